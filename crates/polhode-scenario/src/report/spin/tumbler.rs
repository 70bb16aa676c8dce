//! Report of `polhode spin --periods`: the spins that have the two periods of a tumbling body.

use polhode::body::PrincipalFrame;
use polhode::math::{AngularVelocity, Body};
use polhode::observe::{AxisConvention, TumblerError, TumblingPeriods, TumblingSolution};
use polhode_document::SourceInfo;
use polhode_document::fact::{Fact, Facts, Quantity, object};
use polhode_document::layout::plain_spaces;
use polhode_document::number::number;
use polhode_shape::report::block;
use serde_json::Value;

use super::{body, facts, text};
use crate::report::VERSION;
use crate::report::answer::DIGITS;

/// Report of all spins of a body that have two given periods.
///
/// ```
/// use polhode::body::{InertiaTensor, PrincipalFrame};
/// use polhode::observe::{AxisConvention, TumblingPeriods};
/// use polhode_scenario::report::TumblerReport;
/// let toutatis = PrincipalFrame::of(&InertiaTensor::diagonal([3.0836, 3.235, 1.0])?);
/// let periods = TumblingPeriods { precession: 7.40 * 86_400.0, rotation: 5.38 * 86_400.0 };
/// let report = TumblerReport::new(None, toutatis, periods, AxisConvention::LongAxis)?;
/// assert_eq!(report.to_json()["spins"][0]["regime"], "long_axis");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct TumblerReport {
    source: Option<SourceInfo>,
    principal: PrincipalFrame<Body>,
    periods: TumblingPeriods,
    convention: AxisConvention,
    /// Spins with ω along the principal axes.
    spins: Vec<TumblingSolution>,
}

impl TumblerReport {
    /// Computes the possible spins of a body with these principal moments.
    ///
    /// # Errors
    /// [`TumblerError`] as [`TumblingSolution::all`].
    pub fn new(
        source: Option<SourceInfo>,
        principal: PrincipalFrame<Body>,
        periods: TumblingPeriods,
        convention: AxisConvention,
    ) -> Result<Self, TumblerError> {
        let spins = TumblingSolution::all(principal.moments(), periods, convention)?;
        Ok(Self { source, principal, periods, convention, spins })
    }

    /// Returns the text of the report, at most one screen.
    pub fn to_text(&self) -> String {
        let head = text::head(self.source.as_ref(), "Spins with two given periods", &self.answer());
        let facts: String = self.facts().iter().map(|facts| facts.to_text(false)).collect();
        plain_spaces(&(head + &facts))
    }

    /// Returns a JSON object: the given periods, and a list of spins.
    pub fn to_json(&self) -> Value {
        let keys = ["polhode", "source", "principal", "convention", "periods", "spins"];
        Value::Object(object(&keys, &self.facts()))
    }

    /// Describes the kind and |ω| of each spin.
    fn answer(&self) -> String {
        let kinds = self.spins.iter().map(|spin| {
            let kind = spin.regime.description().split(':').next().unwrap_or_default();
            format!("{kind} with |ω| = {} rad/s", number(self.omega(spin).norm(), DIGITS))
        });
        let kinds = kinds.collect::<Vec<_>>().join(", or ");
        match self.spins.len() {
            1 => format!("One spin has these periods, with its mirror images: {kinds}."),
            n => format!("{n} spins have these periods, each with its mirror images: {kinds}."),
        }
    }

    /// Returns the facts about each spin, then the input.
    fn facts(&self) -> Vec<Facts> {
        let spins: Vec<Vec<Fact>> = self.spins.iter().map(|spin| self.spin(spin)).collect();
        let json = |facts: &Vec<Fact>| object(&[], &[Facts::new("", facts.clone())]).remove("spin");
        let json = spins.iter().map(json).collect::<Option<Value>>().unwrap_or_default();
        let (convention, axis) = match self.convention {
            AxisConvention::LongAxis => ("long_axis", "the long axis, that of least moment"),
            AxisConvention::ShortAxis => ("short_axis", "the short axis, that of greatest moment"),
        };
        let TumblingPeriods { precession, rotation } = self.periods;
        let period = |key: &str, label, seconds| {
            Fact::new(format!("periods.{key}"), label, Quantity::Duration(seconds)).digits(facts::DIGITS)
        };
        let given = vec![
            Fact::data("polhode", VERSION.to_owned()),
            Fact::data("source", self.source.as_ref().map(|source| source.to_json().into())),
            Fact::data("principal", block::principal(&self.principal)),
            Fact::data("convention", Quantity::Word(convention, String::new())),
            period("precession_period_s", "P_φ", precession).note(format!("precession of {axis}")),
            period("rotation_period_s", "P_ψ", rotation).note("rotation about this axis"),
            Fact::shown("moments", body::in_words(&self.principal)),
            Fact::data("spins", json),
        ];
        let titles = (1..).map(|k| format!("Spin {k}"));
        let shown = spins.into_iter().map(|facts| facts.into_iter().map(Fact::without_key).collect());
        let spins = titles.zip(shown).map(|(title, facts)| Facts::new(title, facts));
        spins.chain([Facts::new("Given", given)]).collect()
    }

    fn spin(&self, spin: &TumblingSolution) -> Vec<Fact> {
        let omega = self.omega(spin);
        let regime = Quantity::Word(spin.regime.name(), spin.regime.description().to_owned());
        let periods = spin.periods.map(|periods| facts::tumbling(periods).into());
        let fact = |key: &str, label, value| Fact::new(format!("spin.{key}"), label, value);
        vec![
            fact("regime", "free motion", regime),
            fact("energy_ratio", "T / least T", Quantity::Number(spin.energy_ratio, "")).note("E/E0"),
            fact("momentum_kg_m2_s", "|L|", Quantity::Number(spin.momentum, "kg·m²/s")),
            fact("omega_body", "ω", Quantity::Vector(omega.to_array(), "rad/s"))
                .note("in body axes, where ω along axis 2 is 0"),
            Fact::shown("|ω|", Quantity::Rate(omega.norm())),
            Fact::data("spin.periods", periods),
        ]
        .into_iter()
        .map(|fact| fact.digits(facts::DIGITS))
        .collect()
    }

    /// Returns ω along body axes.
    fn omega(&self, spin: &TumblingSolution) -> AngularVelocity<Body> {
        let along = self.principal.axes().into_iter().zip(spin.omega.to_array());
        let parts = along.map(|(axis, rate)| AngularVelocity::from_array((axis * rate).to_array()));
        parts.fold(AngularVelocity::ZERO, |sum, part| sum + part)
    }
}
