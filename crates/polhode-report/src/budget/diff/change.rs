//! What became of a row.

use polhode_budget::{CopyErrors, Subtotal};
use polhode_document::layout::printable;
use polhode_document::number::number;
use serde_json::{Value, json};

use super::errors::Deviation;

/// What became of a row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Change {
    pub(super) row: String,
    pub(super) what: What,
}

/// One thing that became of it.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum What {
    /// All copies of its own part, kg: what stands in it has a row of its own.
    Added(f64),
    Removed(f64),
    /// One copy of its own part, kg.
    Mass([f64; 2]),
    Quantity([u32; 2]),
    /// How their errors go together.
    Copies([CopyErrors; 2]),
    /// Its frame, or its centre of mass in it, m.
    Moved(f64),
    /// rad
    Turned(f64),
    /// The tensor about its centre, as a part of its greatest element.
    Tensor(f64),
    /// Fractions.
    Growth([f64; 2]),
    /// Its code.
    Maturity([Option<String>; 2]),
    Allowable([Option<f64>; 2]),
    /// What the list states that it comes to.
    Subtotal([Option<Subtotal>; 2]),
    /// The row in which it stands.
    Parent([Option<String>; 2]),
    /// The group with which its errors are correlated.
    Group([Option<String>; 2]),
    /// Standard deviations that are others; none where only correlations are.
    Uncertainty(Vec<Deviation>),
}

impl What {
    pub(super) fn words(&self) -> String {
        let known = |x: &Option<f64>| x.map_or_else(none, |x| format!("{} kg", number(x, 6)));
        match self {
            Self::Added(0.0) => "added, a frame".to_owned(),
            Self::Removed(0.0) => "removed, a frame".to_owned(),
            Self::Added(mass) => format!("added, with {} kg", number(*mass, 6)),
            Self::Removed(mass) => format!("removed, with {} kg", number(*mass, 6)),
            Self::Mass([before, after]) => {
                let word = if after > before { "heavier" } else { "lighter" };
                format!("{word}: {}", from_to(*before, *after, "kg"))
            }
            Self::Quantity([before, after]) => format!("{before} to {after} of it"),
            Self::Moved(by) => format!("moved by {} mm", number(1e3 * by, 4)),
            Self::Turned(by) => format!("turned by {} deg", number(by.to_degrees(), 4)),
            Self::Tensor(part) => {
                format!("its inertia tensor changed by up to {} % of itself", number(100.0 * part, 3))
            }
            Self::Growth([before, after]) => {
                format!("growth allowance {} % to {} %", number(100.0 * before, 4), number(100.0 * after, 4))
            }
            Self::Allowable([before, after]) => {
                format!("allowable mass {} to {}", known(before), known(after))
            }
            Self::Parent([before, after]) => {
                let named =
                    |name: &Option<String>| name.as_deref().map_or_else(|| "nothing".to_owned(), printable);
                format!("stood in {}, stands in {}", named(before), named(after))
            }
            Self::Maturity(both) => {
                let [before, after] =
                    both.each_ref().map(|code| code.as_deref().map_or_else(none, printable));
                format!("maturity {before} to {after}")
            }
            Self::Copies(both) => {
                let [before, after] = both.map(copies);
                format!("copies {before} to {after}")
            }
            Self::Subtotal(both) => {
                let stated = |subtotal: Option<Subtotal>| {
                    let stated = |subtotal: Subtotal| {
                        format!("{} ± {} kg", number(subtotal.mass, 9), number(subtotal.tolerance, 3))
                    };
                    subtotal.map_or_else(none, stated)
                };
                let [before, after] = both.map(stated);
                format!("subtotal {before} to {after}")
            }
            Self::Group(both) => {
                let [before, after] =
                    both.each_ref().map(|name| name.as_deref().map_or_else(none, printable));
                format!("group {before} to {after}")
            }
            Self::Uncertainty(all) if all.is_empty() => "its errors are correlated otherwise".to_owned(),
            Self::Uncertainty(all) => {
                let words: Vec<String> = all.iter().map(Deviation::words).collect();
                format!("sd of {}", words.join(", of "))
            }
        }
    }

    /// What it is, before, after, by how much.
    pub(super) fn to_json(&self) -> (&'static str, Value, Value, Value) {
        let pair = |what, [before, after]: [Value; 2]| (what, before, after, Value::Null);
        let by = |what, by: f64| (what, Value::Null, Value::Null, Value::from(by));
        match self {
            Self::Added(mass) => pair("added", [Value::Null, Value::from(*mass)]),
            Self::Removed(mass) => pair("removed", [Value::from(*mass), Value::Null]),
            Self::Mass(both) => pair("mass", both.map(Value::from)),
            Self::Quantity(both) => pair("quantity", both.map(Value::from)),
            Self::Moved(distance) => by("moved", *distance),
            Self::Turned(angle) => by("turned", *angle),
            Self::Tensor(part) => by("tensor", *part),
            Self::Growth(both) => pair("growth", both.map(Value::from)),
            Self::Allowable(both) => pair("allowable", both.map(Value::from)),
            Self::Parent(both) => pair("parent", both.clone().map(Value::from)),
            Self::Maturity(both) => pair("maturity", both.clone().map(Value::from)),
            Self::Copies(both) => pair("copies", both.map(|errors| Value::from(copies(errors)))),
            Self::Subtotal(both) => {
                let one = |one: Subtotal| json!({ "mass": one.mass, "tolerance": one.tolerance });
                pair("subtotal", both.map(|subtotal| subtotal.map_or(Value::Null, one)))
            }
            Self::Group(both) => pair("group", both.clone().map(Value::from)),
            Self::Uncertainty(all) => {
                let side = |side: usize| {
                    all.iter().map(|one| (one.name.to_owned(), Value::from(one.sd[side]))).collect()
                };
                pair("uncertainty", [Value::Object(side(0)), Value::Object(side(1))])
            }
        }
    }
}

fn none() -> String {
    "none".to_owned()
}

/// As the column `copies` has it.
const fn copies(errors: CopyErrors) -> &'static str {
    match errors {
        CopyErrors::Alike => "alike",
        CopyErrors::Independent => "independent",
    }
}

pub(super) fn from_to(before: f64, after: f64, unit: &str) -> String {
    format!("{} to {} {unit}, by {} {unit}", number(before, 6), number(after, 6), signed(after - before))
}

pub(super) fn signed(x: f64) -> String {
    let shown = number(x, 3);
    if x > 0.0 { format!("+{shown}") } else { shown }
}
