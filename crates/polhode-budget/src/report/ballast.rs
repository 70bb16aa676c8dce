//! The least ballast by which limits are met.

use polhode_document::Section;
use polhode_document::layout::printable;
use polhode_document::number::{count, number, tidy};
use serde_json::{Value, json};

use super::case::Case;
use super::found::Found;
use super::limits::{allowed, shown_unit};
use crate::{Ballast, BallastAnswer, FoundBallast, Limit, UndecidedBallast};

pub(crate) fn section(case: &Case, ballast: &Ballast, limits: &[Limit]) -> Option<Section> {
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
        BallastAnswer::Least(least) => least,
        BallastAnswer::None(none) => {
            section.say(format!(
                "No ballast at these sites, up to {} kg, meets {sought}. That is proved: the prices of the limits leave none in {}.",
                number(none.up_to, 6),
                regions(none.regions)
            ));
            return Some(section);
        }
        BallastAnswer::Undecided(UndecidedBallast { found: Some(found), .. }) => found,
        BallastAnswer::Undecided(undecided) => {
            section.say(format!(
                "No ballast was found that meets {sought}, and none below {} kg does; whether more would is not decided{}.",
                number(undecided.bound, 9),
                ended(undecided)
            ));
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
    section.say(match answer {
        BallastAnswer::Undecided(undecided) => format!(
            "{} kg is the lightest that was found, and none below {} kg meets {sought} (gap {}), as the prices of the limits prove, checked in intervals; what is between is not decided{}{others}.",
            number(found.mass, 9),
            number(found.bound, 9),
            number(found.gap(), 2),
            ended(undecided)
        ),
        _ => format!(
            "{} kg is the least: none below {} kg meets {sought} (gap {}), as the prices of the limits prove, checked in intervals, in {}{others}.",
            number(found.mass, 9),
            number(found.bound, 9),
            number(found.gap(), 2),
            regions(found.regions),
        ),
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
pub(crate) fn in_words(case: &Case, limits: &[Limit]) -> Option<String> {
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
            let of = if left_out.is_empty() { String::new() } else { format!(" for {sought}") };
            let others = others(case, least, left_out, limits, "with it");
            format!("Least ballast {} kg, in {}{of}: proved{others}", number(least.mass, 4), pieces(least))
        }
        BallastAnswer::Undecided(UndecidedBallast { found: Some(found), .. }) => {
            let of = if left_out.is_empty() { String::new() } else { format!(" for {sought}") };
            format!(
                "Ballast of {} kg, in {}{of}: not proved to be the least, which is {} kg or more{}",
                number(found.mass, 4),
                pieces(found),
                number(found.bound, 4),
                others(case, found, left_out, limits, "with it")
            )
        }
        BallastAnswer::Undecided(undecided) => format!(
            "No ballast was found that meets {sought}; whether there is some of {} kg or more is not decided",
            number(undecided.bound, 4)
        ),
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

/// Whether the whole with this ballast meets a limit; not if its number is undefined.
fn is_met(case: &Case, least: &FoundBallast, limit: &Limit) -> bool {
    let body = least.with(&case.estimate(limit.basis).properties);
    body.is_ok_and(|body| limit.of.value(&body).is_ok_and(|value| limit.is_met(value)))
}

/// `3 pieces`
fn pieces(found: &FoundBallast) -> String {
    let all: u64 = found.pieces.iter().map(|piece| piece.count).sum();
    format!("{} piece{}", count(all), if all == 1 { "" } else { "s" })
}

/// Why the search ended.
fn ended(undecided: &UndecidedBallast) -> String {
    let regions = regions(undecided.regions);
    match undecided.effort {
        Some(effort) => format!(
            ", as the search ended after {regions}, with all its effort: `effort` in [ballast] was {}",
            count(effort as u64)
        ),
        None => format!(", as {regions} were looked at, and what is left cannot be split further"),
    }
}

fn regions(n: usize) -> String {
    if n == 1 { "one region".to_owned() } else { format!("{} regions", count(n as u64)) }
}

pub(crate) fn to_json(case: &Case, ballast: Option<&Ballast>, limits: &[Limit]) -> Value {
    let (Some(Found { answer, left_out }), Some(ballast)) = (case.ballast.as_ref(), ballast) else {
        return Value::Null;
    };
    let left_out: Vec<&str> = left_out.iter().map(|(name, _)| name.as_str()).collect();
    let of_found = |found: &FoundBallast, regions: usize, is_proved: bool| {
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
            "proved": is_proved,
            "regions": regions,
            "pieces": found.pieces.iter().map(piece).collect::<Value>(),
            "not_sought_for": left_out,
            "not_sought_for_but_met": met,
        })
    };
    match answer {
        BallastAnswer::Least(least) => of_found(least, least.regions, true),
        BallastAnswer::None(none) => json!({
            "mass": null, "none_up_to": none.up_to, "proved": true, "regions": none.regions, "not_sought_for": left_out,
        }),
        BallastAnswer::Undecided(UndecidedBallast { found: Some(found), regions, .. }) => {
            of_found(found, *regions, false)
        }
        BallastAnswer::Undecided(undecided) => json!({
            "mass": null, "bound": undecided.bound, "proved": false, "regions": undecided.regions, "not_sought_for": left_out,
        }),
    }
}
