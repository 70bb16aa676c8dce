//! Links with the kinds of numbers found in real robots: none is impossible or suspect.

use crate::check_common::{SLAB, Slab, block, bounds, findings, findings_with, is_clean, link, only, robot};
use polhode_robot::check::LinkGeometry;
use polhode_robot::finding::Severity;
use polhode_robot::geometry::VolumeKind;

/// Asserts that a link with this geometry has only notes.
fn valid(why: &str, mass: &str, six: [&str; 6], geometry: LinkGeometry) {
    let all = findings_with(&robot(&link("part", mass, six)), geometry);
    assert!(is_clean(&all), "{why}: {all:#?}");
}

#[test]
fn links_of_real_kinds() {
    use VolumeKind::{Closed, Primitives};
    let none = LinkGeometry::default;
    for (why, mass, six, geometry) in [
        (
            "a forearm as a CAD program prints it",
            "1.219",
            ["0.0111069", "0.0110888", "0.0015721", "-2.5e-05", "-0.00011", "9.8e-06"],
            block([0.08, 0.09, 0.39], Closed),
        ),
        (
            "a shoulder of a cylinder, three digits",
            "3.70",
            ["0.0103", "0.0103", "0.00666", "0", "0", "0"],
            block([0.12, 0.12, 0.18], Closed),
        ),
        (
            "a wheel",
            "0.29",
            ["4.4e-4", "7.9e-4", "4.4e-4", "0", "0", "0"],
            block([0.11, 0.03, 0.11], Primitives),
        ),
        (
            "a thin plate, i1 + i2 = i3 and rounded upwards",
            "0.8",
            ["0.00123", "0.00235", "0.00359", "0", "0", "0"],
            none(),
        ),
        ("a plate with two digits", "0.8", ["0.00033", "0.00012", "0.00046", "0", "0", "0"], none()),
        (
            "a plate out of single precision, printed as double",
            "0.8",
            ["0.0012299999826121", "0.0023500000368803", "0.0035800001844764", "0", "0", "0"],
            none(),
        ),
        (
            "a small part of a file printed to six decimals",
            "0.004",
            ["0.000001", "0.000001", "0.000003", "0.000000", "0.000000", "0.000000"],
            block([0.05, 0.05, 0.003], Closed),
        ),
        ("a rod, without width", "0.12", ["0.0009", "0.0009", "0", "0", "0", "0"], none()),
        ("a rotor, all but a point", "0.02", ["1e-9", "1e-9", "2e-9", "0", "0", "0"], none()),
        (
            "a motor with a heavy core, drawn as a small cylinder",
            "0.55",
            ["0.00012", "0.00012", "0.00021", "0", "0", "0"],
            block([0.03, 0.03, 0.02], Primitives),
        ),
        (
            "a link in a crude box",
            "0.21",
            ["1.9e-4", "1.4e-4", "8e-5", "1e-6", "0", "-3e-6"],
            block([0.3, 0.3, 0.3], Primitives),
        ),
        (
            "a camera's dummy",
            "1e-3",
            ["1e-6", "1e-6", "1e-6", "0", "0", "0"],
            block([0.02, 0.02, 0.01], Primitives),
        ),
        (
            "a padded finger",
            "0.01",
            ["1e-4", "1e-4", "1e-4", "0", "0", "0"],
            block([0.01, 0.015, 0.04], Primitives),
        ),
        ("a hull of a ship", "180000", ["9e6", "8.7e7", "9.1e7", "0", "-1.2e6", "0"], none()),
        (
            "a torso, nine digits, all products",
            "9.042",
            ["0.128376442", "0.0912750107", "0.0719374281", "0.00215317", "-0.01082791", "0.00031415927"],
            block([0.22, 0.31, 0.38], Closed),
        ),
        (
            "a light wing of foam",
            "0.42",
            ["0.0411", "0.00152", "0.0425", "0.00011", "0", "0"],
            block([0.18, 1.08, 0.025], Closed),
        ),
        (
            "a hollow shell of a cover",
            "0.61",
            ["0.0021", "0.00174", "0.0029", "-0.0001", "0.0002", "0.00005"],
            bounds([0.01, 0.0, 0.03], 0.09),
        ),
        (
            "a dense tungsten ballast",
            "19.1",
            ["0.0318", "0.0318", "0.0318", "0", "0", "0"],
            block([0.1, 0.1, 0.1], Closed),
        ),
        (
            "what is taught for a hand's size",
            "0.1",
            ["1e-3", "1e-3", "1e-3", "0.0", "0.0", "0.0"],
            block([0.1, 0.1, 0.1], Primitives),
        ),
    ] {
        valid(why, mass, six, geometry);
    }
}

#[test]
fn a_slab_of_three_digits() {
    for digits in 2..8 {
        let texts = SLAB.tensor().map(|x| format!("{x:.*e}", digits));
        let text = SLAB.robot_of(&texts.each_ref().map(String::as_str));
        assert_eq!(findings_with(&text, SLAB.geometry()), [], "{digits}");
    }
}

/// Plates with arbitrary rotation and rounding. The true tensor has i1 + i2 = i3, and rounding
/// makes half of them violate i1 + i2 ≥ i3.
#[test]
fn rounded_plates_are_never_impossible() {
    let mut beyond = 0;
    for k in 0..2000_u32 {
        let angle = |n: u32| f64::from(k * n % 1009) / 160.0;
        let plate = Slab {
            mass: 0.3 + angle(7),
            edges: [0.1 + 0.05 * angle(11), 0.08 + 0.03 * angle(13), 0.0],
            attitude: [angle(3), angle(5), angle(17)],
            centre: [0.0; 3],
            frame: [0.0; 3],
        };
        let digits = 1 + (k % 6) as usize;
        let texts = plate.tensor().map(|x| format!("{x:.*e}", digits));
        let all = findings(&plate.robot_of(&texts.each_ref().map(String::as_str)));
        assert!(is_clean(&all), "{digits} digits: {all:#?} {plate:?} {texts:?}");
        beyond += usize::from(!all.is_empty());
    }
    assert!(beyond > 500, "rounding is felt: {beyond}");
}

/// Converse: a violation beyond the rounding of its own digits is impossible.
#[test]
fn what_rounding_cannot_explain_is_impossible() {
    let of = |izz: &'static str| {
        findings(&robot(&link("plate", "0.8", ["0.00123", "0.00235", izz, "0", "0", "0"])))
    };
    assert_eq!(of("0.00358"), []);
    assert_eq!(only(&of("0.00359"), "inertia.rounding").severity, Severity::Note);
    assert_eq!(only(&of("0.00360"), "inertia.triangle").severity, Severity::Impossible);
    // Each of the three numbers is off by at most 0.000005.
    let found = only(&of("0.00360"), "inertia.triangle").clone();
    assert!((crate::check_common::number(&found, "rounding") - 1.5e-5).abs() < 1e-8);
    // A number with one digit is typed, not rounded.
    only(&findings(&robot(&link("p", "1", ["1", "1", "3", "0", "0", "0"]))), "inertia.triangle");
    only(&findings(&robot(&link("p", "1", ["0.1", "0.2", "0.4", "0", "0", "0"]))), "inertia.triangle");
}

/// A file whose numbers are rounded to six decimals, without trailing zeros.
#[test]
fn a_file_that_is_cut_at_a_decimal() {
    let tips = link("tip", "0.004", ["1e-06", "0.000002", "0.000004", "0", "0", "0"]);
    let long: String = ["0.012346", "0.000131", "0.003219"]
        .iter()
        .enumerate()
        .map(|(k, x)| link(&format!("l{k}"), "1.2", [x, x, x, "0.000012", "-0.000003", "0.0"]))
        .collect();
    let joints: String = ["l1", "l2", "tip"]
        .iter()
        .map(|child| {
            format!("<joint name=\"j_{child}\" type=\"fixed\"><parent link=\"l0\"/><child link=\"{child}\"/></joint>")
        })
        .collect();
    let all = findings(&robot(&(long + &tips + &joints)));
    assert_eq!(only(&all, "inertia.rounding").severity, Severity::Note);
    assert!(is_clean(&all), "{all:#?}");
    // Without the other links, the same tensor counts as typed.
    only(&findings(&robot(&tips)), "inertia.triangle");
}

/// A complete arm in the style of an industrial robot: a base without inertia, links, a flange, a
/// tool frame.
#[test]
fn an_arm() {
    let links = [
        ("base_link", "4.0", ["0.00443333156", "0.00443333156", "0.0072", "0.0", "0.0", "0.0"]),
        ("shoulder_link", "3.7", ["0.010267495893", "0.010267495893", "0.00666", "0.0", "0.0", "0.0"]),
        ("upper_arm_link", "8.393", ["0.22689067591", "0.22689067591", "0.0151074", "0.0", "0.0", "0.0"]),
        ("forearm_link", "2.275", ["0.049443313556", "0.049443313556", "0.004095", "0.0", "0.0", "0.0"]),
        ("wrist_1_link", "1.219", ["0.111172755531", "0.111172755531", "0.21942", "0.0", "0.0", "0.0"]),
        ("wrist_3_link", "0.1879", ["0.0171364731454", "0.0171364731454", "0.033822", "0.0", "0.0", "0.0"]),
    ];
    let mut text: String = links.iter().map(|(name, mass, six)| link(name, mass, *six)).collect();
    text.push_str("<link name=\"world\"/><link name=\"tool0\"/>");
    let chain = [
        "world",
        "base_link",
        "shoulder_link",
        "upper_arm_link",
        "forearm_link",
        "wrist_1_link",
        "wrist_3_link",
        "tool0",
    ];
    for pair in chain.windows(2) {
        let kind = if pair[0] == "world" || pair[1] == "tool0" { "fixed" } else { "revolute" };
        text.push_str(&format!(
            "<joint name=\"j_{}\" type=\"{kind}\"><parent link=\"{}\"/><child link=\"{}\"/></joint>",
            pair[1], pair[0], pair[1]
        ));
    }
    assert_eq!(findings(&robot(&text)), []);
}
