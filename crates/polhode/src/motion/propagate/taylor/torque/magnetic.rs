//! The series of a magnet in a field: N = m × B, with B seen from the body.
//!
//! A uniform field is constant in space. A dipole's is B = (µ₀/4π r₀³)(3 (M·ρ) ρ/|ρ|² − M)/|ρ|³, M constant in space and ρ = r/r₀ from
//! the orbit's series.

use super::super::row::{Row, Series, TERMS};
use super::super::scalar::{Scalars, quotient};
use super::super::seen::Seen;
use super::super::sums::Sums;
use super::orbit::OrbitSeries;
use super::{Known, StepStart, row};
use crate::math::frame::Principal;
use crate::math::number::Number;
use crate::math::vector::Direction;
use crate::motion::orbit::Orbit;
use crate::motion::propagate::chart::{ROUNDING, THIN};
use crate::motion::rotor::Rotor;
use crate::motion::torque::magnetic::MU_0_OVER_4_PI;
use crate::motion::torque::{Magnetic, MagneticField};

/// The series of a magnet in a field.
#[derive(Clone, Debug)]
pub(in super::super) struct MagneticSeries<N> {
    /// m, principal axes.
    moment: Row<N>,
    /// B, or M of a dipole, space axes.
    source: Row<N>,
    seen: Seen<N>,
    dipole: Option<Box<DipoleSeries<N>>>,
}

/// What a dipole's field needs beside M.
#[derive(Clone, Debug)]
struct DipoleSeries<N> {
    orbit: OrbitSeries<N>,
    /// M·ρ, and that over |ρ|²
    along: Scalars<N>,
    ratio: Scalars<N>,
    ratio_rows: Series<N>,
    /// B |ρ|³, in units of µ₀/4π r₀³
    pattern: Series<N>,
}

impl<N: Number> MagneticSeries<N> {
    pub(super) fn of(zero: N, model: &Magnetic) -> Self {
        let dipole = match &model.field {
            MagneticField::Uniform(_) => None,
            MagneticField::Dipole { orbit, .. } => Some(Box::new(DipoleSeries::of(zero, orbit))),
        };
        Self { moment: Row::splat(zero), source: Row::splat(zero), seen: Seen::all(zero), dipole }
    }

    pub(super) fn set(&mut self, lane: usize, model: &Magnetic, rotor: &Rotor) {
        let moment = rotor.principal().rotation().inverse() * model.moment;
        self.moment.put(lane, cleaned(moment, rotor));
        let source = match (&model.field, &mut self.dipole) {
            (MagneticField::Dipole { dipole, orbit }, Some(series)) => {
                series.orbit.set(lane, orbit);
                dipole
            }
            (MagneticField::Uniform(source) | MagneticField::Dipole { dipole: source, .. }, _) => source,
        };
        self.source.put(lane, row(*source));
    }

    #[inline(always)]
    pub(super) fn start(&mut self, at: &StepStart<N>) {
        self.seen.start(at.seen(self.source));
        if let Some(dipole) = &mut self.dipole {
            dipole.orbit.start(at);
        }
    }

    #[inline(always)]
    pub(super) fn coefficient<M: Sums<N = N>>(&mut self, n: usize, known: &Known<'_, M>) -> Row<N> {
        let field = match &mut self.dipole {
            None => self.seen.coefficient(n),
            Some(dipole) => dipole.coefficient(known.s, n, self.seen.series()),
        };
        // m × B: (m B' − m' B)', ' for turned
        (self.moment * field.turned() - self.moment.turned() * field).turned()
    }

    #[inline(always)]
    pub(super) fn extend<M: Sums<N = N>>(&mut self, n: usize, known: &Known<'_, M>) {
        let none = Row::splat(self.moment.0[0].like(0.0));
        self.seen.extend(known.s, n, known.turning, none);
        if let Some(dipole) = &mut self.dipole {
            dipole.orbit.extend(n, known);
        }
    }
}

impl<N: Number> DipoleSeries<N> {
    fn of(zero: N, orbit: &Orbit) -> Self {
        Self {
            orbit: OrbitSeries::of(zero, orbit),
            along: [zero; TERMS],
            ratio: [zero; TERMS],
            ratio_rows: Series::all(zero),
            pattern: Series::all(zero),
        }
    }

    /// Coefficient n of B, with M seen from the body.
    #[inline(always)]
    fn coefficient<M: Sums<N = N>>(&mut self, s: M, n: usize, dipole: &Series<N>) -> Row<N> {
        self.orbit.measure(s, n);
        let rho = &self.orbit.rho.rows;
        let [x, y, z, _] = s.product(dipole, rho, n).0;
        self.along[n] = x + y + z;
        self.ratio[n] = quotient(&self.along, &self.orbit.square, &self.ratio, n);
        self.ratio_rows.set(n, Row::splat(x.like(3.0) * self.ratio[n]));
        self.pattern.set(n, s.product(&self.ratio_rows, rho, n) - dipole.at(n));
        let r = self.orbit.distance;
        self.orbit.over_cube(s, &self.pattern, n) * Row::splat(r.like(MU_0_OVER_4_PI) / r / r / r)
    }
}

/// m without what is only rounding across a needle: its torque along the needle, divided by so small a moment, would spin it.
fn cleaned(moment: Direction<Principal>, rotor: &Rotor) -> Row {
    let [i1, _, i3] = rotor.principal().moments();
    let [x, y, z] = moment.to_array();
    let clean = |v: f64| if i1 < THIN * i3 && v.abs() < ROUNDING * x.abs() { 0.0 } else { v };
    Row([x, clean(y), clean(z), 0.0])
}
