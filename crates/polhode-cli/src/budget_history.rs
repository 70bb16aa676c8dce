//! `polhode budget --scenario`: what happens over time, for simulate.

use std::path::Path;

use polhode::motion::Outflow;
use polhode_budget::read::{BudgetFile, OverTime};
use polhode_budget::report::{HistoryOptions, history_files};
use polhode_budget::{Basis, SequenceError};

use crate::failure::Failure;
use crate::partial;

/// What is said of a list without a sequence, and what its reader may do.
pub(crate) const NOTHING: (&str, &str) = (
    "nothing happens in it over time",
    "add [sequence] with until, and [[burn]], [[drop]] or [[deploy]]; --body has the body as it is",
);

/// Writes a scenario, and beside it the table that it names.
pub(crate) fn write(
    file: &BudgetFile,
    list: &Path,
    basis: Basis,
    target: &Path,
    force: bool,
) -> Result<(), Failure> {
    let over_time = file.prescribed.as_ref().and_then(|all| Some((all, all.over_time.as_ref()?)));
    let Some((prescribed, over_time)) = over_time else {
        let (message, hint) = NOTHING;
        return Err(Failure::usage(message, hint).about(list));
    };
    if target.extension().is_none_or(|extension| extension != "toml") {
        let hint = "name a file that ends in .toml: the table beside it ends in .csv";
        return Err(Failure::usage("a scenario is a TOML file", hint).about(target));
    }
    let beside = target.with_extension("csv");
    let table = beside.file_name().unwrap_or_default().to_string_lossy();
    let name = over_time.configuration.as_deref();
    let of_file = prescribed.sequence(name, basis);
    let sequence = of_file.ok_or_else(|| Failure::usage("the configuration is not there", "").about(list))?;
    let options = HistoryOptions {
        title: file.title.as_deref().unwrap_or("a parts list"),
        until: over_time.until,
        spin: over_time.spin,
        outflow: &over_time.outflow,
        table: &table,
    };
    let files = history_files(&sequence, &options).map_err(|error| no_history(&error, over_time, list))?;
    let [scenario, rows] = files;
    partial::write_pair([(&beside, rows.as_bytes()), (target, scenario.as_bytes())], force)
}

/// What cannot be, with what its reader may do.
pub(crate) fn refused(error: &SequenceError, list: &Path) -> Failure {
    Failure::usage(error.to_string(), error.hint().unwrap_or_default()).about(list)
}

/// The same of a motion: most often nothing says where mass leaves.
fn no_history(error: &SequenceError, over_time: &OverTime, list: &Path) -> Failure {
    let hint = match (error, &over_time.outflow) {
        (SequenceError::Motion(_), Outflow::None) if !over_time.burns().is_empty() => {
            "say where what leaves goes: [[exit]] with position, or in_place = true under [sequence]"
        }
        (SequenceError::Motion(_), Outflow::InPlace) => {
            "say where what leaves goes: [[exit]] with position, and no in_place"
        }
        _ => return refused(error, list),
    };
    Failure::usage(error.to_string(), hint).about(list)
}
