//! The rooms of the house: who may import whom, who may do what, and how long a file may be.
//!
//! A scanner of lines, not a compiler: it reads code in the house style, tests at the end of the file and left out.

use std::fmt;
use std::path::{Path, PathBuf};

use crate::{Outcome, files, read, root, short};

/// The rooms of the core crate, in order: each may import itself and those before it.
const ROOMS: [&str; 4] = ["math", "body", "motion", "observe"];

/// What files below a path may not say, and why.
const FORBIDDEN: [(&str, &[&str], &str); 4] = [
    (
        "crates/polhode/src/",
        &[
            "std::fs",
            "std::io",
            "std::env",
            "std::time",
            "std::process",
            "std::net",
            "print!",
            "println!",
            "dbg!",
        ],
        "the core meets no files, no terminal and no clock",
    ),
    (
        "crates/polhode/src/observe/",
        &["propagate::", "Stepper", "Trajectory::compute"],
        "observe never integrates",
    ),
    (
        "crates/polhode-report/src/",
        &["std::fs", "std::env", "std::time", "print!", "println!"],
        "report only formats",
    ),
    (
        "crates/polhode-report/src/",
        &["polhode_formats"],
        "report knows results, not the files that they came from",
    ),
];

/// What may be said everywhere: a type that only reports.
const EXCUSED: &str = "propagate::stepper::StepStatistics";

/// Files grow a note beyond the first number of lines, and fail beyond the second.
const LONG: usize = 500;
const TOO_LONG: usize = 800;

/// A line that breaks a rule.
#[derive(Debug, PartialEq)]
struct Violation {
    file: String,
    line: usize,
    found: String,
    rule: String,
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: `{}`: {}", self.file, self.line, self.found, self.rule)
    }
}

/// Checks every Rust file of the workspace.
pub(crate) fn check() -> Outcome {
    let mut violations = Vec::new();
    let mut count = 0;
    for folder in ["crates", "xtask"] {
        for path in files(&root().join(folder), "rs")? {
            let (file, text) = (short(&path), read(&path)?);
            // A file of tests is no part of a room.
            if !file.ends_with("/tests.rs") {
                violations.extend(scan(&file, &text));
            }
            violations.extend(too_long(&file, text.lines().count()));
            if let Some((list, module)) = test_module(&path) {
                violations.extend(left_out(&file, &module, &read(&list)?));
            }
            count += 1;
        }
    }
    if violations.is_empty() {
        println!("   {count} files keep to their rooms");
        return Ok(());
    }
    let lines = violations.iter().map(|v| format!("\n  {v}"));
    Err(format!("{} lines break the order of the house:{}", violations.len(), lines.collect::<String>()))
}

/// Of a file of `tests/all/`, the list of modules that it has to stand in, and its name there.
fn test_module(path: &Path) -> Option<(PathBuf, String)> {
    let of_all = |folder: &Path| folder.ends_with("tests/all").then(|| folder.join("main.rs"));
    let (folder, name) = (path.parent()?, path.file_stem()?.to_str()?);
    match (name, of_all(folder)) {
        ("main", Some(_)) => None,
        (_, Some(list)) => Some((list, name.to_owned())),
        ("mod", None) => Some((of_all(folder.parent()?)?, folder.file_name()?.to_str()?.to_owned())),
        _ => None,
    }
}

/// A file of tests that no list of modules names is never compiled, and nobody says so.
fn left_out(file: &str, module: &str, list: &str) -> Option<Violation> {
    let is_listed = list.lines().any(|line| line == format!("mod {module};"));
    let rule = "tests are listed in tests/all/main.rs".to_owned();
    (!is_listed).then(|| Violation { file: file.to_owned(), line: 1, found: module.to_owned(), rule })
}

fn too_long(file: &str, lines: usize) -> Option<Violation> {
    if lines > TOO_LONG {
        let rule = format!("at most {TOO_LONG} lines; one noun per file");
        return Some(Violation { file: file.to_owned(), line: lines, found: format!("{lines} lines"), rule });
    }
    if lines > LONG {
        println!("   note: {file} has {lines} lines, more than {LONG}: is it one noun?");
    }
    None
}

/// The violations in the text of a file, known by its path from the root.
fn scan(file: &str, text: &str) -> Vec<Violation> {
    let mut violations = Vec::new();
    for (k, line) in text.lines().enumerate().take_while(|(_, line)| line.trim() != "#[cfg(test)]") {
        let code = line.split("//").next().unwrap_or_default();
        let mut report = |found: &str, rule: String| {
            let (file, found) = (file.to_owned(), found.trim().to_owned());
            violations.push(Violation { file, line: k + 1, found, rule });
        };
        for (folder, words, rule) in FORBIDDEN {
            let said = words.iter().any(|word| code.replace(EXCUSED, "").contains(word));
            if file.starts_with(folder) && said {
                report(code, rule.to_owned());
            }
        }
        if let Some(rule) = room_of(file).and_then(|room| wrong_import(room, file, code)) {
            report(code, rule);
        }
    }
    violations
}

/// The room of a file of the core, as its number.
fn room_of(file: &str) -> Option<usize> {
    let inside = file.strip_prefix("crates/polhode/src/")?;
    let (first, _) = inside.split_once('/')?;
    ROOMS.iter().position(|room| *room == first)
}

/// Why a line's paths are wrong in a room, if one is.
fn wrong_import(room: usize, file: &str, code: &str) -> Option<String> {
    targets(file, code).into_iter().find_map(|target| match ROOMS.iter().position(|r| *r == target) {
        Some(other) if other <= room => None,
        Some(other) => Some(format!("{} knows nothing of {}", ROOMS[room], ROOMS[other])),
        None => Some(format!("name the room: `crate::<room>::…`, not `crate::{target}`")),
    })
}

/// The first name after the root of the crate in each path `crate::…` or `super::…` of a line of a file.
fn targets(file: &str, code: &str) -> Vec<String> {
    let inside =
        file.trim_start_matches("crates/polhode/src/").trim_end_matches(".rs").trim_end_matches("/mod");
    let module: Vec<&str> = inside.split('/').collect();
    let mut found = Vec::new();
    let mut rest = code;
    while let Some(start) = rest.find("crate::").into_iter().chain(rest.find("super::")).min() {
        let mut path = &rest[start..];
        let mut here = module.as_slice();
        loop {
            if let Some(after) = path.strip_prefix("crate::") {
                (here, path) = (&[], after);
            } else if let Some(after) = path.strip_prefix("super::") {
                (here, path) = (&here[..here.len().saturating_sub(1)], after);
            } else {
                break;
            }
        }
        let name: String = path.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
        found.push(here.first().map_or(name, |room| (*room).to_owned()));
        rest = path;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rules(file: &str, text: &str) -> Vec<(usize, String)> {
        scan(file, text).into_iter().map(|v| (v.line, v.rule)).collect()
    }

    #[test]
    fn rooms_import_only_what_lies_below() {
        let text = "use crate::math::vector::Torque;\nuse super::error::BodyError;\nuse crate::motion::state::State;\n";
        let rule = "body knows nothing of motion".to_owned();
        assert_eq!(rules("crates/polhode/src/body/inertia.rs", text), [(3, rule)]);
        assert_eq!(rules("crates/polhode/src/observe/drift.rs", text), []);
    }

    #[test]
    fn relative_paths_are_followed_to_their_room() {
        let rule = "body knows nothing of motion".to_owned();
        let up = "use super::super::super::motion::state::State;\n";
        assert_eq!(rules("crates/polhode/src/body/shape/box.rs", up), [(1, rule.clone())]);
        assert_eq!(rules("crates/polhode/src/body/mod.rs", "use super::motion::Rotor;\n"), [(1, rule)]);
        assert_eq!(
            rules("crates/polhode/src/body/shape/box.rs", "use super::super::error::BodyError;\n"),
            []
        );
        assert_eq!(rules("crates/polhode/src/body/shape/mod.rs", "use super::error::BodyError;\n"), []);
    }

    #[test]
    fn the_flat_names_of_the_front_page_are_no_way_around() {
        for text in ["use crate::{State, Rotor};\n", "let x = crate::State::new();\n"] {
            assert_eq!(scan("crates/polhode/src/math/vector.rs", text).len(), 1, "{text}");
        }
    }

    #[test]
    fn tests_that_are_not_listed_are_found() {
        let of =
            |path: &str| test_module(Path::new(path)).map(|(list, name)| (list.display().to_string(), name));
        let list = "crates/a/tests/all/main.rs".to_owned();
        assert_eq!(of("crates/a/tests/all/spin.rs"), Some((list.clone(), "spin".to_owned())));
        assert_eq!(of("crates/a/tests/all/plan/mod.rs"), Some((list.clone(), "plan".to_owned())));
        assert_eq!(
            (of("crates/a/tests/all/plan/one.rs"), of(&list), of("crates/a/src/b/mod.rs")),
            (None, None, None)
        );
        assert_eq!(left_out("spin.rs", "spin", "mod plan;\nmod spin;\n"), None);
        assert!(left_out("pin.rs", "pin", "mod plan;\nmod spin;\n").is_some());
    }

    #[test]
    fn every_forbidden_word_is_found() {
        for (folder, words, _) in FORBIDDEN {
            for word in words {
                let text = format!("//! about {word}\nfn f() {{}}\nlet a = {word}(); // {word}\n");
                let found = scan(&format!("{folder}planted.rs"), &text);
                assert!(!found.is_empty() && found.iter().all(|v| v.line == 3), "{word}: {found:?}");
            }
        }
    }

    #[test]
    fn comments_tests_and_other_crates_are_free() {
        let text = "/// println! is for others\nfn f() {}\n#[cfg(test)]\nuse std::fs;\n";
        assert_eq!(scan("crates/polhode/src/motion/state.rs", text), []);
        assert_eq!(scan("crates/polhode-cli/src/main.rs", "use std::fs;\nprintln!();\n"), []);
        let types_only = "use crate::motion::propagate::stepper::StepStatistics;\n";
        assert_eq!(scan("crates/polhode/src/observe/drift.rs", types_only), []);
    }

    #[test]
    fn long_files_fail() {
        assert_eq!(too_long("a.rs", TOO_LONG), None);
        assert!(too_long("a.rs", TOO_LONG + 1).is_some());
    }
}
