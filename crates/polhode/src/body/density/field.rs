//! Solids whose density depends on position.

use super::cubature::{Subdivision, Totals};
use super::domain::{Brick, Domain};
use super::parametrised::Parametrised;
use crate::body::error::{BodyError, positive};
use crate::body::mass_properties::MassProperties;
use crate::body::mesh::closed::ClosedMesh;
use crate::body::shape::Shape;
use crate::math::frame::Part;
use crate::math::vector::Position;

/// Density ρ(x, y, z), kg/m³, as a function of position, m, along the solid's own axes.
///
/// Every function `Fn([f64; 3]) -> f64` implements this trait. The density must depend on the
/// position only; otherwise the result is meaningless.
pub trait DensityField {
    /// Returns ρ at a point, kg/m³.
    fn density(&self, point: [f64; 3]) -> f64;

    /// Computes ρ at many points. Override it if evaluating many points together is faster than one
    /// by one.
    fn densities(&self, points: &[[f64; 3]], densities: &mut [f64]) {
        for (density, &point) in densities.iter_mut().zip(points) {
            *density = self.density(point);
        }
    }
}

impl<F: Fn([f64; 3]) -> f64> DensityField for F {
    fn density(&self, point: [f64; 3]) -> f64 {
        self(point)
    }
}

/// Solid over which a density is integrated.
#[derive(Clone, Copy, Debug)]
pub enum Solid<'a> {
    /// Polyhedron.
    ///
    /// It is divided into signed tetrahedra from its centroid to each triangle. Therefore ρ must be
    /// finite in the whole convex hull, including holes outside the body. If the tetrahedra extend
    /// far outside the body, terms cancel and digits are lost; the error estimate includes this.
    Mesh(&'a ClosedMesh),
    /// Shape with a smooth parametrisation. ρ is never evaluated outside the shape.
    Shape(&'a dyn Parametrised),
}

/// Tolerance and evaluation limit of the adaptive cubature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cubature {
    /// Largest accepted error estimate. It applies to the mass (relative) and to the centre of mass
    /// (relative to the body's size √(∫ρ r² dV / M), with r from the centre of mass). It also
    /// applies to each element of the inertia tensor (relative to half its trace).
    pub tolerance: f64,
    /// Maximum number of density evaluations. A billion of them need up to 0.4 GB of memory.
    ///
    /// `None` means 3·10⁸, or ten times the evaluations of the initial pass over all charts or
    /// triangles, whichever is larger. No mesh then has too many triangles, and the computation
    /// ends even if the tolerance cannot be reached.
    pub max_evaluations: Option<u64>,
}

impl Default for Cubature {
    /// Returns a tolerance of 1e-10 and the evaluation limit of `None`.
    fn default() -> Self {
        Self { tolerance: 1e-10, max_evaluations: None }
    }
}

impl Cubature {
    /// Returns the maximum number of evaluations, if the initial pass takes `first`.
    fn limit(&self, first: u64) -> u64 {
        const ENOUGH: u64 = 300_000_000;
        self.max_evaluations.unwrap_or(ENOUGH.max(first.saturating_mul(10)))
    }
}

/// Mass properties of a body of varying density, with error estimates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldMassProperties {
    /// Mass, centre of mass, and inertia tensor about it.
    pub properties: MassProperties<Part>,
    /// Estimated errors of `properties`.
    pub error_estimate: FieldError,
    /// Volume of the solid, m³, in closed form.
    pub volume: f64,
    /// Number of density evaluations.
    pub evaluations: u64,
}

/// Estimated errors of [`FieldMassProperties`].
///
/// The result in every piece is compared with that of an embedded rule of lower degree. The
/// absolute differences and the rounding bounds of the sums are added. The estimate is far too
/// large for a smooth density, and too large by a moderate factor for a density with steps. It
/// knows only the samples: it cannot detect a feature that lies between all of them, such as a
/// small inclusion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldError {
    /// Error of the mass, kg.
    pub mass: f64,
    /// Error of the centre of mass, as a distance, m.
    pub center_of_mass: f64,
    /// Error of the inertia tensor's elements, relative to half its trace.
    pub inertia: f64,
}

/// Computes the mass properties of a solid with density ρ(x, y, z), by adaptive cubature.
///
/// M = ∫ρ dV,  M c = ∫ρ x dV,  I = ∫ρ (r² 1 − r rᵀ) dV,  r = x − c
///
/// A solid is the image of unit cubes: one for each chart of a shape, one for each signed
/// tetrahedron of a mesh. Product Gauss–Kronrod rules integrate over the cubes. The piece with the
/// largest error is halved until the error estimate of the whole is within the tolerance. A
/// polynomial density of degree 7 or less is integrated exactly over a mesh. Smooth densities
/// converge fast. Steps and kinks converge slowly, except along the coordinates of the shape.
///
/// A shape costs at least 3375 evaluations for each chart. A mesh costs 3375 for each triangle, or
/// 735 if it has more than 1000 triangles. The time is proportional to that. A piece takes about
/// 0.3 kB of memory, or none if division would not improve it.
///
/// ```
/// use polhode::body::density::{Cubature, Solid, mass_properties_of_field};
/// use polhode::body::shape::Sphere;
/// // A planet of radius 1, 5000 kg/m³ in the middle and 3000 at the surface: M = 4π (5000/3 − 2000/4)
/// let planet = Sphere::new(1.0)?;
/// let density = |[x, y, z]: [f64; 3]| 5000.0 - 2000.0 * (x * x + y * y + z * z).sqrt();
/// let body = mass_properties_of_field(Solid::Shape(&planet), &density, Cubature::default())?;
/// let exact = 4.0 * std::f64::consts::PI * (5000.0 / 3.0 - 500.0);
/// assert!((body.properties.mass() - exact).abs() < body.error_estimate.mass);
/// assert!(body.error_estimate.mass < 1e-10 * exact);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
///
/// # Errors
/// [`BodyError::Density`] if ρ is negative inside or not finite anywhere; [`BodyError::Cubature`]
/// if the tolerance is not reached; [`BodyError::Parameter`] if ρ is zero everywhere, or if the
/// result overflows f64.
pub fn mass_properties_of_field(
    solid: Solid<'_>,
    density: &(impl DensityField + ?Sized),
    cubature: Cubature,
) -> Result<FieldMassProperties, BodyError> {
    let tolerance = cubature.tolerance;
    positive("the tolerance", tolerance)?;
    let domain = solid.domain();
    let mut subdivision = Subdivision::new(&domain);
    let mut sample = |brick: &Brick, points: &[[f64; 3]], densities: &mut [f64]| {
        density.densities(points, densities);
        require_density(solid, &domain, brick, points, densities)
    };
    let unreached = |reached, evaluations| BodyError::Cubature { tolerance, reached, evaluations };

    let bricks = domain.bricks();
    let first = (bricks.len() as u64).saturating_mul(subdivision.samples_per_brick());
    let max_evaluations = cubature.limit(first);
    if first > max_evaluations {
        return Err(unreached(f64::INFINITY, 0));
    }
    for brick in bricks {
        subdivision.add(brick, &mut sample)?;
    }
    let mut totals = subdivision.totals();
    let mut next_sum = 2 * subdivision.bricks();
    loop {
        if worst(&totals) <= tolerance {
            // The running totals accumulate rounding; the totals summed again here do not.
            totals = subdivision.totals();
            if worst(&totals) <= tolerance {
                return finish(solid, &domain, &totals, subdivision.evaluations);
            }
        }
        let cost = 2 * subdivision.samples_per_brick();
        if subdivision.evaluations.saturating_add(cost) > max_evaluations {
            return Err(unreached(worst(&subdivision.totals()), subdivision.evaluations));
        }
        match subdivision.refine(&mut sample)? {
            Some(change) => totals.replace(&change),
            None if subdivision.totals().mass() == 0.0 => {
                positive("the mass", 0.0)?;
            }
            None => return Err(unreached(worst(&subdivision.totals()), subdivision.evaluations)),
        }
        if subdivision.bricks() >= next_sum {
            totals = subdivision.totals();
            next_sum *= 2;
        }
    }
}

/// Returns the largest of the relative errors; infinite while the sums are not those of a physical
/// body.
fn worst(totals: &Totals) -> f64 {
    let covariance = totals.covariance();
    let size = (covariance.xx + covariance.yy + covariance.zz).sqrt();
    let [mass, center, inertia] = totals.relative_errors();
    let worst = mass.max(center / size).max(inertia);
    if totals.mass() > 0.0 && size > 0.0 && worst.is_finite() { worst } else { f64::INFINITY }
}

fn finish(
    solid: Solid<'_>,
    domain: &Domain<'_>,
    totals: &Totals,
    evaluations: u64,
) -> Result<FieldMassProperties, BodyError> {
    let unit = domain.unit();
    let mass = totals.mass() * unit * unit * unit;
    let center = Position::from_array(domain.reference()) + Position::from_array(totals.center()) * unit;
    let properties = MassProperties::from_covariance(mass, center, &(totals.covariance() * unit * unit))?;
    let [of_mass, of_center, inertia] = totals.relative_errors();
    // The position of the centre is rounded too, in proportion to its distance from the origin.
    let rounding = f64::EPSILON * center.max_abs();
    let error_estimate =
        FieldError { mass: of_mass * mass, center_of_mass: of_center * unit + rounding, inertia };
    let volume = solid.shape().spread().extent().measure();
    Ok(FieldMassProperties { properties, error_estimate, volume, evaluations })
}

/// Returns an error for a density that is not finite, or negative in the solid.
fn require_density(
    solid: Solid<'_>,
    domain: &Domain<'_>,
    brick: &Brick,
    points: &[[f64; 3]],
    densities: &[f64],
) -> Result<(), BodyError> {
    let samples = || densities.iter().zip(points);
    if let Some((&value, &at)) = samples().find(|(value, _)| !value.is_finite()) {
        return Err(BodyError::Density { at, value });
    }
    // A single test per brick, because a mesh has many.
    let Some((&value, &at)) = samples().min_by(|a, b| a.0.total_cmp(b.0)) else { return Ok(()) };
    let inside = || match solid {
        // A point of the body is in a positive brick, perhaps also in a negative one.
        Solid::Mesh(mesh) => !domain.is_negative(brick) && winding_number(mesh, at) > 0.5,
        Solid::Shape(_) => true,
    };
    if value < 0.0 && inside() { Err(BodyError::Density { at, value }) } else { Ok(()) }
}

/// Returns the winding number of the mesh about a point: Σ Ω/4π, with the solid angle Ω of the
/// triangle (a, b, c) seen from the point:
///
/// tan(Ω/2) = a · (b × c) / (abc + (a · b) c + (a · c) b + (b · c) a)
///
/// Source: van Oosterom & Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125.
fn winding_number(mesh: &ClosedMesh, point: [f64; 3]) -> f64 {
    let angle = |triangle: [[f64; 3]; 3]| {
        let [a, b, c] =
            triangle.map(|p| Position::<Part>::from_array(core::array::from_fn(|k| p[k] - point[k])));
        let (na, nb, nc) = (a.norm(), b.norm(), c.norm());
        let triple =
            a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
        2.0 * libm::atan2(triple, na * nb * nc + a.dot(b) * nc + a.dot(c) * nb + b.dot(c) * na)
    };
    mesh.triangles().map(angle).sum::<f64>() / (4.0 * core::f64::consts::PI)
}

impl<'a> Solid<'a> {
    fn shape(self) -> &'a dyn Shape {
        match self {
            Self::Mesh(mesh) => mesh,
            Self::Shape(shape) => shape,
        }
    }

    fn domain(self) -> Domain<'a> {
        let spread = self.shape().spread();
        let (centroid, size) = (spread.centroid().to_array(), spread.size_squared().sqrt());
        match self {
            Self::Mesh(mesh) => Domain::of_surface(mesh.surface(), centroid, size),
            Self::Shape(shape) => Domain::of_shape(shape, centroid, size),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_mesh_has_too_many_triangles_unless_its_user_says_so() {
        let samples = 735 * 5_000_000;
        let of = |max_evaluations| Cubature { tolerance: 1e-10, max_evaluations };
        assert_eq!(of(None).limit(samples), 10 * samples);
        assert_eq!(of(None).limit(3375), 300_000_000);
        assert_eq!(of(None).limit(u64::MAX), u64::MAX);
        assert_eq!(of(Some(1_000_000)).limit(samples), 1_000_000);
    }
}
