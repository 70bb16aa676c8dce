//! Decomposition of a motion's error into components that its author can correct.

use super::difference::{conjugate, length, product, rotation_vector, to_body};
use super::motion::ReadMotion;
use super::reference::spread;
use crate::motion::model::state::State;

/// Decomposition of an error: each part is a motion that differs from the exact one in one respect.
///
/// θ of R = R_exact exp(θ), along body axes, is fitted by least squares with
///
/// θ = R_exactᵀ (σ + t δ) + β + (τ + t ρ) ω,
///
/// with t since the start, as long as |θ| ≤ 0.3 rad. The part that reduces the error most is fitted
/// first. A larger rotation of the first row is removed before.
#[derive(Clone, Debug, PartialEq)]
pub struct Split {
    /// Parts of the error, in the order of [`PartKind`].
    pub parts: Vec<SplitPart>,
    /// RMS of the residual that no part explains, rad.
    pub rest: f64,
    /// RMS of the random part of the residual, from row to row, rad.
    pub noise: f64,
    /// RMS of the whole error, rad.
    pub total: f64,
    /// End of the decomposition, s: up to this time the error is small enough.
    pub until: f64,
}

/// Part of an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplitPart {
    /// Kind of the part.
    pub kind: PartKind,
    /// Values of the part, in units of [`PartKind::unit`]; a scalar is the first value. `None` if
    /// the part does not reduce the error, or cannot be distinguished from larger parts in this
    /// run.
    pub value: Option<[f64; 3]>,
    /// RMS by which the part reduces the error that larger parts leave, rad; the squares of all
    /// parts and of the residual add up to that of the whole.
    pub attitude: f64,
}

/// Kinds of differences between a motion and the exact one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PartKind {
    /// Start σ: the initial attitude is rotated in space.
    Start,
    /// Body axes β: the axes in the body are rotated.
    BodyAxes,
    /// Clock τ: the clock is ahead.
    Clock,
    /// Rate ρ: the rotation is too fast.
    Rate,
    /// Drift δ: the attitude drifts slowly in space.
    Drift,
}

impl PartKind {
    /// All kinds of parts.
    pub const ALL: [Self; 5] = [Self::Start, Self::BodyAxes, Self::Clock, Self::Rate, Self::Drift];

    /// Returns the unit of its values.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Start | Self::BodyAxes => "rad",
            Self::Clock => "s",
            Self::Rate => "1",
            Self::Drift => "rad/s",
        }
    }

    /// Returns the number of its values.
    pub const fn count(self) -> usize {
        match self {
            Self::Start | Self::BodyAxes | Self::Drift => 3,
            Self::Clock | Self::Rate => 1,
        }
    }

    /// Returns θ for a unit of each of its values.
    fn shapes(self, state: &State, since: f64) -> Vec<[f64; 3]> {
        let space = |factor: f64| {
            let axis = |k: usize| to_body(state.attitude.quaternion(), unit(k)).map(|c| c * factor);
            vec![axis(0), axis(1), axis(2)]
        };
        let omega = state.omega.to_array();
        match self {
            Self::Start => space(1.0),
            Self::BodyAxes => vec![unit(0), unit(1), unit(2)],
            Self::Clock => vec![omega],
            Self::Rate => vec![omega.map(|c| c * since)],
            Self::Drift => space(since),
        }
    }
}

fn unit(k: usize) -> [f64; 3] {
    core::array::from_fn(|i| if i == k { 1.0 } else { 0.0 })
}

/// Largest |θ| that counts as a small rotation, rad.
const SMALL: f64 = 0.3;
/// Number of rows that determine the kind of a larger rotation of the first row.
const COMPARED: usize = 64;
/// Number of rows that are fitted.
const FITTED: usize = 4000;
/// Smallest remaining fraction of a part, after removing those before it, for which it is
/// distinguishable.
const DISTINCT: f64 = 0.02;
/// Smallest significance of a part: ratio of its sum of squares to the expectation by chance, and
/// to the sum of all squares.
const CHANCE: f64 = 9.0;
const LEAST: f64 = 1e-6;

impl Split {
    /// Decomposes the error of a motion, given the exact states at its times.
    pub fn of(motion: &ReadMotion, exact: &[State]) -> Self {
        let wrong = Taken::of(motion, exact);
        let theta = |row: usize| {
            rotation_vector(exact[row].attitude.quaternion(), wrong.without(motion.attitude[row]))
        };
        let rows = exact.len().min(motion.attitude.len());
        let small = (0..rows).take_while(|&row| length(theta(row)) <= SMALL).count();
        let picked = spread(small, FITTED);
        let picked: Vec<usize> = picked.into_iter().filter(|&row| row < small).collect();
        let began = exact.first().map_or(0.0, |state| state.time);
        let errors: Vec<f64> = picked.iter().flat_map(|&row| theta(row)).collect();

        let columns = |kind: PartKind| {
            let mut columns = vec![Vec::with_capacity(errors.len()); kind.count()];
            for &row in &picked {
                let shapes = kind.shapes(&exact[row], exact[row].time - began);
                columns.iter_mut().zip(shapes).for_each(|(column, shape)| column.extend(shape));
            }
            columns
        };
        let rms = |of: &[f64]| (of.iter().map(|c| c * c).sum::<f64>() / picked.len().max(1) as f64).sqrt();
        let (taken, fit, rest) = chosen(PartKind::ALL.map(|kind| (kind, columns(kind))).to_vec(), &errors);
        let values = fit.solve(&errors);
        let mut at = 0;
        let mut parts = PartKind::ALL.map(|kind| SplitPart { kind, value: None, attitude: 0.0 }).to_vec();
        for (kind, squares) in taken {
            let attitude = (squares / picked.len().max(1) as f64).sqrt();
            let mut value = [0.0; 3];
            value
                .iter_mut()
                .zip(&values[at..at + kind.count()])
                .for_each(|(slot, v)| *slot = v.unwrap_or(0.0));
            at += kind.count();
            let found = parts.iter_mut().filter(|part| part.kind == kind);
            found.for_each(|part| *part = SplitPart { kind, value: Some(value), attitude });
        }
        // Adds the rotation that was removed before the fit to the fitted value.
        if let Some((kind, turn)) = wrong.part() {
            for part in parts.iter_mut().filter(|part| part.kind == kind) {
                let value = part.value.unwrap_or_default();
                let sum = [turn[0] + value[0], turn[1] + value[1], turn[2] + value[2]];
                *part = SplitPart { value: Some(sum), attitude: length(sum), ..*part };
            }
        }
        let noise = noise(&rest).min(rms(&rest));
        let until = picked.last().map_or(began, |&row| exact[row].time);
        let total = rms(&errors).hypot(wrong.part().map_or(0.0, |(_, turn)| length(turn)));
        Self { parts, rest: rms(&rest), noise, total, until }
    }

    /// Returns the parts that contribute at least a tenth of the error, largest first.
    pub fn main_parts(&self) -> Vec<SplitPart> {
        let mut parts: Vec<SplitPart> =
            self.parts.iter().copied().filter(|part| part.attitude >= 0.1 * self.total).collect();
        parts.sort_by(|a, b| b.attitude.total_cmp(&a.attitude));
        parts
    }
}

/// Selects the parts in the order in which they reduce the remaining error most, as long as the
/// reduction exceeds chance. Returns the parts with the squares that each removes, the fit of all
/// of them, and its residual.
fn chosen(mut left: Vec<(PartKind, Vec<Vec<f64>>)>, errors: &[f64]) -> (Vec<(PartKind, f64)>, Fit, Vec<f64>) {
    let (mut taken, mut fit, mut rest) = (Vec::new(), Fit::default(), errors.to_vec());
    let with = |fit: &Fit, columns: &[Vec<f64>]| {
        let mut with = fit.clone();
        columns.iter().for_each(|column| with.take(column.clone()));
        (with.rest(errors), with)
    };
    while let Some((k, (after, next))) = (left.iter().enumerate())
        .map(|(k, (_, columns))| (k, with(&fit, columns)))
        .min_by(|a, b| dot(&a.1.0, &a.1.0).total_cmp(&dot(&b.1.0, &b.1.0)))
    {
        let (kind, _) = left.swap_remove(k);
        let (squares, remain) = (dot(&rest, &rest) - dot(&after, &after), dot(&after, &after));
        let by_chance = kind.count() as f64 * remain / errors.len().max(1) as f64;
        if squares <= CHANCE * by_chance || squares <= LEAST * dot(errors, errors) {
            break;
        }
        taken.push((kind, squares));
        (fit, rest) = (next, after);
    }
    (taken, fit, rest)
}

/// Large rotation of the first row, which is removed: in space, or of the axes in the body,
/// whichever fits the later rows.
#[derive(Clone, Copy)]
enum Taken {
    Nothing,
    /// S of R_read = S R_exact.
    Space([f64; 4]),
    /// B of R_read = R_exact B.
    Body([f64; 4]),
}

impl Taken {
    fn of(motion: &ReadMotion, exact: &[State]) -> Self {
        let (Some(&read), Some(first)) = (motion.attitude.first(), exact.first()) else {
            return Self::Nothing;
        };
        let first = first.attitude.quaternion();
        if length(rotation_vector(first, read)) <= SMALL {
            return Self::Nothing;
        }
        let (space, body) =
            (Self::Space(product(read, conjugate(first))), Self::Body(product(conjugate(first), read)));
        let rows = spread(exact.len().min(motion.attitude.len()), COMPARED);
        let off = |taken: Self| -> f64 {
            let angle = |&row: &usize| {
                length(rotation_vector(exact[row].attitude.quaternion(), taken.without(motion.attitude[row])))
            };
            rows.iter().map(angle).sum()
        };
        if off(body) < off(space) { body } else { space }
    }

    /// Returns an attitude after removal of the rotation.
    fn without(self, read: [f64; 4]) -> [f64; 4] {
        match self {
            Self::Nothing => read,
            Self::Space(turn) => product(conjugate(turn), read),
            Self::Body(turn) => product(read, conjugate(turn)),
        }
    }

    /// Returns the part of the error that it belongs to, and its rotation vector.
    fn part(self) -> Option<(PartKind, [f64; 3])> {
        let vector = |turn| rotation_vector([1.0, 0.0, 0.0, 0.0], turn);
        match self {
            Self::Nothing => None,
            Self::Space(turn) => Some((PartKind::Start, vector(turn))),
            Self::Body(turn) => Some((PartKind::BodyAxes, vector(turn))),
        }
    }
}

/// Returns the RMS of the random change from row to row. If `e_k` has the variance σ², e_(k−1) − 2
/// e_k + e_(k+1) has 6 σ² and fourth differences have 70 σ². A smooth error increases both
/// estimates, one less than the other; the smaller one is used.
fn noise(theta: &[f64]) -> f64 {
    let rows = theta.len() / 3;
    let rms = |binomial: &[f64], variance: f64| {
        let places = (rows + 1).saturating_sub(binomial.len());
        let difference = |k: usize, i: usize| {
            binomial.iter().enumerate().map(|(j, c)| c * theta[3 * (k + j) + i]).sum::<f64>()
        };
        let sum: f64 = (0..places).flat_map(|k| (0..3).map(move |i| difference(k, i).powi(2))).sum();
        if places == 0 { 0.0 } else { (sum / (variance * places as f64)).sqrt() }
    };
    rms(&[1.0, -2.0, 1.0], 6.0).min(rms(&[1.0, -4.0, 6.0, -4.0, 1.0], 70.0))
}

/// Least squares by Gram–Schmidt orthogonalisation, column by column; a column that is nearly a
/// combination of those before it is omitted.
#[derive(Clone, Default)]
struct Fit {
    orthonormal: Vec<Option<Vec<f64>>>,
    /// R of A = Q R: the components of each column along those before it, and its remainder.
    triangle: Vec<Vec<f64>>,
}

impl Fit {
    fn take(&mut self, column: Vec<f64>) {
        let (count, size) = (self.orthonormal.len(), dot(&column, &column).sqrt());
        let (mut left, mut along) = (column, vec![0.0; count + 1]);
        // Repeated, so that the remainder is orthogonal to full precision.
        for _ in 0..2 {
            for (k, q) in self.orthonormal.iter().enumerate() {
                let Some(q) = q else { continue };
                let part = dot(q, &left);
                along[k] += part;
                left.iter_mut().zip(q).for_each(|(c, q)| *c -= part * q);
            }
        }
        let rest = dot(&left, &left).sqrt();
        let is_distinct = rest > DISTINCT * size;
        self.orthonormal.push(is_distinct.then(|| left.iter().map(|c| c / rest).collect()));
        along[count] = rest;
        self.triangle.push(along);
    }

    /// Returns the residual of the errors after the fit.
    fn rest(&self, errors: &[f64]) -> Vec<f64> {
        let mut rest = errors.to_vec();
        for q in self.orthonormal.iter().flatten() {
            let along = dot(q, &rest);
            rest.iter_mut().zip(q).for_each(|(rest, q)| *rest -= along * q);
        }
        rest
    }

    /// Returns the coefficients of the columns; `None` for one that was omitted.
    fn solve(&self, errors: &[f64]) -> Vec<Option<f64>> {
        let mut values: Vec<Option<f64>> = vec![None; self.orthonormal.len()];
        for k in (0..self.orthonormal.len()).rev() {
            let Some(q) = &self.orthonormal[k] else { continue };
            let later: f64 =
                (k + 1..self.orthonormal.len()).map(|j| values[j].unwrap_or(0.0) * self.triangle[j][k]).sum();
            values[k] = Some((dot(q, errors) - later) / self.triangle[k][k]);
        }
        values
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
