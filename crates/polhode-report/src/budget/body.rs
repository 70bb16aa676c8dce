//! The body of a configuration, for other commands: as a part of a scenario, and with its errors as a plan of a sweep.

use core::fmt::{self, Write as _};

use polhode::body::MassProperties;
use polhode::math::{AngularVelocity, Body};
use polhode_budget::{Correlated, Estimate};
use polhode_document::layout::printable;

use super::case::{Case, ten};
use super::{BudgetReport, basis_name};
use crate::body_part::BodyPart;

/// What a plan of a sweep has besides the body and its errors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanOptions {
    /// How many members there are.
    pub members: usize,
    /// Of their draws.
    pub seed: u64,
    /// What the body has at first; it is at rest without.
    pub spin: Option<AngularVelocity<Body>>,
    /// For how long it moves, s.
    pub duration: f64,
}

/// There is no such configuration, or it has to be said which.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoConfiguration {
    /// What was asked for.
    pub asked: Option<String>,
    /// What there is.
    pub names: Vec<String>,
}

/// Why there is no plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoPlan {
    /// Of no body.
    Configuration(NoConfiguration),
    /// No number of the body has an error.
    Exact,
    /// Of a point, which has no attitude.
    Point,
}

impl BudgetReport {
    /// The body of a configuration, which has to be said if there are several.
    ///
    /// # Errors
    /// [`NoConfiguration`] without it, or of another.
    pub fn body(&self, configuration: Option<&str>) -> Result<MassProperties<Body>, NoConfiguration> {
        self.case(configuration).map(|case| case.estimate(self.options.basis).properties)
    }

    /// The body as a part of a scenario file.
    ///
    /// # Errors
    /// As [`BudgetReport::body`].
    pub fn to_scenario(&self, configuration: Option<&str>) -> Result<String, NoConfiguration> {
        let case = self.case(configuration)?;
        let estimate = case.estimate(self.options.basis);
        let mut part = self.part(case, estimate);
        if is_uncertain(estimate) {
            part.comments.push(
                "Its numbers have errors that are correlated: polhode budget --sweep writes a plan that draws them".to_owned(),
            );
        }
        Ok(part.to_toml())
    }

    /// A plan of a sweep whose members have the body's ten numbers with their covariance to first order; of a tensor that is no body's the nearest that is.
    ///
    /// # Errors
    /// [`NoPlan`] where [`BudgetReport::body`] gives none, of a body that is known exactly, and of a point.
    pub fn to_plan(&self, configuration: Option<&str>, options: &PlanOptions) -> Result<String, NoPlan> {
        let case = self.case(configuration).map_err(NoPlan::Configuration)?;
        let estimate = case.estimate(self.options.basis);
        if !is_uncertain(estimate) {
            return Err(NoPlan::Exact);
        }
        let has_extent = estimate.properties.inertia().matrix() != [[0.0; 3]; 3];
        if !has_extent && (4..10).all(|k| estimate.sd(k) == 0.0) {
            return Err(NoPlan::Point);
        }
        let mut toml = self.part(case, estimate).to_toml();
        let PlanOptions { members, seed, spin, duration } = options;
        toml += match spin {
            Some(_) => "\n# As its sequence begins\n",
            None => "\n# At rest: write how it turns, and for how long\n",
        };
        let [x, y, z] = spin.unwrap_or(AngularVelocity::ZERO).to_array();
        let _ = write!(
            toml,
            "[start]\nspin = {{ body = [{x:?}, {y:?}, {z:?}] }}\n\n[run]\nduration = {duration:?}\nsamples = 61\n"
        );
        let law = Correlated::mass_first(ten(&estimate.properties).to_vec(), &covariance_rows(estimate));
        let moved = law.map_or(0, |law| law.impossible(*seed, TRIED));
        let _ = write!(
            toml,
            "\n[sweep]\nmembers = {members}\nsampling = \"monte carlo\"\nseed = {seed}\n\n\
             # Mass, centre of mass x, y, z, inertia xx, yy, zz, xy, xz, yz: in kg, m, kg m^2\n{}\
             [[sweep.vary]]\nkey = \"body\"\ncorrelated.impossible = \"nearest\"\ncorrelated.covariance = [\n",
            if moved > 0 {
                format!(
                    "# By it {moved} of {TRIED} draws have a tensor that is no body's, and become the nearest that is\n"
                )
            } else {
                String::new()
            }
        );
        for row in estimate.covariance {
            let elements = row.map(|x| format!("{x:?}"));
            let _ = writeln!(toml, "    [{}],", elements.join(", "));
        }
        toml += "]\n";
        Ok(toml)
    }

    fn part(&self, case: &Case, estimate: &Estimate<Body>) -> BodyPart<'static> {
        let title = case.name.as_ref().map_or_else(String::new, |name| format!(", {name}"));
        let basis = basis_name(self.options.basis);
        let meaning = "in kg, m, kg m^2, along the axes of the body, from their origin";
        let comment = format!("{}{title}, {basis} masses: {meaning}", self.title);
        BodyPart::of_body(comment, "whole", &estimate.properties)
    }

    fn case(&self, configuration: Option<&str>) -> Result<&Case, NoConfiguration> {
        let found = match (configuration, &self.cases[..]) {
            (None, [only]) => Some(only),
            (None, _) => None,
            (Some(name), cases) => cases.iter().find(|case| case.name.as_deref() == Some(name)),
        };
        found.ok_or_else(|| NoConfiguration {
            asked: configuration.map(str::to_owned),
            names: self.cases.iter().filter_map(|case| case.name.clone()).collect(),
        })
    }
}

/// Draws that are tried, so that a plan says how many are moved.
const TRIED: usize = 1000;

fn covariance_rows(estimate: &Estimate<Body>) -> Vec<Vec<f64>> {
    estimate.covariance.iter().map(|row| row.to_vec()).collect()
}

fn is_uncertain(estimate: &Estimate<Body>) -> bool {
    estimate.covariance != [[0.0; 10]; 10]
}

impl NoConfiguration {
    /// What to do.
    pub fn hint(&self) -> String {
        let names: Vec<String> = self.names.iter().map(|name| format!("\"{}\"", printable(name))).collect();
        match (names.is_empty(), &self.asked) {
            (true, _) => "leave it out: the file has no configurations".to_owned(),
            (false, Some(_)) => format!("there are {}", names.join(", ")),
            (false, None) => format!("name one of {}", names.join(", ")),
        }
    }
}

impl fmt::Display for NoConfiguration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.asked {
            Some(name) => write!(f, "there is no configuration \"{}\"", printable(name)),
            None => f.write_str("there are several configurations, and a body is one of them"),
        }
    }
}

impl std::error::Error for NoConfiguration {}

impl NoPlan {
    /// What to do.
    pub fn hint(&self) -> String {
        match self {
            Self::Configuration(why) => why.hint(),
            Self::Exact => {
                "write errors into the list, such as 1.2 ± 0.1 kg; --body has the body as it is".to_owned()
            }
            Self::Point => "give a part its extent, or its place beside another".to_owned(),
        }
    }
}

impl fmt::Display for NoPlan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Configuration(why) => why.fmt(f),
            Self::Exact => f.write_str("no part has an uncertainty: there is nothing to draw"),
            Self::Point => {
                f.write_str("all mass is at one point, which has no attitude: no member could turn")
            }
        }
    }
}

impl std::error::Error for NoPlan {}
