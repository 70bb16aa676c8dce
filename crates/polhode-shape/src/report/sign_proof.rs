//! Proof of the sign of a report's products of inertia.

use polhode_document::Extra;
use polhode_document::layout::labelled;
use polhode_document::number::error;
use serde_json::json;

use crate::cad::SignProof;

/// Returns the block `products_of_inertia`: the sign convention of the products in a CAD report
/// (`negative` or `positive` integrals) and its proof. It contains the residuals of the report for
/// both signs, in units of its rounding, and the relative rounding.
pub fn sign_proof(proof: &SignProof) -> Extra {
    let (convention, by) = (proof.convention.name(), proof.by.name());
    let [negative, positive] = [proof.residual_negative, proof.residual_positive];
    let sign = if convention == "positive" { "+∫xy dm" } else { "-∫xy dm" };
    let mut text = labelled("products given", &format!("{sign}, by {by}"));
    if negative.is_finite() && positive.is_finite() {
        let residuals = format!(
            "residual {} as -∫xy dm, {} as +∫xy dm (in units of the rounding error)",
            error(negative),
            error(positive)
        );
        text.push_str(&labelled("", &residuals));
    }
    let json = json!({
        "given_as": format!("{convention}_integral"),
        "decided_by": by,
        "residual_negative": finite(negative),
        "residual_positive": finite(positive),
        "rounding": finite(proof.rounding),
    });
    Extra { key: "products_of_inertia", json, text }
}

fn finite(x: f64) -> Option<f64> {
    x.is_finite().then_some(x)
}
