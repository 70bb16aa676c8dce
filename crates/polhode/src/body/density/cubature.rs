//! Adaptive cubature of the ten moments of a density.

use core::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

use super::domain::{Brick, Domain, Samples};
use super::rule::CubatureRule;
use crate::math::sum::Sum;
use crate::math::symmetric3::Symmetric3;

/// ∫ρ (1, x, y, z, xx, yy, zz, xy, xz, yz) dV, lengths in the domain's unit.
pub(super) type Moments = [f64; 10];

/// Bricks of a solid, each with its moments and their errors.
///
/// A brick that further division would not improve is added to a sum and not stored. For a mesh
/// with millions of triangles and a density that is nearly polynomial in each of their cones, only
/// the sum is stored.
pub(super) struct Subdivision<'a> {
    domain: &'a Domain<'a>,
    rule: CubatureRule,
    /// Sum over the bricks that are not stored.
    settled: Tally,
    bricks: Vec<Integrated>,
    /// Queue of brick indices: largest error first; the oldest first among equal errors.
    order: BinaryHeap<(Priority, Reverse<usize>)>,
    samples: Samples,
    pub(super) evaluations: u64,
}

#[derive(Clone, Copy)]
struct Integrated {
    brick: Brick,
    moments: Moments,
    errors: Moments,
    /// Direction (0, 1 or 2) of the largest null rule, along which the brick is divided.
    direction: usize,
    /// Rounding error bound of the sum over the samples, for moments of degree 0, 1 and 2.
    rounding: [f64; 3],
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Totals {
    pub(super) moments: Moments,
    pub(super) errors: Moments,
}

/// Relative rounding bound of a sample: density, weight, volume, their product, and the sums.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Degree of each moment.
const DEGREES: [usize; 10] = [0, 1, 1, 1, 2, 2, 2, 2, 2, 2];

impl<'a> Subdivision<'a> {
    pub(super) fn new(domain: &'a Domain<'a>) -> Self {
        Self {
            domain,
            rule: domain.rule(),
            settled: Tally::default(),
            bricks: Vec::new(),
            order: BinaryHeap::new(),
            samples: Samples::default(),
            evaluations: 0,
        }
    }

    /// Returns the number of samples per brick.
    pub(super) fn samples_per_brick(&self) -> u64 {
        self.rule.samples() as u64
    }

    /// Adds a brick. `density` writes ρ at the samples of the brick, or returns an error.
    pub(super) fn add<E>(
        &mut self,
        brick: Brick,
        density: &mut impl FnMut(&Brick, &[[f64; 3]], &mut [f64]) -> Result<(), E>,
    ) -> Result<(), E> {
        let integrated = self.integrate(brick, density)?;
        if integrated.exceeds_rounding() {
            self.order.push((integrated.priority(), Reverse(self.bricks.len())));
            self.bricks.push(integrated);
        } else {
            self.settled.add(&integrated);
        }
        Ok(())
    }

    /// Halves the brick with the largest error. Returns the sums over the brick and over its
    /// halves, or `None` if further division would not help.
    pub(super) fn refine<E>(
        &mut self,
        density: &mut impl FnMut(&Brick, &[[f64; 3]], &mut [f64]) -> Result<(), E>,
    ) -> Result<Option<(Totals, Totals)>, E> {
        while let Some((_, Reverse(index))) = self.order.pop() {
            let parent = self.bricks[index];
            if !parent.exceeds_rounding() {
                return Ok(None);
            }
            // A brick that is too narrow to divide keeps its error.
            let Some([first, second]) = parent.brick.halves(parent.direction) else { continue };
            let first = self.integrate(first, density)?;
            let second = self.integrate(second, density)?;
            self.order.push((first.priority(), Reverse(index)));
            self.order.push((second.priority(), Reverse(self.bricks.len())));
            self.bricks[index] = first;
            self.bricks.push(second);
            return Ok(Some((Tally::of(&[parent]).totals(), Tally::of(&[first, second]).totals())));
        }
        Ok(None)
    }

    pub(super) fn totals(&self) -> Totals {
        let mut tally = self.settled;
        self.bricks.iter().for_each(|brick| tally.add(brick));
        tally.totals()
    }

    /// Returns the number of stored bricks.
    pub(super) fn bricks(&self) -> usize {
        self.bricks.len()
    }

    fn integrate<E>(
        &mut self,
        brick: Brick,
        density: &mut impl FnMut(&Brick, &[[f64; 3]], &mut [f64]) -> Result<(), E>,
    ) -> Result<Integrated, E> {
        let Self { domain, rule, samples, .. } = self;
        domain.sample(&brick, rule, samples);
        density(&brick, &samples.points, &mut samples.densities)?;
        self.evaluations += samples.points.len() as u64;
        let [outer, middle, inner] = &rule.0;
        let mut block = CubatureSums::default();
        let (mut absolute, mut farthest) = (0.0, 0.0_f64);
        // Sums by row, then by plane: a sum of sums of few terms has little rounding.
        let planes = inner.nodes.len() * middle.nodes.len();
        for (u, plane_start) in outer.nodes.iter().zip((0..).step_by(planes)) {
            let mut plane = CubatureSums::default();
            for (v, row_start) in middle.nodes.iter().zip((plane_start..).step_by(inner.nodes.len())) {
                let mut row = CubatureSums::default();
                for (k, w) in (row_start..).zip(&inner.nodes) {
                    let [x, y, z] = samples.local[k];
                    let mass = samples.densities[k] * samples.volumes[k];
                    let monomials = [1.0, x, y, z, x * x, y * y, z * z, x * y, x * z, y * z];
                    add(&mut row.moments, w.weight * mass, &monomials);
                    add(&mut row.nulls[2], w.null * mass, &monomials);
                    absolute += (u.weight * v.weight * w.weight * mass).abs();
                    farthest = farthest.max(x.abs()).max(y.abs()).max(z.abs());
                }
                add(&mut plane.moments, v.weight, &row.moments);
                add(&mut plane.nulls[1], v.null, &row.moments);
                add(&mut plane.nulls[2], v.weight, &row.nulls[2]);
            }
            add(&mut block.moments, u.weight, &plane.moments);
            add(&mut block.nulls[0], u.null, &plane.moments);
            add(&mut block.nulls[1], u.weight, &plane.nulls[1]);
            add(&mut block.nulls[2], u.weight, &plane.nulls[2]);
        }
        let CubatureSums { moments, nulls } = block;
        let errors = core::array::from_fn(|k| nulls.iter().map(|null| null[k].abs()).sum());
        let size = |null: &Moments| null.iter().fold(0.0, |most: f64, m| most.max(m.abs()));
        let direction = (0..3).max_by(|&a, &b| size(&nulls[a]).total_cmp(&size(&nulls[b]))).unwrap_or(0);
        let rounding = [1.0, farthest, farthest * farthest].map(|scale| ROUNDING * absolute * scale);
        Ok(Integrated { brick, moments, errors, direction, rounding })
    }
}

/// Moments by the rule, and by its three null rules.
#[derive(Default)]
struct CubatureSums {
    moments: Moments,
    nulls: [Moments; 3],
}

/// Adds `weight` · `terms` to `sums`.
fn add(sums: &mut Moments, weight: f64, terms: &Moments) {
    for (sum, term) in sums.iter_mut().zip(terms) {
        *sum += weight * term;
    }
}

impl Integrated {
    fn priority(&self) -> Priority {
        Priority(self.errors.into_iter().fold(0.0, f64::max))
    }

    fn error(&self, k: usize) -> f64 {
        self.errors[k] + self.rounding[DEGREES[k]]
    }

    fn exceeds_rounding(&self) -> bool {
        (0..10).any(|k| self.errors[k] > self.rounding[DEGREES[k]])
    }
}

/// Compensated sums over bricks, in the order in which they are added.
#[derive(Clone, Copy, Default)]
struct Tally {
    moments: [Sum; 10],
    errors: Moments,
}

impl Tally {
    fn of(bricks: &[Integrated]) -> Self {
        let mut tally = Self::default();
        bricks.iter().for_each(|brick| tally.add(brick));
        tally
    }

    fn add(&mut self, brick: &Integrated) {
        for k in 0..10 {
            self.moments[k].add(brick.moments[k]);
            self.errors[k] += brick.error(k);
        }
    }

    fn totals(self) -> Totals {
        Totals { moments: self.moments.map(Sum::value), errors: self.errors }
    }
}

impl Totals {
    /// Replaces the contribution of a brick by that of its halves.
    pub(super) fn replace(&mut self, (whole, halves): &(Self, Self)) {
        for k in 0..10 {
            self.moments[k] += halves.moments[k] - whole.moments[k];
            self.errors[k] += halves.errors[k] - whole.errors[k];
        }
    }

    pub(super) fn mass(&self) -> f64 {
        self.moments[0]
    }

    pub(super) fn center(&self) -> [f64; 3] {
        core::array::from_fn(|k| self.moments[k + 1] / self.moments[0])
    }

    /// Returns ∫ρ x xᵀ dV / M − c cᵀ.
    pub(super) fn covariance(&self) -> Symmetric3 {
        let [mass, _, _, _, xx, yy, zz, xy, xz, yz] = self.moments;
        Symmetric3 { xx, yy, zz, xy, xz, yz } * (1.0 / mass) - Symmetric3::outer(self.center())
    }

    /// Returns the propagated errors of the results: of the mass (relative), of the centre of mass
    /// (in units), and of the inertia tensor relative to half its trace.
    ///
    /// |δc| ≤ (|δm₁| + |c| |δM|) / M,  |δS_ij| ≤ |δm_ij| + |c_i δm_j| + |c_j δm_i| + |c_i c_j δM|,
    /// |δI_xx| ≤ |δS_yy| + |δS_zz|, |δI_xy| ≤ |δS_xy|
    pub(super) fn relative_errors(&self) -> [f64; 3] {
        let mass = self.mass();
        let c = self.center().map(f64::abs);
        let e = &self.errors;
        let center = (0..3).map(|k| (e[k + 1] + c[k] * e[0]) / mass).fold(0.0, libm::hypot);
        let second = |element: usize, i: usize, j: usize| {
            e[element] + c[i] * e[j + 1] + c[j] * e[i + 1] + c[i] * c[j] * e[0]
        };
        let [xx, yy, zz] = [second(4, 0, 0), second(5, 1, 1), second(6, 2, 2)];
        let products = [second(7, 0, 1), second(8, 0, 2), second(9, 1, 2)];
        let worst = [yy + zz, xx + zz, xx + yy].into_iter().chain(products).fold(0.0, f64::max);
        let covariance = self.covariance();
        let half_trace = mass * (covariance.xx + covariance.yy + covariance.zz);
        [e[0] / mass, center, worst / half_trace]
    }
}

/// Error estimate as a sort key of bricks.
#[derive(Clone, Copy, PartialEq)]
struct Priority(f64);

impl Eq for Priority {}

impl PartialOrd for Priority {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Priority {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}
