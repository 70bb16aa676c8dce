//! Centre of mass outside the link's geometry.

use polhode_robot::finding::{Finding, Severity};
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect;

use crate::check_common::{is_clean, number, only, read, repaired};

/// Returns a model with a moving link: its centre of mass, its tensor and its shapes.
fn link(center: &str, shapes: &str) -> String {
    format!(
        "<robot name=\"r\"><link name=\"root\"/><link name=\"a\"><inertial><origin xyz=\"{center}\"/><mass value=\"1.3\"/>\
         <inertia ixx=\"0.0021\" ixy=\"0\" ixz=\"0\" iyy=\"0.0023\" iyz=\"0\" izz=\"0.0012\"/></inertial>{shapes}</link>\
         <joint name=\"j\" type=\"continuous\"><parent link=\"root\"/><child link=\"a\"/><axis xyz=\"0 0 1\"/></joint></robot>"
    )
}

fn visual(pose: &str, shape: &str) -> String {
    format!("<visual><origin {pose}/><geometry>{shape}</geometry></visual>")
}

fn found(text: &str) -> Vec<Finding> {
    inspect(&read(text), &Shapes::default()).findings
}

fn distance(center: &str, shapes: &str) -> f64 {
    let all = found(&link(center, shapes));
    let one = only(&all, "mass.center_outside");
    assert_eq!(one.severity, Severity::Suspect);
    number(one, "distance")
}

#[test]
fn the_distance_is_that_of_a_face_an_edge_and_a_vertex() {
    let shape = visual("xyz=\"0.02 -0.03 0.04\"", "<box size=\"0.1 0.12 0.08\"/>");
    // The box ends at x = 0.07, y = 0.03, z = 0.08.
    for (center, expected) in [
        ("0.1025 -0.0414 0.0521", 0.0325),
        ("0.1 0.0700000001 0.0521", 0.05),
        ("0.09 0.06 0.14", 0.07),
        ("-0.0500001 -0.031 0.041", 0.0200001),
    ] {
        assert!((distance(center, &shape) - expected).abs() < 1e-9, "{center}");
    }
    for (center, expected) in [("0.02 -0.03 1e300", 1e300), ("-1e160 0 0", 1e160)] {
        assert!((distance(center, &shape) / expected - 1.0).abs() < 1e-9, "{center}");
    }
    for center in ["0.0695 0.0295 0.0795", "0.02 -0.03 0.04"] {
        assert!(is_clean(&found(&link(center, &shape))), "{center}: {:#?}", found(&link(center, &shape)));
    }
}

#[test]
fn the_hull_is_of_all_shapes() {
    // The centre may be between two balls, where nothing is drawn, but not outside the cone around
    // both.
    let balls = visual("xyz=\"-0.2 0 0\"", "<sphere radius=\"0.03\"/>")
        + &visual("xyz=\"0.2 0 0\"", "<sphere radius=\"0.06\"/>");
    let codes = |center: &str| found(&link(center, &balls)).into_iter().map(|f| f.code).collect::<Vec<_>>();
    assert!(!codes("0.01 0.02 0.03").contains(&"mass.center_outside"));
    // Distance from a common tangent of circles at (−0.2, 0), r = 0.03 and (0.2, 0), r = 0.06: n =
    // (−s, √(1 − s²)), s = (0.06 − 0.03) / 0.4; n·c − (n·(0.2, 0) + 0.06).
    let s: f64 = 0.03 / 0.4;
    let expected = -s * 0.01 + (1.0 - s * s).sqrt() * 0.1234567 - (-s * 0.2 + 0.06);
    assert!((distance("0.01 0.1234567 0", &balls) - expected).abs() < 1e-9);
    // A shape that cannot be measured may contain the centre.
    let missing = balls.clone() + &visual("xyz=\"0 0 0\"", "<mesh filename=\"nowhere.stl\"/>");
    assert!(!found(&link("0.01 0.1234567 0", &missing)).iter().any(|f| f.code == "mass.center_outside"));
}

#[test]
fn round_shapes_askew() {
    // A cylinder along (sin 0.5, 0, cos 0.5), and a capsule.
    let pose = "xyz=\"0.1 0.2 -0.1\" rpy=\"0 0.5 0\"";
    let (sin, cos) = 0.5_f64.sin_cos();
    // A point 0.03 beyond the rim along the axis and 0.04 across it, in the direction of y.
    let place =
        |along: f64, across: f64| format!("{} {} {}", 0.1 + sin * along, 0.2 + across, -0.1 + cos * along);
    let cylinder = visual(pose, "<cylinder radius=\"0.05\" length=\"0.3\"/>");
    assert!((distance(&place(0.15 + 0.03, 0.05 + 0.04), &cylinder) - 0.05).abs() < 1e-9);
    let capsule = visual(pose, "<capsule radius=\"0.05\" length=\"0.3\"/>");
    assert!((distance(&place(0.15 + 0.06, 0.08), &capsule) - 0.05).abs() < 1e-9);
}

#[test]
fn a_sign_and_a_unit_are_fixed() {
    let shape = visual("xyz=\"0.21 -0.13 0.34\" rpy=\"0.3 0.2 -0.4\"", "<box size=\"0.1 0.12 0.08\"/>");
    for (wrong, right) in [
        ("0.21 0.13 0.34", "0.21 -0.13 0.34"),
        ("-0.21 -0.13 -0.34", "0.21 -0.13 0.34"),
        ("210 -130 340", "0.210 -0.130 0.340"),
        ("0.21 -0.13 34", "0.21 -0.13 0.34"),
        ("0.21 0.34 -0.13", "0.21 -0.13 0.34"),
    ] {
        let text = link(wrong, &shape);
        let all = found(&text);
        let one = only(&all, "mass.center_outside");
        let fixed = repaired(&text, one);
        assert_eq!(fixed, link(right, &shape), "{one:#?}");
        assert!(!found(&fixed).iter().any(|f| f.code == "mass.center_outside"));
    }
    // Without an error that leads to the centroid, a fix is not offered.
    let all = found(&link("0.3 0.11 0.2", &shape));
    assert_eq!(only(&all, "mass.center_outside").repair, None);
}

#[test]
fn simplified_meshes_may_miss_the_centre_by_a_fiftieth_of_the_diagonal() {
    // The box ends at x = 0.07; its diagonal is 0.1755 m.
    let shape = visual("xyz=\"0.02 -0.03 0.04\"", "<box size=\"0.1 0.12 0.08\"/>");
    assert!(is_clean(&found(&link("0.0734 -0.031 0.041", &shape))));
    assert!((distance("0.0736 -0.031 0.041", &shape) - 0.0036).abs() < 1e-12);
}

/// Conversion from millimetres moves any point to the origin, so a centroid there does not confirm
/// it.
#[test]
fn a_centroid_at_the_origin_confirms_no_unit() {
    let shape = visual("xyz=\"0 0 0\"", "<box size=\"0.06 0.05 0.04\"/>");
    for center in ["-0.122993 0.035033383 0.02774", "0.1 0 0"] {
        assert_eq!(only(&found(&link(center, &shape)), "mass.center_outside").repair, None);
    }
}
