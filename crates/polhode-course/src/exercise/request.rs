//! Request of the `exercise` command.
#![allow(rustdoc::broken_intra_doc_links, reason = "the help of the command shows brackets as they are")]

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

/// JSON schema of a [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../../schema/exercise-request.json");

/// Exercise to be made or graded.
///
/// ```
/// use polhode_course::exercise::{Request, run};
/// use polhode_document::Report as _;
/// use polhode_source::files::Memory;
/// let request = Request { topic: Some("two-mass-pendulum".to_owned()), symbols: true, ..Request::default() };
/// assert!(run(&request, &Memory::default())?.to_text(None).contains("omega_0_squared = \"?\""));
///
/// let answers = "topic = \"two-mass-pendulum\"\nseed = 1\nsymbols = true\n[answers]\nomega_0_squared = \"g/b\"\n";
/// let files = Memory::from([("mine.toml", answers)]);
/// let report = run(&Request { answers: Some("mine.toml".into()), ..Request::default() }, &files)?;
/// assert!(report.has_failed());
/// assert!(report.to_text(None).contains("m₂ at the midpoint is missing"));
/// # Ok::<(), polhode_source::Failure>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct Request {
    /// Topic of the exercise, such as box-about-corner; all topics are listed without it.
    #[cfg_attr(feature = "arguments", arg(value_name = "TOPIC"))]
    pub topic: Option<String>,
    /// Seed of the numbers: the same seed gives the same exercise on every machine [default: 1].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "N"))]
    pub seed: Option<u64>,
    /// Ask for formulas in symbols.
    #[cfg_attr(feature = "arguments", arg(long))]
    pub symbols: bool,
    /// Grade the answers in this file (TOML), which names its topic and seed. The exit status is 1
    /// if an answer is wrong or missing.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "FILE"))]
    pub answers: Option<PathBuf>,
    /// Print the solution instead of the problem, or after it with --solution=after. With --answers:
    /// print it after the grades.
    #[cfg_attr(
        feature = "arguments",
        arg(long, value_enum, value_name = "WHERE", num_args = 0..=1, require_equals = true, default_missing_value = "alone")
    )]
    pub solution: Option<Solution>,
}

/// Place of the solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum Solution {
    /// Without the problem.
    Alone,
    /// After the problem.
    After,
}
