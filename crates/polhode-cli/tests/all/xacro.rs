//! `--xacro`, with a program of that name that writes down its arguments and prints a prepared
//! expansion.

use std::fs;
use std::os::unix::fs::PermissionsExt as _;
use std::process::{Command, Output};

use crate::common::{Scratch, json, refused};

const MACROS: &str = r#"<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="prefix" default=""/>
  <link name="$(arg prefix)hand">
    <inertial>
      <mass value="${1.5+0.2}"/>
      <inertia ixx="1" ixy="0.1" ixz="0" iyy="1.25"
        iyz="0" izz="3"/>
    </inertial>
  </link>
</robot>
"#;

const EXPANDED: &str = r#"<robot name="arm">
  <link name="left_hand"><inertial><mass value="1.7"/>
    <inertia ixx="1" ixy="0.1" ixz="0" iyy="1.25" iyz="0" izz="3"/></inertial></link>
</robot>
"#;

/// Program that writes down its arguments, says something, and prints a prepared expansion.
const PROGRAM: &str =
    "#!/bin/sh\nprintf '%s\\n' \"$@\" >> arguments\necho warning: fine >&2\ncat expansion\n";

struct Place(Scratch);

impl Place {
    /// Makes a folder with `arm.urdf.xacro`, and a folder `bin` with the program.
    fn new(name: &str, program: &str) -> Self {
        let scratch = Scratch::new(&format!("xacro-{name}"));
        scratch.write("arm.urdf.xacro", MACROS);
        scratch.write("expansion", EXPANDED);
        fs::create_dir(scratch.0.join("bin")).unwrap();
        let path = scratch.0.join("bin/xacro");
        fs::write(&path, program).unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
        Self(scratch)
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = self.0.command(arguments);
        let path = format!("{}:{}", self.0.0.join("bin").display(), std::env::var("PATH").unwrap());
        command.env("PATH", path);
        command
    }

    fn run(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().unwrap()
    }

    fn arguments(&self) -> String {
        fs::read_to_string(self.0.0.join("arguments")).unwrap()
    }
}

fn printed(output: &Output) -> String {
    assert!(matches!(output.status.code(), Some(0 | 1)), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout.clone()).unwrap()
}

#[test]
fn the_arguments_are_passed_on_and_findings_are_at_macros() {
    let place = Place::new("arguments", PROGRAM);
    let text = printed(&place.run(&[
        "check",
        "arm.urdf.xacro",
        "--xacro",
        "--xacro-arg",
        "prefix:=left_",
        "--xacro-arg",
        "a b:=$(rm x); 'c'",
    ]));
    assert_eq!(place.arguments(), "./arm.urdf.xacro\nprefix:=left_\na b:=$(rm x); 'c'\n");
    assert!(text.contains("left_hand   arm.urdf.xacro:7:22   [inertia.triangle]"), "{text}");
    assert!(text.starts_with("arm.urdf.xacro   URDF, 1 link, 1 inertial"), "{text}");
    // Without --xacro nothing is started.
    fs::remove_file(place.0.0.join("arguments")).unwrap();
    let hint = refused(&place.run(&["check", "arm.urdf.xacro"]), 2);
    assert!(hint.contains("xacro arm.urdf.xacro > arm.urdf, or use --xacro"), "{hint}");
    let hint = refused(&place.run(&["inertia", "arm.urdf.xacro", "--link", "left_hand"]), 2);
    assert!(hint.contains(", or use --xacro"), "{hint}");
    assert!(!place.0.0.join("arguments").exists());
}

#[test]
fn all_commands_of_robots_take_it() {
    let place = Place::new("commands", PROGRAM);
    place.0.write("plain.urdf", EXPANDED);
    place.0.write("-odd.xacro", MACROS);
    // The place of an error is in no file.
    let output = place.run(&["inertia", "arm.urdf.xacro", "--xacro", "--table", "--json"]);
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let error = &report["error"];
    assert!(error["line"].is_null(), "{report}");
    let message = error["message"].as_str().unwrap();
    assert!(message.ends_with("(line 2 of the expanded text)"), "{message}");
    let text = printed(&place.run(&["compare", "plain.urdf", "arm.urdf.xacro", "--xacro"]));
    assert!(text.contains("plain.urdf and arm.urdf.xacro agree"), "{text}");
    // A physical link as one body.
    place.0.write("expansion", &EXPANDED.replace("izz=\"3\"", "izz=\"2\""));
    for lump in [["--lump", "all"], ["--link", "left_hand"]] {
        let output = place.run(&["inertia", "arm.urdf.xacro", "--xacro", lump[0], lump[1], "--json"]);
        assert_eq!(json(&output)["mass"], 1.7);
    }
    // A file name is never an option of xacro.
    fs::remove_file(place.0.0.join("arguments")).unwrap();
    printed(&place.run(&["check", "--xacro", "--", "-odd.xacro"]));
    assert_eq!(place.arguments(), "./-odd.xacro\n");
}

fn printed_any(output: &Output) -> String {
    String::from_utf8_lossy(&[output.stdout.clone(), output.stderr.clone()].concat()).into_owned()
}

#[test]
fn what_goes_wrong_is_said() {
    let place = Place::new("errors", PROGRAM);
    let run = |more: &[&str]| place.run(&[&["check", "arm.urdf.xacro", "--xacro"], more].concat());
    for argument in ["prefix", "prefix=a", ":=a", "--output:=a"] {
        let said = refused(&run(&[&format!("--xacro-arg={argument}")]), 2);
        assert!(
            said.contains(&format!("--xacro-arg \"{argument}\" is not of the form NAME:=VALUE")),
            "{said}"
        );
    }
    let said = refused(&place.run(&["check", "arm.urdf.xacro", "--xacro-arg", "a:=b"]), 2);
    assert!(said.contains("--xacro"), "{said}");
    place.0.write("plain.urdf", EXPANDED);
    let said = refused(&place.run(&["check", "plain.urdf", "--xacro"]), 2);
    assert!(said.contains("no named file is a xacro file"), "{said}");
    let said = refused(&run(&["--fix", "new.urdf"]), 2);
    assert!(said.contains("--fix cannot change arm.urdf.xacro, which is expanded by xacro"), "{said}");
    let options = ["--xacro", "--write-inertials", "new.urdf", "--density", "1000 kg/m^3"];
    let said = refused(&place.run(&[&["inertia", "arm.urdf.xacro"][..], &options].concat()), 2);
    assert!(said.contains("--write-inertials cannot change arm.urdf.xacro"), "{said}");
    assert!(!place.0.0.join("new.urdf").exists());

    // No output; a status with messages, of which the last are quoted; no program.
    place.0.write("expansion", " \n");
    let said = refused(&run(&[]), 2);
    assert!(said.contains("xacro printed nothing: warning: fine"), "{said}");
    let fails = Place::new("fails", "#!/bin/sh\nseq 20 >&2\necho 'No such argument: side' >&2\nexit 2\n");
    fails.0.write("plain.urdf", EXPANDED);
    let said = refused_any(&fails.run(&["check", "arm.urdf.xacro", "plain.urdf", "--xacro"]));
    assert!(
        said.contains("xacro failed, exit status: 2: 16; 17; 18; 19; 20; No such argument: side"),
        "{said}"
    );
    // The other file is checked.
    assert!(said.contains("plain.urdf:3:"), "{said}");
    let output =
        fails.command(&["check", "arm.urdf.xacro", "--xacro"]).env("PATH", fails.0.0.join("none")).output();
    let said = refused(&output.unwrap(), 2);
    assert!(said.contains("--xacro needs the program xacro, which is not on the path"), "{said}");
    assert!(said.contains("pip install xacro"), "{said}");
}

fn refused_any(output: &Output) -> String {
    assert_eq!(output.status.code(), Some(2));
    printed_any(output)
}

#[test]
fn a_fix_without_a_file_prints_the_diff_of_the_expanded_text() {
    let place = Place::new("fix", PROGRAM);
    // One number is a thousand times too large; the box decides.
    let solid = r#"<robot name="arm"><link name="left_hand"><inertial><mass value="2"/>
  <inertia ixx="0.0216667" ixy="0" ixz="0" iyy="0.0166667" iyz="0" izz="8.33333"/></inertial>
  <collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision></link></robot>"#;
    place.0.write("expansion", solid);
    let diff = printed(&place.run(&["check", "arm.urdf.xacro", "--xacro", "--fix"]));
    assert!(diff.contains("--- a/arm.urdf.xacro (expanded)"), "{diff}");
    assert!(diff.contains("\n+  <inertia") && diff.contains("0.00833333"), "{diff}");
    let options = ["--xacro", "--write-inertials", "--density", "1000 kg/m^3"];
    let diff = printed(&place.run(&[&["inertia", "arm.urdf.xacro"][..], &options].concat()));
    assert!(diff.contains("--- a/arm.urdf.xacro (expanded)"), "{diff}");
    assert_eq!(fs::read_to_string(place.0.0.join("arm.urdf.xacro")).unwrap(), MACROS);
}
