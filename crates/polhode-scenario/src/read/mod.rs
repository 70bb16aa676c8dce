//! Scenario files: one body and one motion, as TOML.
//!
//! ```toml
//! title = "T-handle in free fall"
//!
//! [[body.part]]                       # box, sphere, cylinder, …, mesh, particles, tensor
//! shape = "cylinder"
//! radius = "4 mm"
//! length = "40 mm"
//! material = "aluminium"              # or density = "2700 kg/m^3", or mass = "12 g"
//! position = ["0 mm", "0 mm", "20 mm"]
//! rotate = { axis = [0, 1, 0], angle = "90 deg" }
//!
//! [start]
//! spin = { body = ["0.01 rad/s", "0 rad/s", "12 rad/s"] }     # or space = …, or momentum = …
//!
//! [run]
//! duration = "20 s"
//! samples = 2001                      # or every = "10 ms"
//! ```
//!
//! A quantity is a string with its unit, or a number in SI. Anything unknown, impossible or
//! ambiguous is an error that points to its place. Nothing is ignored.

mod actions;
mod body;
mod completion;
mod contact;
mod draft;
mod event;
mod formula;
mod gimbals;
mod key;
mod known_mesh;
pub mod mass_history;
mod mass_table;
mod molecule;
mod motion_table;
mod number;
mod orbit;
pub mod part;
mod pendulum;
mod placement;
mod pointing;
mod prescribed;
mod rows;
mod run;
mod schema;
mod shaft;
pub mod shape;
mod start;
mod substance;
mod sweep;
mod symbolic;
mod symbols;
mod target;
mod template;
mod tensor;
mod torque;
mod wheel;

use std::path::{Path, PathBuf};

use polhode::motion::{ActingTorque, MotionError, Rotor, Scenario};
use polhode_document::SourceInfo;
use polhode_shape::mesh::stl;
use polhode_shape::report::InertiaReport;
use polhode_source::file;
use polhode_source::files::{Disk, Files, Memory};
use polhode_source::toml::reader::Table;
use polhode_source::toml::source::Source;
use polhode_source::toml::tree::Entries;
use polhode_source::{FormatError, FormatErrorKind, Place};

use crate::symbolic::Exact;
use mass_history::PartHistory;
use pointing::References;
use torque::TorquePlaces;

pub use actions::Actions;
pub use completion::{Completion, Suggested};
pub use draft::Draft;
pub use number::WrittenNumber;
pub use run::TableFormat;
pub use schema::schema;
pub use sweep::{Dispersion, Distribution, Law, Question, SOBOL_DIMENSIONS, Sampling, Spread, Sweep, Vary};
pub use target::{Target, TargetColumn};
pub use template::Template;

/// Top-level keys of the file.
pub const TOP: [&str; 17] = [
    "title",
    "symbols",
    "body",
    "orbit",
    "start",
    "torque",
    "wheel",
    "mass_history",
    "event",
    "pointing",
    "prescribed",
    "shaft",
    "pendulum",
    "contact",
    "gimbals",
    "run",
    "sweep",
];

/// Scenario with its file; errors of the motion can be located in the text.
///
/// ```
/// use polhode_scenario::read::ScenarioFile;
/// use polhode_source::files::Memory;
/// let text = r#"
/// [[body.part]]
/// shape = "sphere"
/// radius = "20 mm"
/// mass = "0.5 kg"
/// [[torque]]
/// model = "formula"
/// axes = "body"
/// torque = ["0", "1[N m]/t*1[s]", "0"]
/// [run]
/// duration = "1 s"
/// samples = 2
/// "#;
/// let file = ScenarioFile::parse(&Memory::default(), text.to_owned(), "ball.toml".as_ref())?;
/// let error = file.scenario.simulate().and_then(Result::err).ok_or("it is finite")?;
/// let placed = file.placed(&error).ok_or("it has no place")?;
/// assert_eq!(placed.to_string(), "ball.toml:9:16: torque 1 is not finite at the start: (0, inf, 0) N·m in body axes");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ScenarioFile {
    /// Scenario defined by the file.
    pub scenario: Scenario,
    /// Text of the file.
    pub text: String,
    /// Table formats requested in `[run]`; empty if none are.
    pub tables: Vec<TableFormat>,
    /// Path of the file.
    pub path: PathBuf,
    torques: Vec<TorquePlaces>,
}

impl ScenarioFile {
    /// Reads a scenario file; paths in it are relative to it.
    ///
    /// # Errors
    /// Same as [`read`].
    pub fn read(files: &dyn Files, path: &Path) -> Result<Self, FormatError> {
        Self::parse(files, text_of(files, path)?, path)
    }

    /// Reads a scenario from its text; `path` is used in messages, and paths in the text are
    /// relative to it.
    ///
    /// # Errors
    /// Same as [`read`].
    pub fn parse(files: &dyn Files, text: String, path: &Path) -> Result<Self, FormatError> {
        let source = Source { headings: &TOP, ..Source::new(files, path, &text) };
        let (scenario, tables, torques) = file_of_root(source, &document(source)?)?;
        Ok(Self { scenario, tables, torques, path: path.to_owned(), text })
    }

    /// Returns the report on the body at the start.
    pub fn inertia(&self) -> InertiaReport {
        let title = self.scenario.title();
        let source = SourceInfo::new(self.path.display().to_string(), "scenario")
            .described(title.unwrap_or("scenario"))
            .with("title", title.map(str::to_owned))
            .with("parts", self.scenario.parts().len());
        InertiaReport::of_scenario(source, &self.scenario)
    }

    /// Returns what the file says exactly: formulas of its `[symbols]`, or fractions.
    pub fn exact(&self) -> Exact {
        exact(&self.text, &self.path, &self.scenario)
    }

    /// Returns an error of the motion with its place in the file, if it concerns one of the
    /// torques.
    pub fn placed(&self, error: &MotionError) -> Option<FormatError> {
        let (torque, value) = match *error {
            MotionError::TorqueNotFinite { torque, value } => (torque, value),
            MotionError::NotSmooth { torque, .. }
            | MotionError::TooManyPulses { torque: Some(torque), .. } => (torque, [0.0; 3]),
            _ => return None,
        };
        let places = self.torques.get(torque)?;
        let is_of_pulses = matches!(error, MotionError::TooManyPulses { .. });
        let pulses = places.pulses.as_ref().filter(|_| is_of_pulses);
        // The first non-finite component, along the axes of the formulas.
        let wrong = value.iter().position(|c| !c.is_finite());
        let component = wrong.and_then(|k| places.along_body.get(k));
        let span = pulses.or(component).or(places.formulas.as_ref()).unwrap_or(&places.model).clone();
        let kind = FormatErrorKind::Motion(error.clone());
        Some(FormatError::new(&self.path, Some(Place::in_text(&self.text, span)), kind))
    }
}

/// Reads a scenario file; paths in it are relative to it.
///
/// # Errors
/// [`FormatError`] if the file, or a file that it names, cannot be read, or does not describe a
/// physical body and a valid motion.
pub fn read(path: &Path) -> Result<Scenario, FormatError> {
    ScenarioFile::read(&Disk, path).map(|file| file.scenario)
}

/// Reads the text of a scenario file, of up to 64 MiB.
///
/// # Errors
/// [`FormatError`] if the file cannot be read, is larger, or is not UTF-8.
pub fn text_of(files: &dyn Files, path: &Path) -> Result<String, FormatError> {
    polhode_source::toml::text_of(files, path).map_err(|error| match error.kind() {
        FormatErrorKind::Io { .. } | FormatErrorKind::Utf16 => error,
        _ => perhaps_mesh(
            error,
            &file::bytes(files, path, "", polhode_source::toml::LARGEST_FILE).unwrap_or_default(),
        ),
    })
}

/// Adds advice to an error if the bytes are a mesh instead of a scenario.
fn perhaps_mesh(error: FormatError, bytes: &[u8]) -> FormatError {
    let named = error.path().extension().is_some_and(|extension| extension.eq_ignore_ascii_case("stl"));
    let head = bytes.trim_ascii_start().get(..6).unwrap_or_default();
    if named || head.eq_ignore_ascii_case(b"solid ") || stl::read(bytes).is_ok() {
        return error
            .with_hint("this is a mesh, not a scenario: polhode inertia reads it if its name ends in .stl");
    }
    error
}

/// Reads a scenario from its text; `path` is used in messages, and paths in the text are relative
/// to it.
///
/// A plan, which has a `[sweep]`, gives the scenario as written, with a finding.
///
/// ```
/// use polhode_scenario::read;
/// let text = r#"
/// [[body.part]]
/// shape = "sphere"
/// radius = "20 mm"
/// mass = "0.5 kg"
/// "#;
/// let scenario = read::parse(text, "ball.toml".as_ref())?;
/// assert!((scenario.body().inertia().matrix()[0][0] - 0.4 * 0.5 * 0.02 * 0.02).abs() < 1e-19);
///
/// let error = read::parse(&text.replace("20 mm", "20 kg"), "ball.toml".as_ref()).unwrap_err();
/// assert_eq!(error.to_string(), "ball.toml:4:10: \"kg\" is a mass where a length belongs");
/// # Ok::<(), polhode_source::FormatError>(())
/// ```
///
/// # Errors
/// Same as [`read`].
pub fn parse(text: &str, path: &Path) -> Result<Scenario, FormatError> {
    ScenarioFile::parse(&Disk, text.to_owned(), path).map(|file| file.scenario)
}

/// Returns what the text of a valid scenario says exactly: formulas of its `[symbols]`, or fractions.
pub fn exact(text: &str, path: &Path, scenario: &Scenario) -> Exact {
    // Files, such as meshes, have no exact formulas and are not read.
    let files = Memory::default();
    let source = Source { headings: &TOP, ..Source::new(&files, path, text) };
    let Ok(entries) = document(source) else { return Exact::None };
    let Ok(symbols) = symbols::symbols(&Table::root(source, &entries)) else { return Exact::None };
    let symbolic = symbolic::symbolic(source, &entries, &symbols, scenario);
    match (symbolic, symbols.all().is_empty()) {
        (Ok(symbolic), false) => Exact::Symbols(symbolic),
        (Err(gap), false) => Exact::Gap(gap),
        (Ok(symbolic), true) => Exact::Fractions(symbolic),
        (Err(_), true) => Exact::None,
    }
}

/// Parses a file into a tree.
fn document(source: Source<'_>) -> Result<Entries, FormatError> {
    polhode_source::toml::document(source).map_err(|error| match error.kind() {
        FormatErrorKind::Toml { .. } => perhaps_mesh(error, source.text.as_bytes()),
        _ => error,
    })
}

/// Returns the contents of a file with the tables `entries`; for a plan, the scenario as written.
fn file_of_root(
    source: Source<'_>,
    entries: &Entries,
) -> Result<(Scenario, Vec<TableFormat>, Vec<TorquePlaces>), FormatError> {
    let (mut scenario, torques) = read_root(source, entries)?;
    if entries.contains_key("sweep") {
        let members = sweep::sweep(source, entries, &scenario)?.members;
        scenario = scenario.noting([sweep::nominal(members)]);
    }
    Ok((scenario, run::tables(&Table::root(source, entries))?, torques))
}

/// Returns the scenario of a file with the tables `entries`, and the places of its torques.
fn read_root(source: Source<'_>, entries: &Entries) -> Result<(Scenario, Vec<TorquePlaces>), FormatError> {
    let root = Table::root(source, entries);
    root.allow(&TOP)?;
    let symbols = symbols::symbols(&root)?;
    let root = Table::root(Source { symbols: Some(&symbols), ..source }, entries);
    for (a, b, why) in Scenario::EXCLUSIVE {
        root.at_most_one(&[a, b], why)?;
    }

    root.at_most_one(&["mass_history", "sweep"], "the bodies of a sweep have constant mass properties")?;
    root.at_most_one(&["contact", "sweep"], "sweeps have no outcomes for bodies on the ground")?;
    root.at_most_one(&["gimbals", "sweep"], "sweeps have no outcomes for rotors in gimbals")?;
    root.at_most_one(
        &["gimbals", "start"],
        "the start of a rotor in gimbals is defined by the angles and rates of the axes",
    )?;

    let mut findings = Vec::new();
    let title = root.get("title").map(|title| title.string().map(str::to_owned)).transpose()?;
    let body::Assembly { parts, mut body, mut pivot } = body::body(&root, &mut findings)?;
    let history = mass_history::read(&root, &parts, &body)?;
    if let Some(PartHistory { history, value, .. }) = &history {
        body = history.at(0.0).map_err(|error| value.motion(error))?.0;
    }
    let shared = orbit::read(&root)?;
    let orbit = shared.as_ref().map(|shared| &shared.orbit);
    let run = run::run(&root, orbit)?;
    run::tables(&root)?;
    let end = run.as_ref().and_then(|run| run.times.last().copied());
    findings.extend(history.iter().flat_map(|history| history.idle(end.unwrap_or(f64::INFINITY))));
    let torques = torque::torques(&root, &parts, orbit, end, &mut pivot)?;
    let references = References { orbit, field: torques.field() };
    let events = event::events(&root, &torques, &references)?;
    let pointings = pointing::pointings(&root, &references)?;
    let point = pivot.map(|pivot| pivot.point);
    let rotor = point.map_or_else(|| Rotor::free(&body), |point| Rotor::pivoted(&body, point));
    findings.extend(match point {
        None => body::thinness(rotor.principal()),
        Some(_) => body::thinness(&body.principal()),
    });
    let wheels = wheel::wheels(&root)?;
    let start = start::start(&root, &wheel::locked(&rotor, &wheels)?, orbit)?;
    let ground = contact::contact(&root, start.velocity)?;
    let prescribed = prescribed::prescribed(&root, &start, run.as_ref(), &mut findings)?;
    let named = torques.names.into_iter().enumerate();
    let acting = torques.models.into_iter().zip(named).map(|(model, (k, name))| {
        let is_on = !torques.switched_off.contains(&k);
        ActingTorque { model, name, is_on }
    });
    let wheel_names = wheels.iter().map(|wheel| wheel.name.clone()).collect();
    let wheels = wheel::turning(&rotor, &wheels, start.state.omega)?;
    // The checks above have reported errors with their places.
    let whole = |error: MotionError| root.error(FormatErrorKind::Motion(error));
    let mut scenario = Scenario::new(body).made_of(parts).starting(start.state).map_err(whole)?;
    if let Some(title) = title {
        scenario = scenario.titled(title);
    }
    if let Some(point) = point {
        scenario = scenario.held_at(point).map_err(whole)?;
    } else if let Some(velocity) = start.velocity {
        scenario = scenario.moving(velocity).map_err(whole)?;
    }
    if let Some(orbit) = orbit {
        scenario = scenario.in_orbit(orbit.clone()).map_err(whole)?;
    }
    scenario = scenario
        .pointing(pointings)
        .with_wheels(&wheels)
        .and_then(|s| s.with_torques(acting))
        .map_err(whole)?;
    scenario = scenario.naming_wheels(wheel_names).watching(events).map_err(whole)?;
    if let Some(PartHistory { history, value, .. }) = history {
        scenario = scenario.changing(history).map_err(|error| value.motion(error))?;
    }
    if let Some(motion) = prescribed {
        scenario = scenario.prescribed_as(motion).map_err(whole)?;
    }
    if let Some(run) = run {
        scenario = scenario.sampled(run);
    }
    if let Some(ground) = ground {
        scenario = ground.under(scenario, pivot.as_ref().map(|pivot| pivot.value))?;
    }
    scenario = gimbals::gimbals(&root, scenario, pivot.as_ref().map(|pivot| pivot.value))?;
    scenario = shaft::shaft(&root, &start, scenario)?;
    scenario = pendulum::pendulum(&root, scenario.noting(findings))?;
    // Members of sweeps have cached parts, whose formulas are not evaluated again.
    if root.is_shown() {
        symbols::require_used(&symbols, &root)?;
    }
    let noticed = scenario.check();
    let scenario = scenario.noting(noticed).noting(shared.and_then(|shared| shared.underground()));
    Ok((scenario, torques.places))
}
