//! Ballast in pieces of given sizes on lines, discs and circles, against grids of places and closed forms.

use polhode::body::MassProperties;
use polhode::math::{Body, Direction, Position};
use polhode_budget::{
    About, BallastPlace, Basis, Budget, FoundBallast, Limit, Measure, ProductSign, Round, Site,
};

use crate::ballast::{Random, at, body, center, least, limit, product, sites};

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

/// Whether the centre is within `most` along x and y, and the products about it are within theirs.
fn is_met([m, x, y, z, yz, xz, xy]: &Sums, most: [f64; 5]) -> bool {
    let all = [x / m, y / m, yz - y * z / m, xz - x * z / m, xy - x * y / m];
    all.iter().zip(most).all(|(value, most)| value.abs() <= most)
}

fn limits(most: [f64; 5]) -> Vec<Limit> {
    let about = About::CenterOfMass;
    let products = [([Y, Z], 2), ([X, Z], 3), ([X, Y], 4)].map(|(axes, k)| product(axes, about, most[k]));
    [vec![center(X, most[0]), center(Y, most[1])], products.to_vec()].concat()
}

/// Points of a place.
fn grid(place: &BallastPlace, fine: i32) -> Vec<Position<Body>> {
    match place {
        BallastPlace::Point(p) => vec![*p],
        BallastPlace::Line([a, b]) => {
            (0..=fine).map(|k| *a + (*b - *a) * (f64::from(k) / f64::from(fine))).collect()
        }
        BallastPlace::Disc(round) | BallastPlace::Circle(round) => {
            let n = round.normal.direction().unwrap();
            let u = n.cross(if n.x.abs() < 0.5 { X } else { Y }).direction().unwrap();
            let v = n.cross(u);
            let rings = if matches!(place, BallastPlace::Disc(_)) { 0..=6 } else { 6..=6 };
            let at = |ring: i32, k: i32| {
                let (sin, cos) = (core::f64::consts::TAU * f64::from(k) / f64::from(fine)).sin_cos();
                let out = (u * cos + v * sin) * (round.radius * f64::from(ring) / 6.0);
                round.center + Position::from_array(out.to_array())
            };
            rings.flat_map(|ring| (0..fine).map(move |k| (ring, k))).map(|(ring, k)| at(ring, k)).collect()
        }
    }
}

/// Whether pieces at some points of their grids meet the limits.
fn does_on_grid(whole: &Sums, pieces: &[(f64, &[Position<Body>])], most: [f64; 5]) -> bool {
    let Some(((mass, points), rest)) = pieces.split_first() else { return is_met(whole, most) };
    points.iter().any(|point| does_on_grid(&plus(whole, &sums(*mass, *point)), rest, most))
}

fn question(random: &mut Random) -> (Budget, [f64; 5]) {
    let budget = body(random.within(4.0, 9.0), random.point() * 0.03, [0.03, 0.02, -0.05]);
    let wide = random.within(0.04, 0.09);
    (budget, [random.within(0.004, 0.012), random.within(0.004, 0.012), wide, 0.8 * wide, wide])
}

fn round(random: &mut Random) -> Round {
    let normal = Direction::from_array(random.point().to_array());
    Round { center: random.point() * 0.5, normal, radius: random.within(0.4, 0.8) }
}

#[test]
fn pieces_on_lines_and_rounds_are_those_of_grids() {
    let mut random = Random::new(41);
    let (mut found, mut same, mut none) = (0, 0, 0);
    for case in 0..13 {
        let (budget, most) = question(&mut random);
        let whole = of_body(&budget.mass_properties(Basis::Basic).unwrap());
        let line = BallastPlace::Line([random.point(), random.point()]);
        let round = round(&mut random);
        let other = match case % 3 {
            0 => BallastPlace::Disc(round),
            1 => BallastPlace::Circle(round),
            _ => BallastPlace::Line([random.point(), random.point()]),
        };
        let grids = [grid(&line, 40), grid(&other, 48)];
        let all = vec![sized(line, &[0.12, 0.2], Some(0.33)), sized(other, &[0.15, 0.1], Some(0.2))];
        let got = least(&budget, &sites(all.clone()), &limits(most), 1e-6);
        if let Some(got) = &got {
            check_pieces(got, &all);
        }
        // All that the two may have.
        let (lines, others): (&[&[f64]], &[&[f64]]) =
            (&[&[], &[0.12], &[0.2], &[0.12, 0.12], &[0.12, 0.2]], &[&[], &[0.1], &[0.15], &[0.1, 0.1]]);
        let mut best = f64::INFINITY;
        for a in lines {
            for b in others {
                let total: f64 = a.iter().chain(*b).sum();
                let on = |k: usize| move |mass: &f64| (*mass, k);
                let pieces: Vec<(f64, usize)> = a.iter().map(on(0)).chain(b.iter().map(on(1))).collect();
                let pieces: Vec<(f64, &[Position<Body>])> =
                    pieces.iter().map(|(mass, k)| (*mass, &grids[*k][..])).collect();
                if total < best && pieces.len() <= 3 && does_on_grid(&whole, &pieces, most) {
                    best = total;
                }
            }
        }
        let mass = got.as_ref().map_or(f64::INFINITY, |got| got.mass);
        assert!(mass <= best + 1e-12, "{case}: {mass} {best}");
        none += usize::from(got.is_none());
        found += usize::from(mass.is_finite() && mass > 0.0);
        same += usize::from(mass > 0.0 && (mass - best).abs() < 1e-12);
    }
    assert!(found >= 1 && same >= 1 && none >= 6, "{found} {same} {none}");
}

fn check_pieces(found: &FoundBallast, all: &[Site]) {
    for (k, site) in all.iter().enumerate().filter(|(_, site)| !site.sizes.is_empty()) {
        let own = found.pieces.iter().filter(|piece| piece.site == k);
        assert!(own.clone().all(|piece| site.sizes.contains(&piece.mass)), "{found:?}");
        let sum: f64 = own.map(|piece| piece.count as f64 * piece.mass).sum();
        assert!(sum <= site.most.unwrap_or(f64::INFINITY) + 1e-12, "{found:?}");
    }
}

#[test]
fn a_center_is_put_on_a_line_by_as_many_pieces_as_it_takes() {
    let out = 0.03_f64.hypot(-0.02);
    let budget = body(5.0, Position::new(0.03, -0.02, 0.4), [0.02, -0.03, 0.01]);
    let within = Measure::CenterFromLine { point: Position::ZERO, along: Z };
    let ring = Round { center: Position::new(0.0, 0.0, 0.3), normal: Z, radius: 0.7 };
    for (size, most) in [(0.025, 0.004), (0.003, 0.002), (0.3, 0.01), (0.011, 0.0)] {
        for place in [BallastPlace::Circle(ring), BallastPlace::Disc(ring)] {
            let found = least(
                &budget,
                &sites(vec![sized(place, &[size], None)]),
                &[limit(within.clone(), None, most)],
                1e-9,
            );
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
    let mut found = 0;
    for _ in 0..6 {
        let (budget, most) = question(&mut random);
        let limits = [
            center(X, most[0]),
            center(Y, most[1]),
            product([X, Z], About::Point(Position::new(0.1, 0.2, -0.1)), 2.0 * most[2]),
        ];
        let line = BallastPlace::Line([random.point(), random.point()]);
        let points = at(&[random.point(), random.point(), random.point()]);
        let with = |place: BallastPlace, sizes: &[f64]| {
            sites([vec![sized(place, sizes, Some(0.3))], points.clone()].concat())
        };
        let free = least(&budget, &with(line.clone(), &[0.08, 0.15]), &limits, 1e-6);
        // At each point of a grid one piece, or two beside each other.
        let mut best = f64::INFINITY;
        for point in grid(&line, 60) {
            let one = least(
                &budget,
                &with(BallastPlace::Point(point), &[0.08, 0.15, 0.16, 0.23, 0.3]),
                &limits,
                1e-6,
            );
            best = one.map_or(best, |one| best.min(one.mass));
        }
        let mass = free.map_or(f64::INFINITY, |free| free.mass);
        assert!(mass <= best * (1.0 + 2e-6), "{mass} {best}");
        if best.is_finite() && best > 0.0 {
            found += 1;
            assert!(mass > best * 0.9, "{mass} {best}");
        }
    }
    assert!(found >= 2, "{found}");
}

#[test]
fn sizes_with_products_are_decided() {
    let mut random = Random::new(103);
    let (mut found, mut none) = (0, 0);
    for case in 0..30 {
        let (budget, most) = question(&mut random);
        let points: Vec<Position<Body>> = (0..6).map(|_| random.point()).collect();
        let mut all = at(&points);
        for site in &mut all {
            site.sizes = (0..3).map(|_| (random.within(1.0, 40.0)).round() * 0.01).collect();
        }
        let most = most.map(|most| if case % 2 == 0 { most } else { 0.5 * most });
        match least(&budget, &sites(all.clone()), &limits(most), 1e-6) {
            Some(got) => {
                check_pieces(&got, &all);
                found += usize::from(got.mass > 0.0);
            }
            None => none += 1,
        }
    }
    assert!(found >= 5 && none >= 5, "{found} {none}");
}
