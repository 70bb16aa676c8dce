//! Statistical test of the residuals against the noise.
//!
//! A wrong model need not enlarge the error bars. It appears as residuals that are larger than the
//! noise, or that are correlated in time.

/// Comparison of the residuals of one kind of measurement with its noise.
#[derive(Clone, Debug, PartialEq)]
pub struct ResidualTest {
    /// Measured quantity: `angular velocity`, `attitude`, `period`, `force` …
    pub what: &'static str,
    /// Number of scalar measurements.
    pub count: usize,
    /// Degrees of freedom: `count` minus the share of the parameters estimated from these
    /// measurements.
    pub degrees_of_freedom: f64,
    /// Standard deviation of the noise used as weight.
    pub noise: f64,
    /// True if the noise was specified; false if it was estimated from differences between
    /// readings.
    pub noise_is_told: bool,
    /// Degrees of freedom of the noise variance, n: its relative standard deviation is √(2/n).
    /// Infinite if the noise was specified.
    pub noise_degrees_of_freedom: f64,
    /// Reduced χ²: χ² divided by its degrees of freedom ν. For a right model and specified noise it
    /// is about 1 ± √(2/ν).
    pub reduced_chi_square: f64,
    /// Correlation of successive residuals in one channel. White noise gives ± 1/√count about
    /// −found/count, where `found` counts the fitted parameters.
    pub lag_correlation: Option<f64>,
}

/// Significance threshold, standard deviations.
const NO_CHANCE: f64 = 5.0;

/// Lower bound on the part of the estimated noise variance that is independent of the residuals.
const LEAST_SHARE: f64 = 0.25;

/// Standard deviation of noise, and its uncertainty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Noise {
    pub(crate) deviation: f64,
    /// Degrees of freedom of the variance: infinite if the noise was specified.
    pub(crate) degrees_of_freedom: f64,
}

impl Noise {
    pub(crate) const fn told(deviation: f64) -> Self {
        Self { deviation, degrees_of_freedom: f64::INFINITY }
    }

    pub(crate) const fn is_told(self) -> bool {
        self.degrees_of_freedom == f64::INFINITY
    }
}

impl ResidualTest {
    /// Returns true if the residuals are larger than the noise or correlated: the model is
    /// incomplete.
    pub fn shows_model_error(&self) -> bool {
        self.is_too_large() || self.is_correlated()
    }

    /// Computes the test from runs of residuals in standard deviations, each run one channel in
    /// order of time. `found` counts the parameters estimated from them.
    pub(crate) fn of(what: &'static str, noise: Noise, found: f64, runs: &[Vec<f64>]) -> Self {
        let count: usize = runs.iter().map(Vec::len).sum();
        let sum: f64 = runs.iter().flatten().map(|r| r * r).sum();
        let degrees_of_freedom = (count as f64 - found).max(1.0);
        let pairs: f64 = runs.iter().flat_map(|run| run.windows(2)).map(|pair| pair[0] * pair[1]).sum();
        let lag = (sum > 0.0 && runs.iter().any(|run| run.len() > 2)).then(|| pairs / sum);
        Self {
            what,
            count,
            degrees_of_freedom,
            noise: noise.deviation,
            noise_is_told: noise.is_told(),
            noise_degrees_of_freedom: noise.degrees_of_freedom,
            reduced_chi_square: sum / degrees_of_freedom,
            lag_correlation: lag,
        }
    }

    /// Returns the excess of the residuals over the noise, in standard deviations: normally
    /// distributed if the model is right.
    pub fn excess(&self) -> f64 {
        // The cube root of χ² is nearly normal, also for few degrees of freedom (Wilson and
        // Hilferty).
        let variance = |degrees: f64| 2.0 / (9.0 * degrees);
        if self.noise_is_told {
            let variance = variance(self.degrees_of_freedom);
            return (libm::cbrt(self.reduced_chi_square) - (1.0 - variance)) / variance.sqrt();
        }
        // The noise estimate uses the same readings. The variance estimate from the residuals is
        // efficient, so the difference of the two estimates is independent of it. Its variance is
        // the difference of their variances (Hausman, Econometrica 46 (1978) 1251).
        let (noise, own) = (1.0 / self.noise_degrees_of_freedom, 1.0 / self.degrees_of_freedom);
        let variance = variance(1.0 / (noise - own).max(LEAST_SHARE * noise));
        ((1.0 - variance) - libm::cbrt(1.0 / self.reduced_chi_square)) / variance.sqrt()
    }

    /// Returns the noncentrality of χ² that on average makes the residuals significantly larger
    /// than the specified noise.
    pub(crate) fn least_noncentrality(&self) -> f64 {
        let (degrees, variance) = (self.degrees_of_freedom, 2.0 / (9.0 * self.degrees_of_freedom));
        degrees * ((1.0 - variance + NO_CHANCE * variance.sqrt()).powi(3) - 1.0)
    }

    /// Returns true if the residuals are significantly smaller than the specified noise: the noise
    /// is smaller, or the measurements are not independent.
    pub fn is_too_small(&self) -> bool {
        self.noise_is_told && self.excess() < -NO_CHANCE
    }

    /// Returns true if the residuals are significantly larger than the noise.
    pub fn is_too_large(&self) -> bool {
        self.excess() > NO_CHANCE
    }

    /// Returns true if successive residuals are significantly correlated: the model lacks a part of
    /// the motion.
    pub fn is_correlated(&self) -> bool {
        let count = self.count as f64;
        let by_fit = (self.degrees_of_freedom - count) / count;
        self.lag_correlation.is_some_and(|r| (r - by_fit).abs() > NO_CHANCE / count.sqrt())
    }

    /// Returns the factor by which the errors grow because of the residuals.
    ///
    /// One part is the square root of the reduced χ², where it is significantly above 1 or the
    /// noise was not specified. The other part is √((1 + r)/(1 − r)) for residuals with significant
    /// positive lag correlation r, because successive readings then carry less information.
    pub fn widening(&self) -> f64 {
        let size = if self.is_too_large() || !self.noise_is_told { self.reduced_chi_square } else { 1.0 };
        let news = match self.lag_correlation {
            Some(r) if self.is_correlated() && r > 0.0 => (1.0 + r) / (1.0 - r.min(0.999)),
            _ => 1.0,
        };
        (size * news).sqrt()
    }

    /// Returns the largest factor of all kinds of measurement; 1 if nothing was measured.
    pub(crate) fn widening_of<'a>(tests: impl IntoIterator<Item = &'a Self>) -> f64 {
        tests.into_iter().map(Self::widening).reduce(f64::max).unwrap_or(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Noise = Noise::told(1.0);

    fn noise(count: usize) -> Vec<f64> {
        let mut state = 0.431_f64;
        (0..count)
            .map(|_| {
                (0..12).fold(-6.0, |sum, _| {
                    state = (state * 1997.0 + 0.3127).fract();
                    sum + state
                })
            })
            .collect()
    }

    #[test]
    fn white_noise_is_noise() {
        let test = ResidualTest::of("ω", UNIT, 3.0, &[noise(2000), noise(500)]);
        assert!(!test.is_too_large() && !test.is_correlated(), "{test:?}");
        assert_eq!(test.widening(), 1.0);
    }

    #[test]
    fn what_is_larger_or_follows_itself_is_not() {
        let white = noise(2000);
        let large: Vec<f64> = white.iter().map(|r| 1.2 * r).collect();
        let slow: Vec<f64> = white.windows(4).map(|four| 0.5 * four.iter().sum::<f64>()).collect();
        assert!(ResidualTest::of("ω", UNIT, 3.0, &[large]).is_too_large());
        let test = ResidualTest::of("ω", UNIT, 3.0, &[slow]);
        assert!(test.is_correlated() && test.widening() > 1.5, "{test:?}");
    }
}
