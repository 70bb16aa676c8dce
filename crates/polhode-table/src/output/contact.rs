//! The columns of a body on the ground.

use polhode::motion::contact::{ContactPhase, ContactSample};

/// Name, unit, what it is, and its number.
pub(crate) type OfContact = (&'static str, &'static str, &'static str, fn(&ContactSample) -> f64);

const PHASE: &str = "0 rolling, 1 sliding, 2 flying";
const POSITION: &str = "centre of mass, along space axes";
const VELOCITY: &str = "velocity of the centre of mass, along space axes";
const CONTACT: &str =
    "where the ground is touched, along space axes; of what flies the point that is nearest to the ground";
const IN_BODY: &str = "the point that touches the ground, in body axes";
const FRICTION: &str =
    "force of friction on the body, along space axes; of what rolls the force that holds it";

pub(crate) const COLUMNS: [OfContact; 22] = [
    ("contact_phase", "1", PHASE, |s| phase(s.phase)),
    ("position_space_x_m", "m", POSITION, |s| s.center.x),
    ("position_space_y_m", "m", POSITION, |s| s.center.y),
    ("position_space_z_m", "m", POSITION, |s| s.center.z),
    ("velocity_space_x_m_s", "m/s", VELOCITY, |s| s.velocity.x),
    ("velocity_space_y_m_s", "m/s", VELOCITY, |s| s.velocity.y),
    ("velocity_space_z_m_s", "m/s", VELOCITY, |s| s.velocity.z),
    ("contact_space_x_m", "m", CONTACT, |s| s.contact.x),
    ("contact_space_y_m", "m", CONTACT, |s| s.contact.y),
    ("contact_space_z_m", "m", CONTACT, |s| s.contact.z),
    ("contact_body_x_m", "m", IN_BODY, |s| s.contact_in_body.x),
    ("contact_body_y_m", "m", IN_BODY, |s| s.contact_in_body.y),
    ("contact_body_z_m", "m", IN_BODY, |s| s.contact_in_body.z),
    ("normal_force_n", "N", "normal force of the ground on the body", |s| s.normal_force),
    ("slip_speed_m_s", "m/s", "speed of the point of contact over the ground", |s| s.slip.norm()),
    ("friction_space_x_n", "N", FRICTION, |s| s.friction.x),
    ("friction_space_y_n", "N", FRICTION, |s| s.friction.y),
    ("friction_space_z_n", "N", FRICTION, |s| s.friction.z),
    ("total_kinetic_energy_j", "J", "kinetic energy, that of the centre of mass included", |s| {
        s.kinetic_energy
    }),
    (
        "potential_energy_j",
        "J",
        "potential energy of the weight, zero with the centre of mass at the origin",
        |s| s.potential_energy,
    ),
    ("friction_work_j", "J", "work of friction since the start, relative to the ground", |s| s.friction_work),
    ("ground_work_j", "J", "work since the start that the ground does by its own motion", |s| s.ground_work),
];

const fn phase(phase: ContactPhase) -> f64 {
    match phase {
        ContactPhase::Rolling => 0.0,
        ContactPhase::Sliding => 1.0,
        _ => 2.0,
    }
}
