//! The built command on every scenario in examples/.

use std::process::Command;

use crate::process::{empty_folder, output, polhode};
use crate::{Outcome, files, read, root, short};

/// Runs `inertia` and `explain` on every scenario, and `simulate` on each that has a `[run]`.
pub(crate) fn check() -> Outcome {
    let polhode = polhode()?;
    let results = empty_folder("examples")?;
    let scenarios = files(&root().join("examples"), "toml")?;
    if scenarios.is_empty() {
        return Err("examples/ has no scenario".into());
    }
    for (k, path) in scenarios.iter().enumerate() {
        let scenario = short(path);
        let call = |subcommand: &str| {
            let mut command = Command::new(&polhode);
            command.current_dir(root()).arg(subcommand).arg(&scenario);
            command
        };
        output(&mut call("inertia"))?;
        output(&mut call("explain"))?;
        let runs = read(path)?.lines().any(|line| line.trim() == "[run]");
        if runs {
            output(call("simulate").arg("-o").arg(results.join(k.to_string())))?;
        }
        println!("   {scenario}: inertia, explain{}", if runs { ", simulate" } else { "" });
    }
    Ok(())
}
