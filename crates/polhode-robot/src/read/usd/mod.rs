//! USD: rigid bodies of UsdPhysics, with their masses, shapes and joints.
//!
//! Lengths in a file are in the layer's unit (`metersPerUnit`, by default a centimetre) and
//! masses in `kilogramsPerUnit`. Here all numbers and their texts are in SI units. Quaternions are
//! (w, x, y, z). The up axis of the stage is not applied to bodies.
//!
//! A text layer without arcs is read by itself, with its wrong numbers. A layer with arcs
//! (`subLayers`, `references`, `payload`, `inherits`, `specializes`, variant sets), a binary layer
//! and a package are composed.
//!
//! Source: openusd.org, "Rigid Body Physics in USD"; the schemas UsdPhysics and UsdGeom.

mod array;
mod body;
mod changing;
mod composed;
mod coordinate;
mod joint;
mod layer;
mod mass;
mod mass_site;
mod mesh;
mod path;
mod shape;
mod statement;
mod token;
mod unit;
mod unread;
mod value;
mod xform;

use std::collections::HashMap;
use std::collections::HashSet;
use std::path::Path;

use polhode_source::{ContentError, FormatError};

use super::ReadOptions;
use crate::finding::Severity;
use crate::model::{Geometry, GeometryShape, ModelFormat, Note, Pose, RobotModel, Role};
use layer::{Layer, Prim, require_short};
use mass::Colliders;
use mesh::Meshes;
use unit::Units;
use xform::Affine;

pub(crate) use mass_site::{MassSite, mass_sites};

/// Metadata keys that refer to other layers or prims.
const ELSEWHERE: [&str; 5] = ["references", "payload", "inherits", "specializes", "subLayers"];

/// Reads a stage by its root layer or package.
///
/// # Errors
/// [`FormatError`] if a layer cannot be read, or if the stage cannot be composed.
pub(super) fn read(
    bytes: Vec<u8>,
    path: &Path,
    options: &ReadOptions<'_>,
) -> Result<RobotModel, FormatError> {
    let mut model = RobotModel::empty(path, ModelFormat::Usd);
    let layer = match single(&bytes, path)? {
        Some(layer) => {
            model.text = String::from_utf8(bytes).unwrap_or_default();
            layer
        }
        None => composed(bytes, path, options, &mut model)?,
    };
    let failed = |model: &RobotModel, error| FormatError::of_content(path, model.text.as_bytes(), error);
    let bytes = model.texts().map(str::len).sum();
    fill(&layer, bytes, &mut model).map_err(|error| failed(&model, error))?;
    Ok(model)
}

/// Returns a text layer that is read by itself: one without arcs.
fn single(bytes: &[u8], path: &Path) -> Result<Option<Layer>, FormatError> {
    let Ok(text) = str::from_utf8(bytes) else { return Ok(None) };
    if crate::read::is_binary_usd(bytes) {
        return Ok(None);
    }
    let layer = Layer::of(text).map_err(|error| FormatError::of_content(path, bytes, error))?;
    Ok((!layer.has_arcs()).then_some(layer))
}

fn composed(
    bytes: Vec<u8>,
    path: &Path,
    options: &ReadOptions<'_>,
    model: &mut RobotModel,
) -> Result<Layer, FormatError> {
    let composed::Composed { layer, notes, sources, is_text } = composed::read(path, bytes, options)?;
    let mut sources = sources.into_iter();
    model.text = sources.next().map_or_else(String::new, |root| root.text);
    model.included = sources.collect();
    model.notes = notes;
    model.is_editable = is_text && !has_shared(&layer);
    Ok(layer)
}

/// Returns true if two prims have their values at one place: both are instances of one prim.
fn has_shared(layer: &Layer) -> bool {
    let mut places = HashSet::new();
    let masses = layer.prims.iter().filter_map(|prim| prim.properties.get(body::MASS));
    masses.into_iter().any(|mass| !places.insert(mass.span.clone()))
}

/// Fills the model from a layer; `bytes` is the length of its text.
fn fill(layer: &Layer, bytes: usize, model: &mut RobotModel) -> Result<(), ContentError> {
    model.name = layer.metadata.get("defaultPrim").and_then(|prim| prim.words.first().cloned());
    let units = Units::of(layer, &mut model.notes)?;
    model.is_si = units.are_si();
    elsewhere(layer, &mut model.notes);
    twice(layer, &mut model.notes);
    let stage = Stage::of(layer, units);
    let mut links = HashMap::new();
    let mut colliders: Vec<Colliders<'_>> = Vec::new();
    let mut meshes = Meshes::default();
    for (k, prim) in layer.prims.iter().enumerate() {
        if stage.is_body(k) {
            links.insert(k, model.links.len());
            if !prim.is_over {
                body::unapplied(prim, &mut model.notes);
            }
            let (link, is_computable) = body::link(&stage, k, prim, &mut model.notes);
            model.links.push(link);
            colliders.push(Colliders { body: is_computable.then_some(prim), shapes: Vec::new() });
        }
        let body = stage.body_around(k).filter(|_| !prim.is_abstract);
        let index = body.and_then(|body| links.get(&body)).copied();
        let link = index.and_then(|link: usize| Some((model.links.get_mut(link)?, colliders.get_mut(link)?)));
        let Some((link, own)) = link else {
            if !prim.is_abstract {
                unread::of(prim, &mut model.notes);
            }
            continue;
        };
        let changes = changing::of_shape(prim, &link.name.text, &mut model.notes);
        let frame = Pose::new(link.pose.position, link.pose.rotation);
        let is_collider = applies(prim, "PhysicsCollisionAPI") && !prim.is_off("physics:collisionEnabled");
        let geometry = match prim.kind.as_str() {
            "Mesh" => mesh::geometry(&stage, k, prim, &frame, &mut meshes),
            _ => shape::geometry(&stage, k, prim, &frame),
        };
        match geometry {
            Some(geometry) => {
                if is_collider {
                    own.shapes.push((k, link.geometry.len()));
                }
                link.geometry.push(geometry);
            }
            None if is_collider => own.without_shape(prim, link),
            None => {}
        }
        if is_collider && changes {
            own.without_shape(prim, link);
        }
        if let Some(why) = unread::of(prim, &mut model.notes) {
            own.body = None;
            if is_collider && link.inertial.is_none() {
                link.computed = Some(Err(why));
            }
        }
        if !stage.is_body(k) && body::has_mass(prim) {
            let changes = changing::of_mass(prim, &body::ATTRIBUTES, &mut model.notes);
            if changes.is_some() {
                own.body = None;
            } else if !is_collider {
                body::ignored(prim, &mut model.notes);
            }
        }
    }
    model.notes.extend(meshes.note());
    unread_shapes(model);
    for (link, own) in model.links.iter_mut().zip(&colliders) {
        own.compute(&stage, link, &mut model.notes);
    }
    let mut path_bytes = 0;
    for prim in layer.prims.iter().filter(|prim| !prim.is_abstract) {
        let Some(joint) = joint::joint(&stage, prim) else { continue };
        if let Some(why) = &joint.coordinate.unread {
            let note = Note::new("read.unknown", &joint.name.text, prim.span.clone(), why.clone());
            model.notes.push(Note { severity: Severity::Suspect, ..note });
        }
        let parent = joint.parent.as_ref().map_or(0, |parent| parent.text.len());
        path_bytes += joint.name.text.len() + joint.child.text.len() + parent;
        require_short(path_bytes, bytes, prim.span.clone())?;
        model.joints.push(joint);
    }
    Ok(())
}

/// Adds a shape without a size to each body with content that is not read: its other shapes may be
/// a small part of it.
fn unread_shapes(model: &mut RobotModel) {
    let links: HashMap<_, _> =
        model.links.iter().enumerate().map(|(k, link)| (link.name.text.clone(), k)).collect();
    let mut seen = HashSet::new();
    for note in model.notes.iter().filter(|note| note.code == "read.include") {
        let ancestors = note.subject.match_indices('/').skip(1).map(|(at, _)| &note.subject[..at]);
        let around =
            std::iter::once(note.subject.as_str()).chain(ancestors.collect::<Vec<_>>().into_iter().rev());
        let Some(k) = around.filter_map(|path| links.get(path)).next().filter(|k| seen.insert(**k)) else {
            continue;
        };
        let shape = GeometryShape::Other("content that is not read".to_owned());
        let geometry = Geometry { span: note.span.clone(), role: Role::Visual, pose: Pose::IDENTITY, shape };
        model.links.get_mut(*k).into_iter().for_each(|link| link.geometry.push(geometry.clone()));
    }
}

/// Reports repeated statements about bodies, joints, shapes and units. The last one counts, as in
/// OpenUSD.
fn twice(layer: &Layer, notes: &mut Vec<Note>) {
    const NAMES: [&str; 7] =
        ["metersPerUnit", "kilogramsPerUnit", "xformOpOrder", "size", "radius", "height", "axis"];
    let matters = |name: &str| {
        NAMES.contains(&name)
            || array::ARRAYS.contains(&name)
            || ["physics:", "physx", "xformOp:"].iter().any(|start| name.starts_with(start))
    };
    for (prim, name, span) in layer.twice.iter().filter(|(_, name, _)| matters(name)) {
        let message = format!("a second {name}: only the last one is read");
        let note = Note::new("read.twice", prim, span.clone(), message);
        notes.push(Note { severity: Severity::Suspect, ..note });
    }
}

/// Reports content that is not read.
fn elsewhere(layer: &Layer, notes: &mut Vec<Note>) {
    let own = layer.metadata.iter().map(|(key, value)| ("", key, value));
    let of_prims = layer
        .prims
        .iter()
        .flat_map(|prim| prim.metadata.iter().map(move |(key, value)| (prim.path.as_str(), key, value)));
    let mut found: Vec<_> = own
        .chain(of_prims)
        .filter(|(_, key, value)| ELSEWHERE.contains(&key.as_str()) && !value.words.is_empty())
        .map(|(subject, key, value)| {
            let named = value.words.join("");
            let message = format!("{key} = {named} is not read, so its content is unknown");
            Note::new("read.include", subject, value.span.clone(), message)
        })
        .collect();
    found.sort_by_key(|note| note.span.start);
    notes.extend(found);
    for span in &layer.variants {
        let message = "variant sets are not read: select a variant and flatten the stage".to_owned();
        notes.push(Note::new("read.left_out", "", span.clone(), message));
    }
}

/// Prims with their transforms on the stage.
struct Stage<'l> {
    layer: &'l Layer,
    units: Units,
    /// Transform of each prim in the stage, m.
    places: Vec<Affine>,
    /// Body that each prim belongs to: itself or an ancestor.
    bodies: Vec<Option<usize>>,
    /// Index of each prim by path.
    numbers: HashMap<&'l str, usize>,
}

impl<'l> Stage<'l> {
    fn of(layer: &'l Layer, units: Units) -> Self {
        let (mut places, mut bodies): (Vec<Affine>, Vec<Option<usize>>) = (Vec::new(), Vec::new());
        for (k, prim) in layer.prims.iter().enumerate() {
            let (own, resets) = Affine::of(prim, units.metres);
            let around = prim.parent.filter(|_| !resets);
            // Unreadable numbers of a body are reported for the body, and not for its descendants.
            let is_said = around.is_some_and(|parent| bodies.get(parent).copied().flatten().is_some());
            places.push(match around.and_then(|parent| places.get(parent)) {
                Some(around) if is_said => Affine { unreadable: own.unreadable.clone(), ..around.then(&own) },
                // One unreadable number of an ancestor is sufficient; thousands of descendants may
                // inherit it.
                Some(around) => {
                    let unreadable =
                        around.unreadable.iter().take(1).chain(&own.unreadable).cloned().collect();
                    let bare = Affine { unreadable: Vec::new(), ..*around };
                    Affine { unreadable, ..bare.then(&own) }
                }
                None => own,
            });
            let around = prim.parent.and_then(|parent| bodies.get(parent).copied().flatten());
            let is_rigid = applies(prim, "PhysicsRigidBodyAPI");
            let is_body = !prim.is_abstract && (is_rigid || around.is_none() && body::has_mass(prim));
            bodies.push(if is_body { Some(k) } else { around });
        }
        let numbers = layer.prims.iter().enumerate().map(|(k, prim)| (prim.path.as_str(), k)).collect();
        Self { layer, units, places, bodies, numbers }
    }

    fn is_body(&self, prim: usize) -> bool {
        self.body_around(prim) == Some(prim)
    }

    fn body_around(&self, prim: usize) -> Option<usize> {
        self.bodies.get(prim).copied().flatten()
    }

    /// Returns the pose of a prim in the frame of its body.
    fn pose_in_body(&self, prim: usize) -> Option<Pose> {
        let (_, body) = self.place(self.body_around(prim)?).scaled_pose()?;
        let (_, own) = self.place(prim).scaled_pose()?;
        Some(body.inverse().then(&own))
    }

    fn place(&self, prim: usize) -> Affine {
        self.places.get(prim).cloned().unwrap_or(Affine::IDENTITY)
    }
}

/// Returns true if a schema is applied to a prim.
fn applies(prim: &Prim, schema: &str) -> bool {
    prim.metadata.get("apiSchemas").is_some_and(|schemas| schemas.words.iter().any(|word| word == schema))
}
