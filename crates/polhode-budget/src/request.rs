//! Request of the `budget` command.
#![allow(rustdoc::broken_intra_doc_links, reason = "the help of the command shows brackets as they are")]

use std::path::PathBuf;

use polhode::math::{Body, Part};
use polhode_source::Failure;
use polhode_source::given::{Given, Point, Turn};
use serde::{Deserialize, Serialize};

use crate::Basis;
use crate::read::{LEAST_DRAWS, MOST_DRAWS, Questions};

/// Parts list to read, and options that override those of the file.
///
/// ```
/// use polhode_budget::{Output, Request, run};
/// use polhode_document::Report as _;
/// use polhode_source::files::Memory;
/// let files = Memory::from([("parts.csv", "name,mass [g],x [mm]\nbattery,270 ± 5,12\nradio,94,-20\n")]);
/// let request = Request { file: "parts.csv".into(), output: Some(Output::Body), ..Request::default() };
/// let found = run(&request, &files)?;
/// assert_eq!(found.to_json()["configurations"][0]["estimate"]["mass"], 0.364);
/// let [(name, text)] = &found.files()?[..] else { panic!("one file") };
/// assert_eq!(name.to_str(), Some("body.toml"));
/// assert!(text.starts_with(b"# a parts list, predicted masses"));
/// # Ok::<(), polhode_source::Failure>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct Request {
    /// Parts list, CSV or XLSX; or a plan that names one, TOML.
    #[cfg_attr(feature = "arguments", arg(value_name = "FILE"))]
    pub file: PathBuf,
    /// Additional folder for files that the parts list names, besides its own folder.
    #[serde(rename = "root")]
    #[cfg_attr(feature = "arguments", arg(long = "root", value_name = "DIR"))]
    pub roots: Vec<PathBuf>,
    /// Masses to use: as currently known, or with their growth allowance
    /// [default: the file's, else predicted].
    #[cfg_attr(feature = "arguments", arg(long, value_enum, value_name = "BASIS"))]
    pub basis: Option<Basis>,
    /// Point about which the tensor is also reported: x,y,z from the origin, each with its unit or
    /// in metres.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "X,Y,Z", allow_hyphen_values = true))]
    pub about: Option<Given<Point>>,
    /// Axes along which the tensor is also reported: unit quaternion, scalar first, from these axes
    /// to body axes. Tilts are then relative to these axes.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "W,X,Y,Z", allow_hyphen_values = true))]
    pub along: Option<Given<Turn<Body, Part>>>,
    /// Number of possible bodies to draw: 0, or from 10 to 10,000,000. With --sweep: number of
    /// members of the plan.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "N", value_parser = draws))]
    pub draws: Option<usize>,
    /// Seed of the random draws [default: 1].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "N"))]
    pub seed: Option<u64>,
    /// Name of the only configuration to compute.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "NAME"))]
    pub configuration: Option<String>,
    /// Other parts list to compare with: report the changes since it, row by row and in the whole.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "OTHER", conflicts_with_all = ["about", "along", "draws", "seed", "strict"]))]
    pub diff: Option<PathBuf>,
    /// Exit with status 1 if a limit is not met, or if a mass is greater than allowed.
    #[cfg_attr(feature = "arguments", arg(long))]
    pub strict: bool,
    /// Files to make from the list as given, without draws and ballast.
    #[cfg_attr(feature = "arguments", arg(skip))]
    pub output: Option<Output>,
}

/// Files to make from a list. Each path is the name of a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Output {
    /// CSV with one line per row of the list: masses and mass properties, including descendants.
    Parts,
    /// CSV of the whole over time, with its rates of change.
    Time,
    /// CSV of the whole as a function of the tank fill.
    Fill,
    /// Section of a scenario file with the whole body.
    Body,
    /// XLSX workbook with all tables, the whole and its covariance.
    Workbook(PathBuf),
    /// Sweep plan whose members have the errors and correlations of the list.
    Plan(PathBuf),
    /// Scenario of the changes over time, and a CSV table of the same name that it refers to.
    Scenario(PathBuf),
}

/// Name and contents of a file.
pub type MadeFile = (PathBuf, Vec<u8>);

impl Request {
    /// Refuses options that have no effect together, and a number of draws out of range.
    ///
    /// # Errors
    /// [`Failure::Usage`].
    pub(crate) fn check(&self) -> Result<(), Failure> {
        let given = [
            ("about", self.about.is_some()),
            ("along", self.along.is_some()),
            ("draws", self.draws.is_some()),
            ("seed", self.seed.is_some()),
            ("configuration", self.configuration.is_some()),
            ("strict", self.strict),
            ("output", self.output.is_some()),
        ];
        let (what, refused): (_, &[&str]) = match (&self.diff, &self.output) {
            (Some(_), _) => ("diff", &["about", "along", "draws", "seed", "strict", "output"]),
            (None, Some(Output::Scenario(_))) => {
                ("a scenario", &["about", "along", "draws", "seed", "configuration", "strict"])
            }
            (None, Some(Output::Plan(_))) => ("a plan", &["about", "along"]),
            (None, Some(_)) => ("output", &["about", "along", "draws", "seed"]),
            (None, None) => return draws_in_range(self.draws),
        };
        match given.iter().find(|(name, is_given)| *is_given && refused.contains(name)) {
            Some((name, _)) => Err(Failure::usage(format!("{name} has no effect on {what}"), "leave it out")),
            None => draws_in_range(self.draws),
        }
    }

    /// Returns the questions of this request. Options that are not given are taken from the file.
    pub(crate) fn questions(&self, file: &Questions) -> Questions {
        Questions {
            about: self.about.as_ref().map(|at| at.value.0).or(file.about),
            axes: self.along.as_ref().map(|turn| turn.value.0).or(file.axes),
            draws: self.draws.or(file.draws),
            seed: self.seed.unwrap_or(file.seed),
            basis: self.basis.unwrap_or(file.basis),
        }
    }
}

fn draws_in_range(draws: Option<usize>) -> Result<(), Failure> {
    let text = draws.map_or_else(|| "0".to_owned(), |draws| draws.to_string());
    match self::draws(&text) {
        Ok(_) => Ok(()),
        Err(rule) => Err(Failure::usage(format!("draws is {text}: {rule}"), "")),
    }
}

fn draws(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(n) if n == 0 || (LEAST_DRAWS..=MOST_DRAWS).contains(&n) => Ok(n),
        _ => Err(format!("it must be 0, or from {LEAST_DRAWS} to {MOST_DRAWS}")),
    }
}
