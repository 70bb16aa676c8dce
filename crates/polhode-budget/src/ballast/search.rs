//! Branch and bound: regions of sizes and of centres are split until none can have lighter ballast.

use core::cmp::Ordering;
use std::collections::BinaryHeap;

use super::problem::{Column, Problem, Region};
use super::proof::{Branch, Prices, Tree};
use super::relaxation::Relaxed;

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

/// Once some ballast is found, in one of so many regions lighter one is tried.
const TRIES: usize = 4;

/// A region of centres narrower than this part of the first is not split.
const NARROW: f64 = 1e-9;

struct Node {
    region: Region,
    prices: Prices,
    /// What nothing in it is below.
    bound: f64,
    /// Where it is split if it has to be.
    branch: Option<Branch>,
    /// The two parts.
    parts: Option<[usize; 2]>,
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
    columns: Vec<Column>,
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
            columns: problem.seeds(),
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
            let nothing = Prices { of: Vec::new(), of_mass: true };
            return Outcome { found: Some(Vec::new()), tree: Tree::Leaf(nothing), cap: self.cap };
        }
        let mut root = self.problem.root(self.cap);
        self.look(root.clone());
        // Light ballast moves the centre little: the region becomes smaller once some is found.
        while let Some((mass, _)) = self.found.as_ref().filter(|(mass, _)| *mass < 0.5 * self.cap) {
            self.cap = *mass;
            self.nodes.clear();
            self.open.clear();
            root = self.problem.root(self.cap);
            self.look(root.clone());
        }
        while self.nodes.len() < REGIONS {
            // The least bound first: when that is closed, all are.
            let Some(Open { bound, place }) = self.open.pop() else { break };
            let Some(branch) = self.nodes[place].branch.filter(|_| !self.is_closed(bound)) else { break };
            let parts = self.nodes[place].region.split(branch).map(|region| self.look(region));
            self.nodes[place].parts = Some(parts);
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
    fn look(&mut self, region: Region) -> usize {
        let nothing = Prices { of: Vec::new(), of_mass: true };
        let relaxed = self.problem.relaxed(&region, &mut self.columns);
        let Some(Relaxed { prices, pieces }) = relaxed else {
            let branch = self.middle(&region);
            return self.push(Node { region, prices: nothing, bound: 0.0, branch, parts: None });
        };
        let mut branch = None;
        if let Some(pieces) = pieces {
            if self.found.is_none() || self.nodes.len().is_multiple_of(TRIES) {
                self.try_near(&region, &pieces);
            }
            let bound = self.problem.bound(&prices, &region, self.limit());
            if !self.is_closed(bound) {
                branch = self.branch(&region, &pieces);
            }
        }
        let bound = self.problem.bound(&prices, &region, self.limit());
        if branch.is_none() && !self.is_closed(bound) {
            branch = self.middle(&region);
        }
        self.push(Node { region, prices, bound, branch, parts: None })
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
    fn try_near(&mut self, region: &Region, pieces: &[(Column, f64)]) {
        let problem = self.problem;
        if problem.products.is_empty() && problem.sizes.iter().all(Vec::is_empty) {
            self.offer(problem.polished(pieces));
            return;
        }
        let mut fixed = region.clone();
        for (site, sizes) in problem.sizes.iter().enumerate().filter(|(_, sizes)| !sizes.is_empty()) {
            let nearest = problem.nearest_size(site, at_site(pieces, site));
            let place = sizes.iter().position(|size| Some(*size) == nearest).unwrap_or(0);
            fixed.sizes[site] = [place; 2];
        }
        let center = problem.center(pieces);
        for free in 0..center.len().max(1) {
            let mut fixed = fixed.clone();
            for (k, (at, [low, high])) in center.iter().zip(&region.boxes).enumerate() {
                if k != free || center.len() == 1 {
                    fixed.boxes[k] = [at.clamp(*low, *high); 2];
                }
            }
            let relaxed = problem.relaxed(&fixed, &mut self.columns);
            if let Some(pieces) = relaxed.and_then(|relaxed| relaxed.pieces) {
                self.offer(problem.polished(&pieces));
            }
        }
    }

    /// Where a region is to be split: at a site whose mass is between two sizes, or across the centre by which a broken product is bounded least well.
    fn branch(&self, region: &Region, pieces: &[(Column, f64)]) -> Option<Branch> {
        let problem = self.problem;
        let between = problem.sizes.iter().enumerate().filter_map(|(site, sizes)| {
            let ([least, most], mass) = (region.sizes[site], at_site(pieces, site));
            let index = (least..most).find(|k| mass < sizes[k + 1]).unwrap_or(most.checked_sub(1)?);
            let (below, above) = (sizes[index], *sizes.get(index + 1)?);
            let beside = (mass - below).abs().min((above - mass).abs());
            (least < most && beside > 1e-7 * above).then_some((beside, Branch::Size { site, index }))
        });
        if let Some((_, branch)) = between.max_by(|a, b| a.0.total_cmp(&b.0)) {
            return Some(branch);
        }
        let (center, root) =
            (problem.center(pieces), &self.nodes.first().map_or(region, |node| &node.region));
        let broken = problem.broken_products(pieces);
        let wide = |k: usize| {
            let whole = root.boxes[k][1] - root.boxes[k][0];
            if whole > 0.0 { (region.boxes[k][1] - region.boxes[k][0]) / whole } else { 0.0 }
        };
        let (product, _) = problem
            .products
            .iter()
            .zip(&broken)
            .filter(|(_, by)| **by > 0.0)
            .max_by(|a, b| a.1.total_cmp(b.1))?;
        let [i, j] = product.coordinates;
        let coordinate = if wide(i) >= wide(j) { i } else { j };
        let [low, high] = region.boxes[coordinate];
        let width = high - low;
        (wide(coordinate) > NARROW).then(|| Branch::Center {
            coordinate,
            at: center[coordinate].clamp(low + 0.2 * width, high - 0.2 * width),
        })
    }

    /// Where a region of which nothing is known is split.
    fn middle(&self, region: &Region) -> Option<Branch> {
        let sizes = region.sizes.iter().enumerate().filter(|(_, [least, most])| least < most);
        if let Some((site, [least, most])) = sizes.max_by_key(|(_, [least, most])| most - least) {
            return Some(Branch::Size { site, index: (least + most - 1) / 2 });
        }
        let root = self.nodes.first().map_or(region, |node| &node.region);
        let wide = |k: &usize| {
            let whole = root.boxes[*k][1] - root.boxes[*k][0];
            if whole > 0.0 { (region.boxes[*k][1] - region.boxes[*k][0]) / whole } else { 0.0 }
        };
        let coordinate = (0..region.boxes.len()).max_by(|a, b| wide(a).total_cmp(&wide(b)))?;
        let [low, high] = region.boxes[coordinate];
        (wide(&coordinate) > NARROW).then_some(Branch::Center { coordinate, at: 0.5 * low + 0.5 * high })
    }

    fn tree(&self, place: usize) -> Tree {
        let node = &self.nodes[place];
        match (node.parts, node.branch) {
            (Some([below, above]), Some(branch)) => {
                Tree::Split { branch, below: Box::new(self.tree(below)), above: Box::new(self.tree(above)) }
            }
            _ => Tree::Leaf(node.prices.clone()),
        }
    }
}

fn at_site(pieces: &[(Column, f64)], site: usize) -> f64 {
    pieces.iter().filter(|(column, _)| column.site == site).map(|(_, mass)| mass).sum()
}
