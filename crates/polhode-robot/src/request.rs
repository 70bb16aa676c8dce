//! Request of `check`.
#![allow(rustdoc::broken_intra_doc_links, reason = "the help of the command shows brackets as they are")]

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::finding::Severity;
use crate::policy::date::Date;
use crate::program::Program;

/// Models to check, and what of the findings counts.
///
/// ```
/// use polhode_document::Report as _;
/// use polhode_robot::{Request, run};
/// use polhode_source::files::Memory;
/// let model = r#"<robot><link name="arm"><inertial><mass value="1.7"/>
///     <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="3"/></inertial></link></robot>"#;
/// let files = Memory::from([("robots/arm.urdf", model)]);
/// let checked = run(&Request { files: vec!["robots".into()], ..Request::default() }, &files)?;
/// assert!(checked.has_failed());
/// assert_eq!(checked.to_json()[0]["findings"][0]["code"], "inertia.triangle");
/// # Ok::<(), polhode_source::Failure>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct Request {
    /// Models, and folders to search for them.
    #[cfg_attr(feature = "arguments", arg(required_unless_present_any = ["explain", "out"], value_name = "FILE"))]
    pub files: Vec<PathBuf>,
    /// A folder that holds packages, for package:// and model://; may be repeated. No mesh is
    /// opened outside of these, the folders that are checked, the model's own and an ancestor
    /// folder with the package's name.
    #[serde(rename = "root")]
    #[cfg_attr(feature = "arguments", arg(long = "root", value_name = "DIR"))]
    pub roots: Vec<PathBuf>,
    /// Program that has to accept the models; may be repeated. A link that it refuses, such as a
    /// moving one without mass, is an error instead of a note.
    #[serde(rename = "for")]
    #[cfg_attr(feature = "arguments", arg(long = "for", value_enum, value_name = "PROGRAM"))]
    pub programs: Vec<Program>,
    /// The least severity that makes the exit status 1; suspect, if neither this nor polhode.toml says another.
    #[cfg_attr(feature = "arguments", arg(long, value_enum, value_name = "SEVERITY"))]
    pub fail_on: Option<Severity>,
    /// Exit with 1 for notes too, such as a mesh that cannot be read: --fail-on note.
    #[cfg_attr(feature = "arguments", arg(long, conflicts_with = "fail_on"))]
    pub strict: bool,
    /// Severities of rules, what is allowed and what is left out, instead of ./polhode.toml.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "FILE"))]
    pub config: Option<PathBuf>,
    /// Findings that are known and do not fail, as --write-baseline has written them.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "FILE"))]
    pub baseline: Option<PathBuf>,
    /// Also computes the fixes that are the only consistent ones, and the diff to them.
    #[cfg_attr(feature = "arguments", arg(skip))]
    pub fix: bool,
    /// Today, for allowances that expire; without it none has expired.
    #[cfg_attr(feature = "arguments", arg(skip))]
    pub today: Option<Date>,
}
