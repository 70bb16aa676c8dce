//! Body of a configuration as input of other commands: a section of a scenario file, or a sweep
//! plan with its errors.

use core::fmt::Write as _;

use polhode::body::MassProperties;
use polhode::infer::correlated::Correlated;
use polhode::math::{AngularVelocity, Body};
use polhode_document::layout::printable;
use polhode_source::Failure;
use polhode_source::toml::BodyPart;

use super::BudgetReport;
use super::case::Case;
use super::numbers::ten;
use crate::Estimate;
use crate::read::{OverTime, Questions};

/// Duration of the motion of plan members without a sequence, s.
const DURATION: f64 = 60.0;

impl BudgetReport {
    /// Returns the body of a configuration. The configuration must be named if there are several.
    ///
    /// # Errors
    /// [`Failure`] if the configuration is not named or does not exist.
    pub fn body(&self, configuration: Option<&str>) -> Result<MassProperties<Body>, Failure> {
        self.case(configuration).map(|case| case.estimate(self.options.basis).properties)
    }

    /// Returns the body as a section of a scenario file.
    ///
    /// # Errors
    /// Same as [`BudgetReport::body`].
    pub fn to_scenario(&self, configuration: Option<&str>) -> Result<String, Failure> {
        let case = self.case(configuration)?;
        let estimate = case.estimate(self.options.basis);
        let mut part = self.part(case, estimate);
        if is_uncertain(estimate) {
            part.comments.push(
                "These values have correlated errors: polhode budget --sweep writes a plan that draws them"
                    .to_owned(),
            );
        }
        Ok(part.to_toml())
    }

    /// Returns a sweep plan whose members have the ten numbers of the body, with their covariance
    /// to first order. A tensor that is not physically possible is replaced by the nearest possible
    /// one.
    ///
    /// The plan has as many members as draws, with the same seed. Spin and duration are those of
    /// the sequence, if there is one.
    ///
    /// # Errors
    /// [`Failure`] if [`BudgetReport::body`] fails, if the body is known exactly, and if all mass
    /// is at one point.
    pub(crate) fn to_plan(
        &self,
        configuration: Option<&str>,
        questions: &Questions,
        begun: Option<&OverTime>,
    ) -> Result<String, Failure> {
        let case = self.case(configuration)?;
        let estimate = case.estimate(self.options.basis);
        if !is_uncertain(estimate) {
            return Err(Failure::usage(
                "no part has an uncertainty: there is nothing to draw",
                "add errors to the list, such as 1.2 ± 0.1 kg; --body prints the body without errors",
            ));
        }
        let has_extent = estimate.properties.inertia().matrix() != [[0.0; 3]; 3];
        if !has_extent && (4..10).all(|k| estimate.sd(k) == 0.0) {
            return Err(Failure::usage(
                "all mass is at one point: a point mass has no attitude",
                "give a part a size, or another position",
            ));
        }
        let mut toml = self.part(case, estimate).to_toml();
        let (members, seed) = (questions.draws.unwrap_or(Self::DRAWS), questions.seed);
        let spin = begun.and_then(|all| all.spin);
        let duration = begun.map_or(DURATION, |all| all.until);
        toml += match spin {
            Some(_) => "\n# Start of the sequence\n",
            None => "\n# At rest: enter the angular velocity and the duration\n",
        };
        let [x, y, z] = spin.unwrap_or(AngularVelocity::ZERO).to_array();
        let _ = write!(
            toml,
            "[start]\nspin = {{ body = [{x:?}, {y:?}, {z:?}] }}\n\n[run]\nduration = {duration:?}\nsamples = 61\n"
        );
        let law = Correlated::mass_first(
            ten(&estimate.properties).to_vec(),
            &estimate.covariance.map(|row| row.to_vec()),
        );
        let moved = law.map_or(0, |law| law.impossible(seed, TRIED));
        let _ = write!(
            toml,
            "\n[sweep]\nmembers = {members}\nsampling = \"monte carlo\"\nseed = {seed}\n\n\
             # Mass, centre of mass x, y, z, inertia xx, yy, zz, xy, xz, yz: in kg, m, kg m^2\n{}\
             [[sweep.vary]]\nkey = \"body\"\ncorrelated.impossible = \"nearest\"\ncorrelated.covariance = [\n",
            if moved > 0 {
                format!(
                    "# {moved} of {TRIED} test draws have an unphysical tensor, which is replaced with the nearest physical one\n"
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
        let basis = self.options.basis.name();
        let meaning = "in kg, m, kg m^2, in body axes, from their origin";
        let comment = format!("{}{title}, {basis} masses: {meaning}", self.title);
        BodyPart::of_body(comment, "whole", &estimate.properties)
    }

    fn case(&self, configuration: Option<&str>) -> Result<&Case, Failure> {
        let found = match (configuration, &self.cases[..]) {
            (None, [only]) => Some(only),
            (None, _) => None,
            (Some(name), cases) => cases.iter().find(|case| case.name.as_deref() == Some(name)),
        };
        let names: Vec<&str> = self.cases.iter().filter_map(|case| case.name.as_deref()).collect();
        found.ok_or_else(|| no_configuration(configuration, &names))
    }
}

/// Number of test draws from which a plan states how many tensors are replaced.
const TRIED: usize = 1000;

fn is_uncertain(estimate: &Estimate<Body>) -> bool {
    estimate.covariance != [[0.0; 10]; 10]
}

/// Returns the failure for a configuration that does not exist, or that is not named although there
/// are several.
pub(super) fn no_configuration(asked: Option<&str>, names: &[&str]) -> Failure {
    let there_are: Vec<String> = names.iter().map(|name| format!("\"{}\"", printable(name))).collect();
    let message = match asked {
        Some(name) => format!("unknown configuration \"{}\"", printable(name)),
        None => "the file has several configurations, but only one can be used".to_owned(),
    };
    let hint = match (names.is_empty(), asked) {
        (true, _) => "leave it out: the file has no configurations".to_owned(),
        (false, Some(_)) => format!("the file has {}", there_are.join(", ")),
        (false, None) => format!("name one of {}", there_are.join(", ")),
    };
    Failure::usage(message, hint)
}
