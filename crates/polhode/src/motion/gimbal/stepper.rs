//! Steps: Taylor series about one state after another, the rounding of the variables carried along.

use super::axis::Hold;
use super::equations::{ANGLES, COUNT, RATES, TURNS, WORKS};
use super::model::Model;
use crate::math::number::sin_cos;
use crate::math::root::vanishing;
use crate::math::sum::two_sum;
use crate::motion::solve::propagate::noise::{Random, StepNoise};
use crate::motion::solve::series::{Expansion, System};

/// The smallest rate that rates are measured with, relative to that of the motion.
const SLOWEST: f64 = 1e-10;

/// The variables that are carried along: angles, rates and works, in two words each. Cosines and sines follow.
const CARRIED: [usize; 8] = [ANGLES, ANGLES + 1, ANGLES + 2, RATES, RATES + 1, RATES + 2, WORKS, WORKS + 1];

/// A rotor in its gimbals on its way.
pub(super) struct Stepper {
    pub(super) model: Model,
    expansion: Expansion,
    /// How many pivots there are.
    pivots: usize,
    /// Where the last step began.
    begun: f64,
    time: f64,
    /// At the end of the last step, and what rounding left of it.
    high: [f64; COUNT],
    low: [f64; COUNT],
    noise: Option<(Random, f64)>,
    stretch: f64,
}

/// The variables at a time, and what rounding left of them.
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

    /// Cosines and sines of the angles, to the last bit of both words.
    fn turn(&mut self) {
        with_turns(&mut self.high, &self.low);
    }

    pub(super) const fn time(&self) -> f64 {
        self.time
    }

    /// How many coefficients a step takes.
    pub(super) const fn terms(&self) -> u64 {
        self.expansion.terms()
    }

    /// The least of the pivots of M, less what is lost of it; positive unless the gimbals lock.
    pub(super) fn least_pivot(&self) -> f64 {
        let (_, pivots) = self.model.rates(1.0, &self.high);
        // A minimum that NaN does not escape.
        pivots.into_iter().fold(f64::INFINITY, |least, x| if x.is_nan() || x < least { x } else { least })
    }

    /// The variables at the end of the last step.
    pub(super) const fn variables(&self) -> Variables {
        Variables { high: self.high, low: self.low }
    }

    /// The variables within the step that has begun, or at the end of the last one.
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

    /// The step that may be taken from here; its series. NaN if there is none.
    pub(super) fn expand(&mut self) -> f64 {
        self.begun = self.time;
        let sizes = self.sizes();
        self.stretch * self.expansion.about(&self.high, [&sizes, &vec![f64::INFINITY; self.pivots]])
    }

    /// When gimbals lock within h of the start of the step.
    pub(super) fn locks(&self, h: f64) -> Option<f64> {
        (0..self.pivots).filter_map(|k| vanishing(|t| self.expansion.output(t, k), h)).reduce(f64::min)
    }

    pub(super) fn advance(&mut self, h: f64, to: f64) {
        for k in CARRIED {
            let (before, change) = (self.high[k].abs(), self.expansion.change(h, k));
            (self.high[k], self.low[k]) = two_sum(self.high[k], self.low[k] + change);
            if let Some((random, amplitude)) = &mut self.noise {
                // Of an angle the change alone is rounded, as its two words are carried along.
                let size = if k < RATES { change.abs() } else { 0.5 * (before + self.high[k].abs()) };
                self.low[k] += *amplitude * size * random.next();
            }
        }
        self.time = to;
        self.turn();
    }

    /// What each variable is measured with: a rate with its own size and with what it changes by while the motion goes round, so that a slow one beside a
    /// fast one has its digits.
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

/// Cosines and sines of angles in two words.
fn with_turns(high: &mut [f64; COUNT], low: &[f64; COUNT]) {
    for k in 0..3 {
        let ((sine, cosine), rest) = (sin_cos(high[ANGLES + k]), low[ANGLES + k]);
        high[TURNS + 2 * k] = cosine - rest * sine;
        high[TURNS + 2 * k + 1] = sine + rest * cosine;
    }
}
