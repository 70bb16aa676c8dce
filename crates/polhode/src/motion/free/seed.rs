//! What a flow is made of: a third of its numbers, from which the others follow.
//!
//! A fleet keeps seeds, as reading 65 numbers from memory takes longer than making them of 22. One motion keeps its flow too.

use core::array::from_fn;

use crate::math::double::Double;
use crate::math::real::Real;
use crate::math::rotation::Attitude;
use crate::math::triple::Triple;

use super::elements::Elements;
use super::flow::{Curve, Flow, Frame, Pace, Raw, Series};
use super::labelled::Labelled;
use super::phase::{Elapsed, Rate};

/// What a series is made of.
pub(super) trait Nucleus<T> {
    type Series: Series<T>;

    fn series(&self) -> Self::Series;

    /// Of where on it a motion starts, the second word.
    fn low_start(&self) -> T;
}

/// A nucleus that also comes in other numbers.
pub(super) trait Family: Nucleus<f64> {
    /// What makes the three quotients of theta functions cn, sn and dn.
    fn scale(&self) -> [f64; 3];

    /// The same in numbers T.
    type Of<T: Real>: Nucleus<T>;

    /// The nucleus in which each number is what `pick` makes of the way to it.
    fn assembled<T: Real>(pick: &impl Fn(&dyn Fn(&Self) -> f64) -> T) -> Self::Of<T>;
}

/// The numbers of a motion, but for the third word of its precession: in four parts, as they are asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Seed<T, N> {
    pub(super) course: Course<T>,
    pub(super) shape: Shape<T, N>,
    pub(super) left: Left<T>,
    pub(super) body: Labels<T>,
}

/// What phases are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Course<T> {
    /// ½(Ωt − z), quarter turns, in two words.
    precession: [T; 2],
    /// λ/K: 2z/π, quarter turns, in two words.
    polhode: [T; 2],
    /// 2z/π at the start, quarter turns, the first word.
    start: T,
}

/// What theta functions are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shape<T, N> {
    nucleus: N,
    /// What makes theta functions the components of e.
    direction: [T; 3],
}

/// A quaternion: attitude = left · q · labels⁻¹, q in the labelled axes, of norm 1/`scale`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Left<T>([T; 4]);

/// The axes in the body, and how fast it turns about them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Labels<T> {
    /// A quaternion from the labelled axes to the body's. Of any norm: where the axes are the same but for their names it is of whole
    /// numbers.
    labels: [T; 4],
    /// The amplitudes of ω along the labelled axes, over |labels|², times what makes theta functions cn, sn and dn.
    rates: [T; 3],
}

impl<N: Family> Seed<f64, N> {
    /// The seed, and the third word of its precession, of a nucleus and where on its series the motion starts.
    ///
    /// `units`: rad/s per unit of the elements' rates, and by how much to multiply them to be the seed's.
    pub(super) fn of(
        elements: &Elements,
        labelled: &Labelled,
        [unit, pace]: [f64; 2],
        (nucleus, start): (N, f64),
        attitude: Attitude,
    ) -> (Self, f64) {
        let polhode = elements.lambda / elements.quarter;
        let [first, second, third] =
            (elements.half_precession.scaled(4.0) - Triple::from(polhode.scaled(0.5))).scaled(pace).0;
        let polhode = polhode.scaled(pace);
        let (towards, scale) = (elements.direction(), nucleus.scale());
        let turned = labelled.rotation().quaternion();
        let greatest = turned.iter().fold(0.0, |max: f64, c| max.max(c.abs()));
        let labels = turned.map(|c| c / greatest);
        let norm2 = labels.iter().fold(Double::default(), |sum, &c| sum + Double::from(c).square());
        let course = Course { precession: [first, second], polhode: [polhode.high, polhode.low], start };
        let shape = Shape { nucleus, direction: from_fn(|k| towards[k] * scale[k]) };
        let body =
            Labels { labels, rates: from_fn(|k| (elements.rates[k] / norm2).value() * unit * scale[k]) };
        // attitude(t) = attitude(0) · P · q(0)⁻¹ · q(t) · P⁻¹, P the labelled axes in the body; |q| scale is constant
        let phases = course.pace(&shape, 0.0).phases::<true, false>(&Elapsed::none());
        let curve = shape.curve();
        let Raw { quaternion: q, scale, .. } = curve.raw(&curve.turned(&phases));
        let unit = greatest / (((q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3])) * scale);
        let left = quaternion_product(
            quaternion_product(attitude.quaternion(), turned),
            [q[0] * unit, -q[1] * unit, -q[2] * unit, -q[3] * unit],
        );
        (Self { course, shape, left: Left(left), body }, third)
    }

    /// The seed in other numbers: one body in every lane, or a body in each.
    pub(super) fn assembled<T: Real>(pick: &impl Fn(&dyn Fn(&Self) -> f64) -> T) -> Seed<T, N::Of<T>> {
        Seed {
            course: Course {
                precession: from_fn(|k| pick(&|s| s.course.precession[k])),
                polhode: from_fn(|k| pick(&|s| s.course.polhode[k])),
                start: pick(&|s| s.course.start),
            },
            shape: Shape {
                nucleus: N::assembled(&|get: &dyn Fn(&N) -> f64| pick(&|s: &Self| get(&s.shape.nucleus))),
                direction: from_fn(|k| pick(&|s| s.shape.direction[k])),
            },
            left: Left(from_fn(|k| pick(&|s| s.left.0[k]))),
            body: Labels {
                labels: from_fn(|k| pick(&|s| s.body.labels[k])),
                rates: from_fn(|k| pick(&|s| s.body.rates[k])),
            },
        }
    }
}

impl<T: Real, N: Nucleus<T>> Seed<T, N> {
    /// The whole flow, with the third word of its precession.
    #[inline(always)]
    pub(super) fn flow(&self, third: T) -> Flow<T, N::Series> {
        Flow {
            pace: self.course.pace(&self.shape, third),
            curve: self.shape.curve(),
            frame: self.left.frame(&self.body),
        }
    }
}

impl<T: Real> Course<T> {
    /// With the third word of the precession: only long times ask for it.
    #[inline(always)]
    pub(super) fn pace<N: Nucleus<T>>(&self, shape: &Shape<T, N>, third: T) -> Pace<T> {
        Pace::of(
            Rate::of(self.precession, third),
            Rate::of(self.polhode, T::splat(0.0)),
            [self.start, shape.nucleus.low_start()],
        )
    }

    /// For times within its reach.
    #[inline(always)]
    pub(super) fn near_pace<N: Nucleus<T>>(&self, shape: &Shape<T, N>) -> Pace<T> {
        let zero = T::splat(0.0);
        Pace {
            precession: Rate::of(self.precession, zero),
            polhode: Rate::of(self.polhode, zero),
            start: [self.start, shape.nucleus.low_start()],
            reach: zero,
        }
    }
}

impl<T: Real, N: Nucleus<T>> Shape<T, N> {
    #[inline(always)]
    pub(super) fn curve(&self) -> Curve<T, N::Series> {
        Curve { series: self.nucleus.series(), direction: self.direction }
    }
}

impl<T: Real> Left<T> {
    #[inline(always)]
    pub(super) fn frame(&self, body: &Labels<T>) -> Frame<T> {
        let [r1, r2, r3] = body.rates;
        Frame {
            attitude: matrix_of(self.0, body.labels),
            omega: axes_of(body.labels).map(|[e1, e2, e3]| [e1 * r1, e2 * r2, e3 * r3]),
        }
    }
}

/// The matrix of a quaternion, times its norm squared.
#[inline(always)]
fn axes_of<T: Real>([w, x, y, z]: [T; 4]) -> [[T; 3]; 3] {
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
fn matrix_of<T: Real>([a, b, c, d]: [T; 4], [w, x, y, z]: [T; 4]) -> [[T; 4]; 4] {
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
