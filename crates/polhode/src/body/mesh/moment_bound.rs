//! Bounds of the mass properties of a body of which some mass is uncertain.

use core::ops::{Add, Mul};

use super::hull::ConvexHull;
use crate::body::error::BodyError;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Frame;
use crate::math::vector::Position;

/// Bounds of the absolute moments of volume or mass that may or may not belong to a body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MomentBound {
    /// Bound of ∫ dV, m³, or of ∫ dm, kg.
    pub measure: f64,
    /// Bounds of ∫ |xᵢ| dV about a point.
    pub first: [f64; 3],
    /// Bounds of ∫ |xᵢ xⱼ| dV about that point.
    pub second: [[f64; 3]; 3],
}

/// Factor that exceeds the rounding of the sums.
const OUTWARD: f64 = 1.0 + 1e-9;

impl MomentBound {
    /// Returns the bounds for the convex hull of points, about a point: zero if they are coplanar.
    ///
    /// The hull is divided into tetrahedra from one of its corners. In each, ∫|xᵢ| = |∫xᵢ| if its
    /// corners are on one side of xᵢ = 0; otherwise ∫|xᵢ| ≤ √(V ∫xᵢ²) and ∫|xᵢxⱼ| ≤ √(∫xᵢ² ∫xⱼ²).
    ///
    /// # Errors
    /// [`BodyError::Parameter`] for a point that is not finite.
    pub fn of_hull(points: &[[f64; 3]], about: [f64; 3]) -> Result<Self, BodyError> {
        let hull = match ConvexHull::of(points) {
            Ok(hull) => hull,
            Err(BodyError::FlatPoints { .. } | BodyError::Empty { .. }) => return Ok(Self::default()),
            Err(error) => return Err(error),
        };
        let from = |p: [f64; 3]| core::array::from_fn(|k| p[k] - about[k]);
        let Some(apex) = hull.coordinates().first().map(|p| from(*p)) else { return Ok(Self::default()) };
        let tetrahedra =
            hull.corners().map(|[a, b, c]| Self::of_tetrahedron([apex, from(a), from(b), from(c)]));
        Ok(tetrahedra.fold(Self::default(), Self::add) * OUTWARD)
    }

    /// Returns the bounds for a volume or mass within a distance from the point.
    pub fn within(measure: f64, distance: f64) -> Self {
        let second = measure * distance * distance;
        Self { measure, first: [measure * distance; 3], second: [[second; 3]; 3] }
    }

    /// Returns the bounds about a point at `offset` from the previous one.
    #[must_use]
    pub fn about(&self, offset: [f64; 3]) -> Self {
        let (by, Self { measure, first, second }) = (offset.map(f64::abs), *self);
        Self {
            measure,
            first: core::array::from_fn(|i| first[i] + measure * by[i]),
            second: core::array::from_fn(|i| {
                core::array::from_fn(|j| {
                    second[i][j] + first[i] * by[j] + first[j] * by[i] + measure * by[i] * by[j]
                })
            }),
        }
    }

    fn of_tetrahedron(corners: [[f64; 3]; 4]) -> Self {
        let [a, b, c, d] = corners;
        let [u, v, w] = [b, c, d].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
        let across = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let measure = (across[0] * w[0] + across[1] * w[1] + across[2] * w[2]).abs() / 6.0;
        let sum: [f64; 3] = core::array::from_fn(|k| corners.iter().map(|p| p[k]).sum());
        let integral = |i: usize, j: usize| {
            let products: f64 = corners.iter().map(|p| p[i] * p[j]).sum();
            measure / 20.0 * (products + sum[i] * sum[j])
        };
        let is_one_sided: [bool; 3] = core::array::from_fn(|k| {
            corners.iter().all(|p| p[k] >= 0.0) || corners.iter().all(|p| p[k] <= 0.0)
        });
        let squares: [f64; 3] = core::array::from_fn(|k| integral(k, k));
        let first = core::array::from_fn(|k| {
            if is_one_sided[k] { measure * sum[k].abs() / 4.0 } else { (measure * squares[k]).sqrt() }
        });
        let second = core::array::from_fn(|i| {
            core::array::from_fn(|j| match i == j || is_one_sided[i] && is_one_sided[j] {
                true => integral(i, j).abs(),
                false => (squares[i] * squares[j]).sqrt(),
            })
        });
        Self { measure, first, second }
    }

    /// Returns Σ ∫ xᵢ², a bound of the norm of the change of a tensor.
    fn squared(&self) -> f64 {
        (0..3).map(|k| self.second[k][k]).sum()
    }
}

impl Add for MomentBound {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            measure: self.measure + other.measure,
            first: core::array::from_fn(|i| self.first[i] + other.first[i]),
            second: core::array::from_fn(|i| {
                core::array::from_fn(|j| self.second[i][j] + other.second[i][j])
            }),
        }
    }
}

impl Mul<f64> for MomentBound {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self {
            measure: self.measure * factor,
            first: self.first.map(|x| x * factor),
            second: self.second.map(|row| row.map(|x| x * factor)),
        }
    }
}

/// Part of a body of which some mass is uncertain.
#[derive(Clone, Copy, Debug)]
pub struct UncertainPart<F: Frame> {
    /// Mass properties with the assumed surface.
    pub properties: MassProperties<F>,
    /// Bounds of the moments of the uncertain mass about the centre of mass of the whole body, at
    /// the density of `properties`.
    pub bound: MomentBound,
    /// True if the mass is known: the density then depends on the true volume.
    pub has_mass: bool,
}

/// Error bounds of mass properties, in the body's axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MassBound {
    /// Error bound of the mass, kg.
    pub mass: f64,
    /// Error bounds of the coordinates of the centre of mass, m.
    pub center_of_mass: [f64; 3],
    /// Error bounds of the elements of the tensor about the centre of mass, kg m².
    pub inertia: [[f64; 3]; 3],
    /// Error bound of each principal moment, kg m².
    pub moments: f64,
}

impl MassBound {
    /// Returns the error bounds of a body that consists of these parts; `None` if its uncertain
    /// mass is not smaller than its mass.
    ///
    /// Let ΔM, Δfᵢ and ΔSᵢⱼ be the uncertain moments about the assumed centre of mass, and M' =
    /// M + ΔM ≥ M − |ΔM|:
    ///
    /// Δcᵢ = Δfᵢ/M',  ΔI = tr(ΔS) 1 − ΔS − M' (|Δc|² 1 − Δc Δcᵀ),  M' Δcᵢ Δcⱼ = Δfᵢ Δfⱼ/M'
    ///
    /// Principal moments in ascending order change by at most the norm of ΔI (Weyl). The norm is at
    /// most the largest sum of a row, and at most Σ|ΔSᵢᵢ| + Σ(Δfᵢ)²/M'. If a part of volume V and
    /// mass m is known by its mass, its density is m/V', so that all its moments are multiplied by
    /// s = V/V'. Then |s − 1| ≤ |ΔV|/(V − |ΔV|) and s ≤ V/(V − |ΔV|).
    pub fn of<F: Frame>(whole: &MassProperties<F>, parts: &[UncertainPart<F>]) -> Option<Self> {
        let center = whole.center_of_mass();
        let mut all = MomentBound::default();
        for part in parts {
            let MomentBound { measure, .. } = part.bound;
            if !part.has_mass {
                all = all + part.bound;
                continue;
            }
            let mass = part.properties.mass();
            let least = mass - measure;
            if !(least > 0.0) {
                return None;
            }
            let own = moments(&part.properties, center);
            all = all
                + MomentBound { measure: 0.0, ..part.bound * (mass / least) }
                + MomentBound { measure: 0.0, ..own * (measure / least) };
        }
        let least = whole.mass() - all.measure;
        if !(least > 0.0) {
            return None;
        }
        let MomentBound { measure, first, second } = all;
        let moved = |i: usize, j: usize| second[i][j] + first[i] * first[j] / least;
        let inertia: [[f64; 3]; 3] = core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                OUTWARD
                    * if i == j { (0..3).filter(|k| *k != i).map(|k| moved(k, k)).sum() } else { moved(i, j) }
            })
        });
        let rows = inertia.iter().map(|row| row.iter().sum::<f64>()).fold(0.0, f64::max);
        let whole_norm = OUTWARD * (all.squared() + first.iter().map(|f| f * f).sum::<f64>() / least);
        Some(Self {
            mass: OUTWARD * measure,
            center_of_mass: first.map(|f| OUTWARD * f / least),
            inertia,
            moments: rows.min(whole_norm),
        })
    }
}

/// Returns the absolute moments of a body about a point: its mass, |m cᵢ|, and |Sᵢⱼ| with
/// S = ½ tr(I) 1 − I.
fn moments<F: Frame>(body: &MassProperties<F>, about: Position<F>) -> MomentBound {
    let from = (body.center_of_mass() - about).to_array();
    let tensor = body.inertia_about(about).matrix();
    let half: f64 = 0.5 * (0..3).map(|k| tensor[k][k]).sum::<f64>();
    MomentBound {
        measure: body.mass(),
        first: from.map(|c| (body.mass() * c).abs()),
        second: core::array::from_fn(|i| {
            core::array::from_fn(|j| (if i == j { half - tensor[i][i] } else { -tensor[i][j] }).abs())
        }),
    }
}
