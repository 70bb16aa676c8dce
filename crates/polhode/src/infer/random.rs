//! Standard normal and log-normal random numbers, each a function of a seed and of its purpose.

use core::f64::consts::TAU;

/// Generator of random numbers for one purpose.
///
/// SplitMix64 (Steele, Lea and Flood, OOPSLA 2014), and pairs of normal numbers by the method of
/// Box and Muller.
#[derive(Clone, Debug)]
pub struct Random {
    state: u64,
    other: Option<f64>,
}

impl Random {
    /// Returns the generator for a purpose (for example a row or a group) in a draw.
    pub fn new(seed: u64, draw: usize, purpose: u64) -> Self {
        let state = mixed(mixed(mixed(seed) ^ draw as u64) ^ purpose);
        Self { state, other: None }
    }

    /// Returns the next standard normal number: mean 0, standard deviation 1.
    pub fn normal(&mut self) -> f64 {
        if let Some(other) = self.other.take() {
            return other;
        }
        let radius = (-2.0 * libm::log(self.uniform())).sqrt();
        let (sin, cos) = libm::sincos(TAU * self.uniform());
        self.other = Some(radius * sin);
        radius * cos
    }

    /// Returns a uniform number above 0 and below 1.
    fn uniform(&mut self) -> f64 {
        const SCALE: f64 = 1.0 / (1_u64 << 52) as f64;
        self.state = self.state.wrapping_add(GOLDEN);
        ((finished(self.state) >> 12) as f64 + 0.5) * SCALE
    }
}

const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;

fn mixed(x: u64) -> u64 {
    finished(x.wrapping_add(GOLDEN))
}

fn finished(x: u64) -> u64 {
    let x = (x ^ (x >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    x ^ (x >> 31)
}

/// Returns a log-normal number for a standard normal z, with the stated mean and standard
/// deviation.
pub fn log_normal(mean: f64, sd: f64, z: f64) -> f64 {
    let square = libm::log1p((sd / mean) * (sd / mean));
    mean * libm::exp(square.sqrt() * z - 0.5 * square)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splitmix64_gives_its_known_answers() {
        // From the state 0, as in java.util.SplittableRandom and Vigna's splitmix64.c.
        assert_eq!(finished(GOLDEN), 0xE220_A839_7B1D_CDAF);
        assert_eq!(finished(GOLDEN.wrapping_mul(2)), 0x6E78_9E6A_A1B9_65F4);
    }

    #[test]
    fn the_moments_are_those_of_a_normal_distribution() {
        let (mut sums, count) = ([0.0; 4], 200_000);
        for draw in 0..count / 4 {
            let mut random = Random::new(7, draw, 3);
            for _ in 0..4 {
                let x = random.normal();
                sums.iter_mut().enumerate().for_each(|(k, sum)| *sum += x.powi(k as i32 + 1));
            }
        }
        let [m1, m2, m3, m4] = sums.map(|sum| sum / count as f64);
        // Four standard errors of each moment.
        let error = 4.0 / (count as f64).sqrt();
        assert!(m1.abs() < error && (m2 - 1.0).abs() < 1.42 * error, "{m1} {m2}");
        assert!(m3.abs() < 3.9 * error && (m4 - 3.0).abs() < 9.8 * error, "{m3} {m4}");
    }

    #[test]
    fn masses_have_the_mean_and_the_deviation_that_are_stated() {
        // By the trapezoidal rule in z, which is exact to rounding for such functions.
        let (mut m0, mut m1, mut m2) = (0.0, 0.0, 0.0);
        for k in -1200..=1200 {
            let z = 0.01 * f64::from(k);
            let (weight, mass) = ((-0.5 * z * z).exp(), log_normal(2.3, 0.9, z));
            (m0, m1, m2) = (m0 + weight, m1 + weight * mass, m2 + weight * mass * mass);
        }
        let (mean, square) = (m1 / m0, m2 / m0);
        assert!((mean - 2.3).abs() < 1e-13 && ((square - mean * mean).sqrt() - 0.9).abs() < 1e-13);
    }
}
