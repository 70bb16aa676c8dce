//! What `polhode check` writes, and what it never writes over.

use std::fs;

use crate::check_gate::{impossible, said, status};
use crate::common::{Scratch, refused};

/// A model of two files and a mesh, a world of an included model, a configuration and a baseline.
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

/// Every file below a folder with its bytes.
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
        // without --force, too, whether it is there or not
        refused(&scratch.run(&[&["check"], *arguments].concat()), 2);
        assert_eq!(contents(&scratch.0), before, "{arguments:?}");
    }
    // what --exclude leaves out of the check is a model still
    scratch.write("polhode.toml", "[check]\nexclude = [\"robot.urdf\"]\n");
    let text = refused(&scratch.run(&["check", "robot.urdf", "top.xml", "-o", "robot.urdf", "--force"]), 2);
    assert!(text.contains("the model itself"), "{text}");
}

#[test]
fn nothing_is_written_if_one_of_the_outputs_cannot_be() {
    let scratch = whole_model("gate-one-of-two");
    scratch.write("there.txt", "kept");
    let before = contents(&scratch.0);
    for (second, said) in [
        ("there.txt", "there.txt is there already"),
        ("models", "models is a folder, and --output writes a file"),
        ("no/such.txt", "is in a folder that is not there"),
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
        said(&output).contains("part.json is not written: not all files could be read"),
        "{}",
        said(&output)
    );
    assert!(!scratch.entries().contains(&"part.json".to_owned()));
}
