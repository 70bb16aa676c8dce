//! Six right numbers in the wrong places: `inertia.order`.
//!
//! There are three lists of the six elements: diagonal first (xx yy zz xy xz yz, as MJCF's
//! `fullinertia`), the upper triangle by rows (xx xy xz yy yz zz, as URDF and SDF name them), and
//! the lower triangle by rows (xx xy yy xz yz zz). One read as another puts products where moments
//! belong, which mostly is impossible. Nine numbers by rows (xx xy xz yx yy yz …), cut at six,
//! betray themselves by xy = yx in two places; zz is lost then. The products alone may be
//! exchanged, too (xy yz xz, or yz xz xy as engineers number stresses), and the moments of a body
//! without products (a cylinder along another axis), or two axes with all that belongs to them (y
//! up for z up): only the geometry can tell that.

use super::body::Body;
use super::explanation::{Candidates, Change, LOOSE, Slip};
use super::finding;
use crate::finding::{Finding, Severity};
use crate::model::Tensor;
use crate::moments::{Elements, Moments};

/// `right[k] = ± written[from[k]]`
struct Order {
    mistake: &'static str,
    from: [usize; 6],
    /// True for elements that have the other sign, too.
    negated: [bool; 6],
}

const fn order(mistake: &'static str, from: [usize; 6]) -> Order {
    Order { mistake, from, negated: [false; 6] }
}

/// A quarter of a turn: two products change their signs.
const fn turn(mistake: &'static str, from: [usize; 6], negated: [usize; 2]) -> Order {
    let mut order = order(mistake, from);
    let [i, j] = negated;
    order.negated[i] = true;
    order.negated[j] = true;
    order
}

const LISTS: [Order; 4] = [
    order("xx yy zz xy xz yz written in the places of xx xy xz yy yz zz", [0, 3, 4, 1, 5, 2]),
    order("row-major xx xy xz yy yz zz written in the places of xx yy zz xy xz yz", [0, 3, 5, 1, 2, 4]),
    order(
        "the lower triangle xx xy yy xz yz zz written in the places of xx xy xz yy yz zz",
        [0, 4, 2, 3, 1, 5],
    ),
    order(
        "the lower triangle xx xy yy xz yz zz written in the places of xx yy zz xy xz yz",
        [0, 2, 5, 1, 3, 4],
    ),
];

const PRODUCTS: [Order; 5] = [
    order("iyz and ixz exchanged", [0, 1, 2, 3, 5, 4]),
    order("ixy and iyz exchanged", [0, 1, 2, 5, 4, 3]),
    order("ixy and ixz exchanged", [0, 1, 2, 4, 3, 5]),
    order("products in the order xz yz xy", [0, 1, 2, 5, 3, 4]),
    order("products in the order yz xy xz", [0, 1, 2, 4, 5, 3]),
];

const MOMENTS: [Order; 5] = [
    order("ixx and iyy exchanged", [1, 0, 2, 3, 4, 5]),
    order("ixx and izz exchanged", [2, 1, 0, 3, 4, 5]),
    order("iyy and izz exchanged", [0, 2, 1, 3, 4, 5]),
    order("moments in the order zz xx yy", [1, 2, 0, 3, 4, 5]),
    order("moments in the order yy zz xx", [2, 0, 1, 3, 4, 5]),
];

/// Axes exchanged with all that belongs to them. Frames of another handedness exchange two; a
/// quarter of a turn changes signs, too.
const AXES: [Order; 9] = [
    order("axes x and y exchanged", [1, 0, 2, 3, 5, 4]),
    order("axes x and z exchanged", [2, 1, 0, 5, 4, 3]),
    order("axes y and z exchanged", [0, 2, 1, 4, 3, 5]),
    turn("axes turned by a quarter about x", [0, 2, 1, 4, 3, 5], [3, 5]),
    turn("axes turned by a quarter about x", [0, 2, 1, 4, 3, 5], [4, 5]),
    turn("axes turned by a quarter about y", [2, 1, 0, 5, 4, 3], [3, 4]),
    turn("axes turned by a quarter about y", [2, 1, 0, 5, 4, 3], [4, 5]),
    turn("axes turned by a quarter about z", [1, 0, 2, 3, 5, 4], [3, 4]),
    turn("axes turned by a quarter about z", [1, 0, 2, 3, 5, 4], [3, 5]),
];

const RULE: &str = "URDF and SDF name each element; MJCF's fullinertia is xx yy zz xy xz yz";

/// What an order may explain of a tensor that is possible, but not its geometry's.
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

/// What an order may explain of a tensor that is impossible, and that no geometry explains.
pub(super) fn check_alone(body: &Body, findings: &mut Vec<Finding>) {
    if !matches!(body.inertial.tensor, Tensor::Six(_)) || body.written == [0.0; 6] {
        return;
    }
    let [ixx, iyy, _, ixy, ixz, iyz] = body.written;
    // Nine by rows in the places xx xy xz yy yz zz: yx is where iyy is, yy where iyz is. Products may be zero.
    let bare = [iyy, ixy, ixz] == [0.0; 3] && ixx > 0.0 && iyz > 0.0;
    if iyy == ixy && (iyy != 0.0 || bare) {
        let message = format!(
            "iyy = ixy = {iyy} kg·m²: xx xy xz yx yy yz, the first six of nine, in the places of six"
        );
        let rule = "a symmetric tensor has six numbers; zz is not among these";
        findings.push(finding("inertia.order", Severity::Suspect, body.link, body.place(1), message, rule));
        return;
    }
    let possible: Vec<&Order> =
        LISTS.iter().filter(|o| Moments::of(&right(body, o)).are_possible(slack(body))).collect();
    let Some(order) = possible.first() else { return };
    let [a, b, c] = Moments::of(&right(body, order)).values.map(|x| super::written::short(x, 4));
    let message = format!(
        "{}: that would make the tensor possible ({a}, {b}, {c} kg·m²), and no geometry confirms it",
        order.mistake
    );
    findings.push(finding("inertia.order", Severity::Suspect, body.link, body.tensor_place(), message, RULE));
}

fn slack(body: &Body) -> f64 {
    body.rounding.iter().fold(0.0, |max, h| f64::max(max, *h))
}

fn right(body: &Body, order: &Order) -> Elements {
    order.from.map(|k| body.written[k])
}
