//! The turn since the start of a step: a quaternion's series.

use super::row::Row;
use crate::math::number::Number;

/// q ∘ Ω = Σ Ωᵢ q ∘ eᵢ, of Ωᵢ q, q = (w, x, y, z).
#[inline(always)]
pub(super) fn turned_at<N: Number>([p, q, r]: [Row<N>; 3]) -> Row<N> {
    // q ∘ e1 = (−x, w, z, −y), q ∘ e2 = (−y, −z, w, x), q ∘ e3 = (−z, y, −x, w)
    let ([pw, px, py, pz], [qw, qx, qy, qz], [rw, rx, ry, rz]) = (p.0, q.0, r.0);
    Row([-px - qy - rz, pw - qz + ry, pz + qw - rx, qx - py + rw])
}
