//! Runs a check request.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use polhode_source::files::Files;
use polhode_source::{Failure, FormatError, read_text_file, shown};

use crate::checked::{Checked, FileChecked};
use crate::finding::{Finding, Severity};
use crate::found::{Found, Names, is_folder, models};
use crate::geometry::{Shapes, mesh_files};
use crate::inspect::{Inspection, inspect_for};
use crate::model::RobotModel;
use crate::parallel;
use crate::policy::baseline::Baseline;
use crate::policy::config::Config;
use crate::policy::{Judged, Policy};
use crate::read::{CheckedFolder, ReadOptions, read_model, read_text};
use crate::repair::proved;
use crate::report::{CheckReport, Fixed, Prospect};
use crate::request::Request;

/// Default path of the configuration.
const USUAL: &str = "polhode.toml";

/// Checks the models of a request.
///
/// A model that cannot be read has its failure in the result.
///
/// # Errors
/// [`Failure`] if a root is not a folder, or if a configuration or baseline cannot be read.
pub fn run(request: &Request, files: &dyn Files) -> Result<Checked, Failure> {
    Ok(Inputs::find(request, files)?.check(&mut ()))
}

/// Progress of a check: models are read, then their meshes are measured, then the models are
/// checked.
pub trait Progress {
    /// Starts a stage with `count` files.
    fn begin(&mut self, count: usize);
    /// Reports that one file is done.
    fn done(&mut self, file: &Path);
}

impl Progress for () {
    fn begin(&mut self, _: usize) {}
    fn done(&mut self, _: &Path) {}
}

/// Models of a request, found but not yet read.
#[derive(Debug)]
pub struct Inputs<'a> {
    request: &'a Request,
    files: &'a dyn Files,
    names: Names<'a>,
    policy: Policy,
    config: Option<PathBuf>,
    found: Vec<Found>,
    excluded: Vec<PathBuf>,
    repeated: Vec<[PathBuf; 2]>,
}

impl<'a> Inputs<'a> {
    /// Reads the configuration and the baseline, and searches the folders.
    ///
    /// # Errors
    /// [`Failure`], as for [`run`].
    pub fn find(request: &'a Request, files: &'a dyn Files) -> Result<Self, Failure> {
        polhode_source::file::require_folders(files, &request.roots)?;
        let usual = || Some(PathBuf::from(USUAL)).filter(|usual| files.is_file(usual));
        let config = request.config.clone().or_else(usual);
        if let Some(path) =
            config.iter().chain(&request.baseline).next().filter(|_| !cfg!(feature = "languages"))
        {
            let message =
                format!("{} is a configuration or a baseline, which this build does not read", shown(path));
            return Err(Failure::usage(message, ""));
        }
        let policy = Policy {
            config: match &config {
                Some(path) if cfg!(feature = "languages") => {
                    read_text_file(files, path, |text| Ok(Config::read(path, text)))??
                }
                _ => Config::default(),
            },
            baseline: match &request.baseline {
                Some(path) if cfg!(feature = "languages") => {
                    Some(read_text_file(files, path, |text| Ok(Baseline::read(path, text)))??)
                }
                _ => None,
            },
            today: request.today.unwrap_or_default(),
        };
        let names = Names::new(files);
        let (found, repeated) = models(files, &request.files);
        let is_excluded = |input: &mut Found| {
            let is_in = |path: &PathBuf| {
                let name = names.of(path);
                policy.config.exclude.iter().any(|glob| glob.matches(&name))
            };
            input.as_ref().is_ok_and(is_in)
        };
        let mut found = found;
        let excluded = found.extract_if(.., is_excluded).filter_map(Result::ok).collect();
        Ok(Self { request, files, names, policy, config, found, excluded, repeated })
    }

    /// Returns the models that are checked.
    pub fn models(&self) -> impl Iterator<Item = &Path> {
        self.found.iter().filter_map(|input| input.as_deref().ok())
    }

    /// Returns the models that the configuration excludes.
    pub fn excluded(&self) -> impl Iterator<Item = &Path> {
        self.excluded.iter().map(PathBuf::as_path)
    }

    /// Returns repeated names of files, each with the name under which the file is checked.
    pub fn repeated(&self) -> &[[PathBuf; 2]] {
        &self.repeated
    }

    /// Returns the path of the configuration that was read.
    pub fn config(&self) -> Option<&Path> {
        self.config.as_deref()
    }

    /// Reads and checks the models on all threads.
    pub fn check(mut self, progress: &mut dyn Progress) -> Checked {
        let request = self.request;
        let is_one = matches!(request.files.as_slice(), [file] if !is_folder(self.files, file));
        let folders = request.files.iter().filter_map(|file| CheckedFolder::new(self.files, file));
        let folders: Vec<Arc<CheckedFolder>> = folders.map(Arc::new).collect();
        let reading = |path: &Path| ReadOptions {
            files: self.files,
            roots: request.roots.clone(),
            checked: folders.iter().find(|folder| folder.names(path)).cloned(),
            confined: false,
        };
        let read = |input: Found| match input {
            Ok(path) => {
                let model = read_model(&path, &reading(&path));
                (model.map_err(|error| Failure::from(error).in_file(&path)), path)
            }
            Err((path, failure)) => (Err(failure), path),
        };
        let found = std::mem::take(&mut self.found);
        let inputs = side_by_side(found, progress, read, |input| match input {
            Ok(path) | Err((path, _)) => path,
        });
        // All meshes are measured before the models are checked. Otherwise models with common
        // meshes would wait for each other.
        let meshes = mesh_files(self.files, inputs.iter().filter_map(|(model, _)| model.as_ref().ok()));
        let threads = (parallel::threads() / meshes.len().max(1)).max(1);
        let shapes = Shapes::with_threads(threads).from_files(self.files);
        side_by_side(meshes, progress, |mesh| shapes.read_ahead(&mesh), PathBuf::as_path);
        let outcome = |(model, path): (Result<RobotModel, Failure>, PathBuf)| FileChecked {
            name: self.names.of(&path),
            report: model.and_then(|model| {
                let failed = |failure: Failure| failure.in_file(&path);
                self.report(&path, model, &shapes, &reading(&path)).map_err(failed)
            }),
            path,
        };
        let outcomes = side_by_side(inputs, progress, outcome, |(_, path)| path);
        let judged = outcomes.iter().filter_map(FileChecked::judged);
        let remarks = self.policy.remarks(judged, |file| self.files.look(Path::new(file)).is_ok());
        let fail_on = match request.fail_on {
            _ if request.strict => Severity::Note,
            Some(severity) => severity,
            None => self.policy.config.fail_on.unwrap_or(Severity::Suspect),
        };
        let excluded = self.excluded.len();
        Checked { files: outcomes, is_one, excluded, remarks, fail_on, command: "polhode check" }
    }

    /// Checks a model, and fixes it if requested.
    fn report(
        &self,
        file: &Path,
        model: RobotModel,
        shapes: &Shapes<'_>,
        reading: &ReadOptions<'_>,
    ) -> Result<CheckReport, Failure> {
        let found = inspect_for(&model, shapes, &self.request.programs);
        let found = if self.request.nearest { found } else { found.without_nearest() };
        let Inspection { geometry, findings } = found;
        let judged = self.judge(file, &model, findings);
        let mut report = CheckReport::new(model, geometry, judged);
        let has_repairs = report.findings().iter().any(|finding| finding.repair.is_some());
        if self.request.fix {
            report.model.require_text("nothing is fixed")?;
        } else if !has_repairs {
            return Ok(report);
        }
        // The fixed text is read and checked as a model. A fix that does not remove its finding is
        // left out.
        let check = |text: &str| {
            let model = read_text(text, file, reading)?;
            let findings = inspect_for(&model, shapes, &self.request.programs).findings;
            Ok(self.judge(file, &model, findings).open)
        };
        let fixed = proved(&report.model, report.findings(), check);
        if self.request.fix {
            let (repaired, remaining) = fixed.map_err(|error| unreadable(&error))?;
            let name = self.names.real(&report.model.path);
            let name = if report.model.expansion.is_some() { format!("{name} (expanded)") } else { name };
            let diff = repaired.diff(&report.model, report.findings(), &name);
            report.fixed = Some(Fixed { out: None, repaired, diff, remaining });
        } else {
            report.prospect = fixed.ok().map(|(repaired, remaining)| Prospect::of(&repaired, &remaining));
        }
        Ok(report)
    }

    /// Judges the findings of a model. The model file keeps the name given by the user.
    fn judge(&self, file: &Path, model: &RobotModel, findings: Vec<Finding>) -> Judged {
        let name = |path: &Path| if path == file { self.names.of(path) } else { self.names.real(path) };
        self.policy.judge(name, model, findings)
    }
}

fn unreadable(error: &FormatError) -> Failure {
    Failure::usage(
        format!("the fixed model could not be read again, so it was not written: {}", error.message()),
        "this is a bug in polhode: please report it, with the model",
    )
}

/// Returns the result for each item, computed on all threads, and reports their files to
/// `progress`.
fn side_by_side<I: Send, T: Send>(
    items: Vec<I>,
    progress: &mut dyn Progress,
    work: impl Fn(I) -> T + Sync,
    file: impl Fn(&I) -> &Path,
) -> Vec<T> {
    let files: Vec<PathBuf> = items.iter().map(|item| file(item).to_owned()).collect();
    progress.begin(files.len());
    let done = |k: usize| files.get(k).into_iter().for_each(|file| progress.done(file));
    parallel::map(items, parallel::threads(), work, done)
}
