//! Moving links without mass or inertia that programs reject, drop or change: `mass.refused`.
//!
//! The formats allow such links. Programs treat them differently; the sources are:
//!
//! - MuJoCo 3, `mjCModel::CheckBodyMassInertia` in `user_model.cc`. A body with a joint needs mass
//!   and three principal moments of at least `mjMINVAL` = 1e-15, its own or those of a jointless
//!   descendant. Otherwise the compiler rejects the model. In a URDF, a link without `<inertial>`
//!   gets its mass from collision geometry; `xml_urdf.cc` gives visual geometry the density 0.
//! - Gazebo, `CreateSDF` in `parser_urdf.cc` of libsdformat. A link without positive mass after
//!   fixed joints are lumped is not converted, with a warning. Its joints and all its descendants
//!   are lost, too. A link named `world` is exempt.
//! - Drake, `MultibodyTree::ThrowDefaultMassInertiaError`, which `Finalize` calls. It throws for a
//!   massless assembly of welded bodies that moves by a joint and carries no other moving body.
//! - Isaac Sim, a warning of `omni.physx`: "a possibly invalid inertia tensor … and a negative
//!   mass, small sphere approximated inertia was used". It is for a rigid body without mass and
//!   colliders. UsdPhysics ignores a mass of 0.
//!
//! The finding is a note, because the model may be intended for other programs. It is an error for
//! the programs that the user names.

use std::collections::HashSet;

use super::finding;
use super::tree::Tree;
use crate::finding::{Finding, Severity};
use crate::model::{Link, ModelFormat, RobotModel, Role, Slot, Tensor};
use crate::moments::{Elements, Moments};
use crate::program::Program;

/// Lower limit of mass and moments in MuJoCo (`mjMINVAL`), kg and kg·m².
const LEAST: f64 = 1e-15;

const RULE: &str = "a moving link has mass and moments of inertia";

/// Adds the rejections by programs: as errors for `programs`, otherwise as notes.
pub(super) fn check(model: &RobotModel, tree: &Tree, programs: &[Program], findings: &mut Vec<Finding>) {
    // The mass may be in a file that was not read.
    if model.notes.iter().any(|note| matches!(note.code, "read.include" | "read.left_out")) {
        return;
    }
    let is_told = |found: &&Finding| {
        found.severity >= Severity::Suspect
            && (found.code.starts_with("mass.") || found.code.starts_with("inertia."))
    };
    // Links with a mass that is stated but not read.
    let unread = model.notes.iter().filter(|note| matches!(note.code, "read.animated" | "read.numbers"));
    let told = findings.iter().filter(is_told).map(|found| found.subject.clone());
    let told: HashSet<String> = told.chain(unread.map(|note| note.subject.clone())).collect();
    for (k, link) in model.links.iter().enumerate().filter(|(_, link)| !link.is_static) {
        let refusals = refusals(model, tree, k, link);
        let (named, others): (Vec<_>, Vec<_>) =
            refusals.into_iter().partition(|refusal| programs.contains(&refusal.program));
        let place = || link.inertial.as_ref().map_or_else(|| link.name.span.clone(), |own| own.span.clone());
        if !named.is_empty() {
            let message = message(&named);
            findings.push(finding("mass.refused", Severity::Impossible, link, place(), message, RULE));
        }
        let others: Vec<_> = others.into_iter().filter(|refusal| refusal.is_noted).collect();
        if !others.is_empty() && !told.contains(&link.name.text) {
            let message = message(&others);
            findings.push(finding("mass.refused", Severity::Note, link, place(), message, RULE));
        }
    }
}

/// Program that does not accept a link as it is written.
struct Refusal {
    program: Program,
    /// True if the rejection is reported as a note for programs that are not named.
    is_noted: bool,
    /// True if the link has no mass; false if its mass or inertia is too small.
    is_massless: bool,
}

fn message(refusals: &[Refusal]) -> String {
    let what = if refusals.iter().any(|refusal| refusal.is_massless) {
        "moves without mass"
    } else {
        "moves with a mass or moment of inertia below 1e-15"
    };
    let does = |refusal: &Refusal| match refusal.program {
        Program::Mujoco => "MuJoCo refuses the model",
        Program::Gazebo => "Gazebo drops the link and all its descendants",
        Program::Drake => "Drake refuses the model",
        Program::Isaac => "Isaac Sim assumes the inertia of a small sphere",
    };
    format!("{what}: {}", refusals.iter().map(does).collect::<Vec<_>>().join(", "))
}

/// Returns the programs that do not accept a link together with the links fixed to it.
fn refusals(model: &RobotModel, tree: &Tree, k: usize, link: &Link) -> Vec<Refusal> {
    let is_root = tree.is_base(k);
    let moves = tree.moves_itself(k) || model.format == ModelFormat::Usd && tree.moves(k);
    if tree.group(k) != k || !(moves || is_root) {
        return Vec::new();
    }
    let group = tree.welded(k);
    let links = || group.iter().filter_map(|&k| model.links.get(k));
    let weighs = |kind: Weight| links().any(|link| weight(model.format, link) == kind);
    let is_massless = !weighs(Weight::Enough) && !weighs(Weight::Little);
    let has_collision =
        links().any(|link| link.geometry.iter().any(|geometry| geometry.role == Role::Collision));
    let is_welded = |link: usize| tree.group(link) == k;
    let is_terminal = group.iter().all(|&k| tree.hanging(k).iter().all(|(child, _)| is_welded(*child)));
    // MuJoCo checks only bodies with a joint, and needs one sufficient mass.
    let from_geoms = model.format == ModelFormat::Urdf
        && links()
            .any(|link| link.inertial.is_none() && link.geometry.iter().any(|g| g.role == Role::Collision));
    let mujoco = moves && !weighs(Weight::Enough) && !from_geoms && !tree.is_bounded();
    // In SDF a missing mass is 1 kg, and 0 kg is rejected by a separate rule.
    let gazebo = model.format == ModelFormat::Urdf && is_massless && link.name.text != "world";
    let drake = moves && is_massless && is_terminal && model.format == ModelFormat::Urdf;
    let isaac = moves && is_massless && !has_collision && model.format != ModelFormat::Mjcf;
    let all = [
        (Program::Mujoco, mujoco),
        (Program::Gazebo, gazebo && (moves || !is_terminal)),
        (Program::Drake, drake),
        (Program::Isaac, isaac),
    ];
    let refuses = |(program, refuses): &(Program, bool)| *refuses && program.reads(model.format);
    let refusal = |(program, _)| Refusal { program, is_noted: moves, is_massless };
    all.into_iter().filter(refuses).map(refusal).collect()
}

/// Mass and inertia of a link compared with [`LEAST`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Weight {
    /// All values are at least [`LEAST`], or a program computes them, or they cannot be read
    /// (reported elsewhere).
    Enough,
    /// Positive mass, but the mass or a moment is too small.
    Little,
    None,
}

fn weight(format: ModelFormat, link: &Link) -> Weight {
    let of = |mass: f64, tensor: &Elements| match Moments::of(tensor).values[0] {
        _ if mass <= 0.0 => Weight::None,
        least if mass < LEAST || least < LEAST => Weight::Little,
        _ => Weight::Enough,
    };
    match (&link.computed, &link.inertial) {
        (Some(Ok(computed)), _) => of(computed.mass, &computed.tensor),
        // USD: without mass, or with mass 0, the mass is computed from colliders.
        (Some(Err(_)), None) if format == ModelFormat::Usd => Weight::None,
        (Some(Err(_)), _) => Weight::Enough,
        (None, None) if link.from_geometry || format == ModelFormat::Sdf => Weight::Enough,
        (None, None) => Weight::None,
        (None, Some(inertial)) => {
            let Some(mass) = inertial.mass.finite() else { return Weight::Enough };
            if mass <= 0.0 {
                return Weight::None;
            }
            let numbers: Option<Vec<f64>> =
                inertial.tensor.slots().and_then(|slots| slots.map(Slot::finite).collect());
            match (&inertial.tensor, numbers.as_deref()) {
                // MuJoCo treats a zero tensor in a URDF as missing.
                (_, Some(numbers)) if format == ModelFormat::Urdf && numbers.iter().all(|x| *x == 0.0) => {
                    Weight::Enough
                }
                (Tensor::Six(_), Some(&[xx, yy, zz, xy, xz, yz])) => of(mass, &[xx, yy, zz, xy, xz, yz]),
                (Tensor::Diagonal(_), Some(&[a, b, c])) => of(mass, &[a, b, c, 0.0, 0.0, 0.0]),
                _ => Weight::Enough,
            }
        }
    }
}
