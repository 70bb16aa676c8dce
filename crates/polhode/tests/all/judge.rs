//! Simulated logs of other programs: the meaning of their numbers, their error, and its kind.

use polhode::infer::judge::{
    AccuracyOrder, AttitudeSense, DeclaredReading, Growth, JudgeError, Judgement, MotionLog, OmegaAxes,
    PartKind, QuaternionOrder, Reading, Readings, Reference, SignedAxes, StepErrors,
};
use polhode::prelude::*;

fn rotor_inertia() -> InertiaTensor<Body> {
    InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap()
}

fn free() -> Scenario {
    let body = MassProperties::new(2.3, Position::new(0.1, -0.2, 0.05), rotor_inertia()).unwrap();
    let attitude = Attitude::from_quaternion([0.6, -0.3, 0.5, 0.2]).unwrap();
    let start = State { time: 0.4, attitude, omega: AngularVelocity::new(0.5, -1.3, 0.7) };
    Scenario::new(body).starting(start).unwrap()
}

fn times(from: f64, every: f64, count: usize) -> Vec<f64> {
    (0..count).map(|k| from + every * k as f64).collect()
}

fn exact(scenario: &Scenario, times: &[f64]) -> Vec<State> {
    Reference::of(scenario, times).unwrap().states().to_vec()
}

/// Returns each exact attitude rotated by θ (body axes), a function of the state.
fn turned(states: &[State], theta: impl Fn(&State) -> [f64; 3]) -> Vec<[f64; 4]> {
    let turn = |state: &State| {
        let theta = Direction::<Body>::from_array(theta(state));
        let angle = theta.norm();
        if angle == 0.0 {
            return state.attitude.quaternion();
        }
        (state.attitude * Rotation::<Body, Body>::from_axis_angle(theta, angle).unwrap()).quaternion()
    };
    states.iter().map(turn).collect()
}

/// Returns the log of a program whose numbers have this meaning.
fn written(states: &[State], reading: &Reading, omega_axes: OmegaAxes) -> MotionLog {
    let along = |v: [f64; 3]| {
        let one = |k: usize| reading.axes.to_scenario(std::array::from_fn(|i| f64::from(u8::from(i == k))));
        std::array::from_fn(|k| one(k).iter().zip(v).map(|(a, b)| a * b).sum())
    };
    let attitude = |state: &State| {
        let r = match reading.sense {
            AttitudeSense::BodyToSpace => state.attitude.quaternion(),
            AttitudeSense::SpaceToBody => state.attitude.inverse().quaternion(),
        };
        let [x, y, z]: [f64; 3] = along([r[1], r[2], r[3]]);
        match reading.order {
            QuaternionOrder::ScalarFirst => [r[0], x, y, z],
            QuaternionOrder::ScalarLast => [x, y, z, r[0]],
        }
    };
    let omega = |state: &State| match omega_axes {
        OmegaAxes::Body => along(state.omega.to_array()),
        OmegaAxes::Space => along(state.omega_space().to_array()),
    };
    let times = states.iter().map(|state| state.time / reading.time_factor + reading.time_origin).collect();
    let log = MotionLog::new(times, states.iter().map(attitude).collect()).unwrap();
    log.with_omega(states.iter().map(omega).collect()).unwrap()
}

#[test]
fn every_meaning_of_the_numbers_is_found() {
    let scenario = free();
    let states = exact(&scenario, &times(0.4, 0.02, 150));
    for axes in SignedAxes::ALL {
        for order in QuaternionOrder::ALL {
            for sense in AttitudeSense::ALL {
                for (omega_axes, time_origin) in [(OmegaAxes::Body, -0.4), (OmegaAxes::Space, 17.25)] {
                    let reading = Reading { order, sense, axes, time_origin, time_factor: 1.0 };
                    let log = written(&states, &reading, omega_axes);
                    let found = Readings::of(&log, &scenario, &DeclaredReading::default()).unwrap();
                    let Reading { time_origin: origin, .. } = found.reading;
                    assert!((origin - time_origin).abs() < 1e-14, "{reading}: {}", found.reading);
                    assert_eq!(Reading { time_origin, ..found.reading }, reading);
                    assert_eq!((found.omega_axes(), found.equivalent), (Some(omega_axes), 1), "{reading}");
                    let read = found.read(&log);
                    for (state, omega) in states.iter().zip(read.omega.unwrap()) {
                        assert!((state.omega - omega).norm() < 1e-14, "{reading}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_log_in_single_precision_has_the_same_meaning() {
    let scenario = free();
    let states = exact(&scenario, &times(0.4, 0.02, 150));
    let reading = Reading {
        order: QuaternionOrder::ScalarLast,
        sense: AttitudeSense::SpaceToBody,
        axes: SignedAxes::ALL[7],
        time_origin: -0.4,
        time_factor: 1.0,
    };
    let log = written(&states, &reading, OmegaAxes::Space);
    let single = |c: &f64| f64::from(*c as f32);
    let attitude = log.attitude().iter().map(|q| q.each_ref().map(single)).collect();
    let omega = log.omega().unwrap().iter().map(|w| w.each_ref().map(single)).collect();
    let log = MotionLog::new(log.times().to_vec(), attitude).unwrap().with_omega(omega).unwrap();
    let judgement = Judgement::of(&scenario, &log, &DeclaredReading::default()).unwrap();
    assert_eq!(judgement.readings.reading.axes, reading.axes);
    assert!(judgement.is_single_precision && judgement.largest_attitude_error() < 3e-7);
    let split = &judgement.split;
    assert!(split.noise > 0.5 * split.total && split.main_parts().is_empty(), "{split:?}");
}

/// If the numbers do not determine the meaning, either it does not matter or a declaration is
/// requested.
#[test]
fn what_the_numbers_do_not_tell_is_asked() {
    // About z from the identity: axes that differ by rotations about z give the same motion.
    let body =
        MassProperties::new(2.3, Position::ZERO, InertiaTensor::diagonal([2.0, 3.0, 4.0]).unwrap()).unwrap();
    let start =
        State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.0, 0.0, 1.5) };
    let spinning = Scenario::new(body).starting(start).unwrap();
    let states = exact(&spinning, &times(0.0, 0.02, 300));
    let upwards = SignedAxes::ALL.into_iter().find(|axes| axes.to_string() == "(x, z, −y)").unwrap();
    let plain = Reading {
        order: QuaternionOrder::ScalarFirst,
        sense: AttitudeSense::BodyToSpace,
        axes: upwards,
        time_origin: 0.0,
        time_factor: 1.0,
    };
    // Such a motion does not determine which axis is up, so a declaration is requested. ω is along
    // both kinds of axes.
    let log = written(&states, &plain, OmegaAxes::Space);
    let error = Readings::of(&log, &spinning, &DeclaredReading::default()).unwrap_err();
    assert!(matches!(&error, JudgeError::Ambiguous { fitting: 8, .. }), "{error}");
    let declared = DeclaredReading { axes: Some(upwards), ..Default::default() };
    let found = Readings::of(&log, &spinning, &declared).unwrap();
    assert_eq!((found.omega_axes(), found.equivalent), (Some(OmegaAxes::Body), 1), "{:?}", found.tried);

    let scenario = free();
    let at = times(0.4, 0.02, 150);
    let states = exact(&scenario, &at);
    // Numbers that are not a motion of this kind.
    let wild: Vec<[f64; 4]> =
        (0..150).map(|k| [0, 1, 2, 3].map(|i| (f64::from(k * k) * 1.7 + f64::from(i)).sin())).collect();
    let log = MotionLog::new(at.clone(), wild).unwrap();
    let error = Readings::of(&log, &scenario, &DeclaredReading::default()).unwrap_err();
    assert!(matches!(&error, JudgeError::NoReading { tried } if tried.len() >= 4), "{error}");
    // Declared, they are accepted as declared.
    let declared = DeclaredReading {
        order: Some(QuaternionOrder::ScalarFirst),
        sense: Some(AttitudeSense::BodyToSpace),
        ..Default::default()
    };
    assert!(Readings::of(&log, &scenario, &declared).unwrap().tried[0].relative > 1.0);

    // Equations of motion that are wrong from the first step on: the first row determines the
    // meaning. Here ω along body axes was taken as along space axes.
    let mut attitude = scenario.start().attitude;
    let mut leapt = vec![attitude.quaternion()];
    for state in &states[1..] {
        let omega = Direction::<Space>::from_array(state.omega.to_array());
        attitude = Rotation::<Space, Space>::from_axis_angle(omega, 0.02 * omega.norm()).unwrap() * attitude;
        leapt.push(attitude.quaternion());
    }
    let last = |[w, x, y, z]: [f64; 4]| [x, y, z, w];
    let log = MotionLog::new(at.clone(), leapt.into_iter().map(last).collect()).unwrap();
    let log = log.with_omega(states.iter().map(|s| s.omega.to_array()).collect()).unwrap();
    let found = Readings::of(&log, &scenario, &DeclaredReading::default()).unwrap();
    assert_eq!(found.reading.order, QuaternionOrder::ScalarLast);
    assert_eq!(
        (found.reading.sense, found.omega_axes()),
        (AttitudeSense::BodyToSpace, Some(OmegaAxes::Body))
    );

    // ω that is neither along space axes nor along body axes.
    let good = MotionLog::new(at.clone(), states.iter().map(|s| s.attitude.quaternion()).collect()).unwrap();
    let log = good.with_omega(vec![[0.1, 0.2, -0.3]; 150]).unwrap();
    let error = Readings::of(&log, &scenario, &DeclaredReading::default()).unwrap_err();
    assert!(matches!(error, JudgeError::NoOmega { .. }), "{error}");
    let declared = DeclaredReading { omega_axes: Some(OmegaAxes::Space), ..Default::default() };
    assert_eq!(Readings::of(&log, &scenario, &declared).unwrap().omega_axes(), Some(OmegaAxes::Space));
}

/// A program that logs from its first step on, with times late by one step: the stated times are
/// used.
#[test]
fn the_times_of_a_rough_run_are_not_shifted() {
    let scenario = free();
    let states = exact(&scenario, &times(0.41, 0.01, 300));
    let late = turned(&states, |s| (s.omega * -0.006).to_array());
    let log = MotionLog::new(states.iter().map(|s| s.time).collect(), late).unwrap();
    let judgement = Judgement::of(&scenario, &log, &DeclaredReading::default()).unwrap();
    assert_eq!(judgement.readings.reading.time_origin, 0.0);
    let [clock] = judgement.split.main_parts()[..] else { panic!("{:?}", judgement.split) };
    assert!(clock.kind == PartKind::Clock && (clock.value.unwrap()[0] + 0.006).abs() < 1e-5, "{clock:?}");
}

/// An error of 1e-10 rad is found to 2e-6 (relative) in a row, the limit of double precision, and
/// to 1e-7 in the mean.
#[test]
fn a_small_error_is_known_to_six_digits() {
    let scenario = free();
    let states = exact(&scenario, &times(0.4, 0.013, 2000));
    let wrong = turned(&states, |s| [6e-11, -8e-11 * (s.time * 3.0).sin(), 8e-11 * (s.time * 3.0).cos()]);
    let log = MotionLog::new(states.iter().map(|s| s.time).collect(), wrong).unwrap();
    let angles = Judgement::of(&scenario, &log, &DeclaredReading::default()).unwrap().errors.angles();
    let mean = |of: &dyn Fn(f64) -> f64| angles.iter().map(|&angle| of(angle)).sum::<f64>() / 2000.0;
    assert!((mean(&|angle| angle) / 1e-10 - 1.0).abs() < 1e-7);
    assert!(mean(&|angle| (angle / 1e-10 - 1.0).powi(2)).sqrt() < 2e-6);
}

#[test]
fn rates_energy_and_momentum_are_off_by_what_they_are() {
    let scenario = free();
    let states = exact(&scenario, &times(0.4, 0.05, 200));
    let attitude = turned(&states, |_| [0.01, -0.02, 0.015]);
    // ω too large by one per cent, in space axes.
    let omega: Vec<[f64; 3]> = states.iter().map(|s| (s.omega_space() * 1.01).to_array()).collect();
    let log = MotionLog::new(states.iter().map(|s| s.time).collect(), attitude.clone())
        .unwrap()
        .with_omega(omega)
        .unwrap();
    let declared = DeclaredReading { omega_axes: Some(OmegaAxes::Space), ..Default::default() };
    let errors = Judgement::of(&scenario, &log, &declared).unwrap().errors;
    let rates = errors.rates.as_ref().unwrap();
    let rotor = scenario.rotor();
    let (largest_t, largest_l) =
        (rotor.kinetic_energy(states[0].omega), rotor.angular_momentum(states[0].omega).norm());
    let largest_rate = states.iter().map(|s| s.omega.norm()).fold(0.0, f64::max);
    for (k, state) in states.iter().enumerate() {
        let read = Attitude::from_quaternion(attitude[k]).unwrap();
        let omega = read.inverse() * (state.omega_space() * 1.01);
        let (l, right) =
            (read * rotor.angular_momentum(omega), state.attitude * rotor.angular_momentum(state.omega));
        let off = (omega - state.omega).norm() / largest_rate;
        assert!((rates.omega[k] - off).abs() < 1e-14);
        assert!((rates.kinetic_energy[k] - (rotor.kinetic_energy(omega) / largest_t - 1.0)).abs() < 1e-13);
        assert!((rates.momentum[k] - (l.norm() / largest_l - 1.0)).abs() < 1e-13);
        assert!((rates.momentum_direction[k] - l.angle_to(right)).abs() < 1e-14);
    }
}

/// Every component of an error is found with its numbers, in the presence of all others.
#[test]
fn an_error_is_split_into_its_parts() {
    let scenario = free();
    let states = exact(&scenario, &times(0.4, 0.02, 1500));
    let (start, drift) = ([2e-5, -1e-5, 3e-5], [4e-7, 6e-7, -5e-7]);
    let (axes, clock, rate) = ([-1e-5, 2e-5, 1.5e-5], 3e-5, 2e-6);
    let planted = |s: &State| {
        let since = s.time - 0.4;
        let space = Direction::<Space>::from_array([0, 1, 2].map(|k| start[k] + drift[k] * since));
        let (space, omega) = ((s.attitude.inverse() * space).to_array(), s.omega.to_array());
        [0, 1, 2].map(|k| space[k] + axes[k] + (clock + rate * since) * omega[k])
    };
    let log = MotionLog::new(states.iter().map(|s| s.time).collect(), turned(&states, planted)).unwrap();
    let split = Judgement::of(&scenario, &log, &DeclaredReading::default()).unwrap().split;
    let expected = [start, axes, [clock, 0.0, 0.0], [rate, 0.0, 0.0], drift];
    for ((part, kind), expected) in split.parts.iter().zip(PartKind::ALL).zip(expected) {
        assert_eq!(part.kind, kind);
        for (value, expected) in part.value.unwrap().into_iter().zip(expected) {
            assert!((value - expected).abs() < 1e-3 * expected.abs() + 1e-11, "{kind:?}: {value} {expected}");
        }
    }
    assert!(split.rest < 1e-3 * split.total && split.until > 30.0, "{split:?}");
}

/// A start that is wrong by a radian is reported, together with the other errors.
#[test]
fn a_wrong_start_is_taken_out() {
    let scenario = free();
    let states = exact(&scenario, &times(0.4, 0.02, 500));
    let off = Rotation::<Space, Space>::from_axis_angle(Direction::new(0.3, -0.4, 0.5), 0.9).unwrap();
    let wrong: Vec<[f64; 4]> = states.iter().map(|s| (off * s.attitude).quaternion()).collect();
    let log = MotionLog::new(states.iter().map(|s| s.time).collect(), wrong).unwrap();
    let judgement = Judgement::of(&scenario, &log, &DeclaredReading::default()).unwrap();
    assert!(judgement.readings.from_own_start);
    let [start] = judgement.split.main_parts()[..] else { panic!("{:?}", judgement.split) };
    assert_eq!(start.kind, PartKind::Start);
    let axis = Direction::<Space>::new(0.3, -0.4, 0.5).direction().unwrap().to_array();
    for (value, axis) in start.value.unwrap().into_iter().zip(axis) {
        assert!((value - 0.9 * axis).abs() < 1e-9, "{start:?}");
    }
    assert!((judgement.last_attitude_error() - 0.9).abs() < 1e-9);
}

#[test]
fn growth_is_that_which_was_planted() {
    let scenario = free();
    let states = exact(&scenario, &times(0.4, 0.02, 2000));
    for exponent in [0.0, 0.5, 1.0, 2.0, 3.0] {
        let size = |s: &State| 1e-7 * (s.time - 0.4).powf(exponent);
        let wrong = turned(&states, |s| [0.6, -0.48, 0.64].map(|c| c * size(s)));
        let log = MotionLog::new(states.iter().map(|s| s.time).collect(), wrong).unwrap();
        let growth = Judgement::of(&scenario, &log, &DeclaredReading::default()).unwrap().growth;
        let Growth::Power { exponent: found } = growth else { panic!("{growth:?}") };
        assert!((found - exponent).abs() < 0.02, "{found} {exponent}");
    }
    let at: Vec<f64> = states.iter().map(|s| s.time).collect();
    let errors: Vec<f64> = at.iter().map(|t| 1e-9 * (0.37 * (t - 0.4)).exp()).collect();
    let Growth::Exponential { rate } = Growth::of(&at, &errors, 1e-15) else { panic!("an exponential") };
    assert!((rate - 0.37).abs() < 1e-3);
}

/// The order of RK4 and of Euler's method; no error for an exact motion.
#[test]
fn the_order_of_a_method_is_found_by_its_steps() {
    let scenario = free();
    let slope = |y: &[f64; 7]| {
        let omega = AngularVelocity::<Body>::new(y[4], y[5], y[6]);
        let l = scenario.rotor().angular_momentum(omega);
        let [a, b, c] = principal_solve(&scenario, l.cross(omega).to_array());
        let [w, x, z, u] = [y[0], y[1], y[2], y[3]];
        let [p, q, r] = omega.to_array();
        [
            -0.5 * (x * p + z * q + u * r),
            0.5 * (w * p + z * r - u * q),
            0.5 * (w * q + u * p - x * r),
            0.5 * (w * r + x * q - z * p),
            a,
            b,
            c,
        ]
    };
    let plus = |y: &[f64; 7], k: &[f64; 7], h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
    let run = |rk4: bool, h: f64| {
        let start = scenario.start();
        let [w, x, y, z] = start.attitude.quaternion();
        let [p, q, r] = start.omega.to_array();
        let mut now = [w, x, y, z, p, q, r];
        let (mut attitude, mut at) = (vec![[w, x, y, z]], vec![start.time]);
        for k in 1..=(4.0 / h).round() as usize {
            let k1 = slope(&now);
            now = if rk4 {
                let k2 = slope(&plus(&now, &k1, h / 2.0));
                let k3 = slope(&plus(&now, &k2, h / 2.0));
                let k4 = slope(&plus(&now, &k3, h));
                std::array::from_fn(|i| now[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
            } else {
                plus(&now, &k1, h)
            };
            attitude.push([now[0], now[1], now[2], now[3]]);
            at.push(start.time + h * k as f64);
        }
        let log = MotionLog::new(at, attitude).unwrap();
        Judgement::of(&scenario, &log, &DeclaredReading::default()).unwrap()
    };
    for (rk4, steps, expected) in [(true, [0.02, 0.01, 0.005], 4.0), (false, [0.004, 0.002, 0.001], 1.0)] {
        let judged = steps.map(|h| run(rk4, h));
        let errors = judged.each_ref().map(|judgement| judgement.errors.angles());
        let of = |k: usize| StepErrors {
            step: steps[k],
            times: &judged[k].motion.times,
            errors: &errors[k],
            floor: judged[k].floor(),
        };
        let order = AccuracyOrder::of(&[of(1), of(2), of(0)]).unwrap();
        for found in order.orders {
            assert!((found.unwrap() - expected).abs() < 0.1, "{found:?} {expected}");
        }
    }
}

/// Returns I⁻¹ v by the principal axes.
fn principal_solve(scenario: &Scenario, v: [f64; 3]) -> [f64; 3] {
    let principal = scenario.rotor().principal();
    let v = Torque::<Body>::from_array(v);
    let along = |k: usize| {
        let axis = principal.axis(k);
        (axis * (axis.dot(v) / principal.moments()[k])).to_array()
    };
    let (a, b, c) = (along(0), along(1), along(2));
    [0, 1, 2].map(|i| a[i] + b[i] + c[i])
}

/// A motion of polhode itself under torque has no detectable error.
#[test]
fn what_is_exact_is_not_blamed() {
    let gravity = UniformGravity::STANDARD;
    let top = free().held_at(Position::ZERO).unwrap().with_torques([TorqueModel::Gravity(gravity)]).unwrap();
    let at = times(0.4, 0.01, 800);
    for scenario in [free(), top] {
        let states = exact(&scenario, &at);
        let log =
            MotionLog::new(at.clone(), states.iter().map(|s| s.attitude.quaternion()).collect()).unwrap();
        let log = log.with_omega(states.iter().map(|s| s.omega.to_array()).collect()).unwrap();
        let judgement = Judgement::of(&scenario, &log, &DeclaredReading::default()).unwrap();
        assert!(judgement.largest_attitude_error() < 1e-15);
        assert_eq!(judgement.growth, Growth::Unknown);
        assert!(judgement.floor() < 1e-11);
    }
}

#[test]
fn times_without_a_motion_are_refused() {
    let scenario = free();
    let quaternions = vec![[0.6, -0.3, 0.5, 0.2]; 3];
    let log = MotionLog::new(vec![0.0, 0.5, 1.0], quaternions).unwrap();
    let declared = DeclaredReading { time_origin: Some(0.0), ..Default::default() };
    let error = Judgement::of(&scenario, &log, &declared).unwrap_err();
    assert_eq!(error, JudgeError::BeforeStart { time: 0.0, start: 0.4 });
    let led = polhode::motion::Prescribed::euler_rates([0.0, 1.1, 0.3], [0.5, 0.0, 30.0]).unwrap();
    let prescribed = free().prescribed_as(led).unwrap();
    assert_eq!(
        Judgement::of(&prescribed, &log, &DeclaredReading::default()).unwrap_err(),
        JudgeError::NoMotion
    );
}
