//! Limits compared with definitions, differences, published intervals and independent draws.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{Body, Direction, Position};
use polhode_budget::{
    About, Basis, Estimate, GivenPart, GivenTensor, Growth, Limit, LimitError, Measure, PartUncertainty,
    PartsList, PrincipalAxis, ProductSign, Row, Spread, Trial, Uncertainty, Undefined,
};

use crate::lists::{case, list};

const U: Direction<Body> = Direction::new(0.48, 0.6, 0.64);
const V: Direction<Body> = Direction::new(-0.8, 0.0, 0.6);
const P: Position<Body> = Position::new(0.21, -0.34, 0.55);

fn measures() -> Vec<Measure> {
    let mut all = vec![
        Measure::Mass,
        Measure::Center { along: U * 3.0, from: P },
        Measure::CenterFromPoint(P),
        Measure::CenterFromLine { point: P, along: U * 0.2 },
        Measure::StaticUnbalance { point: P, along: U * 0.2 },
        Measure::CoupleUnbalance { point: P, along: U * 0.2 },
        Measure::PrincipalRatio([2, 0]),
        Measure::PrincipalRatio([1, 1]),
        Measure::Tilt { axis: PrincipalAxis::Nearest, from: V },
        Measure::SpinRatio(U),
        Measure::SpinRatio(V),
        Measure::SpinStability(U),
        Measure::SpinStability(V),
    ];
    for about in [About::CenterOfMass, About::Point(P)] {
        all.push(Measure::Moment { axis: U * 2.0, about });
        all.push(Measure::Product { axes: [U, V * 5.0], sign: ProductSign::PositiveIntegral, about });
        all.push(Measure::Product { axes: [U, V], sign: ProductSign::NegativeIntegral, about });
    }
    for k in 0..3 {
        all.push(Measure::PrincipalMoment(k));
        all.push(Measure::Tilt { axis: PrincipalAxis::Number(k), from: U });
    }
    all
}

/// Returns a body with one number changed by h.
fn moved(of: &MassProperties<Body>, number: usize, h: f64) -> MassProperties<Body> {
    let (mut mass, mut center) = (of.mass(), of.center_of_mass().to_array());
    let mut rows = of.inertia().matrix();
    match number {
        0 => mass += h,
        1..4 => center[number - 1] += h,
        _ => {
            let (i, j) = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)][number - 4];
            rows[i][j] += h;
            rows[j][i] = rows[i][j];
        }
    }
    MassProperties::new(mass, Position::from_array(center), InertiaTensor::from_matrix(rows).unwrap())
        .unwrap()
}

#[test]
fn gradients_are_those_of_differences() {
    for name in ["small", "nested"] {
        let whole = list(&case(name)).budget().unwrap().estimate(Basis::Basic).unwrap();
        let body = &whole.properties;
        let sizes: [f64; 10] = core::array::from_fn(|k| match k {
            0 => 1e-3 * body.mass(),
            1..4 => 1e-3,
            _ => 1e-4 * body.principal().moments()[0],
        });
        for measure in measures() {
            let gradient = measure.gradient(&whole).unwrap();
            let c = gradient.by_center_of_mass.to_array();
            let mut got = vec![gradient.by_mass, c[0], c[1], c[2]];
            got.extend(gradient.by_inertia);
            let slopes: Vec<f64> = (0..10)
                .map(|k| {
                    let h = sizes[k];
                    let at = |steps: f64| measure.value(&moved(body, k, steps * h)).unwrap();
                    (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / 12.0
                })
                .collect();
            let size = slopes.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            for k in 0..10 {
                let got = got[k] * sizes[k];
                assert!(
                    (got - slopes[k]).abs() <= 2e-8 * size + 1e-15,
                    "{measure:?} {}: {got} {}",
                    k,
                    slopes[k]
                );
            }
        }
    }
}

/// Returns five particles, and the body that consists of them.
fn particles() -> ([(f64, [f64; 3]); 5], MassProperties<Body>) {
    let all = [
        (1.3, [0.4, -0.2, 0.9]),
        (0.7, [-0.5, 0.3, 0.1]),
        (2.1, [0.1, 0.8, -0.4]),
        (0.4, [0.9, 0.7, 0.6]),
        (1.1, [-0.3, -0.6, 0.2]),
    ];
    let rows = all
        .iter()
        .enumerate()
        .map(|(k, (m, [x, y, z]))| {
            let at = Position::new(*x, *y, *z);
            Row { parent: Some("body".to_owned()), ..Row::part(format!("p{k}"), GivenPart::point(*m, at)) }
        })
        .chain([Row::frame("body")]);
    let list = PartsList { rows: rows.collect(), ..PartsList::default() };
    (all, list.budget().unwrap().mass_properties(Basis::Basic).unwrap())
}

#[test]
fn values_are_those_of_the_definitions() {
    let (all, body) = particles();
    let mass: f64 = all.iter().map(|(m, _)| m).sum();
    let center: [f64; 3] = core::array::from_fn(|k| all.iter().map(|(m, r)| m * r[k]).sum::<f64>() / mass);
    let center = Position::new(center[0], center[1], center[2]);
    let close = |measure: Measure, want: f64| {
        let got = measure.value(&body).unwrap();
        assert!((got - want).abs() < 1e-14 * want.abs().max(1.0), "{measure:?}: {got} {want}");
    };
    close(Measure::Mass, mass);
    close(Measure::Center { along: U * 7.0, from: P }, U.dot(center - P));
    close(Measure::CenterFromPoint(P), (center - P).dot(center - P).sqrt());
    close(Measure::CenterFromLine { point: P, along: U * 7.0 }, U.cross(center - P).norm());
    close(Measure::StaticUnbalance { point: P, along: U * 7.0 }, mass * U.cross(center - P).norm());
    let couple = all.iter().fold(Direction::ZERO, |sum, (m, r)| {
        let d = Direction::from_array((Position::from_array(*r) - P).to_array());
        sum + U.cross(d) * (m * U.dot(d))
    });
    close(Measure::CoupleUnbalance { point: P, along: U * 7.0 }, couple.norm());
    for (about, point) in [(About::CenterOfMass, center), (About::Point(P), P)] {
        let integral = |f: &dyn Fn(Direction<Body>) -> f64| -> f64 {
            let at = |r: &[f64; 3]| Direction::from_array((Position::from_array(*r) - point).to_array());
            all.iter().map(|(m, r)| m * f(at(r))).sum()
        };
        close(Measure::Moment { axis: U * 0.3, about }, integral(&|d| d.dot(d) - U.dot(d) * U.dot(d)));
        let product = integral(&|d| U.dot(d) * V.dot(d));
        for (sign, factor) in [(ProductSign::PositiveIntegral, 1.0), (ProductSign::NegativeIntegral, -1.0)] {
            close(Measure::Product { axes: [U, V * 2.0], sign, about }, factor * product);
        }
    }
    let principal = body.principal();
    let [i1, i2, i3] = principal.moments();
    close(Measure::PrincipalRatio([0, 2]), i1 / i3);
    for k in 0..3 {
        let axis = principal.axis(k);
        let near = axis * 0.9 + principal.axis((k + 1) % 3) * 0.2;
        let (i, others) = (principal.moments()[k], [0, 1, 2].map(|j| principal.moments()[(k + j) % 3]));
        close(Measure::SpinRatio(near), i / others[1].max(others[2]));
        // Nutation of a nearly steady spin about axis 3: Ω² (i3 − i1)(i3 − i2)/(i1 i2)
        let square = (i - others[1]) * (i - others[2]) / (others[1] * others[2]);
        close(Measure::SpinStability(near), square);
        assert_eq!(square > 0.0, k != 1);
        close(Measure::Tilt { axis: PrincipalAxis::Nearest, from: -near }, (2.0_f64 / 9.0).atan());
        close(Measure::Tilt { axis: PrincipalAxis::Number((k + 2) % 3), from: near }, FRAC_PI_2);
    }
    assert!(i1 < i2 && i2 < i3);
}

fn limit(of: Measure, least: Option<f64>, most: Option<f64>, basis: Basis) -> Limit {
    Limit { name: "limit".to_owned(), of, least, most, basis }
}

const TRIAL: Trial = Trial { seed: 31, draws: 20_000, level: 0.95 };

/// Returns two points with uncertain masses, one of them with an uncertain place.
fn two(sd: f64) -> PartsList {
    let uncertain = |name: &str, mass, x, part| Row {
        parent: Some("body".to_owned()),
        growth: Growth::Fraction(0.2),
        uncertainty: Uncertainty { part, ..Uncertainty::default() },
        ..Row::part(name, GivenPart::point(mass, Position::new(x, 0.1, -0.2)))
    };
    let center = Spread::Deviations([0.01, 0.0, 0.0]);
    let placed = PartUncertainty::Separate {
        mass: 2.0 * sd,
        tensor_follows_mass: true,
        center,
        tensor: Spread::Exact,
    };
    let rows = vec![
        Row::frame("body"),
        uncertain("a", 3.0, 0.5, PartUncertainty::of_mass(sd)),
        uncertain("b", 5.0, -0.4, placed),
    ];
    PartsList { rows, ..PartsList::default() }
}

#[test]
fn probabilities_are_those_of_independent_draws() {
    let budget = two(0.04).budget().unwrap();
    let x = Measure::Center { along: Direction::new(1.0, 0.0, 0.0), from: Position::ZERO };
    let limits = [
        limit(x.clone(), Some(-0.075), Some(-0.055), Basis::Basic),
        limit(Measure::Mass, None, Some(9.7), Basis::Predicted),
        limit(Measure::Mass, Some(9.55), Some(9.7), Basis::Predicted),
        limit(x, None, Some(-0.0625), Basis::Predicted),
    ];
    let found = budget.limits(&limits, TRIAL).unwrap();
    // Another generator, normal masses, and the definition of the centre.
    let mut state = 12_345_u64;
    let mut uniform = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    };
    let count = 200_000;
    let mut met = [0_usize; 5];
    for _ in 0..count {
        let mut normal = || (-2.0 * uniform().ln()).sqrt() * (TAU * uniform()).cos();
        let (a, b) = (3.0 + 0.04 * normal(), 5.0 + 0.08 * normal());
        let x = (0.5 * a - (0.4 + 0.01 * normal()) * b) / (a + b);
        let mass = 1.2 * (a + b);
        let holds = [(-0.075..=-0.055).contains(&x), mass <= 9.7, (9.55..=9.7).contains(&mass), x <= -0.0625];
        for (met, holds) in met.iter_mut().zip(holds.into_iter().chain([holds.iter().all(|holds| *holds)])) {
            *met += usize::from(holds);
        }
    }
    let shares = found.answers.iter().map(|answer| answer.share).chain([found.all.share]);
    for (share, met) in shares.zip(met) {
        let p = met as f64 / f64::from(count);
        let error = 4.0 * (p * (1.0 - p) / 20_000.0 * 1.1).sqrt();
        assert!((share.estimate() - p).abs() < error, "{share:?} {p}");
        assert!(share.interval[0] < share.estimate() && share.interval[1] > share.estimate());
    }
    for (answer, met) in found.answers.iter().zip(met) {
        let p = met as f64 / f64::from(count);
        assert!((answer.first_order.unwrap() - p).abs() < 0.006, "{answer:?} {p}");
        assert_eq!(answer.differs, Some(false));
    }
    let [low, high] = found.all.first_order.unwrap();
    let p = met[4] as f64 / f64::from(count);
    assert!(low < p && p < high && found.all.met);
    // Probability Φ(0.1/0.107331) for the mass: 9.7 − 9.6 over 1.2 √(0.04² + 0.08²)
    let mass = &found.answers[1];
    let sd = 1.2 * (0.0016_f64 + 0.0064).sqrt();
    let margin = mass.margins[1].unwrap();
    assert!((margin.value - 0.1).abs() < 1e-14 && (margin.deviations.unwrap() - 0.1 / sd).abs() < 1e-12);
    assert_eq!(mass.margins[0], None);
    assert!((mass.first_order.unwrap() - 0.824_252_911_976_86).abs() < 1e-13, "{:?}", mass.first_order);
}

#[test]
fn what_first_order_cannot_say_differs_from_the_draws() {
    // Distance from the expected centre: the centre is normal along one direction, and the distance
    // is never negative.
    let budget = two(0.0).budget().unwrap();
    let c = budget.mass_properties(Basis::Basic).unwrap().center_of_mass();
    let near = Position::new(c.x + 1e-5, c.y, c.z);
    let limits = [
        limit(Measure::CenterFromPoint(near), None, Some(0.004), Basis::Basic),
        limit(Measure::CenterFromPoint(c), None, Some(0.004), Basis::Basic),
    ];
    let found = budget.limits(&limits, TRIAL).unwrap();
    let [beside, at] = &found.answers[..] else { unreachable!() };
    assert_eq!(beside.differs, Some(true));
    assert!((beside.sd.unwrap() - 0.00625).abs() < 1e-12 && beside.first_order.unwrap() > 0.73);
    assert_eq!((at.sd, at.first_order, at.differs), (Err(Undefined::Corner), Err(Undefined::Corner), None));
    assert!(at.met && at.margins[1].unwrap().deviations.is_none());
    assert_eq!(found.all.first_order, None);
    // 2 Φ(0.64) − 1
    let [low, high] = at.share.interval;
    assert!(low < 0.477_827_4 && high > 0.477_827_4, "{:?}", at.share);
}

fn symmetric(moments: [f64; 3], sd: f64) -> Estimate<Body> {
    let tensor = GivenTensor { moments, ..GivenTensor::ZERO };
    let part = PartUncertainty::Separate {
        mass: 0.0,
        tensor_follows_mass: false,
        center: Spread::Exact,
        tensor: Spread::Deviations([sd; 6]),
    };
    let row = Row::part("wheel", GivenPart { mass: 4.0, center_of_mass: Position::ZERO, tensor });
    let row = Row { uncertainty: Uncertainty { part, ..Uncertainty::default() }, ..row };
    let list = PartsList { rows: vec![row], ..PartsList::default() };
    list.budget().unwrap().estimate(Basis::Basic).unwrap()
}

#[test]
fn what_equal_moments_leave_undefined_is_said() {
    let wheel = symmetric([2.0, 2.0, 3.0], 0.01);
    let z = Direction::new(0.0, 0.0, 1.0);
    let beside = Direction::new(0.2, 0.1, 1.0);
    let value = |measure: &Measure| measure.value(&wheel.properties);
    let tilt = |axis, from| Measure::Tilt { axis, from };
    let equal = Undefined::EqualMoments;
    // The axis of symmetry is determined; the axes perpendicular to it are not.
    let third = tilt(PrincipalAxis::Number(2), beside);
    assert!(
        (value(&third).unwrap() - 0.05_f64.sqrt().atan()).abs() < 1e-14 && third.gradient(&wheel).is_ok()
    );
    assert_eq!(tilt(PrincipalAxis::Nearest, z).gradient(&wheel), Err(Undefined::Corner));
    assert_eq!(value(&tilt(PrincipalAxis::Nearest, z)), Ok(0.0));
    for measure in
        [tilt(PrincipalAxis::Number(0), beside), tilt(PrincipalAxis::Nearest, Direction::new(0.3, 0.4, 0.1))]
    {
        assert_eq!((value(&measure), measure.gradient(&wheel)), (Err(equal), Err(equal)));
    }
    // The perpendicular axes can have any direction in their plane. The nearest of these directions
    // is nearer than z.
    let across = Direction::new(0.6, 0.6, 0.7);
    assert_eq!(value(&Measure::SpinRatio(across)), Ok(2.0 / 3.0));
    assert_eq!(value(&Measure::SpinRatio(beside)), Ok(1.5));
    assert_eq!(Measure::SpinRatio(beside).gradient(&wheel), Err(equal));
    assert_eq!(Measure::SpinRatio(across).gradient(&wheel), Err(equal));
    assert_eq!(Measure::PrincipalMoment(0).gradient(&wheel), Err(equal));
    assert_eq!(Measure::PrincipalRatio([2, 1]).gradient(&wheel), Err(equal));
    assert!(Measure::PrincipalMoment(2).gradient(&wheel).is_ok());
    // The rate of nutation does not depend on the order of two equal moments: i = 3, a = b = 2.
    let square = Measure::SpinStability(beside);
    assert_eq!(value(&square), Ok(0.25));
    let by = square.gradient(&wheel).unwrap().by_inertia;
    let step = |h: f64| square.value(&symmetric([2.0 + h, 2.0, 3.0], 0.0).properties).unwrap();
    assert!((by[0] - (step(1e-4) - step(-1e-4)) / 2e-4).abs() < 1e-7);
    assert_eq!((by[0], by[1], by[2], by[3]), (-0.375, -0.375, 0.5, 0.0));
    // A sphere has no distinct axes, and a rod has no moment about its line.
    let sphere = symmetric([2.0; 3], 0.0);
    assert_eq!(tilt(PrincipalAxis::Nearest, z).value(&sphere.properties), Err(equal));
    assert_eq!(Measure::SpinRatio(z).value(&sphere.properties), Ok(1.0));
    let rod = symmetric([0.0, 2.0, 2.0], 0.0);
    let zero = Err(Undefined::ZeroMoment);
    assert_eq!(Measure::PrincipalRatio([2, 0]).value(&rod.properties), zero);
    assert_eq!(Measure::SpinStability(z).value(&rod.properties), zero);
    assert_eq!(Measure::SpinStability(z).gradient(&rod), Err(Undefined::ZeroMoment));
}

#[test]
fn what_has_no_value_is_not_met() {
    let rod = Row::part("rod", GivenPart::point(1.0, Position::ZERO));
    let budget = PartsList { rows: vec![rod], ..PartsList::default() }.budget().unwrap();
    let ratio = limit(Measure::SpinRatio(U), Some(0.0), None, Basis::Basic);
    let trial = Trial { draws: 10, ..TRIAL };
    let found = budget.limits(&[ratio], trial).unwrap();
    let answer = &found.answers[0];
    assert_eq!((answer.value, answer.met, answer.share.met), (Err(Undefined::ZeroMoment), false, 0));
    assert!(!found.all.met && found.all.share.met == 0);
    // The limits of exact lists are either met or not.
    let mass = |most| limit(Measure::Mass, Some(1.0), Some(most), Basis::Predicted);
    let found =
        budget.limits(&[mass(1.0), limit(Measure::Mass, Some(1.5), None, Basis::Predicted)], trial).unwrap();
    assert_eq!(found.answers[0].first_order, Ok(1.0));
    assert_eq!((found.answers[1].first_order, found.answers[1].share.met), (Ok(0.0), 0));
    assert_eq!((found.answers[0].share.met, found.answers[0].differs), (10, Some(false)));
    // Without limits, the result for all limits is true.
    let none = budget.limits(&[], trial).unwrap();
    assert!(none.all.met && none.all.share.met == 10 && none.all.first_order == Some([1.0, 1.0]));
}

#[test]
fn limits_that_say_nothing_are_refused() {
    let budget = two(0.1).budget().unwrap();
    let trial = Trial { draws: 10, ..TRIAL };
    let refused = |limit: Limit| budget.limits(&[limit], trial).unwrap_err();
    let mass = |least, most| limit(Measure::Mass, least, most, Basis::Basic);
    assert_eq!(refused(mass(None, None)), LimitError::Open { limit: "limit".to_owned() });
    for limit in [
        mass(Some(f64::NAN), None),
        mass(None, Some(f64::INFINITY)),
        mass(Some(2.0), Some(1.0)),
        limit(Measure::Center { along: Direction::ZERO, from: P }, Some(0.0), None, Basis::Basic),
        limit(Measure::PrincipalMoment(3), Some(0.0), None, Basis::Basic),
        limit(
            Measure::Product {
                axes: [U, U + V],
                sign: ProductSign::PositiveIntegral,
                about: About::CenterOfMass,
            },
            Some(0.0),
            None,
            Basis::Basic,
        ),
        limit(Measure::CenterFromPoint(Position::new(0.0, f64::NAN, 0.0)), None, Some(PI), Basis::Basic),
        // The value overflows, or only its standard deviation does.
        limit(Measure::Moment { axis: U, about: About::Point(P * 1e160) }, None, Some(PI), Basis::Basic),
        limit(Measure::StaticUnbalance { point: P * 1e200, along: U }, None, Some(PI), Basis::Basic),
    ] {
        let error = refused(limit);
        assert!(matches!(&error, LimitError::Value { limit, .. } if limit == "limit"), "{error:?}");
        assert!(error.to_string().contains("\"limit\" is "));
    }
    let good = mass(Some(1.0), None);
    let level = budget.limits(std::slice::from_ref(&good), Trial { level: 1.0, ..trial });
    assert_eq!(level.unwrap_err(), LimitError::Level { value: 1.0 });
    let few = budget.limits(&[good], Trial { draws: 9, ..trial }).unwrap_err();
    assert!(matches!(few, LimitError::Budget(_)));
}
