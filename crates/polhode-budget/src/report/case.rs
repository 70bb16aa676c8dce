//! Computed results of a configuration.

use polhode::body::MassPropertiesGradient;
use polhode::math::{Body, Direction};

use super::changing::Changing;
use super::found::Found;
use crate::read::Questions;
use crate::{
    Basis, Budget, BudgetError, ComparedNumber, Comparison, Draws, Estimate, Evidence, Limit, LimitAnswers,
    LimitError, MassStatement, Measure, NUMBERS, PrincipalUncertainty, Sensitivities, Sensitivity, Subtotal,
    Tilt,
};

/// Configuration with its computed results.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub name: Option<String>,
    pub budget: Budget,
    /// Masses of each row.
    pub statements: Vec<MassStatement>,
    /// Estimates with the basic and with the predicted masses.
    estimates: [Estimate<Body>; 2],
    /// Principal moments and axes on the basis of the options. The draws have the same basis.
    pub principal: PrincipalUncertainty<Body>,
    /// Tilt of each principal axis.
    pub tilts: [AxisTilt; 3],
    pub results: Vec<SpreadResult>,
    pub drawn: Option<Drawn>,
    /// Results of the limits, if there are limits and draws.
    pub limits: Option<LimitAnswers>,
    /// Result of the search for ballast, if it is requested.
    pub ballast: Option<Found>,
    /// Body by tank fill and over time, if it has tanks or changes.
    pub changing: Option<Changing>,
    /// List without the liquid in its tanks, if there is any and differences are requested.
    pub dry: Option<Budget>,
}

/// Principal axis, and the frame axis with which it is compared.
#[derive(Clone, Debug)]
pub(crate) struct AxisTilt {
    /// Index of the frame axis, 0 to 2 for x, y, z.
    pub from: usize,
    pub direction: Direction<Body>,
    pub tilt: Tilt<Body>,
}

/// Number with its standard deviation to first order. The contributions to its variance are in
/// descending order.
#[derive(Clone, Debug)]
pub(crate) struct SpreadResult {
    pub name: String,
    pub unit: &'static str,
    pub of: ResultKind,
    pub sd: f64,
    pub by: Vec<Sensitivity>,
    /// Variance due to all other errors.
    pub rest: f64,
}

/// Kind of quantity of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ResultKind {
    /// Mass and centre of mass.
    Place,
    /// Inertia tensor about the centre of mass.
    Tensor,
    /// Principal moments and tilts.
    Principal,
    /// Quantity that is limited.
    Limit,
}

/// Random draws and their statistics.
#[derive(Clone, Debug)]
pub(crate) struct Drawn {
    pub draws: Draws,
    pub comparison: Comparison,
    /// Quantiles of the tilt of each principal axis at 5 %, 50 % and 95 %, rad.
    pub tilts: [Option<[f64; 3]>; 3],
}

/// Probabilities of the quantiles in [`Drawn::tilts`].
const QUANTILES: [f64; 3] = [0.05, 0.5, 0.95];

impl Case {
    /// Computes the results of a configuration. Calls `reached` with the number of bodies drawn so
    /// far.
    pub(crate) fn new(
        name: Option<String>,
        budget: Budget,
        limits: &[Limit],
        options: &Questions,
        reached: &mut dyn FnMut(usize),
    ) -> Result<Self, LimitError> {
        let statements = budget.mass_statements()?;
        let estimates = [budget.estimate(Basis::Basic)?, budget.estimate(Basis::Predicted)?];
        let estimate = &estimates[options.basis as usize];
        let principal = estimate.principal();
        let tilts = tilts(estimate, options);
        let results = results(&budget, options.basis, estimate, &tilts, limits)?;
        let count = options.draws.unwrap_or(0);
        let drawn = if count > 0 {
            let draws = budget.draws_watched(options.basis, options.seed, count, reached)?;
            let comparison = draws.compare(estimate);
            let is_finite = |one: &&ComparedNumber| one.sd.is_finite() && one.sd_error.is_finite();
            if let Some(one) = comparison.numbers.iter().find(|one| !is_finite(one)) {
                return Err(BudgetError::Variance { of: one.name }.into());
            }
            let quantiles = |k: usize| {
                let mut all = draws.tilts(k, tilts[k].direction)?;
                all.sort_by(f64::total_cmp);
                let last = all.len().checked_sub(1)?;
                Some(QUANTILES.map(|q| all[(q * last as f64).round() as usize]))
            };
            let tilts = [0, 1, 2].map(quantiles);
            Some(Drawn { draws, comparison, tilts })
        } else {
            None
        };
        let limits = match &drawn {
            Some(Drawn { draws, .. }) if !limits.is_empty() => {
                Some(tried(&budget, limits, options, &estimates, draws, reached)?)
            }
            _ => None,
        };
        Ok(Self {
            name,
            budget,
            statements,
            estimates,
            principal,
            tilts,
            results,
            drawn,
            limits,
            ballast: None,
            changing: None,
            dry: None,
        })
    }

    pub(crate) const fn estimate(&self, basis: Basis) -> &Estimate<Body> {
        &self.estimates[basis as usize]
    }

    /// Returns the subtotal that the list states for a row. It does not depend on the liquid in
    /// tanks.
    pub(crate) fn subtotal(&self, row: usize) -> Option<Subtotal> {
        self.dry.as_ref().unwrap_or(&self.budget).rows().subtotal(row)
    }

    pub(crate) fn principal(&self, basis: Basis) -> PrincipalUncertainty<Body> {
        self.estimate(basis).principal()
    }

    /// Returns a row's name without the root's path in front.
    pub(crate) fn short(&self, row: usize) -> &str {
        let rows = self.budget.rows();
        let (name, root) = (rows.name(row), rows.name(self.budget.root()));
        name.strip_prefix(root).and_then(|rest| rest.strip_prefix('/')).unwrap_or(name)
    }

    /// Returns the masses of the whole, all copies of the root counted.
    pub(crate) fn whole_statement(&self) -> MassStatement {
        self.statements[self.budget.root()]
    }

    /// Returns true if a part has a growth allowance.
    pub(crate) fn grows(&self) -> bool {
        self.statements.iter().any(|statement| statement.predicted != statement.basic)
            || (0..self.budget.rows().len()).any(|row| self.budget.rows().grows(row))
    }

    /// Iterates over the rows whose predicted mass exceeds the allowable mass.
    pub(crate) fn exceeded(&self) -> impl Iterator<Item = usize> + '_ {
        let is_beyond = |k: &usize| self.statements[*k].margin().is_some_and(|margin| margin < 0.0);
        (0..self.statements.len()).filter(is_beyond)
    }

    /// Returns the number of parts without errors, and the number of all parts.
    pub(crate) fn exact_parts(&self) -> (usize, usize) {
        let rows = self.budget.rows();
        let parts = || (0..rows.len()).filter(|row| rows.has_part(*row));
        (parts().filter(|row| rows.is_exact(*row)).count(), parts().count())
    }
}

/// Tests limits with the given draws, and with draws on the other basis if a limit needs it.
fn tried(
    budget: &Budget,
    limits: &[Limit],
    options: &Questions,
    estimates: &[Estimate<Body>; 2],
    draws: &Draws,
    reached: &mut dyn FnMut(usize),
) -> Result<LimitAnswers, LimitError> {
    let other = match options.basis {
        Basis::Basic => Basis::Predicted,
        Basis::Predicted => Basis::Basic,
    };
    let others = if limits.iter().any(|limit| limit.basis == other) {
        Some(budget.draws_watched(other, options.seed, draws.bodies.len(), reached)?)
    } else {
        None
    };
    let evidence = |basis: Basis| {
        let draws = if basis == options.basis { Some(draws) } else { others.as_ref() };
        draws.map(|draws| Evidence { estimate: &estimates[basis as usize], draws })
    };
    LimitAnswers::new(limits, LEVEL, evidence(Basis::Basic), evidence(Basis::Predicted))
}

/// Confidence level of the intervals of limits.
pub(crate) const LEVEL: f64 = 0.95;

/// Pairs the principal axes with the axes of the body, or with the requested axes. The sum of the
/// absolute cosines is the greatest possible.
fn tilts(estimate: &Estimate<Body>, options: &Questions) -> [AxisTilt; 3] {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let principal = estimate.principal();
    let unit = |k: usize| {
        let mut axis = [0.0; 3];
        axis[k] = 1.0;
        match options.axes {
            Some(r) => r * Direction::from_array(axis),
            None => Direction::from_array(axis),
        }
    };
    let near = |order: &[usize; 3]| -> f64 {
        (0..3).map(|k| principal.frame.axis(k).dot(unit(order[k])).abs()).sum()
    };
    let order = ORDERS
        .into_iter()
        .fold(ORDERS[0], |best, order| if near(&order) > near(&best) { order } else { best });
    [0, 1, 2].map(|k| {
        let direction = unit(order[k]);
        let unit = direction.direction().unwrap_or(direction);
        AxisTilt { from: order[k], direction, tilt: principal.tilt_from(estimate, k, unit) }
    })
}

fn results(
    budget: &Budget,
    basis: Basis,
    estimate: &Estimate<Body>,
    tilts: &[AxisTilt; 3],
    limits: &[Limit],
) -> Result<Vec<SpreadResult>, BudgetError> {
    let principal = estimate.principal();
    let mut asked: Vec<(String, &'static str, ResultKind, MassPropertiesGradient<Body>)> = NUMBERS
        .iter()
        .enumerate()
        .map(|(k, (name, unit))| {
            let of = if k < 4 { ResultKind::Place } else { ResultKind::Tensor };
            ((*name).to_owned(), *unit, of, number_gradient(k))
        })
        .collect();
    for k in (0..3).filter(|k| principal.is_first_order(*k)) {
        asked.push((format!("i{}", k + 1), "kg·m²", ResultKind::Principal, principal.moment_gradient(k)));
    }
    for (k, AxisTilt { from, tilt, .. }) in tilts.iter().enumerate() {
        if let Some(gradient) = tilt.gradient {
            let name = format!("tilt of {} from {}", k + 1, AXES[*from]);
            asked.push((name, "rad", ResultKind::Principal, gradient));
        }
    }
    // The mass is among the ten numbers above.
    for limit in limits.iter().filter(|limit| limit.basis == basis && limit.of != Measure::Mass) {
        if let Ok(gradient) = limit.of.gradient(estimate) {
            asked.push((limit.name.clone(), limit.of.unit(), ResultKind::Limit, gradient));
        }
    }
    let gradients: Vec<_> = asked.iter().map(|(.., gradient)| *gradient).collect();
    let found = budget.sensitivities(basis, &gradients, MOST_ERRORS)?;
    let result = |((name, unit, of, gradient), by): ((String, _, _, _), Sensitivities)| {
        let sd = estimate.sd_of(&gradient);
        let Sensitivities { greatest, rest, .. } = if sd > 0.0 { by } else { Sensitivities::default() };
        SpreadResult { name, unit, of, sd, by: greatest, rest }
    };
    Ok(asked.into_iter().zip(found).map(result).collect())
}

/// Largest number of errors of a result that are kept separately. No report shows more.
const MOST_ERRORS: usize = 1000;

pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];

/// Returns the gradient of one of the ten numbers.
fn number_gradient(k: usize) -> MassPropertiesGradient<Body> {
    let mut all = [0.0; 10];
    all[k] = 1.0;
    let [by_mass, x, y, z, by_inertia @ ..] = all;
    MassPropertiesGradient { by_mass, by_center_of_mass: Direction::new(x, y, z), by_inertia }
}
