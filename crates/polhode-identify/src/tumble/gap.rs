//! Gaps in a log.

/// Shortest gap, in units of the usual time step.
const GAP: f64 = 3.0;

/// Returns the times before and after each gap.
pub(super) fn gaps(times: &[f64]) -> impl Iterator<Item = [f64; 2]> + '_ {
    let longest = GAP * usual_step(times);
    times.windows(2).filter(move |two| two[1] - two[0] > longest).map(|two| [two[0], two[1]])
}

/// Returns the median time step; infinite for fewer than two times.
pub(super) fn usual_step(times: &[f64]) -> f64 {
    let mut steps: Vec<f64> = times.windows(2).map(|two| two[1] - two[0]).collect();
    let middle = steps.len() / 2;
    if steps.is_empty() {
        return f64::INFINITY;
    }
    *steps.select_nth_unstable_by(middle, f64::total_cmp).1
}
