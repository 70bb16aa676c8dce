//! The triangles of a COLLADA file (.dae).
//!
//! Meshes by `<triangles>`, `<polylist>` and `<polygons>`, each placed as the nodes of the scene place it, in the file's unit. `<up_axis>` is
//! not applied, as RViz and Gazebo do not apply it; `is_y_up` says where others would. Polygons are fans, lines are left out. What it does not
//! read, skins and strips, is an error.
//!
//! Source: COLLADA 1.4.1 specification, Khronos Group 2008.

use std::collections::HashMap;

use polhode::body::mesh::TriangleMesh;
use polhode::body::{Finding, Severity};
use polhode_formats::mesh::{MeshContents, MeshPart};
use polhode_formats::{ContentError, ContentErrorKind, ContentPlace};

use crate::model::{Pose, Span};
use crate::pose::{about_axis, sum};
use crate::read::xml::{Element, Written, with_root};

/// Reads the triangles of the scene, one part for each mesh in it.
///
/// # Errors
/// [`ContentError`] for what is no XML, lacks what it names, or has what is not read.
pub fn read(text: &str) -> Result<MeshContents, ContentError> {
    with_root(text, |root| {
        let named = named(root);
        let unit = root.child("asset").and_then(|asset| asset.child("unit"));
        let unit = unit.and_then(|unit| unit.attribute("meter")).map(|meter| positive(&meter)).transpose()?;
        let mut reader =
            Reader { named, meshes: HashMap::new(), parts: Vec::new(), left: text.len(), lines: 0 };
        let scene = root.child("scene").and_then(|scene| scene.child("instance_visual_scene"));
        let scene = match scene.and_then(|instance| instance.attribute("url")) {
            Some(url) => reader.named.get(url.value.trim_start_matches('#')).copied(),
            None => root.child("library_visual_scenes").and_then(|scenes| scenes.child("visual_scene")),
        };
        let scene = scene.ok_or_else(|| missing("scene", root))?;
        reader.nodes(scene)?;
        let findings = reader.finding().into_iter().collect();
        Ok(MeshContents { encoding: "xml", name: String::new(), unit, parts: reader.parts, findings })
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
    fn of(element: Element<'_>) -> Result<Option<Self>, ContentError> {
        Ok(Some(match element.name() {
            "matrix" => {
                let [a, b, c, x, d, e, f, y, g, h, i, z, ..] = array::<16>(element)?;
                Self { linear: [[a, b, c], [d, e, f], [g, h, i]], shift: [x, y, z] }
            }
            "translate" => Self { shift: array(element)?, ..Self::IDENTITY },
            "scale" => {
                let [x, y, z] = array(element)?;
                Self { linear: [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]], shift: [0.0; 3] }
            }
            "rotate" => {
                let [x, y, z, degrees] = array(element)?;
                let turn = match about_axis([x, y, z], degrees.to_radians()) {
                    Some(turn) => turn,
                    None if degrees == 0.0 => Pose::IDENTITY.rotation,
                    None => return Err(missing("axis of the rotation", element)),
                };
                Self { linear: Pose::new([0.0; 3], turn).matrix(), shift: [0.0; 3] }
            }
            "skew" | "lookat" => return Err(unsupported(element)),
            _ => return Ok(None),
        }))
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
    /// Geometries that have lines and no faces.
    lines: usize,
}

impl<'a> Reader<'a> {
    fn finding(&self) -> Option<Finding> {
        let message = format!("{} geometries of lines alone bound no solid and were left out", self.lines);
        (self.lines > 0).then_some(Finding {
            code: "mesh.not_a_surface",
            severity: Severity::Info,
            message,
            place: None,
        })
    }

    fn nodes(&mut self, scene: Element<'a>) -> Result<(), ContentError> {
        let mut waiting = vec![(scene, Affine::IDENTITY)];
        while let Some((node, mut place)) = waiting.pop() {
            for child in node.children() {
                match child.name() {
                    "node" => waiting.push((child, place)),
                    "instance_geometry" => self.instance(child, &place)?,
                    "instance_node" => {
                        self.spend(1, child)?; // a node in itself ends here
                        let url = child.word("url").unwrap_or("").trim_start_matches('#');
                        let node = self.named.get(url).copied();
                        let node = node.filter(|node| node.name() == "node");
                        waiting.push((node.ok_or_else(|| missing(&format!("node {url:?}"), child))?, place));
                    }
                    "instance_controller" => return Err(unsupported(child)),
                    // they stand before what they place
                    _ => {
                        if let Some(inner) = Affine::of(child)? {
                            place = place.then(&inner);
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
        let size = self.meshes.get(url).map_or(0, |surface| surface.triangles.len() + surface.vertices.len());
        self.spend(size, instance)?;
        let Some(surface) = self.meshes.get(url) else { return Ok(()) };
        let vertices: Vec<_> = surface.vertices.iter().map(|v| place.placed(*v)).collect();
        if let Some(vertex) = vertices.iter().find(|vertex| vertex.iter().any(|c| !c.is_finite())) {
            let (what, found) = ("a vertex where the scene places it".to_owned(), format!("{vertex:?}"));
            let place = ContentPlace::Text(instance.span());
            return Err(ContentError::new(ContentErrorKind::NotFinite { what, found }, place));
        }
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

    fn spend(&mut self, size: usize, instance: Element<'a>) -> Result<(), ContentError> {
        self.left = self.left.checked_sub(size).ok_or_else(|| {
            let what = "scenes that hold a mesh so often that its copies are longer than the file".to_owned();
            ContentError::new(ContentErrorKind::Unsupported { what }, ContentPlace::Text(instance.span()))
        })?;
        Ok(())
    }

    fn surface(&mut self, geometry: Element<'a>) -> Result<Surface, ContentError> {
        let mesh = geometry.child("mesh").ok_or_else(|| missing("mesh", geometry))?;
        let mut surface: Option<Surface> = None;
        let mut has_lines = false;
        for faces in mesh.children() {
            let counts = match faces.name() {
                "triangles" | "polylist" | "polygons" => faces.child_text("vcount"),
                "tristrips" | "trifans" => return Err(unsupported(faces)),
                "lines" | "linestrips" => {
                    has_lines = true;
                    continue;
                }
                _ => continue, // sources
            };
            let inputs: Vec<_> = faces.named("input").collect();
            let offset = |input: &Element<'a>| whole(*input, "offset", 0);
            let offsets = inputs.iter().map(offset).collect::<Result<Vec<_>, _>>()?;
            let stride = offsets.into_iter().max().unwrap_or(0).saturating_add(1);
            let input = inputs.iter().find(|input| input.word("semantic") == Some("VERTEX"));
            let input = *input.ok_or_else(|| missing("input of vertices", faces))?;
            // all faces of a mesh have the same vertices
            let Surface { vertices, triangles } = match &mut surface {
                Some(surface) => surface,
                none => none.insert(Surface { vertices: self.positions(input)?, triangles: Vec::new() }),
            };
            let mut present = 0;
            let mut counts = counts.iter().flat_map(|counts| counts.value.split_ascii_whitespace());
            for list in faces.named("p") {
                let Some(text) = list.text() else { continue };
                let corners = text.value.split_ascii_whitespace().skip(offset(&input)?).step_by(stride);
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
                    present += 1;
                }
            }
            declared(faces, "faces", present)?;
        }
        if surface.is_none() && has_lines {
            self.lines += 1;
            surface = Some(Surface { vertices: Vec::new(), triangles: Vec::new() });
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
            |name: &str, default| accessor.map_or(Ok(default), |accessor| whole(accessor, name, default));
        let (stride, offset) = (of("stride", 3)?, of("offset", 0)?);
        let array = source.child("float_array").ok_or_else(|| missing("float_array", source))?;
        let values = finite(&array.text().ok_or_else(|| missing("numbers", array))?)?;
        declared(array, "numbers of <float_array>", values.len())?;
        if stride < 3 {
            return Err(missing("three coordinates", source));
        }
        let values = values.get(offset..).unwrap_or_default();
        let points: Vec<_> = values.chunks(stride).filter_map(|point| point.first_chunk().copied()).collect();
        if let Some(accessor) = accessor {
            declared(accessor, "points", points.len())?;
        }
        Ok(points)
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

/// What an attribute counts; the default if it is not there.
fn whole(element: Element<'_>, name: &str, default: usize) -> Result<usize, ContentError> {
    let Some(written) = element.attribute(name) else { return Ok(default) };
    written.value.parse().map_err(|_| expected("a whole number", written.value, written.span))
}

/// What an element declares as its `count` is what it has: a file that was cut short, or edited, has something else.
fn declared(element: Element<'_>, what: &str, present: usize) -> Result<(), ContentError> {
    let declared = whole(element, "count", present)?;
    if declared == present {
        return Ok(());
    }
    let (what, declared, present) = (what.to_owned(), declared as u64, present as u64);
    Err(ContentError::new(ContentErrorKind::Count { what, declared, present }, start(element)))
}

fn positive(written: &Written<'_>) -> Result<f64, ContentError> {
    match finite(written)?[..] {
        [number] if number > 0.0 => Ok(number),
        _ => Err(expected("a positive number", written.value, written.span.clone())),
    }
}

/// As many numbers as are asked for, in an element.
fn array<const N: usize>(element: Element<'_>) -> Result<[f64; N], ContentError> {
    let written = element.text().ok_or_else(|| missing("numbers", element))?;
    let values = finite(&written)?;
    let unlike =
        |values: Vec<f64>| expected(&format!("{N} numbers"), &format!("{}", values.len()), written.span);
    values.try_into().map_err(unlike)
}

/// Numbers with blanks between them.
fn finite(written: &Written<'_>) -> Result<Vec<f64>, ContentError> {
    let values: Vec<f64> = written.values().collect();
    if values.iter().all(|value| value.is_finite()) {
        return Ok(values);
    }
    let wrong = written.numbers().find(|number| !number.value.is_some_and(f64::is_finite));
    let (found, at) =
        wrong.map_or((String::new(), written.span.clone()), |number| (number.text, number.span));
    Err(expected("a finite number", &found, at))
}

fn expected(what: &str, found: &str, at: Span) -> ContentError {
    let (what, found) = (what.to_owned(), found.to_owned());
    ContentError::new(ContentErrorKind::Expected { what, found }, ContentPlace::Text(at))
}

fn missing(what: &str, at: Element<'_>) -> ContentError {
    ContentError::new(ContentErrorKind::Missing { what: what.to_owned() }, start(at))
}

fn unsupported(element: Element<'_>) -> ContentError {
    let what = format!("<{}> of COLLADA", element.name());
    ContentError::new(ContentErrorKind::Unsupported { what }, start(element))
}

/// Where an element begins.
fn start(element: Element<'_>) -> ContentPlace {
    let start = element.span().start;
    ContentPlace::Text(start..start + 1)
}
