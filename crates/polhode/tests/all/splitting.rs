//! Splitting methods: order, bounded energy error, and refusals.

use polhode::motion::torque::{Attracted, EnergySink, GravityGradient, Schedule, Scheduled};
use polhode::motion::{Ending, Motor, Orbit, SplittingOrder};
use polhode::prelude::*;

/// Returns a body with three distinct moments, products of inertia and an offset centre, held at a
/// generic pivot.
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
        let slope = (errors[1] / errors[3]).log2() / 2.0;
        assert!((slope - f64::from(order.number())).abs() < 0.25, "{order:?}: {slope} {errors:?}");
    }
}

/// Returns the change of T + U at every tenth step and between, relative to the largest T.
fn energy_errors(rotor: &Rotor, start: State, order: SplittingOrder, step: f64, steps: u32) -> Vec<f64> {
    let times: Vec<f64> = (0..=steps).step_by(10).map(|k| start.time + (f64::from(k) + 0.3) * step).collect();
    let motion = run(rotor, &[gravity()], start, &times, splitting(order, step));
    let energy = |s: &Sample| s.kinetic_energy + s.potential_energy.unwrap();
    let scale = motion.samples().iter().map(|s| s.kinetic_energy).fold(0.0, f64::max);
    motion.samples().iter().map(|s| (energy(s) - energy(motion.start())) / scale).collect()
}

#[test]
fn the_energy_error_does_not_grow() {
    // 10⁵ steps of a generic heavy body, whose motion is chaotic: the error of the last quarter
    // does not exceed that of the first.
    for (order, step, bound) in [
        (SplittingOrder::Two, 0.01, 1e-4),
        (SplittingOrder::Four, 0.03, 2e-10),
        (SplittingOrder::Six, 0.05, 1e-13),
    ] {
        let errors = energy_errors(&heavy(), start(), order, step, 100_000);
        let quarter = errors.len() / 4;
        let worst = |part: &[f64]| part.iter().fold(0.0, |most: f64, e| most.max(e.abs()));
        let mean = |part: &[f64]| part.iter().sum::<f64>() / part.len() as f64;
        let (first, last) = (&errors[..quarter], &errors[3 * quarter..]);
        assert!(worst(last) < 1.5 * worst(first) && worst(first) < bound, "{order:?}");
        assert!((mean(last) - mean(first)).abs() < 0.2 * worst(first), "{order:?}");
    }
}

#[test]
fn rounding_does_not_add_up() {
    // At a step for which the error of the method is below rounding, only rounding remains: a
    // random walk, not a drift.
    let errors = energy_errors(&heavy(), start(), SplittingOrder::Six, 2e-3, 100_000);
    let worst = errors.iter().fold(0.0, |most: f64, e| most.max(e.abs()));
    assert!(worst < 2e-14, "{worst:e}");
}

#[test]
fn work_and_impulse_are_what_the_kicks_gave() {
    let torques = [gravity(), TorqueModel::Constant(ConstantTorque::Body(Torque::new(-0.1, 0.25, 0.15)))];
    let times: Vec<f64> = (0..=1000).map(|k| 0.3 + 0.0371 * f64::from(k)).collect();
    for order in SplittingOrder::ALL {
        let motion = run(&heavy(), &torques, start(), &times, splitting(order, 0.02));
        let drift = Drift::of(&motion).unwrap();
        assert!(drift.work_energy < 2e-14 && drift.momentum < 2e-14, "{order:?}: {drift:?}");
    }
    // and with a short step it equals the work of the true motion
    let [split, taylor] = [splitting(SplittingOrder::Six, 0.01), Method::Taylor]
        .map(|method| run(&heavy(), &torques, start(), &[10.3], method).samples()[0]);
    assert!((split.work - taylor.work).abs() < 1e-11, "{:e}", split.work - taylor.work);
    assert!((split.impulse - taylor.impulse).norm() < 1e-11, "{:e}", (split.impulse - taylor.impulse).norm());
}

#[test]
fn steps_end_where_a_torque_begins_or_ends() {
    // Neither change is a multiple of the step: a step across one would have a first-order error.
    let push = ConstantTorque::Body(Torque::new(0.9, -0.7, 0.4));
    let pulses = Schedule::pulses(0.517, 0.211, 0.613, Some(5)).unwrap();
    let torques = [
        gravity(),
        TorqueModel::Scheduled(Box::new(Scheduled { torque: TorqueModel::Constant(push), schedule: pulses })),
    ];
    let times = [0.4, 0.6, 1.3, 3.9, 5.2];
    let [split, taylor] = [splitting(SplittingOrder::Six, 0.01), Method::Taylor]
        .map(|method| run(&heavy(), &torques, start(), &times, method));
    for (a, b) in split.samples().iter().zip(taylor.samples()) {
        let angle = a.state.attitude.angle_to(b.state.attitude);
        assert!(angle < 1e-11, "{}: {angle:e}", a.state.time);
    }
}

#[test]
fn free_motion_needs_no_steps() {
    // The flow is exact for every step: ten long steps, and a thousand short ones.
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let rotor = Rotor::free(&MassProperties::new(2.3, Position::ZERO, inertia).unwrap());
    let exact = run(&rotor, &[], start(), &[20.3], Method::Exact).samples()[0];
    for step in [2.0, 0.02] {
        let split = run(&rotor, &[], start(), &[20.3], splitting(SplittingOrder::Two, step)).samples()[0];
        let angle = split.state.attitude.angle_to(exact.state.attitude);
        assert!(angle < 3e-14, "{step}: {angle:e}");
    }
}

#[test]
fn a_rod_keeps_its_spin_and_swings() {
    let rod = Rod::new(1.3).unwrap().mass_properties(Substance::Mass(0.7)).unwrap();
    let body = assemble(&[PlacedPart::new(rod, Position::ZERO, Rotation::identity()).unwrap()]).unwrap();
    let rotor = Rotor::pivoted(&body, Position::new(0.0, 0.0, 0.5));
    let start = State { time: 0.0, omega: AngularVelocity::new(0.3, -0.4, 1.2), ..start() };
    let [split, taylor] = [splitting(SplittingOrder::Six, 0.01), Method::Taylor]
        .map(|method| run(&rotor, &[gravity()], start, &[3.0], method).samples()[0].state);
    assert!(split.attitude.angle_to(taylor.attitude) < 1e-11);
    assert!((split.omega - taylor.omega).norm() < 1e-11);
    let along = [TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, 0.1)))];
    let refused =
        Trajectory::compute(&rotor, &along, start, &[1.0], splitting(SplittingOrder::Four, 0.1), 0.0);
    assert!(matches!(refused, Err(MotionError::TorqueWithoutInertia { .. })));
}

#[test]
fn what_is_no_kick_is_refused() {
    let refusal = |rotor: &Rotor, torque: TorqueModel| {
        let method = splitting(SplittingOrder::Four, 0.1);
        Trajectory::compute(rotor, &[gravity(), torque], start(), &[1.0], method, 1e-13).unwrap_err()
    };
    let sink = || TorqueModel::EnergySink(EnergySink::new(0.1).unwrap());
    let error = refusal(&heavy(), sink());
    let said = "splitting cannot take the torque \"energy_sink\": it acts inside the body";
    assert_eq!(error.to_string(), said);
    assert_eq!(error.hint(), Some("use method = \"auto\", without step and order"));
    assert!(!error.is_numerical());
    // also outside its times
    let schedule = Schedule::window(7.0, 8.0).unwrap();
    let later = TorqueModel::Scheduled(Box::new(Scheduled { torque: sink(), schedule }));
    assert_eq!(refusal(&heavy(), later), error);
    let wheel = Wheel::new(Direction::new(0.48, -0.6, 0.64), 0.3, Motor::HeldSpeed).unwrap();
    let error = refusal(&heavy().with_wheels(&[wheel]).unwrap(), gravity());
    assert!(matches!(error, MotionError::NotSplittable { what: "wheel", .. }), "{error}");
    for step in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        let wrong = Trajectory::compute(
            &heavy(),
            &[gravity()],
            start(),
            &[1.0],
            splitting(SplittingOrder::Two, step),
            1e-13,
        );
        assert!(
            matches!(wrong, Err(MotionError::NonPositiveParameter { parameter: "the step", .. })),
            "{step}"
        );
    }
    // Too many steps, and steps below the rounding of the time.
    let far = |time: f64, span: f64, step: f64| {
        let start = State { time, ..start() };
        let method = splitting(SplittingOrder::Two, step);
        let motion =
            Trajectory::compute(&heavy(), &[gravity()], start, &[time + span], method, 1e-13).unwrap();
        motion.ending().clone()
    };
    let many = far(0.0, 1e6, 1e-3);
    assert!(matches!(many, Ending::Failed { cause: MotionError::TooManySteps { .. }, .. }), "{many:?}");
    let small = far(1e12, 1.0, 1e-5);
    assert!(matches!(small, Ending::Failed { cause: MotionError::StepTooSmall { .. }, .. }), "{small:?}");
}

#[test]
fn gravity_gradient_keeps_the_jacobi_integral() {
    // On a circular orbit: T − n·L + 3/2 n² r̂·I r̂
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let rotor = Rotor::free(&MassProperties::new(2.3, Position::ZERO, inertia).unwrap());
    let (rate, normal) = (0.31, Direction::<Space>::new(0.48, -0.6, 0.64));
    let along = Direction::<Space>::new(0.78, 0.624, 0.0).direction().unwrap();
    let position = Position::from_array((along * 7.3).to_array());
    let velocity = Velocity::from_array((normal.cross(along) * (7.3 * rate)).to_array());
    let orbit = Orbit::through(rate * rate * 7.3_f64.powi(3), position, velocity, start().time).unwrap();
    let torques = [TorqueModel::GravityGradient(Box::new(GravityGradient {
        orbit: orbit.clone(),
        attracted: Attracted::Tensor,
    }))];
    let integral = |sample: &Sample| {
        let there = sample.state.attitude.inverse() * orbit.position(sample.state.time);
        let there = there / there.norm();
        let there = AngularVelocity::<Body>::from_array(there.to_array());
        let potential = 3.0 * rate * rate * rotor.kinetic_energy(there);
        sample.kinetic_energy - rate * normal.dot(sample.momentum) + potential
    };
    for (order, step, bound) in [
        (SplittingOrder::Two, 0.05, 1e-4),
        (SplittingOrder::Four, 0.1, 4e-9),
        (SplittingOrder::Six, 0.2, 5e-10),
    ] {
        let times: Vec<f64> = (0..10_000).map(|k| start().time + 10.3 * step * f64::from(k)).collect();
        let motion = run(&rotor, &torques, start(), &times, splitting(order, step));
        let first = integral(motion.start());
        let errors: Vec<f64> =
            motion.samples().iter().map(|s| (integral(s) - first).abs() / first.abs()).collect();
        let worst = |part: &[f64]| part.iter().fold(0.0, |most: f64, e| most.max(*e));
        let (early, late) = (worst(&errors[..2500]), worst(&errors[7500..]));
        assert!(late < 1.5 * early && early < bound, "{order:?}: {early:e} {late:e}");
    }
    // and it agrees with the motion
    let [split, taylor] = [splitting(SplittingOrder::Six, 0.02), Method::Taylor]
        .map(|method| run(&rotor, &torques, start(), &[20.3], method).samples()[0].state);
    assert!(split.attitude.angle_to(taylor.attitude) < 1e-11);
}
