//! A body with wheels or friction inside, worked out: the steps for one rigid body would leave out what moves in it.

use polhode::math::{AngularMomentum, AngularVelocity, Body, Torque};
use polhode::motion::torque::{EnergySink, TorqueModel};
use polhode::motion::{Motor, Wheel};
use polhode::observe::{DissipativeLimit, PermanentRotation};

use super::document::{Document, Section};
use super::driven;
use super::working::{Working, exactly, factor, n, v};
use crate::number::{tidy_beside, tidy_matrix};
use crate::torque::Description;

/// The worked solution, if something moves inside the body.
pub(super) fn solved(w: &Working<'_>) -> Option<Document> {
    let sinks = w.scenario.torques().iter().filter(|torque| matches!(torque, TorqueModel::EnergySink(_)));
    let sinks: Vec<String> = sinks.map(|sink| Description::of(sink).text()).collect();
    if w.scenario.wheels().is_empty() && sinks.is_empty() {
        return None;
    }
    let inside = Inside::of(w);
    let mut sections = vec![equations(w, &sinks), inside.at_start(), inside.balances(), inside.end()];
    sections.extend(motion(w));
    for (number, section) in (1..).zip(&mut sections) {
        section.number = number;
    }
    Some(Document {
        findings: w.findings(),
        title: w.scenario.title().map(str::to_owned).unwrap_or_else(|| "A rigid body".to_owned()),
        answer: vec![inside.answer()],
        sections,
    })
}

fn equations(w: &Working<'_>, sinks: &[String]) -> Section {
    let mut s = Section::new(1, "What moves inside");
    for wheel in w.scenario.wheels() {
        s.say(format!("Inside is {}.", Description::of_wheel(wheel).text()));
    }
    for sink in sinks {
        s.say(format!("Inside is {sink}."));
    }
    s.say(
        "h is the angular momentum of the wheels, I the inertia tensor without what wheels with a motor have about their axes, and α the \
         coefficient of the energy sink. In body axes, which turn at Ω:",
    );
    s.formula(
        "L = {I} ω + h,   Ω = ω + α L × ω,   {I} dω/dt = L × Ω + N − dh/dt",
        r"\mathbf L = \lbrace \mathbf I \rbrace \cdot \boldsymbol\omega + \mathbf h, \qquad \boldsymbol\Omega = \boldsymbol\omega + \alpha \mathbf L \times \boldsymbol\omega, \qquad \lbrace \mathbf I \rbrace \cdot \dot{\boldsymbol\omega} = \mathbf L \times \boldsymbol\Omega + \mathbf N - \dot{\mathbf h}",
    );
    s
}

/// The numbers at the start.
struct Inside<'a, 'w> {
    w: &'a Working<'w>,
    /// Σ α
    alpha: f64,
    omega: AngularVelocity<Body>,
    h: AngularMomentum<Body>,
    momentum: AngularMomentum<Body>,
    /// L × ω
    bending: Torque<Body>,
    /// Ω
    turning: AngularVelocity<Body>,
    /// dh/dt
    motor: Torque<Body>,
}

impl<'a, 'w> Inside<'a, 'w> {
    fn of(w: &'a Working<'w>) -> Self {
        let coefficient = |torque: &TorqueModel| match torque {
            TorqueModel::EnergySink(sink) => sink.coefficient(),
            _ => 0.0,
        };
        let alpha = w.scenario.torques().iter().map(coefficient).sum();
        let (omega, time) = (w.start.omega, w.start.time);
        let h = w.rotor.wheel_momentum(time);
        let momentum = w.rotor.angular_momentum(omega) + h;
        let bending = momentum.cross(omega);
        let turning = omega + AngularVelocity::from_array((bending * alpha).to_array());
        Self { w, alpha, omega, h, momentum, bending, turning, motor: w.rotor.motor_torque(time) }
    }

    fn has_sink(&self) -> bool {
        self.alpha > 0.0
    }

    /// Torques from outside.
    fn is_free(&self) -> bool {
        self.w.scenario.torques().iter().all(|torque| matches!(torque, TorqueModel::EnergySink(_)))
    }

    fn is_driven(&self) -> bool {
        self.w.rotor.wheels().iter().any(Wheel::is_driven)
    }

    /// L × Ω + N − dh/dt
    fn change(&self) -> Torque<Body> {
        self.momentum.cross(self.turning) + self.w.torque - self.motor
    }

    fn at_start(&self) -> Section {
        let w = self.w;
        let mut s = Section::new(2, "The start, step by step");
        s.say(format!("About {}, along body axes:", w.point_name()));
        s.matrix("{I}", tidy_matrix(w.rotor.inertia().matrix()), "kg·m²");
        let [i1, i2, i3] = w.rotor.principal().moments();
        s.line(format!("i1 = {},  i2 = {},  i3 = {} kg·m²", n(i1), n(i2), n(i3)));
        s.line(format!("ω   = {} rad/s", exactly(self.omega.to_array())));
        let carried = w.rotor.angular_momentum(self.omega);
        s.line(format!("{{I}} ω = {} kg·m²/s", v(carried.to_array())));
        let time = w.start.time;
        let terms: Vec<String> =
            w.rotor.wheels().iter().map(|wheel| along(wheel, wheel.momentum_at(time))).collect();
        if !terms.is_empty() {
            s.sum("h  ", &terms, &format!("{} kg·m²/s", v(self.h.to_array())));
        }
        let sum = if terms.is_empty() { "{I} ω" } else { "{I} ω + h" };
        s.line(format!(
            "L   = {sum} = {} kg·m²/s,  |L| = {} kg·m²/s",
            v(self.momentum.to_array()),
            n(self.momentum.norm())
        ));
        let space = w.start.attitude * self.momentum;
        s.line(format!("    = {} kg·m²/s in space axes", v(space.to_array())));
        let scale = self.momentum.norm() * self.omega.norm();
        let shown = |torque: Torque<Body>| v(tidy_beside(torque.to_array(), scale));
        s.line(format!("L × ω = {} N·m", shown(self.bending)));
        if self.has_sink() {
            s.line(format!(
                "Ω   = ω + α L × ω = {} + {}·{} = {} rad/s",
                v(self.omega.to_array()),
                n(self.alpha),
                shown(self.bending),
                v(self.turning.to_array())
            ));
            s.line(format!("L × Ω = {} N·m", shown(self.momentum.cross(self.turning))));
        }
        if !self.is_free() {
            s.line(format!("N   = {} N·m", v(w.torque.to_array())));
        }
        if self.is_driven() {
            let terms: Vec<String> =
                w.rotor.wheels().iter().map(|wheel| along(wheel, wheel.torque_at(time))).collect();
            s.sum("dh/dt", &terms, &format!("{} N·m, of the motors at t0", v(self.motor.to_array())));
        }
        let change = self.change();
        s.line(format!("{{I}} dω/dt = L × Ω + N − dh/dt = {} N·m", shown(change)));
        // I⁻¹, by the principal axes
        let into = w.rotor.principal().rotation().inverse();
        let along_axes = (into * change).to_array();
        let rate =
            [0, 1, 2].map(|k| if [i1, i2, i3][k] > 0.0 { along_axes[k] / [i1, i2, i3][k] } else { 0.0 });
        let rate = w.rotor.principal().rotation()
            * polhode::math::Vector::<polhode::math::quantity::AngularAcceleration, _>::from_array(rate);
        s.line(format!(
            "dω/dt = {} rad/s²",
            v(tidy_beside(rate.to_array(), self.omega.norm() * self.omega.norm()))
        ));
        s
    }

    fn balances(&self) -> Section {
        let w = self.w;
        let mut s = Section::new(3, "Energy, and what is kept");
        let energy = w.rotor.kinetic_energy(self.omega);
        s.line(format!("T = ½ ω · {{I}} ω = {} J, that of the body without its wheels", n(energy)));
        let heat = -self.alpha * self.bending.dot(self.bending);
        let power = (w.torque - self.motor).dot(self.omega);
        s.formula(
            "dT/dt = (N − dh/dt) · ω − α |L × ω|²,   dL/dt = N in space",
            r"\dot T = (\mathbf N - \dot{\mathbf h}) \cdot \boldsymbol\omega - \alpha \lvert \mathbf L \times \boldsymbol\omega \rvert^2, \qquad \dot{\mathbf L} = \mathbf N \text{ in space}",
        );
        if self.is_driven() || !self.is_free() {
            s.line(format!("(N − dh/dt) · ω = {} W", n(tidy_beside([power, 0.0, 0.0], energy)[0])));
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
                "No torque acts from outside, no motor turns a wheel and nothing rubs: L is kept in space, and T is kept."
            }
            (true, true, false) => "No torque acts from outside: L is kept in space. T only falls.",
            (true, false, true) => {
                "No torque acts from outside: L is kept in space. T changes only while a motor works: what a motor takes from the \
                 body's angular momentum its wheel has."
            }
            (true, true, true) => "No torque acts from outside: L is kept in space. T changes while a motor works, and falls else.",
            (false, ..) => "A torque acts from outside, so that L changes in space as the torque says.",
        });
        s
    }

    /// To what it tends.
    fn end(&self) -> Section {
        let mut s = Section::new(4, "Where it leads");
        if !self.is_free() {
            s.say("The torque from outside goes on, so that there is no end that L alone decides.");
            return s;
        }
        let Some(&time) = PermanentRotation::times(self.w.rotor).last() else {
            s.say("A motor never stops: its wheel has more and more angular momentum, and the body as much less.");
            return s;
        };
        let size = self.momentum.norm();
        if self.is_driven() {
            self.after_the_motors(time, &mut s);
        }
        if size == 0.0 {
            return s;
        }
        let Ok(all) = PermanentRotation::all_at(self.w.rotor, size, time) else { return s };
        let (Some(least), Some(most)) = (all.first(), all.last()) else { return s };
        let energy = |one: &PermanentRotation| self.w.rotor.kinetic_energy(one.omega);
        let spin = |one: &PermanentRotation| {
            format!("ω = {} rad/s, T = {} J", v(one.omega.to_array()), n(energy(one)))
        };
        if !self.has_sink() {
            s.say(
                "Nothing costs energy, so that it tends nowhere. Of the spins that stay, those with this |L| that have the least and the most \
                 energy are",
            );
            s.line(format!("least: {}", spin(least)));
            s.line(format!("most:  {}", spin(most)));
            return s;
        }
        let such = if all.iter().filter(|one| energy(one) <= energy(least) * (1.0 + 1e-12)).count() > 1 {
            "such as"
        } else {
            ""
        };
        s.say("Friction lowers T at the |L| that is kept, until ω lies along L where T is least:");
        s.line(format!("{such} {}", spin(least)).trim_start().to_owned());
        if !self.is_driven() {
            let now = self.w.rotor.kinetic_energy(self.omega);
            let lost = now - energy(least);
            let part = if now > 0.0 { format!(", {} % of T", n(100.0 * lost / now)) } else { String::new() };
            s.line(format!("what becomes heat: {} - {} = {} J{part}", n(now), n(energy(least)), n(lost)));
        }
        self.decay(&all, &mut s);
        s
    }

    /// The linear rates next to the spins with this |L|.
    fn decay(&self, all: &[PermanentRotation], s: &mut Section) {
        let Ok(sink) = EnergySink::new(self.alpha) else { return };
        s.say("How fast, by the linear equations next to the spins that have this |L| (polhode stability has them all):");
        for one in [all.last(), all.first()].into_iter().flatten() {
            let decay = match one.with_friction(&sink) {
                DissipativeLimit::Leaves { rate, .. } => {
                    format!("a departure grows by e in {} s", n(1.0 / rate))
                }
                DissipativeLimit::Settles { rate, .. } => {
                    format!("a departure falls to 1/e in {} s", n(1.0 / rate))
                }
                _ => "a departure stays".to_owned(),
            };
            s.line(format!("from ω = {} rad/s: {decay}", v(one.omega.to_array())));
        }
    }

    /// What the wheels have in the end.
    fn after_the_motors(&self, time: f64, s: &mut Section) {
        let h = self.w.rotor.wheel_momentum(time);
        s.line(format!("h after the last motor, at t = {} s: {} kg·m²/s", n(time), v(h.to_array())));
        if self.momentum.norm() > 0.0 {
            s.say("L stays in space, and with these h the body has {I} ω = L − h.");
            return;
        }
        // I ω = −h, by the principal axes
        let into = self.w.rotor.principal().rotation().inverse();
        let along = (into * h).to_array();
        let moments = self.w.rotor.principal().moments();
        let omega = [0, 1, 2].map(|k| if moments[k] > 0.0 { -along[k] / moments[k] } else { 0.0 });
        let omega = self.w.rotor.principal().rotation() * AngularVelocity::from_array(omega);
        s.say("L = 0 stays so: the body turns against its wheels, {I} ω = −h, steadily once the motors have stopped:");
        s.line(format!("ω = −{{I}}⁻¹ h = {} rad/s", v(omega.to_array())));
    }

    fn answer(&self) -> String {
        let l = v(self.momentum.to_array());
        let energy = n(self.w.rotor.kinetic_energy(self.omega));
        let rest = match (self.is_free(), self.has_sink()) {
            (true, true) => "L is kept in space and T falls to the least that |L| allows",
            (true, false) => "L is kept in space",
            (false, _) => "L changes by the torque from outside",
        };
        format!(
            "Something moves inside: L = {{I}} ω + h = {l} kg·m²/s and T = {energy} J at the start; {rest}."
        )
    }
}

/// `0.3·(0, 0, 1)`
fn along(wheel: &Wheel, size: f64) -> String {
    let held = if wheel.motor() == Motor::HeldSpeed { " (held)" } else { "" };
    format!("{}·{}{held}", factor(size), v(wheel.axis().to_array()))
}

/// The computed motion, at a few times.
fn motion(w: &Working<'_>) -> Option<Section> {
    let samples = w.few_samples();
    let how = driven::how(w)?;
    let mut s = Section::new(5, "The motion");
    s.say(format!("ω(t) {how}:"));
    driven::table(&samples, true, &mut s);
    Some(s)
}
