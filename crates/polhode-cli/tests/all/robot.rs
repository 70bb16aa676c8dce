//! Robot models in `polhode inertia`: subtrees, mimic joints, and the table of all links.

use serde_json::{Value, json};

use crate::common::{Scratch, example, json as parsed, number, numbers, refused, stdout};

fn gripper(scratch: &Scratch, flags: &[&str]) -> Value {
    let urdf = example("robots/gripper.urdf");
    parsed(&scratch.run(&[&["inertia", &urdf, "--json"], flags].concat()))
}

#[test]
fn what_hangs_from_a_link_is_a_body_in_its_frame() {
    let scratch = Scratch::new("robot-subtree");
    let palm = gripper(&scratch, &["--subtree", "palm", "--joint", "left_knuckle=23.5 deg"]);
    let value = 23.5_f64.to_radians();
    let right = -0.7 * value + 0.2;
    assert_eq!(palm["source"]["link"], "palm");
    assert_eq!(palm["source"]["links"], json!(["palm", "left", "right", "tip"]));
    assert_eq!(palm["source"]["massless"], json!(["tcp"]));
    assert_eq!(palm["source"]["joints"], json!({ "left_knuckle": value }));
    assert!((number(&palm["source"]["followers"]["right_knuckle"]) - right).abs() < 1e-16);
    assert!((number(&palm["source"]["followers"]["tip_slide"]) - (0.03 * right + 0.01)).abs() < 1e-16);
    assert!((number(&palm["mass"]) - 0.803).abs() < 1e-15);
    // A length with its unit.
    let lifted = gripper(&scratch, &["--lump", "--joint", "lift=-3 cm"]);
    assert_eq!(lifted["source"]["joints"], json!({ "lift": -0.03 }));
    let text = stdout(&scratch.run(&["inertia", &example("robots/gripper.urdf"), "--subtree", "palm"]));
    for words in
        ["palm and its descendants, 4 links of gripper", "right_knuckle = 0.2 rad (follows left_knuckle)"]
    {
        assert!(text.replace('\n', " ").contains(words), "{text}");
    }
}

#[test]
fn what_joints_cannot_be_told_is_refused_with_a_place() {
    let scratch = Scratch::new("robot-refused");
    let urdf = example("robots/gripper.urdf");
    let run = |flags: &[&str]| refused(&scratch.run(&[&["inertia", &urdf], flags].concat()), 2);
    let text = run(&["--lump", "--joint", "right_knuckle=0.1"]);
    assert!(
        text.contains("\"right_knuckle\" follows \"left_knuckle\"") && text.contains("gripper.urdf:44:"),
        "{text}"
    );
    let text = run(&["--lump", "--joint", "lfit=0.1"]);
    assert!(
        text.contains("did you mean lift? the joints that take a value are lift, turn, left_knuckle"),
        "{text}"
    );
    let text = run(&["--subtree", "plam"]);
    assert!(text.contains("did you mean palm?"), "{text}");
    let text = run(&["--subtree", "palm", "--joint", "lift=0.1"]);
    assert!(text.contains("moves nothing below the link \"palm\""), "{text}");
    let text = run(&["--lump", "--joint", "lift=5 deg"]);
    assert!(text.contains("the joint slides: write a length"), "{text}");
    for pair in [["--link", "base", "--subtree", "base"], ["--lump", "all", "--subtree", "base"]] {
        let text = run(&pair);
        assert!(text.contains(pair[0]) && text.contains("--subtree"), "{text}");
    }
    assert!(run(&["--table", "--link", "base"]).contains("--table"));
    assert!(run(&["--table", "--about", "0,0,0"]).contains("--table"));
    scratch.write("one.csv", "m,x,y,z\n1,0,0,0\n");
    let text = refused(&scratch.run(&["inertia", "one.csv", "--table"]), 2);
    assert!(text.contains("--table is only for a robot model"), "{text}");
}

#[test]
fn a_position_beyond_the_limits_is_said_and_not_refused() {
    let scratch = Scratch::new("robot-limits");
    let report = gripper(&scratch, &["--lump", "--joint", "lift=0.5"]);
    let findings = report["findings"].as_array().unwrap();
    let [limits] = findings.as_slice() else { panic!("{findings:?}") };
    assert_eq!((&limits["code"], &limits["severity"]), (&"position.limits".into(), &"warning".into()));
    let message = limits["message"].as_str().unwrap();
    assert!(message.contains("lift = 0.5 m is outside its limits, from -0.1 to 0.4 m"), "{message}");
    assert_eq!(gripper(&scratch, &["--lump", "--joint", "lift=0.4"])["findings"], json!([]));
}

#[test]
fn a_table_has_every_link_and_the_whole() {
    let scratch = Scratch::new("robot-table");
    let urdf = example("robots/arm.urdf");
    let flags = ["--joint", "elbow=30 deg"];
    let run = |form: &[&str]| scratch.run(&[&["inertia", &urdf, "--table"], &flags[..], form].concat());
    let table = parsed(&run(&["--json"]));
    let links = table["links"].as_array().unwrap();
    let names: Vec<&str> = links.iter().map(|link| link["link"].as_str().unwrap()).collect();
    assert_eq!(names, ["base", "upper_arm", "forearm", "camera", "hand", "tool"]);
    assert_eq!((&links[5]["massless"], &links[5]["mass"]), (&true.into(), &Value::Null));
    // Rows agree with --link, the total with --lump.
    let mut camera = parsed(&scratch.run(&["inertia", &urdf, "--link", "camera", "--json"]));
    for key in ["polhode", "source", "findings"] {
        camera.as_object_mut().unwrap().remove(key);
    }
    for (key, value) in camera.as_object().unwrap() {
        assert_eq!(&links[3][key], value);
    }
    let lump = ["inertia", &urdf, "--lump", "--json"];
    assert_eq!(table["whole"], parsed(&scratch.run(&[&lump[..], &flags].concat())));

    let text = stdout(&run(&[]));
    let row = |name: &str| {
        let line = text.lines().find(|line| line.starts_with(name)).unwrap();
        line.split_whitespace().map(str::to_owned).collect::<Vec<_>>()
    };
    // A box of 3.6 kg, 240 × 200 × 100 mm.
    let base = [
        "base", "3.6", "0", "0", "50", "0.015", "0.02028", "0.02928", "0.015", "0", "0", "0.02028", "0",
        "0.02928", "box",
    ];
    assert_eq!(row("base"), base);
    assert_eq!((row("tool ").len(), row("tool ")[14].as_str()), (15, "massless"));
    assert_eq!(row("whole robot")[2], "6.12");
    assert!(text.contains("elbow = 0.523599 rad and other joints at zero"), "{text}");

    let csv = stdout(&run(&["--csv"]));
    let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!((lines.len(), lines.iter().map(Vec::len).collect::<Vec<_>>()), (8, vec![18; 8]));
    assert_eq!(lines[0][..6], ["file", "row", "name", "frame", "shape", "mass_kg"]);
    assert_eq!(lines[6][1..], [vec!["link", "tool", "tool", "massless"], vec![""; 13]].concat());
    assert_eq!(lines[7][1..4], ["whole", "arm", "base"]);
    let center = numbers(&table["whole"]["center_of_mass"]);
    assert_eq!(lines[7][6].parse::<f64>().unwrap(), center[0]);
    assert_eq!(lines[4][10].parse::<f64>().unwrap(), number(&links[3]["inertia"]["tensor"][0][1]));

    // Failed files are reported among the others.
    scratch.write("torn.urdf", "<robot>");
    let both = scratch.run(&["inertia", &urdf, "torn.urdf", "--table", "--json"]);
    assert_eq!(both.status.code(), Some(2));
    let both: Value = serde_json::from_slice(&both.stdout).unwrap();
    assert_eq!((&both[0]["links"][0]["link"], &both[1]["error"]["line"]), (&"base".into(), &1.into()));
    // An unphysical link has no row, and is named.
    let text = std::fs::read_to_string(&urdf).unwrap().replace("izz=\"0.02928\"", "izz=\"0.9\"");
    scratch.write("bad.urdf", &text);
    let said = refused(&scratch.run(&["inertia", "bad.urdf", "--table"]), 2);
    assert!(said.contains("\"base\" cannot be used"), "{said}");
}

#[test]
fn a_subtree_has_the_armature_of_its_joint() {
    let scratch = Scratch::new("robot-armature");
    scratch.write(
        "armature.xml",
        r#"<mujoco><worldbody><body name="a"><joint name="j" axis="0 0 1" armature="0.05"/>
            <inertial pos="0.2 0 0" mass="1" diaginertia="0.001 0.004 0.004"/></body></worldbody></mujoco>"#,
    );
    let armature =
        parsed(&scratch.run(&["inertia", "armature.xml", "--subtree", "a", "--json"]))["source"]["armatures"]
            [0]
        .clone();
    assert_eq!(armature["joint"], "j");
    assert!((number(&armature["inertia"]) - 0.044).abs() < 1e-15);
    assert!((number(&armature["total"]) - 0.094).abs() < 1e-15);
    let text = stdout(&scratch.run(&["inertia", "armature.xml", "--subtree", "a"])).replace('\n', " ");
    assert!(text.contains("0.094 kg·m²") && text.contains("armature of   0.05 kg·m²"), "{text}");
}

#[test]
fn sdf_with_auto_inertia_has_the_inertia_of_its_collisions() {
    let scratch = Scratch::new("robot-auto");
    scratch.write(
        "auto.sdf",
        r#"<sdf version="1.12"><model name="m"><link name="a"><inertial auto="true"/><collision name="c"><density>2710</density>
            <geometry><box><size>0.2 0.1 0.05</size></box></geometry></collision></link></model></sdf>"#,
    );
    let body = parsed(&scratch.run(&["inertia", "auto.sdf", "--link", "a", "--json"]));
    assert!((number(&body["mass"]) - 2.71).abs() < 1e-14);
    let text = stdout(&scratch.run(&["check", "auto.sdf"]));
    assert!(text.contains("[inertia.computed]") && text.contains("2.71 kg"), "{text}");
}

#[test]
fn invalid_links_are_left_out_and_listed_on_request() {
    let scratch = Scratch::new("robot-skip");
    let urdf = example("robots/bad-arm.urdf");
    let lump = ["inertia", &urdf, "--lump", "all"];
    let error = refused(&scratch.run(&lump), 2);
    assert!(error.contains("upper_arm") && !error.contains("camera"), "{error}");
    let report = parsed(&scratch.run(&[&lump[..], &["--skip-invalid", "--json"]].concat()));
    assert_eq!(report["source"]["links"], json!(["base", "hand"]));
    assert!((number(&report["mass"]) - 3.9).abs() < 1e-15);
    let left_out = report["findings"].as_array().unwrap().iter();
    let left_out: Vec<&str> = left_out
        .filter(|finding| finding["code"] == "lump.left_out")
        .filter_map(|finding| finding["message"].as_str())
        .collect();
    for (message, name) in left_out.iter().zip(["upper_arm", "forearm", "camera"]) {
        assert!(message.contains(name), "{message}");
    }
    assert_eq!(left_out.len(), 3);
    refused(&scratch.run(&["inertia", &urdf, "--link", "base", "--skip-invalid"]), 2);
}
