//! Ballast that meets limits: the lightest that a local search finds, with a lower bound.
//!
//! Ballast has no uncertainty. It is at sites: points, lines, discs and circles. A point takes one
//! mass, other sites take several; all can be restricted to pieces of given sizes. The mass and the
//! first and second moments of the whole are linear in the masses, so most limits are linear or
//! cones. Products about the moving centre, W − S S/M, are not.

mod bound;
mod chart;
mod error;
mod local;
mod problem;
mod row;
mod search;
mod simplex;
mod site;

pub use error::BallastError;
pub use site::{Place as BallastPlace, Round, Site};

use polhode::body::{BodyError, InertiaTensor, MassProperties};
use polhode::math::{Body, Position};

use crate::budget::Budget;
use crate::limit::Limit;
use crate::subtrees::combined;
use problem::{Lot, Problem};
use search::Search;

/// Sites and options of a search for ballast.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ballast {
    /// Sites where ballast may be placed.
    pub sites: Vec<Site>,
    /// Largest total mass of ballast, kg.
    pub most: Option<f64>,
    /// Margin to the limits in standard deviations, to first order in the errors of the list.
    ///
    /// The margin is kept on each side of a coordinate, a mass, a moment or a product about a fixed
    /// point. A distance or an unbalance keeps at least this margin in every direction.
    pub deviations: f64,
}

/// Result of the search for ballast.
#[derive(Clone, Debug, PartialEq)]
pub enum BallastAnswer {
    /// Ballast that meets all limits.
    Found(FoundBallast),
    /// No ballast was found that meets all limits.
    NotFound(NoBallast),
}

/// Ballast that meets all limits, and a lower bound on the mass of all such ballast.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundBallast {
    /// Pieces in the order of the sites; empty if the limits are met without ballast.
    pub pieces: Vec<Piece>,
    /// Mass of all pieces, kg.
    pub mass: f64,
    /// Lower bound on the mass of ballast that meets the limits, kg.
    pub bound: f64,
}

/// Result of a search that found no ballast.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoBallast {
    /// Largest mass that was searched, kg: the allowed mass, or a thousand times that of the list.
    pub up_to: f64,
    /// Lower bound on the mass of ballast that meets the limits, kg; infinite if none does.
    pub bound: f64,
}

/// Pieces of one mass at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Index of the site.
    pub site: usize,
    /// Position in the body, m.
    pub position: Position<Body>,
    /// Mass of one piece, kg.
    pub mass: f64,
    /// Number of pieces; 1 if any mass is allowed.
    pub count: u64,
}

/// Largest relative gap to the lower bound at which ballast counts as the least.
const GAP: f64 = 1e-9;

impl Budget {
    /// Searches for the least ballast with which limits are met.
    ///
    /// The search is local, from several starts. Its result meets the limits to a relative 1e-11 of
    /// the change by the ballast. [`FoundBallast::is_least`] returns true if the lower bound proves
    /// that the result is the least. This is usual if limits are linear or cones and sites take any
    /// mass.
    ///
    /// # Errors
    /// [`BallastError`] if a site or a limit is not valid, or ballast cannot be found for a limit.
    pub fn ballast(&self, ballast: &Ballast, limits: &[Limit]) -> Result<BallastAnswer, BallastError> {
        let problem = Problem::new(self, ballast, limits)?;
        let bound = |near: &[Lot], cap: f64| problem.relaxation(cap).relaxed(near).1;
        let none = |bound| Ok(BallastAnswer::NotFound(NoBallast { up_to: problem.cap, bound }));
        let of_all = bound(&[], problem.cap);
        if of_all == f64::INFINITY {
            return none(of_all);
        }
        let Some(lots) = Search::best(&problem) else { return none(of_all) };
        let mut pieces: Vec<Piece> = Vec::new();
        for lot in &lots {
            let position = Position::from_array(problem.charts[lot.site].point(lot.at));
            let piece = Piece {
                site: lot.site,
                position,
                mass: lot.size.unwrap_or(lot.mass),
                count: lot.count() as u64,
            };
            let is_same = |other: &&mut Piece| Piece { count: piece.count, ..**other } == piece;
            match pieces.iter_mut().find(is_same) {
                Some(other) => other.count += piece.count,
                None => pieces.push(piece),
            }
        }
        pieces.sort_by_key(|piece| piece.site);
        let mass = pieces.iter().map(Piece::total).sum();
        // A bound above the mass is only rounding error.
        let bounds =
            [0.0, of_all, bound(&lots, mass)].into_iter().filter(|bound| *bound <= mass * (1.0 + GAP));
        let bound = problem.attainable(bounds.fold(0.0, f64::max)).min(mass);
        Ok(BallastAnswer::Found(FoundBallast { pieces, mass, bound }))
    }
}

impl Piece {
    /// Returns the mass of all pieces, kg.
    fn total(&self) -> f64 {
        self.count as f64 * self.mass
    }
}

impl FoundBallast {
    /// Returns the gap between the mass and its lower bound, relative to the mass.
    pub fn gap(&self) -> f64 {
        if self.mass > 0.0 { (self.mass - self.bound) / self.mass } else { 0.0 }
    }

    /// Returns true if the lower bound proves that no ballast is lighter, except for a relative
    /// 1e-9.
    pub fn is_least(&self) -> bool {
        self.gap() <= GAP
    }

    /// Returns a body with the ballast added. The body is that of the list on either basis.
    ///
    /// # Errors
    /// [`BodyError`] if the sum is not finite.
    pub fn with(&self, body: &MassProperties<Body>) -> Result<MassProperties<Body>, BodyError> {
        let mut parts = vec![*body];
        for piece in &self.pieces {
            let point = InertiaTensor::diagonal([0.0; 3])?;
            parts.push(MassProperties::new(piece.total(), piece.position, point)?);
        }
        Ok(combined(&parts)?.unwrap_or(*body))
    }
}

impl NoBallast {
    /// Returns true if the lower bound proves that no ballast up to [`up_to`](Self::up_to) meets
    /// the limits.
    pub fn is_proved(&self) -> bool {
        self.bound == f64::INFINITY
    }
}
