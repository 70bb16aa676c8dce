//! Links joined to one body, compared with sums over their points.

use polhode_robot::lump::{Lump, Lumping, lump, lump_valid};
use polhode_robot::model::{
    Coordinate, Inertial, Joint, JointKind, Link, ModelFormat, Name, Number, Pose, RobotModel, Slot, Tensor,
};

use crate::common::require_says;

type Vector = [f64; 3];
type Matrix = [[f64; 3]; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn apply(m: &Matrix, v: Vector) -> Vector {
    m.map(|row| dot(row, v))
}

fn transposed(m: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
}

fn times(a: &Matrix, b: &Matrix) -> Matrix {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}

fn plus(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] + b[k])
}

/// Returns the matrix by Rodrigues' formula: cos θ 1 + sin θ [n]× + (1 − cos θ) n nᵀ.
fn turn(axis: Vector, angle: f64) -> Matrix {
    let n = axis.map(|x| x / dot(axis, axis).sqrt());
    let (s, c) = angle.sin_cos();
    let cross = [[0.0, -n[2], n[1]], [n[2], 0.0, -n[0]], [-n[1], n[0], 0.0]];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| f64::from(u8::from(i == j)) * c + s * cross[i][j] + (1.0 - c) * n[i] * n[j])
    })
}

/// Returns the quaternion of the same rotation.
fn quaternion(axis: Vector, angle: f64) -> [f64; 4] {
    let n = axis.map(|x| x / dot(axis, axis).sqrt());
    let (s, c) = (0.5 * angle).sin_cos();
    [c, s * n[0], s * n[1], s * n[2]]
}

/// Returns points of a link in its own frame, from a linear congruential generator with this seed.
fn points(seed: u64) -> Vec<(f64, Vector)> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    (0..200)
        .map(|_| (0.002 + 0.01 * next(), [next() - 0.3, 0.7 * next() - 0.1, 1.3 * next() - 0.9]))
        .collect()
}

/// Returns mass, centre, and tensor about the centre of points.
fn sums(points: &[(f64, Vector)]) -> (f64, Vector, Matrix) {
    let mass: f64 = points.iter().map(|(m, _)| m).sum();
    let centre = std::array::from_fn(|k| points.iter().map(|(m, p)| m * p[k]).sum::<f64>() / mass);
    let mut tensor = [[0.0; 3]; 3];
    for (m, p) in points {
        let r = plus(*p, centre.map(|c: f64| -c));
        for (i, row) in tensor.iter_mut().enumerate() {
            for (j, element) in row.iter_mut().enumerate() {
                *element += m * (f64::from(u8::from(i == j)) * dot(r, r) - r[i] * r[j]);
            }
        }
    }
    (mass, centre, tensor)
}

fn name(text: &str) -> Name {
    Name { text: text.to_owned(), span: 0..0 }
}

fn slot(value: f64) -> Slot {
    Slot::Given(Number { text: format!("{value:e}"), span: 0..0, value: Some(value) })
}

fn pose(position: Vector, axis: Vector, angle: f64) -> Pose {
    Pose { position, rotation: quaternion(axis, angle), unreadable: Vec::new(), span: None }
}

/// Returns a link made of points, whose inertial frame is rotated by `angle` about `axis` relative
/// to the link's.
fn link(text: &str, points: &[(f64, Vector)], axis: Vector, angle: f64) -> Link {
    let (mass, centre, tensor) = sums(points);
    let r = turn(axis, angle);
    // J = Rᵀ I R, in the axes of the inertial frame.
    let j = times(&times(&transposed(&r), &tensor), &r);
    let six = [j[0][0], j[1][1], j[2][2], j[0][1], j[0][2], j[1][2]].map(slot);
    let inertial = Inertial {
        span: 0..0,
        mass: slot(mass),
        pose: pose(centre, axis, angle),
        tensor: Tensor::Six(Box::new(six)),
    };
    Link { inertial: Some(inertial), ..frame(text) }
}

/// Returns a link without mass.
fn frame(text: &str) -> Link {
    Link {
        name: name(text),
        span: 0..0,
        inertial: None,
        from_geometry: false,
        computed: None,
        geometry: Vec::new(),
        pose: pose([0.0; 3], [0.0, 0.0, 1.0], 0.0),
        is_static: false,
    }
}

fn joint(text: &str, kind: JointKind, between: [&str; 2], pose: Pose, axis: Vector, anchor: Vector) -> Joint {
    let [parent, child] = between.map(name);
    Joint {
        name: name(text),
        span: 0..0,
        kind,
        parent: Some(parent),
        child,
        pose,
        axis,
        anchor,
        coordinate: Coordinate::default(),
    }
}

fn model(links: Vec<Link>, joints: Vec<Joint>) -> RobotModel {
    let (path, text) = ("robot.urdf".into(), String::new());
    RobotModel {
        path,
        folder: None,
        format: ModelFormat::Urdf,
        text,
        is_si: true,
        is_editable: true,
        included: Vec::new(),
        expansion: None,
        name: None,
        links,
        joints,
        unread_bodies: Vec::new(),
        notes: Vec::new(),
    }
}

const HAND: (Vector, f64) = ([-0.4, 1.1, 0.3], 2.1);
const SHOULDER: (Vector, Vector, f64) = ([0.31, -0.12, 0.77], [0.2, -0.9, 0.5], 0.83);
const SLIDE: (Vector, Vector, f64) = ([-0.2, 0.45, 0.1], [1.3, 0.4, -0.6], -1.7);
const WRIST: (Vector, Vector, f64) = ([0.05, 0.2, -0.33], [0.3, 0.8, 0.1], 2.6);

/// Returns base —shoulder→ arm —slide→ slider —wrist (fixed)→ hand, with a massless tool on the
/// hand. The order of the lists is arbitrary, as in files.
fn arm() -> RobotModel {
    let turned = |(position, axis, angle): (Vector, Vector, f64)| pose(position, axis, angle);
    let fixed = JointKind::Fixed;
    model(
        vec![
            frame("tool"),
            link("hand", &points(4), HAND.0, HAND.1),
            link("base", &points(1), [1.0, -0.3, 0.8], 0.4),
            link("slider", &points(3), [0.1, 0.2, -0.9], -1.2),
            link("arm", &points(2), [0.7, 0.7, -0.1], 1.9),
        ],
        vec![
            joint("wrist", fixed, ["slider", "hand"], turned(WRIST), [1.0, 0.0, 0.0], [0.0; 3]),
            joint("flange", fixed, ["hand", "tool"], turned(SLIDE), [1.0, 0.0, 0.0], [0.0; 3]),
            joint(
                "slide",
                JointKind::Prismatic,
                ["arm", "slider"],
                turned(SLIDE),
                [0.0, -3.0, 4.0],
                [0.0; 3],
            ),
            joint(
                "shoulder",
                JointKind::Revolute,
                ["base", "arm"],
                turned(SHOULDER),
                [0.6, 0.5, -0.2],
                [0.3, 0.1, -0.2],
            ),
        ],
    )
}

fn close(lump: &Lump, points: &[(f64, Vector)]) {
    let (mass, centre, tensor) = sums(points);
    let scale = tensor[0][0] + tensor[1][1] + tensor[2][2];
    assert!((lump.properties.mass() / mass - 1.0).abs() < 1e-14);
    for (a, b) in lump.properties.center_of_mass().to_array().iter().zip(centre) {
        assert!((a - b).abs() < 1e-14, "{a} {b}");
    }
    // The plain sum of 200 points per link has an error of about 1e-15 on each side.
    for (a, b) in lump.properties.inertia().matrix().as_flattened().iter().zip(tensor.as_flattened()) {
        assert!((a - b).abs() < 1e-14 * scale, "{a} {b}");
    }
}

/// Applies x ↦ R x + p to points.
fn placed(points: &[(f64, Vector)], r: &Matrix, p: Vector) -> Vec<(f64, Vector)> {
    points.iter().map(|&(m, x)| (m, plus(apply(r, x), p))).collect()
}

#[test]
fn the_whole_robot_is_the_sum_of_its_points() {
    let (shoulder, slide) = (0.9, -0.37);
    let positions = [("slide".to_owned(), slide), ("shoulder".to_owned(), shoulder)];
    let lumps = lump(&arm(), Lumping::All, &positions).unwrap();
    let [whole] = lumps.as_slice() else { panic!("{} lumps", lumps.len()) };
    assert_eq!(whole.frame.as_deref(), Some("base"));
    assert_eq!(whole.links, ["base", "arm", "slider", "hand"]);
    assert_eq!(whole.massless, ["tool"]);
    assert_eq!(whole.rounding, 0.0);

    // The points of each link are transformed outwards: each joint's motion in the child's frame,
    // then its pose in the parent's.
    let in_slider = [points(3), placed(&points(4), &turn(WRIST.1, WRIST.2), WRIST.0)].concat();
    let slid = placed(&in_slider, &turn([1.0, 0.0, 0.0], 0.0), [0.0, -0.6 * slide, 0.8 * slide]);
    let in_arm = [points(2), placed(&slid, &turn(SLIDE.1, SLIDE.2), SLIDE.0)].concat();
    let r = turn([0.6, 0.5, -0.2], shoulder);
    let anchor = [0.3, 0.1, -0.2];
    let swung = placed(&in_arm, &r, plus(anchor, apply(&r, anchor).map(|x| -x)));
    let in_base = [points(1), placed(&swung, &turn(SHOULDER.1, SHOULDER.2), SHOULDER.0)].concat();
    close(whole, &in_base);

    // Different joint values give a different tensor, and the last value of a joint counts.
    let other = lump(&arm(), Lumping::All, &[]).unwrap();
    let difference = other[0].properties.inertia().matrix()[0][1] - whole.properties.inertia().matrix()[0][1];
    assert!(difference.abs() > 1e-3);
    let again = [&[("slide".to_owned(), 5.0)], positions.as_slice()].concat();
    assert_eq!(lump(&arm(), Lumping::All, &again).unwrap(), lumps);
}

#[test]
fn fixed_joints_make_groups_in_the_frame_of_their_first_link() {
    let lumps = lump(&arm(), Lumping::Fixed, &[]).unwrap();
    let names: Vec<_> =
        lumps.iter().map(|l| (l.frame.as_deref().unwrap(), l.links.len(), l.massless.len())).collect();
    assert_eq!(names, [("base", 1, 0), ("arm", 1, 0), ("slider", 2, 1)]);
    close(&lumps[0], &points(1));
    close(&lumps[1], &points(2));
    close(&lumps[2], &[points(3), placed(&points(4), &turn(WRIST.1, WRIST.2), WRIST.0)].concat());
}

#[test]
fn two_joints_between_the_same_links_follow_each_other() {
    let place = pose([0.1, -0.2, 0.3], [0.3, 0.2, 0.9], 0.7);
    let joints = vec![
        joint(
            "first",
            JointKind::Revolute,
            ["base", "ball"],
            place.clone(),
            [0.2, 0.9, -0.4],
            [0.1, 0.0, -0.2],
        ),
        joint("second", JointKind::Revolute, ["base", "ball"], place, [-0.8, 0.3, 0.5], [-0.3, 0.2, 0.1]),
    ];
    let model = model(vec![frame("base"), link("ball", &points(9), [0.4, -0.2, 0.6], 0.8)], joints);
    let lumps =
        lump(&model, Lumping::All, &[("first".to_owned(), 1.1), ("second".to_owned(), -0.6)]).unwrap();
    let about = |points: &[(f64, Vector)], axis, angle, anchor| {
        let r = turn(axis, angle);
        placed(points, &r, plus(anchor, apply(&r, anchor).map(|x| -x)))
    };
    // The second joint acts on the child, the first on both.
    let second = about(&points(9), [-0.8, 0.3, 0.5], -0.6, [-0.3, 0.2, 0.1]);
    let first = about(&second, [0.2, 0.9, -0.4], 1.1, [0.1, 0.0, -0.2]);
    close(&lumps[0], &placed(&first, &turn([0.3, 0.2, 0.9], 0.7), [0.1, -0.2, 0.3]));
}

#[test]
fn what_has_no_position_is_refused() {
    let error =
        |model: &RobotModel, positions: &[(String, f64)]| lump(model, Lumping::All, positions).unwrap_err();
    let mut circle = arm();
    circle.joints.push(joint(
        "back",
        JointKind::Fixed,
        ["hand", "base"],
        pose([0.0; 3], HAND.0, 0.0),
        HAND.0,
        [0.0; 3],
    ));
    require_says(&error(&circle, &[]), "form a cycle");
    let mut twice = arm();
    twice.joints.push(joint(
        "brace",
        JointKind::Fixed,
        ["base", "hand"],
        pose([0.0; 3], HAND.0, 0.0),
        HAND.0,
        [0.0; 3],
    ));
    require_says(&error(&twice, &[]), "has two parents: the second by the joint \"brace\"");
    let mut apart = arm();
    apart.joints.retain(|joint| joint.name.text != "shoulder");
    require_says(&error(&apart, &[]), "both have no parent");
    assert_eq!(lump(&apart, Lumping::Fixed, &[]).unwrap().len(), 3);
    let mut lost = arm();
    lost.links.remove(0);
    require_says(&error(&lost, &[]), "names the link \"tool\", which does not exist");
    let mut bent = arm();
    bent.joints[3].axis = [0.0; 3];
    require_says(&error(&bent, &[("shoulder".to_owned(), 0.1)]), "the pose or axis of ");
    for wrong in [("wrist", 0.1), ("elbow", 0.1), ("slide", f64::NAN)] {
        let refused = error(&arm(), &[(wrong.0.to_owned(), wrong.1)]);
        assert!(refused.hint().ends_with("the joints that take a value are slide, shoulder"), "{wrong:?}");
    }
    // The error names a link that is too far away to be added.
    let mut far = arm();
    far.joints[3].pose.position = [1e200, 0.0, 0.0];
    let named = far.joints[3].child.text.clone();
    require_says(&error(&far, &[]), &format!("the link {named:?} cannot be lumped with the others"));
    let empty = model(vec![frame("base")], Vec::new());
    require_says(&error(&empty, &[]), "no link has mass");
    let mut given = arm();
    given.links[0].from_geometry = true;
    require_says(&error(&given, &[]), "cannot be used: it has no inertial: ");
}

#[test]
fn a_tensor_is_as_sure_as_its_digits() {
    // A plate with six digits: i1 + i2 < i3 by 1e-7, and each element is accurate to 5e-8.
    let written = |izz: &str| {
        let number =
            |text: &str| Slot::Given(Number { text: text.to_owned(), span: 0..0, value: text.parse().ok() });
        let six = ["0.0123456", "0.0234567", izz, "0", "0", "0"].map(number);
        let mut plate = link("plate", &points(5), [0.3, -0.5, 0.2], 0.6);
        plate.inertial.as_mut().unwrap().tensor = Tensor::Six(Box::new(six));
        model(vec![plate], Vec::new())
    };
    let lumps = lump(&written("0.0358024"), Lumping::Fixed, &[]).unwrap();
    assert!((lumps[0].rounding - 1e-7).abs() < 1e-15);
    let [i1, i2, i3] = lumps[0].properties.principal().moments();
    assert!((i1 + i2 - i3).abs() < 1e-16);
    assert!((i3 - (0.0358024 - 1e-7 / 3.0)).abs() < 1e-15);
    let error = lump(&written("0.0358026"), Lumping::Fixed, &[]).unwrap_err();
    require_says(&error, "the link \"plate\" cannot be used: ");
}

#[test]
fn links_without_a_body_are_left_out_by_name_and_the_others_are_summed() {
    let link = |name: &str, ixx: &str| {
        format!(
            r#"<link name="{name}"><inertial><origin xyz="0.1 -0.2 0.3" rpy="0 0 0"/><mass value="1.7"/>
            <inertia ixx="{ixx}" ixy="0.01" ixz="-0.02" iyy="0.3" iyz="0.03" izz="0.4"/></inertial></link>"#
        )
    };
    let joint = |name: &str, parent: &str, child: &str, kind: &str| {
        format!(
            r#"<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>
            <origin xyz="0.3 0.1 -0.4" rpy="0.2 -0.1 0.7"/><axis xyz="0 0 1"/></joint>"#
        )
    };
    let model = |second: &str, third: &str| {
        let links = [link("a", "0.2"), link("b", second), link("c", third)].concat();
        let text = format!(
            r#"<robot name="r">{links}{}{}</robot>"#,
            joint("j", "a", "b", "revolute"),
            joint("k", "a", "c", "fixed")
        );
        polhode_robot::read::read_text(&text, "a.urdf".as_ref(), &Default::default()).unwrap()
    };
    let bad = model("9", "0.25");
    assert!(lump(&bad, Lumping::All, &[]).unwrap_err().to_string().contains("\"b\""));
    let [whole] = lump_valid(&bad, Lumping::All, &[]).unwrap().try_into().unwrap();
    assert_eq!(whole.links, ["a", "c"]);
    let [error] = &*whole.left_out else { panic!("{:?}", whole.left_out) };
    assert!(error.to_string().contains("\"b\"") && error.span().is_some(), "{error}");
    // The sum is that of a model in which the link has no inertial.
    let without = polhode_robot::read::read_text(
        &bad.text.replace(&link("b", "9"), r#"<link name="b"/>"#),
        "a.urdf".as_ref(),
        &Default::default(),
    );
    let [other] = lump(&without.unwrap(), Lumping::All, &[]).unwrap().try_into().unwrap();
    assert_eq!(whole.properties, other.properties);
    // A group of which nothing is left is named in the first body.
    let groups = lump_valid(&bad, Lumping::Fixed, &[]).unwrap();
    assert_eq!((groups.len(), groups[0].left_out.len()), (1, 1));
    // Without any valid link the first error is returned.
    assert!(lump_valid(&model("9", "9"), Lumping::Subtree("b"), &[]).is_err());
    assert_eq!(lump_valid(&model("0.3", "0.25"), Lumping::All, &[]).unwrap()[0].left_out, []);
}
