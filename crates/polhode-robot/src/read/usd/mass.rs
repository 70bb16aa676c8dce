//! Mass properties that UsdPhysics computes from the colliders of a body.
//!
//! A collider has its own mass, or a density times its volume. The density is the first of: its own,
//! the body's, that of its bound physics material, 1000 kg/m³. A stated mass of the body scales the
//! sum. A stated centre moves it, with I' = I + m (d² 1 − d dᵀ); a stated tensor replaces it.
//!
//! Source: OpenUSD 26.11, `UsdPhysicsRigidBodyAPI::ComputeMassProperties`, which the tests compare.
//! There, moments below 1e-5 count as not stated; here only 0 does.

use super::body::{self, AXES, CENTER, MASS, MOMENTS};
use super::layer::Prim;
use super::path::absolute;
use super::xform::numbers;
use super::{Stage, applies};
use crate::geometry::Shapes;
use crate::model::{ComputedMass, Geometry, GeometryShape, Link, Note, Pose};
use crate::moments::{Elements, parallel_axes, rotated, scaled};
use crate::pose::unit;
use crate::read::computed::in_words;

pub(super) const DENSITY: &str = "physics:density";

/// Default density, kg/m³.
const WATER: f64 = 1000.0;

/// Mass, centre and tensor that a prim states; each may be missing.
struct Stated {
    mass: Option<f64>,
    center: Option<[f64; 3]>,
    tensor: Option<Elements>,
}

impl Stated {
    fn of(stage: &Stage<'_>, prim: &Prim) -> Result<Self, String> {
        let given = |name: &str| prim.properties.get(name).filter(|value| value.is_given());
        let wrong = |name: &str| format!("{name} of {} is not a finite number", prim.path);
        let units = stage.units;
        let mass = given(MASS).map(|mass| numbers::<1>(mass).ok_or_else(|| wrong(MASS))).transpose()?;
        if mass.is_some_and(|[mass]: [f64; 1]| mass < 0.0) {
            return Err(format!("{MASS} of {} is negative", prim.path));
        }
        let center = prim.properties.get(CENTER).filter(|center| !body::is_left_out(center));
        let center = center.map(|center| numbers::<3>(center).ok_or_else(|| wrong(CENTER))).transpose()?;
        let moments = given(MOMENTS).map(|m| numbers::<3>(m).ok_or_else(|| wrong(MOMENTS))).transpose()?;
        let axes = given(AXES).map(|axes| numbers::<4>(axes).and_then(unit).ok_or_else(|| wrong(AXES)));
        let axes = axes.transpose()?.unwrap_or(Pose::IDENTITY.rotation);
        let unit = units.kilograms * units.metres * units.metres;
        let tensor = moments.map(|[a, b, c]| {
            let own = [a, b, c].map(|moment: f64| unit * moment);
            rotated(&[own[0], own[1], own[2], 0.0, 0.0, 0.0], &Pose::new([0.0; 3], axes).matrix())
        });
        Ok(Self {
            mass: mass.map(|[mass]| units.kilograms * mass),
            center: center.map(|center| center.map(|c: f64| units.metres * c)),
            tensor,
        })
    }
}

/// Colliders of a body.
pub(super) struct Colliders<'l> {
    /// Body; `None` if nothing is computed for it.
    pub(super) body: Option<&'l Prim>,
    /// Index of the prim of each collider, and of its geometry in the link.
    pub(super) shapes: Vec<(usize, usize)>,
}

impl Colliders<'_> {
    /// Notes a collider whose shape is not read: nothing is computed.
    pub(super) fn without_shape(&mut self, prim: &Prim, link: &mut Link) {
        if link.inertial.is_none() {
            link.computed = Some(Err(format!("the shape of {} is not read", prim.path)));
        }
        self.body = None;
    }

    /// Computes what the body of a link does not state.
    pub(super) fn compute(&self, stage: &Stage<'_>, link: &mut Link, notes: &mut Vec<Note>) {
        let Some(body) = self.body.filter(|_| !self.shapes.is_empty()) else { return };
        match computed(stage, body, link, &self.shapes) {
            Ok(None) => {}
            Ok(Some((computed, is_assumed))) => {
                let assumed = if is_assumed { " with the default density 1000 kg/m³" } else { "" };
                let count = match self.shapes.len() {
                    1 => "1 collider".to_owned(),
                    count => format!("{count} colliders"),
                };
                let message = format!("computed from {count}{assumed}: {}", in_words(&computed));
                notes.push(Note::new("inertia.computed", &link.name.text, link.span.clone(), message));
                link.computed = Some(Ok(computed));
            }
            Err(why) if link.computed.is_some() => link.computed = Some(Err(why)),
            // The missing tensor is reported otherwise.
            Err(_) => {}
        }
    }
}

/// Returns the mass properties, and true if the default density counts; `None` if all are stated.
fn computed(
    stage: &Stage<'_>,
    body: &Prim,
    link: &Link,
    colliders: &[(usize, usize)],
) -> Result<Option<(ComputedMass, bool)>, String> {
    let stated = Stated::of(stage, body)?;
    if let Stated { mass: Some(_), center: Some(_), tensor: Some(_) } = stated {
        return Ok(None);
    }
    if let Some(unreadable) = link.pose.unreadable.first() {
        return Err(format!("{:?} in its pose is not a number", unreadable.text));
    }
    if stage.place(stage.numbers.get(body.path.as_str()).copied().unwrap_or(0)).is_scaled()
        && (stated.center.is_some() || stated.tensor.is_some())
    {
        return Err("its prim is scaled, and physics engines apply the scale differently".to_owned());
    }
    let density = density(stage, body)?;
    let (mut parts, mut is_assumed) = (Vec::new(), false);
    for &(prim, geometry) in colliders {
        if let (Some(prim), Some(geometry)) = (stage.layer.prims.get(prim), link.geometry.get(geometry)) {
            let (part, has_default) = collider(stage, prim, geometry, density)?;
            is_assumed |= has_default && stated.mass.is_none();
            parts.push(part);
        }
    }
    let all = joined(&parts);
    let mass = stated.mass.unwrap_or(all.mass);
    let center = stated.center.unwrap_or(all.center);
    let tensor = stated.tensor.unwrap_or_else(|| {
        let scaled = scaled(&all.tensor, mass / all.mass);
        shifted(&scaled, mass, [0, 1, 2].map(|k| center[k] - all.center[k]))
    });
    Ok(Some((ComputedMass { mass, center, tensor }, is_assumed)))
}

/// Returns the mass properties of a collider in the frame of its body, and true if the default
/// density counts.
fn collider(
    stage: &Stage<'_>,
    prim: &Prim,
    geometry: &Geometry,
    of_body: Option<f64>,
) -> Result<(ComputedMass, bool), String> {
    if let Some(unreadable) = geometry.pose.unreadable.first() {
        return Err(format!("{:?} in the pose of {} is not a number", unreadable.text, prim.path));
    }
    let stated = Stated::of(stage, prim)?;
    if matches!(geometry.shape, GeometryShape::Inline { .. }) {
        return Err(format!(
            "{}: a physics engine computes the mass of a mesh from its own approximation",
            prim.path
        ));
    }
    let volume = Shapes::with_threads(1).geometry(geometry).map_err(|why| format!("{}: {why}", prim.path))?;
    let density = match density(stage, prim)?.or(of_body) {
        Some(density) => Some(density),
        None => material(stage, prim)?,
    };
    let is_assumed = stated.mass.is_none() && density.is_none();
    let mass = stated.mass.unwrap_or(density.unwrap_or(WATER) * volume.volume);
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = volume.tensor_per_density;
    let mut own = ComputedMass {
        mass,
        center: volume.centroid,
        tensor: scaled(&[xx, yy, zz, xy, xz, yz], mass / volume.volume),
    };
    if stated.center.is_some() || stated.tensor.is_some() {
        let k = stage.numbers.get(prim.path.as_str()).copied().unwrap_or(0);
        if stage.place(k).is_scaled() {
            return Err(format!("{} is scaled and states its own centre or moments", prim.path));
        }
        // The frame of the shape may be turned to its axis.
        let pose = stage.pose_in_body(k).unwrap_or(Pose::IDENTITY);
        if let Some(center) = stated.center {
            let center = pose.placed(center);
            own.tensor = shifted(&own.tensor, mass, [0, 1, 2].map(|k| center[k] - own.center[k]));
            own.center = center;
        }
        if let Some(tensor) = stated.tensor {
            own.tensor = rotated(&tensor, &pose.matrix());
        }
    }
    Ok((own, is_assumed))
}

/// Returns the density that a prim states, kg/m³.
fn density(stage: &Stage<'_>, prim: &Prim) -> Result<Option<f64>, String> {
    let Some(value) = prim.properties.get(DENSITY).filter(|value| value.is_given()) else { return Ok(None) };
    let [density] =
        numbers::<1>(value).ok_or_else(|| format!("{DENSITY} of {} is not a number", prim.path))?;
    let unit = stage.units.kilograms / stage.units.metres.powi(3);
    if density < 0.0 {
        return Err(format!("{DENSITY} of {} is negative", prim.path));
    }
    Ok(Some(unit * density))
}

/// Returns the density of the physics material that is bound to a prim or to the nearest ancestor.
fn material(stage: &Stage<'_>, prim: &Prim) -> Result<Option<f64>, String> {
    for purpose in ["material:binding:physics", "material:binding"] {
        let mut around = stage.numbers.get(prim.path.as_str()).copied();
        while let Some(prim) = around.and_then(|k| stage.layer.prims.get(k)) {
            if let Some(name) =
                prim.properties.keys().filter(|name| name.starts_with("material:binding:collection")).min()
            {
                return Err(format!("{name} of {} is not read", prim.path));
            }
            if let Some(path) = prim.properties.get(purpose).and_then(|binding| binding.words.first()) {
                let path = absolute(path, &prim.path);
                let material = stage.numbers.get(path.as_str()).and_then(|&k| stage.layer.prims.get(k));
                let material = material.ok_or_else(|| format!("its material {path} is not read"))?;
                return if applies(material, "PhysicsMaterialAPI") {
                    density(stage, material)
                } else {
                    Ok(None)
                };
            }
            around = prim.parent;
        }
    }
    Ok(None)
}

/// Combines the parts: c = Σ m_k c_k / m,  I = Σ (I_k + m_k (d² 1 − d dᵀ)),  d = c_k − c.
fn joined(parts: &[ComputedMass]) -> ComputedMass {
    let mass: f64 = parts.iter().map(|part| part.mass).sum();
    let center = [0, 1, 2].map(|k| parts.iter().map(|part| part.mass * part.center[k]).sum::<f64>() / mass);
    let mut tensor: Elements = [0.0; 6];
    for part in parts {
        let moved = shifted(&part.tensor, part.mass, [0, 1, 2].map(|k| part.center[k] - center[k]));
        tensor = std::array::from_fn(|k| tensor[k] + moved[k]);
    }
    ComputedMass { mass, center, tensor }
}

/// Returns a tensor about a point that is at a distance from the centre.
fn shifted(tensor: &Elements, mass: f64, distance: [f64; 3]) -> Elements {
    let moved = parallel_axes(mass, distance);
    std::array::from_fn(|k| tensor[k] + moved[k])
}
