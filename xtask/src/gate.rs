//! Gate: all checks that must pass before a change is merged.

use std::sync::atomic::Ordering;
use std::time::Instant;

use crate::process::{self, FEATURES, cargo, joined};
use crate::{
    Outcome, api, arrows, book, circles, dependencies, dist, examples, files, installation, layers, module,
    npm, packages, page, prose, python, readme, root, solutions, viewer, vscode, workflows,
};

/// Name and task of a step.
type Step = (&'static str, fn() -> Outcome);

/// The steps up to what everything else is run with, cheapest first.
const FIRST: [Step; 7] = [
    ("format", || process::run(&mut cargo(&["fmt", "--all", "--check"]))),
    ("layers", || layers::check().and_then(|()| arrows::check()).and_then(|()| circles::check())),
    ("prose", prose::check),
    ("licences", dependencies::check),
    ("packages", packages::check),
    ("lints", || {
        let all = ["clippy", "--workspace", "--all-targets", "--locked", "--features", FEATURES];
        process::run(cargo(&all).args(["--", "-D", "warnings"]))
    }),
    ("tests", tests),
];

/// Later steps, in parallel with those of the Python package.
const THEN: [Step; 4] = [
    ("public names", || api::check_in(&book::documentation()?)),
    ("examples", examples::check),
    ("README", readme::check),
    ("archive of a release", dist::check),
];

/// Runs all steps, up to the first failure.
///
/// Steps that mostly wait for other programs run in parallel with the others: those of the viewer
/// and of Python.
pub(crate) fn run() -> Outcome {
    let start = Instant::now();
    std::thread::scope(|scope| {
        let viewer = scope.spawn(|| run_step(&("viewer", viewer::check)));
        let environment = scope.spawn(python::environment);
        FIRST.iter().try_for_each(run_step)?;
        let environment = joined(environment)?;
        let book = scope.spawn(book::environment);
        let pandoc = environment.pandoc()?;
        timed("workflows", || workflows::check(&environment))?;
        joined(viewer)?;
        let page = scope.spawn(|| {
            timed("interactive page", page::check)?;
            timed("npm package", npm::check)?;
            timed("VS Code extension", vscode::check)
        });
        // The wheel is built before other steps call cargo, which runs one build at a time.
        let wheel = timed("wheel", || python::install_wheel(&environment))?;
        let python = scope.spawn(move || timed("Python", || python::check_in(environment, &wheel)));
        THEN.iter().try_for_each(run_step)?;
        timed("book", || book::build_in(&joined(book)?))?;
        timed("worked solutions", || solutions::check(&pandoc))?;
        joined(page)?;
        joined(python)
    })?;
    println!("\nall passed in {:.0} s", start.elapsed().as_secs_f64());
    Ok(())
}

/// Runs all steps with all random draws, then the tests that are too long for the gate.
///
/// The time of a first build comes first, while nothing else runs.
///
/// These are lists of 100,000 rows, and random mutations of each target's stored inputs.
pub(crate) fn run_nightly() -> Outcome {
    process::NIGHTLY.store(true, Ordering::Relaxed);
    timed("first build", installation::measure_build)?;
    run()?;
    page::build(module::Build::Release)?;
    viewer::check_page(&page::path(), &viewer::tested()?)?;
    viewer::check_bits()?;
    npm::release()?;
    vscode::release()?;
    let programs = files(&root().join("fuzz/fuzz_targets"), "rs")?;
    let targets: Vec<_> = programs.iter().filter_map(|path| path.file_stem()?.to_str()).collect();
    let all = ["test", "--workspace", "--locked", "--features", FEATURES, "--test", "*", "--", "--ignored"];
    process::run(cargo(&all).env("POLHODE_FUZZ", targets.join(" ")))
}

/// Runs the test programs in two parallel groups, because each program ends with a single long
/// test.
///
/// It then builds the documentation, whose dependencies have been checked by the lints.
fn tests() -> Outcome {
    let of =
        |what: &[&str]| cargo(&[&["test", "--workspace", "--locked", "--features", FEATURES], what].concat());
    process::run(&mut of(&["--no-run"]))?;
    std::thread::scope(|scope| {
        let units = scope.spawn(|| {
            process::run_beside(&mut of(&["--lib", "--bins"]))
                .and_then(|()| process::run_beside(&mut of(&["--doc"])))
                .and_then(|()| book::document_crates())
        });
        let tested = process::run(&mut of(&["--test", "*"]));
        joined(units).and(tested)
    })
}

fn run_step((name, step): &Step) -> Outcome {
    timed(name, step)
}

fn timed<T>(name: &str, step: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    println!("\n== {name}");
    let begun = Instant::now();
    let found = step().map_err(|why| format!("{name}: {why}"))?;
    println!("   {name} passed in {:.1} s", begun.elapsed().as_secs_f64());
    Ok(found)
}
