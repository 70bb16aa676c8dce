//! Inverse dynamics: every kind of prescribed motion, compared with the others and with motions
//! under torques.

use polhode::math::AngularAcceleration;
use polhode::math::formula::{Binary, Formula, Instruction, Unary};
use polhode::motion::{Motor, Prescribed, RateAxes, Required, Run};
use polhode::prelude::*;

/// Returns a body without symmetry, about a point that is not its centre of mass.
fn rotor() -> Rotor {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
    Rotor::pivoted(&body, Position::new(-0.4, 0.9, 0.2))
}

fn t() -> Vec<Instruction> {
    vec![Instruction::Variable(0)]
}

fn number(value: f64) -> Vec<Instruction> {
    vec![Instruction::Constant(value)]
}

fn of(function: Unary, mut operand: Vec<Instruction>) -> Vec<Instruction> {
    operand.push(Instruction::Unary(function));
    operand
}

fn two(function: Binary, a: Vec<Instruction>, b: Vec<Instruction>) -> Vec<Instruction> {
    [a, b, vec![Instruction::Binary(function)]].concat()
}

/// Returns the formula a + b t.
fn line(a: f64, b: f64) -> Vec<Instruction> {
    two(Binary::Add, number(a), two(Binary::Multiply, number(b), t()))
}

/// Returns the formula a + b sin(c + d t).
fn wave(a: f64, b: f64, c: f64, d: f64) -> Vec<Instruction> {
    two(Binary::Add, number(a), two(Binary::Multiply, number(b), of(Unary::Sin, line(c, d))))
}

fn formula(instructions: Vec<Instruction>) -> Formula {
    Formula::new(instructions).unwrap()
}

/// A nutation and an oscillation on a steady precession.
fn swaying() -> Prescribed {
    Prescribed::EulerAngles([
        formula(two(Binary::Add, line(0.3, 0.8), wave(0.0, 0.2, 0.4, 1.7))),
        formula(wave(0.9, 0.35, -0.2, 1.1)),
        formula(two(Binary::Subtract, line(-0.4, 2.1), wave(0.0, 0.15, 1.0, 2.3))),
    ])
}

/// Checks that ω and dω/dt are the derivatives of the attitude, by fourth-order differences.
#[track_caller]
fn consistent(motion: &Prescribed, time: f64, tolerance: f64) {
    let h = 1e-3;
    let at = |k: f64| motion.at(time + k * h).unwrap().0;
    let (state, acceleration) = motion.at(time).unwrap();
    let turn = |k: f64| {
        let [w, x, y, z] = (at(-k).attitude.inverse() * at(k).attitude).canonical_quaternion();
        let v = AngularVelocity::<Body>::new(x, y, z);
        v * (2.0 * v.norm().atan2(w) / v.norm())
    };
    // Half the rotation from −k h to k h, in the axes of the middle except for order h³, which
    // cancels here.
    let omega = (turn(1.0) * 8.0 - turn(2.0)) / (12.0 * h);
    assert!((omega - state.omega).norm() < tolerance, "{omega:?} {:?}", state.omega);
    let rate = ((at(1.0).omega - at(-1.0).omega) * 8.0 - (at(2.0).omega - at(-2.0).omega)) / (12.0 * h);
    let [x, y, z] = rate.to_array();
    let rate = AngularAcceleration::<Body>::new(x, y, z);
    assert!((rate - acceleration).norm() < tolerance, "{rate:?} {acceleration:?}");
}

#[test]
fn formulas_of_a_steady_precession_are_the_uniform_rates() {
    let ([a, b, c], [p, n, s]) = ([0.4, 0.9, -1.2], [0.7, -0.3, 2.1]);
    let uniform = Prescribed::euler_rates([a, b, c], [p, n, s]).unwrap();
    let angles = Prescribed::EulerAngles([line(a, p), line(b, n), line(c, s)].map(formula));
    for time in [0.0, 0.8, -3.3, 12.0] {
        let ((state, acceleration), (again, rate)) = (uniform.at(time).unwrap(), angles.at(time).unwrap());
        assert!(state.attitude.angle_to(again.attitude) < 1e-15);
        assert!((state.omega - again.omega).norm() < 1e-14 && (acceleration - rate).norm() < 1e-14);
    }
    consistent(&swaying(), 0.7, 1e-10);
}

#[test]
fn a_quaternion_of_any_length_is_the_attitude() {
    // (cos β, sin β n) times an increasing length, with a direction n that is not a unit vector
    let half = || line(0.2, 0.45);
    let grown = |f: Vec<Instruction>| two(Binary::Multiply, of(Unary::Exp, line(0.1, -0.3)), f);
    let component = |k: f64| formula(grown(two(Binary::Multiply, number(k), of(Unary::Sin, half()))));
    let norm = 1.0_f64;
    let [x, y, z] = [2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0].map(|c: f64| c * norm);
    let motion = Prescribed::Quaternion([
        formula(grown(of(Unary::Cos, half()))),
        component(x),
        component(y),
        component(z),
    ]);
    let start: Attitude = Rotation::from_axis_angle(Direction::new(x, y, z), 0.4).unwrap();
    let turn = Prescribed::fixed_axis(start, Direction::new(x, y, z), 0.9, 0.0).unwrap();
    for time in [0.0, 1.3, 5.0] {
        let ((a, rate), (b, zero)) = (motion.at(time).unwrap(), turn.at(time).unwrap());
        assert!(a.attitude.angle_to(b.attitude) < 1e-15 && (a.omega - b.omega).norm() < 1e-15);
        assert!((rate - zero).norm() < 1e-15);
    }
    let generic = Prescribed::Quaternion([
        formula(wave(0.3, 1.0, 0.2, 1.3)),
        formula(wave(-0.5, 0.7, 1.2, 0.9)),
        formula(wave(0.4, -0.8, 0.5, 1.9)),
        formula(wave(0.9, 0.3, -1.0, 0.6)),
    ]);
    consistent(&generic, 0.6, 1e-9);
    let nothing = Prescribed::Quaternion([0.0; 4].map(Formula::constant));
    assert!(matches!(nothing.at(0.0), Err(MotionError::NotFinite { .. })));
}

/// ω(t) of a body in regular precession: R₃(φ) R₁(θ) with uniform rates, in body and in space axes.
#[test]
fn the_attitude_follows_from_omega_along_either_axes() {
    let ([a, b, c], [p, n, s]) = ([0.4, 0.9, -1.2], [0.7, -0.3, 2.1]);
    let known = Prescribed::euler_rates([a, b, c], [p, n, s]).unwrap();
    let times = |a: Vec<Instruction>, b| two(Binary::Multiply, a, b);
    let sin = |f| of(Unary::Sin, f);
    let cos = |f| of(Unary::Cos, f);
    let (phi, theta, psi) = (|| line(a, p), || line(b, n), || line(c, s));
    // ω = (φ̇ sθ sψ + θ̇ cψ, φ̇ sθ cψ − θ̇ sψ, φ̇ cθ + ψ̇)
    let body = [
        two(Binary::Add, times(number(p), times(sin(theta()), sin(psi()))), times(number(n), cos(psi()))),
        two(
            Binary::Subtract,
            times(number(p), times(sin(theta()), cos(psi()))),
            times(number(n), sin(psi())),
        ),
        two(Binary::Add, times(number(p), cos(theta())), number(s)),
    ];
    // ω = (θ̇ cφ + ψ̇ sθ sφ, θ̇ sφ − ψ̇ sθ cφ, φ̇ + ψ̇ cθ)
    let space = [
        two(Binary::Add, times(number(n), cos(phi())), times(number(s), times(sin(theta()), sin(phi())))),
        two(
            Binary::Subtract,
            times(number(n), sin(phi())),
            times(number(s), times(sin(theta()), cos(phi()))),
        ),
        two(Binary::Add, number(p), times(number(s), cos(theta()))),
    ];
    let start = known.at(0.0).unwrap().0.attitude;
    for (axes, omega) in [(RateAxes::Body, body), (RateAxes::Space, space)] {
        let motion = Prescribed::omega(start, axes, omega.map(formula), 10.0).unwrap();
        for time in [0.0, 0.37, 4.9, 10.0] {
            let ((a, rate), (b, expected)) = (motion.at(time).unwrap(), known.at(time).unwrap());
            // Measured at the end, after about 25 rad: 3e-14 rad.
            let [attitude, omega] = [a.attitude.angle_to(b.attitude), (a.omega - b.omega).norm()];
            println!("{axes:?} {time} {attitude:e} {omega:e} {:e}", (rate - expected).norm());
            assert!(attitude < 1e-13, "{axes:?} {time} {attitude:e}");
            assert!(omega < 3e-13 && (rate - expected).norm() < 6e-13, "{axes:?} {time} {omega:e}");
        }
        let Prescribed::Turning(turning) = &motion else { panic!("{motion:?}") };
        let error = motion.at(10.0).unwrap().0.attitude.angle_to(known.at(10.0).unwrap().0.attitude);
        assert!(turning.attitude_error() < 1e-12 && error < 10.0 * turning.attitude_error());
        assert_eq!(motion.span(), Some([0.0, 10.0]));
        for outside in [-0.1, 10.1, f64::NAN] {
            assert!(matches!(motion.at(outside), Err(ref error) if error.is_parameter()));
        }
    }
    let singular = [of(Unary::Log, line(1.0, -0.5)), number(0.0), number(1.0)].map(formula);
    let refused = Prescribed::omega(start, RateAxes::Body, singular, 3.0);
    assert!(refused.unwrap_err().is_numerical());
}

/// A generic simulated motion under torque, with its attitudes as a table: the torque is recovered
/// with the order of the spline.
#[test]
fn the_torque_comes_back_from_a_table_of_attitudes() {
    let rotor = rotor();
    let torques = [TorqueModel::Constant(ConstantTorque::Space(Torque::new(2.0, -3.0, 1.2)))];
    let start = State {
        time: 0.0,
        attitude: Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap(),
        omega: AngularVelocity::new(0.7, -1.1, 0.4),
    };
    let tabled = |intervals: usize| {
        let times = Run::evenly(4.0, intervals + 1, Method::Auto, 1e-14).times;
        let motion = Trajectory::compute(&rotor, &torques, start, &times, Method::Auto, 1e-14).unwrap();
        let rows: Vec<_> = motion.samples().iter().map(|sample| sample.state.attitude).collect();
        Prescribed::attitude_table(&times, &rows).unwrap()
    };
    let check: Vec<f64> = (0..=333).map(|k| 4.0 * f64::from(k) / 333.0).collect();
    let truth = Trajectory::compute(&rotor, &torques, start, &check, Method::Auto, 1e-14).unwrap();
    let error = |intervals: usize| {
        let (motion, uncertainty) = tabled(intervals);
        let found = Trajectory::prescribed(&rotor, &motion, &check).unwrap();
        let pairs = found.samples().iter().zip(truth.samples());
        let torque = pairs.clone().map(|(a, b)| (a.torque - b.torque).norm()).fold(0.0, f64::max);
        let attitude = pairs.map(|(a, b)| a.state.attitude.angle_to(b.state.attitude)).fold(0.0, f64::max);
        // The stated uncertainty is not below the error.
        assert!(attitude < 2.0 * uncertainty.attitude + 1e-14, "{attitude:e} {uncertainty:?}");
        (torque, uncertainty)
    };
    let [(coarse, _), (fine, said), (finer, _)] = [40, 80, 160].map(error);
    let [first, second] = [coarse / fine, fine / finer].map(f64::log2);
    println!("torque within {coarse:e}, {fine:e}, {finer:e} N·m; orders {first:.2}, {second:.2}");
    assert!(first > 5.0 && second > 5.0, "{first} {second}");
    assert!(finer < 1e-5 && !said.is_noisy, "{finer:e} {said:?}");
    consistent(&tabled(80).0, 1.234, 1e-8);
    // Work and impulse are those of the simulated motion.
    let needed = Required::of_motion(&rotor, &tabled(160).0, 4.0).unwrap();
    let first = Required::of_motion(&rotor, &tabled(160).0, 0.0).unwrap();
    let last = truth.samples().last().unwrap();
    assert!((needed.work_since(&first) - last.work).abs() < 1e-6);
    assert!((needed.impulse_since(&first) - last.impulse).norm() < 1e-6);
    assert!((needed.torque_space() - Torque::new(2.0, -3.0, 1.2)).norm() < 1e-5);
}

#[test]
fn a_table_of_omega_is_the_motion_too() {
    let known = swaying();
    let times: Vec<f64> = (0..=120).map(|k| f64::from(k) / 30.0 + 0.004 * f64::from(k % 3)).collect();
    let states: Vec<State> = times.iter().map(|time| known.at(*time).unwrap().0).collect();
    let body: Vec<_> = states.iter().map(|state| state.omega.to_array()).collect();
    let space: Vec<_> = states.iter().map(|state| state.omega_space().to_array()).collect();
    for (axes, omega) in [(RateAxes::Body, body), (RateAxes::Space, space)] {
        let start = states[0].attitude;
        let (motion, uncertainty) = Prescribed::omega_table(start, axes, &times, &omega).unwrap();
        for time in [0.0, 1.111, 2.9, 4.0] {
            let ((a, rate), (b, expected)) = (motion.at(time).unwrap(), known.at(time).unwrap());
            assert!((a.omega - b.omega).norm() < 1e-7 && (rate - expected).norm() < 2e-5, "{axes:?} {time}");
            assert!(a.attitude.angle_to(b.attitude) < 1e-7, "{axes:?} {time}");
        }
        assert!(uncertainty.relative < 1e-3 && !uncertainty.is_noisy, "{uncertainty:?}");
    }
}

#[test]
fn a_table_says_when_it_is_noisy_or_coarse() {
    let known = swaying();
    let rows = |times: &[f64], noise: f64| -> Vec<Attitude> {
        let shaken = |(k, time): (usize, &f64)| {
            let angle = noise * (7.3 * (k * k) as f64).sin();
            let shake: Rotation<Body, Body> =
                Rotation::from_axis_angle(Direction::new(1.0, 2.0, -2.0), angle).unwrap();
            known.at(*time).unwrap().0.attitude * shake
        };
        times.iter().enumerate().map(shaken).collect()
    };
    let evenly = |count: usize| Run::evenly(6.0, count, Method::Auto, 1e-13).times;
    let said =
        |count, noise| Prescribed::attitude_table(&evenly(count), &rows(&evenly(count), noise)).unwrap().1;
    let (good, noisy, coarse) = (said(301, 0.0), said(301, 1e-5), said(21, 0.0));
    assert!(good.relative < 1e-4 && !good.is_noisy, "{good:?}");
    assert!(noisy.relative > 0.003 && noisy.is_noisy, "{noisy:?}");
    assert!(coarse.relative > 0.01 && !coarse.is_noisy, "{coarse:?}");
    // Too few rows are refused.
    let attitudes = rows(&evenly(13), 0.0);
    let parameter = |times: &[f64], rows: &[Attitude]| {
        assert!(matches!(Prescribed::attitude_table(times, rows), Err(ref error) if error.is_parameter()));
    };
    parameter(&evenly(13)[..3], &attitudes[..3]);
    parameter(&evenly(12), &attitudes);
    parameter(&[0.0, 1.0, 1.0, 2.0], &attitudes[..4]);
    parameter(&[0.0, 1.0, f64::NAN, 2.0], &attitudes[..4]);
    let far = Attitude::from_axis_angle(Direction::new(1.0, 0.0, 0.0), 1.7).unwrap();
    parameter(&[0.0, 1.0, 2.0, 3.0], &[Attitude::identity(), far, Attitude::identity(), far]);
}

#[test]
fn the_forces_on_given_points_make_the_torque_at_any_time() {
    let masses =
        [(1.5, [0.5, -1.0, 0.25]), (2.0, [-0.75, 0.5, 2.0]), (0.5, [1.0, 1.5, -0.5]), (0.9, [0.1, 0.2, 0.3])]
            .map(|(m, p)| Particle::<Body>::new(m, Position::from_array(p)).unwrap());
    let body = mass_properties_of_particles(&masses).unwrap();
    let rotor = Rotor::pivoted(&body, Position::new(0.3, 0.1, -0.2));
    for time in [0.0, 0.9, 2.2] {
        let needed = Required::of_motion(&rotor, &swaying(), time).unwrap();
        let forces = masses.map(|mass| needed.force_on(&mass, &rotor));
        let sum = forces.iter().fold(Torque::ZERO, |sum, force| sum + force.torque);
        assert!((sum - needed.torque).norm() < 1e-13 * needed.torque.norm());
    }
}

/// N = dL/dt, with the angular momentum of wheels in L.
#[test]
fn wheels_count_in_the_torque_that_a_motion_needs() {
    let held = Wheel::new(Direction::new(0.4, -0.2, 0.9), 3.7, Motor::HeldSpeed).unwrap();
    let free = Motor::Torque { inertia: 0.2, torque: 0.0, schedule: None };
    let free = Wheel::new(Direction::new(-0.5, 0.8, 0.1), -2.1, free).unwrap();
    let rotor = rotor().with_wheels(&[held, free]).unwrap();
    let motion = swaying();
    let (time, h) = (0.7, 1e-3);
    let l = |k: f64| Required::of_motion(&rotor, &motion, time + k * h).unwrap().momentum;
    let rate = ((l(1.0) - l(-1.0)) * 8.0 - (l(2.0) - l(-2.0))) / (12.0 * h);
    let needed = Required::of_motion(&rotor, &motion, time).unwrap();
    let error = (needed.torque_space() - Torque::from_array(rate.to_array())).norm();
    assert!(error < 1e-9 * needed.torque.norm(), "{error:e}");
    // The torque changes the carrier's energy only.
    let energy = |k: f64| Required::of_motion(&rotor, &motion, time + k * h).unwrap().kinetic_energy;
    let power = ((energy(1.0) - energy(-1.0)) * 8.0 - (energy(2.0) - energy(-2.0))) / (12.0 * h);
    assert!((power / needed.power - 1.0).abs() < 1e-8, "{power} {}", needed.power);
    // A motor does work of its own.
    let driven = Motor::Torque { inertia: 0.2, torque: 0.4, schedule: None };
    let driven = Wheel::new(Direction::new(-0.5, 0.8, 0.1), -2.1, driven).unwrap();
    let rotor = rotor.with_wheels(&[driven]).unwrap();
    assert!(matches!(Required::of_motion(&rotor, &motion, time), Err(ref error) if error.is_parameter()));
}
