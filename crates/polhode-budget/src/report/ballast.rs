//! Ballast section of the report.

use crate::{Ballast, BallastAnswer, FoundBallast, Limit, Piece};
use polhode_document::Section;
use polhode_document::layout::printable;
use polhode_document::number::{count, number, tidy};
use serde_json::{Value, json};

use super::case::Case;
use super::found::Found;
use super::limits::{allowed, shown_unit};

/// Ballast of a configuration, with the limits of the list.
#[derive(Clone, Copy)]
pub(super) struct OfCase<'a> {
    case: &'a Case,
    limits: &'a [Limit],
    found: &'a Found,
}

impl<'a> OfCase<'a> {
    pub(super) fn new(case: &'a Case, limits: &'a [Limit]) -> Option<Self> {
        case.ballast.as_ref().map(|found| Self { case, limits, found })
    }

    pub(super) fn section(self, ballast: &Ballast) -> Section {
        let mut section = Section::new(0, "Ballast");
        let left_out = &self.found.left_out;
        let mut reasons: Vec<&str> = left_out.iter().map(|(_, why)| *why).collect();
        reasons.dedup();
        for reason in reasons {
            let names = left_out.iter().filter(|(_, why)| *why == reason).map(|(name, _)| printable(name));
            section.say(format!(
                "The search does not include {}: {reason}.",
                names.collect::<Vec<_>>().join(", ")
            ));
        }
        let sought = self.sought();
        match &self.found.answer {
            BallastAnswer::NotFound(none) => {
                let up_to = number(none.up_to, 6);
                section.say(if none.is_proved() {
                    format!(
                        "No ballast at these sites, up to {up_to} kg, meets {sought}. The lower bound proves that."
                    )
                } else {
                    format!(
                        "No ballast was found at these sites, up to {up_to} kg, that meets {sought}. It is not proved that none exists: the lower bound is {} kg.",
                        number(none.bound, 9)
                    )
                });
            }
            BallastAnswer::Found(found) if found.pieces.is_empty() => {
                let others = self.others(found, "without ballast");
                section.say(format!("Without ballast the list meets {sought}{others}."));
            }
            BallastAnswer::Found(found) => {
                pieces(&mut section, ballast, found);
                let others = self.others(found, "with it");
                let [mass, least] = [found.mass, found.bound].map(|mass| number(mass, 9));
                let bound =
                    format!("no ballast below {least} kg meets {sought} (gap {})", number(found.gap(), 2));
                section.say(if found.is_least() {
                    format!("{mass} kg is the minimum: {bound}{others}.")
                } else {
                    format!("{mass} kg is the lightest ballast found, not proved to be the minimum: {bound}{others}.")
                });
                if ballast.deviations > 0.0 {
                    section.say(format!(
                        "The values stay {} standard deviations inside the limits.",
                        number(ballast.deviations, 3)
                    ));
                }
                self.compared(&mut section, found);
            }
        }
        section
    }

    /// Adds a table of the limits without and with the ballast.
    fn compared(self, section: &mut Section, found: &FoundBallast) {
        let row = |limit: &Limit| {
            let (unit, scale) = shown_unit(limit.of.unit());
            let without = self.case.estimate(limit.basis).properties;
            let value =
                |body| limit.of.value(&body).map_or_else(|why| why.to_string(), |x| number(scale * x, 5));
            let with = found.with(&without).map_or_else(|error| error.to_string(), value);
            vec![printable(&limit.name), allowed(limit, scale), value(without), with, unit.to_owned()]
        };
        let headers = ["limit", "allowed", "without", "with", "unit"];
        section.table(&headers, self.limits.iter().map(row).collect());
    }

    /// Returns words such as `Least ballast 0.123 kg, in 2 pieces: proved`, with the limits that
    /// were considered.
    pub(super) fn in_words(self) -> String {
        let (sought, is_for_all) = (self.sought(), self.found.left_out.is_empty());
        let found = match &self.found.answer {
            BallastAnswer::NotFound(none) if none.is_proved() => {
                return format!("No ballast at these sites meets {sought}");
            }
            BallastAnswer::NotFound(_) => {
                return format!(
                    "No ballast was found that meets {sought}; it is not proved that none exists"
                );
            }
            BallastAnswer::Found(found) => found,
        };
        if found.pieces.is_empty() {
            let is_one = !is_for_all && self.limits.len() == self.found.left_out.len() + 1;
            let is = if is_one { "is" } else { "are" };
            let others = self.others(found, "without ballast");
            return format!("No ballast is needed: {sought} {is} met without ballast{others}");
        }
        let of = if is_for_all { String::new() } else { format!(" for {sought}") };
        let others = self.others(found, "with it");
        let pieces: u64 = found.pieces.iter().map(|piece| piece.count).sum();
        let pieces = format!("{} piece{}", count(pieces), if pieces == 1 { "" } else { "s" });
        let [mass, bound] = [found.mass, found.bound].map(|mass| number(mass, 4));
        if found.is_least() {
            format!("Minimum ballast {mass} kg, in {pieces}{of} (proved){others}")
        } else {
            format!("Ballast {mass} kg, in {pieces}{of} (minimum not proved, lower bound {bound} kg){others}")
        }
    }

    /// Returns the names of the limits that the search considered.
    fn sought(self) -> String {
        if self.found.left_out.is_empty() {
            return "all limits".to_owned();
        }
        let sought = self.limits.iter().filter(|limit| !self.found.is_left_out(limit));
        sought.map(|limit| printable(&limit.name)).collect::<Vec<_>>().join(", ")
    }

    /// Returns words such as `; spin ratio along z, left out, is not met with it`.
    fn others(self, found: &FoundBallast, ballast: &str) -> String {
        let one = |limit: &Limit| {
            let is = if self.is_met(found, limit) { "is" } else { "is not" };
            format!("; {} (not in the search) {is} met {ballast}", printable(&limit.name))
        };
        self.limits.iter().filter(|limit| self.found.is_left_out(limit)).map(one).collect()
    }

    /// Returns true if the whole with this ballast meets a limit. An undefined number does not meet
    /// it.
    fn is_met(self, found: &FoundBallast, limit: &Limit) -> bool {
        let body = found.with(&self.case.estimate(limit.basis).properties);
        body.is_ok_and(|body| limit.of.value(&body).is_ok_and(|value| limit.is_met(value)))
    }

    pub(super) fn to_json(self, ballast: &Ballast) -> Value {
        let left_out: Vec<&str> = self.found.left_out.iter().map(|(name, _)| name.as_str()).collect();
        let found = match &self.found.answer {
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
        let piece = |piece: &Piece| {
            json!({
                "site": ballast.sites.get(piece.site).map(|site| &site.name),
                "position": piece.position.to_array(),
                "mass": piece.mass,
                "count": piece.count,
            })
        };
        let met = self.limits.iter().filter(|limit| self.found.is_left_out(limit));
        let met = met.filter(|limit| self.is_met(found, limit)).map(|limit| limit.name.as_str());
        json!({
            "mass": found.mass,
            "bound": found.bound,
            "gap": found.gap(),
            "proved": found.is_least(),
            "pieces": found.pieces.iter().map(piece).collect::<Value>(),
            "not_sought_for": left_out,
            "not_sought_for_but_met": met.collect::<Vec<_>>(),
        })
    }
}

/// Adds a table of the places and masses of the pieces.
fn pieces(section: &mut Section, ballast: &Ballast, found: &FoundBallast) {
    let counts = found.pieces.iter().any(|piece| piece.count > 1);
    let row = |piece: &Piece| {
        let [x, y, z] = tidy(piece.position.to_array()).map(|x| number(1e3 * x, 5));
        let site = ballast.sites.get(piece.site).map_or_else(String::new, |site| printable(&site.name));
        let count = counts.then(|| count(piece.count));
        [site, x, y, z].into_iter().chain(count).chain([number(1e3 * piece.mass, 6)]).collect()
    };
    let mut headers = vec!["site", "x (mm)", "y (mm)", "z (mm)"];
    headers.extend(if counts { &["pieces", "each (g)"][..] } else { &["mass (g)"] });
    section.table(&headers, found.pieces.iter().map(row).collect());
}
