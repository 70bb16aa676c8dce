//! Compact constants of a motion: a third of the numbers of a [`Flow`]; the others follow from
//! them.
//!
//! A batch of many bodies stores compact constants: reading 65 numbers from memory takes longer
//! than computing them from 22. A single motion stores its flow too.

use core::array::from_fn;

use crate::math::double::Double;
use crate::math::number::Splat;
use crate::math::rotation::Attitude;
use crate::math::triple::Triple;

use super::elements::Elements;
use super::flow::{Flow, LabelledState, PhaseRates, Series, ToBodyMap, UnnormalisedState};
use super::labelled::Labelled;
use crate::motion::solve::phase::{Elapsed, Rate};

/// Constants that determine a theta series.
pub(super) trait ThetaParameters<T> {
    type Series: Series<T>;

    fn series(&self) -> Self::Series;

    /// Low word of the phase 2z/π at the start, quarter turns.
    fn low_start(&self) -> T;
}

/// Theta parameters in f64 that can be converted to another number type.
pub(super) trait ScalarThetaParameters: ThetaParameters<f64> {
    /// Factors that turn the three quotients of theta functions into cn, sn and dn.
    fn scale(&self) -> [f64; 3];

    /// The same parameters in numbers of type `T`.
    type Of<T: Splat>: ThetaParameters<T>;

    /// Converts the parameters. `pick` receives an accessor of each number and returns the
    /// converted number.
    fn assembled<T: Splat>(pick: &impl Fn(&dyn Fn(&Self) -> f64) -> T) -> Self::Of<T>;
}

/// Constants of a motion without the third word of its precession rate, grouped by the stage that
/// uses them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CompactConstants<T, N> {
    pub(super) frequencies: Frequencies<T>,
    pub(super) theta: ThetaConstants<T, N>,
    pub(super) left: LeftFactor<T>,
    pub(super) axes: LabelledAxes<T>,
}

/// Constants of the two phases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frequencies<T> {
    /// Rate of ½(Ωt − z), quarter turns per unit time, in two words.
    precession: [T; 2],
    /// Rate λ/K of 2z/π, quarter turns per unit time, in two words.
    polhode: [T; 2],
    /// High word of 2z/π at the start, quarter turns.
    start: T,
}

/// Constants of the theta functions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ThetaConstants<T, N> {
    parameters: N,
    /// Factors that turn the theta functions into the components of e, the unit vector along L.
    direction: [T; 3],
}

/// Left factor of the attitude, a quaternion: attitude = left · q · labels⁻¹. Here q is the
/// quaternion in the labelled axes; it has norm 1/`scale`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LeftFactor<T>([T; 4]);

/// Labelled axes in the body, and amplitudes of ω along them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LabelledAxes<T> {
    /// Quaternion from the labelled axes to the body axes, of any norm. If the labelled axes are
    /// only a permutation of the body axes, its components are whole numbers.
    rotation: [T; 4],
    /// Amplitudes of ω along the labelled axes, divided by |rotation|² and multiplied by the
    /// factors that turn theta functions into cn, sn and dn.
    rates: [T; 3],
}

impl<N: ScalarThetaParameters> CompactConstants<f64, N> {
    /// Returns the compact constants and the third word of the precession rate. The pair
    /// `(parameters, start)` holds the theta parameters and the phase of the start.
    ///
    /// `units`: rad/s per unit of the elements' rates, and the factor from the elements' rates to
    /// those of the compact constants.
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
        // attitude(t) = attitude(0) · P · q(0)⁻¹ · q(t) · P⁻¹, where P is the rotation from
        // labelled to body axes. |q| scale is constant.
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

    /// Converts the constants to another number type: one body in all lanes, or one body per lane.
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
    /// Returns the full flow. `third` is the third word of the precession rate.
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
    /// Returns the phase rates. `third`, the third word of the precession rate, matters only at
    /// long times.
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

    /// Returns the phase rates for times within their reach, where the third word does not matter.
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
            // Without `map`, which is inlined only with link-time optimisation (LTO).
            omega: [
                [x[0] * r1, x[1] * r2, x[2] * r3],
                [y[0] * r1, y[1] * r2, y[2] * r3],
                [z[0] * r1, z[1] * r2, z[2] * r3],
            ],
        }
    }
}

/// Returns the rotation matrix of a quaternion, multiplied by its squared norm.
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

/// Returns the 4 × 4 matrix of q ↦ left · q · right⁻¹, multiplied by the squared norm of `right`.
/// Each of the sixteen products occurs in four elements.
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
