//! How a solid's mass properties depend on the vertices of its surface.

use super::closed::ClosedMesh;
use crate::body::derivative::{MassPropertiesDerivative, MassPropertiesGradient};
use crate::body::error::BodyError;
use crate::body::mass_properties::MassProperties;
use crate::body::shape::{Shape, Substance};
use crate::math::frame::Part;
use crate::math::lanes::Lanes;
use crate::math::machine::in_widest_vectors;
use crate::math::number::Splat;
use crate::math::symmetric3::{Symmetric3, power_of_two_near};
use crate::math::vector::{Direction, Position};

/// How the mass properties of a solid that triangles bound depend on its vertices and on how heavy it is.
///
/// Where a vertex v of the surface moves by δv, the surface moves by φ δv, φ being 1 there, 0 at the other vertices, and linear between. So an
/// integral over the volume changes by one over the triangles around it,
///
/// δ∫ f dV = δv · Σ n ∫ f φ dA
///
/// here of f = 1, x and x xᵀ from the centre of mass, exact but for rounding: some 1e-15 of the largest term. A solid that is made of a density
/// keeps it, one of a given mass keeps that. The vertices are those of [`ClosedMesh::surface`], each once: corners of equal coordinates move
/// together ([`ClosedMesh::vertex_numbers`] finds them).
///
/// ```
/// use polhode::body::mesh::{ClosedMesh, MeshDerivatives};
/// use polhode::body::shape::Substance;
/// let [o, x, y, z] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
/// let corner = ClosedMesh::from_triangles(vec![[o, y, x], [o, x, z], [o, z, y], [x, y, z]])?;
/// let derivatives = MeshDerivatives::of(&corner, Substance::Density(4.0))?;
/// let top = corner.vertex_numbers(&[z])[0].ok_or("no vertex")?;
/// // The tip higher by 1 m: mass ρ A/3 more, the centre of mass higher by 1/4 m.
/// let [_, _, higher] = derivatives.by_vertices()[top as usize];
/// assert!((higher.mass - 4.0 * 3.0 / 3.0).abs() < 1e-15);
/// assert!((higher.center_of_mass.z - 0.25).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Cost
/// A gradient costs about what the mass integrals alone do, 1.4 times that (`cargo bench -p polhode --bench mesh`), all ten numbers by each vertex some twenty times that.
#[derive(Clone, Copy, Debug)]
pub struct MeshDerivatives<'a> {
    mesh: &'a ClosedMesh,
    properties: MassProperties<Part>,
    keeps_mass: bool,
}

impl<'a> MeshDerivatives<'a> {
    /// Of a solid made of a substance.
    ///
    /// # Errors
    /// As [`Shape::mass_properties`].
    pub fn of(mesh: &'a ClosedMesh, substance: Substance) -> Result<Self, BodyError> {
        let properties = mesh.mass_properties(substance)?;
        Ok(Self { mesh, properties, keeps_mass: matches!(substance, Substance::Mass(_)) })
    }

    /// The mass properties themselves.
    pub const fn properties(&self) -> &MassProperties<Part> {
        &self.properties
    }

    /// By the mass, kg.
    pub fn by_mass(&self) -> MassPropertiesDerivative<Part> {
        MassPropertiesDerivative::by_mass(&self.properties)
    }

    /// By the density, kg/m³.
    pub fn by_density(&self) -> MassPropertiesDerivative<Part> {
        MassPropertiesDerivative::by_density(&self.properties, self.mesh.spread().extent())
    }

    /// By the coordinates of each vertex, m.
    pub fn by_vertices(&self) -> Vec<[MassPropertiesDerivative<Part>; 3]> {
        let by_number = |number: usize| {
            let unit = |k: usize| if k == number { 1.0 } else { 0.0 };
            self.gradient(&MassPropertiesGradient {
                by_mass: unit(0),
                by_center_of_mass: Direction::new(unit(1), unit(2), unit(3)),
                by_inertia: core::array::from_fn(|k| unit(4 + k)),
            })
        };
        let gradients: [_; 10] = core::array::from_fn(by_number);
        let derivative = |vertex: usize, axis: usize| {
            let of = |number: usize| gradients[number][vertex][axis];
            MassPropertiesDerivative {
                mass: of(0),
                center_of_mass: Position::new(of(1), of(2), of(3)),
                inertia: core::array::from_fn(|k| of(4 + k)),
            }
        };
        let vertices = self.mesh.surface().coordinates().len();
        (0..vertices).map(|vertex| [0, 1, 2].map(|axis| derivative(vertex, axis))).collect()
    }

    /// The derivatives by the coordinates of each vertex, per m, of a number that depends on the solid's mass properties.
    pub fn gradient(&self, of_number: &MassPropertiesGradient<Part>) -> Vec<[f64; 3]> {
        let surface = self.mesh.surface();
        let points = surface.coordinates();
        let mut gradient = vec![[0.0; 3]; points.len()];
        let spread = self.mesh.spread();
        // In units of a power of two near the size: exact, and no fourth power leaves the range of f64.
        let unit = power_of_two_near(spread.size_squared().sqrt());
        let weight = self.weight(of_number, unit);
        let (center, rest) = (spread.centroid().to_array(), self.mesh.centroid_rest());
        in_widest_vectors(
            #[inline(always)]
            || {
                let per_unit = Vectors::splat(1.0 / unit);
                let mut origin = [per_unit; 3];
                let mut low = [per_unit; 3];
                for k in 0..3 {
                    (origin[k], low[k]) = (Vectors::splat(center[k]), Vectors::splat(rest[k] / unit));
                }
                for corners in surface.triangles().chunks(WIDTH) {
                    let mut group = [origin; 3];
                    for (lane, triangle) in corners.iter().enumerate() {
                        for (corner, &index) in group.iter_mut().zip(triangle) {
                            let p = &points[index as usize];
                            for k in 0..3 {
                                corner[k].0[lane] = p[k];
                            }
                        }
                    }
                    for corner in &mut group {
                        for k in 0..3 {
                            corner[k] = (corner[k] - origin[k]) * per_unit - low[k];
                        }
                    }
                    let by_corners = weight.by_corners(group);
                    for (lane, triangle) in corners.iter().enumerate() {
                        for (by, &index) in by_corners.iter().zip(triangle) {
                            let sum = &mut gradient[index as usize];
                            for k in 0..3 {
                                sum[k] += by[k].0[lane];
                            }
                        }
                    }
                }
            },
        );
        gradient
    }

    /// What a unit of volume at x adds to the number, x from the centre of mass in units of length; a moved vertex adds volume.
    ///
    /// At constant density ρ (α + β·x + xᵀ Q x) with α = ∂/∂M, β = ∂/∂c /M and Q of ∂/∂I : (x² 1 − x xᵀ); at constant mass all else becomes lighter,
    /// so that α = −(∂/∂I : I)/M.
    fn weight(&self, of_number: &MassPropertiesGradient<Part>, unit: f64) -> Weight {
        let MassPropertiesGradient { by_mass, by_center_of_mass, by_inertia } = of_number;
        let mass = self.properties.mass();
        // The gradient is per m: of unit⁻¹ · unit³, as n is in units, too.
        let density = mass / self.mesh.volume() * unit * unit;
        let constant = if self.keeps_mass {
            let inertia = self.properties.inertia().symmetric().elements();
            -by_inertia.iter().zip(inertia).map(|(by, i)| by * (i / mass)).sum::<f64>()
        } else {
            *by_mass
        };
        // I_xy is one number, and xy twice in xᵀ Q x.
        let [xx, yy, zz, xy, xz, yz] = *by_inertia;
        let by = Symmetric3 { xx, yy, zz, xy: 0.5 * xy, xz: 0.5 * xz, yz: 0.5 * yz };
        let quadratic = by.inertia_of_second_moments() * (density * unit * unit / 60.0);
        let [q0, q1, q2] = quadratic.rows();
        let linear = by_center_of_mass.to_array().map(|by| by / mass * density * unit / 24.0);
        Weight {
            constant: Vectors::splat(constant * density / 6.0),
            linear: linear.map(Vectors::splat),
            quadratic: [q0, q1, q2].map(|row| row.map(Vectors::splat)),
        }
    }
}

/// A polynomial of the second degree, α/6, β/24, Q/60: as its integrals over a triangle have it.
#[derive(Clone, Copy)]
struct Weight {
    constant: Vectors,
    linear: [Vectors; 3],
    quadratic: [[Vectors; 3]; 3],
}

impl Weight {
    /// n ∫ f φ dA of each corner, n the area's vector: with s = a + b + c
    ///
    /// ∫ f φ_a = 2A (α/6 + β·(s + a)/24 + (½ Σ p·Qp + ½ s·Qs + a·Qs + a·Qa)/60),  p = a, b, c
    #[inline(always)]
    fn by_corners(&self, [a, b, c]: [[Vectors; 3]; 3]) -> [[Vectors; 3]; 3] {
        // No `map` and no closures: they are not inlined everywhere, and then are not compiled for wide vectors.
        let (e, f) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
        let n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
        let s = sum(a, b, c);
        let (qa, qb, qc) = (self.image(a), self.image(b), self.image(c));
        let qs = sum(qa, qb, qc);
        let (aa, bb, cc) = (dot(a, qa), dot(b, qb), dot(c, qc));
        let half = Vectors::splat(0.5);
        let common = self.constant + dot(self.linear, s) + half * (aa + bb + cc + dot(s, qs));
        // p·(β/24 + Qs)
        let slope = [self.linear[0] + qs[0], self.linear[1] + qs[1], self.linear[2] + qs[2]];
        let [of_a, of_b, of_c] =
            [common + dot(a, slope) + aa, common + dot(b, slope) + bb, common + dot(c, slope) + cc];
        [times(n, of_a), times(n, of_b), times(n, of_c)]
    }

    /// Q p
    #[inline(always)]
    fn image(&self, p: [Vectors; 3]) -> [Vectors; 3] {
        let [x, y, z] = self.quadratic;
        [dot(x, p), dot(y, p), dot(z, p)]
    }
}

#[inline(always)]
fn dot(p: [Vectors; 3], q: [Vectors; 3]) -> Vectors {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

#[inline(always)]
fn sum(a: [Vectors; 3], b: [Vectors; 3], c: [Vectors; 3]) -> [Vectors; 3] {
    [a[0] + b[0] + c[0], a[1] + b[1] + c[1], a[2] + b[2] + c[2]]
}

#[inline(always)]
fn times(p: [Vectors; 3], by: Vectors) -> [Vectors; 3] {
    [p[0] * by, p[1] * by, p[2] * by]
}

/// Triangles in a vector.
const WIDTH: usize = 8;

type Vectors = Lanes<WIDTH>;
