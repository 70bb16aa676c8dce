//! Proof that no ballast is lighter, or that none exists, and its check.
//!
//! Every limit is a function f ≥ 0 (or = 0, or in a cone) of the moments, f = β + Σ m a(r) over pieces of the mass m at r. With prices y, none negative (or free, or in the cone), every ballast that meets
//! all limits has
//!
//! ```text
//! Σ m ≥ Σ m − y·f = −y·β + Σ m d(r),  d(r) = 1 − y·a(r)
//! ```
//!
//! and d, quadratic in r, has a least value at each site, which is found and bounded. So the prices alone say what no ballast can be below: the dual bound. Without the first Σ m it is zero that is above
//! the right side, and if that is positive, there is no ballast at all. Where sizes or products about the moving centre make limits that are not linear, this holds in each region of a tree. There a part of a
//! site has masses from one to another, and so have parts of parts: what a part may take has a price too. If all pieces have sizes, the bound is the next sum of them.

use super::interval::Interval;
use super::problem::Problem;
use super::region::Region;
use super::row::{Functional, Kind};

/// What is proved of a region.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Tree {
    /// By prices of all rows.
    Leaf(Prices),
    /// In each of two regions that make up this one.
    Split { branch: Branch, below: Box<Tree>, above: Box<Tree> },
    /// With a part of a site parted where a coordinate has a value.
    Parted { cell: usize, axis: usize, at: f64, rest: Box<Tree> },
}

/// Prices of what limits ask.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Prices {
    /// In kg per unit of each row; or, where none exists, in any unit.
    pub(super) of: Vec<f64>,
    /// Of the mass in each cell that is parted.
    pub(super) of_cells: Vec<f64>,
    /// Whether they bound the mass, and do not show that there is no ballast.
    pub(super) of_mass: bool,
}

/// Where a region is split.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Branch {
    /// A cell has this sum at most, or the next at least.
    Sum { cell: usize, index: usize },
    /// A coordinate of the centre is this at most, or at least.
    Center { coordinate: usize, at: f64 },
}

impl Problem {
    /// What no ballast in a region is below, of those that are no more than `cap`: infinite if there is none.
    pub(super) fn proved(&self, tree: &Tree, region: &Region, cap: f64) -> f64 {
        if region.is_empty() {
            return f64::INFINITY;
        }
        match tree {
            Tree::Leaf(prices) => self.bound(prices, region, cap),
            Tree::Split { branch, below, above } => {
                let [lower, upper] = self.split(region, *branch);
                self.proved(below, &lower, cap).min(self.proved(above, &upper, cap))
            }
            Tree::Parted { cell, axis, at, rest } => {
                self.proved(rest, &self.parted(region, *cell, *axis, *at), cap)
            }
        }
    }

    /// The same by prices: never above what is true, whatever they are.
    pub(super) fn bound(&self, prices: &Prices, region: &Region, cap: f64) -> f64 {
        let Some(sum) = self.weighed(&prices.of, region) else { return 0.0 };
        let one = if prices.of_mass { Interval::ONE } else { Interval::ZERO };
        let price = Functional { constant: Interval::ZERO, ..Functional::mass() * one - sum };
        let mut bound = -sum.constant;
        // Σ (d − π) m + π Σ m, with π the prices of the cells that a part is in.
        let owners = region.owners();
        let price_of =
            |cell: usize| prices.of_cells.get(cell).copied().map_or(Interval::ZERO, Interval::from);
        for (k, cell) in region.cells.iter().enumerate() {
            let (mut owner, mut own) = (owners[k], Interval::ZERO);
            if cell.parts.is_empty() {
                own = Interval::from(cell.chart.least(&price, self.origin).1);
                while let Some(k) = owner {
                    own = own - price_of(k);
                    owner = owners[k];
                }
            } else {
                own = own + price_of(k);
            }
            let [least, most] = [cell.masses[0], cell.masses[1].min(cap)];
            bound =
                bound + Interval::from(if own.low < 0.0 { most } else { least }) * Interval::from(own.low);
        }
        match (prices.of_mass, bound.low > 0.0) {
            (false, true) => f64::INFINITY,
            (true, true) if self.attainable(bound.low) <= cap => self.attainable(bound.low),
            (true, true) => f64::INFINITY,
            _ => 0.0,
        }
    }

    /// y·f, if the prices are such that it cannot be negative.
    fn weighed(&self, prices: &[f64], region: &Region) -> Option<Functional> {
        let mut prices = prices.iter().copied();
        let mut sum = Functional::constant(Interval::ZERO);
        for block in self.rows(region) {
            let own: Vec<f64> = prices.by_ref().take(block.rows.len()).collect();
            let (first, rest) = own.split_first()?;
            let holds = match block.kind {
                Kind::Zero => own.iter().all(|y| y.is_finite()),
                Kind::Positive => own.iter().all(|y| *y >= 0.0 && y.is_finite()),
                Kind::Cone => {
                    let square = rest.iter().map(|y| Interval::from(*y).square()).sum::<Interval>();
                    first.is_finite() && *first >= square.sqrt().high
                }
            };
            if !holds || own.len() != block.rows.len() {
                return None;
            }
            for (row, y) in block.rows.iter().zip(own) {
                sum = sum + *row * Interval::from(y);
            }
        }
        prices.next().is_none().then_some(sum)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]
mod tests {
    use polhode::math::{Body, Direction, Position};

    use super::*;
    use crate::ballast::{Ballast, BallastAnswer, BallastPlace, Site};
    use crate::{Basis, GivenPart, Limit, Measure, PartsList, Row};

    fn asked(sites: &[[f64; 3]]) -> BallastAnswer {
        let point = GivenPart::point(5.0, Position::new(0.03, -0.02, 0.4));
        let list = PartsList { rows: vec![Row::part("body", point)], ..PartsList::default() };
        let along = Direction::<Body>::new(0.0, 0.0, 1.0);
        let limit = Limit {
            name: "centre".to_owned(),
            of: Measure::CenterFromLine { point: Position::ZERO, along },
            least: None,
            most: Some(0.004),
            basis: Basis::Basic,
        };
        let site = |at: &[f64; 3]| Site::new("site", BallastPlace::Point(Position::from_array(*at)));
        let ballast = Ballast { sites: sites.iter().map(site).collect(), ..Ballast::default() };
        list.budget().unwrap().ballast(&ballast, &[limit]).unwrap()
    }

    fn prices(tree: &mut Tree) -> &mut Prices {
        let Tree::Leaf(prices) = tree else { panic!() };
        prices
    }

    #[test]
    fn other_prices_prove_nothing() {
        let BallastAnswer::Least(good) = asked(&[[-0.6, 0.2, 0.1], [0.1, 0.7, -0.3], [-0.4, 0.5, 0.2]])
        else {
            panic!()
        };
        assert!(good.is_proved() && good.mass > 0.1);
        let changes: [&dyn Fn(&mut Prices); 7] = [
            &|prices| prices.of[0] *= 1.0 + 1e-6,
            &|prices| prices.of[0] *= 1.0 - 1e-6,
            &|prices| prices.of[1] += 1e-6,
            &|prices| prices.of[2] = f64::NAN,
            &|prices| prices.of.push(0.0),
            &|prices| prices.of.truncate(2),
            &|prices| prices.of_mass = false,
        ];
        for change in changes {
            let mut bad = good.clone();
            change(prices(&mut bad.proof.tree));
            assert!(!bad.is_proved(), "{:?}", bad.proof.tree);
        }
    }

    #[test]
    fn nor_that_there_is_none() {
        let BallastAnswer::None(good) = asked(&[[0.6, -0.2, 0.1], [0.1, -0.7, -0.3]]) else { panic!() };
        assert!(good.is_proved());
        let changes: [&dyn Fn(&mut Prices); 3] = [
            &|prices| prices.of[0] *= 20.0,
            &|prices| prices.of.iter_mut().for_each(|y| *y = 0.0),
            &|prices| prices.of.iter_mut().skip(1).for_each(|y| *y = -*y),
        ];
        for change in changes {
            let mut bad = good.clone();
            change(prices(&mut bad.proof.tree));
            assert!(!bad.is_proved(), "{:?}", bad.proof.tree);
        }
        let mut bad = good;
        bad.up_to *= 2.0;
        assert!(!bad.is_proved());
    }
}
