//! Order of accuracy of a method, from its runs with several step sizes.

/// Errors of runs of one motion by one method, with several step sizes.
#[derive(Clone, Debug, PartialEq)]
pub struct AccuracyOrder {
    /// Time at which the errors are compared, s.
    pub time: f64,
    /// Step size, s, and largest attitude error up to that time, rad, in order of decreasing step
    /// size.
    pub runs: Vec<(f64, f64)>,
    /// Order p of error ∝ step^p between each run and the next; `None` if one of the errors does
    /// not exceed the uncertainty of the exact motion.
    pub orders: Vec<Option<f64>>,
}

/// Errors of a run with one step size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepErrors<'a> {
    /// Step size of the method, s.
    pub step: f64,
    /// Times of the rows, s.
    pub times: &'a [f64],
    /// Attitude errors at these times, rad.
    pub errors: &'a [f64],
    /// Uncertainty of the exact motion, rad; smaller errors are not significant.
    pub floor: f64,
}

/// Largest error for which an order is computed, rad.
const LARGE: f64 = 0.5;

impl AccuracyOrder {
    /// Computes the order from runs with at least two different step sizes; `None` otherwise.
    /// Errors are compared up to the last time at which all of them are less than 0.5 rad.
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
