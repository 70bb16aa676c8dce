//! Measures that are constant after a switch, such as the energy of a torque-free body: step errors
//! must not cross the value.
//!
//! An event that switches off the only torque leaves its measure at its value. At tolerances from
//! 1e-4 to 1e-15 it happens once, and so does a recording event of the same value. A torque that
//! acts later moves the measure off the value. This is a passage, or none, as before the drift.

use crate::common::scenario::Random;
use polhode::motion::torque::{Schedule, Scheduled};
use polhode::motion::{Ending, EventAction, Measure, Sense};
use polhode::prelude::*;

const METHODS: [Method; 2] = [Method::Taylor, Method::Dop853];
const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 1e-9, 1e-13, 1e-15];

/// Returns the seeds of random motions: those of the gate, or those of the large run,
/// `POLHODE_SCENARIOS=0..400 cargo test -p polhode --test all event_drift`.
fn scenarios() -> core::ops::Range<u64> {
    let Ok(range) = std::env::var("POLHODE_SCENARIOS") else { return 0..6 };
    let (from, to) = range.split_once("..").unwrap_or_else(|| panic!("POLHODE_SCENARIOS is FROM..TO"));
    from.parse().unwrap()..to.parse().unwrap()
}

fn event(measure: &Measure, value: f64, sense: Sense, action: EventAction) -> Event {
    Event::new("it", measure.clone(), value, sense, action).unwrap()
}

#[test]
fn a_measure_that_a_switch_makes_constant_passes_its_value_once() {
    let axis = Direction::new(0.0, 0.0, 1.0);
    let switch = EventAction::Switch { torque: 0, on: false };
    for seed in scenarios() {
        let mut random = Random::new(seed);
        let is_symmetric = random.next() < 0.5;
        let [i1, i2] = [0, 1].map(|_| random.between(0.5, 1.0));
        let i2 = if is_symmetric { i1 } else { i2 };
        let inertia =
            InertiaTensor::diagonal([i1, i2, random.between((i1 - i2).abs() + 0.1, i1 + i2)]).unwrap();
        let body = MassProperties::new(1.3, Position::ZERO, inertia).unwrap();
        let rotor = Rotor::free(&body);
        let measures: &[Measure] = match is_symmetric {
            true => &[Measure::KineticEnergy, Measure::Momentum, Measure::Rate, Measure::OmegaBody(axis)],
            false => &[Measure::KineticEnergy, Measure::Momentum],
        };
        let measure = measures[random.below(measures.len())].clone();
        let attitude = Attitude::from_quaternion(random.quaternion()).unwrap();
        let [x, y, z] = random.vector(1.5);
        let start = State { time: 0.0, attitude, omega: AngularVelocity::new(x, y, z) };
        let torques = [TorqueModel::Constant(ConstantTorque::Body(Torque::from_array(random.vector(1.0))))];
        let value = |state: &State| match &measure {
            Measure::KineticEnergy => rotor.kinetic_energy(state.omega),
            Measure::Momentum => rotor.angular_momentum_space(state).norm(),
            Measure::Rate => state.omega.norm(),
            _ => state.omega.z,
        };
        let driven = Simulation::new(&rotor, &torques, start, &[1.7]).run().unwrap();
        let between = 0.4 * value(&start) + 0.6 * value(&driven.samples()[0].state);
        let events = [
            event(&measure, between, Sense::Either, switch),
            event(&measure, between, Sense::Either, EventAction::Record),
        ];
        for (tolerance, method) in TOLERANCES.into_iter().flat_map(|t| METHODS.map(|m| (t, m))) {
            let motion = Simulation::new(&rotor, &torques, start, &[40.0])
                .events(&events)
                .method(method)
                .tolerance(tolerance)
                .run()
                .unwrap();
            let found: Vec<_> = motion.events().iter().map(|it| (it.event, it.state.time)).collect();
            let place = format!("motion {seed}: {measure:?} {method:?} {tolerance:e}: {found:?}");
            assert_eq!(found.iter().map(|it| it.0).collect::<Vec<_>>(), [0, 1], "{place}");
            assert!(found[0].1 == found[1].1 && found[0].1 < 1.8, "{place}");
            assert_eq!(*motion.ending(), Ending::Complete, "{place}");
        }
    }
}

#[test]
fn a_later_torque_moves_a_measure_off_the_value_at_which_it_drifted() {
    let inertia = InertiaTensor::diagonal([0.66, 0.66, 1.25]).unwrap();
    let body = MassProperties::new(10.0, Position::ZERO, inertia).unwrap();
    let rotor = Rotor::free(&body);
    let omega = AngularVelocity::new(0.1, 0.0, 1.0);
    let start = State { time: 0.0, attitude: Attitude::identity(), omega };
    let about_z = |torque| TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, torque)));
    let off = EventAction::Switch { torque: 0, on: false };
    for (later, count) in [(-0.02, 1), (0.02, 0)] {
        let schedule = Schedule::window(100.0, 110.0).unwrap();
        let later = TorqueModel::Scheduled(Box::new(Scheduled { torque: about_z(later), schedule }));
        let torques = [about_z(0.5), later];
        let events = [
            event(&Measure::Rate, 3.0, Sense::Rising, off),
            event(&Measure::Rate, 3.0, Sense::Falling, EventAction::Record),
        ];
        for (tolerance, method) in TOLERANCES.into_iter().flat_map(|t| METHODS.map(|m| (t, m))) {
            let motion = Simulation::new(&rotor, &torques, start, &[115.0])
                .events(&events)
                .method(method)
                .tolerance(tolerance)
                .run()
                .unwrap();
            let falls: Vec<f64> =
                motion.events().iter().filter(|it| it.event == 1).map(|it| it.state.time).collect();
            let place = format!("{method:?} {tolerance:e} {falls:?}");
            assert_eq!((falls.len(), motion.events().len()), (count, 1 + count), "{place}");
            // The drift takes this long at a rate of 0.016 rad/s².
            let delay = 2e3 * tolerance + 1e-9;
            assert!(falls.iter().all(|t| *t >= 100.0 && *t < 100.0 + delay.min(5.0)), "{place}");
        }
    }
}

#[test]
fn a_measure_that_stays_the_same_from_the_start_passes_no_value_near_it() {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let rotor = Rotor::free(&MassProperties::new(2.3, Position::new(0.1, -0.2, 0.3), inertia).unwrap());
    let omega = AngularVelocity::new(0.3, -0.8, 1.1);
    let start = State { time: 0.0, attitude: Attitude::identity(), omega };
    let [energy, momentum] = [rotor.kinetic_energy(omega), rotor.angular_momentum_space(&start).norm()];
    for offset in [0.0, 1e-15, -1e-12, 1e-9] {
        let events =
            [(Measure::KineticEnergy, energy), (Measure::Momentum, momentum)].map(|(measure, value)| {
                event(&measure, value * (1.0 + offset), Sense::Either, EventAction::Record)
            });
        for (tolerance, method) in TOLERANCES.into_iter().flat_map(|t| METHODS.map(|m| (t, m))) {
            let motion = Simulation::new(&rotor, &[], start, &[100.0])
                .events(&events)
                .method(method)
                .tolerance(tolerance)
                .run()
                .unwrap();
            assert!(motion.events().is_empty(), "{offset:e} {method:?} {tolerance:e} {:?}", motion.events());
        }
    }
}
