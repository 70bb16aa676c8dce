//! Meshes of the assets: where they are, and what they enclose by MuJoCo's rules.
//!
//! MuJoCo sums pyramids from the triangles to one point. By default (`legacy`) that is the middle of the surface and all
//! pyramids count as positive; `exact` has them signed; `convex` takes the convex hull; `shell` the surface itself. Vertices are
//! numbers of single precision.
//!
//! Source: MuJoCo 3.x, `mjCMesh::Process`, `ComputeVolume`, `ComputeInertia`.

use std::path::{Path, PathBuf};

use polhode::body::mesh::ConvexHull;

use polhode_source::files::Files;

use crate::model::{GeometryShape, Name, Pose};
use crate::moments::Moments;
use crate::pose::{dot, of_x_and_y, sum, unit};
use crate::read::uri::Roots;
use crate::read::xml::Element;

use super::builtin::Builtin;
use super::compiler::Settings;
use super::defaults::Source;
use super::field::Field;
use super::surface::Surface;

/// How a mesh is a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum MeshInertia {
    Convex,
    Exact,
    Legacy,
    Shell,
}

/// A mesh of the assets.
#[derive(Clone, Debug)]
pub(super) struct Asset {
    /// As it is written, and where that is.
    file: Option<(Name, Result<PathBuf, String>)>,
    /// Vertices and triangles that stand in the model itself.
    inline: Option<Surface>,
    /// Made by MuJoCo itself.
    builtin: Option<Result<Builtin, String>>,
    /// Made by a plugin.
    field: Option<Result<Field, String>>,
    /// Why it cannot be measured: it is a hull of a limited number of vertices.
    refused: Option<String>,
    inertia: MeshInertia,
    scale: [f64; 3],
    /// The frame that the vertices are given in.
    reference: Pose,
}

/// What a mesh encloses, in the asset's frame.
#[derive(Debug)]
pub(super) struct Solid {
    /// m³, or m² of a shell.
    pub(super) amount: f64,
    pub(super) center: [f64; 3],
    /// About the centre, per kg.
    pub(super) tensor: [f64; 6],
    vertices: Vec<[f64; 3]>,
}

impl Asset {
    /// The mesh that an element of the assets says; `folder` is its model's own.
    pub(super) fn of(
        element: Element<'_>,
        root: Element<'_>,
        source: &Source<'_, '_>,
        settings: &Settings<'_>,
        folder: &Path,
        roots: &Roots<'_>,
    ) -> (String, Self) {
        let file = element.attribute("file");
        let base =
            file.as_ref().map_or("", |file| file.value.rsplit(['/', '\\']).next().unwrap_or(file.value));
        let stem = base.rsplit_once('.').map_or(base, |(stem, _)| stem);
        let name = element.word("name").unwrap_or(stem).to_owned();
        let path = file.map(|file| {
            let written = if settings.strip_path { base } else { file.value };
            let path = roots.resolve(written, &folder.join(settings.mesh_folder));
            (file.name(), path)
        });
        let builtin = Builtin::of(element);
        let inertia = match source.word("inertia") {
            _ if matches!(&builtin, Some(Ok(builtin)) if builtin.is_shell()) => MeshInertia::Shell,
            Some("convex") => MeshInertia::Convex,
            Some("exact") => MeshInertia::Exact,
            Some("shell") => MeshInertia::Shell,
            _ if settings.exact_meshes => MeshInertia::Exact,
            _ => MeshInertia::Legacy,
        };
        let most = source.number("maxhullvert").is_some_and(|most| most >= 0.0);
        let refused = (inertia == MeshInertia::Convex && most)
            .then(|| "its mesh counts as a hull of a limited number of vertices (maxhullvert)".to_owned());
        let three = |name: &str, default| {
            source.written(name).map_or(default, |written| written.array().unwrap_or([f64::NAN; 3]))
        };
        let turn =
            source.written("refquat").map_or(Some(Pose::IDENTITY.rotation), |quat| unit(quat.array()?));
        let reference = Pose::new(three("refpos", [0.0; 3]), turn.unwrap_or([f64::NAN; 4]));
        let asset = Self {
            file: path,
            inline: Surface::inline(element),
            builtin,
            field: Field::of(element, root).filter(|_| element.word("file").is_none()),
            refused,
            inertia,
            scale: three("scale", [1.0; 3]),
            reference,
        };
        (name, asset)
    }

    /// As a shape, and its frame in the geom's.
    pub(super) fn shape(&self) -> (GeometryShape, Pose) {
        let Some((uri, path)) = &self.file else {
            return (GeometryShape::Other("a mesh without a file".to_owned()), Pose::IDENTITY);
        };
        let [x, y, z] = self.scale;
        let even = x.to_bits() == y.to_bits() && y.to_bits() == z.to_bits();
        let inverse = self.reference.inverse();
        if !even && self.reference.rotation != Pose::IDENTITY.rotation
            || !self.reference.rotation.iter().chain(&self.reference.position).all(|c| c.is_finite())
        {
            let what = "a mesh with refquat and a scale".to_owned();
            return (GeometryShape::Other(what), Pose::IDENTITY);
        }
        // S Rᵀ (v − p) = Rᵀ (S v) − S Rᵀ p, where S and R commute
        let position = [0, 1, 2].map(|k| self.scale[k] * inverse.position[k]);
        let shape = GeometryShape::Mesh { uri: uri.clone(), path: path.clone(), scale: self.scale };
        (shape, Pose::new(position, inverse.rotation))
    }

    /// How many points of a grid take as long as what MuJoCo makes for it.
    pub(super) fn made_points(&self) -> usize {
        match (&self.builtin, &self.field) {
            (Some(Ok(builtin)), _) => builtin.vertices().saturating_mul(8),
            (None, Some(Ok(field))) => field.points(),
            _ => 0,
        }
    }

    /// Whether it is given as a file.
    pub(super) const fn is_file(&self) -> bool {
        self.file.is_some()
    }

    /// What it encloses.
    ///
    /// # Errors
    /// In words, why it cannot be told.
    pub(super) fn solid(&self, files: &dyn Files) -> Result<Solid, String> {
        if let Some(why) = &self.refused {
            return Err(why.clone());
        }
        let surface = self.surface(files)?;
        let triangles: Vec<[[f64; 3]; 3]> =
            if self.inertia == MeshInertia::Convex || surface.triangles.is_empty() {
                let hull = ConvexHull::of(&surface.vertices).map_err(|error| format!("its mesh: {error}"))?;
                hull.corners().collect()
            } else {
                surface.corners().collect()
            };
        let solid = summed(&triangles, self.inertia, surface.vertices)?;
        Ok(if self.field.is_some() { solid.unturned() } else { solid })
    }

    /// Its triangles, turned and scaled.
    ///
    /// # Errors
    /// In words, why it cannot be read.
    fn surface(&self, files: &dyn Files) -> Result<Surface, String> {
        if self.field.is_some() && self.scale != [1.0; 3] {
            return Err("its mesh is made by a plugin and has a scale: MuJoCo refuses the file".to_owned());
        }
        let mut surface = match (&self.builtin, &self.field, &self.inline, &self.file) {
            (Some(builtin), ..) => builtin.clone()?.surface(),
            (None, Some(field), ..) => field.clone()?.surface(),
            (None, None, Some(surface), _) => surface.clone(),
            (None, None, None, Some((uri, path))) => {
                let said = |why: String| format!("its mesh {:?} cannot be read: {why}", uri.text);
                Surface::read(files, path.as_ref().map_err(|why| said(why.clone()))?).map_err(said)?
            }
            (None, None, None, None) => return Err("its mesh has no file and no vertices".to_owned()),
        };
        let inverse = self.reference.inverse();
        for vertex in &mut surface.vertices {
            let placed = inverse.placed(vertex.map(|c| f64::from(c as f32)));
            *vertex = [0, 1, 2].map(|k| self.scale[k] * placed[k]);
        }
        if self.scale.iter().product::<f64>() < 0.0 {
            surface.triangles.iter_mut().for_each(|[_, b, c]| std::mem::swap(b, c));
        }
        if !surface.vertices.as_flattened().iter().all(|c| c.is_finite()) {
            return Err("its mesh has coordinates, a scale or a frame that are no numbers".to_owned());
        }
        Ok(surface)
    }
}

/// Sums of pyramids from the triangles to the middle of the surface, and then to the centre.
fn summed(
    triangles: &[[[f64; 3]; 3]],
    inertia: MeshInertia,
    vertices: Vec<[f64; 3]>,
) -> Result<Solid, String> {
    /// MuJoCo refuses less, m³ or m².
    const LEAST: f64 = 1e-15;
    let middle = |t: &[[f64; 3]; 3]| sum(t[0], sum(t[1], t[2])).map(|c| c / 3.0);
    let (mut area, mut apex) = (0.0, [0.0; 3]);
    for triangle in triangles {
        let own = dot(normal(triangle), normal(triangle)).sqrt();
        area += own;
        apex = sum(apex, middle(triangle).map(|c| own * c));
    }
    if !(area >= LEAST) {
        return Err("its mesh has no surface".to_owned());
    }
    apex = apex.map(|c| c / area);
    let amount = |triangle: &[[f64; 3]; 3], from: [f64; 3]| {
        let normal = normal(triangle);
        let volume = dot([0, 1, 2].map(|k| middle(triangle)[k] - from[k]), normal) / 3.0;
        match inertia {
            MeshInertia::Shell => dot(normal, normal).sqrt(),
            MeshInertia::Legacy => volume.abs(),
            MeshInertia::Exact | MeshInertia::Convex => volume,
        }
    };
    let (mut total, mut center) = (0.0, [0.0; 3]);
    for triangle in triangles {
        let own = amount(triangle, apex);
        total += own;
        let place = [0, 1, 2].map(|k| 0.75 * middle(triangle)[k] + 0.25 * apex[k]);
        center = sum(center, place.map(|c| own * c));
    }
    if !(total >= LEAST) {
        return Err("its mesh encloses no volume, or its triangles are inside out".to_owned());
    }
    center = center.map(|c| c / total);
    let (mut total, mut products) = (0.0, [0.0; 6]);
    let share = if inertia == MeshInertia::Shell { 12.0 } else { 20.0 };
    for triangle in triangles {
        let own = amount(triangle, center);
        total += own;
        let [d, e, f] = triangle.map(|corner| [0, 1, 2].map(|k| corner[k] - center[k]));
        let all = sum(d, sum(e, f));
        for (product, (i, j)) in products.iter_mut().zip(crate::moments::PLACES) {
            *product += own / share * (all[i] * all[j] + d[i] * d[j] + e[i] * e[j] + f[i] * f[j]);
        }
    }
    let [xx, yy, zz, xy, xz, yz] = products.map(|product| product / total);
    Ok(Solid { amount: total, center, tensor: [yy + zz, xx + zz, xx + yy, -xy, -xz, -yz], vertices })
}

/// As long as the triangle has area.
fn normal([a, b, c]: &[[f64; 3]; 3]) -> [f64; 3] {
    let [u, v] = [b, c].map(|corner| [0, 1, 2].map(|k| corner[k] - a[k]));
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]].map(|c| 0.5 * c)
}

/// A primitive fitted to a mesh: MuJoCo's sizes, and its frame in the asset's.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    pub(super) size: [f64; 3],
    pub(super) pose: Pose,
}

impl Solid {
    /// As MuJoCo has a mesh that it does not turn: its moments, the greatest first, about the axes that it has, and the origin.
    fn unturned(self) -> Self {
        let Moments { values: [i1, i2, i3], .. } = Moments::of(&self.tensor);
        Self { center: [0.0; 3], tensor: [i3, i2, i1, 0.0, 0.0, 0.0], ..self }
    }

    /// The primitive that has the moments of the mesh, or with `by_bounds` that is as large as the mesh along its principal
    /// axes.
    ///
    /// # Errors
    /// If the axes are open, as those of a cube are, and the answer depends on them.
    pub(super) fn fitted(&self, kind: &str, by_bounds: bool) -> Result<Fitted, String> {
        /// Moments are equal that differ by less of the largest.
        const EQUAL: f64 = 1e-9;
        let Moments { values: [i1, i2, i3], axes: [thin, middle, thick] } = Moments::of(&self.tensor);
        let (x, y) = (thick, middle);
        let long_is_open = i2 - i1 <= EQUAL * i3;
        let is_open = by_bounds && (long_is_open || i3 - i2 <= EQUAL * i3)
            || long_is_open && matches!(kind, "capsule" | "cylinder");
        if is_open {
            return Err(format!("the mesh that its {kind} is fitted to has no principal axes of its own"));
        }
        let _ = thin; // x × y up to its sign
        let rotation = of_x_and_y(x, y).unwrap_or(Pose::IDENTITY.rotation);
        let frame = Pose::new(self.center, rotation);
        if !by_bounds {
            let [a, b, c] =
                [i2 + i1 - i3, i3 + i1 - i2, i3 + i2 - i1].map(|square| 0.5 * (6.0 * square).sqrt());
            let size = match kind {
                "sphere" => [(a + b + c) / 3.0; 3],
                "capsule" => [0.5 * (a + b), (c - 0.25 * (a + b)).max(0.0), 0.0],
                "cylinder" => [0.5 * (a + b), c, 0.0],
                _ => [a, b, c],
            };
            return Ok(Fitted { size, pose: frame });
        }
        let inverse = frame.inverse();
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for vertex in &self.vertices {
            for (k, c) in inverse.placed(*vertex).into_iter().enumerate() {
                (low[k], high[k]) = (low[k].min(c), high[k].max(c));
            }
        }
        let half = [0, 1, 2].map(|k| 0.5 * (high[k] - low[k]));
        let [a, b, c] = half;
        let size = match kind {
            "sphere" => [a.max(b).max(c); 3],
            "capsule" => [a.max(b), c - a.max(b), 0.0],
            "cylinder" => [a.max(b), c, 0.0],
            _ => half,
        };
        let center = [0, 1, 2].map(|k| 0.5 * (high[k] + low[k]));
        Ok(Fitted { size, pose: Pose::new(frame.placed(center), rotation) })
    }
}
