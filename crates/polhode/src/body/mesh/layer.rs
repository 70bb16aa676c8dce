//! Regions where a surface has a single layer and therefore cannot intersect itself.
//!
//! Consider a box around some triangles of a surface, and a viewing axis. If
//!
//! 1. every triangle that reaches into the box has its normal on the same side, up;
//! 2. none of them reaches the top or the bottom of the box;
//! 3. none of them has an edge where the surface ends or reverses its orientation;
//!
//! then the number of layers is the same over any two points of the box's base: between them a
//! layer can end only at a wall of the box (the degree of a map is constant). If there is one layer
//! over one point, there is one over all points. Any intersection of two triangles in the box,
//! beyond their common corners and edges, would be two layers there. So the triangles inside the
//! box intersect nothing. The box is open and slightly larger than the triangles, so that this
//! holds on its walls, too.
//!
//! The signs of the normals and the number of layers are exact. A box that fails a condition is
//! divided; finally its triangles are compared one by one. For nearly all of a finely divided
//! surface this test is sufficient.

use super::edges::Edges;
use super::inside::is_seen_at;
use super::patches::is_balanced;
use super::predicate::across;
use super::threads::Threads;
use super::tree::{Bounds, LEAF, Sides, Tree, sides_of};
use super::weld::Welded;
use super::work::Work;

/// Triangles of a tree, with the data of the single-layer test.
pub(crate) struct Layers<'a> {
    welded: &'a Welded,
    tree: &'a Tree,
    torn: Torn,
    /// Directions that all triangles of each node certainly face; empty if one of them is torn.
    sides: Vec<Sides>,
}

impl<'a> Layers<'a> {
    /// Prepares the test for a tree that omits the triangles `left_out` and those with collinear
    /// corners.
    pub(crate) fn of(
        welded: &'a Welded,
        tree: &'a Tree,
        edges: &Edges,
        left_out: impl Fn(u32) -> bool,
        collinear: &[u32],
    ) -> Self {
        let torn = Torn::of(welded, edges, left_out, collinear);
        let mut sides = tree.sides().to_vec();
        let leaves = sides.len() / 2;
        if !torn.is_empty() {
            for (side, triangles) in sides[leaves..].iter_mut().zip(tree.order().chunks(LEAF)) {
                if triangles.iter().any(|&t| torn.at(welded, t)) {
                    *side = 0;
                }
            }
            for n in (1..leaves).rev() {
                sides[n] = sides[2 * n] & sides[2 * n + 1];
            }
        }
        Self { welded, tree, torn, sides }
    }

    /// Returns the triangles that may intersect others, in the tree's order.
    pub(crate) fn doubtful(&self, work: &Work<'_>, threads: Threads) -> Vec<u32> {
        let leaves = self.tree.nodes().len() / 2;
        let roots = (leaves / LARGEST).max(1);
        let parts = threads.map(roots, |root| {
            let mut doubtful = Vec::new();
            self.divide(roots + root, leaves / roots, work, &mut doubtful);
            doubtful
        });
        parts.concat()
    }

    /// Adds the doubtful triangles of a node with `leaves` leaves; the list is incomplete if the
    /// work was stopped.
    fn divide(&self, node: usize, leaves: usize, work: &Work<'_>, doubtful: &mut Vec<u32>) {
        let order = self.tree.order();
        let first = (node * leaves - self.tree.nodes().len() / 2) * LEAF;
        let own = first.min(order.len())..(first + leaves * LEAF).min(order.len());
        if own.is_empty()
            || !work.goes_on()
            || self.is_single(node, self.welded.corners[order[own.start] as usize][0])
        {
            return;
        }
        if leaves <= SMALLEST {
            doubtful.extend_from_slice(&order[own]);
            return;
        }
        for child in [2 * node, 2 * node + 1] {
            self.divide(child, leaves / 2, work, doubtful);
        }
    }

    /// Returns true if there is certainly only one layer around a node that contains this corner.
    fn is_single(&self, node: usize, corner: u32) -> bool {
        let Bounds { low, high } = self.tree.nodes()[node];
        let mut axes = [0, 1, 2];
        axes.sort_by(|&i, &j| (high[i] - low[i]).total_cmp(&(high[j] - low[j])));
        let faces =
            |axis: usize| [1 << axis, 8 << axis].into_iter().find(|side| self.sides[node] & side != 0);
        axes.into_iter().any(|axis| {
            faces(axis).is_some_and(|side| {
                let cell = self.tree.nodes()[node].about(axis);
                self.all_face(side, axis, &cell) && self.layers(axis, &cell, corner) == 1
            })
        })
    }

    /// Returns true if all triangles that may reach into the box face this side and do not reach
    /// its top or bottom.
    fn all_face(&self, side: Sides, axis: usize, cell: &Bounds) -> bool {
        let fits = |b: &Bounds| cell.low[axis] < b.low[axis] && b.high[axis] < cell.high[axis];
        // If all triangles of a node satisfy this, its children need not be visited.
        let open = |node: usize, bounds: &Bounds| self.sides[node] & side == 0 || !fits(bounds);
        self.tree.all_within(self.welded, cell, open, |t, bounds| {
            let faces = sides_of(self.welded.triangle(t as usize)) & side != 0;
            faces && fits(bounds) && !self.torn.at(self.welded, t)
        })
    }

    /// Returns the number of triangles above and below this corner in the box; next to the corner
    /// if it lies on an edge.
    fn layers(&self, axis: usize, cell: &Bounds, corner: u32) -> usize {
        let point = self.welded.points[corner as usize];
        let line = self.tree.line(point, axis, cell);
        let mut layers = 0;
        let open = |_: usize, _: &Bounds| true;
        self.tree.all_within(self.welded, &line, open, |t, _| {
            let triangle = self.welded.triangle(t as usize);
            layers += usize::from(is_seen_at(triangle, axis, across(axis, point)));
            true
        });
        layers
    }
}

/// Number of leaves of the nodes that are tested first.
const LARGEST: usize = 256;

/// Number of leaves of a node that is not divided further.
const SMALLEST: usize = 2;

/// Places where a surface ends or reverses its orientation.
struct Torn {
    triangles: Vec<u32>,
    /// Corners of triangles without area: their neighbours may touch without being above each
    /// other.
    points: Vec<u32>,
}

impl Torn {
    fn of(welded: &Welded, edges: &Edges, left_out: impl Fn(u32) -> bool, collinear: &[u32]) -> Self {
        let mut halves = [edges.boundary.as_slice(), &edges.inconsistent].concat();
        // Triangles left out are duplicates: at least one triangle of each edge remains.
        let mut left = Vec::new();
        for edge in &edges.crowded {
            left.clear();
            left.extend(edge.iter().filter(|&&half| !left_out(half / 3)));
            if left.first().is_some_and(|_| !is_balanced(&welded.corners, &left)) {
                halves.push(left[0]);
            }
        }
        let mut triangles: Vec<u32> = halves.into_iter().map(|half| half / 3).collect();
        triangles.sort_unstable();
        triangles.dedup();
        let mut points: Vec<u32> = collinear.iter().flat_map(|&t| welded.corners[t as usize]).collect();
        points.sort_unstable();
        points.dedup();
        Self { triangles, points }
    }

    fn is_empty(&self) -> bool {
        self.triangles.is_empty() && self.points.is_empty()
    }

    fn at(&self, welded: &Welded, t: u32) -> bool {
        let of_points = |v: &u32| self.points.binary_search(v).is_ok();
        self.triangles.binary_search(&t).is_ok()
            || !self.points.is_empty() && welded.corners[t as usize].iter().any(of_points)
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::TAU;

    use super::super::TriangleMesh;
    use super::super::component::Measured;
    use super::super::meeting::Meeting;
    use super::super::patches::Patches;
    use super::super::weld::NONE;
    use super::*;

    /// Returns a closed surface parametrised by two angles.
    fn torus(n: u32, m: u32, at: impl Fn(f64, f64) -> [f64; 3]) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
        let angle = |k: u32, n: u32| TAU * f64::from(k) / f64::from(n);
        let points = (0..n * m).map(|k| at(angle(k / m, n), angle(k % m, m))).collect();
        let number = |i: u32, j: u32| i % n * m + j % m;
        let squares = (0..n * m).map(|k| (k / m, k % m));
        let halves = squares.flat_map(|(i, j)| {
            let [a, b, c, d] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
            [[a, b, c], [a, c, d]]
        });
        (points, halves.collect())
    }

    /// Returns a tube around a curve with `turns` turns of varying radius about an oblique axis.
    fn tube(turns: f64, radius: f64, wave: f64) -> impl Fn(f64, f64) -> [f64; 3] {
        move |u, v| {
            let (r, w) = (1.0 + wave * (0.5 * u * (turns - 1.0)).cos(), wave * (u + 0.3).sin());
            let distance = r + radius * v.cos();
            let (x, y) = (distance * (turns * u).cos(), distance * (turns * u).sin());
            let z = radius * v.sin() + w;
            [0.36 * x + 0.48 * y - 0.8 * z, -0.8 * x + 0.6 * y, 0.48 * x + 0.64 * y + 0.6 * z]
        }
    }

    /// Returns a generator of pseudo-random numbers from 0 to 1.
    fn chance() -> impl FnMut() -> f64 {
        let mut state = 20_u64;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / 9_007_199_254_740_992.0
        }
    }

    /// Returns a mesh, its triangles that have an area and are not duplicates, and which of them
    /// are doubtful.
    fn doubtful((points, triangles): (Vec<[f64; 3]>, Vec<[u32; 3]>)) -> (Welded, Vec<u32>, Vec<bool>) {
        let mesh = TriangleMesh::new(points, triangles).unwrap();
        let (welded, threads) = (Welded::of(&mesh, Threads::of(1)), Threads::of(2));
        let edges = Edges::of(&welded.corners, welded.points.len(), threads);
        let patches = Patches::of(&welded.corners, &edges, threads);
        let collinear = Measured::of(&welded, &patches, threads).collinear;
        let again = edges.again();
        let is_again = |t: u32| again.binary_search(&t).is_ok();
        let wanted = |t: usize| {
            patches.component[t] != NONE
                && collinear.binary_search(&(t as u32)).is_err()
                && !is_again(t as u32)
        };
        let tree = Tree::of(&welded, wanted, threads);
        let doubtful = Layers::of(&welded, &tree, &edges, is_again, &collinear)
            .doubtful(&Work::of(u64::MAX, &|| true), threads);
        let mut is_doubtful = vec![false; welded.corners.len()];
        doubtful.iter().for_each(|&t| is_doubtful[t as usize] = true);
        let order = tree.order().to_vec();
        (welded, order, is_doubtful)
    }

    /// Checks that both triangles of every intersecting pair are doubtful. Returns the number of
    /// pairs.
    fn check(mesh: (Vec<[f64; 3]>, Vec<[u32; 3]>)) -> usize {
        let (welded, order, is_doubtful) = doubtful(mesh);
        let mut pairs = 0;
        for (k, &t) in order.iter().enumerate() {
            for &u in &order[..k] {
                let [i, j] = [t as usize, u as usize];
                let [a, b] = [i, j].map(|t| welded.triangle(t));
                let beyond = |a: [[f64; 3]; 3], b: [[f64; 3]; 3]| {
                    (0..3).any(|k| a.iter().all(|p| b.iter().all(|q| p[k] < q[k])))
                };
                if beyond(a, b) || beyond(b, a) {
                    continue;
                }
                let place = |v: u32| welded.points[v as usize];
                let meeting = Meeting::of(welded.corners[i], welded.corners[j], place);
                if meeting != Meeting::Apart {
                    pairs += 1;
                    assert!(is_doubtful[i] && is_doubtful[j], "{t} {u} {meeting:?}");
                }
            }
        }
        pairs
    }

    #[test]
    fn little_of_a_smooth_surface_is_doubtful() {
        for (size, shift) in [(1.0, 0.0), (1e-9, 3e-4), (1e100, 0.0), (7.0, 1e6)] {
            let (points, triangles) = torus(160, 80, tube(1.0, 0.4, 0.1));
            let points = points.iter().map(|p| p.map(|c| c * size + shift)).collect();
            let (_, order, is_doubtful) = doubtful((points, triangles));
            let part = is_doubtful.iter().filter(|&&doubtful| doubtful).count() as f64 / order.len() as f64;
            assert!(part < 0.1, "{size}: {part}");
        }
        assert_eq!(check(torus(40, 20, tube(1.0, 0.4, 0.1))), 0);
    }

    #[test]
    fn what_is_there_again_is_no_second_layer() {
        let (points, mut triangles) = torus(160, 80, tube(1.0, 0.4, 0.1));
        triangles.extend(triangles.clone());
        let (_, order, is_doubtful) = doubtful((points, triangles));
        let part = is_doubtful.iter().filter(|&&doubtful| doubtful).count();
        assert!(order.len() == 160 * 80 * 2 && part < order.len() / 10, "{part} of {}", order.len());
        // The test also must not close the surface where it ends, nor hide an intersection.
        let mut chance = chance();
        let mut found = 0;
        for (round, (turns, wave)) in
            [(1.0, 0.1), (2.0, 0.01), (3.0, 0.03), (2.0, 0.0)].into_iter().cycle().take(12).enumerate()
        {
            let (mut points, mut triangles) = torus(48, 14, tube(turns, 0.3, wave));
            if round % 3 == 1 {
                points.iter_mut().flatten().for_each(|c| *c = (*c * 12.0).round());
            }
            if round % 3 == 2 {
                triangles.retain(|_| chance() > 0.03);
            }
            let again: Vec<_> = triangles.iter().copied().filter(|_| chance() < 0.3).collect();
            triangles
                .extend(again.iter().map(|&[a, b, c]| if chance() < 0.2 { [a, c, b] } else { [b, c, a] }));
            triangles.extend(again.into_iter().filter(|_| chance() < 0.3));
            found += check((points, triangles));
        }
        assert!(found > 100, "{found}");
    }

    #[test]
    fn what_meets_is_doubtful_however_the_layers_lie() {
        // Self-intersecting at the axis; or several turns about it, in layers that coincide or
        // cross in a few places.
        for (turns, radius, wave) in [(1.0, 1.1, 0.0), (2.0, 0.3, 0.0), (2.0, 0.3, 0.01), (3.0, 0.2, 0.03)] {
            let pairs = check(torus(48, 14, tube(turns, radius, wave)));
            assert!(pairs > 0, "{turns} {radius} {wave}");
        }
        // Two surfaces, the outer of which dips through the inner one.
        for dip in [0.0, 0.06, 0.2] {
            let (mut points, mut triangles) = torus(36, 16, tube(1.0, 0.4, 0.1));
            let (outer, more) = torus(40, 14, |u, v| {
                let bump = (-20.0 * ((u - 2.0).powi(2) + (v - 3.0).powi(2))).exp();
                tube(1.0, 0.43 - dip * bump, 0.1)(u, v)
            });
            triangles.extend(more.iter().map(|t| t.map(|v| v + points.len() as u32)));
            points.extend(outer);
            let pairs = check((points, triangles));
            assert_eq!(pairs > 0, dip > 0.0, "{dip}: {pairs}");
        }
    }

    #[test]
    fn folds_and_tears_are_doubtful() {
        let mut chance = chance();
        let mut found = 0;
        for round in 0..12 {
            let (mut points, mut triangles) = torus(40, 14, tube(1.0, 0.4, 0.1));
            // Corners displaced across their neighbours.
            for _ in 0..30 {
                let k = (chance() * points.len() as f64) as usize;
                let by = chance();
                points[k] = points[k].map(|c| c + by * (chance() - 0.5));
            }
            match round % 4 {
                // Coordinates rounded to a grid, so that many points are coplanar or collinear.
                1 => points.iter_mut().flatten().for_each(|c| *c = (*c * 12.0).round()),
                2 => triangles.iter_mut().step_by(41).for_each(|t| t.swap(0, 1)),
                3 => triangles.retain(|_| chance() > 0.02),
                _ => {}
            }
            found += check((points, triangles));
        }
        assert!(found > 100, "{found}");
    }

    #[test]
    fn triangles_at_random_meet_as_they_do() {
        let mut chance = chance();
        for scale in [4.0, 1000.0] {
            let points = (0..900).map(|_| core::array::from_fn(|_| (chance() * scale).round())).collect();
            let corner = |k: u32| [3 * k, 3 * k + 1, 3 * k + 2];
            let mesh = TriangleMesh::new(points, (0..300).map(corner).collect()).unwrap();
            assert!(check((mesh.coordinates().to_vec(), mesh.triangles().to_vec())) > 100);
        }
    }

    #[test]
    fn steps_of_many_corners_on_one_edge_are_doubtful() {
        // A prism whose top is a pair of triangles and whose sides are divided; triangles without
        // area close it.
        let n = 9_u32;
        let mut points: Vec<[f64; 3]> = (0..=n).map(|k| [f64::from(k), 0.0, 0.25 * f64::from(k)]).collect();
        points.extend((0..=n).map(|k| [f64::from(k), 2.0, 1.0 + 0.25 * f64::from(k)]));
        let mut triangles: Vec<[u32; 3]> = vec![[0, n, 2 * n + 1], [0, 2 * n + 1, n + 1]];
        // The seam from 0 to n has corners in between that only collinear triangles and the strip
        // below contain.
        triangles.extend((1..n).map(|k| [0, k, k + 1]));
        let first = points.len() as u32;
        points.extend((0..=n).map(|k| [f64::from(k), -1.0, 0.3 * f64::from(k) - 0.4]));
        triangles.extend((0..n).flat_map(|k| [[k, first + k, k + 1], [first + k, first + k + 1, k + 1]]));
        let pairs = check((points, triangles));
        assert!(pairs > 0);
    }
}
