//! Limits, accuracy and errors of hollow shapes and triangles; `shapes.rs` compares them with their
//! definitions.

use std::f64::consts::PI;

use polhode::body::BodyError;
use polhode::body::shape::{
    ConeShell, Cylinder, CylinderShell, Shape, Sphere, SphereShell, Substance, TriangularPlate,
    TriangularPrism,
};
use polhode::prelude::*;

/// Returns volume or area, surface area, and second moments per unit mass.
fn numbers(shape: &dyn Shape) -> [f64; 11] {
    let spread = shape.spread();
    let body = shape.mass_properties(Substance::Mass(1.0)).unwrap();
    let tensor = body.inertia().matrix();
    let mut numbers = [0.0; 11];
    numbers[..2].copy_from_slice(&[spread.extent().measure(), shape.surface_area()]);
    numbers[2..].copy_from_slice(tensor.as_flattened());
    numbers
}

#[test]
fn without_a_cavity_a_hollow_shape_is_the_solid_to_the_bit() {
    for (r, l) in [(0.37, 0.91), (1.7e-3, 4.1e2), (2.3e40, 0.013)] {
        assert_eq!(numbers(&Cylinder::hollow(r, 0.0, l).unwrap()), numbers(&Cylinder::new(r, l).unwrap()));
        assert_eq!(numbers(&Sphere::hollow(r, 0.0).unwrap()), numbers(&Sphere::new(r).unwrap()));
        // Textbook formulas of the solids.
        let solid = numbers(&Cylinder::new(r, l).unwrap());
        assert_eq!(solid[0], PI * r * r * l);
        assert_eq!(numbers(&Sphere::new(r).unwrap())[0], 4.0 / 3.0 * PI * r * r * r);
        // A cavity below the rounding of the radius has no effect.
        assert_eq!(numbers(&Sphere::hollow(r, 1e-17 * r).unwrap()), numbers(&Sphere::new(r).unwrap()));
    }
}

/// Differences of powers for r = R (1 − e): R³ − r³ = R³ (3e − 3e² + e³), R⁵ − r⁵ = R⁵
/// (5e − 10e² + 10e³ − 5e⁴ + e⁵). e is a power of two, so that r is exact.
#[test]
fn a_thin_wall_keeps_its_digits() {
    let (outer, length, mass) = (1.0, 0.7, 2.3);
    for e in [0.25_f64, 0.5_f64.powi(10), 0.5_f64.powi(30), 0.5_f64.powi(52)] {
        let inner = outer * (1.0 - e);
        let close =
            |got: f64, want: f64| assert!((got / want - 1.0).abs() < 1e-15, "{e:e}: {got:e}, not {want:e}");
        let cubes = e * (3.0 - 3.0 * e + e * e);
        let fifths = e * (5.0 - 10.0 * e + 10.0 * e * e - 5.0 * e * e * e + e * e * e * e);
        let sphere = Sphere::hollow(outer, inner).unwrap();
        close(sphere.spread().extent().measure(), 4.0 / 3.0 * PI * cubes);
        let body = sphere.mass_properties(Substance::Mass(mass)).unwrap();
        close(body.inertia().matrix()[1][1], 0.4 * mass * (fifths / cubes));
        let cylinder = Cylinder::hollow(outer, inner, length).unwrap();
        close(cylinder.spread().extent().measure(), PI * (e * (2.0 - e)) * length);
        let body = cylinder.mass_properties(Substance::Density(1240.0)).unwrap();
        // I_zz = ½ ρ π l (R⁴ − r⁴) = ½ ρ π l (4e − 6e² + 4e³ − e⁴)
        let fourths = e * (4.0 - 6.0 * e + 4.0 * e * e - e * e * e);
        close(body.inertia().matrix()[2][2], 0.5 * 1240.0 * PI * length * fourths);
    }
}

#[test]
fn a_wall_without_thickness_is_a_shell() {
    let (r, l) = (0.37_f64, 0.91);
    let inner = r.next_down();
    let wall = r - inner;
    let near = |solid: &dyn Shape, shell: &dyn Shape| {
        let (solid, shell) = (numbers(solid), numbers(shell));
        // The volume is the area times the wall, and both sides count as surface.
        assert!((solid[0] / (shell[0] * wall) - 1.0).abs() < 1e-15);
        for (solid, shell) in solid.into_iter().zip(shell).skip(2) {
            assert!((solid - shell).abs() < 1e-15, "{solid} {shell}");
        }
    };
    near(&Sphere::hollow(r, inner).unwrap(), &SphereShell::new(r).unwrap());
    near(&Cylinder::hollow(r, inner, l).unwrap(), &CylinderShell::new(r, l, false).unwrap());
}

#[test]
fn cones_and_prisms_have_their_limits() {
    let same = |a: &dyn Shape, b: &dyn Shape| {
        for (a, b) in numbers(a).into_iter().zip(numbers(b)) {
            assert!((a - b).abs() <= 1e-15 * a.abs().max(b.abs()), "{a} {b}");
        }
    };
    let (r, h) = (0.37, 0.91);
    same(&ConeShell::new(r, r, h, false).unwrap(), &CylinderShell::new(r, h, false).unwrap());
    // Two right triangles along a diagonal are a plate: as an assembly, with masses by area.
    let (a, b, l) = (0.31, 0.47, 0.83);
    let halves = [[[0.0, 0.0], [a, 0.0], [a, b]], [[0.0, 0.0], [a, b], [0.0, b]]].map(|corners| {
        let prism =
            TriangularPrism::new(corners, l).unwrap().mass_properties(Substance::Density(3.0)).unwrap();
        PlacedPart::new(prism, Position::ZERO, Rotation::identity()).unwrap()
    });
    let whole = assemble(&halves).unwrap();
    let block = BoxShape::new([a, b, l]).unwrap().mass_properties(Substance::Density(3.0)).unwrap();
    assert!((whole.mass() / block.mass() - 1.0).abs() < 1e-15);
    let pairs =
        whole.inertia().matrix().into_iter().flatten().zip(block.inertia().matrix().into_iter().flatten());
    for (got, want) in pairs {
        assert!((got - want).abs() < 1e-15, "{got} {want}");
    }
    // A prism of zero length is the plate.
    let corners = [[0.2, -0.3], [1.1, 0.1], [0.4, 0.9]];
    let [plate, thin] = [
        numbers(&TriangularPlate::new(corners).unwrap()),
        numbers(&TriangularPrism::new(corners, 1e-12).unwrap()),
    ];
    for (plate, thin) in plate.into_iter().zip(thin).skip(2) {
        assert!((plate - thin).abs() < 1e-16);
    }
}

#[test]
fn what_leaves_no_wall_or_no_area_is_refused_by_name() {
    let refused = |name: &str, value: f64, error: Option<BodyError>| match error {
        Some(BodyError::Parameter { what, value: got, .. }) => {
            assert_eq!(what, name);
            assert!(got == value || got.is_nan() && value.is_nan(), "{name}: {got} instead of {value}");
        }
        other => panic!("{name} = {value}: {other:?}"),
    };
    for value in [0.4, 0.5, -1e-9, -0.4, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        refused("the cylinder's inner radius", value, Cylinder::hollow(0.4, value, 1.0).err());
        refused("the sphere's inner radius", value, Sphere::hollow(0.4, value).err());
    }
    refused("the cylinder's radius", f64::NAN, Cylinder::hollow(f64::NAN, 0.1, 1.0).err());
    for value in [-1.0, f64::NAN, f64::INFINITY] {
        refused("the conical shell's base radius", value, ConeShell::new(value, 1.0, 1.0, false).err());
        refused("the conical shell's top radius", value, ConeShell::new(1.0, value, 1.0, true).err());
    }
    refused("the larger radius of the conical shell", 0.0, ConeShell::new(0.0, 0.0, 1.0, false).err());

    let plate = |corners| TriangularPlate::new(corners).err();
    let prism = |corners| TriangularPrism::new(corners, 1.0).err();
    let (o, p) = ([0.1, 0.2], [1.7, -0.4]);
    refused("the triangular plate's vertex", f64::NAN, plate([o, p, [f64::NAN, 0.0]]));
    refused("the triangular prism's vertex", f64::INFINITY, prism([o, [0.0, f64::INFINITY], p]));
    // On the line of the others, except for the rounding of its own coordinates.
    for u in [0.3, -2.7, 1.0, 0.0] {
        let q = [0, 1].map(|k| o[k] + u * (p[k] - o[k]));
        for (error, name) in [
            (plate([o, p, q]), "the triangular plate's area"),
            (prism([o, p, q]), "the triangular prism's area"),
        ] {
            assert!(matches!(error, Some(BodyError::Parameter { what, .. }) if what == name), "{error:?}");
        }
    }
    assert!(plate([o; 3]).is_some());
}
