//! Explanations, structure, names, joint values at rest, unphysical numbers, and refused requests.

use std::fs;
use std::path::{Path, PathBuf};

use polhode_document::Report as _;
use polhode_robot::Request as CheckRequest;
use polhode_robot::compare::{Comparison, REQUEST_SCHEMA, Request, run};
use polhode_source::Failure;
use polhode_source::files::Memory;
use serde_json::json;

use super::robots::{Frame, Part, Robot, Solid, robot, sum};
use super::{between, codes, compared, notes};
use crate::common::schema::require_fits;

fn messages(comparison: &Comparison) -> Vec<&str> {
    comparison.differences().map(|found| found.message.as_str()).collect()
}

/// Requires that a slip in a URDF or MJCF is explained by words.
fn require_explained(slip: impl Fn(&mut Robot), code: &str, words: &str) {
    for language in ["urdf", "xml"] {
        let mut slipped = robot();
        slip(&mut slipped);
        let comparison = between((&robot(), language), (&slipped, language));
        assert_eq!(codes(&comparison), [(code, "fore")], "{}", comparison.to_text(None));
        assert!(messages(&comparison)[0].contains(words), "{:?}", messages(&comparison));
    }
}

#[test]
fn a_slip_that_explains_a_difference_is_named() {
    require_explained(|r| r.solid("fore").mass *= 1e3, "compare.mass", "the mass in b.");
    require_explained(|r| r.solid("fore").mass /= 1e3, "compare.mass", "the mass in a.");
    let scale = |factor: f64| {
        move |r: &mut Robot| r.solid("fore").center = r.solid("fore").center.map(|c| factor * c)
    };
    require_explained(scale(1e3), "compare.center", " is in mm");
    require_explained(|r| r.solid("fore").center[0] *= -1.0, "compare.center", "x with the opposite sign");
    require_explained(|r| r.solid("fore").center.swap(1, 2), "compare.center", "y and z swapped");
    let tensor = |change: fn(&mut [[f64; 3]; 3])| move |r: &mut Robot| change(&mut r.solid("fore").tensor);
    require_explained(tensor(|t| *t = t.map(|row| row.map(|c| 1e9 * c))), "compare.tensor", " is in g·mm²");
    require_explained(
        tensor(|t| *t = t.map(|row| row.map(|c| 1.5 * c))),
        "compare.tensor",
        "all elements 1.5 times as large",
    );
    require_explained(
        tensor(|t| {
            for (i, j) in [(0, 1), (0, 2), (1, 2)] {
                (t[i][j], t[j][i]) = (-t[i][j], -t[j][i]);
            }
        }),
        "compare.tensor",
        "ixy, ixz and iyz with the opposite sign",
    );
    require_explained(
        tensor(|t| {
            let (xz, yz) = (t[0][2], t[1][2]);
            (t[0][2], t[2][0], t[1][2], t[2][1]) = (yz, yz, xz, xz);
        }),
        "compare.tensor",
        "iyz and ixz swapped",
    );
    // I_origin = I_c + m (c² 1 − c cᵀ)
    let about_origin = |r: &mut Robot| {
        let fore = r.solid("fore");
        let (m, c) = (fore.mass, fore.center);
        let square: f64 = c.iter().map(|x| x * x).sum();
        for (i, row) in fore.tensor.iter_mut().enumerate() {
            for (j, element) in row.iter_mut().enumerate() {
                *element += m * (if i == j { square } else { 0.0 } - c[i] * c[j]);
            }
        }
    };
    require_explained(about_origin, "compare.tensor", " is about the link's origin");
}

#[test]
fn what_two_slips_explain_is_not_explained() {
    // A diagonal tensor with two equal moments: swapped axes and swapped moments are the same.
    let arm = |values: &str| {
        format!(
            r#"<robot name="r"><link name="fore"><inertial><mass value="2"/><inertia {values}/></inertial></link></robot>"#
        )
    };
    let one = arm(r#"ixx="0.02" iyy="0.03" izz="0.04" ixy="0" ixz="0" iyz="0""#);
    let other = arm(r#"ixx="0.03" iyy="0.02" izz="0.04" ixy="0" ixz="0" iyz="0""#);
    let comparison = compared(["urdf", &one], ["urdf", &other], "1e-6");
    let message = messages(&comparison)[0];
    assert_eq!(
        message,
        "ixx 0.03 kg·m², in a.urdf 0.02 kg·m²; iyy 0.02 kg·m², in a.urdf 0.03 kg·m²: the tensor differs by 0.263 (relative)"
    );
}

#[test]
fn swapped_links_name_each_other() {
    let mut slipped = robot();
    let (one, other) = (*slipped.solid("fore"), *slipped.solid("finger"));
    (*slipped.solid("fore"), *slipped.solid("finger")) = (other, one);
    let comparison = between((&robot(), "sdf"), (&slipped, "xml"));
    assert_eq!(codes(&comparison), [("compare.link", "fore"), ("compare.link", "finger")]);
    assert_eq!(messages(&comparison)[0], "mass, centre and tensor are those of \"finger\" in a.sdf");
}

#[test]
fn mass_moved_between_links_is_told_from_mass_that_is_lost() {
    // 0.1 kg of the hand goes to the forearm, as a point at the hand's centre.
    let mut moved = robot();
    let hand = *moved.solid("hand");
    let place = moved.part("hand").pose;
    let fore = *moved.solid("fore");
    let at = place.point(hand.center);
    let mut lighter = moved.clone();
    lighter.solid("hand").mass -= 0.1;
    *moved.solid("fore") = sum(&[fore, Solid { mass: 0.1, center: at, tensor: [[0.0; 3]; 3] }]);
    moved.solid("hand").mass -= 0.1;
    let comparison = between((&robot(), "urdf"), (&moved, "xml"));
    assert!(
        codes(&comparison).iter().all(|(_, link)| ["fore", "hand"].contains(link)),
        "{:?}",
        codes(&comparison)
    );
    assert!(
        messages(&comparison)
            .iter()
            .all(|m| m.ends_with("; the sum of its rigid group agrees: moved between links"))
    );
    let comparison = between((&robot(), "urdf"), (&lighter, "xml"));
    assert_eq!(codes(&comparison), [("compare.mass", "hand")]);
    assert!(!messages(&comparison)[0].contains("agrees"));
    // From the finger to the rail, across the knuckle.
    let mut moved = robot();
    let (finger, rail, place) = (*moved.solid("finger"), *moved.solid("rail"), moved.part("finger").pose);
    let point = Solid { mass: 0.1, center: place.point(finger.center), tensor: [[0.0; 3]; 3] };
    *moved.solid("rail") = sum(&[rail, point]);
    moved.solid("finger").mass -= 0.1;
    let comparison = between((&robot(), "sdf"), (&moved, "usda"));
    let ending = "; the sum of the subtree below joint \"/robot/slide\" agrees: moved between links";
    assert!(
        messages(&comparison).iter().all(|message| message.ends_with(ending)),
        "{:?}",
        messages(&comparison)
    );
}

#[test]
fn structure_that_differs_is_reported_at_the_joint_or_the_link() {
    let mut fixed = robot();
    fixed.part("fore").joint.as_mut().unwrap().kind = "fixed";
    let comparison = between((&robot(), "urdf"), (&fixed, "xml"));
    assert_eq!(codes(&comparison), [("compare.link", "upper")], "{}", comparison.to_text(None));
    let message = messages(&comparison)[0];
    assert_eq!(
        message,
        "\"upper\" and \"fore\" are one rigid group in b.xml, but 2 in a.urdf, moved by \"elbow\""
    );
    let comparison = between((&fixed, "sdf"), (&robot(), "urdf"));
    assert_eq!(codes(&comparison), [("compare.link", "upper")], "{}", comparison.to_text(None));

    let mut slides = robot();
    slides.part("fore").joint.as_mut().unwrap().kind = "prismatic";
    let comparison = between((&robot(), "xml"), (&slides, "sdf"));
    assert_eq!(codes(&comparison), [("compare.joint", "elbow")]);
    assert_eq!(messages(&comparison), ["type prismatic, in a.xml revolute"]);

    // The rail hangs at the upper arm.
    let mut elsewhere = robot();
    elsewhere.part("rail").parent = Some(1);
    let comparison = between((&robot(), "urdf"), (&elsewhere, "sdf"));
    assert_eq!(codes(&comparison), [("compare.joint", "slide")], "{}", comparison.to_text(None));
    assert!(messages(&comparison)[0].contains("below \"upper\", in a.urdf"), "{:?}", messages(&comparison));

    // A link without mass properties; a link that is not there; frames without mass.
    let mut bare = robot();
    bare.part("finger").solid = None;
    let comparison = between((&robot(), "urdf"), (&bare, "urdf"));
    assert_eq!(codes(&comparison), [("compare.mass", "finger")]);
    assert_eq!(messages(&comparison), ["no mass, in a.urdf mass 0.24 kg"]);
    let mut less = robot();
    less.0.pop();
    let comparison = between((&robot(), "xml"), (&less, "sdf"));
    assert_eq!(codes(&comparison), [("compare.link", "finger")]);
    let mut framed = robot();
    let tool = Part { name: "tool".to_owned(), solid: None, parent: Some(3), ..framed.part("hand").clone() };
    framed.0.push(tool);
    framed.part("tool").joint.as_mut().unwrap().name = "mount".to_owned();
    let comparison = between((&robot(), "urdf"), (&framed, "xml"));
    assert_eq!(codes(&comparison), []);
    assert_eq!(
        notes(&comparison),
        [("compare.frame", "frame without mass and without a partner in a.urdf: tool")]
    );
}

#[test]
fn a_base_stands_anywhere_and_hangs_at_the_world_or_not() {
    let text = robot().written("xml");
    let base = "<body name=\"base\" pos=\"0e0 0e0 0e0\" quat=\"1e0 0e0 0e0 0e0\">";
    assert!(text.contains(base), "{text}");
    let moved = text.replace(base, "<body name=\"base\" pos=\"1 -2 0.7\" quat=\"0.6 0 0.8 0\">");
    let free = moved.replace("quat=\"0.6 0 0.8 0\">", "quat=\"0.6 0 0.8 0\"><freejoint name=\"root\"/>");
    for other in [&moved, &free] {
        for (language, own) in [("urdf", robot().written("urdf")), ("xml", text.clone())] {
            let comparison = compared([language, &own], ["xml", other], "1e-12");
            assert_eq!(codes(&comparison), [], "{}", comparison.to_text(None));
            let is_told = *other == free && language == "xml";
            assert_eq!(notes(&comparison).len(), usize::from(is_told), "{}", comparison.to_text(None));
        }
    }
    // A cart on a rail of the world, which URDF needs a link for.
    let cart = r#"<mujoco><worldbody><body name="cart" pos="0.3 0 1"><joint name="x" type="slide" axis="0.6 0.8 0"/>
        <inertial mass="2" pos="0.1 0.2 0.3" fullinertia="0.02 0.03 0.04 0.001 0.002 0.003"/></body></worldbody></mujoco>"#;
    let urdf = r#"<robot name="r"><link name="world"/><link name="cart"><inertial><origin xyz="0.1 0.2 0.3"/><mass value="2"/>
        <inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="0.001" ixz="0.002" iyz="0.003"/></inertial></link>
        <joint name="x" type="prismatic"><parent link="world"/><child link="cart"/><origin xyz="0.3 0 1"/><axis xyz="0.6 0.8 0"/></joint></robot>"#;
    let comparison = compared(["xml", cart], ["urdf", urdf], "1e-12");
    assert_eq!(codes(&comparison), [], "{}", comparison.to_text(None));
    // The rail has mass in the URDF, which a fused base loses.
    let rail = urdf.replace(
        "<link name=\"world\"/>",
        "<link name=\"world\"><inertial><mass value=\"3\"/><inertia ixx=\"0.2\" iyy=\"0.3\" izz=\"0.4\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>",
    );
    let comparison = compared(["urdf", &rail], ["xml", cart], "1e-12");
    assert_eq!(messages(&comparison), ["no mass, in a.urdf mass 3 kg (sum of \"world\")"]);
    let turned = cart.replace("0.6 0.8 0", "0.8 0.6 0");
    assert_eq!(codes(&compared(["xml", &turned], ["urdf", urdf], "1e-12")), [("compare.joint", "x")]);
}

#[test]
fn a_reference_value_is_the_zero_of_a_joint() {
    // ref: the body is drawn at joint value 0.7. URDF draws it at zero.
    let text = robot().written("xml");
    let at_rest = robot().rezeroed("upper", 0.7).written("xml");
    let at_rest = at_rest.replace("<joint name=\"shoulder\"", "<joint name=\"shoulder\" ref=\"0.7\"");
    let comparison = compared(["urdf", &robot().written("urdf")], ["xml", &at_rest], "1e-12");
    assert_eq!(codes(&comparison), []);
    assert!(notes(&comparison).is_empty(), "{:?}", notes(&comparison));
    let comparison =
        compared(["xml", &text], ["xml", &at_rest.replace("ref=\"0.7\"", "ref=\"0.9\"")], "1e-12");
    assert_eq!(codes(&comparison), []);
    assert!(notes(&comparison)[0].1.contains(" rad here"), "{:?}", notes(&comparison));
}

#[test]
fn joints_of_one_body_are_a_chain_of_frames() {
    let inertial = r#"<inertial mass="2" pos="0.1 0.2 0.3" fullinertia="0.02 0.03 0.04 0.001 0.002 0.003"/>"#;
    let mjcf = format!(
        r#"<mujoco><compiler angle="radian"/><worldbody><body name="base">{inertial}<body name="arm" pos="0.2 0.1 0.4">
        <joint name="pan" axis="0 0.6 0.8"/><joint name="tilt" axis="0.8 0.6 0"/>{inertial}</body></body></worldbody></mujoco>"#
    );
    let of_urdf = r#"<inertial><origin xyz="0.1 0.2 0.3"/><mass value="2"/>
        <inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="0.001" ixz="0.002" iyz="0.003"/></inertial>"#;
    let urdf = format!(
        r#"<robot name="r"><link name="base">{of_urdf}</link><link name="between"/><link name="arm">{of_urdf}</link>
        <joint name="pan" type="revolute"><parent link="base"/><child link="between"/><origin xyz="0.2 0.1 0.4"/><axis xyz="0 0.6 0.8"/></joint>
        <joint name="tilt" type="revolute"><parent link="between"/><child link="arm"/><axis xyz="0.8 0.6 0"/></joint></robot>"#
    );
    let comparison = compared(["xml", &mjcf], ["urdf", &urdf], "1e-12");
    assert_eq!(codes(&comparison), [], "{}", comparison.to_text(None));
    let swapped = mjcf.replace("pan", "x").replace("tilt", "pan").replace("\"x\"", "\"tilt\"");
    let comparison = compared(["xml", &swapped], ["urdf", &urdf], "1e-12");
    assert_eq!(codes(&comparison), [("compare.joint", "pan"), ("compare.joint", "tilt")]);
}

#[test]
fn a_fixed_model_differs_where_it_was_fixed() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/robots/bad-arm.urdf");
    let text = fs::read_to_string(file).unwrap();
    let files = Memory::from([("old.urdf", text.as_str())]);
    let request =
        CheckRequest { files: vec![PathBuf::from("old.urdf")], fix: true, ..CheckRequest::default() };
    let checked = polhode_robot::run(&request, &files).unwrap();
    let fixed = checked.fixes().next().unwrap().new.to_owned();
    let changed = text.lines().zip(fixed.lines()).enumerate().filter(|(_, (old, new))| old != new);
    let changed: Vec<u64> = changed.map(|(k, _)| u64::try_from(k + 1).unwrap()).collect();
    let comparison = compared(["urdf", &text], ["urdf", &fixed], "1e-6");
    assert!(comparison.has_failed());
    let report = comparison.to_json();
    let places: Vec<u64> =
        report["differences"].as_array().unwrap().iter().map(|d| d["b"]["line"].as_u64().unwrap()).collect();
    assert!(
        !places.is_empty() && places.iter().all(|line| changed.contains(line)),
        "{places:?} {changed:?}\n{}",
        comparison.to_text(None)
    );
    // The mass "1,2" became "1.2".
    assert!(
        messages(&comparison).contains(&"the mass cannot be read in a.urdf"),
        "{:?}",
        messages(&comparison)
    );
    assert!(compared(["urdf", &fixed], ["urdf", &fixed], "1e-6").is_equal());
}

#[test]
fn impossible_numbers_are_compared_as_written() {
    let arm = |izz: &str, mass: &str| {
        format!(
            r#"<robot name="r"><link name="arm"><inertial><mass value="{mass}"/>
            <inertia ixx="0.01" iyy="0.02" izz="{izz}" ixy="0.001" ixz="0" iyz="0"/></inertial></link></robot>"#
        )
    };
    let bad = arm("5", "-1");
    assert!(compared(["urdf", &bad], ["urdf", &bad], "1e-6").is_equal());
    assert_eq!(
        codes(&compared(["urdf", &bad], ["urdf", &arm("5.1", "-1")], "1e-6")),
        [("compare.tensor", "arm")]
    );
    assert_eq!(codes(&compared(["urdf", &bad], ["urdf", &arm("5", "1")], "1e-6")), [("compare.mass", "arm")]);
    // The limit of the tolerance is sharp.
    let one = arm("0.03", "2");
    assert!(compared(["urdf", &one], ["urdf", &arm("0.03", "2.0000019")], "1e-6").is_equal());
    assert!(!compared(["urdf", &one], ["urdf", &arm("0.03", "2.0000021")], "1e-6").is_equal());
}

fn failure(a: &str, b: &str, map: Option<&str>) -> Failure {
    let files = Memory::from([("a.urdf", a), ("b.urdf", b), ("map.toml", map.unwrap_or(""))]);
    let map = map.map(|_| "map.toml".into());
    run(&Request { a: "a.urdf".into(), b: "b.urdf".into(), map, ..Request::default() }, &files).unwrap_err()
}

#[test]
fn names_are_mapped_by_a_file() {
    let mut renamed = robot();
    renamed.part("fore").name = "forearm".to_owned();
    renamed.part("finger").joint.as_mut().unwrap().name = "mcp".to_owned();
    renamed.part("finger").name = "digit".to_owned();
    let (a, b) = (robot().written("urdf"), renamed.written("urdf"));
    let comparison = compared(["urdf", &a], ["urdf", &b], "1e-12");
    // The forearm is found by its joint, but is another link; the finger is not found.
    assert!(!comparison.is_equal());
    let map = "[links]\n\"fore\" = \"forearm\"\n\"finger\" = \"digit\"\n[joints]\nknuckle = \"mcp\"\n";
    let files = Memory::from([("a.urdf", a.as_str()), ("b.urdf", b.as_str()), ("map.toml", map)]);
    let request = |map: &str| Request {
        a: "a.urdf".into(),
        b: "b.urdf".into(),
        map: Some(map.into()),
        ..Request::default()
    };
    let comparison = run(&request("map.toml"), &files).unwrap();
    assert_eq!(codes(&comparison), [], "{}", comparison.to_text(None));
    assert!(notes(&comparison).is_empty(), "{:?}", notes(&comparison));

    let says = |map: &str, line: usize, words: &str, hint: &str| {
        let failure = failure(&a, &b, Some(map));
        let text = failure.to_string();
        assert!(failure.message().contains(words), "{text}");
        assert!(text.contains(&format!("map.toml:{line}:")) && text.contains(hint), "{text}");
    };
    says("[links]\nforre = \"forearm\"\n", 2, "\"forre\"", "did you mean \"fore\"?");
    says("[links]\nfore = \"forarm\"\n", 2, "\"forarm\"", "did you mean \"forearm\"?");
    says("[links]\nfore = \"forearm\"\nhand = \"forearm\"\n", 3, "twice", "delete one of the two lines");
    says("[link]\nfore = \"forearm\"\n", 1, "link", "did you mean [links]?");
    says("[joints]\nknuckle = 3\n", 2, "a name", "in quotes");
    says("[links]\nfore \"forearm\"\n", 2, "TOML", "[links]");
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let (plain, other) = (robot().written("urdf"), "<robot name=\"r\"><link name=\"x\"/></robot>");
    let failed = failure(&plain, other, None);
    assert!(failed.message().contains("has a partner in b.urdf"), "{failed}");
    assert!(failure(&plain, "<robot>", None).to_string().contains("b.urdf"));
    let loop_closed = plain.replace("</robot>", "<joint name=\"loop\" type=\"revolute\"><parent link=\"hand\"/><child link=\"rail\"/></joint></robot>");
    assert!(failure(&plain, &loop_closed, None).to_string().contains("two parents"));
    let no_axis = plain.replace("<axis xyz=\"6e-1 6.4e-1 -4.8e-1\"/>", "<axis xyz=\"0 0 0\"/>");
    assert!(failure(&plain, &no_axis, None).to_string().contains("\"elbow\""));
    // A mass that both files state in a form that cannot be read.
    let comma = plain.replace("<mass value=\"9e-1\"/>", "<mass value=\"0,9\"/>");
    assert_ne!(comma, plain);
    let text = failure(&comma, &comma, None).to_string();
    assert!(text.contains("\"fore\"") && text.contains("\"0,9\""), "{text}");
}

#[test]
fn a_request_has_its_schema() {
    let full =
        json!({ "a": "a.urdf", "b": "b.xml", "tolerance": "1e-4", "map": "names.toml", "root": ["src"] });
    require_fits(REQUEST_SCHEMA, &full);
    let request: Request = serde_json::from_value(full.clone()).unwrap();
    assert_eq!(request.tolerance(), 1e-4);
    assert_eq!(serde_json::to_value(&request).unwrap(), full);
    for wrong in ["0", "-1e-6", "nan", "inf", "1 mm"] {
        assert!(serde_json::from_value::<Request>(json!({ "tolerance": wrong })).is_err(), "{wrong}");
    }
    assert_eq!(Request::default().tolerance(), 1e-6);
}

#[test]
fn an_axis_that_moves_without_its_link_is_a_joint_difference() {
    for (language, other) in [("xml", "urdf"), ("sdf", "usda"), ("usda", "xml")] {
        let mut slipped = robot();
        slipped.part("fore").joint.as_mut().unwrap().anchor = [1e-3, 0.0, 0.0];
        let comparison = between((&robot(), other), (&slipped, language));
        assert_eq!(codes(&comparison), [("compare.joint", "elbow")], "{}", comparison.to_text(None));
        // The distance of a point 1 mm along x from an axis with x component 0.6 is 0.8 mm.
        assert!(messages(&comparison)[0].contains(": 0.8 mm apart"), "{:?}", messages(&comparison));
        let mut slipped = robot();
        slipped.part("rail").joint.as_mut().unwrap().axis = [-0.48, 0.64, 0.6];
        let comparison = between((&robot(), other), (&slipped, language));
        assert_eq!(codes(&comparison), [("compare.joint", "slide")], "{}", comparison.to_text(None));
        // cos φ = 0.48² + 2 · 0.6 · 0.64
        assert!(messages(&comparison)[0].contains(": 3.242° apart"), "{:?}", messages(&comparison));
    }
}

/// Returns the robot whose finger has its centre of mass on the axis of the knuckle.
fn on_axis() -> Robot {
    let mut robot = robot();
    robot.solid("finger").center = [0.0, 0.08, 0.06];
    robot
}

#[test]
fn a_tensor_alone_determines_no_zero() {
    // Half a turn about the axis of a link with its centre on the axis, and about z the wrong sign
    // of two products: only the tensor changes.
    let mut turned = on_axis();
    let axis = turned.part("finger").joint.as_ref().unwrap().axis;
    for angle in [std::f64::consts::PI, 0.9] {
        turned.solid("finger").tensor = {
            let r = crate::common::matrix_about_axis(axis, angle);
            let t = on_axis().solid("finger").tensor;
            let transposed = std::array::from_fn(|i| std::array::from_fn(|j| r[j][i]));
            crate::common::times(crate::common::times(r, t), transposed)
        };
        for language in ["urdf", "usda"] {
            let comparison = between((&on_axis(), "sdf"), (&turned, language));
            assert_eq!(codes(&comparison), [("compare.tensor", "finger")], "{}", comparison.to_text(None));
            assert!(notes(&comparison).is_empty(), "{:?}", notes(&comparison));
        }
    }
}

#[test]
fn geometry_determines_a_zero_that_the_centre_does_not() {
    let shape = |text: String| {
        let visual = "<visual><origin xyz=\"0.02 0.05 -0.01\" rpy=\"0.1 0.2 0.3\"/><geometry><box size=\"0.1 0.2 0.3\"/></geometry></visual>";
        text.replace("<link name=\"finger\">", &format!("<link name=\"finger\">{visual}"))
    };
    let (plain, moved) = (on_axis().written("urdf"), on_axis().rezeroed("finger", 0.35).written("urdf"));
    let comparison = compared(["urdf", &shape(plain.clone())], ["urdf", &shape(moved.clone())], "1e-12");
    // The frame of the link moved with everything in it: only the zero differs.
    assert_eq!(codes(&comparison), [], "{}", comparison.to_text(None));
    assert_eq!(notes(&comparison), [("compare.zero", "its zero differs: 0 in a.urdf is -0.35 rad here")]);
    // Without geometry, the tensor differs.
    assert_eq!(codes(&compared(["urdf", &plain], ["urdf", &moved], "1e-12")), [("compare.tensor", "finger")]);
}

#[test]
fn rounded_numbers_agree_within_their_digits() {
    let rounded = |robot: &Robot, language: &str| robot.rounded(6).written(language);
    let zeros = robot().rezeroed("upper", 0.7).rezeroed("fore", -1.3);
    for (a, b) in [("urdf", "sdf"), ("sdf", "xml"), ("urdf", "urdf")] {
        for other in [robot(), robot().reframed(b), zeros.reframed(b)] {
            let (one, other) = (rounded(&robot(), a), rounded(&other, b));
            let comparison = compared([a, &one], [b, &other], "1e-4");
            assert_eq!(codes(&comparison), [], "{a} {b}\n{}", comparison.to_text(None));
        }
        let same = compared([a, &rounded(&robot(), a)], [b, &rounded(&robot(), b)], "1e-5");
        assert_eq!(codes(&same), [], "{a} {b}\n{}", same.to_text(None));
    }
}

#[test]
fn the_tolerance_is_a_sharp_limit_of_each_quantity() {
    let is_equal = |slip: &dyn Fn(&mut Robot)| {
        let mut slipped = robot();
        slip(&mut slipped);
        compared(["urdf", &robot().written("urdf")], ["urdf", &slipped.written("urdf")], "1e-4").is_equal()
    };
    let fore = *robot().solid("fore");
    let distance = fore.center.iter().map(|c| c * c).sum::<f64>().sqrt();
    let gyration = ((0..3).map(|k| fore.tensor[k][k]).sum::<f64>() / (2.0 * fore.mass)).sqrt();
    let norm = fore.tensor.iter().flatten().map(|x| x * x).sum::<f64>().sqrt();
    let reach = distance.max(gyration);
    for (part, is_within) in [(0.99e-4, true), (1.01e-4, false)] {
        assert_eq!(is_equal(&|r| r.solid("fore").mass /= 1.0 - part), is_within);
        let shift = |of: f64| move |r: &mut Robot| r.solid("fore").center[2] += part * of;
        assert_eq!(is_equal(&shift(reach)), is_within, "{distance} {gyration}");
        let tensor = |r: &mut Robot| {
            for (i, j) in [(0, 2), (2, 0)] {
                r.solid("fore").tensor[i][j] += part * norm / 2f64.sqrt();
            }
        };
        assert_eq!(is_equal(&tensor), is_within);
        // A turn of the axis about a perpendicular line.
        let turned = |r: &mut Robot| {
            let joint = r.part("fore").joint.as_mut().unwrap();
            let across = [0.64, -0.6, 0.0].map(|c: f64| c / 0.64_f64.hypot(0.6));
            joint.axis = [0, 1, 2].map(|k| part.cos() * joint.axis[k] + part.sin() * across[k]);
        };
        assert_eq!(is_equal(&turned), is_within);
    }
    // The farthest point of the robot, along its links, is between 0.7 m and 1.2 m away.
    for (shift, is_within) in [(0.7e-4, true), (1.2e-4, false)] {
        let across = [0.64, -0.6, 0.0].map(|c: f64| shift * c / 0.64_f64.hypot(0.6));
        let moved = |r: &mut Robot| {
            r.part("fore").pose = r.part("fore").pose.then(&Frame { p: across, ..Frame::IDENTITY })
        };
        assert_eq!(is_equal(&moved), is_within);
    }
}

#[test]
fn mass_moved_across_a_joint_with_another_zero_is_told() {
    let plain = robot();
    let mut moved = plain.rezeroed("upper", 0.7);
    let upper = *moved.solid("upper");
    // At the zero of the first model.
    let at = plain.0[1].pose.point(upper.center);
    moved.solid("upper").mass -= 0.1;
    let base = *moved.solid("base");
    *moved.solid("base") = sum(&[base, Solid { mass: 0.1, center: at, tensor: [[0.0; 3]; 3] }]);
    for language in ["urdf", "xml"] {
        let comparison = between((&plain, "sdf"), (&moved, language));
        assert!(codes(&comparison).contains(&("compare.mass", "upper")), "{}", comparison.to_text(None));
        let ending = "; the sum of all links agrees: moved between links";
        assert!(messages(&comparison).iter().all(|m| m.ends_with(ending)), "{:?}", messages(&comparison));
    }
}

#[test]
fn the_axis_below_determines_the_zero_of_a_joint_without_mass() {
    let mut bare = robot();
    bare.part("upper").solid = None;
    let moved = bare.rezeroed("upper", 0.7);
    for language in ["urdf", "xml"] {
        for other in [moved.clone(), moved.reframed(language)] {
            let comparison = between((&bare, "xml"), (&other, language));
            assert_eq!(codes(&comparison), [], "{}", comparison.to_text(None));
            let [(code, message)] = notes(&comparison)[..] else { panic!("{:?}", notes(&comparison)) };
            assert_eq!((code, message), ("compare.zero", "its zero differs: 0 in a.xml is -0.7 rad here"));
        }
    }
}

#[test]
fn rounding_does_not_accumulate_along_a_chain_of_equal_frames() {
    let mut chain = robot();
    chain.0.truncate(2);
    for k in 2..60 {
        let mut next = chain.0[1].clone();
        next.name = format!("link{k}");
        next.joint.as_mut().unwrap().name = format!("joint{k}");
        next.parent = Some(k - 1);
        chain.0.push(next);
    }
    // Each of 60 poses is turned by half the tolerance, in the same sense.
    let mut rounded = chain.clone();
    for part in &mut rounded.0 {
        part.pose = part.pose.then(&Frame::new([0.0; 3], [0.0, 0.0, 5e-7]));
    }
    let comparison = compared(["urdf", &chain.written("urdf")], ["xml", &rounded.written("xml")], "1e-6");
    assert_eq!(codes(&comparison), [], "{}", comparison.to_text(None));
}
