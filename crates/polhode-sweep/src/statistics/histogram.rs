//! Histograms, over the part of the range that most numbers are in.

use super::passes::Parts;
use super::selection::Selection;
use super::tally::Moments;
use super::{interval, values};
use crate::error::SweepError;
use crate::report::SweepHistogram;

/// Bins of a histogram.
const BINS: usize = 40;
/// Beyond this ratio of the 99 % to the 1 % quantile bins are of equal ratio.
const DECADES: f64 = 100.0;

/// Where the bins of a column are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bins {
    least: f64,
    greatest: f64,
    log: bool,
}

impl Bins {
    /// From the 1 % to the 99 % quantile, or to the ends if they are no further from it than that range is long; `None` for a column that does not vary.
    pub(super) fn of(moments: &Moments, selection: &Selection) -> Option<Self> {
        let rank = |p: f64| interval::around(moments.count, p);
        let (low, high) = (selection.at(rank(0.01).0)?, selection.at(rank(0.99).1)?);
        let log = low > 0.0 && moments.min > 0.0 && high / low > DECADES;
        let scale = |x: f64| if log { libm::log10(x) } else { x };
        let near = scale(high) - scale(low);
        let least = if scale(low) - scale(moments.min) <= near { moments.min } else { low };
        let greatest = if scale(moments.max) - scale(high) <= near { moments.max } else { high };
        let [least, greatest] = if least < greatest { [least, greatest] } else { [moments.min, moments.max] };
        (least < greatest && (greatest - least).is_finite()).then_some(Self { least, greatest, log })
    }

    /// The bin of a number: the first is for what is below, the last for what is above.
    fn place(&self, x: f64) -> usize {
        if x < self.least {
            return 0;
        }
        if x > self.greatest {
            return BINS + 1;
        }
        let scale = |x: f64| if self.log { libm::log10(x) } else { x };
        let part = (scale(x) - scale(self.least)) / (scale(self.greatest) - scale(self.least));
        1 + ((part * BINS as f64) as usize).min(BINS - 1)
    }
}

/// The histograms of all columns that have one.
pub(super) fn count(
    parts: &Parts<'_>,
    names: &[&str],
    bins: &[Option<Bins>],
) -> Result<Vec<Option<SweepHistogram>>, SweepError> {
    const PLACES: usize = BINS + 2;
    let counts = parts.counts(names.len() * PLACES, |batch, counts| {
        for ((name, bins), counts) in names.iter().zip(bins).zip(counts.chunks_exact_mut(PLACES)) {
            let Some(bins) = bins else { continue };
            for value in values(batch, name) {
                if let Some(count) = counts.get_mut(bins.place(value)) {
                    *count += 1;
                }
            }
        }
    })?;
    let histogram = |(bins, counts): (&Option<Bins>, &[u64])| {
        let Bins { least, greatest, log } = (*bins)?;
        let [below, counts @ .., above] = counts else { return None };
        Some(SweepHistogram { least, greatest, log, counts: counts.to_vec(), below: *below, above: *above })
    };
    Ok(bins.iter().zip(counts.chunks_exact(PLACES)).map(histogram).collect())
}
