//! Bounding volume hierarchy over triangles, to skip pairs that are far apart.

use core::f64::consts::SQRT_2;
use core::ops::{ControlFlow, Range};

use super::predicate::{across, certain_turn};
use super::threads::Threads;
use super::weld::{NONE, Welded};

/// Axis-parallel box. Coordinates are rounded monotonically, so that the boxes of intersecting
/// triangles intersect.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
pub(crate) struct Bounds {
    pub(crate) low: [f32; 4],
    pub(crate) high: [f32; 4],
}

impl Bounds {
    const NOTHING: Self = Self { low: [f32::INFINITY; 4], high: [f32::NEG_INFINITY; 4] };

    #[inline(always)]
    fn meets(&self, other: &Self) -> bool {
        (0..4).fold(true, |all, k| all & (self.low[k] <= other.high[k]) & (other.low[k] <= self.high[k]))
    }

    /// Returns the box enlarged by a margin, and along `axis` by half of the box's largest other
    /// width.
    pub(crate) fn about(mut self, axis: usize) -> Self {
        let width = (0..3).filter(|&k| k != axis).map(|k| self.high[k] - self.low[k]).fold(0.0, f32::max);
        for k in 0..3 {
            let margin = if k == axis { 0.5 * width + MARGIN } else { MARGIN };
            self.low[k] -= margin;
            self.high[k] += margin;
        }
        self
    }

    #[inline(always)]
    fn with(&self, other: &Self) -> Self {
        Self {
            low: core::array::from_fn(
                |k| if other.low[k] < self.low[k] { other.low[k] } else { self.low[k] },
            ),
            high: core::array::from_fn(|k| {
                if other.high[k] > self.high[k] { other.high[k] } else { self.high[k] }
            }),
        }
    }
}

/// Margin larger than the last digit of a coordinate between −1 and 1.
const MARGIN: f32 = 1.0 / 4_194_304.0;

/// Number of triangles per leaf.
pub(crate) const LEAF: usize = 4;

/// Complete binary tree over triangles along a space-filling curve (Morton order); the children of
/// node n are 2n and 2n + 1, and the root is node 1.
#[derive(Debug)]
pub(crate) struct Tree {
    /// Triangles by their index in the mesh, in leaves of [`LEAF`].
    order: Vec<u32>,
    nodes: Vec<Bounds>,
    /// Common directions of all triangles of each node.
    sides: Vec<Sides>,
    leaves: usize,
    middle: [f64; 3],
    scale: f64,
}

impl Tree {
    /// Builds the tree of the triangles for which `wanted` returns true.
    pub(crate) fn of(welded: &Welded, wanted: impl Fn(usize) -> bool + Sync, threads: Threads) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for p in &welded.points {
            low = core::array::from_fn(|k| low[k].min(p[k]));
            high = core::array::from_fn(|k| high[k].max(p[k]));
        }
        let middle = core::array::from_fn(|k| 0.5 * low[k] + 0.5 * high[k]);
        let size = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
        let scale = if size > 0.0 { (2.0 / size).min(f64::MAX) } else { 1.0 };
        let mut tree = Self { order: vec![], nodes: vec![], sides: vec![], leaves: 0, middle, scale };
        let pieces = threads.map_pieces(welded.corners.len(), PIECE, |piece| {
            let wanted = piece.filter(|&t| wanted(t));
            wanted.map(|t| Key::new(tree.code(welded.triangle(t)), t as u32)).collect::<Vec<_>>()
        });
        tree.order = sorted(&pieces, threads);
        tree.bound(welded, threads);
        tree
    }

    /// Builds the tree of some of its triangles, given in its order.
    pub(crate) fn part(&self, welded: &Welded, order: Vec<u32>, threads: Threads) -> Self {
        let (middle, scale) = (self.middle, self.scale);
        let mut part = Self { order, nodes: vec![], sides: vec![], leaves: 0, middle, scale };
        part.bound(welded, threads);
        part
    }

    /// Computes the boxes and directions of the nodes.
    fn bound(&mut self, welded: &Welded, threads: Threads) {
        self.leaves = self.leaves().next_power_of_two();
        let (mut nodes, mut sides) = (vec![Bounds::NOTHING; 2 * self.leaves], vec![ALL; 2 * self.leaves]);
        let pieces = threads.map_pieces(self.leaves(), LEAVES, |piece| {
            let leaves =
                self.order[piece.start * LEAF..(piece.end * LEAF).min(self.order.len())].chunks(LEAF);
            let leaf = |triangles: &[u32]| {
                let triangles = triangles.iter().map(|&t| welded.triangle(t as usize));
                triangles.fold((Bounds::NOTHING, ALL), |(bounds, common), triangle| {
                    (bounds.with(&self.bounds(&triangle)), common & sides_of(triangle))
                })
            };
            leaves.map(leaf).collect::<Vec<_>>()
        });
        let leaves = nodes[self.leaves..].iter_mut().zip(&mut sides[self.leaves..]);
        for ((node, side), leaf) in leaves.zip(pieces.into_iter().flatten()) {
            (*node, *side) = leaf;
        }
        for n in (1..self.leaves).rev() {
            nodes[n] = nodes[2 * n].with(&nodes[2 * n + 1]);
            sides[n] = sides[2 * n] & sides[2 * n + 1];
        }
        (self.nodes, self.sides) = (nodes, sides);
    }

    /// Returns the boxes of the triangles, in the order of the tree.
    pub(crate) fn boxes(&self, welded: &Welded, threads: Threads) -> Vec<Bounds> {
        let boxes = threads.map_pieces(self.order.len(), PIECE, |piece| {
            let bounds = |&t: &u32| self.bounds(&welded.triangle(t as usize));
            self.order[piece].iter().map(bounds).collect::<Vec<_>>()
        });
        boxes.concat()
    }

    /// Returns the triangles in the order of the leaves.
    pub(crate) fn order(&self) -> &[u32] {
        &self.order
    }

    /// Returns the boxes of the nodes; the leaves are in the second half.
    pub(crate) fn nodes(&self) -> &[Bounds] {
        &self.nodes
    }

    /// Returns the directions that all triangles of each node certainly face.
    pub(crate) fn sides(&self) -> &[Sides] {
        &self.sides
    }

    /// Returns the number of leaves that contain triangles.
    pub(crate) fn leaves(&self) -> usize {
        self.order.len().div_ceil(LEAF)
    }

    /// Scales coordinates so that the mesh spans −1 … 1.
    fn reduced(&self, p: [f64; 3]) -> [f32; 3] {
        core::array::from_fn(|k| ((p[k] - self.middle[k]) * self.scale) as f32)
    }

    #[inline(always)]
    fn bounds(&self, triangle: &[[f64; 3]; 3]) -> Bounds {
        let [a, b, c] = triangle.map(|p| {
            let [x, y, z] = self.reduced(p);
            let corner = [x, y, z, 0.0];
            Bounds { low: corner, high: corner }
        });
        a.with(&b).with(&c)
    }

    /// Returns the Morton code of a triangle: the interleaved bits of the coordinates of its
    /// centroid.
    fn code(&self, [a, b, c]: [[f64; 3]; 3]) -> u32 {
        let middle = self.reduced(core::array::from_fn(|k| (a[k] + b[k] + c[k]) * (1.0 / 3.0)));
        let [x, y, z] = middle.map(|m| spread((((m + 1.0) * 512.0) as u32).min(1023))); // `as` gives 0 for negative numbers
        x | y << 1 | z << 2
    }

    /// Returns the common value of `of` over all triangles of each node, or [`NONE`] if it is not
    /// the same.
    pub(crate) fn alike(&self, of: impl Fn(u32) -> u32) -> Vec<u32> {
        let mut alike = vec![NONE; 2 * self.leaves];
        for (node, triangles) in alike[self.leaves..].iter_mut().zip(self.order.chunks(LEAF)) {
            let first = of(triangles[0]);
            *node = if triangles.iter().all(|&t| of(t) == first) { first } else { NONE };
        }
        for n in (1..self.leaves).rev() {
            let is_empty = self.nodes[2 * n + 1].low[0] > self.nodes[2 * n + 1].high[0];
            alike[n] = if is_empty || alike[2 * n] == alike[2 * n + 1] { alike[2 * n] } else { NONE };
        }
        alike
    }

    /// Calls `pair` for every two triangles whose [`Tree::boxes`] intersect and the first of which
    /// is in one of the leaves, until it breaks. Its arguments are positions in [`Tree::order`]. If
    /// `alike` (from [`Tree::alike`]) is given, pairs with the same value are skipped.
    pub(crate) fn pairs(
        &self,
        boxes: &[Bounds],
        alike: Option<&[u32]>,
        leaves: Range<usize>,
        mut pair: impl FnMut(usize, usize) -> ControlFlow<()>,
    ) {
        let mut waiting = Vec::with_capacity(64);
        for leaf in leaves {
            let own = leaf * LEAF..((leaf + 1) * LEAF).min(self.order.len());
            let same = alike.map_or(NONE, |alike| alike[self.leaves + leaf]);
            let is_alike = |node: usize| same != NONE && alike.is_some_and(|alike| alike[node] == same);
            for i in own.clone().filter(|_| same == NONE) {
                for j in i + 1..own.end {
                    if boxes[i].meets(&boxes[j]) && pair(i, j).is_break() {
                        return;
                    }
                }
            }
            let about = self.nodes[self.leaves + leaf];
            // Visits only later leaves, so that every pair occurs once: those under the right
            // neighbours of the nodes above this leaf.
            let mut above = self.leaves + leaf;
            while above > 1 {
                if above.is_multiple_of(2) {
                    waiting.push(above + 1);
                }
                above /= 2;
            }
            while let Some(node) = waiting.pop() {
                if !self.nodes[node].meets(&about) || is_alike(node) {
                    continue;
                }
                if node < self.leaves {
                    waiting.extend([2 * node, 2 * node + 1]);
                    continue;
                }
                let first = (node - self.leaves) * LEAF;
                for j in first..(first + LEAF).min(self.order.len()) {
                    if boxes[j].meets(&about) {
                        for i in own.clone() {
                            if boxes[i].meets(&boxes[j]) && pair(i, j).is_break() {
                                return;
                            }
                        }
                    }
                }
            }
        }
    }

    /// Returns the line through a point along an axis, as long as a box.
    pub(crate) fn line(&self, point: [f64; 3], axis: usize, within: &Bounds) -> Bounds {
        let [x, y, z] = self.reduced(point);
        let mut line = Bounds { low: [x, y, z, 0.0], high: [x, y, z, 0.0] };
        (line.low[axis], line.high[axis]) = (within.low[axis], within.high[axis]);
        line
    }

    /// Returns true if `so` holds for every triangle whose box intersects `within`. Only nodes for
    /// which `open` returns true are visited.
    pub(crate) fn all_within(
        &self,
        welded: &Welded,
        within: &Bounds,
        open: impl Fn(usize, &Bounds) -> bool,
        mut so: impl FnMut(u32, &Bounds) -> bool,
    ) -> bool {
        let mut waiting = Vec::with_capacity(64);
        waiting.push(1);
        while let Some(node) = waiting.pop() {
            let bounds = &self.nodes[node];
            if !bounds.meets(within) || !open(node, bounds) {
                continue;
            }
            if node < self.leaves {
                waiting.extend([2 * node, 2 * node + 1]);
                continue;
            }
            let first = (node - self.leaves) * LEAF;
            for &t in &self.order[first..(first + LEAF).min(self.order.len())] {
                let bounds = self.bounds(&welded.triangle(t as usize));
                if bounds.meets(within) && !so(t, &bounds) {
                    return false;
                }
            }
        }
        true
    }

    /// Calls `hit` for every triangle whose box, enlarged by the rounding margin, intersects that
    /// of a triangle.
    pub(crate) fn near(&self, welded: &Welded, triangle: &[[f64; 3]; 3], mut hit: impl FnMut(u32)) {
        let mut about = self.bounds(triangle);
        for k in 0..3 {
            about.low[k] -= MARGIN;
            about.high[k] += MARGIN;
        }
        let open = |_: usize, _: &Bounds| true;
        self.all_within(welded, &about, open, |t, _| {
            hit(t);
            true
        });
    }

    /// Calls `hit` for every triangle whose box may intersect the ray from a point along an axis.
    pub(crate) fn along(&self, welded: &Welded, point: [f64; 3], axis: usize, mut hit: impl FnMut(u32)) {
        let [x, y, z] = self.reduced(point);
        let mut ray = Bounds { low: [x, y, z, 0.0], high: [x, y, z, 0.0] };
        ray.high[axis] = f32::INFINITY;
        let open = |_: usize, _: &Bounds| true;
        self.all_within(welded, &ray, open, |t, _| {
            hit(t);
            true
        });
    }

    /// Returns true if `so` holds for every triangle whose box may intersect the line from a point
    /// of the mesh to a point outside.
    pub(crate) fn between(
        &self,
        welded: &Welded,
        point: [f64; 3],
        outside: [f64; 3],
        mut so: impl FnMut(u32) -> bool,
    ) -> bool {
        let [from, to] = [self.reduced(point), self.reduced(outside)];
        let way: [f32; 3] = core::array::from_fn(|k| 1.0 / (to[k] - from[k]));
        // The line meets the box if its parameter intervals between the three pairs of sides have a
        // common point.
        let meets = |bounds: &Bounds| {
            let (mut enters, mut leaves) = (0.0_f32, 1.0_f32);
            for k in 0..3 {
                let [low, high] =
                    [bounds.low[k] - NEAR, bounds.high[k] + NEAR].map(|c| (c - from[k]) * way[k]);
                enters = enters.max(low.min(high));
                leaves = leaves.min(low.max(high));
            }
            enters <= leaves
        };
        let everywhere = Bounds { low: [f32::MIN; 4], high: [f32::MAX; 4] };
        let open = |_: usize, bounds: &Bounds| meets(bounds);
        self.all_within(welded, &everywhere, open, |t, bounds| !meets(bounds) || so(t))
    }

    /// Returns points in general position around the mesh, beyond its lowest and highest
    /// coordinates along all axes.
    pub(crate) fn outside(&self, k: u32) -> [f64; 3] {
        // Fractional parts of multiples of √2, √3 and √5.
        let part = |root: f64| (root * f64::from(k + 1)).fract();
        let [x, y, z] = [part(SQRT_2), part(1.732_050_807_568_877_2), part(2.236_067_977_499_79)];
        let corner = [x, y, z].map(|part| if part < 0.5 { part - 2.0 } else { part + 1.0 });
        core::array::from_fn(|i| self.middle[i] + corner[i] / self.scale)
    }
}

/// Margin larger than the rounding of values between −3 and 3.
const NEAR: f32 = 1.0 / 262_144.0;

/// Number of triangles in a piece of work.
const PIECE: usize = 1 << 16;

/// Number of leaves in a piece of work.
const LEAVES: usize = 1 << 12;

/// Directions of a normal: bit k if it certainly points along axis k, bit 3 + k if against it.
pub(crate) type Sides = u8;

/// Common directions of an empty set of triangles.
const ALL: Sides = !0;

/// Returns the directions of a triangle's normal of which f64 is certain.
#[inline(always)]
pub(crate) fn sides_of([a, b, c]: [[f64; 3]; 3]) -> Sides {
    (0..3).fold(0, |sides, axis| {
        let turn = certain_turn(across(axis, a), across(axis, b), across(axis, c));
        sides | u8::from(turn > 0.0) << axis | u8::from(turn < 0.0) << (3 + axis)
    })
}

/// Returns the 10 bits of a number with two zeros after each.
fn spread(x: u32) -> u32 {
    let x = (x | x << 16) & 0x0300_00ff;
    let x = (x | x << 8) & 0x0300_f00f;
    let x = (x | x << 4) & 0x030c_30c3;
    (x | x << 2) & 0x0924_9249
}

/// Sort key: the Morton code of a triangle in the high word, and its index in the low word.
#[derive(Clone, Copy, Default)]
struct Key(u64);

impl Key {
    fn new(code: u32, triangle: u32) -> Self {
        Self(u64::from(code) << 32 | u64::from(triangle))
    }

    /// Returns digit k of the code: ten of its 30 bits; digit 0 is the lowest.
    fn digit(self, k: u32) -> usize {
        (self.0 >> (32 + 10 * k)) as usize & (DIGITS - 1)
    }
}

const DIGITS: usize = 1 << 10;

/// Number of keys below which comparisons sort them faster than digits.
const FEW: usize = 1 << 10;

/// Returns the triangles sorted by code; equal codes keep their order. Each thread sorts the codes
/// with certain leading digits.
fn sorted(pieces: &[Vec<Key>], threads: Threads) -> Vec<u32> {
    if let [keys] = pieces
        && keys.len() < FEW
    {
        let mut keys: Vec<u64> = keys.iter().map(|key| key.0).collect();
        keys.sort_unstable();
        return keys.into_iter().map(|key| key as u32).collect();
    }
    let all = || pieces.iter().flatten().copied();
    let mut counts = [0; DIGITS];
    all().for_each(|key| counts[key.digit(2)] += 1);
    let total: usize = counts.iter().sum();
    let parts = threads.count().min(DIGITS);
    let (mut part_of, mut sizes, mut sum) = ([0; DIGITS], vec![0; parts], 0);
    for (part, count) in part_of.iter_mut().zip(counts) {
        *part = (sum * parts / total.max(1)).min(parts - 1);
        sizes[*part] += count;
        sum += count;
    }
    let sorted = threads.map(parts, |part| {
        let mut keys = Vec::with_capacity(sizes[part]);
        keys.extend(all().filter(|key| part_of[key.digit(2)] == part));
        let mut other = vec![Key::default(); keys.len()];
        for k in 0..3 {
            sort_by_digit(&keys, &mut other, k);
            core::mem::swap(&mut keys, &mut other);
        }
        keys.into_iter().map(|key| key.0 as u32).collect::<Vec<_>>()
    });
    sorted.concat()
}

fn sort_by_digit(keys: &[Key], sorted: &mut [Key], k: u32) {
    let mut next = [0; DIGITS];
    keys.iter().for_each(|key| next[key.digit(k)] += 1);
    let mut sum = 0;
    for count in &mut next {
        sum += core::mem::replace(count, sum);
    }
    for &key in keys {
        let at = &mut next[key.digit(k)];
        sorted[*at] = key;
        *at += 1;
    }
}
