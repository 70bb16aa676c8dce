//! Rigid-body dynamics: from mass to motion.
//!
//! A body in (particles, solids, meshes, assemblies, a tensor) → mass, centre of mass, inertia tensor, principal moments
//! and axes → Euler's equations: torque → motion, motion → torque. Exact wherever an exact answer is implemented, and
//! with the evidence of its own error everywhere else.
//!
//! ```
//! use polhode::*;
//!
//! // A body of two parts: a brick, and a short rod across its top.
//! let brick = BoxShape::new([0.20, 0.10, 0.06])?.mass_properties(Substance::Density(1800.0))?;
//! let rod = Rod::new(0.30)?.mass_properties(Substance::Mass(0.4))?;
//! let across = Rotation::about(Direction::new(0.0, 1.0, 0.0), std::f64::consts::FRAC_PI_2)?;
//! let body = assemble(&[
//!     PlacedPart::new(brick, Position::ZERO, Rotation::identity())?,
//!     PlacedPart::new(rod, Position::new(0.02, 0.01, 0.05), across)?,
//! ])?;
//! let principal = body.principal();
//! let [i1, i2, i3] = principal.moments();
//! assert!(i1 < i2 && i2 < i3 && i1 + i2 > i3);
//!
//! // Thrown with a spin close to the intermediate axis, it flips.
//! let omega = principal.axis(1) * 5.0 + principal.axis(0) * 0.01;
//! let omega = AngularVelocity::from_array(omega.to_array());
//! let start = State { time: 0.0, attitude: Attitude::identity(), omega };
//! let rotor = Rotor::free(&body);
//! let flip = FreeRegime::of(&rotor, &start).flip_interval.ok_or("no flip")?;
//! let motion = Trajectory::compute(&rotor, &[], start, &[0.0, flip], Method::Auto, 1e-13)?;
//! let flipped = motion.samples()[1].state.omega.dot(principal.axis(1));
//! assert!((flipped + 5.0).abs() < 1e-3);
//! assert!(Drift::of(&motion).ok_or("no samples")?.momentum < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Conventions
//!
//! - SI units: m, kg, s, rad, N·m, J.
//! - Off-diagonal elements of an inertia tensor are *minus* the integrals, I_xy = −∫xy dm, so that L = I ω. It is about the
//!   centre of mass, along body axes, unless its type ([`InertiaAbout`]) says otherwise.
//! - [`Rotation<A, B>`] is R_AB, v_A = R_AB v_B. The [`Attitude`] is R_space_body; its quaternion is unit, Hamilton, scalar first.
//! - ω is the body's angular velocity relative to [`Space`], along [`Body`] axes unless its type says otherwise.
//! - Principal moments ascend, i1 ≤ i2 ≤ i3; their axes are right-handed.
//!
//! # The rooms
//!
//! `math` (no mass) ← `body` (no time) ← `motion` (no files) ← `observe` (never integrates). Everything public is listed here.

#![forbid(unsafe_code)]

mod body;
mod math;
mod motion;
mod observe;

// body: how much mass, where, and how it resists being turned
pub use body::assembly::{BodyPart, PlacedPart, assemble};
pub use body::density::field::{
    Cubature, DensityField, FieldError, FieldMassProperties, Solid, mass_properties_of_field,
};
pub use body::density::grid::{VoxelGrid, VoxelMassProperties};
pub use body::density::parametrised::Parametrised;
pub use body::error::BodyError;
pub use body::finding::{Finding, Severity};
pub use body::form::{Form, PlacedForm};
pub use body::inertia::{InertiaAbout, InertiaTensor};
pub use body::mass_properties::MassProperties;
pub use body::material::Material;
pub use body::mesh::closed::ClosedMesh;
pub use body::mesh::component::{ComponentRole, MeshComponent};
pub use body::mesh::diagnosis::{EdgePlace, Faults, MeshDiagnosis, PairPlace, TrianglePlace};
pub use body::mesh::hull::ConvexHull;
pub use body::mesh::shell::MeshShell;
pub use body::mesh::{Triangle, TriangleMesh};
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
pub use body::solid::MeasuredSolid;

// math: frames, vectors, rotations, formulas
pub use math::algebra::{Scalar, VectorAlgebra};
pub use math::elliptic::{EllipticError, EllipticParameter, JacobiFunctions};
pub use math::formula::{Binary, Formula, FormulaError, Instruction, Unary};
pub use math::frame::{Body, Frame, Part, Principal, Space};
pub use math::rotation::{Attitude, Rotation, RotationError};
pub use math::symmetric3::symmetric_eigen;
pub use math::vector::{
    Acceleration, AngularAcceleration, AngularMomentum, AngularVelocity, CrossProduct, Direction, Force,
    Momentum, Position, Torque, Vector, Velocity, quantity,
};

// motion: states in time, and what moves them
pub use motion::closed_form::ClosedForm;
pub use motion::ending::{Ending, MethodReason};
pub use motion::ensemble::{Ensemble, EnsembleStates, Member, MemberFailure};
pub use motion::error::MotionError;
pub use motion::event::{Crossing, Event, EventAction, Measure, Sense};
pub use motion::free::{FreeMotion, FreeMotions, PermanentAxis, Regime};
pub use motion::global_error::{ErrorEffort, GlobalError, StateError};
pub use motion::heavy_top::{HeavyTop, SteadyPrecession, TopPath};
pub use motion::inverse::{ParticleForce, Required};
pub use motion::kinematics::{
    KineticEnergySplit, MovingParticle, angular_momentum, momentum, rigid_acceleration, rigid_velocity,
};
pub use motion::orbit::{MU_EARTH, Orbit};
pub use motion::orbital_elements::{Anomaly, OrbitalElements};
pub use motion::pendulum::{Pendulum, Swing};
pub use motion::pendulum_motion::PendulumMotion;
pub use motion::prescribed::{AttitudeTable, Prescribed, RateAxes, Turning, Uncertainty};
pub use motion::propagate::splitting::SplittingOrder;
pub use motion::propagate::stepper::{LOOSEST_TOLERANCE, StepStatistics, TIGHTEST_TOLERANCE};
pub use motion::rotor::Rotor;
pub use motion::sample::Sample;
pub use motion::scenario::{Hanging, Mounted, Run, Scenario};
pub use motion::shaft::{CorrectionMass, Reactions, Shaft, Unbalance};
pub use motion::simulation::Simulation;
pub use motion::solution::Solution;
pub use motion::state::State;
pub use motion::state_variables::StateVariables;
pub use motion::swinging_body::SwingingBody;
pub use motion::torque::{
    Attracted, ConstantTorque, Drag, DragLaw, EnergySink, FormulaTorque, GravityGradient, Law, LawInput,
    Magnetic, MagneticField, OrbitPosition, OwnTorque, Schedule, Scheduled, Thruster, TorqueModel, Torsion,
    UniformGravity,
};
pub use motion::trajectory::{Method, Trajectory};
pub use motion::wheel::{Motor, Wheel};

// observe: what can be read off a motion
pub use observe::cone::Cones;
pub use observe::curve::{Curve, CurveError};
pub use observe::drift::Drift;
pub use observe::geometric_phase::GeometricPhase;
pub use observe::herpolhode::Herpolhode;
pub use observe::least_energy::LeastEnergySpin;
pub use observe::libration::Libration;
pub use observe::momentum_trace::MomentumTrace;
pub use observe::polhode::Polhode;
pub use observe::regime::FreeRegime;
pub use observe::rolling_cones::RollingCones;
pub use observe::rotational_constants::{RotationalConstants, Top};
pub use observe::small_oscillations::{OrbitalEquilibrium, OscillationMode, SmallOscillations, SteadyTop};
pub use observe::stability::{PermanentRotation, Settling, Stability};
pub use observe::symmetric_top::{SymmetricTop, SymmetricTopKind};
pub use observe::tumbler::{TumblerError, TumblingSolution};
pub use observe::tumbling::{AxisConvention, TumblingPeriods};

/// The README's program, as a test.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
