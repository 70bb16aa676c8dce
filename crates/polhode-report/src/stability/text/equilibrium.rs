//! The equilibrium that is meant, and the small oscillations about it.

use std::f64::consts::TAU;

use polhode::motion::TopPath;
use polhode::observe::{OrbitalEquilibrium, OscillationMode, SmallOscillations, SteadyTop};
use polhode_document::layout::labelled;
use polhode_document::number::{number, vector};
use polhode_document::unit::rate;

use super::indented;
use crate::stability::search::{Found, Place};

pub(super) fn write(found: &Found) -> String {
    let oscillations = &found.oscillations;
    let mut text = labelled("small swings", &format!("{}: {}", place(found), verdict(oscillations)));
    text.push_str(&indented(&modes(&oscillations.modes)));
    if oscillations.neutral > 0 {
        let line = format!(
            "{} of 6 rates are zero: the body can be turned, or made to turn on, without a torque",
            oscillations.neutral
        );
        text.push_str(&labelled("neutral", &line));
    }
    match &found.place {
        Place::Top(top, other) => text.push_str(&beside_top(top, other.as_deref())),
        Place::Orbit(nearest) => text.push_str(&labelled("in body axes", &in_body_axes(nearest))),
        _ => {}
    }
    text + &on_orbit(found)
}

/// A difference of two ω that is no more than this part of them is rounding.
const ROUNDING: f64 = 1e-12;

/// Which equilibrium it is, and how far from the start.
fn place(found: &Found) -> String {
    let away = number(found.turned.to_degrees(), 4);
    let spin = || match found.omega_off > ROUNDING * found.oscillations.equilibrium.omega.norm() {
        true => format!("the start is {away}° and {} from it", rate(found.omega_off)),
        false => format!("the start is {away}° from it and turns as it does"),
    };
    match &found.place {
        Place::Start => "about the start, which is an equilibrium".to_owned(),
        Place::Orbit(nearest) => format!(
            "about the nearest attitude at rest relative to the orbit, {}; {}",
            arrangement(nearest),
            spin()
        ),
        Place::Top(top, _) => format!("about {}; {}", steady(top), spin()),
        Place::Nearest => format!("about the nearest equilibrium, {away}° from the start"),
        Place::Vertical => format!("about the nearest equilibrium that turns about the vertical; {}", spin()),
        Place::Rest => {
            format!(
                "about the nearest equilibrium at rest, without the start's spin, {away}° from its attitude"
            )
        }
    }
}

fn steady(top: &SteadyTop) -> String {
    let spin = format!("ω along the axis = {}", rate(top.spin));
    match top.path {
        TopPath::Sleeping { .. } => format!("the top upright, spinning with the start's {spin}"),
        TopPath::Hanging => format!("the top straight down, with the start's {spin}"),
        path => format!(
            "{}: leaning {}° from the vertical, {} about it, {spin}; it has the start's p_φ and p_ψ, so that the top nods about it, \
             and is seen from axes that precess with it",
            path.description(),
            number(top.angle.to_degrees(), 6),
            rate(top.precession),
        ),
    }
}

/// The other steady motion that comes into question.
fn beside_top(top: &SteadyTop, other: Option<&SteadyTop>) -> String {
    let Some(other) = other else { return String::new() };
    let line = format!("{}: {}", steady(other), verdict(&other.oscillations));
    let label = if top.angle == 0.0 { "instead" } else { "upright" };
    labelled(label, &line)
}

fn verdict(oscillations: &SmallOscillations) -> String {
    let fastest = oscillations.modes.iter().map(|mode| mode.growth_rate).fold(0.0, f64::max);
    if fastest > 0.0 {
        format!("unstable, grows at {} /s", number(fastest, 4))
    } else {
        "nothing grows".to_owned()
    }
}

/// `axis 1 down, axis 2 ahead, axis 3 along the normal`
fn arrangement(equilibrium: &OrbitalEquilibrium) -> String {
    let names = [["up", "down"], ["ahead", "astern"], ["along the normal", "against the normal"]];
    let one = |((k, is_along), [along, against]): ((usize, bool), [&str; 2])| {
        format!("axis {} {}", k + 1, if is_along { along } else { against })
    };
    let about = if equilibrium.tilt > SKEW {
        format!(" (to {}°)", number(equilibrium.tilt.to_degrees(), 3))
    } else {
        String::new()
    };
    equilibrium.axes.into_iter().zip(names).map(one).collect::<Vec<_>>().join(", ") + &about
}

/// Principal axes farther than this from the orbit's are said to be so, rad.
const SKEW: f64 = 1e-6;

fn in_body_axes(equilibrium: &OrbitalEquilibrium) -> String {
    let shown = |v: [f64; 3]| vector(tidy(v), 6);
    format!(
        "up {}, ahead {}, the orbit's normal {}",
        shown(equilibrium.up.to_array()),
        shown(equilibrium.ahead.to_array()),
        shown(equilibrium.normal.to_array())
    )
}

/// All attitudes at rest relative to the orbit: by the principal axes that lie along it, whichever way they point.
fn on_orbit(found: &Found) -> String {
    let mut kinds: Vec<([usize; 3], String, usize, f64)> = Vec::new();
    for (equilibrium, oscillations) in &found.on_orbit {
        let axes = equilibrium.axes.map(|(k, _)| k);
        let verdict = verdict(oscillations);
        match kinds.iter_mut().find(|kind| kind.0 == axes && kind.1 == verdict) {
            Some(kind) => kind.2 += 1,
            None => kinds.push((axes, verdict, 1, equilibrium.state.attitude.angle_to(found.start.attitude))),
        }
    }
    if kinds.is_empty() {
        return String::new();
    }
    let row = |([up, ahead, normal], verdict, count, away): ([usize; 3], String, usize, f64)| {
        vec![
            format!(
                "axis {} vertical, {} along the flight, {} along the normal",
                up + 1,
                ahead + 1,
                normal + 1
            ),
            format!("{count} ways"),
            format!("the nearest {}° from the start", number(away.to_degrees(), 4)),
            verdict,
        ]
    };
    let count = found.on_orbit.len();
    let head = format!("{count} attitudes are at rest relative to it; by principal axes, 1 of least moment:");
    labelled("on the orbit", &head) + &indented(&kinds.into_iter().map(row).collect::<Vec<_>>())
}

/// A row for each mode; one for those of one frequency that are swings about any axis of a plane, or about any axis.
fn modes(modes: &[OscillationMode]) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    let mut rest = modes;
    while let Some(first) = rest.first() {
        let (these, others) = rest.split_at(first.multiplicity.clamp(1, rest.len()));
        rest = others;
        if these.len() > 1 && these.iter().all(|mode| mode.minor_axis.norm() < STRAIGHT) {
            let axes: Vec<String> = these.iter().map(|mode| about(mode.axis.to_array())).collect();
            let shape = match axes.as_slice() {
                [a, b] => format!("about any axis in the plane of {a} and {b}"),
                _ => "about any axis".to_owned(),
            };
            rows.push(row(first, format!("{} ways, {shape}", axes.len())));
            continue;
        }
        for mode in these {
            let axis = about(mode.axis.to_array());
            let shape = if mode.minor_axis.norm() < STRAIGHT {
                format!("about {axis}")
            } else {
                format!("on a cone: about {axis}, then {}", about(mode.minor_axis.to_array()))
            };
            let one = if these.len() > 1 { format!("one of {}, {shape}", these.len()) } else { shape };
            rows.push(row(mode, one));
        }
    }
    rows
}

fn row(mode: &OscillationMode, shape: String) -> Vec<String> {
    let period = if mode.frequency > 0.0 {
        format!("{} rad/s, period {} s", number(mode.frequency, 7), number(TAU / mode.frequency, 7))
    } else {
        "no swing".to_owned()
    };
    let rate = match mode.growth_rate {
        rate if rate > 0.0 => format!("grows at {} /s", number(rate, 6)),
        rate if rate < 0.0 => format!("dies away at {} /s", number(-rate, 6)),
        _ => "kept".to_owned(),
    };
    vec![period, rate, shape]
}

fn about(v: [f64; 3]) -> String {
    vector(tidy(v), 4)
}

/// A swing whose ellipse is thinner than this is about one axis.
const STRAIGHT: f64 = 1e-6;

/// Components of a unit vector without what its digits do not show.
fn tidy(v: [f64; 3]) -> [f64; 3] {
    v.map(|x| if x.abs() < 5e-7 { 0.0 } else { x })
}
