//! Reading of the reference tables in fixtures/. A missing table fails its test.
#![allow(dead_code, reason = "each test file uses some of it")]

pub(crate) mod held;
pub(crate) mod scenario;

use polhode::prelude::*;

pub(crate) fn table(name: &str) -> toml::Table {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    text.parse().unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// Returns the tables under `key`; there must be at least one.
pub(crate) fn cases<'a>(table: &'a toml::Table, key: &str) -> Vec<&'a toml::Table> {
    let list: Vec<_> = table[key].as_array().unwrap().iter().map(|t| t.as_table().unwrap()).collect();
    assert!(!list.is_empty(), "no {key}");
    list
}

/// Returns a number that is stored as a number or, with 30 digits, as a string.
pub(crate) fn number(value: &toml::Value) -> f64 {
    match value {
        toml::Value::Float(x) => *x,
        toml::Value::Integer(n) => *n as f64,
        toml::Value::String(text) => text.parse().unwrap_or_else(|_| panic!("{text}")),
        other => panic!("{other:?} is not a number"),
    }
}

pub(crate) fn numbers<const N: usize>(value: &toml::Value) -> [f64; N] {
    let list: Vec<f64> = value.as_array().unwrap().iter().map(number).collect();
    list.try_into().unwrap_or_else(|list| panic!("{list:?} has not {N} numbers"))
}

pub(crate) fn matrix(value: &toml::Value) -> [[f64; 3]; 3] {
    let rows: Vec<_> = value.as_array().unwrap().iter().map(numbers).collect();
    rows.try_into().unwrap()
}

pub(crate) fn attitude(value: &toml::Value) -> Attitude {
    Attitude::from_quaternion(numbers(value)).unwrap()
}

/// Returns the body and its start of a computed case; pivoted if its arm is not zero.
pub(crate) fn start(case: &toml::Table) -> State {
    State {
        time: 0.0,
        attitude: attitude(&case["attitude0"]),
        omega: AngularVelocity::from_array(numbers(&case["omega0"])),
    }
}

/// Returns a free body with these moments along its axes.
pub(crate) fn free_body(moments: [f64; 3]) -> Rotor {
    let inertia = InertiaTensor::diagonal(moments).unwrap();
    Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia).unwrap())
}

/// Returns max |a − b| over the elements, relative to the largest element of b.
pub(crate) fn matrix_error(a: [[f64; 3]; 3], b: [[f64; 3]; 3]) -> f64 {
    let scale = b.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / scale
}
