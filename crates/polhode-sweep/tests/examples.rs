//! The plans of examples/sweeps: every one is read, its members are bodies, and one of them moves.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::fs;
use std::path::Path;

use polhode_sweep::Plan;

#[test]
fn every_plan_is_read_and_its_members_move() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/sweeps");
    let mut count = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let plan = Plan::read(&path).unwrap_or_else(|error| panic!("{error}"));
        assert!(plan.findings().is_empty(), "{}: {:?}", path.display(), plan.findings());
        for member in (0..plan.members()).step_by((plan.members() / 80).max(1) as usize) {
            let scenario = plan.scenario(&plan.values(member)).unwrap_or_else(|error| panic!("{error}"));
            if member == 0 {
                scenario.simulate().unwrap().unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            }
        }
        count += 1;
    }
    assert!(count >= 4, "{count}");
}
