//! Meshes: of files, and of arrays.

use std::path::{Path, PathBuf};

use numpy::PyReadonlyArray2;
use polhode::body::density::{Cubature, FieldError, Solid, mass_properties_of_field};
use polhode::body::mesh::{ConvexHull, MeshShell, TriangleMesh};
use polhode::body::shape::{Extent, Shape, Substance};
use polhode::body::{BodyError, Finding, MassProperties, Severity};
use polhode_document::Extra;
use polhode_document::SourceInfo;
use polhode_shape::mesh::{
    AssumedMetres, MeshContents, MeshFormat, MeshLength, MeshPart, MeshRepair, MeshSolid, RepairBound,
    SolidPart, UnitedMesh,
};
use polhode_shape::report::{InertiaReport, PartRow, error_estimate, parts};
use polhode_source::expression::Expression;
use polhode_source::files::Disk;
use pyo3::prelude::*;

use crate::arrays::rows;
use crate::error::{Raise, refused};
use crate::interrupt::{copied, watched_apart};
use crate::mass_properties::PyMassProperties;
use crate::shape::in_body;
use crate::substance::Given;

/// How a mesh is taken.
#[derive(Clone, Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct MeshOptions {
    /// Metres in the file's unit of length.
    unit: Option<f64>,
    /// The convex hull of each part instead of the mesh.
    hull: bool,
    /// A sheet of this thickness instead of the solid, m.
    shell: Option<f64>,
    /// How far apart vertices of open edges may be that are joined, as text.
    weld: Option<String>,
    /// How far across holes may be that are filled, as text.
    fill: Option<String>,
    /// What lies in several parts once.
    union: bool,
    /// What parts of these names are made of.
    parts: Vec<(String, Given)>,
    /// The density as a formula of x, y and z, m, in kg/m³.
    field: Option<String>,
    /// The relative error that is good enough for it.
    tolerance: Option<f64>,
}

/// A length beside the mesh, of an option of this name.
fn length(name: &str, text: Option<&String>) -> PyResult<Option<MeshLength>> {
    let parsed = text.map(|text| MeshLength::parse(text)).transpose();
    parsed.map_err(|error| refused(format!("{name}: {error}"), error.hint().as_deref()))
}

/// The mass properties of a mesh file.
///
/// # Errors
/// `PolhodeError` if it cannot be read, or bounds no solid.
#[pyfunction]
pub(crate) fn mesh_file(
    py: Python<'_>,
    path: PathBuf,
    format: &str,
    options: MeshOptions,
    given: Given,
) -> PyResult<PyMassProperties> {
    let format = MeshFormat::ALL
        .iter()
        .copied()
        .find(|known| known.name() == format)
        .ok_or_else(|| refused(format!("no mesh format is called {format:?}"), None))?;
    let substance = (given.substance()?, own(&options.parts)?);
    watched_apart(py, move |goes_on| {
        let contents = match options.hull {
            true => MeshContents::read_for_hull(&Disk, &path, format),
            false => MeshContents::read(&Disk, &path, format),
        };
        let contents = contents.map_err(Raise::raise)?;
        let title = format!("{} {}", format.title(), contents.encoding).trim_end().to_owned();
        let source = SourceInfo::new(path.display().to_string(), format.name());
        of_contents(contents, (&path, format), &options, substance, (source, &title), goes_on)
    })?
}

/// The mass properties of triangles: vertices (n, 3), m, and the numbers of three of them for each triangle (m, 3).
///
/// # Errors
/// `PolhodeError` if they bound no solid.
#[pyfunction]
pub(crate) fn mesh_arrays(
    py: Python<'_>,
    vertices: PyReadonlyArray2<'_, f64>,
    triangles: PyReadonlyArray2<'_, u32>,
    options: MeshOptions,
    given: Given,
) -> PyResult<PyMassProperties> {
    let substance = (given.substance()?, own(&options.parts)?);
    let points = copied(py, rows::<3>(&vertices)?)?;
    let corners = triangles.as_slice().map_err(|error| refused(error.to_string(), None))?;
    let corners = copied(py, corners.as_chunks().0)?;
    of_arrays(py, move || TriangleMesh::new(points, corners), options, substance)
}

/// The mass properties of triangles by their corners (n, 9), m.
///
/// # Errors
/// `PolhodeError` if they bound no solid.
#[pyfunction]
pub(crate) fn mesh_corners(
    py: Python<'_>,
    corners: PyReadonlyArray2<'_, f64>,
    options: MeshOptions,
    given: Given,
) -> PyResult<PyMassProperties> {
    let substance = (given.substance()?, own(&options.parts)?);
    let triangles = copied(py, rows::<9>(&corners)?)?;
    let mesh = move || {
        let corner = |[a, b, c, d, e, f, g, h, i]: [f64; 9]| [[a, b, c], [d, e, f], [g, h, i]];
        TriangleMesh::of_soup(triangles.into_iter().map(corner).collect())
    };
    of_arrays(py, mesh, options, substance)
}

/// Of a mesh that is made where it is measured.
fn of_arrays(
    py: Python<'_>,
    mesh: impl FnOnce() -> Result<TriangleMesh, BodyError> + Send + 'static,
    options: MeshOptions,
    substance: Made,
) -> PyResult<PyMassProperties> {
    watched_apart(py, move |goes_on| {
        let contents = MeshContents {
            encoding: "",
            name: String::new(),
            unit: None,
            parts: vec![MeshPart { name: String::new(), mesh: mesh().map_err(Raise::raise)? }],
            findings: Vec::new(),
        };
        let source = SourceInfo::new("arrays", "python");
        // The format only names the file that there is not.
        let file = (Path::new("the arrays"), MeshFormat::Off);
        of_contents(contents, file, &options, substance, (source, "arrays"), goes_on)
    })?
}

/// What all is made of, and what parts of these names are.
type Made = (Option<Substance>, Vec<(String, Substance)>);

fn own(parts: &[(String, Given)]) -> PyResult<Vec<(String, Substance)>> {
    parts.iter().map(|(name, given)| Ok((name.clone(), given.required()?))).collect()
}

fn of_contents(
    mut contents: MeshContents,
    (path, format): (&Path, MeshFormat),
    options: &MeshOptions,
    substance: Made,
    (source, title): (SourceInfo, &str),
    goes_on: &(dyn Fn() -> bool + Sync),
) -> PyResult<PyMassProperties> {
    // Nobody hears of it, as the signal is raised instead.
    let ended = || refused("the computation is interrupted", None);
    let require_wanted = || if goes_on() { Ok(()) } else { Err(ended()) };
    require_wanted()?;
    let (given, count, encoding) = (contents.triangles(), contents.parts.len(), contents.encoding);
    let in_metres = options.unit.is_none() && contents.unit.is_none();
    let described = |what: &str, triangles: usize, parts: usize, unit: f64| {
        let several = if parts > 1 { format!(", {parts} parts") } else { String::new() };
        let assumed = if in_metres { ", in m as no unit is given" } else { "" };
        let before = if given == triangles { String::new() } else { format!(" ({given} in the file)") };
        let words = format!("{title}, {triangles} triangles{before}{several}, {what}{assumed}");
        let source = source.described(words);
        let source = if encoding.is_empty() { source } else { source.with("encoding", encoding) };
        let source = source.with("triangles", triangles).with("parts", parts).with("unit_m", unit);
        let source = if given == triangles { source } else { source.with("triangles_in_file", given) };
        if in_metres { source.with("unit_assumed", true) } else { source }
    };
    if let Some(thickness) = options.shell {
        let contents = contents.in_metres(options.unit);
        let shell = |part: &MeshPart| Ok((part.name.clone(), boxed(MeshShell::new(&part.mesh, thickness)?)));
        let pieces: Result<Vec<_>, BodyError> = contents.parts.iter().map(shell).collect();
        let pieces = pieces.map_err(Raise::raise)?;
        let unit = contents.unit.unwrap_or(1.0);
        return weighed(
            described("taken as a sheet", given, pieces.len(), unit).with("taken_as", "sheet"),
            pieces,
            substance,
            contents.findings,
            in_metres,
        );
    }
    if options.hull {
        for part in &mut contents.parts {
            part.mesh = ConvexHull::of(part.mesh.coordinates()).map_err(Raise::raise)?;
        }
    }
    let (weld, fill) = (length("weld", options.weld.as_ref())?, length("fill", options.fill.as_ref())?);
    let mended = contents.mended(weld, fill, options.unit, path).map_err(Raise::raise)?;
    let (contents, repairs) = mended;
    let file = path.display().to_string();
    let raised = |error| MeshRepair::explained(&repairs, error).raise();
    if options.union {
        require_wanted()?;
        let united = UnitedMesh::of(contents, path, options.unit).map_err(raised)?;
        let mut findings = united.findings_of(&repairs, &file);
        findings.extend(united.findings_in(&file));
        let (name, numbers) = united.for_programs();
        let source = described(
            if options.hull {
                "taken as the union of convex hulls"
            } else {
                "taken as the union of its parts"
            },
            given,
            count,
            united.unit,
        );
        let source = with_repairs(source.with("taken_as", "union").with(name, numbers), &repairs);
        return weighed(source, vec![(String::new(), boxed(united.union))], substance, findings, in_metres);
    }
    require_wanted()?;
    let solid = MeshSolid::watched(contents, path, format, options.unit, goes_on).map_err(raised)?;
    require_wanted()?;
    let mut findings = MeshRepair::findings(&repairs, &solid, &file);
    findings.extend(solid.findings_in(&file));
    let turned = solid.parts.iter().any(|part| part.mesh.inverted());
    let (what, taken_as) = match (options.hull, turned) {
        (true, _) => ("taken as its convex hull", "convex_hull"),
        (false, true) => ("closed, wound inward (turned)", "solid"),
        (false, false) => ("closed, consistently wound", "solid"),
    };
    let vertices: usize = solid.parts.iter().map(|part| part.mesh.vertices()).sum();
    let triangles = match options.hull || !repairs.is_empty() {
        true => solid.parts.iter().map(|part| part.mesh.surface().triangles().len()).sum(),
        false => given,
    };
    let source = described(what, triangles, solid.parts.len(), solid.unit);
    let source = source.with("vertices", vertices).with("taken_as", taken_as);
    let source = with_repairs(source, &repairs);
    if let Some(formula) = &options.field {
        return by_formula(source, &solid.parts, (formula, options.tolerance), findings, in_metres);
    }
    let pieces = solid.parts.into_iter().map(|part| (part.name, boxed(part.mesh)));
    weighed(source, pieces.collect(), substance, findings, in_metres)
}

/// The source with what was mended, for programs.
fn with_repairs(source: SourceInfo, repairs: &[MeshRepair]) -> SourceInfo {
    if repairs.is_empty() {
        return source;
    }
    let each = repairs.iter().map(MeshRepair::for_programs);
    each.fold(source, |source, (name, value)| source.with(name, value))
        .with("volume_bound_m3", RepairBound::of(repairs).volume)
}

fn boxed<S: Shape + 'static>(shape: S) -> Box<dyn Shape> {
    Box::new(shape)
}

/// That nothing says what a body is made of.
pub(crate) fn assumed() -> Finding {
    Finding {
        code: "mass.assumed",
        severity: Severity::Warning,
        message: "neither density, mass nor material is given: 1 kg/m³ is assumed".to_owned(),
        place: None,
    }
}

/// The parts with their masses, together.
fn weighed(
    source: SourceInfo,
    pieces: Vec<(String, Box<dyn Shape>)>,
    (common, own): Made,
    mut findings: Vec<Finding>,
    in_metres: bool,
) -> PyResult<PyMassProperties> {
    let volume = |shape: &dyn Shape| shape.spread().extent().measure();
    let mass_given = matches!(common, Some(Substance::Mass(_)));
    let of = |name: &str| own.iter().find(|(known, _)| known == name).map(|(_, substance)| *substance);
    for (name, substance) in &own {
        let called = pieces.iter().filter(|(piece, _)| piece == name).count();
        if called == 0 {
            let names: Vec<_> = pieces.iter().map(|(name, _)| format!("{name:?}")).collect();
            let hint = format!("its parts are {}", names.join(", "));
            return Err(refused(format!("the mesh has no part named {name:?}"), Some(&hint)));
        }
        if called > 1 && matches!(substance, Substance::Mass(_)) {
            let message = format!("{called} parts of the mesh are named {name:?}: is the mass that of each?");
            let hint =
                "give a density or a material, which counts for each, or name the parts apart in the file";
            return Err(refused(message, Some(hint)));
        }
    }
    let rest: Vec<_> = pieces.iter().filter(|(name, _)| of(name).is_none()).collect();
    if rest.is_empty() && common.is_some() {
        let message = "density, mass or material is for what parts does not name, and it names every part";
        return Err(refused(message, Some("leave it out, or leave a part out of parts")));
    }
    let common = match common {
        Some(Substance::Mass(mass)) if rest.len() > 1 => {
            // The mass of all of them, at one density.
            let of_rest: f64 = rest.iter().map(|(_, shape)| volume(shape.as_ref())).sum();
            Substance::Density(mass / of_rest)
        }
        Some(substance) => substance,
        None if rest.is_empty() => Substance::Density(1.0),
        None => {
            findings.push(assumed());
            Substance::Density(1.0)
        }
    };
    let row = |(name, shape): &(String, Box<dyn Shape>)| {
        let properties = in_body(shape.mass_properties(of(name).unwrap_or(common))?)?;
        Ok(PartRow { name: name.clone(), properties, volume: Some(volume(shape.as_ref())) })
    };
    let rows = pieces.iter().map(row).collect::<Result<Vec<_>, BodyError>>();
    let area = pieces.iter().map(|(_, shape)| shape.surface_area()).sum();
    together(
        source,
        rows.map_err(Raise::raise)?,
        (area, Vec::new()),
        findings,
        in_metres.then_some(mass_given),
    )
}

/// The parts with a density that varies, and how far the result may be off.
fn by_formula(
    source: SourceInfo,
    parts: &[SolidPart],
    (formula, tolerance): (&str, Option<f64>),
    findings: Vec<Finding>,
    in_metres: bool,
) -> PyResult<PyMassProperties> {
    let expression = Expression::parse(formula, &["x", "y", "z"])
        .map_err(|error| refused(format!("field: {error}"), error.hint().as_deref()))?;
    let default = Cubature::default();
    let cubature = Cubature { tolerance: tolerance.unwrap_or(default.tolerance), ..default };
    let mut total = FieldError { mass: 0.0, center_of_mass: 0.0, inertia: 0.0 };
    let mut rows = Vec::new();
    for part in parts {
        let body = mass_properties_of_field(Solid::Mesh(&part.mesh), &expression, cubature);
        let body =
            body.map_err(|error| refused(&error, error.hint().or(Some("check field and tolerance"))))?;
        let FieldError { mass, center_of_mass, inertia } = body.error_estimate;
        // Masses add; of the others the worst part's stands for all.
        total.mass += mass;
        total.center_of_mass = total.center_of_mass.max(center_of_mass);
        total.inertia = total.inertia.max(inertia);
        let properties = in_body(body.properties).map_err(Raise::raise)?;
        rows.push(PartRow { name: part.name.clone(), properties, volume: Some(body.volume) });
    }
    let area = parts.iter().map(|part| part.mesh.surface_area()).sum();
    let error = error_estimate(&total, "by cubature of the formula");
    together(source, rows, (area, vec![error]), findings, in_metres.then_some(false))
}

/// One body of parts; where metres were assumed, whether its mass was given.
fn together(
    source: SourceInfo,
    rows: Vec<PartRow>,
    (area, more): (f64, Vec<Extra>),
    mut findings: Vec<Finding>,
    in_metres: Option<bool>,
) -> PyResult<PyMassProperties> {
    let whole: f64 = rows.iter().filter_map(|row| row.volume).sum();
    let bodies: Vec<_> = rows.iter().map(|row| row.properties).collect();
    let properties = match bodies.as_slice() {
        [only] => *only,
        _ => MassProperties::combined(&bodies).map_err(Raise::raise)?,
    };
    if let Some(mass_given) = in_metres {
        let extent = Some(Extent::Volume(whole));
        let remedy = "give unit=\"mm\", or unit=\"m\" if it is so";
        let assumed = AssumedMetres { properties: &properties, extent, mass_given, others: None, remedy };
        findings.extend(assumed.finding(None));
    }
    let of_parts = if rows.len() > 1 { Some(parts(&rows)) } else { None };
    Ok(PyMassProperties::of(InertiaReport {
        surface_area: Some(area),
        extras: of_parts.into_iter().chain(more).collect(),
        findings,
        ..InertiaReport::new(source, properties).with_volume(Some(whole))
    }))
}
