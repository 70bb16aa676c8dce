//! Report of swing tests.

use polhode::body::{Finding, MassProperties, Severity};
use polhode::math::Body;
use polhode_document::VERSION;
use polhode_document::drawing::{Drawing, Scatter, Series};
use polhode_document::finding;
use polhode_document::layout::printable;
use polhode_document::number::{count, number, with_error};
use polhode_document::{Document, Report, Section};
use polhode_source::toml::BodyPart;
use serde_json::{Value, json};

use super::next::Named;
use super::scenario::NoBody;
use super::{SwingReport, estimate, mistakes, next};
use crate::swing::{Measurement, NextSwing, SwingResult, SwingTest};
use crate::{Number, ON_EARTH, PrincipalEstimate, ResidualTest};

/// Index of the first tensor element among the numbers.
const TENSOR: usize = 4;
/// Reporting threshold of negative damping, standard deviations. Identification itself refuses
/// five.
const GROWS: f64 = 3.0;
/// Width of a test's points, relative to the distance between tests.
const WIDTH: f64 = 0.6;

/// Returns a number with its error and its unit, if any.
fn with_unit(found: &Number, sd: f64) -> String {
    let unit = if found.unit == "1" { String::new() } else { format!(" {}", found.unit) };
    format!("{}{unit}", with_error(found.value, sd))
}

impl Report for SwingReport {
    fn to_json(&self) -> Value {
        let found = &self.found;
        let test = |test: &SwingResult| {
            json!({
                "name": test.name,
                "moment": test.moment.as_ref().map(|moment| json!({
                    "value": moment.value,
                    "sd": moment.sd,
                    "unit": moment.unit,
                })),
                "own": estimate::numbers_to_json(&test.own),
                "residuals": estimate::residuals_to_json(core::slice::from_ref(&test.residuals))[0],
                "left": test.left,
            })
        };
        json!({
            "polhode": VERSION,
            "kind": "swing",
            "title": self.title,
            "estimate": estimate::to_json(&found.estimate),
            "principal": self.is_known().then(|| estimate::principal_to_json(&self.principal())),
            "left_of_numbers": found.left_of_numbers,
            "widening": found.widening,
            "mistakes": mistakes::to_json(&found.mistakes),
            "residuals": found.counted.as_ref().map(|test| {
                estimate::residuals_to_json(core::slice::from_ref(test))[0].clone()
            }),
            "tests": found.tests.iter().map(test).collect::<Value>(),
            "next": self.next.as_ref().map(next::to_json),
            "findings": finding::to_json(&self.findings()),
        })
    }

    fn to_document(&self) -> Document {
        let p = self.principal();
        let mut answer = Vec::new();
        if self.is_known() {
            let of = |k: usize| estimate::cell(p.moments[k], p.moment_sd[k]);
            answer.push(format!("Principal moments {}; {}; {} kg·m²", of(0), of(1), of(2)));
        } else {
            for test in &self.found.tests {
                if let Some(Number { value, sd, unit, .. }) = &test.moment {
                    let (name, moment) = (printable(&test.name), estimate::cell(*value, *sd));
                    answer.push(format!("Moment of inertia in test “{name}”: {moment} {unit}"));
                }
            }
            answer.push(format!("The inertia tensor is not completely determined: {}", self.swung()));
        }
        let mut sections = vec![self.body(), self.each(), self.left()];
        sections.extend(self.next.as_ref().map(next::section));
        let findings = self.findings();
        Document {
            verdict: Some(estimate::verdict(self.found.model_tests(), &findings, &self.found.estimate)),
            title: self.title.clone(),
            answer,
            sections: estimate::numbered(sections),
            findings,
        }
    }

    /// Returns true if the residuals are larger than the noise or correlated.
    fn has_failed(&self) -> bool {
        self.found.model_tests().any(ResidualTest::shows_model_error)
    }
}

impl SwingReport {
    fn principal(&self) -> PrincipalEstimate {
        PrincipalEstimate::of_tensor(&self.found.estimate, TENSOR)
    }

    /// Returns the body as part of a scenario file.
    ///
    /// # Errors
    /// [`NoBody`] if it is not completely determined.
    pub fn to_scenario(&self) -> Result<String, NoBody> {
        let body = self.known().ok_or(NoBody::Unknown { by: "the set of swing tests" })?;
        let meaning = "in kg, m, kg m^2, along the axes of the body, from their origin";
        Ok(BodyPart::of_body(format!("{}: {meaning}", self.title), "body", &body).to_toml())
    }

    /// Returns the body if it is completely determined.
    pub fn known(&self) -> Option<MassProperties<Body>> {
        let mut numbers = self.found.estimate.numbers.iter().take(TENSOR + 6);
        numbers.all(|number| number.sd.is_some()).then_some(self.found.body)
    }

    /// Returns true if all elements of the tensor are determined.
    fn is_known(&self) -> bool {
        self.found.estimate.numbers[TENSOR..].iter().take(6).all(|number| number.sd.is_some())
    }

    fn findings(&self) -> Vec<Finding> {
        let mut findings = Vec::new();
        let mut say = |code: &'static str, message: String| {
            findings.push(estimate::finding(code, Severity::Warning, message));
        };
        if self.has_failed() {
            say(
                "identify.model",
                format!(
                    "the residuals are not noise: the model is incomplete. All errors are multiplied by {}; they are valid only if the missing effect acts like noise",
                    number(self.found.widening, 3)
                ),
            );
        }
        let unknown = self.found.estimate.unknown.len();
        if unknown > 0 {
            say(
                "identify.unknown",
                format!("these tests do not determine {}: {}", directions(unknown), self.swung()),
            );
        }
        if self.found.model_tests().next().is_none() {
            say(
                "identify.untested",
                "there are as many parameters as measurements: no residual can reveal a wrong model"
                    .to_owned(),
            );
        }
        for test in &self.found.tests {
            for damping in test.own.iter().filter(|number| number.name.ends_with("damping")) {
                let Some(sd) = damping.sd.filter(|sd| damping.value < -GROWS * sd) else { continue };
                let message = format!(
                    "the {} of “{}” is {}, {:.1} standard deviations below zero: an amplitude does not grow by itself",
                    damping.name,
                    test.name,
                    with_unit(damping, sd),
                    -damping.value / sd
                );
                say("identify.growing", message);
            }
        }
        if let Some(message) = mistakes::unseen(&self.found) {
            findings.push(estimate::finding("identify.unchecked", Severity::Info, message));
        }
        findings.extend(estimate::small_findings(self.found.model_tests()));
        let gravity = self.found.estimate.numbers.iter().find(|number| number.name == "gravity");
        if let Some(gravity) = gravity.filter(|gravity| !ON_EARTH.contains(&gravity.value)) {
            let message = format!("gravity is {} m/s², unlike that of the Earth", number(gravity.value, 6));
            findings.push(estimate::finding("identify.gravity", Severity::Info, message));
        }
        findings
    }

    /// Returns a sentence on the number of axes that were swung.
    fn swung(&self) -> String {
        let axes = self.found.tests.iter().filter(|test| test.moment.is_some()).count();
        match axes {
            0 => "no test includes the body".to_owned(),
            1 => "only the moment about one axis was measured".to_owned(),
            n => format!(
                "{n} tests include the body; a complete tensor needs six axes that are not all on one quadratic cone"
            ),
        }
    }

    fn body(&self) -> Section {
        let mut s = Section::new(1, "Parameters");
        for line in &self.sources {
            s.say(format!("{line}."));
        }
        s.say("The inertia tensor is about the centre of mass, along the body's axes. A parameter without an error was stated as exact.");
        let numbers: Vec<Number> = self
            .found
            .estimate
            .numbers
            .iter()
            .map(|number| Number { name: printable(&number.name), ..number.clone() })
            .collect();
        estimate::table(&mut s, &numbers);
        if self.is_known() {
            estimate::principal(&mut s, &self.principal(), Some("kg·m²"));
        } else {
            s.say("Principal moments and axes need the complete tensor and are omitted.");
        }
        estimate::relations(&mut s, &self.found.estimate);
        s
    }

    fn each(&self) -> Section {
        let mut s = Section::new(2, "Tests");
        s.say("The moment about the axis is nᵀ I n of the body alone, about the swing axis n moved to the centre of mass.");
        let mut rows = Vec::new();
        for test in &self.found.tests {
            let name = printable(&test.name);
            rows.extend(test.moment.iter().chain(&test.own).map(|number| {
                let value = estimate::number_cell(number);
                vec![name.clone(), number.name.clone(), value, number.unit.to_owned()]
            }));
        }
        s.table(&["test", "parameter", "value ± 1σ", "unit"], rows);
        s
    }

    fn left(&self) -> Section {
        let mut s = Section::new(3, "Residuals");
        match &self.found.counted {
            Some(test) => estimate::residuals(&mut s, core::slice::from_ref(test)),
            None if self.found.model_tests().next().is_none() => {
                s.say("There are as many parameters as measurements: no residual tests the model.");
            }
            None => {}
        }
        let row = |test: &SwingResult| {
            let left = &test.residuals;
            let rms = (left.reduced_chi_square * left.degrees_of_freedom / left.count.max(1) as f64).sqrt();
            vec![printable(&test.name), count(left.count as u64), number(rms, 3)]
        };
        let headers = ["test", "values", "rms residual (standard deviations)"];
        s.table(&headers, self.found.tests.iter().map(row).collect());
        if let Some(scatter) = self.scatter() {
            s.draw(Drawing::Scatter(scatter));
        }
        mistakes::table(&mut s, &self.found);
        s
    }

    /// Returns a plot of the residuals test by test; all values of a log are next to each other.
    fn scatter(&self) -> Option<Scatter> {
        let points = self.found.tests.iter().enumerate().flat_map(|(k, test)| {
            let count = test.left.len().max(1) as f64;
            let place = move |j: usize| (k + 1) as f64 + WIDTH * ((j as f64 + 0.5) / count - 0.5);
            test.left.iter().enumerate().map(move |(j, r)| [place(j), *r])
        });
        let points: Vec<[f64; 2]> = points.collect();
        let left = &self.found.left_of_numbers;
        let place = |j: usize| WIDTH * ((j as f64 + 0.5) / left.len() as f64 - 0.5);
        let numbers = left.iter().enumerate().map(|(j, r)| [place(j), *r]).collect();
        (points.len() > 1).then(|| Scatter {
            title: "Residuals by test, in the order of the plan".to_owned(),
            across: ["test", "1"],
            up: ["measured − predicted", "sd"],
            series: vec![
                Series { name: "times, then amplitudes, or log".to_owned(), mark: '•', points },
                Series {
                    name: "at 0: mass, centre and other measured inputs".to_owned(),
                    mark: 'o',
                    points: numbers,
                },
            ],
            band: 2.0,
            band_name: "± 2 standard deviations",
        })
    }
}

fn directions(count: usize) -> String {
    if count == 1 {
        "1 direction of the parameters".to_owned()
    } else {
        format!("{count} directions of the parameters")
    }
}

impl Named for NextSwing {
    fn name(&self) -> String {
        match self {
            Self::Test { like, test, .. } => {
                format!("a swing {} in the rig of “{}”", printable(&test.name), printable(like))
            }
            Self::Number { name, sd, unit } => {
                format!("another measurement of {} (± {} {unit})", printable(name), number(*sd, 2))
            }
        }
    }

    fn details(&self) -> Option<String> {
        match self {
            Self::Test { test, .. } => predicted(test),
            Self::Number { .. } => None,
        }
    }

    fn to_json(&self) -> Value {
        match self {
            Self::Test { about, like, test } => json!({
                "kind": "test",
                "about": about,
                "like": like,
                "predicted": counted(test),
            }),
            Self::Number { name, sd, unit } => {
                json!({ "kind": "number", "number": name, "sd": sd, "unit": unit })
            }
        }
    }
}

/// Returns text such as `expected time of 40 swings: 63.9 s`; `None` for a log.
fn predicted(test: &SwingTest) -> Option<String> {
    let Measurement::Counted(counted) = &test.measurement else { return None };
    let first = counted.intervals.first()?;
    Some(format!("expected time of {} swings: {} s", number(first.to - first.from, 4), number(first.time, 4)))
}

/// Returns predicted times and amplitudes; null for a log.
fn counted(test: &SwingTest) -> Value {
    let Measurement::Counted(counted) = &test.measurement else { return Value::Null };
    json!({
        "swings": counted.intervals.iter().map(|i| i.to - i.from).collect::<Vec<_>>(),
        "time_s": counted.intervals.iter().map(|i| i.time).collect::<Vec<_>>(),
        "amplitude_rad": counted.amplitudes.iter().map(|a| a.amplitude).collect::<Vec<_>>(),
    })
}
