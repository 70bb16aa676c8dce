//! Other programs: cargo, and the command of this workspace.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::{Outcome, root, short};

/// True for nightly runs, with all random draws and with the long tests.
pub(crate) static NIGHTLY: AtomicBool = AtomicBool::new(false);

/// Returns a cargo command to be run at the root.
pub(crate) fn cargo(arguments: &[&str]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(arguments).current_dir(root());
    if NIGHTLY.load(Ordering::Relaxed) {
        command.env("POLHODE_NIGHTLY", "1");
    }
    command
}

/// Runs a command with its output on the terminal.
pub(crate) fn run(command: &mut Command) -> Outcome {
    let status = command.status().map_err(|error| format!("{}: {error}", line(command)))?;
    if status.success() { Ok(()) } else { Err(format!("`{}` ended with {status}", line(command))) }
}

/// Runs a command and returns its standard output; its standard error becomes the error message.
pub(crate) fn output(command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|error| format!("{}: {error}", line(command)))?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    let diagnostics = String::from_utf8_lossy(&output.stderr);
    Err(format!("`{}` ended with {}\n{}", line(command), output.status, diagnostics.trim_end()))
}

/// Runs a command in parallel with others; its output is printed when it has ended.
pub(crate) fn run_beside(command: &mut Command) -> Outcome {
    let output = command.output().map_err(|error| format!("{}: {error}", line(command)))?;
    let [printed, diagnostics] = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes));
    println!("{}{}", printed, diagnostics);
    if output.status.success() {
        Ok(())
    } else {
        Err(format!("`{}` ended with {}", line(command), output.status))
    }
}

/// Features for conversions of the core crate, tested and documented but not used by other crates.
pub(crate) const FEATURES: &str = "polhode/serde,polhode/mint,polhode/nalgebra,polhode/glam";

/// Builds `polhode` and returns its path.
pub(crate) fn polhode() -> Result<PathBuf, String> {
    program("polhode")
}

/// Returns the path of a program of the workspace, compiled for the tests.
///
/// A separate build would have other features, and compile all dependencies again. The programs are
/// built once, because cargo would wait for parallel tasks, such as the documentation.
pub(crate) fn program(name: &str) -> Result<PathBuf, String> {
    static BUILT: Mutex<bool> = Mutex::new(false);
    let mut built = BUILT.lock().map_err(|_| "a build panicked".to_owned())?;
    if !*built {
        run(&mut cargo(&["test", "--workspace", "--no-run", "--quiet", "--locked", "--features", FEATURES]))?;
        *built = true;
    }
    Ok(build_folder()?.join(format!("{name}{}", std::env::consts::EXE_SUFFIX)))
}

/// Returns an empty folder inside the build folder.
pub(crate) fn empty_folder(name: &str) -> Result<PathBuf, String> {
    let folder = build_folder()?.join("xtask-tmp").join(name);
    let failed = |error| format!("{}: {error}", folder.display());
    if folder.exists() {
        std::fs::remove_dir_all(&folder).map_err(failed)?;
    }
    std::fs::create_dir_all(&folder).map_err(failed)?;
    Ok(folder)
}

/// Returns the folder of built programs, which also contains this one.
pub(crate) fn build_folder() -> Result<PathBuf, String> {
    let this = std::env::current_exe().map_err(|error| format!("where is this program? {error}"))?;
    Ok(this.parent().unwrap_or(Path::new(".")).to_owned())
}

/// Copies a folder with its contents.
pub(crate) fn copy(from: &Path, to: &Path) -> Outcome {
    let failed = |error| format!("{}: {error}", short(from));
    std::fs::create_dir_all(to).map_err(failed)?;
    for entry in std::fs::read_dir(from).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        let (from, to) = (entry.path(), to.join(entry.file_name()));
        if from.is_dir() {
            copy(&from, &to)?;
        } else {
            std::fs::copy(&from, &to).map_err(failed)?;
        }
    }
    Ok(())
}

/// Returns a command as typed in a shell.
fn line(command: &Command) -> String {
    let program = Path::new(command.get_program());
    let name = program.file_stem().unwrap_or(program.as_os_str());
    let words = std::iter::once(name).chain(command.get_args());
    words.map(|word| word.to_string_lossy().into_owned()).collect::<Vec<_>>().join(" ")
}

/// Returns the result of a parallel step.
pub(crate) fn joined<T>(thread: std::thread::ScopedJoinHandle<'_, Result<T, String>>) -> Result<T, String> {
    thread.join().unwrap_or_else(|_| Err("a step panicked".to_owned()))
}
