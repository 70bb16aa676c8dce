//! Report of tumbles.

use polhode::body::{Finding, Severity};
use polhode_document::VERSION;
use polhode_document::drawing::{Drawing, Scatter, Series};
use polhode_document::finding;
use polhode_document::layout::printable;
use polhode_document::number::{count, counted, number};
use polhode_document::{Document, Report, Section};
use polhode_source::toml::BodyPart;
use serde_json::{Value, json};

use super::next::Named;
use super::scenario::{BodySize, NoBody};
use super::{TumbleReport, estimate, next};
use crate::ResidualTest;
use crate::tumble::{Flaw, FlightFit, NextFlight};

/// Maximum number of flights shown in a table.
const SHOWN: usize = 40;
/// Duration of an exported scenario, turns.
const TURNS: f64 = 10.0;

impl Report for TumbleReport {
    fn to_json(&self) -> Value {
        let tumble = &self.found;
        let flight = |flight: &FlightFit| {
            json!({
                "name": flight.name,
                "time": flight.state.time,
                "omega": flight.state.omega.to_array(),
                "omega_sd": flight.omega_sd.map(|sd| Some(sd).filter(|sd| sd.is_finite())),
                "quaternion_wxyz": (!flight.attitude_residuals.is_empty())
                    .then(|| flight.state.attitude.canonical_quaternion()),
                "reduced_chi_square": flight.reduced_chi_square,
                "used": flight.used,
                "left_out": flight.left_out,
                "gyro_residuals": flight.gyro_residuals,
                "attitude_residuals": flight.attitude_residuals,
            })
        };
        json!({
            "polhode": VERSION,
            "kind": "tumble",
            "title": self.title,
            "scale_is_known": tumble.scale_is_known,
            "left_handed_ratios": tumble.left_handed_ratios(),
            "estimate": estimate::to_json(&tumble.estimate),
            "principal": estimate::principal_to_json(&tumble.principal),
            "widening": tumble.widening,
            "next": self.next.as_ref().map(next::to_json),
            "residuals": estimate::residuals_to_json(&tumble.residuals),
            "flights": tumble.flights.iter().map(flight).collect::<Value>(),
            "findings": finding::to_json(&self.findings()),
        })
    }

    fn to_document(&self) -> Document {
        let tumble = &self.found;
        let p = &tumble.principal;
        let mut answer = Vec::new();
        if tumble.scale_is_known {
            let of = |k: usize| estimate::cell(p.moments[k], p.moment_sd[k]);
            answer.push(format!("Principal moments {}; {}; {} kg·m²", of(0), of(1), of(2)));
        }
        answer.push(format!(
            "i1/i3 = {}, i2/i3 = {}",
            estimate::ratio_cell(p, 0),
            estimate::ratio_cell(p, 1)
        ));
        if !tumble.scale_is_known {
            answer.push("Free motion determines only the ratios of the moments, not their size".to_owned());
            answer.push(
                "For absolute values, throw the body once more with a part of known moments attached (in the plan: added = { moments = [...] } in this [[tumble.flight]]); or measure the greatest moment with a swing test and give it with the mass when the body is exported".to_owned(),
            );
        }
        let mut sections = vec![self.read(), self.body(), self.left(), self.each()];
        sections.extend(self.next.as_ref().map(next::section));
        let findings = self.findings();
        Document {
            verdict: Some(estimate::verdict(&tumble.residuals, &findings, &tumble.estimate)),
            title: self.title.clone(),
            answer,
            sections: estimate::numbered(sections),
            findings,
        }
    }

    /// Returns true if the residuals are larger than the noise or correlated.
    fn has_failed(&self) -> bool {
        self.found.residuals.iter().any(ResidualTest::shows_model_error)
    }
}

impl TumbleReport {
    /// Returns the body as part of a scenario file. The first flight is included if all flights
    /// were free.
    ///
    /// # Errors
    /// [`NoBody`] if a value is neither estimated nor stated.
    pub fn to_scenario(&self, size: &BodySize) -> Result<String, NoBody> {
        let tumble = &self.found;
        let is_known = [0, 1].iter().all(|&k| tumble.principal.undetermined_ratio(k).is_none())
            && tumble.estimate.numbers.iter().take(6).all(|number| number.undetermined().is_none());
        if !is_known {
            return Err(NoBody::Unknown { by: "the motion" });
        }
        let greatest = match (tumble.scale_is_known, size.greatest_moment) {
            (true, Some(_)) => return Err(NoBody::Found { what: "greatest-moment" }),
            (true, None) => 1.0,
            (false, given) => given.ok_or(NoBody::Size)?,
        };
        let mass = size.mass.ok_or(NoBody::Mass)?;
        let mut comments = vec![format!("{}: in kg, m, kg m^2, along the axes of the sensor", self.title)];
        comments.push(if tumble.scale_is_known {
            "Free motion does not determine the mass; it was stated.".to_owned()
        } else {
            format!("The motion determined the ratios of the moments. The greatest moment, {greatest:?} kg m^2, and the mass were stated.")
        });
        comments.push(
            "Free motion does not determine the centre of mass; it is placed at the origin.".to_owned(),
        );
        let inertia = core::array::from_fn(|k| greatest * tumble.estimate.numbers[k].value);
        let part = BodyPart { comments, name: "body", mass, center: [0.0; 3], inertia };
        Ok(part.to_toml() + &self.flown().unwrap_or_default())
    }

    /// Returns the start of the first flight as TOML, if the body was free in all flights.
    fn flown(&self) -> Option<String> {
        let has_drag = self.found.estimate.numbers.iter().any(|number| number.name.starts_with("drag"));
        let flight = self.found.flights.first().filter(|_| !self.found.scale_is_known && !has_drag)?;
        let [x, y, z] = flight.state.omega.to_array();
        let turns = TURNS * core::f64::consts::TAU / flight.state.omega.norm();
        Some(format!(
            "\n# Initial state of {}\n[start]\nspin = {{ body = [{x:?}, {y:?}, {z:?}] }}\n\n[run]\nduration = {turns:.3}\nsamples = 1001\n",
            printable(&flight.name)
        ))
    }

    fn findings(&self) -> Vec<Finding> {
        let mut findings = estimate::model_findings(&self.found.residuals);
        let mut say = |code: &'static str, message: String| {
            findings.push(estimate::finding(code, Severity::Warning, message));
        };
        for flaw in &self.found.flaws {
            let code = match flaw {
                Flaw::Saturated(_) => "identify.saturated",
                Flaw::Gap { .. } => "identify.gap",
                _ => "identify.hand",
            };
            say(code, flaw.to_string());
        }
        let left_out: usize = self.found.flights.iter().map(|flight| flight.left_out.len()).sum();
        let used: usize = self.found.flights.iter().map(|flight| flight.used).sum();
        if left_out > 0 {
            say(
                "identify.outliers",
                format!("discarded {left_out} of {} readings as outliers", left_out + used),
            );
        }
        let p = &self.found.principal;
        if p.thickness_sd.is_some_and(|sd| p.thickness < sd) {
            say(
                "identify.lamina",
                "within its error the body is a lamina (i1 + i2 = i3), the limit of physical bodies"
                    .to_owned(),
            );
        }
        findings
    }

    fn read(&self) -> Section {
        let mut s = self.measured();
        let readings: usize =
            self.found.flights.iter().map(|flight| flight.used + flight.left_out.len()).sum();
        s.say(format!("{}, {}.", counted(self.found.flights.len(), "flight"), counted(readings, "reading")));
        s
    }

    fn body(&self) -> Section {
        let mut s = Section::new(2, "Parameters");
        s.formula("I ω̇ = I ω × ω + N", "I \\dot\\omega = I \\omega \\times \\omega + N");
        let unit = self.found.scale_is_known.then_some("kg·m²");
        estimate::principal(&mut s, &self.found.principal, unit);
        if let Some([small, middle]) = self.found.left_handed_ratios() {
            s.say(format!(
                "The gyro's axes are assumed to be right-handed; free motion cannot verify it. With one axis reversed, i1/i3 = {} and i2/i3 = {}.",
                number(small, 4),
                number(middle, 4)
            ));
        }
        s.say("Inertia tensor along the sensor's axes, and the other estimated parameters:");
        estimate::table(&mut s, &self.found.estimate.numbers);
        estimate::relations(&mut s, &self.found.estimate);
        s
    }

    fn left(&self) -> Section {
        let mut s = Section::new(3, "Residuals");
        estimate::residuals(&mut s, &self.found.residuals);
        if let Some(scatter) = self.worst().and_then(|flight| self.scatter(flight)) {
            s.draw(Drawing::Scatter(scatter));
        }
        s
    }

    fn worst(&self) -> Option<&FlightFit> {
        self.found.flights.iter().max_by(|a, b| a.reduced_chi_square.total_cmp(&b.reduced_chi_square))
    }

    /// Returns a plot of a flight's residuals, reading by reading.
    fn scatter(&self, flight: &FlightFit) -> Option<Scatter> {
        let is_gyro = !flight.gyro_residuals.is_empty();
        let of = if is_gyro { &flight.gyro_residuals } else { &flight.attitude_residuals };
        let test = if is_gyro { self.found.residuals.first() } else { self.found.residuals.last() }?;
        let series = |i: usize| Series {
            name: ["x", "y", "z"][i].to_owned(),
            mark: ['x', 'y', 'z'][i],
            points: of.iter().enumerate().map(|(k, r)| [(k + 1) as f64, r[i]]).collect(),
        };
        (of.len() > 2).then(|| Scatter {
            title: format!("Residuals of {}, the flight with the worst fit", printable(&flight.name)),
            across: ["reading", "1"],
            up: ["measured − predicted", if is_gyro { "rad/s" } else { "rad" }],
            series: vec![series(0), series(1), series(2)],
            band: 2.0 * test.noise,
            band_name: "± 2 standard deviations of the noise",
        })
    }

    fn each(&self) -> Section {
        let mut s = Section::new(4, "Flights");
        let row = |flight: &FlightFit| {
            let [x, y, z] = flight.state.omega.to_array();
            let omega = [x, y, z].map(|w| number(w, 5)).join(", ");
            vec![
                printable(&flight.name),
                count(flight.used as u64),
                count(flight.left_out.len() as u64),
                omega,
                number(rms(flight), 3),
                number(flight.reduced_chi_square, 4),
            ]
        };
        let headers =
            ["flight", "readings", "discarded", "initial ω (rad/s)", "rms residual (rad/s)", "reduced χ²"];
        s.table(&headers, self.found.flights.iter().take(SHOWN).map(row).collect());
        if let Some(more) = self.found.flights.len().checked_sub(SHOWN + 1) {
            s.say(format!("--json lists {} more.", more + 1));
        }
        s
    }
}

/// Returns the root mean square residual of a gyro's components, rad/s; of attitudes, rad, without
/// a gyro.
fn rms(flight: &FlightFit) -> f64 {
    let of =
        if flight.gyro_residuals.is_empty() { &flight.attitude_residuals } else { &flight.gyro_residuals };
    let sum: f64 = of.iter().flatten().map(|r| r * r).sum();
    (sum / (3 * of.len()).max(1) as f64).sqrt()
}

impl Named for NextFlight {
    fn name(&self) -> String {
        let axes = self.about.iter().map(|part| part.abs()).collect::<Vec<_>>();
        let named = |least: f64| -> Vec<String> {
            axes.iter()
                .enumerate()
                .filter(|(_, part)| **part > least)
                .map(|(k, _)| format!("{}", k + 1))
                .collect()
        };
        let about = match named(0.9)[..] {
            [ref axis] => format!("about a direction 10° from axis {axis}"),
            _ => format!("about a direction between axes {}", named(0.3).join(", ")),
        };
        format!("a flight {about}")
    }

    fn details(&self) -> Option<String> {
        let omega = self.omega.map(|w| number(w, 3)).join(", ");
        Some(format!("initial ω = ({omega}) rad/s, otherwise as “{}”", printable(&self.like)))
    }

    fn to_json(&self) -> Value {
        json!({ "kind": "flight", "about": self.about, "omega": self.omega, "like": self.like })
    }
}
