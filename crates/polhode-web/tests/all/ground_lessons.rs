//! Statements of the lessons on bodies on the ground, compared with their computed scenarios.

use std::path::Path;

use polhode::math::{Body, Direction, Space};
use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{ContactChange, ContactEvent, ContactState};
use polhode::motion::{GroundContact, Scenario, Trajectory};
use polhode::observe::{BallOnPlane, CirclingDisk, Place, SpinningEgg, SteadyOnGround, SteadyPath, TippeTop};
use polhode_scenario::read as scenario;

use crate::lessons::{Lesson, Step};

const UP: Direction<Space> = Direction::new(0.0, 0.0, 1.0);

/// Motion on the ground, with its contact at each sample.
struct OnGround {
    motion: Trajectory,
    start: ContactState,
    samples: Vec<ContactState>,
}

impl OnGround {
    fn of(motion: Trajectory) -> Self {
        let states = motion.channel(CONTACT).unwrap();
        let (start, samples) = (states.start(), states.iter().collect());
        Self { motion, start, samples }
    }

    fn start(&self) -> &ContactState {
        &self.start
    }

    fn samples(&self) -> &[ContactState] {
        &self.samples
    }

    fn changes(&self) -> &[ContactEvent] {
        self.motion.changes()
    }
}

fn motion(scenario: &Scenario) -> OnGround {
    OnGround::of(scenario.simulate().unwrap().unwrap())
}

/// Computes the motion of a step.
fn moves(step: &Step<'_>) -> OnGround {
    motion(&step.scenario())
}

/// Returns the scenario of a step with one text replaced.
fn with(step: &Step<'_>, from: &str, to: &str) -> Scenario {
    let text = step.text();
    assert!(text.contains(from), "{from} in {text}");
    scenario::parse(&text.replace(from, to), Path::new("changed.toml")).unwrap()
}

fn ground(scenario: &Scenario) -> &GroundContact {
    scenario.ground().unwrap()
}

fn change(motion: &OnGround, which: ContactChange) -> f64 {
    motion.changes().iter().find(|event| event.change == which).unwrap().time
}

/// Returns the angle between the body's z axis and the vertical, degrees.
fn tilt(sample: &ContactState) -> f64 {
    (sample.state.attitude * Direction::<Body>::new(0.0, 0.0, 1.0)).angle_to(UP).to_degrees()
}

fn about_vertical(sample: &ContactState) -> f64 {
    UP.dot(sample.state.attitude * sample.state.omega)
}

fn energy(sample: &ContactState) -> f64 {
    sample.kinetic_energy + sample.potential_energy
}

fn last(motion: &OnGround) -> &ContactState {
    motion.samples().last().unwrap()
}

/// Returns the time at which the rotation about the vertical reverses for good, s.
fn turns_back(motion: &OnGround) -> Option<f64> {
    let pair =
        motion.samples().windows(2).find(|pair| about_vertical(&pair[0]) * about_vertical(&pair[1]) < 0.0)?;
    let [a, b] = [&pair[0], &pair[1]].map(about_vertical);
    Some(pair[0].state.time + (pair[1].state.time - pair[0].state.time) * a / (a - b))
}

#[test]
fn sliding_ball() {
    let lesson = Lesson::open("sliding-ball");
    let first = moves(&lesson.step(1));
    lesson.step(1).right("1.43 m/s", last(&first).velocity.norm());
    let grip = change(&first, ContactChange::Grips);
    let rough = moves(&lesson.step(2));
    lesson.step(2).right("0.146 s", change(&rough, ContactChange::Grips));
    lesson.step(2).says("0.291 s", grip);
    assert!((last(&rough).velocity.norm() - last(&first).velocity.norm()).abs() < 1e-12);
    assert!((last(&first).friction_work - last(&rough).friction_work).abs() < 1e-12);
    assert!((last(&first).friction_work / first.start().kinetic_energy + 2.0 / 7.0).abs() < 1e-12);
    let back = moves(&lesson.step(3));
    lesson.step(3).right("0.21 m/s", -last(&back).velocity.x);
    lesson.step(3).says("6 m/s", back.start().slip.norm());
    lesson.step(3).says("4.5 m/s", 157.343 * 0.0286);
    let stopped = motion(&with(&lesson.step(3), "-157.343 rad/s", "-131.118881118881 rad/s"));
    assert!(last(&stopped).velocity.norm() < 1e-12, "{:?}", last(&stopped).velocity);
    let aside = moves(&lesson.step(4));
    lesson.step(4).right_is("A parabola");
    lesson.step(4).says("2.86 m/s", aside.start().slip.y.abs());
    let to = last(&aside).velocity;
    lesson.step(4).says("49°", to.y.abs().atan2(to.x).to_degrees());
    let ball = BallOnPlane::of(lesson.step(4).scenario().body(), &ground(&lesson.step(4).scenario()).contact)
        .unwrap();
    assert!((ball.share() - 2.0 / 7.0).abs() < 1e-14);
    // Second differences are equal while the ball slips.
    let [a, b, c, d] = [0, 20, 40, 60].map(|k| aside.samples()[k].center);
    assert!(aside.samples()[60].state.time < change(&aside, ContactChange::Grips));
    assert!(((d - c) - (c - b) - ((c - b) - (b - a))).norm() < 1e-12);
}

#[test]
fn euler_disk() {
    let lesson = Lesson::open("euler-disk");
    let scenario = lesson.step(1).scenario();
    let run = motion(&scenario);
    let up = run.start().state.attitude.inverse() * UP;
    let (disk, _) = CirclingDisk::of(scenario.body(), &ground(&scenario).contact, up).unwrap();
    let rate = |tilt: f64| disk.rate_at_rest(tilt.to_radians()).unwrap();
    lesson.step(1).says("50 rad/s", rate(25.0));
    lesson.step(1).says("8 times", rate(25.0) / std::f64::consts::TAU);
    // Rates near 5° from differences: the azimuth of the axis, and the rotation of the body about
    // the vertical.
    let near = run.samples().windows(2).find(|pair| tilt(&pair[1]) < 5.0).unwrap();
    let axis = |s: &ContactState| s.state.attitude * Direction::<Body>::new(0.0, 0.0, 1.0);
    let azimuth = |s: &ContactState| axis(s).y.atan2(axis(s).x);
    let turned = (azimuth(&near[1]) - azimuth(&near[0])).rem_euclid(std::f64::consts::TAU);
    let round = turned / (near[1].state.time - near[0].state.time);
    lesson.step(1).right("88 rad/s", round);
    let body = near[1].state.omega.z + round * (1.0 - axis(&near[1]).z);
    lesson.step(2).right("1.6 rad/s", -body);
    lesson.step(2).right_is("the other way round");
    // The motion to its end.
    let flat = |scenario: &Scenario, seconds: f64| {
        let mut run = scenario.run().unwrap().clone();
        run.times = vec![seconds];
        change(&motion(&scenario.clone().sampled(run)), ContactChange::LiesFlat)
    };
    lesson.step(3).says("15.1 s", flat(&scenario, 40.0));
    lesson.step(3).right("30.2 s", flat(&lesson.step(3).scenario(), 40.0));
    assert!((flat(&lesson.step(4).scenario(), 40.0) - flat(&scenario, 40.0)).abs() < 1e-6);
    lesson.step(4).right_is("Just as long");
    assert!((disk.settling_time(rate(25.0), 1.5e-4) / flat(&scenario, 40.0) - 1.0).abs() < 0.01);
}

#[test]
fn tippe_top() {
    let lesson = Lesson::open("tippe-top");
    let scenario = lesson.step(1).scenario();
    let run = motion(&scenario);
    let grip = change(&run, ContactChange::Grips);
    lesson.step(1).says("0.99 s", grip);
    let gripped = run.samples().iter().find(|s| s.state.time > grip).unwrap();
    lesson.step(1).says("160° off", tilt(gripped));
    let (top, e) = TippeTop::of(scenario.body(), &ground(&scenario).contact).unwrap();
    lesson.step(1).says("4.5 times", 1.0 / top.eccentricity);
    lesson.step(2).right_is("in the same sense");
    assert!(run.samples().iter().all(|s| about_vertical(s) > 0.0));
    lesson.step(2).says("149", e.dot(run.start().state.omega));
    lesson.step(2).says("−93 rad/s", e.dot(gripped.state.omega));
    let between = run.samples().windows(2).find(|pair| e.dot(pair[1].state.omega) < 0.0).unwrap();
    assert!((tilt(&between[0]) - 90.0).abs() < 3.0, "{}", tilt(&between[0]));
    let height = |s: &ContactState| s.center.z;
    lesson.step(3).says("7.7 mm", (height(gripped) - height(run.start())) * 1e3);
    lesson.step(3).says("1.1 mJ", (gripped.potential_energy - run.start().potential_energy) * 1e3);
    lesson.step(3).right("97 rad/s", about_vertical(gripped));
    lesson.step(3).says("12 mJ", -last(&run).friction_work * 1e3);
    assert!((last(&run).friction_work / energy(run.start()) + 0.5).abs() < 0.02);
    let smooth = moves(&lesson.step(4));
    lesson.step(4).right("1.91 s", change(&smooth, ContactChange::Grips));
    let slow = lesson.step(5).scenario();
    lesson.step(5).right_is("It stays on its bottom");
    assert!(motion(&slow).samples().iter().all(|s| tilt(s) < 7.0));
    let spin = |jellett: f64| jellett / top.jellett_of_bottom(1.0);
    lesson.step(5).says("32 rad/s", spin(top.bottom_up_to().unwrap()));
    lesson.step(5).says("63 rad/s", spin(top.inverted_from().unwrap()));
    let never = with(&lesson.step(1), "2.0e-6 kg m^2\"]", "2.6e-6 kg m^2\"]");
    let (never, _) = TippeTop::of(never.body(), &ground(&never).contact).unwrap();
    assert_eq!((top.group(), never.group()), (2, 1));
    let minima = never.minima(never.jellett_of_bottom(1000.0));
    assert!(minima.iter().any(|end| end.place == Place::Bottom));
}

#[test]
fn spinning_egg() {
    let lesson = Lesson::open("spinning-egg");
    let scenario = lesson.step(1).scenario();
    let run = motion(&scenario);
    let (egg, _) = SpinningEgg::of(scenario.body(), &ground(&scenario).contact).unwrap();
    let end = last(&run);
    lesson.step(1).says("8 mm", (end.center.z - run.start().center.z) * 1e3);
    lesson.step(1).right("158 rad/s", about_vertical(end));
    lesson.step(1).says("30 % less", (1.0 - egg.along / egg.across) * 100.0);
    // The wrong answer assumes that L is conserved.
    assert!((150.0 * egg.across / egg.along - 214.0).abs() < 0.6);
    // J = A Ω h for the egg on its side.
    lesson.step(1).says("157 rad/s", egg.spin_on_end(egg.across * 150.0 * egg.radius));
    lesson.step(1).says("18 %", (1.0 - energy(end) / energy(run.start())) * 100.0);
    let slow = lesson.step(2).scenario();
    lesson.step(2).right_is("stays on its side");
    assert!(motion(&slow).samples().iter().all(|s| tilt(s) > 87.0));
    lesson.step(2).says("27.9 rad/s", egg.rises_beyond(egg.height(88_f64.to_radians())));
    let ice = moves(&lesson.step(3));
    lesson.step(3).right_is("It stays near the level");
    assert!(ice.samples().iter().all(|s| (tilt(s) - 90.0).abs() < 3.0));
    // With sticking friction it rolls and does not rise.
    let held = with(&lesson.step(1), "friction = 0.1", "friction = 2.0");
    assert!(motion(&held).samples().iter().all(|s| tilt(s) > 85.0));
}

#[test]
fn rattleback() {
    let lesson = Lesson::open("rattleback");
    let scenario = lesson.step(1).scenario();
    let run = motion(&scenario);
    lesson.step(1).right("2.8 s", turns_back(&run).unwrap());
    lesson.step(1).says("5.35 rad/s", run.samples().iter().map(about_vertical).fold(0.0, f64::max));
    assert!(about_vertical(last(&run)) > 5.0);
    let start = polhode::motion::contact::ContactStart {
        state: scenario.start(),
        at: ground(&scenario).at,
        velocity: ground(&scenario).velocity,
    };
    let steady = SteadyOnGround::near(scenario.body(), &ground(&scenario).contact, &start).unwrap();
    lesson.step(1).says("2.1 per second", steady.modes[0].growth_rate);
    let SteadyPath::OnVertex(vertex) = steady.path else { panic!("{:?}", steady.path) };
    lesson.step(1).says("0.8°", vertex.skew().to_degrees().abs());
    let rattle = vertex.rattleback().unwrap();
    lesson.step(2).says("0.04", rattle.modes[0].growth_per_spin);
    lesson.step(2).says("0.43", -rattle.modes[1].growth_per_spin);
    let other = moves(&lesson.step(2));
    lesson.step(2).right("11.6 s", turns_back(&other).unwrap());
    lesson.step(3).right_is("It spins on");
    let even = moves(&lesson.step(3));
    assert_eq!(turns_back(&even), None);
    assert!(even.samples().iter().all(|s| (about_vertical(s) + 5.0).abs() < 0.5));
    lesson.step(4).right_is("The table");
    // Without friction all forces are vertical, and L · n is constant.
    let ice = with(&lesson.step(4), "law = \"rolling\"", "law = \"frictionless\"\nrolls = true");
    assert_eq!(turns_back(&motion(&ice)), None);
}
