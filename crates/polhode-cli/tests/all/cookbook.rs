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
