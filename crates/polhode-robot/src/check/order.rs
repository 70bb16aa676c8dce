//! Six right numbers in the wrong places: `inertia.order`.
//!
//! There are three lists of the six elements: diagonal first (xx yy zz xy xz yz, as MJCF's `fullinertia`), the upper
//! triangle by rows (xx xy xz yy yz zz, as URDF and SDF name them), and the lower triangle by rows (xx xy yy xz yz zz).
//! One read as another puts products where moments belong, which mostly is impossible. Nine numbers by rows
//! (xx xy xz yx yy yz …), cut at six, betray themselves by xy = yx in two places; zz is lost then. The products
//! alone may be exchanged, too (xy yz xz, or yz xz xy as engineers number stresses), and the moments of a body
//! without products (a cylinder along another axis): only the geometry can tell that.

use super::body::Body;
use super::explanation::{Candidates, Explanation, edits};
use super::finding;
use crate::finding::{Finding, Repair, Severity};
use crate::model::Tensor;
use crate::moments::{Elements, Moments};

/// `right[k] = written[from[k]]`
struct Order {
    mistake: &'static str,
    from: [usize; 6],
}

const LISTS: [Order; 4] = [
    Order {
        mistake: "xx yy zz xy xz yz written in the places of xx xy xz yy yz zz",
        from: [0, 3, 4, 1, 5, 2],
    },
    Order {
        mistake: "row-major xx xy xz yy yz zz written in the places of xx yy zz xy xz yz",
        from: [0, 3, 5, 1, 2, 4],
    },
    Order {
        mistake: "the lower triangle xx xy yy xz yz zz written in the places of xx xy xz yy yz zz",
        from: [0, 4, 2, 3, 1, 5],
    },
    Order {
        mistake: "the lower triangle xx xy yy xz yz zz written in the places of xx yy zz xy xz yz",
        from: [0, 2, 5, 1, 3, 4],
    },
];

const PRODUCTS: [Order; 5] = [
    Order { mistake: "iyz and ixz exchanged", from: [0, 1, 2, 3, 5, 4] },
    Order { mistake: "ixy and iyz exchanged", from: [0, 1, 2, 5, 4, 3] },
    Order { mistake: "ixy and ixz exchanged", from: [0, 1, 2, 4, 3, 5] },
    Order { mistake: "products in the order xz yz xy", from: [0, 1, 2, 5, 3, 4] },
    Order { mistake: "products in the order yz xy xz", from: [0, 1, 2, 4, 5, 3] },
];

const MOMENTS: [Order; 5] = [
    Order { mistake: "ixx and iyy exchanged", from: [1, 0, 2, 3, 4, 5] },
    Order { mistake: "ixx and izz exchanged", from: [2, 1, 0, 3, 4, 5] },
    Order { mistake: "iyy and izz exchanged", from: [0, 2, 1, 3, 4, 5] },
    Order { mistake: "moments in the order zz xx yy", from: [1, 2, 0, 3, 4, 5] },
    Order { mistake: "moments in the order yy zz xx", from: [2, 0, 1, 3, 4, 5] },
];

const RULE: &str = "URDF and SDF name each element; MJCF's fullinertia is xx yy zz xy xz yz";

/// What an order may explain of a tensor that is possible, but not its geometry's.
pub(super) fn explain(candidates: &mut Candidates) {
    let body = candidates.body;
    let bare = body.written[3..].iter().all(|x| *x == 0.0);
    let full = matches!(body.inertial.tensor, Tensor::Six(_)) && !bare;
    for order in LISTS.iter().chain(&PRODUCTS).filter(|_| full).chain(MOMENTS.iter().filter(|_| bare)) {
        candidates.offer(body.in_link_axes(&right(body, order)), || explanation(body, order));
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
        "{}: the tensor is possible so ({a}, {b}, {c} kg·m²), and impossible as written",
        order.mistake
    );
    let mut found =
        finding("inertia.order", Severity::Suspect, body.link, body.tensor_place(), message, RULE);
    // Without a shape that agrees it is a proof only if there is no shape to ask, and no other order does.
    if possible.len() == 1 && body.solids().next().is_none() {
        let edits = explanation(body, order).edits;
        found.repair = Some(Repair { description: super::explanation::describe(body, &edits), edits });
    }
    findings.push(found);
}

fn slack(body: &Body) -> f64 {
    body.rounding.iter().fold(0.0, |max, h| f64::max(max, *h))
}

fn right(body: &Body, order: &Order) -> Elements {
    order.from.map(|k| body.written[k])
}

fn explanation(body: &Body, order: &Order) -> Explanation {
    let texts: Vec<&str> = body.numbers().map(|(_, n)| n.text.as_str()).collect();
    Explanation {
        code: "inertia.order",
        mistake: order.mistake.to_owned(),
        rule: RULE,
        span: body.tensor_place(),
        edits: edits(body, |k, _| texts.get(*order.from.get(k)?).map(|t| (*t).to_owned())),
    }
}
