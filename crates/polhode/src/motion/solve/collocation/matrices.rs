//! Matrices that integrate, analyse and extrapolate functions from their values at the nodes of a
//! step.

use std::sync::OnceLock;

use super::nodes::Nodes;
use super::system::ROOM;
use crate::math::machine::Machine;
use crate::math::number::Number as _;

/// Number of nodes of a step.
pub(super) const NODES: usize = 16;
pub(super) const HALF: usize = NODES / 2;

/// Values at the nodes of the second half of the step, outwards from the middle, and at their
/// mirror images.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Values(pub(super) [[f64; HALF]; 2]);

impl Values {
    pub(super) const NONE: Self = Self([[0.0; HALF]; 2]);

    /// Reorders values that are given in the order of the nodes.
    fn mirrored(values: &[f64; NODES]) -> Self {
        Self([core::array::from_fn(|k| values[HALF + k]), core::array::from_fn(|k| values[HALF - 1 - k])])
    }
}

#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Column([f64; HALF]);

/// Matrices that integrate and analyse values.
///
/// A function is split into parts that are even and odd about the middle of the step. So are its
/// integrals and its polynomials, and half of each matrix is zero.
#[derive(Debug)]
struct Matrices {
    at: Values,
    /// Integrals of even functions from the start to the nodes after the middle, and to those
    /// before it. They apply to the sums of mirrored values.
    even: [[Column; HALF]; 2],
    /// Integrals of odd functions from the start. They apply to the differences of mirrored values
    /// and are equal at mirrored nodes.
    odd: [Column; HALF],
    /// Legendre coefficients 0, 2, 4 … from the sums, and 1, 3, 5 … from the differences.
    analysis: [[Column; HALF]; 2],
}

impl Matrices {
    fn get() -> &'static Self {
        static MATRICES: OnceLock<Matrices> = OnceLock::new();
        MATRICES.get_or_init(Self::new)
    }

    fn new() -> Self {
        let nodes = Nodes::<NODES>::new();
        let integral = |node: usize, j: usize, sign: f64| {
            0.5 * (nodes.integrals[node][HALF + j] + sign * nodes.integrals[node][HALF - 1 - j])
        };
        let columns = |element: &dyn Fn(usize, usize) -> f64| {
            core::array::from_fn(|j| Column(core::array::from_fn(|i| element(i, j))))
        };
        Self {
            at: Values::mirrored(&nodes.at),
            even: [
                columns(&|i, j| integral(HALF + i, j, 1.0)),
                columns(&|i, j| integral(HALF - 1 - i, j, 1.0)),
            ],
            odd: columns(&|i, j| integral(HALF + i, j, -1.0)),
            analysis: [0, 1].map(|parity| columns(&|n, j| nodes.analysis(2 * n + parity)[HALF + j])),
        }
    }
}

/// Returns the sums and the differences of mirrored values. They are stored in memory so that a
/// multiplication can broadcast them to a vector.
#[inline(always)]
pub(super) fn by_parity<S: Machine>(s: S, f: &Values) -> Values {
    let (after, before) = (s.load_eight(&f.0[0]), s.load_eight(&f.0[1]));
    Values([s.eight_numbers(after + before), s.eight_numbers(after - before)])
}

/// Computes y = start + h ∫ f for the variables in `places`.
#[inline(always)]
pub(super) fn integrate<S: Machine>(
    s: S,
    f: &[Values; ROOM],
    [y, parities]: [&mut [Values; ROOM]; 2],
    start: &[f64; ROOM],
    places: &[usize],
    h: f64,
) {
    for &k in places {
        parities[k] = by_parity(s, &f[k]);
    }
    let Matrices { even, odd, .. } = Matrices::get();
    let zero = s.eight(0.0);
    let mut columns = [[zero; HALF]; 3];
    for (registers, columns) in columns.iter_mut().zip([&even[0], &even[1], odd]) {
        for (register, column) in registers.iter_mut().zip(columns) {
            *register = s.load_eight(&column.0);
        }
    }
    let h = s.eight(h);
    for &k in places {
        let [sums, differences] = &parities[k].0;
        let (mut after, mut before, mut of_odd) = (zero, zero, zero);
        for j in 0..HALF {
            after = s.eight(sums[j]).mul_add(columns[0][j], after);
            before = s.eight(sums[j]).mul_add(columns[1][j], before);
            of_odd = s.eight(differences[j]).mul_add(columns[2][j], of_odd);
        }
        let start = s.eight(start[k]);
        let (after, before) = ((after + of_odd).mul_add(h, start), (before + of_odd).mul_add(h, start));
        y[k] = Values([s.eight_numbers(after), s.eight_numbers(before)]);
    }
}

/// Returns the coefficients of Pₙ(2x − 1) of a function, from the sums and differences of its
/// mirrored values.
#[inline(always)]
pub(super) fn coefficients<S: Machine>(s: S, parities: &Values) -> [f64; NODES] {
    let [by_sum, by_difference] = &Matrices::get().analysis;
    let [sums, differences] = &parities.0;
    let (mut even, mut odd) = (s.eight(0.0), s.eight(0.0));
    for j in 0..HALF {
        even = s.eight(sums[j]).mul_add(s.load_eight(&by_sum[j].0), even);
        odd = s.eight(differences[j]).mul_add(s.load_eight(&by_difference[j].0), odd);
    }
    let (even, odd) = (s.eight_numbers(even), s.eight_numbers(odd));
    let mut coefficients = [0.0; NODES];
    for (pair, (even, odd)) in coefficients.as_chunks_mut().0.iter_mut().zip(even.iter().zip(odd)) {
        *pair = [*even, odd];
    }
    coefficients
}

/// Evaluates the rate polynomials of a step of length `length` at the nodes of a step of length h.
/// The latter begins at the time `since` after the start of the former.
#[inline(always)]
pub(super) fn extrapolate<S: Machine>(
    s: S,
    rates: &[[f64; NODES]; ROOM],
    length: f64,
    f: &mut [Values; ROOM],
    parts: [&[usize]; 2],
    [since, h]: [f64; 2],
) {
    for half in 0..2 {
        let nodes = s.load_eight(&Matrices::get().at.0[half]);
        let x = nodes.mul_add(s.eight(2.0 * h / length), s.eight(2.0 * since / length - 1.0));
        let mut p = [s.eight(1.0); NODES];
        p[1] = x;
        for n in 1..NODES - 1 {
            let m = n as f64;
            let (ahead, back) = (s.eight((2.0 * m + 1.0) / (m + 1.0)), s.eight(-m / (m + 1.0)));
            p[n + 1] = (x * ahead).mul_add(p[n], p[n - 1] * back);
        }
        for &k in parts.into_iter().flatten() {
            let mut sum = s.eight(0.0);
            for (c, p) in rates[k].iter().zip(&p) {
                sum = s.eight(*c).mul_add(*p, sum);
            }
            f[k].0[half] = s.eight_numbers(sum);
        }
    }
}
