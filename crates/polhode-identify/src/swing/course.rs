//! How a swing goes on: its amplitude and phase in the course of time, with their derivatives.
//!
//! dA/dt = −a A h₁(A) − β A² h₂(A),  dφ/dt = ω(A) − a²/(2 ω) − (2/3π) a β A − (1/6 − 40/27π²) β² A² ω
//!
//! The last terms are those of the second order in the damping, of a harmonic motion. φ is that of the first harmonic: the middle is passed at whole quarters, and
//! with quadratic damping the turning points are (10/9π) β A before theirs. (From one to the next is then π (1 + β² A²/6)/ω, A the geometric mean of both, as
//! integration of the damped motion shows.)

use core::f64::consts::PI;

use super::family::Family;
use crate::error::IdentifyError;

/// The numbers of a swing besides those of the body and the rig.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Decay {
    /// Amplitude at the beginning, rad.
    pub(super) amplitude: f64,
    /// a, 1/s.
    pub(super) viscous: f64,
    /// β.
    pub(super) quadratic: f64,
}

/// Derivatives are by amplitude, a, β, then by the numbers to be found.
pub(super) const OWN: usize = 3;

/// What the state is a function of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Clock {
    /// Time: the state is amplitude and phase.
    Time,
    /// Phase: the state is amplitude and time.
    Phase,
}

/// States at equal steps of the clock, from 0.
#[derive(Clone, Debug)]
pub(super) struct Course {
    step: f64,
    states: Vec<State>,
}

/// Amplitude, phase or time, and the derivatives of both; and the same differentiated by the clock.
#[derive(Clone, Debug)]
struct State {
    state: Vec<f64>,
    slope: Vec<f64>,
}

/// Amplitude, and phase or time, at a place; with derivatives.
#[derive(Clone, Debug)]
pub(super) struct Point {
    pub(super) amplitude: f64,
    pub(super) other: f64,
    pub(super) amplitude_by: Vec<f64>,
    pub(super) other_by: Vec<f64>,
}

/// Steps; what changes is smooth, as it is averaged over swings.
const STEPS: usize = 96;

impl Course {
    pub(super) fn new(family: &Family, decay: Decay, clock: Clock, end: f64) -> Result<Self, IdentifyError> {
        let step = end / STEPS as f64;
        let mut state = vec![decay.amplitude, 0.0];
        let count = family.rate(&family.at(decay.amplitude)).by.len() + OWN;
        state.resize(2 + 2 * count, 0.0);
        state[2] = 1.0;
        let mut states = Vec::with_capacity(STEPS + 1);
        let slope = |state: &[f64]| slope(family, decay, clock, state);
        for _ in 0..STEPS {
            let k1 = slope(&state)?;
            let k2 = slope(&moved(&state, &k1, 0.5 * step))?;
            let k3 = slope(&moved(&state, &k2, 0.5 * step))?;
            let k4 = slope(&moved(&state, &k3, step))?;
            let next = (0..state.len())
                .map(|i| state[i] + step / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]))
                .collect();
            states.push(State { state, slope: k1 });
            state = next;
        }
        let last = slope(&state)?;
        states.push(State { state, slope: last });
        Ok(Self { step, states })
    }

    /// At a value of the clock: by Hermite's polynomials.
    pub(super) fn at(&self, clock: f64) -> Point {
        let place = if self.step > 0.0 { clock / self.step } else { 0.0 };
        let k = (place.max(0.0) as usize).min(self.states.len() - 2);
        let (s, h) = (place - k as f64, self.step);
        let (a, b) = (&self.states[k], &self.states[k + 1]);
        let [h00, h10, h01, h11] = [
            (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s),
            s * (1.0 - s) * (1.0 - s) * h,
            s * s * (3.0 - 2.0 * s),
            s * s * (s - 1.0) * h,
        ];
        let at = |i: usize| h00 * a.state[i] + h10 * a.slope[i] + h01 * b.state[i] + h11 * b.slope[i];
        let count = (a.state.len() - 2) / 2;
        Point {
            amplitude: at(0),
            other: at(1),
            amplitude_by: (2..2 + count).map(at).collect(),
            other_by: (2 + count..2 + 2 * count).map(at).collect(),
        }
    }
}

fn moved(state: &[f64], slope: &[f64], by: f64) -> Vec<f64> {
    state.iter().zip(slope).map(|(x, v)| x + by * v).collect()
}

/// The equations, and those of the derivatives.
fn slope(family: &Family, decay: Decay, clock: Clock, state: &[f64]) -> Result<Vec<f64>, IdentifyError> {
    let Decay { viscous: a, quadratic: b, .. } = decay;
    let amplitude = state[0];
    IdentifyError::require(
        "an amplitude, rad",
        amplitude,
        amplitude > 0.0 && amplitude <= 1.1 * family.most,
        "above zero, and within what was computed",
    )?;
    let at = family.at(amplitude);
    let rate = family.rate(&at);
    let [h1, h2] = family.decay(&at);
    let (w, mixed) = (rate.value, 2.0 / (3.0 * PI));
    let square = 1.0 / 6.0 - 40.0 / (27.0 * PI * PI);
    // Amplitude: f = −dA/dt, and phase: g = dφ/dt, with derivatives by A, a, β and the numbers.
    let f = a * amplitude * h1.value + b * amplitude * amplitude * h2.value;
    let g = w - 0.5 * a * a / w - mixed * a * b * amplitude - square * b * b * amplitude * amplitude * w;
    let g_by_rate = 1.0 + 0.5 * (a / w).powi(2) - square * b * b * amplitude * amplitude;
    let f_slope =
        a * (h1.value + amplitude * h1.slope) + b * amplitude * (2.0 * h2.value + amplitude * h2.slope);
    let g_slope = g_by_rate * rate.slope - mixed * a * b - 2.0 * square * b * b * amplitude * w;
    let count = (state.len() - 2) / 2;
    let mut f_by = vec![0.0; count];
    let mut g_by = vec![0.0; count];
    f_by[1] = amplitude * h1.value;
    f_by[2] = amplitude * amplitude * h2.value;
    g_by[1] = -a / w - mixed * b * amplitude;
    g_by[2] = -mixed * a * amplitude - 2.0 * square * b * amplitude * amplitude * w;
    for k in OWN..count {
        f_by[k] = a * amplitude * h1.by[k - OWN] + b * amplitude * amplitude * h2.by[k - OWN];
        g_by[k] = g_by_rate * rate.by[k - OWN];
    }
    let amplitude_by = &state[2..2 + count];
    let mut all = vec![0.0; state.len()];
    for k in 0..count {
        let df = f_slope * amplitude_by[k] + f_by[k];
        let dg = g_slope * amplitude_by[k] + g_by[k];
        (all[2 + k], all[2 + count + k]) = match clock {
            Clock::Time => (-df, dg),
            Clock::Phase => ((f * dg / g - df) / g, -dg / (g * g)),
        };
    }
    (all[0], all[1]) = match clock {
        Clock::Time => (-f, g),
        Clock::Phase => (-f / g, 1.0 / g),
    };
    Ok(all)
}
