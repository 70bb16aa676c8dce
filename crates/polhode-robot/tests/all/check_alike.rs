//! Grouped findings of links with the same error, and dummy links.

use crate::check_common::{block, findings, link, only, read, repaired, robot};
use polhode_robot::check::check;
use polhode_robot::finding::{Finding, Severity};
use polhode_robot::geometry::VolumeKind;

const TENSOR: [&str; 6] = ["0.0123", "0.0171", "0.0219", "0", "0", "0"];
/// Tensor of a box of 1.2 kg, 0.1 m × 0.2 m × 0.3 m, in kg·mm².
const IN_KG_MM2: [&str; 6] = ["13000", "10000", "5000", "0", "0", "0"];

fn joined(parent: &str, child: &str, kind: &str) -> String {
    format!(
        "<joint name=\"to_{child}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/></joint>"
    )
}

#[test]
fn the_same_part_is_one_finding_with_the_repairs_of_all() {
    let text = robot(
        &(link("a", "1.2", IN_KG_MM2)
            + &link("b", "1.2", IN_KG_MM2)
            + &link("c", "1.2", IN_KG_MM2)
            + &link("d", "1.3", IN_KG_MM2)
            + &joined("a", "b", "revolute")
            + &joined("b", "c", "revolute")
            + &joined("c", "d", "revolute")),
    );
    let geometry = vec![block([0.1, 0.2, 0.3], VolumeKind::Closed); 4];
    let found = check(&read(&text), &geometry);
    let units: Vec<&Finding> = found.iter().filter(|f| f.code == "inertia.unit").collect();
    // With a different mass, the message has different numbers.
    assert_eq!((units.len(), units[1].subject.as_str()), (2, "d"), "{found:#?}");
    assert_eq!(
        (units[0].subject.as_str(), units[0].others.as_slice()),
        ("a", ["b".to_owned(), "c".to_owned()].as_slice())
    );
    assert!(units[0].message.ends_with("; same in b, c"), "{}", units[0].message);
    let mended = check(&read(&repaired(&text, units[0])), &geometry);
    assert!(!mended.iter().any(|f| f.code == "inertia.unit" && f.subject != "d"), "{mended:#?}");
}

#[test]
fn what_is_impossible_is_said_of_each() {
    let bad = ["0.0123", "0.0171", "0.219", "0", "0", "0"];
    let text = robot(&(link("a", "1.2", bad) + &link("b", "1.2", bad) + &joined("a", "b", "fixed")));
    assert_eq!(findings(&text).iter().filter(|f| f.code == "inertia.triangle").count(), 2);
}

/// Returns the findings about an IMU with this mass and moment, next to a trunk of 0.02 kg·m². It
/// is drawn as a cube of 1 mm.
fn of_imu(mass: &str, moment: &str, kind: &str) -> Vec<Finding> {
    let imu = link("imu", mass, [moment, moment, moment, "0", "0", "0"]);
    let text = robot(&(link("trunk", "7", TENSOR) + &imu + &joined("trunk", "imu", kind)));
    let geometry =
        vec![block([0.3, 0.2, 0.1], VolumeKind::Primitives), block([1e-3; 3], VolumeKind::Primitives)];
    let found = check(&read(&text), &geometry);
    found.into_iter().filter(|f| f.subject == "imu").collect()
}

#[test]
fn a_dummy_is_worth_a_note() {
    let found = of_imu("0.001", "0.0001", "fixed");
    assert!(!found.is_empty() && found.iter().all(|f| f.severity == Severity::Note), "{found:#?}");
    // A dummy with a relevant moment, a larger mass, or a moving joint is not a note.
    for (mass, moment, kind) in
        [("0.001", "0.0012", "fixed"), ("0.011", "0.0001", "fixed"), ("0.001", "0.0001", "revolute")]
    {
        let found = of_imu(mass, moment, kind);
        assert!(found.iter().any(|f| f.severity == Severity::Suspect), "{mass} {moment} {kind}: {found:#?}");
    }
    assert_eq!(only(&of_imu("0.011", "0.0001", "fixed"), "density.implausible").severity, Severity::Suspect);
}
