use super::*;
use crate::body::inertia::InertiaTensor;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::{Body, Space};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::vector::{AngularVelocity, Direction, Position, Torque};
use crate::observe::libration::Libration;

/// Returns the oscillations of a body with these moments about roll (x), pitch (y), yaw (z), on a
/// circular orbit in the xz plane of space at the rate n: N = 3 n² r̂ × I r̂.
fn on_orbit(moments: [f64; 3], n: f64) -> Result<SmallOscillations, MotionError> {
    let body = MassProperties::new(7.0, Position::ZERO, InertiaTensor::diagonal(moments).unwrap()).unwrap();
    let rotor = Rotor::free(&body);
    // The frame rotates about y: at t = 0 its axes are those of space, with z along the radius.
    let torque = move |rotor: &Rotor, state: &State| -> Torque<Body> {
        let orbit =
            Rotation::<Space, Space>::from_axis_angle(Direction::new(0.0, 1.0, 0.0), n * state.time).unwrap();
        let r = state.attitude.inverse() * (orbit * Direction::<Space>::new(0.0, 0.0, 1.0));
        let ir = rotor.inertia().symmetric().apply(r.to_array());
        Torque::from_array(r.cross(Direction::from_array(ir)).to_array()) * (3.0 * n * n)
    };
    let state = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.0, n, 0.0) };
    SmallOscillations::about_equilibrium(&rotor, &[TorqueModel::function("gradient", torque)], state)
}

/// Both sides are derived independently: Hughes's scalar equations, and the linear equations in the
/// rotating frame.
#[test]
fn libration_on_a_circular_orbit_is_that_of_the_scalar_equations() {
    let n = 1.13e-3;
    for moments in [[5.1, 6.2, 1.7], [4.1, 6.0, 3.3], [2.3, 3.1, 4.0], [6.2, 5.1, 1.7]] {
        let found = on_orbit(moments, n).unwrap();
        let expected = Libration::of(moments, n).unwrap();
        assert_eq!(found.is_stable(), expected.is_stable(), "{moments:?} {found:?}");
        let has = |frequency: f64| found.modes.iter().any(|m| (m.frequency / frequency - 1.0).abs() < 1e-9);
        assert!(expected.pitch.is_none_or(has), "{moments:?} {found:?}");
        assert!(expected.roll_yaw.is_none_or(|both| both.into_iter().all(has)), "{moments:?} {found:?}");
    }
}

#[test]
fn a_state_that_does_not_last_is_refused() {
    // On the orbit, but not rotating with it.
    let body =
        MassProperties::new(7.0, Position::ZERO, InertiaTensor::diagonal([5.1, 6.2, 1.7]).unwrap()).unwrap();
    let rotor = Rotor::free(&body);
    let torque = TorqueModel::function("growing", |_, state| Torque::new(0.0, 1e-3 * state.time, 0.0));
    let state =
        State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.0, 0.1, 0.0) };
    assert!(matches!(
        SmallOscillations::about_equilibrium(&rotor, &[torque], state).map(|_| ()),
        Err(MotionError::NotSteady { .. })
    ));
}
