//! Why something is not a body.

use core::fmt;

/// Why something is not a body: each variant carries the value and the rule that it breaks.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum BodyError {
    /// A number outside its range: a mass that is not positive, a radius that is not finite.
    Parameter {
        /// What the number is.
        what: &'static str,
        /// The number.
        value: f64,
        /// What it has to be.
        rule: &'static str,
    },
    /// A matrix that is not symmetric, so not an inertia tensor.
    NotSymmetric {
        /// Row and column, 1 to 3, of the first element that differs from its mirror image.
        element: [usize; 2],
        /// The element.
        value: f64,
        /// Its mirror image.
        mirrored: f64,
    },
    /// A tensor with a negative principal moment.
    NegativeMoment {
        /// Principal moments, ascending, kg·m².
        moments: [f64; 3],
    },
    /// A tensor whose principal moments break i1 + i2 ≥ i3, which no distribution of mass can.
    TriangleInequality {
        /// Principal moments, ascending, kg·m².
        moments: [f64; 3],
    },
    /// No particles, no parts, or no triangles.
    Empty {
        /// What is missing.
        what: &'static str,
    },
    /// A vertex that is not finite.
    Vertex {
        /// Triangle, from 1.
        triangle: usize,
        /// The vertex, m.
        vertex: [f64; 3],
    },
    /// A triangle with a corner that the mesh does not have.
    VertexIndex {
        /// Triangle, from 1.
        triangle: usize,
        /// The index, from 0.
        index: usize,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A mesh with a boundary: it encloses no volume.
    OpenMesh {
        /// Edges that belong to one triangle only.
        edges: usize,
        /// The ends of one of them, in the mesh's own units.
        example: [[f64; 3]; 2],
        /// The triangle, from 1, that the example belongs to.
        triangle: usize,
    },
    /// A mesh whose triangles do not all turn the same way: inside and outside are not defined.
    InconsistentWinding {
        /// Edges whose triangles run along them in the same direction.
        edges: usize,
        /// The ends of one of them, in the mesh's own units.
        example: [[f64; 3]; 2],
        /// The triangle, from 1, that the example belongs to.
        triangle: usize,
    },
    /// A mesh that contains a triangle twice, the same way round: a part of it would count double.
    DuplicateTriangle {
        /// The triangle, from 1.
        first: usize,
        /// The same triangle again, from 1.
        second: usize,
    },
    /// A closed mesh that encloses nothing.
    FlatMesh {
        /// Enclosed volume, in the mesh's own units cubed.
        volume: f64,
    },
    /// A density that is negative inside the body, or not a finite number.
    Density {
        /// Where, m.
        at: [f64; 3],
        /// The density there, kg/m³.
        value: f64,
    },
    /// A cubature that did not reach its tolerance.
    Cubature {
        /// The relative error that was asked for.
        tolerance: f64,
        /// The one that was estimated in the end; infinite if not even a first estimate was within the limit.
        reached: f64,
        /// How many values of the density that took.
        evaluations: u64,
    },
}

impl fmt::Display for BodyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter { what, value, rule } => write!(f, "{what} = {value} must be {rule}"),
            Self::NotSymmetric { element: [i, j], value, mirrored } => {
                write!(f, "the inertia tensor is not symmetric: I{i}{j} = {value}, but I{j}{i} = {mirrored}")
            }
            Self::NegativeMoment { moments: [a, b, c] } => write!(
                f,
                "the inertia tensor is impossible: its principal moments are {a}, {b}, {c} kg·m², and none may be negative"
            ),
            Self::TriangleInequality { moments: [a, b, c] } => write!(
                f,
                "the inertia tensor is impossible: i1 + i2 = {} kg·m² is less than i3 = {c} kg·m² (principal moments {a}, {b}, {c})",
                a + b
            ),
            Self::Empty { what } => write!(f, "there are no {what}"),
            Self::Vertex { triangle, vertex: [x, y, z] } => {
                write!(f, "triangle {triangle} has the vertex ({x}, {y}, {z}), which is not finite")
            }
            Self::VertexIndex { triangle, index, vertices } => {
                write!(f, "triangle {triangle} has vertex {index}, counted from 0, of {vertices}")
            }
            Self::OpenMesh { edges, example: [a, b], triangle } => write!(
                f,
                "the mesh is open, so it has no volume: {edges} edges belong to one triangle only, \
                 the first from {a:?} to {b:?} in triangle {triangle}"
            ),
            Self::InconsistentWinding { edges, example: [a, b], triangle } => write!(
                f,
                "the mesh is not consistently wound: along {edges} edges the triangles do not turn the same way, \
                 the first from {a:?} to {b:?} in triangle {triangle}"
            ),
            Self::DuplicateTriangle { first, second } => {
                write!(f, "triangle {second} is triangle {first} again, so part of the mesh counts double")
            }
            Self::FlatMesh { volume } => write!(f, "the mesh is closed, but encloses no volume ({volume:e})"),
            Self::Density { at: [x, y, z], value } => {
                write!(
                    f,
                    "the density at ({x}, {y}, {z}) is {value} kg/m³, and must be finite and not negative"
                )
            }
            Self::Cubature { tolerance, reached, evaluations } => write!(
                f,
                "the relative error is estimated as {reached:.1e} after {evaluations} values of the density, \
                 more than the tolerance of {tolerance:.1e}"
            ),
        }
    }
}

impl BodyError {
    /// What to try next, where there is something to try.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::NotSymmetric { .. } => {
                Some("give each product of inertia once on either side of the diagonal, with the same sign")
            }
            Self::NegativeMoment { .. } | Self::TriangleInequality { .. } => Some(
                "check the sign convention of the products (here: minus the integral ∫xy dm), the point it is about, \
                 and the units",
            ),
            Self::OpenMesh { .. } => Some(
                "close the mesh in the tool that made it; vertices that only nearly coincide count as different",
            ),
            Self::DuplicateTriangle { .. } => Some("remove duplicate faces in the tool that made the mesh"),
            Self::InconsistentWinding { .. } => {
                Some("make the normals consistent in the tool that made the mesh")
            }
            Self::Density { value, .. } if !value.is_finite() => {
                Some("a mesh needs a finite density in all of its convex hull, a shape only inside")
            }
            Self::Cubature { .. } => Some(
                "allow a larger tolerance or more evaluations; where the density has steps, divide the body along them",
            ),
            _ => None,
        }
    }
}

impl core::error::Error for BodyError {}

/// The value, if it is positive and finite.
pub(crate) fn positive(what: &'static str, value: f64) -> Result<f64, BodyError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(BodyError::Parameter { what, value, rule: "positive and finite" })
    }
}

/// The value, if it is zero or positive, and finite.
pub(crate) fn not_negative(what: &'static str, value: f64) -> Result<f64, BodyError> {
    if value >= 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(BodyError::Parameter { what, value, rule: "zero or positive, and finite" })
    }
}

/// The vector, if all of it is finite.
pub(crate) fn finite(what: &'static str, v: [f64; 3]) -> Result<[f64; 3], BodyError> {
    match v.iter().find(|c| !c.is_finite()) {
        None => Ok(v),
        Some(&value) => Err(BodyError::Parameter { what, value, rule: "finite" }),
    }
}
