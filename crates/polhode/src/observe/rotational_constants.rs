//! Rotational constants of a molecule, computed from its moments of inertia.

use core::f64::consts::PI;

use crate::body::error::BodyError;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Frame;

/// Planck constant, J·s: exact since 2019.
const PLANCK: f64 = 6.626_070_15e-34;

/// Speed of light, m/s: exact.
const LIGHT: f64 = 299_792_458.0;

/// Atomic mass constant, kg (CODATA 2018).
const ATOMIC_MASS: f64 = 1.660_539_066_60e-27;

/// Rotational constants A ≥ B ≥ C of a rigid molecule, and the kind of top.
///
/// A = h/(8π² i1),  B = h/(8π² i2),  C = h/(8π² i3)  as frequencies, divided by c as wavenumbers.
///
/// A linear molecule has no A, because i1 = 0. The constants are those of the given geometry,
/// without vibration or centrifugal distortion; for an equilibrium geometry they are A_e, B_e and
/// C_e.
///
/// # Accuracy
/// The relative error is a few ε of the moments. h and c are exact; u, in which masses are given,
/// has a relative uncertainty of 3e-10 (CODATA 2018).
///
/// ```
/// use polhode::body::{Particle, mass_properties_of_particles};
/// use polhode::math::{Body, Position};
/// use polhode::observe::{RotationalConstants, Top};
/// // HCN along its axis: masses in u, places in ångström
/// let atoms = [(12.0, -0.506397), (14.00307400425, 0.66016), (1.007825031898, -1.582739)];
/// let mut particles = Vec::new();
/// for (mass, z) in atoms {
///     particles.push(Particle::<Body>::new(mass * 1.66053906660e-27, Position::new(0.0, 0.0, z * 1e-10))?);
/// }
/// let molecule = RotationalConstants::of(&mass_properties_of_particles(&particles)?).ok_or("an atom")?;
/// assert_eq!(molecule.top(), Top::Linear);
/// let [a, b, c] = molecule.gigahertz();
/// assert_eq!(a, None);
/// assert!(b == c && (b.unwrap() / 43.518_053 - 1.0).abs() < 5e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Bernath, Spectra of Atoms and Molecules, chapter 6; κ from Ray, Z. Physik 78 (1932) 74.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotationalConstants {
    moments: [f64; 3],
    top: Top,
    tolerance: f64,
}

/// Kinds of rotors, by their equal moments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Top {
    /// All atoms on one line: i1 = 0, i2 = i3.
    Linear,
    /// Three equal moments, for example methane, SF6.
    Spherical,
    /// Elongated, for example CH3F: i1 < i2 = i3, B = C.
    Prolate,
    /// Flattened, for example benzene: i1 = i2 < i3, A = B.
    Oblate,
    /// Three different moments, as for most molecules.
    Asymmetric,
}

impl Top {
    /// Returns the name in lower case, as in JSON.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Spherical => "spherical",
            Self::Prolate => "prolate",
            Self::Oblate => "oblate",
            Self::Asymmetric => "asymmetric",
        }
    }

    /// Returns the kind of top for moments i1 ≤ i2 ≤ i3 with i3 > 0.
    fn of([i1, i2, i3]: [f64; 3], tolerance: f64) -> Self {
        // Moments are quadratic in lengths: an atom at a distance τ from the line gives i1 of order
        // τ².
        if i1 <= tolerance * tolerance * i3 {
            return Self::Linear;
        }
        let (lower, upper) = ((i2 - i1) / i2, (i3 - i2) / i3);
        let whole = (i3 - i1) / i3;
        if whole <= tolerance {
            Self::Spherical
        } else if upper <= tolerance && upper <= lower {
            Self::Prolate
        } else if lower <= tolerance {
            Self::Oblate
        } else {
            Self::Asymmetric
        }
    }
}

impl RotationalConstants {
    /// Largest relative difference of moments that count as equal: 1e-4. It is above the rounding
    /// of geometries with five or more decimals in ångström, and below the smallest differences of
    /// real tops (B and C of HSSH differ by 3e-4).
    pub const TOLERANCE: f64 = 1e-4;

    /// Computes the constants of a body and classifies its top with [`Self::TOLERANCE`]; `None` for
    /// a single point, which has no rotation.
    pub fn of<F: Frame>(body: &MassProperties<F>) -> Option<Self> {
        Self::classified(body, Self::TOLERANCE)
    }

    /// Computes the constants with a given tolerance τ. Moments that differ by at most τ (relative)
    /// count as equal, and a smallest moment of at most τ² times the largest counts as zero.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] unless τ is from 0 to 1.
    pub fn with_tolerance<F: Frame>(
        body: &MassProperties<F>,
        tolerance: f64,
    ) -> Result<Option<Self>, BodyError> {
        if !(0.0..=1.0).contains(&tolerance) {
            let (what, rule) = ("the tolerance of equal moments", "from 0 to 1");
            return Err(BodyError::Parameter { what, value: tolerance, rule });
        }
        Ok(Self::classified(body, tolerance))
    }

    fn classified<F: Frame>(body: &MassProperties<F>, tolerance: f64) -> Option<Self> {
        let moments = body.principal().moments();
        (moments[2] > 0.0).then(|| Self { moments, top: Top::of(moments, tolerance), tolerance })
    }

    /// Returns the principal moments i1 ≤ i2 ≤ i3, kg·m².
    pub const fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// Returns the kind of top.
    pub const fn top(&self) -> Top {
        self.top
    }

    /// Returns the tolerance τ used in the classification.
    pub const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Returns A ≥ B ≥ C, Hz; A is `None` for a linear molecule.
    pub fn hertz(&self) -> [Option<f64>; 3] {
        // A = h/(8π² i1).
        let linear = self.top == Top::Linear;
        let constant = |k: usize| PLANCK / (8.0 * PI * PI) / self.moments[k];
        [Some(constant(0)).filter(|_| !linear), Some(constant(1)), Some(constant(2))]
    }

    /// Returns A ≥ B ≥ C, GHz; A is `None` for a linear molecule.
    pub fn gigahertz(&self) -> [Option<f64>; 3] {
        self.hertz().map(|a| a.map(|a| a / 1e9))
    }

    /// Returns A ≥ B ≥ C as wavenumbers A/c, cm⁻¹; A is `None` for a linear molecule.
    pub fn per_centimetre(&self) -> [Option<f64>; 3] {
        self.hertz().map(|a| a.map(|a| a / (100.0 * LIGHT)))
    }

    /// Returns Ray's asymmetry parameter κ = (2B − A − C)/(A − C): −1 for a prolate top, +1 for an
    /// oblate one, in between for an asymmetric one. `None` for a spherical top; −1 for a linear
    /// molecule, its limit for A → ∞.
    ///
    /// It is computed from the moments, κ = [i1 (i3 − i2) − i3 (i2 − i1)] / [i2 (i3 − i1)], without
    /// subtracting nearly equal constants.
    pub fn ray_kappa(&self) -> Option<f64> {
        let [i1, i2, i3] = self.moments;
        match self.top {
            Top::Spherical => None,
            Top::Linear => Some(-1.0),
            _ => {
                let (lower, upper) = (i2 - i1, i3 - i2);
                // Ratios, because a product of three moments of 1e-45 kg·m² would nearly underflow.
                let (of_upper, of_lower) = (upper / (i3 - i1), lower / (i3 - i1));
                Some((i1 / i2) * of_upper - (i3 / i2) * of_lower)
            }
        }
    }

    /// Returns the inertial defect Δ = i3 − i1 − i2, u·Å²: zero for a planar rigid molecule,
    /// negative for any other.
    ///
    /// Its absolute error is that of the moments; its relative error may be large.
    pub fn inertial_defect(&self) -> f64 {
        let [i1, i2, i3] = self.moments.map(in_unified_units);
        // i3 ≤ i1 + i2.
        (i3 - i2) - i1
    }

    /// Returns the principal moments i1 ≤ i2 ≤ i3, u·Å².
    pub fn moments_in_unified_units(&self) -> [f64; 3] {
        self.moments.map(in_unified_units)
    }
}

/// Converts kg·m² to u·Å².
fn in_unified_units(moment: f64) -> f64 {
    moment / ATOMIC_MASS * 1e20
}

#[cfg(test)]
mod tests {
    use super::*;

    fn top(moments: [f64; 3]) -> Top {
        Top::of(moments, RotationalConstants::TOLERANCE)
    }

    #[test]
    fn tops_are_told_apart_on_both_sides_of_the_tolerance() {
        assert_eq!(top([1.3, 2.1, 2.9]), Top::Asymmetric);
        assert_eq!(top([1.3, 2.1, 2.1 * (1.0 + 0.9e-4)]), Top::Prolate);
        assert_eq!(top([1.3, 2.1, 2.1 * (1.0 + 1.1e-4)]), Top::Asymmetric);
        assert_eq!(top([1.3, 1.3 * (1.0 + 0.9e-4), 2.1]), Top::Oblate);
        assert_eq!(top([1.3, 1.3 * (1.0 + 1.1e-4), 2.1]), Top::Asymmetric);
        assert_eq!(top([1.3, 1.3 + 5e-5, 1.3 + 1e-4]), Top::Spherical);
        // Each pair is within the tolerance, but not all three: the nearer pair decides.
        assert_eq!(top([1.0, 1.0 + 9e-5, 1.0 + 15e-5]), Top::Prolate);
        assert_eq!(top([1.0, 1.0 + 6e-5, 1.0 + 15e-5]), Top::Oblate);
        assert_eq!(top([0.9e-8, 1.0, 1.0]), Top::Linear);
        assert_eq!(top([1.1e-8, 1.0, 1.0]), Top::Prolate);
        assert_eq!(top([0.0, 1.0, 1.0]), Top::Linear);
    }
}
