//! Unphysical inertials: eleven test cases of which no other tool found all, and three from public
//! reports.

use crate::check_common::{SLAB, findings, findings_with, link, number, only, read, repaired, robot, solid};
use polhode_robot::finding::{Finding, Severity};
use polhode_robot::geometry::{Shapes, VolumeKind};
use polhode_robot::inspect::inspect;

const GOOD: [&str; 6] = ["0.0123", "0.0171", "0.0219", "-0.0011", "0.0007", "0.0013"];

fn with(k: usize, text: &'static str) -> String {
    let mut six = GOOD;
    six[k] = text;
    robot(&link("arm", "1.5", six))
}

#[test]
fn the_good_one_is_good() {
    assert_eq!(findings(&robot(&link("arm", "1.5", GOOD))), []);
}

#[test]
fn one_triangle() {
    let all = findings(&robot(&link("arm", "1.5", ["0.01", "0.01", "0.03", "0", "0", "0"])));
    let found = only(&all, "inertia.triangle");
    assert_eq!(found.severity, Severity::Impossible);
    assert!((number(found, "excess") - 0.01).abs() < 1e-15);
    assert!(found.message.contains("i1 + i2 = 0.02 < i3 = 0.03 kg·m² (by 0.01)"), "{}", found.message);
    // The same tensor, rotated: no single element shows the error.
    let [a, b, c] = [0.010, 0.012, 0.0305];
    let turned = crate::check_common::conjugated(
        &[[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]],
        &crate::check_common::turn([0.7, -0.4, 1.9]),
    );
    let all = findings(&SLAB.robot(crate::check_common::six(&turned)));
    assert!((number(only(&all, "inertia.triangle"), "excess") - 0.0085).abs() < 1e-8);
}

#[test]
fn two_not_positive() {
    // The diagonal looks right, but the products are too large for it.
    let all =
        findings(&robot(&link("arm", "1.5", ["0.0123", "0.0171", "0.0219", "0.0302", "0.0007", "0.0013"])));
    let found = only(&all, "inertia.negative");
    assert_eq!(found.severity, Severity::Impossible);
    // Condition det(I − λ 1) = 0 for the smallest root of the characteristic polynomial.
    let (xx, yy, zz, xy, xz, yz) = (0.0123, 0.0171, 0.0219, 0.0302, 0.0007, 0.0013);
    let l = number(found, "i1");
    let det = (xx - l) * ((yy - l) * (zz - l) - yz * yz) - xy * (xy * (zz - l) - yz * xz)
        + xz * (xy * yz - (yy - l) * xz);
    assert!(l < -0.015 && det.abs() < 1e-18, "{l} {det}");
    // A negative moment.
    let all = findings(&with(1, "-0.0171"));
    let found = only(&all, "inertia.negative");
    assert_eq!(found.severity, Severity::Impossible);
    assert!(number(found, "i1") < -0.017);
}

#[test]
fn nan_infinite_and_too_large() {
    for (text, why) in [("nan", "not a number"), ("inf", "too large"), ("1e400", "too large")] {
        for (k, name) in [(0, "ixx"), (4, "ixz")] {
            let document = with(k, text);
            let all = findings(&document);
            let found = only(&all, "number.not_finite");
            assert_eq!((found.severity, all.len()), (Severity::Impossible, 1));
            assert!(found.message.starts_with(name) && found.message.contains(why), "{}", found.message);
            assert_eq!(&document[found.span.clone()], text);
            assert_eq!(found.repair, None);
        }
    }
}

#[test]
fn a_negative_mass() {
    let all = findings(&robot(&link("arm", "-1", GOOD)));
    let found = only(&all, "mass.not_positive");
    assert_eq!((found.severity, all.len()), (Severity::Impossible, 1));
    assert_eq!(number(found, "mass"), -1.0);
}

#[test]
fn a_decimal_comma() {
    let document = robot(&link("arm", "0,5", GOOD));
    let all = findings(&document);
    let found = only(&all, "number.malformed");
    assert_eq!((found.severity, all.len()), (Severity::Impossible, 1));
    assert!(found.message.contains("decimal comma"), "{}", found.message);
    let fixed = repaired(&document, found);
    assert_eq!(fixed, document.replace("0,5", "0.5"));
    assert_eq!(findings(&fixed), []);
}

#[test]
fn a_unit() {
    let document = robot(&link("arm", "1kg", GOOD));
    let all = findings(&document);
    let found = only(&all, "number.malformed");
    assert_eq!((found.severity, all.len()), (Severity::Impossible, 1));
    assert!(found.message.contains("unit \"kg\""), "{}", found.message);
    assert_eq!(findings(&repaired(&document, found)), []);
}

#[test]
fn izz_is_missing() {
    let document = robot(&link("arm", "1.5", GOOD)).replace(" izz=\"0.0219\"", "");
    let all = findings(&document);
    let found = only(&all, "number.missing");
    assert_eq!((found.severity, all.len()), (Severity::Impossible, 1));
    assert!(found.message.contains("izz"), "{}", found.message);
}

#[test]
fn gram_millimetres_as_kilogram_metres() {
    // A link of 1.5 kg and the size of a hand, without geometry: 0.0123 kg·m² are 1.23e7 g·mm².
    let all = findings(&robot(&link("arm", "1.5", ["1.23e7", "1.71e7", "2.19e7", "-1.1e6", "7e5", "1.3e6"])));
    let found = only(&all, "inertia.unit");
    assert_eq!(found.severity, Severity::Suspect);
    assert!((number(found, "gyration_radius") - (number(found, "i3") / 1.5).sqrt()).abs() < 1e-9);
    assert!(number(found, "gyration_radius") > 3000.0);
    assert!(found.message.contains("g·mm²"), "{}", found.message);
    assert_eq!(found.repair, None);

    // With geometry the unit is proved and repaired.
    let document = SLAB.robot(SLAB.tensor().map(|x| x * 1e9));
    let all = findings_with(&document, SLAB.geometry());
    let found = only(&all, "inertia.unit");
    assert!(found.message.contains("g·mm² written as kg·m²"), "{}", found.message);
    let fixed = repaired(&document, found);
    assert_eq!(findings_with(&fixed, SLAB.geometry()), []);
}

/// Tensor from a public report: a missing decimal point.
const FORGOTTEN: [&str; 6] =
    ["2636.237E-6", "2328.164E-6", "1676359E-6", "-38.614E-6", "-162.037E-6", "-72.169E-6"];

/// Returns the geometry of a uniform body of 1.559 kg with the intended tensor.
fn meant() -> polhode_robot::check::LinkGeometry {
    let [xx, yy, zz, xy, xz, yz] =
        [2636.237, 2328.164, 1676.359, -38.614, -162.037, -72.169].map(|x| x * 1e-6 / 1.559);
    let per_mass = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    solid(8e-4, [0.0; 3], per_mass, [[-0.08; 3], [0.08; 3]], VolumeKind::Closed)
}

#[test]
fn a_power_of_ten_is_a_fix_if_the_geometry_confirms_it() {
    let document = robot(&link("Link1", "1.559", FORGOTTEN));
    let all = findings(&document);
    let found = only(&all, "inertia.triangle");
    assert_eq!((found.severity, all.len()), (Severity::Impossible, 1));
    assert!((number(found, "i1") + number(found, "i2") - 0.0049644).abs() < 5e-8);
    assert!((number(found, "i3") - 1.676359).abs() < 1e-7);
    assert!((number(found, "excess") - 1.6713946).abs() < 1e-6);
    assert_eq!(&document[found.span.clone()], "1676359E-6");
    // Without geometry it is a suggestion: a possible tensor is not necessarily right.
    assert_eq!(found.repair, None);
    for part in
        ["izz 1676359E-6 → 1676.359E-6 would make the tensor possible", "0.001641", "0.002335", "0.002665"]
    {
        assert!(found.message.contains(part), "{}", found.message);
    }
    let all = findings_with(&document, meant());
    let found = only(&all, "inertia.triangle");
    let fixed = repaired(&document, found);
    assert_eq!(fixed, document.replace("1676359E-6", "1676.359E-6"));
    assert_eq!(findings_with(&fixed, meant()), []);
    assert!(found.message.contains("izz: 1000 times too large"), "{}", found.message);
    // Geometry with a different tensor does not confirm it, even if it is close.
    for edges in [[1.0, 1.4, 2.0], [0.1, 0.12, 0.14]] {
        let other = crate::check_common::block(edges, VolumeKind::Primitives);
        let all = findings_with(&document, other);
        let found = only(&all, "inertia.triangle");
        assert_eq!(found.repair, None);
        assert!(!found.message.contains("would make"), "{}", found.message);
    }
    // If the radius of gyration exceeds the geometry, the message states both.
    let near = crate::check_common::block([0.1, 0.12, 0.14], VolumeKind::Primitives);
    let all = findings_with(&document, near);
    let found = only(&all, "inertia.triangle");
    assert!(found.message.contains("radius of gyration 1.037 m for 1.559 kg"), "{}", found.message);
}

#[test]
fn what_two_repairs_would_mend_has_none() {
    // A product that is too large: 10⁻², 10⁻³ and so on would all make it possible.
    let all = findings(&with(3, "1.1"));
    assert_eq!(only(&all, "inertia.negative").repair, None);
    // Several powers of ten of i3 are possible: equal moments leave two decades.
    let all = findings(&robot(&link("arm", "1.5", ["0.0123", "0.0123", "2.46", "0", "0", "0"])));
    assert_eq!(only(&all, "inertia.triangle").repair, None);
}

#[test]
fn the_iris_of_px4() {
    let all =
        findings(&robot(&link("base_link", "1.5", ["0.0347563", "0.0458929", "0.0977", "0", "0", "0"])));
    let found = only(&all, "inertia.triangle");
    assert_eq!((found.severity, all.len()), (Severity::Impossible, 1));
    assert!((number(found, "excess") - 0.0170508).abs() < 1e-15);
    assert!(
        found.message.contains("i1 + i2 = 0.0806492 < i3 = 0.0977 kg·m² (by 0.0170508)"),
        "{}",
        found.message
    );
    // No power of ten repairs it.
    assert_eq!(found.repair, None);
}

/// Tensor from a public report: right moments, conjugated quaternion.
const CONJUGATED: [f64; 6] = [0.268209, 0.359486, 0.225659, 0.011284, 0.0635697, -0.00106685];

#[test]
fn a_conjugated_attitude_is_found_by_the_geometry() {
    use polhode_robot::moments::Moments;
    let moments = Moments::of(&CONJUGATED);
    for (value, printed) in moments.values.iter().zip([0.179588555, 0.31243485, 0.361330595]) {
        assert!((value - printed).abs() < 6e-9);
    }
    // The body of 12 kg as a mesh of 0.015 m³.
    let (mass, volume) = (12.0, 0.015);
    let [xx, yy, zz, xy, xz, yz] = CONJUGATED.map(|x| x / mass);
    let per_mass = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let geometry = solid(volume, [0.01, 0.02, -0.03], per_mass, [[-0.4; 3], [0.4; 3]], VolumeKind::Closed);
    // The columns of R are the axes.
    let r = crate::check_common::transposed(&moments.axes);
    let rpy = |r: &crate::check_common::Matrix| {
        let angles = [r[2][1].atan2(r[2][2]), (-r[2][0]).asin(), r[1][0].atan2(r[0][0])];
        let back = crate::check_common::turn(angles);
        assert!(back.iter().flatten().zip(r.iter().flatten()).all(|(a, b)| (a - b).abs() < 1e-12));
        angles
    };
    let text = |r: &crate::check_common::Matrix| {
        let ([a, b, c], [x, y, z]) = (rpy(r), moments.values);
        robot(&format!(
            r#"<link name="body"><inertial><origin xyz="0.01 0.02 -0.03" rpy="{a} {b} {c}"/><mass value="{mass}"/>
<inertia ixx="{x}" ixy="0" ixz="0" iyy="{y}" iyz="0" izz="{z}"/></inertial></link>"#
        ))
    };
    assert_eq!(findings_with(&text(&r), geometry.clone()), []);
    let all = findings_with(&text(&crate::check_common::transposed(&r)), geometry);
    let found = only(&all, "inertia.conjugate");
    assert_eq!((found.severity, all.len()), (Severity::Suspect, 1));
    assert!(number(found, "misfit") > 0.1 && number(found, "misfit_repaired") < 1e-9, "{found:?}");
    assert!(found.message.contains("frame inverted"), "{}", found.message);
}

/// Returns all findings of a text, including the reader's notes.
fn inspected(text: &str) -> Vec<Finding> {
    inspect(&read(text), &Shapes::default()).findings
}

#[test]
fn a_mass_that_is_missing_hides_no_other_rule() {
    let triangle = robot(&link("arm", "1.5", ["0.01", "0.01", "0.03", "0", "0", "0"]));
    let negative = robot(&link("arm", "1.5", ["-0.01", "0.02", "0.03", "0", "0", "0"]));
    let masses = [
        (r#"<mass value="1.5"/>"#, "", "mass.missing"),
        ("1.5", "1,5", "number.malformed"),
        ("1.5", "-1.5", "mass.not_positive"),
        ("1.5", "0", "mass.not_positive"),
    ];
    for (old, new, code) in masses {
        for (document, rule) in [(&triangle, "inertia.triangle"), (&negative, "inertia.negative")] {
            let all = findings(&document.replacen(old, new, 1));
            let codes: Vec<_> = all.iter().map(|f| f.code).collect();
            assert!(codes.contains(&code) && codes.contains(&rule), "{new}: {codes:?}");
        }
    }
    // A missing product hides neither the triangle inequality nor the sign of the moments.
    for (document, rule) in [(&triangle, "inertia.triangle"), (&negative, "inertia.negative")] {
        let all = findings(&document.replace("ixy=\"0\" ", ""));
        only(&all, "number.missing");
        only(&all, rule);
    }
    // A possible tensor without mass is not reported as row-major.
    let all = findings(&robot(&link("arm", "", GOOD)));
    assert_eq!(all.iter().map(|f| f.code).collect::<Vec<_>>(), ["number.malformed"]);
}

#[test]
fn a_tensor_of_nine_numbers_is_symmetric() {
    let nine = |below: [&str; 3]| {
        let [yx, zx, zy] = below;
        let six = robot(&link("arm", "1.5", GOOD));
        six.replace("ixx=", &format!("iyx=\"{yx}\" izx=\"{zx}\" izy=\"{zy}\" ixx="))
    };
    assert_eq!(inspected(&nine(["-0.0011", "7e-4", "0.00130"])), []);
    for wrong in [["0.0011", "0.0007", "0.0013"], ["-0.0011", "0.0013", "0.0013"], ["-0.0011", "0.0007", "x"]]
    {
        let text = nine(wrong);
        let all = inspected(&text);
        let found = only(&all, "inertia.asymmetric");
        assert_eq!(found.severity, Severity::Suspect);
        assert!(wrong.contains(&&text[found.span.clone()]), "{found:?}");
    }
    let sdf = |extra: &str| {
        format!(
            "<sdf version='1.9'><model name='m'><link name='a'><inertial><mass>1.5</mass><inertia><ixx>0.0123</ixx>\
             <iyy>0.0171</iyy><izz>0.0219</izz>{extra}</inertia></inertial></link></model></sdf>"
        )
    };
    assert_eq!(inspected(&sdf("<ixy>0.001</ixy><iyx>0.001</iyx><izx>0</izx>")), []);
    only(&inspected(&sdf("<iyx>0.001</iyx>")), "inertia.asymmetric");
}

#[test]
fn what_is_written_beside_an_inertial_is_not_passed_over() {
    let good = robot(&link("arm", "1.5", GOOD));
    for (old, new, code) in [
        ("<mass value=\"1.5\"/>", "<mass value=\"1.5\"/><mass value=\"2\"/>", "read.twice"),
        ("<mass value=\"1.5\"/>", "<mass value=\"1.5\" unit=\"g\"/>", "read.unknown"),
        ("<inertial>", "<inertial><density value=\"2700\"/>", "read.unknown"),
        ("<inertial>", "<inertial><origin xyz=\"0 0 0.1\" quat=\"0 1 0 0\"/>", "read.unknown"),
        ("<inertia ", "<inertia iyyx=\"1\" unit=\"g mm^2\" ", "read.unknown"),
        ("</inertial>", "</inertial><inertial><mass value=\"2\"/></inertial>", "read.inertials"),
        ("</inertial>", "</inertial><mass value=\"2\"/>", "read.unknown"),
        ("<inertial>", "<Inertial/><inertial>", "read.unknown"),
        ("<inertial>", "<inertial><com xyz=\"0 0 1\"/>", "read.unknown"),
    ] {
        let all = inspected(&good.replacen(old, new, 1));
        assert!(all.iter().any(|f| f.code == code && f.severity == Severity::Suspect), "{new}: {all:#?}");
    }
    let mjcf = |attributes: &str| {
        format!(
            "<mujoco><worldbody><body name='a'><inertial pos='0 0 0.1' mass='1.5' {attributes}/></body></worldbody></mujoco>"
        )
    };
    assert_eq!(inspected(&mjcf("fullinertia='0.0123 0.0171 0.0219 -0.0011 0.0007 0.0013'")), []);
    let two = mjcf("fullinertia='0.0123 0.0171 0.0219 0 0 0' diaginertia='1 2 2.5'");
    only(&inspected(&two), "inertia.two_forms");
    only(&inspected(&mjcf("diaginertia='0.0123 0.0171 0.0219' inertia='1'")), "read.unknown");
}
