//! Atoms as balls in conventional colours, bonds as sticks.

use polhode::body::BodyPart;
use polhode::math::{Body, Position};
use serde_json::{Value, json};

use super::packed::f32s;
use super::placed::at;

/// Drawn radius of an atom relative to its covalent radius, such that sticks remain visible.
const SHOWN: f64 = 0.45;

/// Largest distance between bonded atoms, relative to the sum of their covalent radii.
const BOUND: f64 = 1.25;

/// Largest number of atoms on a page; more would be illegible, and the search for bonds slow.
const MOST: usize = 2000;

/// Returns the balls and sticks of a molecule; `None` if a number is too large for the page.
pub(crate) fn balls(part: &BodyPart, symbols: &[&str], point: Position<Body>) -> Option<Value> {
    let atoms: Vec<([f64; 3], &str)> = part
        .particles
        .iter()
        .map(|particle| (particle.position() - point).to_array())
        .zip(symbols.iter().copied())
        .take(MOST)
        .collect();
    let centers: Vec<f32> = atoms.iter().flat_map(|(place, _)| place.map(|x| x as f32)).collect();
    if !centers.iter().all(|x| x.is_finite()) {
        return None;
    }
    let looks: Vec<Look> = atoms.iter().map(|(_, symbol)| look(symbol)).collect();
    let mut sticks = Vec::new();
    for (k, (a, _)) in atoms.iter().enumerate() {
        for (l, (b, _)) in atoms.iter().enumerate().skip(k + 1) {
            let apart = (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt();
            if apart < BOUND * (looks[k].radius + looks[l].radius) {
                sticks.push(json!([k, l]));
            }
        }
    }
    let own = json!({
        "kind": "balls",
        "centers": f32s(centers),
        "radii": f32s(looks.iter().map(|look| (SHOWN * look.radius) as f32)),
        "colors": looks.iter().map(|look| look.color).collect::<Vec<_>>(),
        "labels": atoms.iter().map(|(_, symbol)| *symbol).collect::<Vec<_>>(),
        "sticks": sticks,
    });
    Some(at(own, &part.name, [0.0; 3], [1.0, 0.0, 0.0, 0.0]))
}

/// Drawing parameters of an atom.
#[derive(Clone, Copy)]
struct Look {
    /// Covalent radius, m.
    radius: f64,
    color: &'static str,
}

/// Returns the drawing parameters of an element.
///
/// Covalent radii are those of Cordero et al., Dalton Trans. (2008) 2832. Colours follow Corey,
/// Pauling and Koltun.
fn look(symbol: &str) -> Look {
    let (picometres, color) = match symbol {
        "H" => (31.0, "#d9d9d9"),
        "C" => (76.0, "#4d4d4d"),
        "N" => (71.0, "#3355dd"),
        "O" => (66.0, "#cc3322"),
        "F" => (57.0, "#66bb44"),
        "P" => (107.0, "#dd8822"),
        "S" => (105.0, "#d9b92b"),
        "Cl" => (102.0, "#44aa44"),
        "Br" => (120.0, "#993322"),
        "I" => (139.0, "#773399"),
        _ => (140.0, "#a08fb0"),
    };
    Look { radius: picometres * 1e-12, color }
}
