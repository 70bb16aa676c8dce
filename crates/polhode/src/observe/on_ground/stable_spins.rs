//! Spin ranges in which a steady motion is stable.

/// Interval of spins, rad/s; an end without a bound is infinite.
pub type SpinInterval = [f64; 2];

/// Spins at which a steady motion is stable: ascending intervals that do not overlap, and the law
/// that bounds them.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct StableSpins {
    /// Stable intervals of the signed spin, rad/s.
    pub intervals: Vec<SpinInterval>,
    /// Name of the law, as in the book.
    pub law: &'static str,
}

impl StableSpins {
    pub(super) const fn new(intervals: Vec<SpinInterval>, law: &'static str) -> Self {
        Self { intervals, law }
    }

    /// Returns the spins in either sense with a ω² > b.
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

    /// Returns true if a spin is in one of the intervals.
    pub fn contains(&self, spin: f64) -> bool {
        self.intervals.iter().any(|[from, to]| *from < spin && spin < *to)
    }

    /// Returns the finite bounds of the intervals, in ascending order, rad/s.
    pub fn thresholds(&self) -> Vec<f64> {
        self.intervals.iter().flatten().copied().filter(|spin| spin.is_finite()).collect()
    }

    /// Returns the threshold of the same sense that is nearest to a spin, if there is one.
    pub fn nearest(&self, spin: f64) -> Option<f64> {
        let of_sense = |threshold: &f64| *threshold * spin >= 0.0;
        let distance = |threshold: &f64| (threshold - spin).abs();
        self.thresholds().into_iter().filter(of_sense).min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }
}

const ALL: SpinInterval = [f64::NEG_INFINITY, f64::INFINITY];

/// Returns intervals of |ω| in both senses.
pub(super) fn both_senses(of_size: &[SpinInterval]) -> Vec<SpinInterval> {
    let mirrored = of_size.iter().rev().map(|[from, to]| [-to, -from]);
    let mut all: Vec<SpinInterval> = Vec::new();
    for next in mirrored.chain(of_size.iter().copied()) {
        match all.last_mut() {
            // Intervals that start at zero are joined across it.
            Some(last) if last[1] == next[0] => last[1] = next[1],
            _ => all.push(next),
        }
    }
    all
}
