//! Motions of a wrist, in words.

use polhode_identify::payload::NextMotion;
use serde_json::{Value, json};

use super::next::Named;
use crate::number::number;

impl Named for NextMotion {
    fn name(&self) -> String {
        match self {
            Self::Rest { down } => format!("rest with gravity along {}", direction(*down)),
            Self::Turn { axis, down, amplitude, rate } => {
                let along: f64 = axis.iter().zip(down).map(|(a, b)| a * b).sum();
                let gravity = if along.abs() < 0.5 { "across" } else { "along" };
                format!(
                    "± {}° about {}, to and fro in {} s, with gravity {gravity} it (along {} in the middle)",
                    number(amplitude.to_degrees(), 2),
                    direction(*axis),
                    number(core::f64::consts::TAU / rate, 2),
                    direction(*down)
                )
            }
        }
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
