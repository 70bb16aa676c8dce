//! Drag compared with closed forms, and with fixtures/damping.toml.

use crate::common::*;
use polhode::motion::torque::{Drag, DragLaw};
use polhode::prelude::*;

const METHODS: [Method; 2] = [Method::Taylor, Method::Dop853];

fn at(omega: [f64; 3]) -> State {
    let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    State { time: 0.0, attitude, omega: AngularVelocity::from_array(omega) }
}

fn drag(law: DragLaw, matrix: [[f64; 3]; 3]) -> TorqueModel {
    TorqueModel::Drag(Drag::new(law, matrix).unwrap())
}

fn diagonal(d: [f64; 3]) -> [[f64; 3]; 3] {
    [[d[0], 0.0, 0.0], [0.0, d[1], 0.0], [0.0, 0.0, d[2]]]
}

#[test]
fn drag_follows_the_reference() {
    for case in cases(&table("damping"), "case") {
        let name = case["name"].as_str().unwrap();
        let inertia = InertiaTensor::from_matrix(matrix(&case["inertia"])).unwrap();
        // The mass and its centre have no effect on a free body.
        let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
        let law = if case["law"].as_str() == Some("linear") { DragLaw::Linear } else { DragLaw::Quadratic };
        let torques = [drag(law, matrix(&case["drag"]))];
        for row in cases(case, "row") {
            let t = number(&row["t"]);
            for method in METHODS {
                let rotor = Rotor::free(&body);
                let motion = Trajectory::compute(&rotor, &torques, start(case), &[t], method, 1e-15).unwrap();
                let sample = motion.samples()[0];
                let omega = AngularVelocity::from_array(numbers(&row["omega"]));
                let scale = start(case).omega.norm();
                let error = (sample.state.omega - omega).norm() / scale;
                let angle = sample.state.attitude.angle_to(attitude(&row["attitude"]));
                assert!(error < 3e-14 && angle < 1e-13, "{name} {method:?} t = {t}: {error:e} {angle:e}");
                let drift = Drift::of(&motion).unwrap();
                assert!(drift.work_energy < 1e-13 && drift.momentum < 1e-13, "{name} {method:?}: {drift:?}");
                // The work equals the lost energy.
                assert!(sample.work < 0.0);
            }
        }
    }
}

#[test]
fn a_spherical_body_loses_its_spin_exponentially() {
    let rotor = free_body([1.7, 1.7, 1.7]);
    let torques = [drag(DragLaw::Linear, diagonal([0.3; 3]))];
    let start = at([0.9, -1.4, 2.1]);
    for method in METHODS {
        let times = [0.0, 0.3, 2.0, 11.0];
        let motion = Trajectory::compute(&rotor, &torques, start, &times, method, 1e-15).unwrap();
        for sample in motion.samples() {
            // ω = ω₀ e^(−c t/I)
            let want = start.omega * (-0.3 * sample.state.time / 1.7).exp();
            assert!((sample.state.omega - want).norm() < 2e-15 * start.omega.norm(), "{method:?}");
        }
    }
}

#[test]
fn quadratic_drag_about_a_principal_axis_is_a_hyperbola() {
    let rotor = free_body([1.1, 2.3, 3.1]);
    let torques = [drag(DragLaw::Quadratic, diagonal([0.2, 0.7, 0.4]))];
    let start = at([0.0, -1.4, 0.0]);
    for method in METHODS {
        let times = [0.3, 2.0, 11.0, 1e3, 1e6];
        let motion = Trajectory::compute(&rotor, &torques, start, &times, method, 1e-15).unwrap();
        for sample in motion.samples() {
            // ω = ω₀/(1 + D |ω₀| t/I)
            let slower = 1.0 + 0.7 * 1.4 * sample.state.time / 2.3;
            let want = -1.4 / slower;
            let error = (sample.state.omega.y - want).abs();
            assert!(error < 1e-14, "{method:?} t = {}: {error:e}", sample.state.time);
        }
    }
}

/// N against D ω |ω| from rest: ω = √(N/D) tanh(√(N D) t/I).
#[test]
fn a_body_starts_from_rest_under_quadratic_drag() {
    let rotor = free_body([1.1, 2.3, 3.1]);
    let torque = Torque::new(0.0, 0.6, 0.0);
    let torques = [
        drag(DragLaw::Quadratic, diagonal([0.2, 0.7, 0.4])),
        TorqueModel::Constant(ConstantTorque::Body(torque)),
    ];
    for method in METHODS {
        let motion =
            Trajectory::compute(&rotor, &torques, at([0.0; 3]), &[0.1, 1.0, 9.0], method, 1e-15).unwrap();
        for sample in motion.samples() {
            let want = (0.6_f64 / 0.7).sqrt() * ((0.6_f64 * 0.7).sqrt() * sample.state.time / 2.3).tanh();
            assert!((sample.state.omega.y - want).abs() < 1e-14, "{method:?} {:?}", sample.state);
        }
    }
    // A body at rest without another torque remains at rest.
    for method in METHODS {
        let motion = Trajectory::compute(&rotor, &torques[..1], at([0.0; 3]), &[5.0], method, 1e-15).unwrap();
        assert_eq!(motion.samples()[0].state.omega, AngularVelocity::ZERO);
    }
}

/// |ω| has a corner where ω passes through zero: ω falls as √(N/D) tan, then as −√(N/D) tanh.
#[test]
fn a_spin_that_reverses_under_quadratic_drag_does_not_stall() {
    let rotor = free_body([1.1, 2.3, 3.1]);
    let (n, d, i) = (0.6_f64, 0.7_f64, 2.3);
    let torques = [
        drag(DragLaw::Quadratic, diagonal([0.2, d, 0.4])),
        TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, -n, 0.0))),
    ];
    let (most, rate) = ((n / d).sqrt(), (n * d).sqrt() / i);
    let stops = (0.8 / most).atan() / rate;
    let omega = |t: f64| {
        let x = rate * (stops - t);
        most * if x > 0.0 { x.tan() } else { x.tanh() }
    };
    for method in METHODS {
        let times = [0.5 * stops, stops, 1.5 * stops, 20.0];
        let motion =
            Trajectory::compute(&rotor, &torques, at([0.0, 0.8, 0.0]), &times, method, 1e-15).unwrap();
        for sample in motion.samples() {
            let error = (sample.state.omega.y - omega(sample.state.time)).abs();
            assert!(error < 2e-14, "{method:?} t = {}: {error:e}", sample.state.time);
        }
        let statistics = motion.solution().statistics().unwrap();
        assert!(statistics.accepted < 200, "{method:?}: {statistics:?}");
    }
}

#[test]
fn both_integrators_agree_near_rest() {
    // A generic body whose rotation a torque in space reverses: ω comes close to zero, but not
    // through it.
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
    let rotor = Rotor::free(&body);
    let torques = [
        drag(DragLaw::Quadratic, [[0.9, 0.2, -0.1], [0.2, 0.5, 0.1], [-0.1, 0.1, 0.7]]),
        drag(DragLaw::Linear, diagonal([0.02, 0.01, 0.03])),
        TorqueModel::Constant(ConstantTorque::Space(Torque::new(-0.5, 0.3, 0.8))),
    ];
    let start = at([0.2, -0.9, 0.4]);
    let [a, b] = METHODS.map(|method| {
        let motion = Trajectory::compute(&rotor, &torques, start, &[2.0, 9.0, 30.0], method, 1e-15).unwrap();
        let drift = Drift::of(&motion).unwrap();
        assert!(drift.work_energy < 1e-12 && drift.momentum < 1e-12, "{method:?}: {drift:?}");
        motion
    });
    for (a, b) in a.samples().iter().zip(b.samples()) {
        assert!((a.state.omega - b.state.omega).norm() < 1e-12);
        assert!(a.state.attitude.angle_to(b.state.attitude) < 1e-12);
    }
}

#[test]
fn drag_about_the_line_of_a_rod_is_refused_and_across_it_is_not() {
    let rotor = free_body([0.0, 2.0, 2.0]);
    let start = at([0.5, 0.3, 0.2]);
    for method in METHODS {
        let across = [drag(DragLaw::Linear, diagonal([0.0, 0.1, 0.1]))];
        assert!(Trajectory::compute(&rotor, &across, start, &[1.0], method, 1e-12).is_ok());
        let about = [drag(DragLaw::Linear, diagonal([0.1; 3]))];
        let refused = Trajectory::compute(&rotor, &about, start, &[1.0], method, 1e-12);
        assert!(matches!(refused, Err(MotionError::TorqueWithoutInertia { .. })), "{method:?}");
    }
}
