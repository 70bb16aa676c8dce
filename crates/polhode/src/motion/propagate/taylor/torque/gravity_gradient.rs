//! The series of the gravity gradient.
//!
//! With ρ = r/r₀ from the orbit's series, the tensor has N = 3 (µ/r₀³) |ρ|⁻⁵ ρ × I ρ.
//!
//! Mass points at r₀ ξ have N = (µ/r₀³) r₀² Σ m f ξ × ρ, f = |ρ|⁻³ − |ρ + ξ|⁻³. With A = |ρ|², δ = 2 ρ·ξ + ξ² and a = A^(−3/2),
//! the rate of (A + δ)^(−3/2) = a − f gives, once what would cancel is taken out,
//!
//! (A + δ) ḟ = δ ȧ + (3/2)(δ̇ a − (Ȧ + δ̇) f)

use super::super::recurrence::Terms;
use super::super::row::{Row, Series, TERMS, Vectors};
use super::super::scalar::{Scalars, power};
use super::super::sums::Sums;
use super::linear::times;
use super::orbit::OrbitSeries;
use super::{Known, StepStart};
use crate::math::number::Number;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::{Direction, quantity::Number as Pure};
use crate::motion::propagate::chart::{ROUNDING, THIN};
use crate::motion::rotor::Rotor;
use crate::motion::torque::gravity_gradient::whole;
use crate::motion::torque::{Attracted, GravityGradient};

/// The series of the gravity gradient.
#[derive(Clone, Debug)]
pub(in super::super) struct GravityGradientSeries<N> {
    orbit: OrbitSeries<N>,
    attracted: AttractedSeries<N>,
}

/// What gravity acts on.
#[derive(Clone, Debug)]
enum AttractedSeries<N> {
    Tensor(Box<TensorSeries<N>>),
    Points(Box<PointsSeries<N>>),
}

impl<N: Number> GravityGradientSeries<N> {
    pub(super) fn of(zero: N, model: &GravityGradient, rotor: &Rotor) -> Self {
        let attracted = match &model.attracted {
            Attracted::Tensor => AttractedSeries::Tensor(Box::new(TensorSeries::of(zero, rotor))),
            Attracted::Points(points) => {
                AttractedSeries::Points(Box::new(PointsSeries::of(zero, points.len())))
            }
        };
        Self { orbit: OrbitSeries::of(zero, &model.orbit), attracted }
    }

    pub(super) fn set(&mut self, lane: usize, model: &GravityGradient, rotor: &Rotor) {
        self.orbit.set(lane, &model.orbit);
        match &mut self.attracted {
            AttractedSeries::Tensor(tensor) => tensor.set(lane, rotor),
            AttractedSeries::Points(points) => points.set(lane, model, rotor),
        }
    }

    #[inline(always)]
    pub(super) fn start(&mut self, at: &StepStart<N>) {
        self.orbit.start(at);
        if let AttractedSeries::Points(points) = &mut self.attracted {
            points.start(self.orbit.distance);
        }
    }

    #[inline(always)]
    pub(super) fn coefficient<M: Sums<N = N>>(&mut self, n: usize, known: &Known<'_, M>) -> Row<N> {
        let Self { orbit, attracted } = self;
        orbit.measure(known.s, n);
        match attracted {
            AttractedSeries::Tensor(tensor) => tensor.coefficient(known.s, n, orbit),
            AttractedSeries::Points(points) => known.apart(
                #[inline(always)]
                |known| points.coefficient(known.s, n, orbit),
            ),
        }
    }

    #[inline(always)]
    pub(super) fn extend<M: Sums<N = N>>(
        &mut self,
        n: usize,
        known: &Known<'_, M>,
        turned: Option<Row<N>>,
    ) -> Row<N> {
        self.orbit.extend(n, known, turned)
    }

    /// ρ and ν at the start of a step.
    #[inline(always)]
    pub(super) fn carried(&self) -> [Row<N>; 2] {
        [self.orbit.rho.rows.at(0), self.orbit.nu.coefficient(0)]
    }

    /// True if all is linear or square: on a circle, of a tensor that has the principal axes.
    pub(super) fn is_simple(&self) -> bool {
        let is_plain = matches!(&self.attracted, AttractedSeries::Tensor(tensor) if tensor.wheels.is_none());
        is_plain && self.orbit.is_circular()
    }

    /// µ/r³, and 3 µ/r³ (i3 − i2)/i1 and so on.
    pub(super) fn give(&self, terms: &mut Terms<N>, lane: usize, inverses: Row) {
        if let AttractedSeries::Tensor(tensor) = &self.attracted {
            let strength = self.orbit.strength.lane(lane);
            terms.pull.put(lane, strength);
            terms.bending.put(lane, tensor.differences.lane(lane) * Row::splat(3.0 * strength) * inverses);
        }
    }

    /// Coefficient n of ρ, found elsewhere.
    pub(super) fn know(&mut self, n: usize, rho: Row<N>) {
        self.orbit.rho.set(n, rho);
    }
}

/// ρ × I ρ.
#[derive(Clone, Debug)]
struct TensorSeries<N> {
    /// (i3 − i2, i1 − i3, i2 − i1): ρ × I ρ is that times (ρ2 ρ3, ρ3 ρ1, ρ1 ρ2).
    differences: Row<N>,
    /// Columns of what wheels add to the tensor, which has other principal axes, and its product with ρ.
    wheels: Option<([Row<N>; 3], Vectors<N>)>,
    /// |ρ|⁻⁵
    fifth: Scalars<N>,
    fifth_rows: Series<N>,
    /// ρ × I ρ
    bending: Series<N>,
}

/// True if gravity acts on wheels beside the carrier.
pub(in super::super) fn has_wheels(rotor: &Rotor) -> bool {
    beside_carrier(rotor).max_abs() != 0.0
}

fn beside_carrier(rotor: &Rotor) -> Symmetric3 {
    whole(rotor) - *rotor.inertia().symmetric()
}

impl<N: Number> TensorSeries<N> {
    fn of(zero: N, rotor: &Rotor) -> Self {
        let mut one = [zero; TERMS];
        one[0] = zero.like(1.0);
        Self {
            differences: Row::splat(zero),
            wheels: has_wheels(rotor).then(|| ([Row::splat(zero); 3], Vectors::all(zero))),
            fifth: one,
            fifth_rows: Series::constant(Row::splat(one[0])),
            bending: Series::all(zero),
        }
    }

    fn set(&mut self, lane: usize, rotor: &Rotor) {
        let [i1, i2, i3] = rotor.principal().moments();
        self.differences.put(lane, Row([i3 - i2, i1 - i3, i2 - i1, 0.0]));
        if let Some((columns, _)) = &mut self.wheels {
            let to_principal = rotor.principal().rotation().inverse().matrix();
            let wheels = beside_carrier(rotor).rotated(&to_principal).rows();
            for (column, [x, y, z]) in columns.iter_mut().zip(wheels) {
                column.put(lane, Row([x, y, z, 0.0]));
            }
        }
    }

    #[inline(always)]
    fn coefficient<M: Sums<N = N>>(&mut self, s: M, n: usize, orbit: &OrbitSeries<N>) -> Row<N> {
        let rho = &orbit.rho;
        let mut bending = self.differences * s.others(rho, n);
        if let Some((columns, momentum)) = &mut self.wheels {
            momentum.set(n, times(columns, rho.rows.at(n)));
            bending = bending + s.cross(&rho.rows, momentum, n);
        }
        let strength = Row::splat(orbit.strength.like(3.0) * orbit.strength);
        if orbit.is_circular() {
            return bending * strength;
        }
        self.bending.set(n, bending.vector());
        if n > 0 {
            self.fifth[n] = power(&orbit.square, -2.5, &self.fifth, n);
            self.fifth_rows.set(n, Row::splat(self.fifth[n]));
        }
        s.product(&self.fifth_rows, &self.bending, n) * strength
    }
}

/// Σ m f ξ × ρ.
#[derive(Clone, Debug)]
struct PointsSeries<N> {
    points: Vec<PointSeries<N>>,
    /// Σ m f ξ
    sum: Series<N>,
}

#[derive(Clone, Debug)]
struct PointSeries<N> {
    mass: N,
    /// From the point that the body turns about, principal axes, m.
    x: Row<N>,
    /// x/r₀
    xi: Row<N>,
    delta: Scalars<N>,
    /// A + δ
    square: Scalars<N>,
    f: Scalars<N>,
}

impl<N: Number> PointsSeries<N> {
    fn of(zero: N, points: usize) -> Self {
        let (none, series) = (Row::splat(zero), [zero; TERMS]);
        let point = PointSeries { mass: zero, x: none, xi: none, delta: series, square: series, f: series };
        Self { points: vec![point; points], sum: Series::all(zero) }
    }

    fn set(&mut self, lane: usize, model: &GravityGradient, rotor: &Rotor) {
        let Attracted::Points(particles) = &model.attracted else { return };
        let to_principal = rotor.principal().rotation().inverse();
        let [i1, _, i3] = rotor.principal().moments();
        for (point, particle) in self.points.iter_mut().zip(particles) {
            let x: Direction<_> = (particle.position() - rotor.point()).as_quantity::<Pure>();
            let [x, y, z] = (to_principal * x).to_array();
            // Of a needle, what is only rounding across it: see `cleaned` in linear.rs.
            let clean = |v: f64| if i1 < THIN * i3 && v.abs() < ROUNDING * x.abs() { 0.0 } else { v };
            point.mass.put(lane, particle.mass());
            point.x.put(lane, Row([x, clean(y), clean(z), 0.0]));
        }
    }

    #[inline(always)]
    fn start(&mut self, distance: N) {
        for point in &mut self.points {
            point.xi = point.x * Row::splat(distance.like(1.0) / distance);
        }
    }

    #[inline(always)]
    fn coefficient<M: Sums<N = N>>(&mut self, s: M, n: usize, orbit: &OrbitSeries<N>) -> Row<N> {
        let rho = &orbit.rho;
        let mut sum = Row::splat(orbit.strength.like(0.0));
        for point in &mut self.points {
            point.extend(n, orbit);
            sum = sum + point.xi * Row::splat(point.mass * point.f[n]);
        }
        self.sum.set(n, sum);
        s.cross(&self.sum, rho, n) * Row::splat(orbit.strength * orbit.distance * orbit.distance)
    }
}

impl<N: Number> PointSeries<N> {
    /// Coefficient n of δ, A + δ and f.
    #[inline(always)]
    fn extend(&mut self, n: usize, orbit: &OrbitSeries<N>) {
        let number = |x: f64| self.mass.like(x);
        let (one, count) = (number(1.0), number(n as f64));
        let dot = |a: Row<N>, b: Row<N>| {
            let [x, y, z, _] = (a * b).0;
            x + y + z
        };
        self.delta[n] = number(2.0) * dot(orbit.rho.rows.at(n), self.xi);
        if n == 0 {
            self.delta[0] = self.delta[0] + dot(self.xi, self.xi);
            // f = (w − 1)(1 + w + w²)/w³, w² = 1 + δ
            let w = (one + self.delta[0]).map(f64::sqrt);
            self.square[0] = one + self.delta[0];
            self.f[0] = self.delta[0] / (one + w) * (one + w + w * w) / (w * w * w);
            return;
        }
        self.square[n] = orbit.square[n] + self.delta[n];
        // n (A + δ)₀ fₙ = Σ (k + (3/2)(n − k)) (δₙ₋ₖ aₖ − (A + δ)ₙ₋ₖ fₖ), k = n for δ only
        let weight = |k: usize| number(k as f64 + 1.5 * (n - k) as f64);
        let known = orbit.cube[..n].iter().zip(&self.f[..n]).enumerate();
        let back = self.delta[1..=n].iter().zip(&self.square[1..=n]).rev();
        let sum = known
            .zip(back)
            .fold(count * self.delta[0] * orbit.cube[n], |sum, ((k, (&a, &f)), (&delta, &square))| {
                sum + weight(k) * (delta * a - square * f)
            });
        self.f[n] = sum / (count * self.square[0]);
    }
}
