//! A sweep killed at any moment and resumed has the same files as one that was not killed.
#![cfg(unix)]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::common::{Scratch, stdout};

/// Number of kills in `cargo xtask test --nightly`, and in the gate; more than one sweep survives.
const KILLS: [u32; 2] = [30, 12];
/// Largest number of kills of one sweep.
const LIVES: u32 = 10;

const PLAN: &str = r#"
title = "Killed and resumed"
[[body.part]]
name = "body"
shape = "tensor"
mass = "3.2 kg"
inertia = [[1.1, 0.13, -0.21], [0.13, 1.7, 0.08], [-0.21, 0.08, 2.3]]
[start]
attitude = { axis = [1, -2, 3], angle = "50 deg" }
spin = { body = [0.3, -1.2, 0.7] }
[run]
duration = "12 s"
samples = 3
[sweep]
members = 6_000
sampling = "monte carlo"
seed = 8
[[sweep.vary]]
key = "start.spin.body[0]"
normal = { mean = 0.3, sd = 1.5 }
[[sweep.vary]]
key = 'body.part["body"].inertia'
dispersion = "5 %"
"#;

/// Returns all files of a folder by their relative path.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if path.is_dir() {
            found.extend(files(&path).into_iter().map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
        } else {
            found.insert(name, fs::read(&path).unwrap());
        }
    }
    found
}

#[test]
fn killed_at_any_moment_a_sweep_loses_nothing_and_does_nothing_twice() {
    let scratch = Scratch::new("sweep-kill");
    scratch.write("plan.toml", PLAN);
    let began = Instant::now();
    stdout(&scratch.run(&["sweep", "plan.toml", "-o", "whole"]));
    let whole_run = began.elapsed();
    let whole = files(&scratch.0.join("whole"));
    assert!(whole.len() > 15, "{:?}", whole.keys());

    // Times of all kinds: from before the first file to after the last part, drawn by a linear
    // congruential generator.
    let mut state = 20_u64;
    let mut draw = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / (1_u64 << 24) as f64
    };
    let [at_night, in_gate] = KILLS;
    let wanted = if std::env::var_os("POLHODE_NIGHTLY").is_some() { at_night } else { in_gate };
    let (mut kills, mut sweeps) = (0, 0);
    while kills < wanted {
        let folder = format!("killed-{sweeps}");
        for life in 0.. {
            let mut command = scratch.command(&["sweep", "plan.toml", "-o", &folder, "--resume"]);
            let mut child =
                command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
            if life == LIVES {
                // On a slow machine every attempt would be killed too early.
                assert!(child.wait().unwrap().success());
                break;
            }
            sleep(whole_run.mul_f64(0.5 * draw()).min(Duration::from_secs(1)));
            if let Some(status) = child.try_wait().unwrap() {
                assert!(status.success(), "{status}");
                break;
            }
            child.kill().unwrap();
            let status = child.wait().unwrap();
            // It may have ended in the meantime.
            if status.success() {
                break;
            }
            kills += 1;
        }
        assert_eq!(files(&scratch.0.join(&folder)), whole, "{folder}");
        fs::remove_dir_all(scratch.0.join(&folder)).unwrap();
        sweeps += 1;
    }
    assert!(sweeps > 1);
}
