//! Affine map that places a mesh of a file.

use polhode::body::BodyError;
use polhode::body::mesh::TriangleMesh;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

/// Affine map x' = A x + t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Affine {
    /// Columns of A: the images of the three axes.
    pub columns: [[f64; 3]; 3],
    /// Translation t: the image of the origin.
    pub origin: [f64; 3],
}

impl Affine {
    pub(crate) const IDENTITY: Self =
        Self { columns: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin: [0.0; 3] };

    /// Returns the map of translation, rotation and scale, with the scale applied first: A = R(q)
    /// diag(s).
    ///
    /// q = (x, y, z, w) is a unit quaternion, scalar last.
    pub(crate) fn of_parts(translation: [f64; 3], [x, y, z, w]: [f64; 4], scale: [f64; 3]) -> Self {
        // R = | 1 − 2(yy + zz)   2(xy − zw)       2(xz + yw)     |
        //     | 2(xy + zw)       1 − 2(xx + zz)   2(yz − xw)     |
        //     | 2(xz − yw)       2(yz + xw)       1 − 2(xx + yy) |
        let columns = [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)],
            [2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)],
            [2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)],
        ];
        let scaled = |k: usize| columns[k].map(|c| c * scale[k]);
        Self { columns: [scaled(0), scaled(1), scaled(2)], origin: translation }
    }

    /// Composes two maps: first `first`, then this one.
    pub(crate) fn after(&self, first: &Self) -> Self {
        Self { columns: first.columns.map(|column| self.turned(column)), origin: self.point(first.origin) }
    }

    /// Maps a point: x' = A x + t.
    pub(crate) fn point(&self, x: [f64; 3]) -> [f64; 3] {
        let turned = self.turned(x);
        [0, 1, 2].map(|k| turned[k] + self.origin[k])
    }

    fn turned(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [a, b, c] = &self.columns;
        [0, 1, 2].map(|k| a[k] * x + b[k] * y + c[k] * z)
    }

    /// Returns true if det A < 0. The map then exchanges left- and right-handed, and with them
    /// outside and inside.
    fn mirrors(&self) -> bool {
        // Only the sign matters. Scaling the columns to size 1 keeps the determinant of a small map
        // from vanishing.
        let [a, b, c] = self.columns.map(|column| {
            let size = column.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            column.map(|x| x / size)
        });
        let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
        a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2] < 0.0
    }

    /// Returns the mapped mesh with its outside still outside. `place` returns the position of the
    /// map, for errors.
    pub(crate) fn placed(
        &self,
        vertices: &[[f64; 3]],
        triangles: &[[u32; 3]],
        place: impl Fn() -> String,
    ) -> Result<TriangleMesh, ContentError> {
        let vertices = vertices.iter().map(|&vertex| self.point(vertex)).collect();
        let triangles = match self.mirrors() {
            true => triangles.iter().map(|&[a, b, c]| [a, c, b]).collect(),
            false => triangles.to_vec(),
        };
        TriangleMesh::new(vertices, triangles).map_err(|e| {
            let kind = match e {
                BodyError::Vertex { vertex, .. } => {
                    ContentErrorKind::not_finite("the coordinate of a placed vertex", format!("{vertex:?}"))
                }
                e => ContentErrorKind::value("the mesh", e.to_string(), "triangles between its own vertices"),
            };
            ContentError::new(kind, ContentPlace::Within(place()))
        })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may")]
mod tests {
    use super::Affine;

    /// A rotation by 120° about (1, 1, 1) maps x to y, y to z and z to x.
    #[test]
    fn parts_are_translation_after_rotation_after_scale() {
        let map = Affine::of_parts([0.5, -3.0, 7.0], [0.5, 0.5, 0.5, 0.5], [2.0, 3.0, -5.0]);
        assert_eq!(map.point([1.0, 10.0, 100.0]), [-500.0 + 0.5, 2.0 - 3.0, 30.0 + 7.0]);
        assert!(map.mirrors());
    }

    #[test]
    fn the_second_map_acts_on_what_the_first_made() {
        let first = Affine::of_parts([1.0, 2.0, 4.0], [0.5, 0.5, 0.5, 0.5], [2.0, 4.0, 8.0]);
        let second = Affine::of_parts([-3.0, 5.0, 0.25], [0.5, -0.5, 0.5, 0.5], [0.5, 2.0, -16.0]);
        let x = [0.75, -1.5, 3.0];
        assert_eq!(second.after(&first).point(x), second.point(first.point(x)));
    }

    /// Its determinant is −6e-360, which underflows in f64.
    #[test]
    fn a_small_mirror_turns_the_winding() {
        let mirror = Affine {
            columns: [[1e-120, 0.0, 0.0], [0.0, 2e-120, 0.0], [0.0, 0.0, -3e-120]],
            ..Affine::IDENTITY
        };
        let mesh = mirror.placed(&[[1.0; 3], [2.0; 3], [3.0; 3]], &[[0, 1, 2]], String::new).unwrap();
        assert_eq!(mesh.triangles(), [[0, 2, 1]]);
    }
}
