//! Quantities with a unit of suitable size, from SI values.

use polhode::body::MassProperties;
use polhode::math::Frame;

use crate::number::{DIGITS, NO_BREAK, alike, number, within};
use crate::si_prefix;

/// Unit with its conversion factor.
#[derive(Clone, Copy, Debug)]
pub struct Unit {
    /// Symbol of the unit.
    pub name: &'static str,
    /// Conversion factor: value in this unit = value in SI × `per_si`.
    per_si: f64,
    /// Smallest size in SI for which the unit is used.
    from: f64,
}

const MASS: [Unit; 6] = [
    Unit { name: "t", per_si: 1e-3, from: 1e4 },
    Unit { name: "kg", per_si: 1.0, from: 0.1 },
    Unit { name: "g", per_si: 1e3, from: 1e-4 },
    Unit { name: "mg", per_si: 1e6, from: 1e-7 },
    Unit { name: "kg", per_si: 1.0, from: f64::MIN_POSITIVE },
    Unit { name: "kg", per_si: 1.0, from: 0.0 },
];

const LENGTH: [Unit; 6] = [
    Unit { name: "km", per_si: 1e-3, from: 1e4 },
    Unit { name: "m", per_si: 1.0, from: 0.1 },
    Unit { name: "mm", per_si: 1e3, from: 1e-4 },
    Unit { name: "µm", per_si: 1e6, from: 1e-7 },
    Unit { name: "nm", per_si: 1e9, from: 1e-12 },
    Unit { name: "m", per_si: 1.0, from: 0.0 },
];

const AREA: [Unit; 4] = [
    Unit { name: "m²", per_si: 1.0, from: 0.1 },
    Unit { name: "cm²", per_si: 1e4, from: 1e-5 },
    Unit { name: "mm²", per_si: 1e6, from: 1e-9 },
    Unit { name: "m²", per_si: 1.0, from: 0.0 },
];

const VOLUME: [Unit; 4] = [
    Unit { name: "m³", per_si: 1.0, from: 0.01 },
    Unit { name: "cm³", per_si: 1e6, from: 1e-8 },
    Unit { name: "mm³", per_si: 1e9, from: 1e-12 },
    Unit { name: "m³", per_si: 1.0, from: 0.0 },
];

/// Units of long times; each is used from three of them on: hours from 3 h, days from 3 d.
const LONGER: [(&str, f64); 2] = [("d", 86_400.0), ("h", 3_600.0)];

/// Formats a time in s, with hours or days in parentheses for a long one: `464832 s (5.38 d)`.
pub fn duration(seconds: f64, digits: usize) -> String {
    let shown = format!("{}{NO_BREAK}s", number(seconds, digits));
    match longer(seconds) {
        Some((name, unit)) => format!("{shown}{NO_BREAK}({}{NO_BREAK}{name})", number(seconds / unit, 6)),
        None => shown,
    }
}

/// Returns the name and length, s, of the hour or day for a long time; `None` for a short one.
pub fn longer(seconds: f64) -> Option<(&'static str, f64)> {
    LONGER.into_iter().find(|(_, unit)| seconds.abs() >= 3.0 * unit)
}

/// Formats a time in one unit: `97.55 ms`, `5.369 d`.
pub fn time(seconds: f64, digits: usize) -> String {
    if let Some((name, unit)) = longer(seconds) {
        return format!("{}{NO_BREAK}{name}", number(seconds / unit, digits));
    }
    let (prefix, size) = si_prefix::fitting(seconds.abs(), "s").unwrap_or(("", 1.0));
    format!("{}{NO_BREAK}{prefix}s", number(seconds / size, digits))
}

/// Formats a mass: `0.412618 kg`.
pub fn mass(kg: f64) -> String {
    one(&MASS, kg)
}

/// Formats a length: `-20 mm`.
pub fn length(m: f64) -> String {
    one(&LENGTH, m)
}

/// Formats an area: `18.5 cm²`.
pub fn area(m2: f64) -> String {
    one(&AREA, m2)
}

/// Formats a volume: `152.822 cm³`.
pub fn volume(m3: f64) -> String {
    one(&VOLUME, m3)
}

/// Formats three lengths in one unit: `12.961562  -17.608532  15.068595  mm`.
pub fn lengths(m: [f64; 3]) -> String {
    aligned(m, fitting(&LENGTH, largest(m)))
}

/// Formats a point: `(10, 0, -20) mm`.
pub fn place(m: [f64; 3]) -> String {
    place_within(m, 0.0)
}

/// Formats a point as [`place`] does, without the digits that its error, m, makes uncertain.
pub fn place_within(m: [f64; 3], error: f64) -> String {
    let unit = fitting(&LENGTH, largest(m));
    let (m, error) = (m.map(|x| x * unit.per_si), error * unit.per_si);
    format!("{} {}", crate::number::vector_within(m, error, DIGITS), unit.name)
}

/// Formats the coordinates of a point as [`lengths`] does; `size` is the largest radius of gyration
/// of the body, m.
pub fn lengths_in(size: f64, m: [f64; 3]) -> String {
    let m = m.map(|x| beside(x, size));
    aligned(m, unit_in(size, m))
}

/// Formats a point as [`place`] does; `size` is the largest radius of gyration of the body, m.
pub fn place_in(size: f64, m: [f64; 3]) -> String {
    let m = m.map(|x| beside(x, size));
    let unit = unit_in(size, m);
    format!("{} {}", crate::number::vector(m.map(|x| x * unit.per_si), DIGITS), unit.name)
}

fn aligned(m: [f64; 3], unit: Unit) -> String {
    format!("{}  {}", alike(&m.map(|x| x * unit.per_si), DIGITS).join("  "), unit.name)
}

/// Returns the largest radius of gyration of a body, m: the size for [`place_in`].
pub fn size<F: Frame>(body: &MassProperties<F>) -> f64 {
    largest(body.gyration_radii())
}

/// Returns the unit for a point of a body. It is not much smaller than the body, even for a centre
/// close to the origin.
fn unit_in(size: f64, m: [f64; 3]) -> Unit {
    let largest = largest(m);
    fitting(&LENGTH, if largest > 0.0 { largest.max(1e-3 * size) } else { 0.0 })
}

fn largest(m: [f64; 3]) -> f64 {
    m.iter().fold(0.0, |max, x| f64::max(max, x.abs()))
}

/// Rounds a coordinate in a body of this size. Rounding errors become 0; below a thousandth of the
/// size it keeps fewer digits the smaller it is.
fn beside(x: f64, size: f64) -> f64 {
    const ROUNDING: f64 = 1e-12;
    const LAST: f64 = 1e-10;
    let part = x.abs() / size;
    if !(part < 1e-3) {
        return x;
    }
    if part <= ROUNDING {
        return 0.0;
    }
    let digits = (part / LAST).log10().ceil().max(2.0) as usize;
    format!("{x:.*e}", digits - 1).parse().unwrap_or(x)
}

/// Formats an angle: `0.6 rad (34.3775°)`.
pub fn angle(rad: f64) -> String {
    format!("{} rad ({}°)", number(rad, 6), number(rad.to_degrees(), 6))
}

/// Formats the amplitude of a pendulum that does not go over the top; it is never rounded to 180°.
pub fn amplitude(rad: f64) -> String {
    if number(rad.to_degrees(), 6) == "180" {
        return format!("{} rad (just below 180°)", number(rad, 6));
    }
    angle(rad)
}

/// Formats the half-angle of a cone; an angle of the size of rounding errors is 0.
pub fn cone(rad: f64) -> String {
    angle(if rad < CLOSED { 0.0 } else { rad })
}

/// Half-angle, rad, below which a cone counts as closed, up to rounding.
pub const CLOSED: f64 = 1e-13;

/// Formats an angular velocity: `3 rad/s (171.887 deg/s)`.
pub fn rate(rad_per_s: f64) -> String {
    rate_within(rad_per_s, 0.0)
}

/// Formats an angular velocity with the digits that an error, rad/s, leaves.
pub fn rate_within(rad_per_s: f64, error: f64) -> String {
    let degrees = within(rad_per_s.to_degrees(), error.to_degrees(), 6);
    format!("{} rad/s ({degrees} deg/s)", within(rad_per_s, error, DIGITS))
}

fn one(units: &[Unit], si: f64) -> String {
    let unit = fitting(units, si.abs());
    format!("{} {}", number(si * unit.per_si, DIGITS), unit.name)
}

/// Returns the first unit that is not too large; zero is given in the SI unit.
fn fitting(units: &[Unit], size: f64) -> Unit {
    let fits = units.iter().find(|unit| size > 0.0 && size >= unit.from);
    fits.copied().unwrap_or(units[units.len() - 1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::plain_spaces;

    #[test]
    fn a_point_has_the_unit_of_its_body() {
        // The centre of mass of a drone, 3e-10 m from the origin in one direction.
        assert_eq!(lengths_in(0.21, [0.0, 3.000_17e-10, 0.0]), "0  3e-7  0  mm");
        assert_eq!(place_in(0.21, [0.0, 3.000_17e-10, 0.0]), "(0, 3e-7, 0) mm");
        // Rounding errors become 0. Coordinates small relative to the body keep few digits, others
        // all.
        assert_eq!(place_in(0.21, [1.3e-14, -0.012_345_678_9, 2.345_678_9e-8]), "(0, -12.3457, 2.346e-5) mm");
        assert_eq!(
            lengths_in(0.21, [0.012_961_562, -0.017_608_532, 0.015]),
            lengths([0.012_961_562, -0.017_608_532, 0.015])
        );
        // A body of nanometre size is given in nanometres, as is a particle, which has no size.
        assert_eq!(place_in(4e-10, [1.2e-10, 0.0, -3e-10]), "(0.12, 0, -0.3) nm");
        assert_eq!(place_in(0.0, [3e-10, 0.0, 0.0]), "(0.3, 0, 0) nm");
        assert_eq!(place_in(0.0, [0.0; 3]), "(0, 0, 0) m");
        assert_eq!(place_in(2.0, [0.0; 3]), "(0, 0, 0) m");
    }

    #[test]
    fn hours_begin_at_three_and_days_at_three() {
        let read = |seconds: f64| plain_spaces(&format!("{}; {}", time(seconds, 4), duration(seconds, 4)));
        assert_eq!(read(9_000.0), "9000 s; 9000 s");
        assert_eq!(read(12_600.0), "3.5 h; 12600 s (3.5 h)");
        assert_eq!(read(216_000.0), "60 h; 216000 s (60 h)");
        assert_eq!(read(463_841.0), "5.369 d; 463841 s (5.36853 d)");
        assert_eq!(plain_spaces(&time(-0.097_55, 4)), "-97.55 ms");
        assert_eq!(plain_spaces(&time(5.635e-12, 4)), "5.635 ps");
        assert_eq!(plain_spaces(&time(0.0, 4)), "0 s");
    }

    #[test]
    fn units_fit_the_size() {
        assert_eq!(mass(0.012), "12 g");
        assert_eq!(plain_spaces(&mass(0.412_618_3)), "0.412618 kg");
        assert_eq!(mass(5.972e24), "5.972e21 t");
        assert_eq!(mass(1.66e-27), "1.66e-27 kg");
        assert_eq!(volume(1.528_216e-4), "152.822 cm³");
        assert_eq!(lengths([0.0; 3]), "0  0  0  m");
        assert_eq!(lengths([0.0, 1.5e-3, -2e-3]), "0  1.5  -2.0  mm");
        assert_eq!(rate(0.0), "0 rad/s (0 deg/s)");
        assert_eq!(plain_spaces(&amplitude(std::f64::consts::PI - 1e-9)), "3.14159 rad (just below 180°)");
        assert_eq!(amplitude(0.5), angle(0.5));
    }
}
