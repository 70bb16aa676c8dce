//! Kinematics of particles: velocities in a rigid body, and decomposition of the kinetic energy.

use crate::body::particles::Particle;
use crate::math::frame::Frame;
use crate::math::vector::{
    Acceleration, AngularAcceleration, AngularMomentum, AngularVelocity, Momentum, Position, Velocity,
};

/// Returns the velocity of a point of a rigid body: v = V + ω × r.
///
/// V is the velocity of the body's origin, and r is the vector from the origin to the point. All
/// vectors have the same axes.
///
/// Source: lecture notes, "The inertia tensor"; Thornton & Marion, eq. (10.17), as cited there.
pub fn rigid_velocity<F>(
    origin_velocity: Velocity<F>,
    omega: AngularVelocity<F>,
    r: Position<F>,
) -> Velocity<F> {
    origin_velocity + omega.cross(r)
}

/// Returns the acceleration of a point of a rigid body whose origin moves uniformly:
/// a = ω̇ × r + ω × (ω × r).
pub fn rigid_acceleration<F>(
    omega: AngularVelocity<F>,
    angular_acceleration: AngularAcceleration<F>,
    r: Position<F>,
) -> Acceleration<F> {
    angular_acceleration.cross(r) + omega.cross(omega.cross(r))
}

/// Particle with a velocity, along the axes of `F`. A set of them need not be a rigid body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MovingParticle<F> {
    /// Mass and position.
    pub particle: Particle<F>,
    /// Velocity, m/s.
    pub velocity: Velocity<F>,
}

/// Decomposition of the kinetic energy of particles about an origin that moves with velocity V.
/// Positions r and velocities v are relative to the origin.
///
/// T = ½ M V² + V · Σ m v + ½ Σ m v²
///
/// About the centre of mass Σ m v = 0, the cross term vanishes, and T = `T_trans` + `T_rot`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KineticEnergySplit {
    /// ½ M V², J.
    pub translation: f64,
    /// V · Σ m v, J; zero about the centre of mass.
    pub cross: f64,
    /// ½ Σ m v², J. For a rigid body with angular velocity ω, v = ω × r, and this is
    /// `T_rot` = ½ ω · I ω.
    pub rotation: f64,
}

impl KineticEnergySplit {
    /// Decomposes the kinetic energy of `particles` about an origin that moves at
    /// `origin_velocity`.
    ///
    /// Source: lecture notes, "The inertia tensor".
    pub fn of<F: Frame>(particles: &[MovingParticle<F>], origin_velocity: Velocity<F>) -> Self {
        let mut split = Self { translation: 0.0, cross: 0.0, rotation: 0.0 };
        for p in particles {
            let m = p.particle.mass();
            let v = p.velocity - origin_velocity;
            split.translation += 0.5 * m * origin_velocity.dot(origin_velocity);
            split.cross += m * origin_velocity.dot(v);
            split.rotation += 0.5 * m * v.dot(v);
        }
        split
    }

    /// Returns the total kinetic energy T, J, which does not depend on the origin.
    pub const fn total(&self) -> f64 {
        self.translation + self.cross + self.rotation
    }
}

/// Returns the linear momentum Σ m v, kg·m/s.
pub fn momentum<F: Frame>(particles: &[MovingParticle<F>]) -> Momentum<F> {
    particles
        .iter()
        .map(|p| (p.velocity * p.particle.mass()).as_quantity())
        .fold(Momentum::ZERO, |sum, p| sum + p)
}

/// Returns the angular momentum Σ m (r − r₀) × (v − v₀), kg·m²/s, about a point r₀ that moves at
/// `point_velocity` v₀.
///
/// Source: lecture notes, "Angular Momentum".
pub fn angular_momentum<F: Frame>(
    particles: &[MovingParticle<F>],
    point: Position<F>,
    point_velocity: Velocity<F>,
) -> AngularMomentum<F> {
    particles
        .iter()
        .map(|p| {
            let momentum: Momentum<F> = ((p.velocity - point_velocity) * p.particle.mass()).as_quantity();
            (p.particle.position() - point).cross(momentum)
        })
        .fold(AngularMomentum::ZERO, |sum, l| sum + l)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::mass_properties_of_particles;
    use crate::math::Body;

    fn cloud() -> Vec<Particle<Body>> {
        [(1.5, [0.5, -1.0, 0.25]), (2.0, [-0.75, 0.5, 2.0]), (0.5, [1.0, 1.5, -0.5]), (0.9, [0.1, 0.2, 0.3])]
            .map(|(m, p)| Particle::new(m, Position::from_array(p)).unwrap())
            .to_vec()
    }

    #[test]
    fn the_cross_term_vanishes_about_the_centre_of_mass_and_only_there() {
        let body = mass_properties_of_particles(&cloud()).unwrap();
        let omega = AngularVelocity::new(0.7, -1.1, 0.4);
        let v_center = Velocity::new(3.0, -2.0, 0.5);
        let moving: Vec<_> = cloud()
            .into_iter()
            .map(|particle| {
                let r = particle.position() - body.center_of_mass();
                MovingParticle { particle, velocity: rigid_velocity(v_center, omega, r) }
            })
            .collect();
        let split = KineticEnergySplit::of(&moving, v_center);
        assert!(split.cross.abs() < 1e-14);
        assert!((split.translation - 0.5 * body.mass() * v_center.dot(v_center)).abs() < 1e-13);
        // `T_rot` = ½ ω · I ω
        let by_tensor = 0.5 * omega.dot(*body.inertia() * omega);
        assert!((split.rotation - by_tensor).abs() < 1e-14);
        // Another origin of the same body: the same total, a nonzero cross term.
        let elsewhere = rigid_velocity(v_center, omega, Position::new(0.3, -0.2, 0.9));
        let other = KineticEnergySplit::of(&moving, elsewhere);
        assert!((other.total() - split.total()).abs() < 1e-13);
        assert!(other.cross.abs() > 0.1);
        // L = I ω about the centre of mass
        let l = angular_momentum(&moving, body.center_of_mass(), v_center);
        assert!((l - *body.inertia() * omega).norm() < 1e-14);
    }

    #[test]
    fn acceleration_is_the_rate_of_velocity() {
        // ω(t) = ω0 + α t in space axes; r is fixed in the body: r(h) = r + (ω × r) h + O(h²)
        let omega = AngularVelocity::<Body>::new(0.7, -1.1, 0.4);
        let alpha = AngularAcceleration::<Body>::new(-0.3, 0.2, 0.9);
        let r = Position::new(0.5, 0.8, -1.2);
        let h = 1e-6;
        let at = |h: f64| {
            let moved = r + (omega.cross(r) * h).as_quantity();
            rigid_velocity(Velocity::ZERO, omega + (alpha * h).as_quantity(), moved)
        };
        let rate: Acceleration<Body> = ((at(h) - at(-h)) / (2.0 * h)).as_quantity();
        assert!((rate - rigid_acceleration(omega, alpha, r)).norm() < 1e-9);
    }
}
