//! Step 5 of a body that spins on a point below its centre of mass.

use polhode::motion::contact::Footing;
use polhode::observe::{StableSpins, SteadyOnGround, VertexSpin};
use polhode_document::Section;
use polhode_document::number::tidy_beside;
use polhode_document::unit::rate;

use super::super::working::n;
use super::{OnGround, disk};

/// Writes the height of the centre of mass, the radii of curvature, and the stable spins.
pub(crate) fn stands(
    g: &OnGround<'_, '_>,
    steady: &SteadyOnGround,
    vertex: &VertexSpin,
    s: &mut Section,
) -> String {
    s.say(
        "Near to the start is a steady motion: the body spins about the vertical at Ω on a point below its centre of mass, at the height h; R are the radii of curvature there, S the moments across the vertical, C that about it (matrices along two axes \
         of the body across n). Small deviations q of n obey",
    );
    s.formula(
        "M q\u{308} + Ω (γ J − µ h J G′) q\u{307} + K q = 0,   M = tr S − S + µ h²,   K = m g G + Ω² (µ h G + C − S),   G = R − h",
        r"M \ddot q + \Omega (\gamma J - \mu h J G') \dot q + K q = 0, \qquad M = \operatorname{tr} S - S + \mu h^2, \qquad K = m g G + \Omega^2 (\mu h G + C - S), \qquad G = R - h",
    );
    let mass = if steady.footing == Footing::Rolling { "µ = m" } else { "µ = 0" };
    s.say(format!(
        "with γ = tr S − C + µ h² − ½ µ h tr G, G′ = G without its trace, J the quarter turn, and {mass} of what {}.",
        if steady.footing == Footing::Rolling { "rolls" } else { "slips freely" }
    ));
    numbers(vertex, s);
    s.line(format!(
        "Ω = {},  {}° from the start",
        rate(steady.spin),
        n(steady.turned_from_start.to_degrees())
    ));
    disk::departures(g, steady, s);
    if let Some(spins) = &steady.stable_spins {
        law(spins, s);
    }
    let verdict = if steady.is_stable() { "is stable" } else { "is unstable" };
    format!("It spins at {} on a point below its centre of mass; that {verdict}.", rate(steady.spin))
}

/// Writes h, C, S and R.
pub(crate) fn numbers(vertex: &VertexSpin, s: &mut Section) {
    let matrix = |[[a, b], [_, d]]: [[f64; 2]; 2]| {
        let [a, b, d] = tidy_beside([a, b, d], a.abs().max(d.abs())).map(n);
        format!("({a}, {b}; {b}, {d})")
    };
    s.line(format!("h = {} m,  C = {} kg·m²", n(vertex.height), n(vertex.along)));
    s.line(format!("S = {} kg·m²", matrix(vertex.across)));
    s.line(format!("R = {} m,  G = {} m", matrix(vertex.radii), matrix(vertex.lever())));
    s.line(format!("M = {} kg·m²", matrix(vertex.inertia())));
}

/// Writes the stability condition of the spin, and its bounds, rad/s.
pub(crate) fn law(spins: &StableSpins, s: &mut Section) {
    let one = |[from, to]: &[f64; 2]| match (from.is_finite(), to.is_finite()) {
        (true, true) => format!("{} to {} rad/s", n(*from), n(*to)),
        (true, false) => format!("above {} rad/s", n(*from)),
        (false, true) => format!("below {} rad/s", n(*to)),
        (false, false) => "at every spin".to_owned(),
    };
    let all: Vec<String> = spins.intervals.iter().map(one).collect();
    let all = if all.is_empty() { "at none".to_owned() } else { all.join(", and ") };
    s.line(format!("stable where {}: {all}", spins.law));
}
