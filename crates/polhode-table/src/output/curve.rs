//! Curves of a free motion, with a row for each point.
//!
//! Points are dense where the curve bends; they are not at equal times. A closed curve ends with
//! its first point.

use polhode::observe::{Curve, Herpolhode, MomentumTrace, Polhode, RollingCones};

use super::Table;

/// Returns the path of ω in the body, rad/s.
pub fn polhode(polhode: &Polhode) -> Table<'_> {
    of(["omega_body", "_rad_s"], "rad/s", &polhode.curve)
}

/// Returns the path of L in the body, kg·m²/s.
pub fn momentum(trace: &MomentumTrace) -> Table<'_> {
    of(["momentum_body", "_kg_m2_s"], "kg·m²/s", &trace.curve)
}

/// Returns the path of ω on the invariable plane, rad/s. It has the component of ω perpendicular to
/// L along space axes, and its coordinates in two right-handed axes of the plane.
pub fn herpolhode(herpolhode: &Herpolhode) -> Table<'_> {
    let mut table = of(["across_space", "_rad_s"], "rad/s", &herpolhode.curve);
    let plane = herpolhode.in_plane();
    for k in 0..2 {
        let component: Vec<f64> = plane.iter().map(|point| point[k]).collect();
        table
            .number(format!("plane_{}_rad_s", k + 1), "rad/s", POINT, move |row| at(&component, row, |x| *x));
    }
    table
}

/// Returns the rulings of the body cone: ω along body axes, rad/s.
pub fn body_cone(cones: &RollingCones) -> Table<'_> {
    of(["omega_body", "_rad_s"], "rad/s", &cones.body)
}

/// Returns the rulings of the space cone at the same times: ω along space axes, rad/s.
pub fn space_cone(cones: &RollingCones) -> Table<'_> {
    of(["omega_space", "_rad_s"], "rad/s", &cones.space)
}

const POINT: &str = "point of the curve";

fn of<'a, Q, F>(name: [&str; 2], unit: &'static str, curve: &'a Curve<Q, F>) -> Table<'a> {
    let mut table = Table::new("curve", curve.points().len());
    table.number("time_s", "s", "time", |row| at(curve.times(), row, |time| *time));
    table.vector(name, unit, POINT, |row| {
        curve.points().get(row).map_or([f64::NAN; 3], |point| point.to_array())
    });
    table
}

fn at<T>(all: &[T], row: usize, number: impl Fn(&T) -> f64) -> f64 {
    all.get(row).map_or(f64::NAN, number)
}
