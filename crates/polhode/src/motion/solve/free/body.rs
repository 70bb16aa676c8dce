//! Body of free motions: its principal axes, found once for all its starts.

use crate::body::principal::PrincipalFrame;
use crate::math::frame::Body;
use crate::math::symmetric3::{Symmetric3, power_of_two_near};
use crate::math::triple::Triple;
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

use super::axes::FineAxes;
use super::labelled::Labelled;

/// Body without wheels that has a moment of inertia, with its principal axes to 46 digits: a third
/// of the work of a [`FreeMotion`](super::FreeMotion).
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct FreeBody {
    pub(super) tensor: Symmetric3,
    pub(super) principal: PrincipalFrame<Body>,
    pub(super) axes: FineAxes,
}

/// Least ratio of a moment to the greatest. Products of three moments must stay in the range of
/// f64.
const THINNEST: f64 = 1e-120;

impl FreeBody {
    /// Finds the principal axes.
    ///
    /// # Errors
    /// - [`MotionError::NoClosedForm`] for a body with wheels.
    /// - [`MotionError::NotSpinnable`] for a body without inertia.
    /// - A parameter error ([`MotionError::is_parameter`]) for a moment that is not zero, but below
    ///   1e-120 of the greatest.
    pub(in crate::motion) fn of(rotor: &Rotor) -> Result<Self, MotionError> {
        if !rotor.wheels().is_empty() {
            return Err(MotionError::NoClosedForm { why: "wheels spin in the body" });
        }
        Self::of_tensor(rotor.inertia().symmetric(), rotor.principal())
    }

    pub(super) fn of_tensor(
        tensor: &Symmetric3,
        principal: &PrincipalFrame<Body>,
    ) -> Result<Self, MotionError> {
        let greatest = principal.moments()[2];
        if greatest == 0.0 {
            return Err(MotionError::NotSpinnable);
        }
        for moment in principal.moments() {
            let holds = moment == 0.0 || moment >= THINNEST * greatest;
            require::that("a principal moment", moment, holds, "zero or at least 1e-120 of the greatest")?;
        }
        let axes = FineAxes::of(tensor, principal);
        Ok(Self { tensor: *tensor, principal: *principal, axes })
    }

    /// Returns true if a rotor is this body: the same tensor and axes, and no wheels.
    pub(in crate::motion) fn is_of(&self, rotor: &Rotor) -> bool {
        let (tensor, principal) = (rotor.inertia().symmetric(), rotor.principal());
        rotor.wheels().is_empty() && self.tensor == *tensor && self.principal == *principal
    }

    /// Labels the axes for a start, in units that are powers of two. Returns the unit of ω, rad/s,
    /// too.
    pub(super) fn labelled(&self, start: &State) -> (Labelled, f64) {
        let axes = &self.axes;
        let unit = power_of_two_near(start.omega.max_abs());
        let omega = axes.along((start.omega / unit).to_array());
        (Labelled::of(axes.moments, omega, axes.axes.map(|axis| axis.map(Triple::value))), unit)
    }
}
