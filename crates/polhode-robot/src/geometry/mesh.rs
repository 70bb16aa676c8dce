//! Mesh of a model: its triangles, and the volume that they enclose.

use std::path::Path;
use std::sync::Arc;

use polhode::body::mesh::{ClosedMesh, ConvexHull, TriangleMesh};
use polhode::body::shape::{Shape, Substance};
use polhode::body::{BodyError, MassProperties};
use polhode_shape::mesh::collada;
use polhode_shape::mesh::collada::UpAxis;
use polhode_shape::mesh::{MeshContents, MeshFormat, MeshPart};
use polhode_source::files::Files;
use polhode_source::read_text_file;

use super::{ENDED, MeshReading, Solid, VolumeKind, z_up};
use crate::model::InlineMesh;

/// Mesh in its own frame, as written; a file is in metres.
#[derive(Debug)]
pub(super) struct Mesh {
    /// All triangles.
    surface: Arc<TriangleMesh>,
    /// All triangles in the most common convention.
    pub(super) usual: Arc<TriangleMesh>,
    pub(super) measured: Result<Measured, String>,
    /// Parts by name, if the file has several and each is closed; they may overlap.
    pub(super) parts: Vec<(String, Solid)>,
    /// True if some of several parts are wound inward and others outward, as a cavity in a part of
    /// its own is.
    pub(super) mixes_winding: bool,
    /// Convention in which the mesh is rotated from y up to z up, if there is one.
    pub(super) turned_in: Option<MeshReading>,
}

/// Enclosed volume of a mesh.
#[derive(Debug)]
pub(super) struct Measured {
    pub(super) solid: Solid,
    pub(super) kind: VolumeKind,
    /// Corners of the convex hull, if the hull replaces the mesh.
    hull: Option<Vec<[f64; 3]>>,
}

impl Mesh {
    pub(super) fn read(
        files: &dyn Files,
        path: &Path,
        threads: usize,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Self, String> {
        let (contents, turned_in) = match MeshFormat::of_path(path) {
            Some(MeshFormat::Collada) if cfg!(feature = "languages") => {
                let read = read_text_file(files, path, collada::read_with_axis);
                let is_y_up = matches!(read, Ok((_, Some(UpAxis::Y))));
                (read.map(|(contents, _)| contents), is_y_up.then_some(MeshReading::Other))
            }
            Some(format) => {
                let turned_in = (format == MeshFormat::Gltf).then_some(MeshReading::Usual);
                (MeshContents::read(files, path, format), turned_in)
            }
            None => {
                let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
                return Err(format!("polhode does not read .{ending} meshes"));
            }
        };
        let words = |error: polhode_source::FormatError| match error.hint() {
            Some(hint) => format!("{}; {hint}", error.message()),
            None => error.message(),
        };
        let contents = contents.map_err(words)?.in_metres(None);
        let mesh = Self::of(contents, threads, goes_on)?;
        let usual = match turned_in {
            Some(MeshReading::Usual) => Arc::new(turned(&mesh.surface).map_err(|error| error.to_string())?),
            _ => mesh.surface.clone(),
        };
        Ok(Self { turned_in, usual, ..mesh })
    }

    /// Measures a mesh that is written in the model.
    pub(super) fn of_inline(
        inline: &InlineMesh,
        threads: usize,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Self, String> {
        let mesh = inline.surface().clone();
        if !inline.is_hull() {
            let parts = vec![MeshPart { name: String::new(), mesh }];
            let (name, findings) = (String::new(), Vec::new());
            let contents = MeshContents { encoding: "text", name, unit: None, parts, findings };
            return Self::of(contents, threads, goes_on);
        }
        let points = mesh.with_shared_vertices(threads);
        let hull = ConvexHull::of(points.coordinates()).map_err(|error| error.to_string())?;
        let measured = Measured::hull(&hull, threads);
        let surface = Arc::new(hull);
        let usual = surface.clone();
        Ok(Self { surface, usual, measured, parts: Vec::new(), mixes_winding: false, turned_in: None })
    }

    fn of(
        contents: MeshContents,
        threads: usize,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Self, String> {
        let solid = |mesh: &TriangleMesh| ClosedMesh::without_remarks(mesh, threads, goes_on);
        let mut solids = Vec::new();
        if let parts @ [_, _, ..] = contents.parts.as_slice() {
            let parts = parts.iter().map(|part| solid(&part.mesh));
            solids = parts.collect::<Result<_, _>>().unwrap_or_default();
        }
        let names = contents.parts.iter().map(|part| part.name.clone());
        let parts: Vec<(String, Solid)> = names.zip(&solids).filter_map(Self::part).collect();
        let inward = solids.iter().filter(|solid| solid.inverted()).count();
        let mixes_winding = inward > 0 && inward < solids.len();
        let one = contents.as_one().map_err(|error| error.to_string())?;
        let Some(all) = one.parts.into_iter().next() else { return Err("it has no triangles".to_owned()) };
        let all = all.mesh.with_shared_vertices(threads);
        if solids.is_empty() {
            // The mesh is one part, pieces of one surface, or not a solid.
            solids.extend(solid(&all));
        }
        let measured = match solids[..] {
            // After cancellation the result is unknown, so the hull is not used.
            [] if !goes_on() => Err(ENDED.to_owned()),
            [] => Measured::hull(&all, threads),
            _ => Measured::closed(&solids),
        };
        let surface = solids.iter().try_fold(TriangleMesh::default(), |all, part| all.joined(part.surface()));
        let surface = surface.map_err(|error| error.to_string())?;
        let surface = if solids.is_empty() { all } else { surface };
        let surface = Arc::new(surface);
        Ok(Self { usual: surface.clone(), surface, measured, parts, mixes_winding, turned_in: None })
    }

    /// Returns a part with its volume; `None` if its moments overflow, which the sum reports.
    fn part((name, solid): (String, &ClosedMesh)) -> Option<(String, Solid)> {
        Some((name, Solid::of(&solid.mass_properties(Substance::Density(1.0)).ok()?)))
    }

    /// Returns points with the same convex hull as the mesh.
    pub(super) fn outline(&self) -> &[[f64; 3]] {
        match &self.measured {
            Ok(Measured { hull: Some(corners), .. }) => corners,
            _ => self.surface.coordinates(),
        }
    }
}

fn turned(mesh: &TriangleMesh) -> Result<TriangleMesh, BodyError> {
    let vertices: Vec<[f64; 3]> = mesh.coordinates().iter().copied().map(z_up).collect();
    TriangleMesh::new(vertices, mesh.triangles().to_vec())
}

impl Measured {
    fn closed(parts: &[ClosedMesh]) -> Result<Self, String> {
        let bodies = parts.iter().map(|part| part.mass_properties(Substance::Density(1.0)));
        let bodies: Vec<_> = bodies.collect::<Result<_, _>>().map_err(|error| error.to_string())?;
        let body = MassProperties::combined(&bodies).map_err(|error| error.to_string())?;
        Ok(Self { solid: Solid::of(&body), kind: VolumeKind::Closed, hull: None })
    }

    /// Returns the convex hull of the vertices of a mesh. Every vertex belongs to a triangle.
    fn hull(mesh: &TriangleMesh, threads: usize) -> Result<Self, String> {
        let surface = ConvexHull::of(mesh.coordinates()).map_err(|error| error.to_string())?;
        // A convex hull does not intersect itself, so remarks are unnecessary.
        let solid = ClosedMesh::without_remarks(&surface, threads, &|| true);
        let solid = solid.map_err(|error| error.to_string())?;
        let hull = Some(solid.surface().coordinates().to_vec());
        Ok(Self { kind: VolumeKind::Hull, hull, ..Self::closed(&[solid])? })
    }
}
