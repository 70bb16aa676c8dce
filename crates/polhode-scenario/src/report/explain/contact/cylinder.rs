//! Step 5 of a cylinder lying on a plane or in a pipe.

use polhode::math::{Body, Direction, Space};
use polhode::motion::contact::{GroundShape, GroundSide};
use polhode::observe::BallOnPlane;
use polhode_document::Section;

use super::super::working::n;
use super::{OnGround, ball, unsolved, wheel};

pub(crate) fn solve(g: &OnGround<'_, '_>, s: &mut Section) -> Option<String> {
    let surface = &g.contact.surface;
    let e: Direction<Body> = surface.axes() * Direction::new(0.0, 0.0, 1.0);
    let axis: Direction<Space> = g.start.state.attitude * e;
    let offset = surface.center() - g.w.body().center_of_mass();
    let across = Direction::<Body>::from_array(offset.to_array());
    let is_centred = (across - e * e.dot(across)).norm() <= 1e-9 * g.arm.norm();
    s.say(
        "A lying cylinder touches the ground along a line, so its axis e stays level and fixed: it rotates about e only. The remaining equations are that along e and the two of the centre of mass along the ground. N stands for the forces \
         along the line, in P as far as their torque about e goes; how they are spread decides that e stays, and the cylinder tips over where they would have to be beyond its ends.",
    );
    if !is_centred {
        s.say("Its centre of mass is off its axis, so it rocks like a pendulum: no closed form is used, and the motion is integrated (step 6).");
        return None;
    }
    if g.contact.ground.turning() != 0.0 {
        unsolved(g, s);
        return None;
    }
    let roller = wheel::straight(g, e)?;
    s.formula("k = C/(m a²),   σ = k/(1 + k)", r"k = \frac{C}{m a^2}, \qquad \sigma = \frac{k}{1 + k}");
    ball::ratio(&roller, "C", s);
    let along = axis.dot(g.contact.gravity);
    match *g.contact.ground.shape() {
        GroundShape::Plane => {}
        GroundShape::Cylinder { radius, side: GroundSide::Inside } if g.is_rolling() => {
            return Some(pipe(g, &roller, radius, s));
        }
        _ => {
            unsolved(g, s);
            return None;
        }
    }
    if g.is_rolling() {
        if along.abs() > 1e-9 * g.contact.gravity.norm() {
            let pushed = roller.mass * along;
            s.say("The slope has a component along the axis. In that direction it cannot roll, and friction balances the whole component of the weight:");
            s.line(format!("m g · e = {} N", n(pushed)));
        }
        return Some(ball::rolls(g, &roller, s));
    }
    let slip = axis.dot(g.start.slip).abs() > 1e-9 * g.start.slip.norm();
    if slip || along.abs() > 1e-9 * g.contact.gravity.norm() {
        s.say("It slips along its axis too, where friction turns nothing: u\u{307} is F/m along e and F/(σ m) across, and the direction of the slip changes in a way that has no closed form here.");
        return None;
    }
    Some(ball::slips(g, &roller, s))
}

/// Solves a cylinder in a pipe: a pendulum, slower than a simple pendulum of the same length.
fn pipe(g: &OnGround<'_, '_>, roller: &BallOnPlane, radius: f64, s: &mut Section) -> String {
    let length = radius - roller.radius;
    let gravity = g.contact.gravity;
    let axis = g.contact.ground.axis();
    let across = (super::direction(gravity.to_array()) - axis * axis.dot(gravity)).norm();
    let small = (across * (1.0 - roller.share()) / length).sqrt();
    s.say("In the pipe its centre of mass is on a circle of radius l = R − a, at θ from the lowest line. v = l θ\u{307} = a ω, and the energy is that of a pendulum with 1 + k times its inertia:");
    s.formula(
        "(1 + k) l θ\u{308} = −g sin θ,   ω0² = g/((1 + k) l) = (1 − σ) g/l",
        r"(1 + k) l \ddot\theta = -g \sin\theta, \qquad \omega_0^2 = \frac{g}{(1 + k) l} = \frac{(1 - \sigma) g}{l}",
    );
    s.line(format!("l = {} m,  g = {} m/s² across the axis", n(length), n(across)));
    s.line(format!("ω0 = {} rad/s, a small swing in {} s", n(small), n(std::f64::consts::TAU / small)));
    format!("It swings in the pipe at ω0 = {} rad/s for small swings.", n(small))
}
