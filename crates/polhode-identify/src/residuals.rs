//! Whether what is left is noise.
//!
//! A wrong model does not show in small error bars: it shows in residuals that are larger than the noise, or that follow each other.

/// What is left of a kind of measurement, held against noise.
#[derive(Clone, Debug, PartialEq)]
pub struct ResidualTest {
    /// What was measured: `angular velocity`, `attitude`, `period`, `force` …
    pub what: &'static str,
    /// How many numbers were measured, and how many are left after what they were used for.
    pub count: usize,
    /// count less the share of the numbers that were found from them.
    pub degrees_of_freedom: f64,
    /// Standard deviation of the noise that they were weighed by.
    pub noise: f64,
    /// True if that was told; else it was found from how the readings jump.
    pub noise_is_told: bool,
    /// How well the noise is known: its variance is that of so many squares, ± √(2/so many) of itself. Infinite if it was told.
    pub noise_degrees_of_freedom: f64,
    /// χ²/degrees of freedom. If the model is right and the noise was told: 1 ± √(2/degrees of freedom).
    pub reduced_chi_square: f64,
    /// Correlation of residuals that follow each other in one channel: ± 1/√count of white noise, about −found/count, as a smooth motion was fitted to it.
    pub lag_correlation: Option<f64>,
}

/// How many standard deviations are no chance.
const NO_CHANCE: f64 = 5.0;

/// Of the variance of noise that was found, what is independent of the residuals at least.
const LEAST_SHARE: f64 = 0.25;

/// A standard deviation, and how well it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Noise {
    pub(crate) deviation: f64,
    /// Of how many independent squares its variance has the error: infinite if it was told.
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
    /// Returns true if the residuals are larger than the noise, or correlated: the model is incomplete.
    pub fn shows_model_error(&self) -> bool {
        self.is_too_large() || self.is_correlated()
    }

    /// Of runs of residuals in standard deviations, each of one channel in the order of time.
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

    /// By how many standard deviations of chance the residuals are larger than the noise: normally distributed if the model is right.
    pub fn excess(&self) -> f64 {
        // the cube root of χ² is nearly normal, also for few degrees of freedom: Wilson and Hilferty
        let variance = |degrees: f64| 2.0 / (9.0 * degrees);
        if self.noise_is_told {
            let variance = variance(self.degrees_of_freedom);
            return (libm::cbrt(self.reduced_chi_square) - (1.0 - variance)) / variance.sqrt();
        }
        // The noise is of the same readings. No estimate of their variance is better than that by the residuals, so the error of the other over it is independent
        // of it, and has the difference of their variances (Hausman, Econometrica 46 (1978) 1251).
        let (noise, own) = (1.0 / self.noise_degrees_of_freedom, 1.0 / self.degrees_of_freedom);
        let variance = variance(1.0 / (noise - own).max(LEAST_SHARE * noise));
        ((1.0 - variance) - libm::cbrt(1.0 / self.reduced_chi_square)) / variance.sqrt()
    }

    /// Of a change of told measurements, what has to be left of its χ² until the residuals are larger than the noise beyond chance, in the mean.
    pub(crate) fn least_noncentrality(&self) -> f64 {
        let (degrees, variance) = (self.degrees_of_freedom, 2.0 / (9.0 * self.degrees_of_freedom));
        degrees * ((1.0 - variance + NO_CHANCE * variance.sqrt()).powi(3) - 1.0)
    }

    /// Residuals are smaller than the noise that was told, beyond chance: it is less than that, or the measurements are no independent ones.
    pub fn is_too_small(&self) -> bool {
        self.noise_is_told && self.excess() < -NO_CHANCE
    }

    /// Residuals are larger than the noise, beyond chance.
    pub fn is_too_large(&self) -> bool {
        self.excess() > NO_CHANCE
    }

    /// Residuals follow each other, beyond chance: they are no white noise, and there is more in the motion than in the model.
    pub fn is_correlated(&self) -> bool {
        let count = self.count as f64;
        let by_fit = (self.degrees_of_freedom - count) / count;
        self.lag_correlation.is_some_and(|r| (r - by_fit).abs() > NO_CHANCE / count.sqrt())
    }

    /// By what errors grow for what the residuals show: the root of χ²/degrees of freedom where it is above 1 beyond chance, or where the noise was not told; and
    /// of (1 + r)/(1 − r) where residuals follow each other with correlation r, as the next then brings little news.
    pub fn widening(&self) -> f64 {
        let size = if self.is_too_large() || !self.noise_is_told { self.reduced_chi_square } else { 1.0 };
        let news = match self.lag_correlation {
            Some(r) if self.is_correlated() && r > 0.0 => (1.0 + r) / (1.0 - r.min(0.999)),
            _ => 1.0,
        };
        (size * news).sqrt()
    }

    /// By what errors grow for what all kinds of measurement show: 1 if nothing was measured.
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
