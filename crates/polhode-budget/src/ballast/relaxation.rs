//! The least ballast in a region if limits are linear there: a conic program over all pieces that the sites allow, solved with those that matter.

use super::interval::Interval;
use super::problem::{Column, Problem};
use super::proof::Prices;
use super::region::{Cell, Region};
use super::row::{Block, Functional, Kind, weights};
use super::solver::{Columns, Solved, least_sum};

/// What comes of a region.
#[derive(Clone, Debug)]
pub(super) struct Relaxed {
    /// What proves the bound.
    pub(super) prices: Prices,
    /// Of a piece by where it is: its mass less what it is worth to the limits.
    pub(super) price: Functional,
    /// The pieces, if there are any that will do.
    pub(super) pieces: Option<Vec<Placed>>,
}

/// A piece in a cell of a region.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Placed {
    pub(super) cell: usize,
    pub(super) column: Column,
    pub(super) mass: f64,
}

/// What is left of the work, and what other regions leave for it.
#[derive(Clone, Debug)]
pub(super) struct Work {
    /// Pieces that were good in other regions.
    pool: Vec<Column>,
    /// How many variables the programs may have that are solved.
    pub(super) left: usize,
    /// Whether one would have had more.
    pub(super) is_spent: bool,
}

impl Work {
    pub(super) const fn new(left: usize) -> Self {
        Self { pool: Vec::new(), left, is_spent: false }
    }
}

/// How well a region is solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Until {
    /// Until no more pieces would make ballast lighter.
    Solved,
    /// Until the least is roughly known; that there is none need not be proved.
    Roughly,
    /// Until nothing in it is lighter than this, or it is known that more pieces cannot show that.
    Above(f64),
}

/// Pieces are added until none would make ballast lighter by more than this part of its own mass: in all, and in a region of centres.
const PRICE: [f64; 2] = [1e-11, 1e-8];

/// The same where pieces do not meet the limits, as a part of what is missing: to prove that none do, and roughly.
const MISSING: [f64; 2] = [1e-6, 0.1];

/// How near the least in a region has to be known before it is split, as a part of it.
const ROUGH: f64 = 0.01;

/// How many pieces besides those that cells begin with are kept for other regions.
const KEPT: usize = 24;

/// Pieces nearer than this part of a cell's size are one piece.
const NEAR: f64 = 1e-7;

/// Masses nearer than this part are one: sums of sizes are known but for rounding.
const SAME: f64 = 1e-11;

/// How often.
const ROUNDS: usize = 80;

impl Problem {
    /// The least ballast in a region, of pieces that cells begin with, that were added elsewhere, or are added; `None` if the solver gives up, or may not solve more.
    pub(super) fn relaxed(&self, region: &Region, work: &mut Work, until: Until) -> Option<Relaxed> {
        let (rows, mut last) = (self.rows(region), None);
        // What takes nothing has no pieces, but if nothing takes any.
        let none = region.leaves().all(|(_, cell)| cell.masses[1] == 0.0);
        let takes_some = |cell: &Cell| none || cell.masses[1] > 0.0;
        let mut columns: Vec<(usize, Column)> = Vec::new();
        for (k, cell) in region.leaves().filter(|(_, cell)| takes_some(cell)) {
            let site = cell.site;
            columns.extend(cell.chart.seeds().into_iter().map(|at| (k, Column { site, at })));
            let others = work.pool.iter().filter(|column| column.site == site && cell.chart.holds(column.at));
            columns.extend(others.map(|column| (k, *column)));
        }
        let missing = MISSING[usize::from(until == Until::Roughly)];
        for _ in 0..ROUNDS {
            let Master { prices, masses, full } = {
                let left = work.left.checked_sub(columns.len());
                work.is_spent |= left.is_none();
                work.left = left?;
                self.master(&rows, region, &columns)?
            };
            let sum = weighed(&rows, &prices.of);
            let price = price(&sum, &prices);
            let price_of_mass = PRICE[usize::from(!self.products.is_empty())];
            let tolerance =
                if prices.of_mass { price_of_mass } else { missing * sum.constant.size() / self.cap };
            let mut added = false;
            for (k, cell) in region.leaves().filter(|(_, cell)| takes_some(cell) && !cell.chart.is_point()) {
                let (at, least) = cell.chart.least(&price, self.origin);
                let new = Column { site: cell.site, at };
                let is_old =
                    |(other, old): &(usize, Column)| *other == k && cell.chart.are_near(old.at, at, NEAR);
                if least + full[k] < -tolerance && !columns.iter().any(is_old) {
                    columns.push((k, new));
                    work.pool.push(new);
                    added = true;
                }
            }
            let total = masses.as_ref().map(|masses| masses.iter().sum::<f64>());
            let placed = |masses: Vec<f64>| {
                let pieces = columns.iter().zip(masses);
                pieces.map(|((cell, column), mass)| Placed { cell: *cell, column: *column, mass }).collect()
            };
            let relaxed = Relaxed { prices, price, pieces: masses.map(placed) };
            let bound = || self.bound(&relaxed.prices, region, self.cap);
            let enough = match (total, until) {
                (None, _) => bound() == f64::INFINITY,
                (Some(_), Until::Solved) => false,
                (Some(total), Until::Roughly) => total - bound() < ROUGH * total,
                (Some(total), Until::Above(closing)) => {
                    let bound = bound();
                    bound >= closing || (total < closing && total - bound < ROUGH * total)
                }
            };
            last = Some(relaxed);
            if !added || enough {
                break;
            }
        }
        let used = last.iter().filter_map(|relaxed| relaxed.pieces.as_ref()).flatten();
        let heaviest = used.clone().fold(0.0, |most: f64, piece| most.max(piece.mass));
        let used = used.filter(|piece| piece.mass > 1e-6 * heaviest).map(|piece| piece.column);
        let used: Vec<Column> = used.filter(|column| work.pool.contains(column)).collect();
        work.pool.retain(|column| !used.contains(column));
        work.pool.drain(..work.pool.len().saturating_sub(KEPT));
        work.pool.extend(used);
        last
    }

    fn master(&self, rows: &[Block], region: &Region, columns: &[(usize, Column)]) -> Option<Master> {
        let at: Vec<[Interval; 10]> =
            columns.iter().map(|(_, column)| weights(self.local(column.at))).collect();
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
            region.cells.iter().map(|cell| [cell.masses[0], cell.masses[1].min(self.cap)]).collect();
        unit = bounds.iter().fold(unit, |unit, [least, _]| unit.max(*least));
        if !(unit > 0.0) {
            unit = 1.0;
        }
        let constants: Vec<f64> =
            rows.iter().flat_map(|block| &block.rows).map(|row| row.constant.middle()).collect();
        // A x + s = b with s in the cones: s = f, then what sites leave, then the masses.
        let mut b: Vec<f64> = constants.iter().zip(&units).map(|(c, of)| c / of / unit).collect();
        let mut cones: Vec<(Kind, usize)> = rows.iter().map(|block| (block.kind, block.rows.len())).collect();
        let mut cells: Vec<Vec<(usize, f64)>> = vec![Vec::new(); bounds.len()];
        // What follows from the parts of a cell is not said again: rows that depend on each other are hard for the solver.
        let of_parts = [0, 1].map(|end| region.summed(region.leaves().map(|(k, _)| (k, bounds[k][end]))));
        for (cell, [least, most]) in bounds.iter().enumerate() {
            let is_parted = !region.cells[cell].parts.is_empty();
            if !is_parted && !columns.iter().any(|(own, _)| *own == cell) {
                continue;
            }
            let says_most = !is_parted || of_parts[1][cell] > most * (1.0 + SAME);
            let says_least = !is_parted || of_parts[0][cell] < least * (1.0 - SAME);
            if most - least <= SAME * most && says_most && says_least {
                cells[cell].push((b.len(), 1.0));
                b.push(most / unit);
                cones.push((Kind::Zero, 1));
                continue;
            }
            for (bound, sign, is_said) in [(*most, 1.0, says_most), (*least, -1.0, says_least)] {
                if is_said && bound < self.cap && (sign > 0.0 || bound > 0.0) {
                    cells[cell].push((b.len(), sign));
                    b.push(sign * bound / unit);
                    cones.push((Kind::Positive, 1));
                }
            }
        }
        // A piece is in a cell and in all that this is part of.
        let owners = region.owners();
        let rows_of = |cell: usize| {
            let up = core::iter::successors(Some(cell), |cell| owners[*cell]);
            let mut all: Vec<(usize, f64)> = up.flat_map(|cell| cells[cell].iter().copied()).collect();
            all.sort_by_key(|(row, _)| *row);
            all
        };
        let before = b.len();
        b.extend(columns.iter().map(|_| 0.0));
        cones.push((Kind::Positive, columns.len()));
        let mut a = Columns::of_rows(b.len());
        for (k, (cell, _)) in columns.iter().enumerate() {
            let of_rows = elements.iter().zip(&units).map(|(row, of)| -row[k] / of).enumerate();
            let of_rows = of_rows.filter(|(_, value)| *value != 0.0).chain(rows_of(*cell));
            a.push(of_rows.chain([(before + k, -1.0)]));
        }
        let Solved { is_feasible: of_mass, x, z } = least_sum(a, &b, &cones)?;
        let y: Vec<f64> = z.iter().zip(&units).map(|(z, of)| z / of).collect();
        if y.iter().chain(&x).any(|x| !x.is_finite()) {
            return None;
        }
        // What it is worth to a cell to take more than it may, of its most and its least mass.
        let worth = |rows: &Vec<(usize, f64)>| rows.iter().map(|(row, sign)| sign * z[*row]).sum::<f64>();
        let full = (0..bounds.len()).map(|cell| worth(&rows_of(cell))).collect();
        let of_cells = if region.cells.len() > self.charts.len() {
            cells.iter().map(|rows| -worth(rows)).collect()
        } else {
            Vec::new()
        };
        let of = in_cones(rows, y);
        let masses = of_mass.then(|| x.iter().map(|x| (x * unit).max(0.0)).collect());
        Some(Master { prices: Prices { of, of_cells, of_mass }, masses, full })
    }
}

struct Master {
    prices: Prices,
    masses: Option<Vec<f64>>,
    /// Of each cell.
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

/// 1 − y·a, or of what shows that there is no ballast −y·a.
fn price(sum: &Functional, prices: &Prices) -> Functional {
    let one = if prices.of_mass { Interval::ONE } else { Interval::ZERO };
    Functional { constant: Interval::ZERO, ..Functional::mass() * one - *sum }
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
