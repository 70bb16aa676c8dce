//! `polhode sweep` from the user's side.

use std::fs;
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::Duration;

use crate::common::{Scratch, entries, json, number, refused, stdout};

const BRICK: &str = r#"
title = "Bricks, thrown"
[[body.part]]
name = "brick"
shape = "box"
size = ["200 mm", "100 mm", "60 mm"]
mass = "2.16 kg"
[start]
spin = { body = [0.3, 2.0, 0.1] }
[run]
duration = "3 s"
samples = 31
"#;

fn plan(members: u64) -> String {
    format!(
        r#"{BRICK}
[sweep]
members = {members}
sampling = "monte carlo"
seed = 2
[[sweep.vary]]
key = "start.spin.body[0]"
normal = {{ mean = 0.3, sd = 1.5 }}
[[sweep.vary]]
key = 'body.part["brick"].mass'
uniform = {{ from = "2 kg", to = "3 kg" }}
"#
    )
}

#[test]
fn a_sweep_is_one_command() {
    let scratch = Scratch::new("sweep");
    scratch.write("bricks.toml", &plan(700));
    let text = stdout(&scratch.run(&["sweep", "bricks.toml"]));
    assert!(text.contains("Bricks, thrown   700 members") && text.contains("short_axis"), "{text}");
    assert!(text.contains("± ") && text.contains("wrote bricks/: summary.json"), "{text}");
    let wide: Vec<_> = text.lines().filter(|line| line.chars().count() > 110).collect();
    assert!(wide.is_empty(), "{wide:?}");
    let files =
        ["histograms.svg", "members", "pairs.svg", "plan.toml", "summary.json", "sweep.json", "sweep.lock"];
    assert_eq!(entries(&scratch.0.join("bricks")), files);
    assert_eq!(fs::read_to_string(scratch.0.join("bricks/plan.toml")).unwrap(), plan(700));

    let again = scratch.run(&["sweep", "bricks.toml"]);
    let error = refused(&again, 2);
    assert!(error.contains("bricks already exists") && error.contains("--resume"), "{error}");
    // What is complete has nothing to go on with, and says the same.
    assert_eq!(stdout(&scratch.run(&["sweep", "bricks.toml", "--resume"])), text);
    let summary = json(&scratch.run(&["sweep", "bricks.toml", "--force", "--threads", "1", "--json"]));
    let written = fs::read_to_string(scratch.0.join("bricks/summary.json")).unwrap();
    assert_eq!(serde_json::from_str::<serde_json::Value>(&written).unwrap(), summary);
    assert_eq!(number(&summary["members"]), 700.0);
    assert_eq!(number(&summary["status"]["complete"]["count"]), 700.0);
    let period = &summary["outcomes"]["period_s"];
    assert!(number(&period["min"]) <= number(&period["quantiles"]["0.5"]["value"]));
}

#[test]
fn a_member_that_cannot_be_is_a_row_and_the_rest_goes_on() {
    let scratch = Scratch::new("sweep-failed");
    // Some members are unphysical: one moment exceeds the sum of the others.
    let text = plan(64)
        .replace(
            "shape = \"box\"\nsize = [\"200 mm\", \"100 mm\", \"60 mm\"]",
            "shape = \"tensor\"\nmoments = [1, 2, 2.5]",
        )
        .replace("'body.part[\"brick\"].mass'", "'body.part[\"brick\"].moments[2]'")
        .replace("from = \"2 kg\", to = \"3 kg\"", "from = 2, to = 4");
    scratch.write("plan.toml", &text);
    let summary = json(&scratch.run(&["sweep", "plan.toml", "--json"]));
    let count = |status: &str| number(&summary["status"][status]["count"]);
    assert!(count("failed") > 16.0 && count("complete") > 16.0, "{}", summary["status"]);
    assert_eq!(count("failed") + count("complete"), 64.0);
    assert_eq!(number(&summary["outcomes"]["period_s"]["count"]), count("complete"));
    assert!(number(&summary["outcomes"]["moment_3_kg_m2"]["max"]) <= 3.0 + 1e-12);
    let failures = summary["failures"].as_array().unwrap();
    assert!(failures.len() == 5 && failures[0]["cause"].as_str().unwrap().len() > 10, "{failures:?}");
}

#[test]
fn what_is_wrong_is_said_and_writes_nothing() {
    let scratch = Scratch::new("sweep-wrong");
    scratch.write("brick.toml", BRICK);
    scratch.write("no-run.toml", &plan(10).replace("[run]\nduration = \"3 s\"\nsamples = 31\n", ""));
    scratch.write("plan.toml", &plan(10));
    let said = |arguments: &[&str], says: &str| {
        let error = refused(&scratch.run(arguments), 2);
        assert!(error.contains(says), "{arguments:?}: {error}");
    };
    said(&["sweep", "brick.toml"], "[sweep]");
    said(&["sweep", "no-run.toml"], "no [run] section");
    said(&["sweep", "none.toml"], "none.toml");
    said(&["sweep", "plan.toml", "-o", "brick.toml", "--force"], "it is not a folder");
    fs::create_dir(scratch.0.join("photos")).unwrap();
    scratch.write("photos/cat.jpg", "a cat");
    said(&["sweep", "plan.toml", "-o", "photos", "--force"], "cat.jpg");
    said(&["sweep", "plan.toml", "-o", "photos", "--resume"], "cat.jpg");
    assert_eq!(entries(&scratch.0.join("photos")), ["cat.jpg"]);
    assert_eq!(scratch.entries(), ["brick.toml", "no-run.toml", "photos", "plan.toml"]);
    for wrong in [["--on", "http://x:1"], ["--threads", "0"]] {
        let output = scratch.run(&["sweep", "plan.toml", wrong[0], wrong[1]]);
        assert_eq!(output.status.code(), Some(2));
    }
}

#[test]
fn another_plan_does_not_go_on() {
    let scratch = Scratch::new("sweep-changed");
    scratch.write("plan.toml", &plan(30));
    stdout(&scratch.run(&["sweep", "plan.toml", "-o", "out"]));
    scratch.write("plan.toml", &plan(30).replace("sd = 1.5", "sd = 1.6"));
    let error = refused(&scratch.run(&["sweep", "plan.toml", "-o", "out", "--resume"]), 2);
    assert!(
        error.contains("out contains the results of another plan") && error.contains("--force"),
        "{error}"
    );
    stdout(&scratch.run(&["sweep", "plan.toml", "-o", "out", "--force"]));
}

/// A limit on file sizes below that of a part simulates a full disk.
#[test]
#[cfg(unix)]
fn what_cannot_be_written_is_said_and_can_go_on() {
    let scratch = Scratch::new("sweep-full");
    scratch.write("plan.toml", &plan(600));
    let limited = "trap '' XFSZ; ulimit -f 40; exec \"$0\" sweep plan.toml -o out";
    let mut command = std::process::Command::new("sh");
    command.args(["-c", limited, env!("CARGO_BIN_EXE_polhode")]).current_dir(&scratch.0);
    let error = refused(&command.output().unwrap(), 2);
    assert!(error.contains("cannot write out/members/part-0000"), "{error}");
    assert!(entries(&scratch.0.join("out/members")).is_empty());
    stdout(&scratch.run(&["sweep", "plan.toml", "-o", "out", "--resume"]));
}

/// A long sweep, ended when dropped.
struct Running(Child);

impl Running {
    fn new(scratch: &Scratch, arguments: &[&str]) -> Self {
        let mut command = scratch.command(arguments);
        Self(command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap())
    }

    /// Waits for a part while it is computed, without a time limit.
    fn until(&mut self, scratch: &Scratch, part: &str) {
        let part = scratch.0.join("out/members").join(part);
        while !part.exists() {
            assert_eq!(self.0.try_wait().unwrap(), None, "it is over without {part:?}");
            sleep(Duration::from_millis(10));
        }
    }

    #[cfg(unix)]
    fn signal(&self, name: &str) {
        let pid = self.0.id().to_string();
        assert!(std::process::Command::new("kill").args([name, &pid]).status().unwrap().success());
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn two_writers_lock_each_other_out() {
    let scratch = Scratch::new("sweep-two");
    scratch.write("plan.toml", &plan(800_000));
    let mut first = Running::new(&scratch, &["sweep", "plan.toml", "-o", "out", "--threads", "1"]);
    first.until(&scratch, "part-00000.parquet");
    // A stopped process cannot finish before the others have tried, and keeps its lock.
    #[cfg(unix)]
    first.signal("-STOP");
    for how in ["--resume", "--force"] {
        let error = refused(&scratch.run(&["sweep", "plan.toml", "-o", "out", how]), 2);
        assert!(error.contains("out is in use by another sweep"), "{error}");
    }
    // The lock is released when the process ends in any way; then another one may write.
    first.0.kill().unwrap();
    first.0.wait().unwrap();
    let mut second =
        Running::new(&scratch, &["sweep", "plan.toml", "-o", "out", "--resume", "--threads", "1"]);
    second.until(&scratch, "part-00001.parquet");
}

#[test]
#[cfg(unix)]
fn ctrl_c_finishes_the_parts_in_hand() {
    let scratch = Scratch::new("sweep-stop");
    scratch.write("plan.toml", &plan(2_000_000));
    let mut running = Running::new(&scratch, &["sweep", "plan.toml", "-o", "out"]);
    running.until(&scratch, "part-00000.parquet");
    running.signal("-INT");
    let status = running.0.wait().unwrap();
    assert_eq!(status.code(), Some(130));
    let mut said = String::new();
    std::io::Read::read_to_string(running.0.stderr.as_mut().unwrap(), &mut said).unwrap();
    assert!(said.starts_with("stopped: ") && said.contains("of 2000000 members are in out"), "{said}");
    assert!(said.contains("polhode sweep plan.toml -o out --resume"), "{said}");
    let names = entries(&scratch.0.join("out/members"));
    assert!(!names.is_empty() && names.iter().all(|name| name.ends_with(".parquet")), "{names:?}");
}

#[test]
fn without_python_a_cluster_is_explained() {
    let scratch = Scratch::new("sweep-on");
    scratch.write("plan.toml", &plan(10));
    let mut command = scratch.command(&["sweep", "plan.toml", "--on", "ray://127.0.0.1:10001"]);
    let error = refused(&command.env("PATH", "").output().unwrap(), 2);
    assert!(
        error.contains("python3 is not in the PATH")
            && error.contains("'ray[data,client]' ./crates/polhode-py"),
        "{error}"
    );
    assert_eq!(scratch.entries(), ["plan.toml"]);
}

/// The test provides a `python3` that prints its arguments.
#[test]
#[cfg(unix)]
fn a_cluster_is_handed_the_same_arguments() {
    use std::os::unix::fs::PermissionsExt as _;
    let scratch = Scratch::new("sweep-python");
    scratch.write("plan.toml", &plan(10));
    fs::create_dir(scratch.0.join("bin")).unwrap();
    let python = |script: &str| {
        let path = scratch.0.join("bin/python3");
        fs::write(&path, format!("#!/bin/sh\n{script}\n")).unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    };
    let run = |more: &[&str]| {
        let arguments = [&["sweep", "plan.toml", "-o", "out", "--on", "dask://h:8786"], more].concat();
        scratch.command(&arguments).env("PATH", scratch.0.join("bin")).output().unwrap()
    };
    python("[ \"$1\" = -c ] || echo \"$@\"");
    let asked = stdout(&run(&["--resume", "--json"]));
    assert_eq!(asked, "-m polhode.sweep plan.toml -o out --on dask://h:8786 --resume --json\n");
    python("[ \"$1\" = -c ] || exit 3");
    assert_eq!(run(&[]).status.code(), Some(3));
    // Only the missing package is named.
    python("[ \"$1\" = -c ] && echo pyarrow");
    let error = refused(&run(&[]), 2);
    assert!(
        error.contains("not installed for this python3: pyarrow\n")
            && error.contains("pip install pyarrow\n"),
        "{error}"
    );
    python("[ \"$1\" = -c ] && echo distributed polhode");
    let error = refused(&run(&[]), 2);
    assert!(
        error.contains("distributed, polhode\n") && error.contains("distributed ./crates/polhode-py\n"),
        "{error}"
    );
}

#[test]
fn what_is_not_as_it_was_written_is_not_trusted() {
    let scratch = Scratch::new("sweep-damaged");
    scratch.write("plan.toml", &plan(1100));
    let resume = ["sweep", "plan.toml", "-o", "out", "--resume"];
    stdout(&scratch.run(&resume));
    let read = |name: &str| fs::read(scratch.0.join("out").join(name)).unwrap();
    let put = |name: &str, bytes: &[u8]| fs::write(scratch.0.join("out").join(name), bytes).unwrap();
    for name in ["plan.toml", "sweep.json"] {
        let whole = read(name);
        let mut flipped = whole.clone();
        flipped[whole.len() / 2] ^= 1;
        let longer = [&whole[..], b"\n"].concat();
        for damaged in [&whole[..whole.len() - 1], &whole[..whole.len() / 2], b"", &flipped, &longer] {
            put(name, damaged);
            let error = refused(&scratch.run(&resume), 2);
            let is_told = error.contains(&format!("out/{name} is damaged: ")) && error.contains("--force");
            // A corrupted number in the manifest looks like another plan.
            assert!(is_told || name == "sweep.json" && error.contains("another plan"), "{error}");
            assert_eq!(read(name), damaged);
        }
        put(name, &whole);
        stdout(&scratch.run(&resume));
    }
    fs::remove_file(scratch.0.join("out/plan.toml")).unwrap();
    assert!(refused(&scratch.run(&resume), 2).contains("the file is missing"));
    put("plan.toml", plan(1100).as_bytes());
    // Damaged parts are recomputed, and this is reported.
    let name = "members/part-00001.parquet";
    let whole = read(name);
    for damaged in [&whole[..whole.len() / 3], b"", &whole.iter().rev().copied().collect::<Vec<_>>()] {
        put(name, damaged);
        let output = scratch.run(&resume);
        stdout(&output);
        assert_eq!(String::from_utf8_lossy(&output.stderr), "note: 1 damaged part was computed again\n");
        assert_eq!(read(name), whole);
    }
    fs::remove_file(scratch.0.join("out").join(name)).unwrap();
    assert!(scratch.run(&resume).stderr.is_empty());
    assert_eq!(read(name), whole);
}

#[test]
fn the_seed_stands_in_all_that_is_written() {
    let scratch = Scratch::new("sweep-seed");
    scratch.write("seven.toml", &plan(40).replace("seed = 2", "seed = 9_007_199_254_740_993"));
    scratch.write("none.toml", &plan(40).replace("seed = 2", ""));
    for (name, seed) in [("seven", 9_007_199_254_740_993_u64), ("none", 0)] {
        let text = stdout(&scratch.run(&["sweep", &format!("{name}.toml")]));
        assert!(text.contains(&format!("40 members, Monte Carlo sampling, seed {seed}\n")), "{text}");
        for file in ["summary.json", "sweep.json"] {
            let bytes = fs::read(scratch.0.join(name).join(file)).unwrap();
            assert_eq!(serde_json::from_slice::<serde_json::Value>(&bytes).unwrap()["seed"], seed, "{file}");
        }
        let part = fs::read(scratch.0.join(name).join("members/part-00000.parquet")).unwrap();
        let holds = |text: &str| part.windows(text.len()).any(|window| window == text.as_bytes());
        assert!(holds("polhode.seed") && holds(&seed.to_string()) && holds("monte_carlo"));
    }
    let grid = format!(
        "{BRICK}[sweep]\nsampling = \"grid\"\n[[sweep.vary]]\nkey = \"start.spin.body[0]\"\nlist = [1, 2]\n"
    );
    scratch.write("grid.toml", &grid);
    let output = scratch.run(&["sweep", "grid.toml", "--json"]);
    assert_eq!(
        serde_json::from_slice::<serde_json::Value>(&output.stdout).unwrap()["seed"],
        serde_json::Value::Null
    );
}
