//! Position and orientation of a part in the body.

use polhode::body::{Form, MassProperties, PlacedForm, PlacedPart};
use polhode::math::{Body, Part, Position, Rotation};
use polhode_source::toml::reader::Table;
use polhode_source::toml::rotation;
use polhode_source::unit::Dimension;
use polhode_source::{FormatError, FormatErrorKind};

/// Position, m, and orientation of a part in the body.
pub(crate) struct Placement {
    pub position: Position<Body>,
    pub rotation: Rotation<Body, Part>,
}

impl Placement {
    pub(crate) fn read(table: &Table<'_>) -> Result<Self, FormatError> {
        let position = match table.get("position") {
            Some(position) => Position::from_array(position.quantities(Dimension::LENGTH)?),
            None => Position::ZERO,
        };
        let rotation = table.get("rotate").map_or(Ok(Rotation::identity()), |value| rotation(&value))?;
        Ok(Self { position, rotation })
    }

    pub(crate) fn place(
        &self,
        table: &Table<'_>,
        part: MassProperties<Part>,
    ) -> Result<MassProperties<Body>, FormatError> {
        let placed = PlacedPart::new(part, self.position, self.rotation);
        placed.map(|part| part.in_body()).map_err(|e| table.error(FormatErrorKind::Body(e)))
    }

    pub(crate) const fn form(&self, form: Form) -> PlacedForm {
        PlacedForm { form, position: self.position, rotation: self.rotation }
    }
}
