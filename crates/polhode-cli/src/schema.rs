//! `polhode schema`

use clap::{Args, ValueEnum};
use polhode_course::exercise;
use polhode_scenario::request::{explain, simulate, spin, stability, torque};

use crate::failure::Failure;
use crate::stdout::print_script;

/// Print the JSON schema of scenario files, or of a command's JSON output.
///
/// An editor that uses the schema of scenario files completes keys and marks invalid ones. A
/// command's schema states the meaning and the unit of every number.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode schema scenario > scenario.schema.json
  polhode schema inertia
  polhode schema inertia --request")]
pub(crate) struct Schema {
    /// Scenario files, or the command whose JSON is described.
    #[arg(value_enum)]
    name: Name,
    /// Describe the request instead of the report: the input of the library function.
    #[arg(long)]
    request: bool,
}

/// Files and reports that have a schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Name {
    /// Scenario files: one body and one motion, as TOML.
    Scenario,
    /// Report of `polhode inertia --json`.
    Inertia,
    /// Report of `polhode simulate --json`.
    Simulate,
    /// Report of `polhode spin --json`.
    Spin,
    /// Report of `polhode stability --json`.
    Stability,
    /// Report of `polhode torque --json`.
    Torque,
    /// Report of `polhode explain --json`.
    Explain,
    /// Report of `polhode exercise --json`.
    Exercise,
    /// Report of `polhode check --json`.
    #[cfg(feature = "robot")]
    Check,
    /// Report of `polhode compare --json`.
    #[cfg(feature = "robot")]
    Compare,
    /// Report of `polhode sweep --json`.
    #[cfg(feature = "sweep")]
    Sweep,
    /// Report of `polhode judge --json`.
    #[cfg(feature = "judge")]
    Judge,
    /// Report of `polhode identify --json`.
    #[cfg(feature = "identify")]
    Identify,
    /// Report of `polhode budget --json`.
    #[cfg(feature = "budget")]
    Budget,
}

impl Schema {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let [report, request] = match self.name {
            Name::Scenario if self.request => {
                let hint = "polhode schema scenario describes the files";
                return Err(Failure::usage("scenario files have no request schema", hint));
            }
            Name::Scenario => {
                let schema = polhode_scenario::read::schema();
                return print_script(format!("{schema:#}\n").as_bytes());
            }
            Name::Inertia => [polhode_shape::REPORT_SCHEMA, polhode_shape::REQUEST_SCHEMA],
            Name::Simulate => [simulate::REPORT_SCHEMA.as_str(), simulate::REQUEST_SCHEMA],
            Name::Spin => [spin::REPORT_SCHEMA.as_str(), spin::REQUEST_SCHEMA],
            Name::Stability => [stability::REPORT_SCHEMA.as_str(), stability::REQUEST_SCHEMA],
            Name::Torque => [torque::REPORT_SCHEMA.as_str(), torque::REQUEST_SCHEMA],
            Name::Explain => [explain::REPORT_SCHEMA.as_str(), explain::REQUEST_SCHEMA],
            Name::Exercise => [exercise::REPORT_SCHEMA, exercise::REQUEST_SCHEMA],
            #[cfg(feature = "robot")]
            Name::Check => [polhode_robot::REPORT_SCHEMA, polhode_robot::REQUEST_SCHEMA],
            #[cfg(feature = "robot")]
            Name::Compare => [polhode_robot::compare::REPORT_SCHEMA, polhode_robot::compare::REQUEST_SCHEMA],
            #[cfg(feature = "sweep")]
            Name::Sweep => [polhode_sweep::REPORT_SCHEMA, polhode_sweep::REQUEST_SCHEMA],
            #[cfg(feature = "judge")]
            Name::Judge => [polhode_judge::REPORT_SCHEMA, polhode_judge::REQUEST_SCHEMA],
            #[cfg(feature = "identify")]
            Name::Identify => [polhode_identify::REPORT_SCHEMA, polhode_identify::REQUEST_SCHEMA],
            #[cfg(feature = "budget")]
            Name::Budget => [polhode_budget::REPORT_SCHEMA, polhode_budget::REQUEST_SCHEMA],
        };
        print_script(if self.request { request } else { report }.as_bytes())
    }
}
