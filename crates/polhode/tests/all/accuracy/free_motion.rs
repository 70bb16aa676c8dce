//! Free motion compared with references of 40 digits.

use std::f64::consts::TAU;

use polhode::motion::Regime;
use polhode::prelude::*;

use crate::common::{cases, number, numbers, start, table};

/// Error bound of every group of cases, at every time: ω relative, attitude in rad.
pub(crate) const PROMISED: f64 = 4e-15;

/// Relative error bound of the constants of motion.
const CONSTANTS: f64 = 1e-15;

/// Groups of cases, in the order of the page.
pub(crate) const GROUPS: [(&str, &str); 13] = [
    ("generic", "moments such as 1, 2, 3; both modes, every order of the axes, every sign"),
    ("awkward", "moments and ω that fill all bits of their doubles"),
    ("nearly symmetric", "moments nearly equal, two or three, to 0.1 … 1e-15"),
    ("the same, turning across", "nearly symmetric, ω across the axis that is nearly one of symmetry"),
    ("near the separatrix", "1 − m = 1e-3 … 1e-32, some of them nearly symmetric or needles"),
    ("separatrix", "L² = 2T i2 exactly"),
    ("needles", "least moment 1e-3 … 1e-12"),
    ("plates", "i1 + i2 = i3"),
    ("symmetric", "two equal moments"),
    ("permanent, spherical", "ω stays where it is"),
    ("wobble", "ω within 1e-8 … 1e-100 of an axis"),
    ("scales", "moments and ω of 1e-150, 1e150 and their mixtures"),
    ("unphysical", "unphysical moments (textbooks)"),
];

fn group(case: &toml::Table) -> usize {
    let [name, regime, symmetry] = ["name", "regime", "symmetry"].map(|key| case[key].as_str().unwrap());
    let index = |name: &str| GROUPS.iter().position(|group| group.0 == name).unwrap();
    index(if !case["physical"].as_bool().unwrap() {
        "unphysical"
    } else if regime == "separatrix" {
        "separatrix"
    } else if regime == "permanent" {
        "permanent, spherical"
    } else if name.contains("near_separatrix") {
        "near the separatrix"
    } else if name.starts_with("needle") {
        "needles"
    } else if name.starts_with("plate") {
        "plates"
    } else if symmetry != "asymmetric" {
        "symmetric"
    } else if name.starts_with("wobble") {
        "wobble"
    } else if name.starts_with("scale") {
        "scales"
    } else if name.starts_with("near_") && name.contains("awkward") {
        "the same, turning across"
    } else if name.starts_with("near_") {
        "nearly symmetric"
    } else if name.starts_with("ugly") {
        "awkward"
    } else {
        "generic"
    })
}

/// Spans of time in periods: the name, and a limit above all of its rows and below those of the
/// next span.
pub(crate) const SPANS: [(&str, f64); 4] =
    [("≤ 13", 100.0), ("≤ 1e3", 1e5), ("≤ 1e6", 1e8), ("≤ 1e9", f64::INFINITY)];

/// Returns the period; without a period one turn, or the time 1/λ on the separatrix.
fn unit_of_time(motion: &FreeMotion) -> f64 {
    let [i1, i2, i3] = motion.labelled_moments();
    match motion.regime() {
        Regime::Separatrix => 1.0 / (motion.amplitudes()[2] * ((i3 - i1) * (i3 - i2) / (i1 * i2)).sqrt()),
        _ => motion.period().unwrap_or(TAU / motion.start().omega.norm()),
    }
}

#[derive(Clone, Copy, Default)]
pub(crate) struct Worst {
    pub(crate) cases: usize,
    pub(crate) rows: [usize; SPANS.len()],
    pub(crate) omega: [f64; SPANS.len()],
    pub(crate) attitude: [f64; SPANS.len()],
    /// Relative errors of the period, of the mean precession and of 1 − m; `None` if the quantity
    /// does not exist.
    pub(crate) constants: [Option<f64>; 3],
}

pub(crate) fn error_of(state: &State, omega: [f64; 3], attitude: Attitude) -> [f64; 2] {
    let truth = AngularVelocity::<Body>::from_array(omega);
    [(state.omega - truth).norm() / truth.norm(), state.attitude.angle_to(attitude)]
}

pub(crate) fn measured() -> [Worst; GROUPS.len()] {
    let mut groups = [Worst::default(); GROUPS.len()];
    for case in cases(&table("free_motion"), "case") {
        let motion = FreeMotion::of_moments(numbers(&case["moments"]), start(case)).unwrap();
        let unit = unit_of_time(&motion);
        let worst = &mut groups[group(case)];
        worst.cases += 1;
        let constants = [
            ("period", motion.period()),
            ("precession_rate", Some(motion.precession_rate())),
            ("one_minus_m", Some(motion.parameter()[1])),
        ];
        // A body that is spherical or symmetric to within rounding is treated as such, and may have
        // no period.
        for (worst, (key, got)) in worst.constants.iter_mut().zip(constants) {
            if let (Some(got), Some(want)) = (got, case.get(key).map(number)) {
                let error = if got == want { 0.0 } else { (got / want - 1.0).abs() };
                assert!(error <= CONSTANTS, "{:?}: {key} {error:e}", case["name"]);
                *worst = Some(worst.unwrap_or(0.0).max(error));
            }
        }
        // The start itself is not computed.
        for row in cases(case, "row").into_iter().filter(|row| number(&row["t"]) != 0.0) {
            let t = number(&row["t"]);
            let span = SPANS.iter().position(|span| t.abs() < span.1 * unit).unwrap();
            let [omega, attitude] =
                error_of(&motion.at(t), numbers(&row["omega"]), crate::common::attitude(&row["attitude"]));
            assert!(omega.is_finite() && attitude.is_finite(), "{:?} at {t}", case["name"]);
            worst.rows[span] += 1;
            worst.omega[span] = worst.omega[span].max(omega);
            worst.attitude[span] = worst.attitude[span].max(attitude);
        }
    }
    groups
}
