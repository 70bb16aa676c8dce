//! Report of a file.

use polhode_source::Failure;

use super::body::no_configuration;
use super::{BudgetReport, Statements};
use crate::read::{BudgetFile, Questions};

/// Extent of a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// Everything: draws, limits, ballast, and the whole over time and by tank fill.
    Full,
    /// List as given, without ballast.
    Given {
        /// True if limits are tested by draws.
        is_drawn: bool,
        /// True if the whole over time and by tank fill is computed.
        has_states: bool,
    },
    /// List as given, with all its statements, for a difference.
    Diff,
}

impl BudgetReport {
    /// Computes the report of a file, or of one of its configurations. Calls `reached` with the
    /// number of bodies drawn so far and the total number.
    ///
    /// # Errors
    /// [`Failure`] that does not name the file: if the configuration does not exist, and for errors
    /// of [`BudgetReport::new`], [`BudgetReport::with_sequence`] and
    /// [`BudgetReport::with_ballast`].
    pub fn of_file(
        file: BudgetFile,
        questions: &Questions,
        configuration: Option<&str>,
        scope: Scope,
        reached: &mut dyn FnMut(usize, usize),
    ) -> Result<Self, Failure> {
        let (is_drawn, has_states) = match scope {
            Scope::Full => (true, true),
            Scope::Given { is_drawn, has_states } => (is_drawn, has_states),
            Scope::Diff => (false, false),
        };
        let sources = file.sources();
        let stated = file.questions.draws.unwrap_or(Self::DRAWS);
        let BudgetFile { title, configurations, limits, ballast, prescribed, .. } = file;
        let mut all: Vec<_> = configurations.into_iter().map(|one| (one.name, one.budget)).collect();
        if let Some(wanted) = configuration {
            if all.iter().all(|(name, _)| name.as_deref() != Some(wanted)) {
                let names: Vec<&str> = all.iter().filter_map(|(name, _)| name.as_deref()).collect();
                return Err(no_configuration(Some(wanted), &names));
            }
            all.retain(|(name, _)| name.as_deref() == Some(wanted));
        }
        let rows = all.iter().map(|(_, budget)| budget.rows().len()).max().unwrap_or(0);
        let draws = || questions.draws.unwrap_or_else(|| Self::affordable_draws(rows));
        let count = if is_drawn { draws() } else { 0 };
        let options = Questions { draws: Some(count), ..questions.clone() };
        let mut drawn = |drawn| reached(drawn, count);
        let mut report = Self::watched(title.as_deref(), sources, all, limits, options, &mut drawn)?;
        if scope == Scope::Diff {
            return Ok(report.with_statements(Statements { draws: Some(stated), ballast, prescribed }));
        }
        for name in report.names() {
            let Some(prescribed) = prescribed.as_ref().filter(|_| has_states) else { break };
            let Some(sequence) = prescribed.sequence(name.as_deref(), questions.basis) else { continue };
            let over_time = prescribed.over_time.as_ref().filter(|all| all.configuration == name);
            report = report.with_sequence(name.as_deref(), &sequence, over_time.map(|all| all.until))?;
        }
        match ballast.filter(|_| scope == Scope::Full) {
            None => Ok(report),
            Some(ballast) => report.with_ballast(ballast).map_err(|error| {
                let hint = "delete [[site]] to see the limits without ballast";
                Failure::usage(error.to_string(), hint)
            }),
        }
    }
}
