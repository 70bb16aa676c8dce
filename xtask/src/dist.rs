//! Release archives: the program for one platform, with its documentation, for users without Rust.
//!
//! The release workflow only calls this task, so its output can be reproduced locally. Equal
//! sources, compiler and `SOURCE_DATE_EPOCH` give equal bytes.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::archive::{Packed, sha256_line, tar_gz, zip};
use crate::notices::notices;
use crate::process::{cargo, empty_folder, output, polhode, run};
use crate::{Outcome, root};

/// Shells with completions, and the file name that each expects.
const SHELLS: [(&str, &str); 5] = [
    ("bash", "polhode.bash"),
    ("zsh", "_polhode"),
    ("fish", "polhode.fish"),
    ("powershell", "_polhode.ps1"),
    ("elvish", "polhode.elv"),
];

/// Files included unchanged.
const TEXTS: [&str; 4] = ["README.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE"];

/// Commands that must succeed in an unpacked archive, in bash.
const TRIED: [&str; 3] = [
    "! command -v sha256sum > tools.txt || sha256sum --quiet --check SHA256SUMS",
    "tar xzf polhode.tar.gz && test -x polhode && test ! -x README.md",
    "source completions/polhode.bash
     COMP_WORDS=(polhode spi) COMP_CWORD=1
     _polhode polhode spi polhode
     test \"${COMPREPLY[*]}\" = spin",
];

/// Builds the program and packs it into `target/dist/`, with a SHA256SUMS of all archives there.
///
/// This machine must be able to run programs for `target`, because the program generates its
/// completions and man pages. A `target` with a glibc version, such as
/// `x86_64-unknown-linux-gnu.2.17`, gives a program for that version and later; it is built by
/// cargo-zigbuild.
pub(crate) fn make(target: Option<&str>) -> Outcome {
    let host = host()?;
    let target = target.unwrap_or(&host);
    let triple = target.split_once("-gnu.").map_or(target.to_owned(), |(start, _)| format!("{start}-gnu"));
    let program = build(target, &triple)?;
    let version = ask(&program, &["--version"])?;
    let version = version.trim().strip_prefix("polhode ").ok_or("the program does not say its version")?;
    let name = format!("polhode-{version}-{triple}");
    let bytes = std::fs::read(&program).map_err(|error| format!("{}: {error}", program.display()))?;
    let is_windows = triple.contains("windows");
    let mut files = contents(&program, bytes, is_windows)?;
    files.push(text("THIRD-PARTY-LICENSES.txt", notices(&triple)?));
    let files: Vec<Packed> =
        files.into_iter().map(|file| Packed { path: format!("{name}/{}", file.path), ..file }).collect();
    let folder = build_folder().join("dist");
    let (file, packed) = if is_windows {
        (format!("{name}.zip"), zip(&files)?)
    } else {
        (format!("{name}.tar.gz"), tar_gz(&files, seconds()?)?)
    };
    write(&folder, &file, &packed)?;
    write(&folder, "SHA256SUMS", sums(&folder)?.as_bytes())?;
    println!(
        "   {}, {:.1} MB, {} files",
        folder.join(file).display(),
        packed.len() as f64 / 1e6,
        files.len()
    );
    Ok(())
}

/// Returns the path of the archive that [`make`] has made for a platform.
pub(crate) fn archive(triple: &str) -> PathBuf {
    build_folder().join(format!("dist/polhode-{}-{triple}.tar.gz", env!("CARGO_PKG_VERSION")))
}

/// Checks an archive like that of [`make`], but with a dummy program, to avoid a release build.
pub(crate) fn check() -> Outcome {
    let program = polhode()?;
    let files = contents(&program, b"no program".to_vec(), cfg!(windows))?;
    let paths: Vec<&str> = files.iter().map(|file| file.path.as_str()).collect();
    for needed in ["man/polhode.1", "man/polhode-spin.1", "man/polhode-man.1", "examples/t-handle.toml"] {
        if !paths.contains(&needed) {
            return Err(format!("{needed} is not among {paths:?}"));
        }
    }
    let folder = empty_folder("dist")?;
    let packed = tar_gz(&files, 0)?;
    write(&folder, "polhode.tar.gz", &packed)?;
    write(&folder, "polhode.zip", &zip(&files)?)?;
    write(&folder, "SHA256SUMS", sums(&folder)?.as_bytes())?;
    for script in TRIED {
        run(Command::new("bash").args(["-euc", script]).current_dir(&folder))?;
    }
    println!(
        "   {} files, {} man pages",
        files.len(),
        paths.iter().filter(|path| path.starts_with("man/")).count()
    );
    notices(&host()?).map(drop)
}

/// Returns the files of an archive; `program` generates its completions and man pages.
fn contents(program: &Path, bytes: Vec<u8>, is_windows: bool) -> Result<Vec<Packed>, String> {
    let name = if is_windows { "polhode.exe" } else { "polhode" };
    let mut found = vec![Packed { path: name.to_owned(), is_program: true, bytes }];
    for name in TEXTS {
        found.push(stored(name)?);
    }
    for (shell, file) in SHELLS {
        found.push(text(&format!("completions/{file}"), ask(program, &["completions", shell])?));
    }
    let page = ask(program, &["man"])?;
    for subcommand in subcommands(&page) {
        found.push(text(&format!("man/polhode-{subcommand}.1"), ask(program, &["man", &subcommand])?));
    }
    found.push(text("man/polhode.1", page));
    // Only files tracked by git are included.
    let examples = output(Command::new("git").args(["ls-files", "examples"]).current_dir(root()))?;
    for path in examples.lines() {
        found.push(stored(path)?);
    }
    Ok(found)
}

/// Returns the subcommands listed in the man page, in lines `polhode\-spin(1)`.
fn subcommands(page: &str) -> Vec<String> {
    let named = page.lines().filter_map(|line| line.strip_prefix("polhode\\-")?.strip_suffix("(1)"));
    named.map(|name| name.replace("\\-", "-")).collect()
}

/// Variable with the flags of the compiler, separated by the character 0x1F.
pub(crate) const FLAGS: &str = "CARGO_ENCODED_RUSTFLAGS";

/// Builds the program without paths of this machine in it.
fn build(target: &str, triple: &str) -> Result<PathBuf, String> {
    let verb = if target == triple { "build" } else { "zigbuild" };
    let program = ["--locked", "--package", "polhode-cli", "--bin", "polhode"];
    let arguments = [&[verb, "--release", "--target", target], &program[..]].concat();
    run(cargo(&arguments).env(FLAGS, flags(triple)))?;
    Ok(self::program(triple))
}

/// Returns the path of the program that [`make`] has built for a platform.
pub(crate) fn program(triple: &str) -> PathBuf {
    let name = if triple.contains("windows") { "polhode.exe" } else { "polhode" };
    build_folder().join(triple).join("release").join(name)
}

/// Returns the flags of the compiler with which nothing that is built has symbols, or paths of this
/// machine.
///
/// Cargo does not apply `strip = true` of a profile to a package that has its own `opt-level`.
pub(crate) fn flags(triple: &str) -> String {
    let mut flags: Vec<String> = std::env::var("RUSTFLAGS")
        .map(|flags| flags.split_whitespace().map(str::to_owned).collect())
        .unwrap_or_default();
    let home = std::env::var("CARGO_HOME").ok().map(PathBuf::from);
    let home = home.or_else(|| std::env::home_dir().map(|home| home.join(".cargo")));
    for (from, to) in [(home, "cargo"), (Some(root()), "polhode")] {
        flags.extend(from.map(|from| format!("--remap-path-prefix={}={to}", from.display())));
    }
    flags.push("-Cstrip=symbols".to_owned());
    if triple.ends_with("-msvc") {
        // The dynamic runtime is missing on some Windows systems.
        flags.push("-Ctarget-feature=+crt-static".to_owned());
    }
    flags.join("\x1f")
}

/// Returns the build folder of cargo.
fn build_folder() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), |folder| root().join(folder))
}

/// Returns the compiler's host platform.
pub(crate) fn host() -> Result<String, String> {
    let said = output(Command::new("rustc").arg("-vV"))?;
    let host = said.lines().find_map(|line| line.strip_prefix("host: "));
    host.map(str::to_owned).ok_or_else(|| "rustc does not say what its host is".to_owned())
}

/// Returns the time for all files, s after 1970: `SOURCE_DATE_EPOCH`, or that of the last commit.
fn seconds() -> Result<u64, String> {
    let said = match std::env::var("SOURCE_DATE_EPOCH") {
        Ok(said) => said,
        Err(_) => output(Command::new("git").args(["log", "-1", "--format=%ct"]).current_dir(root()))?,
    };
    said.trim()
        .parse()
        .map_err(|_| format!("SOURCE_DATE_EPOCH is a number of seconds, not {:?}", said.trim()))
}

fn ask(program: &Path, arguments: &[&str]) -> Result<String, String> {
    output(Command::new(program).args(arguments))
}

fn text(path: &str, text: String) -> Packed {
    Packed { path: path.to_owned(), is_program: false, bytes: text.into_bytes() }
}

/// Returns a file of the source tree, packed at the same path.
fn stored(path: &str) -> Result<Packed, String> {
    let bytes = std::fs::read(root().join(path)).map_err(|error| format!("{path}: {error}"))?;
    Ok(Packed { path: path.to_owned(), is_program: false, bytes })
}

/// Returns the SHA256SUMS of all archives in a folder.
fn sums(folder: &Path) -> Result<String, String> {
    let mut lines = Vec::new();
    for extension in ["gz", "zip"] {
        for path in crate::files(folder, extension)? {
            let bytes = std::fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
            lines.push(sha256_line(&path.file_name().unwrap_or_default().to_string_lossy(), &bytes));
        }
    }
    Ok(lines.concat())
}

fn write(folder: &Path, name: &str, bytes: &[u8]) -> Outcome {
    let path = folder.join(name);
    let written = std::fs::create_dir_all(folder).and_then(|()| std::fs::write(&path, bytes));
    written.map_err(|error| format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::subcommands;

    #[test]
    fn the_pages_are_those_that_the_first_one_names() {
        let page =
            ".SH SUBCOMMANDS\n.TP\npolhode\\-spin(1)\nFree motion\n.TP\npolhode\\-see\\-also(1)\nmore\n";
        assert_eq!(subcommands(page), ["spin", "see-also"]);
    }
}
