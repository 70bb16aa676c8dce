//! Uniform numbers between 0 and 1, both excluded. Each is a function of a key and a member's
//! number only.

use polhode_scenario::read::Sampling;

use super::permutation::Permutation;
use super::sobol;
use hmac_sha256::Hash as Sha256;

/// One of the uniform numbers of a member.
#[derive(Clone, Debug)]
pub(crate) struct Coordinate {
    /// Key of the random numbers.
    key: u64,
    /// Arrangement of each set of points.
    orders: Vec<Order>,
    /// Number of members in a set.
    size: u64,
}

/// Independently drawn sets of points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sets {
    pub(crate) count: u64,
    /// Number of members in each set.
    pub(crate) size: u64,
}

/// Arrangement of the members' numbers in the unit interval.
#[derive(Clone, Debug)]
enum Order {
    /// Independent of other members.
    Anywhere,
    /// One layer per member, given by the permutation.
    Layer(Permutation),
    /// Point of the scrambled Sobol sequence of this dimension.
    Sobol(sobol::Scrambled),
}

impl Coordinate {
    /// Creates the coordinate `index` of a variable, with place `dimension` among all coordinates.
    ///
    /// Random numbers follow from the seed and the variable's name, so that other variables do not
    /// change them. For Sobol points they also depend on the dimension.
    pub(crate) fn new(
        sampling: Sampling,
        sets: Sets,
        seed: u64,
        name: &str,
        index: usize,
        dimension: usize,
    ) -> Self {
        let key = |purpose: &str, set: u64| match set {
            0 => key(seed, name, index, purpose),
            set => key(seed, name, index, &format!("{purpose} {set}")),
        };
        let order = |set: u64| match sampling {
            Sampling::Grid | Sampling::MonteCarlo => Order::Anywhere,
            Sampling::LatinHypercube => Order::Layer(Permutation::new(sets.size, key("layers", set))),
            Sampling::Sobol => Order::Sobol(sobol::Scrambled::new(dimension, key("digits", set))),
        };
        Self { key: key("draws", 0), orders: (0..sets.count).map(order).collect(), size: sets.size }
    }

    /// Returns the number of a member: 52 binary digits plus half of the last, so that 0 and 1 are
    /// excluded.
    pub(crate) fn uniform(&self, member: u64) -> f64 {
        let random = philox(self.key, member);
        let (set, within) = (member / self.size.max(1), member % self.size.max(1));
        match usize::try_from(set).ok().and_then(|set| self.orders.get(set)) {
            Some(Order::Layer(permutation)) => permutation.draw(within, random),
            // Digits below the 32 of the sequence are random.
            Some(Order::Sobol(sequence)) => {
                unit(u64::from(sequence.point(within as u32)) << 20 | random >> 44)
            }
            Some(Order::Anywhere) | None => unit(random >> 12),
        }
    }
}

/// Returns (n + ½) 2⁻⁵² for a number n of 52 binary digits.
pub(crate) fn unit(n: u64) -> f64 {
    const SCALE: f64 = 1.0 / (1_u64 << 52) as f64;
    (n as f64 + 0.5) * SCALE
}

/// Returns a key for a purpose.
fn key(seed: u64, name: &str, index: usize, purpose: &str) -> u64 {
    let hash = Sha256::hash(format!("{seed}\n{name}\n{index}\n{purpose}").as_bytes());
    hash.iter().take(8).fold(0, |key, byte| key << 8 | u64::from(*byte))
}

/// Returns 64 random bits: half of the block of Philox4×32-10 with this key and counter.
fn philox(key: u64, counter: u64) -> u64 {
    let [a, b, ..] =
        philox4x32([key as u32, (key >> 32) as u32], [counter as u32, (counter >> 32) as u32, 0, 0]);
    u64::from(b) << 32 | u64::from(a)
}

/// Returns a block of Philox4×32-10 (Salmon, Moraes, Dror and Shaw, Parallel random numbers: as
/// easy as 1, 2, 3, SC11).
fn philox4x32(mut key: [u32; 2], mut counter: [u32; 4]) -> [u32; 4] {
    const ROUNDS: u32 = 10;
    for _ in 0..ROUNDS {
        let [c0, c1, c2, c3] = counter;
        let (first, second) = (0xD251_1F53 * u64::from(c0), 0xCD9E_8D57 * u64::from(c2));
        let high = |product: u64| (product >> 32) as u32;
        counter = [high(second) ^ c1 ^ key[0], second as u32, high(first) ^ c3 ^ key[1], first as u32];
        key = [key[0].wrapping_add(0x9E37_79B9), key[1].wrapping_add(0xBB67_AE85)];
    }
    counter
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Known answers distributed with Random123 (`kat_vectors`).
    #[test]
    fn philox_gives_its_known_answers() {
        for (key, counter, answer) in [
            ([0, 0], [0; 4], [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8]),
            ([u32::MAX; 2], [u32::MAX; 4], [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd]),
            (
                [0xa409_3822, 0x299f_31d0],
                [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344],
                [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1],
            ),
        ] {
            assert_eq!(philox4x32(key, counter), answer);
        }
    }

    #[test]
    fn neither_zero_nor_one_is_drawn() {
        assert_eq!(unit(0), 2.0_f64.powi(-53));
        assert_eq!(unit((1 << 52) - 1), 1.0 - 2.0_f64.powi(-53));
    }
}
