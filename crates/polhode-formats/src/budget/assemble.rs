//! Rows as budgets: one of each configuration.

use std::collections::{HashMap, HashSet};

use polhode_budget::{Budget, PartsList, Row};

use super::NamedBudget;
use super::blame::Blame;
use super::key::MASS;
use super::plan::Plan;
use super::rows::{ReadRow, Rows};
use super::sheet::Cell;
use crate::content::{ContentError, ContentErrorKind, ContentPlace};
use crate::error::{FormatError, FormatErrorKind};

/// The name of a frame in which all parts stand that stand in no other.
const WHOLE: &str = "whole";

/// Each has all rows of its own: more would fill the memory.
const MOST_CONFIGURATIONS: usize = 100;

/// A budget of each configuration; lines are added about what was taken as given.
pub(super) fn budgets(
    rows: Vec<ReadRow>,
    plan: &Plan,
    reader: &Rows<'_, '_>,
    lines: &mut Vec<String>,
) -> Result<Vec<NamedBudget>, FormatError> {
    let mut names = plan.configurations.clone().unwrap_or_default();
    for (row, name) in rows.iter().flat_map(|row| row.configurations.iter().map(move |name| (row, name))) {
        if names.contains(name) {
            continue;
        }
        names.push(name.clone());
        if names.len() > MOST_CONFIGURATIONS {
            let what = format!("more than {MOST_CONFIGURATIONS} configurations");
            let error = ContentError::new(ContentErrorKind::Unsupported { what }, ContentPlace::Whole);
            let sheet = reader.reader.sheet;
            return Err(sheet.row_error(Some(row.origin), FormatErrorKind::Content(error)));
        }
    }
    if names.is_empty() {
        let (rows, origins): (Vec<_>, Vec<_>) = rows.into_iter().map(|row| (row.row, row.origin)).unzip();
        let budget = one(rows, &origins, plan, reader, None, lines)?;
        return Ok(vec![NamedBudget { name: None, budget }]);
    }
    let mut budgets = Vec::new();
    for name in names {
        let inside =
            rows.iter().filter(|row| row.configurations.is_empty() || row.configurations.contains(&name));
        let (rows, origins): (Vec<_>, Vec<_>) = inside.map(|row| (row.row.clone(), row.origin)).unzip();
        let budget = one(rows, &origins, plan, reader, Some(&name), lines)?;
        budgets.push(NamedBudget { name: Some(name), budget });
    }
    Ok(budgets)
}

fn one(
    mut rows: Vec<Row>,
    origins: &[usize],
    plan: &Plan,
    reader: &Rows<'_, '_>,
    configuration: Option<&str>,
    lines: &mut Vec<String>,
) -> Result<Budget, FormatError> {
    let suffix = configuration.map_or_else(String::new, |name| format!(" in the configuration {name}"));
    lines.push(format!("{} rows{suffix}", rows.len()));
    let is_flat = rows.len() > 1 && rows.iter().all(|row| row.parent.is_none() && !row.name.contains('/'));
    if is_flat {
        let name = whole(&rows, plan.title.as_deref());
        lines.push(format!("all rows stand in one frame, \"{name}\", as none names another"));
        rows.iter_mut().for_each(|row| row.parent = Some(name.clone()));
        rows.push(Row::frame(name));
    }
    let names = rows.iter().take(MOST_SUGGESTED).map(|row| row.name.clone()).collect();
    let blame = Blame { reader, plan, origins, configuration, names };
    let list = PartsList { rows, groups: plan.groups.clone(), growth: plan.growth.clone() };
    let budget = list.budget().map_err(|error| blame.of(error))?;
    double_counting(&budget, &blame)?;
    Ok(budget)
}

/// What the frame of all is called: as the list is, if no row is.
fn whole(rows: &[Row], title: Option<&str>) -> String {
    let names: HashSet<&str> = rows.iter().map(|row| row.name.as_str()).collect();
    let title = title.map(|title| title.replace('/', " ").trim().to_owned());
    let numbered = (2..).map(|number| format!("{WHOLE} {number}"));
    let mut all = title.into_iter().chain([WHOLE.to_owned()]).chain(numbered);
    all.find(|name| !name.is_empty() && !names.contains(name.as_str())).unwrap_or_default()
}

/// Names among which one is looked for that is nearly another.
const MOST_SUGGESTED: usize = 1000;

/// Refuses the mass of a row that is the sum of the rows in it: a spreadsheet's total, which would count twice.
fn double_counting(budget: &Budget, blame: &Blame<'_, '_, '_>) -> Result<(), FormatError> {
    let rows = &budget.list().rows;
    // Of rows with a mass of their own in which two others or more stand: the masses of these, and how many.
    let mut direct: HashMap<usize, (f64, usize)> = HashMap::new();
    for (row, parent) in rows.iter().zip(budget.parents()) {
        if let Some(parent) = parent
            && rows.get(*parent).is_some_and(|row| row.part.is_some())
        {
            let (sum, count) = direct.entry(*parent).or_default();
            *count += 1;
            *sum += row.part.as_ref().map_or(0.0, |part| part.mass * f64::from(row.quantity.count));
        }
    }
    let mut found: Vec<(usize, f64)> =
        direct.into_iter().filter(|(_, (_, count))| *count > 1).map(|(row, (sum, _))| (row, sum)).collect();
    if found.is_empty() {
        return Ok(());
    }
    found.sort_by_key(|(row, _)| *row);
    let statements = budget.mass_statements().map_err(|error| blame.of(error))?;
    for (k, direct) in found {
        let (Some(row), Some(statement)) = (rows.get(k), statements.get(k)) else { continue };
        let Some(own) = row.part.as_ref().map(|part| part.mass) else { continue };
        let Some(cell) = blame.cell(k, &[MASS]) else { continue };
        let inside = statement.basic / f64::from(row.quantity.count) - own;
        let tolerance = blame.reader.reader.half_digit(cell)? + 1e-9 * own;
        if (own - direct).abs() <= tolerance || (own - inside).abs() <= tolerance {
            return Err(total(blame, cell));
        }
    }
    Ok(())
}

fn total(blame: &Blame<'_, '_, '_>, cell: &Cell<'_>) -> FormatError {
    let rule = "the mass of the part itself, but it is the sum of the rows that stand in it: these would count twice";
    let hint = "write a sum into the column subtotal; if the part itself has that mass, give it a row of its own, which stands in this one";
    blame.reader.reader.invalid(cell, rule).with_hint(hint)
}
