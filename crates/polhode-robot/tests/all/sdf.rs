//! SDF files: poses in named frames, and the defaults of the specification.

use crate::common::{
    Matrix, applied, assert_close, assert_near, matrix_about, plus, read, times, transposed, written,
};
use polhode_robot::model::{GeometryShape, JointKind, Pose, RobotModel, Slot, Tensor};

/// Returns a pose as a position and R_z R_y R_x.
fn frame([x, y, z, roll, pitch, yaw]: [f64; 6]) -> ([f64; 3], Matrix) {
    ([x, y, z], times(matrix_about(2, yaw), times(matrix_about(1, pitch), matrix_about(0, roll))))
}

fn then(outer: ([f64; 3], Matrix), inner: ([f64; 3], Matrix)) -> ([f64; 3], Matrix) {
    (plus(outer.0, applied(outer.1, inner.0)), times(outer.1, inner.1))
}

fn inverse((p, r): ([f64; 3], Matrix)) -> ([f64; 3], Matrix) {
    (applied(transposed(r), p).map(|c| -c), transposed(r))
}

#[track_caller]
fn assert_pose(pose: &Pose, expected: ([f64; 3], Matrix)) {
    assert_close(pose.position, expected.0, 2e-15);
    assert_near(&pose.matrix(), &expected.1, 2e-15);
}

fn link<'m>(model: &'m RobotModel, name: &str) -> &'m polhode_robot::model::Link {
    model.links.iter().find(|link| link.name.text == name).unwrap()
}

const A: [f64; 6] = [0.3, -0.7, 1.1, 0.4, -1.1, 2.3];
const B: [f64; 6] = [-0.2, 0.5, 0.9, -0.8, 0.3, 1.7];
const C: [f64; 6] = [1.3, 0.2, -0.6, 1.9, 0.7, -0.4];
const D: [f64; 6] = [0.6, -0.1, 0.8, 0.2, -0.5, 0.9];

fn words(pose: [f64; 6]) -> String {
    pose.map(|c| c.to_string()).join(" ")
}

#[test]
fn poses_follow_the_frames_that_they_name() {
    let [a, b, c, d] = [A, B, C, D].map(words);
    let text = format!(
        r#"<sdf version="1.9"><model name="m"><pose>9 9 9 0 0 0</pose>
        <frame name="f" attached_to="one"><pose>{a}</pose></frame>
        <link name="two"><pose relative_to="f">{b}</pose>
          <inertial><pose>{c}</pose><mass> 2.5 </mass></inertial>
          <visual name="v"><pose relative_to="one">{d}</pose><geometry><sphere><radius>0.1</radius></sphere></geometry></visual>
        </link>
        <link name="one"><pose>{c}</pose></link>
        <joint name="j" type="revolute"><pose>{d}</pose><parent>one</parent><child>two</child>
          <axis><xyz>0.36 0.48 -0.8</xyz></axis></joint>
        <joint name="k" type="prismatic"><parent>world</parent><child>f</child>
          <axis><xyz expressed_in="__model__">0 0 1</xyz></axis></joint>
        </model></sdf>"#
    );
    let model = read(&text);
    assert!(model.notes.is_empty(), "{:?}", model.notes);
    let one = frame(C);
    let two = then(then(one, frame(A)), frame(B));
    assert_eq!(model.links.iter().map(|l| l.name.text.as_str()).collect::<Vec<_>>(), ["two", "one"]);
    assert_pose(&link(&model, "one").pose, one);
    assert_pose(&link(&model, "two").pose, two);
    assert_pose(&link(&model, "two").inertial.as_ref().unwrap().pose, frame(C));
    assert_pose(&link(&model, "two").geometry[0].pose, then(then(inverse(two), one), frame(D)));

    let [j, k] = model.joints.as_slice() else { panic!("two joints") };
    assert_eq!((j.kind, k.kind), (JointKind::Revolute, JointKind::Prismatic));
    assert_eq!((j.parent.as_ref().unwrap().text.as_str(), j.child.text.as_str()), ("one", "two"));
    assert_pose(&j.pose, then(inverse(one), two));
    assert_close(j.anchor, frame(D).0, 2e-15);
    assert_close(j.axis, applied(frame(D).1, [0.36, 0.48, -0.8]), 2e-15);
    // A frame represents the link that it is attached to.
    assert_eq!((&k.parent, k.child.text.as_str()), (&None, "one"));
    assert_close(k.axis, applied(transposed(one.1), [0.0, 0.0, 1.0]), 2e-15);
}

#[test]
fn degrees_and_quaternions_say_the_same_as_radians() {
    let half = 0.35_f64;
    let (s, c) = half.sin_cos();
    let axis = [0.48, -0.6, 0.64];
    let quaternion = format!("{} {} {} {c}", s * axis[0], s * axis[1], s * axis[2]);
    let degrees = [0.4_f64, -1.1, 2.3].map(|a| a.to_degrees().to_string()).join(" ");
    let text = format!(
        r#"<sdf version="1.10"><model name="m">
        <link name="d"><pose degrees="true">0.3 -0.7 1.1 {degrees}</pose></link>
        <link name="q"><pose rotation_format="quat_xyzw">1 2 3 {quaternion}</pose></link>
        <link name="bad"><pose rotation_format="quat_xyzw">1 2 3 0 0 0 0</pose></link>
        <link name="short"><pose>1 2 3</pose></link></model></sdf>"#
    );
    let model = read(&text);
    assert_pose(&link(&model, "d").pose, frame(A));
    assert_pose(
        &link(&model, "q").pose,
        ([1.0, 2.0, 3.0], crate::common::matrix_about_axis(axis, 2.0 * half)),
    );
    assert_eq!(link(&model, "bad").pose.unreadable.len(), 1);
    assert_eq!(link(&model, "short").pose.unreadable[0].text, "1 2 3");
}

#[test]
fn models_in_models_join_their_names_and_frames() {
    let [a, b, c] = [A, B, C].map(words);
    let text = format!(
        r#"<sdf version="1.8"><world name="w">
        <model name="outer"><pose>{a}</pose><static>true</static>
          <model name="inner"><pose>{b}</pose><link name="x"><pose>{c}</pose></link><link name="y"/></model>
          <link name="x"/>
          <joint name="j" type="fixed"><parent>inner::y</parent><child>x</child></joint>
          <joint name="by_model" type="ball"><parent>inner</parent><child>x</child></joint>
        </model>
        <model name="free"><link name="x"/></model>
        <include><uri>model://sun</uri></include></world></sdf>"#
    );
    let model = read(&text);
    let names: Vec<_> = model.links.iter().map(|l| (l.name.text.as_str(), l.is_static)).collect();
    assert_eq!(
        names,
        [("outer::inner::x", true), ("outer::inner::y", true), ("outer::x", true), ("free::x", false)]
    );
    assert_pose(&model.links[0].pose, then(then(frame(A), frame(B)), frame(C)));
    let ends: Vec<_> = model
        .joints
        .iter()
        .map(|j| (j.parent.as_ref().unwrap().text.as_str(), j.child.text.as_str()))
        .collect();
    assert_eq!(ends, [("outer::inner::y", "outer::x"), ("outer::inner::x", "outer::x")]);
    assert_eq!(model.notes.iter().map(|n| n.code).collect::<Vec<_>>(), ["read.include"]);
    assert!(model.notes[0].message.contains("model://sun"));
}

#[test]
fn what_is_left_out_stays_missing() {
    let text = r#"<sdf version="1.6"><model name="m"><link name="a"><inertial>
        <inertia><ixx>0.1<!-- -- --></ixx><iyy>
          2e-1 </iyy><izz></izz><ixy>0,01</ixy></inertia></inertial>
        <collision name="c"><geometry><ellipsoid><radii>1 2 3</radii></ellipsoid></geometry></collision></link>
        <link name="b"><inertial auto="true"/></link><link name="c"/></model></sdf>"#;
    let model = read(text);
    let inertial = model.links[0].inertial.as_ref().unwrap();
    assert!(matches!(&inertial.mass, Slot::Missing { name, .. } if name == "mass"));
    let Tensor::Six(six) = &inertial.tensor else { panic!("six") };
    assert_eq!(written(text, &six[0]), ("0.1", Some(0.1)));
    assert_eq!(written(text, &six[1]), ("2e-1", Some(0.2)));
    assert!(matches!(&six[2], Slot::Given(number) if number.value.is_none()));
    assert_eq!(written(text, &six[3]), ("0,01", None));
    assert!(matches!(&six[5], Slot::Missing { name, .. } if name == "iyz"));
    assert_eq!(model.links[0].geometry[0].shape, GeometryShape::Ellipsoid([1.0, 2.0, 3.0]));
    assert_eq!(model.links.iter().map(|l| l.from_geometry).collect::<Vec<_>>(), [false, true, false]);
    assert_eq!((&model.links[1].inertial, &model.links[2].inertial), (&None, &None));
}

#[test]
fn frames_in_a_circle_or_without_a_name_are_noted() {
    let text = r#"<sdf version="1.8"><model name="m">
        <link name="a"><pose relative_to="b">1 0 0 0 0 0</pose></link>
        <link name="b"><pose relative_to="a">0 1 0 0 0 0</pose></link>
        <link name="c"><pose relative_to="nobody">0 0 1 0 0 0</pose></link></model></sdf>"#;
    let model = read(text);
    assert_eq!(model.notes.iter().map(|n| n.code).collect::<Vec<_>>(), ["read.frame_circle", "read.frame"]);
    assert_eq!(model.links[2].pose.position, [0.0, 0.0, 1.0]);
}
