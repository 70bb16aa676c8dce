//! Statements of the lessons, compared with their computed scenarios.

use std::f64::consts::{PI, TAU};
use std::path::Path;

use polhode::body::PrincipalFrame;
use polhode::math::{Body, Direction, Position, Space};
use polhode::motion::{Sample, Scenario};
use polhode::observe::{AxisConvention, RotationalConstants, TumblingPeriods};
use polhode_scenario::read as scenario;
use polhode_source::files::Memory;
use polhode_web::{Engine, lessons};
use serde_json::Value;

/// Lesson as the engine answers it.
pub(crate) struct Lesson(Value);

impl Lesson {
    pub(crate) fn open(id: &str) -> Self {
        let engine = Engine::beginning_with_lesson(id, &Memory::default(), &|| true).unwrap();
        assert_eq!(engine.first_lesson(), Some(id));
        let lesson = engine.lesson(id, &Memory::default(), &|| true).unwrap();
        Self(serde_json::to_value(lesson).unwrap())
    }

    pub(crate) fn step(&self, k: usize) -> Step<'_> {
        Step(&self.0["steps"][k - 1])
    }
}

pub(crate) struct Step<'a>(&'a Value);

impl Step<'_> {
    pub(crate) fn scenario(&self) -> Scenario {
        scenario::parse(self.text(), Path::new("lesson.toml")).unwrap()
    }

    /// Returns the text of the step's scenario.
    pub(crate) fn text(&self) -> &str {
        self.0["scenario"].as_str().unwrap()
    }

    /// Checks that a part of the step contains these words. They begin with a number, which must be
    /// the value rounded to its decimals.
    #[track_caller]
    pub(crate) fn says(&self, words: &str, value: f64) {
        let question = &self.0["question"];
        let right =
            question["answers"][usize::try_from(question["right"].as_u64().unwrap()).unwrap()].as_str();
        let texts = [self.0["text"].as_str(), question["text"].as_str(), question["why"].as_str(), right];
        assert!(texts.iter().flatten().any(|text| holds(text, words)), "nothing says {words:?}: {texts:?}");
        agrees(words, value);
    }

    /// Checks that the right answer contains these words, and that their number is the value.
    #[track_caller]
    pub(crate) fn right(&self, words: &str, value: f64) {
        self.right_is(words);
        agrees(words, value);
    }

    #[track_caller]
    pub(crate) fn right_is(&self, words: &str) {
        let question = &self.0["question"];
        let right = usize::try_from(question["right"].as_u64().unwrap()).unwrap();
        let answer = question["answers"][right].as_str().unwrap();
        assert!(holds(answer, words), "the right answer is {answer:?}");
    }
}

/// Returns true if the text contains the words, but not as the end of a longer number.
fn holds(text: &str, words: &str) -> bool {
    let longer = |before: &str| before.ends_with(|c: char| c.is_ascii_digit() || c == '.');
    text.match_indices(words).any(|(at, _)| !longer(&text[..at]))
}

/// Checks that the number at the beginning equals the value, rounded to as many decimals.
#[track_caller]
fn agrees(words: &str, value: f64) {
    let digits: String = words
        .chars()
        .map(|c| if c == '−' { '-' } else { c })
        .take_while(|c| "-.0123456789".contains(*c))
        .collect();
    let decimals = digits.split_once('.').map_or(0, |(_, after)| after.len());
    let half = 0.5 * 10_f64.powi(-i32::try_from(decimals).unwrap());
    let said: f64 = digits.parse().unwrap();
    assert!((said - value).abs() <= half * 1.000_001, "{words:?} is said, {value} is computed");
}

fn samples(scenario: &Scenario) -> Vec<Sample> {
    scenario.simulate().unwrap().unwrap().samples().to_vec()
}

fn omega(sample: &Sample) -> [f64; 3] {
    sample.state.omega.to_array()
}

/// Returns a body axis in space axes.
fn axis(sample: &Sample, body: [f64; 3]) -> [f64; 3] {
    (sample.state.attitude * Direction::<Body>::new(body[0], body[1], body[2])).to_array()
}

/// Returns the angle between a body axis and the vertical, degrees.
fn lean(sample: &Sample) -> f64 {
    axis(sample, [0.0, 0.0, 1.0])[2].clamp(-1.0, 1.0).acos().to_degrees()
}

/// Returns the times at which a number changes sign, by linear interpolation between the samples.
fn crossings(samples: &[Sample], number: impl Fn(&Sample) -> f64) -> Vec<f64> {
    let pairs = samples.windows(2).map(|pair| (&pair[0], &pair[1], number(&pair[0]), number(&pair[1])));
    let crossing = pairs.filter(|(_, _, a, b)| (*a < 0.0) != (*b < 0.0));
    crossing.map(|(p, q, a, b)| p.state.time + (q.state.time - p.state.time) * a / (a - b)).collect()
}

/// Returns the mean interval between crossings, s.
fn spacing(times: &[f64]) -> f64 {
    (times[times.len() - 1] - times[0]) / f64::from(u32::try_from(times.len() - 1).unwrap())
}

fn moments(scenario: &Scenario) -> [f64; 3] {
    let tensor = scenario.rotor().inertia();
    std::array::from_fn(|k| tensor.matrix()[k][k])
}

/// Returns the angle between {I} ω and ω about the pivot, degrees.
fn off_axis(scenario: &Scenario) -> f64 {
    let start = scenario.start();
    scenario.rotor().angular_momentum(start.omega).angle_to(start.omega).to_degrees()
}

#[test]
fn every_lesson_can_be_shown_and_asks() {
    let all: Vec<_> = lessons().collect();
    assert!(all.len() >= 12);
    for info in all {
        let lesson = Lesson::open(&info.id);
        let steps = lesson.0["steps"].as_array().unwrap();
        assert!((3..=6).contains(&steps.len()), "{}", info.id);
        for step in steps {
            assert!(!step["question"].is_null() && !step["working"].is_null(), "{}", info.id);
            assert!((1..=3).contains(&step["knobs"].as_array().unwrap().len()), "{}", info.id);
        }
    }
}

#[test]
fn cube() {
    let lesson = Lesson::open("cube");
    let tensor = lesson.step(1).scenario().rotor().inertia().matrix();
    assert!((tensor[0][0] - 2.0 / 3.0).abs() < 1e-14 && (tensor[0][1] + 0.25).abs() < 1e-14);
    lesson.step(1).right("28°", off_axis(&lesson.step(1).scenario()));
    lesson.step(1).says("27.9°", off_axis(&lesson.step(1).scenario()));
    lesson.step(2).right_is("The space diagonal");
    let diagonal = [1.0; 3].map(|one: f64| one / 3_f64.sqrt());
    let along =
        |v: [f64; 3]| (0..3).map(|i| (0..3).map(|j| v[i] * tensor[i][j] * v[j]).sum::<f64>()).sum::<f64>();
    assert!((along(diagonal) - 1.0 / 6.0).abs() < 1e-14);
    lesson.step(3).right_is("Every line in it is one");
    let second = lesson.step(3).scenario();
    assert!(off_axis(&second) < 1e-6);
    for axis in [[1.0, 1.0, -2.0_f64], [3.0, -1.0, -2.0]] {
        let norm = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!((along(axis.map(|x| x / norm)) - 11.0 / 12.0).abs() < 1e-14);
    }
    lesson.step(4).right("25° away", off_axis(&lesson.step(4).scenario()));
    lesson.step(4).says("25.2°", off_axis(&lesson.step(4).scenario()));
}

#[test]
fn parallel_axes() {
    let lesson = Lesson::open("parallel-axes");
    let period = |k: usize| lesson.step(k).scenario().pendulum().unwrap().unwrap().period(0.0);
    lesson.step(1).says("1.64 s", period(1));
    lesson.step(3).right("1.64 s", period(3));
    // T(d) about a hole at any distance d, from the tensor of the stick.
    let scenario = lesson.step(1).scenario();
    let body = scenario.body();
    let at = |d: f64| {
        let about = body.inertia_about(Position::new(d, 0.0, 0.0)).matrix()[2][2];
        TAU * (about / (body.mass() * 9.81 * d)).sqrt()
    };
    assert!((at(0.5) - period(1)).abs() < 1e-9);
    lesson.step(1).right_is("Faster");
    lesson.step(1).says("1.52 s", at(0.289));
    let gyration = (body.inertia().matrix()[2][2] / body.mass()).sqrt();
    lesson.step(1).says("0.289 m", gyration);
    assert!(at(gyration) < at(gyration * 1.01) && at(gyration) < at(gyration * 0.99));
    lesson.step(2).right_is("At d = 0.167 m");
    agrees("0.167", gyration * gyration / 0.5);
    assert!((at(gyration * gyration / 0.5) - at(0.5)).abs() < 1e-12);
    let heavier = lesson.step(3).0["scenario"].as_str().unwrap().replace("120 g", "840 g");
    let heavier = scenario::parse(&heavier, Path::new("heavier.toml")).unwrap();
    assert!((heavier.pendulum().unwrap().unwrap().period(0.0) - period(3)).abs() < 1e-12);
}

#[test]
fn pendulum() {
    let lesson = Lesson::open("pendulum");
    let small = lesson.step(1).scenario().pendulum().unwrap().unwrap().period(0.0);
    lesson.step(1).right("1.64 s", small);
    lesson.step(1).says("1.79 s", TAU * (0.8 / 9.81_f64).sqrt());
    let heavy = lesson.step(2).0["scenario"].as_str().unwrap().replacen(
        "{ mass = \"0.3 kg\", position = [\"40",
        "{ mass = \"3e6 kg\", position = [\"40",
        1,
    );
    let heavy = scenario::parse(&heavy, Path::new("heavy.toml")).unwrap();
    lesson.step(2).right("1.27 s", heavy.pendulum().unwrap().unwrap().period(0.0));
    let turns = crossings(&samples(&lesson.step(3).scenario()), |sample| omega(sample)[2]);
    lesson.step(3).right("18 %", (2.0 * spacing(&turns) / small - 1.0) * 100.0);
    lesson.step(3).says("1.180", 2.0 * spacing(&turns) / small);
    let little = lesson.step(1).scenario().pendulum().unwrap().unwrap();
    lesson.step(3).says("0.05 %", (little.period(5_f64.to_radians()) / small - 1.0) * 100.0);
}

#[test]
fn dumbbell() {
    let lesson = Lesson::open("dumbbell");
    let torque = |k: usize| samples(&lesson.step(k).scenario())[7].torque.to_array();
    let [x, y, z] = torque(1);
    assert!(y.abs() < 1e-12 && z.abs() < 1e-12);
    lesson.step(1).right_is("at right angles to the axis");
    lesson.step(1).says("−5.34 N m", x);
    lesson.step(2).right("21.4 N m", -4.0 * x);
    let faster = lesson.step(2).0["scenario"].as_str().unwrap().replace("30 rpm", "60 rpm");
    let faster = samples(&scenario::parse(&faster, Path::new("faster.toml")).unwrap());
    assert!((faster[7].torque.to_array()[0] - 4.0 * x).abs() < 1e-9);
    lesson.step(3).right_is("At 45°");
    lesson.step(3).says("6.17 N m", -torque(3)[0]);
    assert!((torque(4)[0] - x).abs() < 1e-9);
    // M ω² times the distance of the centre of mass from the axis.
    let body = lesson.step(4).scenario();
    let off = body.body().center_of_mass().to_array()[2] * 0.5;
    lesson.step(4).says("2.47 N", body.body().mass() * PI * PI * off);
}

#[test]
fn cones() {
    let lesson = Lesson::open("cones");
    let of = |k: usize| {
        let scenario = lesson.step(k).scenario();
        let [across, _, along] = moments(&scenario);
        (across, along, samples(&scenario))
    };
    let (across, along, plate) = of(1);
    let spin = omega(&plate[0])[2];
    // Number of times that the symmetry axis crosses a plane through L, in space.
    let l = plate[0].momentum.direction().unwrap().to_array();
    let round = |sample: &Sample| {
        let e = axis(sample, [0.0, 0.0, 1.0]);
        e[0] * l[2] - e[2] * l[0]
    };
    let rate = PI / spacing(&crossings(&plate, round));
    assert!((rate - plate[0].momentum.norm() / across).abs() < 1e-3 * rate);
    lesson.step(1).right_is("Twice as fast");
    lesson.step(1).says("2.00 ω3", rate / spin);
    assert!((along / across - 2.0).abs() < 1e-3);
    let (across, along, bar) = of(2);
    let body_rate = |samples: &[Sample]| {
        let [a, b] = [omega(&samples[0]), omega(&samples[1])];
        (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1])
            / (samples[1].state.time - samples[0].state.time)
    };
    assert!(body_rate(&plate) > 0.0);
    lesson.step(2).right_is("The other way round");
    lesson.step(2).says("−4.67 rad/s", body_rate(&bar));
    assert!(((along / across - 1.0) * 9.0 - body_rate(&bar)).abs() < 1e-6);
    lesson.step(3).right("225 mm", 130.0 * 3_f64.sqrt());
    let alike = lesson.step(3).0["scenario"]
        .as_str()
        .unwrap()
        .replace("length = \"130 mm\"", "length = \"225.16660498395404 mm\"");
    let alike = scenario::parse(&alike, Path::new("alike.toml")).unwrap();
    let [across, _, along] = moments(&alike);
    assert!((along / across - 1.0).abs() < 1e-12);
}

#[test]
fn racket() {
    let lesson = Lesson::open("racket");
    let flips =
        |k: usize| spacing(&crossings(&samples(&lesson.step(k).scenario()), |sample| omega(sample)[2]));
    let [x, y, z] = moments(&lesson.step(1).scenario()).map(|moment| moment * 1e4);
    lesson.step(1).says("0.445, 1.30 and 1.71", x);
    agrees("1.30", z);
    agrees("1.71", y);
    assert!(x < z && z < y);
    let growth = 6.0 * ((z - x) * (y - z) / (x * y)).sqrt();
    lesson.step(1).says("4.09 per second", growth);
    lesson.step(1).right_is("the moment in between");
    lesson.step(1).says("3.83 s", flips(1));
    lesson.step(2).right("4.95 s", flips(2));
    lesson.step(2).right("1.1 s", flips(2) - flips(1));
    lesson.step(2).says("0.56 s", 10_f64.ln() / growth);
    lesson.step(2).says("1.13 s", flips(2) - flips(1));
    lesson.step(3).right("1.91 s", flips(3));
    lesson.step(4).right_is("Nothing");
    let all = samples(&lesson.step(4).scenario());
    assert!(
        all.iter().all(|sample| (sample.momentum - all[0].momentum).norm() < 1e-12 * all[0].momentum.norm())
    );
}

#[test]
fn bicycle_wheel() {
    let lesson = Lesson::open("bicycle-wheel");
    let of = |k: usize| samples(&lesson.step(k).scenario());
    // Mean rate of the axle about the vertical.
    let round = |samples: &[Sample]| {
        let azimuth =
            |sample: &Sample| axis(sample, [0.0, 0.0, 1.0])[1].atan2(axis(sample, [0.0, 0.0, 1.0])[0]);
        let turned: f64 = samples
            .windows(2)
            .map(|pair| (azimuth(&pair[1]) - azimuth(&pair[0]) + PI).rem_euclid(TAU) - PI)
            .sum();
        turned / (samples[samples.len() - 1].state.time - samples[0].state.time)
    };
    let leans = |samples: &[Sample]| {
        samples
            .iter()
            .map(lean)
            .fold([180.0_f64, 0.0_f64], |[low, high], lean| [low.min(lean), high.max(lean)])
    };
    let steady = of(1);
    assert!(leans(&steady).iter().all(|lean| (lean - 90.0).abs() < 0.01));
    lesson.step(1).right_is("stays level and goes round");
    lesson.step(1).says("0.848 rad/s", round(&steady));
    lesson.step(1).says("7.41 s", TAU / round(&steady));
    let faster = of(2);
    assert!(leans(&faster).iter().all(|lean| (lean - 90.0).abs() < 0.01));
    lesson.step(2).right("14.8 s", TAU / round(&faster));
    lesson.step(2).says("0.424 rad/s", round(&faster));
    lesson.step(3).right_is("No: it falls");
    lesson.step(3).says("7° of", 180.0 - leans(&of(3))[1]);
    lesson.step(4).right_is("falls a little first");
    let nodding = of(4);
    lesson.step(4).says("3.3° below", leans(&nodding)[1] - 90.0);
    // The axis is lowest once in each nutation period: the rate of its inclination changes sign
    // twice.
    let turning = nodding.windows(2).map(|pair| lean(&pair[1]) - lean(&pair[0])).collect::<Vec<_>>();
    let count = turning.windows(2).filter(|pair| (pair[0] > 0.0) != (pair[1] > 0.0)).count();
    let nod = 2.0 * 12.0 / f64::from(u32::try_from(count).unwrap());
    // The last nutation period is incomplete.
    assert!((nod - 0.212).abs() < 0.212 * 0.212 / 12.0, "{count} turning points");
    // 33 nutation periods of 0.2119 s are nearly 699 samples.
    lesson.step(4).says("0.212 s", 0.211_913_6);
    lesson.step(4).says("0.847 rad/s", round(&nodding[..=699]));
}

#[test]
fn sleeping_top() {
    let lesson = Lesson::open("sleeping-top");
    let limit = |k: usize| {
        let scenario = lesson.step(k).scenario();
        let [across, _, along] = moments(&scenario);
        let lever = scenario.body().center_of_mass().to_array()[2];
        (4.0 * scenario.body().mass() * 9.80665 * lever * across).sqrt() / along * 30.0 / PI
    };
    let leans = |k: usize| samples(&lesson.step(k).scenario()).iter().map(lean).fold(0.0, f64::max);
    let [across, _, along] = moments(&lesson.step(1).scenario());
    agrees("3.26", across * 1e3);
    agrees("2.00", along * 1e3);
    lesson.step(1).says("331 rpm", limit(1));
    lesson.step(1).right_is("Yes: it trembles");
    lesson.step(1).right("2° at most", leans(1));
    lesson.step(2).says("9 % below", (1.0 - 300.0 / limit(2)) * 100.0);
    lesson.step(2).right("50°", leans(2));
    // The body returns upright.
    let all = samples(&lesson.step(2).scenario());
    let leaning = all.iter().skip_while(|sample| lean(sample) < 45.0);
    assert!(leaning.map(lean).fold(180.0, f64::min) < 3.0);
    lesson.step(3).right_is("The same, 331 rpm");
    assert!((limit(3) - limit(1)).abs() < 1e-9);
    lesson.step(4).right("212 rpm", limit(4));
}

#[test]
fn flat_spin() {
    let lesson = Lesson::open("flat-spin");
    let of = |k: usize| samples(&lesson.step(k).scenario());
    let all = of(1);
    let [first, last] = [&all[0], &all[all.len() - 1]];
    lesson.step(1).right_is("end over end");
    assert!(omega(last)[2].abs() < 1e-3);
    lesson.step(2).right("0.4 rad/s", last.state.omega.norm());
    lesson.step(2).says("0.4 J", last.kinetic_energy);
    lesson.step(2).says("96 %", (1.0 - last.kinetic_energy / first.kinetic_energy) * 100.0);
    assert!((last.momentum - first.momentum).norm() < 1e-9);
    // tan θ in the first seconds.
    let tilt = |sample: &Sample| {
        let [x, y, z] = omega(sample);
        5.0 * x.hypot(y) / (0.2 * z)
    };
    let time = |samples: &[Sample]| {
        let [a, b] = [&samples[0], &samples[200]];
        (b.state.time - a.state.time) / (tilt(b) / tilt(a)).ln()
    };
    agrees("26", time(&all));
    lesson.step(3).right_is("e^(t/13 s)");
    agrees("13", time(&of(3)));
    lesson.step(4).right_is("Its wobble dies away");
    let flat = of(4);
    let wobble = |sample: &Sample| omega(sample)[0].hypot(omega(sample)[1]);
    assert!(wobble(&flat[flat.len() - 1]) < 0.01 * wobble(&flat[0]));
}

#[test]
fn dual_spin() {
    let lesson = Lesson::open("dual-spin");
    let of = |k: usize| samples(&lesson.step(k).scenario());
    let across = |sample: &Sample| omega(sample)[0].hypot(omega(sample)[1]);
    let decay = |samples: &[Sample]| {
        let [a, b] = [&samples[0], &samples[200]];
        (b.state.time - a.state.time) / (across(a) / across(b)).ln()
    };
    let all = of(1);
    let scenario = lesson.step(1).scenario();
    lesson.step(1).says("1696 kg m²/s", scenario.rotor().wheel_momentum(0.0).norm());
    let nod = (1250.0 * across(&all[0]) / scenario.rotor().wheel_momentum(0.0).norm()).atan().to_degrees();
    lesson.step(1).says("5°", nod);
    lesson.step(1).right_is("It takes it away");
    lesson.step(1).says("43 s", decay(&all));
    let locked = of(2);
    assert!((locked[0].momentum.norm() - all[0].momentum.norm()).abs() < 1e-3);
    lesson.step(2).right("1.36 rad/s", across(&locked[locked.len() - 1]));
    lesson.step(3).right("11 s", decay(&of(3)));
}

#[test]
fn gravity_gradient() {
    let lesson = Lesson::open("gravity-gradient");
    let orbit = TAU / 1.10682e-3;
    lesson.step(1).says("94.6 min", orbit / 60.0);
    // Angles of the boom from the vertical, in the plane of the orbit and out of it. The vertical
    // rotates in the x-y plane.
    let swing = |k: usize, out: bool| {
        let ahead = move |sample: &Sample| {
            let boom = axis(sample, [0.0, 0.0, 1.0]);
            let phase = 1.10682e-3 * sample.state.time;
            if out { boom[2] } else { boom[1] * phase.cos() - boom[0] * phase.sin() }
        };
        2.0 * spacing(&crossings(&samples(&lesson.step(k).scenario()), ahead))
    };
    lesson.step(1).right("1.7 times", orbit / swing(1, false));
    let [first, second, third] = moments(&lesson.step(1).scenario());
    lesson.step(1).says("1.69 n", (3.0 * (first - third) / second).sqrt());
    lesson.step(1).says("56.1 min", {
        let body = lesson.step(1).scenario();
        let rate = 1.10682e-3 * (3.0 * (moments(&body)[0] - moments(&body)[2]) / moments(&body)[1]).sqrt();
        TAU / rate / 60.0
    });
    lesson.step(2).right("1.71 times", orbit / swing(2, false));
    lesson.step(3).right_is("Nearly twice");
    lesson.step(3).says("1.97 n", orbit / swing(3, true));
}

#[test]
fn chandler() {
    let lesson = Lesson::open("chandler");
    let days = |k: usize| {
        let all = samples(&lesson.step(k).scenario());
        2.0 * spacing(&crossings(&all, |sample| omega(sample)[1])[1..]) / 86_400.0
    };
    lesson.step(1).right("304 days", days(1));
    lesson.step(1).says("303.6 days", days(1));
    lesson.step(2).right_is("Just as long");
    assert!((days(2) - days(1)).abs() < 1e-3);
    lesson.step(3).says("430 days", days(3));
    // The word "some" stands for a tolerance of 5 %.
    lesson.step(3).right_is("by some 30 %");
    assert!((0.25..0.35).contains(&(1.0 - 0.00232 / 0.003_284_548_3)));
    let across = omega(&samples(&lesson.step(1).scenario())[0]);
    // Distances on the ground: the angle of ω, and of its circle about the axis of figure, times
    // the Earth's radius.
    agrees("9", across[0] / across[2] * 6.357e6);
}

#[test]
fn water() {
    let lesson = Lesson::open("water");
    let constants = |k: usize| {
        let constants = RotationalConstants::of(lesson.step(k).scenario().body()).unwrap();
        constants.per_centimetre().map(Option::unwrap)
    };
    let [a, b, c] = constants(1);
    lesson.step(2).says("25.8", a);
    lesson.step(2).says("14.4", b);
    lesson.step(2).says("9.25 cm⁻¹", c);
    let own = lesson.step(1).scenario();
    let [y, z, x] = PrincipalFrame::of(own.body().inertia()).moments().map(|moment| moment * 1e47);
    lesson.step(1).says("1.08, 1.94 and 3.03", y);
    agrees("1.94", z);
    agrees("3.03", x);
    lesson.step(1).right_is("No: it turns over");
    assert!(crossings(&samples(&own), |sample| omega(sample)[2]).len() > 2);
    lesson.step(2).right_is("A and C, but not B");
    let heavy = constants(2);
    assert!((heavy[1] / b - 1.0).abs() < 1e-12);
    lesson.step(2).says("1.2 %", (1.0 - heavy[0] / a) * 100.0);
    lesson.step(2).says("0.5 %", (1.0 - heavy[2] / c) * 100.0);
    let deuterated = lesson.step(3).scenario();
    let tensor = deuterated.body().inertia().matrix();
    let of = |moment: f64| 6.626_070_15e-34 / (8.0 * PI * PI * 2.997_924_58e10 * moment);
    lesson.step(3).right("7.21 cm⁻¹", of(tensor[2][2]));
    lesson.step(3).says("14.4 cm⁻¹", of(tensor[1][1]));
    lesson.step(4).right_is("The greatest is the sum of the other two");
    assert!((x - y - z).abs() < 1e-12);
}

#[test]
fn tumbling() {
    let lesson = Lesson::open("tumbling");
    let scenario = lesson.step(1).scenario();
    let all = samples(&scenario);
    let day = 86_400.0;
    lesson.step(1).right_is("Never exactly");
    lesson.step(1).says("5.37 days", 2.0 * spacing(&crossings(&all, |sample| omega(sample)[0])) / day);
    let l = all[0].momentum.direction().unwrap();
    let long = |sample: &Sample| sample.state.attitude * Direction::<Body>::new(0.0, 0.0, 1.0);
    // The long axis relative to L, over the whole run.
    let across = Direction::new(1.0, 0.0, 0.0).cross(l).direction().unwrap();
    let third = l.cross(across);
    let azimuth = |sample: &Sample| third.dot(long(sample)).atan2(across.dot(long(sample)));
    let turned: f64 =
        all.windows(2).map(|pair| (azimuth(&pair[1]) - azimuth(&pair[0]) + PI).rem_euclid(TAU) - PI).sum();
    agrees("7.4", TAU / (turned.abs() / 40.0));
    let motion = polhode::motion::FreeMotion::of(scenario.rotor(), scenario.start()).unwrap();
    lesson.step(1).says("5.37 days", motion.period().unwrap() / day);
    lesson
        .step(1)
        .says("7.41 days", TumblingPeriods::of(&motion, AxisConvention::LongAxis).unwrap().precession / day);
    let periods = TumblingPeriods::of(&motion, AxisConvention::LongAxis).unwrap();
    lesson.step(1).says("0.724", periods.ratio());
    let angle = |sample: &Sample| {
        let angle = l.angle_to(long(sample)).to_degrees();
        angle.min(180.0 - angle)
    };
    lesson.step(2).right_is("hardly changes, some 50°");
    lesson.step(2).says("49.8°", all.iter().map(angle).fold(180.0, f64::min));
    lesson.step(2).says("50.6°", all.iter().map(angle).fold(0.0, f64::max));
    lesson.step(3).right_is("about half of it");
    let l2 = all[0].momentum.dot(all[0].momentum);
    lesson.step(3).says("52 %", l2 / (2.0 * 3.235) / all[0].kinetic_energy * 100.0);
    lesson.step(3).says("7.60 days", TAU / (l2.sqrt() / 3.235) / day);
}

#[test]
fn hyperion() {
    let lesson = Lesson::open("hyperion");
    let apart = |k: usize| {
        let text = lesson.step(k).0["scenario"].as_str().unwrap();
        let other = text.replace("\"20 deg/d\"", "\"20.002 deg/d\"");
        assert_ne!(text, other);
        let end = |text: &str| {
            let all = samples(&scenario::parse(text, Path::new("hyperion.toml")).unwrap());
            all[all.len() - 1].state.attitude
        };
        end(text).angle_to(end(&other)).to_degrees()
    };
    let all = samples(&lesson.step(1).scenario());
    // The normal of the orbit is z.
    let tilt = |sample: &Sample| {
        sample.state.omega_space().angle_to(Direction::<Space>::new(0.0, 0.0, 1.0)).to_degrees()
    };
    lesson.step(1).says("15°", tilt(&all[0]));
    lesson.step(1).right("55°", all.iter().map(tilt).fold(0.0, f64::max));
    assert!(all.iter().map(tilt).fold(180.0, f64::min) < 1.0);
    lesson.step(2).says("0.4°", 0.002 * 200.0);
    lesson.step(2).right("110°", apart(2));
    lesson.step(3).right("0.42°", apart(3));
}
