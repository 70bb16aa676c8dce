//! Scenarios with every torque model, compared with their true motions in
//! `fixtures/motion_errors.toml`. The generator of the fixture reads the same texts and shares no
//! code with the program.

mod estimate;

use std::path::Path;

use polhode::motion::Solution;
use polhode::prelude::*;
use polhode_scenario::read as scenario;

/// A scenario and its true states.
struct Case {
    name: String,
    kind: String,
    scenario: Scenario,
    /// Amplification of a small initial difference over the run; `None` for a long free motion.
    growth: Option<f64>,
    truth: Vec<Truth>,
}

/// A true state; each number is a double-double.
struct Truth {
    time: f64,
    attitude: [[f64; 2]; 4],
    omega_body: [[f64; 2]; 3],
}

/// Error of a state.
#[derive(Clone, Copy, Debug)]
struct Off {
    /// Angle between the attitudes, rad.
    attitude: f64,
    /// Relative error of ω: |Δω|/|ω|.
    omega: f64,
}

impl Case {
    fn all() -> Vec<Self> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/motion_errors.toml");
        let fixture: toml::Table = std::fs::read_to_string(path).unwrap().parse().unwrap();
        fixture["case"].as_array().unwrap().iter().map(Self::read).collect()
    }

    fn read(case: &toml::Value) -> Self {
        let [name, kind] = ["name", "kind"].map(|key| case[key].as_str().unwrap().to_owned());
        let text = case["scenario"].as_str().unwrap();
        let scenario = scenario::parse(text, Path::new(&name)).unwrap_or_else(|e| panic!("{name}: {e}"));
        let truth = case["truth"].as_array().unwrap().iter().map(|row| Truth {
            time: row["time"].as_float().unwrap(),
            attitude: words(&row["attitude"]),
            omega_body: words(&row["omega_body"]),
        });
        let growth =
            case.get("growth").map(|x| x.as_float().unwrap_or_else(|| x.as_integer().unwrap() as f64));
        Self { truth: truth.collect(), name, kind, scenario, growth }
    }

    fn simulated(&self) -> Trajectory {
        self.scenario.simulate().unwrap().unwrap_or_else(|e| panic!("{}: {e}", self.name))
    }

    /// Returns the errors of a trajectory at the true states.
    fn off(&self, trajectory: &Trajectory) -> Vec<Off> {
        assert!(trajectory.ending().is_complete(), "{}", self.name);
        let at = |truth: &Truth| {
            let sample = trajectory.samples().iter().find(|sample| sample.state.time == truth.time);
            truth.off(&sample.unwrap_or_else(|| panic!("{}: nothing at {} s", self.name, truth.time)).state)
        };
        self.truth.iter().map(at).collect()
    }
}

impl Truth {
    fn off(&self, state: &State) -> Off {
        let q = state.attitude.quaternion();
        let sign =
            if q.iter().zip(self.attitude).map(|(a, [b, _])| a * b).sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
        // The norm of a quaternion does not affect the attitude.
        let d: [f64; 4] = std::array::from_fn(|k| (sign * q[k] - self.attitude[k][0]) - self.attitude[k][1]);
        let along: f64 = d.iter().zip(self.attitude).map(|(d, [b, _])| d * b).sum();
        let across =
            d.iter().zip(self.attitude).map(|(d, [b, _])| (d - along * b).powi(2)).sum::<f64>().sqrt();
        let w = state.omega.to_array();
        let delta = |k: usize| (w[k] - self.omega_body[k][0]) - self.omega_body[k][1];
        let omega = norm(std::array::from_fn(delta)) / self.speed();
        Off { attitude: 4.0 * (across / 2.0).min(1.0).asin(), omega }
    }

    fn speed(&self) -> f64 {
        norm(self.omega_body.map(|[high, _]| high))
    }
}

fn norm(v: [f64; 3]) -> f64 {
    v[0].hypot(v[1]).hypot(v[2])
}

fn words<const N: usize>(list: &toml::Value) -> [[f64; 2]; N] {
    let list = list.as_array().unwrap();
    std::array::from_fn(|k| two_words(list[k].as_str().unwrap()))
}

/// Splits a decimal number into the nearest double and the remainder.
fn two_words(text: &str) -> [f64; 2] {
    let high: f64 = text.parse().unwrap();
    let [(digits, place), (mut nearest, at)] = [text, &format!("{high:.33e}")].map(decimal);
    match place - at {
        0 => {}
        1 => nearest /= 10,
        -1 => nearest *= 10,
        _ => assert_eq!(high, 0.0, "{text}"),
    }
    let low = if high == 0.0 { 0.0 } else { (digits - nearest) as f64 * 10f64.powi(place - 33) };
    [high, low]
}

/// Returns (m, e) with the number m 10^(e − 33), where m has 34 digits.
fn decimal(text: &str) -> (i128, i32) {
    let (sign, text) = text.strip_prefix('-').map_or((1, text), |rest| (-1, rest));
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let all = format!("{whole}{part}");
    let digits = all.trim_start_matches('0');
    let lead = whole.len() as i32 - 1 - (all.len() - digits.len()) as i32;
    let m: i128 = format!("{digits:0<34}")[..34].parse().unwrap();
    (sign * m, lead + exponent.parse::<i32>().unwrap())
}

#[test]
fn a_decimal_is_two_words() {
    let [high, low] = two_words("0.10000000000000000000000000000000000");
    assert_eq!(high, 0.1);
    assert!((low / -5.551_115_123_125_783e-18 - 1.0).abs() < 1e-14, "{low:e}");
    let [high, low] = two_words("-3.1415926535897932384626433832795e-7");
    assert_eq!(high, -3.141_592_653_589_793e-7);
    assert!(low != 0.0 && low.abs() < 2.7e-23, "{low:e}");
    // 1 − 2⁻⁶⁰; its nearest double is 1.
    let [high, low] = two_words("0.99999999999999999913263826201159645");
    assert!(high == 1.0 && (low * 2f64.powi(60) + 1.0).abs() < 1e-13, "{low:e}");
}

#[test]
fn every_motion_is_near_its_true_one() {
    let cases = Case::all();
    assert!(cases.len() >= 220, "{}", cases.len());
    for case in cases {
        let run = case.scenario.run().unwrap();
        let trajectory = case.simulated();
        let fastest = case.truth.iter().map(Truth::speed).fold(case.scenario.start().omega.norm(), f64::max);
        // Error of a step per radian, amplified by the motion. The error of the splitting method
        // depends on its step size.
        let step = match run.method {
            Method::Splitting { .. } => 1e-3,
            _ => run.tolerance,
        };
        let turned = fastest * run.times.last().unwrap();
        let exact = matches!(trajectory.solution(), Solution::ClosedForm(_));
        let growth = case.growth.unwrap_or(1.0 + turned);
        let limit = if exact { 1e-12 } else { 4.0 * growth * step * (1.0 + turned) };
        for (off, truth) in case.off(&trajectory).iter().zip(&case.truth) {
            // If the body is almost at rest, ω is not accurate relative to its own size.
            let omega = off.omega * truth.speed() / fastest;
            let (name, time) = (&case.name, truth.time);
            assert!(off.attitude.max(omega) < limit, "{name} at {time} s: {off:?}, limit {limit:e}");
        }
    }
}
