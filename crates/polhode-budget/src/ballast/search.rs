//! Branch and bound: regions of sizes and of centres are split until none can have lighter ballast.

use core::cmp::Ordering;
use std::collections::BinaryHeap;

use super::problem::{Column, Problem};
use super::proof::{Prices, Tree};
use super::region::{Cell, Region};
use super::relaxation::{Placed, Relaxed, Until, Work};
use super::row::Functional;
use super::step::{Splitting, Step};

/// What was found, and what is proved.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Outcome {
    /// The lightest that was found.
    pub(super) found: Option<Vec<(Column, f64)>>,
    /// The proof of what nothing is below.
    pub(super) tree: Tree,
    /// Of ballast up to this, kg.
    pub(super) cap: f64,
    /// How many regions were looked at, and how many variables the programs had.
    pub(super) looked_at: usize,
    pub(super) effort: usize,
    /// Whether more of these would have been needed.
    pub(super) is_spent: bool,
}

/// The search begins anew, with what is lighter than ballast that was found, where this is a part of 1/64 lighter for each region that is lost.
const WORTH: f64 = 64.0;

/// No more than this part of the effort goes into ballast that is tried, and the rest into what is proved.
const TRIED: usize = 3;

/// In one of so many regions sums are chosen each after what the others then are.
const ONE_BY_ONE: usize = 4;

pub(super) struct Node {
    pub(super) region: Region,
    prices: Prices,
    /// What nothing in it is below.
    bound: f64,
    /// How it is split if it has to be.
    step: Option<Step>,
    /// What it was split into.
    parts: Vec<usize>,
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
    pub(super) problem: &'a Problem,
    pub(super) work: Work,
    /// What `work` had.
    pub(super) effort: usize,
    looked_at: usize,
    /// What ballast that was tried took of the effort, and how often.
    tried: usize,
    times: usize,
    pub(super) nodes: Vec<Node>,
    open: BinaryHeap<Open>,
    found: Option<(f64, Vec<(Column, f64)>)>,
    cap: f64,
    gap: f64,
}

impl<'a> Search<'a> {
    /// Until what is found is proved but for a part of its mass, or programs of so many variables are solved.
    pub(super) fn new(problem: &'a Problem, gap: f64, effort: usize) -> Self {
        Self {
            problem,
            work: Work::new(effort),
            effort,
            looked_at: 0,
            tried: 0,
            times: 0,
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
            return self.outcome(Tree::Leaf(nothing));
        }
        self.guide();
        self.cap = self.limit();
        self.look(self.problem.root(self.cap), None);
        while !self.work.is_spent {
            // Light ballast moves the centre little, and needs few sizes: the region becomes smaller once some is found, if little is lost.
            if let Some((mass, _)) = self.found
                && (self.cap / mass - 1.0) * WORTH > self.nodes.len() as f64
            {
                self.cap = mass;
                self.nodes.clear();
                self.open.clear();
                self.look(self.problem.root(self.cap), None);
            }
            // The least bound first: when that is closed, all are.
            let Some(Open { bound, place }) = self.open.pop() else { break };
            if self.is_closed(bound) {
                break;
            }
            let Some(step) = self.nodes[place].step else {
                // What cannot be split stays open; elsewhere there may be some ballast.
                if self.found.is_some() { break } else { continue }
            };
            let region = &self.nodes[place].region;
            let parts = match step {
                Step::Split(branch) => self.problem.split(region, branch).to_vec(),
                Step::Part { cell, axis, at } => vec![self.problem.parted(region, cell, axis, at)],
            };
            self.nodes[place].parts =
                parts.into_iter().map(|region| self.look(region, Some(place))).collect();
        }
        let tree = self.tree(0);
        self.outcome(tree)
    }

    fn outcome(self, tree: Tree) -> Outcome {
        Outcome {
            found: self.found.map(|(_, pieces)| pieces),
            tree,
            cap: self.cap,
            looked_at: self.looked_at,
            effort: self.effort - self.work.left,
            is_spent: self.work.is_spent,
        }
    }

    fn is_closed(&self, bound: f64) -> bool {
        match &self.found {
            None => bound == f64::INFINITY,
            Some((mass, _)) => bound >= mass * (1.0 - self.gap),
        }
    }

    pub(super) fn limit(&self) -> f64 {
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
        let relaxed = self.problem.relaxed(&region, &mut self.work, until);
        let Some(Relaxed { prices, price, pieces }) = relaxed else {
            let prices = within.map_or_else(none, |within| self.nodes[within].prices.clone());
            let bound = self.problem.bound(&prices, &region, self.limit());
            let step = self.splitting(&region).middle(&region);
            return self.push(Node { region, prices, bound, step, parts: Vec::new() });
        };
        let mut step = None;
        if let Some(pieces) = pieces {
            if self.tries() {
                let before = self.work.left;
                self.try_near(&region, &pieces, &price);
                self.tried += before - self.work.left;
                self.times += 1;
            } else {
                let near = self.problem.in_pieces(&region, &pieces, false);
                self.offer(self.problem.corrected(near));
            }
            let bound = self.problem.bound(&prices, &region, self.limit());
            if !self.is_closed(bound) {
                step = self.splitting(&region).step(&region, &pieces);
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
            step = self.splitting(&region).middle(&region);
        }
        self.push(Node { region, prices, bound, step, parts: Vec::new() })
    }

    /// How regions are split: as parts of the first of all, which this is if there is none yet.
    fn splitting<'b>(&'b self, region: &'b Region) -> Splitting<'b> {
        Splitting { problem: self.problem, first: self.nodes.first().map_or(region, |node| &node.region) }
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
        self.looked_at += 1;
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
        let Some(mass) = self.problem.mass(&pieces) else { return };
        let lighter = self.found.as_ref().is_none_or(|(found, _)| mass < *found);
        if lighter && self.problem.is_met(&pieces) {
            self.found = Some((mass, pieces));
        }
    }

    /// Whether there is effort for more ballast to be tried.
    fn tries(&self) -> bool {
        self.tried * TRIED <= self.effort - self.work.left
    }

    /// Takes pieces near these.
    pub(super) fn offer_near(&mut self, pieces: &[(Column, f64)], price: Option<&Functional>) {
        let polished = self.problem.polished(pieces, price, &mut self.work);
        self.offer(polished);
    }

    /// Ballast near that of a region: as it is, with the nearest sizes, and with the centre where it is but along one coordinate, so that products about it are linear.
    fn try_near(&mut self, region: &Region, placed: &[Placed], price: &Functional) {
        let problem = self.problem;
        if !problem.is_split() {
            let pieces = problem.in_pieces(region, placed, false);
            self.offer_near(&pieces, Some(price));
            return;
        }
        let one_by_one = self.times.is_multiple_of(ONE_BY_ONE);
        let Some((fixed, placed)) = self.with_sums(region, placed, one_by_one) else { return };
        let center = problem.center(&problem.in_pieces(&fixed, &placed, false));
        for free in 0..center.len().max(1) {
            let mut fixed = fixed.clone();
            for (k, (at, [low, high])) in center.iter().zip(&region.boxes).enumerate() {
                if k != free || center.len() == 1 {
                    fixed.boxes[k] = [at.clamp(*low, *high); 2];
                }
            }
            let relaxed = problem.relaxed(&fixed, &mut self.work, Until::Solved);
            let price = relaxed.as_ref().map(|relaxed| relaxed.price);
            let placed = relaxed.and_then(|relaxed| relaxed.pieces).unwrap_or_else(|| placed.clone());
            let few = problem.in_pieces(&fixed, &placed, false);
            let many = problem.in_pieces(&fixed, &placed, true);
            self.offer_near(&few, price.as_ref());
            if many.len() > few.len() {
                self.offer_near(&many, price.as_ref());
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
            placed = self.problem.relaxed(&region, &mut self.work, until)?.pieces?;
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
