//! Properties of all derivatives.

use polhode::motion::torque::{Drag, DragLaw, Magnetic, MagneticField, TorqueParameter, Torsion};
use polhode::prelude::*;

use super::{ELEMENTS, Problem, between, columns, cross, derivative, difference, differenced};

fn product(a: [[f64; 6]; 6], b: [[f64; 6]; 6]) -> [[f64; 6]; 6] {
    core::array::from_fn(|i| core::array::from_fn(|j| (0..6).map(|k| a[i][k] * b[k][j]).sum()))
}

fn gravity() -> TorqueModel {
    TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(1.1, -2.2, -8.7) })
}

#[test]
fn what_follows_one_after_the_other_multiplies() {
    let drag = TorqueModel::Drag(
        Drag::new(DragLaw::Quadratic, [[0.5, 0.1, 0.0], [0.1, 0.4, 0.2], [0.0, 0.2, 0.7]]).unwrap(),
    );
    let problem = Problem::pivoted(vec![gravity(), drag]);
    let whole = problem.derivatives(&[], &[1.7, 4.0]);
    let [middle, end] = whole.states[..] else { panic!() };
    let rest = Problem { start: middle.state, ..problem }.derivatives(&[], &[4.0]).states[0];
    let want = product(rest.by_start, middle.by_start);
    assert!(difference(end.by_start.as_flattened(), want.as_flattened()) < 1e-12);
    // S(t₂) = Φ S(t₁) + S
    let moved = product(rest.by_start, middle.by_inertia);
    let want: Vec<f64> =
        moved.as_flattened().iter().zip(rest.by_inertia.as_flattened()).map(|(a, b)| a + b).collect();
    assert!(difference(end.by_inertia.as_flattened(), &want) < 1e-12);
}

#[test]
fn a_free_motion_does_not_know_the_size_of_the_body() {
    let motion = Problem::free(Vec::new()).derivatives(&[], &[0.3, 5.0, 40.0]);
    for derivatives in motion.states {
        for row in derivatives.by_inertia {
            let scaled: f64 = row.iter().zip(ELEMENTS).map(|(a, b)| a * b).sum();
            assert!(scaled.abs() < 1e-11, "{scaled:e}");
        }
    }
}

#[test]
fn conservative_motions_are_symplectic() {
    // θ₁ · I δω₂ − θ₂ · I δω₁ + L · (θ₁ × θ₂) of two changes is conserved.
    let field = MagneticField::Uniform(Direction::new(0.9, -1.1, 0.4));
    let magnet = Magnetic { moment: Direction::new(0.3, 1.2, -0.7), field };
    let rest = Attitude::from_quaternion([0.5, -0.6, 1.0, 0.4]).unwrap();
    let spring = TorqueModel::Torsion(Torsion::spring(1.7, rest).unwrap());
    for torques in [vec![], vec![gravity()], vec![TorqueModel::Magnetic(Box::new(magnet)), spring]] {
        let problem = Problem::pivoted(torques);
        let rotor = problem.rotor();
        let motion = problem.derivatives(&[], &[0.3, 2.9]);
        let form = |k: usize| {
            let (state, all) = (motion.states[k].state, columns(&motion.states[k]));
            let momentum = rotor.angular_momentum(state.omega).to_array();
            let parts = |[a, b, c, d, e, f]: [f64; 6]| {
                ([a, b, c], rotor.angular_momentum(AngularVelocity::new(d, e, f)).to_array())
            };
            let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            let mut values = Vec::new();
            for one in &all[..6] {
                for other in &all[..6] {
                    let ((t1, l1), (t2, l2)) = (parts(*one), parts(*other));
                    values.push(dot(t1, l2) - dot(t2, l1) + dot(momentum, cross(t1, t2)));
                }
            }
            values
        };
        let error = difference(&form(1), &form(0));
        assert!(error < 1e-12, "{error:e}\n{:?}\n{:?}", form(1), form(0));
    }
}

#[test]
fn covariances_follow_the_derivatives() {
    let derivatives = Problem::free(vec![]).derivatives(&[], &[2.0]).states[0];
    let diagonal =
        |d: [f64; 6]| core::array::from_fn(|i| core::array::from_fn(|j| if i == j { d[i] } else { 0.0 }));
    let (start, inertia) = ([1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6], [1e-4, 2e-4, 3e-4, 4e-4, 5e-4, 6e-4]);
    let covariance = derivatives.covariance(&diagonal(start), &diagonal(inertia));
    for i in 0..6 {
        for j in 0..6 {
            let of = |m: &[[f64; 6]; 6], d: [f64; 6]| (0..6).map(|k| m[i][k] * d[k] * m[j][k]).sum::<f64>();
            let want = of(&derivatives.by_start, start) + of(&derivatives.by_inertia, inertia);
            assert!((covariance[i][j] - want).abs() < 1e-15 + 1e-12 * want.abs());
        }
    }
}

#[test]
fn a_joint_covariance_is_that_of_motions_that_differ_together() {
    let torque = |x: f64| TorqueModel::Constant(ConstantTorque::Body(Torque::new(x, -0.4, 0.7)));
    let problem = Problem::free(vec![torque(1.3)]);
    let (here, parameters) = (problem.states(&[2.0]), [TorqueParameter { torque: 0, name: "x" }]);
    let motion = problem.derivatives(&parameters, &[2.0]);
    let mut columns = differenced(&problem, &[2.0]);
    columns.push(derivative(
        |h| {
            let other = Problem { torques: vec![torque(1.3 + h)], ..problem.clone() };
            between(&here[0], &other.states(&[2.0])[0]).to_vec()
        },
        0.02,
    ));
    // Three directions in which start, tensor and torque vary together: Σ v vᵀ is mapped to
    // Σ (J v)(J v)ᵀ.
    let directions: Vec<Vec<f64>> =
        (0..3).map(|n| (0..13).map(|k| (f64::from(7 * n + 3 * k) * 0.61).sin()).collect()).collect();
    let sum = |of: &dyn Fn(&[f64]) -> f64| directions.iter().map(|v| of(v)).sum::<f64>();
    let joint: Vec<Vec<f64>> = (0..13).map(|i| (0..13).map(|j| sum(&|v| v[i] * v[j])).collect()).collect();
    let image = |v: &[f64], i: usize| v.iter().zip(&columns).map(|(v, column)| v * column[i]).sum::<f64>();
    let want: Vec<f64> = (0..36).map(|k| sum(&|v| image(v, k / 6) * image(v, k % 6))).collect();
    let got = motion.states[0].joint_covariance(&motion.by_parameters[0], &joint).unwrap();
    let error = difference(got.as_flattened(), &want);
    assert!(error < 1e-10, "{error:e}\n{got:?}\n{want:?}");
    assert_eq!(motion.states[0].joint_covariance(&[], &joint), None);
}

#[test]
fn what_has_no_derivatives_is_refused() {
    let unknown = [TorqueParameter { torque: 0, name: "stiffness" }];
    let problem = Problem::pivoted(vec![gravity()]);
    let rotor = problem.rotor();
    let refused = problem.simulation(&rotor, &[1.0]).run_with_derivatives(&unknown);
    assert!(matches!(refused, Err(MotionError::NoParameter { torque: 0, name: "stiffness" })));
    let refused =
        problem.simulation(&rotor, &[1.0]).run_with_derivatives(&[TorqueParameter { torque: 1, name: "x" }]);
    assert!(matches!(refused, Err(MotionError::NoParameter { torque: 1, .. })));
    let refused = problem.simulation(&rotor, &[1.0]).method(Method::Dop853).run_with_derivatives(&[]);
    assert!(matches!(refused, Err(MotionError::NoMotionDerivatives { .. })));
    let function = TorqueModel::function("f", |_, state| Torque::from_array(state.omega.to_array()) * -0.1);
    let problem = Problem::free(vec![function]);
    let refused = problem.simulation(&problem.rotor(), &[1.0]).run_with_derivatives(&[]);
    assert!(matches!(refused, Err(MotionError::NotSmooth { torque: 0, .. })));
    // Quadratic drag has no second derivative at rest, but a first one; 0/0 does not occur.
    let drag = Drag::new(DragLaw::Quadratic, [[0.5, 0.0, 0.0], [0.0, 0.4, 0.0], [0.0, 0.0, 0.7]]).unwrap();
    let mut problem = Problem::free(vec![TorqueModel::Drag(drag)]);
    problem.start.omega = AngularVelocity::ZERO;
    let refused = problem.simulation(&problem.rotor(), &[1.0]).run_with_derivatives(&[]);
    assert!(matches!(refused, Err(MotionError::NoMotionDerivatives { .. })), "{refused:?}");
    // The tensor of a rod.
    let line = InertiaTensor::diagonal([0.0, 1.0, 1.0]).unwrap();
    let rod = Rotor::free(&MassProperties::new(1.0, Position::ZERO, line).unwrap());
    let start = State { omega: AngularVelocity::new(0.0, 1.0, 2.0), ..problem.start };
    let refused = Simulation::new(&rod, &[], start, &[1.0]).run_with_derivatives(&[]);
    assert!(matches!(refused, Err(MotionError::NoMotionDerivatives { .. })));
}
