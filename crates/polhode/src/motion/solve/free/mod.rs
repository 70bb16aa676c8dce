//! Free motion in closed form: constants are computed once, then any time is evaluated in constant
//! time.
//!
//! One formula serves every body and state (`flow.rs`). The nome determines the faster of its two
//! series. The preparation has four parts:
//!
//! - principal axes in three words (`axes.rs`),
//! - labels such that L circles axis 3 (`labelled.rs`),
//! - amplitudes, parameter and rates without cancellation (`elements.rs`),
//! - phases that keep full precision over 10⁹ periods (`phase.rs`).

mod axes;
mod batch;
mod block;
mod body;
mod compact;
mod constants;
mod derivatives;
mod elements;
mod flow;
mod hyperbolic;
mod kernel;
mod labelled;
mod many;
mod reach;
mod regime;
mod trigonometric;

use crate::body::principal::PrincipalFrame;
use crate::math::frame::{Body, Space};
use crate::math::number::Splat;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::{AngularAcceleration, AngularMomentum};

use super::phase::Elapsed;
use super::reach::{is_within, require};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use constants::Constants;
use elements::Elements;
use kernel::Kernel;

pub use batch::FreeMotions;
pub(in crate::motion) use body::FreeBody;
pub use derivatives::FreeMotionDerivatives;
pub use regime::{PermanentAxis, Regime};

/// Torque-free motion of a body: ω and attitude at any time, past or future, in constant time.
///
/// ```
/// use polhode::body::{InertiaTensor, MassProperties};
/// use polhode::math::{AngularVelocity, Attitude, Position};
/// use polhode::motion::{FreeMotion, Regime, Rotor, State};
/// let inertia = InertiaTensor::diagonal([1.0, 2.0, 3.0])?;
/// let body = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia)?);
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.01, 1.0, 0.01) };
/// let motion = FreeMotion::of(&body, start)?;
/// assert_eq!(motion.regime(), Regime::ShortAxis);
/// let period = motion.period().unwrap();
/// assert!((period / 39.105_734_197_268_72 - 1.0).abs() < 1e-15);
/// let flipped = motion.at(0.5 * period).omega;
/// assert!((flipped.y + 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Accuracy
/// Errors measured against 40-digit references, for moments, ω and attitude exactly as given:
/// 4·10⁻¹⁵ (ω relative, attitude in rad). This holds for |t| up to 10⁹ periods and down to 1 − m =
/// 5·10⁻²⁴. `book/free-motion-accuracy.md` gives the error laws beyond, and `book/accuracy.md` the
/// measured errors.
///
/// If the tensor has products of inertia, its principal axes are first computed to 46 digits.
///
/// # Source
/// Klein & Sommerfeld, Über die Theorie des Kreisels, ch. VI (Cayley–Klein parameters as theta
/// functions). `book/free-motion.md` derives the constants without cancellation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeMotion {
    start: State,
    principal: PrincipalFrame<Body>,
    regime: Regime,
    constants: Constants,
    /// rad/s per unit of the kernel's rates: a power of two. It is 1 except for rates near the
    /// limits of the range of f64.
    unit: f64,
    reach: f64,
    kernel: Kernel,
}

/// Rates need no scaling while the fastest component of ω is between 1/`MODERATE` and `MODERATE`,
/// rad/s: no word of them leaves the range of f64.
const MODERATE: f64 = 18_446_744_073_709_551_616.0;

impl FreeMotion {
    /// Returns the torque-free motion that starts from a state.
    ///
    /// # Errors
    /// - [`MotionError::NotSpinnable`] for a body without inertia.
    /// - [`MotionError::NoClosedForm`] for a body with wheels.
    /// - A parameter error ([`MotionError::is_parameter`]) for a state that is not finite.
    pub fn of(rotor: &Rotor, start: State) -> Result<Self, MotionError> {
        Self::of_body(&FreeBody::of(rotor)?, start)
    }

    /// Returns the motion for principal moments along the body's x, y and z axes, kg·m².
    ///
    /// The moments need not belong to a physical body: Euler's equations do not require i1 + i2 ≥
    /// i3, and some textbook examples violate it.
    ///
    /// ```
    /// use polhode::math::{AngularVelocity, Attitude};
    /// use polhode::motion::{FreeMotion, State};
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.1, 0.2, 5.0) };
    /// let motion = FreeMotion::of_moments([8.0, 4.0, 0.4], start)?; // unphysical
    /// assert!(motion.period().is_some());
    /// # Ok::<(), polhode::motion::MotionError>(())
    /// ```
    ///
    /// # Errors
    /// - A parameter error ([`MotionError::is_parameter`]) for a moment that is negative or not
    ///   finite, or zero unless the other two are equal (a rod).
    /// - [`MotionError::NotSpinnable`] for three zeros.
    pub fn of_moments(moments: [f64; 3], start: State) -> Result<Self, MotionError> {
        for moment in moments {
            require::not_negative("a principal moment", moment)?;
        }
        let [a, b, c] = moments;
        let rod = |i: f64, j: f64, k: f64| i == 0.0 && j != k;
        let is_odd = rod(a, b, c) || rod(b, c, a) || rod(c, a, b);
        let rule = "positive, or zero with two equal others (a rod)";
        require::that("a principal moment", 0.0, !is_odd, rule)?;
        Self::of_symmetric(&Symmetric3::diagonal(moments), start)
    }

    /// Like [`FreeMotion::of`], for a tensor that need not belong to a physical body.
    pub(in crate::motion) fn of_symmetric(tensor: &Symmetric3, start: State) -> Result<Self, MotionError> {
        Self::of_body(&FreeBody::of_tensor(tensor, &PrincipalFrame::of_symmetric(tensor))?, start)
    }

    /// Returns the motion of a body whose axes are known.
    ///
    /// # Errors
    /// A parameter error ([`MotionError::is_parameter`]) for a state that is not finite.
    pub(in crate::motion) fn of_body(body: &FreeBody, start: State) -> Result<Self, MotionError> {
        let [wx, wy, wz] = start.omega.to_array();
        let rate = "a component of the start's angular velocity";
        for (what, value) in [("the start's time", start.time), (rate, wx), (rate, wy), (rate, wz)] {
            require::finite(what, value)?;
        }
        let FreeBody { axes, principal, .. } = body;
        let (labelled, unit) = body.labelled(&start);
        let (labelled, elements) = if labelled.is_permanent() {
            let turned = labelled.about_omega();
            (turned, Elements::permanent(&turned))
        } else {
            (labelled, Elements::of(&labelled))
        };
        let moderate = unit.max(1.0 / unit) <= MODERATE;
        let (kernel_unit, phase_rates) = if moderate { (1.0, unit) } else { (unit, 1.0) };
        Ok(Self {
            start,
            principal: *principal,
            regime: if axes.given {
                Regime::of_exact(&labelled)
            } else {
                Regime::of_rounded(&labelled, principal, start.omega)
            },
            constants: Constants::of(&elements, &labelled, axes.unit, unit),
            unit: kernel_unit,
            reach: reach::of(&elements, &labelled, axes.given, unit),
            kernel: Kernel::of(&elements, &labelled, [unit, phase_rates], start.attitude),
        })
    }

    /// Returns the state at a time, s, which may be before the start.
    ///
    /// ω and attitude are NaN beyond [`FreeMotion::reach`] and for a time that is NaN.
    /// [`FreeMotion::require`] reports such times as errors.
    #[must_use]
    pub fn at(&self, time: f64) -> State {
        if time == self.start.time {
            return self.start;
        }
        if !is_within(&self.start, self.reach, time) {
            return State::unknown(time);
        }
        if self.start.time == 0.0 {
            self.kernel.at::<true>(time, &self.elapsed::<true, f64>(time))
        } else {
            self.kernel.at::<false>(time, &self.elapsed::<false, f64>(time))
        }
    }

    /// Returns the time before and after the start for which the motion is accurate, s.
    ///
    /// The attitude at this limit can be wrong by up to 1e-6 rad, for exact inputs. The cause is
    /// rounding of the constants that multiply time. The reach is some 10²⁵ turns. It is shorter
    /// near the separatrix, where the period depends on differences with few digits.
    pub const fn reach(&self) -> f64 {
        self.reach
    }

    /// Checks that the motion is known at each of the times, s.
    ///
    /// # Errors
    /// [`MotionError::BeyondReach`] for the first time that is beyond [`FreeMotion::reach`] or NaN.
    pub fn require(&self, times: &[f64]) -> Result<(), MotionError> {
        require(&self.start, self.reach, times)
    }

    #[inline(always)]
    fn elapsed<const WHOLE: bool, T: Splat>(&self, time: T) -> Elapsed<T> {
        Elapsed::since::<WHOLE>(T::splat(self.start.time), time, T::splat(self.unit))
    }

    /// Returns dω/dt in body axes at one of the motion's states, rad/s²: i1 ω̇1 = (i2 − i3) ω2 ω3
    /// and cyclic permutations.
    pub fn angular_acceleration(&self, state: &State) -> AngularAcceleration<Body> {
        let ([r1, r2, r3], [w1, w2, w3]) = (self.constants.ratios, self.constants.along(state.omega));
        self.constants.in_body([r1 * w2 * w3, r2 * w3 * w1, r3 * w1 * w2])
    }

    /// Returns L = I ω at one of the motion's states, body axes, kg·m²/s.
    pub fn angular_momentum(&self, state: &State) -> AngularMomentum<Body> {
        let ([i1, i2, i3], [w1, w2, w3]) = (self.constants.moments, self.constants.along(state.omega));
        self.constants.in_body([i1 * w1, i2 * w2, i3 * w3])
    }

    /// Returns the state at the start.
    pub const fn start(&self) -> State {
        self.start
    }

    /// Returns principal moments and axes, body axes.
    pub const fn principal(&self) -> &PrincipalFrame<Body> {
        &self.principal
    }

    /// Returns the kind of motion.
    pub const fn regime(&self) -> Regime {
        self.regime
    }

    /// Returns true if L circles the axis of the least moment or, in a permanent rotation, lies
    /// along it.
    pub fn circles_least(&self) -> bool {
        self.constants.moments[2] < self.constants.moments[0]
    }

    /// Returns the constant angular momentum L in space axes, kg·m²/s.
    pub fn momentum(&self) -> AngularMomentum<Space> {
        let in_body: AngularMomentum<Body> = self.constants.in_body(self.constants.momentum);
        self.start.attitude * in_body
    }

    /// Returns the constant kinetic energy T, J.
    pub const fn kinetic_energy(&self) -> f64 {
        self.constants.kinetic_energy
    }

    /// Returns the period of ω in the body, 4K(m)/λ, s; `None` if ω is constant in the body or
    /// never repeats.
    pub fn period(&self) -> Option<f64> {
        let period = self.constants.period;
        let moves = !matches!(self.regime, Regime::Permanent(_) | Regime::AtRest);
        (moves && period.is_finite()).then_some(period)
    }

    /// Returns Ω, rad/s: the mean rate at which the axis that L circles precesses about L.
    ///
    /// A permanent rotation has Ω = |ω|. On the separatrix Ω is L/i2, the rate that the motion
    /// approaches.
    pub const fn precession_rate(&self) -> f64 {
        self.constants.precession
    }

    /// Returns |λ|, rad/s: along the labelled axes ω = (a1 cn, a2 sn, a3 dn)(u0 ± λt), with the
    /// minus sign in long-axis mode.
    pub const fn polhode_rate(&self) -> f64 {
        self.constants.polhode_rate
    }

    /// Returns the parameter m of the elliptic functions, and 1 − m, each to full precision. 1 − m
    /// may underflow.
    pub const fn parameter(&self) -> [f64; 2] {
        let k1 = self.constants.complementary_modulus;
        [self.constants.parameter, k1 * k1]
    }

    /// Returns k₁ = √(1 − m). It is zero only on the separatrix.
    pub const fn complementary_modulus(&self) -> f64 {
        self.constants.complementary_modulus
    }

    /// Returns the smallest and the largest angle between L and the axis that it circles, rad.
    pub const fn nutation_range(&self) -> [f64; 2] {
        self.constants.nutation
    }

    /// Returns the labelled moments, kg·m². The third belongs to the axis that L circles, the
    /// second is the intermediate moment.
    pub const fn labelled_moments(&self) -> [f64; 3] {
        self.constants.moments
    }

    /// Returns the largest |ω| along each labelled axis, rad/s: ω = (a1 cn, a2 sn, a3 dn).
    pub const fn amplitudes(&self) -> [f64; 3] {
        self.constants.amplitudes
    }
}
