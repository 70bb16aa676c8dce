//! `polhode sweep`

mod cluster;
mod progress;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use clap::Args;
use polhode::body::Severity;
use polhode_document::Report as _;
use polhode_document::json::pretty;
use polhode_document::layout::printable;
use polhode_source::files::Disk;
use polhode_source::shown;
use polhode_sweep::{Dataset, Plan, Request, SweepError};

use crate::failure::Failure;
use crate::folder::wrote;
use crate::stderr::tell;
use crate::stdout::print;
use progress::SweepProgress;

/// Run a parameter sweep and summarize the results.
///
/// A plan is a scenario with a [sweep] section, which lists the inputs that vary from member to
/// member. The output folder contains members/ (tables with one row per member: inputs and
/// outcomes), summary.json and figures. The row of a failed member states the cause.
///
/// An interrupted sweep loses only the parts in progress. --resume continues it, and the resulting
/// files are identical, byte by byte. They do not depend on the number of threads.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode sweep examples/sweeps/tumbling-debris.toml
  polhode sweep plan.toml -o results/plan --threads 4
  polhode sweep plan.toml -o results/plan --resume
  polhode sweep plan.toml --json | jq .outcomes.period_s
  polhode sweep plan.toml --resume --html > plan.html
  polhode sweep plan.toml --on ray://127.0.0.1:10001")]
pub(crate) struct Sweep {
    #[command(flatten)]
    request: Request,
    /// Output folder [default: the plan's name, in the working directory].
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Continue an interrupted sweep, or start one if there is none.
    #[arg(long)]
    resume: bool,
    /// Delete the results of an earlier sweep.
    #[arg(long, conflicts_with = "resume")]
    force: bool,
    /// Print the summary as JSON.
    #[arg(long)]
    json: bool,
    /// Print a self-contained HTML page with figures.
    #[arg(long, conflicts_with_all = ["json", "on"])]
    html: bool,
    /// Compute on a cluster: ray://HOST:PORT or dask://HOST:PORT; ray://local or dask://local for
    /// processes on this machine. Needs the Python package polhode.
    #[arg(long, value_name = "URL", value_parser = cluster::url)]
    on: Option<String>,
}

impl Sweep {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let target = self.output.clone().unwrap_or_else(|| default_folder(&self.request.plan));
        if let Some(url) = &self.on {
            return cluster::hand_over(&self, url, &target);
        }
        let plan = Plan::read(&Disk, &self.request.plan)?;
        warn(&plan);
        let dataset = match (self.resume, self.force) {
            (true, _) => Dataset::resume(&target, &plan),
            (_, true) => Dataset::replace(&target, &plan),
            _ => Dataset::create(&target, &plan),
        }?;
        let (stop, status) = stop_on_signals();
        let threads = self.request.threads();
        let progress = SweepProgress::new();
        let reached = dataset.compute(&plan, threads, &stop, &|reached| progress.reached(reached))?;
        drop(progress);
        if reached.remade > 0 {
            let parts = if reached.remade == 1 { "damaged part was" } else { "damaged parts were" };
            tell(&format!("note: {} {parts} computed again\n", reached.remade));
        }
        if reached.done < reached.members {
            let status = status.load(Ordering::Relaxed) as u8;
            return Err(self.stopped(reached.done, reached.members, &target, status));
        }
        let swept = dataset.finish(&plan, threads)?;
        let summary = &swept.summary;
        if self.json {
            print(&(pretty(&summary.to_json()) + "\n"))
        } else if self.html {
            print(&swept.to_document().to_html())
        } else {
            let asked = (!summary.questions.is_empty()).then_some("questions.svg");
            let names = ["summary.json", "members/", "histograms.svg", "pairs.svg"].into_iter().chain(asked);
            print(&format!("{}{}\n", summary.to_text(), wrote(&target, &names.collect::<Vec<_>>())))
        }
    }

    fn stopped(&self, done: u64, members: u64, target: &Path, status: u8) -> Failure {
        Failure::Stopped {
            done: format!("{done} of {members} members are in {}", shown(target)),
            hint: format!(
                "continue with polhode sweep {} -o {} --resume",
                shown(&self.request.plan),
                shown(target)
            ),
            status,
        }
    }
}

/// Prints the findings on the plan to standard error.
fn warn(plan: &Plan) {
    for finding in plan.findings().iter().filter(|finding| finding.severity != Severity::Info) {
        tell(&format!("{}: {}\n", finding.severity.name(), printable(&finding.message)));
    }
}

/// Installs signal handlers. The flag becomes true on the first Ctrl-C or SIGTERM, after which
/// running parts are finished; a second signal ends the program. The second value is the exit
/// status, 128 plus the signal number, as in shells.
fn stop_on_signals() -> (Arc<AtomicBool>, Arc<AtomicUsize>) {
    let (stop, status) = (Arc::new(AtomicBool::new(false)), Arc::new(AtomicUsize::new(2)));
    for signal in [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM] {
        let code = 128 + signal;
        // The order matters: the second signal must find the flag set by the first. Without
        // handlers, Ctrl-C ends the program.
        let _ = signal_hook::flag::register_conditional_shutdown(signal, code, Arc::clone(&stop));
        let _ = signal_hook::flag::register_usize(signal, Arc::clone(&status), code as usize);
        let _ = signal_hook::flag::register(signal, Arc::clone(&stop));
    }
    (stop, status)
}

/// Returns the plan's name as a folder in the current folder.
fn default_folder(plan: &Path) -> PathBuf {
    PathBuf::from(plan.file_stem().unwrap_or_default())
}

impl From<SweepError> for Failure {
    fn from(error: SweepError) -> Self {
        Self::Request(error.into())
    }
}
