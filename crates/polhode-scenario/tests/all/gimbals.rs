//! Rotors in gimbals in scenario files: reading, and the place of each error.

use std::f64::consts::TAU;

use polhode::math::{Acceleration, Direction};
use polhode::motion::Mechanism;
use polhode::motion::gimbal::{Base, Gimbals, Hold, Spring};
use polhode::prelude::*;
use polhode_scenario::read as scenario;
use polhode_source::FormatError;

const BODY: &str = "[[body.part]]\nshape = 'tensor'\nmass = '1.3 kg'\ncenter_of_mass = [0.01, -0.02, 0.03]\n\
    inertia = [[0.011, 0.0004, -0.0003], [0.0004, 0.012, 0.0002], [-0.0003, 0.0002, 0.013]]\n";
const AXES: &str = "outer_axis = [0, 0, 1]\ninner_axis = [1, 0, 0]\n";
const RUN: &str = "[run]\nduration = '1 s'\nsamples = 5\n";

fn parse(text: &str) -> Result<Scenario, FormatError> {
    scenario::parse(text, "test.toml".as_ref())
}

fn text(keys: &str) -> String {
    format!("{BODY}[gimbals]\n{AXES}{keys}\n{RUN}")
}

fn gimbals(keys: &str) -> Gimbals {
    let scenario = parse(&text(keys)).unwrap_or_else(|e| panic!("{e}"));
    let Mechanism::Gimbals(gimbals) = scenario.mechanism() else { panic!("no gimbals") };
    *gimbals
}

#[track_caller]
fn refused(text: &str, message: &str) {
    let error = parse(text).expect_err("it should be refused");
    let shown = format!("{error} {}", error.hint().unwrap_or_default());
    assert!(shown.contains(message), "{shown}");
}

#[test]
fn gimbals_are_what_their_keys_say() {
    let given = gimbals(
        "rotor_axis = [0, 3, 4]\ncrossing = ['10 mm', 0, '-5 mm']\ngravity = [0, '0.1 m/s^2', '-9.81 m/s^2']\n\
         base = { rate = ['0.1 rad/s', 0, '6 deg/s'] }\n\
         outer = { angle = '10 deg', rate = '2 deg/s', damping = '0.1 N m s/rad', spring = '2 N m/rad', rest = '5 deg', torque = '3 N m', moments = [0.01, 0.02, 0.015] }\n\
         inner = { angle = '-0.3 rad', locked = true, mass = '0.5 kg', center_of_mass = [0, '2 cm', 0], moments = [0.01, 0.02, 0.015] }\n\
         rotor = { rate = '600 rpm', driven = true, damping = '1e-3 N m s/rad' }",
    );
    let [outer, inner, rotor] = *given.axes();
    assert_eq!(outer.hold(), Hold::Free);
    assert!((outer.angle() - 10_f64.to_radians()).abs() < 1e-16);
    assert!((outer.rate() - 2_f64.to_radians()).abs() < 1e-16);
    assert_eq!(outer.damping(), 0.1);
    let Spring { stiffness, rest } = outer.spring().unwrap();
    assert!(stiffness == 2.0 && (rest - 5_f64.to_radians()).abs() < 1e-16);
    assert_eq!(outer.torque(), 3.0);
    assert_eq!((inner.hold(), inner.angle()), (Hold::Locked, -0.3));
    assert_eq!((rotor.hold(), rotor.damping()), (Hold::Driven, 1e-3));
    assert!((rotor.rate() - 10.0 * TAU).abs() < 1e-13);
    assert!((given.rotor_axis() - Direction::new(0.0, 0.6, 0.8)).norm() < 1e-15);
    assert_eq!(given.crossing(), Position::new(0.01, 0.0, -0.005));
    assert_eq!(given.gravity(), Acceleration::new(0.0, 0.1, -9.81));
    let turning = given.base().angular_velocity();
    assert!((turning - AngularVelocity::new(0.1, 0.0, 6_f64.to_radians())).norm() < 1e-16);
    let [of_outer, of_inner] = given.masses();
    assert_eq!(of_outer.inertia(), [[0.01, 0.0, 0.0], [0.0, 0.02, 0.0], [0.0, 0.0, 0.015]]);
    assert_eq!(of_outer.moment(), [0.0; 3]);
    // About the crossing of the axes, by the parallel-axis theorem.
    let [x, y, z] = [0, 1, 2].map(|k| of_inner.inertia()[k][k]);
    assert!((x - 0.0102).abs() < 1e-17 && (y - 0.02).abs() < 1e-17 && (z - 0.0152).abs() < 1e-17);
    assert_eq!(of_inner.moment(), [0.0, 0.01, 0.0]);
}

#[test]
fn what_is_not_said_is_usual() {
    let given = gimbals("");
    assert!(given.axes().iter().all(|axis| axis.hold() == Hold::Free && axis.rate() == 0.0));
    assert_eq!(given.crossing(), Position::new(0.01, -0.02, 0.03), "the centre of mass");
    assert_eq!(given.gravity(), Acceleration::new(0.0, 0.0, -9.80665));
    assert_eq!((*given.base(), given.rotor_axis()), (Base::FIXED, Direction::new(0.0, 0.0, 1.0)));
    assert!(given.masses().iter().all(|gimbal| gimbal.inertia() == [[0.0; 3]; 3]));
    let earth = gimbals("base = { latitude = '-30 deg' }").base().angular_velocity();
    let south = Base::on_earth((-30_f64).to_radians()).unwrap().angular_velocity();
    assert!((earth - south).norm() < 1e-19, "{earth:?}");
    assert!(earth.y > 0.0 && earth.z < 0.0);
    assert_eq!(gimbals("rotor = { locked = false, rate = 3 }").axes()[2].hold(), Hold::Free);
}

#[test]
fn each_mistake_has_its_place() {
    let cases = [
        ("spin = 3", "unknown key"),
        ("inner = { agle = 3 }", "did you mean angle"),
        ("rotor = { moments = [1, 2, 3] }", "moments"),
        ("outer = { angle = '3 kg' }", "is a mass where an angle belongs"),
        ("outer = { damping = -1 }", "the damping of an axis = -1 must be finite and not negative"),
        ("outer = { spring = 0 }", "positive"),
        ("outer = { rest = '3 deg' }", "left out without spring"),
        ("outer = { locked = true, rate = 3 }", "left out with locked = true"),
        ("outer = { locked = true, damping = 3 }", "left out with locked = true"),
        ("outer = { locked = true, driven = true, rate = 3 }", "a lock fixes the angle"),
        ("rotor = { driven = true }", "rate"),
        ("inner = { angle = '90 deg' }", "the angle of the inner gimbal"),
        ("base = { latitude = '91 deg' }", "the latitude of the base"),
        ("base = { latitude = '9 deg', rate = [0, 0, 1] }", "both define the rotation of the base"),
        ("base = { }", "latitude"),
        ("rotor_axis = [0, 0, 0]", "a direction: finite and not zero"),
        ("outer = { center_of_mass = [0, 0, 1], moments = [1, 1, 1] }", "mass"),
        ("outer = { moments = [1, 1, 3] }", "3"),
    ];
    for (keys, message) in cases {
        refused(&text(keys), message);
    }
    let bare = |keys: &str| format!("{BODY}[gimbals]\n{keys}\n{RUN}");
    refused(&bare("outer_axis = [0, 0, 1]"), "inner_axis");
    refused(&bare("outer_axis = [0, 0, 1]\ninner_axis = [1, 0, 0.1]"), "perpendicular");
    refused(&bare("outer_axis = [0, 0, 0]\ninner_axis = [1, 0, 0]"), "a direction");
    // The place is the angle itself.
    let error = parse(&text("inner = { angle = '90 deg' }")).unwrap_err();
    assert!(error.to_string().starts_with("test.toml:9:19:"), "{error}");
}

#[test]
fn what_does_not_go_with_gimbals_is_refused() {
    let with = |more: &str| format!("{BODY}[gimbals]\n{AXES}{more}\n{RUN}");
    refused(&with("[start]\nspin = { body = [0, 0, 1] }"), "the start of a rotor in gimbals is defined");
    refused(
        &with("[[torque]]\nmodel = 'gravity'\npivot = [0, 0, 0]"),
        "only gravity and torques about the three gimbal",
    );
    refused(&with("[[event]]\nmeasure = 'time'\nvalue = 1"), "events are available for");
    refused(&with("[orbit]\naltitude = '500 km'"), "their base");
    refused(&with("[[wheel]]\naxis = [0, 0, 1]\nmomentum = 1"), "the rotor is one rigid body");
    refused(&with("[sweep]\nmembers = 3"), "sweeps have no outcomes");
    refused(&with("").replace("samples = 5", "samples = 5\nmethod = 'dop853'"), "\"auto\" or \"taylor\"");
    let held = with("").replace("[gimbals]", "[body]\npivot = [0, 0, 0]\n[gimbals]");
    refused(&held, "left out with [gimbals]");
}
