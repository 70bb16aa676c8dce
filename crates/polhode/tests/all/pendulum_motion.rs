//! The exact motion of a pendulum, compared with references of 32 digits.

use crate::common::{cases, number, table};
use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{Acceleration, Direction, Position};
use polhode::motion::{Pendulum, PendulumMotion, Rotor, Swing};

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
fn far_away_it_is_where_it_should_be_or_nowhere() {
    // ω₀, θ, θ̇, t: sin ½θ, cos ½θ and θ̇ then, by `swing` of fixtures/heavy_tops.py in 90 digits
    for (given, want, law) in [
        ([2.7, 0.9, -1.3, 1e18], [0.0990004628913922, 0.9950873872918349, -2.6308034571249697], 1e-12),
        ([2.7, 0.9, -1.3, 3e22], [0.055663994492099064, 0.9984495579232752, 2.667690944912245], 2e-8),
        ([1.9, 0.7, 5.1, 1e18], [0.3833270411874416, -0.9236126782880806, 5.058263663324234], 1e-12),
        ([1.9, 0.7, 5.1, 3e22], [0.707922044409489, 0.7062905769151175, 4.524508937015203], 2e-8),
        ([1.7, 0.3, 3.3619224, 1e16], [0.9998101533726266, 0.019484794404996723, 0.0711769194198237], 1e-9),
    ] {
        let [w0, angle, rate, time] = given;
        let motion = PendulumMotion::of(w0, angle, rate).unwrap();
        assert!(motion.reach() > time, "{given:?}: {:e}", motion.reach());
        let (theta, speed) = motion.at(time);
        assert!((speed - want[2]).abs() < law, "{given:?}: {speed}");
        // an angle that contains more turns than digits does not determine the position
        if theta.abs() < 4.0 {
            let (sine, cosine) = (0.5 * theta).sin_cos();
            assert!((sine * want[1] - cosine * want[0]).abs() < law, "{given:?}: {theta}");
        }
        for far in [1e40, -1e300, f64::INFINITY, f64::NAN] {
            assert!(motion.at(far).0.is_nan() && motion.at(far).1.is_nan());
        }
    }
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
        // 7 periods, rounded, have an error of 10⁻¹⁵ s
        assert!((later - angle - turn).abs() < 2e-14 && (speed - rate).abs() < 2e-14);
    }
}

#[test]
fn what_stands_still_stays_and_what_is_no_number_is_refused() {
    for angle in [0.0, std::f64::consts::PI] {
        assert_eq!(PendulumMotion::of(2.0, angle, 0.0).unwrap().at(55.0), (angle, 0.0));
        assert_eq!(PendulumMotion::of(2.0, angle, 0.0).unwrap().at(1e300), (angle, 0.0));
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
