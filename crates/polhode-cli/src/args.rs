//! Definitions of the command line. Help, completions and the man page are generated from them.

use std::ffi::OsString;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory as _, Parser, Subcommand};

#[cfg(feature = "budget")]
use crate::budget::BudgetCommand;
#[cfg(feature = "robot")]
use crate::check::Check;
#[cfg(feature = "robot")]
use crate::compare::Compare;
use crate::exercise::Exercise;
use crate::explain::Explain;
use crate::failure::Failure;
#[cfg(feature = "identify")]
use crate::identify::Identify;
use crate::inertia::Inertia;
#[cfg(feature = "judge")]
use crate::judge::Judge;
#[cfg(feature = "live")]
use crate::live::Live;
#[cfg(feature = "mcp")]
use crate::mcp::Mcp;
use crate::new::New;
use crate::schema::Schema;
use crate::shell::{Completions, Man};
use crate::simulate::Simulate;
use crate::spin::Spin;
use crate::stability::Stability;
#[cfg(feature = "sweep")]
use crate::sweep::Sweep;
use crate::torque::Torque;

/// Rigid-body dynamics: from mass to motion.
///
/// Exit status: 0 success; 1 check, compare or judge has findings; 2 invalid input or usage; 3 the
/// computation did not reach its tolerance. With several files, the worst status counts, in the
/// order 2, 3, 1. Results go to standard output, messages to standard error.
#[derive(Debug, Parser)]
#[command(name = "polhode", version, after_help = examples(), max_term_width = 100)]
pub(crate) struct Polhode {
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXAMPLES: &str = "\
Examples:
  polhode new top
  polhode inertia part.stl --unit mm --density \"2700 kg/m^3\"
  polhode check examples/robots/bad-arm.urdf
  polhode simulate examples/t-handle.toml
  polhode spin --moments 1,2,3 --omega 0.01,1,0.01
  polhode torque examples/notes/11-10-dumbbell.toml
  polhode explain examples/notes/11-10-dumbbell.toml
  polhode judge examples/judge/mujoco-rk4.csv";

/// Returns [`EXAMPLES`] without those of commands that this build does not include.
fn examples() -> String {
    let commands = [(cfg!(feature = "robot"), "polhode check"), (cfg!(feature = "judge"), "polhode judge")];
    let is_there =
        |line: &&str| commands.iter().all(|(is_built, command)| *is_built || !line.contains(command));
    EXAMPLES.lines().filter(is_there).collect::<Vec<_>>().join("\n")
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    New(New),
    Inertia(Box<Inertia>),
    #[cfg(feature = "robot")]
    Check(Check),
    #[cfg(feature = "robot")]
    Compare(Compare),
    Simulate(Simulate),
    Spin(Box<Spin>),
    Stability(Stability),
    Torque(Torque),
    #[cfg(feature = "sweep")]
    Sweep(Sweep),
    Explain(Explain),
    Exercise(Exercise),
    #[cfg(feature = "judge")]
    Judge(Box<Judge>),
    #[cfg(feature = "identify")]
    Identify(Identify),
    #[cfg(feature = "budget")]
    Budget(Box<BudgetCommand>),
    #[cfg(feature = "live")]
    Live(Live),
    #[cfg(feature = "mcp")]
    Mcp(Mcp),
    Schema(Schema),
    Completions(Completions),
    Man(Man),
}

impl Command {
    pub(crate) fn run(self) -> Result<(), Failure> {
        match self {
            Self::New(command) => command.run(),
            Self::Inertia(command) => command.run(),
            #[cfg(feature = "robot")]
            Self::Check(command) => command.run(),
            #[cfg(feature = "robot")]
            Self::Compare(command) => command.run(),
            Self::Simulate(command) => command.run(),
            Self::Spin(command) => command.run(),
            Self::Stability(command) => command.run(),
            Self::Torque(command) => command.run(),
            #[cfg(feature = "sweep")]
            Self::Sweep(command) => command.run(),
            Self::Explain(command) => command.run(),
            Self::Exercise(command) => command.run(),
            #[cfg(feature = "judge")]
            Self::Judge(command) => command.run(),
            #[cfg(feature = "identify")]
            Self::Identify(command) => command.run(),
            #[cfg(feature = "budget")]
            Self::Budget(command) => command.run(),
            #[cfg(feature = "live")]
            Self::Live(command) => command.run(),
            #[cfg(feature = "mcp")]
            Self::Mcp(command) => command.run(),
            Self::Schema(command) => command.run(),
            Self::Completions(command) => command.run(Polhode::command()),
            Self::Man(command) => command.run(Polhode::command()),
        }
    }
}

/// Returns the usage error with a useful tip. For a value that begins with `-`, clap suggests `--`
/// in front of it. That is correct for a file name, and wrong for the value of an option and for an
/// unknown option.
pub(crate) fn with_tip(mut refusal: clap::Error, given: &[OsString]) -> clap::Error {
    let Some(ContextValue::String(found)) = refusal.get(ContextKind::InvalidArg).cloned() else {
        return refusal;
    };
    let given: Vec<String> = given.iter().map(|text| text.to_string_lossy().into_owned()).collect();
    let joined = given.windows(2).find_map(|pair| match pair {
        [option, value] if value.starts_with(&found) && takes_value(&given, option) => {
            let quote = if value.contains(char::is_whitespace) { "\"" } else { "" };
            Some(format!(
                "a value that begins with '-' must be joined to its option: {option}={quote}{value}{quote}"
            ))
        }
        _ => None,
    });
    if refusal.kind() == ErrorKind::UnknownArgument {
        if let Some(tip) = joined {
            refusal.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip.into()]));
        } else if found.starts_with("--") {
            // An unknown option is not a file name.
            refusal.remove(ContextKind::Suggested);
        }
    }
    refusal
}

/// Returns true if the called subcommand has this option, and the option takes a value.
fn takes_value(given: &[String], option: &str) -> bool {
    let polhode = Polhode::command();
    let subcommand = given.get(1).and_then(|name| polhode.find_subcommand(name));
    subcommand.is_some_and(|subcommand| {
        let mut options = subcommand.get_arguments().filter(|argument| argument.get_action().takes_values());
        options
            .any(|argument| argument.get_long().is_some_and(|long| option.strip_prefix("--") == Some(long)))
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_definitions_are_consistent() {
        use clap::CommandFactory as _;
        super::Polhode::command().debug_assert();
    }
}
