//! A hash of the edges of a mesh that is zero when the mesh is closed.
//!
//! Every vertex is sent to a point (p, q) of a plane, p and q from its bits as if by chance. The signed area of the
//! image of a triangle is a sum over its edges,
//!
//! (p_b − p_a)(q_c − q_a) − (p_c − p_a)(q_b − q_a) = [a b] + [b c] + [c a],  [a b] = p_a q_b − p_b q_a = −[b a].
//!
//! Over a mesh each edge that is run along as often one way as the other cancels, so that the sum is zero, exactly: p
//! and q are integers, and the sum is taken modulo 2⁶⁴. If an edge does not cancel, the sum is the area of a polygon
//! with corners at random, and zero about once in 2⁶⁰ meshes. A triangle with two equal corners adds nothing.
//!
//! This is a check against mistakes, not against somebody who builds a mesh to pass it.

use fearless_simd::{Simd, SimdBase as _, f32x16, i32x16, i64x8, prelude::*, u32x16};

use crate::columns::Columns;

/// The sum, and twice the areas of sixteen triangles more.
#[inline(always)]
pub(crate) fn with_areas<S: Simd>(simd: S, sum: i64x8<S>, columns: &Columns<S>) -> i64x8<S> {
    let mut bits = [u32x16::splat(simd, 0); 9];
    let zero = f32x16::splat(simd, 0.0);
    for (bits, &column) in bits.iter_mut().zip(&columns.0) {
        *bits = (column + zero).bitcast(); // −0 + 0 = 0: the same vertex
    }
    let [ax, ay, az, bx, by, bz, cx, cy, cz] = bits;
    let ((pa, qa), (pb, qb), (pc, qc)) = (point(ax, ay, az), point(bx, by, bz), point(cx, cy, cz));
    let (low, high) = simd.widening_mul_i32x16(pb - pa, qc - qa);
    let (less_low, less_high) = simd.widening_mul_i32x16(pc - pa, qb - qa);
    sum + ((low - less_low) + (high - less_high))
}

/// Where vertices are sent: numbers of 31 bits, so that a difference fits into 32 with its sign.
#[inline(always)]
fn point<S: Simd>(x: u32x16<S>, y: u32x16<S>, z: u32x16<S>) -> (i32x16<S>, i32x16<S>) {
    let p = mixed([x, y, z], [0x9E37_79B1, 0x85EB_CA77, 0xC2B2_AE3D], 0x7FB5_D329);
    let q = mixed([z, x, y], [0x27D4_EB2F, 0x1656_67B1, 0x2C1B_3C6D], 0xFFA3_779B);
    (p.bitcast(), q.bitcast())
}

/// A number of 31 bits to which each bit of the three contributes: xor-shifts and odd factors in turn, as the finishers
/// of common hashes have them. The first word is a NaN, so that no coordinate becomes zero under it.
#[inline(always)]
fn mixed<S: Simd>([x, y, z]: [u32x16<S>; 3], factors: [u32; 3], first: u32) -> u32x16<S> {
    let h = (x ^ first) * factors[0];
    let h = h ^ (h >> 15);
    let h = (h + y) * factors[1];
    let h = h ^ (h >> 13);
    let h = (h + z) * factors[2];
    (h ^ (h >> 16)) >> 1
}
