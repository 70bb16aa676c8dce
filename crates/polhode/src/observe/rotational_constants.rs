//! The rotational constants of a molecule: its moments of inertia as spectroscopists write them.

use core::f64::consts::PI;

use crate::body::error::BodyError;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Frame;

/// Planck's constant, J·s: exact since 2019.
const PLANCK: f64 = 6.626_070_15e-34;

/// The speed of light, m/s: exact.
const LIGHT: f64 = 299_792_458.0;

/// The atomic mass constant, kg (CODATA 2018).
const ATOMIC_MASS: f64 = 1.660_539_066_60e-27;

/// The rotational constants A ≥ B ≥ C of a rigid molecule, and which kind of top it is.
///
/// A = h/(8π² i1),  B = h/(8π² i2),  C = h/(8π² i3)  as frequencies, and divided by c as wavenumbers.
///
/// A linear molecule has no A: i1 = 0. They are those of the geometry that is given, without vibration or centrifugal
/// distortion: of an equilibrium geometry they are A_e, B_e and C_e.
///
/// # Accuracy
/// A few ε of the moments. h and c are exact; u, in which masses are given, has an uncertainty of 3e-10 (CODATA 2018).
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

/// The kinds of rotors, by which moments are equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Top {
    /// i1 = 0, i2 = i3: all atoms on one line.
    Linear,
    /// i1 = i2 = i3: methane, SF6.
    Spherical,
    /// i1 < i2 = i3, B = C: elongated, as CH3F.
    Prolate,
    /// i1 = i2 < i3, A = B: flattened, as benzene.
    Oblate,
    /// i1 < i2 < i3: most molecules.
    Asymmetric,
}

impl Top {
    /// The name in lower case, as JSON has it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Spherical => "spherical",
            Self::Prolate => "prolate",
            Self::Oblate => "oblate",
            Self::Asymmetric => "asymmetric",
        }
    }

    /// The kind to which these moments belong, i1 ≤ i2 ≤ i3, i3 > 0.
    fn of([i1, i2, i3]: [f64; 3], tolerance: f64) -> Self {
        // Moments grow with the square of a length: an atom off the line by τ makes an i1 of τ².
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
    /// How far moments may differ, in parts of the larger, and still count as equal: 1e-4. It is above the rounding of
    /// geometries with five or more decimals in ångström, and below the least differences of real tops (B and C of
    /// HSSH differ by 3e-4).
    pub const TOLERANCE: f64 = 1e-4;

    /// The constants of a body, its top classified with [`Self::TOLERANCE`]; `None` of a single point, which has no
    /// rotation.
    pub fn of<F: Frame>(body: &MassProperties<F>) -> Option<Self> {
        Self::classified(body, Self::TOLERANCE)
    }

    /// The same, where a length τ of the size of the body is not known: moments equal within τ count as equal, and a
    /// least moment of at most τ² of the greatest as zero.
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

    /// The principal moments i1 ≤ i2 ≤ i3, kg·m².
    pub const fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// Which kind of top it is.
    pub const fn top(&self) -> Top {
        self.top
    }

    /// The tolerance τ with which the top was classified.
    pub const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// A ≥ B ≥ C, Hz; A is `None` of a linear molecule.
    pub fn hertz(&self) -> [Option<f64>; 3] {
        // A = h/(8π² i1)
        let linear = self.top == Top::Linear;
        let constant = |k: usize| PLANCK / (8.0 * PI * PI) / self.moments[k];
        [Some(constant(0)).filter(|_| !linear), Some(constant(1)), Some(constant(2))]
    }

    /// A ≥ B ≥ C, GHz.
    pub fn gigahertz(&self) -> [Option<f64>; 3] {
        self.hertz().map(|a| a.map(|a| a / 1e9))
    }

    /// A ≥ B ≥ C as wavenumbers A/c, cm⁻¹.
    pub fn per_centimetre(&self) -> [Option<f64>; 3] {
        self.hertz().map(|a| a.map(|a| a / (100.0 * LIGHT)))
    }

    /// Ray's asymmetry parameter κ = (2B − A − C)/(A − C): −1 of a prolate top, +1 of an oblate one, and between them
    /// of an asymmetric one. `None` of a spherical top; −1 of a linear molecule, its limit for A → ∞.
    ///
    /// From the moments, κ = [i1 (i3 − i2) − i3 (i2 − i1)] / [i2 (i3 − i1)]: nearly equal constants are not subtracted.
    pub fn ray_kappa(&self) -> Option<f64> {
        let [i1, i2, i3] = self.moments;
        match self.top {
            Top::Spherical => None,
            Top::Linear => Some(-1.0),
            _ => {
                let (lower, upper) = (i2 - i1, i3 - i2);
                // Ratios, as a molecule's moments of 1e-45 kg·m² would leave little of a product of three.
                let (of_upper, of_lower) = (upper / (i3 - i1), lower / (i3 - i1));
                Some((i1 / i2) * of_upper - (i3 / i2) * of_lower)
            }
        }
    }

    /// The inertial defect Δ = i3 − i1 − i2, u·Å²: zero of a flat molecule, and negative of any other (that is rigid).
    ///
    /// It has the digits of the moments, not of itself.
    pub fn inertial_defect(&self) -> f64 {
        let [i1, i2, i3] = self.moments.map(in_unified_units);
        // i3 ≤ i1 + i2
        (i3 - i2) - i1
    }

    /// The principal moments i1 ≤ i2 ≤ i3, u·Å².
    pub fn moments_in_unified_units(&self) -> [f64; 3] {
        self.moments.map(in_unified_units)
    }
}

/// kg·m² → u·Å²
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
        // each pair is near enough, all three are not: the nearer pair decides
        assert_eq!(top([1.0, 1.0 + 9e-5, 1.0 + 15e-5]), Top::Prolate);
        assert_eq!(top([1.0, 1.0 + 6e-5, 1.0 + 15e-5]), Top::Oblate);
        assert_eq!(top([0.9e-8, 1.0, 1.0]), Top::Linear);
        assert_eq!(top([1.1e-8, 1.0, 1.0]), Top::Prolate);
        assert_eq!(top([0.0, 1.0, 1.0]), Top::Linear);
    }
}
