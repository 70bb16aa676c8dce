//! Rotors in gimbals as scenarios, and their error estimate.

use polhode::motion::gimbal::{Axis, Base, Gimbals};
use polhode::motion::{Ending, ErrorEffort, MethodReason, MotionError, Run, channel};
use polhode::observe::Drift;
use polhode::prelude::*;

use super::{GRAVITY, balanced, free, generic_rotor, symmetric_rotor, upright};

fn gimbals() -> Gimbals {
    let base = Base::turning(AngularVelocity::new(0.3, -0.2, 0.5)).unwrap();
    let outer = balanced([0.004, 0.005, 0.006], [0.0005, -0.0004, 0.0003]);
    let inner = balanced([0.002, 0.003, 0.0025], [0.0; 3]);
    upright(free([0.3, -0.5, 1.1], [0.4, 0.7, 8.0]))
        .with_base(base)
        .with_mass(outer, inner)
        .with_gravity(GRAVITY)
        .unwrap()
}

fn motion(tolerance: f64) -> Trajectory {
    let scenario = Scenario::new(generic_rotor()).in_gimbals(gimbals()).unwrap();
    let scenario = scenario.sampled(Run::evenly(3.0, 16, Method::Auto, tolerance));
    scenario.simulate_with_error(ErrorEffort::Thorough, &mut |_| true).unwrap().unwrap()
}

#[test]
fn a_scenario_in_gimbals_moves() {
    let trajectory = motion(1e-15);
    let angles = trajectory.channel(channel::AXIS_ANGLES).unwrap();
    assert_eq!(angles.iter().count(), trajectory.samples().len());
    assert_eq!(*trajectory.reason(), MethodReason::Gimbals);
    assert_eq!(*trajectory.ending(), Ending::Complete);
    assert!(trajectory.energy_drift() < 1e-13 && Drift::of(&trajectory).is_none());
    // The rate of L of the rotor equals the torque on it: by differences of nearby samples.
    let scenario = Scenario::new(generic_rotor()).in_gimbals(gimbals()).unwrap();
    let (at, h) = (1.3, 1e-4);
    let times = vec![at - h, at, at + h];
    let near = scenario
        .sampled(Run { times, method: Method::Taylor, tolerance: 1e-15 })
        .simulate()
        .unwrap()
        .unwrap();
    let [before, here, after] = [0, 1, 2].map(|k| near.samples()[k]);
    let rate = (after.momentum - before.momentum) * (0.5 / h);
    let torque = here.state.attitude * here.torque;
    let off = (rate.to_array(), torque.to_array());
    assert!((0..3).all(|k| (off.0[k] - off.1[k]).abs() < 1e-5), "{off:?}");
}

#[test]
fn an_estimate_is_not_below_half_of_the_error() {
    let reference = motion(1e-15);
    for tolerance in [1e-5, 1e-13] {
        let trajectory = motion(tolerance);
        let (said, own) = (trajectory.error().unwrap(), reference.error().unwrap());
        for (k, (sample, best)) in trajectory.samples().iter().zip(reference.samples()).enumerate() {
            let error = sample.state.attitude.angle_to(best.state.attitude);
            let [said, least] = [said, own].map(|error| error.computation()[k].attitude);
            assert!(error <= 2.0 * said + least, "{tolerance:e} at {}: {error:e} {said:e}", best.state.time);
        }
    }
    let end = reference.error().unwrap().end().attitude;
    assert!(end > 1e-16 && end < 1e-9, "{end:e}");
}

/// Gimbal lock of massless gimbals ends the motion; perturbed motions end a little earlier or
/// later.
#[test]
fn an_end_by_locking_has_an_error() {
    let rotor = symmetric_rotor(0.012, 0.02, 1.0, 0.0);
    let scenario = Scenario::new(rotor).in_gimbals(upright(free([0.2, 0.3, 0.0], [0.0, 0.8, 0.0]))).unwrap();
    let scenario = scenario.sampled(Run::evenly(2.0, 11, Method::Auto, 1e-13));
    let trajectory = scenario.simulate_with_error(ErrorEffort::Thorough, &mut |_| true).unwrap().unwrap();
    let ending = trajectory.ending();
    assert!(matches!(ending, Ending::Failed { cause: MotionError::GimbalLock { .. }, .. }), "{ending:?}");
    let end = trajectory.error().unwrap().end().attitude;
    assert!(end > 1e-17 && end < 1e-9, "{end:e}");
}

#[test]
fn what_does_not_go_with_gimbals_is_refused() {
    let hung = || Scenario::new(generic_rotor()).in_gimbals(gimbals()).unwrap();
    let state = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };
    let gravity = TorqueModel::Gravity(UniformGravity::STANDARD);
    let velocity = polhode::math::Velocity::new(1.0, 0.0, 0.0);
    let refusals = [
        hung().starting(state),
        hung().held_at(Position::ZERO),
        hung().with_torques([gravity.clone()]),
        hung().moving(velocity),
        Scenario::new(generic_rotor()).held_at(Position::ZERO).unwrap().in_gimbals(gimbals()),
        Scenario::new(generic_rotor()).moving(velocity).unwrap().in_gimbals(gimbals()),
        Scenario::new(generic_rotor()).with_torques([gravity]).unwrap().in_gimbals(gimbals()),
    ];
    for refusal in refusals {
        assert!(matches!(refusal, Err(MotionError::Exclusive { .. })), "{refusal:?}");
    }
    let exact = hung().sampled(Run::evenly(1.0, 2, Method::Exact, 1e-13));
    let error = exact.simulate().unwrap().unwrap_err();
    assert!(error.to_string().contains("gimbals and method exclude each other"), "{error}");
    let derivatives =
        hung().sampled(Run::evenly(1.0, 2, Method::Auto, 1e-13)).derivatives_watched(&[], &mut |_| true);
    assert!(matches!(derivatives, Some(Err(MotionError::NoMotionDerivatives { .. }))));
    // Locked immediately if massless: the scenario is refused.
    let axes = [Axis::free(0.0, 0.0), Axis::free(std::f64::consts::FRAC_PI_2, 0.0), Axis::free(0.0, 1.0)];
    let error = Scenario::new(generic_rotor()).in_gimbals(upright(axes.map(Result::unwrap))).unwrap_err();
    assert!(error.is_parameter(), "{error}");
}
