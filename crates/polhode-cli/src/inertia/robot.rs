//! Robot models in `polhode inertia`.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode_document::Report as _;
use polhode_robot::inertials::{Inertials, InertialsOptions, InertialsRequest};
use polhode_robot::link_table::LinkTable;
use polhode_robot::{LinkChoice, LinkTables};
use polhode_shape::Request;
use polhode_shape::report::InertiaReport;
use polhode_source::files::{Files as _, Overlay};
use polhode_source::{Failure, shown};

use super::output::OutputFlags;
use crate::failure::Failure as CommandFailure;
use crate::outputs::Outputs;
use crate::partial;
use crate::stderr::tell;
use crate::stdout::{print, print_exact};
use crate::xacro::{XacroFlags, require_not_expanded};

/// Options that write files.
pub(super) const OUTPUTS: [&str; 2] = ["write_mesh", "write_inertials"];

/// Options that do not apply to inertials from the geometry of links.
const OF_OTHERS: [&str; 32] = [
    "primitive",
    "hull",
    "shell",
    "field",
    "tolerance",
    "weld",
    "fill",
    "close_within",
    "walls",
    "top_layers",
    "bottom_layers",
    "infill",
    "union",
    "write_mesh",
    "unit",
    "mass_unit",
    "isotopes",
    "products",
    "decimal",
    "lump",
    "subtree",
    "skip_invalid",
    "joints",
    "spacing",
    "origin",
    "per_value",
    "format",
    "symbols",
    "about",
    "along",
    "csv",
    "as_format",
];

/// Lines for the examples in the help, each after a line break.
pub(super) const EXAMPLES: &str = "
  polhode inertia robot.urdf --link forearm
  polhode inertia robot.urdf --lump all --joint elbow=\"30 deg\" --write mjcf
  polhode inertia robot.urdf --subtree palm --joint left_finger=\"5 mm\"
  polhode inertia robot.urdf --lump all --skip-invalid
  polhode inertia robot.urdf --table
  polhode inertia robot.urdf.xacro --xacro --lump all
  polhode inertia robot.urdf --write-inertials --material aluminium --part \"hand=1.2 kg\" | patch -p1
  polhode inertia robot.urdf --write-inertials new.urdf --only missing --density \"1.2 g/cm^3\"";

/// Flags for robot models.
#[derive(Debug, Args)]
pub(super) struct RobotFlags {
    #[command(flatten)]
    links: LinkChoice,
    #[command(flatten)]
    xacro: XacroFlags,
    /// Compute the inertial of each link from its geometry, print the diff of the model, and write
    /// nothing. With OUT, also write the new model to OUT. Each link keeps its mass, unless
    /// --density, --material or --part gives another one, or --mass the total of all links, by
    /// volume. --part "LINK=WHAT" is for links by name or pattern ("arm*=steel"), "LINK/PART=WHAT"
    /// for a shape or mesh part. --link chooses links, also by a pattern.
    #[arg(long, value_name = "OUT", num_args = 0..=1, conflicts_with_all = OF_OTHERS)]
    write_inertials: Option<Option<PathBuf>>,
    #[command(flatten)]
    options: InertialsOptions,
}

impl RobotFlags {
    /// Returns the first flag that is given.
    pub(super) const fn given(&self) -> Option<&'static str> {
        self.links.given()
    }
}

/// Returns the files of this machine, with the expansions of xacro files if requested.
pub(super) fn expanded(files: &[PathBuf], flags: &RobotFlags) -> Result<Overlay<'static>, CommandFailure> {
    flags.xacro.expand(files)
}

/// Returns true for robot models, by their extension and root element, and for xacro files.
pub(super) fn is_model(file: &Path, files: &Overlay<'_>) -> bool {
    let is_xacro = || file.extension().is_some_and(|extension| extension == "xacro");
    files.beneath(file).is_some() || is_xacro() || polhode_robot::read::is_model(files, file)
}

/// Returns one report for a link, or one for each body of joined links.
pub(super) fn reports(
    file: &Path,
    flags: &RobotFlags,
    models: &Overlay<'_>,
) -> Result<Vec<InertiaReport>, Failure> {
    flags.links.reports(models, file)
}

/// Prints a table of the links of each robot if `--table` is given; `fits` refuses a file that
/// contradicts other flags.
pub(super) fn tables(
    files: &[PathBuf],
    flags: &RobotFlags,
    output: &OutputFlags,
    models: &Overlay<'_>,
    fits: impl Fn(&Path) -> Result<(), Failure>,
) -> Option<Result<(), CommandFailure>> {
    let table = |file: &PathBuf| {
        let table = fits(file).and_then(|()| flags.links.link_table(models, file));
        (file.clone(), table.map_err(|failure| failure.in_file(file)))
    };
    let print_all = || print_tables(&LinkTables(files.iter().map(table).collect()), output);
    flags.links.table.then(print_all)
}

fn print_tables(tables: &LinkTables, output: &OutputFlags) -> Result<(), CommandFailure> {
    if output.csv {
        tell(&tables.noticed());
        print(&tables.to_csv())?;
    } else {
        output.form().print(tables)?;
    }
    let failures = tables.0.iter().filter_map(|(_, table)| Some(table.as_ref().err()?.clone().into()));
    CommandFailure::unless_empty(failures.collect())
}

/// Writes the inertials of a model if `--write-inertials` is given.
pub(super) fn write_inertials(
    request: &Request,
    flags: &RobotFlags,
    output: &OutputFlags,
    force: bool,
    models: &Overlay<'_>,
) -> Option<Result<(), CommandFailure>> {
    match (&flags.write_inertials, flags.options.given()) {
        (Some(out), _) => Some(written(request, flags, output, (out.as_deref(), force), models)),
        // clap does not check what an option requires if that conflicts with another option.
        (None, Some(option)) => {
            let message = format!("{option} is only for --write-inertials");
            Some(Err(CommandFailure::usage(message, "add --write-inertials, or leave it out")))
        }
        (None, None) => None,
    }
}

fn written(
    request: &Request,
    flags: &RobotFlags,
    output: &OutputFlags,
    (out, force): (Option<&Path>, bool),
    models: &Overlay<'_>,
) -> Result<(), CommandFailure> {
    let file = one_model(request, models)?;
    if out.is_some() {
        require_not_expanded(models, "--write-inertials")?;
    }
    if out.is_none() && force {
        let message = "--write-inertials without a file writes nothing, so --force has no effect";
        return Err(CommandFailure::usage(message, "name the output file, or delete --force"));
    }
    let outputs = Outputs::new([("--write-inertials", out)], force);
    outputs.require_not_read("the model itself", [file].into_iter())?;
    outputs.require_places()?;
    let request = InertialsRequest {
        file: file.to_owned(),
        roots: Vec::new(),
        link: flags.links.link.clone(),
        options: flags.options,
        substance: request.substance.clone(),
        part: request.mesh.part.clone(),
    };
    let inertials = polhode_robot::inertials::write_inertials(&request, models)?;
    outputs.require_not_part_of(&inertials.model)?;
    let inertials = match out {
        Some(out) => {
            partial::write(out, force, |new| new.write_all(inertials.text().as_bytes()))?;
            inertials.written_to(out.to_owned())
        }
        None => inertials,
    };
    print_inertials(&inertials, file, flags, output)?;
    if inertials.has_failed() { Err(CommandFailure::Findings) } else { Ok(()) }
}

/// Prints the table of the new model, JSON, or the reasons above the diff.
fn print_inertials(
    inertials: &Inertials,
    file: &Path,
    flags: &RobotFlags,
    output: &OutputFlags,
) -> Result<(), CommandFailure> {
    if flags.links.table {
        let table = LinkTable::of(inertials.after(), &[]);
        let table = table.map_err(|error| Failure::usage(error.to_string(), error.hint()).in_file(file));
        tell(&inertials.to_text(None));
        return print_tables(&LinkTables(vec![(file.to_owned(), table)]), output);
    }
    if output.form().json {
        return print(&output.form().text(inertials));
    }
    let reasons: String = inertials.lines().iter().map(|line| format!("# {line}\n")).collect();
    print_exact(&(reasons + &inertials.to_diff(&shown(inertials.model.text_path()))))
}

/// Returns the model of a request.
fn one_model<'r>(request: &'r Request, models: &Overlay<'_>) -> Result<&'r Path, Failure> {
    match request.files.as_slice() {
        [file] if is_model(file, models) => Ok(file),
        [file] if file.is_file() => {
            Err(Failure::usage("--write-inertials is only for a robot model", "leave it out").in_file(file))
        }
        [file] => Ok(file),
        files => {
            let message = format!("--write-inertials writes one model, but {} files are named", files.len());
            Err(Failure::usage(message, "name one model"))
        }
    }
}
