//! Standard normal numbers, each a function of a seed and of what it is for.

use core::f64::consts::TAU;

/// Draws for one purpose.
///
/// SplitMix64 (Steele, Lea and Flood, OOPSLA 2014), and pairs of normal numbers after Box and Muller.
#[derive(Clone, Debug)]
pub(crate) struct Random {
    state: u64,
    other: Option<f64>,
}

impl Random {
    /// For a row, or a group, in a draw.
    pub(crate) fn new(seed: u64, draw: usize, purpose: u64) -> Self {
        let state = mixed(mixed(mixed(seed) ^ draw as u64) ^ purpose);
        Self { state, other: None }
    }

    pub(crate) fn normal(&mut self) -> f64 {
        if let Some(other) = self.other.take() {
            return other;
        }
        let radius = (-2.0 * libm::log(self.uniform())).sqrt();
        let (sin, cos) = libm::sincos(TAU * self.uniform());
        self.other = Some(radius * sin);
        radius * cos
    }

    /// Above 0 and below 1.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splitmix64_gives_its_known_answers() {
        // From the state 0, as java.util.SplittableRandom and Vigna's splitmix64.c have them.
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
        // four standard errors of each
        let error = 4.0 / (count as f64).sqrt();
        assert!(m1.abs() < error && (m2 - 1.0).abs() < 1.42 * error, "{m1} {m2}");
        assert!(m3.abs() < 3.9 * error && (m4 - 3.0).abs() < 9.8 * error, "{m3} {m4}");
    }
}
