//! Limits as functions of the moments of the mass: linear, a cone, or a product about the moving
//! centre.

use polhode::body::MassProperties;
use polhode::math::{Body, Direction, Position};

use super::error::BallastError;
use crate::estimate::Estimate;
use crate::limit::{About, Limit, Measure, across_axes};
use polhode::infer::covariance::{dot, form};

/// Moments of a mass: 1, x, y, z, xx, yy, zz, xy, xz, yz, from the origin of the problem.
pub(super) type Moments = [f64; 10];

pub(super) type Vector = [f64; 3];

/// Symmetric 3×3 matrix: xx, yy, zz, xy, xz, yz.
type Symmetric = [f64; 6];

/// Linear function of the moments, with a constant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Functional {
    pub(super) constant: f64,
    pub(super) by: Moments,
    /// Sum of the magnitudes whose difference the constant is. The rounding error is a few 1e-16 of
    /// it.
    pub(super) size: f64,
}

/// Linear condition on the moments of the ballast.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    pub(super) of: Functional,
    /// True for the condition = 0; false for ≥ 0.
    pub(super) is_zero: bool,
    /// Magnitude that the function is compared with.
    pub(super) scale: f64,
}

impl Row {
    pub(super) const fn new(of: Functional, is_zero: bool) -> Self {
        Self { of, is_zero, scale: 1.0 }
    }
}

/// Condition on the moments of the ballast.
#[derive(Clone, Debug)]
pub(super) enum Rule {
    Linear(Row),
    /// The first function is at least the norm of the others.
    Cone(Vec<Functional>),
    /// sign (P − bound) ≥ 0 or = 0, with P = u·W v − (u·S)(v·S)/M of the body and the ballast.
    Product {
        axes: [Vector; 2],
        body: Moments,
        sign: f64,
        bound: f64,
        is_zero: bool,
    },
}

/// Returns the moments of a unit mass at a place.
pub(super) fn weights([x, y, z]: Vector) -> Moments {
    [1.0, x, y, z, x * x, y * y, z * z, x * y, x * z, y * z]
}

/// Returns the moments of a body from an origin.
pub(super) fn moments(body: &MassProperties<Body>, origin: Vector) -> Moments {
    let c = body.center_of_mass().to_array();
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix();
    let half = 0.5 * (xx + yy + zz);
    let own = [0.0, 0.0, 0.0, 0.0, half - xx, half - yy, half - zz, -xy, -xz, -yz];
    let w = weights(core::array::from_fn(|k| c[k] - origin[k]));
    core::array::from_fn(|k| body.mass() * w[k] + own[k])
}

/// Returns ½ (u vᵀ + v uᵀ).
fn outer(u: Vector, v: Vector) -> Symmetric {
    let both = |i: usize, j: usize| 0.5 * (u[i] * v[j] + u[j] * v[i]);
    [u[0] * v[0], u[1] * v[1], u[2] * v[2], both(0, 1), both(0, 2), both(1, 2)]
}

fn times([xx, yy, zz, xy, xz, yz]: Symmetric, v: Vector) -> Vector {
    [dot(&[xx, xy, xz], &v), dot(&[xy, yy, yz], &v), dot(&[xz, yz, zz], &v)]
}

impl Functional {
    pub(super) const ZERO: Self = Self { constant: 0.0, by: [0.0; 10], size: 0.0 };

    /// Total mass M as a function of the moments.
    pub(super) const MASS: Self =
        Self { by: [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], ..Self::ZERO };

    /// Returns ∫ u·(r − p) dm.
    pub(super) fn first(u: Vector, p: Vector) -> Self {
        let mut by = [0.0; 10];
        by[..4].copy_from_slice(&[-dot(&u, &p), u[0], u[1], u[2]]);
        Self { by, ..Self::ZERO }
    }

    /// Returns ∫ (r − p)·A (r − p) dm.
    fn second(a: Symmetric, p: Vector) -> Self {
        let [x, y, z] = times(a, p);
        let [xx, yy, zz, xy, xz, yz] = a;
        let [m, x, y, z] = [dot(&p, &[x, y, z]), -2.0 * x, -2.0 * y, -2.0 * z];
        Self { by: [m, x, y, z, xx, yy, zz, 2.0 * xy, 2.0 * xz, 2.0 * yz], ..Self::ZERO }
    }

    /// Returns the sum of this function and a multiple of another.
    pub(super) fn plus(&self, factor: f64, other: &Self) -> Self {
        Self {
            constant: self.constant + factor * other.constant,
            by: core::array::from_fn(|k| self.by[k] + factor * other.by[k]),
            size: self.size.max(factor.abs() * other.size),
        }
    }

    /// Returns the linear part at these moments.
    pub(super) fn at(&self, moments: &Moments) -> f64 {
        dot(&self.by, moments)
    }

    /// Returns the bilinear form of the quadratic part.
    pub(super) fn form(&self, u: &Vector, v: &Vector) -> f64 {
        let [.., xx, yy, zz, xy, xz, yz] = self.by;
        dot(u, &times([xx, yy, zz, 0.5 * xy, 0.5 * xz, 0.5 * yz], *v))
    }

    /// Returns the derivative along e for a unit mass at r.
    pub(super) fn slope(&self, r: &Vector, e: &Vector) -> f64 {
        let [_, x, y, z, ..] = self.by;
        dot(&[x, y, z], e) + 2.0 * self.form(r, e)
    }

    /// Returns the function of the mass that is added to a body with these moments.
    pub(super) fn added_to(mut self, moments: &Moments) -> Self {
        let terms = self.by.iter().zip(moments).map(|(l, w)| (l * w).abs());
        self.size = self.constant.abs() + terms.sum::<f64>();
        self.constant += self.at(moments);
        self
    }

    /// Returns the standard deviation to first order, for a body with uncertain mass, centre and
    /// tensor.
    fn sd(&self, estimate: &Estimate<Body>, origin: Vector) -> f64 {
        let (m, c) = (estimate.properties.mass(), estimate.properties.center_of_mass().to_array());
        let d: Vector = core::array::from_fn(|k| c[k] - origin[k]);
        let by = &self.by;
        // W = M (1, d, d dᵀ) + (0, 0, ½ tr I 1 − I)
        let gradient: Moments = core::array::from_fn(|k| match k {
            0 => self.at(&weights(d)),
            1..4 => m * self.slope(&d, &UNITS[k - 1]),
            4..7 => 0.5 * (by[4] + by[5] + by[6]) - by[k],
            _ => -by[k],
        });
        form(&gradient, &estimate.covariance, &gradient).max(0.0).sqrt()
    }
}

impl Rule {
    /// Returns the condition linearized at the moments of given ballast, with the exact value
    /// there.
    ///
    /// The condition of a cone is f₀ − θ·f ≥ 0 with θ along f. It holds for all ballast inside the
    /// cone. The condition of a product is about the centre c of body and ballast:
    /// ∫ u·(r − c) v·(r − c) dm = P + M (u·(S/M − c)) (v·(S/M − c)).
    pub(super) fn tangent(&self, ballast: &Moments) -> Row {
        match self {
            Self::Linear(row) => *row,
            Self::Cone(all) => {
                let values: Vec<f64> = all[1..].iter().map(|f| f.constant + f.at(ballast)).collect();
                let norm = values.iter().fold(0.0_f64, |norm, x| norm.hypot(*x)).max(f64::MIN_POSITIVE);
                let cosines = values.iter().map(|x| x / norm);
                let of = all[1..].iter().zip(cosines).fold(all[0], |sum, (f, by)| sum.plus(-by, f));
                Row::new(of, false)
            }
            Self::Product { axes: [u, v], body, .. } => {
                let all: Moments = core::array::from_fn(|k| body[k] + ballast[k]);
                let of = |u: &Vector| dot(u, &[all[1], all[2], all[3]]) / all[0];
                self.about([of(u), of(v)])
            }
        }
    }

    /// Returns a product's condition with ∫ (u·r − a) (v·r − b) dm in place of P.
    ///
    /// P is this integral minus M (u·c − a) (v·c − b).
    pub(super) fn about(&self, [a, b]: [f64; 2]) -> Row {
        let Self::Product { axes: [u, v], body, sign, bound, is_zero } = self else {
            return Row::new(ONE, false);
        };
        let first = |u: &Vector| Functional::first(*u, [0.0; 3]);
        let square = Functional::second(outer(*u, *v), [0.0; 3]).plus(a * b, &Functional::MASS);
        let product = square.plus(-a, &first(v)).plus(-b, &first(u));
        let of = Functional::ZERO.plus(-sign * bound, &ONE).plus(*sign, &product).added_to(body);
        Row::new(of, *is_zero)
    }
}

/// Returns the conditions of a limit, with a margin in standard deviations.
pub(super) fn rules(
    limit: &Limit,
    estimate: &Estimate<Body>,
    origin: Vector,
    deviations: f64,
) -> Result<Vec<Rule>, BallastError> {
    let refused = |why| BallastError::Limit { limit: limit.name.clone(), why };
    let from = |p: Position<Body>| -> Vector {
        let p = p.to_array();
        core::array::from_fn(|k| p[k] - origin[k])
    };
    let unit = |u: Direction<Body>| u.direction().unwrap_or(u).to_array();
    let body = moments(&estimate.properties, origin);
    let margin = |row: &Functional| if deviations > 0.0 { row.sd(estimate, origin) } else { 0.0 };
    let linear = |of: Functional, is_zero| Rule::Linear(Row::new(of.added_to(&body), is_zero));
    // least ≤ f ≤ most, or least M ≤ f ≤ most M; or a norm |f| ≤ most, or most M.
    let (mass, coordinate) = (Functional::MASS, |u: Vector, p: Position<Body>| Functional::first(u, from(p)));
    let (rows, by, is_norm) = match &limit.of {
        Measure::Mass => (vec![mass], ONE, false),
        Measure::Center { along, from } => (vec![coordinate(unit(*along), *from)], mass, false),
        Measure::CenterFromPoint(p) => (UNITS.map(|u| coordinate(u, *p)).to_vec(), mass, true),
        Measure::CenterFromLine { point, along } => {
            (across_axes(*along).map(|u| coordinate(u.to_array(), *point)).to_vec(), mass, true)
        }
        Measure::StaticUnbalance { point, along } => {
            (across_axes(*along).map(|u| coordinate(u.to_array(), *point)).to_vec(), ONE, true)
        }
        Measure::CoupleUnbalance { point, along } => {
            let couple =
                |u: Direction<Body>| Functional::second(outer(unit(*along), u.to_array()), from(*point));
            (across_axes(*along).map(couple).to_vec(), ONE, true)
        }
        Measure::Moment { axis, about: About::Point(p) } => {
            let [xx, yy, zz, xy, xz, yz] = outer(unit(*axis), unit(*axis));
            let across = [1.0 - xx, 1.0 - yy, 1.0 - zz, -xy, -xz, -yz];
            (vec![Functional::second(across, from(*p))], ONE, false)
        }
        Measure::Product { axes: [u, v], sign, about: About::Point(p) } => {
            let integral = Functional::second(outer(unit(*u), unit(*v)), from(*p));
            (vec![Functional::ZERO.plus(-sign.factor(), &integral)], ONE, false)
        }
        Measure::Product { axes, sign, about: About::CenterOfMass } => {
            if deviations > 0.0 {
                return Err(refused(
                    "a margin for errors is supported only for products about a body-fixed point",
                ));
            }
            let is_zero = limit.least.is_some() && limit.least == limit.most;
            let side = |(bound, side): (Option<f64>, f64)| {
                // ∫ u v dm is the positive integral.
                let (sign, bound) = (-sign.factor() * side, -sign.factor() * bound?);
                Some(Rule::Product { axes: axes.map(unit), body, sign, bound, is_zero })
            };
            let sides = [(limit.least, 1.0), (limit.most.filter(|_| !is_zero), -1.0)];
            return Ok(sides.into_iter().filter_map(side).collect());
        }
        Measure::Moment { about: About::CenterOfMass, .. } => {
            return Err(refused("only moments about a body-fixed point are supported"));
        }
        Measure::PrincipalMoment(_)
        | Measure::PrincipalRatio(_)
        | Measure::Tilt { .. }
        | Measure::SpinRatio(_)
        | Measure::SpinStability(_) => {
            return Err(refused(
                "only masses, centres, products and unbalance are supported; an axis is principal if its two products about the centre of mass are zero",
            ));
        }
    };
    if is_norm && limit.least.is_some_and(|least| least > 0.0) {
        return Err(refused("a distance or an unbalance can have only an upper bound"));
    }
    let least = limit.least.filter(|_| !is_norm);
    let equal = limit.most.filter(|most| if is_norm { *most == 0.0 } else { least == Some(*most) });
    if let Some(value) = equal {
        let rows: Vec<Functional> = rows.iter().map(|row| row.plus(-value, &by)).collect();
        if rows.iter().any(|row| margin(row) > 0.0) {
            return Err(refused("an equality leaves no room for a margin"));
        }
        return Ok(rows.into_iter().map(|row| linear(row, true)).collect());
    }
    // In any direction θ: var(g − θ·f) ≤ (sd g + √Σ var f)²
    let side =
        |greatest: Functional, errors: f64| greatest.plus(-deviations * (errors + margin(&greatest)), &ONE);
    let most = limit.most.map(|most| Functional::ZERO.plus(most, &by));
    if is_norm {
        let errors = rows.iter().map(|row| margin(row).powi(2)).sum::<f64>().sqrt();
        let Some(first) = most.map(|most| side(most, errors)) else { return Ok(Vec::new()) };
        // Sides of a square around the cone. They keep linear programs near the cone.
        let sides = rows.iter().flat_map(|row| [-1.0, 1.0].map(|by| linear(first.plus(by, row), false)));
        let cone = core::iter::once(&first).chain(&rows).map(|row| row.added_to(&body));
        return Ok(sides.chain([Rule::Cone(cone.collect())]).collect());
    }
    let above = least.map(|least| rows[0].plus(-least, &by));
    let below = most.map(|most| most.plus(-1.0, &rows[0]));
    Ok(above.into_iter().chain(below).map(|row| linear(side(row, 0.0), false)).collect())
}

pub(super) const ONE: Functional = Functional { constant: 1.0, ..Functional::ZERO };

const UNITS: [Vector; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
