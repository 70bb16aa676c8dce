//! Bodies: mass, centre of mass and inertia tensor. This module does not depend on time.
//!
//! Every description of a body gives [`MassProperties`]: mass m, centre of mass c, and the
//! [`InertiaTensor`] about it,
//!
//! I = ∫ (|r|² 1 − r rᵀ) dm,  r from the centre of mass.
//!
//! | description of the body | function or module |
//! |---|---|
//! | particles, atoms | [`mass_properties_of_particles`] |
//! | a box, a sphere, a rod … | [`shape`]: closed forms |
//! | a triangle mesh | [`mesh`]: diagnosis, then exact integrals; or its convex hull, or a shell |
//! | a varying density, voxels | [`density`]: cubature with an error bound, exact sums |
//! | parts | [`assemble`]: each at its position and orientation, by the parallel-axis theorem |
//! | a known tensor | [`InertiaTensor::with_negative_products`]; [`InertiaAbout`] for another point
//! |
//!
//! Derivatives of mass properties with respect to densities, positions of parts, particles and mesh
//! vertices: [`AssemblyDerivatives`], [`ParticleDerivatives`], [`mesh::MeshDerivatives`].
//!
//! Off-diagonal elements are minus the products of inertia, I_xy = −∫ x y dm. [`PrincipalFrame`]
//! has the principal moments, ascending, and axes. A tensor that no distribution of mass can have
//! (one that violates the triangle inequality I₁ + I₂ ≥ I₃) is a [`BodyError`]; [`nearest_possible`]
//! proposes the nearest possible ones.

pub(crate) mod assembly;
mod assembly_derivatives;
pub mod density;
mod derivative;
pub(crate) mod error;
pub(crate) mod finding;
pub(crate) mod form;
pub(crate) mod inertia;
pub(crate) mod mass_properties;
pub(crate) mod material;
pub mod mesh;
mod moment_triangle;
mod nearest;
mod particle_derivatives;
pub(crate) mod particles;
pub(crate) mod principal;
pub mod shape;
pub(crate) mod solid;
mod triangle_mesh;

pub use assembly::{BodyPart, PlacedPart, assemble};
pub use assembly_derivatives::{AssemblyDerivatives, PartDerivatives};
pub use derivative::{MassPropertiesDerivative, MassPropertiesGradient};
pub use error::BodyError;
pub use finding::{Finding, Severity};
pub use form::{Form, PlacedForm};
pub use inertia::{InertiaAbout, InertiaTensor};
pub use mass_properties::MassProperties;
pub use material::Material;
pub use moment_triangle::{MOMENT_TRIANGLE, place_in_moment_triangle, possible_ratios, ratio_region};
pub use nearest::{Nearest, NearestPossible, nearest_possible};
pub use particle_derivatives::ParticleDerivatives;
pub use particles::{Particle, mass_properties_of_particles};
pub use principal::{PrincipalFrame, Symmetry};
pub use solid::MeasuredSolid;
