//! Tests of payloads.

mod edges;
mod input;
mod mistakes;
mod motion_noise;
mod next;
mod scale;
mod statistics;
mod unknown;
mod wrist;

use polhode_identify::payload::{
    Payload, PayloadLog, PayloadRow, WrenchNoise, WrenchSense, identify_payload,
};

use crate::draws::{draws, is_about_one, tolerance};
use crate::residuals::Excess;
use statistics::{Statistics, bound};
use wrist::{Carried, Course, noisy, rows};

const SENSE: WrenchSense = WrenchSense::OnPayload;
const FORCE: f64 = 0.1;
const TORQUE: f64 = 0.01;
const KNOWN: WrenchNoise = WrenchNoise::Deviations { force: FORCE, torque: TORQUE };

fn log(rows: Vec<PayloadRow>) -> PayloadLog {
    PayloadLog::new(rows, SENSE).unwrap().with_noise(KNOWN).unwrap()
}

fn found(log: &PayloadLog) -> Payload {
    identify_payload(log).unwrap()
}

/// Checks numbers with a tolerance relative to the largest number of the same unit.
fn close(found: &Payload, truth: &[f64; 10], tolerance: f64) {
    let size = |k: usize| match k {
        0 => truth[0],
        1..=3 => truth[1..4].iter().fold(0.0, |a: f64, b| a.max(b.abs())),
        _ => truth[4..].iter().fold(0.0, |a: f64, b| a.max(b.abs())),
    };
    for (k, (number, truth)) in found.about_center.numbers.iter().zip(truth).enumerate() {
        let off = (number.value - truth).abs();
        assert!(off <= tolerance * size(k), "{}: {} {truth}", number.name, number.value);
    }
}

#[test]
fn without_noise_the_truth_comes_back() {
    let carried = Carried::generic();
    let truth = carried.about_center();
    for sense in [WrenchSense::OnPayload, WrenchSense::OnSensor] {
        let exact = rows(&carried, Course::Generic(1.0), 60, sense);
        for noise in [KNOWN, WrenchNoise::Unknown] {
            let log = PayloadLog::new(exact.clone(), sense).unwrap().with_bias().with_noise(noise).unwrap();
            let found = found(&log);
            close(&found, &truth, 1e-12);
            assert!(found.edge.is_none() && found.unconstrained.is_possible && found.findings.is_empty());
            let body = found.body.unwrap();
            assert!((body.mass() - truth[0]).abs() < 1e-12);
            assert!((body.inertia().matrix()[0][1] - truth[7]).abs() < 1e-13);
            assert!((body.center_of_mass().y - truth[2]).abs() < 1e-13);
        }
    }
}

#[test]
fn numbers_about_the_origin_are_those_about_the_centre() {
    let carried = Carried::generic();
    let exact = rows(&carried, Course::Generic(1.0), 80, SENSE);
    let found = found(&log(exact));
    for (number, truth) in found.about_origin.numbers.iter().zip(carried.about_origin()) {
        assert!((number.value - truth).abs() < 1e-12, "{number:?} {truth}");
    }
}

/// The standard error with 600 draws is 0.04 deviations for a mean and 3 % for a deviation.
#[test]
fn errors_are_what_they_are_said_to_be() {
    let carried = Carried::generic();
    let exact = rows(&carried, Course::Generic(1.0), 150, SENSE);
    let center = carried.about_center();
    let limit = bound(&exact, FORCE, TORQUE, true, &center);
    let bias = [0.7, -1.2, 0.4, 0.05, -0.03, 0.08];
    let truth: Vec<f64> = center.into_iter().chain(bias).collect();
    for noise in [KNOWN, WrenchNoise::Unknown] {
        let mut statistics = Statistics::new(16);
        for seed in 0..draws(600) {
            let mut measured = noisy(&exact, FORCE, TORQUE, seed);
            for row in &mut measured {
                row.force += polhode::math::Force::new(bias[0], bias[1], bias[2]);
                row.torque += polhode::math::Torque::new(bias[3], bias[4], bias[5]);
            }
            let log = PayloadLog::new(measured, SENSE).unwrap().with_bias().with_noise(noise).unwrap();
            let found = found(&log);
            assert!(found.body.is_some());
            statistics.add(&found.about_center, &truth);
        }
        println!(
            "generic {noise:?}: {statistics}, {:?} {:?}",
            statistics.of_draws(&limit),
            statistics.of_said(&limit)
        );
        statistics.hold(&limit);
    }
}

/// Noise estimated from few rows is uncertain. This alone does not indicate a wrong model.
#[test]
fn short_logs_are_found_to_be_what_they_are() {
    let carried = Carried::generic();
    for (count, course) in
        [(30, Course::Generic(1.0)), (60, Course::Generic(1.0)), (60, Course::Generic(4.0))]
    {
        let exact = rows(&carried, course, count, SENSE);
        let mut statistics = Statistics::new(10);
        let mut excess = [Excess::default(), Excess::default()];
        for seed in 0..draws(300) {
            let measured = noisy(&exact, 0.1 * FORCE, 0.1 * TORQUE, 500 + seed);
            let log = PayloadLog::new(measured, SENSE).unwrap().with_noise(WrenchNoise::Unknown).unwrap();
            let found = found(&log);
            excess.iter_mut().zip(&found.tests).for_each(|(excess, test)| excess.add(test));
            statistics.add(&found.about_center, &carried.about_center());
        }
        println!("{count} rows: {statistics}");
        assert!(is_about_one(statistics.normalised(), 0.1), "{statistics}");
        excess.iter().for_each(Excess::hold);
    }
}

#[test]
fn a_covariance_of_the_channels_counts() {
    let carried = Carried::generic();
    let exact = rows(&carried, Course::Generic(1.0), 100, SENSE);
    let truth = carried.about_center();
    // Torque noise correlated with the forces, as in a beam sensor.
    let mix = |row: &PayloadRow, plain: &PayloadRow| {
        let (df, dt) = (row.force - plain.force, row.torque - plain.torque);
        let mut mixed = *row;
        mixed.torque = plain.torque + dt + polhode::math::Torque::new(0.09 * df.y, -0.07 * df.x, 0.05 * df.z);
        mixed
    };
    let mut c = [[0.0; 6]; 6];
    let (f, t) = (FORCE * FORCE, TORQUE * TORQUE);
    for (k, (on, by)) in [(1, 0.09), (0, -0.07), (2, 0.05)].into_iter().enumerate() {
        c[k][k] = f;
        c[3 + k][3 + k] = t + by * by * f;
        c[3 + k][on] = by * f;
        c[on][3 + k] = by * f;
    }
    let mut statistics = Statistics::new(10);
    for seed in 0..draws(400) {
        let measured: Vec<_> = noisy(&exact, FORCE, TORQUE, seed)
            .iter()
            .zip(&exact)
            .map(|(row, plain)| mix(row, plain))
            .collect();
        let log = PayloadLog::new(measured, SENSE).unwrap().with_noise(WrenchNoise::Covariance(c)).unwrap();
        let found = found(&log);
        assert!(found.tests.iter().all(|test| test.widening() == 1.0), "{:?}", found.tests);
        statistics.add(&found.about_center, &truth);
    }
    println!("covariance: {statistics}");
    assert!(is_about_one(statistics.normalised(), 0.07) && statistics.bias() < tolerance(0.15));
}
