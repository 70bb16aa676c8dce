//! Geometry of one link, as evidence for its mass properties.

use super::material::is_solid;
use crate::geometry::{MeshReading, ShapeBox, Shapes, Volume};
use crate::model::{Geometry, Link, Role};

/// Solids of one link, and the position of its centre of mass relative to them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinkGeometry {
    /// Candidate solids: the total of the visual shapes, and that of the collision shapes.
    /// Agreement with one of them is sufficient.
    pub volumes: Vec<Volume>,
    /// Bounds of x, y, z over all solids, in the link's frame, m; `None` if there are none.
    pub bounds: Option<[[f64; 3]; 2]>,
    /// Boxes around the shapes, for pictures: around the visual ones if there are any.
    pub boxes: Vec<ShapeBox>,
    /// True if programs disagree on the up axis of a mesh. Then each orientation is a candidate,
    /// and axes are not evidence.
    pub is_turned_by_some: bool,
    /// True if a shape could not be measured. The other shapes may then be a simplified part of the
    /// link.
    pub is_incomplete: bool,
    /// Distance of the inertial's centre of mass from the convex hull of all shapes, m; `None` if
    /// it is inside or unknown.
    pub outside: Option<f64>,
    /// Solids with all sizes multiplied by a factor; only if no solid has a plausible density as
    /// written.
    pub rescaled: Vec<Rescaled>,
}

/// Solids of a link whose sizes are assumed to be in another unit than metres.
#[derive(Clone, Debug, PartialEq)]
pub struct Rescaled {
    /// Factor applied to all sizes: 0.001 for millimetres.
    pub factor: f64,
    /// Solids with these sizes, in the order of [`LinkGeometry::volumes`].
    pub volumes: Vec<Volume>,
}

/// Units of length in which meshes are exported, m, and their inverses for meshes that were scaled
/// twice.
const UNITS: [f64; 6] = [0.001, 0.01, 0.0254, 1000.0, 100.0, 1.0 / 0.0254];

impl LinkGeometry {
    /// Measures the shapes of a link. A role counts only if all of its shapes can be measured,
    /// because a part of a body proves nothing.
    pub fn of(link: &Link, shapes: &Shapes<'_>) -> Self {
        let mut geometry = Self::measured(link, shapes);
        if cfg!(feature = "languages") {
            geometry.boxes = shapes.boxes(link);
        }
        let inertial = link.inertial.as_ref().filter(|inertial| inertial.pose.unreadable.is_empty());
        let Some(inertial) = inertial else { return geometry };
        geometry.outside =
            shapes.distance_outside(link, inertial.pose.position).filter(|distance| *distance > 0.0);
        if let Some(mass) = inertial.mass.finite().filter(|mass| *mass > 0.0) {
            let is_plausible = geometry.volumes.iter().any(|volume| is_solid(mass / volume.volume));
            if !is_plausible && !geometry.volumes.is_empty() {
                let rescaled = |factor: f64| {
                    let volumes = Self::measured(&resized(link, factor), shapes).volumes;
                    Rescaled { factor, volumes }
                };
                geometry.rescaled = UNITS.into_iter().map(rescaled).collect();
            }
        }
        geometry
    }

    fn measured(link: &Link, shapes: &Shapes<'_>) -> Self {
        let mut geometry = Self::default();
        for role in [Role::Visual, Role::Collision] {
            let both = shapes.is_turned_by_some(link, role);
            geometry.is_turned_by_some |= both;
            let others = both.then_some(MeshReading::Other);
            for reading in [MeshReading::Usual].into_iter().chain(others) {
                let set = shapes.link_as(link, role, reading);
                geometry.is_incomplete |= !set.left_out.is_empty();
                let Some(volume) = set.volume.filter(|_| set.left_out.is_empty()) else { continue };
                geometry.bounds = Some(geometry.bounds.map_or(volume.bounds, |[low, high]| {
                    let [other_low, other_high] = volume.bounds;
                    [
                        [0, 1, 2].map(|k| low[k].min(other_low[k])),
                        [0, 1, 2].map(|k| high[k].max(other_high[k])),
                    ]
                }));
                geometry.volumes.push(volume);
            }
        }
        geometry
    }
}

/// Returns the link with the sizes of its shapes multiplied by a factor. Their positions stay,
/// because these are in the model's own unit.
fn resized(link: &Link, factor: f64) -> Link {
    let shape = |geometry: &Geometry| Geometry { shape: geometry.shape.resized(factor), ..geometry.clone() };
    Link { geometry: link.geometry.iter().map(shape).collect(), ..link.clone() }
}
