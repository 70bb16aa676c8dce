//! Frames that refer to each other by name.

use std::collections::HashMap;

use crate::model::{Note, Number, Pose, Span};

/// Maximum number of frames between a model and its placement frame; longer chains are circular or
/// too slow.
const MOST_PLACEMENT_STEPS: usize = 100;

/// Kind of element that has a frame.
#[derive(Clone, Copy, Debug)]
pub(super) enum FrameKind<'a> {
    /// The root, or a model. Its canonical link represents it.
    Model,
    Link,
    /// Joint or frame: attached to the element that it names.
    Attached(&'a str),
}

#[derive(Debug)]
struct Frame<'a> {
    scope: usize,
    name: &'a str,
    kind: FrameKind<'a>,
    /// Pose in the named frame, otherwise in the frame of its model.
    pose: Pose,
    relative_to: Option<&'a str>,
    span: Span,
    /// Placement frame of a model, if its pose is not that of its own frame.
    placement: Option<&'a str>,
    in_root: Option<Pose>,
}

/// Namespace of a model.
#[derive(Debug)]
pub(super) struct Scope<'a> {
    /// Index of the model's own frame.
    frame: usize,
    /// Names of the enclosing models, each followed by `::`.
    pub(super) prefix: String,
    /// True if the model or an enclosing model is static.
    pub(super) is_static: bool,
    /// Canonical link by name; `None` for the first link.
    canonical: Option<&'a str>,
    names: HashMap<&'a str, usize>,
    /// Scope that shares its names: that of the model that it is merged into.
    merged_into: Option<usize>,
}

impl<'a> Scope<'a> {
    pub(super) fn new(frame: usize, prefix: String, is_static: bool, canonical: Option<&'a str>) -> Self {
        Self { frame, prefix, is_static, canonical, names: HashMap::new(), merged_into: None }
    }
}

impl<'a> Scope<'a> {
    /// Returns the scope of a model whose elements become elements of the enclosing model.
    pub(super) fn merged(
        frame: usize,
        into: usize,
        outer: &Self,
        is_static: bool,
        canonical: Option<&'a str>,
    ) -> Self {
        let own = Self::new(frame, outer.prefix.clone(), is_static, canonical);
        Self { merged_into: Some(into), ..own }
    }
}

/// All frames of a file. The root has frame 0 and scope 0.
#[derive(Debug)]
pub(super) struct Frames<'a> {
    frames: Vec<Frame<'a>>,
    scopes: Vec<Scope<'a>>,
    /// Scope inside the frame of a model.
    inside: HashMap<usize, usize>,
    /// Link that each frame is fixed to.
    links: Vec<Option<usize>>,
}

impl Default for Frames<'_> {
    fn default() -> Self {
        let root = Frame {
            scope: 0,
            name: "",
            kind: FrameKind::Model,
            pose: Pose::IDENTITY,
            relative_to: None,
            span: 0..0,
            placement: None,
            in_root: Some(Pose::IDENTITY),
        };
        let scopes = vec![Scope::new(0, String::new(), false, None)];
        Self { frames: vec![root], scopes, inside: HashMap::from([(0, 0)]), links: Vec::new() }
    }
}

impl<'a> Frames<'a> {
    /// Returns the scope with an index from [`Frames::add_scope`].
    pub(super) fn scope(&self, scope: usize) -> &Scope<'a> {
        // All indices come from `add_scope`.
        &self.scopes[scope]
    }

    /// Returns the scope that holds the names of a scope.
    fn target(&self, scope: usize) -> usize {
        let mut scope = scope;
        while let Some(outer) = self.scope(scope).merged_into {
            scope = outer; // always a lower index
        }
        scope
    }

    /// Sets the placement frame of a model: the model's pose is that of this frame.
    pub(super) fn place_by(&mut self, model: usize, frame: &'a str) {
        if let Some(model) = self.frames.get_mut(model) {
            model.placement = Some(frame);
        }
    }

    pub(super) fn add_scope(&mut self, scope: Scope<'a>) -> usize {
        self.inside.insert(scope.frame, self.scopes.len());
        self.scopes.push(scope);
        self.scopes.len() - 1
    }

    /// Adds a frame to a scope. If a name occurs twice, it refers to the first frame.
    pub(super) fn add(
        &mut self,
        scope: usize,
        name: &'a str,
        kind: FrameKind<'a>,
        pose: Pose,
        relative_to: Option<&'a str>,
        span: Span,
    ) -> usize {
        let frame = self.frames.len();
        self.frames.push(Frame {
            scope,
            name,
            kind,
            pose,
            relative_to,
            span,
            placement: None,
            in_root: None,
        });
        if let Some(own) = self.scopes.get_mut(scope).filter(|_| matches!(kind, FrameKind::Link)) {
            own.canonical.get_or_insert(name);
        }
        let scope = self.target(scope);
        if let Some(scope) = self.scopes.get_mut(scope) {
            scope.names.entry(name).or_insert(frame);
            if matches!(kind, FrameKind::Link) {
                scope.canonical.get_or_insert(name);
            }
        }
        frame
    }

    /// Returns the frame that a name refers to in a scope: a name of the scope, `__model__`,
    /// `world`, or `inner::name`.
    pub(super) fn lookup(&self, scope: usize, name: &str) -> Option<usize> {
        match name {
            "__model__" => return Some(self.scope(scope).frame),
            "world" => return Some(self.scope(self.target(scope)).names.get(name).copied().unwrap_or(0)),
            _ => {}
        }
        let mut scope = self.target(scope);
        let mut rest = name;
        while let Some((model, inner)) = rest.split_once("::") {
            let frame = *self.scope(scope).names.get(model)?;
            scope = *self.inside.get(&frame)?;
            rest = inner;
        }
        if rest == "__model__" {
            Some(self.scope(scope).frame)
        } else {
            self.scope(scope).names.get(rest).copied()
        }
    }

    /// Composes the pose of every frame in the root, and finds the link that it is fixed to.
    pub(super) fn resolve(&mut self, notes: &mut Vec<Note>) {
        self.place_models(notes);
        // Last walk that visited each frame. A frame is visited once, and again only at the start
        // of a cycle.
        let mut walk = vec![usize::MAX; self.frames.len()];
        for first in 0..self.frames.len() {
            let mut chain = Vec::new();
            let mut at = first;
            let mut outer = loop {
                if let Some(known) = &self.frames[at].in_root {
                    break known.clone();
                }
                if std::mem::replace(&mut walk[at], first) == first {
                    let frame = &self.frames[at];
                    let message = "the frames refer to each other in a cycle; the pose is taken as relative to the root frame".to_owned();
                    notes.push(Note::new("read.frame_circle", frame.name, frame.span.clone(), message));
                    break Pose::IDENTITY;
                }
                chain.push(at);
                at = self.parent(at, notes);
            };
            for frame in chain.into_iter().rev() {
                let pose = outer.then(&self.frames[frame].pose);
                outer = Pose::new(pose.position, pose.rotation);
                self.frames[frame].in_root = Some(outer.clone());
            }
        }
        let mut known = vec![None; self.frames.len()];
        walk.fill(usize::MAX);
        for first in 0..self.frames.len() {
            let mut chain = Vec::new();
            let mut at = Some(first);
            let link = loop {
                match at {
                    None => break None,
                    Some(frame) if known[frame].is_some() => break known[frame].flatten(),
                    Some(frame) if std::mem::replace(&mut walk[frame], first) == first => break None,
                    Some(frame) => {
                        chain.push(frame);
                        if matches!(self.frames[frame].kind, FrameKind::Link) {
                            break Some(frame);
                        }
                        at = self.holder(frame);
                    }
                }
            };
            chain.into_iter().for_each(|frame| known[frame] = Some(link));
        }
        self.links = known.into_iter().map(Option::flatten).collect();
    }

    /// Computes X_outer_model = X_outer_placement X_model_placement⁻¹ for each model. Inner models
    /// come last in the list, and first here.
    fn place_models(&mut self, notes: &mut Vec<Note>) {
        for model in (0..self.frames.len()).rev() {
            let Some(name) = self.frames[model].placement else { continue };
            let inside = self.inside.get(&model).copied();
            let Some(placed) = inside.and_then(|scope| self.lookup(scope, name)) else {
                notes.push(unknown(name, self.frames[model].name, self.frames[model].span.clone()));
                continue;
            };
            let (mut at, mut in_model) = (placed, Pose::IDENTITY);
            for _ in 0..MOST_PLACEMENT_STEPS {
                if at == model || at == 0 {
                    break;
                }
                let pose = self.frames[at].pose.then(&in_model);
                in_model = Pose::new(pose.position, pose.rotation);
                at = self.parent(at, notes);
            }
            if at == model {
                let own = &mut self.frames[model].pose;
                let moved = own.then(&in_model.inverse());
                *own =
                    Pose { unreadable: std::mem::take(&mut own.unreadable), span: own.span.take(), ..moved };
            } else {
                let Frame { name: model, span, .. } = &self.frames[model];
                let message = format!("it has no placement frame {name:?}; its own frame is placed instead");
                notes.push(Note::new("read.frame_circle", model, span.clone(), message));
            }
        }
    }

    /// Returns the element that a joint, frame or model is fixed to.
    fn holder(&self, frame: usize) -> Option<usize> {
        match self.frames[frame].kind {
            FrameKind::Link => Some(frame),
            FrameKind::Attached(name) => self.lookup(self.frames[frame].scope, name),
            FrameKind::Model => {
                let scope = *self.inside.get(&frame)?;
                self.lookup(scope, self.scope(scope).canonical?)
            }
        }
    }

    /// Returns the frame of reference of a frame: the one that it names, otherwise its model's.
    fn parent(&self, frame: usize, notes: &mut Vec<Note>) -> usize {
        let Frame { scope, name, relative_to, span, .. } = &self.frames[frame];
        let model = self.scope(*scope).frame;
        match relative_to {
            None => model,
            Some(other) => self.lookup(*scope, other).unwrap_or_else(|| {
                notes.push(unknown(other, name, span.clone()));
                model
            }),
        }
    }

    /// Returns the pose of a frame in the root; valid after [`Frames::resolve`].
    pub(super) fn in_root(&self, frame: usize) -> Pose {
        self.frames.get(frame).and_then(|frame| frame.in_root.clone()).unwrap_or(Pose::IDENTITY)
    }

    /// Returns the unreadable numbers of a frame's own pose.
    pub(super) fn unreadable(&self, frame: usize) -> &[Number] {
        self.frames.get(frame).map_or(&[], |frame| &frame.pose.unreadable)
    }

    /// Returns the link that a frame is fixed to, after [`Frames::resolve`]: the link itself, the
    /// attached link, or a model's canonical link.
    pub(super) fn link_of(&self, frame: usize) -> Option<usize> {
        self.links.get(frame).copied().flatten()
    }

    /// Returns a frame's name, prefixed with the names of the enclosing models.
    pub(super) fn full_name(&self, frame: usize) -> String {
        self.frames
            .get(frame)
            .map_or_else(String::new, |frame| format!("{}{}", self.scope(frame.scope).prefix, frame.name))
    }
}

/// Returns the note for an unknown frame.
pub(super) fn unknown(frame: &str, subject: &str, span: Span) -> Note {
    let message = format!("unknown frame {frame:?}; the pose is taken as relative to the enclosing frame");
    Note::new("read.frame", subject, span, message)
}
