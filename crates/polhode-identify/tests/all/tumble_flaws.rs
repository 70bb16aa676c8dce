//! Tumbles with flawed readings.

use polhode::math::{AngularVelocity, Body, Direction, Rotation};
use polhode::motion::{Motor, Wheel};
use polhode_identify::IdentifyError;
use polhode_identify::tumble::{
    AttitudeReading, Flaw, Flight, FlightSearch, GyroRange, GyroReading, Tumble, TumbleOptions, find_flights,
    identify_tumbles,
};

use crate::noise::Normal;
use crate::tumble::{
    BIAS, STARTS, TENSOR, flights, gyro, holds, motion, ratios, readings, relative, rotor, states,
};

/// Returns the flight with a modified log.
fn with(flight: &Flight, change: impl Fn(&GyroReading) -> GyroReading) -> Flight {
    Flight::of_gyro(flight.name(), flight.gyro().iter().map(change).collect()).unwrap()
}

fn of_components(reading: &GyroReading, change: impl Fn(f64) -> f64) -> GyroReading {
    GyroReading { omega: AngularVelocity::from_array(reading.omega.to_array().map(change)), ..*reading }
}

fn identified(flights: &[Flight]) -> Tumble {
    identify_tumbles(flights, &TumbleOptions::default()).unwrap()
}

fn is_noise(found: &Tumble) -> bool {
    found.residuals.iter().all(|test| !test.is_too_large() && !test.is_correlated())
}

#[test]
fn readings_at_a_limit_are_not_used() {
    for limit in [8.5, 8.0, 7.5] {
        let clipped: Vec<Flight> = flights(21, 0.01)
            .iter()
            .map(|flight| with(flight, |r| of_components(r, |x| x.clamp(-limit, limit))))
            .collect();
        let reached = clipped.iter().flat_map(Flight::gyro).flat_map(|r| r.omega.to_array());
        let reached = reached.filter(|x| x.abs() == limit).count();
        let found = identified(&clipped);
        holds(&found, &relative(TENSOR), 0.02);
        assert!(is_noise(&found), "{limit}: {:?}", found.residuals);
        let mut count = 0;
        for flaw in &found.flaws {
            match flaw {
                Flaw::Saturated(at) => {
                    assert_eq!(at.limit.abs(), limit);
                    count += at.count;
                }
                other => panic!("{limit}: {other:?}"),
            }
        }
        assert_eq!(count, reached, "{limit}: {:?}", found.flaws);
        let said = found.flaws[0].to_string();
        assert!(said.starts_with("gyro axis x is saturated at") && said.contains("(one)"), "{said}");
    }
}

#[test]
fn without_a_limit_none_is_seen() {
    for step in [0.0, 1e-3, 0.01, 0.1] {
        let rounded: Vec<Flight> = flights(22, 0.01)
            .iter()
            .map(|flight| {
                with(flight, |r| of_components(r, |x| if step > 0.0 { (x / step).round() * step } else { x }))
            })
            .collect();
        let found = identified(&rounded);
        assert!(found.flaws.is_empty(), "{step}: {:?}", found.flaws);
        holds(&found, &relative(TENSOR), 0.05);
    }
}

#[test]
fn a_range_that_is_told_holds_as_well_as_one_that_shows() {
    let limit = 8.5;
    let clipped: Vec<Flight> =
        flights(23, 0.01).iter().map(|f| with(f, |r| of_components(r, |x| x.clamp(-limit, limit)))).collect();
    let gyro_range = Some(GyroRange::within(limit));
    let told = identify_tumbles(&clipped, &TumbleOptions { gyro_range, ..TumbleOptions::default() }).unwrap();
    assert_eq!(told, identified(&clipped));
    // An infinite range accepts clipped readings, and the residuals reveal them.
    let none = Some(GyroRange::within(f64::INFINITY));
    let without = identify_tumbles(&clipped, &TumbleOptions { gyro_range: none, ..TumbleOptions::default() });
    assert!(
        without.is_ok_and(|found| found.flights.iter().any(|f| !f.left_out.is_empty()) || !is_noise(&found))
    );
    // A flight without readings inside the range is refused.
    let narrow = Some(GyroRange::within(1.5));
    let error = identify_tumbles(&clipped, &TumbleOptions { gyro_range: narrow, ..TumbleOptions::default() });
    assert!(matches!(error, Err(IdentifyError::Saturated { .. })), "{error:?}");
}

#[test]
fn flights_are_found_over_flat_tops() {
    let mut noise = Normal::new(24);
    let flown = gyro(&motion(TENSOR, STARTS[0]), 1.2, &mut noise, 0.01);
    let held = |from: f64, count: usize, noise: &mut Normal| -> Vec<GyroReading> {
        (0..count)
            .map(|k| {
                let omega = AngularVelocity::from_array([(); 3].map(|()| 0.3 * noise.next()));
                GyroReading { time: from + 0.01 * k as f64, omega }
            })
            .collect()
    };
    let mut log = held(0.21 - 0.5, 50, &mut noise);
    log.extend(flown.iter().map(|r| {
        let [x, y, z] = r.omega.to_array();
        GyroReading { omega: AngularVelocity::new(x.min(7.0), y, z), ..*r }
    }));
    assert!(log.iter().filter(|r| r.omega.x == 7.0).count() > 10);
    log.extend(held(0.21 + 1.2, 50, &mut noise));
    let spans = find_flights(&log, &FlightSearch::default()).unwrap();
    assert_eq!(spans.len(), 1, "{spans:?}");
    assert!((spans[0][0] - 0.21).abs() < 0.06 && (spans[0][1] - 1.40).abs() < 0.06, "{spans:?}");
}

#[test]
fn a_hole_of_time_stamps_is_said_and_does_no_harm() {
    for length in [0.05, 0.3, 0.6] {
        let mut holed = flights(25, 0.01);
        let gyro = holed[1].gyro().iter().copied().filter(|r| !(0.5..0.5 + length).contains(&r.time));
        holed[1] = Flight::of_gyro("with a hole", gyro.collect()).unwrap();
        let found = identified(&holed);
        holds(&found, &relative(TENSOR), 0.01);
        assert!(is_noise(&found), "{length}: {:?}", found.residuals);
        match &found.flaws[..] {
            [Flaw::Gap { flight, from, to }] => {
                assert_eq!(flight, "with a hole");
                assert!((from - 0.49).abs() < 0.011 && (to - 0.5 - length).abs() < 0.011, "{from} {to}");
            }
            other => panic!("{length}: {other:?}"),
        }
    }
}

/// Returns a flight with a hand's torque at its ends, for these durations, s.
fn handled(before: f64, after: f64, noise: &mut Normal) -> Flight {
    let free = motion(TENSOR, STARTS[0]);
    let (throw, catch) = (0.5, 1.5);
    let omega = |t: f64| {
        let hand = |dt: f64| [-9.0 * dt + 40.0 * dt * dt, 14.0 * dt, 11.0 * dt - 30.0 * dt * dt];
        let at = |t: f64| free.at(t).omega.to_array();
        let (kept, off) = if t < throw { (at(throw), hand(t - throw)) } else { (at(catch), hand(t - catch)) };
        if (throw..=catch).contains(&t) { at(t) } else { std::array::from_fn(|k| kept[k] + off[k]) }
    };
    let count = ((catch - throw + before + after) * 100.0) as usize;
    let log = (0..count).map(|k| {
        let time = throw - before + 0.01 * k as f64;
        let [x, y, z] = omega(time);
        let omega = [x + BIAS[0], y + BIAS[1], z + BIAS[2]].map(|w| w + 0.01 * noise.next());
        GyroReading { time, omega: AngularVelocity::from_array(omega) }
    });
    Flight::of_gyro("handled", log.collect()).unwrap()
}

#[test]
fn a_flight_that_begins_or_ends_in_a_hand_is_said() {
    for (before, after) in [(0.2, 0.0), (0.0, 0.2), (0.15, 0.3)] {
        let mut noise = Normal::new(26);
        let mut all = flights(26, 0.01);
        all[0] = handled(before, after, &mut noise);
        let found = identified(&all);
        let hands: Vec<_> = found.flaws.iter().collect();
        let [Flaw::Hand { flight, free, given }] = hands[..] else {
            panic!("{before} {after}: {:?}", found.flaws)
        };
        assert_eq!(flight, "handled");
        assert_eq!([free[0] > given[0], free[1] < given[1]], [before > 0.0, after > 0.0]);
        assert!(free[0] > 0.5 - 0.03 && free[0] < 0.58, "{free:?}");
        assert!(free[1] < 1.5 + 0.03 && free[1] > 1.42, "{free:?}");
        assert!(!is_noise(&found) || found.flights[0].left_out.len() > 5, "{:?}", found.residuals);
        // The reported interval is free.
        let cut = all[0].gyro().iter().copied().filter(|r| (free[0]..=free[1]).contains(&r.time));
        all[0] = Flight::of_gyro("cut", cut.collect()).unwrap();
        let found = identified(&all);
        assert!(found.flaws.is_empty(), "{:?}", found.flaws);
        holds(&found, &relative(TENSOR), 0.01);
    }
}

#[test]
fn noise_and_air_are_no_hand() {
    for sd in [1e-4, 0.02, 0.1, 0.3] {
        let found = identified(&flights(27, sd));
        assert!(found.flaws.is_empty(), "{sd}: {:?}", found.flaws);
    }
}

/// Returns the readings with one axis of the gyro reversed.
fn mirrored(flight: &Flight, axis: usize) -> Vec<GyroReading> {
    let mirror = |r: &GyroReading| {
        let mut omega = r.omega.to_array();
        omega[axis] = -omega[axis];
        GyroReading { omega: AngularVelocity::from_array(omega), ..*r }
    };
    flight.gyro().iter().map(mirror).collect()
}

#[test]
fn free_motion_by_a_left_handed_gyro_is_that_of_another_body() {
    for axis in 0..3 {
        let left: Vec<Flight> = flights(28, 0.01)
            .iter()
            .map(|f| Flight::of_gyro("mirrored", mirrored(f, axis)).unwrap())
            .collect();
        let found = identified(&left);
        // No flaw is visible, but the estimate is the mirrored body, and its own mirrored body is
        // the true one.
        assert!(is_noise(&found) && found.flaws.is_empty(), "{:?}", found.residuals);
        let (p, other) = (&found.principal, found.left_handed_ratios().unwrap());
        assert!((p.ratios[1] - ratios(TENSOR)[1]).abs() > 0.05, "{:?}", p.ratios);
        for (k, truth) in ratios(TENSOR).into_iter().enumerate() {
            assert!((other[k] - truth).abs() < 0.01, "{axis}: {other:?}, {truth}");
        }
    }
    // The alternative body exists for a right-handed log too.
    assert!(identified(&flights(28, 0.01)).left_handed_ratios().is_some());
}

#[test]
fn where_more_is_known_left_handed_axes_are_asked_about() {
    let mut noise = Normal::new(29);
    let is_asked = |flights: &[Flight], options: &TumbleOptions, axis: &str| {
        let error = identify_tumbles(flights, options).unwrap_err().to_string();
        assert!(
            error.starts_with(&format!("the gyro's axes are probably left-handed: with {axis} reversed")),
            "{error}"
        );
    };
    // Scale known from a wheel.
    let wheel = Wheel::new(Direction::new(0.2, 0.3, 0.9), 0.02, Motor::HeldSpeed).unwrap();
    let body = rotor(TENSOR).with_wheels(&[wheel]).unwrap();
    let flights = STARTS.map(|start| {
        let log = readings(&states(&body, &[], start, 1.2), &mut noise, 0.01);
        Flight::of_gyro("wheel", log).unwrap()
    });
    let left = flights
        .each_ref()
        .map(|flight| Flight::of_gyro("wheel", mirrored(flight, 2)).unwrap().with_wheels(vec![wheel]));
    is_asked(&left[..2], &TumbleOptions::default(), "z");
    // Scale known from an added body.
    let added = [2.1e-3, 0.7e-3, 2.4e-3, 0.3e-3, -0.2e-3, 0.1e-3];
    let both = std::array::from_fn(|k| TENSOR[k] + added[k]);
    let mut left = Vec::new();
    for start in STARTS {
        let one = |tensor, noise: &mut Normal| {
            Flight::of_gyro("one", gyro(&motion(tensor, start), 1.2, noise, 0.01)).unwrap()
        };
        left.push(Flight::of_gyro("bare", mirrored(&one(TENSOR, &mut noise), 1)).unwrap());
        left.push(Flight::of_gyro("with", mirrored(&one(both, &mut noise), 1)).unwrap().with_added(added));
    }
    is_asked(&left, &TumbleOptions::default(), "y");
    // Handedness known from attitudes.
    let axes: Rotation<Body, Body> = Rotation::exp(Direction::new(0.4, -0.9, 0.5)).unwrap();
    let tracked = STARTS.map(|start| {
        let motion = motion(TENSOR, start);
        let one = Flight::of_gyro("tracked", gyro(&motion, 1.2, &mut noise, 0.01)).unwrap();
        let attitudes = one.gyro().iter().map(|r| {
            let error = [(); 3].map(|()| 0.002 * noise.next());
            let error: Rotation<Body, Body> = Rotation::exp(Direction::from_array(error)).unwrap();
            AttitudeReading { time: r.time, attitude: motion.at(r.time).attitude * axes * error }
        });
        Flight::new("tracked", mirrored(&one, 2), attitudes.collect()).unwrap()
    });
    is_asked(
        &tracked,
        &TumbleOptions { attitude_noise: Some(0.002), ..TumbleOptions::default() },
        "one of them",
    );
}

#[test]
fn fewer_numbers_than_are_sought_are_refused() {
    let short: Vec<GyroReading> = flights(30, 0.01)[0].gyro().iter().copied().take(4).collect();
    let options = TumbleOptions { gyro_noise: Some(0.01), ..TumbleOptions::default() };
    let error = identify_tumbles(&[Flight::of_gyro("short", short).unwrap()], &options).unwrap_err();
    assert_eq!(error.to_string(), "too few measured values in flights: 12; at least 13 are needed");
    let error = identify_tumbles(&[], &options).unwrap_err();
    assert!(matches!(error, IdentifyError::TooFew { given: 0, .. }), "{error}");
}

#[test]
fn rotation_that_does_not_change_shows_nothing() {
    let sphere = [4.1e-3, 4.1e-3, 4.1e-3, 0.0, 0.0, 0.0];
    let brick = [3.1e-3, 4.2e-3, 5.3e-3, 0.0, 0.0, 0.0];
    let about_axes = [[0.0, 0.0, 9.3], [7.7, 0.0, 0.0]];
    for seed in 0..20 {
        let mut noise = Normal::new(500 + seed);
        let mut flight = |tensor, omega: &[f64; 3]| {
            Flight::of_gyro("steady", gyro(&motion(tensor, *omega), 1.2, &mut noise, 0.01)).unwrap()
        };
        let of_sphere: Vec<Flight> = STARTS.iter().map(|start| flight(sphere, start)).collect();
        let of_brick: Vec<Flight> = about_axes.iter().map(|omega| flight(brick, omega)).collect();
        for flights in [of_sphere, of_brick] {
            let error = identify_tumbles(&flights, &TumbleOptions::default()).unwrap_err();
            assert!(matches!(error, IdentifyError::Steady { .. }), "{seed}: {error}");
        }
        // Slightly off the axis the body wobbles, so it is not a sphere.
        let wobbling: Vec<Flight> = STARTS.iter().map(|start| flight(TENSOR, start)).collect();
        assert!(identify_tumbles(&wobbling, &TumbleOptions::default()).is_ok(), "{seed}");
    }
}
