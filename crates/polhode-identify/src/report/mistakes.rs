//! Possible mistakes in swing tests, and their detectability.

use polhode_document::Section;
use polhode_document::layout::printable;
use polhode_document::number::number;
use serde_json::{Value, json};

use crate::swing::{Mistake, MistakeKind, SwingEstimate};

/// Returns a sentence on mistakes that would remain undetected; `None` if there are none.
pub(crate) fn unseen(found: &SwingEstimate) -> Option<String> {
    const MOST: usize = 4;
    let unseen: Vec<&Mistake> = found.mistakes.iter().filter(|mistake| mistake.is_hidden()).collect();
    let named: Vec<String> = unseen.iter().take(MOST).map(|mistake| name(found, mistake)).collect();
    let more = match unseen.len().saturating_sub(MOST) {
        0 => String::new(),
        n => format!("; and {n} more"),
    };
    (!named.is_empty()).then(|| {
        format!(
            "these mistakes would change the results, and the residuals would not show it: {}{more}",
            named.join("; ")
        )
    })
}

/// Adds a table of all mistakes with their effects.
pub(crate) fn table(section: &mut Section, found: &SwingEstimate) {
    let Some(first) = found.mistakes.first() else { return };
    section.say(format!(
        "Sensitivity to mistakes, in standard deviations. A mistake is detected if it changes the residuals by at least {}; otherwise it changes the results undetected.",
        number(first.needed, 2)
    ));
    let row = |mistake: &Mistake| {
        let shows = match (mistake.shows(), mistake.matters()) {
            (true, _) => "yes",
            (false, true) => "no",
            (false, false) => "no, but negligible",
        };
        vec![name(found, mistake), number(mistake.shift, 2), number(mistake.left, 2), shows.to_owned()]
    };
    section.table(
        &["mistake", "change of results", "change of residuals", "detected"],
        found.mistakes.iter().map(row).collect(),
    );
}

fn name(found: &SwingEstimate, mistake: &Mistake) -> String {
    let what = match &mistake.kind {
        MistakeKind::Miscount => "swings miscounted by one",
        MistakeKind::SideToSide => "peak-to-peak angles given as amplitudes",
        MistakeKind::Twice { number } => return format!("{} twice too large", printable(number)),
        MistakeKind::Clock => "all times 1 % too long",
    };
    match mistake.test.and_then(|k| found.tests.get(k)) {
        Some(test) => format!("{}: {what}", printable(&test.name)),
        None => what.to_owned(),
    }
}

pub(crate) fn to_json(mistakes: &[Mistake]) -> Value {
    let each = |mistake: &Mistake| {
        let (kind, of) = match &mistake.kind {
            MistakeKind::Miscount => ("miscount", None),
            MistakeKind::SideToSide => ("side to side", None),
            MistakeKind::Twice { number } => ("twice as long", Some(number)),
            MistakeKind::Clock => ("clock", None),
        };
        json!({
            "kind": kind,
            "number": of,
            "test": mistake.test,
            "shift": mistake.shift,
            "left": mistake.left,
            "needed": mistake.needed,
            "matters": mistake.matters(),
            "shows": mistake.shows(),
        })
    };
    mistakes.iter().map(each).collect()
}
