//! A closed mesh in which every triangle occurs once, with its multiplicity.

use super::super::TriangleMesh;
use super::super::edges::{Edges, start_of};
use super::super::patches::Patches;
use super::super::threads::Threads;
use super::super::weld::{Welded, is_proper};

/// Triangles that occur once each, with their multiplicity, oriented such that it is positive;
/// triangles that cancel are omitted.
#[derive(Debug)]
pub(super) struct Weighted {
    pub(super) welded: Welded,
    pub(super) times: Vec<i32>,
    pub(super) edges: Edges,
    pub(super) patches: Patches,
}

impl Weighted {
    /// Builds the mesh; `None` if it is not closed, that is, if an edge is not traversed equally
    /// often in both directions. Triangles oriented against a clear majority of their component are
    /// reversed; with `inward`, all are reversed.
    pub(super) fn of(mesh: &TriangleMesh, inward: bool, threads: Threads) -> Option<Self> {
        let mut welded = Welded::of(mesh, threads);
        let edges = Edges::of(&welded.corners, welded.points.len(), threads);
        let patches = Patches::of(&welded.corners, &edges, threads);
        for (corners, against) in welded.corners.iter_mut().zip(&patches.against) {
            if *against != inward {
                corners.swap(1, 2);
            }
        }
        let merged = merged(&welded.corners);
        welded.corners = merged.iter().map(|(_, corners, _)| *corners).collect();
        let times = merged.iter().map(|(_, _, times)| *times).collect();
        let edges = Edges::of(&welded.corners, welded.points.len(), threads);
        let patches = Patches::of(&welded.corners, &edges, threads);
        let all = Self { welded, times, edges, patches };
        all.is_closed().then_some(all)
    }

    fn is_closed(&self) -> bool {
        let Self { welded: Welded { corners, .. }, times, edges, .. } = self;
        let of = |half: u32| times[half as usize / 3];
        let is_balanced = |edge: &Vec<u32>| {
            let start = start_of(corners, edge[0]);
            let step = |&half: &u32| if start_of(corners, half) == start { of(half) } else { -of(half) };
            edge.iter().map(step).sum::<i32>() == 0
        };
        let has_twin = |half: u32| (half, edges.twin(half));
        let mut pairs = (0..3 * corners.len() as u32).map(has_twin).filter(|(half, twin)| half < twin);
        edges.boundary.is_empty()
            && edges.inconsistent.is_empty()
            && edges.crowded.iter().all(is_balanced)
            && pairs.all(|(half, twin)| twin as usize >= 3 * corners.len() || of(half) == of(twin))
    }
}

/// Returns for each set of three corners its first triangle in the majority orientation, and the
/// excess over the opposite orientation; in the order of the mesh.
fn merged(corners: &[[u32; 3]]) -> Vec<(u32, [u32; 3], i32)> {
    let mut keys: Vec<([u32; 3], u32)> =
        (0..).zip(corners).filter(|(_, c)| is_proper(c)).map(|(t, c)| (sorted(*c), t)).collect();
    keys.sort_unstable();
    let same = keys.chunk_by(|a, b| a.0 == b.0);
    let merge = |same: &[([u32; 3], u32)]| {
        let first = corners[same[0].1 as usize];
        let step = |t: u32| if is_same_way(first, corners[t as usize]) { 1 } else { -1 };
        let times: i32 = same.iter().map(|&(_, t)| step(t)).sum();
        let [a, b, c] = first;
        (same[0].1, if times < 0 { [a, c, b] } else { first }, times.abs())
    };
    let mut merged: Vec<_> = same.map(merge).filter(|(_, _, times)| *times > 0).collect();
    merged.sort_unstable();
    merged
}

fn sorted(mut corners: [u32; 3]) -> [u32; 3] {
    corners.sort_unstable();
    corners
}

/// Returns true if two triangles with the same corners have the same orientation.
fn is_same_way([a, b, c]: [u32; 3], other: [u32; 3]) -> bool {
    [[a, b, c], [b, c, a], [c, a, b]].contains(&other)
}
