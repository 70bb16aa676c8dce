//! `polhode new`

use std::io::Write as _;
use std::path::PathBuf;

use clap::{Args, ValueEnum};

use polhode_source::shown;

use crate::failure::Failure;
use crate::page::check_file;
use crate::partial;
use crate::stdout::print;

/// Write an example scenario to start from.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode new top
  polhode new satellite -o missions/first.toml")]
pub(crate) struct New {
    /// Example to write.
    #[arg(value_enum)]
    starter: Starter,
    /// Output file [default: NAME.toml in the working directory].
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Scenario template.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Starter {
    /// Quadrotor built from its parts, tumbling.
    Drone,
    /// Spinning top on its tip.
    Top,
    /// Satellite in orbit, with a momentum wheel.
    Satellite,
    /// Tumbling asteroid.
    Asteroid,
    /// Robot link, for URDF and similar formats.
    RobotLink,
}

impl Starter {
    const fn text(self) -> &'static str {
        match self {
            Self::Drone => include_str!("new/drone.toml"),
            Self::Top => include_str!("new/top.toml"),
            Self::Satellite => include_str!("new/satellite.toml"),
            Self::Asteroid => include_str!("new/asteroid.toml"),
            Self::RobotLink => include_str!("new/robot-link.toml"),
        }
    }

    const fn file(self) -> &'static str {
        match self {
            Self::Drone => "drone.toml",
            Self::Top => "top.toml",
            Self::Satellite => "satellite.toml",
            Self::Asteroid => "asteroid.toml",
            Self::RobotLink => "robot-link.toml",
        }
    }
}

impl New {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let file = self.output.unwrap_or_else(|| PathBuf::from(self.starter.file()));
        check_file(&file, false)?;
        if let Some(folder) = file.parent() {
            std::fs::create_dir_all(folder).map_err(|error| partial::output(&file, error))?;
        }
        // The commands in the file refer to the file by its actual name.
        let text = self.starter.text().replace(self.starter.file(), &file.display().to_string());
        partial::write(&file, false, |out| out.write_all(text.as_bytes()))?;
        let name = shown(&file);
        print(&format!("wrote {name}; edit it, then run\n  polhode simulate {name} --open\n"))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may")]

    use std::path::Path;

    use polhode_scenario::read as scenario;

    use super::*;

    /// A starter runs unchanged, and also with the keys in its comments enabled.
    #[test]
    fn every_starter_runs_and_so_does_what_it_suggests() {
        for starter in Starter::value_variants() {
            let read = |text: &str| scenario::parse(text, Path::new(starter.file()));
            let scenario = read(starter.text()).unwrap();
            assert!(scenario.findings().is_empty(), "{starter:?}: {:?}", scenario.findings());
            assert!(scenario.simulate().unwrap().unwrap().ending().is_complete());
            // Comment lines that contain only keys and tables.
            let is_code = |line: &str| {
                let rest = line.strip_prefix("# ");
                rest.is_some_and(|rest| {
                    rest.starts_with(['[', ']'])
                        || rest.starts_with("    {")
                        || rest.contains(" = ") && !rest.contains(':') && !rest.starts_with(' ')
                })
            };
            let uncommented: Vec<&str> = starter
                .text()
                .lines()
                .map(|line| if is_code(line) { line.trim_start_matches("# ") } else { line })
                .collect();
            if uncommented.join("\n") != starter.text().trim_end() {
                read(&uncommented.join("\n")).unwrap();
            }
        }
    }
}
