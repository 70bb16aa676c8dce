//! Mistakes in a plan of swing tests, and whether what is left would show them.

use super::measurement::{Counted, Measurement};
use super::plan::SwingPlan;
use super::problem::Swings;
use crate::error::IdentifyError;
use crate::least_squares::{Information, Problem, Response, Solution, response, rows_of};
use crate::residuals::ResidualTest;

/// A mistake that could have been made, and whether it would show.
#[derive(Clone, Debug, PartialEq)]
pub struct Mistake {
    /// What would be wrong.
    pub kind: MistakeKind,
    /// Its test, by its place in the plan; `None` of what several tests share.
    pub test: Option<usize>,
    /// By how many standard deviations the body and the other shared numbers would be off, all together.
    pub shift: f64,
    /// By how many standard deviations it would move what is left: the root of the noncentrality of χ².
    pub left: f64,
    /// How many it takes until the residuals are larger than noise beyond chance, in the mean.
    pub needed: f64,
}

/// What could be wrong, to first order in the measurements.
#[derive(Clone, Debug, PartialEq)]
pub enum MistakeKind {
    /// One swing more or less was counted than there was.
    Miscount,
    /// Amplitudes were read from one side to the other, so they are twice too large.
    SideToSide,
    /// A length was measured across, so it is twice too large.
    Twice {
        /// The number's name.
        number: String,
    },
    /// All times are 1 % too long.
    Clock,
}

/// By how much all times are too long.
const CLOCK: f64 = 0.01;

/// Numbers that are off by less are none the worse.
const MATTERS: f64 = 1.0;

impl Mistake {
    /// Whether it would make the numbers wrong.
    pub fn matters(&self) -> bool {
        self.shift >= MATTERS
    }

    /// Whether the residuals would show it.
    pub fn shows(&self) -> bool {
        self.left >= self.needed
    }

    /// Whether it would make the numbers wrong without showing.
    pub fn is_hidden(&self) -> bool {
        self.matters() && !self.shows()
    }
}

/// What becomes of each mistake: a change d of the residuals, in standard deviations, leaves (1 − H) d of itself, H the projection on what the numbers that are found can do.
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
        // Of several intervals, that of which it shows least.
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
    /// By how much the rows change, in standard deviations: of intervals with one swing more, of amplitudes that are twice too large.
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
