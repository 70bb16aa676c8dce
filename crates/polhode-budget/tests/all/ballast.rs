//! Least ballast compared with the corners of linear programs, and properties of all results.

use polhode::math::{Body, Direction, Position};
use polhode_budget::{
    About, Ballast, BallastAnswer, BallastPlace, Basis, Budget, FoundBallast, GivenPart, GivenTensor, Limit,
    Measure, PartsList, ProductSign, Row, Site,
};

const X: Direction<Body> = Direction::new(1.0, 0.0, 0.0);
const Y: Direction<Body> = Direction::new(0.0, 1.0, 0.0);
const Z: Direction<Body> = Direction::new(0.0, 0.0, 1.0);

pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub(crate) fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    pub(crate) fn point(&mut self) -> Position<Body> {
        let mut one = || self.within(-1.0, 1.0);
        Position::new(one(), one(), one())
    }
}

pub(crate) fn body(mass: f64, center: Position<Body>, products: [f64; 3]) -> Budget {
    let center = Position::from_array(center.to_array());
    let tensor = GivenTensor { moments: [3.1, 4.2, 5.3], products, ..GivenTensor::ZERO };
    let row = Row::part("body", GivenPart { mass, center_of_mass: center, tensor });
    PartsList { rows: vec![row], ..PartsList::default() }.budget().unwrap()
}

pub(crate) fn limit(of: Measure, least: impl Into<Option<f64>>, most: impl Into<Option<f64>>) -> Limit {
    let (least, most) = (least.into(), most.into());
    Limit { name: format!("{of:?}"), of, least, most, basis: Basis::Basic }
}

pub(crate) fn center(along: Direction<Body>, most: f64) -> Limit {
    limit(Measure::Center { along, from: Position::ZERO }, -most, most)
}

pub(crate) fn product(axes: [Direction<Body>; 2], about: About, most: f64) -> Limit {
    limit(Measure::Product { axes, sign: ProductSign::PositiveIntegral, about }, -most, most)
}

pub(crate) fn at(points: &[Position<Body>]) -> Vec<Site> {
    let site = |(k, point): (usize, &Position<Body>)| Site::new(format!("{k}"), BallastPlace::Point(*point));
    points.iter().enumerate().map(site).collect()
}

pub(crate) fn sites(sites: Vec<Site>) -> Ballast {
    Ballast { sites, ..Ballast::default() }
}

/// Returns ballast that passed the checks for any result: limits are met, and the lower bound is
/// below the mass.
pub(crate) fn sought(budget: &Budget, ballast: &Ballast, limits: &[Limit]) -> Option<FoundBallast> {
    let BallastAnswer::Found(found) = budget.ballast(ballast, limits).unwrap() else { return None };
    assert!(found.bound >= 0.0 && found.bound <= found.mass, "{found:?}");
    for limit in limits {
        let with = found.with(&budget.mass_properties(limit.basis).unwrap()).unwrap();
        let value = limit.of.value(&with).unwrap();
        let allowed = if limit.least == limit.most || limit.most == Some(0.0) { 1e-11 } else { 1e-14 };
        assert!(limit.most.is_none_or(|most| value <= most + allowed), "{limit:?} {value} {found:?}");
        assert!(limit.least.is_none_or(|least| value >= least - allowed), "{limit:?} {value}");
    }
    for (site, own) in ballast.sites.iter().enumerate() {
        let pieces = found.pieces.iter().filter(|piece| piece.site == site);
        assert!(own.sizes.is_empty() || pieces.clone().all(|piece| own.sizes.contains(&piece.mass)));
        let sum: f64 = pieces.map(|piece| piece.count as f64 * piece.mass).sum();
        assert!(sum <= own.most.unwrap_or(f64::INFINITY) + 1e-12, "{found:?}");
    }
    Some(found)
}

/// Returns ballast that passed these checks, and requires that the lower bound proves it.
pub(crate) fn least(budget: &Budget, ballast: &Ballast, limits: &[Limit]) -> Option<FoundBallast> {
    match budget.ballast(ballast, limits).unwrap() {
        BallastAnswer::NotFound(none) => assert!(none.is_proved() && none.up_to > 0.0, "{none:?}"),
        BallastAnswer::Found(found) => assert!(found.is_least(), "{found:?} {}", found.gap()),
    }
    sought(budget, ballast, limits)
}

/// Returns min Σ x with A x ≥ b and x ≥ 0, over all corners.
fn corners(a: &[Vec<f64>], b: &[f64]) -> Option<f64> {
    let n = a[0].len();
    let mut rows: Vec<(Vec<f64>, f64)> = a.iter().cloned().zip(b.iter().copied()).collect();
    for k in 0..n {
        rows.push(((0..n).map(|j| f64::from(j == k)).collect(), 0.0));
    }
    let mut best: Option<f64> = None;
    for chosen in 0_u32..1 << rows.len() {
        if chosen.count_ones() as usize != n {
            continue;
        }
        let mut system: Vec<Vec<f64>> = (0..rows.len())
            .filter(|k| chosen >> k & 1 == 1)
            .map(|k| rows[k].0.iter().copied().chain([rows[k].1]).collect())
            .collect();
        let Some(x) = gauss(&mut system) else { continue };
        let holds = rows.iter().all(|(row, bound)| {
            let size: f64 = row.iter().zip(&x).map(|(a, x)| (a * x).abs()).sum::<f64>() + bound.abs();
            row.iter().zip(&x).map(|(a, x)| a * x).sum::<f64>() >= bound - 1e-11 * size
        });
        if holds {
            let mass = x.iter().sum::<f64>();
            best = Some(best.map_or(mass, |best: f64| best.min(mass)));
        }
    }
    best
}

fn gauss(system: &mut [Vec<f64>]) -> Option<Vec<f64>> {
    let n = system.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| system[*i][k].abs().total_cmp(&system[*j][k].abs()))?;
        if system[pivot][k].abs() < 1e-12 {
            return None;
        }
        system.swap(k, pivot);
        let row = system[k].clone();
        for (i, other) in system.iter_mut().enumerate() {
            if i != k {
                let factor = other[k] / row[k];
                other.iter_mut().zip(&row).for_each(|(x, y)| *x -= factor * y);
            }
        }
    }
    Some((0..n).map(|k| system[k][n] / system[k][k]).collect())
}

#[test]
fn least_ballast_at_points_is_that_of_all_corners() {
    let mut random = Random::new(7);
    let (mut found, mut none) = (0, 0);
    for _ in 0..150 {
        let (mass, c) = (random.within(2.0, 20.0), random.point() * 0.05);
        let budget = body(mass, c, [0.02, -0.03, 0.01]);
        let points: Vec<Position<Body>> = (0..4).map(|_| random.point()).collect();
        let p = random.point() * 0.1;
        let most = [random.within(0.001, 0.02), random.within(0.001, 0.02), random.within(0.01, 0.2)];
        let limits = [
            center(X, most[0]),
            center(Y, most[1]),
            product([X, Z], About::Point(p), most[2]),
            limit(Measure::Mass, None, mass * random.within(1.02, 1.5)),
        ];
        // Each limit as f ≥ 0, by its definition.
        let whole = budget.mass_properties(Basis::Basic).unwrap();
        let now = limits[2].of.value(&whole).unwrap();
        let (mut a, mut b) = (Vec::new(), Vec::new());
        for (axis, most) in [(X, most[0]), (Y, most[1])] {
            for sign in [1.0, -1.0] {
                a.push(points.iter().map(|r| most - sign * axis.dot(*r)).collect());
                b.push(-mass * (most - sign * axis.dot(c)));
            }
        }
        for sign in [1.0, -1.0] {
            a.push(points.iter().map(|r| -sign * X.dot(*r - p) * Z.dot(*r - p)).collect());
            b.push(-(most[2] - sign * now));
        }
        a.push(vec![-1.0; 4]);
        b.push(mass - limits[3].most.unwrap());
        let want = corners(&a, &b);
        let got = least(&budget, &sites(at(&points)), &limits);
        match (want, got) {
            (None, None) => none += 1,
            (Some(want), Some(got)) => {
                found += usize::from(want > 0.0);
                assert!((got.mass - want).abs() <= 1e-9 * want, "{} {want}", got.mass);
                assert!(got.pieces.len() <= 4);
            }
            (want, got) => panic!("{want:?} {got:?}"),
        }
    }
    assert!(found > 40 && none > 20, "{found} {none}");
}
