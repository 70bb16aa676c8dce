//! `polhode check`, and robot models in `polhode inertia`.

use std::fs;
use std::process::Output;

use serde_json::Value;

use crate::check_gate::confirmed;
use crate::common::{Scratch, example, json, number, numbers, refused, stdout};

/// Model with one link of 1.7 kg and these inertia attributes.
fn robot(inertia: &str) -> String {
    format!(
        "<robot name=\"r\">\n  <link name=\"arm\">\n    <inertial>\n      <mass value=\"1.7\"/>\n      <inertia {inertia}/>\n    \
         </inertial>\n  </link>\n</robot>\n"
    )
}

const GOOD: &str = r#"ixx="0.031" ixy="0.004" ixz="-0.003" iyy="0.042" iyz="0.002" izz="0.053""#;
const IMPOSSIBLE: &str = r#"ixx="0.031" ixy="0.004" ixz="-0.003" iyy="0.042" iyz="0.002" izz="0.53""#;

/// Returns the standard output of a run with this exit status.
fn printed(output: &Output, code: i32) -> String {
    assert_eq!(output.status.code(), Some(code), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn parsed(output: &Output, code: i32) -> Value {
    serde_json::from_str(&printed(output, code)).unwrap()
}

#[test]
fn the_status_says_clean_found_or_unreadable() {
    let scratch = Scratch::new("check-status");
    scratch.write("good.urdf", &robot(GOOD));
    scratch.write("bad.urdf", &robot(IMPOSSIBLE));
    scratch.write("torn.urdf", "<robot name=\"r\"><link name=\"a\"></robot>");
    let good = printed(&scratch.run(&["check", "good.urdf"]), 0);
    assert!(good.contains("IMPOSSIBLE 0   SUSPECT 0") && good.contains("OK 1 of 1"), "{good}");
    let bad = printed(&scratch.run(&["check", "bad.urdf"]), 1);
    assert!(bad.contains("✗ arm   bad.urdf:5:") && bad.contains("[inertia.triangle]"), "{bad}");
    assert!(bad.contains("off-diagonal = -∫xy dm") && bad.contains("rule: "), "{bad}");
    assert!(bad.lines().all(|line| line.chars().count() <= 100), "{bad}");
    let torn = refused(&scratch.run(&["check", "torn.urdf"]), 2);
    assert!(torn.contains("torn.urdf:1:"), "{torn}");
    refused(&scratch.run(&["check", "none.urdf"]), 2);
    refused(&scratch.run(&["check"]), 2);
    // Readable files are reported nevertheless.
    let both = scratch.run(&["check", "torn.urdf", "bad.urdf", "good.urdf"]);
    let text = printed(&both, 2);
    assert!(text.contains("bad.urdf:5:") && text.contains("good.urdf"), "{text}");
    assert!(String::from_utf8_lossy(&both.stderr).contains("torn.urdf:1:"));
    assert!(!both.stdout.is_empty());
}

#[test]
fn notes_count_only_where_one_is_strict() {
    let scratch = Scratch::new("check-strict");
    // An identity tensor without contradicting evidence is a note, not a failure.
    scratch.write(
        "note.urdf",
        &robot(r#"ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1""#).replace("1.7", "20"),
    );
    let text = printed(&scratch.run(&["check", "note.urdf"]), 0);
    assert!(text.contains("· arm") && text.contains("NOTE 1"), "{text}");
    printed(&scratch.run(&["check", "note.urdf", "--strict"]), 1);
}

#[test]
fn json_is_a_contract() {
    let scratch = Scratch::new("check-json");
    let text = robot(IMPOSSIBLE).replace("1.7", "1,7");
    scratch.write("bad.urdf", &text);
    let report = parsed(&scratch.run(&["check", "bad.urdf", "--json"]), 1);
    assert_eq!(report["file"], "bad.urdf");
    assert_eq!(report["format"], "urdf");
    assert_eq!(report["name"], "r");
    assert_eq!((&report["links"], &report["inertials"]), (&1.into(), &1.into()));
    assert_eq!(report["products"], "negative_integral");
    let finding = &report["findings"][0];
    assert_eq!(finding["code"], "number.malformed");
    assert_eq!(finding["severity"], "impossible");
    assert_eq!(finding["link"], "arm");
    assert_eq!((&finding["line"], &finding["column"]), (&4.into(), &20.into()));
    assert!(finding["message"].as_str().unwrap().contains("1,7"));
    assert!(!finding["rule"].as_str().unwrap().is_empty());
    assert!(finding["numbers"].is_object());
    let edit = &finding["repair"]["edits"][0];
    assert_eq!((&edit["line"], &edit["column"]), (&4.into(), &20.into()));
    assert_eq!((&edit["old"], &edit["new"]), (&"1,7".into(), &"1.7".into()));
    assert!(finding["repair"]["description"].is_string());
    let counts = &report["counts"];
    let severities = report["findings"].as_array().unwrap().iter().filter(|f| f["severity"] == "impossible");
    assert_eq!(counts["impossible"], severities.count());
    let sum = |of: &Value| of.as_object().unwrap().values().map(|n| n.as_u64().unwrap()).sum::<u64>();
    assert_eq!(counts["suspect"], 0);
    assert_eq!(sum(counts), report["findings"].as_array().unwrap().len() as u64);
    assert_eq!((&report["verdicts"]["impossible"], &report["verdicts"]["ok"]), (&1.into(), &0.into()));
    assert_eq!(sum(&report["verdicts"]), 1);

    scratch.write("good.urdf", &robot(GOOD));
    scratch.write("torn.urdf", "<robot>");
    let all = parsed(&scratch.run(&["check", "good.urdf", "torn.urdf", "bad.urdf", "--json"]), 2);
    assert_eq!(all.as_array().unwrap().len(), 3);
    assert_eq!(all[0]["findings"].as_array().unwrap().len(), 0);
    assert_eq!((&all[1]["file"], &all[1]["error"]["line"]), (&"torn.urdf".into(), &1.into()));
    assert_eq!(all[2], report);
}

#[test]
fn a_fix_changes_what_it_says_and_no_other_byte() {
    let scratch = Scratch::new("check-fix");
    let text =
        robot(GOOD).replace("1.7", "1,7").replace("  <link", "\t<!-- 1,7 ½ -->  <link").replace('\n', "\r\n");
    let text = format!("\u{feff}{text}");
    scratch.write("bad.urdf", &text);
    let said = printed(&scratch.run(&["check", "bad.urdf", "--fix", "fixed.urdf"]), 0);
    assert!(said.contains("wrote fixed.urdf: 1 value corrected"), "{said}");
    let fixed = fs::read_to_string(scratch.0.join("fixed.urdf")).unwrap();
    assert_eq!(fixed, text.replace("\"1,7\"", "\"1.7\""));
    assert_eq!(fs::read_to_string(scratch.0.join("bad.urdf")).unwrap(), text);
    printed(&scratch.run(&["check", "fixed.urdf"]), 0);

    // Errors without a fix are kept and reported.
    let both = text.replace("izz=\"0.053\"", "izz=\"nan\"");
    scratch.write("both.urdf", &both);
    let report = parsed(&scratch.run(&["check", "both.urdf", "--fix", "half.urdf", "--json"]), 1);
    assert_eq!(report["fix"]["changes"], 1);
    assert_eq!(report["fix"]["out"], "half.urdf");
    assert!(number(&report["fix"]["remaining"]) >= 1.0);
    assert_eq!(fs::read_to_string(scratch.0.join("half.urdf")).unwrap(), both.replace("\"1,7\"", "\"1.7\""));

    // A model without errors is copied.
    scratch.write("good.urdf", &robot(GOOD));
    printed(&scratch.run(&["check", "good.urdf", "--fix", "copy.urdf"]), 0);
    assert_eq!(fs::read_to_string(scratch.0.join("copy.urdf")).unwrap(), robot(GOOD));
}

#[test]
fn a_fix_overwrites_nothing_that_it_should_not() {
    let scratch = Scratch::new("check-fix-refused");
    scratch.write("bad.urdf", &confirmed(&robot(IMPOSSIBLE)));
    scratch.write("good.urdf", &robot(GOOD));
    for out in ["bad.urdf", "./bad.urdf"] {
        let text = refused(&scratch.run(&["check", "bad.urdf", "--fix", out, "--force"]), 2);
        assert!(text.contains("the model itself") && text.contains("hint: "), "{text}");
    }
    let text = refused(&scratch.run(&["check", "bad.urdf", "--fix", "good.urdf"]), 2);
    assert!(text.contains("--force"), "{text}");
    refused(&scratch.run(&["check", "bad.urdf", "--fix", "."]), 2);
    refused(&scratch.run(&["check", "bad.urdf", "good.urdf", "--fix", "out.urdf"]), 2);
    refused(&scratch.run(&["check", "bad.urdf", "--fix", "no/such/out.urdf"]), 2);
    assert_eq!(scratch.entries(), ["bad.urdf", "good.urdf"]);
    assert_eq!(fs::read_to_string(scratch.0.join("good.urdf")).unwrap(), robot(GOOD));
    printed(&scratch.run(&["check", "bad.urdf", "--fix", "good.urdf", "--force"]), 0); // izz 0.53 → 0.053
    assert_eq!(scratch.entries(), ["bad.urdf", "good.urdf"]);
    // A link to the model counts as the model.
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("bad.urdf", scratch.0.join("link.urdf")).unwrap();
        refused(&scratch.run(&["check", "bad.urdf", "--fix", "link.urdf", "--force"]), 2);
        assert_eq!(fs::read_to_string(scratch.0.join("bad.urdf")).unwrap(), confirmed(&robot(IMPOSSIBLE)));
    }
}

#[test]
fn folders_are_searched_for_models() {
    let scratch = Scratch::new("check-folder");
    fs::create_dir_all(scratch.0.join("robots/inner")).unwrap();
    fs::create_dir_all(scratch.0.join("robots/.git")).unwrap();
    scratch.write("robots/b.urdf", &robot(GOOD));
    scratch.write(
        "robots/inner/c.sdf",
        "<?xml version=\"1.0\"?><!-- < --><sdf version=\"1.7\"><model name=\"m\"/></sdf>",
    );
    scratch.write("robots/inner/a.xml", "<mujoco><worldbody/></mujoco>");
    scratch.write("robots/package.xml", "<package><name>robots</name></package>");
    scratch.write("robots/water.sdf", "water\n\n\n  0  0  0  0  0  0  0  0  0  0999 V2000\nM  END\n$$$$\n");
    scratch.write("robots/.git/hidden.urdf", &robot(IMPOSSIBLE));
    #[cfg(unix)]
    std::os::unix::fs::symlink(scratch.0.join("robots"), scratch.0.join("robots/inner/again")).unwrap();
    let reports = parsed(&scratch.run(&["check", "robots", "--json"]), 0);
    let files: Vec<&str> = reports.as_array().unwrap().iter().map(|r| r["file"].as_str().unwrap()).collect();
    assert_eq!(files, ["robots/b.urdf", "robots/inner/a.xml", "robots/inner/c.sdf"]);
    // A file that breaks off before its root, or cannot be opened, is reported; other documents are
    // ignored.
    fs::create_dir_all(scratch.0.join("torn")).unwrap();
    scratch.write("torn/a.world", "<?xml version=\"1.0\"?><!-- never closed <sdf><world/></sdf>");
    scratch.write("torn/b.mjcf", "<?xml version=\"1.0\"?> text <mujoco/>");
    scratch.write("torn/c.xml", "<robot name=\"r\"><group name=\"arm\"/></robot>");
    scratch.write("torn/d.xml", "<OpenSimDocument Version=\"40000\"><AnalyzeTool><model_file>a</model_file></AnalyzeTool></OpenSimDocument>");
    scratch.write("torn/e.xml", "<?xml version=\"1.0\"?><launch><unclosed></launch>");
    scratch.write("torn/f.world", "include \"map.inc\"\n");
    #[cfg(unix)]
    std::os::unix::fs::symlink("nowhere.sdf", scratch.0.join("torn/g.sdf")).unwrap();
    let reports = parsed(&scratch.run(&["check", "torn", "--json"]), 2);
    let files: Vec<&str> = reports.as_array().unwrap().iter().map(|r| r["file"].as_str().unwrap()).collect();
    let expected = ["torn/a.world", "torn/b.mjcf", "torn/g.sdf"];
    assert_eq!(files, expected[..if cfg!(unix) { 3 } else { 2 }]);
    assert!(reports.as_array().unwrap().iter().all(|report| report["error"].is_object()));
    fs::create_dir(scratch.0.join("empty")).unwrap();
    let text = refused(&scratch.run(&["check", "empty"]), 2);
    assert!(text.contains("contains no model"), "{text}");
}

#[test]
fn a_table_has_a_line_for_each_link() {
    let table = stdout(&Scratch::new("check-table").run(&["check", &example("robots/arm.urdf"), "--table"]));
    let head = table.lines().find(|line| line.starts_with("link")).unwrap();
    for column in ["mass/kg", "x/mm", "i1/kg·m²", "a/mm", "kg/m³", "verdict"] {
        assert!(head.contains(column), "{head}");
    }
    let cells = |link: &str| -> Vec<String> {
        let line = table.lines().find(|line| line.starts_with(&format!("{link} "))).unwrap();
        line.split_whitespace().map(str::to_owned).collect()
    };
    // A box of 240 × 200 × 100 mm, 3.6 kg in 4.8 l.
    let base =
        ["base", "3.6", "0", "0", "50", "0.015", "0.02028", "0.02928", "240", "200", "100", "750", "ok"];
    assert_eq!(cells("base"), base);
    assert_eq!(cells("tool").last().unwrap(), "mass"); // "no mass"
}

#[test]
fn the_examples_are_what_they_say() {
    let scratch = Scratch::new("check-examples");
    for good in ["robots/arm.urdf", "robots/arm.sdf", "robots/arm.xml"] {
        printed(&scratch.run(&["check", &example(good)]), 0);
    }
    let bad = parsed(&scratch.run(&["check", &example("robots/bad-arm.urdf"), "--json"]), 1);
    let links: Vec<&str> =
        bad["findings"].as_array().unwrap().iter().map(|f| f["link"].as_str().unwrap()).collect();
    for link in ["base", "upper_arm", "forearm", "camera", "hand"] {
        assert!(links.contains(&link), "{link}: {bad}");
    }
}

#[test]
fn the_three_languages_are_one_robot() {
    let scratch = Scratch::new("check-lump");
    let of = |file: &str| {
        let joints = ["--joint", "elbow=30 deg", "--joint", "shoulder=-0.7", "--joint", "wrist=1.1"];
        json(&scratch.run(&[&["inertia", &example(file), "--lump", "all", "--json"], &joints[..]].concat()))
    };
    let urdf = of("robots/arm.urdf");
    assert!((number(&urdf["mass"]) - 6.12).abs() < 1e-14);
    assert_eq!(urdf["source"]["frame"], "link");
    assert_eq!(urdf["source"]["link"], "base");
    assert_eq!(urdf["source"]["massless"][0], "tool");
    assert!((number(&urdf["source"]["joints"]["elbow"]) - 30_f64.to_radians()).abs() < 1e-15);
    for other in ["robots/arm.sdf", "robots/arm.xml"] {
        let other = of(other);
        assert_eq!(other["source"]["frame"], "model");
        for (a, b) in numbers(&urdf["center_of_mass"]).iter().zip(numbers(&other["center_of_mass"])) {
            assert!((a - b).abs() < 1e-15, "{a} {b}");
        }
        for row in 0..3 {
            let rows = [&urdf, &other].map(|report| numbers(&report["inertia"]["tensor"][row]));
            for (a, b) in rows[0].iter().zip(&rows[1]) {
                assert!((a - b).abs() < 1e-15, "{a} {b}");
            }
        }
    }
    // At zero joint angles the body differs.
    let zero = json(&scratch.run(&["inertia", &example("robots/arm.urdf"), "--lump", "--json"]));
    assert!((number(&zero["center_of_mass"][0]) - number(&urdf["center_of_mass"][0])).abs() > 1e-3);
}

#[test]
fn a_link_and_a_group_are_bodies_of_their_own() {
    let scratch = Scratch::new("check-link");
    let urdf = example("robots/arm.urdf");
    let camera = json(&scratch.run(&["inertia", &urdf, "--link", "camera", "--json"]));
    assert_eq!(camera["source"]["link"], "camera");
    assert_eq!(numbers(&camera["center_of_mass"]), [0.01, 0.0, 0.02]);
    let moments = numbers(&camera["principal"]["moments"]);
    for (a, b) in moments.iter().zip([1.525e-5, 8.725e-5, 9e-5]) {
        assert!((a / b - 1.0).abs() < 1e-14, "{a} {b}");
    }
    // Its inertial frame is rotated, so its tensor has products of inertia.
    assert!(number(&camera["inertia"]["tensor"][0][1]) > 2.9e-5);
    let groups = json(&scratch.run(&["inertia", &urdf, "--lump", "fixed", "--json"]));
    let frames: Vec<&Value> =
        groups.as_array().unwrap().iter().map(|group| &group["source"]["link"]).collect();
    assert_eq!(frames, ["base", "upper_arm", "forearm", "hand"]);
    assert_eq!(groups[2]["source"]["links"], serde_json::json!(["forearm", "camera"]));
    assert!((number(&groups[2]["mass"]) - 1.02).abs() < 1e-15);
    // The output names the links.
    let sdf = stdout(&scratch.run(&["inertia", &urdf, "--lump", "fixed", "--write", "sdf"]));
    assert!(sdf.contains("<link name=\"forearm\">") && sdf.contains("<link name=\"hand\">"), "{sdf}");
    let text = stdout(&scratch.run(&["inertia", &urdf, "--lump", "--joint", "elbow=0.5"]));
    assert!(text.contains("in the frame of base") && text.contains("elbow = 0.5"), "{text}");
}

#[test]
fn robots_are_asked_for_a_link() {
    let scratch = Scratch::new("check-asked");
    let urdf = example("robots/arm.urdf");
    let run = |flags: &[&str]| refused(&scratch.run(&[&["inertia", &urdf], flags].concat()), 2);
    let text = run(&[]);
    assert!(text.contains("--link") && text.contains("forearm"), "{text}");
    let text = run(&["--link", "elbow"]);
    assert!(text.contains("unknown link \"elbow\"") && text.contains("upper_arm"), "{text}");
    let text = run(&["--link", "tool"]);
    assert!(text.contains("has no mass") && text.contains("arm.urdf:47:"), "{text}");
    let text = run(&["--lump", "--joint", "knee=1"]);
    assert!(text.contains("knee") && text.contains("shoulder, elbow, wrist"), "{text}");
    let text = run(&["--lump", "--joint", "elbow=1 m"]);
    assert!(text.contains("elbow") && text.contains("30 deg"), "{text}");
    scratch.write("still.sdf", "<sdf version='1.7'><model name='m'><link name='a'/></model></sdf>");
    let text = refused(&scratch.run(&["inertia", "still.sdf", "--link", "a"]), 2);
    assert!(text.contains("1 kg") && text.contains("add an <inertial> to the link"), "{text}");
    run(&["--lump", "fixed", "--joint", "elbow=1"]);
    run(&["--joint", "elbow=1"]);
    run(&["--link", "base", "--lump"]);
    run(&["--link", "base", "--density", "1000 kg/m^3"]);
    // A molecule in the other format named SDF is still a molecule.
    scratch.write("water.sdf", "water\n\n\n  1  0  0  0  0  0  0  0  0  0999 V2000\n    0.0000    0.0000    0.0000 O   0  0\nM  END\n$$$$\n");
    assert!(number(&json(&scratch.run(&["inertia", "water.sdf", "--json"]))["mass"]) < 1e-25);
    let text = refused(&scratch.run(&["inertia", "water.sdf", "--link", "base"]), 2);
    assert!(text.contains("is only for a robot model"), "{text}");
}

#[test]
fn meshes_are_found_under_the_roots_that_are_given() {
    let scratch = Scratch::new("check-root");
    fs::create_dir_all(scratch.0.join("packages/arm")).unwrap();
    // A tetrahedron of 2, 3 and 1 m with a volume of 1 m³, scaled by 1/10 in the model.
    let obj = "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    scratch.write("packages/arm/arm.obj", obj);
    let mesh = "<visual><geometry><mesh filename=\"package://arm/arm.obj\" scale=\"0.1 0.1 0.1\"/></geometry></visual>";
    // ∫x² = 3 m a² / 80 and ∫xy = −m a b / 80 about the centroid, for legs of 0.2, 0.3 and 0.1 m.
    let own =
        r#"ixx="0.006375" ixy="0.001275" ixz="0.000425" iyy="0.0031875" iyz="0.0006375" izz="0.0082875""#;
    scratch.write("arm.urdf", &robot(own).replace("  </link>", &format!("    {mesh}\n  </link>")));
    let without = parsed(&scratch.run(&["check", "arm.urdf", "--json"]), 0);
    let finding = &without["findings"][0];
    assert_eq!((&finding["code"], &finding["severity"]), (&"geometry.unreadable".into(), &"note".into()));
    assert_eq!((&finding["link"], &finding["line"]), (&"arm".into(), &7.into()));
    assert!(finding["message"].as_str().unwrap().contains("--root"), "{finding}");
    printed(&scratch.run(&["check", "arm.urdf", "--strict"]), 1);
    for root in ["nowhere", "arm.urdf"] {
        let error = refused(&scratch.run(&["check", "arm.urdf", "--root", root]), 2);
        assert!(error.contains("a root must be a folder:"), "{error}");
    }
    let with = ["check", "arm.urdf", "--root", "packages", "--strict"];
    let text = printed(&scratch.run(&with), 0);
    assert!(text.contains("NOTE 0"), "{text}");
    let table = printed(&scratch.run(&[&with[..], &["--table"]].concat()), 0);
    assert!(table.contains(" 1700 "), "{table}"); // 1.7 kg in a litre
}

#[test]
fn what_a_model_says_twice_is_no_body_and_what_was_not_read_is_told() {
    let scratch = Scratch::new("check-twice");
    scratch.write("twice.urdf", &robot(&format!("{GOOD} iyx=\"-0.004\"")));
    for flags in [["--link", "arm"], ["--lump", "all"]] {
        let text = refused(&scratch.run(&[&["inertia", "twice.urdf"], &flags[..]].concat()), 2);
        assert!(text.contains("symmetric") && text.contains("twice.urdf:5:"), "{text}");
    }
    scratch.write("same.urdf", &robot(&format!("{GOOD} iyx=\"0.0040\"")));
    let same = parsed(&scratch.run(&["inertia", "same.urdf", "--link", "arm", "--json"]), 0);
    assert_eq!(same["findings"].as_array().unwrap().len(), 0);
    scratch.write("unit.urdf", &robot(GOOD).replace("\"1.7\"", "\"1.7\" unit=\"g\""));
    let unit = parsed(&scratch.run(&["inertia", "unit.urdf", "--link", "arm", "--json"]), 0);
    assert_eq!(unit["findings"][0]["code"], "read.unknown");
    assert_eq!(unit["findings"][0]["severity"], "warning");
    let link = "<link name='a'><inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>2</iyy><izz>2.5</izz></inertia></inertial></link>";
    scratch.write(
        "part.sdf",
        &format!(
            "<sdf version='1.9'><model name='m'>{link}<include><uri>model://arm</uri></include></model></sdf>"
        ),
    );
    let part = parsed(&scratch.run(&["inertia", "part.sdf", "--lump", "--json"]), 0);
    assert_eq!(part["findings"][0]["code"], "read.include");
}

#[test]
fn a_model_in_utf16_is_named_as_such_whatever_it_ends_in() {
    let scratch = Scratch::new("check-utf16");
    let text = robot("ixx=\"1\" iyy=\"2\" izz=\"2.5\" ixy=\"0.1\" ixz=\"0\" iyz=\"0\"");
    let bytes: Vec<u8> = format!("\u{feff}{text}").encode_utf16().flat_map(u16::to_le_bytes).collect();
    for name in ["a.urdf", "a.xml", "a.sdf"] {
        fs::write(scratch.0.join(name), &bytes).unwrap();
        for command in ["inertia", "check"] {
            let error = refused(&scratch.run(&[command, name]), 2);
            assert!(error.contains("UTF-16"), "{command} {name}: {error}");
        }
    }
}

#[test]
fn a_joint_has_one_value_and_a_link_in_its_own_frame_has_none() {
    let scratch = Scratch::new("check-joint");
    let arm = example("robots/arm.urdf");
    let twice = ["inertia", &arm, "--lump", "--joint", "elbow=1", "--joint", "elbow=2"];
    assert!(refused(&scratch.run(&twice), 2).contains("--joint elbow is given twice"));
    let own = ["inertia", &arm, "--link", "forearm", "--joint", "elbow=1"];
    assert!(refused(&scratch.run(&own), 2).contains("'--joint <NAME=VALUE>'"));
}

#[test]
fn meshes_of_packages_around_and_below_are_found() {
    let scratch = Scratch::new("check-packages");
    let stl = "solid t\nfacet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 2 0 vertex 1 0 0 endloop endfacet\n\
        facet normal 0 0 0 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 0 3 endloop endfacet\n\
        facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 3 vertex 0 2 0 endloop endfacet\n\
        facet normal 0 0 0 outer loop vertex 1 0 0 vertex 0 2 0 vertex 0 0 3 endloop endfacet\nendsolid t\n";
    let model = |package: &str| {
        format!(
            "<robot name=\"r\"><link name=\"a\"><visual><geometry><mesh filename=\"package://{package}/meshes/block.stl\"/></geometry></visual>\
             </link></robot>"
        )
    };
    for folder in ["ws/thing_description/urdf", "ws/thing_description/meshes", "ws/bringup"] {
        fs::create_dir_all(scratch.0.join(folder)).unwrap();
    }
    scratch.write("ws/thing_description/urdf/thing.urdf", &model("thing_description"));
    scratch.write("ws/thing_description/meshes/block.stl", stl);
    scratch.write("ws/bringup/cell.urdf", &model("thing_description"));
    let alone = printed(&scratch.run(&["check", "ws/thing_description/urdf/thing.urdf"]), 0);
    assert!(alone.contains("[read.package]") && !alone.contains("geometry.unreadable"), "{alone}");
    let folder = printed(&scratch.run(&["check", "ws"]), 0);
    assert_eq!(folder.matches("[read.package]").count(), 2, "{folder}");
    assert!(!folder.contains("geometry.unreadable"), "{folder}");
    // A single file has no search folder.
    let outside = printed(&scratch.run(&["check", "ws/bringup/cell.urdf"]), 0);
    assert!(outside.contains("[geometry.unreadable]"), "{outside}");
}

#[test]
fn what_a_program_refuses_fails_for_it() {
    let scratch = Scratch::new("check-for");
    let joint = |name: &str, parent: &str, child: &str| {
        format!(
            "<joint name=\"{name}\" type=\"revolute\"><parent link=\"{parent}\"/><child link=\"{child}\"/><axis xyz=\"1 0 0\"/>\
             <limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>"
        )
    };
    let inertial = |mass: &str, moment: &str| {
        format!(
            "<inertial><mass value=\"{mass}\"/><inertia ixx=\"{moment}\" iyy=\"{moment}\" izz=\"{moment}\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>"
        )
    };
    let model = format!(
        "<robot name=\"a\"><link name=\"w\"/><link name=\"f1\">{}</link><link name=\"b\">{}</link>{}{}</robot>",
        inertial("0", "0"),
        inertial("1", ".1"),
        joint("1", "w", "f1"),
        joint("2", "f1", "b")
    );
    scratch.write("massless.urdf", &model);
    let text = printed(&scratch.run(&["check", "massless.urdf"]), 0);
    assert!(text.contains("[mass.refused]") && text.contains("MuJoCo refuses the model"), "{text}");
    for (program, status) in [("mujoco", 1), ("gazebo", 1), ("isaac", 1), ("drake", 0)] {
        printed(&scratch.run(&["check", "massless.urdf", "--for", program]), status);
    }
    printed(&scratch.run(&["check", "massless.urdf", "--for", "drake", "--for", "mujoco"]), 1);
    refused(&scratch.run(&["check", "massless.urdf", "--for", "bullet"]), 2);
}

#[test]
fn a_unit_of_usd_that_is_not_positive_is_an_error_with_its_line() {
    let scratch = Scratch::new("check-usd-unit");
    scratch.write("zero.usda", "#usda 1.0\n(\n    metersPerUnit = 0\n)\ndef Xform \"r\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\"])\n{\n}\n");
    for command in ["check", "inertia"] {
        let text = refused(&scratch.run(&[command, "zero.usda"]), 2);
        assert!(text.contains("zero.usda:3:") && text.contains("metersPerUnit"), "{text}");
    }
}
