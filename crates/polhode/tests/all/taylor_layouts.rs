//! Layouts of Taylor's recurrence, one for each kind of motion. Every layout with all its terms is
//! compared with DOP853, which evaluates the laws.

use std::num::NonZero;

use polhode::math::formula::{Binary, Formula, Instruction, Unary};
use polhode::motion::torque::{
    Attracted, Drag, DragLaw, EnergySink, FormulaTorque, GravityGradient, TorqueAxes,
};
use polhode::motion::{Ensemble, Member, Motor, Orbit, StateVariables};
use polhode::prelude::*;

/// Returns a body with three distinct moments, all products, mass not 1, and the centre of mass off
/// the origin.
fn body() -> MassProperties<Body> {
    let inertia = InertiaTensor::with_negative_products([2.1, 2.9, 3.7], [0.31, -0.23, 0.17]).unwrap();
    MassProperties::new(1.7, Position::new(0.3, -0.2, 0.5), inertia).unwrap()
}

fn drag() -> TorqueModel {
    let c = [[0.21, 0.03, -0.02], [0.03, 0.11, 0.05], [-0.02, 0.05, 0.34]];
    TorqueModel::Drag(Drag::new(DragLaw::Linear, c).unwrap())
}

fn constant() -> TorqueModel {
    TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.4, -0.7, 0.2)))
}

fn gravity() -> TorqueModel {
    TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(1.3, -0.4, -2.2) })
}

fn gradient() -> TorqueModel {
    let orbit =
        Orbit::circular(0.81, 1.0, Direction::new(0.6, 0.0, 0.8), Direction::new(0.32, 0.6, -0.24)).unwrap();
    TorqueModel::GravityGradient(Box::new(GravityGradient { orbit, attracted: Attracted::Tensor }))
}

fn start(spin: f64) -> State {
    let attitude = Rotation::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    State { time: 0.0, attitude, omega: AngularVelocity::new(spin, -1.4, 0.6) }
}

fn at_end(rotor: &Rotor, torques: &[TorqueModel], method: Method, tolerance: f64) -> State {
    let simulation = Simulation::new(rotor, torques, start(0.9), &[3.0]).method(method).tolerance(tolerance);
    // The same motion with and without evidence.
    let (states, run) = (simulation.states().unwrap(), simulation.run().unwrap());
    let sample = run.samples()[0].state;
    assert_eq!(states[0].attitude.quaternion(), sample.attitude.quaternion());
    states[0]
}

#[test]
fn every_layout_has_the_motion_of_its_laws() {
    let (free, pivoted) = (Rotor::free(&body()), Rotor::pivoted(&body(), Position::ZERO));
    let cases: [(&str, &Rotor, Vec<TorqueModel>); 8] = [
        ("alone", &free, vec![constant()]),
        ("alone, damped", &free, vec![drag(), constant()]),
        ("carrying", &pivoted, vec![gravity()]),
        ("carrying, damped", &pivoted, vec![gravity(), drag(), constant()]),
        ("moving", &free, vec![gradient()]),
        ("moving, damped", &free, vec![gradient(), drag(), constant()]),
        ("general", &pivoted, vec![gravity(), gradient(), drag()]),
        ("general, with two gradients", &free, vec![gradient(), gradient(), constant()]),
    ];
    for (name, rotor, torques) in cases {
        let [one, other] = [(Method::Taylor, 1e-14), (Method::Dop853, 1e-14)]
            .map(|(method, tolerance)| at_end(rotor, &torques, method, tolerance));
        let angle = one.attitude.angle_to(other.attitude);
        let rate = (one.omega - other.omega).norm();
        assert!(angle < 1e-12 && rate < 1e-12, "{name}: {angle:e} rad, {rate:e} rad/s");
    }
}

/// Returns the formula of an expression in postfix notation: variables of the state, numbers,
/// functions and operators.
fn formula(text: &str) -> Formula {
    let of = |word: &str| match word {
        "+" => Instruction::Binary(Binary::Add),
        "-" => Instruction::Binary(Binary::Subtract),
        "*" => Instruction::Binary(Binary::Multiply),
        "/" => Instruction::Binary(Binary::Divide),
        "neg" => Instruction::Unary(Unary::Negate),
        "sin" => Instruction::Unary(Unary::Sin),
        "cos" => Instruction::Unary(Unary::Cos),
        "tan" => Instruction::Unary(Unary::Tan),
        "exp" => Instruction::Unary(Unary::Exp),
        "atan" => Instruction::Unary(Unary::Atan),
        "sqrt" => Instruction::Unary(Unary::Sqrt),
        name => match StateVariables::NAMES.iter().position(|known| *known == name) {
            Some(place) => Instruction::Variable(place),
            None => Instruction::Constant(name.parse().unwrap()),
        },
    };
    Formula::new(text.split(' ').map(of)).unwrap()
}

fn law(axes: TorqueAxes, components: [&str; 3]) -> TorqueModel {
    let components = components.map(formula);
    TorqueModel::Formula(Box::new(match axes {
        TorqueAxes::Body => FormulaTorque::Body(components),
        TorqueAxes::Space => FormulaTorque::Space(components),
    }))
}

/// Laws of which parts, or all, depend on time alone or are linear in the state, and laws that treat
/// the components alike.
fn laws() -> Vec<(&'static str, TorqueModel)> {
    use TorqueAxes::{Body, Space};
    vec![
        ("time alone", law(Body, ["0.3 t sin *", "0.2 t 0.4 * exp / t cos -", "0.1 t t * *"])),
        ("time, circles", law(Body, ["0.2 0.3 t * tan *", "t sin t t * 0.1 * cos *", "2 t + sqrt neg"])),
        ("time, in space", law(Space, ["0.3 t sin *", "0.1", "t 0.2 * cos"])),
        ("linear", law(Body, ["wy 0.3 * wx 0.2 * -", "Lz 0.1 * 0.4 +", "wX 0.2 * neg wz 2 / -"])),
        ("linear in a fixed vector", law(Body, ["r31 0.4 *", "r32 0.2 * wx 0.1 * -", "r33 neg 0.3 +"])),
        (
            "all kinds",
            law(
                Body,
                [
                    "t sin 0.2 * wx 0.3 * - wy wz * 0.1 * +",
                    "t 0.3 * cos wy wy * 0.2 * - r32 +",
                    "0.4 wz atan - 0.1 t * +",
                ],
            ),
        ),
        ("alike", law(Body, ["0.2 3 wx * atan * neg", "0.3 3 wy * atan * neg", "0.2 2 wz * atan * neg"])),
        ("alike, in circles", law(Body, ["wx sin 0.1 +", "wy sin 0.3 *", "wz 2 * sin wz -"])),
        ("alike, tangents", law(Body, ["0.1 wx * tan", "0.2 wy * tan", "0.3 wz * tan"])),
        (
            "alike, quotients",
            law(Body, ["wx 2 wy wy * + /", "wy 3 wz wz * + / neg", "wz 2 wx wx * + / t sin -"]),
        ),
        ("alike, times a number", law(Body, ["qw wx *", "qw wy * neg", "wz 0.2 * qw *"])),
        ("partly alike", law(Body, ["wx sin exp", "wy cos exp", "wz sin exp"])),
    ]
}

fn rotors() -> Vec<(&'static str, Rotor, Vec<TorqueModel>)> {
    let free = Rotor::free(&body());
    let motor = Motor::Torque { inertia: 0.21, torque: 0.35, schedule: None };
    let wheel = Wheel::new(Direction::new(0.6, -0.3, 0.9), 1.7, motor).unwrap();
    let sink = TorqueModel::EnergySink(EnergySink::new(0.02).unwrap());
    vec![
        ("alone", free.clone(), Vec::new()),
        ("damped", free.clone(), vec![drag(), constant()]),
        ("carrying", Rotor::pivoted(&body(), Position::ZERO), vec![gravity()]),
        ("moving", free.clone(), vec![gradient(), drag()]),
        ("with a wheel", free.clone().with_wheels(&[wheel]).unwrap(), vec![drag()]),
        ("with friction", free, vec![sink]),
    ]
}

#[test]
fn every_part_of_a_law_acts() {
    for (name, law) in laws() {
        for (layout, rotor, mut torques) in rotors() {
            torques.push(law.clone());
            let [one, other] = [(Method::Taylor, 1e-14), (Method::Dop853, 1e-14)]
                .map(|(method, tolerance)| at_end(&rotor, &torques, method, tolerance));
            let angle = one.attitude.angle_to(other.attitude);
            let rate = (one.omega - other.omega).norm() / other.omega.norm();
            assert!(angle < 4e-12 && rate < 4e-12, "{name}, {layout}: {angle:e} rad, {rate:e}");
        }
    }
}

/// The checks of work and impulse see every part, too.
#[test]
fn work_and_impulse_of_a_law_are_those_of_the_motion() {
    for (name, law) in laws() {
        for (layout, rotor, mut torques) in rotors().into_iter().take(4) {
            torques.push(law.clone());
            let run =
                Simulation::new(&rotor, &torques, start(0.9), &[3.0]).method(Method::Taylor).tolerance(1e-14);
            let run = run.run().unwrap();
            let (first, last) = (run.start(), &run.samples()[0]);
            let impulse = (last.momentum - first.momentum - last.impulse).norm();
            let work = last.kinetic_energy - first.kinetic_energy - last.work;
            assert!(impulse < 1e-12 && work.abs() < 1e-12, "{name}, {layout}: {impulse:e}, {work:e}");
        }
    }
}

#[test]
fn a_body_in_a_lane_has_the_bits_of_the_body_alone() {
    for (name, law) in laws() {
        for (layout, rotor, mut torques) in rotors() {
            torques.push(law.clone());
            let start = |k: u32| start(0.9 + 0.1 * f64::from(k));
            let member = |k: u32| Member::new(rotor.clone(), torques.clone(), start(k));
            let ensemble = Ensemble::new((0..7).map(member).collect()).unwrap();
            let found = ensemble.at(&[1.3], Method::Taylor, 1e-13, NonZero::<usize>::MIN).unwrap();
            for (k, state) in (0..7).zip(&found.states) {
                let alone = Simulation::new(&rotor, &torques, start(k), &[1.3]).method(Method::Taylor);
                let alone = alone.tolerance(1e-13).states().unwrap()[0];
                let bits = |state: &State| {
                    (state.omega.to_array().map(f64::to_bits), state.attitude.quaternion().map(f64::to_bits))
                };
                assert_eq!(bits(state), bits(&alone), "{name}, {layout}, member {k}");
            }
        }
    }
}
