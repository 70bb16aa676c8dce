//! Solid ellipsoid.

use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;
use crate::math::number::PI;

/// Solid ellipsoid with its centre at the origin and its semi-axes along the coordinate axes.
///
/// I = M/5 diag(b² + c², a² + c², a² + b²) for semi-axes a, b, c
///
/// ```
/// use polhode::body::shape::{Ellipsoid, Shape, Substance};
/// let egg = Ellipsoid::new([0.02, 0.02, 0.03])?.mass_properties(Substance::Mass(0.06))?;
/// assert!((egg.inertia().matrix()[2][2] - 0.06 / 5.0 * 0.0008).abs() < 1e-20);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid {
    pub(in crate::body) semi_axes: [f64; 3],
}

impl Ellipsoid {
    /// Returns an ellipsoid with the given semi-axes along x, y and z, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if a semi-axis is not positive and finite.
    pub fn new(semi_axes: [f64; 3]) -> Result<Self, BodyError> {
        for semi_axis in semi_axes {
            positive("the ellipsoid's semi-axis", semi_axis)?;
        }
        representable(Self { semi_axes })
    }
}

impl Shape for Ellipsoid {
    fn spread(&self) -> Spread {
        let [a, b, c] = self.semi_axes;
        Spread::centered(Extent::Volume(4.0 / 3.0 * PI * a * b * c), self.semi_axes.map(|a| a * a / 5.0))
    }

    /// Returns A = 4π abc R_G(a⁻², b⁻², c⁻²) = π (abc)² ∫₀^∞ Σ 1/(1 + a²t) t dt / √Π(1 + a²t).
    ///
    /// The integrand as a function of ln t is analytic in |Im ln t| < π. The trapezoidal rule over
    /// the whole line with step ½ therefore has the relative error e^(−4π²), less than the
    /// rounding.
    ///
    /// Let a ≥ b ≥ c. Then A/ab depends on b/a and c/b only. If one of these ratios is small, its
    /// effect is proportional to its square and becomes negligible.
    ///
    /// Source: DLMF §19.33(i), and R_G as the integral of §19.16(i), with 1/t for t.
    fn surface_area(&self) -> f64 {
        const STEP: f64 = 0.5;
        /// Ratio whose square is far below the rounding.
        const SMALL: f64 = 1e-12;
        // Lengths in units of a. Below t = e^−20 the integrand decreases as t², above 1/c² ≤ e^111
        // as (c²t)^(−1/2). The contributions beyond both ends are less than the rounding.
        const NODES: core::ops::Range<i32> = -40..382;
        let mut axes = self.semi_axes;
        axes.sort_by(|p, q| q.total_cmp(p));
        let [a, b, c] = axes;
        let (y, z) = ((b / a).max(SMALL), (c / b).max(SMALL));
        let (y2, z2) = (y * y, y * y * z * z);
        let integrand = |k: i32| {
            let t = libm::exp(STEP * f64::from(k));
            let [p, q, r] = [1.0 + t, 1.0 + y2 * t, 1.0 + z2 * t];
            (1.0 / p + 1.0 / q + 1.0 / r) * (t / p.sqrt()) * (t / q.sqrt()) / r.sqrt()
        };
        PI * a * b * y * z2 * STEP * NODES.map(integrand).sum::<f64>()
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Ellipsoid { semi_axes: self.semi_axes })
    }
}
