//! Error bounds of a mesh body whose holes were closed.

use polhode::body::mesh::{MassBound, MeshHole, MomentBound, UncertainPart};
use polhode::body::shape::Substance;
use polhode::body::{BodyError, MassProperties};
use polhode::math::Body;
use polhode_document::Extra;

use super::choice::PartSubstance;
use super::mesh_error::MeshBodyError;
use crate::mesh::{MeshClosure, MeshPart, MeshSolid, RepairBound, Share, UnboundedClosure};
use crate::report::{PartRow, mass_bound};

/// Uncertain volume of the solids of a mesh, m³.
pub(super) struct Uncertain {
    /// Holes of each solid, m.
    pub(super) holes: Vec<Vec<MeshHole>>,
    /// Bound of the error of the volume by closing alone, m³.
    pub(super) closed: f64,
    /// Bound of the error of the volume by closing and all repairs, m³.
    pub(super) volume: f64,
    /// The same relative to the volume.
    pub(super) share: f64,
    /// Bound of the repairs before closing.
    pub(super) repaired: RepairBound,
    /// Corners of the solids, m.
    pub(super) corners: Vec<[f64; 3]>,
}

impl Uncertain {
    /// Returns the uncertain volume of a solid whose holes were closed. `capped` are the parts in the
    /// file's unit; `closure` is in metres.
    ///
    /// # Errors
    /// [`MeshBodyError::Unbounded`] if a cap intersects the mesh, or if the uncertain share of the
    /// volume is above `most`.
    pub(super) fn of(
        solid: &MeshSolid,
        capped: &[MeshPart],
        closure: &MeshClosure,
        repaired: RepairBound,
        most: Share,
    ) -> Result<Self, MeshBodyError> {
        if let Some(point) = closure.crossing(capped, &solid.parts, solid.unit) {
            return Err(MeshBodyError::Unbounded(UnboundedClosure::Crossed { point }));
        }
        let whole: f64 = solid.parts.iter().map(|part| part.mesh.volume()).sum();
        let closed = closure.share(whole, 0.0) * whole;
        let share = closure.share(whole, repaired.volume);
        if share > most.value() && !closure.is_empty() {
            let repaired = repaired.volume > 0.0;
            return Err(MeshBodyError::Unbounded(closure.too_wide(share, most.value(), repaired)));
        }
        let surfaces = solid.parts.iter().map(|part| part.mesh.surface().coordinates());
        Ok(Self {
            holes: closure.holes_of(solid.parts.len()),
            closed,
            volume: share * whole,
            share,
            repaired,
            corners: surfaces.flatten().copied().collect(),
        })
    }

    /// Returns the block of error bounds for parts with their masses. `common` is the substance of
    /// the parts without their own.
    ///
    /// # Errors
    /// [`MeshBodyError`] if the uncertain mass is not smaller than the mass.
    pub(super) fn bounds(
        &self,
        rows: &[PartRow],
        parts: &[PartSubstance],
        common: Option<Substance>,
    ) -> Result<Extra, MeshBodyError> {
        let whole = combined(rows)?;
        let center = whole.center_of_mass().to_array();
        let distance = |p: &[f64; 3]| (0..3).map(|k| (p[k] - center[k]).powi(2)).sum::<f64>().sqrt();
        let reach = self.corners.iter().map(distance).fold(0.0, f64::max) + self.repaired.beyond;
        // The repairs may have changed any of the parts.
        let repaired = MomentBound::within(self.repaired.volume, reach);
        let bound_of = |k: usize| -> Result<MomentBound, BodyError> {
            let density = rows[k].volume.map_or(0.0, |volume| rows[k].properties.mass() / volume);
            let mut holes = self.holes[k].iter().map(|hole| hole.bound(center));
            let all = holes.try_fold(repaired, |all, bound| Ok::<_, BodyError>(all + bound?))?;
            Ok(all * density)
        };
        let own =
            |k: usize| parts.iter().find(|given| given.name == rows[k].name).map(|given| given.substance);
        let mut uncertain = Vec::new();
        let mut rest = Vec::new();
        for k in 0..rows.len() {
            let has_mass = match own(k) {
                None if matches!(common, Some(Substance::Mass(_))) => {
                    rest.push(k);
                    continue;
                }
                substance => matches!(substance, Some(Substance::Mass(_))),
            };
            uncertain.push(UncertainPart { properties: rows[k].properties, bound: bound_of(k)?, has_mass });
        }
        // The parts without their own substance share one mass at a common density.
        if !rest.is_empty() {
            let of_rest: Vec<_> = rest.iter().map(|&k| rows[k].clone()).collect();
            let mut bounds = rest.iter().map(|&k| bound_of(k));
            let bound =
                bounds.try_fold(MomentBound::default(), |all, bound| Ok::<_, BodyError>(all + bound?))?;
            uncertain.push(UncertainPart { properties: combined(&of_rest)?, bound, has_mass: true });
        }
        let bound = MassBound::of(&whole, &uncertain).ok_or(MeshBodyError::AllUncertain)?;
        let proviso = "if the missing surfaces lie within the convex hulls of their holes";
        Ok(mass_bound(&bound, self.volume, self.share, proviso))
    }
}

fn combined(rows: &[PartRow]) -> Result<MassProperties<Body>, BodyError> {
    match rows {
        [only] => Ok(only.properties),
        _ => MassProperties::combined(&rows.iter().map(|row| row.properties).collect::<Vec<_>>()),
    }
}
