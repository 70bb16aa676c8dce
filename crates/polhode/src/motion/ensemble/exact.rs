//! Closed forms at many times, and the best integrator for what has none.

use super::crew::Share;
use crate::motion::closed_form::ClosedForm;
use crate::motion::simulation::Simulation;
use crate::motion::state::State;
use crate::motion::trajectory::Method;

/// States that are computed before they are put down: they stay in the nearest memory.
const BATCH: usize = 256;

/// Flies each member of a share by the best method for it.
pub(super) fn fly(share: &mut Share<'_>, times: &[f64], tolerance: f64) {
    let mut batch = Vec::new();
    for (k, member) in share.members.iter().enumerate() {
        match ClosedForm::of(&member.rotor, &member.torques, member.start) {
            Ok(motion) => {
                batch.resize(BATCH, member.start);
                evaluate(share, k, &motion, times, &mut batch);
            }
            Err(_) => integrate(share, k, times, tolerance, &mut batch),
        }
        if !share.done(1) {
            return;
        }
    }
}

fn evaluate(share: &mut Share<'_>, member: usize, motion: &ClosedForm, times: &[f64], batch: &mut [State]) {
    for (k, times) in times.chunks(BATCH).enumerate() {
        let states = &mut batch[..times.len()];
        match motion {
            ClosedForm::Free(motion) => motion.fill(times, states),
            _ => states.iter_mut().zip(times).for_each(|(state, &time)| *state = motion.at(time)),
        }
        share.put(member, k * BATCH, states);
    }
}

fn integrate(share: &mut Share<'_>, k: usize, times: &[f64], tolerance: f64, states: &mut Vec<State>) {
    let member = &share.members[k];
    let simulation = Simulation {
        rotor: &member.rotor,
        torques: &member.torques,
        switched_off: &[],
        start: member.start,
        events: &[],
        times,
        method: Method::Auto,
        tolerance,
    };
    states.clear();
    let result = simulation.fill(states);
    share.put(k, 0, states);
    if let Err(cause) = result {
        share.fail(k, states.len(), states.last().copied().unwrap_or(member.start), cause);
    }
}
