//! Densities of materials, by which the mass and the geometry of a link are compared.
//!
//! Foam has 10 kg/m³ or more, osmium 22,590. Closed meshes are drawn after the body, so these bounds are theirs.
//! Primitives and hulls represent a body more or less well: a box around it is several times its volume, a small
//! cylinder for a motor a part of it; so they are given a factor of five on both sides.

use crate::geometry::VolumeKind;

/// Lowest density of a material, kg/m³.
pub(super) const LEAST: f64 = 10.0;

/// Highest density of a material, kg/m³.
const GREATEST: f64 = 25_000.0;

/// Factor that primitives and hulls are given.
const CRUDE: f64 = 5.0;

/// True if a material has this density, kg/m³.
pub(super) fn is_solid(density: f64) -> bool {
    (LEAST..=GREATEST).contains(&density)
}

/// True if a material may have this density, kg/m³, given how well such a solid represents the body.
pub(super) fn is_plausible(kind: VolumeKind, density: f64) -> bool {
    let slack = if kind == VolumeKind::Closed { 1.0 } else { CRUDE };
    density >= LEAST / slack && density <= GREATEST * slack
}
