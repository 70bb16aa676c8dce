//! Steps 4 and 5 of a body with wheels or internal friction.
//!
//! L then has terms other than {I} ω, or the body axes rotate at a rate other than ω.

use polhode::math::{AngularMomentum, AngularVelocity, Body, Torque};
use polhode::motion::torque::{EnergySink, TorqueModel};
use polhode::motion::{Motor, Wheel};
use polhode::observe::{DissipativeLimit, PermanentRotation};
use polhode_document::Section;
use polhode_document::number::tidy_beside;

use super::driven;
use super::working::{Working, exactly, factor, n, v};

/// Initial values of a body with wheels or internal friction.
pub(crate) struct Inside<'a, 'w> {
    w: &'a Working<'w>,
    /// Sum of the coefficients of the energy sinks, Σ α.
    alpha: f64,
    omega: AngularVelocity<Body>,
    h: AngularMomentum<Body>,
    momentum: AngularMomentum<Body>,
    /// Cross product L × ω, N·m.
    bending: Torque<Body>,
    /// Angular velocity Ω of the body axes.
    turning: AngularVelocity<Body>,
    /// Rate of change dh/dt of the wheels' momentum by the motors, N·m.
    motor: Torque<Body>,
}

impl<'a, 'w> Inside<'a, 'w> {
    /// Returns the initial values; `None` for a body without wheels and internal friction.
    pub(crate) fn of(w: &'a Working<'w>) -> Option<Self> {
        let coefficient = |torque: &TorqueModel| match torque {
            TorqueModel::EnergySink(sink) => sink.coefficient(),
            _ => 0.0,
        };
        let alpha: f64 = w.scenario.torques().iter().map(coefficient).sum();
        if w.scenario.wheels().is_empty() && alpha == 0.0 {
            return None;
        }
        let (omega, time) = (w.start.omega, w.start.time);
        let h = w.rotor.wheel_momentum(time);
        let momentum = w.rotor.angular_momentum(omega) + h;
        let bending = momentum.cross(omega);
        let turning = omega + AngularVelocity::from_array((bending * alpha).to_array());
        Some(Self { w, alpha, omega, h, momentum, bending, turning, motor: w.rotor.motor_torque(time) })
    }

    fn has_sink(&self) -> bool {
        self.alpha > 0.0
    }

    /// Returns true if no external torque acts.
    fn is_free(&self) -> bool {
        self.w.scenario.torques().iter().all(|torque| matches!(torque, TorqueModel::EnergySink(_)))
    }

    fn is_driven(&self) -> bool {
        self.w.rotor.wheels().iter().any(Wheel::is_driven)
    }

    /// Returns L × Ω + N − dh/dt.
    fn change(&self) -> Torque<Body> {
        self.momentum.cross(self.turning) + self.w.torque - self.motor
    }

    fn has_wheels(&self) -> bool {
        !self.w.rotor.wheels().is_empty()
    }

    /// Returns the symbol of the body axes' angular velocity: ω, or Ω with internal friction.
    const fn turning_name(&self) -> [&'static str; 2] {
        if self.alpha > 0.0 { ["Ω", r"\boldsymbol\Omega"] } else { ["ω", r"\boldsymbol\omega"] }
    }

    /// Returns L × Ω + N − dh/dt as Unicode and LaTeX, without the terms that are zero.
    fn right_side(&self) -> [String; 2] {
        let [text, latex] = self.turning_name();
        let (mut text, mut latex) = (format!("L × {text}"), format!(r"\mathbf L \times {latex}"));
        if !self.is_free() {
            text.push_str(" + N");
            latex.push_str(r" + \mathbf N");
        }
        if self.is_driven() {
            text.push_str(" − dh/dt");
            latex.push_str(r" - \dot{\mathbf h}");
        }
        [text, latex]
    }

    /// Writes h and L for step 3.
    pub(crate) fn momentum(&self, s: &mut Section) {
        let w = self.w;
        if self.has_wheels() {
            s.say(
                "The wheels have angular momentum h, the sum of each wheel's moment of inertia about its axis times its speed. {I} is the tensor without the axial moments of wheels with a motor.",
            );
            s.formula(
                "L = {I} ω + h",
                r"\mathbf L = \lbrace \mathbf I \rbrace \cdot \boldsymbol\omega + \mathbf h",
            );
            let time = w.start.time;
            let terms: Vec<String> =
                w.rotor.wheels().iter().map(|wheel| along(wheel, wheel.momentum_at(time))).collect();
            s.sum("h", &terms, &format!("{} kg·m²/s", v(self.h.to_array())));
            s.line(format!(
                "L = {} kg·m²/s,  |L| = {} kg·m²/s, body axes",
                v(self.momentum.to_array()),
                n(self.momentum.norm())
            ));
            let space = w.start.attitude * self.momentum;
            s.line(format!("  = {} kg·m²/s, space axes", v(space.to_array())));
        }
    }

    /// Writes step 4.
    pub(crate) fn equations(&self) -> Section {
        let w = self.w;
        let mut s = Section::new(4, "Euler's equations");
        let [name, _] = self.turning_name();
        let [text, latex] = self.right_side();
        if self.has_sink() {
            s.say(
                "N = dL/dt holds in space. The friction inside is an energy sink of coefficient α: body axes turn at Ω, and ω, which gives \
                 the energy, follows L with a lag:",
            );
            s.formula(
                "Ω = ω + α L × ω",
                r"\boldsymbol\Omega = \boldsymbol\omega + \alpha \mathbf L \times \boldsymbol\omega",
            );
        } else {
            s.say(format!("N = dL/dt holds in space. Body axes turn at {name}, so there"));
        }
        let l = if self.has_wheels() { "L = {I} ω + h" } else { "L = {I} ω" };
        let l_latex = if self.has_wheels() {
            r"\mathbf L = \lbrace \mathbf I \rbrace \cdot \boldsymbol\omega + \mathbf h"
        } else {
            r"\mathbf L = \lbrace \mathbf I \rbrace \cdot \boldsymbol\omega"
        };
        s.formula(
            &format!("{{I}} dω/dt = {text},   {l}"),
            &format!(
                r"\lbrace \mathbf I \rbrace \cdot \dot{{\boldsymbol\omega}} = {latex}, \qquad {l_latex}"
            ),
        );
        s.say("At t0, in body axes:");
        let scale = self.momentum.norm() * self.omega.norm();
        let shown = |torque: Torque<Body>| v(tidy_beside(torque.to_array(), scale));
        s.line(format!("ω = {} rad/s", exactly(self.omega.to_array())));
        s.line(format!("L = {} kg·m²/s", v(self.momentum.to_array())));
        s.line(format!("L × ω = {} N·m", shown(self.bending)));
        if self.has_sink() {
            s.line(format!(
                "Ω = {} + {}·{} = {} rad/s",
                v(self.omega.to_array()),
                n(self.alpha),
                shown(self.bending),
                v(self.turning.to_array())
            ));
            s.line(format!("L × Ω = {} N·m", shown(self.momentum.cross(self.turning))));
        }
        if !self.is_free() {
            s.line(format!("N = {} N·m", v(w.torque.to_array())));
        }
        if self.is_driven() {
            let time = w.start.time;
            let terms: Vec<String> =
                w.rotor.wheels().iter().map(|wheel| along(wheel, wheel.torque_at(time))).collect();
            s.sum("dh/dt", &terms, &format!("{} N·m, of the motors at t0", v(self.motor.to_array())));
        }
        let change = self.change();
        s.line(format!("{{I}} dω/dt = {text} = {} N·m", shown(change)));
        // Multiplication by I⁻¹ is a division along the principal axes.
        let into = w.rotor.principal().rotation().inverse();
        let along_axes = (into * change).to_array();
        let moments = w.rotor.principal().moments();
        let rate = [0, 1, 2].map(|k| if moments[k] > 0.0 { along_axes[k] / moments[k] } else { 0.0 });
        let rate = w.rotor.principal().rotation()
            * polhode::math::Vector::<polhode::math::quantity::AngularAcceleration, _>::from_array(rate);
        s.line(format!(
            "dω/dt = {} rad/s²",
            v(tidy_beside(rate.to_array(), self.omega.norm() * self.omega.norm()))
        ));
        s
    }

    /// Writes step 5.
    pub(crate) fn solution(&self) -> Section {
        let mut s = Section::new(5, "Solve for ω(t)");
        self.balances(&mut s);
        self.end(&mut s);
        match driven::how(self.w) {
            Some(how) => {
                s.say(format!("ω(t) {how}{}:", self.w.rows.words));
                driven::table(self.w, !self.is_free(), &mut s);
            }
            None => s.say("Add [run] to the scenario to compute values of ω(t)."),
        }
        s
    }

    /// Writes the equation of the attitude for step 6.
    pub(crate) fn attitude_formula(&self, s: &mut Section) {
        let [name, latex] = self.turning_name();
        s.formula(
            &format!("dR/dt = R [{name}]×   or   dq/dt = ½ q {name}      ({name} in body axes)"),
            &format!(r"\dot R = R [{latex}]_\times \quad\text{{or}}\quad \dot q = \tfrac12 q {latex}"),
        );
    }

    /// Writes the energy balance and the constants of the motion.
    fn balances(&self, s: &mut Section) {
        let w = self.w;
        let energy = w.rotor.kinetic_energy(self.omega);
        let of_what = if self.has_wheels() { ", that of the body without its wheels" } else { "" };
        s.line(format!("T = ½ ω · {{I}} ω = {} J{of_what}", n(energy)));
        let heat = -self.alpha * self.bending.dot(self.bending);
        let power = (w.torque - self.motor).dot(self.omega);
        let outside = match (self.is_free(), self.is_driven()) {
            (true, false) => None,
            (false, false) => Some(["N", r"\mathbf N"]),
            (true, true) => Some(["−dh/dt", r"-\dot{\mathbf h}"]),
            (false, true) => Some(["(N − dh/dt)", r"(\mathbf N - \dot{\mathbf h})"]),
        };
        let [mut text, mut latex] = outside.map_or_else(Default::default, |[text, latex]| {
            [format!("{text} · ω"), format!(r"{latex} \cdot \boldsymbol\omega")]
        });
        if self.has_sink() {
            text.push_str(if text.is_empty() { "−α |L × ω|²" } else { " − α |L × ω|²" });
            latex.push_str(r" - \alpha |\mathbf L \times \boldsymbol\omega|^2");
        }
        if text.is_empty() {
            (text, latex) = ("0".to_owned(), "0".to_owned());
        }
        let [l, l_latex] = if self.is_free() { ["0", "0"] } else { ["N", r"\mathbf N"] };
        s.formula(
            &format!("dT/dt = {},   dL/dt = {l} in space", text),
            &format!(r"\dot T = {latex}, \qquad \dot{{\mathbf L}} = {l_latex} \text{{ in space}}"),
        );
        if self.is_driven() || !self.is_free() {
            let [name, _] = outside.unwrap_or_default();
            s.line(format!("{name} · ω = {} W", n(tidy_beside([power, 0.0, 0.0], energy)[0])));
        }
        if self.has_sink() {
            s.line(format!(
                "−α |L × ω|² = -{}·{}² = {} W, which becomes heat",
                n(self.alpha),
                n(self.bending.norm()),
                n(heat)
            ));
        }
        s.say(match (self.is_free(), self.has_sink(), self.is_driven()) {
            (true, false, false) => {
                "No external torque acts, no motor works and no friction acts: L is constant in space, and T is constant."
            }
            (true, true, false) => "No external torque acts: L is constant in space. T only decreases.",
            (true, false, true) => {
                "No external torque acts: L is constant in space. T changes only while a motor works: the motor transfers angular momentum between the body and its wheel."
            }
            (true, true, true) => "No external torque acts: L is constant in space. T changes while a motor works, and otherwise decreases.",
            (false, ..) => "An external torque acts, so L changes in space: dL/dt = N.",
        });
    }

    /// Writes the limit of the motion for large times.
    fn end(&self, s: &mut Section) {
        if !self.is_free() {
            s.say(
                "While an external torque acts, L changes, so L at the start does not determine the final state.",
            );
            return;
        }
        let Some(&time) = PermanentRotation::times(self.w.rotor).last() else {
            s.say(
                "A motor never stops: its wheel gains angular momentum, and the body loses the same amount.",
            );
            return;
        };
        let size = self.momentum.norm();
        if self.is_driven() {
            self.after_the_motors(time, s);
        }
        if size == 0.0 {
            return;
        }
        let Ok(all) = PermanentRotation::all_at(self.w.rotor, size, time) else { return };
        let (Some(least), Some(most)) = (all.first(), all.last()) else { return };
        let energy = |one: &PermanentRotation| self.w.rotor.kinetic_energy(one.omega);
        let spin = |one: &PermanentRotation| {
            format!("ω = {} rad/s, T = {} J", v(one.omega.to_array()), n(energy(one)))
        };
        if !self.has_sink() {
            s.say(
                "No energy is dissipated, so there is no final state. The steady spins with this |L| of the least and the greatest \
                 energy are",
            );
            s.line(format!("least: {}", spin(least)));
            s.line(format!("most:  {}", spin(most)));
            return;
        }
        let such = if all.iter().filter(|one| energy(one) <= energy(least) * (1.0 + 1e-12)).count() > 1 {
            "such as"
        } else {
            ""
        };
        s.say("Friction lowers T at constant |L| until ω lies along L, where T is minimal:");
        s.line(format!("{such} {}", spin(least)).trim_start());
        if !self.is_driven() {
            let now = self.w.rotor.kinetic_energy(self.omega);
            let lost = now - energy(least);
            let part = if now > 0.0 { format!(", {} % of T", n(100.0 * lost / now)) } else { String::new() };
            s.line(format!("dissipated as heat: {} - {} = {} J{part}", n(now), n(energy(least)), n(lost)));
        }
        self.decay(&all, s);
    }

    /// Writes the linear decay rates near the steady spins with this |L|.
    fn decay(&self, all: &[PermanentRotation], s: &mut Section) {
        let Ok(sink) = EnergySink::new(self.alpha) else { return };
        s.say("Rates, from the equations linearized about the steady spins with this |L| (polhode stability lists them all):");
        // Opposite spins have equal energy; the one closer to ω is taken.
        let energy = |one: &PermanentRotation| self.w.rotor.kinetic_energy(one.omega);
        let nearest = |extreme: Option<&PermanentRotation>| {
            let level = energy(extreme?);
            let alike = all.iter().filter(|one| (energy(one) - level).abs() <= 1e-12 * level);
            let toward = |one: &&PermanentRotation| one.omega.dot(self.omega);
            alike.max_by(|a, b| toward(a).total_cmp(&toward(b))).copied()
        };
        for one in [nearest(all.last()), nearest(all.first())].into_iter().flatten() {
            let decay = match one.with_friction(&sink) {
                DissipativeLimit::Leaves { rate, .. } => {
                    format!("a deviation grows by a factor e in {} s", n(1.0 / rate))
                }
                DissipativeLimit::Settles { rate, .. } => {
                    format!("a deviation decays to 1/e in {} s", n(1.0 / rate))
                }
                _ => "a deviation stays constant".to_owned(),
            };
            s.line(format!("from ω = {} rad/s: {decay}", v(one.omega.to_array())));
        }
    }

    /// Writes the momentum of the wheels after the last motor has stopped.
    fn after_the_motors(&self, time: f64, s: &mut Section) {
        let h = self.w.rotor.wheel_momentum(time);
        s.line(format!("h after the last motor, at t = {} s: {} kg·m²/s", n(time), v(h.to_array())));
        if self.momentum.norm() > 0.0 {
            s.say("L is constant in space, and with these h the body has {I} ω = L − h.");
            return;
        }
        // I ω = −h is solved along the principal axes.
        let into = self.w.rotor.principal().rotation().inverse();
        let along = (into * h).to_array();
        let moments = self.w.rotor.principal().moments();
        let omega = [0, 1, 2].map(|k| if moments[k] > 0.0 { -along[k] / moments[k] } else { 0.0 });
        let omega = self.w.rotor.principal().rotation() * AngularVelocity::from_array(omega);
        s.say("L = 0 remains: the body rotates against its wheels, {I} ω = −h, steadily once the motors have stopped:");
        s.line(format!("ω = −{{I}}⁻¹ h = {} rad/s", v(omega.to_array())));
    }

    pub(crate) fn answer(&self) -> String {
        let l = v(self.momentum.to_array());
        let energy = n(self.w.rotor.kinetic_energy(self.omega));
        let rest = match (self.is_free(), self.has_sink()) {
            (true, true) => "L is constant in space and T decreases to the minimum for this |L|",
            (true, false) => "L is kept in space",
            (false, _) => "L changes by the torque from outside",
        };
        let sum = if self.has_wheels() { "{I} ω + h" } else { "{I} ω" };
        format!("Internal motion: L = {sum} = {l} kg·m²/s and T = {energy} J at the start; {rest}.")
    }
}

/// Formats the angular momentum of a wheel: `0.3·(0, 0, 1)`.
fn along(wheel: &Wheel, size: f64) -> String {
    let held = if wheel.motor() == Motor::HeldSpeed { " (held)" } else { "" };
    format!("{}·{}{held}", factor(size), v(wheel.axis().to_array()))
}
