//! Descriptions of a wrist's motions.

use polhode_document::number::number;
use serde_json::{Value, json};

use super::next::Named;
use crate::next::signed_axes;
use crate::payload::NextMotion;

impl Named for NextMotion {
    fn name(&self) -> String {
        match self {
            Self::Rest { down } => format!("rest with gravity along {}", signed_axes(*down)),
            Self::Turn { axis, down, .. } => {
                format!("a swing about {} with gravity along {}", signed_axes(*axis), signed_axes(*down))
            }
        }
    }

    fn details(&self) -> Option<String> {
        let Self::Turn { amplitude, rate, .. } = self else { return None };
        Some(format!(
            "± {}°, period {} s; gravity direction at mid-swing",
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
