//! Page on the findings of `polhode check` in public models, generated from work trees. No model is
//! stored.

mod count;
mod page;
mod repository;

use std::fs::File;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use serde_json::Value;

use crate::process::{build_folder, cargo, empty_folder, run};
use crate::{Outcome, read, root};
use count::{Counts, Seen};
use repository::Repository;

/// Repository with its results.
#[derive(Debug)]
struct Audited {
    repository: Repository,
    counts: Counts,
    cost: Cost,
}

/// Cost of running the command, if the system reports it.
#[derive(Clone, Copy, Debug, Default)]
struct Cost {
    /// Processor time, s.
    seconds: f64,
    /// Peak memory, MiB.
    memory: u64,
}

/// Checks every work tree and writes `book/corpus.md`.
///
/// A file that occurs in several repositories is counted in the first.
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
        let counts = Counts::of(&repository.folder, &results, &mut seen)?;
        audited.push(Audited { repository, counts, cost });
    }
    let page = root().join("book/corpus.md");
    std::fs::write(&page, page::text(&audited)).map_err(|error| format!("{}: {error}", page.display()))
}

/// Returns the results of the command for all models of a work tree, and its cost.
fn check(polhode: &Path, repository: &Repository) -> Result<(Vec<Value>, Cost), String> {
    let out = empty_folder("corpus")?.join("results.json");
    let file = File::create(&out).map_err(|error| format!("{}: {error}", out.display()))?;
    let mut command = Command::new(polhode);
    command.args(["check", ".", "--json"]).current_dir(&repository.folder).stdout(file).stderr(Stdio::null());
    for root in &repository.roots {
        command.arg("--root").arg(root);
    }
    let failed = |error| format!("polhode check in {}: {error}", repository.name);
    let mut child = command.spawn().map_err(failed)?;
    let mut cost = Cost::default();
    let status = loop {
        cost = Cost::of(child.id()).unwrap_or(cost);
        if let Some(status) = child.try_wait().map_err(failed)? {
            break status;
        }
        std::thread::sleep(Duration::from_millis(10));
    };
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

impl Cost {
    /// Returns the cost of a running process so far; Linux only.
    fn of(process: u32) -> Option<Self> {
        /// Clock ticks per second in `/proc` on Linux.
        const TICKS: f64 = 100.0;
        let of = |file: &str| std::fs::read_to_string(format!("/proc/{process}/{file}")).ok();
        let (status, stat) = (of("status")?, of("stat")?);
        let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
        let memory = line.split_whitespace().next()?.parse::<u64>().ok()? / 1024;
        // The process name may contain spaces. The fields after it start with the state. Fields 12
        // and 13 are the ticks in user mode and in kernel mode.
        let mut fields = stat.rsplit_once(')')?.1.split_whitespace().skip(11);
        let mut ticks = || fields.next()?.parse::<f64>().ok();
        Some(Self { seconds: (ticks()? + ticks()?) / TICKS, memory })
    }
}
