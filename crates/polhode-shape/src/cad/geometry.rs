//! Geometric properties of a shape without mass, as printed by MeshLab and FreeCAD: volume, centre,
//! and the tensor at density 1.
//!
//! MeshLab's filter "Compute Geometric Measures" logs, in the unit of the mesh's coordinates,
//!
//! ```text
//! Mesh Surface Area is 98.211000
//! Mesh Volume is 36.789902
//! Center of Mass is 0.012000 -0.000300 0.941000
//! Inertia Tensor is :
//! | 68.811394  0.000714  0.918281 |
//! ```
//!
//! The tensor is about the centre of mass, with products −∫xy dV. Source: `InertiaTensor` in
//! vcg/complex/algorithms/inertia.h of VCGLib, after Mirtich, J. Graphics Tools 1 (1996) 31.
//!
//! FreeCAD's console prints `Shape.Volume`, `Shape.CenterOfMass` and `Shape.MatrixOfInertia`, in
//! mm, as `1000.0`, `Vector (1.0, 2.0, 3.0)` and `Matrix ((…),(…),(…),(0,0,0,1))`. The matrix is
//! about the centre of mass, in the axes of the document, with products −∫xy dV. Source:
//! `MatrixOfInertia` of `GProp_GProps` in Open CASCADE.

mod freecad;
mod meshlab;

use std::f64::consts::PI;
use std::ops::Range;

use polhode::body::shape::Substance;
use polhode::body::{BodyError, Finding, InertiaTensor, MassProperties};
use polhode::math::{Body, Position};
use polhode_source::{ContentError, ContentErrorKind, told_unit};

use super::numbers;
use crate::finding::{info, warning};

/// Program that prints the geometric properties of a shape without mass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum GeometryProgram {
    /// MeshLab (Visual Computing Lab).
    MeshLab,
    FreeCad,
}

impl GeometryProgram {
    /// Returns the program that printed the text; `None` for reports with a mass.
    pub fn of_text(text: &str) -> Option<Self> {
        if meshlab::is_of(text) {
            Some(Self::MeshLab)
        } else if freecad::is_of(text) {
            Some(Self::FreeCad)
        } else {
            None
        }
    }

    /// Returns the name: `MeshLab` or `FreeCAD`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::MeshLab => "MeshLab",
            Self::FreeCad => "FreeCAD",
        }
    }
}

/// Geometric properties of a shape, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct GeometryReport {
    /// Program that printed them.
    pub program: GeometryProgram,
    /// Volume, m³.
    pub volume: f64,
    /// Surface area, m².
    pub surface_area: Option<f64>,
    /// Unit of length, m.
    pub unit: f64,
    /// True if neither the text nor the caller states the unit, so that the metre is assumed.
    pub unit_assumed: bool,
    /// Notes and warnings about rounding, or a mesh that is wound inward.
    pub findings: Vec<Finding>,
    center: Position<Body>,
    /// Tensor about the centre of mass at density 1, m⁵: xx, yy, zz, and the products −∫xy dV, −∫xz
    /// dV, −∫yz dV.
    tensor: [f64; 6],
}

/// Geometric properties in a text, in its own unit of length.
struct Measures {
    volume: Number,
    surface_area: Option<Number>,
    center: [Number; 3],
    /// Tensor, row by row.
    tensor: [Number; 9],
    /// Principal moments, if the text has them.
    moments: Option<[Number; 3]>,
    /// Unit of length, m, if the program always uses the same one.
    unit: Option<f64>,
}

/// Printed number with its rounding bound and its position.
#[derive(Clone, Debug, Default)]
struct Number {
    value: f64,
    half: f64,
    span: Range<usize>,
}

/// Relative rounding of the tensor above which it is reported.
const ROUGH: f64 = 1e-3;

/// Relative rounding of a moment above which it has no certain digit.
const LOST: f64 = 0.4;

/// Relative accuracy of single precision with a margin; MeshLab computes in single precision.
const SINGLE: f64 = 1e-5;

impl GeometryReport {
    /// Reads the output of a program. `unit` is the unit of length of a mesh, m; the default is the
    /// metre.
    ///
    /// ```
    /// use polhode::body::shape::Substance;
    /// use polhode_shape::cad::{GeometryProgram, GeometryReport};
    /// let text = "Volume = 6000.0\nCenterOfMass = Vector (5.0, 10.0, 15.0)\nMatrixOfInertia = Matrix ((650000.0,0.0,0.0,0.0),\
    ///             (0.0,500000.0,0.0,0.0),(0.0,0.0,250000.0,0.0),(0.0,0.0,0.0,1.0))";
    /// let brick = GeometryReport::read(GeometryProgram::FreeCad, text, None)?;
    /// let body = brick.mass_properties(Substance::Mass(0.6)).unwrap(); // kg
    /// // m (b² + c²)/12 of edges 20 mm and 30 mm
    /// assert!((body.inertia().matrix()[0][0] - 0.6 * 1300e-6 / 12.0).abs() < 1e-19);
    /// # Ok::<(), polhode_source::ContentError>(())
    /// ```
    ///
    /// # Errors
    /// [`ContentError`] if a quantity is missing, repeated, not a number, or contradicts another
    /// one, or if the tensor has no significant digits.
    pub fn read(program: GeometryProgram, text: &str, unit: Option<f64>) -> Result<Self, ContentError> {
        told_unit("the unit of length", unit)?;
        let measures = match program {
            GeometryProgram::MeshLab => meshlab::read(text)?,
            GeometryProgram::FreeCad => freecad::read(text)?,
        };
        let mut findings = Vec::new();
        let sign = inward(&measures, &mut findings)?;
        symmetric(text, &measures)?;
        traced(text, &measures)?;
        compact(text, &measures)?;
        rounded(text, program, &measures, &mut findings)?;
        let length = measures.unit.or(unit).unwrap_or(1.0);
        let scaled = |number: &Number, power: i32| sign * number.value * length.powi(power);
        let [xx, xy, xz, _, yy, yz, _, _, zz] = measures.tensor.each_ref().map(|number| scaled(number, 5));
        Ok(Self {
            program,
            volume: scaled(&measures.volume, 3),
            surface_area: measures.surface_area.map(|area| area.value * length * length),
            unit: length,
            unit_assumed: measures.unit.is_none() && unit.is_none(),
            findings,
            center: Position::from_array(measures.center.map(|number| number.value * length)),
            tensor: [xx, yy, zz, xy, xz, yz],
        })
    }

    /// Returns the mass properties for a substance: I = (M/V) I₁ with the tensor I₁ at density 1.
    ///
    /// # Errors
    /// [`BodyError`] if the substance is not that of a solid, or if the printed tensor is
    /// unphysical.
    pub fn mass_properties(&self, substance: Substance) -> Result<MassProperties<Body>, BodyError> {
        let (mass, density) = match substance {
            Substance::Mass(mass) => (mass, mass / self.volume),
            Substance::Density(density) => (density * self.volume, density),
            Substance::AreaDensity(value) | Substance::LineDensity(value) => {
                let rule = "in kg/m³, since the shape is solid";
                return Err(BodyError::Parameter { what: "the density", value, rule });
            }
        };
        let [xx, yy, zz, xy, xz, yz] = self.tensor.map(|element| density * element);
        let tensor = InertiaTensor::with_negative_products([xx, yy, zz], [xy, xz, yz])?;
        MassProperties::new(mass, self.center, tensor)
    }
}

/// Returns the sign of the volume and of the tensor: −1 for a mesh that is wound inward as a whole.
fn inward(measures: &Measures, findings: &mut Vec<Finding>) -> Result<f64, ContentError> {
    let Number { value, span, .. } = &measures.volume;
    if *value > 0.0 {
        return Ok(1.0);
    }
    if *value == 0.0 {
        let rule = "not zero: the shape is not a solid, or too small for the printed digits".to_owned();
        return Err(bad("the volume", value.to_string(), rule, span.clone()));
    }
    let message = "the volume is negative: the whole mesh is wound inward, and was reversed";
    findings.push(info("cad.inward", message));
    Ok(-1.0)
}

/// Refuses a tensor that is not symmetric.
fn symmetric(text: &str, measures: &Measures) -> Result<(), ContentError> {
    let tensor = &measures.tensor;
    let size = [0, 4, 8].map(|k| tensor[k].value.abs()).into_iter().fold(0.0, f64::max);
    for (above, below) in [(1, 3), (2, 6), (5, 7)] {
        let [a, b] = [&tensor[above], &tensor[below]];
        if (a.value - b.value).abs() > 2.0 * (a.half + b.half) + SINGLE * size {
            let rule = format!("equal to its opposite, {}", &text[a.span.clone()]);
            let value = text[b.span.clone()].to_owned();
            return Err(bad("the element of the inertia tensor", value, rule, b.span.clone()));
        }
    }
    Ok(())
}

/// Refuses principal moments whose sum is not the trace: they belong to another shape.
fn traced(text: &str, measures: &Measures) -> Result<(), ContentError> {
    let Some(moments) = &measures.moments else { return Ok(()) };
    let diagonal = [0, 4, 8].map(|k| &measures.tensor[k]);
    let sum = |numbers: [&Number; 3]| numbers.into_iter().map(|number| number.value).sum::<f64>();
    let halves: f64 = moments.iter().chain(diagonal).map(|number| number.half).sum();
    let (moments_sum, trace) = (sum(moments.each_ref()), sum(diagonal));
    if (moments_sum - trace).abs() <= 2.0 * halves + SINGLE * trace.abs() {
        return Ok(());
    }
    let span = moments[0].span.start..moments[2].span.end;
    let rule = format!("with the sum {trace} of the diagonal of the inertia tensor");
    Err(bad("the principal moments", text[span.clone()].to_owned(), rule, span))
}

/// Refuses a volume that is too large for the tensor.
///
/// The ball of radius R = (3V/4π)^⅓ has the smallest ∫r² dV about the centre of mass of all bodies
/// of volume V: ⅗ V R². Each piece of another body outside the ball is farther from the centre
/// than the missing piece inside. Since tr I = 2 ∫r² dV at density 1,
///
/// ½ tr I ≥ ⅗ (3/4π)^⅔ V^(5/3)
///
/// Source: Lieb & Loss, Analysis, 2nd ed. (2001), theorem 1.14, the bathtub principle.
fn compact(text: &str, measures: &Measures) -> Result<(), ContentError> {
    let factor = 0.6 * (0.75 / PI).cbrt().powi(2);
    let volume = &measures.volume;
    let diagonal = [0, 4, 8].map(|k| &measures.tensor[k]);
    let sum = |of: fn(&Number) -> f64| diagonal.into_iter().map(of).sum::<f64>();
    let half_trace = 0.5 * sum(|number| number.value).abs();
    let smallest = (volume.value.abs() - volume.half).max(0.0);
    let least = factor * smallest.cbrt().powi(5);
    if half_trace + 0.5 * sum(|number| number.half) >= least * (1.0 - SINGLE) {
        return Ok(());
    }
    let most = (half_trace / factor).powf(0.6);
    let rule = format!(
        "at most {}: for a given volume the ball has the smallest moments, and those of this tensor are smaller",
        super::six(most)
    );
    let error = bad("the volume", text[volume.span.clone()].to_owned(), rule, volume.span.clone());
    Err(error.hint("paste the volume and the tensor of one shape, in one unit"))
}

/// Reports the rounding error of the tensor; refuses one without significant digits.
fn rounded(
    text: &str,
    program: GeometryProgram,
    measures: &Measures,
    findings: &mut Vec<Finding>,
) -> Result<(), ContentError> {
    let relative = |number: &Number| number.half / number.value.abs().max(f64::MIN_POSITIVE);
    let moments = [0, 4, 8].map(|k| &measures.tensor[k]);
    let remedy = format!("scale the shape up in {}, for example to mm, and print again", program.name());
    if let Some(lost) = moments.into_iter().chain([&measures.volume]).find(|number| relative(number) > LOST) {
        let what = if lost.span == measures.volume.span { "the volume" } else { "the moment of inertia" };
        let rule = "printed with more digits: rounding removes all of them".to_owned();
        let error = bad(what, text[lost.span.clone()].to_owned(), rule, lost.span.clone());
        return Err(error.hint(remedy));
    }
    let rounding = moments.into_iter().map(relative).fold(0.0, f64::max) + relative(&measures.volume);
    if rounding > ROUGH {
        let message = format!(
            "the printed digits determine the moments of inertia only to {:.2} %: {remedy}",
            100.0 * rounding
        );
        findings.push(warning("cad.rounding", message));
    }
    Ok(())
}

/// Slot for a quantity that may occur only once.
#[derive(Default)]
struct Once<T>(Option<T>);

impl<T> Once<T> {
    /// Stores the value; an error if there is one already.
    fn put(&mut self, what: &str, value: T, place: Range<usize>) -> Result<(), ContentError> {
        if self.0.is_some() {
            let rule = "given once: the text contains the measures of more than one shape".to_owned();
            return Err(bad(what, "two values".to_owned(), rule, place).hint("paste one shape at a time"));
        }
        self.0 = Some(value);
        Ok(())
    }

    /// Returns the value, or an error if it is missing.
    fn require(self, what: &str, hint: &str) -> Result<T, ContentError> {
        self.0.ok_or_else(|| ContentErrorKind::missing(what).of_whole().hint(hint))
    }
}

/// Parses exactly `N` numbers in a part of a text, with these characters as separators.
fn exactly<const N: usize>(
    what: &str,
    text: &str,
    part: Range<usize>,
    between: &[char],
) -> Result<[Number; N], ContentError> {
    let expected = |found: &str, span: Range<usize>| {
        let what = format!("{N} {} for {what}", if N == 1 { "number" } else { "numbers" });
        ContentErrorKind::expected(what, found.trim().to_owned()).at(span)
    };
    let is_between = |c: char| c.is_whitespace() || between.contains(&c);
    let mut all = Vec::with_capacity(N);
    let mut at = part.start;
    for word in text[part.clone()].split(is_between) {
        let span = at..at + word.len();
        at = span.end + text[span.end..].chars().next().map_or(0, char::len_utf8);
        if word.is_empty() {
            continue;
        }
        let plain = numbers::read(text, &span, super::DecimalMark::Point).ok();
        let number = plain.and_then(|plain| {
            let value: f64 = plain.digits.parse().ok()?;
            let half = plain.half.max(f64::EPSILON * value.abs());
            value.is_finite().then_some(Number { value, half, span: span.clone() })
        });
        all.push(number.ok_or_else(|| expected(word, span))?);
    }
    all.try_into().map_err(|_| expected(&text[part.clone()], part))
}

/// Sets the rounding of numbers printed by Python, which are the shortest decimals of doubles. They
/// all have a point or an exponent, such as 1.0. C++ streams write 1 and round to six digits.
fn shortest<const N: usize>(text: &str, numbers: [Number; N]) -> [Number; N] {
    let is_shortest = |number: &Number| text[number.span.clone()].contains(['.', 'e', 'E']);
    if !numbers.iter().all(is_shortest) {
        return numbers;
    }
    numbers.map(|number| Number { half: f64::EPSILON * number.value.abs(), ..number })
}

fn bad(what: &str, value: String, rule: String, span: Range<usize>) -> ContentError {
    ContentErrorKind::value(what, value, rule).at(span)
}
