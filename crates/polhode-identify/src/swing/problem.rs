//! Least-squares problem of swing tests.

use core::cell::RefCell;
use core::f64::consts::{PI, TAU};

use super::course::{Clock, Course, Decay, OWN, Point};
use super::family::{Amplitudes, Family};
use super::measurement::{Counted, Logged, Look, Measurement, Signal};
use super::number::{Measured, Numbers, TENSOR};
use super::orbit::Motion;
use super::plan::{SwingPlan, SwingTest};
use crate::error::IdentifyError;
use crate::least_squares::{Problem, Rows};

/// Stage of the fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Stage {
    /// Rate of each test at its mean amplitude; start for the complete fit.
    Rates,
    /// All measurements.
    All,
}

/// Least-squares problem: group 0 has the measured numbers, each further group one test.
pub(super) struct Swings<'a> {
    pub(super) stage: Stage,
    tests: Vec<Prepared<'a>>,
    measured: Vec<Measured>,
    places: Vec<Option<usize>>,
}

struct Prepared<'a> {
    test: &'a SwingTest,
    look: Look,
    amplitudes: Amplitudes,
    /// Rate of the small oscillation and the motions of the last evaluation, which are guesses for
    /// similar parameters.
    last: RefCell<(f64, Vec<Motion>)>,
    /// True for each element of the tensor that this test estimates.
    sought: RefCell<Option<[bool; 6]>>,
}

/// Threshold of influence: the largest possible change of a tensor element must change the test by
/// this many standard deviations.
const NOTHING: f64 = 1e-2;

/// Threshold of influence relative to the most influential element. Elements below it are not
/// estimated from the test. The test cannot determine them, and without other tests they would
/// drift far. The prediction still includes them.
const SMALL: f64 = 1e-5;
/// Relative threshold in the first stage, while rates are far off.
const COARSE: f64 = 1e-3;

/// Largest relative change of the rate for which the last motions are used as guesses.
const NEARBY: f64 = 0.02;

/// Ratio of the largest computed amplitude to the largest observed one.
const ROOM: f64 = 1.1;
/// Minimum of the largest computed amplitude, rad.
const LEAST: f64 = 0.05;

impl<'a> Swings<'a> {
    pub(super) fn new(plan: &'a SwingPlan) -> Result<Self, IdentifyError> {
        let mut tests = Vec::new();
        for test in plan.tests() {
            let look = test.measurement.look()?;
            let seen = look.amplitudes[0].max(look.amplitudes[1]);
            let most = test.rig.most();
            IdentifyError::require(
                "an amplitude, rad",
                seen,
                seen > 0.0 && seen <= most,
                "above zero, and at most 1.75 on wires or 2.97 about an axis",
            )?;
            let amplitudes = Amplitudes::up_to((ROOM * seen).max(LEAST).min(most));
            tests.push(Prepared {
                test,
                look,
                amplitudes,
                last: RefCell::default(),
                sought: RefCell::default(),
            });
        }
        Ok(Self { stage: Stage::Rates, tests, measured: plan.measured(), places: plan.places() })
    }

    /// Returns all numbers, given the estimated parameters.
    pub(super) fn all(&self, shared: &[f64]) -> Vec<f64> {
        let value =
            |(measured, place): (&Measured, &Option<usize>)| place.map_or(measured.value, |k| shared[k]);
        self.measured.iter().zip(&self.places).map(value).collect()
    }

    fn numbers(&self, shared: &[f64]) -> Numbers {
        Numbers::new(&self.all(shared), &self.places)
    }

    /// Returns the misfit of the small-oscillation rates to the observed ones: Σ (ln ω − ln
    /// ω_seen)².
    pub(super) fn misfit(&self, shared: &[f64]) -> Result<f64, IdentifyError> {
        let numbers = self.numbers(shared);
        let mut sum = 0.0;
        for prepared in self.tests.iter().filter(|prepared| prepared.test.body.is_some()) {
            let rate = prepared.test.oscillator(&numbers)?.rest().rate;
            sum += libm::log(rate / prepared.look.rate).powi(2);
        }
        Ok(sum)
    }

    /// Returns the initial local parameters of each group.
    pub(super) fn locals(&self) -> Vec<Vec<f64>> {
        let own = self.tests.iter().map(|prepared| match self.stage {
            Stage::Rates => Vec::new(),
            Stage::All => prepared.own(),
        });
        [Vec::new()].into_iter().chain(own).collect()
    }

    fn measured_rows(&self, shared: &[f64], rows: &mut Rows) {
        for (measured, place) in self.measured.iter().zip(&self.places) {
            if let Some(place) = *place
                && measured.sd.is_finite()
            {
                rows.begin_measurement();
                let (_, by) = rows.push((measured.value - shared[place]) / measured.sd);
                by[place] = 1.0 / measured.sd;
            }
        }
    }

    /// Clears derivatives by tensor elements without influence on a test. In the complete fit the
    /// selection is made at the start and kept, because an element that drifts would gain influence
    /// by its own error.
    fn without_what_is_nothing(&self, prepared: &Prepared, rows: &mut Rows, trace: f64) {
        let tensor = self.places[TENSOR].unwrap_or(0);
        let mut kept = prepared.sought.borrow_mut();
        let sought = match *kept {
            Some(sought) if self.stage == Stage::All => sought,
            _ => {
                let norms = &rows.shared_norms()[tensor..tensor + 6];
                let most = norms.iter().copied().fold(0.0, f64::max);
                let small = if self.stage == Stage::Rates { COARSE } else { SMALL };
                core::array::from_fn(|k| norms[k] * trace >= NOTHING && norms[k] >= small * most)
            }
        };
        *kept = (self.stage == Stage::All).then_some(sought);
        for (k, is_sought) in sought.into_iter().enumerate() {
            if !is_sought {
                rows.clear_shared(tensor + k);
            }
        }
    }
}

/// Writes derivatives in standard deviations.
fn write(by: &[f64], scale: f64, row: &mut [f64]) {
    row.iter_mut().zip(by).for_each(|(element, value)| *element = value * scale);
}

impl Prepared<'_> {
    fn family(&self, numbers: &Numbers) -> Result<Family, IdentifyError> {
        let oscillator = self.test.oscillator(numbers)?;
        let mut last = self.last.borrow_mut();
        let rate = oscillator.rest().rate;
        let is_near = (last.0 / rate - 1.0).abs() < NEARBY;
        let guesses = if is_near { last.1.as_slice() } else { &[] };
        let solved = Family::new(oscillator.as_ref(), &self.amplitudes, guesses)
            .or_else(|_| Family::new(oscillator.as_ref(), &self.amplitudes, &[]));
        let (family, motions) = solved?;
        *last = (rate, motions);
        Ok(family)
    }

    /// Returns the initial A₀; for a log also φ₀ and the zero; then a and β if present.
    fn own(&self) -> Vec<f64> {
        let Look { rate, amplitudes: [first, last], duration, phase, middle, .. } = self.look;
        let damping = self.test.measurement.damping();
        let mut all = vec![first];
        if matches!(self.test.measurement, Measurement::Logged(_)) {
            all.extend([phase, middle]);
        }
        let fall = if duration > 0.0 { libm::log(first / last).max(0.0) / duration } else { 0.0 };
        let share = if damping.count() == 2 { 0.5 * fall } else { fall };
        if damping.is_viscous() {
            all.push(share);
        }
        if damping.is_quadratic() {
            let mean = (first * last).sqrt();
            all.push(share * 0.75 * PI / (rate * mean));
        }
        all
    }

    fn decay(&self, own: &[f64]) -> Decay {
        let damping = self.test.measurement.damping();
        let mut rest = own[own.len() - damping.count()..].iter().copied();
        let viscous = if damping.is_viscous() { rest.next().unwrap_or(0.0) } else { 0.0 };
        Decay { amplitude: own[0], viscous, quadratic: rest.next().unwrap_or(0.0) }
    }

    /// Writes derivatives by amplitude, a and β into the row of local parameters.
    fn write_own(&self, by: &[f64], scale: f64, row: &mut [f64]) {
        let damping = self.test.measurement.damping();
        row[0] = by[0] * scale;
        let first = row.len() - damping.count();
        let kept = [(damping.is_viscous(), by[1]), (damping.is_quadratic(), by[2])];
        for (element, (_, value)) in row[first..].iter_mut().zip(kept.iter().filter(|(is, _)| *is)) {
            *element = value * scale;
        }
    }
}

impl Problem for Swings<'_> {
    fn groups(&self) -> usize {
        1 + self.tests.len()
    }

    fn rows(
        &self,
        group: usize,
        shared: &[f64],
        local: &[f64],
        rows: &mut Rows,
    ) -> Result<(), IdentifyError> {
        let Some(group) = group.checked_sub(1) else {
            self.measured_rows(shared, rows);
            return Ok(());
        };
        let prepared = &self.tests[group];
        let numbers = self.numbers(shared);
        let family = prepared.family(&numbers)?;
        let trace: f64 = (0..3).map(|k| numbers.at(TENSOR + k).value).sum();
        let to = Target { prepared, family: &family };
        match (self.stage, &prepared.test.measurement) {
            (Stage::Rates, _) => to.rate(rows),
            (Stage::All, Measurement::Counted(counted)) => to.counted(counted, local, rows)?,
            (Stage::All, Measurement::Logged(logged)) => to.logged(logged, local, rows)?,
        }
        self.without_what_is_nothing(prepared, rows, trace);
        Ok(())
    }
}

/// Test whose rows are written.
struct Target<'a> {
    prepared: &'a Prepared<'a>,
    family: &'a Family,
}

impl Target<'_> {
    fn rate(&self, rows: &mut Rows) {
        let look = &self.prepared.look;
        let amplitude = (look.amplitudes[0] * look.amplitudes[1]).sqrt();
        let rate = self.family.rate(&self.family.at(amplitude));
        rows.begin_measurement();
        let (_, by) = rows.push(libm::log(look.rate / rate.value) / look.relative);
        write(&rate.by, 1.0 / (rate.value * look.relative), by);
    }

    fn counted(&self, counted: &Counted, own: &[f64], rows: &mut Rows) -> Result<(), IdentifyError> {
        let counts = counted.intervals.iter().map(|i| i.to).chain(counted.amplitudes.iter().map(|r| r.at));
        let end = TAU * counts.fold(0.0, f64::max);
        let course = Course::new(self.family, self.prepared.decay(own), Clock::Phase, end)?;
        let at = |count: f64| course.at(TAU * count);
        for interval in &counted.intervals {
            let (from, to) = (at(interval.from), at(interval.to));
            let by: Vec<f64> = to.other_by.iter().zip(&from.other_by).map(|(a, b)| a - b).collect();
            self.push(rows, interval.time - (to.other - from.other), interval.sd, &by);
        }
        for reading in &counted.amplitudes {
            let here = at(reading.at);
            self.push(rows, reading.amplitude - here.amplitude, reading.sd, &here.amplitude_by);
        }
        Ok(())
    }

    fn push(&self, rows: &mut Rows, residual: f64, sd: f64, by: &[f64]) {
        rows.begin_measurement();
        let (own, shared) = rows.push(residual / sd);
        self.prepared.write_own(by, 1.0 / sd, own);
        write(&by[OWN..], 1.0 / sd, shared);
    }

    fn logged(&self, logged: &Logged, own: &[f64], rows: &mut Rows) -> Result<(), IdentifyError> {
        let (begin, total) = (logged.times[0], logged.times.len());
        let end = logged.times[total - 1] - begin;
        let decay = self.prepared.decay(own);
        let course = Course::new(self.family, decay, Clock::Time, end)?;
        for (&time, &value) in logged.times.iter().zip(&logged.values) {
            let here = course.at(time - begin);
            let signal = self.signal(logged.signal, &here, own[1], decay);
            let by: Vec<f64> = (0..here.other_by.len())
                .map(|k| {
                    let explicit = if k < OWN { signal.by_decay[k] } else { signal.by[k - OWN] };
                    signal.by_amplitude * here.amplitude_by[k] + signal.by_phase * here.other_by[k] + explicit
                })
                .collect();
            let residual = value - own[2] - signal.value;
            self.push(rows, residual, logged.sd, &by);
            // Derivatives by the initial phase and the zero.
            let (row, _) = rows.last();
            row[1] = signal.by_phase / logged.sd;
            row[2] = 1.0 / logged.sd;
        }
        Ok(())
    }

    /// Returns `θ = Σ c_k cos kφ`, or its rate `−ω Σ k c_k sin kφ`, plus the effect of damping on
    /// the shape.
    fn signal(&self, signal: Signal, here: &Point, phase: f64, decay: Decay) -> Predicted {
        let at = self.family.at(here.amplitude);
        let phase = phase + here.other;
        let harmonics = self.family.harmonics(&at);
        let rate = self.family.rate(&at);
        let mut sum = Predicted::nothing(rate.by.len());
        for (k, c) in harmonics.iter().enumerate() {
            let n = k as f64;
            let (sin, cos) = libm::sincos(n * phase);
            let (shape, shape_slope) = match signal {
                Signal::Angle => (cos, -n * sin),
                Signal::Rate => (-n * sin, -n * n * cos),
            };
            sum.value += c.value * shape;
            sum.by_amplitude += c.slope * shape;
            sum.by_phase += c.value * shape_slope;
            sum.by.iter_mut().zip(&c.by).for_each(|(a, b)| *a += b * shape);
        }
        if signal == Signal::Rate {
            sum.by.iter_mut().zip(&rate.by).for_each(|(a, b)| *a = *a * rate.value + sum.value * b);
            sum.by_amplitude = sum.by_amplitude * rate.value + sum.value * rate.slope;
            sum.by_phase *= rate.value;
            sum.value *= rate.value;
        }
        sum.damped(signal, here.amplitude, phase, rate.value, decay);
        sum
    }
}

/// Predicted signal, with its derivatives by amplitude, phase, decay parameters and shared
/// parameters.
struct Predicted {
    value: f64,
    by_amplitude: f64,
    by_phase: f64,
    by_decay: [f64; OWN],
    by: Vec<f64>,
}

impl Predicted {
    fn nothing(count: usize) -> Self {
        Self { value: 0.0, by_amplitude: 0.0, by_phase: 0.0, by_decay: [0.0; OWN], by: vec![0.0; count] }
    }

    /// Adds the first-order effect of damping on the shape of a harmonic motion.
    ///
    /// The angle gains β A² Σ g_n sin nφ with g_n = 8/(π n (n² − 1) (n² − 4)), n = 3, 5 … The rate
    /// gains its derivative and dA/dt cos φ, with dA/dt = −a A − (4/3π) β ω A².
    fn damped(&mut self, signal: Signal, amplitude: f64, phase: f64, rate: f64, decay: Decay) {
        let square = amplitude * amplitude;
        for n in [3.0, 5.0, 7.0, 9.0, 11.0] {
            let size = 8.0 / (PI * n * (n * n - 1.0) * (n * n - 4.0));
            let (sin, cos) = libm::sincos(n * phase);
            let (shape, shape_slope) = match signal {
                Signal::Angle => (size * sin, size * n * cos),
                Signal::Rate => (rate * size * n * cos, -rate * size * n * n * sin),
            };
            self.value += decay.quadratic * square * shape;
            self.by_amplitude += 2.0 * decay.quadratic * amplitude * shape;
            self.by_phase += decay.quadratic * square * shape_slope;
            self.by_decay[2] += square * shape;
        }
        if signal == Signal::Rate {
            let (sin, cos) = libm::sincos(phase);
            let quadratic = 4.0 / (3.0 * PI) * rate * square;
            self.value -= (decay.viscous * amplitude + decay.quadratic * quadratic) * cos;
            self.by_amplitude -= (decay.viscous + 2.0 * decay.quadratic * quadratic / amplitude) * cos;
            self.by_phase += (decay.viscous * amplitude + decay.quadratic * quadratic) * sin;
            self.by_decay[1] -= amplitude * cos;
            self.by_decay[2] -= quadratic * cos;
        }
    }
}
