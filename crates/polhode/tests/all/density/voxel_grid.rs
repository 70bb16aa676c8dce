//! Voxel grids compared with assemblies of boxes and with cubature.

use polhode::body::density::{Cubature, Solid, VoxelGrid, mass_properties_of_field};
use polhode::prelude::*;

use super::Random;

/// Returns random voxels in a slanted lattice, some of them empty.
fn voxels(counts: [usize; 3], random: &mut Random) -> Vec<f64> {
    let n: usize = counts.iter().product();
    (0..n).map(|_| if random.below(3) == 0 { 0.0 } else { 1000.0 + 500.0 * random.next() }).collect()
}

#[test]
fn a_voxel_grid_is_the_assembly_of_its_boxes() {
    let mut random = Random(3);
    let turn = Rotation::<Body, Part>::from_quaternion([0.6, -0.3, 0.5, 0.2]).unwrap();
    let rows = turn.matrix();
    for counts in [[3, 4, 5], [1, 1, 1], [7, 1, 2], [2, 5, 1]] {
        let values = voxels(counts, &mut random).iter().map(|v| v + 1.0).collect::<Vec<_>>();
        let size = [0.02, 0.035, 0.05];
        // The lattice is along the rotated axes: step k is column k of R.
        let steps = std::array::from_fn(|k| std::array::from_fn(|x| rows[x][k] * size[k]));
        let grid = VoxelGrid::new([0.7, -1.3, 0.4], steps, counts).unwrap();
        let body = grid.mass_properties(|voxel| values[voxel]).unwrap();
        let brick = BoxShape::new(size).unwrap();
        let parts: Vec<_> = values
            .iter()
            .enumerate()
            .map(|(voxel, &rho)| {
                let part = brick.mass_properties(Substance::Density(rho)).unwrap();
                PlacedPart::new(part, Position::from_array(grid.center(voxel)), turn).unwrap()
            })
            .collect();
        let exact = assemble(&parts).unwrap();
        assert!((body.properties.mass() / exact.mass() - 1.0).abs() < 1e-15);
        let offset = body.properties.center_of_mass().to_array();
        let offset: f64 =
            (0..3).map(|k| (offset[k] - exact.center_of_mass().to_array()[k]).abs()).fold(0.0, f64::max);
        assert!(offset < 4e-16, "{offset}");
        let (got, exact) = (body.properties.inertia().matrix(), exact.inertia().matrix());
        let trace = exact[0][0] + exact[1][1] + exact[2][2];
        for k in 0..9 {
            let error = got[k / 3][k % 3] - exact[k / 3][k % 3];
            assert!(error.abs() < 1e-15 * trace, "{counts:?} {k}: {error}");
        }
        assert_eq!(body.filled, values.len());
        assert!((body.volume / (values.len() as f64 * 3.5e-5) - 1.0).abs() < 1e-14);
    }
}

#[test]
fn a_trilinear_density_is_integrated_exactly_by_the_trilinear_reading() {
    let mut random = Random(11);
    let counts = [3, 2, 4];
    let values = voxels(counts, &mut random);
    let size = [0.3, 0.2, 0.25];
    let origin = [0.15, 0.1, 0.125];
    let steps = [[size[0], 0.0, 0.0], [0.0, size[1], 0.0], [0.0, 0.0, size[2]]];
    let grid = VoxelGrid::new(origin, steps, counts).unwrap();
    let read = grid.mass_properties(|voxel| values[voxel]).unwrap();
    // The same function by cubature over every half voxel, where it is a polynomial.
    let at = |index: [usize; 3]| values[index[0] + counts[0] * (index[1] + counts[1] * index[2])];
    let field = |p: [f64; 3]| {
        let place: [f64; 3] =
            std::array::from_fn(|k| ((p[k] - origin[k]) / size[k]).clamp(0.0, counts[k] as f64 - 1.0));
        let low: [usize; 3] = place.map(|t| t as usize);
        let mut rho = 0.0;
        for corner in 0..8 {
            let bit = |k: usize| corner >> k & 1;
            let index: [usize; 3] = std::array::from_fn(|k| (low[k] + bit(k)).min(counts[k] - 1));
            let share = |k: usize| {
                let t = place[k] - low[k] as f64;
                if bit(k) == 1 { t } else { 1.0 - t }
            };
            rho += at(index) * share(0) * share(1) * share(2);
        }
        rho
    };
    let halves = counts.map(|n| 2 * n);
    let half = BoxShape::new(size.map(|s| 0.5 * s)).unwrap();
    let mut parts = Vec::new();
    for number in 0..halves.iter().product::<usize>() {
        let index = [number % halves[0], number / halves[0] % halves[1], number / halves[0] / halves[1]];
        let middle: [f64; 3] = std::array::from_fn(|k| (index[k] as f64 + 0.5) * 0.5 * size[k]);
        let local = |p: [f64; 3]| field(std::array::from_fn(|k| p[k] + middle[k]));
        let cubature = Cubature { tolerance: 1e-13, ..Cubature::default() };
        // An octant without mass is skipped.
        if let Ok(body) = mass_properties_of_field(Solid::Shape(&half), &local, cubature) {
            let part = body.properties;
            parts.push(PlacedPart::new(part, Position::from_array(middle), Rotation::identity()).unwrap());
        }
    }
    let exact = assemble(&parts).unwrap();
    assert!((read.trilinear.mass() / exact.mass() - 1.0).abs() < 2e-15);
    assert_eq!(read.trilinear.mass(), read.properties.mass());
    let (a, b) = (read.trilinear.center_of_mass().to_array(), exact.center_of_mass().to_array());
    assert!((0..3).all(|k| (a[k] - b[k]).abs() < 4e-16), "{a:?} {b:?}");
    let (got, exact) = (read.trilinear.inertia().matrix(), exact.inertia().matrix());
    let trace = got[0][0] + got[1][1] + got[2][2];
    for k in 0..9 {
        assert!((got[k / 3][k % 3] - exact[k / 3][k % 3]).abs() < 1e-15 * trace);
    }
    // The estimate is the difference of the two interpretations.
    let (a, b) = (read.properties.center_of_mass(), read.trilinear.center_of_mass());
    assert!((a - b).norm() > 1e-4 && (a - b).norm() <= read.error_estimate.center_of_mass);
    assert!(read.error_estimate.inertia > 1e-3 && read.error_estimate.inertia < 0.5);
}

#[test]
fn a_speck_far_from_the_middle_of_its_grid_loses_nothing() {
    let steps = [[1e-3, 0.0, 0.0], [0.0, 1e-3, 0.0], [0.0, 0.0, 1e-3]];
    let grid = VoxelGrid::new([0.0; 3], steps, [100_000, 2, 3]).unwrap();
    let speck = |voxel: usize| if voxel == 5 || voxel == 6 { 3.0 } else { 0.0 };
    let body = grid.mass_properties(speck).unwrap();
    let exact = BoxShape::new([2e-3, 1e-3, 1e-3]).unwrap().mass_properties(Substance::Density(3.0)).unwrap();
    let (got, exact) = (body.properties.inertia().matrix(), exact.inertia().matrix());
    for k in 0..9 {
        assert!((got[k / 3][k % 3] - exact[k / 3][k % 3]).abs() < 1e-15 * exact[1][1]);
    }
    assert_eq!((body.filled, body.properties.center_of_mass().x), (2, 5.5e-3));
}

#[test]
fn a_grid_that_cannot_be_is_refused() {
    let step = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let grid = |steps, counts| VoxelGrid::new([0.0; 3], steps, counts);
    assert!(matches!(grid(step, [2, 0, 3]), Err(BodyError::Empty { .. })));
    assert!(matches!(grid(step, [usize::MAX, 2, 1]), Err(BodyError::Parameter { .. })));
    assert!(matches!(grid([step[0], step[1], [1.0, 1.0, 0.0]], [2; 3]), Err(BodyError::Parameter { .. })));
    assert!(matches!(
        grid([step[0], step[1], [0.0, f64::NAN, 1.0]], [2; 3]),
        Err(BodyError::Parameter { .. })
    ));
    let grid = grid(step, [2, 3, 4]).unwrap();
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        match grid.mass_properties(|voxel| if voxel == 9 { bad } else { 1.0 }) {
            // 9 = 1 + 2 (1 + 3 · 1)
            Err(BodyError::Density { at, .. }) => assert_eq!(at, [1.0, 1.0, 1.0]),
            other => panic!("{other:?}"),
        }
    }
    assert!(matches!(grid.mass_properties(|_| 0.0), Err(BodyError::Parameter { what: "the mass", .. })));
}
