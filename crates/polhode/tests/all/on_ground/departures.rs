//! Small perturbations of steady motions, integrated on both sides of the thresholds.

use core::f64::consts::FRAC_PI_2;

use polhode::math::Velocity;
use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{Contact, ContactLaw, Footing, StartVelocity, SurfaceShape};
use polhode::observe::SteadyPath;
use polhode::prelude::*;

use crate::common::held::Held;

use super::{FOOTINGS, body, contact, leaning, start, steady, turned};

/// Perturbation of the start, rad.
const DEPARTURE: f64 = 1e-9;

/// Integrates a perturbed steady motion. Returns the largest growth of the perturbation over the
/// whole time, and its growth rate between the middle and the end.
fn growth(
    body: &MassProperties<Body>,
    contact: &Contact,
    attitude: Attitude,
    omega: [f64; 3],
    time: f64,
) -> [f64; 2] {
    let beside = Rotation::<Space, Space>::from_axis_angle(Direction::new(0.8, 0.6, 0.0), DEPARTURE).unwrap();
    let steady = steady(body, contact, &start(attitude, omega));
    let is_level = !matches!(steady.path, SteadyPath::OnVertex(_));
    let count = 4000;
    let times: Vec<f64> = (1..=count).map(|k| time * f64::from(k) / f64::from(count)).collect();
    let mut from = start(beside * attitude, omega);
    if contact.law != ContactLaw::ROLLING && !is_level {
        from.velocity = StartVelocity::Along(Velocity::ZERO);
    }
    let motion = Held::of(Simulation::on_ground(body, contact, from, &times).run().unwrap(), CONTACT);
    let departure = |k: usize| {
        let up: Direction<Body> =
            motion.samples()[k].state.attitude.inverse() * Direction::new(0.0, 0.0, 1.0);
        if is_level { up.z.abs() } else { up.angle_to(steady.normal) }
    };
    let most = |from: f64, to: f64| {
        let index = |part: f64| (part * f64::from(count)) as usize;
        (index(from)..index(to)).map(departure).fold(0.0, f64::max)
    };
    let rate = (most(0.75, 1.0) / most(0.25, 0.5)).ln() / (0.5 * time);
    [most(0.0, 1.0) / DEPARTURE, rate]
}

/// Below a threshold a perturbation grows at the rate of the linear equations; above it remains
/// bounded.
#[track_caller]
fn changes_at(
    body: &MassProperties<Body>,
    contact: &Contact,
    attitude: Attitude,
    omega: impl Fn(f64) -> [f64; 3],
    threshold: f64,
) {
    for side in [0.96, 1.04] {
        let omega = omega(side * threshold);
        let linear = steady(body, contact, &start(attitude, omega));
        let fastest = linear.modes[0].growth_rate;
        if linear.is_stable() {
            let [most, _] = growth(body, contact, attitude, omega, 20.0);
            assert!(most < 30.0, "{side} {most}");
        } else {
            // Until it has grown by a factor of some millions.
            let time = 16.0 / fastest;
            let [_, rate] = growth(body, contact, attitude, omega, time);
            assert!((rate / fastest - 1.0).abs() < 0.05, "{side} {rate} {:?}", linear.modes);
        }
    }
}

#[test]
fn a_torus_that_rolls_too_slowly_falls() {
    let body = body(1.7, [0.037, 0.037, 0.061]);
    for footing in [Footing::Rolling, Footing::Frictionless] {
        let contact =
            contact(SurfaceShape::Rim { radius: 0.31, tube: 0.07, thickness: 0.0 }, [0.0; 3], footing);
        let attitude = leaning(FRAC_PI_2);
        let rolling = |spin: f64| [0.0, 0.0, spin];
        let threshold = |omega: [f64; 3]| {
            let steady = steady(&body, &contact, &start(attitude, omega));
            steady.stable_spins.unwrap().nearest(9.0).unwrap()
        };
        changes_at(&body, &contact, attitude, rolling, threshold(rolling(9.0)));
        // The vertical is along y of the body.
        let spinning = |spin: f64| [0.0, spin, 0.0];
        changes_at(&body, &contact, attitude, spinning, threshold(spinning(9.0)));
    }
}

#[test]
fn an_egg_that_spins_too_slowly_falls() {
    let body = body(0.9, [0.0024, 0.0024, 0.0023]);
    let egg = SurfaceShape::Ellipsoid { semi_axes: [0.07, 0.07, 0.11] };
    for footing in FOOTINGS {
        let contact = contact(egg, [0.0, 0.0, -0.012], footing);
        let spin = |spin: f64| [0.0, 0.0, spin];
        let attitude = leaning(0.0);
        let stable = steady(&body, &contact, &start(attitude, spin(5.0))).stable_spins.unwrap();
        let threshold = stable.thresholds().into_iter().find(|threshold| *threshold > 0.0).unwrap();
        changes_at(&body, &contact, attitude, spin, threshold);
    }
}

#[test]
fn a_rattleback_swings_up_in_one_sense_alone() {
    let body = turned([0.0012, 0.0081, 0.0089], 0.15);
    let shape = SurfaceShape::Ellipsoid { semi_axes: [0.23, 0.05, 0.04] };
    let contact = contact(shape, [0.0; 3], Footing::Rolling);
    let attitude = leaning(0.0);
    let spin = |spin: f64| [0.0, 0.0, spin];
    let SteadyPath::OnVertex(vertex) = steady(&body, &contact, &start(attitude, spin(5.0))).path else {
        panic!("it stands on its vertex")
    };
    let rattle = vertex.rattleback().unwrap();
    let threshold = rattle.stable_sense * rattle.threshold.unwrap();
    changes_at(&body, &contact, attitude, spin, threshold);
    let against = spin(-1.04 * threshold);
    let fastest = steady(&body, &contact, &start(attitude, against)).modes[0].growth_rate;
    let [_, rate] = growth(&body, &contact, attitude, against, 16.0 / fastest);
    assert!(fastest > 0.0 && (rate / fastest - 1.0).abs() < 0.05, "{rate} {fastest}");
}
