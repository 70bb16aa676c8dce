//! Clippy beside the compiler: what stands between cargo and rustc while the gate runs, so that what is linted and what is run share all libraries.
//!
//! Clippy could compile too, but it does so without the optimisations of MIR: LLVM has more to do then, and what is tested is not what rustc makes.

use std::ffi::{OsStr, OsString};
use std::path::Path;
use std::process::{Command, ExitCode, ExitStatus};

/// Set where this program is called in the place of rustc.
const WRAPS: &str = "XTASK_LINTS";

/// Makes a command that calls cargo lint what it compiles of the workspace, by a copy of this program; a warning is an error.
pub(crate) fn wrap(command: &mut Command, linter: &Path) {
    command.env("RUSTC_WORKSPACE_WRAPPER", linter).env(WRAPS, "1");
    // As `cargo clippy -- -D warnings` sets them.
    command.env("CLIPPY_ARGS", ["-D", "warnings", ""].join("__CLIPPY_HACKERY__"));
}

/// Whether cargo calls this program in the place of rustc, with the path of that and its arguments.
pub(crate) fn is_wrapper() -> bool {
    std::env::var_os(WRAPS).is_some() && std::env::args_os().nth(1).is_some_and(|first| is_rustc(&first))
}

/// Lints, and then compiles; a warning of the compiler is an error too.
pub(crate) fn run() -> ExitCode {
    let mut arguments: Vec<OsString> = std::env::args_os().skip(1).collect();
    if arguments.is_empty() {
        return ExitCode::FAILURE;
    }
    let rustc = arguments.remove(0);
    let has = |name: &str| arguments.iter().any(|argument| argument == name);
    // What has no name of its own asks rustc about itself.
    if has("--crate-name") && !has("-") {
        if !is_linted_as_test(&arguments, &manifest()) {
            let status = Command::new("clippy-driver").arg(&rustc).args(of_lints(&arguments)).status();
            if let Some(failed) = failed("clippy-driver", status) {
                return failed;
            }
        }
        arguments.push("-Dwarnings".into());
    }
    failed("rustc", Command::new(rustc).args(arguments).status()).unwrap_or(ExitCode::SUCCESS)
}

/// Returns true for a library whose tests are compiled too: Clippy sees all of its code there.
fn is_linted_as_test(arguments: &[OsString], manifest: &str) -> bool {
    let is_library = arguments.windows(2).any(|pair| pair[0] == "--crate-type" && pair[1] == "lib");
    let is_test = arguments.iter().any(|argument| argument == "--test");
    let of_library =
        manifest.split("\n[").find(|section| section.trim_start_matches('[').starts_with("lib]"));
    let is_tested = !of_library.is_some_and(|section| section.contains("\ntest = false"));
    is_library && !is_test && is_tested
}

/// The manifest of the crate that cargo compiles.
fn manifest() -> String {
    let folder = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default();
    std::fs::read_to_string(Path::new(&folder).join("Cargo.toml")).unwrap_or_default()
}

fn is_rustc(path: &OsStr) -> bool {
    Path::new(path).file_stem().is_some_and(|name| name == "rustc")
}

/// How this program ends if another has failed.
pub(crate) fn failed(program: &str, status: std::io::Result<ExitStatus>) -> Option<ExitCode> {
    match status {
        Ok(status) if status.success() => None,
        Ok(status) => {
            Some(ExitCode::from(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)))
        }
        Err(error) => {
            eprintln!("{program}: {error}");
            Some(ExitCode::FAILURE)
        }
    }
}

/// The arguments of a run that makes nothing but metadata, in a folder that nobody reads: cargo is not told of it.
fn of_lints(arguments: &[OsString]) -> Vec<OsString> {
    let mut found: Vec<OsString> = Vec::new();
    let mut is_folder = false;
    for argument in arguments {
        let text = argument.to_string_lossy();
        found.push(if is_folder {
            Path::new(argument).join("linted").into_os_string()
        } else if text.starts_with("--emit=") {
            "--emit=metadata".into()
        } else if let Some(told) = text.strip_prefix("--json=") {
            let kept: Vec<&str> = told.split(',').filter(|what| *what != "artifacts").collect();
            format!("--json={}", kept.join(",")).into()
        } else {
            argument.clone()
        });
        is_folder = argument == "--out-dir";
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_library_is_linted_once() {
        let library = ["--crate-name", "a", "--crate-type", "lib"].map(OsString::from);
        let test = ["--crate-name", "a", "--test"].map(OsString::from);
        let binary = ["--crate-name", "a", "--crate-type", "bin"].map(OsString::from);
        assert!(is_linted_as_test(&library, "[lib]\ndoctest = false\n\n[[bin]]\ntest = false\n"));
        assert!(!is_linted_as_test(&library, "[lib]\ntest = false\n"));
        assert!(!is_linted_as_test(&test, "") && !is_linted_as_test(&binary, ""));
    }

    #[test]
    fn a_lint_makes_metadata_apart_and_tells_cargo_of_warnings_only() {
        let given = [
            "--crate-name",
            "a",
            "--json=diagnostic-rendered-ansi,artifacts,future-incompat",
            "--emit=dep-info,metadata,link",
            "--out-dir",
            "/t/deps",
            "-L",
            "/t/deps",
        ];
        let wanted = [
            "--crate-name",
            "a",
            "--json=diagnostic-rendered-ansi,future-incompat",
            "--emit=metadata",
            "--out-dir",
            "/t/deps/linted",
            "-L",
            "/t/deps",
        ];
        assert_eq!(of_lints(&given.map(OsString::from)), wanted.map(OsString::from));
    }
}
