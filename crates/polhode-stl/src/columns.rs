//! Records to columns: the coordinates of sixteen triangles, nine vectors of sixteen numbers.

use fearless_simd::{Simd, f32x4, f32x8, f32x16, prelude::*, u8x16, u8x32};

use crate::record::{GROUP, Record, VERTICES};

/// Which record of a group each lane has: those of the first eight in the first half.
pub(crate) const ORDER: [usize; GROUP] = [0, 2, 4, 6, 1, 3, 5, 7, 8, 10, 12, 14, 9, 11, 13, 15];

/// ax, ay, az, bx, by, bz, cx, cy, cz of sixteen triangles.
#[derive(Clone, Copy)]
pub(crate) struct Columns<S: Simd>(pub(crate) [f32x16<S>; 9]);

impl<S: Simd> Columns<S> {
    #[inline(always)]
    pub(crate) fn zero(simd: S) -> Self {
        Self([f32x16::splat(simd, 0.0); 9])
    }

    /// Vector j starts with the first eight numbers of two records. So its number j (bits j₂ j₁ j₀) and its lane
    /// (h c₂ c₁ c₀) say record and column. A round of unzips moves the lowest bit of the lane to a bit of the
    /// number, and that bit to the highest place of the lane; three rounds leave the record in the lane (j₂ j₁ j₀ h)
    /// and the column in the number (c₂ c₁ c₀). (Zips go the other way round, and need four.)
    #[inline(always)]
    pub(crate) fn of(simd: S, records: &[Record; GROUP]) -> Self {
        #[cfg(target_arch = "x86_64")]
        if let Some(avx512) = simd.level().as_avx512() {
            return Self(crate::columns512::columns(avx512, records).map(|column| column.simd_into(simd)));
        }
        let records = ORDER.map(|k| &records[k]);
        let mut v = [f32x16::splat(simd, 0.0); 8];
        for (j, v) in v.iter_mut().enumerate() {
            *v = simd.combine_f32x8(first_eight(simd, records[2 * j]), first_eight(simd, records[2 * j + 1]));
        }
        let [a, b, c, d, e, f, g, h] = unzipped::<S, 4>(unzipped::<S, 2>(unzipped::<S, 1>(v)));
        Self([a, b, c, d, e, f, g, h, ninth(simd, &records)])
    }

    /// The first eight triangles (0), or the last (1).
    #[inline(always)]
    pub(crate) fn half(&self, simd: S, half: usize) -> [f32x8<S>; 9] {
        let mut columns = [f32x8::splat(simd, 0.0); 9];
        for (eight, column) in columns.iter_mut().zip(&self.0) {
            *eight = f32x8::from_slice(simd, &column.as_slice().as_chunks::<8>().0[half]);
        }
        columns
    }
}

#[inline(always)]
fn first_eight<S: Simd>(simd: S, record: &Record) -> f32x8<S> {
    f32x8::from_bytes(u8x32::from_slice(simd, &record[VERTICES..VERTICES + 32]))
}

/// Each pair of vectors whose numbers differ in one bit: the even lanes of both, and the odd ones.
#[inline(always)]
fn unzipped<S: Simd, const BIT: usize>(v: [f32x16<S>; 8]) -> [f32x16<S>; 8] {
    let mut unzipped = v;
    for j in 0..8 {
        if j & BIT == 0 {
            unzipped[j] = v[j].unzip_low(v[j | BIT]);
            unzipped[j | BIT] = v[j].unzip_high(v[j | BIT]);
        }
    }
    unzipped
}

/// The last number of each record: of four records at a time, from their last four numbers. Sixteen loads and as many shuffles take
/// half as long as one gather (AMD Zen 5).
#[inline(always)]
fn ninth<S: Simd>(simd: S, records: &[&Record; GROUP]) -> f32x16<S> {
    let mut ninth = [f32x4::splat(simd, 0.0); 4];
    for (j, ninth) in ninth.iter_mut().enumerate() {
        let mut v = [f32x4::splat(simd, 0.0); 4];
        for (v, record) in v.iter_mut().zip(&records[4 * j..]) {
            *v = f32x4::from_bytes(u8x16::from_slice(simd, &record[VERTICES + 20..VERTICES + 36]));
        }
        *ninth = v[0].zip_high(v[2]).zip_high(v[1].zip_high(v[3]));
    }
    let [a, b, c, d] = ninth;
    simd.combine_f32x8(simd.combine_f32x4(a, b), simd.combine_f32x4(c, d))
}
