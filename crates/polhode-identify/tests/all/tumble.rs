//! Tumbles of a known body.

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{AngularVelocity, Attitude, Body, Direction, Position, Rotation};
use polhode::motion::torque::{Drag, DragLaw, TorqueModel};
use polhode::motion::{FreeMotion, Rotor, State};
use polhode::motion::{Method, Motor, Trajectory, Wheel};
use polhode_identify::IdentifyError;
use polhode_identify::tumble::{
    AttitudeReading, Flight, FlightSearch, GyroErrors, GyroReading, Tumble, TumbleOptions, find_flights,
    identify_tumbles,
};

use crate::draws::{draws, is_about_one, tolerance};
use crate::noise::Normal;
use crate::residuals::Excess;

/// Generic tensor, kg·m²: three distinct moments, all products nonzero.
pub(crate) const TENSOR: [f64; 6] = [3.1e-3, 4.2e-3, 5.3e-3, 0.4e-3, -0.3e-3, 0.2e-3];
pub(crate) const BIAS: [f64; 3] = [0.013, -0.021, 0.008];

pub(crate) fn motion(tensor: [f64; 6], omega: [f64; 3]) -> FreeMotion {
    let [xx, yy, zz, xy, xz, yz] = tensor;
    let inertia = InertiaTensor::from_matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).unwrap();
    let body = MassProperties::new(0.37, Position::ZERO, inertia).unwrap();
    let attitude = Attitude::exp(Direction::new(0.3, -0.5, 0.2)).unwrap();
    let start = State { time: 0.2, attitude, omega: AngularVelocity::from_array(omega) };
    FreeMotion::of(&Rotor::free(&body), start).unwrap()
}

/// Returns readings at 100 Hz of a gyro with noise and bias.
pub(crate) fn gyro(motion: &FreeMotion, duration: f64, noise: &mut Normal, sd: f64) -> Vec<GyroReading> {
    (0..(100.0 * duration) as usize)
        .map(|k| {
            let time = 0.21 + 0.01 * k as f64;
            let omega = motion.at(time).omega.to_array();
            let error = [(); 3].map(|()| sd * noise.next());
            let read = core::array::from_fn(|i| omega[i] + BIAS[i] + error[i]);
            GyroReading { time, omega: AngularVelocity::from_array(read) }
        })
        .collect()
}

pub(crate) const STARTS: [[f64; 3]; 4] =
    [[6.0, 7.0, -4.0], [1.0, 9.0, 1.5], [-8.0, 2.0, 3.0], [2.0, -3.0, 9.0]];

pub(crate) fn flights(seed: u64, sd: f64) -> Vec<Flight> {
    let mut noise = Normal::new(seed);
    let one = |start| Flight::of_gyro("one", gyro(&motion(TENSOR, start), 1.2, &mut noise, sd)).unwrap();
    STARTS.map(one).to_vec()
}

pub(crate) fn ratios(tensor: [f64; 6]) -> [f64; 2] {
    let (m, _) = polhode::math::symmetric_eigen(tensor);
    [m[0] / m[2], m[1] / m[2]]
}

/// Returns the tensor divided by its greatest moment.
pub(crate) fn relative(tensor: [f64; 6]) -> [f64; 6] {
    let (m, _) = polhode::math::symmetric_eigen(tensor);
    tensor.map(|element| element / m[2])
}

#[test]
fn without_noise_the_body_is_found_again() {
    let options = TumbleOptions { gyro_noise: Some(1e-6), ..TumbleOptions::default() };
    let found = identify_tumbles(&flights(1, 0.0), &options).unwrap();
    for (number, truth) in found.estimate.numbers.iter().zip(relative(TENSOR).into_iter().chain(BIAS)) {
        assert!((number.value - truth).abs() < 1e-7, "{number:?} {truth}");
    }
    // Only ratios are determined: the tensor itself is the unobservable direction.
    assert!(!found.scale_is_known);
    assert_eq!(found.estimate.unknown.len(), 1, "{:?}", found.estimate.unknown);
    assert!(found.estimate.get("Ixx/I3").unwrap().sd.is_some_and(|sd| sd > 0.0));
    assert_eq!(found.principal.moment_sd, [None; 3]);
    assert!(found.estimate.get("gyro bias x").unwrap().sd.is_some());
    let unknown = &found.estimate.unknown[0];
    let size = relative(TENSOR).iter().map(|x| x * x).sum::<f64>().sqrt();
    for (part, truth) in unknown.iter().zip(relative(TENSOR)) {
        assert!((part.abs() - truth.abs() / size).abs() < 1e-6, "{unknown:?}");
    }
}

/// Returns the errors of the ratios of moments, and their stated standard deviations.
fn errors(found: &Tumble, truth: [f64; 2]) -> ([f64; 2], [f64; 2]) {
    let p = &found.principal;
    ([p.ratios[0] - truth[0], p.ratios[1] - truth[1]], p.ratio_sd.map(Option::unwrap))
}

/// Returns the normalized squared error, 1 on average for correct stated errors.
fn normalised_square(found: &Tumble, truth: [f64; 2]) -> f64 {
    let (errors, sds) = errors(found, truth);
    let [a, b] = [errors[0] / sds[0], errors[1] / sds[1]];
    let r = found.principal.ratio_correlation.unwrap();
    (a * a - 2.0 * r * a * b + b * b) / (1.0 - r * r) / 2.0
}

#[test]
fn errors_are_what_they_are_said_to_be() {
    let seeds = draws(250);
    let truth = ratios(TENSOR);
    let (mut sums, mut squares, mut said) = ([0.0; 2], [0.0; 2], [0.0; 2]);
    let mut normalised = 0.0;
    for seed in 0..seeds {
        let found: Tumble = identify_tumbles(&flights(100 + seed, 0.02), &TumbleOptions::default()).unwrap();
        let (errors, sds) = errors(&found, truth);
        for k in 0..2 {
            sums[k] += errors[k] / seeds as f64;
            squares[k] += errors[k] * errors[k] / seeds as f64;
            said[k] += sds[k] * sds[k] / seeds as f64;
        }
        normalised += normalised_square(&found, truth) / seeds as f64;
    }
    for k in 0..2 {
        let (sd, said) = (squares[k].sqrt(), said[k].sqrt());
        println!("bias {:.3} sd, sd {:.3} of the stated sd", sums[k] / said, sd / said);
        assert!((sums[k] / said).abs() < tolerance(0.15), "{}", sums[k] / said);
        assert!(is_about_one(sd / said, 0.1), "{}", sd / said);
    }
    println!("normalised square {normalised:.3}");
    assert!(is_about_one(normalised, 0.1), "{normalised}");
}

/// Noise estimated from few readings is uncertain. This alone does not indicate a wrong model.
#[test]
fn short_flights_are_found_to_be_what_they_are() {
    let seeds = draws(300);
    for (count, duration) in [(3, 1.2), (4, 0.5)] {
        let (mut excess, mut normalised) = (Excess::default(), 0.0);
        for seed in 0..seeds {
            let mut noise = Normal::new(9000 + seed);
            let flight = |start: &[f64; 3]| {
                Flight::of_gyro("short", gyro(&motion(TENSOR, *start), duration, &mut noise, 0.02)).unwrap()
            };
            let flights: Vec<Flight> = STARTS[..count].iter().map(flight).collect();
            let found = identify_tumbles(&flights, &TumbleOptions::default()).unwrap();
            excess.add(&found.residuals[0]);
            normalised += normalised_square(&found, ratios(TENSOR)) / seeds as f64;
        }
        excess.hold();
        println!("normalised square {normalised:.3}");
        assert!(is_about_one(normalised, 0.1), "{normalised}");
    }
}

pub(crate) fn rotor(tensor: [f64; 6]) -> Rotor {
    let [xx, yy, zz, xy, xz, yz] = tensor;
    let inertia = InertiaTensor::from_matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).unwrap();
    Rotor::free(&MassProperties::new(0.37, Position::ZERO, inertia).unwrap())
}

/// Returns states at 100 Hz under torques.
pub(crate) fn states(rotor: &Rotor, torques: &[TorqueModel], omega: [f64; 3], duration: f64) -> Vec<State> {
    let attitude = Attitude::exp(Direction::new(0.3, -0.5, 0.2)).unwrap();
    let start = State { time: 0.2, attitude, omega: AngularVelocity::from_array(omega) };
    let times: Vec<f64> = (0..(100.0 * duration) as usize).map(|k| 0.2 + 0.01 * k as f64).collect();
    let run = Trajectory::compute(rotor, torques, start, &times, Method::Auto, 1e-13).unwrap();
    run.samples().iter().map(|sample| sample.state).collect()
}

pub(crate) fn readings(states: &[State], noise: &mut Normal, sd: f64) -> Vec<GyroReading> {
    let read = |state: &State| {
        let omega = state.omega.to_array();
        let read = core::array::from_fn(|i| omega[i] + BIAS[i] + sd * noise.next());
        GyroReading { time: state.time, omega: AngularVelocity::from_array(read) }
    };
    states.iter().map(read).collect()
}

/// Checks that the first numbers are within 4 of their standard deviations, and that these are
/// small.
pub(crate) fn holds(found: &Tumble, truth: &[f64], small: f64) {
    let size = truth.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (number, truth) in found.estimate.numbers.iter().zip(truth) {
        let sd = number.sd.unwrap();
        assert!((number.value - truth).abs() < 4.0 * sd && sd < small * size, "{number:?} {truth}");
    }
}

#[test]
fn something_known_on_the_body_says_how_large_the_moments_are() {
    let added = [2.1e-3, 0.7e-3, 2.4e-3, 0.3e-3, -0.2e-3, 0.1e-3];
    let both = core::array::from_fn(|k| TENSOR[k] + added[k]);
    let mut noise = Normal::new(7);
    let mut flights = Vec::new();
    for start in STARTS {
        flights.push(Flight::of_gyro("bare", gyro(&motion(TENSOR, start), 1.2, &mut noise, 0.01)).unwrap());
        let with = Flight::of_gyro("with", gyro(&motion(both, start), 1.2, &mut noise, 0.01)).unwrap();
        flights.push(with.with_added(added));
    }
    let found = identify_tumbles(&flights, &TumbleOptions::default()).unwrap();
    assert!(found.scale_is_known && found.estimate.unknown.is_empty(), "{:?}", found.estimate.unknown);
    holds(&found, &TENSOR, 0.02);
}

#[test]
fn two_different_added_bodies_determine_the_scale() {
    let light = [1.1e-3, 0.4e-3, 1.3e-3, -0.2e-3, 0.1e-3, 0.3e-3];
    let heavy = [4.2e-3, 3.1e-3, 5.7e-3, 0.3e-3, -0.4e-3, 0.6e-3];
    let mut noise = Normal::new(21);
    let mut flights = Vec::new();
    for start in STARTS {
        for added in [light, heavy] {
            let with = motion(core::array::from_fn(|k| TENSOR[k] + added[k]), start);
            let flight = Flight::of_gyro("with", gyro(&with, 1.2, &mut noise, 0.01)).unwrap();
            flights.push(flight.with_added(added));
        }
    }
    let found = identify_tumbles(&flights, &TumbleOptions::default()).unwrap();
    assert!(found.scale_is_known && found.estimate.unknown.is_empty(), "{:?}", found.estimate.unknown);
    holds(&found, &TENSOR, 0.05);
}

#[test]
fn one_added_body_determines_no_scale() {
    let added = [2.1e-3, 0.7e-3, 2.4e-3, 0.3e-3, -0.2e-3, 0.1e-3];
    let both = motion(core::array::from_fn(|k| TENSOR[k] + added[k]), STARTS[0]);
    let log = gyro(&both, 1.2, &mut Normal::new(22), 0.01);
    let flight = Flight::of_gyro("with", log).unwrap().with_added(added);
    for flights in [vec![flight.clone()], vec![flight.clone(), flight]] {
        let error = identify_tumbles(&flights, &TumbleOptions::default()).unwrap_err();
        assert_eq!(error, IdentifyError::OneBody { flights: flights.len() });
        assert!(error.to_string().contains("only the ratios"), "{error}");
    }
}

#[test]
fn what_the_readings_hardly_show_is_not_determined() {
    // Almost steady rotation about the greatest axis: the nutation is below the noise.
    let tensor = [3.1e-3, 4.2e-3, 5.3e-3, 0.0, 0.0, 0.0];
    let log = gyro(&motion(tensor, [0.015, 0.02, 9.0]), 1.2, &mut Normal::new(23), 0.012);
    let flights = [Flight::of_gyro("steady", log).unwrap()];
    let found = match identify_tumbles(&flights, &TumbleOptions::default()) {
        Ok(found) => found,
        Err(error) => return assert!(matches!(error, IdentifyError::Steady { .. }), "{error}"),
    };
    let p = &found.principal;
    for (k, largest) in [1.0, 0.5].into_iter().enumerate() {
        assert_eq!(p.undetermined_ratio(k).is_some(), p.ratio_sd[k].is_none_or(|sd| sd > largest));
    }
    for k in 0..3 {
        let largest = core::f64::consts::PI / 3.0_f64.sqrt();
        assert_eq!(p.undetermined_turn(k).is_some(), p.turn_sd[k].is_none_or(|sd| sd > largest));
    }
    assert!((0..2).any(|k| p.undetermined_ratio(k).is_some()), "{p:?}");
}

#[test]
fn a_wheel_that_is_known_says_it_too() {
    let wheel = Wheel::new(Direction::new(0.2, 0.3, 0.9), 0.02, Motor::HeldSpeed).unwrap();
    let body = rotor(TENSOR).with_wheels(&[wheel]).unwrap();
    let mut noise = Normal::new(8);
    let flights = STARTS.map(|start| {
        let log = readings(&states(&body, &[], start, 1.2), &mut noise, 0.01);
        Flight::of_gyro("wheel", log).unwrap().with_wheels(vec![wheel])
    });
    let found = identify_tumbles(&flights, &TumbleOptions::default()).unwrap();
    assert!(found.scale_is_known && found.estimate.unknown.is_empty(), "{:?}", found.estimate.unknown);
    holds(&found, &TENSOR, 0.02);
}

#[test]
fn drag_is_found_with_the_body() {
    let drag = [3.0e-4, 1.0e-4, 2.0e-4, 0.3e-4, -0.2e-4, 0.1e-4];
    let [xx, yy, zz, xy, xz, yz] = drag;
    let law = Drag::new(DragLaw::Quadratic, [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).unwrap();
    let mut noise = Normal::new(9);
    let flights = STARTS.map(|start| {
        let states = states(&rotor(TENSOR), &[TorqueModel::Drag(law)], start, 1.2);
        Flight::of_gyro("air", readings(&states, &mut noise, 0.01)).unwrap()
    });
    let options = TumbleOptions { drag: Some(DragLaw::Quadratic), ..TumbleOptions::default() };
    let found = identify_tumbles(&flights, &options).unwrap();
    let (moments, _) = polhode::math::symmetric_eigen(TENSOR);
    let truth: Vec<f64> = TENSOR.iter().chain(&drag).map(|x| x / moments[2]).collect();
    holds(&found, &truth, 0.02);
    assert!(!found.residuals[0].is_too_large() && !found.residuals[0].is_correlated());
    // Without drag in the model the residuals reveal the error.
    let without = identify_tumbles(&flights, &TumbleOptions::default()).unwrap();
    assert!(without.residuals[0].is_too_large() && without.residuals[0].is_correlated());
    assert!(without.widening > 2.0, "{}", without.widening);
}

#[test]
fn tracked_attitudes_and_a_gyro_are_read_together() {
    // Orientation of the tracked axes relative to the gyro's, and the clock offset.
    let axes: Rotation<Body, Body> = Rotation::exp(Direction::new(0.4, -0.9, 0.5)).unwrap();
    let clock = 0.013;
    let mut noise = Normal::new(10);
    let flights = STARTS.map(|start| {
        let motion = motion(TENSOR, start);
        let times: Vec<f64> = (0..120).map(|k| 0.21 + 0.01 * f64::from(k)).collect();
        let gyro = times.iter().map(|&time| {
            let omega = motion.at(time + clock).omega.to_array();
            let read = core::array::from_fn(|i| omega[i] + BIAS[i] + 0.01 * noise.next());
            GyroReading { time, omega: AngularVelocity::from_array(read) }
        });
        let gyro: Vec<_> = gyro.collect();
        let tracked = times.iter().map(|&time| {
            let error = [(); 3].map(|()| 0.002 * noise.next());
            let error: Rotation<Body, Body> = Rotation::exp(Direction::from_array(error)).unwrap();
            AttitudeReading { time: time + 0.004, attitude: motion.at(time + 0.004).attitude * axes * error }
        });
        Flight::new("tracked", gyro, tracked.collect()).unwrap()
    });
    let gyro = GyroErrors { bias: true, clock: true, ..GyroErrors::default() };
    let options = TumbleOptions { gyro, attitude_noise: Some(0.002), ..TumbleOptions::default() };
    let found = identify_tumbles(&flights, &options).unwrap();
    holds(&found, &relative(TENSOR), 0.01);
    let number = |name: &str| found.estimate.get(name).unwrap();
    let late = number("gyro clock");
    assert!((late.value - clock).abs() < 4.0 * late.sd.unwrap() && late.sd.unwrap() < 1e-3, "{late:?}");
    assert!(found.residuals.iter().all(|test| !test.is_too_large() && !test.is_correlated()));
    // With attitudes alone the tensor is along the tracked axes, and is determined too.
    let alone =
        flights.map(|flight| Flight::new("tracked", Vec::new(), flight.attitudes().to_vec()).unwrap());
    let found = identify_tumbles(&alone, &options).unwrap();
    let p = &found.principal;
    for ((ratio, sd), truth) in p.ratios.iter().zip(p.ratio_sd).zip(ratios(TENSOR)) {
        let sd = sd.unwrap();
        assert!((ratio - truth).abs() < 4.0 * sd && sd < 0.01, "{ratio} ± {sd}, {truth}");
    }
}

#[test]
fn the_scale_of_a_gyro_along_principal_axes_does_not_show_in_free_motion() {
    // i1 ω̇1 = (i2 − i3) ω2 ω3 has three coefficients; moments with scales have five parameters.
    let tensor = [3.1e-3, 4.2e-3, 5.3e-3, 0.0, 0.0, 0.0];
    let mut noise = Normal::new(11);
    let flights = STARTS
        .map(|start| Flight::of_gyro("one", gyro(&motion(tensor, start), 1.2, &mut noise, 1e-6)).unwrap());
    let gyro = GyroErrors { bias: true, scale: true, ..GyroErrors::default() };
    match identify_tumbles(&flights, &TumbleOptions { gyro, ..TumbleOptions::default() }) {
        // With noise of 1e-6 of the rates the direction is almost unobservable: its error is large,
        // or `None`.
        Ok(found) => {
            let scale = found.estimate.get("gyro scale x").unwrap();
            assert!(scale.sd.is_none_or(|sd| sd > 1e-3), "{scale:?}");
        }
        Err(error) => assert!(error.hint().is_some_and(|hint| hint.contains("scale")), "{error}"),
    }
}

#[test]
fn outliers_are_left_out_and_counted() {
    let mut noise = Normal::new(12);
    let mut log = gyro(&motion(TENSOR, STARTS[0]), 1.2, &mut noise, 0.01);
    log[40].omega.x += 3.0;
    log[77].omega.z -= 5.0;
    let mut flights = flights(12, 0.01);
    flights[0] = Flight::of_gyro("spoilt", log.clone()).unwrap();
    let found = identify_tumbles(&flights, &TumbleOptions::default()).unwrap();
    assert_eq!(found.flights[0].left_out, [log[40].time, log[77].time]);
    holds(&found, &relative(TENSOR), 0.01);
}

#[test]
fn what_cannot_be_a_flight_is_refused() {
    let reading = |time: f64, x: f64| GyroReading { time, omega: AngularVelocity::new(x, 1.0, 2.0) };
    let few = Flight::of_gyro("few", vec![reading(0.0, 1.0), reading(0.1, 1.0)]).unwrap_err();
    assert_eq!(few.to_string(), "too few readings of a flight: 2; at least 4 are needed");
    let back = vec![reading(0.0, 1.0), reading(0.2, 1.0), reading(0.1, 1.0), reading(0.3, 1.0)];
    assert!(Flight::of_gyro("back", back).unwrap_err().to_string().contains("later than the previous one"));
    let none = vec![reading(0.0, 1.0), reading(0.2, f64::NAN), reading(0.3, 1.0), reading(0.4, 1.0)];
    assert!(Flight::of_gyro("none", none).unwrap_err().to_string().contains("NaN"));
    let still: Vec<_> = (0..200).map(|k| reading(0.01 * f64::from(k), 0.0)).collect();
    assert!(find_flights(&still, &FlightSearch::default()).unwrap().is_empty());
}

#[test]
fn a_rate_in_degrees_is_no_free_motion() {
    // Readings in deg/s taken for rad/s: rates too large by κ would require slower changes by κ.
    let mut noise = Normal::new(13);
    let flights = STARTS.map(|start| {
        let log = gyro(&motion(TENSOR, start), 1.2, &mut noise, 0.01);
        let degrees = |r: &GyroReading| GyroReading { omega: r.omega * 57.295_779_513, ..*r };
        Flight::of_gyro("degrees", log.iter().map(degrees).collect()).unwrap()
    });
    let error = identify_tumbles(&flights, &TumbleOptions::default()).unwrap_err();
    assert!(error.to_string().starts_with("the rates are probably in deg/s"), "{error}");
}

#[test]
fn rates_in_turns_are_no_free_motion() {
    for (unit, per_radian) in [("rpm", 9.549_296_6), ("rev/s", 0.159_154_94)] {
        let mut noise = Normal::new(14);
        let flights = STARTS.map(|start| {
            let log = gyro(&motion(TENSOR, start), 1.2, &mut noise, 0.01);
            let turns = |r: &GyroReading| GyroReading { omega: r.omega * per_radian, ..*r };
            Flight::of_gyro("turns", log.iter().map(turns).collect()).unwrap()
        });
        let error = identify_tumbles(&flights, &TumbleOptions::default()).unwrap_err();
        assert!(error.to_string().starts_with(&format!("the rates are probably in {unit}")), "{error}");
    }
}

#[test]
fn a_steady_rate_says_nothing_of_units() {
    let mut noise = Normal::new(15);
    let reading = |k: i32, noise: &mut Normal| {
        let omega = AngularVelocity::from_array([5.0, -3.0, 6.0].map(|w| w + 0.02 * noise.next()));
        GyroReading { time: 0.01 * f64::from(k), omega }
    };
    let log = (0..150).map(|k| reading(k, &mut noise)).collect();
    let found = identify_tumbles(&[Flight::of_gyro("steady", log).unwrap()], &TumbleOptions::default());
    assert!(!matches!(found, Err(IdentifyError::Unit { .. })), "{found:?}");
}

#[test]
fn times_in_another_unit_are_refused() {
    for factor in [1e3, 1e6] {
        let mut noise = Normal::new(16);
        let flights = STARTS.map(|start| {
            let log = gyro(&motion(TENSOR, start), 1.2, &mut noise, 0.02);
            let late = |r: &GyroReading| GyroReading { time: factor * r.time, ..*r };
            Flight::of_gyro("ms", log.iter().map(late).collect()).unwrap()
        });
        let error = identify_tumbles(&flights, &TumbleOptions::default()).unwrap_err();
        assert!(error.to_string().contains("check that times are in s"), "{error}");
    }
}
