//! OpenSim models of three versions.

use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::inertia::of_lumps;
use polhode_robot::lump::Lumping;
use polhode_robot::model::{JointKind, ModelFormat, RobotModel, Tensor};

use crate::common::{
    applied, assert_close, assert_near, matrix_about, matrix_about_axis, plus, read, refused, require_says,
    times, transposed, written,
};
use crate::mimic::{error, one};

const NEW: &str = r#"<OpenSimDocument Version="40000"><Model name="leg"><Ground name="ground"/>
  <BodySet name="bodyset"><objects>
    <Body name="thigh"><mass>9.3014</mass><mass_center>0.01 -0.17 0.02</mass_center>
      <inertia>0.1339 0.0351 0.1412 0.001 -0.002 0.003</inertia></Body>
    <Body name="shank"><mass>3.7</mass><mass_center>0 -0.18 0</mass_center><inertia>0.05 0.005 0.0511 0 0 0</inertia></Body>
  </objects></BodySet>
  <JointSet name="jointset"><objects>
    <FreeJoint name="root"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/thigh</socket_child_frame></FreeJoint>
    <PinJoint name="knee"><socket_parent_frame>thigh_offset</socket_parent_frame><socket_child_frame>shank_offset</socket_child_frame>
      <frames>
        <PhysicalOffsetFrame name="thigh_offset"><socket_parent>/bodyset/thigh</socket_parent><translation>0.1 -0.4 0</translation><orientation>0.3 -0.4 0.5</orientation></PhysicalOffsetFrame>
        <PhysicalOffsetFrame name="shank_offset"><socket_parent>/bodyset/shank</socket_parent><translation>0 0.05 0.02</translation><orientation>0 0.2 0</orientation></PhysicalOffsetFrame>
      </frames></PinJoint>
  </objects></JointSet></Model></OpenSimDocument>"#;

const OLD: &str = r#"<OpenSimDocument Version="20302"><Model name="leg"><BodySet><objects>
    <Body name="ground"><mass>0</mass><Joint/></Body>
    <Body name="thigh"><mass>9.3014</mass><mass_center>0.01 -0.17 0.02</mass_center>
      <inertia_xx>0.1339</inertia_xx><inertia_yy>0.0351</inertia_yy><inertia_zz>0.1412</inertia_zz>
      <inertia_xy>0.001</inertia_xy><inertia_xz>-0.002</inertia_xz><inertia_yz>0.003</inertia_yz>
      <Joint><FreeJoint name="root"><parent_body>ground</parent_body></FreeJoint></Joint></Body>
    <Body name="shank"><mass>3.7</mass><mass_center>0 -0.18 0</mass_center>
      <inertia_xx>0.05</inertia_xx><inertia_yy>0.005</inertia_yy><inertia_zz>0.0511</inertia_zz>
      <inertia_xy>0</inertia_xy><inertia_xz>0</inertia_xz><inertia_yz>0</inertia_yz>
      <Joint><PinJoint name="knee"><parent_body>thigh</parent_body>
        <location_in_parent>0.1 -0.4 0</location_in_parent><orientation_in_parent>0.3 -0.4 0.5</orientation_in_parent>
        <location>0 0.05 0.02</location><orientation>0 0.2 0</orientation></PinJoint></Joint></Body>
  </objects></BodySet></Model></OpenSimDocument>"#;

/// Returns the model with sockets written as connectors, as by development versions of 3.3.
fn between() -> String {
    let mut text = NEW.replace("40000", "30501");
    for name in ["parent_frame", "child_frame", "parent"] {
        let open = format!("<connectors><Connector_PhysicalFrame_ name=\"{name}\"><connectee_name>");
        text = text.replace(&format!("<socket_{name}>"), &open);
        text = text.replace(
            &format!("</socket_{name}>"),
            "</connectee_name></Connector_PhysicalFrame_></connectors>",
        );
    }
    // One list of connectors for both ends.
    text.replace("</connectors><connectors>", "")
}

fn assert_leg(model: &RobotModel) {
    assert_eq!((model.format, model.name.as_deref()), (ModelFormat::Osim, Some("leg")));
    let names: Vec<_> = model.links.iter().map(|link| link.name.text.as_str()).collect();
    assert_eq!(names, ["thigh", "shank"]);
    let LinkMass::Body(body) = link_mass(model.format, &model.links[0]).unwrap() else { panic!("a body") };
    assert_eq!(body.properties.mass(), 9.3014);
    assert_close(body.properties.center_of_mass().to_array(), [0.01, -0.17, 0.02], 0.0);
    let tensor = [[0.1339, 0.001, -0.002], [0.001, 0.0351, 0.003], [-0.002, 0.003, 0.1412]];
    assert_near(&body.properties.inertia().matrix(), &tensor, 0.0);
    let joints: Vec<_> = model
        .joints
        .iter()
        .map(|j| {
            (j.name.text.as_str(), j.kind, j.parent.as_ref().map(|p| p.text.as_str()), j.child.text.as_str())
        })
        .collect();
    assert_eq!(
        joints,
        [("root", JointKind::Free, None, "thigh"), ("knee", JointKind::Revolute, Some("thigh"), "shank")]
    );
    // X_thigh_shank = X_thigh_joint X_shank_joint⁻¹, with angles about rotating axes.
    let knee = &model.joints[1];
    let outer = times(times(matrix_about(0, 0.3), matrix_about(1, -0.4)), matrix_about(2, 0.5));
    let inner = matrix_about(1, 0.2);
    let attitude = times(outer, transposed(inner));
    assert_near(&knee.pose.matrix(), &attitude, 1e-15);
    assert_close(knee.pose.position, plus([0.1, -0.4, 0.0], applied(attitude, [0.0, -0.05, -0.02])), 1e-15);
    assert_close(knee.axis, applied(inner, [0.0, 0.0, 1.0]), 1e-15);
    assert_eq!(knee.anchor, [0.0, 0.05, 0.02]);
}

#[test]
fn a_model_is_the_same_in_every_version() {
    assert_leg(&read(NEW));
    assert_leg(&read(&between()));
    let old = read(OLD);
    assert_leg(&old);
    let Tensor::Six(six) = &old.links[0].inertial.as_ref().unwrap().tensor else { panic!("six") };
    assert_eq!(written(OLD, &six[4]), ("-0.002", Some(-0.002)));
}

#[test]
fn other_documents_of_opensim_are_refused() {
    assert!(
        refused("<OpenSimDocument Version='40000'><AnalyzeTool/></OpenSimDocument>")
            .to_string()
            .contains("<Model>")
    );
    assert!(
        refused("<OpenSimDocument Version='10904'><Model/></OpenSimDocument>").to_string().contains("20302")
    );
}

#[test]
fn frames_that_go_round_end() {
    let text = NEW.replace("<socket_parent>/bodyset/thigh<", "<socket_parent>thigh_offset<");
    assert_eq!(read(&text).joints.len(), 2);
}

/// Rotations about rotating axes, and translations along the parent's axes.
#[test]
fn a_custom_joint_stands_where_its_functions_are_at_zero() {
    let custom = |transform: &str| {
        let text = NEW.replace("PinJoint", "CustomJoint");
        read(&text.replace("</frames></CustomJoint>", &format!("</frames>{transform}</CustomJoint>")))
    };
    let axis = |name: &str, axis: &str, function: &str| {
        format!(
            "<TransformAxis name='{name}'><coordinates>q</coordinates><axis>{axis}</axis>{function}</TransformAxis>"
        )
    };
    let all = |axes: &[String]| format!("<SpatialTransform>{}</SpatialTransform>", axes.concat());
    let read_all = all(&[
        axis(
            "rotation1",
            "0 0.6 0.8",
            "<LinearFunction name='function'><coefficients>1 0.3</coefficients></LinearFunction>",
        ),
        axis(
            "rotation2",
            "1 0 0",
            "<function><PolynomialFunction><coefficients>0.1 0.7 -0.2</coefficients></PolynomialFunction></function>",
        ),
        axis("rotation3", "0 1 0", ""),
        axis(
            "translation1",
            "1 0 0",
            "<SimmSpline name='function'><x>-1 0 1</x><y>0.3 -0.05 0.2</y></SimmSpline>",
        ),
        axis(
            "translation2",
            "0 1 0",
            "<MultiplierFunction name='function'><function><Constant><value>-0.4</value></Constant></function><scale>1.1</scale></MultiplierFunction>",
        ),
    ]);
    let knee = &custom(&read_all).joints[1];
    let outer = times(times(matrix_about(0, 0.3), matrix_about(1, -0.4)), matrix_about(2, 0.5));
    let moved = times(matrix_about_axis([0.0, 0.6, 0.8], 0.3), matrix_about(0, -0.2));
    let attitude = times(times(outer, moved), transposed(matrix_about(1, 0.2)));
    assert_near(&knee.pose.matrix(), &attitude, 1e-15);
    let way = plus(applied(outer, [-0.05, -0.44, 0.0]), applied(attitude, [0.0, -0.05, -0.02]));
    assert_close(knee.pose.position, plus([0.1, -0.4, 0.0], way), 1e-15);
    assert_eq!(one(&custom(&read_all), Lumping::All, &[]).links.len(), 2);
    // Without functions it agrees with a pin joint at zero.
    let pin = one(&read(NEW), Lumping::All, &[]).properties;
    let custom_pin = one(&custom(""), Lumping::All, &[]);
    assert_eq!(custom_pin.properties, pin);
    assert_eq!(custom_pin.held, ["root", "knee"]);
    let heading =
        |model: &RobotModel| of_lumps(model, Lumping::All, &[], false).unwrap().remove(0).source.description;
    assert!(heading(&read(NEW)).contains("joints at zero, root as in the file (takes no value)"));
    assert!(heading(&custom("")).contains("leg, root and knee as in the file"));

    let unit = "<Constant name='function'><value>0.1</value></Constant>";
    for (wrong, why) in [
        (
            axis("rotation1", "0 0 1", "<SimmSpline name='function'><x>-1 1</x><y>0.3 0.2</y></SimmSpline>"),
            "SimmSpline",
        ),
        (axis("rotation1", "0 0 1", "<Sine name='function'/>"), "Sine"),
        (axis("rotation1", "0 0 1", "<Sine/>"), "Sine"),
        (axis("rotation1", "0 0 1", "<Constant name='function'><value>0,1</value></Constant>"), "Constant"),
        (axis("translation3", "0 0 2", unit), "length 1"),
        (axis("translation4", "0 0 1", unit), "translation4"),
        (axis("translation3", "0 0 1", unit).repeat(2), "occurs twice"),
    ] {
        let model = custom(&all(&[wrong]));
        let refused = error(&model, Lumping::All, &[]);
        require_says(&refused, "the position of the child of joint \"knee\" is unknown");
        assert!(refused.to_string().contains(why), "{refused}");
        // A descendant of the joint has a known pose.
        assert_eq!(one(&model, Lumping::Subtree("shank"), &[]).properties.mass(), 3.7);
    }
    for text in [
        NEW.replace("PinJoint", "EllipsoidJoint"),
        NEW.replace("</frames></PinJoint>", "</frames><reverse>true</reverse></PinJoint>"),
    ] {
        require_says(&error(&read(&text), Lumping::All, &[]), "is unknown: ");
    }
}
