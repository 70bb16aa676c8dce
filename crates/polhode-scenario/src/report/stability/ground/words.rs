//! Steady motions on the ground in words.

use polhode::observe::{Place, StableSpins, SteadyPath};
use polhode_document::number::number;

use super::GroundStabilityReport;

/// Digits of a number in words.
const DIGITS: usize = 4;

/// Kind of the steady motion, and its position.
pub(crate) fn path(report: &GroundStabilityReport) -> [&'static str; 2] {
    match report.steady.path {
        SteadyPath::RollingUpright(_) => ["rolling straight", "with a level axis"],
        SteadyPath::SpinningUpright(_) => ["spinning about the vertical", "with a level axis"],
        SteadyPath::OnVertex(_) => match place(report) {
            Some(Place::Bottom) => ["spinning about the vertical", "with the centre of mass lowest"],
            Some(Place::Tilted | Place::Inverted) => {
                ["spinning about the vertical", "inverted with the centre of mass highest"]
            }
            None => ["spinning about the vertical", "on a point below the centre of mass"],
        },
        SteadyPath::Tilted => ["spinning about the vertical", "at a tilt with the centre of mass at rest"],
        _ => ["circling", "at a tilt"],
    }
}

/// End on which a tippe top spins about its axis.
fn place(report: &GroundStabilityReport) -> Option<Place> {
    let steady = &report.steady;
    steady.tippe_top?;
    let along = steady.axis?.dot(steady.normal);
    Some(if along > 0.0 { Place::Bottom } else { Place::Inverted })
}

/// Sense of a spin about the vertical, seen from above.
pub(crate) fn sense(spin: f64) -> &'static str {
    if spin > 0.0 { "counter-clockwise" } else { "clockwise" }
}

/// `above 5.7 rad/s in either sense`
pub(crate) fn intervals(spins: &StableSpins) -> String {
    let rate = |rate: f64| format!("{}\u{a0}rad/s", number(rate, DIGITS));
    let one = |[from, to]: &[f64; 2]| match (from.is_finite(), to.is_finite()) {
        (true, true) if *from == -to => format!("up to {} in either sense", rate(*to)),
        (true, true) => format!("between {} and {}", rate(*from), rate(*to)),
        (true, false) => format!("above {}", rate(*from)),
        (false, true) => format!("below {}", rate(*to)),
        (false, false) => "all".to_owned(),
    };
    match spins.intervals.as_slice() {
        [] => "none".to_owned(),
        [[_, below], [above, _]] if *below == -above => format!("above {} in either sense", rate(*above)),
        all => all.iter().map(one).collect::<Vec<_>>().join(", "),
    }
}
