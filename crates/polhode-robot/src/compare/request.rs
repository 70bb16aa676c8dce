//! Request of the command `compare`.
#![allow(rustdoc::broken_intra_doc_links, reason = "the help of the command shows brackets as they are")]

use std::path::PathBuf;

use polhode_source::given::{Given, Number, Positive};
use serde::{Deserialize, Serialize};

/// Request of a comparison: two models of one robot.
///
/// ```
/// use polhode_document::Report as _;
/// use polhode_robot::compare::{Request, run};
/// use polhode_source::files::Memory;
/// let model = |mass: &str| format!(r#"<robot><link name="arm"><inertial><mass value="{mass}"/>
///     <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2.5"/></inertial></link></robot>"#);
/// let files = Memory::from([("old.urdf", model("1.7")), ("new.urdf", model("1.8"))]);
/// let comparison = run(&Request { a: "old.urdf".into(), b: "new.urdf".into(), ..Request::default() }, &files)?;
/// assert!(comparison.has_failed());
/// assert_eq!(comparison.to_json()["differences"][0]["code"], "compare.mass");
/// # Ok::<(), polhode_source::Failure>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct Request {
    /// First model: the reference, such as the model before a conversion or a change.
    #[cfg_attr(feature = "arguments", arg(value_name = "A"))]
    pub a: PathBuf,
    /// Second model. Differences are reported at their places in this file.
    #[cfg_attr(feature = "arguments", arg(value_name = "B"))]
    pub b: PathBuf,
    /// Largest relative difference of equal numbers. Distances of axes are relative to the size of
    /// the robot, directions in rad [default: 1e-6].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "NUMBER"))]
    pub tolerance: Option<Given<Positive<Number>>>,
    /// File with names that differ: TOML tables [links] and [joints] of "name in A" = "name in B".
    #[cfg_attr(feature = "arguments", arg(long, value_name = "FILE"))]
    pub map: Option<PathBuf>,
    /// A folder that holds packages, for package:// and model://; may be repeated.
    #[serde(rename = "root")]
    #[cfg_attr(feature = "arguments", arg(long = "root", value_name = "DIR"))]
    pub roots: Vec<PathBuf>,
}

impl Request {
    /// Returns the tolerance; 1e-6 if none is given.
    pub fn tolerance(&self) -> f64 {
        self.tolerance.as_ref().map_or(1e-6, |given| given.value.0.0)
    }
}
