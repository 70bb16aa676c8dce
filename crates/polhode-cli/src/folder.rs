//! An output folder that appears complete or not at all.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::failure::Failure;

/// The file by which a folder of results is known, and how it begins.
const SIGNATURE: (&str, &[u8]) = ("summary.json", b"{\n  \"polhode\": ");

/// The page that shows a motion.
pub(crate) const PAGE: &str = "report.html";

/// All files that a folder of results can hold.
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

/// A folder of results in the making: its files are written beside its final place and moved there by
/// [`Folder::publish`]. Dropped before that, it leaves nothing.
#[derive(Debug)]
pub(crate) struct Folder {
    target: PathBuf,
    partial: PathBuf,
    force: bool,
    published: bool,
}

impl Folder {
    /// Refuses a target that is there already, unless it holds nothing but old results and `force` is set.
    pub(crate) fn check(target: &Path, force: bool) -> Result<(), Failure> {
        let shown = target.display();
        if target.file_name().is_none() {
            let hint = "name a folder of its own: -o results/run-1";
            return Err(Failure::usage(format!("{shown} cannot become the output folder"), hint));
        }
        match fs::symlink_metadata(target) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
            Err(error) => Err(output(target, error)),
            Ok(_) if !force => Err(exists(target)),
            Ok(meta) => match stranger(target, &meta) {
                None => Ok(()),
                Some(why) => Err(Failure::usage(
                    format!("{shown} is not a folder of results, so --force does not replace it: {why}"),
                    "remove it by hand, or choose another folder with -o DIR",
                )),
            },
        }
    }

    /// Starts a folder that is to become `target`.
    pub(crate) fn create(target: &Path, force: bool) -> Result<Self, Failure> {
        let name = target.file_name().unwrap_or_default().to_string_lossy();
        let partial = target.with_file_name(format!(".{name}.partial-{}", std::process::id()));
        if let Some(parent) = target.parent().filter(|p| !p.as_os_str().is_empty()) {
            fs::create_dir_all(parent).map_err(|e| output(parent, e))?;
        }
        fs::create_dir(&partial).map_err(|e| output(target, e))?;
        Ok(Self { target: target.to_owned(), partial, force, published: false })
    }

    /// Writes one of [`OURS`].
    pub(crate) fn file(
        &self,
        name: &str,
        write: impl FnOnce(&mut BufWriter<fs::File>) -> io::Result<()>,
    ) -> Result<(), Failure> {
        let path = self.partial.join(name);
        let written = fs::File::create_new(&path).and_then(|file| {
            let mut out = BufWriter::new(file);
            write(&mut out)?;
            out.flush()
        });
        written.map_err(|e| output(&self.target.join(name), e))
    }

    /// Moves the folder to its place. What came there in the meantime stays, and is an error; old results go if
    /// they may.
    pub(crate) fn publish(mut self) -> Result<(), Failure> {
        let failed = |e| output(&self.target, e);
        let old = self.partial.with_extension(format!("old-{}", std::process::id()));
        let replaces = self.force && self.target.exists();
        if replaces {
            Self::check(&self.target, true)?;
            fs::rename(&self.target, &old).map_err(failed)?;
        }
        // Renaming onto anything but an empty folder fails, so nothing is ever overwritten.
        if let Err(error) = fs::rename(&self.partial, &self.target) {
            if replaces {
                let _ = fs::rename(&old, &self.target);
            }
            return Err(if self.target.exists() { exists(&self.target) } else { failed(error) });
        }
        self.published = true;
        if replaces {
            remove(&old).map_err(|e| output(&old, e))?;
        }
        Ok(())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        if !self.published {
            let _ = remove(&self.partial);
        }
    }
}

/// Removes a folder of results: our files, and then the folder, which must be empty.
fn remove(folder: &Path) -> io::Result<()> {
    for name in OURS {
        match fs::remove_file(folder.join(name)) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
    }
    fs::remove_dir(folder)
}

/// What a place holds that is not ours; `None` for an empty folder, or one of results and nothing else.
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
        return Some(format!("it holds {:?}", foreign.file_name()));
    }
    let (name, begins) = SIGNATURE;
    let signed = fs::read(target.join(name)).is_ok_and(|summary| summary.starts_with(begins));
    (!signed && !entries.is_empty()).then(|| format!("its {name} is not one of polhode's"))
}

fn exists(target: &Path) -> Failure {
    Failure::usage(
        format!("{} is there already", target.display()),
        "choose another folder with -o DIR, or replace old results with --force",
    )
}

fn output(path: &Path, error: io::Error) -> Failure {
    Failure::Output { path: path.display().to_string(), error }
}
