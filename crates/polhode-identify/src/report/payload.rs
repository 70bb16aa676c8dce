//! Report of payloads.

use polhode::body::{Finding, MassProperties, Severity};
use polhode::math::Body;
use polhode_document::VERSION;
use polhode_document::drawing::{Drawing, Scatter, Series};
use polhode_document::finding;
use polhode_document::layout::printable;
use polhode_document::number::{counted, number, with_error};
use polhode_document::{Document, Report, Section};
use polhode_source::toml::BodyPart;
use serde_json::{Value, json};

use super::scenario::NoBody;
use super::{PayloadReport, estimate, next};
use crate::ResidualTest;
use crate::payload::{Edge, EdgeKind, PayloadFinding, Thin};

/// Maximum number of left-out wrenches that are shown.
const SHOWN: usize = 10;
const AXES: [&str; 3] = ["x", "y", "z"];

impl Report for PayloadReport {
    fn to_json(&self) -> Value {
        let payload = &self.found;
        let free = &payload.unconstrained;
        let left = |left: &crate::payload::LeftOut| json!({ "row": left.row, "time": self.found.times.get(left.row), "size": left.size });
        json!({
            "polhode": VERSION,
            "kind": "payload",
            "title": self.title,
            "rows": self.found.times.len(),
            "body": payload.body.as_ref().map(body_to_json),
            "estimate": estimate::to_json(&payload.about_center),
            "about_origin": estimate::to_json(&payload.about_origin),
            "principal": payload.principal().map(|p| estimate::principal_to_json(&p)),
            "edge": payload.edge.as_ref().map(|edge| self.edge_to_json(edge)),
            "unconstrained": {
                "numbers": free.numbers,
                "is_possible": free.is_possible,
                "least_second_moment": free.least_second_moment,
                "chi_square_rise": free.chi_square_rise,
            },
            "residuals": estimate::residuals_to_json(&payload.tests),
            "row_residuals": payload.residuals,
            "next": self.next.as_ref().map(next::to_json),
            "left_out": payload.left_out.iter().map(left).collect::<Value>(),
            "findings": finding::to_json(&self.findings()),
        })
    }

    fn to_document(&self) -> Document {
        let numbers = &self.found.about_center.numbers;
        let of = |k: usize| numbers.get(k).map_or_else(String::new, |n| estimate::cell(n.value, n.sd));
        let is_known = |mut range: std::ops::Range<usize>| {
            range.all(|k| numbers.get(k).is_some_and(|number| number.sd.is_some()))
        };
        let mut answer = vec![match is_known(0..1) {
            true => format!("Mass {} kg", of(0)),
            false => "Mass not determined".to_owned(),
        }];
        answer.push(match is_known(1..4) {
            true => format!("Centre of mass ({}; {}; {}) m from the sensor's origin", of(1), of(2), of(3)),
            false => "Centre of mass not determined".to_owned(),
        });
        if let Some(p) = self.found.principal() {
            let of = |k: usize| estimate::cell(p.moments[k], p.moment_sd[k]);
            answer.push(match p.moment_sd.iter().all(Option::is_some) {
                true => format!(
                    "Principal moments about the centre of mass {}; {}; {} kg·m²",
                    of(0),
                    of(1),
                    of(2)
                ),
                false => "Principal moments about the centre of mass not determined".to_owned(),
            });
        }
        let mut sections = vec![self.read(), self.body()];
        sections.extend(self.found.edge.as_ref().map(|edge| self.edge(edge)));
        sections.extend([self.left(), self.unconstrained()]);
        sections.extend(self.next.as_ref().map(next::section));
        let findings = self.findings();
        Document {
            verdict: Some(estimate::verdict(&self.found.tests, &findings, &self.found.about_center)),
            title: printable(&self.title),
            answer,
            sections: estimate::numbered(sections),
            findings,
        }
    }

    /// Returns true if the residuals are larger than the noise or correlated.
    fn has_failed(&self) -> bool {
        self.found.tests.iter().any(ResidualTest::shows_model_error)
    }
}

impl PayloadReport {
    /// Returns the body as part of a scenario file.
    ///
    /// # Errors
    /// [`NoBody`] if it is not completely determined.
    pub fn to_scenario(&self) -> Result<String, NoBody> {
        let body = self.found.body.as_ref().ok_or(NoBody::Unknown { by: "the motion" })?;
        let meaning = "in kg, m, kg m^2, along the axes of the sensor, from its origin";
        Ok(BodyPart::of_body(format!("{}: {meaning}", self.title), "payload", body).to_toml())
    }

    fn findings(&self) -> Vec<Finding> {
        let payload = &self.found;
        let mut findings = estimate::model_findings(&payload.tests);
        let mut say = |code: &'static str, severity: Severity, message: String| {
            findings.push(estimate::finding(code, severity, message));
        };
        for found in &payload.findings {
            let (code, severity) = match found {
                PayloadFinding::NegativeMass { .. } => ("identify.mass", Severity::Warning),
                PayloadFinding::NotOfKind { .. } => ("identify.kind", Severity::Warning),
                PayloadFinding::GravityVaries { .. } => ("identify.gravity", Severity::Warning),
                PayloadFinding::UnusualGravity { .. } => ("identify.gravity", Severity::Info),
                PayloadFinding::Likely { .. } => ("identify.mistake", Severity::Warning),
                PayloadFinding::ManyOutliers { .. } => ("identify.outliers", Severity::Warning),
                _ => ("identify.impossible", Severity::Warning),
            };
            say(code, severity, found.to_string());
        }
        if !payload.left_out.is_empty() {
            let message = format!(
                "discarded {} of {} wrenches as outliers",
                payload.left_out.len(),
                self.found.times.len()
            );
            say("identify.outliers", Severity::Warning, message);
        }
        if let Some(edge) = &payload.edge {
            let message = format!(
                "the most likely physical payload is {}: within its error it has no extent in {}. In such directions, noise biases the estimate by half a \
                 standard deviation on average. If the payload is {}, state it in the plan: kind = \"{}\"",
                edge.kind,
                counted(edge.thin.len(), "direction"),
                edge.kind,
                kind_key(edge.kind)
            );
            say("identify.edge", Severity::Info, message);
        }
        if payload.body.is_none() {
            let message = "the motion does not determine the whole payload: parameters without an error are unobservable. Also rotate the wrist about other axes";
            say("identify.unknown", Severity::Warning, message.to_owned());
        }
        findings
    }

    fn read(&self) -> Section {
        let mut s = self.measured();
        let rows = counted(self.found.times.len(), "row");
        match (self.found.times.first(), self.found.times.last()) {
            (Some(first), Some(last)) => {
                s.say(format!("{rows}, from {} to {} s.", number(*first, 6), number(*last, 6)));
            }
            _ => s.say(format!("{rows}.")),
        }
        s
    }

    fn body(&self) -> Section {
        let mut s = Section::new(2, "Parameters");
        s.formula(
            "f = m (a − g) + α × h + ω × (ω × h), h = m c",
            "f = m (a - g) + \\alpha \\times h + \\omega \\times (\\omega \\times h),\\quad h = m c",
        );
        s.formula(
            "τ = h × (a − g) + I α + ω × I ω",
            "\\tau = h \\times (a - g) + I \\alpha + \\omega \\times I \\omega",
        );
        s.say("Mass, centre of mass relative to the sensor's origin, and inertia tensor about the centre of mass, along the sensor's axes:");
        estimate::table(&mut s, &self.found.about_center.numbers);
        estimate::relations(&mut s, &self.found.about_center);
        if let Some(p) = self.found.principal() {
            s.say("Principal moments about the centre of mass:");
            estimate::principal(&mut s, &p, Some("kg·m²"));
        }
        s
    }

    fn edge(&self, edge: &Edge) -> Section {
        let mut s = Section::new(3, "Limit of physical bodies");
        s.say(format!(
            "Noise makes small second moments of the payload negative. The most likely physical payload is {}: it has no extent in these directions.",
            edge.kind
        ));
        let mass = self.mass();
        let row = |thin: &Thin| {
            let mut row: Vec<String> = thin.direction.iter().map(|x| number(*x, 5)).collect();
            row.push(with_error(thin.unconstrained, thin.sd));
            row.push(number(thin.at_most, 3));
            row.push(number(thin.thickness_at_most(mass), 3));
            row
        };
        let headers = [
            AXES[0],
            AXES[1],
            AXES[2],
            "∫x² dm, unconstrained (kg·m²)",
            "upper bound (kg·m², 95 %)",
            "upper bound of the thickness (m)",
        ];
        s.table(&headers, edge.thin.iter().map(row).collect());
        match (&edge.along, edge.kind) {
            (Some(along), EdgeKind::Point) => estimate::table(&mut s, &along.numbers),
            (Some(along), kind) => {
                s.say(format!(
                    "Errors if the payload is {kind}; to estimate it as such, write kind = \"{}\" in the plan:",
                    kind_key(kind)
                ));
                estimate::table(&mut s, &along.numbers);
            }
            (None, _) => s.say("The measurements do not determine the errors of such a body."),
        }
        s
    }

    fn mass(&self) -> f64 {
        self.found.about_center.numbers.first().map_or(f64::NAN, |mass| mass.value)
    }

    fn left(&self) -> Section {
        let mut s = Section::new(4, "Residuals");
        estimate::residuals(&mut s, &self.found.tests);
        for scatter in self.scatters() {
            s.draw(Drawing::Scatter(scatter));
        }
        let all = &self.found.left_out;
        for left in all.iter().take(SHOWN) {
            let time = self.found.times.get(left.row).copied().unwrap_or(f64::NAN);
            s.line(format!(
                "discarded: row {} at {} s, {} times the noise",
                left.row + 1,
                number(time, 6),
                number(left.size, 3)
            ));
        }
        if all.len() > SHOWN {
            s.say(format!("--json lists {} more.", all.len() - SHOWN));
        }
        s
    }

    /// Returns plots of the residuals of forces and of torques against time.
    fn scatters(&self) -> impl Iterator<Item = Scatter> {
        let of = |(k, test): (usize, &ResidualTest)| {
            let points = |i: usize| {
                self.found.times.iter().zip(&self.found.residuals).map(|(t, r)| [*t, r[3 * k + i]]).collect()
            };
            let series = |i: usize| Series {
                name: format!("{}{}", ["f", "τ"][k], AXES[i]),
                mark: ['x', 'y', 'z'][i],
                points: points(i),
            };
            Scatter {
                title: format!("Residuals of the {}", test.what),
                across: ["t", "s"],
                up: ["measured − predicted", ["N", "N·m"][k]],
                series: vec![series(0), series(1), series(2)],
                band: 2.0 * test.noise,
                band_name: "± 2 standard deviations of the noise",
            }
        };
        self.found.tests.iter().enumerate().filter(|_| self.found.times.len() > 1).map(of)
    }

    fn unconstrained(&self) -> Section {
        let mut s = Section::new(5, "Comparison with unconstrained least squares");
        let free = &self.found.unconstrained;
        s.say(match (free.is_possible, free.least_second_moment) {
            (true, _) => "Unconstrained least squares gives the same body: it is physical.".to_owned(),
            (false, None) => "Unconstrained least squares gives a mass that is not positive.".to_owned(),
            (false, Some(least)) => format!(
                "Unconstrained least squares gives an unphysical body: its smallest ∫x² dm is {} kg·m².",
                number(least, 3)
            ),
        });
        if !free.is_possible || free.chi_square_rise > 0.0 {
            s.say(format!(
                "The constraint to physical bodies increases χ² by {}.",
                number(free.chi_square_rise, 3)
            ));
            let rows = self.found.about_origin.numbers.iter().zip(&free.numbers);
            let row = |(found, free): (&crate::Number, &f64)| {
                vec![
                    found.name.clone(),
                    estimate::number_cell(found),
                    number(*free, 5),
                    found.unit.to_owned(),
                ]
            };
            s.table(&["parameter", "constrained ± 1σ", "unconstrained", "unit"], rows.map(row).collect());
        }
        s
    }

    fn edge_to_json(&self, edge: &Edge) -> Value {
        let thin = |thin: &Thin| {
            json!({
                "direction": thin.direction,
                "unconstrained": thin.unconstrained,
                "sd": thin.sd,
                "at_most": thin.at_most,
                "thickness_at_most": thin.thickness_at_most(self.mass()),
            })
        };
        json!({
            "kind": kind_key(edge.kind),
            "thin": edge.thin.iter().map(thin).collect::<Value>(),
            "along": edge.along.as_ref().map(estimate::to_json),
        })
    }
}

/// Returns the kind as written in plans.
const fn kind_key(kind: EdgeKind) -> &'static str {
    match kind {
        EdgeKind::Lamina => "plate",
        EdgeKind::Rod => "rod",
        EdgeKind::Point => "point",
    }
}

fn body_to_json(body: &MassProperties<Body>) -> Value {
    json!({
        "mass": body.mass(),
        "center_of_mass": body.center_of_mass().to_array(),
        "inertia": body.inertia().matrix(),
    })
}
