//! Tensor about the link's origin instead of the centre of mass: `inertia.about_origin`.
//!
//!   I_centre = I_origin − m (c² 1 − c cᵀ)
//!
//! CAD programs print both, one below the other. The centre c is that of the file. If the file
//! leaves it at the origin, it is the geometry's centroid.

use super::explanation::{Candidates, Change, LOOSE, SAME, Slip};
use super::written::short;
use crate::model::Tensor;
use crate::moments::{difference, parallel_axes};

/// Values below this fraction of the largest element are rounding of the computation.
const NOTHING: f64 = 1e-12;

pub(super) fn explain(candidates: &mut Candidates) {
    let body = candidates.body;
    let is_given = body.centre != [0.0; 3];
    let centre = if is_given { body.centre } else { candidates.solid.centroid };
    let tensor = difference(&body.tensor, &parallel_axes(candidates.mass, centre));
    let right = body.in_inertial_axes(&tensor);
    let away = short(centre.iter().map(|x| x * x).sum::<f64>().sqrt(), 4);
    let mistake = if is_given {
        format!("tensor about the link's origin, {away} m from the centre of mass")
    } else {
        format!(
            "tensor about the link's origin, and no centre of mass is given; the geometry's centroid is {away} m from the origin"
        )
    };
    // A small difference of large numbers has few digits. If these do not distinguish it from the
    // geometry's value, the geometry's value is used.
    let size = right.iter().fold(0.0, |max, x| f64::max(max, x.abs()));
    let target = candidates.target;
    let is_targets = |k: usize| (right[k] - target[k]).abs() <= body.rounding[k];
    let has_digits = (0..6).all(|k| is_targets(k) || body.rounding[k] <= SAME * size);
    let value = |k: usize| {
        let value = if is_targets(k) { target[k] } else { right[k] };
        if value.abs() <= NOTHING * size { 0.0 } else { value }
    };
    let change = |k: usize| {
        let is_same = (right[k] - body.written[k]).abs() <= NOTHING * size;
        if is_same { Change::Keep } else { Change::Value(value(k)) }
    };
    // A diagonal tensor cannot store products.
    let is_sure = is_given && has_digits && matches!(body.inertial.tensor, Tensor::Six(_));
    candidates.offer(std::array::from_fn(change), LOOSE, || Slip {
        code: "inertia.about_origin",
        mistake,
        rule: "the tensor of an inertial is about the centre of mass, the origin of the inertial frame",
        span: body.tensor_place(),
        is_sure,
    });
}
