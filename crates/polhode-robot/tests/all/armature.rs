//! Inertia moved by the motor of a joint: the moment about the joint axis, and the rotor's inertia.

use polhode::math::Position;
use polhode_robot::inertia::of_lumps;
use polhode_robot::lump::{Drive, Lumping, lump};
use polhode_robot::model::RobotModel;

use crate::common::read;

fn drives(model: &RobotModel, link: &str) -> Vec<Drive> {
    lump(model, Lumping::Subtree(link), &[]).unwrap().remove(0).drives
}

/// Returns n·I n for the tensor about a point of the axis.
fn about_axis(model: &RobotModel, link: &str, axis: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    let body = lump(model, Lumping::Subtree(link), &[]).unwrap().remove(0).properties;
    let tensor = body.inertia_about(Position::new(x, y, z)).matrix();
    let norm = axis.iter().map(|c| c * c).sum::<f64>();
    (0..3).map(|i| (0..3).map(|j| axis[i] * tensor[i][j] * axis[j]).sum::<f64>()).sum::<f64>() / norm
}

#[track_caller]
fn assert_drive(drive: &Drive, joint: &str, inertia: f64, armature: f64) {
    assert_eq!(drive.joint, joint);
    assert!((drive.inertia / inertia - 1.0).abs() < 1e-13, "{} {inertia}", drive.inertia);
    assert!((drive.armature - armature).abs() <= 1e-15 * armature, "{} {armature}", drive.armature);
}

#[test]
fn the_armature_of_a_joint_is_added_to_what_hangs_from_it() {
    let model = read(
        r#"<mujoco><worldbody><body name="a"><joint name="j" axis="0 0 1" armature="0.05"/>
            <inertial pos="0.2 0 0" mass="1" diaginertia="0.001 0.004 0.004"/></body></worldbody></mujoco>"#,
    );
    let [drive] = &drives(&model, "a")[..] else { panic!("a drive") };
    assert_drive(drive, "j", 0.044, 0.05);
    let report = of_lumps(&model, Lumping::Subtree("a"), &[], false).unwrap().remove(0);
    let told =
        "joint j moves 0.044 kg·m² about its axis, or 0.094 kg·m² including its armature of 0.05 kg·m²";
    assert_eq!(
        report.findings.iter().map(|f| (f.code, f.message.as_str())).collect::<Vec<_>>(),
        [("joint.armature", told)]
    );
    let json = report.to_json();
    let armature = &json["source"]["armatures"][0];
    assert_eq!((armature["joint"].as_str(), armature["slides"].as_bool()), (Some("j"), Some(false)));
    for (key, right) in [("inertia", 0.044), ("armature", 0.05), ("total", 0.094)] {
        assert!((armature[key].as_f64().unwrap() - right).abs() < 1e-15, "{key}");
    }
    // A joint without armature has no finding.
    let bare = read(
        r#"<mujoco><worldbody><body name="a"><joint name="j"/><geom size="0.1"/></body></worldbody></mujoco>"#,
    );
    assert_eq!(of_lumps(&bare, Lumping::Subtree("a"), &[], false).unwrap()[0].findings, []);
}

#[test]
fn actuators_add_their_rotors_by_the_square_of_their_gears() {
    let model = read(
        r#"<mujoco><default><joint armature="0.003"/><motor armature="2e-5" gear="30"/>
              <default class="big"><position armature="7e-5"/></default></default>
            <worldbody><body name="a" pos="1 2 3"><joint name="t" axis="1 -2 0.5" pos="0.1 -0.2 0.3"/>
              <joint name="s" type="slide" axis="0 3 4" armature="0.25"/>
              <inertial pos="0.2 0.1 -0.3" mass="1.7" fullinertia="0.031 0.042 0.053 0.001 -0.002 0.003"/>
              <body name="b" pos="0 0 0.4" quat="0.8 0 0.6 0"><joint name="below" armature="9"/><geom size="0.1" mass="0.3"/></body>
            </body></worldbody>
            <actuator><motor joint="t"/><position class="big" joint="t" gear="-5 0 0"/><motor joint="s" armature="0"/>
              <motor joint="below" armature="4"/></actuator></mujoco>"#,
    );
    let found = drives(&model, "a");
    let [turn, slide] = &found[..] else { panic!("two drives") };
    let right = about_axis(&model, "a", [1.0, -2.0, 0.5], [0.1, -0.2, 0.3]);
    // The expected armature is 0.003 + 30² · 2e-5 + 5² · 7e-5.
    assert_drive(turn, "t", right, 0.003 + 0.018 + 0.00175);
    assert!(slide.slides);
    assert_drive(slide, "s", 2.0, 0.25);
}

#[test]
fn rotors_of_drake_and_physx_are_reflected() {
    let inertial = r#"<inertial><origin xyz="0.2 0.1 -0.3"/><mass value="1.7"/>
        <inertia ixx="0.031" iyy="0.042" izz="0.053" ixy="0.001" ixz="-0.002" iyz="0.003"/></inertial>"#;
    let urdf = format!(
        r#"<robot xmlns:drake="http://drake.mit.edu" name="r"><link name="base"/><link name="arm">{inertial}</link>
            <joint name="j" type="continuous"><origin xyz="1 2 3"/><parent link="base"/><child link="arm"/><axis xyz="0.6 0 0.8"/></joint>
            <transmission name="t"><type>SimpleTransmission</type><joint name="j"/>
              <actuator name="m"><mechanicalReduction>7</mechanicalReduction><drake:rotor_inertia value="3e-5"/><drake:gear_ratio value="120"/>
              </actuator></transmission></robot>"#
    );
    let model = read(&urdf);
    let right = about_axis(&model, "arm", [0.6, 0.0, 0.8], [0.0; 3]);
    assert_drive(&drives(&model, "arm")[0], "j", right, 120.0 * 120.0 * 3e-5);
    // URDF has no key for a rotor's inertia: a reduction alone adds nothing.
    let bare = urdf.replace("<drake:rotor_inertia value=\"3e-5\"/>", "");
    assert_eq!(drives(&read(&bare), "arm")[0].armature, 0.0);

    let model = read(
        r#"<sdf version="1.9" xmlns:drake="drake.mit.edu"><model name="m"><link name="base"><inertial><mass>1</mass></inertial></link>
            <link name="arm"><pose>0 0 1 0 0 0</pose><inertial><pose>0.2 0.1 -0.3 0 0 0</pose><mass>1.7</mass><inertia><ixx>0.031</ixx>
            <iyy>0.042</iyy><izz>0.053</izz><ixy>0.001</ixy></inertia></inertial></link>
            <joint name="j" type="revolute"><pose>0.1 0.2 0.3 0 0 0</pose><parent>base</parent><child>arm</child>
              <axis><xyz>0 0.6 0.8</xyz></axis><drake:rotor_inertia>1.5e-5</drake:rotor_inertia><drake:gear_ratio>80</drake:gear_ratio></joint>
            </model></sdf>"#,
    );
    let right = about_axis(&model, "arm", [0.0, 0.6, 0.8], [0.1, 0.2, 0.3]);
    assert_drive(&drives(&model, "arm")[0], "j", right, 80.0 * 80.0 * 1.5e-5);

    // 250 g·cm² in a layer with the units cm and g.
    let model = read(
        "#usda 1.0\n(\n metersPerUnit = 0.01\n kilogramsPerUnit = 0.001\n)\n\
         def Xform \"base\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\"])\n{\n bool physics:rigidBodyEnabled = 0\n}\n\
         def Xform \"arm\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"])\n{\n float physics:mass = 1700\n \
         point3f physics:centerOfMass = (20, 10, -30)\n float3 physics:diagonalInertia = (310000, 420000, 530000)\n}\n\
         def PhysicsRevoluteJoint \"j\"\n{\n rel physics:body0 = </base>\n rel physics:body1 = </arm>\n uniform token physics:axis = \"Y\"\n \
         float physxJoint:armature = 250\n}\n",
    );
    let right = about_axis(&model, "/arm", [0.0, 1.0, 0.0], [0.0; 3]);
    assert_drive(&drives(&model, "/arm")[0], "/j", right, 2.5e-5);
}

#[test]
fn an_armature_that_is_no_inertia_is_told_and_not_added() {
    for armature in ["-0.05", "nan", "much"] {
        let text = format!(
            "<mujoco><worldbody><body name=\"a\"><joint name=\"j\" armature=\"{armature}\"/><geom size=\"0.1\"/></body></worldbody></mujoco>"
        );
        let model = read(&text);
        let report = of_lumps(&model, Lumping::Subtree("a"), &[], false).unwrap().remove(0);
        assert_eq!(report.findings[0].code, "joint.armature");
        assert!(report.findings[0].message.contains("it is not added"), "{}", report.findings[0].message);
        let found = polhode_robot::check::check(&model, &[]);
        assert!(
            found.iter().any(|f| f.code == "joint.armature" && f.subject == "j"),
            "{armature}: {found:?}"
        );
    }
}
