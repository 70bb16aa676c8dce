//! Instructions for installation, in one of two states: before the first release, and after it.
//!
//! `xtask/installation.md` has the texts of both. Pages contain them in blocks
//! `<!-- begin: installation NAME -->` … `<!-- end: installation -->`, and [`PHRASES`] elsewhere.
//! `cargo xtask readme` checks both, `cargo xtask readme --write` writes them.

use std::path::Path;
use std::process::Command;
use std::time::Instant;

use crate::process::{cargo, empty_folder, output, run};
use crate::{Outcome, read, root};

/// Version in the package registries; `None` before the first release.
pub(crate) const RELEASED: Option<&str> = None;

/// Shortest and longest measured time of the first build of the command on two cores, minutes.
const BUILD_MINUTES: (u32, u32) = (4, 9);

/// Address of the repository, from `Cargo.toml`.
const REPOSITORY: &str = env!("CARGO_PKG_REPOSITORY");

/// Texts of all blocks, each after `<!-- NAME, unreleased -->` or `<!-- NAME, released -->`.
const TEXTS: &str = include_str!("../installation.md");

/// Phrases for a clone, and the phrases that replace them on pages for users after a release.
const PHRASES: [(&str, &str); 5] = [
    ("pip install ./crates/polhode-py", "pip install polhode"),
    ("pip install './crates/polhode-py[", "pip install 'polhode["),
    ("cargo install --locked --path crates/polhode-cli", "cargo install --locked polhode-cli"),
    ("cargo install --locked --git {repository} polhode-cli", "cargo install --locked polhode-cli"),
    ("polhode = { git = \"{repository}\" }", "polhode = \"{version}\""),
];

/// More phrases that are false before the first release.
const REGISTRIES: [&str; 10] = [
    "cargo install polhode",
    "cargo add polhode",
    "npm install polhode",
    "npm i polhode",
    "pipx install polhode",
    "uvx polhode",
    "crates.io/crates/polhode",
    "docs.rs/polhode",
    "pypi.org/project/polhode",
    "npmjs.com/package/polhode",
];

/// Phrases that are wrong in both states, outside blocks: only blocks state the time of a build.
const NEVER: [&str; 2] = ["OWNER/polhode", "first build takes"];

const BEGIN: &str = "<!-- begin: installation ";
const END: &str = "<!-- end: installation -->";

/// Compares all tracked texts with the state.
pub(crate) fn check() -> Outcome {
    let mut wrong = Vec::new();
    let package = "crates/polhode-py/pyproject.toml";
    if !read(&root().join(package))?.contains(&format!("\nRepository = \"{REPOSITORY}\"\n")) {
        wrong.push(format!("{package}: Repository is not {REPOSITORY} of Cargo.toml"));
    }
    for path in tracked()? {
        let page = read(&root().join(&path))?;
        if written(&path, &page, RELEASED)? != page {
            wrong.push(format!("{path}: `cargo xtask readme --write` writes other instructions"));
        }
        let outside = outside(&page);
        let found = forbidden(RELEASED).into_iter().filter(|phrase| outside.contains(phrase));
        wrong.extend(found.map(|phrase| format!("{path}: `{phrase}` is wrong in this state")));
    }
    if wrong.is_empty() { Ok(()) } else { Err(format!("installation:\n{}", wrong.join("\n"))) }
}

/// Writes the instructions of the state into all pages.
pub(crate) fn write() -> Outcome {
    for path in tracked()? {
        let page = read(&root().join(&path))?;
        let new = written(&path, &page, RELEASED)?;
        if new != page {
            std::fs::write(root().join(&path), new).map_err(|error| format!("{path}: {error}"))?;
            println!("   {path}");
        }
    }
    Ok(())
}

/// Builds README's first command in an empty folder and compares the time with the stated time.
pub(crate) fn measure_build() -> Outcome {
    run(&mut cargo(&["fetch", "--locked"]))?;
    let folder = empty_folder("first build")?;
    let begun = Instant::now();
    run(cargo(&["build", "--release", "--locked"]).env("CARGO_TARGET_DIR", &folder))?;
    check_build_time(begun.elapsed().as_secs_f64())?;
    std::fs::remove_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))
}

/// Compares the time of a first build of the command on two cores, s, with the stated time.
pub(crate) fn check_build_time(seconds: f64) -> Outcome {
    let (least, most) = BUILD_MINUTES;
    let minutes = seconds / 60.0;
    println!("   first build: {minutes:.1} minutes; stated: {least} to {most}");
    if minutes >= f64::from(least) / 2.0 && minutes <= f64::from(most) * 2.0 {
        return Ok(());
    }
    Err(format!(
        "the first build took {minutes:.1} minutes, the instructions state {least} to {most}: \
         set BUILD_MINUTES in xtask/src/installation.rs, then `cargo xtask readme --write`"
    ))
}

/// Returns the tracked texts that may have instructions. A changelog states what was true.
fn tracked() -> Result<Vec<String>, String> {
    const KINDS: [&str; 12] =
        ["md", "rst", "rs", "py", "pyi", "toml", "yml", "yaml", "ts", "mjs", "ipynb", "json"];
    const EXEMPT: [&str; 3] = ["CHANGELOG.md", "xtask/installation.md", "xtask/src/installation.rs"];
    let listed = output(Command::new("git").args(["ls-files", "-z"]).current_dir(root()))?;
    let kind = |path: &str| Path::new(path).extension().is_some_and(|e| KINDS.iter().any(|kind| e == *kind));
    let texts = listed.split('\0').filter(|path| kind(path) && !EXEMPT.contains(path));
    Ok(texts.map(str::to_owned).collect())
}

/// Returns a text with the blocks and phrases of a state.
fn written(path: &str, page: &str, released: Option<&str>) -> Result<String, String> {
    let wrong = |why: String| format!("{path}: {why}");
    let mut parts = page.split(BEGIN);
    let mut new = phrased(path, parts.next().unwrap_or_default(), released);
    for part in parts {
        let (name, rest) = part.split_once(" -->\n").ok_or_else(|| wrong(format!("`{BEGIN}` has no end")))?;
        let (_, after) = rest.split_once(END).ok_or_else(|| wrong(format!("`{name}` without `{END}`")))?;
        let text = text(name, released).ok_or_else(|| wrong(format!("unknown text `{name}`")))?;
        new += &format!("{BEGIN}{name} -->\n{text}{END}{}", phrased(path, after, released));
    }
    Ok(new)
}

/// Returns text outside blocks with the phrases of the registries after a release.
fn phrased(path: &str, text: &str, released: Option<&str>) -> String {
    let is_page = path == "README.md"
        || path.starts_with("book/")
        || path.ends_with("/README.md") && (path.starts_with("crates/") || path.starts_with("npm/"));
    let pairs = PHRASES.iter().filter(|_| is_page && released.is_some());
    pairs.fold(text.to_owned(), |text, (clone, registry)| {
        text.replace(&filled(clone, released), &filled(registry, released))
    })
}

/// Returns a text without its blocks.
fn outside(page: &str) -> String {
    let mut parts = page.split(BEGIN);
    let first = parts.next().unwrap_or_default();
    let later = parts.filter_map(|part| part.split_once(END)).map(|(_, after)| after);
    std::iter::once(first).chain(later).collect()
}

/// Returns the phrases that no text may have outside blocks.
fn forbidden(released: Option<&str>) -> Vec<String> {
    let registries = PHRASES.iter().map(|(_, registry)| *registry).chain(REGISTRIES);
    let found = registries.filter(|_| released.is_none()).chain(NEVER);
    found.map(|phrase| filled(phrase, released)).collect()
}

/// Returns the text of a block.
fn text(name: &str, released: Option<&str>) -> Option<String> {
    let state = if released.is_some() { "released" } else { "unreleased" };
    let (_, rest) = TEXTS.split_once(&format!("<!-- {name}, {state} -->\n"))?;
    let text = rest.split("<!-- ").next()?.trim_end();
    Some(filled(text, released) + "\n")
}

/// Replaces the names in braces.
fn filled(text: &str, released: Option<&str>) -> String {
    let (least, most) = BUILD_MINUTES;
    text.replace("{version}", released.unwrap_or(env!("CARGO_PKG_VERSION")))
        .replace("{repository}", REPOSITORY)
        .replace("{owner/name}", REPOSITORY.trim_start_matches("https://github.com/"))
        .replace("{rust}", env!("CARGO_PKG_RUST_VERSION"))
        .replace("{minutes}", &format!("{least} to {most} minutes"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// States: none, and a release that is not the present version.
    const STATES: [Option<&str>; 2] = [None, Some("7.8.9")];

    #[test]
    fn both_states_have_every_text() {
        let names: Vec<&str> =
            TEXTS.split("<!-- ").skip(1).filter_map(|part| Some(part.split_once(',')?.0)).collect();
        assert!(names.contains(&"try") && names.contains(&"pre-commit"), "{names:?}");
        for (name, released) in names.iter().flat_map(|name| STATES.map(|state| (name, state))) {
            let text = text(name, released).unwrap();
            assert!(!text.contains('{') && !text.trim().is_empty(), "{text}");
            let registry = forbidden(None)
                .into_iter()
                .find(|phrase| text.contains(phrase) && !NEVER.contains(&phrase.as_str()));
            assert!(released.is_some() || registry.is_none(), "{name}: {registry:?}");
            assert!(released.is_none() || !text.contains("published yet"), "{text}");
        }
    }

    #[test]
    fn the_browser_comes_first_and_a_clone_is_written() {
        for released in STATES {
            let text = text("try", released).unwrap();
            let place = |phrase: &str| text.find(phrase).unwrap_or_else(|| panic!("{phrase}: {text}"));
            assert!(place("polhode.html") < place(&format!("git clone {REPOSITORY}")));
            assert_eq!(text.contains("pip install polhode"), released.is_some());
            for phrase in ["cargo run --release", "4 to 9 minutes on two cores"] {
                assert_eq!(text.contains(phrase), released.is_none(), "{text}");
            }
        }
    }

    #[test]
    fn a_page_is_written_for_each_state() {
        let page = format!("a\n{BEGIN}python -->\nold\n{END}\npip install './crates/polhode-py[jax]'\n");
        let [none, some] = STATES.map(|state| written("book/a.md", &page, state).unwrap());
        assert!(none.starts_with("a\n") && none.contains("git clone") && !none.contains("old"), "{none}");
        assert!(none.ends_with(&format!("{END}\npip install './crates/polhode-py[jax]'\n")), "{none}");
        assert!(some.contains("$ pip install polhode\n") && some.ends_with("pip install 'polhode[jax]'\n"));
        for (state, new) in STATES.into_iter().zip([none, some]) {
            assert_eq!(written("book/a.md", &new, state).unwrap(), new);
            let found = forbidden(state).into_iter().find(|phrase| outside(&new).contains(phrase));
            assert_eq!(found, None);
        }
        // Instructions for developers are always those of a clone.
        let phrase = "pip install ./crates/polhode-py\n";
        assert_eq!(written("benches/a.py", phrase, STATES[1]).unwrap(), phrase);
        assert!(written("a.md", &format!("{BEGIN}python -->\n"), None).is_err());
        assert!(written("a.md", &format!("{BEGIN}other -->\n{END}"), None).is_err());
    }

    #[test]
    fn the_stated_time_is_that_of_a_build() {
        for (seconds, is_right) in [(313.0, true), (527.0, true), (110.0, false), (1100.0, false)] {
            assert_eq!(check_build_time(seconds).is_ok(), is_right, "{seconds}");
        }
        assert!(check_build_time(f64::NAN).is_err());
    }
}
