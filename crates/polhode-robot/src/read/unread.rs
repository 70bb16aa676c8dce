//! Content that a reader would ignore although it may be intended: `read.inertials`, `read.twice`,
//! `read.unknown`, `inertia.asymmetric`, `inertia.two_forms`, `pose.degrees`.
//!
//! Programs read the first of two elements, the tensor elements above the diagonal, and only the
//! attributes of their language. If a file has further content, it may contradict the content that
//! programs read.

use crate::finding::Severity;
use crate::model::{Note, Span};
use crate::read::xml::{Element, Written};

/// Tensor elements above the diagonal, and those below it.
const MIRRORED: [[&str; 2]; 3] = [["ixy", "iyx"], ["ixz", "izx"], ["iyz", "izy"]];
const MOMENTS: [&str; 3] = ["ixx", "iyy", "izz"];

/// Relative difference below which two tensor elements are equal: the last digit of a program's
/// output.
const EQUAL: f64 = 1e-6;

/// Parts of an unknown name that indicate mass properties: as a substring, or as a whole word.
const PHYSICS: [&str; 8] = ["mass", "inertia", "density", "center", "centre", "origin", "pose", "unit"];
const WORDS: [&str; 2] = ["com", "cog"];

/// Checks a URDF link: its inertial and the origins of its shapes.
pub(super) fn urdf(link: Element<'_>, subject: &str, notes: &mut Vec<Note>) {
    let mut reader = Unread { subject, notes };
    reader.once(link, "inertial", "read.inertials");
    reader.astray(link);
    for shape in link.children().filter(|child| matches!(child.name(), "visual" | "collision")) {
        reader.attributes(shape, "origin", &["xyz", "rpy"]);
        reader.origin_degrees(shape);
    }
    for shape in link.children().filter(|child| matches!(child.name(), "visual" | "collision")) {
        reader.once(shape, "origin", "read.twice");
        reader.one_shape(shape);
    }
    let Some(inertial) = link.child("inertial") else { return };
    reader.elements(inertial, &["origin", "mass", "inertia"]);
    reader.attributes(inertial, "origin", &["xyz", "rpy"]);
    reader.origin_degrees(inertial);
    reader.attributes(inertial, "mass", &["value"]);
    let Some(inertia) = inertial.child("inertia") else { return };
    let tensor: Vec<&str> = MOMENTS.into_iter().chain(MIRRORED.into_iter().flatten()).collect();
    let matrix = reader.matrix(inertia, &tensor, |name, value| format!("{name}={value:?}"));
    let known: Vec<&str> = tensor.into_iter().chain(matrix).collect();
    reader.attributes(inertial, "inertia", &known);
    reader.symmetric(|name| inertia.attribute(name));
}

/// Checks the origin of a URDF joint.
pub(super) fn origin(joint: Element<'_>, subject: &str, notes: &mut Vec<Note>) {
    let mut reader = Unread { subject, notes };
    for name in ["origin", "parent", "child", "axis", "limit", "mimic"] {
        reader.once(joint, name, "read.twice");
    }
    reader.attributes(joint, "origin", &["xyz", "rpy"]);
    reader.origin_degrees(joint);
}

/// Checks the inertial of an SDF link.
pub(super) fn sdf(link: Element<'_>, subject: &str, notes: &mut Vec<Note>) {
    let mut reader = Unread { subject, notes };
    reader.once(link, "inertial", "read.inertials");
    reader.astray(link);
    for shape in link.children().filter(|child| matches!(child.name(), "visual" | "collision")) {
        reader.once(shape, "pose", "read.twice");
        reader.once(shape, "density", "read.twice");
        reader.one_shape(shape);
    }
    for placed in link.children().filter(|child| matches!(child.name(), "inertial" | "visual" | "collision"))
    {
        sdf_pose(placed, subject, reader.notes);
    }
    let Some(inertial) = link.child("inertial") else { return };
    reader.elements(
        inertial,
        &["pose", "mass", "inertia", "density", "auto_inertia_params", "fluid_added_mass", "frame"],
    );
    reader.own_attributes(inertial, &["auto"]);
    reader.attributes(inertial, "pose", &["relative_to", "frame", "degrees", "rotation_format"]);
    reader.attributes(inertial, "mass", &[]);
    if let Some(frame) = inertial.child("pose").and_then(|pose| pose.attribute("relative_to"))
        && !frame.value.is_empty()
    {
        let message = format!(
            "the pose of an inertial is relative to its link; relative_to={:?} is not read",
            frame.value
        );
        reader.suspect("read.unknown", frame.span, message);
    }
    let Some(inertia) = inertial.child("inertia") else { return };
    let tensor: Vec<&str> = MOMENTS.into_iter().chain(MIRRORED.into_iter().flatten()).collect();
    let matrix = reader.matrix(inertia, &[], |name, value| format!("<{name}>{value}</{name}>"));
    reader.elements(inertia, &tensor);
    reader.own_attributes(inertia, matrix.as_slice());
    reader.symmetric(|name| inertia.child_text(name));
}

/// Checks the inertial of an MJCF body.
pub(super) fn mjcf(body: Element<'_>, subject: &str, notes: &mut Vec<Note>) {
    const ATTITUDES: [&str; 5] = ["quat", "axisangle", "euler", "xyaxes", "zaxis"];
    let mut reader = Unread { subject, notes };
    reader.once(body, "inertial", "read.inertials");
    let Some(inertial) = body.child("inertial") else { return };
    let known = ["pos", "mass", "diaginertia", "fullinertia"].into_iter().chain(ATTITUDES);
    reader.own_attributes(inertial, &known.collect::<Vec<_>>());
    let Some(full) = inertial.attribute("fullinertia") else { return };
    let others = ["diaginertia"].into_iter().chain(ATTITUDES);
    for other in others.filter(|name| inertial.attribute(name).is_some()) {
        let message =
            format!("fullinertia together with {other}: MuJoCo refuses both together; fullinertia is read");
        reader.suspect("inertia.two_forms", full.span.clone(), message);
    }
}

/// Checks the mass properties of an OpenSim body.
pub(super) fn osim(body: Element<'_>, subject: &str, notes: &mut Vec<Note>) {
    const NUMBERS: [(&str, usize); 3] = [("mass", 1), ("mass_center", 3), ("inertia", 6)];
    let mut reader = Unread { subject, notes };
    for (name, count) in NUMBERS {
        reader.once(body, name, "read.twice");
        let text = body.child_text(name);
        if let Some(extra) = text.and_then(|text| text.numbers().nth(count)) {
            reader.suspect("read.numbers", extra.span, format!("<{name}> has more than {count} numbers"));
        }
    }
    for name in ["xx", "yy", "zz", "xy", "xz", "yz"] {
        reader.once(body, &format!("inertia_{name}"), "read.twice");
    }
}

/// Checks that elements of an SDF joint, frame or model are not repeated.
pub(super) fn sdf_once(element: Element<'_>, subject: &str, notes: &mut Vec<Note>) {
    let mut reader = Unread { subject, notes };
    let of_joint: &[&str] =
        if element.name() == "joint" { &["parent", "child", "axis", "axis2"] } else { &[] };
    for name in ["pose"].iter().chain(of_joint) {
        reader.once(element, name, "read.twice");
    }
}

/// Checks if the angles of an SDF pose are degrees.
pub(super) fn sdf_pose(element: Element<'_>, subject: &str, notes: &mut Vec<Note>) {
    let Some(pose) = element.child("pose") else { return };
    if pose.says_true("degrees") || pose.word("rotation_format").is_some_and(|format| format != "euler_rpy") {
        return;
    }
    if let Some(text) = pose.text()
        && let Some([_, _, _, angles @ ..]) = text.array::<6>()
    {
        Unread { subject, notes }.degrees(angles, text.span);
    }
}

/// Notes about one link or joint.
struct Unread<'n> {
    subject: &'n str,
    notes: &'n mut Vec<Note>,
}

impl Unread<'_> {
    fn suspect(&mut self, code: &'static str, span: Span, message: String) {
        let note = Note::new(code, self.subject, span, message);
        self.notes.push(Note { severity: Severity::Suspect, ..note });
    }

    /// Reports roll, pitch and yaw if one of them is more than a full turn and a round number of
    /// degrees.
    fn degrees(&mut self, angles: [f64; 3], span: Span) {
        const STEP: f64 = 2.5;
        let is_degrees = |angle: f64| angle % STEP == 0.0 && angle.abs() > std::f64::consts::TAU;
        if !angles.into_iter().any(is_degrees) {
            return;
        }
        // Next to a whole number of degrees, as in 0 1 90, small multiples of 0.5 may be degrees;
        // other fractions are unlikely to be.
        let meant = angles.map(|angle| match angle % 0.5 == 0.0 {
            true => angle.to_radians(),
            false => angle,
        });
        let words = |angles: [f64; 3]| angles.map(|angle| (angle + 0.0).to_string()).join(" ");
        let (written, meant) = (words(angles), words(meant));
        let message = format!(
            "roll, pitch and yaw of {written} are read as radians; if they are degrees, write {meant}"
        );
        self.suspect("pose.degrees", span, message);
    }

    /// Checks the angles of an `<origin>`.
    fn origin_degrees(&mut self, parent: Element<'_>) {
        if let Some(rpy) = parent.child("origin").and_then(|origin| origin.attribute("rpy"))
            && let Some(angles) = rpy.array()
        {
            self.degrees(angles, rpy.span);
        }
    }

    /// Reports a repeated element.
    fn once(&mut self, parent: Element<'_>, name: &str, code: &'static str) {
        if let Some(second) = parent.children().filter(|child| child.name() == name).nth(1) {
            let message = format!("a second <{name}> in <{}>: only the first is read", parent.name());
            self.suspect(code, second.span(), message);
        }
    }

    /// Reports a second `<geometry>`, or a second shape in it.
    fn one_shape(&mut self, parent: Element<'_>) {
        self.once(parent, "geometry", "read.twice");
        if let Some(second) = parent.child("geometry").and_then(|geometry| geometry.children().nth(1)) {
            let message =
                format!("a second shape in <geometry>, <{}>: only the first is read", second.name());
            self.suspect("read.twice", second.span(), message);
        }
    }

    /// Notes a tensor written as a matrix, in an unknown attribute or as text. Returns the name of
    /// that attribute.
    fn matrix<'a>(
        &mut self,
        inertia: Element<'a>,
        known: &[&str],
        written: impl Fn(&str, &str) -> String,
    ) -> Option<&'a str> {
        let is_matrix = |text: &Written<'_>| matches!(text.numbers().count(), 6 | 9);
        let mut attributes = inertia.attribute_names().filter(|name| !known.contains(name));
        let attribute = attributes.find(|name| inertia.attribute(name).as_ref().is_some_and(is_matrix));
        let text = match attribute {
            Some(name) => inertia.attribute(name),
            None => inertia.text().filter(is_matrix),
        }?;
        let values: Vec<&str> = text.value.split_whitespace().collect();
        // Order by rows: xx xy xz, yx yy yz, zx zy zz.
        let meant = match values.as_slice() {
            &[xx, xy, xz, yx, yy, yz, zx, zy, zz] if [xy, xz, yz] == [yx, zx, zy] => {
                let six = [("ixx", xx), ("ixy", xy), ("ixz", xz), ("iyy", yy), ("iyz", yz), ("izz", zz)];
                format!(": write {}", six.map(|(name, value)| written(name, value)).join(" "))
            }
            _ => String::new(),
        };
        let message = format!(
            "a tensor of {} numbers is not read; programs read the six attributes ixx, ixy, ixz, iyy, iyz, izz{meant}",
            values.len()
        );
        self.suspect("read.unknown", text.span, message);
        attribute
    }

    /// Reports elements that belong into the inertial but are next to it, and misspelled names of
    /// the inertial.
    fn astray(&mut self, link: Element<'_>) {
        let is_astray = |name: &str| {
            let lower = name.to_ascii_lowercase();
            name != "inertial"
                && ["mass", "inertia", "density", "inertial", "inertials"].contains(&lower.as_str())
        };
        for child in link.children().filter(|child| is_astray(child.name())) {
            let message =
                format!("<{}> in <link> is not read: mass and tensor are in <inertial>", child.name());
            self.suspect("read.unknown", child.span(), message);
        }
    }

    /// Reports repeated elements, and elements that are not in this list.
    fn elements(&mut self, parent: Element<'_>, known: &[&str]) {
        for name in known {
            self.once(parent, name, "read.twice");
        }
        for child in parent.children().filter(|child| !known.contains(&child.name())) {
            let message = format!(
                "<{}> in <{}> is not read; the elements read are {}",
                child.name(),
                parent.name(),
                known.join(", ")
            );
            self.unknown(child.name(), child.span(), message);
        }
    }

    /// Reports attributes that are not in this list, on the first child of that name.
    fn attributes(&mut self, parent: Element<'_>, name: &str, known: &[&str]) {
        if let Some(child) = parent.child(name) {
            self.own_attributes(child, known);
        }
    }

    /// Reports attributes that are not in this list.
    fn own_attributes(&mut self, element: Element<'_>, known: &[&str]) {
        for name in element.attribute_names().filter(|name| !known.contains(name)) {
            let span = element.attribute(name).map_or_else(|| element.span(), |written| written.span);
            let message = match known {
                [] => format!("{name}=… of <{}> is not read", element.name()),
                _ => {
                    format!(
                        "{name}=… of <{}> is not read; the attributes read are {}",
                        element.name(),
                        known.join(", ")
                    )
                }
            };
            self.unknown(name, span, message);
        }
    }

    /// Reports an unknown name: suspect if it indicates mass properties, otherwise a note.
    fn unknown(&mut self, name: &str, span: Span, message: String) {
        let lower = name.to_ascii_lowercase();
        let element =
            lower.len() == 3 && lower.starts_with('i') && lower[1..].bytes().all(|b| b"xyz".contains(&b));
        let mut words = lower.split(|c: char| !c.is_ascii_alphabetic());
        let word = words.any(|word| WORDS.contains(&word));
        let attitude = ["quat", "rpy", "xyz", "euler", "ypr"].iter().any(|word| lower.contains(word));
        // Prefixes of other programs' own elements: drake_…, gz_….
        let foreign = lower.starts_with("xmlns") || lower.starts_with("drake_") || lower.starts_with("gz_");
        if !foreign && (element || word || attitude || PHYSICS.iter().any(|word| lower.contains(word))) {
            self.suspect("read.unknown", span, message);
        } else if !foreign {
            self.notes.push(Note::new("read.unknown", self.subject, span, message));
        }
    }

    /// Reports elements below the diagonal that differ from those above it. A missing element above
    /// the diagonal counts as zero.
    fn symmetric<'a>(&mut self, element: impl Fn(&'static str) -> Option<Written<'a>>) {
        for [upper, lower] in MIRRORED {
            let Some(below) = element(lower) else { continue };
            let above = element(upper);
            let value = |written: &Written<'_>| written.number().value;
            let (a, b) = (above.as_ref().map_or(Some(0.0), value), value(&below));
            let equal = a.zip(b).is_some_and(|(a, b)| (a - b).abs() <= EQUAL * a.abs().max(b.abs()));
            if !equal {
                let written = above.map_or("missing".to_owned(), |above| above.value.to_owned());
                let message = format!(
                    "{upper} is {written} and {lower} is {}: a tensor is symmetric, and programs read only {upper}",
                    below.value
                );
                self.suspect("inertia.asymmetric", below.span, message);
            }
        }
    }
}
