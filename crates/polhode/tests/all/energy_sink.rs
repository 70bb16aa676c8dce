//! Energy dissipation inside a body, compared with its definition and with a closed form.

use polhode::motion::Motor;
use polhode::motion::torque::EnergySink;
use polhode::prelude::*;

const METHODS: [Method; 2] = [Method::Taylor, Method::Dop853];

fn body() -> Rotor {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    Rotor::free(&MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap())
}

fn start(omega: [f64; 3]) -> State {
    let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    State { time: 0.0, attitude, omega: AngularVelocity::from_array(omega) }
}

fn sink(coefficient: f64) -> TorqueModel {
    TorqueModel::EnergySink(EnergySink::new(coefficient).unwrap())
}

fn times(end: f64, count: u32) -> Vec<f64> {
    (0..=count).map(|k| end * f64::from(k) / f64::from(count)).collect()
}

#[test]
fn angular_momentum_stays_where_it_is_and_energy_falls() {
    let wheel = Wheel::new(Direction::new(0.6, -0.3, 0.9), 1.7, Motor::HeldSpeed).unwrap();
    let start = start([2.1, 0.3, -0.4]);
    for rotor in [body(), body().with_wheels(&[wheel]).unwrap()] {
        let [a, b] = METHODS.map(|method| {
            Trajectory::compute(&rotor, &[sink(2e-3)], start, &times(60.0, 120), method, 1e-15).unwrap()
        });
        for motion in [&a, &b] {
            let first = motion.start();
            for pair in motion.samples().windows(2) {
                assert!((pair[1].momentum - first.momentum).norm() < 1e-14 * first.momentum.norm());
                assert!(pair[1].kinetic_energy < pair[0].kinetic_energy);
                assert_eq!(pair[1].torque, Torque::ZERO);
            }
            let drift = Drift::of(motion).unwrap();
            assert!(drift.work_energy < 1e-14 && drift.momentum < 1e-14, "{drift:?}");
            assert!(drift.kinetic_energy > 0.05, "{drift:?}");
        }
        for (a, b) in a.samples().iter().zip(b.samples()) {
            let (omega, turn) =
                ((a.state.omega - b.state.omega).norm(), a.state.attitude.angle_to(b.state.attitude));
            assert!(omega < 1e-12 && turn < 1e-12, "t = {}: {omega:e} {turn:e}", a.state.time);
        }
    }
}

#[test]
fn the_rates_are_those_of_the_definition() {
    let (alpha, h) = (3e-3, 1e-3);
    let rotor = body();
    for method in METHODS {
        let around = [2.0 - 2.0 * h, 2.0 - h, 2.0, 2.0 + h, 2.0 + 2.0 * h];
        let motion =
            Trajectory::compute(&rotor, &[sink(alpha)], start([2.1, 0.3, -0.4]), &around, method, 1e-15)
                .unwrap();
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|k| motion.samples()[k]);
        // Ṫ = −α |L × ω|², by differences of order 4
        let omega = c.state.omega;
        let momentum = rotor.angular_momentum(omega);
        let rate = (8.0 * (d.kinetic_energy - b.kinetic_energy) - (e.kinetic_energy - a.kinetic_energy))
            / (12.0 * h);
        let bending = momentum.cross(omega);
        assert!((rate + alpha * bending.dot(bending)).abs() < 1e-9, "{rate}");
        // The axes turn at Ω = ω + α L × ω.
        let turned = |s: &Sample| {
            let [w, x, y, z] = (c.state.attitude.inverse() * s.state.attitude).canonical_quaternion();
            Direction::<Body>::new(x, y, z) * (2.0 / w.signum())
        };
        let rate = (8.0 * (turned(&d) - turned(&b)) - (turned(&e) - turned(&a))) / (12.0 * h);
        let turning = Direction::<Body>::from_array(omega.to_array())
            + Direction::from_array(bending.to_array()) * alpha;
        assert!((rate - turning).norm() < 1e-9, "{rate:?} {turning:?}");
        assert!(alpha * bending.norm() > 1e-3);
    }
}

#[test]
fn a_symmetric_body_nutates_by_the_closed_form() {
    // A generic axis of symmetry with moment I along it and J across; prolate and oblate.
    let axis = Direction::<Body>::new(0.6, -0.3, 0.9).direction().unwrap();
    for (along, across, towards) in [(1.3, 4.1, false), (5.2, 3.7, true)] {
        let n = axis.to_array();
        let tensor = std::array::from_fn(|i| {
            std::array::from_fn(|j| (along - across) * n[i] * n[j] + if i == j { across } else { 0.0 })
        });
        let body =
            MassProperties::new(1.7, Position::ZERO, InertiaTensor::from_matrix(tensor).unwrap()).unwrap();
        let rotor = Rotor::free(&body);
        let start = start([1.1, -0.7, 0.9]);
        let momentum = rotor.angular_momentum(start.omega);
        let tangent = |l: AngularMomentum<Body>| {
            Direction::from_array(l.to_array()).cross(axis).norm() / l.dot(axis).abs()
        };
        let alpha = 4e-3;
        let rate = alpha * momentum.dot(momentum) * (1.0 / along - 1.0 / across);
        assert_eq!(rate < 0.0, towards);
        for method in METHODS {
            let motion =
                Trajectory::compute(&rotor, &[sink(alpha)], start, &times(60.0, 30), method, 1e-15).unwrap();
            for sample in motion.samples() {
                let expected = tangent(momentum) * (rate * sample.state.time).exp();
                let found = tangent(rotor.angular_momentum(sample.state.omega));
                assert!(
                    (found / expected - 1.0).abs() < 1e-12,
                    "{method:?} t = {}: {found} {expected}",
                    sample.state.time
                );
            }
        }
        // The time constant follows from the same formula.
        let tau = 1.0 / rate.abs();
        let extremes = [f64::min(along, across), f64::max(along, across)];
        let same = EnergySink::with_time_constant(tau, extremes, momentum.norm()).unwrap();
        assert!((same.coefficient() / alpha - 1.0).abs() < 1e-14);
    }
}

#[test]
fn a_sink_that_makes_energy_is_refused() {
    for coefficient in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(EnergySink::new(coefficient).is_err());
    }
    assert!(EnergySink::with_time_constant(10.0, [2.0, 2.0], 3.0).is_err());
    assert!(EnergySink::with_time_constant(10.0, [1.0, 2.0], 0.0).is_err());
    assert!(EnergySink::with_time_constant(-1.0, [1.0, 2.0], 3.0).is_err());
}

#[test]
fn a_rod_that_spins_about_its_line_has_nothing_to_give() {
    let rod = InertiaTensor::diagonal([0.0, 1.3, 1.3]).unwrap();
    let rod = Rotor::free(&MassProperties::new(1.0, Position::ZERO, rod).unwrap());
    for method in METHODS {
        let run = |omega| Trajectory::compute(&rod, &[sink(1e-2)], start(omega), &[0.0, 3.0], method, 1e-13);
        assert!(matches!(run([0.5, 1.0, 0.3]), Err(MotionError::TorqueWithoutInertia { .. })));
        assert!(run([0.0, 1.0, 0.3]).is_ok());
    }
}
