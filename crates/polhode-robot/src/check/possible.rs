//! Physical consistency of a tensor: `inertia.negative`, `inertia.triangle`, `inertia.zero`, and
//! the note `inertia.rounding`.
//!
//! A tensor is possible if no principal moment is negative and i1 + i2 ≥ i3. Both conditions state
//! that a matrix has no negative eigenvalue: I itself, and C = ½ tr(I) 1 − I, the matrix of second
//! moments. For the axis v of i3, i1 + i2 − i3 = 2 λ(C). The smallest eigenvalue is concave in the
//! elements. If the element I_ij may be off by h_ij, no choice within these bounds lifts it above
//!
//!   λ + Σ |v_i v_j| h_ij   (for I),    λ + Σ |½ δ_ij − v_i v_j| h_ij   (for C; h of the diagonal also
//!   enters the trace).
//!
//! If this bound is negative, the tensor is certainly impossible, however the digits were rounded.

use super::body::Body;
use super::written::short;
use super::{finding, nearest, power};
use crate::finding::{Finding, Severity};
use crate::model::{Inertial, Link, Slot};
use crate::moments::Elements;

/// Maximum violation attributed to rounding of the digits, relative to i3: half a unit of the
/// second digit in each number, as in 1.0 + 1.0 < 2.1. A number of one digit was typed and is
/// exact: diag(1, 1, 3) is impossible.
pub(super) const TYPED: f64 = 0.08;

/// Violation of i1 + i2 = i3 for a flat plate by single precision, relative to i3, whatever the
/// number of printed digits.
const SINGLE_PRECISION: f64 = 1e-6;

/// Radius of gyration below which a body is a point, m; smaller than an atom. Programs print values
/// such as 1e-35 kg·m² for zero.
const POINT: f64 = 1e-10;

/// Verdict on a link's mass and tensor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Verdict {
    /// Physical tensor and positive mass; it can be compared with the geometry.
    Possible,
    /// Tensor that no rigid body can have.
    Impossible,
    /// Zero mass or zero tensor; reported separately.
    Nothing,
}

/// Reports the errors of a tensor, independently of the mass. `carried`: the link is fixed to
/// another link.
pub(super) fn check(body: &Body, carried: bool, findings: &mut Vec<Finding>) -> Verdict {
    let weighs = body.mass > 0.0;
    let nothing = if weighs { body.mass * POINT * POINT } else { 0.0 };
    if body.written.iter().all(|x| x.abs() <= nothing) {
        if weighs {
            zero(body, carried, findings);
        }
        return Verdict::Nothing;
    }
    let [i1, i2, i3] = body.moments.values;
    let negative = slack(body, body.moments.axes[0], 0.0);
    let triangle = slack(body, body.moments.axes[2], 1.0);
    let gap = body.moments.triangle();
    if i1 < -negative {
        let [a, b, c] = [i1, i2, i3].map(|x| short(x, 5));
        let message = format!("principal moments {a}, {b}, {c} kg·m²: one is negative{}", beyond(body));
        let rule = "no principal moment is negative";
        let place = (0..3).find(|k| body.written[*k] < 0.0).map_or(body.tensor_place(), |k| body.place(k));
        let mut found = finding("inertia.negative", Severity::Impossible, body.link, place, message, rule);
        found.numbers = vec![("i1", i1), ("i2", i2), ("i3", i3), ("rounding", negative)];
        found.nearest = nearest::of(body);
        suggest(body, &mut found);
        findings.push(found);
        return Verdict::Impossible;
    }
    if gap < -triangle {
        // Enough digits to show the gap.
        let digits = (3.0 + (i3 / -gap).log10().ceil()).clamp(6.0, 17.0) as usize;
        let message = format!(
            "i1 + i2 = {} < i3 = {} kg·m² (by {}){}",
            short(i1 + i2, digits),
            short(i3, digits),
            short(-gap, 6),
            beyond(body),
        );
        let largest = (1..3).fold(0, |best, k| if body.written[k] > body.written[best] { k } else { best });
        let rule = "the sum of any two principal moments is at least the third";
        let mut found =
            finding("inertia.triangle", Severity::Impossible, body.link, body.place(largest), message, rule);
        found.numbers = vec![("i1", i1), ("i2", i2), ("i3", i3), ("excess", -gap), ("rounding", triangle)];
        found.nearest = nearest::of(body);
        suggest(body, &mut found);
        findings.push(found);
        return Verdict::Impossible;
    }
    let floor = SINGLE_PRECISION * i3;
    if gap < -floor || i1 < -floor {
        let message = format!(
            "i1 + i2 = {} < i3 = {} kg·m², within the rounding of the printed digits",
            short(i1 + i2, 6),
            short(i3, 6),
        );
        let rule = "more digits would show whether this tensor is possible";
        let mut found =
            finding("inertia.rounding", Severity::Note, body.link, body.tensor_place(), message, rule);
        found.numbers = vec![("i1", i1), ("i2", i2), ("i3", i3), ("excess", -gap), ("rounding", triangle)];
        findings.push(found);
    }
    if weighs { Verdict::Possible } else { Verdict::Nothing }
}

/// Checks the moments of a tensor that has an unreadable number elsewhere. They obey the same rules
/// in any axes.
pub(super) fn of_moments(link: &Link, inertial: &Inertial) -> Option<Finding> {
    let slots: Vec<&Slot> = inertial.tensor.slots()?.take(3).collect();
    let negative = slots.iter().find_map(|slot| slot.finite().filter(|x| *x < 0.0).map(|x| (slot.span(), x)));
    if let Some((span, moment)) = negative {
        let message = format!("a moment of {} kg·m²", short(moment, 5));
        let rule = "no moment of inertia is negative";
        let mut found = finding("inertia.negative", Severity::Impossible, link, span, message, rule);
        found.numbers = vec![("moment", moment)];
        found.nearest = Some(nearest::unreadable());
        return Some(found);
    }
    let moments: Vec<f64> = slots.iter().filter_map(|slot| slot.finite()).collect();
    let greatest = moments.iter().copied().fold(0.0, f64::max);
    let others = moments.iter().sum::<f64>() - greatest;
    if moments.len() < 3 || greatest - others <= TYPED * greatest {
        return None;
    }
    let message = format!(
        "the sum of two moments, {} kg·m², is less than the third, {} kg·m²",
        short(others, 6),
        short(greatest, 6)
    );
    let rule = "the sum of any two moments about perpendicular axes is at least the third";
    let span = slots.iter().find(|slot| slot.finite() == Some(greatest)).map(|slot| slot.span())?;
    let mut found = finding("inertia.triangle", Severity::Impossible, link, span, message, rule);
    found.numbers = vec![("excess", greatest - others)];
    found.nearest = Some(nearest::unreadable());
    Some(found)
}

/// Adds a suggestion to the message: a change that makes the tensor possible.
fn suggest(body: &Body, found: &mut Finding) {
    if let Some(suggestion) = power::suggestion(body) {
        found.message = format!("{}; {suggestion}", found.message);
    }
}

/// Returns the part of a negative λ(I), or of a negative i1 + i2 − i3 (`trace` = 1), that rounding
/// may explain; v is the axis.
fn slack(body: &Body, v: [f64; 3], trace: f64) -> f64 {
    let [xx, yy, zz, xy, xz, yz]: Elements = body.rounding;
    let [x, y, z] = v;
    // 2 λ(C) = tr(I) − 2 vᵀIv
    let factor = if trace > 0.0 { 2.0 } else { 1.0 };
    let diagonal: f64 =
        [(x, xx), (y, yy), (z, zz)].iter().map(|(c, h)| (trace - factor * c * c).abs() * h).sum();
    let products = 2.0 * factor * ((x * y).abs() * xy + (x * z).abs() * xz + (y * z).abs() * yz);
    let i3 = body.moments.values[2].abs().max(body.moments.values[0].abs());
    let digits = diagonal + products;
    SINGLE_PRECISION * i3 + if body.is_cut { digits } else { digits.min(TYPED * i3) }
}

/// Returns further evidence of an error: a radius of gyration beyond the geometry.
fn beyond(body: &Body) -> String {
    let (k, Some(reach)) = (body.gyration(), body.reach()) else { return String::new() };
    if !(k > reach) {
        return String::new();
    }
    let [k, m, reach] = [k, body.mass, reach].map(|x| short(x, 4));
    format!("; radius of gyration {k} m for {m} kg, but its geometry reaches only {reach} m")
}

/// Reports a point mass. Fixed to another body it is acceptable; alone it cannot rotate.
fn zero(body: &Body, carried: bool, findings: &mut Vec<Finding>) {
    let (severity, rule) = if carried || body.link.is_static {
        (
            Severity::Suspect,
            "only a point mass has no moment of inertia; a link fixed to another one may be a point mass",
        )
    } else {
        (Severity::Impossible, "a link with mass and a size has moments of inertia")
    };
    let exact = body.written.iter().all(|x| *x == 0.0);
    let zero = if exact { "zero" } else { "zero within rounding" };
    let message = format!("all moments are {zero}, but the mass is {} kg", short(body.mass, 6));
    let mut found = finding("inertia.zero", severity, body.link, body.tensor_place(), message, rule);
    found.numbers = vec![("mass", body.mass)];
    findings.push(found);
}
