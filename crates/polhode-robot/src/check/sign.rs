//! Products with the other sign: `inertia.sign`.
//!
//! Some programs print +∫xy dm, some −∫xy dm; a tensor wants the second. The wrong one flips all
//! three. One copied from the mirrored side of a robot has two of them flipped, the two that hold
//! the mirrored axis. Both leave the moments of the diagonal right, and are possible as often as
//! not: only the geometry can tell. It tells of each product by itself; a product too small to tell
//! leaves the fix open.

use super::explanation::{BETTER, Candidates, Change, LOOSE, SAME, Slip, named};
use crate::model::Tensor;

pub(super) fn explain(candidates: &mut Candidates) {
    let body = candidates.body;
    if !matches!(body.inertial.tensor, Tensor::Six(_)) {
        return;
    }
    let present: Vec<usize> = (3..6).filter(|k| body.written[*k] != 0.0).collect();
    // Distance of the product from the geometry's, as written and with the other sign.
    let off = |k: usize| {
        let [written, target] = [body.written[k], candidates.target[k]];
        ((written - target).abs(), (written + target).abs())
    };
    let flipped: Vec<usize> = present
        .iter()
        .copied()
        .filter(|k| {
            let (as_written, turned) = off(*k);
            BETTER * turned <= as_written
        })
        .collect();
    let is_open = |k: &usize| {
        let (as_written, turned) = off(*k);
        let [xx, yy, zz, ..] = body.written;
        let noise = SAME * xx.max(yy).max(zz).abs();
        body.written[*k].abs() > noise && BETTER * turned > as_written && BETTER * as_written > turned
    };
    let is_sure = !present.iter().any(is_open);
    let changes = std::array::from_fn(|k| if flipped.contains(&k) { Change::Negate } else { Change::Keep });
    candidates.offer(changes, LOOSE, || Slip {
        code: "inertia.sign",
        mistake: if flipped == present {
            "the products have the other sign (+∫xy dm for −∫xy dm)".to_owned()
        } else {
            format!("{} with the other sign", named(&flipped))
        },
        rule: "ixy = −∫xy dm, ixz = −∫xz dm, iyz = −∫yz dm",
        span: flipped.first().map_or(body.tensor_place(), |k| body.place(*k)),
        is_sure,
    });
}
