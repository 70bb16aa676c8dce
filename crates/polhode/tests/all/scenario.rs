//! Scenarios: exclusions, in either order, and findings before a run.

use polhode::math::Rotation;
use polhode::motion::contact::{BodySurface, Contact, StartVelocity, SurfaceShape};
use polhode::motion::gimbal::{Axis, Gimbals};
use polhode::motion::torque::EnergySink;
use polhode::motion::{
    ActingTorque, Anomaly, EventAction, GroundContact, MU_EARTH, MassHistory, MassRow, Measure, Motor,
    MountedShaft, Orbit, OrbitalElements, Outflow, Prescribed, Run, Sense, Shaft, Suspension, Task,
};
use polhode::prelude::*;

fn body() -> MassProperties<Body> {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap()
}

fn z() -> Direction<Body> {
    Direction::new(0.0, 0.0, 1.0)
}

/// Adds one part to a scenario, by its name in scenario files.
fn with(part: &str, scenario: Scenario) -> Result<Scenario, MotionError> {
    match part {
        "prescribed" => {
            scenario.prescribed_as(Prescribed::euler_rates([0.2, 1.1, 0.3], [0.5, 0.0, 30.0]).unwrap())
        }
        "torque" => scenario.with_torques([TorqueModel::EnergySink(EnergySink::new(0.01).unwrap())]),
        "event" => {
            let event = Event::new("fast", Measure::Rate, 9.0, Sense::Either, EventAction::Record);
            scenario.watching(vec![event.unwrap()])
        }
        "wheel" => scenario.with_wheels(&[Wheel::new(z(), 1.3, Motor::HeldSpeed).unwrap()]),
        "orbit" => scenario.in_orbit(Orbit::of_elements(
            MU_EARTH,
            &OrbitalElements {
                semi_major_axis: 7.3e6,
                eccentricity: 0.04,
                inclination: 0.9,
                node: 2.1,
                periapsis: -0.7,
                anomaly: Anomaly::Mean(0.3),
            },
        )?),
        "pendulum" => scenario.suspended_from(Suspension { axis: z(), amplitude: None }),
        "shaft" => {
            let shaft = Shaft::new(body(), Position::ZERO, z(), [-0.3, 0.4]).unwrap();
            let gravity = Acceleration::new(0.3, -0.2, -9.7);
            let mounted =
                MountedShaft { shaft, rate: 30.0, acceleration: -1.5, gravity, balance: Vec::new() };
            scenario.mounted(mounted)
        }
        "mass_history" => {
            let row = |time| MassRow { time, body: body(), rates: None };
            scenario.changing(MassHistory::new(&[row(1.0), row(2.0)], Outflow::None).unwrap())
        }
        "contact" => {
            let shape = SurfaceShape::Sphere { radius: 10.0 };
            let surface = BodySurface::new(shape, Position::ZERO, Rotation::identity()).unwrap();
            let (contact, velocity) = (Contact::rolling(surface), StartVelocity::Rolling);
            scenario.on_ground(GroundContact { contact, at: Position::ZERO, velocity })
        }
        "gimbals" => {
            let axes = [0.3, 0.4, 0.5].map(|angle| Axis::free(angle, 0.2).unwrap());
            let [up, east] = [Direction::new(0.0, 0.0, 1.0), Direction::new(1.0, 0.0, 0.0)];
            scenario.in_gimbals(Gimbals::new(up, east, axes).unwrap())
        }
        other => panic!("{other}"),
    }
}

#[test]
fn what_excludes_each_other_does_so_in_either_order() {
    for (a, b, why) in Scenario::EXCLUSIVE {
        for (first, second) in [(a, b), (b, a)] {
            let one = with(first, Scenario::new(body())).unwrap();
            let refused = with(second, one).unwrap_err();
            assert_eq!(refused, MotionError::Exclusive { parts: [a, b], why }, "{first}, then {second}");
            assert!(refused.to_string().contains(why) && !refused.is_numerical());
        }
    }
    // Parts that are not in the list are compatible.
    let both = with("event", with("wheel", with("torque", Scenario::new(body())).unwrap()).unwrap()).unwrap();
    assert_eq!((both.torques().len(), both.wheels().len(), both.events().len()), (1, 1, 1));
}

#[test]
fn a_body_that_is_held_does_not_move_and_a_start_is_finite() {
    let moving = Velocity::new(1.0, 0.0, -2.0);
    let held = Scenario::new(body()).held_at(Position::ZERO).unwrap();
    assert!(matches!(held.clone().moving(moving), Err(MotionError::Exclusive { .. })));
    let free = Scenario::new(body()).moving(moving).unwrap();
    assert!(matches!(free.clone().held_at(Position::ZERO), Err(MotionError::Exclusive { .. })));
    assert!(matches!(with("shaft", free.clone()), Err(MotionError::Exclusive { .. })));
    assert!(matches!(with("shaft", held), Err(MotionError::Exclusive { .. })));
    let start = free.start();
    for wrong in [
        State { time: f64::NAN, ..start },
        State { omega: AngularVelocity::new(0.0, f64::INFINITY, 1.0), ..start },
    ] {
        assert!(matches!(free.clone().starting(wrong), Err(ref error) if error.is_parameter()));
    }
}

#[test]
fn a_prescribed_motion_starts_where_it_does_and_a_shaft_turns_about_its_line() {
    let led = with("prescribed", Scenario::new(body())).unwrap();
    let (state, _) = led.prescribed().unwrap().at(0.0).unwrap();
    assert_eq!((led.start(), led.task()), (state, &Task::Inverse(led.prescribed().unwrap().clone())));
    let shaft = with("shaft", Scenario::new(body())).unwrap();
    assert_eq!(
        (shaft.pivot(), shaft.start().omega),
        (Some(Position::ZERO), AngularVelocity::new(0.0, 0.0, 30.0))
    );
    assert_eq!(shaft.rotor(), &Rotor::pivoted(&body(), Position::ZERO));
}

#[test]
fn what_does_nothing_is_told_before_it_runs() {
    let codes = |scenario: &Scenario| scenario.check().iter().map(|f| f.code).collect::<Vec<_>>();
    let still = Scenario::new(body()).sampled(Run::evenly(1.0, 3, Method::Auto, 1e-12));
    assert_eq!(codes(&still), ["start.rest"]);
    assert!(codes(&still.clone().not_sampled()).is_empty());
    let gravity = TorqueModel::Gravity(UniformGravity::STANDARD);
    let balanced = Scenario::new(body()).held_at(body().center_of_mass()).unwrap();
    assert_eq!(codes(&balanced.with_torques([gravity.clone()]).unwrap()), ["gravity.balanced"]);
    let off = ActingTorque { model: gravity, name: Some("weight".to_owned()), is_on: false };
    let hung = still.held_at(Position::ZERO).unwrap().with_torques([off]).unwrap();
    assert_eq!((codes(&hung), hung.switched_off()), (vec!["torque.off"], &[0][..]));
}
