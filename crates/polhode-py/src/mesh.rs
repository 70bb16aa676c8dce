//! Meshes from files and from arrays.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use numpy::PyReadonlyArray2;
use polhode::body::BodyError;
use polhode::body::mesh::{PrintShell, TriangleMesh};
use polhode::body::shape::Substance;
use polhode_document::SourceInfo;
use polhode_shape::mesh::{MeshContents, MeshFormat, MeshLength, MeshPart, Share};
use polhode_shape::{MeshBody, MeshBodyError, MeshOrigin, MeshUse, MeshWords, PartSubstance, Print};
use polhode_source::expression::Expression;
use polhode_source::files::Disk;
use pyo3::prelude::*;

use crate::arrays::rows;
use crate::error::{Raise, refused};
use crate::interrupt::{copied, watched_apart, watched_here};
use crate::mass_properties::PyMassProperties;
use crate::substance::Given;

/// Options of the evaluation of a mesh.
#[derive(Clone, Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct MeshOptions {
    /// Unit of length of the file, m.
    unit: Option<f64>,
    /// True to replace each part by its convex hull.
    hull: bool,
    /// Thickness of a sheet that replaces the solid, m.
    shell: Option<f64>,
    /// Largest distance at which vertices of open edges are joined, as text.
    weld: Option<String>,
    /// Largest diameter of holes that are filled, as text.
    fill: Option<String>,
    /// Largest share of the volume that closing all holes may leave uncertain, as text.
    close_within: Option<String>,
    /// Thicknesses of the walls and of the layers at top and bottom of a print, m, and the density
    /// of its infill, as text.
    print: Option<([f64; 3], String)>,
    /// True to count overlapping volumes of parts only once.
    union: bool,
    /// True to search for triangles that intersect.
    check: bool,
    /// Substances of the named parts.
    parts: Vec<(String, Given)>,
    /// Density, kg/m³, as a formula of x, y and z, m.
    field: Option<String>,
    /// Relative tolerance of the integration of the formula.
    tolerance: Option<f64>,
}

/// Parsed options of a mesh and its substances.
struct Made {
    options: MeshOptions,
    substance: Option<Substance>,
    parts: Vec<PartSubstance>,
    weld: Option<MeshLength>,
    fill: Option<MeshLength>,
    close_within: Option<Share>,
    print: Option<Print>,
    field: Option<Expression>,
}

impl Made {
    fn new(options: MeshOptions, given: &Given) -> PyResult<Self> {
        let substance = given.substance()?;
        let part = |(name, given): &(String, Given)| {
            Ok(PartSubstance { name: name.clone(), substance: given.required()? })
        };
        let parts = options.parts.iter().map(part).collect::<PyResult<_>>()?;
        let formula = |text: &String| {
            Expression::parse(text, &["x", "y", "z"])
                .map_err(|error| refused(format!("field: {error}"), error.hint().as_deref()))
        };
        let (weld, fill) = (length("weld", options.weld.as_ref())?, length("fill", options.fill.as_ref())?);
        let close_within =
            options.close_within.as_ref().map(|text| share("close_within", text)).transpose()?;
        let print = options.print.as_ref().map(|([walls, top, bottom], infill)| {
            let shell = PrintShell { walls: *walls, top: *top, bottom: *bottom };
            Ok::<_, PyErr>(Print { shell, infill: share("infill", infill)? })
        });
        let print = print.transpose()?;
        let field = options.field.as_ref().map(formula).transpose()?;
        Ok(Self { substance, parts, weld, fill, close_within, print, field, options })
    }

    /// Calculates the mass properties of the mesh that `body` creates.
    fn mass_properties(
        &self,
        goes_on: &(dyn Fn() -> bool + Sync),
        body: impl FnOnce(MeshUse<'_>) -> Result<MeshBody<'_>, MeshBodyError>,
    ) -> PyResult<PyMassProperties> {
        let MeshOptions { unit, hull, shell, union, check, tolerance, .. } = self.options;
        let how = MeshUse {
            unit,
            hull,
            shell,
            weld: self.weld,
            fill: self.fill,
            close_within: self.close_within,
            print: self.print,
            union,
            check,
            substance: self.substance,
            parts: &self.parts,
            field: self.field.as_ref(),
            tolerance,
            goes_on,
            words: MeshWords {
                unit: "give unit=\"mm\", or unit=\"m\" if the file is in metres",
                file: None,
                substance: None,
            },
        };
        let report = body(how).and_then(MeshBody::into_report).map_err(Raise::raise)?;
        Ok(PyMassProperties::of(report))
    }
}

impl Raise for MeshBodyError {
    fn raise(self) -> PyErr {
        match self {
            Self::Format(error) => error.raise(),
            Self::Body(error) => error.raise(),
            Self::Density(error) => refused(&error, error.hint().or(Some("check field and tolerance"))),
            Self::AllNamed => refused(
                "density, mass or material applies to parts that are not in `parts`, but every part is",
                Some("delete it, or delete a part from `parts`"),
            ),
            other => refused(&other, Some(other.hint().as_str()).filter(|hint| !hint.is_empty())),
        }
    }
}

/// Parses a share of this name.
fn share<T: FromStr<Err = String>>(name: &str, text: &str) -> PyResult<T> {
    text.parse().map_err(|error: String| {
        let (message, hint) = error.split_once(" (hint: ").unwrap_or((&error, ""));
        let hint = Some(hint.trim_end_matches(')')).filter(|hint| !hint.is_empty());
        refused(format!("{name}: {message}"), hint)
    })
}

/// Parses a length option of this name.
fn length(name: &str, text: Option<&String>) -> PyResult<Option<MeshLength>> {
    let parsed = text.map(|text| MeshLength::parse(text)).transpose();
    parsed.map_err(|error| refused(format!("{name}: {error}"), error.hint().as_deref()))
}

/// Returns the mass properties of a mesh file.
///
/// # Errors
/// `PolhodeError` if the file cannot be read, or does not bound a solid.
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
        .ok_or_else(|| refused(format!("unknown mesh format {format:?}"), None))?;
    let made = Made::new(options, &given)?;
    watched_apart(py, move |goes_on| {
        made.mass_properties(goes_on, |how| how.read(&Disk, &path, format, &mut ()))
    })?
}

/// Returns the mass properties of triangles (m, 3), given as numbers of vertices (n, 3), m.
///
/// # Errors
/// `PolhodeError` if the triangles do not bound a solid.
#[pyfunction]
pub(crate) fn mesh_arrays(
    py: Python<'_>,
    vertices: PyReadonlyArray2<'_, f64>,
    triangles: PyReadonlyArray2<'_, u32>,
    options: MeshOptions,
    given: Given,
) -> PyResult<PyMassProperties> {
    let made = Made::new(options, &given)?;
    let points = copied(py, rows::<3>(&vertices)?)?;
    let corners = triangles.as_slice().map_err(|error| refused(error.to_string(), None))?;
    let corners = copied(py, corners.as_chunks().0)?;
    let size = points.len().max(corners.len());
    of_arrays(py, made, size, move || TriangleMesh::new(points, corners))
}

/// Returns the mass properties of triangles given by their corners (n, 9), m.
///
/// # Errors
/// `PolhodeError` if the triangles do not bound a solid.
#[pyfunction]
pub(crate) fn mesh_corners(
    py: Python<'_>,
    corners: PyReadonlyArray2<'_, f64>,
    options: MeshOptions,
    given: Given,
) -> PyResult<PyMassProperties> {
    let made = Made::new(options, &given)?;
    let triangles = copied(py, rows::<9>(&corners)?)?;
    let size = triangles.len();
    let mesh = move || {
        let corner = |[a, b, c, d, e, f, g, h, i]: [f64; 9]| [[a, b, c], [d, e, f], [g, h, i]];
        TriangleMesh::of_soup(triangles.into_iter().map(corner).collect())
    };
    of_arrays(py, made, size, mesh)
}

/// Computes the mass properties of a mesh of `size` triangles or vertices. A large mesh, and a
/// density that is a formula, take long: a thread of its own creates and measures it.
fn of_arrays(
    py: Python<'_>,
    made: Made,
    size: usize,
    mesh: impl FnOnce() -> Result<TriangleMesh, BodyError> + Send + 'static,
) -> PyResult<PyMassProperties> {
    let is_short = size < WORTH_THREAD && made.field.is_none();
    let work = move |goes_on: &(dyn Fn() -> bool + Sync)| {
        made.mass_properties(goes_on, |how| {
            let contents = MeshContents {
                encoding: "",
                name: String::new(),
                unit: None,
                parts: vec![MeshPart { name: String::new(), mesh: mesh()? }],
                findings: Vec::new(),
            };
            // The format is only a label; the arrays are not from a file.
            let (path, format, title) = (Path::new("the arrays"), MeshFormat::Off, "arrays".to_owned());
            let source = SourceInfo::new("arrays", "python");
            how.body(contents, &MeshOrigin { path, format, source, title }, &mut ())
        })
    };
    if is_short { watched_here(py, work)? } else { watched_apart(py, work)? }
}

/// Number of triangles and vertices below which a mesh takes some milliseconds, and a thread of its own would
/// take a large part of the time: about 0.2 ms with its first allocations.
const WORTH_THREAD: usize = 1 << 14;
