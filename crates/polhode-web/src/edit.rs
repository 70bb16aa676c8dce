//! Changes of a scenario's text that preserve comments, order and spaces.

use polhode::body::{InertiaTensor, MassProperties, PrincipalFrame};
use polhode::math::Body;
use polhode_scenario::read::ScenarioFile;

use crate::protocol::Edit;
use toml_edit::{Array, DocumentMut, InlineTable, Item, Table, TableLike, Value};

/// Reason why a change could not be made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum EditError {
    /// The text is not valid TOML; the TOML reader reports the place.
    Syntax,
    /// The key does not exist.
    Key { key: String },
    /// The new value is not a valid TOML value.
    Value { value: String },
    /// The change needs a scenario that can be read.
    Scenario,
    /// The moments are not those of a physical body.
    Body { why: String },
}

impl std::fmt::Display for EditError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Syntax => f.write_str("the text is not valid TOML, so its values cannot be changed"),
            Self::Key { key } => write!(f, "the scenario has no {key}"),
            Self::Value { value } => write!(f, "{value:?} is not a valid value in a scenario"),
            Self::Scenario => {
                f.write_str("the text is not a valid scenario, so its body and start are unknown")
            }
            Self::Body { why } => f.write_str(why),
        }
    }
}

/// Applies changes to the text, one after the other. `read` reads the scenario for changes that
/// need its body or its start.
pub(crate) fn edited(
    text: &str,
    edits: &[Edit],
    mut read: impl FnMut(&str) -> Option<ScenarioFile>,
) -> Result<String, EditError> {
    let mut text = text.to_owned();
    for edit in edits {
        let mut document: DocumentMut = text.parse().map_err(|_| EditError::Syntax)?;
        match edit {
            Edit::Set { set: key, value } => {
                set(&mut document, key, value.as_deref())?;
                if let Some(torque) = key.strip_suffix(".on") {
                    name(&mut document, torque);
                }
            }
            Edit::Start { attitude, omega } => start(&mut document, Some(*attitude), *omega),
            Edit::Omega { omega } => {
                let is_relative =
                    document.get("start").is_some_and(|start| start.get("relative_to").is_some());
                let attitude = match is_relative {
                    // A start that is no longer relative to the orbit needs the attitude in space.
                    true => {
                        let file = read(&text).ok_or(EditError::Scenario)?;
                        Some(file.scenario.start().attitude.canonical_quaternion())
                    }
                    false => None,
                };
                start(&mut document, attitude, *omega);
            }
            Edit::Moments { moments } => {
                let file = read(&text).ok_or(EditError::Scenario)?;
                let body = with_moments(file.scenario.body(), *moments)?;
                tensor(&mut document, &body);
            }
        }
        text = document.to_string();
    }
    Ok(text)
}

/// Sets or removes the value of a key. The tables on its path must exist, except the last.
fn set(document: &mut DocumentMut, key: &str, value: Option<&str>) -> Result<(), EditError> {
    let no_key = || EditError::Key { key: key.to_owned() };
    let mut steps = steps(key).ok_or_else(no_key)?;
    let last = steps.pop().ok_or_else(no_key)?;
    let mut item = document.as_item_mut();
    for step in &steps {
        item = match step {
            Step::Key(name) => item.get_mut(name.as_str()),
            Step::Index(k) => item.get_mut(*k),
        }
        .ok_or_else(no_key)?;
    }
    let value = value.map(parsed).transpose()?;
    match (last, value) {
        (Step::Key(name), Some(value)) => put(item.as_table_like_mut().ok_or_else(no_key)?, &name, value),
        (Step::Key(name), None) => {
            item.as_table_like_mut().ok_or_else(no_key)?.remove(&name);
        }
        (Step::Index(k), Some(mut value)) => {
            let old = item.as_array_mut().and_then(|array| array.get_mut(k)).ok_or_else(no_key)?;
            *value.decor_mut() = old.decor().clone();
            *old = value;
        }
        (Step::Index(_), None) => return Err(no_key()),
    }
    Ok(())
}

/// Names a torque after its model if it has no name. A torque that is off needs a name.
fn name(document: &mut DocumentMut, key: &str) {
    let k = key.strip_prefix("torque[").and_then(|rest| rest.strip_suffix(']')).and_then(|k| k.parse().ok());
    let Some(torques) = document.get_mut("torque").and_then(Item::as_array_of_tables_mut) else { return };
    let named = |torque: &Table, name: &str| torque.get("name").and_then(Item::as_str) == Some(name);
    let model = k.and_then(|k: usize| torques.get(k)).filter(|torque| !torque.contains_key("name"));
    let Some(model) = model.and_then(|torque| torque.get("model")).and_then(Item::as_str) else { return };
    let mut names = (1..)
        .map(|n| if n == 1 { model.replace('_', " ") } else { format!("{} {n}", model.replace('_', " ")) });
    let free = names.find(|name| !torques.iter().any(|torque| named(torque, name)));
    if let (Some(torque), Some(name)) = (k.and_then(|k| torques.get_mut(k)), free) {
        torque.insert("name", Item::Value(Value::from(name)));
    }
}

/// Puts a value into a table, with the spaces and the comment of the previous value.
fn put(table: &mut dyn TableLike, key: &str, mut value: Value) {
    match table.get_mut(key) {
        Some(Item::Value(old)) => {
            *value.decor_mut() = old.decor().clone();
            *old = value;
        }
        Some(item) => *item = Item::Value(value),
        None => {
            table.insert(key, Item::Value(value));
        }
    }
}

/// Parses a single TOML value without anything after it.
fn parsed(value: &str) -> Result<Value, EditError> {
    let no_value = || EditError::Value { value: value.chars().take(80).collect() };
    if value.contains(['\n', '\r']) {
        return Err(no_value());
    }
    value.parse().map_err(|_| no_value())
}

enum Step {
    Key(String),
    Index(usize),
}

/// Splits a key such as `body.part[0].size[2]` into its steps.
fn steps(key: &str) -> Option<Vec<Step>> {
    let mut steps = Vec::new();
    for word in key.split('.') {
        let (name, mut rest) = word.split_at(word.find('[').unwrap_or(word.len()));
        if name.is_empty() {
            return None;
        }
        steps.push(Step::Key(name.to_owned()));
        while let Some(inside) = rest.strip_prefix('[') {
            let (index, after) = inside.split_once(']')?;
            steps.push(Step::Index(index.parse().ok()?));
            rest = after;
        }
        if !rest.is_empty() {
            return None;
        }
    }
    Some(steps)
}

/// Writes ω in body axes, and the attitude if given, into the start.
fn start(document: &mut DocumentMut, attitude: Option<[f64; 4]>, omega: [f64; 3]) {
    let item = document.entry("start").or_insert_with(|| Item::Table(Table::new()));
    let Some(table) = item.as_table_like_mut() else { return };
    if attitude.is_some() {
        table.remove("relative_to");
    }
    // A unit in the text is kept for ω.
    let unit = unit_of_spin(table.get("spin"));
    let numbers = omega.map(|component| match unit {
        Some(("deg/s", _)) => Value::from(format!("{} deg/s", short(component.to_degrees()))),
        Some(("rpm", factor)) => Value::from(format!("{} rpm", short(component * factor))),
        _ => Value::from(format!("{} rad/s", short(component))),
    });
    put(table, "spin", Value::InlineTable(of_one("body", numbers.into_iter().collect::<Array>())));
    if let Some(quaternion) = attitude {
        let numbers = quaternion.map(|q| Value::from(rounded(q)));
        let quaternion = of_one("quaternion", numbers.into_iter().collect::<Array>());
        put(table, "attitude", Value::InlineTable(quaternion));
    }
}

/// Returns the unit that all components of a spin have, and its conversion factor: the number of
/// these units in 1 rad/s.
fn unit_of_spin(spin: Option<&Item>) -> Option<(&'static str, f64)> {
    let written = spin?.get("body")?.as_array()?;
    let per_turn = 30.0 / std::f64::consts::PI;
    let has =
        |unit: &str| written.iter().all(|value| value.as_str().is_some_and(|text| text.ends_with(unit)));
    [("deg/s", 0.0), ("rpm", per_turn)].into_iter().find(|(unit, _)| has(unit))
}

fn of_one(key: &str, value: Array) -> InlineTable {
    let mut table = InlineTable::new();
    table.insert(key, Value::Array(value));
    table.fmt();
    table
}

/// Returns the body with other principal moments, kg·m², and with the same axes and mass.
fn with_moments(body: &MassProperties<Body>, moments: [f64; 3]) -> Result<MassProperties<Body>, EditError> {
    let no_body = |error: polhode::body::BodyError| EditError::Body { why: error.to_string() };
    let axes = PrincipalFrame::of(body.inertia()).axes().map(polhode::math::Vector::to_array);
    // I = Σ iₖ eₖ eₖᵀ
    let element = |i: usize, j: usize| (0..3).map(|k| moments[k] * axes[k][i] * axes[k][j]).sum::<f64>();
    let matrix = std::array::from_fn(|i| std::array::from_fn(|j| element(i.min(j), i.max(j))));
    let tensor = InertiaTensor::from_matrix(matrix).map_err(no_body)?;
    MassProperties::new(body.mass(), body.center_of_mass(), tensor).map_err(no_body)
}

/// Replaces all parts of the body by one tensor.
fn tensor(document: &mut DocumentMut, body: &MassProperties<Body>) {
    let mut part = Table::new();
    let numbers = |values: [f64; 3]| values.into_iter().map(Value::from).collect::<Array>();
    part.insert("name", Item::Value(Value::from("body")));
    part.insert("shape", Item::Value(Value::from("tensor")));
    part.insert("mass", Item::Value(Value::from(body.mass())));
    part.insert("center_of_mass", Item::Value(Value::Array(numbers(body.center_of_mass().to_array()))));
    let rows = body.inertia().matrix().map(|row| Value::Array(numbers(row)));
    part.insert("inertia", Item::Value(Value::Array(rows.into_iter().collect())));
    let mut parts = toml_edit::ArrayOfTables::new();
    parts.push(part);
    let whole = document.entry("body").or_insert_with(|| Item::Table(Table::new()));
    if let Some(table) = whole.as_table_like_mut() {
        table.insert("part", Item::ArrayOfTables(parts));
    }
}

/// Formats a number with seven significant digits, without trailing zeros.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.6e}").parse().unwrap_or(value);
    let plain = format!("{rounded}");
    if plain.len() > 12 { format!("{rounded:e}") } else { plain }
}

/// Rounds to 12 decimals. A quaternion is normalised when it is read.
fn rounded(value: f64) -> f64 {
    (value * 1e12).round() / 1e12
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use polhode_source::files::Disk;

    use super::*;

    const TEXT: &str = "# A top.\n[[body.part]]\nname = \"stem\" # of steel\nshape = \"box\"\nsize = [\"1 m\", \"2 m\",   \"3 m\"]\nmass = \"5 kg\"\n\n[start]\nspin = { body = [\"1 deg/s\", \"2 deg/s\", \"3 deg/s\"] } # slow\n";

    fn read(text: &str) -> Option<ScenarioFile> {
        ScenarioFile::parse(&Disk, text.to_owned(), "a.toml".as_ref()).ok()
    }

    fn with(edits: &[Edit]) -> String {
        edited(TEXT, edits, read).unwrap()
    }

    fn key(set: &str, value: &str) -> Edit {
        Edit::Set { set: set.to_owned(), value: Some(value.to_owned()) }
    }

    #[test]
    fn one_value_changes_and_nothing_else() {
        let text = with(&[key("body.part[0].size[1]", "\"25 mm\""), key("body.part[0].mass", "\"7 kg\"")]);
        assert_eq!(text, TEXT.replace("\"2 m\"", "\"25 mm\"").replace("5 kg", "7 kg"));
        let text = with(&[Edit::Omega { omega: [0.0, -0.1, 2.0] }]);
        let spin = "[\"0 deg/s\", \"-5.729578 deg/s\", \"114.5916 deg/s\"] } # slow";
        assert_eq!(text, TEXT.replace("[\"1 deg/s\", \"2 deg/s\", \"3 deg/s\"] } # slow", spin));
    }

    #[test]
    fn a_throw_starts_where_the_hand_let_go() {
        let attitude = [0.5, -0.5, 0.1, 0.7];
        let text = with(&[Edit::Start { attitude, omega: [0.3, -0.2, 0.7] }]);
        let start = read(&text).unwrap().scenario;
        let start = start.start();
        assert!((start.omega.to_array()[1].to_degrees() + 0.2_f64.to_degrees()).abs() < 1e-5);
        let norm = attitude.iter().map(|q| q * q).sum::<f64>().sqrt();
        let [w, _, _, z] = start.attitude.canonical_quaternion();
        assert!((w - 0.5 / norm).abs() < 1e-11 && (z - 0.7 / norm).abs() < 1e-11, "{text}");
    }

    #[test]
    fn moments_keep_the_mass_the_place_and_the_axes() {
        let turned = TEXT.replace(
            "mass =",
            "position = [1, -2, 3]\nrotate = { axis = [1, 2, 3], angle = \"40 deg\" }\nmass =",
        );
        let before = read(&turned).unwrap().scenario;
        let text = edited(&turned, &[Edit::Moments { moments: [2.0, 3.5, 4.75] }], read).unwrap();
        assert!(text.starts_with("# A top.\n") || text.contains("[start]"), "{text}");
        let after = read(&text).unwrap().scenario;
        let [old, new] = [&before, &after].map(|s| PrincipalFrame::of(s.body().inertia()));
        assert_eq!(after.body().mass(), 5.0);
        assert_eq!(after.body().center_of_mass(), before.body().center_of_mass());
        for k in 0..3 {
            assert!((new.moments()[k] - [2.0, 3.5, 4.75][k]).abs() < 1e-14);
            let [a, b] = [old.axes()[k].to_array(), new.axes()[k].to_array()];
            let cosine: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
            assert!(cosine.abs() > 1.0 - 1e-14);
        }
        let impossible = edited(TEXT, &[Edit::Moments { moments: [1.0, 1.0, 3.0] }], read);
        assert!(matches!(impossible, Err(EditError::Body { .. })), "{impossible:?}");
    }

    #[test]
    fn a_torque_that_is_switched_off_gets_a_name() {
        let drag = "\n[[torque]]\nmodel = \"energy_sink\"\nrate = 3e-3\n";
        let text = format!("{TEXT}{drag}{drag}").replacen("rate", "name = \"energy sink\"\nrate", 1);
        let off = edited(&text, &[key("torque[1].on", "false")], read).unwrap();
        assert!(off.contains("name = \"energy sink 2\"") && off.contains("on = false"), "{off}");
        let on = edited(&off, &[key("torque[1].on", "true"), key("torque[0].on", "true")], read).unwrap();
        assert_eq!(on.matches("name = \"energy sink").count(), 2, "{on}");
    }

    #[test]
    fn what_is_not_there_or_no_value_is_refused() {
        for (set, value) in [
            ("body.part[3].mass", "1"),
            ("body..mass", "1"),
            ("body.part[0].mass", "1 = 2"),
            ("body.part[0].mass", "1\nb = 2"),
            ("start.spin.body[3]", "1"),
        ] {
            assert!(edited(TEXT, &[key(set, value)], read).is_err(), "{set} = {value}");
        }
        assert_eq!(edited("[", &[key("a", "1")], read), Err(EditError::Syntax));
    }
}
