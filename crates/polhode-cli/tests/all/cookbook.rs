//! The cookbook: every page is followed, and its output is what the page says.

use std::fs;
use std::path::{Path, PathBuf};

use crate::common::recipe::follow;
use crate::common::{Scratch, entries};

/// How many pages it has at least.
const PAGES: usize = 15;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn the_pages_of_the_cookbook_are_what_their_commands_print() {
    let folder = root().join("book/cookbook");
    let pages: Vec<String> = entries(&folder).into_iter().filter(|name| name != "README.md").collect();
    assert!(pages.len() >= PAGES, "{} pages", pages.len());
    let index = fs::read_to_string(folder.join("README.md")).unwrap();
    for page in pages {
        assert!(index.contains(&format!("({page})")), "{page} is not in the index");
        let scratch = Scratch::new(&format!("cookbook-{page}"));
        copy(&root().join("examples"), &scratch.0.join("examples"));
        let followed = follow(&folder.join(&page), &scratch);
        assert!(followed.commands > 0 && followed.excerpts > 0, "{page} shows no command and what it prints");
    }
}

#[test]
fn the_links_of_the_cookbook_lead_somewhere() {
    let folder = root().join("book/cookbook");
    let mut count = 0;
    for page in entries(&folder) {
        let text = fs::read_to_string(folder.join(&page)).unwrap();
        let targets = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
        for target in targets.filter(|target| !target.starts_with("https:")) {
            let (file, heading) = target.split_once('#').unwrap_or((target, ""));
            let path = folder.join(file);
            assert!(path.is_file(), "{page}: {target}");
            let there = || fs::read_to_string(&path).unwrap().lines().any(|line| anchor(line) == heading);
            assert!(heading.is_empty() || there(), "{page}: {target}");
            count += 1;
        }
    }
    assert!(count > PAGES, "{count} links");
}

/// What follows the `#` of a link to a heading.
fn anchor(line: &str) -> String {
    let text = line.strip_prefix('#').unwrap_or_default().trim_start_matches('#').trim();
    let kept = text.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let (from, to) = (entry.as_ref().unwrap().path(), to.join(entry.unwrap().file_name()));
        if from.is_dir() {
            copy(&from, &to);
        } else {
            fs::copy(&from, &to).unwrap();
        }
    }
}
