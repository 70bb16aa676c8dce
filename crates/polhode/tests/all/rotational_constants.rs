//! Rotational constants: published geometries, limits, and κ compared with exact arithmetic.

use crate::common::{cases, number, numbers, table};
use polhode::observe::{RotationalConstants, Top};
use polhode::prelude::*;

/// Atomic mass constant u, kg (CODATA 2018).
const U: f64 = 1.660_539_066_60e-27;

/// Returns AME2020 masses of the most abundant isotopes, u.
fn mass(atomic_number: f64) -> f64 {
    match atomic_number as u8 {
        1 => 1.007_825_031_898,
        6 => 12.0,
        7 => 14.003_074_004_25,
        8 => 15.994_914_619_26,
        other => panic!("element {other}"),
    }
}

fn body(atoms: &toml::Value, unit: f64) -> MassProperties<Body> {
    let one = |atom: &toml::Value| {
        let [z, x, y, w] = numbers(atom);
        Particle::new(mass(z) * U, Position::new(x * unit, y * unit, w * unit)).unwrap()
    };
    let particles: Vec<_> = atoms.as_array().unwrap().iter().map(one).collect();
    mass_properties_of_particles(&particles).unwrap()
}

fn of_moments(moments: [f64; 3]) -> RotationalConstants {
    let inertia = InertiaTensor::<Body>::diagonal(moments).unwrap();
    RotationalConstants::of(&MassProperties::new(2.3, Position::ZERO, inertia).unwrap()).unwrap()
}

#[test]
fn gaussian_prints_the_same_constants_and_its_molecules_are_these_tops() {
    for case in cases(&table("molecules"), "gaussian") {
        let found = RotationalConstants::of(&body(&case["atoms"], 1e-10)).unwrap();
        let found_ghz: Vec<f64> = found.gigahertz().into_iter().flatten().collect();
        let printed = case["rotational_constants_ghz"].as_array().unwrap();
        // the one constant of a linear molecule is printed once
        let skipped = found_ghz.len() - printed.len();
        assert_eq!(skipped, usize::from(found.top() == Top::Linear));
        for (got, want) in found_ghz[skipped..].iter().zip(printed) {
            // rounding of the geometry to 1e-6 Å, and Gaussian's older constants: 8e-7 at most
            assert!((got / number(want) - 1.0).abs() < 1.5e-6, "{:?}", case["name"]);
        }
        assert_eq!(found.top().name(), case["top"].as_str().unwrap(), "{:?}", case["name"]);
    }
}

#[test]
fn crawford_prints_the_same_moments_and_constants() {
    const BOHR: f64 = 0.529_177_210_903e-10;
    for case in cases(&table("molecules"), "crawford") {
        let body = body(&case["atoms_bohr"], BOHR);
        for (got, want) in
            body.center_of_mass().to_array().iter().zip(numbers::<3>(&case["center_of_mass_bohr"]))
        {
            // printed to 1e-8; the masses are older
            assert!((got / BOHR - want).abs() < 3e-8);
        }
        let found = RotationalConstants::of(&body).unwrap();
        for (got, want) in
            found.moments_in_unified_units().iter().zip(numbers::<3>(&case["moments_u_angstrom2"]))
        {
            assert!((got / want - 1.0).abs() < 2e-7);
        }
        for (got, want) in found.hertz().iter().zip(numbers::<3>(&case["rotational_constants_mhz"])) {
            assert!((got.unwrap() * 1e-6 / want - 1.0).abs() < 2e-7);
        }
        assert_eq!(found.top().name(), case["top"].as_str().unwrap());
    }
}

#[test]
fn a_wavenumber_is_the_frequency_over_c() {
    let found = of_moments([1.3e-46, 2.1e-46, 2.9e-46]);
    for (ghz, cm1) in found.gigahertz().iter().zip(found.per_centimetre()) {
        // 1 cm⁻¹ = 29.9792458 GHz
        assert!((ghz.unwrap() / cm1.unwrap() / 29.979_245_8 - 1.0).abs() < 4e-16);
    }
    // h/(8π²) = 505 379.0 MHz u Å² (in the units of spectroscopy), moments in u Å²
    let [i1, _, _] = found.moments_in_unified_units();
    assert!((found.hertz()[0].unwrap() * 1e-6 * i1 / 505_379.0 - 1.0).abs() < 1e-7);
}

#[test]
fn kappa_is_that_of_exact_arithmetic() {
    // exact fractions of the doubles
    let exact = [
        ([1.3e-46, 2.1e-46, 2.9e-46], -0.380_952_380_952_380_7),
        ([2.7, 3.1, 3.100_6], -0.997_391_010_258_805_6),
        ([2.5, 2.501, 3.9], 0.997_772_319_643_571_4),
    ];
    for (moments, kappa) in exact {
        let found = of_moments(moments).ray_kappa().unwrap();
        assert!((found - kappa).abs() < 3e-16, "{moments:?}: {found:?}");
    }
}

#[test]
fn kappa_has_its_limits() {
    assert_eq!(of_moments([1.3, 2.1, 2.1]).ray_kappa(), Some(-1.0));
    assert_eq!(of_moments([1.3, 1.3, 2.1]).ray_kappa(), Some(1.0));
    assert_eq!(of_moments([1.3; 3]).ray_kappa(), None);
    assert_eq!(of_moments([0.0, 2.1, 2.1]).ray_kappa(), Some(-1.0));
    // where it is zero, B is the mean of A and C
    let [a, c] = [7.0, 3.0];
    let found = of_moments([1.0 / a, 2.0 / (a + c), 1.0 / c]);
    assert!(found.ray_kappa().unwrap().abs() < 1e-15);
}

#[test]
fn a_point_has_no_constants_and_a_turned_line_has_no_a() {
    let atom = [Particle::<Body>::new(4.0 * U, Position::new(1e-10, -2e-10, 3e-10)).unwrap()];
    assert_eq!(RotationalConstants::of(&mass_properties_of_particles(&atom).unwrap()), None);
    // CO2 along a generic direction, its positions rounded to 1e-3 Å
    let rounded = |c: f64| (c * 1e3).round() * 1e-13;
    let at = |s: f64| Position::<Body>::new(rounded(0.36 * s), rounded(-0.48 * s), rounded(0.8 * s));
    let particles = [(15.995, -1.162), (12.0, 0.0), (15.995, 1.162)]
        .map(|(m, s)| Particle::new(m * U, at(s) + Position::new(3e-10, 1e-10, -2e-10)).unwrap());
    let body = mass_properties_of_particles(&particles).unwrap();
    let coarse = RotationalConstants::with_tolerance(&body, 2e-3).unwrap().unwrap();
    assert_eq!((coarse.top(), coarse.hertz()[0]), (Top::Linear, None));
    assert!(coarse.hertz()[1].is_some_and(|b| (b * 1e-9 / 11.7 - 1.0).abs() < 5e-3));
}

#[test]
fn a_plane_has_no_inertial_defect_and_a_tolerance_has_its_range() {
    let flat = of_moments([1.3e-46, 2.1e-46, 3.4e-46]);
    assert!(flat.inertial_defect().abs() < 1e-15 * flat.moments_in_unified_units()[2]);
    assert!((of_moments([1.3 * U, 2.1 * U, 2.9 * U]).inertial_defect() / -0.5e20 - 1.0).abs() < 2e-15);
    let inertia = InertiaTensor::<Body>::diagonal([1.3, 2.1, 2.9]).unwrap();
    let body = MassProperties::new(2.3, Position::ZERO, inertia).unwrap();
    for (tolerance, top) in [(0.0, Top::Asymmetric), (1.0, Top::Linear), (0.3, Top::Prolate)] {
        let found = RotationalConstants::with_tolerance(&body, tolerance).unwrap().unwrap();
        assert_eq!((found.top(), found.tolerance()), (top, tolerance));
    }
    for tolerance in [f64::NAN, -1.0, f64::INFINITY, 1.1] {
        let error = RotationalConstants::with_tolerance(&body, tolerance).unwrap_err();
        assert!(error.to_string().ends_with("must be from 0 to 1"), "{error}");
    }
}
