//! Boxes around single shapes, for pictures.

use super::Shapes;
use crate::model::{Geometry, Link, Pose, Role};

/// Smallest box around a shape along the shape's own axes, in the link's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeBox {
    /// Centre, m.
    pub center: [f64; 3],
    /// Vectors from the centre to the middles of three faces, m.
    pub halves: [[f64; 3]; 3],
}

impl Shapes<'_> {
    /// Returns the boxes around the visual shapes of a link, or around its collision shapes if it
    /// has no visual ones. Shapes that cannot be measured have no box.
    pub(crate) fn boxes(&self, link: &Link) -> Vec<ShapeBox> {
        let is_seen = link.geometry.iter().any(|geometry| geometry.role == Role::Visual);
        let role = if is_seen { Role::Visual } else { Role::Collision };
        let seen = link.geometry.iter().filter(|geometry| geometry.role == role);
        seen.filter_map(|geometry| self.shape_box(geometry)).collect()
    }

    fn shape_box(&self, geometry: &Geometry) -> Option<ShapeBox> {
        let own = Geometry { pose: Pose::IDENTITY, ..geometry.clone() };
        let [low, high] = self.geometry(&own).ok()?.bounds;
        let pose = &geometry.pose;
        let halves = [0, 1, 2].map(|k| {
            let mut half = [0.0; 3];
            half[k] = 0.5 * (high[k] - low[k]);
            pose.turned(half)
        });
        let center = pose.placed([0, 1, 2].map(|k| 0.5 * (low[k] + high[k])));
        let is_finite = halves.as_flattened().iter().chain(&center).all(|x| x.is_finite());
        is_finite.then_some(ShapeBox { center, halves })
    }
}
