//! Sobol sequence with Owen scrambling: random points that fill the cube more evenly than
//! independent ones.

use polhode_scenario::read::SOBOL_DIMENSIONS;

use super::mix::mix;

/// One dimension of the sequence, with scrambled digits.
#[derive(Clone, Debug)]
pub(crate) struct Scrambled {
    /// Direction numbers: the effect of each binary digit of the index on the point.
    directions: [u32; 32],
    key: u64,
}

impl Scrambled {
    /// Creates dimension `dimension`, from 0, with digits scrambled by a key.
    pub(crate) fn new(dimension: usize, key: u64) -> Self {
        Self { directions: directions(dimension), key }
    }

    /// Returns the point of an index as 32 binary digits.
    pub(crate) fn point(&self, index: u32) -> u32 {
        let mut point = 0;
        let mut rest = index;
        for direction in self.directions {
            point ^= direction * (rest & 1);
            rest >>= 1;
        }
        self.scrambled(point)
    }

    /// Applies Owen's nested scrambling: all preceding digits determine at random whether a digit
    /// is inverted (Owen, Randomly permuted (t, m, s)-nets and (t, s)-sequences, 1995).
    fn scrambled(&self, point: u32) -> u32 {
        (0..u32::BITS).fold(0, |scrambled, digit| {
            // The digits before this one, preceded by a one that marks their number.
            let before = (u64::from(point) | 1 << 32) >> (32 - digit);
            let turned = mix(self.key ^ mix(before)) as u32 & 1;
            scrambled << 1 | (point >> (31 - digit) & 1) ^ turned
        })
    }
}

/// Returns the direction numbers `v_i` of a dimension, from the polynomial
/// `x^s + a_1 x^(s−1) + … + 1` and the first s of `m_i` (Bratley and Fox, 1988):
///
/// m_i = 2 a_1 m_(i−1) ⊕ … ⊕ 2^(s−1) a_(s−1) m_(i−s+1) ⊕ 2^s m_(i−s) ⊕ m_(i−s),  v_i = m_i 2^(32−i)
fn directions(dimension: usize) -> [u32; 32] {
    let first: (u32, &[u32]) = (1, &[]);
    let (polynomial, initial) =
        dimension.checked_sub(1).and_then(|k| POLYNOMIALS.get(k)).copied().unwrap_or(first);
    let degree = initial.len();
    let mut directions = [0_u32; 32];
    for i in 0..directions.len() {
        let shift = 31 - i as u32;
        directions[i] = match (initial.get(i), degree) {
            (Some(m), _) => m << shift,
            (None, 0) => 1 << shift,
            (None, _) => {
                let mut v = directions[i - degree] ^ (directions[i - degree] >> degree);
                for k in 1..degree {
                    if polynomial >> (degree - k) & 1 == 1 {
                        v ^= directions[i - k];
                    }
                }
                v
            }
        };
    }
    directions
}

/// Primitive polynomials, as numbers whose binary digits are the coefficients, and initial numbers
/// m_i, for dimensions 2 to 64 (Joe and Kuo, Constructing Sobol sequences with better
/// two-dimensional projections, 2008; new-joe-kuo-6.21201).
#[rustfmt::skip]
const POLYNOMIALS: [(u32, &[u32]); SOBOL_DIMENSIONS - 1] = [
    (3, &[1]), (7, &[1, 3]), (11, &[1, 3, 1]), (13, &[1, 1, 1]), (19, &[1, 1, 3, 3]), (25, &[1, 3, 5, 13]),
    (37, &[1, 1, 5, 5, 17]), (41, &[1, 1, 5, 5, 5]), (47, &[1, 1, 7, 11, 19]), (55, &[1, 1, 5, 1, 1]),
    (59, &[1, 1, 1, 3, 11]), (61, &[1, 3, 5, 5, 31]), (67, &[1, 3, 3, 9, 7, 49]),
    (91, &[1, 1, 1, 15, 21, 21]), (97, &[1, 3, 1, 13, 27, 49]), (103, &[1, 1, 1, 15, 7, 5]),
    (109, &[1, 3, 1, 15, 13, 25]), (115, &[1, 1, 5, 5, 19, 61]), (131, &[1, 3, 7, 11, 23, 15, 103]),
    (137, &[1, 3, 7, 13, 13, 15, 69]), (143, &[1, 1, 3, 13, 7, 35, 63]), (145, &[1, 3, 5, 9, 1, 25, 53]),
    (157, &[1, 3, 1, 13, 9, 35, 107]), (167, &[1, 3, 1, 5, 27, 61, 31]), (171, &[1, 1, 5, 11, 19, 41, 61]),
    (185, &[1, 3, 5, 3, 3, 13, 69]), (191, &[1, 1, 7, 13, 1, 19, 1]), (193, &[1, 3, 7, 5, 13, 19, 59]),
    (203, &[1, 1, 3, 9, 25, 29, 41]), (211, &[1, 3, 5, 13, 23, 1, 55]), (213, &[1, 3, 7, 3, 13, 59, 17]),
    (229, &[1, 3, 1, 3, 5, 53, 69]), (239, &[1, 1, 5, 5, 23, 33, 13]), (241, &[1, 1, 7, 7, 1, 61, 123]),
    (247, &[1, 1, 7, 9, 13, 61, 49]), (253, &[1, 3, 3, 5, 3, 55, 33]),
    (285, &[1, 3, 1, 15, 31, 13, 49, 245]), (299, &[1, 3, 5, 15, 31, 59, 63, 97]),
    (301, &[1, 3, 1, 11, 11, 11, 77, 249]), (333, &[1, 3, 1, 11, 27, 43, 71, 9]),
    (351, &[1, 1, 7, 15, 21, 11, 81, 45]), (355, &[1, 3, 7, 3, 25, 31, 65, 79]),
    (357, &[1, 3, 1, 1, 19, 11, 3, 205]), (361, &[1, 1, 5, 9, 19, 21, 29, 157]),
    (369, &[1, 3, 7, 11, 1, 33, 89, 185]), (391, &[1, 3, 3, 3, 15, 9, 79, 71]),
    (397, &[1, 3, 7, 11, 15, 39, 119, 27]), (425, &[1, 1, 3, 1, 11, 31, 97, 225]),
    (451, &[1, 1, 1, 3, 23, 43, 57, 177]), (463, &[1, 3, 7, 7, 17, 17, 37, 71]),
    (487, &[1, 3, 1, 5, 27, 63, 123, 213]), (501, &[1, 1, 3, 5, 11, 43, 53, 133]),
    (529, &[1, 3, 5, 5, 29, 17, 47, 173, 479]), (539, &[1, 3, 3, 11, 3, 1, 109, 9, 69]),
    (545, &[1, 1, 1, 5, 17, 39, 23, 5, 343]), (557, &[1, 3, 1, 5, 25, 15, 31, 103, 499]),
    (563, &[1, 1, 1, 11, 11, 17, 63, 105, 183]), (601, &[1, 1, 5, 11, 9, 29, 97, 231, 363]),
    (607, &[1, 1, 5, 15, 19, 45, 41, 7, 383]), (617, &[1, 3, 7, 7, 31, 19, 83, 137, 221]),
    (623, &[1, 1, 1, 3, 23, 15, 111, 223, 83]), (631, &[1, 1, 5, 13, 31, 15, 55, 25, 161]),
    (637, &[1, 1, 3, 13, 25, 47, 39, 87, 257]),
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Unscrambled points equal those of scipy.stats.qmc.Sobol(64, scramble=False), in the order of
    /// the index's Gray code.
    #[test]
    fn the_sequence_is_that_of_scipy() {
        let unscrambled = |dimension: usize, index: u32| {
            let digits = directions(dimension);
            (0..32).filter(|k| index >> k & 1 == 1).fold(0, |point, k| point ^ digits[k])
        };
        let gray = |index: u32| index ^ (index >> 1);
        for (dimension, index, expected) in [
            (0, 1, 0.5),
            (0, 2741, 0.968505859375),
            (1, 3, 0.75),
            (1, 4095, 0.941162109375),
            (2, 1234, 0.82666015625),
            (3, 777, 0.2744140625),
            (7, 4001, 0.351806640625),
            (17, 2222, 0.429931640625),
            (31, 3333, 0.213623046875),
            (40, 100, 0.7109375),
            (62, 4090, 0.811767578125),
            (63, 1, 0.5),
            (63, 2749, 0.622314453125),
        ] {
            assert_eq!(f64::from(unscrambled(dimension, gray(index))) / 2.0_f64.powi(32), expected);
        }
    }

    #[test]
    fn every_dimension_has_its_digits_alike_after_scrambling() {
        for dimension in 0..SOBOL_DIMENSIONS {
            let sequence = Scrambled::new(dimension, 0xfeed ^ dimension as u64);
            let mut layers = [false; 256];
            (0..256).for_each(|index| layers[(sequence.point(index) >> 24) as usize] = true);
            assert!(layers.iter().all(|layer| *layer), "{dimension}");
        }
    }

    /// A (0, 2)-sequence: each box of 2^−a × 2^−b contains one of 2^(a+b) points, also after
    /// scrambling.
    #[test]
    fn two_dimensions_are_a_net() {
        let [x, y] = [0, 1].map(|dimension| Scrambled::new(dimension, mix(dimension as u64)));
        for a in 0..=8 {
            let mut boxes = [false; 256];
            for index in 0..256 {
                let (column, row) = (x.point(index) >> (31 - a) >> 1, y.point(index) >> (23 + a) >> 1);
                boxes[(column << (8 - a) | row) as usize] = true;
            }
            assert!(boxes.iter().all(|full| *full), "{a}");
        }
    }
}
