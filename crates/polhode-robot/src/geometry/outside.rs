//! Distance of a point from the convex hull of all shapes of a link.

use crate::model::{Link, Pose};
use crate::pose::dot;

use super::primitive::Primitive;
use super::separation::distance;
use super::{MeshReading, ShapeMesh, Shapes, z_up};

/// Support function of a convex part of the hull: its farthest point in a direction.
type Support<'s> = Box<dyn Fn([f64; 3]) -> [f64; 3] + 's>;

impl Shapes<'_> {
    /// Returns the distance of a point, in the link's frame, from the convex hull of all its
    /// shapes, m; zero inside.
    ///
    /// Returns `None` if a shape cannot be measured, or if there is none. A mesh whose up axis is
    /// ambiguous counts in both orientations.
    pub fn distance_outside(&self, link: &Link, point: [f64; 3]) -> Option<f64> {
        let mut meshes = Vec::new();
        let mut parts: Vec<Support<'_>> = Vec::new();
        for geometry in &link.geometry {
            if !geometry.pose.unreadable.is_empty() {
                return None;
            }
            match self.mesh_of(&geometry.shape) {
                Some(found) => {
                    let ShapeMesh { mesh, scale, .. } = found.ok()?;
                    mesh.measured.as_ref().ok()?;
                    meshes.push((mesh, scale, &geometry.pose));
                }
                None => {
                    let primitive = Primitive::of(&geometry.shape).ok()?;
                    let pose = &geometry.pose;
                    parts.push(Box::new(move |direction| primitive.support(pose, direction)));
                }
            }
        }
        for (mesh, scale, pose) in &meshes {
            let readings: &[bool] = match mesh.turned_in {
                None => &[false],
                Some(MeshReading::Usual | MeshReading::Other) => &[false, true],
            };
            for &turns in readings {
                let outline = mesh.outline();
                parts.push(Box::new(move |direction| farthest(outline, turns, *scale, pose, direction)));
            }
        }
        if parts.is_empty() {
            return None;
        }
        let support = |direction: [f64; 3]| {
            let ends = parts.iter().map(|part| part(direction));
            ends.max_by(|a, b| dot(*a, direction).total_cmp(&dot(*b, direction))).unwrap_or(point)
        };
        // Scale by the largest coordinate, so that squares do not overflow.
        let unit = point.iter().fold(1.0, |max, c| f64::max(max, c.abs()));
        let scaled = |v: [f64; 3]| v.map(|c| c / unit);
        let distance = distance(scaled(point), |direction| scaled(support(direction)));
        Some(unit * distance).filter(|distance| distance.is_finite())
    }
}

/// Returns the farthest point of a mesh in a direction. The direction is transformed to the frame
/// of the points.
pub(super) fn farthest(
    points: &[[f64; 3]],
    turns: bool,
    scale: [f64; 3],
    pose: &Pose,
    direction: [f64; 3],
) -> [f64; 3] {
    let rows = pose.matrix();
    let inner = [0, 1, 2].map(|j| scale[j] * (0..3).map(|i| rows[i][j] * direction[i]).sum::<f64>());
    let placed = |v: [f64; 3]| if turns { z_up(v) } else { v };
    let height = |v: &[f64; 3]| dot(placed(*v), inner);
    let best = points.iter().max_by(|a, b| height(a).total_cmp(&height(b))).copied().unwrap_or([0.0; 3]);
    let best = placed(best);
    pose.placed([0, 1, 2].map(|k| scale[k] * best[k]))
}
