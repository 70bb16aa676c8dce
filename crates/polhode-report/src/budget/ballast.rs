//! The least ballast by which limits are met.

use polhode_budget::{Ballast, BallastAnswer, LeastBallast, Limit};
use serde_json::{Value, json};

use super::case::Case;
use super::found::Found;
use super::limits::{allowed, shown_unit};
use crate::explain::document::Section;
use crate::layout::printable;
use crate::number::{count, number, tidy};

pub(super) fn section(case: &Case, ballast: &Ballast, limits: &[Limit]) -> Option<Section> {
    let Found { answer, left_out } = case.ballast.as_ref()?;
    let mut section = Section::new(0, "Ballast");
    let mut reasons: Vec<&str> = left_out.iter().map(|(_, why)| *why).collect();
    reasons.dedup();
    for reason in reasons {
        let names = left_out.iter().filter(|(_, why)| *why == reason).map(|(name, _)| printable(name));
        section.say(format!("Not sought for {}: {reason}.", names.collect::<Vec<_>>().join(", ")));
    }
    let sought = sought(left_out, limits);
    let least = match answer {
        BallastAnswer::Least(least) => least,
        BallastAnswer::None(none) => {
            section.say(format!(
                "No ballast at these sites, up to {} kg, meets {sought}. That is proved: the prices of the limits leave none in {}.",
                number(none.up_to, 6),
                regions(none.regions)
            ));
            return Some(section);
        }
    };
    if least.pieces.is_empty() {
        section.say(format!(
            "Without ballast the list meets {sought}{}.",
            others(case, least, left_out, limits, "without")
        ));
        return Some(section);
    }
    let row = |piece: &polhode_budget::Piece| {
        let [x, y, z] = tidy(piece.position.to_array()).map(|x| number(1e3 * x, 5));
        let site = ballast.sites.get(piece.site).map_or_else(String::new, |site| printable(&site.name));
        vec![site, x, y, z, number(1e3 * piece.mass, 6)]
    };
    section
        .table(&["site", "x (mm)", "y (mm)", "z (mm)", "mass (g)"], least.pieces.iter().map(row).collect());
    section.say(format!(
        "{} kg is the least: none below {} kg meets {sought} (gap {}), as the prices of the limits prove, checked in intervals, in {}{}.",
        number(least.mass, 9),
        number(least.bound, 9),
        number(least.gap(), 2),
        regions(least.regions),
        others(case, least, left_out, limits, "with it")
    ));
    if ballast.deviations > 0.0 {
        section.say(format!(
            "The whole is kept {} standard deviations inside the limits.",
            number(ballast.deviations, 3)
        ));
    }
    let row = |limit: &Limit| {
        let (unit, scale) = shown_unit(limit.of.unit());
        let without = case.estimate(limit.basis).properties;
        let value = |body| limit.of.value(&body).map_or_else(|why| why.to_string(), |x| number(scale * x, 5));
        let with = least.with(&without).map_or_else(|error| error.to_string(), value);
        vec![printable(&limit.name), allowed(limit, scale), value(without), with, unit.to_owned()]
    };
    section.table(&["limit", "allowed", "without", "with", "unit"], limits.iter().map(row).collect());
    Some(section)
}

/// `Least ballast 0.123 kg, in 2 pieces: proved`, of the limits that it was sought for.
pub(super) fn in_words(case: &Case, limits: &[Limit]) -> Option<String> {
    let Found { answer, left_out } = case.ballast.as_ref()?;
    let sought = sought(left_out, limits);
    Some(match answer {
        BallastAnswer::None(_) => format!("No ballast at these sites meets {sought}"),
        BallastAnswer::Least(least) if least.pieces.is_empty() => {
            let others = others(case, least, left_out, limits, "without");
            let is_one = !left_out.is_empty() && limits.len() == left_out.len() + 1;
            let is = if is_one { "is" } else { "are" };
            format!("No ballast is needed: {sought} {is} met without{others}")
        }
        BallastAnswer::Least(least) => {
            let LeastBallast { pieces, mass, .. } = least;
            let plural = if pieces.len() == 1 { "" } else { "s" };
            let of = if left_out.is_empty() { String::new() } else { format!(" for {sought}") };
            format!(
                "Least ballast {} kg, in {} piece{plural}{of}: proved{}",
                number(*mass, 4),
                count(pieces.len() as u64),
                others(case, least, left_out, limits, "with it")
            )
        }
    })
}

/// The limits that ballast was sought for.
fn sought(left_out: &[(String, &str)], limits: &[Limit]) -> String {
    if left_out.is_empty() {
        return "all limits".to_owned();
    }
    let sought = limits.iter().filter(|limit| !is_left_out(left_out, limit));
    let names: Vec<String> = sought.map(|limit| printable(&limit.name)).collect();
    names.join(", ")
}

/// `; spin ratio along z, left out, is not met with it`
fn others(
    case: &Case,
    least: &LeastBallast,
    left_out: &[(String, &str)],
    limits: &[Limit],
    ballast: &str,
) -> String {
    let one = |limit: &Limit| {
        let is = if is_met(case, least, limit) { "is" } else { "is not" };
        format!("; {}, left out, {is} met {ballast}", printable(&limit.name))
    };
    limits.iter().filter(|limit| is_left_out(left_out, limit)).map(one).collect()
}

fn is_left_out(left_out: &[(String, &str)], limit: &Limit) -> bool {
    left_out.iter().any(|(name, _)| *name == limit.name)
}

/// Whether the whole with this ballast meets a limit; not if its number is undefined.
fn is_met(case: &Case, least: &LeastBallast, limit: &Limit) -> bool {
    let body = least.with(&case.estimate(limit.basis).properties);
    body.is_ok_and(|body| limit.of.value(&body).is_ok_and(|value| limit.is_met(value)))
}

fn regions(n: usize) -> String {
    if n == 1 { "one region".to_owned() } else { format!("{} regions", count(n as u64)) }
}

pub(super) fn to_json(case: &Case, ballast: Option<&Ballast>, limits: &[Limit]) -> Value {
    let left_out = case.ballast.iter().flat_map(|found| &found.left_out);
    let left_out: Vec<&str> = left_out.map(|(name, _)| name.as_str()).collect();
    match (case.ballast.as_ref().map(|found| &found.answer), ballast) {
        (Some(BallastAnswer::Least(least)), Some(ballast)) => {
            let piece = |piece: &polhode_budget::Piece| {
                json!({
                    "site": ballast.sites.get(piece.site).map(|site| &site.name),
                    "position": piece.position.to_array(),
                    "mass": piece.mass,
                })
            };
            let met = limits.iter().filter(|limit| left_out.contains(&limit.name.as_str()));
            let met: Vec<&str> =
                met.filter(|limit| is_met(case, least, limit)).map(|limit| limit.name.as_str()).collect();
            json!({
                "mass": least.mass,
                "bound": least.bound,
                "gap": least.gap(),
                "regions": least.regions,
                "pieces": least.pieces.iter().map(piece).collect::<Value>(),
                "not_sought_for": left_out,
                "not_sought_for_but_met": met,
            })
        }
        (Some(BallastAnswer::None(none)), _) => {
            json!({ "mass": null, "none_up_to": none.up_to, "regions": none.regions, "not_sought_for": left_out })
        }
        _ => Value::Null,
    }
}
