//! Logs of correct motions with wrong column names: the meaning is found.

use polhode::infer::judge::{
    AttitudeSense, DeclaredByName, DeclaredReading, JudgeError, Judgement, MotionLog, OmegaAxes,
    OmegaReading, QuaternionOrder, Reading, Reference, SignedAxes,
};
use polhode::motion::{Event, EventAction, Measure, Sense};
use polhode::prelude::*;

/// Random numbers from 0 to 1 by Knuth's 64-bit generator.
pub(crate) struct Draws(u64);

impl Draws {
    pub(crate) fn of(seed: u64, first: u64) -> Self {
        let mut draws = Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) + first);
        draws.next();
        draws
    }

    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    pub(crate) fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[((self.next() * all.len() as f64) as usize).min(all.len() - 1)]
    }
}

/// Returns a free body, or one under a torque along its axes, with three different moments and
/// products of both signs.
pub(crate) fn scenario(draws: &mut Draws) -> Scenario {
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
        return scenario.with_torques([TorqueModel::Constant(ConstantTorque::Body(torque))]).unwrap();
    }
    scenario
}

/// Returns v along other axes.
pub(crate) fn along(axes: SignedAxes, v: [f64; 3]) -> [f64; 3] {
    let one = |k: usize| axes.to_scenario(std::array::from_fn(|i| f64::from(u8::from(i == k))));
    std::array::from_fn(|k| one(k).iter().zip(v).map(|(a, b)| a * b).sum())
}

/// Difference of a log from polhode's own format.
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

/// Returns a log with polhode's column names and one or two differences.
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
        true => draws.one_of(&SignedAxes::ALL),
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

/// Returns the declaration by the names of polhode's own columns.
pub(crate) fn by_name() -> DeclaredReading {
    DeclaredReading {
        order: Some(QuaternionOrder::ScalarFirst),
        sense: Some(AttitudeSense::BodyToSpace),
        omega_axes: Some(OmegaAxes::Body),
        by_name: DeclaredByName {
            order: true,
            sense: true,
            omega_axes: true,
            time_unit: true,
            omega_unit: true,
        },
        ..DeclaredReading::default()
    }
}

/// Returns the number of logs: `POLHODE_LOGS=2000 cargo test -p polhode --test all judge_ --
/// --nocapture` draws more.
pub(crate) fn count(default: u64) -> u64 {
    std::env::var("POLHODE_LOGS").map_or(default, |count| count.parse().unwrap())
}

/// Logs with one or two differences are read correctly, unless the axes are ambiguous.
#[test]
fn a_right_motion_is_found() {
    let count = count(40);
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
    let (mut refused, mut missed) = (Vec::new(), 0);
    for seed in 0..count {
        let mut draws = Draws::of(seed, 1);
        let scenario = scenario(&mut draws);
        let first = kinds[seed as usize % kinds.len()];
        let unusual = [first, draws.one_of(&kinds)];
        let unusual = if draws.next() < 0.5 { &unusual[..] } else { &unusual[..1] };
        let log = log(&mut draws, &scenario, unusual);
        match Judgement::of(&scenario, &log, &by_name()) {
            Ok(judgement) => {
                let readings = &judgement.readings;
                let found = readings.reading;
                assert_eq!(readings.mistakes, [], "{seed} {unusual:?}");
                // A fitted clock, and rounded times.
                let most = 1e-9 + 10.0 * judgement.floor();
                let off = judgement.largest_attitude_error();
                assert!(off < most, "{seed} {unusual:?}: {off} rad as {found}");
                let omega = judgement.errors.rates.as_ref().unwrap();
                let off = omega.omega.iter().copied().fold(0.0, f64::max);
                assert!(off < most, "{seed} {unusual:?}: ω {off} as {:?}", judgement.readings.omega);
                let is_plain = found.time_factor == 1.0
                    && (found.order, found.sense)
                        == (QuaternionOrder::ScalarFirst, AttitudeSense::BodyToSpace)
                    && readings.omega == Some(OmegaReading::plain(OmegaAxes::Body));
                assert_eq!(readings.is_against_names, !is_plain, "{seed} {unusual:?} {found}");
            }
            Err(error) => {
                refused.push(format!("{seed} {unusual:?}: {error}"));
                // Other axes and a later first row are not searched together. A short rotation from
                // the identity fits many axes.
                let is_unsought = [Unusual::Axes, Unusual::Later].iter().all(|one| unusual.contains(one));
                let is_ambiguous = matches!(error, JudgeError::Ambiguous { .. });
                if !(is_unsought || is_ambiguous && unusual.contains(&Unusual::Axes)) {
                    missed += 1;
                }
            }
        }
    }
    println!("{} of {count} refused: {refused:#?}", refused.len());
    assert_eq!(missed, 0, "{refused:#?}");
}

/// A body under torque that starts slowly: a row in ms, read in s, is minutes later. The log may
/// also begin after the start.
#[test]
fn a_torqued_body_is_found_in_another_unit_and_later() {
    let (scenario, states) = torqued(vec![]);
    let written = |states: &[State], time: &dyn Fn(f64) -> f64| {
        let times = states.iter().map(|state| time(state.time)).collect();
        MotionLog::new(times, states.iter().map(|state| state.attitude.quaternion()).collect()).unwrap()
    };
    for (name, origin, factor) in
        [("ms", 0.0, 1e3), ("ms", 55.0, 1e3), ("µs", 0.0, 1e6), ("Unix, ms", 1.7e9, 1e3)]
    {
        let log = written(&states, &|t| (t + origin) * factor);
        let judgement = Judgement::of(&scenario, &log, &by_name()).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(judgement.readings.reading.time_factor, 1.0 / factor, "{name} {origin}");
        assert!(judgement.largest_attitude_error() < 1e-9 + 10.0 * judgement.floor(), "{name} {origin}");
        assert!(judgement.readings.is_against_names);
    }
    for (first, factor) in [(2, 1.0), (5, 1.0), (30, 1.0), (140, 1.0), (60, 1e9)] {
        let log = written(&states[first..], &|t| (t + 321.5) * factor);
        let judgement = Judgement::of(&scenario, &log, &by_name()).unwrap();
        let Reading { time_origin, time_factor, .. } = judgement.readings.reading;
        assert_eq!(time_factor, 1.0 / factor, "{first}");
        assert!((time_origin / factor - 321.5).abs() < 1e-7, "{first}: {time_origin}");
        assert!(judgement.largest_attitude_error() < 1e-7 && judgement.readings.mistakes.is_empty());
    }
}

/// A body whose motion is stopped by an event long before the last time of the log, in the stated
/// unit.
#[test]
fn a_motion_that_stops_is_found_in_another_unit() {
    let stop = Event::new("stop", Measure::Time, 20.0, Sense::Either, EventAction::Stop).unwrap();
    let (scenario, states) = torqued(vec![stop]);
    let times = states.iter().map(|state| state.time * 1e3).collect();
    let attitude: Vec<[f64; 4]> = states.iter().map(|state| state.attitude.quaternion()).collect();
    let log = MotionLog::new(times, attitude.clone()).unwrap();
    let judgement = Judgement::of(&scenario, &log, &by_name()).unwrap();
    assert_eq!(judgement.readings.reading.time_factor, 1e-3);
    assert!(judgement.largest_attitude_error() < 1e-9);
    // Hours are not among the candidates: no unit fits.
    let log = MotionLog::new(states.iter().map(|state| state.time / 3600.0).collect(), attitude).unwrap();
    let error = Judgement::of(&scenario, &log, &by_name()).unwrap_err();
    assert!(matches!(error, JudgeError::OtherRate { .. }), "{error}");
}

/// Returns a body under constant torque along body axes from a slow start, with events, and its
/// states over 10 s.
fn torqued(events: Vec<Event>) -> (Scenario, Vec<State>) {
    let inertia = InertiaTensor::with_negative_products([0.42, 0.61, 0.77], [-0.05, 0.07, 0.04]).unwrap();
    let body = MassProperties::new(2.6, Position::ZERO, inertia).unwrap();
    let attitude = Attitude::from_quaternion([0.7, -0.3, 0.5, 0.4]).unwrap();
    let start = State { time: 0.0, attitude, omega: AngularVelocity::new(0.1, 0.2, -0.1) };
    let torque = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.3, -0.1, 0.2)));
    let scenario = Scenario::new(body).starting(start).unwrap().with_torques([torque]).unwrap();
    let scenario = scenario.watching(events).unwrap();
    let times: Vec<f64> = (0..201).map(|k| 0.05 * f64::from(k)).collect();
    let states = Reference::of(&scenario, &times).unwrap().states().to_vec();
    (scenario, states)
}
