//! Merging of corners with exactly equal coordinates.

use std::sync::atomic::{AtomicU32, Ordering};

use super::TriangleMesh;
use super::threads::Threads;
use crate::math::symmetric3::power_of_two_near;

/// Marker of a missing vertex, triangle, edge or component.
pub(crate) const NONE: u32 = u32::MAX;

/// Points of a mesh, each once, and its triangles between them.
///
/// Coordinates are scaled by a power of two near the largest one: this is exact, and no product of
/// a few coordinates overflows.
#[derive(Clone, Debug)]
pub(crate) struct Welded {
    /// Points in the order in which triangles use them.
    pub(crate) points: Vec<[f64; 3]>,
    pub(crate) corners: Vec<[u32; 3]>,
    pub(crate) unit: f64,
}

impl Welded {
    pub(crate) fn of(mesh: &TriangleMesh, threads: Threads) -> Self {
        let (mut points, corners) = shared(mesh, threads);
        let largest = points.as_flattened().iter().fold(0.0_f64, |max, c| max.max(c.abs()));
        let unit = power_of_two_near(largest);
        let per_unit = 1.0 / unit;
        points.as_flattened_mut().iter_mut().for_each(|c| *c = (*c + 0.0) * per_unit); // −0 is 0
        Self { points, corners, unit }
    }

    /// Returns the corners of a triangle, in scaled units.
    #[inline(always)]
    pub(crate) fn triangle(&self, t: usize) -> [[f64; 3]; 3] {
        // `map` is not inlined on every target.
        let [a, b, c] = self.corners[t];
        [self.points[a as usize], self.points[b as usize], self.points[c as usize]]
    }

    /// Converts a point to the mesh's own unit of length.
    pub(crate) fn place(&self, point: [f64; 3]) -> [f64; 3] {
        point.map(|c| c * self.unit)
    }
}

impl TriangleMesh {
    /// Returns the same triangles with each vertex once, in the order in which triangles use them,
    /// on at most `threads` threads.
    ///
    /// This reduces the memory for triangles without shared indices, as in STL, to about a quarter,
    /// and later searches for equal corners take almost no time.
    #[must_use]
    pub fn with_shared_vertices(self, threads: usize) -> Self {
        let (vertices, triangles) = shared(&self, Threads::of(threads));
        Self { vertices, triangles, is_hull: self.is_hull }
    }
}

/// Returns the points of a mesh, each once, in the order in which triangles use them, and its
/// triangles between them.
fn shared(mesh: &TriangleMesh, threads: Threads) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let vertices = mesh.coordinates();
    let first = first_equal(vertices, threads);
    let mut points = Vec::with_capacity(vertices.len().min(mesh.triangles().len()));
    let mut number = vec![NONE; vertices.len()];
    let mut numbered = |index: u32| {
        let near = first[index as usize].load(Ordering::Relaxed);
        let first = first[near as usize].load(Ordering::Relaxed) as usize;
        if number[first] == NONE {
            number[first] = points.len() as u32; // ≤ the number of an index
            points.push(vertices[first]);
        }
        number[first]
    };
    let corners = mesh.triangles().iter().map(|&[a, b, c]| [numbered(a), numbered(b), numbered(c)]).collect();
    (points, corners)
}

/// Returns true if the three corners are different.
pub(crate) fn is_proper(&[a, b, c]: &[u32; 3]) -> bool {
    a != b && b != c && c != a
}

/// Returns for each vertex an earlier vertex with the same coordinates, whose own entry is the
/// first such vertex.
///
/// A small table finds equal vertices that are close in the list, as in triangles without indices.
/// The others are distributed by their hashes into parts whose tables fit into a cache, and each
/// part is processed in order.
fn first_equal(vertices: &[[f64; 3]], threads: Threads) -> Vec<AtomicU32> {
    let first: Vec<AtomicU32> = (0..vertices.len()).map(|_| AtomicU32::new(NONE)).collect();
    let parts = (vertices.len() / PART).next_power_of_two().min(PARTS);
    let dealt = threads.map_pieces(vertices.len(), PIECE, |piece| {
        let mut dealt = vec![Vec::with_capacity(piece.len() / parts); parts];
        let mut table = Table::of(piece.len());
        for k in piece {
            let entry = Entry::new(hash(&vertices[k]), k as u32);
            let near = table.first(vertices, entry);
            first[k].store(near, Ordering::Relaxed);
            if near == entry.number() {
                dealt[entry.part(parts)].push(entry);
            }
        }
        dealt
    });
    if let [_] = &dealt[..] {
        return first; // one piece has found all
    }
    threads.map(parts, |part| {
        let all = || dealt.iter().flat_map(|piece| &piece[part]);
        let mut table = Table::of(dealt.iter().map(|piece| piece[part].len()).sum());
        for &entry in all() {
            first[entry.number() as usize].store(table.first(vertices, entry), Ordering::Relaxed);
        }
    });
    first
}

/// Number of vertices in a piece of work.
const PIECE: usize = 1 << 14;

/// Number of vertices in a part, and maximum number of parts.
const PART: usize = 1 << 15;
const PARTS: usize = 1 << 8;

/// Upper half of a vertex's hash, and the vertex's index.
#[derive(Clone, Copy, PartialEq)]
struct Entry(u64);

impl Entry {
    /// Empty slot: the index is `NONE`.
    const EMPTY: Self = Self(u64::MAX);

    const fn new(hash: u64, number: u32) -> Self {
        Self(hash >> 32 << 32 | number as u64)
    }

    const fn hash(self) -> usize {
        (self.0 >> 32) as usize
    }

    const fn number(self) -> u32 {
        self.0 as u32
    }

    /// Returns the part by the first bits of the hash; a table uses the last ones.
    const fn part(self, parts: usize) -> usize {
        (self.0 >> 56) as usize * parts / PARTS
    }
}

fn bits(vertex: &[f64; 3]) -> [u64; 3] {
    vertex.map(|c| (c + 0.0).to_bits())
}

/// Hashes the coordinates by folded products, as in wyhash: every bit of them affects every bit of
/// the hash.
fn hash(vertex: &[f64; 3]) -> u64 {
    let fold = |a: u64, b: u64| {
        let product = u128::from(a) * u128::from(b);
        (product as u64) ^ ((product >> 64) as u64)
    };
    let [x, y, z] = bits(vertex);
    let xy = fold(x ^ 0xa076_1d64_78bd_642f, y ^ 0xe703_7ed1_a0b4_28db);
    fold(xy ^ 0x8ebc_6af0_9c88_c6e3, z ^ 0x5899_65cc_7537_4cc3)
}

/// Hash table of vertices with open addressing, at most half full.
struct Table {
    slots: Vec<Entry>,
    filled: usize,
}

impl Table {
    /// Returns a table for `vertices` vertices; in triangles without indices about one in six is
    /// new.
    fn of(vertices: usize) -> Self {
        Self { slots: vec![Entry::EMPTY; (vertices / 2).next_power_of_two().max(64)], filled: 0 }
    }

    /// Returns the vertex of the table with the same coordinates, or inserts this one.
    fn first(&mut self, vertices: &[[f64; 3]], entry: Entry) -> u32 {
        if 2 * self.filled >= self.slots.len() {
            self.grow();
        }
        let place = |entry: Entry| bits(&vertices[entry.number() as usize]);
        let mask = self.slots.len() - 1;
        let mut at = entry.hash() & mask;
        loop {
            let known = self.slots[at];
            if known == Entry::EMPTY {
                self.slots[at] = entry;
                self.filled += 1;
                return entry.number();
            }
            if known.hash() == entry.hash() && place(known) == place(entry) {
                return known.number();
            }
            at = (at + 1) & mask;
        }
    }

    fn grow(&mut self) {
        let empty = vec![Entry::EMPTY; 4 * self.slots.len()];
        let old = core::mem::replace(&mut self.slots, empty);
        let mask = self.slots.len() - 1;
        for slot in old.into_iter().filter(|&slot| slot != Entry::EMPTY) {
            let mut at = slot.hash() & mask;
            while self.slots[at] != Entry::EMPTY {
                at = (at + 1) & mask;
            }
            self.slots[at] = slot;
        }
    }
}
