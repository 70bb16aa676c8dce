//! What a parts list says besides its rows and its limits: it is compared by differences, and not computed for them.

use polhode::math::{AngularVelocity, Body};
use polhode::motion::Outflow;

use crate::{Ballast, Budget, Burn, LiquidErrors, Tank};

/// What a parts list says besides its rows and its limits.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BudgetStatements {
    /// How many bodies it asks to be drawn.
    pub draws: Option<usize>,
    /// Where ballast may be.
    pub ballast: Option<Ballast>,
    /// Its tanks.
    pub tanks: Vec<StatedTank>,
    /// Each configuration that has tanks, without what is in them.
    pub dry: Vec<(Option<String>, Budget)>,
    /// What is to happen.
    pub sequence: Option<StatedSequence>,
}

/// A tank.
#[derive(Clone, Debug, PartialEq)]
pub struct StatedTank {
    /// The tank.
    pub tank: Tank,
    /// The configurations that it is in, by their names.
    pub configurations: Vec<String>,
    /// What is in it at first, kg.
    pub mass: f64,
    /// How well that is known.
    pub errors: LiquidErrors,
    /// The group with which its errors are correlated.
    pub group: Option<String>,
}

/// What is to happen over time.
#[derive(Clone, Debug, PartialEq)]
pub struct StatedSequence {
    /// The configuration that it begins as.
    pub configuration: Option<String>,
    /// s
    pub until: f64,
    /// What the body has at first.
    pub spin: Option<AngularVelocity<Body>>,
    /// Where mass leaves.
    pub outflow: Outflow,
    /// What leaves tanks.
    pub burns: Vec<Burn>,
    /// What happens at once.
    pub changes: Vec<StatedChange>,
}

/// What happens at once.
#[derive(Clone, Debug, PartialEq)]
pub enum StatedChange {
    /// Rows go.
    Drop {
        /// s
        time: f64,
        /// Their names.
        rows: Vec<String>,
    },
    /// Another configuration is taken.
    Deploy {
        /// s
        time: f64,
        /// Its name.
        configuration: String,
    },
}

impl StatedChange {
    /// When, s.
    pub const fn time(&self) -> f64 {
        match self {
            Self::Drop { time, .. } | Self::Deploy { time, .. } => *time,
        }
    }
}
