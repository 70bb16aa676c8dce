//! Derivatives of event times, and of motions with switches.

use polhode::math::formula::{Formula, Instruction, Unary};
use polhode::motion::torque::{Drag, DragLaw, TorqueParameter};
use polhode::motion::{Ending, EventAction, MU_EARTH, Measure, Motor, Orbit, Reference, Sense};
use polhode::prelude::*;

use super::{Problem, between, check, derivative, difference};

fn push() -> TorqueModel {
    TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.8, -1.7, 2.1)))
}

fn drag() -> TorqueModel {
    let matrix = [[0.5, 0.1, -0.05], [0.1, 0.4, 0.2], [-0.05, 0.2, 0.7]];
    TorqueModel::Drag(Drag::new(DragLaw::Linear, matrix).unwrap())
}

fn event(measure: Measure, value: f64, action: EventAction) -> Event {
    Event::new("event", measure, value, Sense::Either, action).unwrap()
}

/// Returns the first crossing: its time and state.
fn crossing(problem: &Problem) -> State {
    let rotor = problem.rotor();
    let motion = problem.simulation(&rotor, &[6.0]).method(Method::Taylor).tolerance(1e-15).run().unwrap();
    motion.events()[0].state
}

fn measures() -> Vec<(Measure, f64)> {
    let (body, space) = (Direction::new(0.3, -0.5, 0.9), Direction::new(-0.4, 0.2, 0.7));
    let orbit =
        Orbit::circular(MU_EARTH, 6.778e6, Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 0.6, 0.8))
            .unwrap();
    let slow =
        Orbit::circular(1.0, 1.5, Direction::new(1.0, 0.2, 0.0), Direction::new(0.0, 0.6, 0.8)).unwrap();
    let formula = Formula::new([
        Instruction::Variable(1),
        Instruction::Unary(Unary::Sin),
        Instruction::Variable(10),
        Instruction::Binary(polhode::math::formula::Binary::Add),
    ]);
    let mut all = vec![
        Measure::OmegaBody(body),
        Measure::OmegaSpace(space),
        Measure::Rate,
        Measure::KineticEnergy,
        Measure::Momentum,
        Measure::OmegaAngle(body),
        Measure::MomentumAngle(body),
        Measure::Nutation,
        Measure::Precession,
        Measure::Spin,
        Measure::Formula(formula.unwrap()),
    ];
    for space in [
        Reference::Space(space),
        Reference::Nadir(orbit),
        Reference::Velocity(slow.clone()),
        Reference::OrbitNormal(slow),
    ] {
        all.push(Measure::Tilt { body, space });
    }
    // The value of the measure at t = 1.2, which is therefore crossed there.
    let problem = problem(Vec::new());
    let rotor = problem.rotor();
    let state = problem.states(&[1.2])[0];
    let value = |measure: &Measure| -> f64 {
        let momentum = state.attitude.inverse() * rotor.angular_momentum_space(&state);
        let [phi, theta, psi] = state.attitude.euler313();
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        match measure {
            Measure::OmegaBody(n) => dot(n.to_array(), state.omega.to_array()) / n.norm(),
            Measure::OmegaSpace(n) => dot(n.to_array(), state.omega_space().to_array()) / n.norm(),
            Measure::Rate => state.omega.norm(),
            Measure::KineticEnergy => rotor.kinetic_energy(state.omega),
            Measure::Momentum => momentum.norm(),
            Measure::OmegaAngle(n) => n.angle_to(state.omega),
            Measure::MomentumAngle(n) => n.angle_to(momentum),
            Measure::Nutation => theta,
            Measure::Precession => phi,
            Measure::Spin => psi,
            Measure::Tilt { body, space } => {
                body.angle_to(state.attitude.inverse() * space.direction(state.time))
            }
            Measure::Formula(formula) => {
                formula.evaluate(&polhode::motion::StateVariables::of(&rotor, &state))
            }
            _ => f64::NAN,
        }
    };
    all.into_iter().map(|measure| (measure.clone(), value(&measure))).collect()
}

fn problem(events: Vec<Event>) -> Problem {
    let motor = Motor::Torque { inertia: 0.2, torque: 0.4, schedule: None };
    let wheels = vec![Wheel::new(Direction::new(-0.2, 1.0, 0.5), 0.9, motor).unwrap()];
    Problem { events, wheels, ..Problem::free(vec![push(), drag()]) }
}

#[test]
fn times_of_events_change_as_those_of_whole_runs() {
    for (measure, value) in measures() {
        let problem = problem(vec![event(measure.clone(), value, EventAction::Stop)]);
        let here = crossing(&problem);
        let parameters =
            [TorqueParameter { torque: 0, name: "y" }, TorqueParameter { torque: 1, name: "factor" }];
        let motion = problem.derivatives(&parameters, &[6.0]);
        let [crossed] = &motion.events[..] else { panic!("{measure:?}") };
        assert!(
            (crossed.state.state.time - here.time).abs() < 1e-12
                && matches!(motion.ending, Ending::Stopped { .. })
        );
        let of = |other: &Problem| {
            let there = crossing(other);
            let mut all = between(&here, &there).to_vec();
            all.push(there.time - here.time);
            all
        };
        let push = |h: f64| {
            let torques =
                vec![TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.8, -1.7 + h, 2.1))), drag()];
            Problem { torques, ..problem.clone() }
        };
        for column in 0..13 {
            let want = derivative(
                |h| if column < 12 { of(&problem.changed(column, h)) } else { of(&push(h)) },
                0.001,
            );
            let mut got = match column {
                0..6 => crossed.state.by_start.map(|row| row[column]).to_vec(),
                6..12 => crossed.state.by_inertia.map(|row| row[column - 6]).to_vec(),
                _ => crossed.by_parameters[0].to_vec(),
            };
            got.push(match column {
                0..6 => crossed.time_by_start[column],
                6..12 => crossed.time_by_inertia[column - 6],
                _ => crossed.time_by_parameters[0],
            });
            let error = difference(&got, &want);
            assert!(error < 1e-8, "{measure:?}, column {column}: {error:e}\n{got:?}\n{want:?}");
        }
    }
}

#[test]
fn a_switch_changes_the_motion_after_it() {
    // The push begins at a nutation and ends at a value of |ω|: two switches, with a sample between
    // them.
    let on = EventAction::Switch { torque: 0, on: true };
    let off = EventAction::Switch { torque: 0, on: false };
    let rising = |measure, value, action| Event::new("e", measure, value, Sense::Rising, action).unwrap();
    let wheeled = problem(Vec::new());
    let mut switched = Problem { switched_off: vec![0], ..wheeled };
    let body = Direction::new(0.3, -0.5, 0.9);
    let tilt = Measure::Tilt { body, space: Reference::Space(Direction::new(-0.4, 0.2, 0.7)) };
    let states = switched.states(&[1.0, 1.01]);
    let angle =
        |state: &State| body.angle_to(state.attitude.inverse() * Direction::<Space>::new(-0.4, 0.2, 0.7));
    let (angle, is_rising) = (angle(&states[0]), angle(&states[1]) > angle(&states[0]));
    let first =
        Event::new("on", tilt, angle, if is_rising { Sense::Rising } else { Sense::Falling }, on).unwrap();
    switched.events = vec![first, rising(Measure::Rate, 1.45, off)];
    let times = [0.8, 2.0, 6.0];
    let motion = switched.derivatives(&[], &times);
    assert!(motion.events.len() >= 2, "{:?}", motion.events.len());
    check("switched", &switched, &times, 1e-7);
    // An energy sink changes Ω discontinuously where it is switched on.
    let sink = TorqueModel::EnergySink(polhode::motion::torque::EnergySink::new(0.05).unwrap());
    let rate = Measure::OmegaBody(Direction::new(0.0, 0.0, 1.0));
    let value = Problem::free(vec![push()]).states(&[1.0])[0].omega.z;
    let problem = Problem {
        switched_off: vec![1],
        events: vec![event(rate, value, EventAction::Switch { torque: 1, on: true })],
        ..Problem::free(vec![push(), sink])
    };
    assert_eq!(problem.derivatives(&[], &times).events[0].event, 0);
    check("friction switched on", &problem, &times, 1e-7);
}

#[test]
fn two_switches_at_once_are_refused() {
    let value = Problem::free(vec![push(), drag()]).states(&[1.0])[0].omega.z;
    let rate = || Measure::OmegaBody(Direction::new(0.0, 0.0, 1.0));
    let events = [0, 1].map(|torque| event(rate(), value, EventAction::Switch { torque, on: false }));
    let problem = Problem { events: events.to_vec(), ..Problem::free(vec![push(), drag()]) };
    let refused = problem.simulation(&problem.rotor(), &[3.0]).run_with_derivatives(&[]);
    assert!(matches!(refused, Err(MotionError::NoMotionDerivatives { .. })), "{refused:?}");
}
