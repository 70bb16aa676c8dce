//! Positions of a prim's mass properties in the text, for edits.

use std::collections::HashMap;

use polhode_source::ContentError;

use super::body::{AXES, CENTER, MASS, MOMENTS};
use super::layer::{Layer, Prim};
use super::unit::Units;
use crate::model::Span;

/// Mass properties of a prim in the text.
#[derive(Clone, Debug)]
pub(crate) struct MassSite {
    /// Names of the attributes, and the positions of their values: mass, centre, moments, axes.
    pub(crate) values: [(&'static str, Option<Span>); 4],
    /// True if `PhysicsMassAPI` is applied.
    pub(crate) is_applied: bool,
    /// Position of the list of applied schemas, if it is stated.
    pub(crate) schemas: Option<Span>,
    /// Position of the specifier, type and name.
    pub(crate) head: Span,
    /// Byte after the `(` of the metadata, if there is one, and byte after the `{`.
    pub(crate) openings: (Option<usize>, usize),
    /// Byte at which the next prim begins, or the end of the text.
    pub(crate) next: usize,
    /// Length unit, m, and mass unit, kg.
    pub(crate) units: [f64; 2],
}

/// Returns the positions for each prim of a layer, by its path.
pub(crate) fn mass_sites(text: &str) -> Result<HashMap<String, MassSite>, ContentError> {
    let layer = Layer::of(text)?;
    let Units { metres, kilograms } = Units::of(&layer, &mut Vec::new())?;
    let nexts = layer.prims.iter().skip(1).map(|next| next.span.start).chain([text.len()]);
    let site = |(prim, next): (&Prim, usize)| {
        let value = |name: &'static str| (name, prim.properties.get(name).map(|value| value.span.clone()));
        let site = MassSite {
            values: [MASS, CENTER, MOMENTS, AXES].map(value),
            is_applied: super::applies(prim, "PhysicsMassAPI"),
            schemas: prim.metadata.get("apiSchemas").map(|schemas| schemas.span.clone()),
            head: prim.span.clone(),
            openings: prim.openings,
            next,
            units: [metres, kilograms],
        };
        (prim.path.clone(), site)
    };
    Ok(layer.prims.iter().zip(nexts).map(site).collect())
}
