//! The question in numbers: what sites and limits come to, in a region of sizes and centres.

use super::error::BallastError;
use super::interval::{Interval, dot};
use super::row::{Asked, Block, Coordinate, Functional, Kind, Moments, Product, asked, moments};
use super::site::Chart;
use super::{Ballast, Site};
use crate::budget::Budget;
use crate::growth::Basis;
use crate::limit::Limit;

/// Ballast to be found.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Problem {
    pub(super) origin: [f64; 3],
    /// Moments of the basic and of the predicted body.
    wholes: [Moments; 2],
    pub(super) charts: Vec<Chart>,
    pub(super) most: Vec<f64>,
    /// Of each site, from 0 on, or none where any mass will do.
    pub(super) sizes: Vec<Vec<f64>>,
    pub(super) blocks: Vec<Block>,
    pub(super) products: Vec<Product>,
    pub(super) coordinates: Vec<Coordinate>,
    /// No more ballast than this is looked for, kg.
    pub(super) cap: f64,
}

/// Part of what ballast may be: for each site that has sizes, from which to which of them; for each coordinate of the centre, between which values.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Region {
    pub(super) sizes: Vec<[usize; 2]>,
    pub(super) boxes: Vec<[f64; 2]>,
}

/// A piece of ballast.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Column {
    pub(super) site: usize,
    pub(super) at: [f64; 3],
}

/// No more ballast than so many times the mass of the body is looked for.
const CAP: f64 = 1e3;

impl Problem {
    pub(super) fn new(budget: &Budget, ballast: &Ballast, limits: &[Limit]) -> Result<Self, BallastError> {
        if ballast.sites.is_empty() {
            return Err(BallastError::NoSites);
        }
        let estimates = [budget.estimate(Basis::Basic)?, budget.estimate(Basis::Predicted)?];
        let origin = estimates[0].properties.center_of_mass().to_array();
        let wholes = [0, 1].map(|k| moments(&estimates[k].properties, origin));
        let mut problem = Self {
            origin,
            wholes,
            charts: ballast.sites.iter().map(Chart::new).collect::<Result<_, _>>()?,
            most: ballast.sites.iter().map(most).collect::<Result<_, _>>()?,
            sizes: Vec::new(),
            blocks: Vec::new(),
            products: Vec::new(),
            coordinates: Vec::new(),
            cap: CAP * estimates[0].properties.mass(),
        };
        for (site, chart) in ballast.sites.iter().zip(&problem.charts) {
            problem.sizes.push(sizes(site, chart)?);
        }
        let largest =
            problem.sizes.iter().zip(&problem.most).map(|(sizes, most)| sizes.last().unwrap_or(most));
        problem.cap = problem.cap.min(largest.map(|most| Interval::from(*most)).sum::<Interval>().high);
        let question = |what, value, rule| BallastError::Question { what, value, rule };
        if !(ballast.deviations >= 0.0 && ballast.deviations.is_finite()) {
            let rule = "zero or positive, and finite";
            return Err(question("the margin in standard deviations", ballast.deviations, rule));
        }
        if let Some(most) = ballast.most {
            if !(most >= 0.0 && most.is_finite()) {
                return Err(question("the most ballast", most, "zero or positive, and finite"));
            }
            let row = Functional::constant(most.into()) - Functional::mass();
            problem.blocks.push(Block::positive(row));
            problem.cap = problem.cap.min(most);
        }
        for limit in limits {
            limit.check()?;
            let (estimate, whole) = match limit.basis {
                Basis::Basic => (&estimates[0], &wholes[0]),
                Basis::Predicted => (&estimates[1], &wholes[1]),
            };
            match asked(limit, estimate, origin, ballast.deviations)? {
                Asked::Blocks(blocks) => problem.blocks.extend(blocks.into_iter().map(|mut block| {
                    block.rows.iter_mut().for_each(|row| *row = row.added_to(whole));
                    block
                })),
                Asked::Product { axes, least, most } => {
                    let coordinates = axes.map(|u| problem.coordinate(u, limit.basis));
                    problem.products.push(Product { axes, coordinates, basis: limit.basis, least, most });
                }
            }
        }
        Ok(problem)
    }

    fn coordinate(&mut self, along: [Interval; 3], basis: Basis) -> usize {
        let one = Coordinate { along, basis };
        self.coordinates.iter().position(|other| *other == one).unwrap_or_else(|| {
            self.coordinates.push(one);
            self.coordinates.len() - 1
        })
    }

    pub(super) const fn whole(&self, basis: Basis) -> &Moments {
        match basis {
            Basis::Basic => &self.wholes[0],
            Basis::Predicted => &self.wholes[1],
        }
    }

    /// All that ballast up to this mass may be.
    pub(super) fn root(&self, cap: f64) -> Region {
        let total = Interval::from(cap);
        let bounds = |coordinate: &Coordinate| {
            let [mass, x, y, z, ..] = *self.whole(coordinate.basis);
            let first = dot(&coordinate.along, &[x, y, z]);
            // The center goes from where it is towards the sites, the farther the more ballast there is.
            let end = |sign: f64| {
                let out = Functional::first(coordinate.along) * Interval::from(-sign);
                let least = self.charts.iter().map(|chart| chart.least(&out, self.origin).1);
                let far = Interval::from(-least.fold(f64::INFINITY, f64::min));
                let first = first * Interval::from(sign);
                let now = first.over(mass);
                sign * now.high.max((first + total * far).over(mass + total).high)
            };
            [end(-1.0), end(1.0)]
        };
        Region {
            sizes: self.sizes.iter().map(|sizes| [0, sizes.len().saturating_sub(1)]).collect(),
            boxes: self.coordinates.iter().map(bounds).collect(),
        }
    }

    /// Between which masses a site is.
    pub(super) fn masses(&self, region: &Region, site: usize, cap: f64) -> [f64; 2] {
        let sizes = &self.sizes[site];
        let [least, most] = region.sizes[site];
        match (sizes.get(least), sizes.get(most)) {
            (Some(least), Some(most)) => [*least, most.min(cap)],
            _ => [0.0, self.most[site].min(cap)],
        }
    }

    /// What all limits ask in a region, linear: of a product about the centre, (u·S)(v·S)/M is between the planes of McCormick (Math. Program. 10, 1976, 147) over the region's box.
    pub(super) fn rows(&self, region: &Region) -> Vec<Block> {
        let mut all = self.blocks.clone();
        for (coordinate, [low, high]) in self.coordinates.iter().zip(&region.boxes) {
            let whole = self.whole(coordinate.basis);
            let from = |x: f64| Functional::first(coordinate.along) - Functional::mass() * Interval::from(x);
            if low == high {
                all.push(Block { kind: Kind::Zero, rows: vec![from(*low).added_to(whole)] });
                continue;
            }
            all.push(Block::positive(from(*low).added_to(whole)));
            all.push(Block::positive((-from(*high)).added_to(whole)));
        }
        for product in &self.products {
            let ([u, v], whole) = (product.axes, self.whole(product.basis));
            let [a, b] = product.coordinates.map(|k| region.boxes[k].map(Interval::from));
            let plane = |a: Interval, b: Interval| {
                Functional::first(v) * a + Functional::first(u) * b - Functional::mass() * (a * b)
            };
            let integral = Functional::second(u, v);
            let fixed = a[0] == a[1] || b[0] == b[1];
            let planes = |pairs: [[usize; 2]; 2]| {
                let planes = pairs.map(|[i, j]| plane(a[i], b[j]));
                planes.into_iter().take(if fixed { 1 } else { 2 })
            };
            if fixed && product.least.is_some() && product.least == product.most {
                let bound = product.least.map_or(Interval::ZERO, Interval::from);
                let row = integral - plane(a[0], b[0]) - Functional::constant(bound);
                all.push(Block { kind: Kind::Zero, rows: vec![row.added_to(whole)] });
                continue;
            }
            // u·W v − most ≤ (u·S)(v·S)/M ≤ both planes that are above it
            for above in product.most.iter().flat_map(|_| planes([[1, 0], [0, 1]])) {
                let most = product.most.map_or(Interval::ZERO, Interval::from);
                all.push(Block::positive((Functional::constant(most) - integral + above).added_to(whole)));
            }
            for below in product.least.iter().flat_map(|_| planes([[0, 0], [1, 1]])) {
                let least = product.least.map_or(Interval::ZERO, Interval::from);
                all.push(Block::positive((integral - below - Functional::constant(least)).added_to(whole)));
            }
        }
        all
    }

    /// The moments of the whole with ballast.
    pub(super) fn with(&self, basis: Basis, pieces: &[(Column, f64)]) -> Moments {
        let mut all = *self.whole(basis);
        for (column, mass) in pieces {
            let by = super::row::weights(self.local(column.at));
            all.iter_mut().zip(by).for_each(|(sum, w)| *sum = *sum + Interval::from(*mass) * w);
        }
        all
    }

    /// From the origin of the problem.
    pub(super) fn local(&self, at: [f64; 3]) -> [Interval; 3] {
        core::array::from_fn(|k| Interval::from(at[k]) - Interval::from(self.origin[k]))
    }
}

impl Product {
    /// u·W v − (u·S)(v·S)/M
    pub(super) fn value(&self, moments: &Moments) -> Interval {
        let [u, v] = self.axes;
        let [mass, x, y, z, ..] = *moments;
        let s = [x, y, z];
        Functional::second(u, v).at(moments) - (dot(&u, &s) * dot(&v, &s)).over(mass)
    }
}

fn most(site: &Site) -> Result<f64, BallastError> {
    let most = site.most.unwrap_or(f64::INFINITY);
    if most >= 0.0 {
        return Ok(most);
    }
    let rule = "zero or positive";
    Err(BallastError::Value { site: site.name.clone(), what: "the most mass", value: most, rule })
}

/// The sizes that a site has, from 0 on, up to its most.
fn sizes(site: &Site, chart: &Chart) -> Result<Vec<f64>, BallastError> {
    let wrong = |what, value, rule| BallastError::Value { site: site.name.clone(), what, value, rule };
    if site.sizes.is_empty() {
        return Ok(Vec::new());
    }
    if !chart.is_point() {
        let rule = "none, but at points: give the points of a line, a disc or a circle where a piece may be";
        return Err(wrong("the number of sizes", site.sizes.len() as f64, rule));
    }
    if let Some(size) = site.sizes.iter().find(|size| !(**size > 0.0 && size.is_finite())) {
        return Err(wrong("a size", *size, "positive and finite"));
    }
    let mut all = vec![0.0];
    all.extend(site.sizes.iter().filter(|size| site.most.is_none_or(|most| **size <= most)));
    all.sort_by(f64::total_cmp);
    all.dedup();
    Ok(all)
}
