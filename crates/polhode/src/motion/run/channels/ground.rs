//! Channels of a body on the ground.

use super::super::channel::Channel;
use crate::math::frame::Space;
use crate::math::vector::{Force, Position, Velocity};
use crate::motion::contact::{ContactPhase, ContactState};

const POSITION_OF: &str = "centre of mass, along space axes";
const VELOCITY_OF: &str = "velocity of the centre of mass, along space axes";
const POINT_OF: &str =
    "where the ground is touched, along space axes; of what flies the point that is nearest to the ground";
const IN_BODY: &str = "the point that touches the ground, in body axes";
const FRICTION_OF: &str =
    "force of friction on the body, along space axes; of what rolls the force that holds it";

/// Complete state of the body and its contact.
pub const CONTACT: Channel<ContactState> =
    Channel::new("contact", "", "the body and its contact", |row| row.contact().copied());
/// Centre of mass, space axes, m.
pub const POSITION: Channel<Position<Space>> =
    Channel::new("position_space", "m", POSITION_OF, |row| Some(row.contact()?.center));
/// Point of contact, space axes, m; in flight the point of the body nearest to the ground.
pub const CONTACT_POINT: Channel<Position<Space>> =
    Channel::new("contact_space", "m", POINT_OF, |row| Some(row.contact()?.contact));
/// Normal force of the ground on the body, N, never negative.
pub const NORMAL_FORCE: Channel<f64> =
    Channel::new("normal_force_n", "N", "normal force of the ground on the body", |row| {
        Some(row.contact()?.normal_force)
    });
/// Slip velocity: velocity of the body's point of contact relative to the ground, space axes, m/s.
pub const SLIP: Channel<Velocity<Space>> =
    Channel::new("slip_space", "m/s", "velocity of the point of contact over the ground", |row| {
        Some(row.contact()?.slip)
    });
/// Friction force on the body, space axes, N; during rolling the constraint force.
pub const FRICTION: Channel<Force<Space>> =
    Channel::new("friction_space", "N", FRICTION_OF, |row| Some(row.contact()?.friction));
/// Work of friction since the start, relative to the ground, J; never positive.
pub const FRICTION_WORK: Channel<f64> =
    Channel::new("friction_work_j", "J", "work of friction since the start, relative to the ground", |row| {
        Some(row.contact()?.friction_work)
    });
/// Work of the ground since the start, by its own motion, J.
pub const GROUND_WORK: Channel<f64> = Channel::new(
    "ground_work_j",
    "J",
    "work since the start that the ground does by its own motion",
    |row| Some(row.contact()?.ground_work),
);

/// Scalar channels, in the order of the columns of tables.
pub(in crate::motion) const SCALARS: [Channel<f64>; 22] = [
    Channel::new("contact_phase", "1", "0 rolling, 1 sliding, 2 flying", |row| {
        Some(number(row.contact()?.phase))
    }),
    Channel::new("position_space_x_m", "m", POSITION_OF, |row| Some(row.contact()?.center.x)),
    Channel::new("position_space_y_m", "m", POSITION_OF, |row| Some(row.contact()?.center.y)),
    Channel::new("position_space_z_m", "m", POSITION_OF, |row| Some(row.contact()?.center.z)),
    Channel::new("velocity_space_x_m_s", "m/s", VELOCITY_OF, |row| Some(row.contact()?.velocity.x)),
    Channel::new("velocity_space_y_m_s", "m/s", VELOCITY_OF, |row| Some(row.contact()?.velocity.y)),
    Channel::new("velocity_space_z_m_s", "m/s", VELOCITY_OF, |row| Some(row.contact()?.velocity.z)),
    Channel::new("contact_space_x_m", "m", POINT_OF, |row| Some(row.contact()?.contact.x)),
    Channel::new("contact_space_y_m", "m", POINT_OF, |row| Some(row.contact()?.contact.y)),
    Channel::new("contact_space_z_m", "m", POINT_OF, |row| Some(row.contact()?.contact.z)),
    Channel::new("contact_body_x_m", "m", IN_BODY, |row| Some(row.contact()?.contact_in_body.x)),
    Channel::new("contact_body_y_m", "m", IN_BODY, |row| Some(row.contact()?.contact_in_body.y)),
    Channel::new("contact_body_z_m", "m", IN_BODY, |row| Some(row.contact()?.contact_in_body.z)),
    NORMAL_FORCE,
    Channel::new("slip_speed_m_s", "m/s", "speed of the point of contact over the ground", |row| {
        Some(row.contact()?.slip.norm())
    }),
    Channel::new("friction_space_x_n", "N", FRICTION_OF, |row| Some(row.contact()?.friction.x)),
    Channel::new("friction_space_y_n", "N", FRICTION_OF, |row| Some(row.contact()?.friction.y)),
    Channel::new("friction_space_z_n", "N", FRICTION_OF, |row| Some(row.contact()?.friction.z)),
    Channel::new(
        "total_kinetic_energy_j",
        "J",
        "kinetic energy, that of the centre of mass included",
        |row| Some(row.contact()?.kinetic_energy),
    ),
    Channel::new(
        "potential_energy_j",
        "J",
        "potential energy of the weight, zero with the centre of mass at the origin",
        |row| Some(row.contact()?.potential_energy),
    ),
    FRICTION_WORK,
    GROUND_WORK,
];

/// Returns the number of a phase in tables.
const fn number(phase: ContactPhase) -> f64 {
    match phase {
        ContactPhase::Rolling => 0.0,
        ContactPhase::Sliding => 1.0,
        ContactPhase::Flying => 2.0,
    }
}
