//! Logs of right motions whose columns are named wrongly: the meaning is found, or the log is refused.

use polhode::infer::judge::{
    AttitudeSense, DeclaredByName, DeclaredReading, JudgeError, Judgement, MotionLog, OmegaAxes,
    QuaternionOrder, Reference, SignedAxes,
};
use polhode::prelude::*;

/// Numbers from 0 to 1 by the 64-bit generator of Knuth.
struct Draws(u64);

impl Draws {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[((self.next() * all.len() as f64) as usize).min(all.len() - 1)]
    }
}

/// A free body, or one under a torque along its axes, with three different moments and products of both signs.
fn scenario(draws: &mut Draws) -> Scenario {
    let (a, b) = (draws.within(1.0, 3.0), draws.within(1.0, 3.0));
    let moments = [a, b, draws.within((a - b).abs() + 0.2, a + b - 0.2)];
    let turn = Attitude::from_quaternion([0, 1, 2, 3].map(|_| draws.within(-1.0, 1.0))).unwrap().matrix();
    // R D Rᵀ
    let tensor: [[f64; 3]; 3] = std::array::from_fn(|i| {
        std::array::from_fn(|j| (0..3).map(|k| turn[i][k] * moments[k] * turn[j][k]).sum())
    });
    let products = [tensor[0][1], tensor[0][2], tensor[1][2]];
    let inertia =
        InertiaTensor::with_negative_products([tensor[0][0], tensor[1][1], tensor[2][2]], products).unwrap();
    let body = MassProperties::new(draws.within(0.3, 5.0), Position::new(0.1, -0.2, 0.3), inertia).unwrap();
    let attitude = match draws.next() < 0.2 {
        true => Attitude::identity(),
        false => Attitude::from_quaternion([0, 1, 2, 3].map(|_| draws.within(-1.0, 1.0))).unwrap(),
    };
    let omega = AngularVelocity::from_array([0; 3].map(|_| draws.within(-3.0, 3.0)));
    let time = draws.one_of(&[0.0, 0.0, 0.4]);
    let scenario = Scenario::new(body).starting(State { time, attitude, omega }).unwrap();
    if draws.next() < 0.3 {
        let torque = Torque::<Body>::from_array([0; 3].map(|_| draws.within(-0.5, 0.5)));
        return scenario.under([TorqueModel::Constant(ConstantTorque::Body(torque))]).unwrap();
    }
    scenario
}

/// v along other axes.
fn along(axes: SignedAxes, v: [f64; 3]) -> [f64; 3] {
    let one = |k: usize| axes.to_scenario(std::array::from_fn(|i| f64::from(u8::from(i == k))));
    std::array::from_fn(|k| one(k).iter().zip(v).map(|(a, b)| a * b).sum())
}

/// Difference of a log from the plain one.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Unusual {
    Nothing,
    Origin,
    Later,
    TimeUnit,
    Order,
    Sense,
    Axes,
    OmegaUnit,
    OmegaComponents,
    OmegaFrame,
}

/// A log with columns that are named as polhode's own, and with one or two things unusual.
fn log(draws: &mut Draws, scenario: &Scenario, unusual: &[Unusual]) -> MotionLog {
    let has = |one: Unusual| unusual.contains(&one);
    let rate = scenario.start().omega.norm();
    let every = draws.within(0.01, 0.1) / rate;
    let late = if has(Unusual::Later) { draws.within(2.0, 60.0) / rate } else { 0.0 };
    let times: Vec<f64> = (0..200).map(|k| scenario.start().time + late + every * f64::from(k)).collect();
    let reference = Reference::of(scenario, &times).unwrap();
    let factor = match has(Unusual::TimeUnit) {
        true => draws.one_of(&[1e3, 1e6, 1e9, 1.0 / 60.0]),
        false => 1.0,
    };
    let origin = match has(Unusual::Origin) || has(Unusual::Later) {
        true => draws.one_of(&[-1.0, 1.0]) * 10_f64.powf(draws.within(0.0, 7.0)),
        false => 0.0,
    };
    let order = if has(Unusual::Order) { QuaternionOrder::ScalarLast } else { QuaternionOrder::ScalarFirst };
    let sense = if has(Unusual::Sense) { AttitudeSense::SpaceToBody } else { AttitudeSense::BodyToSpace };
    let axes = if has(Unusual::Axes) { draws.one_of(&SignedAxes::ALL[1..]) } else { SignedAxes::SAME };
    let frame = if has(Unusual::OmegaFrame) { OmegaAxes::Space } else { OmegaAxes::Body };
    let unit = match has(Unusual::OmegaUnit) {
        true => draws.one_of(&[
            180.0 / std::f64::consts::PI,
            0.5 / std::f64::consts::PI,
            30.0 / std::f64::consts::PI,
        ]),
        false => 1.0,
    };
    let components = match has(Unusual::OmegaComponents) {
        true => {
            let one = draws.one_of(&SignedAxes::ALL);
            if draws.next() < 0.5 { one.reversed() } else { one }
        }
        false => SignedAxes::SAME,
    };
    let attitude = |state: &State| {
        let r = match sense {
            AttitudeSense::BodyToSpace => state.attitude.quaternion(),
            AttitudeSense::SpaceToBody => state.attitude.inverse().quaternion(),
        };
        let [x, y, z] = along(axes, [r[1], r[2], r[3]]);
        match order {
            QuaternionOrder::ScalarFirst => [r[0], x, y, z],
            QuaternionOrder::ScalarLast => [x, y, z, r[0]],
        }
    };
    let omega = |state: &State| {
        let omega = match frame {
            OmegaAxes::Body => state.omega.to_array(),
            OmegaAxes::Space => state.omega_space().to_array(),
        };
        along(components, along(axes, omega)).map(|c| c * unit)
    };
    let states = reference.states();
    let logged = states.iter().map(|state| (state.time + origin) * factor).collect();
    let log = MotionLog::new(logged, states.iter().map(attitude).collect()).unwrap();
    log.with_omega(states.iter().map(omega).collect()).unwrap()
}

/// Declaration by the names of polhode's own columns.
fn by_name() -> DeclaredReading {
    DeclaredReading {
        order: Some(QuaternionOrder::ScalarFirst),
        sense: Some(AttitudeSense::BodyToSpace),
        omega_axes: Some(OmegaAxes::Body),
        by_name: DeclaredByName { order: true, sense: true, omega_axes: true },
        ..DeclaredReading::default()
    }
}

/// Seeded; `POLHODE_LOGS=2000 cargo test -p polhode --test all judge_readings` draws more.
#[test]
fn a_right_motion_is_never_called_wrong() {
    let count = std::env::var("POLHODE_LOGS").map_or(40, |count| count.parse::<u64>().unwrap());
    let kinds = [
        Unusual::Nothing,
        Unusual::Origin,
        Unusual::Later,
        Unusual::TimeUnit,
        Unusual::Order,
        Unusual::Sense,
        Unusual::Axes,
        Unusual::OmegaUnit,
        Unusual::OmegaComponents,
        Unusual::OmegaFrame,
    ];
    let mut refused = Vec::new();
    for seed in 0..count {
        let mut draws = Draws(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) + 1);
        draws.next();
        let scenario = scenario(&mut draws);
        let first = kinds[seed as usize % kinds.len()];
        let unusual = [first, draws.one_of(&kinds)];
        let unusual = if draws.next() < 0.5 { &unusual[..] } else { &unusual[..1] };
        let log = log(&mut draws, &scenario, unusual);
        match Judgement::of(&scenario, &log, &by_name()) {
            Ok(judgement) => {
                let found = judgement.readings.reading;
                // A clock that is fitted, and times that are rounded.
                let most = 1e-9 + 10.0 * judgement.floor();
                let off = judgement.largest_attitude_error();
                assert!(off < most, "{seed} {unusual:?}: {off} rad as {found}");
                let omega = judgement.errors.rates.as_ref().unwrap();
                let off = omega.omega.iter().copied().fold(0.0, f64::max);
                assert!(off < most, "{seed} {unusual:?}: ω {off} as {:?}", judgement.readings.omega);
            }
            Err(
                JudgeError::NoReading { .. }
                | JudgeError::Ambiguous { .. }
                | JudgeError::FarTimes { .. }
                // In the stated unit the times lie beyond the end of a motion that runs away.
                | JudgeError::Ends { .. }
                | JudgeError::AmbiguousOmega { .. }
                | JudgeError::NoOmega { .. },
            ) => {
                refused.push((seed, unusual.to_vec()));
            }
            Err(error) => panic!("{seed} {unusual:?}: {error}"),
        }
    }
    assert!(refused.len() as u64 <= count / 10, "{} refused: {refused:?}", refused.len());
    println!("{} of {count} refused: {refused:?}", refused.len());
}

/// A motion with a mistake is not called right by taking its numbers for something else.
#[test]
fn a_wrong_motion_is_never_called_right() {
    let count = std::env::var("POLHODE_LOGS").map_or(30, |count| count.parse::<u64>().unwrap());
    for seed in 0..count {
        let mut draws = Draws(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) + 7);
        draws.next();
        let scenario = scenario(&mut draws);
        let start = scenario.start();
        // Without ω × I ω, or standing still, or turned the other way.
        let kind = seed % 3;
        let rate = start.omega.norm();
        let times: Vec<f64> = (0..200).map(|k| start.time + 0.05 * f64::from(k) / rate).collect();
        let turned = |time: &f64| {
            let angle = match kind {
                0 => rate * (time - start.time),
                1 => 0.0,
                _ => -rate * (time - start.time),
            };
            let axis = Direction::<Body>::from_array(start.omega.to_array());
            (start.attitude * Rotation::<Body, Body>::about(axis, angle).unwrap()).quaternion()
        };
        let log = MotionLog::new(times.clone(), times.iter().map(turned).collect()).unwrap();
        if let Ok(judgement) = Judgement::of(&scenario, &log, &by_name()) {
            let (off, found) = (judgement.largest_attitude_error(), judgement.readings.reading);
            assert!(off > 1e-3, "{seed}: {off} rad as {found}");
        }
    }
}
