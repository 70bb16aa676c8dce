//! The command `polhode`: a rigid body in, its mass properties and its motion out.
//!
//! A library with one function, as the Python package has the same command.
#![forbid(unsafe_code)]
#![cfg_attr(
    not(feature = "default"),
    allow(dead_code, reason = "helpers may serve only commands that are left out")
)]

mod args;
mod browser;
#[cfg(feature = "budget")]
mod budget;
#[cfg(feature = "robot")]
mod check;
mod explain;
mod failure;
mod folder;
mod form;
#[cfg(feature = "identify")]
mod identify;
mod inertia;
#[cfg(feature = "judge")]
mod judge;
#[cfg(feature = "live")]
mod live;
mod new;
mod page;
mod partial;
mod plot;
mod progress;
mod same_file;
mod schema;
mod shell;
mod simulate;
mod spin;
mod stability;
mod stderr;
mod stdout;
#[cfg(feature = "sweep")]
mod sweep;
mod table;
mod torque;

use std::ffi::OsString;

use clap::Parser as _;

/// Runs the command with these arguments, the first of which is its own name, and returns its exit status. It owns the process: standard
/// streams, signals, and the end by a signal.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    too_large_is_an_error();
    out_of_memory_is_an_error();
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let done = match args::Polhode::try_parse_from(&arguments) {
        Ok(polhode) => polhode.command.run(),
        // Help and the version are answers: where they cannot be written that is a failure.
        Err(answer) if !answer.use_stderr() => stdout::print_styled(&answer.render()),
        // What was typed stands in the message.
        Err(refusal) => {
            stderr::tell(&args::with_tip(refusal, &arguments).render().to_string());
            return 2;
        }
    };
    match done {
        Ok(()) => 0,
        Err(failure) => failure.report(),
    }
}

/// A file that would pass the limit of `ulimit -f` is an error of the write, as a full disk is, and not the end of the program.
fn too_large_is_an_error() {
    #[cfg(unix)]
    {
        /// Linux, BSD and macOS number it alike.
        const SIGXFSZ: i32 = 25;
        // Nobody looks at the flag: that the signal is caught is all.
        let _ = signal_hook::flag::register(SIGXFSZ, std::sync::Arc::default());
    }
}

/// Memory that cannot be had ends the program as an error does, after the runtime has said how much it was: an allocation that fails
/// in the middle of a vector has nobody to return to, and aborts. Nothing is half-written then: what was begun is beside its place.
fn out_of_memory_is_an_error() {
    #[cfg(unix)]
    {
        use std::sync::Arc;
        use std::sync::atomic::AtomicBool;

        /// Linux, BSD and macOS number it alike.
        const SIGABRT: i32 = 6;
        let always = Arc::new(AtomicBool::new(true));
        // Where it cannot be caught the status is that of an abort.
        let _ = signal_hook::flag::register_conditional_shutdown(SIGABRT, 2, always);
    }
}
