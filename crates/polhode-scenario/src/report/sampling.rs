//! Rotation angle between consecutive samples of a motion.

use polhode::motion::Sample;

/// Threshold of the rotation angle between samples, rad. Above it an oscillation may be hidden.
const FAR: f64 = std::f64::consts::FRAC_PI_2;

/// Threshold of the angle between ω and L, rad. Above it the body nutates.
const PARALLEL: f64 = 1e-6;

/// Returns the largest |ω| Δt between consecutive samples, rad.
pub(crate) fn largest_turn<'a>(samples: impl IntoIterator<Item = &'a Sample>) -> f64 {
    let mut samples = samples.into_iter();
    let Some(mut before) = samples.next() else { return 0.0 };
    let mut largest = 0.0;
    for sample in samples {
        let rate = before.state.omega.norm().max(sample.state.omega.norm());
        largest = f64::max(largest, rate * (sample.state.time - before.state.time));
        before = sample;
    }
    largest
}

/// Returns the largest rotation angle between samples, rad, if it exceeds `FAR` and the body
/// nutates.
pub(crate) fn turn_that_hides(samples: &[Sample]) -> Option<f64> {
    let turn = largest_turn(samples);
    let nutates = samples.iter().any(|s| {
        let omega = s.state.omega_space();
        let angle = omega.to_array().into_iter().zip(s.momentum.to_array());
        let along = angle.map(|(a, b)| a * b).sum::<f64>();
        let size = omega.norm() * s.momentum.norm();
        // cos α = 1 − α²/2
        size > 0.0 && 1.0 - (along / size).abs() > 0.5 * PARALLEL * PARALLEL + 4.0 * f64::EPSILON
    });
    (turn > FAR && nutates).then_some(turn)
}
