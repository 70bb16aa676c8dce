//! Amplitude and phase of a damped swing against time, with their derivatives.
//!
//! dA/dt = −a A h₁(A) − β A² h₂(A)
//!
//! dφ/dt = ω(A) − a²/(2 ω) − (2/3π) a β A − (1/6 − 40/27π²) β² A² ω
//!
//! The terms after ω(A) are of second order in the damping and hold for harmonic motion. φ is the
//! phase of the first harmonic, so the middle position is passed at odd multiples of π/2. With
//! quadratic damping the turning points precede multiples of π by (10/9π) β A. Integration of the
//! damped motion shows that the time between turning points is π (1 + β² A²/6)/ω, with A the
//! geometric mean of both amplitudes.

use core::f64::consts::PI;

use super::family::Family;
use crate::error::IdentifyError;

/// Initial amplitude and damping of a swing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Decay {
    /// Amplitude at the beginning, rad.
    pub(super) amplitude: f64,
    /// Coefficient a of viscous damping, 1/s.
    pub(super) viscous: f64,
    /// Coefficient β of quadratic damping, dimensionless.
    pub(super) quadratic: f64,
}

/// Number of derivatives by amplitude, a and β. They precede the derivatives by the shared
/// parameters.
pub(super) const OWN: usize = 3;

/// Independent variable of the integration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Clock {
    /// Time, s; the state is amplitude and phase.
    Time,
    /// Phase, rad; the state is amplitude and time.
    Phase,
}

/// States at equal steps of the independent variable, from 0.
#[derive(Clone, Debug)]
pub(super) struct Course {
    step: f64,
    states: Vec<State>,
}

/// Amplitude, phase or time, and the derivatives of both; `slope` is their derivative by the
/// independent variable.
#[derive(Clone, Debug)]
struct State {
    state: Vec<f64>,
    slope: Vec<f64>,
}

/// Amplitude, and phase or time, at one value of the independent variable, with derivatives.
#[derive(Clone, Debug)]
pub(super) struct Point {
    pub(super) amplitude: f64,
    pub(super) other: f64,
    pub(super) amplitude_by: Vec<f64>,
    pub(super) other_by: Vec<f64>,
}

/// Number of integration steps; the averaged equations are smooth, so few suffice.
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

    /// Returns the state at a value of the independent variable, by Hermite interpolation.
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

/// Returns the right-hand side of the equations and of their derivatives.
fn slope(family: &Family, decay: Decay, clock: Clock, state: &[f64]) -> Result<Vec<f64>, IdentifyError> {
    let Decay { viscous: a, quadratic: b, .. } = decay;
    let amplitude = state[0];
    IdentifyError::require(
        "an amplitude, rad",
        amplitude,
        amplitude > 0.0 && amplitude <= 1.1 * family.most,
        "above zero, and within the computed range",
    )?;
    let at = family.at(amplitude);
    let rate = family.rate(&at);
    let [h1, h2] = family.decay(&at);
    let (w, mixed) = (rate.value, 2.0 / (3.0 * PI));
    let square = 1.0 / 6.0 - 40.0 / (27.0 * PI * PI);
    // Amplitude: f = −dA/dt, and phase: g = dφ/dt, with derivatives by A, a, β and the shared
    // parameters.
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
