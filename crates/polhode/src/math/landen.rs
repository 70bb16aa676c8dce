//! Descending Landen transformations, which convert amplitudes to arguments that are linear in
//! time.
//!
//! The means are a₀ = 1, g₀ = √m₁, aₙ₊₁ = ½(aₙ + gₙ), gₙ₊₁ = √(aₙ gₙ). Every step halves the
//! argument's share of the elliptic integral and brings the amplitude closer to a linear angle. The
//! correction η of each step is computed without cancellation. Therefore the smallest amplitude and
//! the parameter nearest to 0 keep full relative precision.
//!
//! Source: DLMF §§19.8, 22.20(ii); the corrections are original to this library.

use super::double::Double;

/// Maximum number of steps; 7 are sufficient for m₁ ≥ 0.03.
const STEPS: usize = 8;

/// Convergence threshold; the error of the nome is its square.
const NOME_CONVERGED: f64 = 1e-8;

/// Threshold of the departure; the contribution of a step to a hyperbolic amplitude is its square
/// root.
const NEGLIGIBLE: f64 = 1e-35;

/// Sequence of means for a parameter m, from its complement m₁.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Landen {
    /// Ratios gₙ/aₙ.
    ratio: [f64; STEPS],
    /// Departures 1 − gₙ/aₙ, computed from m.
    departure: [f64; STEPS],
    steps: usize,
    nome: f64,
}

impl Landen {
    /// Computes the sequence for m ≤ about 0.97, given both m and m₁ = 1 − m.
    pub(crate) fn new(m: f64, m1: f64) -> Self {
        let mut landen = Self { ratio: [1.0; STEPS], departure: [0.0; STEPS], steps: 0, nome: 0.0 };
        let (mut a, mut g) = (1.0, m1.sqrt());
        // c₁ = ½(a₀ − g₀), cₙ₊₁ = cₙ² / 4aₙ₊₁.
        let mut c = 0.5 * m / (1.0 + g);
        while landen.steps < STEPS {
            landen.ratio[landen.steps] = g / a;
            landen.departure[landen.steps] = 2.0 * c / a;
            landen.steps += 1;
            (a, g) = (0.5 * (a + g), (a * g).sqrt());
            if landen.nome == 0.0 && c <= NOME_CONVERGED * a {
                // q = lim (cₙ / 4aₙ)^(1/2ⁿ⁻¹).
                landen.nome = (1..landen.steps).fold(c / (4.0 * a), |q, _| q.sqrt());
            }
            if c <= NEGLIGIBLE * a {
                break;
            }
            c *= c / (4.0 * (0.5 * (a + g)));
        }
        landen
    }

    /// Returns the nome q = exp(−πK′/K), with full relative precision.
    pub(crate) const fn nome(&self) -> f64 {
        self.nome
    }

    /// Returns π F(φ|m) / 2K, with φ = atan2(sin, cos) in (−π, π].
    ///
    /// The relation tan(φₙ₊₁ − φₙ) = (gₙ/aₙ) tan φₙ gives φₙ₊₁ = 2φₙ − ηₙ with tan ηₙ = (1 − r) sin
    /// cos / (cos² + r sin²).
    pub(crate) fn angle(&self, sin: f64, cos: f64) -> f64 {
        let (mut s, mut c) = (sin, cos);
        let (mut sum, mut share) = (0.0, 0.5);
        for n in 0..self.steps {
            let r = self.ratio[n];
            sum += share * libm::atan2(self.departure[n] * s * c, c * c + r * s * s);
            (c, s) = (c * c - r * s * s, (1.0 + r) * s * c);
            share *= 0.5;
        }
        libm::atan2(sin, cos) - sum
    }

    /// Returns χ − π F(iχ|m) / 2iK for tanh χ ≥ 0 and sech² χ > 0: the correction to subtract from
    /// χ.
    ///
    /// It is valid for sinh χ ≤ m^−¼, half of the way to K′. Beyond, the steps converge slowly; the
    /// caller uses the distance from K′ instead.
    ///
    /// The relation tanh(χₙ₊₁ − χₙ) = (gₙ/aₙ) tanh χₙ gives χₙ₊₁ = 2χₙ − ηₙ with
    /// e^2ηₙ − 1 = 2 (1 − r) tanh χₙ / ((1 − tanh χₙ)(1 + r tanh χₙ)).
    pub(crate) fn hyperbolic_correction(&self, tanh: f64, sech2: f64) -> f64 {
        let (mut th, mut sigma) = (tanh, sech2);
        let (mut sum, mut share) = (0.0, 0.5);
        for n in 0..self.steps {
            let (r, departure) = (self.ratio[n], self.departure[n]);
            if departure == 0.0 {
                break; // m = 0, where sech² may underflow
            }
            let growth = 2.0 * departure * th * (1.0 + th) / (sigma * (1.0 + r * th));
            sum += share * 0.5 * libm::log1p(growth);
            let below = 1.0 + r * th * th;
            // 1 − r² tanh² = (1 − r)(1 + r) + r² sech².
            sigma *= (departure * (1.0 + r) + r * r * sigma) / (below * below);
            th *= (1.0 + r) / below;
            share *= 0.5;
        }
        sum
    }
}

/// Returns ln x of a double-double number x > 0, with an absolute error of about 10⁻¹⁶ for any
/// magnitude.
pub(crate) fn log_of(x: Double) -> Double {
    // x = f 2ⁿ with f near 1: ln x = n ln 2 + ln f.
    let (mut f, mut n) = libm::frexp(x.high);
    if f < core::f64::consts::FRAC_1_SQRT_2 {
        f *= 2.0;
        n -= 1;
    }
    let ln2 = Double::new(core::f64::consts::LN_2, 2.319_046_813_846_299_6e-17);
    ln2 * Double::from(f64::from(n)) + Double::sum(libm::log(f), x.low / x.high)
}
