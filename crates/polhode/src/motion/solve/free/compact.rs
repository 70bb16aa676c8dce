//! What a flow is made of: a third of its numbers, from which the others follow.
//!
//! A fleet keeps seeds, as reading 65 numbers from memory takes longer than making them of 22. One motion keeps its flow too.

use core::array::from_fn;

use crate::math::double::Double;
use crate::math::number::Splat;
use crate::math::rotation::Attitude;
use crate::math::triple::Triple;

use super::elements::Elements;
use super::flow::{Flow, LabelledState, PhaseRates, Series, ToBodyMap, UnnormalisedState};
use super::labelled::Labelled;
use crate::motion::solve::phase::{Elapsed, Rate};

/// What a series is made of.
pub(super) trait ThetaParameters<T> {
    type Series: Series<T>;

    fn series(&self) -> Self::Series;

    /// Of where on it a motion starts, the second word.
    fn low_start(&self) -> T;
}

/// A parameters that also comes in other numbers.
pub(super) trait ScalarThetaParameters: ThetaParameters<f64> {
    /// What makes the three quotients of theta functions cn, sn and dn.
    fn scale(&self) -> [f64; 3];

    /// The same in numbers T.
    type Of<T: Splat>: ThetaParameters<T>;

    /// The parameters in which each number is what `pick` makes of the way to it.
    fn assembled<T: Splat>(pick: &impl Fn(&dyn Fn(&Self) -> f64) -> T) -> Self::Of<T>;
}

/// The numbers of a motion, but for the third word of its precession: in four parts, as they are asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CompactConstants<T, N> {
    pub(super) frequencies: Frequencies<T>,
    pub(super) theta: ThetaConstants<T, N>,
    pub(super) left: LeftFactor<T>,
    pub(super) axes: LabelledAxes<T>,
}

/// What phases are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frequencies<T> {
    /// ½(Ωt − z), quarter turns, in two words.
    precession: [T; 2],
    /// λ/K: 2z/π, quarter turns, in two words.
    polhode: [T; 2],
    /// 2z/π at the start, quarter turns, the first word.
    start: T,
}

/// What theta functions are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ThetaConstants<T, N> {
    parameters: N,
    /// What makes theta functions the components of e.
    direction: [T; 3],
}

/// A quaternion: attitude = left · q · labels⁻¹, q in the labelled axes, of norm 1/`scale`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LeftFactor<T>([T; 4]);

/// The axes in the body, and how fast it turns about them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LabelledAxes<T> {
    /// A quaternion from the labelled axes to the body's. Of any norm: where the axes are the same but for their names it is of whole
    /// numbers.
    rotation: [T; 4],
    /// The amplitudes of ω along the labelled axes, over |rotation|², times what makes theta functions cn, sn and dn.
    rates: [T; 3],
}

impl<N: ScalarThetaParameters> CompactConstants<f64, N> {
    /// The compact, and the third word of its precession, of a parameters and where on its series the motion starts.
    ///
    /// `units`: rad/s per unit of the elements' rates, and by how much to multiply them to be the compact's.
    pub(super) fn of(
        elements: &Elements,
        labelled: &Labelled,
        [unit, factor]: [f64; 2],
        (parameters, start): (N, f64),
        attitude: Attitude,
    ) -> (Self, f64) {
        let polhode = elements.lambda / elements.quarter;
        let [first, second, third] =
            (elements.half_precession.scaled(4.0) - Triple::from(polhode.scaled(0.5))).scaled(factor).0;
        let polhode = polhode.scaled(factor);
        let (towards, scale) = (elements.direction(), parameters.scale());
        let to_body = labelled.rotation().quaternion();
        let greatest = to_body.iter().fold(0.0, |max: f64, c| max.max(c.abs()));
        let rotation = to_body.map(|c| c / greatest);
        let norm2 = rotation.iter().fold(Double::default(), |sum, &c| sum + Double::from(c).square());
        let frequencies =
            Frequencies { precession: [first, second], polhode: [polhode.high, polhode.low], start };
        let theta = ThetaConstants { parameters, direction: from_fn(|k| towards[k] * scale[k]) };
        let axes = LabelledAxes {
            rotation,
            rates: from_fn(|k| (elements.rates[k] / norm2).value() * unit * scale[k]),
        };
        // attitude(t) = attitude(0) · P · q(0)⁻¹ · q(t) · P⁻¹, P the labelled axes in the body; |q| scale is constant
        let phases = frequencies.phase_rates(&theta, 0.0).phases::<true, false>(&Elapsed::none());
        let curve = theta.curve();
        let UnnormalisedState { quaternion: q, scale, .. } =
            curve.unnormalised(&curve.theta_argument(&phases));
        let unit = greatest / (((q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3])) * scale);
        let left = quaternion_product(
            quaternion_product(attitude.quaternion(), to_body),
            [q[0] * unit, -q[1] * unit, -q[2] * unit, -q[3] * unit],
        );
        (Self { frequencies, theta, left: LeftFactor(left), axes }, third)
    }

    /// The compact in other numbers: one body in every lane, or a body in each.
    pub(super) fn assembled<T: Splat>(
        pick: &impl Fn(&dyn Fn(&Self) -> f64) -> T,
    ) -> CompactConstants<T, N::Of<T>> {
        CompactConstants {
            frequencies: Frequencies {
                precession: from_fn(|k| pick(&|s| s.frequencies.precession[k])),
                polhode: from_fn(|k| pick(&|s| s.frequencies.polhode[k])),
                start: pick(&|s| s.frequencies.start),
            },
            theta: ThetaConstants {
                parameters: N::assembled(&|get: &dyn Fn(&N) -> f64| {
                    pick(&|s: &Self| get(&s.theta.parameters))
                }),
                direction: from_fn(|k| pick(&|s| s.theta.direction[k])),
            },
            left: LeftFactor(from_fn(|k| pick(&|s| s.left.0[k]))),
            axes: LabelledAxes {
                rotation: from_fn(|k| pick(&|s| s.axes.rotation[k])),
                rates: from_fn(|k| pick(&|s| s.axes.rates[k])),
            },
        }
    }
}

impl<T: Splat, N: ThetaParameters<T>> CompactConstants<T, N> {
    /// The whole flow, with the third word of its precession.
    #[inline(always)]
    pub(super) fn flow(&self, third: T) -> Flow<T, N::Series> {
        Flow {
            phase_rates: self.frequencies.phase_rates(&self.theta, third),
            curve: self.theta.curve(),
            to_body: self.left.body_map(&self.axes),
        }
    }
}

impl<T: Splat> Frequencies<T> {
    /// With the third word of the precession: only long times ask for it.
    #[inline(always)]
    pub(super) fn phase_rates<N: ThetaParameters<T>>(
        &self,
        theta: &ThetaConstants<T, N>,
        third: T,
    ) -> PhaseRates<T> {
        PhaseRates::of(
            Rate::of(self.precession, third),
            Rate::of(self.polhode, T::splat(0.0)),
            [self.start, theta.parameters.low_start()],
        )
    }

    /// For times within its reach.
    #[inline(always)]
    pub(super) fn near_phase_rates<N: ThetaParameters<T>>(
        &self,
        theta: &ThetaConstants<T, N>,
    ) -> PhaseRates<T> {
        let zero = T::splat(0.0);
        PhaseRates {
            precession: Rate::of(self.precession, zero),
            polhode: Rate::of(self.polhode, zero),
            start: [self.start, theta.parameters.low_start()],
            reach: zero,
        }
    }
}

impl<T: Splat, N: ThetaParameters<T>> ThetaConstants<T, N> {
    #[inline(always)]
    pub(super) fn curve(&self) -> LabelledState<T, N::Series> {
        LabelledState { series: self.parameters.series(), direction: self.direction }
    }
}

impl<T: Splat> LeftFactor<T> {
    #[inline(always)]
    pub(super) fn body_map(&self, axes: &LabelledAxes<T>) -> ToBodyMap<T> {
        let [r1, r2, r3] = axes.rates;
        let [x, y, z] = axes_of(axes.rotation);
        ToBodyMap {
            attitude: matrix_of(self.0, axes.rotation),
            // Not by `map`, which is inlined only where the whole program is optimised at once.
            omega: [
                [x[0] * r1, x[1] * r2, x[2] * r3],
                [y[0] * r1, y[1] * r2, y[2] * r3],
                [z[0] * r1, z[1] * r2, z[2] * r3],
            ],
        }
    }
}

/// The matrix of a quaternion, times its norm squared.
#[inline(always)]
fn axes_of<T: Splat>([w, x, y, z]: [T; 4]) -> [[T; 3]; 3] {
    let (ww, xx, yy, zz) = (w * w, x * x, y * y, z * z);
    let (sum, difference) = (ww + xx, ww - xx);
    let (other_sum, other_difference) = (yy + zz, yy - zz);
    let (w, y2, z2) = (w + w, y + y, z + z);
    let (wx, wy, wz) = (w * x, w * y, w * z);
    let (xy, xz, yz) = (x * y2, x * z2, y * z2);
    [
        [sum - other_sum, xy - wz, xz + wy],
        [xy + wz, difference + other_difference, yz - wx],
        [xz - wy, yz + wx, difference - other_difference],
    ]
}

/// The matrix of q ↦ left · q · right⁻¹, times the norm of right squared: of the sixteen products each is in four of its elements.
#[inline(always)]
fn matrix_of<T: Splat>([a, b, c, d]: [T; 4], [w, x, y, z]: [T; 4]) -> [[T; 4]; 4] {
    let four = |e: T, f: T, g: T, h: T| {
        let (sum, other_sum, difference, other_difference) = (e + f, g + h, e - f, h - g);
        [other_sum + sum, other_sum - sum, other_difference + difference, other_difference - difference]
    };
    let [m00, m11, m22, m33] = four(c * y, d * z, b * x, a * w);
    let [m32, m23, m01, m10] = four(a * x, b * w, c * z, d * y);
    let [m13, m31, m02, m20] = four(a * y, c * w, d * x, b * z);
    let [m21, m12, m03, m30] = four(a * z, d * w, b * y, c * x);
    [[m00, m01, m02, m03], [m10, m11, m12, m13], [m20, m21, m22, m23], [m30, m31, m32, m33]]
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
