//! Numerical form of the ballast problem: sites, limits, and violations of the limits.

use super::chart::{At, Chart};
use super::error::BallastError;
use super::row::{Functional, Moments, ONE, Row, Rule, Vector, rules, weights};
use super::{Ballast, Site};
use crate::budget::Budget;
use crate::growth::Basis;
use crate::limit::Limit;
use polhode::infer::covariance::dot;

/// Ballast problem in numerical form.
#[derive(Clone, Debug)]
pub(super) struct Problem {
    pub(super) charts: Vec<Chart>,
    /// Largest mass at each site, kg.
    pub(super) most: Vec<f64>,
    /// Sizes of pieces at each site, ascending, kg; empty if any mass is allowed.
    pub(super) sizes: Vec<Vec<f64>>,
    pub(super) rules: Vec<Rule>,
    /// Magnitude of each rule: its value without ballast, and its change by the least ballast.
    scales: Vec<f64>,
    /// Mass of the body, kg.
    pub(super) mass: f64,
    /// Largest mass of ballast that is searched, kg.
    pub(super) cap: f64,
}

/// Ballast at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lot {
    pub(super) site: usize,
    pub(super) at: At,
    /// Mass of all pieces, kg.
    pub(super) mass: f64,
    /// Mass of each piece, kg; `None` if any mass is allowed.
    pub(super) size: Option<f64>,
}

/// Largest mass of ballast that is searched, in masses of the body.
const CAP: f64 = 1e3;

/// Relative noise of a limit: of each term, and of the numbers whose difference the constant is.
///
/// Inequalities are tightened by the noise.
const NOISE: [f64; 2] = [1e-12, 8.0 * f64::EPSILON];

/// Largest violation of a limit that counts as met, in units of its noise: inequalities,
/// equalities.
const VIOLATION: [f64; 2] = [0.01, 10.0];

/// Relative amount by which a sum of sizes may exceed the largest mass of a site.
pub(super) const ROUNDING: f64 = 1e-14;

impl Problem {
    pub(super) fn new(budget: &Budget, ballast: &Ballast, limits: &[Limit]) -> Result<Self, BallastError> {
        if ballast.sites.is_empty() {
            return Err(BallastError::NoSites);
        }
        let question = |what, value, rule| BallastError::Value { site: None, what, value, rule };
        if !(ballast.deviations >= 0.0 && ballast.deviations.is_finite()) {
            let rule = "zero or positive, and finite";
            return Err(question("the margin in standard deviations", ballast.deviations, rule));
        }
        let estimates = [budget.estimate(Basis::Basic)?, budget.estimate(Basis::Predicted)?];
        let body = estimates[0].properties;
        let origin = body.center_of_mass().to_array();
        let sites = &ballast.sites;
        let charts = sites.iter().map(|site| Chart::new(site, origin)).collect::<Result<Vec<_>, _>>()?;
        let most = sites.iter().zip(&charts).map(|(site, chart)| capacity(site, chart));
        let (most, sizes) = most.collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
        let mass = body.mass();
        let (scales, cap) = (Vec::new(), CAP * mass);
        let mut problem = Self { charts, most, sizes, rules: Vec::new(), scales, mass, cap };
        problem.cap = problem.cap.min(problem.most.iter().sum());
        if let Some(most) = ballast.most {
            if !(most >= 0.0 && most.is_finite()) {
                return Err(question("the maximum ballast", most, "zero or positive, and finite"));
            }
            let of = Functional::ZERO.plus(most, &ONE).plus(-1.0, &Functional::MASS);
            problem.rules.push(Rule::Linear(Row::new(of, false)));
            problem.cap = problem.cap.min(most);
        }
        for limit in limits {
            limit.check()?;
            let estimate = &estimates[usize::from(limit.basis == Basis::Predicted)];
            problem.rules.extend(rules(limit, estimate, origin, ballast.deviations)?);
        }
        let is_finite = |row: &Row| row.of.by.iter().chain([&row.of.constant]).all(|x| x.is_finite());
        if !problem.rules.iter().all(|rule| is_finite(&rule.tangent(&[0.0; 10]))) {
            return Err(BallastError::NotFinite { quantity: "a coefficient of a limit" });
        }
        problem.scales = problem.scaled();
        Ok(problem)
    }

    /// Returns lots without mass at fixed points of all sites that take mass.
    pub(super) fn seeds(&self) -> Vec<Lot> {
        let sites = self.charts.iter().enumerate().filter(|(site, _)| self.most[*site] > 0.0);
        let seeds = |(site, chart): (usize, &Chart)| {
            chart.seeds().into_iter().map(move |at| Lot { site, at, mass: 0.0, size: None })
        };
        sites.flat_map(seeds).collect()
    }

    /// Returns the magnitude of each rule.
    fn scaled(&self) -> Vec<f64> {
        let rows: Vec<Row> = self.rules.iter().map(|rule| rule.tangent(&[0.0; 10])).collect();
        let change = |row: &Row| {
            let least = |of| self.charts.iter().map(|chart| chart.least(&of).1).fold(0.0, f64::min);
            -least(row.of).min(least(Functional::ZERO.plus(-1.0, &row.of)))
        };
        let changes: Vec<f64> = rows.iter().map(change).collect();
        let missing = |row: &Row| if row.is_zero { row.of.constant.abs() } else { -row.of.constant };
        let needed =
            rows.iter().zip(&changes).map(|(row, by)| if *by > 0.0 { missing(row) / by } else { 0.0 });
        let mass = needed.fold(0.0, f64::max);
        let scale = |(row, by): (&Row, &f64)| (row.of.constant.abs() + mass * by).max(f64::MIN_POSITIVE);
        rows.iter().zip(&changes).map(scale).collect()
    }

    /// Returns true if products about the moving centre are limited.
    pub(super) fn has_products(&self) -> bool {
        self.rules.iter().any(|rule| matches!(rule, Rule::Product { .. }))
    }

    /// Returns all conditions, linearized at given ballast.
    pub(super) fn tangents(&self, lots: &[Lot]) -> Vec<Row> {
        let ballast = self.moments(lots);
        let scaled = |(rule, scale): (&Rule, &f64)| Row { scale: *scale, ..rule.tangent(&ballast) };
        self.rules.iter().zip(&self.scales).map(scaled).collect()
    }

    /// Returns only the tangents of cones. They hold for all ballast.
    pub(super) fn cuts(&self, lots: &[Lot]) -> Vec<Row> {
        let rows = self.tangents(lots).into_iter().zip(&self.rules);
        rows.filter(|(_, rule)| matches!(rule, Rule::Cone(_))).map(|(row, _)| row).collect()
    }

    /// Returns the problem with linear relaxations of products, for ballast up to a mass.
    pub(super) fn relaxation(&self, cap: f64) -> Self {
        let end = |u: &Vector, body: &Moments, sign: f64| {
            let out = Functional::first(u.map(|u| -sign * u), [0.0; 3]);
            let far = self.charts.iter().map(|chart| -chart.least(&out).1).fold(f64::NEG_INFINITY, f64::max);
            let first = sign * dot(u, &[body[1], body[2], body[3]]);
            sign * (first / body[0]).max((first + cap * far) / (body[0] + cap))
        };
        let linear = |rule: &Rule| {
            let Rule::Product { axes, body, sign, is_zero, .. } = rule else { return vec![rule.clone()] };
            let [[a, c], [b, d]] = axes.map(|u| [-1.0, 1.0].map(|sign| end(&u, body, sign)));
            let side = |turn: f64| {
                let corners = if turn * sign > 0.0 { [[a, b], [c, d]] } else { [[a, d], [c, b]] };
                let of = |corner| Functional::ZERO.plus(turn, &rule.about(corner).of);
                corners.map(|corner| Rule::Linear(Row::new(of(corner), false)))
            };
            let turns: &[f64] = if *is_zero { &[1.0, -1.0] } else { &[1.0] };
            turns.iter().flat_map(|turn| side(*turn)).collect()
        };
        let rules = self.rules.iter().flat_map(linear).collect();
        let mut linear = Self { rules, cap, ..self.clone() };
        linear.scales = linear.scaled();
        linear
    }

    /// Returns the moments of ballast, from the origin of the problem.
    fn moments(&self, lots: &[Lot]) -> Moments {
        let mut all = [0.0; 10];
        for lot in lots {
            let w = weights(self.charts[lot.site].local(lot.at));
            all.iter_mut().zip(w).for_each(|(sum, w)| *sum += lot.mass * w);
        }
        all
    }

    /// Returns the value of a condition, and its rounding error.
    pub(super) fn value(&self, row: &Row, lots: &[Lot]) -> [f64; 2] {
        let at = |lot: &Lot| row.of.at(&weights(self.charts[lot.site].local(lot.at)));
        let terms = lots.iter().map(|lot| lot.mass * at(lot));
        let start = [row.of.constant, NOISE[0] * row.of.constant.abs() + NOISE[1] * row.of.size];
        terms.fold(start, |[value, noise], term| [value + term, noise + NOISE[0] * term.abs()])
    }

    /// Returns the total violation of the limits, each relative to its magnitude.
    pub(super) fn violation(&self, lots: &[Lot]) -> f64 {
        let violation = |row: &Row| {
            let [value, noise] = self.value(row, lots);
            (if row.is_zero { value.abs() - noise } else { 0.5 * noise - value }).max(0.0) / row.scale
        };
        self.tangents(lots).iter().map(violation).sum()
    }

    /// Returns true if the sites take the lots and all limits are met within rounding.
    pub(super) fn is_met(&self, lots: &[Lot]) -> bool {
        let holds = |row: &Row| {
            let [value, noise] = self.value(row, lots);
            (if row.is_zero { value.abs() } else { -value }) <= VIOLATION[usize::from(row.is_zero)] * noise
        };
        self.fits(lots) && self.tangents(lots).iter().all(holds)
    }

    /// Returns true if the sites take the lots. A point takes one piece of given size.
    pub(super) fn fits(&self, lots: &[Lot]) -> bool {
        (0..self.charts.len()).all(|site| {
            let own = lots.iter().filter(|lot| lot.site == site);
            let sum: f64 = own.clone().map(|lot| lot.mass).sum();
            let is_one = self.sizes[site].is_empty() || !self.charts[site].is_point();
            (is_one || own.count() <= 1) && sum <= self.most[site] * (1.0 + ROUNDING)
        })
    }
}

impl Lot {
    /// Returns the number of pieces.
    pub(super) fn count(&self) -> f64 {
        self.size.map_or(1.0, |size| (self.mass / size).round())
    }
}

pub(super) fn total(lots: &[Lot]) -> f64 {
    lots.iter().map(|lot| lot.mass).sum()
}

/// Returns the largest mass of a site, and the sizes of its pieces up to that mass, ascending, kg.
fn capacity(site: &Site, chart: &Chart) -> Result<(f64, Vec<f64>), BallastError> {
    let wrong = |what, value, rule| BallastError::Value { site: Some(site.name.clone()), what, value, rule };
    let most = site.most.unwrap_or(f64::INFINITY);
    if !(most >= 0.0) {
        return Err(wrong("the maximum mass", most, "zero or positive"));
    }
    if let Some(size) = site.sizes.iter().find(|size| !(**size > 0.0 && size.is_finite())) {
        return Err(wrong("a size", *size, "positive and finite"));
    }
    let mut sizes: Vec<f64> = site.sizes.iter().copied().filter(|size| *size <= most).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.dedup();
    let most = match sizes.last() {
        None if !site.sizes.is_empty() => 0.0,
        Some(largest) if chart.is_point() => *largest,
        _ => most,
    };
    Ok((most, sizes))
}
