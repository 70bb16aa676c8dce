//! Masses of links: kept, by density, by name, by part, and a distributed total.

use polhode_document::Report as _;
use polhode_robot::inertials::{InertialsRequest, Only, Origin, write_inertials};
use polhode_source::Failure;
use polhode_source::files::Memory;

use super::{of, outcome, request, why_not, written};

/// Three boxes: the first with a mass and a good tensor, the second with a tensor about the wrong
/// axes, the third without an inertial.
const ROBOT: &str = r#"<robot name="r">
  <link name="arm_1">
    <inertial><origin xyz="0 0 0.1"/><mass value="1.70"/><inertia ixx="0.0073667" ixy="0" ixz="0" iyy="0.0062333" iyz="0" izz="0.0028333"/></inertial>
    <visual name="hull"><origin xyz="0 0 0.1"/><geometry><box size="0.08 0.12 0.194"/></geometry></visual>
  </link>
  <link name="arm_2">
    <inertial>
      <mass value="2.5"/>
      <inertia ixx="3" ixy="0" ixz="0" iyy="1" iyz="0" izz="1.5"/>
    </inertial>
    <collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision>
  </link>
  <link name="hand">
    <visual><geometry><box size="0.1 0.1 0.05"/></geometry></visual>
    <visual name="grip"><origin xyz="0.2 0 0"/><geometry><box size="0.05 0.04 0.03"/></geometry></visual>
  </link>
  <link name="tool"/>
  <joint name="a" type="revolute"><parent link="arm_1"/><child link="arm_2"/><limit lower="0" upper="1"/></joint>
  <joint name="b" type="revolute"><parent link="arm_2"/><child link="hand"/><limit lower="0" upper="1"/></joint>
  <joint name="c" type="fixed"><parent link="hand"/><child link="tool"/></joint>
</robot>
"#;

#[track_caller]
fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-13 * b.abs(), "{a} {b}");
}

#[test]
fn a_mass_in_the_model_is_kept() {
    let inertials = written("r.urdf", ROBOT, &[]);
    let arm = of(&inertials, "arm_2");
    assert_eq!((arm.properties.mass(), arm.mass_by.as_str()), (2.5, "kept"));
    near(arm.properties.inertia().matrix()[0][0], 2.5 * (0.04 + 0.09) / 12.0);
    // The digits of the mass stay, and the element keeps its form.
    let new = inertials.text();
    assert!(new.contains("<mass value=\"1.70\"/>"), "{new}");
    assert!(
        new.contains(
            "    <inertial>\n      <origin xyz=\"0 0 0\" rpy=\"0 0 0\"/>\n      <mass value=\"2.5\"/>\n"
        ),
        "{new}"
    );
    assert!(new.contains("    <inertial><origin xyz=\"0 0 0.1\" rpy=\"0 0 0\"/><mass"), "{new}");
    // A link without mass is listed; a frame needs none.
    assert!(why_not(&inertials, "hand").starts_with("it has no mass: give its density"));
    assert_eq!(why_not(&inertials, "tool"), "no geometry");
    assert!(inertials.has_failed());
    assert_eq!(outcome(&inertials, "hand").line, 13);
}

#[test]
fn only_some_links_are_written() {
    let files = Memory::from([("r.urdf", ROBOT)]);
    let of = |only: Option<Only>, link: Option<&str>| {
        let mut request = request("r.urdf", &["hand=2 kg"]);
        (request.options.only, request.link) = (only, link.map(str::to_owned));
        let inertials = write_inertials(&request, &files).unwrap();
        inertials.links.iter().map(|link| link.link.clone()).collect::<Vec<_>>()
    };
    assert_eq!(of(None, None), ["arm_1", "arm_2", "hand", "tool"]);
    assert_eq!(of(Some(Only::Missing), None), ["hand", "tool"]);
    assert_eq!(of(Some(Only::Suspect), None), ["arm_2", "hand"]);
    assert_eq!(of(Some(Only::Impossible), None), ["arm_2"]);
    assert_eq!(of(None, Some("arm_?")), ["arm_1", "arm_2"]);
    assert_eq!(of(Some(Only::Missing), Some("h*")), ["hand"]);
}

#[test]
fn densities_are_of_all_links_of_some_or_of_a_shape() {
    let mut request = request("r.urdf", &["arm_*=oak", "hand/grip=2.5 g/cm^3", "hand/visual 1=0.3 kg"]);
    request.substance.material = Some("steel".parse().unwrap());
    let files = Memory::from([("r.urdf", ROBOT)]);
    let inertials = write_inertials(&request, &files).unwrap();
    let oak = polhode_shape::material::named("oak").unwrap().density;
    near(of(&inertials, "arm_2").properties.mass(), oak * 0.006);
    near(of(&inertials, "hand").properties.mass(), 0.3 + 2500.0 * 6e-5);
    near(of(&inertials, "hand").properties.center_of_mass().to_array()[0], 0.2 * 0.15 / 0.45);
    // A part takes its mass from the link's, and the rest has the remainder.
    request.part = vec!["hand=0.9 kg".parse().unwrap(), "hand/grip=0.1 kg".parse().unwrap()];
    let inertials = write_inertials(&request, &files).unwrap();
    let hand = of(&inertials, "hand");
    assert_eq!(hand.mass_by, "given, and its parts' own substances");
    near(hand.properties.mass(), 0.9);
    near(hand.properties.center_of_mass().to_array()[0], 0.2 * 0.1 / 0.9);
    near(of(&inertials, "arm_1").properties.mass(), 7850.0 * 0.08 * 0.12 * 0.194);
    request.part = vec!["hand=0.9 kg".parse().unwrap(), "hand/grip=1 kg".parse().unwrap()];
    let inertials = write_inertials(&request, &files).unwrap();
    assert_eq!(
        why_not(&inertials, "hand"),
        "its mass is 0.9 kg, but its parts with their own substance have 1 kg"
    );
}

#[test]
fn a_total_is_distributed_by_volume() {
    let mut request = request("r.urdf", &["hand=1.3 kg"]);
    request.substance.mass = Some("9 kg".parse().unwrap());
    let inertials = write_inertials(&request, &Memory::from([("r.urdf", ROBOT)])).unwrap();
    let (one, two) = (0.08 * 0.12 * 0.194, 0.006);
    near(of(&inertials, "arm_1").properties.mass(), 9.0 * one / (one + two));
    near(of(&inertials, "arm_2").properties.mass(), 9.0 * two / (one + two));
    near(of(&inertials, "hand").properties.mass(), 1.3);
    assert!(
        of(&inertials, "arm_1").mass_by.starts_with("share of the total, 1144.69"),
        "{}",
        inertials.to_text(None)
    );
    assert!(!inertials.has_failed());
}

#[track_caller]
fn refused(text: &str, change: impl FnOnce(&mut InertialsRequest)) -> Failure {
    let mut request = request("r.urdf", &[]);
    change(&mut request);
    write_inertials(&request, &Memory::from([("r.urdf", text)])).unwrap_err()
}

#[test]
fn options_that_contradict_are_refused() {
    let parts = |parts: &'static [&'static str]| {
        move |request: &mut InertialsRequest| {
            request.part = parts.iter().map(|part| part.parse().unwrap()).collect();
        }
    };
    let message = |failure: Failure| failure.message();
    assert_eq!(message(refused(ROBOT, parts(&["arm_*=2 kg"]))), "--part arm_* gives one mass to 2 links");
    assert_eq!(
        message(refused(ROBOT, parts(&["arm_*=steel", "arm_1=oak"]))),
        "--part arm_* and --part arm_1 for the link \"arm_1\" contradict each other"
    );
    let unknown = refused(ROBOT, parts(&["hnad=steel"]));
    assert_eq!(unknown.message(), "--part: no link, shape or mesh part is named \"hnad\"");
    assert!(unknown.hint().unwrap().starts_with("did you mean hand?"));
    let unknown = refused(ROBOT, |request| request.link = Some("amr_1".to_owned()));
    assert_eq!(unknown.message(), "no link is named \"amr_1\"");
    assert!(unknown.hint().unwrap().starts_with("did you mean arm_1?"));
    let two = refused(ROBOT, |request| {
        request.substance.mass = Some("1 kg".parse().unwrap());
        request.substance.density = Some("1 g/cm^3".parse().unwrap());
    });
    assert_eq!(two.message(), "--density and --mass contradict each other");
    let plane = ROBOT.replace("<box size=\"0.1 0.1 0.05\"/>", "<plane/>");
    let total = refused(&plane, |request| request.substance.mass = Some("1 kg".parse().unwrap()));
    assert_eq!(
        total.message(),
        "the total mass cannot be distributed: the link \"hand\" has no usable solid"
    );
    let idle = refused(ROBOT, |request| {
        request.link = Some("hand".to_owned());
        request.part = vec!["hand=2 kg".parse().unwrap()];
        request.substance.mass = Some("1 kg".parse().unwrap());
    });
    assert_eq!(idle.message(), "--mass has no effect: every link has its own --part");
}

/// A link is named, and its requested geometry does not exist.
#[test]
fn a_named_link_without_geometry_fails() {
    let files = Memory::from([("r.urdf", ROBOT)]);
    let mut request = request("r.urdf", &[]);
    request.link = Some("tool".to_owned());
    assert!(write_inertials(&request, &files).unwrap().has_failed());
    request.link = Some("arm_?".to_owned());
    request.options.geometry = Some(Origin::Collision);
    request.options.only = None;
    let inertials = write_inertials(&request, &files).unwrap();
    // The first link keeps the inertial that it has.
    assert_eq!(why_not(&inertials, "arm_1"), "no geometry");
    assert!(!inertials.has_failed());
    request.part = vec!["arm_2=500 g/cm^3".parse().unwrap()];
    let inertials = write_inertials(&request, &files).unwrap();
    assert!(why_not(&inertials, "arm_2").contains("density.implausible"), "{}", inertials.to_text(None));
    // The second link has none that a body can have.
    assert!(inertials.has_failed());
    assert_eq!(inertials.text(), ROBOT);
}
