//! Rows of a parts list as they are given.

use polhode::body::MassProperties;
use polhode::math::{Part, Position, Rotation};

use crate::growth::Growth;
use crate::tensor::{GivenTensor, ProductSign, TensorPoint};
use crate::uncertainty::Uncertainty;

/// Row of a parts list: a frame, a part in it, or both.
///
/// The frame is given in the frame of the parent row. The parent is [`Row::parent`] if that is
/// given. Otherwise it is the path before the last `/` of [`Row::name`]: `bus` for `bus/battery`.
/// Exactly one row, the root, has no parent. Its frame is given in the axes of the body.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Unique name or path, such as `bus/battery`.
    pub name: String,
    /// Name of the parent row, if the path does not contain it.
    pub parent: Option<String>,
    /// Number of copies, and the correlation of their errors.
    pub quantity: Quantity,
    /// Position and orientation of the row's frame in the parent's frame.
    pub place: Place,
    /// Part in this frame, without the parts of child rows.
    pub part: Option<GivenPart>,
    /// Errors of the numbers of this row.
    pub uncertainty: Uncertainty,
    /// Name of the group whose rows have correlated errors.
    pub group: Option<String>,
    /// Growth allowance of the part.
    pub growth: Growth,
    /// Mass that the list states for this row with its descendants, all copies counted, before
    /// growth.
    pub subtotal: Option<Subtotal>,
    /// Allowable mass of this row with its descendants, all copies counted, kg.
    pub allowable: Option<f64>,
}

impl Row {
    /// Returns a frame without a part, at the parent's origin and along its axes.
    pub fn frame(name: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            parent: None,
            quantity: Quantity::ONE,
            place: Place::default(),
            part: None,
            uncertainty: Uncertainty::default(),
            group: None,
            growth: Growth::None,
            subtotal: None,
            allowable: None,
        }
    }

    /// Returns a row with an exactly known part, in a frame at the parent's origin and along its
    /// axes.
    pub fn part(name: impl Into<String>, part: GivenPart) -> Self {
        Self { part: Some(part), ..Self::frame(name) }
    }
}

/// Number of copies of a row. All copies are at the same place, so only their sum matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Number of copies, at least 1.
    pub count: u32,
    /// Correlation between the errors of the copies.
    pub errors: CopyErrors,
}

impl Quantity {
    /// Quantity of one copy.
    pub const ONE: Self = Self { count: 1, errors: CopyErrors::Alike };
}

/// Correlation between the errors of copies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CopyErrors {
    /// All copies have the same error, for example because one estimate is used for all. The
    /// standard deviation of n copies is n times that of one.
    Alike,
    /// Each copy has its own error, for example because each was weighed. The standard deviation of
    /// n copies is √n times that of one. Not allowed for rows with children.
    Independent,
}

impl CopyErrors {
    /// Both variants with their names in lists.
    pub(crate) const NAMED: [(&str, Self); 2] = [("alike", Self::Alike), ("independent", Self::Independent)];

    pub(crate) const fn name(self) -> &'static str {
        Self::NAMED[self as usize].0
    }
}

/// Position and orientation of a frame in its parent's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Origin of the frame, parent axes, m.
    pub position: Position<Part>,
    /// Rotation R_parent_own from the row's axes to the parent's axes.
    pub rotation: Rotation<Part, Part>,
}

impl Default for Place {
    fn default() -> Self {
        Self { position: Position::ZERO, rotation: Rotation::identity() }
    }
}

/// Part as given in a list, in its row's frame.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenPart {
    /// Basic mass of one copy, kg.
    pub mass: f64,
    /// Centre of mass, m.
    pub center_of_mass: Position<Part>,
    /// Inertia tensor, kg·m².
    pub tensor: GivenTensor,
}

impl GivenPart {
    /// Returns a point mass, kg, at a position, m.
    pub fn point(mass: f64, at: Position<Part>) -> Self {
        Self { mass, center_of_mass: at, tensor: GivenTensor::ZERO }
    }

    /// Returns the mass properties of a body as a part.
    pub(crate) fn of(body: &MassProperties<Part>) -> Self {
        let [[xx, xy, xz], [_, yy, yz], [.., zz]] = body.inertia().matrix();
        let tensor = GivenTensor {
            moments: [xx, yy, zz],
            products: [xy, xz, yz],
            sign: ProductSign::NegativeIntegral,
            about: TensorPoint::CenterOfMass,
        };
        Self { mass: body.mass(), center_of_mass: body.center_of_mass(), tensor }
    }
}

/// Mass that a list states for a row with its descendants.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subtotal {
    /// Stated mass, kg.
    pub mass: f64,
    /// Largest allowed difference from the sum, kg: half a unit of the last printed digit.
    pub tolerance: f64,
}
