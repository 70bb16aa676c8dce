//! Descending Landen transformations: what turns amplitudes into arguments that are linear in time.
//!
//! With the means a₀ = 1, g₀ = √m₁, aₙ₊₁ = ½(aₙ + gₙ), gₙ₊₁ = √(aₙ gₙ), every step halves the argument's share of the
//! elliptic integral and brings the amplitude nearer to a plain angle. Each step's correction η is formed without
//! cancellation, so that the smallest amplitude and the parameter nearest to 0 keep their relative digits.
//!
//! Source: DLMF §§19.8, 22.20(ii); the corrections are ours.

use super::double::Double;

/// The largest number of steps: 7 do for m₁ ≥ 0.03.
const STEPS: usize = 8;

/// The nome's error is the square of this.
const NOME_CONVERGED: f64 = 1e-8;

/// A step's share of a hyperbolic amplitude is the square root of its departure.
const NEGLIGIBLE: f64 = 1e-35;

/// The sequence of means of a parameter m, by its complement m₁.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Landen {
    /// gₙ/aₙ
    ratio: [f64; STEPS],
    /// 1 − gₙ/aₙ, formed from m
    departure: [f64; STEPS],
    steps: usize,
    nome: f64,
}

impl Landen {
    /// For m ≤ 0.97 or so, both m and m₁ = 1 − m given.
    pub(crate) fn new(m: f64, m1: f64) -> Self {
        let mut landen = Self { ratio: [1.0; STEPS], departure: [0.0; STEPS], steps: 0, nome: 0.0 };
        let (mut a, mut g) = (1.0, m1.sqrt());
        // c₁ = ½(a₀ − g₀),  cₙ₊₁ = cₙ² / 4aₙ₊₁
        let mut c = 0.5 * m / (1.0 + g);
        while landen.steps < STEPS {
            landen.ratio[landen.steps] = g / a;
            landen.departure[landen.steps] = 2.0 * c / a;
            landen.steps += 1;
            (a, g) = (0.5 * (a + g), (a * g).sqrt());
            if landen.nome == 0.0 && c <= NOME_CONVERGED * a {
                // q = lim (cₙ / 4aₙ)^(1/2ⁿ⁻¹)
                landen.nome = (1..landen.steps).fold(c / (4.0 * a), |q, _| q.sqrt());
            }
            if c <= NEGLIGIBLE * a {
                break;
            }
            c *= c / (4.0 * (0.5 * (a + g)));
        }
        landen
    }

    /// The nome q = exp(−πK′/K), to its relative digits.
    pub(crate) const fn nome(&self) -> f64 {
        self.nome
    }

    /// π F(φ|m) / 2K, φ = atan2(sin, cos) in (−π, π].
    ///
    /// tan(φₙ₊₁ − φₙ) = (gₙ/aₙ) tan φₙ, so φₙ₊₁ = 2φₙ − ηₙ with tan ηₙ = (1 − r) sin cos / (cos² + r sin²).
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

    /// χ − π F(iχ|m) / 2iK for tanh χ ≥ 0 and sech² χ > 0: what to take from χ.
    ///
    /// For sinh χ ≤ m^−¼, half of the way to K′. Beyond, the steps converge slowly: take the rest of the way from K′ instead.
    ///
    /// tanh(χₙ₊₁ − χₙ) = (gₙ/aₙ) tanh χₙ, so χₙ₊₁ = 2χₙ − ηₙ with
    /// e^2ηₙ − 1 = 2 (1 − r) tanh χₙ / ((1 − tanh χₙ)(1 + r tanh χₙ)).
    pub(crate) fn hyperbolic_correction(&self, tanh: f64, sech2: f64) -> f64 {
        let (mut th, mut sigma) = (tanh, sech2);
        let (mut sum, mut share) = (0.0, 0.5);
        for n in 0..self.steps {
            let (r, departure) = (self.ratio[n], self.departure[n]);
            if departure == 0.0 {
                break; // m = 0, where sech² may have left the range of f64
            }
            let growth = 2.0 * departure * th * (1.0 + th) / (sigma * (1.0 + r * th));
            sum += share * 0.5 * libm::log1p(growth);
            let below = 1.0 + r * th * th;
            // 1 − r² tanh² = (1 − r)(1 + r) + r² sech²
            sigma *= (departure * (1.0 + r) + r * r * sigma) / (below * below);
            th *= (1.0 + r) / below;
            share *= 0.5;
        }
        sum
    }
}

/// ln x of a two-word x > 0, to about 10⁻¹⁶ absolute, however large it is.
pub(crate) fn log_of(x: Double) -> Double {
    // x = f 2ⁿ with f near 1:  ln x = n ln 2 + ln f
    let (mut f, mut n) = libm::frexp(x.high);
    if f < core::f64::consts::FRAC_1_SQRT_2 {
        f *= 2.0;
        n -= 1;
    }
    let ln2 = Double::new(core::f64::consts::LN_2, 2.319_046_813_846_299_6e-17);
    ln2 * Double::from(f64::from(n)) + Double::sum(libm::log(f), x.low / x.high)
}
