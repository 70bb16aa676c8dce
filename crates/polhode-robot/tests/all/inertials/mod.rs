//! Inertials written from geometry: whole robots, choices, masses, refusals.

mod masses;
mod rebuilt;
mod robot;
mod samples;
mod solids;
mod texts;

use polhode_robot::inertials::{Inertials, InertialsRequest, LinkOutcome, Outcome, Written, write_inertials};
use polhode_source::files::Memory;

/// Requests the inertials of a model in memory, with the substances of parts.
fn request(file: &str, parts: &[&str]) -> InertialsRequest {
    let part = parts.iter().map(|part| part.parse().unwrap()).collect();
    InertialsRequest { file: file.into(), part, ..InertialsRequest::default() }
}

fn written(file: &str, text: &str, parts: &[&str]) -> Inertials {
    write_inertials(&request(file, parts), &Memory::from([(file, text)])).unwrap()
}

/// Returns the new inertial of a link.
#[track_caller]
fn of<'i>(inertials: &'i Inertials, link: &str) -> &'i Written {
    match &outcome(inertials, link).outcome {
        Outcome::Written(written) => written,
        other => panic!("{link}: {other:?}"),
    }
}

/// Returns the reason why a link has no new inertial.
#[track_caller]
fn why_not<'i>(inertials: &'i Inertials, link: &str) -> &'i str {
    match &outcome(inertials, link).outcome {
        Outcome::NotWritten { why, .. } => why,
        Outcome::NoGeometry { .. } => "no geometry",
        Outcome::Written(written) => panic!("{link}: {written:?}"),
    }
}

#[track_caller]
fn outcome<'i>(inertials: &'i Inertials, link: &str) -> &'i LinkOutcome {
    inertials.links.iter().find(|outcome| outcome.link == link).unwrap()
}
