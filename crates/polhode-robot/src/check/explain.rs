//! Which known mistake turns the geometry's tensor into the one that is written?
//!
//! Each mistake (`check/explanation.rs`) is undone in turn, and what is left is compared with the tensor that the link's shapes would have at
//! its mass, uniform. The misfit is ‖I − I_shape‖ / ‖I_shape‖ over all nine elements.

use super::body::Body;
use super::explanation::Candidates;
use super::{conjugate, order, origin, sign, unit};
use crate::finding::Finding;

/// The mistake that explains why the tensor is not its geometry's, if one does.
pub(super) fn check(body: &Body, findings: &mut Vec<Finding>) {
    let Some(mut candidates) = Candidates::of(body) else { return };
    unit::explain(&mut candidates);
    if body.geometry.is_turned_by_some {
        // Axes that programs disagree on neither accuse nor repair.
        findings.extend(candidates.best().map(|found| Finding { repair: None, ..found }));
        return;
    }
    order::explain(&mut candidates);
    sign::explain(&mut candidates);
    origin::explain(&mut candidates);
    conjugate::explain(&mut candidates);
    findings.extend(candidates.best());
}
