//! Particles, point clouds and parts with tensors, as CSV.
//!
//! The header names the columns with their units: `mass_kg,x_m,y_m,z_m`, or `mass [g]; x [mm]; y
//! [mm]; z [mm]`. Fields are separated by semicolons, tabs, commas or spaces; the first of these
//! that occurs in the first line applies. With semicolons or tabs the decimal mark may be a comma.
//! Thousands are not separated. Blank lines and text after `#` are ignored, with two exceptions: a
//! comment line directly above the numbers may be the header, as written by NumPy. A comment above
//! it may declare the sign of products.
//!
//! A line is a particle or a part. For a part, six columns `Ixx`, `Iyy`, `Izz`, `Ixy`, `Ixz`, `Iyz`
//! are its tensor about its own centre of mass (x, y, z), along the axes of the table. The sign of
//! products is not guessed. Unless all products are zero, a line above the header must declare it:
//! `# products = negative_integral` (elements of the tensor, −∫xy dm) or `# products =
//! positive_integral` (+∫xy dm).
//!
//! A line is one piece. A column `quantity` with a value other than 1 is refused, because each
//! piece needs its own position. Two parts with one name at one position are also refused. An
//! unused column is reported in a finding if it is a label, and refused if it is about mass,
//! inertia, quantity or units.
//!
//! Units are not guessed. A column without a unit, or a file without a header, needs
//! [`ParticleOptions`].

mod fields;
mod header;
mod names;
mod table;

use std::ops::Range;

use polhode::body::{
    BodyError, Finding, InertiaTensor, MassProperties, Particle, mass_properties_of_particles,
};
use polhode::math::{Body, Position};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace, told_unit};

use header::{MASS, Products, TENSOR};
use names::Names;
use table::{Row, Table};

use crate::finding::info;

/// Values that a file may omit; unset by default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ParticleOptions {
    /// Unit of mass if the header names none, kg.
    pub mass_unit: Option<f64>,
    /// Unit of length if the header names none, m.
    pub length_unit: Option<f64>,
    /// Total mass, kg, distributed equally over points without masses.
    pub total_mass: Option<f64>,
}

/// Contents of a particle file.
#[derive(Clone, Debug, PartialEq)]
pub struct ParticleFile {
    /// Particles in file order, in SI units; at least one.
    pub particles: Vec<Particle<Body>>,
    /// Tensor of each part about its own position, kg·m²; empty for points.
    pub tensors: Vec<InertiaTensor<Body>>,
    /// Findings about the contents.
    pub findings: Vec<Finding>,
}

impl ParticleFile {
    /// Returns the mass properties of all particles rigidly joined, with their own tensors if they
    /// have some.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if a sum is not finite.
    pub fn mass_properties(&self) -> Result<MassProperties<Body>, BodyError> {
        if self.tensors.is_empty() {
            return mass_properties_of_particles(&self.particles);
        }
        let parts = self.particles.iter().zip(&self.tensors);
        let parts: Result<Vec<_>, _> =
            parts.map(|(p, tensor)| MassProperties::new(p.mass(), p.position(), *tensor)).collect();
        MassProperties::combined(&parts?)
    }

    /// Returns the number and kind: `"3 particles"`, or `"3 parts"` if they have tensors.
    pub fn described(&self) -> String {
        let what = if self.tensors.is_empty() { "particles" } else { "parts with tensors" };
        format!("{} {what}", self.particles.len())
    }
}

/// Returns true if the header of a table has masses and positions, with or without their units.
pub fn is_table(bytes: &[u8]) -> bool {
    let options = ParticleOptions { mass_unit: Some(1.0), length_unit: Some(1.0), total_mass: None };
    Table::of(bytes, 0, &options).is_ok_and(|(table, _)| table.header.has(MASS))
}

/// Reads particles from the bytes of a file.
///
/// A value is the double nearest to the product of number and unit, if the unit is a power of ten.
/// For other units it is accurate to one unit in the last place.
///
/// ```
/// use polhode_shape::particles::{self, ParticleOptions};
/// let file = b"name; mass [g]; x [mm]; y [mm]; z [mm]\nA; 1,5; 10; -20,5; 3\nB; 2; 0; 4; -7\n";
/// let read = particles::read(file, &ParticleOptions::default())?;
/// assert_eq!(read.particles[0].mass(), 0.0015);
/// assert_eq!(read.particles[0].position().to_array(), [0.01, -0.0205, 0.003]);
///
/// let cloud = ParticleOptions { total_mass: Some(3.0), ..ParticleOptions::default() };
/// let read = particles::read(b"x_m,y_m,z_m\n1,2,3\n-1,0,2\n", &cloud)?;
/// assert_eq!(read.particles[1].mass(), 1.5);
///
/// // Two parts of 10 kg at y = ±1 m: Izz = 2 (2.5 + 10 · 1²)
/// let parts = b"mass_kg,x_m,y_m,z_m,Ixx_kg_m2,Iyy_kg_m2,Izz_kg_m2,Ixy_kg_m2,Ixz_kg_m2,Iyz_kg_m2
/// 10,0,1,0,1,2,2.5,0,0,0
/// 10,0,-1,0,1,2,2.5,0,0,0";
/// let read = particles::read(parts, &ParticleOptions::default())?;
/// assert_eq!(read.mass_properties().unwrap().inertia().matrix()[2][2], 25.0);
/// # Ok::<(), polhode_source::ContentError>(())
/// ```
///
/// # Errors
/// [`ContentError`] with its place in these cases:
///
/// - a column or a unit is missing,
/// - an unused column is about mass or number,
/// - the sign of products is not declared,
/// - a line has a different number of fields than the first,
/// - a field is not a finite number,
/// - a mass is not positive, or a tensor is not physical.
pub fn read(bytes: &[u8], options: &ParticleOptions) -> Result<ParticleFile, ContentError> {
    told_unit("the unit of mass", options.mass_unit)?;
    told_unit("the unit of length", options.length_unit)?;
    let start = if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
    let (table, data) = Table::of(bytes, start, options)?;
    let has_masses = table.header.has(MASS);
    if has_masses && let Some(total) = options.total_mass {
        let rule = "absent, because the file has a column of masses".to_owned();
        return Err(value("the total mass", total.to_string(), rule, ContentPlace::Whole));
    }
    if !has_masses && (options.total_mass.is_none() || table.header.has_tensors()) {
        let hint = match table.header.has_tensors() {
            true => "a part with a tensor needs its own mass: add a column mass_kg",
            false => "add a column mass_kg, or give the total mass, which the points then share equally",
        };
        return Err(missing("column of masses", hint));
    }
    let mut names = Names::default();
    let (mut points, mut tensors) = (Vec::new(), Vec::new());
    table.each_row(bytes, data, |line, row| {
        let place = [row.numbers[1], row.numbers[2], row.numbers[3]];
        if let Some(name) = &row.name {
            names.add(bytes, name, place)?;
        }
        if table.header.has_tensors() {
            tensors.push(tensor(bytes, &line, row, table.header.products)?);
        }
        points.push((line, row.numbers[MASS], place));
        Ok(())
    })?;
    if points.is_empty() {
        return Err(missing("lines of numbers", "a line is a mass and a position, such as 1.5,0,0.2,-3"));
    }
    let mut findings = table.header.findings;
    findings.extend(names.finding());
    let share = options.total_mass.map(|total| total / points.len() as f64);
    if let Some(total) = options.total_mass {
        let message = format!("{} points without masses share {total} kg equally", points.len());
        findings.push(info("particles.equal-masses", message));
    }
    let particles = points.into_iter().map(|(line, mass, [x, y, z])| {
        Particle::new(share.unwrap_or(mass), Position::new(x, y, z)).map_err(|e| body_error(e, line))
    });
    Ok(ParticleFile { particles: particles.collect::<Result<_, _>>()?, tensors, findings })
}

/// Returns the tensor of a line. Nonzero products need a declared sign.
fn tensor(
    bytes: &[u8],
    line: &Range<usize>,
    row: &Row,
    products: Option<Products>,
) -> Result<InertiaTensor<Body>, ContentError> {
    let mut six = [0.0; 6];
    six.copy_from_slice(&row.numbers[TENSOR]);
    let [xx, yy, zz, integrals @ ..] = six;
    let tensor = match products {
        Some(Products::Positive) => InertiaTensor::with_positive_products([xx, yy, zz], integrals),
        None if integrals != [0.0; 3] => {
            let question = "are the products of inertia −∫xy dm or +∫xy dm?";
            let kind = ContentErrorKind::unclear(question, fields::text_of(bytes, line));
            return Err(kind.at(line.clone()).hint(
                "write a line # products = negative_integral (the elements of the tensor) or \
                 # products = positive_integral above the header",
            ));
        }
        _ => InertiaTensor::with_negative_products([xx, yy, zz], integrals),
    };
    tensor.map_err(|error| body_error(error, line.clone()))
}

fn body_error(error: BodyError, line: Range<usize>) -> ContentError {
    ContentErrorKind::Body(Box::new(error)).at(line)
}

fn value(what: &str, value: String, rule: String, place: ContentPlace) -> ContentError {
    ContentError::new(ContentErrorKind::value(what, value, rule), place)
}

fn missing(what: &str, hint: &str) -> ContentError {
    ContentErrorKind::missing(what).of_whole().hint(hint)
}
