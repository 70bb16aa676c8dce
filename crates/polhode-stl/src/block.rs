//! One block of records, summed by one thread.

use fearless_simd::{Level, Simd, dispatch, f32x16, f64x8, i64x8, prelude::*};

use crate::columns::Columns;
use crate::edges;
use crate::not_finite::NotFinite;
use crate::record::Record;
use crate::record::{GROUP, VERTICES};
use crate::sums::{self, LANES, SUMS};

/// Triangles in a stage: their numbers stay in the nearest memory between its loops.
///
/// Each loop is so short that the processor is in several of its turns at once. One loop from bytes to sums takes an eighth longer
/// than these two, as the registers do not suffice for it (AVX-512, records in the second cache).
const STAGE: usize = 128;

/// Triangles that are summed without compensation: 128 a lane.
const CHUNK: usize = 1024;

/// What one block adds to the moments. The sums carry their rounding errors, lane by lane.
#[derive(Clone, Debug)]
pub(crate) struct Block {
    pub(crate) sums: [[f64; LANES]; SUMS],
    pub(crate) errors: [[f64; LANES]; SUMS],
    pub(crate) low: [f32; 3],
    pub(crate) high: [f32; 3],
    pub(crate) edges: i64,
    /// The index counts from the first record of the block.
    pub(crate) not_finite: Option<NotFinite>,
    records: u64,
}

impl Block {
    pub(crate) fn new() -> Self {
        Self {
            sums: [[0.0; LANES]; SUMS],
            errors: [[0.0; LANES]; SUMS],
            low: [f32::INFINITY; 3],
            high: [f32::NEG_INFINITY; 3],
            edges: 0,
            not_finite: None,
            records: 0,
        }
    }

    /// Adds records: a whole number of chunks, but for the last of the block.
    pub(crate) fn add(&mut self, level: Level, records: &[Record], reference: [f64; 3], with_edges: bool) {
        dispatch!(level, simd => simd.vectorize(
            #[inline(always)]
            || {
                if with_edges {
                    self.add_in_vectors::<_, true>(simd, records, reference);
                } else {
                    self.add_in_vectors::<_, false>(simd, records, reference);
                }
            }
        ));
    }

    #[inline(always)]
    fn add_in_vectors<S: Simd, const EDGES: bool>(
        &mut self,
        simd: S,
        records: &[Record],
        reference: [f64; 3],
    ) {
        let reference = reference.map(|c| f64x8::splat(simd, c));
        let mut stage = Stage::<S>::new(simd);
        for chunk in records.chunks(CHUNK) {
            let (whole, rest) = chunk.as_chunks::<STAGE>();
            for records in whole {
                stage.add::<EDGES>(simd, records, &reference);
            }
            if let Some(padded) = padded(rest) {
                stage.add::<EDGES>(simd, &padded, &reference);
            }
            stage.finish(simd);
            if !self.take(simd, &mut stage) {
                self.find_not_finite(chunk);
            }
            self.records += chunk.len() as u64;
        }
        for k in 0..3 {
            self.low[k] = self.low[k].min(stage.low[k].reduce_min());
            self.high[k] = self.high[k].max(stage.high[k].reduce_max());
        }
        self.edges = <[i64; LANES]>::from(stage.edges).into_iter().fold(self.edges, i64::wrapping_add);
    }

    /// Moves the sums of a chunk here, compensated; whether they are finite. No sum of finite `f32` overflows, and a
    /// coordinate that is not finite leaves its trace in d s.
    #[inline(always)]
    fn take<S: Simd>(&mut self, simd: S, stage: &mut Stage<S>) -> bool {
        let zero = f64x8::splat(simd, 0.0);
        let mut trace = zero;
        for (k, sum) in stage.sums.iter_mut().enumerate() {
            // a + b as rounded sum and exact error (Knuth, TAOCP 2, §4.2.2, Theorem B).
            let (a, b) = (f64x8::from_slice(simd, &self.sums[k]), *sum);
            let s = a + b;
            let bb = s - a;
            let error = (a - (s - bb)) + (b - bb);
            self.sums[k] = s.into();
            self.errors[k] = (f64x8::from_slice(simd, &self.errors[k]) + error).into();
            trace += b * 0.0;
            *sum = zero;
        }
        <[f64; LANES]>::from(trace).iter().all(|&t| t == 0.0)
    }

    #[cold]
    fn find_not_finite(&mut self, chunk: &[Record]) {
        for (triangle, record) in (self.records..).zip(chunk) {
            for (corner, bytes) in record[VERTICES..].as_chunks::<12>().0.iter().enumerate() {
                let values = bytes.as_chunks::<4>().0.iter().map(|&word| f32::from_le_bytes(word));
                if let Some((k, value)) = values.enumerate().find(|(_, value)| !value.is_finite()) {
                    let offset = VERTICES + 12 * corner + 4 * k;
                    let first = NotFinite { vertices: 0, triangle, offset, value };
                    self.not_finite.get_or_insert(first).vertices += 1;
                }
            }
        }
    }
}

/// The last records of a chunk, and their last corner again and again: triangles that bound nothing.
fn padded(records: &[Record]) -> Option<[Record; STAGE]> {
    let mut corner = *records.last()?;
    corner.copy_within(VERTICES..VERTICES + 12, VERTICES + 12);
    corner.copy_within(VERTICES..VERTICES + 12, VERTICES + 24);
    let mut padded = [corner; STAGE];
    padded[..records.len()].copy_from_slice(records);
    Some(padded)
}

/// What the loops of a stage hand to each other, and the sums since the last chunk.
struct Stage<S: Simd> {
    columns: [Columns<S>; STAGE / GROUP],
    /// What waits to be added.
    terms: sums::Terms<S>,
    sums: [f64x8<S>; SUMS],
    low: [f32x16<S>; 3],
    high: [f32x16<S>; 3],
    edges: i64x8<S>,
}

impl<S: Simd> Stage<S> {
    #[inline(always)]
    fn new(simd: S) -> Self {
        let zero = f64x8::splat(simd, 0.0);
        Self {
            columns: [Columns::zero(simd); STAGE / GROUP],
            terms: sums::nothing(simd),
            sums: [zero; SUMS],
            low: [f32x16::splat(simd, f32::INFINITY); 3],
            high: [f32x16::splat(simd, f32::NEG_INFINITY); 3],
            edges: i64x8::splat(simd, 0),
        }
    }

    #[inline(always)]
    fn add<const EDGES: bool>(&mut self, simd: S, records: &[Record; STAGE], reference: &[f64x8<S>; 3]) {
        let (mut low, mut high) = (self.low, self.high);
        let groups = records.as_chunks::<GROUP>().0;
        for (stored, group) in self.columns.iter_mut().zip(groups) {
            let columns = Columns::of(simd, group);
            for k in 0..3 {
                let [a, b, c] = [columns.0[k], columns.0[k + 3], columns.0[k + 6]];
                low[k] = low[k].min(a).min(b.min(c));
                high[k] = high[k].max(a).max(b.max(c));
            }
            *stored = columns;
        }
        (self.low, self.high) = (low, high);
        if EDGES {
            let mut edges = self.edges;
            for columns in &self.columns {
                core::hint::black_box(());
                edges = edges::with_areas(simd, edges, columns);
            }
            self.edges = edges;
        }
        let (mut all, mut terms) = (self.sums, self.terms);
        for k in 0..STAGE / LANES {
            core::hint::black_box(());
            // Added a turn later: sums that wait for their terms, a chain of some 50 cycles, would fill the queues of the processor.
            sums::add(&mut all, &terms);
            terms = sums::terms(simd, &self.columns[k / 2].half(simd, k % 2), reference);
        }
        (self.sums, self.terms) = (all, terms);
    }

    /// Adds the terms that wait, and leaves such as add nothing.
    #[inline(always)]
    fn finish(&mut self, simd: S) {
        sums::add(&mut self.sums, &self.terms);
        self.terms = sums::nothing(simd);
    }
}
