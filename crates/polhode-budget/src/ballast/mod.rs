//! The least ballast by which limits are met, with the proof that none is lighter.
//!
//! Ballast is exact, and at sites: points, lines, discs and circles, of which all but points take several masses, at all of them also in pieces of given sizes. The mass and the first and second moments of the whole are
//! linear in the masses, so limits on these are linear: on the mass, on a coordinate c = S/M of the centre (S ≤ most·M), on moments and products about a fixed point; and cones, if they are on a distance of
//! the centre or on an unbalance. Products about the moving centre, W − S S/M, are not: there it is proved in regions of the centre that nothing is lighter; and with sizes in regions of what pieces come to, and of where they are.

mod chart;
mod error;
mod guide;
mod interval;
mod linear;
mod local;
mod parting;
mod planar;
mod polish;
mod problem;
mod proof;
mod region;
mod relaxation;
mod row;
mod search;
mod site;
mod solver;
mod step;
mod sums;
mod unit;

pub use error::BallastError;
pub use site::{Place as BallastPlace, Round, Site};

use polhode::body::{BodyError, InertiaTensor, MassProperties};
use polhode::math::{Body, Position};

use crate::budget::Budget;
use crate::limit::Limit;
use crate::subtrees::combined;
use problem::{Column, Problem};
use proof::Tree;
use search::{Outcome, Search};
use sums::Pieces;

/// Ballast to be found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ballast {
    /// Where it may be.
    pub sites: Vec<Site>,
    /// The most of all together, kg.
    pub most: Option<f64>,
    /// How many standard deviations, to first order in the errors of the list, the whole is kept inside its limits: of each side of a coordinate, a mass, a moment and a product about a fixed point; of a
    /// distance and an unbalance in every direction, at least.
    pub deviations: f64,
    /// How many variables all conic programs together have at most that are solved, or [`EFFORT`](Self::EFFORT): so long the search takes, and not a time, so that every machine has the same answer.
    pub effort: Option<usize>,
}

/// What ballast there is to be.
#[derive(Clone, Debug, PartialEq)]
pub enum BallastAnswer {
    /// The least.
    Least(FoundBallast),
    /// None meets the limits.
    None(NoBallast),
    /// The search ended before one of these was proved.
    Undecided(UndecidedBallast),
}

/// Ballast that meets all limits, and what none that does is below.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundBallast {
    /// Where it is, in the order of the sites; none if the limits are met without.
    pub pieces: Vec<Piece>,
    /// All of it, kg.
    pub mass: f64,
    /// What no ballast that meets the limits is below, kg.
    pub bound: f64,
    /// How many regions of sizes, of places and of centres the proof has; 1 of a linear or conic question.
    pub regions: usize,
    proof: Proof,
}

/// What is known where the search ended before its end.
#[derive(Clone, Debug, PartialEq)]
pub struct UndecidedBallast {
    /// The lightest that was found.
    pub found: Option<FoundBallast>,
    /// What no ballast that meets the limits is below, kg.
    pub bound: f64,
    /// How many regions were looked at.
    pub regions: usize,
    /// How much was allowed, if that is why it ended: with more [`effort`](Ballast::effort) more may be known. Else regions are as narrow as numbers are.
    pub effort: Option<usize>,
}

/// That there is no ballast.
#[derive(Clone, Debug, PartialEq)]
pub struct NoBallast {
    /// None up to this mass, kg: what is allowed, or a thousand times the mass of the list.
    pub up_to: f64,
    /// How many regions of sizes, of places and of centres the proof has.
    pub regions: usize,
    proof: Proof,
}

/// What is to be put into a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Which of the sites.
    pub site: usize,
    /// Where, m.
    pub position: Position<Body>,
    /// Of one, kg.
    pub mass: f64,
    /// How many of this mass are there: 1 where any mass may be.
    pub count: u64,
}

/// A proof, which can be checked against its question.
#[derive(Clone, Debug, PartialEq)]
struct Proof {
    problem: Problem,
    tree: Tree,
    cap: f64,
}

/// By how much the least mass may be above what is proved, as a part of it: of linear and conic questions and of sizes alone or at points.
const GAP: f64 = 1e-9;

/// The same where products about the moving centre are limited, and of sizes on lines, discs and circles beside masses that may be any.
const GAP_OF_PRODUCTS: f64 = 1e-6;

impl Ballast {
    /// The effort where it is not said: some seconds.
    pub const EFFORT: usize = 100_000;
}

impl Budget {
    /// The least ballast by which limits are met, to a part of 1e-9; or of 1e-6 if products about the centre of mass are among them, or if sizes on lines, discs and circles stand beside sites of any mass.
    ///
    /// Limits are met but for rounding: to a part of 1e-11 of what ballast changes.
    ///
    /// # Errors
    /// [`BallastError`] of a site or a limit that cannot be, and of a limit that ballast cannot be found for.
    pub fn ballast(&self, ballast: &Ballast, limits: &[Limit]) -> Result<BallastAnswer, BallastError> {
        if !solver::IS_THERE {
            return Err(BallastError::NoSolver);
        }
        let problem = Problem::new(self, ballast, limits)?;
        let gap = problem.gap();
        let effort = ballast.effort.unwrap_or(Ballast::EFFORT);
        let Outcome { found, tree, cap, looked_at, is_spent, .. } = Search::new(&problem, gap, effort).run();
        let found: Option<Vec<Piece>> = found.map(|found| {
            let of = |(column, mass): &(Column, f64)| {
                let position = Position::from_array(column.at);
                let site = column.site;
                let pieces = problem.pieces_of(site, *mass).unwrap_or_default();
                pieces.into_iter().map(move |Pieces { size, count }| Piece {
                    site,
                    position,
                    mass: size,
                    count,
                })
            };
            found.iter().flat_map(of).collect()
        });
        let proof = Proof { problem, tree, cap };
        let regions = proof.tree.leaves();
        let undecided = |found, bound| UndecidedBallast {
            found,
            bound,
            regions: looked_at,
            effort: is_spent.then_some(effort),
        };
        let Some(pieces) = found else {
            let bound = proof.bound(cap);
            return Ok(if bound == f64::INFINITY {
                BallastAnswer::None(NoBallast { up_to: cap, regions, proof })
            } else {
                BallastAnswer::Undecided(undecided(None, bound))
            });
        };
        let mass = pieces.iter().map(Piece::total).sum();
        let bound = proof.bound(mass).min(mass);
        let found = FoundBallast { pieces, mass, bound, regions, proof };
        Ok(if found.is_least() {
            BallastAnswer::Least(found)
        } else {
            BallastAnswer::Undecided(undecided(Some(found), bound))
        })
    }
}

impl Piece {
    /// The mass of all of them, kg.
    fn total(&self) -> f64 {
        self.count as f64 * self.mass
    }
}

impl FoundBallast {
    /// By how much it may be above the least, as a part of it.
    pub fn gap(&self) -> f64 {
        if self.mass > 0.0 { (self.mass - self.bound) / self.mass } else { 0.0 }
    }

    /// Checks the proof, in intervals: that the pieces are at their sites and meet the limits, and that the prices of the limits leave nothing below the bound.
    pub fn is_proved(&self) -> bool {
        let problem = &self.proof.problem;
        let sizes_hold = self.pieces.iter().all(|piece| {
            let of_size = |sizes: &Vec<f64>| {
                if sizes.is_empty() { piece.count == 1 } else { sizes.contains(&piece.mass) }
            };
            problem.sizes.get(piece.site).is_some_and(of_size)
        });
        let pieces: Vec<_> = self
            .pieces
            .iter()
            .map(|piece| (Column { site: piece.site, at: piece.position.to_array() }, piece.total()))
            .collect();
        let sum: f64 = self.pieces.iter().map(Piece::total).sum();
        sizes_hold && problem.is_met(&pieces) && sum == self.mass && self.bound <= self.proof.bound(self.mass)
    }

    /// The same, and that it is the least but for the part that [`Budget::ballast`] says.
    pub fn is_least(&self) -> bool {
        let gap = self.proof.problem.gap();
        self.is_proved() && self.mass - self.bound <= gap * self.mass * (1.0 + 1e-6)
    }

    /// A body with it: the list on either basis.
    ///
    /// # Errors
    /// [`BodyError`] if the sum is not finite.
    pub fn with(&self, body: &MassProperties<Body>) -> Result<MassProperties<Body>, BodyError> {
        let mut parts = vec![*body];
        for piece in &self.pieces {
            parts.push(MassProperties::new(
                piece.total(),
                piece.position,
                InertiaTensor::diagonal([0.0; 3])?,
            )?);
        }
        Ok(combined(&parts)?.unwrap_or(*body))
    }
}

impl NoBallast {
    /// Checks the proof, in intervals.
    pub fn is_proved(&self) -> bool {
        self.proof.cap >= self.up_to && self.proof.bound(self.up_to) == f64::INFINITY
    }
}

impl Proof {
    /// What no ballast up to a mass is below.
    fn bound(&self, mass: f64) -> f64 {
        // The regions of the centre are those of ballast up to the cap.
        if mass > self.cap {
            return 0.0;
        }
        self.problem.proved(&self.tree, &self.problem.root(self.cap), mass)
    }
}

impl Tree {
    fn leaves(&self) -> usize {
        match self {
            Self::Leaf(_) => 1,
            Self::Split { below, above, .. } => below.leaves() + above.leaves(),
            Self::Parted { rest, .. } => rest.leaves(),
        }
    }
}
