//! Step 5 with torque, or with the motion given.

use polhode::body::Symmetry;
use polhode::motion::{Method, Sample, Solution, Trajectory};

use super::document::Section;
use super::working::{Working, cells, n, v};
use crate::event;
use crate::number::{tidy_beside, ungrouped};

/// The motion is given: there is nothing to solve, but the torque may change along it.
pub(super) fn given(w: &Working<'_>, s: &mut Section) {
    s.say("The motion is given, so ω(t) is known (step 2); the equations gave the torque instead.");
    let samples = w.few_samples();
    if !samples.is_empty() {
        s.say("The torque along the motion, in body axes:");
        table(&samples, true, s);
    }
}

/// Numerical integration.
pub(super) fn integrate(w: &Working<'_>, s: &mut Section) {
    if w.rotor.principal().symmetry() == Symmetry::Point {
        s.say("There is nothing to solve: all the mass is in the point that it would turn about.");
        return;
    }
    // A closed form has been told.
    if !matches!(w.trajectory.as_deref().map(Trajectory::solution), Some(Solution::Exact(_))) {
        s.say("What is integrated:");
        s.formula(
            "dω/dt = {I}⁻¹ (N − ω × {I} ω)",
            r"\dot{\boldsymbol\omega} = \lbrace \mathbf I \rbrace^{-1} \left( \mathbf N - \boldsymbol\omega \times \lbrace \mathbf I \rbrace \boldsymbol\omega \right)",
        );
    }
    let samples = w.few_samples();
    match how(w) {
        Some(how) => {
            let held = if w.pendulum.is_some() { "With the pivot held, in three dimensions: " } else { "" };
            s.say(format!("{held}ω(t) {how}:"));
            let ending = w.trajectory.as_deref().and_then(|t| event::ending_in_words(t, w.scenario));
            if let Some(ending) = ending {
                s.say(format!("The run is {ending}."));
            }
            table(&samples, true, s);
            work(&samples, s);
        }
        None => {
            s.say(format!(
                "ω changes at {} rad/s² at first (step 4). Give the scenario a [run] to have it integrated.",
                v(w.acceleration.to_array())
            ));
        }
    }
}

/// How the numbers were found, in words that follow `ω(t)`.
pub(super) fn how(w: &Working<'_>) -> Option<String> {
    Some(match w.trajectory.as_ref()?.solution() {
        Solution::Exact(_) => "in closed form".to_owned(),
        Solution::Prescribed(_) => "as given".to_owned(),
        Solution::Integrated { method, tolerance, .. } => {
            let error = match (method, tolerance) {
                (Method::Splitting { order, step }, _) => {
                    format!("order {}, steps of {} s", order.number(), ungrouped(*step, 3))
                }
                (_, Some(tolerance)) => format!("error of each step below {}", ungrouped(*tolerance, 3)),
                (_, None) => String::new(),
            };
            format!("by numerical integration ({}, {error})", method.title())
        }
    })
}

/// ω, and N where there is one, at a few times.
pub(super) fn table(samples: &[Sample], torque: bool, s: &mut Section) {
    let largest = |f: &dyn Fn(&Sample) -> f64| samples.iter().map(f).fold(0.0, f64::max);
    let (most_omega, most_torque) = (largest(&|x| x.state.omega.norm()), largest(&|x| x.torque.norm()));
    let row = |x: &Sample| {
        let mut row = vec![x.state.time];
        row.extend(tidy_beside(x.state.omega.to_array(), most_omega));
        if torque {
            row.extend(tidy_beside(x.torque.to_array(), most_torque));
        }
        row.push(x.kinetic_energy);
        row
    };
    let rows: Vec<Vec<f64>> = samples.iter().map(row).collect();
    let headers: &[&str] = if torque {
        &["t (s)", "ωx (rad/s)", "ωy", "ωz", "Nx (N·m)", "Ny", "Nz", "T (J)"]
    } else {
        &["t (s)", "ωx (rad/s)", "ωy (rad/s)", "ωz (rad/s)", "T (J)"]
    };
    s.table(headers, cells(&rows));
}

/// The work of the torque is the gain in kinetic energy.
fn work(samples: &[Sample], s: &mut Section) {
    let (Some(first), Some(last)) = (samples.first(), samples.last()) else { return };
    let gain = last.kinetic_energy - first.kinetic_energy;
    let scale = last.kinetic_energy.max(first.kinetic_energy);
    let [work, gain] = [last.work, gain].map(|x| tidy_beside([x, 0.0, 0.0], scale)[0]);
    s.line(format!("work of the torque ∫ N · ω dt = {} J;  T(end) - T(start) = {} J", n(work), n(gain)));
}
