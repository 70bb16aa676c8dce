//! Computation of members: closed forms at many times, and high-order integrators for all others.

use std::sync::Arc;

use super::Member;
use super::motion::MemberMotion;
use super::prepared::Prepared;
use super::workers::Portion;
use crate::motion::model::state::State;
use crate::motion::solve::closed_form::ClosedForm;
use crate::motion::solve::method::Method;
use crate::motion::solve::propagate::taylor;

/// Number of states of a closed form per batch. A batch fits into the L1 cache.
const BATCH: usize = 256;

/// Up to this number, states of a closed form are computed faster one by one.
const FEW: usize = 4;

/// Number of states of bodies in one batch: some megabytes.
const MANY: usize = 1 << 16;

/// Least number of bodies in a batch. Fewer would leave lanes idle.
const FEWEST: usize = 8;

/// Up to this number, bodies of a kind are computed faster one by one than in lanes.
const FEW_BODIES: usize = 2;

/// Computes each member of a portion by a method. Members for batches of Taylor's method are
/// computed last.
pub(super) fn compute(portion: &mut Portion<'_>, times: &[f64], tolerance: f64, method: Method) {
    let (members, prepared) = (portion.members, portion.prepared);
    let mut states = Vec::new();
    let mut body = None;
    let mut kinds: Vec<Vec<(usize, taylor::BatchBody<'_>)>> = Vec::new();
    let mut last: Option<taylor::BatchBody<'_>> = None;
    for (k, member) in members.iter().enumerate() {
        let Member { rotor, torques, start, .. } = member;
        if member.is_watched() {
            let goes_on = &mut || portion.done(0);
            let motion = MemberMotion::watched(member, torques, times, (method, tolerance), goes_on);
            let Some(motion) = motion else { return };
            portion.put_motion(k, motion);
            if !portion.done(1) {
                return;
            }
            continue;
        }
        let anew = Prepared::default();
        let prepared = prepared.get(k).unwrap_or(&anew);
        let closed = if method == Method::Auto { prepared.closed(member, &mut body) } else { None };
        let in_lanes = closed.is_none() && matches!(method, Method::Auto | Method::Taylor);
        let acting = if in_lanes { prepared.acting(member, last.as_ref()) } else { None };
        if let Some(motion) = closed {
            states.resize(BATCH, *start);
            evaluate(portion, k, motion, times, &mut states);
        } else if let Some(acting) = acting {
            let body = taylor::BatchBody::new(rotor, torques, *start, Arc::clone(acting));
            last = Some(body.clone());
            let same = |bodies: &&mut Vec<(usize, taylor::BatchBody<'_>)>| {
                bodies.first().is_some_and(|(_, first)| first.is_like(&body))
            };
            match kinds.iter_mut().find(same) {
                Some(bodies) => bodies.push((k, body)),
                None => kinds.push(vec![(k, body)]),
            }
            continue;
        } else {
            portion.put_motion(k, MemberMotion::alone(member, torques, times, (method, tolerance)));
        }
        if !portion.done(1) {
            return;
        }
    }
    for bodies in kinds {
        if bodies.len() <= FEW_BODIES {
            for body in bodies {
                by_itself(portion, body, times, tolerance, &mut states);
                if !portion.done(1) {
                    return;
                }
            }
            continue;
        }
        for bodies in bodies.chunks((MANY / times.len()).max(FEWEST)) {
            expand(portion, bodies, times, tolerance, &mut states);
            if !portion.done(bodies.len()) {
                return;
            }
        }
    }
}

fn evaluate(portion: &mut Portion<'_>, k: usize, motion: &ClosedForm, times: &[f64], states: &mut [State]) {
    let (known, beyond) = match motion.require(times) {
        Ok(()) => (times, None),
        Err(cause) => {
            let is_known = |time: &&f64| motion.require(core::slice::from_ref(*time)).is_ok();
            (times.get(..times.iter().take_while(is_known).count()).unwrap_or_default(), Some(cause))
        }
    };
    let mut from = 0;
    for times in known.chunks(BATCH) {
        match motion {
            ClosedForm::Free(motion) if times.len() > FEW => motion.fill(times, states),
            _ if times.len() > FEW => states.iter_mut().zip(motion.at_times(times)).for_each(|(a, b)| *a = b),
            _ => states.iter_mut().zip(times).for_each(|(state, &time)| *state = motion.at(time)),
        }
        portion.put(k, from, states.get(..times.len()).unwrap_or_default());
        from += times.len();
    }
    if let Some(cause) = beyond {
        let last = known.last().map_or(motion.start(), |&time| motion.at(time));
        portion.fail(k, from, last, cause);
    }
}

/// Computes a member by Taylor's method, by itself.
fn by_itself(
    portion: &mut Portion<'_>,
    (k, body): (usize, taylor::BatchBody<'_>),
    times: &[f64],
    tolerance: f64,
    states: &mut Vec<State>,
) {
    let motion = MemberMotion::of_acting(&portion.members[k], &body.acting, times, tolerance);
    if motion.ending.is_complete() {
        portion.put_motion(k, motion);
    } else {
        // A lane also has the last good state, between two times.
        expand(portion, &[(k, body)], times, tolerance, states);
    }
}

/// Computes a batch of members by Taylor's method in SIMD lanes.
fn expand(
    portion: &mut Portion<'_>,
    bodies: &[(usize, taylor::BatchBody<'_>)],
    times: &[f64],
    tolerance: f64,
    states: &mut Vec<State>,
) {
    let Some((first, _)) = bodies.first() else { return };
    states.resize(bodies.len() * times.len(), portion.members[*first].start);
    let subjects = || bodies.iter().map(|(_, body)| body);
    let mut failures = taylor::advance(subjects(), times, tolerance, states).into_iter().peekable();
    for (n, ((k, _), states)) in bodies.iter().zip(states.chunks(times.len())).enumerate() {
        portion.put(*k, 0, states);
        if let Some((_, cause)) = failures.next_if(|(body, _)| *body == n) {
            portion.give_up(*k, cause);
        }
    }
    states.clear();
}
