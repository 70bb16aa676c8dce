//! Legendre's elliptic integrals and Jacobi elliptic functions, given the parameter m = k² *or* its
//! complement m₁ = 1 − m.
//!
//! Near m = 1 everything depends on m₁, and near m = 0 everything on m. The given one of the two is
//! exact here; the other is its complement as a double-double number, which is exact too. Tables by
//! m and by m₁ are therefore both reproduced to full precision, and large arguments are reduced by
//! the K of the given number.
//!
//! The file `reduced` reduces any amplitude or argument to a quarter turn. On a quarter turn,
//!
//! - `incomplete` and `complete` compute F, E and Π by one formula in Carlson's symmetric integrals
//!   (`carlson`), which converge for every parameter without a distinction of cases;
//! - `jacobi` computes sn, cn and dn by Landen's transformation, in a form without subtractions.
//!
//! `amplitude` provides the same functions in double-double precision for closed forms, and the
//! integrals of the third kind that they need.
//!
//! All computations use double-double arithmetic and are rounded once at the end, which takes a few
//! µs for each value. (The closed form of a free motion at many times uses a faster method.)

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

/// Parameter m = k² of elliptic integrals and functions, with its complement m₁ = 1 − m; m ≤ 1,
/// negative m is allowed.
///
/// Every result is rounded once, with a relative error for exactly the given numbers of 0.5 ulp in
/// all tests, also near the zeros of sn and cn and after 10⁵ periods. Only at m = 1 the errors are
/// 2 ulp for sn, cn, dn and 3 ulp for am.
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
    /// Inverse of K, 1 / K.
    inverse_k: Triple,
}

/// Error: an argument is outside the range of an elliptic integral or function.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum EllipticError {
    /// The parameter m is above 1 or not finite.
    Parameter {
        /// Given value of m.
        m: f64,
    },
    /// The complementary parameter m₁ is negative or not finite.
    Complement {
        /// Given value of m₁.
        m1: f64,
    },
    /// The characteristic n of Π is 1 or more, or not finite.
    Characteristic {
        /// Given value of n.
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
    /// Returns the parameter m ≤ 1.
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

    /// Returns the parameter with the complement m₁ = 1 − m ≥ 0.
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

    /// Returns the parameter from both m and m₁ ≥ 0, each with full relative precision.
    pub(crate) fn of(m: Double, m1: Double) -> Self {
        // 1/K = 2 agm(1, k′) / π, using the constant 1/4π.
        let inverse_k = (Triple::INVERSE_4_PI * mean(m1)).scaled(8.0);
        Self { m, m1, inverse_k }
    }

    /// Returns m = k², correctly rounded.
    pub const fn m(&self) -> f64 {
        self.m.high
    }

    /// Returns m₁ = 1 − m = k′², correctly rounded.
    pub const fn complement(&self) -> f64 {
        self.m1.high
    }

    /// Returns true if m = 1: K is infinite and the functions are hyperbolic.
    fn is_hyperbolic(&self) -> bool {
        self.m1.is_zero()
    }
}

/// Returns agm(1, √m₁) in triple-double precision.
fn mean(m1: Double) -> Triple {
    if m1.is_zero() {
        return Triple::default();
    }
    let scale = root_scale(m1);
    let (mut a, mut g) =
        (Triple::from(1.0), Triple::from(m1.scaled(scale).scaled(scale)).sqrt().scaled(1.0 / scale));
    // Quadratic convergence: if |a − g| < 2⁻⁷⁸ a, one more mean is exact to rounding.
    while (a - g).value().abs() > 3e-24 * a.value() {
        (a, g) = ((a + g).scaled(0.5), (a * g).sqrt());
    }
    (a + g).scaled(0.5)
}

/// Returns √x in double-double precision, for every representable x ≥ 0.
fn root(x: Double) -> Double {
    let scale = root_scale(x);
    x.scaled(scale).scaled(scale).sqrt().scaled(1.0 / scale)
}

/// Returns a power of two whose square scales x to the range in which products keep their low
/// words.
fn root_scale(x: Double) -> f64 {
    if x.high < TINY {
        HUGE
    } else if x.high > HUGE {
        TINY
    } else {
        1.0
    }
}

/// Constants 2³⁰⁰ and 2⁻³⁰⁰.
const HUGE: f64 = 2.037_035_976_334_486e90;
const TINY: f64 = 1.0 / HUGE;
