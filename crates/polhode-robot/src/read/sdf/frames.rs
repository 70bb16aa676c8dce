//! Frames that name each other.

use std::collections::HashMap;

use crate::model::{Note, Number, Pose, Span};

/// Frames between a model and the one that places it: longer chains go round, or want time.
const MOST_PLACEMENT_STEPS: usize = 100;

/// What has a frame.
#[derive(Clone, Copy, Debug)]
pub(super) enum FrameKind<'a> {
    /// The root, or a model: its canonical link stands for it.
    Model,
    /// A link.
    Link,
    /// A joint or a frame: fixed to what it names.
    Attached(&'a str),
}

#[derive(Debug)]
struct Frame<'a> {
    scope: usize,
    name: &'a str,
    kind: FrameKind<'a>,
    /// In the frame that it names, else in its model's.
    pose: Pose,
    relative_to: Option<&'a str>,
    span: Span,
    /// The frame of a model that its pose places, if that is not its own.
    placement: Option<&'a str>,
    in_root: Option<Pose>,
}

/// The names of a model.
#[derive(Debug)]
pub(super) struct Scope<'a> {
    /// The model's own frame.
    frame: usize,
    /// The names of the models around, each with `::`.
    pub(super) prefix: String,
    /// The model, or one around it, does not move.
    pub(super) is_static: bool,
    /// The link that stands for the model, by name or by being the first.
    canonical: Option<&'a str>,
    names: HashMap<&'a str, usize>,
    /// The scope that has its names too: that of the model that it is merged into.
    merged_into: Option<usize>,
}

impl<'a> Scope<'a> {
    pub(super) fn new(frame: usize, prefix: String, is_static: bool, canonical: Option<&'a str>) -> Self {
        Self { frame, prefix, is_static, canonical, names: HashMap::new(), merged_into: None }
    }
}

impl<'a> Scope<'a> {
    /// Of a model whose elements become those of the model around it.
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

/// All frames of a file. The root is frame 0 and scope 0.
#[derive(Debug)]
pub(super) struct Frames<'a> {
    frames: Vec<Frame<'a>>,
    scopes: Vec<Scope<'a>>,
    /// The scope that is the inside of a model's frame.
    inside: HashMap<usize, usize>,
    /// The link that each frame is fixed to.
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
    /// The scope of a number that a frame gave.
    pub(super) fn scope(&self, scope: usize) -> &Scope<'a> {
        // numbers come from add_scope only
        &self.scopes[scope]
    }

    /// The scope that has the names of a scope.
    fn target(&self, scope: usize) -> usize {
        let mut scope = scope;
        while let Some(outer) = self.scope(scope).merged_into {
            scope = outer; // an earlier one
        }
        scope
    }

    /// Says that a model's pose is that of a frame in it.
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

    /// A frame of a scope. Of two with the same name, the first is meant by it.
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

    /// The frame that a name means in a scope: its own, `__model__`, `world`, or `inner::name`.
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

    /// Composes every frame with those that it stands in, and finds the link that it is fixed to.
    pub(super) fn resolve(&mut self, notes: &mut Vec<Note>) {
        self.place_models(notes);
        // the walk that came by a frame last: each frame is walked over once, and once more at the start of a circle
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
                    let message = "frames name each other in a circle: it is taken in the root's".to_owned();
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

    /// X_outer_model = X_outer_placement X_model_placement⁻¹, of the innermost models first: they come last.
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
                let message =
                    format!("its placement frame {name:?} does not stand in it: its own frame is placed");
                notes.push(Note::new("read.frame_circle", model, span.clone(), message));
            }
        }
    }

    /// What a joint, a frame or a model is fixed to.
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

    /// The frame that a frame is given in: what it names, else its model's.
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

    /// A frame in the root's, after [`Frames::resolve`].
    pub(super) fn in_root(&self, frame: usize) -> Pose {
        self.frames.get(frame).and_then(|frame| frame.in_root.clone()).unwrap_or(Pose::IDENTITY)
    }

    /// The numbers of a frame's own pose that are none.
    pub(super) fn unreadable(&self, frame: usize) -> &[Number] {
        self.frames.get(frame).map_or(&[], |frame| &frame.pose.unreadable)
    }

    /// The link that a frame is fixed to, after [`Frames::resolve`]: itself, what it is attached to, or a model's canonical link.
    pub(super) fn link_of(&self, frame: usize) -> Option<usize> {
        self.links.get(frame).copied().flatten()
    }

    /// A frame's name with those of the models around it.
    pub(super) fn full_name(&self, frame: usize) -> String {
        self.frames
            .get(frame)
            .map_or_else(String::new, |frame| format!("{}{}", self.scope(frame.scope).prefix, frame.name))
    }
}

/// A frame that no element has.
pub(super) fn unknown(frame: &str, subject: &str, span: Span) -> Note {
    let message = format!("there is no frame {frame:?}: the pose is taken in the frame around it");
    Note::new("read.frame", subject, span, message)
}
