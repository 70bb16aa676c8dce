//! Small motions: Euler's equations linearised about the steady motion nearest to the start.

use std::f64::consts::TAU;

use polhode::motion::State;
use polhode::motion::torque::{Drag, DragLaw, TorqueModel};
use polhode::observe::{Libration, OrbitalEquilibrium, SmallOscillations};
use polhode_document::Section;
use polhode_document::number::tidy_matrix;

use super::working::{Working, acting, cells, n, v};

/// Writes the linearized equations, if there is a steady motion for them.
pub(crate) fn solve(w: &Working<'_>, s: &mut Section) {
    let torques: Vec<TorqueModel> = acting(w.scenario).cloned().collect();
    // Drag alone is solved here; together with other torques it is part of their linear equations.
    if let [TorqueModel::Drag(drag)] = &torques[..] {
        resisted(w, drag, s);
    }
    // Near rest, drag alone only damps and does not restore.
    if torques.iter().all(|torque| matches!(torque, TorqueModel::Drag(_) | TorqueModel::Constant(_))) {
        return;
    }
    // If no attitude is in equilibrium under all torques, the gravity gradient is considered alone.
    let gradients: Vec<TorqueModel> =
        torques.iter().filter(|torque| matches!(torque, TorqueModel::GravityGradient(_))).cloned().collect();
    let all = OrbitalEquilibrium::all(w.rotor, &torques, w.start);
    let (torques, all) = match all {
        Err(_) if !gradients.is_empty() => {
            let all = OrbitalEquilibrium::all(w.rotor, &gradients, w.start);
            s.say("With all torques no attitude is at rest relative to the orbit; with the gravity gradient alone:");
            (gradients, all)
        }
        all => (torques, all),
    };
    if let Ok(Some(all)) = all {
        let circular = torques.iter().find_map(|torque| match torque {
            TorqueModel::GravityGradient(gradient) => gradient.orbit.mean_motion(),
            _ => None,
        });
        if let (Some(nearest), Some(rate)) = (all.first(), circular) {
            librations(w, nearest, rate, torques.len() == 1, s);
            modes(w, &torques, nearest.state, s);
        }
        return;
    }
    let at_rest = State { omega: polhode::math::AngularVelocity::ZERO, ..w.start };
    if let Ok(state) = SmallOscillations::equilibrium_near(w.rotor, &torques, at_rest) {
        let turned = state.attitude.angle_to(w.start.attitude).to_degrees();
        s.say(format!(
            "Small motions: the nearest attitude at rest is {}° from the start. With δθ the rotation from it, in body axes, the \
             equations linear in δθ are",
            n(turned)
        ));
        s.formula(
            "{I} δθ\u{308} = (∂N/∂θ) δθ + (∂N/∂ω) δθ\u{307}",
            r"\lbrace \mathbf I \rbrace \ddot{\delta\theta} = \frac{\partial \mathbf N}{\partial \theta} \delta\theta + \frac{\partial \mathbf N}{\partial \omega} \dot{\delta\theta}",
        );
        modes(w, &torques, state, s);
    }
}

/// Writes the decay under drag alone: the components of ω decay independently for small ω.
fn resisted(w: &Working<'_>, drag: &Drag, s: &mut Section) {
    if drag.law() == DragLaw::Quadratic {
        s.say(
            "Drag by the square of ω has no linear part: N = −|ω| D ω. About a principal axis that is one of D too, d|ω|/dt = −(d/i) ω², \
             so 1/|ω| grows linearly, ω = ω0 / (1 + ω0 d t / i): the decay is algebraic, not exponential.",
        );
        return;
    }
    s.say(
        "For small ω, ω × {I} ω is of second order and is neglected. The remaining equation is linear, with a decay rate for each \
         eigenvector of {I}⁻¹ C:",
    );
    s.formula(
        "{I} ω\u{307} = −C ω,   ω(t) = Σ ck uk exp(−t/τk),   {I}⁻¹ C uk = uk/τk",
        r"\lbrace \mathbf I \rbrace \dot{\boldsymbol\omega} = -C \boldsymbol\omega, \qquad \boldsymbol\omega(t) = \sum_k c_k \mathbf u_k e^{-t/\tau_k}, \qquad \lbrace \mathbf I \rbrace^{-1} C \mathbf u_k = \mathbf u_k / \tau_k",
    );
    s.matrix("C", tidy_matrix(drag.matrix()), "N·m·s");
    // Multiplication by {I}⁻¹ is a division along the principal axes.
    let principal = w.rotor.principal();
    let axes = principal.axes().map(polhode::math::Vector::to_array);
    let c = drag.matrix();
    let along = |a: usize, b: usize| -> f64 {
        (0..3).map(|i| (0..3).map(|j| axes[a][i] * c[i][j] * axes[b][j]).sum::<f64>()).sum()
    };
    let size = (0..3).map(|k| along(k, k)).fold(0.0, f64::max);
    if principal.moments()[0] == 0.0 {
        s.say("Without inertia about axis 1 its rate is undetermined. Perpendicular to it {I}⁻¹ C is");
        for (a, b) in [(1, 1), (1, 2), (2, 2)] {
            s.line(format!("C{0}{1} / i{0} = {2} /s", a + 1, b + 1, n(along(a, b) / principal.moments()[a])));
        }
        return;
    }
    let is_aligned = (0..3).all(|a| (0..a).all(|b| along(a, b).abs() <= 1e-12 * size));
    if is_aligned {
        for (k, moment) in principal.moments().into_iter().enumerate() {
            let time = if along(k, k) > 0.0 {
                format!("{} s", n(moment / along(k, k)))
            } else {
                "for ever".to_owned()
            };
            s.line(format!(
                "about axis {0}: τ = i{0} / C{0}{0} = {1} / {2} = {time}",
                k + 1,
                n(moment),
                n(along(k, k))
            ));
        }
    } else {
        s.say("C is not along the principal axes, so the components are coupled; along them {I}⁻¹ C is");
        let rows = std::array::from_fn(|a| std::array::from_fn(|b| along(a, b) / principal.moments()[a]));
        s.matrix("{I}⁻¹ C", tidy_matrix(rows), "/s");
    }
}

/// Writes DeBra and Delp's equations, for a body that follows its orbit.
fn librations(w: &Working<'_>, place: &OrbitalEquilibrium, rate: f64, alone: bool, s: &mut Section) {
    let moment = |k: usize| w.rotor.principal().moments()[place.axes[k].0];
    let [up, ahead, normal] = [moment(0), moment(1), moment(2)];
    let axis = |k: usize| place.axes[k].0 + 1;
    s.say(format!(
        "Small motions about the nearest attitude that keeps its face to the centre of attraction, with axis {} along the radius (yaw ψ), axis {} along the \
         flight (roll φ) and axis {} along the orbit's normal (pitch θ); n is the orbit's rate:",
        axis(0),
        axis(1),
        axis(2)
    ));
    s.formula(
        "Ip θ\u{308} + 3n² (Ir − Iy) θ = 0\n\
         Ir φ\u{308} + n (Ir + Iy − Ip) ψ\u{307} + 4n² (Ip − Iy) φ = 0\n\
         Iy ψ\u{308} − n (Ir + Iy − Ip) φ\u{307} + n² (Ip − Ir) ψ = 0",
        "\\begin{aligned}\nI_p \\ddot\\theta + 3n^2 (I_r - I_y) \\theta &= 0 \\cr\nI_r \\ddot\\varphi + n (I_r + I_y - I_p) \\dot\\psi + 4n^2 (I_p - I_y) \\varphi &= 0 \\cr\nI_y \\ddot\\psi - n (I_r + I_y - I_p) \\dot\\varphi + n^2 (I_p - I_r) \\psi &= 0\n\\end{aligned}",
    );
    s.line(format!("Ip = {},  Ir = {},  Iy = {} kg·m²,  n = {} rad/s", n(normal), n(ahead), n(up), n(rate)));
    s.line(format!("3n² (Ir − Iy) = {} N·m/rad", n(3.0 * rate * rate * (ahead - up))));
    if !alone {
        s.say("The other torques add further terms; the modes below include all torques.");
        return;
    }
    let Ok(libration) = Libration::of([ahead, normal, up], rate) else { return };
    match libration.pitch {
        Some(pitch) => {
            s.line(format!("pitch: n √(3 (Ir − Iy)/Ip) = {} rad/s, {} n", n(pitch), n(pitch / rate)));
        }
        None => s.line(format!(
            "pitch grows at n √(3 (Iy − Ir)/Ip) = {} /s",
            n(rate * (3.0 * (up - ahead) / normal).sqrt())
        )),
    }
    match libration.roll_yaw {
        Some([slow, fast]) => s.line(format!(
            "roll and yaw: {} and {} rad/s, {} n and {} n",
            n(slow),
            n(fast),
            n(slow / rate),
            n(fast / rate)
        )),
        None => s.line("roll and yaw: one of them grows"),
    }
}

/// Writes the eigenvalues, and the axis about which each mode oscillates.
fn modes(w: &Working<'_>, torques: &[TorqueModel], state: State, s: &mut Section) {
    let Ok(found) = SmallOscillations::about_equilibrium(w.rotor, torques, state) else { return };
    if found.modes.is_empty() {
        return;
    }
    let rows: Vec<Vec<f64>> = found.modes.iter().map(|mode| vec![mode.frequency, mode.growth_rate]).collect();
    let rows = cells(&rows).into_iter().zip(&found.modes).map(|(row, mode)| {
        let period = if mode.frequency > 0.0 { n(TAU / mode.frequency) } else { String::new() };
        [row, vec![period, v(mode.axis.to_array())]].concat()
    });
    s.say("δθ = e^(σt) (u cos ϖt + …), by the eigenvalues σ ± iϖ of these equations:");
    s.table(&["ϖ (rad/s)", "σ (/s)", "period (s)", "u, body axes"], rows.collect());
    if !found.is_stable() {
        s.say("A mode with σ > 0 grows: this attitude is unstable.");
    }
}
