//! `polhode compare`: exit status, formats, and files written.

use std::fs;
use std::process::Output;

use serde_json::Value;

use crate::common::{Scratch, example, refused};

fn printed(output: &Output, code: i32) -> String {
    assert_eq!(output.status.code(), Some(code), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout.clone()).unwrap()
}

/// Folder with the example arm, and the arm with a heavier link.
fn arms(name: &str) -> Scratch {
    let scratch = Scratch::new(name);
    let arm = fs::read_to_string(example("robots/arm.urdf")).unwrap();
    assert!(arm.contains("<mass value=\"1.2\"/>"), "{arm}");
    scratch.write("old.urdf", &arm);
    scratch.write("new.urdf", &arm.replacen("<mass value=\"1.2\"/>", "<mass value=\"1.5\"/>", 1));
    scratch
}

#[test]
fn the_status_says_equal_different_or_unreadable() {
    let scratch = arms("compare-status");
    let same = printed(&scratch.run(&["compare", "old.urdf", "old.urdf"]), 0);
    assert_eq!(same, "old.urdf and old.urdf agree within 1e-6: 6 links, 3 joints, 6.12 kg\n");
    let other = printed(&scratch.run(&["compare", "old.urdf", "new.urdf"]), 1);
    assert!(
        other.starts_with("1 difference: old.urdf and new.urdf, 6 links, 3 joints, 6.12 and 6.42 kg\n"),
        "{other}"
    );
    assert!(other.contains("mass 1.5 kg, in old.urdf 1.2 kg: 1.25 times"), "{other}");
    printed(&scratch.run(&["compare", "old.urdf", "new.urdf", "--tolerance", "0.3"]), 0);
    let missing = refused(&scratch.run(&["compare", "old.urdf", "none.urdf"]), 2);
    assert!(missing.contains("none.urdf"), "{missing}");
    for wrong in ["0", "-1", "nan", "inf", "x"] {
        let option = format!("--tolerance={wrong}");
        refused(&scratch.run(&["compare", "old.urdf", "new.urdf", &option]), 2);
    }
}

#[test]
fn the_examples_of_the_arm_are_one_robot() {
    let scratch = Scratch::new("compare-examples");
    let [urdf, sdf, mjcf] = ["arm.urdf", "arm.sdf", "arm.xml"].map(|name| example(&format!("robots/{name}")));
    for (a, b) in [(&urdf, &sdf), (&urdf, &mjcf), (&mjcf, &sdf)] {
        let text = printed(&scratch.run(&["compare", a, b, "--tolerance", "1e-5"]), 0);
        assert!(text.contains(" agree within 1e-5: "), "{text}");
    }
}

#[test]
fn every_format_has_the_difference_at_its_place() {
    let scratch = arms("compare-forms");
    let form = |form: &str| printed(&scratch.run(&["compare", "old.urdf", "new.urdf", "--format", form]), 1);
    let report: Value = serde_json::from_str(&form("json")).unwrap();
    let found = &report["differences"][0];
    let (line, column) = (found["b"]["line"].as_u64().unwrap(), found["b"]["column"].as_u64().unwrap());
    let text = fs::read_to_string(scratch.0.join("new.urdf")).unwrap();
    let marked = text.lines().nth(usize::try_from(line - 1).unwrap()).unwrap();
    assert!(marked[usize::try_from(column - 1).unwrap()..].starts_with("1.5\""), "{marked}");
    assert_eq!(found["a"]["line"].as_u64().unwrap(), line);
    assert_eq!(printed(&scratch.run(&["compare", "old.urdf", "new.urdf", "--json"]), 1), form("json"));

    let sarif: Value = serde_json::from_str(&form("sarif")).unwrap();
    let result = &sarif["runs"][0]["results"][0];
    assert_eq!((&result["ruleId"], &result["level"]), (&"compare.mass".into(), &"warning".into()));
    assert_eq!(result["locations"][0]["physicalLocation"]["region"]["startLine"], line);
    let related = &result["relatedLocations"][0]["physicalLocation"];
    assert_eq!(
        (&related["artifactLocation"]["uri"], &related["region"]["startLine"]),
        (&"old.urdf".into(), &line.into())
    );

    let junit = form("junit");
    assert!(
        junit.contains("<testsuites name=\"polhode compare\" tests=\"1\" failures=\"1\" errors=\"0\">"),
        "{junit}"
    );
    let github = form("github");
    assert!(
        github.starts_with(&format!("::warning file=new.urdf,line={line},col={column},title=compare.mass::")),
        "{github}"
    );
    let gitlab: Value = serde_json::from_str(&form("gitlab")).unwrap();
    assert_eq!(gitlab[0]["location"]["lines"]["begin"], line);
    assert!(form("markdown").starts_with("### polhode compare\n"));
    assert!(form("html").starts_with("<!DOCTYPE html>") || form("html").starts_with("<!doctype html>"));
}

#[test]
fn a_file_is_written_but_never_over_an_input() {
    let scratch = arms("compare-output");
    let run = |more: &[&str]| scratch.run(&[&["compare", "old.urdf", "new.urdf"], more].concat());
    assert_eq!(printed(&run(&["-o", "out.txt"]), 1), "");
    let whole = printed(&run(&[]), 1);
    assert_eq!(fs::read_to_string(scratch.0.join("out.txt")).unwrap(), whole);
    assert!(refused(&run(&["-o", "out.txt"]), 2).contains("already exists"));
    printed(&run(&["-o", "out.txt", "--force", "--json"]), 1);
    for input in ["old.urdf", "new.urdf"] {
        let error = refused(&run(&["-o", input, "--force"]), 2);
        assert!(error.contains("--output would overwrite"), "{error}");
    }
}
