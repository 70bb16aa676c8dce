//! Robot models in `polhode inertia`.

use std::path::{Path, PathBuf};

use polhode_robot::LinkTables;
use polhode_shape::report::InertiaReport;
use polhode_source::Failure;
use polhode_source::files::Disk;

use super::output::OutputFlags;
use crate::failure::Failure as CommandFailure;
use crate::stderr::tell;
use crate::stdout::print;

pub(super) use polhode_robot::LinkChoice as RobotFlags;

/// Lines for the examples in the help, each after a line break.
pub(super) const EXAMPLES: &str = "
  polhode inertia robot.urdf --link forearm
  polhode inertia robot.urdf --lump all --joint elbow=\"30 deg\" --write mjcf
  polhode inertia robot.urdf --subtree palm --joint left_finger=\"5 mm\"
  polhode inertia robot.urdf --table";

/// Returns true for robot models, by their extension and root element.
pub(super) fn is_model(file: &Path) -> bool {
    polhode_robot::read::is_model(&Disk, file)
}

/// Returns one report for a link, or one for each body of joined links.
pub(super) fn reports(file: &Path, flags: &RobotFlags) -> Result<Vec<InertiaReport>, Failure> {
    flags.reports(&Disk, file)
}

/// Prints a table of the links of each robot if `--table` is given; `fits` refuses a file that
/// contradicts other flags.
pub(super) fn tables(
    files: &[PathBuf],
    flags: &RobotFlags,
    output: &OutputFlags,
    fits: impl Fn(&Path) -> Result<(), Failure>,
) -> Option<Result<(), CommandFailure>> {
    let table = |file: &PathBuf| {
        let table = fits(file).and_then(|()| flags.link_table(&Disk, file));
        (file.clone(), table.map_err(|failure| failure.in_file(file)))
    };
    let print_all = || {
        let tables = LinkTables(files.iter().map(table).collect());
        if output.csv {
            tell(&tables.noticed());
            print(&tables.to_csv())?;
        } else {
            output.form().print(&tables)?;
        }
        let failures = tables.0.into_iter().filter_map(|(_, table)| Some(table.err()?.into()));
        CommandFailure::unless_empty(failures.collect())
    };
    flags.table.then(print_all)
}
