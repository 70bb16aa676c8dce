//! Ballast on lines, discs and circles, in pieces, with margins, and about the moving centre; and
//! refusals.

use polhode::math::{Body, Direction, Position, Rotation};
use polhode_budget::{
    About, Ballast, BallastError, BallastPlace, Basis, Budget, GivenPart, GivenTensor, Limit, Measure,
    PartUncertainty, PartsList, PrincipalAxis, Round, Row, Site, Spread, Trial, Uncertainty,
};

use crate::ballast::{Random, at, body, center, least, limit, product, sites, sought};

const X: Direction<Body> = Direction::new(1.0, 0.0, 0.0);
const Y: Direction<Body> = Direction::new(0.0, 1.0, 0.0);
const Z: Direction<Body> = Direction::new(0.0, 0.0, 1.0);

const AXIS: Measure = Measure::CenterFromLine { point: Position::ZERO, along: Z };

fn round(center: Position<Body>, normal: Direction<Body>, radius: f64) -> Round {
    Round { center, normal, radius }
}

#[test]
fn a_met_limit_takes_no_ballast() {
    let budget = body(5.0, Position::new(0.001, 0.0, 0.4), [0.0; 3]);
    let limits = [limit(AXIS, None, 0.001), product([X, Y], About::CenterOfMass, 0.1)];
    let found = least(&budget, &sites(at(&[Position::new(1.0, 0.0, 0.0)])), &limits).unwrap();
    assert!(found.pieces.is_empty() && found.mass == 0.0 && found.bound == 0.0 && found.gap() == 0.0);
}

#[test]
fn a_center_is_put_on_a_line_by_its_opposite() {
    let c = Position::new(0.03, -0.02, 0.4);
    let budget = body(5.0, c, [0.02, -0.03, 0.01]);
    let out = (0.03_f64).hypot(-0.02);
    let far = 0.7;
    // M out = m far; or, to within d, M (out − d) = m (far + d).
    for (most, mass) in [(0.0, 5.0 * out / far), (0.004, 5.0 * (out - 0.004) / (far + 0.004))] {
        let limits = [limit(AXIS, None, most)];
        for place in [BallastPlace::Circle, BallastPlace::Disc] {
            let site = Site::new("ring", place(round(Position::new(0.0, 0.0, 0.3), Z * 2.0, far)));
            let found = least(&budget, &sites(vec![site]), &limits).unwrap();
            assert!((found.mass / mass - 1.0).abs() < 1e-9, "{} {mass}", found.mass);
            let [piece] = found.pieces[..] else { panic!("{found:?}") };
            let towards = Position::new(-0.03, 0.02, 0.0) * (far / out);
            assert!((piece.position - towards - Position::new(0.0, 0.0, 0.3)).norm() < 1e-5, "{piece:?}");
        }
    }
    // Ballast on the same side does not help: a line, and a point.
    let line = BallastPlace::Line([Position::new(0.1, -1.0, 0.0), Position::new(0.2, -0.1, 1.0)]);
    let same = vec![Site::new("line", line), Site::new("point", BallastPlace::Point(c * 3.0))];
    assert_eq!(least(&budget, &sites(same), &[limit(AXIS, None, 0.01)]), None);
}

#[test]
fn places_are_as_good_as_many_points_of_them() {
    let mut random = Random::new(3);
    for case in 0..12 {
        let budget = body(8.0, random.point() * 0.04, [0.12, -0.2, 0.15]);
        let (a, b) = (random.point(), random.point());
        let disc = round(random.point() * 0.5, Direction::from_array(random.point().to_array()), 0.6);
        let n = disc.normal.direction().unwrap();
        let u = n.cross(if n.x.abs() < 0.5 { X } else { Y }).direction().unwrap();
        let v = n.cross(u);
        let (mut on, mut points) = (vec![Site::new("line", BallastPlace::Line([a, b]))], Vec::new());
        for k in 0..=400 {
            points.push(a + (b - a) * (f64::from(k) / 400.0));
        }
        let radii = if case % 2 == 0 { 0..=10 } else { 10..=10 };
        on.push(Site::new(
            "round",
            if case % 2 == 0 { BallastPlace::Disc(disc) } else { BallastPlace::Circle(disc) },
        ));
        for radius in radii {
            for k in 0..240 {
                let (sin, cos) = (core::f64::consts::TAU * f64::from(k) / 240.0).sin_cos();
                let out = (u * cos + v * sin) * (0.6 * f64::from(radius) / 10.0);
                points.push(disc.center + Position::from_array(out.to_array()));
            }
        }
        let limits = [
            center(X, 0.01),
            limit(AXIS, None, 0.012),
            product([X, Z], About::Point(Position::new(0.1, 0.0, 0.2)), 0.05),
            product([Y, Z], About::Point(Position::new(0.1, 0.0, 0.2)), 0.05),
        ];
        let found = least(&budget, &sites(on), &limits);
        let grid = least(&budget, &sites(at(&points)), &limits);
        match (found, grid) {
            (Some(found), Some(grid)) => {
                assert!(found.mass <= grid.mass * (1.0 + 1e-9), "{case}: {} {}", found.mass, grid.mass);
                assert!(found.mass > grid.mass * 0.985, "{case}: {} {}", found.mass, grid.mass);
                assert!(found.pieces.len() <= 8, "{found:?}");
            }
            (None, None) => {}
            (found, grid) => panic!("{case}: {found:?} {grid:?}"),
        }
    }
}

#[test]
fn pieces_that_one_would_do_for_are_one() {
    let mut random = Random::new(77);
    let mut found = 0;
    for _ in 0..40 {
        let budget = body(8.0, random.point() * 0.04, [0.12, -0.2, 0.15]);
        let normal = Direction::from_array(random.point().to_array());
        let [a, b] = [0, 1].map(|_| round(random.point() * 0.5, normal, 0.6));
        let all = vec![Site::new("a", BallastPlace::Disc(a)), Site::new("b", BallastPlace::Circle(b))];
        let Some(least) = least(&budget, &sites(all), &[center(X, 0.02), limit(AXIS, None, 0.022)]) else {
            continue;
        };
        found += least.pieces.len();
        for (k, piece) in least.pieces.iter().enumerate() {
            let others = least.pieces[..k].iter().filter(|other| other.site == piece.site);
            assert!(others.clone().all(|other| (other.position - piece.position).norm() > 0.05), "{least:?}");
        }
    }
    assert!(found > 20, "{found}");
}

#[test]
fn sizes_are_those_of_all_combinations() {
    let mut random = Random::new(11);
    let (mut found, mut none) = (0, 0);
    for _ in 0..40 {
        let (mass, c) = (random.within(4.0, 9.0), random.point() * 0.04);
        let budget = body(mass, c, [0.03, 0.02, -0.05]);
        let points: Vec<Position<Body>> = (0..5).map(|_| random.point()).collect();
        let choices: Vec<Vec<f64>> =
            (0..5).map(|_| (0..3).map(|_| (random.within(1.0, 40.0)).round() * 0.01).collect()).collect();
        let mut all = at(&points);
        all.iter_mut().zip(&choices).for_each(|(site, sizes)| site.sizes.clone_from(sizes));
        let limits = [center(X, 0.01), center(Y, 0.012), product([X, Z], About::CenterOfMass, 0.06)];
        let whole = budget.mass_properties(Basis::Basic).unwrap();
        let mut best: Option<f64> = None;
        for combination in 0..4_usize.pow(5) {
            let sizes: Vec<f64> = (0..5)
                .map(|k| match combination / 4_usize.pow(k) % 4 {
                    0 => 0.0,
                    n => choices[k as usize][n - 1],
                })
                .collect();
            let total: f64 = sizes.iter().sum();
            if best.is_some_and(|best| total >= best) {
                continue;
            }
            let mut parts = vec![whole];
            for (point, size) in points.iter().zip(&sizes).filter(|(_, size)| **size > 0.0) {
                let none = polhode::body::InertiaTensor::diagonal([0.0; 3]).unwrap();
                parts.push(polhode::body::MassProperties::new(*size, *point, none).unwrap());
            }
            let with = polhode::body::MassProperties::combined(&parts).unwrap();
            if limits.iter().all(|limit| limit.is_met(limit.of.value(&with).unwrap())) {
                best = Some(total);
            }
        }
        match (best, sought(&budget, &sites(all), &limits)) {
            (None, None) => none += 1,
            (Some(best), Some(got)) => {
                found += usize::from(best > 0.0);
                assert!((got.mass - best).abs() <= 1e-6 * best, "{} {best}", got.mass);
            }
            (best, got) => panic!("{best:?} {got:?}"),
        }
    }
    assert!(found > 8 && none > 3, "{found} {none}");
}

#[test]
fn products_about_the_moving_center_are_those_of_a_fine_search() {
    let mut random = Random::new(23);
    for case in 0..6 {
        let c = random.point() * 0.3;
        let budget = body(random.within(3.0, 6.0), c, [0.1, -0.22, 0.17]);
        let whole = budget.mass_properties(Basis::Basic).unwrap();
        let points: Vec<Position<Body>> = (0..3).map(|_| random.point()).collect();
        let limits = [product([X, Z], About::CenterOfMass, 0.03), product([Y, Z], About::CenterOfMass, 0.05)];
        let found = sought(&budget, &sites(at(&points)), &limits);
        // Masses on a grid that is refined around the best point.
        let none = polhode::body::InertiaTensor::diagonal([0.0; 3]).unwrap();
        let broken = |masses: [f64; 3]| {
            let mut parts = vec![whole];
            for (point, mass) in points.iter().zip(masses).filter(|(_, mass)| *mass > 0.0) {
                parts.push(polhode::body::MassProperties::new(mass, *point, none).unwrap());
            }
            let with = polhode::body::MassProperties::combined(&parts).unwrap();
            limits.iter().map(|l| (l.of.value(&with).unwrap().abs() - l.most.unwrap()).max(0.0)).sum::<f64>()
        };
        let most = found.as_ref().map_or(4.0, |found| found.mass * 1.5);
        let (mut best, mut middle, mut half) = (f64::INFINITY, [most / 2.0; 3], most / 2.0);
        for _ in 0..14 {
            let (old, mut nearest) = (middle, f64::INFINITY);
            for k in 0..31_usize.pow(3) {
                let masses = [k % 31, k / 31 % 31, k / 961].map(|k| k as f64 / 15.0 - 1.0);
                let masses: [f64; 3] = core::array::from_fn(|i| (old[i] + half * masses[i]).max(0.0));
                let (total, by) = (masses.iter().sum::<f64>(), broken(masses));
                if by == 0.0 && total < best {
                    (best, middle) = (total, masses);
                } else if best.is_infinite() && by < nearest {
                    (nearest, middle) = (by, masses);
                }
            }
            half *= 0.6;
        }
        match found {
            Some(found) => {
                assert!(found.mass <= best * (1.0 + 1e-6), "{case}: {} {best}", found.mass);
                assert!(best.is_infinite() || found.mass > best * 0.99, "{case}: {} {best}", found.mass);
            }
            None => assert!(best.is_infinite(), "{case}: {best}"),
        }
    }
}

#[test]
fn sites_take_no_more_than_they_may() {
    let budget = body(5.0, Position::new(0.1, 0.0, 0.0), [0.0; 3]);
    let mut all = at(&[Position::new(-1.0, 0.0, 0.0), Position::new(-0.5, 0.0, 0.0)]);
    // M c = m₁ + ½ m₂
    let limits = [limit(Measure::Center { along: X, from: Position::ZERO }, None, 0.0)];
    all[0].most = Some(0.3);
    let found = least(&budget, &sites(all.clone()), &limits).unwrap();
    assert!((found.mass - 0.7).abs() < 1e-9 && found.pieces.len() == 2, "{found:?}");
    all[1].most = Some(0.3);
    assert_eq!(least(&budget, &sites(all.clone()), &limits), None);
    all[1].most = None;
    let total = |most| Ballast { most: Some(most), ..sites(all.clone()) };
    assert!(least(&budget, &total(0.701), &limits).is_some());
    assert_eq!(least(&budget, &total(0.699), &limits), None);
}

#[test]
fn two_planes_balance_a_spin_as_a_shaft_is() {
    let mut random = Random::new(31);
    for _ in 0..10 {
        let budget = body(6.0, random.point() * 0.01, [0.01, 0.03, -0.02]);
        let whole = budget.mass_properties(Basis::Basic).unwrap();
        let along = Direction::from_array(random.point().to_array());
        let point = random.point() * 0.01;
        let shaft = polhode::motion::Shaft::new(whole, point, along, [0.0, 1.0]).unwrap();
        let want = shaft.balance_in_planes([-0.4, 0.5], [0.3, 0.2]).unwrap();
        let n = shaft.axis();
        let middle = |z: f64| point + Position::from_array((n * z).to_array());
        let rings = [(-0.4, 0.3), (0.5, 0.2)]
            .map(|(z, radius)| Site::new("plane", BallastPlace::Circle(round(middle(z), n, radius))));
        let unbalance = |most: f64| {
            [
                limit(Measure::StaticUnbalance { point, along }, None, most),
                limit(Measure::CoupleUnbalance { point, along }, None, most),
            ]
        };
        let found = least(&budget, &sites(rings.to_vec()), &unbalance(0.0)).unwrap();
        let mass = want[0].mass + want[1].mass;
        assert!((found.mass / mass - 1.0).abs() < 1e-9, "{} {mass}", found.mass);
        for piece in &found.pieces {
            assert!((piece.position - want[piece.site].position).norm() < 1e-4, "{found:?} {want:?}");
        }
        // With some unbalance allowed, less ballast is needed.
        let less = least(&budget, &sites(rings.to_vec()), &unbalance(1e-3)).unwrap();
        assert!(less.mass < found.mass);
        // 8 holes in each plane: not lighter, and heavier by at most the cosine of half the angle
        // of a hole.
        let holes: Vec<Site> = [(-0.4, 0.3), (0.5, 0.2)]
            .iter()
            .flat_map(|(z, radius)| {
                Site::bolt_circle("hole", round(middle(*z), n, *radius), Direction::new(0.3, 0.5, 0.8), 8)
            })
            .collect();
        assert_eq!((holes.len(), holes[9].name.as_str()), (16, "hole 2"));
        let drilled = least(&budget, &sites(holes), &unbalance(0.0)).unwrap();
        let most = found.mass / (core::f64::consts::PI / 8.0).cos();
        assert!(drilled.mass >= found.mass * (1.0 - 1e-9) && drilled.mass <= most * (1.0 + 1e-9));
    }
}

fn uncertain() -> Budget {
    let tensor = GivenTensor { moments: [3.1, 4.2, 5.3], products: [0.1, -0.2, 0.15], ..GivenTensor::ZERO };
    let part = GivenPart { mass: 8.0, center_of_mass: Position::new(0.02, 0.03, 0.1), tensor };
    let spread = PartUncertainty::Separate {
        mass: 0.1,
        tensor_follows_mass: true,
        center: Spread::Deviations([0.001, 0.002, 0.001]),
        tensor: Spread::Deviations([0.01, 0.01, 0.01, 0.004, 0.005, 0.006]),
    };
    let row = Row {
        uncertainty: Uncertainty { part: spread, ..Uncertainty::default() },
        ..Row::part("body", part)
    };
    PartsList { rows: vec![row], ..PartsList::default() }.budget().unwrap()
}

#[test]
fn margins_are_so_many_standard_deviations() {
    let budget = uncertain();
    let points = [[-1.0, 0.1, 0.3], [0.1, -0.9, 0.2], [0.4, 0.3, -0.8], [-0.5, -0.6, 0.7], [0.3, 0.2, 0.9]];
    let points = points.map(|[x, y, z]| Position::new(x, y, z));
    let point = Position::new(0.0, 0.0, 0.1);
    let limits = [center(X, 0.008), center(Y, 0.012), product([X, Z], About::Point(point), 0.1)];
    let ballast = Ballast { deviations: 3.0, ..sites(at(&points)) };
    let found = least(&budget, &ballast, &limits).unwrap();
    assert!(found.mass > least(&budget, &sites(at(&points)), &limits).unwrap().mass);
    // The list, with the ballast added.
    let mut list = budget.list().clone();
    list.rows.push(Row::frame("all"));
    list.rows[0].parent = Some("all".to_owned());
    for (k, piece) in found.pieces.iter().enumerate() {
        let point = GivenPart::point(piece.mass, Position::from_array(piece.position.to_array()));
        list.rows.push(Row { parent: Some("all".to_owned()), ..Row::part(format!("ballast {k}"), point) });
    }
    let trial = Trial { seed: 1, draws: 10_000, level: 0.95 };
    let answers = list.budget().unwrap().limits(&limits, trial).unwrap().answers;
    let least =
        answers.iter().flat_map(|answer| answer.margins).flatten().filter_map(|margin| margin.deviations);
    let least = least.fold(f64::INFINITY, f64::min);
    // The deviation of a centre is that of S − most M at the limit. At the centre itself, 3
    // deviations inside, it differs slightly.
    assert!((least - 3.0).abs() < 0.03, "{least} {answers:?}");
    assert!(answers.iter().all(|answer| answer.share.estimate() > 0.995), "{answers:?}");
}

#[test]
fn questions_that_cannot_be_answered_are_refused() {
    let budget = uncertain();
    let points = sites(at(&[Position::new(1.0, 0.0, 0.0)]));
    let refused = |ballast: &Ballast, limit: Limit| budget.ballast(ballast, &[limit]).unwrap_err();
    let about = About::CenterOfMass;
    for of in [
        Measure::Tilt { axis: PrincipalAxis::Nearest, from: Z },
        Measure::SpinRatio(Z),
        Measure::SpinStability(Z),
        Measure::PrincipalMoment(1),
        Measure::PrincipalRatio([2, 1]),
        Measure::Moment { axis: X, about },
    ] {
        assert!(matches!(refused(&points, limit(of, None, 0.1)), BallastError::Limit { .. }));
    }
    assert!(matches!(refused(&points, limit(AXIS, 0.1, None)), BallastError::Limit { .. }));
    let careful = Ballast { deviations: 1.0, ..points.clone() };
    for limit in [product([X, Y], about, 0.1), limit(AXIS, None, 0.0), limit(Measure::Mass, 8.5, 8.5)] {
        assert!(matches!(refused(&careful, limit), BallastError::Limit { .. }));
    }
    let mass = || limit(Measure::Mass, None, 9.0);
    assert_eq!(refused(&Ballast::default(), mass()), BallastError::NoSites);
    assert!(matches!(refused(&points, limit(Measure::Mass, None, None)), BallastError::NotLimit(_)));
    for (most, deviations) in [(Some(-1.0), 0.0), (Some(f64::NAN), 0.0), (None, -1.0), (None, f64::INFINITY)]
    {
        let question = Ballast { most, deviations, ..points.clone() };
        assert!(matches!(refused(&question, mass()), BallastError::Value { site: None, .. }));
    }
    let nowhere = Position::new(0.0, f64::NAN, 0.0);
    let origin = Position::ZERO;
    let mut bad = vec![
        Site::new("a", BallastPlace::Point(nowhere)),
        Site::new("b", BallastPlace::Line([origin, nowhere])),
        Site::new("c", BallastPlace::Disc(round(origin, Direction::ZERO, 1.0))),
        Site::new("d", BallastPlace::Circle(round(origin, Z, 0.0))),
    ];
    let good = Site::new("e", BallastPlace::Point(origin));
    bad.push(Site { most: Some(-1.0), ..good.clone() });
    bad.push(Site { sizes: vec![0.0], ..good.clone() });
    for site in bad {
        let name = site.name.clone();
        let error = refused(&sites(vec![site]), mass());
        assert!(matches!(&error, BallastError::Value { site: Some(site), .. } if *site == name), "{error}");
    }
}

#[test]
fn turned_and_moved_questions_have_the_same_answer() {
    // The list and the sites in another frame, far away. The masses do not depend on the frame.
    let turn = Rotation::<Body, Body>::exp(Direction::new(0.3, -0.7, 0.5)).unwrap();
    let away = Position::new(12.0, -31.0, 7.0);
    let moved = |p: Position<Body>| away + turn * p;
    let budget = body(5.0, Position::new(0.05, -0.07, 0.1), [0.02, -0.03, 0.01]);
    let points =
        [[0.6, 0.2, 0.1], [-0.8, 0.3, -0.3], [0.1, 0.9, 0.4]].map(|[x, y, z]| Position::new(x, y, z));
    let turned = {
        let mut list = budget.list().clone();
        list.rows[0].place.position = Position::from_array(away.to_array());
        list.rows[0].place.rotation = Rotation::from_quaternion(turn.quaternion()).unwrap();
        list.budget().unwrap()
    };
    let limits = |u: Direction<Body>, v: Direction<Body>, w: Direction<Body>, p: Position<Body>| {
        [
            limit(Measure::Center { along: u, from: p }, -0.01, 0.01),
            limit(Measure::CenterFromLine { point: p, along: w }, None, 0.03),
            product([v, w], About::CenterOfMass, 0.02),
        ]
    };
    let one = sought(&budget, &sites(at(&points)), &limits(X, Y, Z, Position::ZERO)).unwrap();
    let other = limits(turn * X, turn * Y, turn * Z, away);
    let two = sought(&turned, &sites(at(&points.map(moved))), &other).unwrap();
    assert!((one.mass / two.mass - 1.0).abs() < 2e-6 && one.mass > 0.1, "{} {}", one.mass, two.mass);
}
