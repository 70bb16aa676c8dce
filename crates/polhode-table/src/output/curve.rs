//! The curves of a free motion: a row per point.
//!
//! Points are where the curve bends, not at equal times. A closed curve ends with the point with which it begins.

use polhode::observe::{Curve, Herpolhode, MomentumTrace, Polhode, RollingCones};

use super::Table;

/// The path of ω in the body.
pub fn polhode(polhode: &Polhode) -> Table<'_> {
    of(["omega_body", "_rad_s"], "rad/s", &polhode.curve)
}

/// The path of L in the body.
pub fn momentum(trace: &MomentumTrace) -> Table<'_> {
    of(["momentum_body", "_kg_m2_s"], "kg·m²/s", &trace.curve)
}

/// The path of ω on the invariable plane: its component across L along space axes, and in two
/// right-handed axes of the plane.
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

/// The rulings of the body cone, ω along body axes.
pub fn body_cone(cones: &RollingCones) -> Table<'_> {
    of(["omega_body", "_rad_s"], "rad/s", &cones.body)
}

/// The rulings of the space cone at the same times, ω along space axes.
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
