//! What a motion's reports say, gathered once from the core.

use std::borrow::Cow;

use polhode::motion::{
    MassHistory, ParticleForce, Pendulum, Prescribed, Required, Rotor, Sample, Scenario, State, Swing,
    Trajectory,
};
use polhode::observe::{Cones, Drift, SymmetricTop};

use crate::report::free_facts::FreeFacts;

/// Everything that is asked of the core for one motion.
#[derive(Clone, Debug)]
pub(crate) struct Facts<'a> {
    /// At the first sample too, if it changes.
    pub rotor: Cow<'a, Rotor>,
    /// At the first sample; that of the scenario if there is none.
    pub start: State,
    /// The free motion that the start would have without torque.
    pub at_start: Option<FreeFacts>,
    /// True if nothing but the body's own inertia decides the motion.
    pub is_free: bool,
    /// The constants of a free symmetric top.
    pub top: Option<Top>,
    /// `None` for a prescribed motion, where nothing is solved.
    pub drift: Option<Drift>,
    pub needed: Option<Needed>,
    pub hanging: Option<(Pendulum, Swing)>,
}

/// A free symmetric top, its cones, and how well L, ω and the axis keep to one plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Top {
    pub motion: SymmetricTop,
    pub cones: Cones,
    pub coplanarity: f64,
}

/// What a prescribed motion needs.
#[derive(Clone, Debug)]
pub(crate) struct Needed {
    pub at_start: Required,
    /// The sample with the largest torque.
    pub largest: Option<Sample>,
    /// On each particle at the start; empty unless particles are all that the body is made of.
    pub forces: Vec<ParticleForce>,
}

impl<'a> Facts<'a> {
    pub(crate) fn of(scenario: &'a Scenario, trajectory: &Trajectory) -> Self {
        let start = trajectory.samples().first().map_or(scenario.start(), |sample| sample.state);
        let then = |history: &MassHistory| history.rotor(start.time, scenario.pivot()).ok();
        let rotor = scenario.history().and_then(then).map_or(Cow::Borrowed(scenario.rotor()), Cow::Owned);
        let prescribed = scenario.prescribed();
        let is_free = scenario.is_free();
        let at_start = FreeFacts::from_start(&rotor, start);
        let free = at_start.filter(|_| is_free);
        Self {
            at_start,
            top: free.and_then(|free| Top::of(free.top?, trajectory)),
            rotor,
            start,
            is_free,
            drift: prescribed.is_none().then(|| Drift::of(trajectory)).flatten(),
            needed: prescribed.and_then(|motion| Needed::by(scenario, motion, trajectory)),
            hanging: scenario.pendulum().and_then(Result::ok).map(|p| (p, swing(scenario, &p, &start))),
        }
    }
}

impl Facts<'_> {
    /// The free motion, if it is one.
    pub(crate) fn free(&self) -> Option<&FreeFacts> {
        self.at_start.as_ref().filter(|_| self.is_free)
    }
}

impl Top {
    fn of((motion, cones): (SymmetricTop, Cones), trajectory: &Trajectory) -> Option<Self> {
        trajectory.samples().first()?;
        let departure = |s: &Sample| Cones::coplanarity(&motion, &s.state);
        let coplanarity = trajectory.samples().iter().map(departure).fold(0.0, f64::max);
        Some(Self { motion, cones, coplanarity })
    }
}

impl Needed {
    fn by(scenario: &Scenario, motion: &Prescribed, trajectory: &Trajectory) -> Option<Self> {
        let rotor = scenario.rotor();
        let time = trajectory.samples().first().map_or(scenario.start().time, |sample| sample.state.time);
        // A trajectory that was computed has a finite start.
        let at_start = Required::by(rotor, motion, time).ok()?;
        let larger = |a: &&Sample, b: &&Sample| a.torque.norm().total_cmp(&b.torque.norm());
        Some(Self {
            at_start,
            largest: trajectory.samples().iter().max_by(larger).copied(),
            forces: crate::report::forces::on_particles(scenario, &at_start),
        })
    }
}

/// The swing of the amplitude that the scenario asks for, else of its start.
fn swing(scenario: &Scenario, pendulum: &Pendulum, start: &State) -> Swing {
    let Some(hanging) = scenario.suspension() else { return Swing::Rest };
    match hanging.amplitude {
        Some(amplitude) => pendulum.swing(amplitude, 0.0),
        None => {
            let rate = hanging.axis.direction().map_or(0.0, |n| n.dot(start.omega));
            pendulum.swing(pendulum.angle(), rate)
        }
    }
}
