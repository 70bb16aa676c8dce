//! What two parts lists state besides their rows: groups, growth allowances, limits, sites and questions.

use polhode::math::{Body, Position};
use polhode_budget::{Ballast, Group, Limit, Site};
use serde_json::{Value, json};

use super::case::Case;
use super::limits::{allowed, shown_unit};
use super::{BudgetReport, basis_name};
use crate::explain::document::Section;
use crate::layout::printable;
use crate::number::number;

/// Something that is stated differently, in words; `None` where it is not stated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Stated {
    what: String,
    values: [Option<String>; 2],
}

/// What is stated differently of all configurations.
pub(super) fn of_reports([before, after]: [&BudgetReport; 2]) -> Vec<Stated> {
    let both = [before, after];
    let mut all = named("limit", both.map(|one| &one.limits[..]), |limit| &limit.name, limit_in_words);
    let sites = both.map(|one| one.ballast.as_ref().map_or(&[][..], |ballast| &ballast.sites));
    all.extend(named("site", sites, |site| &site.name, |site: &Site| format!("{:?}", site.place)));
    let most = |ballast: &Ballast| ballast.most.map(|most| format!("{} kg", number(most, 6)));
    let deviations = |ballast: &Ballast| Some(number(ballast.deviations, 6));
    let point = |at: Position<Body>| {
        let [x, y, z] = at.to_array().map(|x| number(x, 6));
        format!("({x}, {y}, {z}) m")
    };
    let mut add = |what: &str, values: [Option<String>; 2]| {
        if values[0] != values[1] {
            all.push(Stated { what: what.to_owned(), values });
        }
    };
    add("most ballast", both.map(|one| one.ballast.as_ref().and_then(most)));
    add("standard deviations inside the limits", both.map(|one| one.ballast.as_ref().and_then(deviations)));
    add("point that the tensor is wanted about", both.map(|one| one.options.about.map(point)));
    let quaternion = |one: &BudgetReport| {
        let [w, x, y, z] = one.options.along?.canonical_quaternion().map(|x| number(x, 6));
        Some(format!("({w}, {x}, {y}, {z})"))
    };
    add("axes that it is wanted along", both.map(quaternion));
    add("masses that count", both.map(|one| Some(basis_name(one.options.basis).to_owned())));
    all
}

/// What is stated differently of a configuration.
pub(super) fn of_cases(cases: [&Case; 2]) -> Vec<Stated> {
    let lists = cases.map(|case| case.budget.list());
    let groups = lists.map(|list| &list.groups[..]);
    let mut all = named("group", groups, |group| &group.name, group_in_words);
    if lists[0].growth != lists[1].growth {
        all.push(Stated { what: "table of growth allowances".to_owned(), values: [None, None] });
    }
    all
}

/// Items that only one has, or that differ.
fn named<T: PartialEq>(
    what: &str,
    [before, after]: [&[T]; 2],
    name: impl Fn(&T) -> &String,
    words: impl Fn(&T) -> String,
) -> Vec<Stated> {
    let find = |all: &'_ [T], wanted: &T| all.iter().position(|one| name(one) == name(wanted));
    let stated = |item: &T, values| Stated { what: format!("{what} {}", name(item)), values };
    let mut all = Vec::new();
    for item in after {
        match find(before, item) {
            None => all.push(stated(item, [None, Some(words(item))])),
            Some(k) if before[k] != *item => {
                all.push(stated(item, [Some(words(&before[k])), Some(words(item))]));
            }
            Some(_) => {}
        }
    }
    let gone = before.iter().filter(|item| find(after, item).is_none());
    all.extend(gone.map(|item| stated(item, [Some(words(item)), None])));
    all
}

/// `≤ 3 kg, of predicted masses`
fn limit_in_words(limit: &Limit) -> String {
    let (unit, scale) = shown_unit(limit.of.unit());
    format!("{} {unit}, of {} masses", allowed(limit, scale), basis_name(limit.basis))
}

/// `mass 0.9, position 0.5`
fn group_in_words(group: &Group) -> String {
    let all = [
        ("mass", group.mass),
        ("centre", group.center),
        ("tensor", group.tensor),
        ("position", group.position),
        ("rotation", group.rotation),
    ];
    let stated = all.iter().filter(|(_, x)| *x != 0.0);
    let words: Vec<String> = stated.map(|(name, x)| format!("{name} {}", number(*x, 6))).collect();
    if words.is_empty() { "no correlation".to_owned() } else { words.join(", ") }
}

/// What differs, as a section.
pub(super) fn section(all: &[Stated], title: &str) -> Section {
    let mut section = Section::new(0, title);
    let row = |one: &Stated| {
        let [before, after] = match &one.values {
            [None, None] => ["differs".to_owned(), "differs".to_owned()],
            values => {
                values.clone().map(|value| value.as_deref().map_or_else(|| "none".to_owned(), printable))
            }
        };
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
