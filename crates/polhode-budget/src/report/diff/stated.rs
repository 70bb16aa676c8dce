//! Statements of two parts lists outside their rows: groups, growth allowances, limits, sites,
//! tanks, questions and sequences.

use std::collections::HashMap;

use polhode_document::Section;
use polhode_document::layout::printable;
use polhode_document::number::{number, quaternion};
use serde_json::{Value, json};

use super::item::Item;
use super::words::point;
use super::{happening, limit, site, tank};
use crate::report::BudgetReport;
use crate::report::case::Case;
use crate::{ErrorKind, Group};

/// Statement that differs, in words; `None` if a list does not have it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Stated {
    what: String,
    values: [Option<String>; 2],
}

/// Digits with which numbers are shown, and with which they are compared. A change of units has a
/// smaller rounding error.
const DIGITS: [usize; 2] = [6, 12];

/// Returns the statements that differ and that hold for all configurations.
pub(crate) fn of_reports(reports: [&BudgetReport; 2]) -> Vec<Stated> {
    let mut all = compared(reports.map(|report| in_digits(|digits| of_report(report, digits))));
    let names = reports.map(|report| report.names().into_iter().flatten().collect::<Vec<_>>());
    let [mut before, mut after] = names.clone();
    before.sort();
    after.sort();
    if before == after && names[0] != names[1] {
        let values = names.map(|names| Some(names.join(", ")));
        all.push(Stated { what: "order of the configurations".to_owned(), values });
    }
    all
}

fn of_report(report: &BudgetReport, digits: usize) -> Vec<Item> {
    let stated = &report.stated;
    let mut all = of_lists(&report.cases, digits);
    let limits = report.limits.iter();
    all.extend(limits.map(|one| Item::new(format!("limit {}", one.name), limit::in_words(one, digits))));
    if let Some(ballast) = stated.ballast.as_ref().or(report.ballast.as_ref()) {
        let sites = ballast.sites.iter();
        all.extend(sites.map(|one| Item::new(format!("site {}", one.name), site::in_words(one, digits))));
        let most = ballast.most.map(|most| format!("{} kg", number(most, digits)));
        all.extend(most.map(|most| Item::new("ballast, most", most)));
        all.push(Item::new("ballast, deviations", number(ballast.deviations, digits)));
    }
    if let Some(prescribed) = &stated.prescribed {
        all.extend(tank::items(prescribed, digits));
        all.extend(prescribed.over_time.iter().flat_map(|one| happening::items(one, digits)));
    }
    let options = &report.options;
    all.extend(options.about.map(|at| Item::new("result, about", point(at.to_array(), digits))));
    all.extend(options.axes.map(|axes| {
        let wxyz = quaternion(axes.canonical_quaternion(), 0.0, digits);
        Item::new("result, axes", format!("quaternion ({wxyz})"))
    }));
    let draws = stated.draws.or(options.draws).unwrap_or(0);
    all.push(Item::new("result, draws", draws.to_string()));
    all.push(Item::new("result, seed", options.seed.to_string()));
    all.push(Item::new("result, basis", options.basis.name()));
    all
}

/// Returns the name of a configuration, if it differs.
pub(crate) fn of_cases(cases: [&Case; 2]) -> Vec<Stated> {
    let name = |case: &Case| case.name.iter().map(|name| Item::new("configuration", name)).collect();
    compared(cases.map(|case| in_digits(|_| name(case))))
}

/// Returns groups and growth allowances, which are the same in all configurations of a file.
fn of_lists(cases: &[Case], digits: usize) -> Vec<Item> {
    let percent = |x: f64| format!("{} %", number(100.0 * x, digits));
    let mut all: Vec<Item> = Vec::new();
    for budget in cases.iter().map(|case| &case.budget) {
        let groups = budget.groups().iter();
        let groups =
            groups.map(|group| Item::new(format!("group {}", group.name), group_in_words(group, digits)));
        let growth = budget.growth_table().codes();
        let growth = growth.map(|(code, growth)| Item::new(format!("growth {code}"), percent(growth)));
        let items: Vec<Item> = groups.chain(growth).filter(|item| !all.contains(item)).collect();
        all.extend(items);
    }
    all
}

/// Items with one name, each with its value in few and in many digits.
type Alike = Vec<[String; 2]>;

/// Groups items by their names, in their order.
fn in_digits(of: impl Fn(usize) -> Vec<Item>) -> Vec<([String; 2], Alike)> {
    let [short, long] = DIGITS.map(of);
    let mut all: Vec<([String; 2], Alike)> = Vec::new();
    let mut places = HashMap::new();
    for (Item { name, value }, long) in short.into_iter().zip(long) {
        let place = *places.entry(name.clone()).or_insert_with(|| {
            all.push((name, Vec::new()));
            all.len() - 1
        });
        all[place].1.push([value, long.value]);
    }
    all
}

/// Returns items that only one list has, or that differ. Among items with one name, equal ones are
/// matched first, in any order. The others are matched in their order.
fn compared([before, after]: [Vec<([String; 2], Alike)>; 2]) -> Vec<Stated> {
    let mut old: HashMap<_, _> = before.iter().map(|(name, all)| (name, all)).collect();
    let mut all = Vec::new();
    for (name, is) in &after {
        let was = old.remove(name).map_or(&[][..], Vec::as_slice);
        differences(name, [was, is], &mut all);
    }
    for (name, was) in before.iter().filter(|(name, _)| old.contains_key(name)) {
        differences(name, [was, &[]], &mut all);
    }
    all
}

fn differences([name, of]: &[String; 2], sides: [&[[String; 2]]; 2], all: &mut Vec<Stated>) {
    let is_one = sides.iter().all(|side| side.len() < 2);
    let [before, after] = unequal(sides);
    for n in 0..before.len().max(after.len()) {
        let places = [before.get(n).copied(), after.get(n).copied()];
        let number = places[1].or(places[0]).filter(|_| !is_one);
        let number = number.map_or_else(String::new, |k| format!(" {}", k + 1));
        let of_digits = |k: usize| [0, 1].map(|side| places[side].map(|place| &sides[side][place][k]));
        let [short, long] = [0, 1].map(of_digits);
        // If the values are equal in few digits, many are shown.
        let shown = if short[0] == short[1] { long } else { short };
        all.push(Stated {
            what: format!("{name}{number}{of}"),
            values: shown.map(Option::<&String>::cloned),
        });
    }
}

/// Returns the indices of values that have no equal on the other side.
fn unequal([before, after]: [&[[String; 2]]; 2]) -> [Vec<usize>; 2] {
    let mut old: HashMap<&str, Vec<usize>> = HashMap::new();
    // Indices are in descending order, so that the first is taken first.
    before.iter().enumerate().rev().for_each(|(k, [_, long])| old.entry(long).or_default().push(k));
    let is_new = |(k, [_, long]): (usize, &[String; 2])| {
        let equal = old.get_mut(long.as_str()).and_then(Vec::pop);
        equal.is_none().then_some(k)
    };
    let new = after.iter().enumerate().filter_map(is_new).collect();
    let mut rest: Vec<usize> = old.into_values().flatten().collect();
    rest.sort_unstable();
    [rest, new]
}

/// Returns words such as `mass 0.9, position 0.5`.
fn group_in_words(group: &Group, digits: usize) -> String {
    let all = ErrorKind::NAMED.into_iter().zip(group.correlations());
    let stated = all.filter(|(_, x)| *x != 0.0);
    let words: Vec<String> = stated.map(|((name, _), x)| format!("{name} {}", number(x, digits))).collect();
    if words.is_empty() { "no correlation".to_owned() } else { words.join(", ") }
}

/// Returns the differences as a section.
pub(crate) fn section(all: &[Stated], title: &str) -> Section {
    let mut section = Section::new(0, title);
    let row = |one: &Stated| {
        let [before, after] =
            one.values.clone().map(|value| value.as_deref().map_or_else(|| "none".to_owned(), printable));
        vec![printable(&one.what), before, after]
    };
    section.table(&["what", "before", "after"], all.iter().map(row).collect());
    section
}

/// Returns words such as `changed besides the rows: group wings, limit mass`.
pub(crate) fn in_words(all: &[Stated]) -> String {
    let names: Vec<String> = all.iter().map(|one| printable(&one.what)).collect();
    format!("other changes: {}", names.join(", "))
}

pub(crate) fn to_json(all: &[Stated]) -> Value {
    let one = |one: &Stated| json!({ "what": one.what, "before": one.values[0], "after": one.values[1] });
    all.iter().map(one).collect()
}
