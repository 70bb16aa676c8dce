//! `polhode check` in continuous integration: failing, allowed and known findings.

use std::fs;
use std::process::Output;

use serde_json::Value;

use crate::check_forms::mixed;
use crate::common::{Scratch, refused, stdout};

/// Model with one link of 1.7 kg and this largest moment; the link name contains characters that
/// formats must escape.
fn robot(izz: &str) -> String {
    format!(
        "<robot name=\"r\">\n  <link name=\"a|r%m\">\n    <inertial>\n      <mass value=\"1.7\"/>\n      \
         <inertia ixx=\"0.031\" ixy=\"0.004\" ixz=\"-0.003\" iyy=\"0.042\" iyz=\"0.002\" izz=\"{izz}\"/>\n    </inertial>\n  </link>\n</robot>\n"
    )
}

/// Model with a moment ten times too large, and a visual box of the correct tensor; there is
/// exactly one fix.
pub(crate) fn impossible() -> String {
    confirmed(&robot("0.53"))
}

/// Returns the model of [`robot`] with the box whose tensor is that of [`good`].
pub(crate) fn confirmed(robot: &str) -> String {
    robot.replace("  </link>", &format!("    {BOX}\n  </link>"))
}

const BOX: &str = "<collision><origin rpy=\"0.560569321 -1.399136148 2.249840312\"/><geometry><box size=\"0.257639060 0.373739150 0.488515143\"/></geometry></collision>";

pub(crate) fn good() -> String {
    robot("0.053")
}

/// Model with an identity tensor and no contradicting evidence: a note.
pub(crate) fn noted() -> String {
    robot("1")
        .replace("0.031", "1")
        .replace("0.042", "1")
        .replace("0.004", "0")
        .replace("-0.003", "0")
        .replace("0.002", "0")
        .replace("1.7", "20")
}

/// Model with a box of 1.2 kg and an identity tensor: suspect.
fn suspect() -> String {
    noted().replace("\"20\"", "\"1.2\"").replace(
        "    <inertial>",
        "    <visual><geometry><box size=\"0.1 0.2 0.3\"/></geometry></visual>\n    <inertial>",
    )
}

pub(crate) fn status(output: &Output) -> Option<i32> {
    output.status.code()
}

pub(crate) fn said(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

pub(crate) fn printed(output: &Output, code: i32) -> String {
    assert_eq!(status(output), Some(code), "{}", said(output));
    String::from_utf8(output.stdout.clone()).unwrap()
}

#[test]
fn the_severity_that_fails_is_a_choice() {
    let scratch = Scratch::new("check-fail-on");
    for (name, text, impossible_, suspect_, note) in [
        ("i.urdf", impossible(), 1, 1, 1),
        ("s.urdf", suspect(), 0, 1, 1),
        ("n.urdf", noted(), 0, 0, 1),
        ("g.urdf", good(), 0, 0, 0),
    ] {
        scratch.write(name, &text);
        let code = |more: &[&str]| status(&scratch.run(&[&["check", name], more].concat()));
        assert_eq!(code(&["--fail-on", "impossible"]), Some(impossible_), "{name}");
        assert_eq!(code(&["--fail-on", "suspect"]), Some(suspect_), "{name}");
        assert_eq!(code(&[]), Some(suspect_), "{name}");
        assert_eq!(code(&["--fail-on", "note"]), Some(note), "{name}");
        assert_eq!(code(&["--strict"]), Some(note), "{name}");
    }
    // The configuration sets the level, and the command line overrides it.
    scratch.write("polhode.toml", "[check]\nfail_on = \"impossible\"\n");
    assert_eq!(status(&scratch.run(&["check", "s.urdf"])), Some(0));
    assert_eq!(status(&scratch.run(&["check", "s.urdf", "--fail-on", "suspect"])), Some(1));
    assert_eq!(status(&scratch.run(&["check", "i.urdf"])), Some(1));
    refused(&scratch.run(&["check", "i.urdf", "--fail-on", "all"]), 2);
    refused(&scratch.run(&["check", "i.urdf", "--fail-on", "note", "--strict"]), 2);
}

#[test]
fn what_a_configuration_allows_is_listed_with_its_reason() {
    let scratch = Scratch::new("check-config");
    fs::create_dir_all(scratch.0.join("src/old")).unwrap();
    scratch.write("src/a.urdf", &impossible());
    scratch.write("src/old/b.urdf", &impossible());
    let allow = "[[check.allow]]\nrule = \"inertia.triangle\"\nfile = \"src/*.urdf\"\nreason = \"measured on the bench\"\n";
    scratch.write("polhode.toml", &format!("[check]\nexclude = [\"**/old/**\"]\n{allow}"));
    let text = printed(&scratch.run(&["check", "src"]), 0);
    assert!(
        text.contains("allowed: a|r%m src/a.urdf:5:") && text.contains("measured on the bench"),
        "{text}"
    );
    assert!(text.contains("excluded: 1 file") && !text.contains("b.urdf"), "{text}");
    assert!(text.contains("IMPOSSIBLE 0") && text.contains("OK 1 of 1"), "{text}");
    // Absolute names are relative to the working directory.
    let absolute = scratch.0.canonicalize().unwrap().join("src");
    assert_eq!(status(&scratch.run(&["check", absolute.to_str().unwrap()])), Some(0));
    // The JSON lists allowed findings; remarks on the configuration go to standard error.
    let json = scratch.run(&["check", "src/a.urdf", "--json"]);
    let report: Value = serde_json::from_str(&printed(&json, 0)).unwrap();
    assert_eq!(report["findings"].as_array().unwrap().len(), 0);
    assert_eq!(report["allowed"][0]["reason"], "measured on the bench");
    assert_eq!(report["allowed"][0]["id"].as_str().unwrap().len(), 16);
    // An expired entry has no effect.
    scratch.write("gone.toml", &format!("{allow}expires = 2020-01-01\n"));
    let text = printed(&scratch.run(&["check", "src/a.urdf", "--config", "gone.toml"]), 1);
    assert!(text.contains("✗ a|r%m") && text.contains("note: gone.toml:1:1 [allow.expired]"), "{text}");
    scratch.write("later.toml", &format!("{allow}expires = 9999-12-31\n"));
    assert_eq!(status(&scratch.run(&["check", "src/a.urdf", "--config", "later.toml"])), Some(0));
    // An unused entry.
    scratch.write("src/a.urdf", &good());
    let text = printed(&scratch.run(&["check", "src/a.urdf"]), 0);
    assert!(text.contains("note: polhode.toml:3:1 [allow.unused]"), "{text}");
    assert_eq!(status(&scratch.run(&["check", "src/a.urdf", "--strict"])), Some(1));
    let json = scratch.run(&["check", "src/a.urdf", "--json"]);
    assert!(said(&json).contains("[allow.unused]") && serde_json::from_slice::<Value>(&json.stdout).is_ok());
    // An invalid configuration is refused with its place.
    scratch.write("polhode.toml", "[check]\nfail_on = \"imposible\"\n");
    let text = refused(&scratch.run(&["check", "src/a.urdf"]), 2);
    assert!(text.contains("polhode.toml:2:11") && text.contains("did you mean impossible?"), "{text}");
    refused(&scratch.run(&["check", "src/a.urdf", "--config", "none.toml"]), 2);
}

#[test]
fn a_baseline_lets_only_what_is_new_fail() {
    let scratch = Scratch::new("check-baseline");
    scratch.write("a.urdf", &impossible());
    let wrote = scratch.run(&["check", "a.urdf", "--write-baseline", "known.json"]);
    assert!(printed(&wrote, 0).contains("✗ a|r%m") && said(&wrote).contains("wrote known.json: 1 finding"));
    let text = printed(&scratch.run(&["check", "a.urdf", "--baseline", "known.json"]), 0);
    assert!(text.contains("known: 1 finding") && !text.contains('✗'), "{text}");
    // A finding moved by some lines is still known, and another one is new.
    scratch.write("a.urdf", &impossible().replace("  <link", "\n\n  <link"));
    assert_eq!(status(&scratch.run(&["check", "a.urdf", "--baseline", "known.json"])), Some(0));
    scratch.write("b.urdf", &impossible());
    let text = printed(&scratch.run(&["check", "a.urdf", "b.urdf", "--baseline", "known.json"]), 1);
    assert_eq!(text.matches('✗').count(), 1, "{text}");
    // A finding that no longer occurs is reported.
    scratch.write("a.urdf", &good());
    let text = printed(&scratch.run(&["check", "a.urdf", "--baseline", "known.json"]), 0);
    assert!(text.contains("note: known.json:1:1 [baseline.gone]"), "{text}");
    // A baseline is replaced only with --force, and not written if a file could not be read.
    refused_after_results(&scratch.run(&["check", "a.urdf", "--write-baseline", "known.json"]), "--force");
    let again = scratch.run(&[
        "check",
        "a.urdf",
        "b.urdf",
        "--baseline",
        "known.json",
        "--write-baseline",
        "known.json",
        "--force",
    ]);
    assert_eq!(status(&again), Some(0), "{}", said(&again));
    assert_eq!(fs::read_to_string(scratch.0.join("known.json")).unwrap().matches("\"id\"").count(), 1);
    scratch.write("torn.urdf", "<robot>");
    assert_eq!(
        status(&scratch.run(&["check", "torn.urdf", "a.urdf", "--write-baseline", "part.json"])),
        Some(2)
    );
    assert!(!scratch.entries().contains(&"part.json".to_owned()));
    refused(&scratch.run(&["check", "a.urdf", "--baseline", "a.urdf"]), 2);
}

fn refused_after_results(output: &Output, hint: &str) {
    assert_eq!(status(output), Some(2));
    assert!(said(output).contains(hint), "{}", said(output));
}

#[test]
fn a_comment_in_the_model_allows_with_a_reason() {
    let scratch = Scratch::new("check-comment");
    let with = |comment: &str| impossible().replace("  <link", &format!("  {comment}\n  <link"));
    scratch.write("a.urdf", &with("<!-- polhode: allow inertia.triangle: measured -->"));
    let text = printed(&scratch.run(&["check", "a.urdf"]), 0);
    assert!(text.contains("allowed: a|r%m a.urdf:6:") && text.contains("measured"), "{text}");
    scratch.write("a.urdf", &with("<!-- polhode: allow inertia.triangle -->"));
    let text = printed(&scratch.run(&["check", "a.urdf"]), 1);
    assert!(text.contains("[allow.malformed]") && text.contains("[inertia.triangle]"), "{text}");
    // Allowed findings are not fixed.
    scratch.write(
        "b.urdf",
        &with("<!-- polhode: allow number.malformed: a test of readers -->")
            .replace("1.7", "1,7")
            .replace("0.53", "0.053"),
    );
    scratch.run(&["check", "b.urdf", "--fix", "c.urdf"]);
    assert!(fs::read_to_string(scratch.0.join("c.urdf")).unwrap().contains("1,7"));
}

#[test]
fn results_go_to_a_file_whole_or_not_at_all() {
    let scratch = mixed("check-output");
    let to_file = scratch.run(&["check", "src/n.urdf", "--format", "sarif", "--output", "out.sarif"]);
    assert_eq!((status(&to_file), to_file.stdout.len()), (Some(0), 0));
    let written = fs::read_to_string(scratch.0.join("out.sarif")).unwrap();
    assert_eq!(written, stdout(&scratch.run(&["check", "src/n.urdf", "--format", "sarif"])));
    refused(&scratch.run(&["check", "src/n.urdf", "--output", "out.sarif"]), 2);
    assert_eq!(fs::read_to_string(scratch.0.join("out.sarif")).unwrap(), written);
    assert_eq!(status(&scratch.run(&["check", "src/n.urdf", "-o", "out.sarif", "--force"])), Some(0));
    assert!(fs::read_to_string(scratch.0.join("out.sarif")).unwrap().contains("NOTE 1"));
    // `--json` is the same as `--format json`.
    let short = stdout(&scratch.run(&["check", "src/n.urdf", "--json"]));
    assert_eq!(short, stdout(&scratch.run(&["check", "src/n.urdf", "--format", "json"])));
    let text = refused(&scratch.run(&["check", "src/n.urdf", "--fix", "f.urdf", "--format", "sarif"]), 2);
    assert!(text.contains("--fix") && !scratch.entries().contains(&"f.urdf".to_owned()), "{text}");
}

#[test]
fn every_rule_is_explained() {
    let scratch = Scratch::new("check-explain");
    let all = stdout(&scratch.run(&["check", "--explain"]));
    let codes: Vec<&str> = all.lines().map(|line| line.split_whitespace().next().unwrap()).collect();
    assert!(codes.len() > 40 && codes.contains(&"inertia.triangle"), "{all}");
    for code in &codes {
        let text = stdout(&scratch.run(&["check", "--explain", code]));
        assert!(text.starts_with(code) && text.contains("why: ") && text.contains("fix: "), "{text}");
    }
    let text = stdout(&scratch.run(&["check", "--explain", "inertia.triangle"]));
    assert!(text.contains("wrong:   0.53") && text.contains("right:   0.053"), "{text}");
    let text = refused(&scratch.run(&["check", "--explain", "inertia.triangel"]), 2);
    assert!(text.contains("did you mean inertia.triangle?"), "{text}");
    // Each finding has the code of a rule.
    scratch.write("a.urdf", &impossible());
    let report: Value =
        serde_json::from_str(&printed(&scratch.run(&["check", "a.urdf", "--json"]), 1)).unwrap();
    assert!(codes.contains(&report["findings"][0]["code"].as_str().unwrap()));
}

#[test]
fn no_output_takes_the_place_of_a_model() {
    let scratch = Scratch::new("gate-over-model");
    scratch.write("robot.urdf", &impossible());
    for option in ["--output", "--write-baseline", "--fix"] {
        let text = refused(&scratch.run(&["check", "robot.urdf", option, "./robot.urdf", "--force"]), 2);
        assert!(text.contains(&format!("{option} would overwrite the model itself")), "{text}");
        assert_eq!(fs::read_to_string(scratch.0.join("robot.urdf")).unwrap(), impossible());
    }
}
