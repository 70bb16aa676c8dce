//! Runs that are killed, stopped, started twice, or out of disk space; the files left are complete.
#![cfg(unix)]

use std::fs::{self, File};
use std::os::unix::process::ExitStatusExt as _;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use crate::common::{Scratch, example, refused, stdout};

const SWEEP: &str = "[sweep]\nmembers = 100\nsampling = \"sobol\"\n[[sweep.vary]]\nkey = \"start.spin.body[0]\"\nuniform = { from = 0, to = 1 }\n";

const SIGINT: i32 = 2;
const SIGTERM: i32 = 15;

/// Scenario with a minute of work or more; with `duration = "1 s"`, very little.
const LONG: &str = r#"
[[body.part]]
shape = "tensor"
mass = "3.2 kg"
inertia = [[1.1, 0.13, -0.21], [0.13, 1.7, 0.08], [-0.21, 0.08, 2.3]]
[start]
spin = { body = [3.1, -1.2, 20.7] }
[[torque]]
model = "formula"
axes = "body"
torque = ["0.01[N m]*sin(t/1[s])", "0.02[N m s]*wx", "-0.01[N m s]*wz"]
[run]
duration = "1 d"
samples = 11
"#;

/// Starts a run and waits until a condition on its process id holds; fails if the run ends before.
fn until(scratch: &Scratch, arguments: &[&str], is_there: impl Fn(u32) -> bool) -> Child {
    let mut command = scratch.command(arguments);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    while !is_there(child.id()) {
        if child.try_wait().unwrap().is_some() {
            panic!("{:?} {:?}", scratch.entries(), child.wait_with_output());
        }
        sleep(Duration::from_millis(2));
    }
    child
}

/// Starts a run and waits until its unfinished folder exists.
fn begun(scratch: &Scratch, arguments: &[&str]) -> Child {
    let partial = |id: u32| format!(".partial-{id}");
    until(scratch, arguments, |id| scratch.entries().iter().any(|name| name.ends_with(&partial(id))))
}

fn signal(child: &Child, number: i32) {
    assert!(
        Command::new("kill")
            .arg(format!("-{number}"))
            .arg(child.id().to_string())
            .status()
            .unwrap()
            .success()
    );
}

fn long(name: &str) -> Scratch {
    let scratch = Scratch::new(name);
    scratch.write("long.toml", LONG);
    scratch.write("short.toml", &LONG.replace("1 d", "1 s"));
    scratch
}

#[test]
fn what_a_killed_run_leaves_the_next_one_removes() {
    let scratch = long("killed");
    let mut child = begun(&scratch, &["simulate", "long.toml", "-o", "out"]);
    child.kill().unwrap();
    child.wait().unwrap();
    let left = format!(".out.partial-{}", child.id());
    assert_eq!(scratch.entries(), [left.as_str(), "long.toml", "short.toml"]);
    // Similar names, and leftovers of other targets, are kept.
    let other_files =
        [".out.partial-", ".out.partial-7x", ".out2.partial-7", "out.partial-7", ".out.partial-07b"];
    for name in other_files {
        scratch.write(name, "");
    }
    // A folder with the name of a leftover but foreign content is kept too.
    fs::create_dir(scratch.0.join(".out.partial-8")).unwrap();
    scratch.write(".out.partial-8/photo.jpg", "");
    stdout(&scratch.run(&["simulate", "short.toml", "-o", "out"]));
    let mut want: Vec<&str> =
        [&other_files[..], &[".out.partial-8", "long.toml", "out", "short.toml"]].concat();
    want.sort_unstable();
    assert_eq!(scratch.entries(), want);
    assert_eq!(
        crate::common::entries(&scratch.0.join("out")),
        ["report.html", "summary.json", "trajectory.parquet"]
    );
}

#[test]
fn old_results_whose_successor_never_came_go_back() {
    let scratch = long("old");
    stdout(&scratch.run(&["simulate", "short.toml", "-o", "out"]));
    let summary = fs::read(scratch.0.join("out/summary.json")).unwrap();
    // The state between the two renames of a run that replaces old results.
    fs::rename(scratch.0.join("out"), scratch.0.join(".out.old-4711")).unwrap();
    let text = refused(&scratch.run(&["simulate", "long.toml", "-o", "out"]), 2);
    assert!(text.contains("already exists"), "{text}");
    assert_eq!(fs::read(scratch.0.join("out/summary.json")).unwrap(), summary);
    // The state after both renames.
    stdout(&scratch.run(&["simulate", "short.toml", "-o", ".out.old-4711"]));
    stdout(&scratch.run(&["simulate", "short.toml", "-o", "out", "--force"]));
    assert_eq!(scratch.entries(), ["long.toml", "out", "short.toml"]);
}

#[test]
fn files_of_killed_runs_are_removed_too() {
    let scratch = Scratch::new("killed-files");
    for target in ["slew.csv", "spin.html", "spin.svg", "fixed.urdf"] {
        scratch.write(&format!(".{target}.partial-4711"), "half");
    }
    stdout(&scratch.run(&["torque", &example("slew.toml"), "-o", "slew.csv"]));
    let plot = ["--html=spin.html", "--plot", "omega=spin.svg"];
    stdout(&scratch.run(&[&["spin", "--moments", "1,2,3", "--omega", "0.1,1,0.2"], &plot[..]].concat()));
    scratch.run(&["check", &example("robots/bad-arm.urdf"), "--fix", "fixed.urdf"]);
    assert_eq!(scratch.entries(), ["fixed.urdf", "slew.csv", "spin.html", "spin.svg"]);
}

#[test]
fn a_signal_ends_a_run_and_leaves_nothing() {
    for number in [SIGINT, SIGTERM] {
        let scratch = long("signal");
        let mut child = begun(&scratch, &["simulate", "long.toml", "-o", "out"]);
        signal(&child, number);
        let status = child.wait().unwrap();
        assert_eq!(status.signal(), Some(number), "{status}");
        assert_eq!(scratch.entries(), ["long.toml", "short.toml"]);
    }
}

#[test]
fn a_signal_stops_a_batch() {
    let scratch = Scratch::new("signal-batch");
    assert!(Command::new("mkfifo").arg(scratch.0.join("wait.obj")).status().unwrap().success());
    let mut command = scratch.command(&["inertia", "wait.obj", &example("bracket.stl")]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    sleep(Duration::from_millis(100));
    signal(&child, SIGTERM);
    assert_eq!(child.wait().unwrap().signal(), Some(SIGTERM));
}

#[test]
fn a_signal_stops_a_sweep_that_goes_on_later() {
    let plan = format!(
        "{}[sweep]\nmembers = 4000\nsampling = \"sobol\"\nseed = 5\n[[sweep.vary]]\nkey = \"start.spin.body[0]\"\nuniform = {{ from = 0, to = 1 }}\n",
        LONG.replace("1 d", "1 s")
    );
    for number in [SIGINT, SIGTERM] {
        let scratch = Scratch::new("signal-sweep");
        scratch.write("plan.toml", &plan);
        let first = scratch.0.join("out/members/part-00000.parquet");
        let run = ["sweep", "plan.toml", "-o", "out", "--threads", "1"];
        let child = until(&scratch, &run, |_| first.exists());
        // A second run while the first one writes.
        let text = refused(&scratch.run(&["sweep", "plan.toml", "-o", "out", "--resume"]), 2);
        assert!(text.contains("in use"), "{text}");
        signal(&child, number);
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(128 + number));
        let text = String::from_utf8(output.stderr).unwrap();
        assert!(text.contains("stopped: ") && text.contains("continue with polhode sweep"), "{text}");
        assert!(output.stdout.is_empty());
        let parts = crate::common::entries(&scratch.0.join("out/members"));
        assert!(parts.iter().all(|part| part.ends_with(".parquet")), "{parts:?}");
        assert!(!scratch.0.join("out/summary.json").exists());
    }
}

#[test]
fn of_two_starts_one_wins_and_the_other_says_so() {
    let scratch = long("twice");
    let mut first = begun(&scratch, &["simulate", "long.toml", "-o", "out"]);
    for force in [&[][..], &["--force"]] {
        let text = refused(&scratch.run(&[&["simulate", "short.toml", "-o", "out"], force].concat()), 2);
        assert!(text.contains("another polhode"), "{text}");
    }
    // Another target is free.
    stdout(&scratch.run(&["simulate", "short.toml", "-o", "out2"]));
    first.kill().unwrap();
    first.wait().unwrap();
    // Simultaneous starts, with and without --force.
    for force in [&[][..], &["--force"]] {
        let run = [&["simulate", "short.toml", "-o", "out"], force].concat();
        let start = |_| scratch.command(&run).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let children: Vec<Child> = (0..6).map(start).collect();
        let outputs: Vec<_> = children.into_iter().map(|child| child.wait_with_output().unwrap()).collect();
        let won = outputs.iter().filter(|output| output.status.code() == Some(0)).count();
        // A run that starts after another one has ended replaces its results, which are of the same
        // scenario.
        assert!(won >= 1, "{won}");
        for output in outputs.iter().filter(|output| !output.status.success()) {
            let text = refused(output, 2);
            assert!(text.contains("another polhode") || text.contains("already exists"), "{text}");
        }
        assert_eq!(scratch.entries(), ["long.toml", "out", "out2", "short.toml"]);
        assert_eq!(crate::common::entries(&scratch.0.join("out")).len(), 3);
    }
}

#[test]
fn of_two_sweeps_one_wins_and_the_other_says_so() {
    let scratch = Scratch::new("sweep-twice");
    scratch.write("plan.toml", &format!("{}{SWEEP}", LONG.replace("1 d", "1 s")));
    let start = |_| {
        let mut command = scratch.command(&["sweep", "plan.toml", "-o", "out"]);
        command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
    };
    let children: Vec<Child> = (0..4).map(start).collect();
    let outputs: Vec<_> = children.into_iter().map(|child| child.wait_with_output().unwrap()).collect();
    assert_eq!(outputs.iter().filter(|output| output.status.success()).count(), 1);
    for output in outputs.iter().filter(|output| !output.status.success()) {
        let text = refused(output, 2);
        assert!(text.contains("already exists") || text.contains("in use"), "{text}");
    }
    assert!(scratch.0.join("out/summary.json").exists());
}

/// Runs polhode with a limit on file sizes of some blocks, to simulate a nearly full disk.
fn without_room(scratch: &Scratch, blocks: u32, arguments: &[&str]) -> std::process::Output {
    let mut command = Command::new("sh");
    let script = format!("ulimit -f {blocks}; exec \"$0\" \"$@\"");
    command.arg("-c").arg(script).arg(env!("CARGO_BIN_EXE_polhode")).args(arguments);
    command.current_dir(&scratch.0).output().unwrap()
}

#[test]
fn without_room_nothing_is_left_half_written() {
    let scratch = long("full");
    let slew = example("slew.toml");
    let spin = ["spin", "--moments", "1,2,3", "--omega", "0.1,1,0.2"];
    for run in [
        &["simulate", "short.toml", "-o", "deep/out"][..],
        &["torque", &slew, "-o", "slew.csv"],
        &[&spin[..], &["--html=spin.html"]].concat(),
        &[&spin[..], &["--plot", "omega=spin.svg"]].concat(),
        &[&spin[..], &["--duration", "20 s", "--table", "csv", "-o", "spin"]].concat(),
    ] {
        let text = refused(&without_room(&scratch, 1, run), 2);
        assert!(text.contains("cannot write") && text.contains("free disk space"), "{run:?}: {text}");
        assert_eq!(scratch.entries(), ["long.toml", "short.toml"], "{run:?}");
    }
    // Old results are kept.
    stdout(&scratch.run(&["simulate", "short.toml", "-o", "out"]));
    let summary = fs::read(scratch.0.join("out/summary.json")).unwrap();
    refused(&without_room(&scratch, 1, &["simulate", "short.toml", "-o", "out", "--force"]), 2);
    assert_eq!(fs::read(scratch.0.join("out/summary.json")).unwrap(), summary);
    assert_eq!(scratch.entries(), ["long.toml", "out", "short.toml"]);
}

#[test]
fn a_sweep_without_room_goes_on_when_there_is_some() {
    let scratch = Scratch::new("full-sweep");
    let plan = format!("{}{SWEEP}", LONG.replace("1 d", "1 s"));
    scratch.write("plan.toml", &plan);
    let text = refused(&without_room(&scratch, 4, &["sweep", "plan.toml", "-o", "out"]), 2);
    assert!(text.contains("cannot write") && text.contains("hint: "), "{text}");
    let parts = crate::common::entries(&scratch.0.join("out/members"));
    assert!(parts.iter().all(|part| part.ends_with(".parquet")), "{parts:?}");
    stdout(&scratch.run(&["sweep", "plan.toml", "-o", "out", "--resume"]));
    stdout(&scratch.run(&["sweep", "plan.toml", "-o", "whole"]));
    for name in ["summary.json", "plan.toml", "sweep.json", "members/part-00003.parquet"] {
        let read = |folder: &str| fs::read(scratch.0.join(folder).join(name)).unwrap();
        assert_eq!(read("out"), read("whole"), "{name}");
    }
}

#[test]
fn standard_output_that_is_full_is_an_error() {
    let scratch = long("dev-full");
    let bracket = example("bracket.stl");
    for run in [
        &["inertia", &bracket][..],
        &["inertia", &bracket, "--json"],
        &["inertia", &bracket, "--csv"],
        &["explain", "short.toml"],
        &["spin", "--moments", "1,2,3", "--omega", "0.1,1,0.2"],
    ] {
        let full = File::options().write(true).open("/dev/full").unwrap();
        let output = scratch.command(run).stdout(full).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{run:?}");
        assert!(
            String::from_utf8(output.stderr).unwrap().contains("cannot write standard output"),
            "{run:?}"
        );
    }
}
