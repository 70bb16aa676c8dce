//! Output folder that appears complete or not at all.

use std::fs;
use std::io::{self, BufWriter};
use std::path::{Path, PathBuf};

use serde_json::Value;

use polhode_source::shown;

use crate::failure::Failure;
use crate::partial::{Partial, exists, output};

/// File that identifies a folder of results, and its first bytes.
const SIGNATURE: (&str, &[u8]) = ("summary.json", b"{\n  \"polhode\": ");

/// Page that shows a motion.
pub(crate) const PAGE: &str = "report.html";

/// All files that a folder of results may contain.
const OURS: [&str; 9] = [
    SIGNATURE.0,
    PAGE,
    "trajectory.parquet",
    "trajectory.csv",
    "polhode.csv",
    "momentum.csv",
    "herpolhode.csv",
    "body_cone.csv",
    "space_cone.csv",
];

/// Lists the files written to a folder: `wrote brick/: summary.json, report.html`.
pub(crate) fn wrote(folder: &Path, names: &[impl AsRef<str>]) -> String {
    let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    format!("wrote {}/: {}", shown(folder), names.join(", "))
}

/// Policy for replacing existing results.
#[derive(Clone, Debug)]
pub(crate) enum Replace {
    /// Replaces nothing.
    Never,
    /// Replaces results of the scenario at this path, as recorded in their summary.
    ResultsOf(PathBuf),
    /// Replaces any results.
    Forced,
}

impl Replace {
    /// Returns [`Self::Forced`] if `force` is set, else the policy for results of this scenario.
    pub(crate) fn results_of(scenario: &Path, force: bool) -> Self {
        if force { Self::Forced } else { Self::ResultsOf(scenario.to_owned()) }
    }

    /// Returns [`Self::Forced`] if `force` is set, else [`Self::Never`].
    pub(crate) const fn forced(force: bool) -> Self {
        if force { Self::Forced } else { Self::Never }
    }

    /// Returns true if the results in this folder may be replaced, according to their summary.
    fn allows(&self, folder: &Path) -> bool {
        match self {
            Self::Never => false,
            Self::Forced => true,
            Self::ResultsOf(scenario) => {
                let summary = fs::read(folder.join(SIGNATURE.0)).ok();
                let summary = summary.and_then(|bytes| serde_json::from_slice::<Value>(&bytes).ok());
                summary.is_some_and(|summary| summary["source"]["path"] == scenario.display().to_string())
            }
        }
    }
}

/// Folder of results under construction. Its files are written next to the final place and moved
/// there by [`Folder::publish`]. If dropped before, it is removed.
#[derive(Debug)]
pub(crate) struct Folder {
    partial: Partial,
    replace: Replace,
}

impl Folder {
    /// Refuses an existing target, unless it contains only old results that may be replaced.
    pub(crate) fn check(target: &Path, replace: &Replace) -> Result<(), Failure> {
        let shown = shown(target);
        if target.file_name().is_none() {
            let hint = "choose a separate folder: -o results/run-1";
            return Err(Failure::usage(format!("{shown} cannot be the output folder"), hint));
        }
        match fs::symlink_metadata(target) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
            Err(error) => Err(output(target, error)),
            Ok(_) if !replace.allows(target) => Err(exists(target)),
            Ok(meta) => match (stranger(target, &meta), replace) {
                (None, _) => Ok(()),
                (Some(why), Replace::ResultsOf(_)) => Err(Failure::usage(
                    format!("{shown} already exists and is not replaced: {why}"),
                    "remove it yourself, or choose another folder with -o DIR",
                )),
                (Some(why), _) => Err(Failure::usage(
                    format!("{shown} is not a folder of results, so --force does not replace it: {why}"),
                    "remove it yourself, or choose another folder with -o DIR",
                )),
            },
        }
    }

    /// Starts a folder for `target`; no other process can write to the same target meanwhile.
    pub(crate) fn create(target: &Path, replace: Replace) -> Result<Self, Failure> {
        Self::check(target, &replace)?;
        let partial = Partial::folder(target, remove)?;
        // A previous run may have been killed while it replaced old results; these are restored by
        // now.
        Self::check(target, &replace)?;
        Ok(Self { partial, replace })
    }

    /// Writes one of the files in [`OURS`].
    pub(crate) fn file(
        &self,
        name: &str,
        write: impl FnOnce(&mut BufWriter<fs::File>) -> io::Result<()>,
    ) -> Result<(), Failure> {
        let path = self.partial.path().join(name);
        let written = fs::File::create_new(&path).and_then(|file| {
            let mut out = BufWriter::new(file);
            write(&mut out)?;
            // A full disk may report its error only here.
            out.into_inner()?.sync_all()
        });
        written.map_err(|e| output(&self.partial.target().join(name), e))
    }

    /// Moves the folder to its place. Content that appeared there in the meantime is kept, and is
    /// an error. Old results are removed if that is allowed.
    pub(crate) fn publish(self) -> Result<(), Failure> {
        let (target, old) = (self.partial.target().to_owned(), self.partial.old());
        let replaces = target.exists() && self.replace.allows(&target);
        if replaces {
            Self::check(&target, &self.replace)?;
        }
        let published = self.partial.publish(|partial| {
            if replaces {
                fs::rename(&target, &old)?;
            }
            // Renaming onto a folder that is not empty fails, so nothing is ever overwritten.
            fs::rename(partial.path(), &target).inspect_err(|_| {
                if replaces && fs::rename(&old, &target).is_err() {
                    // Another process has replaced them in the meantime.
                    let _ = remove(&old);
                }
            })
        });
        if let Err(error) = published {
            return Err(if target.exists() { exists(&target) } else { output(&target, error) });
        }
        if replaces {
            remove(&old).map_err(|e| output(&old, e))?;
        }
        Ok(())
    }
}

/// Removes a folder of results: first the known files, then the folder, which must be empty.
fn remove(folder: &Path) -> io::Result<()> {
    for name in OURS {
        match fs::remove_file(folder.join(name)) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
    }
    match fs::remove_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        other => other,
    }
}

/// Describes foreign content at the target; `None` for an empty folder, or one with results only.
fn stranger(target: &Path, meta: &fs::Metadata) -> Option<String> {
    if !meta.is_dir() {
        return Some(if meta.is_symlink() { "it is a link" } else { "it is a file" }.to_owned());
    }
    let entries = match fs::read_dir(target).and_then(Iterator::collect::<io::Result<Vec<_>>>) {
        Ok(entries) => entries,
        Err(error) => return Some(error.to_string()),
    };
    let foreign = entries.iter().find(|e| !OURS.iter().any(|ours| e.file_name() == *ours));
    if let Some(foreign) = foreign {
        return Some(format!("it contains {:?}", foreign.file_name()));
    }
    let (name, begins) = SIGNATURE;
    let signed = fs::read(target.join(name)).is_ok_and(|summary| summary.starts_with(begins));
    (!signed && !entries.is_empty()).then(|| format!("its {name} was not written by polhode"))
}
