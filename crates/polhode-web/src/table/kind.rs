//! Kinds of tables.

use polhode_shape::particles;
use serde::{Deserialize, Serialize};

use super::field::fields;
use super::{Field, KnownKind};

/// Kind of a table or a plan: the command that reads it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum TableKind {
    /// Parts list, or a plan that names one.
    Budget,
    /// Measured motion: a plan, or the log of a gyro.
    Identify,
    /// Motion that another program computed.
    Judge,
    /// Particles: a body that turns, not a report.
    Particles,
}

impl TableKind {
    pub(crate) const ALL: [Self; 4] = [Self::Budget, Self::Identify, Self::Judge, Self::Particles];

    /// Returns the kind of a plan in TOML; `None` for a scenario.
    pub(crate) fn of_plan(text: &str) -> Option<Self> {
        let is_budget = polhode_budget::read::is_plan(text);
        is_budget.then_some(Self::Budget).or(polhode_identify::read::is_plan(text).then_some(Self::Identify))
    }

    /// Returns the kinds that the headings of a table allow.
    pub(crate) fn of_headings(bytes: &[u8]) -> Vec<Self> {
        // A log that names its scenario was computed and not measured.
        let names_scenario = polhode_judge::scenario_named_by(bytes).is_some();
        let is = |kind: &Self| match kind {
            Self::Budget => polhode_budget::read::is_list(bytes),
            Self::Identify => polhode_identify::read::is_log(bytes) && !names_scenario,
            Self::Judge => polhode_judge::is_run(bytes),
            Self::Particles => particles::is_table(bytes),
        };
        Self::ALL.into_iter().filter(is).collect()
    }

    /// Returns the kind with its meaning and its options. `others` are the paths of other tables.
    pub(crate) fn known(self, is_plan: bool, others: &[String]) -> KnownKind {
        let fields = |schema, keys: &[&str]| -> Vec<Field> { fields(schema, keys, others) };
        let (what, fields) = match self {
            Self::Budget => (
                "Parts list: mass, centre of mass and inertia of the whole, with uncertainties (polhode budget)",
                fields(
                    polhode_budget::REQUEST_SCHEMA,
                    &["configuration", "basis", "about", "along", "draws", "seed", "diff"],
                ),
            ),
            Self::Identify => (
                "Measured motion: the mass properties of a body from its gyro or tracked attitudes (polhode identify)",
                if is_plan {
                    Vec::new()
                } else {
                    fields(polhode_identify::REQUEST_SCHEMA, &["columns", "whole", "drag"])
                },
            ),
            Self::Judge => (
                "Computed motion: the log of a simulation, compared with the exact motion (polhode judge)",
                fields(
                    polhode_judge::REQUEST_SCHEMA,
                    &[
                        "moments",
                        "start-omega",
                        "against",
                        "limit",
                        "step",
                        "columns",
                        "quaternion",
                        "sense",
                        "omega",
                        "axes",
                        "time-origin",
                    ],
                ),
            ),
            Self::Particles => ("Particles: point masses or parts, as one body that turns", Vec::new()),
        };
        KnownKind { kind: self, what, fields }
    }
}
