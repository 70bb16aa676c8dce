//! The evaluation of one motion: its flow, with the series that is short.

use crate::math::rotation::{Attitude, Rotation};
use crate::math::triple::Triple;
use crate::math::vector::Vector;
use crate::motion::state::State;

use super::elements::Elements;
use super::flow::{Family, Flow, Phases, Raw};
use super::hyperbolic::Hyperbolic;
use super::labelled::Labelled;
use super::phase::{Elapsed, Rate};
use super::trigonometric::Trigonometric;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kernel {
    Trigonometric(Flow<f64, Trigonometric<f64>>),
    Hyperbolic(Flow<f64, Hyperbolic<f64>>),
}

/// Below this 1 − m the hyperbolic series is the shorter: K = 2K′.
const BALANCE: f64 = 0.03;

impl Kernel {
    /// `unit`: rad/s per unit of the elements' rates.
    pub(super) fn of(elements: &Elements, labelled: &Labelled, unit: f64, attitude: Attitude) -> Self {
        if elements.m1().value() > BALANCE {
            let (series, start) = Trigonometric::of(elements);
            Self::Trigonometric(Flow::prepared(elements, labelled, unit, series, start, attitude))
        } else {
            let (series, start) = Hyperbolic::of(elements);
            Self::Hyperbolic(Flow::prepared(elements, labelled, unit, series, start, attitude))
        }
    }

    /// The state at a time; `WHOLE` if `elapsed` has one word.
    pub(super) fn at<const WHOLE: bool>(&self, time: f64, elapsed: &Elapsed<f64>) -> State {
        let (q, omega) = match self {
            Self::Trigonometric(flow) => flow.at::<WHOLE>(elapsed),
            Self::Hyperbolic(flow) => flow.at::<WHOLE>(elapsed),
        };
        State { time, attitude: Rotation::from_unit(q), omega: Vector::from_array(omega) }
    }
}

impl<S: Family> Flow<f64, S> {
    /// Quaternion and ω.
    #[inline(always)]
    fn at<const WHOLE: bool>(&self, elapsed: &Elapsed<f64>) -> ([f64; 4], [f64; 3]) {
        let phases = if elapsed.is_within(self.reach) {
            self.phases::<WHOLE, false>(elapsed)
        } else {
            self.phases_of_long_time(elapsed)
        };
        self.state(&self.raw(&self.turned(&phases)))
    }

    #[cold]
    fn phases_of_long_time(&self, elapsed: &Elapsed<f64>) -> Phases<f64> {
        self.phases::<false, true>(elapsed)
    }

    fn prepared(
        elements: &Elements,
        labelled: &Labelled,
        unit: f64,
        series: S,
        start: [f64; 2],
        attitude: Attitude,
    ) -> Self {
        let polhode = elements.lambda / elements.quarter;
        let scale = series.scale();
        let omega = [0, 1, 2].map(|row| {
            [0, 1, 2].map(|k| elements.rates[k].value() * unit * scale[k] * labelled.axes[k][row])
        });
        let precession =
            Rate::new((elements.half_precession.scaled(4.0) - Triple::from(polhode.scaled(0.5))).0);
        let polhode = Rate::new([polhode.high, polhode.low, 0.0]);
        let towards = elements.direction();
        let mut flow = Self {
            precession,
            polhode,
            reach: precession.reach().min(polhode.reach()),
            start,
            direction: [0, 1, 2].map(|k| towards[k] * scale[k]),
            omega,
            attitude: [[0.0; 4]; 4],
            series,
        };
        // attitude(t) = attitude(0) · P · q(0)⁻¹ · q(t) · P⁻¹, P the labelled axes in the body; |q| scale is constant
        let labels = labelled.rotation();
        let Raw { quaternion: q, scale, .. } =
            flow.raw(&flow.turned(&flow.phases::<true, false>(&Elapsed::none())));
        let norm2 = (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
        let unit = 1.0 / (norm2 * scale);
        let left = quaternion_product(
            quaternion_product(attitude.quaternion(), labels.quaternion()),
            [q[0] * unit, -q[1] * unit, -q[2] * unit, -q[3] * unit],
        );
        let right = labels.inverse().quaternion();
        flow.attitude = matrix_of(|q| quaternion_product(quaternion_product(left, q), right));
        flow
    }
}

/// The matrix of a linear map of quaternions.
fn matrix_of(f: impl Fn([f64; 4]) -> [f64; 4]) -> [[f64; 4]; 4] {
    let columns = [0, 1, 2, 3].map(|k| {
        let mut basis = [0.0; 4];
        basis[k] = 1.0;
        f(basis)
    });
    [0, 1, 2, 3].map(|row| columns.map(|column| column[row]))
}

fn quaternion_product(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    let ([aw, ax, ay, az], [bw, bx, by, bz]) = (a, b);
    [
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    ]
}
