//! Next flight: predicted uncertainty, compared with simulated flights.

use polhode_identify::tumble::{Flight, TumbleOptions, identify_tumbles, next_flight};

use crate::noise::Normal;
use crate::tumble::{STARTS, TENSOR, gyro, motion};

const SD: f64 = 0.02;
const OPTIONS: TumbleOptions = TumbleOptions {
    gyro: polhode_identify::tumble::GyroErrors { bias: true, scale: false, skew: false, clock: false },
    drag: None,
    gyro_noise: Some(SD),
    gyro_range: None,
    attitude_noise: None,
    outlier: 6.0,
};

fn flight(omega: [f64; 3], noise: &mut Normal) -> Flight {
    Flight::of_gyro("one", gyro(&motion(TENSOR, omega), 1.2, noise, SD)).unwrap()
}

/// Returns the largest standard deviation after another flight, and the number of unobservable
/// directions.
fn after(flights: &[Flight], more: Flight) -> (f64, usize) {
    let mut all = flights.to_vec();
    all.push(more);
    let found = identify_tumbles(&all, &OPTIONS).unwrap();
    assert_eq!(found.widening, 1.0);
    let now = next_flight(&all, &OPTIONS, &found).unwrap().unwrap().now;
    (now.largest_sd, now.unknown)
}

#[test]
fn the_flight_that_is_suggested_brings_what_is_said() {
    let mut noise = Normal::new(31);
    // Two flights that contain little information on each other's axes.
    let flights: Vec<Flight> = STARTS[1..3].iter().map(|omega| flight(*omega, &mut noise)).collect();
    let found = identify_tumbles(&flights, &OPTIONS).unwrap();
    let next = next_flight(&flights, &OPTIONS, &found).unwrap().unwrap();
    assert!(next.refused.is_empty() && next.candidates.len() == 7 && next.now.unknown == 0, "{next:?}");
    let mut actual = Vec::new();
    for candidate in &next.candidates {
        let (sd, unknown) = after(&flights, flight(candidate.experiment.omega, &mut noise));
        println!(
            "{:?}: {} → {} said, {sd} found",
            candidate.experiment.about, next.now.largest_sd, candidate.then.largest_sd
        );
        assert_eq!(unknown, 0);
        assert!((sd / candidate.then.largest_sd - 1.0).abs() < 0.05, "{candidate:?} {sd}");
        actual.push(sd);
    }
    let best = next.best().unwrap();
    assert!(best.then.largest_sd < 0.8 * next.now.largest_sd, "{best:?}");
    assert!(actual[1..].iter().all(|sd| actual[0] < 1.05 * sd), "{actual:?}");
    assert!(actual[6] > 1.3 * actual[0], "{actual:?}");
}

#[test]
fn with_something_known_on_the_body_flights_of_both_kinds_are_looked_at() {
    let mut noise = Normal::new(32);
    let added = [2.1e-3, 0.7e-3, 2.4e-3, 0.3e-3, -0.2e-3, 0.1e-3];
    let both = core::array::from_fn(|k| TENSOR[k] + added[k]);
    let with = |omega: [f64; 3], noise: &mut Normal| {
        Flight::of_gyro("with", gyro(&motion(both, omega), 1.2, noise, SD)).unwrap().with_added(added)
    };
    let flights =
        vec![flight(STARTS[0], &mut noise), flight(STARTS[2], &mut noise), with(STARTS[1], &mut noise)];
    let found = identify_tumbles(&flights, &OPTIONS).unwrap();
    assert!(found.scale_is_known);
    let next = next_flight(&flights, &OPTIONS, &found).unwrap().unwrap();
    assert_eq!(next.candidates.len(), 14);
    let best = next.best().unwrap();
    let omega = best.experiment.omega;
    let more =
        if best.experiment.like == "with" { with(omega, &mut noise) } else { flight(omega, &mut noise) };
    let (sd, _) = after(&flights, more);
    assert!((sd / best.then.largest_sd - 1.0).abs() < 0.05, "{best:?} {sd}");
}
