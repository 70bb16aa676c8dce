//! Ensembles: many bodies, each with its own start and torques, at the same times.
//!
//! - `workers` distributes portions of the members to threads.
//! - `advance` computes a portion: closed forms, Taylor's method in batches, and all other members
//!   one by one.
//! - `in_step` computes members with a torque that one call computes for all.

mod advance;
mod in_step;
mod member;
mod motion;
mod outcome;
mod prepared;
mod workers;

use core::num::NonZero;
use std::sync::OnceLock;

use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::state::State;
use crate::motion::solve::limits::require_tolerance;
use crate::motion::solve::method::Method;
use crate::motion::solve::start::{require_ascending, require_finite};
pub use member::{Member, MemberCrossing, MemberFailure, MemberStop};
pub use outcome::EnsembleOutcome;
use workers::Workers;

/// Up to this number, states of known closed forms are computed on one thread.
const FEW_STATES: usize = 2048;

/// States of the members of an ensemble at given times.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EnsembleStates {
    /// States, member by member, and time by time within each member. A member that failed repeats
    /// its last good state; one that an event stopped repeats its state at the event. The time of a
    /// state tells which.
    pub states: Vec<State>,
    /// See [`EnsembleOutcome::failures`].
    pub failures: Vec<MemberFailure>,
    /// See [`EnsembleOutcome::stops`].
    pub stops: Vec<MemberStop>,
    /// See [`EnsembleOutcome::crossings`].
    pub crossings: Vec<MemberCrossing>,
}

/// Many independent bodies, computed in SIMD lanes and on several threads.
///
/// Every state is bit-identical for any number of threads, any vector width, and any other members.
/// Members with a
/// [`TorqueModel::vectorized_function`](crate::motion::torque::TorqueModel::vectorized_function)
/// are computed on the calling thread, with one call for all of them.
///
/// The preparation of a closed form takes microseconds. The first call with [`Method::Auto`] does
/// not keep the closed forms; the second call keeps them, about 1 kB per member. Repeated calls are
/// therefore fast, and an ensemble that is used once stays small.
/// [`FreeMotions`](crate::motion::solve::free::FreeMotions) evaluates many free motions at one
/// time, several times faster.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::{Ensemble, Member};
/// use std::num::NonZero;
/// let body = MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([1.0, 2.0, 2.5])?)?;
/// let torque = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, 0.5)));
/// let start = |spin| State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.0, 0.0, spin) };
/// let member = |spin: f64| Member::new(Rotor::free(&body), vec![torque.clone()], start(spin));
/// let ensemble = Ensemble::new((0..100).map(|k| member(f64::from(k))).collect())?;
/// let found = ensemble.at(&[1.0, 2.0], Method::Auto, 1e-12, NonZero::<usize>::MIN)?;
/// // Two times each: ω of member 41 at t = 2 s is 41 rad/s + N t/i3.
/// assert!((found.states[2 * 41 + 1].omega.z - (41.0 + 0.5 * 2.0 / 2.5)).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// An event that stops a member does not stop the others:
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::{Ensemble, Event, EventAction, Measure, Member, Sense};
/// use std::num::NonZero;
/// let body = MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([1.0, 2.0, 2.5])?)?;
/// let torque = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, 0.5)));
/// let rate = Measure::OmegaBody(Direction::new(0.0, 0.0, 1.0));
/// let fast = Event::new("fast", rate, 3.0, Sense::Rising, EventAction::Stop)?;
/// let start = |spin| State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.0, 0.0, spin) };
/// let member = |spin| Member::new(Rotor::free(&body), vec![torque.clone()], start(spin)).watching(vec![fast.clone()]);
/// let ensemble = Ensemble::new(vec![member(1.0), member(2.0)])?;
/// let found = ensemble.at(&[6.0, 8.0], Method::Auto, 1e-12, NonZero::<usize>::MIN)?;
/// let [stop] = found.stops[..] else { return Err("one of them comes so far".into()) };
/// assert!(stop.member == 1 && (stop.time - 5.0).abs() < 1e-12);
/// assert_eq!(found.states[3].time, stop.time);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Ensemble {
    members: Vec<Member>,
    /// True if one call computes a torque of many members.
    is_in_step: bool,
    /// Closed form and decomposed torques of each member, kept from the second call on.
    prepared: Vec<prepared::Prepared>,
    /// Set by the first call that uses them.
    asked: OnceLock<()>,
    /// Latest start time, s.
    latest: f64,
}

impl Ensemble {
    /// Creates an ensemble.
    ///
    /// # Errors
    /// The failure of the first member that cannot start:
    ///
    /// - a parameter error ([`MotionError::is_parameter`]) for a start or a torque that is not
    ///   finite, and for an event that cannot be measured;
    /// - [`MotionError::NotSpinnable`] for a body without inertia.
    pub fn new(members: Vec<Member>) -> Result<Self, MemberFailure> {
        let is_in_step = members.iter().any(|member| member.torques.iter().any(in_step::is_shared));
        if is_in_step {
            in_step::require_starts(&members)?;
        }
        for (member, Member { rotor, torques, switched_off, start, events }) in members.iter().enumerate() {
            let of_member = |cause| MemberFailure { member, cause };
            if !is_in_step {
                require_finite(rotor, torques, switched_off, start).map_err(of_member)?;
            }
            if !rotor.is_spinnable() {
                return Err(of_member(MotionError::NotSpinnable));
            }
            for event in events {
                event.require_possible(rotor, torques, events, start).map_err(of_member)?;
            }
        }
        let latest = members.iter().map(|member| member.start.time).fold(f64::NEG_INFINITY, f64::max);
        let prepared = vec![prepared::Prepared::default(); members.len()];
        Ok(Self { members, is_in_step, prepared, asked: OnceLock::new(), latest })
    }

    /// Returns the members as given.
    pub fn members(&self) -> &[Member] {
        &self.members
    }

    /// Returns the number of members.
    pub const fn len(&self) -> usize {
        self.members.len()
    }

    /// Returns true if the ensemble is empty.
    pub const fn is_empty(&self) -> bool {
        self.members.is_empty()
    }

    /// Returns the largest number of threads that can share the work.
    pub const fn most_threads(&self) -> usize {
        self.members.len().div_ceil(workers::PORTION)
    }

    /// Computes every member at each of the times (s, ascending, none before a start) on `threads`
    /// threads.
    ///
    /// The states are bit-identical to those of
    /// [`Simulation::states`](super::simulation::Simulation::states) with this method and
    /// tolerance. For a member with events they are those of
    /// [`Simulation::run`](super::simulation::Simulation::run).
    ///
    /// # Errors
    /// A parameter error ([`MotionError::is_parameter`]) if times are out of order, or the
    /// tolerance is out of its range. Errors of single members are in [`EnsembleStates::failures`].
    pub fn at(
        &self,
        times: &[f64],
        method: Method,
        tolerance: f64,
        threads: NonZero<usize>,
    ) -> Result<EnsembleStates, MotionError> {
        let Some(first) = self.members.first() else {
            return Ok(EnsembleStates::default());
        };
        let mut states = vec![first.start; self.members.len() * times.len()];
        let EnsembleOutcome { failures, stops, crossings } =
            self.fill(times, (method, tolerance), threads, &mut states, &mut |_| true)?;
        Ok(EnsembleStates { states, failures, stops, crossings })
    }

    /// Computes every member like [`Ensemble::at`] and writes the states into a slice, in the same
    /// order. An element of type `[f64; 8]` becomes the row (t, w, x, y, z, ω1, ω2, ω3). Returns
    /// failures, stops and events.
    ///
    /// `progress` receives the number of finished members, repeatedly and at the end, on the
    /// calling thread. If it returns `false`, the computation stops.
    ///
    /// # Errors
    /// - The errors of [`Ensemble::at`].
    /// - A parameter error ([`MotionError::is_parameter`]) if the number of states is not the
    ///   number of members times the number of times.
    /// - [`MotionError::Cancelled`] if `progress` returned `false`. Only some of the states are
    ///   then written.
    pub fn fill<S: From<State> + Send>(
        &self,
        times: &[f64],
        (method, tolerance): (Method, f64),
        threads: NonZero<usize>,
        states: &mut [S],
        progress: &mut dyn FnMut(usize) -> bool,
    ) -> Result<EnsembleOutcome, MotionError> {
        require_tolerance(tolerance)?;
        require_ascending(f64::NEG_INFINITY, times)?;
        if let Some(&first) = times.first() {
            require::that(
                "the first time",
                first,
                first >= self.latest,
                "not before the start of any member",
            )?;
        }
        let (holds, rule) = (
            self.members.len().checked_mul(times.len()) == Some(states.len()),
            "that of members times that of times",
        );
        require::that("the number of states to fill", states.len() as f64, holds, rule)?;
        if states.is_empty() {
            return Ok(EnsembleOutcome::default());
        }
        if self.is_in_step && matches!(method, Method::Auto | Method::Dop853) {
            return in_step::fill(&self.members, times, (method, tolerance), states, progress);
        }
        let again = method == Method::Auto && self.asked.set(()).is_err();
        let prepared = if again { self.prepared.as_slice() } else { &[] };
        // A thread takes longer to start than these states.
        let is_short =
            again && states.len() <= FEW_STATES && self.members.iter().all(|it| it.torques.is_empty());
        let threads = if is_short { NonZero::<usize>::MIN } else { threads };
        Workers::new(threads).fill((&self.members, prepared), times.len(), states, progress, &|portion| {
            advance::compute(portion, times, tolerance, method);
        })
    }
}

/// Converts a state to (t, w, x, y, z, ω1, ω2, ω3): time, attitude R_space_body as a quaternion, ω
/// in body axes.
impl From<State> for [f64; 8] {
    fn from(state: State) -> Self {
        let ([w, x, y, z], [a, b, c]) = (state.attitude.quaternion(), state.omega.to_array());
        [state.time, w, x, y, z, a, b, c]
    }
}
