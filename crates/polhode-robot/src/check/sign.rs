//! Products with the wrong sign: `inertia.sign`.
//!
//! Some programs print +∫xy dm, others −∫xy dm; the tensor needs the second. The wrong convention
//! flips all three products. A tensor copied from the mirrored side of a robot has two flipped
//! products, those that contain the mirrored axis. Both errors keep the diagonal, and the result is
//! often physical. Only the geometry can detect them. Each product is tested separately; if one is
//! too small to decide, a fix is not offered.

use super::explanation::{BETTER, Candidates, Change, LOOSE, SAME, Slip, named};
use crate::model::Tensor;

pub(super) fn explain(candidates: &mut Candidates) {
    let body = candidates.body;
    if !matches!(body.inertial.tensor, Tensor::Six(_)) {
        return;
    }
    let present: Vec<usize> = (3..6).filter(|k| body.written[*k] != 0.0).collect();
    // Deviation of the product from the geometry's: as written, and with the opposite sign.
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
            "the products have the wrong sign (+∫xy dm instead of −∫xy dm)".to_owned()
        } else {
            format!("{} with the wrong sign", named(&flipped))
        },
        rule: "ixy = −∫xy dm, ixz = −∫xz dm, iyz = −∫yz dm",
        span: flipped.first().map_or(body.tensor_place(), |k| body.place(*k)),
        is_sure,
    });
}
