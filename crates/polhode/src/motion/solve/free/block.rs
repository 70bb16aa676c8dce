//! Evaluation of several states in SIMD lanes, in three stages: phases, theta functions, states.

use crate::math::lanes::Lanes;
use crate::math::rotation::Rotation;
use crate::math::vector::Vector;
use crate::motion::model::state::State;

use super::flow::{Phases, Stages, ThetaArgument, UnnormalisedState};
use crate::motion::solve::phase::Phase;

/// Number of states in a group: one AVX-512 vector, or two AVX2 vectors.
pub(super) const WIDTH: usize = 8;

pub(super) type Vectors = Lanes<WIDTH>;

/// Intermediate results of the stages for a few groups of states.
///
/// Each stage is a separate short loop, so that the processor overlaps several iterations. In one
/// long loop it would wait, because every number of a state depends on the previous one.
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

    /// Computes the phases of the first `groups` groups.
    #[inline(always)]
    pub(super) fn start(&mut self, groups: usize, phases: impl Fn(usize) -> Phases<Vectors>) {
        for (g, place) in self.phases.iter_mut().enumerate().take(groups) {
            *place = phases(one(g));
        }
    }

    /// Computes the phases like [`Block::start`], but with one loop for each of the two phases.
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

    /// Computes the states from the phases.
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

    /// Returns the state in one lane.
    #[inline(always)]
    pub(super) fn state(&self, group: usize, lane: usize, time: f64) -> State {
        let (attitude, omega) = self.rows(group, lane);
        State { time, attitude: Rotation::from_unit(attitude), omega: Vector::from_array(omega) }
    }

    /// Returns the quaternion (w, x, y, z) and ω of the state in one lane.
    #[inline(always)]
    pub(super) fn rows(&self, group: usize, lane: usize) -> ([f64; 4], [f64; 3]) {
        let ([qw, qx, qy, qz], [wx, wy, wz]) = (&self.attitude[group], &self.omega[group]);
        let attitude = [qw.0[lane], qx.0[lane], qy.0[lane], qz.0[lane]];
        (attitude, [wx.0[lane], wy.0[lane], wz.0[lane]])
    }
}

/// Returns `group` unchanged. The `black_box` hides from the compiler that groups are adjacent in
/// memory. Otherwise it would vectorise across groups, lane by lane.
#[inline(always)]
pub(super) fn one(group: usize) -> usize {
    core::hint::black_box(());
    group
}
