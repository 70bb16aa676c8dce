//! Tumbles of a body that is known.

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{AngularVelocity, Attitude, Direction, Position};
use polhode::motion::{FreeMotion, Rotor, State};
use polhode_identify::tumble::{Flight, GyroReading, Tumble, TumbleOptions, identify_tumbles};

use crate::noise::Normal;

/// Three distinct moments, all products, in kg·m².
const TENSOR: [f64; 6] = [3.1e-3, 4.2e-3, 5.3e-3, 0.4e-3, -0.3e-3, 0.2e-3];
const BIAS: [f64; 3] = [0.013, -0.021, 0.008];

fn motion(tensor: [f64; 6], omega: [f64; 3]) -> FreeMotion {
    let [xx, yy, zz, xy, xz, yz] = tensor;
    let inertia = InertiaTensor::from_matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).unwrap();
    let body = MassProperties::new(0.37, Position::ZERO, inertia).unwrap();
    let attitude = Attitude::exp(Direction::new(0.3, -0.5, 0.2)).unwrap();
    let start = State { time: 0.2, attitude, omega: AngularVelocity::from_array(omega) };
    FreeMotion::of(&Rotor::free(&body), start).unwrap()
}

/// Readings at 100 Hz of a gyro with noise and bias.
fn gyro(motion: &FreeMotion, duration: f64, noise: &mut Normal, sd: f64) -> Vec<GyroReading> {
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

const STARTS: [[f64; 3]; 4] = [[6.0, 7.0, -4.0], [1.0, 9.0, 1.5], [-8.0, 2.0, 3.0], [2.0, -3.0, 9.0]];

fn flights(seed: u64, sd: f64) -> Vec<Flight> {
    let mut noise = Normal::new(seed);
    let one = |start| Flight::of_gyro("one", gyro(&motion(TENSOR, start), 1.2, &mut noise, sd)).unwrap();
    STARTS.map(one).to_vec()
}

fn ratios(tensor: [f64; 6]) -> [f64; 2] {
    let (m, _) = polhode::math::symmetric_eigen(tensor);
    [m[0] / m[2], m[1] / m[2]]
}

/// The tensor in units of its greatest moment.
fn relative(tensor: [f64; 6]) -> [f64; 6] {
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
    // Only ratios are known: the tensor itself is the direction in which nothing is.
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

#[test]
fn errors_are_what_they_are_said_to_be() {
    const SEEDS: u64 = 60;
    let truth = ratios(TENSOR);
    let (mut sums, mut squares, mut said) = ([0.0; 2], [0.0; 2], [0.0; 2]);
    let mut normalised = 0.0;
    for seed in 0..SEEDS {
        let found: Tumble = identify_tumbles(&flights(100 + seed, 0.02), &TumbleOptions::default()).unwrap();
        let p = &found.principal;
        let errors = [p.ratios[0] - truth[0], p.ratios[1] - truth[1]];
        let sds = p.ratio_sd.map(Option::unwrap);
        for k in 0..2 {
            sums[k] += errors[k] / SEEDS as f64;
            squares[k] += errors[k] * errors[k] / SEEDS as f64;
            said[k] += sds[k] * sds[k] / SEEDS as f64;
        }
        let [a, b] = [errors[0] / sds[0], errors[1] / sds[1]];
        let r = p.ratio_correlation.unwrap();
        normalised += (a * a - 2.0 * r * a * b + b * b) / (1.0 - r * r) / (2.0 * SEEDS as f64);
    }
    for k in 0..2 {
        let (sd, said) = (squares[k].sqrt(), said[k].sqrt());
        println!("bias {:.3} sd, sd {:.3} of what is said", sums[k] / said, sd / said);
        assert!((sums[k] / said).abs() < 0.35, "{}", sums[k] / said);
        assert!((sd / said - 1.0).abs() < 0.25, "{}", sd / said);
    }
    println!("normalised square {normalised:.3}");
    assert!((0.7..1.3).contains(&normalised), "{normalised}");
}
