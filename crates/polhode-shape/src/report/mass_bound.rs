//! Error bounds of mass properties.

use polhode::body::mesh::MassBound;
use polhode_document::Extra;
use polhode_document::json::{matrix, numbers};
use polhode_document::layout::{labelled, matrix_rows};
use polhode_document::number::error;
use polhode_document::unit;
use serde_json::json;

/// Returns the block `bounds`: error bounds of the volume (m³), mass (kg), coordinates of the
/// centre of mass (m), tensor and principal moments (kg m²). `share` is the bound of the volume
/// relative to it; `proviso` is the condition under which the bounds hold.
pub fn mass_bound(bound: &MassBound, volume: f64, share: f64, proviso: &str) -> Extra {
    let MassBound { mass, center_of_mass, inertia, moments } = *bound;
    let json = json!({
        "volume": volume,
        "volume_share": share,
        "mass": mass,
        "center_of_mass": numbers(&center_of_mass),
        "inertia": matrix(inertia),
        "principal_moments": moments,
    });
    let rows = matrix_rows(&inertia.map(|row| row.map(above)), 2);
    let rows: String = rows.iter().map(|row| format!("    {}\n", row.trim_end())).collect();
    let center = unit::lengths(center_of_mass.map(above)).replace(' ', "\u{a0}");
    let text = labelled("error bounds", proviso)
        + &labelled(
            "volume",
            &format!("± {} ({}\u{a0}%)", unit::volume(above(volume)), error(above(100.0 * share))),
        )
        + &labelled("mass", &format!("± {}", unit::mass(above(mass))))
        + &labelled("centre of mass", &format!("±\u{a0}{center}"))
        + &labelled("principal", &format!("± {} kg·m²", error(above(moments))))
        + "tensor           ± each element, kg·m²\n"
        + &rows;
    Extra { key: "bounds", json, text }
}

/// Rounds a bound up to two significant digits.
fn above(bound: f64) -> f64 {
    if !(bound > 0.0 && bound.is_finite()) {
        return bound;
    }
    let exponent = bound.log10().floor() as i32 - 1;
    let digits = (bound / 10_f64.powi(exponent)).ceil();
    // Parsing a decimal rounds once.
    format!("{digits}e{exponent}").parse().unwrap_or(bound)
}

#[cfg(test)]
mod tests {
    use super::above;

    #[test]
    fn bounds_are_rounded_up_to_two_digits() {
        for (bound, rounded) in
            [(0.0, 0.0), (1.21e-7, 1.3e-7), (9.91, 10.0), (3.456e5, 3.5e5), (1e-3, 1e-3), (0.998, 1.0)]
        {
            assert!((above(bound) - rounded).abs() <= 1e-15 * rounded, "{bound}: {}", above(bound));
            assert!(above(bound) >= bound, "{bound}");
        }
    }
}
