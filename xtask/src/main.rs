//! Tasks of this workspace; `cargo xtask test` runs all checks before a change is merged.

mod api;
mod archive;
mod arrows;
mod book;
mod circles;
mod corpus;
mod dependencies;
mod dist;
mod engines;
mod examples;
mod gate;
mod installation;
mod layers;
mod licence;
mod module;
mod notices;
mod npm;
mod packages;
mod page;
mod process;
mod prose;
mod python;
mod readme;
mod release;
mod sbom;
mod solutions;
mod speed;
mod viewer;
mod vscode;
mod workflows;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Result of a task; an error is a message.
type Outcome = Result<(), String>;

const USAGE: &str = "\
usage: cargo xtask TASK

  test       everything, in order, up to the first failure; --nightly with all random draws and with the long tests; --ray is a gate of its
             own: sweeps on Ray and Dask whose workers are killed, Linux alone
  layers     the modules' order: which may import which, what each may do, how long files are, and that no files or folders use each other in a circle
  prose      wording of comments, messages and book, counted; --list PATTERN, --write takes lower counts over
  licences   how many crates are linked, and under which licences
  examples   the built command on every scenario in examples/
  readme     the README's commands, and the instructions for installation on all pages; --write writes these
  packages   every crate as a package, with licences and nothing from outside
  api        the public names of the core crate, compared with crates/polhode/api.txt; --write takes them over
  book       the book as a site in target/book, its links checked; --open shows it
  speed      measures anew what book/speed.md, work-precision.md, ensembles.md, mass-properties.md, peers.md, clusters-dask.md and clusters-ray.md say; needs python3 and what it compares with
  corpus     what the check finds in FOLDER…, work trees of public models, on book/corpus.md; needs git
  engines    what engines make of the suite, FOLDER… of their runs, on book/judge-engines.md
  viewer     the page's viewer: its bundle is the build of its source, and its tests pass in a browser
  page       polhode.html, the interactive page with the engine in WebAssembly, into target/page/, for a release: its size is checked, its tests pass in a
             browser, its motions have the bits of a native build, and the command takes it over; after `npm ci` in viewer/
  npm        the npm package in target/npm/, for a release: its size is checked, and its tests pass in Node and in a browser; after `npm ci` in viewer/
  vscode     the extension of VS Code, packed, and its tests in an extension host; after `cargo xtask npm`
  python     the Python package: its wheel is built, and its tests and examples pass from there
  workflows  the workflows and the action of GitHub, and the job for GitLab, as their schemas and zizmor read them
  dist       the program for one platform, packed with man pages, completions and examples, into target/dist/; --target for another than
             this machine's own, --check tries the packing without building the program
  release    all that is uploaded for a release, in target/upload/, from a clean work tree on Linux or macOS: archive, wheel and sdist, npm package, page, site,
             crates, list of packages, checksums; --check uses each of them where nothing of this project is installed; after `npm ci` in viewer/
  solutions  the worked solutions of examples/, read by pandoc and MathJax; after `npm ci` in viewer/";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let outcome = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["test"] => gate::run(),
        ["test", "--nightly"] => gate::run_nightly(),
        ["test", "--ray"] => python::check_with_ray(),
        ["layers"] => layers::check().and_then(|()| arrows::check()).and_then(|()| circles::check()),
        ["prose"] => prose::check(),
        ["prose", "--list", pattern] => prose::list(pattern),
        ["prose", "--write"] => prose::write(),
        ["licences"] => dependencies::check(),
        ["examples"] => examples::check(),
        ["readme"] => readme::check(),
        ["readme", "--write"] => installation::write(),
        ["packages"] => packages::check(),
        ["api"] => api::check(),
        ["api", "--write"] => api::write(),
        ["book"] => book::build(false),
        ["book", "--open"] => book::build(true),
        ["speed"] => speed::measure(),
        ["corpus", ref folders @ ..] if !folders.is_empty() => corpus::audit(folders),
        ["engines", ref folders @ ..] if !folders.is_empty() => engines::grade(folders),
        ["viewer"] => viewer::check().and_then(|()| page::check()).and_then(|()| npm::check()),
        ["page"] => page::release(),
        ["npm"] => npm::release(),
        ["vscode"] => vscode::release(),
        ["python"] => python::check(),
        ["dist"] => dist::make(None),
        ["dist", "--target", target] => dist::make(Some(target)),
        ["dist", "--check"] => dist::check(),
        ["release"] => release::make(),
        ["release", "--check"] => release::check(),
        ["solutions"] => python::environment().and_then(|python| solutions::check(&python.pandoc()?)),
        ["workflows"] => python::environment().and_then(|python| workflows::check(&python)),
        ["help" | "--help" | "-h"] => {
            println!("{USAGE}");
            Ok(())
        }
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("xtask: FAILED: {why}");
            ExitCode::FAILURE
        }
    }
}

/// Returns the root of the workspace, as given by cargo at run time, because build folders can be
/// shared.
fn root() -> PathBuf {
    let xtask = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    Path::new(&xtask).parent().unwrap_or(Path::new(".")).to_owned()
}

/// Returns all files below `directory` with the extension `extension`, in order.
fn files(directory: &Path, extension: &str) -> Result<Vec<PathBuf>, String> {
    let unreadable = |error| format!("{}: {error}", short(directory));
    let mut found = Vec::new();
    for entry in std::fs::read_dir(directory).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        if path.is_dir() {
            found.extend(files(&path, extension)?);
        } else if path.extension().is_some_and(|e| e == extension) {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

/// Returns the text of a file.
fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", short(path)))
}

/// Returns a path for messages: relative to the root, with slashes.
fn short(path: &Path) -> String {
    path.strip_prefix(root()).unwrap_or(path).display().to_string().replace('\\', "/")
}
