//! Possible tensors nearest to an impossible one, as proposals.
//!
//! The elements are along the inertial's axes and about the centre of mass, as in the model. Mass
//! and centre of mass stay as they are: they do not decide whether a tensor about the centre of
//! mass is possible.

use polhode::body::{InertiaTensor, Nearest, nearest_possible};
use polhode::math::Body as BodyAxes;

use super::body::{Body, NAMES};
use super::explanation::percent;
use super::written::short;
use crate::finding::{NearestTensor, Proposal};
use crate::moments::{Elements, Moments, elements, matrix, norm};

/// Significant digits of a proposed element.
const DIGITS: usize = 6;

/// Element below which a product is rounding noise, relative to the largest element.
const NOISE: f64 = 64.0 * f64::EPSILON;

/// Moment below which a proposed body is a rod, relative to the largest moment.
const ROD: f64 = 1e-12;

/// Proposes the possible tensors nearest to the body's, if they can be computed; none without the
/// feature `languages`.
pub(super) fn of(body: &Body) -> Option<Proposal> {
    if !cfg!(feature = "languages") {
        return None;
    }
    let nearest = nearest_possible(matrix(&body.written)).ok()?;
    let proposed = |nearest: Nearest| {
        let exact = elements(&nearest.tensor.matrix());
        Some((possible_when_rounded(&exact)?, body_of(&exact), nearest.distance))
    };
    let (tensor, form, distance) = proposed(nearest.frobenius)?;
    let share = percent(distance / norm(&body.written));
    let frobenius =
        described(tensor, distance, &format!("{form}; distance {} kg·m² ({share})", short(distance, 3)));
    let affine_invariant = match nearest.affine_invariant {
        Some(nearest) => {
            let (tensor, form, distance) = proposed(nearest)?;
            Ok(described(tensor, distance, &format!("{form}; distance {}", short(distance, 3))))
        }
        None => Err(not_positive(&body.moments)),
    };
    Some(Proposal { frobenius: Ok(frobenius), affine_invariant })
}

/// Returns the proposal for a tensor with an element that cannot be read.
pub(super) fn unreadable() -> Proposal {
    let why = || Err("none: an element of the tensor cannot be read".to_owned());
    Proposal { frobenius: why(), affine_invariant: why() }
}

fn described(tensor: Elements, distance: f64, rest: &str) -> NearestTensor {
    let list: Vec<String> =
        NAMES.iter().zip(tensor).map(|(name, x)| format!("{name} {}", short(x, DIGITS))).collect();
    NearestTensor { description: format!("{} kg·m², {rest}", list.join(", ")), tensor, distance }
}

/// Returns the reason why no possible tensor is at a finite affine-invariant distance.
fn not_positive(moments: &Moments) -> String {
    let [i1, i2, i3] = moments.values;
    if i1 > 0.0 {
        return "none: principal moment i1 is zero within rounding".to_owned();
    }
    let which = match (i2 > 0.0, i3 > 0.0) {
        (true, _) => "moment i1 is",
        (false, true) => "moments i1 and i2 are",
        (false, false) => "moments i1, i2 and i3 are",
    };
    format!("none: principal {which} not positive")
}

/// Returns the body that has a tensor on the boundary of the possible ones.
fn body_of(tensor: &Elements) -> &'static str {
    match Moments::of(tensor).values {
        [_, _, i3] if i3 <= 0.0 => "a point",
        [i1, _, i3] if i1 <= ROD * i3 => "a thin rod",
        _ => "a flat body",
    }
}

/// Returns a tensor rounded to six digits that is itself possible.
///
/// Rounding may leave the possible tensors. Then the two smaller principal moments are raised by
/// the norm of the rounding errors, and twice as much each time until the rounded tensor is
/// possible.
fn possible_when_rounded(exact: &Elements) -> Option<Elements> {
    let rounded = |x: f64| short(x, DIGITS).parse::<f64>().ok();
    let largest = exact.iter().fold(0.0, |max, x| f64::max(max, x.abs()));
    let mut raise = 0.0;
    let Moments { axes: [first, second, _], .. } = Moments::of(exact);
    for _ in 0..40 {
        let mut tensor = [0.0; 6];
        let mut error: f64 = 0.0;
        for (k, (i, j)) in crate::moments::PLACES.into_iter().enumerate() {
            let raised = exact[k] + raise * (first[i] * first[j] + second[i] * second[j]);
            let is_noise = k >= 3 && raised.abs() <= NOISE * largest;
            tensor[k] = if is_noise { 0.0 } else { rounded(raised)? };
            error = error.hypot(tensor[k] - raised);
        }
        if InertiaTensor::<BodyAxes>::from_matrix(matrix(&tensor)).is_ok() {
            return Some(tensor);
        }
        raise = f64::max(2.0 * raise, error);
    }
    None
}
