//! Next motion: predicted uncertainty, compared with logs that contain the motion.

use polhode::math::{Acceleration, AngularAcceleration, AngularVelocity, Force, Torque};
use polhode_identify::payload::{NextMotion, PayloadRow, next_motion};

use super::wrist::{Carried, Course, noisy, rows};
use super::{FORCE, SENSE, TORQUE, found, log};

/// Returns rows of a motion, as many as before, after the given rows.
fn made(carried: &Carried, motion: NextMotion, before: &[PayloadRow]) -> Vec<PayloadRow> {
    let last = before.last().unwrap().time;
    let row = |k: usize| {
        let time = 0.013 * k as f64;
        let [omega, alpha, gravity] = motion.at(time, 9.81);
        let mut row = PayloadRow {
            time: last + 1.0 + time,
            omega: AngularVelocity::from_array(omega),
            alpha: AngularAcceleration::from_array(alpha),
            acceleration: Acceleration::ZERO,
            gravity: Acceleration::from_array(gravity),
            force: Force::ZERO,
            torque: Torque::ZERO,
        };
        (row.force, row.torque) = carried.wrench(&row);
        row
    };
    (0..before.len()).map(row).collect()
}

#[test]
fn the_motion_that_is_suggested_brings_what_is_said() {
    let carried = Carried::generic();
    for (course, unknown) in [(Course::OneAxis, true), (Course::Generic(0.4), false)] {
        let before = noisy(&rows(&carried, course, 900, SENSE), FORCE, TORQUE, 5);
        let first = log(before.clone());
        let next = next_motion(&first, &found(&first)).unwrap().unwrap();
        assert!(next.refused.is_empty() && next.candidates.len() == 42);
        assert_eq!(next.now.unknown > 0, unknown, "{:?}", next.now);
        let best = next.best().unwrap();
        let last = next.candidates.last().unwrap();
        let mut actual = Vec::new();
        for candidate in [best, &next.candidates[7], &next.candidates[20], last] {
            let more = noisy(&made(&carried, candidate.experiment, &before), FORCE, TORQUE, 6);
            let both = log(before.iter().chain(&more).copied().collect());
            let now = next_motion(&both, &found(&both)).unwrap().unwrap().now;
            assert_eq!(now.unknown, candidate.then.unknown);
            // Parameters are scaled by the estimated body, which another motion changes while it is
            // not fully determined.
            let size = |known: &polhode_identify::Knowledge| {
                if known.unknown > 0 { known.mean_sd } else { known.largest_sd }
            };
            let (sd, said) = (size(&now), size(&candidate.then));
            assert!((sd / said - 1.0).abs() < 0.1, "{:?}: {said} {sd}", candidate.experiment);
            actual.push((now.unknown, sd));
        }
        assert!(actual[0] < actual[1] && actual[0] < actual[2] && actual[0] < actual[3], "{actual:?}");
    }
}

/// A bias of the sensor and noise of the motion are taken into account.
#[test]
fn a_log_at_rest_is_to_be_turned() {
    let carried = Carried::generic();
    let before = noisy(&rows(&carried, Course::Poses, 300, SENSE), FORCE, TORQUE, 5);
    let first = log(before).with_bias();
    let next = next_motion(&first, &found(&first)).unwrap().unwrap();
    let best = next.best().unwrap();
    assert!(
        matches!(best.experiment, NextMotion::Turn { rate, .. } if (rate - std::f64::consts::PI).abs() < 1e-12),
        "{best:?}"
    );
    assert!(best.then.unknown < next.now.unknown);
    assert!(matches!(next.candidates.last().unwrap().experiment, NextMotion::Rest { .. }));
}
