//! Jacobians of torques, compared with differences of the torques at generic points.

use polhode::math::formula::{Binary, Formula, Instruction, Unary};
use polhode::math::{Scalar, VectorAlgebra};
use polhode::motion::StateVariables;
use polhode::motion::torque::{FormulaTorque, Schedule, Scheduled, TorqueJacobian};
use polhode::observe::SmallOscillations;
use polhode::prelude::*;

use crate::ensemble::{every_torque, start};

fn axes() -> [Direction<Body>; 3] {
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Direction::from_array)
}

/// Returns (f(h) − f(−h))/2h with errors of sixth order.
fn difference(f: impl Fn(f64) -> Torque<Body>, h: f64) -> Torque<Body> {
    let odd = |k: f64| f(k * h) - f(-k * h);
    (odd(1.0) * 45.0 - odd(2.0) * 9.0 + odd(3.0)) / (60.0 * h)
}

/// Returns the Jacobian by differences of the torque.
fn expected(torque: &TorqueModel, rotor: &Rotor, state: &State) -> [[Torque<Body>; 3]; 2] {
    let turned = |axis: Direction<Body>| {
        difference(
            |h| {
                let attitude = state.attitude * Rotation::<Body, Body>::from_axis_angle(axis, h).unwrap();
                torque.torque(rotor, &State { attitude, ..*state })
            },
            4e-3,
        )
    };
    let faster = |axis: Direction<Body>| {
        let omega = |h: f64| state.omega + AngularVelocity::from_array((axis * h).to_array());
        difference(|h| torque.torque(rotor, &State { omega: omega(h), ..*state }), 4e-3)
    };
    [axes().map(turned), axes().map(faster)]
}

fn agrees(name: &str, torque: &TorqueModel, rotor: &Rotor, state: &State, digits: f64) {
    let TorqueJacobian { by_attitude, by_omega, .. } = torque.jacobian(rotor, state).unwrap();
    let size = torque.torque(rotor, state).norm();
    for (found, expected) in [by_attitude, by_omega].into_iter().zip(expected(torque, rotor, state)) {
        for (found, expected) in found.into_iter().zip(expected) {
            let error = (found - expected).norm();
            assert!(error <= digits * (size + expected.norm()), "{name}: {found:?} {expected:?}");
        }
    }
}

#[test]
fn every_torque_has_its_derivatives() {
    for (name, rotor, torques) in every_torque() {
        for k in 0..4 {
            for torque in &torques {
                agrees(name, torque, &rotor, &start(k), 3e-11);
                // The same torque as a function, which is differentiated by differences.
                let copy = torque.clone();
                let function = TorqueModel::function("copy", move |rotor, state| copy.torque(rotor, state));
                agrees(name, &function, &rotor, &start(k), 1e-9);
            }
        }
    }
}

/// Returns Σ cₖ sin(xₖ + 0.1 k) of all variables of formulas, or the same inside an `if`.
fn of_all_variables(is_rough: bool) -> TorqueModel {
    use Instruction as I;
    let component = |seed: usize| {
        let mut all = vec![I::Constant(0.3)];
        for k in 0..StateVariables::COUNT {
            let weight = 0.1 + 0.07 * ((k * 5 + seed * 11) % 13) as f64;
            all.extend([I::Constant(weight), I::Variable(k), I::Constant(0.1 * k as f64)]);
            all.extend([I::Binary(Binary::Add), I::Unary(Unary::Sin), I::Binary(Binary::Multiply)]);
            all.push(I::Binary(Binary::Add));
        }
        if is_rough {
            all.splice(0..0, [I::Constant(1.0)]);
            all.extend([I::Constant(7.0), I::If]);
        }
        Formula::new(all).unwrap()
    };
    TorqueModel::Formula(Box::new(FormulaTorque::Space([component(0), component(1), component(2)])))
}

#[test]
fn formulas_of_every_variable_have_their_derivatives() {
    let (_, rotor, _) = every_torque().swap_remove(3);
    for (is_rough, digits) in [(false, 1e-10), (true, 1e-9)] {
        for k in 0..4 {
            agrees("formula", &of_all_variables(is_rough), &rotor, &start(k), digits);
        }
    }
}

#[test]
fn what_is_switched_off_has_none() {
    let torque = TorqueModel::own("tug", Tug(2.0));
    let schedule = Schedule::window(3.0, 4.0).unwrap();
    let later = TorqueModel::Scheduled(Box::new(Scheduled { torque, schedule }));
    let (_, rotor, _) = every_torque().swap_remove(0);
    let at = |time: f64| later.jacobian(&rotor, &State { time, ..start(1) }).unwrap().by_omega[0];
    assert_eq!(at(2.0), Torque::ZERO);
    assert!(at(3.5).norm() > 0.1);
}

/// Torque N = c |ω| ê, which has a corner at rest.
#[derive(Debug)]
struct Tug(f64);

impl Law for Tug {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        at.in_body(Direction::new(0.6, 0.0, 0.8)) * at.omega().norm().scaled(self.0)
    }
}

#[test]
fn corners_are_refused() {
    let (_, rotor, _) = every_torque().swap_remove(0);
    let rest = State { omega: AngularVelocity::ZERO, attitude: Attitude::identity(), time: 0.0 };
    let variable =
        |name| Instruction::Variable(StateVariables::NAMES.iter().position(|n| *n == name).unwrap());
    let zero = || Formula::new([Instruction::Constant(0.0)]).unwrap();
    let along_x = |formula: Vec<Instruction>| {
        TorqueModel::Formula(Box::new(FormulaTorque::Body([Formula::new(formula).unwrap(), zero(), zero()])))
    };
    let dry = TorqueModel::function("dry friction", |_, state| {
        Torque::from_array(state.omega.to_array().map(|x| if x == 0.0 { 0.0 } else { -0.1 * x.signum() }))
    });
    // θ is |δθ| near the identity.
    let nutation = along_x(vec![variable("theta"), Instruction::Unary(Unary::Sin)]);
    let size = along_x(vec![variable("wx"), Instruction::Unary(Unary::Abs)]);
    for torque in [TorqueModel::own("tug", Tug(1.0)), dry, nutation, size] {
        let refused = SmallOscillations::about_equilibrium(&rotor, core::slice::from_ref(&torque), rest);
        assert!(matches!(refused, Err(MotionError::NoDerivative { .. })), "{torque:?} {refused:?}");
    }
    // |ω| ω and similar functions have the derivative zero at rest.
    let smooth = along_x(vec![
        variable("wx"),
        Instruction::Unary(Unary::Abs),
        variable("wx"),
        Instruction::Binary(Binary::Multiply),
    ]);
    let hypot = along_x(vec![
        variable("wx"),
        variable("wy"),
        Instruction::Binary(Binary::Hypot),
        variable("wx"),
        Instruction::Binary(Binary::Multiply),
    ]);
    let drag = every_torque().swap_remove(6).2.swap_remove(0);
    for torque in [smooth, hypot, drag] {
        let jacobian = torque.jacobian(&rotor, &rest).unwrap();
        assert!(jacobian.by_omega.iter().all(|n| n.norm() < 1e-6), "{jacobian:?}");
    }
}

#[test]
fn modes_have_the_digits_of_their_derivatives() {
    // A rod held at its end: √(M g l/I).
    let inertia = InertiaTensor::diagonal([0.096, 0.099, 0.011]).unwrap();
    let stick = MassProperties::new(0.8, Position::ZERO, inertia).unwrap();
    let rotor = Rotor::pivoted(&stick, Position::new(0.0, 0.0, 0.6));
    let rest = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };
    let swings =
        SmallOscillations::about_equilibrium(&rotor, &[TorqueModel::Gravity(UniformGravity::STANDARD)], rest)
            .unwrap();
    for (mode, moment) in swings.modes.iter().zip([0.099, 0.096]) {
        let exact = (9.80665 * 0.6 / (moment / 0.8 + 0.36_f64)).sqrt();
        assert!((mode.frequency / exact - 1.0).abs() < 1e-14, "{} {exact}", mode.frequency);
    }
}
