//! Rules for modules: allowed imports, forbidden words, and the length of files.
//!
//! The check scans lines and does not parse Rust. It relies on the formatting of this project;
//! tests at the end of a file are skipped.

use std::fmt;
use std::path::{Path, PathBuf};

use crate::{Outcome, files, read, root, short};

/// Modules of the core crate in order; each may import itself and earlier ones.
const MODULES: [&str; 13] = [
    "math",
    "body",
    "motion/error",
    "motion/model",
    "motion/solve",
    "motion/contact",
    "motion/gimbal",
    "motion/inverse",
    "motion/run",
    "motion/task",
    "observe",
    "infer",
    "interop",
];

/// Paths, with the words that files below them must not use, and the reason.
const FORBIDDEN: [(&str, &[&str], &str); 18] = [
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
    ("crates/polhode-algebra/src/", &OUTSIDE, FILES),
    ("crates/polhode-source/src/", &OUTSIDE, FILES),
    ("crates/polhode-document/src/", &OUTSIDE, FILES),
    ("crates/polhode-table/src/", &OUTSIDE, FILES),
    ("crates/polhode-shape/src/", &OUTSIDE, FILES),
    ("crates/polhode-scenario/src/", &OUTSIDE, FILES),
    (
        "crates/polhode-scenario/src/report/",
        &["crate::read"],
        "a report knows results, not the files that they are from",
    ),
    ("crates/polhode-course/src/", &OUTSIDE, FILES),
    ("crates/polhode-judge/src/", &OUTSIDE, FILES),
    ("crates/polhode-identify/src/", &OUTSIDE, FILES),
    ("crates/polhode-budget/src/", &OUTSIDE, FILES),
    ("crates/polhode-robot/src/", &OUTSIDE, FILES),
    ("crates/polhode-web/src/", &OUTSIDE, FILES),
    (
        "crates/polhode-mcp/src/",
        &["std::fs", "File::open", "std::env", "print!", "println!"],
        "it meets its client through the given streams, and files through `Files` alone",
    ),
    ("crates/polhode-npm/src/", &OUTSIDE, FILES),
    ("crates/polhode-wasm/src/", &OUTSIDE, FILES),
];

/// Words for files, clock and terminal, which only the command, its server and Python use.
const OUTSIDE: [&str; 10] = [
    "std::fs",
    "File::open",
    "std::env",
    "Instant::now",
    "SystemTime::now",
    "print!",
    "println!",
    ".exists()",
    ".is_dir()",
    ".canonicalize()",
];

const FILES: &str = "it meets no terminal and no clock, and files through `Files` alone";

/// The only file that may open files.
const DISK: &str = "crates/polhode-source/src/files/disk.rs";

/// Type that every module may name, because it only reports.
const EXCUSED: &str = "propagate::step_statistics::StepStatistics";

/// Largest number of lines of a file without a note.
const LONG: usize = 500;
/// Largest number of lines of a file that passes.
const TOO_LONG: usize = 800;

/// Line that breaks a rule.
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
            // Test files are not part of a module.
            if !file.ends_with("/tests.rs") && !file.contains("/tests/") {
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
        println!("   {count} files keep the modules' order");
        return Ok(());
    }
    let lines = violations.iter().map(|v| format!("\n  {v}"));
    Err(format!("{} lines break the modules' order:{}", violations.len(), lines.collect::<String>()))
}

/// Returns the file with the module list for a file of `tests/all/`, and the module's name.
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

/// Returns a violation if a test file is missing from its module list, because it is then never
/// compiled.
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

/// Returns the violations in the text of a file; `file` is its path from the root.
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
            if file.starts_with(folder) && file != DISK && said {
                report(code, rule.to_owned());
            }
        }
        if let Some(rule) = wrong_import(file, code) {
            report(code, rule);
        }
    }
    violations
}

/// Returns the index in [`MODULES`] of the module that contains a path inside the core crate.
fn module_of(path: &[String]) -> Option<usize> {
    MODULES.iter().position(|module| {
        let names: Vec<&str> = module.split('/').collect();
        path.len() >= names.len() && names.iter().zip(path).all(|(a, b)| a == b)
    })
}

/// Returns the path of a file inside the core crate, such as `motion`, `model`, `rotor`.
fn inside(file: &str) -> Option<Vec<String>> {
    let inside = file.strip_prefix("crates/polhode/src/")?.trim_end_matches(".rs").trim_end_matches("/mod");
    Some(inside.split('/').map(str::to_owned).collect())
}

/// Returns the reason why an import on a line is forbidden; `None` if all are allowed.
fn wrong_import(file: &str, code: &str) -> Option<String> {
    let here = inside(file)?;
    let module = module_of(&here)?;
    targets(&here, code).into_iter().find_map(|target| match module_of(&target) {
        Some(other) if other <= module => None,
        Some(other) => Some(format!("{} knows nothing of {}", MODULES[module], MODULES[other])),
        None => Some(format!("name the module: `crate::<module>::…`, not `crate::{}`", target.join("::"))),
    })
}

/// Returns the first two names, after the root of the crate, of each path on a line.
///
/// Paths start with `crate::` or `super::`.
fn targets(module: &[String], code: &str) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    // A visibility is not an import.
    let code = code.replace("pub(in crate::", "pub(in ");
    let mut rest = code.as_str();
    while let Some(start) = rest.find("crate::").into_iter().chain(rest.find("super::")).min() {
        let mut path = &rest[start..];
        let mut here = module;
        loop {
            if let Some(after) = path.strip_prefix("crate::") {
                (here, path) = (&[], after);
            } else if let Some(after) = path.strip_prefix("super::") {
                (here, path) = (&here[..here.len().saturating_sub(1)], after);
            } else {
                break;
            }
        }
        let end = path.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':')).unwrap_or(path.len());
        let names = path[..end].split("::").filter(|name| !name.is_empty()).map(str::to_owned);
        found.push(here.iter().cloned().chain(names).take(2).collect());
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
    fn modules_import_only_what_comes_before_them() {
        let text = "use crate::math::vector::Torque;\nuse super::error::BodyError;\nuse crate::motion::model::state::State;\n";
        let rule = "body knows nothing of motion/model".to_owned();
        assert_eq!(rules("crates/polhode/src/body/inertia.rs", text), [(3, rule)]);
        assert_eq!(rules("crates/polhode/src/observe/drift.rs", text), []);
    }

    #[test]
    fn relative_paths_are_followed_to_their_module() {
        let rule = "body knows nothing of motion/model".to_owned();
        let up = "use super::super::super::motion::model::state::State;\n";
        assert_eq!(rules("crates/polhode/src/body/shape/box.rs", up), [(1, rule.clone())]);
        assert_eq!(
            rules("crates/polhode/src/body/mod.rs", "use super::motion::model::rotor::Rotor;\n"),
            [(1, rule)]
        );
        assert_eq!(
            rules("crates/polhode/src/body/shape/box.rs", "use super::super::error::BodyError;\n"),
            []
        );
        assert_eq!(rules("crates/polhode/src/body/shape/mod.rs", "use super::error::BodyError;\n"), []);
    }

    #[test]
    fn motion_has_an_order_of_its_own() {
        let text =
            "use crate::motion::run::trajectory::Trajectory;\nuse super::super::run::sample::Sample;\n";
        let rule = "motion/solve knows nothing of motion/run".to_owned();
        let expected = [(1, rule.clone()), (2, rule)];
        assert_eq!(rules("crates/polhode/src/motion/solve/free/flow.rs", text)[..1], expected[..1]);
        assert_eq!(rules("crates/polhode/src/motion/solve/closed_form.rs", text), expected);
        assert_eq!(rules("crates/polhode/src/motion/task/scenario.rs", text), []);
    }

    #[test]
    fn the_flat_names_of_the_front_page_are_no_way_around() {
        for text in
            ["use crate::{State, Rotor};\n", "let x = crate::State::new();\n", "use crate::motion::State;\n"]
        {
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
        assert_eq!(scan("crates/polhode/src/motion/model/state.rs", text), []);
        assert_eq!(scan("crates/polhode-cli/src/main.rs", "use std::fs;\nprintln!();\n"), []);
        let types_only = "use crate::motion::solve::propagate::step_statistics::StepStatistics;\n";
        assert_eq!(scan("crates/polhode/src/observe/drift.rs", types_only), []);
    }

    #[test]
    fn long_files_fail() {
        assert_eq!(too_long("a.rs", TOO_LONG), None);
        assert!(too_long("a.rs", TOO_LONG + 1).is_some());
    }
}
