//! Motion to be plotted.

use polhode::body::PrincipalFrame;
use polhode::math::Body;
use polhode::motion::{FreeMotion, Pointing, Sample, Solution, Trajectory, Wheel};

use crate::report::balance::Driven;

/// Motion to be plotted, with the data that its figures need.
#[derive(Clone, Debug)]
pub(crate) struct PlottedMotion<'a> {
    pub title: String,
    pub trajectory: &'a Trajectory,
    /// Principal moments and axes about the pivot or the centre of mass.
    pub principal: PrincipalFrame<Body>,
    pub free: Option<FreeMotion>,
    pub driven: Driven,
    pub wheels: Vec<(String, Wheel)>,
    pub pointings: Vec<Pointing>,
}

impl<'a> PlottedMotion<'a> {
    pub(crate) fn samples(&self) -> &'a [Sample] {
        self.trajectory.samples()
    }

    pub(crate) fn is_prescribed(&self) -> bool {
        matches!(self.trajectory.solution(), Solution::Prescribed(_))
    }

    /// Returns the duration from the first to the last sample, s.
    pub(crate) fn duration(&self) -> f64 {
        match self.samples() {
            [first, .., last] => last.state.time - first.state.time,
            _ => 0.0,
        }
    }
}
