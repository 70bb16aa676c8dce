//! Hints in the sources: each with something to write is followed by a test.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::CASES;

/// Crates with hints. Those of the Python package have their own tests.
const CRATES: [&str; 14] = [
    "",
    "-budget",
    "-cli",
    "-document",
    "-identify",
    "-judge",
    "-live",
    "-robot",
    "-scenario",
    "-shape",
    "-source",
    "-sweep",
    "-table",
    "-web",
];

/// Checks that every hint in the sources with an option or code to write is the hint of a case, is
/// followed by a test of its reader, or is listed with `! TEXT` and the reason that it has none;
/// and that no listed hint has a case.
pub(super) fn check(hints: &[String]) {
    let listed: Vec<&str> = CASES.lines().filter_map(|line| line.strip_prefix("! ")).collect();
    let read = read_back();
    let mut wrong = Vec::new();
    let mut count = 0;
    for (place, text) in sites() {
        count += 1;
        let has_case =
            hints.iter().any(|hint| is_made_by(hint, &text)) || read.iter().any(|hint| begins(hint, &text));
        let is_listed = listed.iter().any(|start| text.starts_with(start));
        if has_case == is_listed {
            wrong.push(format!("{place}: {}: {text}", if has_case { "is listed" } else { "has no case" }));
        }
    }
    assert!(count > 240 && wrong.is_empty(), "{count} hints\n{}", wrong.join("\n"));
}

/// Checks that every place in the sources that looks for the name that was meant has a case, or is
/// listed with `?! FILE` and the test that follows it.
pub(super) fn check_names<'a>(cases: impl Iterator<Item = &'a str>) {
    let listed = CASES.lines().filter_map(|line| line.strip_prefix("?! "));
    let mut tested: BTreeMap<String, usize> = BTreeMap::new();
    cases
        .chain(listed)
        .filter(|file| !file.is_empty())
        .for_each(|file| *tested.entry(file.to_owned()).or_default() += 1);
    let mut found: BTreeMap<String, usize> = BTreeMap::new();
    for path in CRATES.iter().flat_map(|name| sources(&folder(&format!("{name}/src")))) {
        let text = fs::read_to_string(&path).unwrap();
        let text = text.split("#[cfg(test)]\nmod ").next().unwrap_or(&text);
        // Some files have a function of this name for other things.
        let imports = |line: &str| {
            line.starts_with("use ")
                && line.contains("nearest")
                && ["polhode_source", "suggestion", "crate::nearest"].iter().any(|it| line.contains(it))
        };
        let is_name = text.contains("polhode_source::nearest(") || text.lines().any(imports);
        let calls = text.lines().filter(|line| !line.trim_start().starts_with("//")).map(|line| {
            let own = line.match_indices("nearest(").filter(|(at, _)| is_name && !line[..*at].ends_with('.'));
            own.count() + line.matches(".suggesting(").count()
        });
        let count: usize = calls.sum();
        if count > 0 {
            let path = path.display().to_string();
            let name = path.rsplit_once("/polhode").map_or(&*path, |(_, name)| name.trim_start_matches('-'));
            found.insert(name.to_owned(), count);
        }
    }
    assert_eq!(tested, found, "cases for each file, and calls in it");
}

/// Checks that the options in hints are options of a command that prints them; `help` returns the
/// help of a command.
pub(super) fn check_options(help: impl Fn(&str) -> String) {
    const COMMANDS: [(&str, &str); 7] = [
        ("budget", "budget"),
        ("identify", "identify"),
        ("judge", "judge simulate"),
        ("robot", "check compare inertia"),
        ("shape", "inertia"),
        ("sweep", "sweep"),
        ("table", "judge identify"),
    ];
    const ALL: &str = "budget check compare explain identify inertia judge live new schema simulate spin stability sweep torque";
    let options = |text: &str| -> Vec<String> {
        let ends = |c: char| !(c.is_ascii_lowercase() || c == '-');
        let words =
            text.split("--").skip(1).map(|rest| rest.split(ends).next().unwrap_or_default().to_owned());
        words.filter(|word| word.starts_with(|c: char| c.is_ascii_lowercase())).collect()
    };
    let known: BTreeMap<&str, Vec<String>> =
        ALL.split(' ').map(|command| (command, options(&help(command)))).collect();
    let mut count = 0;
    for (place, text) in sites() {
        let named = COMMANDS.iter().find(|(name, _)| place.contains(&format!("/polhode-{name}/")));
        let commands = named.map_or(ALL, |(_, commands)| commands);
        for option in options(&text) {
            count += 1;
            let exists = commands.split(' ').any(|command| known[command].contains(&option));
            assert!(exists, "{place}: --{option} is not an option of {commands}: {text}");
        }
    }
    assert!(count > 80, "{count}");
}

/// Returns the texts with which other tests check the beginnings of hints that they follow.
fn read_back() -> Vec<String> {
    let mut found = Vec::new();
    for name in ["", "-identify", "-scenario", "-sweep"] {
        for path in sources(&folder(&format!("{name}/tests"))) {
            let text = fs::read_to_string(&path).unwrap();
            if !["obey::check(", "refuses(", "follow("].iter().any(|call| text.contains(call)) {
                continue;
            }
            // These hints are not followed.
            let mut parts = text.split("refuses_alone(");
            let kept = parts.next().unwrap_or_default().to_owned();
            let kept =
                parts.fold(kept, |kept, part| kept + part.split_once(");").map_or("", |(_, rest)| rest));
            found.extend(literals(&kept).into_iter().map(|(_, text)| text));
        }
    }
    found
}

/// Returns true if a text is the beginning of a hint that a format string can make.
fn begins(text: &str, format: &str) -> bool {
    const LEAST: usize = 10;
    let head = format.replace("{{", "{").replace("}}", "}");
    let head =
        if head.len() < format.len() { head.as_str() } else { format.split('{').next().unwrap_or_default() };
    text.len() >= LEAST && head.starts_with(text) || head.len() >= LEAST && text.starts_with(head)
}

/// Returns true if a format string can make a hint.
fn is_made_by(hint: &str, format: &str) -> bool {
    let mut rest = hint;
    format.replace("{{", "\u{1}").replace("}}", "\u{2}").split('{').enumerate().all(|(k, piece)| {
        let literal = if k == 0 { piece } else { piece.split_once('}').map_or("", |(_, after)| after) };
        let literal = literal.replace('\u{1}', "{").replace('\u{2}', "}");
        let Some((_, after)) = rest.split_once(literal.as_str()) else { return false };
        rest = after;
        true
    })
}

/// Returns the place and the text of every string in the sources that tells to write code or an
/// option, and of all hints of the core crate's errors.
fn sites() -> Vec<(String, String)> {
    const VERBS: [&str; 15] = [
        "write ",
        "add ",
        "give ",
        "use ",
        "set ",
        "name ",
        "state ",
        "remove ",
        "delete ",
        "choose ",
        "allow ",
        "leave out ",
        "try ",
        "put ",
        "replace ",
    ];
    let mut found = Vec::new();
    for name in CRATES {
        for path in sources(&folder(&format!("{name}/src"))) {
            let text = fs::read_to_string(&path).unwrap();
            let text = text.split("#[cfg(test)]\nmod ").next().unwrap_or(&text);
            let advice = if name.is_empty() { advice(text) } else { 0..0 };
            for (line, literal) in literals(text) {
                let begins = |verb: &&str| {
                    literal.starts_with(*verb)
                        || ["; ", ": ", ", ", "or ", "and ", "("]
                            .iter()
                            .any(|before| literal.contains(&format!("{before}{verb}")))
                };
                let has_code = ["--", " = ", "[["].iter().any(|code| literal.contains(code));
                let is_hint = advice.contains(&line) || has_code && VERBS.iter().any(begins);
                if is_hint && !literal.contains('\n') {
                    found.push((format!("{}:{line}", path.display()), literal));
                }
            }
        }
    }
    found
}

/// Returns the lines of the function that returns the hints of an error.
fn advice(text: &str) -> std::ops::Range<usize> {
    let Some((before, rest)) = text.split_once("pub fn hint(") else { return 0..0 };
    let start = before.lines().count();
    let function = rest.split("\n    }\n").next().unwrap_or_default();
    start..start + function.lines().count()
}

/// Returns a folder in that of a crate, such as `-cli/src`.
fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../polhode{name}"))
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let rust = files.into_iter().filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
    rust.chain(folders.iter().flat_map(|folder| sources(folder))).collect()
}

/// Returns the strings of a source file that are not in comments, with their lines.
fn literals(text: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let mut joined: Option<(usize, String)> = None;
    for (number, line) in (1..).zip(text.lines()) {
        let mut rest = if joined.is_some() { line.trim_start() } else { line };
        if joined.is_none() && line.trim_start().starts_with("//") {
            continue;
        }
        loop {
            if let Some((start, mut literal)) = joined.take() {
                // A string goes on after a backslash at the end of a line.
                let Some((end, is_closed)) = end_of_string(rest) else { break };
                literal.push_str(&rest[..end]);
                if !is_closed {
                    joined = Some((start, literal));
                    break;
                }
                found.push((start, literal.replace("\\\"", "\"").replace("\\n", "\n")));
                rest = &rest[end + 1..];
            }
            // A quote as a character is not the beginning of a string.
            let Some(open) =
                rest.match_indices('"').map(|(at, _)| at).find(|&at| !rest[..at].ends_with('\''))
            else {
                break;
            };
            joined = Some((number, String::new()));
            rest = &rest[open + 1..];
        }
    }
    found
}

/// Returns the end of a string, and true if it is a quote, false if it is the end of the line.
fn end_of_string(rest: &str) -> Option<(usize, bool)> {
    let mut escaped = false;
    for (at, c) in rest.char_indices() {
        match c {
            '"' if !escaped => return Some((at, true)),
            _ => escaped = c == '\\' && !escaped,
        }
    }
    Some((rest.len() - usize::from(rest.ends_with('\\')), false))
}
