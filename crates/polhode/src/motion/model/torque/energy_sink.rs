//! Energy lost inside a body: L is kept, T is not.

use super::model::Model;
use crate::math::vector::Direction;
use crate::motion::error::MotionError;
use crate::motion::model::law::{Law, LawInput};
use crate::motion::model::require;

/// Dissipation inside a body that bends, sloshes or carries a damper, whose angular momentum it cannot change: an *energy sink*.
///
/// The damper's own motion is left out; what is kept is that it costs energy and no angular momentum. With ω defined by L = I ω, the
/// axes of the body turn at
///
/// Ω = ω + α L × ω
///
/// so that L̇ = L × Ω in body axes: L stays where it is in space, and
///
/// Ṫ = −α |L × ω|² ≤ 0
///
/// until the body spins about its axis of greatest moment (or, exactly, about another, where the loss is zero too). So ω here is I⁻¹ L,
/// by which T = ½ ω · L, and differs from the rate Ω at which the axes turn while energy is being lost, by α |L × ω|, which is small
/// where the loss in a turn is.
///
/// A body with two equal moments, I along its axis of symmetry and J across, nutates towards or away from that axis by
///
/// tan θ = tan θ₀ exp(α L² (1/I − 1/J) t)
///
/// θ being the angle from L to the axis: a spin about the axis of least moment (I < J) ends as a *flat spin* across it. So the time
/// constant of the nutation is τ = 1 / (α L² |1/I − 1/J|), by which α can be chosen: see [`EnergySink::with_time_constant`].
///
/// # Source
/// The equation is a double bracket: Bloch, Krishnaprasad, Marsden & Ratiu, Commun. Math. Phys. 175 (1996) 1, for L̇ = L × ω + α L × (L × ω).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergySink {
    coefficient: f64,
}

impl Law for EnergySink {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        at.in_body(Direction::ZERO)
    }

    /// α is in the equations of motion, not in a torque.
    fn parameters(&self) -> &'static [&'static str] {
        &["coefficient"]
    }
}

impl EnergySink {
    /// The sink with the coefficient α, 1/(N·m·s).
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

    /// The sink by which the tangent of the nutation angle changes by a factor e in a time τ, s, in a body with the extreme moments
    /// `least` and `greatest`, kg·m², and the angular momentum `momentum`, kg·m²/s: α = 1 / (τ L² (1/least − 1/greatest)).
    ///
    /// For a body with two equal moments that is exact; for another it is the largest of its rates.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if τ is not positive, or if no such α exists: the moments are equal, the body is at rest.
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

    /// α, 1/(N·m·s).
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
