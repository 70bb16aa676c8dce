//! The order of accuracy of a method, by its runs of several steps.

/// The errors of runs of one motion by one method, with several steps.
#[derive(Clone, Debug, PartialEq)]
pub struct AccuracyOrder {
    /// The time at which they are compared, s.
    pub time: f64,
    /// Step (s) and largest attitude error up to that time (rad), from the largest step on.
    pub runs: Vec<(f64, f64)>,
    /// p of error ∝ step^p, between each run and the next; `None` where one of the errors is not above what the exact motion may be wrong by.
    pub orders: Vec<Option<f64>>,
}

/// A run of one step: the step, s, its times, s, its attitude errors, rad, and what the exact motion may be wrong by, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepErrors<'a> {
    /// Of the method, s.
    pub step: f64,
    /// When, s.
    pub times: &'a [f64],
    /// How far off, rad.
    pub errors: &'a [f64],
    /// What they cannot tell from 0, rad.
    pub floor: f64,
}

/// Errors above it have no order, rad.
const LARGE: f64 = 0.5;

impl AccuracyOrder {
    /// Of runs with at least two different steps: compared to the last time up to which all of them are off by less than 0.5 rad.
    ///
    /// ```
    /// use polhode::infer::judge::{AccuracyOrder, StepErrors};
    /// let times = [0.0, 1.0, 2.0];
    /// let [coarse, fine] = [[0.0, 4e-4, 8e-4], [0.0, 1e-4, 2e-4]];
    /// let run = |step, errors| StepErrors { step, times: &times, errors, floor: 1e-14 };
    /// let order = AccuracyOrder::of(&[run(0.01, &coarse), run(0.005, &fine)]).ok_or("two steps")?;
    /// assert!((order.orders[0].ok_or("above the floor")? - 2.0).abs() < 1e-12);
    /// # Ok::<(), &str>(())
    /// ```
    pub fn of(runs: &[StepErrors<'_>]) -> Option<Self> {
        let mut runs = runs.to_vec();
        runs.sort_by(|a, b| b.step.total_cmp(&a.step));
        runs.dedup_by(|a, b| a.step == b.step);
        if runs.len() < 2 {
            return None;
        }
        let good_until = |run: &StepErrors<'_>| {
            let good = run.errors.iter().take_while(|&&error| error < LARGE).count();
            run.times.get(good.min(run.times.len()).saturating_sub(1)).copied()
        };
        let time = runs.iter().filter_map(good_until).fold(f64::INFINITY, f64::min);
        let largest = |run: &StepErrors<'_>| {
            let upto = run.times.iter().zip(run.errors).take_while(|(t, _)| **t <= time);
            upto.map(|(_, error)| *error).fold(0.0, f64::max)
        };
        let errors: Vec<(f64, f64)> = runs.iter().map(|run| (run.step, largest(run))).collect();
        let order = |k: usize| {
            let ((h0, e0), (h1, e1)) = (errors[k], errors[k + 1]);
            let is_above = e0 > 3.0 * runs[k].floor && e1 > 3.0 * runs[k + 1].floor;
            is_above.then(|| libm::log(e0 / e1) / libm::log(h0 / h1))
        };
        let orders = (0..errors.len() - 1).map(order).collect();
        Some(Self { time, runs: errors, orders })
    }
}
