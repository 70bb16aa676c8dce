//! Schema of scenario files. All files of the project conform, changed ones do not, and the book
//! has the same keys.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::{fs, iter};

use polhode_scenario::read as scenario;
use serde_json::{Value, json};

use super::common::page::{blocks, names, root, rows, scenario_pages, scenario_reference, section};
use super::fit::fits;

static SCHEMA: LazyLock<Value> = LazyLock::new(scenario::schema);

/// Returns a value of the schema with its reference resolved.
fn resolved(schema: &Value) -> &Value {
    match schema["$ref"].as_str() {
        Some(name) => SCHEMA.pointer(&name[1..]).unwrap(),
        None => schema,
    }
}

/// Returns the place and reason if a file does not conform to the schema.
fn misfit(file: &Value) -> Option<String> {
    fits(&SCHEMA, &SCHEMA, file, "").err()
}

/// Converts a TOML file to JSON.
fn json(text: &str) -> Value {
    serde_json::to_value(toml::from_str::<toml::Table>(text).unwrap()).unwrap()
}

/// Returns every scenario and plan of the examples, of the command's templates and of the book.
fn files() -> Vec<(PathBuf, String)> {
    let folders = ["examples", "examples/notes", "examples/sweeps", "crates/polhode-cli/src/new"];
    let entries = folders.iter().flat_map(|folder| fs::read_dir(root().join(folder)).unwrap());
    let paths = entries.map(|entry| entry.unwrap().path());
    let mut files: Vec<_> = paths
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .map(|path| (path.clone(), fs::read_to_string(&path).unwrap()))
        .collect();
    for name in scenario_pages().into_iter().chain(["sweep.md".to_owned()]) {
        let page = fs::read_to_string(root().join("book").join(&name)).unwrap();
        let complete = blocks(&page).into_iter().filter(|(_, is_fragment, _)| !is_fragment);
        files.extend(complete.map(|(line, _, text)| (root().join(format!("examples/{name}:{line}")), text)));
    }
    assert!(files.len() > 80, "{}", files.len());
    files
}

#[test]
fn every_scenario_fits() {
    for (path, text) in files() {
        let misfit = misfit(&json(&text));
        assert_eq!(misfit, None, "{}", path.display());
    }
}

/// Reader and schema refuse values of another type, and keys that no table has.
#[test]
fn what_does_not_fit_is_refused_by_both() {
    let (mut tried, mut seen) = (0, BTreeSet::new());
    for (path, text) in files() {
        let whole = json(&text);
        for pointer in pointers(&whole, "") {
            // Tables with the same keys at the same place are tested once.
            let (table, _) = pointer.rsplit_once('/').unwrap();
            let keys = whole.pointer(table).unwrap().as_object().map(|keys| keys.keys().collect::<Vec<_>>());
            let names: String = pointer.split('/').filter(|step| step.parse::<usize>().is_err()).collect();
            if !seen.insert(format!("{names} {keys:?}")) {
                continue;
            }
            let free = pointer.starts_with("/sweep/questions");
            // Its keys are names of the user's choice.
            let is_named = pointer == "/symbols";
            let mut changes = vec![Value::Bool(true)];
            changes.extend((!is_named).then(|| serde_json::json!({ "zzz": 1 })));
            if whole.pointer(&pointer).unwrap().is_object() && !free && !is_named {
                let mut more = whole.pointer(&pointer).unwrap().clone();
                more["zzz"] = Value::from(1);
                changes.push(more);
            }
            for change in changes {
                let mut changed = whole.clone();
                if changed.pointer(&pointer) == Some(&change)
                    || change.is_boolean() && whole.pointer(&pointer).unwrap().is_boolean()
                {
                    continue;
                }
                *changed.pointer_mut(&pointer).unwrap() = change;
                let place = format!("{}, {pointer}", path.display());
                assert!(misfit(&changed).is_some(), "{place}: the schema accepts {changed}");
                let text = toml_of(&changed);
                assert!(scenario::parse(&text, &path).is_err(), "{place}: the reader accepts {text}");
                tried += 1;
            }
        }
    }
    assert!(tried > 1000, "{tried}");
}

/// Formats a file with one line for each of its keys.
fn toml_of(file: &Value) -> String {
    fn value(json: &Value) -> String {
        match json {
            Value::Object(entries) => {
                let pairs: Vec<_> =
                    entries.iter().map(|(key, inner)| format!("{key:?} = {}", value(inner))).collect();
                format!("{{ {} }}", pairs.join(", "))
            }
            Value::Array(elements) => {
                format!("[{}]", elements.iter().map(value).collect::<Vec<_>>().join(", "))
            }
            plain => plain.to_string(),
        }
    }
    file.as_object().unwrap().iter().map(|(key, json)| format!("{key} = {}\n", value(json))).collect()
}

/// Returns the paths to all values inside a value.
fn pointers(value: &Value, way: &str) -> Vec<String> {
    let inner: Vec<(String, &Value)> = match value {
        Value::Object(entries) => entries.iter().map(|(key, value)| (key.clone(), value)).collect(),
        Value::Array(elements) => {
            elements.iter().enumerate().map(|(k, value)| (k.to_string(), value)).collect()
        }
        _ => Vec::new(),
    };
    let below = inner.iter().flat_map(|(key, value)| {
        let way = format!("{way}/{key}");
        iter::once(way.clone()).chain(pointers(value, &way))
    });
    below.collect()
}

/// Table of the schema.
#[derive(Debug)]
struct Place {
    /// Path of keys, separated by dots.
    path: String,
    title: String,
    keys: Vec<(String, &'static Value)>,
    required: BTreeSet<String>,
}

fn places() -> Vec<Place> {
    let mut found = Vec::new();
    walk(&SCHEMA, "", &mut found);
    found
}

fn walk(schema: &'static Value, path: &str, found: &mut Vec<Place>) {
    let schema = resolved(schema);
    if let Some(keys) = schema["properties"].as_object() {
        let title = schema["title"].as_str().unwrap_or_default().to_owned();
        let keys = keys.iter().map(|(key, value)| (key.clone(), value));
        let required = schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str);
        let required = required.map(str::to_owned).collect();
        found.push(Place { path: path.to_owned(), title, keys: keys.clone().collect(), required });
        for (key, value) in keys {
            walk(value, format!("{path}.{key}").trim_start_matches('.'), found);
        }
    }
    let forms = ["anyOf", "oneOf"].into_iter().filter_map(|word| schema[word].as_array()).flatten();
    forms.chain(schema.get("items")).for_each(|form| walk(form, path, found));
}

/// Headings of the reference for the keys of a table, and the path of the table.
const PAGE: [(&str, &[&str]); 32] = [
    ("## The file", &[""]),
    ("## Body", &["body"]),
    ("### Particles", &["body.part.particles"]),
    ("## Rotations", &["body.part.rotate", "start.attitude", "torque.rest", "contact.surface.rotate"]),
    ("## Orbit", &["orbit"]),
    ("## Start", &["start"]),
    ("### Spin", &["start.spin"]),
    ("### Pulses", &["torque.pulses"]),
    ("## Wheels", &["wheel"]),
    ("## Mass history", &["mass_history"]),
    ("### Burns", &["mass_history.burn"]),
    ("### Drops", &["mass_history.drop"]),
    ("### Exits", &["mass_history.exit"]),
    ("## Contact", &["contact"]),
    ("### Surface", &["contact.surface"]),
    ("### Ground", &["contact.ground"]),
    ("## Gimbals", &["gimbals"]),
    ("### Axes", &["gimbals.outer", "gimbals.inner"]),
    ("### Base", &["gimbals.base"]),
    ("## Events", &["event"]),
    ("## Pointing", &["pointing"]),
    ("## Prescribed", &["prescribed"]),
    ("### Angular velocity", &["prescribed.omega"]),
    ("## Shaft", &["shaft"]),
    ("### Balance", &["shaft.balance"]),
    ("## Pendulum", &["pendulum"]),
    ("## Run", &["run"]),
    // Including the keys of each model or shape.
    ("## Torques", &["torque"]),
    ("### Shapes", &["body.part"]),
    // Tables that are a value in another table.
    ("## Events", &["event.then"]),
    ("### Measures", &["event.between"]),
    ("## Pointing", &["pointing.to"]),
];

fn page() -> &'static str {
    static PAGE: LazyLock<String> = LazyLock::new(scenario_reference);
    &PAGE
}

/// Returns the keys in the first cells of the table under a heading.
fn in_book(heading: &str) -> BTreeSet<String> {
    rows(section(page(), heading)).iter().flat_map(|row| names(row[0])).map(str::to_owned).collect()
}

/// Returns the keys of all forms of a table.
fn of_place(places: &[Place], path: &str) -> BTreeSet<String> {
    let there = places.iter().filter(|place| place.path == path);
    there.flat_map(|place| place.keys.iter().map(|(key, _)| key.clone())).collect()
}

/// Adds the keys that only one side has.
fn compare(book: &BTreeSet<String>, keys: &BTreeSet<String>, place: &str, wrong: &mut Vec<String>) {
    wrong.extend(book.difference(keys).map(|key| format!("{place}: the reader has no `{key}`")));
    wrong.extend(keys.difference(book).map(|key| format!("{place}: the book lacks `{key}`")));
}

#[test]
fn the_book_has_every_key_and_no_other() {
    let places = places();
    let mut wrong = Vec::new();
    for place in &places {
        let is_there = PAGE.iter().any(|(_, paths)| paths.contains(&place.path.as_str()));
        let is_rotor = place.path == "gimbals.rotor";
        if !is_there && !is_rotor && !place.path.starts_with("sweep") {
            wrong.push(format!("no heading is known for `{}`", place.path));
        }
    }
    for (heading, paths) in PAGE {
        for path in paths {
            let keys = of_place(&places, path);
            match *path {
                "torque" | "body.part" => {}
                "event.then" | "event.between" | "pointing.to" => {
                    let text = section(page(), heading);
                    let lacks = keys.iter().filter(|key| !text.contains(&format!("{key} = ")));
                    wrong.extend(lacks.map(|key| format!("{heading}: the book lacks `{key}`")));
                }
                _ => compare(&in_book(heading), &keys, &format!("{heading}, {path}"), &mut wrong),
            }
        }
    }
    // The rotor axis has the same first keys as the gimbal axes.
    let rotor = of_place(&places, "gimbals.rotor");
    wrong.extend(rotor.difference(&in_book("### Axes")).map(|key| format!("gimbals.rotor: {key}")));
    let every_torque = &in_book("## Torques") | &in_book("### When a torque acts");
    for place in places.iter().filter(|place| place.path == "torque") {
        let model = place.title.split('"').nth(1).unwrap();
        let heading = format!("### Torque `{model}`");
        let keys = place.keys.iter().map(|(key, _)| key.clone()).collect();
        compare(&(&in_book(&heading) | &every_torque), &keys, &heading, &mut wrong);
    }
    let headings = page().lines().filter_map(|line| line.strip_prefix("### Torque `")?.strip_suffix('`'));
    let models = places
        .iter()
        .filter_map(|place| place.title.strip_prefix("[[torque]] of model \"")?.strip_suffix('"'));
    compare(
        &headings.map(str::to_owned).collect(),
        &models.map(str::to_owned).collect(),
        "models",
        &mut wrong,
    );
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Returns the words for a type in the tables of the book, one of which must be in the cell; empty
/// if any text is allowed.
fn words(schema: &'static Value) -> Vec<&'static str> {
    let schema = resolved(schema);
    let description = schema["description"].as_str().unwrap_or_default();
    let dimension =
        description.split([',', ';']).next().and_then(|text| text.split_once(' ')).map(|(_, name)| name);
    if let Some(name) = dimension.filter(|_| !schema["type"].is_null()) {
        let is_composed = name.starts_with("quantity");
        return if is_composed {
            Vec::new()
        } else {
            vec![name, name.trim_start_matches("plain "), "formula", "quantity", "what is measured"]
        };
    }
    match schema["type"].as_str() {
        Some("integer") => vec!["whole number", "2, 4 or 6"],
        Some("boolean") => vec!["true or false"],
        Some("array") => match (schema["minItems"].as_u64(), resolved(&schema["items"])) {
            (_, items) if items.get("properties").is_some() => vec!["array of tables"],
            (Some(2), _) => vec!["[2]", "array of two"],
            (Some(3), items) if items["minItems"] == 3 => vec!["[3][3]"],
            (Some(3), items) if is_number(items) => vec!["direction", "[3] of numbers"],
            (Some(3), _) => vec!["[3]"],
            (Some(4), _) => vec!["[4]"],
            _ => Vec::new(),
        },
        Some("object") => vec!["table", "rotation"],
        Some("number") => vec!["number"],
        _ if is_number(schema) => vec!["number"],
        Some("string") => vec!["string"],
        _ if !schema["enum"].is_null() => vec!["string", "`\""],
        _ => Vec::new(),
    }
}

/// Returns true for a plain number, or a formula in its place.
fn is_number(schema: &Value) -> bool {
    schema["type"] == "number"
        || schema["type"] == json!(["number", "string"]) && schema["description"].is_null()
}

#[test]
fn the_book_has_the_type_of_every_key_and_whether_it_is_required() {
    let (places, mut wrong) = (places(), Vec::new());
    let own = [("### Mesh", "body.part"), ("### Molecule", "body.part"), ("### Tensor", "body.part")];
    let pages = PAGE.iter().flat_map(|(heading, paths)| paths.iter().map(move |path| (*heading, *path)));
    for (heading, path) in pages.chain(own).filter(|(heading, _)| *heading != "### Shapes") {
        for row in rows(section(page(), heading)) {
            for key in names(row[0]) {
                let there = places.iter().filter(|place| place.path == path);
                let there = there.filter(|place| {
                    let title = place.title.to_lowercase();
                    path != "body.part" || title.contains(&heading["### ".len()..].to_lowercase())
                });
                let (mut needing, mut forms) = (0, 0);
                for place in there {
                    let Some((_, value)) = place.keys.iter().find(|(other, _)| other == key) else {
                        continue;
                    };
                    let words = words(value);
                    if !words.is_empty() && !words.iter().any(|word| row[1].contains(word)) {
                        wrong.push(format!("{heading}: `{key}` is {words:?}, not {}", row[1]));
                    }
                    forms += 1;
                    needing += usize::from(place.required.contains(key));
                }
                // If some forms require the key, the cell states which.
                let is_one = forms > 0 && (needing == 0 || needing == forms);
                let is_told = row.len() > 3 && !row[2].starts_with("required with");
                if is_one && is_told && (row[2] == "required") != (needing > 0) {
                    wrong.push(format!(
                        "{heading}: the default of `{key}` is {:?}, and the reader differs",
                        row[2]
                    ));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn the_book_has_every_shape_with_its_keys() {
    let (places, mut wrong) = (places(), Vec::new());
    let (common, substance) = (in_book("## Parts"), in_book("### Substance"));
    let materials =
        substance.iter().filter(|name| polhode::body::Material::ALL.iter().any(|m| m.name == **name));
    let substance: BTreeSet<String> = substance.difference(&materials.cloned().collect()).cloned().collect();
    let table = rows(section(page(), "### Shapes"));
    let parts: Vec<_> = places.iter().filter(|place| place.path == "body.part").collect();
    let of_title = |place: &&&Place| place.title.split('"').nth(1).unwrap().to_owned();
    let shapes = parts.iter().map(|place| of_title(&place)).collect();
    compare(
        &table.iter().flat_map(|row| names(row[0])).map(str::to_owned).collect(),
        &shapes,
        "### Shapes",
        &mut wrong,
    );
    for place in &parts {
        let shape = of_title(&place);
        let Some(row) = table.iter().find(|row| names(row[0]).eq([shape.as_str()])) else { continue };
        let own: BTreeSet<String> = names(row[1]).map(str::to_owned).collect();
        let given = matches!(shape.as_str(), "molecule" | "particles" | "tensor");
        let mut book = &own | &common;
        book.extend(substance.iter().filter(|key| !given && *key != "thickness").cloned());
        compare(&book, &place.keys.iter().map(|(key, _)| key.clone()).collect(), &shape, &mut wrong);
        // Keys with a table of their own.
        match shape.as_str() {
            "mesh" => compare(&in_book("### Mesh"), &own, &shape, &mut wrong),
            "molecule" => compare(&in_book("### Molecule"), &own, &shape, &mut wrong),
            "tensor" => compare(&in_book("### Tensor"), &own, &shape, &mut wrong),
            _ => {}
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn the_book_has_every_name_that_is_a_value() {
    let mut wrong = Vec::new();
    for place in places().iter().filter(|place| !place.path.starts_with("sweep")) {
        for (key, value) in &place.keys {
            let (path, title) = (place.path.as_str(), place.title.split('"').nth(1).unwrap_or_default());
            let heading = match (path, key.as_str(), title) {
                ("torque" | "body.part", "model" | "shape", _) => continue,
                ("torque", "pulses", _) => "### Pulses".to_owned(),
                ("torque", _, model) => format!("### Torque `{model}`"),
                ("body.part", _, "molecule") => "### Molecule".to_owned(),
                ("body.part", _, _) => "### Tensor".to_owned(),
                ("event", "measure" | "between", _) => "### Measures".to_owned(),
                _ => {
                    let heading = PAGE.iter().find(|(_, paths)| paths.contains(&path));
                    heading.map_or("### Axes", |(heading, _)| heading).to_owned()
                }
            };
            let text = section(page(), &heading);
            for name in choices(value) {
                if !text.contains(&format!("`\"{name}\"`")) && !text.contains(&format!("`{name}`")) {
                    wrong.push(format!("{heading}: {key} = \"{name}\""));
                }
            }
        }
    }
    let measures = places().into_iter().filter(|place| place.path == "event").flat_map(|place| place.keys);
    let measures =
        measures.filter(|(key, _)| key == "measure").flat_map(|(_, value)| choices(value)).collect();
    compare(&in_book("### Measures"), &measures, "### Measures", &mut wrong);
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Returns the names that a value, or an element of it, may have.
fn choices(schema: &'static Value) -> Vec<String> {
    let own = schema["enum"].as_array().into_iter().flatten().map(|name| name.as_str().unwrap().to_owned());
    let forms = ["anyOf", "oneOf"].into_iter().filter_map(|word| schema[word].as_array()).flatten();
    own.chain(forms.chain(schema.get("items")).flat_map(choices)).collect()
}

#[test]
fn the_page_of_sweeps_has_every_key() {
    let page = fs::read_to_string(Path::new(&root()).join("book/sweep.md")).unwrap();
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let words: BTreeSet<&str> = page.split(|c| !is_word(c)).collect();
    let sweep =
        places().into_iter().filter(|place| place.path.starts_with("sweep")).flat_map(|place| place.keys);
    let named = sweep.flat_map(|(key, value)| choices(value).into_iter().chain([key]));
    let lacks: BTreeSet<String> =
        named.filter(|name| name.split(' ').any(|word| !words.contains(word))).collect();
    assert!(lacks.is_empty(), "{lacks:?}");
}
