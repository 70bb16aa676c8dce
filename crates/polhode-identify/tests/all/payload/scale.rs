//! Payloads of all sizes, and unusual motions.

use polhode::math::{Acceleration, Force, Torque};
use polhode_identify::IdentifyError;
use polhode_identify::payload::{MotionNoise, PayloadLog, WrenchNoise, identify_payload};

use super::wrist::{Carried, Course, noisy, rows, shaken};
use super::{KNOWN, SENSE, found};

/// Mass, length and noise in proportion: the same draws give the same estimate in other units.
#[test]
fn units_do_not_matter() {
    let plain = Carried::rod();
    let base = noisy(&rows(&plain, Course::Generic(1.0), 80, SENSE), 0.1, 0.01, 4);
    let with = |m: f64, l: f64| {
        let measured = base
            .iter()
            .map(|row| {
                let mut row = *row;
                row.acceleration = row.acceleration * l;
                row.gravity = row.gravity * l;
                row.force = row.force * (m * l);
                row.torque = row.torque * (m * l * l);
                row
            })
            .collect();
        let noise = WrenchNoise::Deviations { force: 0.1 * m * l, torque: 0.01 * m * l * l };
        found(&PayloadLog::new(measured, SENSE).unwrap().with_bias().with_noise(noise).unwrap())
    };
    let one = with(1.0, 1.0);
    for (m, l) in [(1e-6, 1e-3), (1e6, 1e2), (3e-12, 2.0), (1e9, 1e-6)] {
        let other = with(m, l);
        assert!(other.body.is_some());
        let scales = [m, l, l, l, m * l * l];
        for (k, (a, b)) in
            one.about_center.numbers.iter().zip(&other.about_center.numbers).enumerate().take(10)
        {
            let scale = scales[k.min(4)];
            let (sd, other_sd) = (a.sd.unwrap(), b.sd.unwrap() / scale);
            assert!(
                (a.value - b.value / scale).abs() < 1e-3 * sd && (sd / other_sd - 1.0).abs() < 1e-6,
                "{m} {l} {a:?} {b:?}"
            );
        }
        assert_eq!(one.edge.as_ref().map(|e| e.kind), other.edge.as_ref().map(|e| e.kind));
    }
}

/// The mass has no effect in free fall; m c and the tensor about the origin are determined.
#[test]
fn in_free_fall_the_mass_is_unknown() {
    let carried = Carried::generic();
    let mut measured = rows(&carried, Course::Generic(1.0), 80, SENSE);
    let truth = carried.about_origin();
    for row in &mut measured {
        // Subtract the wrench of m (a − g) and c × m (a − g).
        let s = (row.acceleration - row.gravity).to_array();
        let h = [truth[1], truth[2], truth[3]];
        row.force += Force::from_array(s.map(|s| -truth[0] * s));
        let moment = [h[1] * s[2] - h[2] * s[1], h[2] * s[0] - h[0] * s[2], h[0] * s[1] - h[1] * s[0]];
        row.torque += Torque::from_array(moment.map(|t| -t));
        row.acceleration = Acceleration::ZERO;
        row.gravity = Acceleration::ZERO;
    }
    let found = found(&PayloadLog::new(measured, SENSE).unwrap().with_noise(KNOWN).unwrap());
    assert_eq!(found.about_origin.unknown.len(), 1);
    assert!(
        found.about_origin.numbers[0].sd.is_none()
            && found.about_center.get("center x").unwrap().sd.is_none()
    );
    for (number, truth) in found.about_origin.numbers.iter().zip(truth).skip(1) {
        assert!(number.sd.is_some() && (number.value - truth).abs() < 1e-6, "{number:?} {truth}");
    }
    assert!(found.body.is_none());
}

#[test]
fn nothing_carried_is_a_mass_within_its_error_of_zero() {
    let nothing = Carried(vec![(1e-12, [0.01, 0.02, 0.03])]);
    for seed in 0..20 {
        let measured = noisy(&rows(&nothing, Course::Generic(1.0), 100, SENSE), 0.1, 0.01, seed);
        let found = found(&PayloadLog::new(measured, SENSE).unwrap().with_noise(KNOWN).unwrap());
        let mass = &found.about_origin.numbers[0];
        assert!(mass.value > 0.0 && mass.value < 5.0 * mass.sd.unwrap(), "{mass:?}");
        assert!(found.findings.is_empty(), "{:?}", found.findings);
    }
}

#[test]
fn three_rows_are_enough_without_noise() {
    let carried = Carried::generic();
    let all = rows(&carried, Course::Generic(1.0), 60, SENSE);
    let three = vec![all[3], all[21], all[44]];
    let found = found(&PayloadLog::new(three, SENSE).unwrap().with_noise(KNOWN).unwrap());
    super::close(&found, &carried.about_center(), 1e-10);
}

/// Weak signals, large noise or the wrong sense: every estimate exists and is physically
/// consistent.
#[test]
fn there_is_an_answer_whatever_the_noise() {
    for (k, carried) in [Carried::generic(), Carried::plate(), Carried::rod()].iter().enumerate() {
        let exact = rows(carried, Course::Generic(0.5), 40, SENSE);
        for seed in 0..36 {
            let size = 10_f64.powi(seed as i32 % 12 - 4);
            let known = WrenchNoise::Deviations { force: size, torque: 0.1 * size };
            let measured = noisy(&exact, size, 0.1 * size, seed);
            for sense in [SENSE, SENSE.other()] {
                for noise in [WrenchNoise::Unknown, known] {
                    let log = PayloadLog::new(measured.clone(), sense).unwrap().with_noise(noise).unwrap();
                    for log in [log.clone(), log.with_bias()] {
                        let found = identify_payload(&log);
                        let is_known = found.as_ref().is_ok_and(|found| found.body.is_some());
                        assert!(is_known, "{k} {seed} {sense:?} {noise:?}: {:?}", found.err());
                    }
                }
            }
        }
    }
}

/// The same with noise of the motion, even if it hides the motion: the estimate is consistent, or
/// an error is returned.
#[test]
fn with_noise_of_the_motion_there_is_an_answer_or_none() {
    let exact = rows(&Carried::generic(), Course::Generic(0.5), 60, SENSE);
    let (mut answers, mut refused) = (0, 0);
    for seed in 0..36 {
        let size = 10_f64.powf(seed as f64 % 12.0 / 3.0 - 3.0);
        let moving = MotionNoise { omega: 0.1 * size, alpha: 2.0 * size, acceleration: size };
        let measured = shaken(
            &noisy(&exact, size, 0.1 * size, seed),
            [moving.omega, moving.alpha, moving.acceleration],
            seed,
        );
        let known = WrenchNoise::Deviations { force: size, torque: 0.1 * size };
        for sense in [SENSE, SENSE.other()] {
            for noise in [WrenchNoise::Unknown, known] {
                let log = PayloadLog::new(measured.clone(), sense).unwrap().with_noise(noise).unwrap();
                let log = log.with_motion_noise(moving).unwrap();
                for log in [log.clone(), log.with_bias()] {
                    match identify_payload(&log) {
                        Ok(found) => {
                            answers += 1;
                            assert!(found.about_origin.numbers[0].value > 0.0);
                        }
                        Err(IdentifyError::NoConvergence { .. } | IdentifyError::NotFinite { .. }) => {
                            println!("refused {size} {sense:?} {noise:?}");
                            refused += 1;
                        }
                        Err(error) => panic!("{seed} {sense:?} {noise:?}: {error:?}"),
                    }
                }
            }
        }
    }
    println!("with noise of the motion: {answers} answers, {refused} refused");
    assert!(answers > 9 * refused);
}
