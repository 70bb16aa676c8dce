//! Files and folders under construction: written next to their final place, and moved there when
//! complete.
//!
//! `.NAME.partial-PID` is locked during the lifetime of its process; the system releases the lock
//! however the process ends. Another process therefore recognizes an active write, and reports it.
//! It recognizes leftovers of a killed process, and removes them. Ctrl-C and SIGTERM remove
//! unfinished files, and then end the program as usual.

use std::fs::{self, File, TryLockError};
use std::io::{self, BufWriter, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};

use polhode_source::shown;

use crate::failure::Failure;

/// Unfinished targets of this process. The holder of the lock decides whether a target is published
/// or removed.
static IN_THE_MAKING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Name parts of unfinished targets and of old results to be removed, between the target name and
/// the process number.
const PARTIAL: &str = "partial";
pub(crate) const OLD: &str = "old";

/// Function that removes an unfinished target. For a folder it is given by the owner, who knows the
/// possible contents.
type Remove = fn(&Path) -> io::Result<()>;

/// Unfinished target next to its final place. If dropped before it is published, it is removed.
#[derive(Debug)]
pub(crate) struct Partial {
    target: PathBuf,
    path: PathBuf,
    /// Folders that were created for it, the outermost first.
    parents: Vec<PathBuf>,
    remove: Remove,
    /// Lock held until the end; `None` where folders cannot be locked.
    lock: Option<File>,
    published: bool,
}

impl Partial {
    /// Starts a folder for `target` and creates its parent folders; `remove` removes such a folder.
    pub(crate) fn folder(target: &Path, remove: Remove) -> Result<Self, Failure> {
        let parents = make_parents(target).map_err(|error| output(target, error))?;
        Self::claim(target, parents, remove, &|path| {
            fs::create_dir(path)?;
            if cfg!(unix) { File::open(path).map(Some) } else { Ok(None) }
        })
    }

    /// Starts a file for `target`.
    fn file(target: &Path) -> Result<Self, Failure> {
        Self::claim(target, Vec::new(), |path| fs::remove_file(path), &|path| {
            File::create_new(path).map(Some)
        })
    }

    fn claim(
        target: &Path,
        parents: Vec<PathBuf>,
        remove: Remove,
        make: &dyn Fn(&Path) -> io::Result<Option<File>>,
    ) -> Result<Self, Failure> {
        /// Limit on retries: another process that cleans up may interfere between creation and
        /// locking.
        const TRIES: usize = 8;
        remove_on_signals();
        let path = beside(target, PARTIAL, &std::process::id().to_string());
        let mut error = io::Error::from(io::ErrorKind::ResourceBusy);
        for _ in 0..TRIES {
            require_unused(target, remove)?;
            let mut made = in_the_making();
            let lock = match make(&path) {
                Ok(lock) => lock,
                Err(other) => {
                    error = other;
                    continue;
                }
            };
            // Without support for locks, no process cleans up either.
            let _ = lock.as_ref().map(File::lock);
            if fs::symlink_metadata(&path).is_ok() {
                made.push(path.clone());
                drop(made);
                return Ok(Self { target: target.to_owned(), path, parents, remove, lock, published: false });
            }
        }
        parents.iter().rev().for_each(|parent| drop(fs::remove_dir(parent)));
        Err(output(target, error))
    }

    /// Returns the path of the unfinished target.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the path of the final place.
    pub(crate) fn target(&self) -> &Path {
        &self.target
    }

    /// Returns the path for old results that are being replaced.
    pub(crate) fn old(&self) -> PathBuf {
        beside(&self.target, OLD, &std::process::id().to_string())
    }

    /// Moves the target to its place by `rename`; no signal interrupts this.
    pub(crate) fn publish(mut self, rename: impl FnOnce(&Self) -> io::Result<()>) -> io::Result<()> {
        let mut made = in_the_making();
        rename(&self)?;
        made.retain(|path| *path != self.path);
        self.published = true;
        Ok(())
    }
}

impl Drop for Partial {
    fn drop(&mut self) {
        if self.published {
            return;
        }
        let mut made = in_the_making();
        let _ = (self.remove)(&self.path);
        made.retain(|path| *path != self.path);
        for parent in self.parents.iter().rev() {
            // A folder that is not empty is kept.
            let _ = fs::remove_dir(parent);
        }
    }
}

/// Writes a file completely or not at all. It replaces a file only if `force` is set.
pub(crate) fn write(
    target: &Path,
    force: bool,
    write: impl FnOnce(&mut BufWriter<&File>) -> io::Result<()>,
) -> Result<(), Failure> {
    written(target, write)?.publish(|partial| moved(partial, force)).map_err(|error| failed(target, error))
}

/// Writes two files, both or none.
pub(crate) fn write_pair([first, second]: [(&Path, &[u8]); 2], force: bool) -> Result<(), Failure> {
    let all = [first, second].map(|(target, _)| target);
    if let Some(target) = all.into_iter().find(|target| !force && fs::symlink_metadata(target).is_ok()) {
        return Err(exists(target));
    }
    let of = |(target, bytes): (&Path, &[u8])| written(target, |out| out.write_all(bytes));
    let [before, after] = [of(first)?, of(second)?];
    let [first, second] = all;
    // The file that the first one replaces is kept under another name until the second is written.
    let old = before.old();
    let kept = match fs::hard_link(first, &old) {
        Ok(()) => true,
        Err(error) if error.kind() == io::ErrorKind::NotFound => false,
        Err(_) => fs::copy(first, &old).map(|_| true).map_err(|error| failed(first, error))?,
    };
    let moved_first = before.publish(|partial| moved(partial, force)).map_err(|error| failed(first, error));
    let both = moved_first.and_then(|()| {
        after.publish(|partial| moved(partial, force)).map_err(|error| {
            let _ = if kept { fs::rename(&old, first) } else { fs::remove_file(first) };
            failed(second, error)
        })
    });
    if kept {
        // After a failure it has been restored already.
        let _ = fs::remove_file(&old);
    }
    both
}

/// Returns an unfinished file with its complete content.
fn written(
    target: &Path,
    write: impl FnOnce(&mut BufWriter<&File>) -> io::Result<()>,
) -> Result<Partial, Failure> {
    let partial = Partial::file(target)?;
    let written = partial.lock.as_ref().map_or(Ok(()), |file| {
        let mut out = BufWriter::new(file);
        write(&mut out)?;
        out.flush()?;
        drop(out);
        // A full disk may report its error only here.
        file.sync_all()
    });
    written.map_err(|error| failed(target, error))?;
    Ok(partial)
}

/// Moves the file to its place. Without `force` it uses a hard link, which fails for an existing
/// file; a rename would replace it.
fn moved(partial: &Partial, force: bool) -> io::Result<()> {
    if force {
        return fs::rename(partial.path(), partial.target());
    }
    match fs::hard_link(partial.path(), partial.target()) {
        Err(error) if error.kind() != io::ErrorKind::AlreadyExists => {
            fs::rename(partial.path(), partial.target())
        }
        Ok(()) => fs::remove_file(partial.path()),
        refused => refused,
    }
}

fn failed(target: &Path, error: io::Error) -> Failure {
    match error.kind() {
        io::ErrorKind::AlreadyExists => exists(target),
        _ => output(target, error),
    }
}

/// Returns the error for an existing file or folder that must not be replaced.
pub(crate) fn exists(target: &Path) -> Failure {
    Failure::usage(
        format!("{} already exists", shown(target)),
        "choose another path, or overwrite with --force",
    )
}

/// Returns the error for a path that cannot be written.
pub(crate) fn output(path: &Path, error: io::Error) -> Failure {
    Failure::Output { path: shown(path), error }
}

/// Removes the leftovers of killed processes for a target.
///
/// # Errors
/// An error if a running process writes to the target.
fn require_unused(target: &Path, remove: Remove) -> Result<(), Failure> {
    // If the folder cannot be listed, leftovers cannot be removed.
    let Ok(found) = traces(target) else { return Ok(()) };
    let mut stale = Vec::new();
    for (path, kind) in found {
        let Ok(file) = File::open(&path) else { continue };
        match file.try_lock() {
            Ok(()) => stale.push((path, kind, file)),
            Err(TryLockError::WouldBlock) => {
                let message = format!("{} is being written by another polhode process", shown(target));
                return Err(Failure::usage(message, "wait until it ends, or choose another path with -o"));
            }
            Err(TryLockError::Error(_)) => {}
        }
    }
    for (path, kind, _lock) in stale {
        // Old results are restored if their replacement was never completed.
        let _ = match kind {
            OLD if fs::symlink_metadata(target).is_err() => fs::rename(&path, target),
            _ => remove(&path),
        };
    }
    Ok(())
}

/// Returns all leftovers next to a target, with their kind.
fn traces(target: &Path) -> io::Result<Vec<(PathBuf, &'static str)>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(parent(target))? {
        let entry = entry?;
        let name = entry.file_name();
        let is_ours = |kind: &&str| {
            let number = name.to_str().and_then(|name| name.rsplit_once('-')).map(|(_, number)| number);
            number.is_some_and(|number| {
                number.parse::<u32>().is_ok() && beside(target, kind, number).file_name() == Some(&name)
            })
        };
        let kind = entry.file_type()?;
        if let Some(ours) = [PARTIAL, OLD].into_iter().find(is_ours)
            && (kind.is_file() || kind.is_dir())
        {
            found.push((entry.path(), ours));
        }
    }
    Ok(found)
}

/// Returns the path `.NAME.KIND-NUMBER` next to a target.
fn beside(target: &Path, kind: &str, number: &str) -> PathBuf {
    let mut name = std::ffi::OsString::from(".");
    name.push(target.file_name().unwrap_or_default());
    name.push(format!(".{kind}-{number}"));
    target.with_file_name(name)
}

/// Returns the folder of a file, `.` for a bare file name.
pub(crate) fn parent(target: &Path) -> &Path {
    target.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Creates the parent folders of a target; returns the new ones.
fn make_parents(target: &Path) -> io::Result<Vec<PathBuf>> {
    let parent = parent(target);
    let mut missing: Vec<PathBuf> = parent
        .ancestors()
        .take_while(|folder| !folder.as_os_str().is_empty() && !folder.exists())
        .map(Path::to_owned)
        .collect();
    missing.reverse();
    fs::create_dir_all(parent)?;
    Ok(missing)
}

fn in_the_making() -> MutexGuard<'static, Vec<PathBuf>> {
    IN_THE_MAKING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Installs handlers for SIGINT and SIGTERM that remove unfinished targets before the program ends.
#[cfg(unix)]
fn remove_on_signals() {
    use signal_hook::consts::{SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;

    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // Without handlers the signals end the program immediately, and the next run cleans up.
        let Ok(mut signals) = Signals::new([SIGINT, SIGTERM]) else { return };
        let watch = move || {
            let Some(signal) = signals.forever().next() else { return };
            // The lock is held until the end, so that no target is published any more and no other
            // error is reported.
            let made = in_the_making();
            for path in &*made {
                let _ = if path.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
            }
            let _ = emulate_default_handler(signal);
            std::process::exit(128 + signal);
        };
        let _ = std::thread::Builder::new().name("signals".to_owned()).spawn(watch);
    });
}

/// Does nothing on other systems: the next run cleans up.
#[cfg(not(unix))]
fn remove_on_signals() {}
