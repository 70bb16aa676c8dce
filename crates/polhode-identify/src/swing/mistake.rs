//! Possible mistakes in a plan of swing tests, and their detectability by the residuals.

use super::measurement::{Counted, Measurement};
use super::plan::SwingPlan;
use super::problem::Swings;
use crate::error::IdentifyError;
use crate::least_squares::{Information, Problem, Response, Solution, response, rows_of};
use crate::residuals::ResidualTest;

/// Possible mistake, with its effect on the result and on the residuals.
#[derive(Clone, Debug, PartialEq)]
pub struct Mistake {
    /// Kind of the mistake.
    pub kind: MistakeKind,
    /// Index of the affected test in the plan; `None` for a number that tests share.
    pub test: Option<usize>,
    /// Shift of the body and the other shared parameters, in standard deviations of their joint
    /// distribution.
    pub shift: f64,
    /// Shift of the residuals, in standard deviations: the square root of the noncentrality of χ².
    pub left: f64,
    /// Shift of the residuals that on average makes them significantly larger than the noise.
    pub needed: f64,
}

/// Kind of a mistake; effects are of first order in the measurements.
#[derive(Clone, Debug, PartialEq)]
pub enum MistakeKind {
    /// Count off by one swing.
    Miscount,
    /// Amplitudes read from side to side, so twice too large.
    SideToSide,
    /// Length measured across, as a diameter, so twice too large.
    Twice {
        /// Name of the length in the plan.
        number: String,
    },
    /// All times too long by 1 %.
    Clock,
}

/// Relative error of all times.
const CLOCK: f64 = 0.01;

/// Threshold of a relevant shift, standard deviations.
const MATTERS: f64 = 1.0;

impl Mistake {
    /// Returns true if the mistake would shift the estimate noticeably.
    pub fn matters(&self) -> bool {
        self.shift >= MATTERS
    }

    /// Returns true if the residuals would reveal the mistake.
    pub fn shows(&self) -> bool {
        self.left >= self.needed
    }

    /// Returns true if the mistake would shift the estimate noticeably and remain undetected.
    pub fn is_hidden(&self) -> bool {
        self.matters() && !self.shows()
    }
}

/// Computes the effect of each possible mistake.
///
/// A change d of the measurements, in standard deviations, changes the residuals by (1 − H) d,
/// where H projects on the changes that the parameters can produce.
///
/// Source: Baarda, A testing procedure for use in geodetic networks, 1968 (internal reliability).
pub(super) fn mistakes(
    plan: &SwingPlan,
    swings: &Swings,
    solution: &Solution,
    found: &Information,
    test: &ResidualTest,
) -> Result<Vec<Mistake>, IdentifyError> {
    let needed = test.least_noncentrality().sqrt();
    let rows = (0..swings.groups())
        .map(|group| rows_of(swings, group, &solution.shared, &solution.place.local[group]))
        .collect::<Result<Vec<_>, _>>()?;
    let mistake = |kind, test, changes: &[(usize, Vec<f64>)]| {
        let Response { left, followed } = response(&rows, found, changes)?;
        Ok::<_, IdentifyError>(Mistake { kind, test, shift: followed, left, needed })
    };
    let mut all = Vec::new();
    let mut clock = Vec::new();
    for (k, test) in plan.tests().iter().enumerate() {
        let Measurement::Counted(counted) = &test.measurement else { continue };
        let (times, amplitudes) = (counted.intervals.len(), counted.amplitudes.len());
        let change =
            |changed: &dyn Fn(usize) -> bool, doubled: bool| [(k + 1, counted.change(changed, doubled))];
        let miscount = |i: usize| mistake(MistakeKind::Miscount, Some(k), &change(&|row| row == i, false));
        // Of several intervals, report the one whose miscount is hardest to detect.
        let miscounts = (0..times).map(miscount).collect::<Result<Vec<_>, _>>()?;
        all.extend(miscounts.into_iter().min_by(|a, b| a.left.total_cmp(&b.left)));
        if amplitudes > 0 {
            all.push(mistake(MistakeKind::SideToSide, Some(k), &change(&|_| false, true))?);
        }
        let longer = counted.intervals.iter().map(|interval| CLOCK * interval.time / interval.sd);
        clock.push((k + 1, longer.chain((0..amplitudes).map(|_| 0.0)).collect()));
    }
    for (row, (name, half)) in plan.lengths().enumerate().filter_map(|(row, length)| Some((row, length?))) {
        let mut change = vec![0.0; rows[0].count()];
        change[row] = half;
        all.push(mistake(MistakeKind::Twice { number: name.to_owned() }, None, &[(0, change)])?);
    }
    if !clock.is_empty() {
        all.push(mistake(MistakeKind::Clock, None, &clock)?);
    }
    Ok(all)
}

impl Counted {
    /// Returns the change of the rows, in standard deviations, for intervals with one swing too
    /// many, or for amplitudes twice too large.
    fn change(&self, miscounted: &dyn Fn(usize) -> bool, doubled: bool) -> Vec<f64> {
        let time = self.intervals.iter().enumerate().map(|(k, interval)| {
            let swing = interval.time / (interval.to - interval.from);
            if miscounted(k) { swing / interval.sd } else { 0.0 }
        });
        let amplitude = self
            .amplitudes
            .iter()
            .map(|reading| if doubled { 0.5 * reading.amplitude / reading.sd } else { 0.0 });
        time.chain(amplitude).collect()
    }
}
