//! The mass properties of a robot's links: of one, of those that fixed joints hold together, of what hangs from one, or of all.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use polhode_document::json::pretty;
use polhode_document::layout::printable;
use polhode_robot::inertia::{InertiaError, of_link, of_lumps};
use polhode_robot::line_index::{FilePlace, Places};
use polhode_robot::link_table::LinkTable;
use polhode_robot::lump::{Lumping, slides};
use polhode_robot::model::RobotModel;
use polhode_robot::read::{ReadOptions, read_model};
use polhode_shape::noticed;
use polhode_shape::report::InertiaReport;
use polhode_source::files::Disk;
use polhode_source::given::quantity;
use polhode_source::unit::Dimension;
use polhode_source::{Failure, shown};
use serde_json::Value;

use super::output::OutputFlags;
use crate::failure::Failure as CommandFailure;
use crate::stderr::tell;
use crate::stdout::print;

/// Returns true for robot models, by their extension and root element.
pub(super) fn is_model(path: &Path) -> bool {
    polhode_robot::read::is_model(&Disk, path)
}

/// Lines among the examples of the help, each after a line break.
pub(super) const EXAMPLES: &str = "
  polhode inertia robot.urdf --link forearm
  polhode inertia robot.urdf --lump all --joint elbow=\"30 deg\" --write mjcf
  polhode inertia robot.urdf --subtree palm --joint left_finger=\"5 mm\"
  polhode inertia robot.urdf --table";

/// Flags for robot models.
#[derive(Debug, Args)]
pub(super) struct RobotFlags {
    /// A link of a robot, in its own frame.
    #[arg(long, value_name = "NAME", group = "of_robot")]
    link: Option<String>,
    /// The links of a robot joined: "fixed", those that fixed joints hold together, or "all" [default: all].
    #[arg(long, value_name = "WHICH", num_args = 0..=1, default_missing_value = "all", group = "of_robot")]
    lump: Option<Which>,
    /// A link and all that hangs from it, joined, in the frame of that link.
    #[arg(long, value_name = "LINK", group = "of_robot")]
    subtree: Option<String>,
    /// Every link of a robot, a row each, and the whole robot: for people, or with --json or --csv.
    #[arg(long, group = "of_robot", conflicts_with_all = ["about", "along", "axes", "as_format"])]
    table: bool,
    /// The value of a joint, in rad or m or with its unit: elbow="30 deg"; joints that follow it do so, others are at zero.
    #[arg(long = "joint", value_name = "NAME=VALUE", requires = "of_robot", conflicts_with = "link", value_parser = joint, allow_hyphen_values = true)]
    joints: Vec<(String, String)>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Which {
    /// A body for each group of links that fixed joints hold together, in the frame of its first link.
    Fixed,
    /// One body, in the frame of the model.
    All,
}

impl RobotFlags {
    /// The first that is given.
    pub(super) const fn given(&self) -> Option<&'static str> {
        match self {
            Self { link: Some(_), .. } => Some("--link"),
            Self { lump: Some(_), .. } => Some("--lump"),
            Self { subtree: Some(_), .. } => Some("--subtree"),
            Self { table: true, .. } => Some("--table"),
            _ => None,
        }
    }

    /// The values of joints, rad or m.
    fn positions(&self, model: &RobotModel) -> Result<Vec<(String, f64)>, Failure> {
        let joints = &self.joints;
        let twice = joints
            .iter()
            .enumerate()
            .find(|(k, (name, _))| joints.iter().take(*k).any(|(other, _)| other == name));
        if let Some((_, (name, _))) = twice {
            let message = format!("--joint {name} is given twice");
            return Err(Failure::usage(message, "a joint has one value: leave one of them out"));
        }
        joints.iter().map(|(name, value)| position(model, name, value)).collect()
    }
}

/// One report for the link, or for each body that is asked for.
pub(super) fn reports(file: &Path, flags: &RobotFlags) -> Result<Vec<InertiaReport>, Failure> {
    let model = read_model(file, &ReadOptions::default())?;
    let lumping = match (&flags.link, flags.lump, &flags.subtree) {
        (Some(name), _, _) => {
            return of_link(&model, name).map(|report| vec![report]).map_err(|error| failure(&model, &error));
        }
        (_, Some(Which::Fixed), _) if !flags.joints.is_empty() => {
            return Err(Failure::usage(
                "--joint is for --lump all: what fixed joints hold together has the same inertia in every position",
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
                format!("{} is a robot of {} links", shown(file), model.links.len()),
                format!(
                    "name one by --link, join them by --lump fixed, --lump all or --subtree, or list them by --table; its links are {}",
                    names.join(", ")
                ),
            ));
        }
    };
    let positions = flags.positions(&model)?;
    of_lumps(&model, lumping, &positions).map_err(|error| failure(&model, &error))
}

/// Prints a table of the links of each robot, if `--table` is given; `fits` refuses a file that the flags do not fit.
pub(super) fn tables(
    files: &[PathBuf],
    flags: &RobotFlags,
    output: &OutputFlags,
    fits: impl Fn(&Path) -> Result<(), Failure>,
) -> Option<Result<(), CommandFailure>> {
    if !flags.table {
        return None;
    }
    let table = |file: &Path| {
        fits(file)?;
        let model = read_model(file, &ReadOptions::default())?;
        let positions = flags.positions(&model)?;
        LinkTable::of(&model, &positions).map_err(|error| failure(&model, &error))
    };
    let tables: Vec<_> = files
        .iter()
        .map(|file| (file.as_path(), table(file).map_err(|failure| failure.about(file))))
        .collect();
    let printed = print(&text_of(&tables, output));
    Some(printed.and_then(|()| {
        CommandFailure::unless_empty(
            tables.into_iter().filter_map(|(_, table)| Some(table.err()?.into())).collect(),
        )
    }))
}

/// Returns the tables in the order of their files. A file that failed has an object with its error in JSON, and is left out elsewhere.
fn text_of(tables: &[(&Path, Result<LinkTable, Failure>)], output: &OutputFlags) -> String {
    let each = || tables.iter().filter_map(|(file, table)| Some((*file, table.as_ref().ok()?)));
    if output.json {
        let value = |(file, table): &(&Path, Result<LinkTable, Failure>)| match table {
            Ok(table) => table.to_json(),
            Err(failure) => CommandFailure::from(failure.clone()).to_json(file),
        };
        return match tables {
            [one] => pretty(&value(one)) + "\n",
            several => pretty(&Value::Array(several.iter().map(value).collect())) + "\n",
        };
    }
    if !output.csv {
        return each().map(|(_, table)| table.to_text()).collect::<Vec<_>>().join("\n");
    }
    for (file, table) in each() {
        let description = printable(&table.whole.source.description);
        tell(&format!("info: {}: {description}\n", shown(file)));
        table.findings().iter().for_each(|finding| tell(&noticed(file, finding)));
    }
    let rows: String = each().map(|(_, table)| table.to_csv()).collect();
    if rows.is_empty() { rows } else { LinkTable::csv_head() + &rows }
}

/// NAME=VALUE, apart; the value waits for its joint to say whether it is an angle or a length.
fn joint(text: &str) -> Result<(String, String), String> {
    let (name, value) = text.rsplit_once('=').ok_or("NAME=VALUE belongs here, such as elbow=0.5")?;
    Ok((name.trim().to_owned(), value.trim().to_owned()))
}

/// The value of a joint, rad or m.
fn position(model: &RobotModel, name: &str, value: &str) -> Result<(String, f64), Failure> {
    let slides = slides(model, name).map_err(|error| failure(model, &error.into()))?;
    let dimension = if slides { Dimension::LENGTH } else { Dimension::ANGLE };
    match quantity(value, dimension) {
        Ok(q) => Ok((name.to_owned(), q)),
        Err(why) => Err(Failure::usage(
            format!("--joint {name}: {why}"),
            if slides {
                "it slides: a length, such as 0.02 or \"20 mm\""
            } else {
                "it turns: an angle, such as 0.5 or \"30 deg\""
            },
        )),
    }
}

/// A failure with its place in the model, if it has one.
fn failure(model: &RobotModel, error: &InertiaError) -> Failure {
    let (message, hint) = (error.to_string(), error.hint());
    match error.span() {
        Some(span) => {
            let FilePlace { file, line, column, .. } = Places::of(model).place(&span);
            Failure::located(message, file, [line, column], hint)
        }
        None => Failure::usage(message, hint).about(&model.path),
    }
}
