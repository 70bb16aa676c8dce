//! Branch and bound: regions of sizes and of centres are split until none can have lighter ballast.

use core::cmp::Ordering;
use std::collections::BinaryHeap;

use super::problem::{Column, Problem};
use super::proof::{Branch, Prices, Tree};
use super::region::{Cell, Region};
use super::relaxation::{Placed, Relaxed, Until};
use super::row::Functional;

/// What was found, and what is proved.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Outcome {
    /// The lightest that was found.
    pub(super) found: Option<Vec<(Column, f64)>>,
    /// The proof of what nothing is below.
    pub(super) tree: Tree,
    /// Of ballast up to this, kg.
    pub(super) cap: f64,
}

/// Regions that are looked at.
const REGIONS: usize = 20_000;

/// In so many regions some ballast is tried to be found,
const FIRST: usize = 4;

/// and then in one of so many lighter one.
const TRIES: usize = 4;

/// A region of centres narrower than this part of the first is not split.
const NARROW: f64 = 1e-9;

struct Node {
    region: Region,
    prices: Prices,
    /// What nothing in it is below.
    bound: f64,
    /// How it is split if it has to be.
    step: Option<Step>,
    /// What it was split into.
    parts: Vec<usize>,
}

/// How a region is split.
#[derive(Clone, Copy)]
enum Step {
    /// Into two.
    Split(Branch),
    /// A part of a site in it into two.
    Part { cell: usize, axis: usize, at: f64 },
}

/// A region that may have lighter ballast; those of the least bound are the greatest.
#[derive(PartialEq)]
struct Open {
    bound: f64,
    place: usize,
}

impl Eq for Open {}

impl Ord for Open {
    fn cmp(&self, other: &Self) -> Ordering {
        other.bound.total_cmp(&self.bound).then(other.place.cmp(&self.place))
    }
}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

pub(super) struct Search<'a> {
    problem: &'a Problem,
    /// Pieces that were good in other regions.
    pool: Vec<Column>,
    nodes: Vec<Node>,
    open: BinaryHeap<Open>,
    found: Option<(f64, Vec<(Column, f64)>)>,
    cap: f64,
    gap: f64,
}

impl<'a> Search<'a> {
    /// Until what is found is proved but for a part of its mass.
    pub(super) fn new(problem: &'a Problem, gap: f64) -> Self {
        Self {
            problem,
            pool: Vec::new(),
            nodes: Vec::new(),
            open: BinaryHeap::new(),
            found: None,
            cap: problem.cap,
            gap,
        }
    }

    pub(super) fn run(mut self) -> Outcome {
        self.offer(Some(Vec::new()));
        if self.found.is_some() {
            let nothing = Prices { of: Vec::new(), of_cells: Vec::new(), of_mass: true };
            return Outcome { found: Some(Vec::new()), tree: Tree::Leaf(nothing), cap: self.cap };
        }
        let mut root = self.problem.root(self.cap);
        self.look(root.clone(), None);
        // Light ballast moves the centre little: the region becomes smaller once some is found.
        while let Some((mass, _)) = self.found.as_ref().filter(|(mass, _)| *mass < 0.5 * self.cap) {
            self.cap = *mass;
            self.nodes.clear();
            self.open.clear();
            root = self.problem.root(self.cap);
            self.look(root.clone(), None);
        }
        while self.nodes.len() < REGIONS {
            // The least bound first: when that is closed, all are.
            let Some(Open { bound, place }) = self.open.pop() else { break };
            let Some(step) = self.nodes[place].step.filter(|_| !self.is_closed(bound)) else { break };
            let region = &self.nodes[place].region;
            let parts = match step {
                Step::Split(branch) => self.problem.split(region, branch).to_vec(),
                Step::Part { cell, axis, at } => vec![self.problem.parted(region, cell, axis, at)],
            };
            self.nodes[place].parts =
                parts.into_iter().map(|region| self.look(region, Some(place))).collect();
        }
        Outcome { tree: self.tree(0), cap: self.cap, found: self.found.map(|(_, pieces)| pieces) }
    }

    fn is_closed(&self, bound: f64) -> bool {
        match &self.found {
            None => bound == f64::INFINITY,
            Some((mass, _)) => bound >= mass * (1.0 - self.gap),
        }
    }

    fn limit(&self) -> f64 {
        self.found.as_ref().map_or(self.cap, |(mass, _)| mass.min(self.cap))
    }

    /// Looks at a region, and says where its node is.
    fn look(&mut self, region: Region, within: Option<usize>) -> usize {
        let none = || Prices { of: Vec::new(), of_cells: Vec::new(), of_mass: true };
        if region.is_empty() {
            return self.push(Node {
                region,
                prices: none(),
                bound: f64::INFINITY,
                step: None,
                parts: Vec::new(),
            });
        }
        let until = self.until();
        let relaxed = self.problem.relaxed(&region, &mut self.pool, until);
        let Some(Relaxed { prices, price, pieces }) = relaxed else {
            let prices = within.map_or_else(none, |within| self.nodes[within].prices.clone());
            let bound = self.problem.bound(&prices, &region, self.limit());
            let step = self.middle(&region);
            return self.push(Node { region, prices, bound, step, parts: Vec::new() });
        };
        let mut step = None;
        if let Some(pieces) = pieces {
            if self.nodes.len() < FIRST || self.nodes.len().is_multiple_of(TRIES) {
                self.try_near(&region, &pieces, &price);
            }
            let bound = self.problem.bound(&prices, &region, self.limit());
            if !self.is_closed(bound) {
                step = self.step(&region, &pieces);
            }
        }
        let mut prices = prices;
        let mut bound = self.problem.bound(&prices, &region, self.limit());
        // The prices of what it is a part of hold here too.
        if let Some(others) = within.map(|within| self.nodes[within].prices.clone())
            && let by_others = self.problem.bound(&others, &region, self.limit())
            && by_others > bound
        {
            (prices, bound) = (others, by_others);
        }
        if step.is_none() && !self.is_closed(bound) {
            step = self.middle(&region);
        }
        self.push(Node { region, prices, bound, step, parts: Vec::new() })
    }

    fn until(&self) -> Until {
        let above = |(mass, _): &(f64, Vec<_>)| mass * (1.0 - self.gap);
        if self.problem.is_split() {
            Until::Above(self.found.as_ref().map_or(f64::INFINITY, above))
        } else {
            Until::Solved
        }
    }

    fn push(&mut self, node: Node) -> usize {
        let place = self.nodes.len();
        if !self.is_closed(node.bound) {
            self.open.push(Open { bound: node.bound, place });
        }
        self.nodes.push(node);
        place
    }

    /// Takes ballast if it meets all limits and is lighter than what was found.
    fn offer(&mut self, pieces: Option<Vec<(Column, f64)>>) {
        let Some(mut pieces) = pieces else { return };
        pieces.sort_by_key(|(column, _)| column.site);
        let mass = pieces.iter().map(|(_, mass)| mass).sum::<f64>();
        let lighter = self.found.as_ref().is_none_or(|(found, _)| mass < *found);
        if lighter && self.problem.is_met(&pieces) {
            self.found = Some((mass, pieces));
        }
    }

    /// Ballast near that of a region: as it is, with the nearest sizes, and with the centre where it is but along one coordinate, so that products about it are linear.
    fn try_near(&mut self, region: &Region, placed: &[Placed], price: &Functional) {
        let problem = self.problem;
        if !problem.is_split() {
            self.offer(problem.polished(&problem.in_pieces(region, placed, false), Some(price)));
            return;
        }
        let one_by_one = self.nodes.len() < FIRST || self.nodes.len().is_multiple_of(TRIES * TRIES);
        let Some((fixed, placed)) = self.with_sums(region, placed, one_by_one) else { return };
        let center = problem.center(&problem.in_pieces(&fixed, &placed, false));
        for free in 0..center.len().max(1) {
            let mut fixed = fixed.clone();
            for (k, (at, [low, high])) in center.iter().zip(&region.boxes).enumerate() {
                if k != free || center.len() == 1 {
                    fixed.boxes[k] = [at.clamp(*low, *high); 2];
                }
            }
            let relaxed = problem.relaxed(&fixed, &mut self.pool, Until::Solved);
            let price = relaxed.as_ref().map(|relaxed| relaxed.price);
            let placed = relaxed.and_then(|relaxed| relaxed.pieces).unwrap_or_else(|| placed.clone());
            let few = problem.in_pieces(&fixed, &placed, false);
            let many = problem.in_pieces(&fixed, &placed, true);
            self.offer(problem.polished(&few, price.as_ref()));
            if many.len() > few.len() {
                self.offer(problem.polished(&many, price.as_ref()));
            }
        }
    }

    /// A region in which each sum is one that there is near what it was: all at once, or each after what the others then are.
    fn with_sums(
        &mut self,
        region: &Region,
        placed: &[Placed],
        one_by_one: bool,
    ) -> Option<(Region, Vec<Placed>)> {
        let (mut region, mut placed) = (region.clone(), placed.to_vec());
        loop {
            let totals = region.summed(placed.iter().map(|piece| (piece.cell, piece.mass)));
            let near = |(k, cell): (usize, &Cell)| {
                let sums = self.problem.sums[cell.site].as_ref()?;
                let index = sums.nearest(totals[k], cell.sums);
                let beside = (totals[k] - sums.at(index)[1]).max(sums.at(index)[0] - totals[k]).max(0.0);
                (cell.sums[0] < cell.sums[1]).then_some((beside, k, index))
            };
            let mut open: Vec<_> = region.leaves().filter_map(near).collect();
            if open.is_empty() {
                return Some((region, placed));
            }
            open.sort_by(|a, b| a.0.total_cmp(&b.0));
            let now = open.iter().filter(|(beside, ..)| *beside <= 1e-7 * self.cap).count().max(1);
            for (_, cell, index) in &open[..if one_by_one { now } else { open.len() }] {
                region.cells[*cell].sums = [*index; 2];
            }
            self.problem.tighten(&mut region);
            if region.is_empty() {
                return None;
            }
            let until = self.until();
            placed = self.problem.relaxed(&region, &mut self.pool, until)?.pieces?;
        }
    }

    /// Where a region is to be split: at a sum between two that there are; in a part of a site, whose moments are farthest from those of pieces in it; or across the centre by which a broken product is bounded least well.
    fn step(&self, region: &Region, placed: &[Placed]) -> Option<Step> {
        let problem = self.problem;
        let totals = region.summed(placed.iter().map(|piece| (piece.cell, piece.mass)));
        let between = region.cells.iter().enumerate().filter_map(|(k, cell)| {
            let (sums, [least, most]) = (problem.sums[cell.site].as_ref()?, cell.sums);
            let above = sums.first_from(totals[k]).clamp(least.min(most) + 1, most.max(least + 1));
            let (low, high) = (sums.at(above - 1)[1], sums.at(above)[0]);
            let beside = (totals[k] - low).abs().min((high - totals[k]).abs());
            let is_between = totals[k] > low && totals[k] < high && beside > 1e-7 * high;
            (least < most && is_between).then_some((beside, Branch::Sum { cell: k, index: above - 1 }))
        });
        if let Some((_, branch)) = between.max_by(|a, b| a.0.total_cmp(&b.0)) {
            return Some(Step::Split(branch));
        }
        let free = region.leaves().filter(|(_, cell)| problem.has_free_pieces(cell.site));
        let apart = free.map(|(k, cell)| (problem.apart(region, placed, k), k, cell));
        let apart = apart.filter(|(by, ..)| *by > 1e-9).max_by(|a, b| a.0.total_cmp(&b.0));
        let broken = problem.broken_products(&problem.in_pieces(region, placed, false));
        let worst = problem.products.iter().zip(&broken).filter(|(_, by)| **by > 0.0);
        let worst = worst.max_by(|a, b| a.1.total_cmp(b.1));
        let center = worst.and_then(|(product, by)| {
            let [i, j] = product.coordinates;
            let coordinate = if self.wide(region, i) >= self.wide(region, j) { i } else { j };
            let [low, high] = region.boxes[coordinate];
            let width = high - low;
            let at = problem.center(&problem.in_pieces(region, placed, false))[coordinate];
            let at = at.clamp(low + 0.2 * width, high - 0.2 * width);
            let size = Functional::second(product.axes[0], product.axes[1]);
            let size = size.added_to(problem.whole(product.basis)).size;
            (self.wide(region, coordinate) > NARROW).then_some((
                *by / size.max(f64::MIN_POSITIVE),
                Step::Split(Branch::Center { coordinate, at }),
            ))
        });
        match (apart, center) {
            (Some((by, k, cell)), center) if center.is_none_or(|(broken, _)| by > broken) => {
                let own = placed.iter().filter(|piece| piece.cell == k);
                let own: Vec<_> = own.map(|piece| (piece.column.at, piece.mass)).collect();
                let parting = problem.parting(cell, &own);
                parting.map(|(axis, at)| Step::Part { cell: k, axis, at }).or(center.map(|(_, step)| step))
            }
            (_, center) => center.map(|(_, step)| step),
        }
    }

    /// How wide a coordinate of the centre is, as a part of what it is in all.
    fn wide(&self, region: &Region, k: usize) -> f64 {
        let root = self.nodes.first().map_or(region, |node| &node.region);
        let whole = root.boxes[k][1] - root.boxes[k][0];
        if whole > 0.0 { (region.boxes[k][1] - region.boxes[k][0]) / whole } else { 0.0 }
    }

    /// Where a region of which nothing is known is split.
    fn middle(&self, region: &Region) -> Option<Step> {
        let sums = region.leaves().filter(|(_, cell)| cell.sums[0] < cell.sums[1]);
        if let Some((cell, of)) = sums.max_by_key(|(_, cell)| cell.sums[1] - cell.sums[0]) {
            let [least, most] = of.sums;
            return Some(Step::Split(Branch::Sum { cell, index: (least + most - 1) / 2 }));
        }
        let center = (0..region.boxes.len()).map(|k| (self.wide(region, k), k));
        let center = center.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|(wide, _)| *wide > NARROW);
        let free = region
            .leaves()
            .filter(|(_, cell)| self.problem.has_free_pieces(cell.site) && cell.masses[1] > 0.0);
        let parting = |(k, cell): (usize, &Cell)| {
            let (axis, at) = self.problem.parting(cell, &[])?;
            let part = cell.chart.size() / self.problem.charts[cell.site].size();
            Some((part, Step::Part { cell: k, axis, at }))
        };
        let part = free.filter_map(parting).max_by(|a, b| a.0.total_cmp(&b.0));
        match (center, part) {
            (Some((wide, _)), Some((part, step))) if part > wide => Some(step),
            (Some((_, coordinate)), _) => {
                let [low, high] = region.boxes[coordinate];
                Some(Step::Split(Branch::Center { coordinate, at: 0.5 * low + 0.5 * high }))
            }
            (None, part) => part.map(|(_, step)| step),
        }
    }

    fn tree(&self, place: usize) -> Tree {
        let node = &self.nodes[place];
        match (&node.parts[..], node.step) {
            ([below, above], Some(Step::Split(branch))) => {
                Tree::Split { branch, below: Box::new(self.tree(*below)), above: Box::new(self.tree(*above)) }
            }
            ([rest], Some(Step::Part { cell, axis, at })) => {
                Tree::Parted { cell, axis, at, rest: Box::new(self.tree(*rest)) }
            }
            _ => Tree::Leaf(node.prices.clone()),
        }
    }
}
