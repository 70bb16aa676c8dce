//! glTF 2.0: JSON with separate buffers, or everything in one binary GLB.
//!
//! A document is a forest of nodes. Each node may place a mesh, and several nodes may place the
//! same mesh. The reader returns the default scene. Every node with a mesh is a part, placed by the
//! product of all matrices above it, in double precision. The unit is the metre. The axes are the
//! file's own (y is up in glTF; nothing is rotated).
//!
//! A mesh consists of primitives, one for each material; together they bound the solid. Triangles,
//! strips and fans are read; points and lines are skipped. Positions are floats or quantized
//! integers, packed or interleaved, sparse or dense. A placement that mirrors reverses the winding,
//! so that outside stays outside.
//!
//! Compressed meshes (Draco, meshopt) are refused by name. Animation does not apply to a rigid
//! body. Skinned meshes are used in their bind pose, and morph targets without a weight are
//! ignored; both are findings. Morph targets with weights are refused.
//!
//! Source: Khronos Group, glTF 2.0 Specification, version 2.0.1.

mod accessor;
mod buffer;
mod glb;
mod json;
mod node;
mod primitive;

use std::collections::HashMap;
use std::path::Path;

use polhode::body::Severity;
use polhode_source::files::Files;
use polhode_source::json_value;
use polhode_source::package::unfolding::Budget;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};
use serde_json::Value;

use super::affine::Affine;
use super::notes::Notes;
use super::{MeshContents, MeshPart};
use buffer::Buffers;
use json::Json;
use node::Forest;
use primitive::Surface;

/// Reads the bytes of a `.gltf` or `.glb` file. Buffers in separate files are searched only in
/// `folder`.
///
/// ```
/// use std::path::Path;
/// use polhode_shape::mesh::gltf::read;
/// use polhode_source::files::Memory;
///
/// // Two nodes place the same three corners: as they are, and 2 m along z.
/// let file = br#"{
///     "asset": {"version": "2.0"},
///     "nodes": [{"mesh": 0, "name": "low"}, {"mesh": 0, "name": "high", "translation": [0, 0, 2]}],
///     "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
///     "accessors": [{"bufferView": 0, "componentType": 5121, "type": "VEC3", "count": 3}],
///     "bufferViews": [{"buffer": 0, "byteLength": 9}],
///     "buffers": [{"byteLength": 9, "uri": "data:application/octet-stream;base64,AAEAAwAABQAC"}]
/// }"#;
/// let contents = read(&Memory::default(), file, Path::new(""))?;
/// assert_eq!((contents.unit, contents.parts.len()), (Some(1.0), 2));
/// let corners = contents.parts[1].mesh.corners().next();
/// assert_eq!(corners, Some([[0.0, 1.0, 2.0], [3.0, 0.0, 2.0], [5.0, 0.0, 4.0]]));
/// # Ok::<(), polhode_source::ContentError>(())
/// ```
///
/// # Errors
/// [`ContentError`] for bytes that are not glTF 2.0, an inconsistent document or buffer, a required
/// extension that is not supported, a buffer outside the folder, and a scene without triangles.
pub fn read(files: &dyn Files, bytes: &[u8], folder: &Path) -> Result<MeshContents, ContentError> {
    let container = glb::open(bytes)?;
    let document = parsed(container.json, container.is_binary)?;
    let root = Json::root(&document);
    require_version(&root)?;
    require_extensions(&root)?;

    let forest = Forest::of(&root)?;
    let mut scene = Scene {
        buffers: Buffers::new(root.clone(), container.chunk, files, folder),
        root,
        budget: Budget::placing(bytes.len() as u64),
        surfaces: HashMap::new(),
        parts: Vec::new(),
        notes: Notes::default(),
    };
    let name = scene.walk(&forest)?;
    if scene.parts.is_empty() {
        let kind = ContentErrorKind::missing("triangles in its scene");
        return Err(kind.of_whole().hint("export the solids as triangle meshes"));
    }
    Ok(MeshContents {
        encoding: if container.is_binary { "binary" } else { "json" },
        name,
        unit: Some(1.0),
        parts: scene.parts,
        findings: scene.notes.findings(),
    })
}

/// State of the traversal of the scene.
struct Scene<'a> {
    root: Json<'a>,
    buffers: Buffers<'a>,
    budget: Budget,
    /// Meshes read so far, by index.
    surfaces: HashMap<usize, Surface>,
    parts: Vec<MeshPart>,
    notes: Notes,
}

impl<'a> Scene<'a> {
    /// Places the mesh of every node of the scene, and returns the name of the scene.
    fn walk(&mut self, forest: &Forest<'a>) -> Result<String, ContentError> {
        let (name, roots) = forest.scene(&self.root)?;
        let mut stack: Vec<_> = roots.into_iter().rev().map(|node| (node, Affine::IDENTITY)).collect();
        let mut placed = 0;
        while let Some((index, above)) = stack.pop() {
            let node = &forest.nodes[index];
            let map = above.after(&node::transform(&node.json, &mut self.notes)?);
            if let Some(mesh) = node.json.get("mesh") {
                placed += 1;
                self.place(&node.json, &mesh, map)?;
            }
            stack.extend(node.children.iter().rev().map(|&child| (child, map)));
        }
        for node in forest.nodes.iter().filter(|node| node.json.get("mesh").is_some()).skip(placed) {
            const SENTENCE: [&str; 2] =
                ["a mesh in another scene was not read", "meshes in other scenes were not read"];
            self.notes.add("mesh.other_scene", Severity::Info, SENTENCE, || node.json.place().to_owned());
        }
        Ok(name)
    }

    fn place(&mut self, node: &Json<'a>, mesh: &Json<'a>, map: Affine) -> Result<(), ContentError> {
        let (index, mesh) = mesh.referred(&self.root, "meshes", "mesh")?;
        if !self.surfaces.contains_key(&index) {
            let surface =
                Surface::of(&mesh, &self.root, &mut self.buffers, &mut self.budget, &mut self.notes)?;
            self.surfaces.insert(index, surface);
        }
        let Some(surface) = self.surfaces.get(&index).filter(|surface| !surface.triangles.is_empty()) else {
            return Ok(());
        };
        let name = match node.text_or_empty("name")? {
            "" => mesh.text_or_empty("name")?,
            name => name,
        };
        primitive::is_unmorphed(node)?;
        let maps = match node.get("skin") {
            Some(_) => {
                const SENTENCE: [&str; 2] = [
                    "a mesh is attached to a skeleton and was used in its bind pose, without the transform of its node",
                    "meshes are attached to skeletons and were used in their bind poses, without the transforms of their nodes",
                ];
                self.notes.add("mesh.skinned", Severity::Warning, SENTENCE, || node.place().to_owned());
                vec![Affine::IDENTITY]
            }
            None => node::instances(node, map, &self.root, &mut self.buffers, &mut self.budget)?,
        };
        for map in maps {
            let place = || node.place().to_owned();
            self.budget.spend(1, size_of::<MeshPart>() + name.len(), place)?;
            self.budget.spend(surface.vertices.len(), size_of::<[f64; 3]>(), place)?;
            self.budget.spend(surface.triangles.len(), size_of::<[u32; 3]>(), place)?;
            let mesh = map.placed(&surface.vertices, &surface.triangles, place)?;
            self.parts.push(MeshPart { name: name.to_owned(), mesh });
        }
        Ok(())
    }
}

/// Maximum size of a JSON document, including `data:` URIs, bytes. In memory it takes several times
/// as much.
pub const LARGEST_TEXT: u64 = 256 << 20;

fn parsed(json: &[u8], is_binary: bool) -> Result<Value, ContentError> {
    if json.len() as u64 > LARGEST_TEXT {
        let what = format!("a document whose JSON has more than {LARGEST_TEXT} bytes");
        return Err(ContentErrorKind::unsupported(what)
            .of_whole()
            .hint("put the buffers into files or into a .glb, not into data: URIs"));
    }
    let text = json.strip_prefix("\u{feff}".as_bytes()).unwrap_or(json);
    json_value(text).map_err(|e| {
        let message = e.to_string();
        let what = message.split(" at line ").next().unwrap_or_default().to_owned();
        let (line, column) = (e.line(), e.column());
        let kind = ContentErrorKind::expected("JSON", what);
        if is_binary {
            let place = format!("the chunk of JSON, line {line}, column {column}");
            return ContentError::new(kind, ContentPlace::Within(place));
        }
        let start: usize =
            text.split_inclusive(|&b| b == b'\n').take(line.saturating_sub(1)).map(<[u8]>::len).sum();
        let at = (json.len() - text.len() + start + column.saturating_sub(1)).min(json.len());
        kind.at(at..(at + 1).min(json.len()))
    })
}

fn require_version(root: &Json<'_>) -> Result<(), ContentError> {
    let asset = root.need("asset")?;
    let version = asset.need("version")?;
    let needed = asset.get("minVersion");
    let is_two = |json: &Json<'_>| Ok(json.text()?.split('.').next() == Some("2"));
    let too_new = needed.as_ref().map(|json| Ok(json.text()? != "2.0")).transpose()? == Some(true);
    if !is_two(&version)? || too_new {
        let number = needed.filter(|_| too_new).unwrap_or(version.clone());
        let kind = ContentErrorKind::unsupported(format!("glTF {}", number.text()?));
        return Err(number.error(kind).hint("export it as glTF 2.0"));
    }
    Ok(())
}

/// Checks the required extensions: supported ones, and ones that do not affect the shape.
fn require_extensions(root: &Json<'_>) -> Result<(), ContentError> {
    const READ: [&str; 2] = ["KHR_mesh_quantization", "EXT_mesh_gpu_instancing"];
    const LOOKS: [&str; 8] = [
        "KHR_materials_",
        "KHR_texture_",
        "KHR_lights_",
        "EXT_texture_",
        "EXT_lights_",
        "MSFT_texture_",
        "KHR_xmp_json_ld",
        "KHR_animation_pointer",
    ];
    for extension in root.list("extensionsRequired")? {
        let name = extension.text()?;
        if READ.contains(&name) || LOOKS.iter().any(|start| name.starts_with(start)) {
            continue;
        }
        let is_compression = ["KHR_draco_mesh_compression", "EXT_meshopt_compression"].contains(&name);
        return Err(if is_compression {
            extension.error(buffer::compressed(name)).hint(buffer::UNPACK)
        } else {
            let what = format!("files that need the extension {name}");
            extension.error(ContentErrorKind::unsupported(what)).hint("export it without the extension")
        });
    }
    Ok(())
}
