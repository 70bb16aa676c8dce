//! Impossible starts and impossible contacts.

use core::f64::consts::FRAC_PI_2;

use polhode::math::{Direction, Rotation, Velocity};
use polhode::motion::contact::{
    BodySurface, Contact, ContactLaw, ContactStart, Friction, Ground, GroundShape, GroundSide, Resistance,
    StartVelocity, SurfaceShape,
};
use polhode::motion::{Event, EventAction, GroundContact, Measure, MotionError, Sense};
use polhode::prelude::*;

use super::{ball, generic_body, state, surface};

fn error(body: &MassProperties<Body>, contact: Contact, start: ContactStart) -> MotionError {
    Simulation::on_ground(body, &contact, start, &[1.0]).run().unwrap_err()
}

/// Returns the parameter that is refused.
fn refused(body: &MassProperties<Body>, contact: Contact, start: ContactStart) -> String {
    let error = error(body, contact, start);
    assert!(error.is_parameter(), "{error}");
    error.to_string()
}

fn sphere() -> SurfaceShape {
    SurfaceShape::Sphere { radius: 0.3 }
}

#[test]
fn what_violates_the_contact_is_refused() {
    let contact = Contact::rolling(surface(sphere(), [0.0; 3]));
    let start = ContactStart::rolling(state(Attitude::identity(), [0.0, 1.0, 0.0]));
    let hovers = ContactStart { at: Position::new(0.0, 0.0, 0.01), ..start };
    assert!(refused(&ball(0.3), contact, hovers).contains("hovers"));
    let penetrates = ContactStart { at: Position::new(0.0, 0.0, -0.01), ..start };
    assert!(refused(&ball(0.3), contact, penetrates).contains("penetrates"));
    let slips = ContactStart { velocity: StartVelocity::Along(Velocity::new(0.5, 0.0, 0.0)), ..start };
    assert!(refused(&ball(0.3), contact, slips).contains("slip at the start"));
    let rolls = ContactStart { velocity: StartVelocity::Along(Velocity::new(0.3, 0.0, 0.0)), ..start };
    assert!(Simulation::on_ground(&ball(0.3), &contact, rolls, &[1.0]).run().is_ok());
    let law = ContactLaw::with_friction(Friction { sticking: 0.3, kinetic: 0.3, viscous: 0.0 }).unwrap();
    let leaves = ContactStart { velocity: StartVelocity::Along(Velocity::new(0.5, 0.0, 0.2)), ..start };
    assert!(refused(&ball(0.3), Contact { law, ..contact }, leaves).contains("along the normal"));
    let still = ContactStart::rolling(state(Attitude::identity(), [0.0, 0.0, 2.0]));
    let law = ContactLaw::ROLLING.resisted_by(Resistance { rolling: 1e-3, pivoting: 0.0 }).unwrap();
    assert!(refused(&ball(0.3), Contact { law, ..contact }, still).contains("rate of rolling"));
}

#[test]
fn bodies_and_grounds_that_cannot_be_are_refused() {
    let start = ContactStart::rolling(state(Attitude::identity(), [0.3, 1.0, 0.2]));
    let outside = surface(SurfaceShape::Ellipsoid { semi_axes: [0.3, 0.2, 0.1] }, [0.0, 0.0, 0.11]);
    assert!(refused(&generic_body(), Contact::rolling(outside), start).contains("inside the surface"));
    let bowl = |radius| {
        let shape = GroundShape::Sphere { radius, side: GroundSide::Inside };
        Ground::new(shape, Direction::new(0.0, 0.0, 1.0)).unwrap()
    };
    let ellipsoid = surface(SurfaceShape::Ellipsoid { semi_axes: [0.3, 0.2, 0.2] }, [0.0; 3]);
    let contact = Contact { ground: bowl(0.44), ..Contact::rolling(ellipsoid) };
    let at = Position::new(0.0, 0.0, -0.44);
    assert!(refused(&generic_body(), contact, ContactStart { at, ..start }).contains("more than one point"));
    let thick = surface(SurfaceShape::Rim { radius: 0.2, tube: 0.0, thickness: 0.02 }, [0.0; 3]);
    let upright = Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), FRAC_PI_2).unwrap();
    // An exact right angle: the axis of the disk is along x.
    let exact = Rotation::from_matrix([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).unwrap();
    let stands = ContactStart::rolling(state(exact, [0.0, 0.0, 3.0]));
    assert!(refused(&generic_body(), Contact::rolling(thick), stands).contains("both of its rims"));
    let lying = surface(SurfaceShape::Cylinder { radius: 0.2, length: None }, [0.0; 3]);
    let round = InertiaTensor::diagonal([0.06, 0.06, 0.09]).unwrap();
    let round = MassProperties::new(2.0, Position::ZERO, round).unwrap();
    let across = ContactStart::rolling(state(upright, [0.0, 0.5, 3.0]));
    assert!(refused(&round, Contact::rolling(lying), across).contains("its own axis alone"));
    let tilted = Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), 1.2).unwrap();
    let tilted = ContactStart::rolling(state(tilted, [0.0, 0.0, 3.0]));
    assert!(refused(&round, Contact::rolling(lying), tilted).contains("the tilt of a lying cylinder"));
    let needle = InertiaTensor::diagonal([0.1, 0.1, 0.0]).unwrap();
    let needle = MassProperties::new(1.0, Position::ZERO, needle).unwrap();
    assert!(refused(&needle, Contact::rolling(surface(sphere(), [0.0; 3])), start).contains("needle"));
    let none = ContactStart::rolling(state(Attitude::identity(), [f64::NAN, 0.0, 0.0]));
    assert!(refused(&generic_body(), Contact::rolling(surface(sphere(), [0.0; 3])), none).contains("finite"));
}

#[test]
fn numbers_that_cannot_be_are_refused() {
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let shape = SurfaceShape::Sphere { radius };
        assert!(BodySurface::new(shape, Position::ZERO, Rotation::identity()).is_err(), "{radius}");
        let shape = GroundShape::Cylinder { radius, side: GroundSide::Outside };
        assert!(Ground::new(shape, Direction::new(0.0, 0.0, 1.0)).is_err(), "{radius}");
    }
    assert!(Ground::new(GroundShape::Plane, Direction::ZERO).is_err());
    assert!(Ground::LEVEL.turning_at(f64::NAN).is_err());
    let friction =
        |sticking, kinetic, viscous| ContactLaw::with_friction(Friction { sticking, kinetic, viscous });
    assert!(friction(0.3, 0.3, 0.0).is_ok());
    for bad in [
        friction(-0.1, -0.1, 0.0),
        friction(0.2, 0.3, 0.0),
        friction(0.3, 0.3, -1.0),
        friction(f64::NAN, 0.1, 0.0),
    ] {
        assert!(bad.is_err());
    }
    assert!(ContactLaw::ROLLING.resisted_by(Resistance { rolling: -1.0, pivoting: 0.0 }).is_err());
}

/// A rod that is pushed along the ground with its lower end ahead: no normal force is large enough
/// (Painlevé 1895).
#[test]
fn painleves_paradox_is_named() {
    let inertia = InertiaTensor::diagonal([0.0005, 0.084, 0.084]).unwrap();
    let body = MassProperties::new(1.0, Position::ZERO, inertia).unwrap();
    let rod = surface(SurfaceShape::Ellipsoid { semi_axes: [0.5, 0.03, 0.03] }, [0.0; 3]);
    let friction = Friction { sticking: 1.8, kinetic: 1.8, viscous: 0.0 };
    let contact = Contact { law: ContactLaw::with_friction(friction).unwrap(), ..Contact::rolling(rod) };
    // The x axis is at 0.95 rad from the level, its upper end towards +x.
    let attitude = Rotation::from_axis_angle(Direction::new(0.0, 1.0, 0.0), -0.95).unwrap();
    let start = |v: f64| ContactStart {
        velocity: StartVelocity::Along(Velocity::new(v, 0.0, 0.0)),
        ..ContactStart::rolling(state(attitude, [0.0; 3]))
    };
    // Drawn with its upper end ahead, it slides.
    let found = [1.0, -1.0].map(|v| Simulation::on_ground(&body, &contact, start(v), &[0.01]).run());
    let paradox = |r: &Result<_, _>| matches!(r, Err(MotionError::Painleve { .. }));
    assert_eq!(found.each_ref().map(paradox), [false, true], "{found:?}");
}

#[test]
fn what_acts_on_no_body_on_the_ground_is_refused() {
    let contact = Contact::rolling(surface(sphere(), [0.0; 3]));
    let ground = GroundContact { contact, at: Position::ZERO, velocity: StartVelocity::Rolling };
    let free =
        || Scenario::new(generic_body()).starting(state(Attitude::identity(), [0.3, 1.0, 0.2])).unwrap();
    assert!(free().on_ground(ground).is_ok());
    let held = free().held_at(Position::new(0.0, 0.0, 0.1)).unwrap();
    assert!(matches!(
        held.on_ground(ground),
        Err(MotionError::Exclusive { parts: ["contact", "pivot"], .. })
    ));
    let torque = TorqueModel::Gravity(UniformGravity::STANDARD);
    assert!(free().with_torques([torque]).unwrap().on_ground(ground).is_err());
    let energy = Event::new("e", Measure::TotalEnergy, 1.0, Sense::Either, EventAction::Record).unwrap();
    assert!(free().watching(vec![energy]).unwrap().on_ground(ground).is_err());
    let rate = Event::new("slow", Measure::Rate, 0.5, Sense::Falling, EventAction::Stop).unwrap();
    assert!(free().watching(vec![rate]).unwrap().on_ground(ground).is_ok());
}
