//! The moments of a whole file, joined from its blocks.

use crate::block::Block;
use crate::not_finite::NotFinite;
use crate::sums::{AREA, SUMS};

/// Sums over the triangles (a, b, c) of a file, in its unit of length.
///
/// d = a · (b × c), s = a + b + c, coordinates from the reference point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// Triangles.
    pub count: u64,
    /// The point that the sums are about: near the middle of the body.
    pub reference: [f64; 3],
    /// Σ d, six times the volume; negative if the normals point inward.
    pub six_volume: f64,
    /// Σ d s, 24 times the volume times the centroid.
    pub first: [f64; 3],
    /// Σ d (a aᵀ + b bᵀ + c cᵀ + s sᵀ), 120 times the volume times ⟨x xᵀ⟩: xx, yy, zz, xy, xz, yz.
    pub second: [f64; 6],
    /// Area of all triangles.
    pub area: f64,
    /// Least coordinates.
    pub low: [f64; 3],
    /// Greatest coordinates.
    pub high: [f64; 3],
    /// Zero if every edge is run along as often one way as the other, else zero once in some 2⁶⁰ meshes; `None` if it
    /// was not asked for.
    pub edge_hash: Option<u64>,
    /// Vertices that are infinite or not a number: then no sum means anything.
    pub not_finite: Option<NotFinite>,
}

/// What one block adds to the moments, its lanes joined: less than a sixth of [`Block`]. Memory that was never written before is slow,
/// and kept blocks took 5 % of the time.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    sums: [Sum; SUMS],
    low: [f32; 3],
    high: [f32; 3],
    edges: i64,
    not_finite: Option<NotFinite>,
}

impl Part {
    pub(crate) fn of(block: &Block) -> Self {
        let mut sums = [Sum::default(); SUMS];
        for (k, sum) in sums.iter_mut().enumerate() {
            for (&part, &error) in block.sums[k].iter().zip(&block.errors[k]) {
                sum.add(part);
                sum.error += error;
            }
        }
        Self { sums, low: block.low, high: block.high, edges: block.edges, not_finite: block.not_finite }
    }
}

impl Moments {
    /// The blocks are all of the same length but the last, in the order of the file.
    pub(crate) fn joined(
        count: u64,
        block_length: u64,
        reference: [f64; 3],
        blocks: &[Part],
        edges: bool,
    ) -> Self {
        let mut sums = [Sum::default(); SUMS];
        let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        let mut hash = 0_i64;
        let mut not_finite: Option<NotFinite> = None;
        for (number, block) in (0_u64..).zip(blocks) {
            for (sum, part) in sums.iter_mut().zip(&block.sums) {
                sum.add(part.value);
                sum.error += part.error;
            }
            for k in 0..3 {
                low[k] = low[k].min(block.low[k]);
                high[k] = high[k].max(block.high[k]);
            }
            hash = hash.wrapping_add(block.edges);
            if let Some(found) = block.not_finite {
                let triangle = number * block_length + found.triangle;
                not_finite.get_or_insert(NotFinite { vertices: 0, triangle, ..found }).vertices +=
                    found.vertices;
            }
        }
        let value = sums.map(|sum| sum.value + sum.error);
        Self {
            count,
            reference,
            six_volume: value[0],
            first: core::array::from_fn(|k| value[1 + k]),
            second: core::array::from_fn(|k| value[4 + k]),
            area: 0.5 * value[AREA],
            low: low.map(|c| f64::from(c) + 0.0),
            high: high.map(|c| f64::from(c) + 0.0),
            edge_hash: edges.then_some(hash.cast_unsigned()),
            not_finite,
        }
    }
}

/// A sum and its rounding error.
#[derive(Clone, Copy, Debug, Default)]
struct Sum {
    value: f64,
    error: f64,
}

impl Sum {
    /// Knuth, TAOCP 2, §4.2.2, Theorem B.
    fn add(&mut self, term: f64) {
        let s = self.value + term;
        let bb = s - self.value;
        self.error += (self.value - (s - bb)) + (term - bb);
        self.value = s;
    }
}
