//! A body that swings about a principal axis of its own, level across gravity: a compound pendulum without a hinge.

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::frame::Body;
use crate::math::number::Splat;
use crate::math::quaternion::Quaternion;
use crate::math::rotation::Rotation;
use crate::math::vector::{AngularVelocity, Direction};

use super::at_times::at_times;
use super::pendulum_motion::PendulumMotion;
use super::phase::Elapsed;
use super::reach::is_within;
use crate::motion::error::MotionError;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::gravity::UniformGravity;

/// The motion of a body held at a pivot that turns about a principal axis n through it, where n is across gravity and across
/// the arm of the centre of mass: the torque is along n, and so ω stays along it.
///
/// # Accuracy
/// 5·10⁻¹⁶ rad within a hundredth of [`SwingingBody::reach`] and less, for a body that meets these conditions exactly. What meets them to rounding only (4 ε) is taken
/// to meet them; a turn about the intermediate axis is unstable, and the true motion then leaves the plane in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SwingingBody {
    start: State,
    axis: [f64; 3],
    motion: PendulumMotion,
    /// From cos ½θ and sin ½θ to the attitude.
    attitude: [[f64; 2]; 4],
}

/// A part of a vector or tensor that is rounding.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

impl SwingingBody {
    /// The motion that starts from a state.
    ///
    /// # Errors
    /// [`MotionError::NoClosedForm`] for a body or start that does not swing so.
    pub fn of(rotor: &Rotor, gravity: &UniformGravity, start: State) -> Result<Self, MotionError> {
        let no = |why| Err(MotionError::NoClosedForm { why });
        if !rotor.wheels().is_empty() {
            return no("wheels spin in the body");
        }
        let g: Direction<Body> = (start.attitude.inverse() * gravity.acceleration).as_quantity();
        let l: Direction<Body> = rotor.lever().as_quantity();
        let torque: Direction<Body> = l.cross(g);
        let moving: Direction<Body> = start.omega.as_quantity();
        // A torque that is rounding has no direction: a body at rest then hangs, or stands, and may as well swing about any axis.
        let is_torque = torque.norm() > ROUNDING * l.norm() * g.norm();
        let across_both = |n: &Direction<Body>| {
            n.dot(l).abs() <= ROUNDING * l.norm() && n.dot(g).abs() <= ROUNDING * g.norm()
        };
        let found = moving.direction().or_else(|| torque.direction().filter(|_| is_torque));
        let Some(n) = found.or_else(|| rotor.principal().axes().into_iter().find(across_both)) else {
            return no("neither spin nor torque gives the body an axis to swing about");
        };
        let inertia = rotor.inertia().matrix().map(Direction::<Body>::from_array).map(|row| row.dot(n));
        let moment = n.dot(Direction::<Body>::from_array(inertia));
        let across = Direction::<Body>::from_array(inertia) - n * moment;
        if !(across.norm() <= ROUNDING * rotor.principal().moments()[2]) {
            return no("the body does not turn about a principal axis");
        }
        if !across_both(&n) {
            return no("the axis that the body turns about is not across gravity and the centre of mass");
        }
        if !(moment > 0.0 && l.norm() > 0.0 && g.norm() > 0.0) {
            return no("no weight turns the body");
        }
        Ok(Self::about(n.to_array(), rotor, gravity, start))
    }

    /// With every number in two words, as a long time multiplies its rounding.
    fn about(n: [f64; 3], rotor: &Rotor, gravity: &UniformGravity, start: State) -> Self {
        let words = |v: [f64; 3]| v.map(Double::from);
        // n again in two words, from ω where that gave it
        let exact = if start.omega.norm() > 0.0 {
            start.omega.to_array().map(|w| w / start.omega.max_abs())
        } else {
            n
        };
        let n = scaled(words(exact), Double::ONE / norm(words(exact)));
        let attitude = Quaternion(start.attitude.quaternion().map(Double::from)).unit();
        let g = attitude.conjugate().turned(words(gravity.acceleration.to_array()));
        let l = words(rotor.lever().to_array());
        let [down, arm] = [g, l].map(|v| {
            let [a, b, c] = scaled(n, dot(v, n));
            let [x, y, z] = v;
            [x - a, y - b, z - c]
        });
        let rows = rotor.inertia().matrix().map(words);
        let moment = dot(n, rows.map(|row| dot(row, n)));
        // ω₀² = M g l/I
        let size = norm(down) * norm(arm);
        let frequency = (Double::from(rotor.mass()) * size / moment).sqrt();
        let [cosine, sine] = [dot(down, arm) / size, dot(n, cross(down, arm)) / size];
        let half = if cosine.high >= 0.0 {
            [Double::ONE + cosine, sine]
        } else {
            let side = if sine.high < 0.0 { -1.0 } else { 1.0 };
            [sine.scaled(side), (Double::ONE - cosine).scaled(side)]
        };
        let length = (half[0].square() + half[1].square()).sqrt();
        let half = Complex { re: half[0] / length, im: half[1] / length };
        let rate = dot(words(start.omega.to_array()), n);
        // Turned about n by ½θ less that of the start
        let turned = |half_turn: Complex<Double>| {
            let [x, y, z] = scaled(n, half_turn.im);
            attitude.times(Quaternion([half_turn.re, x, y, z])).0.map(Double::value)
        };
        let back = half.conjugate();
        let (cosine, sine) = (turned(back), turned(back.times_i()));
        Self {
            start,
            axis: n.map(Double::value),
            motion: PendulumMotion::of_half_angle(frequency, half, rate),
            attitude: [0, 1, 2, 3].map(|k| [cosine[k], sine[k]]),
        }
    }

    /// The state that it starts from.
    pub const fn start(&self) -> State {
        self.start
    }

    /// For how long before and after its start the motion is known, s: as [`PendulumMotion::reach`].
    pub fn reach(&self) -> f64 {
        self.motion.reach()
    }

    /// The state at a time, s, before the start too; not a number beyond [`SwingingBody::reach`], and at a time that is none.
    #[must_use]
    pub fn at(&self, time: f64) -> State {
        if time == self.start.time {
            return self.start;
        }
        if !is_within(&self.start, self.reach(), time) {
            return State::unknown(time);
        }
        if self.motion.is_still() {
            return State { time, ..self.start };
        }
        let elapsed = Elapsed::since::<false>(self.start.time, time, 1.0);
        let (attitude, omega) = self.turned(self.motion.half_angle(&elapsed));
        State { time, attitude: Rotation::from_unit(attitude), omega: AngularVelocity::from_array(omega) }
    }

    /// The states at some times, in their order: each with the bits of [`SwingingBody::at`], several times as fast.
    #[must_use]
    pub fn at_times(&self, times: &[f64]) -> Vec<State> {
        let Some(kernel) = self.motion.kernel() else {
            return times.iter().map(|&time| self.at(time)).collect();
        };
        at_times(
            times,
            &self.start,
            self.reach(),
            1.0,
            #[inline(always)]
            |elapsed| self.turned(kernel.at(elapsed)),
        )
    }

    /// Quaternion and ω by cos ½θ + i sin ½θ and the rate.
    #[inline(always)]
    fn turned<T: Splat>(&self, (half, rate): (Complex<T>, T)) -> ([T; 4], [T; 3]) {
        let [a0, a1, a2, a3] = &self.attitude;
        let (w, x, y, z) = (dot2(a0, half), dot2(a1, half), dot2(a2, half), dot2(a3, half));
        // The norm's last digits by 1/√n = (3 − n)/2 for n near 1.
        let k = T::splat(1.5) - T::splat(0.5) * ((w * w + x * x) + (y * y + z * z));
        let [n0, n1, n2] = self.axis;
        ([w * k, x * k, y * k, z * k], [T::splat(n0) * rate, T::splat(n1) * rate, T::splat(n2) * rate])
    }

    /// The pendulum's angle and rate.
    pub const fn motion(&self) -> &PendulumMotion {
        &self.motion
    }
}

#[inline(always)]
fn dot2<T: Splat>(a: &[f64; 2], half: Complex<T>) -> T {
    T::splat(a[0]) * half.re + T::splat(a[1]) * half.im
}

fn dot([a, b, c]: [Double; 3], [x, y, z]: [Double; 3]) -> Double {
    a * x + b * y + c * z
}

fn cross([a, b, c]: [Double; 3], [x, y, z]: [Double; 3]) -> [Double; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn norm(v: [Double; 3]) -> Double {
    dot(v, v).sqrt()
}

fn scaled(v: [Double; 3], by: Double) -> [Double; 3] {
    v.map(|c| c * by)
}
