//! Step 2: ω and N at t0, and the velocities.

use polhode::math::{Space, Velocity};
use polhode::motion::torque::{ConstantTorque, TorqueModel};
use polhode::motion::{KineticEnergySplit, MovingParticle, Prescribed, Rotor};
use polhode_document::Section;
use polhode_document::number::tidy;
use polhode_document::unit::{angle, rate};

use super::symbols;
use super::working::{Working, acting, cells, exactly, n, v};
use crate::report::torque::Description;

/// Largest number of particles whose velocities are listed.
const MOST_PARTICLES: usize = 12;

pub(crate) fn section(w: &Working<'_>) -> Section {
    let mut s = Section::new(2, "Note ω and N at t0");
    omega(w, &mut s);
    if let Some(symbolic) = w.exact.symbols() {
        symbols::omega(symbolic, &mut s);
    }
    torque(w, &mut s);
    kinematics(w, &mut s);
    s
}

fn omega(w: &Working<'_>, s: &mut Section) {
    let omega = w.start.omega;
    if let Some(motion) = w.scenario.prescribed() {
        given_motion(motion, s);
    } else if !w.is_turning() {
        s.say("The body does not turn at t0: ω = 0.");
        return;
    }
    s.line(format!("t0 = {} s", n(w.start.time)));
    s.line(format!("ω  = {} rad/s in body axes", exactly(omega.to_array())));
    if w.start.attitude != polhode::math::Attitude::identity() {
        s.line(format!("   = {} rad/s in space axes", v(w.start.omega_space().to_array())));
    }
    s.line(format!("|ω| = {}", rate(omega.norm())));
}

fn given_motion(motion: &Prescribed, s: &mut Section) {
    s.say("The motion is prescribed; the required torque is unknown.");
    match motion {
        Prescribed::FixedAxis { axis, rate, acceleration, .. } => {
            s.formula("ω(t) = n̂ (ω0 + α t)", r"\boldsymbol\omega(t) = \hat{\mathbf n} (\omega_0 + \alpha t)");
            s.line(format!("n̂  = {}, fixed in the body and in space", v(axis.to_array())));
            s.line(format!("ω0 = {} rad/s,  α = {} rad/s²", n(*rate), n(*acceleration)));
        }
        Prescribed::EulerRates { angles, rates, .. } => {
            s.formula(
                "φ = φ0 + φ\u{307} t,   θ = θ0 + θ\u{307} t,   ψ = ψ0 + ψ\u{307} t        (Euler angles, 3-1-3)\n\
                 ω = (φ\u{307} sin θ sin ψ + θ\u{307} cos ψ,  φ\u{307} sin θ cos ψ − θ\u{307} sin ψ,  φ\u{307} cos θ + ψ\u{307})",
                r"\boldsymbol\omega = (\dot\varphi \sin\theta \sin\psi + \dot\theta \cos\psi,\quad \dot\varphi \sin\theta \cos\psi - \dot\theta \sin\psi,\quad \dot\varphi \cos\theta + \dot\psi)"
            );
            for (name, angle0, rate) in
                [("φ", angles[0], rates[0]), ("θ", angles[1], rates[1]), ("ψ", angles[2], rates[2])]
            {
                s.line(format!("{name}0 = {},  {name}\u{307} = {} rad/s", angle(angle0), n(rate)));
            }
        }
        Prescribed::EulerAngles(_) => s.say("Its Euler angles φ, θ, ψ (3-1-3) are formulas of t; ω follows from their derivatives."),
        Prescribed::Quaternion(_) => s.say("Its attitude is a quaternion whose components are formulas of t; ω follows from their derivatives."),
        Prescribed::Turning(_) => s.say("ω(t) is given; the attitude follows from it."),
        Prescribed::Table(_) => s.say("Its attitude is a smooth interpolation of a table; ω is the derivative of that curve."),
        _ => {}
    }
}

fn torque(w: &Working<'_>, s: &mut Section) {
    if w.needed.is_some() {
        s.line("N  is unknown: step 4");
        return;
    }
    for wheel in w.scenario.wheels() {
        s.say(format!("Inside is {}.", Description::of_wheel(wheel).text()));
    }
    let is_sink = |torque: &&TorqueModel| matches!(torque, TorqueModel::EnergySink(_));
    for sink in w.scenario.torques().iter().filter(is_sink) {
        s.say(format!("Inside is {}.", Description::of(sink).text()));
    }
    if w.scenario.torques().iter().all(|torque| is_sink(&torque)) {
        s.say("No external torque acts: N = 0, and L is constant in space.");
        return;
    }
    s.say("Torque at t0, in body axes:");
    for model in acting(w.scenario).filter(|torque| !is_sink(torque)) {
        let at_start = v(model.torque(w.rotor, &w.start).to_array());
        match model {
            TorqueModel::Gravity(g) => {
                let down = w.start.attitude.inverse() * g.acceleration;
                s.formula(
                    "N = Σ rα × mα g = l × M g",
                    r"\mathbf N = \sum_\alpha \mathbf r_\alpha \times m_\alpha \mathbf g = \mathbf l \times M \mathbf g",
                );
                s.line(format!("l = {} m,  M = {} kg", v(w.rotor.lever().to_array()), n(w.rotor.mass())));
                s.line(format!("g = {} m/s² in body axes", v(down.to_array())));
                s.line(format!("N = {at_start} N·m"));
                if w.scenario.pivot().is_none() {
                    s.say("Uniform gravity has no torque about the centre of mass (l = 0).");
                }
            }
            TorqueModel::Constant(ConstantTorque::Body(_)) => {
                s.line(format!("N = {at_start} N·m, constant in body axes"));
            }
            TorqueModel::Constant(ConstantTorque::Space(n)) => {
                s.line(format!("N = {at_start} N·m, from {} N·m constant in space axes", v(n.to_array())));
            }
            other => s.line(format!("N = {at_start} N·m: {}", Description::of(other).text())),
        }
    }
    if acting(w.scenario).count() > 1 {
        s.line(format!("sum N = {} N·m", v(w.torque.to_array())));
    }
}

fn kinematics(w: &Working<'_>, s: &mut Section) {
    let velocity = w.center_velocity();
    if !w.is_turning() && velocity.norm() == 0.0 {
        s.say("The body is at rest at t0: every v = 0 and T = 0.");
        return;
    }
    s.say("The velocity of a point of the body, with V the velocity of the origin and r the vector from the origin to the point:");
    s.formula("v = V + ω × r", r"\mathbf v = \mathbf V + \boldsymbol\omega \times \mathbf r");
    if w.scenario.pivot().is_some() {
        s.line("V  = 0: the pivot is fixed");
        s.line(format!("Vc = ω × l = {} m/s, the centre of mass, in space axes", v(velocity.to_array())));
    } else {
        s.line(format!("V = {} m/s, the centre of mass, in space axes", v(velocity.to_array())));
    }
    let moving = w.moving_particles();
    if w.scenario.is_all_particles() && (1..=MOST_PARTICLES).contains(&moving.len()) {
        let rows: Vec<Vec<f64>> = moving
            .iter()
            .map(|p| {
                let [x, y, z] = tidy(p.velocity.to_array());
                vec![x, y, z, p.velocity.norm()]
            })
            .collect();
        let headers = ["α", "vx (m/s)", "vy (m/s)", "vz (m/s)", "|v| (m/s)"];
        s.table(&headers, super::body::numbered(cells(&rows)));
    }
    if w.scenario.wheels().is_empty() {
        energy(w, &moving, velocity, s);
    }
}

/// Writes the kinetic energy T = T_trans + T_rot, with the value of the cross term.
fn energy(w: &Working<'_>, moving: &[MovingParticle<Space>], velocity: Velocity<Space>, s: &mut Section) {
    s.say(
        "With the centre of mass as the origin and V its velocity, the kinetic energy is the sum of the translational and the rotational energy. The cross term is zero, because Σ mα rα = 0.",
    );
    s.formula(
        "T = ½ M V² + V · (ω × Σ mα rα) + ½ Σ mα (ω × rα)² = T_trans + 0 + T_rot",
        r"T = \tfrac12 M V^2 + \mathbf V \cdot \left(\boldsymbol\omega \times \sum_\alpha m_\alpha \mathbf r_\alpha\right) + \tfrac12 \sum_\alpha m_\alpha (\boldsymbol\omega \times \mathbf r_\alpha)^2 = T_{\text{trans}} + 0 + T_{\text{rot}}",
    );
    let split = KineticEnergySplit::of(moving, velocity);
    let exact = w.scenario.is_all_particles() && !moving.is_empty();
    // Particles at the centres of the parts give T_trans and the cross term, but not all of T_rot.
    let about_center = Rotor::free(w.body()).kinetic_energy(w.start.omega);
    let rotation = if exact { split.rotation } else { about_center };
    let translation = 0.5 * w.body().mass() * velocity.dot(velocity);
    let total = translation + rotation;
    s.line(format!(
        "T_trans = ½ M V² = ½ · {} · {}² = {} J",
        n(w.body().mass()),
        n(velocity.norm()),
        n(translation)
    ));
    s.line(format!(
        "cross   = {} J{}",
        polhode_document::number::error(split.cross),
        rounding_note(split.cross)
    ));
    let how = if exact { "½ Σ mα (ω × rα)²" } else { "½ ω · {I} · ω" };
    s.line(format!("T_rot   = {how} = {} J, about the centre of mass", n(rotation)));
    s.line(format!("T       = {} J", n(total)));
    if w.scenario.pivot().is_some() {
        s.say("About the fixed pivot, all kinetic energy is rotational; step 3 gives the same value with the tensor about the pivot.");
    } else if let Some(first) = moving.first().filter(|_| exact && w.is_turning() && moving.len() > 1) {
        let other = KineticEnergySplit::of(moving, first.velocity);
        s.say("T does not depend on the origin, but with another origin the cross term is not zero. With particle 1 as the origin:");
        s.line(format!(
            "T = {} + {} + {} = {} J",
            n(other.translation),
            factor_or_noise(other.cross, total),
            n(other.rotation),
            n(other.total())
        ));
    }
}

fn rounding_note(cross: f64) -> &'static str {
    if cross == 0.0 { "" } else { " (rounding)" }
}

fn factor_or_noise(x: f64, scale: f64) -> String {
    super::working::factor(if x.abs() <= 1e-14 * scale { 0.0 } else { x })
}
