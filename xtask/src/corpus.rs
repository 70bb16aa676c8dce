//! The page of what `polhode check` finds in public models: work trees in, numbers out. No model is kept.

mod count;
mod page;
mod repository;

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::process::{build_folder, cargo, empty_folder, run};
use crate::{Outcome, read, root};
use count::{Counts, Seen};
use repository::Repository;

/// A repository and what was found in it.
#[derive(Debug)]
struct Audited {
    repository: Repository,
    counts: Counts,
    cost: Cost,
}

/// What a run of the command took.
#[derive(Clone, Copy, Debug, Default)]
struct Cost {
    seconds: f64,
    /// The most memory at a time, MiB; `None` where the machine does not say.
    memory: Option<u64>,
}

/// Checks every work tree and writes `book/corpus.md`. What has the same bytes in several is counted in the first.
pub(crate) fn audit(folders: &[&str]) -> Outcome {
    run(&mut cargo(&["build", "--release", "--quiet", "--locked", "--package", "polhode-cli"]))?;
    let built = build_folder()?.with_file_name("release");
    let polhode = built.join(format!("polhode{}", std::env::consts::EXE_SUFFIX));
    let mut repositories =
        folders.iter().map(|folder| Repository::at(Path::new(folder))).collect::<Result<Vec<_>, _>>()?;
    repositories.sort_by_key(|repository| repository.name.to_lowercase());
    let mut seen = Seen::default();
    let mut audited = Vec::new();
    for repository in repositories {
        println!("   {}", repository.name);
        let (results, cost) = check(&polhode, &repository)?;
        let mut counts = Counts::default();
        for result in results {
            counts.add(&repository.folder, &result, &mut seen)?;
        }
        audited.push(Audited { repository, counts, cost });
    }
    let page = root().join("book/corpus.md");
    std::fs::write(&page, page::text(&audited)).map_err(|error| format!("{}: {error}", page.display()))
}

/// What the command says of all models in a work tree, and what that took.
fn check(polhode: &Path, repository: &Repository) -> Result<(Vec<Value>, Cost), String> {
    let out = empty_folder("corpus")?.join("results.json");
    let file = File::create(&out).map_err(|error| format!("{}: {error}", out.display()))?;
    let mut command = Command::new(polhode);
    command.args(["check", ".", "--json"]).current_dir(&repository.folder).stdout(file).stderr(Stdio::null());
    for root in &repository.roots {
        command.arg("--root").arg(root);
    }
    let failed = |error| format!("polhode check in {}: {error}", repository.name);
    let begun = Instant::now();
    let mut child = command.spawn().map_err(failed)?;
    let mut cost = Cost::default();
    let status = loop {
        cost.memory = peak(child.id()).or(cost.memory);
        if let Some(status) = child.try_wait().map_err(failed)? {
            break status;
        }
        std::thread::sleep(Duration::from_millis(10));
    };
    cost.seconds = begun.elapsed().as_secs_f64();
    if !status.code().is_some_and(|code| (0..=2).contains(&code)) {
        return Err(format!("polhode check in {} ended with {status}", repository.name));
    }
    let results: Value =
        serde_json::from_str(&read(&out)?).map_err(|error| format!("{}: {error}", repository.name))?;
    let Value::Array(results) = results else {
        return Err(format!("{}: its results are no list", repository.name));
    };
    Ok((results, cost))
}

/// The most memory that a running program has had, MiB, on Linux.
fn peak(process: u32) -> Option<u64> {
    let status = std::fs::read_to_string(PathBuf::from(format!("/proc/{process}/status"))).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.split_whitespace().next()?.parse::<u64>().ok()? / 1024)
}
