//! Candidate errors of a tensor, and the criteria for their agreement with the geometry.
//!
//! An error is undone, and every element of the result is compared with the tensor of the uniform
//! geometry. The error explains the tensor if all elements agree, and if each changed element comes
//! at least five times closer to the geometry's. An element that already agrees is therefore never
//! changed.

use super::body::{Body, NAMES};
use super::written::{negated, restyled, shifted, short};
use crate::geometry::Volume;
use crate::model::Span;
use crate::moments::{Elements, difference, norm, trace};

/// Tolerance relative to each element, for errors that keep the digits. Screws, holes and cables
/// are not drawn.
pub(super) const LOOSE: f64 = 0.03;

/// Tolerance for errors explained by a formula or by a factor such as the mass. These agree to all
/// digits, or by chance.
pub(super) const TIGHT: f64 = 0.002;

/// Relative difference of the moments below which a tensor counts as isotropic. It then has only
/// one number, which agrees by chance more often than six.
const ISOTROPIC: f64 = 0.05;

/// Upper limit on the rounding error of the digits, relative to an element.
const ROUNDING: f64 = 0.01;

/// Required improvement of a changed element: its deviation as written, divided by the deviation
/// after the change. Smaller improvements may be chance.
pub(super) const BETTER: f64 = 5.0;

/// Required improvement of the tensor as a whole.
const BETTER_IN_ALL: f64 = 1.5;

/// Required deviation of a written element, as a multiple of its rounding error.
const BEYOND_ROUNDING: f64 = 3.0;

/// Relative difference below which two tensors are equal.
pub(super) const SAME: f64 = 1e-3;

/// Correction of an element, relative to the written value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Change {
    Keep,
    /// The written value times 10^k, with its digits.
    Shift(i32),
    Scale(f64),
    Negate,
    /// The value written for another element; with the opposite sign if the flag is true.
    Take(usize, bool),
    /// The geometry's value. A wrong formula gives the number stored here, which must equal the
    /// written value.
    Formula(f64),
    /// Value computed from all elements.
    Value(f64),
}

/// Error of a tensor: its rule, description and position.
#[derive(Clone, Debug)]
pub(super) struct Slip {
    pub(super) code: &'static str,
    /// Description: `"the products have the other sign"`
    pub(super) mistake: String,
    pub(super) rule: &'static str,
    /// Position in the text.
    pub(super) span: Span,
    /// False if the correct numbers are ambiguous.
    pub(super) is_sure: bool,
}

/// Supposition about the geometry and the mass, under which the tensor is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Supposition {
    /// Factor applied to all sizes of the geometry.
    pub(super) scale: f64,
    /// Factor applied to the mass.
    pub(super) mass: f64,
}

impl Supposition {
    pub(super) const NONE: Self = Self { scale: 1.0, mass: 1.0 };

    /// Returns the number of suppositions that differ from 1.
    pub(super) fn count(&self) -> usize {
        usize::from(self.scale != 1.0) + usize::from(self.mass != 1.0)
    }
}

/// Explanation: a supposition, and an error of the tensor or none.
#[derive(Clone, Debug)]
pub(super) struct Fit {
    pub(super) supposition: Supposition,
    /// Misfit ‖I − I_shape‖ / ‖I_shape‖ with all errors undone.
    pub(super) misfit: f64,
    /// Misfit of the tensor as written.
    pub(super) as_written: f64,
    /// Ratio of the trace of the written tensor to that of the geometry's tensor.
    pub(super) ratio: f64,
    /// Corrected tensor, in the inertial's axes.
    pub(super) tensor: Elements,
    pub(super) slip: Option<Slip>,
    /// Edits that correct the tensor.
    pub(super) edits: Vec<(Span, String)>,
}

/// Errors that explain a body's tensor, compared with one solid.
#[derive(Debug)]
pub(super) struct Candidates<'b, 'm> {
    pub(super) body: &'b Body<'m>,
    pub(super) solid: &'b Volume,
    /// Supposed mass, kg.
    pub(super) mass: f64,
    supposition: Supposition,
    /// Tensor of the solid with this mass, in the inertial's axes.
    pub(super) target: Elements,
    /// Scale of each element, √(I_ii I_jj) of the solid; tolerances are relative to it.
    sizes: Elements,
    as_written: f64,
    pub(super) fits: Vec<Fit>,
}

impl<'b, 'm> Candidates<'b, 'm> {
    pub(super) fn of(body: &'b Body<'m>, solid: &'b Volume, supposition: Supposition) -> Self {
        let mass = supposition.mass * body.mass;
        let target = body.in_inertial_axes(&body.implied(solid, mass));
        let [xx, yy, zz, ..] = target;
        let sizes = [xx, yy, zz, (xx * yy).sqrt(), (xx * zz).sqrt(), (yy * zz).sqrt()];
        let as_written = norm(&difference(&body.written, &target)) / norm(&target);
        Self { body, solid, mass, supposition, target, sizes, as_written, fits: Vec::new() }
    }

    /// Returns true if the written element agrees with the solid's within a relative tolerance.
    pub(super) fn agrees(&self, k: usize, tolerance: f64) -> bool {
        let [written, target, size] = [self.body.written[k], self.target[k], self.sizes[k]];
        (written - target).abs() <= tolerance * size + self.rounding(k, 1.0)
    }

    /// Returns true if all written elements agree with the solid's within a relative tolerance.
    pub(super) fn all_agree(&self, tolerance: f64) -> bool {
        (0..6).all(|k| self.agrees(k, tolerance))
    }

    /// Returns the tolerance of errors that keep the digits.
    pub(super) fn loose(&self) -> f64 {
        let written = &self.body.written;
        let third = trace(written) / 3.0;
        let differences = norm(&difference(written, &[third, third, third, 0.0, 0.0, 0.0]));
        if differences <= ISOTROPIC * norm(written) { TIGHT } else { LOOSE }
    }

    /// Returns the mass-weighted second moments ∫x² dm of the solid, in the inertial's axes.
    pub(super) fn second_moments(&self) -> [f64; 3] {
        let [xx, yy, zz, ..] = self.target;
        [0.5 * (yy + zz - xx), 0.5 * (xx + zz - yy), 0.5 * (xx + yy - zz)]
    }

    /// Returns true if the products of the solid vanish, so that formulas for its moments hold in
    /// these axes.
    pub(super) fn is_aligned(&self) -> bool {
        (3..6).all(|k| self.target[k].abs() <= SAME * self.sizes[k])
    }

    /// Returns the rounding error of a written element that was multiplied by a factor.
    fn rounding(&self, k: usize, factor: f64) -> f64 {
        (self.body.rounding[k] * factor.abs()).min(ROUNDING * self.sizes[k])
    }

    /// Offers the written tensor as an explanation, if it agrees under the supposition.
    pub(super) fn offer_as_written(&mut self, tolerance: f64) {
        if self.all_agree(tolerance) {
            let tensor = self.body.written;
            self.push(tensor, None, Vec::new());
        }
    }

    /// Offers an error that these changes undo. `slip` is evaluated only if the error explains the
    /// tensor.
    pub(super) fn offer(&mut self, changes: [Change; 6], tolerance: f64, slip: impl FnOnce() -> Slip) {
        let body = self.body;
        let right = self.right(&changes);
        let mut is_better = false;
        for k in 0..6 {
            let [was, left] = [body.written[k], right[k]].map(|x| (x - self.target[k]).abs());
            let factor = match changes[k] {
                Change::Shift(power) => 10_f64.powi(power),
                Change::Scale(factor) => factor,
                _ => 1.0,
            };
            let noise = SAME * self.sizes[k];
            // The negated comparison also rejects NaN.
            if !(left <= tolerance * self.sizes[k] + self.rounding(k, factor)) {
                return;
            }
            if right[k] == body.written[k] {
                continue;
            }
            let better = BETTER * left <= was && was > BEYOND_ROUNDING * self.rounding(k, 1.0);
            is_better |= better && was > noise;
            let is_neutral = was <= noise && left <= noise;
            if !(better || is_neutral) {
                return;
            }
        }
        let off = f64::max(SAME, BEYOND_ROUNDING * norm(&body.rounding) / norm(&body.written));
        let misfit = norm(&difference(&right, &self.target)) / norm(&self.target);
        // If the other elements deviate as much, the changed ones are not evidence.
        if is_better && self.as_written > off.max(BETTER_IN_ALL * misfit) {
            let slip = slip();
            let edits = if slip.is_sure { self.edits(&changes) } else { Vec::new() };
            self.push(right, Some(slip), edits);
        }
    }

    fn push(&mut self, tensor: Elements, slip: Option<Slip>, edits: Vec<(Span, String)>) {
        let misfit = norm(&difference(&tensor, &self.target)) / norm(&self.target);
        let Self { supposition, as_written, .. } = *self;
        let ratio = trace(&self.body.written) / trace(&self.target);
        self.fits.push(Fit { supposition, misfit, as_written, ratio, tensor, slip, edits });
    }

    fn right(&self, changes: &[Change; 6]) -> Elements {
        let written = &self.body.written;
        std::array::from_fn(|k| match changes[k] {
            Change::Keep => written[k],
            // A written zero is zero in every unit.
            Change::Shift(_) | Change::Scale(_) | Change::Negate if written[k] == 0.0 => 0.0,
            Change::Shift(power) => written[k] * 10_f64.powi(power),
            Change::Scale(factor) => written[k] * factor,
            Change::Negate => -written[k],
            Change::Take(from, negates) => written[from] * if negates { -1.0 } else { 1.0 },
            Change::Formula(wrong) => self.target[k] + (written[k] - wrong),
            Change::Value(right) => right,
        })
    }

    /// Returns the edits for the changes; empty if an element that changes has no text.
    fn edits(&self, changes: &[Change; 6]) -> Vec<(Span, String)> {
        let body = self.body;
        let right = self.right(changes);
        let texts: Vec<&str> = body.numbers().map(|(_, number)| number.text.as_str()).collect();
        // The text of a zero has no style; the longest text provides it.
        let longest = texts.iter().copied().max_by_key(|text| text.len()).unwrap_or("");
        let mut edits = Vec::new();
        let mut changed = (0..6).filter(|k| right[*k] != body.written[*k]).count();
        for (k, number) in body.numbers() {
            if right[k] == body.written[k] {
                continue;
            }
            changed -= 1;
            let old = number.text.as_str();
            let style = if body.written[k] == 0.0 { longest } else { old };
            let text = match changes[k] {
                Change::Keep => continue,
                Change::Shift(power) => shifted(old, power),
                Change::Negate => Some(negated(old)),
                Change::Take(from, negates) => {
                    texts.get(from).map(|text| if negates { negated(text) } else { (*text).to_owned() })
                }
                Change::Formula(_) => Some(restyled(self.target[k], style)),
                Change::Scale(_) | Change::Value(_) => Some(restyled(right[k], style)),
            };
            let Some(text) = text else { return Vec::new() };
            edits.push((number.span.clone(), text));
        }
        if changed == 0 { edits } else { Vec::new() }
    }
}

/// Returns the changes in words: `"ixy 0.012 → -0.012, ixz …"`
pub(super) fn describe(body: &Body, edits: &[(Span, String)]) -> String {
    let changes: Vec<String> = body
        .numbers()
        .filter_map(|(k, number)| {
            let (_, text) = edits.iter().find(|(span, _)| *span == number.span)?;
            Some(format!("{} {} → {text}", NAMES[k], number.text))
        })
        .collect();
    changes.join(", ")
}

/// Returns a list of element names: `"ixx"`, `"ixx and iyy"`, `"ixx, iyy and izz"`
pub(super) fn named(elements: &[usize]) -> String {
    let names: Vec<&str> = elements.iter().filter_map(|k| NAMES.get(*k).copied()).collect();
    match names.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} and {last}", others.join(", ")),
        Some((last, _)) => (*last).to_owned(),
        None => String::new(),
    }
}

/// Describes the error corrected by a power of ten: `"10 times too large"`, `"10^6 times too
/// small"`.
pub(super) fn times_too(power: i32) -> String {
    let times = match power.unsigned_abs() {
        few @ ..=4 => 10_u32.pow(few).to_string(),
        many => format!("10^{many}"),
    };
    format!("{times} times too {}", if power < 0 { "large" } else { "small" })
}

/// Describes a misfit: `"29 % off the geometry's tensor"`, or for large ratios `"711 times the
/// geometry's tensor"`.
pub(super) fn compared(misfit: f64, ratio: f64) -> String {
    let is_far = ratio > 0.0 && !(0.5..=2.0).contains(&ratio);
    let off = if is_far { format!("{} times", short(ratio, 3)) } else { format!("{} off", percent(misfit)) };
    format!("{off} the geometry's tensor")
}

/// Formats a misfit in per cent; values at rounding level become 0.
pub(super) fn percent(misfit: f64) -> String {
    if misfit < 1e-6 { "0 %".to_owned() } else { format!("{} %", short(100.0 * misfit, 2)) }
}
