//! Eigenvalues and eigenvectors in triple-double precision.

use super::sum::{two_product_of_halves, two_sum, with_halves};
use super::symmetric3::Symmetric3;
use super::triple::Triple;

/// Eigenvalues, ascending except for rounding, and right-handed orthonormal eigenvectors of a
/// symmetric matrix to about 46 digits.
///
/// The iteration starts with vectors of f64 precision. The residuals of the equations are computed
/// in triple-double precision and their correction in f64, so each round doubles the digits or adds
/// those of an f64. With the vectors vⱼ and the values λⱼ,
///
/// rⱼ = S vⱼ − λⱼ vⱼ,  Rᵢⱼ = δᵢⱼ − vᵢ·vⱼ,  λⱼ → λⱼ + vⱼ·rⱼ,  vⱼ → vⱼ + Σᵢ vᵢ Eᵢⱼ,
/// Eᵢⱼ = ½ Rᵢⱼ + ½ (vᵢ·rⱼ + vⱼ·rᵢ) / (λⱼ − λᵢ),  Eⱼⱼ = ½ Rⱼⱼ
///
/// Two vectors of nearly equal values, which f64 does not distinguish, are first rotated in their
/// plane.
///
/// Source: Ogita & Aishima, Japan J. Indust. Appl. Math. 35 (2018) 1007, with the residuals instead
/// of Vᵀ S V. The residuals are small, so that f64 precision of their products is sufficient.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FineEigen {
    pub(crate) values: [Triple; 3],
    pub(crate) vectors: [[Triple; 3]; 3],
}

const PAIRS: [[usize; 2]; 3] = [[0, 1], [0, 2], [1, 2]];

/// Rounding of vᵢ·rⱼ, relative to the largest eigenvalue.
const NEGLIGIBLE: f64 = 1e-46;

/// Correction size 2⁻¹⁰³; after such a correction its own error is below triple-double precision.
const LAST: f64 = 1.0 / (1_u128 << 103) as f64;

/// Largest angle for which a rotation is approximated to first order; the remainder is corrected in
/// the next round.
const SMALL: f64 = 1.0 / 1024.0;

/// Iteration limit: two rounds are sufficient for well separated values, four for nearly equal
/// values.
const MOST_ROUNDS: usize = 12;

impl FineEigen {
    /// Computes the eigenvalues of the matrix minus one of its diagonal elements, if that is exact:
    /// the differences of nearly equal values then keep full relative precision.
    ///
    /// Known vectors of f64 precision save the computation of the first approximation.
    pub(crate) fn of(matrix: &Symmetric3, known: Option<[[f64; 3]; 3]>) -> Self {
        let (rest, shift) = shifted(matrix);
        let vectors = known.unwrap_or_else(|| right_handed(rest.eigen().vectors));
        let values = vectors.map(|vector| dot(&vector, &rest.apply(vector)));
        let largest = values.iter().fold(0.0, |max: f64, value| max.max(value.abs()));
        let mut fine = Self {
            values: values.map(Triple::from),
            vectors: vectors.map(|vector| vector.map(Triple::from)),
        };
        let mut size = fine.refine::<true>(&rest, NEGLIGIBLE * largest);
        for _round in 0..MOST_ROUNDS {
            if size <= LAST {
                break;
            }
            size = fine.refine::<false>(&rest, NEGLIGIBLE * largest);
        }
        Self { values: fine.values.map(|value| value.plus(shift)), ..fine }
    }

    /// Performs one round and returns the size of its correction. `ONE_WORD` is true if all numbers
    /// have f64 precision.
    fn refine<const ONE_WORD: bool>(&mut self, matrix: &Symmetric3, negligible: f64) -> f64 {
        let halved = self.vectors.map(|vector| vector.map(Halved::of));
        let rows = matrix.rows().map(|row| row.map(with_halves));
        let one = self.vectors.map(|vector| vector.map(Triple::value));
        // Residuals rⱼ.
        let residuals = [0, 1, 2].map(|j| {
            let value = Halved::of(-self.values[j]);
            [0, 1, 2].map(|k| {
                let mut sum = Remainder::default();
                for (element, component) in rows[k].iter().zip(&halved[j]) {
                    sum.add_product_with_word::<ONE_WORD>(*element, component);
                }
                sum.add_product::<ONE_WORD>(&value, &halved[j][k]);
                sum.value()
            })
        });
        let defect = |i: usize, j: usize| {
            let mut sum = Remainder([if i == j { -1.0 } else { 0.0 }, 0.0, 0.0]);
            for (a, b) in halved[i].iter().zip(&halved[j]) {
                sum.add_product::<ONE_WORD>(a, b);
            }
            -sum.value()
        };
        for (value, (vector, residual)) in self.values.iter_mut().zip(one.iter().zip(&residuals)) {
            *value = value.plus(dot(vector, residual));
        }
        let mut size: f64 = 0.0;
        let mut corrections = [[0.0; 3]; 3];
        for (j, row) in corrections.iter_mut().enumerate() {
            row[j] = 0.5 * defect(j, j);
            size = size.max(row[j].abs());
        }
        for [i, j] in PAIRS {
            let off = 0.5 * (dot(&one[i], &residuals[j]) + dot(&one[j], &residuals[i]));
            let gap = (self.values[j] - self.values[i]).value();
            let mut turn = off / gap;
            if off.abs() <= negligible {
                // For equal values, rounding would continue to rotate the vectors.
                turn = if turn.abs() <= LAST { turn } else { 0.0 };
            } else if !(turn.abs() <= SMALL) {
                self.turn([i, j], off, gap);
                return 1.0;
            }
            let half = 0.5 * defect(i, j);
            (corrections[i][j], corrections[j][i]) = (half + turn, half - turn);
            size = size.max(half.abs()).max(turn.abs());
        }
        for (j, vector) in self.vectors.iter_mut().enumerate() {
            for (k, component) in vector.iter_mut().enumerate() {
                let by = [0, 1, 2].map(|i| one[i][k] * corrections[i][j]);
                *component = component.plus((by[0] + by[1]) + by[2]);
            }
        }
        size
    }

    /// Rotates vectors i and j in their plane so that vᵢ·S vⱼ changes from `off` to zero, in f64
    /// precision (Golub & Van Loan, §8.5).
    #[cold]
    fn turn(&mut self, [i, j]: [usize; 2], off: f64, gap: f64) {
        let zeta = gap / (2.0 * off);
        let t = 1.0_f64.copysign(zeta) / (zeta.abs() + libm::hypot(1.0, zeta));
        let c = 1.0 / (1.0 + t * t).sqrt();
        let s = t * c;
        let (vi, vj) = (self.vectors[i], self.vectors[j]);
        self.vectors[i] = [0, 1, 2].map(|k| vi[k].times(c) - vj[k].times(s));
        self.vectors[j] = [0, 1, 2].map(|k| vi[k].times(s) + vj[k].times(c));
        self.values[i] = self.values[i].plus(-t * off);
        self.values[j] = self.values[j].plus(t * off);
    }
}

/// Returns the matrix minus a multiple of the identity, and the multiple: an element of its
/// diagonal, or zero if the differences are not exact.
fn shifted(matrix: &Symmetric3) -> (Symmetric3, f64) {
    let shift = matrix.xx;
    let (yy, lost_of_yy) = two_sum(matrix.yy, -shift);
    let (zz, lost_of_zz) = two_sum(matrix.zz, -shift);
    if lost_of_yy == 0.0 && lost_of_zz == 0.0 {
        (Symmetric3 { xx: 0.0, yy, zz, ..*matrix }, shift)
    } else {
        (*matrix, 0.0)
    }
}

/// Returns the same vectors, with the third one reversed if they are left-handed.
fn right_handed([a, b, c]: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let across = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    [a, b, if dot(&across, &c) < 0.0 { c.map(|c| -c) } else { c }]
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]
}

/// Triple-double number; its first two words are stored with their halves.
#[derive(Clone, Copy, Default)]
struct Halved {
    first: [f64; 3],
    second: [f64; 3],
    third: f64,
}

impl Halved {
    #[inline(always)]
    fn of(Triple([first, second, third]): Triple) -> Self {
        Self { first: with_halves(first), second: with_halves(second), third }
    }
}

/// Remainder of a sum of products that cancel: exact except for terms below the third word of the
/// largest.
#[derive(Clone, Copy, Default)]
struct Remainder([f64; 3]);

impl Remainder {
    #[inline(always)]
    fn add_product_with_word<const ONE_WORD: bool>(&mut self, a: [f64; 3], b: &Halved) {
        let (high, error) = two_product_of_halves(a, b.first);
        self.add(high);
        self.add_second(error);
        if ONE_WORD {
            return;
        }
        let (middle, low) = two_product_of_halves(a, b.second);
        self.add_second(middle);
        self.0[2] += low + a[0] * b.third;
    }

    #[inline(always)]
    fn add_product<const ONE_WORD: bool>(&mut self, a: &Halved, b: &Halved) {
        self.add_product_with_word::<ONE_WORD>(a.first, b);
        if ONE_WORD {
            return;
        }
        let (middle, low) = two_product_of_halves(a.second, b.first);
        self.add_second(middle);
        self.0[2] += low + (a.second[0] * b.second[0] + a.third * b.first[0]);
    }

    #[inline(always)]
    fn add(&mut self, word: f64) {
        let (sum, error) = two_sum(self.0[0], word);
        self.0[0] = sum;
        self.add_second(error);
    }

    #[inline(always)]
    fn add_second(&mut self, word: f64) {
        let (sum, error) = two_sum(self.0[1], word);
        self.0[1] = sum;
        self.0[2] += error;
    }

    #[inline(always)]
    fn value(self) -> f64 {
        let (high, low) = two_sum(self.0[0], self.0[1]);
        high + (low + self.0[2])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triple_dot(a: &[Triple; 3], b: &[Triple; 3]) -> Triple {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    /// Returns the largest of |vᵢ·S vⱼ| relative to the shifted matrix, of |vᵢ·S vᵢ − λᵢ| relative
    /// to the matrix, and of |vᵢ·vⱼ − δᵢⱼ|.
    fn errors(matrix: &Symmetric3, fine: &FineEigen) -> [f64; 3] {
        let (rest, shift) = shifted(matrix);
        let rows = rest.rows().map(|row| row.map(Triple::from));
        let mut worst = [0.0_f64; 3];
        for i in 0..3 {
            for j in 0..3 {
                let image = rows.map(|row| triple_dot(&row, &fine.vectors[j]));
                let element = triple_dot(&fine.vectors[i], &image);
                let unit = if i == j { -1.0 } else { 0.0 };
                let defect = triple_dot(&fine.vectors[i], &fine.vectors[j]).plus(unit).value().abs();
                worst[2] = worst[2].max(defect);
                if i == j {
                    let error = (element.plus(shift) - fine.values[j]).value().abs();
                    worst[1] = worst[1].max(error / matrix.max_abs());
                } else {
                    worst[0] = worst[0].max(element.value().abs() / rest.max_abs());
                }
            }
        }
        worst
    }

    /// Returns diag(a, b, c) rotated by a matrix with rational elements, rounded.
    fn turned(moments: [f64; 3]) -> Symmetric3 {
        let r = [[1.0, 2.0, 2.0], [2.0, 1.0, -2.0], [-2.0, 2.0, -1.0]];
        Symmetric3::diagonal(moments).rotated(&r)
    }

    #[test]
    fn values_and_vectors_have_46_digits_however_near_they_are() {
        let ulp = f64::EPSILON;
        for matrix in [
            turned([1.0, 2.0, 2.75]),
            turned([1.3, 1.3 + 1e-9, 2.1]),
            turned([1.3, 1.3 + 1e-15, 2.1]),
            turned([1.1, 2.1, 2.1]),
            turned([2.0, 2.0, 3.0]),
            Symmetric3 { xy: 1.0, ..turned([2.0; 3]) },
            turned([1.0, 1.0 + 3.0 * ulp, 1.0 + 7.0 * ulp]),
            turned([1.0, 1e-9, 1e-16]),
            turned([0.0, 1.0, 1.0]),
            turned([-1.0, 1e-3, 1.0]),
            Symmetric3 { xy: ulp, ..turned([2.0, 2.0, 3.0]) },
            Symmetric3 { xy: 0.5, ..Symmetric3::diagonal([1.0, 1.0, 1.5]) },
            Symmetric3 { xz: 1e-300, ..Symmetric3::diagonal([1.0, 1.0, 1.5]) },
            Symmetric3 { xz: 1e-20, yz: -1e-25, ..Symmetric3::diagonal([1.0, 2.0, 3.0]) },
        ] {
            let eigen = matrix.eigen();
            let searched = FineEigen::of(&matrix, None);
            let known = FineEigen::of(&matrix, Some(right_handed(eigen.polished(&matrix).vectors)));
            for fine in [searched, known] {
                let worst = errors(&matrix, &fine);
                assert!(worst.iter().all(|error| *error < 1e-46), "{matrix:?}: {worst:?}");
                let [a, b, c] = fine.vectors.map(|v| v.map(Triple::value));
                assert_eq!(right_handed([a, b, c]), [a, b, c], "{matrix:?}");
            }
        }
    }

    #[test]
    fn an_axis_of_the_frame_stays_exact() {
        let needle = Symmetric3 { xx: 1.25, yy: 1.75, zz: 1e-60, xy: 0.25, ..Symmetric3::default() };
        let FineEigen { values: [least, ..], vectors: [axis, ..] } = FineEigen::of(&needle, None);
        assert_eq!(least, Triple::from(1e-60));
        assert_eq!(axis, [0.0, 0.0, 1.0].map(Triple::from));
    }
}
