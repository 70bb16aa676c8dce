//! What fails, what is allowed and what is known, from flags and files.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use clap::{Args, ValueEnum};
use polhode_robot::finding::Severity;
use polhode_robot::policy::baseline::{self, Baseline};
use polhode_robot::policy::config::Config;
use polhode_robot::policy::date::Date;
use polhode_robot::policy::{Judged, Policy};
use polhode_source::files::Disk;
use polhode_source::read_text_file;
use polhode_source::shown;

use super::outputs::Outputs;
use crate::failure::Failure;
use crate::partial;
use crate::stderr::tell;

/// The configuration that is read without being named.
const USUAL: &str = "polhode.toml";

/// Flags for what counts.
#[derive(Debug, Args)]
pub(super) struct PolicyFlags {
    /// The least severity that makes the exit status 1; suspect, if neither this nor polhode.toml says another.
    #[arg(long, value_enum, value_name = "SEVERITY")]
    fail_on: Option<Least>,
    /// Exit with 1 for notes too, such as a mesh that cannot be read: --fail-on note.
    #[arg(long, conflicts_with = "fail_on")]
    strict: bool,
    /// Severities of rules, what is allowed and what is left out, instead of ./polhode.toml.
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
    /// Findings that are known and do not fail, as --write-baseline has written them.
    #[arg(long, value_name = "FILE")]
    baseline: Option<PathBuf>,
    /// Write what is found as a baseline; findings do not fail then.
    #[arg(long, value_name = "FILE")]
    write_baseline: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Least {
    Impossible,
    Suspect,
    Note,
}

impl PolicyFlags {
    /// Where a baseline is written to.
    pub(super) fn baseline_out(&self) -> Option<&Path> {
        self.write_baseline.as_deref()
    }

    /// Refuses to write over what says what counts. A baseline is written anew in its place, with what it knows.
    pub(super) fn require_not_written(&self, outputs: &Outputs<'_>) -> Result<(), Failure> {
        outputs.require_not_read("the configuration", self.config_file().into_iter())?;
        let others = outputs.without("--write-baseline");
        others.require_not_read("the baseline", self.baseline.iter().map(PathBuf::as_path))
    }

    /// The configuration that is read, if any is.
    fn config_file(&self) -> Option<&Path> {
        self.config.as_deref().or_else(|| Some(Path::new(USUAL)).filter(|usual| usual.is_file()))
    }

    /// What counts, and the least severity that fails.
    pub(super) fn read(&self) -> Result<(Policy, Severity), Failure> {
        let config = match self.config_file() {
            Some(path) => read_text_file(&Disk, path, |text| Ok(Config::read(path, text)))??,
            None => Config::default(),
        };
        let baseline = match &self.baseline {
            Some(path) => Some(read_text_file(&Disk, path, |text| Ok(Baseline::read(path, text)))??),
            None => None,
        };
        let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
        let fail_on = match self.fail_on {
            _ if self.strict => Severity::Note,
            Some(Least::Impossible) => Severity::Impossible,
            Some(Least::Suspect) => Severity::Suspect,
            Some(Least::Note) => Severity::Note,
            None => config.fail_on.unwrap_or(Severity::Suspect),
        };
        Ok((Policy { config, baseline, today: Date::of_days(seconds / 86_400) }, fail_on))
    }

    /// Writes a baseline of these files, if that is asked for; whether it was.
    pub(super) fn write_baseline<'a>(
        &self,
        judged: impl Iterator<Item = (&'a str, &'a Judged)>,
        force: bool,
    ) -> Result<bool, Failure> {
        let Some(path) = &self.write_baseline else { return Ok(false) };
        let (text, count) = baseline::text(judged);
        partial::write(path, force, |file| file.write_all(text.as_bytes()))?;
        let noun = if count == 1 { "finding" } else { "findings" };
        tell(&format!("wrote {}: {count} {noun}, known from now on with --baseline\n", shown(path)));
        Ok(true)
    }
}
