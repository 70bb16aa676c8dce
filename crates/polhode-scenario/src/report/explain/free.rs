//! Step 5 without torque: permanent rotation, the symmetric top, the asymmetric body.

use std::f64::consts::TAU;

use polhode::body::Symmetry;
use polhode::motion::{FreeMotion, Regime};
use polhode::observe::{Cones, FreeRegime, JacobiForm, SymmetricTop};
use polhode_document::Section;
use polhode_document::unit::{CLOSED, cone, rate};

use super::symbols;
use super::working::{Working, factor, n, v};
use super::{driven, elliptic, tensor};
use crate::report::free_facts::FreeFacts;

pub(crate) fn solve(w: &Working<'_>, s: &mut Section) {
    if w.rotor.principal().symmetry() == Symmetry::Point {
        s.say("There is nothing to solve: all the mass is in one point, which cannot rotate.");
        return;
    }
    let Some(free) = &w.at_start else { return };
    match (free.regime.regime, &free.top) {
        (Regime::Permanent(_) | Regime::AtRest, _) => permanent(w, &free.regime, s),
        (_, Some((top, _))) => symmetric(w, &free.motion, top, s),
        _ => asymmetric(w, &free.regime, s),
    }
}

fn permanent(w: &Working<'_>, free: &FreeRegime, s: &mut Section) {
    if !w.is_turning() {
        s.say("At rest and without torque the body stays at rest: ω(t) = 0.");
        return;
    }
    s.say(format!(
        "ω lies along a principal axis, so ω × L = 0 and ω\u{307} = 0: {}. The axis and the rate are constant, in the body and in space.",
        free.regime.description()
    ));
    s.formula("ω(t) = ω(t0)", r"\boldsymbol\omega(t) = \boldsymbol\omega(t_0)");
    let speed = w.start.omega.norm();
    s.line(format!("ω = {} rad/s, one turn in {} s", v(w.start.omega.to_array()), n(TAU / speed)));
    if let Some(growth) = free.growth_rate {
        s.say(
            "But rotation about the intermediate axis is unstable: perturbations grow as exp(σ t), and the body flips over, again \
             and again.",
        );
        growth_rate(growth, s);
    }
}

/// Writes the solution of a symmetric top as in the notes: η(t) = A exp(iΩt), about the symmetry
/// axis e.
fn symmetric(w: &Working<'_>, motion: &FreeMotion, top: &SymmetricTop, s: &mut Section) {
    let [axial, transverse] = top.moments();
    let e = top.axis();
    let along = e * top.spin();
    let omega = polhode::math::Direction::from_array(w.start.omega.to_array());
    let across = omega - along;
    if across.norm() <= CLOSED * omega.norm() {
        along_axis(w, top, s);
        return;
    }
    s.say(
        "Two moments are equal: a symmetric top. Take e, the symmetry axis, with I_e about it and I_t across it (the \
         notes' I3 and I1 = I2), û along the part of ω across e at t0, and v̂ = e × û. The equation along e gives ω_e = constant (the notes' ω3), and the others become",
    );
    s.formula(
        "ω\u{307}_u = −Ω ω_v,   ω\u{307}_v = +Ω ω_u,   Ω = (I_e − I_t) ω_e / I_t",
        r"\dot\omega_u = -\Omega \omega_v, \qquad \dot\omega_v = +\Omega \omega_u, \qquad \Omega = \frac{I_e - I_t}{I_t} \omega_e",
    );
    s.formula(
        "η = ω_u + i ω_v:   η\u{307} = iΩ η,   η = A exp(iΩt)   →   ω_u = A cos Ωt,  ω_v = A sin Ωt,  ω_e = constant",
        r"\eta = \omega_u + i\omega_v, \quad \dot\eta = i\Omega\eta, \quad \eta = A e^{i\Omega t} \quad\Rightarrow\quad \omega_u = A\cos\Omega t, \quad \omega_v = A\sin\Omega t, \quad \omega_e = \text{constant}",
    );
    let name = tensor::along_body_axis(e).map_or_else(String::new, |name| format!(" = {name}"));
    s.line(format!("e   = {}{name},  I_e = {},  I_t = {} kg·m²", v(e.to_array()), n(axial), n(transverse)));
    s.line(format!("ω_e = ω · e = {} rad/s", n(top.spin())));
    s.line(format!("A   = |ω - ω_e e| = {} rad/s", n(across.norm())));
    if let Some(u) = across.direction() {
        s.line(format!("û   = {},  v̂ = {}", v(u.to_array()), v(e.cross(u).to_array())));
    }
    s.line(format!(
        "Ω   = ({} - {})·{} / {} = {} rad/s{}",
        n(axial),
        n(transverse),
        super::working::factor(top.spin()),
        n(transverse),
        n(top.body_rate()),
        once_in(top.body_rate())
    ));
    if top.body_rate() == 0.0 {
        s.say(
            "Ω = 0: ω is perpendicular to the symmetry axis, so it is along a principal axis and constant.",
        );
    }
    if let Some(symbolic) = w.exact.symbols() {
        symbols::top(symbolic, e.to_array(), &Cones::of(top), s);
    }
    cones(w, motion, top, s);
}

/// Writes the rotation about the symmetry axis, with ω along it up to rounding.
///
/// Both cones are lines.
fn along_axis(w: &Working<'_>, top: &SymmetricTop, s: &mut Section) {
    s.say(
        "Two moments are equal: a symmetric top, and ω lies along its symmetry axis e (within rounding), so \
         ω × L = 0 and ω\u{307} = 0. The axis and the rate are constant, in the body and in space.",
    );
    s.formula("ω(t) = ω(t0)", r"\boldsymbol\omega(t) = \boldsymbol\omega(t_0)");
    s.line(format!("e = {}", v(top.axis().to_array())));
    s.line(format!("ω = {} rad/s{}", v(w.start.omega.to_array()), once_in(w.start.omega.norm())));
}

fn cones(w: &Working<'_>, motion: &FreeMotion, top: &SymmetricTop, s: &mut Section) {
    let cones = Cones::of(top);
    let sense = if cones.body_rate < 0.0 { ", against the right hand about e" } else { "" };
    s.say(format!(
        "In the body ω circles e at Ω{sense} and sweeps the body cone. In space L is fixed, and T = ½ ω L cos γ is \
         constant, so ω keeps its angle γ to L and sweeps the space cone; ω and e both circle L, at the same rate φ\u{307}. \
         The cones touch along ω, and the body cone rolls on the space cone."
    ));
    s.formula(
        "tan (ω,e) = A / |ω_e|,   φ\u{307} = |L| / I_t,   ω = L/I_t − Ω e   (so L, ω and e lie in one plane)",
        r"\tan\angle(\boldsymbol\omega, \mathbf e) = \frac{A}{|\omega_e|}, \qquad \dot\varphi = \frac{|\mathbf L|}{I_t}, \qquad \boldsymbol\omega = \frac{\mathbf L}{I_t} - \Omega \mathbf e",
    );
    s.line(format!("body cone   half-angle {}", cone(cones.body_half_angle)));
    s.line(format!("space cone  half-angle {}", cone(cones.space_half_angle)));
    s.line(format!("nutation    {} between L and ±e, constant", cone(cones.nutation)));
    s.line(format!("φ\u{307} = |L| / I_t = {}{}", rate(cones.space_rate), once_in(cones.space_rate)));
    let samples = w.trajectory.as_ref().map_or(&[][..], |trajectory| trajectory.samples());
    let departure = samples
        .iter()
        .map(|x| Cones::coplanarity(top, &x.state))
        .fold(Cones::coplanarity(top, &motion.at(w.start.time + 1.0)), f64::max);
    s.line(format!(
        "e · (ω × L) / |ω||L| = {} at worst: one plane",
        polhode_document::number::error(departure)
    ));
    if let Some(how) = driven::how(w) {
        s.say(format!("ω(t) {how}{}:", w.rows.words));
        driven::table(w, false, s);
    }
}

fn asymmetric(w: &Working<'_>, free: &FreeRegime, s: &mut Section) {
    let [i1, i2, i3] = w.rotor.principal().moments();
    let l = w.rotor.angular_momentum(w.start.omega);
    let (l2, t) = (l.dot(l), w.rotor.kinetic_energy(w.start.omega));
    s.say(
        "Three different moments: Euler's equations are coupled, but energy and angular momentum are constant. So ω moves along a closed curve, the polhode, which is the intersection of two ellipsoids:",
    );
    s.formula(
        "2T = i1 ω1² + i2 ω2² + i3 ω3²,   L² = (i1 ω1)² + (i2 ω2)² + (i3 ω3)²,   D = L² / 2T",
        r"2T = i_1\omega_1^2 + i_2\omega_2^2 + i_3\omega_3^2, \qquad L^2 = i_1^2\omega_1^2 + i_2^2\omega_2^2 + i_3^2\omega_3^2, \qquad D = \frac{L^2}{2T}",
    );
    s.line(format!("2T = {} J,  L² = {} (kg·m²/s)²", n(2.0 * t), n(l2)));
    s.line(format!(
        "D = {} kg·m²,  compared with i1, i2, i3 = {}, {}, {} kg·m²",
        n(l2 / (2.0 * t)),
        n(i1),
        n(i2),
        n(i3)
    ));
    let [x, _, z] = (w.rotor.principal().rotation().inverse() * w.start.omega).to_array();
    let (first, third) = (i1 * (i1 - i2) * x * x, i3 * (i3 - i2) * z * z);
    s.line(format!(
        "D - i2 = [i1 (i1 - i2) ω1² + i3 (i3 - i2) ω3²] / 2T = [{} + {}] / {} = {} kg·m²",
        factor(first),
        n(third),
        n(2.0 * t),
        n((first + third) / (2.0 * t))
    ));
    let why = match free.regime {
        Regime::LongAxis => "D < i2: ",
        Regime::ShortAxis => "D > i2: ",
        Regime::Separatrix => "D = i2: ",
        _ => "",
    };
    s.say(format!("{why}{}.", free.regime.description()));
    if let Some(form) = w.at_start.as_ref().and_then(|free| JacobiForm::of(&free.motion)) {
        elliptic::closed_form(&form, free, s);
    }
    if let Some(flip) = free.flip_interval {
        let flips = if free.growth_rate.is_some() { ": the body flips" } else { "" };
        s.line(format!("ω2 changes sign every {} s{flips}", n(flip)));
    }
    let off = w.at_start.as_ref().map(FreeFacts::degrees_off);
    if let (Some(growth), Some(off)) = (free.growth_rate, off) {
        s.say(format!("ω starts {off}° from the intermediate axis; near it a deviation grows as exp(σ t):"));
        growth_rate(growth, s);
    }
    match driven::how(w) {
        Some(how) => {
            s.say(format!("ω(t) {how}{}:", w.rows.words));
            driven::table(w, false, s);
        }
        None => s.say("Add [run] to the scenario to compute values of ω(t)."),
    }
}

fn growth_rate(growth: f64, s: &mut Section) {
    s.formula(
        "σ = |ω2| √[ (i3 − i2)(i2 − i1) / (i1 i3) ]",
        r"\sigma = |\omega_2| \sqrt{\frac{(i_3 - i_2)(i_2 - i_1)}{i_1 i_3}}",
    );
    s.line(format!("σ = {} /s", n(growth)));
}

/// Formats the period of a rate: `, once in 3 s`; empty for a rate of 0.
pub(crate) fn once_in(rate: f64) -> String {
    if rate == 0.0 { String::new() } else { format!(", once in {} s", n(TAU / rate.abs())) }
}
