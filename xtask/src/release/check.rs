//! Checks of a release: each artefact is used in an empty environment.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use super::{MOST, PLATFORM, folder, one};
use crate::process::{empty_folder, output, run};
use crate::{Outcome, book, dist, npm, python, read, root, viewer, vscode};

/// Version of auditwheel, as in the workflow of releases.
const AUDIT: &str = "auditwheel==6.8.2";

/// Programs of every system.
const SHELL: [&str; 10] = ["sh", "bash", "tar", "gzip", "env", "cat", "uname", "sed", "dirname", "readlink"];

/// Largest time of the first answer from an artefact, s.
const FIRST_ANSWER: f64 = 30.0;

/// Makes the release of the last commit, if that has not been done, and checks all of it.
pub(crate) fn check() -> Outcome {
    if !super::is_made()? {
        super::make()?;
    }
    let folder = folder()?;
    run(Command::new("sha256sum").args(["--quiet", "--check", "SHA256SUMS"]).current_dir(&folder))?;
    let archive = one(&folder, &format!("{}.tar.gz", dist::host()?))?;
    let size = std::fs::metadata(&archive).map_err(|error| format!("{}: {error}", archive.display()))?.len();
    println!("   {}: {:.1} MB", archive.display(), size as f64 / 1e6);
    if size > MOST {
        return Err(format!("the archive has {size} bytes, more than {MOST}"));
    }
    let page = read(&folder.join("START.md"))?;
    let answers = answers(&page);
    if answers.len() != 3 {
        return Err(format!("START.md has {} sections with commands and an answer, not 3", answers.len()));
    }
    let commands = answers.iter().map(|answer| first_answer(answer, &folder));
    let places = commands.collect::<Result<Vec<_>, _>>()?;
    wheel(&one(&folder, ".whl")?)?;
    run(Command::new("python3")
        .arg(root().join("integrations/try.py"))
        .arg(one(&folder, ".whl")?)
        .arg(&archive))?;
    sdist(&folder)?;
    let command = one(&places[0], "/polhode")?;
    npm::test(&one(&folder, ".tgz")?, &command)?;
    vscode::test(&command)?;
    viewer::check_page(&folder.join("polhode.html"), &command)?;
    book::check_site(&folder.join("site"))
}

/// A section of START.md: commands, and a part of what they print.
#[derive(Debug, PartialEq, Eq)]
struct Answer<'a> {
    title: &'a str,
    script: &'a str,
    printed: &'a str,
}

/// Returns the sections that have a block of commands, and the answer after it.
fn answers(page: &str) -> Vec<Answer<'_>> {
    let sections = page.split("\n## ").skip(1);
    let answer = |section| {
        let block = |language: &str| str::split_once(section, language)?.1.split("\n```").next();
        let (title, _) = str::split_once(section, '\n')?;
        Some(Answer { title, script: block("```sh\n")?, printed: block("```text\n")? })
    };
    sections.filter_map(answer).collect()
}

/// Runs the commands in a folder with the files of the release, and without the variables of this
/// environment. Returns the folder.
///
/// The path leads to [`SHELL`] and to what the title names, and to nothing of Rust.
fn first_answer(answer: &Answer<'_>, files: &Path) -> Result<PathBuf, String> {
    let place =
        empty_folder(&format!("first-answer-{}", answer.title.split(' ').next().unwrap_or_default()))?;
    for entry in std::fs::read_dir(files).map_err(|error| format!("{}: {error}", files.display()))? {
        let path = entry.map_err(|error| error.to_string())?.path();
        if let Some(name) = path.file_name().filter(|_| path.is_file()) {
            std::fs::copy(&path, place.join(name)).map_err(|error| format!("{}: {error}", path.display()))?;
        }
    }
    let home = place.join("home");
    std::fs::create_dir(&home).map_err(|error| format!("{}: {error}", home.display()))?;
    let path = programs(answer.title, &place)?;
    let begun = Instant::now();
    let mut script = Command::new("sh");
    script.args(["-euc", answer.script]).current_dir(&place).env_clear().env("PATH", path).env("HOME", home);
    // Mirrors and proxies of pip and npm.
    script.envs(std::env::vars().filter(|(name, _)| {
        let name = name.to_uppercase();
        name.starts_with("PIP_")
            || name.starts_with("NPM_CONFIG_")
            || name.ends_with("_PROXY")
            || name.contains("CERT")
    }));
    let printed = output(&mut script)?;
    let seconds = begun.elapsed().as_secs_f64();
    println!("   {}: first answer after {seconds:.1} s", answer.title);
    if !printed.contains(answer.printed) {
        return Err(format!("{}: {:?} is not in the answer\n{printed}", answer.title, answer.printed));
    }
    if seconds > FIRST_ANSWER {
        return Err(format!("{}: {seconds:.1} s, more than {FIRST_ANSWER} s", answer.title));
    }
    Ok(place)
}

/// Makes a folder of links to [`SHELL`] and to the programs that a section needs, and returns it.
fn programs(title: &str, place: &Path) -> Result<PathBuf, String> {
    let folder = place.join("bin");
    std::fs::create_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut found: Vec<(&str, String)> = Vec::new();
    let more: &[&str] = match title.split(' ').next() {
        Some("Python") => &["python3"],
        Some("Node") => &["node", "npm"],
        _ => &[],
    };
    for &program in SHELL.iter().chain(more) {
        let at = match program {
            // Not a script that chooses a version of Python.
            "python3" => output(Command::new(program).args(["-c", "import sys; print(sys.executable)"]))?,
            _ => output(Command::new("sh").args(["-c", &format!("command -v {program}")]))?,
        };
        found.push((program, at));
    }
    for (program, at) in found {
        link(Path::new(at.trim()), &folder.join(program))?;
    }
    Ok(folder)
}

#[cfg(unix)]
fn link(from: &Path, to: &Path) -> Outcome {
    std::os::unix::fs::symlink(from, to).map_err(|error| format!("{}: {error}", to.display()))
}

#[cfg(not(unix))]
fn link(from: &Path, to: &Path) -> Outcome {
    std::fs::copy(from, to).map(drop).map_err(|error| format!("{}: {error}", to.display()))
}

/// Checks the wheel's metadata, its tag of the platform, and the glibc that it needs.
fn wheel(wheel: &Path) -> Outcome {
    let script = root().join("crates/polhode-py/wheel.py");
    let python = python::make(&empty_folder("audit")?.join("venv"))?;
    if !wheel.to_string_lossy().contains("manylinux") {
        return run(Command::new(python).arg(script).arg(wheel));
    }
    let platform = format!("{PLATFORM}_{}", std::env::consts::ARCH);
    run(Command::new(&python).arg(script).arg(wheel).args(["--platform", &platform]))?;
    run(Command::new(&python).args(["-m", "pip", "install", "--quiet", AUDIT]))?;
    let said = output(Command::new(&python).args(["-m", "auditwheel", "show"]).arg(wheel))?;
    let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
    // What it needs is at most what its tag says.
    let tag = said.split("platform tag: \"").nth(1).and_then(|rest| rest.split('"').next());
    let needed = tag.and_then(|tag| tag.strip_prefix("manylinux_2_")?.split('_').next()?.parse::<u32>().ok());
    let most = PLATFORM.strip_prefix("manylinux_2_").and_then(|minor| minor.parse().ok());
    match (needed, most) {
        (Some(needed), Some(most)) if needed <= most => Ok(()),
        _ => Err(format!("the wheel is tagged {PLATFORM}, but auditwheel says: {said}")),
    }
}

/// Builds the sdist where Rust is, without optimization, and uses it; where Rust is not, it says so.
fn sdist(folder: &Path) -> Outcome {
    let source = one(folder, &format!("polhode-{}.tar.gz", super::VERSION))?;
    let place = empty_folder("sdist")?;
    let python = python::make(&place.join("venv"))?;
    let install =
        |command: &mut Command| output(command.args(["-m", "pip", "install", "--quiet"]).arg(&source));
    let path = programs("Python", &place)?;
    match install(Command::new(&python).env("PATH", path)) {
        Err(why) if why.contains("https://rustup.rs") => {}
        other => return Err(format!("without Rust, the sdist does not name https://rustup.rs: {other:?}")),
    }
    install(
        Command::new(&python)
            .env("MATURIN_PEP517_ARGS", "--profile dev")
            .env("CARGO_TARGET_DIR", place.join("target")),
    )?;
    let answer = output(Command::new(&python).args(["-c", "import polhode; print(polhode.__version__)"]))?;
    let built = output(Command::new(python.with_file_name("polhode")).arg("--version"))?;
    if built.trim() == format!("polhode {}", super::VERSION) && answer.trim() == super::VERSION {
        return Ok(());
    }
    Err(format!("the sdist has version {} and the command {}", answer.trim(), built.trim()))
}

#[cfg(test)]
mod tests {
    use super::{Answer, answers};

    #[test]
    fn a_section_with_commands_has_an_answer() {
        let page = "# T\n\n## A browser\n\nOpen it.\n\n## A shell\n\n```sh\ntar x\ncd y\n```\n\n```text\nFlips\n```\n";
        assert_eq!(answers(page), [Answer { title: "A shell", script: "tar x\ncd y", printed: "Flips" }]);
        assert_eq!(answers(super::super::START).len(), 3);
    }
}
