//! Declared meaning of a log's numbers.

use super::axes::SignedAxes;
use super::log::QuaternionOrder;

/// Direction of the rotations of a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AttitudeSense {
    /// R_space_body: body components to space components, the convention of polhode.
    BodyToSpace,
    /// R_body_space: space components to body components.
    SpaceToBody,
}

impl AttitudeSense {
    /// Both directions.
    pub const ALL: [Self; 2] = [Self::BodyToSpace, Self::SpaceToBody];
}

/// Frame of the angular velocity of a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum OmegaAxes {
    /// Components along body axes.
    Body,
    /// Components along space axes.
    Space,
}

impl OmegaAxes {
    /// Both frames.
    pub const ALL: [Self; 2] = [Self::Body, Self::Space];
}

/// Declared meaning of a log's numbers; `None` where nothing is declared.
///
/// A declaration by the user is final. One that is only in the names of the columns
/// ([`DeclaredReading::by_name`]) is tried first, and is dropped if the motion contradicts it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DeclaredReading {
    /// Order of the quaternion's numbers.
    pub order: Option<QuaternionOrder>,
    /// Direction of the rotations.
    pub sense: Option<AttitudeSense>,
    /// Frame of the angular velocity.
    pub omega_axes: Option<OmegaAxes>,
    /// Axes of the log, as signed axes of the scenario.
    pub axes: Option<SignedAxes>,
    /// The log's time at the scenario's time 0, in s of the log's clock.
    pub time_origin: Option<f64>,
    /// Seconds per stated second of the log's clock: 1 if the unit of the times is certain.
    pub time_factor: Option<f64>,
    /// rad/s per stated rad/s of the log's ω: 1 if the unit of ω is certain.
    pub omega_factor: Option<f64>,
    /// Declarations that are only in the names of the columns.
    pub by_name: DeclaredByName,
}

/// Declarations that are only in the names of columns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DeclaredByName {
    /// True if [`DeclaredReading::order`] is only in the names.
    pub order: bool,
    /// True if [`DeclaredReading::sense`] is only in the names.
    pub sense: bool,
    /// True if [`DeclaredReading::omega_axes`] is only in the names.
    pub omega_axes: bool,
    /// True if the unit of the times is only in the names.
    pub time_unit: bool,
    /// True if the unit of ω is only in the names.
    pub omega_unit: bool,
}

impl DeclaredReading {
    /// Returns the declarations of the user, without those in the names.
    #[must_use]
    pub fn certain(self) -> Self {
        Self {
            order: self.order.filter(|_| !self.by_name.order),
            sense: self.sense.filter(|_| !self.by_name.sense),
            omega_axes: self.omega_axes.filter(|_| !self.by_name.omega_axes),
            by_name: DeclaredByName::default(),
            ..self
        }
    }

    /// Returns these declarations, completed by those of a log.
    ///
    /// ```
    /// use polhode::infer::judge::{DeclaredByName, DeclaredReading, OmegaAxes, QuaternionOrder};
    /// let user = DeclaredReading { omega_axes: Some(OmegaAxes::Space), ..DeclaredReading::default() };
    /// let log = DeclaredReading {
    ///     order: Some(QuaternionOrder::ScalarFirst),
    ///     omega_axes: Some(OmegaAxes::Body),
    ///     by_name: DeclaredByName { order: true, omega_axes: true, ..DeclaredByName::default() },
    ///     ..DeclaredReading::default()
    /// };
    /// let both = user.or(&log);
    /// assert_eq!((both.order, both.omega_axes), (Some(QuaternionOrder::ScalarFirst), Some(OmegaAxes::Space)));
    /// assert_eq!((both.certain().order, both.certain().omega_axes), (None, Some(OmegaAxes::Space)));
    /// ```
    #[must_use]
    pub fn or(self, log: &Self) -> Self {
        Self {
            order: self.order.or(log.order),
            sense: self.sense.or(log.sense),
            omega_axes: self.omega_axes.or(log.omega_axes),
            axes: self.axes.or(log.axes),
            time_origin: self.time_origin.or(log.time_origin),
            time_factor: self.time_factor.or(log.time_factor),
            omega_factor: self.omega_factor.or(log.omega_factor),
            by_name: DeclaredByName {
                order: self.order.is_none() && log.by_name.order,
                sense: self.sense.is_none() && log.by_name.sense,
                omega_axes: self.omega_axes.is_none() && log.by_name.omega_axes,
                time_unit: self.time_factor.is_none() && log.by_name.time_unit,
                omega_unit: self.omega_factor.is_none() && log.by_name.omega_unit,
            },
        }
    }
}
