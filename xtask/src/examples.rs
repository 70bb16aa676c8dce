//! Runs the built command on every scenario in examples/.

use std::path::Path;
use std::process::Command;

use crate::process::{cargo, empty_folder, output, polhode, program};
use crate::{Outcome, files, read, root, short};

/// Runs the command on all files in examples/.
///
/// These are `budget` for parts lists, and `identify` for measurement plans. Scenarios get
/// `inertia`, `explain` if they have a worked solution, and `simulate` if they have a `[run]`.
/// Plans get `sweep`.
pub(crate) fn check() -> Outcome {
    let polhode = polhode()?;
    let results = empty_folder("examples")?;
    let scenarios = files(&root().join("examples"), "toml")?;
    if scenarios.is_empty() {
        return Err("examples/ has no scenario".into());
    }
    for extension in ["csv", "xlsx"] {
        for path in files(&root().join("examples/budget"), extension)? {
            let list = short(&path);
            output(Command::new(&polhode).current_dir(root()).arg("budget").arg(&list))?;
            println!("   {list}: budget");
        }
    }
    for (k, path) in scenarios.iter().enumerate() {
        let scenario = short(path);
        let call = |subcommand: &str| {
            let mut command = Command::new(&polhode);
            command.current_dir(root()).arg(subcommand).arg(&scenario);
            command
        };
        if scenario.starts_with("examples/identify") {
            output(&mut call("identify"))?;
            println!("   {scenario}: identify");
            continue;
        }
        output(&mut call("inertia"))?;
        let unsolved = has_no_solution(path)?;
        if !unsolved {
            output(&mut call("explain"))?;
        }
        let runs = read(path)?.lines().any(|line| line.trim() == "[run]");
        if runs {
            output(call("simulate").arg("-o").arg(results.join(k.to_string())))?;
        }
        let sweeps = read(path)?.lines().any(|line| line.trim() == "[sweep]");
        if sweeps {
            sweep(&polhode, path, &results.join(format!("sweep-{k}")))?;
        }
        let more =
            [(runs, ", simulate"), (sweeps, ", sweep")].map(|(done, what)| if done { what } else { "" });
        println!("   {scenario}: inertia{}{}", if unsolved { "" } else { ", explain" }, more.concat());
    }
    outside()
}

/// Returns true if a scenario has no worked solution: its mass changes, or the body is in gimbals.
pub(crate) fn has_no_solution(scenario: &Path) -> Result<bool, String> {
    let is_section = |line: &str| {
        let name = line.trim_start_matches('[');
        name.len() < line.len() && ["mass_history", "gimbals]"].iter().any(|start| name.starts_with(start))
    };
    Ok(read(scenario)?.lines().any(is_section))
}

/// Checks the program in `outside/`, which uses the crate from outside the workspace like a user's
/// program.
///
/// It must be short, and its event must happen. It is run with the libraries compiled for the
/// tests.
fn outside() -> Outcome {
    output(&mut cargo(&[
        "metadata",
        "--quiet",
        "--locked",
        "--format-version",
        "1",
        "--manifest-path",
        MANIFEST,
    ]))?;
    let lines = read(&root().join(PROGRAM))?.lines().count();
    if lines > MOST_LINES {
        return Err(format!("{PROGRAM} has {lines} lines, more than {MOST_LINES}"));
    }
    let table = output(Command::new(program("examples/eddy_brake")?).current_dir(root()))?;
    let rows = table.lines().count();
    if !(table.starts_with("time_s,") && (3..600).contains(&rows)) {
        return Err(format!("{PROGRAM} wrote {rows} lines: its event should have ended it"));
    }
    println!("   {PROGRAM}: {lines} lines, a table of {rows}");
    Ok(())
}

const MANIFEST: &str = "outside/Cargo.toml";
const PROGRAM: &str = "crates/polhode-scenario/examples/eddy_brake.rs";

/// Largest number of lines of the program outside the workspace.
const MOST_LINES: usize = 40;

/// Number of members of a plan here, enough for statistics and pictures.
const TRIED: &str = "members = 32";

/// Runs `sweep` on a copy of a plan with fewer members; a grid is not changed.
fn sweep(polhode: &Path, plan: &Path, folder: &Path) -> Outcome {
    let fewer = |line: &str| if line.starts_with("members = ") { TRIED.to_owned() } else { line.to_owned() };
    let text: Vec<String> = read(plan)?.lines().map(fewer).collect();
    let failed = |error| format!("{}: {error}", folder.display());
    std::fs::create_dir_all(folder).map_err(failed)?;
    let copy = folder.join("plan.toml");
    std::fs::write(&copy, text.join("\n")).map_err(failed)?;
    output(Command::new(polhode).arg("sweep").arg(&copy).arg("-o").arg(folder.join("results"))).map(drop)
}
