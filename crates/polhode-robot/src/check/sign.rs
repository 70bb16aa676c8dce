//! Products with the other sign: `inertia.sign`.
//!
//! Some programs print +∫xy dm, some −∫xy dm; a tensor wants the second. The wrong one flips all three. One copied from
//! the mirrored side of a robot has two of them flipped, the two that hold the mirrored axis. Both leave the moments
//! of the diagonal right, and are possible as often as not: only the geometry can tell.

use super::body::NAMES;
use super::explanation::{Candidates, Explanation, edits};
use super::written::negated;
use crate::model::Tensor;

/// Which of ixy, ixz, iyz have the other sign: all first, then two, then one.
const PATTERNS: [[bool; 3]; 7] = [
    [true, true, true],
    [true, true, false],
    [true, false, true],
    [false, true, true],
    [true, false, false],
    [false, true, false],
    [false, false, true],
];

pub(super) fn explain(candidates: &mut Candidates) {
    let body = candidates.body;
    if !matches!(body.inertial.tensor, Tensor::Six(_)) {
        return;
    }
    let present = [3, 4, 5].map(|k| body.written[k] != 0.0);
    for pattern in PATTERNS {
        // Zeros have no sign. "All" stands for what there is of them.
        let all = pattern == [true; 3];
        let flips: [bool; 3] = std::array::from_fn(|k| pattern[k] && present[k]);
        if flips == [false; 3] || !all && (flips != pattern || flips == present) {
            continue;
        }
        let flipped = |k: usize| k >= 3 && flips[k - 3];
        let tensor = std::array::from_fn(|k| if flipped(k) { -body.written[k] } else { body.written[k] });
        candidates.offer(body.in_link_axes(&tensor), || {
            let names: Vec<&str> = (3..6).filter(|k| flipped(*k)).map(|k| NAMES[k]).collect();
            Explanation {
                code: "inertia.sign",
                mistake: if all {
                    "the products have the other sign (+∫xy dm for −∫xy dm)".to_owned()
                } else {
                    format!("{} with the other sign", names.join(" and "))
                },
                rule: "ixy = −∫xy dm, ixz = −∫xz dm, iyz = −∫yz dm",
                span: (3..6).find(|k| flipped(*k)).map_or(body.tensor_place(), |k| body.place(k)),
                edits: edits(body, |k, text| Some(if flipped(k) { negated(text) } else { text.to_owned() })),
            }
        });
    }
}
