//! Step 5 with torques, or for a prescribed motion.

use polhode::body::Symmetry;
use polhode::motion::{Sample, Solution, Trajectory};
use polhode_document::Section;
use polhode_document::number::{number, tidy_beside, without_noise};

use super::working::{Working, cells, n, v};
use crate::report::facts::ending_in_words;

/// Writes the torque along a prescribed motion, which needs no solution.
pub(crate) fn given(w: &Working<'_>, s: &mut Section) {
    s.say("The motion is prescribed, so ω(t) is known (step 2), and the equations give the torque instead.");
    if !w.rows.samples.is_empty() {
        s.say(format!("The torque along the motion, in body axes{}:", w.rows.words));
        table(w, true, s);
    }
}

/// Writes the integrated equation, and ω(t).
pub(crate) fn integrate(w: &Working<'_>, s: &mut Section) {
    if w.rotor.principal().symmetry() == Symmetry::Point {
        s.say("There is nothing to solve: all the mass is at the reference point.");
        return;
    }
    // The closed form has been written before.
    if !matches!(w.trajectory.as_deref().map(Trajectory::solution), Some(Solution::ClosedForm(_))) {
        s.say("What is integrated:");
        s.formula(
            "dω/dt = {I}⁻¹ (N − ω × {I} ω)",
            r"\dot{\boldsymbol\omega} = \lbrace \mathbf I \rbrace^{-1} \left( \mathbf N - \boldsymbol\omega \times \lbrace \mathbf I \rbrace \boldsymbol\omega \right)",
        );
    }
    match how(w) {
        Some(how) => {
            let held = if w.pendulum.is_some() { "With the pivot held, in three dimensions: " } else { "" };
            s.say(format!("{held}ω(t) {how}{}:", w.rows.words));
            let ending = w.trajectory.as_deref().and_then(|t| ending_in_words(t, w.scenario));
            if let Some(ending) = ending {
                s.say(format!("The run is {ending}."));
            }
            table(w, true, s);
            work(w, s);
        }
        None => {
            s.say(format!(
                "ω changes at {} rad/s² at t0 (step 4). Add [run] to the scenario to integrate the motion.",
                v(w.acceleration.to_array())
            ));
        }
    }
}

/// Returns how the numbers were found, in words that follow `ω(t)`.
pub(crate) fn how(w: &Working<'_>) -> Option<String> {
    Some(match w.trajectory.as_ref()?.solution() {
        Solution::ClosedForm(_) => "in closed form".to_owned(),
        Solution::Prescribed(_) => "as given".to_owned(),
        solution => {
            let error = match (solution, solution.tolerance()) {
                (Solution::Splitting { order, step, .. }, _) => {
                    format!("order {}, steps of {} s", order.number(), number(*step, 3))
                }
                (_, Some(tolerance)) => format!("error of each step below {}", number(tolerance, 3)),
                (_, None) => String::new(),
            };
            format!("by numerical integration ({}, {error})", solution.title())
        }
    })
}

/// Writes ω, and N if there is one, at the instants of [`Working::rows`].
pub(crate) fn table(w: &Working<'_>, torque: bool, s: &mut Section) {
    let samples = &w.rows.samples;
    // Rows before the end have smaller errors than the end.
    let error = w.error();
    let [omega_noise, torque_noise] = [error.omega, error.attitude].map(|error| error.min(MOST_NOISE));
    let largest = |f: &dyn Fn(&Sample) -> f64| samples.iter().map(f).fold(0.0, f64::max);
    let (most_omega, most_torque) = (largest(&|x| x.state.omega.norm()), largest(&|x| x.torque.norm()));
    let most_energy = largest(&|x| x.kinetic_energy);
    let row = |x: &Sample| {
        let mut row = vec![x.state.time];
        row.extend(without_noise(x.state.omega.to_array(), most_omega, omega_noise));
        if torque {
            row.extend(without_noise(x.torque.to_array(), most_torque, torque_noise));
        }
        row.push(without_noise([x.kinetic_energy, 0.0, 0.0], most_energy, omega_noise)[0]);
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

/// Largest relative error that is treated as noise in all rows.
const MOST_NOISE: f64 = 1e-9;

/// Writes the work of the torque and the gain in kinetic energy, which must agree.
fn work(w: &Working<'_>, s: &mut Section) {
    let samples = w.trajectory.as_ref().map_or(&[][..], |trajectory| trajectory.samples());
    let (Some(first), Some(last)) = (samples.first(), samples.last()) else { return };
    let gain = last.kinetic_energy - first.kinetic_energy;
    let scale = last.kinetic_energy.max(first.kinetic_energy);
    let [work, gain] = [last.work, gain].map(|x| tidy_beside([x, 0.0, 0.0], scale)[0]);
    s.line(format!("work of the torque ∫ N · ω dt = {} J;  T(end) - T(start) = {} J", n(work), n(gain)));
}
