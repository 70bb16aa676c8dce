//! Six correct numbers in the wrong order: `inertia.order`.
//!
//! Three orders of the elements are common:
//!
//! - diagonal first (xx yy zz xy xz yz, as MJCF's `fullinertia`),
//! - upper triangle by rows (xx xy xz yy yz zz, as URDF and SDF name them),
//! - lower triangle by rows (xx xy yy xz yz zz).
//!
//! Reading one order as another puts products in place of moments, which is usually impossible.
//! Nine numbers by rows (xx xy xz yx yy yz …) cut to six show xy = yx in two places; zz is then
//! lost.
//!
//! Other exchanges leave a physical tensor, so only the geometry can detect them. The products may
//! be exchanged (xy yz xz; or yz xz xy, the order of stresses in engineering). The moments of a
//! body without products may be exchanged (a cylinder along another axis). Two axes may be
//! exchanged with all their elements (y up for z up).

use super::body::Body;
use super::explanation::{Candidates, Change, LOOSE, Slip};
use super::finding;
use crate::finding::{Finding, Severity};
use crate::model::Tensor;
use crate::moments::{Elements, Moments};

/// Permutation of elements with signs: `right[k] = ± written[from[k]]`
pub(crate) struct Order {
    pub(crate) mistake: &'static str,
    from: [usize; 6],
    /// True for elements whose sign changes.
    negated: [bool; 6],
}

impl Order {
    /// Returns the elements in the right order.
    pub(crate) fn applied(&self, written: &Elements) -> Elements {
        std::array::from_fn(|k| {
            let element = written[self.from[k]];
            if self.negated[k] { -element } else { element }
        })
    }

    /// Returns all orders.
    pub(crate) fn all() -> impl Iterator<Item = &'static Self> {
        LISTS.iter().chain(&PRODUCTS).chain(&MOMENTS).chain(&AXES)
    }
}

const fn order(mistake: &'static str, from: [usize; 6]) -> Order {
    Order { mistake, from, negated: [false; 6] }
}

/// Returns a rotation by 90°: two products change sign.
const fn turn(mistake: &'static str, from: [usize; 6], negated: [usize; 2]) -> Order {
    let mut order = order(mistake, from);
    let [i, j] = negated;
    order.negated[i] = true;
    order.negated[j] = true;
    order
}

const LISTS: [Order; 4] = [
    order("xx yy zz xy xz yz written as xx xy xz yy yz zz", [0, 3, 4, 1, 5, 2]),
    order("row-major xx xy xz yy yz zz written as xx yy zz xy xz yz", [0, 3, 5, 1, 2, 4]),
    order("the lower triangle xx xy yy xz yz zz written as xx xy xz yy yz zz", [0, 4, 2, 3, 1, 5]),
    order("the lower triangle xx xy yy xz yz zz written as xx yy zz xy xz yz", [0, 2, 5, 1, 3, 4]),
];

const PRODUCTS: [Order; 5] = [
    order("iyz and ixz swapped", [0, 1, 2, 3, 5, 4]),
    order("ixy and iyz swapped", [0, 1, 2, 5, 4, 3]),
    order("ixy and ixz swapped", [0, 1, 2, 4, 3, 5]),
    order("products in the order xz yz xy", [0, 1, 2, 5, 3, 4]),
    order("products in the order yz xy xz", [0, 1, 2, 4, 5, 3]),
];

const MOMENTS: [Order; 5] = [
    order("ixx and iyy swapped", [1, 0, 2, 3, 4, 5]),
    order("ixx and izz swapped", [2, 1, 0, 3, 4, 5]),
    order("iyy and izz swapped", [0, 2, 1, 3, 4, 5]),
    order("moments in the order zz xx yy", [1, 2, 0, 3, 4, 5]),
    order("moments in the order yy zz xx", [2, 0, 1, 3, 4, 5]),
];

/// Exchanged axes. A change of handedness exchanges two axes; a rotation by 90° also changes signs.
const AXES: [Order; 9] = [
    order("axes x and y swapped", [1, 0, 2, 3, 5, 4]),
    order("axes x and z swapped", [2, 1, 0, 5, 4, 3]),
    order("axes y and z swapped", [0, 2, 1, 4, 3, 5]),
    turn("axes rotated by 90° about x", [0, 2, 1, 4, 3, 5], [3, 5]),
    turn("axes rotated by 90° about x", [0, 2, 1, 4, 3, 5], [4, 5]),
    turn("axes rotated by 90° about y", [2, 1, 0, 5, 4, 3], [3, 4]),
    turn("axes rotated by 90° about y", [2, 1, 0, 5, 4, 3], [4, 5]),
    turn("axes rotated by 90° about z", [1, 0, 2, 3, 5, 4], [3, 4]),
    turn("axes rotated by 90° about z", [1, 0, 2, 3, 5, 4], [3, 5]),
];

const RULE: &str = "URDF and SDF name each element; MJCF's fullinertia is xx yy zz xy xz yz";

/// Offers orders that explain a physical tensor that differs from its geometry's.
pub(super) fn explain(candidates: &mut Candidates) {
    let body = candidates.body;
    let bare = body.written[3..].iter().all(|x| *x == 0.0);
    let full = matches!(body.inertial.tensor, Tensor::Six(_)) && !bare;
    let of_full = LISTS.iter().chain(&PRODUCTS).chain(&AXES).filter(|_| full);
    for order in of_full.chain(MOMENTS.iter().filter(|_| bare)) {
        let change = |k: usize| match (order.from[k], order.negated[k]) {
            (from, false) if from == k => Change::Keep,
            (from, negates) => Change::Take(from, negates),
        };
        candidates.offer(std::array::from_fn(change), LOOSE, || Slip {
            code: "inertia.order",
            mistake: order.mistake.to_owned(),
            rule: RULE,
            span: body.tensor_place(),
            is_sure: true,
        });
    }
}

/// Reports orders that explain an impossible tensor without help of the geometry.
pub(super) fn check_alone(body: &Body, findings: &mut Vec<Finding>) {
    if !matches!(body.inertial.tensor, Tensor::Six(_)) || body.written == [0.0; 6] {
        return;
    }
    let [ixx, iyy, _, ixy, ixz, iyz] = body.written;
    // Nine elements by rows in the places xx xy xz yy yz zz: yx is in the place of iyy, yy in that
    // of iyz. Products may be zero.
    let bare = [iyy, ixy, ixz] == [0.0; 3] && ixx > 0.0 && iyz > 0.0;
    if iyy == ixy && (iyy != 0.0 || bare) {
        let message = format!(
            "iyy = ixy = {iyy} kg·m²: the first six of nine elements, xx xy xz yx yy yz, written as the six of a symmetric tensor"
        );
        let rule = "a symmetric tensor has six different elements; zz is missing here";
        findings.push(finding("inertia.order", Severity::Suspect, body.link, body.place(1), message, rule));
        return;
    }
    let possible: Vec<&Order> =
        LISTS.iter().filter(|o| Moments::of(&o.applied(&body.written)).are_possible(slack(body))).collect();
    let Some(order) = possible.first() else { return };
    let [a, b, c] = Moments::of(&order.applied(&body.written)).values.map(|x| super::written::short(x, 4));
    let message = format!(
        "{}? This would make the tensor possible ({a}, {b}, {c} kg·m²), but no geometry confirms it",
        order.mistake
    );
    findings.push(finding("inertia.order", Severity::Suspect, body.link, body.tensor_place(), message, RULE));
}

fn slack(body: &Body) -> f64 {
    body.rounding.iter().fold(0.0, |max, h| f64::max(max, *h))
}
