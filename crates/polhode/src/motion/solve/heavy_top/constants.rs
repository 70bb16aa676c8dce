//! Constants of a motion from its start, in three words, so that nearly vanishing quantities keep
//! their precision.
//!
//! k is the vertical (against gravity), e the top's axis (from the pivot to the centre of mass).
//! The third body axis used here is e, the third space axis is k. P = w + iz and Q = x + iy, from
//! the quaternion between these axes, are the Cayley–Klein parameters cos ½θ e^½i(φ+ψ) and sin ½θ
//! e^½i(φ−ψ).

use crate::math::complex::Complex;
use crate::math::frame::Body;
use crate::math::quaternion::Quaternion;
use crate::math::symmetric3::power_of_two_near;
use crate::math::triple::Triple;
use crate::math::vector::Direction;
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::gravity::UniformGravity;

/// Constants of the top and of its start. Rates are in `unit`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constants {
    /// Unit of rates, a power of two, rad/s.
    pub(super) unit: f64,
    /// Moments about the pivot, kg·m²: A perpendicular to the axis, C about the axis.
    pub(super) moments: [f64; 2],
    /// M g l, N·m.
    pub(super) weight: f64,
    /// Rotation from z to the vertical, in space.
    pub(super) vertical: Quaternion<Triple>,
    /// Rotation from z to the top's axis, in the body.
    pub(super) axis: Quaternion<Triple>,
    /// P and Q at the start.
    pub(super) start: [Complex<Triple>; 2],
    /// ω1 + iω2 at the start: the components perpendicular to the axis.
    pub(super) across: Complex<Triple>,
    /// ω3 at the start: the component along the axis.
    pub(super) spin: Triple,
    /// a = C ω3/A
    pub(super) a: Triple,
    /// β = 2 M g l/A
    pub(super) beta: Triple,
    /// 1 − cos θ at the start.
    pub(super) from_top: Triple,
    /// 1 + cos θ at the start.
    pub(super) from_bottom: Triple,
    /// d(cos θ)/dt at the start.
    pub(super) fall: Triple,
    /// b − a, where b = k · L/A.
    pub(super) b_minus_a: Triple,
    /// b + a, where b = k · L/A.
    pub(super) b_plus_a: Triple,
    /// α − β: (ω1² + ω2²) − β (1 − cos θ)
    pub(super) excess: Triple,
}

/// Tolerance for the symmetry of the tensor, relative to its greatest moment. Sums over the parts
/// of a body leave rounding errors of this size.
const SYMMETRIC: f64 = 16.0 * f64::EPSILON;

impl Constants {
    /// Computes the constants from the body, gravity and the start.
    ///
    /// # Errors
    /// Those of [`HeavyTop::of`](super::HeavyTop::of).
    pub(super) fn of(rotor: &Rotor, gravity: &UniformGravity, start: &State) -> Result<Self, MotionError> {
        require_top(rotor)?;
        let no = |why| MotionError::NoClosedForm { why };
        let Some((down, g)) = split(gravity.acceleration.to_array()) else {
            return Err(no("gravity is zero"));
        };
        let Some((e, l)) = split(rotor.lever().to_array()) else {
            return Err(no("the centre of mass is at the pivot"));
        };

        // C = e · I e,  A = ½ (tr I − C)
        let scale = power_of_two_near(rotor.principal().moments()[2]);
        let rows = rotor.inertia().matrix().map(|row| row.map(|i| Triple::from(i / scale)));
        let [axial, trace] = [dot(e, rows.map(|row| dot(row, e))), rows[0][0] + rows[1][1] + rows[2][2]];
        let axial = if rotor.principal().moments()[0] == 0.0 { Triple::default() } else { axial };
        let transverse = (trace - axial).scaled(0.5);

        let largest = start.omega.max_abs();
        let ratio = 2.0 * rotor.mass() * g.1 / (transverse.value() * scale) * l.1;
        let beta = ratio * g.0.value() * l.0.value();
        let unit = power_of_two_near(largest.max(beta.sqrt()));
        let mass = power_of_two_near(rotor.mass());
        let beta_unit = 2.0 * (mass / scale) * (g.1 / unit) * (l.1 / unit);
        let beta = (Triple::from(rotor.mass() / mass) * g.0 * l.0 / transverse).scaled(beta_unit);
        let holds = beta.value() > 0.0 && beta.value().is_finite() && largest.is_finite();
        let rule = "finite and in the range of numbers, with the weight's torque";
        require::that("the start's angular velocity", largest, holds, rule)?;

        let up = down.map(|c| -c);
        let vertical = Quaternion::from_z_to(up, up[2].value() < 0.0);
        let axis = Quaternion::from_z_to(e, e[2].value() < 0.0);
        let attitude = Quaternion(start.attitude.quaternion().map(Triple::from)).unit();
        let Quaternion([w, x, y, z]) = vertical.conjugate().times(attitude).times(axis);
        let (p, q) = (Complex { re: w, im: z }, Complex { re: x, im: y });
        let omega = start.omega.to_array().map(|c| Triple::from(c / unit));
        let [x, y, spin] = axis.conjugate().turned(omega);
        let across = Complex { re: x, im: y };

        let a = axial * spin / transverse;
        let [from_top, from_bottom] = [q, p].map(|half| half.norm_squared().scaled(2.0));
        // k1 + i k2 = 2i P* Q. The real part of (k1 − i k2)(ω1 + iω2) is k · ω without its part
        // along the axis; the imaginary part is d(cos θ)/dt.
        let turning = p.times(q.conjugate()).times_i().times(across).scaled(Triple::from(-2.0));
        let b_minus_a = turning.re - a * from_top;
        let excess = across.norm_squared() - beta * from_top;
        Ok(Self {
            unit,
            moments: [transverse, axial].map(|i| i.value() * scale),
            weight: rotor.mass() * (g.0.value() * g.1) * (l.0.value() * l.1),
            vertical,
            axis,
            start: [p, q],
            across,
            spin,
            a,
            beta,
            from_top,
            from_bottom,
            fall: turning.im,
            b_minus_a: unless_rounding(b_minus_a, turning.re),
            b_plus_a: unless_rounding(turning.re + a * from_bottom, turning.re),
            excess: unless_rounding(excess, across.norm_squared()),
        })
    }
}

/// Returns `difference`, or zero if it is below the rounding error of three words, relative to
/// `term`.
fn unless_rounding(difference: Triple, term: Triple) -> Triple {
    if difference.value().abs() <= 1e-45 * term.value().abs() { Triple::default() } else { difference }
}

fn dot(a: [Triple; 3], b: [Triple; 3]) -> Triple {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns the direction of a vector and its length, the length as a number times a power of two;
/// `None` for the zero vector.
fn split(v: [f64; 3]) -> Option<([Triple; 3], (Triple, f64))> {
    let unit = power_of_two_near(v.iter().fold(0.0, |max: f64, c| max.max(c.abs())));
    let v = v.map(|c| Triple::from(c / unit));
    let length = dot(v, v).sqrt();
    (length.value() > 0.0).then(|| (v.map(|c| c / length), (length, unit)))
}

/// Checks that the body is a symmetric top about the pivot.
///
/// # Errors
/// - [`MotionError::NoClosedForm`] for wheels, a centre of mass at the pivot, or a body without
///   this symmetry.
/// - [`MotionError::NotSpinnable`] for a body without inertia.
fn require_top(rotor: &Rotor) -> Result<(), MotionError> {
    let no = |why| Err(MotionError::NoClosedForm { why });
    if !rotor.wheels().is_empty() {
        return no("wheels spin in the body");
    }
    if !rotor.is_spinnable() {
        return Err(MotionError::NotSpinnable);
    }
    let lever: Direction<Body> = rotor.lever().as_quantity();
    let Some(e) = lever.direction() else { return no("the centre of mass is at the pivot") };
    // I = A 1 + (C − A) e eᵀ
    let axial = rotor.inertia().about_axis(e);
    let rows = rotor.inertia().matrix();
    let transverse = 0.5 * (rows[0][0] + rows[1][1] + rows[2][2] - axial);
    let e = e.to_array();
    let largest = rotor.principal().moments()[2];
    for (i, row) in rows.iter().enumerate() {
        for (j, element) in row.iter().enumerate() {
            let one = if i == j { transverse } else { 0.0 };
            let departure = element - (one + (axial - transverse) * e[i] * e[j]);
            // Negated, so that NaN is also rejected.
            if !(departure.abs() <= SYMMETRIC * largest) {
                return no("the body is not symmetric about the line from the pivot to its centre of mass");
            }
        }
    }
    Ok(())
}
