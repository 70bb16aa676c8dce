//! `polhode check`

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use clap::{ArgGroup, Args};
use polhode_document::Report as _;
use polhode_document::layout::printable_lines;
use polhode_robot::policy::date::Date;
use polhode_robot::report::CheckReport;
use polhode_robot::rule::{list, rule, rules};
use polhode_robot::{Checked, Format, Inputs, Progress, Request};
use polhode_source::shown;

use crate::failure::Failure;
use crate::outputs::Outputs;
use crate::partial;
use crate::progress::FileProgress;
use crate::stderr::tell;
use crate::stdout::{print, print_exact};
use crate::xacro::{XacroFlags, require_not_expanded};

/// Check the inertias of a robot or simulation model: URDF, SDF, MJCF, USD, OpenSim.
///
/// Impossible: no body has these numbers. Suspect: physically possible, but in conflict with the
/// link's own geometry. Each finding states its place, the rule and the fix, if exactly one fix is
/// consistent with all evidence. Folders are searched for .urdf, .sdf, .world, .usd* and .osim
/// files, and for .xml files that are models. To allow findings, use polhode.toml, a baseline, or a
/// comment in the model: <!-- polhode: allow RULE: REASON -->.
///
/// Exit status: 0 no impossible or suspect finding, 1 at least one, 2 a file cannot be read.
#[derive(Debug, Args)]
#[command(
    group = ArgGroup::new("written").args(["out", "output", "write_baseline"]).multiple(true),
    after_help = "\
Examples:
  polhode check robot.urdf
  polhode check robot.urdf --table
  polhode check robot.urdf --nearest
  polhode check robot.urdf --html > robot.html
  polhode check robot.urdf --fix | patch -p1
  polhode check robot.urdf --fix robot-fixed.urdf
  polhode check src/ --root src --json | jq '.[].findings[]'
  polhode check world.sdf --root models --strict
  polhode check robot.urdf --for mujoco --for drake
  polhode check robot.urdf.xacro --xacro --xacro-arg prefix:=left_
  polhode check src/ --fail-on impossible --format sarif --output check.sarif
  polhode check src/ --write-baseline known.json
  polhode check src/ --baseline known.json
  polhode check --explain inertia.triangle"
)]
pub(crate) struct Check {
    #[command(flatten)]
    request: Request,
    #[command(flatten)]
    xacro: XacroFlags,
    #[command(flatten)]
    form: Form,
    /// Write the results to FILE, completely or not at all, and print nothing.
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Write all findings to a baseline; the findings then do not fail.
    #[arg(long, value_name = "FILE")]
    write_baseline: Option<PathBuf>,
    /// Print the diff of all fixes that are the only consistent ones, with the evidence above each,
    /// and write nothing. With OUT, also write the fixed model to OUT. All other bytes stay
    /// unchanged.
    #[arg(long = "fix", value_name = "OUT", num_args = 0..=1, conflicts_with_all = ["baseline", "write_baseline"])]
    out: Option<Option<PathBuf>>,
    /// Replace existing output files of --fix, --output and --write-baseline; never the model
    /// itself.
    #[arg(long, requires = "written")]
    force: bool,
    /// Print a rule with its reason, fix and example; without CODE, list all rules, one per line.
    #[arg(long, value_name = "CODE", num_args = 0..=1, conflicts_with_all = [
        "files", "roots", "programs", "nearest", "xacro", "xacro_args", "json", "table", "html", "format", "output", "fail_on", "strict", "config", "baseline", "write_baseline", "out", "force",
    ])]
    explain: Option<Option<String>>,
}

/// Options for the output format.
#[derive(Debug, Args)]
struct Form {
    /// Output format.
    #[arg(long, value_enum, value_name = "FORM", conflicts_with_all = ["json", "table", "html"])]
    format: Option<Format>,
    /// Print JSON: one object for one file, an array for several or for a folder.
    #[arg(long)]
    json: bool,
    /// Print a table with one line per link: mass, centre, principal moments, equivalent box,
    /// density, verdict.
    #[arg(long, conflicts_with_all = ["json", "nearest"])]
    table: bool,
    /// Print a self-contained HTML page with the findings and all links.
    #[arg(long, conflicts_with_all = ["json", "table"])]
    html: bool,
}

impl Form {
    fn format(&self) -> Format {
        match self {
            Self { json: true, .. } => Format::Json,
            Self { table: true, .. } => Format::Table,
            Self { html: true, .. } => Format::Html,
            Self { format, .. } => format.unwrap_or_default(),
        }
    }
}

impl Check {
    pub(crate) fn run(mut self) -> Result<(), Failure> {
        if let Some(code) = &self.explain {
            return explain(code.as_deref());
        }
        self.require_models()?;
        let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
        self.request.today = Some(Date::of_days(seconds / 86_400));
        self.request.fix = self.out.is_some();
        let files = self.xacro.expand(&self.request.files)?;
        if self.fixed().is_some() {
            require_not_expanded(&files, "--fix")?;
        }
        let inputs = Inputs::find(&self.request, &files)?;
        for [again, first] in inputs.repeated() {
            tell(&format!("{} is the same file as {}; it is checked once\n", shown(again), shown(first)));
        }
        self.require_fix_fits(inputs.models().count())?;
        let outputs = self.outputs();
        outputs.require_not_read("the model itself", inputs.models().chain(inputs.excluded()))?;
        outputs.require_not_read("the configuration", inputs.config().into_iter())?;
        // A baseline may be replaced only by one that includes its findings.
        let known = self.request.baseline.iter().map(PathBuf::as_path);
        outputs.without("--write-baseline").require_not_read("the baseline", known)?;
        outputs.require_places()?;
        let checked = inputs.check(&mut FileProgress::new(0));
        for file in &checked.files {
            match &file.report {
                Ok(report) => outputs.require_not_part_of(&report.model)?,
                Err(failure) => outputs.require_not_named(&file.path, failure)?,
            }
        }
        self.write(checked)
    }

    /// Writes and prints the results.
    fn write(&self, mut checked: Checked) -> Result<(), Failure> {
        let form = self.form.format();
        let diff = if form == Format::Json { String::new() } else { checked.to_diff() };
        if matches!(self.out, Some(None)) && form != Format::Json {
            for file in &checked.files {
                let left = file.report.as_ref().map_or_else(|_| String::new(), CheckReport::not_repaired);
                if !left.is_empty() {
                    tell(&format!("{}\n{left}", shown(&file.path)));
                }
            }
            tell(checked.about_policy().trim_start());
            match &self.output {
                Some(path) => partial::write(path, false, |file| file.write_all(diff.as_bytes()))?,
                None => print_exact(&diff)?,
            }
        } else {
            if self.output.is_none() && !diff.is_empty() {
                print(&format!("{diff}\n"))?;
            }
            if let Some(out) = self.fixed() {
                if let Some(fix) = checked.fixes().next() {
                    partial::write(out, self.force, |file| file.write_all(fix.new.as_bytes()))?;
                }
                checked = checked.with_fix_in(out);
            }
            tell(&checked.left_out_of(form));
            let text = checked.to_form(form);
            match &self.output {
                Some(path) => {
                    let gap = if diff.is_empty() { "" } else { "\n" };
                    let text = printable_lines(&format!("{diff}{gap}{text}"));
                    partial::write(path, self.force, |file| file.write_all(text.as_bytes()))?;
                }
                None => print(&text)?,
            }
        }
        let mut has_failed = checked.has_failed();
        if let Some(path) = &self.write_baseline {
            if checked.files.iter().all(|file| file.report.is_ok()) {
                let (text, count) = checked.to_baseline();
                partial::write(path, self.force, |file| file.write_all(text.as_bytes()))?;
                let noun = if count == 1 { "finding" } else { "findings" };
                tell(&format!(
                    "wrote {}: {count} {noun}, ignored from now on with --baseline\n",
                    shown(path)
                ));
                has_failed = false;
            } else {
                tell(&format!("{} is not written, because some files could not be read\n", shown(path)));
            }
        }
        let mut failures: Vec<Failure> =
            checked.files.into_iter().filter_map(|file| file.report.err()).map(Failure::from).collect();
        failures.extend(has_failed.then_some(Failure::Findings));
        Failure::unless_empty(failures)
    }

    /// Returns the file for the fixed model, if one is named.
    fn fixed(&self) -> Option<&Path> {
        self.out.as_ref()?.as_deref()
    }

    /// Returns the output files in the order in which they are written.
    fn outputs(&self) -> Outputs<'_> {
        let options = [
            ("--fix", self.fixed()),
            ("--output", self.output.as_deref()),
            ("--write-baseline", self.write_baseline.as_deref()),
        ];
        Outputs::new(options, self.force)
    }

    /// Requires a model before `--fix`, which would take the file after it as its output.
    fn require_models(&self) -> Result<(), Failure> {
        match self.fixed() {
            Some(out) if self.request.files.is_empty() => Err(Failure::usage(
                format!("no model is named: {} is the output file of --fix", shown(out)),
                format!("name the model first: polhode check {} --fix", shown(out)),
            )),
            _ => Ok(()),
        }
    }

    /// Refuses one output file for several models, `--force` without a file, and a format without
    /// fixes.
    fn require_fix_fits(&self, models: usize) -> Result<(), Failure> {
        let (message, hint) = match (&self.out, self.form.format()) {
            (None, _) => return Ok(()),
            (Some(None), _) if self.force => (
                "--fix without a file writes nothing, so --force has no effect".to_owned(),
                "name the output file, or delete --force",
            ),
            (Some(Some(_)), _) if models != 1 => {
                (format!("--fix writes one model, but {models} are named"), "fix them one by one")
            }
            (Some(None), Format::Text) if self.request.nearest => (
                "--fix without a file prints a diff, which has no nearest tensors".to_owned(),
                "delete one of the two, or name the output file after --fix",
            ),
            (Some(None), Format::Table) => (
                "--fix without a file prints a diff, but --table prints a table".to_owned(),
                "delete one of the two, or name the output file after --fix",
            ),
            (Some(_), Format::Text | Format::Json | Format::Table) => return Ok(()),
            (Some(_), _) => {
                let option = if self.form.html { "--html" } else { "--format" };
                let message = format!(
                    "--fix reports as text, as a table or as JSON, but {option} requests another format"
                );
                (message, "write the fixed model first, then check it in that format")
            }
        };
        Err(Failure::usage(message, hint))
    }
}

impl Progress for FileProgress {
    fn begin(&mut self, count: usize) {
        *self = Self::new(count);
    }

    fn done(&mut self, file: &Path) {
        self.next(file);
    }
}

/// Prints one rule, or all rules.
fn explain(code: Option<&str>) -> Result<(), Failure> {
    let Some(code) = code else { return print(&list()) };
    match rule(code) {
        Some(rule) => print(&rule.to_text()),
        None => {
            let meant = polhode_source::nearest(code, rules().map(|rule| rule.code));
            let meant = meant.map_or(String::new(), |meant| format!("did you mean {meant}? "));
            Err(Failure::usage(
                format!("unknown rule {code}"),
                format!("{meant}--explain alone lists all rules"),
            ))
        }
    }
}
