//! Units for people: the size that fits, from SI.

use polhode::body::MassProperties;
use polhode::math::Frame;

use crate::number::{NO_BREAK, alike, number, within};
use crate::si_prefix;

/// A unit and how many SI units it is.
#[derive(Clone, Copy, Debug)]
pub struct Unit {
    /// Symbol of the unit.
    pub name: &'static str,
    /// A number in SI times this is a number in the unit.
    per_si: f64,
    /// From this size (SI) on the unit fits.
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

/// Units of a time that is three of them or longer: hours from 3 h on, days from 3 d.
const LONGER: [(&str, f64); 2] = [("d", 86_400.0), ("h", 3_600.0)];

/// Digits of a quantity that stands alone.
pub const DIGITS: usize = 7;

/// A time with its digits, and in hours or days where that says more: `464832 s (5.38 d)`.
pub fn duration(seconds: f64, digits: usize) -> String {
    let shown = format!(
        "{}{NO_BREAK}s",
        if digits > DIGITS { number(seconds, digits) } else { number(seconds, digits) }
    );
    match longer(seconds) {
        Some((name, unit)) => format!("{shown}{NO_BREAK}({}{NO_BREAK}{name})", number(seconds / unit, 6)),
        None => shown,
    }
}

/// Hours or days, with the length of one, s, for a time that is read in them.
pub fn longer(seconds: f64) -> Option<(&'static str, f64)> {
    LONGER.into_iter().find(|(_, unit)| seconds.abs() >= 3.0 * unit)
}

/// A time in one unit: `97.55 ms`, `5.369 d`.
pub fn time(seconds: f64, digits: usize) -> String {
    if let Some((name, unit)) = longer(seconds) {
        return format!("{}{NO_BREAK}{name}", number(seconds / unit, digits));
    }
    let (prefix, size) = si_prefix::fitting(seconds.abs(), "s").unwrap_or(("", 1.0));
    format!("{}{NO_BREAK}{prefix}s", number(seconds / size, digits))
}

/// `0.4126183 kg`
pub fn mass(kg: f64) -> String {
    one(&MASS, kg)
}

/// `-20 mm`
pub fn length(m: f64) -> String {
    one(&LENGTH, m)
}

/// `18.5 cm²`
pub fn area(m2: f64) -> String {
    one(&AREA, m2)
}

/// `152.8216 cm³`
pub fn volume(m3: f64) -> String {
    one(&VOLUME, m3)
}

/// Three lengths in one unit: `12.961562  -17.608532  15.068595  mm`
pub fn lengths(m: [f64; 3]) -> String {
    aligned(m, fitting(&LENGTH, largest(m)))
}

/// A point: `(10, 0, -20) mm`
pub fn place(m: [f64; 3]) -> String {
    place_within(m, 0.0)
}

/// A point as [`place`]; no digit of a coordinate after the first that its error, m, makes uncertain.
pub fn place_within(m: [f64; 3], error: f64) -> String {
    let unit = fitting(&LENGTH, largest(m));
    let (m, error) = (m.map(|x| x * unit.per_si), error * unit.per_si);
    format!("{} {}", crate::number::vector_within(m, error, DIGITS), unit.name)
}

/// The coordinates of a point in a body whose largest radius of gyration is `size`, m, as [`lengths`].
pub fn lengths_in(size: f64, m: [f64; 3]) -> String {
    let m = m.map(|x| beside(x, size));
    aligned(m, unit_in(size, m))
}

/// A point in a body whose largest radius of gyration is `size`, m, as [`place`].
pub fn place_in(size: f64, m: [f64; 3]) -> String {
    let m = m.map(|x| beside(x, size));
    let unit = unit_in(size, m);
    format!("{} {}", crate::number::vector(m.map(|x| x * unit.per_si), DIGITS), unit.name)
}

fn aligned(m: [f64; 3], unit: Unit) -> String {
    format!("{}  {}", alike(&m.map(|x| x * unit.per_si), DIGITS).join("  "), unit.name)
}

/// The size of a body for [`place_in`]: its largest radius of gyration, m.
pub fn size<F: Frame>(body: &MassProperties<F>) -> f64 {
    largest(body.gyration_radii())
}

/// The unit of a point in a body: a centre that is almost at the origin does not go in nanometres.
fn unit_in(size: f64, m: [f64; 3]) -> Unit {
    let largest = largest(m);
    fitting(&LENGTH, if largest > 0.0 { largest.max(1e-3 * size) } else { 0.0 })
}

fn largest(m: [f64; 3]) -> f64 {
    m.iter().fold(0.0, |max, x| f64::max(max, x.abs()))
}

/// A coordinate in a body of this size: 0 if it is rounding beside that, and the fewer digits the less it is; from a thousandth
/// on it keeps all.
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

/// `0.6 rad (34.3775°)`
pub fn angle(rad: f64) -> String {
    format!("{} rad ({}°)", number(rad, 6), number(rad.to_degrees(), 6))
}

/// How far a pendulum swings that does not go over the top: never 180°, however it rounds.
pub fn amplitude(rad: f64) -> String {
    if number(rad.to_degrees(), 6) == "180" {
        return format!("{} rad (just below 180°)", number(rad, 6));
    }
    angle(rad)
}

/// The half-angle of a cone: one that only rounding opened is closed.
pub fn cone(rad: f64) -> String {
    angle(if rad < CLOSED { 0.0 } else { rad })
}

/// A cone of a smaller half-angle, rad, is a line but for rounding.
pub const CLOSED: f64 = 1e-13;

/// `3 rad/s (171.887 deg/s)`
pub fn rate(rad_per_s: f64) -> String {
    rate_within(rad_per_s, 0.0)
}

/// The same with the digits that an error (rad/s) leaves.
pub fn rate_within(rad_per_s: f64, error: f64) -> String {
    let degrees = within(rad_per_s.to_degrees(), error.to_degrees(), 6);
    format!("{} rad/s ({degrees} deg/s)", within(rad_per_s, error, DIGITS))
}

fn one(units: &[Unit], si: f64) -> String {
    let unit = fitting(units, si.abs());
    format!("{} {}", number(si * unit.per_si, DIGITS), unit.name)
}

/// The first unit that is not too large; a zero goes in the SI unit.
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
        // A drone's centre that is 3e-10 m off the origin, in one direction.
        assert_eq!(lengths_in(0.21, [0.0, 3.000_17e-10, 0.0]), "0  3e-7  0  mm");
        assert_eq!(place_in(0.21, [0.0, 3.000_17e-10, 0.0]), "(0, 3e-7, 0) mm");
        // What is rounding is 0; what is small beside the body keeps few digits, what is not keeps all.
        assert_eq!(
            place_in(0.21, [1.3e-14, -0.012_345_678_9, 2.345_678_9e-8]),
            "(0, -12.34568, 2.346e-5) mm"
        );
        assert_eq!(
            lengths_in(0.21, [0.012_961_562, -0.017_608_532, 0.015]),
            lengths([0.012_961_562, -0.017_608_532, 0.015])
        );
        // A body of nanometres has nanometres, and so has a particle, which has no size.
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
        assert_eq!(plain_spaces(&mass(0.412_618_3)), "0.4126183 kg");
        assert_eq!(mass(5.972e24), "5.972e21 t");
        assert_eq!(mass(1.66e-27), "1.66e-27 kg");
        assert_eq!(volume(1.528_216e-4), "152.8216 cm³");
        assert_eq!(lengths([0.0; 3]), "0  0  0  m");
        assert_eq!(lengths([0.0, 1.5e-3, -2e-3]), "0  1.5  -2.0  mm");
        assert_eq!(rate(0.0), "0 rad/s (0 deg/s)");
        assert_eq!(plain_spaces(&amplitude(std::f64::consts::PI - 1e-9)), "3.14159 rad (just below 180°)");
        assert_eq!(amplitude(0.5), angle(0.5));
    }
}
