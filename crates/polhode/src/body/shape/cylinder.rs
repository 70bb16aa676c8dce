//! Cylinder, solid or hollow.

use super::{Extent, Shape, Spread, hollow, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;
use crate::math::number::PI;

/// Cylinder with its centre at the origin and its axis along z, solid or with a coaxial bore.
///
/// I = M diag((R² + r²)/4 + l²/12, (R² + r²)/4 + l²/12, (R² + r²)/2) for the outer radius R and the
/// inner radius r, which is zero if solid
///
/// ```
/// use polhode::body::shape::{Cylinder, Shape, Substance};
/// let wheel = Cylinder::new(0.5, 0.1)?.mass_properties(Substance::Mass(8.0))?;
/// assert!((wheel.inertia().matrix()[2][2] - 1.0).abs() < 1e-15);
/// let tube = Cylinder::hollow(0.5, 0.4, 0.1)?.mass_properties(Substance::Mass(8.0))?;
/// assert!((tube.inertia().matrix()[2][2] - 4.0 * (0.25 + 0.16)).abs() < 1e-15);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    pub(in crate::body) radius: f64,
    /// Radius of the bore, m; zero if solid.
    pub(in crate::body) inner_radius: f64,
    pub(in crate::body) length: f64,
}

impl Cylinder {
    /// Returns a solid cylinder with the given radius and length, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the radius or the length is not positive and finite.
    pub fn new(radius: f64, length: f64) -> Result<Self, BodyError> {
        Self::hollow(radius, 0.0, length)
    }

    /// Returns a cylinder with the given outer radius, radius of its bore, and length, m; without a
    /// bore if `inner_radius` is zero.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the radius or the length is not positive and finite, or unless
    /// 0 ≤ `inner_radius` < `radius`.
    pub fn hollow(radius: f64, inner_radius: f64, length: f64) -> Result<Self, BodyError> {
        positive("the cylinder's radius", radius)?;
        representable(Self {
            radius,
            inner_radius: hollow("the cylinder's inner radius", inner_radius, radius)?,
            length: positive("the cylinder's length", length)?,
        })
    }
}

impl Shape for Cylinder {
    /// Computes V = π (R − r) (R + r) l and ⟨x²⟩ = (R⁴ − r⁴)/4(R² − r²) = (R² + r²)/4.
    ///
    /// The differences of powers are divided out, so that a thin wall keeps its digits.
    fn spread(&self) -> Spread {
        let Self { radius, inner_radius: inner, length } = *self;
        let across = (radius * radius + inner * inner) / 4.0;
        let volume = PI * (radius - inner) * (radius + inner) * length;
        Spread::centered(Extent::Volume(volume), [across, across, length * length / 12.0])
    }

    /// Returns A = 2π (R + r) l + 2π (R² − r²), inside and outside.
    fn surface_area(&self) -> f64 {
        let Self { radius, inner_radius: inner, length } = *self;
        2.0 * PI * (radius + inner) * (radius - inner + length)
    }

    fn form(&self) -> Option<Form> {
        let Self { radius, inner_radius, length } = *self;
        Some(Form::Cylinder { radius, inner_radius, length })
    }
}
