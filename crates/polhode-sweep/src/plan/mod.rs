//! Plans: a scenario, and what differs from member to member.

use std::path::Path;

use polhode::Scenario;
use polhode_formats::{FormatError, scenario};

/// A scenario, and what differs from member to member.
#[derive(Clone, Debug)]
pub struct Plan {
    text: String,
    scenario: Scenario,
    variables: Vec<Variable>,
}

/// Something that differs: one column of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// The column's name.
    pub name: String,
    /// The unit in SI; empty if there is none.
    pub unit: String,
    /// What it is, for people.
    pub description: String,
}

/// How members are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sampling {
    /// Every combination of the values given.
    Grid,
    /// Independent draws.
    MonteCarlo,
    /// One draw in each of as many layers as there are members, in every variable.
    LatinHypercube,
    /// Owen-scrambled Sobol points.
    Sobol,
}

impl Plan {
    /// Reads a plan; the files that it names are found relative to it.
    ///
    /// # Errors
    /// [`FormatError`]
    pub fn read(path: &Path) -> Result<Self, FormatError> {
        let (scenario, text) = scenario::read_with_text(path)?;
        Ok(Self { text, scenario, variables: Vec::new() })
    }

    /// The scenario with every variable as its file has it.
    pub const fn nominal(&self) -> &Scenario {
        &self.scenario
    }

    /// True if the motions of members are to be kept too.
    pub const fn wants_trajectories(&self) -> bool {
        false
    }

    /// The text of its file.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// How many members there are.
    pub const fn members(&self) -> u64 {
        1
    }

    /// How they are drawn.
    pub const fn sampling(&self) -> Sampling {
        Sampling::Grid
    }

    /// What differs.
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// What differs, of a member: a number for each variable, SI. Depends on nothing but the plan and the member's number.
    pub fn values(&self, _member: u64) -> Vec<f64> {
        Vec::new()
    }

    /// The scenario with these values of the variables.
    ///
    /// # Errors
    /// [`FormatError`] if there is no such body or motion: this member fails, others may not.
    pub fn scenario(&self, _values: &[f64]) -> Result<Scenario, FormatError> {
        Ok(self.scenario.clone())
    }

    /// A name for everything that results depend on: the plan's text, the contents of the files that it names, and the program's version.
    pub fn digest(&self) -> String {
        String::new()
    }
}
