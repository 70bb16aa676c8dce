//! Answers have the numbers of the library, and conform to the schemas.

use polhode::math::{AngularVelocity, Attitude};
use polhode::motion::{FreeMotion, State};
use polhode_document::Report as _;
use polhode_npm::{FREE_MOTION_REPORT_SCHEMA, FREE_MOTION_REQUEST_SCHEMA};
use polhode_scenario::request::simulate;
use polhode_source::files::Memory;
use serde_json::json;

use crate::ask;
use crate::schema::{misfit, require_fits};

const MODEL: &str = r#"<robot name="r"><link name="box"><inertial><mass value="2.3"/>
  <inertia ixx="0.0216667" ixy="0.001" ixz="-0.002" iyy="0.0166667" iyz="0.0004" izz="8.33333"/></inertial>
  <collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision></link></robot>"#;

const SCENARIO: &str = "[[body.part]]\nshape = 'box'\nsize = [0.11, 0.23, 0.31]\nmass = 2.3\n\
    rotate = { axis = [1, 2, -1], angle = 0.4 }\n[start]\nspin = { body = [0.1, 3.1, -0.2] }\n\
    [[torque]]\nmodel = 'drag'\nlaw = 'linear'\ncoefficient = [0.001, 0.002, 0.0015]\n[run]\nduration = 5\nsamples = 7\n";

#[test]
fn free_motion_has_the_states_of_the_core() {
    let (moments, omega) = ([0.83, 1.7, 2.1], [0.13, 2.9, -0.21]);
    let wxyz = [0.1, -0.7, 0.5, 0.5];
    let times = [-2.5, 0.0, 0.75, 12.0, 3.25];
    let request = json!({ "moments": moments, "omega": omega, "attitude": wxyz, "times": times });
    require_fits(FREE_MOTION_REQUEST_SCHEMA, &request);
    let (answer, numbers) = ask(&json!({ "free_motion": request }), &Memory::default());
    let report = &answer["value"];
    require_fits(FREE_MOTION_REPORT_SCHEMA, report);
    let start = State {
        time: 0.0,
        attitude: Attitude::from_quaternion(wxyz).unwrap(),
        omega: AngularVelocity::from_array(omega),
    };
    let motion = FreeMotion::of_moments(moments, start).unwrap();
    assert_eq!((&report["regime"], report["period_s"].as_f64()), (&json!("short_axis"), motion.period()));
    assert_eq!(report["kinetic_energy_j"].as_f64(), Some(motion.kinetic_energy()));
    assert_eq!(numbers[..5], times);
    let mut before = start.attitude.quaternion();
    for (k, time) in times.into_iter().enumerate() {
        let state = motion.at(time);
        assert_eq!(numbers[5 + 3 * k..8 + 3 * k], state.omega.to_array());
        let wxyz = &numbers[20 + 4 * k..24 + 4 * k];
        let found = state.attitude.quaternion();
        assert!(found == wxyz || found.map(|component| -component) == wxyz);
        assert!(before.iter().zip(wxyz).map(|(a, b)| a * b).sum::<f64>() >= 0.0);
        before.copy_from_slice(wxyz);
    }
}

/// A quaternion and its negative are the same attitude: the signs are continuous from row to row.
#[test]
fn signs_of_attitudes_are_continuous() {
    let times: Vec<f64> = (0..400).map(|k| 0.05 * f64::from(k)).collect();
    let request = json!({ "moments": [0.83, 1.7, 2.1], "omega": [0.4, 2.9, -0.21], "times": times });
    let (_, numbers) = ask(&json!({ "free_motion": request }), &Memory::default());
    let rows: Vec<&[f64]> = numbers[4 * times.len()..].chunks(4).collect();
    assert!(rows.iter().any(|row| row[0] < 0.0) && rows.iter().any(|row| row[0] > 0.0));
    for pair in rows.windows(2) {
        assert!(pair[0].iter().zip(pair[1]).map(|(a, b)| a * b).sum::<f64>() > 0.9);
    }
}

#[test]
fn check_answers_with_the_report_of_the_slice() {
    let files = Memory::from([("robots/box.urdf", MODEL), ("notes.txt", "")]);
    let (answer, _) = ask(&json!({ "check": { "files": [""], "fix": true } }), &files);
    let request =
        polhode_robot::Request { files: vec!["".into()], fix: true, ..polhode_robot::Request::default() };
    let checked = polhode_robot::run(&request, &files).unwrap();
    assert_eq!(answer["value"]["reports"], checked.to_json());
    require_fits(polhode_robot::REPORT_SCHEMA, &answer["value"]["reports"]);
    assert_eq!(answer["value"]["reports"][0]["file"], "robots/box.urdf");
    assert_eq!(answer["value"]["failed"], true);
    assert_eq!(answer["value"]["remarks"], json!([]));
}

#[test]
fn inertia_reads_every_kind_of_file() {
    let model = MODEL.replace("8.33333", "0.0283333");
    let files = Memory::from([("box.urdf", model.as_str()), ("box.toml", SCENARIO)]);
    let request = json!({ "inertia": { "files": ["box.urdf", "box.toml"], "lump": "all" } });
    let (refused, _) = ask(&request, &files);
    assert!(refused["failures"][0]["reason"].as_str().unwrap().contains("--lump is only for a robot model"));
    for request in [
        json!({ "files": ["box.urdf"], "lump": "all" }),
        json!({ "files": ["box.toml"], "about": "0.1, 0.2, -0.3" }),
        json!({ "cylinder": "7 cm, 31 cm", "mass": "2.3 kg" }),
    ] {
        let (answer, _) = ask(&json!({ "inertia": request }), &files);
        require_fits(polhode_shape::REPORT_SCHEMA, &answer["value"]);
        assert_eq!(answer["value"][0]["mass"], 2.3);
    }
}

#[test]
fn simulate_answers_with_the_columns_of_the_table() {
    let files = Memory::from([("a.toml", SCENARIO)]);
    let (answer, numbers) = ask(&json!({ "simulate": { "file": "a.toml", "at": ["1.5 s"] } }), &files);
    let value = &answer["value"];
    let request = simulate::Request {
        file: "a.toml".into(),
        at: vec!["1.5 s".parse().unwrap()],
        ..simulate::Request::default()
    };
    let motion = simulate::run(&request, &files).unwrap();
    assert_eq!(value["summary"], motion.to_json());
    assert_eq!(misfit(&simulate::REPORT_SCHEMA, &value["summary"]), None);
    let columns = value["columns"].as_array().unwrap();
    let named = columns.iter().find(|column| column["name"] == "omega_body_y_rad_s").unwrap();
    assert_eq!((&named["unit"], &named["values"]["f64"][1]), (&json!("rad/s"), &json!(7)));
    let at = named["values"]["f64"][0].as_u64().unwrap() as usize;
    let expected: Vec<f64> =
        motion.trajectory.samples().iter().map(|sample| sample.state.omega.to_array()[1]).collect();
    assert_eq!(numbers[at..at + 7], expected);
    assert_eq!(numbers.len(), 7 * columns.len());
}

#[test]
fn explain_writes_each_format() {
    let files = Memory::from([("a.toml", SCENARIO)]);
    for (format, start) in [("markdown", "# "), ("html", "<!"), ("latex", "\\"), ("text", "")] {
        let request = json!({ "explain": { "request": { "file": "a.toml" }, "format": format } });
        let (answer, _) = ask(&request, &files);
        let text = answer["value"].as_str().unwrap();
        assert!(text.starts_with(start) && text.len() > 1000, "{format}: {}", &text[..80]);
    }
}
