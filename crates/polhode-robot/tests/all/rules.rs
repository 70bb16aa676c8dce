//! The table of rules agrees with the checks: each reported code is in the table, and each example
//! breaks its rule until it is corrected.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use polhode_robot::finding::Finding;
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect;
use polhode_robot::policy::Policy;
use polhode_robot::read::{ReadOptions, read_text};
use polhode_robot::rule::{page, rule, rules};

fn found(text: &str) -> Vec<Finding> {
    let model = read_text(text, Path::new("example.urdf"), &ReadOptions::default()).unwrap();
    let findings = inspect(&model, &Shapes::default()).findings;
    Policy::default().judge(|_| "example.urdf".to_owned(), &model, findings).open
}

#[test]
fn each_example_breaks_its_rule_until_it_is_mended() {
    for rule in rules() {
        let Some(example) = &rule.example else { continue };
        let [wrong, right] = example.models();
        let told = |text: &str| found(text).into_iter().find(|f| f.code == rule.code);
        let finding = told(&wrong).unwrap_or_else(|| panic!("{}: {wrong}\n{:#?}", rule.code, found(&wrong)));
        assert_eq!(finding.severity, rule.severity, "{}", rule.code);
        assert_eq!(told(&right), None, "{}: {right}", rule.code);
    }
}

/// Collects quoted words that look like a code from the sources below a folder, without tests.
fn codes(folder: &Path, found: &mut BTreeSet<String>) {
    const SUBJECTS: [&str; 13] = [
        "number.",
        "mass.",
        "density.",
        "inertia.",
        "gyration.",
        "geometry.",
        "tree.",
        "joint.",
        "pose.",
        "read.",
        "allow.",
        "baseline.",
        "compare.",
    ];
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            if path.file_name().is_none_or(|name| name != "rule") {
                codes(&path, found);
            }
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        let text = text.split_once("#[cfg(test)]").map_or(text.as_str(), |(code, _)| code);
        for line in text.lines().filter(|line| !line.trim_start().starts_with("//")) {
            let quoted = line.split('"').skip(1).step_by(2);
            let is_code = |word: &&str| {
                SUBJECTS.iter().any(|subject| word.strip_prefix(subject).is_some_and(|rest| !rest.is_empty()))
                    && word.bytes().all(|b| b.is_ascii_lowercase() || b == b'_' || b == b'.')
            };
            found.extend(quoted.filter(is_code).map(str::to_owned));
        }
    }
}

#[test]
fn each_code_that_is_told_is_in_the_table_and_the_reverse() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut told = BTreeSet::new();
    codes(&source, &mut told);
    let listed: BTreeSet<String> = rules().map(|rule| rule.code.to_owned()).collect();
    assert_eq!(told, listed);
    assert!(rule("inertia.triangle").is_some() && rule("inertia.triangel").is_none());
}

#[test]
fn the_page_of_the_book_is_the_table() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/rules.md");
    let page = page();
    if std::env::var_os("POLHODE_WRITE_RULES").is_some() {
        fs::write(&path, &page).unwrap();
    }
    let written = fs::read_to_string(&path).unwrap().replace("\r\n", "\n");
    assert!(
        written == page,
        "book/rules.md is not the table: POLHODE_WRITE_RULES=1 cargo test -p polhode-robot writes it"
    );
}

/// A small collision shape is no evidence of the size if the visual mesh cannot be read.
#[test]
fn geometry_that_cannot_all_be_measured_does_not_accuse() {
    let link = |visual: &str| {
        format!(
            "<robot name=\"r\"><link name=\"a\"><inertial><mass value=\"1.3\"/><inertia ixx=\"0.02\" iyy=\"0.03\" izz=\"0.04\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>\
             <visual><geometry>{visual}</geometry></visual><collision><geometry><sphere radius=\"0.001\"/></geometry></collision></link></robot>"
        )
    };
    let codes = |visual: &str| found(&link(visual)).iter().map(|finding| finding.code).collect::<Vec<_>>();
    assert_eq!(codes("<mesh filename=\"gone.stl\"/>"), ["geometry.unreadable"]);
    let small = codes("<sphere radius=\"0.002\"/>");
    assert!(small.contains(&"density.implausible"), "{small:?}");
}
