//! Rejected input.

use polhode::math::{Force, Torque};
use polhode_identify::IdentifyError;
use polhode_identify::payload::{MotionNoise, PayloadLog, WrenchNoise, identify_payload};

use super::wrist::{Carried, Course, rows};
use super::{SENSE, log};

#[test]
fn what_cannot_be_used_is_refused() {
    let good = rows(&Carried::generic(), Course::Generic(1.0), 40, SENSE);

    let mut bad = good.clone();
    bad[3].torque = Torque::new(0.0, f64::NAN, 0.0);
    let error = PayloadLog::new(bad, SENSE).unwrap_err();
    assert_eq!(error.to_string(), "a torque is NaN, but must be finite");

    let mut bad = good.clone();
    bad[5].time = bad[4].time;
    let error = PayloadLog::new(bad, SENSE).unwrap_err();
    assert!(matches!(error, IdentifyError::Value { what: "a time", value, .. } if value == good[4].time));

    let mut bad = good.clone();
    bad[5].time = f64::NAN;
    assert!(matches!(PayloadLog::new(bad, SENSE), Err(IdentifyError::Value { what: "a time", .. })));

    let mut silent = good.clone();
    silent.iter_mut().for_each(|row| row.force = Force::new(0.0, 0.0, 0.0));
    let error = PayloadLog::new(silent, SENSE).unwrap_err();
    assert_eq!(error.to_string(), "every force in the log is zero");
    let mut silent = good.clone();
    silent.iter_mut().for_each(|row| row.torque = Torque::new(0.0, 0.0, 0.0));
    let error = PayloadLog::new(silent, SENSE).unwrap_err();
    assert_eq!(error, IdentifyError::AllZero { what: "torque" });

    let few = good[..2].to_vec();
    let error = identify_payload(&log(few)).unwrap_err();
    assert_eq!(error, IdentifyError::TooFew { what: "rows", given: 2, needed: 3 });
    let unknown = PayloadLog::new(good[..11].to_vec(), SENSE).unwrap();
    assert!(matches!(identify_payload(&unknown), Err(IdentifyError::TooFew { given: 11, needed: 12, .. })));
    assert!(matches!(identify_payload(&log(Vec::new())), Err(IdentifyError::TooFew { given: 0, .. })));
}

#[test]
fn noise_that_cannot_be_is_refused() {
    let plain = PayloadLog::new(rows(&Carried::generic(), Course::Generic(1.0), 40, SENSE), SENSE).unwrap();
    for (noise, what) in [
        (WrenchNoise::Deviations { force: 0.0, torque: 1.0 }, "the noise of a force is 0"),
        (WrenchNoise::Deviations { force: 1.0, torque: f64::NAN }, "the noise of a torque is NaN"),
        (WrenchNoise::Covariance([[1.0; 6]; 6]), "the smallest pivot of the wrench's covariance is 0"),
    ] {
        let error = plain.clone().with_noise(noise).unwrap_err().to_string();
        assert!(error.starts_with(what), "{error}");
    }
    let mut skew = [[0.0; 6]; 6];
    (0..6).for_each(|k| skew[k][k] = 1.0);
    skew[4][1] = 0.3;
    assert!(
        plain.clone().with_noise(WrenchNoise::Covariance(skew)).unwrap_err().to_string().contains("is 0.3")
    );
    let error = plain.with_motion_noise(MotionNoise { alpha: -1.0, ..MotionNoise::default() }).unwrap_err();
    assert_eq!(error.to_string(), "the noise of an angular acceleration is -1, but must be zero or positive");
}
