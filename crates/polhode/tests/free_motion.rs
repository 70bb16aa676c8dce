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
        let error = if truth.norm() == 0.0 { state.omega.norm() } else { (state.omega - truth).norm() / truth.norm() };
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
        println!("{name:50} omega {:.1e} at {:.2e}   attitude {:.1e} at {:.2e}", omega.0, omega.1, attitude.0, attitude.1);
        if !(omega.0 <= 4e-15 && attitude.0 <= 4e-15) {
            failures.push(format!("{name}: omega {:e}, attitude {:e}", omega.0, attitude.0));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
