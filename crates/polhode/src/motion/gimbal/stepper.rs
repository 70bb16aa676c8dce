//! Steps by Taylor series, with compensated rounding of the variables.

use super::axis::Hold;
use super::equations::{ANGLES, COUNT, RATES, TURNS, WORKS};
use super::model::Model;
use crate::math::number::sin_cos;
use crate::math::root::vanishing;
use crate::math::sum::two_sum;
use crate::motion::solve::propagate::noise::{Random, StepNoise};
use crate::motion::solve::series::{Expansion, System};

/// Smallest scale of a rate, relative to the rate of the motion.
const SLOWEST: f64 = 1e-10;

/// Variables stored as double-doubles: angles, rates and works. Cosines and sines follow from the
/// angles.
const CARRIED: [usize; 8] = [ANGLES, ANGLES + 1, ANGLES + 2, RATES, RATES + 1, RATES + 2, WORKS, WORKS + 1];

/// Integrator of a rotor in its gimbals.
pub(super) struct Stepper {
    pub(super) model: Model,
    expansion: Expansion,
    /// Number of pivots.
    pivots: usize,
    /// Start time of the last step.
    begun: f64,
    time: f64,
    /// Variables at the end of the last step: high and low words.
    high: [f64; COUNT],
    low: [f64; COUNT],
    noise: Option<(Random, f64)>,
    stretch: f64,
}

/// Variables at a time: high and low words.
#[derive(Clone, Copy, Debug)]
pub(super) struct Variables {
    pub(super) high: [f64; COUNT],
    pub(super) low: [f64; COUNT],
}

impl Stepper {
    pub(super) fn new(model: Model, tolerance: f64, time: f64, noise: Option<StepNoise>) -> Self {
        let mut pivots = 0;
        let system = System::record(COUNT, |one, y| {
            let (rates, outputs) = model.rates(one, y);
            pivots = outputs.len();
            [rates, outputs]
        });
        let mut high = [0.0; COUNT];
        for (k, axis) in model.axes.iter().enumerate() {
            high[ANGLES + k] = axis.angle();
            high[RATES + k] = axis.rate();
        }
        let (noise, stretch) = noise.map_or((None, 1.0), |StepNoise { seed, amplitude, stretch }| {
            (Some((Random::new(seed), amplitude * f64::EPSILON)), stretch)
        });
        let expansion = Expansion::new(system, tolerance);
        let mut stepper =
            Self { model, expansion, pivots, begun: time, time, high, low: [0.0; COUNT], noise, stretch };
        stepper.turn();
        stepper
    }

    /// Computes cosines and sines of the angles, from both words.
    fn turn(&mut self) {
        with_turns(&mut self.high, &self.low);
    }

    pub(super) const fn time(&self) -> f64 {
        self.time
    }

    /// Returns the number of coefficients of a step.
    pub(super) const fn terms(&self) -> u64 {
        self.expansion.terms()
    }

    /// Returns the smallest pivot of M minus its threshold; positive except at gimbal lock.
    pub(super) fn least_pivot(&self) -> f64 {
        let (_, pivots) = self.model.rates(1.0, &self.high);
        // A minimum that propagates NaN.
        pivots.into_iter().fold(f64::INFINITY, |least, x| if x.is_nan() || x < least { x } else { least })
    }

    /// Returns the variables at the end of the last step.
    pub(super) const fn variables(&self) -> Variables {
        Variables { high: self.high, low: self.low }
    }

    /// Returns the variables within the current step, or at the end of the last one.
    pub(super) fn variables_at(&self, time: f64) -> Variables {
        if time == self.time {
            return self.variables();
        }
        let (mut high, mut low) = (self.high, self.low);
        for k in CARRIED {
            (high[k], low[k]) = two_sum(high[k], low[k] + self.expansion.change(time - self.begun, k));
        }
        with_turns(&mut high, &low);
        Variables { high, low }
    }

    /// Computes the next step and returns its length; NaN if there is none.
    pub(super) fn expand(&mut self) -> f64 {
        self.begun = self.time;
        let sizes = self.sizes();
        self.stretch * self.expansion.about(&self.high, [&sizes, &vec![f64::INFINITY; self.pivots]])
    }

    /// Returns the time of gimbal lock within h of the start of the step, if it occurs.
    pub(super) fn locks(&self, h: f64) -> Option<f64> {
        (0..self.pivots).filter_map(|k| vanishing(|t| self.expansion.output(t, k), h)).reduce(f64::min)
    }

    pub(super) fn advance(&mut self, h: f64, to: f64) {
        for k in CARRIED {
            let (before, change) = (self.high[k].abs(), self.expansion.change(h, k));
            (self.high[k], self.low[k]) = two_sum(self.high[k], self.low[k] + change);
            if let Some((random, amplitude)) = &mut self.noise {
                // For an angle only the change is rounded, as both words are stored.
                let size = if k < RATES { change.abs() } else { 0.5 * (before + self.high[k].abs()) };
                self.low[k] += *amplitude * size * random.next();
            }
        }
        self.time = to;
        self.turn();
    }

    /// Returns the scale of each variable. The scale of a rate combines its own magnitude and its
    /// change during one revolution, so that a slow rate next to a fast one keeps its accuracy.
    fn sizes(&self) -> [f64; COUNT] {
        let dynamics = self.model.dynamics(1.0, &self.high);
        let free = |k: &usize| self.model.axes[*k].hold() == Hold::Free;
        let [x, y, z] = self.model.turning;
        let around = (0..3).filter(free).fold(x.hypot(y).hypot(z), |sum, k| {
            sum + self.high[RATES + k].abs() + dynamics.accelerations[k].abs().sqrt()
        });
        let around = if around > 0.0 { around } else { 1.0 };
        let mut sizes = [1.0; COUNT];
        for k in 0..3 {
            let change = dynamics.accelerations[k].abs() / around;
            sizes[RATES + k] = self.high[RATES + k].abs() + change + SLOWEST * around;
        }
        let reading = self.model.reading(&self.high);
        let energy = reading.kinetic_energy.abs() + reading.potential_energy.abs();
        let energy = if energy > 0.0 { energy } else { f64::INFINITY };
        sizes[WORKS..].fill(energy);
        sizes
    }
}

/// Computes cosines and sines of double-double angles.
fn with_turns(high: &mut [f64; COUNT], low: &[f64; COUNT]) {
    for k in 0..3 {
        let ((sine, cosine), rest) = (sin_cos(high[ANGLES + k]), low[ANGLES + k]);
        high[TURNS + 2 * k] = cosine - rest * sine;
        high[TURNS + 2 * k + 1] = sine + rest * cosine;
    }
}
