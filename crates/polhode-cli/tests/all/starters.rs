//! `polhode new`: every example answers with the command that is printed for it, and the tutorials
//! start from the same files.

use std::fs;
use std::path::Path;

use crate::common::{Scratch, refused, stdout};

/// Name, exit status of the next command, and a part of its answer.
const STARTERS: [(&str, i32, &str); 14] = [
    ("bat", 0, "Flips every 1.612 s"),
    ("cube", 0, "I₂ = I₃ = 11/12 M b²"),
    ("top", 0, "precess"),
    ("drone", 0, "Torque N: drag"),
    ("pencil", 0, "Spin about axis 3 is stable; about axes 1 and 2 unstable"),
    ("satellite", 0, "momentum wheel"),
    ("asteroid", 0, "wrote asteroid/: summary.json, trajectory.csv"),
    ("moon", 0, "gravity gradient"),
    ("robot-link", 0, "<inertia ixx="),
    ("gripper", 1, "Not right: 1 impossible and 1 suspect finding in 3 links."),
    ("molecule", 0, "rotation         A = 77.4629,  B = 12.0812,  C = 10.4512 GHz"),
    ("parts", 0, "→ All 2 limits are met; probability"),
    ("log", 1, "→ Most likely cause: first-order integration"),
    ("sweep", 0, "have event_turned_over_count > 0"),
];

#[test]
fn every_starter_is_listed_and_answers_with_the_command_named_for_it() {
    let scratch = Scratch::new("starters");
    let list = stdout(&scratch.run(&["new"]));
    assert_eq!(list.lines().filter(|line| line.starts_with("  ")).count(), STARTERS.len(), "{list}");
    assert!(list.lines().all(|line| line.chars().count() <= 100), "{list}");
    for (name, status, answer) in STARTERS {
        let written = stdout(&scratch.run(&["new", name]));
        let next = written.lines().last().unwrap().trim();
        let line = list.lines().find(|line| line.starts_with(&format!("  {name} ")));
        assert!(line.is_some_and(|line| line.ends_with(&format!("  {next}"))), "{name}: {list}");
        let output = scratch.run(&next.split(' ').skip(1).collect::<Vec<_>>());
        let printed = String::from_utf8(output.stdout).unwrap();
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(status), "{next}\n{errors}");
        assert!(printed.contains(answer), "{next}\n{printed}");
        let refusal = refused(&scratch.run(&["new", name]), 2);
        assert!(refusal.contains("already exists") && refusal.contains("-o FILE"), "{refusal}");
    }
}

/// The comments of the examples name more commands. They succeed too.
#[test]
fn the_commands_in_the_comments_of_a_starter_succeed() {
    let scratch = Scratch::new("starter-comments");
    for (name, ..) in STARTERS {
        let written = stdout(&scratch.run(&["new", name]));
        let (files, _) = written.strip_prefix("wrote ").unwrap().split_once("; ").unwrap();
        for file in files.split(" and ") {
            let text = fs::read_to_string(scratch.0.join(file)).unwrap();
            let commands = text.lines().filter_map(|line| {
                let line = line.trim_start_matches(['#', ' ']);
                line.strip_prefix("polhode ").map(|rest| rest.split("   ").next().unwrap_or(rest).trim())
            });
            let commands: Vec<&str> = commands.collect();
            assert!(!commands.is_empty() || file.ends_with(".xyz"), "{file}");
            for command in commands.into_iter().filter(|command| !command.contains("my-robot.urdf")) {
                let output = scratch.run(&command.split(' ').collect::<Vec<_>>());
                let has_findings = ["check gripper.urdf", "judge "].iter().any(|it| command.starts_with(it));
                let errors = String::from_utf8(output.stderr).unwrap();
                let status = output.status.code();
                // The sweep of the satellite is in a comment until the user enables it.
                let expected =
                    if command.starts_with("sweep satellite") { 2 } else { i32::from(has_findings) };
                assert_eq!(status, Some(expected), "{file}: {command}\n{errors}");
            }
        }
    }
}

#[test]
fn a_starter_has_any_name_and_an_unknown_one_is_refused() {
    let scratch = Scratch::new("starter-names");
    stdout(&scratch.run(&["new", "top", "-o", "deep/er/mine.toml"]));
    let text = fs::read_to_string(scratch.0.join("deep/er/mine.toml")).unwrap();
    assert!(text.contains("polhode simulate deep/er/mine.toml --open") && !text.contains(" top.toml"));
    // The log refers to its body, which is written next to it.
    let written = stdout(&scratch.run(&["new", "log", "-o", "deep/run.csv"]));
    assert!(written.starts_with("wrote deep/run.csv and deep/free-body.toml;"), "{written}");
    let output = scratch.run(&["judge", "deep/run.csv"]);
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    refused(&scratch.run(&["new", "toaster"]), 2);
    refused(&scratch.run(&["new", "-o", "top.toml"]), 2);
}

/// The first file of each tutorial, without comments, is the starter that the tutorial names.
#[test]
fn the_first_file_of_each_tutorial_is_a_starter() {
    let book = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/tutorials");
    let scratch = Scratch::new("starter-tutorials");
    for (tutorial, starter, file) in [
        ("student", "cube", "cube.toml"),
        ("spacecraft-engineer", "pencil", "pencil.toml"),
        ("robot-engineer", "gripper", "gripper.urdf"),
        ("planetary-scientist", "moon", "moon.toml"),
        ("chemist", "molecule", "molecule.xyz"),
    ] {
        let page = fs::read_to_string(book.join(format!("{tutorial}.md"))).unwrap();
        assert!(page.contains(&format!("`polhode new {starter}")), "{tutorial}");
        let languages = ["toml", "xml", "xyz"].map(|language| format!("```{language}\n"));
        let starts = languages.iter().filter_map(|open| Some(page.find(open)? + open.len()));
        let first = starts.min().map(|start| page[start..].split("```").next().unwrap()).unwrap();
        stdout(&scratch.run(&["new", starter]));
        let written = fs::read_to_string(scratch.0.join(file)).unwrap();
        assert_eq!(without_comments(&written), without_comments(first), "{tutorial}");
    }
    let page = fs::read_to_string(book.join("physics-engine-author.md")).unwrap();
    assert!(page.contains("`polhode new log`"));
    let page = fs::read_to_string(book.join("student.md")).unwrap();
    assert!(page.contains("`polhode new bat`"));
}

/// Returns the lines of a file without comments, titles of molecules, and blank lines.
fn without_comments(text: &str) -> Vec<String> {
    let mut text = text.to_owned();
    while let Some(start) = text.find("<!--") {
        let end = text[start..].find("-->").unwrap() + start + 3;
        text.replace_range(start..end, "");
    }
    let is_molecule = text.starts_with('5');
    let lines = text.lines().enumerate().filter(|(i, _)| !(is_molecule && *i == 1));
    let lines = lines.map(|(_, line)| line.split('#').next().unwrap_or_default().trim_end().to_owned());
    lines.filter(|line| !line.is_empty()).collect()
}
