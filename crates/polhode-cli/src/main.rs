//! The command `polhode`: a rigid body in, its mass properties and its motion out.
#![forbid(unsafe_code)]

mod args;
mod check;
mod explain;
mod failure;
mod folder;
mod inertia;
mod model_file;
mod numbers;
mod page;
mod plot;
mod progress;
mod shell;
mod simulate;
mod spin;
mod stability;
mod stdout;
mod sweep;
mod table;
mod torque;

use clap::Parser as _;
use std::process::ExitCode;

fn main() -> ExitCode {
    let done = match args::Polhode::try_parse() {
        Ok(polhode) => polhode.command.run(),
        // Help and the version are answers: where they cannot be written that is a failure.
        Err(answer) if !answer.use_stderr() => stdout::print_styled(&answer.render()),
        Err(refusal) => refusal.exit(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
