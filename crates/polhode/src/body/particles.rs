//! Point particles and their mass properties.

use super::error::{BodyError, finite, positive};
use super::mass_properties::{Center, MassProperties};
use crate::math::frame::Frame;
use crate::math::sum::Sum;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Position;

/// Particle: a mass, kg, at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle<F> {
    mass: f64,
    position: Position<F>,
}

impl<F: Frame> Particle<F> {
    /// Returns a particle of positive mass at a finite position, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the mass is not positive and finite, or the position is not
    /// finite.
    pub fn new(mass: f64, position: Position<F>) -> Result<Self, BodyError> {
        positive("the particle's mass", mass)?;
        finite("the particle's position", position.to_array())?;
        Ok(Self { mass, position })
    }

    /// Returns the mass, kg.
    pub const fn mass(&self) -> f64 {
        self.mass
    }

    /// Returns the position, m.
    pub const fn position(&self) -> Position<F> {
        self.position
    }
}

/// Computes the mass properties of rigidly joined particles.
///
/// M = Σ m_α,  M c = Σ m_α r_α,  I_ij = Σ m_α [δ_ij Σ_k x²_{α,k} − x_{α,i} x_{α,j}],  x_α = r_α − c
///
/// ```
/// use polhode::body::{Particle, mass_properties_of_particles};
/// use polhode::math::{Body, Position};
/// let particles = [
///     Particle::<Body>::new(3.0, Position::new(1.0, 0.0, 1.0))?,
///     Particle::new(4.0, Position::new(1.0, 1.0, -1.0))?,
///     Particle::new(2.0, Position::new(-1.0, 1.0, 0.0))?,
/// ];
/// let body = mass_properties_of_particles(&particles)?;
/// // Thornton & Marion, problem 11-13
/// let about_origin = body.inertia_about(Position::ZERO).matrix();
/// let expected = [[13.0, -2.0, 1.0], [-2.0, 16.0, 4.0], [1.0, 4.0, 15.0]];
/// for (row, want) in about_origin.iter().flatten().zip(expected.iter().flatten()) {
///     assert!((row - want).abs() < 1e-14);
/// }
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
///
/// # Errors
/// [`BodyError::Empty`] if `particles` is empty; [`BodyError::Parameter`] if a sum is not finite.
///
/// Source: the lecture notes, "The inertia tensor".
pub fn mass_properties_of_particles<F: Frame>(
    particles: &[Particle<F>],
) -> Result<MassProperties<F>, BodyError> {
    let points: Vec<_> = particles.iter().map(|p| (p.mass, p.position)).collect();
    let Center { mass, reference, rest } =
        Center::of(&points).ok_or(BodyError::Empty { what: "particles" })?;
    let mut second = [Sum::default(); 6];
    for p in particles {
        let x = (p.position - reference) - rest;
        for (sum, element) in second.iter_mut().zip(Symmetric3::outer(x.to_array()).elements()) {
            sum.add(p.mass * element);
        }
    }
    let [xx, yy, zz, xy, xz, yz] = second.map(|s| s.value() / mass);
    let covariance = Symmetric3 { xx, yy, zz, xy, xz, yz };
    MassProperties::from_covariance(mass, reference + rest, &covariance)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::frame::Body;

    #[test]
    fn particles_far_from_the_origin_lose_nothing() {
        let shape = [(1.5, [0.5, -1.0, 0.25]), (2.0, [-0.75, 0.5, 2.0]), (0.5, [1.0, 1.5, -0.5])];
        let at = |origin: [f64; 3]| {
            let particles = shape.map(|(m, p)| {
                Particle::<Body>::new(m, Position::from_array(p) + Position::from_array(origin)).unwrap()
            });
            mass_properties_of_particles(&particles).unwrap()
        };
        let near = at([0.0; 3]);
        let far = at([1e9, -3e9, 2e9]); // still exact coordinates
        assert!((*near.inertia().symmetric() - *far.inertia().symmetric()).max_abs() < 4e-15);
    }

    #[test]
    fn a_massless_or_missing_particle_is_refused() {
        assert!(Particle::<Body>::new(0.0, Position::ZERO).is_err());
        assert!(Particle::<Body>::new(f64::INFINITY, Position::ZERO).is_err());
        assert!(Particle::<Body>::new(1.0, Position::new(0.0, f64::NAN, 0.0)).is_err());
        assert!(matches!(mass_properties_of_particles::<Body>(&[]), Err(BodyError::Empty { .. })));
    }
}
