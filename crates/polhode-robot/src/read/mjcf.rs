//! MJCF, MuJoCo's XML: bodies in bodies, sizes by halves, angles in degrees unless the file says otherwise, quaternions scalar first.
//!
//! What MuJoCo would do to an inertial after reading it (`balanceinertia`, `boundmass`, `boundinertia`, `settotalmass`) is a note, and
//! is not done. `<include>` is a note: the places of numbers are those of one text.
//!
//! Source: mujoco.readthedocs.io, XML Reference; the order of the operations where it says less is that of MuJoCo's compiler.

mod defaults;
mod settings;

use std::collections::HashMap;
use std::path::Path;

use polhode_formats::ContentError;

use crate::model::{
    Geometry, GeometryShape, Inertial, Joint, JointKind, Link, Name, Note, Number, Pose, RobotModel, Role,
    Slot, Span, Tensor,
};
use crate::pose::{direction, of_z_axis};
use crate::read::pose::Reading;
use crate::read::unread;
use crate::read::uri::Roots;
use crate::read::xml::{Element, Written, slot};
use defaults::{Classes, Source};
use settings::{FromGeometry, Settings};

/// Fills the model with what the root says.
pub(super) fn read(root: Element<'_>, roots: &Roots, model: &mut RobotModel) -> Result<(), ContentError> {
    model.name = root.word("model").map(str::to_owned);
    let settings = Settings::of(root, &mut model.notes);
    let classes = Classes::of(root);
    let meshes = meshes(root, &classes, &settings, roots);
    let mut reader =
        Reader { settings, classes, meshes, jointed: Vec::new(), frames_in_parents: Vec::new(), model };
    let worlds: Vec<_> = root.named("worldbody").collect();
    for world in worlds.into_iter().chain((root.name() == "mujocoinclude").then_some(root)) {
        reader.tree(world);
    }
    reader.finish();
    Ok(())
}

/// Mesh files by the names of their assets: the name and place of the file, where it is, its scale, and the frame that the file's
/// vertices are given in.
type Meshes<'a> = HashMap<&'a str, GeometryShape>;

fn meshes<'a>(
    root: Element<'a>,
    classes: &Classes<'a>,
    settings: &Settings<'a>,
    roots: &Roots,
) -> Meshes<'a> {
    let mut meshes = HashMap::new();
    for mesh in root.named("asset").flat_map(|asset| asset.children().filter(|child| child.name() == "mesh"))
    {
        let source = classes.mesh(mesh);
        let Some(file) = mesh.attribute("file") else {
            if let Some(name) = mesh.word("name") {
                meshes.insert(name, GeometryShape::Other("a mesh without a file".to_owned()));
            }
            continue;
        };
        let base = file.value.rsplit(['/', '\\']).next().unwrap_or(file.value);
        let stem = base.rsplit_once('.').map_or(base, |(stem, _)| stem);
        let written = if settings.strip_path { base } else { file.value };
        let shape = if source.written("refpos").is_some() || source.written("refquat").is_some() {
            GeometryShape::Other("a mesh with refpos or refquat".to_owned())
        } else {
            GeometryShape::Mesh {
                uri: file.name(),
                path: roots.resolve(written, Path::new(settings.mesh_folder)),
                scale: source
                    .written("scale")
                    .map_or([1.0; 3], |scale| scale.array().unwrap_or([f64::NAN; 3])),
            }
        };
        meshes.insert(mesh.word("name").unwrap_or(stem), shape);
    }
    meshes
}

/// A body or a frame of a body on the way down the tree.
#[derive(Clone)]
struct Branch<'a> {
    element: Element<'a>,
    /// The body that what stands in it belongs to; `None` for the world.
    link: Option<usize>,
    /// Its frame in that body's.
    frame: Pose,
    /// The class of what names none.
    class: Option<&'a str>,
}

struct Reader<'a, 'm> {
    settings: Settings<'a>,
    classes: Classes<'a>,
    meshes: Meshes<'a>,
    /// For each link, the link above it, and whether it has a joint.
    jointed: Vec<(Option<usize>, bool)>,
    /// For each link, its frame in that of the link above it.
    frames_in_parents: Vec<Pose>,
    model: &'m mut RobotModel,
}

impl<'a> Reader<'a, '_> {
    /// Reads what stands below an element, in the order of the file.
    fn tree(&mut self, world: Element<'a>) {
        let class = world.word("childclass");
        let mut branches = vec![Branch { element: world, link: None, frame: Pose::IDENTITY, class }];
        while let Some(branch) = branches.pop() {
            let branch = match branch.element.name() {
                "body" => self.body(&branch),
                "frame" => self.frame(&branch),
                _ => branch,
            };
            let first = branches.len();
            for child in branch.element.children() {
                match child.name() {
                    "body" | "frame" => branches.push(Branch { element: child, ..branch.clone() }),
                    "geom" => self.geom(child, &branch),
                    "joint" | "freejoint" => self.joint(child, &branch),
                    "composite" | "flexcomp" | "replicate" | "attach" | "include" => {
                        self.left_out(child, &branch);
                    }
                    _ => {}
                }
            }
            if let Some(later) = branches.get_mut(first..) {
                later.reverse();
            }
        }
    }

    /// What stands in a `<frame>`: its own place and class, and the body around it.
    fn frame(&self, branch: &Branch<'a>) -> Branch<'a> {
        let element = branch.element;
        let pose = self.pose(element, &Source::of(element));
        let class = element.word("childclass").or(branch.class);
        Branch { frame: branch.frame.then(&pose), class, ..branch.clone() }
    }

    /// Takes up a body that stands in a branch.
    fn body(&mut self, branch: &Branch<'a>) -> Branch<'a> {
        let element = branch.element;
        let start = element.span().start;
        let index = self.model.links.len();
        let name = element.attribute("name").map_or_else(
            || Name { text: format!("body {}", index + 1), span: start..start + 1 },
            |name| name.name(),
        );
        let in_parent = branch.frame.then(&self.pose(element, &Source::of(element)));
        let parent = branch.link.and_then(|link| self.model.links.get(link));
        let pose = parent
            .map_or(Pose::IDENTITY, |parent| Pose::new(parent.pose.position, parent.pose.rotation))
            .then(&in_parent);
        unread::mjcf(element, &name.text, &mut self.model.notes);
        let given = element.child("inertial");
        let computed = match self.settings.from_geometry {
            FromGeometry::Never => false,
            FromGeometry::Auto => given.is_none(),
            FromGeometry::Always => true,
        };
        let inertial = given.filter(|_| !computed).map(|given| self.inertial(given, &name.text));
        self.model.links.push(Link {
            name,
            span: element.span(),
            inertial,
            geometry: Vec::new(),
            pose,
            is_static: false,
            from_geometry: computed,
        });
        self.jointed.push((branch.link, false));
        self.frames_in_parents.push(in_parent);
        let class = element.word("childclass").or(branch.class);
        Branch { element, link: Some(index), frame: Pose::IDENTITY, class }
    }

    fn inertial(&mut self, element: Element<'a>, link: &str) -> Inertial {
        let tensor = if let Some(full) = element.attribute("fullinertia") {
            // the order of the file is that of Tensor::Six
            Tensor::Six(Box::new(self.slots(&full, ["M11", "M22", "M33", "M12", "M13", "M23"], link)))
        } else if let Some(diagonal) = element.attribute("diaginertia") {
            Tensor::Diagonal(Box::new(self.slots(
                &diagonal,
                ["diaginertia 1", "diaginertia 2", "diaginertia 3"],
                link,
            )))
        } else {
            Tensor::Missing(element.span())
        };
        let mass = slot(element, "mass");
        let pose = self.pose(element, &Source::of(element));
        Inertial { span: element.span(), mass, pose, tensor }
    }

    /// The numbers of an attribute; one that is not there is missing, and one too many is a note.
    fn slots<const N: usize>(&mut self, written: &Written<'a>, names: [&str; N], link: &str) -> [Slot; N] {
        let mut numbers = written.numbers();
        let slots = names.map(|name| match numbers.next() {
            Some(number) => Slot::Given(number),
            None => Slot::Missing { span: written.span.clone(), name: name.to_owned() },
        });
        if let Some(Number { span, .. }) = numbers.next() {
            let span = span.start..written.span.end.max(span.end);
            self.note("read.numbers", link, span, format!("more than {N} numbers: MuJoCo refuses them"));
        }
        slots
    }

    fn geom(&mut self, element: Element<'a>, branch: &Branch<'a>) {
        let Some(index) = branch.link else { return }; // the world's own
        let source = self.classes.geom(element, branch.class);
        let zero = |name: &str| source.word(name).is_some_and(|word| word.parse() == Ok(0_i64));
        let role = if zero("contype") && zero("conaffinity") { Role::Visual } else { Role::Collision };
        let ends = source.written("fromto").map(|written| written.array().unwrap_or([f64::NAN; 6]));
        let pose = match ends {
            Some(ends) => along(ends),
            None => self.pose(element, &source),
        };
        let shape = self.shape(&source, ends);
        let span = element.span();
        if let Some(link) = self.model.links.get_mut(index) {
            link.geometry.push(Geometry { span, role, pose: branch.frame.then(&pose), shape });
        }
    }

    fn shape(&self, source: &Source<'_, 'a>, ends: Option<[f64; 6]>) -> GeometryShape {
        let mut sizes = source.values("size");
        if let Some([ax, ay, az, bx, by, bz]) = ends {
            // radius, and half the length between the ends; a box or ellipsoid is as wide as it is deep
            let half = 0.5 * [bx - ax, by - ay, bz - az].iter().map(|c| c * c).sum::<f64>().sqrt();
            let width = sizes.first().copied().unwrap_or(f64::NAN);
            sizes = match source.word("type") {
                Some("box" | "ellipsoid") => vec![width, width, half],
                _ => vec![width, half],
            };
        }
        let size = |k: usize| sizes.get(k).copied().unwrap_or(f64::NAN);
        let mesh = source.word("mesh");
        match (source.word("type").unwrap_or("sphere"), mesh) {
            ("mesh", Some(name)) => self.meshes.get(name).cloned().unwrap_or_else(|| {
                GeometryShape::Other(format!("the mesh {name:?}, which this file does not have"))
            }),
            (kind @ ("box" | "sphere" | "cylinder" | "capsule" | "ellipsoid"), Some(_)) => {
                GeometryShape::Other(format!("a {kind} fitted to a mesh"))
            }
            ("box", None) => GeometryShape::Box([0, 1, 2].map(|k| 2.0 * size(k))),
            ("sphere", None) => GeometryShape::Sphere(size(0)),
            ("cylinder", None) => GeometryShape::Cylinder { radius: size(0), length: 2.0 * size(1) },
            ("capsule", None) => GeometryShape::Capsule { radius: size(0), length: 2.0 * size(1) },
            ("ellipsoid", None) => GeometryShape::Ellipsoid([0, 1, 2].map(size)),
            (other, _) => GeometryShape::Other(other.to_owned()),
        }
    }

    fn joint(&mut self, element: Element<'a>, branch: &Branch<'a>) {
        let Some(index) = branch.link else { return };
        let source = self.classes.joint(element, branch.class);
        let kind = match (element.name(), source.word("type")) {
            ("freejoint", _) | (_, Some("free")) => JointKind::Free,
            (_, None | Some("hinge")) => JointKind::Revolute,
            (_, Some("slide")) => JointKind::Prismatic,
            _ => JointKind::Other,
        };
        let three = |name: &str, default| {
            source.written(name).map_or(default, |written| written.array().unwrap_or([f64::NAN; 3]))
        };
        let anchor = branch.frame.placed(three("pos", [0.0; 3]));
        let axis = branch.frame.turned(three("axis", [0.0, 0.0, 1.0]));
        if let Some((_, jointed)) = self.jointed.get_mut(index) {
            *jointed = true;
        }
        let start = element.span().start;
        let name = element.attribute("name").map_or_else(
            || Name { text: format!("joint {}", self.model.joints.len() + 1), span: start..start + 1 },
            |name| name.name(),
        );
        self.hang(index, name, element.span(), kind, axis, anchor);
    }

    /// Joins a link to the one above it.
    fn hang(
        &mut self,
        index: usize,
        name: Name,
        span: Span,
        kind: JointKind,
        axis: [f64; 3],
        anchor: [f64; 3],
    ) {
        let parent = self.jointed.get(index).and_then(|(parent, _)| *parent);
        let name_of = |link: usize| self.model.links.get(link).map(|link| link.name.clone());
        let Some(child) = name_of(index) else { return };
        let pose = self.frames_in_parents.get(index).cloned().unwrap_or(Pose::IDENTITY);
        let parent = parent.and_then(name_of);
        self.model.joints.push(Joint { name, span, kind, parent, child, pose, axis, anchor });
    }

    /// Fixes what has no joint, and puts everything in the order of the file.
    fn finish(&mut self) {
        for index in 0..self.jointed.len() {
            if self.jointed.get(index).is_some_and(|(_, jointed)| *jointed) {
                continue;
            }
            let Some(link) = self.model.links.get(index) else { continue };
            let span = link.span.clone();
            let name = Name { text: format!("{} (fixed)", link.name.text), span: span.start..span.start + 1 };
            self.hang(index, name, span, JointKind::Fixed, [0.0, 0.0, 1.0], [0.0; 3]);
        }
        self.model.joints.sort_by_key(|joint| joint.span.start);
        for link in &mut self.model.links {
            link.geometry.sort_by_key(|geometry| geometry.span.start);
            // without geoms there is nothing to compute it from
            link.from_geometry &= !link.geometry.is_empty();
        }
    }

    /// `pos`, and the attitude in one of its five forms.
    fn pose(&self, element: Element<'a>, source: &Source<'_, 'a>) -> Pose {
        let mut reading = Reading::default();
        let position = reading.numbers(source.written("pos").as_ref(), [0.0; 3]);
        // the element's own form goes before one of its class
        let own = Source::of(element);
        let rotation = self.settings.attitude(&mut reading, &own);
        let rotation = rotation.or_else(|| self.settings.attitude(&mut reading, source));
        reading.pose(position, rotation.unwrap_or(Pose::IDENTITY.rotation))
    }

    fn left_out(&mut self, element: Element<'a>, branch: &Branch<'a>) {
        let subject = branch
            .link
            .and_then(|link| self.model.links.get(link))
            .map_or("", |link| &link.name.text)
            .to_owned();
        let message = format!("<{}> is not read: what it makes is not checked", element.name());
        let code = if element.name() == "include" { "read.include" } else { "read.left_out" };
        self.note(code, &subject, element.span(), message);
    }

    fn note(&mut self, code: &'static str, subject: &str, span: Span, message: String) {
        self.model.notes.push(Note::new(code, subject, span, message));
    }
}

/// The frame in the middle between two points, its z axis from the second to the first.
fn along([ax, ay, az, bx, by, bz]: [f64; 6]) -> Pose {
    let middle = [0.5 * (ax + bx), 0.5 * (ay + by), 0.5 * (az + bz)];
    let axis = direction([ax - bx, ay - by, az - bz]).unwrap_or([0.0, 0.0, 1.0]);
    let finite = middle.iter().all(|c| c.is_finite());
    Pose::new(if finite { middle } else { [0.0; 3] }, of_z_axis(axis).unwrap_or(Pose::IDENTITY.rotation))
}
