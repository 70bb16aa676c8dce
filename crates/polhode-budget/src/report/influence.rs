//! Contributions of single errors to the variance of results.

use polhode_document::drawing::{Bar, BarPanel, Bars, Drawing};
use polhode_document::layout::printable;
use polhode_document::number::{NO_BREAK, number};
use polhode_document::{Block, Section};

use super::case::{Case, ResultKind, SpreadResult};
use super::limits::shown_unit;
use crate::{Sensitivity, Source};

/// Number of bars per result, and of cells per row of the table.
const BARS: usize = 6;
const CELLS: usize = 2;

pub(crate) fn section(case: &Case) -> Option<Section> {
    let results: Vec<&SpreadResult> = case.results.iter().filter(|result| !result.by.is_empty()).collect();
    if results.is_empty() {
        return None;
    }
    let mut section = Section::new(4, "Error breakdown");
    section.say(
        "Share of each error in the variance of a quantity, to first order; all shares add up to 100 %.",
    );
    let row = |result: &&SpreadResult| {
        let (unit, scale) = shown_unit(result.unit);
        let mut cells = vec![printable(&result.name), format!("{} {unit}", number(scale * result.sd, 2))];
        cells.extend(result.by.iter().take(CELLS).map(|by| {
            format!("{}: {}{NO_BREAK}%", printable(&named(case, by)), number(100.0 * share(result, by), 2))
        }));
        cells.resize(2 + CELLS, String::new());
        cells
    };
    let headers = ["quantity", "sd", "largest share", "second"];
    section.table(&headers, results.iter().map(row).collect());
    for (title, of) in [
        ("Errors of mass and centre of mass", ResultKind::Place),
        ("Errors of the inertia tensor", ResultKind::Tensor),
        ("Errors of principal moments and axes", ResultKind::Principal),
        ("Errors of limited quantities", ResultKind::Limit),
    ] {
        let results: Vec<&SpreadResult> = results.iter().copied().filter(|result| result.of == of).collect();
        if !results.is_empty() {
            let caption = if section.blocks.iter().any(|block| matches!(block, Block::Drawing(_))) {
                ""
            } else {
                CAPTION
            };
            section.draw(Drawing::Bars(tornado(case, title, caption, &results)));
        }
    }
    Some(section)
}

/// Returns bars of the standard deviations to both sides, with the greatest at the top.
fn tornado(case: &Case, title: &str, caption: &'static str, results: &[&SpreadResult]) -> Bars {
    let panel = |result: &&SpreadResult| {
        let (unit, scale) = shown_unit(result.unit);
        let bar = |by: &Sensitivity| {
            let sd = scale * by.variance.sqrt();
            Bar {
                name: named(case, by),
                from: -sd,
                to: sd,
                size: format!("{} %", number(100.0 * share(result, by), 2)),
                kind: by.kind as usize,
            }
        };
        BarPanel {
            title: format!("{} ± {} {unit}", result.name, number(scale * result.sd, 2)),
            across: ["standard deviation", unit],
            bars: result.by.iter().take(BARS).map(bar).collect(),
        }
    };
    Bars {
        title: title.to_owned(),
        caption,
        kinds: KINDS.to_vec(),
        panels: results.iter().map(panel).collect(),
    }
}

const CAPTION: &str = "Each bar shows the change of the quantity for plus and minus one standard deviation of an error, with the error's share of the variance.";

/// Names of the kinds of errors, in their order.
const KINDS: [&str; 6] = ["mass", "centre", "tensor", "position", "rotation", "density"];

/// Returns the name of a row or a group.
pub(crate) fn source_name(case: &Case, by: &Sensitivity) -> String {
    match by.source {
        Source::Row(k) => case.short(k).to_owned(),
        Source::Group(k) => format!("group {}", case.budget.groups()[k].name),
    }
}

/// Returns words such as `battery, mass`.
fn named(case: &Case, by: &Sensitivity) -> String {
    format!("{}, {}", source_name(case, by), KINDS[by.kind as usize])
}

pub(crate) fn share(result: &SpreadResult, by: &Sensitivity) -> f64 {
    by.variance / (result.sd * result.sd)
}
