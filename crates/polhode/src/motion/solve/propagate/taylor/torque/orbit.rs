//! Series of an orbit in rotating body axes.
//!
//! Let ρ = r/r₀ and ν = ṙ/r₀, where r₀ is the distance at the start of the step. Each step starts
//! from the closed form of the orbit, and
//!
//! ρ̇ = ν + ρ × Ω,  ν̇ = −(µ/r₀³) ρ/|ρ|³ + ν × Ω
//!
//! If the orbit is a circle, |ρ| is 1, and these equations are linear.

use super::super::body_resolved::BodyResolved;
use super::super::row::{Row, Series};
use super::super::scalar::{Scalars, power};
use super::super::sums::SeriesSums;
use super::{Known, StepStart, row};
use crate::math::number::Number;
use crate::motion::model::orbit::Orbit;

/// Series of an orbit over one step.
#[derive(Clone, Debug)]
pub(super) struct OrbitSeries<N> {
    /// Orbit of each lane.
    orbits: Vec<Orbit>,
    /// True for circular orbits; the same for all lanes.
    is_circular: bool,
    /// µ, m³/s².
    mu: N,
    /// r₀, m.
    pub(super) distance: N,
    /// µ/r₀³, 1/s².
    pub(super) strength: N,
    pub(super) rho: Series<N>,
    nu: BodyResolved<N>,
    /// |ρ|².
    pub(super) square: Scalars<N>,
    /// |ρ|⁻³.
    pub(super) cube: Scalars<N>,
    /// |ρ|⁻³ in every element of a row.
    cube_rows: Series<N>,
}

impl<N: Number> OrbitSeries<N> {
    pub(super) fn of(zero: N, orbit: &Orbit) -> Self {
        let one = Scalars::constant(zero.like(1.0));
        Self {
            orbits: vec![orbit.clone(); N::LANES],
            is_circular: orbit.is_circular(),
            mu: zero,
            distance: zero,
            strength: zero,
            rho: Series::all(zero),
            nu: BodyResolved::all(zero),
            square: one,
            cube: one,
            cube_rows: Series::constant(Row::splat(one[0])),
        }
    }

    pub(super) fn set(&mut self, lane: usize, orbit: &Orbit) {
        self.orbits[lane] = orbit.clone();
        self.mu.put(lane, orbit.mu());
        if orbit.is_circular() {
            self.distance.put(lane, orbit.periapsis());
            self.strength.put(lane, orbit.strength(orbit.periapsis()));
        }
    }

    #[inline(always)]
    pub(super) fn start(&mut self, at: &StepStart<N>) {
        let (mut position, mut velocity) = (at.omega, at.omega);
        if self.is_circular {
            for (lane, orbit) in self.orbits.iter().enumerate() {
                let [toward, rate] = orbit.around(at.time.lane(lane));
                position.put(lane, row(toward));
                velocity.put(lane, row(rate));
            }
            self.rho.set(0, at.resolved(position).vector());
            self.nu.start(at.resolved(velocity));
            return;
        }
        for (lane, orbit) in self.orbits.iter().enumerate() {
            let (r, v) = orbit.position_and_velocity(at.time.lane(lane));
            position.put(lane, row(r));
            velocity.put(lane, row(v));
        }
        let r = position.norm();
        self.strength = self.mu / r / r / r;
        self.distance = r;
        self.rho.set(0, at.resolved(position.divided(r)).vector());
        self.nu.start(at.resolved(velocity.divided(r)));
    }

    /// Computes coefficient n of |ρ|² and |ρ|⁻³.
    #[inline(always)]
    pub(super) fn measure<M: SeriesSums<N = N>>(&mut self, s: M, n: usize) {
        // Coefficient 0 is 1 by the choice of r₀, and on a circle all others are zero.
        if n == 0 || self.is_circular {
            return;
        }
        let rho = &self.rho;
        let [x, y, z, _] = s.product(rho, rho, n).0;
        self.square[n] = x + y + z;
        self.cube[n] = power(&self.square, -1.5, &self.cube, n);
        self.cube_rows.set(n, Row::splat(self.cube[n]));
    }

    /// Computes coefficient n + 1 of ρ and ν.
    #[inline(always)]
    pub(super) fn extend<M: SeriesSums<N = N>>(&mut self, n: usize, known: &Known<'_, M>) {
        let turning = &known.turning.rows;
        let over_cube =
            if self.is_circular { self.rho[n] } else { known.s.product(&self.cube_rows, &self.rho, n) };
        let pull = over_cube * Row::splat(-self.strength);
        let next = (known.s.cross(&self.rho, turning, n) + self.nu.coefficient(n)).over(n + 1);
        self.rho.set(n + 1, next.vector());
        self.nu.extend(known.s, n, turning, pull);
    }
}
