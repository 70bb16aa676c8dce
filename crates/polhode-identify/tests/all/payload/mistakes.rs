//! Logs with a mistake.

use polhode::math::{Acceleration, AngularAcceleration, AngularVelocity, Body, Force, Torque, Vector};
use polhode_identify::payload::{
    Mistake, Payload, PayloadFinding, PayloadLog, PayloadRow, WrenchNoise, WrenchSense,
};

use super::wrist::{Carried, Course, noisy, rows};
use super::{FORCE, KNOWN, SENSE, TORQUE, close, found, log};

fn measured() -> Vec<PayloadRow> {
    noisy(&rows(&Carried::generic(), Course::Generic(1.0), 200, SENSE), FORCE, TORQUE, 11)
}

#[test]
fn the_wrong_side_has_a_negative_mass() {
    let log = PayloadLog::new(measured(), WrenchSense::OnSensor).unwrap().with_noise(KNOWN).unwrap();
    let found = found(&log);
    let mass = found.findings.iter().find_map(|finding| match finding {
        PayloadFinding::NegativeMass { mass, .. } => Some(*mass),
        _ => None,
    });
    assert!((mass.unwrap() + Carried::generic().about_center()[0]).abs() < 0.05);
    assert!(!found.unconstrained.is_possible && found.unconstrained.least_second_moment.is_none());
    assert!(found.tests[0].is_too_large());
    assert!(found.findings[0].to_string().contains("the wrench has the opposite sign"));
}

fn likely(found: &Payload) -> Option<Mistake> {
    found.findings.iter().find_map(|finding| match finding {
        PayloadFinding::Likely { mistake, .. } => Some(*mistake),
        _ => None,
    })
}

#[test]
fn wrong_units_and_signs_are_found() {
    const DEGREES: f64 = 180.0 / std::f64::consts::PI;
    let scaled = |a: [f64; 3], by: f64| a.map(|a| a * by);
    let omega = |row: &mut PayloadRow, by| {
        row.omega = AngularVelocity::from_array(scaled(row.omega.to_array(), by));
    };
    let alpha = |row: &mut PayloadRow, by| {
        row.alpha = AngularAcceleration::from_array(scaled(row.alpha.to_array(), by));
    };
    let make = |mistake: Mistake, row: &mut PayloadRow| match mistake {
        Mistake::AccelerationInG => row.acceleration = row.acceleration / 9.806_65,
        Mistake::AccelerationHasGravity => row.acceleration -= row.gravity,
        Mistake::GravityReversed => row.gravity = -row.gravity,
        Mistake::OmegaInDegrees => omega(row, DEGREES),
        Mistake::AlphaInDegrees => alpha(row, DEGREES),
        Mistake::AnglesInDegrees => {
            omega(row, DEGREES);
            alpha(row, DEGREES);
        }
        Mistake::AlphaReversed => alpha(row, -1.0),
        Mistake::TorqueInCentimetres => row.torque = row.torque * 100.0,
        Mistake::TorqueInMillimetres => row.torque = row.torque * 1000.0,
    };
    let all = [
        Mistake::AccelerationInG,
        Mistake::AccelerationHasGravity,
        Mistake::GravityReversed,
        Mistake::OmegaInDegrees,
        Mistake::AlphaInDegrees,
        Mistake::AnglesInDegrees,
        Mistake::AlphaReversed,
        Mistake::TorqueInCentimetres,
        Mistake::TorqueInMillimetres,
    ];
    for mistake in all {
        for noise in [KNOWN, WrenchNoise::Unknown] {
            let mut rows = measured();
            rows.iter_mut().for_each(|row| make(mistake, row));
            let found = found(&PayloadLog::new(rows, SENSE).unwrap().with_noise(noise).unwrap());
            assert_eq!(likely(&found), Some(mistake), "{noise:?}: {:?} {:?}", found.findings, found.tests);
        }
    }
    let right = found(&log(measured()));
    assert!(right.findings.is_empty(), "{:?}", right.findings);
}

/// Division of the torques by 1000 makes all residuals small. This alone must not suggest N·mm.
#[test]
fn what_is_wrong_otherwise_is_no_mistake_of_units() {
    let wrong: [fn(&mut PayloadRow); 5] = [
        |row| row.gravity = Acceleration::ZERO,
        |row| row.force = row.force / 9.806_65,
        |row| row.acceleration += row.alpha.cross(polhode::math::Position::new(0.05, -0.02, 0.1)),
        |row| row.torque = turned(row.torque),
        |row| (row.force, row.torque) = (turned(row.force), turned(row.torque)),
    ];
    for make in wrong {
        let mut rows = measured();
        rows.iter_mut().for_each(make);
        let found = found(&log(rows));
        assert!(found.tests.iter().all(polhode_identify::ResidualTest::is_too_large), "{:?}", found.tests);
        assert_eq!(likely(&found), None, "{:?}", found.findings);
    }
}

/// Permutes the components cyclically.
fn turned<Q>(v: Vector<Q, Body>) -> Vector<Q, Body> {
    Vector::new(v.y, v.z, v.x)
}

#[test]
fn odd_gravity_is_said() {
    let mut rows = measured();
    rows.iter_mut().for_each(|row| row.gravity = row.gravity * 0.1);
    assert!(
        matches!(found(&log(rows)).findings[0], PayloadFinding::UnusualGravity { size } if (size - 0.981).abs() < 1e-9)
    );
    let mut rows = measured();
    rows[20].gravity = rows[20].gravity * 1.1;
    assert!(matches!(found(&log(rows)).findings[0], PayloadFinding::GravityVaries { .. }));
}

/// A wrong model does not give small errors. Example: cable friction that follows the rotation.
#[test]
fn what_is_not_in_the_model_widens_errors() {
    for noise in [KNOWN, WrenchNoise::Unknown] {
        let mut rows = measured();
        for row in &mut rows {
            let drag = 0.05 * row.omega.x;
            row.torque += Torque::new(drag, 0.0, 0.0);
        }
        let right = found(&PayloadLog::new(measured(), SENSE).unwrap().with_noise(noise).unwrap());
        let wrong = found(&PayloadLog::new(rows, SENSE).unwrap().with_noise(noise).unwrap());
        assert!(
            wrong.tests[1].is_too_large() && wrong.tests[1].is_correlated(),
            "{noise:?} {:?}",
            wrong.tests
        );
        assert!(!right.tests[1].is_too_large());
        let sd = |found: &Payload| found.about_center.get("Ixx").unwrap().sd.unwrap();
        assert!(sd(&wrong) > 2.0 * sd(&right));
    }
}

#[test]
fn a_gross_outlier_is_left_out() {
    for noise in [KNOWN, WrenchNoise::Unknown] {
        let mut rows = measured();
        let clean = found(&PayloadLog::new(rows.clone(), SENSE).unwrap().with_noise(noise).unwrap());
        assert!(clean.left_out.is_empty());
        rows[17].force += Force::new(400.0, -90.0, 30.0);
        rows[101].torque += Torque::new(-0.3, 3.0, 0.4);
        let found = found(&PayloadLog::new(rows, SENSE).unwrap().with_noise(noise).unwrap());
        assert_eq!(found.left_out.iter().map(|left| left.row).collect::<Vec<_>>(), [17, 101]);
        assert!(found.left_out[0].size > 1000.0);
        assert!(!found.tests.iter().any(|test| test.is_too_large() || test.is_correlated()));
        for (with, without) in found.about_center.numbers.iter().zip(&clean.about_center.numbers) {
            assert!((with.value - without.value).abs() < without.sd.unwrap(), "{with:?} {without:?}");
        }
    }
}

#[test]
fn where_many_are_off_none_is_left_out() {
    let mut rows = measured();
    for row in rows.iter_mut().step_by(5) {
        row.force += Force::new(5.0, 2.0, -7.0);
    }
    let found = found(&log(rows));
    assert!(found.left_out.is_empty() && found.tests[0].is_too_large());
    assert!(
        found.findings.iter().any(|f| matches!(f, PayloadFinding::ManyOutliers { count } if *count == 40)),
        "{:?}",
        found.findings
    );
}

#[test]
fn a_vacuum_of_weight_is_no_mistake() {
    let mut rows = rows(&Carried::generic(), Course::Generic(1.0), 100, SENSE);
    for row in &mut rows {
        row.acceleration -= row.gravity;
        row.gravity = Acceleration::ZERO;
    }
    let found = found(&log(rows));
    assert!(found.findings.is_empty());
    close(&found, &Carried::generic().about_center(), 1e-11);
}
