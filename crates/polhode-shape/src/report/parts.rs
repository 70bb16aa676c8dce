//! Parts of a body with their masses.

use polhode::body::MassProperties;
use polhode::math::Body;
use polhode_document::Extra;
use polhode_document::json::vector;
use polhode_document::layout::{columns, printable};
use polhode_document::number::tidy;
use polhode_document::unit;
use serde_json::{Value, json};

/// Part of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct PartRow {
    /// Name of the part; an empty name is shown as its number, from 1.
    pub name: String,
    /// Mass properties in body axes.
    pub properties: MassProperties<Body>,
    /// Enclosed volume, m³.
    pub volume: Option<f64>,
}

/// Returns the block `parts` for a body with several parts.
pub fn parts(rows: &[PartRow]) -> Extra {
    let one = |row: &PartRow| {
        json!({
            "name": row.name,
            "mass": row.properties.mass(),
            "volume": row.volume,
            "density": row.volume.map(|v| row.properties.mass() / v),
            "center_of_mass": vector(row.properties.center_of_mass()),
        })
    };
    Extra { key: "parts", json: rows.iter().map(one).collect::<Value>(), text: text(rows) }
}

fn text(rows: &[PartRow]) -> String {
    let cells: Vec<Vec<String>> = rows
        .iter()
        .enumerate()
        .map(|(k, row)| {
            let name = if row.name.is_empty() { format!("part {}", k + 1) } else { printable(&row.name) };
            let place =
                unit::place_in(unit::size(&row.properties), tidy(row.properties.center_of_mass().to_array()));
            vec![name, unit::mass(row.properties.mass()), format!("centre of mass {place}")]
        })
        .collect();
    let lines = columns(&cells).into_iter().map(|line| format!("    {line}\n")).collect::<String>();
    format!("parts\n{lines}")
}
