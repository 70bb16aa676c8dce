//! Mirrored pairs: products must change sign with the side.

use crate::check_common::{SLAB, Slab, findings, only, six, transposed, turn};
use polhode_robot::finding::{Finding, Severity};

/// Returns a URDF link with a tensor in link axes, written in a rotated inertial frame.
fn side(name: &str, centre: [f64; 3], tensor: [f64; 6], frame: [f64; 3]) -> String {
    let [xx, yy, zz, xy, xz, yz] = tensor;
    let matrix = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let [xx, yy, zz, xy, xz, yz] = six(&crate::check_common::conjugated(&matrix, &transposed(&turn(frame))));
    let ([x, y, z], [r, p, w]) = (centre, frame);
    format!(
        r#"<link name="{name}"><inertial><origin xyz="{x} {y} {z}" rpy="{r} {p} {w}"/><mass value="1.37"/>
<inertia ixx="{xx}" ixy="{xy}" ixz="{xz}" iyy="{yy}" iyz="{yz}" izz="{zz}"/></inertial></link>
"#
    )
}

/// Returns the findings for a left and a right link; the right one has these signs of its centre
/// and products.
fn pair(names: [&str; 2], centre: [f64; 3], products: [f64; 3]) -> Vec<Finding> {
    let left = Slab { frame: [0.0; 3], ..SLAB };
    let [xx, yy, zz, xy, xz, yz] = left.tensor();
    let [x, y, z] = left.centre;
    let there = [centre[0] * x, centre[1] * y, centre[2] * z];
    let mirrored = [xx, yy, zz, products[0] * xy, products[1] * xz, products[2] * yz];
    let text = format!(
        "<robot name=\"r\"><link name=\"torso\"/>{}{}{}{}</robot>",
        side(names[0], left.centre, left.tensor(), [0.2, 0.5, -0.9]),
        side(names[1], there, mirrored, [-0.7, 0.3, 1.1]),
        format_args!(
            "<joint name=\"jl\" type=\"revolute\"><parent link=\"torso\"/><child link=\"{}\"/></joint>",
            names[0]
        ),
        format_args!(
            "<joint name=\"jr\" type=\"revolute\"><parent link=\"torso\"/><child link=\"{}\"/></joint>",
            names[1]
        ),
    );
    findings(&text)
}

const HIPS: [&str; 2] = ["l_hip", "r_hip"];

#[test]
fn mirrored_products_are_no_finding() {
    assert_eq!(pair(HIPS, [1.0, -1.0, 1.0], [-1.0, 1.0, -1.0]), []);
    assert_eq!(pair(HIPS, [-1.0, 1.0, 1.0], [-1.0, -1.0, 1.0]), []);
    assert_eq!(pair(HIPS, [1.0, 1.0, -1.0], [1.0, -1.0, -1.0]), []);
    // A mirror image in a frame that is rotated by 180°: all three axes change sign.
    assert_eq!(pair(HIPS, [-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]), []);
}

#[test]
fn the_same_part_twice_is_no_finding() {
    assert_eq!(pair(HIPS, [1.0, 1.0, 1.0], [1.0, 1.0, 1.0]), []);
    // Rotated by 180° about z.
    assert_eq!(pair(HIPS, [-1.0, -1.0, 1.0], [1.0, -1.0, -1.0]), []);
}

#[test]
fn the_same_products_on_both_sides_are_one() {
    for names in [HIPS, ["LHip", "RHip"], ["FL_thigh", "FR_thigh"], ["left_arm_2", "right_arm_2"]] {
        let all = pair(names, [1.0, -1.0, 1.0], [1.0, 1.0, 1.0]);
        let found = only(&all, "inertia.mirrored_pair");
        assert_eq!((found.severity, found.subject.as_str(), all.len()), (Severity::Suspect, names[1], 1));
        assert!(found.message.contains("the same products"), "{}", found.message);
        for part in [names[0], names[1], "ixy", "iyz"] {
            assert!(found.message.contains(part), "{}", found.message);
        }
        assert!(!found.message.contains("ixz"), "ixz has no y: {}", found.message);
        assert!(found.repair.is_none());
    }
}

#[test]
fn so_are_those_mirrored_along_another_axis() {
    let all = pair(HIPS, [1.0, -1.0, 1.0], [-1.0, -1.0, 1.0]);
    assert!(only(&all, "inertia.mirrored_pair").message.contains("wrong sign"));
}

#[test]
fn other_names_are_no_pair() {
    assert_eq!(pair(["hip_1", "hip_2"], [1.0, -1.0, 1.0], [1.0, 1.0, 1.0]), []);
}

/// Centres in the mirror plane: the joints determine the plane.
#[test]
fn joints_show_the_mirror_where_centres_cannot() {
    let slab = Slab { frame: [0.0; 3], ..SLAB };
    let [xx, yy, zz, xy, xz, yz] = slab.tensor();
    let centre = [0.05, 0.0, -0.08];
    let text = |products: [f64; 3], y: f64, right: [f64; 3]| {
        let joint = |side: &str, y: f64| {
            format!(
                "<joint name=\"j{side}\" type=\"revolute\"><origin xyz=\"0.1 {y} 0.2\"/>\
                 <parent link=\"torso\"/><child link=\"{side}_hip\"/></joint>"
            )
        };
        format!(
            "<robot name=\"r\"><link name=\"torso\"/>{}{}{}{}</robot>",
            side("l_hip", centre, [xx, yy, zz, xy, xz, yz], [0.2, 0.5, -0.9]),
            side("r_hip", right, [xx, yy, zz, products[0], products[1], products[2]], [0.2, 0.5, -0.9]),
            joint("l", 0.15),
            joint("r", y)
        )
    };
    let all = findings(&text([xy, xz, yz], -0.15, centre));
    let found = only(&all, "inertia.mirrored_pair");
    assert!(found.message.contains("ixy") && found.message.contains("iyz"), "{}", found.message);
    assert_eq!(findings(&text([-xy, xz, -yz], -0.15, centre)), []);
    assert_eq!(findings(&text([xy, xz, yz], 0.35, centre)), []);
}
