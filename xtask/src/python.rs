//! Checks of the Python package: its wheel is built and installed as a user would, and tested from
//! there.
//!
//! This needs Python and its package index; building the command does not.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::process::{FEATURES, empty_folder, joined, output, polhode, run, run_beside};
use crate::{Outcome, files, read, root, viewer};

/// Version of the oldest Python that the tests run with; the package is for 3.10 too.
const PYTHON: (u32, u32) = (3, 11);

/// Path of the Python in a virtual environment.
pub(crate) const EXECUTABLE: &str = if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" };

/// Packages that the tests need besides the package.
///
/// They are optional dependencies of the package, Dask for the cluster, and pandoc for worked
/// solutions. Others run notebooks and show them in a browser, or read the workflows.
const NEEDED: [&str; 23] = [
    "pytest",
    "pytest-xdist",
    "scipy",
    "matplotlib",
    "mypy",
    "pyright==1.1.414",
    "pyarrow",
    "pandas",
    "polars",
    "xarray",
    "trimesh",
    "jax",
    "pint",
    "astropy",
    "distributed",
    "pypandoc_binary",
    "nbclient",
    "ipykernel",
    "anywidget",
    "jupyterlab",
    "playwright",
    "check-jsonschema==0.39.0",
    "zizmor==1.32.0",
];

/// Packages that the tests on Ray need besides the package.
const NEEDED_WITH_RAY: [&str; 5] = ["pytest", "pyarrow", "pandas", "distributed", "ray[data,client]==2.60.0"];

/// Number of members of the sweep whose workers are killed there: enough for several kills.
const MEMBERS_WITH_RAY: &str = "20000";

/// Makes an environment of its own, and runs all checks in it.
pub(crate) fn check() -> Outcome {
    let environment = environment()?;
    let wheel = install_wheel(&environment)?;
    check_in(environment, &wheel)
}

/// Runs the tests on Ray, and a sweep on Dask and on Ray whose workers are killed at random.
///
/// They use the wheel in an environment of its own, on Linux alone.
pub(crate) fn check_with_ray() -> Outcome {
    let environment = environment_of("ray", &NEEDED_WITH_RAY)?;
    install_wheel(&environment)?;
    let Environment { folder, python } = environment;
    let package = root().join("crates/polhode-py");
    let empty = folder.join("empty");
    std::fs::create_dir(&empty).map_err(|error| format!("{}: {error}", empty.display()))?;
    let here = |arguments: &[&str]| {
        let mut command = Command::new(&python);
        // Ray would take a third of the machine's memory for what its processes share.
        command
            .args(arguments)
            .current_dir(&empty)
            .env("RAY_DEFAULT_OBJECT_STORE_MAX_MEMORY_BYTES", "500000000")
            // A head would otherwise want a token if one is in the home directory. Its clients know
            // the token only after a cluster of their own.
            .env("RAY_AUTH_MODE", "disabled");
        command
    };
    run(here(&["-m", "pytest", "-v", "-c"])
        .arg(package.join("pyproject.toml"))
        .arg(package.join("tests/test_ray.py")))?;
    run(here(&[]).arg(root().join("benches/clusters/measure.py")).args([
        "--try",
        MEMBERS_WITH_RAY,
        "dask",
        "ray",
    ]))
}

/// Builds the wheel and installs it into an environment.
pub(crate) fn install_wheel(Environment { folder, python }: &Environment) -> Result<PathBuf, String> {
    let package = root().join("crates/polhode-py");
    let wheels = folder.join("wheels");
    // The wheel is compiled as the tests are, from the same libraries. A release build would
    // compile all of them once more.
    let mut wheel = Command::new(python);
    wheel.args(["-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir"]).args([&wheels, &package]);
    let optimised = optimised(&read(&root().join("Cargo.toml"))?);
    run(
        wheel.env("MATURIN_PEP517_ARGS", format!("--profile dev --features {FEATURES},as-tested{optimised}"))
    )?;
    let wheel = files(&wheels, "whl")?.pop().ok_or("pip made no wheel")?;
    run(Command::new(python).arg(package.join("wheel.py")).arg(&wheel))?;
    run(Command::new(python).args(["-m", "pip", "install", "--quiet"]).arg(&wheel))?;
    Ok(wheel)
}

/// Runs the tests and [what is documented](check_documented) from an empty folder.
///
/// An import there takes the wheel's modules, not the tree's.
pub(crate) fn check_in(environment: Environment, wheel: &Path) -> Outcome {
    let Environment { folder, python } = environment;
    let package = root().join("crates/polhode-py");
    let empty = folder.join("empty");
    std::fs::create_dir(&empty).map_err(|error| format!("{}: {error}", empty.display()))?;
    let here = |arguments: &[&str]| {
        let mut command = Command::new(&python);
        command.args(arguments).current_dir(&empty).env("MPLBACKEND", "Agg");
        command
    };
    let settings = package.join("pyproject.toml");
    let where_from = output(&mut here(&["-c", "import polhode; print(polhode.__file__)"]))?;
    if !Path::new(where_from.trim()).starts_with(&folder) {
        return Err(format!("{} is imported, not the wheel", where_from.trim()));
    }
    println!("   {}", wheel.file_name().unwrap_or_default().to_string_lossy());
    // The checks outside pytest run in parallel with it: each waits for other programs much of its
    // time.
    std::thread::scope(|scope| {
        let beside = scope.spawn(|| check_documented(&here, &python, Path::new(where_from.trim())));
        // Ray is large: its tests are `cargo xtask test --ray`.
        let tests = package.join("tests");
        let ray = format!("--ignore={}", tests.join("test_ray.py").display());
        // Each waits for programs of its own much of the time.
        let mut tested = here(&["-m", "pytest", "-q", "-n", "2", "--dist", "loadfile", &ray, "-c"]);
        // JupyterLab is looked at in the browser of the page's tests.
        let tested = tested.args([&settings, &tests]).env("POLHODE", polhode()?);
        let tested = run_beside(tested.env("CHROMIUM", viewer::chromium()?));
        tested.and(joined(beside))
    })
}

/// Checks the examples of the documentation, the book and `examples/python/`, the notebooks, and
/// the types.
///
/// `installed` is the package's `__init__.py`.
fn check_documented(here: &dyn Fn(&[&str]) -> Command, python: &Path, installed: &Path) -> Outcome {
    let package = root().join("crates/polhode-py");
    let settings = package.join("pyproject.toml");
    // The modules that need Ray and PyTorch cannot be imported here: the tests of the latter run
    // its examples.
    let without =
        ["_ray.py", "torch.py"].map(|name| format!("--ignore={}", installed.with_file_name(name).display()));
    let documented = ["--doctest-modules", &without[0], &without[1], "--pyargs", "polhode"];
    run_beside(here(&["-m", "pytest", "-q", "-c"]).arg(&settings).args(documented))?;
    // The tables of these pages are measured results of the programs as they are.
    run(here(&[]).arg(root().join("benches/python/measure.py")).arg("--check"))?;
    run(here(&[]).arg(root().join("benches/clusters/measure.py")).arg("--check"))?;
    let book = root().join("book");
    let pages = ["python.md", "differentiable.md", "clusters.md"].map(|page| book.join(page));
    let followed = [files(&book.join("cookbook"), "md")?, files(&book.join("tutorials"), "md")?];
    let pages = pages.into_iter().chain(followed.concat());
    run_beside(here(&["-m", "pytest", "-q", "--doctest-glob=*.md", "-c"]).arg(&settings).args(pages))?;
    run_beside(here(&["-m", "mypy", "--config-file"]).arg(&settings).args([
        "-p",
        "polhode",
        "-p",
        "polhode_command",
    ]))?;
    run_beside(here(&["-m", "pyright", "--pythonpath"]).arg(python).arg("--project").arg(&package))?;
    run_beside(
        here(&["-W", "error::UserWarning"]).arg(book.join("notebooks/execute.py")).env_remove("MPLBACKEND"),
    )?;
    for example in files(&root().join("examples/python"), "py")? {
        println!("   {}", crate::short(&example));
        output(here(&["-W", "error"]).arg(&example))?;
    }
    Ok(())
}

/// Folder, and the Python of an environment in it that has what the tests need.
#[derive(Debug)]
pub(crate) struct Environment {
    folder: PathBuf,
    python: PathBuf,
}

impl Environment {
    /// Returns a program that one of its packages has.
    pub(crate) fn program(&self, name: &str) -> PathBuf {
        self.python.with_file_name(format!("{name}{}", std::env::consts::EXE_SUFFIX))
    }

    /// Returns the pandoc that one of its packages has.
    pub(crate) fn pandoc(&self) -> Result<PathBuf, String> {
        let ask = "import pypandoc; print(pypandoc.get_pandoc_path())";
        output(Command::new(&self.python).args(["-c", ask])).map(|path| PathBuf::from(path.trim()))
    }
}

/// Makes the environment of the package's tests.
pub(crate) fn environment() -> Result<Environment, String> {
    environment_of("python", &NEEDED)
}

/// Makes an environment with packages.
fn environment_of(name: &str, packages: &[&str]) -> Result<Environment, String> {
    let folder = empty_folder(name)?;
    let python = make(&folder.join("venv"))?;
    // Modules are compiled when they are imported, and no others.
    run(Command::new(&python).args(["-m", "pip", "install", "--quiet", "--no-compile"]).args(packages))?;
    Ok(Environment { folder, python })
}

/// Makes a virtual environment, and returns its Python.
pub(crate) fn make(environment: &Path) -> Result<PathBuf, String> {
    let hint = "Python 3.11 or later with venv is needed, https://python.org";
    let system = if cfg!(windows) { "python" } else { "python3" };
    let version = output(Command::new(system).arg("--version")).map_err(|why| format!("{why}\n{hint}"))?;
    if version_of(&version).is_none_or(|version| version < PYTHON) {
        return Err(format!("{}: {hint}", version.trim()));
    }
    let make = || output(Command::new(system).args(["-m", "venv"]).arg(environment));
    // Debian's Python has no venv until its package is installed.
    make().or_else(|_| install_venv().and_then(|()| make())).map_err(|why| format!("{why}\n{hint}"))?;
    Ok(environment.join(EXECUTABLE))
}

/// Returns the packages that the tests optimise, as arguments of a build for development.
///
/// They are those in `[profile.test.package.…]` of the workspace's manifest.
fn optimised(manifest: &str) -> String {
    let packages = manifest.split("[profile.test.package.").skip(1);
    let package = |section: &str| {
        let (name, rest) = section.split_once(']')?;
        let level = rest.trim_start().strip_prefix("opt-level = ")?.split_whitespace().next()?;
        Some(format!(" --config profile.dev.package.{name}.opt-level={level}"))
    };
    packages.filter_map(package).collect()
}

fn install_venv() -> Outcome {
    println!("   no venv: installing it");
    let apt = |arguments: &[&str]| {
        run(Command::new("apt-get").args(arguments).env("DEBIAN_FRONTEND", "noninteractive"))
    };
    apt(&["update", "-qq"])?;
    apt(&["install", "-qq", "-y", "--no-install-recommends", "python3-venv"])
}

/// Returns (3, 11) for `Python 3.11.7`.
fn version_of(said: &str) -> Option<(u32, u32)> {
    let mut numbers = said.trim().strip_prefix("Python ")?.split('.').map(str::parse);
    Some((numbers.next()?.ok()?, numbers.next()?.ok()?))
}

#[cfg(test)]
mod tests {
    use super::{optimised, version_of};

    #[test]
    fn what_tests_optimise_is_read() {
        let manifest = "[profile.dev]\ndebug = false\n\n[profile.test.package.one]\nopt-level = 1 # why\n\n[profile.test.package.two-three]\nopt-level = 2\n";
        let both = " --config profile.dev.package.one.opt-level=1 --config profile.dev.package.two-three.opt-level=2";
        assert_eq!(optimised(manifest), both);
    }

    #[test]
    fn the_version_of_python_is_read() {
        assert_eq!(version_of("Python 3.11.7\n"), Some((3, 11)));
        assert_eq!(version_of("Python 3.9.2"), Some((3, 9)));
        assert_eq!(version_of("Python 4.0.0rc1"), Some((4, 0)));
        assert_eq!(version_of("python: not found"), None);
    }
}
