//! The command `polhode`: mass properties and motion of a rigid body.
//!
//! It is a library with a single function, which the Python package also calls.
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
#[cfg(feature = "robot")]
mod compare;
mod exercise;
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
#[cfg(feature = "mcp")]
mod mcp;
mod new;
#[cfg(feature = "robot")]
mod outputs;
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
mod written;
#[cfg(feature = "robot")]
mod xacro;

use std::ffi::OsString;

use clap::Parser as _;

/// Runs the command with these arguments, the first of which is its own name, and returns its exit
/// status. It assumes ownership of the process: standard streams, signal handlers, and termination
/// by a signal.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    too_large_is_an_error();
    out_of_memory_is_an_error();
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let done = match args::Polhode::try_parse_from(&arguments) {
        Ok(polhode) => polhode.command.run(),
        // Help and version are results: failing to write them is a failure.
        Err(answer) if !answer.use_stderr() => stdout::print_styled(&answer.render()),
        // The message quotes what the user typed.
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

/// Turns exceeding `ulimit -f` into a write error, as for a full disk, instead of a fatal signal.
fn too_large_is_an_error() {
    #[cfg(unix)]
    {
        /// Signal number on Linux, BSD and macOS.
        const SIGXFSZ: i32 = 25;
        // The flag is not used; catching the signal is enough.
        let _ = signal_hook::flag::register(SIGXFSZ, std::sync::Arc::default());
    }
}

/// Turns a failed allocation into an error exit, after the runtime has printed the size. An
/// allocation failure inside a vector cannot return an error, and aborts. No file is left
/// half-written, because files are written next to their final place.
fn out_of_memory_is_an_error() {
    #[cfg(unix)]
    {
        use std::sync::Arc;
        use std::sync::atomic::AtomicBool;

        /// Signal number on Linux, BSD and macOS.
        const SIGABRT: i32 = 6;
        let always = Arc::new(AtomicBool::new(true));
        // If the signal cannot be caught, the exit status is that of an abort.
        let _ = signal_hook::flag::register_conditional_shutdown(SIGABRT, 2, always);
    }
}
