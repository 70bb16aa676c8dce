//! `<inertial auto="true">`: mass properties of a link from its collisions and their densities.
//!
//! m = Σ ρ_k V_k, with centre and tensor of the joined collisions. A stated mass scales m and the
//! tensor. The density ρ is that of the collision, else of the inertial, else 1000 kg/m³.
//!
//! Source: libsdformat 16, `Link::ResolveAutoInertials`, `Collision::CalculateInertial`,
//! `Geometry::CalculateInertial`. There, meshes are left to the simulator. Gazebo integrates over
//! the triangles; this module does the same for closed meshes.

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{Part, Position};

use crate::finding::Severity;
use crate::geometry::{Shapes, Volume, VolumeKind};
use crate::model::{ComputedMass, GeometryShape, Link, Note, Role};
use crate::read::computed::in_words;
use crate::read::xml::Element;

/// Default density, kg/m³.
const WATER: f64 = 1000.0;

/// Reason why a mass is not computed.
enum Fault {
    /// Error that libsdformat rejects.
    Refused(String),
    /// Value that cannot be computed here.
    Unknown(String),
}

/// Returns the error for a value of `auto` that is neither true nor false; libsdformat rejects it.
pub(super) fn unclear(inertial: Element<'_>) -> Option<String> {
    let word = inertial.word("auto")?;
    let is_clear = ["true", "1", "false", "0"].contains(&&*word.trim().to_ascii_lowercase());
    (!is_clear).then(|| format!("auto={word:?} of <inertial> is neither \"true\" nor \"false\""))
}

/// Sets the mass properties that libsdformat computes, and adds a note.
pub(super) fn compute(
    link: &mut Link,
    inertial: Element<'_>,
    element: Element<'_>,
    shapes: &Shapes<'_>,
    notes: &mut Vec<Note>,
) {
    let name = link.name.text.clone();
    let mut note = |severity, message| {
        notes.push(Note { severity, ..Note::new("inertia.computed", &name, inertial.span(), message) });
    };
    for overwritten in ["pose", "inertia"].into_iter().filter(|own| inertial.child(own).is_some()) {
        note(Severity::Suspect, format!("SDFormat overwrites <{overwritten}>, because auto=\"true\""));
    }
    let collisions: Vec<_> = element.named("collision").collect();
    let computed = parts(link, &collisions, inertial, shapes).and_then(|parts| together(&parts, inertial));
    link.computed = Some(match computed {
        Ok(computed) => {
            let count = match collisions.len() {
                1 => "1 collision".to_owned(),
                count => format!("{count} collisions"),
            };
            let is_stated = |element: &Element<'_>| element.child("density").is_some();
            let is_assumed = ["mass", "density"].iter().all(|own| inertial.child(own).is_none())
                && !collisions.iter().all(is_stated);
            let assumed = if is_assumed { " with the default density 1000 kg/m³" } else { "" };
            let message = format!("computed from {count}{assumed}: {}", in_words(&computed));
            note(Severity::Note, message);
            Ok(computed)
        }
        Err(Fault::Refused(why)) => {
            note(Severity::Impossible, format!("SDFormat refuses auto=\"true\": {why}"));
            Err(why)
        }
        Err(Fault::Unknown(why)) => {
            note(Severity::Note, format!("auto=\"true\" is not computed by `check`: {why}"));
            Err(why)
        }
    });
}

/// Returns the collisions as bodies with their densities.
fn parts(
    link: &Link,
    collisions: &[Element<'_>],
    inertial: Element<'_>,
    shapes: &Shapes<'_>,
) -> Result<Vec<MassProperties<Part>>, Fault> {
    if collisions.is_empty() {
        return Err(Fault::Refused("the link has no collision".to_owned()));
    }
    if shapes.is_turned_by_some(link, Role::Collision) {
        return Err(Fault::Unknown("programs disagree on the attitude of one of its meshes".to_owned()));
    }
    let geometry = link.geometry.iter().filter(|geometry| geometry.role == Role::Collision);
    let part = |(geometry, collision): (&crate::model::Geometry, &Element<'_>)| {
        let density = match positive(*collision, "density")? {
            Some(own) => own,
            None => positive(inertial, "density")?.unwrap_or(WATER),
        };
        if let Some(unreadable) = geometry.pose.unreadable.first() {
            return Err(Fault::Unknown(format!(
                "{:?} in the pose of a collision is not a number",
                unreadable.text
            )));
        }
        let volume = shapes.geometry(geometry).map_err(|why| match geometry.shape {
            GeometryShape::Mesh { .. } | GeometryShape::Inline { .. } | GeometryShape::Other(_) => {
                Fault::Unknown(why)
            }
            _ => Fault::Refused(why),
        })?;
        if volume.kind == VolumeKind::Hull {
            return Err(Fault::Unknown("one of its meshes is not closed".to_owned()));
        }
        body(&volume, density)
    };
    geometry.zip(collisions).map(part).collect()
}

fn body(volume: &Volume, density: f64) -> Result<MassProperties<Part>, Fault> {
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] =
        volume.tensor_per_density.map(|row| row.map(|x| density * x));
    let tensor = InertiaTensor::<Part>::with_negative_products([xx, yy, zz], [xy, xz, yz]);
    let center = Position::from_array(volume.centroid);
    tensor
        .and_then(|tensor| MassProperties::new(density * volume.volume, center, tensor))
        .map_err(|error| Fault::Unknown(error.to_string()))
}

/// Combines all parts and scales them to the stated mass.
fn together(parts: &[MassProperties<Part>], inertial: Element<'_>) -> Result<ComputedMass, Fault> {
    let all = MassProperties::combined(parts).map_err(|error| Fault::Unknown(error.to_string()))?;
    let mass = positive(inertial, "mass")?.unwrap_or(all.mass());
    let scale = mass / all.mass();
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = all.inertia().matrix();
    let tensor = [xx, yy, zz, xy, xz, yz].map(|element| scale * element);
    Ok(ComputedMass { mass, center: all.center_of_mass().to_array(), tensor })
}

/// Returns the positive number in a child element, if it is present.
fn positive(parent: Element<'_>, name: &str) -> Result<Option<f64>, Fault> {
    let Some(child) = parent.child(name) else { return Ok(None) };
    let written = child.text();
    match written.as_ref().and_then(|written| written.number().value).filter(|x| *x > 0.0 && x.is_finite()) {
        Some(value) => Ok(Some(value)),
        None => {
            let text = written.map_or("", |written| written.value);
            Err(Fault::Refused(format!("its {name} is {text:?}; expected a positive number")))
        }
    }
}
