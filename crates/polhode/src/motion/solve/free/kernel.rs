//! Evaluation of one motion: its flow, with the series that converges faster.

use crate::math::rotation::{Attitude, Rotation};
use crate::math::vector::Vector;
use crate::motion::model::state::State;

use super::compact::{CompactConstants, ScalarThetaParameters};
use super::elements::Elements;
use super::flow::{Flow, Phases, Series, Stages, UnnormalisedState};
use super::hyperbolic::{Hyperbolic, Pulse};
use super::labelled::Labelled;
use super::trigonometric::{Nomes, Trigonometric};
use crate::motion::solve::phase::Elapsed;

/// Compact constants and the flow computed from them, for each kind of series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kernel {
    Trigonometric(CompactConstants<f64, Nomes<f64>>, Flow<f64, Trigonometric<f64>>),
    Hyperbolic(CompactConstants<f64, Pulse<f64>>, Flow<f64, Hyperbolic<f64>>),
}

/// Threshold of 1 − m, where K = 2K′. Below it the hyperbolic series is the shorter one.
pub(super) const BALANCE: f64 = 0.03;

impl Kernel {
    /// Chooses the series and computes its constants.
    ///
    /// `units`: rad/s per unit of the elements' rates, and the factor from the elements' rates to
    /// those of the kernel.
    pub(super) fn of(elements: &Elements, labelled: &Labelled, units: [f64; 2], attitude: Attitude) -> Self {
        if elements.m1().value() > BALANCE {
            let (compact, flow) = constants_of(elements, labelled, units, Nomes::of(elements), attitude);
            Self::Trigonometric(compact, flow)
        } else {
            let (compact, flow) = constants_of(elements, labelled, units, Pulse::of(elements), attitude);
            Self::Hyperbolic(compact, flow)
        }
    }

    /// Returns the state at a time, and the unit vector along L in the labelled axes.
    pub(super) fn at_with_direction(&self, time: f64, elapsed: &Elapsed<f64>) -> (State, [f64; 3]) {
        let ((q, omega), direction) = match self {
            Self::Trigonometric(_, flow) => flow.at_with_direction(elapsed),
            Self::Hyperbolic(_, flow) => flow.at_with_direction(elapsed),
        };
        let state = State { time, attitude: Rotation::from_unit(q), omega: Vector::from_array(omega) };
        (state, direction)
    }

    /// Returns the state at a time. `WHOLE` is true if `elapsed` has only one word.
    pub(super) fn at<const WHOLE: bool>(&self, time: f64, elapsed: &Elapsed<f64>) -> State {
        let (q, omega) = match self {
            Self::Trigonometric(_, flow) => flow.at::<WHOLE>(elapsed),
            Self::Hyperbolic(_, flow) => flow.at::<WHOLE>(elapsed),
        };
        State { time, attitude: Rotation::from_unit(q), omega: Vector::from_array(omega) }
    }
}

fn constants_of<N: ScalarThetaParameters>(
    elements: &Elements,
    labelled: &Labelled,
    units: [f64; 2],
    parameters: (N, f64),
    attitude: Attitude,
) -> (CompactConstants<f64, N>, Flow<f64, N::Series>) {
    let (compact, third) = CompactConstants::of(elements, labelled, units, parameters, attitude);
    let flow = compact.flow(third);
    (compact, flow)
}

impl<S: Series<f64>> Flow<f64, S> {
    /// Returns quaternion and ω.
    #[inline(always)]
    fn at<const WHOLE: bool>(&self, elapsed: &Elapsed<f64>) -> ([f64; 4], [f64; 3]) {
        self.state(&self.unnormalised_at::<WHOLE>(elapsed))
    }

    fn at_with_direction(&self, elapsed: &Elapsed<f64>) -> (([f64; 4], [f64; 3]), [f64; 3]) {
        let unnormalised = self.unnormalised_at::<false>(elapsed);
        let (towards, rates) = (&self.curve.direction, &unnormalised.rates);
        let direction = [towards[0] * rates[0], towards[1] * rates[1], towards[2] * rates[2]];
        (self.state(&unnormalised), direction)
    }

    #[inline(always)]
    fn unnormalised_at<const WHOLE: bool>(&self, elapsed: &Elapsed<f64>) -> UnnormalisedState<f64> {
        let phases = if elapsed.is_within(self.phase_rates.reach) {
            self.phase_rates.phases::<WHOLE, false>(elapsed)
        } else {
            self.phases_of_long_time(elapsed)
        };
        self.unnormalised(&self.theta_argument(&phases))
    }

    #[cold]
    fn phases_of_long_time(&self, elapsed: &Elapsed<f64>) -> Phases<f64> {
        self.phase_rates.phases::<false, true>(elapsed)
    }
}
