//! Step 5 of a body suspended from a fixed axis.

use polhode::body::Particle;
use polhode::math::{Body, Direction};
use polhode::motion::{Pendulum, Swing};
use polhode_document::Section;
use polhode_document::number::{error, tidy_beside};
use polhode_document::unit;

use super::working::{Working, factor, leaves, n, v};

/// Largest number of particles in a written sum.
const MOST_TERMS: usize = 6;

pub(crate) fn solve(w: &Working<'_>, pendulum: &Pendulum, s: &mut Section) {
    let Some(axis) = w.scenario.suspension().and_then(|hanging| hanging.axis.direction()) else { return };
    let mass = w.rotor.mass();
    s.say(
        "The body hangs from a fixed axis n̂: the only variable is the angle θ from the hanging position, with the component of Euler's equations along n̂. Gravity pulls the centre of mass, at the distance d, back to θ = 0 (the notes lose this \
         minus sign):",
    );
    s.formula(
        "I θ\u{308} = N · n̂ = −M g d sin θ   →   θ\u{308} ≃ −ω0² θ,   ω0 = √(M g d / I)",
        r"I \ddot\theta = \mathbf N \cdot \hat{\mathbf n} = -M g d \sin\theta \quad\Rightarrow\quad \ddot\theta \simeq -\omega_0^2 \theta, \qquad \omega_0 = \sqrt{\frac{M g d}{I}}",
    );
    s.line(format!("n̂ = {} in body axes", v(axis.to_array())));
    moment(w, pendulum, axis, s);
    s.line(format!(
        "M = {} kg,  d = {} m,  g = {} m/s² across the axis",
        n(mass),
        n(pendulum.arm()),
        n(pendulum.gravity())
    ));
    let small = pendulum.small_frequency();
    s.line(format!(
        "ω0² = {}·{}·{} / {} = {} /s²",
        n(mass),
        n(pendulum.gravity()),
        n(pendulum.arm()),
        n(pendulum.moment()),
        n(small * small)
    ));
    s.line(format!("ω0 = {} rad/s,  period of small swings 2π/ω0 = {} s", n(small), n(pendulum.period(0.0))));
    at_start(pendulum, s);
    amplitude(w, pendulum, axis, s);
    swing_test(w, pendulum, s);
    // The pivot of the run holds a point only, so the body leaves n̂ unless it is a principal axis.
    if leaves(w.scenario, axis) && w.trajectory.is_some() {
        s.say(
            "The run below holds only the pivot, not the axis, so its motion differs from this pendulum's.",
        );
    }
}

/// Writes the moment I about the axis; for a few particles as a sum.
fn moment(w: &Working<'_>, pendulum: &Pendulum, axis: Direction<Body>, s: &mut Section) {
    let particles = w.scenario.particles();
    if !w.scenario.is_all_particles() || !(1..=MOST_TERMS).contains(&particles.len()) {
        s.line(format!("I = {} kg·m² about the axis", n(pendulum.moment())));
        return;
    }
    // Distance of each particle from the axis.
    let arm = |p: &Particle<Body>| axis.cross(p.position() - w.point()).norm();
    let terms: Vec<String> =
        particles.iter().map(|p| format!("{}·{}²", n(p.mass()), factor(arm(p)))).collect();
    s.sum("I = Σ m ρ²", &terms, &format!("{} kg·m², ρ from the axis", n(pendulum.moment())));
}

fn at_start(pendulum: &Pendulum, s: &mut Section) {
    let theta = pendulum.angle();
    if theta.abs() < 1e-12 {
        s.line("at t0 it hangs straight down: θ = 0");
        return;
    }
    let small = pendulum.small_frequency();
    s.line(format!(
        "at t0 θ = {},  θ\u{308} = -ω0² sin θ = {} rad/s²",
        unit::angle(theta),
        n(if is_upright(pendulum) { 0.0 } else { -small * small * theta.sin() })
    ));
}

/// Returns true if the body is upright, up to rounding.
fn is_upright(pendulum: &Pendulum) -> bool {
    let (sin, cos) = pendulum.angle().sin_cos();
    cos < 0.0 && sin.abs() < 1e-12
}

fn amplitude(w: &Working<'_>, pendulum: &Pendulum, axis: Direction<Body>, s: &mut Section) {
    let swing = match w.scenario.suspension().and_then(|hanging| hanging.amplitude) {
        Some(amplitude) => pendulum.swing(amplitude, 0.0),
        None => pendulum.swing(pendulum.angle(), axis.dot(w.start.omega)),
    };
    match swing {
        Swing::Rest => {
            s.say("At rest it stays there; add an amplitude or a start to compute the exact period.");
        }
        Swing::Oscillation { amplitude, period } => {
            s.say("At a finite amplitude the period is longer; it is an elliptic integral:");
            s.formula(
                "P = 4 K(k) / ω0,   k = sin ½θmax,   K(k) = ∫ dx / √(1 − k² sin² x), x from 0 to π/2",
                r"P = \frac{4 K(k)}{\omega_0}, \qquad k = \sin \tfrac12 \theta_{\max}, \qquad K(k) = \int_0^{\pi/2} \frac{dx}{\sqrt{1 - k^2 \sin^2 x}}",
            );
            let longer = period / pendulum.period(0.0) - 1.0;
            s.line(format!("θmax = {}", unit::amplitude(amplitude)));
            s.line(format!("P = {} s, {} % longer than a small swing", n(period), n(100.0 * longer)));
            series(amplitude, longer, s);
        }
        Swing::Separatrix if is_upright(pendulum) && !w.is_turning() => {
            s.say("It is at rest upright: an unstable equilibrium.");
        }
        Swing::Separatrix => {
            s.say("It has exactly the energy of the upright position, which it approaches in infinite time.");
        }
        Swing::Revolution { period } => {
            s.say("It has enough energy to rotate over the top.");
            s.line(format!("one turn in {} s", n(period)));
        }
    }
}

/// Writes the series of the period in k and in θmax, term by term.
fn series(amplitude: f64, longer: f64, s: &mut Section) {
    s.say("As a series in k, and in θmax:");
    s.formula(
        "P = (2π/ω0) [1 + (1/2)² k² + (1·3/2·4)² k⁴ + (1·3·5/2·4·6)² k⁶ + …]\n\
         P = (2π/ω0) [1 + θmax²/16 + 11 θmax⁴/3072 + 173 θmax⁶/737280 + …]",
        r"P = \frac{2\pi}{\omega_0} \left[1 + \frac{k^2}{4} + \frac{9 k^4}{64} + \frac{25 k^6}{256} + \ldots\right] = \frac{2\pi}{\omega_0} \left[1 + \frac{\theta_{\max}^2}{16} + \frac{11 \theta_{\max}^4}{3072} + \frac{173 \theta_{\max}^6}{737280} + \ldots\right]",
    );
    let k2 = (0.5 * amplitude).sin().powi(2);
    let in_k = [k2 / 4.0, 9.0 * k2.powi(2) / 64.0, 25.0 * k2.powi(3) / 256.0];
    let square = amplitude * amplitude;
    let in_theta = [square / 16.0, 11.0 * square.powi(2) / 3072.0, 173.0 * square.powi(3) / 737_280.0];
    for (name, terms) in [("k", in_k), ("θmax", in_theta)] {
        let sum: f64 = terms.iter().sum();
        // Remainder of P ω0 / 2π − 1; omitted if it is a rounding error.
        let rest = longer - sum;
        let rest = if rest > 4.0 * f64::EPSILON { format!(", {} short", error(rest)) } else { String::new() };
        s.line(format!("P ω0 / 2π - 1, in {name}: {} = {}{rest}", terms.map(n).join(" + "), n(sum)));
    }
}

/// Writes the swing test: from a measured period to the moment of inertia.
fn swing_test(w: &Working<'_>, pendulum: &Pendulum, s: &mut Section) {
    let (mass, arm) = (w.rotor.mass(), pendulum.arm());
    let steiner = mass * arm * arm;
    let central = tidy_beside([pendulum.moment() - steiner, 0.0, 0.0], pendulum.moment())[0];
    s.say(
        "The swing test inverts this formula: suspend a body of known M and d and count small swings. The period P gives the moment of inertia about the axis, and the parallel-axis theorem the moment about the centre of mass:",
    );
    s.formula(
        "I = M g d (P / 2π)²,   I_c = I − M d²",
        r"I = M g d \left(\frac{P}{2\pi}\right)^2, \qquad I_c = I - M d^2",
    );
    let period = pendulum.period(0.0);
    s.line(format!(
        "I = {}·{}·{}·({} / 2π)² = {} kg·m²",
        n(mass),
        n(pendulum.gravity()),
        n(arm),
        n(period),
        n(pendulum.moment())
    ));
    s.line(format!("I_c = {} - {} = {} kg·m²", n(pendulum.moment()), n(steiner), n(central)));
    if central > 1e-9 * pendulum.moment() {
        s.say(format!(
            "An error of 1 % in P causes an error of 2 % in I, and of {} % in I_c, because M d² is subtracted. Suspend it so that d is near the gyration radius {} m, where both are similar and P depends least on d.",
            n(2.0 * pendulum.moment() / central),
            n((central / mass).sqrt())
        ));
    }
}
