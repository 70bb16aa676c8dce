//! The series of an orbit, as the turning body sees it.
//!
//! ρ = r/r₀ and ν = ṙ/r₀, with r₀ the distance at the start of the step, which the orbit's closed form begins afresh:
//!
//! ρ̇ = ν + ρ × Ω,  ν̇ = −(µ/r₀³) ρ/|ρ|³ + ν × Ω
//!
//! On a circle |ρ| is 1, and all of this is linear.

use super::super::row::{Row, Series, TERMS, Vectors, cross, product};
use super::super::scalar::{Scalars, power};
use super::super::seen::Seen;
use super::{Known, StepStart, row};
use crate::math::lanes::Fours;
use crate::math::vector::{Direction, quantity::Number};
use crate::motion::orbit::Orbit;

/// The series of an orbit over one step.
#[derive(Clone, Debug)]
pub(super) struct OrbitSeries {
    orbit: Orbit,
    /// r₀, m.
    pub(super) distance: f64,
    /// µ/r₀³, 1/s².
    pub(super) strength: f64,
    pub(super) rho: Vectors,
    nu: Seen,
    /// |ρ|²
    pub(super) square: Scalars,
    /// |ρ|⁻³
    pub(super) cube: Scalars,
    /// The same in every place of a row.
    cube_rows: Series,
}

impl OrbitSeries {
    pub(super) fn of(orbit: &Orbit) -> Self {
        let mut one = [0.0; TERMS];
        one[0] = 1.0;
        Self {
            orbit: orbit.clone(),
            distance: 0.0,
            strength: 0.0,
            rho: Vectors::ZERO,
            nu: Seen::ZERO,
            square: one,
            cube: one,
            cube_rows: Series::constant(Row::splat(1.0)),
        }
    }

    pub(super) fn is_circular(&self) -> bool {
        self.orbit.is_circular()
    }

    pub(super) fn start(&mut self, at: &StepStart) {
        let (position, velocity) = self.orbit.position_and_velocity(at.time);
        self.distance = position.norm();
        self.strength = self.orbit.strength(self.distance);
        let to_principal = at.attitude.inverse();
        let rho: Direction<_> = (position / self.distance).as_quantity::<Number>();
        let nu: Direction<_> = (velocity / self.distance).as_quantity::<Number>();
        self.rho.set(0, row(to_principal * rho));
        self.nu.start(row(to_principal * nu));
    }

    /// Finds coefficient n of |ρ|² and |ρ|⁻³.
    #[inline(always)]
    pub(super) fn measure<S: Fours>(&mut self, s: S, n: usize) {
        // The first is 1 because r₀ is chosen so, and a circle has no others.
        if n == 0 || self.is_circular() {
            return;
        }
        let rho = &self.rho.rows;
        let [x, y, z, _] = product(s, rho, rho, n).0;
        self.square[n] = x + y + z;
        self.cube[n] = power(&self.square, -1.5, &self.cube, n);
        self.cube_rows.set(n, Row::splat(self.cube[n]));
    }

    /// Coefficient n of |ρ|⁻³ times a vector.
    #[inline(always)]
    pub(super) fn over_cube<S: Fours>(&self, s: S, vector: &Series, n: usize) -> Row {
        if self.is_circular() { vector[n] } else { product(s, &self.cube_rows, vector, n) }
    }

    /// Finds coefficient n + 1 of ρ and ν.
    #[inline(always)]
    pub(super) fn extend<S: Fours>(&mut self, n: usize, known: &Known<'_, S>) {
        let pull = self.over_cube(known.s, &self.rho.rows, n) * Row::splat(-self.strength);
        let rate = cross(known.s, &self.rho.rows, known.turning, n) + self.nu.coefficient(n);
        self.rho.set(n + 1, rate.over(n + 1));
        self.nu.extend(known.s, n, known.turning, pull);
    }
}
