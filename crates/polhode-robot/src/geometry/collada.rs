//! The triangles of a COLLADA file (.dae).
//!
//! Meshes by `<triangles>`, `<polylist>` and `<polygons>`, each placed as the nodes of the scene place it, in the file's unit. `<up_axis>` is
//! not applied, as RViz and Gazebo do not apply it; [`is_y_up`] says where others would. Polygons are fans. What it does not read, skins, nodes of a
//! library, strips, is an error.
//!
//! Source: COLLADA 1.4.1 specification, Khronos Group 2008.

use std::collections::HashMap;

use polhode::TriangleMesh;
use polhode_formats::mesh::{MeshContents, MeshPart};
use polhode_formats::{ContentError, ContentErrorKind, ContentPlace};

use crate::model::Pose;
use crate::pose::{about_axis, sum};
use crate::read::xml::{Element, with_root};

/// Reads the triangles of the scene, one part for each mesh in it.
///
/// # Errors
/// [`ContentError`] for what is no XML, lacks what it names, or has what is not read.
pub fn read(text: &str) -> Result<MeshContents, ContentError> {
    with_root(text, |root| {
        let named = named(root);
        let unit = root
            .child("asset")
            .and_then(|asset| asset.child("unit"))
            .and_then(|unit| unit.attribute("meter"));
        let mut reader = Reader { named, meshes: HashMap::new(), parts: Vec::new(), left: text.len() };
        let scene = root.child("scene").and_then(|scene| scene.child("instance_visual_scene"));
        let scene = match scene.and_then(|instance| instance.attribute("url")) {
            Some(url) => reader.named.get(url.value.trim_start_matches('#')).copied(),
            None => root.child("library_visual_scenes").and_then(|scenes| scenes.child("visual_scene")),
        };
        let scene = scene.ok_or_else(|| missing("scene", root))?;
        reader.nodes(scene)?;
        Ok(MeshContents {
            encoding: "xml",
            name: String::new(),
            unit: unit
                .and_then(|meter| meter.array())
                .map(|[meter]| meter)
                .filter(|meter| *meter > 0.0 && meter.is_finite()),
            parts: reader.parts,
            findings: Vec::new(),
        })
    })
}

/// Whether a text that has been read says `<up_axis>Y_UP</up_axis>`.
pub(super) fn is_y_up(text: &str) -> bool {
    let said = text.split_once("<up_axis>").map(|(_, rest)| rest.trim_start());
    said.is_some_and(|rest| rest.starts_with("Y_UP"))
}

/// x' = L x + t
#[derive(Clone, Copy)]
struct Affine {
    linear: [[f64; 3]; 3],
    shift: [f64; 3],
}

impl Affine {
    const IDENTITY: Self =
        Self { linear: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.0; 3] };

    fn turned(&self, v: [f64; 3]) -> [f64; 3] {
        self.linear.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }

    fn placed(&self, p: [f64; 3]) -> [f64; 3] {
        sum(self.shift, self.turned(p))
    }

    fn then(&self, inner: &Self) -> Self {
        let columns = [0, 1, 2].map(|k| self.turned([0, 1, 2].map(|i| inner.linear[i][k])));
        Self { linear: [0, 1, 2].map(|i| [0, 1, 2].map(|k| columns[k][i])), shift: self.placed(inner.shift) }
    }

    fn mirrors(&self) -> bool {
        let [a, b, c] = self.linear;
        let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
        a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2] < 0.0
    }

    /// What an element of a node says, if it says how the node is placed.
    fn of(element: Element<'_>) -> Option<Result<Self, ContentError>> {
        let numbers = element.text();
        let placed = match element.name() {
            "matrix" => numbers.and_then(|text| text.array()).map(|m: [f64; 16]| Self {
                linear: [[m[0], m[1], m[2]], [m[4], m[5], m[6]], [m[8], m[9], m[10]]],
                shift: [m[3], m[7], m[11]],
            }),
            "translate" => {
                numbers.and_then(|text| text.array()).map(|shift| Self { shift, ..Self::IDENTITY })
            }
            "scale" => numbers.and_then(|text| text.array()).map(|[x, y, z]| Self {
                linear: [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]],
                shift: [0.0; 3],
            }),
            "rotate" => numbers.and_then(|text| text.array()).map(|[x, y, z, degrees]: [f64; 4]| {
                let turn = about_axis([x, y, z], degrees.to_radians()).unwrap_or(Pose::IDENTITY.rotation);
                Self { linear: Pose::new([0.0; 3], turn).matrix(), shift: [0.0; 3] }
            }),
            "skew" | "lookat" => return Some(Err(unsupported(element))),
            _ => return None,
        };
        Some(placed.ok_or_else(|| missing("numbers", element)))
    }
}

/// A mesh as the file has it, before it is placed.
struct Surface {
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
}

struct Reader<'a> {
    named: HashMap<&'a str, Element<'a>>,
    meshes: HashMap<&'a str, Surface>,
    parts: Vec<MeshPart>,
    /// Triangles and vertices that may still come: a mesh that the scene has a thousand times must not fill the memory.
    left: usize,
}

impl<'a> Reader<'a> {
    fn nodes(&mut self, scene: Element<'a>) -> Result<(), ContentError> {
        let mut waiting = vec![(scene, Affine::IDENTITY)];
        while let Some((node, mut place)) = waiting.pop() {
            for child in node.children() {
                match child.name() {
                    "node" => waiting.push((child, place)),
                    "instance_geometry" => self.instance(child, &place)?,
                    "instance_node" | "instance_controller" => return Err(unsupported(child)),
                    // they stand before what they place
                    _ => {
                        if let Some(inner) = Affine::of(child) {
                            place = place.then(&inner?);
                        }
                    }
                }
            }
        }
        Ok(())
    }

    fn instance(&mut self, instance: Element<'a>, place: &Affine) -> Result<(), ContentError> {
        let url = instance.word("url").unwrap_or("").trim_start_matches('#');
        if !self.meshes.contains_key(url) {
            let geometry = self
                .named
                .get(url)
                .copied()
                .ok_or_else(|| missing(&format!("geometry {url:?}"), instance))?;
            let surface = self.surface(geometry)?;
            self.meshes.insert(url, surface);
        }
        let Some(surface) = self.meshes.get(url) else { return Ok(()) };
        self.left =
            self.left.checked_sub(surface.triangles.len() + surface.vertices.len()).ok_or_else(|| {
                let what =
                    "scenes that hold a mesh so often that its copies are longer than the file".to_owned();
                ContentError::new(ContentErrorKind::Unsupported { what }, ContentPlace::Text(instance.span()))
            })?;
        let vertices = surface.vertices.iter().map(|v| place.placed(*v)).collect();
        let turn = |[a, b, c]: [u32; 3]| if place.mirrors() { [a, c, b] } else { [a, b, c] };
        let triangles: Vec<_> = surface.triangles.iter().copied().map(turn).collect();
        if triangles.is_empty() {
            return Ok(());
        }
        let mesh = TriangleMesh::new(vertices, triangles).map_err(|error| {
            ContentError::new(ContentErrorKind::Body(Box::new(error)), ContentPlace::Text(instance.span()))
        })?;
        self.parts.push(MeshPart { name: url.to_owned(), mesh });
        Ok(())
    }

    fn surface(&self, geometry: Element<'a>) -> Result<Surface, ContentError> {
        let mesh = geometry.child("mesh").ok_or_else(|| missing("mesh", geometry))?;
        let mut surface: Option<Surface> = None;
        for faces in mesh.children() {
            let counts = match faces.name() {
                "triangles" | "polylist" | "polygons" => faces.child_text("vcount"),
                "tristrips" | "trifans" => return Err(unsupported(faces)),
                _ => continue, // lines and sources
            };
            let inputs: Vec<_> = faces.named("input").collect();
            let offset = |input: &Element<'a>| number(*input, "offset").unwrap_or(0);
            let stride = inputs.iter().map(offset).max().unwrap_or(0).saturating_add(1);
            let input = inputs.iter().find(|input| input.word("semantic") == Some("VERTEX"));
            let input = *input.ok_or_else(|| missing("input of vertices", faces))?;
            // all faces of a mesh have the same vertices
            let Surface { vertices, triangles } = match &mut surface {
                Some(surface) => surface,
                none => none.insert(Surface { vertices: self.positions(input)?, triangles: Vec::new() }),
            };
            let mut counts = counts.iter().flat_map(|counts| counts.value.split_ascii_whitespace());
            for list in faces.named("p") {
                let Some(text) = list.text() else { continue };
                let corners = text.value.split_ascii_whitespace().skip(offset(&input)).step_by(stride);
                let corners: Option<Vec<u32>> = corners
                    .map(|word| word.parse().ok().filter(|index| (*index as usize) < vertices.len()))
                    .collect();
                let corners = corners.ok_or_else(|| missing("vertex of that number", list))?;
                let mut rest = corners.as_slice();
                while !rest.is_empty() {
                    let size = match faces.name() {
                        "triangles" => Some(3),
                        "polygons" => Some(rest.len()),
                        _ => counts.next().and_then(|count| count.parse().ok()),
                    };
                    let (face, later) = size
                        .filter(|size| *size > 0)
                        .and_then(|size| rest.split_at_checked(size))
                        .ok_or_else(|| missing("corner of the last face", list))?;
                    if let [first, others @ ..] = face {
                        triangles.extend(others.windows(2).map(|edge| [*first, edge[0], edge[1]]));
                    }
                    rest = later;
                }
            }
        }
        surface.ok_or_else(|| missing("triangles", geometry))
    }

    /// The positions behind an input: `<vertices>`, then a source, then its numbers.
    fn positions(&self, input: Element<'a>) -> Result<Vec<[f64; 3]>, ContentError> {
        let follow = |element: Element<'a>| {
            let url = element.word("source").unwrap_or("").trim_start_matches('#');
            self.named.get(url).copied().ok_or_else(|| missing(&format!("element {url:?}"), element))
        };
        let vertices = follow(input)?;
        let position = vertices.named("input").find(|input| input.word("semantic") == Some("POSITION"));
        let source = follow(position.ok_or_else(|| missing("positions", vertices))?)?;
        let accessor = source.child("technique_common").and_then(|technique| technique.child("accessor"));
        let of =
            |name: &str, default| accessor.and_then(|accessor| number(accessor, name)).unwrap_or(default);
        let (stride, offset) = (of("stride", 3), of("offset", 0));
        let numbers = source.child_text("float_array").ok_or_else(|| missing("float_array", source))?;
        let values: Vec<f64> = numbers.values().skip(offset).collect();
        if stride < 3 {
            return Err(missing("three coordinates", source));
        }
        Ok(values.chunks(stride).filter_map(|point| point.first_chunk().copied()).collect())
    }
}

/// All elements that have an `id`.
fn named(root: Element<'_>) -> HashMap<&str, Element<'_>> {
    let mut named = HashMap::new();
    let mut waiting = vec![root];
    while let Some(element) = waiting.pop() {
        if let Some(id) = element.word("id") {
            named.entry(id).or_insert(element);
        }
        waiting.extend(element.children());
    }
    named
}

fn number(element: Element<'_>, name: &str) -> Option<usize> {
    element.word(name).and_then(|word| word.parse().ok())
}

fn missing(what: &str, at: Element<'_>) -> ContentError {
    let start = at.span().start;
    ContentError::new(
        ContentErrorKind::Missing { what: what.to_owned() },
        ContentPlace::Text(start..start + 1),
    )
}

fn unsupported(element: Element<'_>) -> ContentError {
    let start = element.span().start;
    let what = format!("<{}> of COLLADA", element.name());
    ContentError::new(ContentErrorKind::Unsupported { what }, ContentPlace::Text(start..start + 1))
}
