//! What a force–torque sensor carries.

mod answer;
mod edge;
mod finding;
mod identify;
mod log;
mod mistake;
mod motion;
mod noise;
mod outliers;
mod possible;
mod regression;
mod small;

pub use answer::{Payload, Unconstrained};
pub use edge::{Edge, EdgeKind, Thin};
pub use finding::{Mistake, PayloadFinding};
pub use identify::identify_payload;
pub use log::{MotionNoise, PayloadLog, PayloadRow, WrenchNoise, WrenchSense, gravity_along};
pub use outliers::LeftOut;
