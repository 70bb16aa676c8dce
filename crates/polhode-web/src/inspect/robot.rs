//! Inspection of a robot with all joints at zero, with the errors of its inertias and the repair of
//! `polhode check --fix`.
//!
//! No file is written. A dropped model can open only files that were dropped with it.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use polhode::body::PrincipalFrame;
use polhode_robot::at_rest::AtRest;
use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::finding::{Finding, Severity};
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect;
use polhode_robot::line_index::{FilePlace, Places};
use polhode_robot::model::{Link, ModelFormat, RobotModel, Span};
use polhode_robot::read::{ReadOptions, read_model, read_text};
use polhode_robot::repair::proved;
use polhode_scenario::report::display::equivalent_box;
use polhode_source::FormatError;
use polhode_source::files::Files;
use serde::Serialize;
use serde_json::Value;

use super::links::{LinkShapes, NotShown};
use crate::refusal::{Refusal, RefusalKind};

/// Inspection of a robot: `RobotInspection` of `viewer/src/live/protocol.ts`.
#[derive(Debug, Serialize)]
pub struct RobotInspection {
    name: String,
    links: Vec<RobotLink>,
    findings: Vec<RobotFinding>,
    repair: Option<Repair>,
}

#[derive(Debug, Serialize)]
struct RobotLink {
    name: String,
    position: [f64; 3],
    quaternion: [f64; 4],
    /// Shapes as `Shape` of the page.
    shapes: Vec<Value>,
    inertial: Option<LinkInertial>,
    verdict: &'static str,
}

#[derive(Debug, PartialEq, Serialize)]
struct LinkInertial {
    mass: f64,
    center: [f64; 3],
    #[serde(rename = "box")]
    equivalent_box: Option<LinkBox>,
}

#[derive(Debug, PartialEq, Serialize)]
struct LinkBox {
    size: [f64; 3],
    quaternion: [f64; 4],
}

#[derive(Debug, Serialize)]
struct RobotFinding {
    link: Option<usize>,
    code: &'static str,
    severity: &'static str,
    message: String,
    /// File of the place, if it is a file that the model includes.
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<String>,
    line: usize,
    column: usize,
}

#[derive(Debug, Serialize)]
struct Repair {
    text: String,
    changes: Vec<Change>,
}

/// A line that the repair changes.
#[derive(Debug, PartialEq, Serialize)]
struct Change {
    line: usize,
    before: String,
    after: String,
}

impl RobotInspection {
    /// Inspects a file, which may open others in its own folder and in `roots`. `name` is for
    /// messages.
    pub(crate) fn of(
        name: &str,
        path: &Path,
        roots: Vec<PathBuf>,
        files: &dyn Files,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Self, Refusal> {
        let options = ReadOptions { files, confined: !roots.is_empty(), roots, ..ReadOptions::default() };
        let unreadable = |error: FormatError| {
            let place = error.place().map_or_else(String::new, |place| format!(", line {}", place.line));
            let message = format!("{name:?} cannot be read{place}: {}", error.message());
            let refusal = Refusal::new(RefusalKind::Unprocessable, message);
            match error.hint() {
                Some(hint) => refusal.hint(hint),
                None => refusal,
            }
        };
        let model = read_model(path, &options).map_err(unreadable)?;
        let shapes = Shapes::watched(goes_on).from_files(files);
        let found = inspect(&model, &shapes).findings;
        let at_rest = AtRest::of(&model);
        let numbers = numbers(&model);
        let places = Places::of(&model);
        let severities = severities(&found);
        let mut findings: Vec<RobotFinding> =
            found.iter().map(|one| RobotFinding::of(one, &numbers, &places)).collect();
        let unplaced = at_rest.unplaced.iter();
        findings.extend(unplaced.filter_map(|&k| RobotFinding::of_unplaced(&model, k, &places)));
        let LinkShapes { shapes: looks, not_shown } = LinkShapes::of(&model, &shapes);
        let is_said = |shape: &NotShown| {
            found.iter().any(|one| one.code == "geometry.unreadable" && one.span == shape.span)
        };
        let hidden = not_shown.iter().filter(|shape| !is_said(shape));
        findings.extend(hidden.map(|shape| RobotFinding::of_hidden(shape, &places)));
        let repaired = proved(&model, &found, |text| {
            read_text(text, path, &options).map(|model| inspect(&model, &shapes).findings)
        });
        // A repaired text that cannot be read again is not offered.
        let repair = repaired.ok().filter(|(repaired, _)| !repaired.applied.is_empty());
        let repair = repair.map(|(repaired, _)| Repair {
            changes: changes(&model.text, &repaired.text),
            text: repaired.text,
        });
        let links = model.links.iter().zip(at_rest.poses).zip(looks).map(|((link, pose), shapes)| {
            let severity = severities.get(link.name.text.as_str()).copied();
            let inertial = inertial(model.format, link);
            RobotLink {
                name: link.name.text.clone(),
                position: pose.position,
                quaternion: pose.rotation,
                shapes,
                verdict: match severity {
                    Some(Severity::Impossible) => "impossible",
                    Some(Severity::Suspect) => "suspect",
                    _ if link.inertial.is_none() => "none",
                    _ => "ok",
                },
                inertial,
            }
        });
        let links = links.collect();
        let name = model.name.clone().unwrap_or_else(|| name.to_owned());
        Ok(Self { name, links, findings, repair })
    }
}

/// Returns the index of the first link with each name.
fn numbers(model: &RobotModel) -> HashMap<&str, usize> {
    let mut numbers = HashMap::with_capacity(model.links.len());
    for (k, link) in model.links.iter().enumerate() {
        numbers.entry(link.name.text.as_str()).or_insert(k);
    }
    numbers
}

/// Returns the greatest severity found for each link.
fn severities(findings: &[Finding]) -> HashMap<&str, Severity> {
    let mut severities: HashMap<&str, Severity> = HashMap::new();
    for finding in findings {
        for name in std::iter::once(&finding.subject).chain(&finding.others) {
            let worst = severities.entry(name).or_insert(finding.severity);
            *worst = (*worst).max(finding.severity);
        }
    }
    severities
}

impl RobotFinding {
    /// Makes a finding at a place in the model's files.
    fn at(
        places: &Places<'_>,
        span: &Span,
        link: Option<usize>,
        [code, severity]: [&'static str; 2],
        message: String,
    ) -> Self {
        let FilePlace { file, is_included, line, column } = places.place(span);
        let name = file.file_name().unwrap_or(file.as_os_str());
        let file = is_included.then(|| name.to_string_lossy().into_owned());
        Self { link, code, severity, message, file, line, column }
    }

    fn of(finding: &Finding, numbers: &HashMap<&str, usize>, places: &Places<'_>) -> Self {
        let severity = match finding.severity {
            Severity::Impossible => "impossible",
            Severity::Suspect => "suspect",
            Severity::Note => "note",
        };
        let link = numbers.get(finding.subject.as_str()).copied();
        Self::at(places, &finding.span, link, [finding.code, severity], finding.message.clone())
    }

    fn of_hidden(shape: &NotShown, places: &Places<'_>) -> Self {
        let message = format!("a shape is not shown: {}", shape.why);
        Self::at(places, &shape.span, Some(shape.link), ["page.mesh", "note"], message)
    }

    fn of_unplaced(model: &RobotModel, link: usize, places: &Places<'_>) -> Option<Self> {
        let message =
            "it is shown at the origin, because its position relative to the other links is unknown"
                .to_owned();
        let span = &model.links.get(link)?.name.span;
        Some(Self::at(places, span, Some(link), ["page.unplaced", "note"], message))
    }
}

/// Returns mass, centre and equivalent box in the link's frame; `None` if mass or centre are
/// missing or invalid.
fn inertial(format: ModelFormat, link: &Link) -> Option<LinkInertial> {
    let written = link.inertial.as_ref()?;
    if let Ok(LinkMass::Body(body)) = link_mass(format, link) {
        let (properties, principal) = (&body.properties, PrincipalFrame::of(body.properties.inertia()));
        let size = equivalent_box(principal.moments(), properties.mass());
        return Some(LinkInertial {
            mass: properties.mass(),
            center: properties.center_of_mass().to_array(),
            equivalent_box: size
                .map(|size| LinkBox { size, quaternion: principal.rotation().canonical_quaternion() }),
        });
    }
    let center = written.pose.position;
    let is_placed = written.pose.unreadable.is_empty() && center.iter().all(|x| x.is_finite());
    let mass = written.mass.finite().filter(|_| is_placed)?;
    Some(LinkInertial { mass, center, equivalent_box: None })
}

/// Returns the lines that differ. Repairs change numbers within lines. If the number of lines
/// differs, everything from the first to the last difference is one change.
fn changes(before: &str, after: &str) -> Vec<Change> {
    let [old, new] = [before, after].map(|text| text.split('\n').collect::<Vec<_>>());
    let plain = |line: &str| line.trim_end_matches('\r').to_owned();
    if old.len() == new.len() {
        let differing = (1..).zip(old.iter().zip(&new)).filter(|(_, (before, after))| before != after);
        let change = |(line, (before, after)): (usize, (&&str, &&str))| Change {
            line,
            before: plain(before),
            after: plain(after),
        };
        return differing.map(change).collect();
    }
    let same = |pairs: &mut dyn Iterator<Item = (&&str, &&str)>| pairs.take_while(|(a, b)| a == b).count();
    let shorter = old.len().min(new.len());
    let head = same(&mut old.iter().zip(&new));
    let tail = same(&mut old.iter().rev().zip(new.iter().rev())).min(shorter - head);
    let middle = |lines: &[&str]| lines.get(head..lines.len() - tail).unwrap_or_default().join("\n");
    vec![Change { line: head + 1, before: middle(&old), after: middle(&new) }]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changed_lines_are_those_that_differ() {
        let change = |line, before: &str, after: &str| Change {
            line,
            before: before.to_owned(),
            after: after.to_owned(),
        };
        assert_eq!(changes("a\r\nb\r\nc\nd", "a\r\nB\r\nc\nD"), [change(2, "b", "B"), change(4, "d", "D")]);
        assert_eq!(changes("a\nb\nc", "a\nx\ny\nc"), [change(2, "b", "x\ny")]);
        assert_eq!(changes("a\na", "a\na\na"), [change(3, "", "a")]);
        assert_eq!(changes("a", "a"), []);
    }
}
