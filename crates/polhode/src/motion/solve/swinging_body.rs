//! Compound pendulum: a body that swings about one of its principal axes, which is horizontal. The
//! body needs no hinge.

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

/// Motion of a body held at a pivot that rotates about a principal axis n through the pivot.
///
/// n must be perpendicular to gravity and to the arm of the centre of mass. The torque is then
/// along n, and ω stays along n.
///
/// # Accuracy
/// 5·10⁻¹⁶ rad up to a hundredth of [`SwingingBody::reach`], if these conditions hold exactly. A
/// body that satisfies them only to rounding (4 ε) is treated as if it satisfied them. Rotation
/// about the intermediate axis is unstable, so the true motion of such a body leaves the plane in
/// time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SwingingBody {
    start: State,
    axis: [f64; 3],
    motion: PendulumMotion,
    /// Matrix from cos ½θ and sin ½θ to the attitude.
    attitude: [[f64; 2]; 4],
}

/// Tolerance of the conditions on vectors and tensor, relative.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

impl SwingingBody {
    /// Returns the motion that starts from a state.
    ///
    /// # Errors
    /// [`MotionError::NoClosedForm`] if body or start do not satisfy these conditions.
    pub fn of(rotor: &Rotor, gravity: &UniformGravity, start: State) -> Result<Self, MotionError> {
        let no = |why| Err(MotionError::NoClosedForm { why });
        if !rotor.wheels().is_empty() {
            return no("wheels spin in the body");
        }
        let g: Direction<Body> = (start.attitude.inverse() * gravity.acceleration).as_quantity();
        let l: Direction<Body> = rotor.lever().as_quantity();
        let torque: Direction<Body> = l.cross(g);
        let moving: Direction<Body> = start.omega.as_quantity();
        // A torque of the size of rounding has no direction. A body at rest then hangs or stands
        // upright and may swing about any axis.
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

    /// Computes the constants in two words, because a long time multiplies their rounding errors.
    fn about(n: [f64; 3], rotor: &Rotor, gravity: &UniformGravity, start: State) -> Self {
        let words = |v: [f64; 3]| v.map(Double::from);
        // n in two words, from ω if the body rotates
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
        // Attitude rotated about n by ½θ minus its value at the start.
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

    /// Returns the state at the start.
    pub const fn start(&self) -> State {
        self.start
    }

    /// Returns the time before and after the start for which the motion is known, s:
    /// [`PendulumMotion::reach`].
    pub fn reach(&self) -> f64 {
        self.motion.reach()
    }

    /// Returns the state at a time, s, which may be before the start. ω and attitude are NaN beyond
    /// [`SwingingBody::reach`] and for a time that is NaN.
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

    /// Returns the states at many times (s), in their order. Each is bit-identical to
    /// [`SwingingBody::at`]; the computation is several times faster.
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

    /// Returns quaternion and ω from cos ½θ + i sin ½θ and the rate.
    #[inline(always)]
    fn turned<T: Splat>(&self, (half, rate): (Complex<T>, T)) -> ([T; 4], [T; 3]) {
        let [a0, a1, a2, a3] = &self.attitude;
        let (w, x, y, z) = (dot2(a0, half), dot2(a1, half), dot2(a2, half), dot2(a3, half));
        // Correct the last digits of the norm by 1/√n = (3 − n)/2 for n near 1.
        let k = T::splat(1.5) - T::splat(0.5) * ((w * w + x * x) + (y * y + z * z));
        let [n0, n1, n2] = self.axis;
        ([w * k, x * k, y * k, z * k], [T::splat(n0) * rate, T::splat(n1) * rate, T::splat(n2) * rate])
    }

    /// Returns the motion of the pendulum's angle.
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
