//! Histograms over the central part of the range.

use super::passes::Parts;
use super::selection::Selection;
use super::tally::Moments;
use super::{interval, values};
use crate::error::SweepError;
use crate::report::SweepHistogram;

/// Number of bins of a histogram.
const BINS: usize = 40;
/// Ratio of the 99 % to the 1 % quantile above which bins have equal ratios.
const DECADES: f64 = 100.0;

/// Bins of a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bins {
    least: f64,
    greatest: f64,
    log: bool,
}

impl Bins {
    /// Chooses the bins; `None` for a column that does not vary.
    ///
    /// They cover the 1 % to the 99 % quantile. An end extends to the extreme value if that is no
    /// further away than the length of this range.
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

    /// Returns the bin of a value: the first is for values below the range, the last for values
    /// above.
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

/// Returns the histograms of all columns with bins.
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
