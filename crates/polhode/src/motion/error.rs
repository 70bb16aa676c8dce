//! Why a motion cannot be computed.

use core::fmt;

/// Why a motion cannot be computed: each variant carries the value and the time.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum MotionError {
    /// A number that is NaN or infinite.
    NonFiniteParameter {
        /// What the number is.
        parameter: &'static str,
        /// The number.
        value: f64,
    },
    /// A number that has to be positive and finite, and is not.
    NonPositiveParameter {
        /// What the number is.
        parameter: &'static str,
        /// The number.
        value: f64,
    },
    /// A number that has to be finite and not negative, and is not.
    NegativeParameter {
        /// What the number is.
        parameter: &'static str,
        /// The number.
        value: f64,
    },
    /// A vector without a direction: zero, or not finite.
    NoDirection {
        /// What its length is.
        parameter: &'static str,
        /// The length.
        length: f64,
    },
    /// A number outside a range of its own.
    ParameterOutOfRange {
        /// What the number is.
        parameter: &'static str,
        /// The number.
        value: f64,
        /// What it has to be.
        rule: &'static str,
    },
    /// Mass properties over time that cannot be, or whose motion is not known.
    MassHistory {
        /// When, s.
        time: f64,
        /// What the history does then.
        why: &'static str,
    },
    /// Something that is not known of a rotor in gimbals.
    InGimbals {
        /// What, and why.
        why: &'static str,
    },
    /// Two parts of a scenario that exclude each other.
    Exclusive {
        /// Both, as a scenario file names them.
        parts: [&'static str; 2],
        /// Why.
        why: &'static str,
    },
    /// All the mass is in the point that the body turns about: it has no inertia at all.
    NotSpinnable,
    /// A torque is NaN or infinite at the start.
    TorqueNotFinite {
        /// Which of the torques, from 0.
        torque: usize,
        /// Its components at the start, body axes, N·m.
        value: [f64; 3],
    },
    /// A torque along an axis about which the body has no inertia.
    TorqueWithoutInertia {
        /// The torque along that axis, N·m.
        torque: f64,
        /// When, s.
        time: f64,
    },
    /// A torque has no derivative in a state, though one is needed: it has a corner or a jump there, or is not finite near it.
    NoDerivative {
        /// Which one, by its name.
        torque: &'static str,
        /// When, s.
        time: f64,
    },
    /// A torque has no number of this name to differentiate by, or there is no such torque.
    NoParameter {
        /// Which of the torques, from 0.
        torque: usize,
        /// The name.
        name: &'static str,
    },
    /// A motion has no derivatives, or none that are known here.
    NoMotionDerivatives {
        /// Why.
        why: &'static str,
        /// When, s.
        time: f64,
    },
    /// A motion does not go on from its end.
    NotContinued {
        /// Why.
        why: &'static str,
    },
    /// A state is no equilibrium, though one was asked for: the torque there turns the body, or changes on the way.
    NotSteady {
        /// What is left of the torque, N·m.
        torque: f64,
        /// The sum of the sizes of what should balance, N·m.
        scale: f64,
    },
    /// A body on the ground has no steady motion of which it is known here whether it lasts.
    NoSteadyMotion {
        /// Why, and what would have one.
        why: &'static str,
    },
    /// No closed form is known here for this body and start.
    NoClosedForm {
        /// Why.
        why: &'static str,
    },
    /// A time beyond which the phase of a closed form is not known, or NaN.
    BeyondReach {
        /// The time, s.
        time: f64,
        /// How far from its start the motion is known, s.
        reach: f64,
    },
    /// A torque that splitting cannot take: it is no function of attitude and time alone.
    NotSplittable {
        /// The torque's model.
        what: &'static str,
        /// Why.
        why: &'static str,
    },
    /// The step needed for the tolerance is lost in the rounding of the time.
    StepTooSmall {
        /// The last good time, s.
        time: f64,
        /// The step that was tried, s.
        step: f64,
    },
    /// More steps than the limit.
    TooManySteps {
        /// The last good time, s.
        time: f64,
        /// The step there, s.
        step: f64,
        /// The most steps that are tried.
        most: u64,
    },
    /// More pulses than the limit on steps: no step crosses the beginning or the end of one.
    TooManyPulses {
        /// The torque with the most of them, from 0; `None` for a wheel's motor.
        torque: Option<usize>,
        /// How many there are from the start to the end, of all torques and motors.
        count: f64,
        /// The most that are gone through.
        most: u64,
    },
    /// More events than the limit.
    TooManyEvents {
        /// The time of the last, s.
        time: f64,
        /// The most that are written down.
        most: usize,
    },
    /// Painlevé's paradox: friction of what slides is so large that no normal force keeps the body on the ground, or any does.
    Painleve {
        /// When, s.
        time: f64,
    },
    /// A contact at which it cannot be decided whether the body lifts off, or whether, or whither, it slips.
    Undecided {
        /// When, s.
        time: f64,
    },
    /// A change of the contact with the ground after which the motion is not known, where all of it was asked for.
    ContactChanged {
        /// The change, in a sentence.
        what: &'static str,
        /// Time of the change, s.
        time: f64,
    },
    /// Gimbals without inertia lock: the rotor's axis has come to lie along the outer one, and what both turn by is not known apart.
    GimbalLock {
        /// When, s.
        time: f64,
        /// The angle of the inner gimbal, rad.
        angle: f64,
    },
    /// The body turns faster and faster, beyond all that its start and the torques of each beginning explain: |ω| becomes 10⁹ times as
    /// large, or grows towards infinity within a time.
    RunAway {
        /// The start of the current run of steps whose |ω| exceeds the bound, s.
        time: f64,
        /// |ω| there, rad/s.
        rate: f64,
        /// The bound on |ω|: 10³ times what the start and the torques explain, rad/s.
        most: f64,
    },
    /// An event measures the total energy, and a torque has no potential.
    NoPotential,
    /// Taylor's method was asked for, and a torque has no power series.
    NotSmooth {
        /// Which of the torques, from 0.
        torque: usize,
        /// What it has that has none: a function of a formula.
        why: &'static str,
    },
    /// A torsion spring or wire comes to half a turn, beyond which an attitude does not determine its twist.
    HalfTurn {
        /// Time of the half turn, s.
        time: f64,
    },
    /// Events switch torques on and off at one instant without end: each torque takes the motion back to where the
    /// other is switched.
    Chatter {
        /// Index of an event that happens again and again, from 0.
        event: usize,
        /// Time of the switches, s.
        time: f64,
    },
    /// The function of an event changes so fast that its passages cannot all be found.
    EventTooFast {
        /// Index of the event, from 0.
        event: usize,
        /// Time up to which its passages are known, s.
        time: f64,
        /// End of the step in which it changes too fast, s.
        until: f64,
    },
    /// The progress callback ended an integration.
    Stopped {
        /// The time it had reached, s.
        time: f64,
    },
    /// Cancelled by the progress callback.
    Cancelled {
        /// How many were done.
        done: usize,
    },
    /// The state became infinite or undefined.
    NotFinite {
        /// The last good time, s.
        time: f64,
    },
}

impl MotionError {
    /// True if the input was fine but the computation could not reach its tolerance.
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

    /// What to try next, where there is something to try.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::NotSpinnable => Some("give the mass an extent: a point has no attitude"),
            Self::TorqueWithoutInertia { .. } => {
                Some("all the mass is on one line: give it a thickness, or a torque across the line")
            }
            Self::NotSteady { .. } => Some(
                "start nearer to an equilibrium, at rest or turning about an axis along which all torques stay as they are",
            ),
            Self::NoDerivative { .. } => Some(
                "dry friction at rest, |x|, sign(x) and the angle theta near 0 have a corner or a jump: write a torque that is smooth there",
            ),
            Self::NoSteadyMotion { .. } => Some(
                "start nearer to one: a symmetric body that rolls straight or spins upright, a spin about the vertical on a point below the centre of mass, without slip and pivoting friction on level ground",
            ),
            Self::NoClosedForm { .. } => Some("use method = \"auto\" or \"dop853\""),
            Self::BeyondReach { .. } => {
                Some("give an earlier time; the last bit of what is measured decides the phase long before")
            }
            Self::NotSplittable { .. } => Some("use method = \"taylor\" or \"dop853\""),
            Self::StepTooSmall { .. } | Self::TooManySteps { .. } => {
                Some("loosen the tolerance or lengthen the step, or shorten the duration")
            }
            Self::TooManyPulses { .. } => Some(
                "shorten the duration, or give the pulses a longer period or a count; pulses so dense act as their mean, width / period of the torque",
            ),
            Self::TooManyEvents { .. } => Some(
                "shorten the duration; an event that switches what it measures may happen without end: give it a direction, or a dead band",
            ),
            Self::NoPotential => Some("measure the kinetic energy"),
            Self::RunAway { .. } => Some("check the sign of the torque: one that grows with ω has no bound"),
            Self::NotSmooth { .. } => Some("use method = \"auto\" or \"dop853\""),
            Self::HalfTurn { .. } => {
                Some("stop the run before with an event on the angle, or start with less energy")
            }
            Self::Chatter { .. } => Some(
                "give the events that switch on and off different values: between them is the dead band of the controller",
            ),
            Self::EventTooFast { .. } => Some(
                "measure something slower: in one step of the motion the phase of a formula may advance by 1e6 rad",
            ),
            Self::TorqueNotFinite { .. } => {
                Some("a formula is NaN where it divides by zero or takes the root of a negative number")
            }
            Self::NotFinite { .. } => Some("check the units of the torque, the spin and the inertia"),
            Self::NoParameter { .. } => Some("`TorqueModel::parameters` lists the names that a torque has"),
            Self::Painleve { .. } => Some("give a smaller coefficient of friction"),
            Self::Undecided { .. } => Some(
                "give another start or another law: rolling alone takes a friction that nothing has where the normal force is small",
            ),
            Self::GimbalLock { .. } => {
                Some("give the outer gimbal an inertia about its axis: then this is a motion like others")
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
                "this is no equilibrium, and none was found near it: of torques of {scale:.3e} N·m in all, {torque:.3e} N·m is left over"
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
            Self::NotContinued { why } => write!(f, "the motion does not go on from its end: {why}"),
            Self::NoSteadyMotion { why } => write!(f, "no steady motion on the ground is near: {why}"),
            Self::NoClosedForm { why } => write!(f, "there is no closed form of this motion: {why}"),
            Self::BeyondReach { time, .. } if !time.is_finite() => {
                write!(f, "t = {time} s is no time")
            }
            Self::BeyondReach { time, reach } => write!(
                f,
                "t = {time} s is too far away: this motion is known up to {reach:.1e} s from its start, where rounding \
                 leaves its phase six digits",
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
                "at t = {time} s steps are of {step:e} s: to the end that is more than {most} steps",
                time = plain(*time)
            ),
            Self::TooManyPulses { torque, count, most } => {
                let of = match torque {
                    Some(torque) => format!("torque {}", torque + 1),
                    None => "a wheel's motor".to_owned(),
                };
                write!(f, "to the end there are {count:.3e} pulses, most of {of}: that is more than {most}")
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
                    "at t = {time} s it cannot be decided how the body goes on: whether it lifts off, or whether, and in which direction, it slips"
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
                "the motion runs away: at t = {time} s the body turns at {rate:.3e} rad/s, and soon after it is far beyond \
                 {most:.3e} rad/s, 1000 times what its start and the torques where they begin explain",
                time = plain(*time)
            ),
            Self::NoPotential => f.write_str(
                "an event measures the total energy, and a torque has no potential, or is switched",
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
                "at t = {time} s a spring or wire is twisted by half a turn; beyond, its torque is not determined",
                time = plain(*time)
            ),
            Self::Chatter { event, time } => write!(
                f,
                "at t = {time} s events switch torques on and off without end: event {} happens twice at this instant",
                event + 1,
                time = plain(*time)
            ),
            Self::EventTooFast { event, time, until } => write!(
                f,
                "the function of event {} changes too fast: between t = {time} s and {until} s not all passages can be found",
                event + 1,
                time = plain(*time),
                until = plain(*until)
            ),
            Self::Stopped { time } => write!(f, "stopped at {time} s, as was asked"),
            Self::Cancelled { done } => write!(f, "cancelled after {done} members"),
            Self::NotFinite { time } => {
                write!(f, "the motion is not finite after t = {time} s", time = plain(*time))
            }
        }
    }
}

/// The rule that a number breaks.
fn broken(f: &mut fmt::Formatter<'_>, parameter: &str, value: f64, rule: &str) -> fmt::Result {
    write!(f, "{parameter} = {} must be {rule}", plain(value))
}

/// A number without a power of ten where people write it so: 1e300 has no three hundred digits.
pub(super) fn plain(x: f64) -> String {
    if x != 0.0 && !(1e-9..1e16).contains(&x.abs()) { format!("{x:e}") } else { x.to_string() }
}

impl core::error::Error for MotionError {}
