//! `polhode check`

mod files;
mod fix;
mod output;
mod outputs;
mod parallel;
mod policy;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::{ArgGroup, Args, ValueEnum};
use polhode_robot::finding::Finding;
use polhode_robot::geometry::{Shapes, mesh_files};
use polhode_robot::inspect::{Inspection, inspect_for};
use polhode_robot::model::RobotModel;
use polhode_robot::policy::{Judged, Policy};
use polhode_robot::program::Program;
use polhode_robot::read::{CheckedFolder, ReadOptions, read_model, read_text};
use polhode_robot::repair::proved;
use polhode_robot::report::{CheckReport, Prospect};
use polhode_robot::rule::{list, rule, rules};
use polhode_source::FormatError;
use polhode_source::files::Disk;

use crate::failure::Failure;
use crate::progress::FileProgress;
use crate::stderr::tell;
use crate::stdout::print;
use files::{Unread, name, real_name};
use fix::FixFlags;
use output::{Outcome, OutputFlags, Results};
use outputs::Outputs;
use polhode_source::shown;
use policy::PolicyFlags;

/// Are the inertias of a robot or simulation model right? URDF, SDF, MJCF, USD, OpenSim.
///
/// Impossible: these numbers are unphysical. Suspect: a body may, but hardly this link, by its own
/// geometry. Each finding says where, by which rule, and the fix, if exactly one is consistent with
/// all evidence. Folders are searched for .urdf, .sdf, .world, .usda and .osim files, and for .xml
/// files that are models. What is allowed is in polhode.toml, in a baseline, or in the model:
/// <!-- polhode: allow RULE: REASON -->.
///
/// Exit status: 0 nothing impossible or suspect, 1 something is, 2 a file cannot be read.
#[derive(Debug, Args)]
#[command(
    group = ArgGroup::new("written").args(["out", "output", "write_baseline"]).multiple(true),
    after_help = "\
Examples:
  polhode check robot.urdf
  polhode check robot.urdf --table
  polhode check robot.urdf --fix | patch -p1
  polhode check robot.urdf --fix robot-fixed.urdf
  polhode check src/ --root src --json | jq '.[].findings[]'
  polhode check world.sdf --root models --strict
  polhode check robot.urdf --for mujoco --for drake
  polhode check src/ --fail-on impossible --format sarif --output check.sarif
  polhode check src/ --write-baseline known.json
  polhode check src/ --baseline known.json
  polhode check --explain inertia.triangle"
)]
pub(crate) struct Check {
    /// Models, and folders to search for them.
    #[arg(required_unless_present_any = ["explain", "out"], value_name = "FILE")]
    files: Vec<PathBuf>,
    /// A folder that holds packages, for package:// and model://; may be repeated. No mesh is
    /// opened outside of these, the folders that are checked, the model's own and an ancestor
    /// folder with the package's name.
    #[arg(long = "root", value_name = "DIR")]
    roots: Vec<PathBuf>,
    /// Program that has to accept the models; may be repeated. A link that it refuses, such as a
    /// moving one without mass, is an error instead of a note.
    #[arg(long = "for", value_enum, value_name = "PROGRAM")]
    programs: Vec<ForProgram>,
    #[command(flatten)]
    output: OutputFlags,
    #[command(flatten)]
    policy: PolicyFlags,
    #[command(flatten)]
    fix: FixFlags,
    /// Print what a rule asks, why, how to mend what breaks it, and an example; without CODE all rules, a line each.
    #[arg(long, value_name = "CODE", num_args = 0..=1, conflicts_with_all = [
        "files", "roots", "programs", "json", "table", "format", "output", "fail_on", "strict", "config", "baseline", "write_baseline", "out", "force",
    ])]
    explain: Option<Option<String>>,
}

/// A program that reads models.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum ForProgram {
    Mujoco,
    Gazebo,
    Drake,
    Isaac,
}

impl From<ForProgram> for Program {
    fn from(program: ForProgram) -> Self {
        match program {
            ForProgram::Mujoco => Self::Mujoco,
            ForProgram::Gazebo => Self::Gazebo,
            ForProgram::Drake => Self::Drake,
            ForProgram::Isaac => Self::Isaac,
        }
    }
}

impl Check {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if let Some(code) = &self.explain {
            return explain(code.as_deref());
        }
        polhode_source::file::require_folders(&Disk, &self.roots)?;
        self.fix.require_models(&self.files)?;
        let (policy, fail_on) = self.policy.read()?;
        let found = files::models(&self.files);
        let named: Vec<PathBuf> = found.iter().filter_map(|input| input.as_ref().ok()).cloned().collect();
        let one = matches!(self.files.as_slice(), [file] if !file.is_dir());
        let is_excluded = |path: &Path| policy.config.exclude.iter().any(|glob| glob.matches(&name(path)));
        let count = found.len();
        let inputs: Vec<Result<PathBuf, Unread>> =
            found.into_iter().filter(|input| !input.as_ref().is_ok_and(|path| is_excluded(path))).collect();
        let excluded = count - inputs.len();
        let models: Vec<&Path> = inputs.iter().filter_map(|input| input.as_deref().ok()).collect();
        self.fix.require_one(models.len())?;
        let target = self.fix.file();
        self.output.require_no_other_form(self.fix.is_given())?;
        self.output.require_no_table(self.fix.is_diff())?;
        let outputs = self.outputs();
        outputs.require_not_read("the model itself", named.iter().map(PathBuf::as_path))?;
        self.policy.require_not_written(&outputs)?;
        outputs.require_places()?;

        let folders: Vec<_> =
            self.files.iter().filter_map(|file| CheckedFolder::new(&Disk, file)).map(Arc::new).collect();
        let reading = |path: &Path| self.reading(&folders, path);
        let read = |input: Result<PathBuf, Unread>| match input {
            Ok(path) => {
                let model = read_model(&path, &reading(&path));
                Input { model: model.map_err(|error| Failure::from(error).about(&path)), path }
            }
            Err(Unread { path, failure }) => Input { path, model: Err(failure) },
        };
        let inputs = side_by_side(inputs, read, |input| match input {
            Ok(path) | Err(Unread { path, .. }) => path,
        });
        // All meshes before the models: these would wait for each other where they have meshes in common.
        let meshes = mesh_files(&Disk, inputs.iter().filter_map(|input| input.model.as_ref().ok()));
        let shapes = Shapes::with_threads((parallel::threads() / meshes.len().max(1)).max(1));
        side_by_side(meshes, |mesh| shapes.read_ahead(&mesh), PathBuf::as_path);
        let outcome = |Input { path, model }: Input| Outcome {
            report: model.and_then(|model| {
                self.report(&path, model, target, (&shapes, &policy, &reading(&path)))
                    .map_err(|failure| failure.about(&path))
            }),
            path,
        };
        let outcomes = side_by_side(inputs, outcome, |input| &input.path);
        for Outcome { path, report } in &outcomes {
            match report {
                Ok(report) => outputs.require_not_part_of(&report.model)?,
                Err(failure) => outputs.require_not_named(path, failure)?,
            }
        }

        let judged: Vec<(String, &Judged)> = outcomes
            .iter()
            .filter_map(|outcome| Some((name(&outcome.path), &outcome.report.as_ref().ok()?.judged)))
            .collect();
        let judged = || judged.iter().map(|(file, judged)| (file.as_str(), *judged));
        let remarks = policy.remarks(judged(), |file| Path::new(file).exists());
        let results = Results { outcomes: &outcomes, one, excluded, remarks: &remarks, fail_on };
        if self.fix.is_diff() && !self.output.is_json() {
            self.output.write_diff(&results)?;
        } else {
            self.output.announce(&results)?;
            if let (Some(target), [Outcome { report: Ok(report), .. }]) = (target, outcomes.as_slice()) {
                fix::write(report, target, self.fix.force)?;
            }
            self.output.write(&results, self.fix.force)?;
        }

        let fails = |findings: &[Finding]| findings.iter().any(|finding| finding.severity >= fail_on);
        // A diff repairs nothing yet.
        let remaining = |report: &CheckReport| match report.fixed.as_ref().filter(|fixed| fixed.out.is_some())
        {
            Some(fixed) => fails(&fixed.remaining),
            None => fails(report.findings()),
        };
        let mut found =
            remarks.iter().any(|remark| remark.severity.is_some_and(|severity| severity >= fail_on))
                || outcomes.iter().filter_map(|outcome| outcome.report.as_ref().ok()).any(remaining);
        if outcomes.iter().all(|outcome| outcome.report.is_ok()) {
            found &= !self.policy.write_baseline(judged(), self.fix.force)?;
        } else if let Some(path) = self.policy.baseline_out() {
            tell(&format!("{} is not written: not all files could be read\n", shown(path)));
        }
        let mut failures: Vec<Failure> =
            outcomes.into_iter().filter_map(|outcome| outcome.report.err()).collect();
        if found {
            failures.push(Failure::Findings);
        }
        Failure::unless_empty(failures)
    }

    /// What is found in a file, and repaired if that is asked for.
    fn report(
        &self,
        file: &Path,
        model: RobotModel,
        out: Option<&Path>,
        by: (&Shapes<'_>, &Policy, &ReadOptions<'_>),
    ) -> Result<CheckReport, Failure> {
        let (shapes, policy, _) = by;
        let Inspection { geometry, findings } = inspect_for(&model, shapes, &self.programs());
        let judged = judge(policy, file, &model, findings);
        let mut report = CheckReport::new(model, geometry, judged);
        let check = |text: &str| self.findings_in(text, file, by);
        if self.fix.is_given() {
            return fix::fixed(report, out, check);
        }
        if report.findings().iter().any(|finding| finding.repair.is_some()) {
            let fixed = proved(&report.model, report.findings(), check);
            report.prospect = fixed.ok().map(|(repaired, remaining)| Prospect::of(&repaired, &remaining));
        }
        Ok(report)
    }

    /// What is found in a text in place of the file's.
    fn findings_in(
        &self,
        text: &str,
        file: &Path,
        (shapes, policy, reading): (&Shapes<'_>, &Policy, &ReadOptions<'_>),
    ) -> Result<Vec<Finding>, FormatError> {
        let model = read_text(text, file, reading)?;
        let findings = inspect_for(&model, shapes, &self.programs()).findings;
        Ok(judge(policy, file, &model, findings).open)
    }

    /// What is written, in the order in which it is.
    fn outputs(&self) -> Outputs<'_> {
        let options = [
            ("--fix", self.fix.file()),
            ("--output", self.output.file()),
            ("--write-baseline", self.policy.baseline_out()),
        ];
        Outputs::new(options, self.fix.force)
    }

    fn programs(&self) -> Vec<Program> {
        self.programs.iter().copied().map(Program::from).collect()
    }

    /// Options for a model, with the folder of the command line that it was found in.
    fn reading(&self, folders: &[Arc<CheckedFolder>], path: &Path) -> ReadOptions<'_> {
        let checked = folders.iter().find(|folder| folder.names(path)).cloned();
        ReadOptions { roots: self.roots.clone(), checked, ..ReadOptions::default() }
    }
}

/// A file that is named, or found in a folder.
struct Input {
    path: PathBuf,
    model: Result<RobotModel, Failure>,
}

/// What comes of each item, on all threads; how far that is, is shown by their files.
fn side_by_side<I: Send, T: Send>(
    items: Vec<I>,
    work: impl Fn(I) -> T + Sync,
    file: impl Fn(&I) -> &Path,
) -> Vec<T> {
    let files: Vec<PathBuf> = items.iter().map(|item| file(item).to_owned()).collect();
    let mut progress = FileProgress::new(files.len());
    let done = |k: usize| files.get(k).into_iter().for_each(|file| progress.next(file));
    parallel::map(items, parallel::threads(), work, done)
}

/// The file itself is called as it is named.
fn judge(policy: &Policy, file: &Path, model: &RobotModel, findings: Vec<Finding>) -> Judged {
    policy.judge(|path| if path == file { name(path) } else { real_name(path) }, model, findings)
}

/// A rule, or all of them.
fn explain(code: Option<&str>) -> Result<(), Failure> {
    let Some(code) = code else { return print(&list()) };
    match rule(code) {
        Some(rule) => print(&rule.to_text()),
        None => {
            let meant = polhode_source::nearest(code, rules().map(|rule| rule.code));
            let meant = meant.map_or(String::new(), |meant| format!("did you mean {meant}? "));
            Err(Failure::usage(
                format!("there is no rule {code}"),
                format!("{meant}--explain alone lists all rules"),
            ))
        }
    }
}
