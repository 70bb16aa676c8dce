//! The report of `polhode spin --periods`: which spins have the two periods of a tumbling body.

use polhode::body::PrincipalFrame;
use polhode::math::{AngularVelocity, Body};
use polhode::observe::{AxisConvention, TumblerError, TumblingPeriods, TumblingSolution};
use polhode_document::SourceInfo;
use polhode_document::json::vector;
use polhode_document::layout::{labelled, plain_spaces};
use polhode_document::number::number;
use polhode_document::unit::DIGITS;
use polhode_document::unit::duration;
use serde_json::{Value, json};

use super::summary::tumbling;
use super::text::heading;
use super::{body, summary};
use crate::{VERSION, block, omega};

/// All spins of a body that have two periods, ready to be read.
///
/// ```
/// use polhode::body::{InertiaTensor, PrincipalFrame};
/// use polhode::observe::{AxisConvention, TumblingPeriods};
/// use polhode_report::TumblerReport;
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
    /// ω along the principal axes.
    spins: Vec<TumblingSolution>,
}

impl TumblerReport {
    /// Asks for the spins that a body with these principal moments can have.
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

    /// One screen for people.
    pub fn to_text(&self) -> String {
        let axis = match self.convention {
            AxisConvention::LongAxis => "the long axis, that of least moment",
            AxisConvention::ShortAxis => "the short axis, that of greatest moment",
        };
        let [precession, rotation] =
            [self.periods.precession, self.periods.rotation].map(|period| duration(period, 16));
        let given = format!("P_φ = {precession}, P_ψ = {rotation}, of {axis}");
        let found = match self.spins.len() {
            1 => "one spin has these periods, with its mirror images".to_owned(),
            n => format!("{n} spins have these periods, each with its mirror images"),
        };
        let mut text = heading(self.source.as_ref());
        text.push_str(&labelled("answer", &found));
        for (k, spin) in self.spins.iter().enumerate() {
            text.push_str(&labelled(&format!("spin {}", k + 1), spin.regime.description()));
            text.push_str(&labelled("", &omega::in_words(self.omega(spin))));
            let [ratio, momentum] = [spin.energy_ratio, spin.momentum].map(|x| number(x, DIGITS));
            let line = format!("T/T_min = E/E0 = {ratio}, |L| = {momentum} kg·m²/s");
            text.push_str(&labelled("", &line));
        }
        text.push_str(&labelled("periods", &given));
        text.push_str(&labelled("moments", &body::in_words(&self.principal)));
        plain_spaces(&text)
    }

    /// One object: what was given, and a list of spins.
    pub fn to_json(&self) -> Value {
        let convention = match self.convention {
            AxisConvention::LongAxis => "long_axis",
            AxisConvention::ShortAxis => "short_axis",
        };
        let spin = |spin: &TumblingSolution| {
            json!({
                "regime": spin.regime.name(),
                "energy_ratio": spin.energy_ratio,
                "momentum_kg_m2_s": spin.momentum,
                "omega_body": vector(self.omega(spin)),
                "periods": spin.periods.map(summary::tumbling),
            })
        };
        json!({
            "polhode": VERSION,
            "source": self.source.as_ref().map(SourceInfo::to_json),
            "principal": block::principal(&self.principal),
            "convention": convention,
            "periods": tumbling(self.periods),
            "spins": self.spins.iter().map(spin).collect::<Value>(),
        })
    }

    /// ω along body axes.
    fn omega(&self, spin: &TumblingSolution) -> AngularVelocity<Body> {
        let along = self.principal.axes().into_iter().zip(spin.omega.to_array());
        let parts = along.map(|(axis, rate)| AngularVelocity::from_array((axis * rate).to_array()));
        parts.fold(AngularVelocity::ZERO, |sum, part| sum + part)
    }
}
