//! Collects the frames, links and joints of all files, in the order of the main file.
//!
//! An included model takes the place of its `<include>`, with the name, pose, placement frame and
//! `<static>` given there. With `merge="true"` its elements become elements of the enclosing model.
//!
//! Source: sdformat.org/spec, `<include>`, and its "Model composition"; libsdformat for details.

use polhode_source::{ContentError, ContentErrorKind};

use super::frames::{FrameKind, Frames, Scope};
use super::pose;
use crate::model::{Note, Pose, RobotModel};
use crate::read::unread;
use crate::read::xml::{Element, is_true};

/// Maximum number of elements of a world with all includes. Without a limit, a chain of files, each
/// including the next one several times, could exhaust the memory.
const MOST_ELEMENTS: usize = 300_000;

/// Links and joints, each with its scope and its frame.
#[derive(Default)]
pub(super) struct Gathered<'a> {
    pub(super) links: Vec<(Element<'a>, usize, usize)>,
    pub(super) joints: Vec<(Element<'a>, usize, usize)>,
}

/// Element to be visited: its scope, and true if it is in a world.
struct Waiting<'a> {
    element: Element<'a>,
    scope: usize,
    in_world: bool,
}

/// Collects every frame, link and joint.
pub(super) fn gather<'a>(
    root: Element<'a>,
    frames: &mut Frames<'a>,
    model: &mut RobotModel,
    most_name_bytes: usize,
) -> Result<Gathered<'a>, ContentError> {
    let mut gathered = Gathered::default();
    let (mut name_bytes, mut elements) = (0, 0);
    let lone = root.named("model").count() == 1;
    let mut waiting = below(root, 0, false);
    while let Some(Waiting { element, scope, in_world }) = waiting.pop() {
        elements += 1;
        require_few(elements, element)?;
        let name = element.word("name").unwrap_or("");
        if matches!(element.name(), "model" | "include" | "link" | "joint" | "frame") {
            unread::sdf_pose(element, name, &mut model.notes);
            unread::sdf_once(element, name, &mut model.notes);
            require_few(model.notes.len(), element)?;
        }
        match element.name() {
            "world" => {
                model.name = model.name.take().or_else(|| Some(name.to_owned()));
                waiting.extend(below(element, scope, true));
            }
            "model" => {
                model.name = model.name.take().or_else(|| Some(name.to_owned()));
                let outer = frames.scope(scope);
                // The pose of a single model in the world is not part of the model.
                let alone = lone && scope == 0 && !in_world;
                let (pose, relative_to) = if alone { (Pose::IDENTITY, None) } else { pose(element) };
                let prefix = if alone { String::new() } else { format!("{}{name}::", outer.prefix) };
                name_bytes += prefix.len();
                require_short(name_bytes, most_name_bytes, element)?;
                let is_static = outer.is_static || says_static(element) == Some(true);
                let frame = frames.add(scope, name, FrameKind::Model, pose, relative_to, element.span());
                let canonical = element.word("canonical_link");
                if let Some(placed) = placement(element).filter(|_| !alone) {
                    frames.place_by(frame, placed);
                }
                let inner = frames.add_scope(Scope::new(frame, prefix, is_static, canonical));
                waiting.extend(below(element, inner, false));
            }
            "include" => {
                let Some(included) = included(element, &mut model.notes) else { continue };
                let inner = include(element, included, scope, frames);
                name_bytes += frames.scope(inner).prefix.len();
                require_short(name_bytes, most_name_bytes, element)?;
                waiting.extend(below(included, inner, false));
            }
            "link" => {
                let (pose, relative_to) = pose(element);
                let frame = frames.add(scope, name, FrameKind::Link, pose, relative_to, element.span());
                name_bytes += frames.scope(scope).prefix.len();
                require_short(name_bytes, most_name_bytes, element)?;
                gathered.links.push((element, scope, frame));
            }
            "joint" => {
                let (pose, relative_to) = pose(element);
                let child = element.child_text("child").map_or("", |text| text.value);
                let relative_to = relative_to.or(Some(child));
                let kind = FrameKind::Attached(child);
                let frame = frames.add(scope, name, kind, pose, relative_to, element.span());
                gathered.joints.push((element, scope, frame));
            }
            "frame" => {
                let (pose, relative_to) = pose(element);
                let attached = element.word("attached_to").filter(|name| !name.is_empty());
                let relative_to = relative_to.or(attached);
                let kind = FrameKind::Attached(attached.unwrap_or("__model__"));
                frames.add(scope, name, kind, pose, relative_to, element.span());
            }
            _ => {}
        }
    }
    Ok(gathered)
}

/// Returns the children of an element in reverse order.
fn below(element: Element<'_>, scope: usize, in_world: bool) -> Vec<Waiting<'_>> {
    let mut children: Vec<_> =
        element.children().map(|element| Waiting { element, scope, in_world }).collect();
    children.reverse();
    children
}

/// Returns the model of an included file. A file that was not read already has a note.
fn included<'a>(element: Element<'a>, notes: &mut Vec<Note>) -> Option<Element<'a>> {
    let root = element.linked()?;
    let model = root.child("model").filter(|_| root.name() == "sdf" || root.name() == "gazebo");
    if model.is_none() && root.child("light").is_none() && root.child("actor").is_none() {
        let message = format!("<include> of a file without a model: its root element is <{}>", root.name());
        notes.push(Note::new("read.include", "", element.span(), message));
    }
    model
}

/// Adds the scope and the frame of an included model.
fn include<'a>(element: Element<'a>, model: Element<'a>, scope: usize, frames: &mut Frames<'a>) -> usize {
    let name = element.child_text("name").map(|name| name.value).or(model.word("name")).unwrap_or("");
    let (pose, relative_to) = pose(if element.child("pose").is_some() { element } else { model });
    let outer = frames.scope(scope);
    let is_static = outer.is_static || says_static(element).or(says_static(model)).unwrap_or(false);
    let prefix = format!("{}{name}::", outer.prefix);
    let merges = element.says_true("merge");
    // libsdformat gives the frame of a merged model a name that does not occur in files.
    let own_name = if merges { "" } else { name };
    let frame = frames.add(scope, own_name, FrameKind::Model, pose, relative_to, element.span());
    let placed = element.child_text("placement_frame").map(|frame| frame.value).or(placement(model));
    if let Some(placed) = placed {
        frames.place_by(frame, placed);
    }
    let canonical = model.word("canonical_link");
    let inner = if merges {
        Scope::merged(frame, scope, frames.scope(scope), is_static, canonical)
    } else {
        Scope::new(frame, prefix, is_static, canonical)
    };
    frames.add_scope(inner)
}

fn placement(model: Element<'_>) -> Option<&str> {
    model.word("placement_frame").filter(|name| !name.is_empty())
}

fn says_static(model: Element<'_>) -> Option<bool> {
    model.child_text("static").map(|text| is_true(text.value))
}

/// Returns an error if there are more elements, shapes or notes than the limit.
pub(super) fn require_few(count: usize, element: Element<'_>) -> Result<(), ContentError> {
    if count <= MOST_ELEMENTS {
        return Ok(());
    }
    let what = format!("more than {MOST_ELEMENTS} elements, included models counted");
    Err(ContentErrorKind::unsupported(what).at(element.span()))
}

/// Returns an error if the names together are much longer than the text.
pub(super) fn require_short(
    name_bytes: usize,
    most: usize,
    element: Element<'_>,
) -> Result<(), ContentError> {
    if name_bytes <= most {
        return Ok(());
    }
    let what = "models nested so deeply that their joined names are many times longer than the file";
    let kind = ContentErrorKind::unsupported(what);
    let start = element.span().start;
    Err(kind.at(start..start + 1))
}
