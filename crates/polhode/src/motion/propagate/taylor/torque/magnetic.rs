//! The series of a magnet in a field: N = m × B, with B seen from the body.
//!
//! A uniform field is constant in space. A dipole's is B = (µ₀/4π r₀³)(3 (M·ρ) ρ/|ρ|² − M)/|ρ|³, M constant in space and ρ = r/r₀ from
//! the orbit's series.

use super::super::row::{Row, Series, TERMS, product};
use super::super::scalar::{Scalars, quotient};
use super::super::seen::Seen;
use super::orbit::OrbitSeries;
use super::{Known, StepStart, row};
use crate::math::frame::{Principal, Space};
use crate::math::lanes::Fours;
use crate::math::vector::Direction;
use crate::motion::propagate::chart::{ROUNDING, THIN};
use crate::motion::rotor::Rotor;
use crate::motion::torque::magnetic::MU_0_OVER_4_PI;
use crate::motion::torque::{Magnetic, MagneticField};

/// The series of a magnet in a field.
#[derive(Clone, Debug)]
pub(in super::super) struct MagneticSeries {
    /// m, principal axes.
    moment: Row,
    /// B, or M of a dipole.
    source: Direction<Space>,
    seen: Seen,
    dipole: Option<Box<DipoleSeries>>,
}

/// What a dipole's field needs beside M.
#[derive(Clone, Debug)]
struct DipoleSeries {
    orbit: OrbitSeries,
    /// M·ρ, and that over |ρ|²
    along: Scalars,
    ratio: Scalars,
    ratio_rows: Series,
    /// B |ρ|³, in units of µ₀/4π r₀³
    pattern: Series,
}

impl MagneticSeries {
    pub(super) fn of(model: &Magnetic, rotor: &Rotor) -> Self {
        let moment = rotor.principal().rotation().inverse() * model.moment;
        let (source, dipole) = match &model.field {
            MagneticField::Uniform(field) => (*field, None),
            MagneticField::Dipole { dipole, orbit } => (*dipole, Some(Box::new(DipoleSeries::of(orbit)))),
        };
        Self { moment: cleaned(moment, rotor), source, seen: Seen::ZERO, dipole }
    }

    pub(super) fn start(&mut self, at: &StepStart) {
        self.seen.start(row(at.attitude.inverse() * self.source));
        if let Some(dipole) = &mut self.dipole {
            dipole.orbit.start(at);
        }
    }

    #[inline(never)]
    pub(super) fn coefficient<S: Fours>(&mut self, n: usize, known: &Known<'_, S>) -> Row {
        let field = match &mut self.dipole {
            None => self.seen.coefficient(n),
            Some(dipole) => dipole.coefficient(known.s, n, self.seen.series()),
        };
        // m × B: (m B' − m' B)', ' for turned
        (self.moment * field.turned() - self.moment.turned() * field).turned()
    }

    #[inline(never)]
    pub(super) fn extend<S: Fours>(&mut self, n: usize, known: &Known<'_, S>) {
        self.seen.extend(known.s, n, known.turning, Row::ZERO);
        if let Some(dipole) = &mut self.dipole {
            dipole.orbit.extend(n, known);
        }
    }
}

impl DipoleSeries {
    fn of(orbit: &crate::motion::orbit::Orbit) -> Self {
        Self {
            orbit: OrbitSeries::of(orbit),
            along: [0.0; TERMS],
            ratio: [0.0; TERMS],
            ratio_rows: Series::ZERO,
            pattern: Series::ZERO,
        }
    }

    /// Coefficient n of B, with M seen from the body.
    #[inline(always)]
    fn coefficient<S: Fours>(&mut self, s: S, n: usize, dipole: &Series) -> Row {
        self.orbit.measure(s, n);
        let rho = &self.orbit.rho.rows;
        let [x, y, z, _] = product(s, dipole, rho, n).0;
        self.along[n] = x + y + z;
        self.ratio[n] = quotient(&self.along, &self.orbit.square, &self.ratio, n);
        self.ratio_rows.set(n, Row::splat(3.0 * self.ratio[n]));
        self.pattern.set(n, product(s, &self.ratio_rows, rho, n) - dipole.at(n));
        let r = self.orbit.distance;
        self.orbit.over_cube(s, &self.pattern, n) * Row::splat(MU_0_OVER_4_PI / r / r / r)
    }
}

/// m without what is only rounding across a needle: its torque along the needle, divided by so small a moment, would spin it.
fn cleaned(moment: Direction<Principal>, rotor: &Rotor) -> Row {
    let [i1, _, i3] = rotor.principal().moments();
    let [x, y, z] = moment.to_array();
    let clean = |v: f64| if i1 < THIN * i3 && v.abs() < ROUNDING * x.abs() { 0.0 } else { v };
    Row([x, clean(y), clean(z), 0.0])
}
