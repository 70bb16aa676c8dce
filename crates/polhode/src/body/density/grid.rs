//! Voxel grids: a density on a lattice of equal boxes.

use super::field::FieldError;
use crate::body::error::{BodyError, finite};
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Part;
use crate::math::sum::Sum;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::{Direction, Position};

/// Lattice of equal boxes (or parallelepipeds, if its axes are not orthogonal): the positions of
/// voxels, without their densities.
///
/// Voxel (i, j, k) has its centre at origin + i a + j b + k c with the steps a, b and c, and the
/// number i + n₁ (j + n₂ k). The axes may have any order and either handedness.
///
/// ```
/// use polhode::body::density::VoxelGrid;
/// // Two voxels of 1 m, of 3 and 1 kg/m³, side by side
/// let grid = VoxelGrid::new([0.5, 0.0, 0.0], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [2, 1, 1])?;
/// let body = grid.mass_properties(|voxel| [3.0, 1.0][voxel])?;
/// assert_eq!(body.properties.mass(), 4.0);
/// assert_eq!(body.properties.center_of_mass().x, 0.75);
/// assert_eq!(body.properties.inertia().matrix()[0][0], 4.0 / 6.0); // a box's, M (1² + 1²) / 12
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VoxelGrid {
    origin: [f64; 3],
    steps: [[f64; 3]; 3],
    counts: [usize; 3],
}

/// Mass properties of a voxel grid, for the two usual interpretations of a voxel's value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VoxelMassProperties {
    /// Mass properties if every voxel is a box of uniform density; exact except for rounding.
    pub properties: MassProperties<Part>,
    /// Mass properties if the density is trilinear between voxel centres, and constant across the
    /// outer half of the outermost voxels; exact except for rounding. The mass is the same.
    pub trilinear: MassProperties<Part>,
    /// Difference between the two interpretations, plus rounding.
    ///
    /// This is the uncertainty from the unknown distribution of density within a voxel. It does not
    /// include how well the voxels represent the body, mainly at its surface; only a finer grid can
    /// show that.
    pub error_estimate: FieldError,
    /// Number of voxels whose density is not zero.
    pub filled: usize,
    /// Volume of the voxels whose density is not zero, m³.
    pub volume: f64,
}

impl VoxelGrid {
    /// Returns the lattice with the centre of its first voxel at `origin`, m.
    ///
    /// `steps` are the vectors from a voxel to the next along each axis, m, and `counts` are the
    /// numbers of voxels along each axis.
    ///
    /// # Errors
    /// [`BodyError::Empty`] if a count is zero; [`BodyError::Parameter`] if a number is not finite,
    /// if the steps are coplanar, or if the number of voxels exceeds `usize`.
    pub fn new(origin: [f64; 3], steps: [[f64; 3]; 3], counts: [usize; 3]) -> Result<Self, BodyError> {
        finite("the origin of the voxels", origin)?;
        for step in steps {
            finite("the step between voxels", step)?;
        }
        if counts.contains(&0) {
            return Err(BodyError::Empty { what: "voxels" });
        }
        if counts.iter().try_fold(1_usize, |all, &n| all.checked_mul(n)).is_none() {
            let value = counts.iter().map(|&n| n as f64).product();
            return Err(BodyError::Parameter {
                what: "the number of voxels",
                value,
                rule: "addressable by this machine",
            });
        }
        let grid = Self { origin, steps, counts };
        let lengths: f64 = steps.map(|step| Direction::<Part>::from_array(step).norm()).iter().product();
        let volume = grid.voxel_volume();
        if !(volume > 1e-12 * lengths && volume.is_finite()) {
            let rule = "positive and finite: the steps may not lie in one plane";
            return Err(BodyError::Parameter { what: "the volume of a voxel", value: volume, rule });
        }
        Ok(grid)
    }

    /// Returns the number of voxels along each axis.
    pub const fn counts(&self) -> [usize; 3] {
        self.counts
    }

    /// Returns the volume of a voxel, |a · (b × c)|, m³.
    pub fn voxel_volume(&self) -> f64 {
        let [a, b, c] = self.steps.map(Direction::<Part>::from_array);
        a.dot(b.cross(c)).abs()
    }

    /// Returns the centre of a voxel, m, given its number.
    pub fn center(&self, voxel: usize) -> [f64; 3] {
        let [n1, n2, _] = self.counts;
        self.at([voxel % n1, voxel / n1 % n2, voxel / n1 / n2].map(|i| i as f64))
    }

    fn at(&self, [i, j, k]: [f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.steps;
        core::array::from_fn(|x| self.origin[x] + (i * a[x] + j * b[x] + k * c[x]))
    }

    /// Computes the mass properties of the voxels, each with the density `density(number)`, kg/m³.
    ///
    /// Moments of the voxel indices are summed about the voxel nearest to the centre of mass. If S
    /// is their covariance, that of the body is A S Aᵀ with A = (a b c). `density` is called twice
    /// for each voxel, in ascending order of the numbers; the values are not stored.
    ///
    /// # Errors
    /// [`BodyError::Density`] if a density is negative or not finite; [`BodyError::Parameter`] if
    /// all are zero, or if the result overflows f64.
    pub fn mass_properties(&self, density: impl Fn(usize) -> f64) -> Result<VoxelMassProperties, BodyError> {
        self.try_mass_properties(|voxel| Ok(density(voxel)))
    }

    /// Computes the mass properties like [`VoxelGrid::mass_properties`], with densities whose
    /// evaluation may fail (for example, a file reader).
    ///
    /// # Errors
    /// The first error of `density`, and the errors of [`VoxelGrid::mass_properties`].
    pub fn try_mass_properties<E: From<BodyError>>(
        &self,
        mut density: impl FnMut(usize) -> Result<f64, E>,
    ) -> Result<VoxelMassProperties, E> {
        let middle = self.counts.map(|n| (n / 2) as f64);
        let first = self.sum(&mut density, middle)?;
        // Sums about a point far from the body would cancel.
        let near: [f64; 3] =
            core::array::from_fn(|k| middle[k] + (first.boxes[k + 1] / first.boxes[0]).round());
        let near = if near.iter().all(|i| i.is_finite()) { near } else { middle };
        let sums = self.sum(&mut density, near)?;
        let properties = self.body(&sums.boxes, near)?;
        let trilinear = self.body(&sums.trilinear, near)?;
        let (a, b) = (*properties.inertia().symmetric(), *trilinear.inertia().symmetric());
        let half_trace = 0.5 * (a.xx + a.yy + a.zz);
        let error_estimate = FieldError {
            mass: ROUNDING * properties.mass(),
            center_of_mass: (properties.center_of_mass() - trilinear.center_of_mass()).norm()
                + ROUNDING * (properties.center_of_mass().norm() + properties.gyration_radii()[2]),
            inertia: (a - b).max_abs() / half_trace + ROUNDING,
        };
        let volume = sums.filled as f64 * self.voxel_volume();
        Ok(VoxelMassProperties { properties, trilinear, error_estimate, filled: sums.filled, volume })
    }

    /// Returns the index moments about the index `reference`.
    fn sum<E: From<BodyError>>(
        &self,
        density: &mut impl FnMut(usize) -> Result<f64, E>,
        reference: [f64; 3],
    ) -> Result<IndexSums, E> {
        let [n1, n2, n3] = self.counts;
        let mut boxes = [Sum::default(); 10];
        let mut trilinear = [Sum::default(); 10];
        let (mut voxel, mut filled) = (0, 0);
        for k in 0..n3 {
            for j in 0..n2 {
                let mut row = [Sum::default(); 3];
                let (mut first, mut last) = (0.0, 0.0);
                // Plain sums of a few voxels, which have little rounding, are added to compensated
                // sums.
                let mut few = [0.0; 3];
                for i in 0..n1 {
                    if i % FEW == 0 {
                        row.iter_mut().zip(core::mem::take(&mut few)).for_each(|(sum, term)| sum.add(term));
                    }
                    let rho = density(voxel)?;
                    if !(rho >= 0.0 && rho.is_finite()) {
                        return Err(BodyError::Density { at: self.center(voxel), value: rho }.into());
                    }
                    voxel += 1;
                    if i == 0 {
                        first = rho;
                    }
                    last = rho;
                    filled += usize::from(rho != 0.0);
                    let x = i as f64 - reference[0];
                    few[0] += rho;
                    few[1] += rho * x;
                    few[2] += rho * x * x;
                }
                row.iter_mut().zip(few).for_each(|(sum, term)| sum.add(term));
                let row = row.map(Sum::value);
                let place = [j as f64 - reference[1], k as f64 - reference[2]];
                add_row(&mut boxes, [row[0], row[1], row[2] + row[0] / 12.0], place.map(Spreading::of_box));
                // Moments as if all voxels were inner ones, then the corrections at the two ends.
                let inner = Spreading::of_hat(0.0, 1, 3);
                let mut hats = [row[0], row[1], row[2] + row[0] * inner.second];
                for (i, rho) in [(0, first), (n1 - 1, last)].into_iter().take(n1) {
                    let x = i as f64 - reference[0];
                    let (end, inside) = (Spreading::of_hat(x, i, n1), Spreading::of_hat(x, 1, 3));
                    hats[1] += rho * (end.mean - inside.mean);
                    hats[2] += rho * (end.second - inside.second);
                }
                let across = [Spreading::of_hat(place[0], j, n2), Spreading::of_hat(place[1], k, n3)];
                add_row(&mut trilinear, hats, across);
            }
        }
        Ok(IndexSums { boxes: boxes.map(Sum::value), trilinear: trilinear.map(Sum::value), filled })
    }

    /// Returns the mass properties for the given index moments.
    fn body(&self, moments: &[f64; 10], reference: [f64; 3]) -> Result<MassProperties<Part>, BodyError> {
        let [mass, x, y, z, xx, yy, zz, xy, xz, yz] = *moments;
        crate::body::error::positive("the mass", mass)?;
        let c = [x, y, z].map(|first| first / mass);
        let index = Symmetric3 { xx, yy, zz, xy, xz, yz } * (1.0 / mass) - Symmetric3::outer(c);
        let rows = core::array::from_fn(|x| self.steps.map(|step| step[x]));
        let center = self.at(core::array::from_fn(|k| reference[k] + c[k]));
        let mass = mass * self.voxel_volume();
        MassProperties::from_covariance(mass, Position::from_array(center), &index.rotated(&rows))
    }
}

/// Number of voxels whose densities are added without compensation.
const FEW: usize = 16;

/// Relative rounding bound of the sums: compensated, except for the products and a few plain terms.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Σρ (1, i, j, k, ii, jj, kk, ij, ik, jk)
struct IndexSums {
    boxes: [f64; 10],
    trilinear: [f64; 10],
    filled: usize,
}

/// Distribution of a voxel's value along one axis: mean and mean square of the index, relative to
/// the reference.
#[derive(Clone, Copy)]
struct Spreading {
    mean: f64,
    second: f64,
}

impl Spreading {
    /// Returns the uniform distribution over [x − ½, x + ½].
    fn of_box(x: f64) -> Self {
        Self { mean: x, second: x * x + 1.0 / 12.0 }
    }

    /// Returns a hat function from x − 1 to x + 1 for voxel `i` of `n`; at an end of the row, half
    /// a box and half a hat.
    ///
    /// ∫(1 − |t|) t² dt = 1/6. At the first voxel the mean is −1/8 + 1/6 = 1/24 and the mean square
    /// is 1/24 + 1/12 = 1/8.
    fn of_hat(x: f64, i: usize, n: usize) -> Self {
        let (shift, square) = match i {
            _ if n == 1 => (0.0, 1.0 / 12.0),
            0 => (1.0 / 24.0, 0.125),
            _ if i == n - 1 => (-1.0 / 24.0, 0.125),
            _ => (0.0, 1.0 / 6.0),
        };
        Self { mean: x + shift, second: x * x + 2.0 * x * shift + square }
    }
}

/// Adds a row of voxels with the moments Σρ (1, i, ii), at the given distributions across the row.
fn add_row(sums: &mut [Sum; 10], [mass, x, xx]: [f64; 3], [y, z]: [Spreading; 2]) {
    if mass == 0.0 {
        return;
    }
    let terms = [
        mass,
        x,
        mass * y.mean,
        mass * z.mean,
        xx,
        mass * y.second,
        mass * z.second,
        x * y.mean,
        x * z.mean,
        mass * (y.mean * z.mean),
    ];
    for (sum, term) in sums.iter_mut().zip(terms) {
        sum.add(term);
    }
}
