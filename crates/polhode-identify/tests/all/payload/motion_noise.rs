//! Noise in the measured motion.

use polhode_identify::payload::{MotionNoise, PayloadLog, WrenchNoise, identify_payload};
use polhode_identify::{IdentifyError, ResidualTest};

use super::statistics::Statistics;
use super::wrist::{Carried, Course, noisy, rows, shaken};
use super::{FORCE, SENSE, TORQUE, found, log};
use crate::draws::{draws, is_about_one, tolerance};

const SHAKEN: [f64; 3] = [0.05, 2.0, 0.1];
const NOISE: MotionNoise = MotionNoise { omega: 0.05, alpha: 2.0, acceleration: 0.1 };

/// Undeclared noise biases the parameters and increases the residuals; declared noise does neither.
#[test]
fn noise_of_the_motion_does_not_draw_numbers_aside() {
    let carried = Carried::generic();
    let exact = rows(&carried, Course::Generic(1.0), 400, SENSE);
    let truth = carried.about_center();
    let (mut plain, mut said) = (Statistics::new(10), Statistics::new(10));
    for seed in 0..draws(300) {
        let measured = shaken(&noisy(&exact, FORCE, TORQUE, seed), SHAKEN, seed);
        let found_plain = found(&log(measured.clone()));
        assert!(found_plain.tests.iter().all(ResidualTest::is_too_large));
        plain.add(&found_plain.about_center, &truth);
        let found = found(&log(measured).with_motion_noise(NOISE).unwrap());
        assert!(found.tests.iter().all(|test| test.widening() == 1.0), "{:?}", found.tests);
        said.add(&found.about_center, &truth);
    }
    println!("motion noise: not said {plain}, said {said}");
    assert!(plain.bias() > 1.0, "{}", plain.bias());
    assert!(said.bias() < tolerance(0.15) && is_about_one(said.normalised(), 0.1), "{said}");
}

/// Rotation about z, with noise about x and y: parameters that only this noise would determine are
/// unobservable.
#[test]
fn what_only_noise_moves_is_unknown() {
    let carried = Carried::generic();
    let exact = rows(&carried, Course::OneAxis, 400, SENSE);
    for seed in 0..20 {
        let measured = shaken(&noisy(&exact, FORCE, TORQUE, seed), [0.01, 0.1, 0.02], seed);
        let noise = MotionNoise { omega: 0.01, alpha: 0.1, acceleration: 0.02 };
        let found = found(&log(measured).with_motion_noise(noise).unwrap());
        for name in ["Ixx about the origin", "Iyy about the origin", "Ixy about the origin"] {
            assert!(found.about_origin.get(name).unwrap().sd.is_none(), "{name}: {found:?}");
        }
        let zz = found.about_origin.get("Izz about the origin").unwrap();
        assert!((zz.value - carried.about_origin()[6]).abs() < 5.0 * zz.sd.unwrap(), "{zz:?}");
        assert!(found.body.is_none());
    }
}

/// If much of the information is noise, errors are larger than the rows alone suggest, and still
/// correct.
#[test]
fn errors_hold_where_the_motion_is_hardly_larger_than_its_noise() {
    let carried = Carried::generic();
    let truth = carried.about_center();
    let exact = rows(&carried, Course::Generic(0.3), 400, SENSE);
    let noise = MotionNoise { omega: 0.03, alpha: 0.6, acceleration: 0.05 };
    let mut said = Statistics::new(10);
    let mut all = 0;
    for seed in 0..draws(200) {
        let measured = shaken(&noisy(&exact, FORCE, 0.3 * TORQUE, seed), [0.03, 0.6, 0.05], seed);
        let log = PayloadLog::new(measured, SENSE)
            .unwrap()
            .with_noise(WrenchNoise::Deviations { force: FORCE, torque: 0.3 * TORQUE })
            .unwrap();
        let found = found(&log.with_motion_noise(noise).unwrap());
        all += i32::from(found.unconstrained.is_possible);
        said.add(&found.about_center, &truth);
    }
    let ratio = said.of_draws(&said.mean_said());
    // A mean of 200 draws has a standard error of 0.07 deviations, and ten parameters are compared.
    println!("much motion noise: {said} {ratio:?}, possible {all}");
    assert!(said.bias() < tolerance(0.17) && is_about_one(said.normalised(), 0.1), "{said}");
}

/// Logs of little more than noise give a valid estimate with fewer determined parameters. Few are
/// refused, those with a completely hidden motion.
#[test]
fn logs_that_are_mostly_noise_have_an_answer() {
    let (mut refused, mut all) = (0, 0);
    for carried in [Carried::generic(), Carried::plate(), Carried::rod()] {
        let truth = carried.about_center()[0];
        for rate in [0.1, 0.3, 1.0] {
            let exact = rows(&carried, Course::Generic(rate), 300, SENSE);
            for shaking in [[0.03, 0.6, 0.05], [0.1, 2.0, 0.2], [0.3, 6.0, 0.5], [0.05, 6.0, 0.05]] {
                let [omega, alpha, acceleration] = shaking;
                for seed in 0..6 {
                    let measured = shaken(&noisy(&exact, FORCE, TORQUE, seed), shaking, seed);
                    let noise = MotionNoise { omega, alpha, acceleration };
                    all += 1;
                    match identify_payload(&log(measured).with_motion_noise(noise).unwrap()) {
                        Ok(found) => {
                            let mass = &found.about_center.numbers[0];
                            let is_right = mass.sd.is_none_or(|sd| (mass.value - truth).abs() < 5.0 * sd);
                            assert!(is_right, "{rate} {shaking:?} {seed}: {mass:?}, {truth}");
                        }
                        Err(IdentifyError::NoConvergence { .. }) => refused += 1,
                        Err(error) => panic!("{rate} {shaking:?} {seed}: {error}"),
                    }
                }
            }
        }
    }
    println!("{refused} of {all} refused");
    assert!(refused <= 4, "{refused} of {all}");
}
