//! Rules that use the geometry, tested on a slab that is rotated and displaced, with a rotated
//! inertial frame.

use crate::check_common::*;
use polhode_robot::check::{LinkGeometry, check};
use polhode_robot::finding::{Finding, Severity};
use polhode_robot::geometry::VolumeKind;

/// Returns the only finding of a slab with these numbers, and the document.
fn one(slab: &Slab, tensor: [f64; 6], code: &str) -> (String, Finding) {
    let document = slab.robot(tensor);
    let all = findings_with(&document, slab.geometry());
    let found = only(&all, code).clone();
    assert_eq!(all.len(), 1, "{all:#?}");
    assert_eq!(found.severity, Severity::Suspect);
    (document, found)
}

/// Checks that the repair removes all findings and restores the right numbers.
fn repairs(document: &str, found: &Finding) {
    let fixed = repaired(document, found);
    assert_eq!(findings_with(&fixed, SLAB.geometry()), [], "{fixed}");
    let inertial = read(&fixed).links[0].inertial.clone().unwrap();
    let polhode_robot::model::Tensor::Six(slots) = inertial.tensor else { panic!("six numbers") };
    for (slot, right) in slots.iter().zip(SLAB.tensor()) {
        assert!((slot.finite().unwrap() - right).abs() < 1e-6 * SLAB.tensor()[0], "{fixed}");
    }
}

#[test]
fn the_right_tensor_has_no_finding() {
    assert_eq!(findings_with(&SLAB.robot(SLAB.tensor()), SLAB.geometry()), []);
    let [.., xy, xz, yz] = SLAB.tensor();
    for product in [xy, xz, yz] {
        assert!(product.abs() > 5e-4, "the point is generic: {:?}", SLAB.tensor());
    }
}

#[test]
fn a_body_that_is_not_uniform_has_none_either() {
    for factor in [0.35, 0.7, 1.4, 2.5] {
        let all = findings_with(&SLAB.robot(SLAB.tensor().map(|x| x * factor)), SLAB.geometry());
        assert!(all.is_empty(), "{factor}: {all:#?}");
    }
    // A different body in the same place.
    let other = Slab { edges: [0.12, 0.1, 0.2], attitude: [1.3, 0.3, -0.6], ..SLAB };
    assert_eq!(findings_with(&SLAB.robot(other.tensor()), SLAB.geometry()), []);
}

#[test]
fn units() {
    for (factor, name) in
        [(1e9, "g·mm²"), (1e6, "kg·mm²"), (1e7, "g·cm²"), (1e4, "kg·cm²"), (3_417.171_9, "lb·in²")]
    {
        let (document, found) = one(&SLAB, SLAB.tensor().map(|x| x * factor), "inertia.unit");
        assert!(found.message.contains(name), "{}", found.message);
        assert!((number(&found, "misfit") / factor - 1.0).abs() < 1e-3);
        repairs(&document, &found);
    }
    let (document, found) = one(&SLAB, SLAB.tensor().map(|x| x * 1e-6), "inertia.unit");
    assert!(found.message.contains("10^6 times too small"), "{}", found.message);
    repairs(&document, &found);
}

#[test]
fn a_unit_that_fits_by_size_alone_is_asked_and_not_repaired() {
    // Half the tensor, in g·mm²: the body is not uniform.
    let (_, found) = one(&SLAB, SLAB.tensor().map(|x| 0.5e9 * x), "inertia.unit");
    assert!(found.message.contains("g·mm²") && found.repair.is_none(), "{found:#?}");
}

#[test]
fn orders() {
    let [xx, yy, zz, xy, xz, yz] = SLAB.tensor();
    // The elements have the order xx yy zz xy xz yz; the places of URDF are xx xy xz yy yz zz.
    for (tensor, what) in [
        ([xx, xy, yz, yy, zz, xz], "xx yy zz xy xz yz written as xx xy xz yy yz zz"),
        ([xx, xy, xz, yy, yz, zz], "row-major"),
        ([xx, xz, zz, xy, yy, yz], "lower triangle"),
    ] {
        let document = SLAB.robot(tensor);
        let all = findings_with(&document, SLAB.geometry());
        let found = only(&all, "inertia.order");
        assert!(found.message.contains(what), "{}", found.message);
        assert!(all.iter().any(|f| f.severity == Severity::Impossible), "{all:#?}");
        repairs(&document, found);
        // It is also reported without geometry, if it is the only possible order.
        assert!(findings(&document).iter().any(|f| f.code == "inertia.order"), "{what}");
    }
    let (document, found) = one(&SLAB, [xx, yy, zz, xy, yz, xz], "inertia.order");
    assert!(found.message.contains("iyz and ixz swapped"), "{}", found.message);
    repairs(&document, &found);
}

#[test]
fn nine_numbers_cut_at_six() {
    let [xx, yy, _, xy, xz, yz] = SLAB.tensor();
    // The elements xx xy xz yx yy yz in the places xx xy xz yy yz zz, and in xx yy zz xy xz yz.
    for tensor in [[xx, xy, yz, xy, xz, yy], [xx, xy, xz, xy, yy, yz]] {
        let all = findings(&SLAB.robot(tensor));
        let found = only(&all, "inertia.order");
        assert!(found.message.contains("first six of nine"), "{}", found.message);
        assert!(found.repair.is_none());
        assert!(all.iter().any(|f| f.severity == Severity::Impossible));
    }
}

#[test]
fn moments_of_another_axis() {
    let geometry = block([0.05, 0.08, 0.4], VolumeKind::Primitives);
    let moment = |a: f64, b: f64| 0.9 * (a * a + b * b) / 12.0;
    let [x, y, z] = [moment(0.08, 0.4), moment(0.05, 0.4), moment(0.05, 0.08)].map(|i| format!("{i:.6}"));
    let right = robot(&link("bar", "0.9", [&x, &y, &z, "0", "0", "0"]));
    assert_eq!(findings_with(&right, geometry.clone()), []);
    let wrong = robot(&link("bar", "0.9", [&z, &y, &x, "0", "0", "0"]));
    let all = findings_with(&wrong, geometry.clone());
    let found = only(&all, "inertia.order");
    assert!(found.message.contains("ixx and izz swapped"), "{}", found.message);
    assert_eq!(repaired(&wrong, found), right);
}

#[test]
fn about_the_origin() {
    let parallel = {
        let [x, y, z] = SLAB.centre;
        let square = x * x + y * y + z * z;
        let about = [
            [square - x * x, -x * y, -x * z],
            [-x * y, square - y * y, -y * z],
            [-x * z, -y * z, square - z * z],
        ];
        six(&conjugated(&about, &transposed(&turn(SLAB.frame)))).map(|i| i * SLAB.mass)
    };
    let tensor: [f64; 6] = std::array::from_fn(|k| SLAB.tensor()[k] + parallel[k]);
    let (document, found) = one(&SLAB, tensor, "inertia.about_origin");
    assert!(found.message.contains("0.1487 m"), "{}", found.message);
    repairs(&document, &found);
    // If the file also omits the centre, the repair is ambiguous.
    let forgotten = Slab { centre: [0.0; 3], ..SLAB };
    let document = forgotten.robot(tensor);
    let all = findings_with(&document, SLAB.geometry());
    assert!(only(&all, "inertia.about_origin").repair.is_none());
}

#[test]
fn products_of_the_other_sign() {
    let [xx, yy, zz, xy, xz, yz] = SLAB.tensor();
    let (document, found) = one(&SLAB, [xx, yy, zz, -xy, -xz, -yz], "inertia.sign");
    assert!(found.message.contains("+∫xy dm"), "{}", found.message);
    repairs(&document, &found);
    let (document, found) = one(&SLAB, [xx, yy, zz, xy, -xz, -yz], "inertia.sign");
    assert!(found.message.contains("ixz and iyz"), "{}", found.message);
    repairs(&document, &found);
    // Small products, 2 % of the moments, printed with three digits.
    let slim = Slab { attitude: [0.02, -0.03, 0.025], frame: [0.0; 3], ..SLAB };
    let texts = slim.tensor().map(|x| format!("{x:.2e}"));
    let texts = texts.each_ref().map(String::as_str);
    assert_eq!(findings_with(&slim.robot_of(&texts), slim.geometry()), []);
    let mut wrong = slim.tensor();
    wrong[3..].iter_mut().for_each(|x| *x = -*x);
    let all = findings_with(&slim.robot(wrong), slim.geometry());
    assert!(only(&all, "inertia.sign").repair.is_some());
}

#[test]
fn products_of_the_other_sign_may_be_impossible() {
    // A flat rotated plate: its tensor has i1 + i2 = i3, and no other combination of signs is
    // possible.
    let plate = Slab { edges: [0.31, 0.19, 0.004], ..SLAB };
    let [xx, yy, zz, xy, xz, yz] = plate.tensor();
    assert_eq!(findings_with(&plate.robot(plate.tensor()), plate.geometry()), []);
    let document = plate.robot([xx, yy, zz, -xy, -xz, -yz]);
    let all = findings_with(&document, plate.geometry());
    assert!(all.iter().any(|f| f.severity == Severity::Impossible && f.repair.is_none()), "{all:#?}");
    let found = only(&all, "inertia.sign");
    assert_eq!(findings_with(&repaired(&document, found), plate.geometry()), []);
}

#[test]
fn a_conjugated_frame_and_one_left_over() {
    let link_axes = conjugated(&matrix(SLAB.tensor()), &turn(SLAB.frame));
    // The rotation Rᵀ would take this tensor to the link's axes.
    let conjugate = six(&conjugated(&link_axes, &turn(SLAB.frame)));
    let (_, found) = one(&SLAB, conjugate, "inertia.conjugate");
    assert!(found.message.contains("frame inverted"), "{}", found.message);
    let (_, found) = one(&SLAB, six(&link_axes), "inertia.conjugate");
    assert!(found.message.contains("along the link's axes"), "{}", found.message);
}

fn matrix([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> Matrix {
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

#[test]
fn gyration_beyond_the_geometry() {
    // Thirty times the tensor: not a unit, but too large for a body of this size.
    let tensor = SLAB.tensor().map(|x| x * 30.0);
    let (_, found) = one(&SLAB, tensor, "gyration.too_large");
    let [a, b, c] = SLAB.edges;
    // The largest moment of a slab is about its shortest edge.
    let k = (30.0 * (b * b + c * c) / 12.0_f64).sqrt();
    assert!((number(&found, "gyration_radius") - k).abs() < 1e-6 * k, "{found:?}");
    // `geometry()` bounds a ball around the slab: half a diagonal along each axis.
    let reach = 0.5 * (3.0 * (a * a + b * b + c * c)).sqrt();
    assert!((number(&found, "bound") / (1.1 * reach) - 1.0).abs() < 1e-12);
    assert!(found.repair.is_none());
    // Bounds without volume are sufficient.
    let all = findings_with(&SLAB.robot(tensor), bounds(SLAB.centre, 0.2));
    only(&all, "gyration.too_large");
}

#[test]
fn density() {
    let volume: f64 = SLAB.edges.iter().product();
    for (density, wrong) in [(9.0, true), (11.0, false), (24_000.0, false), (26_000.0, true)] {
        let slab = Slab { mass: density * volume, ..SLAB };
        let all = findings_with(&slab.robot(slab.tensor()), slab.geometry());
        assert_eq!(!all.is_empty(), wrong, "{density}: {all:#?}");
        if wrong {
            let found = only(&all, "density.implausible");
            assert!((number(found, "density") / density - 1.0).abs() < 1e-12);
            assert_eq!(found.severity, Severity::Suspect);
        }
    }
    // A rough collision box in addition to the mesh: one solid that agrees is enough.
    let slab = Slab { mass: 400.0 * volume, ..SLAB };
    let mut geometry = slab.geometry();
    geometry.volumes.insert(0, block([1.0, 1.1, 1.2], VolumeKind::Primitives).volumes[0].clone());
    assert_eq!(findings_with(&slab.robot(slab.tensor()), geometry), []);
    // A box around a light link is not a reason for a finding.
    let tensor = ["2e-4", "3e-4", "4e-4", "0", "0", "0"];
    let light = robot(&link("hand", "0.2", tensor));
    assert_eq!(findings_with(&light, block([0.3, 0.35, 0.4], VolumeKind::Primitives)), []);
}

#[test]
fn placeholders() {
    let identity = ["1.0", "1.0", "1.0", "0.0", "0.0", "0.0"];
    let document = robot(&link("cup", "0.4", identity));
    let all = findings_with(&document, block([0.1, 0.1, 0.12], VolumeKind::Closed));
    let found = only(&all, "inertia.placeholder");
    assert_eq!((found.severity, all.len()), (Severity::Suspect, 1));
    assert!(found.message.contains("1 kg·m² about each axis for 0.4 kg"), "{}", found.message);
    // Without evidence against it, it is a note; if the geometry agrees, it is not reported.
    let all = findings(&robot(&link("cup", "4", identity)));
    assert_eq!(only(&all, "inertia.placeholder").severity, Severity::Note);
    let metre = block([1.0, 1.0, 1.0], VolumeKind::Closed);
    assert_eq!(findings_with(&robot(&link("crate", "11", identity)), metre), []);
}

#[test]
fn one_tensor_for_links_that_differ() {
    let of = |name: &str, mass: &str, moment: &str| link(name, mass, [moment, moment, moment, "0", "0", "0"]);
    let joints = r#"<joint name="j1" type="fixed"><parent link="a"/><child link="b"/></joint>
<joint name="j2" type="fixed"><parent link="b"/><child link="c"/></joint>"#;
    let three = |moment: &str| {
        robot(&format!("{}{}{}{joints}", of("a", "5", moment), of("b", "1", moment), of("c", "0.6", moment)))
    };
    let all = findings(&three("0.1"));
    let found = only(&all, "inertia.placeholder");
    assert_eq!(found.severity, Severity::Suspect);
    assert_eq!(number(found, "links"), 3.0);
    assert!(found.message.contains("a, b, c"), "{}", found.message);
    // The value of tutorials for small links is a note; equal links are not reported.
    assert!(is_clean(&findings(&three("1e-3"))));
    assert_eq!(findings(&three("0.1").replace("\"5\"", "\"1\"").replace("\"0.6\"", "\"1\"")), []);
}

#[test]
fn no_geometry_is_no_finding() {
    let [xx, yy, zz, xy, xz, yz] = SLAB.tensor();
    assert_eq!(findings_with(&SLAB.robot([xx, yy, zz, -xy, -xz, -yz]), LinkGeometry::default()), []);
}

#[test]
fn nine_numbers_cut_at_six_may_have_no_products() {
    // The elements xx 0 0 0 yy 0 in the places xx xy xz yy yz zz.
    let all = findings(&robot(&link("bar", "0.9", ["0.0126", "0", "0", "0", "0", "0.0122"])));
    let found = only(&all, "inertia.order");
    assert!(found.message.contains("first six of nine"), "{}", found.message);
}

#[test]
fn a_placeholder_on_link_after_link_is_one_finding() {
    for (moment, reach) in [("0.01", 0.02), ("1e-3", 0.01), ("0.0001", 0.004)] {
        let names: Vec<String> = (0..40).map(|k| format!("finger{k}")).collect();
        let links: String =
            names.iter().map(|name| link(name, "0.2", [moment, moment, moment, "0", "0", "0"])).collect();
        let geometry: Vec<_> = names.iter().map(|_| bounds([0.0; 3], reach)).collect();
        let model = read(&robot(&links));
        let found = check(&model, &geometry);
        let found: Vec<_> = found.iter().filter(|f| !f.code.starts_with("tree")).collect();
        assert_eq!((found.len(), found[0].code), (1, "inertia.placeholder"), "{moment}: {found:#?}");
        assert_eq!((found[0].severity, number(found[0], "links")), (Severity::Suspect, 40.0));
        assert_eq!((&found[0].subject, &found[0].others), (&names[0], &names[1..].to_vec()));
        assert!(found[0].message.contains("finger0, finger1") && found[0].message.contains("and 28 more"));
    }
    // Two links are not enough for this finding: the error is reported for each, grouped.
    let two: String =
        ["a", "b"].iter().map(|n| link(n, "0.2", ["0.01", "0.01", "0.01", "0", "0", "0"])).collect();
    let found = check(&read(&robot(&two)), &[bounds([0.0; 3], 0.02), bounds([0.0; 3], 0.02)]);
    let both = only(&found, "gyration.too_large");
    assert_eq!((both.subject.as_str(), both.others.as_slice()), ("a", ["b".to_owned()].as_slice()));
}

#[test]
fn a_mesh_that_programs_turn_in_two_ways_accuses_no_axes() {
    let solids = |edges: [[f64; 3]; 2]| {
        let [a, b] = edges.map(|edges| block(edges, VolumeKind::Closed));
        LinkGeometry {
            volumes: [a.volumes, b.volumes].concat(),
            bounds: Some([[-0.2; 3], [0.2; 3]]),
            is_turned_by_some: true,
            ..LinkGeometry::default()
        }
    };
    let geometry = solids([[0.05, 0.08, 0.4], [0.05, 0.4, 0.08]]);
    let moment = |a: f64, b: f64| format!("{:.6}", 0.9 * (a * a + b * b) / 12.0);
    let [x, y, z] = [moment(0.08, 0.4), moment(0.05, 0.4), moment(0.05, 0.08)];
    // Both orientations are accepted, so other orders are not reported.
    for six in [[&x, &y, &z], [&x, &z, &y], [&z, &y, &x], [&y, &x, &z]] {
        let [a, b, c] = six.map(String::as_str);
        let all = findings_with(&robot(&link("bar", "0.9", [a, b, c, "0", "0", "0"])), geometry.clone());
        assert_eq!(all, []);
    }
    // A wrong unit does not depend on the axes: it is reported, but not repaired.
    let milli = |text: &str| format!("{}e9", text);
    let six = [&x, &z, &y].map(|text| milli(text));
    let wrong = robot(&link("bar", "0.9", [&six[0], &six[1], &six[2], "0", "0", "0"]));
    let all = findings_with(&wrong, geometry);
    assert!(only(&all, "inertia.unit").repair.is_none());
}
