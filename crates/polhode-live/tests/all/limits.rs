//! Limits of the files of a session.

use std::fs::File;

use polhode_live::{Live, LiveOptions};

use crate::client::{Folder, Page};
use crate::models::SCENARIO;

/// Makes a file of zeros that takes no place on the disk.
fn sparse(folder: &Folder, name: &str, length: u64) {
    File::create(folder.0.join(name)).unwrap().set_len(length).unwrap();
}

#[track_caller]
fn refused(folder: &Folder, name: &str, says: [&str; 2]) {
    let options = LiveOptions { files: vec![folder.0.join(name)], ..LiveOptions::default() };
    let error = Live::bind(&options).unwrap_err().to_string();
    assert!(says.iter().all(|words| error.contains(words)), "{error}");
}

#[test]
fn a_file_that_is_too_large_is_named() {
    let folder = Folder::new("large");
    sparse(&folder, "large.stl", (256 << 20) + 1);
    refused(&folder, "large.stl", ["large.stl exceeds a limit", "at most 256 MiB"]);
    // A title that is the name of a file counts as that file.
    folder.file("names.toml", format!("title = \"large.stl\"\n{SCENARIO}"));
    refused(&folder, "names.toml", ["large.stl exceeds a limit", "at most 256 MiB"]);
}

#[test]
fn files_that_are_too_large_together_are_named() {
    let folder = Folder::new("together");
    let names = ["a", "b", "c", "d", "e"];
    names.iter().for_each(|name| sparse(&folder, name, 210 << 20));
    let part = |name: &&str| format!("[[body.part]]\nname = \"{name}\"\n");
    folder.file("five.toml", names.iter().map(part).collect::<String>());
    refused(&folder, "five.toml", ["e exceeds a limit", "1024 MiB together"]);
}

#[test]
fn one_file_too_many_is_named() {
    let folder = Folder::new("many");
    let part = |k: usize| {
        folder.file(&format!("m{k:04}"), "");
        format!("[[body.part]]\nname = \"m{k:04}\"\n")
    };
    let text: String = (0..4_000).map(part).collect();
    folder.file("many.toml", &text);
    // The scenario is the first of 4001 files.
    refused(&folder, "many.toml", ["many.toml exceeds a limit", "at most 4000 files"]);
    folder.file("fewer.toml", text.rsplit_once("[[").unwrap().0);
    assert_eq!(Page::open(&[folder.0.join("fewer.toml")]).pack().files.len(), 4_000);
}
