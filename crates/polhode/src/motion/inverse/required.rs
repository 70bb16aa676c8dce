//! Torques and forces that a motion requires.

use super::prescribed::Prescribed;
use crate::body::particles::Particle;
use crate::math::frame::{Body, Space};
use crate::math::vector::{
    AngularAcceleration, AngularMomentum, AngularVelocity, Direction, Force, Position, Torque,
};
use crate::motion::error::MotionError;
use crate::motion::model::kinematics::rigid_acceleration;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::wheel::Wheel;

/// Torque and related quantities that a motion requires at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Required {
    /// State of the motion: attitude and ω.
    pub state: State,
    /// Angular acceleration dω/dt, body axes, rad/s².
    pub acceleration: AngularAcceleration<Body>,
    /// Torque N = I ω̇ + ω × L about the rotor's reference point, body axes, N·m. L = I ω + h, with
    /// h the angular momentum of the wheels.
    pub torque: Torque<Body>,
    /// Power N · ω, W.
    pub power: f64,
    /// Kinetic energy `T_rot` about that point, J.
    pub kinetic_energy: f64,
    /// Angular momentum L about that point, space axes, kg·m²/s.
    pub momentum: AngularMomentum<Space>,
}

/// Force that one particle requires to follow a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParticleForce {
    /// Force F = m a, body axes, N.
    pub force: Force<Body>,
    /// Component of F along r, which has no torque: tension (against r) or compression (along r) of
    /// a massless rod.
    pub along: Force<Body>,
    /// Component of F normal to r, which has the whole torque.
    pub across: Force<Body>,
    /// Torque r × F about the rotor's reference point, body axes, N·m.
    pub torque: Torque<Body>,
}

impl Required {
    /// Computes the torque that a prescribed motion requires at a time.
    ///
    /// ```
    /// use polhode::prelude::*;
    /// use polhode::motion::{Prescribed, Required};
    /// // Thornton & Marion, example 11.10: a dumbbell turned about an axis tilted by α from its rod
    /// let (m1, m2, b, omega, alpha) = (1.2, 0.7, 0.5, 3.0, 0.6_f64);
    /// let masses = [
    ///     Particle::new(m1, Position::new(0.0, 0.0, b))?,
    ///     Particle::new(m2, Position::new(0.0, 0.0, -b))?,
    /// ];
    /// let dumbbell = Rotor::pivoted(&mass_properties_of_particles(&masses)?, Position::ZERO);
    /// let axis = Direction::new(0.0, alpha.sin(), alpha.cos());
    /// let motion = Prescribed::fixed_axis(Attitude::identity(), axis, omega, 0.0)?;
    /// let needed = Required::of_motion(&dumbbell, &motion, 0.0)?;
    /// let expected = -(m1 + m2) * b * b * omega * omega * alpha.sin() * alpha.cos();
    /// assert!((needed.torque - Torque::new(expected, 0.0, 0.0)).norm() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`Prescribed::at`]. A parameter's error ([`MotionError::is_parameter`]) if a
    /// motor turns a wheel, as part of the work is then done by the motor.
    /// [`MotionError::NotFinite`] if torque, power, energy or momentum exceeds the range of f64.
    pub fn of_motion(rotor: &Rotor, motion: &Prescribed, time: f64) -> Result<Self, MotionError> {
        let (motor, is_driven) =
            (rotor.motor_torque(time).norm(), rotor.wheels().iter().any(Wheel::is_driven));
        require::that(
            "the motor's torque on a wheel",
            motor,
            !is_driven,
            "zero where a motion is prescribed",
        )?;
        let (state, acceleration) = motion.at(time)?;
        let torque = rotor.torque_for(state.omega, acceleration, time);
        let needed = Self {
            state,
            acceleration,
            torque,
            power: torque.dot(state.omega),
            kinetic_energy: rotor.kinetic_energy(state.omega),
            momentum: rotor.angular_momentum_space(&state),
        };
        let finite = torque.is_finite()
            && needed.power.is_finite()
            && needed.kinetic_energy.is_finite()
            && needed.momentum.is_finite();
        if finite { Ok(needed) } else { Err(MotionError::NotFinite { time }) }
    }

    /// Returns N in space axes, N·m.
    pub fn torque_space(&self) -> Torque<Space> {
        self.state.attitude * self.torque
    }

    /// Returns the work of the torque since an earlier time of the same motion,
    /// ∫ N · ω dt = T − T₀, J.
    pub fn work_since(&self, earlier: &Self) -> f64 {
        self.kinetic_energy - earlier.kinetic_energy
    }

    /// Returns the angular impulse of the torque since an earlier time of the same motion,
    /// ∫ N dt = L − L₀, space axes, N·m·s.
    pub fn impulse_since(&self, earlier: &Self) -> AngularMomentum<Space> {
        self.momentum - earlier.momentum
    }

    /// Returns the force that a particle of the body, or one fixed to it, requires to follow the
    /// motion.
    pub fn force_on(&self, particle: &Particle<Body>, rotor: &Rotor) -> ParticleForce {
        ParticleForce::of(particle, rotor.point(), self.state.omega, self.acceleration)
    }
}

impl ParticleForce {
    /// Returns the force on one particle of a body that turns about `point`:
    /// F = m [ω̇ × r + ω × (ω × r)], with r from the point.
    ///
    /// The sum of r × F over all particles is the torque that the motion requires. The motion does
    /// not determine the distribution of *external* forces: in a rigid body, any set with the same
    /// sum and the same torque has the same effect.
    pub fn of(
        particle: &Particle<Body>,
        point: Position<Body>,
        omega: AngularVelocity<Body>,
        acceleration: AngularAcceleration<Body>,
    ) -> Self {
        let r = particle.position() - point;
        let force: Force<Body> = (rigid_acceleration(omega, acceleration, r) * particle.mass()).as_quantity();
        let unit = r.direction().unwrap_or(Direction::ZERO);
        let along: Force<Body> = unit.as_quantity() * unit.dot(force);
        Self { force, along, across: force - along, torque: r.cross(force) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::mass_properties_of_particles;
    use crate::math::rotation::Attitude;

    #[test]
    fn the_forces_on_the_particles_make_the_torque_that_euler_asks_for() {
        let particles = [
            (1.5, [0.5, -1.0, 0.25]),
            (2.0, [-0.75, 0.5, 2.0]),
            (0.5, [1.0, 1.5, -0.5]),
            (0.9, [0.1, 0.2, 0.3]),
        ]
        .map(|(m, p)| Particle::new(m, Position::from_array(p)).unwrap());
        let pivot = Position::new(0.2, -0.4, 0.6);
        let rotor = Rotor::pivoted(&mass_properties_of_particles(&particles).unwrap(), pivot);
        let motion = Prescribed::euler_rates([0.4, 0.9, -1.2], [0.7, -0.3, 2.1]).unwrap();
        let needed = Required::of_motion(&rotor, &motion, 0.8).unwrap();
        let forces = particles.map(|p| ParticleForce::of(&p, pivot, needed.state.omega, needed.acceleration));
        let sum = forces.iter().fold(Torque::ZERO, |sum, f| sum + f.torque);
        assert!((sum - needed.torque).norm() < 1e-13 * needed.torque.norm());
        for (f, p) in forces.iter().zip(particles) {
            assert!((f.along + f.across - f.force).norm() < 1e-14);
            assert!((p.position() - pivot).cross(f.along).norm() < 1e-13);
        }
        // The power equals the rate of the kinetic energy.
        let h = 1e-5;
        let energy = |t: f64| rotor.kinetic_energy(motion.at(t).unwrap().0.omega);
        assert!(((energy(0.8 + h) - energy(0.8 - h)) / (2.0 * h) - needed.power).abs() < 1e-8);
    }

    #[test]
    fn no_torque_is_needed_about_a_principal_axis() {
        let particles = [(1.0, [1.0, 0.0, 0.0]), (2.0, [0.0, 1.5, 0.0]), (1.5, [-0.5, -2.0, 0.0])]
            .map(|(m, p)| Particle::new(m, Position::from_array(p)).unwrap());
        let rotor = Rotor::free(&mass_properties_of_particles(&particles).unwrap());
        let axis: Direction<Body> = rotor.principal().axis(2);
        let motion = Prescribed::fixed_axis(Attitude::identity(), axis, 5.0, 0.0).unwrap();
        assert!(Required::of_motion(&rotor, &motion, 1.0).unwrap().torque.norm() < 1e-14);
        let spin_up = Prescribed::fixed_axis(Attitude::identity(), axis, 5.0, 0.3).unwrap();
        let i3 = rotor.principal().moments()[2];
        let expected: Torque<Body> = axis.as_quantity() * (0.3 * i3);
        assert!((Required::of_motion(&rotor, &spin_up, 1.0).unwrap().torque - expected).norm() < 1e-13);
    }
}
