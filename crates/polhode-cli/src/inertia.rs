//! `polhode inertia`

mod mesh;
mod output;
mod substance;

use std::path::{Path, PathBuf};

use clap::Args;
use polhode::{Body, Part, Position, Rotation};
use polhode_formats::mesh::MeshFormat;
use polhode_formats::scenario;
use polhode_formats::unit::Dimension;
use polhode_report::{InertiaReport, SourceInfo};

use self::mesh::MeshFlags;
use self::output::OutputFlags;
use self::substance::SubstanceFlags;
use crate::failure::Failure;
use crate::numbers::{numbers, positive, quantity, rotation};
use crate::progress::FileProgress;
use crate::stdout::print;

/// Mass, centre of mass, inertia tensor, principal moments and axes.
///
/// Of a scenario's body (TOML) or of a mesh (STL). The tensor is about the centre of mass, along body axes; its
/// off-diagonals are minus the integrals, I_xy = -∫xy dm.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode inertia bracket.stl --unit mm --material aluminium
  polhode inertia bracket.stl --unit mm --mass \"85 g\" --about \"0,0,12 mm\" --json
  polhode inertia arm.obj --part \"rod=steel\" --part \"grip=85 g\" --as urdf
  polhode inertia parts/*.stl --unit mm --material steel --csv
  polhode inertia examples/notes/11-05-principal-axes.toml --axes")]
pub(crate) struct Inertia {
    /// Scenario files (.toml) and meshes (.stl, .obj, .ply, .off, .gltf, .glb, .3mf).
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    substance: SubstanceFlags,
    #[command(flatten)]
    mesh: MeshFlags,
    /// The unit of length in a mesh file, such as mm or in; meshes say none [default: m].
    #[arg(long, value_name = "UNIT", value_parser = length_unit)]
    unit: Option<f64>,
    /// Also the tensor about this point: x,y,z from the origin, each with its unit or in metres.
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    about: Option<Position<Body>>,
    /// Also the tensor along axes turned by this unit quaternion (scalar first, turned axes to body axes).
    #[arg(long, value_name = "W,X,Y,Z", value_parser = rotation::<Body, Part>, allow_hyphen_values = true)]
    along: Option<Rotation<Body, Part>>,
    /// Print the principal axes too.
    #[arg(long)]
    axes: bool,
    #[command(flatten)]
    output: OutputFlags,
}

impl Inertia {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let mut reports = Vec::new();
        let mut errors = Vec::new();
        let mut progress = FileProgress::new(self.files.len());
        for file in &self.files {
            progress.next(file);
            match self.report(file) {
                Ok(report) => reports.push((file.clone(), report)),
                Err(Failure::Input(found)) => errors.extend(found),
                Err(other) => return Err(other),
            }
        }
        drop(progress);
        if !errors.is_empty() {
            return Err(Failure::Input(errors));
        }
        print(self.output.text(&reports)?.as_bytes())
    }

    fn report(&self, file: &Path) -> Result<InertiaReport, Failure> {
        let extension = file.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
        let report = match extension.as_str() {
            "toml" => self.of_scenario(file)?,
            _ => match MeshFormat::of_path(file) {
                Some(format) => mesh::report(file, format, self.unit, &self.substance, &self.mesh)?,
                None => {
                    return Err(Failure::usage(
                        format!("{} is no file that polhode reads", file.display()),
                        "a scenario's name ends in .toml, a mesh's in .stl, .obj, .ply, .off, .gltf, .glb or .3mf",
                    ));
                }
            },
        };
        let about = self.about.or(report.about);
        if let Some(point) = about
            && report.properties.inertia_about(point).matrix().iter().flatten().any(|e| !e.is_finite())
        {
            return Err(Failure::usage(
                "the tensor about that point is too large for a number",
                "check --about",
            ));
        }
        Ok(InertiaReport { about, axes: self.along, show_axes: self.axes, ..report })
    }

    fn of_scenario(&self, file: &Path) -> Result<InertiaReport, Failure> {
        if self.substance.given().is_some() || self.unit.is_some() || self.mesh.any() {
            let flags = "--density, --mass, --material, --part and --unit are for meshes";
            return Err(Failure::usage(
                format!("{flags}, and {} is a scenario", file.display()),
                "a scenario says what each of its parts is made of, and in which units",
            ));
        }
        let scenario = scenario::read(file)?;
        let title = scenario.title.as_deref().unwrap_or("scenario");
        let source = SourceInfo::new(file.display().to_string(), "scenario")
            .described(title)
            .with("title", scenario.title.clone())
            .with("parts", scenario.parts.len());
        Ok(InertiaReport::of_scenario(source, &scenario))
    }
}

fn length_unit(text: &str) -> Result<f64, String> {
    if !text.starts_with(char::is_alphabetic) {
        return Err("the name of a unit of length belongs here, such as mm".to_owned());
    }
    positive(quantity(&format!("1 {text}"), Dimension::LENGTH)?)
}

fn point(text: &str) -> Result<Position<Body>, String> {
    numbers(text, "x,y,z", Dimension::LENGTH).map(Position::from_array)
}
