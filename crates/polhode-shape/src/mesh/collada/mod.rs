//! COLLADA: scenes of digital assets in XML.
//!
//! A document has libraries of geometries and nodes, and a scene, which is a tree of nodes. The
//! reader returns the scene. Each instance of a geometry in the tree, including instances of
//! library nodes, is a part, placed by the product of all transformations above it. The file states
//! its unit of length; the default is the metre. `<up_axis>` is not applied: the axes are the
//! file's own, as with glTF, and a note states the up axis. ([`read_with_axis`] is for callers that
//! apply it.)
//!
//! Faces are `<triangles>`, `<polylist>`, `<polygons>`, `<tristrips>` and `<trifans>`; geometries
//! with only lines are skipped. A placement that mirrors reverses the winding, so that outside
//! stays outside. Materials, cameras, lights and animations are ignored. Features that change a
//! shape but are not supported (skins, morphs, skewed axes, polygons with holes) are refused by
//! name.
//!
//! Source: COLLADA 1.4.1 specification, Khronos Group 2008.

mod library;
mod placement;
mod surface;
mod value;

use std::collections::{HashMap, HashSet};

use polhode::body::{Finding, Severity};
use polhode_source::package::unfolding::Budget;
use polhode_source::xml::{Element, with_root};
use polhode_source::{ContentError, ContentErrorKind};

use super::affine::Affine;
use super::notes::Notes;
use super::polygon::Polygons;
use super::{MeshContents, MeshPart};
use crate::finding::info;
use library::{Library, meter};
use surface::Surface;
use value::{expected, missing, start, unsupported};

/// Up axis stated in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UpAxis {
    /// Up axis `X_UP`.
    X,
    /// Up axis `Y_UP`.
    Y,
    /// Up axis `Z_UP`.
    Z,
}

/// Reads the text of a COLLADA file.
///
/// ```
/// use polhode_shape::mesh::collada::read;
/// let flake = r##"<COLLADA version="1.4.1">
///   <asset><unit name="inch" meter="0.0254"/><up_axis>Z_UP</up_axis></asset>
///   <library_geometries><geometry id="flake"><mesh>
///     <source id="p"><float_array count="9">0 1 0  3 0 0  5 0 2</float_array></source>
///     <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
///     <triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
///   </mesh></geometry></library_geometries>
///   <library_visual_scenes><visual_scene id="s"><node name="low"><instance_geometry url="#flake"/></node>
///     <node name="high"><translate>0 0 10</translate><instance_geometry url="#flake"/></node>
///   </visual_scene></library_visual_scenes>
///   <scene><instance_visual_scene url="#s"/></scene>
/// </COLLADA>"##;
/// let contents = read(flake)?;
/// assert_eq!((contents.unit, contents.parts[1].name.as_str()), (Some(0.0254), "high"));
/// let corners = contents.parts[1].mesh.corners().next();
/// assert_eq!(corners, Some([[0.0, 1.0, 10.0], [3.0, 0.0, 10.0], [5.0, 0.0, 12.0]]));
/// # Ok::<(), polhode_source::ContentError>(())
/// ```
///
/// # Errors
/// [`ContentError`] for invalid XML, missing elements, or unsupported features.
pub fn read(text: &str) -> Result<MeshContents, ContentError> {
    read_with_axis(text).map(|(contents, _)| contents)
}

/// Reads the text of a COLLADA file; also returns the up axis if the file states one.
///
/// # Errors
/// [`ContentError`], as for [`read`].
pub fn read_with_axis(text: &str) -> Result<(MeshContents, Option<UpAxis>), ContentError> {
    with_root(text, |root| {
        require_version(root)?;
        let asset = root.child("asset");
        let said = asset.map(meter).transpose()?.flatten();
        let unit = said.unwrap_or(1.0);
        let up = asset.map(up_axis).transpose()?.flatten();
        let mut reader = Reader {
            library: Library::of(root, unit)?,
            surfaces: HashMap::new(),
            polygons: Polygons::default(),
            budget: Budget::placing(text.len() as u64),
            notes: Notes::default(),
            parts: Vec::new(),
        };
        let name = reader.scene(root)?;
        let mut findings: Vec<Finding> = remarks(said, up);
        findings.extend(reader.polygons.finding());
        findings.extend(reader.notes.findings());
        Ok((MeshContents { encoding: "xml", name, unit: Some(unit), parts: reader.parts, findings }, up))
    })
}

fn require_version(root: Element<'_>) -> Result<(), ContentError> {
    if root.name() != "COLLADA" {
        let at = root.span().start;
        return Err(expected("<COLLADA>", &format!("<{}>", root.name()), at..at + 1));
    }
    match root.attribute("version") {
        Some(version) if !version.value.starts_with("1.4") && !version.value.starts_with("1.5") => {
            let kind = ContentErrorKind::unsupported(format!("COLLADA {}", version.value));
            Err(ContentError::new(kind, polhode_source::ContentPlace::Text(version.span))
                .hint("export it as COLLADA 1.4.1"))
        }
        _ => Ok(()),
    }
}

fn up_axis(asset: Element<'_>) -> Result<Option<UpAxis>, ContentError> {
    let Some(axis) = asset.child_text("up_axis") else { return Ok(None) };
    match axis.value {
        "X_UP" => Ok(Some(UpAxis::X)),
        "Y_UP" => Ok(Some(UpAxis::Y)),
        "Z_UP" => Ok(Some(UpAxis::Z)),
        other => Err(expected("X_UP, Y_UP or Z_UP", other, axis.span)),
    }
}

/// Returns findings about the conventions: the axes were not rotated, and the unit is the default
/// of the format.
fn remarks(unit: Option<f64>, up: Option<UpAxis>) -> Vec<Finding> {
    let axis = match up {
        Some(UpAxis::X) => Some("x"),
        Some(UpAxis::Y) => Some("y"),
        Some(UpAxis::Z) | None => None,
    };
    let turned = axis.map(|axis| format!("the file has {axis} up; its axes are kept, without a rotation"));
    let turned = turned.map(|message| info("mesh.up_axis", &message));
    let metres = "the file states no unit of length; the COLLADA default is the metre";
    let metres = unit.is_none().then(|| info("mesh.unit_default", metres));
    turned.into_iter().chain(metres).collect()
}

/// State of the traversal of the scene.
struct Reader<'a> {
    library: Library<'a>,
    /// Geometries read so far, by the position of their element.
    surfaces: HashMap<usize, Surface>,
    polygons: Polygons,
    /// Memory limit, since a scene may contain a mesh a thousand times.
    budget: Budget,
    notes: Notes,
    parts: Vec<MeshPart>,
}

/// Budget for an element of a node, bytes: covers its memory and its time.
const STEP: usize = 1024;

/// Pending step of the traversal.
enum Step<'a> {
    Enter {
        node: Element<'a>,
        map: Affine,
        /// The `<node>` itself, or the `<instance_node>` that refers to it.
        asked: Element<'a>,
    },
    /// The node is complete.
    Leave(usize),
}

impl<'a> Reader<'a> {
    /// Returns the visual scene that the file selects, or its only one.
    fn shown(&self, root: Element<'a>) -> Result<Element<'a>, ContentError> {
        let mut instances = root.named("scene").flat_map(|scene| scene.named("instance_visual_scene"));
        if let Some(instance) = instances.next() {
            return match instances.next() {
                None => self.library.named(instance, "url", "visual_scene"),
                Some(other) => Err(unsupported(other, " after another one")),
            };
        }
        let libraries = root.named("library_visual_scenes");
        let mut scenes = libraries.flat_map(|library| library.named("visual_scene"));
        match (scenes.next(), scenes.next()) {
            (Some(scene), None) => Ok(scene),
            (None, _) => Err(missing("visual_scene", root)),
            (Some(_), Some(other)) => Err(missing("<scene>, which selects the visual scene", other)),
        }
    }

    /// Places the geometries of the scene, and returns its name.
    fn scene(&mut self, root: Element<'a>) -> Result<String, ContentError> {
        let scene = self.shown(root)?;
        let mut above = HashSet::new();
        let mut steps = vec![Step::Enter { node: scene, map: Affine::IDENTITY, asked: scene }];
        while let Some(step) = steps.pop() {
            match step {
                Step::Leave(node) => {
                    above.remove(&node);
                }
                Step::Enter { node, map, asked } => {
                    let number = node.span().start;
                    if !above.insert(number) {
                        let (what, value) = ("the node", node.word("id").unwrap_or("").to_owned());
                        let kind = ContentErrorKind::value(what, value, "acyclic: it contains itself");
                        return Err(ContentError::new(kind, start(asked)));
                    }
                    steps.push(Step::Leave(number));
                    let inner = self.enter(node, map)?;
                    steps.extend(inner.into_iter().rev());
                }
            }
        }
        Ok(scene.word("name").unwrap_or("").to_owned())
    }

    /// Places the geometries of a node, and returns its child nodes.
    fn enter(&mut self, node: Element<'a>, mut map: Affine) -> Result<Vec<Step<'a>>, ContentError> {
        let mut inner = Vec::new();
        let mut has_placed = false;
        let is_alone = node.named("instance_geometry").nth(1).is_none();
        for child in node.children() {
            self.spend(1, STEP, child)?;
            match child.name() {
                "node" => inner.push(Step::Enter { node: child, map, asked: child }),
                "instance_node" => {
                    let node = self.library.named(child, "url", "node")?;
                    inner.push(Step::Enter { node, map, asked: child });
                }
                "instance_geometry" => self.place(child, node, is_alone, &map)?,
                "instance_controller" => return Err(unsupported(child, ", skins and morphs")),
                _ => {
                    let Some(own) = placement::of(child)? else { continue };
                    if has_placed {
                        return Err(unsupported(child, " after the geometry that it would place"));
                    }
                    map = map.after(&own);
                    continue;
                }
            }
            has_placed = true;
        }
        Ok(inner)
    }

    fn place(
        &mut self,
        instance: Element<'a>,
        node: Element<'a>,
        is_alone: bool,
        map: &Affine,
    ) -> Result<(), ContentError> {
        let geometry = self.library.named(instance, "url", "geometry")?;
        let number = geometry.span().start;
        let sizes = match self.surfaces.get(&number) {
            Some(surface) => [surface.vertices.len(), surface.triangles.len()],
            None => {
                let surface = Surface::of(geometry, &self.library, &mut self.polygons)?;
                let sizes = [surface.vertices.len(), surface.triangles.len()];
                self.surfaces.insert(number, surface);
                sizes
            }
        };
        let name = name(instance, is_alone.then_some(node), geometry);
        self.spend(1, size_of::<MeshPart>() + name.len(), instance)?;
        self.spend(sizes[0], size_of::<[f64; 3]>(), instance)?;
        self.spend(sizes[1], size_of::<[u32; 3]>(), instance)?;
        let Some(surface) = self.surfaces.get(&number) else { return Ok(()) };
        if surface.triangles.is_empty() {
            const SENTENCE: [&str; 2] =
                ["a geometry has no faces and was ignored", "geometries have no faces and were ignored"];
            self.notes.add("mesh.not_a_surface", Severity::Info, SENTENCE, || format!("geometry {name:?}"));
            return Ok(());
        }
        let mesh = map.placed(&surface.vertices, &surface.triangles, String::new);
        let mesh = mesh.map_err(|error| ContentError { place: start(instance), ..error })?;
        self.parts.push(MeshPart { name, mesh });
        Ok(())
    }

    fn spend(&mut self, items: usize, bytes_each: usize, at: Element<'a>) -> Result<(), ContentError> {
        let spent = self.budget.spend(items, bytes_each, String::new);
        spent.map_err(|error| ContentError { place: start(at), ..error })
    }
}

/// Returns the name of a part: the name of its instance or node if it is unique there, otherwise
/// that of its geometry.
fn name(instance: Element<'_>, node: Option<Element<'_>>, geometry: Element<'_>) -> String {
    let of = |element: Option<Element<'_>>, attribute: &str| {
        let word = element.and_then(|element| element.word(attribute))?;
        (!word.is_empty()).then(|| word.to_owned())
    };
    let (instance, geometry) = (Some(instance), Some(geometry));
    let names = [(instance, "name"), (node, "name"), (geometry, "name"), (node, "id"), (geometry, "id")];
    names.into_iter().find_map(|(element, attribute)| of(element, attribute)).unwrap_or_default()
}
