//! Shapes of uniform density with closed-form mass integrals, each in its own file.
//!
//! A shape says how its mass is spread over it per unit mass; how heavy it is comes from a [`Substance`].

pub(crate) mod r#box;
pub(crate) mod box_shell;
pub(crate) mod capsule;
pub(crate) mod cone;
pub(crate) mod cone_shell;
pub(crate) mod cylinder;
pub(crate) mod cylinder_shell;
pub(crate) mod disk;
pub(crate) mod ellipsoid;
pub(crate) mod plate;
pub(crate) mod rod;
pub(crate) mod sphere;
pub(crate) mod sphere_shell;
pub(crate) mod tetrahedron;
pub(crate) mod torus;
pub(crate) mod triangle;
pub(crate) mod triangular_plate;
pub(crate) mod triangular_prism;

pub use r#box::BoxShape;
pub use box_shell::BoxShell;
pub use capsule::Capsule;
pub use cone::Cone;
pub use cone_shell::ConeShell;
pub use cylinder::Cylinder;
pub use cylinder_shell::CylinderShell;
pub use disk::Disk;
pub use ellipsoid::Ellipsoid;
pub use plate::Plate;
pub use rod::Rod;
pub use sphere::Sphere;
pub use sphere_shell::SphereShell;
pub use tetrahedron::Tetrahedron;
pub use torus::Torus;
pub use triangular_plate::TriangularPlate;
pub use triangular_prism::TriangularPrism;

use core::fmt;

use super::error::{BodyError, not_negative, positive};
use super::form::Form;
use super::mass_properties::MassProperties;
use crate::math::frame::Part;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Position;

/// A body of uniform density, described in its own [`Part`] axes.
///
/// The constructors refuse, with [`BodyError::Parameter`], what is so small or so large that f64 does not hold its
/// volume, area or length, or its mean square size.
pub trait Shape: fmt::Debug + Send + Sync {
    /// Over what the mass is spread, how much of it there is, and how it lies about its centre.
    fn spread(&self) -> Spread;

    /// Area that bounds a solid, or of one side of a thin shell or plate, m²; a thin rod has none.
    fn surface_area(&self) -> f64;

    /// What it looks like, for those who draw it; `None` where only the moments are known.
    fn form(&self) -> Option<Form> {
        None
    }

    /// Mass properties of the shape made of a substance.
    ///
    /// # Errors
    /// [`BodyError`] if the substance does not fit the shape (kg/m³ for a thin plate), or a number is not
    /// positive and finite.
    fn mass_properties(&self, substance: Substance) -> Result<MassProperties<Part>, BodyError> {
        let spread = self.spread();
        let mass = substance.mass_of(spread.extent)?;
        in_range("the moment of inertia", spread.size_squared() * mass)?;
        MassProperties::from_covariance(mass, spread.centroid, &spread.covariance)
    }
}

/// How a uniform mass is spread over a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    pub(crate) extent: Extent,
    pub(crate) centroid: Position<Part>,
    /// Second moments about the centroid per unit mass, ∫ x xᵀ dm / M: positive semi-definite, so that every
    /// tensor made of it is possible.
    pub(crate) covariance: Symmetric3,
}

impl Spread {
    /// Volume, area or length.
    pub const fn extent(&self) -> Extent {
        self.extent
    }

    /// Where the centre of mass is.
    pub const fn centroid(&self) -> Position<Part> {
        self.centroid
    }

    /// Mean square distance from the centroid: the trace of the second moments.
    pub(crate) fn size_squared(&self) -> f64 {
        self.covariance.xx + self.covariance.yy + self.covariance.zz
    }

    /// The spread, if f64 holds its numbers: at 1e-110 m a volume is 0, at 1e160 m an area is infinite.
    pub(crate) fn representable(self) -> Result<Self, BodyError> {
        let what = match self.extent {
            Extent::Volume(_) => "the volume",
            Extent::Area(_) => "the area",
            Extent::Length(_) => "the length",
        };
        in_range(what, self.extent.measure())?;
        in_range("the mean square size", self.size_squared())?;
        Ok(self)
    }

    /// A spread about the origin, with second moments (⟨x²⟩, ⟨y²⟩, ⟨z²⟩) and no products.
    pub(crate) fn centered(extent: Extent, second_moments: [f64; 3]) -> Self {
        Self { extent, centroid: Position::ZERO, covariance: Symmetric3::diagonal(second_moments) }
    }

    /// The same spread elsewhere.
    pub(crate) fn moved(self, by: Position<Part>) -> Self {
        Self { centroid: self.centroid + by, ..self }
    }

    /// This spread and others as one, each weighted by its own volume, area or length: the faces of a can.
    ///
    /// c = Σ w_k c_k,  S = Σ w_k (S_k + d_k d_kᵀ),  d_k = c_k − c.  All must be of this one's kind.
    pub(crate) fn joined(self, others: &[Self]) -> Self {
        let parts = || core::iter::once(&self).chain(others);
        let total: f64 = parts().map(|p| p.extent.measure()).sum();
        let weight = |p: &Self| p.extent.measure() / total;
        let centroid = parts().fold(Position::ZERO, |sum, p| sum + p.centroid * weight(p));
        let covariance = parts().fold(Symmetric3::default(), |sum, p| {
            let d = (p.centroid - centroid).to_array();
            sum + (p.covariance + Symmetric3::outer(d)) * weight(p)
        });
        Self { extent: self.extent.with_measure(total), centroid, covariance }
    }
}

/// The shape, if f64 holds the numbers of its spread.
fn representable<S: Shape>(shape: S) -> Result<S, BodyError> {
    shape.spread().representable().map(|_| shape)
}

/// An inner radius, if it leaves a wall.
fn hollow(what: &'static str, inner_radius: f64, radius: f64) -> Result<f64, BodyError> {
    if not_negative(what, inner_radius)? < radius {
        return Ok(inner_radius);
    }
    Err(BodyError::Parameter { what, value: inner_radius, rule: "less than its radius" })
}

/// Refuses what is not positive and finite with all its digits.
fn in_range(what: &'static str, value: f64) -> Result<(), BodyError> {
    if value >= f64::MIN_POSITIVE && value.is_finite() {
        return Ok(());
    }
    Err(BodyError::Parameter { what, value, rule: "positive and finite: too large or too small for f64" })
}

/// Over what a shape's mass is spread, and how much of it there is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// A solid, m³.
    Volume(f64),
    /// A thin shell or plate, m².
    Area(f64),
    /// A thin rod, m.
    Length(f64),
}

impl Extent {
    /// The number of m³, m² or m.
    pub const fn measure(self) -> f64 {
        match self {
            Self::Volume(m) | Self::Area(m) | Self::Length(m) => m,
        }
    }

    /// The volume of a solid; `None` for what is thin.
    pub const fn volume(self) -> Option<f64> {
        match self {
            Self::Volume(v) => Some(v),
            _ => None,
        }
    }

    const fn with_measure(self, measure: f64) -> Self {
        match self {
            Self::Volume(_) => Self::Volume(measure),
            Self::Area(_) => Self::Area(measure),
            Self::Length(_) => Self::Length(measure),
        }
    }
}

/// What a shape is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Substance {
    /// The whole mass, kg: fits every shape.
    Mass(f64),
    /// Density, kg/m³: for solids.
    Density(f64),
    /// Mass per area, kg/m²: for thin shells and plates.
    AreaDensity(f64),
    /// Mass per length, kg/m: for thin rods.
    LineDensity(f64),
}

impl Substance {
    fn mass_of(self, extent: Extent) -> Result<f64, BodyError> {
        let mass = match (self, extent) {
            (Self::Mass(mass), _) => positive("the mass", mass)?,
            (Self::Density(rho), Extent::Volume(v)) => positive("the density", rho)? * v,
            (Self::AreaDensity(sigma), Extent::Area(a)) => positive("the area density", sigma)? * a,
            (Self::LineDensity(lambda), Extent::Length(l)) => positive("the line density", lambda)? * l,
            (Self::Density(value) | Self::AreaDensity(value) | Self::LineDensity(value), extent) => {
                let rule = match extent {
                    Extent::Volume(_) => "in kg/m³, since the shape is solid",
                    Extent::Area(_) => "in kg/m², since the shape is thin",
                    Extent::Length(_) => "in kg/m, since the shape is a thin rod",
                };
                return Err(BodyError::Parameter { what: "the density", value, rule });
            }
        };
        positive("the mass", mass)
    }
}
