//! Names from files: every error names its file, and no name can control the terminal.

use std::fs;
use std::process::Output;

use serde_json::Value;

use crate::common::{Scratch, example, stdout};

/// Text that turns a terminal red, overwrites the line and reverses the text direction.
const EVIL: &str = "a\u{1b}[31m\rb\u{9b}2J\u{202e}c\u{200b}";

fn texts(output: &Output) -> [String; 2] {
    [&output.stdout, &output.stderr].map(|bytes| String::from_utf8(bytes.clone()).unwrap())
}

/// Checks that printed text does not control the terminal.
fn tame(output: &Output, what: &[&str]) -> [String; 2] {
    let texts = texts(output);
    for text in &texts {
        let evil = text.chars().find(|c| {
            c.is_control() && !matches!(c, '\n' | '\t')
                || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}')
        });
        assert_eq!(evil, None, "{what:?}: {text:?}");
        assert!(!text.contains("panicked"), "{what:?}: {text}");
    }
    texts
}

const OPEN: &str = "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
const CLOSED: &str = "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

fn robot(name: &str, ixx: &str) -> String {
    let inertia = format!(r#"<inertia ixx="{ixx}" iyy="0.021" izz="0.019" ixy="0.001" ixz="0" iyz="0"/>"#);
    format!(
        r#"<robot name="{name}"><link name="{name}"><inertial><mass value="2.3"/>{inertia}</inertial></link></robot>"#
    )
}

#[test]
fn a_batch_goes_on_after_an_error_and_every_error_names_its_file() {
    let scratch = Scratch::new("batch");
    scratch.write("one.obj", CLOSED);
    scratch.write("open.obj", OPEN);
    scratch.write("what.step", "");
    scratch.write("negative.npy", "x");
    scratch.write("robot.urdf", &robot("arm", "0.02"));
    scratch.write("two.obj", &CLOSED.replace("v 0 0 1", "v 0 0 2"));
    let files =
        ["one.obj", "open.obj", "what.step", "gone.stl", "negative.npy", "robot.urdf", ".", "two.obj"];
    let bad = &files[1..7];
    for form in [&[][..], &["--json"], &["--csv"]] {
        let output = scratch.run(&[&["inertia", "--format=obj"], form, &["one.obj", "two.obj"]].concat());
        stdout(&output);
        let output = scratch.run(&[&["inertia"], form, &files].concat());
        assert_eq!(output.status.code(), Some(2));
        let [out, err] = texts(&output);
        assert_eq!(err.matches("error: ").count(), bad.len(), "{err}");
        let errors: Vec<&str> = err.split("\n\n").collect();
        for (error, file) in errors.iter().zip(bad) {
            assert!(
                error.lines().any(|line| line.contains(" --> ") && line.contains(file)),
                "{file}: {error}"
            );
        }
        match form {
            ["--json"] => {
                let value: Value = serde_json::from_str(&out).unwrap();
                let list = value.as_array().unwrap();
                assert_eq!(list.len(), files.len());
                for (value, file) in list.iter().zip(files) {
                    if bad.contains(&file) {
                        assert_eq!(value["file"], file);
                        assert!(
                            value["error"]["message"].as_str().is_some_and(|message| !message.is_empty())
                        );
                        assert!(value.get("mass").is_none());
                    } else {
                        assert_eq!(value["source"]["path"], file);
                        assert!(value.get("error").is_none());
                    }
                }
            }
            ["--csv"] => assert_eq!(out.lines().count(), 3, "{out}"),
            _ => assert!(out.starts_with("one.obj") && out.contains("\ntwo.obj"), "{out}"),
        }
    }
    // A single file gives an object, not an array; a failed file has no CSV row.
    let output = scratch.run(&["inertia", "--json", "open.obj"]);
    let value: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((output.status.code(), &value["file"]), (Some(2), &Value::from("open.obj")));
    assert!(scratch.run(&["inertia", "--csv", "open.obj"]).stdout.is_empty());
    // A flag for a single file.
    let output = scratch.run(&["inertia", "one.obj", "robot.urdf", "--link", "arm"]);
    let [out, err] = texts(&output);
    assert!(out.starts_with("robot.urdf") && err.contains("--> one.obj") && output.status.code() == Some(2));
}

#[test]
fn a_check_goes_on_too_and_the_worst_counts() {
    let scratch = Scratch::new("check-batch");
    scratch.write("good.urdf", &robot("arm", "0.02"));
    scratch.write("bad.urdf", &robot("arm", "0.2"));
    scratch.write("torn.urdf", "<robot><link");
    fs::create_dir(scratch.0.join("empty")).unwrap();
    let run = |files: &[&str]| scratch.run(&[&["check", "--json"], files].concat());
    assert_eq!(run(&["good.urdf", "bad.urdf"]).status.code(), Some(1));
    for broken in ["torn.urdf", "empty", "gone.urdf"] {
        let output = run(&["bad.urdf", broken, "good.urdf"]);
        assert_eq!(output.status.code(), Some(2), "{broken}");
        let value: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(value.as_array().map(Vec::len), Some(3));
        assert_eq!(value[1]["file"], broken);
        assert!(value[1]["error"]["message"].is_string() && value[2].get("error").is_none());
        assert!(texts(&output)[1].contains(&format!("--> {broken}")), "{broken}");
    }
}

#[test]
fn no_name_of_a_file_steers_the_terminal() {
    let scratch = Scratch::new("evil-files");
    let of = |ending: &str| format!("{EVIL}\n.{ending}");
    let examples = [
        ("toml", "t-handle.toml"),
        ("stl", "bracket.stl"),
        ("xyz", "water.xyz"),
        ("mol", "water.mol"),
        ("pdb", "water.pdb"),
    ];
    for (ending, name) in examples {
        fs::copy(example(name), scratch.0.join(of(ending))).unwrap();
    }
    fs::copy(example("slew.toml"), scratch.0.join("slew.toml")).unwrap();
    fs::copy(example("t-handle.toml"), scratch.0.join("t-handle.toml")).unwrap();
    scratch.write(&of("urdf"), &robot("arm", "0.2"));
    scratch.write(&of("csv"), "mass_kg,x_m,y_m,z_m\n1.5,1,2,3\n2.5,-4,0,2\n");
    scratch.write(&of("obj"), CLOSED);
    scratch.write(&of("step"), "");
    scratch.write(&of("npy"), "no array");
    scratch.write("torn.toml", "[[body.part]\n");
    let files = ["toml", "stl", "xyz", "mol", "pdb", "urdf", "csv", "obj", "step", "npy"].map(of);
    let gone = of("gone.stl");
    for file in files.iter().chain([&gone]) {
        for command in ["inertia", "check", "explain", "simulate", "spin", "torque", "stability", "sweep"] {
            let run = [command, file, "--json"];
            let [out, _] = tame(&scratch.run(&run), &run);
            if command == "inertia" {
                let value: Value = serde_json::from_str(&out).unwrap();
                let path = value["source"]["path"].as_str().or(value["file"].as_str());
                assert_eq!(path, Some(file.as_str()));
            }
            let run = [command, file];
            tame(&scratch.run(&run), &run);
        }
        for flags in
            [&["--link", EVIL][..], &["--part", EVIL], &["--as", "urdf"], &["--csv"], &["--as", "usd"]]
        {
            let run = [&["inertia", file], flags].concat();
            tame(&scratch.run(&run), &run);
        }
    }
    let (folder, figure, table, page) = (of("d"), format!("omega={}", of("svg")), of("csv2"), of("html"));
    let html = format!("--html={page}");
    let fix = of("fixed.urdf");
    for run in [
        &["simulate", "t-handle.toml", "-o", &folder, "--plot", &figure][..],
        &["simulate", "t-handle.toml", "-o", &folder],
        &["simulate", "t-handle.toml", "-o", &folder, "--force", "--plot", &figure],
        &["simulate", "t-handle.toml", "-o", &of("toml"), "--force"],
        &["spin", "t-handle.toml", "-o", &folder],
        &["spin", "t-handle.toml", &html],
        &["spin", "t-handle.toml", &html],
        &["spin", "t-handle.toml", "--at-file", &of("npy")],
        &["torque", "slew.toml", "-o", &table],
        &["torque", "slew.toml", "-o", &table],
        &["check", &of("urdf"), "--fix", &fix],
        &["check", &of("urdf"), "--fix", &fix],
        &["check", &folder],
        &["sweep", "t-handle.toml", "-o", &folder],
        &["inertia", &gone, "--format", EVIL],
        &["inertia", "--material", EVIL, &gone],
        &[EVIL],
        &["spin", "--moments", EVIL, "--omega", EVIL],
        &["inertia", "--field", EVIL, &gone],
    ] {
        tame(&scratch.run(run), run);
    }
}

#[test]
fn no_name_within_a_file_steers_the_terminal() {
    let scratch = Scratch::new("evil-names");
    // TOML has escapes for all of these characters.
    let toml = r"a\u001b[31m\rb\u009b2J\u202ec\u200b";
    let scenario = format!(
        "title = \"{toml}\"\n[[body.part]]\nname = \"{toml}\"\nshape = \"box\"\nsize = [1, 2, 3]\nmass = 7\n\
         [[torque]]\nname = \"{toml}\"\nmodel = \"constant\"\naxes = \"body\"\ntorque = [0, 0, 1]\n\
         [[event]]\nname = \"{toml}\"\nmeasure = \"omega_body_z\"\nvalue = 0.2\n\
         [start]\nspin = {{ body = [0.1, 2, 0.1] }}\n[run]\nduration = 10\nsamples = 11\n"
    );
    scratch.write("good.toml", &scenario);
    scratch.write(
        "free.toml",
        &scenario[..scenario.find("[[torque]]").unwrap()]
            .replace("mass = 7", "mass = 7\n[start]\nspin = { body = [1, 2, 3] }"),
    );
    scratch.write("key.toml", &format!("{scenario}\"{toml}\" = 3\n"));
    scratch.write("table.toml", &format!("{scenario}[\"{toml}\"]\nx = 3\n"));
    scratch.write("shape.toml", &scenario.replace("\"box\"", &format!("\"{toml}\"")));
    scratch.write("material.toml", &scenario.replace("mass = 7", &format!("material = \"{toml}\"")));
    scratch.write("file.toml", &scenario.replace("shape = \"box\"", &format!("file = \"{toml}.stl\"")));
    scratch.write("unit.toml", &scenario.replace("mass = 7", &format!("mass = \"7 {toml}\"")));
    scratch.write("raw.toml", &format!("title = \"{EVIL}\"\n{scenario}"));
    scratch.write(
        "sweep.toml",
        &format!(
            "{scenario}[sweep]\nmembers = 20\nsampling = \"sobol\"\n[[sweep.vary]]\nkey = \"{toml}\"\nuniform = {{ from = 0, to = 1 }}\n"
        ),
    );
    scratch.write(
        "good-sweep.toml",
        &format!(
            "{scenario}[sweep]\nmembers = 20\nsampling = \"sobol\"\n[[sweep.vary]]\nkey = 'body.part[0].mass'\nuniform = {{ from = 1, to = 2 }}\n"
        ),
    );
    // XML has references for some of these characters; the others are literal.
    let xml = "a&#x9b;31m&#13;b&#x202e;c\u{202e}\u{9b}\u{200b}";
    scratch.write("good.urdf", &robot(xml, "0.02"));
    scratch.write("bad.urdf", &robot(xml, "0.2"));
    scratch.write("word.urdf", &robot(xml, xml));
    scratch.write("bad.sdf", &format!("<sdf version=\"1.9\"><model name=\"{xml}\"><link name=\"{xml}\"><inertial><mass>{xml}</mass></inertial></link></model></sdf>"));
    scratch.write("bad.xml", &format!("<mujoco model=\"{xml}\"><worldbody><body name=\"{xml}\"><inertial mass=\"{xml}\" pos=\"0 0 0\" diaginertia=\"1 1 9\"/></body></worldbody></mujoco>"));
    let line = EVIL.replace('\r', "");
    scratch.write("good.obj", &format!("g {line}\n{CLOSED}"));
    scratch.write("open.obj", &format!("g {line}\n{OPEN}"));
    scratch.write("word.obj", &format!("{CLOSED}f {line}\n"));
    scratch.write("word.csv", &format!("mass_kg,x_m,y_m,{line}\n1,2,3,4\n"));
    scratch.write("cell.csv", &format!("mass_kg,x_m,y_m,z_m\n1,2,3,{line}\n"));
    scratch.write("good.xyz", &format!("2\n{line}\nH 0 0 0\nO 0 0 1\n"));
    scratch.write("word.xyz", &format!("2\n{line}\nH 0 0 0\n{line} 0 0 1\n"));
    scratch.write("cad.txt", &format!("Mass properties of {line}\nMass = {line} grams\n"));
    scratch.write("word.ply", &format!("ply\nformat {line}\n"));
    scratch.write("word.stl", &format!("solid {line}\nfacet {line}\n"));
    scratch.write("word.nrrd", &format!("NRRD0004\ntype: {line}\n\n"));
    scratch.write("times.txt", &format!("1 {line}\n"));
    let mut files = crate::common::entries(&scratch.0);
    files.retain(|name| !name.starts_with("times"));
    for file in &files {
        for command in ["inertia", "check", "explain", "simulate", "spin", "torque", "stability", "sweep"] {
            for json in [&[][..], &["--json"]] {
                let run = [&[command, file], json].concat();
                tame(&scratch.run(&run), &run);
            }
        }
        for flags in [
            &["--link", "x"][..],
            &["--lump", "fixed"],
            &["--lump", "all", "--joint", "x=1"],
            &["--part", "x=steel"],
            &["--as", "urdf", "--lump", "all"],
            &["--csv", "--lump", "all"],
            &["--as", "mjcf"],
            &["--as", "usd"],
            &["--as", "jsbsim"],
            &["--as", "rocketpy"],
            &["--as", "basilisk"],
            &["--as", "solidworks"],
        ] {
            let run = [&["inertia", file], flags].concat();
            tame(&scratch.run(&run), &run);
        }
        for run in [["check", file, "--table"], ["explain", file, "--markdown"]] {
            tame(&scratch.run(&run), &run);
        }
    }
    let run = ["spin", "free.toml", "--at-file", "times.txt"];
    tame(&scratch.run(&run), &run);
    // The JSON contains the exact name.
    let value = crate::common::json(&scratch.run(&["inertia", "good.urdf", "--lump", "fixed", "--json"]));
    assert_eq!(value["source"]["link"], "a\u{9b}31m\rb\u{202e}c\u{202e}\u{9b}\u{200b}");
}

#[test]
fn a_cell_of_a_table_is_no_formula() {
    let scratch = Scratch::new("formula");
    for name in ["=1+1.obj", "+a.obj", "-a.obj", "@a.obj"] {
        scratch.write(name, CLOSED);
    }
    let table = stdout(&scratch.run(&["inertia", "--csv", "--", "=1+1.obj", "+a.obj", "-a.obj", "@a.obj"]));
    let names: Vec<&str> = table.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(names, ["'=1+1", "'+a", "'-a", "'@a"]);
}
