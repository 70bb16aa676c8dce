//! Density bounds for comparing the mass with the geometry of a link.
//!
//! Foam has at least 10 kg/m³, osmium 22,590 kg/m³. Closed meshes follow the body closely, so these
//! bounds apply to them. Primitives and hulls represent a body roughly: an enclosing box has
//! several times its volume, a small cylinder for a motor only a part of it. For them the bounds
//! are widened by a factor of five on both sides.

use crate::geometry::VolumeKind;

/// Lowest density of a material, kg/m³.
pub(super) const LEAST: f64 = 10.0;

/// Highest density of a material, kg/m³.
const GREATEST: f64 = 25_000.0;

/// Factor by which the bounds are widened for primitives and hulls.
const CRUDE: f64 = 5.0;

/// Returns true if a material has this density, kg/m³.
pub(super) fn is_solid(density: f64) -> bool {
    (LEAST..=GREATEST).contains(&density)
}

/// Returns true if this density, kg/m³, is plausible for a solid of this kind.
pub(super) fn is_plausible(kind: VolumeKind, density: f64) -> bool {
    let slack = if kind == VolumeKind::Closed { 1.0 } else { CRUDE };
    density >= LEAST / slack && density <= GREATEST * slack
}
