//! `polhode inertia`

mod cad;
mod field;
mod kind;
mod mesh;
mod model;
mod molecule;
#[cfg(not(feature = "robot"))]
mod no_robot;
mod output;
mod particles;
#[cfg(feature = "robot")]
mod robot;
mod substance;
mod voxel;
mod written;

use std::path::{Path, PathBuf};

use clap::Args;
use polhode::math::{Body, Part, Position, Rotation};
use polhode_document::SourceInfo;
use polhode_scenario::read as scenario;
use polhode_shape::brep::BrepFormat;
use polhode_shape::mesh::MeshFormat;
use polhode_shape::molecule::MoleculeFormat;
use polhode_shape::report::InertiaReport;
use polhode_source::files::Disk;
use polhode_source::given::{point, positive, rotation, unit_named};
use polhode_source::read_file;
use polhode_source::shown;
use polhode_source::unit::Dimension;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use self::cad::CadFlags;
use self::kind::Kind;
use self::mesh::MeshFlags;
use self::molecule::MoleculeFlags;
#[cfg(not(feature = "robot"))]
use self::no_robot as robot;
use self::output::OutputFlags;
use self::robot::RobotFlags;
use self::substance::SubstanceFlags;
use self::voxel::VoxelFlags;
use self::written::MeshFile;
use crate::failure::Failure;
use crate::progress::FileProgress;
use crate::stdout::print;

/// Mass, centre of mass, inertia tensor, principal moments and axes.
///
/// Of a scenario's body (TOML) or of a mesh (STL). The tensor is about the centre of mass, along body axes; its
/// off-diagonals are minus the integrals, I_xy = -∫xy dm.
#[derive(Debug, Args)]
#[command(after_help = ["\
Examples:
  polhode inertia bracket.stl --unit mm --material aluminium
  polhode inertia bracket.stl --unit mm --mass \"85 g\" --about \"0,0,12 mm\" --json
  polhode inertia arm.obj --part \"rod=steel\" --part \"grip=85 g\" --as urdf", robot::EXAMPLES, "
  polhode inertia torn.stl --unit mm --material steel --weld \"0.01 mm\" --write-mesh whole.stl
  polhode inertia gripper.stl --unit mm --material steel --union
  polhode inertia parts/*.stl --unit mm --material steel --csv
  polhode inertia examples/notes/11-05-principal-axes.toml --axes"].concat())]
pub(crate) struct Inertia {
    /// Scenarios, meshes, molecules, particles, voxel grids, CAD reports, robots; what each is, its ending says.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    substance: SubstanceFlags,
    #[command(flatten)]
    mesh: MeshFlags,
    /// The unit of length in a file that does not say it, such as mm or in [default for meshes: m].
    #[arg(long, value_name = "UNIT", value_parser = length_unit)]
    unit: Option<f64>,
    /// The unit of mass in a file that does not say it, such as g or lbm.
    #[arg(long, value_name = "UNIT", value_parser = mass_unit)]
    mass_unit: Option<f64>,
    #[command(flatten)]
    molecule: MoleculeFlags,
    #[command(flatten)]
    cad: CadFlags,
    #[command(flatten)]
    robot: RobotFlags,
    #[command(flatten)]
    voxel: VoxelFlags,
    /// What the files are, if their endings do not say it.
    #[arg(long, value_name = "KIND")]
    format: Option<Kind>,
    /// Also the tensor about this point: x,y,z from the origin, each with its unit or in metres.
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true, conflicts_with_all = ["csv", "as_format"])]
    about: Option<Position<Body>>,
    /// Also the tensor along axes turned by this unit quaternion (scalar first, turned axes to body axes).
    #[arg(long, value_name = "W,X,Y,Z", value_parser = rotation::<Body, Part>, allow_hyphen_values = true, conflicts_with_all = ["csv", "as_format"])]
    along: Option<Rotation<Body, Part>>,
    /// Print the principal axes too; JSON and tables have them always.
    #[arg(long, conflicts_with = "as_format")]
    axes: bool,
    #[command(flatten)]
    output: OutputFlags,
}

impl Inertia {
    pub(crate) fn run(self) -> Result<(), Failure> {
        self.mesh.check_output(self.files.len())?;
        let fits = |file: &Path| self.kind(file).map(drop);
        if let Some(done) = robot::tables(&self.files, &self.robot, &self.output, fits) {
            return done;
        }
        let (mut answers, mut written) = (Vec::new(), Vec::new());
        let mut progress = FileProgress::new(self.files.len());
        for file in &self.files {
            progress.next(file);
            answers.push((
                file.as_path(),
                self.reports(file, &mut written).map_err(|failure| failure.about(file)),
            ));
        }
        drop(progress);
        let text = self.output.text(&answers);
        self.output.warn(&answers);
        let mut failures: Vec<_> = answers.into_iter().filter_map(|(_, answer)| answer.err()).collect();
        match text {
            Ok(text) => {
                if failures.is_empty() {
                    written.iter().try_for_each(MeshFile::write)?;
                }
                print(&text)?;
            }
            Err(failure) => failures.push(failure),
        }
        Failure::unless_empty(failures)
    }

    /// What a file is, if the flags fit that.
    fn kind(&self, file: &Path) -> Result<Kind, Failure> {
        if self.format.is_none_or(Kind::is_mesh)
            && let Some(format) = BrepFormat::of_content(&Disk, file)
        {
            return Err(Failure::usage(format.refusal(), format.hint(file)));
        }
        if self.format.is_none()
            && let Some(format) = BrepFormat::of_path(file)
        {
            read_file(&Disk, file, |bytes| match bytes {
                [] => Err(nothing_of(format)),
                _ => Ok(()),
            })?;
            return Err(Failure::usage(format.refusal(), format.hint(file)));
        }
        // The ending .xyz is of molecules and of clouds of points, of which only the hull is a body.
        let of_path = || match Kind::of_path(file) {
            Some(Kind::Xyz) if self.mesh.is_hull() => Some(Kind::Mesh(MeshFormat::Points)),
            kind => kind,
        };
        let Some(kind) = self.format.or_else(of_path) else {
            return Err(Failure::usage(
                format!("{} has an unknown file extension", shown(file)),
                format!("say what it is by --format; scenarios are .toml, meshes {}", mesh_extensions()),
            ));
        };
        self.refuse_flags_for(kind, file)?;
        self.refuse_idle_units(kind, file)?;
        Ok(kind)
    }

    /// The reports of a file: one, or one for each of its molecules. What is to be written with them, when all is known, goes to `written`.
    fn reports(&self, file: &Path, written: &mut Vec<MeshFile>) -> Result<Vec<InertiaReport>, Failure> {
        let kind = self.kind(file)?;
        let reports = match kind {
            Kind::Scenario => vec![of_scenario(file)?],
            Kind::Particles => {
                vec![particles::report(file, self.substance.mass(), self.unit, self.mass_unit)?]
            }
            Kind::Cad => {
                vec![cad::report(file, &self.cad, self.substance.given(), self.unit, self.mass_unit)?]
            }
            Kind::Xyz => molecule::reports(file, MoleculeFormat::Xyz, &self.molecule)?,
            Kind::Mol => {
                let format = MoleculeFormat::of_path(file).filter(|format| *format == MoleculeFormat::Sdf);
                molecule::reports(file, format.unwrap_or(MoleculeFormat::Mol), &self.molecule)?
            }
            Kind::Pdb => molecule::reports(file, MoleculeFormat::Pdb, &self.molecule)?,
            Kind::Robot => robot::reports(file, &self.robot)?,
            Kind::Npy => vec![voxel::report(file, "npy", &self.voxel, self.unit)?],
            Kind::Nrrd => vec![voxel::report(file, "nrrd", &self.voxel, self.unit)?],
            Kind::Mesh(format) => {
                let (report, file) = mesh::report(file, format, self.unit, &self.substance, &self.mesh)?;
                written.extend(file);
                vec![report]
            }
        };
        reports.into_iter().map(|report| self.finished(report)).collect()
    }

    /// The report with the point and the axes that are asked for.
    fn finished(&self, report: InertiaReport) -> Result<InertiaReport, Failure> {
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

    /// A flag that means nothing for this kind of file is an error, not ignored.
    fn refuse_flags_for(&self, kind: Kind, file: &Path) -> Result<(), Failure> {
        let mesh = kind.is_mesh();
        let voxels = matches!(kind, Kind::Npy | Kind::Nrrd);
        let listed = matches!(kind, Kind::Cad | Kind::Particles);
        let checks = [
            (
                self.substance.given().and(Some("--density, --mass or --material")),
                mesh || kind == Kind::Cad,
                "a mesh or the measures of a shape",
            ),
            (
                self.unit.and(Some("--unit")),
                mesh || kind == Kind::Nrrd || listed,
                "a mesh, an NRRD grid, particles or a CAD report",
            ),
            (self.mass_unit.and(Some("--mass-unit")), listed, "particles or a CAD report"),
            (self.mesh.given(), mesh, "a mesh"),
            (self.cad.given(), kind == Kind::Cad, "a CAD report"),
            (self.molecule.given(), matches!(kind, Kind::Xyz | Kind::Mol | Kind::Pdb), "a molecule"),
            (self.robot.given(), kind == Kind::Robot, "a robot model"),
            (self.voxel.given(), voxels, "a voxel grid"),
        ];
        let fits = |what: &str| what != "--density, --mass or --material" || !self.only_mass_of(kind);
        match checks
            .into_iter()
            .find_map(|(flag, fit, owner)| flag.filter(|f| !fit && fits(f)).map(|f| (f, owner)))
        {
            None => Ok(()),
            Some((flag, owner)) => Err(Failure::usage(
                format!("{flag} is for {owner}, and {} is {}", shown(file), kind.in_words()),
                match kind {
                    Kind::Scenario => "a scenario says what each of its parts is made of, and in which units",
                    _ => "leave it out, or say by --format what the file is",
                },
            )),
        }
    }

    /// A unit for a file that names its units itself is an error, not ignored.
    fn refuse_idle_units(&self, kind: Kind, file: &Path) -> Result<(), Failure> {
        let readable = |unit, mass_unit| match kind {
            Kind::Particles => particles::report(file, self.substance.mass(), unit, mass_unit).is_ok(),
            Kind::Cad if cad::leaves_unit_open(file) => false,
            Kind::Cad => cad::report(file, &self.cad, self.substance.given(), unit, mass_unit).is_ok(),
            _ => false,
        };
        let idle = if self.unit.is_some() && readable(None, self.mass_unit) {
            "--unit"
        } else if self.mass_unit.is_some() && readable(self.unit, None) {
            "--mass-unit"
        } else {
            return Ok(());
        };
        Err(Failure::usage(
            format!(
                "{idle} is for a file that does not name its unit, and {} does, or needs none",
                file.display()
            ),
            "leave it out",
        ))
    }

    /// Points without masses share --mass.
    fn only_mass_of(&self, kind: Kind) -> bool {
        kind == Kind::Particles && self.substance.mass().is_some()
    }
}

/// That a file has no bytes.
fn nothing_of(format: BrepFormat) -> ContentError {
    let kind =
        ContentErrorKind::Expected { what: format!("a {} file", format.title()), found: String::new() };
    ContentError::new(kind, ContentPlace::Whole).hint("the file is empty: export it again")
}

/// `.stl, .obj, …`
fn mesh_extensions() -> String {
    let all = MeshFormat::ALL.iter().flat_map(|format| format.extensions());
    all.map(|extension| format!(".{extension}")).collect::<Vec<_>>().join(", ")
}

fn of_scenario(file: &Path) -> Result<InertiaReport, Failure> {
    let scenario = scenario::read(file)?;
    let title = scenario.title().unwrap_or("scenario");
    let source = SourceInfo::new(file.display().to_string(), "scenario")
        .described(title)
        .with("title", scenario.title().map(str::to_owned))
        .with("parts", scenario.parts().len());
    Ok(InertiaReport::of_scenario(source, &scenario))
}

fn length_unit(text: &str) -> Result<f64, String> {
    if !text.starts_with(char::is_alphabetic) {
        return Err("the name of a unit of length belongs here, such as mm".to_owned());
    }
    positive(unit_named(text, Dimension::LENGTH)?)
}

fn mass_unit(text: &str) -> Result<f64, String> {
    if !text.starts_with(char::is_alphabetic) {
        return Err("the name of a unit of mass belongs here, such as g".to_owned());
    }
    positive(unit_named(text, Dimension::MASS)?)
}
