//! Edges of a mesh and the triangles that meet there.

use core::ops::Range;
use std::collections::{HashMap, HashSet};
use std::sync::atomic::{AtomicU32, Ordering};

use super::threads::Threads;
use super::weld::{NONE, is_proper};

/// Edges of a mesh by their half-edges: half-edge 3 t + k of triangle t runs from its corner k to
/// the next corner.
///
/// Triangles with two equal corners have no edges. All lists are in the order of the mesh.
#[derive(Debug)]
pub(crate) struct Edges {
    /// Opposite half-edge, for an edge with two triangles.
    pub(crate) twin: Vec<AtomicU32>,
    /// Half-edges of edges with one triangle.
    pub(crate) boundary: Vec<u32>,
    /// First half-edge of each edge whose two triangles traverse it in the same direction.
    pub(crate) inconsistent: Vec<u32>,
    /// All half-edges of each edge with more than two triangles.
    pub(crate) crowded: Vec<Vec<u32>>,
    /// Pairs of triangles with the same three corners; true if they have the same orientation.
    pub(crate) duplicates: Vec<(u32, u32, bool)>,
}

impl Edges {
    pub(crate) fn of(corners: &[[u32; 3]], points: usize, threads: Threads) -> Self {
        let twin: Vec<_> = (0..3 * corners.len()).map(|_| AtomicU32::new(NONE)).collect();
        // Each thread processes the edges whose lower end is one of its vertices.
        let parts = threads.map_pieces(points, points.div_ceil(threads.count()).max(1), |vertices| {
            let mut part = Self::none();
            part.find(corners, vertices.start as u32..vertices.end as u32, &twin);
            part
        });
        let mut edges = Self { twin, ..Self::none() };
        for part in parts {
            edges.boundary.extend(part.boundary);
            edges.inconsistent.extend(part.inconsistent);
            edges.crowded.extend(part.crowded);
            edges.duplicates.extend(part.duplicates);
        }
        edges.boundary.sort_unstable();
        edges.inconsistent.sort_unstable();
        edges.crowded.sort_unstable();
        edges.duplicates.sort_unstable();
        edges
    }

    const fn none() -> Self {
        Self { twin: vec![], boundary: vec![], inconsistent: vec![], crowded: vec![], duplicates: vec![] }
    }

    /// Returns the triangles that have the same corners and orientation as an earlier one, in
    /// ascending order.
    pub(crate) fn again(&self) -> Vec<u32> {
        // For each triangle: the first one with its corners, and whether it is reversed. The list
        // of pairs links each triangle to the next.
        let mut first: HashMap<u32, (u32, bool)> = HashMap::new();
        let mut turned = HashSet::new();
        let mut again = Vec::new();
        for &(t, u, same_way) in &self.duplicates {
            let (root, is_turned) = *first.entry(t).or_insert((t, false));
            let is_turned = is_turned == same_way;
            first.insert(u, (root, is_turned));
            if !is_turned || !turned.insert(root) {
                again.push(u);
            }
        }
        again.sort_unstable();
        again
    }

    /// Returns the opposite half-edge of an edge with two triangles, or [`NONE`].
    pub(crate) fn twin(&self, half: u32) -> u32 {
        self.twin[half as usize].load(Ordering::Relaxed)
    }

    fn find(&mut self, corners: &[[u32; 3]], lower: Range<u32>, twin: &[AtomicU32]) {
        // Buckets by the lower vertex, counted before they are filled.
        let mut start = vec![0_u32; lower.len() + 1];
        for_each_edge(corners, &lower, |v, _, _| start[v + 1] += 1);
        for v in 0..lower.len() {
            start[v + 1] += start[v];
        }
        let mut entries = vec![0_u64; start[lower.len()] as usize];
        let mut next = start.clone();
        for_each_edge(corners, &lower, |v, high, half| {
            entries[next[v] as usize] = (u64::from(high) << 32) | u64::from(half);
            next[v] += 1;
        });
        for v in 0..lower.len() {
            let bucket = &mut entries[start[v] as usize..start[v + 1] as usize];
            bucket.sort_unstable();
            for edge in bucket.chunk_by(|e, f| e >> 32 == f >> 32) {
                self.sort_out(corners, edge, twin);
            }
        }
    }

    /// Classifies the half-edges of one edge; the low words of `edge` are their indices.
    fn sort_out(&mut self, corners: &[[u32; 3]], edge: &[u64], twin: &[AtomicU32]) {
        let start = |half: u32| start_of(corners, half);
        // Triangles with the same corners also meet along their lowest edge, whose third corner is
        // the highest.
        let high = (edge[0] >> 32) as u32;
        match *edge {
            [h] => self.boundary.push(h as u32),
            [g, h] => {
                let (g, h) = (g as u32, h as u32);
                twin[g as usize].store(h, Ordering::Relaxed);
                twin[h as usize].store(g, Ordering::Relaxed);
                if start(g) == start(h) {
                    self.inconsistent.push(g);
                }
                let third = opposite(corners, g);
                if third > high && third == opposite(corners, h) {
                    self.duplicates.push((g / 3, h / 3, start(g) == start(h)));
                }
            }
            _ => {
                self.crowded.push(edge.iter().map(|&h| h as u32).collect());
                let third = |&h: &u64| (opposite(corners, h as u32), h as u32);
                let mut thirds: Vec<_> = edge.iter().map(third).filter(|&(third, _)| third > high).collect();
                thirds.sort_unstable();
                for pair in thirds.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
                    let (g, h) = (pair[0].1, pair[1].1);
                    self.duplicates.push((g / 3, h / 3, start(g) == start(h)));
                }
            }
        }
    }
}

/// Calls `f` for each half-edge whose lower end is in a range: with the position of the lower end in
/// the range, the higher end, and the half-edge.
#[inline(always)]
fn for_each_edge(corners: &[[u32; 3]], lower: &Range<u32>, mut f: impl FnMut(usize, u32, u32)) {
    for (t, corner) in corners.iter().enumerate().filter(|(_, corner)| is_proper(corner)) {
        let [p, q, r] = *corner;
        for (k, (a, b)) in [(p, q), (q, r), (r, p)].into_iter().enumerate() {
            if lower.contains(&a.min(b)) {
                f((a.min(b) - lower.start) as usize, a.max(b), (3 * t + k) as u32);
            }
        }
    }
}

/// Returns the vertex where a half-edge starts.
pub(crate) fn start_of(corners: &[[u32; 3]], half: u32) -> u32 {
    corners[half as usize / 3][half as usize % 3]
}

/// Returns the vertex where a half-edge ends.
pub(crate) fn end_of(corners: &[[u32; 3]], half: u32) -> u32 {
    corners[half as usize / 3][(half as usize % 3 + 1) % 3]
}

/// Returns the corner of its triangle that is not on a half-edge.
pub(crate) fn opposite(corners: &[[u32; 3]], half: u32) -> u32 {
    corners[half as usize / 3][(half as usize % 3 + 2) % 3]
}
