//! Step 5 of a rattleback: its two oscillations, and which one grows in each direction of spin.

use std::f64::consts::TAU;

use polhode::observe::{RattleMode, Rattleback, SteadyOnGround, VertexSpin};
use polhode_document::Section;
use polhode_document::unit::{angle, rate};

use super::super::working::{factor, n};
use super::{OnGround, disk, vertex};

pub(crate) fn solve(
    g: &OnGround<'_, '_>,
    steady: &SteadyOnGround,
    spin: &VertexSpin,
    rattle: &Rattleback,
    s: &mut Section,
) -> String {
    let rate_of = steady.spin;
    s.say(
        "The body rests and spins on a point below its centre of mass, at the height h. It is a rattleback, as the principal axes of its tensor are turned against the axes of its underside. Along two axes of the body across n let S be the moments and R the \
         radii of curvature there, as matrices: for every choice of axes, one of them has an off-diagonal element.",
    );
    vertex::numbers(spin, s);
    s.line(format!("turned against each other by {}", angle(spin.skew())));
    swings(rattle, s);
    growth(rattle, rate_of, s);
    reason(s);
    let answer = threshold(rattle, rate_of, s);
    s.say(format!(
        "The formula for σ is for slow spin. The exact linear equations, at Ω = {}, {}° from the start:",
        rate(rate_of),
        n(steady.turned_from_start.to_degrees())
    ));
    disk::departures(g, steady, s);
    s.say("The linear equations do not give the loss of spin, the time of reversal and the spin afterwards. They have no closed form, so the motion is integrated (step 6).");
    answer
}

fn swings(rattle: &Rattleback, s: &mut Section) {
    s.say("At rest it swings in two ways. A tilt q lets P run away from below the centre of mass, by G q = (R − h) q, and gravity pulls it back if each radius is larger than h; M is the inertia about P:");
    s.formula(
        "M q\u{308} + m g G q = 0,   det (m g G − ϖ² M) = 0,   M = tr S − S + m h²,   G = R − h",
        r"M \ddot q + m g G q = 0, \qquad \det(m g G - \varpi^2 M) = 0, \qquad M = \operatorname{tr} S - S + m h^2, \qquad G = R - h",
    );
    if rattle.modes.is_empty() {
        s.say("A radius is smaller than h: at rest it falls over, and does not swing.");
        return;
    }
    for mode in &rattle.modes {
        s.line(format!("ϖ = {} rad/s, once in {} s", n(mode.frequency), n(TAU / mode.frequency)));
    }
    s.say("The quick one is the one along its length (pitching), where the radius is large, and the slow one that across (rolling), if the body is long.");
}

fn growth(rattle: &Rattleback, spin: f64, s: &mut Section) {
    s.say("Spin at Ω adds Ω (γ J − m h J G′) q\u{307}. The part with γ is gyroscopic, and does no work. But J G′ is symmetric: along one of two axes it damps, along the other it feeds, and of which sign depends on that of Ω. By first order in Ω a swing u grows as e^(σt),");
    s.formula(
        "σ/Ω = ½ m h (u · J G′ u)/(u · M u),   G′ = G − ½ tr G",
        r"\frac{\sigma}{\Omega} = \tfrac12 m h \frac{u \cdot J G' u}{u \cdot M u}, \qquad G' = G - \tfrac12 \operatorname{tr} G",
    );
    for mode in &rattle.modes {
        let at = mode.growth_per_spin * spin;
        let does = if at > 0.0 { "grows" } else { "dies away" };
        s.line(format!(
            "ϖ = {} rad/s: σ/Ω = {}, and at Ω = {} rad/s it {does}, σ = {} /s",
            n(mode.frequency),
            n(mode.growth_per_spin),
            factor(spin),
            n(at)
        ));
    }
    s.say("As tr J G′ = 0, one of them grows and the other one dies away in each sense. If S and R had the same axes, u · J G′ u would be zero for both: nothing would rattle.");
}

fn reason(s: &mut Section) {
    s.say(
        "Reason: on a skew underside, P moves off the line of the tilt, so that N and F have a torque about the vertical that goes with the swing, and, on the average, one way. Energy is constant, so the spin loses what a swing gains: spun against its sense it stops, and the remaining swing then drives it the other way.",
    );
}

fn threshold(rattle: &Rattleback, spin: f64, s: &mut Section) -> String {
    let sense = |x: f64| if x > 0.0 { "against the clock" } else { "with the clock" };
    let (stable, other) = (sense(rattle.stable_sense), sense(-rattle.stable_sense));
    s.say(format!(
        "Seen from above, spin {other} is always unstable: the sum of all four rates is Ω m h χ/det M, χ = tr (S J G′), which has one sign, and so one of them is positive. Spin {stable} is stable where the criterion of Hurwitz holds:"
    ));
    s.formula(
        "Ω² [(tr S − C + m h²) tr G − 2 m h det G] > m g det G",
        r"\Omega^2 \left[(\operatorname{tr} S - C + m h^2) \operatorname{tr} G - 2 m h \det G\right] > m g \det G",
    );
    let grows = |k: &RattleMode| k.growth_per_spin * spin > 0.0;
    let swing = rattle.modes.iter().find(|mode| grows(mode));
    let fast = swing.map_or_else(String::new, |mode| {
        format!(": the swing of {} rad/s grows at {} /s", n(mode.frequency), n(mode.growth_per_spin * spin))
    });
    match rattle.threshold {
        Some(threshold) => s.line(format!("|Ω| > {}", rate(threshold))),
        None => s.line("here no spin satisfies it: it also rattles in its own sense, but more slowly"),
    }
    if spin * rattle.stable_sense < 0.0 {
        return format!("It is spun {other}, against its sense, and will turn back{fast}.");
    }
    match rattle.threshold {
        Some(threshold) if spin.abs() > threshold => {
            format!("It is spun {stable}, in its sense and faster than {} rad/s: it is stable.", n(threshold))
        }
        _ => format!("It is spun {stable}, in its sense, but not fast enough{fast}."),
    }
}
