//! Typical errors of a centre of mass: wrong sign, wrong unit, exchanged coordinates.
//!
//! Undoing the error must bring all three coordinates to the geometry's centroid, and must not
//! change a coordinate that is already right. A centroid at the origin does not confirm a unit,
//! because every small factor leads there. A fix follows if exactly one result remains.

use polhode_source::xml::Number;

use super::body::Body;
use super::edit::{center, multiplied};
use super::explanation::BETTER;
use super::material::is_plausible;
use super::written::negated;
use crate::finding::Repair;
use crate::model::RobotModel;

/// Distance from the centroid that counts as zero, relative to the diagonal of the geometry's
/// bounds.
const NEAR: f64 = 0.01;

/// Factors that correct coordinates in other units.
const UNITS: [(f64, &str); 6] = [
    (0.001, "in mm"),
    (0.01, "in cm"),
    (0.0254, "in inches"),
    (0.1, "10 times too large"),
    (10.0, "10 times too small"),
    (1000.0, "1000 times too small"),
];

/// Returns the error in words and its fix, if exactly one result remains.
pub(super) fn repair(model: &RobotModel, body: &Body, diagonal: f64) -> Option<(String, Repair)> {
    if body.geometry.is_turned_by_some {
        return None;
    }
    let numbers = center(model, body.inertial)?;
    let mut found: Vec<(String, [String; 3])> = Vec::new();
    for solid in body.solids().filter(|s| is_plausible(s.kind, body.mass / s.volume)) {
        for (what, texts) in slips(&numbers) {
            let value = |text: &str| text.parse::<f64>().unwrap_or(f64::NAN);
            let right = texts.each_ref().map(|text| value(text));
            let explains = |k: usize| {
                let was = (value(&numbers[k].text) - solid.centroid[k]).abs();
                let left = (right[k] - solid.centroid[k]).abs();
                let is_kept = texts[k] == numbers[k].text || value(&numbers[k].text) == 0.0;
                left <= NEAR * diagonal && (is_kept || BETTER * left <= was)
            };
            let is_told = BETTER * distance(right, solid.centroid) <= distance([0.0; 3], solid.centroid);
            if is_told && (0..3).all(explains) && !found.iter().any(|(_, others)| *others == texts) {
                found.push((what, texts));
            }
        }
    }
    let [(what, texts)] = found.as_slice() else { return None };
    let changed = numbers.iter().zip(texts).filter(|(number, text)| number.text != **text);
    let edits: Vec<_> = changed.map(|(number, text)| (number.span.clone(), text.clone())).collect();
    let old = numbers.each_ref().map(|number| number.text.as_str()).join(" ");
    let description =
        format!("centre of mass {old} → {}: {what}; it then equals the geometry's centroid", texts.join(" "));
    Some((what.clone(), Repair { description, edits }))
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

/// Returns the coordinates with each error undone.
fn slips(numbers: &[Number; 3]) -> Vec<(String, [String; 3])> {
    let texts = numbers.each_ref().map(|number| number.text.clone());
    let is_zero = |k: usize| numbers[k].value == Some(0.0);
    let mut slips = Vec::new();
    // Sign changes of any coordinates.
    for flips in 1_usize..8 {
        let flipped = |k: usize| flips >> k & 1 == 1;
        if (0..3).any(|k| flipped(k) && is_zero(k)) {
            continue;
        }
        let changed = [0, 1, 2].map(|k| if flipped(k) { negated(&texts[k]) } else { texts[k].clone() });
        let names: Vec<&str> =
            (0..3).filter(|k| flipped(*k)).filter_map(|k| ["x", "y", "z"].get(k).copied()).collect();
        slips.push((format!("{} with the wrong sign", names.join(" and ")), changed));
    }
    // Units of all coordinates, or of one.
    for (factor, unit) in UNITS {
        for only in [None, Some(0), Some(1), Some(2)] {
            let changes = |k: usize| !is_zero(k) && only.is_none_or(|j| j == k);
            let changed = [0, 1, 2]
                .map(|k| if changes(k) { multiplied(&numbers[k], factor) } else { Some(texts[k].clone()) });
            let [Some(x), Some(y), Some(z)] = changed else { continue };
            let what = only.and_then(|k: usize| ["x ", "y ", "z "].get(k).copied()).unwrap_or("");
            slips.push((format!("{what}{unit}"), [x, y, z]));
        }
    }
    for [i, j] in [[0, 1], [0, 2], [1, 2]] {
        let mut changed = texts.clone();
        changed.swap(i, j);
        let names = ["x", "y", "z"];
        slips.push((format!("{} and {} swapped", names[i], names[j]), changed));
    }
    slips
}
