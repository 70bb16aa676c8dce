//! A counterpart with different numbers withdraws a fix; one that agrees keeps it.

use polhode_robot::finding::Finding;
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect;

use crate::check_common::{only, read, repaired};

const MASS: f64 = 1.3;

/// Visual and collision boxes of a link, of two sizes, so that each may explain different numbers.
const SEEN: [f64; 3] = [0.1, 0.13, 0.3];
const TOUCHED: [f64; 3] = [0.11, 0.14, 0.32];

fn moments([a, b, c]: [f64; 3]) -> [f64; 3] {
    [b * b + c * c, a * a + c * c, a * a + b * b].map(|x| MASS * x / 12.0)
}

/// Returns a link moved by a joint. On the right side its boxes are mirrored along y.
fn link(name: &str, mass: f64, center: [f64; 3], [xx, yy, zz]: [f64; 3]) -> String {
    let side = if name.contains("right") { -1.0 } else { 1.0 };
    let shape = |role: &str, [a, b, c]: [f64; 3]| {
        format!(
            "<{role}><origin xyz=\"0.02 {} 0.15\"/><geometry><box size=\"{a} {b} {c}\"/></geometry></{role}>",
            side * 0.04
        )
    };
    let [x, y, z] = center;
    format!(
        "<link name=\"{name}\"><inertial><origin xyz=\"{x} {} {z}\"/><mass value=\"{mass}\"/>\
         <inertia ixx=\"{xx:.12}\" ixy=\"0\" ixz=\"0\" iyy=\"{yy:.12}\" iyz=\"0\" izz=\"{zz:.12}\"/></inertial>{}{}</link>\
         <joint name=\"of_{name}\" type=\"continuous\"><parent link=\"root\"/><child link=\"{name}\"/><axis xyz=\"0 0 1\"/></joint>",
        side * y,
        shape("visual", SEEN),
        shape("collision", TOUCHED)
    )
}

fn robot(links: &[String]) -> String {
    format!("<robot name=\"r\"><link name=\"root\"/>{}</robot>", links.concat())
}

fn found(text: &str) -> Vec<Finding> {
    inspect(&read(text), &Shapes::default()).findings
}

const CENTER: [f64; 3] = [0.02, 0.04, 0.15];

/// Returns the moments of the collision box, with izz from x² + z² instead of x² + y².
fn slip() -> [f64; 3] {
    let [xx, yy, _] = moments(TOUCHED);
    [xx, yy, yy]
}

const NAMES: [[&str; 2]; 2] = [["arm_left", "arm_right"], ["arm_1", "arm_2"]];

#[test]
fn a_counterpart_with_other_numbers_withdraws_the_fix() {
    for [name, twin] in NAMES {
        let alone = found(&robot(&[link(name, MASS, CENTER, slip())]));
        assert!(only(&alone, "inertia.geometry").repair.is_some());
        // The other arm agrees with the visual box, so this arm may, too.
        let text = robot(&[link(name, MASS, CENTER, slip()), link(twin, MASS, CENTER, moments(SEEN))]);
        let both = found(&text);
        let slip = only(&both, "inertia.geometry");
        assert_eq!((slip.subject.as_str(), &slip.repair), (name, &None));
        assert!(
            slip.message.ends_with(&format!("its counterpart {twin} has different numbers")),
            "{}",
            slip.message
        );
    }
}

#[test]
fn a_counterpart_that_agrees_leaves_the_fix() {
    for [name, twin] in NAMES {
        let text = robot(&[link(name, MASS, CENTER, slip()), link(twin, MASS, CENTER, moments(TOUCHED))]);
        let fixed = repaired(&text, only(&found(&text), "inertia.geometry"));
        assert!(found(&fixed).iter().all(|f| f.code != "inertia.geometry"), "{fixed}");
    }
}

#[test]
fn what_is_no_counterpart_says_nothing() {
    let left = link("arm_left", MASS, CENTER, slip());
    for other in [
        // A different name, mass or shape, or the same error on both sides.
        link("leg_right", MASS, CENTER, moments(SEEN)),
        link("arm_right", 1.1 * MASS, CENTER, moments(SEEN)),
        link("arm_right", MASS, CENTER, moments(SEEN)).replace("0.14 0.32", "0.12 0.28"),
        link("arm_right", MASS, CENTER, slip()),
    ] {
        let both = found(&robot(&[left.clone(), other.clone()]));
        let slip = both.iter().find(|f| f.code == "inertia.geometry" && f.subject == "arm_left").unwrap();
        assert!(slip.repair.is_some(), "{other}: {slip:#?}");
    }
}

#[test]
fn a_centre_of_mass_is_compared_with_the_mirrored_one() {
    // The y coordinate has the wrong sign; the opposite sign agrees with the centroid. The right
    // arm agrees, or is 6 mm away.
    let wrong = [0.02, -0.04, 0.15];
    for (right, is_written) in [([0.02, 0.04, 0.15], true), ([0.02, 0.046, 0.15], false)] {
        let text = robot(&[
            link("arm_left", MASS, wrong, moments(TOUCHED)),
            link("arm_right", MASS, right, moments(TOUCHED)),
        ]);
        let all = found(&text);
        assert_eq!(only(&all, "mass.center_outside").repair.is_some(), is_written, "{all:#?}");
    }
}
