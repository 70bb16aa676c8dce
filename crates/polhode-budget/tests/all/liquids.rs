//! Liquids in tanks with errors: first order compared with central differences and with draws, and
//! refusals.

use polhode::body::{MassProperties, MassPropertiesGradient};
use polhode::math::{Body, Direction, Position, Rotation};
use polhode_budget::{
    Basis, Budget, BudgetError, Down, ErrorKind, Estimate, GivenPart, Group, Liquid, LiquidErrors,
    LiquidTable, Measured, PartUncertainty, PartsList, Place, Row, Sensitivity, Source, Tank, TankShape,
    Uncertainty, Vessel,
};

const DENSITY: f64 = 912.0;

fn vessel(shape: TankShape, density: f64, down: Down) -> Liquid {
    Liquid::Vessel(Box::new(Vessel::new(shape, density, down).unwrap()))
}

/// Returns two tanks described by their shapes, and one by a table whose middle row is not a
/// mixture of the others.
fn liquids(dense: [f64; 2]) -> [Liquid; 3] {
    let fuel = TankShape::Cylinder { radius: 0.15, length: 0.3, ends: [0.15, 0.1] };
    let table = [(2.0, 0.1), (5.0, 0.16), (9.0, 0.19)].map(|(mass, z)| {
        let [a, b, c] = [0.011 * mass, 0.013 * mass, 0.009 * mass];
        let inertia =
            polhode::body::InertiaTensor::with_negative_products([a, b, c], [0.001, -0.002, 0.0005]);
        MassProperties::new(mass, Position::new(0.02, -0.01 * z, z), inertia.unwrap()).unwrap()
    });
    [
        vessel(fuel, dense[0] * DENSITY, Down::PlusX),
        vessel(TankShape::Ellipsoid([0.2, 0.26, 0.3]), dense[1] * DENSITY, Down::MinusZ),
        Liquid::Table(LiquidTable::new(table.to_vec(), None).unwrap()),
    ]
}

const MASSES: [f64; 3] = [12.0, 31.0, 6.3];
const NAMES: [&str; 3] = ["fuel", "water", "grain"];

fn measured(k: usize) -> Measured {
    [Measured::Mass, Measured::Fill, Measured::Mass][k]
}

fn errors(k: usize, amount: f64, density: f64) -> LiquidErrors {
    LiquidErrors { measured: measured(k), amount, density }
}

fn turned(position: [f64; 3], angle: f64) -> Place {
    let rotation = Rotation::from_axis_angle(Direction::new(0.3, -0.5, 0.8), angle).unwrap();
    Place { position: Position::from_array(position), rotation }
}

/// Returns a body with rotated tank frames, and with these masses in the tanks.
fn list(masses: [f64; 3], dense: [f64; 2], errors: [LiquidErrors; 3]) -> PartsList {
    let bus = GivenPart::point(40.0, Position::new(0.1, 0.05, -0.2));
    let mut rows = vec![
        Row::part("craft", bus),
        Row::part("craft/arm", GivenPart::point(7.0, Position::new(-0.4, 0.6, 0.3))),
        Row { place: turned([0.1, -0.2, 0.4], 0.7), ..Row::frame("craft/fuel tank") },
        Row { place: turned([-0.3, 0.2, -0.5], -1.1), ..Row::frame("craft/water tank") },
        Row { place: turned([0.5, 0.1, 0.2], 2.1), ..Row::frame("craft/motor") },
    ];
    let frames = ["craft/fuel tank", "craft/water tank", "craft/motor"];
    for (k, liquid) in liquids(dense).into_iter().enumerate() {
        let tank = Tank { name: NAMES[k].to_owned(), frame: frames[k].to_owned(), liquid };
        rows.push(tank.row(masses[k], errors[k]).unwrap());
    }
    PartsList { rows, ..PartsList::default() }
}

fn exact() -> [LiquidErrors; 3] {
    [0, 1, 2].map(|k| errors(k, 0.0, 0.0))
}

fn ten(body: &MassProperties<Body>) -> [f64; 10] {
    let [x, y, z] = body.center_of_mass().to_array();
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix();
    [body.mass(), x, y, z, xx, yy, zz, xy, xz, yz]
}

fn whole(masses: [f64; 3], dense: [f64; 2]) -> [f64; 10] {
    ten(&list(masses, dense, exact()).budget().unwrap().mass_properties(Basis::Basic).unwrap())
}

fn estimate(errors: [LiquidErrors; 3]) -> Estimate<Body> {
    list(MASSES, [1.0; 2], errors).budget().unwrap().estimate(Basis::Basic).unwrap()
}

/// The covariance of one error alone is δ δᵀ. The derivative δ is a central difference of the whole
/// with more and with less liquid.
#[test]
fn first_order_is_the_derivative_of_the_exact_integrals() {
    for number in 0..5 {
        let (k, is_density) = if number < 3 { (number, false) } else { (number - 3, true) };
        let sd = if is_density { 0.03 } else { 0.4 };
        let mut given = exact();
        given[k] = errors(k, if is_density { 0.0 } else { sd }, if is_density { sd } else { 0.0 });
        let found = estimate(given).covariance;
        let moved = |by: f64| {
            let (mut masses, mut dense) = (MASSES, [1.0; 2]);
            if is_density {
                dense[k] += by;
                // The level is fixed, and with it the volume.
                if measured(k) == Measured::Fill {
                    masses[k] *= 1.0 + by;
                }
            } else {
                masses[k] += by;
            }
            whole(masses, dense)
        };
        let h = 1e-4;
        let (more, less) = (moved(h), moved(-h));
        let slope: [f64; 10] = std::array::from_fn(|j| (more[j] - less[j]) / (2.0 * h));
        for i in 0..10 {
            for j in 0..10 {
                let want = sd * sd * slope[i] * slope[j];
                // Rounding and truncation errors of the differences, for both factors.
                let rounding = [i, j].map(|k| slope[k].abs() + 1e-3).iter().product::<f64>() * 1e-7 * sd * sd;
                let found = found[i][j];
                assert!((found - want).abs() < rounding, "{number}: {i} {j}: {found} {want}");
            }
        }
        let size = slope.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        assert!(size > 0.01, "{number}: nothing changes");
    }
}

/// Returns the list with all errors. Two of them are correlated.
fn uncertain(scale: f64) -> Budget {
    let given = [
        errors(0, scale * 0.4, scale * 0.03),
        errors(1, scale * 0.9, scale * 0.05),
        errors(2, scale * 0.25, 0.0),
    ];
    let mut list = list(MASSES, [1.0; 2], given);
    list.groups = vec![Group { density: 0.8, ..Group::of_masses("liquids", 0.4) }];
    for row in &mut list.rows {
        if NAMES[..2].contains(&row.name.as_str()) {
            row.group = Some("liquids".to_owned());
        }
    }
    list.rows[1].uncertainty =
        Uncertainty { part: PartUncertainty::of_mass(scale * 0.2), ..Default::default() };
    list.budget().unwrap()
}

#[test]
fn small_errors_are_drawn_as_first_order_says() {
    let budget = uncertain(0.1);
    let estimate = budget.estimate(Basis::Basic).unwrap();
    let draws = budget.draws(Basis::Basic, 41, 6000).unwrap();
    assert_eq!(draws.moved, 0);
    let comparison = draws.compare(&estimate);
    for (k, number) in comparison.numbers.iter().enumerate() {
        assert!(!number.differs() && number.sd > 0.0, "{number:?}");
        assert!((number.sd / number.first_order_sd - 1.0).abs() < 0.05, "{number:?}");
        if k < 10 {
            for j in 0..k {
                let size = estimate.sd(k) * estimate.sd(j);
                let apart = comparison.covariance[k][j] - estimate.covariance[k][j];
                assert!(apart.abs() < 0.06 * size, "{k} {j}: {apart} of {size}");
            }
        }
    }
}

#[test]
fn errors_are_named_by_what_they_are_of() {
    let budget = uncertain(1.0);
    let mass = MassPropertiesGradient::<Body> {
        by_mass: 1.0,
        by_center_of_mass: Direction::ZERO,
        by_inertia: [0.0; 6],
    };
    let found = budget.sensitivities(Basis::Basic, &[mass], 100).unwrap().remove(0).greatest;
    let of = |source, kind| {
        let is = |one: &&Sensitivity| one.source == source && one.kind == kind;
        found.iter().find(is).map_or(0.0, |one| one.variance)
    };
    // The mass of a weighed liquid does not depend on the density. The mass of a filled one does.
    let [fuel, water] =
        [0, 1].map(|k| budget.list().rows.iter().position(|row| row.name == NAMES[k]).unwrap());
    assert_eq!(of(Source::Row(fuel), ErrorKind::Density), 0.0);
    let close = |found: f64, want: f64| assert!((found / want - 1.0).abs() < 1e-12, "{found} {want}");
    close(of(Source::Row(fuel), ErrorKind::Mass), 0.6 * 0.16);
    close(of(Source::Row(water), ErrorKind::Density), 0.2 * (0.05_f64 * 31.0).powi(2));
    close(of(Source::Group(0), ErrorKind::Density), 0.8 * (0.05_f64 * 31.0).powi(2));
    close(of(Source::Group(0), ErrorKind::Mass), 0.4 * 1.3_f64.powi(2));
    let all: f64 = found.iter().map(|one| one.variance).sum();
    close(all.sqrt(), budget.estimate(Basis::Basic).unwrap().sd(0));
}

/// A nearly full tank never contains more than its capacity, and a nearly empty one never less than
/// nothing.
#[test]
fn tanks_are_between_empty_and_full() {
    let dry = 47.0;
    let capacity = liquids([1.0; 2]).map(|liquid| liquid.capacity());
    for (mass, sd) in [(0.97 * capacity[0], 1.5), (0.2, 0.3), (capacity[0], 1.0)] {
        let mut given = exact();
        given[0] = errors(0, sd, 0.0);
        let list = list([mass, 31.0, 6.3], [1.0; 2], given);
        let rest = dry + 31.0 + 6.3;
        let draws = list.budget().unwrap().draws(Basis::Basic, 5, 3000).unwrap();
        let inside: Vec<f64> = draws.bodies.iter().map(|body| body.mass() - rest).collect();
        let beyond = |x: &f64| *x < -1e-9 || *x > capacity[0] * (1.0 + 1e-9);
        assert!(!inside.iter().any(beyond), "{mass}");
        let full = inside.iter().filter(|x| **x > capacity[0] * (1.0 - 1e-9)).count();
        assert_eq!(full, draws.moved, "{mass}");
        assert_eq!(mass > 1.0, draws.moved > 100, "{mass}: {}", draws.moved);
    }
    // A lighter liquid of the same mass may not fit. At the same level, it always does.
    let of_density = |measured| {
        let mut given = exact();
        given[0] = LiquidErrors { measured, amount: 0.0, density: 0.05 };
        let list = list([0.99 * capacity[0], 31.0, 6.3], [1.0; 2], given);
        list.budget().unwrap().draws(Basis::Basic, 5, 1000).unwrap().moved
    };
    assert!(of_density(Measured::Mass) > 300 && of_density(Measured::Fill) == 0);
}

#[test]
fn what_is_no_liquid_is_refused() {
    let given = |amount, density| {
        let mut given = exact();
        given[1] = errors(1, amount, density);
        list(MASSES, [1.0; 2], given)
    };
    let refused = |list: PartsList| list.budget().unwrap_err().to_string();
    let rule = "but must be zero or positive, and finite";
    assert_eq!(
        refused(given(-0.1, 0.0)),
        format!("the standard deviation of the amount of the liquid of \"water\" is -0.1, {rule}")
    );
    assert_eq!(
        refused(given(0.0, f64::INFINITY)),
        format!("the standard deviation of the density of the liquid of \"water\" is inf, {rule}")
    );
    for change in [0, 1, 2] {
        let mut list = given(0.1, 0.0);
        let part =
            list.rows.iter_mut().find(|row| row.name == "water").and_then(|row| row.part.as_mut()).unwrap();
        match change {
            0 => part.mass *= 1.0 + 1e-6,
            1 => part.center_of_mass.x += 1e-6,
            _ => part.tensor.moments[1] *= 1.0 + 1e-6,
        }
        assert!(
            matches!(list.budget().unwrap_err(), BudgetError::NotTheLiquid { row } if row.name == "water")
        );
    }
    let tank = Tank { name: "t".to_owned(), frame: "f".to_owned(), liquid: liquids([1.0; 2])[2].clone() };
    assert!(tank.row(0.0, errors(2, 0.1, 0.0)).is_none() && tank.row(9.1, errors(2, 0.1, 0.0)).is_none());
}
