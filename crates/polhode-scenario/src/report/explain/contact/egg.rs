//! Step 5 of an egg, an ellipsoid of revolution: why friction stands it up, and at which spins it
//! stays.

use polhode::math::{AngularVelocity, Attitude, Body, Direction, Rotation};
use polhode::motion::State;
use polhode::motion::contact::ContactStart;
use polhode::observe::{SpinningEgg, SteadyPath};
use polhode_document::Section;
use polhode_document::unit::{angle, rate};

use super::super::tensor::along_body_axis;
use super::super::working::{n, v};
use super::{OnGround, disk, vertex};

pub(crate) fn solve(
    g: &OnGround<'_, '_>,
    egg: &SpinningEgg,
    e: Direction<Body>,
    s: &mut Section,
) -> Option<String> {
    let l = g.w.rotor.angular_momentum(g.start.state.omega);
    let jellett = -Direction::<Body>::from_array(g.arm.to_array()).dot(l);
    let tilt = e.angle_to(g.up);
    let spin = g.up.dot(g.start.state.omega);
    s.say("An ellipsoid of revolution about e, with semi-axes b across and c along it. Its centre of mass is h above the ground, where e is at θ from n:");
    s.formula("h(θ) = √(b² sin²θ + c² cos²θ)", r"h(\theta) = \sqrt{b^2 \sin^2\theta + c^2 \cos^2\theta}");
    let name = along_body_axis(e).map_or_else(String::new, |name| format!(" = {name}"));
    s.line(format!("e = {}{name},  A = {},  C = {} kg·m²", v(e.to_array()), n(egg.across), n(egg.along)));
    s.line(format!("b = {} m,  c = {} m", n(egg.radius), n(egg.half_length)));
    s.line(format!("θ = {} at t0,  h = {} m", angle(tilt), n(egg.height(tilt))));
    let rises = sliding(g, egg, jellett, [tilt, spin], s);
    steady(g, s);
    standing(g, egg, e, jellett, s);
    s.say("Between, θ(t) has no closed form: it is integrated (step 6).");
    rises
}

/// Writes the balance of Moffatt and Shimomura for a sliding egg.
fn sliding(
    g: &OnGround<'_, '_>,
    egg: &SpinningEgg,
    jellett: f64,
    [tilt, spin]: [f64; 2],
    s: &mut Section,
) -> Option<String> {
    s.say(
        "While it spins fast and slips, friction is small compared with the gyroscopic torques, which balance each other: (C ω_e − A Ω cos θ) Ω sin θ = 0, so that L is nearly A Ω along the vertical. Then J = −L · r, which is constant for a ball (Jellett), is nearly constant for an egg (Moffatt, Shimomura 2002), and the energy depends on h alone:",
    );
    s.formula(
        "J = −L · r ≈ A Ω h,   E(h) = J²/(2 A h²) + m g h,   dE/dh < 0 where Ω² > m g h/A",
        r"J = -\mathbf L \cdot \mathbf r \approx A \Omega h, \qquad E(h) = \frac{J^2}{2 A h^2} + m g h, \qquad \frac{dE}{dh} < 0 \text{ where } \Omega^2 > \frac{m g h}{A}",
    );
    s.say("Friction dissipates energy. So the centre of mass rises if the spin is fast enough, and fully if |J| > √(A m g h³) with the largest h: the spin supplies the potential energy and the friction losses.");
    let height = egg.height(tilt);
    let (enough, stands) = (egg.rises_beyond(height), egg.stands_beyond());
    s.line(format!("J = {} kg·m³/s,  √(A m g h³) = {} with the largest h", n(jellett), n(stands)));
    s.line(format!("Ω = {} rad/s,  √(m g h/A) = {} rad/s at t0", n(spin), n(enough)));
    let last = g.last();
    if let Some(last) = last {
        let arm =
            Direction::<Body>::from_array((last.contact_in_body - g.w.body().center_of_mass()).to_array());
        let then = -arm.dot(g.w.rotor.angular_momentum(last.state.omega));
        s.line(format!("J at the end of the run, t = {} s: {} kg·m³/s", n(last.state.time), n(then)));
    }
    if egg.half_length > egg.radius {
        s.line(format!("on its end it would spin at J/(C c) = {} rad/s", n(egg.spin_on_end(jellett))));
    }
    if g.is_frictionless() {
        s.say("Without friction it does not rise: T + U, L · n and ω · e are constant, and θ oscillates.");
        return Some("Without friction it does not rise: it nutates.".to_owned());
    }
    if g.is_rolling() {
        s.say("It rolls without slip, so friction dissipates nothing and it does not rise.");
        return Some("It rolls without slip, so friction dissipates nothing.".to_owned());
    }
    let oblate = egg.half_length < egg.radius;
    let up = if oblate { "its rim" } else { "its end" };
    Some(if jellett.abs() > stands {
        format!(
            "It spins fast enough for friction to raise it to {up}: |J| = {} > {} kg·m³/s.",
            n(jellett.abs()),
            n(stands)
        )
    } else if spin.abs() > enough {
        format!(
            "It is raised by friction, but not to {up}: |J| = {} < {} kg·m³/s.",
            n(jellett.abs()),
            n(stands)
        )
    } else {
        format!("It spins too slowly for friction to raise it: {} < {} rad/s.", n(spin.abs()), n(enough))
    })
}

/// Writes the steady motion nearest to the start, and its stability.
fn steady(g: &OnGround<'_, '_>, s: &mut Section) {
    let Some(steady) = g.steady(&g.rolling_start()) else { return };
    let what = match steady.path {
        SteadyPath::SpinningUpright(_) => "it spins about the vertical on its side",
        SteadyPath::RollingUpright(_) => "it rolls straight on its side",
        SteadyPath::OnVertex(_) => "it spins on its end",
        SteadyPath::Circling => "it runs in a circle",
        _ => return,
    };
    s.say(format!(
        "Near to the start, {}° away, is a steady motion without slip: {what}, at {}. Slip raises the egg, and these equations do not describe slip.",
        n(steady.turned_from_start.to_degrees()),
        rate(steady.spin)
    ));
    disk::departures(g, &steady, s);
    if let Some(spins) = &steady.stable_spins {
        vertex::law(spins, s);
    }
}

/// Writes the stability of the egg on its end, at the spin that follows from J.
fn standing(g: &OnGround<'_, '_>, egg: &SpinningEgg, e: Direction<Body>, jellett: f64, s: &mut Section) {
    let spin = egg.spin_on_end(jellett);
    let axis = Direction::<Body>::from_array(e.to_array());
    let Some(attitude) = upright(axis) else { return };
    let omega = AngularVelocity::from_array((axis * spin).to_array());
    let start = ContactStart { state: State { attitude, omega, ..g.start.state }, ..g.rolling_start() };
    let Some(steady) = g.steady(&start) else { return };
    let SteadyPath::OnVertex(vertex) = steady.path else { return };
    s.say("On its end, e along n, it is a sleeping top with the point of contact for its peg. With b²/c the radius of curvature there and c the height:");
    vertex::numbers(&vertex, s);
    if let Some(spins) = &steady.stable_spins {
        vertex::law(spins, s);
    }
    s.line(format!(
        "J gives it {} rad/s there: {}",
        n(spin),
        if steady.is_stable() { "it stays" } else { "it falls" }
    ));
}

/// Returns an attitude with this body axis upright.
fn upright(axis: Direction<Body>) -> Option<Attitude> {
    let up = Direction::<Body>::new(0.0, 0.0, 1.0);
    let (across, cosine) = (axis.cross(up), axis.dot(up));
    if across.norm() < 1e-12 {
        let half = if cosine > 0.0 { 0.0 } else { std::f64::consts::PI };
        return Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), half).ok();
    }
    let turn = Direction::from_array(across.to_array());
    Rotation::from_axis_angle(turn, across.norm().atan2(cosine)).ok()
}
