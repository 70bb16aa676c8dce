//! Lower bounds and local minima of ballast against a random search, on general random problems.
//!
//! Each body has limits that some hidden ballast meets. A random descent from there finds lighter
//! ballast that meets them. The lower bound has to be below, and the result should not be above.

use polhode::math::{Body, Direction, Position};
use polhode_budget::{
    About, Ballast, BallastAnswer, BallastPlace, Basis, Budget, GivenPart, GivenTensor, Limit, Measure,
    PartsList, ProductSign, Round, Row, Site,
};

use crate::ballast::{Random, sought};

/// Ballast at one point: its mass, and two numbers from 0 to 1 for the point of its site.
#[derive(Clone, Copy)]
struct Lot {
    site: usize,
    mass: f64,
    at: [f64; 2],
}

struct Question {
    budget: Budget,
    sites: Vec<Site>,
    limits: Vec<Limit>,
    hidden: Vec<Lot>,
}

/// Mass, ∫ r dm, and ∫ (xx, yy, zz, xy, xz, yz) dm.
type Moments = [f64; 10];

fn moments(mass: f64, r: Position<Body>) -> Moments {
    let [x, y, z] = r.to_array();
    [1.0, x, y, z, x * x, y * y, z * z, x * y, x * z, y * z].map(|w| mass * w)
}

fn point(place: &BallastPlace, [s, t]: [f64; 2]) -> Position<Body> {
    match place {
        BallastPlace::Point(p) => *p,
        BallastPlace::Line([a, b]) => *a + (*b - *a) * s,
        BallastPlace::Disc(round) | BallastPlace::Circle(round) => {
            let n = round.normal.direction().unwrap();
            let u = n.cross(Direction::new(0.3, -0.5, 0.8)).direction().unwrap();
            let out = if matches!(place, BallastPlace::Disc(_)) { t } else { 1.0 };
            let (sin, cos) = (core::f64::consts::TAU * s).sin_cos();
            let r = (u * cos + n.cross(u) * sin) * (round.radius * out);
            round.center + Position::from_array(r.to_array())
        }
    }
}

fn direction(random: &mut Random) -> Direction<Body> {
    Direction::from_array(random.point().to_array()).direction().unwrap()
}

/// Value of a measure, by its definition.
fn value(of: &Measure, [m, s @ .., xx, yy, zz, xy, xz, yz]: &Moments) -> f64 {
    let w = [[*xx, *xy, *xz], [*xy, *yy, *yz], [*xz, *yz, *zz]];
    let first = |u: Direction<Body>| u.to_array().iter().zip(s).map(|(u, s)| u * s).sum::<f64>();
    let second = |u: Direction<Body>, v: Direction<Body>| -> f64 {
        let (u, v) = (u.to_array(), v.to_array());
        (0..9).map(|k| u[k / 3] * w[k / 3][k % 3] * v[k % 3]).sum()
    };
    let axis = |u: Direction<Body>, p: Position<Body>| u.dot(Direction::from_array(p.to_array()));
    match of {
        Measure::Mass => *m,
        Measure::Center { along, from } => first(*along) / m - axis(*along, *from),
        Measure::CenterFromLine { point, along } => {
            let c = Position::from_array([s[0] / m, s[1] / m, s[2] / m]) - *point;
            (c.dot(c) - axis(*along, c).powi(2)).max(0.0).sqrt()
        }
        Measure::Product { axes: [u, v], about: About::CenterOfMass, .. } => {
            second(*u, *v) - first(*u) * first(*v) / m
        }
        Measure::Product { axes: [u, v], about: About::Point(p), .. } => {
            let (a, b) = (axis(*u, *p), axis(*v, *p));
            second(*u, *v) - a * first(*v) - b * first(*u) + a * b * m
        }
        _ => panic!("{of:?}"),
    }
}

impl Question {
    fn new(random: &mut Random, is_sized: bool, has_products: bool) -> Self {
        let mass = random.within(3.0, 9.0);
        let tensor = GivenTensor {
            moments: [random.within(2.6, 3.4), random.within(3.6, 4.4), random.within(4.6, 5.4)],
            products: [(); 3].map(|()| random.within(-0.3, 0.3)),
            ..GivenTensor::ZERO
        };
        let center_of_mass = Position::from_array((random.point() * 0.1).to_array());
        let row = Row::part("body", GivenPart { mass, center_of_mass, tensor });
        let budget = PartsList { rows: vec![row], ..PartsList::default() }.budget().unwrap();
        let number = 2 + (3.0 * random.uniform()) as usize;
        let site = |k: usize| {
            let round = Round {
                center: random.point() * 0.6,
                normal: direction(random),
                radius: random.within(0.2, 0.8),
            };
            let place = match (5.0 * random.uniform()) as usize {
                0 => BallastPlace::Line([random.point(), random.point()]),
                1 => BallastPlace::Disc(round),
                2 => BallastPlace::Circle(round),
                _ => BallastPlace::Point(random.point()),
            };
            let sizes = [0.05, 0.08, 0.2].map(|size| size * random.within(0.7, 1.3));
            let sizes = if is_sized && random.uniform() < 0.8 { sizes.to_vec() } else { Vec::new() };
            Site { sizes, ..Site::new(format!("{k}"), place) }
        };
        let sites: Vec<Site> = (0..number).map(site).collect();
        let lot = |(site, own): (usize, &Site)| {
            let any = random.within(0.02, 0.4);
            let mass = own.sizes.get((3.0 * random.uniform()) as usize).copied().unwrap_or(any);
            Lot { site, mass, at: [random.uniform(), random.uniform()] }
        };
        let hidden: Vec<Lot> = sites.iter().enumerate().map(lot).collect();
        let mut question = Self { budget, sites, limits: Vec::new(), hidden };
        let about = |random: &mut Random| {
            if has_products { About::CenterOfMass } else { About::Point(random.point() * 0.2) }
        };
        let axes = |random: &mut Random| {
            let u = direction(random);
            [u, u.cross(direction(random)).direction().unwrap()]
        };
        let sign = ProductSign::PositiveIntegral;
        let mut measures = vec![
            Measure::Center { along: direction(random), from: random.point() * 0.1 },
            Measure::Product { axes: axes(random), sign, about: about(random) },
            Measure::Product { axes: axes(random), sign, about: about(random) },
            Measure::CenterFromLine { point: random.point() * 0.1, along: direction(random) },
        ];
        measures.truncate(2 + (3.0 * random.uniform()) as usize);
        let (with, without) = (question.with(&question.hidden), question.with(&[]));
        for of in measures {
            let [now, then] = [&without, &with].map(|all| value(&of, all));
            // The limit is between the values without ballast and with it, nearer to the latter.
            let most = then + random.within(0.02, 0.5) * (now - then);
            let (least, most) = if matches!(of, Measure::CenterFromLine { .. }) {
                (None, Some(most.max(then)))
            } else if now > then {
                (None, Some(most))
            } else {
                (Some(most), None)
            };
            let name = format!("{of:?}");
            question.limits.push(Limit { name, of, least, most, basis: Basis::Basic });
        }
        question
    }

    /// Moments of the body with ballast.
    fn with(&self, lots: &[Lot]) -> Moments {
        let body = self.budget.mass_properties(Basis::Basic).unwrap();
        let mut all = moments(body.mass(), body.center_of_mass());
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix();
        let half = 0.5 * (xx + yy + zz);
        let own = [half - xx, half - yy, half - zz, -xy, -xz, -yz];
        all[4..].iter_mut().zip(own).for_each(|(w, own)| *w += own);
        for lot in lots {
            let one = moments(lot.mass, point(&self.sites[lot.site].place, lot.at));
            all.iter_mut().zip(one).for_each(|(w, one)| *w += one);
        }
        all
    }

    fn is_met(&self, lots: &[Lot]) -> bool {
        let all = self.with(lots);
        self.limits.iter().all(|limit| limit.is_met(value(&limit.of, &all)))
    }

    /// Lightest ballast of a random descent from the hidden one.
    fn descent(&self, random: &mut Random) -> f64 {
        let total = |lots: &[Lot]| lots.iter().map(|lot| lot.mass).sum::<f64>();
        let mut lots = self.hidden.clone();
        assert!(self.is_met(&lots));
        for step in 0..4000 {
            let far = 0.5_f64.powf(12.0 * f64::from(step % 400) / 400.0);
            let mut next = lots.clone();
            for lot in &mut next {
                lot.at = lot.at.map(|x| (x + far * random.within(-1.0, 1.0)).clamp(0.0, 1.0));
                let sizes = &self.sites[lot.site].sizes;
                if sizes.is_empty() {
                    lot.mass = (lot.mass + 0.1 * far * random.within(-1.2, 0.8)).max(0.0);
                } else if random.uniform() < 0.3 {
                    let size = sizes.get((4.0 * random.uniform()) as usize);
                    lot.mass = size.copied().unwrap_or(0.0);
                }
            }
            if total(&next) <= total(&lots) && self.is_met(&next) {
                lots = next;
            }
        }
        total(&lots)
    }
}

/// Compares the search with the descent, and returns how often it was heavier, and was proved.
fn compared(seed: u64, number: usize, is_sized: bool, has_products: bool) -> [usize; 2] {
    let mut random = Random::new(seed);
    let (mut heavier, mut proved) = (0, 0);
    for case in 0..number {
        let question = Question::new(&mut random, is_sized, has_products);
        let best = question.descent(&mut random);
        let ballast = Ballast { sites: question.sites.clone(), ..Ballast::default() };
        match question.budget.ballast(&ballast, &question.limits).unwrap() {
            BallastAnswer::Found(found) => {
                assert!(found.bound <= best * (1.0 + 1e-9), "{case}: {found:?} {best}");
                sought(&question.budget, &ballast, &question.limits);
                heavier += usize::from(found.mass > best * (1.0 + 1e-6));
                proved += usize::from(found.is_least());
            }
            BallastAnswer::NotFound(none) => {
                assert!(none.bound <= best * (1.0 + 1e-9), "{case}: {none:?} {best}");
                heavier += 1;
            }
        }
    }
    [heavier, proved]
}

#[test]
fn bounds_of_linear_and_conic_limits_are_those_of_the_least() {
    let [heavier, proved] = compared(201, 100, false, false);
    assert!(heavier == 0 && proved == 100, "{heavier} {proved}");
}

#[test]
fn bounds_of_pieces_hold() {
    let [heavier, proved] = compared(202, 40, true, false);
    assert!(heavier <= 1, "{heavier} {proved}");
}

#[test]
fn bounds_of_products_about_the_center_hold() {
    let [heavier, proved] = compared(203, 100, false, true);
    assert!(heavier <= 1, "{heavier} {proved}");
}

#[test]
fn bounds_of_pieces_with_products_hold() {
    let [heavier, proved] = compared(204, 15, true, true);
    assert!(heavier <= 3, "{heavier} {proved}");
}
