//! `polhode new`

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use polhode_source::shown;

use crate::failure::Failure;
use crate::partial;
use crate::stdout::print;

/// Write an example file to start from, or list the examples.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode new
  polhode new top
  polhode new satellite -o missions/first.toml")]
pub(crate) struct New {
    /// Example to write; without one, all are listed with the command to run next.
    #[arg(value_enum)]
    starter: Option<Starter>,
    /// Output file [default: NAME with its extension, in the working directory].
    #[arg(short, long, value_name = "FILE", requires = "starter")]
    output: Option<PathBuf>,
}

/// Example that `polhode new` can write.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Starter {
    /// Table-tennis bat that flips in flight.
    Bat,
    /// Cube about its corner, in symbols.
    Cube,
    /// Spinning top on its tip.
    Top,
    /// Quadrotor built from its parts, tumbling.
    Drone,
    /// Long satellite, spinning about its axis.
    Pencil,
    /// Satellite in orbit, with a momentum wheel.
    Satellite,
    /// Tumbling asteroid.
    Asteroid,
    /// Chaotic moon on an eccentric orbit.
    Moon,
    /// Robot link, for URDF and similar formats.
    RobotLink,
    /// URDF of a gripper, with two mistakes.
    #[cfg(feature = "robot")]
    Gripper,
    /// Molecule as XYZ: formic acid.
    Molecule,
    /// Parts list with uncertainties and limits.
    #[cfg(feature = "budget")]
    Parts,
    /// Log of a physics engine, and its body.
    #[cfg(feature = "judge")]
    Log,
    /// Monte Carlo sweep of a thrown book.
    #[cfg(feature = "sweep")]
    Sweep,
}

/// File of a starter. Its name in `text` and `next` stands for the actual name.
struct Template {
    file: &'static str,
    text: &'static str,
    /// Command to run next.
    next: &'static str,
    /// Name and text of a file that this one refers to.
    companion: Option<(&'static str, &'static str)>,
}

macro_rules! template {
    ($file:literal, $next:literal) => {
        Template { file: $file, text: include_str!(concat!("new/", $file)), next: $next, companion: None }
    };
}

impl Starter {
    const fn template(self) -> Template {
        match self {
            Self::Bat => template!("bat.toml", "polhode simulate bat.toml --open"),
            Self::Cube => template!("cube.toml", "polhode explain cube.toml"),
            Self::Top => template!("top.toml", "polhode simulate top.toml --open"),
            Self::Drone => template!("drone.toml", "polhode simulate drone.toml --open"),
            Self::Pencil => template!("pencil.toml", "polhode stability pencil.toml"),
            Self::Satellite => template!("satellite.toml", "polhode simulate satellite.toml --open"),
            Self::Asteroid => template!("asteroid.toml", "polhode simulate asteroid.toml --open"),
            Self::Moon => template!("moon.toml", "polhode simulate moon.toml --open"),
            Self::RobotLink => {
                template!("robot-link.toml", "polhode inertia robot-link.toml --as urdf")
            }
            #[cfg(feature = "robot")]
            Self::Gripper => template!("gripper.urdf", "polhode check gripper.urdf"),
            Self::Molecule => template!("molecule.xyz", "polhode inertia molecule.xyz"),
            #[cfg(feature = "budget")]
            Self::Parts => template!("parts.csv", "polhode budget parts.csv"),
            #[cfg(feature = "judge")]
            Self::Log => Template {
                companion: Some(("free-body.toml", include_str!("new/free-body.toml"))),
                ..template!("log.csv", "polhode judge log.csv")
            },
            #[cfg(feature = "sweep")]
            Self::Sweep => template!("sweep.toml", "polhode sweep sweep.toml"),
        }
    }
}

impl New {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let Some(starter) = self.starter else { return print(&list()) };
        let Template { file: template_name, text, next, companion } = starter.template();
        let file = self.output.unwrap_or_else(|| PathBuf::from(template_name));
        let mut files = vec![(file.clone(), text)];
        files.extend(companion.map(|(name, text)| (file.with_file_name(name), text)));
        files.iter().try_for_each(|(file, _)| check_absent(file))?;
        if let Some(folder) = file.parent() {
            std::fs::create_dir_all(folder).map_err(|error| partial::output(&file, error))?;
        }
        // The commands in the file refer to the file by its actual name.
        let name = file.display().to_string();
        for (file, text) in &files {
            let text = text.replace(template_name, &name);
            partial::write(file, false, |out| out.write_all(text.as_bytes()))?;
        }
        let written: Vec<String> = files.iter().map(|(file, _)| shown(file)).collect();
        let next = next.replace(template_name, &shown(&file));
        print(&format!("wrote {}; edit and run\n  {next}\n", written.join(" and ")))
    }
}

/// Refuses an existing file: an example is never worth the user's own text.
fn check_absent(file: &Path) -> Result<(), Failure> {
    match std::fs::symlink_metadata(file) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(()),
        Err(error) => Err(Failure::Output { path: shown(file), error }),
        Ok(_) => {
            Err(Failure::usage(format!("{} already exists", shown(file)), "choose another file with -o FILE"))
        }
    }
}

/// Returns one line for each starter: name, contents, and the command to run next.
fn list() -> String {
    let values = Starter::value_variants().iter().filter_map(|starter| {
        let value = starter.to_possible_value()?;
        Some((value.get_name().to_owned(), value.get_help()?.to_string(), starter.template().next))
    });
    let rows: Vec<(String, String, &str)> = values.collect();
    let name_width = rows.iter().map(|(name, ..)| name.len()).max().unwrap_or(0);
    let help_width = rows.iter().map(|(_, help, _)| help.len()).max().unwrap_or(0);
    let lines =
        rows.iter().map(|(name, help, next)| format!("  {name:name_width$}  {help:help_width$}  {next}\n"));
    format!(
        "polhode new NAME writes one of these files; then run the command next to it.\n\n{}",
        lines.collect::<String>()
    )
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may")]

    use polhode_scenario::read as scenario;

    use super::*;

    /// A scenario runs unchanged, or with the keys in its comments enabled, and is complete.
    #[test]
    fn every_scenario_runs_and_so_does_what_it_suggests() {
        let templates = Starter::value_variants().iter().map(|starter| starter.template());
        let files = templates.flat_map(|it| [Some((it.file, it.text)), it.companion]);
        let mut count = 0;
        for (name, text) in files.flatten().filter(|(name, _)| name.ends_with(".toml")) {
            count += 1;
            let read = |text: &str| scenario::parse(text, Path::new(name));
            let scenario = read(text).unwrap();
            // A plan says that it is one.
            let others = scenario.findings().iter().filter(|finding| finding.code != "sweep.nominal");
            assert_eq!(others.count(), 0, "{name}: {:?}", scenario.findings());
            let is_complete = |text: &str| {
                read(text).unwrap().simulate().map(|motion| motion.unwrap().ending().is_complete())
            };
            let mut motions = vec![is_complete(text)];
            // Comment lines that contain only keys and tables.
            let is_code = |line: &str| {
                let rest = line.strip_prefix("# ");
                rest.is_some_and(|rest| {
                    rest.starts_with(['[', ']'])
                        || rest.starts_with("    {")
                        || rest.contains(" = ") && !rest.contains(':') && !rest.starts_with(' ')
                })
            };
            let uncommented: Vec<&str> = text
                .lines()
                .map(|line| if is_code(line) { line.trim_start_matches("# ") } else { line })
                .collect();
            if uncommented.join("\n") != text.trim_end() {
                motions.push(is_complete(&uncommented.join("\n")));
            }
            // The cube moves only with its comments.
            assert!(motions.contains(&Some(true)) && !motions.contains(&Some(false)), "{name}: {motions:?}");
        }
        assert!(count >= 9, "{count} scenarios");
    }
}
