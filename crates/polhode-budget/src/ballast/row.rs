//! Limits as functions of the moments of the mass: what is linear in them, what is a cone, and what is neither.

use polhode::body::MassProperties;
use polhode::math::{Body, Direction, Position};

use super::error::BallastError;
use super::interval::{Interval, dot};
use crate::estimate::Estimate;
use crate::growth::Basis;
use crate::limit::{About, Limit, Measure};

/// Moments of a mass: 1, x, y, z, xx, yy, zz, xy, xz, yz, from the origin of the problem.
pub(super) type Moments = [Interval; 10];

/// A constant and a linear function of the moments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Functional {
    pub(super) constant: Interval,
    pub(super) by: Moments,
    /// What it is the small difference of: its rounding is a few 1e-16 of that.
    pub(super) size: f64,
}

/// What functions of the moments have to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// None negative.
    Positive,
    /// All zero.
    Zero,
    /// The first no less than the norm of the others.
    Cone,
}

/// Functions that go together.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Block {
    pub(super) kind: Kind,
    pub(super) rows: Vec<Functional>,
}

/// A limit on a product about the centre of mass: u·W v − (u·S)(v·S)/M, with the coordinates of the centre by which it is bounded.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Product {
    pub(super) axes: [Vector; 2],
    /// Of the centre's coordinates that are searched.
    pub(super) coordinates: [usize; 2],
    pub(super) basis: Basis,
    /// Of ∫ u v dm.
    pub(super) least: Option<f64>,
    pub(super) most: Option<f64>,
}

/// A coordinate of the centre of mass, from the origin of the problem.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Coordinate {
    pub(super) along: Vector,
    pub(super) basis: Basis,
}

pub(super) type Vector = [Interval; 3];

/// What a limit asks of the moments.
pub(super) enum Asked {
    Blocks(Vec<Block>),
    Product { axes: [Vector; 2], least: Option<f64>, most: Option<f64> },
}

/// The moments of a unit mass.
pub(super) fn weights([x, y, z]: Vector) -> Moments {
    [Interval::ONE, x, y, z, x.square(), y.square(), z.square(), x * y, x * z, y * z]
}

/// The moments of a body.
pub(super) fn moments(body: &MassProperties<Body>, origin: [f64; 3]) -> Moments {
    let mass = Interval::from(body.mass());
    let c = body.center_of_mass().to_array();
    let d: Vector = core::array::from_fn(|k| Interval::from(c[k]) - Interval::from(origin[k]));
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix().map(|row| row.map(Interval::from));
    let half = Interval::from(0.5);
    let own = [half * (yy + zz - xx), half * (xx + zz - yy), half * (xx + yy - zz), -xy, -xz, -yz];
    let mut all = weights(d).map(|w| mass * w);
    all[4..].iter_mut().zip(own).for_each(|(sum, own)| *sum = *sum + own);
    all
}

impl Functional {
    const ZERO: Self = Self { constant: Interval::ZERO, by: [Interval::ZERO; 10], size: 0.0 };

    pub(super) fn constant(x: Interval) -> Self {
        Self { constant: x, ..Self::ZERO }
    }

    /// M
    pub(super) fn mass() -> Self {
        let mut by = [Interval::ZERO; 10];
        by[0] = Interval::ONE;
        Self { by, ..Self::ZERO }
    }

    /// u·S
    pub(super) fn first([x, y, z]: Vector) -> Self {
        let mut by = [Interval::ZERO; 10];
        by[1..4].copy_from_slice(&[x, y, z]);
        Self { by, ..Self::ZERO }
    }

    /// ∫ (u·r)(v·r) dm
    pub(super) fn second(u: Vector, v: Vector) -> Self {
        let both = |i: usize, j: usize| u[i] * v[j] + u[j] * v[i];
        let mut by = [Interval::ZERO; 10];
        by[4..].copy_from_slice(&[u[0] * v[0], u[1] * v[1], u[2] * v[2], both(0, 1), both(0, 2), both(1, 2)]);
        Self { by, ..Self::ZERO }
    }

    /// ∫ u·(r − p) dm
    fn first_from(u: Vector, p: Vector) -> Self {
        Self::first(u) - Self::mass() * dot(&u, &p)
    }

    /// ∫ u·(r − p) v·(r − p) dm
    fn second_from(u: Vector, v: Vector, p: Vector) -> Self {
        let (up, vp) = (dot(&u, &p), dot(&v, &p));
        Self::second(u, v) - Self::first(u) * vp - Self::first(v) * up + Self::mass() * (up * vp)
    }

    /// Of these moments, without the constant.
    pub(super) fn at(&self, moments: &Moments) -> Interval {
        dot(&self.by, moments)
    }

    /// uᵀ L v of the quadratic part.
    pub(super) fn form(&self, u: &Vector, v: &Vector) -> Interval {
        let [.., xx, yy, zz, xy, xz, yz] = self.by;
        let half = Interval::from(0.5);
        let off = |l: Interval, i: usize, j: usize| half * l * (u[i] * v[j] + u[j] * v[i]);
        xx * u[0] * v[0] + yy * u[1] * v[1] + zz * u[2] * v[2] + off(xy, 0, 1) + off(xz, 0, 2) + off(yz, 1, 2)
    }

    /// How it changes along e, of a unit mass at r.
    pub(super) fn slope(&self, r: &Vector, e: &Vector) -> Interval {
        let [_, x, y, z, ..] = self.by;
        dot(&[x, y, z], e) + Interval::from(2.0) * self.form(r, e)
    }

    /// The same of the mass that is added to these moments.
    pub(super) fn added_to(mut self, moments: &Moments) -> Self {
        let terms = self.by.iter().zip(moments).map(|(l, w)| (*l * *w).size());
        self.size = self.constant.size() + terms.sum::<f64>();
        self.constant = self.constant + self.at(moments);
        self
    }

    /// Its standard deviation to first order, of a body.
    fn sd(&self, estimate: &Estimate<Body>, origin: [f64; 3]) -> f64 {
        let by = self.by.map(Interval::middle);
        let (m, c) = (estimate.properties.mass(), estimate.properties.center_of_mass().to_array());
        let d: [f64; 3] = core::array::from_fn(|k| c[k] - origin[k]);
        let inner = |w: [f64; 10]| by.iter().zip(w).map(|(l, w)| l * w).sum::<f64>();
        // By the mass, the centre and the tensor: W = M (1, d, d dᵀ) + (0, 0, ½ tr I 1 − I).
        let gradient: [f64; 10] = core::array::from_fn(|k| {
            let mut w = [0.0; 10];
            match k {
                0 => return inner(weights(d.map(Interval::from)).map(Interval::middle)),
                1..4 => {
                    w[k] = m;
                    w[3 + k] = 2.0 * m * d[k - 1];
                    for (place, i, j) in [(7, 0, 1), (8, 0, 2), (9, 1, 2)] {
                        w[place] = m * (f64::from(i + 1 == k) * d[j] + f64::from(j + 1 == k) * d[i]);
                    }
                }
                4..7 => {
                    w[4..7].fill(0.5);
                    w[k] = -0.5;
                }
                _ => w[k] = -1.0,
            }
            inner(w)
        });
        let variance = polhode::infer::covariance::form(&gradient, &estimate.covariance, &gradient);
        variance.max(0.0).sqrt()
    }
}

impl core::ops::Add for Functional {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        let by = core::array::from_fn(|k| self.by[k] + b.by[k]);
        Self { constant: self.constant + b.constant, by, size: self.size.max(b.size) }
    }
}

impl core::ops::Sub for Functional {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self + b * -Interval::ONE
    }
}

impl core::ops::Mul<Interval> for Functional {
    type Output = Self;
    fn mul(self, by: Interval) -> Self {
        Self { constant: self.constant * by, by: self.by.map(|l| l * by), size: self.size * by.size() }
    }
}

impl Block {
    pub(super) fn positive(row: Functional) -> Self {
        Self { kind: Kind::Positive, rows: vec![row] }
    }
}

/// What a limit asks, with the whole kept so many standard deviations inside.
pub(super) fn asked(
    limit: &Limit,
    estimate: &Estimate<Body>,
    origin: [f64; 3],
    deviations: f64,
) -> Result<Asked, BallastError> {
    let refused = |why| BallastError::Limit { limit: limit.name.clone(), why };
    let from = |p: Position<Body>| -> Vector {
        let p = p.to_array();
        core::array::from_fn(|k| Interval::from(p[k]) - Interval::from(origin[k]))
    };
    let unit = |u: Direction<Body>| u.direction().unwrap_or(u).to_array().map(Interval::from);
    let sd = |row: &Functional| if deviations > 0.0 { row.sd(estimate, origin) } else { 0.0 };
    // least ≤ f ≤ most, or least M ≤ f ≤ most M.
    let between = |f: Functional, by: Functional| -> Result<Asked, BallastError> {
        let sides = |row: Functional| {
            let margin = Interval::from(deviations) * Interval::from(sd(&row));
            Block::positive(row - Functional::constant(margin))
        };
        let at = |bound: f64| by * Interval::from(bound);
        Ok(Asked::Blocks(match (limit.least, limit.most) {
            (Some(least), Some(most)) if least == most => {
                let row = f - at(least);
                if sd(&row) > 0.0 {
                    return Err(refused("an equality cannot be kept with a margin for errors"));
                }
                vec![Block { kind: Kind::Zero, rows: vec![row] }]
            }
            (least, most) => {
                let least = least.map(|least| sides(f - at(least)));
                least.into_iter().chain(most.map(|most| sides(at(most) - f))).collect()
            }
        }))
    };
    // |f| ≤ most, or most M.
    let norm = |rows: Vec<Functional>, by: Functional| -> Result<Asked, BallastError> {
        if limit.least.is_some_and(|least| least > 0.0) {
            return Err(refused("ballast can keep a distance or an unbalance below a value, not above one"));
        }
        let Some(most) = limit.most else { return Ok(Asked::Blocks(Vec::new())) };
        if most == 0.0 {
            if rows.iter().any(|row| sd(row) > 0.0) {
                return Err(refused("an equality cannot be kept with a margin for errors"));
            }
            return Ok(Asked::Blocks(vec![Block { kind: Kind::Zero, rows }]));
        }
        let greatest = by * Interval::from(most);
        // In any direction θ: var(g − θ·f) ≤ (sd g + √Σ var f)²
        let errors = rows.iter().map(|row| sd(row) * sd(row)).sum::<f64>().sqrt() + sd(&greatest);
        let first = greatest - Functional::constant(Interval::from(deviations) * Interval::from(errors));
        Ok(Asked::Blocks(vec![Block { kind: Kind::Cone, rows: [vec![first], rows].concat() }]))
    };
    let one = Functional::constant(Interval::ONE);
    match &limit.of {
        Measure::Mass => between(Functional::mass(), one),
        Measure::Center { along, from: p } => {
            between(Functional::first_from(unit(*along), from(*p)), Functional::mass())
        }
        Measure::CenterFromPoint(p) => {
            let rows = UNITS.map(|u| Functional::first_from(u.map(Interval::from), from(*p)));
            norm(rows.to_vec(), Functional::mass())
        }
        Measure::CenterFromLine { point, along } => {
            let rows = across(*along).map(|u| Functional::first_from(u, from(*point)));
            norm(rows.to_vec(), Functional::mass())
        }
        Measure::StaticUnbalance { point, along } => {
            let rows = across(*along).map(|u| Functional::first_from(u, from(*point)));
            norm(rows.to_vec(), one)
        }
        Measure::CoupleUnbalance { point, along } => {
            let rows = across(*along).map(|u| Functional::second_from(unit(*along), u, from(*point)));
            norm(rows.to_vec(), one)
        }
        Measure::Moment { axis, about: About::Point(p) } => {
            let (u, p) = (unit(*axis), from(*p));
            let all = UNITS.iter().map(|e| {
                let e = e.map(Interval::from);
                Functional::second_from(e, e, p)
            });
            between(all.fold(-Functional::second_from(u, u, p), |sum, f| sum + f), one)
        }
        Measure::Product { axes: [u, v], sign, about } => {
            // ∫ u v dm is the positive integral.
            let factor = Interval::from(-sign.factor());
            let (u, v) = (unit(*u), unit(*v));
            match about {
                About::Point(p) => between(Functional::second_from(u, v, from(*p)) * factor, one),
                About::CenterOfMass => {
                    if deviations > 0.0 {
                        return Err(refused(
                            "a margin for errors can be kept of products about a point that is fixed in the body only",
                        ));
                    }
                    let (least, most) = if factor.low > 0.0 {
                        (limit.least, limit.most)
                    } else {
                        (limit.most.map(|x| -x), limit.least.map(|x| -x))
                    };
                    Ok(Asked::Product { axes: [u, v], least, most })
                }
            }
        }
        Measure::Moment { about: About::CenterOfMass, .. } => {
            Err(refused("ballast can be found for moments about a point that is fixed in the body only"))
        }
        Measure::PrincipalMoment(_)
        | Measure::PrincipalRatio(_)
        | Measure::Tilt { .. }
        | Measure::SpinRatio(_)
        | Measure::SpinStability(_) => Err(refused(
            "ballast can be found for masses, centres, products and unbalance: an axis is principal where its two products about the centre of mass are zero",
        )),
    }
}

const UNITS: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Two directions across a line, perpendicular.
fn across(along: Direction<Body>) -> [Vector; 2] {
    crate::limit::across_axes(along).map(|u| u.to_array().map(Interval::from))
}

impl core::ops::Neg for Functional {
    type Output = Self;
    fn neg(self) -> Self {
        self * -Interval::ONE
    }
}
