//! Mistakes that may explain a tensor, and which of them fits best.

use super::body::Body;
use super::finding;
use super::written::short;
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

/// A mistake.
#[derive(Debug)]
pub(super) struct Explanation {
    pub(super) code: &'static str,
    /// `"the products have the other sign"`
    pub(super) mistake: String,
    pub(super) rule: &'static str,
    /// Where.
    pub(super) span: Span,
    /// The text without the mistake, where that is only numbers.
    pub(super) edits: Vec<(Span, String)>,
}

/// The mistakes that explain a body's tensor.
#[derive(Debug)]
pub(super) struct Candidates<'b, 'm> {
    pub(super) body: &'b Body<'m>,
    as_written: f64,
    /// Misfit and tensor without the mistake.
    fits: Vec<(f64, Elements, Explanation)>,
}

impl<'b, 'm> Candidates<'b, 'm> {
    /// `None` if there is nothing to compare with, or nothing to explain.
    pub(super) fn of(body: &'b Body<'m>) -> Option<Self> {
        let as_written = body.misfit(&body.tensor)?;
        let rounding = norm(&body.rounding) / norm(&body.tensor).max(f64::MIN_POSITIVE);
        let off = as_written > f64::max(SAME, BEYOND_ROUNDING * rounding);
        off.then_some(Self { body, as_written, fits: Vec::new() })
    }

    /// A mistake that, undone, leaves this tensor along the link's axes. It is only written out if it fits.
    pub(super) fn offer(&mut self, tensor: Elements, mistake: impl FnOnce() -> Explanation) {
        let misfit = self.body.misfit(&tensor).unwrap_or(f64::INFINITY);
        if misfit <= FIT && BETTER * misfit <= self.as_written {
            self.fits.push((misfit, tensor, mistake()));
        }
    }

    /// The finding of the one that fits best; of equals, the first.
    pub(super) fn best(mut self) -> Option<Finding> {
        let body = self.body;
        let least = self.fits.iter().map(|(misfit, ..)| *misfit).min_by(f64::total_cmp)?;
        let simplest = self.fits.iter().position(|(misfit, ..)| *misfit <= 1.1 * least + SAME * FIT)?;
        let (misfit, tensor, chosen) = self.fits.remove(simplest);
        // Another that fits as well and means another tensor leaves the choice to a person.
        let other = self.fits.iter().any(|(m, t, _)| {
            *m <= BETTER * f64::max(least, SAME) && norm(&difference(t, &tensor)) > SAME * norm(&tensor)
        });
        let [off, left] = [self.as_written, misfit].map(|x| short(100.0 * x, 2));
        let message = format!(
            "{}: as written it is {off} % from its geometry's tensor, without that mistake {left} %",
            chosen.mistake
        );
        let mut found = finding(chosen.code, Severity::Suspect, body.link, chosen.span, message, chosen.rule);
        found.numbers = vec![("misfit", self.as_written), ("misfit_repaired", misfit)];
        if !other && !chosen.edits.is_empty() {
            let description = describe(body, &chosen.edits);
            found.repair = Some(Repair { description, edits: chosen.edits });
        }
        Some(found)
    }
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
