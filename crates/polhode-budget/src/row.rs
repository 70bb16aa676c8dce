//! What a parts list says, row by row.

use polhode::body::MassProperties;
use polhode::math::{Part, Position, Rotation};

use crate::growth::Growth;
use crate::tensor::{GivenTensor, ProductSign, TensorPoint};
use crate::uncertainty::Uncertainty;

/// A row of a parts list: a frame, a part in it, or both.
///
/// Its frame stands in that of the row [`Row::parent`] or, without, of the row that [`Row::name`] begins with: `bus/battery` in `bus`. One row stands in none: its
/// parent is the body.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its name, or its path: unique.
    pub name: String,
    /// The name of the row in whose frame it stands, if its path does not say so.
    pub parent: Option<String>,
    /// How many there are.
    pub quantity: Quantity,
    /// Where its frame is in its parent's.
    pub place: Place,
    /// What has mass in it, besides the rows that stand in it.
    pub part: Option<GivenPart>,
    /// How well all that is known.
    pub uncertainty: Uncertainty,
    /// The group with which its errors are correlated.
    pub group: Option<String>,
    /// How much heavier the part is expected to become.
    pub growth: Growth,
    /// The mass that the list states for this row with all in it, all copies counted, before growth.
    pub subtotal: Option<Subtotal>,
    /// Allowable mass of this row with all in it, all copies counted, kg.
    pub allowable: Option<f64>,
}

impl Row {
    /// A frame at its parent's origin and along its axes.
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

    /// A part, exactly known, in such a frame.
    pub fn part(name: impl Into<String>, part: GivenPart) -> Self {
        Self { part: Some(part), ..Self::frame(name) }
    }
}

/// Copies of a row, all at its place: what counts is their sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// How many: 1 at least.
    pub count: u32,
    /// How their errors go together.
    pub errors: CopyErrors,
}

impl Quantity {
    /// One.
    pub const ONE: Self = Self { count: 1, errors: CopyErrors::Alike };
}

/// How the errors of copies go together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CopyErrors {
    /// Each copy has the same error, as where one estimate stands for all: the standard deviation of n is n times that of one.
    Alike,
    /// Each has its own, as weighed units have: √n times. For rows in which no other stands.
    Independent,
}

impl CopyErrors {
    /// Both, with their names.
    pub(crate) const NAMED: [(&str, Self); 2] = [("alike", Self::Alike), ("independent", Self::Independent)];

    pub(crate) const fn name(self) -> &'static str {
        Self::NAMED[self as usize].0
    }
}

/// Where a frame is in another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Its origin, m.
    pub position: Position<Part>,
    /// R_parent_own.
    pub rotation: Rotation<Part, Part>,
}

impl Default for Place {
    fn default() -> Self {
        Self { position: Position::ZERO, rotation: Rotation::identity() }
    }
}

/// A part as a list gives it, in its row's frame.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenPart {
    /// Basic mass of one, kg.
    pub mass: f64,
    /// Centre of mass, m.
    pub center_of_mass: Position<Part>,
    /// Inertia tensor.
    pub tensor: GivenTensor,
}

impl GivenPart {
    /// All the mass at one point.
    pub fn point(mass: f64, at: Position<Part>) -> Self {
        Self { mass, center_of_mass: at, tensor: GivenTensor::ZERO }
    }

    /// Returns a body as a part.
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

/// A mass that a list states for a row with all in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subtotal {
    /// kg
    pub mass: f64,
    /// By how much the sum may differ, kg: half of the last digit that is printed.
    pub tolerance: f64,
}
