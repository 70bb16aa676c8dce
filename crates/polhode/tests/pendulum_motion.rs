//! The pendulum's exact motion, against references of 32 digits.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod common;

use common::{cases, number, table};
use polhode::{Acceleration, Direction, InertiaTensor, MassProperties, Position, Rotor};
use polhode::{Pendulum, PendulumMotion, Swing};

#[test]
fn every_kind_of_swing_has_the_digits_of_the_reference() {
    let table = table("pendulum_motion");
    let mut seen = 0;
    for case in cases(&table, "case") {
        let name = case["name"].as_str().unwrap();
        let [w0, angle, rate] = ["frequency", "angle", "rate"].map(|key| number(&case[key]));
        let motion = PendulumMotion::of(w0, angle, rate).unwrap();
        // 2 ω₀ k bounds the rate, and 2k a small angle
        let k = (0.5 * angle).sin().hypot(0.5 * rate / w0);
        for row in cases(case, "row") {
            let (got, speed) = motion.at(number(&row["t"]));
            let [want, want_speed] = ["angle", "rate"].map(|key| number(&row[key]));
            let errors =
                [(got - want).abs() / want.abs().max(k), (speed - want_speed).abs() / (2.0 * w0 * k)];
            println!("{name} {:?}: {:.1e} {:.1e}", row["t"], errors[0], errors[1]);
            assert!(errors.iter().all(|e| *e < 4.5e-16), "{name} {:?}: {errors:?}", row["t"]);
            seen += 1;
        }
    }
    assert!(seen > 60);
}

#[test]
fn a_rod_swings_with_the_period_that_its_kind_says() {
    let inertia = InertiaTensor::diagonal([0.0, 0.096, 0.096]).unwrap();
    let rod = MassProperties::new(0.8, Position::new(0.6, 0.0, 0.0), inertia).unwrap();
    let hung = Rotor::pivoted(&rod, Position::ZERO);
    let axis = Direction::new(0.0, 0.0, 1.0);
    let pendulum = Pendulum::hung(&hung, axis, Acceleration::new(9.81, 0.0, 0.0)).unwrap();
    for (angle, rate) in [(0.3, 1.1), (2.9, -0.2), (0.4, 9.1), (-1.7, -8.5)] {
        let motion = pendulum.motion(angle, rate).unwrap();
        let period = motion.period().unwrap();
        let (later, speed) = motion.at(7.0 * period);
        let turn = match pendulum.swing(angle, rate) {
            Swing::Oscillation { period: said, .. } => {
                assert!((said / period - 1.0).abs() < 1e-15);
                0.0
            }
            Swing::Revolution { period: said } => {
                assert!((said / period - 1.0).abs() < 1e-15);
                14.0 * std::f64::consts::PI * rate.signum()
            }
            other => panic!("{other:?}"),
        };
        // 7 periods, rounded, are off by 10⁻¹⁵ s
        assert!((later - angle - turn).abs() < 2e-14 && (speed - rate).abs() < 2e-14);
    }
}

#[test]
fn what_stands_still_stays_and_what_is_no_number_is_refused() {
    for angle in [0.0, std::f64::consts::PI] {
        assert_eq!(PendulumMotion::of(2.0, angle, 0.0).unwrap().at(55.0), (angle, 0.0));
    }
    for [w0, angle, rate] in [
        [0.0, 1.0, 1.0],
        [f64::NAN, 1.0, 1.0],
        [1.0, f64::INFINITY, 0.0],
        [1.0, 0.0, f64::NAN],
        [1.0, 0.0, 1e300],
    ] {
        assert!(PendulumMotion::of(w0, angle, rate).is_err());
    }
}
