//! Bodies on the ground in scenario files: reading, and the place of each error.

use polhode::math::Rotation;
use polhode::motion::GroundContact;
use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{
    ContactPhase, Friction, Grip, GroundShape, GroundSide, StartVelocity, SurfaceShape,
};
use polhode::prelude::*;
use polhode_scenario::read as scenario;
use polhode_source::FormatError;

use crate::common::held::Held;

const BODY: &str = "[[body.part]]\nshape = 'tensor'\nmass = '1.3 kg'\n\
    inertia = [[0.011, 0.0004, -0.0003], [0.0004, 0.012, 0.0002], [-0.0003, 0.0002, 0.013]]\n";
const BALL: &str =
    "surface = { shape = 'sphere', radius = '200 mm', position = ['3 mm', '-2 mm', '5 mm'] }\n";
const RUN: &str = "[run]\nduration = '1 s'\nsamples = 5\n";

fn parse(text: &str) -> Result<Scenario, FormatError> {
    scenario::parse(text, "test.toml".as_ref())
}

/// Returns a scenario with these keys of its contact and of its start.
fn text(contact: &str, start: &str) -> String {
    format!("{BODY}[contact]\n{contact}\n[start]\n{start}\n{RUN}")
}

fn ground(contact: &str, start: &str) -> GroundContact {
    let scenario = parse(&text(contact, start)).unwrap_or_else(|e| panic!("{e}"));
    *scenario.ground().unwrap()
}

#[test]
fn a_contact_is_what_its_keys_say() {
    let given = ground(
        "surface = { shape = 'ellipsoid', semi_axes = ['300 mm', '0.25 m', '20 cm'], position = [0.01, -0.02, 0.03], rotate = { axis = [0, 0, 1], angle = '20 deg' } }\n\
         ground = { shape = 'plane', slope = '10 deg', rate = '30 rpm' }\nlaw = 'friction'\nfriction = 0.3\nstatic_friction = 0.35\nviscous = '0.1 N s/m'\n\
         rolling_friction = '1 mm'\npivoting_friction = '0.5 mm'\ngravity = ['0.1 m/s^2', 0, '-9.81 m/s^2']",
        "spin = { body = [0.3, -0.4, 0.5] }\nvelocity = [0, '-0.1 m/s', 0]",
    );
    let contact = given.contact;
    assert_eq!(*contact.surface.shape(), SurfaceShape::Ellipsoid { semi_axes: [0.3, 0.25, 0.2] });
    assert_eq!(contact.surface.center(), Position::new(0.01, -0.02, 0.03));
    let turned = Rotation::from_axis_angle(Direction::new(0.0, 0.0, 1.0), 20_f64.to_radians()).unwrap();
    assert!(contact.surface.axes().angle_to(turned) < 1e-15);
    let [x, y, z] = contact.ground.axis().to_array();
    assert!((x - 10_f64.to_radians().sin()).abs() < 1e-16 && y == 0.0 && z > 0.98, "downhill is +x");
    assert!((contact.ground.turning() - std::f64::consts::PI).abs() < 1e-15);
    let friction = Friction { kinetic: 0.3, sticking: 0.35, viscous: 0.1 };
    assert_eq!(*contact.law.grip(), Grip::Friction(friction));
    assert_eq!([contact.law.resistance().rolling, contact.law.resistance().pivoting], [0.001, 0.0005]);
    assert_eq!(contact.gravity.to_array(), [0.1, 0.0, -9.81]);
    assert_eq!(given.velocity, StartVelocity::Along(polhode::math::Velocity::new(0.0, -0.1, 0.0)));
}

#[test]
fn what_is_not_said_is_usual() {
    let given = ground(&format!("{BALL}law = 'rolling'"), "spin = { body = [1, 2, 3] }");
    assert_eq!((given.at, given.velocity), (Position::ZERO, StartVelocity::Rolling));
    assert_eq!(given.contact.gravity.to_array(), [0.0, 0.0, -9.80665]);
    assert_eq!(given.contact.ground.axis(), Direction::new(0.0, 0.0, 1.0));
    let friction = ground(&format!("{BALL}law = 'friction'\nfriction = 0.4\nrolls = true"), "");
    let Grip::Friction(coefficients) = *friction.contact.law.grip() else { panic!("friction") };
    assert_eq!([coefficients.kinetic, coefficients.sticking, coefficients.viscous], [0.4, 0.4, 0.0]);
    // The lowest point of a bowl and the highest of a hill, relative to gravity.
    for (shape, side, height) in
        [("sphere", "inside", -1.0), ("sphere", "outside", 1.0), ("cylinder", "inside", -1.0)]
    {
        let bowl = format!(
            "{BALL}law = 'rolling'\ngravity = [3, 0, -4]\nground = {{ shape = '{shape}', radius = '1.5 m', side = '{side}', axis = [0, 1, 0] }}"
        );
        let given = ground(&bowl, "");
        let want = Position::new(-0.6 * height * 1.5, 0.0, 0.8 * height * 1.5);
        assert!((given.at - want).norm() < 1e-15, "{shape} {side}: {:?}", given.at);
        let shape = *given.contact.ground.shape();
        assert!(matches!(
            shape,
            GroundShape::Sphere { radius: 1.5, .. }
                | GroundShape::Cylinder { radius: 1.5, side: GroundSide::Inside }
        ));
    }
    let rim = ground(
        "surface = { shape = 'rim', radius = 0.3 }\nlaw = 'frictionless'\nrolls = true",
        "attitude = { axis = [1, 0, 0], angle = '70 deg' }",
    );
    assert_eq!(*rim.contact.surface.shape(), SurfaceShape::Rim { radius: 0.3, tube: 0.0, thickness: 0.0 });
}

#[test]
fn the_motion_is_that_of_the_core() {
    let scenario = parse(&text(
        &format!("{BALL}law = 'friction'\nfriction = 0.2"),
        "spin = { body = [1, -2, 3] }\nvelocity = ['2 m/s', 0, 0]",
    ))
    .unwrap();
    let motion = scenario.simulate().unwrap().unwrap();
    let contact = Held::of(motion.clone(), CONTACT);
    assert_eq!(contact.samples().len(), motion.samples().len());
    assert_eq!(contact.start().phase, ContactPhase::Sliding);
    assert!(contact.energy_drift() < 1e-13, "{:e}", contact.energy_drift());
    // The initial velocity is that of the contact, including its normal component.
    assert_eq!(scenario.velocity(), contact.start().velocity);
    assert!(scenario.velocity().z.abs() > 1e-4, "{:?}", scenario.velocity());
    assert!(Drift::of(&motion).is_none(), "work and impulse are by the theorems");
}

/// A horizontal velocity would take a body off a slope, and is refused. The error states its part
/// along the slope. That part is completed by the rate at which the centre of an egg rises or
/// falls.
#[test]
fn a_velocity_on_a_slope_is_completed_along_the_normal_or_refused() {
    let on = |ground: &str| {
        format!(
            "surface = {{ shape = 'ellipsoid', semi_axes = [0.3, 0.25, 0.2] }}\nlaw = 'friction'\nfriction = 0.3\nground = {ground}"
        )
    };
    let turned = "attitude = { axis = [1, 2, 3], angle = '50 deg' }\nspin = { body = [1, -2, 3] }\n";
    for ground in ["{ slope = '20 deg' }", "{ normal = [0.3, -0.4, 1.2] }"] {
        let start = |velocity: &str| {
            let text = text(&on(ground), &format!("{turned}velocity = {velocity}"));
            parse(&text.replace("'1 s'", "'2 ms'").replace("samples = 5", "samples = 3"))
        };
        let error = start("['0.5 m/s', '0.2 m/s', 0]").unwrap_err();
        assert!(error.message().contains("along the normal"), "{error}");
        let hint = error.hint().unwrap();
        let (_, fits) = hint.split_once("velocity = ").unwrap();
        let along: Vec<f64> =
            fits.trim_matches(['[', ']']).split(", ").map(|number| number.parse().unwrap()).collect();
        let scenario = start(fits).unwrap_or_else(|error| panic!("{fits}: {error}"));
        let motion = scenario.simulate().unwrap().unwrap();
        let contact = Held::of(motion.clone(), CONTACT);
        let normal = scenario.ground().unwrap().contact.ground.normal_at(Position::ZERO).unwrap();
        let along = polhode::math::Velocity::new(along[0], along[1], along[2]);
        assert!(along.dot(normal).abs() < 1e-15 && along.norm() > 0.3);
        // The normal component equals the rate of the centre's height, from differences of the
        // samples.
        let velocity = contact.start().velocity;
        let change = velocity - along;
        let rest = |k: usize| change.to_array()[k] - change.dot(normal) * normal.to_array()[k];
        assert!((0..3).all(|k| rest(k).abs() < 1e-15), "{velocity:?} {along:?}");
        let [first, second, third] = [0, 1, 2].map(|k| {
            let sample = &contact.samples()[k];
            (sample.state.time, sample.center.dot(normal))
        });
        let h = second.0 - first.0;
        let rate = (4.0 * second.1 - third.1 - 3.0 * first.1) / (2.0 * h);
        assert!((rate - velocity.dot(normal)).abs() < 1e-4, "{rate} {}", velocity.dot(normal));
        assert!(velocity.dot(normal).abs() > 1e-2);
    }
}

/// Checks the text at the place of each error, and its message.
#[test]
fn each_mistake_has_its_place() {
    let rolling = format!("{BALL}law = 'rolling'");
    let slides = format!("{BALL}law = 'friction'\nfriction = 0.3");
    let bowl = |radius: &str| {
        format!("{rolling}\nground = {{ shape = 'sphere', radius = {radius}, side = 'inside' }}")
    };
    let lying = "surface = { shape = 'cylinder', radius = 0.2 }\nlaw = 'rolling'";
    let laid = "attitude = { axis = [1, 0, 0], angle = '90 deg' }\n";
    let cases: &[(&str, &str, &str, &str)] = &[
        ("law = 'rolling'", "", "[contact]", "surface"),
        ("surface = { radius = 1 }\nlaw = 'rolling'", "", "{ radius = 1 }", "shape"),
        ("surface = { shape = 'sphere', radius = 0 }\nlaw = 'rolling'", "", "0", "positive"),
        ("surface = { shape = 'sphere', tube = 1 }\nlaw = 'rolling'", "", "tube", "unknown key"),
        (
            "surface = { shape = 'rim', radius = 1, tube = '-1 mm' }\nlaw = 'rolling'",
            "",
            "'-1 mm'",
            "not negative",
        ),
        (
            "surface = { shape = 'egg' }\nlaw = 'rolling'",
            "",
            "'egg'",
            "one of sphere, ellipsoid, rim, cylinder",
        ),
        (BALL, "", "[contact]", "law"),
        (&format!("{BALL}law = 'sliding'"), "", "'sliding'", "one of rolling, friction, frictionless"),
        (&format!("{BALL}law = 'friction'\nrolls = true"), "", "[contact]", "friction"),
        (&format!("{BALL}law = 'friction'\nfriction = -0.1"), "", "-0.1", "not negative"),
        (
            &format!("{slides}\nstatic_friction = 0.2\nrolls = true"),
            "",
            "0.2",
            "at least the kinetic coefficient, friction = 0.3",
        ),
        (&format!("{slides}\nviscous = '3 m'\nrolls = true"), "", "'3 m'", "in kg s^-1"),
        (&format!("{rolling}\nfriction = 0.3"), "", "0.3", "left out with law = \"rolling\""),
        (&format!("{rolling}\nrolling_friction = '-1 mm'"), "", "'-1 mm'", "not negative"),
        (&format!("{rolling}\nrolling_friction = '1 mm'"), "", "'1 mm'", "the rate of rolling"),
        (&slides, "", "[contact]", "rolls"),
        (&format!("{slides}\nrolls = false"), "", "false", "unless [start] has a velocity"),
        (
            &format!("{slides}\nrolls = true"),
            "velocity = [1, 0, 0]",
            "[1, 0, 0]",
            "left out with rolls = true",
        ),
        (&format!("{rolling}\nrolls = true"), "", "true", "left out with law = \"rolling\""),
        (&rolling, "velocity = [1, 0, 0]", "[1, 0, 0]", "the slip at the start"),
        (&slides, "velocity = [1, 0, 0.5]", "[1, 0, 0.5]", "along the normal"),
        (&format!("{rolling}\nat = [0, 0, '1 mm']"), "", "[0, 0, '1 mm']", "hovers"),
        (&format!("{rolling}\nat = [0, 0, '-1 mm']"), "", "[0, 0, '-1 mm']", "penetrates"),
        (&format!("{rolling}\nground = {{ normal = [0, 0, 0] }}"), "", "[0, 0, 0]", "direction"),
        (
            &format!("{rolling}\nground = {{ normal = [0, 0, 1], slope = '3 deg' }}"),
            "",
            "'3 deg'",
            "both define",
        ),
        (&format!("{rolling}\nground = {{ slope = '90 deg' }}"), "", "'90 deg'", "between -90 and 90 deg"),
        (&format!("{rolling}\nground = {{ shape = 'plane', radius = 1 }}"), "", "radius", "unknown key"),
        (
            &format!("{rolling}\nground = {{ shape = 'sphere', radius = 1 }}"),
            "",
            "{ shape = 'sphere', radius = 1 }",
            "side",
        ),
        (
            &bowl("'0.2 m'"),
            "",
            "{ shape = 'sphere', radius = '0.2 m', side = 'inside' }",
            "the radius of the ground",
        ),
        (&format!("{}\ngravity = [0, 0, 0]", bowl("1")), "", "[contact]", "at"),
        (
            "surface = { shape = 'sphere', radius = 0.2, position = [0.3, 0, 0] }\nlaw = 'rolling'",
            "",
            "{ shape = 'sphere', radius = 0.2, position = [0.3, 0, 0] }",
            "inside the surface",
        ),
        ("surface = { shape = 'rim', radius = 0.2 }\nlaw = 'rolling'", "", "[start]", "lies flat"),
        (lying, "", "[start]", "its axis lies along the ground"),
        (
            lying,
            &format!("{laid}spin = {{ body = [1, 0, 2] }}"),
            "{ body = [1, 0, 2] }",
            "about its own axis alone",
        ),
        (
            &format!("{lying}\nground = {{ shape = 'sphere', radius = 1, side = 'outside' }}"),
            laid,
            "{ shape = 'sphere', radius = 1, side = 'outside' }",
            "a plane or a cylinder",
        ),
        (lying, laid, "{ shape = 'cylinder', radius = 0.2 }", "a principal axis"),
    ];
    for (contact, start, place, message) in cases {
        let text = text(contact, start);
        let error = parse(&text).err().unwrap_or_else(|| panic!("{contact}\n{start} is read"));
        let found = error.place().unwrap_or_else(|| panic!("{error}"));
        let shown = error.to_string();
        assert_eq!(text.get(found.span.clone()), Some(*place), "{contact}\n{start}\n{shown}");
        assert!(shown.contains(message), "{contact}\n{start}\n{shown}");
        assert!(shown.starts_with(&format!("test.toml:{}:{}: ", found.line, found.column)), "{shown}");
    }
}

#[test]
fn what_excludes_a_contact_is_refused() {
    let base = text(&format!("{BALL}law = 'rolling'"), "");
    for (more, place, why) in [
        (
            "[[torque]]\nmodel = 'drag'\ncoefficient = 1",
            "[[torque]]",
            "only gravity and the contact force act",
        ),
        ("[orbit]\naltitude = '400 km'", "[orbit]", "not in orbit"),
        ("[[wheel]]\naxis = [0, 0, 1]\nmomentum = 1", "[[wheel]]", "one rigid body"),
        ("[sweep]\nmembers = 3", "[sweep]", "sweeps have no outcomes"),
        ("[body]\npivot = [0, 0, 0]", "[0, 0, 0]", "left out with [contact]"),
        (
            "[[event]]\nmeasure = 'total_energy'\nvalue = 1",
            "'total_energy'",
            "includes that of its centre of mass",
        ),
    ] {
        // [body] precedes its parts.
        let text =
            if more.starts_with("[body]") { format!("{more}\n{base}") } else { format!("{base}{more}\n") };
        let error = parse(&text).err().unwrap_or_else(|| panic!("{more} is read"));
        let shown = error.to_string();
        assert!(shown.contains(why), "{more}: {shown}");
        let found = text.get(error.place().unwrap().span.clone()).unwrap();
        assert!(found == place || found.starts_with(place), "{more}: {found:?} {shown}");
    }
    let splitting = base.replace("samples = 5", "samples = 5\nmethod = 'dop853'");
    let error = parse(&splitting).unwrap_err();
    assert_eq!(splitting.get(error.place().unwrap().span.clone()), Some("'dop853'"), "{error}");
    let needle = base.replace(&BODY[BODY.find("inertia").unwrap()..], "moments = [1, 1, 0]\n");
    let error = parse(&needle).unwrap_err();
    assert!(error.to_string().contains("a needle"), "{error}");
}

#[test]
fn a_tolerance_that_is_too_loose_for_a_contact_is_reported() {
    let at = |tolerance: &str| {
        let text = text(&format!("{BALL}law = 'rolling'"), "spin = { body = [1, 2, 3] }");
        parse(&format!("{text}tolerance = {tolerance}\n")).unwrap()
    };
    let loose = at("1e-3");
    let found = loose.findings().iter().find(|finding| finding.code == "run.tolerance").unwrap();
    assert!(found.message.starts_with("the tolerance is 1e-12 a step, not 1e-3:"), "{}", found.message);
    assert!(at("1e-12").findings().iter().all(|finding| finding.code != "run.tolerance"));
}

#[test]
fn a_velocity_along_the_ground_is_suggested_without_rounding() {
    let sphere = "[[body.part]]\nshape = 'sphere'\nradius = 0.1\nmass = 1\n";
    let refused = |velocity: &str| {
        let contact = "surface = { shape = 'sphere', radius = 0.1 }\nlaw = 'friction'\nfriction = 0.1\nground = { slope = '30 deg' }";
        let text = format!("{sphere}[contact]\n{contact}\n[start]\nvelocity = {velocity}\n{RUN}");
        parse(&text).unwrap_err().hint().unwrap_or_default().to_owned()
    };
    let along = refused("[0.5, 0, 0.8660254037844386]");
    assert!(along.ends_with("velocity = [0.0, 0.0, 0.0]"), "{along}");
    let fast = refused("[1e300, 0, 0]");
    assert!(fast.contains("e299, 0.0, -") && fast.len() < 200, "{fast}");
}
