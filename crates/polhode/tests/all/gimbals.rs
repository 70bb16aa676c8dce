//! Rotors in two gimbals: gyroscopes and gyrocompasses.

mod closed_form;
mod held;
mod refusals;
mod scenario;
mod truth;

use polhode::math::{Acceleration, Direction, Part};
use polhode::motion::channel::GIMBALS;
use polhode::motion::gimbal::{Axis, Gimbal, GimbalState, Gimbals};
use polhode::prelude::*;

use crate::common::held::Held;

/// Returns a body of 1.7 kg with three moments and three products, its centre of mass off the
/// origin.
fn generic_rotor() -> MassProperties<Body> {
    let inertia =
        InertiaTensor::with_negative_products([0.011, 0.014, 0.017], [0.002, -0.0015, 0.001]).unwrap();
    MassProperties::new(1.7, Position::new(0.02, -0.03, 0.05), inertia).unwrap()
}

/// Returns a rotor that is symmetric about its third axis, its centre of mass at a height above the
/// origin.
fn symmetric_rotor(across: f64, along: f64, mass: f64, height: f64) -> MassProperties<Body> {
    let inertia = InertiaTensor::diagonal([across, across, along]).unwrap();
    MassProperties::new(mass, Position::new(0.0, 0.0, height), inertia).unwrap()
}

fn balanced(moments: [f64; 3], products: [f64; 3]) -> Gimbal {
    Gimbal::balanced(&InertiaTensor::<Part>::with_negative_products(moments, products).unwrap())
}

/// Returns gimbals with the outer axis up and the inner one east.
fn upright(axes: [Axis; 3]) -> Gimbals {
    Gimbals::new(Direction::new(0.0, 0.0, 1.0), Direction::new(1.0, 0.0, 0.0), axes).unwrap()
}

fn free(angles: [f64; 3], rates: [f64; 3]) -> [Axis; 3] {
    [0, 1, 2].map(|k| Axis::free(angles[k], rates[k]).unwrap())
}

const GRAVITY: Acceleration<Space> = Acceleration::new(0.0, 0.0, -9.80665);

fn run(rotor: &MassProperties<Body>, gimbals: &Gimbals, times: &[f64]) -> Held<GimbalState> {
    Held::of(Simulation::in_gimbals(rotor, gimbals, 0.0, times).run().unwrap(), GIMBALS)
}

#[track_caller]
fn near(got: f64, want: f64, tolerance: f64) {
    assert!((got - want).abs() <= tolerance, "{got:e} is not {want:e}: off by {:.2e}", (got - want).abs());
}
