//! Masses of a list: its tree, and the breakdown of the whole.

use polhode_document::Section;
use polhode_document::drawing::{Bar, BarPanel, Bars, Drawing};
use polhode_document::layout::{INDENT, printable};
use polhode_document::number::{DIGITS, NO_BREAK, alike, count, number};

use super::case::Case;
use crate::MassStatement;

/// Largest number of rows that are shown. JSON and CSV have all.
const SHOWN: usize = 60;
/// Largest number of bars of components.
const BARS: usize = 14;

pub(crate) fn section(case: &Case) -> Section {
    let mut section = Section::new(1, "Mass breakdown");
    section.say("Mass of each row in kg, including the rows inside it.");
    let tree = Tree::of(case);
    let shown = tree.shown(case);
    table(&mut section, case, &tree, &shown);
    let left_out = case.statements.len() - shown.len();
    if left_out > 0 {
        section.say(format!("{} more rows are in --json and --csv.", count(left_out as u64)));
    }
    let (budget, rows) = (&case.budget, case.budget.rows());
    if (0..rows.len()).any(|k| budget.has_rows_in(k) && rows.quantity(k).count > 1) {
        section.say("Each mass is the sum over all copies of the row, in one copy of its parent.");
    }
    section.draw(Drawing::Bars(waterfall(case, &tree)));
    section
}

/// Returns words such as `Allowable 4.5 kg: the margin is 0.19 kg, 4.7 % of the basic mass`.
pub(crate) fn margin_in_words(case: &Case) -> Option<String> {
    let whole = case.whole_statement();
    let (allowable, margin, part) = (whole.allowable?, whole.margin()?, whole.relative_margin()?);
    let words = format!(
        "Allowable {} kg: the margin is {} kg, {}{NO_BREAK}% of the basic mass",
        number(allowable, DIGITS),
        number(margin, 4),
        number(100.0 * part, 3)
    );
    Some(if margin < 0.0 { format!("{words}: too heavy") } else { words })
}

/// Tree of rows, by their parents.
struct Tree {
    children: Vec<Vec<usize>>,
    depth: Vec<usize>,
    /// Depth-first order: each row before its descendants, and these before its next sibling.
    order: Vec<usize>,
}

impl Tree {
    fn of(case: &Case) -> Self {
        let (budget, count) = (&case.budget, case.statements.len());
        let mut children = vec![Vec::new(); count];
        for (k, parent) in (0..count).filter_map(|k| Some((k, budget.parent(k)?))) {
            children[parent].push(k);
        }
        let (mut depth, mut order) = (vec![0; count], Vec::with_capacity(count));
        let mut open = vec![budget.root()];
        while let Some(k) = open.pop() {
            order.push(k);
            for &child in children[k].iter().rev() {
                depth[child] = depth[k] + 1;
                open.push(child);
            }
        }
        Self { children, depth, order }
    }

    /// Returns the rows to show: as many levels as fit, the heaviest rows of the next level, and
    /// all rows that exceed the allowable mass.
    fn shown(&self, case: &Case) -> Vec<usize> {
        let deepest = self.depth.iter().copied().max().unwrap_or(0);
        // Number of rows up to each depth.
        let mut within = vec![0; deepest + 1];
        self.depth.iter().for_each(|depth| within[*depth] += 1);
        (1..within.len()).for_each(|level| within[level] += within[level - 1]);
        let level = within.iter().rposition(|count| *count <= SHOWN).unwrap_or(0);
        let mut is_shown: Vec<bool> = self.depth.iter().map(|depth| *depth <= level).collect();
        let ordered = || self.order.iter().copied();
        let mut heaviest: Vec<usize> = ordered().filter(|&k| self.depth[k] == level + 1).collect();
        heaviest.sort_by(|&a, &b| case.statements[b].predicted.total_cmp(&case.statements[a].predicted));
        let room = SHOWN.saturating_sub(within[level]);
        heaviest
            .iter()
            .take(room)
            .chain(&case.exceeded().take(SHOWN).collect::<Vec<_>>())
            .for_each(|&k| is_shown[k] = true);
        ordered().filter(|&k| is_shown[k]).collect()
    }
}

fn table(section: &mut Section, case: &Case, tree: &Tree, shown: &[usize]) {
    let rows = case.budget.rows();
    let statements: Vec<&MassStatement> = shown.iter().map(|&k| &case.statements[k]).collect();
    let is_quantity = shown.iter().any(|&k| rows.quantity(k).count > 1);
    let is_allowed = statements.iter().any(|statement| statement.allowable.is_some());
    let (mut headers, mut columns): (Vec<&str>, Vec<Vec<String>>) = (Vec::new(), Vec::new());
    let mut column = |header, cells| {
        headers.push(header);
        columns.push(cells);
    };
    let name = |&k: &usize| {
        let name = rows.name(k);
        // The position in the tree already shows the path.
        let parent = case.budget.parent(k).map(|parent| rows.name(parent));
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
        let copies = |&k: &usize| match rows.quantity(k).count {
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

/// Returns the components of the whole one after the other, then the growth allowance, then the
/// margin.
fn waterfall(case: &Case, tree: &Tree) -> Bars {
    let rows = case.budget.rows();
    let whole = case.whole_statement();
    let mut front = vec![case.budget.root()];
    // The heaviest assembly is replaced by its children as long as they fit.
    while let Some((place, &k)) = front
        .iter()
        .enumerate()
        .filter(|(_, k)| !tree.children[**k].is_empty() && !rows.has_part(**k))
        .filter(|(_, k)| rows.quantity(**k).count == 1)
        .filter(|(_, k)| front.len() - 1 + tree.children[**k].len() <= BARS)
        .max_by(|(_, a), (_, b)| case.statements[**a].basic.total_cmp(&case.statements[**b].basic))
    {
        front.splice(place..=place, tree.children[k].iter().copied());
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
        title: "Mass breakdown".to_owned(),
        caption: "Each bar starts where the previous one ends: basic masses, growth allowance up to the predicted mass, margin up to the allowable mass.",
        kinds: vec!["basic mass", "growth allowance", "margin", "", "", "negative margin"],
        panels: vec![BarPanel { title: "Mass breakdown".to_owned(), across: ["mass", "kg"], bars }],
    }
}
