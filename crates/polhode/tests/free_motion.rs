//! Free motion against 40-digit references, in every regime.

mod common;

use common::{cases, number, numbers, start, table};
use polhode::*;

/// What the worst row of a case is off by, and when.
#[derive(Default)]
struct Worst {
    omega: (f64, f64),
    attitude: (f64, f64),
}

fn worst_of(case: &toml::Table) -> Worst {
    let motion = FreeMotion::of_moments(numbers(&case["moments"]), start(case)).unwrap();
    let mut worst = Worst::default();
    for row in cases(case, "row") {
        let t = number(&row["t"]);
        let state = motion.at(t);
        let truth = AngularVelocity::<Body>::from_array(numbers(&row["omega"]));
        let error = if truth.norm() == 0.0 {
            state.omega.norm()
        } else {
            (state.omega - truth).norm() / truth.norm()
        };
        let turned = state.attitude.angle_to(common::attitude(&row["attitude"]));
        // NaN counts as worst
        if !(error <= worst.omega.0) {
            worst.omega = (error, t);
        }
        if !(turned <= worst.attitude.0) {
            worst.attitude = (turned, t);
        }
    }
    worst
}

#[test]
fn every_regime_follows_the_reference_for_a_thousand_million_periods() {
    let mut failures = Vec::new();
    for case in cases(&table("free_motion"), "case") {
        let name = case["name"].as_str().unwrap();
        let Worst { omega, attitude } = worst_of(case);
        println!(
            "{name:50} omega {:.1e} at {:.2e}   attitude {:.1e} at {:.2e}",
            omega.0, omega.1, attitude.0, attitude.1
        );
        if !(omega.0 <= 4e-15 && attitude.0 <= 4e-15) {
            failures.push(format!("{name}: omega {:e}, attitude {:e}", omega.0, attitude.0));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn many_states_have_the_bits_of_one() {
    for case in cases(&table("free_motion"), "case") {
        let motion = FreeMotion::of_moments(numbers(&case["moments"]), start(case)).unwrap();
        let unit = motion.period().unwrap_or(1.0);
        // 0 … 139: full blocks, full groups and rests, the start among them, and times without digits
        let times: Vec<f64> =
            (0..140).map(|k| unit * (f64::from(k) - 7.0) * 0.0917 * 3f64.powi(k / 10)).collect();
        let times: Vec<f64> = times.into_iter().chain([1e300, -f64::MAX, 1e40]).collect();
        for count in [0, 1, 15, 16, 17, 64, 80, 143] {
            let many = motion.at_times(&times[..count]);
            assert_eq!(many.len(), count);
            for (&time, state) in times.iter().zip(many) {
                assert_eq!(state, motion.at(time), "{} at {time}", case["name"].as_str().unwrap());
                assert!(
                    state.omega.is_finite()
                        && (state.attitude.quaternion().iter().map(|c| c * c).sum::<f64>() - 1.0).abs()
                            < 1e-15
                );
            }
        }
    }
}

#[test]
fn a_motion_starts_where_it_starts() {
    for case in cases(&table("free_motion"), "case") {
        for time in [0.0, -7.3, 1e9] {
            let start = State { time, ..start(case) };
            let motion = FreeMotion::of_moments(numbers(&case["moments"]), start).unwrap();
            assert_eq!(motion.at(time), start);
            // and next to it no jump
            let beside = motion.at(if time == 0.0 { f64::MIN_POSITIVE } else { time.next_up() });
            let step = (beside.time - time) * start.omega.norm();
            assert!(
                (beside.omega - start.omega).norm() <= (4e-15 + 4.0 * step) * start.omega.norm(),
                "{}",
                case["name"].as_str().unwrap()
            );
            assert!(
                beside.attitude.angle_to(start.attitude) <= 4e-15 + 1.1 * step,
                "{}",
                case["name"].as_str().unwrap()
            );
        }
    }
}

#[test]
fn many_bodies_have_the_bits_of_one() {
    let table = table("free_motion");
    let motions: Vec<_> = cases(&table, "case")
        .into_iter()
        .enumerate()
        .map(|(k, case)| {
            let start = State { time: if k % 3 == 0 { 12.5 } else { 0.1 * k as f64 }, ..start(case) };
            FreeMotion::of_moments(numbers(&case["moments"]), start).unwrap()
        })
        .collect();
    for count in [0, 1, 7, 8, 9, motions.len()] {
        let all = FreeMotions::of(&motions[..count]);
        assert_eq!((all.len(), all.is_empty()), (count, count == 0));
        for time in [12.5, -3.3e9, 0.1] {
            let states = all.at(time);
            assert_eq!(states.len(), count);
            for (motion, state) in motions.iter().zip(states) {
                assert_eq!(state, motion.at(time));
            }
        }
    }
}
