//! Storage of a sweep's results in a folder.
//!
//! ```text
//! DIR/sweep.json                        what was asked for; a folder without it is one in which nothing has begun
//! DIR/plan.toml                         the plan
//! DIR/members/part-00000.parquet        a row for each member of the part
//! DIR/trajectories/part-00000.parquet   a row for each of their samples, if the plan wants them
//! DIR/summary.json, histograms.svg, pairs.svg, questions.svg   when all parts are there
//! ```
//!
//! The division into parts follows from the plan alone. A part is a pure function of the plan and
//! its number, and its file is written atomically. So the existing parts are the checkpoint: after
//! any interruption, and on any machine, only missing parts are computed. The final folder is
//! identical byte for byte.

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
use crate::parquet;
use crate::plan::Plan;
use crate::rows::{inputs, simulate, trajectories};
use crate::statistics;
use crate::swept::Swept;
use crate::threads;
use folder::{
    Folder, HISTOGRAMS, MANIFEST, MEMBERS, PAIRS, PLAN, QUESTIONS, SUMMARY, TRAJECTORIES, part_name,
};

pub(crate) use manifest::Manifest;

/// Results of a sweep in a folder, locked against other writers.
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
/// println!("{}", dataset.finish(&plan, 2)?.summary.to_text());
/// # drop(dataset);
/// # std::fs::remove_dir_all(&folder)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Dataset {
    folder: Folder,
    manifest: Manifest,
}

/// Progress of a sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Number of finished members, including those of earlier runs.
    pub done: u64,
    /// Number of all members of the sweep.
    pub members: u64,
    /// Number of existing parts that were damaged or foreign, and were computed again.
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

    /// Continues a sweep, or begins it if there is none.
    ///
    /// # Errors
    /// - [`SweepError::Changed`] for results of another plan
    /// - [`SweepError::Damaged`] if the copy of the plan or the manifest was modified
    /// - [`SweepError::InUse`] while another process writes
    /// - [`SweepError::NotASweep`] for a folder with other content
    /// - otherwise the same as [`Dataset::create`]
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
            return Err(SweepError::Damaged { path, why: "it is not valid JSON and may be truncated" });
        };
        if let Some(what) = manifest.difference(&value) {
            return Err(SweepError::Changed { folder: folder.path().to_owned(), what });
        }
        // It was written completely, before all other files.
        if written != manifest.to_text().as_bytes() {
            return Err(SweepError::Damaged { path, why: "its content has changed since polhode wrote it" });
        }
        require_copy(&folder, plan)?;
        folder.sweep_out()?;
        Ok(Self { folder, manifest })
    }

    /// Discards the results of an earlier sweep, if any, and begins.
    ///
    /// # Errors
    /// Same as [`Dataset::resume`], except [`SweepError::Changed`].
    pub fn replace(folder: &Path, plan: &Plan) -> Result<Self, SweepError> {
        let manifest = Manifest::of(plan)?;
        let folder = if is_missing(folder)? { Folder::create(folder)? } else { Folder::open(folder)? };
        begun(folder, manifest, plan)
    }

    /// Returns the number of parts.
    pub const fn parts(&self) -> u64 {
        self.manifest.parts()
    }

    /// Returns the members of a part; empty for a part beyond the last.
    pub fn rows(&self, part: u64) -> Range<u64> {
        self.manifest.rows(part)
    }

    /// Returns true if the plan requests trajectories, so that [`Dataset::write_trajectories`] is
    /// needed too.
    pub const fn wants_trajectories(&self) -> bool {
        self.manifest.trajectories()
    }

    /// Returns the parts that are missing or damaged, ascending.
    ///
    /// # Errors
    /// [`SweepError::Read`] if a file cannot be read.
    pub fn missing(&self) -> Result<Vec<u64>, SweepError> {
        let mut missing = Vec::new();
        for part in 0..self.parts() {
            if !self.is_whole(part)? {
                missing.push(part);
            }
        }
        Ok(missing)
    }

    /// Stores the rows of a part, as returned by [`simulate`](crate::simulate), durably.
    /// Trajectories, if requested, must be written before.
    ///
    /// # Errors
    /// [`SweepError::Rows`] if they are not the rows of this part, [`SweepError::Write`].
    pub fn write(&self, part: u64, rows: &Batch) -> Result<(), SweepError> {
        let expected = self.rows(part);
        let Values::Whole(members) = &rows.column("member")?.values else {
            return Err(SweepError::Rows { part, why: "the member numbers are not integers".to_owned() });
        };
        if expected.is_empty() || !members.iter().copied().eq(expected.clone()) {
            let why = format!("the part has members {} … {}", expected.start, expected.end.saturating_sub(1));
            return Err(SweepError::Rows { part, why });
        }
        self.keep(MEMBERS, part, rows)
    }

    /// Stores the trajectories of a part, as returned by [`trajectories`](crate::trajectories),
    /// durably.
    ///
    /// # Errors
    /// [`SweepError::Write`] if the file cannot be written.
    pub fn write_trajectories(&self, part: u64, rows: &Batch) -> Result<(), SweepError> {
        self.keep(TRAJECTORIES, part, rows)
    }

    /// Computes the missing parts in threads of this process. After `stop` only the parts in
    /// progress are completed. `progress` is called after each part.
    ///
    /// The files do not depend on the number of threads.
    ///
    /// # Errors
    /// The first error in any thread.
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

    /// Reads all parts, and writes the summary and the figures. All parts must exist.
    ///
    /// # Errors
    /// [`SweepError::Incomplete`] if a part is missing; [`SweepError::Read`],
    /// [`SweepError::Write`].
    pub fn finish(&self, plan: &Plan, threads: usize) -> Result<Swept, SweepError> {
        let (summary, sample) = statistics::of(plan, self.parts(), threads, &|part| self.read(part))?;
        let swept = Swept::new(summary, sample, plan);
        let figures = swept.figures();
        self.folder.write(HISTOGRAMS, figures.histograms().to_svg().as_bytes())?;
        self.folder.write(PAIRS, figures.pairs().to_svg().as_bytes())?;
        if let Some(questions) = figures.questions() {
            self.folder.write(QUESTIONS, questions.to_svg().as_bytes())?;
        }
        self.folder.write(SUMMARY, (pretty(&swept.summary.to_json()) + "\n").as_bytes())?;
        Ok(swept)
    }

    /// Computes a part unless it exists. Returns true if a damaged or foreign file was replaced.
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

    /// Reads the rows of a part, which must exist.
    fn read(&self, part: u64) -> Result<Batch, SweepError> {
        let path = self.place(MEMBERS, part);
        let rows = parquet::load(&path, &self.manifest.part_metadata(part));
        rows.map_err(SweepError::reading(&path))?.ok_or(SweepError::Incomplete { part })
    }

    /// Returns true if all files of a part exist and are valid.
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

/// Begins a sweep in a folder; the manifest is written last.
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

/// Returns an error if the copy of the plan differs from the plan, because readers of the results
/// rely on it.
fn require_copy(folder: &Folder, plan: &Plan) -> Result<(), SweepError> {
    let path = folder.join(PLAN);
    match fs::read(&path) {
        Ok(copy) if copy == plan.text().as_bytes() => Ok(()),
        Ok(_) => Err(SweepError::Damaged { path, why: "it is not the plan of these results" }),
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            Err(SweepError::Damaged { path, why: "the file is missing" })
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
