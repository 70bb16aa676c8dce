//! Primitives: corners and their connection to triangles.

use std::collections::HashMap;

use polhode::body::Severity;
use polhode_source::package::unfolding::Budget;
use polhode_source::{ContentError, ContentErrorKind};

use super::accessor;
use super::buffer::{Buffers, UNPACK, compressed};
use super::json::Json;
use crate::mesh::notes::Notes;

/// Triangles of all primitives of a mesh.
#[derive(Debug, Default)]
pub(crate) struct Surface {
    pub vertices: Vec<[f64; 3]>,
    pub triangles: Vec<[u32; 3]>,
}

/// Refuses morph weights that change the shape.
pub(crate) fn is_unmorphed(holder: &Json<'_>) -> Result<(), ContentError> {
    let weights = holder.list("weights")?;
    for weight in weights {
        if weight.number()? != 0.0 {
            let what = "morph targets with a weight: the shape differs from its vertices";
            return Err(weight
                .error(ContentErrorKind::unsupported(what))
                .hint("apply the shape keys in the program that created the file, and export again"));
        }
    }
    Ok(())
}

impl Surface {
    pub(crate) fn of<'a>(
        mesh: &Json<'a>,
        root: &Json<'a>,
        buffers: &mut Buffers<'a>,
        budget: &mut Budget,
        notes: &mut Notes,
    ) -> Result<Self, ContentError> {
        let mut surface = Self::default();
        // Primitives often share vertices. The map stores first vertex and count by accessor.
        let mut known: HashMap<usize, (usize, usize)> = HashMap::new();
        for primitive in mesh.list("primitives")? {
            let Some(corners) = Corners::of(&primitive)? else {
                const SENTENCE: [&str; 2] = [
                    "a primitive consists of points or lines, or has no positions, and was ignored",
                    "primitives consist of points or lines, or have no positions, and were ignored",
                ];
                notes.add("mesh.not_a_surface", Severity::Info, SENTENCE, || primitive.place().to_owned());
                continue;
            };
            if primitive.get("targets").is_some() {
                is_unmorphed(mesh)?;
                const SENTENCE: [&str; 2] = [
                    "a primitive has morph targets, which were ignored",
                    "primitives have morph targets, which were ignored",
                ];
                notes.add("mesh.morph_targets", Severity::Info, SENTENCE, || primitive.place().to_owned());
            }
            let (accessor, positions) = corners.positions.referred(root, "accessors", "accessor")?;
            let draco = primitive.get("extensions").and_then(|e| e.get("KHR_draco_mesh_compression"));
            if let Some(draco) = draco.filter(|_| positions.get("bufferView").is_none()) {
                return Err(draco.error(compressed("KHR_draco_mesh_compression")).hint(UNPACK));
            }
            let (first, count) = match known.get(&accessor) {
                Some(&range) => range,
                None => {
                    let vertices = accessor::vectors::<3>(&positions, buffers, budget)?;
                    let range = (surface.vertices.len(), vertices.len());
                    surface.vertices.extend(vertices);
                    known.insert(accessor, range);
                    range
                }
            };
            let too_many = |_| corners.positions.refused("the vertices of the mesh", "at most 2³² − 1");
            let first = u32::try_from(first).map_err(too_many)?;
            u32::try_from(surface.vertices.len()).map_err(too_many)?;
            match primitive.get("indices") {
                Some(indices) => {
                    let (_, indices) = indices.referred(root, "accessors", "accessor")?;
                    let order = accessor::indices(&indices, count, buffers, budget)?;
                    surface.join(&primitive, corners.mode, order.len(), first, |k| order[k], budget)?;
                }
                None => surface.join(&primitive, corners.mode, count, first, |k| k as u32, budget)?,
            }
        }
        Ok(surface)
    }

    /// Connects a sequence of corners to triangles.
    fn join(
        &mut self,
        primitive: &Json<'_>,
        mode: Mode,
        corners: usize,
        first: u32,
        corner: impl Fn(usize) -> u32,
        budget: &mut Budget,
    ) -> Result<(), ContentError> {
        let (fits, rule) = match mode {
            Mode::Triangles => (corners.is_multiple_of(3), "divisible by 3"),
            Mode::Strip | Mode::Fan => (corners >= 3, "3 or more"),
        };
        if !fits {
            let (what, value) = ("the number of corners", corners.to_string());
            return Err(primitive.error(ContentErrorKind::value(what, value, rule)));
        }
        let count = if mode == Mode::Triangles { corners / 3 } else { corners - 2 };
        budget.spend(count, size_of::<[u32; 3]>(), || primitive.place().to_owned())?;
        self.triangles.extend((0..count).map(|i| {
            let order = match mode {
                Mode::Triangles => [3 * i, 3 * i + 1, 3 * i + 2],
                // Every second triangle of a strip has the opposite winding.
                Mode::Strip => [i, i + 1 + i % 2, i + 2 - i % 2],
                Mode::Fan => [i + 1, i + 2, 0],
            };
            order.map(|k| first + corner(k))
        }));
        Ok(())
    }
}

/// Connection of corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    Triangles,
    Strip,
    Fan,
}

/// Positions of a primitive and their connection.
struct Corners<'a> {
    positions: Json<'a>,
    mode: Mode,
}

impl<'a> Corners<'a> {
    /// Reads a primitive; `None` if it is not a surface.
    fn of(primitive: &Json<'a>) -> Result<Option<Self>, ContentError> {
        let mode = match primitive.whole_or("mode", 4)? {
            0..=3 => return Ok(None),
            4 => Mode::Triangles,
            5 => Mode::Strip,
            6 => Mode::Fan,
            _ => return Err(primitive.need("mode")?.refused("mode", "from 0 to 6")),
        };
        Ok(primitive.need("attributes")?.get("POSITION").map(|positions| Self { positions, mode }))
    }
}
