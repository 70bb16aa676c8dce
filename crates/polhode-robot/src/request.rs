//! Request of the command `check`.
#![allow(rustdoc::broken_intra_doc_links, reason = "the help of the command shows brackets as they are")]

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::finding::Severity;
use crate::policy::date::Date;
use crate::program::Program;

/// Request of a check: models, and the policy for their findings.
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
    /// Models to check; folders are searched for models.
    #[cfg_attr(feature = "arguments", arg(required_unless_present_any = ["explain", "out"], value_name = "FILE"))]
    pub files: Vec<PathBuf>,
    /// A folder that holds packages, for package:// and model://; may be repeated. Meshes are
    /// opened only below these roots, the checked folders, the model's own folder, and an ancestor
    /// folder with the package's name.
    #[serde(rename = "root")]
    #[cfg_attr(feature = "arguments", arg(long = "root", value_name = "DIR"))]
    pub roots: Vec<PathBuf>,
    /// Program that has to accept the models; may be repeated. A link that it rejects, such as a
    /// moving one without mass, is an error instead of a note.
    #[serde(rename = "for")]
    #[cfg_attr(feature = "arguments", arg(long = "for", value_enum, value_name = "PROGRAM"))]
    pub programs: Vec<Program>,
    /// Propose the possible tensors nearest to each impossible one, in the Frobenius norm and in the
    /// affine-invariant metric, with their distances. Mass and centre of mass stay, and nothing is
    /// written. The proposals are those of flat bodies: a measured or computed tensor is better.
    #[cfg_attr(feature = "arguments", arg(long))]
    pub nearest: bool,
    /// Lowest severity that makes the exit status 1. Default: suspect, or the value in
    /// polhode.toml.
    #[cfg_attr(feature = "arguments", arg(long, value_enum, value_name = "SEVERITY"))]
    pub fail_on: Option<Severity>,
    /// Exit with 1 for notes too, such as a mesh that cannot be read: --fail-on note.
    #[cfg_attr(feature = "arguments", arg(long, conflicts_with = "fail_on"))]
    pub strict: bool,
    /// Configuration file with severities of rules, allowances and exclusions, instead of
    /// ./polhode.toml.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "FILE"))]
    pub config: Option<PathBuf>,
    /// Baseline of known findings, which do not fail, as written by --write-baseline.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "FILE"))]
    pub baseline: Option<PathBuf>,
    /// True to compute the fixes that are the only consistent ones, and their diff.
    #[cfg_attr(feature = "arguments", arg(skip))]
    pub fix: bool,
    /// Current date, for allowances that expire. The default is before any expiry date.
    #[cfg_attr(feature = "arguments", arg(skip))]
    pub today: Option<Date>,
}
