//! Equal products on both sides of a mirrored pair: `inertia.mirrored_pair`.
//!
//! Left and right limbs are mirror images, and their frames usually have the same axes. The mirror
//! image along x has −ixy and −ixz, but files are often copied from one side to the other. Two
//! links are a pair if their names differ only in the side. The pair is mirrored if masses and
//! principal moments are equal and the centres of mass are mirror images.
//!
//! If a frame on one side is also rotated by 180°, the map is another of the four that change one
//! sign or three:
//!
//!   (x, y, z) → (−x, y, z), (x, −y, z), (x, y, −z), (−x, −y, −z).
//!
//! The centres of mass determine which maps are possible. A finding requires products and moments
//! of equal magnitude on both sides, with signs that agree with none of these maps.
//!
//! A part that is used twice, such as a motor, is not a mirrored pair. Its centre is the same on
//! both sides, or rotated by 180° (two signs), and so are its products. If the centres coincide
//! because they lie in the mirror plane, the joint positions determine the plane. Links with the
//! same meshes at the same poses are the same part.

use std::sync::Arc;

use std::collections::HashMap;

use super::body::{Body, NAMES};
use super::finding;
use super::tree::Tree;
use super::written::short;
use crate::finding::{Finding, Severity};
use crate::model::{Geometry, GeometryShape, Joint, Link, RobotModel};
use crate::moments::{PLACES, norm};

/// Names of sides: left and right, and front and rear combinations such as FL FR RL RR and LF RF LH
/// RH.
pub(super) const SIDES: [(&str, &str); 12] = [
    ("left", "right"),
    ("l", "r"),
    ("fl", "fr"),
    ("rl", "rr"),
    ("bl", "br"),
    ("hl", "hr"),
    ("ml", "mr"),
    ("lf", "rf"),
    ("lh", "rh"),
    ("lb", "rb"),
    ("lm", "rm"),
    ("lr", "rr"),
];

/// Relative difference below which two values are equal; they may have been rounded.
pub(super) const EQUAL: f64 = 0.01;

/// Fraction of its vector or tensor above which a coordinate or product counts as nonzero. Below
/// it, the sign may be noise.
const THERE: f64 = 0.02;

/// Signs of the mirror images, then of the rotations by 180°.
pub(super) const MAPS: [[f64; 3]; 7] = [
    [-1.0, 1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, -1.0],
    [-1.0, -1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [-1.0, 1.0, -1.0],
    [1.0, -1.0, -1.0],
];

pub(super) fn check(model: &RobotModel, tree: &Tree, bodies: &[Option<Body>], findings: &mut Vec<Finding>) {
    let bodies: Vec<(usize, &Body)> =
        bodies.iter().enumerate().filter_map(|(k, body)| Some((k, body.as_ref()?))).collect();
    let names: HashMap<&str, (usize, &Body)> =
        bodies.iter().map(|(k, body)| (body.link.name.text.as_str(), (*k, *body))).collect();
    for (k, left) in bodies {
        let found = mirrored_names(&left.link.name.text)
            .into_iter()
            .find_map(|name| names.get(name.as_str()).copied());
        if let Some((j, right)) = found {
            let joints = [k, j].map(|link| tree.joint(link).and_then(|joint| model.joints.get(joint)));
            pair(left, right, joints, findings);
        }
    }
}

/// Returns the mirror between the positions of two joints; their frames must have their parents'
/// axes.
fn mirror_of_joints([left, right]: [Option<&Joint>; 2]) -> Option<[f64; 3]> {
    let place = |joint: Option<&Joint>| {
        let pose = &joint?.pose;
        (pose.rotation[0].abs() == 1.0).then_some(pose.position)
    };
    let (left, right) = (place(left)?, place(right)?);
    let distance = left.iter().map(|x| x * x).sum::<f64>().sqrt();
    let axis = (0..3).find(|k| (left[*k] - right[*k]).abs() > THERE * distance)?;
    let mut mirror = [1.0; 3];
    mirror[axis] = -1.0;
    (0..3).all(|k| (right[k] - mirror[k] * left[k]).abs() <= EQUAL * distance).then_some(mirror)
}

/// Returns the possible names of the right counterpart of a left link.
fn mirrored_names(name: &str) -> Vec<String> {
    let mut names = Vec::new();
    for (start, end) in words(name) {
        let Some(word) = name.get(start..end) else { continue };
        let lower = word.to_ascii_lowercase();
        for (_, right) in SIDES.iter().filter(|(left, _)| *left == lower) {
            let styled = if word.chars().all(|c| c.is_ascii_uppercase()) {
                right.to_ascii_uppercase()
            } else if word.starts_with(|c: char| c.is_ascii_uppercase()) {
                right[..1].to_ascii_uppercase() + &right[1..]
            } else {
                (*right).to_owned()
            };
            names.push(format!("{}{styled}{}", &name[..start], &name[end..]));
        }
    }
    names
}

/// Returns the ranges of words in a name. A word ends at a character that is not a letter, and
/// before a capital after a small letter or before one (`LHip` is L, Hip).
pub(super) fn words(name: &str) -> Vec<(usize, usize)> {
    let bytes = name.as_bytes();
    let mut words = Vec::new();
    let mut start = None;
    for (k, byte) in bytes.iter().enumerate() {
        let before = k.checked_sub(1).and_then(|p| bytes.get(p)).copied().unwrap_or(b' ');
        let after = bytes.get(k + 1).copied().unwrap_or(b' ');
        let hump = byte.is_ascii_uppercase()
            && (before.is_ascii_lowercase() || before.is_ascii_uppercase() && after.is_ascii_lowercase());
        if let Some(begin) = start.filter(|_| hump || !byte.is_ascii_alphabetic()) {
            words.push((begin, k));
            start = None;
        }
        if byte.is_ascii_alphabetic() && start.is_none() {
            start = Some(k);
        }
    }
    words.extend(start.map(|begin| (begin, bytes.len())));
    words
}

fn pair(left: &Body, right: &Body, joints: [Option<&Joint>; 2], findings: &mut Vec<Finding>) {
    let near = |a: f64, b: f64, size: f64| (a - b).abs() <= EQUAL * size;
    let alike = left.mass > 0.0
        && near(left.mass, right.mass, left.mass)
        && left.moments.are_possible(left.moments.values[2].abs() * EQUAL)
        && (0..3).all(|k| near(left.moments.values[k], right.moments.values[k], left.moments.values[2]));
    let distance = left.centre.iter().map(|x| x * x).sum::<f64>().sqrt();
    let same_centre = (0..3).all(|k| near(left.centre[k], right.centre[k], distance));
    let size = norm(&left.tensor);
    let equal_sizes = (0..6).all(|k| near(left.tensor[k].abs(), right.tensor[k].abs(), size));
    if !alike || !equal_sizes || !(size > 0.0) {
        return;
    }
    let fits = |s: &[f64; 3]| (0..3).all(|k| near(right.centre[k], s[k] * left.centre[k], distance));
    if same_centre && have_the_same_meshes(left.link, right.link) {
        return;
    }
    let consistent: Vec<[f64; 3]> = if same_centre {
        mirror_of_joints(joints).into_iter().filter(fits).collect()
    } else {
        MAPS.into_iter().filter(fits).collect()
    };
    let there: Vec<usize> = (3..6).filter(|k| left.tensor[*k].abs() > THERE * size).collect();
    let agrees = |s: &[f64; 3], k: usize| {
        let (a, b) = PLACES[k];
        left.tensor[k] * right.tensor[k] * s[a] * s[b] > 0.0
    };
    let mirrored = consistent.iter().find(|s| s.iter().product::<f64>() < 0.0);
    let Some(mirrored) = mirrored.filter(|_| !consistent.iter().any(|s| there.iter().all(|k| agrees(s, *k))))
    else {
        return;
    };
    let wrong: Vec<usize> = there.iter().copied().filter(|k| !agrees(mirrored, *k)).collect();
    let shown: Vec<String> = wrong
        .iter()
        .map(|k| format!("{} {} and {}", NAMES[*k], short(left.tensor[*k], 4), short(right.tensor[*k], 4)))
        .collect();
    let copied = there.iter().all(|k| left.tensor[*k] * right.tensor[*k] > 0.0);
    let how = if copied { "the same products" } else { "products with the wrong sign" };
    let message = format!(
        "{} / {}: mirrored links with {how}: {} kg·m²",
        left.link.name.text,
        right.link.name.text,
        shown.join(", ")
    );
    let rule =
        "for a body mirrored along x, ixy and ixz change sign; along y, ixy and iyz; along z, ixz and iyz";
    let span = wrong.first().map_or(right.tensor_place(), |k| right.place(*k));
    let mut found = finding("inertia.mirrored_pair", Severity::Suspect, right.link, span, message, rule);
    found.numbers = vec![("ixy", right.tensor[3]), ("ixz", right.tensor[4]), ("iyz", right.tensor[5])];
    findings.push(found);
}

/// Returns true if both links have meshes, and the same ones at the same poses.
fn have_the_same_meshes(left: &Link, right: &Link) -> bool {
    let meshes = |link: &Link| -> Vec<_> {
        let mesh = |geometry: &Geometry| {
            let (text, inline, scale) = match &geometry.shape {
                GeometryShape::Mesh { uri, scale, .. } => (Some(uri.text.clone()), None, *scale),
                GeometryShape::Inline { mesh: Ok(mesh), scale, .. } => (None, Some(Arc::clone(mesh)), *scale),
                _ => return None,
            };
            Some((text, inline, scale, geometry.pose.position, geometry.pose.rotation))
        };
        link.geometry.iter().filter_map(mesh).collect()
    };
    let left = meshes(left);
    !left.is_empty() && left == meshes(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_are_found_in_names() {
        for (left, right) in [
            ("l_hip", "r_hip"),
            ("LHip", "RHip"),
            ("left_knee_link", "right_knee_link"),
            ("kneeLeft", "kneeRight"),
            ("FL_calf", "FR_calf"),
            ("RL_calf", "RR_calf"),
            ("LF_SHANK", "RF_SHANK"),
            ("arm_left_3_link", "arm_right_3_link"),
            ("finger1_l", "finger1_r"),
            ("LEFT_ARM", "RIGHT_ARM"),
        ] {
            assert!(mirrored_names(left).iter().any(|n| n == right), "{left}: {:?}", mirrored_names(left));
        }
        for name in ["wheel", "link_3", "leftover", "ball", "R_hip", "élan", ""] {
            assert_eq!(mirrored_names(name), Vec::<String>::new(), "{name}");
        }
    }
}
