//! Runs an inertia request.

use std::path::Path;

use polhode::math::{Body, Position};
use polhode_source::files::Files;
use polhode_source::{ContentError, ContentErrorKind};
use polhode_source::{Failure, read_file, shown};

use super::bodies::{Bodies, FileBodies};
use super::host::Host;
use super::kind::Kind;
use super::request::{Point, Request};
use super::written::{MeshFile, written_format};
use super::{cad, mesh, molecule, particles, voxel};
use crate::brep::BrepFormat;
use crate::mesh::MeshFormat;
use crate::molecule::MoleculeFormat;
use crate::report::InertiaReport;

/// Returns the mass properties of the bodies in files (meshes, molecules, particles, voxel grids and
/// CAD reports), or of a shape.
///
/// A file that cannot be read has its failure in the result.
///
/// # Errors
/// [`Failure`] if options contradict each other, if a shape lacks its mass, or if a mesh is to be
/// written for several files, or in a format that cannot be written.
pub fn run(request: &Request, files: &dyn Files) -> Result<Bodies, Failure> {
    run_in(request, files, &mut ())
}

/// Runs a request as [`run`] does. `host` reads scenarios and robot models, and receives progress.
///
/// # Errors
/// [`Failure`], as for [`run`].
pub fn run_in(request: &Request, files: &dyn Files, host: &mut dyn Host) -> Result<Bodies, Failure> {
    if let Some(target) = &request.mesh.write_mesh {
        if request.files.len() > 1 {
            let message = "--write-mesh writes one mesh, but several files are given";
            return Err(Failure::usage(message, "name one"));
        }
        written_format(target)?;
    }
    request.substance.refuse_several()?;
    if let Some(shape) = request.primitive(host)? {
        return Ok(Bodies { files: vec![shape], mesh: None });
    }
    let mut bodies = Bodies { files: Vec::new(), mesh: None };
    for path in &request.files {
        host.begin(path);
        let reports = request.reports(path, files, host, &mut bodies.mesh);
        let reports = reports.map_err(|failure| failure.in_file(path));
        bodies.files.push(FileBodies { path: path.clone(), reports });
    }
    Ok(bodies)
}

impl Request {
    /// Returns the kind of a file.
    ///
    /// # Errors
    /// [`Failure`] if the kind is unknown, or if an option does not apply to it.
    pub fn kind(&self, file: &Path, files: &dyn Files, host: &dyn Host) -> Result<Kind, Failure> {
        if self.format.is_none_or(Kind::is_mesh)
            && let Some(format) = BrepFormat::of_content(files, file)
        {
            return Err(Failure::usage(format.refusal(), format.hint(file)));
        }
        if self.format.is_none()
            && let Some(format) = BrepFormat::of_path(file)
        {
            read_file(files, file, |bytes| match bytes {
                [] => Err(nothing_of(format)),
                _ => Ok(()),
            })?;
            return Err(Failure::usage(format.refusal(), format.hint(file)));
        }
        let of_path = || match Kind::of_path(file) {
            _ if host.is_robot(file) => Some(Kind::Robot),
            // The extension .xyz stands for molecules and for point clouds. The latter are bodies
            // only with the hull option.
            Some(Kind::Xyz) if self.mesh.hull => Some(Kind::Mesh(MeshFormat::Points)),
            kind => kind,
        };
        let Some(kind) = self.format.or_else(of_path) else {
            return Err(Failure::usage(
                format!("{} has an unknown file extension", shown(file)),
                format!("give its format by --format; scenarios are .toml, meshes {}", mesh_extensions()),
            ));
        };
        self.refuse_options_for(Some(kind), &format!("{} is {}", shown(file), kind.in_words()), host)?;
        self.refuse_idle_units(kind, file, files)?;
        Ok(kind)
    }

    /// Returns the reports of a file: one for each of its bodies. A mesh to be written is stored in
    /// `written`.
    fn reports(
        &self,
        file: &Path,
        files: &dyn Files,
        host: &mut dyn Host,
        written: &mut Option<MeshFile>,
    ) -> Result<Vec<InertiaReport>, Failure> {
        let molecules = |format| molecule::reports(files, file, format, self);
        let reports = match self.kind(file, files, host)? {
            kind @ (Kind::Scenario | Kind::Robot) => host.reports(file, kind)?,
            Kind::Particles => vec![particles::report(files, file, self)?],
            Kind::Cad => vec![cad::report(files, file, self)?],
            Kind::Xyz => molecules(MoleculeFormat::Xyz)?,
            Kind::Mol => {
                let format = MoleculeFormat::of_path(file).filter(|format| *format == MoleculeFormat::Sdf);
                molecules(format.unwrap_or(MoleculeFormat::Mol))?
            }
            Kind::Pdb => molecules(MoleculeFormat::Pdb)?,
            Kind::Npy => vec![voxel::report(files, file, "npy", self)?],
            Kind::Nrrd => vec![voxel::report(files, file, "nrrd", self)?],
            Kind::Mesh(format) => {
                let (report, mesh) = mesh::report(files, file, format, self, host)?;
                *written = mesh;
                vec![report]
            }
        };
        reports.into_iter().map(|report| self.finished(report, None)).collect()
    }

    /// Returns the report of the requested shape; its name serves as its path.
    fn primitive(&self, host: &dyn Host) -> Result<Option<FileBodies>, Failure> {
        let shape = match (self.primitive.given().as_slice(), self.files.first()) {
            ([], _) => return Ok(None),
            ([shape], None) => *shape,
            ([shape], Some(file)) => {
                let message =
                    format!("--{} and the file {} contradict each other", shape.name(), shown(file));
                return Err(Failure::usage(message, "give a shape or files, not both"));
            }
            ([first, second, ..], _) => {
                let message = format!("--{} and --{} contradict each other", first.name(), second.name());
                return Err(Failure::usage(
                    message,
                    "give one shape; several form a body in a scenario file",
                ));
            }
        };
        self.refuse_options_for(None, &format!("--{} is a shape", shape.name()), host)?;
        let report = self.finished(shape.report(self.substance.given())?, shape.corner())?;
        Ok(Some(FileBodies { path: shape.name().into(), reports: Ok(vec![report]) }))
    }

    /// Adds the point and the axes of the request to a report. `corner` is the corner of a box.
    fn finished(
        &self,
        report: InertiaReport,
        corner: Option<Position<Body>>,
    ) -> Result<InertiaReport, Failure> {
        let about = match self.about.as_ref().map(|point| point.value) {
            None => report.about,
            Some(Point::At(point)) => Some(point),
            Some(Point::Corner) => Some(corner.ok_or_else(|| {
                let hint = "write the point as x,y,z from the origin, such as --about \"0,0,12 mm\"";
                Failure::usage("--about corner is only for --box", hint)
            })?),
        };
        if let Some(point) = about
            && report.properties.inertia_about(point).matrix().iter().flatten().any(|e| !e.is_finite())
        {
            return Err(Failure::usage(
                "the tensor about that point is too large for a double",
                "check --about",
            ));
        }
        let axes = self.along.as_ref().map(|turn| turn.value.0);
        Ok(InertiaReport { about, axes, ..report })
    }

    /// Returns an error for an option that does not apply to this kind of file, or to a shape
    /// (`None`). `body` states the kind in words.
    fn refuse_options_for(&self, kind: Option<Kind>, body: &str, host: &dyn Host) -> Result<(), Failure> {
        const SUBSTANCE: &str = "--density, --mass or --material";
        let is = |some: Kind| kind == Some(some);
        let mesh = kind.is_some_and(Kind::is_mesh);
        let voxels = is(Kind::Npy) || is(Kind::Nrrd);
        let listed = is(Kind::Cad) || is(Kind::Particles);
        // Points without masses share the total mass.
        let has_substance =
            mesh || kind.is_none() || is(Kind::Cad) || is(Kind::Particles) && self.substance.mass().is_some();
        let checks = [
            (self.format.and(Some("--format")), kind.is_some(), "a file"),
            (self.substance.given().and(Some(SUBSTANCE)), has_substance, "a mesh or the measures of a shape"),
            (
                self.unit.as_ref().and(Some("--unit")),
                mesh || is(Kind::Nrrd) || listed,
                "a mesh, an NRRD grid, particles or a CAD report",
            ),
            (self.mass_unit.as_ref().and(Some("--mass-unit")), listed, "particles or a CAD report"),
            (self.mesh.given(), mesh, "a mesh"),
            (self.cad.given(), is(Kind::Cad), "a CAD report"),
            (self.molecule.given(), is(Kind::Xyz) || is(Kind::Mol) || is(Kind::Pdb), "a molecule"),
            (host.robot_option(), is(Kind::Robot), "a robot model"),
            (self.voxel.given(), voxels, "a voxel grid"),
        ];
        let refused =
            checks.into_iter().find_map(|(option, fits, owner)| Some((option.filter(|_| !fits)?, owner)));
        match refused {
            None => Ok(()),
            Some((option, owner)) => Err(Failure::usage(
                format!("{option} is only for {owner}, but {body}"),
                match kind {
                    None => "delete it",
                    Some(Kind::Scenario) => "a scenario states the substance and the units of each part",
                    Some(_) => "delete it, or give the kind of the file by --format",
                },
            )),
        }
    }

    /// Returns an error for a unit if the file states its own units.
    fn refuse_idle_units(&self, kind: Kind, file: &Path, files: &dyn Files) -> Result<(), Failure> {
        let is_readable = |request: &Self| match kind {
            Kind::Particles => particles::report(files, file, request).is_ok(),
            Kind::Cad if cad::leaves_unit_open(files, file) => false,
            Kind::Cad => cad::report(files, file, request).is_ok(),
            _ => false,
        };
        let idle = if self.unit.is_some() && is_readable(&Self { unit: None, ..self.clone() }) {
            "--unit"
        } else if self.mass_unit.is_some() && is_readable(&Self { mass_unit: None, ..self.clone() }) {
            "--mass-unit"
        } else {
            return Ok(());
        };
        let path = file.display();
        Err(Failure::usage(
            format!("{idle} is only for a file that states no unit, but {path} states one or needs none"),
            "leave it out",
        ))
    }
}

/// Returns the error of an empty file.
fn nothing_of(format: BrepFormat) -> ContentError {
    let kind = ContentErrorKind::expected(format!("a {} file", format.title()), "");
    kind.of_whole().hint("the file is empty: export it again")
}

/// Returns the list of mesh extensions: `.stl, .obj, …`
fn mesh_extensions() -> String {
    let all = MeshFormat::ALL.iter().flat_map(|format| format.extensions());
    all.map(|extension| format!(".{extension}")).collect::<Vec<_>>().join(", ")
}
