//! `polhode budget --diff`: everything that a list can say is compared.

mod cases;
mod rich;

use std::collections::BTreeSet;

use polhode_formats::FormatErrorKind;
use polhode_formats::budget::from_text;

use crate::common::{Scratch, stdout};
use cases::CASES;
use rich::{GRAINS, PARTS, RICH};

/// What only says how the file is read shows in what it reads, if that changes.
const OF_READING: [&str; 3] = ["decimal", "ignore", "cad"];

fn list(rich: &str) -> String {
    let (head, parts) = rich.split_once("name,parent,").unwrap();
    let head: String = head.lines().map(|line| format!("# {line}\n")).collect();
    format!("{head}name,parent,{parts}")
}

#[test]
fn every_key_and_column_is_compared() {
    let scratch = Scratch::new("budget-diff-rich");
    let rich = format!("{RICH}{PARTS}");
    GRAINS.iter().for_each(|(name, table)| scratch.write(name, table));
    scratch.write("before.csv", &list(&rich));
    let diff = |text: &str| {
        scratch.write("after.csv", &list(text));
        let said = stdout(&scratch.run(&["budget", "after.csv", "--diff", "before.csv", "--markdown"]));
        let plain = said.replace(['|', '\u{a0}'], " ").replace('\\', "");
        plain.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let same = diff(&rich);
    assert!(
        same.contains("no row changed; the mass is the same") && !same.contains("besides the rows"),
        "{same}"
    );
    for (section, key, changes, expected) in CASES {
        let changed = changes.iter().fold(rich.clone(), |text, (from, to)| {
            assert!(text.contains(from), "{section} {key}: {from}");
            text.replace(from, to)
        });
        let said = diff(&changed);
        for words in *expected {
            assert!(said.contains(words), "{section} {key}: {words}: {said}");
        }
    }
}

/// All keys that the reader knows are in the cases above, but for sections, which have keys.
#[test]
fn no_key_is_left_out() {
    let scratch = Scratch::new("budget-diff-keys");
    GRAINS.iter().for_each(|(name, table)| scratch.write(name, table));
    let rich = format!("{RICH}{PARTS}");
    let sections: BTreeSet<&str> = RICH.lines().filter(|line| line.starts_with('[')).collect();
    for section in sections.iter().copied().filter(|section| *section != "[growth]").chain([""]) {
        let text = match section {
            "" => format!("zzz = 1\n{rich}"),
            section => rich.replacen(&format!("{section}\n"), &format!("{section}\nzzz = 1\n"), 1),
        };
        let error = from_text(&scratch.0.join("rich.csv"), &list(&text)).unwrap_err();
        let FormatErrorKind::UnknownKey { known, .. } = error.kind() else { panic!("{section}: {error}") };
        for key in known.iter().filter(|key| !section.is_empty() || !OF_READING.contains(*key)) {
            let is_section = |name: &str| {
                sections.contains(format!("[{name}]").as_str())
                    || sections.contains(format!("[[{name}]]").as_str())
            };
            let is_changed = CASES.iter().any(|(of, name, ..)| *of == section && name == key);
            assert!(is_changed || (section.is_empty() && is_section(key)), "{section} {key}");
        }
    }
}
