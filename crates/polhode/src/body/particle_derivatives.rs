//! Derivatives of the mass properties of particles with respect to each of them.

use super::derivative::MassPropertiesDerivative;
use super::error::BodyError;
use super::mass_properties::Center;
use super::particles::Particle;
use crate::math::frame::Frame;
use crate::math::vector::Position;

/// Derivatives of the mass properties of particles with respect to one of them: with d from the
/// centre of mass to it,
///
/// ∂M = ∂m,  ∂c = (d ∂m + m ∂r)/M,  ∂I = (d² 1 − d dᵀ) ∂m + m (2 d·∂r 1 − d ∂rᵀ − ∂r dᵀ)
///
/// ```
/// use polhode::body::{Particle, ParticleDerivatives};
/// use polhode::math::{Body, Position};
/// // A dumbbell along z: I_xx = μ l², with the reduced mass μ = 3/4 kg and l = 2 m.
/// let particles = [Particle::<Body>::new(1.0, Position::ZERO)?, Particle::new(3.0, Position::new(0.0, 0.0, 2.0))?];
/// let derivatives = ParticleDerivatives::of(&particles)?;
/// let [_, _, by_z] = derivatives[1].by_position;
/// assert_eq!(by_z.inertia[0], 2.0 * 0.75 * 2.0);
/// assert_eq!(derivatives[1].by_mass.inertia[0], 0.5 * 0.5);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParticleDerivatives<F> {
    /// Derivative with respect to its mass, per kg.
    pub by_mass: MassPropertiesDerivative<F>,
    /// Derivatives with respect to its coordinates, per m.
    pub by_position: [MassPropertiesDerivative<F>; 3],
}

impl<F: Frame> ParticleDerivatives<F> {
    /// Returns the derivatives with respect to each particle of
    /// [`mass_properties_of_particles`](super::mass_properties_of_particles), in their order.
    ///
    /// # Errors
    /// [`BodyError::Empty`] if `particles` is empty.
    pub fn of(particles: &[Particle<F>]) -> Result<Vec<Self>, BodyError> {
        let points: Vec<_> = particles.iter().map(|p| (p.mass(), p.position())).collect();
        let Center { mass: whole, reference, rest } =
            Center::of(&points).ok_or(BodyError::Empty { what: "particles" })?;
        let heavier =
            MassPropertiesDerivative { mass: 1.0, center_of_mass: Position::ZERO, inertia: [0.0; 6] };
        let moved = MassPropertiesDerivative::by_translation();
        let of = |&(mass, position): &(f64, Position<F>)| {
            let lever = (position - reference) - rest;
            Self {
                by_mass: heavier.of_sum(mass, lever, whole),
                by_position: moved.map(|change| change.of_sum(mass, lever, whole)),
            }
        };
        Ok(points.iter().map(of).collect())
    }
}
