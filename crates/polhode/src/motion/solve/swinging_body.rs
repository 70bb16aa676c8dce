//! A body that swings about a principal axis of its own, level across gravity: a compound pendulum without a hinge.

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::frame::Body;
use crate::math::quaternion::Quaternion;
use crate::math::rotation::Rotation;
use crate::math::vector::{AngularVelocity, Direction};

use super::pendulum_motion::PendulumMotion;
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
    axis: [Double; 3],
    motion: PendulumMotion,
    /// cos ½θ + i sin ½θ at the start
    half: Complex<Double>,
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
        Self { start, axis: n, motion: PendulumMotion::of_half_angle(frequency, half, rate), half }
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
        let elapsed = Double::sum(time, -self.start.time);
        let Some((half, rate)) = self.motion.half_angle(elapsed) else { return State { time, ..self.start } };
        let turn = half.times(self.half.conjugate());
        let [x, y, z] = scaled(self.axis, turn.im);
        let start = Quaternion(self.start.attitude.quaternion().map(Double::from)).unit();
        let Quaternion(attitude) = start.times(Quaternion([turn.re, x, y, z]));
        State {
            time,
            attitude: Rotation::near_unit(attitude.map(Double::value)),
            omega: AngularVelocity::from_array(self.axis.map(|n| n.value() * rate)),
        }
    }

    /// The pendulum's angle and rate.
    pub const fn motion(&self) -> &PendulumMotion {
        &self.motion
    }
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
