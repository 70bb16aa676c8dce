//! Logs of wrong motions: a mistake is not interpreted as another meaning of the numbers.

use std::f64::consts::{PI, TAU};

use polhode::infer::judge::{JudgeError, Judgement, LogMistake, MotionLog, Reference, SignedAxes};
use polhode::prelude::*;

use super::judge_readings::{Draws, along, by_name, count, scenario};

/// Rotation angle of the exact motion between rows, rad.
const TURN: f64 = 0.05;

fn exact(scenario: &Scenario, times: &[f64]) -> Vec<State> {
    Reference::of(scenario, times).unwrap().states().to_vec()
}

fn even(scenario: &Scenario, first: u32, rows: u32) -> Vec<f64> {
    let start = scenario.start();
    (first..first + rows).map(|k| start.time + TURN / start.omega.norm() * f64::from(k)).collect()
}

fn log(times: Vec<f64>, states: &[State]) -> MotionLog {
    MotionLog::new(times, states.iter().map(|state| state.attitude.quaternion()).collect()).unwrap()
}

fn judged(scenario: &Scenario, log: &MotionLog) -> Result<Judgement, JudgeError> {
    Judgement::of(scenario, log, &by_name())
}

/// Without ω × I ω, at rest, or rotated in the opposite sense. Other axes may fit the beginning as
/// well: then the log is refused.
#[test]
fn a_wrong_law_is_never_called_right() {
    let (count, mut refused) = (count(30), 0);
    for seed in 0..count {
        let scenario = scenario(&mut Draws::of(seed, 7));
        let (start, times) = (scenario.start(), even(&scenario, 0, 200));
        let rate = [1.0, 0.0, -1.0][seed as usize % 3] * start.omega.norm();
        let axis = Direction::<Body>::from_array(start.omega.to_array());
        let turned = |time: &f64| {
            let turn = Rotation::<Body, Body>::from_axis_angle(axis, rate * (time - start.time)).unwrap();
            (start.attitude * turn).quaternion()
        };
        let log = MotionLog::new(times.clone(), times.iter().map(turned).collect()).unwrap();
        match judged(&scenario, &log) {
            Ok(judgement) => {
                let (off, found) = (judgement.largest_attitude_error(), judgement.readings.reading);
                assert!(off > 1e-3, "{seed}: {off} rad as {found}");
            }
            Err(JudgeError::Ambiguous { .. }) => refused += 1,
            Err(error) => panic!("{seed}: {error}"),
        }
    }
    assert!(100 * refused <= count, "{refused} of {count} refused");
}

/// A program that rotates too fast or too slowly, such as one that takes deg/s as rad/s, is not
/// explained by a unit of time.
///
/// A small factor is an error, a large one is refused.
#[test]
fn a_wrong_rate_is_no_unit_of_time() {
    let wrong = [180.0 / PI, PI / 180.0, TAU, 1.0 / TAU, 30.0 / PI, PI / 30.0, 100.0, 0.01, 970.0, 0.0173];
    let mut counts = [0, 0];
    for seed in 0..count(36) {
        let mut draws = Draws::of(seed, 11);
        let scenario = scenario(&mut draws);
        let start = scenario.start().time;
        let is_small = seed % 3 == 0;
        let factor = if is_small { draws.one_of(&[0.5, 0.9, 1.05, 2.0]) } else { draws.one_of(&wrong) };
        let times = even(&scenario, 0, draws.one_of(&[30, 80, 200]));
        let stated = times.iter().map(|time| start + (time - start) / factor).collect();
        let log = log(stated, &exact(&scenario, &times));
        counts[usize::from(is_small)] += 1;
        match judged(&scenario, &log) {
            Ok(judgement) if is_small => {
                let (off, found) = (judgement.largest_attitude_error(), judgement.readings.reading);
                assert!(off > 1e-3 && found.time_factor == 1.0, "{seed} × {factor}: {off} rad as {found}");
            }
            Err(JudgeError::OtherRate { ratio, .. }) if !is_small => {
                assert!((ratio / factor - 1.0).abs() < 0.3, "{seed} × {factor}: {ratio}");
            }
            Ok(judgement) => panic!("{seed} × {factor}: {}", judgement.readings.reading),
            Err(error) => panic!("{seed} × {factor}: {error}"),
        }
    }
    println!("{counts:?} of large and small factors");
}

/// Rows whose times are stated from the start on, or from one row after it, but whose states are
/// those of later times.
#[test]
fn rows_that_are_late_are_a_mistake() {
    for seed in 0..count(30) {
        let mut draws = Draws::of(seed, 13);
        let scenario = scenario(&mut draws);
        let late = draws.one_of(&[1, 2, 3, 5, 10, 30]);
        let first = if late <= 3 { draws.one_of(&[0, 1]) } else { 0 };
        let times = even(&scenario, first, 150);
        let states = exact(&scenario, &even(&scenario, first + late, 150));
        let log = log(times.clone(), &states);
        let log = log.with_omega(states.iter().map(|state| state.omega.to_array()).collect()).unwrap();
        let judgement =
            judged(&scenario, &log).unwrap_or_else(|error| panic!("{seed}, {late} rows: {error}"));
        let shift = states[0].time - times[0];
        let readings = &judgement.readings;
        let [LogMistake::LateRows { shift: found }] = readings.mistakes[..] else {
            panic!("{seed}, {late} rows from {first}: {:?} {}", readings.mistakes, readings.reading)
        };
        assert!((found - shift).abs() < 1e-6 * shift, "{seed}: {found} {shift}");
        assert_eq!((readings.reading.time_origin, readings.omega.unwrap().is_plain()), (0.0, true));
        let off = judgement.largest_attitude_error();
        assert!(off > 0.5 * TURN, "{seed}, {late} rows: {off} rad");
    }
}

/// If the delay is less than a part of the beginning, the stated times are used.
#[test]
fn rows_that_are_late_by_little_are_an_error() {
    for seed in 0..count(12) {
        let scenario = scenario(&mut Draws::of(seed, 17));
        let (start, rate) = (scenario.start().time, scenario.start().omega.norm());
        let times: Vec<f64> = (0..400).map(|k| start + 2e-3 / rate * f64::from(k)).collect();
        let late: Vec<f64> = times.iter().map(|time| time + 6e-3 / rate).collect();
        let judgement = judged(&scenario, &log(times, &exact(&scenario, &late))).unwrap();
        let off = judgement.largest_attitude_error();
        assert!(off > 4e-3 && judgement.readings.reading.time_origin == 0.0, "{seed}: {off}");
    }
}

/// ω with mirrored components, in body axes or in space axes, with body-to-space attitudes.
#[test]
fn a_mirrored_omega_is_a_mistake() {
    for seed in 0..count(30) {
        let mut draws = Draws::of(seed, 19);
        let scenario = scenario(&mut draws);
        let times = even(&scenario, 0, 100);
        let states = exact(&scenario, &times);
        let components = draws.one_of(&SignedAxes::ALL).reversed();
        let is_space = draws.one_of(&[true, false]);
        let omega = |state: &State| match is_space {
            true => along(components, state.omega_space().to_array()),
            false => along(components, state.omega.to_array()),
        };
        let log = log(times, &states).with_omega(states.iter().map(omega).collect()).unwrap();
        let judgement = judged(&scenario, &log).unwrap_or_else(|error| panic!("{seed}: {error}"));
        assert_eq!(judgement.readings.mistakes, [LogMistake::OmegaComponents { components }], "{seed}");
        assert!(judgement.readings.is_against_names && judgement.largest_attitude_error() < 1e-12);
        // max |ω_log − ω| / max |ω|
        let largest = |sizes: &mut dyn Iterator<Item = f64>| sizes.fold(0.0, f64::max);
        let in_log = |state: &State| match is_space {
            true => state.omega_space().to_array(),
            false => state.omega.to_array(),
        };
        let mut apart = states.iter().map(|state| distance(omega(state), in_log(state)));
        let exact = largest(&mut apart) / largest(&mut states.iter().map(|state| state.omega.norm()));
        let off = largest(&mut judgement.errors.rates.unwrap().omega.into_iter());
        assert!((off - exact).abs() < 1e-12 && exact > 0.01, "{seed}: {off}, not {exact}");
    }
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// The ω of space relative to the body, −ω, belongs to space-to-body attitudes.
#[test]
fn a_conjugate_motion_has_the_opposite_omega() {
    for seed in 0..count(12) {
        let scenario = scenario(&mut Draws::of(seed, 23));
        let times = even(&scenario, 0, 100);
        let states = exact(&scenario, &times);
        let conjugate: Vec<[f64; 4]> =
            states.iter().map(|state| state.attitude.inverse().quaternion()).collect();
        for sign in [1.0, -1.0] {
            let omega = states.iter().map(|state| (state.omega * sign).to_array()).collect();
            let log = MotionLog::new(times.clone(), conjugate.clone()).unwrap().with_omega(omega).unwrap();
            let judgement = judged(&scenario, &log).unwrap();
            assert_eq!(judgement.readings.mistakes, [], "{seed}");
            assert!(judgement.readings.is_against_names);
            let off = judgement.errors.rates.as_ref().unwrap().omega.iter().copied().fold(0.0, f64::max);
            assert!(off < 1e-12 && judgement.largest_attitude_error() < 1e-12, "{seed}: {off}");
        }
    }
}

/// −ω of a motion about one axis is a mirrored ω, or one along axes rotated by π: it is refused.
#[test]
fn a_sign_that_the_motion_does_not_tell_is_refused() {
    let body =
        MassProperties::new(2.3, Position::ZERO, InertiaTensor::diagonal([2.0, 3.0, 4.0]).unwrap()).unwrap();
    let attitude = Attitude::from_quaternion([0.6, -0.3, 0.5, 0.2]).unwrap();
    let start = State { time: 0.0, attitude, omega: AngularVelocity::new(0.0, 0.0, 1.5) };
    let spinning = Scenario::new(body).starting(start).unwrap();
    let times = even(&spinning, 0, 100);
    let states = exact(&spinning, &times);
    let log = |sign: f64| {
        let omega = states.iter().map(|state| (state.omega * sign).to_array()).collect();
        log(times.clone(), &states).with_omega(omega).unwrap()
    };
    let degrees = judged(&spinning, &log(180.0 / PI)).unwrap();
    assert!((degrees.readings.omega.unwrap().factor * 180.0 / PI - 1.0).abs() < 1e-12);
    let error = judged(&spinning, &log(-1.0)).unwrap_err();
    assert!(matches!(error, JudgeError::AmbiguousOmega { .. }), "{error}");
}

/// ω that is too large by 20 % fits one reading roughly, and is judged by it. Readings with larger
/// deviations are not considered.
#[test]
fn a_scaled_omega_is_an_error() {
    let scenario = scenario(&mut Draws::of(3, 29));
    let times = even(&scenario, 0, 200);
    let states = exact(&scenario, &times);
    let omega = states.iter().map(|state| (state.omega * 1.2).to_array()).collect();
    let judgement = judged(&scenario, &log(times, &states).with_omega(omega).unwrap()).unwrap();
    assert!(judgement.readings.omega.unwrap().is_plain());
    let off = judgement.errors.rates.unwrap().omega.into_iter().fold(0.0, f64::max);
    assert!((off - 0.2).abs() < 1e-3, "{off}");
}
