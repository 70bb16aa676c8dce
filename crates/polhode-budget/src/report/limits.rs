//! Section of the report on limits.

use polhode_document::Section;
use polhode_document::layout::printable;
use polhode_document::number::{NO_BREAK, count, number, with_error};
use serde_json::{Value, json};

use super::case::{Case, LEVEL};
use crate::{Answer, Limit, LimitAnswers, Margin, Share};

pub(crate) fn section(case: &Case, limits: &[Limit]) -> Option<Section> {
    let answers = case.limits.as_ref()?;
    let mut section = Section::new(0, "Limits");
    let row = |(limit, answer): (&Limit, &Answer)| {
        let (unit, scale) = shown_unit(limit.of.unit());
        let value = match (answer.value, answer.sd) {
            (Ok(value), Ok(sd)) => with_error(scale * value, scale * sd),
            (Ok(value), Err(_)) => number(scale * value, 4),
            (Err(why), _) => why.to_string(),
        };
        let unit = if unit.is_empty() { String::new() } else { format!("{NO_BREAK}{unit}") };
        vec![
            printable(&limit.name),
            format!("{}{unit}", allowed(limit, scale)),
            value,
            answer.least_margin().map_or_else(String::new, |margin| number(scale * margin.value, 3)),
            if answer.met { "met" } else { "not met" }.to_owned(),
            probability(&answer.share),
        ]
    };
    let headers = ["limit", "allowed", "value ± sd", "margin", "", "probability"];
    section.table(&headers, limits.iter().zip(&answers.answers).map(row).collect());
    section.say(format!(
        "Probability: share of the {} draws that meet the limit, with its {} % confidence interval (Clopper–Pearson). Met or not met: for the nominal values of the list.",
        count(answers.all.share.of as u64),
        number(100.0 * LEVEL, 3)
    ));
    for (limit, answer) in limits.iter().zip(&answers.answers) {
        if let (Some(true), Ok(first_order)) = (answer.differs, answer.first_order) {
            section.say(format!(
                "{}: the first-order probability (normal distribution) is {}.",
                printable(&limit.name),
                percent(first_order)
            ));
        }
    }
    if limits.len() > 1 {
        section.line(format!("all limits together: {}", probability(&answers.all.share)));
    }
    Some(section)
}

/// Returns words such as `All 5 limits are met; in 87.2 % (85.1 … 89.0 %) of possible bodies`.
pub(crate) fn answer_in_words(case: &Case) -> Option<String> {
    let answers = case.limits.as_ref().filter(|answers| !answers.answers.is_empty())?;
    let (met, all) = (answers.answers.iter().filter(|answer| answer.met).count(), answers.answers.len());
    let of = match (met == all, all) {
        (true, _) => "",
        (false, 1) => " that it is met:",
        (false, _) => " that all are met:",
    };
    let share = format!("probability{of} {}", probability(&answers.all.share));
    Some(match (met == all, all) {
        (true, 1) => format!("The limit is met; {share}"),
        (false, 1) => format!("The limit is not met; {share}"),
        (true, _) => format!("All {} limits are met; {share}", count(all as u64)),
        (false, _) => {
            format!("{} of {} limits are met; {share}", count(met as u64), count(all as u64))
        }
    })
}

/// Iterates over the names of the limits that are not met.
pub(crate) fn broken<'a>(case: &'a Case, limits: &'a [Limit]) -> impl Iterator<Item = &'a str> {
    let answers = case.limits.iter().flat_map(|answers| &answers.answers);
    answers.zip(limits).filter(|(answer, _)| !answer.met).map(|(_, limit)| limit.name.as_str())
}

pub(crate) fn shown_unit(unit: &'static str) -> (&'static str, f64) {
    match unit {
        "m" => ("mm", 1e3),
        "rad" => ("deg", 1f64.to_degrees()),
        unit => (unit, 1.0),
    }
}

pub(crate) fn allowed(limit: &Limit, scale: f64) -> String {
    let shown = |x: f64| number(scale * x, 6);
    match (limit.least, limit.most) {
        (Some(least), Some(most)) => format!("{} … {}", shown(least), shown(most)),
        (Some(least), None) => format!("≥ {}", shown(least)),
        (None, Some(most)) => format!("≤ {}", shown(most)),
        (None, None) => String::new(),
    }
}

/// Returns words such as `87.2 % (85.1 … 89.0 %)`.
fn probability(share: &Share) -> String {
    let [low, high] = share.interval.map(end);
    format!("{}{NO_BREAK}({low} … {high}{NO_BREAK}%)", percent(share.estimate()))
}

/// Formats a probability in percent. Near 0 and 1, enough decimals are shown to differ from 0 and
/// 100.
fn end(p: f64) -> String {
    const NEAR: f64 = 1e-3;
    /// Distance from 0 or 1 that is only rounding error.
    const ROUNDING: f64 = 1e-12;
    let beside = p.min(1.0 - p);
    if beside < ROUNDING {
        return if p < 0.5 { "0" } else { "100" }.to_owned();
    }
    let decimals = if beside < NEAR { (-(100.0 * beside).log10().floor()).max(2.0) as usize } else { 1 };
    format!("{:.decimals$}", 100.0 * p)
}

fn percent(p: f64) -> String {
    format!("{}{NO_BREAK}%", end(p))
}

pub(crate) fn to_json(case: &Case, limits: &[Limit]) -> Value {
    let Some(LimitAnswers { answers, all }) = &case.limits else { return Value::Null };
    let share = |share: &Share| {
        json!({
            "met": share.met,
            "of": share.of,
            "probability": share.estimate(),
            "interval": share.interval,
            "level": share.level,
        })
    };
    let margin = |margin: &Margin| json!({ "value": margin.value, "deviations": margin.deviations });
    let one = |(limit, answer): (&Limit, &Answer)| {
        let [least, most] = answer.margins;
        json!({
            "name": limit.name,
            "unit": limit.of.unit(),
            "basis": limit.basis.name(),
            "least": limit.least,
            "most": limit.most,
            "value": answer.value.ok(),
            "sd": answer.sd.ok(),
            "met": answer.met,
            "margin": { "least": least.as_ref().map(margin), "most": most.as_ref().map(margin) },
            "first_order": answer.first_order.ok(),
            "draws": share(&answer.share),
            "differs": answer.differs,
        })
    };
    json!({
        "each": limits.iter().zip(answers).map(one).collect::<Value>(),
        "all": { "met": all.met, "draws": share(&all.share), "first_order": all.first_order },
    })
}
