//! A rigid body that rolls, slides and spins on a surface, with one point of contact.
//!
//! The [`BodySurface`] of a body (a sphere, an ellipsoid, the rim of a disk or a hoop, a cylinder that
//! lies) touches the [`Ground`] (a plane, level or not, or turning; the inside or the outside of a sphere
//! or a cylinder). A [`ContactLaw`] states what holds the point of contact: it rolls without slipping, or
//! there is friction, or none. [`Simulation::on_ground`](crate::motion::Simulation::on_ground) computes the
//! motion by collocation where it is smooth and by Taylor series where it is not, and finds the changes
//! between rolling, sliding and flying ([`ContactChange`]). Impacts are not computed: a motion ends where
//! a body comes back to the ground.

mod arrangement;
mod change;
mod dual;
mod equations;
mod flight;
mod geometry;
mod ground;
mod law;
mod model;
mod onset;
mod phase;
pub(crate) mod problem;
mod reading;
pub(crate) mod reduced;
mod setup;
mod smooth;
mod start;
mod state;
mod stepper;
mod surface;
pub(crate) mod system;
mod transition;
mod watch;

pub use arrangement::Contact;
pub use change::{ContactChange, ContactEvent, ContactPhase};
pub use ground::{Ground, GroundShape, GroundSide};
pub use law::{ContactLaw, Friction, Grip, Resistance};
pub use reduced::Footing;
pub use start::{ContactStart, StartVelocity};
pub use state::ContactState;
pub use surface::{BodySurface, SurfaceShape};
