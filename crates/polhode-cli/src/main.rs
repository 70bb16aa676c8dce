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
    match args::Polhode::parse().command.run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
