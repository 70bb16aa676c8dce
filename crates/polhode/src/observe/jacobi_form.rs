//! Jacobi form: ω(t) of a free asymmetric body in Jacobi elliptic functions, as in textbooks.

use crate::math::elliptic::{EllipticParameter, JacobiFunctions};
use crate::math::frame::Principal;
use crate::math::vector::AngularVelocity;
use crate::motion::solve::free::{FreeMotion, Regime};

/// One of the three Jacobi elliptic functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JacobiFunction {
    /// Sine amplitude, sn.
    Sn,
    /// Cosine amplitude, cn.
    Cn,
    /// Delta amplitude, dn.
    Dn,
}

impl JacobiFunction {
    /// Returns `sn`, `cn` or `dn`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sn => "sn",
            Self::Cn => "cn",
            Self::Dn => "dn",
        }
    }

    const fn of(self, values: &JacobiFunctions) -> f64 {
        match self {
            Self::Sn => values.sn,
            Self::Cn => values.cn,
            Self::Dn => values.dn,
        }
    }
}

/// Angular velocity along the principal axes, each component an amplitude times a Jacobi function
/// of λt + φ.
///
/// The functions depend on the mode, with i1 < i2 < i3 and D = L²/2T:
///
/// D > i2 (short-axis mode): ω1 = A1 cn, ω2 = A2 sn, ω3 = A3 dn of λt + φ;
/// D < i2 (long-axis mode): ω1 = A1 dn, ω2 = A2 sn, ω3 = A3 cn;
/// D = i2 (separatrix, m = 1): sn = tanh, cn = dn = sech.
///
/// |A1|² = (2T i3 − L²)/(i1 (i3 − i1)), |A3|² = (L² − 2T i1)/(i3 (i3 − i1)), and |A2|² is the
/// smaller of (2T i3 − L²)/(i2 (i3 − i2)) and (L² − 2T i1)/(i2 (i2 − i1)). The axes are those of
/// [`PrincipalFrame`](crate::body::PrincipalFrame); t is the time since the start.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::FreeMotion;
/// use polhode::observe::JacobiForm;
/// let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
/// let body = Rotor::free(&MassProperties::new(2.3, Position::new(0.1, -0.2, 0.3), inertia)?);
/// let omega = AngularVelocity::new(0.7, -1.1, 0.4);
/// let motion = FreeMotion::of(&body, State { time: 2.0, attitude: Attitude::identity(), omega })?;
/// let form = JacobiForm::of(&motion).ok_or("two equal moments, or a permanent rotation")?;
/// let after = motion.principal().rotation() * form.omega(7.5);
/// assert!((after - motion.at(9.5).omega).norm() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Accuracy
/// The form is meant for reading: the phase λt + φ has the precision of a product of doubles.
/// [`FreeMotion`] keeps full precision for long times, and also has the attitude.
///
/// # Source
/// Landau & Lifshitz, Mechanics, §37; Whittaker, Analytical Dynamics, §69. Tested against
/// [`FreeMotion`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JacobiForm {
    functions: [JacobiFunction; 3],
    amplitudes: [f64; 3],
    rate: f64,
    phase: f64,
    parameter: EllipticParameter,
}

impl JacobiForm {
    /// Returns the form of a motion; `None` for a permanent rotation, at rest, and if two moments
    /// are equal.
    pub fn of(motion: &FreeMotion) -> Option<Self> {
        use JacobiFunction::{Cn, Dn, Sn};
        let regime = motion.regime();
        if !matches!(regime, Regime::LongAxis | Regime::ShortAxis | Regime::Separatrix) {
            return None;
        }
        let [m, m1] = motion.parameter();
        let parameter =
            if m < 0.5 { EllipticParameter::new(m) } else { EllipticParameter::from_complement(m1) }.ok()?;
        let omega = (motion.principal().rotation().inverse() * motion.start().omega).to_array();
        // L circles the third of the labelled axes, whose function is dn.
        let [c, s, d] = motion.amplitudes();
        let (functions, sizes, circled) =
            if motion.circles_least() { ([Dn, Sn, Cn], [d, s, c], 0) } else { ([Cn, Sn, Dn], [c, s, d], 2) };
        let sign = |k: usize| 1.0_f64.copysign(omega[k]);
        // dω2/dt has the sign of ω3 ω1, like A2 cn dn; where cn keeps its sign, A2 takes that sign.
        let (first, second, third) = match regime {
            Regime::Separatrix => (sign(0), sign(0) * sign(2), sign(2)),
            _ => (sign(circled), 1.0, sign(circled)),
        };
        let amplitudes = [first * sizes[0], second * sizes[1], third * sizes[2]];
        let ratio = |name: JacobiFunction| {
            let k = functions.iter().position(|f| *f == name)?;
            Some(omega[k] / amplitudes[k])
        };
        let phase = parameter.argument_of([ratio(Sn)?, ratio(Cn)?, ratio(Dn)?]);
        Some(Self { functions, amplitudes, rate: motion.polhode_rate(), phase, parameter })
    }

    /// Returns the functions of ω1, ω2 and ω3.
    pub const fn functions(&self) -> [JacobiFunction; 3] {
        self.functions
    }

    /// Returns A1, A2 and A3 with their signs, rad/s.
    pub const fn amplitudes(&self) -> [f64; 3] {
        self.amplitudes
    }

    /// Returns λ > 0, 1/s.
    pub const fn rate(&self) -> f64 {
        self.rate
    }

    /// Returns φ, between −2K and 2K.
    pub const fn phase(&self) -> f64 {
        self.phase
    }

    /// Returns the parameter m = k², with 1 − m to full relative precision.
    pub const fn parameter(&self) -> &EllipticParameter {
        &self.parameter
    }

    /// Returns ω along the principal axes, rad/s, at the time t after the start, s.
    pub fn omega(&self, t: f64) -> AngularVelocity<Principal> {
        let values = self.parameter.jacobi(self.rate * t + self.phase);
        let component = |k: usize| self.amplitudes[k] * self.functions[k].of(&values);
        AngularVelocity::new(component(0), component(1), component(2))
    }
}
