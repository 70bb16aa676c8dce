//! Corners that are the same point: their coordinates are equal, exactly.

use std::sync::atomic::{AtomicU32, Ordering};

use super::TriangleMesh;
use super::threads::Threads;
use crate::math::symmetric3::power_of_two_near;

/// Not a vertex, a triangle, an edge or a component.
pub(crate) const NONE: u32 = u32::MAX;

/// The points of a mesh, each once, and its triangles between them.
///
/// The points are in units of a power of two near the largest coordinate: exact, and no product of a few leaves the range of f64.
#[derive(Clone, Debug)]
pub(crate) struct Welded {
    /// In the order in which triangles use them.
    pub(crate) points: Vec<[f64; 3]>,
    pub(crate) corners: Vec<[u32; 3]>,
    pub(crate) unit: f64,
}

impl Welded {
    pub(crate) fn of(mesh: &TriangleMesh, threads: Threads) -> Self {
        let vertices = mesh.vertices();
        let first = first_equal(vertices, threads);
        let mut points = Vec::new();
        let mut number = vec![NONE; vertices.len()];
        let mut numbered = |index: u32| {
            let first = first[index as usize].load(Ordering::Relaxed) as usize;
            if number[first] == NONE {
                number[first] = points.len() as u32; // ≤ the number of an index
                points.push(vertices[first].map(|c| c + 0.0)); // −0 is 0
            }
            number[first]
        };
        let corners = mesh.triangles().iter().map(|corners| corners.map(&mut numbered)).collect();
        let largest = points.as_flattened().iter().fold(0.0_f64, |max, c| max.max(c.abs()));
        let unit = power_of_two_near(largest);
        let per_unit = 1.0 / unit;
        points.as_flattened_mut().iter_mut().for_each(|c| *c *= per_unit);
        Self { points, corners, unit }
    }

    /// The corners of a triangle, in units.
    #[inline(always)]
    pub(crate) fn triangle(&self, t: usize) -> [[f64; 3]; 3] {
        self.corners[t].map(|v| self.points[v as usize])
    }

    /// A point in the mesh's own unit of length.
    pub(crate) fn place(&self, point: [f64; 3]) -> [f64; 3] {
        point.map(|c| c * self.unit)
    }
}

/// Three different corners.
pub(crate) fn is_proper(&[a, b, c]: &[u32; 3]) -> bool {
    a != b && b != c && c != a
}

/// The first vertex with the same coordinates, of each vertex.
///
/// Each thread has the vertices of some hashes, and goes through them in order.
fn first_equal(vertices: &[[f64; 3]], threads: Threads) -> Vec<AtomicU32> {
    let first: Vec<AtomicU32> = (0..vertices.len()).map(|_| AtomicU32::new(NONE)).collect();
    let parts = threads.count();
    threads.map(parts, |part| {
        let mut table = Table::of(vertices.len() / parts);
        for (k, vertex) in vertices.iter().enumerate() {
            let hash = hash(vertex);
            if (hash >> 48) as usize % parts == part {
                first[k].store(table.first(vertices, k as u32, hash), Ordering::Relaxed);
            }
        }
    });
    first
}

fn bits(vertex: &[f64; 3]) -> [u64; 3] {
    vertex.map(|c| (c + 0.0).to_bits())
}

/// Every bit of the coordinates changes every bit of the hash: by folded products, as in wyhash.
fn hash(vertex: &[f64; 3]) -> u64 {
    let fold = |a: u64, b: u64| {
        let product = u128::from(a) * u128::from(b);
        (product as u64) ^ ((product >> 64) as u64)
    };
    let [x, y, z] = bits(vertex);
    let xy = fold(x ^ 0xa076_1d64_78bd_642f, y ^ 0xe703_7ed1_a0b4_28db);
    fold(xy ^ 0x8ebc_6af0_9c88_c6e3, z ^ 0x5899_65cc_7537_4cc3)
}

/// A hash table of vertices by their number, open, at most half full.
struct Table {
    /// The upper half of the hash and the number.
    slots: Vec<u64>,
    filled: usize,
}

const EMPTY: u64 = u64::MAX;

impl Table {
    /// For so many vertices, of which in triangles without indices every sixth is new.
    fn of(vertices: usize) -> Self {
        Self { slots: vec![EMPTY; (vertices / 2).next_power_of_two().max(1024)], filled: 0 }
    }

    /// The vertex of the table with the same coordinates, or else this one.
    fn first(&mut self, vertices: &[[f64; 3]], number: u32, hash: u64) -> u32 {
        if 2 * self.filled >= self.slots.len() {
            self.grow(vertices);
        }
        let mask = self.slots.len() - 1;
        let mut at = hash as usize & mask;
        loop {
            let slot = self.slots[at];
            if slot == EMPTY {
                self.slots[at] = (hash >> 32 << 32) | u64::from(number);
                self.filled += 1;
                return number;
            }
            let known = slot as u32;
            if slot >> 32 == hash >> 32 && bits(&vertices[known as usize]) == bits(&vertices[number as usize])
            {
                return known;
            }
            at = (at + 1) & mask;
        }
    }

    fn grow(&mut self, vertices: &[[f64; 3]]) {
        let empty = vec![EMPTY; 4 * self.slots.len()];
        let old = core::mem::replace(&mut self.slots, empty);
        let mask = self.slots.len() - 1;
        for slot in old.into_iter().filter(|&slot| slot != EMPTY) {
            let mut at = hash(&vertices[slot as u32 as usize]) as usize & mask;
            while self.slots[at] != EMPTY {
                at = (at + 1) & mask;
            }
            self.slots[at] = slot;
        }
    }
}
