//! Step 5 of Lagrange's top: two momenta, an effective potential, a cubic.

use std::f64::consts::{PI, TAU};

use polhode::math::AngularVelocity;
use polhode::motion::torque::TorqueModel;
use polhode::motion::{HeavyTop, TopPath};
use polhode_document::Section;
use polhode_document::graph::Graph;
use polhode_document::unit::rate;

use super::free::once_in;
use super::tensor::along_body_axis;
use super::working::{Working, factor, n, v};
use crate::report::facts::heavy_top_of;

/// Returns the scenario's body as a heavy symmetric top, if it is one.
pub(crate) fn of(w: &Working<'_>) -> Option<HeavyTop> {
    heavy_top_of(w.scenario, w.start)
}

/// Conserved quantities of Lagrange's equations.
struct Constants {
    /// Moments of inertia A and C, kg·m².
    moments: [f64; 2],
    /// Product M g l, N·m.
    weight: f64,
    /// Momenta p_φ and p_ψ, kg·m²/s.
    momenta: [f64; 2],
    /// Energy E′ = E − p_ψ²/2C, J.
    energy: f64,
}

impl Constants {
    fn of(w: &Working<'_>, top: &HeavyTop) -> Option<Self> {
        let TorqueModel::Gravity(gravity) = w.scenario.torques().first()? else { return None };
        let up = -gravity.acceleration.direction()?;
        let e = w.rotor.lever().direction()?;
        let along = w.rotor.angular_momentum(w.start.omega).dot(e);
        let about_vertical = w.rotor.angular_momentum_space(&w.start).dot(up);
        let height = (w.start.attitude * e).dot(up);
        let across = w.start.omega - AngularVelocity::from_array((e * top.spin()).to_array());
        let [a, _] = top.moments();
        let weight = top.weight_torque();
        Some(Self {
            moments: top.moments(),
            weight,
            momenta: [about_vertical, along],
            energy: 0.5 * a * across.dot(across) + weight * height,
        })
    }

    /// Returns the potential U_eff(θ) = (p_φ − p_ψ cos θ)² / (2 A sin²θ) + M g l cos θ, J.
    fn potential(&self, theta: f64) -> f64 {
        let (sin, cos) = theta.sin_cos();
        let [along_vertical, along_axis] = self.momenta;
        let cross = (along_vertical - along_axis * cos) / sin;
        cross * cross / (2.0 * self.moments[0]) + self.weight * cos
    }
}

pub(crate) fn solve(w: &Working<'_>, top: &HeavyTop, s: &mut Section) {
    let Some(constants) = Constants::of(w, top) else { return };
    let Some(e) = w.rotor.lever().direction() else { return };
    let [a, c] = constants.moments;
    s.say(
        "The body is symmetric about e, which leads from the pivot to the centre of mass at the distance l: Lagrange's top. \
         With θ between e and the vertical, φ of e about the vertical and ψ of the body about e (Euler angles):",
    );
    s.formula(
        "T = ½ A (θ\u{307}² + φ\u{307}² sin²θ) + ½ C (ψ\u{307} + φ\u{307} cos θ)²,   U = M g l cos θ",
        r"T = \tfrac12 A (\dot\theta^2 + \dot\varphi^2 \sin^2\theta) + \tfrac12 C (\dot\psi + \dot\varphi\cos\theta)^2, \qquad U = M g l \cos\theta",
    );
    let name = along_body_axis(e).map_or_else(String::new, |name| format!(" = {name}"));
    s.line(format!("e = {}{name},  A = {},  C = {} kg·m²", v(e.to_array()), n(a), n(c)));
    s.line(format!("M g l = {} N·m", n(constants.weight)));
    momenta(&constants, top, s);
    potential(&constants, top, s);
    cubic(&constants, top, s);
    limits(&constants, top, s);
}

fn momenta(constants: &Constants, top: &HeavyTop, s: &mut Section) {
    let [_, c] = constants.moments;
    let [p_phi, p_psi] = constants.momenta;
    s.say("φ and ψ are cyclic (neither T nor U contains them), so their momenta are constant: the components of L along the vertical and along e.");
    s.formula(
        "p_ψ = C (ψ\u{307} + φ\u{307} cos θ) = C ω_e,   p_φ = A φ\u{307} sin²θ + p_ψ cos θ",
        r"p_\psi = C (\dot\psi + \dot\varphi\cos\theta) = C \omega_e, \qquad p_\varphi = A \dot\varphi \sin^2\theta + p_\psi\cos\theta",
    );
    s.line(format!("p_φ = L · k̂ = {} kg·m²/s, k̂ upward", n(p_phi)));
    s.line(format!("p_ψ = L · e = C ω_e = {}·{} = {} kg·m²/s", n(c), factor(top.spin()), n(p_psi)));
    s.formula(
        "φ\u{307} = (p_φ − p_ψ cos θ) / (A sin²θ),   ψ\u{307} = ω_e − φ\u{307} cos θ",
        r"\dot\varphi = \frac{p_\varphi - p_\psi\cos\theta}{A\sin^2\theta}, \qquad \dot\psi = \omega_e - \dot\varphi\cos\theta",
    );
    s.say(
        "Two spins are distinguished: ω_e = ω · e, which is constant and given by the start, and the proper spin ψ\u{307}, the rate of the body about e relative to the plane of e and the vertical. That plane rotates at φ\u{307}, and φ\u{307} cos θ is its component along e.",
    );
}

fn potential(constants: &Constants, top: &HeavyTop, s: &mut Section) {
    s.say("One equation for θ remains, like that of a particle in one dimension:");
    s.formula(
        "E′ = ½ A θ\u{307}² + U_eff(θ),   U_eff = (p_φ − p_ψ cos θ)² / (2 A sin²θ) + M g l cos θ,   E′ = T + U − p_ψ²/2C",
        r"E' = \tfrac12 A\dot\theta^2 + U_{\text{eff}}(\theta), \qquad U_{\text{eff}} = \frac{(p_\varphi - p_\psi\cos\theta)^2}{2A\sin^2\theta} + M g l\cos\theta, \qquad E' = T + U - \frac{p_\psi^2}{2C}",
    );
    s.line(format!("E′ = {} J", n(constants.energy)));
    let [highest, lowest] = top.nutation_bounds();
    if top.roots().is_none() {
        return;
    }
    // The graph extends beyond the turning points by their distance, at least one degree.
    let margin = (lowest - highest).max(PI / 180.0);
    let (from, to) = ((highest - margin).max(1e-3), (lowest + margin).min(PI - 1e-3));
    const POINTS: u32 = 161;
    let span = [0.0, 1.0].map(|part| constants.potential(highest + part * (lowest - highest)));
    let floor =
        (0..POINTS).map(|k| constants.potential(from + (to - from) * f64::from(k) / f64::from(POINTS - 1)));
    let least = floor.fold(f64::INFINITY, f64::min);
    // Points far above the level line would compress the curve.
    let depth = (span[0].max(span[1]).max(constants.energy) - least).max(1e-9 * constants.weight);
    let points: Vec<[f64; 2]> = (0..POINTS)
        .map(|k| from + (to - from) * f64::from(k) / f64::from(POINTS - 1))
        .map(|theta| [theta.to_degrees(), constants.potential(theta)])
        .filter(|p| p[1] <= least + 4.0 * depth)
        .collect();
    if points.len() > 2 {
        s.graph(Graph {
            title: "The effective potential".to_owned(),
            across: ["θ", "°"],
            up: ["U_eff", "J"],
            points,
            level: (
                [highest.to_degrees(), lowest.to_degrees(), constants.energy],
                "E′, between the turning points",
            ),
        });
    }
}

fn cubic(constants: &Constants, top: &HeavyTop, s: &mut Section) {
    s.say("With u = cos θ the right-hand side is a cubic, and u(t) is an elliptic function:");
    s.formula(
        "u\u{307}² = θ\u{307}² sin²θ = f(u) = (1 − u²)(2E′ − 2 M g l u)/A − (p_φ − p_ψ u)²/A²",
        r"\dot u^2 = \dot\theta^2 \sin^2\theta = f(u) = \frac{(1 - u^2)(2E' - 2 M g l u)}{A} - \frac{(p_\varphi - p_\psi u)^2}{A^2}",
    );
    let (Some([u1, u2, u3]), Some([m, _])) = (top.roots(), top.parameter()) else {
        s.say(format!("Here the axis remains vertical: {}.", top.path().description()));
        return;
    };
    let a = constants.moments[0];
    s.say("f has the roots u1 ≤ u2 ≤ 1 ≤ u3, and u oscillates between u1 and u2:");
    s.formula(
        "u = u1 + (u2 − u1) sn²(λ t + δ, k),   λ² = M g l (u3 − u1)/2A,   k² = (u2 − u1)/(u3 − u1)",
        r"u = u_1 + (u_2 - u_1) \operatorname{sn}^2(\lambda t + \delta, k), \qquad \lambda^2 = \frac{M g l}{2A} (u_3 - u_1), \qquad k^2 = \frac{u_2 - u_1}{u_3 - u_1}",
    );
    s.line(format!("u1 = {},  u2 = {},  u3 = {}", n(u1), n(u2), n(u3)));
    let [highest, lowest] = top.nutation_bounds().map(|angle| n(angle.to_degrees()));
    s.line(format!("θ = {highest} … {lowest}°: {}", top.path().description()));
    let lambda = (0.5 * constants.weight / a * (u3 - u1)).sqrt();
    s.line(format!("λ = {} /s,  k² = {}", n(lambda), n(m)));
    let Some(period) = top.nutation_period() else {
        s.say("k = 1: the separatrix, on which the top approaches the vertical in infinite time.");
        return;
    };
    let what = if is_steady(top) { "of small nutations about it" } else { "of a nutation" };
    s.line(format!("period {what} 2 K(k) / λ = {} s", n(period)));
    let is_planar = top.path() == TopPath::Planar;
    if let Some(turned) = top.precession_in_a_nutation().filter(|_| !is_planar) {
        let through = if top.mean_precession().is_none() {
            ", including the half turn of φ at the vertical"
        } else {
            ""
        };
        s.line(format!("precession in a nutation = {}°{through}", n(turned.to_degrees())));
    }
    if let (Some(precession), Some(spin)) = (top.mean_precession(), top.mean_spin()) {
        s.line(format!("φ\u{307} on average = {}{}", rate(precession), once_in(precession)));
        s.line(format!("proper spin ψ\u{307} on average = {};  ω_e = {}", rate(spin), rate(top.spin())));
    }
}

const fn is_steady(top: &HeavyTop) -> bool {
    matches!(top.path(), TopPath::SteadySlow | TopPath::SteadyFast | TopPath::Conical)
}

/// Writes the approximations for a fast top and the steady precessions, with the exact values.
fn limits(constants: &Constants, top: &HeavyTop, s: &mut Section) {
    let [a, c] = constants.moments;
    let spin = (c * top.spin()).abs();
    let needed = 2.0 * (constants.weight * a).sqrt();
    if top.roots().is_none() || spin == 0.0 {
        return;
    }
    s.say("The limit of a fast top, C |ω_e| ≫ 2 √(M g l A): small nutations at the rate C |ω_e| / A, while it precesses at M g l / C ω_e on average.");
    s.line(format!(
        "C |ω_e| = {},  2 √(M g l A) = {} kg·m²/s: {} times as much",
        n(spin),
        n(needed),
        n(spin / needed)
    ));
    s.line(format!(
        "2π A / C |ω_e| = {} s,  M g l / C ω_e = {} rad/s",
        n(TAU * a / spin),
        n(constants.weight / (c * top.spin()))
    ));
    let [highest, lowest] = top.nutation_bounds();
    let middle = 0.5 * (highest + lowest);
    if let Some(steady) = top.steady_precession(middle, top.spin()) {
        s.say("Steady precession, without nutation, requires θ\u{308} = 0, A φ\u{307}² cos θ − C ω_e φ\u{307} + M g l = 0, which has two rates; with this ω_e at the middle of the nutation:");
        let fast = steady.fast.map_or_else(String::new, |fast| format!(",  the fast one {} rad/s", n(fast)));
        s.line(format!("θ = {}°:  the slow one {} rad/s{fast}", n(middle.to_degrees()), n(steady.slow)));
    }
}
