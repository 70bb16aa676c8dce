//! Cost of meshes, in ns per triangle, µs and ms. `cargo bench -p polhode --bench mesh`.
//!
//! Each line: name, minimum time of a few runs, unit.

use std::collections::HashMap;
use std::hint::black_box;
use std::time::Instant;

use polhode::body::MassPropertiesGradient;
use polhode::body::mesh::{ConvexHull, MeshDerivatives, MeshDiagnosis, MeshShell};
use polhode::prelude::*;

/// Returns the minimum time of a few runs, s.
fn least<T>(mut work: impl FnMut() -> T) -> f64 {
    let mut least = f64::INFINITY;
    let begin = Instant::now();
    while begin.elapsed().as_secs_f64() < 2.0 {
        let start = Instant::now();
        black_box(work());
        least = least.min(start.elapsed().as_secs_f64());
    }
    least
}

/// Returns an octahedron on a wavy sphere, with each face divided into four `level` times.
fn lump(level: u32) -> Result<TriangleMesh, BodyError> {
    let mut vertices = vec![];
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let mut p = [0.0; 3];
            p[axis] = sign;
            vertices.push(p);
        }
    }
    let mut faces: Vec<[u32; 3]> = (0..8)
        .map(|k: u32| {
            let [x, y, z] = [k & 1, 2 + (k >> 1 & 1), 4 + (k >> 2)];
            if k.count_ones().is_multiple_of(2) { [x, y, z] } else { [x, z, y] }
        })
        .collect();
    for _division in 0..level {
        let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                let (p, q): ([f64; 3], [f64; 3]) = (vertices[a as usize], vertices[b as usize]);
                let sum: [f64; 3] = std::array::from_fn(|k| p[k] + q[k]);
                let norm = sum.iter().map(|c| c * c).sum::<f64>().sqrt();
                vertices.push(sum.map(|c| c / norm));
                vertices.len() as u32 - 1
            })
        };
        let divide = |&[a, b, c]: &[u32; 3]| {
            let (p, q, r) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, p, r], [p, b, q], [r, q, c], [p, q, r]]
        };
        faces = faces.iter().flat_map(divide).collect();
    }
    let wavy = |[x, y, z]: [f64; 3]| {
        let r = 1.0 + 0.1 * (5.0 * x).sin() * (7.0 * y + 1.0).cos() + 0.05 * (11.0 * z).sin();
        [1.3 * r * x + 0.2 * y, 0.8 * r * y, 0.6 * r * z - 0.1 * x]
    };
    TriangleMesh::new(vertices.into_iter().map(wavy).collect(), faces)
}

/// Returns the mesh with each corner moved by up to `by`.
fn rough(mesh: &TriangleMesh, by: f64) -> Result<TriangleMesh, BodyError> {
    let mut state = 7_u64;
    let mut chance = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / 9_007_199_254_740_992.0 - 0.5
    };
    let moved = mesh.coordinates().iter().map(|p| p.map(|c| c + 2.0 * by * chance()));
    TriangleMesh::new(moved.collect(), mesh.triangles().to_vec())
}

/// Measures derivatives with respect to all vertices, compared with the mass integrals, which a
/// change of unit computes. Run with `taskset -c 0`, as derivatives use one thread.
fn derivatives(mesh: &TriangleMesh) -> Result<(), BodyError> {
    let count = mesh.triangles().len() as f64;
    let (mut solid, mut factor) = (Some(ClosedMesh::of(mesh)?), 2.0);
    let integrals = least(|| {
        solid = solid.take().and_then(|solid| solid.scaled(factor).ok());
        factor = 1.0 / factor;
    });
    let solid = ClosedMesh::of(mesh)?;
    let derivatives = MeshDerivatives::of(&solid, Substance::Density(1.7))?;
    let by_inertia = [0.9, -0.2, 0.5, 1.3, -0.6, 0.8];
    let number = MassPropertiesGradient {
        by_mass: 0.3,
        by_center_of_mass: Direction::new(-0.7, 1.1, 0.4),
        by_inertia,
    };
    let gradient = least(|| derivatives.gradient(&number));
    let all = least(|| derivatives.by_vertices());
    println!("{count} triangles: mass integrals\t{:.1}\tns/triangle", integrals * 1e9 / count);
    println!("{count} triangles: a gradient by all vertices\t{:.1}\tns/triangle", gradient * 1e9 / count);
    println!("{count} triangles: all derivatives by all vertices\t{:.1}\tns/triangle", all * 1e9 / count);
    Ok(())
}

/// Measures a whole mesh with few triangles: its diagnosis and integrals, and without the search for
/// intersections.
fn small(mesh: &TriangleMesh) {
    let count = mesh.triangles().len();
    let whole = least(|| ClosedMesh::of(mesh));
    let unchecked = least(|| ClosedMesh::unchecked(mesh, &|| true));
    println!("solid of {count} triangles\t{:.1}\tµs", whole * 1e6);
    println!("solid of {count} triangles, unchecked\t{:.1}\tµs", unchecked * 1e6);
}

fn main() -> Result<(), BodyError> {
    for level in [3, 4, 5] {
        small(&lump(level)?); // 512, 2,048 and 8,192 triangles
    }
    let mesh = lump(9)?; // 2,097,152 triangles
    let count = mesh.triangles().len();
    let soup = TriangleMesh::of_triangles(&mesh.corners().collect::<Vec<_>>())?;
    let rough = rough(&mesh, 5e-4)?; // a sixth of an edge
    println!("triangles\t{count}\t1");
    for threads in [1, 2] {
        for (what, mesh) in [("indexed", &mesh), ("without indices", &soup), ("rough", &rough)] {
            let seconds = least(|| MeshDiagnosis::with_threads(mesh, threads));
            let million = seconds * 1e3 * 1.3e6 / count as f64;
            println!("diagnosis of 1.3 million triangles, {what}, {threads} threads\t{million:.0}\tms");
        }
        let seconds = least(|| ClosedMesh::with_threads(&mesh, threads));
        println!("solid, {threads} threads\t{:.1}\tns/triangle", seconds * 1e9 / count as f64);
    }
    derivatives(&lump(7)?)?; // 131,072 triangles
    let points = mesh.coordinates();
    println!("convex hull of {} points\t{:.0}\tms", points.len(), least(|| ConvexHull::of(points)) * 1e3);
    println!("shell\t{:.1}\tns/triangle", least(|| MeshShell::new(&mesh, 1e-3)) * 1e9 / count as f64);
    Ok(())
}
