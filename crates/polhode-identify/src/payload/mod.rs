//! What a force–torque sensor carries: mass, centre and tensor from wrench and motion.
//!
//! # Model
//!
//! About the sensor's origin and along its axes, which are the payload's body axes, with ω, α = ω̇, the acceleration a of the origin, gravity g, and
//!
//! - m, mass, kg
//! - h = m c, the moment of mass, kg·m; c is the centre of mass from the sensor's origin
//! - I, the tensor about the sensor's origin, kg·m²
//! - b, the sensor's bias, if it is to be found
//!
//! the wrench on the payload is f = m (a − g) + α × h + ω × (ω × h), N, and τ = h × (a − g) + I α + ω × I ω, N·m: linear in ten numbers. The sensor reads
//! it, or what is opposite ([`WrenchSense`]), and b.
//!
//! # Method
//!
//! Least squares in standard deviations of the noise, with these numbers confined to those of possible bodies: m > 0, and second moments about the centre that
//! are positive semidefinite. That is a convex problem with one answer, which an interior-point method finds. Noise of the measured motion, if it is
//! declared ([`MotionNoise`]), is taken from the likeliest motion, found together with the numbers, so it does not draw them to zero. Wrenches that are far off
//! are left out, and listed.
//!
//! Motion has to come with its derivatives: rows without ω, α or a do not exist. Who has attitudes and positions alone has to differentiate them, and
//! declares the noise that this leaves.
//!
//! # What comes out
//!
//! [`Payload`] has the numbers with their covariance. What the motion does not determine is in [`Estimate::unknown`](crate::Estimate::unknown), and numbers that
//! change along it have no standard deviation; their values are those of the least body that explains the wrench. The same goes for directions in which all that
//! moves is the noise of the motion. Plates and rods are at the edge of what is
//! possible: [`Edge`] says so, with the errors of what moves along the edge and a bound for what is across; who knows that it is a plate or a rod says so
//! ([`PayloadLog::with_kind`]). A wrong model widens all errors,
//! and shows in [`Payload::tests`]; the commonest mistakes are tried and named ([`PayloadFinding`]).
//!
//! ```
//! use polhode::math::{Acceleration, AngularAcceleration, AngularVelocity, Force, Torque};
//! use polhode_identify::payload::{PayloadLog, PayloadRow, WrenchNoise, WrenchSense, identify_payload};
//!
//! // A ball, 2 kg and 0.012 kg·m², 0.1 m along z: turned to and fro about changing axes by a hand that is at rest.
//! let rows = (0..200).map(|k| {
//!     let t = 0.01 * f64::from(k);
//!     let (u, v) = (5.0 * t, 7.0 * t);
//!     let omega = AngularVelocity::new(2.0 * u.sin(), 1.5 * v.cos(), (u + v).sin());
//!     let alpha = AngularAcceleration::new(10.0 * u.cos(), -10.5 * v.sin(), 12.0 * (u + v).cos());
//!     let gravity = Acceleration::new(-9.81 * u.sin(), 9.81 * u.cos() * v.sin(), -9.81 * u.cos() * v.cos());
//!     let c = polhode::math::Position::new(0.0, 0.0, 0.1);
//!     let acceleration = alpha.cross(c) + omega.cross(omega.cross(c)) - gravity;
//!     let force = Force::from_array((acceleration * 2.0).to_array());
//!     let torque = Torque::from_array((alpha * 0.012).to_array()) + c.cross(force);
//!     PayloadRow { time: t, omega, alpha, acceleration: Acceleration::ZERO, gravity, force, torque }
//! });
//! let log = PayloadLog::new(rows.collect(), WrenchSense::OnPayload)?
//!     .with_noise(WrenchNoise::Deviations { force: 0.05, torque: 0.002 })?
//!     .with_bias();
//! let payload = identify_payload(&log)?;
//! let body = payload.body.ok_or("something is unknown")?;
//! assert!((body.mass() - 2.0).abs() < 1e-9);
//! assert!((body.center_of_mass().z - 0.1).abs() < 1e-9);
//! assert!((body.inertia().matrix()[1][1] - 0.012).abs() < 1e-9);
//! // how well the mass would be known with that noise
//! assert!(payload.about_center.get("mass").and_then(|mass| mass.sd).is_some_and(|sd| sd < 0.01));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Sources: C. G. Atkeson, C. H. An, J. M. Hollerbach, Int. J. Robot. Res. 5 (1986) 101, for the model; P. M. Wensing, S. Kim, J.-J. E. Slotine, IEEE Robot.
//! Autom. Lett. 3 (2018) 60, for what is possible; C. Rucker, P. M. Wensing, IEEE Robot. Autom. Lett. 7 (2022) 2747, for coordinates of the same set.

mod about;
mod answer;
mod edge;
mod finding;
mod identify;
mod log;
mod mistake;
mod motion;
mod next;
mod noise;
mod outliers;
mod possible;
mod regression;
mod shape;
mod small;

pub use answer::{Payload, Unconstrained};
pub use edge::{Edge, EdgeKind, Thin};
pub use finding::{Mistake, PayloadFinding};
pub use identify::identify_payload;
pub use log::{MotionNoise, PayloadLog, PayloadRow, WrenchNoise, WrenchSense, gravity_along};
pub use next::{NextMotion, next_motion};
pub use outliers::LeftOut;
