//! Proposals of nearest possible tensors: `check --nearest`.

use polhode::body::InertiaTensor;
use polhode::math::Body;
use polhode_document::Report as _;
use polhode_robot::{Checked, Format, REPORT_SCHEMA, Request, run};
use polhode_source::files::Memory;
use serde_json::Value;

use crate::common::schema::require_fits;

/// Returns a model of one link, whose tensor has these elements in the order of URDF.
fn arm([ixx, ixy, ixz, iyy, iyz, izz]: [&str; 6]) -> String {
    format!(
        r#"<robot name="r"><link name="arm"><inertial><origin xyz="0.1 -0.2 0.3"/><mass value="1.7"/>
  <inertia ixx="{ixx}" ixy="{ixy}" ixz="{ixz}" iyy="{iyy}" iyz="{iyz}" izz="{izz}"/></inertial></link></robot>"#
    )
}

/// Returns the report as text, without line breaks.
fn words(text: [&str; 6]) -> String {
    let text = checked(&arm(text), true).to_form(Format::Text);
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn checked(model: &str, nearest: bool) -> Checked {
    let files = Memory::from([("arm.urdf", model)]);
    run(&Request { files: vec!["arm.urdf".into()], nearest, ..Request::default() }, &files).unwrap()
}

/// Returns the elements xx, yy, zz, xy, xz, yz and the distance.
fn proposed(nearest: &Value) -> ([f64; 6], f64) {
    let number = |name: &str| nearest[name].as_f64().unwrap_or_else(|| panic!("{name}: {nearest}"));
    (["ixx", "iyy", "izz", "ixy", "ixz", "iyz"].map(number), number("distance"))
}

const METRICS: [&str; 2] = ["frobenius", "affine_invariant"];

/// Tensors that violate the triangle inequality, as text; the last ones have principal axes of any
/// direction, few digits, and sizes far from 1.
const BROKEN: [[&str; 6]; 6] = [
    ["1", "0", "0", "1", "0", "3"],
    ["0.7123", "0.1", "-0.2", "1.1", "0.05", "2.61"],
    ["0.0301", "-0.011", "0.007", "0.0102", "-0.013", "0.0987"],
    ["2.3e-7", "1e-8", "0", "1.1e-7", "-3e-8", "9.4e-7"],
    ["310.5", "-12.25", "40.75", "415.125", "33.5", "1210.625"],
    ["1.00001", "0.333333", "0.1", "1.00003", "0.142857", "2.71828"],
];

#[test]
fn what_is_printed_is_possible_and_as_near_as_stated() {
    for text in BROKEN {
        let checked = checked(&arm(text), true);
        require_fits(REPORT_SCHEMA, &checked.to_json());
        let finding = &checked.to_json()["findings"][0];
        assert_eq!(finding["code"], "inertia.triangle");
        let [xx, xy, xz, yy, yz, zz] = text.map(|x| x.parse::<f64>().unwrap());
        let given = [xx, yy, zz, xy, xz, yz];
        let size = given.iter().fold(0.0, |max, x: &f64| f64::max(max, x.abs()));
        for metric in METRICS {
            let (tensor, distance) = proposed(&finding["nearest"][metric]);
            let [a, b, c, d, e, f] = tensor;
            InertiaTensor::<Body>::with_negative_products([a, b, c], [d, e, f]).unwrap();
            // Six digits: each element is off by at most 5e-6 (relative), or raised by as much.
            let rounded = |x: &f64| format!("{x:.5e}").parse::<f64>().unwrap() == *x;
            assert!(tensor.iter().all(rounded), "{tensor:?}");
            let change: f64 =
                (0..6).map(|k| (tensor[k] - given[k]).powi(2) * if k < 3 { 1.0 } else { 2.0 }).sum();
            if metric == "frobenius" {
                assert!((change.sqrt() - distance).abs() < 3e-5 * size, "{tensor:?} {distance}");
            } else {
                assert!(change.sqrt() > proposed(&finding["nearest"]["frobenius"]).1, "{tensor:?}");
            }
        }
    }
}

#[test]
fn every_format_has_the_proposals_only_if_requested() {
    let model = arm(BROKEN[1]);
    for form in [
        Format::Text,
        Format::Json,
        Format::Sarif,
        Format::Junit,
        Format::Github,
        Format::Gitlab,
        Format::Markdown,
        Format::Html,
    ] {
        let [with, without] = [true, false].map(|nearest| checked(&model, nearest).to_form(form));
        assert!(with.contains("nearest") && !without.contains("nearest"), "{form:?}: {with}");
        // The distance is part of each.
        assert!(with.contains("distance"), "{form:?}: {with}");
    }
    let text = words(BROKEN[1]);
    for line in [
        "nearest possible tensors: for the same mass and centre of mass; a fix, a measured or a computed tensor is better",
        "nearest possible tensor, Frobenius: ixx ",
        "nearest possible tensor, affine-invariant: ixx ",
        "kg·m², a flat body; distance ",
    ] {
        assert!(text.contains(line), "{line}: {text}");
    }
}

#[test]
fn the_verdict_and_the_identifier_stay() {
    let model = arm(BROKEN[2]);
    let [with, without] = [true, false].map(|nearest| checked(&model, nearest));
    assert!(with.has_failed() && without.has_failed());
    let mut object = with.to_json();
    object["findings"][0].as_object_mut().unwrap().remove("nearest").unwrap();
    assert_eq!(object, without.to_json());
}

#[test]
fn a_negative_moment_has_a_reason_instead_of_an_affine_invariant_neighbour() {
    let nearest = |text| checked(&arm(text), true).to_json()["findings"][0]["nearest"].clone();
    let found = nearest(["-0.31", "0.02", "0", "1.25", "0.3", "1.75"]);
    assert_eq!(found["affine_invariant"]["none"], "principal moment i1 is not positive");
    assert!(proposed(&found["frobenius"]).1 > 0.3);
    let found = nearest(["-1.31", "0.02", "0", "-1.25", "0.3", "1.75"]);
    assert_eq!(found["affine_invariant"]["none"], "principal moments i1 and i2 are not positive");
    let found = nearest(["1e-20", "0", "0", "1.25", "0", "3.5"]);
    assert_eq!(found["affine_invariant"]["none"], "principal moment i1 is zero within rounding");
    let text = words(["-1.5", "0", "0", "-1.25", "0", "-1.75"]);
    assert!(text.contains("ixx 0, iyy 0, izz 0, ixy 0, ixz 0, iyz 0 kg·m², a point"), "{text}");
    let text = words(["-1.5", "0", "0", "1.25", "0", "1.75"]);
    assert!(text.contains("ixx 0, iyy 1.5, izz 1.5, ixy 0, ixz 0, iyz 0 kg·m², a thin rod"), "{text}");
}

#[test]
fn a_tensor_with_an_unreadable_element_has_a_reason() {
    let found = checked(&arm(["1", "nan", "0", "1", "0", "3"]), true).to_json();
    let findings = found["findings"].as_array().unwrap();
    let finding = findings.iter().find(|finding| finding["code"] == "inertia.triangle").unwrap();
    for metric in METRICS {
        assert_eq!(finding["nearest"][metric]["none"], "an element of the tensor cannot be read");
    }
}
