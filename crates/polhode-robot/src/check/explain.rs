//! Which known mistake turns the geometry's tensor into the one that is written?
//!
//! Each mistake is undone in turn, and what is left is compared with the tensor that the link's shapes would have at
//! its mass, uniform. The misfit is ‖I − I_shape‖ / ‖I_shape‖ over all nine elements.

use super::body::Body;
use super::written::short;
use super::{conjugate, finding, order, origin, sign, unit};
use crate::finding::{Finding, Repair, Severity};
use crate::model::Span;
use crate::moments::{Elements, difference, norm};

/// A tensor that is its geometry's is within a few per cent: screws, holes and cables are not drawn.
pub(super) const FIT: f64 = 0.03;

/// What is written must be this many times farther off than with the mistake undone. Below it both may be chance.
const BETTER: f64 = 5.0;

/// What is written must be off by this many times what rounding of its digits explains.
const BEYOND_ROUNDING: f64 = 3.0;

/// Tensors this near to each other mean the same.
const SAME: f64 = 1e-3;

/// A mistake, undone.
#[derive(Debug)]
pub(super) struct Explanation {
    pub(super) code: &'static str,
    /// The mistake: `"the products have the other sign"`.
    pub(super) mistake: String,
    pub(super) rule: &'static str,
    /// Where.
    pub(super) span: Span,
    /// Without the mistake, along the link's axes.
    pub(super) tensor: Elements,
    /// The text without the mistake, where that is only numbers.
    pub(super) edits: Vec<(Span, String)>,
}

/// The mistake that explains why the tensor is not its geometry's, if one does.
pub(super) fn check(body: &Body, findings: &mut Vec<Finding>) {
    let Some(as_written) = body.misfit(&body.tensor) else { return };
    let mut explanations = Vec::new();
    unit::explain(body, &mut explanations);
    order::explain(body, &mut explanations);
    sign::explain(body, &mut explanations);
    origin::explain(body, &mut explanations);
    conjugate::explain(body, &mut explanations);
    findings.extend(best(body, as_written, explanations, Severity::Suspect));
}

/// The finding of the explanation that fits best, if it fits well enough.
pub(super) fn best(
    body: &Body,
    as_written: f64,
    explanations: Vec<Explanation>,
    severity: Severity,
) -> Option<Finding> {
    let rounding = norm(&body.rounding) / norm(&body.tensor).max(f64::MIN_POSITIVE);
    if as_written <= BEYOND_ROUNDING * rounding {
        return None;
    }
    let mut fits: Vec<(f64, Explanation)> = explanations
        .into_iter()
        .filter_map(|e| Some((body.misfit(&e.tensor)?, e)))
        .filter(|(misfit, _)| *misfit <= FIT && BETTER * misfit <= as_written)
        .collect();
    let least = fits.iter().map(|(misfit, _)| *misfit).min_by(f64::total_cmp)?;
    let simplest = fits.iter().position(|(misfit, _)| *misfit <= 1.1 * least + SAME * FIT)?;
    let (misfit, chosen) = fits.remove(simplest);
    // Another that fits as well and means another tensor leaves the choice to a person.
    let other = fits.iter().any(|(m, e)| {
        let apart = norm(&difference(&e.tensor, &chosen.tensor)) / norm(&chosen.tensor);
        *m <= BETTER * f64::max(least, 1e-3) && apart > SAME
    });
    let [off, left] = [as_written, misfit].map(|x| short(100.0 * x, 2));
    let message = format!(
        "{}: as written it is {off} % from its geometry's tensor, without that mistake {left} %",
        chosen.mistake
    );
    let mut found = finding(chosen.code, severity, body.link, chosen.span, message, chosen.rule);
    found.numbers = vec![("misfit", as_written), ("misfit_repaired", misfit)];
    if !other && !chosen.edits.is_empty() {
        let description = describe(body, &chosen.edits);
        found.repair = Some(Repair { description, edits: chosen.edits });
    }
    Some(found)
}

/// `"ixy 0.012 → -0.012, ixz …"`
pub(super) fn describe(body: &Body, edits: &[(Span, String)]) -> String {
    let changes: Vec<String> = body
        .numbers()
        .filter_map(|(k, number)| {
            let (_, text) = edits.iter().find(|(span, _)| *span == number.span)?;
            Some(format!("{} {} → {text}", super::body::NAMES[k], number.text))
        })
        .collect();
    changes.join(", ")
}

/// The edits that make the written numbers these texts, where they differ.
pub(super) fn edits(body: &Body, text: impl Fn(usize, &str) -> Option<String>) -> Vec<(Span, String)> {
    let mut edits = Vec::new();
    for (k, number) in body.numbers() {
        let Some(new) = text(k, &number.text) else { return Vec::new() };
        if new != number.text {
            edits.push((number.span.clone(), new));
        }
    }
    edits
}
