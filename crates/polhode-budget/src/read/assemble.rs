//! Budgets from the rows of a table: one for each configuration.

use std::collections::{HashMap, HashSet};

use polhode_source::{FormatError, FormatErrorKind};

use super::NamedBudget;
use super::blame::Blame;
use super::cell::Cell;
use super::key::{AT_X, AT_Y, AT_Z, IXX, IYY, IZZ, MASS, X, Y, Z};
use super::plan::Plan;
use super::rows::{ReadRows, Rows};
use crate::{Budget, BudgetError, Row};

/// Default name of the root frame of a list without parents.
const WHOLE: &str = "whole";

/// Makes a budget for each configuration. Appends sentences about the assumptions to `lines`.
pub(crate) fn budgets(
    read: ReadRows,
    plan: &Plan,
    reader: &Rows<'_, '_>,
    lines: &mut Vec<String>,
) -> Result<Vec<NamedBudget>, FormatError> {
    let ReadRows { rows, origins, configurations, members } = read;
    let mut is_used = vec![false; reader.reader.sheet.rows.len()];
    if configurations.is_empty() {
        let budget = one(rows, &origins, plan, reader, None, lines)?;
        mark_used(&budget, &origins, plan, &mut is_used);
        without_effect(&origins, &is_used, reader)?;
        return Ok(vec![NamedBudget { name: None, budget }]);
    }
    let mut budgets = Vec::new();
    for (number, name) in (0..).zip(configurations) {
        let (mut inside, mut inside_origins) = (crate::Rows::default(), Vec::new());
        let mut members = members.iter().peekable();
        for (k, origin) in (0..).zip(&origins) {
            let (mut is_in_some, mut is_in) = (false, false);
            while let Some((_, member)) = members.next_if(|(row, _)| *row == k) {
                is_in_some = true;
                is_in |= *member == number;
            }
            if is_in || !is_in_some {
                inside.push(rows.get(k as usize));
                inside_origins.push(*origin);
            }
        }
        let budget = one(inside, &inside_origins, plan, reader, Some(&name), lines)?;
        mark_used(&budget, &inside_origins, plan, &mut is_used);
        budgets.push(NamedBudget { name: Some(name), budget });
    }
    without_effect(&origins, &is_used, reader)?;
    Ok(budgets)
}

/// Marks the rows of the table that have an effect: parts, frames of other rows, and frames whose
/// origins tensors or tanks use.
fn mark_used(budget: &Budget, origins: &[u32], plan: &Plan, is_used: &mut [bool]) {
    let rows = budget.rows();
    let mut frames: HashSet<&str> = plan.tanks.iter().filter_map(|tank| tank.frame.as_deref()).collect();
    frames.extend((0..rows.len()).filter_map(|k| rows.tensor_frame(k)));
    for (k, origin) in origins.iter().enumerate() {
        if rows.has_part(k) || budget.has_rows_in(k) || frames.contains(rows.name(k)) {
            is_used.get_mut(*origin as usize).into_iter().for_each(|used| *used = true);
        }
    }
}

/// Refuses a row without mass and without children.
fn without_effect(origins: &[u32], is_used: &[bool], reader: &Rows<'_, '_>) -> Result<(), FormatError> {
    let reader = &reader.reader;
    let unused = origins.iter().find(|origin| is_used.get(**origin as usize) == Some(&false));
    let row = unused.and_then(|origin| reader.sheet.rows.get(*origin as usize));
    let Some(cell) = row.and_then(|row| reader.sheet.row(row).into_iter().next()) else { return Ok(()) };
    let error = reader.invalid(&cell, "a row with mass, or the parent of other rows");
    Err(error.with_hint("an empty frame has no effect: give it a mass, or delete it"))
}

fn one(
    mut rows: crate::Rows,
    origins: &[u32],
    plan: &Plan,
    reader: &Rows<'_, '_>,
    configuration: Option<&str>,
    lines: &mut Vec<String>,
) -> Result<Budget, FormatError> {
    let suffix = configuration.map_or_else(String::new, |name| format!(" in the configuration {name}"));
    lines.push(format!("{} rows{suffix}", rows.len()));
    let is_flat = rows.len() > 1 && (0..rows.len()).all(|k| rows.frame_of(k).is_none());
    if is_flat {
        let name = whole(&rows, plan.title.as_deref());
        lines.push(format!("all rows are in one frame, \"{name}\", because no row has a parent"));
        rows.enclose(Row::frame(name));
    }
    let names = rows.iter().take(MOST_SUGGESTED).map(|row| row.name).collect();
    let blame = Blame { reader, plan, origins, configuration, names };
    let budget = Budget::new(rows, plan.groups.clone(), plan.growth.clone());
    let budget = budget.map_err(|error| blame.of(&error))?;
    double_counting(&budget, &blame)?;
    budget.mass_properties(plan.questions.basis).map_err(|error| too_large(&error, &budget, &blame))?;
    Ok(budget)
}

/// Returns the error of a sum that overflows, at the cell with the largest number of the list.
fn too_large(error: &BudgetError, budget: &Budget, blame: &Blame<'_, '_, '_>) -> FormatError {
    let numbers = |row: Row| {
        let part = row.part.as_ref();
        let mass = part.map_or(0.0, |part| part.mass);
        let [x, y, z] = part.map_or([0.0; 3], |part| part.center_of_mass.to_array());
        let [xx, yy, zz] = part.map_or([0.0; 3], |part| part.tensor.moments);
        let [at_x, at_y, at_z] = row.place.position.to_array();
        [mass, x, y, z, xx, yy, zz, at_x, at_y, at_z].map(f64::abs)
    };
    let keys = [MASS, X, Y, Z, IXX, IYY, IZZ, AT_X, AT_Y, AT_Z];
    let all = (budget.rows().iter().enumerate())
        .flat_map(|(k, row)| numbers(row).into_iter().zip(keys).map(move |(number, key)| (number, k, key)));
    let cell = all.max_by(|a, b| a.0.total_cmp(&b.0)).and_then(|(_, k, key)| blame.cell(k, &[key]));
    match (cell, error.hint()) {
        (Some(cell), hint @ Some(_)) => {
            blame.reader.reader.sheet.error(&cell, FormatErrorKind::subject(error, hint))
        }
        _ => blame.of(error),
    }
}

/// Returns the name of the root frame: the title of the list, unless a row has that name.
fn whole(rows: &crate::Rows, title: Option<&str>) -> String {
    let title = title.map(|title| title.replace('/', " ").trim().to_owned());
    let numbered = (2..).map(|number| format!("{WHOLE} {number}"));
    let mut all = title.into_iter().chain([WHOLE.to_owned()]).chain(numbered);
    all.find(|name| !name.is_empty() && rows.position(name).is_none()).unwrap_or_default()
}

/// Largest number of names that are searched for a suggestion.
const MOST_SUGGESTED: usize = 1000;

/// Refuses a mass that is the sum of the rows below it. It would be a total of a spreadsheet, and
/// count twice.
fn double_counting(budget: &Budget, blame: &Blame<'_, '_, '_>) -> Result<(), FormatError> {
    let rows = budget.rows();
    // For each row with its own mass and with children: the mass of the children, and their number.
    let mut direct: HashMap<usize, (f64, usize)> = HashMap::new();
    for k in 0..rows.len() {
        if let Some(parent) = budget.parent(k).filter(|parent| rows.has_part(*parent)) {
            let (sum, count) = direct.entry(parent).or_default();
            *count += 1;
            *sum += rows.mass(k).map_or(0.0, |mass| mass * f64::from(rows.quantity(k).count));
        }
    }
    let mut found: Vec<(usize, (f64, usize))> = direct.into_iter().collect();
    if found.is_empty() {
        return Ok(());
    }
    found.sort_by_key(|(row, _)| *row);
    let statements = budget.mass_statements().map_err(|error| blame.of(&error))?;
    for (k, (direct, count)) in found {
        let (Some(own), Some(statement)) = (rows.mass(k), statements.get(k)) else { continue };
        let Some(cell) = blame.cell(k, &[MASS]) else { continue };
        let inside = statement.basic / f64::from(rows.quantity(k).count) - own;
        // A sum may be rounded. The mass of a single row is copied exactly.
        let rounding = if count > 1 { blame.reader.reader.half_digit(&cell)? } else { 0.0 };
        let tolerance = rounding + 1e-9 * own;
        if (own - direct).abs() <= tolerance || (own - inside).abs() <= tolerance {
            return Err(total(blame, &cell));
        }
    }
    Ok(())
}

fn total(blame: &Blame<'_, '_, '_>, cell: &Cell<'_>) -> FormatError {
    let rule =
        "the mass of the part itself, but it is the sum of the rows inside it, which would be counted twice";
    let hint = "write a sum in the column subtotal; if the part itself has this mass, give it its own row inside this one";
    blame.reader.reader.invalid(cell, rule).with_hint(hint)
}
