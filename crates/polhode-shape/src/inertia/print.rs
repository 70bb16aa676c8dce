//! Mesh bodies that are printed with walls, solid layers and infill.

use polhode::body::mesh::{ClosedMesh, MeshInfill, PrintShell};
use polhode::body::shape::{Shape as _, Substance};
use polhode::body::{BodyError, MassProperties};
use polhode::math::Part;
use polhode_document::number::number;
use polhode_document::unit;
use polhode_document::{Extra, SourceInfo};
use serde_json::json;

use super::bounded::mass_bounds;
use super::choice::PartSubstance;
use super::mesh_error::MeshBodyError;
use crate::mesh::Fraction;
use crate::report::{PartRow, mass_bound};

/// Walls, solid layers and infill of a print.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Print {
    /// Walls along the surface, and solid layers at top and bottom.
    pub shell: PrintShell,
    /// Density of the infill relative to that of the walls.
    pub infill: Fraction,
}

/// Tolerance for the volume of the infill, relative to it.
const TOLERANCE: f64 = 1e-3;

/// Solid of a print with its infill.
pub(super) struct Printed {
    solid: ClosedMesh,
    infill: MeshInfill,
    fraction: f64,
}

impl Print {
    /// Computes the infill of a solid.
    pub(super) fn of(
        self,
        solid: ClosedMesh,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Printed, MeshBodyError> {
        let infill = solid.infill(&self.shell, TOLERANCE, goes_on).map_err(MeshBodyError::Print)?;
        Ok(Printed { solid, infill, fraction: self.infill.value() })
    }

    /// Returns walls, layers and infill in words.
    pub(super) fn in_words(self) -> String {
        let percent = number(100.0 * self.infill.value(), 6);
        let PrintShell { walls, top, bottom } = self.shell;
        let layers = match [top, bottom].map(unit::length) {
            [both, _] if top == bottom && top > 0.0 => format!(", layers of {both} at top and bottom"),
            [top, bottom] => [(self.shell.top, top, "top"), (self.shell.bottom, bottom, "bottom")]
                .into_iter()
                .filter(|(thickness, ..)| *thickness > 0.0)
                .map(|(_, length, place)| format!(", layers of {length} at the {place}"))
                .collect(),
        };
        format!("printed with walls of {}{layers} and an infill of {percent}%", unit::length(walls))
    }

    /// Adds walls and infill to the source of a report.
    pub(super) fn stated<'a>(
        self,
        source: SourceInfo,
        printed: impl Iterator<Item = &'a Printed> + Clone,
    ) -> SourceInfo {
        let volume: f64 = printed.clone().map(|part| part.infill.volume).sum();
        let bound: f64 = printed.map(|part| part.infill.bound.measure).sum();
        source.with(
            "print",
            json!({
                "walls_m": self.shell.walls,
                "top_layers_m": self.shell.top,
                "bottom_layers_m": self.shell.bottom,
                "infill": self.infill.value(),
                "infill_volume_m3": volume,
                "infill_bound_m3": bound,
            }),
        )
    }
}

impl Printed {
    /// Returns the volume of material at full density that has the same mass, m³.
    pub(super) fn material(&self) -> f64 {
        self.solid.volume() - (1.0 - self.fraction) * self.infill.volume
    }

    /// Returns the mass properties. A density is that of the walls.
    pub(super) fn mass_properties(&self, substance: Substance) -> Result<MassProperties<Part>, BodyError> {
        self.infill.mass_properties(&self.solid, substance, self.fraction).map(|(body, _)| body)
    }
}

/// Returns the block of error bounds of printed parts with their masses.
pub(super) fn bounds(
    printed: &[&Printed],
    rows: &[PartRow],
    parts: &[PartSubstance],
    common: Option<Substance>,
) -> Result<Extra, MeshBodyError> {
    let bound = mass_bounds(rows, parts, common, |k, center| {
        let part = printed[k];
        let centroid = part.solid.spread().centroid().to_array();
        let offset = std::array::from_fn(|i| center[i] - centroid[i]);
        let density = rows[k].properties.mass() / part.material();
        Ok(part.infill.bound.about(offset) * ((1.0 - part.fraction) * density))
    })?;
    Ok(mass_bound(&bound, 0.0, 0.0, "from the cells at the boundary of the infill"))
}
