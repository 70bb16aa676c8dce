//! Splitting: its orders, its bounded energy error, and what it refuses.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use polhode::*;

/// A body with three distinct moments, products of inertia and an offset centre, held at a generic pivot.
fn heavy() -> Rotor {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
    Rotor::pivoted(&body, Position::new(-0.1, 0.2, -0.15))
}

fn gravity() -> TorqueModel {
    TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(1.1, -2.2, -8.7) })
}

fn start() -> State {
    let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    State { time: 0.3, attitude, omega: AngularVelocity::new(0.7, -1.1, 1.9) }
}

fn splitting(order: SplittingOrder, step: f64) -> Method {
    Method::Splitting { order, step }
}

fn run(rotor: &Rotor, torques: &[TorqueModel], start: State, times: &[f64], method: Method) -> Trajectory {
    Trajectory::compute(rotor, torques, start, times, method, 1e-15).unwrap()
}

#[test]
fn each_order_is_what_it_says() {
    let torques = [
        gravity(),
        TorqueModel::Constant(ConstantTorque::Space(Torque::new(0.3, -0.4, 0.2))),
        TorqueModel::Constant(ConstantTorque::Body(Torque::new(-0.1, 0.25, 0.15))),
    ];
    let end = 4.3;
    let rotor = heavy();
    let truth = run(&rotor, &torques, start(), &[end], Method::Taylor).samples()[0];
    for (order, steps) in [
        (SplittingOrder::Two, [200, 400, 800, 1600]),
        (SplittingOrder::Four, [20, 40, 80, 160]),
        (SplittingOrder::Six, [15, 30, 60, 120]),
    ] {
        let errors = steps.map(|n| {
            let step = (end - start().time) / f64::from(n);
            let sample = run(&rotor, &torques, start(), &[end], splitting(order, step)).samples()[0];
            let attitude = sample.state.attitude.angle_to(truth.state.attitude);
            let omega = (sample.state.omega - truth.state.omega).norm() / truth.state.omega.norm();
            attitude.max(omega)
        });
        println!("{order:?} {errors:?}");
        let slope = (errors[1] / errors[3]).log2() / 2.0;
        assert!((slope - f64::from(order.number())).abs() < 0.25, "{order:?}: {slope} {errors:?}");
    }
}
