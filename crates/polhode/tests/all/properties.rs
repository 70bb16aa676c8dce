//! Properties of all bodies and all motions, tested with random inputs close to the limits.

use polhode::math::{Frame, quantity};
use polhode::prelude::*;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// Generates physical principal moments: generic, nearly equal, flat, needle-like, and at any
/// scale.
fn moments() -> impl Strategy<Value = [f64; 3]> {
    // second moments a, b, c ≥ 0 make i = (b + c, a + c, a + b)
    let second = prop_oneof![
        3 => (0.01..1.0, 0.01..1.0, 0.01..1.0),
        1 => (0.5..1.0, 0.0..1e-12_f64, 0.5..1.0).prop_map(|(a, d, c)| (a, a + d, c)),
        1 => (0.1..1.0, 0.1..1.0).prop_map(|(a, b)| (a, b, 0.0)),
        1 => (0.1..1.0, 1e-12..1e-6_f64, 1e-12..1e-6_f64),
    ];
    let scale = prop_oneof![4 => Just(1.0), 1 => Just(1e-140), 1 => Just(1e140), 1 => 1e-6..1e6];
    (second, scale).prop_map(|((a, b, c), s)| [(b + c) * s, (a + c) * s, (a + b) * s])
}

fn rotation<A: Frame, B: Frame>() -> impl Strategy<Value = Rotation<A, B>> {
    prop::array::uniform4(-1.0..1.0_f64)
        .prop_filter("a direction", |q| q.iter().map(|c| c * c).sum::<f64>() > 0.01)
        .prop_map(|q| Rotation::from_quaternion(q).unwrap())
}

fn vector<Q, F>(size: f64) -> impl Strategy<Value = Vector<Q, F>>
where
    Q: std::fmt::Debug,
    F: Frame,
{
    prop::array::uniform3(-size..size).prop_map(Vector::from_array)
}

/// Generates a tensor with arbitrary principal axes.
fn tensor() -> impl Strategy<Value = InertiaTensor<Body>> {
    (moments(), rotation::<Body, Part>())
        .prop_map(|(moments, r)| InertiaTensor::<Part>::diagonal(moments).unwrap().in_frame(r))
}

fn body() -> impl Strategy<Value = MassProperties<Body>> {
    (tensor(), vector(3.0), 0.1..10.0).prop_map(|(inertia, center, mass)| {
        // a mass that matches the size of the tensor, so that both terms of the parallel axis
        // theorem are significant
        let size = PrincipalFrame::of(&inertia).moments()[2];
        MassProperties::new(mass * size, center, inertia).unwrap()
    })
}

fn largest(m: [[f64; 3]; 3]) -> f64 {
    m.iter().flatten().fold(0.0, |max, x| max.max(x.abs()))
}

fn difference(a: [[f64; 3]; 3], b: [[f64; 3]; 3]) -> f64 {
    let mut d = a;
    for (row, other) in d.iter_mut().zip(b) {
        for (x, y) in row.iter_mut().zip(other) {
            *x -= y;
        }
    }
    largest(d) / largest(b)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, rng_seed: RngSeed::Fixed(11), ..ProptestConfig::default() })]

    #[test]
    fn the_principal_frame_rebuilds_the_tensor(t in tensor()) {
        let p = PrincipalFrame::of(&t);
        let [i1, i2, i3] = p.moments();
        prop_assert!(0.0 <= i1 && i1 <= i2 && i2 <= i3 && i3 - i2 - i1 <= 1e-13 * i3);
        // L = I ω along each axis is i ω
        for (k, i) in [i1, i2, i3].into_iter().enumerate() {
            let n = AngularVelocity::<Body>::from_array(p.axis(k).to_array());
            let residual = t * n - AngularMomentum::from_array((n * i).to_array());
            prop_assert!(residual.norm() < 4e-15 * i3, "{:e}", residual.norm() / i3);
        }
        let handedness = p.axis(0).dot(p.axis(1).cross(p.axis(2)));
        prop_assert!((handedness - 1.0).abs() < 2e-15);
        for k in 0..2 {
            let axis = p.axis(k);
            let sign = axis.to_array().into_iter().find(|c| c.abs() >= (1.0 - 1e-9) * axis.max_abs()).unwrap();
            prop_assert!(sign > 0.0);
        }
        // and its rotation maps principal to body components
        for (k, unit) in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].into_iter().enumerate() {
            prop_assert!((p.rotation() * Direction::from_array(unit) - p.axis(k)).norm() < 2e-15);
        }
    }

    #[test]
    fn moments_do_not_depend_on_the_axes(t in tensor(), r in rotation::<Part, Body>()) {
        let (a, b) = (PrincipalFrame::of(&t).moments(), PrincipalFrame::of(&t.in_frame(r)).moments());
        for k in 0..3 {
            prop_assert!((a[k] - b[k]).abs() < 4e-15 * a[2]);
        }
    }

    #[test]
    fn parallel_axes_compose(b in body(), p in vector(5.0), q in vector(5.0)) {
        // Huygens: the moment about an axis grows by M times the squared distance
        let n = Direction::<Body>::new(0.36, -0.48, 0.8);
        let lever = b.center_of_mass() - p;
        let distance2 = lever.dot(lever) - n.dot(lever).powi(2);
        let about = b.inertia_about(p).about_axis(n);
        let expected = b.inertia().about_axis(n) + b.mass() * distance2;
        prop_assert!((about - expected).abs() < 1e-14 * largest(b.inertia_about(p).matrix()));
        // from p to q through the centre of mass
        let back = MassProperties::from_inertia_about(b.mass(), b.center_of_mass(), &b.inertia_about(p)).unwrap();
        let whole = largest(b.inertia_about(p).matrix()) / largest(b.inertia_about(q).matrix());
        prop_assert!(difference(back.inertia_about(q).matrix(), b.inertia_about(q).matrix()) < 1e-14 * (1.0 + whole));
    }

    #[test]
    fn an_assembly_does_not_care_in_which_axes_it_is_joined(
        a in body(), r in rotation::<Part, Body>(), shift in vector(2.0),
    ) {
        let other = a.placed(shift, Rotation::identity()).unwrap();
        let joined = MassProperties::combined(&[a, other]).unwrap();
        let turned = MassProperties::combined(&[a.in_frame(r), other.in_frame(r)]).unwrap();
        prop_assert!(difference(turned.inertia().matrix(), joined.in_frame(r).inertia().matrix()) < 2e-14);
        prop_assert!((turned.center_of_mass() - r * joined.center_of_mass()).norm() < 1e-14);
    }

    #[test]
    fn matrices_and_euler_angles_come_back(r in rotation::<Space, Body>()) {
        prop_assert!(Attitude::from_matrix(r.matrix()).unwrap().angle_to(r) < 1e-15);
        prop_assert!(Attitude::from_euler313(r.euler313()).unwrap().angle_to(r) < 2e-15);
        prop_assert!((r * r.inverse()).angle() < 1e-15);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 120, failure_persistence: None, rng_seed: RngSeed::Fixed(11), ..ProptestConfig::default() })]

    #[test]
    fn any_motion_keeps_its_balances(
        b in body(), attitude in rotation::<Space, Body>(), omega in vector(3.0), pivot in vector(2.0),
        kind in 0..4, load in vector::<quantity::Torque, Space>(1.0),
    ) {
        // torques that match the scale of the body
        let scale = PrincipalFrame::of(b.inertia()).moments()[2];
        let (rotor, torques) = match kind {
            0 => (Rotor::free(&b), vec![]),
            1 => (Rotor::free(&b), vec![TorqueModel::Constant(ConstantTorque::Space(load * (0.1 * scale)))]),
            2 => {
                let n = Torque::<Body>::from_array(load.to_array());
                (Rotor::pivoted(&b, pivot), vec![TorqueModel::Constant(ConstantTorque::Body(n * (0.1 * scale)))])
            }
            _ => {
                let acceleration = Acceleration::from_array(load.to_array());
                (Rotor::pivoted(&b, pivot), vec![TorqueModel::Gravity(UniformGravity { acceleration })])
            }
        };
        // Needles that spin up about their thin axis are excluded.
        prop_assume!(rotor.principal().moments()[0] > 1e-3 * scale || torques.is_empty());
        let times: Vec<f64> = (0..=20).map(|k| 0.25 * f64::from(k)).collect();
        let start = State { time: 0.0, attitude, omega };
        let motion = Trajectory::compute(&rotor, &torques, start, &times, Method::Auto, 1e-13).unwrap();
        let drift = Drift::of(&motion).unwrap();
        prop_assert!(drift.work_energy < 1e-11 && drift.momentum < 1e-11, "{:?}", drift);
        prop_assert!(drift.total_energy.is_none_or(|e| e < 1e-11), "{:?}", drift);
        for pair in motion.samples().windows(2) {
            let [p, q] = [pair[0], pair[1]].map(|s| s.state.attitude.quaternion());
            let cosine: f64 = p.iter().zip(q).map(|(a, b)| a * b).sum();
            let norm: f64 = q.iter().map(|c| c * c).sum();
            prop_assert!(cosine >= 0.0 && (norm - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn closed_forms_agree_with_integration(
        a in 0.1..1.0_f64, c in 0.1..1.0_f64, attitude in rotation::<Space, Body>(), omega in vector(3.0),
        axes in rotation::<Body, Part>(),
    ) {
        let tensor = InertiaTensor::<Part>::diagonal([a + c, a + c, 2.0 * a]).unwrap().in_frame(axes);
        let rotor = Rotor::free(&MassProperties::new(1.0, Position::ZERO, tensor).unwrap());
        let start = State { time: 0.0, attitude, omega };
        let at = |method| {
            let motion = Trajectory::compute(&rotor, &[], start, &[3.0], method, 1e-14).unwrap();
            motion.samples()[0].state
        };
        let exact = at(Method::Exact);
        for integrated in [at(Method::Dop853), at(Method::Taylor)] {
            prop_assert!(exact.attitude.angle_to(integrated.attitude) < 1e-12);
            prop_assert!((exact.omega - integrated.omega).norm() < 1e-12 * omega.norm());
        }
    }

    #[test]
    fn the_period_of_omega_is_its_period(m in moments(), omega in vector(2.0)) {
        let inertia = InertiaTensor::diagonal(m).unwrap();
        let rotor = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia).unwrap());
        let start = State { time: 0.0, attitude: Attitude::identity(), omega };
        let free = FreeRegime::of(&rotor, &start);
        if let Some(period) = free.period.filter(|p| p * omega.norm() < 300.0) {
            let motion = Trajectory::compute(&rotor, &[], start, &[period], Method::Auto, 1e-14).unwrap();
            let back = motion.samples()[0].state.omega;
            prop_assert!((back - omega).norm() < 1e-9 * omega.norm(), "{:?} {:?} {}", free, back, period);
        }
    }
}
