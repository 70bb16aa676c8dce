//! Payload of a force–torque sensor: mass, centre and tensor from wrench and motion.
//!
//! # Model
//!
//! All quantities are about the sensor's origin and along its axes, which are the payload's body
//! axes. The motion is given by ω, α = ω̇, the acceleration a of the origin, and gravity g. The
//! parameters are
//!
//! - m, mass, kg
//! - h = m c, first moment of mass, kg·m; c is the centre of mass from the sensor's origin
//! - I, inertia tensor about the sensor's origin, kg·m²
//! - b, bias of the sensor, if estimated
//!
//! The wrench on the payload, N and N·m, is
//!
//! f = m (a − g) + α × h + ω × (ω × h),  τ = h × (a − g) + I α + ω × I ω.
//!
//! It is linear in ten parameters. The sensor reads this wrench or its opposite ([`WrenchSense`]),
//! plus b.
//!
//! # Method
//!
//! The method is weighted least squares, constrained to physically consistent bodies: m > 0, and
//! positive semidefinite second moments about the centre. This convex problem has one solution,
//! which an interior-point method finds.
//!
//! If noise of the measured motion is declared ([`MotionNoise`]), the most likely motion is
//! estimated together with the parameters. This avoids the bias towards zero. Outliers among the
//! wrenches are left out and listed.
//!
//! Rows must contain ω, α and a. Users with attitudes and positions only must differentiate them,
//! and declare the resulting noise.
//!
//! # Result
//!
//! [`Payload`] has the parameters with their covariance.
//! [`Estimate::unknown`](crate::Estimate::unknown) lists the directions that the motion does not
//! determine, or in which it contains only noise. Parameters that change along them have no
//! standard deviation; their values are those of the smallest body that explains the wrench.
//!
//! Plates and rods lie on the boundary of physical consistency. [`Edge`] reports this, with the
//! errors along the boundary and an upper bound across it. A payload known to be a plate or a rod
//! can be declared as such ([`PayloadLog::with_kind`]).
//!
//! A wrong model widens all errors and is visible in [`Payload::tests`]. Typical mistakes are
//! tested and named ([`PayloadFinding`]).
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
//! Sources: C. G. Atkeson, C. H. An, J. M. Hollerbach, Int. J. Robot. Res. 5 (1986) 101 (model); P.
//! M. Wensing, S. Kim, J.-J. E. Slotine, IEEE Robot. Autom. Lett. 3 (2018) 60 (physical
//! consistency); C. Rucker, P. M. Wensing, IEEE Robot. Autom. Lett. 7 (2022) 2747 (coordinates of
//! the same set).

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
