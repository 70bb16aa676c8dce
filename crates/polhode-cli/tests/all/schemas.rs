//! JSON schemas of requests and reports: output and input of the command conform to them.

use std::path::Path;

use polhode_document::Report as _;
use polhode_judge::suite::CASES;
use polhode_scenario::request::{explain, simulate, spin, stability, torque};
use polhode_source::files::Disk;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use crate::common::{Scratch, entries, example, json, stdout};
use crate::schema::misfit;

/// Requires that objects forbid other keys, that numbers and lists of numbers have descriptions,
/// and that definitions exist.
fn require_strict(root: &Value, schema: &Value, at: &str) {
    if let Some(words) = schema.as_object() {
        let types = schema["type"].to_string();
        let name = schema["$ref"].as_str().unwrap_or("#");
        assert!(root.pointer(&name[1..]).is_some(), "{at}: {name}");
        let is_list = ["vector", "matrix", "quaternion"].iter().any(|list| name.ends_with(list));
        if is_list || types.contains("number") || types.contains("integer") {
            assert!(words.contains_key("description"), "{at}");
        }
        assert!(!types.contains("object") || words.contains_key("additionalProperties"), "{at}");
        words.iter().for_each(|(word, inner)| require_strict(root, inner, &format!("{at}/{word}")));
    }
    let items = schema.as_array().into_iter().flatten().enumerate();
    items.for_each(|(k, inner)| require_strict(root, inner, &format!("{at}/{k}")));
}

#[test]
fn schemas_are_strict() {
    for schema in [
        polhode_budget::REQUEST_SCHEMA,
        polhode_budget::REPORT_SCHEMA,
        polhode_robot::REQUEST_SCHEMA,
        polhode_robot::REPORT_SCHEMA,
        polhode_robot::LINK_CHOICE_SCHEMA,
        polhode_robot::compare::REQUEST_SCHEMA,
        polhode_robot::compare::REPORT_SCHEMA,
        polhode_robot::INERTIALS_REQUEST_SCHEMA,
        polhode_robot::INERTIALS_REPORT_SCHEMA,
        polhode_shape::REQUEST_SCHEMA,
        polhode_shape::REPORT_SCHEMA,
        polhode_identify::REQUEST_SCHEMA,
        polhode_identify::REPORT_SCHEMA,
        polhode_judge::REQUEST_SCHEMA,
        polhode_judge::REPORT_SCHEMA,
        polhode_sweep::REQUEST_SCHEMA,
        polhode_sweep::REPORT_SCHEMA,
        simulate::REQUEST_SCHEMA,
        &simulate::REPORT_SCHEMA,
        spin::REQUEST_SCHEMA,
        &spin::REPORT_SCHEMA,
        stability::REQUEST_SCHEMA,
        &stability::REPORT_SCHEMA,
        torque::REQUEST_SCHEMA,
        &torque::REPORT_SCHEMA,
        explain::REQUEST_SCHEMA,
        &explain::REPORT_SCHEMA,
    ] {
        let schema = serde_json::from_str(schema).unwrap();
        require_strict(&schema, &schema, "");
        assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    }
}

/// Checks the default and a full request: both conform, are read back unchanged, and have the keys
/// of the schema.
fn check_request<R: Default + PartialEq + std::fmt::Debug + Serialize + DeserializeOwned>(
    schema: &str,
    full: &Value,
) {
    let empty = serde_json::to_value(R::default()).unwrap();
    let read = R::deserialize(full).unwrap();
    assert_eq!(&serde_json::to_value(&read).unwrap(), full);
    assert_eq!(R::deserialize(json!({})).unwrap(), R::default());
    for request in [&json!({}), &empty, full] {
        assert_eq!(misfit(schema, request), None);
    }
    let known: Value = serde_json::from_str(schema).unwrap();
    let keys = |value: &Value| value.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    let (mut of_schema, mut of_request) = (keys(&known["properties"]), keys(&empty));
    of_schema.sort();
    of_request.sort();
    assert_eq!(of_schema, of_request);
    let more = json!({ "zzz": 1 });
    assert!(misfit(schema, &more).is_some() && R::deserialize(more).is_err());
}

#[test]
fn requests_fit() {
    let full = json!({
        "files": ["gyro.csv"], "columns": "time ms = t, omega deg/s = gx gy gz", "whole": true, "drag": "linear", "bifilar": false,
        "trifilar": false, "pendulum": true, "mass": "742 g", "distance": "8.2 cm ± 0.5 mm", "length": "1.2 m", "swings": "50",
        "time": "41.2 s ± 0.1 s", "amplitude": "8 deg ± 1 deg", "gravity": "9.81 m/s^2", "body": true,
        "greatest-moment": "0.0166 kg m^2", "strict": true,
    });
    check_request::<polhode_identify::Request>(polhode_identify::REQUEST_SCHEMA, &full);
    let full = json!({
        "files": ["a.toml", "run.csv"], "columns": "time=t, quaternion xyzw=qx qy qz qw", "quaternion": "xyzw",
        "sense": "space-to-body", "omega": "body", "axes": "x,z,-y", "time-origin": "2 s", "step": "2 ms", "root": ["logs"],
        "limit": "0.1 deg", "suite": "suite", "moments": "1, 2, 3", "start-omega": "0.1, 0, 3",
        "against": "old.csv",
    });
    check_request::<polhode_judge::Request>(polhode_judge::REQUEST_SCHEMA, &full);
    let full = json!({
        "a": "old.urdf", "b": "new.xml", "tolerance": "1e-4", "map": "names.toml", "root": ["packages"],
    });
    check_request::<polhode_robot::compare::Request>(polhode_robot::compare::REQUEST_SCHEMA, &full);
    let full = json!({
        "file": "arm.urdf", "root": ["src"], "link": "arm*", "only": "missing", "geometry": "collision",
        "density": null, "mass": "12 kg", "material": null, "part": ["hand=1.2 kg", "hand/grip=steel"],
    });
    check_request::<polhode_robot::inertials::InertialsRequest>(
        polhode_robot::INERTIALS_REQUEST_SCHEMA,
        &full,
    );
    let full = json!({ "plan": "plan.toml", "threads": 4 });
    check_request::<polhode_sweep::Request>(polhode_sweep::REQUEST_SCHEMA, &full);
    let full = json!({ "file": "top.toml", "at": ["0 s, 1 s", "2:3:0.5"], "error": true, "verbose": true });
    check_request::<simulate::Request>(simulate::REQUEST_SCHEMA, &full);
    let full = json!({
        "file": "body.toml", "moments": "1, 2, 3", "inertia": "1, 2, 2.5, 0.1, 0, 0", "omega": "(0, 0, 30) deg/s",
        "attitude": "1, 0, 0, 0", "allow-unphysical": true, "at": ["1 h"], "periods": "7.4 d, 5.4 d", "convention": "long",
        "verbose": true,
    });
    check_request::<spin::Request>(spin::REQUEST_SCHEMA, &full);
    let full =
        json!({ "file": "slew.toml", "at": ["30 s"], "point": ["0.5 kg, 0, 10 cm, 0"], "verbose": true });
    check_request::<torque::Request>(torque::REQUEST_SCHEMA, &full);
    let full = json!({ "file": "top.toml", "verbose": true });
    check_request::<stability::Request>(stability::REQUEST_SCHEMA, &full);
    let full = json!({ "file": "top.toml", "lagrangian": true, "hamiltonian": true });
    check_request::<explain::Request>(explain::REQUEST_SCHEMA, &full);
}

/// Reports of the examples conform, as `json` checks, and modified ones do not.
#[test]
fn reports_of_examples_fit() {
    let scratch = Scratch::new("schemas");
    for name in ["bifilar", "payload", "racket-like", "rod-logs"] {
        let report = json(&scratch.run(&["identify", &example(&format!("identify/{name}.toml")), "--json"]));
        require_refused(polhode_identify::REPORT_SCHEMA, &report);
    }
    let [scenario, mujoco, pybullet, rapier] =
        ["tumbling.toml", "mujoco-rk4.csv", "pybullet-default.csv", "rapier-default.csv"]
            .map(|name| example(&format!("judge/{name}")));
    for runs in [[&scenario, &mujoco], [&scenario, &pybullet], [&scenario, &rapier], [&mujoco, &pybullet]] {
        let output = scratch.run(&["judge", runs[0], runs[1], "--json"]);
        let report: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(misfit(polhode_judge::REPORT_SCHEMA, &report), None);
        require_refused(polhode_judge::REPORT_SCHEMA, &report);
    }
    let output = scratch.run(&["judge", &rapier, "--against", &mujoco, "--moments", "1,2,2.5", "--json"]);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(misfit(polhode_judge::REPORT_SCHEMA, &report), None);
    require_refused(polhode_judge::REPORT_SCHEMA, &report);
    let plan = example("sweeps/sleeping-threshold.toml");
    let report = json(&scratch.run(&["sweep", &plan, "--json"]));
    require_refused(polhode_sweep::REPORT_SCHEMA, &report);
    // The report in memory equals that in a folder.
    let request = polhode_sweep::Request { plan: plan.into(), ..Default::default() };
    assert_eq!(polhode_sweep::run(&request, &Disk).unwrap().to_json(), report);
    // One case has a run, the exact motion; the others state why they have none.
    stdout(&scratch.run(&["judge", "--write-suite", "cases"]));
    let exact = format!("{}.csv", CASES[0].name);
    std::fs::create_dir(scratch.0.join("suite")).unwrap();
    std::fs::copy(scratch.0.join("cases/exact").join(&exact), scratch.0.join("suite").join(&exact)).unwrap();
    let lines: Vec<String> = CASES[1..].iter().map(|case| format!("{}: not here", case.name)).collect();
    scratch.write("suite/not-run.txt", &lines.join("\n"));
    let card = serde_json::from_slice(&scratch.run(&["judge", "--suite", "suite", "--json"]).stdout).unwrap();
    assert_eq!(misfit(polhode_judge::REPORT_SCHEMA, &card), None);
    require_refused(polhode_judge::REPORT_SCHEMA, &card);
}

/// Reports on every example scenario that a command accepts conform, as `json` checks, and modified
/// ones do not.
#[test]
fn reports_on_scenarios_fit() {
    let scratch = Scratch::new("schemas-scenarios");
    let files: Vec<String> = ["", "notes/"]
        .into_iter()
        .flat_map(|folder| {
            let names =
                entries(Path::new(&example(folder))).into_iter().filter(|name| name.ends_with(".toml"));
            names.map(move |name| example(&format!("{folder}{name}")))
        })
        .collect();
    for (command, schema, accepted, flags) in [
        ("simulate", &simulate::REPORT_SCHEMA, 48, &["--at", "0 s"][..]),
        ("spin", &spin::REPORT_SCHEMA, 10, &["--at", "-1 s, 0 s, 1 s"]),
        ("stability", &stability::REPORT_SCHEMA, 36, &[]),
        ("torque", &torque::REPORT_SCHEMA, 4, &["--at", "0 s", "--point", "0.5,1,2,3"]),
        ("explain", &explain::REPORT_SCHEMA, 46, &[]),
    ] {
        let outputs = files.iter().map(|file| scratch.run(&[&[command, file, "--json"], flags].concat()));
        let reports: Vec<Value> =
            outputs.filter(|output| output.status.success()).map(|output| json(&output)).collect();
        assert!(reports.len() >= accepted, "{command}: {}", reports.len());
        for report in &reports {
            assert_eq!(misfit(schema, report), None);
        }
        require_refused(schema, &reports[0]);
    }
    let periods = ["--periods", "7.4 d, 5.38 d", "--convention", "long", "--json"];
    let spins = json(&scratch.run(&[&["spin", "--moments", "3.0836,3.235,1"], &periods[..]].concat()));
    require_refused(&spin::REPORT_SCHEMA, &spins);
    let grounded = json(&scratch.run(&["stability", &example("rattleback.toml"), "--json"]));
    require_refused(&stability::REPORT_SCHEMA, &grounded);
}

/// Checks that a report with a missing or an additional key does not conform.
fn require_refused(schema: &str, report: &Value) {
    for key in report.as_object().unwrap().keys() {
        let mut changed = report.clone();
        changed.as_object_mut().unwrap().remove(key);
        assert!(misfit(schema, &changed).is_some(), "{key}");
    }
    let mut changed = report.clone();
    changed["zzz"] = 1.into();
    assert!(misfit(schema, &changed).is_some());
}

#[test]
fn schemas_are_printed() {
    let scratch = Scratch::new("schemas-printed");
    let printed =
        |arguments: &[&str]| -> Value { serde_json::from_str(&stdout(&scratch.run(arguments))).unwrap() };
    for (name, schemas) in [
        ("inertia", [polhode_shape::REPORT_SCHEMA, polhode_shape::REQUEST_SCHEMA]),
        ("check", [polhode_robot::REPORT_SCHEMA, polhode_robot::REQUEST_SCHEMA]),
        ("compare", [polhode_robot::compare::REPORT_SCHEMA, polhode_robot::compare::REQUEST_SCHEMA]),
        ("sweep", [polhode_sweep::REPORT_SCHEMA, polhode_sweep::REQUEST_SCHEMA]),
        ("judge", [polhode_judge::REPORT_SCHEMA, polhode_judge::REQUEST_SCHEMA]),
        ("identify", [polhode_identify::REPORT_SCHEMA, polhode_identify::REQUEST_SCHEMA]),
        ("budget", [polhode_budget::REPORT_SCHEMA, polhode_budget::REQUEST_SCHEMA]),
        ("simulate", [simulate::REPORT_SCHEMA.as_str(), simulate::REQUEST_SCHEMA]),
        ("spin", [spin::REPORT_SCHEMA.as_str(), spin::REQUEST_SCHEMA]),
        ("stability", [stability::REPORT_SCHEMA.as_str(), stability::REQUEST_SCHEMA]),
        ("torque", [torque::REPORT_SCHEMA.as_str(), torque::REQUEST_SCHEMA]),
        ("explain", [explain::REPORT_SCHEMA.as_str(), explain::REQUEST_SCHEMA]),
    ] {
        let [report, request] = schemas.map(|schema| serde_json::from_str::<Value>(schema).unwrap());
        assert_eq!(printed(&["schema", name]), report);
        assert_eq!(printed(&["schema", name, "--request"]), request);
    }
}
