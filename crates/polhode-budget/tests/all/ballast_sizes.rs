//! Ballast in pieces of given sizes on lines, discs and circles, compared with random searches,
//! combinations and closed forms.

use polhode::body::MassProperties;
use polhode::math::{Body, Direction, Position};
use polhode_budget::{About, BallastPlace, Basis, Budget, Limit, Measure, ProductSign, Round, Site};

use crate::ballast::{Random, at, body, center, limit, product, sites, sought};

const X: Direction<Body> = Direction::new(1.0, 0.0, 0.0);
const Y: Direction<Body> = Direction::new(0.0, 1.0, 0.0);
const Z: Direction<Body> = Direction::new(0.0, 0.0, 1.0);

fn sized(place: BallastPlace, sizes: &[f64], most: Option<f64>) -> Site {
    Site { sizes: sizes.to_vec(), most, ..Site::new("site", place) }
}

/// Mass, ∫ r dm and ∫ (yz, xz, xy) dm.
type Sums = [f64; 7];

fn sums(mass: f64, r: Position<Body>) -> Sums {
    let [x, y, z] = r.to_array();
    [mass, mass * x, mass * y, mass * z, mass * y * z, mass * x * z, mass * x * y]
}

fn plus(a: &Sums, b: &Sums) -> Sums {
    core::array::from_fn(|k| a[k] + b[k])
}

fn of_body(body: &MassProperties<Body>) -> Sums {
    let product = |u, v| {
        let about = About::Point(Position::ZERO);
        let of = Measure::Product { axes: [u, v], sign: ProductSign::PositiveIntegral, about };
        of.value(body).unwrap()
    };
    let mut all = sums(body.mass(), body.center_of_mass());
    all[4..].copy_from_slice(&[product(Y, Z), product(X, Z), product(X, Y)]);
    all
}

/// Returns true if the centre is within `most` along x and y, and the products about it are within
/// theirs.
fn is_met([m, x, y, z, yz, xz, xy]: &Sums, most: [f64; 5]) -> bool {
    let all = [x / m, y / m, yz - y * z / m, xz - x * z / m, xy - x * y / m];
    all.iter().zip(most).all(|(value, most)| value.abs() <= most)
}

fn limits(most: [f64; 5]) -> Vec<Limit> {
    let about = About::CenterOfMass;
    let products = [([Y, Z], 2), ([X, Z], 3), ([X, Y], 4)].map(|(axes, k)| product(axes, about, most[k]));
    [vec![center(X, most[0]), center(Y, most[1])], products.to_vec()].concat()
}

/// Returns a body that is inside its limits with this ballast, at random places between them, and
/// the limits.
fn met_with(hidden: &[(f64, Position<Body>)], random: &mut Random) -> (Budget, [f64; 5]) {
    let (mass, wide) = (random.within(4.0, 9.0), random.within(0.02, 0.05));
    let most = [random.within(0.004, 0.012), random.within(0.004, 0.012), wide, 0.8 * wide, wide];
    let inside: [f64; 5] = most.map(|most| random.within(-0.7, 0.7) * most);
    let ballast = hidden.iter().fold([0.0; 7], |all, (mass, at)| plus(&all, &sums(*mass, *at)));
    let total = mass + ballast[0];
    let center =
        [total * inside[0] - ballast[1], total * inside[1] - ballast[2], mass * random.within(-0.05, 0.05)];
    let center = Position::from_array(center.map(|s| s / mass));
    // Missing part of each product, to be provided by the products of the body alone.
    let with = |products: [f64; 3]| {
        let budget = body(mass, center, products);
        let [m, x, y, z, yz, xz, xy] =
            plus(&of_body(&budget.mass_properties(Basis::Basic).unwrap()), &ballast);
        (budget, [yz - y * z / m, xz - x * z / m, xy - x * y / m])
    };
    let now = with([0.0; 3]).1;
    let mut products = [0.0; 3];
    for (k, product) in products.iter_mut().enumerate() {
        let mut one = [0.0; 3];
        one[k] = 0.1;
        let changed = with(one).1;
        let which = (0..3).find(|k| (changed[*k] - now[*k]).abs() > 0.05).unwrap();
        *product = 0.1 * (inside[2 + which] - now[which]) / (changed[which] - now[which]);
    }
    (with(products).0, most)
}

/// Returns a point of a place, from two numbers from 0 to 1.
fn at_place(place: &BallastPlace, [s, t]: [f64; 2]) -> Position<Body> {
    match place {
        BallastPlace::Point(p) => *p,
        BallastPlace::Line([a, b]) => *a + (*b - *a) * s,
        BallastPlace::Disc(round) | BallastPlace::Circle(round) => {
            let n = round.normal.direction().unwrap();
            let u = n.cross(if n.x.abs() < 0.5 { X } else { Y }).direction().unwrap();
            let v = n.cross(u);
            let out = if matches!(place, BallastPlace::Disc(_)) { t } else { 1.0 };
            let (sin, cos) = (core::f64::consts::TAU * s).sin_cos();
            round.center + Position::from_array(((u * cos + v * sin) * (round.radius * out)).to_array())
        }
    }
}

/// Returns true if a random search from many starts finds points at which the pieces meet the
/// limits.
fn does_somewhere(
    whole: &Sums,
    pieces: &[(f64, &BallastPlace)],
    most: [f64; 5],
    random: &mut Random,
) -> bool {
    let beside = |at: &[[f64; 2]]| {
        let all = pieces.iter().zip(at).map(|((mass, place), at)| sums(*mass, at_place(place, *at)));
        let [m, x, y, z, yz, xz, xy] = all.fold(*whole, |all, one| plus(&all, &one));
        let all = [x / m, y / m, yz - y * z / m, xz - x * z / m, xy - x * y / m];
        all.iter().zip(most).map(|(value, most)| (value.abs() / most - 1.0).max(0.0).powi(2)).sum::<f64>()
    };
    (0..40).any(|_| {
        let mut at: Vec<[f64; 2]> = pieces.iter().map(|_| [random.uniform(), random.uniform()]).collect();
        let (mut now, mut step) = (beside(&at), 0.5);
        for _ in 0..600 {
            if now == 0.0 || step < 1e-9 {
                break;
            }
            let near: Vec<[f64; 2]> = at
                .iter()
                .map(|at| at.map(|x| (x + step * random.within(-1.0, 1.0)).clamp(0.0, 1.0)))
                .collect();
            let then = beside(&near);
            if then < now {
                (at, now, step) = (near, then, 1.5 * step);
            } else {
                step *= 0.9;
            }
        }
        now == 0.0
    })
}

fn round(random: &mut Random) -> Round {
    let normal = Direction::from_array(random.point().to_array());
    Round { center: random.point() * 0.5, normal, radius: random.within(0.4, 0.8) }
}

#[test]
fn pieces_on_lines_and_rounds_are_those_of_a_random_search() {
    let mut random = Random::new(41);
    let (mut found, mut none) = (0, 0);
    for case in 0..36 {
        let line = BallastPlace::Line([random.point(), random.point()]);
        let round = round(&mut random);
        let other = match case % 3 {
            0 => BallastPlace::Disc(round),
            1 => BallastPlace::Circle(round),
            _ => BallastPlace::Line([random.point(), random.point()]),
        };
        // One or two pieces on each place meet the limits. In the last cases, these pieces are not
        // available.
        let factor = if case < 30 { 1.0 } else { 1.5 };
        let pieces = [(0.12, &line), (0.2, &line), (0.1, &other), (0.1, &other)];
        let pieces = &pieces[case % 2..if case % 4 < 2 { 3 } else { 4 }];
        let mut hidden = |(mass, place): &(f64, &BallastPlace)| {
            (factor * mass, at_place(place, [random.uniform(), random.uniform()]))
        };
        let hidden: Vec<_> = pieces.iter().map(&mut hidden).collect();
        let (budget, most) = met_with(&hidden, &mut random);
        let whole = of_body(&budget.mass_properties(Basis::Basic).unwrap());
        let all = vec![
            sized(line.clone(), &[0.12, 0.2], Some(0.33)),
            sized(other.clone(), &[0.15, 0.1], Some(0.2)),
        ];
        let got = sought(&budget, &sites(all.clone()), &limits(most));
        // All combinations of pieces on the two places, the lightest first.
        let lines: [&[f64]; 5] = [&[], &[0.12], &[0.2], &[0.12, 0.12], &[0.12, 0.2]];
        let others: [&[f64]; 4] = [&[], &[0.1], &[0.15], &[0.1, 0.1]];
        let mut choices: Vec<(f64, Vec<(f64, &BallastPlace)>)> = Vec::new();
        for (a, b) in lines.iter().flat_map(|a| others.iter().map(move |b| (a, b))) {
            let pieces = a.iter().map(|mass| (*mass, &line)).chain(b.iter().map(|mass| (*mass, &other)));
            choices.push((a.iter().chain(*b).sum(), pieces.collect()));
        }
        choices.sort_by(|a, b| a.0.total_cmp(&b.0));
        let best = choices.iter().find(|(_, pieces)| does_somewhere(&whole, pieces, most, &mut random));
        match (best, &got) {
            (Some((best, _)), Some(got)) => {
                assert!((got.mass - best).abs() < 1e-12, "{case}: {} {best}", got.mass);
                found += usize::from(*best > 0.0);
            }
            (None, None) => none += 1,
            (best, got) => panic!("{case}: {best:?} {got:?}"),
        }
    }
    assert!(found >= 28 && none >= 3, "{found} {none}");
}

#[test]
fn a_center_is_put_on_a_line_by_as_many_pieces_as_it_takes() {
    let out = 0.03_f64.hypot(-0.02);
    let budget = body(5.0, Position::new(0.03, -0.02, 0.4), [0.02, -0.03, 0.01]);
    let within = Measure::CenterFromLine { point: Position::ZERO, along: Z };
    let ring = Round { center: Position::new(0.0, 0.0, 0.3), normal: Z, radius: 0.7 };
    for (size, most) in [(0.025, 0.004), (0.003, 0.002), (0.3, 0.01), (0.011, 0.0)] {
        for place in [BallastPlace::Circle(ring), BallastPlace::Disc(ring)] {
            let all = sites(vec![sized(place, &[size], None)]);
            let found = sought(&budget, &all, &[limit(within.clone(), None, most)]);
            // M (out − most) ≤ n m (radius + most)
            let number = (5.0 * (out - most) / (0.7 + most) / size).ceil();
            let found = found.unwrap();
            assert!((found.mass - number * size).abs() < 1e-12, "{size} {most}: {} {number}", found.mass);
            assert_eq!(found.pieces.iter().map(|piece| piece.count).sum::<u64>() as f64, number);
        }
    }
}

#[test]
fn a_piece_beside_any_masses_is_where_it_makes_them_least() {
    let mut random = Random::new(59);
    let (mut found, mut with_piece) = (0, 0);
    for case in 0..12 {
        let line = BallastPlace::Line([random.point(), random.point()]);
        let points: Vec<Position<Body>> = (0..3).map(|_| random.point()).collect();
        let mut hidden = vec![(0.15, at_place(&line, [random.uniform(); 2]))];
        hidden.extend(points.iter().map(|at| (random.within(0.02, 0.2), *at)));
        let (budget, most) = met_with(&hidden, &mut random);
        let whole = of_body(&budget.mass_properties(Basis::Basic).unwrap());
        let all = hidden.iter().fold(whole, |all, (mass, at)| plus(&all, &sums(*mass, *at)));
        // ∫ (x − p) (z − q) dm of the body with the hidden ballast, with a small interval around
        // it.
        let (p, q) = (0.1, -0.1);
        let value = all[5] - p * all[3] - q * all[1] + p * q * all[0];
        let about = About::Point(Position::new(p, 0.2, q));
        let beside = product([X, Z], about, 0.0);
        let beside =
            Limit { least: Some(value - 0.3 * most[2]), most: Some(value + 0.6 * most[2]), ..beside };
        let limits = [center(X, most[0]), center(Y, most[1]), beside];
        // One piece only, because two exceed the largest mass.
        let with = |place: BallastPlace| {
            sites([vec![sized(place, &[0.08, 0.15], Some(0.155))], at(&points)].concat())
        };
        let got = sought(&budget, &with(line.clone()), &limits).unwrap();
        // Each point of a grid that is refined around the best point.
        let of = |s: f64| {
            let place = BallastPlace::Point(at_place(&line, [s.clamp(0.0, 1.0), 0.0]));
            sought(&budget, &with(place), &limits).map_or(f64::INFINITY, |one| one.mass)
        };
        let (mut best, mut half) = ((f64::INFINITY, 0.5), 0.5);
        for fine in [24, 8, 8, 8, 8, 8, 8] {
            let middle = best.1;
            for k in -fine..=fine {
                let s = middle + half * f64::from(k) / f64::from(fine);
                let mass = of(s);
                best = if mass < best.0 { (mass, s) } else { best };
            }
            half *= 2.0 / f64::from(fine);
        }
        assert!((got.mass - best.0).abs() <= 4e-6 * best.0, "{case}: {} {}", got.mass, best.0);
        found += usize::from(got.mass > 0.0);
        with_piece += usize::from(got.pieces.iter().any(|piece| piece.site == 0));
    }
    assert!(found >= 10 && with_piece >= 3, "{found} {with_piece}");
}

#[test]
fn sizes_with_products_are_those_of_all_combinations() {
    let mut random = Random::new(103);
    let (mut found, mut none) = (0, 0);
    for case in 0..30 {
        let points: Vec<Position<Body>> = (0..6).map(|_| random.point()).collect();
        let mut all = at(&points);
        for site in &mut all {
            site.sizes = (0..3).map(|_| (random.within(1.0, 40.0)).round() * 0.01).collect();
        }
        let hidden = all.iter().zip(&points).filter(|_| random.uniform() < 0.6);
        let hidden: Vec<_> = hidden.map(|(site, at)| (site.sizes[0], *at)).collect();
        let (budget, most) = met_with(&hidden, &mut random);
        let most = if case % 3 == 0 { most.map(|most| 0.3 * most) } else { most };
        let whole = of_body(&budget.mass_properties(Basis::Basic).unwrap());
        let mut best = f64::INFINITY;
        for choice in 0..4_usize.pow(6) {
            let (mut sum, mut total) = (whole, 0.0);
            for (k, (site, at)) in all.iter().zip(&points).enumerate() {
                if let Some(which) = (choice / 4_usize.pow(k as u32) % 4).checked_sub(1) {
                    total += site.sizes[which];
                    sum = plus(&sum, &sums(site.sizes[which], *at));
                }
            }
            if total < best && is_met(&sum, most) {
                best = total;
            }
        }
        let got = sought(&budget, &sites(all.clone()), &limits(most));
        match &got {
            Some(got) => {
                assert!((got.mass - best).abs() < 1e-12, "{case}: {} {best}", got.mass);
                found += usize::from(got.mass > 0.0);
            }
            None => {
                assert_eq!(best, f64::INFINITY, "{case}");
                none += 1;
            }
        }
    }
    assert!(found >= 20 && none >= 4, "{found} {none}");
}

/// Fine pieces are only slightly heavier than arbitrary masses.
#[test]
fn fine_pieces_are_as_heavy_as_any_masses() {
    let budget = body(6.0, Position::new(0.021, -0.013, 0.2), [0.03, 0.02, -0.05]);
    let ring =
        Round { center: Position::new(0.05, 0.02, 0.5), normal: Direction::new(0.3, -0.2, 1.0), radius: 0.6 };
    let disc = Round { center: Position::new(-0.1, 0.03, -0.3), normal: Z, radius: 0.5 };
    let places = [BallastPlace::Circle(ring), BallastPlace::Disc(disc)];
    let about = About::CenterOfMass;
    let limits = [product([X, Z], about, 0.01), product([Y, Z], about, 0.01)];
    let of = |size: Option<f64>| {
        let site = |place: &BallastPlace| sized(place.clone(), size.as_slice(), Some(0.25));
        sites(places.iter().map(site).collect())
    };
    let any = sought(&budget, &of(None), &limits).unwrap();
    for size in [0.003, 2e-5] {
        let found = sought(&budget, &of(Some(size)), &limits).unwrap();
        let number = (any.mass / size).ceil();
        assert!((found.mass - number * size).abs() < 1e-12, "{} {}", found.mass, any.mass);
        assert_eq!(found.pieces.iter().map(|piece| piece.count).sum::<u64>() as f64, number);
        assert!(found.pieces.len() < 40);
    }
}
