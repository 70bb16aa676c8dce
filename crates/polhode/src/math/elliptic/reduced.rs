//! Any real number of quarter turns as whole half turns and a rest in [−½, ½] half turns, given by its sine and cosine.
//!
//! The same for an amplitude φ, whose quarter turn is π/2, and for an argument u, whose quarter is K.

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::triple::Triple;

/// Whole half turns, and a rest of at most a quarter turn either way by its sine and cosine.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reduced {
    /// The whole half turns, rounded if they are too many to count.
    pub(super) half_turns: f64,
    /// Whether they are odd.
    pub(super) odd: bool,
    /// Sine of the rest.
    pub(super) sin: Double,
    /// Cosine of the rest, not negative.
    pub(super) cos: Double,
}

impl Reduced {
    /// An angle in rad.
    pub(super) fn angle(phi: f64) -> Self {
        // 2/π = 8 / 4π
        Self::new(phi, Triple::INVERSE_4_PI.scaled(8.0))
    }

    /// `x` × `rate` quarter turns.
    ///
    /// Three words of rate leave the rest an absolute error of 2⁻¹⁵⁵ x rate. Beyond 2¹⁵⁰ quarters no rest can be told,
    /// and it is 0.
    pub(super) fn new(x: f64, rate: Triple) -> Self {
        let about = x * rate.value();
        if about.abs() > 1.4e45 {
            return Self { half_turns: 0.5 * about, odd: false, sin: Double::default(), cos: Double::ONE };
        }
        Self::of(Triple::from(x) * rate)
    }

    /// So many quarter turns, fewer than 2¹⁵⁰.
    pub(super) fn of(quarter_turns: Triple) -> Self {
        let mut rest = quarter_turns;
        let (mut quarters, mut quadrant) = (0.0, 0.0);
        // Whatever is whole in each word
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
            // a quarter more than the half turns below
            Self { half_turns: 0.5 * (quarters - 1.0), odd: quadrant == 3.0, sin: cos, cos: -sin }
        } else {
            // a quarter less than the half turns above
            Self { half_turns: 0.5 * (quarters + 1.0), odd: quadrant == 1.0, sin: -cos, cos: sin }
        }
    }

    /// half_turns × what half a turn is worth + what the rest is, rounded once.
    pub(super) fn unfolded(&self, half_turn: impl FnOnce() -> Double, rest: Double) -> f64 {
        if self.half_turns == 0.0 {
            return rest.value();
        }
        let half_turn = half_turn();
        // Two-word products stop before f64 does.
        if half_turn.high.is_finite() && self.half_turns.abs() < 1e30 {
            (Double::from(self.half_turns) * half_turn + rest).value()
        } else {
            self.half_turns * half_turn.high
        }
    }
}

/// e^iφ, φ in rad.
pub(crate) fn unit(phi: Double) -> Complex<Double> {
    // 2/π = 8 / 4π
    let Reduced { odd, sin, cos, .. } = Reduced::of(Triple::from(phi) * Triple::INVERSE_4_PI.scaled(8.0));
    let sign = if odd { -1.0 } else { 1.0 };
    Complex { re: cos.scaled(sign), im: sin.scaled(sign) }
}

/// The angle in [−π/2, π/2] of a sine and a cosine.
pub(super) fn arc(sin: Double, cos: Double) -> Double {
    let about = libm::atan2(sin.high, cos.high);
    let at = Reduced::angle(about);
    // φ − φ₀ = sin(φ − φ₀)
    Double::from(about) + (sin * at.cos - cos * at.sin)
}

/// sin x and cos x for |x| ≤ π/4, in two words.
fn sin_cos(x: Double) -> (Double, Double) {
    // sin(x/4) by its series, y (1 − y²/(2·3) (1 − y²/(4·5) (1 − …)))
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

/// sin 2x and cos 2x.
fn double_angle((sin, cos): (Double, Double)) -> (Double, Double) {
    ((sin * cos).scaled(2.0), Double::ONE - sin.square().scaled(2.0))
}
