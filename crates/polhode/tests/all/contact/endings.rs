//! Ends of motions and of phases, compared with known results.

use polhode::math::{Direction, Rotation, Space, Torque};
use polhode::motion::contact::{
    Contact, ContactChange, ContactLaw, ContactStart, ContactState, Friction, Ground, GroundShape,
    GroundSide, Resistance, SurfaceShape,
};
use polhode::motion::{Ending, MotionError};
use polhode::prelude::*;

use crate::common::held::Held;

use super::{G, ball, generic_body, near, run, state, surface};

/// Returns the change of contact that ended a motion, if one did.
fn ended_by(motion: &Held<ContactState>) -> Option<ContactChange> {
    match motion.ending() {
        Ending::Contact { change, .. } => Some(*change),
        _ => None,
    }
}

/// A body that leaves level ground returns and touches it. This includes surfaces whose lowest
/// point contains a root.
#[test]
fn what_lands_touches_the_ground() {
    let shapes = [
        SurfaceShape::Sphere { radius: 0.3 },
        SurfaceShape::Ellipsoid { semi_axes: [0.3, 0.05, 0.05] },
        SurfaceShape::Rim { radius: 0.1, tube: 0.0, thickness: 0.0 },
        SurfaceShape::Rim { radius: 0.1, tube: 0.02, thickness: 0.0 },
    ];
    let attitude = Rotation::from_axis_angle(Direction::new(0.48, 0.6, 0.64), 0.8).unwrap();
    for shape in shapes {
        let mut landed = 0;
        for omega in [[3.0, 25.0, 5.0], [60.0, 1.0, 20.0], [20.0, -30.0, 10.0]] {
            let surface = surface(shape, [0.01, -0.012, 0.008]);
            let contact = Contact { law: ContactLaw::FRICTIONLESS, ..Contact::rolling(surface) };
            let start = ContactStart::rolling(state(attitude, omega));
            let motion = run(&generic_body(), &contact, start, &[20.0]);
            if ended_by(&motion) != Some(ContactChange::Lands) {
                continue;
            }
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
    let attitude = Rotation::from_axis_angle(Direction::new(0.48, 0.6, 0.64), 0.8).unwrap();
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

/// A lying cylinder is refused if it does not turn about a principal axis, if friction resists its
/// pivoting, or if the ground turns below it.
#[test]
fn a_cylinder_that_would_not_keep_its_axis_is_refused() {
    let attitude =
        Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), -core::f64::consts::FRAC_PI_2).unwrap();
    let start = ContactStart::rolling(state(attitude, [0.0, 0.0, 2.0]));
    let rolling = Contact::rolling(surface(SurfaceShape::Cylinder { radius: 0.3, length: None }, [0.0; 3]));
    let symmetric =
        MassProperties::new(2.0, Position::ZERO, InertiaTensor::diagonal([0.06, 0.06, 0.09]).unwrap())
            .unwrap();
    let refused = |body: &MassProperties<Body>, contact: Contact| {
        let error: MotionError = Simulation::on_ground(body, &contact, start, &[1.0]).run().unwrap_err();
        error.to_string()
    };
    assert!(Simulation::on_ground(&symmetric, &rolling, start, &[1.0]).run().is_ok());
    assert!(refused(&generic_body(), rolling).contains("principal axis"));
    let ground = Ground::LEVEL.turning_at(1.0).unwrap();
    assert!(refused(&symmetric, Contact { ground, ..rolling }).contains("direction of its axis"));
    let law = ContactLaw::ROLLING.resisted_by(Resistance { rolling: 0.0, pivoting: 1e-3 }).unwrap();
    assert!(refused(&symmetric, Contact { law, ..rolling }).contains("does not pivot"));
    // Slip without friction never ends.
    assert!(ContactLaw::with_friction(Friction { sticking: 0.3, kinetic: 0.0, viscous: 0.1 }).is_err());
}

/// A disk falls over without spin, about its resting point or with its centre moving straight down.
/// Energy conservation gives the rate at which it lies flat, to within the threshold of inclination
/// 1e-8.
#[test]
fn a_disk_that_falls_over_lies_flat() {
    let (radius, mass, a) = (0.2, 1.7, 0.0313);
    let body =
        MassProperties::new(mass, Position::ZERO, InertiaTensor::diagonal([a, a, 0.0507]).unwrap()).unwrap();
    let tilt = 1.2_f64;
    let rim = surface(SurfaceShape::Rim { radius, tube: 0.0, thickness: 0.0 }, [0.0; 3]);
    // Along a coordinate axis, the perpendicular components remain exactly zero.
    let axes = [Direction::new(0.6, 0.8, 0.0), Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 1.0, 0.0)];
    let laws = [ContactLaw::ROLLING, ContactLaw::FRICTIONLESS];
    for (axis, law) in axes.into_iter().flat_map(|axis| laws.map(|law| (axis, law))) {
        let attitude = Rotation::from_axis_angle(axis, tilt).unwrap();
        let start = ContactStart::rolling(state(attitude, [0.0; 3]));
        let motion = run(&body, &Contact { law, ..Contact::rolling(rim) }, start, &[10.0]);
        assert_eq!(ended_by(&motion), Some(ContactChange::LiesFlat));
        let end = motion.samples().last().unwrap();
        // In both cases the centre moves straight down at the end, at R ω.
        let moment = a + mass * radius * radius;
        near(end.state.omega.norm().powi(2), 2.0 * mass * G * radius * tilt.sin() / moment, 1e-6);
        near(end.center.z, 0.0, 3e-9);
    }
}

/// A thick disk inclined within its base falls back onto its other rim, turning about its resting
/// point.
#[test]
fn a_thick_disk_falls_back_onto_its_other_rim() {
    let (radius, half, mass, a) = (0.2, 0.05, 1.7, 0.0413);
    let body =
        MassProperties::new(mass, Position::ZERO, InertiaTensor::diagonal([a, a, 0.0507]).unwrap()).unwrap();
    let lean = 0.15_f64;
    let attitude =
        Rotation::from_axis_angle(Direction::new(0.6, 0.8, 0.0), core::f64::consts::FRAC_PI_2 - lean)
            .unwrap();
    let start = ContactStart::rolling(state(attitude, [0.0; 3]));
    let rim = surface(SurfaceShape::Rim { radius, tube: 0.0, thickness: 2.0 * half }, [0.0; 3]);
    let motion = run(&body, &Contact::rolling(rim), start, &[10.0]);
    assert_eq!(ended_by(&motion), Some(ContactChange::OtherRim));
    let fallen = radius * lean.cos() + half * lean.sin() - radius;
    let moment = a + mass * (radius * radius + half * half);
    let end = motion.samples().last().unwrap();
    near(end.state.omega.norm().powi(2), 2.0 * mass * G * fallen / moment, 1e-10);
    near(end.center.z, radius, 1e-12);
    // A disk inclined beyond its base falls onto its face.
    let attitude = Rotation::from_axis_angle(Direction::new(0.6, 0.8, 0.0), 1.2).unwrap();
    let motion =
        run(&body, &Contact::rolling(rim), ContactStart::rolling(state(attitude, [0.0; 3])), &[10.0]);
    assert_eq!(ended_by(&motion), Some(ContactChange::LiesFlat));
    let fallen = radius * 1.2_f64.sin() + half * 1.2_f64.cos() - half;
    let end = motion.samples().last().unwrap();
    near(end.state.omega.norm().powi(2), 2.0 * mass * G * fallen / moment, 1e-6);
}

/// A disk that falls over in a bowl touches it with its whole rim where the sine of its inclination
/// is r/ρ.
#[test]
fn a_disk_that_falls_over_in_a_bowl_osculates() {
    let (bowl, radius, mass, a) = (0.9, 0.2, 1.7, 0.0313);
    let body =
        MassProperties::new(mass, Position::ZERO, InertiaTensor::diagonal([a, a, 0.0507]).unwrap()).unwrap();
    let ground = GroundShape::Sphere { radius: bowl, side: GroundSide::Inside };
    let ground = Ground::new(ground, Direction::new(0.0, 0.0, 1.0)).unwrap();
    let rim = surface(SurfaceShape::Rim { radius, tube: 0.0, thickness: 0.0 }, [0.0; 3]);
    let tilt = 1.2_f64;
    let attitude = Rotation::from_axis_angle(Direction::new(0.6, 0.8, 0.0), tilt).unwrap();
    let start = ContactStart {
        at: Position::new(0.0, 0.0, -bowl),
        ..ContactStart::rolling(state(attitude, [0.0; 3]))
    };
    let motion = run(&body, &Contact { ground, ..Contact::rolling(rim) }, start, &[10.0]);
    assert_eq!(
        ended_by(&motion),
        Some(ContactChange::Osculates),
        "{:?} {:?}",
        motion.ending(),
        motion.changes()
    );
    let end = motion.samples().last().unwrap();
    let axis: Direction<Space> = end.state.attitude * Direction::new(0.0, 0.0, 1.0);
    near(axis.cross(end.normal).norm(), radius / bowl, 1e-8);
    let moment = a + mass * radius * radius;
    let fallen = radius * (tilt.sin() - radius / bowl);
    near(end.state.omega.norm().powi(2), 2.0 * mass * G * fallen / moment, 1e-6);
}

/// A ball with three moments that friction prevents from pivoting until friction is too small.
#[test]
fn a_ball_is_held_from_pivoting_and_pivots_anew() {
    let levers = Resistance { rolling: 0.0, pivoting: 0.002 };
    let law = ContactLaw::ROLLING.resisted_by(levers).unwrap();
    let contact =
        Contact { law, ..Contact::rolling(surface(SurfaceShape::Sphere { radius: 0.2 }, [0.0; 3])) };
    let attitude = Rotation::from_axis_angle(Direction::new(0.48, 0.6, 0.64), 0.8).unwrap();
    let start = ContactStart::rolling(state(attitude, [5.0, -3.0, 1.0]));
    let times: Vec<f64> = (0..=400).map(|k| 0.01 * f64::from(k)).collect();
    let motion = run(&generic_body(), &contact, start, &times);
    let [stops, anew, ..] = motion.changes() else { panic!("{:?}", motion.changes()) };
    assert_eq!([stops.change, anew.change], [ContactChange::PivotingStops, ContactChange::Pivots]);
    assert!(motion.energy_drift() < 1e-12, "{:e}", motion.energy_drift());
    let mut held = 0;
    for sample in motion.samples() {
        let time = sample.state.time;
        let pivoting = (sample.state.attitude * sample.state.omega).z;
        let torque: Torque<Space> = sample.state.attitude * sample.torque;
        // Of the forces at a ball's lowest point, only pivoting friction has a torque about the
        // vertical.
        if stops.time < time && time < anew.time {
            held += 1;
            near(pivoting, 0.0, 1e-12);
            assert!(torque.z.abs() < levers.pivoting * sample.normal_force, "{time}");
        } else if time < stops.time {
            near(torque.z, -pivoting.signum() * levers.pivoting * sample.normal_force, 1e-12);
        }
    }
    assert!(held > 0);
    let times = [anew.time - 1e-7, anew.time + 1e-3];
    let motion = run(&generic_body(), &contact, start, &times);
    let [before, after] = motion.samples() else { panic!("two times") };
    let torque: Torque<Space> = before.state.attitude * before.torque;
    near(torque.z.abs() / (levers.pivoting * before.normal_force), 1.0, 1e-5);
    let pivoting = (after.state.attitude * after.state.omega).z;
    assert!(pivoting * torque.z < 0.0 && pivoting.abs() > 1e-9, "{pivoting:e}");
}

/// Rolling at N = 0 may require friction that is not available. Without it the body would
/// penetrate the ground, so it does not lift off.
#[test]
fn what_friction_held_down_does_not_lift_off() {
    let inertia = InertiaTensor::diagonal([0.004, 0.006, 0.005]).unwrap();
    let body = MassProperties::new(1.0, Position::ZERO, inertia).unwrap();
    let sphere = surface(SurfaceShape::Sphere { radius: 0.1 }, [0.03, 0.02, 0.04]);
    let start = ContactStart::rolling(state(Rotation::identity(), [3.0, 30.0, 5.0]));
    let motion = run(&body, &Contact::rolling(sphere), start, &[0.0, 0.04, 1.0]);
    assert!(
        matches!(motion.ending(), Ending::Failed { cause: MotionError::Undecided { .. }, .. }),
        "{:?}",
        motion.ending()
    );
    assert_eq!(motion.changes(), []);
}

/// `states` returns the states of a run as far as the motion is known, and refuses a run that ends
/// earlier.
#[test]
fn states_end_where_the_contact_does() {
    let (radius, mass, a) = (0.2, 1.7, 0.0313);
    let body =
        MassProperties::new(mass, Position::ZERO, InertiaTensor::diagonal([a, a, 0.0507]).unwrap()).unwrap();
    let rim = surface(SurfaceShape::Rim { radius, tube: 0.0, thickness: 0.0 }, [0.0; 3]);
    let contact = Contact::rolling(rim);
    let attitude = Rotation::from_axis_angle(Direction::new(0.6, 0.8, 0.0), 1.2).unwrap();
    let start = ContactStart::rolling(state(attitude, [0.0; 3]));
    let times = [0.0, 0.1, 0.2];
    let simulation = Simulation::on_ground(&body, &contact, start, &times);
    let states: Vec<State> = simulation.run().unwrap().samples().iter().map(|s| s.state).collect();
    assert_eq!(simulation.states().unwrap(), states);
    let error = Simulation::on_ground(&body, &contact, start, &[10.0]).states().unwrap_err();
    assert!(matches!(error, MotionError::ContactChanged { .. }), "{error}");
    assert!(error.is_numerical() && error.to_string().contains("the disk lies flat"), "{error}");
    for refused in [simulation.switched_off(&[0]), simulation.method(Method::Dop853)] {
        assert!(matches!(refused.run(), Err(MotionError::Exclusive { .. })));
    }
}
