//! Constants of the motion of a body on the ground, with their values at t0.

use polhode::math::{Body, Direction, Velocity};
use polhode::motion::contact::{Grip, GroundShape, SurfaceShape};
use polhode::observe::TippeTop;
use polhode_document::Section;
use polhode_document::number::tidy_beside;

use super::super::working::{exactly, n};
use super::{OnGround, bowl};

/// Constant of the motion: formula, value with unit, and the reason why it is constant.
struct Constant {
    formula: &'static str,
    value: String,
    why: &'static str,
}

pub(crate) fn list(g: &OnGround<'_, '_>, s: &mut Section) {
    let all = constants(g);
    if all.is_empty() {
        s.say("No quantity is constant: friction dissipates energy, and its torque changes L. The balance of energy holds: T + U minus the work of friction and of the ground.");
        return;
    }
    let until = if g.is_rolling() && !matches!(g.contact.law.grip(), Grip::NoSlip) {
        ", as long as it rolls"
    } else {
        ""
    };
    s.say(format!("What stays constant{until}:"));
    let rows = all.into_iter().map(|c| vec![c.formula.to_owned(), c.value, c.why.to_owned()]).collect();
    s.table(&["constant", "at t0", "why"], rows);
}

fn constants(g: &OnGround<'_, '_>) -> Vec<Constant> {
    let contact = g.contact;
    let is_plane = matches!(contact.ground.shape(), GroundShape::Plane);
    let gravity = super::direction(contact.gravity.to_array());
    let is_level = is_plane && (gravity + g.start.normal * gravity.norm()).norm() <= 1e-9 * gravity.norm();
    let mut all = Vec::new();
    if contact.ground.turning() == 0.0 && (g.is_rolling() || g.is_frictionless()) && !g.is_resisted() {
        let why = if g.is_rolling() { "P is at rest: no work" } else { "N n is across all motion of P" };
        let value = format!("{} J", n(g.start.kinetic_energy + g.start.potential_energy));
        all.push(Constant { formula: "T + U", value, why });
    }
    all.extend(about_normal(g, is_plane));
    if g.is_frictionless() && !g.is_resisted() {
        all.extend(frictionless(g, is_level));
    }
    if !g.is_resisted() {
        all.extend(of_spheres(g, is_level));
    }
    all
}

/// Returns ω · n of a ball with three equal moments, if it is constant.
fn about_normal(g: &OnGround<'_, '_>, is_plane: bool) -> Option<Constant> {
    let resistance = g.contact.law.resistance();
    let in_bowl = matches!(g.contact.ground.shape(), GroundShape::Sphere { .. })
        && g.contact.ground.turning() == 0.0
        && g.is_rolling()
        && resistance.rolling == 0.0;
    if !bowl::is_even_ball(g) || resistance.pivoting != 0.0 || !(is_plane || in_bowl) {
        return None;
    }
    let omega = g.start.state.omega;
    let value = format!("{} rad/s", n(tidy_beside([g.up.dot(omega), 0.0, 0.0], omega.norm())[0]));
    let why = if is_plane { "no force has a torque about n" } else { "r is along n, and n\u{307} across ω" };
    Some(Constant { formula: "ω · n", value, why })
}

fn frictionless(g: &OnGround<'_, '_>, is_level: bool) -> Vec<Constant> {
    let (start, mut all) = (&g.start, Vec::new());
    if is_level {
        let value = format!("{} kg·m²/s", n(g.up.dot(g.w.rotor.angular_momentum(start.state.omega))));
        all.push(Constant { formula: "L · n", value, why: "all forces are vertical" });
        let away = (start.normal * start.normal.dot(start.velocity)).to_array();
        let along = start.velocity - Velocity::from_array(away);
        let size = start.velocity.norm().max(start.state.omega.norm() * g.arm.norm());
        let value = format!("{} m/s", exactly(tidy_beside(along.to_array(), size)));
        all.push(Constant { formula: "v along the ground", value, why: "no force is along the ground" });
    }
    if let Some(e) = g.axis().filter(|_| !bowl::is_even_ball(g)) {
        let value = format!("{} rad/s", n(e.dot(start.state.omega)));
        all.push(Constant { formula: "ω · e", value, why: "P and the axis are in one plane with n" });
    }
    all
}

/// Returns Jellett's and Routh's constants of a tippe top, and Chaplygin's constants of a ball with
/// its centre of mass at its geometric centre.
fn of_spheres(g: &OnGround<'_, '_>, is_level: bool) -> Vec<Constant> {
    let (contact, body) = (g.contact, g.w.body());
    let mut all = Vec::new();
    if let Some((top, e)) = TippeTop::of(body, contact) {
        let arm = Direction::<Body>::from_array(g.arm.to_array());
        let value = format!("{} kg·m³/s", n(-arm.dot(g.w.rotor.angular_momentum(g.start.state.omega))));
        all.push(Constant {
            formula: "J = −L · r",
            value,
            why: "Jellett's constant, for every friction: step 5",
        });
        if g.is_rolling() {
            let routh = top.routh(e.dot(g.start.state.omega), e.dot(g.up));
            let value = format!("{} kg·m²·rad/s", n(routh));
            all.push(Constant {
                formula: "ω_e √(A C + m r · {I} r)", value, why: "Routh's, as it rolls"
            });
        }
    }
    let is_centred = matches!(contact.surface.shape(), SurfaceShape::Sphere { radius }
        if (contact.surface.center() - body.center_of_mass()).norm() <= 1e-9 * radius);
    let rolls = is_level && contact.ground.turning() == 0.0 && g.is_rolling();
    if is_centred && rolls && !bowl::is_even_ball(g) {
        let about = g.start.state.attitude * about_contact(g);
        let value = format!("{} kg·m²/s", exactly(tidy_beside(about.to_array(), about.norm())));
        all.push(Constant { formula: "L_P in space", value, why: "s = v, r × g = 0" });
    }
    all
}

/// Returns L about the point of contact, kg·m²/s, body axes.
pub(crate) fn about_contact(g: &OnGround<'_, '_>) -> Direction<Body> {
    let own = Direction::<Body>::from_array(g.w.rotor.angular_momentum(g.start.state.omega).to_array());
    let velocity = g.start.state.attitude.inverse() * Direction::from_array(g.start.velocity.to_array());
    let arm = Direction::<Body>::from_array(g.arm.to_array());
    own - arm.cross(velocity) * g.w.body().mass()
}
