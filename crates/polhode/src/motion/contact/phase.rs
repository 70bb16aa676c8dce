//! Phases of a contact: rolling, sliding and flying, each with its equations and the functions that
//! end it.

use super::flight;
use super::model::Model;
use super::smooth::Smooth;
use super::watch::{Kind, Sides, Watch, watches};
use crate::math::root::vanishing;
use crate::motion::solve::collocation::{Collocation, ROOM, StepWork, Wanted};
use crate::motion::solve::limits::TIGHTEST_TOLERANCE;
use crate::motion::solve::series::{Expansion, System};

/// First step of a phase times the rate of the motion.
const FIRST_STEP: f64 = 0.1;

/// Solver of a phase: collocation for smooth equations, otherwise Taylor series, which continue a
/// root analytically through its zero.
#[derive(Clone, Debug)]
enum Solution {
    Collocation(Box<Collocation>),
    Series(Expansion),
}

/// Phase, with memory for its solution.
#[derive(Clone, Debug)]
pub(super) struct Phase {
    pub(super) kind: Kind,
    pub(super) watches: Vec<Watch>,
    solution: Solution,
    count: usize,
}

impl Phase {
    pub(super) fn new(of: Sides<'_>, kind: Kind, tolerance: f64) -> Self {
        let Sides { model, law, length } = of;
        let watches = watches(of, kind);
        // The direction of a slip must be as accurate as the slip itself, however small it is.
        let tolerance = if watches.contains(&Watch::SlipSpeed) { TIGHTEST_TOLERANCE } else { tolerance };
        let series = |system| Solution::Series(Expansion::new(system, tolerance));
        let (count, solution) = match kind {
            Kind::Flying => {
                let system = System::record(flight::COUNT, |one, y| {
                    let (rates, gap) = model.flight(one, y);
                    [rates, vec![gap]]
                });
                (flight::COUNT, series(system))
            }
            Kind::Touching(regime, pivot) if model.is_smooth(regime) => {
                let system = Smooth { of, regime, pivot, watches: &watches };
                (Model::count(regime), Solution::Collocation(Box::new(Collocation::new(&system, tolerance))))
            }
            Kind::Touching(regime, pivot) => {
                let system = System::record(Model::count(regime), |one, y| {
                    let (rates, at) = model.rates(one, y, regime, pivot);
                    let value = |watch: &Watch| model.watched(one, &at, *watch, law, length, pivot);
                    [rates, watches.iter().map(value).collect()]
                });
                (Model::count(regime), series(system))
            }
        };
        Self { kind, watches, solution, count }
    }

    /// Restarts the phase; `rate` is a rate of the motion.
    pub(super) fn begin(&mut self, rate: f64) {
        if let Solution::Collocation(collocation) = &mut self.solution {
            collocation.begin(FIRST_STEP / rate);
        }
    }

    /// Computes a step from a state and returns its length. `sizes` are the scales of the variables
    /// and of the watched functions.
    pub(super) fn about(&mut self, of: Sides<'_>, state: &[f64], sizes: [&[f64]; 2], wanted: Wanted) -> f64 {
        match (&mut self.solution, self.kind) {
            (Solution::Collocation(collocation), Kind::Touching(regime, pivot)) => {
                let system = Smooth { of, regime, pivot, watches: &self.watches };
                collocation.about(&system, state, sizes[0], wanted)
            }
            (Solution::Series(expansion), _) => wanted.stretch * expansion.about(state, sizes),
            (Solution::Collocation(_), Kind::Flying) => f64::NAN,
        }
    }

    /// True for collocation, whose solution is more accurate at the end of a step than within it.
    pub(super) const fn is_collocation(&self) -> bool {
        matches!(self.solution, Solution::Collocation(_))
    }

    /// Sets a known motion by the coefficients of the variables and of the watched functions.
    pub(super) fn impose(&mut self, variables: &[Vec<f64>], outputs: &[Vec<f64>]) {
        if let Solution::Series(expansion) = &mut self.solution {
            expansion.impose(variables, outputs);
        }
    }

    /// Returns the changes of the variables since the start of the step.
    pub(super) fn changes(&self, t: f64) -> [f64; ROOM] {
        match &self.solution {
            Solution::Collocation(collocation) => collocation.changes(t),
            Solution::Series(expansion) => {
                core::array::from_fn(|k| if k < self.count { expansion.change(t, k) } else { 0.0 })
            }
        }
    }

    /// Returns the variables at time t after the start of the step.
    pub(super) fn variables(&self, t: f64) -> Vec<f64> {
        let changes = self.changes(t);
        let start = |k: usize| match &self.solution {
            Solution::Collocation(collocation) => collocation.start(k),
            Solution::Series(expansion) => expansion.variable(0.0, k),
        };
        (0..self.count).map(|k| start(k) + changes[k]).collect()
    }

    /// Returns the time within a step of length h at which watched function k vanishes, if it does.
    pub(super) fn vanishing(&self, k: usize, h: f64) -> Option<f64> {
        match &self.solution {
            Solution::Collocation(collocation) if collocation.keeps_its_sign(k) => None,
            Solution::Collocation(collocation) => vanishing(|t| collocation.output(t, k), h),
            Solution::Series(expansion) => vanishing(|t| expansion.output(t, k), h),
        }
    }

    /// Returns the cost of the step: evaluations, or the coefficients of its series.
    pub(super) fn take_work(&mut self) -> StepWork {
        match &mut self.solution {
            Solution::Collocation(collocation) => collocation.take_work(),
            Solution::Series(expansion) => StepWork { evaluations: expansion.terms(), rejected: 0 },
        }
    }
}
