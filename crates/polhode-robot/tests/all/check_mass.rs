//! Missing masses, and tensors without mass.

use crate::check_common::{findings, is_clean, link, only, robot};
use polhode_robot::finding::Severity;

const TENSOR: [&str; 6] = ["0.0123", "0.0171", "0.0219", "-0.0011", "0.0007", "0.0013"];
const ZERO: [&str; 6] = ["0", "0", "0", "0", "0", "0"];
const BOX: &str = "<collision><geometry><box size=\"0.1 0.2 0.3\"/></geometry></collision>";

fn hung(kind: &str, child: &str) -> String {
    let base = link("base", "3", TENSOR);
    robot(&format!(
        "{base}{child}<joint name=\"j\" type=\"{kind}\"><parent link=\"base\"/><child link=\"tip\"/></joint>"
    ))
}

#[test]
fn frames_are_no_finding() {
    for child in ["<link name=\"tip\"/>".to_owned(), link("tip", "0", ZERO), link("tip", "0.0", ZERO)] {
        assert_eq!(findings(&hung("fixed", &child)), [], "{child}");
    }
}

#[test]
fn zero_mass_where_motion_needs_it() {
    let all = findings(&hung("revolute", &link("tip", "0", ZERO)));
    let found = only(&all, "mass.not_positive");
    assert_eq!((found.severity, found.subject.as_str(), all.len()), (Severity::Impossible, "tip", 1));
    // A link that carries a mass needs none of its own.
    let more = link("tip", "0", ZERO)
        + &link("hand", "0.7", TENSOR)
        + "<joint name=\"k\" type=\"revolute\"><parent link=\"tip\"/><child link=\"hand\"/></joint>";
    let all = findings(&hung("revolute", &more));
    assert_eq!((only(&all, "mass.refused").severity, all.len()), (Severity::Note, 1));
    // A model without any mass is a drawing.
    let drawing = robot(&format!(
        "{}{}<joint name=\"j\" type=\"revolute\"><parent link=\"base\"/><child link=\"tip\"/></joint>",
        link("base", "0", ZERO),
        link("tip", "0", ZERO)
    ));
    let all = findings(&drawing);
    assert_eq!(only(&all, "mass.not_positive").severity, Severity::Suspect);
}

#[test]
fn no_mass_with_inertia() {
    for (kind, severity) in [("fixed", Severity::Suspect), ("revolute", Severity::Impossible)] {
        let all = findings(&hung(kind, &link("tip", "0", TENSOR)));
        let found = only(&all, "mass.not_positive");
        assert_eq!((found.severity, all.len()), (severity, 1));
        assert!(found.message.contains("0.0123 kg·m²"), "{}", found.message);
    }
}

#[test]
fn no_inertia_with_mass() {
    let all = findings(&hung("revolute", &link("tip", "0.7", ZERO)));
    let found = only(&all, "inertia.zero");
    assert_eq!((found.severity, all.len()), (Severity::Impossible, 1));
    assert!(found.message.contains("0.7 kg"), "{}", found.message);
    // A point mass that is fixed to a body may be intended.
    let all = findings(&hung("fixed", &link("tip", "0.7", ZERO)));
    assert_eq!(only(&all, "inertia.zero").severity, Severity::Suspect);
}

#[test]
fn what_can_be_touched_has_mass() {
    for inertial in ["", "<inertial><mass value=\"0\"/></inertial>"] {
        for kind in ["fixed", "revolute"] {
            let child = format!("<link name=\"tip\">{inertial}{BOX}</link>");
            let all = findings(&hung(kind, &child));
            let code = if kind == "revolute" && !inertial.is_empty() {
                "mass.not_positive"
            } else {
                "mass.massless_collision"
            };
            let found = only(&all, code);
            // A link that is fixed to a link with mass shares that mass.
            assert_eq!(found.severity == Severity::Note, kind == "fixed", "{all:#?}");
            assert_eq!(found.subject, "tip");
        }
    }
    // A base fixed to its place, as in manipulators.
    let base = format!("<link name=\"base\">{BOX}</link>");
    let arm = robot(&format!(
        "{base}{}<joint name=\"j\" type=\"revolute\"><parent link=\"base\"/><child link=\"tip\"/></joint>",
        link("tip", "1", TENSOR)
    ));
    assert!(is_clean(&findings(&arm)));
}

#[test]
fn a_mass_without_a_tensor() {
    let all =
        findings(&hung("revolute", "<link name=\"tip\"><inertial><mass value=\"0.7\"/></inertial></link>"));
    let found = only(&all, "inertia.missing");
    assert_eq!((found.severity, all.len()), (Severity::Impossible, 1));
    let all = findings(&hung("revolute", &link("tip", "1", TENSOR).replace("<mass value=\"1\"/>", "")));
    assert_eq!(only(&all, "mass.missing").severity, Severity::Impossible);
}

#[test]
fn a_body_of_mjcf_needs_mass_if_it_has_a_joint() {
    let body = |inside: &str| {
        format!(
            "<mujoco><worldbody><body name=\"b\"><joint type=\"hinge\"/>{inside}</body></worldbody></mujoco>"
        )
    };
    let all = findings(&body(""));
    assert_eq!(only(&all, "mass.missing").severity, Severity::Impossible);
    for fine in [
        "<geom type=\"sphere\" size=\"0.1\"/>",
        "<inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"0.01 0.02 0.025\"/>",
        "<body name=\"c\"><geom type=\"sphere\" size=\"0.1\"/></body>",
    ] {
        assert_eq!(findings(&body(fine)), [], "{fine}");
    }
    // Two joints of one body are not two parents.
    assert_eq!(findings(&body("<joint type=\"slide\"/><geom type=\"sphere\" size=\"0.1\"/>")), []);
}

#[test]
fn sdf_has_defaults_and_static_models() {
    let sdf = |models: &str| format!("<sdf version=\"1.9\">{models}</sdf>");
    let collision =
        "<collision name=\"c\"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>";
    let free = sdf(&format!("<model name=\"m\"><link name=\"l\">{collision}</link></model>"));
    let all = findings(&free);
    assert_eq!(only(&all, "mass.missing").severity, Severity::Suspect);
    let fixed =
        sdf(&format!("<model name=\"m\"><static>true</static><link name=\"l\">{collision}</link></model>"));
    assert_eq!(findings(&fixed), []);
    let zero = sdf(&format!(
        "<model name=\"m\"><link name=\"l\"><inertial><mass>0</mass></inertial>{collision}</link></model>"
    ));
    assert_eq!(only(&findings(&zero), "mass.not_positive").severity, Severity::Impossible);
    // Products may be omitted.
    let six = sdf(
        "<model name=\"m\"><link name=\"l\"><inertial><mass>2</mass><inertia><ixx>0.01</ixx><iyy>0.02</iyy>\
                   <izz>0.025</izz></inertia></inertial></link></model>",
    );
    assert_eq!(findings(&six), []);
}

/// Returns a massless pad on a link, with its joint.
fn pad(name: &str, kind: &str, parent: &str) -> String {
    format!(
        "<link name=\"{name}\">{BOX}</link>\n<joint name=\"to_{name}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{name}\"/></joint>\n"
    )
}

#[test]
fn pads_on_a_link_with_mass_are_one_note() {
    let base = link("base", "3", TENSOR);
    let pads = pad("a", "fixed", "base") + &pad("b", "fixed", "a") + &pad("c", "fixed", "base");
    let all = findings(&robot(&(base.clone() + &pads)));
    let found = only(&all, "mass.massless_collision");
    assert_eq!((found.severity, all.len(), found.subject.as_str()), (Severity::Note, 1, "a"));
    assert_eq!(found.others, ["b", "c"]);
    assert!(found.message.ends_with("fixed to a link with mass; same in b, c"), "{}", found.message);
    // A pad that a joint moves is reported separately, and so is a pad fixed to it.
    let moved = pad("a", "fixed", "base") + &pad("b", "revolute", "base") + &pad("c", "fixed", "b");
    let all = findings(&robot(&(base + &moved)));
    let suspect: Vec<_> = all.iter().filter(|f| f.severity == Severity::Suspect).collect();
    assert_eq!(suspect.len(), 1, "{all:#?}");
    assert_eq!(
        (suspect[0].subject.as_str(), suspect[0].others.as_slice()),
        ("b", ["c".to_owned()].as_slice())
    );
    // Fixed to the world, as in manipulators.
    let arm = pad("foot", "fixed", "world") + &link("arm", "1", TENSOR);
    let joint = "<joint name=\"j\" type=\"revolute\"><parent link=\"foot\"/><child link=\"arm\"/></joint>";
    let all = findings(&robot(&format!("<link name=\"world\"/>{arm}{joint}")));
    assert_eq!(only(&all, "mass.massless_collision").severity, Severity::Note);
}
