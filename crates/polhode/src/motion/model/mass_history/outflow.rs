//! Outflow of mass from a body.

use crate::math::frame::Body;
use crate::math::vector::{Direction, Position};
use crate::motion::error::MotionError;
use crate::motion::model::require;

use super::moments::Moments;
use super::{SAME_MASS, wrong};

/// Way in which mass leaves a body between jumps.
#[derive(Clone, Debug, PartialEq)]
pub enum Outflow {
    /// No mass leaves.
    None,
    /// Mass is left behind where it was, with the velocity that it has there, as in evaporation. ω
    /// does not change.
    InPlace,
    /// Mass leaves through exits. Their shares of the flow are positive and sum to 1.
    Exits(Vec<Exit>),
}

/// Exit through which mass leaves, uniformly over a disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exit {
    /// Fraction of the total flow.
    pub share: f64,
    /// Centre of the disc, body axes, m.
    pub position: Position<Body>,
    /// Normal of the disc, body axes.
    pub axis: Direction<Body>,
    /// Radius of the disc, m; zero for a point.
    pub radius: f64,
}

impl Outflow {
    /// Checks the exits.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]).
    pub(super) fn require_possible(&self) -> Result<(), MotionError> {
        let Self::Exits(exits) = self else { return Ok(()) };
        for exit in exits {
            require::positive("the share of an exit", exit.share)?;
            require::finite("the place of an exit", exit.position.norm())?;
            require::not_negative("the radius of an exit", exit.radius)?;
            if exit.radius > 0.0 {
                require::direction("the length of an exit's axis", exit.axis)?;
            }
        }
        let sum: f64 = exits.iter().map(|exit| exit.share).sum();
        require::that("the sum of the shares of all exits", sum, (sum - 1.0).abs() <= 1e-9, "1")
    }

    /// Checks a piece that begins at `time`. `bodies` are the Bernstein coefficients of its
    /// moments.
    ///
    /// # Errors
    /// [`MotionError::MassHistory`] if one of them is not physical.
    pub(super) fn require_piece(
        &self,
        time: f64,
        bodies: &[Moments],
        reference: Position<Body>,
    ) -> Result<(), MotionError> {
        if bodies.iter().any(|body| body.properties(reference).is_err()) {
            return Err(wrong(time, "has unphysical bodies before the next row with the given rates"));
        }
        for pair in bodies.windows(2) {
            let [before, after] = pair else { continue };
            let lost = before.minus(after);
            if lost.mass().abs() <= SAME_MASS * before.mass() {
                continue;
            }
            if lost.mass() < 0.0 {
                return Err(wrong(time, "gains mass with unknown motion"));
            }
            match self {
                Self::None => return Err(wrong(time, "loses mass, but its exit is not defined")),
                Self::InPlace if !lost.is_part_of(before) => {
                    return Err(wrong(
                        time,
                        "loses mass that is not a physical body, although it is left in place",
                    ));
                }
                _ => {}
            }
        }
        Ok(())
    }

    pub(super) fn stretched(&self, reference: Position<Body>, by: [f64; 3]) -> Self {
        let Self::Exits(exits) = self else { return self.clone() };
        let moved = |exit: &Exit| {
            let d = (exit.position - reference).to_array();
            let position = reference + Position::from_array(core::array::from_fn(|k| by[k] * d[k]));
            Exit { position, ..*exit }
        };
        Self::Exits(exits.iter().map(moved).collect())
    }
}
