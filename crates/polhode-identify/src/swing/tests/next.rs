//! Next test: predicted uncertainty, compared with plans that contain the test.

use super::statistics::{Noise, platform};
use crate::swing::*;

fn knowledge(plan: &SwingPlan) -> crate::NextExperiment<NextSwing> {
    let found = identify_swings(plan).unwrap();
    assert_eq!(found.widening, 1.0);
    next_swing(plan, &found).unwrap().unwrap()
}

#[test]
fn the_test_that_is_suggested_brings_what_is_said() {
    let mut noise = Noise::new(3, 1.0);
    let plan = platform().plan(&mut || noise.normal());
    let next = knowledge(&plan);
    assert_eq!(next.now.unknown, 0);
    assert!(next.refused.is_empty(), "{:?}", next.refused);
    for candidate in &next.candidates {
        let name = match &candidate.experiment {
            NextSwing::Test { test, .. } => &test.name,
            NextSwing::Number { name, .. } => name,
        };
        println!("{name}: {}", candidate.then.largest_sd);
    }
    println!("{:?}", next.now);
    let of_tests: Vec<_> = next
        .candidates
        .iter()
        .filter_map(|candidate| match &candidate.experiment {
            NextSwing::Test { test, .. } => Some((test, candidate.then.largest_sd)),
            NextSwing::Number { .. } => None,
        })
        .collect();
    assert_eq!(of_tests.len(), 13);
    let mut actual = Vec::new();
    for (test, said) in [of_tests[0], of_tests[6], of_tests[12]] {
        let mut more = plan.clone();
        more.add(test.clone());
        let sd = knowledge(&more).now.largest_sd;
        println!("{}: {} → {said} said, {sd} found", test.name, next.now.largest_sd);
        assert!((sd / said - 1.0).abs() < 0.02, "{}: {said} {sd}", test.name);
        actual.push(sd);
    }
    assert!(actual[0] < 0.99 * next.now.largest_sd, "{actual:?}");
    assert!(actual[0] <= actual[1] && actual[1] <= actual[2], "{actual:?}");
}

const Z: Placement = Placement::AS_IT_IS;

fn bifilar(radius_sd: f64) -> SwingPlan {
    let mut plan = SwingPlan::new(Measured::new(3.2, 0.001), [Measured::exact(0.0); 3]);
    let radius = plan.number("wire radius", "m", Measured::new(0.15, radius_sd));
    let length = plan.number("wire length", "m", Measured::new(1.2, 0.5e-3));
    let rig = Rig::Wires(Wires::bifilar(radius, radius, length));
    let swings = Measurement::Counted(Counted::new(50.0, (103.2, 0.05), [0.31, 0.26], 0.005));
    plan.add(SwingTest::new("about z", Z, rig, swings));
    plan
}

#[test]
fn after_one_axis_another_is_swung() {
    let next = knowledge(&bifilar(0.2e-3));
    assert_eq!(next.now.unknown, 5);
    let best = next.best().unwrap();
    assert_eq!(best.then.unknown, 4);
    // An axis at right angles gives most new information.
    match &best.experiment {
        NextSwing::Test { about, like, .. } => {
            assert!(about[2] == 0 && like == "about z", "{about:?} {like}");
        }
        other @ NextSwing::Number { .. } => panic!("{other:?}"),
    }
    // Five more tests determine everything.
    assert_eq!(next.together.len(), 5, "{:?}", next.together);
    let again =
        next.candidates.iter().find(|c| matches!(c.experiment, NextSwing::Test { about: [0, 0, 1], .. }));
    assert_eq!(again.unwrap().then.unknown, 5);
}

#[test]
fn a_number_that_is_measured_again_has_a_root_of_two_less_error() {
    let next = knowledge(&bifilar(3e-3));
    let again = next.candidates.iter().find(|candidate| match &candidate.experiment {
        NextSwing::Number { name, .. } => name == "wire radius",
        NextSwing::Test { .. } => false,
    });
    let said = again.unwrap().then.largest_sd;
    let sd = knowledge(&bifilar(3e-3 / 2.0_f64.sqrt())).now.largest_sd;
    assert!((sd / said - 1.0).abs() < 1e-3, "{said} {sd}");
    assert!(sd < 0.75 * next.now.largest_sd);
}
