//! Layouts of Taylor's recurrence, one for each kind of motion. Every layout with all its terms is
//! compared with DOP853, which evaluates the laws.

use polhode::motion::Orbit;
use polhode::motion::torque::{Attracted, Drag, DragLaw, GravityGradient};
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

fn at_end(rotor: &Rotor, torques: &[TorqueModel], method: Method, tolerance: f64) -> State {
    let attitude = Rotation::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    let start = State { time: 0.0, attitude, omega: AngularVelocity::new(0.9, -1.4, 0.6) };
    let simulation = Simulation::new(rotor, torques, start, &[3.0]).method(method).tolerance(tolerance);
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
