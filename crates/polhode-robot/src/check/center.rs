//! Checks that the centre of mass is inside the convex hull of the link's geometry:
//! `mass.center_outside`.
//!
//! The centre of mass is a mean of the body's points. It therefore lies in the convex hull of any
//! geometry that contains the body. For that geometry this is as strict as the triangle inequality.
//! A link may have parts that are not drawn, so the finding is only suspect. The proof is a plane
//! that separates the centre from all shapes (`geometry/separation.rs`).

use super::body::Body;
use super::center_slip;
use super::dummy::{FRAME, Held};
use super::finding;
use super::written::short;
use crate::finding::{Finding, Severity};
use crate::model::RobotModel;

/// Tolerance relative to the diagonal of the geometry's bounds, for simplified meshes, parts that
/// are not drawn, and rounded coordinates. Measured centres of public robots are up to 1.9 %
/// outside the drawn meshes.
const ALLOWED: f64 = 0.02;

pub(super) fn check(model: &RobotModel, body: &Body, held: Held, findings: &mut Vec<Finding>) {
    let (Some(distance), Some([low, high])) = (body.geometry.outside, body.geometry.bounds) else { return };
    // An implausible density makes the geometry itself doubtful.
    if !(body.mass > 0.0) || !body.has_plausible_density() {
        return;
    }
    let diagonal = (0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt();
    let allowed = ALLOWED * diagonal;
    if !(distance > allowed) {
        return;
    }
    let place = body.centre.map(|x| short(x, 4)).join(", ");
    let millimetres = short(1e3 * distance, 3);
    let (what, repair) = match center_slip::repair(model, body, diagonal) {
        Some((what, repair)) => (format!("; {what}"), Some(repair)),
        None => (String::new(), None),
    };
    let message = format!(
        "centre of mass ({place}) m: {millimetres} mm outside the convex hull of all shapes of the link{what}"
    );
    let is_frame = body.mass <= FRAME || held == Held::Dummy;
    let severity = if is_frame { Severity::Note } else { Severity::Suspect };
    let span = body.inertial.pose.span.clone().unwrap_or(body.inertial.span.clone());
    let rule = "the centre of mass lies in the convex hull of the link's geometry";
    let mut found = finding("mass.center_outside", severity, body.link, span, message, rule);
    found.numbers = vec![("distance", distance), ("allowed", allowed)];
    found.repair = repair;
    findings.push(found);
}
