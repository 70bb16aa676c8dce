//! Bodies with momentum wheels: conservation laws, an independent larger system, and closed forms.

use polhode::motion::Motor;
use polhode::motion::torque::{Schedule, Scheduled};
use polhode::prelude::*;

const METHODS: [Method; 2] = [Method::Taylor, Method::Dop853];

const TENSOR: [[f64; 3]; 3] = [[3.1, -0.4, 0.3], [-0.4, 4.2, -0.2], [0.3, -0.2, 5.3]];

fn body() -> Rotor {
    let inertia = InertiaTensor::from_matrix(TENSOR).unwrap();
    Rotor::free(&MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap())
}

fn start() -> State {
    let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    State { time: 0.0, attitude, omega: AngularVelocity::new(0.7, -1.1, 0.4) }
}

fn axis() -> Direction<Body> {
    Direction::new(0.6, -0.3, 0.9)
}

fn motor(inertia: f64, torque: f64, schedule: Option<Schedule>) -> Motor {
    Motor::Torque { inertia, torque, schedule }
}

fn compute(rotor: &Rotor, torques: &[TorqueModel], end: f64, method: Method) -> Trajectory {
    let times: Vec<f64> = (0..=50).map(|k| end * f64::from(k) / 50.0).collect();
    Trajectory::compute(rotor, torques, start(), &times, method, 1e-15).unwrap()
}

fn wheels() -> [(&'static str, Vec<Wheel>); 4] {
    let window = Some(Schedule::window(3.0, 11.5).unwrap());
    let pulses = Some(Schedule::pulses(1.0, 0.7, 2.3, Some(9)).unwrap());
    let other = Direction::new(-0.2, 1.0, 0.5);
    [
        ("held", vec![Wheel::new(axis(), 2.7, Motor::HeldSpeed).unwrap()]),
        ("free", vec![Wheel::turning(axis(), 12.0, motor(0.21, 0.0, None), start().omega).unwrap()]),
        ("window", vec![Wheel::new(axis(), -0.4, motor(0.21, 0.35, window)).unwrap()]),
        (
            "two",
            vec![
                Wheel::new(axis(), 0.8, motor(0.3, -0.5, pulses)).unwrap(),
                Wheel::new(other, 1.9, Motor::HeldSpeed).unwrap(),
            ],
        ),
    ]
}

#[test]
fn nothing_inside_changes_the_whole_angular_momentum() {
    for (name, wheels) in wheels() {
        let rotor = body().with_wheels(&wheels).unwrap();
        for method in METHODS {
            // about ten turns
            let motion = compute(&rotor, &[], 50.0, method);
            let first = motion.start().momentum;
            let worst = motion.samples().iter().map(|s| (s.momentum - first).norm() / first.norm());
            let worst = worst.fold(0.0, f64::max);
            let bound = if method == Method::Taylor { 1e-14 } else { 5e-14 };
            assert!(worst < bound, "{name} {method:?}: {worst:e}");
            // The reaction of the motors does work: without it, the balance of T would fail.
            let drift = Drift::of(&motion).unwrap();
            assert!(drift.work_energy < 3e-14, "{name} {method:?}: {drift:?}");
            let motors = wheels.iter().any(Wheel::is_driven);
            assert_eq!(drift.kinetic_energy > 1e-3, motors, "{name}: {drift:?}");
        }
    }
}

#[test]
fn both_integrators_agree_with_a_torque_too() {
    let torques = [
        TorqueModel::Constant(ConstantTorque::Space(Torque::new(0.1, -0.2, 0.15))),
        TorqueModel::Constant(ConstantTorque::Body(Torque::new(-0.05, 0.12, 0.07))),
    ];
    for (name, wheels) in wheels() {
        let rotor = body().with_wheels(&wheels).unwrap();
        let [a, b] = METHODS.map(|method| compute(&rotor, &torques, 20.0, method));
        for (a, b) in a.samples().iter().zip(b.samples()) {
            let (omega, turn) =
                ((a.state.omega - b.state.omega).norm(), a.state.attitude.angle_to(b.state.attitude));
            assert!(omega < 1e-12 && turn < 1e-12, "{name} t = {}: {omega:e} {turn:e}", a.state.time);
        }
        for motion in [&a, &b] {
            let drift = Drift::of(motion).unwrap();
            assert!(drift.work_energy < 1e-13 && drift.momentum < 1e-13, "{name}: {drift:?}");
        }
    }
}

#[test]
fn a_torque_that_ends_leaves_no_impulse_behind() {
    let wheel = Wheel::new(axis(), 2.7, Motor::HeldSpeed).unwrap();
    let rotor = body().with_wheels(&[wheel]).unwrap();
    let torque = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.3, -0.2, 0.4)));
    let schedule = Schedule::window(0.0, 1.3).unwrap();
    let torques = [TorqueModel::Scheduled(Box::new(Scheduled { torque, schedule }))];
    for method in METHODS {
        let drift = Drift::of(&compute(&rotor, &torques, 10.0, method)).unwrap();
        assert!(drift.momentum < 1e-14 && drift.work_energy < 1e-14, "{method:?}: {drift:?}");
    }
}

#[test]
fn energy_is_kept_under_gravity_unless_a_motor_works() {
    let inertia = InertiaTensor::from_matrix(TENSOR).unwrap();
    let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
    let gravity = [TorqueModel::Gravity(UniformGravity::STANDARD)];
    for (name, wheels) in wheels() {
        let rotor = Rotor::pivoted(&body, Position::new(0.4, -0.2, 0.3)).with_wheels(&wheels).unwrap();
        for method in METHODS {
            let drift = Drift::of(&compute(&rotor, &gravity, 20.0, method)).unwrap();
            assert!(drift.work_energy < 1e-12 && drift.momentum < 1e-12, "{name} {method:?}: {drift:?}");
            let driven = wheels.iter().any(Wheel::is_driven);
            assert_eq!(drift.total_energy.is_none(), driven, "{name}");
            assert!(drift.total_energy.is_none_or(|drift| drift < 1e-12), "{name} {method:?}: {drift:?}");
        }
    }
}

/// Integrates carrier and wheel as two bodies on one axle, from their two angular momenta,
/// independently of the library's equations.
///
/// The carrier with the locked wheel has I, the wheel J about a. The unknowns are ω and the
/// relative rate Ω. L = I ω + J Ω a, and along the axle J (a·ω̇ + Ω̇) = u. So (I − J a aᵀ) ω̇ = (I
/// ω + J Ω a) × ω − u a, Ω̇ = u/J − a·ω̇. The method is the classical Runge–Kutta method.
fn two_bodies(inertia: f64, torque: f64, speed: f64, end: f64, steps: u32) -> [f64; 4] {
    let a = axis().direction().unwrap().to_array();
    let carrier: [[f64; 3]; 3] =
        std::array::from_fn(|i| std::array::from_fn(|j| TENSOR[i][j] - inertia * a[i] * a[j]));
    let cross = |u: [f64; 3], v: [f64; 3]| {
        [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    };
    let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    // Cramer's rule
    let solve = |b: [f64; 3]| {
        let [x, y, z] = carrier;
        let determinant = dot(x, cross(y, z));
        let (p, q, r) = (cross(y, z), cross(z, x), cross(x, y));
        std::array::from_fn::<f64, 3, _>(|k| (p[k] * b[0] + q[k] * b[1] + r[k] * b[2]) / determinant)
    };
    let rate = |y: [f64; 4]| {
        let w = [y[0], y[1], y[2]];
        let l = std::array::from_fn::<f64, 3, _>(|i| dot(TENSOR[i], w) + inertia * y[3] * a[i]);
        let gyroscopic = cross(l, w);
        let acceleration = solve(std::array::from_fn(|i| gyroscopic[i] - torque * a[i]));
        [acceleration[0], acceleration[1], acceleration[2], torque / inertia - dot(a, acceleration)]
    };
    let along = |y: [f64; 4], k: [f64; 4], h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
    let [x, y, z] = start().omega.to_array();
    let (mut y, h) = ([x, y, z, speed], end / f64::from(steps));
    for _ in 0..steps {
        let k1 = rate(y);
        let k2 = rate(along(y, k1, h / 2.0));
        let k3 = rate(along(y, k2, h / 2.0));
        let k4 = rate(along(y, k3, h));
        y = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
    }
    y
}

#[test]
fn a_motor_wheel_is_two_bodies_on_an_axle() {
    let (inertia, speed, end) = (0.21, 9.0, 4.0);
    for torque in [0.0, 0.35, -0.8] {
        let wheel = Wheel::turning(axis(), speed, motor(inertia, torque, None), start().omega).unwrap();
        let rotor = body().with_wheels(&[wheel]).unwrap();
        let [x, y, z, relative] = two_bodies(inertia, torque, speed, end, 20_000);
        for method in METHODS {
            let last = *compute(&rotor, &[], end, method).samples().last().unwrap();
            let omega = last.state.omega;
            // 1e-12: the error of 20 000 steps of order 4
            assert!(
                (omega - AngularVelocity::new(x, y, z)).norm() < 2e-12,
                "{torque} {method:?} {omega:?} {x} {y} {z}"
            );
            let found = wheel.momentum_at(end) / inertia - wheel.axis().dot(omega);
            assert!((found - relative).abs() < 2e-11, "{torque} {method:?}: {found} {relative}");
        }
    }
}

#[test]
fn a_spin_up_turns_the_carrier_the_other_way() {
    // About a principal axis: (i − J) ω = −u t; with held speed nothing happens.
    let principal = *body().principal();
    let axis = principal.axis(1);
    let (inertia, torque) = (0.25, 0.4);
    let schedule = Some(Schedule::window(1.0, 3.5).unwrap());
    let wheel = Wheel::new(axis, 0.0, motor(inertia, torque, schedule)).unwrap();
    let rotor = body().with_wheels(&[wheel]).unwrap();
    let rest = State { omega: AngularVelocity::ZERO, ..start() };
    for method in METHODS {
        let times = [0.5, 2.0, 3.5, 8.0];
        let motion = Trajectory::compute(&rotor, &[], rest, &times, method, 1e-14).unwrap();
        for (sample, on) in motion.samples().iter().zip([0.0, 1.0, 2.5, 2.5]) {
            let rate = -torque * on / (principal.moments()[1] - inertia);
            let expected = AngularVelocity::from_array((axis * rate).to_array());
            assert!((sample.state.omega - expected).norm() < 1e-15, "{method:?} {on}");
            assert!(sample.momentum.norm() < 2e-15);
        }
        // and the whole rotation: half a t² during spin-up, then at constant rate
        let rate = torque / (principal.moments()[1] - inertia);
        let angle = rate * (0.5 * 2.5 * 2.5 + 2.5 * 4.5);
        let turned = Attitude::from_axis_angle(Direction::new(1.0, 0.0, 0.0), angle).unwrap().angle();
        let last = motion.samples()[3].state.attitude;
        assert!((last.angle_to(rest.attitude) - turned).abs() < 1e-14);
    }
}

#[test]
fn wheels_that_no_body_can_hold_are_refused() {
    let refused = |wheel: Result<Wheel, MotionError>| matches!(wheel, Err(ref error) if error.is_parameter());
    assert!(refused(Wheel::new(Direction::ZERO, 1.0, Motor::HeldSpeed)));
    assert!(refused(Wheel::new(Direction::new(f64::NAN, 0.0, 1.0), 1.0, Motor::HeldSpeed)));
    assert!(refused(Wheel::new(axis(), f64::INFINITY, Motor::HeldSpeed)));
    assert!(refused(Wheel::new(axis(), 1.0, motor(0.0, 1.0, None))));
    assert!(refused(Wheel::new(axis(), 1.0, motor(1.0, f64::NAN, None))));
    // More inertia than the body, and exactly as much.
    let wheel =
        |inertia: f64| Wheel::new(Direction::new(0.0, 0.0, 1.0), 1.0, motor(inertia, 0.0, None)).unwrap();
    assert!(body().with_wheels(&[wheel(6.0)]).is_err());
    let disk = InertiaTensor::diagonal([1.0, 1.0, 2.0]).unwrap();
    let disk = Rotor::free(&MassProperties::new(1.0, Position::ZERO, disk).unwrap());
    assert!(disk.clone().with_wheels(&[wheel(2.0)]).is_err());
    assert!(disk.with_wheels(&[wheel(1.5)]).is_ok());
    let rod = InertiaTensor::diagonal([0.0, 1.0, 1.0]).unwrap();
    let rod = Rotor::free(&MassProperties::new(1.0, Position::ZERO, rod).unwrap());
    assert!(rod.with_wheels(&[Wheel::new(axis(), 1.0, Motor::HeldSpeed).unwrap()]).is_err());
}
