//! Inertia tensors as lists give them: about some point, with products of either sign.

use polhode::body::{BodyError, InertiaAbout, InertiaTensor, MassProperties};
use polhode::math::{Frame, Part, Position};

/// A tensor along the axes of its row.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenTensor {
    /// Ixx, Iyy, Izz, kg·m².
    pub moments: [f64; 3],
    /// Ixy, Ixz, Iyz, kg·m².
    pub products: [f64; 3],
    /// What a product is.
    pub sign: ProductSign,
    /// The point that it is about.
    pub about: TensorPoint,
}

/// What is called a product of inertia: never guessed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProductSign {
    /// Ixy = −∫ x y dm: an element of the tensor.
    NegativeIntegral,
    /// Ixy = ∫ x y dm: minus an element.
    PositiveIntegral,
}

/// The point that a tensor is about.
#[derive(Clone, Debug, PartialEq)]
pub enum TensorPoint {
    /// The part's own centre of mass.
    CenterOfMass,
    /// A point in the row's frame, m.
    At(Position<Part>),
    /// The origin of another row's frame, where the list has it; what is uncertain of places moves this point with the row's own frame.
    OriginOf(String),
}

impl GivenTensor {
    /// Of a point.
    pub const ZERO: Self = Self {
        moments: [0.0; 3],
        products: [0.0; 3],
        sign: ProductSign::NegativeIntegral,
        about: TensorPoint::CenterOfMass,
    };

    /// The elements xx, yy, zz, xy, xz, yz of the tensor itself.
    pub(crate) fn elements(&self) -> [f64; 6] {
        let ([xx, yy, zz], sign) = (self.moments, self.sign.factor());
        let [xy, xz, yz] = self.products.map(|product| sign * product);
        [xx, yy, zz, xy, xz, yz]
    }
}

impl ProductSign {
    /// Both, with their names.
    pub(crate) const NAMED: [(&str, Self); 2] =
        [("tensor elements", Self::NegativeIntegral), ("positive integrals", Self::PositiveIntegral)];

    pub(crate) const fn name(self) -> &'static str {
        Self::NAMED[self as usize].0
    }

    /// By what a product is multiplied to be an element of the tensor.
    pub(crate) const fn factor(self) -> f64 {
        match self {
            Self::NegativeIntegral => 1.0,
            Self::PositiveIntegral => -1.0,
        }
    }
}

/// The mass properties of a mass with a tensor about a point, or its own centre.
pub(crate) fn mass_properties(
    mass: f64,
    center: Position<Part>,
    elements: [f64; 6],
    about: Option<Position<Part>>,
) -> Result<MassProperties<Part>, BodyError> {
    match about {
        None => MassProperties::new(mass, center, InertiaTensor::from_matrix(rows(elements))?),
        Some(point) => MassProperties::from_inertia_about(
            mass,
            center,
            &InertiaAbout::from_matrix(point, rows(elements))?,
        ),
    }
}

/// A body of the same form, so many times as heavy.
pub(crate) fn scaled<F: Frame>(
    body: &MassProperties<F>,
    factor: f64,
) -> Result<MassProperties<F>, BodyError> {
    if factor == 1.0 {
        return Ok(*body);
    }
    let rows = body.inertia().matrix().map(|row| row.map(|element| element * factor));
    MassProperties::new(body.mass() * factor, body.center_of_mass(), InertiaTensor::from_matrix(rows)?)
}

/// The matrix of xx, yy, zz, xy, xz, yz.
pub(crate) const fn rows([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> [[f64; 3]; 3] {
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

/// The elements xx, yy, zz, xy, xz, yz of a matrix.
pub(crate) const fn elements([[xx, xy, xz], [_, yy, yz], [_, _, zz]]: [[f64; 3]; 3]) -> [f64; 6] {
    [xx, yy, zz, xy, xz, yz]
}

/// u·v 1 − ½ (u vᵀ + v uᵀ): of u = v = d, what a unit mass at d adds to a tensor.
pub(crate) fn steiner([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 6] {
    [
        b * y + c * z,
        a * x + c * z,
        a * x + b * y,
        -0.5 * (a * y + b * x),
        -0.5 * (a * z + c * x),
        -0.5 * (b * z + c * y),
    ]
}

/// a + s b
pub(crate) fn plus(a: [f64; 6], b: [f64; 6], s: f64) -> [f64; 6] {
    core::array::from_fn(|k| a[k] + s * b[k])
}
