//! The sums over triangles, lane by lane.
//!
//! For a triangle (a, b, c) seen from the reference point, with e = b − a and f = c − a,
//!
//! d = a · (e × f),  s = a + b + c,  p = a + b,  q = b + c,  r = c + a
//!
//! 6 V = Σ d,  24 V c = Σ d s,  120 V ⟨x xᵀ⟩ = Σ d (p pᵀ + q qᵀ + r rᵀ),  2 A = Σ |e × f|
//!
//! as a aᵀ + b bᵀ + c cᵀ + s sᵀ = p pᵀ + q qᵀ + r rᵀ. As p = 2 a + e, r = 2 a + f and q = p + f, b and c are not needed from the
//! reference point. The volume comes last in each product: what waits for it, the longest chain, is one sum each. (With
//! 8 s sᵀ + u uᵀ + 3 v vᵀ, u = e + f, v = e − f, there are 17 sums instead of 11, and the terms do not fit into the registers beside
//! them: 2 % slower on a quiet core of AMD Zen 5, 14 % on a busy one.)
//!
//! e and f are exact: differences of `f32` in `f64`, if their exponents are within 29 of each other.

use fearless_simd::{Simd, SimdBase as _, SimdFloat as _, f32x8, f64x8};

/// How many sums there are: d, d s, d (p pᵀ + q qᵀ + r rᵀ), |e × f|.
pub(crate) const SUMS: usize = 11;

/// Triangles side by side in the sums.
pub(crate) const LANES: usize = 8;

/// Of eight triangles: d, s, p pᵀ + q qᵀ + r rᵀ, |e × f|².
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
    let (nx, ny, nz) = (less(ey, fz, ez * fy), less(ez, fx, ex * fz), less(ex, fy, ey * fx));
    let (ax, ay, az) = (ax - reference[0], ay - reference[1], az - reference[2]);
    let d = plus(az, nz, plus(ay, ny, ax * nx));
    let square = plus(nz, nz, plus(ny, ny, nx * nx));
    let (twice_ax, twice_ay, twice_az) = (ax + ax, ay + ay, az + az);
    let (px, py, pz) = (twice_ax + ex, twice_ay + ey, twice_az + ez);
    let (rx, ry, rz) = (twice_ax + fx, twice_ay + fy, twice_az + fz);
    let (qx, qy, qz) = (px + fx, py + fy, pz + fz);
    let xx = plus(rx, rx, plus(qx, qx, px * px));
    let yy = plus(ry, ry, plus(qy, qy, py * py));
    let zz = plus(rz, rz, plus(qz, qz, pz * pz));
    let xy = plus(rx, ry, plus(qx, qy, px * py));
    let xz = plus(rx, rz, plus(qx, qz, px * pz));
    let yz = plus(ry, rz, plus(qy, qz, py * pz));
    [d, qx + ax, qy + ay, qz + az, xx, yy, zz, xy, xz, yz, square]
}

/// Adds the terms of eight triangles.
#[inline(always)]
pub(crate) fn add<S: Simd>(
    sums: &mut [f64x8<S>; SUMS],
    &[d, sx, sy, sz, xx, yy, zz, xy, xz, yz, square]: &Terms<S>,
) {
    sums[AREA] += square.sqrt();
    sums[0] += d;
    sums[1] = plus(d, sx, sums[1]);
    sums[2] = plus(d, sy, sums[2]);
    sums[3] = plus(d, sz, sums[3]);
    sums[4] = plus(d, xx, sums[4]);
    sums[5] = plus(d, yy, sums[5]);
    sums[6] = plus(d, zz, sums[6]);
    sums[7] = plus(d, xy, sums[7]);
    sums[8] = plus(d, xz, sums[8]);
    sums[9] = plus(d, yz, sums[9]);
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
pub(crate) const AREA: usize = 10;
