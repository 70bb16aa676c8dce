//! Executable of the command `polhode`.
#![forbid(unsafe_code)]

use std::process::ExitCode;

/// Thread that reads USD by the crate `openusd`. A defect there is an error of the file, which the
/// command reports.
const CONTAINED: &str = "usd";

fn main() -> ExitCode {
    let report = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |defect| {
        if std::thread::current().name() != Some(CONTAINED) {
            report(defect);
        }
    }));
    ExitCode::from(polhode_cli::run(std::env::args_os()))
}
