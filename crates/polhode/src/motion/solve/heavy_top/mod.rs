//! Lagrange's top: motion of a heavy symmetric body held at a point of its axis, in closed form.
//!
//! - `nutation.rs`: the axis moves between two inclinations as sn².
//! - `cayley_klein.rs`: precession and spin are two integrals of the third kind, one for each
//!   Cayley–Klein parameter.
//! - `constants.rs`: the constants follow from the start without cancellation.
//!
//! The attitude is the quaternion of these parameters. Therefore no angle is undetermined if the
//! axis is vertical.

mod cayley_klein;
mod constants;
mod kernel;
mod nutation;
mod path;

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::elliptic::unit;
use crate::math::number::PI;
use crate::math::quaternion::Quaternion;
use crate::math::rotation::Rotation;
use crate::math::triple::Triple;
use crate::math::vector::AngularVelocity;

use super::reach::{Drift, is_within};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::gravity::UniformGravity;
use crate::motion::solve::at_times::at_times;
use crate::motion::solve::phase::Elapsed;
use cayley_klein::CayleyKlein;
use constants::Constants;
use kernel::Kernel;
use nutation::Nutation;

pub use path::{SteadyPrecession, TopPath};

/// Motion of a heavy symmetric top: ω and attitude at any time, past or future, in constant time.
///
/// The body is held at a pivot. Its inertia tensor about the pivot is A 1 + (C − A) e eᵀ, where e
/// points from the pivot to the centre of mass. Gravity can have any direction. The angles are
/// those of e: inclination θ from the vertical (against gravity), precession φ about the vertical,
/// and spin ψ about e.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::{HeavyTop, TopPath};
/// // The top of Landau & Lifshitz §35 with A = 1, C = 1/2, M g l = 1, leaning by 60° and let go.
/// let inertia = InertiaTensor::diagonal([0.75, 0.75, 0.5])?; // about the centre of mass, half a metre from the tip
/// let body = MassProperties::new(1.0, Position::new(0.0, 0.0, 0.5), inertia)?;
/// let top = Rotor::pivoted(&body, Position::ZERO);
/// let gravity = UniformGravity { acceleration: Acceleration::new(0.0, 0.0, -2.0) };
/// let attitude = Attitude::from_euler313([0.0, 60_f64.to_radians(), 0.0])?;
/// let start = State { time: 0.0, attitude, omega: AngularVelocity::new(0.0, 0.0, 5.0) };
/// let motion = HeavyTop::of(&top, &gravity, start)?;
/// assert_eq!(motion.path(), TopPath::Cusps);
/// let [highest, lowest] = motion.nutation_bounds();
/// assert!((highest - 60_f64.to_radians()).abs() < 1e-15);
/// // The lowest angle solves (C ω3)² (cos 60° − cos θ) = 2 A M g l sin²θ.
/// let c = lowest.cos();
/// assert!((6.25 * (0.5 - c) - 2.0 * (1.0 - c * c)).abs() < 1e-14);
/// let nod = motion.nutation_period().unwrap();
/// let again = motion.at(nod).attitude.euler313();
/// assert!((again[1] - highest).abs() < 1e-7 && (again[0] - motion.mean_precession().unwrap() * nod).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Accuracy
/// The errors below are for exact inputs (tensor, lever, gravity, ω and attitude), against
/// references of 32 digits. Attitude: 9·10⁻¹⁶ rad. ω: 6·10⁻¹⁶, relative to the greater of |ω| and
/// √(M g l/A). They are the same after 1000 nutations, and down to 1 − m = 2·10⁻¹⁵.
///
/// Constants have three words, rates of phases two, and integrals of the third kind 22 digits. On
/// the separatrix itself (1 − m = 0) the hyperbolic functions have one word. Constants that differ
/// from those of the separatrix by less than 10⁻⁴⁵ of their terms count as equal.
///
/// A tensor that is symmetric only to rounding (16 ε of its greatest moment) is treated as
/// symmetric. The effect of this change grows with time.
///
/// The constants take 33 µs, a state 50 ns, or 17 ns per state for many times. Measured by
/// `tests/all/heavy_top.rs`.
///
/// # Source
/// Landau & Lifshitz, Mechanics, §35, problem 1; Goldstein, Classical Mechanics, §5.7; `book/tops.md`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeavyTop {
    start: State,
    path: TopPath,
    moments: [f64; 2],
    weight: f64,
    /// rad/s per unit of the rates below: a power of two.
    unit: f64,
    vertical: Quaternion<Double>,
    axis: Quaternion<Double>,
    /// ω3 in `unit`.
    spin: Double,
    /// ½(ω3 − a): steady rate of the phase of P. The phase of Q has the opposite rate. Nutation
    /// adds to both.
    turning: Double,
    nods: Option<Nods>,
    /// Theta functions; `None` on the separatrix and for an axis that stays vertical.
    kernel: Option<Kernel>,
    reach: f64,
}

/// Constants of a motion whose axis is not always vertical.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Nods {
    nutation: Nutation,
    /// P and Q, and the complex factors of absolute value 1 that match them to the start.
    halves: [(CayleyKlein, Complex<Double>); 2],
}

impl HeavyTop {
    /// Returns the motion that starts from a state.
    ///
    /// # Errors
    /// - [`MotionError::NoClosedForm`] for wheels, no gravity, a centre of mass at the pivot, or a
    ///   body that is not symmetric about the line from the pivot to its centre of mass.
    /// - [`MotionError::NotSpinnable`] for a body without inertia.
    /// - A parameter error ([`MotionError::is_parameter`]) for numbers that are not finite.
    pub fn of(rotor: &Rotor, gravity: &UniformGravity, start: State) -> Result<Self, MotionError> {
        for (what, value) in [
            ("the start's time", start.time),
            ("the start's angular velocity", start.omega.norm()),
            ("the acceleration of gravity", gravity.acceleration.norm()),
        ] {
            require::finite(what, value)?;
        }
        let top = Constants::of(rotor, gravity, &start)?;
        let double = |q: Quaternion<Triple>| Quaternion(q.0.map(Triple::double));
        let turning = (top.spin - top.a).scaled(0.5).double();
        let still = top.across.norm_squared().is_zero();
        let vertical = top.from_top.is_zero() || top.from_bottom.is_zero();
        let nods = (!(still && vertical)).then(|| Nods::of(&top, turning));
        let spin = top.spin.double();
        let turns = (turning.value().abs() + spin.value().abs()) / (2.0 * PI);
        let reach = nods.as_ref().map_or(Drift(TWO_WORDS * turns).reach(), |nods| nods.reach(turns));
        let vertical_and_axis = [double(top.vertical), double(top.axis)];
        let moves = nods.as_ref().filter(|nods| nods.nutation.parameter.complement() > 0.0);
        let kernel = moves.map(|nods| Kernel::of(nods, vertical_and_axis, [turning, spin], top.unit));
        Ok(Self {
            start,
            kernel,
            path: TopPath::of(&top, nods.as_ref().map(|nods| &nods.nutation)),
            moments: top.moments,
            weight: top.weight,
            unit: top.unit,
            vertical: double(top.vertical),
            axis: double(top.axis),
            spin,
            turning,
            nods,
            reach: (reach / top.unit).min(f64::MAX),
        })
    }

    /// Returns the state at a time, s, which may be before the start. Beyond [`HeavyTop::reach`],
    /// and for a time that is NaN, ω and attitude are NaN.
    #[must_use]
    pub fn at(&self, time: f64) -> State {
        if time == self.start.time {
            return self.start;
        }
        if !is_within(&self.start, self.reach, time) {
            return State::unknown(time);
        }
        match (&self.kernel, &self.nods) {
            (Some(kernel), _) => {
                let (attitude, omega) = kernel.at(&Elapsed::since::<false>(self.start.time, time, self.unit));
                let (attitude, omega) = (Rotation::from_unit(attitude), AngularVelocity::from_array(omega));
                State { time, attitude, omega }
            }
            (None, Some(nods)) => self.by_integrals(nods, time),
            (None, None) => self.turned(time),
        }
    }

    /// Computes a state by Legendre's integrals in two words. Needed on the separatrix, where the
    /// theta functions have no period.
    fn by_integrals(&self, nods: &Nods, time: f64) -> State {
        let ([p, q], across) = nods.at(self.elapsed(time), self.turning);
        let [w, x, y, z] = [p.re, q.re, q.im, p.im];
        let Quaternion(attitude) = self.vertical.times(Quaternion([w, x, y, z])).times(self.axis.conjugate());
        let omega = self.axis.turned([across.re, across.im, self.spin]);
        State {
            time,
            attitude: Rotation::near_unit(attitude.map(Double::value)),
            omega: AngularVelocity::from_array(omega.map(|w| w.value() * self.unit)),
        }
    }

    fn elapsed(&self, time: f64) -> Double {
        Double::sum(time, -self.start.time) * Double::from(self.unit)
    }

    /// Returns the states at many times (s), in their order. Each is bit-identical to
    /// [`HeavyTop::at`]; the computation is several times faster.
    #[must_use]
    pub fn at_times(&self, times: &[f64]) -> Vec<State> {
        let Some(kernel) = &self.kernel else { return times.iter().map(|&time| self.at(time)).collect() };
        at_times(
            times,
            &self.start,
            self.reach,
            self.unit,
            #[inline(always)]
            |elapsed| kernel.at(elapsed),
        )
    }

    /// Returns the time before and after the start for which the attitude is accurate to 1e-6 rad,
    /// for exact inputs, s. It is 2⁵² nutations, and less near the separatrix.
    pub const fn reach(&self) -> f64 {
        self.reach
    }

    /// Returns the state of a vertical top, which only rotates about its axis.
    fn turned(&self, time: f64) -> State {
        let turn = unit((self.spin * self.elapsed(time)).scaled(0.5));
        let zero = Double::default();
        let about_axis = Quaternion([turn.re, zero, zero, turn.im]);
        let start = Quaternion(self.start.attitude.quaternion().map(Double::from)).unit();
        let Quaternion(attitude) = start.times(self.axis).times(about_axis).times(self.axis.conjugate());
        State { time, attitude: Rotation::near_unit(attitude.map(Double::value)), omega: self.start.omega }
    }

    /// Returns the state at the start.
    pub const fn start(&self) -> State {
        self.start
    }

    /// Returns the moments about the pivot, kg·m²: A perpendicular to the axis, C about the axis.
    pub const fn moments(&self) -> [f64; 2] {
        self.moments
    }

    /// Returns M g l, the torque of the weight when the axis is horizontal, N·m.
    pub const fn weight_torque(&self) -> f64 {
        self.weight
    }

    /// Returns ω3, the constant component of ω along the axis, rad/s.
    pub fn spin(&self) -> f64 {
        self.spin.value() * self.unit
    }

    /// Returns the kind of motion of the axis.
    pub const fn path(&self) -> TopPath {
        self.path
    }

    /// Returns the smallest and the largest angle between the axis and the vertical, rad.
    pub fn nutation_bounds(&self) -> [f64; 2] {
        let Some(Nods { nutation, .. }) = &self.nods else {
            return if self.path == TopPath::Hanging { [core::f64::consts::PI; 2] } else { [0.0; 2] };
        };
        let [lowest, highest, _] = nutation.from_top.map(Double::value);
        let [low, high, _] = nutation.from_bottom.map(Double::value);
        [path::angle(highest, high), path::angle(lowest, low)]
    }

    /// Returns the period of θ, 2K(m)/λ, s. In a steady precession it is the period of small
    /// nutations.
    ///
    /// `None` on the separatrix, and if the axis stays vertical.
    pub fn nutation_period(&self) -> Option<f64> {
        let nutation = &self.nods.as_ref()?.nutation;
        let period = nutation.parameter.quarter().scaled(2.0) / nutation.rate;
        Some(period.value() / self.unit).filter(|period| period.is_finite())
    }

    /// Returns the mean rate of φ over a nutation, rad/s. φ is the angle of the axis about the
    /// vertical, right-handed about the direction against gravity.
    ///
    /// `None` on the separatrix, if the axis stays vertical, and if it passes through the vertical.
    /// In the last case φ jumps by half a turn; see [`HeavyTop::precession_in_a_nutation`].
    pub fn mean_precession(&self) -> Option<f64> {
        self.mean_rates().filter(|_| self.path != TopPath::ThroughVertical).map(|[precession, _]| precession)
    }

    /// Returns the precession angle between two successive extrema of θ of the same kind, rad. It
    /// is right-handed about the direction against gravity.
    ///
    /// If the axis passes through the vertical, the number of turns is undefined, and the angle is
    /// between −π and π. `None` on the separatrix, and if the axis stays vertical.
    pub fn precession_in_a_nutation(&self) -> Option<f64> {
        self.nutation_period()?;
        let Nods { nutation, halves: [(p, _), (q, _)] } = self.nods.as_ref()?;
        // φ = arg P + arg Q
        let [p, q] = [p, q].map(|half| half.whole_gain(&nutation.parameter));
        let turned = (p + q).value();
        let turns = (turned / core::f64::consts::TAU).round();
        Some(if self.path == TopPath::ThroughVertical {
            turned - core::f64::consts::TAU * turns
        } else {
            turned
        })
    }

    /// Returns the mean rate of ψ over a nutation, rad/s. ψ is the rotation of the body about its
    /// axis, measured from the plane through the vertical.
    ///
    /// `None` in the same cases as [`HeavyTop::mean_precession`].
    pub fn mean_spin(&self) -> Option<f64> {
        self.mean_rates().filter(|_| self.path != TopPath::ThroughVertical).map(|[_, spin]| spin)
    }

    fn mean_rates(&self) -> Option<[f64; 2]> {
        self.nutation_period()?;
        let Nods { nutation, halves: [(p, _), (q, _)] } = self.nods.as_ref()?;
        let period = nutation.parameter.quarter().scaled(2.0) / nutation.rate;
        // φ = arg P + arg Q, ψ = arg P − arg Q
        let [p, q] = [p, q].map(|half| half.gain(&nutation.parameter) / period);
        let mean = |rate: Double| rate.value() * self.unit;
        Some([mean(p + q), mean(p - q + self.turning.scaled(2.0))])
    }

    /// Returns the parameter m of the elliptic functions, and 1 − m; `None` if the axis stays
    /// vertical.
    pub fn parameter(&self) -> Option<[f64; 2]> {
        let parameter = &self.nods.as_ref()?.nutation.parameter;
        Some([parameter.m(), parameter.complement()])
    }

    /// Returns the roots u₁ ≤ u₂ ≤ u₃ of f(u) = u̇², u = cos θ. The axis moves between u₁ and u₂;
    /// u₃ ≥ 1. `None` if the axis stays vertical.
    ///
    /// f(u) = (1 − u²)(2E′ − 2 M g l u)/A − (p_φ − p_ψ u)²/A², u = u₁ + (u₂ − u₁) sn²(λ t + δ), and
    /// λ² = M g l (u₃ − u₁)/2A.
    ///
    /// Source: Goldstein, Classical Mechanics, §5.7.
    pub fn roots(&self) -> Option<[f64; 3]> {
        let nutation = &self.nods.as_ref()?.nutation;
        let [lowest, highest, third] = nutation.from_top.map(Double::value);
        Some([1.0 - lowest, 1.0 - highest, 1.0 + third])
    }

    /// Returns the sleeping-top threshold 2√(M g l A)/C, rad/s; infinite if C = 0. An upright top
    /// is stable if its spin is faster.
    pub fn sleeping_threshold(&self) -> f64 {
        let [across, along] = self.moments;
        2.0 * (self.weight * across).sqrt() / along
    }

    /// Returns the rates of steady precession at an angle from the vertical (rad) with the spin ω3
    /// (rad/s).
    ///
    /// `None` if the spin is too slow, |ω3| < 2√(M g l A cos θ)/C, or for a horizontal axis without
    /// spin.
    pub fn steady_precession(&self, angle: f64, spin: f64) -> Option<SteadyPrecession> {
        let (_, cosine) = crate::math::number::sin_cos(angle);
        SteadyPrecession::of(self.moments, self.weight, cosine, spin)
    }
}

/// Relative uncertainty of a turn, for rates of two words.
const TWO_WORDS: f64 = 1e-30;

/// Uncertainty of the phase gained in a nutation, rad: integrals of the third kind have 24 digits.
const INTEGRALS: f64 = 1e-23;

/// Relative uncertainty of the roots of the cubic, whose coefficients have three words.
const ROOTS: f64 = 1e-45;

/// Largest number of nutations within the reach, 2⁵². Beyond it their number is not exact in f64.
const MOST_NUTATIONS: f64 = 4_503_599_627_370_496.0;

impl Nods {
    /// Returns the reach, in the time unit of the constants. `turns`: number of turns per unit time
    /// in addition to the nutation.
    fn reach(&self, turns: f64) -> f64 {
        let Nutation { rate, ref parameter, ref spread, .. } = self.nutation;
        let rate = rate.value();
        let half_period = parameter.quarter().value() / rate;
        if !half_period.is_finite() {
            let linear: f64 = self.halves.iter().map(|(half, _)| half.linear_rate().abs()).sum();
            return Drift(TWO_WORDS * (turns + (1.0 + linear) * rate)).reach();
        }
        let gained: f64 = self.halves.iter().map(|(half, _)| half.gain(parameter).value().abs()).sum();
        let turns = turns + (PI + gained) / (2.0 * half_period);
        // K ≈ ½ ln(16/(1 − m)): the uncertainty of 1 − m = (v₂ − v₃)/(v₁ − v₃) enters in every
        // nutation
        let uncertain = ROOTS / (parameter.complement() * spread.value());
        let law = Drift(TWO_WORDS * turns + (INTEGRALS + uncertain) / (2.0 * half_period)).reach();
        law.min(2.0 * half_period * MOST_NUTATIONS).max(half_period)
    }

    fn of(top: &Constants, turning: Double) -> Self {
        let nutation = Nutation::of(top);
        let half_by_rate = |c: Triple| c.double().scaled(0.5) / nutation.rate;
        let Nutation { from_top, from_bottom, swing, spread, ref parameter, .. } = nutation;
        let p = CayleyKlein::new(from_bottom, -swing, spread, half_by_rate(top.b_plus_a), parameter);
        let q = CayleyKlein::new(from_top, swing, spread, half_by_rate(top.b_minus_a), parameter);
        let at = parameter.amplitude(nutation.start);
        let [p0, q0] = top.start.map(double);
        let (across, spin) = (double(top.across), top.spin.double());
        // q̇ = ½ q ω:  Ṗ = ½(iω3 P − Q W*),  Q̇ = ½(P W − iω3 Q),  W = ω1 + iω2
        let half = Double::from(0.5);
        let p_rate = p0.times_i().scaled(spin).minus(q0.times(across.conjugate())).scaled(half);
        let q_rate = p0.times(across).minus(q0.times_i().scaled(spin)).scaled(half);
        let factor = |half: &CayleyKlein, value: Complex<Double>, rate: Complex<Double>, turning: Double| {
            let jet = half.at(parameter, nutation.start, &at);
            // Either Z or, if the axis is vertical, its derivative determines the direction.
            let own = rate.minus(value.times_i().scaled(turning));
            let sum = jet.value.conjugate().times(value);
            let sum = sum.plus(jet.rate.scaled(nutation.rate).conjugate().times(own));
            let size = sum.norm_squared().sqrt();
            if size.is_zero() {
                return Complex { re: Double::ONE, im: Double::default() };
            }
            Complex { re: sum.re / size, im: sum.im / size }
        };
        let halves = [(p, factor(&p, p0, p_rate, turning)), (q, factor(&q, q0, q_rate, -turning))];
        Self { nutation, halves }
    }

    /// Returns P and Q, and ω1 + iω2, after a time.
    fn at(&self, elapsed: Double, turning: Double) -> ([Complex<Double>; 2], Complex<Double>) {
        let Nutation { rate, start, ref parameter, .. } = self.nutation;
        let x = start + rate * elapsed;
        let amplitude = parameter.amplitude(x);
        let [(p, p0), (q, q0)] = &self.halves;
        let steady = turning * elapsed;
        let evaluated = |half: &CayleyKlein, factor: &Complex<Double>, phase: Double, turning: Double| {
            let turn = unit(phase).times(*factor);
            let jet = half.at(parameter, x, &amplitude);
            let [value, change] = [jet.value, jet.rate].map(|z| z.times(turn));
            (value, change.scaled(rate).plus(value.times_i().scaled(turning)))
        };
        let (p, p_rate) = evaluated(p, p0, steady, turning);
        let (q, q_rate) = evaluated(q, q0, -steady, -turning);
        // ω1 + iω2 = 2(P* Q̇ − Q Ṗ*)
        let across = p.conjugate().times(q_rate).minus(q.times(p_rate.conjugate()));
        ([p, q], across.scaled(Double::from(2.0)))
    }
}

fn double(z: Complex<Triple>) -> Complex<Double> {
    Complex { re: z.re.double(), im: z.im.double() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{InertiaTensor, MassProperties};
    use crate::math::rotation::Attitude;
    use crate::math::vector::{Acceleration, Position};

    /// Returns a pseudorandom number between −1 and 1.
    fn random(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Compares 3000 tops of every kind: fast, slow, nearly steady, planar, and near the vertical
    /// or the separatrix.
    #[test]
    fn theta_functions_agree_with_the_integrals_in_two_words() {
        let mut seed = 20;
        let (mut worst, mut kinds) = ([0.0_f64; 2], std::collections::BTreeMap::new());
        for k in 0..3000 {
            let mut number = |scale: f64| scale * random(&mut seed);
            let (across, along) = (0.5 + number(0.45), 0.6 + number(0.5));
            let along = along.min(2.0 * across);
            let inertia = InertiaTensor::diagonal([across, across, along]).unwrap();
            let arm = Position::new(0.0, 0.0, 0.4 + number(0.3));
            let body = MassProperties::new(1.7, arm, inertia).unwrap();
            let gravity = UniformGravity { acceleration: Acceleration::new(0.0, 0.0, -9.81) };
            let rotor = Rotor::pivoted(&body, Position::ZERO);
            let angle = match k % 8 {
                0 => 10f64.powf(number(3.0) - 4.0),
                1 => PI - 10f64.powf(number(3.0) - 4.0),
                2 => 0.0,
                3 => PI,
                _ => 1.55 + number(1.5),
            };
            let omega = match k % 5 {
                0 => [number(1e-3), number(1e-3), number(40.0)],
                1 => [number(3.0), number(3.0), 0.0],
                2 => [0.0, 0.0, number(20.0)],
                3 => [number(9.0), number(9.0), number(9.0)],
                _ => [number(30.0), number(1.0), number(2.0)],
            };
            let attitude = Attitude::from_euler313([number(3.0), angle, number(3.0)]).unwrap();
            let start = State { time: number(5.0), attitude, omega: AngularVelocity::from_array(omega) };
            let motion = HeavyTop::of(&rotor, &gravity, start).unwrap();
            let Some(nods) = &motion.nods else { continue };
            assert!(motion.kernel.is_some());
            *kinds.entry(motion.path().name()).or_insert(0) += 1;
            let times: Vec<f64> = (0..11).map(|_| number(10.0)).collect();
            let states = motion.at_times(&times);
            // rate scale of an attitude error: √(M g l/A)
            let pendulum = (motion.weight / motion.moments[0]).sqrt();
            let rates = times.iter().map(|&time| motion.by_integrals(nods, time).omega.norm());
            let fastest = rates.fold(pendulum, f64::max);
            for (&time, state) in times.iter().zip(&states) {
                assert_eq!(*state, motion.at(time));
                let want = motion.by_integrals(nods, time);
                let error =
                    [state.attitude.angle_to(want.attitude), (state.omega - want.omega).norm() / fastest];
                assert!(error[0] < 3e-15 && error[1] < 2e-15, "{k} {time}: {error:?} {start:?}");
                worst = [worst[0].max(error[0]), worst[1].max(error[1])];
            }
        }
        println!("{worst:?} {kinds:?}");
        assert!(kinds.len() >= 4, "{kinds:?}");
    }
}
