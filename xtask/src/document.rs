//! The documentation of the crates beside the tests of its examples: what stands between cargo and rustdoc while the gate runs, so that what is documented
//! and what is run share all libraries. `cargo doc` compiles every dependency once more.

use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, ExitCode};

use crate::lint;

/// Set where this program is called in the place of rustdoc, to the folder of the documentation.
const FOLDER: &str = "XTASK_DOCUMENTS";

/// Makes a command that calls `cargo test --doc` document what it tests, by a copy of this program; a warning is an error.
pub(crate) fn wrap(command: &mut Command, this: &Path, folder: &Path) {
    command.env("RUSTDOC", this).env(FOLDER, folder);
}

/// Runs rustdoc in whose place this program is called, if it is: the tests, and then the documentation.
pub(crate) fn in_place_of_rustdoc() -> Option<ExitCode> {
    let folder = std::env::var_os(FOLDER)?;
    let arguments: Vec<OsString> = std::env::args_os().skip(1).collect();
    let mut runs = vec![arguments.clone()];
    if arguments.iter().any(|argument| argument == "--test") {
        runs.push(documenting(&arguments, Path::new(&folder)));
    }
    let failed =
        runs.iter().find_map(|run| lint::failed("rustdoc", Command::new("rustdoc").args(run).status()));
    Some(failed.unwrap_or(ExitCode::SUCCESS))
}

/// The arguments of tests, for documentation in a folder.
fn documenting(arguments: &[OsString], folder: &Path) -> Vec<OsString> {
    let mut found = Vec::new();
    let mut arguments = arguments.iter();
    while let Some(argument) = arguments.next() {
        match argument.to_str() {
            Some("--test" | "--no-run" | "--nocapture") => {}
            Some("--test-run-directory" | "--test-args" | "--test-runtool" | "--test-runtool-arg") => {
                arguments.next();
            }
            _ => found.push(argument.clone()),
        }
    }
    found.extend(["-D", "warnings", "--out-dir"].map(OsString::from));
    found.push(folder.into());
    // As cargo says, of the crate that is tested.
    if let Some(version) = std::env::var_os("CARGO_PKG_VERSION") {
        found.extend(["--crate-version".into(), version]);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_only_tests_have_is_left_out() {
        let given =
            ["--crate-name", "a", "--test", "src/lib.rs", "--test-run-directory", "/w/a", "-L", "/t/deps"];
        let found = documenting(&given.map(OsString::from), Path::new("/t/doc"));
        let wanted =
            ["--crate-name", "a", "src/lib.rs", "-L", "/t/deps", "-D", "warnings", "--out-dir", "/t/doc"];
        assert_eq!(found[..9], wanted.map(OsString::from));
    }
}
