//! Tables and plans: recognition, reports as the slices make them, and errors with their places.

use polhode_document::Report;
use polhode_document::json::pretty;
use polhode_source::files::Memory;
use serde_json::{Value, json};

use crate::session::Session;

const LIST: &str = "name,mass [g],x [mm],y [mm]\nbattery,270 ± 5,12,-3.5\nradio,94 ± 2,-20,41\n";

/// A swing of a pendulum, counted.
const PLAN: &str = "\
[swing]
mass = \"742 g\"
center = [0, 0, 0]

[[swing.test]]
name = \"about the axis\"
rig = \"compound\"
axis = [1, 0, 0]
pivot = [0, 0, { value = \"8.2 cm\", sd = \"0.5 mm\" }]
counted = { swings = 50, time = \"41.2 s\", sd = \"0.1 s\", amplitude = \"8 deg\", amplitude_sd = \"1 deg\", damping = \"none\" }
";

const SCENARIO: &str = "\
[[body.part]]
shape = \"box\"
size = [0.1, 0.2, 0.3]
mass = 2

[start]
spin = { body = [0, 3, 0] }

[run]
duration = 1
";

/// A log of a rotation about y at 3 rad/s, with these lines before its names.
fn log(head: &str) -> String {
    let row = |k: i32| (0.01 * f64::from(k), 0.015 * f64::from(k));
    let rows: String =
        (0..=100).map(row).map(|(t, half)| format!("{t},{},0,{},0\n", half.cos(), half.sin())).collect();
    format!("{head}time,qw,qx,qy,qz\n{rows}")
}

/// Returns a session with a dropped set, and the answer to the opening of its first file.
fn dropped(files: &[(&str, &str)]) -> (Session, Value) {
    let mut session = Session::default();
    let entry = drop_more(&mut session, 1, files);
    (session, entry)
}

fn drop_more(session: &mut Session, set: u32, files: &[(&str, &str)]) -> Value {
    for (name, text) in files {
        session.files.insert(format!("dropped/{set}/{name}"), text.as_bytes());
    }
    let path = format!("dropped/{set}/{}", files[0].0);
    session.ask(&json!({ "open": { "path": path, "set": format!("dropped/{set}") } })).json
}

fn kinds(session: &Session, id: u32) -> Vec<String> {
    let content = session.ask(&json!({ "document": { "id": id } })).json;
    assert_eq!(content["kind"], "table", "{content}");
    let kinds = content["table"]["kinds"].as_array().unwrap();
    kinds.iter().map(|kind| kind["kind"].as_str().unwrap().to_owned()).collect()
}

fn report(session: &Session, id: u32, kind: &str, mut request: Value) -> Value {
    request["document"] = json!(id);
    request["kind"] = json!(kind);
    session.ask(&json!({ "report": request })).json
}

/// Asserts that an answer has this report, whose title is in the page.
#[track_caller]
fn assert_is(answer: &Value, report: &dyn Report) {
    assert_eq!(answer["error"], Value::Null);
    assert_eq!(answer["report"]["json"], pretty(&report.to_json()) + "\n");
    assert_eq!(answer["report"]["html"], report.to_document().to_html());
    assert_eq!(answer["report"]["has_failed"], report.has_failed());
}

#[test]
fn a_parts_list_has_the_report_of_its_slice() {
    let (session, entry) = dropped(&[("parts.csv", LIST)]);
    assert_eq!((&entry["kind"], &entry["name"]), (&json!("table"), &json!("parts.csv")));
    let answer =
        report(&session, 0, "budget", json!({ "options": { "draws": 100, "about": "1 cm, 0, -2 mm" } }));
    let request = polhode_budget::Request {
        file: "parts.csv".into(),
        draws: Some(100),
        about: serde_json::from_value(json!("1 cm, 0, -2 mm")).unwrap(),
        ..Default::default()
    };
    assert_is(&answer, &polhode_budget::run(&request, &Memory::from([("parts.csv", LIST)])).unwrap());
    let fields = session.ask(&json!({ "document": { "id": 0 } })).json;
    let fields = fields["table"]["kinds"][0]["fields"].as_array().unwrap().clone();
    let form = |key: &str| fields.iter().find(|field| field["key"] == key).unwrap().clone();
    assert_eq!(form("basis")["choices"], json!(["basic", "predicted"]));
    assert_eq!([&form("draws")["form"], &form("about")["form"]], ["integer", "text"]);
}

#[test]
fn a_plan_is_computed_from_its_edited_text() {
    let (session, _) = dropped(&[("pendulum.toml", PLAN)]);
    assert_eq!(kinds(&session, 0), ["identify"]);
    let edited = PLAN.replace("742 g", "801 g");
    for text in [PLAN, &edited] {
        let request = polhode_identify::Request { files: vec!["pendulum.toml".into()], ..Default::default() };
        let expected = polhode_identify::run(&request, &Memory::from([("pendulum.toml", text)])).unwrap();
        assert_is(&report(&session, 0, "identify", json!({ "text": text })), &expected);
    }
    let wrong = PLAN.replace("swings = 50", "swings = -50");
    let answer = report(&session, 0, "identify", json!({ "text": wrong }));
    let error = &answer["error"];
    assert_eq!((&answer["report"], &error["line"]), (&Value::Null, &json!(10)));
    let [from, to] = ["from", "to"].map(|key| usize::try_from(error[key].as_u64().unwrap()).unwrap());
    assert!(wrong[from..to].contains("-50"), "{error}");
    assert!(error["places"].as_str().unwrap().contains("pendulum.toml:10:"), "{error}");
}

#[test]
fn a_plan_reads_the_files_of_its_set_only() {
    let plan = "parts = \"../2/parts.csv\"\n";
    let (mut session, _) = dropped(&[("plan.toml", plan), ("parts.csv", LIST)]);
    drop_more(&mut session, 2, &[("parts.csv", LIST)]);
    assert_eq!(kinds(&session, 0), ["budget"]);
    let answer = report(&session, 0, "budget", json!({ "options": { "draws": 0 } }));
    assert_eq!((&answer["report"], &answer["error"]["line"]), (&Value::Null, &json!(1)), "{answer}");
    let in_set = json!({ "text": "parts = \"parts.csv\"\n", "options": { "draws": 0 } });
    let answer = report(&session, 0, "budget", in_set);
    assert_eq!(answer["error"], Value::Null);
}

#[test]
fn a_run_is_judged_by_the_scenario_that_it_names_or_that_is_open() {
    let named = log("# scenario = \"box.toml\"\n");
    let files = Memory::from([("box.toml", SCENARIO), ("run.csv", &named)]);
    let request = polhode_judge::Request { files: vec!["run.csv".into()], ..Default::default() };
    let expected = polhode_judge::run(&request, &files).unwrap();
    assert!(!expected.has_failed());
    let (session, _) = dropped(&[("run.csv", &named), ("box.toml", SCENARIO)]);
    assert_eq!(kinds(&session, 0), ["judge"]);
    let content = session.ask(&json!({ "document": { "id": 0 } })).json;
    assert_eq!(content["table"]["has_scenario"], true);
    assert_is(&report(&session, 0, "judge", json!({})), &expected);

    // The scenario was dropped before, and its text was edited: it turns faster.
    let (mut session, _) = dropped(&[("box.toml", SCENARIO)]);
    drop_more(&mut session, 2, &[("run.csv", &named)]);
    let content = session.ask(&json!({ "document": { "id": 1 } })).json;
    assert_eq!(content["table"]["has_scenario"], false);
    let judged =
        |text: &str| report(&session, 1, "judge", json!({ "scenario": { "document": 0, "text": text } }));
    let same = judged(SCENARIO);
    assert_eq!((&same["error"], &same["report"]["has_failed"]), (&Value::Null, &json!(false)), "{same}");
    let faster = judged(&SCENARIO.replace("[0, 3, 0]", "[0, 3.5, 0]"));
    assert_eq!((&faster["error"], &faster["report"]["has_failed"]), (&Value::Null, &json!(true)), "{faster}");
    let alone = report(&session, 1, "judge", json!({}));
    assert!(alone["error"]["message"].as_str().unwrap().contains("box.toml"), "{alone}");
}

#[test]
fn a_run_is_judged_by_moments_or_another_log() {
    let columns = "# columns = \"quaternion wxyz body-to-space = qw qx qy qz\"\n";
    let (mut session, _) = dropped(&[("run.csv", &log(columns))]);
    let other = log(columns).replace("0.01,", "0.010,");
    drop_more(&mut session, 2, &[("other.csv", &other)]);
    assert_eq!(kinds(&session, 0), ["identify", "judge"]);
    let moments = json!({ "options": { "moments": "0.03,0.02,0.01", "start-omega": "0,3,0" } });
    let answer = report(&session, 0, "judge", moments);
    assert_eq!(
        (&answer["error"], &answer["report"]["has_failed"]),
        (&Value::Null, &json!(false)),
        "{answer}"
    );
    let content = session.ask(&json!({ "document": { "id": 0 } })).json;
    let fields = content["table"]["kinds"][1]["fields"].as_array().unwrap();
    let against = fields.iter().find(|field| field["key"] == "against").unwrap();
    assert_eq!(against["choices"], json!(["dropped/2/other.csv"]));
    let answer = report(&session, 0, "judge", json!({ "options": { "against": "dropped/2/other.csv" } }));
    assert_eq!(
        (&answer["error"], &answer["report"]["has_failed"]),
        (&Value::Null, &json!(false)),
        "{answer}"
    );
    let wrong = report(&session, 0, "judge", json!({ "options": { "moments": "1,2" } }));
    assert_eq!(wrong["error"]["message"], "moments is \"1,2\": expected 3 numbers (a,b,c), not 2");
}

#[test]
fn a_table_of_several_kinds_is_asked_about() {
    let both = "name,mass_kg,x_m,y_m,z_m\nA,1.5,0.1,-0.2,3\nB,2,0,0.4,-0.7\n";
    let (session, _) = dropped(&[("parts.csv", both)]);
    assert_eq!(kinds(&session, 0), ["budget", "particles"]);
    let body = session.ask(&json!({ "particles": { "id": 0 } })).json;
    assert_eq!((&body["id"], &body["kind"]), (&json!(1), &json!("scenario")));
    let (session, _) = dropped(&[("damaged.csv", "time;gewicht\n1;2\n")]);
    assert_eq!(kinds(&session, 0), ["budget", "identify", "judge", "particles"]);
    let answer = report(&session, 0, "judge", json!({}));
    assert_eq!(answer["error"]["line"], 1, "{answer}");
    let gyro = "t,gyro_x,gyro_y,gyro_z\n0,1,2,3\n";
    assert_eq!(kinds(&dropped(&[("gyro.csv", gyro)]).0, 0), ["identify"]);
    let (session, entry) = dropped(&[("cloud.csv", "mass_kg,x_m,y_m,z_m\n1.5,0.1,-0.2,3\n2,0,0.4,-0.7\n")]);
    assert_eq!(entry["kind"], "scenario");
    assert_eq!(report(&session, 0, "budget", json!({}))["refusal"]["kind"], "bad_request");
}

#[test]
fn a_damaged_table_has_place_value_rule_and_advice() {
    let (session, _) = dropped(&[("parts.csv", &LIST.replace("94 ± 2", "94 mm"))]);
    let answer = report(&session, 0, "budget", json!({}));
    let error = &answer["error"];
    assert_eq!(error["message"], "\"mm\" is a length where a mass belongs");
    assert_eq!([&error["line"], &error["column"]], [3, 7]);
    let places = error["places"].as_str().unwrap();
    assert!(places.contains("--> parts.csv:3:7") && places.contains("3 | radio,94 mm,-20,41"), "{places}");
    assert!(!places.contains("error:") && !places.contains("hint:"), "{places}");
    let late = log("").replacen("\n0.02,", "\n0.002,", 1);
    let (session, _) = dropped(&[("run.csv", &late)]);
    let answer = report(&session, 0, "judge", json!({ "options": { "moments": "1,2,3" } }));
    assert_eq!(answer["error"]["line"], 4, "{answer}");
    assert!(
        answer["error"]["hint"].is_string() || answer["error"]["message"].as_str().unwrap().contains("0.002")
    );
}

#[test]
fn parquet_is_refused_with_advice() {
    let mut session = Session::default();
    let answer = session.open("run.parquet", b"PAR1\0\0PAR1");
    let refusal = &answer["refusal"];
    assert!(refusal["message"].as_str().unwrap().contains("Parquet"), "{answer}");
    assert_eq!(refusal["hint"], "write it as CSV, or use the polhode command");
}

#[test]
fn nobody_waits_for_a_cancelled_report() {
    let (session, _) = dropped(&[("parts.csv", LIST)]);
    let request = json!({ "report": { "document": 0, "kind": "budget", "options": { "draws": 50 } } });
    assert_eq!(session.ask_watched(&request, &|| false).refusal()[0], "ended");
    assert_eq!(session.ask(&request).json["error"], Value::Null);
}
