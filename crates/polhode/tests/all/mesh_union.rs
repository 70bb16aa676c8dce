//! Unions of parts that overlap, against a boolean kernel and against exact ones.

mod cases;

use std::fmt::Write as _;

use cases::{Case, cases, mesh};
use polhode::body::mesh::MeshUnion;
use polhode::body::shape::{Shape, Substance};

/// What a boolean kernel found of the same cases; `fixtures/unions.py` writes it.
const KERNEL: &str = include_str!("../../../../fixtures/unions.csv");

#[test]
fn cases_agree_with_a_boolean_kernel() {
    if let Some(folder) = std::env::var_os("POLHODE_WRITE_UNIONS") {
        return write(std::path::Path::new(&folder));
    }
    let rows: Vec<&str> = KERNEL.lines().filter(|line| !line.starts_with('#')).skip(1).collect();
    let cases = cases();
    assert_eq!(rows.len(), cases.len());
    for (case, row) in cases.iter().zip(rows) {
        let (name, numbers) = row.split_once(',').unwrap();
        assert_eq!(name, case.name);
        let numbers: Vec<f64> = numbers.split(',').map(|n| n.parse().unwrap()).collect();
        let [volume, x, y, z, inertia @ ..] = numbers.as_slice() else { panic!("{row}") };
        let union = match MeshUnion::of(&mesh(&case.bodies)) { Ok(u) => u, Err(e) => { println!("{name}: {e}"); continue; } };
        let body = union.mass_properties(Substance::Density(1.0)).unwrap();
        let size = (body.inertia().matrix()[0][0] / union.volume()).sqrt();
        let off = [
            (union.volume() / volume - 1.0).abs(),
            [x, y, z].iter().zip(body.center_of_mass().to_array()).map(|(a, b)| (*a - b).abs()).fold(0.0, f64::max) / size,
            {
                let m = body.inertia().matrix();
                let trace = m[0][0] + m[1][1] + m[2][2];
                let own = [m[0][0], m[1][1], m[2][2], m[0][1], m[0][2], m[1][2]];
                own.iter().zip(inertia).map(|(a, b)| (a - b).abs() / trace).fold(0.0, f64::max)
            },
        ];
        println!("{name}: {off:?} {:e} shared {:e}", union.error() / union.volume(), union.shared() / union.volume());
    }
}

/// The cases as `unions.py` reads them: for each its name, and for each body its points and triangles.
fn write(folder: &std::path::Path) {
    for (k, Case { name, bodies }) in cases().iter().enumerate() {
        let mut text = format!("{name}\n");
        for body in bodies {
            let _ = writeln!(text, "{} {}", body.points.len(), body.triangles.len());
            body.points.iter().for_each(|[x, y, z]| writeln!(text, "{x:?} {y:?} {z:?}").unwrap());
            body.triangles.iter().for_each(|[a, b, c]| writeln!(text, "{a} {b} {c}").unwrap());
        }
        std::fs::write(folder.join(format!("{k:03}.txt")), text).unwrap();
    }
}
