//! Torsion springs and wires: oscillations with the same period at every amplitude, and
//! conservation of energy.

use std::num::NonZero;

use polhode::motion::torque::Torsion;
use polhode::motion::{Ending, Ensemble, EventAction, EventFunction, Measure, Member, Sense, SplittingOrder};
use polhode::prelude::*;

const METHODS: [Method; 2] = [Method::Taylor, Method::Dop853];

fn body() -> MassProperties<Body> {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap()
}

fn rest() -> Attitude {
    Attitude::from_quaternion([0.8, 0.1, -0.4, 0.5]).unwrap()
}

/// Returns a spring, and a wire along an axis of space.
fn springs(stiffness: f64, axis: Direction<Space>) -> [TorqueModel; 2] {
    [Torsion::spring(stiffness, rest()), Torsion::wire(stiffness, rest(), axis)]
        .map(|torsion| TorqueModel::Torsion(torsion.unwrap()))
}

#[test]
fn the_period_is_the_same_at_every_amplitude() {
    let rotor = Rotor::free(&body());
    // About the intermediate axis, rounding would grow into a tilt.
    let (moment, axis) = (rotor.principal().moments()[2], rest() * rotor.principal().axis(2));
    let stiffness = 1.7;
    let rate = (stiffness / moment).sqrt();
    for amplitude in [1e-9, 0.01, 1.0, 3.1] {
        let start = State {
            time: 0.0,
            attitude: Rotation::<Space, Space>::from_axis_angle(axis, amplitude).unwrap() * rest(),
            omega: AngularVelocity::ZERO,
        };
        for torque in springs(stiffness, axis) {
            for method in METHODS {
                let times: Vec<_> = (0..40).map(|k| f64::from(k) * 0.77).collect();
                let torques = [torque.clone()];
                let motion = Trajectory::compute(&rotor, &torques, start, &times, method, 1e-15).unwrap();
                for sample in motion.samples() {
                    // ψ = ψ₀ cos √(κ/I) t
                    let angle = amplitude * (rate * sample.state.time).cos();
                    let want = Rotation::<Space, Space>::from_axis_angle(axis, angle).unwrap() * rest();
                    let error = sample.state.attitude.angle_to(want);
                    // The error of the smallest amplitude is absolute, at the tolerance, not
                    // relative.
                    assert!(error < 6e-14, "{method:?} {amplitude} t = {}: {error:e}", sample.state.time);
                }
                // Angles are accurate to the tolerance, for every amplitude.
                let energy = Drift::of(&motion).unwrap().total_energy.unwrap();
                assert!(energy < 1e-13 + 2e-14 / amplitude, "{method:?} {amplitude}: {energy:e}");
            }
        }
    }
}

#[test]
fn both_integrators_keep_the_energy_and_agree() {
    let axis = Direction::new(0.3, -0.5, 0.9);
    let pivoted = Rotor::pivoted(&body(), Position::new(-0.2, 0.1, 0.05));
    let start = State {
        time: 0.0,
        attitude: Attitude::from_quaternion([0.9, -0.2, 0.1, 0.6]).unwrap(),
        omega: AngularVelocity::new(0.4, -0.7, 0.3),
    };
    let times: Vec<_> = (0..=20).map(f64::from).collect();
    for torque in springs(2.9, axis) {
        // With gravity at the pivot, so that the body tilts.
        let torques = [
            torque,
            TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(0.1, 0.3, -1.2) }),
        ];
        let [a, b] = METHODS.map(|method| {
            let motion = Trajectory::compute(&pivoted, &torques, start, &times, method, 1e-15).unwrap();
            let drift = Drift::of(&motion).unwrap();
            assert!(drift.total_energy.unwrap() < 3e-13, "{method:?}: {drift:?}");
            assert!(drift.work_energy < 3e-13 && drift.momentum < 3e-13, "{method:?}: {drift:?}");
            motion
        });
        for (a, b) in a.samples().iter().zip(b.samples()) {
            let error = (a.state.omega - b.state.omega).norm();
            assert!(error < 1e-12, "t = {}: {error:e}", a.state.time);
            assert!(a.state.attitude.angle_to(b.state.attitude) < 1e-12);
        }
    }
}

const TOLERANCES: [f64; 7] = [1e-15, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5, 1e-3];

/// Returns a body that starts from rest attitude about its third axis, fast enough for this
/// amplitude, rad. Also returns the time of half a turn: sin √(κ/I) t = π/amplitude.
fn thrown(amplitude: f64, stiffness: f64) -> (Rotor, State, Direction<Space>, f64) {
    let rotor = Rotor::free(&body());
    let (moment, axis) = (rotor.principal().moments()[2], rotor.principal().axis(2));
    let rate = (stiffness / moment).sqrt();
    let omega = AngularVelocity::from_array((axis * (amplitude * rate)).to_array());
    let passes = (std::f64::consts::PI / amplitude).asin() / rate;
    (rotor, State { time: 0.0, attitude: rest(), omega }, rest() * axis, passes)
}

#[test]
fn half_a_turn_ends_the_motion_at_one_time_at_all_tolerances() {
    // The second case exceeds half a turn for a hundredth of its period, within a step. The last
    // one stays below it by a relative 10⁻⁶.
    for (amplitude, ends) in [(400.0_f64, true), (180.4, true), (180.0002, true), (179.9998, false)] {
        let stiffness = 1.7;
        let (rotor, start, axis, passes) = thrown(amplitude.to_radians(), stiffness);
        for torque in springs(stiffness, axis) {
            for method in METHODS {
                for tolerance in TOLERANCES {
                    // Near the turning point, a small error of the angle is a large error of the
                    // time, and may decide if half a turn is reached.
                    let slope = (amplitude.to_radians().powi(2) - std::f64::consts::PI.powi(2)).abs().sqrt();
                    if 100.0 * tolerance > slope * slope {
                        continue;
                    }
                    let times = [if ends { 0.5 * passes } else { 1.0 }, 12.0];
                    let torques = [torque.clone()];
                    let motion =
                        Trajectory::compute(&rotor, &torques, start, &times, method, tolerance).unwrap();
                    let samples = motion.samples();
                    assert_eq!(samples[0].state.time, times[0], "what comes before is kept");
                    if !ends {
                        assert_eq!(*motion.ending(), Ending::Complete, "{method:?} {tolerance}");
                        continue;
                    }
                    let Ending::Failed { time, ref cause } = *motion.ending() else {
                        panic!("{amplitude} {method:?} {tolerance}: {:?}", motion.ending())
                    };
                    assert_eq!(*cause, MotionError::HalfTurn { time });
                    assert!(cause.is_numerical() && cause.hint().is_some());
                    let most = (20.0 * tolerance + 1e-13) / slope;
                    assert!((time - passes).abs() < most, "{method:?} {tolerance}: {time} {passes}");
                    let last = samples[1].state;
                    assert!(samples.len() == 2 && last.time == time);
                    let [w, ..] = (rest().inverse() * last.attitude).quaternion();
                    assert!(w.abs() < 1e-14, "{w}");
                }
            }
        }
    }
}

#[test]
fn a_spring_in_tumbling_motion_ends_at_one_time_at_all_tolerances() {
    let rotor = Rotor::free(&body());
    let push = TorqueModel::Constant(ConstantTorque::Space(Torque::new(0.11, -0.06, -1.36)));
    let omega = AngularVelocity::new(1.17, 1.45, -0.4);
    let start =
        State { time: 0.0, attitude: Attitude::from_quaternion([0.88, -0.11, 0.21, -0.41]).unwrap(), omega };
    for torsion in springs(1.9, Direction::new(0.3, -0.5, 0.9)) {
        let torques = [torsion, push.clone()];
        let ends = |method, tolerance| {
            let motion = Trajectory::compute(&rotor, &torques, start, &[30.0], method, tolerance).unwrap();
            let Ending::Failed { time, cause: MotionError::HalfTurn { .. } } = *motion.ending() else {
                panic!("{method:?} {tolerance}: {:?}", motion.ending())
            };
            time
        };
        let exact = ends(Method::Taylor, 1e-15);
        for tolerance in TOLERANCES {
            for method in METHODS {
                let time = ends(method, tolerance);
                assert!(
                    (time - exact).abs() < 1e3 * tolerance + 1e-12,
                    "{method:?} {tolerance}: {time} {exact}"
                );
            }
        }
        let splitting = ends(Method::Splitting { order: SplittingOrder::Six, step: 2.5e-4 }, 1e-13);
        assert!((splitting - exact).abs() < 1e-8, "{splitting} {exact}");
    }
}

#[test]
fn an_event_before_half_a_turn_wins() {
    let (rotor, start, axis, passes) = thrown(400_f64.to_radians(), 1.7);
    let angle = |torque: &TorqueModel, at: f64, action| {
        let TorqueModel::Torsion(torsion) = torque.clone() else { panic!() };
        // −cos ½θ is smooth beyond half a turn.
        let twist = EventFunction::new(move |state| {
            let [w, ..] = (torsion.rest().inverse() * state.attitude).quaternion();
            -w
        });
        Event::new("twist", Measure::Function(twist), -(0.5 * at).cos(), Sense::Rising, action).unwrap()
    };
    for torque in springs(1.7, axis) {
        for method in METHODS {
            for tolerance in TOLERANCES {
                let torques = [torque.clone()];
                let times = [9.0];
                let run = |action| {
                    let events = [angle(&torque, 3.1413, action)];
                    let simulation = Simulation::new(&rotor, &torques, start, &times).events(&events);
                    simulation.method(method).tolerance(tolerance).run().unwrap()
                };
                let stopped = run(EventAction::Stop);
                let Ending::Stopped { event: 0, time } = *stopped.ending() else {
                    panic!("{:?}", stopped.ending())
                };
                assert!((time - passes + 8.3e-5).abs() < 5e-5 + 50.0 * tolerance, "{time} {passes}");
                // After the switch-off it turns without limit.
                let off = run(EventAction::Switch { torque: 0, on: false });
                assert_eq!(*off.ending(), Ending::Complete, "{method:?} {tolerance}");
                let recorded = run(EventAction::Record);
                assert!(recorded.events().len() == 1 && !recorded.ending().is_complete());
            }
        }
    }
}

#[test]
fn a_twist_of_half_a_turn_at_the_start_is_not_determined() {
    let rotor = Rotor::free(&body());
    let axis = Direction::new(0.3, -0.5, 0.9).direction().unwrap();
    let attitude = Rotation::<Space, Space>::from_axis_angle(axis, std::f64::consts::PI).unwrap() * rest();
    let start = State { time: 2.0, attitude, omega: AngularVelocity::new(0.4, -0.7, 0.3) };
    for torque in springs(1.7, axis) {
        for method in METHODS {
            let torques = [torque.clone()];
            let motion = Trajectory::compute(&rotor, &torques, start, &[2.0, 3.0], method, 1e-13).unwrap();
            let cause = MotionError::HalfTurn { time: 2.0 };
            assert_eq!(*motion.ending(), Ending::Failed { time: 2.0, cause });
            assert_eq!(motion.samples().len(), 1);
        }
    }
}

#[test]
fn members_of_an_ensemble_end_at_half_a_turn_as_alone() {
    let stiffness = 1.7;
    let times: Vec<f64> = (0..=30).map(|k| 0.2 * f64::from(k)).collect();
    let members: Vec<Member> = (0..12)
        .map(|k| {
            let (rotor, start, axis, _) = thrown(2.4 + 0.13 * f64::from(k), stiffness);
            let [spring, wire] = springs(stiffness, axis);
            Member::new(rotor, vec![if k % 2 == 0 { spring } else { wire }], start)
        })
        .collect();
    let ensemble = Ensemble::new(members.clone()).unwrap();
    for method in METHODS {
        let found = ensemble.at(&times, method, 1e-9, NonZero::<usize>::MIN).unwrap();
        let mut failed = 0;
        for (k, member) in members.iter().enumerate() {
            let motion =
                Trajectory::compute(&member.rotor, &member.torques, member.start, &times, method, 1e-9)
                    .unwrap();
            let states = &found.states[k * times.len()..(k + 1) * times.len()];
            for (a, b) in states.iter().zip(motion.samples()).take(motion.samples().len() - 1) {
                assert_eq!(a.time, b.state.time);
                assert!(
                    a.attitude.angle_to(b.state.attitude) < 1e-13 && (a.omega - b.state.omega).norm() < 1e-13
                );
            }
            if let Ending::Failed { cause, .. } = motion.ending() {
                let failure = found.failures.iter().find(|failure| failure.member == k);
                assert_eq!(failure.map(|failure| &failure.cause), Some(cause));
                failed += 1;
            }
        }
        assert!(failed == found.failures.len() && failed > 3 && failed < 9, "{failed}");
    }
}
