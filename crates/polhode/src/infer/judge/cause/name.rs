//! Mistakes that a program may make.

use core::fmt;

use super::scheme::Scheme;
use crate::math::frame::Body;
use crate::math::vector::AngularVelocity;

/// Mistake of a program, or another reason why its motion is not the exact one.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Cause {
    /// The gyroscopic term is missing: I ω̇ = N.
    NoGyroscopicTerm,
    /// The attitude equation is q̇ = ½ ω q, although ω is along body axes.
    OmegaBodyAsSpace,
    /// The attitude equation is q̇ = ½ q ω, although ω is along space axes.
    OmegaSpaceAsBody,
    /// The attitude is the inverse one, R_body_space.
    ConjugateAttitude,
    /// The quaternion is (x, y, z, w), with the scalar last.
    ScalarLast,
    /// The tensor is Rᵀ D R instead of R D Rᵀ, with the principal moments D and R_body_principal.
    TensorTransposed,
    /// The principal moments are used along the body's axes, in this order (0 is the smallest).
    PrincipalMomentsAlongBodyAxes([usize; 3]),
    /// The products of inertia have the opposite sign.
    ProductsReversed,
    /// The products of inertia are omitted.
    ProductsLeftOut,
    /// The products of inertia are permuted: these indices (0 is I_xy, 1 I_xz, 2 I_yz) are used as
    /// xy, xz, yz.
    ProductsReordered([usize; 3]),
    /// The tensor of a free body is about the origin of its axes instead of its centre of mass.
    TensorAboutOrigin,
    /// The tensor of a body on a pivot is about its centre of mass.
    TensorAboutCenterOfMass,
    /// The angular momentum of the wheels is omitted.
    WheelsLeftOut,
    /// Components of a torque along body axes are used along space axes; those of all torques if
    /// `torque` is `None`.
    TorqueBodyAsSpace {
        /// Name of the torque; `None` for all torques.
        torque: Option<&'static str>,
    },
    /// Components of a torque along space axes are used along body axes.
    TorqueSpaceAsBody {
        /// Name of the torque; `None` for all torques.
        torque: Option<&'static str>,
    },
    /// The torque has the opposite sign, −N.
    TorqueReversed {
        /// Name of the torque; `None` for all torques.
        torque: Option<&'static str>,
    },
    /// The torque is omitted, N = 0.
    TorqueLeftOut {
        /// Name of the torque; `None` for all torques.
        torque: Option<&'static str>,
    },
    /// All torques are multiplied by a factor.
    TorqueScaled {
        /// Factor, fitted.
        factor: f64,
    },
    /// ω̇ has an additional damping term −c ω.
    Damping {
        /// Damping c, 1/s, fitted.
        rate: f64,
    },
    /// ω̇ has an additional damping term −c ω, and the gyroscopic term is missing.
    DampingWithoutGyroscopicTerm {
        /// Damping c, 1/s, fitted.
        rate: f64,
    },
    /// The angular speed |ω| is limited.
    SpeedLimit {
        /// Limit of |ω|, rad/s.
        limit: f64,
        /// True if the gyroscopic term is present, false if it is missing too.
        gyroscopic: bool,
    },
    /// The method has fixed steps by this rule.
    Method {
        /// Rule of the steps.
        scheme: Scheme,
        /// Step size, s: declared, or estimated.
        step: f64,
    },
    /// The method has fixed steps by this rule, and ω is damped in addition.
    MethodWithDamping {
        /// Rule of the steps.
        scheme: Scheme,
        /// Step size, s: declared, or the row spacing.
        step: f64,
        /// Damping c, 1/s, fitted.
        rate: f64,
    },
    /// The rows are rounded to this number of decimals, or to the 24 bits of single precision
    /// (`None`), and have no other error.
    RoundedRows(Option<u32>),
    /// The rows have 24 bits, and an error that grows like that of steps in single precision.
    SinglePrecisionArithmetic,
    /// The rows belong to shifted times.
    TimeShift {
        /// Shift of the true times relative to the stated ones, s, positive if later, fitted.
        shift: f64,
    },
    /// The motion has a different start.
    OtherStart {
        /// Angle between the first row's attitude and the scenario's, rad.
        angle: f64,
        /// ω of the first row, rad/s, if the log has ω.
        omega: Option<AngularVelocity<Body>>,
    },
    /// The components of the start's ω along body axes are used along space axes.
    StartOmegaAlongSpace,
    /// The motion is that of a body with this tensor.
    OtherTensor {
        /// Tensor about the point on which the equations of motion are based (the centre of mass,
        /// or the pivot), kg·m², fitted.
        tensor: [[f64; 3]; 3],
        /// False if the motion determines only the ratios of the elements; the trace is then that
        /// of the scenario.
        has_scale: bool,
    },
}

impl Cause {
    /// Returns false for causes that are not mistakes: the error of a method of order 2 or more,
    /// and single precision.
    pub const fn is_mistake(&self) -> bool {
        match self {
            Self::Method { scheme, .. } => scheme.order() < 2,
            Self::RoundedRows(_) | Self::SinglePrecisionArithmetic => false,
            _ => true,
        }
    }

    /// Returns the number of values that were taken from the run or fitted to it; a few values
    /// chosen from many count as 1.
    pub(super) const fn fitted(&self) -> u32 {
        match self {
            Self::TorqueScaled { .. }
            | Self::Damping { .. }
            | Self::DampingWithoutGyroscopicTerm { .. }
            | Self::MethodWithDamping { .. }
            | Self::SpeedLimit { .. }
            | Self::OtherStart { .. }
            | Self::TimeShift { .. } => 1,
            Self::OtherTensor { .. } => 6,
            _ => 0,
        }
    }

    /// Returns advice for the author of the program.
    pub const fn hint(&self) -> &'static str {
        match self {
            Self::NoGyroscopicTerm | Self::DampingWithoutGyroscopicTerm { .. } => {
                "Write I ω̇ = N − ω × I ω along body axes, or keep L = R I Rᵀ ω along space axes and compute ω from it after each step. \
                 In an engine, switch its gyroscopic forces on. Unless the body is a ball or turns about a principal axis, a constant ω \
                 is no free motion."
            }
            Self::OmegaBodyAsSpace => {
                "With ω along body axes and R_space_body write q̇ = ½ q ω; ½ ω q is for ω along space axes."
            }
            Self::OmegaSpaceAsBody => {
                "With ω along space axes and R_space_body write q̇ = ½ ω q; ½ q ω is for ω along body axes."
            }
            Self::ConjugateAttitude => {
                "The quaternion takes components in space to those in the body; negate x, y and z for R_space_body."
            }
            Self::ScalarLast => {
                "The numbers are x, y, z, w; move the scalar to the front, or say so of the log."
            }
            Self::TensorTransposed => {
                "With the principal axes as the columns of R the tensor along body axes is R D Rᵀ; libraries differ in whether \
                 eigenvectors are rows or columns."
            }
            Self::PrincipalMomentsAlongBodyAxes(_) => {
                "Principal moments are about the principal axes: align the body axes with them, or use the full tensor."
            }
            Self::ProductsReversed => {
                "The elements off the diagonal of the tensor are I_xy = −∫ x y dm; CAD reports often have +∫ x y dm."
            }
            Self::ProductsLeftOut => {
                "Use the full tensor; a diagonal one is right only along the principal axes."
            }
            Self::ProductsReordered(_) => {
                "Check the order of the products in the file format: both xy, xz, yz and yz, xz, xy are common."
            }
            Self::TensorAboutOrigin => {
                "A free body rotates about its centre of mass: I_c = I_o − m (c² 1 − c cᵀ), with c from the origin to the centre of mass."
            }
            Self::TensorAboutCenterOfMass => {
                "About a pivot the tensor is I_p = I_c + m (l² 1 − l lᵀ), with l from the pivot to the centre of mass."
            }
            Self::WheelsLeftOut => "With wheels L = I ω + Σ h a, and the gyroscopic term is ω × (I ω + h).",
            Self::TorqueBodyAsSpace { .. } => {
                "A torque N along body axes is R N along space axes: rotate it in each step before adding it."
            }
            Self::TorqueSpaceAsBody { .. } => {
                "A torque N along space axes is Rᵀ N along body axes: rotate it in each step before adding it."
            }
            Self::TorqueReversed { .. } => {
                "Change the sign: N = r × F, with r from the centre of rotation to the point where the force acts."
            }
            Self::TorqueLeftOut { .. } => {
                "Apply the torque in every step: engines clear applied torques after each step."
            }
            Self::TorqueScaled { .. } => {
                "Check the unit of the torque, the mass, g, the lever arm, and that it is applied once in each step."
            }
            Self::Damping { .. } | Self::MethodWithDamping { .. } => {
                "Set the angular damping of the body to zero: the default of some engines is 0.04 or 0.05 1/s."
            }
            Self::SpeedLimit { .. } => {
                "Raise the maximum angular speed of the body: the default of some engines is 7, 47 or 100 rad/s."
            }
            Self::Method { scheme, .. } => method_hint(*scheme),
            Self::RoundedRows(_) => {
                "Log all 17 digits of doubles, if the program computes in double precision."
            }
            Self::SinglePrecisionArithmetic => {
                "Compute in double precision if that matters: single precision loses about 6e-8 in each step."
            }
            Self::TimeShift { .. } => {
                "Check whether rows are written before a step but stamped with the time after it, or the reverse."
            }
            Self::StartOmegaAlongSpace => {
                "The scenario's ω is along body axes; an engine that expects space axes needs R ω."
            }
            Self::OtherStart { .. } => {
                "Start from the scenario's attitude and ω; check whether the engine expects ω along body or space axes."
            }
            Self::OtherTensor { .. } => {
                "Check the tensor of the program: its reference point, axes, parts and densities."
            }
        }
    }
}

const fn method_hint(scheme: Scheme) -> &'static str {
    match scheme {
        Scheme::ImplicitGyroscopic(_) | Scheme::LaggedMomentum(_) => {
            "An implicit gyroscopic term is stable and loses energy in proportion to the step: the body finally rotates about its axis of \
             greatest moment. Take shorter steps, or keep L along space axes and use a method of order 2 or more."
        }
        Scheme::HeldAtStart(_) | Scheme::HeldAtEnd(_) => {
            "Rotate the attitude with ω at the middle of the step, (ω + ω′)/2, as q′ = q exp(½ h ω): the error is then of order h²."
        }
        _ if scheme.order() < 2 => {
            "The error is of order h. Use a method of order 2 (midpoint, splitting into rotations about the principal axes) or 4 (RK4 for q \
             and ω), or take many steps for each row."
        }
        Scheme::RungeKutta4MeanRate => {
            "Rotating by the mean ω has an error of order h² even if ω has one of order h⁴: integrate the quaternion itself by RK4, or \
             add the commutators of Munthe-Kaas. Otherwise take shorter steps."
        }
        _ => {
            "This is the discretization error of the method, not a mistake: take shorter steps to reduce it."
        }
    }
}

/// One sentence that describes the cause.
impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of = |torque: &Option<&'static str>| torque.map_or_else(String::new, |name| format!(" ({name})"));
        match self {
            Self::NoGyroscopicTerm => f.write_str("the gyroscopic term ω × I ω is missing"),
            Self::OmegaBodyAsSpace => {
                f.write_str("the body components of ω rotate the attitude as if they were along space axes")
            }
            Self::OmegaSpaceAsBody => {
                f.write_str("the space components of ω rotate the attitude as if they were along body axes")
            }
            Self::ConjugateAttitude => f.write_str("the attitude is the inverse, R_body_space"),
            Self::ScalarLast => f.write_str("the quaternion has its scalar last"),
            Self::TensorTransposed => f.write_str(
                "the tensor is transformed from principal to body axes the wrong way, Rᵀ D R instead of R D Rᵀ",
            ),
            Self::PrincipalMomentsAlongBodyAxes(order) => {
                write!(f, "the principal moments {} are used as moments about the body's x, y, z axes", numbered(order, 1))
            }
            Self::ProductsReversed => f.write_str("the products of inertia have the wrong sign"),
            Self::ProductsLeftOut => f.write_str("the products of inertia are missing"),
            Self::ProductsReordered(order) => {
                let name = |k: usize| ["I_xy", "I_xz", "I_yz"].get(k).copied().unwrap_or("?");
                let [a, b, c] = order.map(name);
                write!(
                    f,
                    "the products of inertia are in the wrong order: {a}, {b}, {c} instead of I_xy, I_xz, I_yz"
                )
            }
            Self::TensorAboutOrigin => {
                f.write_str("the tensor is about the origin of the body's axes, not about its centre of mass")
            }
            Self::TensorAboutCenterOfMass => {
                f.write_str("the tensor is about the centre of mass, not about the pivot")
            }
            Self::WheelsLeftOut => f.write_str("the angular momentum of the wheels is missing"),
            Self::TorqueBodyAsSpace { torque } => {
                write!(f, "the body components of the torque{} are applied along space axes", of(torque))
            }
            Self::TorqueSpaceAsBody { torque } => {
                write!(f, "the space components of the torque{} are applied along body axes", of(torque))
            }
            Self::TorqueReversed { torque } => write!(f, "the torque{} has the wrong sign", of(torque)),
            Self::TorqueLeftOut { torque } => write!(f, "the torque{} is missing", of(torque)),
            Self::TorqueScaled { factor } => {
                write!(
                    f,
                    "the torque is wrong by a factor of {factor:.6}, or the mass or the tensor is wrong"
                )
            }
            Self::Damping { rate } => write!(f, "ω is damped: ω̇ has the additional term −c ω, c = {rate:.4} 1/s"),
            Self::DampingWithoutGyroscopicTerm { rate } => {
                write!(f, "the gyroscopic term ω × I ω is missing, and ω is damped: ω̇ = I⁻¹ N − c ω, c = {rate:.4} 1/s")
            }
            Self::SpeedLimit { limit, gyroscopic } => {
                let besides = if *gyroscopic { "" } else { ", and the gyroscopic term ω × I ω is missing" };
                write!(f, "|ω| is limited to {limit:.6} rad/s{besides}")
            }
            Self::Method { scheme, step } if scheme.order() < 2 => {
                write!(f, "first-order integration ({scheme}), h = {step:.6} s")
            }
            Self::MethodWithDamping { scheme, step, rate } => {
                write!(
                    f,
                    "ω is damped, c = {rate:.4} 1/s, with first-order integration ({scheme}), h = {step:.6} s"
                )
            }
            Self::Method { scheme, step } => {
                write!(f, "discretization error of {scheme}, h = {step:.6} s")
            }
            Self::RoundedRows(None) => f.write_str("the motion is correct to the single precision of its rows"),
            Self::RoundedRows(Some(digits)) => {
                write!(f, "the motion is correct to the precision of its rows (decimal places: {digits})")
            }
            Self::SinglePrecisionArithmetic => f.write_str("the motion is computed in single precision"),
            Self::TimeShift { shift } => {
                write!(f, "each row has the motion of {shift:.6} s after its stated time")
            }
            Self::StartOmegaAlongSpace => {
                f.write_str("the body components of the initial ω are used along space axes")
            }
            Self::OtherStart { angle, omega } => {
                write!(f, "the start is different: {angle:.6} rad from the scenario's attitude")?;
                omega.map_or(Ok(()), |omega| write!(f, ", with ω = {omega}"))
            }
            Self::OtherTensor { tensor: [a, b, c], has_scale } => {
                let scale = if *has_scale { "kg·m²" } else { "kg·m² times any factor" };
                write!(f, "the motion is that of another body, with the tensor [")?;
                for (k, row) in [a, b, c].into_iter().enumerate() {
                    let [x, y, z] = row;
                    let lead = if k == 0 { "" } else { ", " };
                    write!(f, "{lead}[{x:.6}, {y:.6}, {z:.6}]")?;
                }
                write!(f, "] {scale}")
            }
        }
    }
}

fn numbered(order: &[usize; 3], from: usize) -> String {
    let [a, b, c] = order.map(|k| k + from);
    format!("I{a}, I{b}, I{c}")
}
