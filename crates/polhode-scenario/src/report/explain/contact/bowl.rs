//! Step 5 of a ball in a bowl, or on another ball.

use std::f64::consts::TAU;

use polhode::motion::contact::{GroundSide, SurfaceShape};
use polhode::motion::{HeavyTop, TopPath};
use polhode::observe::BallInBowl;
use polhode_document::Section;

use super::super::free::once_in;
use super::super::working::{n, v};
use super::OnGround;

/// Returns true if the surface is a sphere centred at the centre of mass, with three equal moments.
pub(crate) fn is_even_ball(g: &OnGround<'_, '_>) -> bool {
    let body = g.w.body();
    let is_centred = matches!(g.contact.surface.shape(), SurfaceShape::Sphere { radius }
        if (g.contact.surface.center() - body.center_of_mass()).norm() <= 1e-9 * radius);
    is_centred && g.w.rotor.principal().symmetry() == polhode::body::Symmetry::Spherical
}

pub(crate) fn solve(g: &OnGround<'_, '_>, s: &mut Section) -> Option<String> {
    let ball = BallInBowl::of(g.w.body(), g.contact)?;
    if !g.is_rolling() || g.is_resisted() {
        return None;
    }
    let top = ball.top(&g.start).ok()?;
    s.say(
        "A ball that rolls on a sphere moves like a heavy top. With e from the centre of the sphere to the centre of the ball, at the distance l, rolling requires v = l e\u{307}; the torque −a n × F on the ball and F = m (v\u{307} − g) make \
         ω · n constant, as n\u{307} is across ω, and leave",
    );
    s.formula(
        "(1 + k) m l² e × e\u{308} + k m l a (ω · n) e\u{307} = l e × m g,   k = I/(m a²)",
        r"(1 + k) m l^2 \mathbf e \times \ddot{\mathbf e} + k m l a (\boldsymbol\omega \cdot \mathbf n) \dot{\mathbf e} = l \mathbf e \times m \mathbf g, \qquad k = \frac{I}{m a^2}",
    );
    s.say("This is the equation of a symmetric top with its pivot at the centre of the sphere, with these factors in place of A and C ω3; for ω · n = 0 it is a spherical pendulum:");
    s.line(format!("l = {} m,  k = {}", n(ball.distance), n(ball.ratio())));
    let [a, _] = top.moments();
    let normal = g.up.dot(g.start.state.omega);
    s.line(format!("A = (1 + k) m l² = {} kg·m²", n(a)));
    s.line(format!(
        "ω · n = {} rad/s,  C ω3 = k m l a ω · n = {} kg·m²/s",
        n(normal),
        n(ball.moment * ball.distance / ball.radius * normal)
    ));
    let inside = ball.side == GroundSide::Inside;
    if inside {
        let small = ball.small_frequency();
        s.say("Small swings without spin about n are slower than those of a pendulum of length l, because k/(1 + k) of the energy is in the rotation of the ball:");
        s.formula("ω0² = g/((1 + k) l)", r"\omega_0^2 = \frac{g}{(1 + k) l}");
        s.line(format!("ω0 = {} rad/s, a swing in {} s", n(small), n(TAU / small)));
    }
    Some(goes(&ball, &top, s))
}

/// Writes the path of the ball, from the cubic of the equivalent top.
fn goes(ball: &BallInBowl, top: &HeavyTop, s: &mut Section) -> String {
    if ball.side == GroundSide::Outside {
        s.say("So it rolls down, or stays near the top like a sleeping top if it spins fast. It leaves the sphere where N = 0, unless it slips before: the centre of mass needs the centripetal force m v²/l, which gravity alone supplies:");
        s.formula("N = −m g · n − m v²/l", r"N = -m \mathbf g \cdot \mathbf n - \frac{m v^2}{l}");
        return "It moves like the axis of a heavy top as long as N > 0 and friction prevents slip."
            .to_owned();
    }
    // A top's θ is measured from the upward vertical, the ball's angle from the lowest point.
    let from_below = top.nutation_bounds().map(|angle| std::f64::consts::PI - angle);
    let [high, low] = from_below.map(|angle| n(angle.to_degrees()));
    s.say("Its axis nutates between two turning points (the cubic of Lagrange's top) while it precesses; the angles are at the centre of the bowl, from the lowest point:");
    s.line(format!(
        "{low} … {high}°: between {} and {} m from the lowest point",
        n(ball.distance * from_below[1].sin().abs()),
        n(ball.distance * from_below[0].sin().abs())
    ));
    s.line(format!(
        "heights above the lowest place: {} m",
        v([ball.distance * (1.0 - from_below[1].cos()), ball.distance * (1.0 - from_below[0].cos()), 0.0])
            .trim_end_matches(", 0)")
            .trim_start_matches('(')
            .replace(", ", " and ")
    ));
    let Some(period) = top.nutation_period() else {
        return "It moves like the axis of a heavy top.".to_owned();
    };
    s.line(format!("period 2 K(k)/λ = {} s", n(period)));
    if top.path() != TopPath::Planar
        && let Some(turned) = top.precession_in_a_nutation()
    {
        s.line(format!("goes round by {}° in that time{}", n(turned.to_degrees()), once_in(turned / period)));
    }
    format!("It moves like the axis of a heavy top, in and out once in {} s.", n(period))
}
