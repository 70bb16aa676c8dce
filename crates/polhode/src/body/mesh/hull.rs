//! Convex hulls of points.

use super::TriangleMesh;
use super::predicate::side;
use super::weld::NONE;
use crate::body::error::{BodyError, finite};
use crate::body::triangle_mesh::normal;
use crate::math::symmetric3::power_of_two_near;

/// Convex hull: the smallest convex solid that contains given points.
///
/// The algorithm is Quickhull. It starts from a tetrahedron and repeatedly adds the point farthest
/// above a face. Exact signs decide which points are above a face, so that points on faces or edges
/// and many coplanar points are handled correctly: the hull contains every point. Its faces are
/// outward-oriented triangles with corners at given points; no vertex lies inside a face or an
/// edge.
///
/// The expected time is O(n log n). The result is the same for the same points in the same order.
///
/// Source: Barber, Dobkin & Huhdanpaa, ACM Trans. Math. Softw. 22 (1996) 469.
///
/// ```
/// use polhode::body::mesh::{ClosedMesh, ConvexHull};
/// let corners = (0..8).map(|k| [k & 1, k >> 1 & 1, k >> 2].map(f64::from));
/// let points: Vec<_> = corners.chain([[0.5, 0.2, 0.7], [1.0, 0.5, 0.5]]).collect();
/// let hull = ConvexHull::of(&points)?;
/// assert_eq!((hull.coordinates().len(), hull.triangles().len()), (8, 12));
/// assert_eq!(ClosedMesh::of(&hull)?.volume(), 1.0);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ConvexHull;

impl ConvexHull {
    /// Returns the surface of the hull, with vertices in the order of the input.
    ///
    /// # Errors
    /// [`BodyError::Empty`] if `points` is empty; [`BodyError::Parameter`] for a coordinate that is
    /// not finite; [`BodyError::FlatPoints`] if all points are coplanar.
    pub fn of(points: &[[f64; 3]]) -> Result<TriangleMesh, BodyError> {
        for &point in points {
            finite("the point's coordinate", point)?;
        }
        if points.is_empty() {
            return Err(BodyError::Empty { what: "points" });
        }
        let largest = points.as_flattened().iter().fold(0.0_f64, |max, c| max.max(c.abs()));
        let per_unit = 1.0 / power_of_two_near(largest);
        // Lengths are scaled by a power of two near the largest coordinate: this is exact, and no
        // product overflows.
        let reduced: Vec<[f64; 3]> = points.iter().map(|p| p.map(|c| c * per_unit)).collect();
        let simplex = simplex(&reduced).ok_or_else(|| flat(&reduced))?;
        let mut hull = Growing::of(&reduced, simplex);
        while let Some(face) = hull.waiting.pop() {
            hull.grow(face);
        }
        Ok(hull.mesh(points))
    }
}

/// Returns the error for coplanar points.
fn flat(points: &[[f64; 3]]) -> BodyError {
    let first = points[0];
    let place = match points.iter().find(|point| **point != first) {
        None => "at one place",
        Some(&other) => {
            let is_beside = |&point: &[f64; 3]| super::predicate::facing([first, other, point]).is_some();
            if points.iter().any(is_beside) { "in one plane" } else { "on one line" }
        }
    };
    BodyError::FlatPoints { count: points.len(), place }
}

/// Returns four points that are not coplanar and far apart: a tetrahedron with (0, 1, 2)
/// counter-clockwise seen from outside.
fn simplex(points: &[[f64; 3]]) -> Option<[u32; 4]> {
    let point = |k: usize| points[k];
    let distance = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum::<f64>();
    let a = (0..points.len()).min_by(|&i, &j| point(i)[0].total_cmp(&point(j)[0]))?;
    let farthest = |measure: &dyn Fn(usize) -> f64| {
        (0..points.len()).max_by(|&i, &j| measure(i).total_cmp(&measure(j)).then(j.cmp(&i)))
    };
    let b = farthest(&|k| distance(point(a), point(k)))?;
    let squared = |[x, y, z]: [f64; 3]| x * x + y * y + z * z;
    // If rounding hides the farthest point, any point that exact signs accept is sufficient.
    let on_a_line = |k: usize| super::predicate::facing([point(a), point(b), point(k)]).is_none();
    let c = farthest(&|k| squared(normal([point(a), point(b), point(k)])))?;
    let c = if on_a_line(c) { (0..points.len()).find(|&k| !on_a_line(k))? } else { c };
    let height = |k: usize| side([point(a), point(b), point(c)], point(k));
    let d = farthest(&|k| height(k).abs())?;
    let simplex = if height(d) > 0.0 { [a, c, b, d] } else { [a, b, c, d] };
    (height(d) != 0.0).then_some(simplex.map(|k| k as u32))
}

struct Face {
    corners: [u32; 3],
    /// Faces across the edges from each corner to the next.
    neighbours: [u32; 3],
    /// Points above this face; each point is in the list of one face only.
    above: Vec<u32>,
    removed: bool,
    /// Last point compared with this face, and its position relative to the face.
    seen: (u32, Seen),
}

/// Position of a point relative to the plane of a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Seen {
    Above,
    InPlane,
    Below,
}

/// Hull of some of the points; each other point is above one of its faces or inside it.
struct Growing<'a> {
    points: &'a [[f64; 3]],
    faces: Vec<Face>,
    /// Faces with points above them.
    waiting: Vec<u32>,
    /// New face whose horizon edge starts at each vertex.
    fan: Vec<u32>,
    /// Last apex for which `covers` was evaluated at each vertex.
    examined: Vec<u32>,
    /// Number of removed faces that are still in the list.
    removed: usize,
}

impl<'a> Growing<'a> {
    fn of(points: &'a [[f64; 3]], [a, b, c, d]: [u32; 4]) -> Self {
        let none = || vec![NONE; points.len()];
        let (faces, waiting, removed) = (vec![], vec![], 0);
        let mut hull = Self { points, faces, waiting, fan: none(), examined: none(), removed };
        for (corners, neighbours) in
            [([a, b, c], [1, 2, 3]), ([b, a, d], [0, 3, 2]), ([c, b, d], [0, 1, 3]), ([a, c, d], [0, 2, 1])]
        {
            hull.push(corners, neighbours);
        }
        hull.hand_out((0..points.len() as u32).collect(), 0);
        hull
    }

    fn push(&mut self, corners: [u32; 3], neighbours: [u32; 3]) -> u32 {
        let seen = (NONE, Seen::Below);
        self.faces.push(Face { corners, neighbours, above: vec![], removed: false, seen });
        self.faces.len() as u32 - 1
    }

    fn height(&self, face: u32, point: u32) -> f64 {
        let corners = self.faces[face as usize].corners.map(|v| self.points[v as usize]);
        side(corners, self.points[point as usize])
    }

    /// Assigns each point to the first face, from index `first` on, that it is above. Points above
    /// no face are discarded.
    fn hand_out(&mut self, points: Vec<u32>, first: usize) {
        for point in points {
            let above = (first..self.faces.len()).find(|&face| self.height(face as u32, point) > 0.0);
            if let Some(face) = above {
                self.faces[face].above.push(point);
            }
        }
        let with_points = (first..self.faces.len()).filter(|&face| !self.faces[face].above.is_empty());
        self.waiting.extend(with_points.map(|face| face as u32));
    }

    /// Adds the point farthest above a face to the hull.
    fn grow(&mut self, face: u32) {
        if self.faces[face as usize].removed {
            return;
        }
        let above = &self.faces[face as usize].above;
        let farther =
            |&&i: &&u32, &&j: &&u32| self.height(face, i).total_cmp(&self.height(face, j)).then(j.cmp(&i));
        let Some(&apex) = above.iter().max_by(farther) else { return };
        let covered = self.covered_from(apex, face);
        let horizon = self.horizon(&covered);
        let mut orphans = Vec::new();
        for &face in &covered {
            orphans.append(&mut self.faces[face as usize].above);
        }
        orphans.retain(|&point| point != apex);
        let first = self.faces.len();
        for &(beyond, edge) in &horizon {
            // The edge of the face beyond runs from b to a; that of the new face from a to b.
            let corners = self.faces[beyond as usize].corners;
            let (b, a) = (corners[edge], corners[(edge + 1) % 3]);
            let new = self.push([a, b, apex], [beyond, NONE, NONE]);
            self.faces[beyond as usize].neighbours[edge] = new;
            self.fan[a as usize] = new;
        }
        for new in first..self.faces.len() {
            // The next face of the fan starts at b.
            let next = self.fan[self.faces[new].corners[1] as usize];
            self.faces[new].neighbours[1] = next;
            self.faces[next as usize].neighbours[2] = new as u32;
        }
        self.hand_out(orphans, first);
        self.removed += covered.len();
        if self.removed > 1000 && 2 * self.removed > self.faces.len() {
            self.drop_removed();
        }
    }

    /// Drops removed faces and keeps the order. Among many points on a circle, a face is removed
    /// and created many times.
    fn drop_removed(&mut self) {
        let mut count = 0;
        let mut number = |face: &Face| {
            count += u32::from(!face.removed);
            if face.removed { NONE } else { count - 1 }
        };
        let numbers: Vec<u32> = self.faces.iter().map(&mut number).collect();
        self.faces.retain(|face| !face.removed);
        for face in &mut self.faces {
            face.neighbours = face.neighbours.map(|neighbour| numbers[neighbour as usize]);
        }
        self.waiting.retain(|face| numbers[*face as usize] != NONE);
        for face in &mut self.waiting {
            *face = numbers[*face as usize];
        }
        self.removed = 0;
    }

    /// Removes the faces that a point is above, connected with this one, and the faces whose plane
    /// contains it if they have a corner that stops being a vertex. Returns the removed faces.
    ///
    /// So no new triangle has zero area, and no vertex remains inside a face or an edge. A face of
    /// many triangles, such as the end of a cylinder, is not rebuilt for each of its corners.
    fn covered_from(&mut self, apex: u32, face: u32) -> Vec<u32> {
        let mut covered = vec![face];
        self.faces[face as usize].removed = true;
        let mut k = 0;
        while let Some(&face) = covered.get(k) {
            for neighbour in self.faces[face as usize].neighbours {
                if self.seen_from(apex, neighbour) == Seen::Above {
                    self.remove(neighbour, &mut covered);
                }
            }
            k += 1;
        }
        for k in 0..covered.len() {
            let face = covered[k];
            for vertex in self.faces[face as usize].corners {
                let examined = &mut self.examined[vertex as usize];
                if *examined == apex {
                    continue;
                }
                *examined = apex;
                if self.covers(apex, vertex, face) {
                    let mut around = self.around(vertex, face, 0);
                    while around != face {
                        self.remove(around, &mut covered);
                        around = self.around(vertex, around, 0);
                    }
                }
            }
        }
        covered
    }

    fn remove(&mut self, face: u32, covered: &mut Vec<u32>) {
        if !self.faces[face as usize].removed {
            self.faces[face as usize].removed = true;
            covered.push(face);
        }
    }

    fn seen_from(&mut self, apex: u32, face: u32) -> Seen {
        let (from, seen) = self.faces[face as usize].seen;
        if from == apex {
            return seen;
        }
        let height = self.height(face, apex);
        let seen = match height {
            _ if height > 0.0 => Seen::Above,
            _ if height < 0.0 => Seen::Below,
            _ => Seen::InPlane,
        };
        self.faces[face as usize].seen = (apex, seen);
        seen
    }

    /// Returns true if corner v of this face stops being a vertex when the apex p is added: no face
    /// at v has p below it.
    ///
    /// If nᵢ · (p − v) ≥ 0 for all normals nᵢ at v, a point slightly beyond v, seen from p, lies in
    /// the hull, so that v is between p and that point. Conversely, if v is between p and a point q
    /// of the hull, nᵢ · (q − v) ≤ 0 gives the same condition. The faces around v are visited in
    /// both directions at once; the first face below ends the search, however many faces are in the
    /// other direction.
    fn covers(&mut self, apex: u32, vertex: u32, face: u32) -> bool {
        let mut ways = [face; 2];
        loop {
            for (way, turn) in [2, 0].into_iter().enumerate() {
                ways[way] = self.around(vertex, ways[way], turn);
                if self.seen_from(apex, ways[way]) == Seen::Below {
                    return false;
                }
                if ways[0] == ways[1] {
                    return true;
                }
            }
        }
    }

    /// Returns the next face around a corner: across the edge that starts there (`turn` = 0) or
    /// ends there (`turn` = 2).
    fn around(&self, vertex: u32, face: u32, turn: usize) -> u32 {
        let Face { corners, neighbours, .. } = &self.faces[face as usize];
        let corner = corners.iter().position(|&corner| corner == vertex).unwrap_or_default();
        neighbours[(corner + turn) % 3]
    }

    /// Returns the edges around the removed faces, each as the face beyond it and the edge's index
    /// there.
    fn horizon(&self, removed: &[u32]) -> Vec<(u32, usize)> {
        let mut horizon = Vec::new();
        for &face in removed {
            for beyond in self.faces[face as usize].neighbours {
                let Face { neighbours, removed, .. } = &self.faces[beyond as usize];
                let back = neighbours.iter().position(|&n| n == face);
                horizon.extend(back.filter(|_| !removed).map(|edge| (beyond, edge)));
            }
        }
        horizon
    }

    fn mesh(&self, points: &[[f64; 3]]) -> TriangleMesh {
        let mut number = vec![NONE; points.len()];
        let faces = self.faces.iter().filter(|face| !face.removed);
        for &vertex in faces.clone().flat_map(|face| &face.corners) {
            number[vertex as usize] = 0;
        }
        let mut vertices = Vec::new();
        for (number, point) in number.iter_mut().zip(points).filter(|(number, _)| **number == 0) {
            *number = vertices.len() as u32;
            vertices.push(*point);
        }
        let triangles = faces.map(|face| face.corners.map(|v| number[v as usize])).collect();
        TriangleMesh { vertices, triangles, is_hull: true }
    }
}
