//! Sphere, solid or hollow.

use super::{Extent, Shape, Spread, hollow, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;
use crate::math::number::PI;

/// Sphere with its centre at the origin, solid or with a concentric spherical cavity.
///
/// I = 2/5 M (R⁵ − r⁵)/(R³ − r³) for the outer radius R and the inner radius r, which is zero if
/// solid
///
/// ```
/// use polhode::body::shape::{Shape, Sphere, Substance};
/// let ball = Sphere::new(0.5)?.mass_properties(Substance::Mass(4.0))?;
/// assert!((ball.inertia().matrix()[0][0] - 0.4).abs() < 1e-16);
/// let shell = Sphere::hollow(2.0, 1.0)?.mass_properties(Substance::Mass(7.0))?;
/// assert!((shell.inertia().matrix()[0][0] - 0.4 * 31.0).abs() < 1e-14);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    pub(in crate::body) radius: f64,
    /// Radius of the cavity, m; zero if solid.
    pub(in crate::body) inner_radius: f64,
}

impl Sphere {
    /// Returns a solid sphere with the given radius, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the radius is not positive and finite.
    pub fn new(radius: f64) -> Result<Self, BodyError> {
        Self::hollow(radius, 0.0)
    }

    /// Returns a sphere with the given outer radius and radius of its cavity, m; without a cavity
    /// if `inner_radius` is zero.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the radius is not positive and finite, or unless
    /// 0 ≤ `inner_radius` < `radius`.
    pub fn hollow(radius: f64, inner_radius: f64) -> Result<Self, BodyError> {
        positive("the sphere's radius", radius)?;
        let inner_radius = hollow("the sphere's inner radius", inner_radius, radius)?;
        representable(Self { radius, inner_radius })
    }
}

impl Shape for Sphere {
    /// Computes, with the ratio of the radii k = r/R: V = 4π/3 (R³ − r³) = 4π/3 R² (R − r)
    /// (1 + k + k²),
    ///
    /// ⟨x²⟩ = (R⁵ − r⁵)/5(R³ − r³) = R²/5 (1 + k + k² + k³ + k⁴)/(1 + k + k²)
    ///
    /// The differences of powers are divided out, so that a thin wall keeps its digits.
    fn spread(&self) -> Spread {
        let Self { radius, inner_radius: inner } = *self;
        let k = inner / radius;
        let cubes = 1.0 + k * (1.0 + k);
        let fifths = cubes + k * k * k * (1.0 + k);
        let volume = 4.0 / 3.0 * PI * radius * radius * (radius - inner) * cubes;
        Spread::centered(Extent::Volume(volume), [radius * radius / 5.0 * (fifths / cubes); 3])
    }

    /// Returns A = 4π (R² + r²), inside and outside.
    fn surface_area(&self) -> f64 {
        let Self { radius, inner_radius: inner } = *self;
        4.0 * PI * radius * radius + 4.0 * PI * inner * inner
    }

    fn form(&self) -> Option<Form> {
        let Self { radius, inner_radius } = *self;
        Some(match inner_radius {
            0.0 => Form::Ellipsoid { semi_axes: [radius; 3] },
            _ => Form::HollowSphere { radius, inner_radius },
        })
    }
}
