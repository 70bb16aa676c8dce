//! Libration of a gravity-gradient stabilised body on a circular orbit.

use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Small oscillations of a body whose principal axes stay close to the orbital axes.
///
/// The roll axis is along the velocity, the pitch axis along the orbit normal, and the yaw axis
/// along the radius. The body rotates once per orbit.
///
/// Let A, B, C be the moments about roll, pitch and yaw. Then k1 = (B − C)/A, k2 = (A − C)/B,
/// k3 = (B − A)/C. With the orbital rate n, the characteristic equations are:
///
/// pitch, in the orbital plane: s² + 3 k2 n² = 0
///
/// roll and yaw, coupled by gyroscopic torque: s⁴ + (1 + 3 k1 + k1 k3) n² s² + 4 k1 k3 n⁴ = 0
///
/// ```
/// // A pencil that points at the Earth: √3 swings in an orbit in its plane, 2 across.
/// let n = 1.1e-3;
/// let pencil = polhode::observe::Libration::of([1000.0, 1000.0, 1e-6], n)?;
/// assert!((pencil.pitch.unwrap() / n - 3f64.sqrt()).abs() < 1e-8);
/// assert!((pencil.roll_yaw.unwrap()[1] / n - 2.0).abs() < 1e-8);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
///
/// # Source
/// Hughes, Spacecraft Attitude Dynamics (1986), ch. 9; DeBra & Delp, J. Astronaut. Sci. 8 (1961)
/// 14.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Libration {
    /// Frequency of pitch, in the orbital plane, rad/s; `None` if pitch is unstable.
    pub pitch: Option<f64>,
    /// Frequencies of the coupled roll and yaw modes, ascending, rad/s; `None` if one of them is
    /// unstable. A zero frequency is a rotation about an axis of symmetry.
    pub roll_yaw: Option<[f64; 2]>,
}

impl Libration {
    /// Computes the libration of a body with these moments about roll, pitch and yaw, kg·m², on an
    /// orbit with the rate `orbit_rate`, rad/s.
    ///
    /// # Errors
    /// A parameter error ([`MotionError::is_parameter`]) unless all are positive and finite.
    pub fn of(moments: [f64; 3], orbit_rate: f64) -> Result<Self, MotionError> {
        let [a, b, c] = moments;
        for (what, value) in [
            ("the moment about the roll axis", a),
            ("the moment about the pitch axis", b),
            ("the moment about the yaw axis", c),
            ("the orbit's rate", orbit_rate),
        ] {
            require::positive(what, value)?;
        }
        let (k1, k2, k3) = ((b - c) / a, (a - c) / b, (b - a) / c);
        // With s² = −n² x: x² − p x + q = 0, stable if both x are real and neither is negative.
        let (p, q) = (1.0 + 3.0 * k1 + k1 * k3, 4.0 * k1 * k3);
        let discriminant = p * p - 4.0 * q;
        let roll_yaw = (p > 0.0 && q >= 0.0 && discriminant >= 0.0).then(|| {
            let larger = 0.5 * (p + discriminant.sqrt());
            [q / larger, larger].map(|x| orbit_rate * x.sqrt())
        });
        Ok(Self { pitch: (k2 >= 0.0).then(|| orbit_rate * (3.0 * k2).sqrt()), roll_yaw })
    }

    /// Returns true if all librations are stable.
    pub const fn is_stable(&self) -> bool {
        self.pitch.is_some() && self.roll_yaw.is_some()
    }
}
