//! Graph of the error against time.

use polhode_document::graph::Graph;

use super::JudgedRun;

/// Maximum number of points; each is the largest error of its time interval.
const POINTS: usize = 240;

/// Returns log₁₀ of the attitude error of a run, rad, against time; `None` if too few errors are
/// above zero.
pub(crate) fn of_error(run: &JudgedRun) -> Option<Graph> {
    let judgement = &run.judgement;
    let level = (judgement.floor(), "estimated error of the exact motion");
    let title = format!("Attitude error: {}", run.name);
    of_angles(title, &judgement.motion.times, &judgement.errors.angles(), "log₁₀ of the error", level)
}

/// Returns log₁₀ of angles, rad, against time, with a level and its name; `None` if too few angles
/// are above zero.
pub(crate) fn of_angles(
    title: String,
    times: &[f64],
    angles: &[f64],
    up: &'static str,
    (floor, level): (f64, &'static str),
) -> Option<Graph> {
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
        title,
        across: ["t", "s"],
        up: [up, "rad"],
        level: ([first[0], last[0], floor.log10()], level),
        points,
    })
}
