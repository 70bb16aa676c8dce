//! Derivatives of a solid's mass properties with respect to the vertices of its surface.

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

/// Derivatives of the mass properties of a solid bounded by triangles, with respect to its
/// vertices, mass and density.
///
/// If a vertex v moves by δv, the surface moves by φ δv. Here φ = 1 at v, 0 at the other vertices,
/// and is linear in between. The derivative of a volume integral is therefore an integral over the
/// adjacent triangles,
///
/// δ∫ f dV = δv · Σ n ∫ f φ dA
///
/// with f = 1, x and x xᵀ, x from the centre of mass. The result is exact except for rounding,
/// about 1e-15 of the largest term. A solid defined by a density keeps its density; a solid of
/// given mass keeps its mass. The vertices are those of [`ClosedMesh::surface`], each once. Corners
/// with equal coordinates move together ([`ClosedMesh::vertex_numbers`] finds them).
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
/// A gradient costs about 1.4 times as much as the mass integrals (`cargo bench -p polhode --bench
/// mesh`). All ten numbers for each vertex cost about twenty times as much.
#[derive(Clone, Copy, Debug)]
pub struct MeshDerivatives<'a> {
    mesh: &'a ClosedMesh,
    properties: MassProperties<Part>,
    keeps_mass: bool,
}

impl<'a> MeshDerivatives<'a> {
    /// Returns the derivatives for a solid made of a substance.
    ///
    /// # Errors
    /// The errors of [`Shape::mass_properties`].
    pub fn of(mesh: &'a ClosedMesh, substance: Substance) -> Result<Self, BodyError> {
        let properties = mesh.mass_properties(substance)?;
        Ok(Self { mesh, properties, keeps_mass: matches!(substance, Substance::Mass(_)) })
    }

    /// Returns the mass properties.
    pub const fn properties(&self) -> &MassProperties<Part> {
        &self.properties
    }

    /// Returns the derivative with respect to the mass, per kg.
    pub fn by_mass(&self) -> MassPropertiesDerivative<Part> {
        MassPropertiesDerivative::by_mass(&self.properties)
    }

    /// Returns the derivative with respect to the density, per kg/m³.
    pub fn by_density(&self) -> MassPropertiesDerivative<Part> {
        MassPropertiesDerivative::by_density(&self.properties, self.mesh.spread().extent())
    }

    /// Returns the derivatives with respect to the coordinates of each vertex, per m.
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

    /// Returns the derivatives of a scalar with respect to the coordinates of each vertex, per m,
    /// from its gradient with respect to the mass properties.
    pub fn gradient(&self, of_number: &MassPropertiesGradient<Part>) -> Vec<[f64; 3]> {
        let surface = self.mesh.surface();
        let points = surface.coordinates();
        let mut gradient = vec![[0.0; 3]; points.len()];
        let spread = self.mesh.spread();
        // Lengths are scaled by a power of two near the size: this is exact, and no fourth power
        // overflows.
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

    /// Returns the contribution per unit volume at x to the scalar, with x from the centre of mass
    /// in scaled units; a moved vertex adds volume.
    ///
    /// The value at constant density is ρ (α + β·x + xᵀ Q x) with α = ∂/∂M, β = ∂/∂c / M, and Q
    /// from ∂/∂I : (x² 1 − x xᵀ). At constant mass the density decreases elsewhere, so that
    /// α = −(∂/∂I : I)/M.
    fn weight(&self, of_number: &MassPropertiesGradient<Part>, unit: f64) -> Weight {
        let MassPropertiesGradient { by_mass, by_center_of_mass, by_inertia } = of_number;
        let mass = self.properties.mass();
        // The gradient is per m, a factor of unit⁻¹ · unit³, because n is in scaled units too.
        let density = mass / self.mesh.volume() * unit * unit;
        let constant = if self.keeps_mass {
            let inertia = self.properties.inertia().symmetric().elements();
            -by_inertia.iter().zip(inertia).map(|(by, i)| by * (i / mass)).sum::<f64>()
        } else {
            *by_mass
        };
        // I_xy is one variable, but xy occurs twice in xᵀ Q x.
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

/// Quadratic polynomial with the factors of its triangle integrals: α/6, β/24, Q/60.
#[derive(Clone, Copy)]
struct Weight {
    constant: Vectors,
    linear: [Vectors; 3],
    quadratic: [[Vectors; 3]; 3],
}

impl Weight {
    /// Returns n ∫ f φ dA for each corner, with the area vector n and s = a + b + c:
    ///
    /// ∫ f φ_a = 2A (α/6 + β·(s + a)/24 + (½ Σ p·Qp + ½ s·Qs + a·Qs + a·Qa)/60),  p = a, b, c
    #[inline(always)]
    fn by_corners(&self, [a, b, c]: [[Vectors; 3]; 3]) -> [[Vectors; 3]; 3] {
        // `map` and closures are not inlined on every target, and would then not be compiled for
        // wide vectors.
        let (e, f) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
        let n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
        let s = sum(a, b, c);
        let (qa, qb, qc) = (self.image(a), self.image(b), self.image(c));
        let qs = sum(qa, qb, qc);
        let (aa, bb, cc) = (dot(a, qa), dot(b, qb), dot(c, qc));
        let half = Vectors::splat(0.5);
        let common = self.constant + dot(self.linear, s) + half * (aa + bb + cc + dot(s, qs));
        // Factor of p: β/24 + Qs.
        let slope = [self.linear[0] + qs[0], self.linear[1] + qs[1], self.linear[2] + qs[2]];
        let [of_a, of_b, of_c] =
            [common + dot(a, slope) + aa, common + dot(b, slope) + bb, common + dot(c, slope) + cc];
        [times(n, of_a), times(n, of_b), times(n, of_c)]
    }

    /// Returns Q p.
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

/// Number of triangles per vector.
const WIDTH: usize = 8;

type Vectors = Lanes<WIDTH>;
