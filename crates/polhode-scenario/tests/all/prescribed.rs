//! Prescribed motions and shafts in scenario files: every form, its errors, and tables of motions.

use std::fs;
use std::path::{Path, PathBuf};

use polhode::body::Severity;
use polhode::motion::{Prescribed, Unbalance};
use polhode::prelude::*;
use polhode_scenario::read as scenario;
use polhode_source::FormatError;

use crate::obey;

const BODY: &str = "[[body.part]]\nshape = 'box'\nsize = ['0.3 m', '0.2 m', '0.1 m']\nmass = '4 kg'\n";

fn parse(text: &str) -> Result<Scenario, FormatError> {
    scenario::parse(&format!("{BODY}{text}"), Path::new("test.toml"))
}

#[track_caller]
fn refuses(text: &str, message: &str, hint: &str) {
    let error = parse(text).expect_err(text);
    assert!(error.message().starts_with(message), "{error}");
    let place = error.place().unwrap();
    let given = error.hint().unwrap_or_default();
    assert!(given.starts_with(hint), "hint: {given}");
    let parts = |error: &FormatError| (error.message(), error.place().map(|place| place.span.clone()));
    let whole = format!("{BODY}{text}");
    let read = |text: &str| scenario::parse(text, Path::new("test.toml")).map(drop);
    obey::check(&whole, (&error.message(), &place.span, &given), read, parts);
}

fn at(text: &str, time: f64) -> State {
    parse(text).unwrap().prescribed().unwrap().at(time).unwrap().0
}

#[test]
fn formulas_of_the_time_are_read() {
    let steady = at("[prescribed]\neuler313 = [0.4, 0.9, -1.2]\nrates = [0.7, -0.3, 2.1]", 0.8);
    let angles =
        at("[prescribed]\nangles = ['0.4 + 0.7[rad/s]*t', '0.9 - 0.3[1/s]*t', '-1.2 + 2.1[rad/s]*t']", 0.8);
    assert!(
        steady.attitude.angle_to(angles.attitude) < 1e-15 && (steady.omega - angles.omega).norm() < 1e-15
    );
    let turn = at("[prescribed]\nquaternion = ['3*cos(0.45[rad/s]*t)', 0, '3*sin(0.45[rad/s]*t)', 0]", 1.1);
    assert!((turn.omega - AngularVelocity::new(0.0, 0.9, 0.0)).norm() < 1e-15);
    let run = "[run]\nduration = 3\nsamples = 31\n";
    let start = "[start]\nattitude = { euler313 = [0.4, 0.9, -1.2] }\n";
    let body = at(
        &format!(
            "{run}{start}[prescribed]\nomega = {{ body = ['1[rad/s]*sin(1[rad/s]*t)', '0.5[rad/s]', '1[rad/s^3]*t^2'] }}"
        ),
        2.0,
    );
    assert!((body.omega - AngularVelocity::new(2_f64.sin(), 0.5, 4.0)).norm() < 1e-15);
    let text = format!(
        "{run}{start}[prescribed]\nomega = {{ space = ['1[rad/s]*sin(1[rad/s]*t)', '0.5[rad/s]', '1[rad/s^3]*t^2'] }}"
    );
    let space = at(&text, 2.0);
    assert!((space.omega_space() - AngularVelocity::new(2_f64.sin(), 0.5, 4.0)).norm() < 1e-14);
    let scenario = parse(&text).unwrap();
    let codes: Vec<_> = scenario.findings().iter().map(|finding| finding.code).collect();
    assert_eq!(codes, ["prescribed.integrated"]);
    // The start of the scenario equals that of the prescribed motion.
    assert!(scenario.start().omega.norm() > 0.4);
    let corner = parse("[prescribed]\nangles = ['abs(t - 1[s])/1[s]', 0.5, 0]").unwrap();
    assert_eq!(corner.findings().iter().map(|f| f.code).collect::<Vec<_>>(), ["prescribed.corner"]);
}

#[test]
fn what_is_no_formula_and_no_motion_is_refused() {
    // Angles are plain numbers, but the time has a unit.
    refuses("[prescribed]\nangles = ['sin(t)', 0, 0]", "sin needs a number without unit, not a time", "");
    refuses(
        "[prescribed]\nomega = { body = ['2', 0, 0] }",
        "the value is a plain number, where an angular",
        "",
    );
    refuses("[prescribed]\nangles = ['2*x', 0, 0]", "unknown variable x", "the variables are t");
    refuses(
        "[prescribed]\nangles = [1, 0]",
        "angles must be an array of 3 formulas of t",
        "write angles = [",
    );
    refuses(
        "[prescribed]\nquaternion = [0, 0, 0, 0]",
        "the motion is not finite after t = 0 s",
        "its formulas",
    );
    refuses(
        "[prescribed]\nangles = ['log(t/1[s])', 0, 0]",
        "the motion is not finite after t = 0 s",
        "its formulas",
    );
    let singular = "[run]\nduration = 2\n[prescribed]\nomega = { body = ['1[rad/s]*log(1 - t/1[s])', 0, 0] }";
    refuses(singular, "the motion is not finite", "its formulas");
    refuses("[prescribed]\nomega = {}", "the key body is missing in omega", "write omega = ");
    refuses(
        "[prescribed]\nangles = [1, 0, 0]\nrate = 3",
        "angles and rate are both given: the formulas are the motion",
        "leave one",
    );
    refuses(
        "[prescribed]\naxis = [0, 0, 1]\nrate = 1\nangles = [1, 0, 0]",
        "axis and angles are both given: give the motion in one way only",
        "leave one",
    );
    refuses(
        "[start]\nattitude = { quaternion = [1, 0, 0, 0] }\n[prescribed]\nquaternion = [1, 1, 0, 0]",
        "attitude = { quaternion = [1, 0, 0, 0] } must be left out, since the quaternion of the prescribed motion",
        "leave out attitude",
    );
}

/// Temporary folder of a test with a table in it.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("polhode-prescribed-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir(&folder).unwrap();
        Self(folder)
    }

    fn read(&self, table: &str, text: &str) -> Result<Scenario, FormatError> {
        fs::write(self.0.join("motion.csv"), table).unwrap();
        let text = format!("{BODY}[prescribed]\ntable = 'motion.csv'\n{text}");
        scenario::parse(&text, &self.0.join("scenario.toml"))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn a_trajectory_that_was_written_is_a_motion() {
    let folder = Folder::new("written");
    let known = parse(
        "[prescribed]\nangles = ['0.3 + 0.2*sin(t*1[1/s])', '0.9 + 0.3*cos(1.3[1/s]*t)', '0.7[rad/s]*t']\n[run]\nduration = 4\nsamples = 201",
    )
    .unwrap();
    let motion = known.simulate().unwrap().unwrap();
    let mut bytes = Vec::new();
    polhode_table::output::Table::of(&motion, &Default::default()).write_csv(&mut bytes).unwrap();
    let table = String::from_utf8(bytes).unwrap();
    let start = "[start]\nattitude = { euler313 = [0.3, 1.2, 0] }\n";
    for (columns, start) in [("attitude", ""), ("omega_body", start), ("omega_space", start)] {
        let text = format!("columns = '{columns}'\n{start}[run]\nduration = 4\nsamples = 23");
        let again = folder.read(&table, &text).unwrap();
        let worse = again.findings().iter().filter(|f| f.severity != Severity::Info).count();
        assert_eq!(worse, 0, "{:?}", again.findings());
        for sample in again.simulate().unwrap().unwrap().samples() {
            let (state, _) = known.prescribed().as_ref().unwrap().at(sample.state.time).unwrap();
            assert!(
                state.attitude.angle_to(sample.state.attitude) < 1e-10,
                "{columns} {}",
                sample.state.time
            );
            assert!((state.omega - sample.state.omega).norm() < 1e-9);
        }
    }
    // By default the attitudes determine the motion.
    assert!(matches!(folder.read(&table, "").unwrap().prescribed(), Some(Prescribed::Table(_))));
}

#[test]
fn a_wrong_table_is_shown_where_it_is_wrong() {
    let folder = Folder::new("wrong");
    let head = "time_s,attitude_w,attitude_x,attitude_y,attitude_z\n";
    let rows = |last: &str| format!("# a motion\n{head}0,1,0,0,0\n1,1,0.1,0,0\n\n2,1,0.2,0,0\n{last}\n");
    assert!(folder.read(&rows("3,-1,-0.3,0,0 # the sign does not matter"), "").is_ok());
    for (table, says) in [
        (rows("3,1,0.3,0"), "motion.csv:7:1: the line = 3,1,0.3,0 must be 5 fields long"),
        (rows("3,1,0.3,0,zero"), "motion.csv:7:11: expected a number, found \"zero\""),
        (rows("3,1,inf,0,0"), "motion.csv:7:5: the number inf is not finite"),
        (rows("2,1,0.3,0,0"), "motion.csv:7:1: time_s = 2 must be after the time of the previous row"),
        (rows("3,0,0,0,0"), "motion.csv:7:1: the attitude = 3,0,0,0,0 must be a quaternion that is not zero"),
        ("time_s,x\n0,1\n".to_owned(), "motion.csv: the file has no columns of the motion"),
        ("x,y\n0,1\n".to_owned(), "motion.csv: the file has no column time_s"),
        ("# nothing\n\n".to_owned(), "motion.csv: the file has no lines"),
    ] {
        let error = folder.read(&table, "").unwrap_err();
        assert!(error.to_string().contains(says), "{error}\n{says}");
        assert!(error.origin().is_some() && (error.hint().is_some() || error.place().is_some()));
    }
    for (table, text, says) in [
        (rows("9,-1,0.8,0,0"), "", "the turn from a row to the next"),
        (rows(""), "", "the number of rows = 3 must be at least 4"),
        (
            rows("3,1,0.3,0,0"),
            "[run]\nduration = 4",
            "table = 'motion.csv' must be as long as the run, 0 to 4 s",
        ),
        (rows("3,1,0.3,0,0"), "columns = 'omega_body'", "the file has no columns of the motion"),
        (rows("3,1,0.3,0,0"), "rate = 3", "table and rate are both given: the table is the motion"),
    ] {
        let error = folder.read(&table, text).unwrap_err();
        assert!(error.to_string().contains(says), "{error}");
    }
    let missing = parse("[prescribed]\ntable = 'nowhere.csv'").unwrap_err();
    assert!(missing.message().contains("the file does not exist"));
    assert!(missing.hint().unwrap().starts_with("paths are relative to the scenario"));
}

const SHAFT: &str = "[shaft]\naxis = [0, 3, 4]\nbearings = ['-10 cm', '20 cm']\nrate = '60 rpm'\n";

#[test]
fn a_shaft_is_a_motion_about_its_point() {
    let text = format!(
        "{SHAFT}point = [0, 0, '1 cm']\nacceleration = '2 rad/s^2'\ngravity = [0, 0, '-1 g0']\n\
         balance = {{ planes = [0, '5 cm'], radii = ['3 cm', '4 cm'] }}"
    );
    let scenario = parse(&text).unwrap();
    assert_eq!(scenario.pivot(), Some(Position::new(0.0, 0.0, 0.01)));
    let (state, _) = scenario.prescribed().unwrap().at(0.5).unwrap();
    assert!((state.omega.norm() - (std::f64::consts::TAU + 1.0)).abs() < 1e-14);
    let mounted = scenario.shaft().unwrap();
    assert_eq!(mounted.shaft.bearings(), [-0.1, 0.2]);
    assert_eq!(mounted.gravity, Acceleration::new(0.0, 0.0, -9.806_65));
    assert_eq!(mounted.balance, [[0.0, 0.03], [0.05, 0.04]]);
    let masses = mounted.correction_masses().unwrap();
    let balanced = mounted.shaft.with(&masses).unwrap();
    assert_eq!((masses.len(), balanced.unbalance()), (2, Unbalance::None));
}

#[test]
fn a_shaft_that_cannot_be_is_refused() {
    refuses(
        &SHAFT.replace("'20 cm'", "'-0.1 m'"),
        "the distance between the bearings = 0 must be finite and not zero",
        "",
    );
    refuses(&SHAFT.replace("[0, 3, 4]", "[0, 0, 0]"), "axis = [0, 0, 0] must be a direction", "the z axis");
    refuses(&SHAFT.replace("rate = '60 rpm'\n", ""), "the key rate is missing in [shaft]", "write rate");
    let balance =
        |planes: &str, radii: &str| format!("{SHAFT}balance = {{ planes = {planes}, radii = {radii} }}");
    refuses(
        &balance("[0, 1, 2]", "[1, 1, 1]"),
        "planes = [0, 1, 2] must be one plane, or two",
        "one plane corrects",
    );
    refuses(&balance("[0, 1]", "[1]"), "radii = [1] must be as many as there are planes", "each plane");
    refuses(&balance("[1, 1]", "[1, 1]"), "the distance between the planes = 0 must be", "");
    refuses(&balance("[0, 1]", "[1, 0]"), "radii = 0 must be positive", "a size is positive;");
    refuses(
        &format!("{SHAFT}[prescribed]\naxis = [0, 0, 1]\nrate = 1"),
        "shaft and prescribed are both given: a shaft rotates at its given",
        "leave one",
    );
    refuses(&format!("{SHAFT}[body]\npivot = [0, 0, 0]"), "shaft = [shaft]", "leave out pivot");
    refuses(&format!("{SHAFT}[start]\nspin = {{ body = [0, 0, 1] }}"), "spin = ", "leave out spin");
    refuses(
        &format!("{SHAFT}[start]\nvelocity = [0, 0, 1]"),
        "velocity = [0, 0, 1] must be left out",
        "a shaft only",
    );
    refuses(
        &format!("{SHAFT}[run]\nduration = 1\nmethod = 'exact'"),
        "method = 'exact' must be left out",
        "a prescribed",
    );
}
