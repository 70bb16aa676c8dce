//! Error bounds of a mesh body whose holes were closed.

use polhode::body::mesh::{MassBound, MeshHole, MomentBound, UncertainPart};
use polhode::body::shape::Substance;
use polhode::body::{BodyError, Finding, MassProperties};
use polhode::math::Body;
use polhode_document::{Extra, SourceInfo};

use super::choice::PartSubstance;
use super::mesh_error::MeshBodyError;
use crate::mesh::{MeshClosure, MeshPart, MeshRepair, MeshSolid, RepairBound, Share, UnboundedClosure};
use crate::report::{PartRow, mass_bound};

/// Uncertain volume of the solids of a mesh, m³.
pub(super) struct Uncertain {
    /// Holes of each solid, m.
    holes: Vec<Vec<MeshHole>>,
    /// Bound of the error of the volume by closing alone, m³.
    closed: f64,
    /// Bound of the error of the volume by closing and all repairs, m³.
    volume: f64,
    /// The same relative to the volume.
    share: f64,
    /// Bound of the repairs before closing.
    repaired: RepairBound,
    /// Corners of the solids, m.
    corners: Vec<[f64; 3]>,
    closure: MeshClosure,
}

impl Uncertain {
    /// Returns the uncertain volume of a solid whose holes were closed, `None` without holes; adds
    /// a finding. `capped` are the parts, and `closure` their holes, in the file's unit.
    ///
    /// # Errors
    /// [`MeshBodyError::Unbounded`] if a cap intersects the mesh, or if the uncertain share of the
    /// volume is above `most`.
    pub(super) fn of(
        solid: &MeshSolid,
        capped: &[MeshPart],
        closure: MeshClosure,
        repairs: &[MeshRepair],
        most: Share,
        (findings, file): (&mut Vec<Finding>, &str),
    ) -> Result<Option<Self>, MeshBodyError> {
        let (closure, repaired) = (closure.scaled(solid.unit), RepairBound::of(repairs));
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
        findings.push(closure.finding(share, file));
        if closure.is_empty() {
            return Ok(None);
        }
        let surfaces = solid.parts.iter().map(|part| part.mesh.surface().coordinates());
        Ok(Some(Self {
            holes: closure.holes_of(solid.parts.len()),
            closed,
            volume: share * whole,
            share,
            repaired,
            corners: surfaces.flatten().copied().collect(),
            closure,
        }))
    }

    /// Adds the closed holes to the source of a report.
    pub(super) fn stated(&self, source: SourceInfo) -> SourceInfo {
        let (name, value) = self.closure.for_programs(self.closed);
        source.with(name, value).with("volume_bound_m3", self.volume)
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
        let bound = mass_bounds(rows, parts, common, |k, center| {
            let distance = |p: &[f64; 3]| (0..3).map(|k| (p[k] - center[k]).powi(2)).sum::<f64>().sqrt();
            let reach = self.corners.iter().map(distance).fold(0.0, f64::max) + self.repaired.beyond;
            // The repairs may have changed any of the parts.
            let repaired = MomentBound::within(self.repaired.volume, reach);
            let density = rows[k].volume.map_or(0.0, |volume| rows[k].properties.mass() / volume);
            let mut holes = self.holes[k].iter().map(|hole| hole.bound(center));
            let all = holes.try_fold(repaired, |all, bound| Ok::<_, BodyError>(all + bound?))?;
            Ok(all * density)
        })?;
        let proviso = "if the missing surfaces lie within the convex hulls of their holes";
        Ok(mass_bound(&bound, self.volume, self.share, proviso))
    }
}

/// Returns the error bounds of parts with their masses. `bound_of` returns the bounds of the
/// uncertain moments of a part about a point; `common` is the substance of the parts without their
/// own.
///
/// # Errors
/// [`MeshBodyError`] if the uncertain mass is not smaller than the mass.
pub(super) fn mass_bounds(
    rows: &[PartRow],
    parts: &[PartSubstance],
    common: Option<Substance>,
    bound_of: impl Fn(usize, [f64; 3]) -> Result<MomentBound, BodyError>,
) -> Result<MassBound, MeshBodyError> {
    let whole = combined(rows)?;
    let center = whole.center_of_mass().to_array();
    let own = |row: &PartRow| parts.iter().find(|given| given.name == row.name).map(|given| given.substance);
    let (mut uncertain, mut rest, mut of_rest) = (Vec::new(), Vec::new(), MomentBound::default());
    for (k, row) in rows.iter().enumerate() {
        let bound = bound_of(k, center)?;
        let substance = own(row);
        if substance.is_none() && matches!(common, Some(Substance::Mass(_))) {
            // The parts without their own substance share one mass at a common density.
            rest.push(row.clone());
            of_rest = of_rest + bound;
            continue;
        }
        let has_mass = matches!(substance, Some(Substance::Mass(_)));
        uncertain.push(UncertainPart { properties: row.properties, bound, has_mass });
    }
    if !rest.is_empty() {
        uncertain.push(UncertainPart { properties: combined(&rest)?, bound: of_rest, has_mass: true });
    }
    MassBound::of(&whole, &uncertain).ok_or(MeshBodyError::AllUncertain)
}

fn combined(rows: &[PartRow]) -> Result<MassProperties<Body>, BodyError> {
    match rows {
        [only] => Ok(only.properties),
        _ => MassProperties::combined(&rows.iter().map(|row| row.properties).collect::<Vec<_>>()),
    }
}
