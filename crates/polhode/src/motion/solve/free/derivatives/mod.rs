//! Derivatives of free motion with respect to its start and the inertia tensor, in closed form:
//! `book/free-motion-derivatives.md`, section 10.

mod columns;
mod elliptic;
mod functions;
mod hyperbolic;
mod inertia;
mod momentum;
mod short;
mod trigonometric;

use crate::math::machine::{Machine, Work, in_vectors};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::state_derivatives::StateDerivatives;
use crate::motion::solve::reach::is_within;

use super::elements::Elements;
use super::{FreeBody, FreeMotion};
use columns::ToBody;
use functions::{Functions, TimeFunctions};
use momentum::MomentumFlow;
use short::ShortSeries;

/// Torque-free motion with its derivatives with respect to the start and the inertia tensor. Any
/// time, past or future, is evaluated in constant time.
///
/// ```
/// use polhode::body::{InertiaTensor, MassProperties};
/// use polhode::math::{AngularVelocity, Attitude, Position};
/// use polhode::motion::{FreeMotionDerivatives, Rotor, State};
/// let inertia = InertiaTensor::diagonal([1.0, 2.0, 3.0])?;
/// let body = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia)?);
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.0, 0.0, 0.5) };
/// let motion = FreeMotionDerivatives::of(&body, start)?;
/// let after = motion.at(7.0);
/// // A body that spins 1 rad/s faster about its axis is 7 rad further after 7 s …
/// assert!((after.by_start[2][5] - 7.0).abs() < 1e-14);
/// // … and one with products of inertia wobbles.
/// assert!(after.by_inertia[1][4] < -0.9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Accuracy
/// The error of a block (θ or ω, with respect to ω(0) or to the tensor) is relative to the norm of
/// the block. Largest errors:
///
/// - 7·10⁻¹⁴ against differences in 120 digits, for 77 motions up to 10⁶ periods. They include 1 −
///   m = 10⁻²⁰ and 0, and permanent, symmetric and spherical motions.
/// - 7·10⁻¹³ for 10⁵ random bodies over 8 rad. Their moments are within a factor of 10; some are
///   close to symmetry, to the separatrix, or to an axis.
/// - 2·10⁻¹⁵ times the ratio of the moments for a needle, if that is larger.
///
/// Most blocks are accurate to 10⁻¹⁵. The derivative of θ with respect to the tensor is the least
/// accurate, just after a rotation of 0.1 rad.
///
/// Single columns are less accurate if their parts cancel. Example: the diagonal elements I_xx and
/// I_yy of a body with two equal moments, such as a top along z. These columns of θ are accurate to
/// 2·10⁻¹¹ of the column. Every other column of such a body is accurate to 2·10⁻¹³, unless it is
/// below a hundredth of its block.
///
/// # Cost
/// 5 to 5.5 times the cost of a state. While the body has rotated by less than 0.1 rad, 50 times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeMotionDerivatives {
    motion: FreeMotion,
    flow: MomentumFlow,
    functions: Functions,
    short: ShortSeries,
    to_body: ToBody,
    /// |L|, in units of the elements.
    momentum: f64,
    /// Conversion factor: time units of the elements per time unit of the kernel.
    factor: f64,
    is_permanent: bool,
}

/// Largest |∫ σ²/dn² dt| for which derivatives are returned. Near the intermediate axis derivatives
/// grow like the square root of this integral V, and their parts like V itself. Beyond this value
/// the parts leave the range of f64.
const LARGEST: f64 = 1e290;

/// Least ratio of the smallest moment to the greatest. A thinner body would have fewer than six
/// correct digits.
const THINNEST: f64 = 1e-8;

impl FreeMotionDerivatives {
    /// Returns the torque-free motion that starts from a state, with its derivatives.
    ///
    /// # Errors
    /// The errors of [`FreeMotion::of`]. A parameter error ([`MotionError::is_parameter`]) if a
    /// principal moment is below 1e-8 of the greatest, as for a rod.
    pub fn of(rotor: &Rotor, start: State) -> Result<Self, MotionError> {
        let body = FreeBody::of(rotor)?;
        let motion = FreeMotion::of_body(&body, start)?;
        let [least, _, greatest] = motion.principal.moments();
        let rule = "at least 1e-8 of the greatest, because derivatives are requested";
        require::that("a principal moment", least, least >= THINNEST * greatest, rule)?;
        let (labelled, unit) = body.labelled(&start);
        let elements = Elements::of(&labelled);
        let flow = MomentumFlow::of(&elements, &labelled);
        let factor = unit / motion.unit;
        Ok(Self {
            motion,
            flow,
            functions: Functions::of(&elements, factor),
            short: ShortSeries::of(&flow),
            to_body: ToBody::of(&flow, &labelled, body.axes.unit, unit),
            momentum: elements.momentum.value(),
            factor,
            is_permanent: labelled.is_permanent(),
        })
    }

    /// Returns the state and its derivatives at a time, s, which may be before the start.
    ///
    /// Both are NaN beyond [`FreeMotion::reach`] and for a time that is NaN. Derivatives are also
    /// NaN if they grow beyond about 1e140 near the intermediate axis.
    #[must_use]
    pub fn at(&self, time: f64) -> StateDerivatives {
        let motion = &self.motion;
        if !is_within(&motion.start, motion.reach, time) {
            return StateDerivatives::unknown(time);
        }
        let elapsed = motion.elapsed::<false, f64>(time);
        let t = elapsed.double().value() * self.factor;
        let (state, momentum) = if time == motion.start.time {
            (motion.start, self.flow.start)
        } else {
            let (state, direction) = motion.kernel.at_with_direction(time, &elapsed);
            let momentum = self.momentum;
            (
                state,
                if self.is_permanent {
                    self.flow.start
                } else {
                    [momentum * direction[0], momentum * direction[1], momentum * direction[2]]
                },
            )
        };
        let back = back(&state, &motion.start);
        let turn = matrix_of(back[0], [back[1], back[2], back[3]]);
        if self.short.covers(t) {
            return self.to_body.in_si(&self.short.at(&self.flow, &self.to_body, t), &turn, state);
        }
        let functions = self.functions.at(&elapsed, t);
        if !(functions.quotient.abs() < LARGEST) {
            return StateDerivatives { state, ..StateDerivatives::unknown(time) };
        }
        let back = matrix_of(back[0], self.to_body.along([back[1], back[2], back[3]]));
        in_vectors(Assembly {
            flow: &self.flow,
            to_body: &self.to_body,
            momentum,
            back,
            functions,
            turn,
            state,
        })
    }

    /// Returns states and derivatives at many times, s, in their order.
    #[must_use]
    pub fn at_times(&self, times: &[f64]) -> Vec<StateDerivatives> {
        times.iter().map(|&time| self.at(time)).collect()
    }

    /// Returns the motion without derivatives.
    pub const fn motion(&self) -> &FreeMotion {
        &self.motion
    }
}

/// Inputs of the derivatives of one state: some thousand products without a branch.
struct Assembly<'a> {
    flow: &'a MomentumFlow,
    to_body: &'a ToBody,
    momentum: [f64; 3],
    back: [[f64; 3]; 3],
    functions: TimeFunctions,
    turn: [[f64; 3]; 3],
    state: State,
}

impl Work for Assembly<'_> {
    type Output = StateDerivatives;

    #[inline(always)]
    fn run<S: Machine>(self, _: S) -> StateDerivatives {
        let Self { flow, to_body, momentum, back, functions, turn, state } = self;
        to_body.in_si(&to_body.columns(flow, &momentum, &back, &functions), &turn, state)
    }
}

/// Returns the attitude at the start relative to that of `state`, as a quaternion in body axes.
fn back(state: &State, start: &State) -> [f64; 4] {
    let ([aw, ax, ay, az], [bw, bx, by, bz]) = (state.attitude.quaternion(), start.attitude.quaternion());
    [
        aw * bw + ax * bx + ay * by + az * bz,
        aw * bx - ax * bw - ay * bz + az * by,
        aw * by + ax * bz - ay * bw - az * bx,
        aw * bz - ax * by + ay * bx - az * bw,
    ]
}

#[inline(always)]
fn matrix_of(w: f64, [x, y, z]: [f64; 3]) -> [[f64; 3]; 3] {
    let (x2, y2, z2) = (x + x, y + y, z + z);
    [
        [1.0 - (y * y2 + z * z2), x * y2 - w * z2, x * z2 + w * y2],
        [x * y2 + w * z2, 1.0 - (x * x2 + z * z2), y * z2 - w * x2],
        [x * z2 - w * y2, y * z2 + w * x2, 1.0 - (x * x2 + y * y2)],
    ]
}
