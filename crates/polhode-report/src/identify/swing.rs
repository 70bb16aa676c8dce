//! Swing tests.

use polhode::body::{Finding, Severity};
use polhode_identify::swing::{SwingEstimate, SwingResult};
use polhode_identify::{Number, PrincipalEstimate};
use serde_json::{Value, json};

use super::estimate;
use crate::explain::document::{Document, Section};
use crate::layout::printable;
use crate::number::{count, number};
use crate::{VERSION, finding};

/// A body that was found by its swings.
#[derive(Clone, Debug)]
pub struct SwingReport {
    title: String,
    found: SwingEstimate,
    principal: PrincipalEstimate,
    /// What was read, line by line.
    sources: Vec<String>,
}

/// Where the tensor's elements begin among the numbers.
const TENSOR: usize = 4;

impl SwingReport {
    /// Of what was found.
    pub fn new(title: Option<&str>, found: SwingEstimate) -> Self {
        let principal = PrincipalEstimate::of_tensor(&found.estimate, TENSOR);
        Self {
            title: title.unwrap_or("a body that swings").to_owned(),
            found,
            principal,
            sources: Vec::new(),
        }
    }

    /// With the lines that say what was read of logs.
    #[must_use]
    pub fn with_sources(self, sources: Vec<String>) -> Self {
        Self { sources, ..self }
    }

    /// True if what is left is more than noise.
    pub fn has_model_error(&self) -> bool {
        let logs = self.found.tests.iter().map(|test| &test.residuals);
        // of counted swings only all together are a test
        logs.filter(|test| test.lag_correlation.is_some())
            .chain(&self.found.counted)
            .any(|test| test.is_too_large() || test.is_correlated())
    }

    /// What is known of the tensor: its elements that have an error.
    fn is_known(&self) -> bool {
        self.found.estimate.numbers[TENSOR..].iter().take(6).all(|number| number.sd.is_some())
    }

    fn findings(&self) -> Vec<Finding> {
        let mut findings = Vec::new();
        let mut say = |code: &'static str, message: String| {
            findings.push(Finding { code, severity: Severity::Warning, message, place: None });
        };
        if self.has_model_error() {
            say(
                "identify.model",
                format!(
                    "what is left is no noise: errors are widened {}-fold, and hold only if what is missing acts like noise",
                    number(self.found.widening, 3)
                ),
            );
        }
        let unknown = self.found.estimate.unknown.len();
        if unknown > 0 {
            say(
                "identify.unknown",
                format!("{} are not determined by these tests: {}", directions(unknown), self.swung()),
            );
        }
        let is_logged = self.found.tests.iter().any(|test| test.residuals.lag_correlation.is_some());
        if self.found.counted.is_none() && !is_logged {
            say(
                "identify.untested",
                "as much is found as was measured: nothing is left that could show a wrong model".to_owned(),
            );
        }
        findings
    }

    /// How many axes were swung.
    fn swung(&self) -> String {
        let axes = self.found.tests.iter().filter(|test| test.moment.is_some()).count();
        match axes {
            0 => "no test has the body".to_owned(),
            1 => "only one axis was swung".to_owned(),
            n => format!(
                "{n} tests have the body, where a whole tensor takes six axes that are not all on one quadratic cone"
            ),
        }
    }

    /// The report as a document: text, Markdown, a page.
    pub fn to_document(&self) -> Document {
        let p = &self.principal;
        let mut answer = Vec::new();
        if self.is_known() {
            let of = |k: usize| estimate::cell(p.moments[k], p.moment_sd[k]);
            answer.push(format!("Principal moments {}; {}; {} kg·m²", of(0), of(1), of(2)));
        } else {
            answer.push(format!("The whole tensor is not known: {}", self.swung()));
        }
        for test in &self.found.tests {
            if let Some(Number { value, sd, unit, .. }) = &test.moment {
                answer.push(format!("{}: {} {unit}", printable(&test.name), estimate::cell(*value, *sd)));
            }
        }
        let mut sections = vec![self.body(), self.each(), self.left()];
        for (k, section) in sections.iter_mut().enumerate() {
            section.number = u8::try_from(k + 1).unwrap_or(u8::MAX);
        }
        Document { title: self.title.clone(), answer, sections, findings: self.findings() }
    }

    fn body(&self) -> Section {
        let mut s = Section::new(1, "The body");
        for line in &self.sources {
            s.say(format!("{line}."));
        }
        s.say("The tensor is about the centre of mass, along the body's axes; a number without an error was given as exact.");
        let numbers: Vec<Number> = self
            .found
            .estimate
            .numbers
            .iter()
            .map(|number| Number { name: printable(&number.name), ..number.clone() })
            .collect();
        estimate::table(&mut s, &numbers);
        if self.is_known() {
            estimate::principal(&mut s, &self.principal, Some("kg·m²"));
        } else {
            s.say("Principal moments and axes are left out: they need the whole tensor.");
        }
        estimate::relations(&mut s, &self.found.estimate);
        s
    }

    fn each(&self) -> Section {
        let mut s = Section::new(2, "Test by test");
        s.say("The moment is nᵀ I n of the body alone, about the axis n of the swing through the body's centre of mass.");
        let mut rows = Vec::new();
        for test in &self.found.tests {
            let name = printable(&test.name);
            rows.extend(test.moment.iter().chain(&test.own).map(|number| {
                let value = estimate::cell(number.value, number.sd);
                vec![name.clone(), number.name.clone(), value, number.unit.to_owned()]
            }));
        }
        s.table(&["test", "number", "value ± sd", "unit"], rows);
        s
    }

    fn left(&self) -> Section {
        let mut s = Section::new(3, "What is left");
        match &self.found.counted {
            Some(test) => estimate::residuals(&mut s, core::slice::from_ref(test)),
            None => s.say("As much was found as was measured: no residual tests the model."),
        }
        let row = |test: &SwingResult| {
            let left = &test.residuals;
            let rms = (left.reduced_chi_square * left.degrees_of_freedom / left.count.max(1) as f64).sqrt();
            vec![printable(&test.name), count(left.count as u64), number(rms, 3)]
        };
        let headers = ["test", "numbers", "left (standard deviations, rms)"];
        s.table(&headers, self.found.tests.iter().map(row).collect());
        s
    }

    /// The report as data.
    pub fn to_json(&self) -> Value {
        let found = &self.found;
        let numbers = |numbers: &[Number]| -> Value {
            let each = |n: &Number| json!({ "name": n.name, "unit": n.unit, "value": n.value, "sd": n.sd });
            numbers.iter().map(each).collect()
        };
        let test = |test: &SwingResult| {
            json!({
                "name": test.name,
                "moment": test.moment.as_ref().map(|moment| json!({
                    "value": moment.value,
                    "sd": moment.sd,
                    "unit": moment.unit,
                })),
                "own": numbers(&test.own),
                "residuals": estimate::residuals_to_json(core::slice::from_ref(&test.residuals))[0],
            })
        };
        json!({
            "polhode": VERSION,
            "kind": "swing",
            "title": self.title,
            "estimate": estimate::to_json(&found.estimate),
            "principal": self.is_known().then(|| estimate::principal_to_json(&self.principal)),
            "widening": found.widening,
            "residuals": found.counted.as_ref().map(|test| {
                estimate::residuals_to_json(core::slice::from_ref(test))[0].clone()
            }),
            "tests": found.tests.iter().map(test).collect::<Value>(),
            "findings": finding::to_json(&self.findings()),
        })
    }
}

fn directions(count: usize) -> String {
    if count == 1 {
        "one direction of the numbers".to_owned()
    } else {
        format!("{count} directions of the numbers")
    }
}
