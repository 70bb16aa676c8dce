//! Tests: every lane gives the same bits as its body alone, and fails where the body fails alone.

use super::*;
use crate::body::{InertiaTensor, MassProperties, Particle};
use crate::math::formula::{Binary, Formula, Instruction, Unary};
use crate::math::machine::in_narrower_vectors;
use crate::math::rotation::Attitude;
use crate::math::vector::{AngularVelocity, Direction, Position, Torque, Velocity};
use crate::math::{Acceleration, Force};
use crate::motion::model::orbit::Orbit;
use crate::motion::model::torque::{
    Attracted, ConstantTorque, Drag, DragLaw, EnergySink, FormulaTorque, GravityGradient, Magnetic,
    MagneticField, Thruster, Torsion, UniformGravity,
};
use crate::motion::model::wheel::{Motor, Wheel};
use crate::motion::run::simulation::Simulation;
use crate::motion::solve::method::Method;
use crate::motion::solve::propagate::taylor::acting::BatchKind;

/// Body, torques and start of a test scenario; different for each number k.
type Member = (Rotor, Vec<TorqueModel>, State);

/// Returns a number between 0 and 1, different for each k.
fn part(k: usize) -> f64 {
    (0.618 * k as f64 + 0.17).fract()
}

fn member(name: &str, k: usize) -> Member {
    let f = part(k);
    let products = [0.4, -0.3 * f, 0.2];
    let inertia = InertiaTensor::with_negative_products([3.1 + f, 4.2, 5.3], products).unwrap();
    let body = MassProperties::new(2.3, Position::new(0.11, -0.07 * f, 0.23), inertia).unwrap();
    let mut rotor = Rotor::free(&body);
    if name.starts_with("pivoted") {
        rotor = Rotor::pivoted(&body, Position::new(0.01, 0.02 - 0.1 * f, -0.2));
    }
    if name.ends_with("wheels") {
        let driven = Motor::Torque { inertia: 0.2, torque: 0.01 * f, schedule: None };
        let wheels = [([0.5, -0.3, 0.9], 3.0 + f, driven), ([-0.5, 0.3, 0.2], 1.0, Motor::HeldSpeed)];
        let wheels =
            wheels.map(|(axis, h, motor)| Wheel::new(Direction::from_array(axis), h, motor).unwrap());
        rotor = rotor.with_wheels(&wheels).unwrap();
    }
    let rest = Attitude::from_quaternion([0.8, 0.1 + 0.2 * f, -0.4, 0.5]).unwrap();
    let mut omega = AngularVelocity::new(0.3 + f, 0.5 - 2.0 * f, 0.2 * (1 + k % 5) as f64);
    if name.contains("at rest") && k.is_multiple_of(3) {
        omega = AngularVelocity::ZERO;
    }
    if name == "spring" || name == "wire" {
        omega = omega * 0.2;
    }
    // Some of them fail, in different ways.
    match k % 23 {
        3 => omega = AngularVelocity::new(f64::NAN, 0.0, 0.0),
        5 => omega = omega * 1e10,
        9 => omega = omega * 1e17,
        14 => omega = omega * 1e120,
        20 if rotor.wheels().is_empty() && !name.starts_with("pivoted") => {
            let rod = InertiaTensor::diagonal([0.0, 1.3, 1.3]).unwrap();
            rotor = Rotor::free(&MassProperties::new(2.3, Position::ZERO, rod).unwrap());
            omega = AngularVelocity::new(0.0, 0.3, 0.5 - f);
        }
        _ => {}
    }
    // The start is before the first of the times, or equal to it.
    let start = State { time: if k.is_multiple_of(4) { 0.5 } else { 0.4 * f }, attitude: rest, omega };
    (rotor, torques(name, f, rest), start)
}

fn torques(name: &str, f: f64, rest: Attitude) -> Vec<TorqueModel> {
    let gravity =
        || TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(0.3, -0.4, f - 9.1) });
    let circle = || {
        let (radial, motion) = (Direction::new(1.0, f, 0.2), Direction::new(-0.1, 1.0, f));
        Orbit::circular(0.25, 1.0 + f, radial, motion).unwrap()
    };
    let ellipse = || {
        let (position, velocity) = (Position::new(1.0 + f, 0.1, 0.2), Velocity::new(-0.1, 0.4, 0.1));
        Orbit::through(0.25, position, velocity, 0.3).unwrap()
    };
    let points = || {
        let points = [
            (1.5, [0.09, -0.02, 0.04]),
            (0.7, [-0.06, 0.11, 0.03]),
            (2.2, [0.01, 0.05, -0.13]),
            (1.1, [-0.08, -0.09, 0.02]),
        ];
        let points = points.map(|(m, p)| Particle::new(m * (1.0 + f), Position::from_array(p)).unwrap());
        Attracted::Points(points.to_vec())
    };
    let gradient =
        |orbit, attracted| TorqueModel::GravityGradient(Box::new(GravityGradient { orbit, attracted }));
    let drag = |jacobian| {
        let matrix = [[0.05 + 0.1 * f, 0.01, 0.0], [0.01, 0.07, -0.02], [0.0, -0.02, 0.04]];
        TorqueModel::Drag(Drag::new(jacobian, matrix).unwrap())
    };
    let magnet = |field| {
        TorqueModel::Magnetic(Box::new(Magnetic { moment: Direction::new(0.3, -0.2, 0.5 + f), field }))
    };
    let uniform = || MagneticField::Uniform(Direction::new(0.3, 0.2, f - 0.9));
    let dipole = Direction::new(1e6, 2e6, -3e6 * f);
    let sink = || TorqueModel::EnergySink(EnergySink::new(0.01 + 0.02 * f).unwrap());
    match name {
        "free" | "wheels" => vec![],
        "body" => vec![TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.1, 0.2 + f, -0.3)))],
        "space" => vec![TorqueModel::Constant(ConstantTorque::Space(Torque::new(0.1, 0.2 + f, -0.3)))],
        "thruster" => {
            let (position, force) = (Position::new(0.3, 0.2, 0.1 + f), Force::new(0.1, 0.5, -0.2));
            vec![TorqueModel::Thruster(Thruster { position, force })]
        }
        "pivoted" | "pivoted with wheels" => vec![gravity()],
        "gradient on a circle" => vec![gradient(circle(), Attracted::Tensor)],
        "gradient" | "gradient of wheels" => vec![gradient(ellipse(), Attracted::Tensor)],
        "points on a circle" => vec![gradient(circle(), points())],
        "points" => vec![gradient(ellipse(), points())],
        "drag" => vec![drag(DragLaw::Linear)],
        "quadratic drag" | "quadratic drag at rest" => vec![drag(DragLaw::Quadratic)],
        "pivoted, quadratic drag, at rest" => vec![drag(DragLaw::Quadratic), gravity()],
        "magnet" => vec![magnet(uniform())],
        "dipole on a circle" => vec![magnet(MagneticField::Dipole { dipole, orbit: circle() })],
        "dipole" => vec![magnet(MagneticField::Dipole { dipole, orbit: ellipse() })],
        "sink" => vec![sink()],
        "spring" => vec![TorqueModel::Torsion(Torsion::spring(1.7 + f, rest).unwrap())],
        "wire" => {
            vec![TorqueModel::Torsion(Torsion::wire(1.7, rest, Direction::new(0.3, -0.5, 0.9 + f)).unwrap())]
        }
        "formula" => {
            // sin t, f − ωx, f
            let [t, rate] = [0, 1].map(Instruction::Variable);
            let [sine, less] = [Instruction::Unary(Unary::Sin), Instruction::Binary(Binary::Subtract)];
            let one = Formula::new([t, sine]).unwrap();
            let two = Formula::new([Instruction::Constant(f), rate, less]).unwrap();
            vec![TorqueModel::Formula(Box::new(FormulaTorque::Body([one, two, Formula::constant(f)])))]
        }
        "saturated" | "pivoted, saturated, at rest" => {
            // −f tanh 3ω, or its arctangent
            let function = if name == "saturated" { Unary::Tanh } else { Unary::Atan };
            let times = Instruction::Binary(Binary::Multiply);
            let along = |k: usize| {
                let (factor, scale) = (Instruction::Constant(-f), Instruction::Constant(3.0));
                let rate = Instruction::Variable(1 + k);
                Formula::new([factor, scale, rate, times, Instruction::Unary(function), times]).unwrap()
            };
            let law = FormulaTorque::Body([0, 1, 2].map(along));
            let wave = Formula::new([Instruction::Variable(0), Instruction::Unary(Unary::Sin)]).unwrap();
            let zero = || Formula::constant(0.0);
            let wave = FormulaTorque::Body([wave, zero(), zero()]);
            let mut torques = vec![TorqueModel::Formula(Box::new(law))];
            if name == "saturated" {
                torques.push(TorqueModel::Formula(Box::new(wave)));
            } else {
                torques.push(gravity());
            }
            torques
        }
        _ => vec![sink(), gravity(), drag(DragLaw::Linear), magnet(uniform())],
    }
}

const KINDS: [&str; 27] = [
    "free",
    "wheels",
    "body",
    "space",
    "thruster",
    "pivoted",
    "pivoted with wheels",
    "gradient on a circle",
    "gradient",
    "gradient of wheels",
    "points on a circle",
    "points",
    "drag",
    "quadratic drag",
    "quadratic drag at rest",
    "pivoted, quadratic drag, at rest",
    "magnet",
    "dipole on a circle",
    "dipole",
    "sink",
    "spring",
    "wire",
    "formula",
    "saturated",
    "pivoted, saturated, at rest",
    "pivoted, four torques",
    "four torques and wheels",
];

/// Times within steps and at their ends, close together and far apart.
const TIMES: [f64; 9] = [0.5, 0.6, 0.61, 0.9, 1.7, 1.7000001, 4.0, 4.5, 9.0];

fn bits(state: &State) -> [u64; 8] {
    let ([w, x, y, z], [a, b, c]) = (state.attitude.quaternion(), state.omega.to_array());
    [state.time, w, x, y, z, a, b, c].map(f64::to_bits)
}

fn bodies(members: &[Member]) -> Vec<BatchBody<'_>> {
    let acting = |(rotor, torques, _): &Member| Acting::of(rotor, torques).unwrap();
    members.iter().map(|member| BatchBody::new(&member.0, &member.1, member.2, acting(member))).collect()
}

/// Compares a batch with each body alone. Returns the numbers of bodies that succeed and that fail.
fn compare(members: &[Member], times: &[f64], tolerance: f64) -> [usize; 2] {
    let bodies = bodies(members);
    let nothing = State { time: -1.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };
    let mut states = vec![nothing; bodies.len() * times.len()];
    let failures = advance(bodies.iter(), times, tolerance, &mut states);
    for (k, body) in bodies.iter().enumerate() {
        let BatchBody { rotor, torques, start, .. } = *body;
        let alone = |times: &[f64]| {
            Simulation::new(rotor, torques, start, times).method(Method::Taylor).tolerance(tolerance).states()
        };
        let got = &states[k * times.len()..(k + 1) * times.len()];
        let cause = failures.iter().find(|(body, _)| *body == k).map(|(_, cause)| cause);
        match alone(times) {
            Ok(want) => {
                assert!(cause.is_none(), "{k}: {cause:?}");
                for (got, want) in got.iter().zip(&want) {
                    assert_eq!(bits(got), bits(want), "{k}: {got:?} {want:?}");
                }
            }
            Err(want) => {
                // NaN is not equal to itself, so the texts are compared
                assert_eq!(format!("{:?}", Some(want)), format!("{cause:?}"), "{k}");
                // The last good state is repeated.
                let last = got.last().map_or(start.time, |state| state.time);
                for (got, time) in got.iter().zip(times) {
                    assert!(got.time == time.min(last), "{k}: {got:?} at {time}, to {last}");
                }
            }
        }
    }
    [bodies.len() - failures.len(), failures.len()]
}

#[test]
fn every_kind_has_the_bits_that_each_body_has_alone() {
    for name in KINDS {
        for (count, tolerance) in [(1, 1e-15), (7, 1e-3), (8, 1e-12), (9, 1e-15), (100, 1e-8)] {
            let members: Vec<Member> = (0..count).map(|k| member(name, k)).collect();
            let kinds: Vec<_> = members.iter().map(|(rotor, torques, _)| kind(rotor, torques)).collect();
            assert!(kinds[0].is_some() && kinds.iter().all(|kind| *kind == kinds[0]), "{name}: {kinds:?}");
            let [good, failed] = compare(&members, &TIMES, tolerance);
            assert!(count < 100 || good > 30 && failed > 5, "{name}: {good} {failed}");
        }
    }
}

#[test]
fn no_times_and_none_but_the_start() {
    let members: Vec<Member> = (0..19).map(|k| member("pivoted", k)).collect();
    // Only the start that is NaN fails.
    assert_eq!(compare(&members, &[], 1e-12), [18, 1]);
    let at_start: Vec<Member> = (0..20).step_by(4).map(|k| member("magnet", k)).collect();
    compare(&at_start, &[0.5, 0.5], 1e-12);
    assert_eq!(advance(core::iter::empty(), &TIMES, 1e-12, &mut []), []);
}

#[test]
fn a_tolerance_out_of_range_fails_every_body() {
    let members: Vec<Member> = (0..3).map(|k| member("free", k)).collect();
    for tolerance in [0.0, f64::NAN, 1.0] {
        assert_eq!(compare(&members, &TIMES, tolerance), [0, 3]);
    }
}

/// Function that advances a batch, if this machine has the instructions.
type Vehicle = fn(Advance<'_, '_>) -> Option<Vec<(usize, MotionError)>>;

#[test]
fn narrower_vectors_and_none_have_the_same_bits() {
    // Registers of two numbers have no fused multiply–add on this kind of machine, so their bits
    // differ.
    let narrower: [Vehicle; 1] = [|work| in_narrower_vectors(work)];
    for name in ["free", "pivoted, four torques", "gradient", "quadratic drag at rest", "spring"] {
        let members: Vec<Member> = (0..20).map(|k| member(name, k)).collect();
        let bodies = bodies(&members);
        let nothing = vec![bodies[0].start; 20 * TIMES.len()];
        let mut widest = nothing.clone();
        let one = advance(bodies.iter(), &TIMES, 1e-10, &mut widest);
        for run in narrower {
            let mut states = nothing.clone();
            let bodies: Vec<_> = bodies.iter().collect();
            let work = Advance { bodies: &bodies, times: &TIMES, tolerance: 1e-10, states: &mut states };
            let Some(mut two) = run(work) else { continue };
            two.sort_by_key(|(body, _)| *body);
            assert_eq!(format!("{one:?}"), format!("{two:?}"));
            for (a, b) in widest.iter().zip(&states) {
                assert_eq!(bits(a), bits(b), "{name}");
            }
        }
    }
}

#[test]
fn what_changes_on_its_way_and_what_has_no_series_goes_alone() {
    let (rotor, torques, _) = member("pivoted", 1);
    let scheduled = crate::motion::model::torque::TorqueModel::Scheduled(Box::new(
        crate::motion::model::torque::Scheduled {
            torque: torques[0].clone(),
            schedule: crate::motion::model::torque::Schedule::window(1.0, 2.0).unwrap(),
        },
    ));
    assert_eq!(kind(&rotor, &[scheduled]), None);
    let rough = Formula::new([Instruction::Variable(0), Instruction::Unary(Unary::Abs)]).unwrap();
    let rough = FormulaTorque::Body([rough, Formula::constant(0.0), Formula::constant(0.0)]);
    assert_eq!(kind(&rotor, &[TorqueModel::Formula(Box::new(rough))]), None);
    let schedule = Some(crate::motion::model::torque::Schedule::window(1.0, 2.0).unwrap());
    let motor = Motor::Torque { inertia: 0.1, torque: 0.1, schedule };
    let wheel = Wheel::new(Direction::new(0.0, 0.6, 0.8), 1.0, motor).unwrap();
    assert_eq!(kind(&rotor.with_wheels(&[wheel]).unwrap(), &[]), None);
}

fn kind(rotor: &Rotor, torques: &[TorqueModel]) -> Option<BatchKind> {
    Some(Acting::of(rotor, torques)?.kind.clone())
}
