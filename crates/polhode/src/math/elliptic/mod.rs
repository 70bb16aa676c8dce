//! Legendre's elliptic integrals and Jacobi's elliptic functions, by the parameter m = k² *and* its complement m₁ = 1 − m.
//!
//! Near m = 1 everything depends on m₁, and near m = 0 everything on m; whichever of the two is given is exact here, and
//! the other is its complement in two words, which is exact too. So a table by m and a table by m₁ are both met to the
//! last digit, and K, by whose multiples large arguments are reduced, is the K of the number that was given.
//!
//! The file `reduced` takes any amplitude or argument to a quarter turn. On a quarter,
//!
//! - `incomplete` and `complete` have F, E and Π as one formula in Carlson's symmetric integrals (`carlson`), which
//!   converge for every parameter without a choice of cases;
//! - `jacobi` has sn, cn and dn by Landen's transformation, in a form where nothing is ever subtracted.
//!
//! `amplitude` gives closed forms the same with both words, and what they need of the third kind.
//!
//! All of it is done in numbers of two words and rounded once at the end, which takes some µs for each value. (The closed
//! form of a free motion, made for many times, has a faster way of its own.)

mod amplitude;
mod carlson;
mod complete;
mod incomplete;
mod jacobi;
mod reduced;

use core::fmt;

use super::double::Double;
use super::triple::Triple;

pub(crate) use amplitude::Amplitude;
pub(crate) use complete::complete_k;
pub use jacobi::JacobiFunctions;
pub(crate) use reduced::unit;

/// The parameter m = k² of elliptic integrals and functions, with its complement m₁ = 1 − m; m ≤ 1, negative m allowed.
///
/// Every result is rounded once, relative to itself and for exactly the numbers given: 0.5 ulp in all that was tried,
/// near the zeros of sn and cn and after 10⁵ periods too. Only at m = 1 itself sn, cn, dn have 2 ulp and am has 3.
///
/// ```
/// use polhode::math::elliptic::EllipticParameter;
/// // The pendulum released at 90°: m = sin²(90°/2), period 4 K / 2π of the small one.
/// let m = EllipticParameter::new(0.5)?;
/// assert_eq!(m.k() / std::f64::consts::FRAC_PI_2, 1.1803405990160963);
/// // So near 1 that m itself has no digits for it.
/// let m = EllipticParameter::from_complement(1e-300)?;
/// assert_eq!(m.m(), 1.0);
/// assert!((m.k() - (4.0 / m.complement().sqrt()).ln()).abs() < 1e-13);
/// # Ok::<(), polhode::math::elliptic::EllipticError>(())
/// ```
///
/// Source: DLMF, chapters 19 and 22, with k² = m and α² = n.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EllipticParameter {
    m: Double,
    m1: Double,
    /// 1 / K
    inverse_k: Triple,
}

/// Why there is no such integral.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum EllipticError {
    /// The parameter m is above 1 or not finite.
    Parameter {
        /// The offending m.
        m: f64,
    },
    /// The complementary parameter m₁ is negative or not finite.
    Complement {
        /// The offending m₁.
        m1: f64,
    },
    /// The characteristic n of Π is 1 or more, or not finite.
    Characteristic {
        /// The offending n.
        n: f64,
    },
}

impl fmt::Display for EllipticError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter { m } => write!(f, "the elliptic parameter m = {m} must be finite and at most 1"),
            Self::Complement { m1 } => {
                write!(f, "the complementary elliptic parameter m1 = {m1} must be finite and not negative")
            }
            Self::Characteristic { n } => {
                write!(
                    f,
                    "the characteristic n = {n} of an integral of the third kind must be finite and below 1"
                )
            }
        }
    }
}

impl core::error::Error for EllipticError {}

impl EllipticParameter {
    /// By m ≤ 1.
    ///
    /// # Errors
    /// [`EllipticError::Parameter`] for m > 1 or an m that is not finite.
    pub fn new(m: f64) -> Result<Self, EllipticError> {
        if m.is_finite() && m <= 1.0 {
            Ok(Self::of(Double::from(m), Double::sum(1.0, -m)))
        } else {
            Err(EllipticError::Parameter { m })
        }
    }

    /// By m₁ = 1 − m ≥ 0.
    ///
    /// # Errors
    /// [`EllipticError::Complement`] for m₁ < 0 or an m₁ that is not finite.
    pub fn from_complement(m1: f64) -> Result<Self, EllipticError> {
        if m1.is_finite() && m1 >= 0.0 {
            Ok(Self::of(Double::sum(1.0, -m1), Double::from(m1)))
        } else {
            Err(EllipticError::Complement { m1 })
        }
    }

    /// By both, each with its own digits, m₁ ≥ 0.
    pub(crate) fn of(m: Double, m1: Double) -> Self {
        // 1/K = 2 agm(1, k′) / π, and 1/4π is at hand.
        let inverse_k = (Triple::INVERSE_4_PI * mean(m1)).scaled(8.0);
        Self { m, m1, inverse_k }
    }

    /// m = k², correctly rounded.
    pub const fn m(&self) -> f64 {
        self.m.high
    }

    /// m₁ = 1 − m = k′², correctly rounded.
    pub const fn complement(&self) -> f64 {
        self.m1.high
    }

    /// m = 1: K is infinite and the functions are hyperbolic.
    fn is_hyperbolic(&self) -> bool {
        self.m1.is_zero()
    }
}

/// agm(1, √m₁) in three words.
fn mean(m1: Double) -> Triple {
    if m1.is_zero() {
        return Triple::default();
    }
    let scale = root_scale(m1);
    let (mut a, mut g) =
        (Triple::from(1.0), Triple::from(m1.scaled(scale).scaled(scale)).sqrt().scaled(1.0 / scale));
    // Quadratic convergence: once |a − g| < 2⁻⁷⁸ a, one more mean is exact to rounding.
    while (a - g).value().abs() > 3e-24 * a.value() {
        (a, g) = ((a + g).scaled(0.5), (a * g).sqrt());
    }
    (a + g).scaled(0.5)
}

/// √x with both words, for every x ≥ 0 there is.
fn root(x: Double) -> Double {
    let scale = root_scale(x);
    x.scaled(scale).scaled(scale).sqrt().scaled(1.0 / scale)
}

/// A power of two whose square brings x to where products keep their low words.
fn root_scale(x: Double) -> f64 {
    if x.high < TINY {
        HUGE
    } else if x.high > HUGE {
        TINY
    } else {
        1.0
    }
}

/// 2³⁰⁰ and 2⁻³⁰⁰
const HUGE: f64 = 2.037_035_976_334_486e90;
const TINY: f64 = 1.0 / HUGE;
