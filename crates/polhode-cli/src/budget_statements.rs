//! What a parts list says besides its rows, for `polhode budget --diff`.

use polhode_budget::read::{BudgetFile, FilledTank, OverTime, PlannedChange};
use polhode_budget::report::{BudgetReport, BudgetStatements, StatedChange, StatedSequence, StatedTank};

/// All that it says besides its rows and its limits.
pub(crate) fn statements(file: &BudgetFile) -> BudgetStatements {
    let mut stated = BudgetStatements {
        draws: Some(file.questions.draws.unwrap_or(BudgetReport::DRAWS)),
        ballast: file.ballast.clone(),
        ..BudgetStatements::default()
    };
    let Some(prescribed) = &file.prescribed else { return stated };
    for (name, dry, tanks) in prescribed.dry() {
        stated.dry.push((name.map(str::to_owned), dry.clone()));
        for FilledTank { tank, mass, errors, group } in tanks {
            let known = stated.tanks.iter_mut().find(|other| other.tank.name == tank.name);
            match known {
                Some(known) => known.configurations.extend(name.map(str::to_owned)),
                None => stated.tanks.push(StatedTank {
                    tank: tank.clone(),
                    configurations: name.iter().map(|name| (*name).to_owned()).collect(),
                    mass: *mass,
                    errors: *errors,
                    group: group.clone(),
                }),
            }
        }
    }
    stated.sequence = prescribed.over_time.as_ref().map(sequence);
    stated
}

fn sequence(all: &OverTime) -> StatedSequence {
    let change = |change: &PlannedChange| match change.clone() {
        PlannedChange::Drop { time, rows } => StatedChange::Drop { time, rows },
        PlannedChange::Deploy { time, configuration } => StatedChange::Deploy { time, configuration },
    };
    StatedSequence {
        configuration: all.configuration.clone(),
        until: all.until,
        spin: all.spin,
        outflow: all.outflow.clone(),
        burns: all.burns().to_vec(),
        changes: all.changes().iter().map(change).collect(),
    }
}
