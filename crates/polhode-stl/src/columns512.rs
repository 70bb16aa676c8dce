//! Records to columns with AVX-512.
//!
//! What is scarce here is not shuffles but what moves bytes: on AMD Zen 5 a load across two lines of the cache takes a cycle, and so
//! does a store, each with nothing beside it. So a pair of records, 100 bytes, is loaded twice and not four times: 32 bytes of its first
//! record, and 64 bytes with the end of that and all of its second one, which lies two bytes off the words of the first; a shuffle
//! of 16-bit words does not mind. The round after it stays inside the 128-bit parts of the vectors, where four shuffles a cycle
//! are done instead of two. With the unzips of `columns.rs` the moments take 8 % longer.

use core::arch::x86_64::{
    __m512, __m512i, _mm512_castpd_ps, _mm512_castps_pd, _mm512_castsi256_si512, _mm512_castsi512_ps,
    _mm512_mask_blend_epi32, _mm512_permutex2var_epi16, _mm512_shuffle_f32x4, _mm512_unpackhi_pd,
    _mm512_unpackhi_ps, _mm512_unpacklo_pd, _mm512_unpacklo_ps,
};

use fearless_simd::{prelude::*, u8x32, u8x64};

use crate::record::{GROUP, Record, VERTICES};

fearless_simd::kernel!(
    /// The columns of sixteen records, in the order of `columns.rs`.
    #[inline(always)]
    pub(crate) fn columns(avx512: Avx512, records: &[Record; GROUP]) -> [__m512; 9] {
        let first_eight: __m512i = u8x64::from_slice(avx512, &FIRST_EIGHT).into();
        let ninth: __m512i = u8x64::from_slice(avx512, &NINTH).into();
        let zero: __m512i = u8x64::splat(avx512, 0).into();
        let mut behind = [zero; 8];
        let mut v = [_mm512_castsi512_ps(zero); 8];
        for (j, pair) in records.as_chunks::<2>().0.iter().enumerate() {
            let bytes = pair.as_flattened();
            let first = u8x32::from_slice(avx512, &bytes[VERTICES..VERTICES + 32]);
            behind[j] = u8x64::from_slice(avx512, &bytes[BEHIND..]).into();
            // 128-bit parts: a and bx of the first record, its by, bz, cx, cy, the same of the second.
            let both =
                _mm512_permutex2var_epi16(_mm512_castsi256_si512(first.into()), first_eight, behind[j]);
            v[j] = _mm512_castsi512_ps(both);
        }
        // Four by four inside each part: column k of four records, column k + 4 of them, the same of the four others.
        let mut w = [v[0]; 8];
        for half in [0, 4] {
            let [a, b, c, d] = [v[half], v[half + 1], v[half + 2], v[half + 3]];
            let low = [_mm512_unpacklo_ps(a, b), _mm512_unpacklo_ps(c, d)].map(|v| _mm512_castps_pd(v));
            let high = [_mm512_unpackhi_ps(a, b), _mm512_unpackhi_ps(c, d)].map(|v| _mm512_castps_pd(v));
            w[half] = _mm512_castpd_ps(_mm512_unpacklo_pd(low[0], low[1]));
            w[half + 1] = _mm512_castpd_ps(_mm512_unpackhi_pd(low[0], low[1]));
            w[half + 2] = _mm512_castpd_ps(_mm512_unpacklo_pd(high[0], high[1]));
            w[half + 3] = _mm512_castpd_ps(_mm512_unpackhi_pd(high[0], high[1]));
        }
        let mut columns = [v[0]; 9];
        for k in 0..4 {
            columns[k] = _mm512_shuffle_f32x4::<0b10_00_10_00>(w[k], w[k + 4]);
            columns[k + 4] = _mm512_shuffle_f32x4::<0b11_01_11_01>(w[k], w[k + 4]);
        }
        // Of four records at a time, in every place where they may go.
        let four = |j: usize| _mm512_permutex2var_epi16(behind[j], ninth, behind[j + 1]);
        let low = _mm512_mask_blend_epi32(0b1100_1100_1100_1100, four(0), four(2));
        let high = _mm512_mask_blend_epi32(0b1100_1100_1100_1100, four(4), four(6));
        columns[8] = _mm512_castsi512_ps(_mm512_mask_blend_epi32(0xFF00, low, high));
        columns
    }
);

/// Where the second load of a pair begins.
const BEHIND: usize = 36;

/// Where the vertices of the second record are in it, in 16-bit words, behind the 32 words of the first load.
const SECOND: u8 = 32 + ((50 + VERTICES - BEHIND) / 2) as u8;

/// Sixteen words from the first load, sixteen of the second record.
const FIRST_EIGHT: [u8; 64] = {
    let mut words = [0; 64];
    let mut k = 0;
    while k < 16 {
        words[2 * k] = k as u8;
        words[2 * k + 32] = SECOND + k as u8;
        k += 1;
    }
    words
};

/// The ninth numbers of the first records of two pairs, twice; those of the second records, twice; all again.
const NINTH: [u8; 64] = {
    let first = ((VERTICES + 32 - BEHIND) / 2) as u8;
    let mut words = [0; 64];
    let mut k = 0;
    while k < 16 {
        let word = 32 * (k % 2) as u8 + if k / 4 % 2 == 0 { first } else { SECOND - 32 + 16 };
        words[4 * k] = word;
        words[4 * k + 2] = word + 1;
        k += 1;
    }
    words
};
