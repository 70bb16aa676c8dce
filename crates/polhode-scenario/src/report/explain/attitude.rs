//! Step 6: the attitude.

use std::f64::consts::{PI, TAU};

use polhode::body::Symmetry;
use polhode::math::Attitude;
use polhode::motion::{FreeMotion, Regime, State, Trajectory};
use polhode::observe::{Drift, SymmetricTop};
use polhode_document::Section;
use polhode_document::number::{error, quaternion, without_noise};

use super::inside::Inside;
use super::working::{DIGITS, Working, n, v};

pub(crate) fn section(w: &Working<'_>, inside: Option<&Inside<'_, '_>>) -> Section {
    let mut s = Section::new(6, "Solve for the attitude");
    if w.rotor.principal().symmetry() == Symmetry::Point {
        s.say("A point has no attitude.");
        return s;
    }
    let turning = if w.has_sink() { "Ω" } else { "ω" };
    s.say(format!("The body axes rotate with {turning}; R maps body components to space components, and its columns are the three axes:"));
    match inside {
        Some(inside) => inside.attitude_formula(&mut s),
        None => s.formula(
            "dx̂i/dt = ω × x̂i   or   dR/dt = R [ω]×   or   dq/dt = ½ q ω      (ω in body axes)",
            r"\frac{d\hat{\mathbf x}_i}{dt} = \boldsymbol\omega \times \hat{\mathbf x}_i \quad\text{or}\quad \dot R = R [\boldsymbol\omega]_\times \quad\text{or}\quad \dot q = \tfrac12 q \boldsymbol\omega",
        ),
    }
    match w.at_start.as_ref().filter(|_| w.is_free()) {
        Some(free) if free.regime.regime == Regime::AtRest => s.say("With ω = 0 it stays R(t0)."),
        Some(free) if matches!(free.regime.regime, Regime::Permanent(_)) => {
            s.formula(
                "R(t) = R(t0) · turn(ω̂, |ω| (t − t0))",
                r"R(t) = R(t_0) \operatorname{turn}\left(\hat{\boldsymbol\omega}, |\boldsymbol\omega| (t - t_0)\right)",
            );
        }
        Some(free) if let Some((top, _)) = &free.top => {
            s.say("For the symmetric top the solution is a product of two rotations at constant rates, one in space and one in the body:");
            s.formula(
                "R(t) = turn(L̂, φ\u{307} (t − t0)) · R(t0) · turn(e, −Ω (t − t0))",
                r"R(t) = \operatorname{turn}\left(\hat{\mathbf L}, \dot\varphi (t - t_0)\right) R(t_0) \operatorname{turn}\left(\mathbf e, -\Omega (t - t_0)\right)",
            );
            s.line(format!("L̂ = {} in space axes", v(top.momentum_direction().to_array())));
            symmetric_angles(w, top, &mut s);
        }
        Some(free) if let Some(circled) = circled(free.regime.regime) => {
            asymmetric_angles(w, &free.motion, circled, &mut s);
        }
        _ => {}
    }
    let end = w.trajectory.as_ref().and_then(|t| t.samples().last());
    match end {
        Some(last) => {
            attitude(&last.state, w.error().attitude, "end", &mut s);
            evidence(w, &mut s);
        }
        None => {
            attitude(&w.start, 0.0, "t0", &mut s);
            if w.is_turning() || w.torque.norm() > 0.0 {
                s.say("Without [run] the attitude is not computed any further.");
            }
        }
    }
    s
}

/// Returns the index of the axis that L circles, 0, 1 or 2; `None` if it circles none.
const fn circled(regime: Regime) -> Option<usize> {
    match regime {
        Regime::LongAxis => Some(0),
        Regime::ShortAxis => Some(2),
        _ => None,
    }
}

/// Writes the Euler angles of a symmetric top about L: θ is constant, φ and ψ are linear in time.
fn symmetric_angles(w: &Working<'_>, top: &SymmetricTop, s: &mut Section) {
    let theta = w.rotor.angular_momentum(top.start().omega).angle_to(top.axis());
    s.say("In Euler angles about L̂ (θ between L̂ and e, φ of e about L̂, ψ of the body about e):");
    s.formula(
        "cos θ = I_e ω_e / |L|,   φ = φ0 + (|L| / I_t)(t − t0),   ψ = ψ0 − Ω (t − t0),   ω_e = φ\u{307} cos θ + ψ\u{307}",
        r"\cos\theta = \frac{I_e \omega_e}{|\mathbf L|}, \quad \varphi = \varphi_0 + \frac{|\mathbf L|}{I_t} (t - t_0), \quad \psi = \psi_0 - \Omega (t - t_0), \quad \omega_e = \dot\varphi \cos\theta + \dot\psi",
    );
    s.line(format!(
        "θ = {}°,  φ\u{307} = {} rad/s,  ψ\u{307} = {} rad/s",
        n(theta.to_degrees()),
        n(top.space_rate()),
        n(-top.body_rate())
    ));
}

/// Writes the Euler angles of an asymmetric body about L, from the components of L along its axes.
fn asymmetric_angles(w: &Working<'_>, motion: &FreeMotion, circled: usize, s: &mut Section) {
    s.say(format!(
        "In Euler angles about L̂ (θ between L̂ and axis {0}, φ of axis {0} about L̂, ψ of the body about axis {0}), as L = |L| \
         (sin θ sin ψ, sin θ cos ψ, cos θ) along the axes {1}:",
        circled + 1,
        if circled == 2 { "1, 2, 3" } else { "2, 3, 1" },
    ));
    let (text, latex) = if circled == 2 {
        (
            "cos θ = i3 ω3 / |L|,   tan ψ = i1 ω1 / i2 ω2,   φ\u{307} = |L| (i1 ω1² + i2 ω2²) / (i1² ω1² + i2² ω2²)",
            r"\cos\theta = \frac{i_3\omega_3}{|\mathbf L|}, \qquad \tan\psi = \frac{i_1\omega_1}{i_2\omega_2}, \qquad \dot\varphi = |\mathbf L| \frac{i_1\omega_1^2 + i_2\omega_2^2}{i_1^2\omega_1^2 + i_2^2\omega_2^2}",
        )
    } else {
        (
            "cos θ = i1 ω1 / |L|,   tan ψ = i2 ω2 / i3 ω3,   φ\u{307} = |L| (i2 ω2² + i3 ω3²) / (i2² ω2² + i3² ω3²)",
            r"\cos\theta = \frac{i_1\omega_1}{|\mathbf L|}, \qquad \tan\psi = \frac{i_2\omega_2}{i_3\omega_3}, \qquad \dot\varphi = |\mathbf L| \frac{i_2\omega_2^2 + i_3\omega_3^2}{i_2^2\omega_2^2 + i_3^2\omega_3^2}",
        )
    };
    s.formula(text, latex);
    // The range refers to the end of the axis on the side of L.
    let [near, far] = motion.nutation_range();
    let l = (motion.principal().rotation().inverse() * w.rotor.angular_momentum(w.start.omega)).to_array();
    let range = if l[circled] < 0.0 { [PI - far, PI - near] } else { [near, far] };
    let [least, most] = range.map(|angle| n(angle.to_degrees()));
    let rate = motion.precession_rate();
    if let Some(direction) = motion.momentum().direction() {
        s.line(format!("L̂ = {} in space axes", v(direction.to_array())));
    }
    s.line(format!("θ = {least} … {most}°"));
    s.line(format!("φ\u{307} = {} rad/s on average, once in {} s", n(rate), n(TAU / rate.abs())));
    if let Some(period) = motion.period() {
        s.line(format!("in a period of ω ({} s) φ grows by {}°", n(period), n((rate * period).to_degrees())));
    }
    s.say(
        "The integral of φ\u{307} is an elliptic integral of the third kind; it is evaluated with theta functions.",
    );
}

/// Writes the attitude of a state; components below `error`, rad, are written as 0.
pub(crate) fn attitude(state: &State, error: f64, when: &str, s: &mut Section) {
    s.matrix(format!("R({when})"), state.attitude.matrix().map(|row| without_noise(row, 1.0, error)), "");
    if when == "end" {
        s.line(format!("t = {} s", n(state.time)));
    }
    let q = quaternion(state.attitude.canonical_quaternion(), error, DIGITS);
    s.line(format!("quaternion  w, x, y, z = {q}"));
    euler(state.attitude, error, s);
}

/// Rounding error of angles, rad.
const ROUNDING: f64 = 2e-14;

/// Writes the Euler angles.
///
/// If θ is 0 or π within the error, only φ + ψ or φ − ψ is determined.
fn euler(attitude: Attitude, error: f64, s: &mut Section) {
    let [phi, theta, psi] = attitude.euler313();
    let error = error.max(ROUNDING);
    let pole = if theta <= error {
        Some(("0", "0°", "φ + ψ", phi + psi))
    } else if PI - theta <= error {
        Some(("π", "180°", "φ − ψ", phi - psi))
    } else {
        None
    };
    if let Some((theta, degrees, name, angle)) = pole {
        let angle = (angle + PI).rem_euclid(TAU) - PI;
        let angle = if angle.abs() <= 2.0 * error { 0.0 } else { angle };
        s.line(format!("Euler 3-1-3 θ = {theta}: only {name} is determined, {name} = {} rad", n(angle)));
        s.line(format!("            θ = {degrees}, {name} = {}°", n(angle.to_degrees())));
        return;
    }
    // φ and ψ change by at most error/sin θ.
    let around = error / theta.sin();
    let shown = [(phi, around), (theta, error), (psi, around)];
    let [phi, theta, psi] = shown.map(|(angle, error)| if angle.abs() <= error { 0.0 } else { angle });
    s.line(format!("Euler 3-1-3 φ, θ, ψ = {}, {}, {} rad", n(phi), n(theta), n(psi)));
    let [phi, theta, psi] = [phi, theta, psi].map(|a| n(a.to_degrees()));
    s.line(format!("                    = {phi}°, {theta}°, {psi}°"));
}

/// Writes the drift of the conserved quantities over the run, and the estimated error at its end.
fn evidence(w: &Working<'_>, s: &mut Section) {
    if w.needed.is_some() {
        return;
    }
    let Some(drift) = w.trajectory.as_deref().and_then(Drift::of) else { return };
    s.say("Checks of the conserved quantities, relative, at the worst sample of the run:");
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
            "estimated error at the end: attitude {} rad, ω {} (relative)",
            error(end.attitude),
            error(end.omega)
        ));
    }
}
