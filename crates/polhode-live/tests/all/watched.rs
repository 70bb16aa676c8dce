//! Files that are written to while they are served.

use std::fs;
use std::time::{Duration, Instant};

use crate::client::{Folder, Pack, Page};
use crate::models::{SCENARIO, SOLID, model};

/// Waits until the pack meets a condition.
#[track_caller]
fn until(page: &Page, what: &str, condition: impl Fn(&Pack) -> bool) {
    let begun = Instant::now();
    while !condition(&page.pack()) {
        assert!(begun.elapsed() < Duration::from_secs(10), "{what}: {:?}", page.pack());
        std::thread::sleep(Duration::from_millis(20));
    }
}

fn contents<'a>(pack: &'a Pack, folder: &Folder, name: &str) -> Option<&'a [u8]> {
    let path = folder.path(name);
    pack.files.iter().find(|file| file.0 == path).map(|file| &file.1[..])
}

#[test]
fn the_pack_is_that_of_the_files_as_they_are_now() {
    let folder = model("watched");
    let page = Page::open(&[folder.0.join("scenarios/one.toml")]);
    let etag = || page.get("files").headers["etag"].clone();
    let first = etag();
    assert_eq!(etag(), first);
    // A mesh is written to.
    let larger = SOLID.replace("1.9", "2.3");
    folder.file("meshes/solid.obj", &larger);
    until(&page, "mesh", |pack| contents(pack, &folder, "meshes/solid.obj") == Some(larger.as_bytes()));
    assert_ne!(etag(), first);
    folder.file("meshes/solid.obj", SOLID);
    until(&page, "mesh", |pack| contents(pack, &folder, "meshes/solid.obj") == Some(SOLID.as_bytes()));
    assert_eq!(etag(), first);
    // The scenario names another mesh, which does not exist yet.
    let other = SCENARIO.replace("solid.obj", "other.obj");
    folder.file("scenarios/one.toml", &other);
    until(&page, "scenario", |pack| pack.paths() == [folder.path("scenarios/one.toml")]);
    folder.file("meshes/other.obj", SOLID);
    until(&page, "other mesh", |pack| contents(pack, &folder, "meshes/other.obj") == Some(SOLID.as_bytes()));
    // A wrong text is served, as the page shows its errors.
    folder.file("scenarios/one.toml", "[[[");
    until(&page, "wrong", |pack| contents(pack, &folder, "scenarios/one.toml") == Some(b"[[["));
}

#[test]
fn a_file_that_is_replaced_or_missing_for_a_moment_stays() {
    let folder = model("replaced");
    let path = folder.0.join("scenarios/one.toml");
    let page = Page::open(std::slice::from_ref(&path));
    let first = page.pack();
    // A program saves a file by renaming another one.
    let heavier = SCENARIO.replace("1.5", "2.25");
    fs::rename(folder.file("scenarios/.one.toml.new", &heavier), &path).unwrap();
    until(&page, "renamed", |pack| contents(pack, &folder, "scenarios/one.toml") == Some(heavier.as_bytes()));
    // While the file is missing, the last pack is served.
    fs::remove_file(&path).unwrap();
    for _ in 0..3 {
        assert_eq!(contents(&page.pack(), &folder, "scenarios/one.toml"), Some(heavier.as_bytes()));
    }
    folder.file("scenarios/one.toml", SCENARIO);
    until(&page, "again", |pack| *pack == first);
    // A mesh is missing for less time than a program takes to rename a file.
    let mesh = folder.0.join("meshes/solid.obj");
    fs::rename(&mesh, folder.0.join("meshes/old.obj")).unwrap();
    let poll = std::thread::spawn(move || page.pack());
    std::thread::sleep(Duration::from_millis(20));
    fs::rename(folder.0.join("meshes/old.obj"), &mesh).unwrap();
    assert_eq!(poll.join().unwrap(), first);
}

#[test]
fn a_mesh_that_is_half_written_is_not_served() {
    let folder = model("half");
    let page = Page::open(&[folder.0.join("meshes/solid.obj")]);
    let first = page.pack();
    folder.file("meshes/solid.obj", &SOLID[..SOLID.len() - 3]);
    std::thread::sleep(Duration::from_millis(50));
    assert_eq!(page.pack(), first);
    let larger = SOLID.replace("1.9", "2.3");
    folder.file("meshes/solid.obj", &larger);
    until(&page, "whole", |pack| contents(pack, &folder, "meshes/solid.obj") == Some(larger.as_bytes()));
}
