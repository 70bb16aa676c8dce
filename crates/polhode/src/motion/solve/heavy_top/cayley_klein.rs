//! One Cayley–Klein parameter Z of a heavy top (P or Q) as a function of its nutation.
//!
//! |Z|² = ½y with y = 1 ± cos θ = y₁ cn² + y₂ sn². Its phase advances by ½(b ± a)∫dt/y, in addition
//! to a constant rate. With h = (b ± a)/2λ the integral is of the third kind:
//!
//! Z = √(½y) exp(i (h/y₁) Π(n; x)),  n = 1 − y₂/y₁.
//!
//! The change of the characteristic from n to N = m/n (DLMF 19.7.8) splits off an arctangent:
//!
//! Z = (A cn dn + iG sn)/q · exp(i ρ),  q² = cn² + N₁ sn²,  A² = ½y₁,  G² = ½ y₂|y₃|/(v₁ − v₃),
//!
//! where N₁ = 1 − N = |y₃|/(v₁ − v₃). The second form is smooth through the vertical. There y₁ or
//! y₂ is 0, and the first form has an infinite rate. The first form is smooth where the third root
//! is the vertical. The form with the smaller of |n| and |N| is used.
//!
//! Source: Klein & Sommerfeld, Über die Theorie des Kreisels, ch. VI, for the parameters as theta
//! functions. The form used here was derived for polhode.

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::elliptic::{Amplitude, EllipticParameter, unit};

/// Z as a function of x. At x = 0 the factor √(½y) or (A cn dn + iG sn)/q is real and positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CayleyKlein {
    form: Form,
    h: Double,
    /// Coefficients of the phase, linear · x + third · ⅓ sn³ R_J(cn², dn², 1, cn² + n₁ sn²),
    /// continued over all periods.
    linear: Double,
    third: Double,
    n1: Double,
    /// ⅓ R_J over a quarter period.
    complete: Double,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    /// Form √(½y).
    Modulus { y1: Double, y2: Double },
    /// Form (A cn dn + iG sn)/q.
    Product { a: Double, g: Double },
}

/// Value and derivative with respect to x.
#[derive(Clone, Copy, Debug)]
pub(super) struct QuaternionJet {
    pub(super) value: Complex<Double>,
    pub(super) rate: Complex<Double>,
}

impl CayleyKlein {
    /// Chooses the form. Arguments: [y₁, y₂, |y₃|]; y₁ − y₂ with its sign; v₁ − v₃; h.
    pub(super) fn new(
        [y1, y2, y3]: [Double; 3],
        falls: Double,
        spread: Double,
        h: Double,
        parameter: &EllipticParameter,
    ) -> Self {
        // |n| ≤ |N|, from 1 − n = y₂/y₁ and 1 − N: both are below 1 if y decreases, and above 1 if
        // it increases.
        let (n1, other) = (y2 * spread, y3 * y1);
        let modulus = y1.high > 0.0 && if falls.high >= 0.0 { n1 >= other } else { n1 <= other };
        let (form, linear, third, n1) = if modulus {
            let linear = h / y1;
            (Form::Modulus { y1, y2 }, linear, linear * falls / y1, y2 / y1)
        } else {
            let g = (y2 * y3 / spread).scaled(0.5).sqrt();
            // If h = 0, either A or G is 0, and the sign is arbitrary.
            let form = Form::Product { a: y1.scaled(0.5).sqrt(), g: if h.high < 0.0 { -g } else { g } };
            // g (F − Π(N)) = −g N · ⅓ sn³ R_J, |g N| = |h|/(v₁ − v₃); N < 0 if y increases
            let third = h / spread;
            (form, Double::default(), if falls.high < 0.0 { third } else { -third }, y3 / spread)
        };
        // The complete integral is not needed at m = 1 (without half turns) or if y₃ =
        // 0, where the coefficient of the third kind is 0.
        let has_turns = parameter.complement() > 0.0 && n1.high > 0.0;
        let complete = if has_turns { parameter.complete_third(n1) } else { Double::default() };
        Self { form, h, linear, third, n1, complete }
    }

    /// Linear part of the phase, per unit of x.
    pub(super) fn linear_rate(&self) -> f64 {
        self.linear.value()
    }

    /// Returns Z and its derivative at x, whose amplitude is `at`.
    pub(super) fn at(&self, parameter: &EllipticParameter, x: Double, at: &Amplitude) -> QuaternionJet {
        let mut phase = self.linear * x;
        if !self.third.is_zero() {
            let turns = self.complete.scaled(2.0) * Double::from(at.half_turns);
            phase = phase + self.third * (parameter.third(at, self.n1) + turns);
        }
        let turn = unit(phase);
        let jet = self.unturned(parameter, at);
        QuaternionJet { value: jet.value.times(turn), rate: jet.rate.times(turn) }
    }

    /// Returns Z without the factor exp(i phase). The derivative includes that of the phase.
    fn unturned(&self, parameter: &EllipticParameter, at: &Amplitude) -> QuaternionJet {
        let Amplitude { sn: s, cn: c, dn: d, .. } = *at;
        let (s2, c2, scd) = (s.square(), c.square(), s * c * d);
        match self.form {
            Form::Modulus { y1, y2 } => {
                // dZ/dx = ((y₂ − y₁) sn cn dn + ih)/√(2y)
                let y = y1 * c2 + y2 * s2;
                let root = y.scaled(0.5).sqrt();
                let by = Double::ONE / root.scaled(2.0);
                let rate = Complex { re: (y2 - y1) * scd, im: self.h }.scaled(by);
                QuaternionJet { value: Complex { re: root, im: Double::default() }, rate }
            }
            Form::Product { a, g } => {
                let by_q2 = Double::ONE / (c2 + self.n1 * s2);
                let by_q = by_q2.sqrt().scaled(at.sign());
                let z = Complex { re: a * c * d, im: g * s }.scaled(by_q);
                // d(cn dn)/dx = −sn (dn² + m cn²),  dq/dx = −N sn cn dn/q,  dρ/dx = third · sn²/q²
                let m = parameter.m_in_words();
                let along = Complex { re: -(a * s * (d.square() + m * c2)), im: g * c * d }.scaled(by_q);
                let stretch = z.scaled((Double::ONE - self.n1) * scd * by_q2);
                let turning = z.times_i().scaled(self.third * s2 * by_q2);
                QuaternionJet { value: z, rate: along.plus(stretch).plus(turning) }
            }
        }
    }

    /// Returns Z and −i dZ/dx at x = 0, both real.
    pub(super) fn at_lowest(&self) -> [Double; 2] {
        match self.form {
            Form::Modulus { y1, .. } => {
                let root = y1.scaled(0.5).sqrt();
                [root, self.h / root.scaled(2.0)]
            }
            Form::Product { a, g } => [a, g],
        }
    }

    /// Returns true if the phase, apart from its linear part, decreases with x.
    pub(super) fn winds_backwards(&self) -> bool {
        self.h.high < 0.0
    }

    /// Returns the gain of the phase over one nutation, x → x + 2K. A passage through the vertical
    /// counts as half a turn forwards (h = 0).
    pub(super) fn whole_gain(&self, parameter: &EllipticParameter) -> Double {
        let through = matches!(self.form, Form::Product { .. }) && self.h.is_zero();
        let gain = self.gain(parameter);
        if through { gain + Double::TAU.scaled(0.5) } else { gain }
    }

    /// Returns the gain of the phase over one nutation, x → x + 2K. A passage through the vertical
    /// counts as zero: it can be half a turn in either direction.
    pub(super) fn gain(&self, parameter: &EllipticParameter) -> Double {
        let half_turn = match self.form {
            Form::Product { .. } if self.h.high > 0.0 => Double::TAU.scaled(0.5),
            Form::Product { .. } if self.h.high < 0.0 => -Double::TAU.scaled(0.5),
            _ => Double::default(),
        };
        let quarters = self.linear * parameter.quarter() + self.third * self.complete;
        half_turn + quarters.scaled(2.0)
    }
}
