//! 3MF, the 3D Manufacturing Format: XML in a ZIP archive.
//!
//! A package contains a model with objects and a build. An object is a mesh or a list of placed
//! objects; the build is the list of placed objects to be made. Every mesh in the build is a part,
//! once for each placement. The file states its unit of length; the default is the millimetre.
//!
//! Objects of types other than `model` (supports, surfaces) do not belong to the solid and are
//! skipped, with a finding. A placement that mirrors reverses the winding, so that outside stays
//! outside. The production extension (objects in other model files of the same package) is
//! supported. Materials are ignored. A model that requires an extension that changes shapes
//! (slices, beam lattices, volumes) is refused by name.
//!
//! The XML is decompressed while it is read, and is not stored. The sizes of the decompressed data
//! and of the placed meshes are limited to multiples of the file size (see `budget.rs`). Nothing is
//! written to disk.
//!
//! Source: 3MF Consortium, Core Specification, version 1.3; Production Extension, version 1.1.

mod model;

use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use polhode::body::Severity;
use polhode_source::package::archive::{Archive, key};
use polhode_source::package::relation::relations;
use polhode_source::package::unfolding::Budget;
use polhode_source::package::xml::Xml;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::affine::Affine;
use super::notes::Notes;
use super::{MeshContents, MeshPart};
use model::{Contents, Model, Use};

/// Reads the bytes of a 3MF file.
///
/// ```
/// use std::io::Write;
/// use polhode_shape::mesh::threemf::read;
/// use zip::write::{SimpleFileOptions, ZipWriter};
///
/// let model = br#"<model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
///   <resources><object id="7" name="flake"><mesh>
///     <vertices><vertex x="0" y="1" z="0"/><vertex x="3" y="0" z="0"/><vertex x="5" y="0" z="2"/></vertices>
///     <triangles><triangle v1="0" v2="1" v3="2"/></triangles>
///   </mesh></object></resources>
///   <build><item objectid="7" transform="1 0 0 0 1 0 0 0 1 0 0 10"/></build>
/// </model>"#;
/// let mut zip = ZipWriter::new(std::io::Cursor::new(Vec::new()));
/// zip.start_file("3D/3dmodel.model", SimpleFileOptions::default())?;
/// zip.write_all(model)?;
/// let contents = read(&zip.finish()?.into_inner())?;
/// assert_eq!((contents.unit, contents.parts[0].name.as_str()), (Some(0.0254), "flake"));
/// let corners = contents.parts[0].mesh.corners().next();
/// assert_eq!(corners, Some([[0.0, 1.0, 10.0], [3.0, 0.0, 10.0], [5.0, 0.0, 12.0]]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ContentError`] for bytes that are not a 3MF package, a damaged or malicious archive, an
/// inconsistent model, a required extension that is not supported, and a build without triangles.
pub fn read(bytes: &[u8]) -> Result<MeshContents, ContentError> {
    let mut package = Package {
        archive: Archive::open(bytes)?,
        models: Vec::new(),
        numbers: HashMap::new(),
        budget: Budget::placing(bytes.len() as u64),
        notes: Notes::default(),
        parts: Vec::new(),
    };
    let root = package.root()?;
    package.model(&root)?;
    package.build()?;
    if package.parts.is_empty() {
        let kind = ContentErrorKind::missing("triangles in its build");
        return Err(kind.of_whole().hint("export the solid, not an empty build plate"));
    }
    let Model { unit: (_, unit), title, .. } = package.models.swap_remove(0).1;
    let (parts, findings) = (package.parts, package.notes.findings());
    Ok(MeshContents { encoding: "zip", name: title.trim().to_owned(), unit: Some(unit), parts, findings })
}

/// State of the reader.
struct Package<'a> {
    archive: Archive<'a>,
    /// Model files and their names, the root first.
    models: Vec<(String, Model)>,
    /// Index of each model file, by [`key`].
    numbers: HashMap<String, usize>,
    budget: Budget,
    notes: Notes,
    parts: Vec<MeshPart>,
}

/// Identifier of an object: index of its model file, and its id in that file.
type Id = (usize, u32);

/// Line that refers to an object: index of the model file, and line number.
type Line = (usize, usize);

/// Pending step of the traversal of the components.
enum Step {
    /// Places an object that is referred to by a line.
    Enter { id: Id, map: Affine, asked: Line },
    /// The object is complete.
    Leave(Id),
}

impl Package<'_> {
    /// Returns the name of the root model file.
    fn root(&mut self) -> Result<String, ContentError> {
        const RELATIONSHIPS: &str = "_rels/.rels";
        const MODEL: &str = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
        let all = relations(&mut self.archive, RELATIONSHIPS)?;
        let root = all.into_iter().find(|relation| relation.kind == MODEL);
        Ok(root.map_or_else(|| "3D/3dmodel.model".to_owned(), |root| root.target))
    }

    /// Returns the index of a model file, which is read when it is first needed.
    fn model(&mut self, path: &str) -> Result<usize, ContentError> {
        if let Some(&number) = self.numbers.get(&key(path)) {
            return Ok(number);
        }
        let name = path.strip_prefix('/').unwrap_or(path).to_owned();
        let model = Model::read(Xml::new(self.archive.stream(&name)?, &name), &mut self.notes)?;
        if let Some((first, root)) = self.models.first().filter(|(_, root)| root.unit != model.unit) {
            let (what, value) = ("unit", model.unit.0.to_owned());
            let rule = format!("{}, the unit of {first}", root.unit.0);
            let kind = ContentErrorKind::value(what, value, rule);
            return Err(ContentError::new(kind, ContentPlace::Within(name)));
        }
        self.models.push((name, model));
        self.numbers.insert(key(path), self.models.len() - 1);
        Ok(self.models.len() - 1)
    }

    /// Places everything in the build of the root model, in file order.
    fn build(&mut self) -> Result<(), ContentError> {
        let mut above: HashSet<Id> = HashSet::new();
        for item in 0..self.models[0].1.items.len() {
            let used = self.models[0].1.items[item].clone();
            let mut steps = vec![self.step(0, &used, &Affine::IDENTITY)?];
            while let Some(step) = steps.pop() {
                match step {
                    Step::Leave(id) => {
                        above.remove(&id);
                    }
                    Step::Enter { id, map, asked } => {
                        let components = self.enter(id, &map, &used, asked)?;
                        if components.is_empty() {
                            continue;
                        }
                        if !above.insert(id) {
                            let (what, value) = ("the component", format!("object {}", id.1));
                            let rule = "acyclic: it contains itself";
                            return Err(self.error(asked, ContentErrorKind::value(what, value, rule)));
                        }
                        steps.push(Step::Leave(id));
                        for component in components.iter().rev() {
                            steps.push(self.step(id.0, component, &map)?);
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Returns the step for a build item or a component.
    fn step(&mut self, from: usize, used: &Use, above: &Affine) -> Result<Step, ContentError> {
        let asked = (from, used.line);
        self.budget.spend(1, size_of::<Step>(), || place(&self.models, asked))?;
        let number = match &used.path {
            None => from,
            Some(path) if self.archive.has(path) => self.model(path)?,
            Some(path) => {
                let (what, value) = ("path", path.clone());
                let rule = "a model file of the package";
                return Err(self.error(asked, ContentErrorKind::value(what, value, rule)));
            }
        };
        Ok(Step::Enter { id: (number, used.object), map: above.after(&used.transform), asked })
    }

    /// Places an object that is a mesh, or returns its components; `item` is the build item that it
    /// belongs to.
    fn enter(&mut self, id: Id, map: &Affine, item: &Use, asked: Line) -> Result<Rc<[Use]>, ContentError> {
        let (file, model) = &self.models[id.0];
        let place = || place(&self.models, asked);
        let Some(object) = model.objects.get(&id.1) else {
            let (what, value) = ("objectid", id.1.to_string());
            let rule = format!("the id of an object in {file}");
            return Err(self.error(asked, ContentErrorKind::value(what, value, rule)));
        };
        if object.kind != "model" {
            const SENTENCE: [&str; 2] = [
                "an object is not part of the solid (its type is not model) and was ignored",
                "objects are not part of the solid (their type is not model) and were ignored",
            ];
            self.notes.add("mesh.not_a_solid", Severity::Info, SENTENCE, place);
            return Ok(Rc::default());
        }
        match &object.contents {
            Contents::Components(components) => Ok(components.clone()),
            Contents::Mesh { vertices, triangles } if !triangles.is_empty() => {
                let whole = self.models[0].1.objects.get(&item.object).filter(|_| item.path.is_none());
                let names =
                    [&object.name, whole.map_or(&item.part_number, |whole| &whole.name), &item.part_number];
                let name = names.into_iter().find(|name| !name.is_empty()).cloned().unwrap_or_default();
                self.budget.spend(1, size_of::<MeshPart>() + name.len(), place)?;
                self.budget.spend(vertices.len(), size_of::<[f64; 3]>(), place)?;
                self.budget.spend(triangles.len(), size_of::<[u32; 3]>(), place)?;
                let mesh = map.placed(vertices, triangles, place)?;
                self.parts.push(MeshPart { name, mesh });
                Ok(Rc::default())
            }
            Contents::Mesh { .. } | Contents::Nothing => Ok(Rc::default()),
        }
    }

    fn error(&self, asked: Line, kind: ContentErrorKind) -> ContentError {
        ContentError::new(kind, ContentPlace::Within(place(&self.models, asked)))
    }
}

/// Returns the location of a line in a model file.
fn place(models: &[(String, Model)], (model, line): Line) -> String {
    format!("{}, line {line}", models[model].0)
}
