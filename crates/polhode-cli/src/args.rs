//! What the command line can say. Help, completions and the man page come from here.

use clap::{CommandFactory as _, Parser, Subcommand};

use crate::check::Check;
use crate::explain::Explain;
use crate::failure::Failure;
use crate::inertia::Inertia;
use crate::shell::{Completions, Man};
use crate::simulate::Simulate;
use crate::spin::Spin;
use crate::stability::Stability;
use crate::sweep::Sweep;
use crate::torque::Torque;

/// Rigid-body dynamics: from mass to motion.
///
/// Exit status: 0 fine, 1 check found something, 2 bad input or usage, 3 the computation could not reach its tolerance; of
/// several files the worst, 2 before 3 before 1. Data goes to standard output, everything else to standard error.
#[derive(Debug, Parser)]
#[command(name = "polhode", version, after_help = EXAMPLES, max_term_width = 100)]
pub(crate) struct Polhode {
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXAMPLES: &str = "\
Examples:
  polhode inertia part.stl --unit mm --density \"2700 kg/m^3\"
  polhode check examples/robots/bad-arm.urdf
  polhode simulate examples/t-handle.toml
  polhode spin --moments 1,2,3 --omega 0.01,1,0.01
  polhode torque examples/notes/11-10-dumbbell.toml
  polhode explain examples/notes/11-10-dumbbell.toml";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Inertia(Box<Inertia>),
    Check(Check),
    Simulate(Simulate),
    Spin(Box<Spin>),
    Stability(Stability),
    Torque(Torque),
    Sweep(Sweep),
    Explain(Explain),
    Completions(Completions),
    Man(Man),
}

impl Command {
    pub(crate) fn run(self) -> Result<(), Failure> {
        match self {
            Self::Inertia(command) => command.run(),
            Self::Check(command) => command.run(),
            Self::Simulate(command) => command.run(),
            Self::Spin(command) => command.run(),
            Self::Stability(command) => command.run(),
            Self::Torque(command) => command.run(),
            Self::Sweep(command) => command.run(),
            Self::Explain(command) => command.run(),
            Self::Completions(command) => command.run(Polhode::command()),
            Self::Man(command) => command.run(Polhode::command()),
        }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_definitions_are_consistent() {
        use clap::CommandFactory as _;
        super::Polhode::command().debug_assert();
    }
}
