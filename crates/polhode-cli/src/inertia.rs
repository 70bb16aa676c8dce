//! `polhode inertia`

use std::path::{Path, PathBuf};

use clap::Args;
use polhode::{
    Body, Finding, Material, Part, PlacedPart, Position, Rotation, Severity, Shape as _, Substance,
};
use polhode_formats::mesh::stl::StlKind;
use polhode_formats::mesh::{self, MeshFile};
use polhode_formats::scenario;
use polhode_formats::unit::Dimension;
use polhode_report::{InertiaReport, SourceInfo, pretty};
use serde_json::Value;

use crate::failure::Failure;
use crate::numbers::{numbers, positive, quantity, rotation};
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
  polhode inertia examples/notes/11-05-principal-axes.toml --axes")]
pub(crate) struct Inertia {
    /// Scenario files (.toml) and meshes (.stl).
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    substance: SubstanceFlags,
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
    /// Print JSON: one object for one file, an array for several.
    #[arg(long)]
    json: bool,
}

/// What a mesh is made of.
#[derive(Debug, Args)]
#[group(multiple = false)]
struct SubstanceFlags {
    /// Density of a mesh, such as "2700 kg/m^3" or "2.7 g/cm^3".
    #[arg(long, value_parser = density)]
    density: Option<f64>,
    /// Mass of a mesh, such as "85 g".
    #[arg(long, value_parser = mass)]
    mass: Option<f64>,
    /// Material of a mesh by name, such as aluminium or steel.
    #[arg(long, value_parser = material)]
    material: Option<Material>,
}

impl Inertia {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let mut reports = Vec::new();
        let mut errors = Vec::new();
        for file in &self.files {
            match self.report(file) {
                Ok(report) => reports.push(report),
                Err(Failure::Input(found)) => errors.extend(found),
                Err(other) => return Err(other),
            }
        }
        if !errors.is_empty() {
            return Err(Failure::Input(errors));
        }
        let text = if !self.json {
            reports.iter().map(InertiaReport::to_text).collect::<Vec<_>>().join("\n")
        } else if let [report] = reports.as_slice() {
            pretty(&report.to_json()) + "\n"
        } else {
            pretty(&Value::Array(reports.iter().map(InertiaReport::to_json).collect())) + "\n"
        };
        print(text.as_bytes())
    }

    fn report(&self, file: &Path) -> Result<InertiaReport, Failure> {
        let extension = file.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
        let report = match extension.as_str() {
            "toml" => self.of_scenario(file)?,
            "stl" => self.of_mesh(file)?,
            _ => {
                return Err(Failure::usage(
                    format!("{} is neither a scenario nor a mesh that polhode reads", file.display()),
                    "a scenario's name ends in .toml, a mesh's in .stl",
                ));
            }
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
        if self.substance.given().is_some() || self.unit.is_some() {
            let flags = "--density, --mass, --material and --unit are for meshes";
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

    fn of_mesh(&self, file: &Path) -> Result<InertiaReport, Failure> {
        let unit = self.unit.unwrap_or(1.0);
        let file_read = mesh::read(file, unit)?;
        let mut findings = file_read.findings(&file.display().to_string());
        let MeshFile { mesh, kind, triangles, .. } = file_read;
        let substance = self.substance.given().unwrap_or_else(|| {
            findings.push(Finding {
                code: "mass.assumed",
                severity: Severity::Warning,
                message: "neither density, mass nor material is given: 1 kg/m³ is assumed".to_owned(),
                place: Some("--density, --mass or --material".to_owned()),
            });
            Substance::Density(1.0)
        });
        let invalid = |message: String| Failure::usage(message, "check --density, --mass and --unit");
        let part = mesh.mass_properties(substance).map_err(|e| invalid(e.to_string()))?;
        let placed = PlacedPart::new(part, Position::ZERO, Rotation::identity());
        let properties = placed.map_err(|e| invalid(e.to_string()))?.in_body();
        let encoding = match kind {
            StlKind::Binary => "binary",
            StlKind::Ascii => "ascii",
        };
        let description = format!(
            "STL {encoding}, {triangles} triangles, closed, {}",
            if mesh.inverted() { "wound inward (turned)" } else { "consistently wound" }
        );
        let source = SourceInfo::new(file.display().to_string(), "stl")
            .described(description)
            .with("encoding", encoding)
            .with("triangles", triangles)
            .with("vertices", mesh.vertices())
            .with("unit_m", unit);
        Ok(InertiaReport {
            volume: Some(mesh.volume()),
            surface_area: Some(mesh.surface_area()),
            density: Some(properties.mass() / mesh.volume()),
            findings,
            ..InertiaReport::new(source, properties)
        })
    }
}

impl SubstanceFlags {
    fn given(&self) -> Option<Substance> {
        let density = self.density.or(self.material.map(|m| m.density)).map(Substance::Density);
        density.or(self.mass.map(Substance::Mass))
    }
}

fn density(text: &str) -> Result<f64, String> {
    positive(quantity(text, Dimension::DENSITY)?)
}

fn mass(text: &str) -> Result<f64, String> {
    positive(quantity(text, Dimension::MASS)?)
}

fn length_unit(text: &str) -> Result<f64, String> {
    if !text.starts_with(char::is_alphabetic) {
        return Err("the name of a unit of length belongs here, such as mm".to_owned());
    }
    positive(quantity(&format!("1 {text}"), Dimension::LENGTH)?)
}

fn material(text: &str) -> Result<Material, String> {
    Material::named(text).ok_or_else(|| {
        let names: Vec<_> = Material::ALL.iter().map(|m| m.name).collect();
        format!("no such material (known: {})", names.join(", "))
    })
}

fn point(text: &str) -> Result<Position<Body>, String> {
    numbers(text, "x,y,z", Dimension::LENGTH).map(Position::from_array)
}
