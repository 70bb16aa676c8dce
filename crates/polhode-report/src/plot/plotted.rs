//! What figures of a motion are drawn from.

use polhode::body::PrincipalFrame;
use polhode::math::Body;
use polhode::motion::{FreeMotion, Pointing, Sample, Solution, Trajectory, Wheel};

use crate::balance::Driven;

/// A motion, and what its figures ask of it.
#[derive(Clone, Debug)]
pub(super) struct PlottedMotion<'a> {
    pub(super) title: String,
    pub(super) trajectory: &'a Trajectory,
    /// About the point that the body turns about.
    pub(super) principal: PrincipalFrame<Body>,
    pub(super) free: Option<FreeMotion>,
    pub(super) driven: Driven,
    pub(super) wheels: Vec<(String, Wheel)>,
    pub(super) pointings: Vec<Pointing>,
}

impl<'a> PlottedMotion<'a> {
    pub(super) fn samples(&self) -> &'a [Sample] {
        self.trajectory.samples()
    }

    pub(super) fn is_prescribed(&self) -> bool {
        matches!(self.trajectory.solution(), Solution::Prescribed(_))
    }

    /// From the first to the last sample, s.
    pub(super) fn duration(&self) -> f64 {
        match self.samples() {
            [first, .., last] => last.state.time - first.state.time,
            _ => 0.0,
        }
    }
}
