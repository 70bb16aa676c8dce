//! The masses of a list: its tree, and what the whole is made of.

use polhode_budget::MassStatement;

use super::case::Case;
use crate::explain::document::Section;
use crate::explain::drawing::{Bar, BarPanel, Bars, Drawing};
use crate::layout::{INDENT, printable};
use crate::number::{GROUP, alike, count, number};

/// Rows that are shown; all are in JSON and CSV.
const SHOWN: usize = 60;
/// Bars of the whole.
const BARS: usize = 14;
/// Digits of masses that stand below each other.
const DIGITS: usize = 6;

pub(super) fn section(case: &Case) -> Section {
    let mut section = Section::new(1, "Masses");
    section.say("In kg, of each row with all that stands in it.");
    let tree = Tree::of(case);
    let shown = tree.shown(case);
    table(&mut section, case, &tree, &shown);
    let left_out = case.statements.len() - shown.len();
    if left_out > 0 {
        section.say(format!("{} more rows are in --json and --csv.", count(left_out as u64)));
    }
    let inside = case.budget.parents().iter().flatten();
    if inside.clone().any(|&k| case.budget.list().rows[k].quantity.count > 1) {
        section.say("Each mass is of all copies of a row in one of the row in which it stands.");
    }
    section.draw(Drawing::Bars(waterfall(case, &tree)));
    section
}

/// `Allowable 4.5 kg: the margin is 0.19 kg, 4.7 % of the basic mass`
pub(super) fn margin_in_words(case: &Case) -> Option<String> {
    let whole = case.whole_statement();
    let (allowable, margin, part) = (whole.allowable?, whole.margin()?, whole.relative_margin()?);
    let words = format!(
        "Allowable {} kg: the margin is {} kg, {}{GROUP}% of the basic mass",
        number(allowable, DIGITS),
        number(margin, 4),
        number(100.0 * part, 3)
    );
    Some(if margin < 0.0 { format!("{words}: too heavy") } else { words })
}

/// Rows by the row in which they stand.
struct Tree {
    inside: Vec<Vec<usize>>,
    depth: Vec<usize>,
    /// Each row before those in it.
    order: Vec<usize>,
}

impl Tree {
    fn of(case: &Case) -> Self {
        let parents = case.budget.parents();
        let mut inside = vec![Vec::new(); parents.len()];
        for (k, parent) in parents.iter().enumerate() {
            if let Some(parent) = parent {
                inside[*parent].push(k);
            }
        }
        let (mut depth, mut order) = (vec![0; parents.len()], Vec::with_capacity(parents.len()));
        let mut next = vec![case.budget.root()];
        while let Some(k) = next.pop() {
            order.push(k);
            for &child in inside[k].iter().rev() {
                depth[child] = depth[k] + 1;
                next.push(child);
            }
        }
        Self { inside, depth, order }
    }

    /// So many levels as there is room for, of a level too long its heaviest rows, and whatever is too heavy.
    fn shown(&self, case: &Case) -> Vec<usize> {
        let deepest = self.depth.iter().copied().max().unwrap_or(0);
        let within = |level: usize| self.depth.iter().filter(|depth| **depth <= level).count();
        let level = (0..=deepest).rev().find(|&level| within(level) <= SHOWN).unwrap_or(0);
        let mut is_shown: Vec<bool> = self.depth.iter().map(|depth| *depth <= level).collect();
        let mut heaviest: Vec<usize> =
            self.order.iter().copied().filter(|&k| self.depth[k] == level + 1).collect();
        heaviest.sort_by(|&a, &b| case.statements[b].predicted.total_cmp(&case.statements[a].predicted));
        let room = SHOWN.saturating_sub(within(level));
        heaviest
            .iter()
            .take(room)
            .chain(&case.exceeded().take(SHOWN).collect::<Vec<_>>())
            .for_each(|&k| is_shown[k] = true);
        self.order.iter().copied().filter(|&k| is_shown[k]).collect()
    }
}

fn table(section: &mut Section, case: &Case, tree: &Tree, shown: &[usize]) {
    let rows = &case.budget.list().rows;
    let statements: Vec<&MassStatement> = shown.iter().map(|&k| &case.statements[k]).collect();
    let is_quantity = shown.iter().any(|&k| rows[k].quantity.count > 1);
    let is_allowed = statements.iter().any(|statement| statement.allowable.is_some());
    let (mut headers, mut columns): (Vec<&str>, Vec<Vec<String>>) = (Vec::new(), Vec::new());
    let mut column = |header, cells| {
        headers.push(header);
        columns.push(cells);
    };
    let name = |&k: &usize| {
        let name = &rows[k].name;
        // What a path says before is said by where the row stands.
        let parent = case.budget.parents()[k].map(|parent| rows[parent].name.as_str());
        let short = parent.and_then(|parent| name.strip_prefix(parent)?.strip_prefix('/')).unwrap_or(name);
        format!("{}{}", INDENT.to_string().repeat(2 * tree.depth[k]), printable(short))
    };
    let masses = |of: &dyn Fn(&MassStatement) -> Option<f64>| -> Vec<String> {
        let values: Vec<Option<f64>> = statements.iter().map(|statement| of(statement)).collect();
        let known: Vec<f64> = values.iter().copied().flatten().collect();
        let mut texts = alike(&known, DIGITS).into_iter();
        values.iter().map(|value| value.and_then(|_| texts.next()).unwrap_or_default()).collect()
    };
    column("part", shown.iter().map(name).collect());
    if is_quantity {
        let copies = |&k: &usize| match rows[k].quantity.count {
            1 => String::new(),
            n => format!("{} ×", count(u64::from(n))),
        };
        column("quantity", shown.iter().map(copies).collect());
    }
    column(if case.grows() { "basic" } else { "mass" }, masses(&|s| Some(s.basic)));
    if case.grows() {
        let growth = |s: &&MassStatement| match s.growth_allowance() / s.basic {
            part if part.is_finite() => format!("{} %", number(100.0 * part, 3)),
            _ => String::new(),
        };
        column("growth", statements.iter().map(growth).collect());
        column("predicted", masses(&|s| Some(s.predicted)));
    }
    if is_allowed {
        column("allowable", masses(&|s| s.allowable));
        let margin = |s: &&MassStatement| s.margin().map_or_else(String::new, |margin| number(margin, 4));
        column("margin", statements.iter().map(margin).collect());
    }
    let lines = (0..shown.len()).map(|k| columns.iter().map(|cells| cells[k].clone()).collect()).collect();
    section.table(&headers, lines);
}

/// The greatest parts of the whole one after the other, then growth, then what is left.
fn waterfall(case: &Case, tree: &Tree) -> Bars {
    let rows = &case.budget.list().rows;
    let whole = case.whole_statement();
    let mut front = vec![case.budget.root()];
    // The heaviest assembly is opened while there is room for what is in it.
    while let Some((place, &k)) = front
        .iter()
        .enumerate()
        .filter(|(_, k)| !tree.inside[**k].is_empty() && rows[**k].part.is_none() && is_one_of_one(case, **k))
        .filter(|(_, k)| front.len() - 1 + tree.inside[**k].len() <= BARS)
        .max_by(|(_, a), (_, b)| case.statements[**a].basic.total_cmp(&case.statements[**b].basic))
    {
        front.splice(place..=place, tree.inside[k].iter().copied());
    }
    let mut bars: Vec<Bar> = Vec::new();
    let mut sum = 0.0;
    let mut add = |name: String, mass: f64, kind: usize| {
        let size = format!("{} kg", number(mass, 4));
        bars.push(Bar { name, from: sum, to: sum + mass, size, kind });
        sum += mass;
    };
    for k in front {
        let mass = case.statements[k].basic;
        if mass > 0.0 {
            add(case.short(k).to_owned(), mass, 0);
        }
    }
    if case.grows() {
        add("growth allowance".to_owned(), whole.growth_allowance(), 1);
    }
    if let Some(margin) = whole.margin() {
        add("margin".to_owned(), margin, if margin < 0.0 { 5 } else { 2 });
    }
    Bars {
        title: "What the mass is made of".to_owned(),
        caption: "Each bar begins where the one above ends: the basic masses, the growth allowance up to the predicted mass, the margin up to the allowable one.",
        kinds: vec!["basic mass", "growth allowance", "margin", "", "", "negative margin"],
        panels: vec![BarPanel { title: "What the mass is made of".to_owned(), across: ["mass", "kg"], bars }],
    }
}

/// Whether what stands in it counts as often in the whole as its statement says.
fn is_one_of_one(case: &Case, row: usize) -> bool {
    case.budget.list().rows[row].quantity.count == 1
}
