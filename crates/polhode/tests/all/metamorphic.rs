//! Metamorphic tests with random scenarios: results transform like axes, units and parts. They do
//! not depend on the order of torques, on the method, on the tolerance, or on a division of the run
//! into parts. Two results differ by at most twice the sum of their stated errors.

use crate::common::scenario::{Change, Lump, Numbers, Random};
use polhode::motion::{Ending, ErrorEffort, EventAction, Measure, Run, Sense, SplittingOrder, StateError};
use polhode::prelude::*;

/// Tolerances of the compared runs.
const TOLERANCES: [f64; 5] = [1e-13, 1e-11, 1e-8, 1e-5, 1e-2];

/// Rounding of the transformed inputs, in units of the rounding that the stated input error
/// assumes: a tensor is rotated by about twenty operations.
const INPUTS: f64 = 16.0;

/// Scenarios of the gate. Others: `POLHODE_METAMORPHIC=0..2000 cargo test -p polhode --test all
/// metamorphic`.
const SCENARIOS: core::ops::Range<u64> = 0..300;

fn scenarios() -> core::ops::Range<u64> {
    let Ok(range) = std::env::var("POLHODE_METAMORPHIC") else { return SCENARIOS };
    let (from, to) = range.split_once("..").unwrap_or_else(|| panic!("POLHODE_METAMORPHIC is FROM..TO"));
    from.parse().unwrap()..to.parse().unwrap()
}

/// A scenario with its events.
#[derive(Clone)]
struct Case {
    numbers: Numbers,
    /// |ω| and a time at which torques are switched off, if there are any.
    rate: f64,
    time: f64,
    end: f64,
    method: Method,
    tolerance: f64,
}

/// States at four times, and their errors: of the computation, and of the inputs.
struct Outcome {
    states: Vec<State>,
    errors: Vec<[StateError; 2]>,
    events: Vec<(usize, bool)>,
    ending: &'static str,
}

impl Case {
    /// Returns a random scenario; `None` if its motion ends too early for a comparison.
    fn random(seed: u64) -> Option<Self> {
        let mut random = Random::new(seed ^ 0x5eed);
        let numbers = Numbers::random(&mut random);
        let times: Vec<f64> = (0..=40).map(|k| numbers.duration * f64::from(k) / 40.0).collect();
        let motion =
            Simulation::new(&numbers.rotor(), &numbers.torques(), numbers.start(), &times).run().unwrap();
        let samples = motion.samples();
        let rate = samples[random.below(samples.len())].state.omega.norm();
        let end = 0.9 * samples.last().unwrap().state.time;
        let (time, tolerance) = (random.between(0.2, 0.8) * end, TOLERANCES[0]);
        (end > 0.5).then_some(Self { numbers, rate, time, end, method: Method::Taylor, tolerance })
    }

    fn events(&self) -> Vec<Event> {
        let either = Sense::Either;
        let off = |torque| EventAction::Switch { torque, on: false };
        let count = self.numbers.pushes.len();
        let by_rate = if count > 1 { off(1) } else { EventAction::Record };
        let by_time = if count > 0 { off(0) } else { EventAction::Record };
        vec![
            Event::new("rate", Measure::Rate, self.rate, either, by_rate).unwrap(),
            Event::new("time", Measure::Time, self.time, either, by_time).unwrap(),
        ]
    }

    fn run(&self, order: &[usize]) -> Outcome {
        let (rotor, start) = (self.numbers.rotor(), self.numbers.start());
        let all = self.numbers.torques();
        let torques: Vec<TorqueModel> = order.iter().map(|k| all[*k].clone()).collect();
        let place = |torque: usize| order.iter().position(|k| *k == torque).unwrap();
        let events: Vec<Event> = self
            .events()
            .into_iter()
            .map(|event| {
                let action = match event.action() {
                    EventAction::Switch { torque, on } => EventAction::Switch { torque: place(torque), on },
                    action => action,
                };
                Event::new(event.name(), event.measure().clone(), event.value(), event.sense(), action)
                    .unwrap()
            })
            .collect();
        let times = [0.25, 0.5, 0.75, 1.0].map(|part| part * self.end);
        let simulation = Simulation::new(&rotor, &torques, start, &times).events(&events).method(self.method);
        let motion =
            simulation.tolerance(self.tolerance).run_with_error(ErrorEffort::Auto, &mut |_| true).unwrap();
        Outcome::of(&motion)
    }

    fn in_order(&self) -> Outcome {
        self.run(&(0..self.numbers.pushes.len()).collect::<Vec<_>>())
    }

    /// Computes the motion in two runs.
    fn in_two(&self) -> Outcome {
        let Self { numbers, end, method, tolerance, .. } = self;
        let times = [0.25, 0.5, 0.75, 1.0].map(|part| part * end);
        let sampled = |times: &[f64]| Run { times: times.to_vec(), method: *method, tolerance: *tolerance };
        let scenario = Scenario::new(numbers.body());
        let scenario = match numbers.rotor().is_pivoted() {
            true => scenario.held_at(numbers.rotor().point()).unwrap(),
            false => scenario,
        };
        let scenario = scenario.with_wheels(numbers.rotor().wheels()).unwrap();
        let scenario = scenario.with_torques(numbers.torques()).unwrap().starting(numbers.start()).unwrap();
        let scenario = scenario.watching(self.events()).unwrap().sampled(sampled(&times[..2]));
        let run = |scenario: &Scenario| {
            let effort = ErrorEffort::Auto;
            Outcome::of(&scenario.simulate_with_error(effort, &mut |_| true).unwrap().unwrap())
        };
        let first = scenario.simulate().unwrap().unwrap();
        let mut whole = run(&scenario);
        if !first.ending().is_complete() {
            return whole;
        }
        let rest = run(&scenario.continued_after(&first, times[2..].to_vec()).unwrap());
        whole.states.extend(rest.states);
        whole.errors.extend(rest.errors);
        whole.events.extend(rest.events);
        Outcome { ending: rest.ending, ..whole }
    }

    fn changed(&self, change: &Change) -> Self {
        let Self { rate, time, end, .. } = *self;
        let (rate, time, end) = (rate / change.time, time * change.time, end * change.time);
        Self { numbers: self.numbers.changed(change), rate, time, end, ..*self }
    }

    /// Splits every part into two of different mass at different places, and changes the order.
    fn in_parts(&self, random: &mut Random) -> Self {
        let mut numbers = self.numbers.clone();
        let halves = |lump: &Lump| {
            let part = random.between(0.2, 0.8);
            let offset = random.vector(0.02);
            let masses = [part * lump.mass, (1.0 - part) * lump.mass];
            let shifts = [offset, offset.map(|x| -x * part / (1.0 - part))];
            // Σ m (d² 1 − d dᵀ) of the two is subtracted from their tensors, in proportion to their
            // masses.
            let spread: [[f64; 3]; 3] = core::array::from_fn(|i| {
                core::array::from_fn(|j| {
                    let steiner = |m: f64, d: [f64; 3]| {
                        let square: f64 = d.iter().map(|x| x * x).sum();
                        m * (if i == j { square } else { 0.0 } - d[i] * d[j])
                    };
                    steiner(masses[0], shifts[0]) + steiner(masses[1], shifts[1])
                })
            });
            [0, 1].map(|k| Lump {
                mass: masses[k],
                center: core::array::from_fn(|i| lump.center[i] + shifts[k][i]),
                tensor: core::array::from_fn(|i| {
                    core::array::from_fn(|j| (lump.tensor[i][j] - spread[i][j]) * masses[k] / lump.mass)
                }),
            })
        };
        numbers.lumps = numbers.lumps.iter().flat_map(halves).collect();
        numbers.lumps.rotate_left(2);
        Self { numbers, ..self.clone() }
    }
}

impl Outcome {
    fn of(motion: &Trajectory) -> Self {
        let error = motion.error().unwrap();
        let errors = error.computation().iter().zip(error.inputs()).map(|(a, b)| [*a, *b]).collect();
        let ending = match motion.ending() {
            Ending::Complete => "complete",
            Ending::Failed { cause: MotionError::HalfTurn { .. }, .. } => "half turn",
            other => panic!("{other:?}"),
        };
        let events = motion.events().iter().map(|it| (it.event, it.rising)).collect();
        Self { states: motion.samples().iter().map(|sample| sample.state).collect(), errors, events, ending }
    }

    /// Returns the scenario in other axes and units.
    fn changed(&self, change: &Change) -> Self {
        let states = self.states.iter().map(|state| change.state(state)).collect();
        Self { states, errors: self.errors.clone(), events: self.events.clone(), ending: self.ending }
    }

    /// Returns the largest difference of two results relative to twice their stated errors;
    /// infinite if their events differ.
    fn difference(&self, other: &Self) -> f64 {
        if (&self.events, self.ending) != (&other.events, other.ending) {
            return f64::INFINITY;
        }
        let count = self.states.len() - usize::from(self.ending != "complete");
        let mut largest = 0.0_f64;
        for k in 0..count {
            let (a, b) = (&self.states[k], &other.states[k]);
            let bound = |of: fn(&StateError) -> f64| {
                let sum = |which: usize| of(&self.errors[k][which]) + of(&other.errors[k][which]);
                2.0 * sum(0) + INPUTS * sum(1)
            };
            let size = a.omega.norm().max(b.omega.norm());
            let attitude = a.attitude.angle_to(b.attitude) / bound(|e| e.attitude);
            let omega = (a.omega - b.omega).norm() / size / bound(|e| e.omega);
            largest = largest.max(attitude).max(omega);
        }
        largest
    }
}

#[test]
fn results_transform_as_scenarios_do() {
    let (mut compared, mut closest, mut failures) = (0_u32, 0.0_f64, Vec::new());
    for seed in scenarios() {
        let Some(case) = Case::random(seed) else { continue };
        let mut random = Random::new(seed ^ 0xa11);
        let base = case.in_order();
        let none = Change::NONE;
        let turned = Change { axes: [random.quaternion(), none.axes[1]], ..none };
        let placed = Change { axes: [none.axes[0], random.quaternion()], ..none };
        let scaled = Change { length: 0.3048, mass: 1.0 / 0.45359237, time: 1.0 / 60.0, ..none };
        let order: Vec<usize> = (0..case.numbers.pushes.len()).rev().collect();
        let with = |method, tolerance| Case { method, tolerance, ..case.clone() };
        // The gate runs one comparison per scenario, in turn; other scenarios run all.
        let all = if seed < SCENARIOS.end { seed % 9..seed % 9 + 1 } else { 0..9 };
        for k in all {
            let same = |other: &Outcome, what: &str| (base.difference(other), what.to_owned());
            let in_other_words = |change: &Change, what: &str| {
                (base.changed(change).difference(&case.changed(change).in_order()), what.to_owned())
            };
            let (part, what) = match k {
                0 => in_other_words(&turned, "body axes"),
                1 => in_other_words(&placed, "space axes"),
                2 => in_other_words(&scaled, "units"),
                3 => same(&case.in_parts(&mut random).in_order(), "parts"),
                4 => same(&case.run(&order), "order of torques"),
                5 => same(&case.in_two(), "two runs"),
                6 => same(&with(Method::Dop853, TOLERANCES[0]).in_order(), "DOP853"),
                7 if case.numbers.is_splittable() => {
                    let splitting = Method::Splitting { order: SplittingOrder::Six, step: case.end / 1000.0 };
                    same(&with(splitting, TOLERANCES[0]).in_order(), "splitting")
                }
                7 => same(&with(Method::Dop853, TOLERANCES[1]).in_order(), "DOP853"),
                _ => {
                    let method = if seed % 2 == 0 { Method::Taylor } else { Method::Dop853 };
                    let by = |tolerance: &f64| {
                        same(&with(method, *tolerance).in_order(), &format!("tolerance {tolerance:e}"))
                    };
                    let worse = |a: (f64, String), b: (f64, String)| if a.0 > b.0 { a } else { b };
                    TOLERANCES[1..].iter().map(by).reduce(worse).unwrap()
                }
            };
            (compared, closest) = (compared + 1, closest.max(part));
            if !(part <= 1.0) {
                failures.push(format!("scenario {seed}, {what}: {part} of the bound"));
            }
        }
    }
    println!("{compared} comparisons; the closest takes {closest:.3} of its bound");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(2 * compared as usize > scenarios().count());
}
