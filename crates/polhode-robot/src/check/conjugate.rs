//! The inertial's attitude is the inverse of what it should be, or is not meant at all: `inertia.conjugate`.
//!
//! The attitude of an inertial takes its components to the link's, I_link = R I Rᵀ. The conjugate quaternion (angles of
//! the inverse rotation) gives Rᵀ I R, which is as possible, and only the geometry can tell. So with numbers along the
//! link's axes beside an attitude that is left over, and with (x, y, z, w) where (w, x, y, z) belongs.

use super::explanation::{Candidates, Change, LOOSE, Slip};
use crate::moments::rotated;
use crate::pose::{rotation_matrix, transposed};

pub(super) fn explain(candidates: &mut Candidates) {
    let body = candidates.body;
    let [w, x, y, z] = body.inertial.pose.rotation;
    if [x, y, z] == [0.0; 3] {
        return;
    }
    let mistakes = [
        ("attitude of the inertial's frame conjugated", transposed(&body.rotation)),
        (
            "tensor along the link's axes, though the inertial's frame is turned",
            rotation_matrix([1.0, 0.0, 0.0, 0.0]),
        ),
        ("quaternion x y z w in the place of w x y z", rotation_matrix([z, w, x, y])),
    ];
    for (mistake, rotation) in mistakes {
        let right = body.in_inertial_axes(&rotated(&body.written, &rotation));
        candidates.offer(right.map(Change::Value), LOOSE, || Slip {
            code: "inertia.conjugate",
            mistake: mistake.to_owned(),
            rule: "the attitude of an inertial takes its components to the link's: I_link = R I Rᵀ",
            span: body.inertial.pose.span.clone().unwrap_or(body.inertial.span.clone()),
            is_sure: false,
        });
    }
}
