//! Family of motions up to an amplitude: ω, harmonics and decay as polynomials in A².
//!
//! The amplitude −A describes the other half of a swing. So ω(A) is even. The harmonics k = 0, 1, 2
//! are A^k times an even function, and higher ones A or A² times one. With J = (1/2π) ∮ I θ̇ dθ and
//! the torques −2 a I θ̇ − β I |θ̇| θ̇, the amplitude averaged over a swing decays as
//!
//! dA/dt = −a A h₁ − β A² h₂,  a A h₁ = 2 a S/S′,  β A² h₂ = β Q/S′,
//! S = (1/2π) ∮ θ̇² dt,  Q = (1/2π) ∮ |θ̇|³ dt.
//!
//! Harmonic motion has dA/dt = −a A − (4/3π) β ω A². Sources: P.-T. Lin, Y.-S. Bao, for the law
//! dA/dt = −a A − b A²; N. N. Bogoliubov, Y. A. Mitropolsky, Asymptotic Methods in the Theory of
//! Non-linear Oscillations, for the averages.

use core::f64::consts::PI;

use nalgebra::DMatrix;

use super::dual::Gradient;
use super::orbit::{Grid, Motion, Orbit};
use super::rig::Oscillator;
use crate::error::IdentifyError;

/// Motions of one oscillator at several amplitudes.
#[derive(Clone, Debug)]
pub(super) struct Family {
    /// Largest amplitude, rad.
    pub(super) most: f64,
    /// One row per amplitude. Columns: ω, h₁, h₂, harmonics divided by A or A².
    values: DMatrix<f64>,
    /// Derivatives of each of these columns by the estimated parameters, one row per amplitude.
    by: Vec<DMatrix<f64>>,
}

/// Column indices in `values`.
const RATE: usize = 0;
const VISCOUS: usize = 1;
const QUADRATIC: usize = 2;
const HARMONICS: usize = 3;

/// Quantity at an amplitude.
#[derive(Clone, Debug)]
pub(super) struct Value {
    pub(super) value: f64,
    /// Derivative by the amplitude.
    pub(super) slope: f64,
    pub(super) by: Vec<f64>,
}

/// Interpolation weights of the rows at an amplitude, and their derivatives by it.
#[derive(Clone, Debug)]
pub(super) struct Weights {
    amplitude: f64,
    weights: Vec<f64>,
    slopes: Vec<f64>,
}

/// Amplitudes at which the motion is solved, in ascending order.
#[derive(Clone, Debug)]
pub(super) struct Amplitudes {
    pub(super) most: f64,
    amplitudes: Vec<f64>,
    pub(super) grid: Grid,
}

impl Amplitudes {
    /// Returns enough amplitudes for full accuracy of ω up to `most`. Convergence is limited by the
    /// singularity at a pendulum's amplitude of π.
    pub(super) fn up_to(most: f64) -> Self {
        let distance = 2.0 * (PI / most).powi(2) - 1.0;
        let fall = libm::log(distance + (distance * distance - 1.0).sqrt());
        let count = (31.0 / fall).ceil().clamp(3.0, 60.0) as usize;
        let amplitudes = (0..count).map(|i| most * (0.5 * (1.0 + node(i, count))).sqrt()).collect();
        Self { most, amplitudes, grid: Grid::of_amplitude(most) }
    }
}

/// Returns the zeros of the Chebyshev polynomial, in ascending order.
fn node(i: usize, count: usize) -> f64 {
    -libm::cos(PI * (i as f64 + 0.5) / count as f64)
}

impl Family {
    /// Solves the motions, from guesses if there are any. Also returns the motions, as guesses for
    /// similar parameters.
    pub(super) fn new(
        oscillator: &dyn Oscillator,
        amplitudes: &Amplitudes,
        guesses: &[Motion],
    ) -> Result<(Self, Vec<Motion>), IdentifyError> {
        let mut orbits: Vec<Orbit> = Vec::new();
        let mut before: Option<(f64, Motion)> = None;
        for (k, &amplitude) in amplitudes.amplitudes.iter().enumerate() {
            let near = guesses
                .get(k)
                .and_then(|guess| guess.clone().solved(oscillator, &amplitudes.grid, amplitude).ok());
            let orbit = match near {
                Some(orbit) => orbit,
                None => climbed(oscillator, &amplitudes.grid, before.as_ref(), amplitude)?,
            };
            before = Some((amplitude, orbit.motion.clone()));
            orbits.push(orbit);
        }
        let family = Self::of(&orbits, amplitudes, oscillator.quantities());
        Ok((family, orbits.into_iter().map(|orbit| orbit.motion).collect()))
    }

    fn of(orbits: &[Orbit], amplitudes: &Amplitudes, quantities: &[Gradient]) -> Self {
        let count = orbits.len();
        let found = quantities.first().map_or(0, |q| q.by.len());
        let chain = DMatrix::from_fn(quantities.len(), found, |q, k| quantities[q].by[k]);
        let harmonics = amplitudes.grid.count();
        let mut values = DMatrix::zeros(count, HARMONICS + harmonics);
        let mut by = vec![DMatrix::zeros(count, found); HARMONICS + harmonics];
        let mut squares: Vec<[Gradient; 2]> = Vec::new();
        for (i, orbit) in orbits.iter().enumerate() {
            let amplitude = amplitudes.amplitudes[i];
            let rate_by = DMatrix::from_row_slice(1, quantities.len(), &orbit.rate_by) * &chain;
            let rate = Gradient { value: orbit.motion.rate, by: rate_by.iter().copied().collect() };
            let coefficients = &amplitudes.grid.harmonics * &orbit.angle;
            let coefficients_by = &amplitudes.grid.harmonics * &orbit.angle_by * &chain;
            values[(i, RATE)] = rate.value;
            by[RATE].set_row(i, &rate_by.row(0));
            for k in 0..harmonics {
                let size = power(amplitude, k).0;
                values[(i, HARMONICS + k)] = coefficients[k] / size;
                by[HARMONICS + k].set_row(i, &(coefficients_by.row(k) / size));
            }
            squares.push(mean_powers(amplitude, &rate, coefficients.as_slice(), &coefficients_by));
        }
        let mut family = Self { most: amplitudes.most, values, by };
        family.set_decay(&squares, amplitudes);
        // Leave out harmonics that are rounding at the largest amplitude.
        let largest = amplitudes.amplitudes[count - 1];
        let matters = (0..harmonics)
            .rev()
            .find(|&k| {
                let size = power(largest, k).0;
                (family.values[(count - 1, HARMONICS + k)] * size).abs() > 1e-13 * largest
            })
            .unwrap_or(1);
        family.values = family.values.columns(0, HARMONICS + matters + 1).into_owned();
        family.by.truncate(HARMONICS + matters + 1);
        family
    }

    /// Computes h₁ and h₂ from s = S/A² and q = Q/A³ at all amplitudes. With x = A²:
    ///
    /// h₁ = s/(s + x s′),  h₂ = q/(2 (s + x s′))
    fn set_decay(&mut self, squares: &[[Gradient; 2]], amplitudes: &Amplitudes) {
        let found = self.by[RATE].ncols();
        for (i, [s, q]) in squares.iter().enumerate() {
            let amplitude = amplitudes.amplitudes[i];
            let Weights { slopes, .. } = self.at(amplitude);
            // x s′ = ½ A ds/dA
            let rise = Gradient::sum(
                found,
                slopes.iter().zip(squares).map(|(slope, [s, _])| (0.5 * amplitude * slope, s)),
            );
            let below = s.plus(&rise);
            for (column, ratio) in [(VISCOUS, s.over(&below)), (QUADRATIC, q.over(&below).scaled(0.5))] {
                self.values[(i, column)] = ratio.value;
                (0..found).for_each(|k| self.by[column][(i, k)] = ratio.by[k]);
            }
        }
    }

    /// Returns the interpolation weights at an amplitude.
    pub(super) fn at(&self, amplitude: f64) -> Weights {
        let count = self.values.nrows();
        let (x, x_slope) = {
            let over = amplitude / self.most;
            (2.0 * over * over - 1.0, 4.0 * over / self.most)
        };
        // Chebyshev polynomials and their derivatives at x; w_i = (1/n) (1 + 2 Σ T_k(x_i) T_k(x)).
        let polynomials = |x: f64| {
            let mut all = vec![(1.0, 0.0); count];
            for k in 1..count {
                all[k] = if k == 1 {
                    (x, 1.0)
                } else {
                    let ((t, slope), (before, before_slope)) = (all[k - 1], all[k - 2]);
                    (2.0 * x * t - before, 2.0 * t + 2.0 * x * slope - before_slope)
                };
            }
            all
        };
        let here = polynomials(x);
        let mut weights = Weights { amplitude, weights: Vec::new(), slopes: Vec::new() };
        for i in 0..count {
            let angle = PI * (i as f64 + 0.5) / count as f64;
            let (mut w, mut slope) = (1.0, 0.0);
            for (k, (t, t_slope)) in here.iter().enumerate().skip(1) {
                // T_k(−cos a) = (−1)^k cos k a
                let sign = if k % 2 == 0 { 2.0 } else { -2.0 };
                let own = sign * libm::cos(k as f64 * angle);
                w += own * t;
                slope += own * t_slope;
            }
            weights.weights.push(w / count as f64);
            weights.slopes.push(slope * x_slope / count as f64);
        }
        weights
    }

    fn column(&self, column: usize, at: &Weights) -> Value {
        let (values, by) = (self.values.column(column), &self.by[column]);
        let sum = |weights: &[f64]| weights.iter().zip(values.iter()).map(|(w, v)| w * v).sum::<f64>();
        Value {
            value: sum(&at.weights),
            slope: sum(&at.slopes),
            by: by
                .column_iter()
                .map(|column| at.weights.iter().zip(column.iter()).map(|(w, v)| w * v).sum())
                .collect(),
        }
    }

    /// Returns ω at an amplitude.
    pub(super) fn rate(&self, at: &Weights) -> Value {
        self.column(RATE, at)
    }

    /// Returns h₁ and h₂ at an amplitude.
    pub(super) fn decay(&self, at: &Weights) -> [Value; 2] {
        [self.column(VISCOUS, at), self.column(QUADRATIC, at)]
    }

    /// Returns the coefficients of cos kφ at an amplitude.
    pub(super) fn harmonics(&self, at: &Weights) -> Vec<Value> {
        (0..self.by.len() - HARMONICS)
            .map(|k| {
                let Value { value, slope, mut by } = self.column(HARMONICS + k, at);
                let (size, size_slope) = power(at.amplitude, k);
                by.iter_mut().for_each(|by| *by *= size);
                Value { value: value * size, slope: slope * size + value * size_slope, by }
            })
            .collect()
    }
}

/// Returns the leading power of harmonic k, A or A², and its derivative.
fn power(amplitude: f64, k: usize) -> (f64, f64) {
    if k % 2 == 1 { (amplitude, 1.0) } else { (amplitude * amplitude, 2.0 * amplitude) }
}

/// Maximum number of continuation steps.
const MOST_PARTS: usize = 12;

/// Solves the motion at an amplitude by continuation from a smaller one; failing steps are halved.
fn climbed(
    oscillator: &dyn Oscillator,
    grid: &Grid,
    before: Option<&(f64, Motion)>,
    amplitude: f64,
) -> Result<Orbit, IdentifyError> {
    let guess = |from: Option<&(f64, Motion)>, to: f64| match from {
        Some((from, motion)) => motion.grown(oscillator, to / from),
        None => Motion::small(oscillator, grid, to),
    };
    let mut from = before.cloned();
    let mut step = amplitude - from.as_ref().map_or(0.0, |(a, _)| *a);
    let mut refused = IdentifyError::NoConvergence { steps: MOST_PARTS };
    for _ in 0..MOST_PARTS {
        let here = from.as_ref().map_or(0.0, |(a, _)| *a);
        let to = if here + step > amplitude * (1.0 - 1e-9) { amplitude } else { here + step };
        match guess(from.as_ref(), to).solved(oscillator, grid, to) {
            Ok(orbit) if to >= amplitude => return Ok(orbit),
            Ok(orbit) => from = Some((to, orbit.motion)),
            // Too large a step may also converge to another motion with slack wires.
            Err(error) => {
                step *= 0.5;
                refused = error;
            }
        }
    }
    Err(refused)
}

/// Returns S/A² and Q/A³.
fn mean_powers(
    amplitude: f64,
    rate: &Gradient,
    coefficients: &[f64],
    coefficients_by: &DMatrix<f64>,
) -> [Gradient; 2] {
    let found = rate.by.len();
    let harmonic =
        |k: usize| Gradient { value: coefficients[k], by: coefficients_by.row(k).iter().copied().collect() };
    let all: Vec<Gradient> = (0..coefficients.len()).map(harmonic).collect();
    // S = ½ ω Σ k² c_k²
    let mut s = Gradient::constant(0.0, found);
    for (k, c) in all.iter().enumerate() {
        s = s.plus(&c.times(c).scaled((k * k) as f64));
    }
    // `Q = (ω²/π) ∫0^π |Σ k c_k sin kφ|³ dφ` by Simpson's rule; the integrand has triple zeros at
    // both ends.
    let mut q = Gradient::constant(0.0, found);
    const PARTS: usize = 96;
    for part in 1..PARTS {
        let phase = PI * part as f64 / PARTS as f64;
        let speed = Gradient::sum(
            found,
            all.iter().enumerate().map(|(k, c)| (k as f64 * libm::sin(k as f64 * phase), c)),
        );
        let weight = if part % 2 == 1 { 4.0 } else { 2.0 } / (3.0 * PARTS as f64);
        let cube = speed.times(&speed).times(&speed).scaled(weight * speed.value.signum());
        q = q.plus(&cube);
    }
    [
        s.times(rate).scaled(0.5 / (amplitude * amplitude)),
        q.times(rate).times(rate).scaled(1.0 / amplitude.powi(3)),
    ]
}
