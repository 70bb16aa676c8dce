//! Captions of the pictures: the content, with its numbers.

use polhode::motion::{FreeMotion, Regime};
use polhode_document::number::{number, typeset};
use polhode_document::unit::time;
use serde_json::{Value, json};

use super::cones::{ConeAngles, Precession, is_moving};
use crate::report::answer;
use crate::report::facts::Known;
use crate::report::free_facts::FreeFacts;

/// Number of significant digits in a caption.
const DIGITS: usize = 4;

/// Captions of the pictures; the last three pictures exist for free motions only.
#[derive(Clone, Debug)]
pub(crate) struct Captions {
    body: String,
    free: Option<[String; 3]>,
}

impl Captions {
    pub(crate) fn of(known: &Known<'_>, free: Option<&FreeFacts>) -> Self {
        let body = answer::lines(known).join(" ");
        Self { body, free: free.map(|free| [poinsot(&free.motion), cones(free), sphere(free)]) }
    }

    pub(crate) fn json(&self) -> Value {
        let free = |k: usize| self.free.as_ref().and_then(|all| all.get(k)).map(|text| typeset(text));
        json!({ "body": typeset(&self.body), "poinsot": free(0), "cones": free(1), "sphere": free(2) })
    }
}

fn poinsot(motion: &FreeMotion) -> String {
    let height = number(2.0 * motion.kinetic_energy() / motion.momentum().norm(), DIGITS);
    match (is_rod(motion), is_moving(motion)) {
        (false, true) => format!(
            "The inertia ellipsoid rolls without slipping on the invariable plane, 2T/|L| = {height} rad/s from its centre; the \
             point of contact, the tip of ω, traces the polhode and the herpolhode."
        ),
        (false, false) => format!(
            "The inertia ellipsoid touches the invariable plane, 2T/|L| = {height} rad/s from its centre, at one point: ω stays \
             along L."
        ),
        (true, is_moving) => {
            let tip = if is_moving {
                ". The point of this line that is at rest, the tip of ω, traces the polhode and the herpolhode"
            } else {
                ": ω stays along L"
            };
            format!(
                "The inertia ellipsoid of a rod is a cylinder: it touches the invariable plane, 2T/|L| = {height} rad/s from its \
                 centre, along a line{tip}."
            )
        }
    }
}

fn cones(free: &FreeFacts) -> String {
    if !is_moving(&free.motion) {
        return "A permanent rotation: ω remains along L, and both cones are lines.".to_owned();
    }
    let ConeAngles { body, space, precession } = ConeAngles::of(free);
    let [half, narrow] = [body, space].map(|[least, _]| degrees(least));
    match precession {
        Some(Precession::Prograde) => format!(
            "The body cone (half-angle {half}) rolls outside on the space cone ({narrow}): prograde precession."
        ),
        Some(Precession::Retrograde) => format!(
            "The body cone (half-angle {half}) rolls around the space cone ({narrow}), which is inside it: retrograde precession."
        ),
        None => {
            let axis = circled(&free.motion);
            let [body, space] =
                [body, space].map(|[least, most]| format!("{} … {}", degrees(least), degrees(most)));
            format!(
                "The body cone (ω to axis {axis}: {body}) rolls on the space cone (ω to L: {space}); the body is asymmetric, so \
                 neither is circular."
            )
        }
    }
}

fn sphere(free: &FreeFacts) -> String {
    let motion = &free.motion;
    match (motion.regime(), free.regime.period) {
        (Regime::Separatrix, _) => {
            "The tip of L in the body moves along a separatrix towards axis 2, without reaching it."
                .to_owned()
        }
        (_, Some(period)) if is_rod(motion) => {
            let period = time(period, DIGITS);
            format!(
                "The tip of L in the body circles axis 1 once in {period}, on the great circle across the rod: L has no component along \
                 it."
            )
        }
        (regime, Some(period)) => {
            let separatrices = if regime == Regime::Symmetric {
                "; for a symmetric body all curves are circles"
            } else {
                "; the separatrices pass through axis 2"
            };
            let axis = circled(motion);
            let period = time(period, DIGITS);
            format!(
                "The tip of L in the body circles axis {axis} once in {period}, along T = const on the sphere |L| = \
                 const{separatrices}."
            )
        }
        (regime, None) => format!("L is constant in the body: {}.", regime.description()),
    }
}

/// Returns true if a moment is zero, so that 2T = I (ω₂² + ω₃²) does not depend on ω₁.
fn is_rod(motion: &FreeMotion) -> bool {
    motion.labelled_moments().contains(&0.0)
}

fn circled(motion: &FreeMotion) -> u8 {
    if motion.circles_least() { 1 } else { 3 }
}

fn degrees(rad: f64) -> String {
    format!("{}°", number(rad.to_degrees(), DIGITS))
}
