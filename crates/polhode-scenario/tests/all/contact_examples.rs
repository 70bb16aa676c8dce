//! Statements in titles and comments of the examples of bodies on the ground.

use std::path::Path;

use polhode::math::{Body, Direction, Space};
use polhode::motion::Run;
use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{ContactPhase, ContactState};
use polhode::prelude::*;
use polhode_scenario::read as scenario;

use crate::common::held::Held;

fn read(name: &str) -> Scenario {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    scenario::read(&path).unwrap_or_else(|e| panic!("{e}"))
}

/// Returns the motion; checks the energy balance and the absence of findings.
fn motion(scenario: &Scenario) -> Held<ContactState> {
    let motion = scenario.simulate().unwrap().unwrap();
    let contact = Held::of(motion, CONTACT);
    assert!(contact.energy_drift() < 1e-12, "{:e}", contact.energy_drift());
    assert!(scenario.findings().is_empty(), "{:?}", scenario.findings());
    contact
}

fn spin(s: &ContactState) -> f64 {
    s.state.omega_space().z
}

/// Returns the angle between the body's z axis and the vertical, degrees.
fn tilt(s: &ContactState) -> f64 {
    let axis: Direction<Space> = s.state.attitude * Direction::<Body>::new(0.0, 0.0, 1.0);
    axis.z.clamp(-1.0, 1.0).acos().to_degrees()
}

fn at(motion: &Held<ContactState>, time: f64) -> &ContactState {
    motion.samples().iter().find(|s| s.state.time >= time - 1e-9).unwrap()
}

fn close(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected}");
}

#[test]
fn the_rattleback_turns_back() {
    let motion = motion(&read("rattleback.toml"));
    close(spin(motion.start()), -5.0, 1e-12);
    let back = motion.samples().iter().find(|s| spin(s) > 0.0).unwrap();
    close(back.state.time, 2.8, 0.05);
    let most = motion.samples().iter().map(spin).fold(0.0, f64::max);
    close(most, 5.35, 0.01);
    assert!(spin(motion.samples().last().unwrap()) > 5.0, "and keeps it");
    // Without the product of inertia it would not reverse.
    let text =
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/rattleback.toml"));
    let straight = text.unwrap().replace("\"-2e-5 kg m^2\"", "0");
    let straight = scenario::parse(&straight, "straight.toml".as_ref()).unwrap();
    let contact = Held::of(straight.simulate().unwrap().unwrap(), CONTACT);
    assert!(contact.samples().iter().all(|s| spin(s) < -4.5));
}

#[test]
fn eulers_disk_whirls_ever_faster() {
    let scenario = read("eulers-disk.toml");
    let motion = self::motion(&scenario);
    // Mean rate of the azimuth of the point of contact over 40 samples of 5 ms.
    let whirl = |time: f64| {
        let k = motion.samples().iter().position(|s| s.state.time >= time - 1e-9).unwrap();
        let angle = |s: &ContactState| {
            let arm = s.contact - s.center;
            arm.y.atan2(arm.x)
        };
        let steps = motion.samples()[k..=k + 40].windows(2);
        let turn =
            |pair: &[ContactState]| (angle(&pair[1]) - angle(&pair[0])).rem_euclid(std::f64::consts::TAU);
        steps.map(turn).sum::<f64>() / 0.2
    };
    close(whirl(0.0), 50.5, 0.5);
    close(whirl(10.0) / whirl(0.0), 1.82, 0.05);
    close(tilt(at(&motion, 10.0)), 4.6, 0.1);
    assert!(motion.samples().iter().all(|s| s.center.x.hypot(s.center.y - 0.0318) < 0.003), "it stays");
    assert!(spin(motion.start()) > 12.0 && spin(motion.samples().last().unwrap()) < -4.0);
    // The motion to its end.
    let long = scenario.sampled(Run { times: vec![0.0, 20.0], method: Method::Auto, tolerance: 1e-13 });
    let long = long.simulate().unwrap().unwrap();
    let [change] = long.changes() else { panic!("{:?}", long.ending()) };
    close(change.time, 15.10, 0.01);
    assert_eq!(change.change.name(), "lies flat");
}

#[test]
fn the_tippe_top_turns_over() {
    let scenario = read("tippe-top.toml");
    let motion = motion(&scenario);
    close(tilt(motion.start()), 6.0, 1e-12);
    let [change] = motion.changes() else { panic!("{:?}", motion.changes()) };
    close(change.time, 0.99, 0.01);
    let last = motion.samples().last().unwrap();
    close(tilt(last), 160.4, 0.5);
    close(spin(last), 97.0, 0.5);
    close(last.center.z - motion.start().center.z, 0.0077, 0.0001);
    assert_eq!([motion.start().phase, last.phase], [ContactPhase::Sliding, ContactPhase::Rolling]);
    let jellett =
        |s: &ContactState| -scenario.rotor().angular_momentum_space(&s.state).dot(s.contact - s.center);
    for s in motion.samples() {
        close(jellett(s) / jellett(motion.start()), 1.0, 1e-11);
    }
}

#[test]
fn the_coin_spirals_and_falls() {
    let scenario = read("coin.toml");
    let motion = self::motion(&scenario);
    let start = motion.start();
    close(start.velocity.norm(), 0.58, 0.01);
    close(tilt(start), 75.0, 1e-9);
    close(tilt(at(&motion, 3.0)), 46.0, 0.5);
    close(tilt(at(&motion, 6.0)), 5.2, 0.3);
    // Extent of the path of the point of contact during an interval.
    let width = |from: f64, to: f64| {
        let path = motion.samples().iter().filter(|s| (from..to).contains(&s.state.time));
        let ends = path.map(|s| s.contact.x).fold([f64::MAX, f64::MIN], |[a, b], x| [a.min(x), b.max(x)]);
        ends[1] - ends[0]
    };
    assert!(width(0.0, 2.0) > 0.2 && width(5.5, 7.0) < 0.05, "{} {}", width(0.0, 2.0), width(5.5, 7.0));
    // Without rolling friction the path is a circle of 20 cm, forever.
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/coin.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let circle: String = text
        .lines()
        .filter(|line| !line.starts_with("rolling_friction"))
        .map(|line| format!("{line}\n"))
        .collect();
    let circle = scenario::parse(&circle, "circle.toml".as_ref()).unwrap();
    let circle = Held::of(circle.simulate().unwrap().unwrap(), CONTACT);
    let tilts = circle.samples().iter().map(tilt);
    let [least, most] = tilts.fold([f64::MAX, f64::MIN], |[a, b], x| [a.min(x), b.max(x)]);
    assert!(least > 74.9 && most < 75.1, "{least} {most}");
    let points: Vec<f64> = circle.samples().iter().map(|s| s.contact.y).collect();
    let [low, high] = points.iter().fold([f64::MAX, f64::MIN], |[a, b], &x| [a.min(x), b.max(x)]);
    close(0.5 * (high - low), 0.197, 0.001);
}

#[test]
fn the_egg_stands_up() {
    let motion = motion(&read("spinning-egg.toml"));
    close(tilt(motion.start()), 88.0, 1e-9);
    let last = motion.samples().last().unwrap();
    assert!(tilt(last) < 10.0, "{}", tilt(last));
    close(last.center.z - motion.start().center.z, 0.008, 0.0005);
    let grips = motion.changes().last().unwrap();
    close(grips.time, 1.33, 0.01);
    close(-last.friction_work / motion.start().kinetic_energy, 0.2, 0.03);
}

#[test]
fn the_ball_comes_round_at_two_sevenths_of_the_table() {
    let motion = motion(&read("ball-on-turntable.toml"));
    let last = motion.samples().last().unwrap();
    assert!((last.center - motion.start().center).norm() < 1e-10);
    let half = at(&motion, 3.15);
    assert!((half.center - motion.start().center).norm() > 0.2);
    assert!((at(&motion, 6.3).center - motion.start().center).norm() < 1e-10, "once round");
}

#[test]
fn the_marble_goes_round_in_rosettes() {
    let motion = motion(&read("ball-in-bowl.toml"));
    let distance = motion.samples().iter().map(|s| s.contact.x.hypot(s.contact.y));
    let [least, most] = distance.fold([f64::MAX, f64::MIN], |[a, b], x| [a.min(x), b.max(x)]);
    close(least, 0.022, 0.0005);
    close(most, 0.060, 0.0005);
    assert!(motion.samples().iter().all(|s| s.phase == ContactPhase::Rolling && s.normal_force > 0.0));
}

#[test]
fn the_hoop_gains_half_of_what_slides() {
    let scenario = read("hoop.toml");
    let motion = motion(&scenario);
    let (first, last) = (motion.samples()[0], *motion.samples().last().unwrap());
    let gained = (last.velocity.norm() - first.velocity.norm()) / 3.0;
    let sliding = 9.80665 * 10_f64.to_radians().sin();
    // 1/(1 + I/(m ρ²)), with the outer radius ρ of the tube.
    let share = 0.306_f64.powi(2) / (0.306_f64.powi(2) + 0.09 + 0.75 * 0.006_f64.powi(2));
    close(gained / sliding, share, 1e-12);
    close(gained, 0.87, 0.005);
    assert!(motion.changes().is_empty() && last.friction.norm() < 0.1 * last.normal_force);
}
