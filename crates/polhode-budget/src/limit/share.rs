//! Share of draws, and a confidence interval of the probability.

/// Number of draws that meet a condition, and a confidence interval of the probability.
///
/// The interval is that of Clopper and Pearson (Biometrika 26, 1934, 404). It contains the
/// probability in at least the stated share of all cases, for any probability.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// Number of draws that meet the condition.
    pub met: usize,
    /// Number of all draws.
    pub of: usize,
    /// Ends of the confidence interval, 0 to 1.
    pub interval: [f64; 2],
    /// Confidence level of the interval, for example 0.95.
    pub level: f64,
}

impl Share {
    /// Makes a share from a count. Returns `None` if `of` is 0, `met` exceeds `of`, or the level is
    /// not between 0 and 1.
    pub fn new(met: usize, of: usize, level: f64) -> Option<Self> {
        let level_holds = level > 0.0 && level < 1.0;
        if of == 0 || met > of || !level_holds {
            return None;
        }
        let (tail, k, rest) = (0.5 * (1.0 - level), met as f64, (of - met) as f64);
        let least = if met == 0 { 0.0 } else { beta_quantile(k, rest + 1.0, tail) };
        let most = if met == of { 1.0 } else { 1.0 - beta_quantile(rest, k + 1.0, tail) };
        Some(Self { met, of, interval: [least, most], level })
    }

    /// Returns the share itself, `met / of`.
    pub fn estimate(&self) -> f64 {
        self.met as f64 / self.of as f64
    }
}

/// Returns the x at which the incomplete beta function is p, by bisection.
fn beta_quantile(a: f64, b: f64, p: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    loop {
        let x = 0.5 * (low + high);
        if x <= low || x >= high || high - low < 1e-15 * high {
            return x;
        }
        if incomplete_beta(a, b, x) < p { low = x } else { high = x }
    }
}

/// Returns the regularised incomplete beta function I_x(a, b), for 0 < x < 1.
fn incomplete_beta(a: f64, b: f64, x: f64) -> f64 {
    let log =
        libm::lgamma(a + b) - libm::lgamma(a) - libm::lgamma(b) + a * libm::log(x) + b * libm::log1p(-x);
    let front = libm::exp(log);
    // The continued fraction converges fast below the mean.
    if x < (a + 1.0) / (a + b + 2.0) {
        front * fraction(a, b, x) / a
    } else {
        1.0 - front * fraction(b, a, 1.0 - x) / b
    }
}

/// Returns the continued fraction 1/(1 + d₁/(1 + d₂/(1 + …))) of I_x (DLMF 8.17.22), by Lentz's
/// method.
fn fraction(a: f64, b: f64, x: f64) -> f64 {
    const TINY: f64 = 1e-300;
    let kept = |x: f64| if x.abs() < TINY { TINY } else { x };
    let (mut c, mut d) = (1.0, 1.0 / kept(1.0 - (a + b) * x / (a + 1.0)));
    let mut value = d;
    for m in 1..100_000 {
        let m = f64::from(m);
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        let mut by = 1.0;
        for term in [even, odd] {
            d = 1.0 / kept(1.0 + term * d);
            c = kept(1.0 + term / c);
            by *= c * d;
        }
        value *= by;
        if (by - 1.0).abs() < 1e-15 {
            break;
        }
    }
    value
}

/// Returns Φ(z) = ½ erfc(−z/√2).
pub(super) fn normal(z: f64) -> f64 {
    0.5 * libm::erfc(-z * core::f64::consts::FRAC_1_SQRT_2)
}
