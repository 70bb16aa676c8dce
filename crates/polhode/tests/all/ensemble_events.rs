//! Events of an ensemble's members are the same as for each member alone.

use std::num::NonZero;

use polhode::motion::{
    Ending, Ensemble, EnsembleStates, Event, EventAction, Measure, Member, MemberStop, Sense,
};
use polhode::prelude::*;

use super::ensemble::{every_torque, start};

const TIMES: [f64; 4] = [0.25, 0.5, 1.1, 2.5];

fn event(name: &str, measure: Measure, value: f64, action: EventAction) -> Event {
    Event::new(name, measure, value, Sense::Either, action).unwrap()
}

/// Events that most members cross sooner or later, once or often; every third member is stopped by
/// one.
fn events(k: usize) -> Vec<Event> {
    let action = if k.is_multiple_of(3) { EventAction::Stop } else { EventAction::Record };
    let along = Measure::OmegaBody(Direction::new(0.3, -0.5, 0.9));
    vec![
        event("rate", along, 1.08, action),
        event("nutation", Measure::Nutation, 1.1, EventAction::Record),
        event("time", Measure::Time, 0.7, EventAction::Record),
    ]
}

/// Returns one member under each torque; every fifth has no events.
fn members() -> Vec<Member> {
    let of = |(k, (_, rotor, torques))| {
        let member = Member::new(rotor, torques, start(k));
        if k % 5 == 4 { member } else { member.watching(events(k)) }
    };
    every_torque().into_iter().enumerate().map(of).collect()
}

fn at(members: &[Member], threads: usize) -> EnsembleStates {
    let threads = NonZero::new(threads).unwrap();
    Ensemble::new(members.to_vec()).unwrap().at(&TIMES, Method::Auto, 1e-11, threads).unwrap()
}

fn bits(states: &[State]) -> Vec<[u64; 8]> {
    states.iter().map(|state| <[f64; 8]>::from(*state).map(f64::to_bits)).collect()
}

#[test]
fn members_with_events_have_the_bits_of_a_run() {
    let members = members();
    let found = at(&members, 1);
    let mut counts = [0; 2];
    for (k, member) in members.iter().enumerate() {
        let simulation = Simulation::new(&member.rotor, &member.torques, member.start, &TIMES);
        let simulation = simulation.tolerance(1e-11).events(&member.events);
        let states = &found.states[4 * k..][..4];
        let happened = found.crossings.iter().filter(|happened| happened.member == k);
        let happened: Vec<_> = happened.map(|happened| happened.crossing.clone()).collect();
        if member.events.is_empty() {
            assert_eq!(bits(states), bits(&simulation.states().unwrap()));
            assert!(happened.is_empty());
            continue;
        }
        let motion = simulation.run().unwrap();
        let mut wanted: Vec<State> = motion.samples().iter().map(|sample| sample.state).collect();
        wanted.resize(4, *wanted.last().unwrap());
        assert_eq!(bits(states), bits(&wanted), "{k}");
        assert_eq!(happened, motion.events(), "{k}");
        let stop = found.stops.iter().find(|stop| stop.member == k).copied();
        let wanted = match *motion.ending() {
            Ending::Stopped { event, time } => Some(MemberStop { member: k, event, time }),
            _ => None,
        };
        assert_eq!(stop, wanted, "{k}");
        if let Some(stop) = stop {
            assert_eq!(states[3].time, stop.time);
        }
        counts = [counts[0] + happened.len(), counts[1] + usize::from(stop.is_some())];
    }
    assert!(found.failures.is_empty() && counts[0] > 30 && counts[1] > 2, "{counts:?}");
}

#[test]
fn neither_threads_nor_neighbours_change_them() {
    // More members than a thread takes at a time.
    let members: Vec<_> = (0..8).flat_map(|_| members()).collect();
    let (one, many) = (at(&members, 1), at(&members, 3));
    assert_eq!(bits(&one.states), bits(&many.states));
    assert_eq!((&one.stops, &one.crossings), (&many.stops, &many.crossings));
    let few = at(&members[3..7], 1);
    assert_eq!(bits(&few.states), bits(&one.states[12..28]));
    let of_few = one.crossings.iter().filter(|happened| (3..7).contains(&happened.member));
    assert!(of_few.map(|happened| &happened.crossing).eq(few.crossings.iter().map(|h| &h.crossing)));
}

/// A torque that is off until an event switches it on, together with members that it never turns.
#[test]
fn torques_are_switched() {
    let (_, rotor, torques) = every_torque().swap_remove(1);
    let on = EventAction::Switch { torque: 0, on: true };
    let off = Member::new(rotor, torques, start(2)).switched_off(vec![0]);
    let later = off.clone().watching(vec![event("on", Measure::Time, 0.75, on)]);
    let free = Member { torques: Vec::new(), switched_off: Vec::new(), ..off.clone() };
    let found = at(&[later.clone(), off, free], 1);
    let simulation = Simulation::new(&later.rotor, &later.torques, later.start, &TIMES);
    let motion = simulation.switched_off(&[0]).events(&later.events).tolerance(1e-11).run().unwrap();
    let wanted: Vec<State> = motion.samples().iter().map(|sample| sample.state).collect();
    assert_eq!(bits(&found.states[..4]), bits(&wanted));
    for k in 0..4 {
        let [later, off, free] = [0, 4, 8].map(|member| found.states[member + k].omega);
        assert!((off - free).norm() < 1e-10);
        assert_eq!((later - free).norm() > 1e-3, k > 1, "{k}");
    }
}

/// A function of many members is called for a single member where that member has events; it
/// receives the index.
#[test]
fn functions_of_many_members_have_events() {
    let law = |state: &State, member: usize| {
        let drag = state.omega.to_array().map(|rate| rate * (-0.1 - 0.02 * member as f64));
        Torque::<Body>::from_array(drag) + Torque::new(0.0, 0.1, 0.05 * state.time.cos())
    };
    let many = TorqueModel::vectorized_function("many", move |asked| {
        asked.iter().map(|one| law(&one.state, one.member)).collect()
    });
    let (_, rotor, _) = every_torque().swap_remove(0);
    let slow = |k: usize| event("slow", Measure::Rate, 1.33, [EventAction::Stop, EventAction::Record][k % 2]);
    let member = |k: usize, torque: TorqueModel| {
        let member = Member::new(rotor.clone(), vec![torque], start(k));
        if k == 4 { member } else { member.watching(vec![slow(k)]) }
    };
    let together: Vec<_> = (0..6).map(|k| member(k, many.clone())).collect();
    let alone = |k: usize| TorqueModel::function("one", move |_, state| law(state, k));
    let alone: Vec<_> = (0..6).map(|k| member(k, alone(k))).collect();
    let (found, wanted) = (at(&together, 2), at(&alone, 1));
    assert_eq!(bits(&found.states), bits(&wanted.states));
    assert_eq!((found.crossings, &found.stops), (wanted.crossings, &wanted.stops));
    assert_eq!(found.stops.iter().map(|stop| stop.member).collect::<Vec<_>>(), [0, 2]);
}

#[test]
fn an_event_that_cannot_be_measured_is_refused() {
    let (_, rotor, torques) = every_torque().swap_remove(5);
    let energy = event("energy", Measure::TotalEnergy, 1.0, EventAction::Record);
    let good = Member::new(rotor, torques, start(0));
    let refused = Ensemble::new(vec![good.clone(), good.watching(vec![energy])]).unwrap_err();
    assert_eq!((refused.member, &refused.cause), (1, &MotionError::NoPotential), "{refused}");
}

#[test]
fn progress_ends_the_work_within_a_member() {
    let (_, rotor, torques) = every_torque().swap_remove(6);
    let member = Member::new(rotor, torques, start(0)).watching(events(1));
    let ensemble = Ensemble::new(vec![member]).unwrap();
    let (mut rows, mut asked) = (vec![[0.0; 8]; 1], 0);
    let mut goes_on = |done| {
        asked += 1;
        assert_eq!(done, 0);
        asked < 5
    };
    let ended = ensemble.fill(&[1e4], (Method::Auto, 1e-11), NonZero::<usize>::MIN, &mut rows, &mut goes_on);
    assert_eq!((ended, asked), (Err(MotionError::Cancelled { done: 0 }), 5));
}
