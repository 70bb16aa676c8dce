//! Reader for FreeCAD's console and the output of its macros.

use std::ops::Range;

use polhode_source::unit;
use polhode_source::unit::Dimension;
use polhode_source::{ContentError, ContentErrorKind};

use super::super::units;
use super::{Measures, Number, Once, bad, exactly, shortest};

const HINT: &str =
    "paste the output of the FreeCAD console for Shape.Volume, Shape.CenterOfMass and Shape.MatrixOfInertia";

/// FreeCAD's internal unit, the millimetre, independent of the display unit, m.
const MILLIMETRE: f64 = 1e-3;

/// Returns true if a text has a matrix of inertia in FreeCAD's format.
pub(crate) fn is_of(text: &str) -> bool {
    text.contains("Matrix (") && text.lines().any(|line| label(line) == Some(Label::Inertia))
}

/// Quantity named in a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Label {
    Volume,
    Area,
    Mass,
    Center,
    Inertia,
}

/// Returns the quantity that a line names: `>>> obj.Shape.CenterOfMass`, `Center of mass:`.
fn label(line: &str) -> Option<Label> {
    let squeezed: String =
        line.chars().filter(|c| !c.is_whitespace() && *c != '_').flat_map(char::to_lowercase).collect();
    let has = |words: &[&str]| words.iter().any(|word| squeezed.contains(word));
    if has(&["matrixofinertia", "inertiamatrix", "inertiatensor"]) {
        Some(Label::Inertia)
    } else if has(&["centerofmass", "centreofmass", "centerofgravity", "centreofgravity"]) {
        Some(Label::Center)
    } else if has(&["volume"]) {
        Some(Label::Volume)
    } else if has(&["area"]) {
        Some(Label::Area)
    } else if has(&["mass"]) {
        Some(Label::Mass)
    } else {
        None
    }
}

#[derive(Default)]
struct Found {
    volume: Once<Number>,
    area: Once<Number>,
    mass: Once<Number>,
    center: Once<[Number; 3]>,
    tensor: Once<[Number; 9]>,
}

pub(crate) fn read(text: &str) -> Result<Measures, ContentError> {
    let mut found = Found::default();
    let (mut waiting, mut start) = (None, 0);
    while start < text.len() {
        let line = text[start..].split_inclusive('\n').next().unwrap_or_default();
        let end = start + line.len();
        let prompt = line.trim_start().starts_with(">>>") || line.trim_start().starts_with("... ");
        if prompt {
            // A command; its result is on the next line.
            (waiting, start) = (label(line), end);
            continue;
        }
        let named = label(line);
        let value = match named {
            Some(_) => line.find([':', '=']).map(|at| start + at + 1),
            None => Some(start),
        };
        let target = named.or(waiting);
        (waiting, start) = match (target, value) {
            (Some(target), Some(from)) if !text[from..end].trim().is_empty() => {
                (None, found.value(text, target, from, end)?)
            }
            _ => (target, end),
        };
    }
    found.measures(text)
}

impl Found {
    /// Reads the value of a quantity from byte `from` on; returns the start of the next line.
    fn value(&mut self, text: &str, target: Label, from: usize, end: usize) -> Result<usize, ContentError> {
        match target {
            Label::Volume => {
                self.volume.put("the volume", quantity(text, from..end, "the volume", 3)?, from..end)?;
            }
            Label::Area => {
                self.area.put("the area", quantity(text, from..end, "the area", 2)?, from..end)?;
            }
            Label::Mass => {
                let [mass] = exactly("the mass", text, from..end, &[])?;
                self.mass.put("the mass", mass, from..end)?;
            }
            Label::Center => {
                let part = inside(text, "Vector", from..end)?;
                self.center.put(
                    "the centre of mass",
                    exactly("the centre of mass", text, part, &[','])?,
                    from..end,
                )?;
            }
            Label::Inertia => {
                let part = inside(text, "Matrix", from..text.len())?;
                let next = text[part.end..].find('\n').map_or(text.len(), |at| part.end + at + 1);
                let all: [Number; 16] = exactly(
                    "the matrix of inertia, four rows of four,",
                    text,
                    part.clone(),
                    &[',', '(', ')'],
                )?;
                let all = shortest(text, all);
                self.tensor.put("the matrix of inertia", upper(text, &all)?, part)?;
                return Ok(next);
            }
        }
        Ok(end)
    }

    fn measures(self, text: &str) -> Result<Measures, ContentError> {
        let volume = self.volume.require("volume", HINT)?;
        // Shape.Mass is the volume at density 1. With any other mass, the matrix does not belong to
        // it.
        if let Some(mass) = self.mass.0
            && (mass.value - volume.value).abs() > 1e-6 * volume.value.abs()
        {
            let rule = "equal to the volume: FreeCAD's matrix of inertia is for density 1".to_owned();
            let error = bad("the mass", text[mass.span.clone()].to_owned(), rule, mass.span);
            return Err(error.hint("delete the line, and give --mass or --density"));
        }
        Ok(Measures {
            volume,
            surface_area: self.area.0,
            center: self.center.require("centre of mass", HINT)?,
            tensor: self.tensor.require("matrix of inertia", HINT)?,
            moments: None,
            unit: Some(MILLIMETRE),
        })
    }
}

/// Returns the upper 3×3 block of a 4×4 matrix; the rest must be that of the identity.
fn upper(text: &str, all: &[Number; 16]) -> Result<[Number; 9], ContentError> {
    for (k, number) in all.iter().enumerate().filter(|(k, _)| k % 4 == 3 || k / 4 == 3) {
        let unit = if k == 15 { 1.0 } else { 0.0 };
        if number.value != unit {
            let rule =
                format!("{unit}: the fourth row and column of a matrix of inertia are those of the identity");
            let value = text[number.span.clone()].to_owned();
            return Err(bad("the element of the matrix", value, rule, number.span.clone()));
        }
    }
    let at = |k: usize| all[4 * (k / 3) + k % 3].clone();
    Ok([0, 1, 2, 3, 4, 5, 6, 7, 8].map(at))
}

/// Returns the span in brackets after a name: `Vector (1, 2, 3)`.
fn inside(text: &str, name: &str, part: Range<usize>) -> Result<Range<usize>, ContentError> {
    let expected = || {
        let found = text[part.clone()].lines().next().unwrap_or_default().trim().to_owned();
        ContentErrorKind::expected(format!("{name} (…)"), found).at(part.clone()).hint(HINT)
    };
    let line = &text[part.clone()];
    let trimmed = line.trim_start();
    let rest = trimmed.strip_prefix(name).unwrap_or(trimmed).trim_start();
    let open = part.end - rest.len();
    let mut depth = 0_usize;
    for (at, c) in rest.char_indices() {
        match c {
            '(' => depth += 1,
            ')' if depth == 1 => return Ok(open + 1..open + at),
            ')' => depth = depth.saturating_sub(1),
            _ if depth == 0 => break,
            _ => {}
        }
    }
    Err(expected())
}

/// Parses a number in mm to a power, or with its own unit.
fn quantity(text: &str, part: Range<usize>, what: &str, power: i32) -> Result<Number, ContentError> {
    let words = text[part.clone()].trim();
    let start = part.start + text[part.clone()].find(words).unwrap_or(0);
    let split = words.find(char::is_whitespace).unwrap_or(words.len());
    let [mut number] = exactly::<1>(what, text, start..start + split, &[])?;
    let phrase = words[split..].trim();
    if phrase.is_empty() {
        let [number] = shortest(text, [number]);
        return Ok(number);
    }
    let dimension = Dimension::new(0, i8::try_from(power).unwrap_or(0), 0, 0);
    let factor = units::read(phrase, dimension).and_then(|unit| unit::factor(&unit, dimension).ok());
    let factor = factor.ok_or_else(|| {
        ContentErrorKind::expected(format!("a unit of {what}"), phrase).at(start + split..part.end)
    })?;
    let in_mm = factor / MILLIMETRE.powi(power);
    number.value *= in_mm;
    number.half *= in_mm;
    Ok(number)
}
