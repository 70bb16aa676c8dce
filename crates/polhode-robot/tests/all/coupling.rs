//! Coupled joints in SDF, OpenSim and PhysX.

use polhode_robot::lump::{Lumping, slides};

use crate::common::{read, require_says};
use crate::mimic::{error, one, value};

#[test]
fn sdf_follows_from_a_reference() {
    let link = |name: &str| {
        format!(
            "<link name='{name}'><inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial></link>"
        )
    };
    let joint = |name: &str, child: &str, axis: &str| {
        format!(
            "<joint name='{name}' type='revolute'><parent>palm</parent><child>{child}</child><axis><xyz>0 0 1</xyz>{axis}</axis></joint>"
        )
    };
    let text = |mimic: &str| {
        let links: String = ["palm", "left", "right"].map(link).concat();
        let left = joint("l", "left", "<limit><lower>-1e16</lower><upper>0.8</upper></limit>");
        format!(
            "<sdf version='1.11'><world name='w'><model name='hand'>{links}{left}{}</model></world></sdf>",
            joint("r", "right", mimic)
        )
    };
    let mimic = "<mimic joint='l'><multiplier>-0.7</multiplier><offset>0.2</offset><reference>0.15</reference></mimic>";
    let whole = one(&read(&text(mimic)), Lumping::All, &[("hand::l", 0.41)]);
    assert!((value(&whole, "hand::r") - (-0.7 * (0.41 - 0.15) + 0.2)).abs() < 1e-16);
    assert_eq!(whole.positions[0].limits, Some([f64::NEG_INFINITY, 0.8]));
    assert_eq!(whole.positions[1].limits, None);
    let at_rest = one(&read(&text(mimic)), Lumping::All, &[]);
    assert!((value(&at_rest, "hand::r") - (0.7 * 0.15 + 0.2)).abs() < 1e-16);
    for wrong in [
        mimic.replace("joint='l'", "joint='l' axis='axis2'"),
        mimic.replace("0.15", "0,15"),
        mimic.replace("<multiplier>-0.7</multiplier>", ""),
    ] {
        require_says(&error(&read(&text(&wrong)), Lumping::All, &[]), "the relation cannot be read");
    }
    // A joint with two axes does not have a single value.
    let second = text(
        "</axis><axis2><xyz>0 1 0</xyz><mimic joint='l'><multiplier>1</multiplier></mimic></axis2><axis>",
    );
    let second =
        second.replace("<axis></axis>", "").replace("name='r' type='revolute'", "name='r' type='universal'");
    let refused = error(&read(&second), Lumping::All, &[("hand::l", 0.41)]);
    require_says(&refused, "the joint \"hand::r\" follows \"hand::l\", but the relation cannot be read");
}

#[test]
fn opensim_couples_coordinates() {
    let body = |name: &str| {
        format!(
            "<Body name='{name}'><mass>1.3</mass><mass_center>0.1 -0.2 0.05</mass_center><inertia>0.1 0.1 0.1 0 0 0</inertia></Body>"
        )
    };
    let joint = |name: &str, parent: &str, child: &str, coordinate: &str| {
        format!("<PinJoint name='{name}'><socket_parent_frame>{parent}</socket_parent_frame><socket_child_frame>{child}</socket_child_frame>
            <coordinates><Coordinate name='{coordinate}'><default_value>0.4</default_value><range>-0.5 0.6</range><clamped>true</clamped></Coordinate></coordinates></PinJoint>")
    };
    let text = |function: &str| {
        format!(
            "<OpenSimDocument Version='40000'><Model name='leg'><BodySet><objects>{}{}{}</objects></BodySet><JointSet><objects>{}{}</objects></JointSet>
            <ConstraintSet><objects><CoordinateCouplerConstraint name='c'><isEnforced>true</isEnforced>
            <coupled_coordinates_function>{function}</coupled_coordinates_function>
            <independent_coordinate_names>hip_angle</independent_coordinate_names>
            <dependent_coordinate_name>knee_angle</dependent_coordinate_name><scale_factor>2</scale_factor></CoordinateCouplerConstraint></objects></ConstraintSet></Model></OpenSimDocument>",
            body("pelvis"), body("thigh"), body("shank"),
            joint("hip", "pelvis", "thigh", "hip_angle"), joint("knee", "thigh", "shank", "knee_angle"),
        )
    };
    let line = text("<LinearFunction><coefficients>-0.7 0.2</coefficients></LinearFunction>");
    let whole = one(&read(&line), Lumping::All, &[("hip_angle", 0.41)]);
    assert!((value(&whole, "knee") - 2.0 * (-0.7 * 0.41 + 0.2)).abs() < 1e-16);
    assert_eq!(whole.positions[0].limits, Some([-0.5, 0.6]));
    // A joint is given by its own name, and does not use its default value.
    assert_eq!(one(&read(&line), Lumping::All, &[("hip", 0.41)]), whole);
    assert_eq!(value(&one(&read(&line), Lumping::All, &[]), "hip"), 0.0);
    require_says(&error(&read(&line), Lumping::All, &[("knee_angle", 0.1)]), "takes no value of its own");
    let held = read(&text("<Constant><value>0.3</value></Constant>"));
    assert_eq!(value(&one(&held, Lumping::All, &[]), "knee"), 0.6);
    let bent = read(&text("<SimmSpline><x>0 1</x><y>0 1</y></SimmSpline>"));
    let refused = error(&bent, Lumping::All, &[]);
    assert!(refused.to_string().contains("SimmSpline"), "{refused}");
    // A coupling that does not affect the result is not evaluated.
    assert_eq!(one(&bent, Lumping::Subtree("shank"), &[]).properties.mass(), 1.3);
    // A joint with several coordinates does not have a single value.
    let knee = line.replace("<PinJoint name='knee'>", "<UniversalJoint name='knee'>").replacen(
        "</PinJoint></objects>",
        "</UniversalJoint></objects>",
        1,
    );
    let several = read(&knee.replacen(
        "<Coordinate name='knee_angle'>",
        "<Coordinate name='knee_turn'/><Coordinate name='knee_angle'>",
        1,
    ));
    let refused = error(&several, Lumping::All, &[]);
    require_says(&refused, "the joint \"knee\" follows ");
    require_says(&refused, "but the relation cannot be read");
    let off = read(&line.replace("<isEnforced>true", "<isEnforced>false"));
    assert_eq!(value(&one(&off, Lumping::All, &[]), "knee"), 0.0);
}

#[test]
fn usd_gears_joints() {
    let body = |name: &str| {
        format!(
            "def Xform \"{name}\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"]) {{ float physics:mass = 1.3\n point3f physics:centerOfMass = (0.1, -0.2, 0.05)\n float3 physics:diagonalInertia = (0.1, 0.12, 0.15) }}\n"
        )
    };
    let joint = |name: &str, kind: &str, child: &str, more: &str| {
        format!(
            "def {kind} \"{name}\" {{ uniform token physics:axis = \"Z\"\n rel physics:body0 = </r/palm>\n rel physics:body1 = </r/{child}>\n{more}\n}}\n"
        )
    };
    let text = |kind: &str| {
        let mimic = "rel physxMimicJoint:rotZ:referenceJoint = </r/l>\n float physxMimicJoint:rotZ:gearing = 0.7\n float physxMimicJoint:rotZ:offset = -11.5";
        let limits = "float physics:lowerLimit = -20\n float physics:upperLimit = 50";
        format!(
            "#usda 1.0\n( metersPerUnit = 1 )\ndef Xform \"r\" {{\n{}{}{}{}{}\n}}\n",
            body("palm"),
            body("left"),
            body("right"),
            joint("l", "PhysicsRevoluteJoint", "left", limits),
            joint("r", kind, "right", mimic),
        )
    };
    let whole = one(&read(&text("PhysicsRevoluteJoint")), Lumping::All, &[("/r/l", 0.41)]);
    assert!((value(&whole, "/r/r") - (-0.7 * 0.41 + 11.5_f64.to_radians())).abs() < 1e-15);
    let limits = whole.positions[0].limits.unwrap();
    assert!(
        (limits[0] + 20_f64.to_radians()).abs() < 1e-15 && (limits[1] - 50_f64.to_radians()).abs() < 1e-15
    );
    let mixed = read(&text("PhysicsPrismaticJoint"));
    require_says(&error(&mixed, Lumping::All, &[]), "but the relation cannot be read");
    // A joint with six axes does not have a single value, and a fixed joint has none.
    let six = error(&read(&text("PhysicsJoint")), Lumping::All, &[("/r/l", 0.41)]);
    require_says(&six, "the joint \"/r/r\" follows \"/r/l\", but the relation cannot be read");
    one(&read(&text("PhysicsFixedJoint")), Lumping::All, &[("/r/l", 0.41)]);
}

#[test]
fn a_name_means_one_joint() {
    let body = |name: &str| {
        format!(
            "<Body name='{name}'><mass>1.3</mass><mass_center>0.1 -0.2 0.05</mass_center><inertia>0.1 0.1 0.1 0 0 0</inertia></Body>"
        )
    };
    let joint = |kind: &str, name: &str, parent: &str, child: &str, coordinate: &str| {
        format!("<{kind} name='{name}'><socket_parent_frame>{parent}</socket_parent_frame><socket_child_frame>{child}</socket_child_frame>
            <coordinates><Coordinate name='{coordinate}'/></coordinates></{kind}>")
    };
    let model = |joints: [(&str, &str, &str); 2], more: &str| {
        let [first, second] = joints;
        read(&format!(
            "<OpenSimDocument Version='40000'><Model name='m'><BodySet><objects>{}{}</objects></BodySet><JointSet><objects>{}{}</objects></JointSet>{more}</Model></OpenSimDocument>",
            body("a"),
            body("b"),
            joint(first.0, first.1, "/ground", "a", first.2),
            joint(second.0, second.1, "a", "b", second.2),
        ))
    };
    // The name of a joint, and the same name for a coordinate of another joint.
    let crossed = model([("SliderJoint", "j", "x"), ("PinJoint", "x", "y")], "");
    let refused = error(&crossed, Lumping::All, &[("x", 0.05)]);
    require_says(&refused, "both take a value by the name \"x\"");
    assert!(refused.hint().starts_with("j has"), "{refused}");
    assert_eq!(slides(&crossed, "x"), Err(refused));
    assert_eq!((slides(&crossed, "j"), slides(&crossed, "y")), (Ok(true), Ok(false)));
    require_says(&slides(&crossed, "z").unwrap_err(), "unknown joint \"z\", or it takes no value");
    // Two coordinates with the same name, also if a constraint names them.
    let joints = [("SliderJoint", "j", "q"), ("PinJoint", "k", "q")];
    require_says(
        &error(&model(joints, ""), Lumping::All, &[("q", 0.05)]),
        "both take a value by the name \"q\"",
    );
    let coupler = |leader: &str, follower: &str| {
        format!("<ConstraintSet><objects><CoordinateCouplerConstraint name='c'>
            <coupled_coordinates_function><Constant><value>0.3</value></Constant></coupled_coordinates_function>
            <independent_coordinate_names>{leader}</independent_coordinate_names>
            <dependent_coordinate_name>{follower}</dependent_coordinate_name></CoordinateCouplerConstraint></objects></ConstraintSet>")
    };
    for names in [("", "q"), ("q", "q")] {
        let coupled = model(joints, &coupler(names.0, names.1));
        require_says(&error(&coupled, Lumping::All, &[]), " cannot be read: ");
    }
    // A joint and its own coordinate.
    let straight = model([("SliderJoint", "j", "x"), ("PinJoint", "k", "y")], "");
    let refused = error(&straight, Lumping::All, &[("k", 0.1), ("y", 0.2)]);
    require_says(&refused, "\"k\" and \"y\" are the same joint, but both have a value");
    // A coordinate with the name of a joint that takes no value.
    let held = model([("WeldJoint", "x", "w"), ("PinJoint", "k", "x")], "");
    assert_eq!(value(&one(&held, Lumping::All, &[("x", 0.2)]), "k"), 0.2);
}
