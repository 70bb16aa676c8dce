//! Where a surface lies in one layer, and so cannot meet itself.
//!
//! Take a box about some triangles of a surface, and look at it along an axis. If
//!
//! 1. every triangle that reaches into the box has its normal on the same side, up;
//! 2. none of them reaches the lid or the bottom of the box;
//! 3. none of them has an edge where the surface ends or turns over;
//!
//! then the layers over any two points of the box's ground are as many: going from one to the other a layer can end only at a wall of
//! the box (the degree of a map is constant). If there is one over one point, there is one over all, and whatever two triangles had in
//! common in the box, beyond their corners and edges, would be two layers there. So the triangles that the box was made for meet
//! nothing. The box is open and a little larger than they are, so this holds on its walls, too.
//!
//! The signs of the normals are certain, and so is the number of layers; a box for which one of these fails is divided, and in the end
//! its triangles are compared one by one. Nearly all of a finely divided surface needs no more than this.

use super::edges::Edges;
use super::inside::seen_at;
use super::patches::is_balanced;
use super::predicate::{across, certain_turn};
use super::threads::Threads;
use super::tree::{Bounds, LEAF, Tree};
use super::weld::Welded;

/// Which way the triangles of a tree face.
pub(crate) struct Layers<'a> {
    welded: &'a Welded,
    tree: &'a Tree,
    /// Of each triangle in the tree's order, and of each of its nodes what all triangles have in common.
    facing: Vec<Sides>,
    nodes: Vec<Sides>,
}

/// Bit k if a normal certainly points along axis k, bit 3 + k if against it.
type Sides = u8;

impl<'a> Layers<'a> {
    pub(crate) fn of(
        welded: &'a Welded,
        tree: &'a Tree,
        edges: &Edges,
        collinear: &[u32],
        threads: Threads,
    ) -> Self {
        let torn = Torn::of(welded, edges, collinear);
        let order = tree.order();
        let sides = |&t: &u32| if torn.at(welded, t) { 0 } else { sides(welded.triangle(t as usize)) };
        let facing =
            threads.map_pieces(order.len(), PIECE, |piece| order[piece].iter().map(sides).collect::<Vec<_>>());
        let facing = facing.concat();
        let leaves = tree.nodes().len() / 2;
        let mut nodes = vec![!0; 2 * leaves];
        for (node, all) in nodes[leaves..].iter_mut().zip(facing.chunks(LEAF)) {
            *node = all.iter().fold(!0, |common, sides| common & sides);
        }
        for n in (1..leaves).rev() {
            nodes[n] = nodes[2 * n] & nodes[2 * n + 1];
        }
        Self { welded, tree, facing, nodes }
    }

    /// The triangles that may meet others, in the tree's order.
    pub(crate) fn doubtful(&self, threads: Threads) -> Vec<u32> {
        let leaves = self.tree.nodes().len() / 2;
        let roots = (leaves / LARGEST).max(1);
        let parts = threads.map(roots, |root| {
            let mut doubtful = Vec::new();
            self.divide(roots + root, leaves / roots, &mut doubtful);
            doubtful
        });
        parts.concat()
    }

    /// The doubtful triangles of a node that has so many leaves.
    fn divide(&self, node: usize, leaves: usize, doubtful: &mut Vec<u32>) {
        let order = self.tree.order();
        let first = (node * leaves - self.tree.nodes().len() / 2) * LEAF;
        let own = first.min(order.len())..(first + leaves * LEAF).min(order.len());
        if own.is_empty() || self.is_single(node, self.welded.corners[order[own.start] as usize][0]) {
            return;
        }
        if leaves <= SMALLEST {
            doubtful.extend_from_slice(&order[own]);
            return;
        }
        for child in [2 * node, 2 * node + 1] {
            self.divide(child, leaves / 2, doubtful);
        }
    }

    /// Is there certainly but one layer about a node that has this corner?
    fn is_single(&self, node: usize, corner: u32) -> bool {
        let Bounds { low, high } = self.tree.nodes()[node];
        let mut axes = [0, 1, 2];
        axes.sort_by(|&i, &j| (high[i] - low[i]).total_cmp(&(high[j] - low[j])));
        let faces = |axis: usize| [1 << axis, 8 << axis].into_iter().find(|side| self.nodes[node] & side != 0);
        axes.into_iter().any(|axis| {
            faces(axis).is_some_and(|side| {
                let cell = self.tree.nodes()[node].about(axis);
                self.all_face(side, axis, &cell) && self.layers(axis, &cell, corner) == 1
            })
        })
    }

    /// Do all triangles that may reach into the box face this side, and stay off its lid and its bottom?
    fn all_face(&self, side: Sides, axis: usize, cell: &Bounds) -> bool {
        let fits = |b: &Bounds| cell.low[axis] < b.low[axis] && b.high[axis] < cell.high[axis];
        // Where all in a node do, no need to look further.
        let open = |node: usize, bounds: &Bounds| self.nodes[node] & side == 0 || !fits(bounds);
        self.tree.all_within(cell, open, |k, bounds| self.facing[k] & side != 0 && fits(bounds))
    }

    /// How many triangles are above and below this corner in the box; beside it, where a point lies on an edge.
    fn layers(&self, axis: usize, cell: &Bounds, corner: u32) -> usize {
        let point = self.welded.points[corner as usize];
        let line = self.tree.line(point, axis, cell);
        let mut layers = 0;
        let all = |_: usize, _: &Bounds| true;
        self.tree.all_within(&line, all, |k, _| {
            let triangle = self.welded.triangle(self.tree.order()[k] as usize);
            layers += usize::from(seen_at(triangle, axis, across(axis, point)).is_some());
            true
        });
        layers
    }
}

/// Triangles in a piece of work.
const PIECE: usize = 1 << 14;

/// Leaves of the nodes that are looked at first.
const LARGEST: usize = 256;

/// Leaves of a node that is not divided.
const SMALLEST: usize = 2;

/// Where a surface ends or turns over.
struct Torn {
    triangles: Vec<u32>,
    /// Corners of triangles without an area: what is beside these may touch without being above each other.
    points: Vec<u32>,
}

impl Torn {
    fn of(welded: &Welded, edges: &Edges, collinear: &[u32]) -> Self {
        let unbalanced = edges.crowded.iter().filter(|edge| !is_balanced(&welded.corners, edge));
        let halves = edges.boundary.iter().chain(&edges.inconsistent).chain(unbalanced.map(|edge| &edge[0]));
        let mut triangles: Vec<u32> = halves.map(|half| half / 3).collect();
        triangles.sort_unstable();
        triangles.dedup();
        let mut points: Vec<u32> = collinear.iter().flat_map(|&t| welded.corners[t as usize]).collect();
        points.sort_unstable();
        points.dedup();
        Self { triangles, points }
    }

    fn at(&self, welded: &Welded, t: u32) -> bool {
        let of_points = |v: &u32| self.points.binary_search(v).is_ok();
        self.triangles.binary_search(&t).is_ok()
            || !self.points.is_empty() && welded.corners[t as usize].iter().any(of_points)
    }
}

fn sides(triangle: [[f64; 3]; 3]) -> Sides {
    (0..3).fold(0, |sides, axis| {
        let [a, b, c] = triangle.map(|p| across(axis, p));
        let turn = certain_turn(a, b, c);
        sides | if turn > 0.0 { 1 << axis } else { 0 } | if turn < 0.0 { 8 << axis } else { 0 }
    })
}
