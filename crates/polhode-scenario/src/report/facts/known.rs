//! Results of the core for one motion, gathered once.

use std::borrow::Cow;

use polhode::body::PrincipalFrame;
use polhode::math::{AngularMomentum, Body, Space};
use polhode::motion::{
    HeavyTop, MassHistory, ParticleForce, Pendulum, Prescribed, Required, Rotor, Sample, Scenario, State,
    Swing, Trajectory,
};
use polhode::observe::{Cones, Drift, SymmetricTop};

use super::heavy_top;
use crate::report::free_facts::FreeFacts;

/// Results of the core that the reports of one motion use.
#[derive(Clone, Debug)]
pub(crate) struct Known<'a> {
    /// `None` if only the moments of the body are known.
    pub scenario: Option<&'a Scenario>,
    pub trajectory: &'a Trajectory,
    /// Rotor at the first sample if the body changes; `None` without a scenario.
    pub rotor: Option<Cow<'a, Rotor>>,
    pub principal: PrincipalFrame<Body>,
    /// State at the first sample, or the start of the scenario for a trajectory without samples.
    pub start: State,
    /// T at the start about the point that the body turns about, J.
    pub kinetic_energy: f64,
    /// L at the start about the same point, space axes, kg·m²/s.
    pub momentum: AngularMomentum<Space>,
    /// Free motion from the same start without torque.
    pub at_start: Option<FreeFacts>,
    /// True if only the inertia of the body determines the motion.
    pub is_free: bool,
    /// Constants of a free symmetric top.
    pub top: Option<Top>,
    /// Drift of conserved quantities; `None` for a prescribed motion, for which no equation is
    /// solved.
    pub drift: Option<Drift>,
    pub needed: Option<Needed>,
    pub hanging: Option<(Pendulum, Swing)>,
    pub heavy_top: Option<HeavyTop>,
}

/// Free symmetric top, its cones, and the largest deviation of L, ω and the axis from one plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Top {
    pub motion: SymmetricTop,
    pub cones: Cones,
    pub coplanarity: f64,
}

/// Torque and forces that a prescribed motion needs.
#[derive(Clone, Debug)]
pub(crate) struct Needed {
    pub at_start: Required,
    /// Sample with the largest torque.
    pub largest: Option<Sample>,
    /// Force on each particle at the start; empty unless the body consists of particles only.
    pub forces: Vec<ParticleForce>,
}

impl<'a> Known<'a> {
    pub(crate) fn of(scenario: &'a Scenario, trajectory: &'a Trajectory) -> Self {
        let start = trajectory.samples().first().map_or(scenario.start(), |sample| sample.state);
        let then = |history: &MassHistory| history.rotor(start.time, scenario.pivot()).ok();
        let rotor = scenario.history().and_then(then).map_or(Cow::Borrowed(scenario.rotor()), Cow::Owned);
        let prescribed = scenario.prescribed();
        let is_free = scenario.is_free();
        let at_start = FreeFacts::from_start(&rotor, start);
        let free = at_start.filter(|_| is_free);
        Self {
            scenario: Some(scenario),
            trajectory,
            principal: *rotor.principal(),
            kinetic_energy: rotor.kinetic_energy(start.omega),
            momentum: rotor.angular_momentum_space(&start),
            at_start,
            top: free.and_then(|free| Top::of(free.top?, trajectory)),
            rotor: Some(rotor),
            start,
            is_free,
            drift: prescribed.is_none().then(|| Drift::of(trajectory)).flatten(),
            needed: prescribed.and_then(|motion| Needed::by(scenario, motion, trajectory)),
            hanging: scenario.pendulum().and_then(Result::ok).map(|p| (p, swing(scenario, &p, &start))),
            heavy_top: heavy_top::of(scenario, start),
        }
    }

    /// Returns the motion of a free body of which only the moments are known.
    pub(crate) fn of_moments(
        principal: &PrincipalFrame<Body>,
        free: Option<FreeFacts>,
        trajectory: &'a Trajectory,
    ) -> Self {
        let start = trajectory.start();
        Self {
            scenario: None,
            trajectory,
            rotor: None,
            principal: *principal,
            start: start.state,
            kinetic_energy: start.kinetic_energy,
            momentum: start.momentum,
            at_start: free,
            is_free: true,
            top: free.and_then(|free| Top::of(free.top?, trajectory)),
            drift: Drift::of(trajectory),
            needed: None,
            hanging: None,
            heavy_top: None,
        }
    }

    /// Returns the free motion; `None` if other causes act.
    pub(crate) fn free(&self) -> Option<&FreeFacts> {
        self.at_start.as_ref().filter(|_| self.is_free)
    }

    /// Returns the name of the reference point of L and T.
    pub(crate) fn about(&self) -> &'static str {
        if self.rotor.as_ref().is_some_and(|rotor| rotor.is_pivoted()) { "pivot" } else { "centre of mass" }
    }

    /// Returns the first and last sample; `None` without samples.
    pub(crate) fn ends(&self) -> Option<[&'a Sample; 2]> {
        let samples = self.trajectory.samples();
        Some([samples.first()?, samples.last()?])
    }

    /// Returns the time of the last sample, or else of the start, s.
    pub(crate) fn end_time(&self) -> f64 {
        self.ends().map_or(self.start.time, |[_, last]| last.state.time)
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
    /// Returns true if some later torque is larger than that at the start.
    pub(crate) fn is_larger_later(&self) -> bool {
        let at_start = self.at_start.torque.norm();
        self.largest.is_some_and(|largest| is_larger(largest.torque.norm(), at_start))
    }

    /// Returns the size of the terms of N = I ω̇ + ω × L, N·m.
    pub(crate) fn scale(&self) -> f64 {
        let largest =
            self.largest.map_or(0.0, |s| f64::max(s.torque.norm(), s.momentum.norm() * s.state.omega.norm()));
        largest.max(torque_scale(&self.at_start))
    }

    fn by(scenario: &Scenario, motion: &Prescribed, trajectory: &Trajectory) -> Option<Self> {
        let rotor = scenario.rotor();
        let time = trajectory.samples().first().map_or(scenario.start().time, |sample| sample.state.time);
        // The start of a computed trajectory is finite.
        let at_start = Required::of_motion(rotor, motion, time).ok()?;
        let larger = |a: &&Sample, b: &&Sample| a.torque.norm().total_cmp(&b.torque.norm());
        Some(Self {
            at_start,
            largest: trajectory.samples().iter().max_by(larger).copied(),
            forces: crate::report::forces::on_particles(scenario, &at_start),
        })
    }
}

/// Returns the size of the terms of N = I ω̇ + ω × L at a time, N·m.
pub(crate) fn torque_scale(needed: &Required) -> f64 {
    f64::max(needed.torque.norm(), needed.momentum.norm() * needed.state.omega.norm())
}

/// Returns true if a value of a run exceeds that at the start by more than rounding.
pub(crate) fn is_larger(later: f64, at_start: f64) -> bool {
    later > at_start * (1.0 + 1e-9)
}

/// Returns the swing with the amplitude of the scenario, or else with that of its start.
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
