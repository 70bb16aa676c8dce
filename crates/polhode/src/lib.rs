//! Rigid-body dynamics: from mass to motion.
#![forbid(unsafe_code)]

mod body;
mod math;
mod motion;
mod observe;

pub use body::assembly::{BodyPart, PlacedPart, assemble};
pub use body::error::BodyError;
pub use body::finding::{Finding, Severity};
pub use body::inertia::{InertiaAbout, InertiaTensor};
pub use body::mass_properties::MassProperties;
pub use body::material::Material;
pub use body::mesh::{ClosedMesh, Triangle};
pub use body::particles::{Particle, mass_properties_of_particles};
pub use body::principal::{PrincipalFrame, Symmetry};
pub use body::shape::r#box::BoxShape;
pub use body::shape::box_shell::BoxShell;
pub use body::shape::capsule::Capsule;
pub use body::shape::cone::Cone;
pub use body::shape::cylinder::Cylinder;
pub use body::shape::cylinder_shell::CylinderShell;
pub use body::shape::disk::Disk;
pub use body::shape::ellipsoid::Ellipsoid;
pub use body::shape::plate::Plate;
pub use body::shape::rod::Rod;
pub use body::shape::sphere::Sphere;
pub use body::shape::sphere_shell::SphereShell;
pub use body::shape::tetrahedron::Tetrahedron;
pub use body::shape::torus::Torus;
pub use body::shape::{Extent, Shape, Spread, Substance};
pub use math::frame::{Body, Frame, Part, Principal, Space};
pub use math::rotation::{Attitude, Rotation, RotationError};
pub use math::vector::{
    Acceleration, AngularAcceleration, AngularMomentum, AngularVelocity, CrossProduct, Direction, Force, Momentum,
    Position, Torque, Vector, Velocity, quantity,
};
pub use motion::error::MotionError;
pub use motion::free::{FreeMotion, PermanentRotation, SymmetricTop, SymmetricTopKind};
pub use motion::inverse::{ParticleForce, Required};
pub use motion::kinematics::{
    KineticEnergySplit, MovingParticle, angular_momentum, momentum, rigid_acceleration, rigid_velocity,
};
pub use motion::pendulum::{Pendulum, Swing};
pub use motion::prescribed::Prescribed;
pub use motion::propagate::stepper::{LOOSEST_TOLERANCE, StepStatistics, TIGHTEST_TOLERANCE};
pub use motion::rotor::Rotor;
pub use motion::scenario::{Hanging, Run, Scenario};
pub use motion::state::State;
pub use motion::torque::{ConstantTorque, TorqueModel, UniformGravity};
pub use motion::trajectory::{Method, Sample, Solution, Trajectory};
pub use observe::cone::Cones;
pub use observe::drift::Drift;
pub use observe::regime::{FreeRegime, Regime};
