//! The sums over triangles, lane by lane.
//!
//! For a triangle (a, b, c) seen from the reference point, with e = b − a and f = c − a,
//!
//! d = a · (e × f),  s = a + b + c = 3 a + u,  u = e + f,  v = e − f
//!
//! 6 V = Σ d,  24 V c = Σ d s,  720 V ⟨x xᵀ⟩ = Σ d (8 s sᵀ + u uᵀ + 3 v vᵀ),  2 A = Σ |e × f|
//!
//! as a aᵀ + b bᵀ + c cᵀ = (s sᵀ)/3 + (u uᵀ + 3 v vᵀ)/6, and 120 V ⟨x xᵀ⟩ = Σ d (a aᵀ + b bᵀ + c cᵀ + s sᵀ). One vector
//! in place of three is multiplied with the volume, and the small terms are summed apart from the large ones.
//!
//! e and f are exact: differences of `f32` in `f64`, if their exponents are within 29 of each other.

use fearless_simd::{Simd, SimdBase as _, SimdFloat as _, f64x8};

use crate::columns::Columns;

/// How many sums there are: d, d s, d s sᵀ, d (u uᵀ + 3 v vᵀ), |e × f|.
pub(crate) const SUMS: usize = 17;

/// Triangles side by side in the sums.
pub(crate) const LANES: usize = 8;

/// Of eight triangles: d, s, u, v.
pub(crate) type Terms<S> = [f64x8<S>; 10];

/// The terms of sixteen triangles; their areas are added at once.
#[inline(always)]
pub(crate) fn terms<S: Simd>(
    simd: S,
    columns: &Columns<S>,
    reference: &[f64x8<S>; 3],
    area: &mut f64x8<S>,
) -> [Terms<S>; 2] {
    let mut low = [f64x8::splat(simd, 0.0); 9];
    let mut high = low;
    for k in 0..9 {
        (low[k], high[k]) = simd.widen_f32x16(columns.0[k]);
    }
    [terms_of_eight(low, reference, area), terms_of_eight(high, reference, area)]
}

#[inline(always)]
fn terms_of_eight<S: Simd>(
    triangles: [f64x8<S>; 9],
    reference: &[f64x8<S>; 3],
    area: &mut f64x8<S>,
) -> Terms<S> {
    core::hint::black_box(()); // the two halves one after the other: there are not enough registers for both
    let [ax, ay, az, bx, by, bz, cx, cy, cz] = triangles;
    let (ex, ey, ez) = (bx - ax, by - ay, bz - az);
    let (fx, fy, fz) = (cx - ax, cy - ay, cz - az);
    let (ax, ay, az) = (ax - reference[0], ay - reference[1], az - reference[2]);
    let (nx, ny, nz) = (ey * fz - ez * fy, ez * fx - ex * fz, ex * fy - ey * fx);
    let d = ax * nx + ay * ny + az * nz;
    *area += (nx * nx + ny * ny + nz * nz).sqrt();
    let (ux, uy, uz) = (ex + fx, ey + fy, ez + fz);
    [d, ax * 3.0 + ux, ay * 3.0 + uy, az * 3.0 + uz, ux, uy, uz, ex - fx, ey - fy, ez - fz]
}

/// Adds all but the areas.
#[inline(always)]
pub(crate) fn add<S: Simd>(sums: &mut [f64x8<S>; SUMS], &[d, sx, sy, sz, ux, uy, uz, vx, vy, vz]: &Terms<S>) {
    core::hint::black_box(());
    sums[0] += d;
    let (px, py, pz) = (d * sx, d * sy, d * sz);
    sums[1] += px;
    sums[2] += py;
    sums[3] += pz;
    sums[4] += px * sx;
    sums[5] += py * sy;
    sums[6] += pz * sz;
    sums[7] += px * sy;
    sums[8] += px * sz;
    sums[9] += py * sz;
    let (px, py, pz) = (d * ux, d * uy, d * uz);
    let three = d * 3.0;
    let (qx, qy, qz) = (three * vx, three * vy, three * vz);
    sums[10] += px * ux + qx * vx;
    sums[11] += py * uy + qy * vy;
    sums[12] += pz * uz + qz * vz;
    sums[13] += px * uy + qx * vy;
    sums[14] += px * uz + qx * vz;
    sums[15] += py * uz + qy * vz;
}

/// The place of the areas among the sums.
pub(crate) const AREA: usize = 16;
