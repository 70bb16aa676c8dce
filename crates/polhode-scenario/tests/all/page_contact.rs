//! Page data of a body on the ground.

use polhode::body::shape::Ellipsoid;
use polhode::motion::GroundContact;
use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{
    BodySurface, Contact, ContactLaw, Friction, Ground, GroundShape, StartVelocity, SurfaceShape,
};
use polhode::prelude::*;
use serde_json::Value;

use crate::common::held::Held;
use crate::page::{number, page_of};

/// A lead egg spins, slips and then rolls on a rotating slope. If `is_shown`, its contact surface
/// is that of its part.
fn on_slope(is_shown: bool) -> Scenario {
    let half = [0.021, 0.024, 0.031];
    let part = crate::common::solid("egg", "ellipsoid", &Ellipsoid::new(half).unwrap(), 0.06, [0.0; 3], 0.0);
    let scenario = crate::common::scenario("An egg", vec![part]);
    let scenario = crate::common::facing(scenario, Attitude::from_quaternion([0.8, 0.5, -0.2, 0.3]).unwrap());
    let scenario = crate::common::spinning(scenario, AngularVelocity::new(3.0, -7.0, 11.0));
    let scenario = scenario.sampled(crate::common::run(0.4, 201));
    let semi_axes = if is_shown { half } else { half.map(|a| 1.1 * a) };
    let surface =
        BodySurface::new(SurfaceShape::Ellipsoid { semi_axes }, Position::ZERO, Rotation::identity())
            .unwrap();
    let ground = Ground::new(GroundShape::Plane, Direction::new(0.05, -0.02, 1.0)).unwrap();
    let friction = Friction { sticking: 0.06, kinetic: 0.05, viscous: 0.0 };
    let contact = Contact {
        surface,
        ground: ground.turning_at(0.7).unwrap(),
        law: ContactLaw::with_friction(friction).unwrap(),
        gravity: Acceleration::new(0.0, 0.0, -9.81),
    };
    let velocity = StartVelocity::Rolling;
    scenario.on_ground(GroundContact { contact, at: Position::ZERO, velocity }).unwrap()
}

/// Scenario for the check of the data format; it has a separate contact surface.
pub(crate) fn egg() -> Scenario {
    on_slope(false)
}

fn row(value: &Value) -> Vec<f64> {
    let bytes = crate::page::bytes(value);
    bytes.chunks_exact(8).map(|eight| f64::from_le_bytes(eight.try_into().unwrap())).collect()
}

#[test]
fn the_point_of_contact_is_where_the_body_and_the_ground_have_it() {
    let (data, trajectory) = page_of(&on_slope(false));
    let contact = &data["motion"]["contact"];
    let motion = Held::of(trajectory, CONTACT);
    let three = |rows: &[f64], k: usize| -> [f64; 3] { std::array::from_fn(|c| rows[3 * k + c]) };
    let (center, point) = (row(&contact["center"]), row(&contact["point"]));
    let scalars =
        ["normalForce", "friction", "slip", "frictionWork", "groundWork"].map(|key| row(&contact[key]));
    assert_eq!(motion.samples().len(), 201);
    for (k, sample) in motion.samples().iter().enumerate() {
        assert_eq!(three(&center, k), sample.center.to_array());
        assert_eq!(three(&point, k), sample.contact.to_array());
        let wanted = [
            sample.normal_force,
            sample.friction.norm(),
            sample.slip.norm(),
            sample.friction_work,
            sample.ground_work,
        ];
        assert_eq!(scalars.each_ref().map(|values| values[k]), wanted);
        // The viewer computes the point of contact in the body in this way.
        let arm = sample.state.attitude.inverse() * (sample.contact - sample.center);
        assert!((arm - sample.contact_in_body).norm() < 1e-14, "{k}");
    }
}

#[test]
fn phases_are_those_of_the_samples_and_changes_are_events() {
    let (data, trajectory) = page_of(&on_slope(true));
    let motion = Held::of(trajectory, CONTACT);
    assert!(!motion.changes().is_empty());
    let phases = data["motion"]["contact"]["phases"].as_array().unwrap();
    for sample in motion.samples() {
        let t = sample.state.time;
        let within = |phase: &&Value| number(&phase["from"]) <= t && t <= number(&phase["to"]);
        let mut named = phases.iter().filter(within).map(|phase| phase["name"].as_str().unwrap());
        assert!(named.any(|name| name == sample.phase.name()), "{t}");
    }
    let events = data["motion"]["events"].as_array().unwrap();
    assert_eq!(events.len(), motion.changes().len());
    for (event, change) in events.iter().zip(motion.changes()) {
        assert_eq!(event["name"], change.change.name());
        assert_eq!(number(&event["time"]), change.time);
    }
}

#[test]
fn the_surface_is_shown_beside_the_parts_unless_it_is_theirs() {
    let surface = |is_shown| page_of(&on_slope(is_shown)).0["motion"]["contact"]["surface"].clone();
    assert_eq!(surface(true), Value::Null);
    let beside = surface(false);
    assert_eq!(beside["kind"], "ellipsoid");
    assert!((number(&beside["half"][2]) - 1.1 * 0.031).abs() < 1e-16);
    // If only the tensor of the body is known, the contact surface is its visible shape.
    let mut ground = on_slope(false).ground().copied().unwrap();
    let scenario = crate::common::tensor("A celt", [2e-5, 2.2e-5, 2.5e-5], [1e-6, 0.0, 0.0], [0.1, 0.2, 0.3]);
    let center = scenario.body().center_of_mass();
    ground.contact.surface =
        BodySurface::new(*ground.contact.surface.shape(), center, Rotation::identity()).unwrap();
    let scenario = scenario.sampled(crate::common::run(0.01, 3));
    let (data, _) = page_of(&scenario.on_ground(ground).unwrap());
    assert_eq!(data["motion"]["contact"]["surface"], Value::Null);
    assert_eq!(data["body"]["shapes"][0]["half"], beside["half"]);
}
