//! Motions compared with references of 36 digits from another formulation of mechanics:
//! `fixtures/contact.py`.

use polhode::math::{Acceleration, Direction, Rotation, Velocity};
use polhode::motion::contact::{
    BodySurface, Contact, ContactChange, ContactLaw, ContactPhase, ContactStart, ContactState, Friction,
    Ground, GroundShape, GroundSide, Resistance, StartVelocity, SurfaceShape,
};
use polhode::prelude::*;
use toml::Table;

use super::run;
use crate::common::{attitude, cases, matrix, number, numbers, table};

#[test]
fn motions_are_those_of_another_formulation() {
    let table = table("contact");
    for case in cases(&table, "case") {
        let worst = error_of(case);
        let name = case["name"].as_str().unwrap();
        // Just after the onset of slip, friction is as uncertain as the direction of slip.
        let bound = if case["event"].as_str() == Some("slip") { 2e-12 } else { 1e-13 };
        assert!(worst < bound, "{name}: {worst:.2e}");
    }
}

/// Returns the largest relative difference of the stored quantities.
fn error_of(case: &Table) -> f64 {
    let name = case["name"].as_str().unwrap();
    let text = |key: &str| case[key].as_str().unwrap();
    let triple = |key: &str| numbers::<3>(&case[key]);
    let inertia = InertiaTensor::from_matrix(matrix(&case["inertia"])).unwrap();
    let body = MassProperties::new(number(&case["mass"]), Position::ZERO, inertia).unwrap();
    let shape = match (text("body"), &list(&case["size"])[..]) {
        ("sphere", [radius]) => SurfaceShape::Sphere { radius: *radius },
        ("ellipsoid", [a, b, c]) => SurfaceShape::Ellipsoid { semi_axes: [*a, *b, *c] },
        ("ring", [radius, tube]) => SurfaceShape::Rim { radius: *radius, tube: *tube, thickness: 0.0 },
        other => panic!("{other:?}"),
    };
    let surface =
        BodySurface::new(shape, Position::from_array(triple("center")), Rotation::identity()).unwrap();
    let radius = number(&case["ground_radius"]);
    let level = Direction::new(0.0, 0.0, 1.0);
    let ground = match text("ground") {
        "plane" | "turntable" => Ground::LEVEL.turning_at(number(&case["ground_rate"])),
        "inside_sphere" => Ground::new(GroundShape::Sphere { radius, side: GroundSide::Inside }, level),
        "outside_sphere" => Ground::new(GroundShape::Sphere { radius, side: GroundSide::Outside }, level),
        "inside_cylinder" => {
            let along = Direction::new(1.0, 0.0, 0.0);
            Ground::new(GroundShape::Cylinder { radius, side: GroundSide::Inside }, along)
        }
        other => panic!("{other}"),
    };
    let friction =
        |kinetic, viscous| ContactLaw::with_friction(Friction { sticking: kinetic, kinetic, viscous });
    let law = match text("law") {
        "rolling" => ContactLaw::ROLLING,
        "coulomb" => friction(number(&case["mu"]), 0.0).unwrap(),
        "viscous" => friction(0.0, number(&case["viscosity"])).unwrap(),
        "frictionless" => ContactLaw::FRICTIONLESS,
        other => panic!("{other}"),
    };
    let resistance = Resistance { rolling: number(&case["rolling"]), pivoting: number(&case["pivoting"]) };
    let law = law.resisted_by(resistance).unwrap();
    let gravity = Acceleration::from_array(triple("gravity"));
    let contact = Contact { surface, ground: ground.unwrap(), law, gravity };
    let rows = cases(case, "row");
    let times: Vec<f64> = rows.iter().map(|row| number(&row["t"])).collect();
    let attitude = attitude(&case["start_attitude"]);
    let state = State { time: 0.0, attitude, omega: AngularVelocity::from_array(triple("start_omega")) };
    let slips = triple("start_slip") != [0.0; 3];
    let velocity = if slips || text("law") == "viscous" || text("law") == "frictionless" {
        StartVelocity::Along(Velocity::from_array(numbers(&rows[0]["velocity"])))
    } else {
        StartVelocity::Rolling
    };
    let start = ContactStart { state, at: Position::from_array(triple("start_contact")), velocity };
    let motion = run(&body, &contact, start, &times);
    let changed =
        |change| motion.changes().iter().find(|event| event.change == change).map(|event| event.time);
    let found = match text("event") {
        "none" => None,
        "slip" => Some(changed(ContactChange::Slips)),
        "stick" => Some(changed(ContactChange::Grips)),
        "lift_off" => Some(changed(ContactChange::LiftsOff)),
        other => panic!("{other}"),
    };
    let mut worst: f64 = 0.0;
    if let Some(found) = found {
        let (found, wanted) = (found.unwrap_or(f64::NAN), number(&case["event_t"]));
        assert!((found - wanted).abs() < 1e-11, "{name}: {found} is not {wanted}");
        worst = worst.max(0.01 * (found / wanted - 1.0).abs());
    } else {
        assert!(motion.changes().is_empty(), "{name}: {:?}", motion.changes());
    }
    let at_event = |t: f64| text("event") != "none" && (t - number(&case["event_t"])).abs() < 1e-9;
    for (sample, row) in motion.samples().iter().zip(&rows) {
        // Rounding determines on which side of an event a sample is.
        if at_event(sample.state.time) {
            continue;
        }
        let error = error_of_sample(sample, row, &body);
        assert!(error.is_finite(), "{name} {}", sample.state.time);
        worst = worst.max(error);
    }
    assert_eq!(motion.samples().len(), rows.len(), "{name}: {:?}", motion.ending());
    worst
}

/// Returns the difference of each number relative to the largest of its kind.
fn error_of_sample(sample: &ContactState, row: &Table, body: &MassProperties<Body>) -> f64 {
    let wanted = |key: &str| numbers::<3>(&row[key]);
    let phase = match row["phase"].as_str().unwrap() {
        "rolling" => ContactPhase::Rolling,
        "gliding" => ContactPhase::Sliding,
        _ => ContactPhase::Flying,
    };
    assert_eq!(sample.phase, phase, "at {}", sample.state.time);
    let turned = attitude(&row["attitude"]).angle_to(sample.state.attitude);
    let energy = number(&row["energy"]);
    let weight = body.mass() * 9.81;
    let scale = |key: &str, least: f64| wanted(key).iter().fold(least, |size, x| size.max(x.abs()));
    let mut errors = vec![turned];
    let mut compare = |got: &[f64], key: &str, least: f64| {
        let size = scale(key, least);
        errors.extend(got.iter().zip(wanted(key)).map(|(got, want)| (got - want).abs() / size));
    };
    if phase != ContactPhase::Flying {
        compare(&sample.contact.to_array(), "contact_ground", 0.3);
        compare(&(sample.contact_in_body - body.center_of_mass()).to_array(), "contact_body", 0.3);
        compare(&sample.slip.to_array(), "slip", 1.0);
        compare(&sample.friction.to_array(), "friction", weight);
    }
    compare(&sample.center.to_array(), "position", 0.3);
    compare(&sample.velocity.to_array(), "velocity", 1.0);
    compare(&sample.state.omega.to_array(), "omega", 1.0);
    let works = [number(&row["work_friction"]), number(&row["work_ground"]), number(&row["normal_force"])];
    let size = energy.abs().max(1.0);
    errors.push((sample.friction_work - works[0]).abs() / size);
    errors.push((sample.ground_work - works[1]).abs() / size);
    errors.push((sample.normal_force - works[2]).abs() / works[2].max(weight));
    errors.push((sample.kinetic_energy + sample.potential_energy - energy).abs() / size);
    errors.into_iter().fold(0.0, |worst, error| if error > worst || error.is_nan() { error } else { worst })
}

fn list(value: &toml::Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}
