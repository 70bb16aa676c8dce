//! USD as text. Expected positions on the stage are those of OpenUSD 26.11 (`UsdGeom.XformCache`).

use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::check::check;
use polhode_robot::finding::Severity;
use polhode_robot::model::{GeometryShape, JointKind, ModelFormat, Role, Slot, Tensor};
use polhode_robot::read::format_of;

use crate::common::{
    Matrix, applied, assert_close, assert_near, matrix_about, matrix_about_axis, plus, read, refused, times,
    transposed,
};

const ROBOT: &str = r##"#usda 1.0
(
    defaultPrim = "Robot"
    metersPerUnit = 0.01
    kilogramsPerUnit = 0.001
    upAxis = "Y"
    doc = """a robot, with # in its "words" """
)

def Xform "Robot" (
    kind = "component"
)
{
    float3 xformOp:rotateXYZ = (20, -30, 40)
    double3 xformOp:translate = (10, 20, 30)
    double3 xformOp:translate:pivot = (1, 2, 3)
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:translate:pivot", "xformOp:rotateXYZ", "!invert!xformOp:translate:pivot"]

    def Xform "base" (
        prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI"]
    )
    {
        point3f physics:centerOfMass = (1.5, -2.5, 3.5)
        float3 physics:diagonalInertia = (1.25e6, 2.5e6, 3e6)
        float physics:mass = 2500 (
            doc = "grams"
        )
        quatf physics:principalAxes = (0.8, 0.2, -0.4, 0.4)
        quatf xformOp:orient = (0.5, 0.5, -0.5, 0.5)
        float xformOp:rotateZ:more = 25
        uniform token[] xformOpOrder = ["xformOp:orient", "xformOp:rotateZ:more"]

        def Cube "shape" (
            prepend apiSchemas = ["PhysicsCollisionAPI"]
        )
        {
            double size = 2
            float3 xformOp:scale = (10, 20, 5)
            double3 xformOp:translate = (1, 2, 3)
            float3 xformOp:rotateZYX = (10, 20, 30)
            uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateZYX", "xformOp:scale"]
        }
        def Capsule "long" { uniform token axis = "X"; double radius = 3; double height = 8
            matrix4d xformOp:transform = ( (0, 1, 0, 0), (-1, 0, 0, 0), (0, 0, 1, 0), (4, 5, 6, 1) )
            uniform token[] xformOpOrder = ["xformOp:transform"]
        }
    }

    over "arm" (
        prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI"]
        references = @other.usda@</Arm>
    )
    {
        uniform token[] xformOpOrder = ["!resetXformStack!", "xformOp:translate"]
        double3 xformOp:translate = (7, 8, 9)
        float physics:mass = 1200
        point3f physics:centerOfMass = (0, 0, 0)
        float3 physics:diagonalInertia = (5e5, 5e5, 5e5)
    }

    def PhysicsRevoluteJoint "elbow"
    {
        uniform token physics:axis = "Z"
        rel physics:body0 = </Robot/base>
        rel physics:body1 = </Robot/arm>
        point3f physics:localPos0 = (10, 0, 5)
        point3f physics:localPos1 = (-2, 1, 0)
        quatf physics:localRot0 = (0.5, 0.5, 0.5, -0.5)
        quatf physics:localRot1 = (1, 0, 0, 0)
    }
    class "not" ( prepend apiSchemas = ["PhysicsRigidBodyAPI"] ) { }
}
"##;

#[test]
fn bodies_stand_where_their_operations_say_and_are_in_si() {
    let model = read(ROBOT);
    assert_eq!((model.format, model.name.as_deref(), model.is_si), (ModelFormat::Usd, Some("Robot"), false));
    assert_eq!(format_of(ROBOT), Some(ModelFormat::Usd));
    let names: Vec<_> = model.links.iter().map(|link| link.name.text.as_str()).collect();
    assert_eq!(names, ["/Robot/base", "/Robot/arm"]);
    let (base, arm) = (&model.links[0], &model.links[1]);
    assert_eq!(&model.text[base.name.span.clone()], "base");
    assert_close(base.pose.position, [0.12226864763581123, 0.21915525341401362, 0.29466210690499833], 1e-15);
    let attitude: Matrix = [
        [-0.40732358481864844, -0.5420581945932507, 0.7350240886697466],
        [-0.746429372094757, -0.26615209416685426, -0.609923155196477],
        [0.5262420448089578, -0.7970796550188093, -0.29619813272602424],
    ];
    assert_near(&base.pose.matrix(), &attitude, 1e-14);
    assert_eq!(arm.pose.position, [0.07, 0.08, 0.09]);

    let inertial = base.inertial.as_ref().unwrap();
    assert_eq!(inertial.mass.finite(), Some(2.5));
    assert_eq!(&model.text[inertial.mass.span()], "2500");
    let Tensor::Diagonal(moments) = &inertial.tensor else { panic!("three") };
    assert_eq!(moments.each_ref().map(Slot::finite), [0.125, 0.25, 0.3].map(Some));
    let LinkMass::Body(body) = link_mass(model.format, base).unwrap() else { panic!("a body") };
    // Quaternion (w, x, y, z) = (0.8, 0.2, −0.4, 0.4).
    let r = matrix_about_axis([0.2, -0.4, 0.4], 2.0 * 0.8_f64.acos());
    let own = [[0.125, 0.0, 0.0], [0.0, 0.25, 0.0], [0.0, 0.0, 0.3]];
    assert_near(&body.properties.inertia().matrix(), &times(times(r, own), transposed(r)), 1e-15);
    assert_close(body.properties.center_of_mass().to_array(), [0.015, -0.025, 0.035], 1e-17);
    // Content of other layers is unknown.
    assert_eq!((model.notes[0].code, model.notes[0].subject.as_str()), ("read.include", "/Robot/arm"));
    assert!(check(&model, &[]).iter().all(|finding| finding.repair.is_none()));
}

#[test]
fn shapes_are_in_the_frame_of_their_body() {
    let model = read(ROBOT);
    let [cube, capsule] = model.links[0].geometry.as_slice() else { panic!("two shapes") };
    assert_eq!((cube.role, capsule.role), (Role::Collision, Role::Visual));
    let GeometryShape::Box(edges) = cube.shape else { panic!("a box") };
    assert_close(edges, [0.2, 0.4, 0.1], 1e-15);
    assert_close(cube.pose.position, [0.01, 0.02, 0.03], 1e-15);
    // rotateZYX rotates about z first.
    let [x, y, z] =
        [(0, 10_f64), (1, 20.0), (2, 30.0)].map(|(axis, angle)| matrix_about(axis, angle.to_radians()));
    assert_near(&cube.pose.matrix(), &times(times(x, y), z), 1e-14);
    assert_eq!(capsule.shape, GeometryShape::Capsule { radius: 0.03, length: 0.08 });
    assert_close(capsule.pose.position, [0.04, 0.05, 0.06], 1e-15);
    // The axis x of a prim rotated by 90° about z is along y.
    let along = applied(capsule.pose.matrix(), [0.0, 0.0, 1.0]);
    assert_close(along.map(f64::abs), [0.0, 1.0, 0.0], 1e-14);
}

#[test]
fn joints_have_a_frame_in_each_of_two_bodies() {
    let model = read(ROBOT);
    let [joint] = model.joints.as_slice() else { panic!("one joint") };
    assert_eq!((joint.name.text.as_str(), joint.kind), ("/Robot/elbow", JointKind::Revolute));
    assert_eq!(
        (joint.parent.as_ref().unwrap().text.as_str(), joint.child.text.as_str()),
        ("/Robot/base", "/Robot/arm")
    );
    assert_eq!((joint.axis, joint.anchor), ([0.0, 0.0, 1.0], [-0.02, 0.01, 0.0]));
    let r = matrix_about_axis([1.0, 1.0, -1.0], 120_f64.to_radians());
    assert_near(&joint.pose.matrix(), &r, 1e-15);
    assert_close(joint.pose.position, plus([0.1, 0.0, 0.05], applied(r, [0.02, -0.01, 0.0])), 1e-15);
}

#[test]
fn an_end_of_a_joint_may_be_the_world_or_named_from_the_joint() {
    let model =
        read(&ROBOT.replace("body0 = </Robot/base>", "body0 = None").replace("</Robot/arm>", "<../arm>"));
    let [joint] = model.joints.as_slice() else { panic!("one joint") };
    assert_eq!((&joint.parent, joint.child.text.as_str()), (&None, "/Robot/arm"));
    // A joint to the world may name its body first.
    let model = read(&ROBOT.replace("    rel physics:body1 = </Robot/arm>\n", ""));
    let joint = &model.joints[0];
    assert_eq!(
        (&joint.parent, joint.child.text.as_str(), joint.anchor),
        (&None, "/Robot/base", [0.1, 0.0, 0.05])
    );
}

#[test]
fn a_joint_may_hold_what_another_layer_has() {
    let text = ROBOT.replace("</Robot/arm>", "</Robot/hand>");
    let unknown = |text: &str| {
        let findings = check(&read(text), &[]);
        findings.iter().find(|finding| finding.code == "tree.unknown_link").unwrap().severity
    };
    assert_eq!(unknown(&text), Severity::Note);
    assert_eq!(unknown(&text.replace("references = @other.usda@</Arm>", "")), Severity::Impossible);
}

#[test]
fn what_is_left_out_the_engine_computes_and_is_no_body_here() {
    let body = |inside: &str| {
        let text = format!(
            "#usda 1.0\n( metersPerUnit = 1 )\ndef Xform \"a\" ( apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"] )\n{{\n{inside}\n}}\n"
        );
        let model = read(&text);
        assert!(model.is_si);
        link_mass(model.format, &model.links[0]).map_err(|error| error.to_string())
    };
    let whole = "float physics:mass = 2\nfloat3 physics:diagonalInertia = (1, 2, 2.5)\npoint3f physics:centerOfMass = (0, 0, 1)";
    assert!(body(whole).is_ok());
    for (right, wrong, said) in [
        ("mass = 2", "mass = 0", "it is missing"),
        ("(0, 0, 1)", "(-inf, -inf, -inf)", "its centre of mass is missing"),
        ("(1, 2, 2.5)", "(0, 0, 0)", "no inertia tensor"),
        ("(1, 2, 2.5)", "(1, 2)", "diagonalInertia 3"),
        ("(1, 2, 2.5)", "(1, 2kg, 2.5)", "2kg"),
        ("(0, 0, 1)", "(0, 0)", "inertial frame"),
        (
            "mass = 2",
            "mass = 2\nfloat3 xformOp:scale = (1, 1, 2)\nuniform token[] xformOpOrder = [\"xformOp:scale\"]",
            "scaled",
        ),
        ("mass = 2", "mass = 2\nquatf physics:principalAxes = (1, nan, 0, 0)", "inertial frame"),
    ] {
        assert!(whole.contains(right));
        let error = body(&whole.replace(right, wrong)).unwrap_err();
        assert!(error.contains(said), "{wrong}: {error}");
    }
}

#[test]
fn what_is_no_usd_is_refused_where_it_stands() {
    for (text, said) in [
        ("#usda 1.0\ndef Xform \"a\"\n{\n", "ends the prim"),
        ("#usda 1.0\ndef Xform \"a\" { float x = (1, 2 }", "the closing bracket"),
        ("#usda 1.0\ndef Xform a { }", "name of the prim"),
        ("#usda 1.0\ndef Xform \"a", "closing"),
        ("#usda 1.0\n}", "a prim or a property"),
    ] {
        assert!(refused(text).to_string().contains(said), "{text}: {}", refused(text));
    }
    let deep = format!("#usda 1.0\n{}{}", "def \"a\" {\n".repeat(2000), "}\n".repeat(2000));
    assert!(refused(&deep).to_string().contains("nested deeper"));
}

/// Returns a body of 2 kg in a rotated frame, with additional lines in its prim.
fn body_with(lines: &str) -> polhode_robot::model::RobotModel {
    read(&format!(
        "#usda 1.0\n(\n    metersPerUnit = 1\n)\n\ndef Xform \"a\" (\n    prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"]\n)\n{{\n    \
         float physics:mass = 2\n    point3f physics:centerOfMass = (0.1, -0.3, 0.2)\n    \
         float3 physics:diagonalInertia = (0.5, 0.7, 0.9)\n    quatf physics:principalAxes = (0.8, 0.2, -0.4, 0.4)\n{lines}}}\n\
         def Xform \"b\" (\n    prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"]\n)\n{{\n    float physics:mass = 3\n    \
         float3 physics:diagonalInertia = (0.5, 0.7, 0.9)\n}}\n\
         def PhysicsFixedJoint \"j\"\n{{\n    bool physics:jointEnabled = 0\n    rel physics:body0 = </a>\n    rel physics:body1 = </b>\n}}\n"
    ))
}

#[test]
fn what_usd_says_otherwise_than_in_numbers_is_not_passed_over() {
    let is_body = |lines: &str| {
        let model = body_with(lines);
        matches!(link_mass(model.format, &model.links[0]), Ok(LinkMass::Body(_)))
    };
    let turned = "    float xformOp:rotateZ = 30\n    uniform token[] xformOpOrder = [\"xformOp:rotateZ\"]\n";
    assert!(is_body("") && is_body(turned));
    // A mirror is not a rotation.
    assert!(!is_body(
        "    float3 xformOp:scale = (-1, 1, 1)\n    uniform token[] xformOpOrder = [\"xformOp:scale\"]\n"
    ));
    // A transform with time samples has no single value.
    let moved = body_with(
        "    double3 xformOp:translate.timeSamples = {\n        0: (0, 0, 1),\n    }\n    uniform token[] xformOpOrder = [\"xformOp:translate\"]\n",
    );
    assert_eq!(moved.links[0].pose.unreadable.len(), 1);
    // usdcat writes a boolean as 0 or 1.
    assert!(moved.joints.is_empty());
    assert!(body_with("    bool physics:rigidBodyEnabled = 0\n").links[0].is_static);
    assert!(!body_with("    bool physics:rigidBodyEnabled = 1\n").links[0].is_static);
}
