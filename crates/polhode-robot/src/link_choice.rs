//! Selection of the links of a robot that form a body: one link, groups joined by fixed joints, a
//! subtree, or all.

use std::path::Path;
use std::str::FromStr;

use polhode_document::layout::printable;
use polhode_shape::report::InertiaReport;
use polhode_source::files::Files;
use polhode_source::given::{Given, quantity};
use polhode_source::text::counted;
use polhode_source::unit::Dimension;
use polhode_source::{Failure, shown};
use serde::{Deserialize, Serialize};

use crate::inertia::{of_link, of_lumps};
use crate::link_table::LinkTable;
use crate::lump::{Lumping, slides};
use crate::model::RobotModel;
use crate::read::{ReadOptions, read_model};

/// Selection of a robot's links, and the values of its joints.
///
/// ```
/// use polhode_robot::LinkChoice;
/// use polhode_source::files::Memory;
/// let model = r#"<robot><link name="arm"><inertial><mass value="2"/>
///     <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>"#;
/// let choice = LinkChoice { link: Some("arm".to_owned()), ..LinkChoice::default() };
/// let reports = choice.reports(&Memory::from([("a.urdf", model)]), "a.urdf".as_ref())?;
/// assert_eq!(reports[0].properties.mass(), 2.0);
/// # Ok::<(), polhode_source::Failure>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct LinkChoice {
    /// A link of a robot, in its own frame.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "NAME", group = "of_robot"))]
    pub link: Option<String>,
    /// Joined links of a robot: "fixed" for each group held by fixed joints, or "all" [default:
    /// all].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "WHICH", num_args = 0..=1, default_missing_value = "all", group = "of_robot"))]
    pub lump: Option<Which>,
    /// A link and all its descendants, joined, in the frame of that link.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "LINK", group = "of_robot"))]
    pub subtree: Option<String>,
    /// Go on without the links whose mass properties are impossible, and list them: joined links.
    #[cfg_attr(feature = "arguments", arg(long, requires = "of_robot", conflicts_with_all = ["link", "table"]))]
    pub skip_invalid: bool,
    /// A table of all links of a robot and the whole robot: as text, or with --json or --csv.
    #[cfg_attr(feature = "arguments", arg(long, group = "of_robot", conflicts_with_all = ["about", "along", "as_format"]))]
    pub table: bool,
    /// The value of a joint, rad or m or with its unit: elbow="30 deg". Coupled joints follow;
    /// other joints are at zero.
    #[serde(rename = "joint")]
    #[cfg_attr(
        feature = "arguments",
        arg(
            long = "joint",
            value_name = "NAME=VALUE",
            requires = "of_robot",
            conflicts_with = "link",
            allow_hyphen_values = true
        )
    )]
    pub joints: Vec<Given<JointValue>>,
}

/// Links that are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum Which {
    /// One body for each group of links held by fixed joints, in the frame of its first link.
    Fixed,
    /// One body, in the frame of the model.
    All,
}

/// Value of a joint: an angle or a length, according to the joint.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JointValue {
    /// Name of the joint.
    pub name: String,
    /// Number, rad or m, or a number with its unit.
    pub value: String,
}

impl FromStr for JointValue {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, value) = text.rsplit_once('=').ok_or("expected NAME=VALUE, such as elbow=0.5")?;
        Ok(Self { name: name.trim().to_owned(), value: value.trim().to_owned() })
    }
}

impl LinkChoice {
    /// Returns the name of the first option that is set.
    pub const fn given(&self) -> Option<&'static str> {
        match self {
            Self { link: Some(_), .. } => Some("--link"),
            Self { lump: Some(_), .. } => Some("--lump"),
            Self { subtree: Some(_), .. } => Some("--subtree"),
            Self { table: true, .. } => Some("--table"),
            _ => None,
        }
    }

    /// Refuses two selections of links, and joint values without a selection that uses them, as the
    /// definitions of the command do.
    ///
    /// # Errors
    /// [`Failure`] that names the keys.
    pub fn require_one(self) -> Result<Self, Failure> {
        let given = [
            ("link", self.link.is_some()),
            ("lump", self.lump.is_some()),
            ("subtree", self.subtree.is_some()),
        ];
        let mut given = given.into_iter().filter_map(|(key, is_given)| is_given.then_some(key));
        let (first, second) = (given.next(), given.next());
        if let (Some(first), Some(second)) = (first, second) {
            return Err(Failure::usage(
                format!("{first} and {second} contradict each other"),
                "leave one of them out",
            ));
        }
        if !self.joints.is_empty() && matches!(first, None | Some("link")) {
            let hint = "give lump or subtree, or leave joint out";
            return Err(Failure::usage("joint is only for joined links of a robot", hint));
        }
        if self.skip_invalid && matches!(first, None | Some("link")) {
            let hint = "give lump or subtree, or leave skip-invalid out";
            return Err(Failure::usage("skip-invalid is only for joined links of a robot", hint));
        }
        Ok(self)
    }

    /// Returns a report for the selected link, or for each body of joined links.
    ///
    /// # Errors
    /// [`Failure`] if the model cannot be read, or if it has no such link or joint.
    pub fn reports(&self, files: &dyn Files, file: &Path) -> Result<Vec<InertiaReport>, Failure> {
        let model = read_model(file, &ReadOptions { files, ..ReadOptions::default() })?;
        let lumping = match (&self.link, self.lump, &self.subtree) {
            (Some(name), _, _) => {
                return of_link(&model, name)
                    .map(|report| vec![report])
                    .map_err(|error| error.in_model(&model));
            }
            (_, Some(Which::Fixed), _) if !self.joints.is_empty() => {
                return Err(Failure::usage(
                    "--joint has no effect with --lump fixed: links fixed together have the same inertia in every position",
                    "leave it out",
                ));
            }
            (_, Some(Which::Fixed), _) => Lumping::Fixed,
            (_, Some(Which::All), _) => Lumping::All,
            (_, _, Some(link)) => Lumping::Subtree(link),
            _ => {
                let mut names: Vec<_> =
                    model.links.iter().take(40).map(|link| printable(&link.name.text)).collect();
                if names.len() < model.links.len() {
                    names.push("…".to_owned());
                }
                return Err(Failure::usage(
                    format!("{} is a robot of {}", shown(file), counted(model.links.len(), "link")),
                    format!(
                        "choose one by --link, lump them by --lump fixed, --lump all or --subtree, or list them by --table; its links are {}",
                        names.join(", ")
                    ),
                ));
            }
        };
        let positions = self.positions(&model)?;
        of_lumps(&model, lumping, &positions, self.skip_invalid).map_err(|error| error.in_model(&model))
    }

    /// Returns a table of the links.
    ///
    /// # Errors
    /// [`Failure`], as for [`LinkChoice::reports`].
    pub fn link_table(&self, files: &dyn Files, file: &Path) -> Result<LinkTable, Failure> {
        let model = read_model(file, &ReadOptions { files, ..ReadOptions::default() })?;
        let positions = self.positions(&model)?;
        LinkTable::of(&model, &positions).map_err(|error| error.in_model(&model))
    }

    /// Returns the values of joints, rad or m.
    fn positions(&self, model: &RobotModel) -> Result<Vec<(String, f64)>, Failure> {
        let joints: Vec<&JointValue> = self.joints.iter().map(|joint| &joint.value).collect();
        let twice = joints
            .iter()
            .enumerate()
            .find(|(k, joint)| joints.iter().take(*k).any(|other| other.name == joint.name));
        if let Some((_, JointValue { name, .. })) = twice {
            let message = format!("--joint {name} is given twice");
            return Err(Failure::usage(message, "a joint has one value: delete one of the two"));
        }
        joints.into_iter().map(|JointValue { name, value }| position(model, name, value)).collect()
    }
}

/// Parses the value of a joint, rad or m.
fn position(model: &RobotModel, name: &str, value: &str) -> Result<(String, f64), Failure> {
    let slides = slides(model, name).map_err(|error| error.in_model(model))?;
    let dimension = if slides { Dimension::LENGTH } else { Dimension::ANGLE };
    match quantity(value, dimension) {
        Ok(q) => Ok((name.to_owned(), q)),
        Err(why) => Err(Failure::usage(
            format!("--joint {name}: {why}"),
            if slides {
                "the joint slides: write a length, such as 0.02 or \"20 mm\""
            } else {
                "the joint rotates: write an angle, such as 0.5 or \"30 deg\""
            },
        )),
    }
}
