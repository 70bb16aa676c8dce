//! What changed from one budget to another.

use std::collections::HashMap;

use polhode::body::MassProperties;
use polhode::math::Part;
use polhode_budget::{Basis, Estimate, NUMBERS, Row};
use serde_json::{Value, json};

use super::case::{Case, ten};
use super::principal;
use super::stated::{self, Stated};
use super::{BudgetReport, basis_name};
use crate::VERSION;
use crate::explain::document::{Document, Section};
use crate::layout::printable;
use crate::number::{count, number, tidy, with_error};

/// What changed from one budget to another, row by row and in the whole.
#[derive(Clone, Debug)]
pub struct BudgetDiff<'a> {
    titles: [&'a str; 2],
    basis: Basis,
    pairs: Vec<Pair<'a>>,
    /// Configurations that only the first has, and only the second.
    alone: [Vec<&'a str>; 2],
    /// Besides the configurations.
    stated: Vec<Stated>,
}

/// A configuration of both.
#[derive(Clone, Debug)]
struct Pair<'a> {
    cases: [&'a Case; 2],
    changes: Vec<Change>,
    /// Besides the rows.
    stated: Vec<Stated>,
}

/// What became of a row.
#[derive(Clone, Debug, PartialEq)]
struct Change {
    row: String,
    what: What,
}

/// One thing that became of it.
#[derive(Clone, Debug, PartialEq)]
enum What {
    /// All copies of its own part, kg: what stands in it has a row of its own.
    Added(f64),
    Removed(f64),
    /// One copy of its own part, kg.
    Mass([f64; 2]),
    Quantity([u32; 2]),
    /// Its frame, or its centre of mass in it, m.
    Moved(f64),
    /// rad
    Turned(f64),
    /// The tensor about its centre, as a part of its greatest element.
    Tensor(f64),
    /// Fractions.
    Growth([f64; 2]),
    Allowable([Option<f64>; 2]),
    /// The row in which it stands.
    Parent([Option<String>; 2]),
    Uncertainty,
}

/// Rounding of numbers in other units.
const ROUNDING: f64 = 1e-12;
/// Changes that are shown; all are in JSON.
const SHOWN: usize = 100;

impl<'a> BudgetDiff<'a> {
    /// From `before` to `after`: configurations of the same name, or those of lists that have only one.
    pub fn new(before: &'a BudgetReport, after: &'a BudgetReport) -> Self {
        let mut pairs = Vec::new();
        let mut alone = [Vec::new(), Vec::new()];
        let only = before.cases.len() == 1 && after.cases.len() == 1;
        for case in &after.cases {
            let same = before.cases.iter().find(|other| only || other.name == case.name);
            match same {
                Some(other) => {
                    let cases = [other, case];
                    pairs.push(Pair { cases, changes: changes(cases), stated: stated::of_cases(cases) });
                }
                None => alone[1].extend(case.name.as_deref()),
            }
        }
        let is_alone = |case: &&Case| !only && after.cases.iter().all(|other| other.name != case.name);
        alone[0].extend(before.cases.iter().filter(is_alone).filter_map(|case| case.name.as_deref()));
        let stated = stated::of_reports([before, after]);
        Self { titles: [&before.title, &after.title], basis: after.options.basis, pairs, alone, stated }
    }

    /// True if nothing differs.
    pub fn is_empty(&self) -> bool {
        let is_same = |pair: &Pair<'_>| pair.changes.is_empty() && pair.stated.is_empty();
        self.stated.is_empty() && self.alone.iter().all(Vec::is_empty) && self.pairs.iter().all(is_same)
    }

    /// As a document: text, Markdown, a page.
    pub fn to_document(&self) -> Document {
        let [before, after] = self.titles.map(printable);
        let title = if before == after {
            format!("{after}: what changed")
        } else {
            format!("From {before} to {after}")
        };
        let mut answer = Vec::new();
        for (words, names) in ["Only before", "Only after"].iter().zip(&self.alone) {
            answer.extend(names.iter().map(|name| format!("{words}: the configuration {}", printable(name))));
        }
        let mut sections = Vec::new();
        for pair in &self.pairs {
            let name = pair.cases[1].name.as_deref().filter(|_| self.pairs.len() > 1);
            let of = |words: &str| match name {
                Some(name) => format!("{}: {words}", printable(name)),
                None => words.to_owned(),
            };
            answer.push(of(&self.in_words(pair)));
            let mut rows = Section::new(0, &of("part by part"));
            pair.table(&mut rows);
            let mut whole = Section::new(0, &of("the whole"));
            self.whole(pair, &mut whole);
            sections.extend([rows, whole]);
            if !pair.stated.is_empty() {
                answer.push(of(&stated::in_words(&pair.stated)));
                sections.push(stated::section(&pair.stated, &of("besides the rows")));
            }
        }
        if !self.stated.is_empty() {
            answer.push(stated::in_words(&self.stated));
            sections.push(stated::section(&self.stated, "limits, sites and questions"));
        }
        for (k, section) in sections.iter_mut().enumerate() {
            section.number = u8::try_from(k + 1).unwrap_or(u8::MAX);
            let mut letters = section.title.chars();
            if let (None, Some(first)) = (section.title.find(':'), letters.next()) {
                section.title = first.to_uppercase().chain(letters).collect();
            }
        }
        Document { title, answer, sections, findings: Vec::new() }
    }

    /// `3 changes of 2 rows; predicted mass 4.31 kg to 4.52 kg, by +0.21 kg`
    fn in_words(&self, pair: &Pair<'_>) -> String {
        let mut rows: Vec<&str> = pair.changes.iter().map(|change| change.row.as_str()).collect();
        rows.dedup();
        let [before, after] = pair.cases.map(|case| case.estimate(self.basis).properties.mass());
        let mass = if before == after {
            "the mass is the same".to_owned()
        } else {
            format!("{} mass {}", basis_name(self.basis), from_to(before, after, "kg"))
        };
        match (pair.changes.len(), rows.len()) {
            (0, _) => format!("no row changed; {mass}"),
            (n, k) => format!("{}; {mass}", of_rows(n, k)),
        }
    }

    fn whole(&self, pair: &Pair<'_>, section: &mut Section) {
        let [before, after] = pair.cases.map(|case| case.estimate(self.basis));
        let values = [before, after].map(|estimate| ten(&estimate.properties));
        let centers = values.map(|all| tidy([all[1], all[2], all[3]]));
        let mut rows: Vec<Vec<String>> = (0..10)
            .map(|k| {
                let (name, unit) = NUMBERS[k];
                let (unit, scale) = if unit == "m" { ("mm", 1e3) } else { (unit, 1.0) };
                let of = |side: usize| {
                    let value = if (1..4).contains(&k) { centers[side][k - 1] } else { values[side][k] };
                    scale * value
                };
                let sd = [before, after].map(|estimate| scale * estimate.sd(k));
                let change = of(1) - of(0);
                let cells = [0, 1].map(|side| with_error(of(side), sd[side]));
                let [was, is] = cells;
                vec![name.to_owned(), was, is, signed(change), unit.to_owned()]
            })
            .collect();
        let moments = [before, after].map(Estimate::principal);
        for k in 0..3 {
            let of = |side: usize| moments[side].frame.moments()[k];
            let cells = [0, 1].map(|side| principal::moment(pair.cases[side], &moments[side], k));
            let [was, is] = cells;
            rows.push(vec![format!("i{}", k + 1), was, is, signed(of(1) - of(0)), "kg·m²".to_owned()]);
        }
        section.table(&["number", "before", "after", "change", "unit"], rows);
        let margin = |case: &Case| {
            case.whole_statement()
                .margin()
                .map_or_else(|| "none".to_owned(), |x| format!("{} kg", number(x, 4)))
        };
        if pair.cases.iter().any(|case| case.whole_statement().allowable.is_some()) {
            let [was, is] = pair.cases.map(margin);
            section.line(format!("margin before {was}, after {is}"));
        }
    }

    /// As data.
    pub fn to_json(&self) -> Value {
        let change = |change: &Change| {
            let (what, before, after, by) = change.what.to_json();
            json!({ "row": change.row, "what": what, "before": before, "after": after, "by": by })
        };
        let pair = |pair: &Pair<'_>| {
            let whole = pair.cases.map(|case| {
                let estimate = case.estimate(self.basis);
                let values = ten(&estimate.properties);
                let sd: Vec<f64> = (0..10).map(|k| estimate.sd(k)).collect();
                json!({ "values": values, "sd": sd, "margin": case.whole_statement().margin() })
            });
            let [before, after] = whole;
            json!({
                "name": pair.cases[1].name,
                "changes": pair.changes.iter().map(change).collect::<Value>(),
                "stated": stated::to_json(&pair.stated),
                "numbers": NUMBERS.map(|(name, _)| name),
                "before": before,
                "after": after,
            })
        };
        json!({
            "polhode": VERSION,
            "kind": "budget diff",
            "titles": self.titles,
            "basis": basis_name(self.basis),
            "only_before": self.alone[0],
            "only_after": self.alone[1],
            "stated": stated::to_json(&self.stated),
            "configurations": self.pairs.iter().map(pair).collect::<Value>(),
        })
    }
}

impl Pair<'_> {
    fn table(&self, section: &mut Section) {
        if self.changes.is_empty() {
            section.say("No row changed.");
            return;
        }
        let row = |change: &Change| vec![printable(&change.row), change.what.words()];
        section.table(&["part", "what became of it"], self.changes.iter().take(SHOWN).map(row).collect());
        if self.changes.len() > SHOWN {
            section
                .say(format!("{} more changes are in --json.", count((self.changes.len() - SHOWN) as u64)));
        }
    }
}

fn of_rows(changes: usize, rows: usize) -> String {
    let plural =
        |n: usize, word: &str| format!("{} {word}{}", count(n as u64), if n == 1 { "" } else { "s" });
    format!("{} of {}", plural(changes, "change"), plural(rows, "row"))
}

fn from_to(before: f64, after: f64, unit: &str) -> String {
    format!("{} to {} {unit}, by {} {unit}", number(before, 6), number(after, 6), signed(after - before))
}

fn signed(x: f64) -> String {
    let shown = number(x, 3);
    if x > 0.0 { format!("+{shown}") } else { shown }
}

impl What {
    fn words(&self) -> String {
        let known = |x: &Option<f64>| x.map_or_else(|| "none".to_owned(), |x| format!("{} kg", number(x, 6)));
        match self {
            Self::Added(0.0) => "added, a frame".to_owned(),
            Self::Removed(0.0) => "removed, a frame".to_owned(),
            Self::Added(mass) => format!("added, with {} kg", number(*mass, 6)),
            Self::Removed(mass) => format!("removed, with {} kg", number(*mass, 6)),
            Self::Mass([before, after]) => {
                let word = if after > before { "heavier" } else { "lighter" };
                format!("{word}: {}", from_to(*before, *after, "kg"))
            }
            Self::Quantity([before, after]) => format!("{before} to {after} of it"),
            Self::Moved(by) => format!("moved by {} mm", number(1e3 * by, 4)),
            Self::Turned(by) => format!("turned by {} deg", number(by.to_degrees(), 4)),
            Self::Tensor(part) => {
                format!("its inertia tensor changed by up to {} % of itself", number(100.0 * part, 3))
            }
            Self::Growth([before, after]) => {
                format!("growth allowance {} % to {} %", number(100.0 * before, 4), number(100.0 * after, 4))
            }
            Self::Allowable([before, after]) => {
                format!("allowable mass {} to {}", known(before), known(after))
            }
            Self::Parent([before, after]) => {
                let named =
                    |name: &Option<String>| name.as_deref().map_or_else(|| "nothing".to_owned(), printable);
                format!("stood in {}, stands in {}", named(before), named(after))
            }
            Self::Uncertainty => "its uncertainty changed".to_owned(),
        }
    }

    /// What it is, before, after, by how much.
    fn to_json(&self) -> (&'static str, Value, Value, Value) {
        let pair = |what, [before, after]: [Value; 2]| (what, before, after, Value::Null);
        let by = |what, by: f64| (what, Value::Null, Value::Null, Value::from(by));
        match self {
            Self::Added(mass) => pair("added", [Value::Null, Value::from(*mass)]),
            Self::Removed(mass) => pair("removed", [Value::from(*mass), Value::Null]),
            Self::Mass(both) => pair("mass", both.map(Value::from)),
            Self::Quantity(both) => pair("quantity", both.map(Value::from)),
            Self::Moved(distance) => by("moved", *distance),
            Self::Turned(angle) => by("turned", *angle),
            Self::Tensor(part) => by("tensor", *part),
            Self::Growth(both) => pair("growth", both.map(Value::from)),
            Self::Allowable(both) => pair("allowable", both.map(Value::from)),
            Self::Parent(both) => pair("parent", both.clone().map(Value::from)),
            Self::Uncertainty => pair("uncertainty", [Value::Null, Value::Null]),
        }
    }
}

/// In the order of the rows of the second, then what is no more.
fn changes([before, after]: [&Case; 2]) -> Vec<Change> {
    let (old, new) = (&before.budget.list().rows, &after.budget.list().rows);
    let named = |rows: &[Row]| -> HashMap<String, usize> {
        rows.iter().enumerate().map(|(k, row)| (row.name.clone(), k)).collect()
    };
    let (old_names, new_names) = (named(old), named(new));
    let mut all = Vec::new();
    for (k, row) in new.iter().enumerate() {
        let mut add = |what| all.push(Change { row: row.name.clone(), what });
        match old_names.get(&row.name) {
            None => add(What::Added(own(after, k))),
            Some(&other) => differences([before, after], [other, k]).into_iter().for_each(add),
        }
    }
    for (k, row) in old.iter().enumerate().filter(|(_, row)| !new_names.contains_key(&row.name)) {
        all.push(Change { row: row.name.clone(), what: What::Removed(own(before, k)) });
    }
    all
}

/// The mass of all copies of a row's own part.
fn own(case: &Case, row: usize) -> f64 {
    let copies = f64::from(case.budget.list().rows[row].quantity.count);
    case.budget.given(row).map_or(0.0, |part| copies * part.mass())
}

fn differences(cases: [&Case; 2], rows: [usize; 2]) -> Vec<What> {
    let [before, after] = [0, 1].map(|side| &cases[side].budget.list().rows[rows[side]]);
    let mut all = Vec::new();
    let parents = [0, 1].map(|side| {
        let parent = cases[side].budget.parents()[rows[side]];
        parent.map(|parent| cases[side].budget.list().rows[parent].name.clone())
    });
    if parents[0] != parents[1] {
        all.push(What::Parent(parents));
    }
    let counts = [before.quantity.count, after.quantity.count];
    if counts[0] != counts[1] {
        all.push(What::Quantity(counts));
    }
    let parts = [0, 1].map(|side| cases[side].budget.given(rows[side]));
    let mut distance = (after.place.position - before.place.position).norm();
    let size = after.place.position.max_abs().max(before.place.position.max_abs());
    let mut is_moved = distance > ROUNDING * size;
    match parts {
        [Some(was), Some(is)] => {
            if !near(was.mass(), is.mass()) {
                all.push(What::Mass([was.mass(), is.mass()]));
            }
            let by = (is.center_of_mass() - was.center_of_mass()).norm();
            let size = is.center_of_mass().max_abs().max(was.center_of_mass().max_abs());
            if by > ROUNDING * size {
                // Both together, along the axes of the frame in which it stands.
                let [was, is] = [(before, was), (after, is)]
                    .map(|(row, part)| row.place.position + row.place.rotation * part.center_of_mass());
                (is_moved, distance) = (true, (is - was).norm());
            }
            // What is only heavier has the tensor that goes with it.
            let part = tensor_change(was, is);
            if part > ROUNDING.max(1e-9) {
                all.push(What::Tensor(part));
            }
        }
        [None, Some(is)] => all.push(What::Mass([0.0, is.mass()])),
        [Some(was), None] => all.push(What::Mass([was.mass(), 0.0])),
        [None, None] => {}
    }
    if is_moved {
        all.push(What::Moved(distance));
    }
    let angle = (after.place.rotation * before.place.rotation.inverse()).angle();
    if angle > 1e-9 {
        all.push(What::Turned(angle));
    }
    let growths = [0, 1].map(|side| cases[side].budget.growth(rows[side]));
    if !near(growths[0], growths[1]) {
        all.push(What::Growth(growths));
    }
    if before.allowable != after.allowable {
        all.push(What::Allowable([before.allowable, after.allowable]));
    }
    if before.uncertainty != after.uncertainty
        || before.group != after.group
        || before.quantity.errors != after.quantity.errors
    {
        all.push(What::Uncertainty);
    }
    all
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= ROUNDING * a.abs().max(b.abs())
}

/// By how much the tensor of a mass of 1 kg changed, over its greatest element.
fn tensor_change(was: &MassProperties<Part>, is: &MassProperties<Part>) -> f64 {
    let each = |body: &MassProperties<Part>| {
        let mass = body.mass();
        body.inertia().matrix().map(|row| row.map(|x| x / mass))
    };
    let (was, is) = (each(was), each(is));
    let greatest = was.iter().chain(&is).flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    let by =
        was.iter().flatten().zip(is.iter().flatten()).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    if greatest > 0.0 { by / greatest } else { 0.0 }
}
