//! What two parts lists state besides their rows: groups, growth allowances, limits, sites, tanks, questions, and what is to happen.

use polhode_budget::Group;
use serde_json::{Value, json};

use super::words::point;
use super::{happening, limit, site, tank};
use crate::budget::case::Case;
use crate::budget::{BudgetReport, basis_name};
use crate::explain::document::Section;
use crate::layout::printable;
use crate::number::{count, number};

/// Something that is stated differently, in words; `None` where it is not stated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Stated {
    what: String,
    values: [Option<String>; 2],
}

/// What something is called, and what is stated of it.
type Item = (String, String);

/// With so many digits numbers are shown, and with so many they are compared: rounding of other units is less.
const DIGITS: [usize; 2] = [6, 12];

/// What is stated differently of all configurations.
pub(super) fn of_reports(reports: [&BudgetReport; 2]) -> Vec<Stated> {
    let mut all = compared(reports.map(|report| DIGITS.map(|digits| of_report(report, digits))));
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
    let mut all: Vec<Item> = Vec::new();
    let limits = report.limits.iter();
    all.extend(limits.map(|one| (format!("limit {}", one.name), limit::in_words(one, digits))));
    if let Some(ballast) = stated.ballast.as_ref().or(report.ballast.as_ref()) {
        let sites = ballast.sites.iter();
        all.extend(sites.map(|one| (format!("site {}", one.name), site::in_words(one, digits))));
        let most = ballast.most.map(|most| format!("{} kg", number(most, digits)));
        all.extend(most.map(|most| ("ballast, most".to_owned(), most)));
        all.push(("ballast, deviations".to_owned(), number(ballast.deviations, digits)));
        let effort = ballast.effort.map(|effort| count(effort as u64));
        all.extend(effort.map(|effort| ("ballast, effort".to_owned(), effort)));
    }
    all.extend(stated.tanks.iter().flat_map(|one| tank::items(one, digits)));
    all.extend(stated.sequence.iter().flat_map(|one| happening::items(one, digits)));
    let options = &report.options;
    all.extend(options.about.map(|at| ("result, about".to_owned(), point(at.to_array(), digits))));
    all.extend(options.along.map(|axes| {
        let [w, x, y, z] = axes.canonical_quaternion().map(|x| number(x, digits));
        ("result, axes".to_owned(), format!("quaternion ({w}, {x}, {y}, {z})"))
    }));
    let draws = stated.draws.unwrap_or(options.draws);
    all.push(("result, draws".to_owned(), draws.to_string()));
    all.push(("result, seed".to_owned(), options.seed.to_string()));
    all.push(("result, basis".to_owned(), basis_name(options.basis).to_owned()));
    all
}

/// What is stated differently of a configuration.
pub(super) fn of_cases(cases: [&Case; 2]) -> Vec<Stated> {
    compared(cases.map(|case| DIGITS.map(|digits| of_case(case, digits))))
}

fn of_case(case: &Case, digits: usize) -> Vec<Item> {
    let list = case.budget.list();
    let mut all: Vec<Item> =
        case.name.iter().map(|name| ("configuration".to_owned(), name.clone())).collect();
    let groups = list.groups.iter();
    all.extend(groups.map(|group| (format!("group {}", group.name), group_in_words(group, digits))));
    let percent = |x: f64| format!("{} %", number(100.0 * x, digits));
    all.extend(list.growth.codes().map(|(code, growth)| (format!("growth {code}"), percent(growth))));
    all
}

/// Items that only one has, or that differ; each in words with few digits and with many.
fn compared([before, after]: [[Vec<Item>; 2]; 2]) -> Vec<Stated> {
    let find = |all: &[Item], wanted: &str| all.iter().position(|(what, _)| what == wanted);
    let mut all = Vec::new();
    for (k, (what, value)) in after[0].iter().enumerate() {
        let was = find(&before[0], what);
        let long = |side: &[Vec<Item>; 2], k: usize| side[1].get(k).map(|(_, value)| value.clone());
        let values = match was {
            None => [None, Some(value.clone())],
            Some(j) => {
                let short = [before[0].get(j).map(|(_, value)| value.clone()), Some(value.clone())];
                let long = [long(&before, j), long(&after, k)];
                if long[0] == long[1] {
                    continue;
                }
                // Digits by which they differ are shown.
                if short[0] == short[1] { long } else { short }
            }
        };
        all.push(Stated { what: what.clone(), values });
    }
    let gone = before[0].iter().filter(|(what, _)| find(&after[0], what).is_none());
    all.extend(gone.map(|(what, value)| Stated { what: what.clone(), values: [Some(value.clone()), None] }));
    all
}

/// `mass 0.9, position 0.5`
fn group_in_words(group: &Group, digits: usize) -> String {
    let all = [
        ("mass", group.mass),
        ("center", group.center),
        ("tensor", group.tensor),
        ("position", group.position),
        ("rotation", group.rotation),
        ("density", group.density),
    ];
    let stated = all.iter().filter(|(_, x)| *x != 0.0);
    let words: Vec<String> = stated.map(|(name, x)| format!("{name} {}", number(*x, digits))).collect();
    if words.is_empty() { "no correlation".to_owned() } else { words.join(", ") }
}

/// What differs, as a section.
pub(super) fn section(all: &[Stated], title: &str) -> Section {
    let mut section = Section::new(0, title);
    let row = |one: &Stated| {
        let [before, after] =
            one.values.clone().map(|value| value.as_deref().map_or_else(|| "none".to_owned(), printable));
        vec![printable(&one.what), before, after]
    };
    section.table(&["what", "before", "after"], all.iter().map(row).collect());
    section
}

/// `changed besides the rows: group wings, limit mass`
pub(super) fn in_words(all: &[Stated]) -> String {
    let names: Vec<String> = all.iter().map(|one| printable(&one.what)).collect();
    format!("changed besides the rows: {}", names.join(", "))
}

pub(super) fn to_json(all: &[Stated]) -> Value {
    let one = |one: &Stated| json!({ "what": one.what, "before": one.values[0], "after": one.values[1] });
    all.iter().map(one).collect()
}
