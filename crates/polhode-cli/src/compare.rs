//! `polhode compare`

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode_document::Report as _;
use polhode_document::layout::printable_lines;
use polhode_robot::Format;
use polhode_robot::compare::{Request, run};
use polhode_source::shown;

use crate::failure::Failure;
use crate::partial;
use crate::same_file::is_same;
use crate::stdout::print;
use crate::xacro::XacroFlags;

/// Compare two models of one robot, link by link: URDF, SDF, MJCF, USD, OpenSim.
///
/// The mass, the centre of mass and the inertia tensor of each link, and the type and the axis of
/// each joint. Links merged by fixed joints, other link frames, other joint zeros and another place
/// of the base do not count. Links and joints correspond by name, or by --map. Numbers are compared
/// as written, whether physical or not. Limits, couplings and geometry are not compared.
///
/// Exit status: 0 no difference, 1 at least one, 2 a file cannot be read.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode compare robot.urdf robot.xml
  polhode compare old.urdf new.urdf --tolerance 1e-4
  polhode compare robot.urdf robot.urdf.xacro --xacro
  polhode compare robot.urdf robot-fixed.urdf --json
  polhode compare robot.urdf robot.usda --map names.toml
  polhode compare robot.urdf robot.sdf --format junit --output compare.xml")]
pub(crate) struct Compare {
    #[command(flatten)]
    request: Request,
    #[command(flatten)]
    xacro: XacroFlags,
    /// Output format of the differences and notes.
    #[arg(long, value_enum, value_name = "FORM", conflicts_with = "json")]
    format: Option<Format>,
    /// Print JSON, as with --format json.
    #[arg(long)]
    json: bool,
    /// Write the results to FILE, completely or not at all, and print nothing.
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Replace an existing output file; never one of the models.
    #[arg(long, requires = "output")]
    force: bool,
}

impl Compare {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if let Some(output) = &self.output {
            self.require_free(output)?;
        }
        let files = self.xacro.expand([&self.request.a, &self.request.b])?;
        let comparison = run(&self.request, &files)?;
        let form = if self.json { Format::Json } else { self.format.unwrap_or_default() };
        let text = comparison.to_form(form);
        match &self.output {
            Some(path) => {
                let text = printable_lines(&text);
                partial::write(path, self.force, |file| file.write_all(text.as_bytes()))?;
            }
            None => print(&text)?,
        }
        if comparison.has_failed() { Err(Failure::Findings) } else { Ok(()) }
    }

    /// Refuses to overwrite an input.
    fn require_free(&self, output: &Path) -> Result<(), Failure> {
        let inputs = [&self.request.a, &self.request.b].into_iter().chain(&self.request.map);
        match inputs.into_iter().find(|input| is_same(output, input)) {
            Some(input) => Err(Failure::usage(
                format!("--output would overwrite {}, which is an input", shown(input)),
                "write to another file",
            )),
            None => Ok(()),
        }
    }
}
