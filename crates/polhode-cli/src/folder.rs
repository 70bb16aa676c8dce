//! An output folder that appears complete or not at all.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::failure::Failure;

/// The file by which a folder of results is known.
const SIGNATURE: &str = "summary.json";

/// A folder of results in the making: its files are written beside its final place and moved there by [`Folder::publish`].
/// Dropped before that, it leaves nothing.
#[derive(Debug)]
pub(crate) struct Folder {
    target: PathBuf,
    partial: PathBuf,
    published: bool,
}

impl Folder {
    /// Refuses a target that is there already, unless it holds old results and `force` is set.
    pub(crate) fn check(target: &Path, force: bool) -> Result<(), Failure> {
        let shown = target.display();
        if target.file_name().is_none() {
            let hint = "name a folder of its own: -o results/run-1";
            return Err(Failure::usage(format!("{shown} cannot become the output folder"), hint));
        }
        match fs::symlink_metadata(target) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
            Err(error) => Err(output(target, error)),
            Ok(_) if !force => Err(Failure::usage(
                format!("{shown} is there already"),
                "choose another folder with -o DIR, or replace it with --force",
            )),
            Ok(meta) if meta.is_dir() && is_ours(target) => Ok(()),
            Ok(_) => Err(Failure::usage(
                format!("{shown} is not a folder of results, so --force does not replace it"),
                format!("it has no {SIGNATURE}; remove it by hand, or choose another folder with -o DIR"),
            )),
        }
    }

    /// Starts a folder that is to become `target`.
    pub(crate) fn create(target: &Path) -> Result<Self, Failure> {
        let name = target.file_name().unwrap_or_default().to_string_lossy();
        let partial = target.with_file_name(format!(".{name}.partial-{}", std::process::id()));
        if let Some(parent) = target.parent().filter(|p| !p.as_os_str().is_empty()) {
            fs::create_dir_all(parent).map_err(|e| output(parent, e))?;
        }
        fs::create_dir(&partial).map_err(|e| output(&partial, e))?;
        Ok(Self { target: target.to_owned(), partial, published: false })
    }

    /// Writes one file.
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

    /// Moves the folder to its place; old results there go.
    pub(crate) fn publish(mut self) -> Result<(), Failure> {
        let failed = |e| output(&self.target, e);
        if self.target.exists() {
            let old = self.partial.with_extension("old");
            fs::rename(&self.target, &old).map_err(failed)?;
            if let Err(error) = fs::rename(&self.partial, &self.target) {
                // Put back what was there.
                let _ = fs::rename(&old, &self.target);
                return Err(failed(error));
            }
            fs::remove_dir_all(&old).map_err(failed)?;
        } else {
            fs::rename(&self.partial, &self.target).map_err(failed)?;
        }
        self.published = true;
        Ok(())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        if !self.published {
            let _ = fs::remove_dir_all(&self.partial);
        }
    }
}

/// An empty folder, or one that holds results of this program.
fn is_ours(target: &Path) -> bool {
    target.join(SIGNATURE).is_file() || fs::read_dir(target).is_ok_and(|mut entries| entries.next().is_none())
}

fn output(path: &Path, error: io::Error) -> Failure {
    Failure::Output { path: path.display().to_string(), error }
}
