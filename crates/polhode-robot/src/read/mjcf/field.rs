//! Meshes from the five signed distance functions of MuJoCo: `<mesh><plugin instance="…"/></mesh>`.
//!
//! MuJoCo samples the distances on a grid of about a million points, in single precision, and
//! extracts the zero surface. It does not rotate such a mesh to its principal axes, as it does with
//! other meshes. Nevertheless it uses the principal moments about the axes of the geom, the largest
//! about x, and puts the centre at the geom's origin. This reader does the same.
//!
//! Source: MuJoCo 3.12, `mjCMesh::LoadSDF`; results of versions 3.17 and 4.0 for the same files.

mod cubes;
mod shape;

use crate::read::xml::Element;

use super::surface::Surface;
use shape::Shape;

/// Shape that is given by its signed distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Field {
    shape: Shape,
    /// Half edges of the sampled box around the origin, m.
    half: [f64; 3],
    /// Number of grid points along the axes.
    count: [usize; 3],
}

impl Field {
    /// Reads the plugin of a mesh; its instances are below the model's root. `None` without a
    /// plugin.
    pub(super) fn of(mesh: Element<'_>, root: Element<'_>) -> Option<Result<Self, String>> {
        let plugin = mesh.child("plugin")?;
        let read = || {
            let (name, element) = match plugin.word("instance") {
                Some(instance) => instances(root)
                    .find(|(_, element)| element.word("name") == Some(instance))
                    .ok_or_else(|| format!("its plugin has no instance {instance:?}"))?,
                None => (plugin.word("plugin").unwrap_or(""), plugin),
            };
            let shape = Shape::of(name, element)?;
            Self::around(shape)
                .ok_or_else(|| format!("its mesh is a {name} whose sizes define no bounding box"))
        };
        Some(read())
    }

    fn around(shape: Shape) -> Option<Self> {
        /// Number of grid points along the three edges together, minus three.
        const POINTS: f64 = 300.0;
        let half = shape.half_box();
        if !half.iter().all(|half| *half > 0.0 && half.is_finite()) {
            return None;
        }
        let total: f64 = half.iter().sum();
        let count = half.map(|half| (POINTS / total * half).floor() as usize + 1);
        count.iter().all(|count| *count > 1).then_some(Self { shape, half, count })
    }

    /// Returns the number of grid points.
    pub(super) fn points(self) -> usize {
        self.count.iter().product()
    }

    /// Returns the zero surface of the distance.
    pub(super) fn surface(self) -> Surface {
        let [nx, ny, nz] = self.count;
        let place = |axis: usize, k: f64| {
            let half = self.half[axis];
            2.0 * half * k / (self.count[axis] - 1) as f64 - half
        };
        let mut distances = Vec::with_capacity(self.points());
        for k in 0..nz {
            for j in 0..ny {
                distances.extend((0..nx).map(|i| {
                    let point = [place(0, i as f64), place(1, j as f64), place(2, k as f64)];
                    self.shape.distance(point) as f32
                }));
            }
        }
        let vertices = cubes::triangles(&distances, self.count).into_iter().flatten();
        let vertices: Vec<_> =
            vertices.map(|vertex| [0, 1, 2].map(|axis| place(axis, f64::from(vertex[axis])))).collect();
        let triangles = (0..vertices.len() as u32 / 3).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
        Surface { vertices, triangles }
    }
}

/// Returns the instances of all plugins, each with the name of its plugin.
fn instances<'a>(root: Element<'a>) -> impl Iterator<Item = (&'a str, Element<'a>)> {
    let plugins = root.named("extension").flat_map(|extension| extension.named("plugin"));
    plugins.flat_map(|plugin| {
        let name = plugin.word("plugin").unwrap_or("");
        plugin.named("instance").map(move |instance| (name, instance))
    })
}
