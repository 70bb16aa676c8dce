//! Small oscillations about an equilibrium: frequencies, damping and mode shapes.

mod mode;
mod on_orbit;
mod shapes;
mod steady;
mod steady_top;

pub use mode::OscillationMode;
pub use on_orbit::OrbitalEquilibrium;
pub use steady_top::SteadyTop;

use crate::math::complex::Complex;
use crate::math::eigenvalues::{Matrix, eigenvalues};
use crate::motion::error::MotionError;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;
use steady::Steady;

/// Small oscillations of a body near an equilibrium under its torques: frequencies, damping and
/// mode shapes.
///
/// The equilibrium is a steady motion: rest, or rotation at constant ω about an axis fixed in space
/// and in the body, under a torque that is constant in the body. Examples are a hanging body, a
/// sleeping top, and a satellite that keeps its face to the Earth on a circular orbit. With the
/// small rotation δθ away from it along body axes, the change δω of ω, and L = I ω + h,
///
/// δθ̇ = δω + δθ × ω,  I δω̇ = I δω × ω + L × δω + ∂N/∂θ δθ + ∂N/∂ω δω
///
/// The six eigenvalues of these equations are computed. An energy sink adds α (I δω × ω + L × δω)
/// to δθ̇, and L × this term to I δω̇. The derivatives of N are those of [`TorqueModel::jacobian`].
///
/// ```
/// use polhode::prelude::*;
/// use polhode::observe::SmallOscillations;
/// // A stick of 1.2 m and 0.8 kg hangs by its end.
/// let stick = MassProperties::new(0.8, Position::ZERO, InertiaTensor::diagonal([0.096, 0.096, 1e-4])?)?;
/// let body = Rotor::pivoted(&stick, Position::new(0.0, 0.0, 0.6));
/// let rest = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };
/// let gravity = [TorqueModel::Gravity(UniformGravity::STANDARD)];
/// let swings = SmallOscillations::about_equilibrium(&body, &gravity, rest)?;
/// let expected = (9.80665 * 0.6 / (0.096 / 0.8 + 0.36_f64)).sqrt(); // √(M g l / I)
/// assert!(swings.modes.iter().all(|mode| (mode.frequency / expected - 1.0).abs() < 1e-9));
/// assert_eq!((swings.modes.len(), swings.neutral), (2, 2)); // two ways to swing; turning about the vertical costs nothing
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SmallOscillations {
    /// Equilibrium state.
    pub equilibrium: State,
    /// Modes, those with the largest growth rate first, then by frequency. Modes of equal frequency
    /// form a basis; `multiplicity` is their number.
    pub modes: Vec<OscillationMode>,
    /// Number of zero eigenvalues out of six: changes of the equilibrium's orientation or rotation
    /// that cause no torque.
    pub neutral: usize,
}

/// Threshold below which an eigenvalue, relative to the fastest rate of the equations, counts as
/// zero. It is the square root of the largest difference error, which is the error of a defective
/// pair.
const NEUTRAL: f64 = 1e-6;

impl SmallOscillations {
    /// Computes the oscillations about an equilibrium.
    ///
    /// # Errors
    /// [`MotionError::NotSteady`] if the state is not an equilibrium: the unbalanced torque exceeds
    /// 1e-8 of the torques' size, or the torques change in time along the motion.
    /// [`MotionError::NoDerivative`] where a torque has a corner or a jump. A parameter error
    /// ([`MotionError::is_parameter`]) for a rod, whose spin about its own line is undetermined.
    /// [`MotionError::NotFinite`] if a torque near the state is not finite.
    pub fn about_equilibrium(
        rotor: &Rotor,
        torques: &[TorqueModel],
        equilibrium: State,
    ) -> Result<Self, MotionError> {
        Self::of(&Steady::new(rotor, torques, equilibrium)?)
    }

    /// Finds an equilibrium by Newton's method from a state, with the same ω in space: the nearest
    /// one if the state is close to it. It may be unstable, like an inverted pendulum.
    ///
    /// # Errors
    /// The errors of [`SmallOscillations::about_equilibrium`], if no equilibrium is found.
    pub fn equilibrium_near(
        rotor: &Rotor,
        torques: &[TorqueModel],
        state: State,
    ) -> Result<State, MotionError> {
        Steady::near(rotor, torques, state)
    }

    fn of(steady: &Steady<'_>) -> Result<Self, MotionError> {
        let equilibrium = steady.state();
        let Some((matrix, rate)) = steady.linearised()? else {
            return Ok(Self { equilibrium, modes: Vec::new(), neutral: 6 });
        };
        let values = eigenvalues(&matrix).ok_or(MotionError::NotFinite { time: equilibrium.time })?;
        let mut modes = modes(&matrix, &values, rate);
        modes.sort_by(|a, b| {
            // Rates that differ by rounding count as equal.
            let growth = |mode: &OscillationMode| (mode.growth_rate / (NEUTRAL * rate)).round();
            growth(b).total_cmp(&growth(a)).then(a.frequency.total_cmp(&b.frequency))
        });
        let neutral = values.iter().filter(|value| value.abs() < NEUTRAL).count();
        Ok(Self { equilibrium, modes, neutral })
    }

    /// Returns true if no mode grows.
    pub fn is_stable(&self) -> bool {
        self.modes.iter().all(|mode| !mode.is_growing())
    }
}

/// Returns one mode for each pair of complex eigenvalues and for each nonzero real eigenvalue;
/// equal eigenvalues are grouped.
fn modes(matrix: &Matrix<6>, values: &[Complex<f64>; 6], rate: f64) -> Vec<OscillationMode> {
    let moving = |value: &&Complex<f64>| value.im >= 0.0 && value.abs() >= NEUTRAL;
    let mut roots: Vec<Vec<Complex<f64>>> = Vec::new();
    for value in values.iter().filter(moving) {
        match roots.iter_mut().find(|group| group.iter().any(|root| root.minus(*value).abs() < NEUTRAL)) {
            Some(group) => group.push(*value),
            None => roots.push(vec![*value]),
        }
    }
    let of_roots = |group: &Vec<Complex<f64>>| {
        let mean = group.iter().fold(Complex { re: 0.0, im: 0.0 }, |sum, root| sum.plus(*root));
        let mean = mean.scaled(1.0 / group.len() as f64);
        // A real part that is only rounding counts as zero.
        let growth = if mean.re.abs() < NEUTRAL { 0.0 } else { mean.re };
        shapes::modes(matrix, group, [growth * rate, mean.im * rate])
    };
    roots.iter().flat_map(of_roots).collect()
}

#[cfg(test)]
mod tests;
