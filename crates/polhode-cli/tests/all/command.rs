//! The command from the user's side: its output, files and failures.

use std::fs;

use serde_json::Value;

use crate::common::{Scratch, example, json, number, numbers, refused, stdout};

const BRICK: &str = r#"
title = "A brick"
[[body.part]]
shape = "box"
size = ["200 mm", "100 mm", "60 mm"]
density = "1800 kg/m^3"
[start]
spin = { body = [0.3, 2.0, 0.1] }
[run]
duration = "3 s"
samples = 31
"#;

/// A torque for which the motion has no closed form.
const PUSH: &str = r#"
[[torque]]
model = "constant"
axes = "body"
torque = ["1 mN m", "0 N m", "0 N m"]
"#;

#[test]
fn simulate_writes_a_folder_whose_table_is_the_motion() {
    let scratch = Scratch::new("simulate");
    scratch.write("brick.toml", BRICK);
    let text = stdout(&scratch.run(&[
        "simulate",
        "brick.toml",
        "--table",
        "csv",
        "--table",
        "parquet",
        "--table",
        "csv",
    ]));
    assert!(text.contains("A brick") && text.contains("wrote brick/: summary.json"), "{text}");
    assert_eq!(scratch.entries(), ["brick", "brick.toml"]);

    let summary: Value =
        serde_json::from_str(&fs::read_to_string(scratch.0.join("brick/summary.json")).unwrap()).unwrap();
    assert!((number(&summary["mass"]) - 2.16).abs() < 1e-15);
    let table = fs::read_to_string(scratch.0.join("brick/trajectory.csv")).unwrap();
    let mut lines = table.lines();
    let header: Vec<_> = lines.next().unwrap().split(',').collect();
    assert_eq!(&header[..5], ["time_s", "attitude_w", "attitude_x", "attitude_y", "attitude_z"]);
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|c| c.parse().unwrap()).collect()).collect();
    assert_eq!(rows.len(), 31);
    // Attitude and ω of the last row give the angular momentum of the first.
    let column = |name: &str| header.iter().position(|h| *h == name).unwrap();
    let (first, last) = (&rows[0], &rows[30]);
    assert_eq!(last[column("time_s")], 3.0);
    for axis in ["x", "y", "z"] {
        let k = column(&format!("momentum_space_{axis}_kg_m2_s"));
        assert!((first[k] - last[k]).abs() < 1e-14);
    }
    let moved = (first[column("omega_body_x_rad_s")] - last[column("omega_body_x_rad_s")]).abs();
    assert!(moved > 0.1, "the brick does not tumble");
    assert!(number(&summary["drift"]["momentum"]) < 1e-11);
    assert!(fs::metadata(scratch.0.join("brick/trajectory.parquet")).unwrap().len() > 1000);
}

#[test]
fn an_old_folder_is_kept_unless_forced() {
    let scratch = Scratch::new("force");
    scratch.write("brick.toml", BRICK);
    stdout(&scratch.run(&["simulate", "brick.toml"]));
    let before = fs::read(scratch.0.join("brick/summary.json")).unwrap();
    scratch.write("other.toml", BRICK);
    let text = refused(&scratch.run(&["simulate", "other.toml", "-o", "brick"]), 2);
    assert!(text.contains("brick already exists") && text.contains("--force"), "{text}");
    assert_eq!(fs::read(scratch.0.join("brick/summary.json")).unwrap(), before);
    fs::remove_file(scratch.0.join("other.toml")).unwrap();

    // Results and plots of the same scenario are replaced, also after changes to its file.
    scratch.write("brick.toml", &BRICK.replace("1800", "900"));
    for _ in 0..2 {
        stdout(&scratch.run(&["simulate", "brick.toml", "--plot", "omega=o.svg", "--plot", "p.png"]));
    }
    let other = scratch.run(&["simulate", "brick.toml", "-o", "again", "--plot", "omega=brick.toml.svg"]);
    stdout(&other);
    fs::write(scratch.0.join("brick.toml.svg"), "<svg xmlns='somebody else'/>").unwrap();
    let text = refused(&scratch.run(&["simulate", "brick.toml", "--plot", "omega=brick.toml.svg"]), 2);
    assert!(text.contains("brick.toml.svg already exists"), "{text}");
    // A scenario name may be the prefix of another one.
    for plot in ["p.png", "omega=o.svg"] {
        stdout(&scratch.run(&["simulate", "brick.toml", "-o", "again", "--plot", plot]));
        scratch.write("brick.tom", BRICK);
        let text = refused(&scratch.run(&["simulate", "brick.tom", "-o", "third", "--plot", plot]), 2);
        assert!(text.contains("already exists"), "{text}");
        fs::remove_file(scratch.0.join("brick.tom")).unwrap();
    }
    for name in ["o.svg", "p.png", "brick.toml.svg"] {
        fs::remove_file(scratch.0.join(name)).unwrap();
    }
    fs::remove_dir_all(scratch.0.join("again")).unwrap();
    assert_ne!(fs::read(scratch.0.join("brick/summary.json")).unwrap(), before);
    assert_eq!(scratch.entries(), ["brick", "brick.toml"]);

    // `--force` does not remove foreign files.
    fs::create_dir(scratch.0.join("photos")).unwrap();
    fs::write(scratch.0.join("photos/cat.jpg"), "a cat").unwrap();
    let text = refused(&scratch.run(&["simulate", "brick.toml", "-o", "photos", "--force"]), 2);
    assert!(text.contains("not a folder of results"), "{text}");
    assert!(scratch.0.join("photos/cat.jpg").exists());
    // The same holds for foreign files among results, and files similar to results.
    fs::write(scratch.0.join("brick/notes.md"), "mine").unwrap();
    let text = refused(&scratch.run(&["simulate", "brick.toml"]), 2);
    assert!(text.contains("it contains \"notes.md\""), "{text}");
    let text = refused(&scratch.run(&["simulate", "brick.toml", "--force"]), 2);
    assert!(text.contains("notes.md") && scratch.0.join("brick/notes.md").exists(), "{text}");
    fs::create_dir(scratch.0.join("other")).unwrap();
    fs::write(scratch.0.join("other/summary.json"), "{}").unwrap();
    refused(&scratch.run(&["simulate", "brick.toml", "-o", "other", "--force"]), 2);
    for target in ["brick.toml", ".", ".."] {
        refused(&scratch.run(&["simulate", "brick.toml", "-o", target, "--force"]), 2);
    }
    assert!(scratch.0.join("brick.toml").exists());
    stdout(&scratch.run(&["simulate", "brick.toml", "-o", "deep/er/run"]));
    assert!(scratch.0.join("deep/er/run/trajectory.parquet").exists());
}

#[test]
fn bad_input_names_its_place_and_writes_nothing() {
    let scratch = Scratch::new("bad");
    for (change, with, place, says) in [
        ("shape = \"box\"", "shape = \"bx\"", "bad.toml:4:9", "box"),
        ("200 mm", "200 kg", "bad.toml:5:9", "a length"),
        ("1800 kg", "-1800 kg", "bad.toml:6:11", "positive"),
        ("samples = 31", "sampels = 31", "bad.toml:11:1", "samples"),
        ("[0.3, 2.0, 0.1]", "[0.3, nan, 0.1]", "bad.toml:8:", "finite"),
        ("duration = \"3 s\"", "duration = \"-3 s\"", "bad.toml:10:", "positive"),
        ("[start]", "[start]\nattitude = { quaternion = [0, 0, 0, 0] }", "bad.toml:8:", "zero"),
    ] {
        assert!(BRICK.contains(change));
        scratch.write("bad.toml", &BRICK.replace(change, with));
        for command in ["simulate", "inertia", "explain"] {
            let text = refused(&scratch.run(&[command, "bad.toml"]), 2);
            assert!(text.contains(place) && text.contains(says) && text.contains("hint: "), "{text}");
        }
        assert_eq!(scratch.entries(), ["bad.toml"]);
    }
    refused(&scratch.run(&["inertia", "nowhere.toml"]), 2);
    refused(&scratch.run(&["inertia", "."]), 2);
    refused(&scratch.run(&["inertia", "nowhere.step"]), 2);
    scratch.write("bad.step", "ISO-10303-21;\n");
    let text = refused(&scratch.run(&["inertia", "bad.step"]), 2);
    assert!(text.contains(".stl"), "{text}");
    refused(&scratch.run(&["inertia"]), 2);
    refused(&scratch.run(&["wobble"]), 2);
}

#[test]
fn a_scenario_without_a_run_is_not_simulated() {
    let scratch = Scratch::new("norun");
    scratch.write("still.toml", BRICK.split("[run]").next().unwrap());
    let text = refused(&scratch.run(&["simulate", "still.toml"]), 2);
    assert!(text.contains("[run]"), "{text}");
    stdout(&scratch.run(&["explain", "still.toml"]));
}

/// Checks a run that ends too early: exit status 3, and all files marked incomplete.
#[track_caller]
fn incomplete(scratch: &Scratch, name: &str, text: &str, cause: &str) -> Value {
    scratch.write(&format!("{name}.toml"), text);
    let output = scratch.run(&["simulate", &format!("{name}.toml"), "--table", "csv", "--table", "parquet"]);
    let error = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(3), "{error}");
    assert!(error.starts_with("error: ") && error.contains("t = ") && error.contains("hint: "), "{error}");
    assert!(error.contains(cause) && error.contains("marked incomplete"), "{error}");
    let screen = String::from_utf8(output.stdout).unwrap();
    assert!(screen.contains("incomplete, and ends at t = "), "{screen}");
    let read = |file: &str| fs::read(scratch.0.join(name).join(file)).unwrap();
    let summary: Value = serde_json::from_slice(&read("summary.json")).unwrap();
    assert_eq!(summary["complete"], false);
    assert_eq!(summary["end"]["reason"], "failure");
    assert!(summary["end"]["cause"].as_str().unwrap().contains(cause));
    assert!(String::from_utf8_lossy(&read("report.html")).contains("incomplete, and ends at t = "));
    let holds = |text: &str| read("trajectory.parquet").windows(text.len()).any(|w| w == text.as_bytes());
    assert!(holds("polhode.complete") && holds("polhode.cause"));
    let table = String::from_utf8(read("trajectory.csv")).unwrap();
    let last = table.lines().last().unwrap().split(',').next().unwrap().parse::<f64>().unwrap();
    assert_eq!(number(&summary["end"]["time_s"]), last);
    assert!(!table.contains("NaN") && !table.contains("inf"));
    summary
}

#[test]
fn what_cannot_go_on_is_written_as_far_as_it_is_good() {
    let scratch = Scratch::new("reach");
    // 1e300 N·m on a brick: ω overflows f64.
    let torque = "[[torque]]\nmodel = \"constant\"\naxes = \"body\"\ntorque = [1e300, 2e300, -1e300]\n[run]";
    incomplete(&scratch, "burst", &BRICK.replace("[run]", torque), "");
    // Too many steps: refused immediately.
    let long = incomplete(&scratch, "long", &(BRICK.replace("3 s", "1e15 s") + PUSH), "steps");
    assert!(number(&long["end"]["time_s"]) > 0.0);
    // An invalid input stays a usage error, and writes nothing.
    let before = scratch.entries();
    scratch.write("fast.toml", &BRICK.replace("2.0", "1e200"));
    let text = refused(&scratch.run(&["simulate", "fast.toml"]), 2);
    assert!(text.contains("finite"), "{text}");
    assert_eq!(scratch.entries().len(), before.len() + 1);
    // An incomplete motion has no explanation.
    refused(&scratch.run(&["explain", "long.toml"]), 3);
}

#[test]
fn a_motion_that_an_event_stops_is_complete() {
    let scratch = Scratch::new("stop");
    let event =
        "[[event]]\nname = \"slow\"\nmeasure = \"omega_body_y\"\nvalue = \"1.5 rad/s\"\nthen = \"stop\"\n";
    scratch.write("brick.toml", &(BRICK.to_owned() + PUSH + event));
    let text = stdout(&scratch.run(&["simulate", "brick.toml"]));
    assert!(text.contains("by the event \"slow\"") && text.contains("\nEvents\n"), "{text}");
    let summary = fs::read_to_string(scratch.0.join("brick/summary.json")).unwrap();
    let summary: Value = serde_json::from_str(&summary).unwrap();
    assert_eq!(summary["complete"], true);
    assert_eq!(summary["end"]["reason"], "event");
    assert_eq!(summary["end"]["event"], "slow");
    let time = number(&summary["end"]["time_s"]);
    assert!(time > 0.0 && time < 3.0);
    let happened = &summary["events"][0]["happened"][0];
    assert_eq!(number(&happened["time_s"]), time);
    assert!((numbers(&happened["omega_body"])[1] - 1.5).abs() < 1e-14);
    assert_eq!(number(&summary["final"]["time_s"]), time);
    assert_eq!(summary["run"]["method_used"], "taylor");
    let reason = summary["run"]["method_reason"].as_str().unwrap();
    assert!(reason.contains("a torque other than uniform gravity acts on the body"), "{reason}");
}

#[test]
fn inertia_of_a_mesh_follows_its_substance_and_unit() {
    let scratch = Scratch::new("mesh");
    let stl = example("bracket.stl");
    let of = |flags: &[&str]| {
        let mut arguments = vec!["inertia", stl.as_str(), "--json", "--unit", "mm"];
        arguments.extend_from_slice(flags);
        json(&scratch.run(&arguments))
    };
    let dense = of(&["--density", "2.7 g/cm^3", "--about", "10 mm, 0, -5 mm"]);
    let named = of(&["--material", "Aluminium"]);
    assert_eq!(dense["mass"], named["mass"]);
    assert_eq!(dense["inertia"], named["inertia"]);
    let mass = number(&dense["mass"]);
    assert!((number(&dense["volume"]) * 2700.0 / mass - 1.0).abs() < 1e-15);
    let weighed = of(&["--mass", "1 kg"]);
    let ratio = number(&weighed["inertia"]["tensor"][0][0]) / number(&dense["inertia"]["tensor"][0][0]);
    assert!((ratio * mass - 1.0).abs() < 1e-14);
    // Parallel-axis theorem, at a generic point.
    let c: Vec<f64> = (0..3).map(|k| number(&dense["center_of_mass"][k])).collect();
    let a = [c[0] - 0.01, c[1], c[2] + 0.005];
    for i in 0..3 {
        for j in 0..3 {
            let square: f64 = a.iter().map(|x| x * x).sum();
            let steiner = mass * (if i == j { square } else { 0.0 } - a[i] * a[j]);
            let want = number(&dense["inertia"]["tensor"][i][j]) + steiner;
            let got = number(&dense["inertia_about"]["tensor"][i][j]);
            assert!((got - want).abs() < 1e-14 * mass, "{i}{j}");
        }
    }
    assert_eq!(dense["findings"].as_array().unwrap().len(), 0);
    let assumed = of(&[]);
    assert_eq!(assumed["findings"][0]["code"], "mass.assumed");
    // Usage errors.
    refused(&scratch.run(&["inertia", &stl, "--density", "2700 kg"]), 2);
    refused(&scratch.run(&["inertia", &stl, "--mass", "-1 kg"]), 2);
    refused(&scratch.run(&["inertia", &stl, "--mass", "1 kg", "--material", "steel"]), 2);
    refused(&scratch.run(&["inertia", &stl, "--unit", "kg"]), 2);
    refused(&scratch.run(&["inertia", &stl, "--unit", "3"]), 2);
    refused(&scratch.run(&["inertia", &stl, "--about", "1e200,0,0"]), 2);
    refused(&scratch.run(&["inertia", &stl, "--about", "1,2"]), 2);
    refused(&scratch.run(&["inertia", &stl, "--material", "unobtainium"]), 2);
    let both = json(&scratch.run(&["inertia", &stl, &stl, "--json", "--mass", "1 kg"]));
    assert_eq!(both.as_array().unwrap().len(), 2);
}

#[test]
fn an_open_mesh_is_refused_with_its_place() {
    let scratch = Scratch::new("open");
    let facet = |a: &str, b: &str, c: &str| {
        format!("facet normal 0 0 0\nouter loop\nvertex {a}\nvertex {b}\nvertex {c}\nendloop\nendfacet\n")
    };
    let (o, x, y, z) = ("0 0 0", "2 0 0", "0 3 0", "0 0 1");
    let closed = [facet(o, y, x), facet(o, x, z), facet(o, z, y), facet(x, y, z)];
    scratch.write("closed.stl", &format!("solid t\n{}endsolid t\n", closed.concat()));
    let whole = json(&scratch.run(&["inertia", "closed.stl", "--mass", "6 kg", "--json"]));
    assert_eq!(number(&whole["volume"]), 1.0);
    scratch.write("open.stl", &format!("solid t\n{}endsolid t\n", closed[..3].concat()));
    let text = refused(&scratch.run(&["inertia", "open.stl"]), 2);
    assert!(text.contains("open.stl") && text.contains("3 edges") && text.contains("hint: "), "{text}");
}

#[test]
fn numbers_in_json_are_those_of_the_library() {
    let scratch = Scratch::new("bits");
    scratch.write("brick.toml", BRICK);
    let inertia = json(&scratch.run(&["inertia", "brick.toml", "--json"]));
    let shape = polhode::body::shape::BoxShape::new([0.2, 0.1, 0.06]).unwrap();
    let part = polhode::body::shape::Shape::mass_properties(
        &shape,
        polhode::body::shape::Substance::Density(1800.0),
    )
    .unwrap();
    assert_eq!(number(&inertia["mass"]).to_bits(), part.mass().to_bits());
    for (i, row) in part.inertia().matrix().iter().enumerate() {
        for (j, element) in row.iter().enumerate() {
            assert_eq!(number(&inertia["inertia"]["tensor"][i][j]), *element);
        }
    }
    assert_eq!(inertia["principal"]["symmetry"], "asymmetric");
}

#[test]
fn every_command_explains_itself() {
    let scratch = Scratch::new("help");
    for command in ["inertia", "simulate", "spin", "explain"] {
        let help = stdout(&scratch.run(&[command, "--help"]));
        assert!(help.contains("Examples:") && help.contains("--json"), "{help}");
    }
    let schema = json(&scratch.run(&["schema", "scenario"]));
    assert_eq!(schema["properties"]["run"]["required"], serde_json::json!(["duration"]));
    assert!(refused(&scratch.run(&["schema", "scene"]), 2).contains("scenario"));
    assert!(stdout(&scratch.run(&["completions", "bash"])).contains("simulate"));
    assert!(stdout(&scratch.run(&["man"])).contains(".TH polhode 1"));
    assert!(stdout(&scratch.run(&["man", "spin"])).contains(".TH polhode-spin 1"));
    assert!(refused(&scratch.run(&["man", "spine"]), 2).contains("unknown subcommand \"spine\""));
    assert!(stdout(&scratch.run(&["--version"])).starts_with("polhode 0."));
}

#[test]
fn an_error_is_estimated_of_what_is_computed() {
    let scratch = Scratch::new("command-error");
    let text = refused(&scratch.run(&["simulate", &example("notes/11-10-dumbbell.toml"), "--error"]), 2);
    assert!(text.contains("prescribes its motion: there is no error to estimate"), "{text}");
    let summary = json(&scratch.run(&["simulate", &example("heavy-top.toml"), "--error", "--json"]));
    assert_eq!(summary["error"]["effort"], "thorough");
    let attitude = summary["error"]["attitude_rad"].as_f64().unwrap();
    assert!((1e-16..1e-9).contains(&attitude), "{attitude:e}");
    // The estimate for input errors is an upper bound; the much larger error of the steps does not
    // show that inputs matter.
    let chaotic = "[[body.part]]\nshape = 'tensor'\nmass = 3\ncenter_of_mass = [0, 0, 0]\ninertia = [[1, 0, 0], [0, 2, 0], [0, 0, 2.5]]\n[start]\nspin = { body = [0.3, 0.5, 0.9] }
[orbit]\nrate = 0.5\nmu = '4e10 m^3/s^2'\n[[torque]]\nmodel = 'gravity_gradient'
[run]\nduration = 20\nsamples = 12001\nmethod = 'dop853'\ntolerance = 1e-5\n";
    scratch.write("chaotic.toml", chaotic);
    let [cheap, thorough] = [&[][..], &["--error"]].map(|more| {
        stdout(&scratch.run(&[&["simulate", "chaotic.toml", "--no-page", "--force", "-v"], more].concat()))
    });
    assert!(cheap.contains("its effect on the attitude at the end, at most\n"), "{cheap}");
    assert!(thorough.contains("its effect on the attitude at the end\n"), "{thorough}");
    assert!(!cheap.contains("[motion.inputs]"), "{cheap}");
}

#[test]
fn an_energy_below_the_range_of_numbers_is_said() {
    let scratch = Scratch::new("underflow");
    let ball = "[[body.part]]\nshape = 'sphere'\nradius = '20 mm'\nmass = '0.5 kg'\n";
    let push = "[[torque]]\nmodel = 'constant'\naxes = 'body'\ntorque = ['1e-160 N m', 0, '-2e-160 N m']\n";
    let spun = |rate: &str| format!("{ball}[start]\nspin = {{ body = [{rate}, 0, {rate}] }}\n");
    let run = "[run]\nduration = '40 s'\nsamples = 41\n";
    scratch.write("slow.toml", &format!("{}{run}", spun("1e-300")));
    scratch.write("pushed.toml", &format!("{}{push}{run}", spun("0")));
    for (name, code) in [("slow", "start.underflow"), ("pushed", "motion.underflow")] {
        let file = format!("{name}.toml");
        let findings = json(&scratch.run(&["simulate", &file, "--no-page", "--json"]))["findings"].clone();
        let codes: Vec<_> =
            findings.as_array().unwrap().iter().map(|finding| finding["code"].clone()).collect();
        assert_eq!(codes, [code], "{findings}");
    }
    let text = stdout(&scratch.run(&["stability", "slow.toml"]));
    assert!(text.contains("[start.underflow]"), "{text}");
}

#[cfg(target_os = "linux")]
#[test]
fn what_cannot_be_written_is_a_failure() {
    let scratch = Scratch::new("full");
    scratch.write("ball.toml", "[[body.part]]\nshape = 'sphere'\nradius = '20 mm'\nmass = '0.5 kg'\n");
    for arguments in [
        &["--help"][..],
        &["--version"],
        &["help"],
        &["inertia", "--help"],
        &["check", "--help"],
        &["simulate", "--help"],
        &["spin", "-h"],
        &["stability", "--help"],
        &["torque", "--help"],
        &["sweep", "--help"],
        &["explain", "--help"],
        &["completions", "--help"],
        &["man", "--help"],
        &["help", "sweep"],
        &["man"],
        &["completions", "bash"],
        &["schema", "scenario"],
        &["inertia", "ball.toml"],
        &["inertia", "ball.toml", "--json"],
        &["inertia", "ball.toml", "--csv"],
        &["stability", "ball.toml"],
    ] {
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let output = scratch.command(arguments).stdout(full).output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(said.starts_with("error: cannot write standard output"), "{arguments:?}: {said}");
        // A closed pipe is not a failure.
        let mut child = scratch.command(arguments).stdout(std::process::Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        assert_eq!(child.wait().unwrap().code(), Some(0), "{arguments:?}");
    }
}

#[test]
fn a_value_that_begins_with_a_minus_is_told_how_it_is_given() {
    let scratch = Scratch::new("command-minus");
    scratch.write("f.stl", "");
    for (arguments, joined) in [
        (&["inertia", "f.stl", "--density", "-5"][..], "--density=-5"),
        (&["inertia", "f.stl", "--part", "-a=2 kg"], "--part=\"-a=2 kg\""),
        (&["inertia", "f.stl", "--link", "-a"], "--link=-a"),
        (&["sweep", "f.toml", "--threads", "-1"], "--threads=-1"),
    ] {
        let error = refused(&scratch.run(arguments), 2);
        assert!(error.contains(&format!("must be joined to its option: {joined}\n")), "{error}");
        // Following the advice, the value is accepted by the option.
        let obeyed = joined.replace('"', "");
        let error = refused(&scratch.run(&[&arguments[..2], &[obeyed.as_str()]].concat()), 2);
        assert!(!error.contains("unexpected argument"), "{error}");
    }
    // An unknown option is not a file name.
    let error = refused(&scratch.run(&["inertia", "f.stl", "--colour"]), 2);
    assert!(error.contains("unexpected argument '--colour'") && !error.contains("tip:"), "{error}");
    // For a file name the hint of clap is kept.
    let error = refused(&scratch.run(&["inertia", "-5.stl"]), 2);
    assert!(error.contains("use '-- -5"), "{error}");
}

#[test]
fn the_name_of_a_unit_is_asked_for_by_a_name() {
    let scratch = Scratch::new("command-units");
    scratch.write("f.stl", "");
    scratch.write("f.csv", "mass_mm,x_m,y_m,z_m\n1,2,3,4\n");
    for (arguments, hint) in [
        (&["inertia", "f.stl", "--unit", "kg"][..], "write a unit of length, such as mm"),
        (&["inertia", "f.csv", "--mass-unit", "mm"], "write a unit of mass, such as kg"),
        (&["inertia", "f.csv"], "write a unit of mass, such as kg"),
        (&["inertia", "f.stl", "--unit", "millimetre"], "did you mean mm?"),
    ] {
        let error = refused(&scratch.run(arguments), 2);
        assert!(error.contains(hint), "{error}");
    }
}

/// Failure to start a browser is only a note.
#[test]
fn a_page_that_cannot_be_opened_is_written() {
    let scratch = Scratch::new("no-browser");
    scratch.write("brick.toml", BRICK);
    let output = scratch
        .command(&["simulate", "brick.toml", "--open"])
        .env("BROWSER", "no-such-program")
        .output()
        .unwrap();
    stdout(&output);
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("cannot start a browser") && said.contains("brick/report.html"), "{said}");
    assert!(scratch.0.join("brick/report.html").exists());
}
