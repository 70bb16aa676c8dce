//! Lagrange's top in closed form: references of 32 digits, the integrators, and what a top can do.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod common;

use common::{cases, number, numbers, table};
use polhode::*;
use std::f64::consts::PI;

const DOWN: UniformGravity = UniformGravity { acceleration: Acceleration::new(0.0, 0.0, -9.81) };

/// A = 0.5234375, C = 0.21875 kg·m², M g l = 5.518125 N·m.
fn top() -> Rotor {
    let inertia = InertiaTensor::diagonal([0.3125, 0.3125, 0.21875]).unwrap();
    Rotor::pivoted(
        &MassProperties::new(1.5, Position::new(0.0, 0.0, 0.375), inertia).unwrap(),
        Position::ZERO,
    )
}

fn leaning(angle: f64, omega: [f64; 3]) -> State {
    let attitude = Attitude::from_euler313([0.4, angle, -0.7]).unwrap();
    State { time: 0.0, attitude, omega: AngularVelocity::from_array(omega) }
}

#[test]
fn thousand_nutations_have_the_digits_of_the_reference() {
    let table = table("heavy_tops");
    let mut worst = [0.0_f64; 2];
    let mut seen = 0;
    for case in cases(&table, "case") {
        let name = case["name"].as_str().unwrap();
        let inertia = case["inertia"].as_array().unwrap();
        let inertia = [0, 1, 2].map(|k| numbers::<3>(&inertia[k]));
        let arm = Position::from_array(numbers(&case["arm"]));
        let inertia = InertiaTensor::from_matrix(inertia).unwrap();
        let rotor =
            Rotor::pivoted(&MassProperties::new(number(&case["mass"]), arm, inertia).unwrap(), Position::ZERO);
        let gravity = UniformGravity { acceleration: Acceleration::from_array(numbers(&case["gravity"])) };
        let attitude = Attitude::from_quaternion(numbers(&case["quaternion"])).unwrap();
        assert_eq!(attitude.quaternion(), numbers::<4>(&case["attitude0"]));
        let omega = AngularVelocity::from_array(numbers(&case["omega0"]));
        let motion = HeavyTop::of(&rotor, &gravity, State { time: 0.0, attitude, omega }).unwrap();
        for row in cases(case, "row") {
            let state = motion.at(number(&row["t"]));
            let want = Attitude::from_quaternion(numbers(&row["attitude"])).unwrap();
            let rates = AngularVelocity::from_array(numbers(&row["omega"]));
            let error =
                [state.attitude.angle_to(want), (state.omega - rates).norm() / rates.norm().max(omega.norm())];
            println!("{name} {:?}: {:.1e} {:.1e}", row["nutations"], error[0], error[1]);
            assert!(error[0] < 1e-15 && error[1] < 1e-15, "{name} {:?}: {error:?}", row["nutations"]);
            worst = [worst[0].max(error[0]), worst[1].max(error[1])];
            seen += 1;
        }
        let near = |what: &str, got: f64, want: f64| {
            assert!((got / want - 1.0).abs() < 1e-15, "{name}, {what}: {got} {want}");
        };
        near("period", motion.nutation_period().unwrap(), number(&case["nutation_period"]));
        near("1 - m", motion.parameter().unwrap()[1], number(&case["one_minus_m"]));
        if let (Some(precession), Some(spin)) = (case.get("precession"), case.get("spin")) {
            let scale = omega.norm();
            let got = [motion.mean_precession().unwrap(), motion.mean_spin().unwrap()];
            for (got, want) in got.iter().zip([number(precession), number(spin)]) {
                assert!((got - want).abs() < 1e-15 * scale, "{name}: {got} {want}");
            }
        }
        let [lowest, highest] = numbers::<2>(&case["cosines"]);
        let bounds = motion.nutation_bounds().map(f64::cos);
        assert!((bounds[0] - highest).abs() < 2e-16 && (bounds[1] - lowest).abs() < 2e-16, "{name}");
    }
    println!("{seen} rows; worst {worst:?}");
    assert!(seen > 130);
}

