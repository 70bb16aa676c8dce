//! Plan of a request: a plan file, or a plan text composed from the command's options.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use polhode_source::Failure;
use serde_json::Value;

use crate::request::Request;

/// Extensions of log files; every other file is a plan.
const LOGS: [&str; 8] = ["csv", "tsv", "txt", "dat", "parquet", "json", "jsonl", "ndjson"];

/// Measurement plan of a request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum GivenPlan {
    /// Path of a plan file.
    File(PathBuf),
    /// Text of a plan composed from the options.
    Text(String),
}

impl Request {
    /// Returns the plan: the plan file of the request, or the text composed from its options.
    ///
    /// # Errors
    /// [`Failure`] for options that are missing, contradict each other, or belong to another kind
    /// of measurement.
    pub fn plan(&self) -> Result<GivenPlan, Failure> {
        let (gyro, swings) = (first(self.of_gyro()), self.swings_option());
        if let (true, Some(option)) = (self.strict, swings) {
            let message = format!("--strict tests the residuals, but the one test of {option} has none");
            return Err(Failure::usage(
                message,
                "remove --strict, or write a plan with more measurements than parameters",
            ));
        }
        let ends = || format!("file extensions of logs are {}", LOGS.join(", "));
        match (&self.files[..], gyro, swings) {
            ([], Some(option), _) => Err(Failure::usage(
                format!("{option} applies to a log, but there is none"),
                "add the path of the log",
            )),
            ([], None, _) => self.swing_plan().map(GivenPlan::Text),
            ([file, ..], _, Some(option)) => {
                let message = format!("{option} applies to counted swings, which do not come from a file");
                let hint = match option {
                    "--mass" => "remove it; or add --body, to print a body of this mass",
                    _ => "remove the file, or write a plan of the swings",
                };
                Err(Failure::usage(message, hint).in_file(file))
            }
            ([plan], gyro, None) if !is_log(plan) => match gyro {
                Some(option) => Err(Failure::usage(
                    format!("{option} applies to a log, but this file is read as a plan"),
                    ends() + "; with a plan, write the setting in the plan",
                )
                .in_file(plan)),
                None => Ok(GivenPlan::File(plan.clone())),
            },
            (all, _, None) => match all.iter().find(|file| !is_log(file)) {
                Some(plan) => {
                    Err(Failure::usage("a plan must be the only file: it names its logs", ends())
                        .in_file(plan))
                }
                None => Ok(GivenPlan::Text(self.tumble_plan())),
            },
        }
    }

    /// Returns the first swing option of the request; with `--body`, `--mass` is not one.
    fn swings_option(&self) -> Option<&'static str> {
        let named = self.named().map(|(name, value)| (name, value.is_some()));
        let mut all = self.rigs().into_iter().chain(named).filter(|(_, is_given)| *is_given);
        all.find(|(name, _)| !(self.body && *name == "--mass")).map(|(name, _)| name)
    }

    const fn of_gyro(&self) -> [(&'static str, bool); 3] {
        [("--columns", self.columns.is_some()), ("--whole", self.whole), ("--drag", self.drag.is_some())]
    }

    /// Returns the options that name a rig, each with true if it is set.
    const fn rigs(&self) -> [(&'static str, bool); 3] {
        [("--bifilar", self.bifilar), ("--trifilar", self.trifilar), ("--pendulum", self.pendulum)]
    }

    /// Returns the swing options that take a value.
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

    fn tumble_plan(&self) -> String {
        let logs: Vec<String> = self.files.iter().map(|log| quoted(&log.to_string_lossy())).collect();
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
                    "no measurement is specified",
                    "add the path of a plan or a log, or use --bifilar, --trifilar or --pendulum",
                ));
            }
            [one, other, ..] => {
                return Err(Failure::usage(
                    format!("{one} and {other} are two different tests"),
                    "use one of them, or write a plan for several tests",
                ));
            }
        };
        let require = |name: &str, example: &str| {
            let value =
                self.named().into_iter().find(|(own, _)| *own == name).and_then(|(_, value)| value.as_ref());
            value.ok_or_else(|| {
                Failure::usage(
                    format!("{rig} needs {name}"),
                    format!("for example {name} {}", quoted(example)),
                )
            })
        };
        let mass = measured("--mass", require("--mass", "1.24 kg ± 1 g")?)?;
        let distance = measured("--distance", require("--distance", "300 mm ± 0.5 mm")?)?;
        let wires = if rig == "--pendulum" {
            if self.length.is_some() {
                return Err(Failure::usage(
                    "--length is the length of wires, but --pendulum has none",
                    "remove --length; --distance is the distance from the axis to the centre of mass",
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
            // An equilateral triangle's corners lie at 1/√3 of its side from the centre.
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
                format!("--swings is {}, but must be a positive number", quoted(swings)),
                "for example --swings 20",
            ));
        }
        let with_sd = |name: &str, value: &str, example: &str| {
            let (value, sd) = parts(name, value)?;
            let Some(sd) = sd else {
                let message = format!("{name} needs a standard deviation");
                return Err(Failure::usage(message, format!("for example {name} {}", quoted(example))));
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
                let message = "--amplitude takes one angle, or two: at the beginning and at the end";
                return Err(Failure::usage(message, "for more amplitudes, write a plan"));
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

fn is_log(file: &Path) -> bool {
    let extension = file.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
    extension.is_some_and(|extension| LOGS.contains(&&*extension))
}

/// Returns the first option that is set.
fn first(options: impl IntoIterator<Item = (&'static str, bool)>) -> Option<&'static str> {
    options.into_iter().find(|(_, is_given)| *is_given).map(|(name, _)| name)
}

/// Returns the text as a quoted TOML string.
fn quoted(text: &str) -> String {
    Value::from(text).to_string()
}

/// Returns a quantity in TOML: `"1.24 kg"`, or `{ value = "1.24 kg", sd = "1 g" }` for
/// `1.24 kg ± 1 g`.
fn measured(name: &str, text: &str) -> Result<String, Failure> {
    Ok(match parts(name, text)? {
        (value, Some(sd)) => format!("{{ value = {}, sd = {} }}", quoted(&value), quoted(&sd)),
        (value, None) => quoted(&value),
    })
}

/// Splits a quantity into its value and its optional standard deviation.
pub(crate) fn parts(name: &str, text: &str) -> Result<(String, Option<String>), Failure> {
    let Some((sign, at)) = ["±", "+-", "+/-"].iter().find_map(|sign| Some((sign, text.find(sign)?))) else {
        return Ok((text.trim().to_owned(), None));
    };
    let (value, sd) = (text[..at].trim(), text[at + sign.len()..].trim());
    let has_unit = |part: &str| part.chars().any(|c| c.is_alphabetic() && !matches!(c, 'e' | 'E'));
    if value.is_empty() || sd.is_empty() || has_unit(value) != has_unit(sd) {
        let message = format!(
            "{name} is {}, but must be a value and its standard deviation, each with its unit",
            quoted(text)
        );
        return Err(Failure::usage(message, "for example \"31.4 s ± 0.1 s\""));
    }
    Ok((value.to_owned(), Some(sd.to_owned())))
}
