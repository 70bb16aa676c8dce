//! The least ballast in a region if limits are linear there: a conic program over all pieces that the sites allow, solved with those that matter.

use super::interval::Interval;
use super::problem::{Column, Problem, Region};
use super::proof::Prices;
use super::row::{Block, Functional, Kind, weights};
use super::solver::{Columns, Solved, least_sum};

/// What comes of a region.
#[derive(Clone, Debug)]
pub(super) struct Relaxed {
    /// What proves the bound.
    pub(super) prices: Prices,
    /// The pieces, if there are any that will do.
    pub(super) pieces: Option<Vec<(Column, f64)>>,
}

/// Pieces are added until none would make ballast lighter by more than this part of its own mass: in all, and in a region of centres.
const PRICE: [f64; 2] = [1e-11, 1e-8];

/// How many pieces besides the first are kept for other regions.
const KEPT: usize = 24;

/// Pieces nearer than this part of a site's size are one piece.
const NEAR: f64 = 1e-7;

/// How often.
const ROUNDS: usize = 80;

impl Problem {
    /// The pieces that a search begins with.
    pub(super) fn seeds(&self) -> Vec<Column> {
        let of = |(site, chart): (usize, &super::site::Chart)| {
            chart.seeds().into_iter().map(move |at| Column { site, at }).collect::<Vec<_>>()
        };
        self.charts.iter().enumerate().flat_map(of).collect()
    }

    /// The least ballast in a region, of pieces that are there or are added; `None` if the solver gives up.
    pub(super) fn relaxed(&self, region: &Region, columns: &mut Vec<Column>) -> Option<Relaxed> {
        let (rows, mut last) = (self.rows(region), None);
        for _ in 0..ROUNDS {
            let master = self.master(&rows, region, columns)?;
            let Master { prices, masses, full } = master;
            let sum = weighed(&rows, &prices.of);
            let one = if prices.of_mass { Interval::ONE } else { Interval::ZERO };
            let price = Functional { constant: Interval::ZERO, ..Functional::mass() * one - sum };
            let price_of_mass = PRICE[usize::from(!self.products.is_empty())];
            let tolerance = if prices.of_mass { price_of_mass } else { 0.1 * sum.constant.size() / self.cap };
            let mut added = false;
            for (site, chart) in self.charts.iter().enumerate() {
                let (at, least) = chart.least(&price, self.origin);
                let new = Column { site, at };
                let is_new =
                    || !columns.iter().any(|old| old.site == site && chart.are_near(old.at, at, NEAR));
                if !chart.is_point() && least + full[site] < -tolerance && is_new() {
                    columns.push(new);
                    added = true;
                }
            }
            let pieces: Option<Vec<_>> = masses.map(|masses| columns.iter().copied().zip(masses).collect());
            last = Some(Relaxed { prices, pieces });
            let is_proved = |relaxed: &Relaxed| {
                !relaxed.prices.of_mass && self.bound(&relaxed.prices, region, self.cap) == f64::INFINITY
            };
            if !added || last.as_ref().is_some_and(is_proved) {
                break;
            }
        }
        let seeds = self.seeds().len();
        let used = last.iter().filter_map(|relaxed| relaxed.pieces.as_ref()).flatten();
        let heaviest = used.clone().fold(0.0, |most: f64, (_, mass)| most.max(*mass));
        let used: Vec<Column> =
            used.skip(seeds).filter(|(_, mass)| *mass > 1e-6 * heaviest).map(|(column, _)| *column).collect();
        let mut others = columns.split_off(seeds.min(columns.len()));
        others.retain(|column| !used.contains(column));
        columns.extend(others.into_iter().rev().take(KEPT).rev());
        columns.extend(used);
        last
    }

    fn master(&self, rows: &[Block], region: &Region, columns: &[Column]) -> Option<Master> {
        let at: Vec<[Interval; 10]> = columns.iter().map(|column| weights(self.local(column.at))).collect();
        let elements: Vec<Vec<f64>> = rows
            .iter()
            .flat_map(|block| &block.rows)
            .map(|row| at.iter().map(|w| row.at(w).middle()).collect())
            .collect();
        // Each block in units of what a unit mass does to it, and masses in those that the worst needs.
        let (mut units, mut unit, mut first) = (Vec::new(), 0.0_f64, 0);
        for block in rows {
            let own = &elements[first..first + block.rows.len()];
            let most = own.iter().flatten().fold(0.0, |most: f64, a| most.max(a.abs()));
            let most = if most > 0.0 { most } else { 1.0 };
            units.extend(block.rows.iter().map(|_| most));
            unit = unit.max(missing(block) / most);
            first += block.rows.len();
        }
        let bounds: Vec<[f64; 2]> =
            (0..self.charts.len()).map(|site| self.masses(region, site, self.cap)).collect();
        unit = bounds.iter().fold(unit, |unit, [least, _]| unit.max(*least));
        if !(unit > 0.0) {
            unit = 1.0;
        }
        let constants: Vec<f64> =
            rows.iter().flat_map(|block| &block.rows).map(|row| row.constant.middle()).collect();
        // A x + s = b with s in the cones: s = f, then what sites leave, then the masses.
        let mut b: Vec<f64> = constants.iter().zip(&units).map(|(c, of)| c / of / unit).collect();
        let mut cones: Vec<(Kind, usize)> = rows.iter().map(|block| (block.kind, block.rows.len())).collect();
        let mut sites: Vec<Vec<(usize, f64)>> = vec![Vec::new(); self.charts.len()];
        for (site, [least, most]) in bounds.iter().enumerate() {
            if least == most {
                sites[site].push((b.len(), 1.0));
                b.push(most / unit);
                cones.push((Kind::Zero, 1));
                continue;
            }
            for (bound, sign) in [(*most, 1.0), (*least, -1.0)] {
                if bound < self.cap && (sign > 0.0 || bound > 0.0) {
                    sites[site].push((b.len(), sign));
                    b.push(sign * bound / unit);
                    cones.push((Kind::Positive, 1));
                }
            }
        }
        let before = b.len();
        b.extend(columns.iter().map(|_| 0.0));
        cones.push((Kind::Positive, columns.len()));
        let mut a = Columns::of_rows(b.len());
        for (k, column) in columns.iter().enumerate() {
            let of_rows = elements.iter().zip(&units).map(|(row, of)| -row[k] / of).enumerate();
            let of_rows =
                of_rows.filter(|(_, value)| *value != 0.0).chain(sites[column.site].iter().copied());
            a.push(of_rows.chain([(before + k, -1.0)]));
        }
        let Solved { is_feasible: of_mass, x, z } = least_sum(a, &b, &cones)?;
        let y: Vec<f64> = z.iter().zip(&units).map(|(z, of)| z / of).collect();
        if y.iter().chain(&x).any(|x| !x.is_finite()) {
            return None;
        }
        // What it is worth to a site to take more than it may, of its most and its least mass.
        let full = sites.iter().map(|rows| rows.iter().map(|(row, sign)| sign * z[*row]).sum()).collect();
        let of = in_cones(rows, y);
        let masses = of_mass.then(|| x.iter().map(|x| (x * unit).max(0.0)).collect());
        Some(Master { prices: Prices { of, of_mass }, masses, full })
    }
}

struct Master {
    prices: Prices,
    masses: Option<Vec<f64>>,
    /// Of each site.
    full: Vec<f64>,
}

/// By how much a block is beside what is asked of it without ballast.
fn missing(block: &Block) -> f64 {
    let values: Vec<f64> = block.rows.iter().map(|row| row.constant.middle()).collect();
    match (block.kind, &values[..]) {
        (Kind::Cone, [first, rest @ ..]) => (rest.iter().map(|x| x * x).sum::<f64>().sqrt() - first).max(0.0),
        (Kind::Positive, values) => values.iter().fold(0.0, |most, x| most.max(-x)),
        (_, values) => values.iter().fold(0.0, |most, x| most.max(x.abs())),
    }
}

/// y·f
fn weighed(rows: &[Block], prices: &[f64]) -> Functional {
    let all = rows.iter().flat_map(|block| &block.rows).zip(prices);
    all.fold(Functional::constant(Interval::ZERO), |sum, (row, y)| sum + *row * Interval::from(*y))
}

/// The prices, with what rounding has put beside the cones put into them.
fn in_cones(rows: &[Block], mut prices: Vec<f64>) -> Vec<f64> {
    let mut first = 0;
    for block in rows {
        let own = &mut prices[first..first + block.rows.len()];
        match (block.kind, own) {
            (Kind::Positive, own) => own.iter_mut().for_each(|y| *y = y.max(0.0)),
            (Kind::Cone, [first, rest @ ..]) => {
                let square = rest.iter().map(|y| Interval::from(*y).square()).sum::<Interval>();
                *first = first.max(square.sqrt().high);
            }
            _ => {}
        }
        first += block.rows.len();
    }
    prices.truncate(first);
    prices
}
