//! Step 6: the attitude.

use polhode::body::Symmetry;
use polhode::motion::{Regime, State, Trajectory};
use polhode::observe::Drift;

use super::document::Section;
use super::working::{Working, n, v};
use crate::number::error;

pub(super) fn section(w: &Working<'_>) -> Section {
    let mut s = Section::new(6, "Solve for the attitude");
    if w.rotor.principal().symmetry() == Symmetry::Point {
        s.say("A point has no attitude.");
        return s;
    }
    s.say("The body axes turn with ω; R takes body components to space components, and carries all three of them:");
    s.formula(
        "dx̂i/dt = ω × x̂i   or   dR/dt = R [ω]×   or   dq/dt = ½ q ω      (ω in body axes)",
        r"\frac{d\hat{\mathbf x}_i}{dt} = \boldsymbol\omega \times \hat{\mathbf x}_i \quad\text{or}\quad \dot R = R [\boldsymbol\omega]_\times \quad\text{or}\quad \dot q = \tfrac12 q \boldsymbol\omega",
    );
    match w.at_start.as_ref().filter(|_| w.is_free()) {
        Some(free) if free.regime.regime == Regime::AtRest => s.say("With ω = 0 it stays R(t0)."),
        Some(free) if matches!(free.regime.regime, Regime::Permanent(_)) => {
            s.formula(
                "R(t) = R(t0) · turn(ω̂, |ω| (t − t0))",
                r"R(t) = R(t_0) \operatorname{turn}\bigl(\hat{\boldsymbol\omega}, |\boldsymbol\omega| (t - t_0)\bigr)",
            );
        }
        Some(free) if let Some((top, _)) = &free.top => {
            s.say("For the symmetric top the solution is two turns at constant rates, one in space and one in the body:");
            s.formula(
                "R(t) = turn(L̂, φ\u{307} (t − t0)) · R(t0) · turn(e, −Ω (t − t0))",
                r"R(t) = \operatorname{turn}\bigl(\hat{\mathbf L}, \dot\varphi (t - t_0)\bigr) R(t_0) \operatorname{turn}\bigl(\mathbf e, -\Omega (t - t_0)\bigr)",
            );
            s.line(format!("L̂ = {} in space axes", v(top.momentum_direction().to_array())));
        }
        _ => {}
    }
    let end = w.trajectory.as_ref().and_then(|t| t.samples().last());
    match end {
        Some(last) => {
            attitude(&last.state, "end", &mut s);
            evidence(w, &mut s);
        }
        None => {
            attitude(&w.start, "t0", &mut s);
            if w.is_turning() || w.torque.norm() > 0.0 {
                s.say("Without a [run] the attitude is followed no further.");
            }
        }
    }
    s
}

fn attitude(state: &State, when: &str, s: &mut Section) {
    s.matrix(format!("R({when})"), state.attitude.matrix(), "");
    let q = state.attitude.canonical_quaternion().map(n).join(", ");
    let [phi, theta, psi] = state.attitude.euler313();
    if when == "end" {
        s.line(format!("t = {} s", n(state.time)));
    }
    s.line(format!("quaternion  w, x, y, z = {q}"));
    s.line(format!("Euler 3-1-3 φ, θ, ψ = {}, {}, {} rad", n(phi), n(theta), n(psi)));
    let [phi, theta, psi] = [phi, theta, psi].map(|a| n(a.to_degrees()));
    s.line(format!("                    = {phi}°, {theta}°, {psi}°"));
}

/// How good the run is.
fn evidence(w: &Working<'_>, s: &mut Section) {
    if w.needed.is_some() {
        return;
    }
    let Some(drift) = w.trajectory.as_deref().and_then(Drift::of) else { return };
    s.say("Evidence: what must hold whatever the solution is, relative, at the worst sample of the run:");
    if w.is_free() {
        s.line(format!("T constant to {}", error(drift.kinetic_energy)));
        s.line(format!("L constant in space to {}", error(drift.momentum)));
    } else {
        s.line(format!("T - T(t0) = work of the torque to {}", error(drift.work_energy)));
        s.line(format!("L - L(t0) = ∫ N dt in space to {}", error(drift.momentum)));
        if let Some(total) = drift.total_energy {
            s.line(format!("T + U constant to {}", error(total)));
        }
    }
    if let Some(estimate) = w.trajectory.as_deref().and_then(Trajectory::error) {
        let end = estimate.end();
        s.line(format!(
            "estimated error at the end: attitude {} rad, ω {} of itself",
            error(end.attitude),
            error(end.omega)
        ));
    }
}
