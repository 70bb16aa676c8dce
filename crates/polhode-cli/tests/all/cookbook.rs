//! Runs the README, the first steps, the cookbook and the tutorials, and compares the output with
//! the pages.

use std::fs;
use std::path::{Path, PathBuf};

use crate::common::recipe::follow;
use crate::common::{Scratch, entries};

/// Folder of pages to run, the page that lists them, and their minimum number.
struct Pages {
    folder: &'static str,
    index: &'static str,
    least: usize,
}

const COOKBOOK: Pages = Pages { folder: "book/cookbook", index: "book/cookbook/README.md", least: 15 };
const TUTORIALS: Pages = Pages { folder: "book/tutorials", index: "book/README.md", least: 6 };

/// Instructions for coding agents.
const SKILL: &str = "integrations/skill/polhode/SKILL.md";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn the_pages_of_the_cookbook_are_what_their_commands_print() {
    follow_all(&COOKBOOK);
}

#[test]
fn the_tutorials_are_what_their_commands_print() {
    follow_all(&TUTORIALS);
}

#[test]
fn the_readme_and_the_first_steps_are_what_their_commands_print() {
    for page in ["README.md", "book/start.md", SKILL] {
        let scratch = Scratch::new(&format!("page-{}", page.replace('/', "-")));
        copy(&root().join("examples"), &scratch.0.join("examples"));
        let followed = follow(&root().join(page), &scratch);
        // The skill states where to read in the output, and shows none.
        let shows = page == SKILL || followed.excerpts > 0;
        assert!(followed.commands > 0 && shows, "{page} shows no command and what it prints");
    }
}

/// The format limits a skill: <https://agentskills.io/specification>.
#[test]
fn the_skill_has_the_form_of_skills() {
    let text = fs::read_to_string(root().join(SKILL)).unwrap();
    let (front, body) = text.strip_prefix("---\n").unwrap().split_once("\n---\n").unwrap();
    let [name, description] = front.lines().collect::<Vec<_>>().try_into().unwrap();
    let (name, description) = (name.strip_prefix("name: "), description.strip_prefix("description: "));
    assert_eq!(name, Path::new(SKILL).parent().and_then(Path::file_name).and_then(|name| name.to_str()));
    // A colon and a blank would begin another value in YAML.
    assert!(description.is_some_and(|text| text.chars().count() <= 1024 && !text.contains(": ")));
    assert!(body.lines().count() <= 120);
}

fn follow_all(Pages { folder, index, least }: &Pages) {
    let listed = fs::read_to_string(root().join(index)).unwrap();
    let folder = root().join(folder);
    let pages: Vec<String> = entries(&folder).into_iter().filter(|name| name != "README.md").collect();
    assert!(pages.len() >= *least, "{} pages", pages.len());
    for page in pages {
        assert!(
            listed.contains(&format!("({page})")) || listed.contains(&format!("(tutorials/{page})")),
            "{page} is not in {index}"
        );
        let scratch = Scratch::new(&format!("page-{page}"));
        copy(&root().join("examples"), &scratch.0.join("examples"));
        let followed = follow(&folder.join(&page), &scratch);
        assert!(followed.commands > 0 && followed.excerpts > 0, "{page} shows no command and what it prints");
    }
}

#[test]
fn the_links_of_the_pages_lead_somewhere() {
    for pages in [COOKBOOK, TUTORIALS] {
        let count = links(&root().join(pages.folder));
        assert!(count > pages.least, "{count} links");
    }
}

/// The gallery commands use scenarios that `cargo xtask examples` simulates: those with a `[run]`.
#[test]
fn each_motion_of_the_gallery_has_its_picture_scenario_and_command() {
    let page = fs::read_to_string(root().join("book/gallery.md")).unwrap();
    let motions: Vec<&str> = page.split("\n### ").skip(1).collect();
    assert!(motions.len() >= 20, "{} motions", motions.len());
    for motion in motions {
        let (_, rest) =
            motion.split_once("`polhode simulate ").unwrap_or_else(|| panic!("no command: {motion}"));
        let (example, _) = rest.split_once(" --open`").unwrap_or_else(|| panic!("no command: {motion}"));
        let stem = Path::new(example).file_stem().unwrap().to_str().unwrap();
        assert!(motion.contains(&format!("](gallery/{stem}.webp)")), "{motion}");
        assert!(motion.contains(&format!("[{stem}.toml](../{example})")), "{motion}");
        let scenario = fs::read_to_string(root().join(example)).unwrap();
        assert!(scenario.lines().any(|line| line == "[run]"), "{example} has no motion");
    }
}

/// Checks the links of all pages of a folder; returns their number.
fn links(folder: &Path) -> usize {
    let mut count = 0;
    for page in entries(folder) {
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
    count
}

/// Returns the link anchor of a heading.
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
