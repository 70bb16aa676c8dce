//! Why something is not a body.

use core::fmt;

/// Pairs of triangles that overlap or touch are counted up to here: one more stands for any larger number.
pub(crate) const COUNTED: usize = 10_000;

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
    /// A tensor about another point that leaves an impossible one about the centre of mass: I = J − M (d² 1 − d dᵀ).
    ImpossibleAtCenter {
        /// M, kg.
        mass: f64,
        /// d, from the point to the centre of mass, m.
        lever: [f64; 3],
        /// Principal moments of J, ascending, kg·m².
        about: [f64; 3],
        /// Principal moments of I, ascending, kg·m².
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
        /// Loops that they make.
        loops: usize,
        /// The ends of one of them, in the mesh's own units.
        example: [[f64; 3]; 2],
        /// The triangle, from 1, that the example belongs to.
        triangle: usize,
    },
    /// Vertices that a weld would join although they are farther apart than its tolerance: others between them are nearer.
    WeldTooWide {
        /// The tolerance, in the mesh's own units.
        tolerance: f64,
        /// How many vertices hang together.
        vertices: usize,
        /// How far apart they are, in the mesh's own units.
        distance: f64,
        /// Two of them that are so far apart.
        example: [[f64; 3]; 2],
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
    /// A closed mesh with one side only, as Klein's bottle: it has no inside.
    Unorientable {
        /// Edges whose triangles run along them in the same direction.
        edges: usize,
        /// The ends of one of them, in the mesh's own units.
        example: [[f64; 3]; 2],
        /// The triangle, from 1, that the example belongs to.
        triangle: usize,
    },
    /// A mesh that contains a triangle twice, the same way round: a part of it would count double.
    DuplicateTriangle {
        /// How many triangles are there again.
        count: usize,
        /// The first of them, from 1.
        first: usize,
        /// The same triangle again, from 1.
        second: usize,
    },
    /// A mesh of parts that go through each other: what they have in common would count twice.
    OverlappingMesh {
        /// Pairs of triangles that cross, or show that parts overlap at an edge; 10,001 for any number above 10,000.
        pairs: usize,
        /// The first of these, from 1.
        triangles: [usize; 2],
        /// Where they cross, in the mesh's own units.
        point: [f64; 3],
    },
    /// A mesh of so many triangles so near each other that it cannot be found out whether parts of it overlap.
    OverlapsUndecided {
        /// How many triangles it has.
        triangles: usize,
        /// Steps that were not enough.
        steps: u64,
    },
    /// A mesh with a part that is wound outward within another: as a solid it would count twice, as a cavity it is wound wrong.
    NestedSolid {
        /// How many there are.
        parts: usize,
        /// A triangle of the first of them, from 1.
        triangle: usize,
        /// What it encloses, in the mesh's own units cubed.
        volume: f64,
    },
    /// A mesh with a part that is wound inward beside others that are not: it would count negative.
    InvertedPart {
        /// How many there are.
        parts: usize,
        /// A triangle of the first of them, from 1.
        triangle: usize,
        /// What it encloses, negative, in the mesh's own units cubed.
        volume: f64,
    },
    /// A mesh that winds negatively about places: their union with the others would leave out what may be solid.
    NegativeUnion {
        /// How much that is, in the mesh's own units cubed.
        volume: f64,
        /// What it winds about once or more often.
        whole: f64,
    },
    /// A mesh whose union takes too long to find.
    UnionUndecided {
        /// Its triangles.
        triangles: usize,
        /// Steps that were not enough.
        steps: u64,
    },
    /// A mesh whose union cannot be computed well enough.
    UnionUnclear {
        /// What it would enclose, in the mesh's own units cubed.
        volume: f64,
        /// What that may be off.
        error: f64,
    },
    /// A closed mesh that encloses nothing.
    FlatMesh {
        /// Enclosed volume, in the mesh's own units cubed.
        volume: f64,
    },
    /// Points whose convex hull encloses nothing.
    FlatPoints {
        /// The number of points.
        count: usize,
        /// `"in one plane"`, `"on one line"` or `"at one place"`.
        place: &'static str,
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
                "the inertia tensor is impossible: its principal moments are {}, {}, {} kg·m², and none may be negative",
                six(*a),
                six(*b),
                six(*c)
            ),
            Self::TriangleInequality { moments: [a, b, c] } => {
                // All digits where six do not show it.
                let shown = |x: f64| if six(a + b) == six(*c) { x.to_string() } else { six(x) };
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
                "the mesh has one side only, so it has no inside: however it is wound, triangles disagree along an edge \
                 ({edges} of them as it is, the first from {a:?} to {b:?} in triangle {triangle})"
            ),
            Self::DuplicateTriangle { count, first, second } => write!(
                f,
                "triangle {second} is triangle {first} again, so part of the mesh counts double ({})",
                plural(*count, "such pair")
            ),
            Self::OverlappingMesh { pairs, triangles: [t, u], point } => write!(
                f,
                "parts of the mesh overlap, so what they share counts twice: {} of triangles, \
                 the first triangles {t} and {u} near {point:?}",
                counted(*pairs)
            ),
            Self::OverlapsUndecided { triangles, steps } => write!(
                f,
                "so many of the mesh's {triangles} triangles are so near each other that it was not found out whether parts of it \
                 overlap: that would take more than {steps} steps"
            ),
            Self::NestedSolid { parts, triangle, volume } => write!(
                f,
                "a part of the mesh lies in another and is wound outward as that one is, so its volume ({volume:e}) counts twice: \
                 the part of triangle {triangle}, the first of {parts}"
            ),
            Self::InvertedPart { parts, triangle, volume } => write!(
                f,
                "a part of the mesh is wound inward and in no solid, so its volume counts negative ({volume:e}): \
                 the part of triangle {triangle}, the first of {parts}"
            ),
            Self::NegativeUnion { volume, whole } => write!(
                f,
                "the mesh winds about {volume:e} the wrong way round (about {whole:e} the right way), so its parts are no solids that could \
                 be united"
            ),
            Self::UnionUndecided { triangles, steps } => write!(
                f,
                "what the parts of the mesh enclose together was not found: its {triangles} triangles meet so often that it takes more than \
                 {steps} steps"
            ),
            Self::UnionUnclear { volume, error } => write!(
                f,
                "what the parts of the mesh enclose together is not known well enough: {volume:e}, but for {error:.1e}"
            ),
            Self::FlatMesh { volume: 0.0 } => f.write_str("the mesh is closed, but encloses no volume"),
            Self::FlatMesh { volume } => {
                write!(f, "the mesh is closed, but encloses no volume that rounding leaves ({volume:.5e})")
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
                "the relative error is estimated as {reached:.1e} after {evaluations} values of the density, \
                 more than the tolerance of {tolerance:.1e}"
            ),
        }
    }
}

/// `1 edge`, `2 edges`
fn plural(count: usize, noun: &str) -> String {
    if count == 1 { format!("1 {noun}") } else { format!("{count} {noun}s") }
}

/// How many pairs there are, as far as they are counted.
pub(crate) fn counted(pairs: usize) -> String {
    match pairs {
        1 => "1 pair".to_owned(),
        ..=COUNTED => format!("{pairs} pairs"),
        _ => format!("more than {COUNTED} pairs"),
    }
}

/// A number with six significant digits.
fn six(x: f64) -> String {
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    if x == 0.0 || (1e-4..1e7).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
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
            Self::ImpossibleAtCenter { .. } => Some(
                "check the centre of mass and the point that the tensor is about (perhaps it is about the centre of mass already), the sign \
                 convention of the products, and the units",
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
                Some("cut it open and close it as the surface of a solid, or take it as a thin sheet")
            }
            Self::OverlappingMesh { .. } => {
                Some("unite the solids in the tool that made the mesh (boolean union)")
            }
            Self::OverlapsUndecided { .. } => Some(
                "divide long thin triangles, and corners or edges of very many triangles, in the tool that made the mesh",
            ),
            Self::NestedSolid { .. } => Some(
                "a cavity is wound inward: turn its normals; a solid within a solid is to be united with it",
            ),
            Self::NegativeUnion { .. } => Some(
                "turn the normals of parts that are wound inward outward; where a part goes through itself, its inside turns out: mend it in \
                 the tool that made the mesh",
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
