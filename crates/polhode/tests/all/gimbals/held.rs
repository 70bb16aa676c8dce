//! Locked, driven, damped and sprung axes; gimbal lock.

use core::f64::consts::FRAC_PI_2;

use polhode::math::{Direction, Part};
use polhode::motion::gimbal::{Axis, Base, Gimbal, Gimbals, Spring};
use polhode::motion::{Ending, EventAction, Measure, MotionError, Sense};
use polhode::prelude::*;

use super::{GRAVITY, balanced, free, generic_rotor, near, run, symmetric_rotor, upright};

/// All axes locked: the whole is one body that turns with the base. The holding torques are ω × I ω
/// minus that of the weight, along each axis.
#[test]
fn locks_hold_what_turns_with_the_base() {
    let rotor = generic_rotor();
    let angles = [0.7, -0.4, 1.3];
    let axes = angles.map(|angle| Axis::locked(angle).unwrap());
    let inner_mass = MassProperties::<Part>::new(
        0.8,
        Position::new(0.02, 0.01, -0.04),
        InertiaTensor::with_negative_products([0.004, 0.005, 0.006], [0.0005, -0.0004, 0.0003]).unwrap(),
    );
    let omega = AngularVelocity::<Space>::new(1.1, -0.7, 2.3);
    let gimbals = upright(axes)
        .holding(Position::ZERO, Direction::new(0.2, -0.1, 1.0))
        .and_then(|gimbals| gimbals.with_base(Base::turning(omega)?).with_gravity(GRAVITY))
        .unwrap()
        .with_mass(Gimbal::MASSLESS, Gimbal::pendulous(&inner_mass.unwrap()));
    let motion = run(&rotor, &gimbals, &[0.0, 2.0]);
    let start = &motion.samples()[0];
    // The rotor alone, about its own axis: e₃ · (ω × I ω − m c × g), in its own axes.
    let about = rotor.inertia_about(Position::ZERO).matrix();
    let w = start.state.omega;
    let image = about.map(|row| row[0] * w.x + row[1] * w.y + row[2] * w.z);
    let gyroscopic = Direction::<Body>::from_array(w.to_array()).cross(Direction::from_array(image));
    let g = start.state.attitude.inverse() * GRAVITY;
    let arm = Direction::<Body>::from_array(rotor.center_of_mass().to_array());
    let weight = arm.cross(Direction::from_array(g.to_array())) * rotor.mass();
    near(start.holding[2], gimbals.rotor_axis().dot(gyroscopic - weight), 1e-15);
    assert!((start.state.attitude * w - Vector::from_array(omega.to_array())).norm() < 1e-14);
    // Nothing changes relative to the base.
    let end = &motion.samples()[1];
    assert_eq!(end.angles, angles);
    end.holding.iter().zip(start.holding).for_each(|(end, start)| near(*end, start, 1e-15));
    let turned = Rotation::<Space, Space>::from_axis_angle(
        Direction::from_array(omega.to_array()),
        2.0 * omega.norm(),
    );
    assert!((turned.unwrap() * start.state.attitude).angle_to(end.state.attitude) < 1e-15);
}

/// One free axis is a pendulum with damping and a spring: θ̈ = −(k + …) θ − d θ̇ + τ, without
/// gravity in closed form.
#[test]
fn a_single_axis_swings_as_its_spring_and_its_damping_say() {
    let rotor = symmetric_rotor(0.03, 0.05, 1.0, 0.0);
    let spring = Spring { stiffness: 1.7, rest: 0.2 };
    let axis = Axis::free(0.9, -0.3).and_then(|a| a.damped(0.08)?.sprung(spring)?.turned_by(0.11)).unwrap();
    let axes = [Axis::locked(0.4).unwrap(), axis, Axis::locked(0.1).unwrap()];
    let motion = run(&rotor, &upright(axes), &[0.7, 3.0]);
    let (decay, middle) = (0.08 / 0.06, 0.2 + 0.11 / 1.7);
    let rate = (1.7 / 0.03 - decay * decay).sqrt();
    let (a, b) = (0.9 - middle, (-0.3 + decay * (0.9 - middle)) / rate);
    for sample in motion.samples() {
        let t = sample.state.time;
        let (s, c) = (rate * t).sin_cos();
        near(sample.angles[1], middle + (-decay * t).exp() * (a * c + b * s), 1e-14);
    }
    assert!(motion.energy_drift() < 1e-14);
}

/// A driven rotor keeps its rate, and the work of the motor is the added energy.
#[test]
fn a_motor_keeps_the_rate_of_an_asymmetric_rotor() {
    let rotor = generic_rotor();
    let axes = [Axis::free(0.3, 0.4), Axis::free(-0.5, 0.7), Axis::driven(0.2, 20.0)].map(Result::unwrap);
    let gimbals = upright(axes)
        .with_mass(balanced([0.004, 0.005, 0.006], [0.0005, -0.0004, 0.0003]), Gimbal::MASSLESS)
        .with_gravity(GRAVITY)
        .unwrap();
    let times: Vec<f64> = (1..=20).map(|k| 0.1 * f64::from(k)).collect();
    let motion = run(&rotor, &gimbals, &times);
    for sample in motion.samples() {
        near(sample.rates[2], 20.0, 0.0);
        near(sample.angles[2], 0.2 + 20.0 * sample.state.time, 1e-13);
    }
    let works = motion.samples().iter().map(|sample| sample.motor_work.abs());
    assert!(works.fold(0.0, f64::max) > 0.01);
    assert!(motion.energy_drift() < 1e-14, "{:.1e}", motion.energy_drift());
}

/// A rotor without spin tips straight to the lock of massless gimbals; with a gimbal that has mass
/// it continues.
#[test]
fn massless_gimbals_lock_and_end_the_motion() {
    let rotor = symmetric_rotor(0.012, 0.02, 1.0, 0.0);
    let gimbals = upright(free([0.2, 0.3, 0.0], [0.0, 0.8, 0.0]));
    let motion = run(&rotor, &gimbals, &[1.0, 2.0]);
    let Ending::Failed { time, cause } = motion.ending() else { panic!("{:?}", motion.ending()) };
    near(*time, (FRAC_PI_2 - 0.3) / 0.8, 1e-4);
    assert!(matches!(cause, MotionError::GimbalLock { angle, .. } if (angle - FRAC_PI_2).abs() < 1e-4));
    assert!(cause.is_numerical() && cause.to_string().contains("the gimbals lock"), "{cause}");
    assert_eq!(motion.samples().last().unwrap().state.time, *time);
    assert_eq!(motion.samples().len(), 2);
    let heavy = gimbals.with_mass(balanced([0.001, 0.001, 0.001], [0.0; 3]), Gimbal::MASSLESS);
    let motion = run(&rotor, &heavy, &[1.0, 2.0]);
    near(motion.samples()[1].angles[1], 1.9, 1e-13);
}

/// Only the angles themselves depend on the zero positions of the axes.
#[test]
fn turned_zeros_of_the_angles_are_the_same_motion() {
    let rotor = generic_rotor();
    let first = upright(free([0.3, -0.5, 1.1], [0.4, 0.7, 5.0])).with_gravity(GRAVITY).unwrap();
    let (s, c) = 0.3_f64.sin_cos();
    let axes = free([0.0, -0.5, 1.1], [0.4, 0.7, 5.0]);
    let second = Gimbals::new(Direction::new(0.0, 0.0, 2.0), Direction::new(c, s, 0.0), axes).unwrap();
    let second = second.with_gravity(GRAVITY).unwrap();
    let [a, b] = [first, second].map(|gimbals| run(&rotor, &gimbals, &[1.5]).samples()[0]);
    assert!(a.state.attitude.angle_to(b.state.attitude) < 1e-13);
    near(a.angles[0], b.angles[0] + 0.3, 1e-13);
}

/// The outer axis turns at 2 rad/s, and the rotor's axis away from its start.
#[test]
fn an_event_stops_a_motion_in_gimbals() {
    let axes = [Axis::driven(0.0, 2.0), Axis::locked(0.0), Axis::locked(0.0)].map(Result::unwrap);
    let (rotor, gimbals) = (generic_rotor(), upright(axes));
    let tilt =
        |space: Direction<Space>| Measure::Tilt { body: Direction::new(0.0, 0.0, 1.0), space: space.into() };
    // The rotor's axis is along y at first.
    let event = |name, value, action| {
        Event::new(name, tilt(Direction::new(0.0, 1.0, 0.0)), value, Sense::Rising, action).unwrap()
    };
    let events = [event("seen", 0.5, EventAction::Record), event("far", 0.7, EventAction::Stop)];
    let simulation = Simulation::in_gimbals(&rotor, &gimbals, 0.0, &[0.0, 0.3, 1.0]).events(&events);
    let motion = simulation.run().unwrap();
    let times: Vec<f64> = motion.events().iter().map(|crossing| crossing.state.time).collect();
    let Ending::Stopped { event: 1, time } = *motion.ending() else { panic!("{:?}", motion.ending()) };
    near(times[0], 0.25, 1e-14);
    near(time, 0.35, 1e-14);
    assert_eq!((times.len(), times[1]), (2, time));
    assert_eq!(motion.samples().last().unwrap().state.time, time);
    let switch = [event("on", 0.5, EventAction::Switch { torque: 0, on: true })];
    assert!(matches!(simulation.events(&switch).run(), Err(MotionError::Exclusive { .. })));
    // Without events, all times are present.
    let states: Vec<State> =
        simulation.events(&[]).run().unwrap().samples().iter().map(|s| s.state).collect();
    assert_eq!(simulation.states().unwrap(), states);
}
