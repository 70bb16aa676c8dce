//! Inertia tensors as given in lists: about any point, with products of either sign.

use polhode::body::{BodyError, InertiaAbout, InertiaTensor, MassProperties};
use polhode::math::{Frame, Part, Position};

/// Inertia tensor along the axes of its row.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenTensor {
    /// Ixx, Iyy, Izz, kg·m².
    pub moments: [f64; 3],
    /// Ixy, Ixz, Iyz, kg·m².
    pub products: [f64; 3],
    /// Sign convention of the products.
    pub sign: ProductSign,
    /// Reference point of the tensor.
    pub about: TensorPoint,
}

/// Sign convention of products of inertia. It must be given; it is never guessed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProductSign {
    /// Ixy = −∫ x y dm: the tensor element.
    NegativeIntegral,
    /// Ixy = ∫ x y dm: minus the tensor element.
    PositiveIntegral,
}

/// Reference point of a tensor.
#[derive(Clone, Debug, PartialEq)]
pub enum TensorPoint {
    /// Centre of mass of the part.
    CenterOfMass,
    /// Point in the row's frame, m.
    At(Position<Part>),
    /// Origin of another row's frame, at its nominal place in the list. Errors of the row's own
    /// place move this point with the row's frame.
    OriginOf(String),
}

impl GivenTensor {
    /// Tensor of a point mass.
    pub const ZERO: Self = Self {
        moments: [0.0; 3],
        products: [0.0; 3],
        sign: ProductSign::NegativeIntegral,
        about: TensorPoint::CenterOfMass,
    };

    /// Returns the elements xx, yy, zz, xy, xz, yz of the tensor, kg·m².
    pub(crate) fn elements(&self) -> [f64; 6] {
        let ([xx, yy, zz], sign) = (self.moments, self.sign.factor());
        let [xy, xz, yz] = self.products.map(|product| sign * product);
        [xx, yy, zz, xy, xz, yz]
    }
}

impl ProductSign {
    /// Both variants with their names.
    pub(crate) const NAMED: [(&str, Self); 2] =
        [("tensor elements", Self::NegativeIntegral), ("positive integrals", Self::PositiveIntegral)];

    pub(crate) const fn name(self) -> &'static str {
        Self::NAMED[self as usize].0
    }

    /// Returns the factor from a product to the tensor element: 1 or −1.
    pub(crate) const fn factor(self) -> f64 {
        match self {
            Self::NegativeIntegral => 1.0,
            Self::PositiveIntegral => -1.0,
        }
    }
}

/// Returns the mass properties of a mass with a tensor about a point, or about its centre of mass.
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

/// Returns a body of the same form, with its mass multiplied by `factor`.
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

/// Returns the symmetric matrix of the elements xx, yy, zz, xy, xz, yz.
pub(crate) const fn rows([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> [[f64; 3]; 3] {
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

/// Returns the elements xx, yy, zz, xy, xz, yz of a symmetric matrix.
pub(crate) const fn elements([[xx, xy, xz], [_, yy, yz], [_, _, zz]]: [[f64; 3]; 3]) -> [f64; 6] {
    [xx, yy, zz, xy, xz, yz]
}

/// Returns u·v 1 − ½ (u vᵀ + v uᵀ). With u = v = d, it is the tensor of a unit mass at d.
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

/// Returns a + s b.
pub(crate) fn plus(a: [f64; 6], b: [f64; 6], s: f64) -> [f64; 6] {
    core::array::from_fn(|k| a[k] + s * b[k])
}
