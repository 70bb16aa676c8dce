//! Phases: rolling, sliding and flying, each with its equations and with what ends it.

use super::equations::{Kinetics, Pivot, Regime};
use super::flight;
use super::law::{ContactLaw, Grip};
use super::model::{GroundForm, Model, SurfaceForm};
use super::smooth::Smooth;
use crate::math::algebra::{Components, Field};
use crate::math::root::vanishing;
use crate::motion::solve::collocation::{Collocation, ROOM};
use crate::motion::solve::propagate::stepper::TIGHTEST_TOLERANCE;
use crate::motion::solve::series::{Expansion, System};

/// Which equations hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Touching(Regime, Pivot),
    Flying,
}

/// A function that is positive as long as a phase goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Watch {
    /// N
    NormalForce,
    /// µₛ² N² − F_t²
    Grip,
    /// |u|
    SlipSpeed,
    /// What N is divided by.
    Inertance,
    /// The rate at which the body turns about the normal, in its sense.
    Turning,
    /// µₚ² N² − τₚ²
    Holding,
    /// |ω_t|
    RollingRate,
    /// How much the rim that is touched is lower than the other one.
    OtherRim,
    /// How much the axis of a rim is off the normal, less what counts as nothing.
    Slope,
    /// (½ N l)² less the square of the torque that keeps the axis level.
    Ends,
    /// The determinant of 1 + r′K.
    Fit,
    /// The distance from the ground.
    Gap,
}

/// The slope of a disk, and the room between curvatures, that counts as none.
const LEAST: f64 = 1e-8;

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

/// What a phase is a phase of.
#[derive(Clone, Copy, Debug)]
pub(super) struct PhaseModel<'a> {
    pub(super) model: &'a Model,
    pub(super) law: &'a ContactLaw,
    /// Of a cylinder that lies, if it has ends.
    pub(super) length: Option<f64>,
}

impl Phase {
    pub(super) fn new(of: PhaseModel<'_>, kind: Kind, tolerance: f64) -> Self {
        let PhaseModel { model, law, length } = of;
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

    /// From a state at a time, `since` the start of the step before: the length of the step, `stretch` times as long as it would be. The variables and what is watched are
    /// measured with `sizes`.
    pub(super) fn about(
        &mut self,
        of: PhaseModel<'_>,
        state: &[f64],
        sizes: [&[f64]; 2],
        [time, since, stretch]: [f64; 3],
    ) -> f64 {
        match (&mut self.solution, self.kind) {
            (Solution::Collocation(collocation), Kind::Touching(regime, pivot)) => {
                let system = Smooth { of, regime, pivot, watches: &self.watches };
                collocation.about(&system, state, sizes[0], [time, since, stretch])
            }
            (Solution::Series(expansion), _) => stretch * expansion.about(state, sizes),
            (Solution::Collocation(_), Kind::Flying) => f64::NAN,
        }
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

    /// How many evaluations or coefficients the last step took.
    pub(super) fn work(&self) -> u64 {
        match &self.solution {
            Solution::Collocation(collocation) => collocation.evaluations(),
            Solution::Series(expansion) => expansion.terms(),
        }
    }
}

/// What may end a phase.
pub(super) fn watches(PhaseModel { model, law, length }: PhaseModel<'_>, kind: Kind) -> Vec<Watch> {
    let Kind::Touching(regime, pivot) = kind else { return vec![Watch::Gap] };
    let mut watches = vec![Watch::NormalForce];
    match regime {
        Regime::Rolling if *law.grip() != Grip::NoSlip => watches.push(Watch::Grip),
        Regime::Rolling => {}
        Regime::Sliding => {
            watches.push(Watch::Inertance);
            if model.kinetic != 0.0 {
                watches.push(Watch::SlipSpeed);
            }
        }
    }
    if model.pivoting != 0.0 {
        watches.push(if pivot == Pivot::Held { Watch::Holding } else { Watch::Turning });
    }
    if model.rolling != 0.0 {
        watches.push(Watch::RollingRate);
    }
    if matches!(model.surface, SurfaceForm::Rim { height, .. } if height != 0.0) {
        watches.push(Watch::OtherRim);
    }
    if model.axis_inertia.is_some() && length.is_some() {
        watches.push(Watch::Ends);
    }
    if matches!(model.surface, SurfaceForm::Rim { radius, .. } if radius != 0.0) {
        watches.push(Watch::Slope);
    }
    if model.ground != GroundForm::Plane {
        watches.push(Watch::Fit);
    }
    watches
}

impl Model {
    /// The value of what is watched.
    #[inline(always)]
    pub(super) fn watched<S: Field>(
        &self,
        one: S,
        at: &Kinetics<S>,
        watch: Watch,
        law: &ContactLaw,
        length: Option<f64>,
        pivot: Pivot,
    ) -> S {
        let n = at.normal;
        let (relative, force) = (at.relative, at.normal_force);
        match watch {
            Watch::NormalForce => force,
            Watch::Grip => {
                let most = law.friction().sticking;
                (force * force).times(most * most) - at.tangential.dot(at.tangential)
            }
            Watch::SlipSpeed => at.slip.dot(at.slip).root(),
            Watch::Inertance => at.inertance,
            Watch::Turning => match pivot {
                Pivot::Turning(sense) => relative.dot(n).times(sense),
                Pivot::Held => one,
            },
            Watch::Holding => (force * force).times(self.pivoting * self.pivoting) - at.holding * at.holding,
            Watch::RollingRate => {
                let along = relative - n * relative.dot(n);
                along.dot(along).root()
            }
            Watch::OtherRim => match self.surface {
                SurfaceForm::Rim { height, .. } => n.0[2].times(-height),
                SurfaceForm::Ellipsoid { .. } => one,
            },
            // Of a disk that falls straight over the root goes on through zero.
            Watch::Slope => (n.0[0] * n.0[0] + n.0[1] * n.0[1]).root() - one.times(LEAST),
            Watch::Ends => {
                let half = 0.5 * length.unwrap_or(f64::INFINITY);
                let level = self.leveling(one, at);
                (force * force).times(half * half) - level * level
            }
            Watch::Fit => at.fit,
            Watch::Gap => one,
        }
    }

    /// True of a rim whose axis is along the normal: where it touches the ground, rounding decides.
    pub(super) fn lies_flat(&self, at: &Kinetics<f64>) -> bool {
        let Components([x, y, _]) = at.normal;
        matches!(self.surface, SurfaceForm::Rim { radius, .. } if radius != 0.0) && x.hypot(y) <= LEAST
    }

    /// True where the ground is as curved as the body: rounding decides here too.
    pub(super) fn osculates(&self, at: &Kinetics<f64>) -> bool {
        self.ground != GroundForm::Plane && at.fit <= LEAST
    }

    /// The torque about z × n that keeps the axis of a cylinder level, beside that of a force in its middle.
    #[inline(always)]
    fn leveling<S: Field>(&self, one: S, at: &Kinetics<S>) -> S {
        let force = at.tangential + at.normal * at.normal_force;
        let needed = at.omega_rate.image(&self.inertia) + at.omega.cross(at.omega.image(&self.inertia))
            - at.arm.cross(force);
        let zero = one.times(0.0);
        Components([zero, zero, one]).cross(at.normal).dot(needed)
    }
}
