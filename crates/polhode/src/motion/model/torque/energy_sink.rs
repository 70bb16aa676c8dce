//! Energy dissipation inside a body: L is conserved, T is not.

use super::model::Model;
use crate::math::vector::Direction;
use crate::motion::error::MotionError;
use crate::motion::model::law::{Law, LawInput};
use crate::motion::model::require;

/// Energy dissipation inside a body that flexes, sloshes or carries a damper: an *energy sink*. It
/// cannot change the angular momentum.
///
/// The motion of the damper is not modelled, only its loss of energy at constant angular momentum.
/// With ω defined by L = I ω, the axes of the body turn at
///
/// Ω = ω + α L × ω
///
/// so that L̇ = L × Ω in body axes: L is constant in space, and
///
/// Ṫ = −α |L × ω|² ≤ 0
///
/// until the body spins about its axis of greatest moment. (A spin exactly about another principal
/// axis has no loss either.) Here ω is I⁻¹ L, and T = ½ ω · L. It differs from the turning rate Ω
/// of the axes by α |L × ω| while energy is dissipated. This difference is small if the loss in one
/// turn is small.
///
/// A body with two equal moments has I along its axis of symmetry and J across it. Its nutation
/// angle θ from L to the axis grows or decays as
///
/// tan θ = tan θ₀ exp(α L² (1/I − 1/J) t)
///
/// A spin about the axis of least moment (I < J) ends as a *flat spin* across it. The time constant
/// of the nutation is τ = 1 / (α L² |1/I − 1/J|), from which α can be chosen: see
/// [`EnergySink::with_time_constant`].
///
/// # Source
/// The equation is a double bracket: Bloch, Krishnaprasad, Marsden & Ratiu, Commun. Math. Phys. 175
/// (1996) 1, for L̇ = L × ω + α L × (L × ω).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergySink {
    coefficient: f64,
}

impl Law for EnergySink {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        at.in_body(Direction::ZERO)
    }

    /// α is a parameter of the equations of motion, not of a torque.
    fn parameters(&self) -> &'static [&'static str] {
        &["coefficient"]
    }
}

impl EnergySink {
    /// Creates a sink with the coefficient α, 1/(N·m·s).
    ///
    /// ```
    /// assert!(polhode::motion::torque::EnergySink::new(0.01).is_ok());
    /// assert!(polhode::motion::torque::EnergySink::new(-0.01).is_err()); // it would create energy
    /// ```
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) unless α is positive and finite.
    pub fn new(coefficient: f64) -> Result<Self, MotionError> {
        require::positive("the coefficient of an energy sink", coefficient)?;
        Ok(Self { coefficient })
    }

    /// Creates a sink from a time constant.
    ///
    /// The tangent of the nutation angle changes by a factor e in the time τ, s. `least` and
    /// `greatest` are the extreme moments of the body, kg·m², and `momentum` is the angular
    /// momentum, kg·m²/s: α = 1 / (τ L² (1/least − 1/greatest)). This is exact for a body with two
    /// equal moments. For another body it is its largest rate.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if τ is not positive, or if no such α
    /// exists because the moments are equal or the body is at rest.
    pub fn with_time_constant(
        time_constant: f64,
        [least, greatest]: [f64; 2],
        momentum: f64,
    ) -> Result<Self, MotionError> {
        require::positive("the time constant of an energy sink", time_constant)?;
        let rate = momentum * momentum * ((greatest - least) / greatest / least);
        let rule = "above zero: a body at rest, a rod, or one with equal moments has no nutation to damp";
        let holds = rate > 0.0 && rate.is_finite();
        require::that("L² (1/i1 − 1/i3) of a body with an energy sink", rate, holds, rule)?;
        Self::new(1.0 / (time_constant * rate))
    }

    /// Returns the coefficient α, 1/(N·m·s).
    pub const fn coefficient(&self) -> f64 {
        self.coefficient
    }
}

impl Model for EnergySink {
    fn name(&self) -> &'static str {
        "energy_sink"
    }

    fn unsplittable(&self) -> Option<&'static str> {
        Some("it acts inside the body")
    }

    fn sink(&self) -> f64 {
        self.coefficient
    }
}
