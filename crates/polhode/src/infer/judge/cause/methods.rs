//! Methods with fixed steps, with the declared step size or an estimated one.

use super::law::Law;
use super::name::Cause;
use super::scheme::Scheme;
use super::trial::{Trials, fitted, judged, scale};

/// Maximum number of steps of one method.
const MOST: f64 = 4_000.0;

/// Maximum number of steps between two rows.
const MOST_BETWEEN_ROWS: f64 = 200_000.0;

/// Rotation angle of the body over which a step size is estimated, rad.
const LOOK: f64 = 20.0;

/// Rotation angle of the first step size that is tried, rad.
const ANGLE: f64 = 0.05;

/// Largest remaining fraction of the error, with the best scale, for which a method is tried again.
const HOPELESS: f64 = 0.5;

impl Trials<'_> {
    /// Tries all methods: with the declared step size, or, if that explains nothing, with the row
    /// spacing divided into 1, 2, 3 … parts.
    pub(super) fn try_methods(&mut self, declared: Option<f64>) {
        let count = self.tried.len();
        let declared = declared.filter(|h| h.is_finite() && *h > 0.0);
        if let Some(step) = declared {
            for scheme in self.schemes() {
                self.try_method(scheme, step, false);
            }
        }
        if self.tried[count..].iter().any(|tried| tried.passes) {
            return;
        }
        for scheme in self.schemes() {
            if let Some(step) = self.step_of(scheme) {
                self.try_method(scheme, step, true);
            }
        }
    }

    /// Tries the methods of engines with damped ω, if nothing simpler explains the run.
    pub(super) fn try_damped_methods(&mut self, declared: Option<f64>) {
        if self.tried.iter().any(|tried| tried.passes) {
            return;
        }
        let step = declared.filter(|h| h.is_finite() && *h > 0.0).unwrap_or(self.rows.spacing);
        let look = (LOOK / self.rows.rate).min(MOST / 4.0 * step);
        let rows = self.window.rows_until(self.start.time + look);
        for scheme in Scheme::ENGINES {
            let damped = |rate: f64| {
                let law = Law { damping: rate, ..self.law.clone() };
                scheme.follow(&law, self.start, &rows.times, step)
            };
            let least = 1e-3 / self.duration();
            let Some(rate) = fitted(&rows, least, damped).filter(|rate| *rate > least) else { continue };
            let (left, base) = (rows.misfit(&damped(rate)), rows.base(usize::MAX));
            self.tried.push(judged(Cause::MethodWithDamping { scheme, step, rate }, left, base, true));
        }
    }

    /// Returns all methods that differ for this law; without a torque, L is the same before and
    /// after a step.
    fn schemes(&self) -> impl Iterator<Item = Scheme> + use<> {
        let is_free = self.law.torque_count() == 0 && !self.law.has_wheels();
        Scheme::ALL.into_iter().filter(move |scheme| !(is_free && matches!(scheme, Scheme::MomentumLast(_))))
    }

    fn try_method(&mut self, scheme: Scheme, step: f64, is_found: bool) {
        if self.rows.spacing / step > MOST_BETWEEN_ROWS {
            return;
        }
        let rows = self.window.rows_until(self.start.time + MOST * step);
        let states = scheme.follow(&self.law, self.start, &rows.times, step);
        if 2 * states.len() > rows.times.len() {
            let (left, base) = (rows.misfit(&states), rows.base(states.len()));
            self.tried.push(judged(Cause::Method { scheme, step }, left, base, is_found));
        }
    }

    /// Returns the step size with which a method is closest to the run; its error is proportional
    /// to a power of the step size.
    fn step_of(&self, scheme: Scheme) -> Option<f64> {
        const ROUNDS: usize = 4;
        const NEIGHBOURS: f64 = 12.0;
        let spacing = self.rows.spacing;
        let look = (LOOK / self.rows.rate).min(MOST * spacing);
        let rows = self.window.rows_until(self.start.time + look);
        let span = rows.times.last()? - self.start.time;
        let at = |parts: f64| scheme.follow(&self.law, self.start, &rows.times, spacing / parts);
        let mut parts = (spacing * self.rows.rate / ANGLE).ceil().max(1.0);
        let mut best = (f64::INFINITY, parts);
        for _ in 0..ROUNDS {
            let states = at(parts);
            best = better(best, (rows.misfit(&states).size(), parts));
            let (times, left) = scale(&rows, &states);
            if !(times > 0.0) || left > HOPELESS {
                break;
            }
            let next = (parts * times.powf(-1.0 / f64::from(scheme.order()))).round().max(1.0);
            if next == parts || !is_short(span, spacing / next) {
                break;
            }
            parts = next;
        }
        if best.1 <= NEIGHBOURS && best.0 < HOPELESS * rows.base(usize::MAX).size() {
            for next in [best.1 - 1.0, best.1 + 1.0] {
                if next >= 1.0 {
                    best = better(best, (rows.misfit(&at(next)).size(), next));
                }
            }
        }
        Some(spacing / best.1)
    }
}

fn is_short(span: f64, step: f64) -> bool {
    span / step < 5.0 * MOST
}

fn better(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    if b.0 < a.0 { b } else { a }
}
