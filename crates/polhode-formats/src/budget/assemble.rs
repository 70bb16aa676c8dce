//! Rows as budgets: one of each configuration.

use std::collections::{HashMap, HashSet};

use polhode_budget::{Budget, BudgetError, PartsList, Row, TensorPoint};

use super::NamedBudget;
use super::blame::Blame;
use super::key::{AT_X, AT_Y, AT_Z, IXX, IYY, IZZ, MASS, X, Y, Z};
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
        let used = used(&budget, &origins, plan);
        without_effect(&origins, &used, reader)?;
        return Ok(vec![NamedBudget { name: None, budget }]);
    }
    let mut budgets = Vec::new();
    let mut all_used = HashSet::new();
    for name in names {
        let inside =
            rows.iter().filter(|row| row.configurations.is_empty() || row.configurations.contains(&name));
        let (rows, origins): (Vec<_>, Vec<_>) = inside.map(|row| (row.row.clone(), row.origin)).unzip();
        let budget = one(rows, &origins, plan, reader, Some(&name), lines)?;
        all_used.extend(used(&budget, &origins, plan));
        budgets.push(NamedBudget { name: Some(name), budget });
    }
    let origins: Vec<usize> = rows.iter().map(|row| row.origin).collect();
    without_effect(&origins, &all_used, reader)?;
    Ok(budgets)
}

/// Rows with a part, and frames in which something stands or of which the origin counts; by their places in the table.
fn used(budget: &Budget, origins: &[usize], plan: &Plan) -> HashSet<usize> {
    let rows = &budget.list().rows;
    let mut frames: HashSet<&str> = plan.tanks.iter().filter_map(|tank| tank.frame.as_deref()).collect();
    frames.extend(rows.iter().filter_map(|row| match &row.part.as_ref()?.tensor.about {
        TensorPoint::OriginOf(frame) => Some(frame.as_str()),
        _ => None,
    }));
    let parents: HashSet<usize> = budget.parents().iter().copied().flatten().collect();
    let is_used = |k: usize, row: &Row| {
        row.part.is_some() || parents.contains(&k) || frames.contains(row.name.as_str())
    };
    let all = rows.iter().zip(origins).enumerate();
    all.filter(|(k, (row, _))| is_used(*k, row)).map(|(_, (_, origin))| *origin).collect()
}

/// Refuses a row without mass in which nothing stands.
fn without_effect(
    origins: &[usize],
    used: &HashSet<usize>,
    reader: &Rows<'_, '_>,
) -> Result<(), FormatError> {
    let reader = &reader.reader;
    let Some(origin) = origins.iter().find(|origin| !used.contains(origin)) else { return Ok(()) };
    let Some(cell) = reader.sheet.rows.get(*origin).and_then(|row| reader.sheet.row(row).first()) else {
        return Ok(());
    };
    let error = reader.invalid(cell, "a row with mass, or one in which others stand");
    Err(error.with_hint("a frame in which nothing stands has no effect: give it a mass, or leave it out"))
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
    budget.mass_properties(plan.questions.basis).map_err(|error| too_large(error, &budget, &blame))?;
    Ok(budget)
}

/// The error of a sum that overflows, at the largest number that the list has.
fn too_large(error: BudgetError, budget: &Budget, blame: &Blame<'_, '_, '_>) -> FormatError {
    let numbers = |row: &Row| {
        let part = row.part.as_ref();
        let mass = part.map_or(0.0, |part| part.mass);
        let [x, y, z] = part.map_or([0.0; 3], |part| part.center_of_mass.to_array());
        let [xx, yy, zz] = part.map_or([0.0; 3], |part| part.tensor.moments);
        let [at_x, at_y, at_z] = row.place.position.to_array();
        [mass, x, y, z, xx, yy, zz, at_x, at_y, at_z].map(f64::abs)
    };
    let keys = [MASS, X, Y, Z, IXX, IYY, IZZ, AT_X, AT_Y, AT_Z];
    let rows = budget.list().rows.iter().enumerate();
    let all = rows
        .flat_map(|(k, row)| numbers(row).into_iter().zip(keys).map(move |(number, key)| (number, k, key)));
    let cell = all.max_by(|a, b| a.0.total_cmp(&b.0)).and_then(|(_, k, key)| blame.cell(k, &[key]));
    match (cell, error.hint()) {
        (Some(cell), Some(hint)) => {
            blame.reader.reader.sheet.error(cell, FormatErrorKind::Budget(error)).with_hint(hint)
        }
        _ => blame.of(error),
    }
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
    // Of rows with a mass of their own in which others stand: the masses of these, and how many.
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
    let mut found: Vec<(usize, (f64, usize))> = direct.into_iter().collect();
    if found.is_empty() {
        return Ok(());
    }
    found.sort_by_key(|(row, _)| *row);
    let statements = budget.mass_statements().map_err(|error| blame.of(error))?;
    for (k, (direct, count)) in found {
        let (Some(row), Some(statement)) = (rows.get(k), statements.get(k)) else { continue };
        let Some(own) = row.part.as_ref().map(|part| part.mass) else { continue };
        let Some(cell) = blame.cell(k, &[MASS]) else { continue };
        let inside = statement.basic / f64::from(row.quantity.count) - own;
        // A sum may be rounded; the mass of one row is copied as it is.
        let rounding = if count > 1 { blame.reader.reader.half_digit(cell)? } else { 0.0 };
        let tolerance = rounding + 1e-9 * own;
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
