//! `polhode inertia --write-inertials`: first the diff, then the new model.

use std::fs;

use serde_json::Value;

use crate::common::{Scratch, example, json, refused, stdout};
use crate::schema::misfit;

/// Two links: a box without an inertial, and a mesh with a wrong one.
const ROBOT: &str = r#"<robot name="r">
  <link name="base">
    <collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision>
  </link>
  <link name="wedge">
    <inertial>
      <mass value="0.5"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2"/>
    </inertial>
    <visual><geometry><mesh filename="wedge.obj"/></geometry></visual>
  </link>
  <joint name="j" type="fixed"><parent link="base"/><child link="wedge"/></joint>
</robot>
"#;

const WEDGE: &str = "v 0 0 0\nv 0.2 0 0\nv 0 0.3 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

fn scratch(name: &str) -> Scratch {
    let scratch = Scratch::new(name);
    scratch.write("r.urdf", ROBOT);
    scratch.write("wedge.obj", WEDGE);
    scratch
}

#[test]
fn the_diff_comes_first() {
    let scratch = scratch("inertials-diff");
    let read = |name: &str| fs::read_to_string(scratch.0.join(name)).unwrap();
    let run = ["inertia", "r.urdf", "--write-inertials", "--part", "base=500 kg/m^3"];
    let diff = stdout(&scratch.run(&run));
    let lines: Vec<&str> = diff.lines().collect();
    assert_eq!(lines[0], "# r.urdf: 2 new inertials for 2 links");
    assert_eq!(lines[1], "# r.urdf:2: base: 3 kg (500 kg/m³), 0.006 m³ of collision: 1 shape; no visual");
    assert_eq!(
        lines[2],
        "# r.urdf:5: wedge: 0.5 kg (kept), 0.001 m³ of visual: 1 shape (4 triangles, closed); no collision"
    );
    assert_eq!(lines[3..5], ["--- a/r.urdf", "+++ b/r.urdf"]);
    assert!(diff.contains("\n+      <mass value=\"3\"/>\n"), "{diff}");
    // Nothing is written without a file.
    assert_eq!(read("r.urdf"), ROBOT);
    let with = [&run[..3], &["new.urdf"], &run[3..]].concat();
    let printed = stdout(&scratch.run(&with));
    assert!(printed.starts_with("# r.urdf: 2 new inertials for 2 links, in new.urdf\n"), "{printed}");
    assert!(printed.ends_with(diff.split_once("---").unwrap().1), "{printed}");
    stdout(&scratch.run(&["check", "new.urdf"]));
    let new = read("new.urdf");
    assert!(
        new.contains("<mass value=\"0.5\"/>")
            && new.contains("    <inertial>\n      <origin xyz=\"0.05 0.075 0.025\" rpy=\"0 0 0\"/>"),
        "{new}"
    );
    // An existing file is replaced with --force only, and the model never.
    assert!(refused(&scratch.run(&with), 2).contains("new.urdf already exists"));
    stdout(&scratch.run(&[&with[..], &["--force"]].concat()));
    let onto = ["inertia", "r.urdf", "--write-inertials", "r.urdf", "--force"];
    assert!(refused(&scratch.run(&onto), 2).contains("would overwrite the model itself"));
    let onto = ["inertia", "r.urdf", "--write-inertials", "wedge.obj", "--force", "--part", "base=oak"];
    assert!(refused(&scratch.run(&onto), 2).contains("would overwrite a mesh of the model"));
    // The new model needs no changes.
    let again = stdout(&scratch.run(&["inertia", "new.urdf", "--write-inertials"]));
    assert!(
        again.starts_with("# new.urdf: 0 new inertials for 2 links; 2 unchanged\n") && !again.contains("---"),
        "{again}"
    );
}

#[test]
fn a_link_that_gets_none_is_an_exit_status() {
    let scratch = scratch("inertials-status");
    let output = scratch.run(&["inertia", "r.urdf", "--write-inertials", "--json"]);
    assert_eq!(output.status.code(), Some(1));
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(misfit(polhode_robot::INERTIALS_REPORT_SCHEMA, &report), None);
    let why = report["links"][0]["why_not"].as_str().unwrap();
    assert!(why.starts_with("it has no mass: give its density or mass by --density"), "{why}");
    assert_eq!((&report["links"][1]["mass_kg"], &report["out"]), (&0.5.into(), &Value::Null));
    assert!(report["diff"].as_str().unwrap().contains("+++ b/r.urdf"));
    // The table has the new model.
    let table = ["inertia", "r.urdf", "--write-inertials", "--material", "steel", "--table"];
    let output = scratch.run(&table);
    let text = stdout(&output);
    assert!(text.lines().any(|line| line.starts_with("base   ") && line.contains("47.1")), "{text}");
    assert!(String::from_utf8_lossy(&output.stderr).starts_with("r.urdf: 2 new inertials"));
    let whole = json(&scratch.run(&[&table[..], &["--json"]].concat()))["whole"]["mass"].as_f64().unwrap();
    assert!((whole / (7850.0 * 0.007) - 1.0).abs() < 1e-12, "{whole}");
}

#[test]
fn only_one_robot_model_is_written() {
    let scratch = scratch("inertials-models");
    let run = |arguments: &[&str]| refused(&scratch.run(&[&["inertia"], arguments].concat()), 2);
    assert!(run(&["wedge.obj", "--write-inertials"]).contains("only for a robot model"));
    assert!(run(&["r.urdf", "r.urdf", "--write-inertials"]).contains("2 files are named"));
    assert!(run(&["r.urdf", "--write-inertials", "--hull"]).contains("--hull"));
    assert!(run(&["nowhere.urdf", "--write-inertials"]).contains("nowhere.urdf"));
    assert!(run(&["r.urdf", "--only", "missing"]).contains("--write-inertials"));
    // A model in each of the languages, all of whose inertials are right.
    for name in ["arm.urdf", "arm.sdf", "arm.xml"] {
        let text =
            stdout(&scratch.run(&["inertia", &example(&format!("robots/{name}")), "--write-inertials"]));
        assert!(text.contains(": 0 new inertials for "), "{text}");
    }
}
