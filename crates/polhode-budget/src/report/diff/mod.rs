//! Differences between two budgets.

mod change;
mod errors;
mod happening;
mod item;
mod limit;
mod rows;
mod site;
mod stated;
mod tank;
mod words;

use polhode_document::VERSION;
use polhode_document::layout::printable;
use polhode_document::number::{count, counted, number, with_error};
use polhode_document::{Document, Section};
use serde_json::{Value, json};

use super::BudgetReport;
use super::case::Case;
use super::numbers::{shown, ten, tidied};
use super::principal;
use crate::{Basis, Estimate, NUMBERS};
use change::{Change, from_to, signed};
use stated::Stated;

/// Differences between two budgets, row by row and in the whole.
#[derive(Clone, Debug)]
pub struct BudgetDiff<'a> {
    titles: [&'a str; 2],
    basis: Basis,
    pairs: Vec<Pair<'a>>,
    /// Configurations that only the first budget has, and that only the second has.
    alone: [Vec<&'a str>; 2],
    /// Different statements outside the configurations.
    stated: Vec<Stated>,
}

/// Configuration that both budgets have.
#[derive(Clone, Debug)]
struct Pair<'a> {
    cases: [&'a Case; 2],
    changes: Vec<Change>,
    /// Different statements outside the rows.
    stated: Vec<Stated>,
}

/// Largest number of changes that are shown. JSON has all.
const SHOWN: usize = 100;

impl<'a> BudgetDiff<'a> {
    /// Compares two reports. Configurations with the same name are compared, or those of lists that
    /// have only one. A list without configurations is compared with each.
    pub fn new(before: &'a BudgetReport, after: &'a BudgetReport) -> Self {
        let only = before.cases.len() == 1 && after.cases.len() == 1;
        let is_pair = |a: &Case, b: &Case| only || a.name == b.name || a.name.is_none() || b.name.is_none();
        let mut pairs = Vec::new();
        for case in &after.cases {
            for cases in before.cases.iter().filter(|other| is_pair(other, case)).map(|other| [other, case]) {
                pairs.push(Pair { cases, changes: rows::changes(cases), stated: stated::of_cases(cases) });
            }
        }
        let alone = |all: &'a [Case], others: &[Case]| {
            let is_alone = |case: &&Case| !others.iter().any(|other| is_pair(case, other));
            all.iter().filter(is_alone).filter_map(|case| case.name.as_deref()).collect()
        };
        let alone = [alone(&before.cases, &after.cases), alone(&after.cases, &before.cases)];
        let stated = stated::of_reports([before, after]);
        Self { titles: [&before.title, &after.title], basis: after.options.basis, pairs, alone, stated }
    }

    /// Returns true if nothing differs.
    pub fn is_empty(&self) -> bool {
        let is_same = |pair: &Pair<'_>| pair.changes.is_empty() && pair.stated.is_empty();
        self.stated.is_empty() && self.alone.iter().all(Vec::is_empty) && self.pairs.iter().all(is_same)
    }

    /// Returns the differences as a document: text, Markdown or HTML.
    pub fn to_document(&self) -> Document {
        let [before, after] = self.titles.map(printable);
        let title = if before == after {
            format!("{after}: what changed")
        } else {
            format!("From {before} to {after}")
        };
        let mut answer = Vec::new();
        for (words, names) in ["Only before", "Only after"].iter().zip(&self.alone) {
            answer.extend(names.iter().map(|name| format!("{words}: configuration {}", printable(name))));
        }
        let mut sections = Vec::new();
        for pair in &self.pairs {
            let name = pair.name().filter(|_| self.pairs.len() > 1);
            let of = |words: &str| match name {
                Some(name) => format!("{}: {words}", printable(name)),
                None => words.to_owned(),
            };
            answer.push(of(&self.in_words(pair)));
            let mut rows = Section::new(0, &of("parts"));
            pair.table(&mut rows);
            let mut whole = Section::new(0, &of("total"));
            self.whole(pair, &mut whole);
            sections.extend([rows, whole]);
            if !pair.stated.is_empty() {
                answer.push(of(&stated::in_words(&pair.stated)));
                sections.push(stated::section(&pair.stated, &of("other changes")));
            }
        }
        if !self.stated.is_empty() {
            answer.push(stated::in_words(&self.stated));
            sections.push(stated::section(&self.stated, "requests and sequence"));
        }
        for (k, section) in sections.iter_mut().enumerate() {
            section.number = u8::try_from(k + 1).unwrap_or(u8::MAX);
            let mut letters = section.title.chars();
            if let (None, Some(first)) = (section.title.find(':'), letters.next()) {
                section.title = first.to_uppercase().chain(letters).collect();
            }
        }
        Document { title, verdict: None, answer, sections, findings: Vec::new() }
    }

    /// Returns words such as `3 changes of 2 rows; predicted mass 4.31 kg to 4.52 kg, by +0.21 kg`.
    fn in_words(&self, pair: &Pair<'_>) -> String {
        let mut rows: Vec<&str> = pair.changes.iter().map(|change| change.row.as_str()).collect();
        rows.dedup();
        let [before, after] = pair.cases.map(|case| case.estimate(self.basis).properties.mass());
        let mass = if before == after {
            "mass unchanged".to_owned()
        } else {
            format!("{} mass {}", self.basis.name(), from_to(before, after, "kg"))
        };
        match (pair.changes.len(), rows.len()) {
            (0, _) => format!("no row changed; {mass}"),
            (n, k) => format!("{} of {}; {mass}", counted(n, "change"), counted(k, "row")),
        }
    }

    fn whole(&self, pair: &Pair<'_>, section: &mut Section) {
        let [before, after] = pair.cases.map(|case| case.estimate(self.basis));
        let values = [before, after].map(|estimate| tidied(ten(&estimate.properties)));
        let mut rows: Vec<Vec<String>> = Vec::new();
        for k in 0..10 {
            let (name, unit, scale) = shown(k, ("mm", 1e3));
            let [was, is] = values.map(|values| scale * values[k]);
            let sd = [before, after].map(|estimate| scale * estimate.sd(k));
            let cells = [with_error(was, sd[0]), with_error(is, sd[1]), signed(is - was), unit.to_owned()];
            rows.push([name.to_owned()].into_iter().chain(cells).collect());
        }
        let moments = [before, after].map(Estimate::principal);
        for k in 0..3 {
            let by = moments[1].frame.moments()[k] - moments[0].frame.moments()[k];
            let [was, is] = [0, 1].map(|side| principal::moment(pair.cases[side], &moments[side], k));
            rows.push(vec![format!("i{}", k + 1), was, is, signed(by), "kg·m²".to_owned()]);
        }
        section.table(&["quantity", "before", "after", "change", "unit"], rows);
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

    /// Returns the differences as JSON.
    pub fn to_json(&self) -> Value {
        let pair = |pair: &Pair<'_>| {
            let whole = pair.cases.map(|case| {
                let estimate = case.estimate(self.basis);
                let values = ten(&estimate.properties);
                let sd: Vec<f64> = (0..10).map(|k| estimate.sd(k)).collect();
                json!({ "values": values, "sd": sd, "margin": case.whole_statement().margin() })
            });
            let [before, after] = whole;
            json!({
                "name": pair.name(),
                "changes": pair.changes.iter().map(Change::to_json).collect::<Value>(),
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
            "basis": self.basis.name(),
            "only_before": self.alone[0],
            "only_after": self.alone[1],
            "stated": stated::to_json(&self.stated),
            "configurations": self.pairs.iter().map(pair).collect::<Value>(),
        })
    }
}

impl Pair<'_> {
    fn name(&self) -> Option<&str> {
        let [before, after] = self.cases;
        after.name.as_deref().or(before.name.as_deref())
    }

    fn table(&self, section: &mut Section) {
        if self.changes.is_empty() {
            section.say("No row changed.");
            return;
        }
        let row = |change: &Change| vec![printable(&change.row), change.words.clone()];
        section.table(&["part", "change"], self.changes.iter().take(SHOWN).map(row).collect());
        if self.changes.len() > SHOWN {
            section
                .say(format!("{} more changes are in --json.", count((self.changes.len() - SHOWN) as u64)));
        }
    }
}
