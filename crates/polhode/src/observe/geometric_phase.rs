//! Geometric phase: rotation of a free body in one period of ω.

use crate::math::double::Double;
use crate::math::means::quarter_and_share;
use crate::math::number::PI;
use crate::motion::solve::free::{FreeMotion, Regime};

/// Rotation about L in one period of ω, and its two parts: total = dynamic + geometric.
///
/// After one period P ([`FreeMotion::period`]), ω and L have the same body components as before.
/// The attitude has therefore rotated about L, by the right-hand rule:
///
/// attitude(t + P) = (rotation by `total` about L) · attitude(t), total = 2 T P / |L| − σ S
///
/// S is the solid angle, 0 … 2π sr, enclosed by the path of L in the body around the axis that it
/// circles, seen from the centre of the sphere |L| = constant. σ is the orientation: L circles its
/// axis by the right-hand rule (σ = +1) in short-axis mode and against it (σ = −1) in long-axis
/// mode.
///
/// Attitudes determine the total only modulo 2π. The value here is continuous within a mode and
/// tends to |ω| P as the motion tends to a permanent rotation. It is the advance of the azimuth
/// about L of every body axis that L does not circle, such as the intermediate one. The axis that L
/// circles advances by Ω P = total + 2πσ, with Ω of [`FreeMotion::precession_rate`].
///
/// # Accuracy
/// The relative error of each value is a few ε, also for the geometric part of the smallest wobble:
/// S = 2K(m) A1 A2 / (|L| A3) · R with positive terms only, L = (A1 cn, A2 sn, A3 dn), and R by
/// arithmetic–geometric means.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::observe::GeometricPhase;
/// // A coin-like body whose symmetry axis is at 0.3 rad from L: S is a cap.
/// let omega = AngularVelocity::new(0.3_f64.sin() / 1.0, 0.0, 0.3_f64.cos() / 2.0);
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega };
/// let motion = FreeMotion::of_moments([1.0, 1.0, 2.0], start)?;
/// let phase = GeometricPhase::of(&motion).ok_or("no period")?;
/// assert!((phase.geometric + std::f64::consts::TAU * (1.0 - 0.3_f64.cos())).abs() < 1e-14);
/// // one period later the body has turned about L by the total
/// let axis: Direction<Space> = motion.momentum().direction().ok_or("at rest")?;
/// let turned = Rotation::<Space, Space>::from_axis_angle(axis, phase.total)?;
/// let after = motion.at(motion.period().ok_or("no period")?).attitude;
/// assert!(after.angle_to(turned * start.attitude) < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Montgomery, Am. J. Phys. 59 (1991) 394; elementary derivation: Natário, arXiv:0909.2109 (J.
/// Geom. Mech. 2 (2010) 113).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeometricPhase {
    /// Rotation about L in one period of ω, rad: Ω P ∓ 2π, positive.
    pub total: f64,
    /// Dynamic phase 2 T P / |L|, rad: the component of ω along L, which is constant, times the
    /// period.
    pub dynamic: f64,
    /// Geometric phase −σ S, rad: negative in short-axis mode, positive in long-axis mode. It
    /// depends on the path only, not on the speed along it.
    pub geometric: f64,
}

impl GeometricPhase {
    /// Computes the phase of a motion; `None` if ω does not circle an axis
    /// ([`FreeMotion::period`]).
    pub fn of(motion: &FreeMotion) -> Option<Self> {
        let period = motion.period()?;
        let sigma = if motion.circles_least() { -1.0 } else { 1.0 };
        Some(Self {
            total: motion.precession_rate() * period - sigma * 2.0 * PI,
            dynamic: 2.0 * motion.kinetic_energy() / motion.momentum().norm() * period,
            geometric: -sigma * solid_angle(motion),
        })
    }
}

/// Returns the solid angle S that the path of L in the body encloses around the axis that it
/// circles, sr.
fn solid_angle(motion: &FreeMotion) -> f64 {
    if motion.regime() == Regime::Symmetric {
        // 2π (1 − cos θ), without cancellation.
        return 4.0 * PI * libm::sin(0.5 * motion.nutation_range()[0]).powi(2);
    }
    let ([i1, i2, i3], [w1, w2, w3]) = (motion.labelled_moments(), motion.amplitudes());
    // Amplitudes of L in units of A3.
    let (a1, a2) = (i1 * w1 / (i3 * w3), i2 * w2 / (i3 * w3));
    let l_squared = 1.0 + a1 * a1;
    let k1 = Double::from(motion.complementary_modulus());
    let (quarter, share) = quarter_and_share(k1, Double::from(l_squared));
    2.0 * (quarter * share).value() * a1 * a2 / l_squared.sqrt()
}
