//! Attributes unknown to MuJoCo, which rejects such a file. A hint names the nearest known
//! attribute.
//!
//! The lists contain the attributes of MuJoCo 4.0 and of earlier versions.

use crate::finding::Severity;
use crate::model::Note;
use crate::read::xml::Element;

const COMPILER: &str = "alignfree angle assetdir autolimits balanceinertia boundinertia boundmass conflict convexhull coordinate \
     discardvisual eulerseq exactmeshinertia fitaabb fusestatic inertiafromgeom inertiagrouprange meshdir passthrough savecanonical \
     savecompiled saveinertial settotalmass strippath texturedir usethread";
const GEOM: &str = "adhesion axisangle castshadow class conaffinity condim contype density euler fitscale fluidcoef fluidshape friction fromto gap \
     group hfield margin mass material mesh name pos priority quat rgba shellinertia size solimp solmix solref surfacevel type user \
     xyaxes zaxis";
const BODY: &str =
    "axisangle childclass euler fuse gravcomp mocap name pos quat simple sleep user xyaxes zaxis";
const JOINT: &str = "actuatorfrclimited actuatorfrcrange actuatorgravcomp align armature axis class damping frictionloss group limited \
     margin name pos range ref solimpfriction solimplimit solreffriction solreflimit springdamper springref springyield stiffness type user";
const MESH: &str = "builtin class content_type face file inertia material maxhullvert name normal octree params refpos refquat scale \
     smoothnormal texcoord vertex";

/// Adds notes for unknown attributes of settings, defaults, meshes and bodies.
pub(super) fn unknown(root: Element<'_>, notes: &mut Vec<Note>) {
    let mut waiting = vec![(root, "")];
    while let Some((element, body)) = waiting.pop() {
        for child in element.children() {
            let name = child.word("name").filter(|_| child.name() == "body").unwrap_or(body);
            let known = match child.name() {
                "compiler" => COMPILER,
                "geom" => GEOM,
                "body" => BODY,
                "joint" | "freejoint" => JOINT,
                "mesh" => MESH,
                _ => "",
            };
            if !known.is_empty() {
                notes.extend(
                    child.attribute_names().filter_map(|attribute| note(child, attribute, known, name)),
                );
            }
            if matches!(child.name(), "worldbody" | "body" | "frame" | "replicate" | "default" | "asset") {
                waiting.push((child, name));
            }
        }
    }
}

fn note(element: Element<'_>, attribute: &str, known: &str, body: &str) -> Option<Note> {
    let mut names = known.split_ascii_whitespace();
    if attribute.starts_with("xmlns") || names.any(|name| name == attribute) {
        return None;
    }
    let lower = attribute.to_ascii_lowercase();
    let same = known.split_ascii_whitespace().find(|name| **name == lower);
    let meant = same.or_else(|| polhode_source::nearest(&lower, known.split_ascii_whitespace()));
    let question = meant.map_or_else(String::new, |meant| format!("; did you mean {meant}?"));
    let message = format!(
        "{attribute}=… is not an attribute of <{}>: MuJoCo refuses the file{question}",
        element.name()
    );
    let span = element.attribute(attribute).map_or_else(|| element.span(), |written| written.span);
    let severity = if meant.is_some() { Severity::Suspect } else { Severity::Note };
    Some(Note { severity, ..Note::new("read.unknown", body, span, message) })
}
