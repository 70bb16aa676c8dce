//! Events compared with closed forms, and motions that cannot continue.

use crate::common::free_body;
use polhode::math::Velocity;
use polhode::math::formula::{Binary, Formula, Instruction, Unary};
use polhode::motion::torque::FormulaTorque;
use polhode::motion::{
    Crossing, Ending, EventAction, Measure, MethodReason, Orbit, Pendulum, Reference, Sense, SplittingOrder,
    StateVariables,
};
use polhode::prelude::*;

const METHODS: [Method; 2] = [Method::Taylor, Method::Dop853];
const TAU: f64 = std::f64::consts::TAU;

/// Returns a simulation from t = 0.7 without events, sampled at its ends.
fn simulation<'a>(
    rotor: &'a Rotor,
    torques: &'a [TorqueModel],
    omega: [f64; 3],
    times: &'a [f64],
) -> Simulation<'a> {
    let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    let start = State { time: times[0], attitude, omega: AngularVelocity::from_array(omega) };
    Simulation::new(rotor, torques, start, times).tolerance(1e-14)
}

fn run(simulation: Simulation<'_>) -> Trajectory {
    simulation.run().unwrap()
}

fn event(measure: Measure, value: f64, sense: Sense, action: EventAction) -> Event {
    Event::new("it", measure, value, sense, action).unwrap()
}

fn body_torque(n: [f64; 3]) -> TorqueModel {
    TorqueModel::Constant(ConstantTorque::Body(Torque::from_array(n)))
}

/// Returns the times of all crossings.
fn times(motion: &Trajectory) -> Vec<f64> {
    motion.events().iter().map(|crossing| crossing.state.time).collect()
}

#[track_caller]
fn close(found: &[f64], wanted: &[f64], tolerance: f64) {
    assert_eq!(found.len(), wanted.len(), "{found:?} {wanted:?}");
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found - wanted).abs() <= tolerance, "{found} is not {wanted}, by {:e}", found - wanted);
    }
}

#[test]
fn the_phase_of_a_symmetric_body_passes_at_its_times() {
    // ω_x = A cos(Ω (t − t0) + δ): Euler's equations of a body with two equal moments.
    let (axial, transverse) = (3.1, 1.7);
    let rotor = free_body([transverse, transverse, axial]);
    let omega: [f64; 3] = [0.9, -0.4, 2.3];
    let rate = (axial - transverse) / transverse * omega[2];
    let (amplitude, phase) = (omega[0].hypot(omega[1]), omega[1].atan2(omega[0]));
    let (start, end) = (0.7, 40.7);
    for value in [0.55, 0.0, -0.93] {
        // rising: ω_x = value with Ω (t − t0) + δ = −arccos(value/A)
        let first = ((-(value / amplitude).acos() - phase) / rate).rem_euclid(TAU / rate);
        let wanted: Vec<f64> =
            (0..).map(|k| start + first + TAU / rate * f64::from(k)).take_while(|t| *t <= end).collect();
        assert!(wanted.len() > 10);
        let x = Measure::OmegaBody(Direction::new(2.0, 0.0, 0.0));
        let events = [event(x, value, Sense::Rising, EventAction::Record)];
        for method in [Method::Auto, Method::Taylor, Method::Dop853] {
            let ends = [start, end];
            let motion = run(simulation(&rotor, &[], omega, &ends).events(&events).method(method));
            close(&times(&motion), &wanted, 3e-13);
            assert!(motion.events().iter().all(|crossing| crossing.rising && crossing.name == "it"));
            for crossing in motion.events() {
                assert!((crossing.state.omega.x - value).abs() < 3e-13);
            }
            assert_eq!(*motion.ending(), Ending::Complete);
        }
    }
}

#[test]
fn a_near_miss_is_none_and_a_near_touch_is_two() {
    // ω_x has the amplitude A. Just below it there are two close crossings at each crest, just
    // above it none.
    let rotor = free_body([1.7, 1.7, 3.1]);
    let omega: [f64; 3] = [0.9, -0.4, 2.3];
    let amplitude = omega[0].hypot(omega[1]);
    let rate = (3.1 - 1.7) / 1.7 * omega[2];
    for (part, each) in [(1.0 - 1e-9, 2), (1.0 - 1e-4, 2), (1.0 + 1e-9, 0)] {
        let x = Measure::OmegaBody(Direction::new(1.0, 0.0, 0.0));
        let events = [event(x, part * amplitude, Sense::Either, EventAction::Record)];
        for method in METHODS {
            let ends = [0.7, 60.7];
            let motion = run(simulation(&rotor, &[], omega, &ends).events(&events).method(method));
            let crests = (60.0 * rate / TAU) as usize;
            let count = motion.events().len();
            assert!(count >= each * crests && count <= each * (crests + 1), "{method:?} {part}: {count}");
            assert!(motion.events().chunks(2).all(|pair| pair[0].rising && !pair[1].rising));
        }
    }
}

#[test]
fn what_is_passed_twice_in_a_step_happens_once_where_it_stops() {
    // ω_x crosses 0.99 A twice at each crest, within one step.
    let rotor = free_body([1.7, 1.7, 3.1]);
    let omega: [f64; 3] = [0.9, -0.4, 2.3];
    let x = Measure::OmegaBody(Direction::new(1.0, 0.0, 0.0));
    let events = [event(x, 0.99 * omega[0].hypot(omega[1]), Sense::Either, EventAction::Stop)];
    for method in METHODS {
        let motion = run(simulation(&rotor, &[], omega, &[0.7, 60.7]).events(&events).method(method));
        let [crossing] = motion.events() else { panic!("{method:?}: {:?}", motion.events()) };
        assert_eq!(*motion.ending(), Ending::Stopped { event: 0, time: crossing.state.time });
    }
}

#[test]
fn a_spin_up_stops_at_its_rate() {
    // About a principal axis that is not a body axis, ω = N t / I.
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let rotor = Rotor::free(&MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap());
    let (axis, moment) = (rotor.principal().axis(1), rotor.principal().moments()[1]);
    let (torque, rate) = (0.37, 2.9);
    let push = [body_torque((axis * torque).to_array())];
    let events = [event(Measure::OmegaBody(axis * 3.0), rate, Sense::Rising, EventAction::Stop)];
    for method in METHODS {
        let ends = [0.0, 10.0, 1e3];
        let motion = run(simulation(&rotor, &push, [0.0; 3], &ends).events(&events).method(method));
        let wanted = moment * rate / torque;
        let Ending::Stopped { event: 0, time } = *motion.ending() else { panic!("{:?}", motion.ending()) };
        assert!((time / wanted - 1.0).abs() < 1e-14, "{method:?}: {time} is not {wanted}");
        let sampled: Vec<f64> = motion.samples().iter().map(|sample| sample.state.time).collect();
        assert_eq!(sampled, [0.0, 10.0, time]);
        let last = motion.samples().last().unwrap();
        assert!((last.state.omega.norm() / rate - 1.0).abs() < 1e-14);
        assert!((last.work / (0.5 * moment * rate * rate) - 1.0).abs() < 1e-13);
    }
}

#[test]
fn a_pendulum_is_upright_at_quarters_of_its_period() {
    let inertia = InertiaTensor::diagonal([0.05, 0.07, 0.06]).unwrap();
    let body = MassProperties::new(1.3, Position::new(0.0, 0.0, -0.4), inertia).unwrap();
    let rotor = Rotor::pivoted(&body, Position::ZERO);
    let weight = [TorqueModel::Gravity(UniformGravity::STANDARD)];
    let axis = Direction::new(1.0, 0.0, 0.0);
    let amplitude: f64 = 1.9;
    let gravity = Acceleration::new(0.0, 0.0, -9.80665);
    let period = Pendulum::hung(&rotor, axis, gravity).unwrap().period(amplitude);
    let attitude = Attitude::from_axis_angle(Direction::from_array(axis.to_array()), amplitude).unwrap();
    // The y axis of the rod is level when the rod hangs straight down: its angle to the vertical
    // passes 90°.
    let level =
        Measure::Tilt { body: Direction::new(0.0, 1.0, 0.0), space: Direction::new(0.0, 0.0, 1.0).into() };
    let events = [
        event(level.clone(), TAU / 4.0, Sense::Either, EventAction::Record),
        event(level, TAU / 4.0, Sense::Falling, EventAction::Record),
        event(Measure::TotalEnergy, 1e3, Sense::Either, EventAction::Record),
    ];
    for method in METHODS {
        let ends = [0.0, 3.0 * period];
        let start = State { time: 0.0, attitude, omega: AngularVelocity::ZERO };
        let motion = run(Simulation::new(&rotor, &weight, start, &ends)
            .tolerance(1e-14)
            .events(&events)
            .method(method));
        let at = |k: usize| times_of(&motion, k);
        let quarter = |k: u32| period * f64::from(2 * k + 1) / 4.0;
        close(&at(0), &(0..6).map(quarter).collect::<Vec<_>>(), 1e-13);
        // It starts with its y axis pointing up, less than 90° from the vertical: first the angle
        // rises.
        close(&at(1), &at(0).into_iter().skip(1).step_by(2).collect::<Vec<_>>(), 1e-13);
        assert!(at(2).is_empty());
    }
}

fn times_of(motion: &Trajectory, event: usize) -> Vec<f64> {
    let of = |crossing: &&Crossing| crossing.event == event;
    motion.events().iter().filter(of).map(|crossing| crossing.state.time).collect()
}

#[test]
fn a_relay_swings_between_its_rates() {
    // Bang-bang control: +N until ω = b, then −N until ω = a, … : a sawtooth of slope N/I.
    let inertia = [2.0, 3.5, 5.0];
    let rotor = free_body(inertia);
    let (n, low, high, end) = (0.8, -0.3, 0.9, 40.0);
    let torques = [body_torque([0.0, n, 0.0]), body_torque([0.0, -n, 0.0])];
    let rate = || Measure::OmegaBody(Direction::new(0.0, 1.0, 0.0));
    let switch = |torque, on| EventAction::Switch { torque, on };
    let events = [
        event(rate(), high, Sense::Rising, switch(0, false)),
        event(rate(), high, Sense::Rising, switch(1, true)),
        event(rate(), low, Sense::Falling, switch(1, false)),
        event(rate(), low, Sense::Falling, switch(0, true)),
    ];
    let slope = n / inertia[1];
    let rise = (high - low) / slope;
    let wanted: Vec<f64> = (0..)
        .map(|k| high / slope + f64::from(k) * rise)
        .take_while(|t| *t < end)
        .flat_map(|t| [t, t])
        .collect();
    let sampled: Vec<f64> = (0..=400).map(|k| f64::from(k) * 0.1).collect();
    for method in METHODS {
        let problem = simulation(&rotor, &torques, [0.0; 3], &sampled);
        let motion = run(problem.events(&events).switched_off(&[1]).method(method));
        close(&times(&motion), &wanted, 2e-13);
        assert_eq!(motion.samples().len(), 401);
        for sample in motion.samples() {
            let t = sample.state.time;
            let phase = (t - high / slope).rem_euclid(2.0 * rise);
            let rising = t < high / slope || phase > rise;
            let omega = match () {
                () if t < high / slope => slope * t,
                () if phase <= rise => high - slope * phase,
                () => low + slope * (phase - rise),
            };
            assert!((sample.state.omega.y - omega).abs() < 1e-13, "{t}: {}", sample.state.omega.y);
            assert_eq!(sample.torque.y, if rising { n } else { -n });
        }
        let drift = Drift::of(&motion).unwrap();
        assert!(drift.work_energy < 1e-13 && drift.momentum < 1e-13, "{drift:?}");
    }
}

/// Returns an ellipse with about the same period as the rotation of the body.
fn quick_orbit() -> Orbit {
    let (position, velocity) = (Position::new(0.7, 0.1, -0.4), Velocity::new(-0.3, 0.9, 0.2));
    Orbit::through(0.8, position, velocity, 0.0).unwrap()
}

#[test]
fn a_generic_motion_is_cut_and_goes_on_the_same() {
    // A switch without effect (a torque of zero) must not change the motion either.
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
    let rotor = Rotor::pivoted(&body, Position::new(-0.4, 0.9, 0.2));
    let torques = [TorqueModel::Gravity(UniformGravity::STANDARD), body_torque([0.0; 3])];
    let space = Direction::new(0.3, -0.5, 0.8);
    let measures = [
        Measure::OmegaSpace(space),
        Measure::Rate,
        Measure::KineticEnergy,
        Measure::Momentum,
        Measure::Tilt { body: Direction::new(1.0, 2.0, -0.5), space: space.into() },
        Measure::Tilt { body: Direction::new(1.0, 2.0, -0.5), space: Reference::Velocity(quick_orbit()) },
        Measure::OmegaAngle(Direction::new(0.2, -1.0, 0.4)),
        Measure::MomentumAngle(Direction::new(0.2, -1.0, 0.4)),
        Measure::Nutation,
        Measure::Precession,
        Measure::Spin,
    ];
    let ends = [0.0, 4.0];
    let omega = [1.3, -0.8, 2.1];
    let plain = run(simulation(&rotor, &torques, omega, &ends));
    for measure in measures {
        // A value that is crossed: that of the motion at a chosen time.
        let value = value_at(&rotor, &torques, omega, &measure, 1.234);
        let events = [
            event(measure.clone(), value, Sense::Either, EventAction::Record),
            event(measure.clone(), value, Sense::Either, EventAction::Switch { torque: 1, on: false }),
            event(measure.clone(), value, Sense::Rising, EventAction::Record),
            event(measure.clone(), value, Sense::Falling, EventAction::Record),
        ];
        for method in METHODS {
            let motion = run(simulation(&rotor, &torques, omega, &ends).events(&events).method(method));
            let [all, cut, up, down] = [0, 1, 2, 3].map(|k| times_of(&motion, k));
            assert!(all.iter().any(|t| (t - 1.234).abs() < 1e-11), "{measure:?}: {all:?}");
            close(&cut, &all, 1e-12);
            assert_eq!(up.len() + down.len(), all.len(), "{measure:?}");
            let [end, same] = [&motion, &plain].map(|m| m.samples().last().unwrap().state);
            assert!(end.attitude.angle_to(same.attitude) < 2e-12, "{measure:?}");
            assert!((end.omega - same.omega).norm() < 2e-12, "{measure:?}");
        }
    }
}

/// Returns the measure at a time, by bisection with events.
fn value_at(rotor: &Rotor, torques: &[TorqueModel], omega: [f64; 3], measure: &Measure, time: f64) -> f64 {
    let ends = [0.0, time];
    let motion = run(simulation(rotor, torques, omega, &ends));
    let Sample { state, momentum, kinetic_energy, .. } = *motion.samples().last().unwrap();
    let to_body = state.attitude.inverse();
    let [phi, theta, psi] = state.attitude.euler313();
    match measure {
        Measure::OmegaSpace(n) => n.direction().unwrap().dot(state.omega_space()),
        Measure::Rate => state.omega.norm(),
        Measure::KineticEnergy => kinetic_energy,
        Measure::Momentum => momentum.norm(),
        Measure::Tilt { body, space } => body.angle_to(to_body * space.direction(state.time)),
        Measure::OmegaAngle(n) => n.angle_to(state.omega),
        Measure::MomentumAngle(n) => n.angle_to(to_body * momentum),
        Measure::Nutation => theta,
        Measure::Precession => phi,
        Measure::Spin => psi,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_start_at_the_value_is_no_event() {
    let rotor = free_body([2.0, 3.5, 5.0]);
    let push = [body_torque([0.0, 0.0, 1.0])];
    for (value, wanted) in [(0.3, 0), (0.3 + 1e-9, 1)] {
        let z = Measure::OmegaBody(Direction::new(0.0, 0.0, 1.0));
        let events = [event(z, value, Sense::Either, EventAction::Record)];
        for method in METHODS {
            let ends = [0.0, 5.0];
            let motion =
                run(simulation(&rotor, &push, [0.0, 0.0, 0.3], &ends).events(&events).method(method));
            assert_eq!(motion.events().len(), wanted);
        }
    }
    // Time itself: crossed once, not at the start.
    let at = |t| event(Measure::Time, t, Sense::Either, EventAction::Record);
    let events = [at(1.0), at(3.3), at(7.0)];
    let ends = [1.0, 5.0];
    for method in [Method::Auto, Method::Taylor] {
        let motion = run(simulation(&rotor, &[], [0.1, 0.2, 3.0], &ends).events(&events).method(method));
        assert_eq!(times(&motion), [3.3]);
    }
}

#[test]
fn events_that_cannot_be_are_refused() {
    let new = |measure, value| Event::new("x", measure, value, Sense::Either, EventAction::Stop);
    let zero = Direction::ZERO;
    assert!(new(Measure::Time, f64::NAN).is_err());
    assert!(new(Measure::OmegaBody(zero), 1.0).is_err());
    assert!(new(Measure::Nutation, 0.0).is_err() && new(Measure::Nutation, 4.0).is_err());
    assert!(new(Measure::Precession, 4.0).is_ok());
    let rotor = free_body([2.0, 3.5, 5.0]);
    let ends = [0.0, 5.0];
    let refused = |torques: &[TorqueModel], event: Event| {
        simulation(&rotor, torques, [0.1, 0.2, 3.0], &ends).events(&[event]).run().unwrap_err()
    };
    let switch = event(Measure::Time, 1.0, Sense::Either, EventAction::Switch { torque: 1, on: false });
    assert!(matches!(refused(&[body_torque([1.0; 3])], switch), MotionError::ParameterOutOfRange { .. }));
    let energy = new(Measure::TotalEnergy, 1.0).unwrap();
    assert_eq!(refused(&[body_torque([1.0; 3])], energy), MotionError::NoPotential);
}

#[test]
fn what_cannot_go_on_keeps_what_is_good() {
    // 1e15 s at 3 rad/s: too many steps.
    let rotor = free_body([2.0, 3.5, 5.0]);
    let push = [body_torque([1e-3, 2e-3, -1e-3])];
    for method in METHODS {
        let ends = [0.0, 1.0, 1e15];
        let motion = run(simulation(&rotor, &push, [0.1, 0.2, 3.0], &ends).method(method));
        let Ending::Failed { time, cause: MotionError::TooManySteps { .. } } = *motion.ending() else {
            panic!("{:?}", motion.ending())
        };
        assert!(!motion.ending().is_complete());
        let sampled: Vec<f64> = motion.samples().iter().map(|sample| sample.state.time).collect();
        assert_eq!(sampled, [0.0, 1.0, time]);
        assert!(Drift::of(&motion).unwrap().work_energy < 1e-12);
    }
    // ω leaves the range of f64: only the start remains.
    let push = [body_torque([1e300, 2e300, -1e300])];
    for method in METHODS {
        let ends = [0.0, 1e10];
        let motion = run(simulation(&rotor, &push, [0.1, 0.2, 3.0], &ends).method(method));
        assert!(matches!(motion.ending(), Ending::Failed { .. }), "{:?}", motion.ending());
        assert!(motion.samples().iter().all(|sample| sample.kinetic_energy.is_finite()));
        assert!(!motion.samples().is_empty());
    }
}

#[test]
fn a_method_says_why_it_is_used() {
    let rotor = free_body([2.0, 3.5, 5.0]);
    let push = [body_torque([1e-3, 2e-3, -1e-3])];
    let ends = [0.0, 1.0];
    let why = |torques: &[TorqueModel], method| {
        let motion = run(simulation(&rotor, torques, [0.1, 0.2, 3.0], &ends).method(method));
        (motion.solution().name(), *motion.reason())
    };
    assert_eq!(
        why(&[], Method::Auto),
        ("exact", MethodReason::ClosedForm { title: "free motion by theta functions" })
    );
    assert_eq!(why(&[], Method::Exact), ("exact", MethodReason::Asked));
    let smooth =
        MethodReason::Smooth { no_closed_form: "a torque other than uniform gravity acts on the body" };
    assert_eq!(why(&push, Method::Auto), ("taylor", smooth));
    assert_eq!(why(&push, Method::Dop853), ("dop853", MethodReason::Asked));
}

/// Returns a torque along body z, by a formula.
fn formula_torque(z: &[Instruction]) -> TorqueModel {
    let nothing = || Formula::constant(0.0);
    let components = [nothing(), nothing(), Formula::new(z.iter().copied()).unwrap()];
    TorqueModel::Formula(Box::new(FormulaTorque::Body(components)))
}

fn variable(name: &str) -> Instruction {
    Instruction::Variable(StateVariables::NAMES.iter().position(|other| *other == name).unwrap())
}

#[test]
fn a_motion_that_runs_away_ends_where_it_is_still_right() {
    // N = k ω²: ω = ω₀/(1 − t/t₁), t₁ = I/(k ω₀), is infinite at t₁.
    let (k, spin, moment) = (0.7, 0.4, 5.0);
    let rotor = free_body([2.0, 3.5, moment]);
    let (w, times) = (variable("wz"), Instruction::Binary(Binary::Multiply));
    let push = [formula_torque(&[Instruction::Constant(k), w, times, w, times])];
    let last = moment / (k * spin);
    // For every duration of the run, with its end near t₁ or far beyond: steps shrink to zero
    // before ω is infinite.
    for (method, end) in METHODS.into_iter().flat_map(|method| [17.9, 50.0, 1e6].map(|end| (method, end))) {
        let sampled = [0.0, 5.0, 15.0, end];
        let motion = run(simulation(&rotor, &push, [0.0, 0.0, spin], &sampled).method(method));
        let Ending::Failed { time, cause: MotionError::RunAway { rate, most, time: at, .. } } =
            *motion.ending()
        else {
            panic!("{method:?}: {:?}", motion.ending())
        };
        // It ends before the numbers are absurd, and after they are no longer plausible.
        assert!((most / (1e3 * spin) - 1.0).abs() < 1e-12 && rate <= most && rate > 1e-2 * most, "{rate}");
        assert!(time == at && time < last && time > last * (1.0 - 0.1), "{time} {last}");
        assert_eq!(motion.samples().len(), 4);
        for sample in motion.samples() {
            let omega = spin / (1.0 - sample.state.time / last);
            assert!((sample.state.omega.z / omega - 1.0).abs() < 1e-12 * omega / spin, "{sample:?}");
        }
    }
}

#[test]
fn what_grows_by_much_and_not_without_bound_does_not_run_away() {
    // At rest, until a push with a bell-shaped time history: at its beginning the torque is nearly
    // zero.
    let rotor = free_body([2.0, 3.5, 5.0]);
    let op = Instruction::Binary;
    let bell = [
        Instruction::Constant(2e3),
        variable("t"),
        Instruction::Constant(5.0),
        op(Binary::Subtract),
        Instruction::Unary(Unary::Power(2)),
        Instruction::Unary(Unary::Negate),
        Instruction::Unary(Unary::Exp),
        op(Binary::Multiply),
    ];
    for method in METHODS {
        let push = [formula_torque(&bell)];
        let motion = run(simulation(&rotor, &push, [0.0; 3], &[0.0, 10.0]).method(method));
        assert_eq!(*motion.ending(), Ending::Complete, "{method:?}");
        // ∫ N dt = 2000 √π, except for the tails of the bell.
        let omega = 2e3 * std::f64::consts::PI.sqrt() / 5.0;
        assert!((motion.samples()[1].state.omega.z / omega - 1.0).abs() < 1e-10, "{motion:?}");
    }
}

#[test]
fn a_formula_that_is_no_number_ends_the_motion() {
    // N = √(1 − t) is NaN after 1 s.
    let rotor = free_body([2.0, 3.5, 5.0]);
    let (subtract, root) = (Instruction::Binary(Binary::Subtract), Instruction::Unary(Unary::Sqrt));
    let push = [formula_torque(&[Instruction::Constant(1.0), variable("t"), subtract, root])];
    for method in METHODS {
        let ends = [0.0, 0.5, 10.0];
        let motion = run(simulation(&rotor, &push, [0.3, 0.2, 1.0], &ends).method(method));
        let Ending::Failed { time, .. } = *motion.ending() else { panic!("{:?}", motion.ending()) };
        assert!(time > 1.0 - 1e-3 && time <= 1.0 + 1e-9, "{method:?}: {time}");
        let last = motion.samples().last().unwrap();
        assert_eq!(last.state.time, time);
        // ∫ √(1 − t) dt = ⅔ (1 − (1 − t)^{3/2})
        let impulse = 2.0 / 3.0 * (1.0 - (1.0 - time).max(0.0).powf(1.5));
        let gained = Drift::of(&motion).unwrap();
        assert!(gained.momentum < 1e-12 && last.work.is_finite() && impulse > 0.6);
    }
}

#[test]
fn what_has_corners_is_integrated_by_dop853() {
    let rotor = free_body([2.0, 3.5, 5.0]);
    let push = [body_torque([0.1; 3]), formula_torque(&[variable("wx"), Instruction::Unary(Unary::Abs)])];
    let ends = [0.0, 1.0];
    let at = |method| simulation(&rotor, &push, [0.3, 0.2, 1.0], &ends).method(method);
    let motion = run(at(Method::Auto));
    let rough = MethodReason::Rough {
        no_closed_form: "a torque other than uniform gravity acts on the body",
        torque: 1,
        why: "abs",
    };
    assert_eq!((motion.solution().name(), *motion.reason()), ("dop853", rough));
    assert!(rough.to_string().ends_with("torque 2 has no Taylor series, as it has abs"));
    let refused = at(Method::Taylor).run().unwrap_err();
    assert_eq!(refused, MotionError::NotSmooth { torque: 1, why: "abs" });
    assert!(!refused.is_numerical());
}

#[test]
fn splitting_has_events_too() {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
    let rotor = Rotor::pivoted(&body, Position::new(-0.4, 0.9, 0.2));
    let torques = [TorqueModel::Gravity(UniformGravity::STANDARD), body_torque([0.7, -0.2, 0.4])];
    let formula = Formula::new([variable("wx"), variable("wy"), Instruction::Binary(Binary::Hypot)]).unwrap();
    let off = EventAction::Switch { torque: 1, on: false };
    let events = [
        event(Measure::Formula(formula), 1.9, Sense::Either, EventAction::Record),
        event(Measure::Time, 1.2345, Sense::Rising, off),
    ];
    let ends = [0.0, 4.0];
    let splitting = Method::Splitting { order: SplittingOrder::Six, step: 1e-2 };
    let [a, b] = [Method::Taylor, splitting].map(|method| {
        run(simulation(&rotor, &torques, [1.3, -0.8, 2.1], &ends).events(&events).method(method))
    });
    assert!(a.events().len() > 2);
    close(&times(&b), &times(&a), 1e-8);
    let [end, same] = [&a, &b].map(|m| m.samples().last().unwrap().state);
    assert!(end.attitude.angle_to(same.attitude) < 1e-8);
}
