//! Fuzz targets for meshes.
//!
//! An accepted mesh is finite, reads back the same in this and in another format, and bounds a
//! physical body.

use std::fmt::Write as _;
use std::path::Path;

use polhode::body::mesh::{ConvexHull, TriangleMesh};
use polhode::body::shape::{Shape as _, Substance};
use polhode::math::Rotation;
use polhode_shape::mesh::{MeshContents, MeshFormat, MeshSolid, points};
use polhode_source::files::Disk;

use super::physical::{assert_physical, assert_written_is_read};

/// Largest number of triangles for diagnostics, and of corners for a hull; more would take too
/// long.
const MOST: usize = 2000;

pub fn stl(data: &[u8]) {
    mesh(data, MeshFormat::Stl);
}

pub fn obj(data: &[u8]) {
    mesh(data, MeshFormat::Obj);
    if let Ok(cloud) = points::read(data) {
        assert!(
            cloud.parts.iter().all(|part| part
                .mesh
                .coordinates()
                .as_flattened()
                .iter()
                .all(|x| x.is_finite()))
        );
    }
}

pub fn ply(data: &[u8]) {
    mesh(data, MeshFormat::Ply);
}

pub fn off(data: &[u8]) {
    mesh(data, MeshFormat::Off);
}

pub fn gltf(data: &[u8]) {
    mesh(data, MeshFormat::Gltf);
}

pub fn threemf(data: &[u8]) {
    mesh(data, MeshFormat::ThreeMf);
}

pub fn collada(data: &[u8]) {
    mesh(data, MeshFormat::Collada);
}

fn mesh(data: &[u8], format: MeshFormat) {
    let read = || MeshContents::parse(&Disk, data, Path::new("/nowhere/mesh"), format);
    match read() {
        Ok(contents) => {
            assert_eq!(Ok(&contents), read().as_ref());
            accepted(contents, format);
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

/// Checks the meshes of a file that was read.
fn accepted(contents: MeshContents, format: MeshFormat) {
    for part in &contents.parts {
        assert!(part.mesh.coordinates().as_flattened().iter().all(|c| c.is_finite()));
        assert!(
            part.mesh
                .triangles()
                .as_flattened()
                .iter()
                .all(|&v| (v as usize) < part.mesh.coordinates().len())
        );
    }
    if contents.triangles() > MOST {
        return;
    }
    let Ok(one) = contents.clone().as_one() else { return };
    let Some(all) = one.parts.first().map(|part| part.mesh.clone()) else { return };
    let same = |a: &TriangleMesh, b: &TriangleMesh| a.corners().eq(b.corners());
    let again = MeshContents::parse(&Disk, as_off(&all).as_bytes(), Path::new("a.off"), MeshFormat::Off)
        .and_then(|again| {
            assert!(same(&again.parts[0].mesh, &all), "OFF says something else");
            MeshSolid::of(again, Path::new("a.off"), MeshFormat::Off, Some(0.001))
        });
    let solid = |contents| MeshSolid::of(contents, Path::new("a.mesh"), format, Some(0.001));
    if let Ok(whole) = solid(one) {
        let weigh = |solid: &MeshSolid| solid.parts[0].mesh.mass_properties(Substance::Density(2.5));
        assert_eq!(weigh(&whole), weigh(&again.unwrap()), "OFF gives another body");
    }
    if let Ok(solid) = solid(contents) {
        for part in &solid.parts {
            if let Ok(body) = part.mesh.mass_properties(Substance::Density(2.5)) {
                assert_physical(&body);
                assert_written_is_read(&body.in_frame(Rotation::identity()));
            }
        }
    }
    if all.coordinates().len() <= MOST
        && let Ok(hull) = ConvexHull::of(all.coordinates())
    {
        assert!(hull.triangles().len() >= 4);
    }
}

/// Writes a mesh in the OFF format, with all digits of every number.
fn as_off(mesh: &TriangleMesh) -> String {
    let mut text = format!("OFF\n{} {} 0\n", mesh.coordinates().len(), mesh.triangles().len());
    for [x, y, z] in mesh.coordinates() {
        let _ = writeln!(text, "{x:?} {y:?} {z:?}");
    }
    for [a, b, c] in mesh.triangles() {
        let _ = writeln!(text, "3 {a} {b} {c}");
    }
    text
}
