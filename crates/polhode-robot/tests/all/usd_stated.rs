//! Wrong, repeated and animated statements of a USD layer: each is reported.

use polhode_robot::body::link_mass;
use polhode_robot::finding::{Finding, Severity};
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect;
use polhode_robot::model::{GeometryShape, Role};
use polhode_robot::remarks::remarks;

use crate::common::{assert_close, read, refused, require_says};

/// Returns a layer with one body.
fn layer(units: &str, body: &str) -> String {
    format!(
        "#usda 1.0\n(\n    {units}\n    upAxis = \"Z\"\n)\ndef Xform \"r\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\",\"PhysicsMassAPI\"])\n\
         {{\n    {body}\n    point3f physics:centerOfMass = (0,0,0)\n    quatf physics:principalAxes = (1,0,0,0)\n}}\n"
    )
}

const UNITS: &str = "metersPerUnit = 1\n    kilogramsPerUnit = 1";
const MOMENTS: &str = "float3 physics:diagonalInertia = (1,1,1.5)";

fn found(text: &str) -> Vec<Finding> {
    inspect(&read(text), &Shapes::default()).findings
}

fn codes(text: &str) -> Vec<(&'static str, Severity, usize)> {
    let line = |found: &Finding| text[..found.span.start].lines().count();
    found(text).iter().map(|found| (found.code, found.severity, line(found))).collect()
}

#[test]
fn a_unit_that_is_no_positive_number_is_an_error_at_its_line() {
    let body = format!("float physics:mass = 2\n    {MOMENTS}");
    for key in ["metersPerUnit", "kilogramsPerUnit"] {
        for wrong in ["0", "-1", "nan", "inf", "\"1\"", "(1, 2)", "1e999", "None"] {
            let other = if key == "metersPerUnit" { "kilogramsPerUnit = 1" } else { "metersPerUnit = 1" };
            let error = refused(&layer(&format!("{other}\n    {key} = {wrong}"), &body));
            assert_eq!(error.place().map(|place| place.line), Some(4), "{key} = {wrong}: {error}");
            assert!(error.message().contains(key), "{error}");
            assert!(error.message().contains("positive finite number"), "{error}");
        }
    }
    assert_eq!(codes(&layer(UNITS, &body)), []);
}

#[test]
fn what_is_stated_twice_is_a_finding() {
    let twice = layer(UNITS, &format!("float physics:mass = 2\n    float physics:mass = 3\n    {MOMENTS}"));
    assert_eq!(codes(&twice), [("read.twice", Severity::Suspect, 10)]);
    assert!(remarks(&read(&twice), Some("/r")).is_err());
    for (text, subject) in [
        (
            layer(
                &format!("{UNITS}\n    metersPerUnit = 0.01"),
                &format!("float physics:mass = 2\n    {MOMENTS}"),
            ),
            "",
        ),
        (layer(UNITS, &format!("float physics:mass = 2\n    {MOMENTS}\n    {MOMENTS}")), "/r"),
        (
            layer(
                UNITS,
                &format!(
                    "float physics:mass = 2\n    {MOMENTS}\n    def Cube \"c\" {{\n double size = 1\n double size = 2\n }}"
                ),
            ),
            "/r/c",
        ),
    ] {
        let found = found(&text);
        let twice: Vec<&str> =
            found.iter().filter(|f| f.code == "read.twice").map(|found| found.subject.as_str()).collect();
        assert_eq!(twice, [subject]);
    }
}

#[test]
fn a_mass_that_changes_over_time_is_a_finding() {
    for (body, line) in [
        (format!("float physics:mass.timeSamples = {{ 0: 1, 1: 5 }}\n    {MOMENTS}"), 9),
        (
            format!(
                "float physics:mass = 2\n    {MOMENTS}\n    float3 physics:diagonalInertia.timeSamples = {{ 0: (1, 1, 1) }}"
            ),
            11,
        ),
        (
            format!("float physics:mass = 2\n    {MOMENTS}\n    float physics:mass.connect = </other.mass>"),
            11,
        ),
    ] {
        let text = layer(UNITS, &body);
        assert_eq!(codes(&text), [("read.animated", Severity::Suspect, line)], "{body}");
        let model = read(&text);
        let error = link_mass(model.format, &model.links[0]).unwrap_err();
        require_says(&error, "its mass cannot be computed: ");
        require_says(&error, "is not read");
    }
    // For a shape it is a note.
    let shape = "def Cube \"c\" {\n double size = 1\n double size.timeSamples = { 0: 2 }\n }";
    let text = layer(UNITS, &format!("float physics:mass = 2\n    {MOMENTS}\n    {shape}"));
    assert!(codes(&text).contains(&("read.animated", Severity::Note, 13)), "{:?}", codes(&text));
}

#[test]
fn numbers_that_are_too_many_or_none_are_findings() {
    for (body, code) in [
        (
            "float physics:mass = 2\n    float3 physics:diagonalInertia = (1, 1, 1.5, 2)".to_owned(),
            "read.numbers",
        ),
        (format!("float physics:mass = (2, 3)\n    {MOMENTS}"), "read.numbers"),
        (format!("string physics:mass = \"2\"\n    {MOMENTS}"), "number.malformed"),
        (format!("float physics:mass = nan\n    {MOMENTS}"), "number.not_finite"),
        (
            "float physics:mass = 2\n    float3 physics:diagonalInertia = (1, nan, 1.5)".to_owned(),
            "number.not_finite",
        ),
        (
            "float physics:mass = 2\n    string physics:diagonalInertia = \"1 1 1\"".to_owned(),
            "number.malformed",
        ),
        ("float physics:mass = 2\n    float3 physics:diagonalInertia = (1, 1)".to_owned(), "number.missing"),
    ] {
        let text = layer(UNITS, &body);
        let found = found(&text);
        assert!(found.iter().any(|f| f.code == code && f.severity >= Severity::Suspect), "{body}: {found:?}");
        let model = read(&text);
        assert!(link_mass(model.format, &model.links[0]).is_err(), "{body}");
    }
}

#[test]
fn axes_that_are_none_are_told() {
    let joint = |axis: &str| {
        layer(UNITS, &format!("float physics:mass = 2\n    {MOMENTS}"))
            + &format!(
                "def PhysicsRevoluteJoint \"j\"\n{{\n rel physics:body1 = </r>\n uniform token physics:axis = \"{axis}\"\n}}\n"
            )
    };
    assert_eq!(codes(&joint("Y")), []);
    assert!(
        codes(&joint("y"))
            .iter()
            .any(|(code, severity, _)| (*code, *severity) == ("read.unknown", Severity::Suspect))
    );
}

#[test]
fn the_shape_of_a_body_may_be_the_body_itself() {
    let text = "#usda 1.0\n(\n metersPerUnit = 0.01\n)\ndef Cone \"top\" (prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsCollisionAPI\"])\n\
        {\n double radius = 3\n double height = 8\n uniform token axis = \"X\"\n double3 xformOp:translate = (10, 20, 30)\n \
        uniform token[] xformOpOrder = [\"xformOp:translate\"]\n}\n";
    let model = read(text);
    let [shape] = &model.links[0].geometry[..] else { panic!("a shape") };
    assert_eq!(
        (shape.role, &shape.shape),
        (Role::Collision, &GeometryShape::Cone { radius: 0.03, length: 0.08 })
    );
    // A cone has a third of the volume of its cylinder. Its centroid is a quarter of its height
    // from the base, here along x.
    let solid = Shapes::default().link(&model.links[0], Role::Collision).volume.unwrap();
    assert!((solid.volume / (std::f64::consts::PI * 0.0009 * 0.08 / 3.0) - 1.0).abs() < 1e-14);
    assert_close(solid.centroid, [-0.02, 0.0, 0.0], 1e-16);
    // The error of √(1 − a²) for an axis that rounding rotates by 1e-8.
    assert_close(solid.bounds[0], [-0.04, -0.03, -0.03], 1e-9);
    assert_close(solid.bounds[1], [0.04, 0.03, 0.03], 1e-9);
    assert!((solid.extent - 0.05).abs() < 1e-9);
}
