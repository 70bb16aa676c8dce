//! Members under a torque that one call computes for all of them.

use std::num::NonZero;
use std::sync::{Arc, Mutex};

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{AngularVelocity, Attitude, Body, Position, Torque};
use polhode::motion::torque::{ConstantTorque, MemberState, Schedule, Scheduled, TorqueModel};
use polhode::motion::{Ensemble, Member, Method, MotionError, Rotor, State};

const TIMES: [f64; 4] = [0.0, 0.7, 1.9, 6.0];

/// Returns drag that grows with the attitude's first component, plus a push that differs between
/// members.
fn law(state: &State, push: f64) -> Torque<Body> {
    let [w, ..] = state.attitude.quaternion();
    let drag = Torque::from_array(state.omega.to_array().map(|rate| -0.1 * (1.0 + w * w) * rate));
    drag + Torque::new(0.0, push * state.time.cos(), 0.05)
}

fn member(k: usize, torques: Vec<TorqueModel>) -> Member {
    let tensor = [[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]];
    let body = InertiaTensor::from_matrix(tensor).unwrap();
    let rotor = Rotor::free(&MassProperties::new(2.3, Position::ZERO, body).unwrap());
    let omega = AngularVelocity::new(0.3 + 0.37 * k as f64, -1.1, 0.4);
    let attitude = Attitude::from_quaternion([0.5, -0.1, 0.7, 0.3]).unwrap();
    Member::new(rotor, torques, State { time: 0.0, attitude, omega })
}

/// Returns a torque that acts for a while, together with a function.
fn beside(function: TorqueModel) -> Vec<TorqueModel> {
    let push = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.2, 0.0, -0.1)));
    let schedule = Schedule::window(0.5, 2.5).unwrap();
    vec![TorqueModel::Scheduled(Box::new(Scheduled { schedule, torque: push })), function]
}

/// Members in step have the same bits as each alone, and one call serves all of them.
#[test]
fn bits_are_those_of_the_function_alone() {
    let calls = Arc::new(Mutex::new(Vec::new()));
    let heard = Arc::clone(&calls);
    let many = TorqueModel::vectorized_function("many", move |asked| {
        heard.lock().unwrap().push(asked.len());
        asked.iter().map(|one| law(&one.state, 0.01 * one.member as f64)).collect()
    });
    let members = (0..40).map(|k| member(k, beside(many.clone())));
    let together = Ensemble::new(members.collect()).unwrap();
    let one_by_one = Ensemble::new(
        (0..40)
            .map(|k| {
                let one = TorqueModel::function("one", move |_, state| law(state, 0.01 * k as f64));
                member(k, beside(one))
            })
            .collect(),
    )
    .unwrap();
    let states =
        |ensemble: &Ensemble| ensemble.at(&TIMES, Method::Auto, 1e-10, NonZero::<usize>::MIN).unwrap();
    let (found, expected) = (states(&together), states(&one_by_one));
    assert!(found.failures.is_empty() && expected.failures.is_empty());
    for (a, b) in found.states.iter().zip(&expected.states) {
        assert!(a.attitude.angle_to(b.attitude) < 1e-12 && (a.omega - b.omega).norm() < 1e-12);
    }
    let calls = calls.lock().unwrap();
    assert_eq!(calls[0], 40);
    let steps: usize = calls.iter().sum();
    assert!(calls.len() < steps / 20, "{} calls for {steps} evaluations", calls.len());
}

/// A member that cannot continue stays where it was, and the others continue. A function that
/// returns too few torques is refused.
#[test]
fn failures_are_of_members() {
    let partial = TorqueModel::vectorized_function("partial", |asked| {
        let torque = |one: &MemberState<'_>| match one.member == 1 && one.state.time > 1.0 {
            true => Torque::new(f64::NAN, f64::NAN, f64::NAN),
            false => law(&one.state, 0.0),
        };
        asked.iter().map(torque).collect()
    });
    let members: Vec<_> = (0..3).map(|k| member(k, vec![partial.clone()])).collect();
    let found = Ensemble::new(members).unwrap();
    let found = found.at(&TIMES, Method::Auto, 1e-10, NonZero::<usize>::MIN).unwrap();
    assert_eq!(found.failures.iter().map(|failure| failure.member).collect::<Vec<_>>(), [1]);
    let reached: Vec<f64> = found.states.iter().map(|state| state.time).collect();
    assert_eq!(reached[..4], TIMES);
    assert_eq!(reached[4..8], [0.0, 0.7, 0.7, 0.7]);
    assert_eq!(reached[8..], TIMES);
    let short = TorqueModel::vectorized_function("short", |_| Vec::new());
    let refused = Ensemble::new(vec![member(0, vec![short])]).unwrap_err();
    assert!(matches!(refused.cause, MotionError::TorqueNotFinite { torque: 0, .. }), "{refused}");
}
