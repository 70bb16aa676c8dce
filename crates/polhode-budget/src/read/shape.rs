//! Parts described by their form: a shape, a mesh, a report of a CAD program, or the body of a
//! scenario.

use std::ops::Range;
use std::path::{Path, PathBuf};

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{Body, Frame, Part, Position};
use polhode_scenario::read::ScenarioFile;
use polhode_scenario::read::part::part;
use polhode_shape::cad;
use polhode_shape::mesh::MeshFormat;
use polhode_source::files::{Confined, Files as _, NotOpened};
use polhode_source::toml::document;
use polhode_source::toml::reader::Table;
use polhode_source::toml::source::Source;
use polhode_source::unit;
use polhode_source::{FormatError, FormatErrorKind};

use super::cell::Cell;
use super::cells::{Cells, Given, Reader};
use super::heading::ColumnUnit;
use super::key::{
    CAD, DENSITY, ENDS, FILE, FILL, KEYS, MATERIAL, MESH, SCENARIO, SHAPE, SIZES, UNION, UNIT, WELD, X, Y, Z,
};
use super::rows::Rows;

/// Kind of form that a row refers to.
enum Form {
    Shape,
    Mesh,
    Cad,
    Scenario,
}

/// Largest number of shapes in the cache, which avoids computing equal ones again.
const MOST_KNOWN: usize = 10_000;

/// Table of a scenario made of a row, with the source cell of each value.
struct Written<'s, 'a> {
    text: String,
    cells: Vec<(Range<usize>, &'s Cell<'a>)>,
}

impl<'s, 'a> Written<'s, 'a> {
    fn put(&mut self, key: &str, value: &str, cell: &'s Cell<'a>) {
        let start = self.text.len();
        self.text += &format!("{key} = {value}\n");
        self.cells.push((start..self.text.len(), cell));
    }
}

impl<'s, 'a> Rows<'s, 'a> {
    /// Computes a part from its shape, mesh or file, and from the mass that its row gives.
    pub(crate) fn formed<'c>(
        &mut self,
        cells: &Cells<'c, 'a>,
        mass: Option<Given<'c, 'a>>,
    ) -> Result<MassProperties<Part>, FormatError> {
        let all = [(SHAPE, Form::Shape), (MESH, Form::Mesh), (CAD, Form::Cad), (SCENARIO, Form::Scenario)];
        let by_key = all.into_iter().find_map(|(key, form)| Some((cells.cell(key)?, form)));
        let by_file = || cells.cell(FILE).map(|cell| (cell, form_of(&cell.text)));
        let Some((cell, form)) = by_key.or_else(by_file) else {
            return Err(self.reader.invalid(cells.first, "a part"));
        };
        let text = self.reader.whole(cell)?;
        let is_shape = matches!(form, Form::Shape);
        if !is_shape && let Some(center) = [X, Y, Z].iter().find_map(|key| cells.cell(*key)) {
            let error = self.reader.invalid(center, "left out, because the file gives the centre of mass");
            return Err(error.with_hint("at x, at y and at z give the position of the file's axes"));
        }
        let properties = match form {
            Form::Shape | Form::Mesh => self.shaped(cells, cell, mass)?,
            Form::Cad | Form::Scenario => {
                let others = [DENSITY, MATERIAL, ENDS, UNIT, WELD, FILL, UNION].into_iter().chain(SIZES);
                let others = others.filter_map(|key| cells.cell(key));
                if let Some(other) = mass.map(|mass| mass.cell).into_iter().chain(others).next() {
                    return Err(self.reader.invalid(other, "left out, because the file gives it"));
                }
                let path = self.beside(text);
                self.require_within(cell)?;
                match form {
                    Form::Cad => self.reported(&path, cell)?,
                    _ => self.body_of(&path, cell)?,
                }
            }
        };
        let center = self.reader.all_or_none(cells, [X, Y, Z])?;
        let Some(center) = center else { return Ok(properties) };
        let center = Position::from_array(center.map(|given| given.map_or(0.0, |given| given.value)));
        MassProperties::new(properties.mass(), center, *properties.inertia())
            .map_err(|error| self.reader.sheet.error(cell, FormatErrorKind::Body(error)))
    }

    fn beside(&self, name: &str) -> PathBuf {
        self.reader.sheet.path().parent().unwrap_or(Path::new("")).join(name)
    }

    /// Returns the files that parts may refer to.
    fn files(&self) -> Confined<'s> {
        self.access.of(self.reader.sheet.path())
    }

    fn require_within(&self, cell: &Cell<'a>) -> Result<(), FormatError> {
        let folder = self.reader.sheet.path().parent().unwrap_or(Path::new(""));
        match self.files().named(folder, Path::new(&*cell.text)) {
            Err(NotOpened::Outside) => {
                let error = self.reader.invalid(cell, "a file in the folder of the parts list, or below it");
                Err(error.with_hint("--root DIR allows files in another folder"))
            }
            Err(NotOpened::NotGiven) => {
                Err(self.reader.invalid(cell, "left out: no other file is opened for this list"))
            }
            Err(NotOpened::NotRegular) => Err(self.reader.invalid(cell, "a regular file")),
            // The reader of the file reports that it is missing.
            Ok(_) | Err(NotOpened::Missing) => Ok(()),
        }
    }

    /// Computes a shape or a mesh with the reader of scenarios.
    fn shaped<'c>(
        &mut self,
        cells: &Cells<'c, 'a>,
        form: &'c Cell<'a>,
        mass: Option<Given<'c, 'a>>,
    ) -> Result<MassProperties<Part>, FormatError> {
        let mut table = Written { text: String::new(), cells: Vec::new() };
        let is_shape = cells.cell(SHAPE).is_some();
        let name = quoted(&form.text);
        if is_shape {
            table.put("shape", &name, form);
        } else {
            table.put("shape", "\"mesh\"", form);
            table.put("file", &name, form);
        }
        if let Some(given) = mass {
            table.put("mass", &format!("{:?}", given.value), given.cell);
        }
        if let Some(cell) = cells.cell(DENSITY) {
            let density = match self.reader.given_density(cells)? {
                Some(given) => format!("{:?}", given.value),
                None => quoted(&cell.text),
            };
            table.put("density", &density, cell);
        }
        for key in [MATERIAL, UNIT, ENDS, UNION].into_iter().chain(SIZES).chain([WELD, FILL]) {
            let Some(cell) = cells.cell(key) else { continue };
            let value = match key {
                MATERIAL | UNIT => quoted(self.reader.whole(cell)?),
                ENDS | UNION => match self.reader.whole(cell)?.to_ascii_lowercase().as_str() {
                    "true" | "yes" => "true".to_owned(),
                    "false" | "no" => "false".to_owned(),
                    _ => return Err(self.reader.invalid(cell, "true or false")),
                },
                _ => self.reader.sizes(cell)?,
            };
            table.put(&KEYS[key].name.replace(' ', "_"), &value, cell);
        }
        if let Some(known) = self.known.get(&table.text) {
            return Ok(*known);
        }
        let files = self.files();
        let source = Source::new(&files, self.reader.sheet.path(), &table.text);
        let mut findings = Vec::new();
        let mut read = || {
            let entries = document(source)?;
            part(Table::root(source, &entries), 1, &mut findings)
        };
        let read = read().map_err(|error| self.reader.sheet.moved(error, &table.cells, form))?;
        let row = form.row;
        self.taken
            .findings
            .extend(findings.into_iter().map(|finding| format!("row {row}: {}", finding.message)));
        let properties = in_part(&read.properties);
        let properties =
            properties.map_err(|error| self.reader.sheet.error(form, FormatErrorKind::Body(error)))?;
        if self.known.len() < MOST_KNOWN {
            self.known.insert(table.text, properties);
        }
        Ok(properties)
    }

    /// Reads the mass properties in a report of a CAD program.
    fn reported(&mut self, path: &Path, cell: &Cell<'a>) -> Result<MassProperties<Part>, FormatError> {
        let key = format!("cad {}", path.display());
        if let Some(known) = self.known.get(&key) {
            return Ok(*known);
        }
        let read =
            polhode_source::read_text_file(&self.files(), path, |text| cad::read(text, &self.plan.cad));
        let report = read.map_err(|error| self.named_in(error, cell))?;
        self.taken
            .findings
            .extend(report.findings.iter().map(|finding| format!("{}: {}", cell.text, finding.message)));
        self.taken.findings.push(format!(
            "{}: products of inertia {}, by {}",
            cell.text,
            report.proof.convention.name(),
            report.proof.by.name()
        ));
        self.keep(key, &report.properties, cell)
    }

    /// Reads the body of a scenario.
    fn body_of(&mut self, path: &Path, cell: &Cell<'a>) -> Result<MassProperties<Part>, FormatError> {
        let key = format!("scenario {}", path.display());
        if let Some(known) = self.known.get(&key) {
            return Ok(*known);
        }
        let scenario = ScenarioFile::read(&self.files(), path);
        let scenario = scenario.map_err(|error| self.named_in(error, cell))?.scenario;
        let taken = scenario.taken_at_start();
        let findings = scenario.findings().iter().chain(&taken);
        self.taken.findings.extend(findings.map(|finding| format!("{}: {}", cell.text, finding.message)));
        self.keep(key, scenario.body(), cell)
    }

    fn keep(
        &mut self,
        key: String,
        body: &MassProperties<Body>,
        cell: &Cell<'a>,
    ) -> Result<MassProperties<Part>, FormatError> {
        let properties =
            in_part(body).map_err(|error| self.reader.sheet.error(cell, FormatErrorKind::Body(error)))?;
        self.known.insert(key, properties);
        Ok(properties)
    }

    /// Returns the error of a file, with the cell that refers to it.
    fn named_in(&self, error: FormatError, cell: &Cell<'a>) -> FormatError {
        let sheet = self.reader.sheet;
        match error.kind() {
            kind @ FormatErrorKind::Io { .. } => sheet
                .error(cell, kind.clone())
                .with_hint(format!("paths are relative to the parts list: this one is {:?}", error.path())),
            _ => error.named_at(sheet.path(), sheet.spot(cell)),
        }
    }
}

impl<'s, 'a> Reader<'s, 'a> {
    /// Reads the density of a part; `None` if there is none, or if it is a formula.
    pub(crate) fn given_density<'c>(
        &mut self,
        cells: &Cells<'c, 'a>,
    ) -> Result<Option<Given<'c, 'a>>, FormatError> {
        let Some(cell) = cells.cell(DENSITY) else { return Ok(None) };
        let pointed = self.pointed(cell)?;
        let first = pointed.split(['±', '+']).next().unwrap_or_default();
        let is_number = unit::number_of(first.trim_start_matches('('))
            .is_some_and(|_| !unit::unit_of(first).starts_with(['*', '·', '-', '(']));
        if is_number { self.number(cells, DENSITY) } else { Ok(None) }
    }

    /// Converts lengths to the form of scenarios: `100 × 50 × 20 mm` becomes a list of three.
    fn sizes(&self, cell: &Cell<'a>) -> Result<String, FormatError> {
        if self.whole(cell)?.starts_with('[') {
            return Ok(cell.text.to_string());
        }
        let text = self.pointed(cell)?;
        let mut pieces: Vec<&str> = text.split(['×', 'x', 'X', ';']).map(str::trim).collect();
        if let [one] = pieces[..] {
            pieces = one.split(',').map(str::trim).collect();
        }
        let own = pieces.last().map_or("", |last| unit::unit_of(last));
        let mut units = pieces.iter().map(|piece| unit::unit_of(piece));
        if units.clone().any(str::is_empty) && units.any(|other| !other.is_empty() && other != own) {
            let error = self.invalid(cell, "lengths with one unit at the end, or each with its own");
            return Err(error.with_hint("write 100 × 50 × 20 mm, or 10 cm × 50 mm × 20 mm"));
        }
        let of_column = match self.columns.get(cell.column).map(|column| &column.unit) {
            Some(ColumnUnit::Unit(unit)) => unit.name.as_str(),
            _ => "",
        };
        let unit = if own.is_empty() { of_column } else { own };
        let all: Vec<String> = pieces
            .iter()
            .map(|piece| match (unit::number_of(piece), unit::unit_of(piece)) {
                (Some(number), "") if unit.is_empty() => {
                    number.parse().map_or(number, |number: f64| format!("{number:?}"))
                }
                (Some(number), "") => quoted(&format!("{number} {unit}")),
                _ => quoted(piece),
            })
            .collect();
        Ok(if let [one] = &all[..] { one.clone() } else { format!("[{}]", all.join(", ")) })
    }
}

/// Returns the kind of a file by its name.
fn form_of(name: &str) -> Form {
    let path = Path::new(name);
    if MeshFormat::of_path(path).is_some() || polhode_shape::brep::BrepFormat::of_path(path).is_some() {
        return Form::Mesh;
    }
    match path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml")) {
        true => Form::Scenario,
        false => Form::Cad,
    }
}

/// Returns a body in the frame of a row.
fn in_part<F: Frame>(body: &MassProperties<F>) -> Result<MassProperties<Part>, polhode::body::BodyError> {
    let center = Position::from_array(body.center_of_mass().to_array());
    MassProperties::new(body.mass(), center, InertiaTensor::from_matrix(body.inertia().matrix())?)
}

/// Returns a text as a TOML string.
pub(crate) fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => quoted += &format!("\\u{:04X}", u32::from(c)),
            c => quoted.push(c),
        }
    }
    quoted + "\""
}

#[cfg(test)]
mod tests {
    use super::{ENDS, KEYS, SIZES};
    use polhode_scenario::read::shape::SHAPES;

    #[test]
    fn every_key_of_a_shape_of_scenarios_is_a_column() {
        let columns: Vec<String> =
            SIZES.into_iter().chain([ENDS]).map(|key| KEYS[key].name.replace(' ', "_")).collect();
        for (shape, keys) in SHAPES {
            assert!(keys.iter().all(|key| columns.iter().any(|column| column == key)), "{shape}: {keys:?}");
        }
    }
}
