//! Families of polhodes of equal energy on the inertia ellipsoid.

use crate::body::principal::Symmetry;
use crate::math::frame::{Body, Principal};
use crate::math::rotation::Rotation;
use crate::math::vector::AngularVelocity;
use crate::motion::model::state::State;
use crate::motion::solve::free::{FreeMotion, Regime};

use super::curve::CurveError;
use super::polhode::{Polhode, drawn};
use super::sampling::{Span, separatrix_rate};

impl Polhode {
    /// Computes polhodes over the whole inertia ellipsoid of a motion, with the same energy and
    /// other angular momenta.
    ///
    /// There are `each` polhodes around each end of the axes of smallest and of largest moment, and
    /// the four halves of the separatrices. The former are evenly spaced in the elliptic angle from
    /// the axis. A body with two equal moments has them around its symmetry axis only. The family
    /// is empty at rest, for a sphere (its polhodes are points), and for a rod (its ellipsoid is
    /// unbounded). The time of each starts at 0 s.
    ///
    /// ```
    /// use polhode::math::{AngularVelocity, Attitude};
    /// use polhode::motion::{FreeMotion, State};
    /// use polhode::observe::Polhode;
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.5, 1.0, -0.7) };
    /// let motion = FreeMotion::of_moments([1.0, 2.0, 3.0], start)?;
    /// let family = Polhode::family(&motion, 3, 1e-3)?;
    /// assert_eq!(family.len(), 4 * 3 + 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`Polhode::of`].
    pub fn family(motion: &FreeMotion, each: usize, tolerance: f64) -> Result<Vec<Self>, CurveError> {
        Span::of(motion, 1.0, 0.0, tolerance)?;
        let principal = motion.principal();
        let shaped =
            matches!(principal.symmetry(), Symmetry::Asymmetric | Symmetry::Oblate | Symmetry::Prolate);
        if !shaped || motion.regime() == Regime::AtRest {
            return Ok(Vec::new());
        }
        let ellipsoid = InertiaEllipsoid::of(motion);
        let mut family = Vec::new();
        for angle in ellipsoid.angles(each) {
            for sign in [1.0, -1.0] {
                family.push(ellipsoid.sister(angle, sign, tolerance)?);
            }
        }
        if principal.symmetry() == Symmetry::Asymmetric {
            for signs in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
                family.push(ellipsoid.separatrix(signs, tolerance)?);
            }
        }
        let into_body = principal.rotation();
        Ok(family.into_iter().map(|sister| turned(sister, into_body)).collect())
    }
}

fn turned(sister: Polhode, into_body: Rotation<Body, Principal>) -> Polhode {
    let curve = sister.curve.mapped(|omega| into_body * omega.as_frame());
    Polhode { curve, ..sister }
}

/// Inertia ellipsoid in its principal axes, which are the body axes of the other motions.
struct InertiaEllipsoid {
    moments: [f64; 3],
    /// Semi-axes √(2T/i), rad/s.
    semi_axes: [f64; 3],
}

impl InertiaEllipsoid {
    fn of(motion: &FreeMotion) -> Self {
        let moments = motion.principal().moments();
        // Evaluated where cn = 1: 2T = i1 a1² + i3 a3² in the motion's labels.
        let ([j1, _, j3], [a1, _, a3]) = (motion.labelled_moments(), motion.amplitudes());
        let semi_axes = moments.map(|i| libm::hypot(a1 * (j1 / i).sqrt(), a3 * (j3 / i).sqrt()));
        Self { moments, semi_axes }
    }

    /// Returns the angle from the axis of largest moment to the separatrix in the plane of the axes
    /// of smallest and largest moment, rad.
    fn separatrix_angle(&self) -> f64 {
        let [i1, i2, i3] = self.moments;
        libm::atan2((i3 - i2).sqrt(), (i2 - i1).sqrt())
    }

    /// Returns evenly spaced angles on both sides of the separatrix, rad.
    fn angles(&self, each: usize) -> Vec<f64> {
        let [i1, i2, i3] = self.moments;
        let (separatrix, right) = (self.separatrix_angle(), core::f64::consts::FRAC_PI_2);
        let part = |k: usize| k as f64 / (each as f64 + 1.0);
        let greatest = (1..=each).filter(|_| i2 < i3).map(|k| separatrix * part(k));
        let least = (1..=each).filter(|_| i1 < i2).map(|k| right - (right - separatrix) * part(k));
        greatest.chain(least).collect()
    }

    /// Returns ω in the plane of the axes of smallest and largest moment, rad/s.
    fn across(&self, angle: f64) -> [f64; 2] {
        let [s1, _, s3] = self.semi_axes;
        [s1 * libm::sin(angle), s3 * libm::cos(angle)]
    }

    fn sister(&self, angle: f64, sign: f64, tolerance: f64) -> Result<Polhode, CurveError> {
        let [w1, w3] = self.across(angle);
        let omega = AngularVelocity::new(sign * w1, 0.0, sign * w3);
        let start = State { time: 0.0, attitude: Rotation::identity(), omega };
        Polhode::of(&FreeMotion::of_moments(self.moments, start)?, tolerance)
    }

    /// Computes half a separatrix, ω = (a1 sech, a2 tanh, a3 sech)(λt), where a2 has the sign of
    /// (i3 − i1) a3 a1.
    fn separatrix(&self, [sign1, sign3]: [f64; 2], tolerance: f64) -> Result<Polhode, CurveError> {
        let [w1, w3] = self.across(self.separatrix_angle());
        let a = [sign1 * w1, sign1 * sign3 * self.semi_axes[1], sign3 * w3];
        let rate = separatrix_rate(self.moments, w3);
        let at = |time: f64| {
            let sech = 1.0 / libm::cosh(rate * time);
            let omega = AngularVelocity::new(a[0] * sech, a[1] * libm::tanh(rate * time), a[2] * sech);
            State { time, attitude: Rotation::identity(), omega }
        };
        let span = Span::separatrix(0.0, rate, 0.0, tolerance);
        let curve = drawn(&span, at, libm::hypot(w1, w3), tolerance)?;
        Ok(Polhode { curve, regime: Regime::Separatrix })
    }
}
