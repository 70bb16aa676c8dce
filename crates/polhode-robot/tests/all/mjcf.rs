//! MJCF files: nested bodies, half sizes, degrees, default classes.

use crate::common::{
    Matrix, applied, assert_close, assert_near, matrix_about, matrix_about_axis, plus, read, times, written,
};
use polhode_robot::body::link_mass;
use polhode_robot::check::check;
use polhode_robot::inertia::{of_link, of_lumps};
use polhode_robot::link_table::LinkTable;
use polhode_robot::lump::Lumping;
use polhode_robot::model::{GeometryShape, JointKind, Pose, Role, Slot, Tensor};

#[track_caller]
fn assert_attitude(pose: &Pose, expected: &Matrix) {
    assert_near(&pose.matrix(), expected, 2e-15);
}

#[test]
fn bodies_hang_in_bodies_by_their_joints_or_fixed() {
    let text = r#"<mujoco model="m"><compiler angle="radian"/><worldbody><light/><geom type="plane" size="1 1 1"/>
      <body name="a" pos="0.3 -0.7 1.1" axisangle="1 -2 3 0.9"><freejoint/>
        <frame pos="0.1 0.2 0.3" euler="0.4 0.5 -0.6">
          <body name="b" pos="-0.4 0.6 0.2" quat="2 0.4 -0.6 0.8">
            <joint name="h" axis="0 1 0" pos="0.1 0.2 0.3"/><joint name="s" type="slide" axis="1 2 2"/>
          </body>
        </frame>
        <body pos="1 0 0"/>
      </body></worldbody></mujoco>"#;
    let model = read(text);
    assert!(model.notes.is_empty(), "{:?}", model.notes);
    assert_eq!(model.links.iter().map(|l| l.name.text.as_str()).collect::<Vec<_>>(), ["a", "b", "body 3"]);
    let a = matrix_about_axis([1.0, -2.0, 3.0], 0.9);
    let f = times(times(matrix_about(0, 0.4), matrix_about(1, 0.5)), matrix_about(2, -0.6));
    let angle = 2.0 * (1.16_f64.sqrt() / 2.0).atan();
    let b = matrix_about_axis([0.4, -0.6, 0.8], angle);
    let in_a = (plus([0.1, 0.2, 0.3], applied(f, [-0.4, 0.6, 0.2])), times(f, b));
    assert_attitude(&model.links[0].pose, &a);
    assert_attitude(&model.links[1].pose, &times(a, in_a.1));
    assert_close(model.links[1].pose.position, plus([0.3, -0.7, 1.1], applied(a, in_a.0)), 2e-15);

    let joints: Vec<_> = model
        .joints
        .iter()
        .map(|j| (j.kind, j.parent.as_ref().map(|p| p.text.as_str()), j.child.text.as_str()))
        .collect();
    assert_eq!(
        joints,
        [
            (JointKind::Free, None, "a"),
            (JointKind::Revolute, Some("a"), "b"),
            (JointKind::Prismatic, Some("a"), "b"),
            (JointKind::Fixed, Some("a"), "body 3"),
        ]
    );
    let h = &model.joints[1];
    assert_eq!((h.axis, h.anchor), ([0.0, 1.0, 0.0], [0.1, 0.2, 0.3]));
    assert_close(h.pose.position, in_a.0, 1e-15);
    assert_attitude(&h.pose, &in_a.1);
}

#[test]
fn attitudes_in_all_forms() {
    let turn = |body: &str, settings: &str| {
        let model = read(&format!("<mujoco>{settings}<worldbody><body {body}/></worldbody></mujoco>"));
        model.links[0].pose.clone()
    };
    let [a, b, c] = [20.0_f64, -50.0, 110.0].map(f64::to_radians);
    let (x, y, z) = (matrix_about(0, a), matrix_about(1, b), matrix_about(2, c));
    assert_attitude(&turn(r#"euler="20 -50 110""#, ""), &times(times(x, y), z));
    assert_attitude(&turn(r#"euler="20 -50 110""#, r#"<compiler eulerseq="XYZ"/>"#), &times(times(z, y), x));
    let zyx = times(times(matrix_about(2, a), matrix_about(1, b)), matrix_about(0, c));
    assert_attitude(&turn(r#"euler="20 -50 110""#, r#"<compiler eulerseq="zyx"/>"#), &zyx);
    assert_attitude(
        &turn(r#"axisangle="2 -1 2 70""#, ""),
        &matrix_about_axis([2.0, -1.0, 2.0], 70_f64.to_radians()),
    );

    // The columns are the axes.
    let r = matrix_about_axis([0.3, 0.8, -0.5], 2.9);
    let column = |k: usize| [r[0][k], r[1][k], r[2][k]];
    let sloped: [f64; 3] = std::array::from_fn(|k| 3.0 * column(1)[k] + 0.7 * column(0)[k]);
    let axes: Vec<String> =
        column(0).map(|c| 2.0 * c).into_iter().chain(sloped).map(|c| c.to_string()).collect();
    assert_attitude(&turn(&format!(r#"xyaxes="{}""#, axes.join(" ")), ""), &r);

    // The shortest rotation, about z × n.
    let n = [0.36, -0.48, -0.8];
    let expected = matrix_about_axis([0.48, 0.36, 0.0], (-0.8_f64).acos());
    assert_attitude(&turn(r#"zaxis="0.72 -0.96 -1.6""#, ""), &expected);
    assert_close(applied(expected, [0.0, 0.0, 1.0]), n, 2e-15);
    assert_attitude(&turn(r#"zaxis="0 0 -1""#, ""), &matrix_about(0, std::f64::consts::PI));

    for none in [
        r#"quat="0 0 0 0""#,
        r#"zaxis="0 0 0""#,
        r#"euler="1 2""#,
        r#"xyaxes="1 0 0 2 0 0""#,
        r#"axisangle="0 0 0 3""#,
    ] {
        assert_eq!(turn(none, "").unreadable.len(), 1, "{none}");
    }
}

#[test]
fn inertials_in_both_forms_and_none() {
    let text = r#"<mujoco><worldbody>
      <body name="f"><inertial pos="0.1 0.2 0.3" mass="1.559" fullinertia="0.1 0.2 0.25 -0.01 0.02 0.03"/></body>
      <body name="d"><inertial pos="0 0 0" euler="0 90 0" mass="2" diaginertia="0.1 0,2 0.3 0.4"/><geom size="1"/></body>
      <body name="n"><inertial pos="0 0 0" mass="1"/></body>
      <body name="g"><geom size="0.1"/></body><body name="e"/></worldbody></mujoco>"#;
    let model = read(text);
    let inertial = |k: usize| model.links[k].inertial.as_ref().unwrap();
    assert_eq!(written(text, &inertial(0).mass), ("1.559", Some(1.559)));
    let Tensor::Six(six) = &inertial(0).tensor else { panic!("six") };
    // The order M11 M22 M33 M12 M13 M23 is xx yy zz xy xz yz.
    assert_eq!(six.each_ref().map(Slot::finite), [0.1, 0.2, 0.25, -0.01, 0.02, 0.03].map(Some));
    let Tensor::Diagonal(three) = &inertial(1).tensor else { panic!("three") };
    assert_eq!(written(text, &three[1]), ("0,2", None));
    assert_attitude(&inertial(1).pose, &matrix_about(1, 90_f64.to_radians()));
    assert_eq!((model.notes[0].code, &text[model.notes[0].span.clone()]), ("read.numbers", "0.4"));
    assert!(matches!(inertial(2).tensor, Tensor::Missing(_)));
    assert_eq!(
        model.links.iter().map(|l| l.from_geometry).collect::<Vec<_>>(),
        [false, false, false, true, false]
    );

    let always = read(&text.replacen(
        "<mujoco>",
        r#"<mujoco><compiler inertiafromgeom="true" balanceinertia="true" boundmass="0"/>"#,
        1,
    ));
    assert_eq!((&always.links[1].inertial, always.links[1].from_geometry), (&None, true));
    assert_eq!(always.notes[0].code, "read.numbers");
    let never = read(&text.replacen("<mujoco>", r#"<mujoco><compiler inertiafromgeom="false"/>"#, 1));
    assert!(!never.links[3].from_geometry);
}

#[test]
fn geoms_have_halves_and_what_their_classes_say() {
    let text = r#"<mujoco>
      <compiler meshdir="assets/"/>
      <default class="all"><geom type="capsule" size="0.1 0.2"/><mesh scale="2 2 2"/>
        <default class="seen"><geom contype="0" conaffinity="0" type="box" size="0.1 0.2 0.3"/>
          <default class="long"><geom size="0.5 0.6 0.7"/></default></default>
        <default class="up"><joint axis="1 0 0" type="slide"/><geom euler="90 0 0"/></default>
      </default>
      <asset><mesh file="arm.stl"/><mesh name="m" file="b/leg.obj" scale="1 -1 1"/></asset>
      <worldbody><body childclass="seen">
        <geom/><geom class="long" pos="1 2 3"/><geom class="main"/>
        <geom class="main" type="mesh" mesh="arm"/><geom class="main" type="mesh" mesh="m"/>
        <geom class="main" type="cylinder" fromto="1 2 3 1 2 5" size="0.3"/>
        <geom class="main" type="ellipsoid" size="1 2 3"/><geom class="main" type="hfield"/>
        <geom class="all" size="0.3"/>
        <body childclass="up"><joint/><geom zaxis="0 1 0"/></body>
      </body></worldbody></mujoco>"#;
    let model = read(text);
    let shapes: Vec<_> = model.links[0].geometry.iter().map(|g| (g.role, g.shape.clone())).collect();
    assert_eq!(shapes[0], (Role::Visual, GeometryShape::Box([0.2, 0.4, 0.6])));
    assert_eq!(shapes[1], (Role::Visual, GeometryShape::Box([1.0, 1.2, 1.4])));
    assert_eq!(shapes[2], (Role::Collision, GeometryShape::Capsule { radius: 0.1, length: 0.4 }));
    let mesh = |k: usize| match &shapes[k].1 {
        GeometryShape::Mesh { uri, scale, .. } => (uri.text.clone(), *scale),
        other => panic!("{other:?}"),
    };
    assert_eq!(mesh(3), ("arm.stl".to_owned(), [2.0; 3]));
    assert_eq!(mesh(4), ("b/leg.obj".to_owned(), [1.0, -1.0, 1.0]));
    assert_eq!(shapes[5].1, GeometryShape::Cylinder { radius: 0.3, length: 2.0 });
    assert_eq!(model.links[0].geometry[5].pose.position, [1.0, 2.0, 4.0]);
    assert_eq!(shapes[6].1, GeometryShape::Ellipsoid([1.0, 2.0, 3.0]));
    assert_eq!(shapes[7].1, GeometryShape::Other("hfield".to_owned()));
    // A number that the geom does not give is taken from its class.
    assert_eq!(shapes[8].1, GeometryShape::Capsule { radius: 0.3, length: 0.4 });
    assert_eq!((model.joints[1].kind, model.joints[1].axis), (JointKind::Prismatic, [1.0, 0.0, 0.0]));
    // The geom's own attitude takes precedence over that of its class.
    assert_close(applied(model.links[1].geometry[0].pose.matrix(), [0.0, 0.0, 1.0]), [0.0, 1.0, 0.0], 2e-15);
}

#[test]
fn what_is_not_read_is_noted() {
    let text = r#"<mujoco><include file="other.xml"/><worldbody><body name="b"><composite/><replicate/></body><include file='more.xml'/></worldbody></mujoco>"#;
    let codes: Vec<_> = read(text).notes.iter().map(|n| (n.code, n.subject.clone())).collect();
    let left = |code, subject: &str| (code, subject.to_owned());
    assert_eq!(
        codes,
        [
            left("read.include", ""),
            left("read.include", ""),
            left("read.left_out", "b"),
            left("read.left_out", "b")
        ]
    );
}

#[test]
fn bodies_that_mujoco_makes_are_refused_by_name() {
    let text = r#"<mujoco><worldbody>
<body name="arm"><geom size="0.1"/>
  <body name="hand"><joint name="j"/>
    <composite type="cable" curve="s" count="9 1 1" initial="none"><geom type="capsule" size="0.01"/></composite></body>
  <body name="tool"><geom size="0.1"/></body></body>
<flexcomp name="cloth" dim="2" count="3 3 1"/></worldbody></mujoco>"#;
    let model = read(text);
    assert_eq!((model.links.len(), model.notes.len()), (3, 2));
    let places = ["<composite", "<flexcomp"].map(|element| text.find(element).unwrap());
    for (note, (place, subject)) in model.notes.iter().zip(places.into_iter().zip(["hand", ""])) {
        assert_eq!((note.code, note.span.start, note.subject.as_str()), ("read.left_out", place, subject));
        assert!(note.message.contains("mj_saveLastXML"), "{}", note.message);
    }
    // The bodies may be fixed to the hand, so it may have mass.
    assert!(check(&model, &[]).iter().all(|finding| finding.code == "read.left_out"));

    let error = |lumping| of_lumps(&model, lumping, &[], false).unwrap_err();
    for lumping in [Lumping::All, Lumping::Fixed, Lumping::Subtree("arm"), Lumping::Subtree("hand")] {
        let error = error(lumping);
        assert_eq!(error.span().unwrap().start, places[0], "{lumping:?}");
        assert_eq!(
            error.to_string(),
            "the bodies of <composite> are not read, so their mass would be missing"
        );
        assert!(error.hint().contains("mj_saveLastXML"));
    }
    assert_eq!(LinkTable::of(&model, &[]).unwrap_err(), error(Lumping::All));
    assert!(of_lumps(&model, Lumping::Subtree("tool"), &[], false).is_ok());
    assert!(of_link(&model, "arm").is_ok());
}

#[test]
fn a_total_mass_is_refused_where_bodies_are_missing() {
    let model = read(
        "<mujoco><compiler settotalmass='9'/><worldbody><body name='b'><geom size='1'/></body><flexcomp name='f'/></worldbody></mujoco>",
    );
    let error = link_mass(model.format, &model.links[0]).unwrap_err();
    assert!(error.to_string().contains("<flexcomp> is not read"), "{error}");
}

#[test]
fn ends_of_a_shape_that_are_no_six_numbers_give_no_length() {
    for ends in ["0 0 0 0 0", "0 0 0 0 0 A", "0 0 0 0 0 1 2"] {
        let text = format!(
            "<mujoco><worldbody><body name=\"a\"><geom type=\"capsule\" size=\"0.1 0.2\" fromto=\"{ends}\"/></body></worldbody></mujoco>"
        );
        let shape = &read(&text).links[0].geometry[0].shape;
        assert!(
            matches!(shape, GeometryShape::Capsule { length, .. } if length.is_nan()),
            "{ends}: {shape:?}"
        );
    }
}
