//! Scenario that is evaluated many times with some of its numbers changed.

use std::path::{Path, PathBuf};

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::formula::Formula;
use polhode::math::{Body, Position};
use polhode::motion::Scenario;
use polhode_source::expression::condition;
use polhode_source::files::{Disk, Files};
use polhode_source::toml::source::Source;
use polhode_source::toml::tree::{Entries, Node, Replacement, replace};
use polhode_source::unit::Dimension;
use polhode_source::{FormatError, FormatErrorKind};

use super::sweep::{self, Question, Sweep};
use super::target::{Target, Varied};
use super::{document, read_root, text_of};

/// Scenario that is evaluated many times with some of its numbers changed.
///
/// The file is parsed once. Later evaluations open no files; they reuse the meshes, molecules and
/// tables of the first one. Unchanged parts of the body are not computed again, and have no
/// [`form`](polhode::body::BodyPart::form).
///
/// ```
/// use polhode_scenario::read::Template;
/// use polhode_source::files::Memory;
/// let plan = r#"
/// [[body.part]]
/// shape = "sphere"
/// radius = "20 mm"
/// mass = "0.5 kg"
///
/// [sweep]
/// members = 100
/// sampling = "monte carlo"
/// vary = [{ key = "body.part[0].mass", uniform = { from = "0.4 kg", to = "600 g" } }]
/// "#;
/// let template = Template::parse(&Memory::default(), plan.to_owned(), "balls.toml".as_ref())?;
/// let mass = template.sweep()?.vary[0].target.clone();
/// let heavy = template.scenario([(&mass, &[0.6][..])])?;
/// assert_eq!(heavy.body().mass(), 0.6);
/// assert!(template.scenario([(&mass, &[-0.6][..])]).is_err());
/// # Ok::<(), polhode_source::FormatError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Template {
    path: PathBuf,
    text: String,
    entries: Entries,
    files: Vec<PathBuf>,
    nominal: Scenario,
}

impl Template {
    /// Reads a scenario, optionally with a `[sweep]`; paths in it are relative to it.
    ///
    /// # Errors
    /// Same as [`scenario::read`](super::read).
    pub fn read(files: &dyn Files, path: &Path) -> Result<Self, FormatError> {
        Self::parse(files, text_of(files, path)?, path)
    }

    /// Reads a scenario, optionally with a `[sweep]`, from its text.
    ///
    /// # Errors
    /// Same as [`scenario::read`](super::read).
    pub fn parse(files: &dyn Files, text: String, path: &Path) -> Result<Self, FormatError> {
        let source = Source::new(files, path, &text);
        let entries = document(source)?;
        let (nominal, _) = read_root(source, &entries)?;
        let mut files = Vec::new();
        let mut see = |leaf: &Node| files.extend(leaf.file().map(|name| source.sibling(name)));
        entries.values().for_each(|entry| entry.node.each_leaf(&mut see));
        Ok(Self { path: path.to_owned(), entries, files, nominal, text })
    }

    /// Returns the scenario as written.
    pub const fn nominal(&self) -> &Scenario {
        &self.nominal
    }

    /// Returns the text of the file.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns the path of the file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the files that the scenario names.
    pub fn files(&self) -> &[PathBuf] {
        &self.files
    }

    /// Returns the contents of `[sweep]`.
    ///
    /// # Errors
    /// [`FormatError`] if there is no `[sweep]`, or if it is invalid.
    pub fn sweep(&self) -> Result<Sweep, FormatError> {
        sweep::sweep(self.source(), &self.entries, &self.nominal)
    }

    /// Returns the scenario with other values, SI units, for some targets; each target needs one
    /// value per column.
    ///
    /// # Errors
    /// [`FormatError`] if the body or motion is invalid; the error refers to a place in the file.
    pub fn scenario<'v>(
        &self,
        values: impl IntoIterator<Item = (&'v Target, &'v [f64])>,
    ) -> Result<Scenario, FormatError> {
        let mut entries = self.entries.clone();
        for (target, values) in values {
            self.replace(target, values, &mut entries)?;
        }
        read_root(self.source(), &entries).map(|(scenario, _)| scenario)
    }

    /// Returns the condition of a question on columns with these names and dimensions.
    ///
    /// # Errors
    /// [`FormatError`] at its place in the question, if the condition is invalid.
    pub fn condition(
        &self,
        question: &Question,
        columns: &[(&str, Dimension)],
    ) -> Result<Formula, FormatError> {
        condition(&question.condition, columns)
            .map_err(|error| self.source().formula(question.place.clone(), &question.condition, error))
    }

    /// Returns the text as a source. No file is opened, because their contents are cached.
    fn source(&self) -> Source<'_> {
        Source { is_shown: false, ..Source::new(&Disk, &self.path, &self.text) }
    }

    /// Replaces the values of a target.
    fn replace(&self, target: &Target, values: &[f64], entries: &mut Entries) -> Result<(), FormatError> {
        let fail = |kind| self.source().error(target.place.clone(), kind);
        let invalid = |key: &str, value: String, rule: &str| {
            fail(FormatErrorKind::Value { key: key.to_owned(), value, rule: rule.to_owned() })
        };
        let columns = target.columns();
        if values.len() != columns.len() {
            return Err(invalid(&target.key, format!("{values:?}"), &format!("{} numbers", columns.len())));
        }
        if let Some((value, column)) = values.iter().zip(columns).find(|(value, _)| !value.is_finite()) {
            return Err(invalid(&column.name, value.to_string(), "finite"));
        }
        match (&target.varied, values) {
            (Varied::Numbers(numbers), values) => {
                for (ways, value) in numbers.iter().zip(values) {
                    ways.iter().for_each(|way| replace(entries, way, Replacement::Number(*value)));
                }
            }
            (Varied::Rotation(way), &[w, x, y, z]) => {
                replace(entries, way, Replacement::Rotation([w, x, y, z]));
            }
            (Varied::MassProperties(way, name, nominal), values) => {
                let other = mass_properties(nominal, values).map_err(|e| fail(FormatErrorKind::Body(e)))?;
                replace(entries, way, Replacement::MassProperties(name.clone(), other));
            }
            // Rotations have four columns; other numbers of values are refused above.
            (Varied::Rotation(_), _) => {}
        }
        Ok(())
    }
}

/// Creates mass properties from ten numbers, or from the six of a tensor: xx, yy, zz, xy, xz, yz.
fn mass_properties(
    nominal: &MassProperties<Body>,
    values: &[f64],
) -> Result<MassProperties<Body>, polhode::body::BodyError> {
    let (mass, center, tensor) = match *values {
        [mass, x, y, z, ref tensor @ ..] if tensor.len() == 6 => (mass, Position::new(x, y, z), tensor),
        _ => (nominal.mass(), nominal.center_of_mass(), values),
    };
    let inertia = match *tensor {
        [xx, yy, zz, xy, xz, yz] => InertiaTensor::with_negative_products([xx, yy, zz], [xy, xz, yz])?,
        _ => *nominal.inertia(),
    };
    MassProperties::new(mass, center, inertia)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

    use std::fs;
    use std::ops::Range;

    use polhode::body::BodyPart;

    use super::*;
    use crate::read as scenario;
    use polhode_source::toml::tree::{Kind, Known, Step, Way};

    /// Returns the scenario without data that do not affect the motion: shapes of parts, and places
    /// of findings.
    fn comparable(scenario: Scenario) -> Scenario {
        let without = scenario.parts().iter().map(|part| BodyPart { form: None, ..part.clone() }).collect();
        scenario.made_of(without)
    }

    /// Collects the paths to all numbers below a node.
    fn numbers(node: &Node, way: &[Step], found: &mut Vec<(Way, Range<usize>, f64, Dimension)>) {
        let further = |step| way.iter().cloned().chain([step]).collect::<Vec<_>>();
        match &node.kind {
            Kind::List(elements) => {
                for (k, element) in elements.iter().enumerate() {
                    numbers(element, &further(Step::Element(k)), found);
                }
            }
            Kind::Table(entries) => {
                for (key, entry) in entries {
                    numbers(&entry.node, &further(Step::Key(key.clone())), found);
                }
            }
            _ => {
                if let Some(Known::Number(value, dimension)) = node.known.get() {
                    found.push((way.to_vec(), node.span.clone(), *value, *dimension));
                }
            }
        }
    }

    /// Replacing a number gives the same result as writing it in the file, for every number of
    /// every example. If one is refused, so is the other.
    #[test]
    fn a_replaced_number_is_one_written_otherwise() {
        let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
        let mut count = 0;
        for entry in
            [examples.clone(), examples.join("notes")].iter().flat_map(|folder| fs::read_dir(folder).unwrap())
        {
            let path = entry.unwrap().path();
            if path.extension().is_none_or(|extension| extension != "toml") {
                continue;
            }
            let template = Template::read(&Disk, &path).unwrap();
            let mut found = Vec::new();
            for (key, entry) in &template.entries {
                numbers(&entry.node, &[Step::Key(key.clone())], &mut found);
            }
            for (way, span, value, dimension) in found {
                let value = 1.0625 * value + 0.0078125;
                let mut text = template.text.clone();
                // A number without a unit is refused next to others with units.
                let written = match dimension.unit().0 {
                    unit if unit.is_empty() => format!("{value:?}"),
                    unit => format!("\"{value:?} {unit}\""),
                };
                text.replace_range(span.clone(), &written);
                let written = scenario::parse(&text, &path).map(comparable);
                let mut entries = template.entries.clone();
                replace(&mut entries, &way, Replacement::Number(value));
                let again = read_root(template.source(), &entries).map(|(scenario, _)| comparable(scenario));
                match (written, again) {
                    (Ok(written), Ok(again)) => assert!(written == again, "{}: {way:?}", path.display()),
                    (Err(written), Err(again)) => assert_eq!(written.message(), again.message()),
                    (written, again) => panic!("{}: {way:?}: {written:?}, {again:?}", path.display()),
                }
                count += 1;
            }
        }
        assert!(count > 300, "{count}");
    }

    #[test]
    fn nothing_changed_is_nothing_changed() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/bracket.toml");
        let template = Template::read(&Disk, &path).unwrap();
        assert_eq!(template.files().len(), 1);
        assert_eq!(comparable(template.scenario([]).unwrap()), comparable(template.nominal().clone()));
    }
}
