//! Reduction of a real number of quarter turns to whole half turns and a remainder in [−½, ½] half
//! turns, given by its sine and cosine.
//!
//! The quarter turn is π/2 for an amplitude φ, and K for an argument u.

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::triple::Triple;

/// Whole half turns, and a remainder of at most a quarter turn in either direction, given by its
/// sine and cosine.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reduced {
    /// Number of whole half turns; rounded if it is too large to count exactly.
    pub(super) half_turns: f64,
    /// True if the number of half turns is odd.
    pub(super) odd: bool,
    /// Sine of the remainder.
    pub(super) sin: Double,
    /// Cosine of the remainder, not negative.
    pub(super) cos: Double,
}

impl Reduced {
    /// Reduces an angle in rad.
    pub(super) fn angle(phi: f64) -> Self {
        // 2/π = 8 / 4π.
        Self::new(phi, Triple::INVERSE_4_PI.scaled(8.0))
    }

    /// Reduces `x` · `rate` quarter turns.
    ///
    /// The absolute error of the remainder is 2⁻¹⁵⁵ x rate, for a triple-double rate. Beyond 2¹⁵⁰
    /// quarter turns the remainder is undetermined and set to 0.
    pub(super) fn new(x: f64, rate: Triple) -> Self {
        let about = x * rate.value();
        if about.abs() > 1.4e45 {
            return Self { half_turns: 0.5 * about, odd: false, sin: Double::default(), cos: Double::ONE };
        }
        Self::of(Triple::from(x) * rate)
    }

    /// Reduces a number of quarter turns, fewer than 2¹⁵⁰.
    pub(super) fn of(quarter_turns: Triple) -> Self {
        let mut rest = quarter_turns;
        let (mut quarters, mut quadrant) = (0.0, 0.0);
        // Removes the whole part of each word.
        for _word in 0..3 {
            let whole = rest.value().round();
            rest = rest - Triple::from(whole);
            quarters += whole;
            quadrant += whole % 4.0;
        }
        let quadrant = quadrant.rem_euclid(4.0);
        let (sin, cos) = sin_cos(rest.double() * Double::TAU.scaled(0.25));
        if quadrant % 2.0 == 0.0 {
            Self { half_turns: 0.5 * quarters, odd: quadrant == 2.0, sin, cos }
        } else if sin.high <= 0.0 {
            // One quarter more than the half turns below.
            Self { half_turns: 0.5 * (quarters - 1.0), odd: quadrant == 3.0, sin: cos, cos: -sin }
        } else {
            // One quarter less than the half turns above.
            Self { half_turns: 0.5 * (quarters + 1.0), odd: quadrant == 1.0, sin: -cos, cos: sin }
        }
    }

    /// Returns `half_turns` times the value of a half turn, plus the value of the remainder,
    /// rounded once.
    pub(super) fn unfolded(&self, half_turn: impl FnOnce() -> Double, rest: Double) -> f64 {
        if self.half_turns == 0.0 {
            return rest.value();
        }
        let half_turn = half_turn();
        // Double-double products overflow before f64 does.
        if half_turn.high.is_finite() && self.half_turns.abs() < 1e30 {
            (Double::from(self.half_turns) * half_turn + rest).value()
        } else {
            self.half_turns * half_turn.high
        }
    }
}

/// Returns e^iφ, φ in rad.
pub(crate) fn unit(phi: Double) -> Complex<Double> {
    // 2/π = 8 / 4π.
    let Reduced { odd, sin, cos, .. } = Reduced::of(Triple::from(phi) * Triple::INVERSE_4_PI.scaled(8.0));
    let sign = if odd { -1.0 } else { 1.0 };
    Complex { re: cos.scaled(sign), im: sin.scaled(sign) }
}

/// Returns the angle in [−π/2, π/2] for a sine and a cosine, rad.
pub(super) fn arc(sin: Double, cos: Double) -> Double {
    let about = libm::atan2(sin.high, cos.high);
    let at = Reduced::angle(about);
    // φ − φ₀ = sin(φ − φ₀) to double-double precision.
    Double::from(about) + (sin * at.cos - cos * at.sin)
}

/// Returns sin x and cos x for |x| ≤ π/4, in double-double precision.
fn sin_cos(x: Double) -> (Double, Double) {
    // Series of sin(x/4): y (1 − y²/(2·3) (1 − y²/(4·5) (1 − …))).
    let y = x.scaled(0.25);
    let minus_y2 = -y.square();
    let mut series = Double::ONE;
    for k in (1..=10).rev() {
        let k = f64::from(2 * k);
        series = Double::ONE + minus_y2 * series / Double::from(k * (k + 1.0));
    }
    let sin = y * series;
    let cos = (Double::ONE - sin.square()).sqrt();
    double_angle(double_angle((sin, cos)))
}

/// Returns sin 2x and cos 2x.
fn double_angle((sin, cos): (Double, Double)) -> (Double, Double) {
    ((sin * cos).scaled(2.0), Double::ONE - sin.square().scaled(2.0))
}
