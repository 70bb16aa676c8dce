//! Mass-property reports in the formats of CAD programs.

use std::fmt::Write;

use polhode::body::MassProperties;
use polhode::math::{Body, Position};
use polhode_shape::cad::ProductConvention;

/// Output format of a program.
#[derive(Clone, Copy)]
pub(crate) struct Print {
    pub(crate) sign: ProductConvention,
    /// Names of the units of mass and length in the program, and their values in SI in the next
    /// field.
    pub(crate) words: [&'static str; 2],
    pub(crate) units: [f64; 2],
    pub(crate) number: fn(f64) -> String,
}

impl Print {
    pub(crate) fn mass(&self, body: &MassProperties<Body>) -> String {
        (self.number)(body.mass() / self.units[0])
    }

    pub(crate) fn center(&self, body: &MassProperties<Body>) -> [String; 3] {
        body.center_of_mass().to_array().map(|c| (self.number)(c / self.units[1]))
    }

    pub(crate) fn tensor(&self, rows: [[f64; 3]; 3]) -> [[String; 3]; 3] {
        let unit = self.units[0] * self.units[1] * self.units[1];
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let flip = i != j && self.sign == ProductConvention::Positive;
                (self.number)(if flip { -rows[i][j] } else { rows[i][j] } / unit)
            })
        })
    }
}

pub(crate) const LETTERS: [char; 3] = ['x', 'y', 'z'];

pub(crate) fn solidworks(body: &MassProperties<Body>, print: Print) -> String {
    let [mass, length] = print.words;
    let [x, y, z] = print.center(body);
    let mut text = format!(
        "Mass properties of bracket 12\n     Configuration: Default\n     Coordinate system: -- default --\n\n\
         Mass = {} {mass}\n\nVolume = {} cubic {length}\n\nCenter of mass: ( {length} )\n\tX = {x}\n\tY = {y}\n\tZ = {z}\n\n",
        print.mass(body),
        (print.number)(3e-4 / print.units[1].powi(3)),
    );
    let tensors = [
        (
            "L",
            "Taken at the center of mass and aligned with the output coordinate system.",
            body.inertia().matrix(),
        ),
        ("I", "Taken at the output coordinate system.", body.inertia_about(Position::ZERO).matrix()),
    ];
    for (letter, taken, rows) in tensors {
        writeln!(text, "Moments of inertia: ( {mass} *  square {length} )\n{taken}").unwrap();
        for (i, row) in print.tensor(rows).iter().enumerate() {
            for (j, element) in row.iter().enumerate() {
                write!(text, "\t{letter}{}{} = {element}", LETTERS[i], LETTERS[j]).unwrap();
            }
            text.push('\n');
        }
        text.push('\n');
    }
    text
}

pub(crate) fn fusion(body: &MassProperties<Body>, print: Print) -> String {
    let [mass, length] = print.words;
    let [x, y, z] = print.center(body);
    let mut text = format!(
        "wheel of inertia v7\n\nArea\t5876.196 {length}^2\nDensity\t0.008 {mass} / {length}^3\nMass\t{} {mass}\n\
         Volume\t{} {length}^3\nPhysical Material\tSteel\n\nBounding Box\n\tLength \t 43.39 {length}\n\
         World X,Y,Z\t0 {length}, 0 {length}, 0 {length}\nCenter of Mass\t{x} {length}, {y} {length}, {z} {length}\n\n",
        print.mass(body),
        (body.mass() / print.units[0] / 0.008).round()
    );
    let tensors = [
        ("Center of Mass", body.inertia().matrix()),
        ("Origin", body.inertia_about(Position::ZERO).matrix()),
    ];
    for (point, rows) in tensors {
        writeln!(text, "Moment of Inertia at {point}   ({mass} {length}^2)").unwrap();
        for (i, row) in print.tensor(rows).iter().enumerate() {
            for (j, element) in row.iter().enumerate() {
                writeln!(text, "\tI{}{} = {element}", LETTERS[i], LETTERS[j]).unwrap();
            }
        }
        text.push('\n');
    }
    text
}

pub(crate) fn creo(body: &MassProperties<Body>, print: Print) -> String {
    let [mass, length] = print.words;
    let [x, y, z] = print.center(body);
    let mut text = format!(
        "VOLUME =  {:.7e}  {length}^3\nSURFACE AREA =  1.2345678e+04  {length}^2\n\
         DENSITY =  7.8270820e-06 {mass} / {length}^3\nMASS =  {} {mass}\n\n\
         CENTER OF GRAVITY with respect to _PRT0001 coordinate frame:\nX   Y   Z    {x} {y} {z} {length}\n\n",
        body.mass() / print.units[0] / 7.827_082e-6,
        print.mass(body)
    );
    let tensors = [
        ("", body.inertia_about(Position::ZERO).matrix()),
        ("at CENTER OF GRAVITY ", body.inertia().matrix()),
    ];
    for (point, rows) in tensors {
        writeln!(
            text,
            "INERTIA {point}with respect to _PRT0001 coordinate frame:  ({mass} * {length}^2)\n\nINERTIA TENSOR:"
        )
        .unwrap();
        for (i, row) in print.tensor(rows).iter().enumerate() {
            let names: Vec<String> = LETTERS.iter().map(|j| format!("I{}{j}", LETTERS[i])).collect();
            writeln!(text, "{}  {}", names.join(" "), row.join(" ")).unwrap();
        }
        text.push('\n');
    }
    text + "ROTATION ANGLES from _PRT0001 orientation to PRINCIPAL AXES (degrees):\nangles about x  y  z   1 2 3\n\n\
            RADII OF GYRATION with respect to PRINCIPAL AXES:\nR1  R2  R3   1.1e+01 1.2e+01 1.3e+01 MM\n"
}

pub(crate) fn onshape(body: &MassProperties<Body>, print: Print) -> String {
    let [mass, length] = print.words;
    let [x, y, z] = print.center(body);
    let mut text = format!(
        "Mass properties\nMass: {} {mass}\nCenter of mass\nX: {x} {length}\nY: {y} {length}\nZ: {z} {length}\n\
         Moments of inertia ({mass} {length}\u{b2})\n",
        print.mass(body)
    );
    for (i, row) in print.tensor(body.inertia().matrix()).iter().enumerate() {
        for (j, element) in row.iter().enumerate() {
            writeln!(text, "L{}{}\n{element}", LETTERS[i], LETTERS[j]).unwrap();
        }
    }
    let unit = print.units[0] * print.units[1].powi(2);
    let moments = body.principal().moments().map(|i| (print.number)(i / unit));
    write!(
        text,
        "Principal moments of inertia ({mass} {length}\u{b2})\nPx {} Py {} Pz {}\n",
        moments[2], moments[0], moments[1]
    )
    .unwrap();
    text
}

/// Returns axes and moments in SolidWorks' format, axes with three digits.
pub(crate) fn principal(body: &MassProperties<Body>, print: Print) -> String {
    let [mass, length] = print.words;
    let principal = body.principal();
    let mut text = format!(
        "Principal axes of inertia and principal moments of inertia: ( {mass} *  square {length} )\n\
         Taken at the center of mass.\n"
    );
    for (k, letter) in LETTERS.iter().enumerate() {
        let [a, b, c] = principal.axis(k).to_array();
        let moment = (print.number)(principal.moments()[k] / (print.units[0] * print.units[1].powi(2)));
        writeln!(text, "\t I{letter} = ({a:.3}, {b:.3}, {c:.3})   \tP{letter} = {moment}").unwrap();
    }
    text
}

pub(crate) fn two_decimals(value: f64) -> String {
    format!("{value:.2}")
}

/// Formats a number as Fusion does: three decimals without trailing zeros, and an exponent from
/// 1e5.
pub(crate) fn fusion_number(value: f64) -> String {
    if value.abs() < 1e5 {
        let fixed = format!("{value:.3}");
        return fixed.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    creo_number(value, 3)
}

pub(crate) fn creo_number(value: f64, digits: usize) -> String {
    let short = format!("{value:.digits$e}");
    let (mantissa, power) = short.split_once('e').unwrap();
    format!("{mantissa}E{:+03}", power.parse::<i32>().unwrap())
}

/// Formats a number in the German style: 1.234.567,89
pub(crate) fn german(value: f64) -> String {
    let fixed = format!("{:.2}", value.abs());
    let (whole, fraction) = fixed.split_once('.').unwrap();
    let mut groups: Vec<&str> = Vec::new();
    let mut rest = whole;
    while rest.len() > 3 {
        let (head, tail) = rest.split_at(rest.len() - 3);
        groups.insert(0, tail);
        rest = head;
    }
    groups.insert(0, rest);
    format!("{}{},{fraction}", if value < 0.0 { "-" } else { "" }, groups.join("."))
}

pub(crate) fn eight_decimals_comma(value: f64) -> String {
    format!("{value:.8}").replace('.', ",")
}
