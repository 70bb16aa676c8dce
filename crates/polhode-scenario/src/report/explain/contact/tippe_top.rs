//! Step 5 of a tippe top: Jellett's constant, energy over tilt, and the reason for its rise.

use std::f64::consts::PI;

use polhode::math::{Body, Direction};
use polhode::motion::contact::Grip;
use polhode::observe::{EndState, Place, TippeTop};
use polhode_document::Section;
use polhode_document::graph::Graph;
use polhode_document::unit::angle;

use super::super::tensor::along_body_axis;
use super::super::working::{cells, factor, n, v};
use super::OnGround;

pub(crate) fn solve(g: &OnGround<'_, '_>, top: &TippeTop, e: Direction<Body>, s: &mut Section) -> String {
    let l = g.w.rotor.angular_momentum(g.start.state.omega);
    let jellett = -Direction::<Body>::from_array(g.arm.to_array()).dot(l);
    s.say(
        "A symmetric ball with its centre of mass off its centre: a tippe top. Its axis e points from the centre of mass to the centre of the sphere, at the distance α R, at θ from n; θ = 0 is with the centre of mass lowest.",
    );
    let name = along_body_axis(e).map_or_else(String::new, |name| format!(" = {name}"));
    s.line(format!("e = {}{name},  A = {},  C = {} kg·m²", v(e.to_array()), n(top.across), n(top.along)));
    s.line(format!(
        "R = {} m,  α = {},  A/C = {}",
        n(top.radius),
        n(top.eccentricity),
        n(top.across / top.along)
    ));
    s.line(format!("θ = {} at t0", angle(e.angle_to(g.up))));
    constant(g, jellett, s);
    reason(g, e, s);
    energy(g, top, jellett, s);
    groups(g, top, jellett, s);
    ends(g, top, jellett, e, s)
}

fn constant(g: &OnGround<'_, '_>, jellett: f64, s: &mut Section) {
    s.say("One quantity is constant for every friction (Jellett 1872). As r = −R (n − α e), with e\u{307} = ω × e, and L, ω and e in one plane,");
    s.formula(
        "J = −L · r,   dJ/dt = −[r × (N n + F)] · r − α R L · (ω × e) = 0",
        r"J = -\mathbf L \cdot \mathbf r, \qquad \frac{dJ}{dt} = -\left[\mathbf r \times (N \mathbf n + \mathbf F)\right] \cdot \mathbf r - \alpha R \mathbf L \cdot (\boldsymbol\omega \times \mathbf e) = 0",
    );
    if g.is_resisted() {
        s.say("But rolling and pivoting resistance change it: here it is only nearly constant.");
    }
    s.line(format!("J = {} kg·m³/s", n(jellett)));
    if let Some(last) = g.last() {
        let body = g.w.body();
        let arm = Direction::<Body>::from_array((last.contact_in_body - body.center_of_mass()).to_array());
        let then = -arm.dot(g.w.rotor.angular_momentum(last.state.omega));
        s.line(format!("  = {} kg·m³/s at the end of the run, t = {} s", n(then), n(last.state.time)));
    }
}

/// Writes the torque of friction, and the change of L that it causes.
fn reason(g: &OnGround<'_, '_>, e: Direction<Body>, s: &mut Section) {
    s.say(
        "Why it rises. Spun about the vertical at Ω with its axis off by θ, P slips at u ≈ Ω n × r, because it is off the axis of the spin. Friction opposes the slip: it is horizontal and perpendicular to the plane of n and e, and its torque about the centre of mass lies in that plane:",
    );
    s.formula(
        "F = −µ N û,   û = n × e / sin θ;   (r × F) · n = −µ N α R sin θ,   (r × F) · e = −µ N R sin θ",
        r"\mathbf F = -\mu N \hat{\mathbf u}, \quad \hat{\mathbf u} = \frac{\mathbf n \times \mathbf e}{\sin\theta}; \qquad (\mathbf r \times \mathbf F) \cdot \mathbf n = -\mu N \alpha R \sin\theta, \qquad (\mathbf r \times \mathbf F) \cdot \mathbf e = -\mu N R \sin\theta",
    );
    s.say(
        "So L · e decreases 1/α times as fast as L · n. L is large and stays nearly vertical. Because its component along e decreases through zero, e must turn away from L: upward. (The same torque raises a top on a rounded tip.) Jellett's constant in one line: J/R = L · n − α L · e.",
    );
    let friction = g.start.state.attitude.inverse() * super::direction(g.start.friction.to_array());
    let torque = Direction::<Body>::from_array(g.arm.to_array()).cross(friction);
    if g.start.slip.norm() > 0.0 && !g.is_frictionless() {
        s.line(format!(
            "at t0: |u| = {} m/s,  |F| = {} N",
            n(g.start.slip.norm()),
            n(g.start.friction.norm())
        ));
        s.line(format!("(r × F) · n = {} N·m,  (r × F) · e = {} N·m", n(torque.dot(g.up)), n(torque.dot(e))));
        s.line(format!("the dissipated power is F · u = {} W", n(g.start.friction.dot(g.start.slip))));
    } else if g.is_frictionless() {
        s.say("Without friction it does not rise: T + U, L · n and ω · e are constant, and θ oscillates.");
    } else {
        s.say("At t0 it does not slip: friction dissipates nothing and does not raise it unless it slips.");
    }
}

fn energy(g: &OnGround<'_, '_>, top: &TippeTop, jellett: f64, s: &mut Section) {
    s.say("Final state: friction dissipates energy as long as P slips, and J is constant: of all motions with this J at a tilt, the one that does not slip has the least energy,");
    s.formula(
        "W(θ) = J²/(2 R² D) + m g R (1 − α cos θ),   D = A sin²θ + C (cos θ − α)²",
        r"W(\theta) = \frac{J^2}{2 R^2 D} + m g R (1 - \alpha \cos\theta), \qquad D = A \sin^2\theta + C (\cos\theta - \alpha)^2",
    );
    s.say("and it ends in a minimum of W. T + U at the start exceeds it by the energy of the slip:");
    let up = g.start.normal.dot(g.start.center) * g.contact.gravity.norm() * g.w.body().mass();
    let from = g.start.normal.dot(g.start.contact) * g.contact.gravity.norm() * g.w.body().mass();
    let total = g.start.kinetic_energy + up - from;
    let tilt = g.axis().map_or(0.0, |e| e.angle_to(g.up));
    s.line(format!("T + U = {} J at t0,  W(θ0) = {} J", n(total), n(top.least_energy(jellett, tilt.cos()))));
    const POINTS: u32 = 181;
    let points: Vec<[f64; 2]> = (0..POINTS)
        .map(|k| PI * f64::from(k) / f64::from(POINTS - 1))
        .map(|theta| [theta.to_degrees(), top.least_energy(jellett, theta.cos())])
        .collect();
    let least = points.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
    let depth = (total - least).max(1e-9 * least.abs());
    let points: Vec<[f64; 2]> = points.into_iter().filter(|p| p[1] <= least + 4.0 * depth).collect();
    if points.len() > 2 {
        s.graph(Graph {
            title: "The least energy with this J".to_owned(),
            across: ["θ", "°"],
            up: ["W", "J"],
            points,
            level: ([0.0, 180.0, total], "T + U at the start"),
        });
    }
}

fn groups(g: &OnGround<'_, '_>, top: &TippeTop, jellett: f64, s: &mut Section) {
    s.say("Which final states are minima depends on A, C, α and J:");
    s.formula(
        "J1² = m g R³ α C² (1 − α)⁴/[A − C (1 − α)],   J2² = m g R³ α C² (1 + α)⁴/[C (1 + α) − A]",
        r"J_1^2 = \frac{m g R^3 \alpha C^2 (1 - \alpha)^4}{A - C (1 - \alpha)}, \qquad J_2^2 = \frac{m g R^3 \alpha C^2 (1 + \alpha)^4}{C (1 + \alpha) - A}",
    );
    let less = top.along * (1.0 - top.eccentricity);
    let more = top.along * (1.0 + top.eccentricity);
    s.line(format!("C (1 − α) = {},  A = {},  C (1 + α) = {} kg·m²", n(less), n(top.across), n(more)));
    s.say(match top.group() {
        1 => "A < C (1 − α): the bottom is a minimum at every J, and nothing that is spun there leaves it (group I).",
        2 => "C (1 − α) < A < C (1 + α): the bottom is a minimum up to |J| = J1, the inverted position from J2 on: it turns over if it is spun fast enough (group II).",
        _ => "A > C (1 + α): the bottom is a minimum up to |J| = J1, the inverted position never: it rises to a tilt (group III).",
    });
    // Jellett's constant at a spin of 1 rad/s about the vertical, with the centre of mass lowest.
    let of_spin = top.jellett_of_bottom(1.0);
    for (name, limit, what) in [
        ("J1", top.bottom_up_to(), "leaves the bottom if it is spun there at more than"),
        ("J2", top.inverted_from(), "stands inverted if it was spun at the bottom at more than"),
    ] {
        if let Some(limit) = limit {
            s.line(format!("{name} = {} kg·m³/s: {what} {} rad/s", n(limit), n(limit / of_spin)));
        }
    }
    let spin = g.start.state.omega.dot(g.up);
    let side = jellett.abs() / of_spin;
    s.line(format!(
        "the start has |J| = {}, that of {} rad/s at the bottom; it is spun at {} rad/s",
        n(jellett.abs()),
        n(side),
        factor(spin)
    ));
}

fn ends(g: &OnGround<'_, '_>, top: &TippeTop, jellett: f64, e: Direction<Body>, s: &mut Section) -> String {
    let all = top.all(jellett);
    let rows: Vec<Vec<f64>> = all
        .iter()
        .map(|state| vec![state.cosine.acos().to_degrees(), top.spin(jellett, state.cosine), state.energy])
        .collect();
    s.say("All motions with this J whose W is stationary:");
    let rows = cells(&rows).into_iter().zip(&all).map(|(row, state)| {
        let kind = if state.is_minimum { "minimum" } else { "no minimum" };
        [vec![state.place.name().to_owned()], row, vec![kind.to_owned()]].concat()
    });
    s.table(&["", "θ (°)", "ω·n (rad/s)", "W (J)", ""], rows.collect());
    let minima: Vec<&EndState> = all.iter().filter(|state| state.is_minimum).collect();
    let names: Vec<String> = minima.iter().map(|state| name(state)).collect();
    let to = names.join(", or to ");
    let dry = g.friction().sticking > 0.0;
    if g.is_frictionless() {
        return "Without friction it does not rise: it nutates.".to_owned();
    }
    if g.is_rolling() && dry || !matches!(g.contact.law.grip(), Grip::Friction(_)) {
        s.say("It rolls, so no energy is lost and it does not reach that state: it nutates about the nearest steady motion.");
        return "It rolls without slip, so friction dissipates nothing: it does not turn over.".to_owned();
    }
    if dry {
        s.say("Dry friction holds P once it is at rest. So the top may stop short of the minimum and nutate there without slip.");
    }
    let gained = top.mass * top.gravity * top.radius * top.eccentricity;
    if let Some(last) = minima.last().filter(|last| last.place != Place::Bottom) {
        let up = gained * (e.angle_to(g.up).cos() - last.cosine);
        s.line(format!("U gains m g α R (cos θ0 − cos θ) = {} J on the way to {}", n(up), name(last)));
        s.line(format!("out of the spin, of which {} rad/s are left", n(top.spin(jellett, last.cosine))));
    }
    format!("Sliding friction brings it to {to}, with J = {} kg·m³/s as at the start.", n(jellett))
}

fn name(state: &EndState) -> String {
    match state.place {
        Place::Bottom => "the bottom".to_owned(),
        Place::Tilted => format!("a tilt of {}°", n(state.cosine.acos().to_degrees())),
        Place::Inverted => "the inverted position".to_owned(),
    }
}
