//! Mass integrals of a polyhedron.

use core::ops::{Add, Mul, Range, Sub};

use super::component::FLAT;
use super::threads::Threads;
use crate::body::error::BodyError;
use crate::body::shape::{Extent, Spread};
use crate::math::double::Double;
use crate::math::lanes::Lanes;
use crate::math::machine::in_widest_vectors;
use crate::math::number::{Number, Splat};
use crate::math::sum::{quick_two_sum, two_sum};
use crate::math::symmetric3::{Symmetric3, power_of_two_near};
use crate::math::vector::Position;

/// Closed, consistently oriented surface to integrate over.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polyhedron<'a> {
    pub(crate) points: &'a [[f64; 3]],
    pub(crate) corners: &'a [[u32; 3]],
    pub(crate) threads: Threads,
}

/// Results of the integrals.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Integrals {
    /// Volume, centroid and covariance; the volume is negative if the surface is oriented inward.
    pub(crate) spread: Spread,
    pub(crate) area: f64,
    /// Low word of the centroid (double-double), m; it matters for a small body far from the
    /// origin.
    pub(crate) centroid_rest: [f64; 3],
}

impl Polyhedron<'_> {
    /// Computes volume, centroid and covariance of the polyhedron, and its area.
    ///
    /// The integrals are sums over the signed tetrahedra from a local reference point to each
    /// triangle (a, b, c), with d = a · ((b − a) × (c − a)) = a · (b × c):
    ///
    /// 6 V = Σ d,  24 V c = Σ d s,  120 V ⟨x xᵀ⟩ = Σ d (a aᵀ + b bᵀ + c cᵀ + s sᵀ),  s = a + b + c
    ///
    /// They are exact for the polyhedron except for rounding, about 4e-16 of half the tensor's
    /// trace. The reference is first the centre of the bounding box, then the centroid, so that a
    /// body far from the origin, or far from the centre of its box, loses no digits. For
    /// thin-walled bodies, needles, and small triangles far from the reference, large terms cancel.
    /// If the terms are more than [`CANCELLED`] times their sum, or the products in them more than
    /// [`ROUNDED`] times, the sums are repeated in double-double arithmetic.
    ///
    /// The result is bit-identical for any number of threads and any vector width.
    ///
    /// Source: Tonon, J. Math. Stat. 1 (2005) 8, summed over the boundary.
    pub(crate) fn integrate(&self) -> Result<Integrals, BodyError> {
        let (low, high) = self.bounds();
        let middle: [f64; 3] = core::array::from_fn(|k| 0.5 * low[k] + 0.5 * high[k]);
        let size = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
        // Lengths are scaled by a power of two near the size: this is exact, and no fifth power
        // overflows.
        let unit = power_of_two_near(size);
        let (cubed, per_unit) = (unit * unit * unit, 1.0 / unit);
        let first: MomentSums = self.sum(|piece| self.piece::<4>(piece, middle, per_unit));
        // The bound exceeds the rounding noise of flat triangles: area times distance times ε.
        let six_volume = first.terms[0].value();
        if six_volume.abs() <= FLAT * first.area.value() {
            return Err(BodyError::FlatMesh { volume: six_volume / 6.0 * cubed });
        }
        let centroid = first.centroid();
        // The reference has few digits. Differences from it are exact for coordinates with few
        // digits, and have random rounding otherwise. The last digits of a full-precision reference
        // would round all differences the same way.
        let grid = unit * GRID;
        let reference: [f64; 3] =
            core::array::from_fn(|k| ((middle[k] + centroid[k] * unit) / grid).round_ties_even() * grid);
        let mut sums = self.sum(|piece| self.piece::<10>(piece, reference, per_unit));
        let trace: f64 = sums.terms[4..7].iter().map(|sum| sum.value()).sum();
        // `!(… <= …)` instead of `>`, so that NaN is also computed again.
        let [terms, products] = [sums.magnitude, sums.products].map(Double::value);
        if !(terms <= CANCELLED * trace.abs() && products <= ROUNDED * trace.abs()) {
            sums = self.sum(|piece| self.piece_in_two_words(piece, reference, per_unit));
        }
        let rest = sums.centroid();
        let [six_volume, _, _, _, second @ ..] = sums.terms;
        // In double-double arithmetic, so that only the last digit is rounded.
        let twenty = six_volume * Double::from(20.0);
        let [xx, yy, zz, xy, xz, yz] = second.map(|element| (element / twenty).value());
        let covariance = Symmetric3 { xx, yy, zz, xy, xz, yz } - Symmetric3::outer(rest);
        let six_volume = six_volume.value();
        let centroid: [(f64, f64); 3] = core::array::from_fn(|k| two_sum(reference[k], rest[k] * unit));
        let spread = Spread {
            extent: Extent::Volume(six_volume / 6.0 * cubed),
            centroid: Position::from_array(centroid.map(|(rounded, _)| rounded)),
            covariance: covariance * unit * unit,
        };
        let centroid_rest = centroid.map(|(_, rest)| rest);
        Ok(Integrals { spread, area: sums.area.value() * unit * unit, centroid_rest })
    }

    fn bounds(&self) -> ([f64; 3], [f64; 3]) {
        let mut bounds = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for p in self.points {
            bounds.0 = core::array::from_fn(|k| bounds.0[k].min(p[k]));
            bounds.1 = core::array::from_fn(|k| bounds.1[k].max(p[k]));
        }
        bounds
    }

    /// Returns the sums of all pieces, added in their order.
    fn sum(&self, piece: impl Fn(Range<usize>) -> MomentSums + Sync) -> MomentSums {
        let pieces = self.threads.map_pieces(self.corners.len(), PIECE, piece);
        pieces.iter().fold(MomentSums::default(), |all, piece| all.with(piece))
    }

    /// Returns the first `TERMS` sums over some triangles, eight triangles at a time.
    fn piece<const TERMS: usize>(
        &self,
        triangles: Range<usize>,
        reference: [f64; 3],
        per_unit: f64,
    ) -> MomentSums {
        let mut sums = LaneSums::<TERMS>::new();
        in_widest_vectors(
            #[inline(always)]
            || {
                let [x, y, z] = reference;
                let origin = [Vectors::splat(x), Vectors::splat(y), Vectors::splat(z)];
                let per_unit = Vectors::splat(per_unit);
                for corners in self.corners[triangles].chunks(WIDTH) {
                    // Unused lanes are at the reference point and add nothing.
                    let mut group = [origin; 3];
                    for (lane, triangle) in corners.iter().enumerate() {
                        for (corner, &index) in group.iter_mut().zip(triangle) {
                            let p = &self.points[index as usize];
                            for k in 0..3 {
                                corner[k].0[lane] = p[k];
                            }
                        }
                    }
                    for corner in &mut group {
                        for k in 0..3 {
                            corner[k] = (corner[k] - origin[k]) * per_unit;
                        }
                    }
                    sums.add(group);
                }
            },
        );
        sums.total()
    }

    fn piece_in_two_words(&self, triangles: Range<usize>, reference: [f64; 3], per_unit: f64) -> MomentSums {
        let mut sums = MomentSums::default();
        for corners in &self.corners[triangles] {
            let triangle = corners.map(|v| {
                let p = self.points[v as usize];
                core::array::from_fn(|k| Double::sum(p[k], -reference[k]).scaled(per_unit))
            });
            let terms = terms(triangle);
            for (sum, term) in sums.terms.iter_mut().zip(terms) {
                *sum = *sum + term;
            }
            let area = area(triangle.map(|p| p.map(Double::value)));
            sums.area = sums.area + Double::from(area);
        }
        sums
    }
}

/// Ratio of terms to their sum above which too few digits remain.
const CANCELLED: f64 = 4.0;

/// Ratio of the products of which the terms consist (all taken as positive) to their sum above
/// which the terms have too few digits.
const ROUNDED: f64 = 64.0;

/// Grid of the reference point, in scaled units: so close to the centroid that no digits are lost.
const GRID: f64 = 1.0 / 1_048_576.0;

/// Number of triangles in a piece of work.
const PIECE: usize = 1 << 12;

/// Number of triangles per vector.
const WIDTH: usize = 8;

type Vectors = Lanes<WIDTH>;

/// Returns d, d s, and d (a aᵀ + b bᵀ + c cᵀ + s sᵀ) with its elements xx, yy, zz, xy, xz, yz.
#[inline(always)]
fn terms<T>([a, b, c]: [[T; 3]; 3]) -> [T; 10]
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    // `map` and larger closures are not inlined on every target, and would then not be compiled for
    // wide vectors.
    let (e, f) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
    let n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
    let d = a[0] * n[0] + a[1] * n[1] + a[2] * n[2];
    let s = [a[0] + b[0] + c[0], a[1] + b[1] + c[1], a[2] + b[2] + c[2]];
    let p = [a, b, c, s];
    [
        d,
        d * s[0],
        d * s[1],
        d * s[2],
        d * second(&p, 0, 0),
        d * second(&p, 1, 1),
        d * second(&p, 2, 2),
        d * second(&p, 0, 1),
        d * second(&p, 0, 2),
        d * second(&p, 1, 2),
    ]
}

/// Returns Σ pᵢ pⱼ.
#[inline(always)]
fn second<T: Copy + Add<Output = T> + Mul<Output = T>>([a, b, c, s]: &[[T; 3]; 4], i: usize, j: usize) -> T {
    a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]
}

/// Returns the magnitude of the products in the terms of the trace: d (a² + b² + c² + s²) with
/// every product in d positive.
#[inline(always)]
fn products([a, b, c]: [[Vectors; 3]; 3]) -> Vectors {
    let e = positive([b[0] - a[0], b[1] - a[1], b[2] - a[2]]);
    let f = positive([c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
    let m = [e[1] * f[2] + e[2] * f[1], e[2] * f[0] + e[0] * f[2], e[0] * f[1] + e[1] * f[0]];
    let s = [a[0] + b[0] + c[0], a[1] + b[1] + c[1], a[2] + b[2] + c[2]];
    dot(positive(a), m) * (dot(a, a) + dot(b, b) + dot(c, c) + dot(s, s))
}

#[inline(always)]
fn positive([x, y, z]: [Vectors; 3]) -> [Vectors; 3] {
    [x.map(f64::abs), y.map(f64::abs), z.map(f64::abs)]
}

#[inline(always)]
fn dot(p: [Vectors; 3], q: [Vectors; 3]) -> Vectors {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

/// Returns ½ |(b − a) × (c − a)|.
#[inline(always)]
fn area<T: Splat>([a, b, c]: [[T; 3]; 3]) -> T {
    let (u, v) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    T::splat(0.5) * (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).map(f64::sqrt)
}

/// Sums of the integrals, in powers of the scaled unit of length.
#[derive(Clone, Copy, Debug, Default)]
struct MomentSums {
    /// Sums of [`terms`].
    terms: [Double; 10],
    area: Double,
    /// Sum of the absolute terms of the trace.
    magnitude: Double,
    /// Sum of [`products`].
    products: Double,
}

impl MomentSums {
    fn with(&self, other: &Self) -> Self {
        Self {
            terms: core::array::from_fn(|k| self.terms[k] + other.terms[k]),
            area: self.area + other.area,
            magnitude: self.magnitude + other.magnitude,
            products: self.products + other.products,
        }
    }

    /// Returns the centroid relative to the reference point: Σ d s / 4 Σ d.
    fn centroid(&self) -> [f64; 3] {
        let [d, x, y, z, ..] = self.terms;
        [x, y, z].map(|first| (first / d).value() * 0.25)
    }
}

/// Sums in many lanes with their rounding errors (`Sum2` of Ogita, Rump & Oishi in each lane).
struct LaneSums<const TERMS: usize> {
    high: [Vectors; TERMS],
    low: [Vectors; TERMS],
    area: Vectors,
    magnitude: Vectors,
    products: Vectors,
}

impl<const TERMS: usize> LaneSums<TERMS> {
    #[inline(always)]
    fn new() -> Self {
        let zero = Vectors::splat(0.0);
        Self { high: [zero; TERMS], low: [zero; TERMS], area: zero, magnitude: zero, products: zero }
    }

    #[inline(always)]
    fn add(&mut self, triangles: [[Vectors; 3]; 3]) {
        let terms = terms(triangles);
        for (k, (high, low)) in self.high.iter_mut().zip(&mut self.low).enumerate() {
            let (sum, error) = two_sum(*high, terms[k]);
            *high = sum;
            *low = *low + error;
        }
        self.area = self.area + area(triangles);
        if TERMS > 4 {
            self.magnitude = self.magnitude + (terms[4] + terms[5] + terms[6]).map(f64::abs);
            self.products = self.products + products(triangles);
        }
    }

    fn total(&self) -> MomentSums {
        let total = |lanes: Vectors| lanes.0.iter().fold(Double::default(), |sum, &x| sum + Double::from(x));
        let [area, magnitude, products] = [self.area, self.magnitude, self.products].map(total);
        let mut sums = MomentSums { area, magnitude, products, ..MomentSums::default() };
        for (sum, (high, low)) in sums.terms.iter_mut().zip(self.high.iter().zip(&self.low)) {
            let lanes = high.0.iter().zip(low.0).map(|(&high, low)| {
                let (high, low) = quick_two_sum(high, low);
                Double::new(high, low)
            });
            *sum = lanes.fold(Double::default(), |sum, lane| sum + lane);
        }
        sums
    }
}
