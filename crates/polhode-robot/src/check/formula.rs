//! Moments computed with a wrong formula: `inertia.geometry`.
//!
//! A tensor without products follows from the second moments a, b, c of the geometry along x, y, z,
//! times the mass:
//!
//!   ixx = b + c,  iyy = a + c,  izz = a + b.
//!
//! Typical errors take the wrong pair (izz = a + c), or omit one of the two (ixx = c, the formula
//! of a slender rod). Others take a length twice or half as long as it is (4 c, c/4; 2 c for H²/2
//! in place of (H/2)²). The written value must equal the result of the error to all digits, because
//! bodies are not uniform. The correct value is the geometry's.

use super::explanation::{Candidates, Change, Slip, TIGHT, named};
use super::factor::{ROUND_SECTION, RULE};

/// The two axes perpendicular to each axis.
const ACROSS: [[usize; 2]; 3] = [[1, 2], [0, 2], [0, 1]];

const AXES: [&str; 3] = ["x", "y", "z"];

pub(super) fn explain(candidates: &mut Candidates) {
    if !candidates.is_aligned() {
        return;
    }
    let seconds = candidates.second_moments();
    each_by_itself(candidates, seconds);
    lengths(candidates, seconds);
}

/// Offers moments from a wrong pair of axes, or from one axis alone.
fn each_by_itself(candidates: &mut Candidates, seconds: [f64; 3]) {
    let body = candidates.body;
    let wrong: Vec<usize> = (0..3).filter(|k| !candidates.agrees(*k, TIGHT)).collect();
    let nearest = |k: usize, values: [f64; 2]| {
        let off = |value: &f64| (value - body.written[k]).abs();
        values.into_iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(f64::NAN)
    };
    let pairs = |k: usize| {
        let [i, j] = ACROSS[k];
        nearest(k, [seconds[k] + seconds[i], seconds[k] + seconds[j]])
    };
    let rods = |k: usize| {
        let [i, j] = ACROSS[k];
        nearest(k, [seconds[i], seconds[j]])
    };
    let pair = "the formula of another axis (a wrong pair of lengths)";
    let rod = "the formula of a slender rod: one of two squared lengths is missing";
    for (values, why) in [([0, 1, 2].map(pairs), pair), ([0, 1, 2].map(rods), rod)] {
        let changes =
            std::array::from_fn(
                |k| {
                    if wrong.contains(&k) { Change::Formula(values[k]) } else { Change::Keep }
                },
            );
        candidates.offer(changes, TIGHT, || slip(body, &wrong, format!("{}: {why}", named(&wrong))));
    }
}

/// Offers lengths along one or two axes that are wrong by one factor.
fn lengths(candidates: &mut Candidates, seconds: [f64; 3]) {
    let body = candidates.body;
    for axes in [&[0][..], &[1], &[2], &[0, 1], &[0, 2], &[1, 2]] {
        for (factor, why) in [
            (4.0, "a diameter instead of a radius, or a full length instead of a half length"),
            (0.25, "a radius instead of a diameter, or a half length instead of a full length"),
            (2.0, "H²/2 instead of (H/2)²"),
        ] {
            // A factor of 2 on two equal second moments is a thin tube, which is right.
            if let (true, &[i, j]) = (factor == 2.0, axes)
                && (seconds[i] - seconds[j]).abs() <= ROUND_SECTION * seconds[i]
            {
                continue;
            }
            let changed = |k: usize| seconds[k] * if axes.contains(&k) { factor } else { 1.0 };
            let values = ACROSS.map(|[i, j]| changed(i) + changed(j));
            let wrong: Vec<usize> =
                (0..3).filter(|k| ACROSS[*k].iter().any(|axis| axes.contains(axis))).collect();
            let changes = std::array::from_fn(|k| {
                if wrong.contains(&k) { Change::Formula(values[k]) } else { Change::Keep }
            });
            candidates.offer(changes, TIGHT, || {
                let along: Vec<&str> = axes.iter().map(|axis| AXES[*axis]).collect();
                slip(body, &wrong, format!("{}: {why}, along {}", named(&wrong), along.join(" and ")))
            });
        }
    }
}

fn slip(body: &super::body::Body, wrong: &[usize], mistake: String) -> Slip {
    let span = wrong.first().map_or(body.tensor_place(), |k| body.place(*k));
    Slip { code: "inertia.geometry", mistake, rule: RULE, span, is_sure: true }
}
