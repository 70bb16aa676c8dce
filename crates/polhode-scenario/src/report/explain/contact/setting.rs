//! Steps 1 and 2 on the ground: the contact, its constraint, and the forces at t0.

use polhode::math::{Attitude, Direction, Space, Velocity};
use polhode::motion::contact::{Grip, SurfaceShape};
use polhode_document::Section;
use polhode_document::number::tidy_beside;
use polhode_document::unit::rate;

use super::super::working::{exactly, factor, n, v};
use super::OnGround;
use crate::report::facts;

/// Writes step 1.
pub(crate) fn axes(g: &OnGround<'_, '_>) -> Section {
    let mut s = Section::new(1, "Choose the axes");
    s.say(
        "Body axes x, y, z: fixed in the body, so that {I} is constant; they turn with it at ω. Origin: the centre of mass C, about which the equations of rotation hold for every motion of C. With the point of contact as the origin the force would drop out, but this point moves in the body and on the ground (step 4).",
    );
    s.line(format!("C = {} m", v(g.w.body().center_of_mass().to_array())));
    if g.w.start.attitude == Attitude::identity() {
        s.say("At t0 the body axes are parallel to the space axes: R(t0) = 1.");
    } else {
        s.say("At t0 the attitude is R(t0), with the body axes x, y, z in space axes as columns: a_space = R\u{a0}a_body.");
        s.matrix("R(t0)", g.w.start.attitude.matrix(), "");
    }
    let surface = &g.contact.surface;
    s.say(format!(
        "Surface: {}. Ground: {}. With n the normal of the ground, towards the body, the point of contact P is where the surface has the outer normal −n, at r from C. As the body turns, n does so in the \
         body, and r with it:",
        facts::surface(surface),
        facts::form(&g.contact.ground)
    ));
    let (text, latex) = match surface.shape() {
        SurfaceShape::Ellipsoid { .. } => (
            "r = d − A n / √(n · A n),   A = diag(a², b², c²) along its axes,   n\u{307} = n × ω",
            r"\mathbf r = \mathbf d - \frac{A \mathbf n}{\sqrt{\mathbf n \cdot A \mathbf n}}, \qquad A = \operatorname{diag}(a^2, b^2, c^2), \qquad \dot{\mathbf n} = \mathbf n \times \boldsymbol\omega",
        ),
        SurfaceShape::Rim { .. } => (
            "r = d + R p − τ n,   p = [(n · e) e − n] / |(n · e) e − n|,   n\u{307} = n × ω",
            r"\mathbf r = \mathbf d + R \mathbf p - \tau \mathbf n, \qquad \mathbf p = \frac{(\mathbf n \cdot \mathbf e) \mathbf e - \mathbf n}{|(\mathbf n \cdot \mathbf e) \mathbf e - \mathbf n|}, \qquad \dot{\mathbf n} = \mathbf n \times \boldsymbol\omega",
        ),
        _ => (
            "r = d − R n,   n\u{307} = n × ω",
            r"\mathbf r = \mathbf d - R \mathbf n, \qquad \dot{\mathbf n} = \mathbf n \times \boldsymbol\omega",
        ),
    };
    s.formula(text, latex);
    let what = match surface.shape() {
        SurfaceShape::Rim { thickness, .. } if *thickness > 0.0 => {
            "d is the vector from C to the centre of the lower rim, e is its axis, R its radius, τ that of its tube, and p points downhill in its plane; n\u{307} is seen from the body, and on curved ground n turns in space besides."
        }
        SurfaceShape::Rim { .. } => {
            "d is the vector from C to the centre of the rim, e is its axis, R its radius, τ that of its tube, and p points downhill in its plane; n\u{307} is seen from the body, and on curved ground n turns in space besides."
        }
        _ => {
            "d is the vector from C to the centre of the surface; n\u{307} is seen from the body, and on curved ground n turns in space besides."
        }
    };
    s.say(what);
    let center = surface.center() - g.w.body().center_of_mass();
    let [d, up, arm] = [center.to_array(), g.up.to_array(), g.arm.to_array()];
    if !matches!(surface.shape(), SurfaceShape::Rim { thickness, .. } if *thickness > 0.0) {
        s.line(format!("d = {} m", v(d)));
    }
    s.line(format!("n = {} in body axes,  {} in space axes", v(up), v(g.start.normal.to_array())));
    s.line(format!("r = {} m in body axes", v(arm)));
    s.line(format!("C is −r · n = {} m above the ground", n(-g.up.dot(g.arm))));
    s
}

/// Writes step 2.
pub(crate) fn forces(g: &OnGround<'_, '_>) -> Section {
    let mut s = Section::new(2, "Note ω, the constraint and the forces at t0");
    let (start, omega) = (&g.start, g.start.state.omega);
    s.line(format!("t0 = {} s", n(start.state.time)));
    s.line(format!("ω  = {} rad/s in body axes", exactly(omega.to_array())));
    if start.state.attitude != Attitude::identity() {
        s.line(format!("   = {} rad/s in space axes", v(start.state.omega_space().to_array())));
    }
    s.line(format!("|ω| = {}", rate(omega.norm())));
    constraint(g, &mut s);
    velocities(g, &mut s);
    s.say("The forces on the body, in space axes: its weight in C, and in P the normal force N n and friction F. N and F are unknown constraint forces (step 4).");
    let weight = g.contact.gravity * g.w.body().mass();
    let size = weight.norm().max(start.normal_force);
    s.line(format!("m g = {} N", v(weight.to_array())));
    s.line(format!(
        "N   = {} N,  compared with −m g · n = {} N",
        n(start.normal_force),
        n(-start.normal.dot(weight))
    ));
    s.line(format!("F   = {} N", exactly(tidy_beside(start.friction.to_array(), size))));
    holding(g, &mut s);
    energy(g, &mut s);
    s
}

fn constraint(g: &OnGround<'_, '_>, s: &mut Section) {
    match g.contact.law.grip() {
        Grip::NoSlip => {
            s.say("It rolls without slipping: the point of the body at P has the velocity w of the ground there, which is zero unless the ground rotates.");
            s.formula("v + ω × r = w", r"\mathbf v + \boldsymbol\omega \times \mathbf r = \mathbf w");
        }
        _ if g.is_frictionless() => {
            s.say("P stays on the ground and may slip in any direction, because the ground is frictionless:");
            s.formula(
                "(v + ω × r − w) · n = 0,   F = 0",
                r"(\mathbf v + \boldsymbol\omega \times \mathbf r - \mathbf w) \cdot \mathbf n = 0, \qquad \mathbf F = 0",
            );
        }
        _ => {
            s.say("P stays on the ground, u · n = 0. Where it slips, at u, friction opposes u with a known magnitude; where it does not, friction is a constraint force of at most µₛ N:");
            s.formula(
                "u = v + ω × r − w;   u ≠ 0:  F = −(µ N/|u| + c) u;   u = 0:  |F| ≤ µₛ N",
                r"\mathbf u = \mathbf v + \boldsymbol\omega \times \mathbf r - \mathbf w, \qquad \mathbf F = -\left(\frac{\mu N}{|\mathbf u|} + c\right) \mathbf u \quad (\mathbf u \ne 0), \qquad |\mathbf F| \le \mu_s N \quad (\mathbf u = 0)",
            );
        }
    }
}

fn velocities(g: &OnGround<'_, '_>, s: &mut Section) {
    let start = &g.start;
    let turned: Direction<Space> =
        start.state.attitude * Direction::from_array(start.state.omega.cross(g.arm).to_array());
    let size = start.velocity.norm().max(turned.norm());
    let shown = |x: [f64; 3]| exactly(tidy_beside(x, size));
    s.line(format!("v     = {} m/s, the centre of mass, in space axes", shown(start.velocity.to_array())));
    s.line(format!("ω × r = {} m/s", shown(turned.to_array())));
    let slip = start.slip;
    if g.contact.ground.turning() != 0.0 {
        let carried = start.velocity + Velocity::from_array(turned.to_array()) - slip;
        s.line(format!("w     = Ω × x = {} m/s", shown(carried.to_array())));
    }
    if g.is_rolling() {
        s.line("u     = 0: it rolls");
    } else {
        s.line(format!("u     = {} m/s,  |u| = {} m/s", shown(slip.to_array()), n(slip.norm())));
    }
}

/// Writes the friction force relative to its limit.
fn holding(g: &OnGround<'_, '_>, s: &mut Section) {
    let (friction, normal, force) = (g.friction(), g.start.normal_force, g.start.friction.norm());
    if g.is_frictionless() || !matches!(g.contact.law.grip(), Grip::Friction(_)) {
        return;
    }
    if g.is_rolling() {
        s.line(format!(
            "|F| = {} N,  µₛ N = {}·{} = {} N: it is held",
            n(tidy_beside([force, 0.0, 0.0], normal)[0]),
            n(friction.sticking),
            factor(normal),
            n(friction.sticking * normal)
        ));
    } else if friction.viscous == 0.0 {
        s.line(format!(
            "|F| = µ N = {}·{} = {} N, against u",
            n(friction.kinetic),
            factor(normal),
            n(friction.kinetic * normal)
        ));
    }
}

fn energy(g: &OnGround<'_, '_>, s: &mut Section) {
    let (mass, speed) = (g.w.body().mass(), g.start.velocity.norm());
    let rotation = g.w.rotor.kinetic_energy(g.start.state.omega);
    s.say("The energy: that of the centre of mass, that of the rotation about it, and U = −m g · x of the centre of mass.");
    s.formula(
        "T = ½ m v² + ½ ω · {I} ω",
        r"T = \tfrac12 m v^2 + \tfrac12 \boldsymbol\omega \cdot \lbrace \mathbf I \rbrace \boldsymbol\omega",
    );
    let translation = 0.5 * mass * speed * speed;
    s.line(format!(
        "T = ½ · {} · {}² + {} = {} J",
        n(mass),
        n(speed),
        n(rotation),
        n(translation + rotation)
    ));
    let size = g.start.kinetic_energy.abs() + mass * g.contact.gravity.norm() * g.arm.norm();
    s.line(format!("U = {} J", n(tidy_beside([g.start.potential_energy, 0.0, 0.0], size)[0])));
}
