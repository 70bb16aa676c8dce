//! Motions compared with references of 40 digits (fixtures/ describes how they were computed).

use crate::common::*;
use polhode::motion::{ErrorEffort, Pendulum, Regime, Swing, TIGHTEST_TOLERANCE};
use polhode::prelude::*;

/// Returns the errors of ω (relative) and attitude (rad) at one row of a case.
fn errors(row: &toml::Table, state: &State) -> (f64, f64) {
    let omega = AngularVelocity::from_array(numbers(&row["omega"]));
    ((state.omega - omega).norm() / omega.norm(), state.attitude.angle_to(attitude(&row["attitude"])))
}

const METHODS: [Method; 2] = [Method::Dop853, Method::Taylor];

/// Returns the larger of each error.
fn worst(errors: [(f64, f64); 2]) -> [f64; 2] {
    [errors[0].0.max(errors[1].0), errors[0].1.max(errors[1].1)]
}

/// Returns a motion at one time, which may be before its start. Every torque here depends on the
/// attitude only, so the motion with reversed ω is the same motion backwards.
fn integrate(
    method: Method,
    rotor: &Rotor,
    torques: &[TorqueModel],
    start: State,
    t: f64,
    tolerance: f64,
) -> Sample {
    let sign = if t < 0.0 { -1.0 } else { 1.0 };
    let start = State { omega: start.omega * sign, ..start };
    let motion = Trajectory::compute(rotor, torques, start, &[sign * t], method, tolerance).unwrap();
    let sample = motion.samples()[0];
    let drift = Drift::of(&motion).unwrap();
    assert!(drift.work_energy < 1e3 * tolerance * (1.0 + t.abs()), "t = {t}: {drift:?}");
    assert!(drift.momentum < 1e3 * tolerance * (1.0 + t.abs()), "t = {t}: {drift:?}");
    let state = State { time: t, omega: sample.state.omega * sign, ..sample.state };
    Sample { state, momentum: sample.momentum * sign, ..sample }
}

#[test]
fn free_asymmetric_bodies_follow_the_reference() {
    for case in cases(&table("free_asymmetric"), "case") {
        let rotor = free_body(numbers(&case["moments"]));
        let name = case["name"].as_str().unwrap();
        for row in cases(case, "row") {
            let t = number(&row["t"]);
            let [omega, attitude] = worst(
                METHODS
                    .map(|method| errors(row, &integrate(method, &rotor, &[], start(case), t, 1e-15).state)),
            );
            // The errors of phase grow with t; each passage of the separatrix multiplies them.
            let bound = match name {
                "dzhanibekov_1e-6" if t.abs() > 10.0 => 2e-12 * t.abs().powi(3),
                "dzhanibekov_1e-3" if t.abs() > 10.0 => 1e-11 * t.abs(),
                _ => 2e-14 * (1.0 + t.abs()),
            };
            assert!(omega < bound && attitude < bound, "{name} t = {t}: {omega:e} {attitude:e}");
        }
    }
}

#[test]
fn free_symmetric_bodies_have_their_closed_form() {
    for case in cases(&table("symmetric_top"), "case") {
        let rotor = free_body(numbers(&case["moments"]));
        let motion = FreeMotion::of(&rotor, start(case)).unwrap();
        assert_eq!(motion.regime(), Regime::Symmetric);
        for row in cases(case, "row") {
            let t = number(&row["t"]);
            let (omega, attitude) = errors(row, &motion.at(t));
            // two phases, each rounded relative to its size
            let bound = 1e-15 * (2.0 + start(case).omega.norm() * t.abs());
            assert!(omega < bound && attitude < bound, "{:?} t = {t}: {omega:e} {attitude:e}", case["name"]);
        }
    }
}

#[test]
fn torques_follow_the_reference() {
    let zero = [0.0; 3];
    for case in cases(&table("torque_cases"), "case") {
        let name = case["name"].as_str().unwrap();
        let inertia = InertiaTensor::from_matrix(matrix(&case["inertia"])).unwrap();
        let arm = Position::from_array(numbers(&case["arm"]));
        let body = MassProperties::new(number(&case["mass"]), arm, inertia).unwrap();
        let gravity = numbers(&case["gravity"]);
        let rotor = if gravity == zero { Rotor::free(&body) } else { Rotor::pivoted(&body, Position::ZERO) };
        let mut torques = Vec::new();
        if gravity != zero {
            let acceleration = Acceleration::from_array(gravity);
            torques.push(TorqueModel::Gravity(UniformGravity { acceleration }));
        }
        for (key, make) in [
            (
                "torque_body",
                (|n| ConstantTorque::Body(Torque::from_array(n))) as fn([f64; 3]) -> ConstantTorque,
            ),
            ("torque_space", |n| ConstantTorque::Space(Torque::from_array(n))),
        ] {
            let n = numbers(&case[key]);
            if n != zero {
                torques.push(TorqueModel::Constant(make(n)));
            }
        }
        assert!(!torques.is_empty());
        for row in cases(case, "row") {
            let t = number(&row["t"]);
            for method in METHODS {
                let sample = integrate(method, &rotor, &torques, start(case), t, 1e-15);
                let (omega, attitude) = errors(row, &sample.state);
                let bound = 1e-13 * (1.0 + start(case).omega.norm() * t.abs());
                assert!(omega < bound && attitude < bound, "{name} t = {t}: {omega:e} {attitude:e}");
                let energy = number(&row["kinetic_energy"]);
                assert!((sample.kinetic_energy / energy - 1.0).abs() < bound, "{name} t = {t}");
                let momentum = AngularMomentum::from_array(numbers(&row["momentum_space"]));
                assert!((sample.momentum - momentum).norm() < bound * momentum.norm(), "{name} t = {t}");
                if let Some(potential) = sample.potential_energy {
                    let total = number(&row["total_energy"]);
                    let scale = sample.kinetic_energy.max(potential.abs());
                    assert!(
                        (sample.kinetic_energy + potential - total).abs() < bound * scale,
                        "{name} t = {t}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_thousand_seconds_drift_by_less_than_1e_12() {
    let start =
        State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.3, 0.5, 0.9) };
    let times: Vec<f64> = (0..=1000).map(f64::from).collect();
    let rotor = free_body([1.0, 2.0, 3.0]);
    for method in [Method::Dop853, Method::Taylor] {
        let motion = Trajectory::compute(&rotor, &[], start, &times, method, TIGHTEST_TOLERANCE).unwrap();
        let drift = Drift::of(&motion).unwrap();
        println!("{drift:?} {:?}", motion.solution());
        assert!(
            drift.kinetic_energy < 1e-12 && drift.momentum_magnitude < 1e-12 && drift.momentum < 1e-12,
            "{drift:?}"
        );
    }
}

#[test]
fn the_tolerance_controls_the_error() {
    let case_table = table("free_asymmetric");
    let case = cases(&case_table, "case")[0];
    let rotor = free_body(numbers(&case["moments"]));
    let row = cases(case, "row").into_iter().find(|r| number(&r["t"]) == 100.0).unwrap();
    let mut last = f64::INFINITY;
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14] {
        let (omega, attitude) =
            errors(row, &integrate(Method::Dop853, &rotor, &[], start(case), 100.0, tolerance).state);
        println!("{tolerance:e} {omega:e} {attitude:e}");
        assert!(attitude < 1e3 * tolerance + 1e-13, "{tolerance:e}: {attitude:e}");
        assert!(attitude < 0.1 * last, "{tolerance:e}: {attitude:e} after {last:e}");
        last = attitude.max(1e-12);
    }
}

#[test]
fn times_and_tolerances_out_of_range_are_refused() {
    let rotor = free_body([1.0, 2.0, 3.0]);
    let start =
        State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.3, 0.5, 0.9) };
    let run =
        |times: &[f64], method, tolerance| Trajectory::compute(&rotor, &[], start, times, method, tolerance);
    assert!(matches!(run(&[1.0], Method::Dop853, 1e-16), Err(ref error) if error.is_parameter()));
    assert!(matches!(run(&[1.0], Method::Dop853, f64::NAN), Err(ref error) if error.is_parameter()));
    assert!(matches!(run(&[2.0, 1.0], Method::Auto, 1e-9), Err(ref error) if error.is_parameter()));
    assert!(matches!(run(&[f64::NAN], Method::Auto, 1e-9), Err(ref error) if error.is_parameter()));
    let push = [TorqueModel::Constant(ConstantTorque::Space(Torque::new(0.1, 0.0, 0.0)))];
    let pushed = Trajectory::compute(&rotor, &push, start, &[1.0], Method::Exact, 1e-9);
    assert!(matches!(pushed, Err(MotionError::NoClosedForm { .. })));
    let point = free_body([0.0; 3]);
    let still = Trajectory::compute(&point, &[], start, &[1.0], Method::Auto, 1e-9);
    assert!(matches!(still, Err(MotionError::NotSpinnable)));
}

#[test]
fn a_rod_swings_but_takes_no_torque_along_itself() {
    // Thornton & Marion, example 11.4: m1 at the end of a rod of length b, m2 in the middle;
    // released at 40°.
    let (m1, m2, b, g) = (1.3, 0.8, 0.9, 9.81);
    let particles =
        [(m1, b), (m2, b / 2.0)].map(|(m, x)| Particle::new(m, Position::new(x, 0.0, 0.0)).unwrap());
    let rotor = Rotor::pivoted(&mass_properties_of_particles(&particles).unwrap(), Position::ZERO);
    let gravity = [TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(g, 0.0, 0.0) })];
    let amplitude = 40_f64.to_radians();
    let z = Direction::new(0.0, 0.0, 1.0);
    let start = State {
        time: 0.0,
        attitude: Rotation::from_axis_angle(z, amplitude).unwrap(),
        omega: AngularVelocity::ZERO,
    };
    let pendulum = Pendulum::hung(
        &rotor,
        Direction::new(0.0, 0.0, 1.0),
        start.attitude.inverse() * Acceleration::new(g, 0.0, 0.0),
    )
    .unwrap();
    let by_the_notes = ((m1 + m2 / 2.0) / (m1 + m2 / 4.0) * g / b).sqrt();
    assert!((pendulum.small_frequency() / by_the_notes - 1.0).abs() < 1e-15);
    assert!((pendulum.angle() - amplitude).abs() < 1e-15);
    // After the exact period it has returned; after half of it, it is on the other side.
    let period = pendulum.period(amplitude);
    let times = [0.5 * period, period, 7.0 * period];
    let motion = Trajectory::compute(&rotor, &gravity, start, &times, Method::Auto, 1e-15).unwrap();
    let back = motion.samples()[1].state;
    assert!(back.attitude.angle_to(start.attitude) < 1e-13 && back.omega.norm() < 1e-12);
    let side = motion.samples()[0].state;
    assert!(side.attitude.angle_to(Rotation::from_axis_angle(z, -amplitude).unwrap()) < 1e-13);
    assert!(motion.samples()[2].state.attitude.angle_to(start.attitude) < 1e-12);

    let along = [TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.1, 0.2, 0.0)))];
    let refused = Trajectory::compute(&rotor, &along, start, &times, Method::Auto, 1e-9);
    assert!(matches!(refused, Err(MotionError::TorqueWithoutInertia { .. })), "{refused:?}");
}

#[test]
fn pendulums_of_any_amplitude_have_their_period() {
    let rod = MassProperties::new(
        0.8,
        Position::new(0.6, 0.1, 0.2),
        InertiaTensor::diagonal([0.01, 0.096, 0.1]).unwrap(),
    );
    let rotor = Rotor::pivoted(&rod.unwrap(), Position::new(-0.1, 0.2, 0.3));
    let axis = Direction::new(0.2, -0.3, 1.0);
    let pendulum = Pendulum::hung(&rotor, axis, Acceleration::new(9.0, 1.0, -3.0)).unwrap();
    // ω0² from the definitions
    let n = axis.direction().unwrap();
    let l = rotor.lever().to_array();
    let l = Direction::<Body>::from_array(l);
    let g = Direction::<Body>::new(9.0, 1.0, -3.0);
    let (arm, down) = (n.cross(l).norm(), n.cross(g).norm());
    let i = n.dot(Direction::from_array(
        (*rotor.inertia() * AngularVelocity::from_array(n.to_array())).to_array(),
    ));
    let small = (0.8 * down * arm / i).sqrt();
    assert!((pendulum.small_frequency() / small - 1.0).abs() < 1e-15);
    for case in cases(&table("pendulum"), "case") {
        let amplitude = number(&case["amplitude_rad"]);
        let ratio = pendulum.period(amplitude) * small / (2.0 * std::f64::consts::PI);
        let expected = number(&case["period_ratio"]);
        // cos²(θ/2) loses relative accuracy towards π
        let bound = 1e-15 + 3e-16 / (0.5 * amplitude).cos().powi(2).sqrt();
        assert!((ratio / expected - 1.0).abs() < bound, "{:?} {:e}", case["label"], ratio / expected - 1.0);
        if let Swing::Oscillation { amplitude: a, period } = pendulum.swing(amplitude, 0.0) {
            assert!(
                (a / amplitude - 1.0).abs() < 1e-9
                    && (period / pendulum.period(amplitude) - 1.0).abs() < 1e-12
            );
        } else {
            assert!(amplitude == 0.0);
        }
    }
    // Through the bottom at twice the rate that just reaches the top: a revolution, with its period
    // by the integral of dθ/θ̇.
    let rate = 4.0 * small;
    let Swing::Revolution { period } = pendulum.swing(0.0, rate) else { panic!("must go round") };
    let n = 4000;
    let h = 2.0 * std::f64::consts::PI / f64::from(n);
    let speed = |theta: f64| (rate * rate - 4.0 * small * small * (theta / 2.0).sin().powi(2)).sqrt();
    let by_quadrature: f64 = (0..n).map(|k| h / speed(f64::from(k) * h)).sum(); // spectral accuracy, as the integrand is periodic
    assert!((period / by_quadrature - 1.0).abs() < 1e-14);
    assert!(matches!(pendulum.swing(0.0, 0.0), Swing::Rest));
    assert!(pendulum.period(std::f64::consts::PI).is_infinite());
}

/// An error estimate may cost 14 times the motion: a caller sees its progress and can stop it.
#[test]
fn an_estimate_of_the_error_tells_that_it_is_made() {
    let rotor = free_body([1.3, 2.1, 2.9]);
    let start =
        State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.3, -0.5, 0.9) };
    for method in METHODS {
        let simulation = Simulation::new(&rotor, &[], start, &[4.0, 30.0]).method(method);
        let (mut steps, mut told) = (0, Vec::new());
        let motion = simulation
            .run_watched(&mut |_| {
                steps += 1;
                true
            })
            .unwrap();
        let with_error = simulation
            .run_with_error(ErrorEffort::Thorough, &mut |time| {
                told.push(time);
                true
            })
            .unwrap();
        assert_eq!(motion.samples(), with_error.samples());
        // Thirteen runs, one of them with twice as many steps, all after the motion itself.
        assert!(told.len() > 12 * steps && steps > 10, "{} of {steps}", told.len());
        assert!(told.iter().skip(steps).all(|time| *time == 30.0));
        assert_eq!(simulation.global_error(&motion, ErrorEffort::Thorough).as_ref(), with_error.error());
        // A stop takes effect in the motion, and in each run of the estimate.
        for most in [5, steps + 3] {
            let mut left = i64::try_from(most).unwrap();
            let stopped = simulation.run_with_error(ErrorEffort::Thorough, &mut |_| {
                left -= 1;
                left > 0
            });
            assert!(
                matches!(stopped, Err(MotionError::Stopped { time }) if time > 0.0 && time <= 30.0),
                "{stopped:?}"
            );
            assert!(left > -20, "it went on for {left}");
        }
    }
}
