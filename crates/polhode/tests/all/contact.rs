//! Bodies that roll, slide and spin on a surface.

mod closed_form;
mod constants;
mod endings;
mod error;
mod refusals;
mod truth;

use polhode::math::Rotation;
use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{BodySurface, Contact, ContactStart, ContactState, SurfaceShape};
use polhode::prelude::*;

use crate::common::held::Held;

/// Standard gravity, m/s².
const G: f64 = 9.80665;

/// Returns a surface with this centre, along body axes.
fn surface(shape: SurfaceShape, center: [f64; 3]) -> BodySurface {
    BodySurface::new(shape, Position::from_array(center), Rotation::identity()).unwrap()
}

/// Returns a homogeneous ball of mass 2 kg.
fn ball(radius: f64) -> MassProperties<Body> {
    let moment = 0.4 * 2.0 * radius * radius;
    MassProperties::new(2.0, Position::ZERO, InertiaTensor::diagonal([moment; 3]).unwrap()).unwrap()
}

/// Returns a body of 1.7 kg with three moments and three products; its centre of mass is at the
/// origin.
fn generic_body() -> MassProperties<Body> {
    let inertia =
        InertiaTensor::with_negative_products([0.011, 0.014, 0.017], [0.002, -0.0015, 0.001]).unwrap();
    MassProperties::new(1.7, Position::ZERO, inertia).unwrap()
}

fn run(
    body: &MassProperties<Body>,
    contact: &Contact,
    start: ContactStart,
    times: &[f64],
) -> Held<ContactState> {
    Held::of(Simulation::on_ground(body, contact, start, times).run().unwrap(), CONTACT)
}

fn state(attitude: Attitude, omega: [f64; 3]) -> State {
    State { time: 0.0, attitude, omega: AngularVelocity::from_array(omega) }
}

#[track_caller]
fn near(got: f64, want: f64, tolerance: f64) {
    assert!((got - want).abs() <= tolerance, "{got:e} is not {want:e}: off by {:.2e}", (got - want).abs());
}
