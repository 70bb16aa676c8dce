//! Trials of causes, one by one.

use super::follow::follow;
use super::found::TriedCause;
use super::law::Law;
use super::name::Cause;
use super::rows::{Misfit, Rows, Window, rotation_vector};
use crate::motion::model::state::State;

/// Largest remaining fraction of the error of a cause that explains it; the second value applies if
/// numbers were fitted or the step size was estimated.
const BAR: [f64; 2] = [0.1, 0.03];

/// Weight of the residual for a cause with one fitted number, and with several.
const FITTED: [f64; 2] = [3.0, 30.0];

/// Fraction of the error below which residuals do not distinguish causes.
const ALIKE: f64 = 1e-6;

/// Remaining fraction of the error above which a motion is not computed to its end.
const HOPELESS: f64 = 0.3;

/// Smallest fraction of the error that the first linear step must explain; otherwise no number is
/// fitted.
const LITTLE: f64 = 0.3;

/// Maximum number of extrapolation steps for one motion.
const MOST: usize = 20_000;

/// Run, correct law, and results of the trials.
#[derive(Debug)]
pub(super) struct Trials<'a> {
    pub(super) window: Window<'a>,
    pub(super) rows: Rows,
    pub(super) law: Law<'a>,
    pub(super) start: State,
    pub(super) tried: Vec<TriedCause>,
}

impl Trials<'_> {
    /// Returns the motion of a law over the rows.
    pub(super) fn motion(&self, law: &Law<'_>) -> Vec<State> {
        follow(law, self.start, &self.rows.times, MOST, |_| true)
    }

    /// Returns the motion of a law, up to the row at which it is certain not to explain the run.
    fn motion_of_use(&self, law: &Law<'_>) -> Vec<State> {
        let base = self.rows.base(usize::MAX).attitude;
        let most = (HOPELESS * base).powi(2) * self.rows.times.len() as f64;
        let (mut sum, mut rows) = (0.0, self.rows.run.iter());
        follow(law, self.start, &self.rows.times, MOST, |state| {
            sum += rows.next().map_or(0.0, |run| run.angle_to(state.attitude).powi(2));
            sum <= most
        })
    }

    /// Compares the motion of a law with the run.
    pub(super) fn try_law(&mut self, cause: Cause, law: &Law<'_>) {
        let states = self.motion_of_use(law);
        let (left, base) = (self.rows.misfit(&states), self.rows.base(states.len()));
        let is_whole = states.len() == self.rows.times.len();
        let mut tried = judged(cause, left, base, false);
        tried.passes &= is_whole;
        self.tried.push(tried);
    }

    /// Compares states at the rows with the run.
    pub(super) fn try_states(&mut self, cause: Cause, states: &[State]) {
        let judged = judged(cause, self.rows.misfit(states), self.rows.base(states.len()), false);
        // A motion that cannot be computed for half of the rows is not significant.
        if 2 * states.len() > self.rows.times.len() {
            self.tried.push(judged);
        }
    }

    /// Tries several causes of one kind, each with its law, and keeps the best.
    pub(super) fn try_best_law<'l>(&mut self, laws: impl IntoIterator<Item = (Cause, Law<'l>)>) {
        let count = self.tried.len();
        for (cause, law) in laws {
            self.try_law(cause, &law);
        }
        let best = self.tried.drain(count..).min_by(|a, b| a.score.total_cmp(&b.score));
        self.tried.extend(best);
    }

    /// Returns the time from the start to the last row, s.
    pub(super) fn duration(&self) -> f64 {
        self.rows.times.last().map_or(1.0, |end| end - self.start.time)
    }
}

/// Fits a number such that the states, as a function of it, are as close to the run as possible, by
/// the Gauss–Newton method from zero.
pub(super) fn fitted(rows: &Rows, scale: f64, states: impl Fn(f64) -> Vec<State>) -> Option<f64> {
    const ROUNDS: usize = 6;
    let (mut number, mut difference) = (0.0, scale);
    for round in 0..ROUNDS {
        let here = rows.differences(&states(number));
        let there = rows.differences(&states(number + difference));
        let (mut across, mut square, mut whole) = (0.0, 0.0, 0.0);
        for (a, b) in here.iter().zip(&there) {
            let slope = (b - a) / difference;
            across += a * slope;
            square += slope * slope;
            whole += a * a;
        }
        let step = -across / square;
        let left = 1.0 - across * across / (square * whole);
        if !step.is_finite() || (round == 0 && left > (1.0 - LITTLE).powi(2)) {
            return None;
        }
        number += step;
        if step.abs() < 1e-5 * number.abs() {
            break;
        }
        difference = (1e-2 * step).abs().max(1e-3 * scale);
    }
    Some(number)
}

/// Returns a cause with the quality of its explanation.
pub(super) fn judged(cause: Cause, left: Misfit, base: Misfit, is_found: bool) -> TriedCause {
    let ratio = left.size() / base.size();
    let weight = match cause.fitted() {
        0 => 1.0,
        1 => FITTED[0],
        _ => FITTED[1],
    };
    let bar = BAR[usize::from(is_found || cause.fitted() > 0)];
    let keeps_omega = left.omega <= 1.5 * base.omega + 0.1 * base.attitude;
    let residual = left.attitude;
    let part = residual / base.attitude;
    TriedCause {
        cause,
        residual,
        error: base.attitude,
        explained: 1.0 - part,
        is_named: false,
        score: if ratio.is_nan() { f64::INFINITY } else { (ratio + ALIKE) * weight },
        passes: part <= bar && keeps_omega,
    }
}

/// Returns the factor by which the difference between the states and the exact states must be
/// multiplied to be closest to the run, and the remaining fraction of the error.
pub(super) fn scale(rows: &Rows, states: &[State]) -> (f64, f64) {
    let run = rows.differences(&rows.exact[..states.len().min(rows.exact.len())]);
    let (mut across, mut square, mut whole) = (0.0, 0.0, 0.0);
    for ((state, exact), run) in states.iter().zip(&rows.exact).zip(run.chunks_exact(3)) {
        let way = rotation_vector(exact.attitude, state.attitude).to_array();
        for (a, b) in way.iter().zip(run) {
            across += a * b;
            square += a * a;
            whole += b * b;
        }
    }
    let times = across / square;
    (times, (1.0 - times * across / whole).max(0.0).sqrt())
}
