//! Errors of motions.

use core::fmt;

/// Error of a motion. Each variant carries the value and the time, if they apply.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum MotionError {
    /// Number that is NaN or infinite.
    NonFiniteParameter {
        /// Description of the number.
        parameter: &'static str,
        /// Value of the number.
        value: f64,
    },
    /// Number that must be positive and finite, and is not.
    NonPositiveParameter {
        /// Description of the number.
        parameter: &'static str,
        /// Value of the number.
        value: f64,
    },
    /// Number that must be nonnegative and finite, and is not.
    NegativeParameter {
        /// Description of the number.
        parameter: &'static str,
        /// Value of the number.
        value: f64,
    },
    /// Vector without a direction: zero, or not finite.
    NoDirection {
        /// Description of its length.
        parameter: &'static str,
        /// Length of the vector.
        length: f64,
    },
    /// Number outside its range.
    ParameterOutOfRange {
        /// Description of the number.
        parameter: &'static str,
        /// Value of the number.
        value: f64,
        /// Rule that the number violates.
        rule: &'static str,
    },
    /// Mass history that is impossible, or whose motion cannot be computed.
    MassHistory {
        /// Time of the violation, s.
        time: f64,
        /// Description of the violation.
        why: &'static str,
    },
    /// Unsupported property of a rotor in gimbals.
    InGimbals {
        /// Property, with the reason.
        why: &'static str,
    },
    /// Two parts of a scenario that exclude each other.
    Exclusive {
        /// Names of both parts in scenario files.
        parts: [&'static str; 2],
        /// Reason for the exclusion.
        why: &'static str,
    },
    /// All the mass is at the rotor's reference point: it has no inertia.
    NotSpinnable,
    /// Torque that is NaN or infinite at the start.
    TorqueNotFinite {
        /// Index of the torque, from 0.
        torque: usize,
        /// Components at the start, body axes, N·m.
        value: [f64; 3],
    },
    /// Torque along an axis about which the body has no inertia.
    TorqueWithoutInertia {
        /// Component of the torque along that axis, N·m.
        torque: f64,
        /// Time at which it occurs, s.
        time: f64,
    },
    /// Torque without a derivative in a state where one is needed: it has a corner or a jump, or is
    /// not finite nearby.
    NoDerivative {
        /// Name of the torque.
        torque: &'static str,
        /// Time of the state, s.
        time: f64,
    },
    /// Unknown torque, or unknown parameter of a torque.
    NoParameter {
        /// Index of the torque, from 0.
        torque: usize,
        /// Name of the parameter.
        name: &'static str,
    },
    /// Motion without derivatives, or with derivatives that are not implemented.
    NoMotionDerivatives {
        /// Reason for the absence.
        why: &'static str,
        /// Time at which it occurs, s.
        time: f64,
    },
    /// Motion that cannot be continued from its end.
    NotContinued {
        /// Reason for the refusal.
        why: &'static str,
    },
    /// State that is not an equilibrium: the torque turns the body, or changes with time.
    NotSteady {
        /// Residual of the torque, N·m.
        torque: f64,
        /// Sum of the magnitudes of the terms that should balance, N·m.
        scale: f64,
    },
    /// Body on the ground without a steady motion whose stability can be computed.
    NoSteadyMotion {
        /// Reason, and conditions for a steady motion.
        why: &'static str,
    },
    /// No closed form is known for this body and start.
    NoClosedForm {
        /// Reason for the absence.
        why: &'static str,
    },
    /// Time at which the phase of a closed form has no accuracy, or NaN.
    BeyondReach {
        /// Requested time, s.
        time: f64,
        /// Largest distance from the start at which the motion is known, s.
        reach: f64,
    },
    /// Torque that splitting cannot integrate: it is not a function of attitude and time alone.
    NotSplittable {
        /// Model of the torque.
        what: &'static str,
        /// Reason for the refusal.
        why: &'static str,
    },
    /// The step required by the tolerance is below the rounding of the time.
    StepTooSmall {
        /// Last valid time, s.
        time: f64,
        /// Step that was tried, s.
        step: f64,
    },
    /// The limit on the number of steps is exceeded.
    TooManySteps {
        /// Last valid time, s.
        time: f64,
        /// Step at that time, s.
        step: f64,
        /// Limit on the number of steps.
        most: u64,
    },
    /// The limit on the number of pulses is exceeded. No step crosses the beginning or the end of a
    /// pulse.
    TooManyPulses {
        /// Index of the torque with the largest number of pulses, from 0; `None` for a wheel's
        /// motor.
        torque: Option<usize>,
        /// Number of pulses from the start to the end, over all torques and motors.
        count: f64,
        /// Limit on the number of pulses.
        most: u64,
    },
    /// The limit on the number of events is exceeded.
    TooManyEvents {
        /// Time of the last event, s.
        time: f64,
        /// Limit on the number of recorded events.
        most: usize,
    },
    /// Painlevé's paradox: sliding friction is so large that either no normal force keeps the body
    /// on the ground, or every one does.
    Painleve {
        /// Time at which it occurs, s.
        time: f64,
    },
    /// Contact whose next phase is undetermined: lift-off, or slip and its direction.
    Undecided {
        /// Time at which it occurs, s.
        time: f64,
    },
    /// Change of the contact after which the motion is not modelled, although a later time was
    /// requested.
    ContactChanged {
        /// Sentence that describes the change.
        what: &'static str,
        /// Time of the change, s.
        time: f64,
    },
    /// Gimbal lock without gimbal inertia: the rotor's axis is along the outer axis, and the
    /// rotations about both cannot be distinguished.
    GimbalLock {
        /// Time of the lock, s.
        time: f64,
        /// Angle of the inner gimbal, rad.
        angle: f64,
    },
    /// The body accelerates beyond any rate that its start and the initial torques explain: |ω|
    /// grows by a factor of 10⁹, or diverges in finite time.
    RunAway {
        /// Start of the current sequence of steps with |ω| above the bound, s.
        time: f64,
        /// |ω| at that time, rad/s.
        rate: f64,
        /// Bound on |ω|: 10³ times the rate that the start and the torques explain, rad/s.
        most: f64,
    },
    /// An event measures the total energy, but a torque has no potential.
    NoPotential,
    /// Taylor's method was requested, but a torque has no power series.
    NotSmooth {
        /// Index of the torque, from 0.
        torque: usize,
        /// Function or formula without a power series.
        why: &'static str,
    },
    /// A torsion spring or wire reaches half a turn. Beyond it, an attitude does not determine the
    /// twist.
    HalfTurn {
        /// Time of the half turn, s.
        time: f64,
    },
    /// Chattering: events switch torques on and off at one instant without end. Each torque takes
    /// the motion back to the switching point of the other.
    Chatter {
        /// Index of an event that happens repeatedly, from 0.
        event: usize,
        /// Time of the switches, s.
        time: f64,
    },
    /// The function of an event changes too fast to find all its crossings.
    EventTooFast {
        /// Index of the event, from 0.
        event: usize,
        /// Time up to which the crossings are known, s.
        time: f64,
        /// End of the step in which the function changes too fast, s.
        until: f64,
    },
    /// The progress callback ended an integration.
    Stopped {
        /// Time reached, s.
        time: f64,
    },
    /// Cancelled by the progress callback.
    Cancelled {
        /// Number of completed computations.
        done: usize,
    },
    /// The state became infinite or undefined.
    NotFinite {
        /// Last valid time, s.
        time: f64,
    },
}

impl MotionError {
    /// True if the input was valid, but the computation could not reach its tolerance.
    pub const fn is_numerical(&self) -> bool {
        matches!(
            self,
            Self::StepTooSmall { .. }
                | Self::TooManySteps { .. }
                | Self::TooManyEvents { .. }
                | Self::Painleve { .. }
                | Self::Undecided { .. }
                | Self::ContactChanged { .. }
                | Self::GimbalLock { .. }
                | Self::RunAway { .. }
                | Self::HalfTurn { .. }
                | Self::Chatter { .. }
                | Self::EventTooFast { .. }
                | Self::NotFinite { .. }
        )
    }

    /// True if a number of the input is outside its range.
    pub const fn is_parameter(&self) -> bool {
        matches!(
            self,
            Self::NonFiniteParameter { .. }
                | Self::NonPositiveParameter { .. }
                | Self::NegativeParameter { .. }
                | Self::NoDirection { .. }
                | Self::ParameterOutOfRange { .. }
                | Self::MassHistory { .. }
        )
    }

    /// Returns a hint on how to fix the error, if there is one.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::NotSpinnable => Some("give the body an extent: a point has no attitude"),
            Self::TorqueWithoutInertia { .. } => {
                Some("all the mass is on one line: give it a thickness, or a torque across the line")
            }
            Self::NotSteady { .. } => Some(
                "start nearer to an equilibrium, at rest or rotating about an axis along which all torques are constant",
            ),
            Self::NoDerivative { .. } => Some(
                "dry friction at rest, |x|, sign(x) and the angle theta near 0 have a corner or a jump: use a smooth torque",
            ),
            Self::NoSteadyMotion { .. } => Some(
                "start nearer to one, on level ground without slip and pivoting friction: a symmetric body that rolls straight or spins upright, or a spin about the vertical on a point below the centre of mass",
            ),
            Self::NoClosedForm { .. } => Some("use method = \"auto\" or \"dop853\""),
            Self::BeyondReach { time, .. } if !time.is_finite() => None,
            Self::BeyondReach { .. } => {
                Some("use an earlier time; long before this one, the rounding of the input limits the phase")
            }
            Self::NotSplittable { .. } => Some("use method = \"auto\", without step and order"),
            Self::StepTooSmall { .. } | Self::TooManySteps { .. } => {
                Some("loosen the tolerance or lengthen the step, or shorten the duration")
            }
            Self::TooManyPulses { .. } => Some(
                "shorten the duration, or give the pulses a longer period or a count; such dense pulses act like their mean, width / period times the torque",
            ),
            Self::TooManyEvents { .. } => Some(
                "shorten the duration; an event that switches the quantity that it measures may repeat endlessly: give it a direction or a dead band",
            ),
            Self::NoPotential => Some("use measure = \"kinetic_energy\""),
            Self::RunAway { .. } => {
                Some("check the sign of the torque: a torque that grows with ω is unbounded")
            }
            Self::NotSmooth { .. } => Some("use method = \"auto\" or \"dop853\""),
            Self::HalfTurn { .. } => {
                Some("stop the run earlier, by an event on the angle, or start with less energy")
            }
            Self::Chatter { .. } => Some(
                "give the events that switch on and off different values, with the controller's dead band between them",
            ),
            Self::EventTooFast { .. } => Some(
                "measure a slower quantity: the phase of a formula may advance by at most 1e6 rad per step",
            ),
            Self::TorqueNotFinite { .. } => {
                Some("a formula is NaN where it divides by zero or takes the root of a negative number")
            }
            Self::NotFinite { .. } => Some("check the units of the torque, the spin and the inertia"),
            Self::NoParameter { .. } => Some("`TorqueModel::parameters` lists the names that a torque has"),
            Self::Painleve { .. } => Some("give a smaller coefficient of friction"),
            Self::Undecided { .. } => Some(
                "change the start or the law: pure rolling needs unlimited friction where the normal force is small",
            ),
            Self::GimbalLock { .. } => {
                Some("give the outer gimbal an inertia about its axis: then this is an ordinary motion")
            }
            Self::NonFiniteParameter { .. }
            | Self::NonPositiveParameter { .. }
            | Self::NegativeParameter { .. }
            | Self::NoDirection { .. }
            | Self::ParameterOutOfRange { .. }
            | Self::MassHistory { .. }
            | Self::InGimbals { .. }
            | Self::NoMotionDerivatives { .. }
            | Self::NotContinued { .. }
            | Self::Exclusive { .. }
            | Self::ContactChanged { .. }
            | Self::Stopped { .. }
            | Self::Cancelled { .. } => None,
        }
    }
}

impl fmt::Display for MotionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NonFiniteParameter { parameter, value } => broken(f, parameter, *value, "finite"),
            Self::NonPositiveParameter { parameter, value } => {
                broken(f, parameter, *value, "positive and finite")
            }
            Self::NegativeParameter { parameter, value } => {
                broken(f, parameter, *value, "finite and not negative")
            }
            Self::NoDirection { parameter, length } => {
                broken(f, parameter, *length, "a direction: finite and not zero")
            }
            Self::ParameterOutOfRange { parameter, value, rule } => broken(f, parameter, *value, rule),
            Self::MassHistory { time, why } => {
                write!(f, "at t = {time} s the body's history of mass properties {why}", time = plain(*time))
            }
            Self::InGimbals { why } => write!(f, "the body hangs in gimbals: {why}"),
            Self::Exclusive { parts: [a, b], why } => write!(f, "{a} and {b} exclude each other: {why}"),
            Self::NotSpinnable => {
                write!(
                    f,
                    "the body has no inertia about the point that it turns about, so its motion is undetermined"
                )
            }
            Self::TorqueNotFinite { torque, value: [x, y, z] } => {
                write!(
                    f,
                    "torque {} is not finite at the start: ({x}, {y}, {z}) N·m in body axes",
                    torque + 1
                )
            }
            Self::TorqueWithoutInertia { torque, time } => write!(
                f,
                "at t = {time} s a torque of {torque} N·m acts about an axis along which the body has no inertia",
                time = plain(*time)
            ),
            Self::NotSteady { torque, scale } => write!(
                f,
                "the start is not an equilibrium, and none was found near it: of {scale:.3e} N·m of torque in total, {torque:.3e} N·m is unbalanced"
            ),
            Self::NoDerivative { torque, time } => write!(
                f,
                "the torque \"{torque}\" has no derivative in this state, at t = {time} s: it has a corner or a jump there, or is not finite nearby",
                time = plain(*time)
            ),
            Self::NoParameter { torque, name } => {
                write!(f, "torque {} has no parameter \"{name}\"", torque + 1)
            }
            Self::NoMotionDerivatives { why, time } => {
                write!(f, "at t = {time} s the motion has no derivatives: {why}", time = plain(*time))
            }
            Self::NotContinued { why } => write!(f, "the motion cannot be continued from its end: {why}"),
            Self::NoSteadyMotion { why } => {
                write!(f, "the start is not near a steady motion on the ground: {why}")
            }
            Self::NoClosedForm { why } => write!(f, "this motion has no closed form: {why}"),
            Self::BeyondReach { time, .. } if !time.is_finite() => {
                write!(f, "t = {time} s is not finite")
            }
            Self::BeyondReach { time, reach } => write!(
                f,
                "t = {time} s is too far away: this motion is known up to {:.1e} s from its start, where rounding limits its phase to six digits",
                // Rounded down: a time up to this one is accepted.
                0.95 * reach,
                time = plain(*time)
            ),
            Self::NotSplittable { what, why } => {
                write!(f, "splitting cannot take the torque \"{what}\": {why}")
            }
            Self::StepTooSmall { time, step } => {
                write!(
                    f,
                    "at t = {time} s the step ({step:e} s) is too small to advance the time",
                    time = plain(*time)
                )
            }
            Self::TooManySteps { time, step, most } => write!(
                f,
                "at t = {time} s the steps are {step:e} s: more than {most} steps to the end",
                time = plain(*time)
            ),
            Self::TooManyPulses { torque, count, most } => {
                let of = match torque {
                    Some(torque) => format!("torque {}", torque + 1),
                    None => "a wheel's motor".to_owned(),
                };
                write!(f, "the run has {count:.3e} pulses, most from {of}: more than the limit of {most}")
            }
            Self::Painleve { time } => {
                write!(
                    f,
                    "at t = {time} s friction is so large that no normal force keeps the sliding body on the ground (Painlevé's paradox)"
                )
            }
            Self::Undecided { time } => {
                write!(
                    f,
                    "at t = {time} s the next phase is undetermined: whether the body lifts off, or whether and in which direction it slips"
                )
            }
            Self::ContactChanged { what, time } => write!(f, "at t = {time} s the motion ends: {what}"),
            Self::GimbalLock { time, angle } => write!(
                f,
                "at t = {time} s the gimbals lock: with the inner one at {angle} rad the rotor's axis lies along the outer one, and gimbals without inertia are not \
                 held apart",
                time = plain(*time),
                angle = plain(*angle)
            ),
            Self::TooManyEvents { time, most } => {
                write!(f, "at t = {time} s there are already {most} events", time = plain(*time))
            }
            Self::RunAway { time, rate, most } => write!(
                f,
                "the motion diverges: at t = {time} s |ω| is {rate:.3e} rad/s, and soon after it is far above {most:.3e} rad/s, 1000 times the rate that the start and the initial torques explain",
                time = plain(*time)
            ),
            Self::NoPotential => f.write_str(
                "an event measures the total energy, but a torque has no potential, or is switched",
            ),
            Self::NotSmooth { torque, why } => {
                write!(
                    f,
                    "Taylor's method needs torques with a power series, and torque {} has {why}",
                    torque + 1
                )
            }
            Self::HalfTurn { time } => write!(
                f,
                "at t = {time} s a spring or wire is twisted by half a turn; beyond that its torque is not defined",
                time = plain(*time)
            ),
            Self::Chatter { event, time } => write!(
                f,
                "at t = {time} s events switch torques on and off endlessly: event {} happens twice at this time",
                event + 1,
                time = plain(*time)
            ),
            Self::EventTooFast { event, time, until } => write!(
                f,
                "the function of event {} changes too fast: not all crossings between t = {time} s and {until} s can be found",
                event + 1,
                time = plain(*time),
                until = plain(*until)
            ),
            Self::Stopped { time } => write!(f, "stopped at {time} s, as requested"),
            Self::Cancelled { done } => write!(f, "cancelled after {done} members"),
            Self::NotFinite { time } => {
                write!(f, "the motion is not finite after t = {time} s", time = plain(*time))
            }
        }
    }
}

/// Writes the rule that a number violates.
fn broken(f: &mut fmt::Formatter<'_>, parameter: &str, value: f64, rule: &str) -> fmt::Result {
    write!(f, "{parameter} = {} must be {rule}", plain(value))
}

/// Formats a number without exponent if it is of moderate size.
pub(super) fn plain(x: f64) -> String {
    if x != 0.0 && !(1e-9..1e16).contains(&x.abs()) { format!("{x:e}") } else { x.to_string() }
}

impl core::error::Error for MotionError {}
