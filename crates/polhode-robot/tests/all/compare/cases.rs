//! Structure, names, joint values at rest, unphysical numbers, and refused requests.

use std::fs;
use std::path::{Path, PathBuf};

use polhode_document::Report as _;
use polhode_robot::Request as CheckRequest;
use polhode_robot::compare::{REQUEST_SCHEMA, Request, run};
use polhode_source::Failure;
use polhode_source::files::Memory;
use serde_json::json;

use super::robots::{Part, robot};
use super::{between, codes, compared, messages, notes};
use crate::common::schema::require_fits;

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
