//! The results of a sweep in a folder.
//!
//! ```text
//! DIR/sweep.json                        what was asked for; a folder without it is one in which nothing has begun
//! DIR/plan.toml                         the plan
//! DIR/members/part-00000.parquet        a row for each member of the part
//! DIR/trajectories/part-00000.parquet   a row for each of their samples, if the plan wants them
//! DIR/summary.json, histograms.svg, pairs.svg, questions.svg   when all parts are there
//! ```
//!
//! Which members a part has follows from the plan alone, a part is a pure function of the plan and its number, and its file
//! appears whole or not at all. So the parts that are there are the checkpoint: whatever happens to the processes that make
//! them, and wherever they run, what is missing is made, and the folder ends with the same bytes.

mod durable;
mod folder;
mod manifest;

use std::fs;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use polhode_document::json::pretty;

use crate::batch::{Batch, Values};
use crate::error::SweepError;
use crate::figures::SweepFigures;
use crate::parquet;
use crate::plan::Plan;
use crate::report::SweepSummary;
use crate::rows::{inputs, simulate, trajectories};
use crate::statistics;
use crate::threads;
use folder::{
    Folder, HISTOGRAMS, MANIFEST, MEMBERS, PAIRS, PLAN, QUESTIONS, SUMMARY, TRAJECTORIES, part_name,
};

pub(crate) use manifest::Manifest;

/// The results of a sweep in a folder, which nobody else writes to while this lives.
///
/// ```
/// use polhode_source::files::Disk;
/// use polhode_sweep::{Dataset, Plan, inputs, simulate};
/// let text = r#"
/// [[body.part]]
/// shape = "tensor"
/// mass = "3 kg"
/// moments = ["1 kg m^2", "2 kg m^2", "2.5 kg m^2"]
/// [start]
/// spin = { body = [0.1, 2, -0.3] }
/// [run]
/// duration = "60 s"
/// [sweep]
/// sampling = "grid"
/// [[sweep.vary]]
/// key = "start.spin.body[1]"
/// list = ["1 rad/s", "2 rad/s"]
/// "#;
/// let plan = Plan::parse(&Disk, text.to_owned(), "plan.toml".as_ref())?;
/// let folder = std::env::temp_dir().join(format!("polhode-dataset-{}", std::process::id()));
/// let dataset = Dataset::create(&folder, &plan)?;
/// for part in dataset.missing()? {
///     dataset.write(part, &simulate(&plan, &inputs(&plan, dataset.rows(part)))?)?;
/// }
/// assert!(dataset.missing()?.is_empty());
/// println!("{}", dataset.finish(&plan, 2)?.to_text());
/// # drop(dataset);
/// # std::fs::remove_dir_all(&folder)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Dataset {
    folder: Folder,
    manifest: Manifest,
}

/// How a run of a sweep went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Members that are there, those of earlier runs included.
    pub done: u64,
    /// Members of the sweep.
    pub members: u64,
    /// Parts that were there, but damaged or of something else, and were computed anew.
    pub remade: u64,
}

impl Dataset {
    /// Begins a sweep in a new folder.
    ///
    /// # Errors
    /// [`SweepError::Exists`], [`SweepError::NoRun`], [`SweepError::Write`].
    pub fn create(folder: &Path, plan: &Plan) -> Result<Self, SweepError> {
        let manifest = Manifest::of(plan)?;
        begun(Folder::create(folder)?, manifest, plan)
    }

    /// Goes on with a sweep, or begins it if there is none.
    ///
    /// # Errors
    /// [`SweepError::Changed`] for results of another plan, [`SweepError::Damaged`] where the copy of the plan or the manifest is not as
    /// it was written, [`SweepError::InUse`] while somebody else writes,
    /// [`SweepError::NotASweep`] for a folder of something else; else as [`Dataset::create`].
    pub fn resume(folder: &Path, plan: &Plan) -> Result<Self, SweepError> {
        let manifest = Manifest::of(plan)?;
        if is_missing(folder)? {
            return begun(Folder::create(folder)?, manifest, plan);
        }
        let folder = Folder::open(folder)?;
        let path = folder.join(MANIFEST);
        let written = match fs::read(&path) {
            Ok(written) => written,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return begun(folder, manifest, plan),
            Err(error) => return Err(SweepError::Read { path, error }),
        };
        let Ok(value) = serde_json::from_slice(&written) else {
            return Err(SweepError::Damaged { path, why: "it is no JSON, as if cut short" });
        };
        if let Some(what) = manifest.difference(&value) {
            return Err(SweepError::Changed { folder: folder.path().to_owned(), what });
        }
        // It was written whole, and before everything else.
        if written != manifest.to_text().as_bytes() {
            return Err(SweepError::Damaged { path, why: "it is not as polhode wrote it" });
        }
        require_copy(&folder, plan)?;
        folder.sweep_out()?;
        Ok(Self { folder, manifest })
    }

    /// Throws the results of an earlier sweep away, if there are any, and begins.
    ///
    /// # Errors
    /// As [`Dataset::resume`], but for [`SweepError::Changed`].
    pub fn replace(folder: &Path, plan: &Plan) -> Result<Self, SweepError> {
        let manifest = Manifest::of(plan)?;
        let folder = if is_missing(folder)? { Folder::create(folder)? } else { Folder::open(folder)? };
        begun(folder, manifest, plan)
    }

    /// How many parts there are.
    pub const fn parts(&self) -> u64 {
        self.manifest.parts()
    }

    /// The members of a part; none if there is no such part.
    pub fn rows(&self, part: u64) -> Range<u64> {
        self.manifest.rows(part)
    }

    /// True if the plan wants trajectories, so that [`Dataset::write_trajectories`] is due too.
    pub const fn wants_trajectories(&self) -> bool {
        self.manifest.trajectories()
    }

    /// The parts that are not there, or are damaged, ascending.
    ///
    /// # Errors
    /// [`SweepError::Read`]
    pub fn missing(&self) -> Result<Vec<u64>, SweepError> {
        let mut missing = Vec::new();
        for part in 0..self.parts() {
            if !self.is_whole(part)? {
                missing.push(part);
            }
        }
        Ok(missing)
    }

    /// Keeps the rows of a part, as [`simulate`](crate::simulate) gives them, durably. Trajectories, if the plan wants them, are
    /// written before.
    ///
    /// # Errors
    /// [`SweepError::Rows`] if they are others, [`SweepError::Write`].
    pub fn write(&self, part: u64, rows: &Batch) -> Result<(), SweepError> {
        let expected = self.rows(part);
        let Values::Whole(members) = &rows.column("member")?.values else {
            return Err(SweepError::Rows { part, why: "their members are no whole numbers".to_owned() });
        };
        if expected.is_empty() || !members.iter().copied().eq(expected.clone()) {
            let why = format!("it has members {} … {}", expected.start, expected.end.saturating_sub(1));
            return Err(SweepError::Rows { part, why });
        }
        self.keep(MEMBERS, part, rows)
    }

    /// Keeps the trajectories of a part, as [`trajectories`](crate::trajectories) gives them, durably.
    ///
    /// # Errors
    /// [`SweepError::Write`]
    pub fn write_trajectories(&self, part: u64, rows: &Batch) -> Result<(), SweepError> {
        self.keep(TRAJECTORIES, part, rows)
    }

    /// Computes what is missing, in threads of this process; `stop` ends it after the parts in hand. `progress` is told after each
    /// part how far it is.
    ///
    /// The files do not depend on the number of threads.
    ///
    /// # Errors
    /// The first that a thread met.
    pub fn compute(
        &self,
        plan: &Plan,
        threads: usize,
        stop: &AtomicBool,
        progress: &(dyn Fn(Progress) + Sync),
    ) -> Result<Progress, SweepError> {
        let (done, remade) = (AtomicU64::new(0), AtomicU64::new(0));
        let members = self.manifest.members();
        threads::each(self.parts(), threads, stop, |part| {
            remade.fetch_add(self.make(plan, part)?.into(), Ordering::Relaxed);
            let rows = self.rows(part);
            let own = rows.end - rows.start;
            let done = done.fetch_add(own, Ordering::Relaxed) + own;
            progress(Progress { done, members, remade: remade.load(Ordering::Relaxed) });
            Ok(())
        })?;
        Ok(Progress { done: done.into_inner(), members, remade: remade.into_inner() })
    }

    /// Reads all parts, and writes what they come to: the summary and its pictures. [`Dataset::missing`] has nothing left to say.
    ///
    /// # Errors
    /// [`SweepError::Incomplete`] if a part is not there; [`SweepError::Read`], [`SweepError::Write`].
    pub fn finish(&self, plan: &Plan, threads: usize) -> Result<SweepSummary, SweepError> {
        let (summary, sample) = statistics::of(plan, self.parts(), threads, &|part| self.read(part))?;
        let figures = SweepFigures::new(&summary, &sample);
        self.folder.write(HISTOGRAMS, figures.histograms().to_svg().as_bytes())?;
        self.folder.write(PAIRS, figures.pairs().to_svg().as_bytes())?;
        if let Some(questions) = figures.questions() {
            self.folder.write(QUESTIONS, questions.to_svg().as_bytes())?;
        }
        self.folder.write(SUMMARY, (pretty(&summary.to_json()) + "\n").as_bytes())?;
        Ok(summary)
    }

    /// Makes a part, unless it is there; true if it was, and is not to be trusted.
    fn make(&self, plan: &Plan, part: u64) -> Result<bool, SweepError> {
        if self.is_whole(part)? {
            return Ok(false);
        }
        let was_damaged = self.place(MEMBERS, part).exists();
        let inputs = inputs(plan, self.rows(part));
        if self.wants_trajectories() {
            self.write_trajectories(part, &trajectories(plan, &inputs)?)?;
        }
        self.write(part, &simulate(plan, &inputs)?)?;
        Ok(was_damaged)
    }

    /// The rows of a part, which has to be there.
    fn read(&self, part: u64) -> Result<Batch, SweepError> {
        let path = self.place(MEMBERS, part);
        let rows = parquet::load(&path, &self.manifest.part_metadata(part));
        rows.map_err(SweepError::reading(&path))?.ok_or(SweepError::Incomplete { part })
    }

    /// True if a part is there with all that belongs to it.
    fn is_whole(&self, part: u64) -> Result<bool, SweepError> {
        let is_whole = |kind: &str| {
            let path = self.place(kind, part);
            parquet::is_whole(&path, &self.manifest.part_metadata(part)).map_err(SweepError::reading(&path))
        };
        Ok((!self.wants_trajectories() || is_whole(TRAJECTORIES)?) && is_whole(MEMBERS)?)
    }

    fn keep(&self, kind: &str, part: u64, rows: &Batch) -> Result<(), SweepError> {
        let path = self.place(kind, part);
        let bytes = parquet::write(rows, &self.manifest.part_metadata(part));
        bytes.and_then(|bytes| durable::write(&path, &bytes)).map_err(SweepError::writing(&path))
    }

    fn place(&self, kind: &str, part: u64) -> PathBuf {
        self.folder.join(kind).join(part_name(part))
    }
}

/// A folder in which a sweep has begun: the manifest comes last.
fn begun(folder: Folder, manifest: Manifest, plan: &Plan) -> Result<Dataset, SweepError> {
    folder.clear()?;
    folder.write(PLAN, plan.text().as_bytes())?;
    folder.make(MEMBERS)?;
    if manifest.trajectories() {
        folder.make(TRAJECTORIES)?;
    }
    folder.write(MANIFEST, manifest.to_text().as_bytes())?;
    Ok(Dataset { folder, manifest })
}

/// Refuses to go on where the copy of the plan is not the plan: whoever reads the results would trust it.
fn require_copy(folder: &Folder, plan: &Plan) -> Result<(), SweepError> {
    let path = folder.join(PLAN);
    match fs::read(&path) {
        Ok(copy) if copy == plan.text().as_bytes() => Ok(()),
        Ok(_) => Err(SweepError::Damaged { path, why: "it is not the plan that the results are of" }),
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            Err(SweepError::Damaged { path, why: "it is not there" })
        }
        Err(error) => Err(SweepError::Read { path, error }),
    }
}

fn is_missing(folder: &Path) -> Result<bool, SweepError> {
    match fs::symlink_metadata(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(true),
        Err(error) => Err(SweepError::Read { path: folder.to_owned(), error }),
        Ok(_) => Ok(false),
    }
}
