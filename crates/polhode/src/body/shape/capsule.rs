//! Capsule shape.

use super::cylinder::Cylinder;
use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;
use crate::math::number::PI;
use crate::math::vector::Position;

/// Solid cylinder between two half balls, with its centre at the origin and its axis along z.
///
/// I_zz = (M_cylinder/2 + 2/5 M_caps) r²,
/// I_xx = M_cylinder (r²/4 + l²/12) + M_caps (2/5 r² + 3/8 l r + l²/4)
///
/// ```
/// use polhode::body::shape::{Capsule, Shape, Substance};
/// let pill = Capsule::new(0.5, 2.0)?;
/// assert!((pill.spread().extent().measure() - std::f64::consts::PI * (0.5 + 1.0 / 6.0)).abs() < 1e-15);
/// // caps weigh a quarter of it
/// let pill = pill.mass_properties(Substance::Mass(1.0))?;
/// assert!((pill.inertia().matrix()[2][2] - (0.75 / 2.0 + 0.4 * 0.25) * 0.25).abs() < 1e-16);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule {
    pub(in crate::body) radius: f64,
    pub(in crate::body) length: f64,
}

impl Capsule {
    /// Returns a capsule with the given radius and the length of its cylinder without the caps, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the radius or the length is not positive and finite.
    pub fn new(radius: f64, length: f64) -> Result<Self, BodyError> {
        representable(Self {
            radius: positive("the capsule's radius", radius)?,
            length: positive("the capsule's length", length)?,
        })
    }
}

impl Shape for Capsule {
    fn spread(&self) -> Spread {
        let Self { radius, length } = *self;
        let r2 = radius * radius;
        // A half ball has its centroid 3/8 r above its base: ⟨z²⟩ = r²/5 − (3r/8)² = 19/320 r².
        let half_ball = Spread::centered(
            Extent::Volume(2.0 / 3.0 * PI * r2 * radius),
            [r2 / 5.0, r2 / 5.0, r2 * 19.0 / 320.0],
        );
        let cap =
            |side: f64| half_ball.moved(Position::new(0.0, 0.0, side * (0.5 * length + 0.375 * radius)));
        Cylinder { radius, inner_radius: 0.0, length }.spread().joined(&[cap(-1.0), cap(1.0)])
    }

    fn surface_area(&self) -> f64 {
        2.0 * PI * self.radius * (2.0 * self.radius + self.length)
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Capsule { radius: self.radius, length: self.length })
    }
}
