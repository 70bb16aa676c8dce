//! Mass-property reports of CAD programs, pasted as text: SolidWorks, Fusion, Creo, Onshape, and
//! others with similar labels. [`GeometryReport`] reads the geometric properties printed by MeshLab
//! and FreeCAD, which have no mass. Labels must be in English; numbers and units may have the
//! format of any country. Headings in other languages are detected and refused by name.
//!
//! Three things are read or proved, and never guessed:
//!
//! - units, from the unit names in the report;
//! - the decimal mark, from numbers with only one interpretation;
//! - the sign of the products of inertia, from the parallel-axis theorem or the principal axes
//!   ([`SignProof`]).
//!
//! Ambiguities lead to an error with a question, which [`CadOptions`] can answer.

mod geometry;
mod language;
mod numbers;
mod proof;
mod scan;
mod units;

use std::ops::Range;

use polhode::body::{BodyError, Finding, InertiaAbout, InertiaTensor, MassProperties};
use polhode::math::{Body, Position};
use polhode_source::unit;
use polhode_source::unit::{Dimension, UnitError};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace, told_unit};
use serde::{Deserialize, Serialize};

use proof::{Evidence, PLACES, Printed, Tensor};
use scan::{CENTRAL, Group, ORIGIN, SCALARS, Scan};

use crate::finding::{info, warning};

pub use geometry::{GeometryProgram, GeometryReport};
pub use proof::{SignProof, SignSource};

/// Values that a report may leave ambiguous; unset by default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CadOptions {
    /// Decimal mark, if the numbers are ambiguous.
    pub decimal: Option<DecimalMark>,
    /// Sign convention of the products of inertia, if it cannot be proved.
    pub products: Option<ProductConvention>,
    /// Unit of mass if the report names none, kg.
    pub mass_unit: Option<f64>,
    /// Unit of length if the report names none, m.
    pub length_unit: Option<f64>,
}

/// Decimal mark of printed numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum DecimalMark {
    /// Decimal point: 1.5
    Point,
    /// Decimal comma: 1,5
    Comma,
}

impl DecimalMark {
    /// Returns `point` or `comma`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Point => "point",
            Self::Comma => "comma",
        }
    }

    const fn character(self) -> char {
        match self {
            Self::Point => '.',
            Self::Comma => ',',
        }
    }
}

/// Sign convention of the products of inertia.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum ProductConvention {
    /// Negative integrals -∫xy dm, the elements of the tensor.
    Negative,
    /// Positive integrals +∫xy dm.
    Positive,
}

impl ProductConvention {
    /// Returns `negative` or `positive`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Negative => "negative",
            Self::Positive => "positive",
        }
    }
}

/// Program that wrote a report, detected by its headings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CadProduct {
    /// SolidWorks (Dassault Systèmes).
    SolidWorks,
    /// Fusion (Autodesk).
    Fusion,
    /// Creo Parametric (PTC).
    Creo,
    /// Onshape (PTC).
    Onshape,
    /// Unknown program: none of these headings.
    Unknown,
}

impl CadProduct {
    /// Returns the name: `SolidWorks`, `Fusion`, `Creo`, `Onshape` or `an unknown program`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::SolidWorks => "SolidWorks",
            Self::Fusion => "Fusion",
            Self::Creo => "Creo",
            Self::Onshape => "Onshape",
            Self::Unknown => "an unknown program",
        }
    }
}

/// Contents of a CAD report.
#[derive(Clone, Debug, PartialEq)]
pub struct CadReport {
    /// Program that wrote the report.
    pub product: CadProduct,
    /// Mass properties in SI units, in the report's coordinate system.
    pub properties: MassProperties<Body>,
    /// Volume, m³.
    pub volume: Option<f64>,
    /// Surface area, m².
    pub surface_area: Option<f64>,
    /// Density, kg/m³; also `None` if the report rounds it to zero.
    pub density: Option<f64>,
    /// Proof of the sign of the products.
    pub proof: SignProof,
    /// Findings of the reader.
    pub findings: Vec<Finding>,
}

/// Reads a report.
///
/// Values are the doubles nearest to the printed numbers, in SI units. The result is as accurate as
/// the digits of the report. Several tensors are used for the proof; the result uses the one about
/// the centre of mass.
///
/// ```
/// use polhode_shape::cad::{self, CadOptions, ProductConvention, SignSource};
/// let report = "
/// Mass = 2.50 kilograms
/// Center of mass: ( meters )
///     X = 1.00  Y = -2.00  Z = 0.50
/// Moments of inertia: ( kilograms * square meters )
/// Taken at the center of mass and aligned with the output coordinate system.
///     Lxx = 10.00  Lxy = 1.00   Lxz = -0.50
///     Lyx = 1.00   Lyy = 8.00   Lyz = 0.75
///     Lzx = -0.50  Lzy = 0.75   Lzz = 5.00
/// Moments of inertia: ( kilograms * square meters )
/// Taken at the output coordinate system.
///     Ixx = 20.63  Ixy = -4.00  Ixz = 0.75
///     Iyx = -4.00  Iyy = 11.13  Iyz = -1.75
///     Izx = 0.75   Izy = -1.75  Izz = 17.50
/// ";
/// let report = cad::read(report, &CadOptions::default())?;
/// // -4 = 1 + 2.5 × 1 × (-2): these products are +∫xy dm
/// assert_eq!(report.proof.by, SignSource::ParallelAxis);
/// assert_eq!(report.proof.convention, ProductConvention::Positive);
/// assert!(report.proof.residual_positive < 1.0 && report.proof.residual_negative > 50.0);
/// assert_eq!(report.properties.inertia().matrix()[0][1], -1.0); // the tensor has minus the integral
/// # Ok::<(), polhode_source::ContentError>(())
/// ```
///
/// # Errors
/// [`ContentError`] if a quantity is missing, repeated or not a number; with a question if a unit,
/// the decimal mark or the sign is ambiguous; with both residuals if the report contradicts itself.
pub fn read(text: &str, options: &CadOptions) -> Result<CadReport, ContentError> {
    told_unit("the unit of mass", options.mass_unit)?;
    told_unit("the unit of length", options.length_unit)?;
    let scan = scan::scan(text)?;
    let mut numbers: Vec<_> = spans(&scan).collect();
    numbers.sort_by_key(|span| span.start);
    let mark = numbers::decimal_mark(text, &numbers, options.decimal)?;
    let reader = Reader { text, mark, options };

    let (_, mass_name, mass_dimension) = SCALARS[0];
    if let Some(program) = GeometryProgram::of_text(text)
        && !scan.scalars[0].is_some()
    {
        return Err(without_mass(program));
    }
    let untold = |error: ContentError| in_its_language(text, error);
    let [mass] = reader.whole(&scan.scalars[0], mass_dimension, |_| mass_name.to_owned()).map_err(untold)?;
    let central = reader.tensor(&scan.tensors[CENTRAL], CENTRAL).map_err(untold)?;
    let origin = reader.tensor(&scan.tensors[ORIGIN], ORIGIN).map_err(untold)?;
    if central.is_none() && origin.is_none() {
        let error = ContentErrorKind::missing("moments of inertia").of_whole();
        return Err(untold(
            error.hint("paste the whole report, from the mass to the last moment of inertia"),
        ));
    }
    // The tensor about the centre of mass does not depend on its position. An example is a single
    // block of Creo.
    let nowhere = !scan.center.is_some()
        && central.is_some()
        && origin.is_none()
        && !scan.names_center
        && language::foreign(text).is_none();
    let center = match nowhere {
        true => [Printed::default(); 3],
        false => reader
            .whole(&scan.center, Dimension::LENGTH, |k| scan::center_name(k).to_owned())
            .map_err(untold)?,
    };
    let evidence = Evidence {
        mass,
        center,
        central,
        origin,
        moments: reader.if_whole(&scan.moments, Dimension::INERTIA)?,
        axes: reader.if_whole(&scan.axes, Dimension::NONE)?,
        stated: scan.stated,
        told: options.products,
    };
    let proof = proof::prove(&evidence)?;
    let properties = body(&evidence, proof.convention).map_err(impossible)?;
    let mut findings = findings(&evidence, &proof);
    if nowhere {
        let message = "the report has no centre of mass: it is taken as the origin; only the tensor about the centre of mass is known";
        findings.push(warning("cad.no-center", message.to_owned()));
    }
    let mut scalar = |k: usize| -> Result<Option<Printed>, ContentError> {
        let (group, (_, name, dimension)) = (&scan.scalars[k], SCALARS[k]);
        let value: Option<[Printed; 1]> = reader.if_whole(group, dimension)?;
        if group.is_some() && value.is_none() {
            let message = format!("{name} has no unit and was ignored");
            findings.push(info("cad.no-unit", message));
        }
        Ok(value.map(|[p]| p).filter(|p| p.value > 0.0))
    };
    let [volume, surface_area, density] = [scalar(1)?, scalar(2)?, scalar(3)?];
    if let (Some(volume), Some(density)) = (volume, density)
        && let Some(product) = other_mass(mass, volume, density)
    {
        // SolidWorks marks values that the user has overridden.
        if text.to_lowercase().contains("overrid") {
            let message = format!(
                "the mass is overridden: density × volume, {} kg/m³ × {} m³, is {} kg",
                six(density.value),
                six(volume.value),
                six(product)
            );
            findings.push(warning("cad.overridden", message));
        } else {
            return Err(contradictory(text, &scan.scalars[0], [density, volume].map(|p| p.value), product));
        }
    }
    Ok(CadReport {
        product: scan.product,
        properties,
        volume: volume.map(|p| p.value),
        surface_area: surface_area.map(|p| p.value),
        density: density.map(|p| p.value),
        findings,
        proof,
    })
}

/// Returns density times volume if it differs from the mass: m = ρ V must hold within twice the
/// rounding of all three.
fn other_mass(mass: Printed, volume: Printed, density: Printed) -> Option<f64> {
    let product = density.value * volume.value;
    let rounding = mass.half + density.half * volume.value + volume.half * density.value;
    ((mass.value - product).abs() > 2.0 * rounding + 1e-9 * product).then_some(product)
}

fn contradictory(text: &str, mass: &Group<1>, [density, volume]: [f64; 2], product: f64) -> ContentError {
    let [found] = &mass.numbers;
    let span = found.as_ref().map_or(0..0, |found| found.span.clone());
    let kind = ContentErrorKind::value(
        "the mass",
        text[span.clone()].to_owned(),
        format!(
            "density × volume of the report: {} kg/m³ × {} m³ = {} kg",
            six(density),
            six(volume),
            six(product)
        ),
    );
    kind.at(span)
        .hint("paste the numbers of one body, with their units; delete a density or volume of another body")
}

/// Formats a number with six significant digits.
fn six(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    if (1e-4..1e7).contains(&rounded.abs()) { rounded.to_string() } else { format!("{rounded:e}") }
}

/// Returns the spans of all numbers that are used.
fn spans(scan: &Scan) -> impl Iterator<Item = std::ops::Range<usize>> {
    let nine = scan.tensors.iter().chain([&scan.axes]).flat_map(|group| &group.numbers);
    let three = [&scan.center, &scan.moments].into_iter().flat_map(|group| &group.numbers);
    let one = scan.scalars.iter().flat_map(|group| &group.numbers);
    nine.chain(three).chain(one).flatten().map(|found| found.span.clone())
}

/// Returns the mass properties, from the tensor about the centre of mass if there is one.
fn body(evidence: &Evidence, convention: ProductConvention) -> Result<MassProperties<Body>, BodyError> {
    let mass = evidence.mass.value;
    let center = Position::from_array(evidence.center.map(|p| p.value));
    let sign = if convention == ProductConvention::Positive { -1.0 } else { 1.0 };
    let Some(tensor) = evidence.central else {
        let [xx, yy, zz, xy, xz, yz] = evidence.origin.unwrap_or_default().map(|p| p.value);
        let [xy, xz, yz] = [xy, xz, yz].map(|p| sign * p);
        let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let about = InertiaAbout::from_matrix(Position::ZERO, rows)?;
        return MassProperties::from_inertia_about(mass, center, &about);
    };
    let [xx, yy, zz, products @ ..] = tensor.map(|p| p.value);
    let tensor = match convention {
        ProductConvention::Negative => InertiaTensor::with_negative_products([xx, yy, zz], products)?,
        ProductConvention::Positive => InertiaTensor::with_positive_products([xx, yy, zz], products)?,
    };
    MassProperties::new(mass, center, tensor)
}

fn impossible(error: BodyError) -> ContentError {
    let hint = match error {
        BodyError::NegativeMoment { .. }
        | BodyError::TriangleInequality { .. }
        | BodyError::ImpossibleAtCenter { .. } => Some(
            "if the body is a rod or a plate, print more digits: rounding can make its tensor impossible",
        ),
        _ => error.hint(),
    };
    let hint = hint.map(str::to_owned);
    ContentError { kind: ContentErrorKind::Body(Box::new(error)), place: ContentPlace::Whole, hint }
}

fn findings(evidence: &Evidence, proof: &SignProof) -> Vec<Finding> {
    let mut findings = Vec::new();
    if evidence.central.is_none() {
        let message =
            "the tensor was moved from the origin to the centre of mass, which loses digits".to_owned();
        findings.push(info("cad.moved", message));
    }
    if let Some(stated) = evidence.stated
        && stated != proof.convention
        && proof.by != SignSource::NoProducts
    {
        let message = format!(
            "the report states {} products of inertia, but according to {} they are {}",
            stated.name(),
            proof.by.name(),
            proof.convention.name()
        );
        findings.push(warning("cad.notation", message));
    }
    let worst = proof.residual_negative.max(proof.residual_positive);
    if worst < proof::FAILS
        && !matches!(proof.by, SignSource::Told | SignSource::Stated | SignSource::NoProducts)
    {
        let message = format!(
            "the sign of the products is close to the rounding limit: with {} products the residual is {:.1} times the rounding error, with the other \
             sign by {worst:.1}",
            proof.convention.name(),
            proof.residual_negative.min(proof.residual_positive),
        );
        findings.push(info("cad.narrow-sign", message));
    }
    // The sign was given, although neither sign fits.
    let least = proof.residual_negative.min(proof.residual_positive);
    if least > proof::FITS {
        let message = format!(
            "the report contradicts itself: with either sign the residual is at least {least:.2e} times the rounding error"
        );
        findings.push(warning("cad.contradiction", message));
    }
    findings
}

/// Parser for the numbers and units of one report.
struct Reader<'a> {
    text: &'a str,
    mark: DecimalMark,
    options: &'a CadOptions,
}

impl Reader<'_> {
    /// Returns all numbers of a required group.
    fn whole<const N: usize>(
        &self,
        group: &Group<N>,
        dimension: Dimension,
        name: impl Fn(usize) -> String,
    ) -> Result<[Printed; N], ContentError> {
        let numbers = self.group(group, dimension, &name)?;
        let mut all = [Printed::default(); N];
        for (k, (slot, number)) in all.iter_mut().zip(numbers).enumerate() {
            *slot = number.ok_or_else(|| missing(&name(k)))?;
        }
        Ok(all)
    }

    /// Returns all numbers of an optional group; `None` if one of them, or their unit, is missing.
    fn if_whole<const N: usize>(
        &self,
        group: &Group<N>,
        dimension: Dimension,
    ) -> Result<Option<[Printed; N]>, ContentError> {
        let no_unit = dimension != Dimension::NONE && group.unit.is_none() && self.told(dimension).is_none();
        if no_unit || group.numbers.iter().any(Option::is_none) {
            return Ok(None);
        }
        self.whole(group, dimension, |_| String::new()).map(Some)
    }

    /// Returns a tensor from nine or six numbers; `None` if there is none.
    fn tensor(&self, group: &Group<9>, which: usize) -> Result<Option<Tensor>, ContentError> {
        if !group.is_some() {
            return Ok(None);
        }
        let numbers = self.group(group, Dimension::INERTIA, &|k| scan::element_name(which, k))?;
        let mut tensor = Tensor::default();
        for (slot, [i, j]) in tensor.iter_mut().zip(PLACES) {
            let (above, below) = (numbers[3 * i + j], numbers[3 * j + i]);
            *slot = above.or(below).ok_or_else(|| missing(&scan::element_name(which, 3 * i + j)))?;
            let (Some(a), Some(b), Some(found)) = (above, below, &group.numbers[3 * j + i]) else { continue };
            if (a.value - b.value).abs() > 2.0 * (a.half + b.half) {
                let what = scan::element_name(which, 3 * j + i);
                let value = self.text[found.span.clone()].to_owned();
                let rule = format!("equal to {}", scan::element_name(which, 3 * i + j));
                return Err(ContentErrorKind::value(what, value, rule).at(found.span.clone()));
            }
        }
        Ok(Some(tensor))
    }

    /// Returns the numbers that are present, in SI units.
    fn group<const N: usize>(
        &self,
        group: &Group<N>,
        dimension: Dimension,
        name: &impl Fn(usize) -> String,
    ) -> Result<[Option<Printed>; N], ContentError> {
        let mut decimals = None;
        for found in group.numbers.iter().flatten() {
            let number = numbers::read(self.text, &found.span, self.mark)?;
            let fewest = [decimals, number.decimals].into_iter().flatten().filter(|d| *d > 0).min();
            decimals = fewest.or(decimals);
        }
        let mut all = [None; N];
        for (k, (slot, found)) in all.iter_mut().zip(&group.numbers).enumerate() {
            let Some(found) = found else { continue };
            let number = numbers::read(self.text, &found.span, self.mark)?;
            // Next to 1.25, a bare 3 is 3.00 without its trailing zeros.
            let half = match (number.decimals, decimals) {
                (Some(0), Some(decimals)) => 0.5 * 10f64.powi(-i32::try_from(decimals).unwrap_or(i32::MAX)),
                _ => number.half,
            };
            let place = || ContentPlace::Text(found.span.clone());
            let parse = |text: &str| {
                unit::parse(text, dimension).map_err(|error| {
                    ContentError::new(out_of_range(&name(k), &number.digits, &error), place())
                })
            };
            *slot = Some(match (found.unit.as_ref().or(group.unit.as_ref()), self.told(dimension)) {
                (Some(unit), _) => Printed {
                    value: parse(&format!("{} {unit}", number.digits))?,
                    half: half * parse(&format!("1 {unit}"))?,
                },
                (None, Some(factor)) => {
                    Printed { value: parse(&number.digits)? * factor, half: half * factor }
                }
                (None, None) => {
                    let error = unknown_unit(self.text, &name(k), dimension, &found.span);
                    return Err(error.unwrap_or_else(|| no_unit(&name(k), dimension, place())));
                }
            });
        }
        Ok(all)
    }

    /// Returns the given unit for a dimension.
    fn told(&self, dimension: Dimension) -> Option<f64> {
        let CadOptions { mass_unit, length_unit, .. } = *self.options;
        match dimension {
            Dimension::NONE => Some(1.0),
            Dimension::MASS => mass_unit,
            Dimension::LENGTH => length_unit,
            Dimension::VOLUME => length_unit.map(|l| l * l * l),
            Dimension::INERTIA => Some(mass_unit? * length_unit? * length_unit?),
            Dimension::DENSITY => Some(mass_unit? / (length_unit? * length_unit? * length_unit?)),
            _ => length_unit.map(|l| l * l), // the surface area
        }
    }
}

/// Returns the error for geometric properties, which [`GeometryReport`] reads together with a
/// substance.
fn without_mass(program: GeometryProgram) -> ContentError {
    ContentErrorKind::missing("mass").of_whole().hint(format!(
        "{} prints volume, centre and tensor for density 1: give the density, such as polhode inertia FILE --density \"2700 kg/m^3\"",
        program.name()
    ))
}

/// Replaces the error of a missing quantity if the headings are in another language.
fn in_its_language(text: &str, error: ContentError) -> ContentError {
    let foreign = language::foreign(text).filter(|_| matches!(error.kind, ContentErrorKind::Missing { .. }));
    let Some((language, heading)) = foreign else { return error };
    let what = format!("{language} headings such as {heading:?}");
    ContentErrorKind::unsupported(what).of_whole().hint(format!(
        "set the program to English, or translate the headings; polhode reads: {}",
        language::KNOWN
    ))
}

fn missing(name: &str) -> ContentError {
    ContentErrorKind::missing(name.strip_prefix("the ").unwrap_or(name).to_owned()).of_whole().hint(format!(
        "paste the whole report, from the mass to the last moment of inertia, in English; polhode reads the headings: {}",
        language::KNOWN
    ))
}

/// Returns the error for a word after a number that ends its line and is not a unit.
fn unknown_unit(text: &str, name: &str, dimension: Dimension, number: &Range<usize>) -> Option<ContentError> {
    let rest = text[number.end..].lines().next().unwrap_or_default();
    let word = rest.trim();
    if !word.starts_with(char::is_alphabetic) || word.contains(char::is_whitespace) {
        return None;
    }
    let start = number.end + (rest.len() - rest.trim_start().len());
    let (what, found) = (format!("a unit of {}", name.strip_prefix("the ").unwrap_or(name)), word);
    let place = ContentPlace::Text(start..start + word.len());
    let error = ContentError::new(ContentErrorKind::expected(what, found), place);
    Some(match dimension {
        Dimension::MASS if word.eq_ignore_ascii_case("mg") => {
            error.hint("MG may be the milligram or the megagram: write mg or t")
        }
        Dimension::MASS => error.hint("write mg, g, kg, t, lb, oz or slug"),
        _ => error,
    })
}

fn no_unit(name: &str, dimension: Dimension, place: ContentPlace) -> ContentError {
    let question = format!("in which unit is {name}?");
    let example = match dimension {
        Dimension::MASS => "paste the line with the unit, or give it by --mass-unit, such as --mass-unit g",
        Dimension::LENGTH => "paste the line with the unit, or give it by --unit, such as --unit mm",
        _ => {
            "paste the line with the unit, or give it by --unit and --mass-unit, such as --unit mm --mass-unit g"
        }
    };
    ContentError::new(ContentErrorKind::unclear(question, ""), place).hint(example)
}

fn out_of_range(what: &str, number: &str, error: &UnitError) -> ContentErrorKind {
    let value = number.to_owned();
    ContentErrorKind::value(what, value, format!("a number in range: {error}"))
}
