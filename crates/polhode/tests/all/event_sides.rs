//! The side of an event's value on which a motion is, where torques change: a passage is neither
//! lost nor counted twice.

use crate::common::free_body;
use polhode::math::{Position, quantity};
use polhode::motion::torque::{Drag, DragLaw, Magnetic, MagneticField, Schedule, Scheduled, Torsion};
use polhode::motion::{Ending, EventAction, Measure, Run, Sense};
use polhode::prelude::*;

const METHODS: [Method; 2] = [Method::Taylor, Method::Dop853];

fn event(measure: Measure, value: f64, sense: Sense, action: EventAction) -> Event {
    Event::new("it", measure, value, sense, action).unwrap()
}

/// Returns an event of ω about z.
fn spin(value: f64, sense: Sense, action: EventAction) -> Event {
    event(Measure::OmegaBody(Direction::new(0.0, 0.0, 1.0)), value, sense, action)
}

const fn switch(torque: usize, on: bool) -> EventAction {
    EventAction::Switch { torque, on }
}

fn about_z(torque: f64) -> TorqueModel {
    TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, torque)))
}

fn within(torque: TorqueModel, from: f64, to: f64) -> TorqueModel {
    TorqueModel::Scheduled(Box::new(Scheduled { torque, schedule: Schedule::window(from, to).unwrap() }))
}

/// Returns a body of moments (2, 3.5, 5) that turns about z.
fn turning(start: f64, angle: f64, omega: f64) -> (Rotor, State) {
    let attitude = Attitude::from_axis_angle(Direction::new(0.0, 0.0, 1.0), angle).unwrap();
    (
        free_body([2.0, 3.5, 5.0]),
        State { time: start, attitude, omega: AngularVelocity::new(0.0, 0.0, omega) },
    )
}

/// Returns the events that happened: index, time since the start, and true if rising.
fn happened(motion: &Trajectory) -> Vec<(usize, f64, bool)> {
    let start = motion.start().state.time;
    motion.events().iter().map(|it| (it.event, it.state.time - start, it.rising)).collect()
}

#[track_caller]
fn assert_happened(motion: &Trajectory, wanted: &[(usize, f64, bool)], tolerance: f64) {
    let found = happened(motion);
    let is_close = found.len() == wanted.len()
        && found.iter().zip(wanted).all(|(a, b)| (a.0, a.2) == (b.0, b.2) && (a.1 - b.1).abs() <= tolerance);
    assert!(is_close, "{found:?} is not {wanted:?}");
}

#[test]
fn a_value_that_switches_a_torque_is_passed_again_soon_after() {
    // A spring about z and a push N: ψ̈ = (N − κ ψ)/I. The push ends at ω = v, where ψ = −ε. Then ω
    // rises to its maximum at ψ = 0 and crosses v at ψ = ε, (2/p) atan(ε p/v) later, p = √(κ/I).
    let (moment, stiffness, push, v) = (5.0, 1.7, 2.3, 0.6);
    let p = f64::sqrt(stiffness / moment);
    for (epsilon, start) in [(0.3, 0.0), (1e-2, 0.0), (1e-4, 0.0), (1e-6, 0.0), (1e-2, 1e5)] {
        // Backwards by 0.4 s from the switch: ψ = N/κ + a cos pt + b sin pt.
        let (center, a, b) = (push / stiffness, -epsilon - push / stiffness, v / p);
        let before = -0.4_f64;
        let (sin, cos) = (p * before).sin_cos();
        let (angle, omega) = (center + a * cos + b * sin, p * (b * cos - a * sin));
        let (rotor, state) = turning(start, angle, omega);
        let wire = Torsion::wire(stiffness, Attitude::identity(), Direction::new(0.0, 0.0, 1.0)).unwrap();
        let torques = [TorqueModel::Torsion(wire), about_z(push)];
        let events = [
            spin(v, Sense::Either, switch(1, false)),
            spin(v, Sense::Falling, EventAction::Record),
            spin(v, Sense::Rising, EventAction::Record),
        ];
        let again = 0.4 + 2.0 / p * (epsilon * p / v).atan();
        let wanted = [(0, 0.4, true), (2, 0.4, true), (0, again, false), (1, again, false)];
        for method in METHODS {
            let times = [start, start + 1.5];
            let motion = Simulation::new(&rotor, &torques, state, &times)
                .events(&events)
                .method(method)
                .run()
                .unwrap();
            // ω is parabolic after the switch: rounding of 1e-16 moves a passage by 1e-16/(p² ε).
            let tolerance = 2e-13 + 1e-15 / epsilon + 2e-16 * start / epsilon;
            assert_happened(&motion, &wanted, tolerance);
        }
    }
}

#[test]
fn a_magnetic_torque_that_is_switched_off_leaves_two_passages() {
    let part = |mass, center: [f64; 3], rows| {
        let inertia = InertiaTensor::from_matrix(rows).unwrap();
        MassProperties::new(mass, Position::from_array(center), inertia).unwrap()
    };
    let body = MassProperties::combined(&[
        part(
            2.776815078198507,
            [-0.1426738106335378, 0.11854695122020685, 0.043597213911579794],
            [
                [0.4148345925530225, -0.018816033463176028, 0.0012170849620350948],
                [-0.018816033463176028, 0.4157720148293257, -0.015032223411045305],
                [0.0012170849620350948, -0.015032223411045305, 0.43014832533775377],
            ],
        ),
        part(
            2.1301267447642713,
            [-0.10631170970655547, -0.15286048180583403, 0.09555054459677559],
            [
                [0.17794822296147156, -0.038454292829154614, 0.03183527801072166],
                [-0.038454292829154614, 0.2008178226785843, -0.04744246757880075],
                [0.03183527801072166, -0.04744246757880075, 0.17513722672013704],
            ],
        ),
        part(
            0.5646276688302359,
            [-0.00952286658294163, -0.055472539458437914, 0.1296434842376511],
            [
                [0.07929867419082857, -0.003749102994130335, 0.0024401244834801996],
                [-0.003749102994130335, 0.08571584213404326, -7.606018101484493e-05],
                [0.0024401244834801996, -7.606018101484493e-05, 0.08623154946251252],
            ],
        ),
    ])
    .unwrap();
    let attitude = [0.5981631598610908, -0.6850443710057548, 0.007597066474924863, -0.4157611435900432];
    let start = State {
        time: 0.0,
        attitude: Attitude::from_quaternion(attitude).unwrap(),
        omega: AngularVelocity::new(0.5429805302035187, 0.23443990954173471, -0.21690202639830466),
    };
    let magnetic = Magnetic {
        moment: Vector::from_array([1.1371589184362394, 0.05216637206908881, 0.3223009352773842]),
        field: MagneticField::Uniform(Vector::from_array([
            -0.058722228673646265,
            0.0057849280297637305,
            0.006431441788008505,
        ])),
    };
    let torques = [TorqueModel::Magnetic(Box::new(magnetic))];
    let rate = |action| event(Measure::Rate, 0.7460382732361684, Sense::Either, action);
    let events =
        [rate(switch(0, false)), event(Measure::Time, 2.377172013609328, Sense::Either, EventAction::Record)];
    let times: Vec<f64> = (0..=7800).map(|k| f64::from(k) * 1e-3).collect();
    for method in METHODS {
        let motion = Simulation::new(&Rotor::free(&body), &torques, start, &times)
            .events(&events)
            .method(method)
            .run()
            .unwrap();
        let passages: Vec<f64> =
            motion.events().iter().filter(|it| it.event == 0).map(|it| it.state.time).collect();
        // At the first crossing, the switch reverses |ω|: in the samples, |ω| − v changes its sign
        // only in the millisecond of the second.
        let above: Vec<bool> =
            motion.samples().iter().map(|s| s.state.omega.norm() > 0.7460382732361684).collect();
        let changes = (1..above.len()).filter(|&k| above[k] != above[k - 1]);
        let changes: Vec<usize> = changes.collect();
        let found: Vec<usize> = passages.iter().map(|t| (t / 1e-3).ceil() as usize).collect();
        assert_eq!(found[1..], changes, "{method:?}");
        assert!((passages[0] - 2.3424).abs() < 5e-5 && (passages[1] - 2.4381).abs() < 5e-5, "{passages:?}");
    }
}

/// Returns linear drag on a moment of 5 about z: ω̇ = (N − c ω)/5.
fn drag(coefficient: f64) -> TorqueModel {
    let matrix = [[coefficient, 0.0, 0.0], [0.0, coefficient, 0.0], [0.0, 0.0, coefficient]];
    TorqueModel::Drag(Drag::new(DragLaw::Linear, matrix).unwrap())
}

#[test]
fn a_motor_that_is_switched_off_at_a_value_turns_back_there_and_has_one_passage() {
    // ω = (N/c) (1 − e^(−c t/I)) up to v, then it decays: it touches v, and the event has happened
    // once.
    let (push, c, v) = (2.3, 0.7, 1.1);
    let reached = -5.0 / c * f64::ln(1.0 - v * c / push);
    for sense in [Sense::Either, Sense::Rising] {
        for start in [0.0, 1e6] {
            let (rotor, state) = turning(start, 0.3, 0.0);
            let torques = [about_z(push), drag(c)];
            let events = [spin(v, sense, switch(0, false)), spin(v, sense, EventAction::Record)];
            for method in METHODS {
                let times = [start, start + 9.0];
                let motion = Simulation::new(&rotor, &torques, state, &times)
                    .events(&events)
                    .method(method)
                    .run()
                    .unwrap();
                assert_happened(&motion, &[(0, reached, true), (1, reached, true)], 1e-13 + 1e-15 * start);
                let last = motion.samples().last().unwrap().state;
                let wanted = v * (-c / 5.0 * (9.0 - reached)).exp();
                assert!((last.omega.z - wanted).abs() < 1e-12 + 1e-15 * start, "{}", last.omega.z);
            }
        }
    }
}

#[test]
fn switching_on_and_off_at_one_value_ends_the_motion() {
    let (push, c, v) = (2.3, 0.7, 1.1);
    let reached = -5.0 / c * f64::ln(1.0 - v * c / push);
    let (rotor, state) = turning(0.0, 0.3, 0.0);
    let torques = [about_z(push), drag(c)];
    let relay = |low| [spin(v, Sense::Rising, switch(0, false)), spin(low, Sense::Falling, switch(0, true))];
    for method in METHODS {
        let times = [0.0, 1.0, 9.0];
        let run = |events: &[Event]| {
            Simulation::new(&rotor, &torques, state, &times).events(events).method(method).run().unwrap()
        };
        let motion = run(&relay(v));
        let Ending::Failed { time, cause } = motion.ending().clone() else { panic!("{:?}", motion.ending()) };
        assert_eq!(cause, MotionError::Chatter { event: 0, time });
        assert!((time - reached).abs() < 1e-13, "{time} {reached}");
        assert_happened(&motion, &[(0, reached, true), (1, reached, false)], 1e-13);
        let last = motion.samples().last().unwrap();
        assert!(last.state.time == time && motion.samples().len() == 3);
        assert!(cause.is_numerical() && cause.hint().is_some_and(|hint| hint.contains("dead band")));
        // With a dead band it is a relay: down from v to low by drag alone, up again by the push.
        let low = 0.9;
        let motion = run(&relay(low));
        assert_eq!(*motion.ending(), Ending::Complete);
        let down = 5.0 / c * f64::ln(v / low);
        let up = 5.0 / c * f64::ln((push / c - low) / (push / c - v));
        let first = happened(&motion);
        assert!(first.len() >= 3, "{first:?}");
        let wanted = [(0, reached, true), (1, reached + down, false), (0, reached + down + up, true)];
        for (found, wanted) in first.iter().zip(wanted) {
            assert!((found.0, found.2) == (wanted.0, wanted.2) && (found.1 - wanted.1).abs() < 1e-12);
        }
    }
}

#[test]
fn a_value_that_is_reached_where_a_schedule_changes_is_passed_or_not_by_what_comes_after() {
    // ω = N t/I is v at t₁, to rounding. After t₁ the push continues at another rate, ends, or is
    // reversed.
    for (push, corner) in [(1.0, 1.0), (0.37, 2.9), (2.3, 0.7), (0.1, 3.3), (7.7, 0.3), (1.3, 1.9)] {
        let v = push * corner / 5.0;
        for (after, count) in [(0.4, 1), (0.0, 0), (-0.6, 0)] {
            let (rotor, state) = turning(0.0, 0.3, 0.0);
            let torques = [within(about_z(push), 0.0, corner), within(about_z(after), corner, 9.0)];
            let events = [spin(v, Sense::Either, EventAction::Record)];
            for method in METHODS {
                let motion = Simulation::new(&rotor, &torques, state, &[0.0, 5.0])
                    .events(&events)
                    .method(method)
                    .run()
                    .unwrap();
                let wanted = [(0, corner, true)];
                assert_happened(&motion, &wanted[..count], 1e-14);
            }
        }
    }
}

#[test]
fn events_at_one_time_all_happen() {
    let record = EventAction::Record;
    let either = Sense::Either;
    for start in [0.0, 12.0, 1e6] {
        let (rotor, state) = turning(start, 0.3, 0.2);
        let (push, corner) = (1.3, 1.75);
        let torques = [within(about_z(push), start, start + corner), about_z(0.4), about_z(0.6)];
        // At the corner ω = 0.2 + 1.7 t/5. At the time of the switch, which two events of one
        // measure cause, a time event also happens.
        let middle = 0.5_f64;
        let rate = |t: f64| 0.2 + (push + 0.4) * t / 5.0;
        let events = [
            event(Measure::Time, start + corner, either, record),
            spin(rate(corner), either, record),
            spin(rate(middle), either, switch(2, true)),
            spin(rate(middle), either, switch(1, false)),
            spin(rate(middle), Sense::Falling, record),
            event(Measure::Time, start + middle, either, record),
            // The body does not start with this ω, and does not cross it either.
            spin(0.2, either, record),
        ];
        for method in METHODS {
            let times = [start, start + 4.0];
            let motion = Simulation::new(&rotor, &torques, state, &times)
                .switched_off(&[2])
                .events(&events)
                .method(method)
                .run()
                .unwrap();
            let mut found = happened(&motion);
            found.sort_by_key(|it| it.0);
            // From the middle on, the torque is 1.3 + 0.6.
            let second = middle + (rate(corner) - rate(middle)) * 5.0 / (push + 0.6);
            let wanted = [(0, corner), (1, second), (2, middle), (3, middle), (5, middle)];
            let tolerance = 1e-13 + 1e-15 * start;
            assert_eq!(found.len(), wanted.len(), "{method:?} {start}: {found:?}");
            for (found, wanted) in found.iter().zip(wanted) {
                assert!(
                    found.0 == wanted.0 && found.2 && (found.1 - wanted.1).abs() < tolerance,
                    "{found:?}"
                );
            }
        }
    }
}

#[test]
fn a_start_at_the_value_is_left_and_come_back_to_within_a_step() {
    // ω_x = A cos(Ω t + δ) of a symmetric body: at the start it falls, or rises, from its value, to
    // which it returns at −δ.
    let (axial, transverse) = (3.1, 1.7);
    let rotor = free_body([transverse, transverse, axial]);
    let rate = (axial - transverse) / transverse * 2.3;
    for delta in [-0.01_f64, -1e-4, -1e-6, 0.02, -2.9] {
        let (sin, cos) = delta.sin_cos();
        let omega = AngularVelocity::new(0.8 * cos, 0.8 * sin, 2.3);
        let start = State { time: 0.0, attitude: Attitude::identity(), omega };
        let measure = || Measure::OmegaBody(Direction::new(1.0, 0.0, 0.0));
        let events = [event(measure(), 0.8 * cos, Sense::Either, EventAction::Record)];
        // The other time with the same cosine is −δ, modulo a turn.
        let turn = std::f64::consts::TAU;
        let period = turn / rate;
        let back = (-2.0 * delta).rem_euclid(turn) / rate;
        for method in [Method::Auto, Method::Taylor, Method::Dop853] {
            let end = 0.9 * period;
            let motion = Simulation::new(&rotor, &[], start, &[0.0, end])
                .events(&events)
                .method(method)
                .run()
                .unwrap();
            let wanted: Vec<_> =
                [back].into_iter().filter(|t| *t < end).map(|t| (0, t, delta > 0.0)).collect();
            assert_happened(&motion, &wanted, 1e-13 + 1e-15 / delta.abs());
        }
    }
}

#[test]
fn a_motion_that_continues_another_loses_no_event_and_counts_none_twice() {
    // Stopped at an event, before it, and at its time.
    let body = MassProperties::new(
        2.0,
        Position::new(0.1, -0.2, 0.3),
        InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap(),
    )
    .unwrap();
    let whole = |events: Vec<Event>, times: Vec<f64>, method| {
        Scenario::new(body)
            .with_torques([
                drag(0.3),
                TorqueModel::Constant(ConstantTorque::Space(Torque::new(0.7, -1.1, 0.4))),
            ])
            .unwrap()
            .starting(State {
                time: 0.0,
                attitude: Attitude::identity(),
                omega: AngularVelocity::new(0.9, -0.4, 1.3),
            })
            .unwrap()
            .watching(events)
            .unwrap()
            .sampled(Run { times, method, tolerance: 1e-13 })
    };
    let n: Vector<quantity::Number, Body> = Direction::new(0.3, 1.0, -0.2);
    let watched = |action| {
        vec![
            event(Measure::OmegaBody(n), 0.1, Sense::Either, action),
            event(Measure::Nutation, 0.9, Sense::Either, EventAction::Record),
            event(Measure::Rate, 1.2, Sense::Either, EventAction::Record),
        ]
    };
    for method in METHODS {
        let all = whole(watched(EventAction::Record), vec![0.0, 12.0], method).simulate().unwrap().unwrap();
        let wanted = happened(&all);
        assert!(wanted.len() >= 4, "{wanted:?}");
        let splits = wanted.iter().map(|it| it.1).chain([1.0, 5.0]);
        for split in splits.flat_map(|t| [t, t - 4e-16 * t, t + 4e-16 * t]) {
            let scenario = whole(watched(EventAction::Record), vec![0.0, split], method);
            let first = scenario.simulate().unwrap().unwrap();
            let second =
                scenario.continued_after(&first, vec![split, 12.0]).unwrap().simulate().unwrap().unwrap();
            let mut found = happened(&first);
            found.extend(second.events().iter().map(|it| (it.event, it.state.time, it.rising)));
            assert_eq!(found.len(), wanted.len(), "{method:?} {split}: {found:?} {wanted:?}");
            for (a, b) in found.iter().zip(&wanted) {
                assert!((a.0, a.2) == (b.0, b.2) && (a.1 - b.1).abs() < 1e-11, "{a:?} {b:?}");
            }
        }
        // Stopped at each passage of the first event, and continued from there.
        let stopping = whole(watched(EventAction::Stop), vec![0.0, 12.0], method);
        let mut found = Vec::new();
        let mut motion = stopping.simulate().unwrap().unwrap();
        loop {
            found.extend(motion.events().iter().map(|it| (it.event, it.state.time, it.rising)));
            let Ending::Stopped { time, .. } = *motion.ending() else { break };
            motion =
                stopping.continued_after(&motion, vec![time, 12.0]).unwrap().simulate().unwrap().unwrap();
        }
        assert_eq!(found.len(), wanted.len(), "{method:?}: {found:?} {wanted:?}");
        for (a, b) in found.iter().zip(&wanted) {
            assert!((a.0, a.2) == (b.0, b.2) && (a.1 - b.1).abs() < 1e-11, "{a:?} {b:?}");
        }
    }
}
