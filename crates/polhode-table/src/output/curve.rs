//! The curves of a free motion as text: a line per point, in the CSV of the trajectory table.
//!
//! Points are where the curve bends, not at equal times. A closed curve ends with the point with which it begins.

use std::io::{self, BufWriter, Write};

use polhode::observe::{Curve, Herpolhode, MomentumTrace, Polhode, RollingCones};

use super::csv::separated;

/// The path of ω in the body: `time_s, omega_body_x_rad_s, …`
///
/// # Errors
/// Those of `out`.
pub fn polhode(polhode: &Polhode, out: impl Write) -> io::Result<()> {
    write(["omega_body_x_rad_s", "omega_body_y_rad_s", "omega_body_z_rad_s"], &polhode.curve, out)
}

/// The path of L in the body: `time_s, momentum_body_x_kg_m2_s, …`
///
/// # Errors
/// Those of `out`.
pub fn momentum(trace: &MomentumTrace, out: impl Write) -> io::Result<()> {
    let names = ["momentum_body_x_kg_m2_s", "momentum_body_y_kg_m2_s", "momentum_body_z_kg_m2_s"];
    write(names, &trace.curve, out)
}

/// The path of ω on the invariable plane: its component across L along space axes, `time_s, across_space_x_rad_s, …`, and in
/// two right-handed axes of the plane, `plane_1_rad_s, plane_2_rad_s`.
///
/// # Errors
/// Those of `out`.
pub fn herpolhode(herpolhode: &Herpolhode, out: impl Write) -> io::Result<()> {
    let names = [
        "across_space_x_rad_s",
        "across_space_y_rad_s",
        "across_space_z_rad_s",
        "plane_1_rad_s",
        "plane_2_rad_s",
    ];
    let curve = &herpolhode.curve;
    let points = curve.points().iter().zip(herpolhode.in_plane());
    let rows = points.map(|(across, [u, v])| [across.x, across.y, across.z, u, v]);
    lines(names, curve.times().iter().copied().zip(rows), out)
}

/// The rulings of the body cone, ω along body axes: `time_s, omega_body_x_rad_s, …`
///
/// # Errors
/// Those of `out`.
pub fn body_cone(cones: &RollingCones, out: impl Write) -> io::Result<()> {
    write(["omega_body_x_rad_s", "omega_body_y_rad_s", "omega_body_z_rad_s"], &cones.body, out)
}

/// The rulings of the space cone at the same times, ω along space axes: `time_s, omega_space_x_rad_s, …`
///
/// # Errors
/// Those of `out`.
pub fn space_cone(cones: &RollingCones, out: impl Write) -> io::Result<()> {
    write(["omega_space_x_rad_s", "omega_space_y_rad_s", "omega_space_z_rad_s"], &cones.space, out)
}

fn write<Q, F>(names: [&str; 3], curve: &Curve<Q, F>, out: impl Write) -> io::Result<()> {
    let points = curve.points().iter().map(|point| point.to_array());
    lines(names, curve.times().iter().copied().zip(points), out)
}

/// A line of names, then a line per point.
fn lines<const N: usize>(
    names: [&str; N],
    rows: impl Iterator<Item = (f64, [f64; N])>,
    out: impl Write,
) -> io::Result<()> {
    let mut out = BufWriter::new(out);
    write!(out, "time_s,")?;
    separated(&mut out, &names, |out, name| write!(out, "{name}"))?;
    for (time, numbers) in rows {
        write!(out, "{time:?},")?;
        separated(&mut out, &numbers, |out, number| write!(out, "{number:?}"))?;
    }
    out.flush()
}
