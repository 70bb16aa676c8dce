//! Impossible inputs are refused, with the number and the rule.

use core::f64::consts::FRAC_PI_2;

use polhode::math::{Acceleration, Direction};
use polhode::motion::MotionError;
use polhode::motion::gimbal::{Axis, Base, Gimbals, Spring};
use polhode::prelude::*;

use super::{free, generic_rotor, symmetric_rotor, upright};

const UP: Direction<Space> = Direction::new(0.0, 0.0, 1.0);

#[track_caller]
fn refused<T: core::fmt::Debug>(result: Result<T, MotionError>, message: &str) {
    let error = result.unwrap_err();
    assert!(error.is_parameter() && error.to_string().contains(message), "{error}");
}

#[test]
fn numbers_out_of_range_are_refused() {
    let axes = free([0.1; 3], [0.2; 3]);
    refused(Axis::free(f64::NAN, 0.0), "the angle of an axis");
    refused(Axis::driven(0.0, f64::INFINITY), "the rate of an axis");
    refused(axes[0].damped(-1.0), "the damping of an axis = -1");
    refused(axes[0].sprung(Spring { stiffness: -2.0, rest: 0.0 }), "the stiffness of a spring = -2");
    refused(axes[0].sprung(Spring { stiffness: 2.0, rest: f64::NAN }), "the angle of a spring at rest");
    refused(axes[0].turned_by(f64::NAN), "the torque about an axis");
    refused(Base::on_earth(1.6), "the latitude of the base = 1.6");
    refused(Base::turning(AngularVelocity::new(f64::NAN, 0.0, 0.0)), "the angular velocity of the base");
    refused(Gimbals::new(UP, Direction::new(1.0, 0.0, 0.1), axes), "zero: the inner axis is perpendicular");
    refused(Gimbals::new(Direction::ZERO, UP, axes), "the outer axis = 0");
    let gimbals = upright(axes);
    refused(gimbals.holding(Position::ZERO, Direction::ZERO), "the axis of the rotor = 0");
    refused(
        gimbals.holding(Position::new(f64::NAN, 0.0, 0.0), Direction::new(0.0, 0.0, 1.0)),
        "the crossing",
    );
    refused(gimbals.with_gravity(Acceleration::new(0.0, f64::NAN, 0.0)), "gravity");
    let rotor = generic_rotor();
    refused(Simulation::in_gimbals(&rotor, &gimbals, 1.0, &[0.5]).run(), "");
    refused(
        Simulation::in_gimbals(&rotor, &gimbals, 0.0, &[1.0]).tolerance(0.1).run(),
        "the tolerance = 0.1",
    );
}

#[test]
fn axes_that_nothing_holds_apart_are_refused() {
    let rotor = generic_rotor();
    for angle in [FRAC_PI_2, -FRAC_PI_2, 3.0 * FRAC_PI_2] {
        let gimbals = upright(free([0.1, angle, 0.2], [0.0; 3]));
        let message = "off ±90 deg";
        refused(Simulation::in_gimbals(&rotor, &gimbals, 0.0, &[1.0]).run(), message);
    }
    // A needle has no inertia about its own axis.
    let needle = symmetric_rotor(0.01, 0.0, 1.0, 0.0);
    let gimbals = upright(free([0.1, 0.2, 0.3], [0.0; 3]));
    let message = "the moment of inertia about the rotor's axis = 0 must be positive";
    refused(Simulation::in_gimbals(&needle, &gimbals, 0.0, &[1.0]).run(), message);
    // With its axis driven this does not matter, and neither does ±90°.
    let axes =
        [Axis::free(0.1, 0.0), Axis::free(FRAC_PI_2 - 0.5, 0.2), Axis::driven(0.0, 3.0)].map(Result::unwrap);
    assert!(Simulation::in_gimbals(&needle, &upright(axes), 0.0, &[1.0]).run().is_ok());
}
