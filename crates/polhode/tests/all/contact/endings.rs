//! What ends a motion or one of its phases, against what is known of it.

use polhode::math::{Direction, Rotation};
use polhode::motion::MotionError;
use polhode::motion::contact::{
    Contact, ContactChange, ContactEnding, ContactLaw, ContactSimulation, ContactStart, Friction, Ground,
    Resistance, SurfaceShape,
};
use polhode::prelude::*;

use super::{G, ball, generic_body, near, run, state, surface};

/// What leaves level ground comes back to it, and touches it then: of surfaces whose lowest point has a root in it too.
#[test]
fn what_lands_touches_the_ground() {
    let shapes = [
        SurfaceShape::Sphere { radius: 0.3 },
        SurfaceShape::Ellipsoid { semi_axes: [0.3, 0.05, 0.05] },
        SurfaceShape::Rim { radius: 0.1, tube: 0.0, thickness: 0.0 },
        SurfaceShape::Rim { radius: 0.1, tube: 0.02, thickness: 0.0 },
    ];
    let attitude = Rotation::about(Direction::new(0.48, 0.6, 0.64), 0.8).unwrap();
    for shape in shapes {
        let mut landed = 0;
        for omega in [[3.0, 25.0, 5.0], [60.0, 1.0, 20.0], [20.0, -30.0, 10.0]] {
            let surface = surface(shape, [0.01, -0.012, 0.008]);
            let contact = Contact { law: ContactLaw::FRICTIONLESS, ..Contact::rolling(surface) };
            let start = ContactStart::rolling(state(attitude, omega));
            let motion = run(&generic_body(), &contact, start, &[20.0]);
            let ContactEnding::Changed { change: ContactChange::Lands, .. } = motion.ending() else {
                continue;
            };
            landed += 1;
            let end = motion.samples().last().unwrap();
            near(end.contact.z, 0.0, 1e-10);
            assert!(motion.energy_drift() < 1e-13, "{shape:?}: {:e}", motion.energy_drift());
        }
        assert!(landed > 0, "{shape:?}");
    }
}

/// A homogeneous ball: I ω̇ₙ = −µₚ m g, (I + m a²) ω̇ = −µᵣ m g.
#[test]
fn friction_stops_pivoting_and_rolling() {
    let (a, levers, rates) = (0.3, Resistance { rolling: 0.004, pivoting: 0.003 }, [2.5, 1.9]);
    let law = ContactLaw::ROLLING.resisted_by(levers).unwrap();
    let contact = Contact { law, ..Contact::rolling(surface(SurfaceShape::Sphere { radius: a }, [0.0; 3])) };
    let attitude = Rotation::about(Direction::new(0.48, 0.6, 0.64), 0.8).unwrap();
    let omega: AngularVelocity<Body> =
        attitude.inverse() * AngularVelocity::new(0.6 * rates[0], -0.8 * rates[0], rates[1]);
    let motion = run(&ball(a), &contact, ContactStart::rolling(state(attitude, omega.to_array())), &[100.0]);
    let [pivoting, rolling] = motion.changes() else { panic!("{:?}", motion.changes()) };
    assert_eq!(
        [pivoting.change, rolling.change],
        [ContactChange::PivotingStops, ContactChange::RollingStops]
    );
    near(pivoting.time, 0.4 * a * a * rates[1] / (levers.pivoting * G), 1e-12);
    let time = 1.4 * a * a * rates[0] / (levers.rolling * G);
    near(rolling.time, time, 1e-11);
    let end = motion.samples().last().unwrap();
    near(end.contact.norm(), 0.5 * a * rates[0] * time, 1e-11);
    near(end.kinetic_energy, 0.0, 1e-15);
}

/// A lying cylinder that would turn off its line, or pivot, is none; a ground that turns below it neither.
#[test]
fn a_cylinder_that_would_not_keep_its_axis_is_refused() {
    let attitude = Rotation::about(Direction::new(1.0, 0.0, 0.0), -core::f64::consts::FRAC_PI_2).unwrap();
    let start = ContactStart::rolling(state(attitude, [0.0, 0.0, 2.0]));
    let rolling = Contact::rolling(surface(SurfaceShape::Cylinder { radius: 0.3, length: None }, [0.0; 3]));
    let symmetric =
        MassProperties::new(2.0, Position::ZERO, InertiaTensor::diagonal([0.06, 0.06, 0.09]).unwrap())
            .unwrap();
    let refused = |body: &MassProperties<Body>, contact: Contact| {
        let error: MotionError = ContactSimulation::new(body, &contact, start, &[1.0]).run().unwrap_err();
        error.to_string()
    };
    assert!(ContactSimulation::new(&symmetric, &rolling, start, &[1.0]).run().is_ok());
    assert!(refused(&generic_body(), rolling).contains("principal axis"));
    let ground = Ground::LEVEL.turning_at(1.0).unwrap();
    assert!(refused(&symmetric, Contact { ground, ..rolling }).contains("direction of its axis"));
    let law = ContactLaw::ROLLING.resisted_by(Resistance { rolling: 0.0, pivoting: 1e-3 }).unwrap();
    assert!(refused(&symmetric, Contact { law, ..rolling }).contains("does not pivot"));
    // What slips without friction never grips.
    assert!(ContactLaw::with_friction(Friction { sticking: 0.3, kinetic: 0.0, viscous: 0.1 }).is_err());
}
