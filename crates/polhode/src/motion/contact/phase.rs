//! Phases: rolling, sliding and flying, each with its equations and with what ends it.

use super::flight;
use super::model::Model;
use super::smooth::Smooth;
use super::watch::{Kind, Sides, Watch, watches};
use crate::math::root::vanishing;
use crate::motion::solve::collocation::{Collocation, ROOM, StepWork, Wanted};
use crate::motion::solve::limits::TIGHTEST_TOLERANCE;
use crate::motion::solve::series::{Expansion, System};

/// The first step of a phase, times a rate of its motion.
const FIRST_STEP: f64 = 0.1;

/// How a phase is worked out: where it is smooth by collocation, and else by Taylor series, which go on analytically where a root has its zero.
#[derive(Clone, Debug)]
enum Solution {
    Collocation(Box<Collocation>),
    Series(Expansion),
}

/// A phase, with room for its solution.
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
        // The direction of a slip has all the digits of the slip, however small that is.
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

    /// Begins anew; `rate` is one of the motion.
    pub(super) fn begin(&mut self, rate: f64) {
        if let Solution::Collocation(collocation) = &mut self.solution {
            collocation.begin(FIRST_STEP / rate);
        }
    }

    /// From a state: the length of the step. The variables and what is watched are measured with `sizes`.
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

    /// True of collocation: the end of a step has more digits than what is within it.
    pub(super) const fn is_collocation(&self) -> bool {
        matches!(self.solution, Solution::Collocation(_))
    }

    /// A motion that is known otherwise, by the coefficients of the variables and of what is watched.
    pub(super) fn impose(&mut self, variables: &[Vec<f64>], outputs: &[Vec<f64>]) {
        if let Solution::Series(expansion) = &mut self.solution {
            expansion.impose(variables, outputs);
        }
    }

    /// The changes of the variables since the start of the step.
    pub(super) fn changes(&self, t: f64) -> [f64; ROOM] {
        match &self.solution {
            Solution::Collocation(collocation) => collocation.changes(t),
            Solution::Series(expansion) => {
                core::array::from_fn(|k| if k < self.count { expansion.change(t, k) } else { 0.0 })
            }
        }
    }

    /// The variables t after the start of the step.
    pub(super) fn variables(&self, t: f64) -> Vec<f64> {
        let changes = self.changes(t);
        let start = |k: usize| match &self.solution {
            Solution::Collocation(collocation) => collocation.start(k),
            Solution::Series(expansion) => expansion.variable(0.0, k),
        };
        (0..self.count).map(|k| start(k) + changes[k]).collect()
    }

    /// When in a step of length h what is watched vanishes, if it does.
    pub(super) fn vanishing(&self, k: usize, h: f64) -> Option<f64> {
        match &self.solution {
            Solution::Collocation(collocation) if collocation.keeps_its_sign(k) => None,
            Solution::Collocation(collocation) => vanishing(|t| collocation.output(t, k), h),
            Solution::Series(expansion) => vanishing(|t| expansion.output(t, k), h),
        }
    }

    /// What the step cost: evaluations, or the coefficients of its series.
    pub(super) fn take_work(&mut self) -> StepWork {
        match &mut self.solution {
            Solution::Collocation(collocation) => collocation.take_work(),
            Solution::Series(expansion) => StepWork { evaluations: expansion.terms(), rejected: 0 },
        }
    }
}
