//! Motions of a wrist, in words.

use polhode_document::number::number;
use polhode_identify::payload::NextMotion;
use serde_json::{Value, json};

use super::next::Named;

impl Named for NextMotion {
    fn name(&self) -> String {
        match self {
            Self::Rest { down } => format!("rest with gravity along {}", direction(*down)),
            Self::Turn { axis, down, .. } => {
                format!("a swing about {} with gravity along {}", direction(*axis), direction(*down))
            }
        }
    }

    fn details(&self) -> Option<String> {
        let Self::Turn { amplitude, rate, .. } = self else { return None };
        Some(format!(
            "± {}°, to and fro in {} s, gravity as said in the middle",
            number(amplitude.to_degrees(), 2),
            number(core::f64::consts::TAU / rate, 2)
        ))
    }

    fn to_json(&self) -> Value {
        match self {
            Self::Rest { down } => json!({ "kind": "rest", "down": down }),
            Self::Turn { axis, down, amplitude, rate } => json!({
                "kind": "turn",
                "axis": axis,
                "down": down,
                "amplitude_rad": amplitude,
                "rate_rad_s": rate,
            }),
        }
    }
}

/// `x − z` of (1, 0, −1)/√2.
fn direction(v: [f64; 3]) -> String {
    let mut text = String::new();
    for (part, axis) in v.into_iter().zip(["x", "y", "z"]).filter(|(part, _)| part.abs() > 0.1) {
        text.push_str(match (text.is_empty(), part > 0.0) {
            (true, true) => "",
            (true, false) => "−",
            (false, true) => " + ",
            (false, false) => " − ",
        });
        text.push_str(axis);
    }
    text
}
