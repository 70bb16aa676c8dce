//! Output files of `polhode check`, and files that are never overwritten.

use std::fs;

use crate::check_gate::{impossible, printed, said, status};
use crate::common::{Scratch, refused};

/// Folder with a model of two files and a mesh, a world with an included model, a configuration and
/// a baseline.
fn whole_model(name: &str) -> Scratch {
    let scratch = Scratch::new(name);
    fs::create_dir_all(scratch.0.join("models/inner")).unwrap();
    scratch.write("robot.urdf", &impossible());
    scratch.write(
        "meshed.urdf",
        &impossible().replace(
            "<inertial>",
            "<visual><geometry><mesh filename=\"tri.obj\"/></geometry></visual>\n    <inertial>",
        ),
    );
    scratch.write("tri.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    scratch.write("top.xml", "<mujoco><worldbody><include file=\"inc.xml\"/></worldbody></mujoco>");
    scratch.write("inc.xml", "<mujocoinclude><body name=\"a\"><inertial pos=\"0 0 0\" mass=\"1,5\" diaginertia=\"1 1 1\"/></body></mujocoinclude>");
    scratch.write(
        "world.sdf",
        "<sdf version=\"1.9\"><world name=\"w\"><include><uri>model://inner</uri></include></world></sdf>",
    );
    scratch.write(
        "models/inner/model.config",
        "<model><name>inner</name><sdf version=\"1.9\">model.sdf</sdf></model>",
    );
    scratch.write(
        "models/inner/model.sdf",
        "<sdf version=\"1.9\"><model name=\"m\"><link name=\"a\"/></model></sdf>",
    );
    scratch.write("polhode.toml", "[check]\n");
    scratch.write("known.json", "{\"polhode_baseline\": 1, \"findings\": []}");
    scratch
}

/// Returns all files below a folder with their contents.
fn contents(folder: &std::path::Path) -> Vec<(std::path::PathBuf, Vec<u8>)> {
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            all.append(&mut contents(&path));
        } else {
            all.push((path.clone(), fs::read(&path).unwrap_or_default()));
        }
    }
    all.sort();
    all
}

#[test]
fn no_output_takes_the_place_of_another_or_of_what_is_read() {
    let scratch = whole_model("gate-outputs");
    #[cfg(unix)]
    std::os::unix::fs::symlink("models", scratch.0.join("linked")).unwrap();
    let before = contents(&scratch.0);
    let cases: &[(&[&str], &str)] = &[
        (
            &["robot.urdf", "--fix", "o.urdf", "--output", "./o.urdf"],
            "--fix and --output would both write ./o.urdf",
        ),
        (
            &["robot.urdf", "--output", "q.txt", "--write-baseline", "models/../q.txt"],
            "--output and --write-baseline",
        ),
        (&["robot.urdf", "--fix", "polhode.toml"], "--fix would overwrite the configuration"),
        (&["robot.urdf", "--config", "polhode.toml", "--output", "./polhode.toml"], "the configuration"),
        (
            &["robot.urdf", "--baseline", "known.json", "--output", "known.json"],
            "--output would overwrite the baseline",
        ),
        (&["top.xml", "--output", "inc.xml"], "--output would overwrite a file that the model includes"),
        (&["top.xml", "robot.urdf", "--write-baseline", "./inc.xml"], "a file that the model includes"),
        (&["meshed.urdf", "--fix", "tri.obj"], "--fix would overwrite a mesh of the model"),
        (
            &["world.sdf", "--root", "models", "--fix", "models/inner/model.sdf"],
            "a file that the model includes",
        ),
        (&["world.sdf", "--root", "models", "--output", "models/inner/model.config"], "the model.config"),
        #[cfg(unix)]
        (
            &["world.sdf", "--root", "models", "--fix", "linked/inner/model.sdf"],
            "a file that the model includes",
        ),
        #[cfg(unix)]
        (&["robot.urdf", "--fix", "linked/o.urdf", "--output", "models/o.urdf"], "--fix and --output"),
    ];
    for (arguments, said) in cases {
        let text = refused(&scratch.run(&[&["check"], *arguments, &["--force"]].concat()), 2);
        assert!(text.contains(said), "{arguments:?}: {text}");
        // The same holds without --force, for existing and new files.
        refused(&scratch.run(&[&["check"], *arguments].concat()), 2);
        assert_eq!(contents(&scratch.0), before, "{arguments:?}");
    }
    // A model excluded from the check is still an input.
    scratch.write("polhode.toml", "[check]\nexclude = [\"robot.urdf\"]\n");
    let text = refused(&scratch.run(&["check", "robot.urdf", "top.xml", "-o", "robot.urdf", "--force"]), 2);
    assert!(text.contains("the model itself"), "{text}");
}

#[test]
fn what_a_model_is_made_of_that_cannot_be_read_is_kept() {
    let scratch = whole_model("gate-torn-include");
    scratch.write("torn.xml", "<mujocoinclude><body>");
    scratch.write(
        "top.xml",
        "<mujoco><worldbody><include file=\"torn.xml\"/><include file=\"inc.xml\"/></worldbody></mujoco>",
    );
    scratch.write("results.txt", "old");
    let before = contents(&scratch.0);
    for (out, said) in [
        ("torn.xml", "a file that the model includes"),
        ("inc.xml", "an unreadable file that the model names"),
    ] {
        let text = refused(&scratch.run(&["check", "top.xml", "robot.urdf", "-o", out, "--force"]), 2);
        assert!(text.contains(said), "{text}");
        assert_eq!(contents(&scratch.0), before, "{out}");
    }
    // Results of the other models are written.
    let output = scratch.run(&["check", "top.xml", "robot.urdf", "-o", "results.txt", "--force"]);
    assert_eq!(status(&output), Some(2));
    assert!(fs::read_to_string(scratch.0.join("results.txt")).unwrap().contains("robot.urdf"));
}

#[test]
fn nothing_is_written_if_one_of_the_outputs_cannot_be() {
    let scratch = whole_model("gate-one-of-two");
    scratch.write("there.txt", "kept");
    let before = contents(&scratch.0);
    for (second, said) in [
        ("there.txt", "there.txt already exists"),
        ("models", "models is a folder, but --output writes a file"),
        ("no/such.txt", "the folder of no/such.txt does not exist"),
    ] {
        let text = refused(&scratch.run(&["check", "robot.urdf", "--fix", "o.urdf", "--output", second]), 2);
        assert!(text.contains(said), "{text}");
        assert_eq!(contents(&scratch.0), before, "{second}");
    }
    let both = ["check", "robot.urdf", "--fix", "o.urdf", "--output", "there.txt", "--force"];
    assert_eq!(status(&scratch.run(&both)), Some(0));
    assert!(fs::read_to_string(scratch.0.join("there.txt")).unwrap().contains("wrote o.urdf"));
}

#[test]
fn a_baseline_that_is_not_written_is_said() {
    let scratch = whole_model("gate-no-baseline");
    scratch.write("torn.urdf", "<robot>");
    let output = scratch.run(&["check", "torn.urdf", "robot.urdf", "--write-baseline", "part.json"]);
    assert_eq!(status(&output), Some(2));
    assert!(
        said(&output).contains("part.json is not written, because some files could not be read"),
        "{}",
        said(&output)
    );
    assert!(!scratch.entries().contains(&"part.json".to_owned()));
}

#[test]
fn what_stands_in_an_included_file_is_allowed_by_that_files_name() {
    let scratch = whole_model("gate-allow-included");
    fs::create_dir(scratch.0.join("more")).unwrap();
    let allow = |file: &str, link: &str| {
        format!(
            "[[check.allow]]\nrule = \"number.malformed\"\nfile = \"{file}\"\nlink = \"{link}\"\nreason = \"theirs\"\n"
        )
    };
    scratch.write("more/top.xml", "<mujoco><worldbody><include file=\"../inc.xml\"/></worldbody></mujoco>");
    for (model, file, link, code) in [
        ("top.xml", "inc.xml", "a", 0),
        ("top.xml", "./inc.*", "a", 0),
        ("top.xml", "top.xml", "a", 0),
        ("more/top.xml", "inc.xml", "a", 0),
        ("more/../more/top.xml", "**/inc.xml", "a", 0),
        ("top.xml", "more/inc.xml", "a", 1),
        ("top.xml", "inc.xml", "b", 1),
    ] {
        scratch.write("polhode.toml", &allow(file, link));
        let text = printed(&scratch.run(&["check", model, "--root", "."]), code);
        assert_eq!(text.contains("allowed: a"), code == 0, "{model} {file}: {text}");
        let asks = file == "inc.xml" && code == 1;
        assert_eq!(text.contains("[allow.unused]"), asks || file == "more/inc.xml", "{model} {file}: {text}");
    }
    // The model itself has the finding, not the included file.
    let own = "<mujoco><worldbody><include file=\"inc.xml\"/><body name=\"b\"><inertial pos=\"0 0 0\" mass=\"2,5\" diaginertia=\"1 1 1\"/></body></worldbody></mujoco>";
    scratch.write("top.xml", own);
    scratch.write("polhode.toml", &allow("inc.xml", "*"));
    let text = printed(&scratch.run(&["check", "top.xml"]), 1);
    assert!(text.contains("allowed: a") && text.contains("✗ b"), "{text}");
}

#[test]
fn a_file_of_two_names_is_checked_once() {
    let scratch = Scratch::new("gate-once");
    fs::create_dir(scratch.0.join("src")).unwrap();
    scratch.write("src/robot.urdf", &impossible());
    let one = said(&scratch.run(&["check", "src/robot.urdf"]));
    let once = |arguments: &[&str], names: &str| {
        let output = scratch.run(&[&["check"], arguments, &["--json"]].concat());
        let reports: serde_json::Value = serde_json::from_str(&printed(&output, 1)).unwrap();
        assert_eq!(reports.as_array().unwrap().len(), 1, "{arguments:?}");
        assert!(said(&output).contains(names), "{}", said(&output));
        let diff = printed(&scratch.run(&[&["check"], arguments, &["--fix"]].concat()), 1);
        assert_eq!(diff.matches("\n+++ ").count(), 1, "{diff}");
    };
    assert!(!one.contains("once"), "{one}");
    once(
        &["src/robot.urdf", "./src/robot.urdf"],
        "./src/robot.urdf is the same file as src/robot.urdf; it is checked once",
    );
    once(&["src", "src/../src/robot.urdf"], "is the same file as src/robot.urdf; it is checked once");
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("robot.urdf", scratch.0.join("src/same.urdf")).unwrap();
        once(&["src"], "src/same.urdf is the same file as src/robot.urdf; it is checked once");
        once(
            &["src/same.urdf", "src/robot.urdf"],
            "src/robot.urdf is the same file as src/same.urdf; it is checked once",
        );
    }
}
