//! A mass of which all sizes are multiples.

/// A mass of which sizes are multiples, but for rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Unit {
    /// kg
    size: f64,
    /// By how much a multiple may be beside its sum, as a part of it.
    error: f64,
}

/// What is left of a division is nothing below this part of the greatest size.
const NOTHING: f64 = 1e-9;

/// Sizes are multiples to this part.
const NEAR: f64 = 1e-13;

/// More multiples are not counted: each is a number of its own.
const MOST: f64 = 1e12;

impl Unit {
    /// The greatest of positive sizes, by Euclid's algorithm.
    pub(super) fn of(sizes: impl Iterator<Item = f64>) -> Option<Self> {
        let sizes: Vec<f64> = sizes.collect();
        let most = sizes.iter().copied().fold(0.0, f64::max);
        let common = sizes.iter().fold(0.0, |unit: f64, size| {
            let (mut a, mut b) = (*size, unit);
            while b > NOTHING * most {
                let count = (a / b).round();
                (a, b) = (b, (a - count * b).abs());
            }
            a
        });
        if !(common > 0.0) {
            return None;
        }
        let counts: Vec<f64> = sizes.iter().map(|size| (size / common).round()).collect();
        let size = sizes.iter().sum::<f64>() / counts.iter().sum::<f64>();
        let beside = |(of, count): (&f64, &f64)| (of / (count * size) - 1.0).abs();
        let error = sizes.iter().zip(&counts).map(beside).fold(0.0, f64::max);
        let is_one = counts.iter().all(|count| *count >= 1.0) && error <= NEAR;
        is_one.then_some(Self { size, error: error + 8.0 * f64::EPSILON })
    }

    /// Whether multiples up to a mass are not too many.
    pub(super) fn counts_to(&self, mass: f64) -> bool {
        mass / self.size <= MOST
    }

    /// Between which masses a multiple is.
    pub(super) fn times(&self, count: u64) -> [f64; 2] {
        let mass = count as f64 * self.size;
        [mass * (1.0 - self.error), mass * (1.0 + self.error)]
    }

    /// The first multiple that is not below a mass.
    pub(super) fn first_from(&self, mass: f64) -> u64 {
        let mut count = ((mass / self.size).floor() as u64).saturating_sub(1);
        while self.times(count)[1] < mass && (count as f64) < 2.0 * MOST {
            count += 1;
        }
        count
    }

    /// The last multiple that is not above a mass.
    pub(super) fn last_to(&self, mass: f64) -> u64 {
        let mut count = (mass / self.size).ceil() as u64 + 1;
        while count > 0 && self.times(count)[0] > mass {
            count -= 1;
        }
        count
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_those_of_decimals() {
        for (sizes, want) in [
            (&[0.003][..], Some(0.003)),
            (&[0.12, 0.2, 0.15], Some(0.01)),
            (&[0.0032, 0.005, 0.0041], Some(0.0001)),
            (&[0.3, 0.3 * core::f64::consts::SQRT_2], None),
            (&[], None),
        ] {
            match (Unit::of(sizes.iter().copied()), want) {
                (Some(unit), Some(want)) => {
                    assert!((unit.size / want - 1.0).abs() < 1e-14, "{unit:?}");
                    for size in sizes {
                        let [low, high] = unit.times((size / want).round() as u64);
                        assert!(low <= *size && *size <= high && high - low < 1e-14);
                    }
                    let mass = 7.3 * want;
                    assert_eq!((unit.first_from(mass), unit.last_to(mass)), (8, 7));
                    assert_eq!((unit.first_from(5.0 * want), unit.last_to(5.0 * want)), (5, 5));
                }
                (None, None) => {}
                (found, want) => panic!("{found:?} {want:?}"),
            }
        }
    }
}
