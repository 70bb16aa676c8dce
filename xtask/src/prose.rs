//! Wording of comments, messages and pages: counts of the patterns that make readers read twice.
//!
//! `xtask/prose.txt` has the largest count of each pattern that is allowed. No change may raise a
//! count; a change that lowers one takes the lower count over with `cargo xtask prose --write`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::{Outcome, files, read, root, short};

/// Longest text of a comment line, without indentation.
const LONGEST: usize = 100;

/// First words that leave a doc comment without a subject.
const HEADLESS: [&str; 23] = [
    "What", "Of", "Where", "Which", "Those", "By", "As", "Why", "How", "Whether", "With", "From", "To", "In",
    "On", "At", "For", "That", "Beside", "Through", "Off", "Among", "Between",
];

/// Idioms that are not English of the field.
const IDIOMS: [&str; 15] = [
    "what is left",
    "what it is made of",
    "what becomes of",
    "so many",
    "but for",
    "anew",
    "beside",
    "mends",
    "is asked",
    "is told",
    "are asked",
    "are told",
    "of itself",
    "well-kept",
    "goes astray",
];

/// Items that need a doc comment where they are public; fields, variants and modules may do without.
const ITEMS: [&str; 8] = ["fn", "struct", "enum", "trait", "type", "const", "static", "union"];

/// A place with a pattern: `crates/polhode/src/lib.rs:12: …`.
type Places = BTreeMap<&'static str, Vec<String>>;

/// Compares the counts with those allowed.
pub(crate) fn check() -> Outcome {
    let (places, allowed) = (places()?, allowed()?);
    let mut wrong = Vec::new();
    for (pattern, places) in &places {
        let most = allowed.get(*pattern).copied().unwrap_or_default();
        println!("   {pattern:<16} {:>5} of {most}", places.len());
        if places.len() > most {
            wrong.push(format!("{} places with `{pattern}`, {most} allowed", places.len()));
        }
    }
    match wrong[..] {
        [] => Ok(()),
        _ => Err(format!("{}; `cargo xtask prose --list PATTERN` lists them", wrong.join("; "))),
    }
}

/// Prints the places of one pattern.
pub(crate) fn list(pattern: &str) -> Outcome {
    let mut places = places()?;
    let known: Vec<&str> = places.keys().copied().collect();
    let known = known.join(", ");
    let found = places.remove(pattern);
    found
        .map(|places| places.iter().for_each(|place| println!("{place}")))
        .ok_or_else(|| format!("unknown pattern `{pattern}`; expected one of: {known}"))
}

/// Writes the present counts as those allowed.
pub(crate) fn write() -> Outcome {
    let lines = places()?.into_iter().map(|(pattern, places)| format!("{pattern}: {}\n", places.len()));
    let path = counts();
    std::fs::write(&path, lines.collect::<String>()).map_err(|error| format!("{}: {error}", short(&path)))
}

fn counts() -> PathBuf {
    root().join("xtask/prose.txt")
}

fn allowed() -> Result<BTreeMap<String, usize>, String> {
    let path = counts();
    let text = read(&path)?;
    let count = |line: &str| {
        let (pattern, count) = line.split_once(": ")?;
        Some((pattern.to_owned(), count.parse().ok()?))
    };
    let counts = text.lines().map(|line| count(line).ok_or_else(|| format!("{}: {line}", short(&path))));
    counts.collect()
}

fn places() -> Result<Places, String> {
    let mut places: Places =
        ["headless", "idiom", "long line", "name in prose", "undocumented"].map(|p| (p, Vec::new())).into();
    for folder in ["crates", "xtask"] {
        for path in files(&root().join(folder), "rs")? {
            if !path.components().any(|part| part.as_os_str() == "target") {
                rust(&path, &read(&path)?, &mut places);
            }
        }
    }
    for path in files(&root().join("book"), "md")? {
        for (n, line) in read(&path)?.lines().enumerate() {
            note_idioms(&path, n, line, &mut places);
        }
    }
    Ok(places)
}

/// Finds the patterns in a file of Rust.
fn rust(path: &Path, text: &str, places: &mut Places) {
    let (mut starts, mut is_code, mut has_doc) = (true, false, false);
    for (n, line) in text.lines().enumerate() {
        let line = line.trim_start();
        let Some(comment) = line.strip_prefix("//") else {
            let is_source = path.components().any(|part| part.as_os_str() == "src");
            if is_source && !has_doc && is_public_item(line) {
                put("undocumented", path, n, line, places);
            }
            has_doc &= line.starts_with('#') || line.starts_with(['"', ')', ']']);
            (starts, is_code) = (true, false);
            if line.contains('"') {
                note_idioms(path, n, line, places);
            }
            continue;
        };
        let doc = comment.strip_prefix(['/', '!']);
        has_doc |= doc.is_some();
        let prose = doc.unwrap_or(comment).trim_start();
        if prose.starts_with("```") {
            is_code = !is_code;
        } else if !is_code {
            if doc.is_some() && starts && is_headless(prose) {
                put("headless", path, n, prose, places);
            }
            if prose.chars().count() > LONGEST {
                put("long line", path, n, prose, places);
            }
            if has_bare_name(prose) {
                put("name in prose", path, n, prose, places);
            }
            note_idioms(path, n, prose, places);
        }
        starts = prose.is_empty();
    }
}

fn put(pattern: &'static str, path: &Path, n: usize, text: &str, places: &mut Places) {
    places.entry(pattern).or_default().push(format!("{}:{}: {text}", short(path), n + 1));
}

fn note_idioms(path: &Path, n: usize, text: &str, places: &mut Places) {
    if IDIOMS.iter().any(|idiom| has_words(text, idiom)) {
        put("idiom", path, n, text, places);
    }
}

/// Returns true if a text has these words as whole words.
fn has_words(text: &str, words: &str) -> bool {
    text.match_indices(words).any(|(at, _)| {
        let [before, after] = [text[..at].chars().next_back(), text[at + words.len()..].chars().next()];
        [before, after].into_iter().flatten().all(|c| !c.is_alphanumeric() && c != '_')
    })
}

fn is_headless(prose: &str) -> bool {
    let first = prose.split_whitespace().next().unwrap_or_default();
    HEADLESS.contains(&first) && !prose.starts_with("How many") && !prose.starts_with("How long")
}

/// Returns true if a word of a sentence is an identifier outside of backticks, links and formulas.
fn has_bare_name(prose: &str) -> bool {
    let outside = prose.split('`').step_by(2);
    outside.flat_map(str::split_whitespace).any(|word| {
        let word = word.trim_matches(['.', ',', ';', ':']);
        let is_name = word.chars().all(|c| c.is_ascii_lowercase() || c == '_');
        // `x_i` is a symbol with an index.
        is_name && word.contains('_') && word.split('_').all(|part| part.len() > 1)
    })
}

fn is_public_item(line: &str) -> bool {
    let mut words = line.split_whitespace();
    words.next() == Some("pub")
        && words
            .find(|word| !matches!(*word, "unsafe" | "async" | "extern"))
            .is_some_and(|word| ITEMS.contains(&word))
        && !line.contains('$')
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the patterns found in a text.
    fn found(text: &str) -> Vec<&'static str> {
        let mut places = Places::new();
        rust(Path::new("src/a.rs"), text, &mut places);
        places.into_keys().collect()
    }

    #[test]
    fn each_pattern_is_found_and_its_correction_passes() {
        for (pattern, wrong, right) in [
            ("headless", "/// What the mass is.", "/// Mass, kg."),
            ("idiom", "// What is left: so many rows.", "// The remainder: this many rows."),
            ("idiom", r#"let m = "the value is told";"#, r#"let m = "the value is printed";"#),
            ("name in prose", "/// Sum of sums_before and x.", "/// Sum of `sums_before` and x."),
            ("undocumented", "pub fn mass() {}", "/// Mass, kg.\n#[must_use]\npub fn mass() {}"),
            ("undocumented", "pub const fn mass() {}", "pub(crate) const fn mass() {}"),
        ] {
            assert_eq!(found(wrong), [pattern], "{wrong}");
            assert!(found(right).is_empty(), "{right}");
        }
        assert_eq!(found(&format!("// {}", "x ".repeat(60))), ["long line"]);
    }

    #[test]
    fn code_in_documentation_is_not_prose() {
        assert!(found("/// Adds.\n/// ```\n/// let so_many = add(so many);\n/// ```").is_empty());
        assert!(found("/// Beta of a fobeside word.").is_empty());
    }
}
