//! Machine-readable output formats of `polhode check`.

use std::collections::BTreeSet;
use std::fs;

use serde_json::Value;

use crate::check_gate::{good, impossible, noted, printed, said};
use crate::common::{Scratch, stdout};

/// Folder with one failing, one allowed, one noted and one unreadable model.
pub(crate) fn mixed(name: &str) -> Scratch {
    let scratch = Scratch::new(name);
    fs::create_dir_all(scratch.0.join("src")).unwrap();
    scratch.write("src/a, b.urdf", &impossible());
    scratch.write("src/n.urdf", &noted());
    scratch.write(
        "src/ok.urdf",
        &impossible().replace("  <link", "<!-- polhode: allow inertia.triangle: a & b -->\n  <link"),
    );
    scratch.write("src/torn.urdf", "<robot>\n<link name=\"a\">\n</robot>");
    scratch
}

#[test]
fn sarif_is_what_its_schema_says() {
    let scratch = mixed("check-sarif");
    let output = scratch.run(&["check", "src", "--format", "sarif"]);
    let log: Value = serde_json::from_str(&printed(&output, 2)).unwrap();
    assert_eq!(log["version"], "2.1.0");
    assert!(log["$schema"].as_str().unwrap().ends_with("sarif-2.1.0.json"));
    let run = &log["runs"][0];
    let driver = &run["tool"]["driver"];
    assert_eq!(driver["name"], "polhode");
    let rules = driver["rules"].as_array().unwrap();
    let ids: BTreeSet<&str> = rules.iter().map(|rule| rule["id"].as_str().unwrap()).collect();
    assert_eq!(ids.len(), rules.len());
    for rule in rules {
        assert!(
            ["error", "warning", "note"].contains(&rule["defaultConfiguration"]["level"].as_str().unwrap())
        );
        assert!(!rule["shortDescription"]["text"].as_str().unwrap().is_empty());
        assert!(!rule["help"]["text"].as_str().unwrap().is_empty() && rule["help"]["markdown"].is_string());
    }
    assert_eq!(run["columnKind"], "unicodeCodePoints");
    let results = run["results"].as_array().unwrap();
    assert_eq!(results.len(), 3, "{results:#?}");
    let mut prints = BTreeSet::new();
    for result in results {
        let index = usize::try_from(result["ruleIndex"].as_u64().unwrap()).unwrap();
        assert_eq!(rules[index]["id"], result["ruleId"]);
        assert!(["error", "warning", "note"].contains(&result["level"].as_str().unwrap()));
        assert!(!result["message"]["text"].as_str().unwrap().is_empty());
        let place = &result["locations"][0]["physicalLocation"];
        let uri = place["artifactLocation"]["uri"].as_str().unwrap();
        assert!(uri.starts_with("src/") && !uri.contains([' ', '\\']), "{uri}");
        let number = |key: &str| place["region"][key].as_u64().unwrap();
        assert!(
            number("startLine") >= 1
                && number("startColumn") >= 1
                && number("endLine") >= number("startLine")
        );
        prints.insert(result["partialFingerprints"]["polhode/v1"].as_str().unwrap());
    }
    assert_eq!(prints.len(), 3);
    let first = &results[0];
    assert_eq!((&first["ruleId"], &first["level"]), (&"inertia.triangle".into(), &"error".into()));
    assert_eq!(first["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "src/a,%20b.urdf");
    assert_eq!(first["locations"][0]["logicalLocations"][0]["name"], "a|r%m");
    assert!(first.get("suppressions").is_none());
    assert_eq!(results[2]["suppressions"][0]["justification"], "a & b");
    // The fix is the same as in the JSON: same place, same text.
    let replacement = &first["fixes"][0]["artifactChanges"][0]["replacements"][0];
    assert_eq!(replacement["insertedContent"]["text"], "0.053");
    assert_eq!(replacement["deletedRegion"]["startLine"], 5);
    let invocation = &run["invocations"][0];
    assert_eq!(invocation["executionSuccessful"], false);
    let unread = &invocation["toolExecutionNotifications"][0];
    assert_eq!(unread["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "src/torn.urdf");
}

#[test]
fn junit_counts_what_it_has() {
    let scratch = mixed("check-junit");
    let text = printed(&scratch.run(&["check", "src", "--format", "junit"]), 2);
    assert!(text.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites "), "{text}");
    let tree = text.lines().nth(1).unwrap();
    assert!(tree.contains("tests=\"4\" failures=\"1\" errors=\"1\">"), "{tree}");
    let count = |what: &str| text.matches(what).count();
    assert_eq!(
        (count("<testsuite "), count("<testcase "), count("<failure "), count("<error "), count("<skipped ")),
        (4, 4, 1, 1, 1)
    );
    assert_eq!((count("<testcase "), count("</testcase>")), (4, 4));
    assert!(text.contains("allowed: a &amp; b") && text.contains("<system-out>note: "), "{text}");
    // With `--strict` a note fails; a clean file is a passed test case.
    let strict = printed(&scratch.run(&["check", "src/n.urdf", "--format", "junit", "--strict"]), 1);
    assert!(strict.contains("failures=\"1\""), "{strict}");
    scratch.write("good.urdf", &good());
    let text = printed(&scratch.run(&["check", "good.urdf", "--format", "junit"]), 0);
    assert!(text.contains("<testcase classname=\"good.urdf\" name=\"nothing found\"/>"), "{text}");
}

#[test]
fn github_gitlab_and_markdown_escape_what_they_must() {
    let scratch = mixed("check-forms");
    let text = printed(&scratch.run(&["check", "src", "--format", "github"]), 2);
    let line = text
        .lines()
        .find(|line| line.contains("inertia.triangle,"))
        .or(text.lines().find(|line| line.contains("title=inertia.triangle")))
        .unwrap();
    assert!(line.starts_with("::error file=src/a%2C b.urdf,line=5,col="), "{line}");
    assert!(line.contains(",title=inertia.triangle::a|r%25m: i1 + i2 = "), "{line}");
    assert!(
        text.contains("::error file=src/torn.urdf,line=3") && text.contains("::notice file=src/n.urdf"),
        "{text}"
    );
    assert!(text.contains("\nallowed: a|r%m src/ok.urdf:6 [inertia.triangle]: a & b\n"), "{text}");
    assert!(text.ends_with("4 files, 1 impossible, 0 suspect, 1 note, 1 allowed, 0 known\n"), "{text}");

    let issues: Value =
        serde_json::from_str(&printed(&scratch.run(&["check", "src", "--format", "gitlab"]), 2)).unwrap();
    let issues = issues.as_array().unwrap();
    let severities: Vec<&str> = issues.iter().map(|issue| issue["severity"].as_str().unwrap()).collect();
    assert_eq!(severities, ["blocker", "critical", "info"]);
    let prints: BTreeSet<&str> = issues.iter().map(|issue| issue["fingerprint"].as_str().unwrap()).collect();
    assert_eq!(prints.len(), 3);
    assert_eq!(issues[1]["location"]["path"], "src/a, b.urdf");
    assert_eq!(issues[1]["location"]["lines"]["begin"], 5);
    assert!(issues.iter().all(|issue| issue["description"].is_string() && issue["check_name"].is_string()));

    let table = printed(&scratch.run(&["check", "src", "--format", "markdown"]), 2);
    assert!(table.contains("**1 impossible**"), "{table}");
    let rows: Vec<&str> = table.lines().filter(|line| line.starts_with('|')).collect();
    assert_eq!(rows.len(), 5, "{table}");
    // Each row has four columns, whatever its cells contain.
    for row in rows {
        assert_eq!(row.replace("\\|", "").matches('|').count(), 5, "{row}");
    }
    assert!(table.contains("a\\|r%m") && table.contains("a &amp; b"), "{table}");
}

#[test]
fn what_is_left_out_or_off_is_said_in_each_form() {
    let scratch = Scratch::new("check-left-out");
    fs::create_dir_all(scratch.0.join("src/old")).unwrap();
    scratch.write("src/a.urdf", &impossible());
    scratch.write("src/old/b.urdf", &impossible());
    scratch.write(
        "polhode.toml",
        "[check]\nexclude = [\"**/old/**\"]\n[check.rules]\n\"inertia.triangle\" = \"off\"\n",
    );
    const LEFT_OUT: &str = "excluded: 1 file, by exclude in the configuration";
    const OFF: &str = "off: 1 finding of disabled rules";
    for form in ["text", "sarif", "junit", "github", "markdown"] {
        let text = printed(&scratch.run(&["check", "src", "--format", form]), 0);
        assert!(text.contains(LEFT_OUT) && text.contains(OFF), "{form}: {text}");
    }
    // Formats without a place for it use standard error.
    let gitlab = scratch.run(&["check", "src", "--format", "gitlab"]);
    assert!(said(&gitlab).contains(LEFT_OUT) && said(&gitlab).contains(OFF), "{}", said(&gitlab));
    assert_eq!(printed(&gitlab, 0).trim(), "[]");
    let sarif: Value =
        serde_json::from_str(&stdout(&scratch.run(&["check", "src", "--format", "sarif"]))).unwrap();
    let invocation = &sarif["runs"][0]["invocations"][0];
    assert_eq!(invocation["executionSuccessful"], true);
    assert_eq!(invocation["toolExecutionNotifications"][0]["level"], "note");
    let junit = stdout(&scratch.run(&["check", "src", "--format", "junit"]));
    assert!(junit.lines().nth(1).unwrap().contains("tests=\"3\" failures=\"0\" errors=\"0\">"), "{junit}");
    let github = stdout(&scratch.run(&["check", "src", "--format", "github"]));
    assert_eq!(github.matches("::notice title=polhode check::").count(), 2, "{github}");
}

#[test]
fn repairs_of_an_included_file_are_of_that_file() {
    let scratch = Scratch::new("check-included-fix");
    fs::create_dir_all(scratch.0.join("src/parts")).unwrap();
    scratch.write(
        "src/main.xml",
        "<mujoco>\n<worldbody>\n<include file=\"parts/arm.xml\"/></worldbody></mujoco>",
    );
    scratch.write(
        "src/parts/arm.xml",
        "<mujocoinclude>\n\n<body name=\"arm\"><joint/><inertial pos=\"0 0 0\" mass=\"1,7\" diaginertia=\"0.031 0.042 0.053\"/></body>\n\
         </mujocoinclude>",
    );
    let log: Value =
        serde_json::from_str(&printed(&scratch.run(&["check", "src/main.xml", "--format", "sarif"]), 1))
            .unwrap();
    let change = &log["runs"][0]["results"][0]["fixes"][0]["artifactChanges"][0];
    assert_eq!(change["artifactLocation"]["uri"], "src/parts/arm.xml", "{change:#}");
    assert_eq!(change["replacements"][0]["deletedRegion"]["startLine"], 3);
    assert_eq!(change["replacements"][0]["insertedContent"]["text"], "1.7");
}
