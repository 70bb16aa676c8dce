//! Bodies at the limits of the range of numbers.

use std::f64::consts::{PI, TAU};

use crate::edges::{TURN, relative, turned};
use polhode::body::shape::{
    BoxShell, Capsule, Cone, CylinderShell, Disk, Ellipsoid, Plate, SphereShell, Tetrahedron, Torus,
};
use polhode::prelude::*;

#[test]
fn radii_of_gyration_are_where_the_mass_would_be_a_ring() {
    for (got, i) in turned([1.3, 2.1, 2.9], TURN).gyration_radii().into_iter().zip([1.3, 2.1, 2.9]) {
        assert!((2.3 * got * got - i).abs() < 4e-15);
    }
}

#[test]
fn tensors_on_the_edge_of_the_possible() {
    use BodyError::{NegativeMoment, NotSymmetric, TriangleInequality};
    for scale in [1e-200, 1.0, 3e150] {
        let diagonal = |m: [f64; 3]| InertiaTensor::<Body>::diagonal(m.map(|i| i * scale));
        let over = |n: f64| diagonal([1.0, 1.0, 2.0 * (1.0 + n * f64::EPSILON)]);
        assert!(over(32.0).is_ok() && matches!(over(200.0), Err(TriangleInequality { .. })));
        let below = |n: f64| diagonal([-n * f64::EPSILON, 1.0, 1.0]);
        assert!(below(32.0).is_ok() && matches!(below(200.0), Err(NegativeMoment { .. })));
    }
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        let skew = |part: f64| {
            let mut rows = [[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]];
            rows[j][i] += part * 5.3;
            InertiaTensor::<Body>::from_matrix(rows)
        };
        assert!(skew(0.9e-12).is_ok() && skew(-0.9e-12).is_ok());
        for refused in [skew(1.1e-12), skew(-1.1e-12)] {
            assert!(matches!(refused, Err(NotSymmetric { element, .. }) if element == [i + 1, j + 1]));
        }
    }
}

#[test]
fn thin_meshes_are_solids_and_flat_ones_are_not() {
    let wedge = |unit: f64, height: f64| {
        let [o, x, y, z] =
            [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.3, 0.2, height]].map(|p| p.map(|c| c * unit));
        ClosedMesh::from_triangles(vec![[o, y, x], [o, x, z], [o, z, y], [x, y, z]])
    };
    for unit in [1e-60, 1.0, 1e60] {
        let thin = wedge(unit, 1e-13).unwrap();
        assert!(relative(thin.volume(), 1e-13 / 6.0 * unit * unit * unit) < 0.01);
        assert!(matches!(wedge(unit, 1e-15), Err(BodyError::FlatMesh { .. })));
        assert!(matches!(wedge(unit, 0.0), Err(BodyError::FlatMesh { .. })));
    }
}

#[test]
fn a_size_that_f64_does_not_hold_is_refused() {
    fn too_far(result: Result<impl std::fmt::Debug, BodyError>) -> bool {
        result.is_err_and(
            |e| matches!(e, BodyError::Parameter { rule, .. } if rule.contains("too large or too small")),
        )
    }
    let corners = [[0.1, 0.2, 0.3], [1.7, 0.1, -0.4], [0.6, 0.9, 0.8], [0.0, 0.0, 2.0]];
    let [a, b, c, d] = corners;
    let mesh = [[a, c, b], [a, b, d], [b, c, d], [c, a, d]];
    let tetrahedron = |s: f64| Tetrahedron::new(corners.map(|p| p.map(|x| x * s)));
    let closed = |s: f64| ClosedMesh::from_triangles(mesh.map(|t| t.map(|p| p.map(|x| x * s))).to_vec());
    let unit = tetrahedron(1.0).unwrap().spread().extent().measure();
    for s in [1e-100, 1e-9, 1e9, 1e100] {
        assert!(relative(tetrahedron(s).unwrap().spread().extent().measure() / s / s / s, unit) < 1e-14);
        assert!(relative(closed(s).unwrap().volume() / s / s / s, unit) < 1e-14);
        assert!(BoxShape::new([s; 3]).is_ok() && Ellipsoid::new([s; 3]).is_ok() && Torus::new(s, s).is_ok());
    }
    for s in [1e-110, 1e110] {
        assert!(too_far(tetrahedron(s)) && too_far(closed(s)), "{s:e}");
        assert!(too_far(BoxShape::new([s; 3])) && too_far(Ellipsoid::new([s; 3])) && too_far(Sphere::new(s)));
        assert!(too_far(Cylinder::new(s, s)) && too_far(Capsule::new(s, s)) && too_far(Cone::new(s, 0.0, s)));
        assert!(too_far(Torus::new(s, 0.5 * s)));
        assert!(Disk::new(s).is_ok() && Rod::new(s).is_ok());
    }
    for s in [1e-170, 1e170] {
        assert!(too_far(BoxShell::new([s; 3])) && too_far(SphereShell::new(s)) && too_far(Disk::new(s)));
        assert!(too_far(CylinderShell::new(s, s, true)) && too_far(CylinderShell::new(s, s, false)));
        assert!(too_far(Plate::new([s; 2])) && too_far(Rod::new(s)));
        assert!(too_far(closed(s)) && too_far(tetrahedron(s)));
    }
    // the coordinates are in range, their differences are not
    let wide = |p: [f64; 3]| p.map(|x| (x - 0.6) * 1.2e308);
    assert!(too_far(Tetrahedron::new(corners.map(wide))));
    assert!(too_far(ClosedMesh::from_triangles(mesh.map(|t| t.map(wide)).to_vec())));
    // each number is in range, their product is not
    let speck = BoxShape::new([1e-100; 3]).unwrap();
    assert!(too_far(speck.mass_properties(Substance::Mass(1e-150))));
    let moon = BoxShape::new([1e100; 3]).unwrap();
    assert!(too_far(moon.mass_properties(Substance::Mass(1e150))));
    assert!(moon.mass_properties(Substance::Density(1e10)).is_err());
    assert!(speck.mass_properties(Substance::Mass(1e100)).is_ok());
}

#[test]
fn a_needle_and_a_flake_have_an_area() {
    let area = |semi_axes| Ellipsoid::new(semi_axes).unwrap().surface_area();
    // two sides of a disk, and of an ellipse
    assert!(relative(area([0.7, 1e-200, 0.7]), TAU * 0.49) < 2e-15);
    assert!(relative(area([0.7, 0.3, 1e-250]), TAU * 0.21) < 2e-15);
    // a round needle: ∫ 2π b √(1 − x²/a²) dx over its length = π² a b
    assert!(relative(area([1e130, 1e-150, 1e-150]), PI * PI * 1e-20) < 2e-15);
    assert!(relative(area([1e-90, 1e120, 1e-90]), PI * PI * 1e30) < 2e-15);
    // flat and thin: again two sides of an ellipse
    assert!(relative(area([1.0, 1e-12, 1e-24]), TAU * 1e-12) < 2e-15);
    assert!(relative(area([1e-40, 1e20, 1e-10]), TAU * 1e10) < 2e-15);
    // near the ratio below which the result no longer changes
    for ratio in [1e-10, 1e-11, 1e-12, 1e-13] {
        assert!(relative(area([1.0, ratio, ratio]), PI * PI * ratio) < 2e-15);
    }
}
