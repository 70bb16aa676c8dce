//! A changing body at one time, over a generic number type. The equations are stated once, for
//! values and for power series.

use crate::math::algebra::{Components, Scalar};

/// Elements xx, yy, zz, xy, xz, yz of a symmetric matrix.
pub(super) type Elements<S> = [S; 6];

/// Changing body at one time. Inertia is about the centre of mass, or about the pivot if held.
pub(super) struct Instant<S> {
    /// Vector from `ChangingBody::reference` to the centre of mass, m.
    pub(super) lever: [S; 3],
    /// M times `lever`.
    pub(super) first: [S; 3],
    /// Inertia tensor I.
    pub(super) inertia: Elements<S>,
    /// Rate of change İ of the inertia tensor.
    pub(super) rate: Elements<S>,
    /// D: leaving mass removes the angular momentum D ω per unit time.
    pub(super) drain: Option<Elements<S>>,
    /// True if D = −İ.
    pub(super) is_in_place: bool,
}

/// Returns M v.
pub(super) fn image<S: Scalar>([xx, yy, zz, xy, xz, yz]: Elements<S>, v: Components<S>) -> Components<S> {
    let [x, y, z] = v.0;
    Components([xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z])
}

/// Returns (u·v) 1 − ½ (u vᵀ + v uᵀ).
pub(super) fn steiner<S: Scalar>([a, b, c]: [S; 3], [x, y, z]: [S; 3]) -> Elements<S> {
    let (ax, by, cz) = (a * x, b * y, c * z);
    let off = |p: S, q: S| -(p + q).scaled(0.5);
    [by + cz, ax + cz, ax + by, off(a * y, b * x), off(a * z, c * x), off(b * z, c * y)]
}

pub(super) fn sum<S: Scalar>(a: Elements<S>, b: Elements<S>) -> Elements<S> {
    core::array::from_fn(|k| a[k] + b[k])
}

pub(super) fn difference<S: Scalar>(a: Elements<S>, b: Elements<S>) -> Elements<S> {
    core::array::from_fn(|k| a[k] - b[k])
}

pub(super) fn times<S: Scalar>(a: Elements<S>, by: S) -> Elements<S> {
    a.map(|a| a * by)
}

impl<S: Scalar> Instant<S> {
    /// Returns ω̇ = I⁻¹ (N − ω × I ω − (İ + D) ω).
    pub(super) fn acceleration(&self, omega: Components<S>, torque: Components<S>) -> Components<S> {
        let momentum = image(self.inertia, omega);
        let balance = torque - omega.cross(momentum);
        if self.is_in_place {
            return solved(self.inertia, balance);
        }
        let change = self.drain.map_or(self.rate, |drain| sum(self.rate, drain));
        solved(self.inertia, balance - image(change, omega))
    }

    /// Returns the power that changes T = ½ ω·I ω, and the torque that changes I ω in space.
    pub(super) fn balances(&self, omega: Components<S>, torque: Components<S>) -> (S, Components<S>) {
        // Ṫ = ω·N − ω·D ω − ½ ω·İ ω
        let rate = omega.dot(image(self.rate, omega)).scaled(0.5);
        let drained = if self.is_in_place {
            -image(self.rate, omega)
        } else if let Some(drain) = self.drain {
            image(drain, omega)
        } else {
            return (omega.dot(torque) - rate, torque);
        };
        (omega.dot(torque - drained) - rate, torque - drained)
    }
}

/// Solves I x = b by cofactors.
pub(super) fn solved<S: Scalar>([xx, yy, zz, xy, xz, yz]: Elements<S>, b: Components<S>) -> Components<S> {
    let cofactors = [
        yy * zz - yz * yz,
        zz * xx - xz * xz,
        xx * yy - xy * xy,
        xz * yz - xy * zz,
        xy * yz - xz * yy,
        xy * xz - yz * xx,
    ];
    let determinant = xx * cofactors[0] + xy * cofactors[3] + xz * cofactors[4];
    Components(image(cofactors, b).0.map(|x| x / determinant))
}
