//! Errors of body construction.

use core::fmt;

/// Maximum number of overlapping or touching triangle pairs that is counted; `COUNTED` + 1 stands
/// for any larger number.
pub(crate) const COUNTED: usize = 10_000;

/// Error of a body: each variant carries the value and the rule that it violates.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum BodyError {
    /// A number is outside its range, for example a mass that is not positive, or a radius that is
    /// not finite.
    Parameter {
        /// Name of the number.
        what: &'static str,
        /// Value of the number.
        value: f64,
        /// Rule that the number must obey.
        rule: &'static str,
    },
    /// A matrix is not symmetric and therefore not an inertia tensor.
    NotSymmetric {
        /// Row and column, 1 to 3, of the first element that differs from its mirror image.
        element: [usize; 2],
        /// Value of the element, kg·m².
        value: f64,
        /// Value of its mirror image, kg·m².
        mirrored: f64,
    },
    /// A tensor has a negative principal moment.
    NegativeMoment {
        /// Principal moments, ascending, kg·m².
        moments: [f64; 3],
    },
    /// A tensor violates the triangle inequality i1 + i2 ≥ i3, which holds for every distribution
    /// of mass.
    TriangleInequality {
        /// Principal moments, ascending, kg·m².
        moments: [f64; 3],
    },
    /// A tensor J about another point gives an impossible tensor about the centre of mass:
    /// I = J − M (d² 1 − d dᵀ).
    ImpossibleAtCenter {
        /// Mass M, kg.
        mass: f64,
        /// Vector d from the point to the centre of mass, m.
        lever: [f64; 3],
        /// Principal moments of J, ascending, kg·m².
        about: [f64; 3],
        /// Principal moments of I, ascending, kg·m².
        moments: [f64; 3],
    },
    /// A required list is empty: particles, parts, points, triangles or voxels.
    Empty {
        /// Name of the missing items.
        what: &'static str,
    },
    /// A vertex is not finite.
    Vertex {
        /// Index of the triangle, from 1.
        triangle: usize,
        /// Coordinates of the vertex, m.
        vertex: [f64; 3],
    },
    /// A triangle refers to a vertex that the mesh does not have.
    VertexIndex {
        /// Index of the triangle, from 1.
        triangle: usize,
        /// Index of the vertex, from 0.
        index: usize,
        /// Number of vertices in the mesh.
        vertices: usize,
    },
    /// A mesh has a boundary and therefore encloses no volume.
    OpenMesh {
        /// Number of edges that belong to one triangle only.
        edges: usize,
        /// Number of loops that these edges form.
        loops: usize,
        /// End points of one of these edges, in the mesh's own units.
        example: [[f64; 3]; 2],
        /// Triangle of the example edge, from 1.
        triangle: usize,
    },
    /// Welding would join vertices that are farther apart than its tolerance, through other
    /// vertices between them.
    WeldTooWide {
        /// Weld tolerance, in the mesh's own units.
        tolerance: f64,
        /// Number of vertices in the cluster.
        vertices: usize,
        /// Largest distance between vertices of the cluster, in the mesh's own units.
        distance: f64,
        /// Two vertices of the cluster at that distance.
        example: [[f64; 3]; 2],
    },
    /// The triangles of a mesh are not consistently oriented: inside and outside are not defined.
    InconsistentWinding {
        /// Number of edges whose triangles traverse them in the same direction.
        edges: usize,
        /// End points of one of these edges, in the mesh's own units.
        example: [[f64; 3]; 2],
        /// Triangle of the example edge, from 1.
        triangle: usize,
    },
    /// A closed mesh is not orientable, like a Klein bottle: it has no inside.
    Unorientable {
        /// Number of edges whose triangles traverse them in the same direction.
        edges: usize,
        /// End points of one of these edges, in the mesh's own units.
        example: [[f64; 3]; 2],
        /// Triangle of the example edge, from 1.
        triangle: usize,
    },
    /// A mesh contains a triangle twice with the same orientation: part of the mesh would count
    /// twice.
    DuplicateTriangle {
        /// Number of duplicate triangles.
        count: usize,
        /// First triangle of one duplicate pair, from 1.
        first: usize,
        /// Second triangle of that pair, from 1.
        second: usize,
    },
    /// Parts of a mesh intersect: their common volume would count twice.
    OverlappingMesh {
        /// Number of triangle pairs that intersect, or that show overlapping parts at an edge;
        /// 10,001 stands for any number above 10,000.
        pairs: usize,
        /// First of these pairs, triangles from 1.
        triangles: [usize; 2],
        /// Point of intersection of that pair, in the mesh's own units.
        point: [f64; 3],
    },
    /// Too many triangles of a mesh are close together to decide within the step limit whether its
    /// parts overlap.
    OverlapsUndecided {
        /// Number of triangles in the mesh.
        triangles: usize,
        /// Number of steps after which the search stopped.
        steps: u64,
    },
    /// A part inside another part is oriented outward: as a solid it would count twice; as a cavity
    /// its orientation is wrong.
    NestedSolid {
        /// Number of such parts.
        parts: usize,
        /// Triangle of the first such part, from 1.
        triangle: usize,
        /// Volume that this part encloses, in the mesh's own units cubed.
        volume: f64,
    },
    /// A part is oriented inward although it is not inside another part: its volume would count
    /// negative.
    InvertedPart {
        /// Number of such parts.
        parts: usize,
        /// Triangle of the first such part, from 1.
        triangle: usize,
        /// Volume that this part encloses, negative, in the mesh's own units cubed.
        volume: f64,
    },
    /// Some regions have a negative winding number: the union would omit volume that may be solid.
    NegativeUnion {
        /// Volume of these regions, in the mesh's own units cubed.
        volume: f64,
        /// Volume of the regions with winding number 1 or more, in the mesh's own units cubed.
        whole: f64,
    },
    /// Computing the union of a mesh takes more steps than the limit.
    UnionUndecided {
        /// Number of triangles in the mesh.
        triangles: usize,
        /// Number of steps after which the computation stopped.
        steps: u64,
    },
    /// The union of a mesh cannot be computed accurately enough.
    UnionUnclear {
        /// Computed volume of the union, in the mesh's own units cubed.
        volume: f64,
        /// Estimated error of that volume, in the same units.
        error: f64,
    },
    /// A closed mesh encloses no volume.
    FlatMesh {
        /// Enclosed volume, in the mesh's own units cubed.
        volume: f64,
    },
    /// The convex hull of the points encloses no volume.
    FlatPoints {
        /// Number of points.
        count: usize,
        /// Degeneracy of the points: `"in one plane"`, `"on one line"` or `"at one place"`.
        place: &'static str,
    },
    /// A density is negative inside the body, or not finite.
    Density {
        /// Position of the evaluation, m.
        at: [f64; 3],
        /// Density at that position, kg/m³.
        value: f64,
    },
    /// A cubature did not reach its tolerance.
    Cubature {
        /// Requested relative error.
        tolerance: f64,
        /// Estimated relative error at the end; infinite if the evaluation limit did not allow a
        /// first estimate.
        reached: f64,
        /// Number of density evaluations.
        evaluations: u64,
    },
}

impl fmt::Display for BodyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter { what, value, rule } => write!(f, "{what} = {} must be {rule}", plain(*value)),
            Self::NotSymmetric { element: [i, j], value, mirrored } => {
                write!(f, "the inertia tensor is not symmetric: I{i}{j} = {value}, but I{j}{i} = {mirrored}")
            }
            Self::NegativeMoment { moments: [a, b, c] } => write!(
                f,
                "the inertia tensor is impossible: its principal moments are {}, {}, {} kg·m², and none may be negative",
                six(*a),
                six(*b),
                six(*c)
            ),
            Self::TriangleInequality { moments: [a, b, c] } => {
                // Prints all digits if six significant digits would hide the violation.
                let shown = |x: f64| if six(a + b) == six(*c) { plain(x) } else { six(x) };
                let [sum, a, b, c] = [a + b, *a, *b, *c].map(shown);
                write!(
                    f,
                    "the inertia tensor is impossible: i1 + i2 = {sum} kg·m² is less than i3 = {c} kg·m² (principal moments {a}, {b}, {c})"
                )
            }
            Self::ImpossibleAtCenter { mass, lever: [x, y, z], about: [j1, j2, j3], moments: [a, b, c] } => {
                write!(
                    f,
                    "the inertia tensor is impossible about the centre of mass: I = J - M (d² 1 - d dᵀ), with M = {mass} kg and d = ({x}, {y}, {z}) m \
                 from the point of J, takes its principal moments {j1}, {j2}, {j3} to {a}, {b}, {c} kg·m², {}",
                    if *a < 0.0 {
                        "and none may be negative"
                    } else {
                        "and none may be greater than the sum of the others"
                    }
                )
            }
            Self::Empty { what } => write!(f, "there are no {what}"),
            Self::Vertex { triangle, vertex: [x, y, z] } => {
                write!(f, "triangle {triangle} has the vertex ({x}, {y}, {z}), which is not finite")
            }
            Self::VertexIndex { triangle, index, vertices } => {
                write!(f, "triangle {triangle} has vertex {index}, counted from 0, of {vertices}")
            }
            Self::OpenMesh { edges, loops, example: [a, b], triangle } => write!(
                f,
                "the mesh is open, so it has no volume: {} in {} {} to one triangle only, \
                 the first from {a:?} to {b:?} in triangle {triangle}",
                plural(*edges, "edge"),
                plural(*loops, "loop"),
                if *edges == 1 { "belongs" } else { "belong" }
            ),
            Self::WeldTooWide { tolerance, vertices, distance, example: [a, b] } => write!(
                f,
                "welding what is at most {tolerance:e} apart would join {vertices} vertices that are {distance:e} apart, \
                 such as {a:?} and {b:?}: what is smaller than that would be lost"
            ),
            Self::InconsistentWinding { edges, example: [a, b], triangle } => write!(
                f,
                "the mesh is not consistently wound: along {} the triangles do not turn the same way, \
                 the first from {a:?} to {b:?} in triangle {triangle}",
                plural(*edges, "edge")
            ),
            Self::Unorientable { edges, example: [a, b], triangle } => write!(
                f,
                "the mesh has only one side (it is not orientable), so it has no inside: for every winding, triangles disagree along an edge \
                 ({edges} of them as it is, the first from {a:?} to {b:?} in triangle {triangle})"
            ),
            Self::DuplicateTriangle { count, first, second } => write!(
                f,
                "triangle {second} is triangle {first} again, so part of the mesh counts double ({})",
                plural(*count, "such pair")
            ),
            Self::OverlappingMesh { pairs, triangles: [t, u], point } => write!(
                f,
                "parts of the mesh overlap, so the shared volume counts twice: {} of triangles, \
                 the first triangles {t} and {u} near {point:?}",
                counted(*pairs)
            ),
            Self::OverlapsUndecided { triangles, steps } => write!(
                f,
                "too many of the mesh's {triangles} triangles are close together to decide whether parts of it overlap: that would take more than {steps} steps"
            ),
            Self::NestedSolid { parts, triangle, volume } => write!(
                f,
                "a part of the mesh lies in another part and both are wound outward, so its volume ({volume:e}) counts twice: \
                 the part of triangle {triangle}, the first of {parts}"
            ),
            Self::InvertedPart { parts, triangle, volume } => write!(
                f,
                "a part of the mesh is wound inward and lies in no solid, so its volume is negative ({volume:e}): \
                 the part of triangle {triangle}, the first of {parts}"
            ),
            Self::NegativeUnion { volume, whole } => write!(
                f,
                "the mesh is wound inward around a volume of {volume:e} (outward around {whole:e}), so its parts are not solids and cannot be united"
            ),
            Self::UnionUndecided { triangles, steps } => write!(
                f,
                "the union of the parts of the mesh was not computed: its {triangles} triangles intersect so often that it takes more than {steps} steps"
            ),
            Self::UnionUnclear { volume, error } => write!(
                f,
                "the volume of the union of the mesh parts is not accurate enough: {volume:e}, with an error bound of {error:.1e}"
            ),
            Self::FlatMesh { volume: 0.0 } => f.write_str("the mesh is closed, but encloses no volume"),
            Self::FlatMesh { volume } => {
                write!(f, "the mesh is closed, but its volume ({volume:.5e}) is within rounding of zero")
            }
            Self::FlatPoints { count, place } => {
                let lie = if *count == 1 { "point lies" } else { "points lie" };
                write!(f, "{count} {lie} {place}: their convex hull has no volume")
            }
            Self::Density { at: [x, y, z], value } => {
                write!(
                    f,
                    "the density at ({x}, {y}, {z}) is {value} kg/m³, and must be finite and not negative"
                )
            }
            Self::Cubature { tolerance, reached, evaluations } => write!(
                f,
                "the estimated relative error is {reached:.1e} after {evaluations} density evaluations, above the tolerance of {tolerance:.1e}"
            ),
        }
    }
}

/// Returns the count with its noun: `1 edge`, `2 edges`.
fn plural(count: usize, noun: &str) -> String {
    if count == 1 { format!("1 {noun}") } else { format!("{count} {noun}s") }
}

/// Returns the number of pairs as text, or "more than" the counting limit.
pub(crate) fn counted(pairs: usize) -> String {
    match pairs {
        1 => "1 pair".to_owned(),
        ..=COUNTED => format!("{pairs} pairs"),
        _ => format!("more than {COUNTED} pairs"),
    }
}

/// Formats a number with all digits, without exponent if it is of moderate size.
fn plain(x: f64) -> String {
    if x.is_finite() && x != 0.0 && !(1e-9..1e16).contains(&x.abs()) {
        format!("{x:e}")
    } else {
        x.to_string()
    }
}

/// Formats a number with six significant digits.
fn six(x: f64) -> String {
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    if x == 0.0 || (1e-4..1e7).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

impl BodyError {
    /// Returns a suggestion for fixing the error, if there is one.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::NotSymmetric { .. } => Some(
                "give each product of inertia on both sides of the diagonal, with the same value and sign",
            ),
            Self::NegativeMoment { .. } | Self::TriangleInequality { .. } => Some(
                "check the sign convention of the products (here: minus the integral ∫xy dm), the point it is about, \
                 and the units",
            ),
            Self::ImpossibleAtCenter { .. } => Some(
                "check the centre of mass and the reference point of the tensor (perhaps it is already about the centre of mass), the sign convention of the products, and the units",
            ),
            Self::OpenMesh { .. } => Some(
                "close the mesh in the tool that made it; vertices that only nearly coincide count as different",
            ),
            Self::WeldTooWide { .. } => Some(
                "weld with a smaller tolerance: less than the mesh's smallest feature, more than its gaps",
            ),
            Self::DuplicateTriangle { .. } => Some("remove duplicate faces in the tool that made the mesh"),
            Self::InconsistentWinding { .. } => {
                Some("make the normals consistent in the tool that made the mesh")
            }
            Self::Unorientable { .. } => {
                Some("cut it open and close it as the surface of a solid, or use it as a thin sheet")
            }
            Self::OverlappingMesh { .. } => {
                Some("unite the solids in the tool that made the mesh (boolean union)")
            }
            Self::OverlapsUndecided { .. } => Some(
                "remesh long thin triangles, and vertices or edges with very many triangles, in the tool that made the mesh",
            ),
            Self::NestedSolid { .. } => {
                Some("for a cavity, turn the normals inward; unite a solid within a solid with the outer one")
            }
            Self::NegativeUnion { .. } => Some(
                "turn the normals of inward parts outward; a part that intersects itself is inside out in places: fix it in the tool that made the mesh",
            ),
            Self::UnionUndecided { .. } | Self::UnionUnclear { .. } => {
                Some("unite the parts in the tool that made the mesh")
            }
            Self::InvertedPart { .. } => Some("turn the normals of this part outward"),
            _ => None,
        }
    }
}

impl core::error::Error for BodyError {}

/// Returns the value if it is positive and finite.
pub(crate) fn positive(what: &'static str, value: f64) -> Result<f64, BodyError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(BodyError::Parameter { what, value, rule: "positive and finite" })
    }
}

/// Returns the value if it is zero or positive, and finite.
pub(crate) fn not_negative(what: &'static str, value: f64) -> Result<f64, BodyError> {
    if value >= 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(BodyError::Parameter { what, value, rule: "zero or positive, and finite" })
    }
}

/// Returns the vector if all its components are finite.
pub(crate) fn finite(what: &'static str, v: [f64; 3]) -> Result<[f64; 3], BodyError> {
    match v.iter().find(|c| !c.is_finite()) {
        None => Ok(v),
        Some(&value) => Err(BodyError::Parameter { what, value, rule: "finite" }),
    }
}
