//! A tensor about the link's origin instead of the centre of mass: `inertia.about_origin`.
//!
//!   I_centre = I_origin − m (c² 1 − c cᵀ)
//!
//! CAD programs print both, one below the other. The centre c is the file's; if the file leaves it at the origin, the
//! geometry's.

use super::body::Body;
use super::explanation::{Candidates, Explanation, edits};
use super::written::{restyled, short};
use crate::model::Tensor;
use crate::moments::{Elements, difference, parallel_axes};

const RULE: &str = "an inertial's tensor is about its own origin, the centre of mass";

pub(super) fn explain(candidates: &mut Candidates) {
    let body = candidates.body;
    let explanation = |mistake, edits| Explanation {
        code: "inertia.about_origin",
        mistake,
        rule: RULE,
        span: body.tensor_place(),
        edits,
    };
    if body.centre != [0.0; 3] {
        let tensor = difference(&body.tensor, &parallel_axes(body.mass, body.centre));
        candidates.offer(tensor, || {
            let away = length(body.centre);
            let mistake = format!("tensor about the link's origin, {away} m from the centre of mass");
            explanation(mistake, texts(body, &body.in_inertial_axes(&tensor)))
        });
        return;
    }
    for solid in body.solids() {
        candidates.offer(difference(&body.tensor, &parallel_axes(body.mass, solid.centroid)), || {
            let away = length(solid.centroid);
            let mistake = format!(
                "tensor about the link's origin, and no centre of mass given; the geometry's is {away} m from there"
            );
            explanation(mistake, Vec::new())
        });
    }
}

fn length(v: [f64; 3]) -> String {
    short(v.iter().map(|x| x * x).sum::<f64>().sqrt(), 4)
}

/// The six numbers about the centre; none if the language has no place for products.
fn texts(body: &Body, right: &Elements) -> Vec<(crate::model::Span, String)> {
    if !matches!(body.inertial.tensor, Tensor::Six(_)) {
        return Vec::new();
    }
    // A zero's text has no style: the longest text's then.
    let style = body.numbers().map(|(_, n)| n.text.as_str()).max_by_key(|t| t.len()).unwrap_or("");
    edits(body, |k, text| {
        let style = if body.written[k] == 0.0 { style } else { text };
        Some(if right[k] == body.written[k] { text.to_owned() } else { restyled(right[k], style) })
    })
}
