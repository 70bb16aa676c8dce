//! Names of sampling methods, and the validity of their confidence intervals.

use crate::plan::Sampling;
use crate::report::SweepIntervals;

/// Returns the name of a sampling method in files.
pub(crate) const fn name(sampling: Sampling) -> &'static str {
    match sampling {
        Sampling::Grid => "grid",
        Sampling::MonteCarlo => "monte_carlo",
        Sampling::LatinHypercube => "latin_hypercube",
        Sampling::Sobol => "sobol",
    }
}

/// Returns the kind of confidence intervals, or the reason why there are none.
pub(crate) const fn intervals(sampling: Sampling, replicates: u64, confidence: f64) -> SweepIntervals {
    if replicates > 1 {
        return SweepIntervals::OfSets { confidence, sets: replicates };
    }
    let why = match sampling {
        Sampling::MonteCarlo => return SweepIntervals::Given { confidence },
        Sampling::Grid => "members of a grid are not a random sample",
        Sampling::LatinHypercube => {
            "members of a Latin hypercube are not independent; replicates = 16 draws 16 independent hypercubes, \
             which give intervals"
        }
        Sampling::Sobol => {
            "Sobol points are not independent; replicates = 16 draws 16 independent sets, which give intervals"
        }
    };
    SweepIntervals::None { why }
}
