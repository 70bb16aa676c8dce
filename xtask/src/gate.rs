//! Everything that has to pass before a change lands.

use std::time::Instant;

use crate::process::{self, cargo};
use crate::{Outcome, api, dependencies, examples, layers, packages, python, readme, viewer};

/// A name and a chore.
type Step = (&'static str, fn() -> Outcome);

/// The steps, cheapest first.
const STEPS: [Step; 11] = [
    ("format", || process::run(&mut cargo(&["fmt", "--all", "--check"]))),
    ("layers", layers::check),
    ("licences", dependencies::check),
    ("packages", packages::check),
    ("lints", || {
        let clippy = ["clippy", "--workspace", "--all-targets", "--locked", "--features", FEATURES];
        process::run(cargo(&clippy).args(["--", "-D", "warnings"]))
    }),
    ("tests", || process::run(&mut cargo(&["test", "--workspace", "--locked"]))),
    ("features", || {
        // Unoptimised: the core is compiled once more for them.
        let test = ["test", "--profile", "dev", "--locked", "--package", "polhode", "--test", "interop"];
        process::run(cargo(&test).args(["--features", FEATURES]))
    }),
    ("documentation", || {
        let doc = ["doc", "--workspace", "--lib", "--no-deps", "--locked"];
        process::run(cargo(&doc).env("RUSTDOCFLAGS", "-D warnings"))
    }),
    ("public names", api::check),
    ("examples", examples::check),
    ("README", readme::check),
];

/// Those that wait for other programs much of their time, side by side.
const LAST: [Step; 2] = [("viewer", viewer::check), ("Python", python::check)];

/// The conversions of the core crate, which no other crate here uses.
const FEATURES: &str = "polhode/serde,polhode/mint,polhode/nalgebra,polhode/glam";

/// Runs every step, up to the first that fails.
pub(crate) fn run() -> Outcome {
    let start = Instant::now();
    STEPS.iter().try_for_each(run_step)?;
    std::thread::scope(|scope| {
        let threads = LAST.map(|step| scope.spawn(move || run_step(&step)));
        let ended = threads.map(|thread| thread.join().unwrap_or_else(|_| Err("a step panicked".to_owned())));
        ended.into_iter().collect::<Outcome>()
    })?;
    println!("\nall passed in {:.0} s", start.elapsed().as_secs_f64());
    Ok(())
}

fn run_step((name, step): &Step) -> Outcome {
    println!("\n== {name}");
    let begun = Instant::now();
    step().map_err(|why| format!("{name}: {why}"))?;
    println!("   {name} passed in {:.1} s", begun.elapsed().as_secs_f64());
    Ok(())
}
