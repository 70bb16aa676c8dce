//! Inverted or superfluous attitude of the inertial: `inertia.conjugate`.
//!
//! The attitude of an inertial rotates its components to the link's, I_link = R I Rᵀ. The conjugate
//! quaternion (the angles of the inverse rotation) gives Rᵀ I R, which is also physical. Only the
//! geometry can detect this error. The same holds for a tensor in link axes with a superfluous
//! attitude, and for a quaternion (x, y, z, w) in place of (w, x, y, z).

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
        ("attitude of the inertial frame inverted", transposed(&body.rotation)),
        (
            "tensor along the link's axes, although the inertial frame is rotated",
            rotation_matrix([1.0, 0.0, 0.0, 0.0]),
        ),
        ("quaternion in the order x y z w instead of w x y z", rotation_matrix([z, w, x, y])),
    ];
    for (mistake, rotation) in mistakes {
        let right = body.in_inertial_axes(&rotated(&body.written, &rotation));
        candidates.offer(right.map(Change::Value), LOOSE, || Slip {
            code: "inertia.conjugate",
            mistake: mistake.to_owned(),
            rule: "the attitude of an inertial rotates its components into the link's frame: I_link = R I Rᵀ",
            span: body.inertial.pose.span.clone().unwrap_or(body.inertial.span.clone()),
            is_sure: false,
        });
    }
}
