//! Step 5 of a ball on a plane.
//!
//! It slides until it no longer slips. Then it rolls straight, down a slope, or in a circle on a
//! turntable.

use polhode::math::{Acceleration, Position, Space, Velocity};
use polhode::motion::contact::{ContactChange, Friction, Grip};
use polhode::observe::{BallOnPlane, SlipEnd};
use polhode_document::Section;
use polhode_document::number::tidy_beside;
use polhode_document::unit::angle;

use super::super::free::once_in;
use super::super::working::{exactly, factor, n, v};
use super::OnGround;

pub(crate) fn solve(g: &OnGround<'_, '_>, ball: &BallOnPlane, s: &mut Section) -> String {
    s.say(
        "A ball with its centre of mass at its centre and three equal moments: r = −a n, and ω × {I} ω = 0. Its motion depends on the ratio of its moment to m a²:",
    );
    s.formula("k = I/(m a²),   σ = k/(1 + k)", r"k = \frac{I}{m a^2}, \qquad \sigma = \frac{k}{1 + k}");
    ratio(ball, "I", s);
    if g.is_rolling() { rolls(g, ball, s) } else { slips(g, ball, s) }
}

/// Solves the motion of a ball that slips at the start, or is on frictionless ground.
pub(crate) fn slips(g: &OnGround<'_, '_>, ball: &BallOnPlane, s: &mut Section) -> String {
    if g.is_frictionless() { frictionless(ball, s) } else { slides(g, ball, s) }
}

/// Writes k and σ as numbers; for known bodies also as fractions, such as 2/5 and 2/7.
pub(crate) fn ratio(ball: &BallOnPlane, moment: &str, s: &mut Section) {
    let square = ball.mass * ball.radius * ball.radius;
    let known = match ball.moment / square {
        k if (k - 0.4).abs() < 1e-9 => ": 2/5 and 2/7, those of a homogeneous ball",
        k if (k - 2.0 / 3.0).abs() < 1e-9 => ": 2/3 and 2/5, those of a thin shell",
        k if (k - 0.5).abs() < 1e-9 => ": 1/2 and 1/3, those of a homogeneous cylinder",
        _ => "",
    };
    s.line(format!(
        "m a² = {}·{}² = {} kg·m²,  {moment} = {} kg·m²",
        n(ball.mass),
        n(ball.radius),
        n(square),
        n(ball.moment)
    ));
    s.line(format!("k = {},  σ = {}{known}", n(ball.moment / square), n(ball.share())));
}

fn frictionless(ball: &BallOnPlane, s: &mut Section) -> String {
    s.say(
        "Without friction no torque acts: ω is constant in space, and the centre of mass moves like a point mass.",
    );
    let downhill = ball.downhill();
    s.line(format!("v\u{307} = g_t = {} m/s²", acceleration(downhill)));
    format!("It slides without friction, with v\u{307} = {} m/s² and constant ω.", acceleration(downhill))
}

/// Solves the sliding phase, until the slip vanishes.
fn slides(g: &OnGround<'_, '_>, ball: &BallOnPlane, s: &mut Section) -> String {
    let (friction, slip, velocity) = (g.friction(), g.start.slip, g.start.velocity);
    s.say("It slips, so F is known. F changes both v and the slip u = v − a ω × n; its torque −a n × F changes ω:");
    s.formula(
        "v\u{307} = g_t + F/m,   a (ω\u{307} × n) = −F/(k m),   u\u{307} = g_t + F/(σ m)",
        r"\dot{\mathbf v} = \mathbf g_t + \frac{\mathbf F}{m}, \qquad a \dot{\boldsymbol\omega} \times \mathbf n = -\frac{\mathbf F}{k m}, \qquad \dot{\mathbf u} = \mathbf g_t + \frac{\mathbf F}{\sigma m}",
    );
    s.say(
        "Friction reduces the slip 1/σ times as fast as the velocity, because it changes both v and ω. With g_n the component of g normal to the plane and g_t the component along it:",
    );
    let steep = ball.downhill().norm();
    s.line(format!("g_n = {} m/s²,  g_t = {} m/s²", n(ball.pressing()), acceleration(ball.downhill())));
    s.line(format!("u0 = {} m/s,  |u0| = {} m/s", vector(slip, velocity), n(slip.norm())));
    if g.is_resisted() {
        s.say("Rolling resistance changes ω too, in another direction; no closed form is known with it, so the formulas below neglect it.");
    }
    let end = ball.slip_end(slip, &friction);
    if end != SlipEnd::Unknown {
        law(ball, &friction, steep, s);
    }
    match end {
        SlipEnd::At(time) => ends(g, ball, time, s),
        SlipEnd::Never => {
            let text = if steep > 0.0 && friction.kinetic > 0.0 {
                "The slope is too steep for this friction, κ < |g_t|: the slip grows without limit."
            } else {
                "The slip decays but never ends, because viscous friction is proportional to the slip."
            };
            s.say(text);
            format!("It slides on {}: the slip does not end.", slope(ball))
        }
        SlipEnd::Unknown => {
            s.say("On a rotating plane, where u\u{307} has the further term −Ω n × v, and with viscous friction on a slope, no closed form is known; the motion is integrated (step 6).");
            let gripped = gripped(g)
                .map_or_else(String::new, |time| format!(" In the run it grips at t = {} s.", n(time)));
            format!("It slips at |u| = {} m/s at first.{gripped}", n(slip.norm()))
        }
    }
}

/// Writes the differential equation of the slip, and κ.
fn law(ball: &BallOnPlane, friction: &Friction, steep: f64, s: &mut Section) {
    let kappa = ball.slip_deceleration(friction);
    match (friction.viscous > 0.0, steep > 0.0) {
        (false, false) => s.formula(
            "u\u{307} = −κ û,   κ = µ g/σ,   |u| = |u0| − κ t,   T = |u0|/κ",
            r"\dot{\mathbf u} = -\kappa \hat{\mathbf u}, \qquad \kappa = \frac{\mu g}{\sigma}, \qquad |\mathbf u| = |\mathbf u_0| - \kappa t, \qquad T = \frac{|\mathbf u_0|}{\kappa}",
        ),
        (true, false) => s.formula(
            "d|u|/dt = −κ − λ |u|,   κ = µ g/σ,   λ = c/(σ m),   T = ln(1 + λ |u0|/κ)/λ",
            r"\frac{d|\mathbf u|}{dt} = -\kappa - \lambda |\mathbf u|, \qquad \kappa = \frac{\mu g}{\sigma}, \qquad \lambda = \frac{c}{\sigma m}, \qquad T = \frac{1}{\lambda} \ln\left(1 + \frac{\lambda |\mathbf u_0|}{\kappa}\right)",
        ),
        (_, true) => {
            s.say("On a slope the slip turns downhill. But κ |u| + g_t · u decreases linearly, for every direction:");
            s.formula(
                "u\u{307} = g_t − κ û,   κ = µ g_n/σ,   d(κ |u| + g_t · u)/dt = −(κ² − g_t²),   T = (κ |u0| + g_t · u0)/(κ² − g_t²)",
                r"\dot{\mathbf u} = \mathbf g_t - \kappa \hat{\mathbf u}, \qquad \kappa = \frac{\mu g_n}{\sigma}, \qquad \frac{d}{dt}\left(\kappa |\mathbf u| + \mathbf g_t \cdot \mathbf u\right) = -(\kappa^2 - g_t^2), \qquad T = \frac{\kappa |\mathbf u_0| + \mathbf g_t \cdot \mathbf u_0}{\kappa^2 - g_t^2}",
            );
        }
    }
    s.line(format!(
        "κ = {}·{}/{} = {} m/s²",
        n(friction.kinetic),
        n(ball.pressing()),
        n(ball.share()),
        n(kappa)
    ));
    if friction.viscous > 0.0 {
        s.line(format!(
            "λ = {}/({}·{}) = {} /s",
            n(friction.viscous),
            n(ball.share()),
            n(ball.mass),
            n(ball.slip_decay(friction))
        ));
    }
}

/// Writes the motion after the slip vanishes at `time`, s.
fn ends(g: &OnGround<'_, '_>, ball: &BallOnPlane, time: f64, s: &mut Section) -> String {
    let (friction, slip, velocity) = (g.friction(), g.start.slip, g.start.velocity);
    let (steep, share) = (ball.downhill().norm(), ball.share());
    let rolling = ball.rolls_off(velocity, slip, time);
    s.line(format!("T = {} s", n(time)));
    if steep == 0.0 && friction.viscous == 0.0 && cross(velocity, slip) {
        s.say("F is constant, so until then the path is a parabola with its axis along −u0. The total change of velocity is σ u0, independent of the friction coefficient:");
    } else if steep == 0.0 {
        s.say(
            "The total change of velocity is σ u0, independent of the friction: more friction only shortens the slip.",
        );
    } else {
        s.say("As v\u{307} − σ u\u{307} = (1 − σ) g_t does not contain the friction, the velocity at that time does not depend on the path:");
    }
    s.formula(
        "v(T) = v0 − σ u0 + (1 − σ) g_t T",
        r"\mathbf v(T) = \mathbf v_0 - \sigma \mathbf u_0 + (1 - \sigma) \mathbf g_t T",
    );
    let shown = vector(rolling, velocity);
    let gained = if steep == 0.0 {
        String::new()
    } else {
        format!(" + {}", acceleration(ball.rolling_acceleration() * time))
    };
    s.line(format!(
        "v(T) = {} − {}·{}{gained} = {shown} m/s",
        vector(velocity, velocity),
        n(share),
        vector(slip, velocity)
    ));
    s.line(format!("|v(T)| = {} m/s", n(rolling.norm())));
    if rolling.norm() > 0.0 && velocity.norm() > 0.0 && steep == 0.0 {
        let part = rolling.norm() / velocity.norm();
        let known = if (part - 5.0 / 7.0).abs() < 1e-9 {
            ": 5/7, as for every homogeneous ball that starts without spin"
        } else {
            ""
        };
        s.line(format!("       = {} |v0|{known}", n(part)));
        if rolling.dot(velocity) < -1e-12 * rolling.norm() * velocity.norm() {
            s.say("It comes back: the backspin is so large that the final velocity is opposite to the initial one (a draw shot in billiards).");
        }
    }
    if steep == 0.0 {
        let moved = ball.displacement(velocity, slip, &friction, time);
        s.line(format!("its displacement is {} m, {} m", v(moved.to_array()), n(moved.norm())));
    }
    let lost = 0.5 * ball.mass * share * slip.dot(slip);
    if steep == 0.0 {
        s.line(format!("friction has dissipated ½ σ m u0² = {} J", n(lost)));
    }
    if let Some(run) = gripped(g) {
        s.line(format!("the run finds T = {} s", n(run - g.start.state.time)));
    }
    if ball.friction_to_roll() > friction.sticking {
        s.say(
            "There it is at rest for a moment, but friction is too small to hold it: it continues to slip, downhill.",
        );
        return format!("It slides uphill for {} s, and then down: friction does not hold it.", n(time));
    }
    s.say("From then on it rolls:");
    let after = rolling_on(g, ball, s);
    format!(
        "It slides for {} s, and then rolls at {} m/s{}.",
        n(time),
        n(rolling.norm()),
        if after.is_empty() { String::new() } else { format!("; {after}") }
    )
}

/// Returns the time at which the slip of the run first vanishes.
fn gripped(g: &OnGround<'_, '_>) -> Option<f64> {
    let changes = g.motion()?.changes();
    changes.first().filter(|event| event.change == ContactChange::Grips).map(|event| event.time)
}

/// Solves the motion of a ball that rolls from the start.
pub(crate) fn rolls(g: &OnGround<'_, '_>, ball: &BallOnPlane, s: &mut Section) -> String {
    if ball.turning != 0.0 {
        return turntable(g, ball, s);
    }
    let after = rolling_on(g, ball, s);
    let speed = n(g.start.velocity.norm());
    if after.is_empty() {
        format!("It rolls straight on at {speed} m/s: nothing slows it.")
    } else {
        format!("It rolls at {speed} m/s; {after}.")
    }
}

/// Writes the equation of motion of a ball that rolls on a plane at rest.
fn rolling_on(g: &OnGround<'_, '_>, ball: &BallOnPlane, s: &mut Section) -> String {
    let resistance = g.contact.law.resistance();
    let gained = ball.rolling_acceleration();
    s.say("While it rolls, u = 0, so F = −σ m g_t and the acceleration is (1 − σ) g_t:");
    s.formula(
        "v\u{307} = (1 − σ) g_t,   F = −σ m g_t",
        r"\dot{\mathbf v} = (1 - \sigma) \mathbf g_t, \qquad \mathbf F = -\sigma m \mathbf g_t",
    );
    if resistance.rolling > 0.0 {
        // Deceleration µᵣ g_n/(a (1 + k)).
        let slowed = resistance.rolling * ball.pressing() / ball.radius * (1.0 - ball.share());
        s.say("Rolling friction, a torque µr N that opposes the rolling, reduces it by (1 − σ) µr g_n/a, along v:");
        s.line(format!("(1 − σ) µr g_n/a = {} m/s²", n(slowed)));
        if gained.norm() == 0.0 && g.is_rolling() {
            let speed = g.start.velocity.norm();
            s.line(format!(
                "it stops after v divided by this = {} s, and {} m",
                n(speed / slowed),
                n(0.5 * speed * speed / slowed)
            ));
            return format!("rolling friction stops it after {} s", n(speed / slowed));
        }
    }
    if gained.norm() == 0.0 {
        s.line("g_t = 0: v and ω are constant, and F = 0");
        return String::new();
    }
    let incline = ball.normal.angle_to(-ball.gravity);
    s.line(format!("slope α = {},  |g_t| = g sin α = {} m/s²", angle(incline), n(ball.downhill().norm())));
    s.line(format!(
        "v\u{307} = {} m/s²,  |v\u{307}| = (1 − σ) g sin α = {} m/s²",
        acceleration(gained),
        n(gained.norm())
    ));
    let needed = ball.friction_to_roll();
    s.say("This requires a friction force of σ tan α times the normal force:");
    let have = g.friction().sticking;
    let verdict = if !matches!(g.contact.law.grip(), Grip::Friction(_)) {
        String::new()
    } else if have >= needed {
        format!(", and µs = {} suffices", n(have))
    } else {
        format!(", and µs = {} is less: it slips", n(have))
    };
    s.line(format!("|F|/N = σ tan α = {}{verdict}", n(needed)));
    format!("down the slope its speed grows by {} m/s per second", n(gained.norm()))
}

fn turntable(g: &OnGround<'_, '_>, ball: &BallOnPlane, s: &mut Section) -> String {
    s.say("The table rotates at Ω about n, and the ball's point of contact moves with it: v = Ω n × x + a ω × n. Its derivative, with both equations, gives an equation for v alone:");
    s.formula(
        "v\u{307} = σ Ω n × v + (1 − σ) g_t",
        r"\dot{\mathbf v} = \sigma \Omega \mathbf n \times \mathbf v + (1 - \sigma) \mathbf g_t",
    );
    s.say("v rotates at σ Ω, for every velocity and position: the ball moves on a circle, whose centre need not be that of the table. The ball does not drift outward.");
    s.line(format!("Ω = {} rad/s{}", n(ball.turning), once_in(ball.turning)));
    s.line(format!(
        "σ Ω = {}·{} = {} rad/s{}",
        n(ball.share()),
        factor(ball.turning),
        n(ball.circle_rate()),
        once_in(ball.circle_rate())
    ));
    let drift = ball.drift();
    let (place, velocity) = (g.start.contact, g.start.velocity);
    let center = ball.circle_center(place, velocity);
    let radius = (velocity - drift).norm() / ball.circle_rate().abs();
    if drift.norm() > 0.0 {
        s.say("On a slope the circle drifts horizontally, at the velocity for which v\u{307} is zero:");
        s.line(format!("drift = n × g_t (1 − σ)/(σ Ω) = {} m/s", vector(drift, velocity)));
    }
    s.line(format!("v0 = {} m/s at x0 = {} m", vector(velocity, velocity), point(place)));
    s.line(format!("middle x0 + n × (v0 − drift)/(σ Ω) = {} m", point(center)));
    s.line(format!("radius |v0 − drift|/|σ Ω| = {} m", n(radius)));
    if g.is_resisted() {
        s.say("Rolling and pivoting resistance also change ω, and with it the circle.");
    }
    let moves =
        if drift.norm() > 0.0 { format!(", which drifts at {} m/s", n(drift.norm())) } else { String::new() };
    format!(
        "It moves on a circle of radius {} m in {} s{moves}.",
        n(radius),
        n(std::f64::consts::TAU / ball.circle_rate().abs())
    )
}

fn slope(ball: &BallOnPlane) -> &'static str {
    if ball.downhill().norm() > 0.0 { "the slope" } else { "the level" }
}

fn acceleration(a: Acceleration<Space>) -> String {
    v(a.to_array())
}

fn point(x: Position<Space>) -> String {
    v(x.to_array())
}

/// Formats a velocity; components that are rounding errors relative to the other one are 0.
fn vector(x: Velocity<Space>, beside: Velocity<Space>) -> String {
    exactly(tidy_beside(x.to_array(), x.norm().max(beside.norm())))
}

/// Returns true if two velocities are not parallel.
fn cross(a: Velocity<Space>, b: Velocity<Space>) -> bool {
    let [a, b] = [a, b].map(|v| super::direction(v.to_array()));
    a.cross(b).norm() > 1e-9 * a.norm() * b.norm()
}
