//! What a log itself says of the meaning of its numbers.

use super::axes::SignedAxes;
use super::log::QuaternionOrder;

/// Which way the rotations of a log go.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AttitudeSense {
    /// R_space_body: body components to space components, as polhode has it.
    BodyToSpace,
    /// R_body_space, its inverse.
    SpaceToBody,
}

impl AttitudeSense {
    /// Both.
    pub const ALL: [Self; 2] = [Self::BodyToSpace, Self::SpaceToBody];
}

/// Along which axes the angular velocity of a log is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum OmegaAxes {
    /// Those of the body.
    Body,
    /// Those of space.
    Space,
}

impl OmegaAxes {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Body, Self::Space];
}

/// What a log says without doubt, by the names of its columns or its user's word; `None` where it says nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DeclaredReading {
    /// The order of its quaternions.
    pub order: Option<QuaternionOrder>,
    /// Which way its rotations go.
    pub sense: Option<AttitudeSense>,
    /// Along which axes its ω is.
    pub omega_axes: Option<OmegaAxes>,
    /// Its axes.
    pub axes: Option<SignedAxes>,
    /// The log's time at the scenario's time 0, s.
    pub time_origin: Option<f64>,
}
