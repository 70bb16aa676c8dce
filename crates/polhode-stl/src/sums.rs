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

use fearless_simd::{Simd, SimdBase as _, SimdFloat as _, f32x8, f64x8};

/// How many sums there are: d, d s, d s sᵀ, d (u uᵀ + 3 v vᵀ), |e × f|.
pub(crate) const SUMS: usize = 17;

/// Triangles side by side in the sums.
pub(crate) const LANES: usize = 8;

/// Of eight triangles: d, s, u, v, |e × f|².
pub(crate) type Terms<S> = [f64x8<S>; 11];

/// Terms that add nothing.
#[inline(always)]
pub(crate) fn nothing<S: Simd>(simd: S) -> Terms<S> {
    [f64x8::splat(simd, 0.0); 11]
}

/// The terms of eight triangles.
#[inline(always)]
pub(crate) fn terms<S: Simd>(simd: S, columns: &[f32x8<S>; 9], reference: &[f64x8<S>; 3]) -> Terms<S> {
    let mut triangles = [f64x8::splat(simd, 0.0); 9];
    for (triangle, &column) in triangles.iter_mut().zip(columns) {
        *triangle = simd.widen_f32x16(simd.combine_f32x8(column, column)).0;
    }
    let [ax, ay, az, bx, by, bz, cx, cy, cz] = triangles;
    let (ex, ey, ez) = (bx - ax, by - ay, bz - az);
    let (fx, fy, fz) = (cx - ax, cy - ay, cz - az);
    let (ax, ay, az) = (ax - reference[0], ay - reference[1], az - reference[2]);
    let (nx, ny, nz) = (less(ey, fz, ez * fy), less(ez, fx, ex * fz), less(ex, fy, ey * fx));
    let d = plus(az, nz, plus(ay, ny, ax * nx));
    let square = plus(nz, nz, plus(ny, ny, nx * nx));
    let (ux, uy, uz) = (ex + fx, ey + fy, ez + fz);
    let three = f64x8::splat(simd, 3.0);
    let (sx, sy, sz) = (plus(ax, three, ux), plus(ay, three, uy), plus(az, three, uz));
    [d, sx, sy, sz, ux, uy, uz, ex - fx, ey - fy, ez - fz, square]
}

/// Adds the terms of eight triangles.
#[inline(always)]
pub(crate) fn add<S: Simd>(
    sums: &mut [f64x8<S>; SUMS],
    &[d, sx, sy, sz, ux, uy, uz, vx, vy, vz, square]: &Terms<S>,
) {
    sums[AREA] += square.sqrt();
    sums[0] += d;
    let (px, py, pz) = (d * sx, d * sy, d * sz);
    sums[1] += px;
    sums[2] += py;
    sums[3] += pz;
    sums[4] = plus(px, sx, sums[4]);
    sums[5] = plus(py, sy, sums[5]);
    sums[6] = plus(pz, sz, sums[6]);
    sums[7] = plus(px, sy, sums[7]);
    sums[8] = plus(px, sz, sums[8]);
    sums[9] = plus(py, sz, sums[9]);
    let (px, py, pz) = (d * ux, d * uy, d * uz);
    let three = d + d + d; // 3 d to the bit; the processor has more to multiply than to add
    let (qx, qy, qz) = (three * vx, three * vy, three * vz);
    sums[10] = plus(qx, vx, plus(px, ux, sums[10]));
    sums[11] = plus(qy, vy, plus(py, uy, sums[11]));
    sums[12] = plus(qz, vz, plus(pz, uz, sums[12]));
    sums[13] = plus(qx, vy, plus(px, uy, sums[13]));
    sums[14] = plus(qx, vz, plus(px, uz, sums[14]));
    sums[15] = plus(qy, vz, plus(py, uz, sums[15]));
}

/// a b + c, rounded once, on every machine.
#[inline(always)]
fn plus<S: Simd>(a: f64x8<S>, b: f64x8<S>, c: f64x8<S>) -> f64x8<S> {
    a.mul_add_precise(b, c)
}

/// a b − c, rounded once, on every machine.
#[inline(always)]
fn less<S: Simd>(a: f64x8<S>, b: f64x8<S>, c: f64x8<S>) -> f64x8<S> {
    a.mul_sub_precise(b, c)
}

/// The place of the areas among the sums.
pub(crate) const AREA: usize = 16;
