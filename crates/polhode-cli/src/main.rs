//! Executable of the command `polhode`.
#![forbid(unsafe_code)]

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(polhode_cli::run(std::env::args_os()))
}
