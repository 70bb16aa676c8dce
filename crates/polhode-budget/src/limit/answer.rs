//! Whether limits are met, with what margin and what probability.

use polhode::math::Body;

use super::Limit;
use super::error::LimitError;
use super::share::{Share, normal};
use super::undefined::Undefined;
use crate::budget::Budget;
use crate::draws::Draws;
use crate::estimate::Estimate;
use crate::growth::Basis;

/// How limits are tried by draws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trial {
    /// The same seed gives the same draws.
    pub seed: u64,
    /// How many.
    pub draws: usize,
    /// Level of confidence of the intervals, as 0.95.
    pub level: f64,
}

/// What is known of a body on one basis.
#[derive(Clone, Copy, Debug)]
pub struct Evidence<'a> {
    /// To first order.
    pub estimate: &'a Estimate<Body>,
    /// By draws.
    pub draws: &'a Draws,
}

/// The answers to all limits of a list.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitAnswers {
    /// One of each limit.
    pub answers: Vec<Answer>,
    /// All of them together.
    pub all: AllMet,
}

/// Whether a limit is met.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// Of the list as it is given.
    pub value: Result<f64, Undefined>,
    /// Its standard deviation to first order.
    pub sd: Result<f64, Undefined>,
    /// Whether the list as it is given meets the limit; not if there is no value.
    pub met: bool,
    /// What is left to the least and to the greatest value, where there is one: negative if the limit is broken.
    pub margins: [Option<Margin>; 2],
    /// The probability that it is met, of a normal distribution with this value and standard deviation.
    pub first_order: Result<f64, Undefined>,
    /// In how many draws it is met; not in those in which it has no value.
    pub share: Share,
    /// Whether the share differs from what first order says by more than chance makes it, which it does once in some 16,000 times; `None` where first order says nothing.
    pub differs: Option<bool>,
}

impl Answer {
    /// The margin to the nearer side.
    pub(crate) fn least_margin(&self) -> Option<Margin> {
        self.margins.into_iter().flatten().min_by(|a, b| a.value.total_cmp(&b.value))
    }
}

/// What is left to a limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// In the unit of the measure.
    pub value: f64,
    /// In standard deviations, where there is one that is not zero.
    pub deviations: Option<f64>,
}

/// Whether all limits are met at once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AllMet {
    /// Whether the list as it is given meets all.
    pub met: bool,
    /// In how many draws all are met: limits of both bases in the same draw of the errors.
    pub share: Share,
    /// Between which probabilities first order has it, however the limits are correlated: 1 − Σ (1 − p) and the least p. `None` where it says nothing of one.
    pub first_order: Option<[f64; 2]>,
}

/// The probability of four standard errors, either way.
const SIGNIFICANT: f64 = 6.334_248_366_623_973e-5;

impl Budget {
    /// Whether limits are met.
    ///
    /// # Errors
    /// [`LimitError`] of a limit that says nothing, of a level that is none, and where the list has no estimate or draws.
    pub fn limits(&self, limits: &[Limit], trial: Trial) -> Result<LimitAnswers, LimitError> {
        let on = |basis: Basis| -> Result<_, LimitError> {
            let asked = limits.iter().any(|limit| limit.basis == basis);
            // Without limits all are met in every draw.
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
    /// By what is known on each basis that limits are on: draws of the same seed, and as many.
    ///
    /// # Errors
    /// [`LimitError`] of a limit that says nothing, of a level that is none, of a basis of which nothing is known, and of different numbers of draws.
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
                    let rule = "finite: a point or an error is too far";
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
            // The probability of each side being broken: both are small where it matters.
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
