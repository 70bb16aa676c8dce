//! Checks of the Python package: build the wheel, install it as a user would, and test it.
//!
//! This requires Python and its package index, unlike a build of the command.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::process::{FEATURES, empty_folder, joined, output, polhode, run, run_beside};
use crate::{Outcome, files, read, root, viewer};

/// Oldest Python version for the tests; the package itself also supports 3.10.
const PYTHON: (u32, u32) = (3, 11);

/// Path of Python inside a virtual environment.
pub(crate) const EXECUTABLE: &str = if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" };

/// Packages required by the tests.
///
/// These are optional dependencies of polhode, Dask for clusters, and pandoc for worked solutions.
/// Others run notebooks, show them in a browser, or check workflows.
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

/// Packages required by the tests with Ray.
const NEEDED_WITH_RAY: [&str; 5] = ["pytest", "pyarrow", "pandas", "distributed", "ray[data,client]==2.60.0"];

/// Number of members of the sweep whose workers are killed; the run lasts for several kills.
const MEMBERS_WITH_RAY: &str = "20000";

/// Runs all checks in a new environment.
pub(crate) fn check() -> Outcome {
    let environment = environment()?;
    let wheel = install_wheel(&environment)?;
    check_in(environment, &wheel)
}

/// Runs the tests with Ray, and sweeps on Dask and Ray while workers are killed at random; Linux
/// only.
pub(crate) fn check_with_ray() -> Outcome {
    let environment = environment_of("ray", &NEEDED_WITH_RAY)?;
    install_wheel(&environment)?;
    let Environment { folder, python } = environment;
    let package = root().join("crates/polhode-py");
    let empty = folder.join("empty");
    std::fs::create_dir(&empty).map_err(|error| format!("{}: {error}", empty.display()))?;
    let here = |arguments: &[&str]| {
        let mut command = Command::new(&python);
        // By default Ray uses a third of the memory for its object store.
        command
            .args(arguments)
            .current_dir(&empty)
            .env("RAY_DEFAULT_OBJECT_STORE_MAX_MEMORY_BYTES", "500000000")
            // With a token in the home directory, Ray would require it, and clients would not find
            // it.
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
    // The wheel uses the libraries compiled for the tests, because a release build would compile
    // them again.
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

/// Runs the tests and [what is documented](check_documented) in an empty folder, to import the
/// installed wheel.
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
    // The other checks run in parallel with pytest, because both often wait for other programs.
    std::thread::scope(|scope| {
        let beside = scope.spawn(|| check_documented(&here, &python, Path::new(where_from.trim())));
        // Ray is large, so its tests are run by `cargo xtask test --ray` only.
        let tests = package.join("tests");
        let ray = format!("--ignore={}", tests.join("test_ray.py").display());
        // Two processes, because tests often wait for other programs.
        let mut tested = here(&["-m", "pytest", "-q", "-n", "2", "--dist", "loadfile", &ray, "-c"]);
        // JupyterLab is tested in the same browser as the page.
        let tested = tested.args([&settings, &tests]).env("POLHODE", polhode()?);
        let tested = run_beside(tested.env("CHROMIUM", viewer::chromium()?));
        tested.and(joined(beside))
    })
}

/// Checks the examples in the documentation, the book and `examples/python/`, the notebooks, and
/// the types.
///
/// `installed` is the `__init__.py` of the installed package.
fn check_documented(here: &dyn Fn(&[&str]) -> Command, python: &Path, installed: &Path) -> Outcome {
    let package = root().join("crates/polhode-py");
    let settings = package.join("pyproject.toml");
    // Modules that need Ray or PyTorch cannot be imported here. The examples of the latter run in
    // their own tests.
    let without =
        ["_ray.py", "torch.py"].map(|name| format!("--ignore={}", installed.with_file_name(name).display()));
    let documented = ["--doctest-modules", &without[0], &without[1], "--pyargs", "polhode"];
    run_beside(here(&["-m", "pytest", "-q", "-c"]).arg(&settings).args(documented))?;
    // Checks that the tables on these pages belong to the current programs.
    run(here(&[]).arg(root().join("benches/python/measure.py")).arg("--check"))?;
    run(here(&[]).arg(root().join("benches/clusters/measure.py")).arg("--check"))?;
    let book = root().join("book");
    let pages = [
        "python.md",
        "python-scenarios.md",
        "python-data.md",
        "python-ensembles.md",
        "python-notebooks.md",
        "differentiable.md",
        "clusters.md",
    ];
    let pages = pages.map(|page| book.join(page));
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

/// Virtual environment for tests: its folder, and its Python.
#[derive(Debug)]
pub(crate) struct Environment {
    folder: PathBuf,
    python: PathBuf,
}

impl Environment {
    /// Returns the path of a program installed in the environment.
    pub(crate) fn program(&self, name: &str) -> PathBuf {
        self.python.with_file_name(format!("{name}{}", std::env::consts::EXE_SUFFIX))
    }

    /// Returns the path of the pandoc installed in the environment.
    pub(crate) fn pandoc(&self) -> Result<PathBuf, String> {
        let ask = "import pypandoc; print(pypandoc.get_pandoc_path())";
        output(Command::new(&self.python).args(["-c", ask])).map(|path| PathBuf::from(path.trim()))
    }
}

/// Creates the environment for the tests of the package.
pub(crate) fn environment() -> Result<Environment, String> {
    environment_of("python", &NEEDED)
}

/// Creates an environment with these packages.
fn environment_of(name: &str, packages: &[&str]) -> Result<Environment, String> {
    let folder = empty_folder(name)?;
    let python = make(&folder.join("venv"))?;
    // Modules are compiled on import instead of during installation.
    run(Command::new(&python).args(["-m", "pip", "install", "--quiet", "--no-compile"]).args(packages))?;
    Ok(Environment { folder, python })
}

/// Creates a virtual environment and returns its Python.
pub(crate) fn make(environment: &Path) -> Result<PathBuf, String> {
    let hint = "Python 3.11 or later with venv is needed, https://python.org";
    let system = if cfg!(windows) { "python" } else { "python3" };
    let version = output(Command::new(system).arg("--version")).map_err(|why| format!("{why}\n{hint}"))?;
    if version_of(&version).is_none_or(|version| version < PYTHON) {
        return Err(format!("{}: {hint}", version.trim()));
    }
    let make = || output(Command::new(system).args(["-m", "venv"]).arg(environment));
    // On Debian, venv is a separate package.
    make().or_else(|_| install_venv().and_then(|()| make())).map_err(|why| format!("{why}\n{hint}"))?;
    Ok(environment.join(EXECUTABLE))
}

/// Returns build arguments that optimise the same packages in the `dev` profile as in the tests.
///
/// The manifest lists them in `[profile.test.package.…]`.
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

/// Parses `Python 3.11.7` to (3, 11).
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
