//! Everything that has to pass before a change lands.

use std::time::Instant;

use crate::process::{self, cargo};
use crate::{Outcome, api, dependencies, examples, layers, packages, python, readme, viewer};

/// A name and a chore.
type Step = (&'static str, fn() -> Outcome);

/// The steps, cheapest first.
const STEPS: [Step; 12] = [
    ("format", || process::run(&mut cargo(&["fmt", "--all", "--check"]))),
    ("layers", layers::check),
    ("licences", dependencies::check),
    ("packages", packages::check),
    ("lints", || {
        let clippy = ["clippy", "--workspace", "--all-targets", "--locked", "--", "-D", "warnings"];
        process::run(&mut cargo(&clippy))
    }),
    ("tests", || process::run(&mut cargo(&["test", "--workspace", "--locked"]))),
    ("documentation", || {
        let doc = ["doc", "--workspace", "--lib", "--no-deps", "--locked"];
        process::run(cargo(&doc).env("RUSTDOCFLAGS", "-D warnings"))
    }),
    ("public names", api::check),
    ("examples", examples::check),
    ("README", readme::check),
    ("viewer", viewer::check),
    ("Python", python::check),
];

/// Runs every step, up to the first that fails.
pub(crate) fn run() -> Outcome {
    let start = Instant::now();
    for (name, step) in STEPS {
        println!("\n== {name}");
        let begun = Instant::now();
        step().map_err(|why| format!("{name}: {why}"))?;
        println!("   passed in {:.1} s", begun.elapsed().as_secs_f64());
    }
    println!("\nall passed in {:.0} s", start.elapsed().as_secs_f64());
    Ok(())
}
