//! The question in numbers: what sites and limits come to, in a region of sizes and centres.

use super::chart::Chart;
use super::error::BallastError;
use super::interval::{Interval, dot};
use super::region::Region;
use super::row::{Asked, Block, Coordinate, Functional, Kind, Moments, Product, asked, moments};
use super::sums::Sums;
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
    /// Of the pieces of each site, ascending; none where any mass will do.
    pub(super) sizes: Vec<Vec<f64>>,
    /// What pieces at a site come to, if it has sizes.
    pub(super) sums: Vec<Option<Sums>>,
    /// What all ballast comes to, if all sites have sizes.
    pub(super) totals: Option<Sums>,
    pub(super) blocks: Vec<Block>,
    pub(super) products: Vec<Product>,
    pub(super) coordinates: Vec<Coordinate>,
    /// No more ballast than this is looked for, kg.
    pub(super) cap: f64,
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
            sizes: ballast.sites.iter().map(sizes).collect::<Result<_, _>>()?,
            sums: Vec::new(),
            totals: None,
            blocks: Vec::new(),
            products: Vec::new(),
            coordinates: Vec::new(),
            cap: CAP * estimates[0].properties.mass(),
        };
        let site = |k: usize| (&problem.charts[k], problem.most[k], &problem.sizes[k][..]);
        let sums = |(chart, most, sizes): (&Chart, f64, &[f64])| match sizes {
            [] => None,
            sizes if chart.is_point() => Some(Sums::of_one(&[&[0.0], sizes].concat())),
            sizes => Some(Sums::of_any(sizes, most.min(problem.cap))),
        };
        problem.sums = (0..problem.charts.len()).map(|k| sums(site(k))).collect();
        if problem.sums.iter().all(Option::is_some) {
            problem.totals =
                Some(Sums::totals(problem.sums.iter().flatten(), problem.sizes.iter().flatten().copied()));
        }
        let largest =
            problem.sums.iter().zip(&problem.most).map(|(sums, most)| {
                sums.as_ref().map_or(*most, |sums| sums.at(sums.len() - 1)[1].min(*most))
            });
        problem.cap = problem.cap.min(largest.map(Interval::from).sum::<Interval>().high);
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
        problem.require_finite()?;
        Ok(problem)
    }

    /// Refuses NaN and infinities before a solver sees them.
    fn require_finite(&self) -> Result<(), BallastError> {
        let is_finite = |x: &Interval| x.low.is_finite() && x.high.is_finite();
        if !self.wholes.iter().flatten().all(is_finite) {
            return Err(BallastError::NotFinite { quantity: "a moment of the parts list" });
        }
        let rows = self.blocks.iter().flat_map(|block| &block.rows);
        if !rows.flat_map(|row| [row.constant].into_iter().chain(row.by)).all(|x| is_finite(&x)) {
            return Err(BallastError::NotFinite { quantity: "a coefficient of a limit" });
        }
        Ok(())
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

    /// Between which values the coordinates of the centre are with ballast up to a mass.
    pub(super) fn boxes(&self, cap: f64) -> Vec<[f64; 2]> {
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
        self.coordinates.iter().map(bounds).collect()
    }

    /// All that ballast up to this mass may be.
    pub(super) fn root(&self, cap: f64) -> Region {
        let cells = (0..self.charts.len()).map(|site| self.cell(site, cap)).collect();
        Region { cells, boxes: self.boxes(cap) }
    }

    /// The least mass from one on that ballast can have.
    pub(super) fn attainable(&self, mass: f64) -> f64 {
        self.totals.as_ref().map_or(mass, |totals| totals.least_from(mass))
    }

    /// Whether several pieces of given sizes may be at a site, each at its own place.
    pub(super) fn has_free_pieces(&self, site: usize) -> bool {
        self.sums[site].is_some() && !self.charts[site].is_point()
    }

    /// By how much the least mass may be above what is proved, as a part of it.
    pub(super) fn gap(&self) -> f64 {
        let moves = self.totals.is_none() && (0..self.charts.len()).any(|site| self.has_free_pieces(site));
        if self.products.is_empty() && !moves { super::GAP } else { super::GAP_OF_PRODUCTS }
    }

    /// Whether limits in some region are not linear.
    pub(super) fn is_split(&self) -> bool {
        !self.products.is_empty() || self.sums.iter().any(Option::is_some)
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
        let fits = |size: &f64| *size <= most;
        return Ok(if site.sizes.is_empty() || site.sizes.iter().any(fits) { most } else { 0.0 });
    }
    let rule = "zero or positive";
    Err(BallastError::Value { site: site.name.clone(), what: "the most mass", value: most, rule })
}

/// The sizes that a site has, up to its most, ascending.
fn sizes(site: &Site) -> Result<Vec<f64>, BallastError> {
    if let Some(size) = site.sizes.iter().find(|size| !(**size > 0.0 && size.is_finite())) {
        let rule = "positive and finite";
        return Err(BallastError::Value { site: site.name.clone(), what: "a size", value: *size, rule });
    }
    let mut all: Vec<f64> =
        site.sizes.iter().copied().filter(|size| site.most.is_none_or(|most| *size <= most)).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    Ok(all)
}
