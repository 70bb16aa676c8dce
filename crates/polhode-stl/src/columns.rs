//! Records to columns: the coordinates of sixteen triangles, nine vectors of sixteen numbers.

use fearless_simd::{Bytes as _, Simd, SimdBase as _, f32x8, f32x16, u8x32};

use crate::Record;

/// Triangles in a group: one vector of AVX-512 in `f32`.
pub(crate) const GROUP: usize = 16;

/// Where the vertices start in a record, behind the normal.
pub(crate) const VERTICES: usize = 12;

/// ax, ay, az, bx, by, bz, cx, cy, cz of sixteen triangles, in their order.
#[derive(Clone, Copy)]
pub(crate) struct Columns<S: Simd>(pub(crate) [f32x16<S>; 9]);

impl<S: Simd> Columns<S> {
    #[inline(always)]
    pub(crate) fn zero(simd: S) -> Self {
        Self([f32x16::splat(simd, 0.0); 9])
    }

    /// Vector j starts with the first eight numbers of records 2j and 2j + 1. So its number j (bits j₂ j₁ j₀) and its
    /// lane (h c₂ c₁ c₀) say record and column. A round of zips moves the highest bit of the lane to a bit of the
    /// number, and that bit to the lowest place of the lane; four rounds leave the record in the lane (j₂ j₁ j₀ h)
    /// and the column in the number (c₀ c₂ c₁).
    #[inline(always)]
    pub(crate) fn of(simd: S, records: &[Record; GROUP]) -> Self {
        let mut v = [f32x16::splat(simd, 0.0); 8];
        for (j, v) in v.iter_mut().enumerate() {
            *v = simd
                .combine_f32x8(first_eight(simd, &records[2 * j]), first_eight(simd, &records[2 * j + 1]));
        }
        let v = zipped::<S, 4>(zipped::<S, 1>(zipped::<S, 2>(zipped::<S, 4>(v))));
        let mut ninth = [0.0; GROUP];
        for (ninth, record) in ninth.iter_mut().zip(records) {
            *ninth = f32::from_le_bytes([record[44], record[45], record[46], record[47]]);
        }
        Self([v[0], v[4], v[1], v[5], v[2], v[6], v[3], v[7], f32x16::from_slice(simd, &ninth)])
    }
}

#[inline(always)]
fn first_eight<S: Simd>(simd: S, record: &Record) -> f32x8<S> {
    f32x8::from_bytes(u8x32::from_slice(simd, &record[VERTICES..VERTICES + 32]))
}

/// Each pair of vectors whose numbers differ in one bit, interleaved.
#[inline(always)]
fn zipped<S: Simd, const BIT: usize>(v: [f32x16<S>; 8]) -> [f32x16<S>; 8] {
    let mut zipped = v;
    for j in 0..8 {
        if j & BIT == 0 {
            zipped[j] = v[j].zip_low(v[j | BIT]);
            zipped[j | BIT] = v[j].zip_high(v[j | BIT]);
        }
    }
    zipped
}
