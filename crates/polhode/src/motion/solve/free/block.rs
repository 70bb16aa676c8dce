//! States side by side, in the lanes of vectors: from their times to rows in stages.

use crate::math::lanes::Lanes;
use crate::math::rotation::Rotation;
use crate::math::vector::Vector;
use crate::motion::model::state::State;

use super::flow::{Phases, Stages, ThetaArgument, UnnormalisedState};
use crate::motion::solve::phase::Phase;

/// States in a group: a vector of AVX-512, two of AVX2.
pub(super) const WIDTH: usize = 8;

pub(super) type Vectors = Lanes<WIDTH>;

/// The stages of some groups of states.
///
/// Each is a loop of its own, so short that the processor is in several of its turns at once: in one long loop it would wait, as every
/// number of a state waits for the one before.
pub(super) struct Block<const GROUPS: usize> {
    phases: [Phases<Vectors>; GROUPS],
    argument: [ThetaArgument<Vectors>; GROUPS],
    unnormalised: [UnnormalisedState<Vectors>; GROUPS],
    attitude: [[Vectors; 4]; GROUPS],
    omega: [[Vectors; 3]; GROUPS],
}

impl<const GROUPS: usize> Block<GROUPS> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        let zero = Lanes([0.0; WIDTH]);
        Self {
            phases: [Phases::of(zero); GROUPS],
            argument: [ThetaArgument::of(zero); GROUPS],
            unnormalised: [UnnormalisedState::of(zero); GROUPS],
            attitude: [[zero; 4]; GROUPS],
            omega: [[zero; 3]; GROUPS],
        }
    }

    /// The phases of so many groups.
    #[inline(always)]
    pub(super) fn start(&mut self, groups: usize, phases: impl Fn(usize) -> Phases<Vectors>) {
        for (g, place) in self.phases.iter_mut().enumerate().take(groups) {
            *place = phases(one(g));
        }
    }

    /// As [`Block::start`], one phase after the other.
    #[inline(always)]
    pub(super) fn start_apart(
        &mut self,
        groups: usize,
        polhode: impl Fn(usize) -> Phase<Vectors>,
        precession: impl Fn(usize) -> Phase<Vectors>,
    ) {
        for (g, phases) in self.phases.iter_mut().enumerate().take(groups) {
            phases.polhode = polhode(one(g));
        }
        for (g, phases) in self.phases.iter_mut().enumerate().take(groups) {
            phases.precession = precession(one(g));
        }
    }

    /// The states of the phases.
    #[inline(always)]
    pub(super) fn finish<S: Stages<Vectors>>(&mut self, groups: usize, stages: impl Fn(usize) -> S) {
        for (g, argument) in self.argument.iter_mut().enumerate().take(groups) {
            *argument = stages(one(g)).theta_argument(&self.phases[g]);
        }
        for (g, unnormalised) in self.unnormalised.iter_mut().enumerate().take(groups) {
            *unnormalised = stages(one(g)).unnormalised(&self.argument[g]);
        }
        for (g, unnormalised) in self.unnormalised.iter().enumerate().take(groups) {
            (self.attitude[g], self.omega[g]) = stages(one(g)).state(unnormalised);
        }
    }

    /// One of the states.
    #[inline(always)]
    pub(super) fn state(&self, group: usize, lane: usize, time: f64) -> State {
        let (attitude, omega) = self.rows(group, lane);
        State { time, attitude: Rotation::from_unit(attitude), omega: Vector::from_array(omega) }
    }

    /// Its quaternion and ω.
    #[inline(always)]
    pub(super) fn rows(&self, group: usize, lane: usize) -> ([f64; 4], [f64; 3]) {
        let ([qw, qx, qy, qz], [wx, wy, wz]) = (&self.attitude[group], &self.omega[group]);
        let attitude = [qw.0[lane], qx.0[lane], qy.0[lane], qz.0[lane]];
        (attitude, [wx.0[lane], wy.0[lane], wz.0[lane]])
    }
}

/// The group itself. The compiler is not to see that the next is beside it, or it makes vectors across groups, lane by lane.
#[inline(always)]
pub(super) fn one(group: usize) -> usize {
    core::hint::black_box(());
    group
}
