//! Request of `budget`.
#![allow(rustdoc::broken_intra_doc_links, reason = "the help of the command shows brackets as they are")]

use std::path::PathBuf;

use polhode::math::{Body, Part};
use polhode_source::Failure;
use polhode_source::given::{Given, Point, Turn};
use serde::{Deserialize, Serialize};

use crate::Basis;
use crate::read::{LEAST_DRAWS, MOST_DRAWS, Questions};

/// Parts list to read, and options that override its own.
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
    /// A parts list, CSV or XLSX; or a plan that names one, TOML.
    #[cfg_attr(feature = "arguments", arg(value_name = "FILE"))]
    pub file: PathBuf,
    /// Folder that files which the parts list names may lie in, besides its own folder.
    #[serde(rename = "root")]
    #[cfg_attr(feature = "arguments", arg(long = "root", value_name = "DIR"))]
    pub roots: Vec<PathBuf>,
    /// Which masses count: as they are known, or with their growth allowance [default: the file's, else predicted].
    #[cfg_attr(feature = "arguments", arg(long, value_enum, value_name = "BASIS"))]
    pub basis: Option<Basis>,
    /// Also the tensor about this point: x,y,z from the origin, each with its unit or in metres.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "X,Y,Z", allow_hyphen_values = true))]
    pub about: Option<Given<Point>>,
    /// Also the tensor along axes turned by this unit quaternion (scalar first, turned axes to body
    /// axes), from which tilts are then.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "W,X,Y,Z", allow_hyphen_values = true))]
    pub along: Option<Given<Turn<Body, Part>>>,
    /// How many possible bodies are drawn: 0, or from 10 to 10,000,000. Of --sweep, how many members the plan has.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "N", value_parser = draws))]
    pub draws: Option<usize>,
    /// Draw others [default: 1].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "N"))]
    pub seed: Option<u64>,
    /// Only this configuration.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "NAME"))]
    pub configuration: Option<String>,
    /// Say what changed since another parts list: row by row, and in the whole.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "OTHER", conflicts_with_all = ["about", "along", "draws", "seed", "strict"]))]
    pub diff: Option<PathBuf>,
    /// Exit with status 1 if a limit is not met, or something is heavier than allowed.
    #[cfg_attr(feature = "arguments", arg(long))]
    pub strict: bool,
    /// Files that are made of the list as it is given, without draws and ballast.
    #[cfg_attr(feature = "arguments", arg(skip))]
    pub output: Option<Output>,
}

/// Files that are made of a list. Names are those that the files get.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Output {
    /// CSV: a row for each row of the list, with the masses and mass properties of all in it.
    Parts,
    /// CSV: the whole over time, with its rates.
    Time,
    /// CSV: the whole by what is in each tank.
    Fill,
    /// The whole as a part of a scenario file.
    Body,
    /// XLSX: all tables, the whole and its covariance.
    Workbook(PathBuf),
    /// Plan of a sweep whose members have the list's errors, with their correlations.
    Plan(PathBuf),
    /// Scenario of what happens over time, and a CSV table of the same name that it names.
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

    /// Returns the questions of this request, else those of the file.
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
