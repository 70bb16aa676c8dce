//! `polhode budget` as a function of a request and files.

use polhode_budget::{Output, REQUEST_SCHEMA, Request, run};
use polhode_document::Report as _;
use polhode_source::files::{Disk, Memory};
use serde_json::{Value, json};

use crate::common::{Scratch, example, json, stdout};
use crate::schema::misfit;

#[test]
fn requests_of_budget_fit_their_schema() {
    let full = json!({
        "file": "list.csv", "root": ["shared"], "basis": "basic", "about": "0,0,1 m", "along": "1,0,0,0", "draws": 20,
        "seed": 7, "configuration": "stowed", "diff": "before.csv", "strict": true, "output": { "scenario": "a.toml" },
    });
    let read: Request = serde_json::from_value(full.clone()).unwrap();
    assert_eq!(serde_json::to_value(&read).unwrap(), full);
    assert_eq!(read.output, Some(Output::Scenario("a.toml".into())));
    let empty = serde_json::to_value(Request::default()).unwrap();
    for request in [&json!({}), &empty, &full, &json!({ "output": "body" })] {
        assert_eq!(misfit(REQUEST_SCHEMA, request), None);
    }
    let known: Value = serde_json::from_str(REQUEST_SCHEMA).unwrap();
    for key in empty.as_object().unwrap().keys() {
        assert!(known["properties"].get(key).is_some(), "{key}");
    }
    for wrong in [json!({ "zzz": 1 }), json!({ "basis": "heavy" }), json!({ "output": "page" })] {
        assert!(misfit(REQUEST_SCHEMA, &wrong).is_some());
        assert!(serde_json::from_value::<Request>(wrong).is_err());
    }
}

#[test]
fn a_request_answers_what_the_command_prints() {
    let scratch = Scratch::new("budget-request");
    for name in ["budget/cubesat.csv", "budget/sounding-rocket.xlsx"] {
        let file = example(name);
        let request = Request { file: file.clone().into(), draws: Some(100), ..Request::default() };
        let found = run(&request, &Disk).unwrap();
        assert_eq!(found.to_json(), json(&scratch.run(&["budget", &file, "--draws", "100", "--json"])));
    }
    let file = example("budget/sounding-rocket.xlsx");
    let made = |output| {
        let request = Request { file: file.clone().into(), output: Some(output), ..Request::default() };
        run(&request, &Disk).unwrap().files().unwrap()
    };
    for (output, option) in
        [(Output::Parts, "--csv"), (Output::Time, "--csv=time"), (Output::Fill, "--csv=fill")]
    {
        let [(_, table)] = &made(output)[..] else { panic!("{option}") };
        assert_eq!(String::from_utf8_lossy(table), stdout(&scratch.run(&["budget", &file, option])));
    }
    for (output, option, target) in [
        (Output::Workbook("a.xlsx".into()), "--xlsx", "a.xlsx"),
        (Output::Scenario("a.toml".into()), "--scenario", "a.toml"),
    ] {
        stdout(&scratch.run(&["budget", &file, option, target]));
        for (name, bytes) in made(output) {
            assert_eq!(std::fs::read(scratch.0.join(&name)).unwrap(), bytes, "{name:?}");
        }
    }
}

#[test]
fn options_without_effect_are_refused_in_requests() {
    let files = Memory::from([("a.csv", "name,mass [g],x\na,1 ± 0.1,0\n")]);
    let refused = |more: Value| {
        let mut request = json!({ "file": "a.csv" });
        request.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        run(&serde_json::from_value(request).unwrap(), &files).unwrap_err().message()
    };
    for (more, message) in [
        (json!({ "draws": 3 }), "draws is 3: it must be 0, or from 10 to 10000000"),
        (json!({ "diff": "a.csv", "strict": true }), "strict has no effect on diff"),
        (json!({ "about": "0,0,1", "output": "body" }), "about has no effect on output"),
        (json!({ "seed": 1, "output": { "workbook": "a.xlsx" } }), "seed has no effect on output"),
        (json!({ "strict": true, "output": { "scenario": "a.toml" } }), "strict has no effect on a scenario"),
        (json!({ "along": "1,0,0,0", "output": { "plan": "a.toml" } }), "along has no effect on a plan"),
        (json!({ "output": "time" }), "the list has no sequence"),
        (json!({ "configuration": "b" }), "unknown configuration \"b\""),
    ] {
        assert_eq!(refused(more), message);
    }
}
