//! Ballast by which limits are met.

use crate::{Ballast, BallastAnswer, FoundBallast, Limit};
use polhode_document::Section;
use polhode_document::layout::printable;
use polhode_document::number::{count, number, tidy};
use serde_json::{Value, json};

use super::case::Case;
use super::found::Found;
use super::limits::{allowed, shown_unit};

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
    let found = match answer {
        BallastAnswer::Found(found) => found,
        BallastAnswer::NotFound(none) => {
            let up_to = number(none.up_to, 6);
            section.say(if none.is_proved() {
                format!(
                    "No ballast at these sites, up to {up_to} kg, meets {sought}. The lower bound proves that."
                )
            } else {
                format!(
                    "No ballast was found at these sites, up to {up_to} kg, that meets {sought}. That none exists is not proved: the lower bound is {} kg.",
                    number(none.bound, 9)
                )
            });
            return Some(section);
        }
    };
    if found.pieces.is_empty() {
        section.say(format!(
            "Without ballast the list meets {sought}{}.",
            others(case, found, left_out, limits, "without")
        ));
        return Some(section);
    }
    let counts = found.pieces.iter().any(|piece| piece.count > 1);
    let row = |piece: &crate::Piece| {
        let [x, y, z] = tidy(piece.position.to_array()).map(|x| number(1e3 * x, 5));
        let site = ballast.sites.get(piece.site).map_or_else(String::new, |site| printable(&site.name));
        let count = counts.then(|| count(piece.count));
        [site, x, y, z].into_iter().chain(count).chain([number(1e3 * piece.mass, 6)]).collect()
    };
    let head: &[&str] = if counts {
        &["site", "x (mm)", "y (mm)", "z (mm)", "pieces", "each (g)"]
    } else {
        &["site", "x (mm)", "y (mm)", "z (mm)", "mass (g)"]
    };
    section.table(head, found.pieces.iter().map(row).collect());
    let others = others(case, found, left_out, limits, "with it");
    let mass = number(found.mass, 9);
    let bound = format!(
        "no ballast below {} kg meets {sought} (gap {})",
        number(found.bound, 9),
        number(found.gap(), 2)
    );
    section.say(if found.is_least() {
        format!("{mass} kg is the least: {bound}{others}.")
    } else {
        format!("{mass} kg is the lightest that was found, not proved least: {bound}{others}.")
    });
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
        let with = found.with(&without).map_or_else(|error| error.to_string(), value);
        vec![printable(&limit.name), allowed(limit, scale), value(without), with, unit.to_owned()]
    };
    section.table(&["limit", "allowed", "without", "with", "unit"], limits.iter().map(row).collect());
    Some(section)
}

/// `Least ballast 0.123 kg, in 2 pieces: proved`, of the limits that it was sought for.
pub(super) fn in_words(case: &Case, limits: &[Limit]) -> Option<String> {
    let Found { answer, left_out } = case.ballast.as_ref()?;
    let sought = sought(left_out, limits);
    let found = match answer {
        BallastAnswer::NotFound(none) if none.is_proved() => {
            return Some(format!("No ballast at these sites meets {sought}"));
        }
        BallastAnswer::NotFound(_) => {
            return Some(format!("No ballast was found that meets {sought}; that none exists is not proved"));
        }
        BallastAnswer::Found(found) => found,
    };
    if found.pieces.is_empty() {
        let others = others(case, found, left_out, limits, "without");
        let is_one = !left_out.is_empty() && limits.len() == left_out.len() + 1;
        let is = if is_one { "is" } else { "are" };
        return Some(format!("No ballast is needed: {sought} {is} met without{others}"));
    }
    let of = if left_out.is_empty() { String::new() } else { format!(" for {sought}") };
    let others = others(case, found, left_out, limits, "with it");
    let (mass, pieces) = (number(found.mass, 4), pieces(found));
    Some(if found.is_least() {
        format!("Least ballast {mass} kg, in {pieces}{of}: proved{others}")
    } else {
        let bound = number(found.bound, 4);
        format!("Ballast of {mass} kg, in {pieces}{of}: not proved least, lower bound {bound} kg{others}")
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
    least: &FoundBallast,
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

/// Returns true if the whole with this ballast meets a limit. An undefined number does not meet it.
fn is_met(case: &Case, least: &FoundBallast, limit: &Limit) -> bool {
    let body = least.with(&case.estimate(limit.basis).properties);
    body.is_ok_and(|body| limit.of.value(&body).is_ok_and(|value| limit.is_met(value)))
}

/// `3 pieces`
fn pieces(found: &FoundBallast) -> String {
    let all: u64 = found.pieces.iter().map(|piece| piece.count).sum();
    format!("{} piece{}", count(all), if all == 1 { "" } else { "s" })
}

pub(super) fn to_json(case: &Case, ballast: Option<&Ballast>, limits: &[Limit]) -> Value {
    let (Some(Found { answer, left_out }), Some(ballast)) = (case.ballast.as_ref(), ballast) else {
        return Value::Null;
    };
    let left_out: Vec<&str> = left_out.iter().map(|(name, _)| name.as_str()).collect();
    let found = match answer {
        BallastAnswer::Found(found) => found,
        BallastAnswer::NotFound(none) if none.is_proved() => {
            return json!({
                "mass": null, "none_up_to": none.up_to, "proved": true, "not_sought_for": left_out,
            });
        }
        BallastAnswer::NotFound(none) => {
            return json!({
                "mass": null, "bound": none.bound, "proved": false, "not_sought_for": left_out,
            });
        }
    };
    let piece = |piece: &crate::Piece| {
        json!({
            "site": ballast.sites.get(piece.site).map(|site| &site.name),
            "position": piece.position.to_array(),
            "mass": piece.mass,
            "count": piece.count,
        })
    };
    let met = limits.iter().filter(|limit| left_out.contains(&limit.name.as_str()));
    let met: Vec<&str> =
        met.filter(|limit| is_met(case, found, limit)).map(|limit| limit.name.as_str()).collect();
    json!({
        "mass": found.mass,
        "bound": found.bound,
        "gap": found.gap(),
        "proved": found.is_least(),
        "pieces": found.pieces.iter().map(piece).collect::<Value>(),
        "not_sought_for": left_out,
        "not_sought_for_but_met": met,
    })
}
