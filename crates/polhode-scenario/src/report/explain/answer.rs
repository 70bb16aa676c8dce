//! Answer of a worked solution, printed before the steps.

use polhode::body::Symmetry;
use polhode_document::number::tidy_beside;
use polhode_document::unit::{CLOSED, rate};

use super::inside::Inside;
use super::working::{Working, exactly, n, v};
use crate::report::forces;

/// Largest number of particles whose forces the answer states; for more, only step 4 states them.
const MOST_PARTICLES: usize = 4;

pub(crate) fn lines(w: &Working<'_>, inside: Option<&Inside<'_, '_>>) -> Vec<String> {
    let mut lines = vec![body(w)];
    if let Some(pendulum) = &w.pendulum {
        let (frequency, period) = (pendulum.small_frequency(), pendulum.period(0.0));
        lines.push(format!(
            "It swings at ω0 = {}, period {} s for small swings.",
            rate(frequency),
            n(period)
        ));
    }
    if let Some(inside) = inside {
        lines.push(inside.answer());
    } else if w.needed.is_some() {
        lines.extend(needed(w));
    } else if w.is_free() {
        lines.extend(free(w));
    } else if w.is_turning() || w.torque.norm() > 0.0 {
        let line = format!(
            "N = {} N·m at t0 changes ω at {} rad/s², in body axes.",
            v(w.torque.to_array()),
            v(w.acceleration.to_array())
        );
        lines.push(line);
    }
    lines
}

pub(crate) fn body(w: &Working<'_>) -> String {
    let principal = w.rotor.principal();
    let mass = n(w.body().mass());
    if principal.symmetry() == Symmetry::Point {
        return format!("M = {mass} kg in one point: zero inertia about {}.", w.point_name());
    }
    let moments = principal.moments().map(n).join(", ");
    format!(
        "M = {mass} kg; principal moments about {} i1, i2, i3 = {moments} kg·m² ({}).",
        w.point_name(),
        principal.symmetry().name()
    )
}

fn needed(w: &Working<'_>) -> Vec<String> {
    let Some(needed) = &w.needed else { return Vec::new() };
    let [_, _, i3] = w.rotor.principal().moments();
    let scale = i3 * w.start.omega.dot(w.start.omega).max(w.acceleration.norm());
    let torque = exactly(tidy_beside(needed.torque.to_array(), scale));
    let when =
        if needed.state.time == 0.0 { String::new() } else { format!(" at t = {} s", n(needed.state.time)) };
    let mut lines =
        vec![format!("The motion requires N = {torque} N·m about {} in body axes{when}.", w.point_name())];
    let forces = forces::on_particles(w.scenario, needed);
    if (1..=MOST_PARTICLES).contains(&forces.len()) {
        let each: Vec<String> = forces
            .iter()
            .enumerate()
            .map(|(k, f)| format!("F{} = {} N", k + 1, v(f.force.to_array())))
            .collect();
        lines.push(format!("The forces on the particles: {}.", each.join(", ")));
    }
    lines
}

fn free(w: &Working<'_>) -> Option<String> {
    if !w.is_turning() || w.rotor.principal().symmetry() == Symmetry::Point {
        return None;
    }
    let free = w.at_start.as_ref()?;
    if let Some((_, cones)) = &free.top {
        if cones.body_half_angle < CLOSED {
            return Some(
                "A symmetric top that rotates about its symmetry axis: ω is constant, in the body and in space."
                    .to_owned(),
            );
        }
        return Some(format!(
            "A symmetric top: ω circles the symmetry axis at Ω = {} rad/s in the body, on a cone of {}°; both circle L \
             at {} rad/s in space, ω on a cone of {}°.",
            n(cones.body_rate),
            n(cones.body_half_angle.to_degrees()),
            n(cones.space_rate),
            n(cones.space_half_angle.to_degrees())
        ));
    }
    let period =
        free.regime.period.map_or_else(String::new, |p| format!("; ω repeats in the body every {} s", n(p)));
    Some(format!("Free motion: {}{period}.", free.regime.regime.description()))
}
