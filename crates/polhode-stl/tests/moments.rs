//! The moments against exact sums in integers, and the promises about bits, edges and bad records.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod common;

use std::num::NonZeroUsize;

use common::{GRID, Integers, Triangle, icosphere, record, records};
use polhode_stl::{Options, Record, moments_of_file, moments_of_records};

fn options(threads: usize) -> Options {
    Options { threads: NonZeroUsize::new(threads).unwrap(), edges: true }
}

/// Largest difference of the central second moments from the exact ones, in units of half their trace, and the relative
/// error of the volume.
fn errors(triangles: &[Triangle]) -> (f64, f64) {
    let exact = Integers::of(triangles);
    let m = moments_of_records(&records(triangles), &options(2));
    assert_eq!(m.edge_hash, Some(0));
    let c = m.first.map(|f| f / (4.0 * m.six_volume));
    let outer = [c[0] * c[0], c[1] * c[1], c[2] * c[2], c[0] * c[1], c[0] * c[2], c[1] * c[2]];
    let covariance: [f64; 6] = core::array::from_fn(|k| m.second[k] / (20.0 * m.six_volume) - outer[k]);
    let (volume, central) = exact.volume_and_covariance();
    let trace = central[0] + central[1] + central[2];
    let worst =
        covariance.iter().zip(central).map(|(a, b)| (a - b).abs() / (0.5 * trace)).fold(0.0, f64::max);
    ((m.six_volume / 6.0 / volume - 1.0).abs(), worst)
}

#[test]
fn spheres_agree_with_exact_integers() {
    for levels in 0..7 {
        for offset in [[0.0; 3], [3.0, -2.5, 1.75], [96.0, 33.0, -65.0]] {
            let (volume, covariance) = errors(&icosphere(levels, offset));
            println!("{} triangles at {offset:?}: {volume:.1e} {covariance:.1e}", 20 * 4_usize.pow(levels));
            assert!(volume < 1e-15 && covariance < 2e-15, "{levels} {offset:?}: {volume:e} {covariance:e}");
        }
    }
}

#[test]
fn one_and_many_threads_memory_and_file_have_the_same_bits() {
    let triangles = icosphere(6, [3.0, -2.5, 1.75]);
    // Not a whole number of groups, stages, chunks or blocks.
    for length in [1, 15, 17, 63, 65, 1023, 4097, 4096 * 3 + 77, 16_384 * 2 + 77, 81_920] {
        let records = records(&triangles[..length]);
        let one = moments_of_records(&records, &options(1));
        let path = std::env::temp_dir().join(format!("polhode-stl-{}-{length}", std::process::id()));
        std::fs::write(&path, [b"seven b".as_slice(), records.as_flattened()].concat()).unwrap();
        let file = std::fs::File::open(&path).unwrap();
        for threads in [1, 2, 3, 8] {
            assert_eq!(moments_of_records(&records, &options(threads)), one);
            assert_eq!(moments_of_file(&file, 7, length as u64, &options(threads)).unwrap(), one);
        }
        let beyond = moments_of_file(&file, 7, length as u64 + 1, &options(2)).unwrap_err();
        assert_eq!(beyond.kind(), std::io::ErrorKind::UnexpectedEof);
        std::fs::remove_file(path).unwrap();
        let without = moments_of_records(&records, &Options { edges: false, ..options(1) });
        assert_eq!(without, polhode_stl::Moments { edge_hash: None, ..one });
    }
}

#[test]
fn the_bounds_and_the_area_are_those_of_the_triangles() {
    let triangles: Vec<Triangle> = icosphere(3, [3.0, -2.5, 1.75])[..777].to_vec();
    let m = moments_of_records(&records(&triangles), &options(1));
    for k in 0..3 {
        let coordinates = || triangles.iter().flatten().map(|v| f64::from(v[k]));
        assert_eq!(m.low[k], coordinates().fold(f64::INFINITY, f64::min));
        assert_eq!(m.high[k], coordinates().fold(f64::NEG_INFINITY, f64::max));
    }
    let area: f64 = triangles.iter().map(common::area).sum();
    assert!((m.area / area - 1.0).abs() < 1e-14);
}

#[test]
fn no_triangles_have_no_moments() {
    let m = moments_of_records(&[], &options(2));
    assert_eq!((m.count, m.six_volume, m.area, m.edge_hash), (0, 0.0, 0.0, Some(0)));
}

fn hash(triangles: &[Triangle]) -> u64 {
    moments_of_records(&records(triangles), &options(1)).edge_hash.unwrap()
}

#[test]
fn a_closed_mesh_in_any_order_has_the_hash_zero() {
    let mut mesh = icosphere(4, [0.5, 0.25, -0.75]);
    let flipped: Vec<Triangle> = mesh.iter().map(|&[a, b, c]| [a, c, b]).collect();
    assert_eq!(hash(&flipped), 0);
    mesh.reverse();
    for (k, triangle) in mesh.iter_mut().enumerate() {
        triangle.rotate_left(k % 3);
    }
    assert_eq!(hash(&mesh), 0);
    // A triangle with two equal corners bounds nothing, and −0 is 0.
    mesh.push([[0.5, 0.0, 1.0], [0.5, 0.0, 1.0], [7.0, 8.0, 9.0]]);
    assert_eq!(hash(&mesh), 0);
    let [o, x, y, z] = [[0.0_f32, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
    let minus = |v: [f32; 3]| v.map(|c| if c == 0.0 { -0.0 } else { c });
    assert_eq!(hash(&[[o, minus(y), x], [minus(o), x, z], [o, z, y], [minus(x), y, minus(z)]]), 0);
}

#[test]
fn an_open_or_inconsistent_mesh_never_has_the_hash_zero() {
    let mesh = icosphere(5, [0.0; 3]);
    let whole: u64 = 0;
    // The hash of the mesh without a triangle, or with it turned, is minus once or twice what the triangle adds.
    let mut seen = std::collections::HashSet::new();
    for triangle in mesh.iter().step_by(3) {
        let alone = hash(&[*triangle]);
        assert_ne!(whole.wrapping_sub(alone), 0);
        assert_ne!(whole.wrapping_sub(alone.wrapping_mul(2)), 0);
        // Nor do two of them make up for each other.
        assert!(seen.insert(alone) && !seen.contains(&alone.wrapping_neg()));
    }
    let mut open = mesh.clone();
    open.remove(4321);
    assert_ne!(hash(&open), 0);
    let mut turned = mesh.clone();
    turned[1234].swap(0, 1);
    assert_ne!(hash(&turned), 0);
    // One bit of one coordinate.
    let mut moved = mesh;
    moved[777][1][2] = f32::from_bits(moved[777][1][2].to_bits() ^ 1);
    assert_ne!(hash(&moved), 0);
}

#[test]
fn triangles_of_a_lattice_add_different_areas() {
    // Few bits in each coordinate, every step the same: what a weak hash would map to a lattice again.
    let mut seen = std::collections::HashSet::new();
    let mut mesh = Vec::new();
    for i in (0..24_u8).step_by(2) {
        for j in 0..12_u8 {
            for k in 6..18_u8 {
                let p = |di: u8, dj: u8, dk: u8| [i + di, j + dj, k + dk].map(|n| f32::from(n) - 8.0);
                mesh.push([p(0, 0, 0), p(1, 0, 0), p(0, 1, 0)]);
                mesh.push([p(0, 0, 0), p(0, 1, 0), p(0, 0, 1)]);
                mesh.push([p(0, 0, 0), p(0, 0, 1), p(1, 0, 0)]);
                mesh.push([p(1, 0, 0), p(0, 1, 0), p(0, 0, 1)]);
            }
        }
    }
    for triangle in &mesh {
        let alone = hash(&[*triangle]);
        assert!(alone != 0 && seen.insert(alone) && !seen.contains(&alone.wrapping_neg()));
    }
}

#[test]
fn vertices_that_are_not_finite_are_counted_and_the_first_is_named() {
    let mesh = icosphere(5, [1.0, 2.0, 3.0]);
    for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for at in [0, 1, 4095, 4096, 12_345, 16_383, 16_384, 20_477] {
            let mut bad = mesh.clone();
            bad[at][1][2] = value;
            bad[20_478][2] = [value; 3];
            let m = moments_of_records(&records(&bad), &options(2));
            let found = m.not_finite.unwrap();
            assert_eq!((found.vertices, found.triangle, found.offset), (2, at as u64, 12 + 12 + 8));
            assert_eq!(found.value.to_bits(), value.to_bits());
        }
    }
    // The largest numbers there are do no harm.
    let huge: Vec<Record> = mesh.iter().map(|t| record(&t.map(|v| v.map(|c| c * 5e37)))).collect();
    let m = moments_of_records(&huge, &options(2));
    assert!(m.not_finite.is_none() && m.second.iter().all(|s| s.is_finite()));
}

#[test]
fn the_grid_holds_every_coordinate() {
    for vertex in icosphere(3, [96.0, 33.0, -65.0]).iter().flatten().flatten() {
        assert_eq!((f64::from(*vertex) * GRID).fract(), 0.0);
    }
}
