//! Expansion of xacro files by the user's own program `xacro`, if requested.
//!
//! A xacro file can run Python, so nothing is expanded without `--xacro`. The program is started
//! directly, without a shell; its output takes the place of the file's text.

use std::ffi::{OsStr, OsString};
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use clap::Args;
use polhode_source::files::{Disk, Overlay};
use polhode_source::shown;

use crate::failure::Failure;

/// Longest time for one file.
const LIMIT: Duration = Duration::from_secs(60);

/// Pause between two looks at a running program.
const PAUSE: Duration = Duration::from_millis(10);

/// Number of lines of messages that are quoted, the last ones.
const QUOTED: usize = 6;

/// Options for xacro files.
#[derive(Debug, Args)]
pub(crate) struct XacroFlags {
    /// Expand xacro files by the program xacro, which must be on the path. A xacro file can run
    /// code: use this for files that you trust.
    #[arg(long)]
    xacro: bool,
    /// Argument for xacro, such as prefix:=left_; may be repeated.
    #[arg(long = "xacro-arg", value_name = "NAME:=VALUE", requires = "xacro")]
    xacro_args: Vec<String>,
}

impl XacroFlags {
    /// Returns the files of this machine, with the expansions of all xacro files among `named`.
    ///
    /// A file that xacro cannot expand cannot be opened; its error quotes xacro's.
    ///
    /// # Errors
    /// [`Failure`] if no file is a xacro file, if an argument is malformed, or without xacro.
    pub(crate) fn expand<'p>(
        &self,
        named: impl IntoIterator<Item = &'p PathBuf>,
    ) -> Result<Overlay<'static>, Failure> {
        let mut files = Overlay::new(&Disk);
        if !self.xacro {
            return Ok(files);
        }
        if let Some(argument) = self.xacro_args.iter().find(|argument| !is_argument(argument)) {
            return Err(Failure::usage(
                format!("--xacro-arg {argument:?} is not of the form NAME:=VALUE"),
                "write, for example, --xacro-arg prefix:=left_",
            ));
        }
        for path in named.into_iter().filter(|path| is_xacro(path)) {
            files.insert(path, expansion(path, &self.xacro_args)?);
        }
        if files.paths().next().is_none() {
            return Err(Failure::usage(
                "--xacro is given, but no named file is a xacro file",
                "name a file that ends in .xacro or declares xmlns:xacro, or leave out --xacro",
            ));
        }
        Ok(files)
    }
}

/// Refuses to write a new text of a model that is expanded; `option` would write it.
pub(crate) fn require_not_expanded(files: &Overlay<'_>, option: &str) -> Result<(), Failure> {
    match files.paths().next() {
        Some(path) => Err(Failure::usage(
            format!("{option} cannot change {}, which is expanded by xacro", shown(path)),
            format!("edit its macros; {option} without a file prints the diff of the expanded text"),
        )),
        None => Ok(()),
    }
}

/// Returns true for `NAME:=VALUE` whose name cannot be an option.
fn is_argument(argument: &str) -> bool {
    argument.split_once(":=").is_some_and(|(name, _)| !name.is_empty() && !name.starts_with('-'))
}

/// Returns true for a file with the extension `.xacro`, or with the declaration of the prefix.
fn is_xacro(path: &Path) -> bool {
    path.extension() == Some(OsStr::new("xacro"))
        || path.is_file() && std::fs::read_to_string(path).is_ok_and(|text| text.contains("xmlns:xacro"))
}

/// Returns the expansion of a file, or the reason why there is none.
///
/// # Errors
/// [`Failure`] if xacro cannot be started.
fn expansion(path: &Path, arguments: &[String]) -> Result<Result<Vec<u8>, String>, Failure> {
    // A name that begins with a hyphen would be an option.
    let file = if path.is_relative() { Path::new(".").join(path) } else { path.to_owned() };
    let arguments = arguments.iter().map(OsString::from);
    let ran = run("xacro", std::iter::once(file.into()).chain(arguments).collect(), LIMIT);
    let Ran { status, output, messages } = ran.map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => Failure::usage(
            "--xacro needs the program xacro, which is not on the path",
            "install it (pip install xacro), or source the setup file of ROS",
        ),
        _ => Failure::usage(format!("xacro cannot be started: {error}"), ""),
    })?;
    Ok(match status {
        None => Err(format!("xacro did not end within {} s", LIMIT.as_secs())),
        Some(status) if !status.success() => Err(format!("xacro failed, {status}{}", quoted(&messages))),
        Some(_) if output.iter().all(u8::is_ascii_whitespace) => {
            Err(format!("xacro printed nothing{}", quoted(&messages)))
        }
        Some(_) => Ok(output),
    })
}

/// Returns the last lines of messages on one line, after a colon.
fn quoted(messages: &[u8]) -> String {
    let text = String::from_utf8_lossy(messages);
    let lines: Vec<&str> = text.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    let last = lines.get(lines.len().saturating_sub(QUOTED)..).unwrap_or_default();
    if last.is_empty() { String::new() } else { format!(": {}", last.join("; ")) }
}

/// Result of a program: no status if it was stopped at the time limit.
struct Ran {
    status: Option<ExitStatus>,
    output: Vec<u8>,
    messages: Vec<u8>,
}

/// Runs a program without input, at most for a time.
///
/// # Errors
/// I/O error if it cannot be started, or if its output cannot be read.
fn run(program: &str, arguments: Vec<OsString>, limit: Duration) -> io::Result<Ran> {
    let mut command = Command::new(program);
    command.args(arguments).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn()?;
    let end = Instant::now() + limit;
    let [output, messages] = [read_all(child.stdout.take()), read_all(child.stderr.take())];
    let stopped = || Ran { status: None, output: Vec::new(), messages: Vec::new() };
    let Some(status) = wait(&mut child, end)? else { return Ok(stopped()) };
    // Another program that it has started may keep the pipe open.
    let rest = || end.saturating_duration_since(Instant::now());
    match (output.recv_timeout(rest()), messages.recv_timeout(rest())) {
        (Ok(output), Ok(messages)) => Ok(Ran { status: Some(status), output: output?, messages: messages? }),
        (Err(RecvTimeoutError::Timeout), _) | (_, Err(RecvTimeoutError::Timeout)) => Ok(stopped()),
        _ => Err(io::Error::other("its output cannot be read")),
    }
}

/// Waits for the end of a program, and ends it at the time limit.
fn wait(child: &mut Child, end: Instant) -> io::Result<Option<ExitStatus>> {
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        if Instant::now() >= end {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        thread::sleep(PAUSE);
    }
}

/// Reads a pipe to its end on another thread.
fn read_all(pipe: Option<impl Read + Send + 'static>) -> Receiver<io::Result<Vec<u8>>> {
    let (sender, receiver) = channel();
    thread::spawn(move || {
        let mut bytes = Vec::new();
        let read = pipe.map_or(Ok(0), |mut pipe| pipe.read_to_end(&mut bytes));
        // Without a receiver the time limit has passed.
        let _ = sender.send(read.map(|_| bytes));
    });
    receiver
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn a_program_is_stopped_at_the_time_limit() {
        let begin = Instant::now();
        let ran = run("sleep", vec!["20".into()], Duration::from_millis(100)).unwrap();
        assert!(ran.status.is_none() && begin.elapsed() < Duration::from_secs(10));
        // A program in the background keeps the pipe open.
        let ran =
            run("sh", vec!["-c".into(), "sleep 20 & echo a".into()], Duration::from_millis(300)).unwrap();
        assert!(ran.status.is_none() && begin.elapsed() < Duration::from_secs(10));
    }

    #[test]
    fn arguments_cannot_be_options() {
        assert!(is_argument("prefix:=") && is_argument("a:=b:=c"));
        assert!(!is_argument("prefix=a") && !is_argument(":=a") && !is_argument("--output:=a"));
    }
}
