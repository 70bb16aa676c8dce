//! Measurements that need no plan: a gyro's log, the swings about one axis. What is said on the command line is written as a plan, and read as one.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode_source::given::{positive, quantity};
use polhode_source::unit::Dimension;
use serde_json::Value;

use crate::failure::Failure;

/// What is said without a plan.
#[derive(Debug, Args)]
pub(super) struct Simple {
    /// Which columns of the log are what: "time ms = t, omega deg/s = gx gy gz".
    #[arg(long, value_name = "COLUMNS", help_heading = "Logs of a gyro")]
    columns: Option<String>,
    /// The whole log is one flight; else flights are found in it.
    #[arg(long, help_heading = "Logs of a gyro")]
    whole: bool,
    /// Find the drag of the air too: "linear" or "quadratic".
    #[arg(long, value_name = "LAW", help_heading = "Logs of a gyro")]
    drag: Option<String>,
    /// Two parallel wires of one length hold the body, its centre in the middle between them: moment about the vertical.
    #[arg(long, help_heading = SWINGS)]
    bifilar: bool,
    /// Three parallel wires of one length hold the body, its centre in the middle: moment about the vertical.
    #[arg(long, help_heading = SWINGS)]
    trifilar: bool,
    /// The body swings about a level axis: moment about the parallel axis through its centre of mass.
    #[arg(long, help_heading = SWINGS)]
    pendulum: bool,
    /// The body's mass; with --body, that of a body that was thrown.
    #[arg(long, value_name = "MASS", help_heading = SWINGS)]
    mass: Option<String>,
    /// From one wire to another of --bifilar or --trifilar; from the axis of --pendulum to the centre of mass.
    #[arg(long, value_name = "LENGTH", help_heading = SWINGS)]
    distance: Option<String>,
    /// Of the wires.
    #[arg(long, value_name = "LENGTH", help_heading = SWINGS)]
    length: Option<String>,
    /// How many whole periods were counted.
    #[arg(long, value_name = "COUNT", help_heading = SWINGS)]
    swings: Option<String>,
    /// The time of all of them, with its standard deviation: "31.4 s ± 0.1 s".
    #[arg(long, value_name = "TIME", help_heading = SWINGS)]
    time: Option<String>,
    /// The amplitude about the middle of the time, "10 deg ± 1 deg"; or at its beginning and end, "12 deg, 9 deg ± 1 deg".
    #[arg(long, value_name = "ANGLES", help_heading = SWINGS)]
    amplitude: Option<String>,
    /// Gravity, if it is not 9.80665 m/s^2.
    #[arg(long, value_name = "ACCELERATION", help_heading = SWINGS)]
    gravity: Option<String>,
    /// Print the plan that all this stands for, and find nothing.
    #[arg(long)]
    print_plan: bool,
}

const SWINGS: &str = "Swings about one axis (\"±\" or \"+-\" before a standard deviation)";

/// Extensions of logs; every other file is a plan.
const LOGS: [&str; 8] = ["csv", "tsv", "txt", "dat", "parquet", "json", "jsonl", "ndjson"];

/// Where a plan is.
pub(super) enum Asked {
    File(PathBuf),
    /// Its text.
    Text(String),
}

impl Simple {
    pub(super) const fn prints_plan(&self) -> bool {
        self.print_plan
    }

    /// The plan: the file that is given, or what the flags say.
    pub(super) fn asked(&self, files: &[PathBuf], is_body: bool) -> Result<Asked, Failure> {
        let (gyro, swings) = (first(self.of_gyro()), self.swings_flag(is_body));
        let is_log = |file: &Path| {
            let extension = file.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
            extension.is_some_and(|extension| LOGS.contains(&&*extension))
        };
        match files {
            [] => match gyro {
                Some(flag) => Err(Failure::usage(
                    format!("{flag} says something of a log, and there is none"),
                    "name the log",
                )),
                None => self.swing_plan().map(Asked::Text),
            },
            [file, ..] if swings.is_some() => {
                let flag = swings.unwrap_or_default();
                let message = format!("{flag} says something of counted swings, which are in no file");
                let hint = match flag {
                    "--mass" => "leave it out; or print the body with --body, of which it is the mass",
                    _ => "leave the file out, or write a plan",
                };
                Err(Failure::usage(message, hint).about(file))
            }
            [plan] if !is_log(plan) => match (gyro, self.print_plan) {
                (Some(flag), _) => Err(Failure::usage(
                    format!("{flag} says something of a log, and this file is read as a plan"),
                    format!("logs end in {}; in a plan, write it there", LOGS.join(", ")),
                )
                .about(plan)),
                (None, true) => Err(Failure::usage(
                    "--print-plan prints what flags stand for, and this is a plan already",
                    "leave --print-plan out",
                )
                .about(plan)),
                (None, false) => Ok(Asked::File(plan.clone())),
            },
            all => match all.iter().find(|file| !is_log(file)) {
                Some(plan) => Err(Failure::usage(
                    "a plan stands alone, and its logs are in it",
                    format!("logs end in {}", LOGS.join(", ")),
                )
                .about(plan)),
                None => Ok(Asked::Text(self.tumble_plan(all))),
            },
        }
    }

    /// A flag of swings that is given; the mass is also one of --body.
    pub(super) fn swings_flag(&self, is_body: bool) -> Option<&'static str> {
        let is_of_swings = |name| !(is_body && name == "--mass");
        let named = self.named().map(|(name, value)| (name, value.is_some() && is_of_swings(name)));
        first(self.rigs().into_iter().chain(named))
    }

    /// The mass of a body that was thrown, kg.
    pub(super) fn thrown_mass(&self) -> Result<Option<f64>, Failure> {
        let Some(text) = &self.mass else { return Ok(None) };
        let (value, sd) = parts("--mass", text)?;
        if sd.is_some() {
            let message = "--mass has a standard deviation, for which a scenario has no place";
            return Err(Failure::usage(message, "as in --mass \"350 g\""));
        }
        let refused = |why: String| Failure::usage(format!("--mass: {why}"), "as in --mass \"350 g\"");
        quantity(&value, Dimension::MASS).and_then(positive).map(Some).map_err(refused)
    }

    const fn of_gyro(&self) -> [(&'static str, bool); 3] {
        [("--columns", self.columns.is_some()), ("--whole", self.whole), ("--drag", self.drag.is_some())]
    }

    const fn rigs(&self) -> [(&'static str, bool); 3] {
        [("--bifilar", self.bifilar), ("--trifilar", self.trifilar), ("--pendulum", self.pendulum)]
    }

    const fn named(&self) -> [(&'static str, &Option<String>); 7] {
        [
            ("--mass", &self.mass),
            ("--distance", &self.distance),
            ("--length", &self.length),
            ("--swings", &self.swings),
            ("--time", &self.time),
            ("--amplitude", &self.amplitude),
            ("--gravity", &self.gravity),
        ]
    }

    fn tumble_plan(&self, logs: &[PathBuf]) -> String {
        let logs: Vec<String> = logs.iter().map(|log| quoted(&log.to_string_lossy())).collect();
        let log = if let [log] = &logs[..] { log.clone() } else { format!("[{}]", logs.join(", ")) };
        let mut plan = format!("[tumble]\nlog = {log}\n");
        let flights = if self.whole { "whole" } else { "find" };
        let _ = writeln!(plan, "flights = {}", quoted(flights));
        for (key, value) in [("columns", &self.columns), ("drag", &self.drag)] {
            if let Some(value) = value {
                let _ = writeln!(plan, "{key} = {}", quoted(value));
            }
        }
        plan
    }

    fn swing_plan(&self) -> Result<String, Failure> {
        let given: Vec<&str> = self.rigs().into_iter().filter(|(_, is)| *is).map(|(name, _)| name).collect();
        let rig = match given[..] {
            [rig] => rig,
            [] => {
                return Err(Failure::usage(
                    "nothing says what was measured",
                    "name a plan or a log, or say --bifilar, --trifilar or --pendulum",
                ));
            }
            [one, other, ..] => {
                return Err(Failure::usage(
                    format!("{one} and {other} are two tests"),
                    "write a plan for several",
                ));
            }
        };
        let require = |name: &str, example: &str| {
            let value =
                self.named().into_iter().find(|(own, _)| *own == name).and_then(|(_, value)| value.as_ref());
            value.ok_or_else(|| {
                Failure::usage(format!("{rig} needs {name}"), format!("as in {name} {}", quoted(example)))
            })
        };
        let mass = measured("--mass", require("--mass", "1.24 kg ± 1 g")?)?;
        let distance = measured("--distance", require("--distance", "300 mm ± 0.5 mm")?)?;
        let wires = if rig == "--pendulum" {
            if self.length.is_some() {
                return Err(Failure::usage(
                    "--pendulum has no wires: --length is theirs",
                    "the distance from the axis to the centre of mass is --distance",
                ));
            }
            None
        } else {
            Some(measured("--length", require("--length", "1.2 m ± 1 mm")?)?)
        };
        let counted = self.counted(
            require("--swings", "20")?,
            require("--time", "31.4 s ± 0.1 s")?,
            require("--amplitude", "10 deg ± 1 deg")?,
        )?;
        let mut plan = format!("[swing]\nmass = {mass}\ncenter = [0, 0, 0]\n");
        if let Some(gravity) = &self.gravity {
            let _ = writeln!(plan, "gravity = {}", measured("--gravity", gravity)?);
        }
        let _ = write!(plan, "\n[swing.numbers]\ndistance = {distance}\n\n[[swing.test]]\n");
        match wires {
            // three wires at the corners of a triangle are 1/√3 of its side from the middle
            Some(length) => {
                let (rig, times) =
                    if rig == "--bifilar" { ("bifilar", 0.5) } else { ("trifilar", 3.0_f64.sqrt() / 3.0) };
                let _ = write!(
                    plan,
                    "name = \"about the vertical\"\nrig = \"{rig}\"\nup = [0, 0, 1]\nacross = [1, 0, 0]\n\
                     radius = {{ number = \"distance\", times = {times} }}\nlength = {length}\n",
                );
            }
            None => plan.push_str(
                "name = \"about the axis\"\nrig = \"compound\"\naxis = [1, 0, 0]\npivot = [0, 0, \"distance\"]\n",
            ),
        }
        plan.push_str(&counted);
        Ok(plan)
    }

    fn counted(&self, swings: &str, time: &str, amplitude: &str) -> Result<String, Failure> {
        if !swings.trim().parse::<f64>().is_ok_and(|count| count > 0.0 && count.is_finite()) {
            return Err(Failure::usage(
                format!("--swings is {}, and has to be a number", quoted(swings)),
                "as in --swings 20",
            ));
        }
        let with_sd = |name: &str, value: &str, example: &str| {
            let (value, sd) = parts(name, value)?;
            let Some(sd) = sd else {
                let message = format!("{name} needs its standard deviation");
                return Err(Failure::usage(message, format!("as in {name} {}", quoted(example))));
            };
            Ok((value, sd))
        };
        let (time, sd) = with_sd("--time", time, "31.4 s ± 0.1 s")?;
        let (angles, amplitude_sd) = with_sd("--amplitude", amplitude, "12 deg, 9 deg ± 1 deg")?;
        let angles: Vec<String> = angles.split(',').map(|angle| quoted(angle.trim())).collect();
        let (angles, damping) = match &angles[..] {
            [one] => (one.clone(), ", damping = \"none\""),
            [first, last] => (format!("[{first}, {last}]"), ""),
            _ => {
                let message = "--amplitude is one angle, or two, at the beginning and at the end";
                return Err(Failure::usage(message, "write a plan for more"));
            }
        };
        Ok(format!(
            "counted = {{ swings = {}, time = {}, sd = {}, amplitude = {angles}, amplitude_sd = {}{damping} }}\n",
            swings.trim(),
            quoted(&time),
            quoted(&sd),
            quoted(&amplitude_sd)
        ))
    }
}

/// The first flag that is given.
fn first(flags: impl IntoIterator<Item = (&'static str, bool)>) -> Option<&'static str> {
    flags.into_iter().find(|(_, is_given)| *is_given).map(|(name, _)| name)
}

/// A TOML string.
fn quoted(text: &str) -> String {
    Value::from(text).to_string()
}

/// `"1.24 kg"`, or `{ value = "1.24 kg", sd = "1 g" }` of `1.24 kg ± 1 g`.
fn measured(name: &str, text: &str) -> Result<String, Failure> {
    Ok(match parts(name, text)? {
        (value, Some(sd)) => format!("{{ value = {}, sd = {} }}", quoted(&value), quoted(&sd)),
        (value, None) => quoted(&value),
    })
}

/// A value, and its standard deviation, if it has one.
fn parts(name: &str, text: &str) -> Result<(String, Option<String>), Failure> {
    let Some((sign, at)) = ["±", "+-", "+/-"].iter().find_map(|sign| Some((sign, text.find(sign)?))) else {
        return Ok((text.trim().to_owned(), None));
    };
    let (value, sd) = (text[..at].trim(), text[at + sign.len()..].trim());
    let has_unit = |part: &str| part.chars().any(|c| c.is_alphabetic() && !matches!(c, 'e' | 'E'));
    if value.is_empty() || sd.is_empty() || has_unit(value) != has_unit(sd) {
        let message = format!(
            "{name} is {}, and has to be a value and its standard deviation, each with its unit",
            quoted(text)
        );
        return Err(Failure::usage(message, "as in \"31.4 s ± 0.1 s\""));
    }
    Ok((value.to_owned(), Some(sd.to_owned())))
}
