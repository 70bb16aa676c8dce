//! Steps in two halves: comparison runs of the error estimate take every step of a motion so.

/// The whole step that is being taken in two halves.
///
/// Whatever set its length (the tolerance, the end of a piece or of the run, a limit of the
/// method), its halves are really shorter. The truncation error of a step of order p falls by
/// 2^(p+1), so that the distance of a run in halves from the run in whole steps is the truncation
/// error of the latter. Within the first half series and dense output start where those of the
/// whole step do: there series have more terms ([`MORE_TERMS`]), and DOP853 and splitting take a
/// part of a step in two halves too.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct Halving {
    /// Start and end of the whole step, s.
    whole: [f64; 2],
}

/// Terms that Taylor series have beyond those of the run: two, as every other term may be zero.
pub(in crate::motion) const MORE_TERMS: usize = 2;

impl Halving {
    /// Before the first step.
    pub(in crate::motion) const NONE: Self = Self { whole: [f64::NAN; 2] };

    /// The end of the whole step, if `time` is inside it: the second half ends there.
    pub(in crate::motion) fn second_half(&self, time: f64) -> Option<f64> {
        let [start, end] = self.whole;
        (start < time && time < end).then_some(end)
    }

    /// Begins a whole step, and returns the end of its first half.
    pub(in crate::motion) fn begin(&mut self, start: f64, end: f64) -> f64 {
        self.whole = [start, end];
        let middle = start + 0.5 * (end - start);
        if middle > start { middle } else { end }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_is_taken_in_two_halves_and_the_next_one_begins_after_both() {
        let mut halving = Halving::NONE;
        assert_eq!(halving.second_half(1.0), None);
        assert_eq!(halving.begin(1.0, 1.5), 1.25);
        let ends = [1.0, 1.25, 1.4, 1.5].map(|time| halving.second_half(time));
        assert_eq!(ends, [None, Some(1.5), Some(1.5), None]);
        // between neighbouring numbers there is no middle
        let next = 1.0 + f64::EPSILON;
        let mut before = Halving::NONE;
        assert_eq!(before.begin(1.0, next), next);
    }
}
