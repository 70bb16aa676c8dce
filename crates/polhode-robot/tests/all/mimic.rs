//! Coupled joints and subtrees, compared with MuJoCo 3.17 and Pinocchio 4.1.

use polhode_robot::LinkError;
use polhode_robot::lump::{JointPosition, Lump, Lumping, PositionBy, lump};
use polhode_robot::model::{Joint, RobotModel};

use crate::common::{read, require_says};

const GRIPPER: &str = include_str!("../../../../examples/robots/gripper.urdf");

fn given(values: &[(&str, f64)]) -> Vec<(String, f64)> {
    values.iter().map(|&(name, value)| (name.to_owned(), value)).collect()
}

pub(crate) fn one(model: &RobotModel, lumping: Lumping<'_>, values: &[(&str, f64)]) -> Lump {
    let lumps = lump(model, lumping, &given(values)).unwrap();
    let [one] = lumps.as_slice() else { panic!("{} lumps", lumps.len()) };
    one.clone()
}

pub(crate) fn error(model: &RobotModel, lumping: Lumping<'_>, values: &[(&str, f64)]) -> LinkError {
    lump(model, lumping, &given(values)).unwrap_err()
}

pub(crate) fn value(lump: &Lump, joint: &str) -> f64 {
    lump.positions.iter().find(|position| position.joint == joint).unwrap().value
}

/// Asserts mass, centre, and the tensor xx yy zz xy xz yz about the centre.
fn assert_is(lump: &Lump, mass: f64, center: [f64; 3], six: [f64; 6], tolerance: f64) {
    let properties = &lump.properties;
    assert!((properties.mass() / mass - 1.0).abs() < tolerance);
    for (a, b) in properties.center_of_mass().to_array().iter().zip(center) {
        assert!((a - b).abs() < tolerance, "{a} {b}");
    }
    let i = properties.inertia().matrix();
    let trace = six[0] + six[1] + six[2];
    for (a, b) in [i[0][0], i[1][1], i[2][2], i[0][1], i[0][2], i[1][2]].iter().zip(six) {
        assert!((a - b).abs() < tolerance * trace, "{a} {b}");
    }
}

const POSE: [(&str, f64); 3] = [("lift", 0.17), ("turn", -0.83), ("left_knuckle", 0.41)];

/// Expected values from `pin.crba(model, data, q)` with q of all five joints, `right_knuckle` =
/// −0.7 · 0.41 + 0.2 and `tip_slide` = 0.03 times that + 0.01.
///
/// The whole is `model.inertias[0] + data.oMi[1].act(data.Ycrb[1])`. The subtrees are `data.Ycrb`
/// of the joints `turn` and `right_knuckle`, whose frames are those of the child links.
#[test]
fn a_gripper_is_pinocchios() {
    let model = read(GRIPPER);
    let whole = one(&model, Lumping::All, &POSE);
    assert_eq!(whole.frame.as_deref(), Some("base"));
    assert!((value(&whole, "right_knuckle") - -0.087).abs() < 1e-16);
    assert!((value(&whole, "tip_slide") - 0.00739).abs() < 1e-16);
    assert_is(
        &whole,
        6.603,
        [0.09614566563824886, 0.02277085456368003, 0.21257376359059058],
        [
            0.31723787777214685,
            0.3546689028876585,
            0.12806045586492076,
            -0.03664410257490375,
            -0.12796428118373335,
            -0.05288208162717067,
        ],
        1e-15,
    );
    let palm = one(&model, Lumping::Subtree("palm"), &[("left_knuckle", 0.41)]);
    assert_eq!(palm.frame.as_deref(), Some("palm"));
    assert_eq!((palm.links.len(), palm.massless.as_slice()), (4, ["tcp".to_owned()].as_slice()));
    assert_is(
        &palm,
        0.803,
        [0.04654461142223511, -0.01649181158020465, 0.00972670870271394],
        [
            0.0018425042066597015,
            0.001709464724623935,
            0.002734939254717088,
            -1.1027381846990538e-05,
            -5.918668101769643e-05,
            0.00011638251436951058,
        ],
        1e-15,
    );
    // Its tip is moved by a joint that is not in the subtree.
    let right = one(&model, Lumping::Subtree("right"), &[("left_knuckle", 0.41)]);
    assert_is(
        &right,
        0.1,
        [0.06025242628651053, -0.013824668553800337, 0.003291348664848201],
        [
            3.5161979069584796e-05,
            0.00010969786522263506,
            0.00010665790516765389,
            -3.0841562419355657e-06,
            5.330606995907741e-06,
            3.1695156899385336e-06,
        ],
        1e-15,
    );
}

#[test]
fn a_follower_of_nothing_is_at_its_offset() {
    let whole = one(&read(GRIPPER), Lumping::All, &[]);
    let by = |joint: &str| &whole.positions.iter().find(|position| position.joint == joint).unwrap().by;
    assert_eq!((value(&whole, "right_knuckle"), value(&whole, "left_knuckle")), (0.2, 0.0));
    assert_eq!(value(&whole, "tip_slide"), 0.03 * 0.2 + 0.01);
    assert_eq!((by("left_knuckle"), by("lift")), (&PositionBy::Rest, &PositionBy::Rest));
    assert_eq!(by("tip_slide"), &PositionBy::Leader(Some("right_knuckle".to_owned())));
    // Limits are those of the file: lift = 0.5 exceeds them, and so does the coupled joint.
    let far = one(&read(GRIPPER), Lumping::All, &[("lift", 0.5), ("left_knuckle", -0.35)]);
    let outside: Vec<&str> =
        far.positions.iter().filter(|p| p.is_outside()).map(|p| p.joint.as_str()).collect();
    assert_eq!(outside, ["lift", "left_knuckle", "right_knuckle"]);
    // A value at the limit is permitted.
    assert!(
        !one(&read(GRIPPER), Lumping::All, &[("lift", 0.4)]).positions.iter().any(JointPosition::is_outside)
    );
}

const HAND: &str = r#"<mujoco model="hand"><compiler angle="degree"/><worldbody>
  <body name="palm" pos="0.1 -0.2 0.3" euler="20 -15 40">
    <inertial pos="0.03 -0.02 0.01" mass="0.62" fullinertia="0.00061 0.00083 0.00072 0.00005 -0.00003 0.00002"/>
    <joint name="wrist" type="hinge" axis="0.3 -0.5 0.8" pos="-0.02 0.01 0.03" ref="12" range="-90 90"/>
    <body name="left" pos="0.06 0.04 0.01" euler="5 10 -8">
      <inertial pos="0.05 0.01 0.004" mass="0.083" fullinertia="0.000021 0.000057 0.000049 0.000002 -0.000001 0.000003"/>
      <joint name="left_knuckle" type="hinge" axis="0.1 0.2 0.95" pos="0.004 0 -0.002" ref="-7" range="-20 50"/>
    </body>
    <body name="right" pos="0.06 -0.04 0.01" euler="-5 6 9">
      <inertial pos="0.048 -0.012 0.003" mass="0.079" fullinertia="0.000023 0.000054 0.000047 -0.000002 0.000001 0.000002"/>
      <joint name="right_knuckle" type="hinge" axis="-0.1 0.15 0.9" pos="0.002 0.003 0" ref="4" range="-20 10"/>
      <body name="tip" pos="0.09 -0.01 0.005" euler="12 3 -7">
        <inertial pos="0.01 -0.004 0.006" mass="0.021" fullinertia="0.0000031 0.0000047 0.0000042 0.0000003 -0.0000002 0.0000001"/>
        <joint name="tip_slide" type="slide" axis="0.8 -0.3 0.2" ref="0.015" range="-0.05 0.05"/>
      </body></body></body></worldbody>
  <equality>
    <joint joint1="right_knuckle" joint2="left_knuckle" polycoef="0.2 -0.7 0.11 -0.05 0.02"/>
    <joint joint1="tip_slide" joint2="right_knuckle" polycoef="0.01 0.03"/>
  </equality></mujoco>"#;

/// Expected values from `mj_forward` at qpos = (0.37, −0.29, 0.39064…, 0.03462…), where `efc_pos`
/// of both constraints is 0 and 5e-18. Composites are summed in NumPy from `xipos`, `ximat`,
/// `body_mass` and `body_inertia`; their mass and centre agree with `body_subtreemass` and
/// `subtree_com`. MuJoCo computes principal axes to about 1e-14.
#[test]
fn a_hand_is_mujocos() {
    let model = read(HAND);
    let values = [("wrist", 0.37), ("left_knuckle", -0.29)];
    let whole = one(&model, Lumping::All, &values);
    assert_eq!(whole.frame, None);
    assert!((value(&whole, "right_knuckle") - 0.3906425002677889).abs() < 1e-15);
    assert!((value(&whole, "tip_slide") - 0.03462487990564048).abs() < 1e-16);
    assert_is(
        &whole,
        0.803,
        [0.13935056469234802, -0.17913710368715835, 0.333929810937265],
        [
            0.0018398136620730516,
            0.0014807507918123957,
            0.0019453370698039871,
            -0.00045204793095903373,
            -0.0003392291073927768,
            -0.00044375932417877926,
        ],
        1e-13,
    );
    let right = one(&model, Lumping::Subtree("right"), &values[1..]);
    assert_is(
        &right,
        0.1,
        [0.06246702893275895, -0.014858009850796902, 0.004672211533405737],
        [
            3.030435796670119e-05,
            0.00013833373097065218,
            0.0001330809166913955,
            1.4061649631536981e-05,
            -8.128751130248687e-06,
            3.966193205792508e-06,
        ],
        1e-13,
    );
    // A value equal to `ref` moves nothing.
    let at_rest = one(&model, Lumping::Subtree("left"), &[]);
    assert_eq!(at_rest.properties.mass(), 0.083);
    let given = one(&model, Lumping::All, &[("wrist", 12_f64.to_radians())]);
    assert_eq!(given.properties, one(&model, Lumping::All, &[]).properties);
    // Ranges are in degrees in the file, and in radians here.
    let limits = whole.positions[0].limits.unwrap();
    assert!((limits[1] - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    assert!(whole.positions.iter().any(|p| p.joint == "right_knuckle" && p.is_outside()));
}

#[test]
fn mjcf_couples_what_is_on() {
    let of =
        |old: &str, new: &str| one(&read(&HAND.replace(old, new)), Lumping::All, &[("left_knuckle", -0.29)]);
    let rest = 4_f64.to_radians();
    let off = of("polycoef=\"0.2 -0.7", "active=\"false\" polycoef=\"0.2 -0.7");
    assert_eq!(value(&off, "right_knuckle"), rest);
    // Disabled by a class, and the default coefficients.
    let class = "<default><default class='off'><equality active='false'/></default></default><equality>";
    let off = of("<equality>", &format!("{class}<!-- -->")).positions;
    assert!(off.iter().any(|p| p.joint == "right_knuckle" && p.value != rest));
    let named = HAND.replace("<equality>", class).replace("joint1=\"right", "class=\"off\" joint1=\"right");
    assert_eq!(value(&one(&read(&named), Lumping::All, &[]), "right_knuckle"), rest);
    // A class passes its attributes to nested classes.
    let inner =
        class.replace("<equality active='false'/>", "<equality active='false'/><default class='in'/>");
    let named = HAND.replace("<equality>", &inner).replace("joint1=\"right", "class=\"in\" joint1=\"right");
    assert_eq!(value(&one(&read(&named), Lumping::All, &[]), "right_knuckle"), rest);
    let line = of(" polycoef=\"0.2 -0.7 0.11 -0.05 0.02\"", "");
    let expected = rest + (-0.29 + 7_f64.to_radians());
    assert!((value(&line, "right_knuckle") - expected).abs() < 1e-16);
    // Without a second joint the value is constant.
    let held = read(&HAND.replace("joint2=\"left_knuckle\" ", ""));
    assert_eq!(value(&one(&held, Lumping::All, &[]), "right_knuckle"), rest + 0.2);
    let text = error(&held, Lumping::All, &[("right_knuckle", 0.1)]).to_string();
    assert!(text.contains("\"right_knuckle\" is constrained to a constant value"), "{text}");
    // Two constraints on one joint.
    let twice = HAND.replace("joint1=\"tip_slide\" joint2=\"right", "joint1=\"right_knuckle\" joint2=\"wri");
    let twice = read(&twice.replace("joint2=\"wri_knuckle\"", "joint2=\"wrist\""));
    let refused = error(&twice, Lumping::All, &[]);
    require_says(&refused, "the joint \"right_knuckle\" ");
    require_says(&refused, " the relation cannot be read: ");
}

/// MuJoCo 3.17 generates two constraints: k0 of j0 and k1 of j1.
#[test]
fn copies_follow_copies() {
    let mass = "<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>";
    let text = format!(
        "<mujoco><worldbody><replicate count='2' offset='0 0 1'>
        <body name='b'>{mass}<joint name='j'/><body name='c' pos='0 1 0'>{mass}<joint name='k'/></body></body>
        </replicate></worldbody><equality><joint joint1='k' joint2='j' polycoef='0.1 2'/></equality></mujoco>"
    );
    let whole = one(&read(&text), Lumping::All, &[("j1", 0.3)]);
    assert!((value(&whole, "k0") - 0.1).abs() < 1e-16);
    assert!((value(&whole, "k1") - 0.7).abs() < 1e-15);
}

/// MuJoCo 3.17 drops a constraint between a copied and another joint, unless the constraint names a
/// copy.
#[test]
fn copies_follow_what_is_copied_along() {
    let mass = "<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>";
    let copies = |inner: &str| format!("<replicate count='2' offset='0 0 1' sep='-'>{inner}</replicate>");
    let b = format!("<body name='b'>{mass}<joint name='j'/></body>");
    let read_with = |world: &str, names: &str| {
        read(&format!(
            "<mujoco><worldbody><body name='z'>{mass}<joint name='z'/></body>{world}</worldbody>
            <equality><joint {names} polycoef='0.1 2'/></equality></mujoco>"
        ))
    };
    let nested = copies(&format!("<body name='o'>{mass}<joint name='o'/>{}</body>", copies(&b)));
    for (world, names) in [
        (copies(&b), "joint1='j' joint2='z'"),
        (copies(&b), "joint1='z' joint2='j'"),
        (nested.clone(), "joint1='j' joint2='o'"),
        (nested.clone(), "joint1='o' joint2='j'"),
    ] {
        assert!(
            read_with(&world, names).joints.iter().all(|joint| joint.coordinate.follows.is_none()),
            "{names}"
        );
    }
    let followers = |world: &str, names: &str| {
        let model = read_with(world, names);
        let follower = |joint: &Joint| {
            let follows = joint.coordinate.follows.as_ref()?;
            Some(format!("{} {}", joint.name.text, follows.leader.as_ref().map_or("", |leader| &leader.text)))
        };
        model.joints.iter().filter_map(follower).collect::<Vec<_>>().join(", ")
    };
    assert_eq!(followers(&copies(&b), "joint1='j-0' joint2='z'"), "j-0 z");
    assert_eq!(followers(&copies(&b), "joint1='z' joint2='j-1'"), "z j-1");
    assert_eq!(followers(&copies(&b), "joint1='j-0' joint2='j-1'"), "j-0 j-1");
    assert_eq!(followers(&nested, "joint1='j-0' joint2='o'"), "j-0-0 o-0, j-0-1 o-1");
    assert_eq!(followers(&nested, "joint1='j-0-1'"), "j-0-1 ");
    // An unknown joint is reported only if the constraint matters. MuJoCo rejects the file.
    let lost = read_with(&copies(&b), "joint1='z' joint2='q'");
    require_says(&error(&lost, Lumping::All, &[]), "which does not exist");
}

/// This test took a hundred seconds with a quadratic algorithm.
#[test]
fn copies_and_constraints_do_not_multiply() {
    let constraints: String =
        (0..20_000).map(|k| format!("<joint joint1='j' joint2='i{k}'/><joint joint1='l{k}'/>")).collect();
    let model = read(&format!(
        "<mujoco><worldbody><replicate count='40000' offset='1 0 0'><body><joint name='j'/></body></replicate></worldbody>
        <equality>{constraints}</equality></mujoco>"
    ));
    assert!(model.joints.iter().all(|joint| joint.coordinate.follows.is_some()));
}

#[test]
fn what_cannot_follow_is_refused_with_both_names() {
    let model = read(GRIPPER);
    let place = |error: &LinkError, text: &str| {
        let span = error.span().unwrap();
        text[..span.start].lines().count()
    };
    let own = error(&model, Lumping::All, &[("right_knuckle", 0.1)]);
    let said = format!("{own} {}", own.hint());
    assert!(said.contains("\"right_knuckle\" follows \"left_knuckle\""), "{said}");
    let mimic = GRIPPER.lines().position(|line| line.contains("<mimic joint=\"left_knuckle\"")).unwrap();
    assert_eq!(place(&own, GRIPPER), mimic + 1);

    let lost = GRIPPER.replace("<mimic joint=\"left_knuckle\"", "<mimic joint=\"left_knukle\"");
    let refused = error(&read(&lost), Lumping::All, &[]);
    require_says(&refused, "which does not exist");
    assert!(refused.hint().contains("left_knuckle") && place(&refused, &lost) == mimic + 1);
    // An irrelevant coupling is not evaluated.
    assert_eq!(one(&read(&lost), Lumping::Subtree("left"), &[]).properties.mass(), 0.083);
    assert!(lump(&read(&lost), Lumping::Fixed, &[]).is_ok());

    let fixed = read(&GRIPPER.replace("<mimic joint=\"left_knuckle\"", "<mimic joint=\"flange\""));
    require_says(&error(&fixed, Lumping::All, &[]), "which is not a single rotating or sliding joint");
    for circle in ["tip_slide", "right_knuckle"] {
        let circle =
            read(&GRIPPER.replace("<mimic joint=\"left_knuckle\"", &format!("<mimic joint=\"{circle}\"")));
        require_says(&error(&circle, Lumping::All, &[]), "in a cycle");
        require_says(&error(&circle, Lumping::Subtree("right"), &[]), "in a cycle");
    }
    let word = read(&GRIPPER.replace("multiplier=\"-0.7\"", "multiplier=\"-0,7\""));
    require_says(&error(&word, Lumping::All, &[]), "but the relation cannot be read");
    let twice = read(&GRIPPER.replace("name=\"flange\" type=\"fixed\"", "name=\"turn\" type=\"fixed\""));
    require_says(&error(&twice, Lumping::All, &[("turn", 0.1)]), "two joints have the name \"turn\"");
}

#[test]
fn a_value_moves_something_or_is_refused() {
    let model = read(GRIPPER);
    for joint in ["turn", "lift"] {
        let refused = error(&model, Lumping::Subtree("palm"), &[(joint, 0.1)]);
        require_says(&refused, &format!("the joint {joint:?} moves nothing below the link \"palm\""));
    }
    // A leader outside the subtree is used; a leader in a sibling subtree is not.
    one(&model, Lumping::Subtree("right"), &[("left_knuckle", 0.1)]);
    require_says(&error(&model, Lumping::Subtree("tip"), &[("left_knuckle", 0.1)]), "moves nothing");
    require_says(&error(&model, Lumping::Fixed, &[("turn", 0.1)]), "moves nothing within a group of links");
    let refused = error(&model, Lumping::Subtree("plam"), &[]);
    assert!(refused.hint().contains("did you mean palm?"), "{}", refused.hint());
    let refused = error(&model, Lumping::All, &[("trun", 0.1)]);
    assert!(refused.hint().contains("did you mean turn?"), "{}", refused.hint());
    require_says(
        &error(&model, Lumping::Subtree("tcp"), &[]),
        "neither the link \"tcp\" nor its descendants",
    );
}

/// The subtree of the root is the whole model, unless the root is attached to the world.
#[test]
fn what_hangs_on_the_world_stands_where_its_joint_says() {
    let hung = GRIPPER.replace(
        "<joint name=\"lift\"",
        "<joint name=\"floor\" type=\"revolute\"><parent link=\"world\"/><child link=\"base\"/>
           <origin xyz=\"0.3 -0.1 0.2\" rpy=\"0 0 0\"/><axis xyz=\"0 0 1\"/></joint><joint name=\"lift\"",
    );
    let (free, hung) = (read(GRIPPER), read(&hung));
    let own = one(&free, Lumping::All, &POSE);
    assert_eq!(one(&free, Lumping::Subtree("base"), &POSE), own);
    assert_eq!(one(&hung, Lumping::Subtree("base"), &POSE).properties, own.properties);
    let placed = one(&hung, Lumping::All, &[POSE.as_slice(), &[("floor", 0.6)]].concat());
    assert_eq!(placed.frame, None);
    let ([x, y, z], (s, c)) = (own.properties.center_of_mass().to_array(), 0.6_f64.sin_cos());
    let expected = [c * x - s * y + 0.3, s * x + c * y - 0.1, z + 0.2];
    for (a, b) in placed.properties.center_of_mass().to_array().iter().zip(expected) {
        assert!((a - b).abs() < 1e-15, "{a} {b}");
    }
}
