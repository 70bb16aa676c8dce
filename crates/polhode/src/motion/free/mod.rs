//! Free motion in closed form: constants once, then any time at once.
//!
//! One formula serves every body and state (`flow.rs`); which of its two series is short depends on the nome. The rest is
//! preparation: principal axes in two words (`axes.rs`), labels by what L circles (`labelled.rs`), amplitudes, parameter and
//! rates without cancellation (`elements.rs`), phases that lose no digit over 10⁹ periods (`phase.rs`).

mod axes;
mod elements;
mod fleet;
mod flow;
mod hyperbolic;
mod labelled;
mod many;
mod phase;
mod regime;
mod trigonometric;

use crate::body::principal::PrincipalFrame;
use crate::math::double::Double;
use crate::math::frame::{Body, Space};
use crate::math::real::Real;
use crate::math::rotation::{Attitude, Rotation};
use crate::math::symmetric3::{Symmetric3, power_of_two_near};
use crate::math::vector::{AngularAcceleration, AngularMomentum, AngularVelocity, Vector};

use super::error::MotionError;
use super::rotor::Rotor;
use super::state::State;
use axes::FineAxes;
use elements::Elements;
use flow::Flow;
use hyperbolic::Hyperbolic;
use labelled::Labelled;
use phase::{Elapsed, FineRate, Rate};
use trigonometric::Trigonometric;

pub use fleet::FreeMotions;
pub use regime::{PermanentAxis, Regime};

/// The torque-free motion of a body: ω and attitude at any time, past or future, in constant time.
///
/// ```
/// use polhode::{AngularVelocity, Attitude, FreeMotion, InertiaTensor, MassProperties, Position, Regime, Rotor, State};
/// let inertia = InertiaTensor::diagonal([1.0, 2.0, 3.0])?;
/// let body = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia)?);
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.01, 1.0, 0.01) };
/// let motion = FreeMotion::of(&body, start)?;
/// assert_eq!(motion.regime(), Regime::ShortAxis);
/// let period = motion.period().unwrap();
/// assert!((period / 39.105_734_197_268_72 - 1.0).abs() < 1e-15);
/// let flipped = motion.at(0.5 * period).omega;
/// assert!((flipped.y + 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Accuracy
/// Against 50-digit references, for the moments, ω and attitude exactly as given: see the accuracy page of the book. Phases carry
/// three words, so the error does not grow before some 10²⁴ turns; the error of a time's own last digit is not counted.
/// Of a tensor with products of inertia the principal axes are found to 30 digits first.
///
/// # Source
/// Klein & Sommerfeld, Über die Theorie des Kreisels, ch. VI (Cayley–Klein parameters as theta functions); the constants without
/// cancellation are derived in `book/free-motion.md`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeMotion {
    start: State,
    principal: PrincipalFrame<Body>,
    regime: Regime,
    /// Moments in the order of the labels, kg·m², and the amplitudes of ω along their axes, rad/s.
    moments: [f64; 3],
    differences: [f64; 3],
    labels: Rotation<Body, Body>,
    rates: [f64; 3],
    nutation: [f64; 2],
    parameter: [f64; 2],
    period: f64,
    precession: f64,
    momentum: AngularMomentum<Body>,
    kinetic_energy: f64,
    /// rad/s per unit of the flow's rates: a power of two.
    unit: f64,
    kernel: Kernel,
}

/// The constants of the evaluation, with the series that is short.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kernel {
    Trigonometric(Flow<f64, Trigonometric<f64>>),
    Hyperbolic(Flow<f64, Hyperbolic<f64>>),
}

/// Below this 1 − m the hyperbolic series is the shorter: K = 2K′.
const BALANCE: f64 = 0.03;

impl FreeMotion {
    /// The motion that starts from a state with no torque.
    ///
    /// # Errors
    /// [`MotionError::NotSpinnable`] for a body without inertia; [`MotionError::Parameter`] for a state that is not finite.
    pub fn of(rotor: &Rotor, start: State) -> Result<Self, MotionError> {
        Self::of_tensor(rotor.inertia().symmetric(), rotor.principal(), start)
    }

    /// The motion of principal moments along the body's own x, y and z, which need not be those of a possible body: Euler's
    /// equations do not ask for i1 + i2 ≥ i3, and textbooks sometimes forget it.
    ///
    /// ```
    /// use polhode::{AngularVelocity, Attitude, FreeMotion, State};
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.1, 0.2, 5.0) };
    /// let motion = FreeMotion::of_moments([8.0, 4.0, 0.4], start)?; // no body has these
    /// assert!(motion.period().is_some());
    /// # Ok::<(), polhode::MotionError>(())
    /// ```
    ///
    /// # Errors
    /// [`MotionError::Parameter`] for a moment that is negative or not finite, or zero unless the other two are equal (a rod);
    /// [`MotionError::NotSpinnable`] for three zeros.
    pub fn of_moments(moments: [f64; 3], start: State) -> Result<Self, MotionError> {
        let wrong = moments.iter().find(|i| !(i.is_finite() && **i >= 0.0));
        if let Some(&value) = wrong {
            return Err(MotionError::Parameter {
                what: "a principal moment",
                value,
                rule: "finite and not negative",
            });
        }
        let [a, b, c] = moments;
        let rod = |i: f64, j: f64, k: f64| i == 0.0 && j != k;
        if rod(a, b, c) || rod(b, c, a) || rod(c, a, b) {
            let rule = "positive, or zero with two equal others (a rod)";
            return Err(MotionError::Parameter { what: "a principal moment", value: 0.0, rule });
        }
        let tensor = Symmetric3::diagonal(moments);
        Self::of_tensor(&tensor, &PrincipalFrame::of_symmetric(&tensor), start)
    }

    fn of_tensor(
        tensor: &Symmetric3,
        principal: &PrincipalFrame<Body>,
        start: State,
    ) -> Result<Self, MotionError> {
        if principal.moments()[2] == 0.0 {
            return Err(MotionError::NotSpinnable);
        }
        for (what, value) in
            [("the start's time", start.time), ("the start's angular velocity", start.omega.norm())]
        {
            if !value.is_finite() {
                return Err(MotionError::Parameter { what, value, rule: "finite" });
            }
        }
        let fine = FineAxes::of(tensor, principal);
        let unit = power_of_two_near(start.omega.max_abs());
        let omega = fine.along((start.omega / unit).to_array());
        let labelled = Labelled::of(fine.moments, omega, fine.axes.map(|axis| axis.map(|c| c.value())));
        let (labelled, elements) = if labelled.is_permanent() {
            let turned = labelled.about_omega();
            (turned, Elements::permanent(&turned))
        } else {
            (labelled, Elements::of(&labelled))
        };
        let regime = Regime::of(principal, start.omega, &labelled);
        let labels = Rotation::from_axes(labelled.axes.map(Vector::from_array));
        let axes = Axes { columns: labelled.axes, rotation: labels };
        let kernel = if elements.m1.value() > BALANCE {
            let (series, phase) = Trigonometric::of(&elements);
            Kernel::Trigonometric(Flow::prepared(&elements, &axes, unit, series, phase, start.attitude))
        } else {
            let (series, phase) = Hyperbolic::of(&elements);
            Kernel::Hyperbolic(Flow::prepared(&elements, &axes, unit, series, phase, start.attitude))
        };
        let value = |x: Double| x.value();
        let [i1, i2, i3] = labelled.moments;
        let momentum: AngularVelocity<Body> =
            labels * Vector::from_array([0, 1, 2].map(|k| (labelled.moments[k] * labelled.omega[k]).value()));
        let twice_t =
            (0..3).fold(Double::default(), |sum, k| sum + labelled.moments[k] * labelled.omega[k].square());
        let [a1, a2, a3] = elements.amplitudes.map(value);
        // ℓ3 = A3 dn lies between A3 and A3 √(1 − m), where ℓ2 = A2
        let least_a3 = a3 * elements.m1.value().max(0.0).sqrt();
        Ok(Self {
            start,
            principal: *principal,
            regime,
            moments: labelled.moments.map(|i| i.value() * fine.unit),
            differences: [i2 - i3, i3 - i1, i1 - i2].map(|d| d.value() * fine.unit),
            labels,
            rates: elements.rates.map(|a| a.value() * unit),
            nutation: [libm::atan2(a1, a3), libm::atan2(a2, least_a3)],
            parameter: [elements.m.value(), elements.m1.value().max(0.0)],
            period: 4.0 * (elements.quarter / elements.lambda.abs()).value() / unit,
            precession: elements.half_precession.value() * (4.0 * core::f64::consts::PI) * unit,
            momentum: (momentum * unit * fine.unit).as_quantity(),
            kinetic_energy: 0.5 * twice_t.value() * unit * unit * fine.unit,
            unit,
            kernel,
        })
    }

    /// The state at a time, s; any time, before the start too.
    #[must_use]
    pub fn at(&self, time: f64) -> State {
        if time == self.start.time {
            return self.start;
        }
        let elapsed = &self.elapsed(time);
        let (q, omega) = match &self.kernel {
            Kernel::Trigonometric(flow) => flow.at(elapsed),
            Kernel::Hyperbolic(flow) => flow.at(elapsed),
        };
        State { time, attitude: Rotation::from_unit(q), omega: Vector::from_array(omega) }
    }

    #[inline(always)]
    fn elapsed<T: Real>(&self, time: T) -> Elapsed<T> {
        Elapsed::since(T::splat(self.start.time), time, T::splat(self.unit))
    }

    /// dω/dt in the body at one of the motion's states, rad/s²: i1 ω̇1 = (i2 − i3) ω2 ω3 and so on.
    pub fn angular_acceleration(&self, state: &State) -> AngularAcceleration<Body> {
        let w = self.labels.inverse() * state.omega;
        let ([i1, i2, i3], [d23, d31, d12]) = (self.moments, self.differences);
        let ratio = |d: f64, i: f64| if i == 0.0 { 0.0 } else { d / i };
        let rate: AngularAcceleration<Body> =
            Vector::new(ratio(d23, i1) * w.y * w.z, ratio(d31, i2) * w.z * w.x, ratio(d12, i3) * w.x * w.y);
        self.labels * rate
    }

    /// L = I ω of one of the motion's states, in body axes, kg·m²/s.
    pub fn angular_momentum(&self, state: &State) -> AngularMomentum<Body> {
        let w = self.labels.inverse() * state.omega;
        let [i1, i2, i3] = self.moments;
        let momentum: AngularMomentum<Body> = Vector::new(i1 * w.x, i2 * w.y, i3 * w.z);
        self.labels * momentum
    }

    /// Where it starts.
    pub const fn start(&self) -> State {
        self.start
    }

    /// Principal moments and axes.
    pub const fn principal(&self) -> &PrincipalFrame<Body> {
        &self.principal
    }

    /// Which kind of motion it is.
    pub const fn regime(&self) -> Regime {
        self.regime
    }

    /// True if L circles the axis of least moment or, in a permanent rotation, lies along it.
    pub fn circles_least(&self) -> bool {
        self.moments[2] < self.moments[0]
    }

    /// L in space, kg·m²/s: constant.
    pub fn momentum(&self) -> AngularMomentum<Space> {
        self.start.attitude * self.momentum
    }

    /// T, J: constant.
    pub const fn kinetic_energy(&self) -> f64 {
        self.kinetic_energy
    }

    /// The time after which ω repeats in the body, 4K(m)/λ, s; `None` where it never moves or never repeats.
    pub fn period(&self) -> Option<f64> {
        let repeats = self.period.is_finite() && self.parameter[1] > 0.0;
        (repeats && !matches!(self.regime, Regime::Permanent(_) | Regime::AtRest)).then_some(self.period)
    }

    /// Ω: the mean rate at which the axis that L circles precesses about L, rad/s; of a permanent rotation |ω|.
    ///
    /// Of the separatrix L/i2, the rate at which it ends.
    pub const fn precession_rate(&self) -> f64 {
        self.precession
    }

    /// The parameter m of the elliptic functions and 1 − m, each with its own digits.
    pub const fn parameter(&self) -> [f64; 2] {
        self.parameter
    }

    /// The smallest and the largest angle between L and the axis that it circles, rad.
    pub const fn nutation_range(&self) -> [f64; 2] {
        self.nutation
    }

    /// Moments in the labels of the motion, kg·m²: the third is that of the axis that L circles, the second the intermediate.
    pub const fn labelled_moments(&self) -> [f64; 3] {
        self.moments
    }

    /// The largest |ω| along each labelled axis, rad/s: ω = (a1 cn, a2 sn, a3 dn).
    pub const fn amplitudes(&self) -> [f64; 3] {
        self.rates
    }
}

/// The labelled axes in the body.
struct Axes {
    columns: [[f64; 3]; 3],
    rotation: Rotation<Body, Body>,
}

impl<S: flow::Family> Flow<f64, S> {
    fn prepared(
        elements: &Elements,
        axes: &Axes,
        unit: f64,
        series: S,
        start: [f64; 2],
        attitude: Attitude,
    ) -> Self {
        let turns = elements.lambda / elements.quarter.scaled(4.0);
        let scale = series.scale();
        let omega = [0, 1, 2]
            .map(|row| [0, 1, 2].map(|k| elements.rates[k].value() * unit * scale[k] * axes.columns[k][row]));
        let mut flow = Self {
            precession: FineRate::new(elements.half_precession.0),
            polhode: Rate::new([turns.high, turns.low]),
            start,
            omega,
            attitude: matrix_of(|q| q),
            series,
        };
        // attitude(t) = attitude(0) · P · q(0)⁻¹ · q(t) · P⁻¹, P the labelled axes in the body
        let (q, _) = flow.at(&Elapsed::new(0.0, 0.0));
        let left = quaternion_product(
            quaternion_product(attitude.quaternion(), axes.rotation.quaternion()),
            [q[0], -q[1], -q[2], -q[3]],
        );
        let right = axes.rotation.inverse().quaternion();
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
