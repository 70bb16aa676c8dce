//! Molecule block of a report: rotational constants.

use polhode::observe::{RotationalConstants, Top};
use polhode_document::layout::{labelled, printable};
use polhode_document::number::{DIGITS, alike, number, tidy_beside};
use serde_json::{Value, json};

/// Molecule block of a report: formula, isotopes and rotational constants.
///
/// ```
/// use polhode::body::{InertiaTensor, MassProperties};
/// use polhode::math::{Body, Position};
/// use polhode::observe::RotationalConstants;
/// use polhode_shape::report::MoleculeReport;
/// let inertia = InertiaTensor::<Body>::diagonal([1.0e-46, 1.8e-46, 2.8e-46])?;
/// let body = MassProperties::new(3e-26, Position::ZERO, inertia)?;
/// let report = MoleculeReport {
///     formula: "H2O".to_owned(),
///     atoms: 3,
///     isotopes: "abundant",
///     constants: RotationalConstants::of(&body),
/// };
/// assert_eq!(report.to_json()["top"], "asymmetric");
/// assert!(report.to_text().starts_with("formula          H2O, 3 atoms\n"));
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MoleculeReport {
    /// Chemical formula in Hill order.
    pub formula: String,
    /// Number of atoms.
    pub atoms: usize,
    /// Choice of masses for atoms without a given isotope: `abundant` or `average`.
    pub isotopes: &'static str,
    /// Rotational constants; `None` for a single atom.
    pub constants: Option<RotationalConstants>,
}

impl MoleculeReport {
    /// Returns the value of the key `molecule`. It contains A, B and C in GHz and in cm⁻¹, Ray's κ,
    /// and the type of top. Infinite constants are `null` (A of a linear molecule, all of an atom).
    /// κ is `null` for a spherical top and an atom, the type of top for an atom.
    pub fn to_json(&self) -> Value {
        let of =
            |get: fn(&RotationalConstants) -> [Option<f64>; 3]| self.constants.map_or([None; 3], |c| get(&c));
        json!({
            "formula": self.formula,
            "atoms": self.atoms,
            "isotopes": self.isotopes,
            "rotational_constants_ghz": of(RotationalConstants::gigahertz),
            "rotational_constants_cm1": of(RotationalConstants::per_centimetre),
            "ray_kappa": self.constants.and_then(|c| c.ray_kappa()),
            "top": self.constants.map(|c| c.top().name()),
            "top_tolerance": self.constants.map(|c| c.tolerance()),
            "moments_u_angstrom2": self.constants.map_or([None; 3], |c| c.moments_in_unified_units().map(Some)),
            "inertial_defect_u_angstrom2": self.constants.map(|c| c.inertial_defect()),
        })
    }

    /// Returns text lines that follow the inertia.
    pub fn to_text(&self) -> String {
        let atoms = if self.atoms == 1 { "1 atom".to_owned() } else { format!("{} atoms", self.atoms) };
        let masses = match self.isotopes {
            "abundant" => "abundant: most abundant isotope, where the file names none",
            "average" => "average: standard atomic weight, where the file names no isotope",
            other => other,
        };
        let mut text = labelled("formula", &format!("{}, {atoms}", printable(&self.formula)));
        text.push_str(&labelled("masses", masses));
        let Some(constants) = self.constants else {
            text.push_str(&labelled("rotation", "a single atom has no rotational constants"));
            return text;
        };
        for (label, values, unit) in
            [("rotation", constants.gigahertz(), "GHz"), ("", constants.per_centimetre(), "cm⁻¹")]
        {
            text.push_str(&labelled(label, &constants_text(values, unit)));
        }
        let (top, tolerance) = (constants.top(), number(constants.tolerance(), 2));
        let rule = match top {
            Top::Linear => {
                format!("linear: i1/i3 is less than {}", number(constants.tolerance().powi(2), 2))
            }
            Top::Spherical => format!("spherical: A, B and C are equal within {tolerance}"),
            Top::Prolate => format!("prolate: B and C are equal within {tolerance}"),
            Top::Oblate => format!("oblate: A and B are equal within {tolerance}"),
            Top::Asymmetric => format!("asymmetric: no two constants are equal within {tolerance}"),
        };
        text.push_str(&labelled("top", &rule));
        if let Some(kappa) = constants.ray_kappa() {
            text.push_str(&labelled("Ray's κ", &number(kappa, DIGITS)));
        }
        let [_, _, i3] = constants.moments_in_unified_units();
        let [defect, ..] = tidy_beside([constants.inertial_defect(), 0.0, 0.0], i3);
        let defect = number(defect, 6);
        text.push_str(&labelled("inertial defect", &format!("{defect} u·Å², i3 - i1 - i2")));
        text
    }
}

/// Returns `A = …, B = …, C = … GHz`; a linear molecule has only B.
fn constants_text(values: [Option<f64>; 3], unit: &str) -> String {
    let [a, b, c] = values.map(|value| value.unwrap_or(f64::INFINITY));
    if a.is_infinite() {
        return format!("B = {} {unit}", number(b, DIGITS));
    }
    let cells = alike(&[a, b, c], DIGITS);
    let named: Vec<String> =
        ["A", "B", "C"].iter().zip(cells).map(|(name, cell)| format!("{name} = {cell}")).collect();
    format!("{} {unit}", named.join(",  ").replace(' ', "\u{a0}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use polhode::body::{InertiaTensor, MassProperties};
    use polhode::math::{Body, Position};

    fn report(moments: [f64; 3]) -> MoleculeReport {
        let inertia = InertiaTensor::<Body>::diagonal(moments).unwrap();
        let body = MassProperties::new(4.5e-26, Position::ZERO, inertia).unwrap();
        let constants = RotationalConstants::of(&body);
        MoleculeReport { formula: "CHN".to_owned(), atoms: 3, isotopes: "average", constants }
    }

    #[test]
    fn keys_are_the_contract_and_what_is_infinite_is_null() {
        let json = report([0.0, 1.9e-46, 1.9e-46]).to_json();
        let keys: Vec<&str> = json.as_object().unwrap().keys().map(String::as_str).collect();
        assert_eq!(
            keys,
            [
                "formula",
                "atoms",
                "isotopes",
                "rotational_constants_ghz",
                "rotational_constants_cm1",
                "ray_kappa",
                "top",
                "top_tolerance",
                "moments_u_angstrom2",
                "inertial_defect_u_angstrom2"
            ]
        );
        assert!(json["rotational_constants_ghz"][0].is_null());
        assert!((json["rotational_constants_ghz"][1].as_f64().unwrap() - 44.168_504_6).abs() < 1e-7);
        assert!((json["rotational_constants_cm1"][2].as_f64().unwrap() - 1.473_302_73).abs() < 1e-8);
        assert_eq!((&json["ray_kappa"], &json["top"]), (&Value::from(-1.0), &Value::from("linear")));

        let json = report([0.0; 3]).to_json();
        assert!(json["top"].is_null() && json["ray_kappa"].is_null());
        assert!(json["rotational_constants_ghz"].as_array().unwrap().iter().all(Value::is_null));
        assert!(report([3.1e-46; 3]).to_json()["ray_kappa"].is_null());
    }

    #[test]
    fn the_text_says_masses_constants_and_tolerance() {
        let plain = |moments| polhode_document::layout::plain_spaces(&report(moments).to_text());
        let text = plain([1.5e-45, 8.3e-45, 9.3e-45]);
        for part in
            ["CHN, 3 atoms", "average: ", "A = ", "C = ", "GHz", "cm⁻¹", "asymmetric: no two", "Ray's κ"]
        {
            assert!(text.contains(part), "{part} in\n{text}");
        }
        assert!(plain([0.0, 1.9e-46, 1.9e-46]).contains("B = 44.1685 GHz"));
        assert!(plain([0.0; 3]).contains("a single atom"));
        assert!(
            text.lines().all(|line| polhode_document::layout::width(line) <= polhode_document::layout::WIDTH)
        );
    }
}
