//! Events of formulas and functions that change much faster than the body turns: all passages are
//! found, or the run ends.

use core::f64::consts::PI;

use crate::common::free_body;
use polhode::math::formula::{Binary, Formula, Instruction, Unary};
use polhode::motion::{Ending, EventAction, EventFunction, Measure, Sense, StateVariables};
use polhode::prelude::*;

fn event(measure: Measure, value: f64) -> Event {
    Event::new("it", measure, value, Sense::Either, EventAction::Record).unwrap()
}

/// Returns the measure sin κt.
fn wave(kappa: f64) -> Measure {
    let time = StateVariables::NAMES.iter().position(|name| *name == "t").unwrap();
    let instructions = [
        Instruction::Constant(kappa),
        Instruction::Variable(time),
        Instruction::Binary(Binary::Multiply),
        Instruction::Unary(Unary::Sin),
    ];
    Measure::Formula(Formula::new(instructions).unwrap())
}

fn run(event: Event, omega: [f64; 3], push: f64, end: f64, method: Method) -> Trajectory {
    let rotor = free_body([2.0, 3.5, 5.0]);
    let torques = [TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.4 * push, push)))];
    let torques = if push == 0.0 { &[][..] } else { &torques };
    let start =
        State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::from_array(omega) };
    Simulation::new(&rotor, torques, start, &[end]).events(&[event]).method(method).run().unwrap()
}

#[test]
fn all_zeros_of_a_fast_formula_are_found() {
    // At rest, in free motion and under a torque; a resting body takes one step for the whole run.
    for (omega, push) in [([0.0; 3], 0.0), ([0.1, 0.2, 0.3], 0.0), ([0.0; 3], 0.5), ([0.7, -0.2, 1.1], 0.5)] {
        for (kappa, end) in [(50.0, 100.0), (500.0, 10.0), (5000.0, 1.0)] {
            for method in [Method::Auto, Method::Dop853] {
                let motion = run(event(wave(kappa), 0.0), omega, push, end, method);
                let found: Vec<f64> = motion.events().iter().map(|it| it.state.time).collect();
                let count = (kappa * end / PI).floor() as usize;
                assert_eq!(found.len(), count, "{omega:?} {push} {kappa} {method:?}");
                for (k, time) in found.iter().enumerate() {
                    let zero = (k + 1) as f64 * PI / kappa;
                    assert!((time - zero).abs() < 1e-14 * end, "{kappa} {time} {zero}");
                }
            }
        }
    }
}

#[test]
fn narrow_tops_of_a_fast_formula_are_found() {
    // sin κt > 1 − 10⁻⁶ within 0.0014 rad of each maximum.
    let (kappa, end, value) = (50.0, 10.0, 1.0 - 1e-6);
    let motion = run(event(wave(kappa), value), [0.0; 3], 0.5, end, Method::Auto);
    let tops = (kappa * end / (2.0 * PI) + 0.75).floor() as usize;
    assert_eq!(motion.events().len(), 2 * tops);
    let half = f64::acos(value) / kappa;
    for (k, crossing) in motion.events().iter().enumerate() {
        let top = (2.0 * PI * (k / 2) as f64 + 0.5 * PI) / kappa;
        let wanted = if k % 2 == 0 { top - half } else { top + half };
        assert!((crossing.state.time - wanted).abs() < 1e-11 && crossing.rising == (k % 2 == 0));
    }
}

#[test]
fn a_fast_ripple_on_a_slow_function_is_followed() {
    // t − 3.3 + 10⁻³ sin 5000t crosses zero about five times where it is within 10⁻³.
    let ripple = |t: f64| t - 3.3 + 1e-3 * (5000.0 * t).sin();
    let grid = |k: u32| 3.29 + 0.02 * f64::from(k) / 1e6;
    let wanted = (0..1_000_000).filter(|&k| ripple(grid(k)) * ripple(grid(k + 1)) < 0.0).count();
    assert!(wanted > 2);
    let measure = || Measure::Function(EventFunction::new(move |state| ripple(state.time)));
    for push in [0.0, 0.5] {
        let motion = run(event(measure(), 0.0), [0.0, 0.0, 0.2], push, 4.0, Method::Auto);
        assert_eq!(motion.events().len(), wanted);
    }
}

#[test]
fn a_formula_that_is_too_fast_ends_the_run() {
    let motion = run(event(wave(1e7), 0.0), [0.0; 3], 0.0, 10.0, Method::Auto);
    let Ending::Failed { cause, .. } = motion.ending() else { panic!("{:?}", motion.ending()) };
    assert_eq!(*cause, MotionError::EventTooFast { event: 0, time: 0.0, until: 10.0 });
    assert!(cause.is_numerical() && cause.to_string().contains("event 1 changes too fast"));
}
