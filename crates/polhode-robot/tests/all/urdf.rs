//! URDF files: their contents and text positions.

use crate::common::{assert_near, read, written};
use polhode_robot::model::{GeometryShape, JointKind, ModelFormat, Role, Slot, Tensor};
use polhode_robot::read::format_of;

const ARM: &str = r#"<?xml version="1.0"?>
<!-- -- a robot -- -->
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="base"/>
  <link name="upper &amp; lower">
    <inertial>
      <origin xyz="0.1 -0.2
	0.35" rpy="0.4 -1.1 2.3"/>
      <mass value=" 1.559 "/>
      <inertia ixx="0.0026294" ixy='-1e-4' ixz="2.5e-5" iyy="0.002335" iyz="7e-05" izz="1676359E-6"/>
    </inertial>
    <visual>
      <origin xyz="0 0 1"/>
      <geometry><mesh filename="package://arm/meshes/upper.stl" scale="0.001 0.001 -0.001"/></geometry>
    </visual>
    <collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision>
    <collision><geometry><cylinder radius="0.1" length="0,5"/></geometry></collision>
    <collision><geometry><sphere radius="0.25"/></geometry></collision>
  </link>
  <joint name="turn" type="continuous">
    <origin xyz="0.3 0.2 -0.7" rpy="-0.3 0.8 1.9"/>
    <parent link="base"/><child link="upper &amp; lower"/>
    <axis xyz="0 0.6 -0.8"/>
  </joint>
  <joint name="stay" type="fixed"><parent link="base"/><child link="tool"/></joint>
  <transmission name="t"><joint name="turn"/></transmission>
  <controller:x foo:bar="1"/>
</robot>
"#;

#[test]
fn every_number_keeps_its_text_and_its_place() {
    let model = read(ARM);
    assert_eq!((model.format, model.name.as_deref()), (ModelFormat::Urdf, Some("arm")));
    assert_eq!(model.text, ARM);
    assert!(model.notes.is_empty(), "{:?}", model.notes);
    let [base, upper] = model.links.as_slice() else { panic!("two links") };
    assert_eq!((base.name.text.as_str(), &base.inertial), ("base", &None));
    assert_eq!(
        (upper.name.text.as_str(), &ARM[upper.name.span.clone()]),
        ("upper & lower", "upper &amp; lower")
    );

    let inertial = upper.inertial.as_ref().unwrap();
    assert!(
        ARM[inertial.span.clone()].starts_with("<inertial>")
            && ARM[inertial.span.clone()].ends_with("</inertial>")
    );
    assert_eq!(written(ARM, &inertial.mass), ("1.559", Some(1.559)));
    let Tensor::Six(six) = &inertial.tensor else { panic!("six") };
    let expected = [
        ("0.0026294", Some(0.002_629_4)),
        ("0.002335", Some(0.002_335)),
        ("1676359E-6", Some(1.676_359)),
        ("-1e-4", Some(-1e-4)),
        ("2.5e-5", Some(2.5e-5)),
        ("7e-05", Some(7e-5)),
    ];
    assert_eq!(six.each_ref().map(|slot| written(ARM, slot)), expected);
}

#[test]
fn an_attitude_is_yaw_after_pitch_after_roll_about_fixed_axes() {
    let model = read(ARM);
    let pose = &model.links[1].inertial.as_ref().unwrap().pose;
    assert_eq!(pose.position, [0.1, -0.2, 0.35]);
    let [roll, pitch, yaw] = [0.4_f64, -1.1, 2.3];
    let x = crate::common::matrix_about(0, roll);
    let y = crate::common::matrix_about(1, pitch);
    let z = crate::common::matrix_about(2, yaw);
    assert_near(&pose.matrix(), &crate::common::times(z, crate::common::times(y, x)), 1e-15);
}

#[test]
fn shapes_have_the_sizes_that_are_written_and_nan_for_those_that_are_none() {
    let model = read(ARM);
    let shapes = &model.links[1].geometry;
    assert_eq!(shapes.iter().map(|g| g.role).collect::<Vec<_>>()[..2], [Role::Visual, Role::Collision]);
    assert_eq!(shapes[0].pose.position, [0.0, 0.0, 1.0]);
    let GeometryShape::Mesh { uri, path, scale } = &shapes[0].shape else { panic!("a mesh") };
    assert_eq!((uri.text.as_str(), *scale), ("package://arm/meshes/upper.stl", [1e-3, 1e-3, -1e-3]));
    assert!(path.as_ref().is_err_and(|why| why.contains("--root")), "{path:?}");
    assert_eq!(shapes[1].shape, GeometryShape::Box([0.1, 0.2, 0.3]));
    let GeometryShape::Cylinder { radius, length } = shapes[2].shape else { panic!("a cylinder") };
    assert!(radius == 0.1 && length.is_nan());
    assert_eq!(shapes[3].shape, GeometryShape::Sphere(0.25));
}

#[test]
fn joints_say_what_hangs_on_what_and_how() {
    let model = read(ARM);
    let [turn, stay] = model.joints.as_slice() else { panic!("two joints, the transmission's is none") };
    assert_eq!((turn.kind, stay.kind), (JointKind::Revolute, JointKind::Fixed));
    assert_eq!(turn.parent.as_ref().unwrap().text, "base");
    assert_eq!(turn.child.text, "upper & lower");
    assert_eq!((turn.axis, stay.axis), ([0.0, 0.6, -0.8], [1.0, 0.0, 0.0]));
    assert_eq!(turn.pose.position, [0.3, 0.2, -0.7]);
}

#[test]
fn what_is_no_number_or_not_there_is_kept_for_the_checks() {
    let text = r#"<robot><link name="a"><inertial><origin xyz="1 2,5 nan" rpy="0 0"/><mass value="0,5"/>
        <inertia ixx="1kg" ixy="" ixz="1e400" iyy="-inf" iyz="NaN"/></inertial></link>
        <link name="b"><inertial/></link></robot>"#;
    let model = read(text);
    let inertial = model.links[0].inertial.as_ref().unwrap();
    assert_eq!(written(text, &inertial.mass), ("0,5", None));
    let Tensor::Six(six) = &inertial.tensor else { panic!("six") };
    assert_eq!(written(text, &six[0]), ("1kg", None));
    assert_eq!(written(text, &six[1]), ("-inf", Some(f64::NEG_INFINITY)));
    assert!(
        matches!(&six[2], Slot::Missing { name, span } if name == "izz" && text[span.clone()].starts_with("<inertia "))
    );
    assert_eq!(written(text, &six[3]), ("", None));
    assert_eq!(written(text, &six[4]), ("1e400", Some(f64::INFINITY)));
    assert!(written(text, &six[5]).1.unwrap().is_nan());
    assert_eq!(six[4].finite(), None);

    let pose = &inertial.pose;
    assert_eq!(pose.position, [1.0, 0.0, 0.0]);
    let bad: Vec<_> = pose.unreadable.iter().map(|n| &text[n.span.clone()]).collect();
    assert_eq!(bad, ["2,5", "nan", "0 0"]);

    let empty = model.links[1].inertial.as_ref().unwrap();
    assert!(matches!(&empty.mass, Slot::Missing { name, .. } if name == "mass"));
    assert!(matches!(empty.tensor, Tensor::Missing(_)));
}

#[test]
fn a_macro_is_refused_with_the_way_to_expand_it() {
    let texts = [
        r#"<robot xmlns:xacro="x"><xacro:macro name="leg"/></robot>"#,
        r#"<robot xmlns:xacro="x"><link name="${side}_leg"/></robot>"#,
        r#"<robot xmlns:xacro="x"><link name="leg"><xacro:insert_block name="mass"/></link></robot>"#,
        r#"<robot xmlns:xacro="x"><link name="leg"><visual><geometry><mesh filename="$(find a)/b.stl"/></geometry></visual></link></robot>"#,
        r#"<robot xmlns:xacro="x"><link name="leg"><visual><origin xyz="0 0 ${l}"/></visual></link></robot>"#,
    ];
    for text in texts {
        let error = crate::common::refused(text);
        assert!(error.hint().unwrap().contains("xacro model.xml > model.urdf"), "{error}");
    }
    // An expression in a comment is not a macro.
    read(r#"<robot xmlns:xacro="x"><!-- ${l} --><link name="leg"/></robot>"#);
}

#[test]
fn the_root_element_says_the_language() {
    assert_eq!(format_of(ARM), Some(ModelFormat::Urdf));
    assert_eq!(format_of("\u{feff}\n<sdf version='1.7'>"), Some(ModelFormat::Sdf));
    assert_eq!(format_of("<mujoco/>"), Some(ModelFormat::Mjcf));
    assert_eq!(format_of("<!-- <robot> --><html>"), None);
    assert_eq!(format_of("robot"), None);
    assert!(
        crate::common::refused("<html></html>")
            .to_string()
            .contains("expected <robot> (URDF), <sdf>, <mujoco> or <OpenSimDocument>")
    );
}
