//! Whose errors matter.

use polhode_budget::{ErrorKind, Sensitivity, Source};
use polhode_document::drawing::{Bar, BarPanel, Bars, Drawing};
use polhode_document::layout::printable;
use polhode_document::number::{GROUP, number};
use polhode_document::{Block, Section};

use super::case::{Case, ResultKind, SpreadResult};
use super::limits::shown_unit;

/// Bars of a result, and cells of the table.
const BARS: usize = 6;
const CELLS: usize = 2;

pub(super) fn section(case: &Case) -> Option<Section> {
    let results: Vec<&SpreadResult> = case.results.iter().filter(|result| !result.by.is_empty()).collect();
    if results.is_empty() {
        return None;
    }
    let mut section = Section::new(4, "Whose errors matter");
    section
        .say("To first order, each error's part of the variance of a number; all parts together are 100 %.");
    let row = |result: &&SpreadResult| {
        let (unit, scale) = shown_unit(result.unit);
        let mut cells = vec![printable(&result.name), format!("{} {unit}", number(scale * result.sd, 2))];
        cells.extend(result.by.iter().take(CELLS).map(|by| {
            format!("{}: {}{GROUP}%", printable(&named(case, by)), number(100.0 * share(result, by), 2))
        }));
        cells.resize(2 + CELLS, String::new());
        cells
    };
    let headers = ["number", "sd", "most of it by", "then by"];
    section.table(&headers, results.iter().map(row).collect());
    for (title, of) in [
        ("Errors of mass and centre of mass", ResultKind::Place),
        ("Errors of the inertia tensor", ResultKind::Tensor),
        ("Errors of principal moments and axes", ResultKind::Principal),
        ("Errors of what is limited", ResultKind::Limit),
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

/// Standard deviations to both sides, the greatest above.
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
                kind: kind_place(by.kind),
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

const CAPTION: &str = "Each bar is as long as what one standard deviation of an error makes of the number, to both sides; beside it is its part of the variance.";

const KINDS: [&str; 6] = ["mass", "centre", "tensor", "position", "rotation", "density"];

const fn kind_place(kind: ErrorKind) -> usize {
    match kind {
        ErrorKind::Mass => 0,
        ErrorKind::Center => 1,
        ErrorKind::Tensor => 2,
        ErrorKind::Position => 3,
        ErrorKind::Rotation => 4,
        ErrorKind::Density => 5,
    }
}

/// `mass`, `center`, …, as JSON has it.
pub(super) const fn kind_name(kind: ErrorKind) -> &'static str {
    ["mass", "center", "tensor", "position", "rotation", "density"][kind_place(kind)]
}

/// A row or a group.
pub(super) fn source_name(case: &Case, by: &Sensitivity) -> String {
    match by.source {
        Source::Row(k) => case.short(k).to_owned(),
        Source::Group(k) => format!("group {}", case.budget.groups()[k].name),
    }
}

/// `battery, mass`
fn named(case: &Case, by: &Sensitivity) -> String {
    format!("{}, {}", source_name(case, by), KINDS[kind_place(by.kind)])
}

pub(super) fn share(result: &SpreadResult, by: &Sensitivity) -> f64 {
    by.variance / (result.sd * result.sd)
}
