//! Shapes of uniform density with closed-form mass integrals, each in its own file.
//!
//! A shape defines the distribution of its mass per unit mass; a [`Substance`] defines the mass
//! itself.

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

/// Body of uniform density, described in its own [`Part`] axes.
///
/// The constructors return [`BodyError::Parameter`] if the shape is so small or so large that f64
/// cannot represent its volume, area or length, or its mean square size.
pub trait Shape: fmt::Debug + Send + Sync {
    /// Returns the distribution of mass: extent (volume, area or length), centroid, and second
    /// moments.
    fn spread(&self) -> Spread;

    /// Returns the area that bounds a solid, or of one side of a thin shell or plate, m²; zero for
    /// a thin rod.
    fn surface_area(&self) -> f64;

    /// Returns the shape for drawing; `None` if only the moments are known.
    fn form(&self) -> Option<Form> {
        None
    }

    /// Computes the mass properties of the shape made of a substance.
    ///
    /// # Errors
    /// [`BodyError`] if the substance does not fit the shape (for example kg/m³ for a thin plate),
    /// or if a number is not positive and finite.
    fn mass_properties(&self, substance: Substance) -> Result<MassProperties<Part>, BodyError> {
        let spread = self.spread();
        let mass = substance.mass_of(spread.extent)?;
        in_range("the moment of inertia", spread.size_squared() * mass)?;
        MassProperties::from_covariance(mass, spread.centroid, &spread.covariance)
    }
}

/// Distribution of a uniform mass over a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    pub(crate) extent: Extent,
    pub(crate) centroid: Position<Part>,
    /// Second moments about the centroid per unit mass, ∫ x xᵀ dm / M, m². The matrix is positive
    /// semi-definite, so that every tensor computed from it is possible.
    pub(crate) covariance: Symmetric3,
}

impl Spread {
    /// Returns the volume, area or length.
    pub const fn extent(&self) -> Extent {
        self.extent
    }

    /// Returns the centroid, which is the centre of mass, m.
    pub const fn centroid(&self) -> Position<Part> {
        self.centroid
    }

    /// Returns the mean square distance from the centroid, m²: the trace of the second moments.
    pub(crate) fn size_squared(&self) -> f64 {
        self.covariance.xx + self.covariance.yy + self.covariance.zz
    }

    /// Returns the distribution if f64 can represent its numbers: at 1e-110 m a volume is 0, at
    /// 1e160 m an area is infinite.
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

    /// Returns a distribution about the origin, with second moments (⟨x²⟩, ⟨y²⟩, ⟨z²⟩), m², and no
    /// products.
    pub(crate) fn centered(extent: Extent, second_moments: [f64; 3]) -> Self {
        Self { extent, centroid: Position::ZERO, covariance: Symmetric3::diagonal(second_moments) }
    }

    /// Returns the same distribution displaced by a vector.
    pub(crate) fn moved(self, by: Position<Part>) -> Self {
        Self { centroid: self.centroid + by, ..self }
    }

    /// Combines this distribution with others, each weighted by its own volume, area or length, for
    /// example the faces of a can.
    ///
    /// c = Σ w_k c_k,  S = Σ w_k (S_k + d_k d_kᵀ),  d_k = c_k − c.  All must have the same kind of
    /// extent as this one.
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

/// Returns the shape if f64 can represent the numbers of its distribution.
fn representable<S: Shape>(shape: S) -> Result<S, BodyError> {
    shape.spread().representable().map(|_| shape)
}

/// Returns an inner radius if it is not negative and less than the radius.
fn hollow(what: &'static str, inner_radius: f64, radius: f64) -> Result<f64, BodyError> {
    if not_negative(what, inner_radius)? < radius {
        return Ok(inner_radius);
    }
    Err(BodyError::Parameter { what, value: inner_radius, rule: "less than its radius" })
}

/// Returns an error if a value is not positive, finite and of full precision (not subnormal).
fn in_range(what: &'static str, value: f64) -> Result<(), BodyError> {
    if value >= f64::MIN_POSITIVE && value.is_finite() {
        return Ok(());
    }
    Err(BodyError::Parameter { what, value, rule: "positive and finite: too large or too small for f64" })
}

/// Extent of a shape: the volume, area or length over which its mass is distributed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// Volume of a solid, m³.
    Volume(f64),
    /// Area of a thin shell or plate, m².
    Area(f64),
    /// Length of a thin rod, m.
    Length(f64),
}

impl Extent {
    /// Returns the value in m³, m² or m.
    pub const fn measure(self) -> f64 {
        match self {
            Self::Volume(m) | Self::Area(m) | Self::Length(m) => m,
        }
    }

    /// Returns the volume of a solid, m³; `None` for a thin shape.
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

/// Substance of a shape: its mass, or its density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Substance {
    /// Total mass, kg; for every shape.
    Mass(f64),
    /// Density, kg/m³; for solids.
    Density(f64),
    /// Mass per area, kg/m²; for thin shells and plates.
    AreaDensity(f64),
    /// Mass per length, kg/m; for thin rods.
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
