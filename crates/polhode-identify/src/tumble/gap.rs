//! Holes in a log.

/// How many times as long as usual no reading is a gap.
const GAP: f64 = 3.0;

/// Where times are further apart than usual.
pub(super) fn gaps(times: &[f64]) -> impl Iterator<Item = [f64; 2]> + '_ {
    let longest = GAP * usual_step(times);
    times.windows(2).filter(move |two| two[1] - two[0] > longest).map(|two| [two[0], two[1]])
}

/// The median of what is between two times; infinite of fewer than two.
pub(super) fn usual_step(times: &[f64]) -> f64 {
    let mut steps: Vec<f64> = times.windows(2).map(|two| two[1] - two[0]).collect();
    let middle = steps.len() / 2;
    if steps.is_empty() {
        return f64::INFINITY;
    }
    *steps.select_nth_unstable_by(middle, f64::total_cmp).1
}
