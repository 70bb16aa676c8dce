//! Graph of the error against time.

use polhode_document::graph::Graph;

use super::JudgedRun;

/// Maximum number of points; each is the largest error of its time interval.
const POINTS: usize = 240;

/// Returns log₁₀ of the attitude error, rad, against time; `None` if too few errors are above zero.
pub(crate) fn of_error(run: &JudgedRun) -> Option<Graph> {
    let judgement = &run.judgement;
    let (times, angles) = (&judgement.motion.times, judgement.errors.angles());
    let floor = judgement.floor();
    let rows = times.len();
    let each = rows.div_ceil(POINTS).max(1);
    let points: Vec<[f64; 2]> = (times.chunks(each).zip(angles.chunks(each)))
        .filter_map(|(times, angles)| {
            let largest = angles.iter().copied().fold(0.0, f64::max);
            (largest > 0.0).then(|| [times[times.len() / 2], largest.max(0.1 * floor).log10()])
        })
        .collect();
    let (first, last) = (*points.first()?, *points.last()?);
    (points.len() > 2).then(|| Graph {
        title: format!("Attitude error: {}", run.name),
        across: ["t", "s"],
        up: ["log₁₀ of the error", "rad"],
        level: ([first[0], last[0], floor.log10()], "estimated error of the exact motion"),
        points,
    })
}
