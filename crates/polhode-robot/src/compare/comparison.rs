//! Result of a comparison.

use polhode_document::json::pretty;
use polhode_document::{Document, Report};
use serde_json::{Map, Value, json};

use super::robot::Robot;
use crate::checked::{Checked, Format};
use crate::finding::{Finding, Related, Severity};
use crate::line_index::{FilePlace, Places};
use crate::model::{ModelFormat, RobotModel};
use crate::report::{CheckReport, format_name};

/// Differences of two models, in the order of the second file, then notes.
#[derive(Debug)]
pub struct Comparison {
    /// Second model with the differences as findings.
    pub(super) checked: Checked,
    /// First and second model.
    pub(super) summaries: [Summary; 2],
    pub(super) tolerance: f64,
}

/// Size of a model.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Summary {
    pub(super) path: String,
    format: ModelFormat,
    pub(super) links: usize,
    /// Number of joints that are not fixed.
    pub(super) joints: usize,
    /// Sum of all masses, kg.
    pub(super) mass: f64,
}

impl Summary {
    pub(super) fn of(robot: &Robot<'_>) -> Self {
        Self {
            path: robot.model.path.to_string_lossy().into_owned(),
            format: robot.model.format,
            links: robot.model.links.len(),
            joints: robot.moving(),
            mass: robot.mass(),
        }
    }

    fn to_json(&self) -> Value {
        json!({
            "file": self.path,
            "format": format_name(self.format).to_ascii_lowercase(),
            "links": self.links,
            "joints": self.joints,
            "mass": self.mass,
        })
    }
}

impl Comparison {
    /// Returns the differences.
    pub fn differences(&self) -> impl Iterator<Item = &Finding> {
        self.findings().filter(|finding| finding.severity > Severity::Note)
    }

    /// Returns the notes: other joint zeros, frames without a partner, skipped content.
    pub fn notes(&self) -> impl Iterator<Item = &Finding> {
        self.findings().filter(|finding| finding.severity == Severity::Note)
    }

    /// Returns true if the models agree within the tolerance.
    pub fn is_equal(&self) -> bool {
        self.differences().next().is_none()
    }

    /// Returns the result in an output format.
    pub fn to_form(&self, form: Format) -> String {
        match form {
            Format::Text | Format::Table => self.to_text(None),
            Format::Json => pretty(&self.to_json()) + "\n",
            Format::Html => self.to_document().to_html(),
            Format::Sarif | Format::Junit | Format::Github | Format::Gitlab | Format::Markdown => {
                self.checked.to_form(form)
            }
        }
    }

    /// Returns the second model.
    pub(super) fn model(&self) -> Option<&RobotModel> {
        self.checked.reports().next().map(|report| &report.model)
    }

    fn findings(&self) -> impl Iterator<Item = &Finding> {
        self.checked.reports().flat_map(CheckReport::findings)
    }
}

impl Report for Comparison {
    fn to_json(&self) -> Value {
        let places = self.model().map(Places::of);
        let value = |found: &Finding| finding(places.as_ref(), found);
        let [a, b] = &self.summaries;
        json!({
            "polhode": polhode_document::VERSION,
            "a": a.to_json(),
            "b": b.to_json(),
            "tolerance": self.tolerance,
            "equal": self.is_equal(),
            "differences": self.differences().map(value).collect::<Vec<_>>(),
            "notes": self.notes().map(value).collect::<Vec<_>>(),
        })
    }

    fn to_document(&self) -> Document {
        Document::of_text("Comparison of two robot models", &self.to_text(None))
    }

    fn to_text(&self, _columns: Option<usize>) -> String {
        self.text()
    }

    fn has_failed(&self) -> bool {
        !self.is_equal()
    }
}

fn finding(places: Option<&Places<'_>>, finding: &Finding) -> Value {
    let numbers: Map<String, Value> =
        finding.numbers.iter().map(|&(name, value)| (name.to_owned(), Value::from(value))).collect();
    // A finding about the first model only has no place in the second.
    let place = places.filter(|_| finding.span != (0..0)).map(|places| places.place(&finding.span));
    let of_b = place.map(|FilePlace { file, line, column, .. }| json!({ "file": file.to_string_lossy(), "line": line, "column": column }));
    let of_a = finding
        .related
        .as_ref()
        .map(|Related { file, line, column }| json!({ "file": file, "line": line, "column": column }));
    json!({
        "code": finding.code,
        "link": finding.subject,
        "others": finding.others,
        "message": finding.message,
        "numbers": numbers,
        "a": of_a,
        "b": of_b,
    })
}
