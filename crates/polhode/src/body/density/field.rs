//! Solids whose density is a function of place.

use super::cubature::{Subdivision, Totals};
use super::domain::{Brick, Domain};
use super::parametrised::Parametrised;
use crate::body::error::{BodyError, positive};
use crate::body::mass_properties::MassProperties;
use crate::body::mesh::closed::ClosedMesh;
use crate::body::shape::Shape;
use crate::math::frame::Part;
use crate::math::vector::Position;

/// A density ρ(x, y, z), kg/m³, of a place in m along the solid's own axes.
///
/// Every function `Fn([f64; 3]) -> f64` is one. It must not depend on anything else, or the answer means nothing.
pub trait DensityField {
    /// ρ at a point, kg/m³.
    fn density(&self, point: [f64; 3]) -> f64;

    /// ρ at many points: whoever can do better than one after the other does it here.
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

/// What a density is spread over.
#[derive(Clone, Copy, Debug)]
pub enum Solid<'a> {
    /// A polyhedron.
    ///
    /// It is divided into signed tetrahedra from its centroid to each triangle, so that ρ must be finite in its convex
    /// hull, also where the body is not: in its holes. Where it leaves the body by much, digits cancel, and the error
    /// estimate says so.
    Mesh(&'a ClosedMesh),
    /// A shape with a smooth parametrisation. ρ is never asked for outside.
    Shape(&'a dyn Parametrised),
}

/// How far to go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cubature {
    /// The estimated error that is good enough: of the mass relative to it, of the centre of mass relative to the
    /// body's size √(∫ρ r² dV / M), r from the centre of mass, and of each element of the inertia tensor relative to half its trace.
    pub tolerance: f64,
    /// How many values of ρ may be asked for. A billion of them need up to 0.4 GB of memory.
    ///
    /// `None`: 3·10⁸, or ten times what the first look at every chart or triangle takes, whichever is more. No mesh has too
    /// many triangles then, and a tolerance out of reach still ends.
    pub max_evaluations: Option<u64>,
}

impl Default for Cubature {
    /// A tolerance of 1e-10, and as many values as `None` allows.
    fn default() -> Self {
        Self { tolerance: 1e-10, max_evaluations: None }
    }
}

impl Cubature {
    /// How many values may be asked for, if the first look takes `first`.
    fn limit(&self, first: u64) -> u64 {
        const ENOUGH: u64 = 300_000_000;
        self.max_evaluations.unwrap_or(ENOUGH.max(first.saturating_mul(10)))
    }
}

/// Mass properties of a body of varying density, and how far they may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldMassProperties {
    /// Mass, centre of mass, inertia tensor about it.
    pub properties: MassProperties<Part>,
    /// Their errors, estimated.
    pub error_estimate: FieldError,
    /// Volume of the solid, m³, in closed form.
    pub volume: f64,
    /// How often the density was asked for.
    pub evaluations: u64,
}

/// Estimated errors of [`FieldMassProperties`].
///
/// In every piece a rule of lower degree is compared with the one that is used, and the differences are added as if all
/// had the same sign; so is the rounding of the sums. For a smooth density this is far too much, for one with
/// steps by some factor. It knows only the samples: what lies between all of them, such as a speck, stays unseen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldError {
    /// Of the mass, kg.
    pub mass: f64,
    /// Of the centre of mass, its distance, m.
    pub center_of_mass: f64,
    /// Of the inertia tensor's elements, relative to half its trace.
    pub inertia: f64,
}

/// Mass properties of a solid with the density ρ(x, y, z), by adaptive cubature.
///
/// M = ∫ρ dV,  M c = ∫ρ x dV,  I = ∫ρ (r² 1 − r rᵀ) dV,  r = x − c
///
/// A solid is the image of unit cubes: of one for each chart of a shape, of one for each signed tetrahedron of a mesh. The cubes
/// have product rules of Gauss and Kronrod, and the piece with the largest error is halved until the
/// estimate of the whole is within the tolerance. A polynomial density of degree 7 or less is integrated exactly over a
/// mesh. Smooth densities converge fast; steps and kinks slowly, except along the coordinates of the shape.
///
/// A shape costs 3375 values at least for each chart, a mesh 3375 for each triangle, or 735 where it has more than 1000.
/// Time goes with that; of memory a piece takes some 0.3 kB, and none if no division would improve it.
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
/// [`BodyError::Density`] where ρ is negative inside, or not finite anywhere; [`BodyError::Cubature`] if the
/// tolerance is not reached; [`BodyError::Parameter`] if ρ is zero everywhere, or f64 does not hold the result.
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
            // The running totals collect rounding; these do not.
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

/// The largest of the relative errors; infinite while the sums are no body's.
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
    // The centre's place is rounded too, however far from the origin.
    let rounding = f64::EPSILON * center.max_abs();
    let error_estimate =
        FieldError { mass: of_mass * mass, center_of_mass: of_center * unit + rounding, inertia };
    let volume = solid.shape().spread().extent().measure();
    Ok(FieldMassProperties { properties, error_estimate, volume, evaluations })
}

/// Refuses a density that is not finite, or negative in the solid.
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
    // One test for each brick: a mesh is long.
    let Some((&value, &at)) = samples().min_by(|a, b| a.0.total_cmp(b.0)) else { return Ok(()) };
    let inside = || match solid {
        // A point of the body is in a positive brick, if not in that only.
        Solid::Mesh(mesh) => !domain.is_negative(brick) && winding_number(mesh, at) > 0.5,
        Solid::Shape(_) => true,
    };
    if value < 0.0 && inside() { Err(BodyError::Density { at, value }) } else { Ok(()) }
}

/// How often the mesh winds around a point: Σ Ω/4π, with the solid angle Ω of the triangle (a, b, c) seen from there
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
