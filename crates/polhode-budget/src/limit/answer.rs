//! Results of limits: met or not met, margin and probability.

use polhode::math::Body;

use super::Limit;
use super::error::LimitError;
use super::share::{Share, normal};
use super::undefined::Undefined;
use crate::budget::Budget;
use crate::draws::Draws;
use crate::estimate::Estimate;
use crate::growth::Basis;

/// Settings of the test of limits by random draws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trial {
    /// Seed of the draws. The same seed gives the same draws.
    pub seed: u64,
    /// Number of draws.
    pub draws: usize,
    /// Confidence level of the intervals, for example 0.95.
    pub level: f64,
}

/// Estimate and draws of a body on one basis.
#[derive(Clone, Copy, Debug)]
pub struct Evidence<'a> {
    /// Estimate to first order.
    pub estimate: &'a Estimate<Body>,
    /// Random draws of the body.
    pub draws: &'a Draws,
}

/// Results of all limits of a list.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitAnswers {
    /// Result of each limit.
    pub answers: Vec<Answer>,
    /// Result of all limits together.
    pub all: AllMet,
}

/// Result of one limit.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// Value for the list as given.
    pub value: Result<f64, Undefined>,
    /// Standard deviation of the value to first order.
    pub sd: Result<f64, Undefined>,
    /// True if the list as given meets the limit; false without a value.
    pub met: bool,
    /// Margins to the least and to the greatest value, if given. A margin is negative if the limit
    /// is violated.
    pub margins: [Option<Margin>; 2],
    /// Probability that the limit is met, for a normal distribution with this value and standard
    /// deviation.
    pub first_order: Result<f64, Undefined>,
    /// Share of the draws that meet the limit. Draws without a value do not meet it.
    pub share: Share,
    /// True if the share differs significantly from first order. By chance, this happens about once
    /// in 16,000 times. `None` without a first-order result.
    pub differs: Option<bool>,
}

impl Answer {
    /// Returns the margin to the nearer bound.
    pub(crate) fn least_margin(&self) -> Option<Margin> {
        self.margins.into_iter().flatten().min_by(|a, b| a.value.total_cmp(&b.value))
    }
}

/// Margin between a value and a bound of a limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// Margin in the unit of the measure.
    pub value: f64,
    /// Margin in standard deviations; `None` if the standard deviation is unknown or zero.
    pub deviations: Option<f64>,
}

/// Result of all limits together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AllMet {
    /// True if the list as given meets all limits.
    pub met: bool,
    /// Share of the draws that meet all limits. Limits on both bases are tested in the same draw of
    /// the errors.
    pub share: Share,
    /// Bounds on the probability to first order, for any correlation of the limits: 1 − Σ (1 − p)
    /// and the least p. `None` if one limit has no first-order result.
    pub first_order: Option<[f64; 2]>,
}

/// Two-sided probability of four standard errors.
const SIGNIFICANT: f64 = 6.334_248_366_623_973e-5;

impl Budget {
    /// Tests whether limits are met.
    ///
    /// # Errors
    /// [`LimitError`] if a limit has no bound or an invalid number, if the confidence level is
    /// invalid, or if the list has no estimate or draws.
    pub fn limits(&self, limits: &[Limit], trial: Trial) -> Result<LimitAnswers, LimitError> {
        let on = |basis: Basis| -> Result<_, LimitError> {
            let asked = limits.iter().any(|limit| limit.basis == basis);
            // Without limits, the basic draws are still needed: each of them meets all limits.
            if !asked && (basis == Basis::Predicted || !limits.is_empty()) {
                return Ok(None);
            }
            Ok(Some((self.estimate(basis)?, self.draws(basis, trial.seed, trial.draws)?)))
        };
        let (basic, predicted) = (on(Basis::Basic)?, on(Basis::Predicted)?);
        fn evidence(of: &Option<(Estimate<Body>, Draws)>) -> Option<Evidence<'_>> {
            of.as_ref().map(|(estimate, draws)| Evidence { estimate, draws })
        }
        LimitAnswers::new(limits, trial.level, evidence(&basic), evidence(&predicted))
    }
}

impl LimitAnswers {
    /// Tests limits with the evidence on each basis that they use. The draws on both bases must
    /// have the same seed and number.
    ///
    /// # Errors
    /// [`LimitError`] if a limit has no bound or an invalid number, if the confidence level is
    /// invalid, if evidence on a basis is missing, or if the numbers of draws differ.
    pub fn new(
        limits: &[Limit],
        level: f64,
        basic: Option<Evidence<'_>>,
        predicted: Option<Evidence<'_>>,
    ) -> Result<Self, LimitError> {
        let counts = [basic, predicted].into_iter().flatten().map(|evidence| evidence.draws.bodies.len());
        let (fewest, most) = (counts.clone().min().unwrap_or(0), counts.max().unwrap_or(0));
        if fewest != most || fewest == 0 {
            return Err(LimitError::Draws { given: [fewest, most] });
        }
        let share = |met: usize| Share::new(met, most, level).ok_or(LimitError::Level { value: level });
        let mut all = vec![true; most];
        let mut answers = Vec::with_capacity(limits.len());
        for limit in limits {
            limit.check()?;
            let evidence = match limit.basis {
                Basis::Basic => basic,
                Basis::Predicted => predicted,
            };
            let evidence = evidence.ok_or(LimitError::Draws { given: [0, most] })?;
            let mut met = 0;
            for (all, body) in all.iter_mut().zip(&evidence.draws.bodies) {
                let holds = limit.of.value(body).is_ok_and(|value| limit.is_met(value));
                *all &= holds;
                met += usize::from(holds);
            }
            let answer = limit.answer(evidence.estimate, share(met)?);
            for (what, value) in [("the value", answer.value), ("the standard deviation", answer.sd)] {
                if let Ok(value) = value
                    && !value.is_finite()
                {
                    let rule = "finite: a point or an error is too large";
                    return Err(LimitError::Value { limit: limit.name.clone(), what, value, rule });
                }
            }
            answers.push(answer);
        }
        let least = answers.iter().map(|answer| answer.first_order.ok()).collect::<Option<Vec<f64>>>();
        let all = AllMet {
            met: answers.iter().all(|answer| answer.met),
            share: share(all.iter().filter(|met| **met).count())?,
            first_order: least.map(|all| {
                let missed: f64 = all.iter().map(|p| 1.0 - p).sum();
                [(1.0 - missed).max(0.0), all.iter().fold(1.0, |least: f64, p| least.min(*p))]
            }),
        };
        Ok(Self { answers, all })
    }
}

impl Limit {
    fn answer(&self, estimate: &Estimate<Body>, share: Share) -> Answer {
        let value = self.of.value(&estimate.properties);
        let sd = self.of.gradient(estimate).map(|gradient| estimate.sd_of(&gradient));
        let known = sd.ok().filter(|sd| *sd > 0.0);
        let margin = |by: f64| Margin { value: by, deviations: known.map(|sd| by / sd) };
        let least = value.ok().zip(self.least).map(|(value, least)| margin(value - least));
        let most = value.ok().zip(self.most).map(|(value, most)| margin(most - value));
        let met = value.is_ok_and(|value| self.is_met(value));
        let first_order = sd.map(|_| {
            if known.is_none() {
                return if met { 1.0 } else { 0.0 };
            }
            // Probability that one bound is violated. Both are small where they matter.
            let broken = |margin: Option<Margin>| {
                margin.and_then(|margin| margin.deviations).map_or(0.0, |z| normal(-z))
            };
            (1.0 - broken(least) - broken(most)).max(0.0)
        });
        let differs = first_order.ok().and_then(|p| {
            let [low, high] = Share::new(share.met, share.of, 1.0 - SIGNIFICANT)?.interval;
            Some(p < low || p > high)
        });
        Answer { value, sd, met, margins: [least, most], first_order, share, differs }
    }
}
