//! MJCF, the XML format of MuJoCo: nested bodies, half sizes, angles in degrees by default,
//! quaternions with the scalar first.
//!
//! Masses are those that MuJoCo's compiler computes ([`crate::model::Link::computed`]), if they
//! differ from the inertial.
//!
//! Source: mujoco.readthedocs.io, XML Reference; MuJoCo's compiler for the order of operations.

mod armature;
mod attach;
mod attributes;
mod builtin;
mod compiler;
mod context;
mod defaults;
mod equality;
mod field;
mod geom;
mod inertial;
mod joint;
mod mass;
mod measure;
mod mesh;
mod replicate;
mod surface;

use std::collections::HashMap;
use std::path::PathBuf;
use std::rc::Rc;

use polhode_source::ContentError;
use polhode_source::files::Files;

use crate::finding::Severity;
use crate::model::{Link, Name, Note, Pose, RobotModel, Span, UnreadBodies};
use crate::read::pose::Reading;
use crate::read::unread;
use crate::read::uri::Roots;
use crate::read::xml::Element;
use compiler::FromGeometry;
use context::Context;
use defaults::Source;
use equality::Origin;
use mass::BodyMass;
use mesh::Solid;

/// Fills the model from the root element.
pub(super) fn read(
    root: Element<'_>,
    folders: &[PathBuf],
    roots: &Roots<'_>,
    model: &mut RobotModel,
) -> Result<(), ContentError> {
    model.name = root.word("model").map(str::to_owned);
    let blind = model.notes.iter().any(|note| note.code == "read.include");
    let contexts = context::all(root, folders, roots, &mut model.notes);
    Reader::new(roots.files, &contexts, model).read(root, blind)
}

/// Position in the traversal of the element tree.
#[derive(Clone)]
struct Branch<'a> {
    element: Element<'a>,
    /// Index of the context of its model.
    context: usize,
    /// Enclosing body; `None` for the world.
    link: Option<usize>,
    /// Frame of the element in that body's frame.
    frame: Pose,
    /// Default class of elements that name none.
    class: Option<&'a str>,
    /// Prefix and suffix of names.
    prefix: Rc<str>,
    suffix: Rc<str>,
    /// Index of its copy or attached model in [`Reader::origins`].
    origin: usize,
}

impl Branch<'_> {
    /// Returns a name with prefix and suffix, as in the whole model.
    fn name(&self, name: Name) -> Name {
        Name { text: format!("{}{}{}", self.prefix, name.text, self.suffix), ..name }
    }
}

struct Reader<'c, 'a, 'm> {
    files: &'c dyn Files,
    contexts: &'c [Context<'a>],
    solids: HashMap<(usize, String), Result<Rc<Solid>, String>>,
    /// Number of points of the meshes that MuJoCo generates.
    made_points: usize,
    /// Parent of each link, and true if the link has a joint.
    jointed: Vec<(Option<usize>, bool)>,
    /// Frame of each link in its parent's frame.
    frames_in_parents: Vec<Pose>,
    masses: Vec<BodyMass>,
    /// Element number of each joint, for sorting; the next field has that of each link.
    joint_order: Vec<usize>,
    link_order: Vec<usize>,
    /// Number of elements so far; the next field has the total bytes of their names.
    elements: usize,
    name_bytes: usize,
    /// Models whose bodies are read, and their copies; the next field has the origin of each joint.
    origins: Vec<Origin>,
    joint_origins: Vec<usize>,
    /// Reason why bodies are missing.
    incomplete: Option<String>,
    /// True if an `<include>` could not be read, so that settings may be missing.
    is_blind: bool,
    model: &'m mut RobotModel,
}

impl<'c, 'a, 'm> Reader<'c, 'a, 'm> {
    fn new(files: &'c dyn Files, contexts: &'c [Context<'a>], model: &'m mut RobotModel) -> Self {
        Self {
            files,
            contexts,
            solids: HashMap::new(),
            made_points: 0,
            jointed: Vec::new(),
            frames_in_parents: Vec::new(),
            masses: Vec::new(),
            joint_order: Vec::new(),
            link_order: Vec::new(),
            elements: 0,
            name_bytes: 0,
            origins: vec![Origin { context: 0, prefix: Rc::from(""), suffix: Rc::from(""), within: None }],
            joint_origins: Vec::new(),
            incomplete: None,
            is_blind: false,
            model,
        }
    }

    fn read(mut self, root: Element<'a>, blind: bool) -> Result<(), ContentError> {
        // Files that include this one may provide its defaults.
        self.is_blind = blind || root.name() == "mujocoinclude";
        if root.name() == "mujocoinclude" {
            self.tree(root)?; // with or without a <worldbody> in it
        } else {
            for world in root.named("worldbody") {
                self.tree(world)?;
            }
        }
        self.fix_the_rest(root)?;
        equality::couple(self.contexts, &self.origins, &self.joint_origins, &mut self.model.joints);
        armature::add(self.contexts, &self.origins, &self.joint_origins, &mut self.model.joints);
        let settings: Vec<_> = self.contexts.iter().map(|context| &context.settings).collect();
        let blind = blind.then_some("an <include> could not be read");
        mass::compile(&mut self.model.links, self.masses, &settings, self.incomplete, blind);
        Ok(())
    }

    /// Reads the content of an element, in file order.
    fn tree(&mut self, world: Element<'a>) -> Result<(), ContentError> {
        let class = world.word("childclass");
        let (prefix, suffix) = (Rc::from(""), Rc::from(""));
        let mut branches = vec![Branch {
            element: world,
            context: 0,
            link: None,
            frame: Pose::IDENTITY,
            class,
            prefix,
            suffix,
            origin: 0,
        }];
        while let Some(branch) = branches.pop() {
            self.elements += 1;
            self.require_few(branch.element)?;
            let first = branches.len();
            if matches!(branch.element.name(), "body" | "frame" | "replicate" | "geom" | "joint") {
                self.require_class(&branch);
            }
            match branch.element.name() {
                "body" => Self::below(&self.body(&branch), &mut branches),
                "frame" => Self::below(&self.frame(&branch), &mut branches),
                "replicate" => self.replicate(&branch, &mut branches)?,
                "attach" => self.attach(&branch, &mut branches),
                "geom" => self.add_geom(&branch),
                "joint" | "freejoint" => self.joint(&branch),
                "composite" | "flexcomp" => self.generator(&branch),
                "include" => self.left_out(&branch),
                "worldbody" | "mujocoinclude" => Self::below(&branch, &mut branches),
                _ => {}
            }
            if let Some(later) = branches.get_mut(first..) {
                later.reverse();
            }
        }
        Ok(())
    }

    /// Reports an unknown default class. MuJoCo rejects it, and its attributes are unknown.
    fn require_class(&mut self, branch: &Branch<'a>) {
        let context = self.contexts.get(branch.context).filter(|_| !self.is_blind);
        let Some(written) = context.and_then(|context| context.classes.unknown(branch.element)) else {
            return;
        };
        let subject = self.name_of(branch.link).to_owned();
        let message =
            format!("the default class {:?} does not exist: MuJoCo refuses the file", written.value);
        if let Some(body) = branch.link.and_then(|link| self.masses.get_mut(link)) {
            body.unknown.get_or_insert(format!("the default class {:?} does not exist", written.value));
        }
        self.suspect("read.unknown", &subject, written.span, message);
    }

    /// Adds the children of a branch, in order.
    fn below(branch: &Branch<'a>, branches: &mut Vec<Branch<'a>>) {
        branches.extend(branch.element.children().map(|element| Branch { element, ..branch.clone() }));
    }

    /// Returns the branch of a `<frame>`, with its pose and class and the enclosing body.
    fn frame(&self, branch: &Branch<'a>) -> Branch<'a> {
        let element = branch.element;
        let pose = self.pose(element, &Source::of(element), branch.context);
        let class = element.word("childclass").or(branch.class);
        let mut frame = branch.frame.then(&pose);
        frame.unreadable = branch.frame.unreadable.iter().chain(&pose.unreadable).take(1).cloned().collect();
        Branch { frame, class, ..branch.clone() }
    }

    /// Adds a body of a branch.
    fn body(&mut self, branch: &Branch<'a>) -> Branch<'a> {
        let element = branch.element;
        let number = self.model.links.len() + 1;
        let name = element
            .attribute("name")
            .map_or_else(|| made_up(format!("body {number}"), element), |name| branch.name(name.name()));
        self.name_bytes += name.text.len();
        let own = self.pose(element, &Source::of(element), branch.context);
        let position = own.position;
        let mut in_parent = branch.frame.then(&own);
        in_parent.unreadable.extend(branch.frame.unreadable.iter().cloned());
        let pose = self.pose_of(branch.link).then(&in_parent);
        unread::mjcf(element, &name.text, &mut self.model.notes);
        let given = inertial::of(element);
        let from_geometry = self.contexts.get(branch.context).map(|context| context.settings.from_geometry);
        let from_geoms = match from_geometry {
            None | Some(FromGeometry::Never) => false,
            Some(FromGeometry::Auto) => given.is_none(),
            Some(FromGeometry::Always) => true,
        };
        let inertial = given.map(|given| self.inertial(given, &name.text, branch.context));
        let (inertial, instead) = if from_geoms { (None, inertial) } else { (inertial, None) };
        let link = Link {
            name,
            span: element.span(),
            inertial,
            geometry: Vec::new(),
            pose,
            is_static: false,
            from_geometry: from_geoms,
            computed: None,
        };
        let context = branch.context;
        let mass = BodyMass { context, from_geoms, inertial: instead, position, ..Default::default() };
        let index = self.model.links.len();
        self.model.links.push(link);
        self.masses.push(mass);
        self.jointed.push((branch.link, false));
        self.frames_in_parents.push(in_parent);
        self.link_order.push(self.elements);
        let class = element.word("childclass").or(branch.class);
        Branch { link: Some(index), frame: Pose::IDENTITY, class, ..branch.clone() }
    }

    fn add_geom(&mut self, branch: &Branch<'a>) {
        let Some(index) = branch.link else { return }; // geom of the world
        let weighs = self.masses.get(index).is_some_and(|body| body.from_geoms);
        let Some(geom) = self.geom(branch.element, branch, weighs) else { return };
        if let Some(link) = self.model.links.get_mut(index) {
            link.geometry.push(geom.geometry);
        }
        let Some(body) = self.masses.get_mut(index) else { return };
        match geom.mass {
            Ok(part) => body.parts.extend(part),
            Err(why) => {
                body.unknown.get_or_insert(why);
            }
        }
    }

    /// Returns the frame of a link in the model's frame; the identity for the world.
    fn pose_of(&self, link: Option<usize>) -> Pose {
        let link = link.and_then(|link| self.model.links.get(link));
        link.map_or(Pose::IDENTITY, |link| Pose::new(link.pose.position, link.pose.rotation))
    }

    /// Returns the pose: `pos`, and the attitude in one of its five forms.
    fn pose(&self, element: Element<'a>, source: &Source<'_, 'a>, context: usize) -> Pose {
        let mut reading = Reading::default();
        let position = reading.numbers(source.written("pos").as_ref(), [0.0; 3]);
        let Some(context) = self.contexts.get(context) else {
            return reading.pose(position, Pose::IDENTITY.rotation);
        };
        // The element's own attitude takes precedence over that of its class.
        let own = Source::of(element);
        let rotation = context.settings.attitude(&mut reading, &own);
        let rotation = rotation.or_else(|| context.settings.attitude(&mut reading, source));
        reading.pose(position, rotation.unwrap_or(Pose::IDENTITY.rotation))
    }

    /// Marks the mass as unknown after an `<include>` that could not be read; it may contain an
    /// inertial or geoms.
    fn left_out(&mut self, branch: &Branch<'a>) {
        if let Some(body) = branch.link.and_then(|link| self.masses.get_mut(link)) {
            body.unknown.get_or_insert("an <include> in it could not be read".to_owned());
        }
    }

    /// Reports an element from which MuJoCo generates bodies, none of which is read.
    fn generator(&mut self, branch: &Branch<'a>) {
        self.not_made(branch, "save the compiled model (MuJoCo: mj_saveLastXML), and check that file");
        let (element, span) = (branch.element.name().to_owned(), branch.element.span());
        let link = branch.link.map(|link| self.name_of(Some(link)).to_owned());
        self.model.unread_bodies.push(UnreadBodies { element, link, span });
    }

    /// Reports that the bodies of an element are missing.
    fn not_made(&mut self, branch: &Branch<'a>, why: &str) {
        let what = branch.element.name();
        self.incomplete = Some(format!("<{what}> is not read"));
        let subject = self.name_of(branch.link).to_owned();
        let message = format!("<{what}> is not read, and its result is not checked: {why}");
        self.note("read.left_out", &subject, branch.element.span(), message);
    }

    /// Returns the name of a link; empty for the world.
    fn name_of(&self, link: Option<usize>) -> &str {
        link.and_then(|link| self.model.links.get(link)).map_or("", |link| &link.name.text)
    }

    fn suspect(&mut self, code: &'static str, subject: &str, span: Span, message: String) {
        self.note(code, subject, span, message);
        if let Some(note) = self.model.notes.last_mut() {
            note.severity = Severity::Suspect;
        }
    }

    fn note(&mut self, code: &'static str, subject: &str, span: Span, message: String) {
        self.name_bytes += subject.len();
        self.model.notes.push(Note::new(code, subject, span, message));
    }
}

/// Returns a generated name for an element without one.
fn made_up(text: String, element: Element<'_>) -> Name {
    let start = element.span().start;
    Name { text, span: start..start + 1 }
}
