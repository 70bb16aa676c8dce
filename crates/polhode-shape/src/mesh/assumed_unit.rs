//! A mesh whose unit nobody gave is in metres, and most are drawn in millimetres: is what comes of that a body?
//!
//! STL, OBJ, PLY and OFF have no unit. The size of a body is the longest side of the box of its moments: of a box its own side, of
//! other bodies something near. A mesh in metres that was drawn in mm is a thousand times too long, and 10⁹ times too heavy.

use polhode::body::shape::Extent;
use polhode::body::{Finding, MassProperties, Severity};
use polhode::math::Frame;

use super::MeshFormat;

/// A longer body is asked for its unit, m.
const LONGEST: f64 = 5.0;

/// A body that is heavier by its density is asked, kg.
const HEAVIEST: f64 = 1e4;

/// A body that is lighter for its size by its mass is asked, kg/m³: half of what is assumed where nothing is said.
const THINNEST: f64 = 0.5;

/// A body so many times as long as the others that it is with is asked.
const MUCH_LONGER: f64 = 100.0;

impl MeshFormat {
    /// True if its files, or the format where they do not, say in which unit they are.
    pub const fn has_unit(self) -> bool {
        matches!(self, Self::Gltf | Self::ThreeMf | Self::Collada)
    }
}

/// What is known of a mesh in metres that nobody gave.
#[derive(Clone, Copy, Debug)]
pub struct AssumedMetres<'a, F: Frame> {
    /// The body that it is.
    pub properties: &'a MassProperties<F>,
    /// How large it is, if that is known.
    pub extent: Option<Extent>,
    /// True if its mass was given, and does not follow from its size.
    pub mass_given: bool,
    /// The size of the largest of the other bodies that it is with, by [`longest_side`], m.
    pub others: Option<f64>,
    /// How to say the unit: `--unit mm`.
    pub remedy: &'a str,
}

impl<F: Frame> AssumedMetres<'_, F> {
    /// `mesh.unit`, if what comes of metres is absurd.
    ///
    /// ```
    /// use polhode::body::{InertiaTensor, MassProperties};
    /// use polhode::math::{Part, Position};
    /// use polhode_shape::mesh::AssumedMetres;
    /// let is_asked = |side: f64, mass: f64| {
    ///     let inertia = InertiaTensor::<Part>::diagonal([mass * side * side / 6.0; 3])?;
    ///     let properties = &MassProperties::new(mass, Position::ZERO, inertia)?;
    ///     let cube = AssumedMetres { properties, extent: None, mass_given: false, others: None, remedy: "--unit mm" };
    ///     Ok::<_, polhode::body::BodyError>(cube.finding(None).is_some())
    /// };
    /// assert!(!is_asked(0.12, 4.7)?);
    /// assert!(is_asked(120.0, 4.7e9)?);
    /// # Ok::<(), polhode::body::BodyError>(())
    /// ```
    pub fn finding(&self, place: Option<String>) -> Option<Finding> {
        let (side, mass) = (longest_side(self.properties), self.properties.mass());
        let volume = match self.extent {
            Some(Extent::Volume(volume)) => Some(volume),
            _ => None,
        };
        let density = volume.map(|volume| mass / volume).filter(|density| *density < THINNEST);
        let mut absurd = Vec::new();
        if side > LONGEST {
            absurd.push(format!("it is some {} m long", rounded(side)));
        }
        if mass > HEAVIEST && !self.mass_given {
            absurd.push(format!("its mass is {} t", rounded(1e-3 * mass)));
        }
        if let Some(density) = density.filter(|_| self.mass_given) {
            absurd.push(format!("its density is {} kg/m³", rounded(density)));
        }
        if let Some(others) = self.others.filter(|others| side > MUCH_LONGER * others) {
            absurd.push(format!("it is {} times as long as the other parts", rounded(side / others)));
        }
        (!absurd.is_empty()).then(|| Finding {
            code: "mesh.unit",
            severity: Severity::Warning,
            message: format!(
                "nobody says the unit of the mesh, so it is in metres, and then {}: is it in mm? ({})",
                absurd.join(", "),
                self.remedy
            ),
            place,
        })
    }
}

/// The longest side of the box with the same moments, m: b² = 6 (i₂ + i₃ − i₁)/M.
pub fn longest_side<F: Frame>(properties: &MassProperties<F>) -> f64 {
    let [i1, i2, i3] = properties.principal().moments();
    (6.0 * ((i2 - i1) + i3) / properties.mass()).sqrt()
}

/// With three digits.
fn rounded(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use polhode::body::InertiaTensor;
    use polhode::math::{Part, Position};

    /// A box of three sides, m, and a density, off the origin.
    fn block(sides: [f64; 3], density: f64) -> (MassProperties<Part>, Option<Extent>) {
        let volume: f64 = sides.iter().product();
        let mass = density * volume;
        let [x, y, z] = sides.map(|side| side * side);
        let inertia = InertiaTensor::diagonal([y + z, z + x, x + y].map(|sum| mass * sum / 12.0)).unwrap();
        let properties = MassProperties::new(mass, Position::new(0.3, -1.2, 0.7), inertia).unwrap();
        (properties, Some(Extent::Volume(volume)))
    }

    fn message(sides: [f64; 3], density: f64, mass_given: bool, others: Option<f64>) -> Option<String> {
        let (properties, extent) = block(sides, density);
        let assumed =
            AssumedMetres { properties: &properties, extent, mass_given, others, remedy: "--unit mm" };
        assumed.finding(None).map(|finding| finding.message)
    }

    #[test]
    fn the_longest_side_is_that_of_the_box() {
        let (properties, _) = block([0.31, 4.7, 1.9], 7850.0);
        assert!((longest_side(&properties) - 4.7).abs() < 1e-14);
    }

    #[test]
    fn what_no_workshop_makes_is_asked_for_its_unit() {
        assert_eq!(message([0.12, 0.08, 0.02], 7850.0, false, None), None);
        assert_eq!(message([1.9, 0.9, 0.7], 7850.0, false, Some(0.03)), None);
        for (sides, density, mass_given, others, says) in [
            ([120.0, 80.0, 9.6], 2700.0, false, None, "some 120 m long, its mass is 249000 t"),
            ([5.5, 0.2, 0.1], 1.0, false, None, "some 5.5 m long: is it in mm? (--unit mm)"),
            ([1.7, 1.5, 1.4], 7850.0, false, None, "then its mass is 28 t"),
            ([4.0, 3.0, 2.0], 0.085 / 24.0, true, None, "then its density is 0.00354 kg/m³"),
            ([2.0, 1.0, 0.5], 700.0, false, Some(0.013), "then it is 154 times as long as the other parts"),
        ] {
            let message = message(sides, density, mass_given, others).unwrap();
            assert!(message.contains(says), "{message}");
        }
        // A mass that is given is what somebody weighed.
        assert_eq!(message([1.7, 1.5, 1.4], 7850.0, true, None), None);
    }
}
