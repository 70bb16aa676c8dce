//! Members with a torque that one call computes for all of them.
//!
//! Each member takes its own steps, so that its error control and its bits are those of a single
//! body. A common step would be that of the member with the shortest step. Only the evaluations are
//! synchronised: each call computes one torque for each member, at whatever stage of its step the
//! member is.

use core::mem;
use std::sync::Arc;

use super::motion::MemberMotion;
use super::{EnsembleOutcome, Member, MemberFailure};
use crate::motion::error::MotionError;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;
use crate::motion::model::torque::own::{GivenTorque, MemberState, NOT_KNOWN, VectorizedFunction};
use crate::motion::solve::method::Method;
use crate::motion::solve::propagate::stepper::resumable::Resumable;
use crate::motion::solve::start::{require_few_pulses, require_finite};

/// Number of members computed together; each needs some kilobytes.
const TOGETHER: usize = 1 << 14;

/// Function that stores the motion of a member.
type Put<'a> = dyn FnMut(usize, MemberMotion) + 'a;

/// Function, and the members whose torque it computes, with storage for the results.
struct Shared {
    function: Arc<VectorizedFunction>,
    members: Vec<(usize, Arc<GivenTorque>)>,
}

impl Shared {
    /// Computes the torque of each member for which `state` returns a state.
    fn compute(&self, first: usize, members: &[Member], state: &dyn Fn(usize) -> Option<State>) {
        let known = self.members.iter().filter_map(|(k, given)| Some((*k, given, state(*k)?)));
        let (places, asked): (Vec<_>, Vec<_>) = known
            .map(|(k, given, state)| {
                (given, MemberState { member: first + k, rotor: &members[k].rotor, state })
            })
            .unzip();
        if asked.is_empty() {
            return;
        }
        let found = (self.function)(&asked);
        // A list of the wrong length is treated as no result, because the missing member is not
        // known.
        let is_whole = found.len() == places.len();
        for (k, place) in places.into_iter().enumerate() {
            place.set(found.get(k).copied().filter(|_| is_whole).unwrap_or(NOT_KNOWN));
        }
    }
}

/// Returns true for a member that is computed separately: events, or half turns of torsions, are
/// located within each of its steps.
fn is_alone(member: &Member) -> bool {
    member.is_watched() || member.torques.iter().any(|torque| torque.model().rest().is_some())
}

/// Returns true if one call computes the torque of many members.
pub(super) fn is_shared(torque: &TorqueModel) -> bool {
    function_of(torque).is_some()
}

fn function_of(torque: &TorqueModel) -> Option<&Arc<VectorizedFunction>> {
    match torque {
        TorqueModel::Own(own) => own.vectorized_function(),
        _ => None,
    }
}

/// Returns the torques of each member, and the shared functions. A shared torque is replaced by
/// storage for its value.
///
/// A member that is computed separately calls the function for itself alone: while an event is
/// located, the other members do not move.
fn with_places(first: usize, members: &[Member]) -> (Vec<Vec<TorqueModel>>, Vec<Shared>) {
    let mut shared: Vec<Shared> = Vec::new();
    let torques = members.iter().enumerate().map(|(k, member)| {
        let torques = member.torques.iter().map(|torque| {
            let (TorqueModel::Own(own), Some(function)) = (torque, function_of(torque)) else {
                return torque.clone();
            };
            if is_alone(member) {
                return TorqueModel::Own(own.alone(first + k));
            }
            let given = Arc::new(GivenTorque::default());
            let place = (k, Arc::clone(&given));
            match shared.iter_mut().find(|other| Arc::ptr_eq(&other.function, function)) {
                Some(other) => other.members.push(place),
                None => shared.push(Shared { function: Arc::clone(function), members: vec![place] }),
            }
            TorqueModel::Own(own.given(&given))
        });
        torques.collect()
    });
    (torques.collect(), shared)
}

/// Checks the start of each member, and its torque there.
///
/// # Errors
/// The errors of [`super::Ensemble::new`], for the first member whose start, or whose torque there,
/// is not finite.
pub(super) fn require_starts(members: &[Member]) -> Result<(), MemberFailure> {
    for (block, members) in members.chunks(TOGETHER).enumerate() {
        let first = block * TOGETHER;
        let (torques, shared) = with_places(first, members);
        for function in &shared {
            function.compute(first, members, &|k| Some(members[k].start));
        }
        for (k, (member, torques)) in members.iter().zip(&torques).enumerate() {
            require_finite(&member.rotor, torques, &member.switched_off, &member.start)
                .map_err(|cause| MemberFailure { member: first + k, cause })?;
        }
    }
    Ok(())
}

/// Computes all members at the times and stores the states in the order of the members. Returns
/// their failures, stops and events.
///
/// # Errors
/// [`MotionError::Cancelled`] if `progress` returned false.
pub(super) fn fill<S: From<State>>(
    members: &[Member],
    times: &[f64],
    by: (Method, f64),
    states: &mut [S],
    progress: &mut dyn FnMut(usize) -> bool,
) -> Result<EnsembleOutcome, MotionError> {
    let mut outcome = EnsembleOutcome::default();
    let blocks = members.chunks(TOGETHER).zip(states.chunks_mut(TOGETHER.saturating_mul(times.len())));
    for (block, (members, states)) in blocks.enumerate() {
        let first = block * TOGETHER;
        let mut put = |k: usize, motion: MemberMotion| {
            let places = states.iter_mut().skip(k * times.len());
            for (place, state) in places.zip(motion.at_all(times.len(), members[k].start)) {
                *place = S::from(state);
            }
            outcome.add(first + k, motion);
        };
        compute(first, members, times, by, &mut put, progress)?;
    }
    Ok(outcome.sorted())
}

/// Computes some members together.
fn compute(
    first: usize,
    members: &[Member],
    times: &[f64],
    by: (Method, f64),
    put: &mut Put<'_>,
    progress: &mut dyn FnMut(usize) -> bool,
) -> Result<(), MotionError> {
    let (torques, mut shared) = with_places(first, members);
    for function in &shared {
        function.compute(first, members, &|k| Some(members[k].start));
    }
    let mut done = first;
    let mut motions: Vec<(usize, Resumable<'_>)> = Vec::with_capacity(members.len());
    for (k, (member, torques)) in members.iter().zip(&torques).enumerate() {
        let Member { rotor, start, .. } = member;
        if is_alone(member) {
            let motion = MemberMotion::watched(member, torques, times, by, &mut || progress(done));
            put(k, motion.ok_or(MotionError::Cancelled { done })?);
            done += 1;
            continue;
        }
        if !torques.iter().any(is_shared) {
            put(k, MemberMotion::alone(member, torques, times, by));
            done += 1;
            continue;
        }
        let span = [start.time, times.last().copied().unwrap_or(start.time)];
        let made = require_few_pulses(rotor, torques, &|_| false, span)
            .map_err(|cause| (Vec::new(), cause))
            .and_then(|()| Resumable::new(rotor, torques, *start, times, by.1));
        match made {
            Ok(motion) => motions.push((k, motion)),
            Err((states, cause)) => {
                put(k, MemberMotion::of_states(states, Some(cause)));
                done += 1;
            }
        }
    }
    let mut wanted: Vec<Option<State>> = vec![None; members.len()];
    loop {
        let before = motions.len();
        motions.retain_mut(|(k, motion)| {
            wanted[*k] = motion.wanted();
            if wanted[*k].is_none() {
                put(*k, MemberMotion::of_states(mem::take(&mut motion.states), None));
            }
            wanted[*k].is_some()
        });
        done += before - motions.len();
        if !progress(done) {
            return Err(MotionError::Cancelled { done });
        }
        if motions.is_empty() {
            return Ok(());
        }
        for function in &mut shared {
            function.members.retain(|(k, _)| wanted[*k].is_some());
            function.compute(first, members, &|k| wanted[k]);
        }
        let before = motions.len();
        motions.retain_mut(|(k, motion)| {
            let failed = motion.resume().err();
            let goes_on = failed.is_none();
            if let Some(cause) = failed {
                wanted[*k] = None;
                put(*k, MemberMotion::of_states(mem::take(&mut motion.states), Some(cause)));
            }
            goes_on
        });
        done += before - motions.len();
    }
}
