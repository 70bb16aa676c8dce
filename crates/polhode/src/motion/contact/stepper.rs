//! Steps along a phase, with compensated rounding of the variables.

use super::equations::{AXES, Kinetics, OMEGA, PLACE, Pivot, Regime, VELOCITY};
use super::flight::{CENTER, CENTER_RATE};
use super::law::ContactLaw;
use super::model::{GroundForm, Model};
use super::phase::Phase;
use super::watch::{Kind, Sides, Watch, watches};
use crate::math::algebra::Components;
use crate::math::sum::two_sum;
use crate::motion::solve::collocation::{StepWork, Wanted};
use crate::motion::solve::propagate::noise::{Random, StepNoise};

/// Integrator of a body on the ground.
#[derive(Clone, Debug)]
pub(super) struct Stepper {
    pub(super) model: Model,
    law: ContactLaw,
    length: Option<f64>,
    tolerance: f64,
    /// Size of the body, m.
    size: f64,
    /// Phases used so far, and the index of the current one.
    phases: Vec<Phase>,
    current: usize,
    /// Start time of the last step, and its length.
    begun: f64,
    step: f64,
    /// Variables at the end of the last step: high and low words.
    high: Vec<f64>,
    low: Vec<f64>,
    time: f64,
    /// Generator of the perturbation after each step, and its amplitude.
    noise: Option<(Random, f64)>,
    stretch: f64,
    /// Duration for which an imposed motion replaces the series.
    imposed: Option<f64>,
}

/// End of a phase, found in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Passing {
    /// Time since the start of the step, s.
    pub(super) after: f64,
    pub(super) watch: Watch,
}

impl Stepper {
    pub(super) fn new(
        model: Model,
        law: ContactLaw,
        length: Option<f64>,
        [size, tolerance]: [f64; 2],
        time: f64,
    ) -> Self {
        Self {
            model,
            law,
            length,
            tolerance,
            size,
            phases: Vec::new(),
            current: 0,
            begun: time,
            step: 0.0,
            high: Vec::new(),
            low: Vec::new(),
            time,
            noise: None,
            stretch: 1.0,
            imposed: None,
        }
    }

    /// Adds rounding noise to each step and changes the step size, for a comparison run.
    pub(super) fn perturbed(self, noise: Option<StepNoise>) -> Self {
        let Some(StepNoise { seed, amplitude, stretch }) = noise else { return self };
        Self { noise: Some((Random::new(seed), amplitude * f64::EPSILON)), stretch, ..self }
    }

    /// Continues with other equations, from these variables.
    pub(super) fn enter(&mut self, kind: Kind, variables: Vec<f64>) {
        let known = self.phases.iter().position(|phase| phase.kind == kind);
        self.current = known.unwrap_or_else(|| {
            self.phases.push(Phase::new(self.of(), kind, self.tolerance));
            self.phases.len() - 1
        });
        let rate = self.rate(&variables);
        self.phases[self.current].begin(rate);
        self.low = vec![0.0; variables.len()];
        self.high = variables;
        self.begun = self.time;
        self.step = 0.0;
        self.imposed = None;
    }

    /// Begins to slip from rolling, slowly at first; returns false if the onset cannot be computed.
    pub(super) fn begin_to_slip(&mut self, pivot: Pivot) -> bool {
        if self.step == 0.0 {
            return false;
        }
        let kind = Kind::Touching(Regime::Sliding, pivot);
        // Initial guess: it rolls on.
        let mut phase = self.phases[self.current].clone();
        let (sizes, watched) = (self.sizes_of(&self.high), self.sizes_of_watched());
        let wanted = self.wanted(self.step, f64::INFINITY, self.time);
        let longest = phase.about(self.of(), &self.high, [&sizes, &watched], wanted);
        let rolling = |t: f64| phase.variables(t);
        let watches = watches(self.of(), kind);
        let Some(onset) = self.onset(&rolling, pivot, longest, &watches) else { return false };
        let beginning = onset.variables.iter().map(|series| series[0]).collect();
        self.enter(kind, beginning);
        self.phases[self.current].impose(&onset.variables, &onset.outputs);
        self.imposed = Some(onset.duration);
        true
    }

    /// Returns the value of a watched function.
    pub(super) fn value(&self, at: &Kinetics<f64>, watch: Watch, pivot: Pivot) -> f64 {
        self.model.watched(1.0, at, watch, &self.law, self.length, pivot)
    }

    pub(super) fn kind(&self) -> Kind {
        self.phases[self.current].kind
    }

    /// True if the phase is computed by collocation, false if by Taylor series.
    pub(super) fn is_collocation(&self) -> bool {
        self.phases[self.current].is_collocation()
    }

    pub(super) const fn size(&self) -> f64 {
        self.size
    }

    pub(super) const fn law(&self) -> &ContactLaw {
        &self.law
    }

    /// Returns the functions that may end the phase.
    pub(super) fn watches(&self) -> &[Watch] {
        &self.phases[self.current].watches
    }

    /// Returns the cost of the last step: evaluations, or the coefficients of its series.
    pub(super) fn take_work(&mut self) -> StepWork {
        self.phases[self.current].take_work()
    }

    const fn of(&self) -> Sides<'_> {
        Sides { model: &self.model, law: &self.law, length: self.length }
    }

    pub(super) const fn time(&self) -> f64 {
        self.time
    }

    /// Returns the variables at the end of the last step.
    pub(super) fn variables(&self) -> &[f64] {
        &self.high
    }

    /// Returns the variables within the last step.
    pub(super) fn variables_at(&self, time: f64) -> Vec<f64> {
        if time == self.time {
            return self.high.clone();
        }
        let mut y = self.phases[self.current].variables(time - self.begun);
        self.normalise(&mut y);
        y
    }

    /// Returns the slip speed below which slip is rounding, m/s.
    pub(super) fn least_slip(&self, y: &[f64]) -> f64 {
        1e-13 * self.speed(y)
    }

    /// Returns the scale of velocities, m/s.
    pub(super) fn speed(&self, y: &[f64]) -> f64 {
        self.rate(y) * self.size
    }

    /// Returns the scale of angular rates, rad/s.
    pub(super) fn rate(&self, y: &[f64]) -> f64 {
        let [gx, gy, gz] = self.model.gravity;
        let falling = (gx.hypot(gy).hypot(gz) / self.size).sqrt();
        let omega = y[OMEGA].hypot(y[OMEGA + 1]).hypot(y[OMEGA + 2]);
        let rate = omega + falling + self.model.turning.abs();
        if rate > 0.0 { rate } else { 1.0 }
    }

    /// Computes the next step, at most until `end`, and returns its length; NaN if there is none.
    /// The solution before `first_look` is not needed, except at the end.
    pub(super) fn expand(&mut self, end: f64, first_look: f64) -> f64 {
        let since = self.step;
        self.begun = self.time;
        self.step = 0.0;
        if let Some(known) = self.imposed.take() {
            return known;
        }
        let sizes = self.sizes_of(&self.high);
        let watched = self.sizes_of_watched();
        let of = Sides { model: &self.model, law: &self.law, length: self.length };
        let wanted = self.wanted(since, end, first_look);
        let phase = &mut self.phases[self.current];
        phase.about(of, &self.high, [&sizes, &watched], wanted)
    }

    const fn wanted(&self, since: f64, end: f64, first_look: f64) -> Wanted {
        let most = if end > self.time { end - self.time } else { f64::INFINITY };
        Wanted { time: self.time, since, stretch: self.stretch, most, first_look }
    }

    /// Recomputes the step so that the tolerance also holds within it, and returns its length;
    /// `None` if it holds already.
    pub(super) fn refined(&mut self, end: f64) -> Option<f64> {
        self.phases[self.current].is_collocation().then(|| self.expand(end, self.time))
    }

    /// Shortens the step to end at `to`, as a step is most accurate at its end. Returns the end
    /// reached, which is earlier if this takes more than one step.
    pub(super) fn shorten(&mut self, to: f64, first_look: f64) -> f64 {
        if !self.phases[self.current].is_collocation() || !(to > self.time) {
            return to;
        }
        let reached = self.time + self.expand(to, first_look);
        if (to - reached).abs() <= 4.0 * f64::EPSILON * to.abs() { to } else { reached }
    }

    /// Returns the first end of the phase within h of the start of the step.
    pub(super) fn passing(&self, h: f64) -> Option<Passing> {
        let phase = &self.phases[self.current];
        let all = phase
            .watches
            .iter()
            .enumerate()
            .filter_map(|(k, &watch)| Some(Passing { after: phase.vanishing(k, h)?, watch }));
        all.reduce(|first, next| if next.after < first.after { next } else { first })
    }

    /// Takes the step, or a part of length h of it.
    pub(super) fn advance(&mut self, h: f64, to: f64) {
        let changes = self.phases[self.current].changes(h);
        for ((high, low), change) in self.high.iter_mut().zip(&mut self.low).zip(changes) {
            let before = high.abs();
            (*high, *low) = two_sum(*high, *low + change);
            if let Some((random, amplitude)) = &mut self.noise {
                *low += 0.5 * *amplitude * (before + high.abs()) * random.next();
            }
        }
        self.step = h;
        self.time = to;
        let mut y = core::mem::take(&mut self.high);
        self.normalise(&mut y);
        self.high = y;
    }

    /// Returns the value of a watched function at the end of the last step; `None` if it is not
    /// watched.
    pub(super) fn watched(&self, watch: Watch) -> Option<f64> {
        let phase = &self.phases[self.current];
        if !phase.watches.contains(&watch) {
            return None;
        }
        let at = self.kinetics(&self.high)?;
        let Kind::Touching(_, pivot) = phase.kind else { return None };
        Some(self.value(&at, watch, pivot))
    }

    /// Returns the quantities of the contact; `None` for a flying body.
    pub(super) fn kinetics(&self, y: &[f64]) -> Option<Kinetics<f64>> {
        match self.kind() {
            Kind::Touching(regime, pivot) => Some(self.model.kinetics(1.0, y, regime, pivot)),
            Kind::Flying => None,
        }
    }

    /// Returns the scale of each watched function. The gap of a flying body has its own
    /// singularities, those of the lowest point. Other functions have those of the variables, or
    /// end a step at their zero.
    fn sizes_of_watched(&self) -> Vec<f64> {
        let size = |watch: &Watch| if matches!(watch, Watch::Gap) { self.size } else { f64::INFINITY };
        self.watches().iter().map(size).collect()
    }

    /// Returns the scale of each variable.
    pub(super) fn sizes_of(&self, y: &[f64]) -> Vec<f64> {
        let rate = self.rate(y);
        let speed = rate * self.size;
        let mut sizes = vec![1.0; AXES + 6];
        sizes.extend([rate; 3]);
        let largest = |k: usize, least: f64| {
            let v = &y[k..k + 3];
            v.iter().fold(least, |size, x| size.max(x.abs()))
        };
        let works = match self.kind() {
            Kind::Flying => {
                sizes.extend([largest(CENTER, self.size); 3]);
                sizes.extend([largest(CENTER_RATE, speed); 3]);
                CENTER_RATE + 3
            }
            Kind::Touching(..) => {
                sizes.extend(match self.model.ground {
                    GroundForm::Plane => [self.size; 3],
                    GroundForm::Sphere { .. } => [1.0; 3],
                    GroundForm::Cylinder { .. } => [1.0, 1.0, self.size],
                });
                if y.len() > VELOCITY + 2 {
                    sizes.extend([largest(VELOCITY, speed); 3]);
                }
                sizes.len()
            }
        };
        sizes.resize(works, 1.0);
        let energy = self.model.mass * speed * speed;
        sizes.extend([energy; 2]);
        sizes
    }

    /// Corrects rounding: orthonormal axes, a unit normal, and a velocity tangential to the ground.
    fn normalise(&self, y: &mut [f64]) {
        const SMALL: f64 = 4.0 * f64::EPSILON;
        let vector = |y: &[f64], k: usize| Components([y[k], y[k + 1], y[k + 2]]);
        let (e1, e3) = (vector(y, AXES), vector(y, AXES + 3));
        let off = [e1.dot(e1) - 1.0, e3.dot(e3) - 1.0, e1.dot(e3)];
        if off.iter().any(|x| x.abs() > SMALL) {
            let e3 = e3.scaled(1.0 / e3.dot(e3).sqrt());
            let e1 = e1 - e3.scaled(e1.dot(e3));
            let e1 = e1.scaled(1.0 / e1.dot(e1).sqrt());
            y[AXES..AXES + 3].copy_from_slice(&e1.0);
            y[AXES + 3..AXES + 6].copy_from_slice(&e3.0);
        }
        if self.kind() == Kind::Flying {
            return;
        }
        let last = match self.model.ground {
            GroundForm::Plane => 0,
            GroundForm::Cylinder { .. } => 2,
            GroundForm::Sphere { .. } => 3,
        };
        let square: f64 = y[PLACE..PLACE + last].iter().map(|x| x * x).sum();
        if last > 0 && (square - 1.0).abs() > SMALL {
            let length = square.sqrt();
            y[PLACE..PLACE + last].iter_mut().for_each(|x| *x /= length);
        }
        if y.len() > VELOCITY + 2
            && let Some(at) = self.kinetics(y)
        {
            let off = at.slip.dot(at.normal);
            if off.abs() > f64::EPSILON * self.speed(y) {
                let v = vector(y, VELOCITY) - at.normal.scaled(off);
                y[VELOCITY..VELOCITY + 3].copy_from_slice(&v.0);
            }
        }
    }
}
