//! Events of random motions: Taylor's method, DOP853 and a dense grid of samples agree on each of
//! them.
//!
//! Each scenario has up to four torques, some with schedules, and up to four events, which record,
//! switch or stop. Each event has a twin that records both directions. The measures of the events
//! are computed here along the motion by Taylor's method, at 600 times, and at times that approach
//! each switch to 10⁻⁷ s. Between two of these times there is an odd number of passages if the sign
//! differs, and an even number otherwise. There are two if a parabola through three values reaches
//! beyond zero.
//!
//! Both methods have the same passages and ending. Their times differ by at most 10⁻⁹ s, a hundred
//! times the error of such a motion at the tolerance of 10⁻¹³. Otherwise the measure by Taylor's
//! method at the time of DOP853 must be at the value to 10⁻¹⁰, because near a turning point a time
//! is less accurate than a value.

use crate::common::scenario::{Numbers, Random};
use polhode::motion::{Ending, EventAction, Measure, Sense};
use polhode::prelude::*;

const TOLERANCE: f64 = 1e-13;

/// Seeds of random scenarios of the gate. The large run, `POLHODE_SCENARIOS=0..2000 cargo test -p
/// polhode --test all event_random`, takes some minutes; its ranges may be run one by one.
const SCENARIOS: core::ops::Range<u64> = 0..16;

fn scenarios() -> core::ops::Range<u64> {
    let Ok(range) = std::env::var("POLHODE_SCENARIOS") else { return SCENARIOS };
    let (from, to) = range.split_once("..").unwrap_or_else(|| panic!("POLHODE_SCENARIOS is FROM..TO"));
    from.parse().unwrap()..to.parse().unwrap()
}

/// Returns the measure of an event minus its value, or a function with the same zeros; the size of
/// its terms; and true if a passage there counts.
fn gap(event: &Event, rotor: &Rotor, state: &State) -> (f64, f64, bool) {
    let (v, omega) = (event.value(), state.omega);
    let momentum = state.attitude.inverse() * rotor.angular_momentum_space(state);
    let plain = |x: f64, size: f64| (x - v, size.max(v.abs()), true);
    let between = |angle: f64| (angle - v, 1.0, true);
    let around = |angle: f64| ((angle - v).sin(), 1.0, (angle - v).cos() > 0.0);
    match event.measure() {
        Measure::Time => plain(state.time, 1.0),
        Measure::OmegaBody(n) => plain(n.dot(omega), omega.norm()),
        Measure::OmegaSpace(n) => plain(n.dot(state.omega_space()), omega.norm()),
        Measure::Rate => plain(omega.norm(), omega.norm()),
        Measure::KineticEnergy => plain(rotor.kinetic_energy(omega), rotor.kinetic_energy(omega)),
        Measure::Momentum => plain(momentum.norm(), momentum.norm()),
        Measure::Tilt { body, space } => {
            between(body.angle_to(state.attitude.inverse() * space.direction(state.time)))
        }
        Measure::OmegaAngle(n) => between(n.angle_to(omega)),
        Measure::MomentumAngle(n) => between(n.angle_to(momentum)),
        Measure::Nutation => between(state.attitude.euler313()[1]),
        Measure::Precession => around(state.attitude.euler313()[0]),
        Measure::Spin => around(state.attitude.euler313()[2]),
        other => panic!("{other:?}"),
    }
}

fn measure(random: &mut Random) -> Measure {
    let n = |random: &mut Random| Direction::from_array(random.vector(1.0));
    match random.below(11) {
        0 => Measure::OmegaBody(n(random)),
        1 => Measure::OmegaSpace(Direction::from_array(random.vector(1.0))),
        2 | 3 => Measure::Rate,
        4 => Measure::KineticEnergy,
        5 => Measure::Momentum,
        6 => Measure::Tilt { body: n(random), space: Direction::from_array(random.vector(1.0)).into() },
        7 => Measure::OmegaAngle(n(random)),
        8 => Measure::MomentumAngle(n(random)),
        9 => Measure::Nutation,
        _ => {
            if random.next() < 0.5 {
                Measure::Precession
            } else {
                Measure::Spin
            }
        }
    }
}

struct Case {
    seed: u64,
    rotor: Rotor,
    torques: Vec<TorqueModel>,
    start: State,
    events: Vec<Event>,
    /// Number of events. They are followed by the same number of twins that record, and of twins
    /// that record both directions.
    count: usize,
    off: Vec<usize>,
    end: f64,
}

impl Case {
    fn random(seed: u64) -> Self {
        let mut random = Random::new(seed);
        let numbers = Numbers::random(&mut random);
        let (rotor, torques, start) = (numbers.rotor(), numbers.torques(), numbers.start());
        let times: Vec<f64> = (0..=100).map(|k| numbers.duration * f64::from(k) / 100.0).collect();
        let plain = Simulation::new(&rotor, &torques, start, &times).run().unwrap();
        let samples = plain.samples();
        // Includes motions that reach half a turn of a torsion, as switches may change that.
        let end = numbers.duration;
        let count = 1 + random.below(4);
        let mut events = Vec::new();
        for _ in 0..count {
            let measure = measure(&mut random);
            let zero = Event::new("", measure.clone(), 1e-9, Sense::Either, EventAction::Record).unwrap();
            let values: Vec<f64> = samples
                .iter()
                .map(|sample| match measure {
                    Measure::Precession => sample.state.attitude.euler313()[0],
                    Measure::Spin => sample.state.attitude.euler313()[2],
                    _ => gap(&zero, &rotor, &sample.state).0 + 1e-9,
                })
                .collect();
            // Value at a time, or near the highest or lowest value, where it is crossed twice in
            // short succession.
            let most = |sign: f64| values.iter().map(|v| sign * v).fold(f64::NEG_INFINITY, f64::max) * sign;
            let range = most(1.0) - most(-1.0);
            let near = range * 10_f64.powf(random.between(-6.0, -1.0));
            let value = match random.below(8) {
                0 => most(1.0) - near,
                1 => most(-1.0) + near,
                _ => values[1 + random.below(values.len() - 2)],
            };
            let action = match random.below(10) {
                0 => EventAction::Stop,
                1..=5 if !torques.is_empty() => {
                    EventAction::Switch { torque: random.below(torques.len()), on: random.next() < 0.4 }
                }
                _ => EventAction::Record,
            };
            let sense = [Sense::Either, Sense::Either, Sense::Rising, Sense::Falling][random.below(4)];
            // A constant does not cross its value, and an angle must be between 0 and π.
            let (measure, value) = if range > 1e-6 { (measure, value) } else { (Measure::Time, 0.3 * end) };
            if Event::new("event", measure.clone(), value, sense, action).is_ok() {
                events.push((measure, value, sense, action));
            }
        }
        // Often an event of the same measure and value, with another sense or action.
        if random.next() < 0.3 && !torques.is_empty() && !events.is_empty() {
            let (measure, value, ..) = events[0].clone();
            let action = EventAction::Switch { torque: random.below(torques.len()), on: random.next() < 0.5 };
            let sense = [Sense::Either, Sense::Rising, Sense::Falling][random.below(3)];
            events.push((measure, value, sense, action));
        }
        let count = events.len();
        let record = EventAction::Record;
        let twins = events.clone().into_iter().map(|(m, v, sense, _)| (m, v, sense, record));
        let either = events.clone().into_iter().map(|(m, v, ..)| (m, v, Sense::Either, record));
        let all = events.into_iter().chain(twins.collect::<Vec<_>>()).chain(either.collect::<Vec<_>>());
        let events =
            all.map(|(m, v, sense, action)| Event::new("event", m, v, sense, action).unwrap()).collect();
        let off = (0..torques.len()).filter(|_| random.next() < 0.2).collect();
        Self { seed, rotor, torques, start, events, count, off, end }
    }

    fn run(&self, method: Method, times: &[f64]) -> Trajectory {
        let simulation = Simulation::new(&self.rotor, &self.torques, self.start, times);
        simulation
            .events(&self.events)
            .switched_off(&self.off)
            .method(method)
            .tolerance(TOLERANCE)
            .run()
            .unwrap()
    }

    fn gap(&self, event: usize, state: &State) -> (f64, f64, bool) {
        gap(&self.events[event], &self.rotor, state)
    }

    /// Returns the passages by event, then in the order of time.
    fn passages(&self, motion: &Trajectory) -> Vec<(usize, f64, bool)> {
        let mut found: Vec<_> =
            motion.events().iter().map(|it| (it.event, it.state.time, it.rising)).collect();
        found.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        found
    }

    /// Compares an event with its twin, and the twin of both directions with the signs of the
    /// measure.
    fn check_grid(&self, motion: &Trajectory, switches: &[f64]) {
        let passages = self.passages(motion);
        for event in 0..self.count {
            let of = |event: usize| passages.iter().filter(move |it| it.0 == event);
            let twin = event + 2 * self.count;
            let taken: Vec<f64> = of(event + self.count).map(|it| it.1).collect();
            let happened: Vec<f64> = of(event).map(|it| it.1).collect();
            assert_eq!(
                happened,
                taken,
                "scenario {}: event {event} and its twin, of {:?} {:?}",
                self.seed,
                self.events,
                motion.events()
            );
            let times: Vec<f64> = of(twin).map(|it| it.1).collect();
            let definite: Vec<(f64, f64, bool)> = motion
                .samples()
                .iter()
                .map(|sample| {
                    let (gap, scale, counts) = self.gap(twin, &sample.state);
                    (sample.state.time, if gap.abs() > 1e-11 * scale { gap } else { 0.0 }, counts)
                })
                .filter(|it| it.1 != 0.0)
                .collect();
            let inside = |a: f64, b: f64| times.iter().filter(|t| **t > a && **t <= b).count();
            for pair in definite.windows(2) {
                let [(a, left, counts), (b, right, also)] = *pair else { continue };
                // A switch may reverse the motion at the value.
                if !(counts && also) || switches.iter().any(|t| *t > a && *t <= b) {
                    continue;
                }
                let count = inside(a, b);
                let place = format!("scenario {}: event {event} between {a} and {b}: {count}", self.seed);
                assert_eq!(count % 2 == 1, left * right < 0.0, "{place}");
            }
            for three in definite.windows(3) {
                let [(a, left, counts), (m, middle, _), (b, right, also)] = *three else { continue };
                let [l, c, r] = [left, middle, right].map(|x| x * middle.signum());
                if !(counts && also && c < l && c < r) || switches.iter().any(|t| *t > a && *t <= b) {
                    continue;
                }
                // Parabola through three values.
                let [s1, s2] = [(c - l) / (m - a), (r - c) / (b - m)];
                let curvature = (s2 - s1) / (b - a);
                let slope = s1 + curvature * (m - a);
                let lowest = c - 0.25 * slope * slope / curvature;
                let sag = (l - c).max(r - c);
                let count = inside(a, b);
                let place = format!("scenario {}: event {event} near {m}: {count}", self.seed);
                assert!(count >= 2 || lowest > -0.1 * sag, "{place}");
                assert!(count < 2 || lowest < 0.1 * sag, "{place}");
            }
        }
    }
}

#[test]
fn methods_and_samples_agree_on_all_events_of_random_scenarios() {
    let mut total = [0; 4];
    for seed in scenarios() {
        let case = Case::random(seed);
        let taylor = case.run(Method::Taylor, &[case.end]);
        let switch = |event: usize| matches!(case.events[event].action(), EventAction::Switch { .. });
        let switches: Vec<f64> =
            taylor.events().iter().filter(|it| switch(it.event)).map(|it| it.state.time).collect();
        let mut grid: Vec<f64> = (0..=600).map(|k| case.end * f64::from(k) / 600.0).collect();
        for time in &switches {
            let beside = (0..13).map(|k| 10_f64.powf(-1.0 - 0.5 * f64::from(k)));
            grid.extend(beside.flat_map(|d| [time - d, time + d]).filter(|t| *t > 0.0 && *t < case.end));
        }
        grid.sort_by(f64::total_cmp);
        grid.dedup();
        let sampled = case.run(Method::Taylor, &grid);
        let known = [&sampled, &taylor].map(|motion| case.passages(motion));
        let is_same = known[0].len() == known[1].len()
            && known[0]
                .iter()
                .zip(&known[1])
                .all(|(a, b)| (a.0, a.2) == (b.0, b.2) && (a.1 - b.1).abs() < 1e-11);
        assert!(is_same, "scenario {seed}: {known:?}");
        case.check_grid(&sampled, &switches);

        let other = case.run(Method::Dop853, &[case.end]);
        let [a, b] = [&taylor, &other].map(|motion| case.passages(motion));
        let kinds =
            |passages: &[(usize, f64, bool)]| passages.iter().map(|it| (it.0, it.2)).collect::<Vec<_>>();
        assert_eq!(kinds(&a), kinds(&b), "scenario {seed}: {a:?} {b:?} {:?}", case.events);
        let mut doubtful: Vec<(f64, usize)> = Vec::new();
        for (a, b) in a.iter().zip(&b) {
            if (a.1 - b.1).abs() > 1e-9 {
                doubtful.push((b.1, b.0));
            }
        }
        doubtful.sort_by(|a, b| a.0.total_cmp(&b.0));
        let times: Vec<f64> = doubtful.iter().map(|it| it.0).filter(|t| *t <= case.end).collect();
        let there = case.run(Method::Taylor, &times);
        for (sample, (time, event)) in there.samples().iter().zip(&doubtful) {
            let (gap, scale, _) = case.gap(*event, &sample.state);
            assert!(gap.abs() < 1e-10 * scale, "scenario {seed}: event {event} at {time}: {gap:e}");
        }
        let ended = |motion: &Trajectory| match motion.ending() {
            Ending::Complete => (0, 0, case.end),
            Ending::Stopped { event, time } => (1, *event, *time),
            Ending::Failed { cause: MotionError::HalfTurn { .. }, time } => (2, 0, *time),
            Ending::Failed { cause: MotionError::Chatter { event, .. }, time } => (3, *event, *time),
            other => panic!("scenario {seed}: {other:?}"),
        };
        let [a, b] = [&taylor, &other].map(ended);
        assert!((a.0, a.1) == (b.0, b.1) && (a.2 - b.2).abs() < 1e-7, "scenario {seed}: {a:?} {b:?}");
        total[0] += taylor.events().len();
        total[1] += switches.len();
        total[2] += doubtful.len();
        total[3] += usize::from(a.0 >= 2);
    }
    let [passages, switches, doubtful, ended] = total;
    println!(
        "{passages} passages, {switches} of events that switch; {doubtful} times differ by more than 1e-9 s; {ended} motions end early"
    );
    let count = scenarios().count();
    assert!(count < 10 || passages > 3 * count && switches > count / 5, "{total:?}");
}
