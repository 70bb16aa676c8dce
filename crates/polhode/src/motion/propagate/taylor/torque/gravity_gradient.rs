//! The series of the gravity gradient.
//!
//! With ρ = r/r₀ from the orbit's series, the tensor has N = 3 (µ/r₀³) |ρ|⁻⁵ ρ × I ρ.
//!
//! Mass points at r₀ ξ have N = (µ/r₀³) r₀² Σ m f ξ × ρ, f = |ρ|⁻³ − |ρ + ξ|⁻³. With A = |ρ|², δ = 2 ρ·ξ + ξ² and a = A^(−3/2),
//! the rate of (A + δ)^(−3/2) = a − f gives, once what would cancel is taken out,
//!
//! (A + δ) ḟ = δ ȧ + (3/2)(δ̇ a − (Ȧ + δ̇) f)

use super::super::row::{Row, Series, TERMS, Vectors, cross, others, product};
use super::super::scalar::{Scalars, power};
use super::orbit::OrbitSeries;
use super::{Known, StepStart};
use crate::math::lanes::{Fours, Plain};
use crate::math::vector::{Direction, quantity::Number};
use crate::motion::propagate::chart::{ROUNDING, THIN};
use crate::motion::rotor::Rotor;
use crate::motion::torque::gravity_gradient::whole;
use crate::motion::torque::{Attracted, GravityGradient};

/// The series of the gravity gradient.
#[derive(Clone, Debug)]
pub(in super::super) struct GravityGradientSeries {
    orbit: OrbitSeries,
    attracted: AttractedSeries,
}

/// What gravity acts on.
#[derive(Clone, Debug)]
enum AttractedSeries {
    Tensor(Box<TensorSeries>),
    Points(Box<PointsSeries>),
}

impl GravityGradientSeries {
    pub(super) fn of(model: &GravityGradient, rotor: &Rotor) -> Self {
        let attracted = match &model.attracted {
            Attracted::Tensor => AttractedSeries::Tensor(Box::new(TensorSeries::of(rotor))),
            Attracted::Points(_) => AttractedSeries::Points(Box::new(PointsSeries::of(model, rotor))),
        };
        Self { orbit: OrbitSeries::of(&model.orbit), attracted }
    }

    pub(super) fn start(&mut self, at: &StepStart) {
        self.orbit.start(at);
        if let AttractedSeries::Points(points) = &mut self.attracted {
            points.start(&self.orbit);
        }
    }

    #[inline(always)]
    pub(super) fn coefficient<S: Fours>(&mut self, n: usize, known: &Known<'_, S>) -> Row {
        self.orbit.measure(known.s, n);
        match &mut self.attracted {
            AttractedSeries::Tensor(tensor) => tensor.coefficient(known.s, n, &self.orbit),
            AttractedSeries::Points(points) => points.coefficient(Plain, n, &self.orbit),
        }
    }

    #[inline(always)]
    pub(super) fn extend<S: Fours>(&mut self, n: usize, known: &Known<'_, S>) {
        self.orbit.extend(n, known);
    }
}

/// ρ × I ρ.
#[derive(Clone, Debug)]
struct TensorSeries {
    /// (i3 − i2, i1 − i3, i2 − i1): ρ × I ρ is that times (ρ2 ρ3, ρ3 ρ1, ρ1 ρ2).
    differences: Row,
    /// Columns of what wheels add to the tensor, which has other principal axes, and its product with ρ.
    wheels: Option<([Row; 3], Vectors)>,
    /// |ρ|⁻⁵
    fifth: Scalars,
    fifth_rows: Series,
    /// ρ × I ρ
    bending: Series,
}

impl TensorSeries {
    fn of(rotor: &Rotor) -> Self {
        let [i1, i2, i3] = rotor.principal().moments();
        let wheels = whole(rotor) - *rotor.inertia().symmetric();
        let to_principal = rotor.principal().rotation().inverse().matrix();
        let columns = wheels.rotated(&to_principal).rows().map(|[x, y, z]| Row([x, y, z, 0.0]));
        let mut one = [0.0; TERMS];
        one[0] = 1.0;
        Self {
            differences: Row([i3 - i2, i1 - i3, i2 - i1, 0.0]),
            wheels: (wheels.max_abs() != 0.0).then_some((columns, Vectors::ZERO)),
            fifth: one,
            fifth_rows: Series::constant(Row::splat(1.0)),
            bending: Series::ZERO,
        }
    }

    #[inline(always)]
    fn coefficient<S: Fours>(&mut self, s: S, n: usize, orbit: &OrbitSeries) -> Row {
        let rho = &orbit.rho;
        let mut bending = self.differences * others(s, rho, n);
        if let Some(([a, b, c], momentum)) = &mut self.wheels {
            let [x, y, z, _] = rho.rows.at(n).0;
            momentum.set(n, *a * Row::splat(x) + (*b * Row::splat(y) + *c * Row::splat(z)));
            bending = bending + cross(s, &rho.rows, momentum, n);
        }
        let strength = Row::splat(3.0 * orbit.strength);
        if orbit.is_circular() {
            return bending * strength;
        }
        self.bending.set(n, bending);
        if n > 0 {
            self.fifth[n] = power(&orbit.square, -2.5, &self.fifth, n);
            self.fifth_rows.set(n, Row::splat(self.fifth[n]));
        }
        product(s, &self.fifth_rows, &self.bending, n) * strength
    }
}

/// Σ m f ξ × ρ.
#[derive(Clone, Debug)]
struct PointsSeries {
    points: Vec<PointSeries>,
    /// Σ m f ξ
    sum: Series,
}

#[derive(Clone, Debug)]
struct PointSeries {
    mass: f64,
    /// From the point that the body turns about, principal axes, m.
    x: Row,
    /// x/r₀
    xi: Row,
    delta: Scalars,
    /// A + δ
    square: Scalars,
    f: Scalars,
}

impl PointsSeries {
    fn of(model: &GravityGradient, rotor: &Rotor) -> Self {
        let Attracted::Points(particles) = &model.attracted else {
            return Self { points: Vec::new(), sum: Series::ZERO };
        };
        let to_principal = rotor.principal().rotation().inverse();
        let [i1, _, i3] = rotor.principal().moments();
        let points = particles.iter().map(|particle| {
            let x: Direction<_> = (particle.position() - rotor.point()).as_quantity::<Number>();
            let [x, y, z] = (to_principal * x).to_array();
            // Of a needle, what is only rounding across it: see `cleaned` in linear.rs.
            let clean = |v: f64| if i1 < THIN * i3 && v.abs() < ROUNDING * x.abs() { 0.0 } else { v };
            PointSeries {
                mass: particle.mass(),
                x: Row([x, clean(y), clean(z), 0.0]),
                xi: Row::ZERO,
                delta: [0.0; TERMS],
                square: [0.0; TERMS],
                f: [0.0; TERMS],
            }
        });
        Self { points: points.collect(), sum: Series::ZERO }
    }

    fn start(&mut self, orbit: &OrbitSeries) {
        for point in &mut self.points {
            point.xi = point.x * Row::splat(1.0 / orbit.distance);
        }
    }

    #[inline(never)]
    fn coefficient<S: Fours>(&mut self, s: S, n: usize, orbit: &OrbitSeries) -> Row {
        let rho = &orbit.rho;
        let mut sum = Row::ZERO;
        for point in &mut self.points {
            point.extend(n, orbit);
            sum = sum + point.xi * Row::splat(point.mass * point.f[n]);
        }
        self.sum.set(n, sum);
        cross(s, &self.sum, rho, n) * Row::splat(orbit.strength * orbit.distance * orbit.distance)
    }
}

impl PointSeries {
    /// Coefficient n of δ, A + δ and f.
    #[inline(always)]
    fn extend(&mut self, n: usize, orbit: &OrbitSeries) {
        let dot = |a: Row, b: Row| {
            let [x, y, z, _] = (a * b).0;
            x + y + z
        };
        self.delta[n] = 2.0 * dot(orbit.rho.rows.at(n), self.xi);
        if n == 0 {
            self.delta[0] += dot(self.xi, self.xi);
            // f = (w − 1)(1 + w + w²)/w³, w² = 1 + δ
            let w = (1.0 + self.delta[0]).sqrt();
            self.square[0] = 1.0 + self.delta[0];
            self.f[0] = self.delta[0] / (1.0 + w) * (1.0 + w + w * w) / (w * w * w);
            return;
        }
        self.square[n] = orbit.square[n] + self.delta[n];
        // n (A + δ)₀ fₙ = Σ (k + (3/2)(n − k)) (δₙ₋ₖ aₖ − (A + δ)ₙ₋ₖ fₖ), k = n for δ only
        let weight = |k: usize| k as f64 + 1.5 * (n - k) as f64;
        let known = orbit.cube[..n].iter().zip(&self.f[..n]).enumerate();
        let back = self.delta[1..=n].iter().zip(&self.square[1..=n]).rev();
        let sum = known
            .zip(back)
            .fold(n as f64 * self.delta[0] * orbit.cube[n], |sum, ((k, (a, f)), (delta, square))| {
                sum + weight(k) * (delta * a - square * f)
            });
        self.f[n] = sum / (n as f64 * self.square[0]);
    }
}
