//! The spins at which a steady motion is stable.

/// An interval of spins, rad/s; without a bound on a side it is infinite there.
pub type SpinInterval = [f64; 2];

/// The spins at which a steady motion is stable: intervals in ascending order, which do not overlap, and the law that bounds them.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct StableSpins {
    /// rad/s, with sign.
    pub intervals: Vec<SpinInterval>,
    /// The law, in words of the book.
    pub law: &'static str,
}

impl StableSpins {
    pub(super) const fn new(intervals: Vec<SpinInterval>, law: &'static str) -> Self {
        Self { intervals, law }
    }

    /// Where a ω² > b, of a spin in either sense.
    pub(super) fn where_exceeds(a: f64, b: f64, law: &'static str) -> Self {
        let threshold = (b / a).sqrt();
        Self::new(
            match (a > 0.0, b > 0.0) {
                (true, true) => both_senses(&[[threshold, f64::INFINITY]]),
                (true, false) => vec![ALL],
                (false, true) => Vec::new(),
                (false, false) if a == 0.0 => {
                    if b < 0.0 {
                        vec![ALL]
                    } else {
                        Vec::new()
                    }
                }
                (false, false) => vec![[-threshold, threshold]],
            },
            law,
        )
    }

    /// True if a spin is in one of the intervals.
    pub fn contains(&self, spin: f64) -> bool {
        self.intervals.iter().any(|[from, to]| *from < spin && spin < *to)
    }

    /// The bounds of the intervals that are finite, in ascending order, rad/s.
    pub fn thresholds(&self) -> Vec<f64> {
        self.intervals.iter().flatten().copied().filter(|spin| spin.is_finite()).collect()
    }

    /// The threshold that is nearest to a spin in its sense, if there is one.
    pub fn nearest(&self, spin: f64) -> Option<f64> {
        let of_sense = |threshold: &f64| *threshold * spin >= 0.0;
        let distance = |threshold: &f64| (threshold - spin).abs();
        self.thresholds().into_iter().filter(of_sense).min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }
}

const ALL: SpinInterval = [f64::NEG_INFINITY, f64::INFINITY];

/// Intervals of |ω|, in both senses.
pub(super) fn both_senses(of_size: &[SpinInterval]) -> Vec<SpinInterval> {
    let mirrored = of_size.iter().rev().map(|[from, to]| [-to, -from]);
    let mut all: Vec<SpinInterval> = Vec::new();
    for next in mirrored.chain(of_size.iter().copied()) {
        match all.last_mut() {
            // What begins at zero goes through it.
            Some(last) if last[1] == next[0] => last[1] = next[1],
            _ => all.push(next),
        }
    }
    all
}
