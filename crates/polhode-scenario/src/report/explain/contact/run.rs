//! Step 6 on the ground: the computed motion, and its accuracy.

use polhode::math::{Body, Direction};
use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{ContactEvent, ContactState};
use polhode::motion::{Series, Trajectory};
use polhode_document::Section;
use polhode_document::number::error;

use super::super::attitude;
use super::super::working::{cells, n};
use super::OnGround;
use crate::report::facts::ending_in_words;

/// Largest number of listed changes of contact.
const MOST: usize = 12;

/// Number of rows of the table.
const ROWS: usize = 9;

pub(crate) fn section(g: &OnGround<'_, '_>) -> Section {
    let mut s = Section::new(6, "What the run shows");
    let Some(motion) = g.motion().filter(|motion| !motion.samples().is_empty()) else {
        s.say("Without [run] the motion is not computed any further.");
        attitude::attitude(&g.start.state, 0.0, "t0", &mut s);
        return s;
    };
    s.say(format!(
        "The equations of step 4 are integrated, with the attitude by x\u{307} = ω × x of its axes, by {}; where rolling, sliding and flying change is found as a root of a series.",
        motion.solution().title()
    ));
    changes(g, motion.changes(), &mut s);
    if let Some(ending) = g.w.trajectory.as_deref().and_then(|t| ending_in_words(t, g.w.scenario)) {
        s.say(format!("The run is {ending}."));
    }
    let states: Vec<ContactState> = motion.channel(CONTACT).into_iter().flat_map(Series::iter).collect();
    table(g, &states, &mut s);
    if let Some(last) = states.last() {
        attitude::attitude(&last.state, g.w.error().attitude, "end", &mut s);
    }
    s.say("Checks of the conserved quantities, relative, at the worst sample of the run:");
    s.line(format!(
        "T + U minus the work of friction and of the ground constant to {}",
        error(motion.energy_drift())
    ));
    if let Some(estimate) = g.w.trajectory.as_deref().and_then(Trajectory::error) {
        let end = estimate.end();
        s.line(format!(
            "estimated error at the end: attitude {} rad, ω {} (relative)",
            error(end.attitude),
            error(end.omega)
        ));
    }
    s
}

fn changes(g: &OnGround<'_, '_>, all: &[ContactEvent], s: &mut Section) {
    let phase = g.start.phase.name();
    if all.is_empty() {
        s.say(format!("It is {phase} throughout."));
        return;
    }
    s.say(format!("It is {phase} at first, and then:"));
    for event in all.iter().take(MOST) {
        s.line(format!("t = {} s: {}", n(event.time), event.change));
    }
    if all.len() > MOST {
        s.line(format!("… and {} more", all.len() - MOST));
    }
}

/// Writes a table of a few times: inclination of the axis, rates about the axis and the normal,
/// forces, and energy.
fn table(g: &OnGround<'_, '_>, samples: &[ContactState], s: &mut Section) {
    let few: Vec<ContactState> = if samples.len() <= ROWS {
        samples.to_vec()
    } else {
        (0..ROWS).map(|k| samples[k * (samples.len() - 1) / (ROWS - 1)]).collect()
    };
    s.say(format!(
        "{} samples, evenly spaced over the run; the motion between them is not shown:",
        few.len()
    ));
    let axis = g.axis().filter(|_| !super::bowl::is_even_ball(g));
    let tilt = |x: &ContactState, e: Direction<Body>| (x.state.attitude * e).angle_to(x.normal).to_degrees();
    let rows: Vec<Vec<f64>> = few
        .iter()
        .map(|x| {
            let up = x.state.attitude.inverse() * x.normal;
            let mut row = vec![x.state.time];
            if let Some(e) = axis {
                row.extend([tilt(x, e), e.dot(x.state.omega)]);
            }
            row.extend([
                up.dot(x.state.omega),
                x.velocity.norm(),
                x.slip.norm(),
                x.normal_force,
                x.kinetic_energy + x.potential_energy,
            ]);
            row
        })
        .map(tidied)
        .collect();
    let mut headers = vec!["t (s)"];
    if axis.is_some() {
        headers.extend(["(e, n) (°)", "ω·e (rad/s)"]);
    }
    headers.extend(["ω·n (rad/s)", "|v| (m/s)", "|u| (m/s)", "N (N)", "T + U (J)"]);
    s.table(&headers, cells(&rows));
}

/// Returns the row with rounding errors set to 0.
fn tidied(row: Vec<f64>) -> Vec<f64> {
    row.into_iter().map(|x| if x.abs() < 1e-13 { 0.0 } else { x }).collect()
}
