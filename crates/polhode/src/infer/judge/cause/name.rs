//! What a program may do wrong.

use core::fmt;

use super::scheme::Scheme;
use crate::math::frame::Body;
use crate::math::vector::AngularVelocity;

/// What a program may do wrong, or why its motion is not the exact one.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Cause {
    /// I ω̇ = N.
    NoGyroscopicTerm,
    /// q̇ = ½ ω q with ω along body axes.
    OmegaBodyAsSpace,
    /// q̇ = ½ q ω with ω along space axes.
    OmegaSpaceAsBody,
    /// The attitude is R_body_space.
    ConjugateAttitude,
    /// The quaternion is (x, y, z, w).
    ScalarLast,
    /// Rᵀ D R for R D Rᵀ, with the principal moments D and R_body_principal.
    TensorTransposed,
    /// The principal moments, along the body's axes in this order (0 is the least).
    PrincipalMomentsAlongBodyAxes([usize; 3]),
    /// The products of inertia have the other sign.
    ProductsReversed,
    /// The products of inertia are zero.
    ProductsLeftOut,
    /// The products of inertia stand in another order: in the places xy, xz, yz those numbers (0 is I_xy, 1 I_xz, 2 I_yz).
    ProductsReordered([usize; 3]),
    /// Of a free body the tensor about the origin of its axes instead of its centre of mass.
    TensorAboutOrigin,
    /// Of a body held at a pivot the tensor about its centre of mass.
    TensorAboutCenterOfMass,
    /// Wheels spin, and their momentum is not counted.
    WheelsLeftOut,
    /// A torque along body axes has its components along space axes; of all torques if `torque` is `None`.
    TorqueBodyAsSpace {
        /// What the torque is called.
        torque: Option<&'static str>,
    },
    /// A torque along space axes has its components along body axes.
    TorqueSpaceAsBody {
        /// What the torque is called.
        torque: Option<&'static str>,
    },
    /// −N for N.
    TorqueReversed {
        /// What the torque is called.
        torque: Option<&'static str>,
    },
    /// N = 0.
    TorqueLeftOut {
        /// What the torque is called.
        torque: Option<&'static str>,
    },
    /// All torques are this many times as large.
    TorqueScaled {
        /// How many times, fitted.
        factor: f64,
    },
    /// ω̇ has −c ω besides.
    Damping {
        /// c, 1/s, fitted.
        rate: f64,
    },
    /// The same without the gyroscopic term.
    DampingWithoutGyroscopicTerm {
        /// c, 1/s, fitted.
        rate: f64,
    },
    /// |ω| is cut off.
    SpeedLimit {
        /// The greatest |ω|, rad/s.
        limit: f64,
        /// Without the gyroscopic term besides.
        gyroscopic: bool,
    },
    /// Steps of one length by this rule.
    Method {
        /// The rule.
        scheme: Scheme,
        /// The step, s: declared, or found.
        step: f64,
    },
    /// The same with ω damped besides.
    MethodWithDamping {
        /// The rule.
        scheme: Scheme,
        /// The step, s: declared, or the rows' spacing.
        step: f64,
        /// c, 1/s, fitted.
        rate: f64,
    },
    /// The rows are rounded to so many digits behind the point, or to the 24 bits of single precision, and have no other error.
    RoundedRows(Option<u32>),
    /// The rows have 24 bits, and an error that grows as that of steps in single precision does.
    SinglePrecisionArithmetic,
    /// The rows are those of other times.
    TimeShift {
        /// By how much these times are later than the rows say, s, fitted.
        shift: f64,
    },
    /// The motion starts elsewhere.
    OtherStart {
        /// The angle between the first row's attitude and the scenario's, rad.
        angle: f64,
        /// The first row's ω, rad/s, if it has one.
        omega: Option<AngularVelocity<Body>>,
    },
    /// The start's ω has its components along body axes taken along those of space.
    StartOmegaAlongSpace,
    /// It is the motion of a body with this tensor.
    OtherTensor {
        /// About the point that the body turns about, kg·m²; fitted.
        tensor: [[f64; 3]; 3],
        /// False where the motion says the ratios of its elements alone; then its trace is the scenario's.
        has_scale: bool,
    },
}

impl Cause {
    /// False for what is no mistake: the error of a method of order 2 or more, and single precision.
    pub const fn is_mistake(&self) -> bool {
        match self {
            Self::Method { scheme, .. } => scheme.order() < 2,
            Self::RoundedRows(_) | Self::SinglePrecisionArithmetic => false,
            _ => true,
        }
    }

    /// How many numbers were taken from the run, or fitted to it; few of many are 1.
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

    /// What to write instead: for the author of the program.
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
                "Principal moments belong along the principal axes: turn the body's axes to those, or use the full tensor."
            }
            Self::ProductsReversed => {
                "The elements off the diagonal of the tensor are I_xy = −∫ x y dm; CAD reports often have +∫ x y dm."
            }
            Self::ProductsLeftOut => {
                "Use the full tensor; a diagonal one is right only along the principal axes."
            }
            Self::ProductsReordered(_) => {
                "See in which order the file's format has the products: xy, xz, yz is as usual as yz, xz, xy."
            }
            Self::TensorAboutOrigin => {
                "A free body turns about its centre of mass: I_c = I_o − m (c² 1 − c cᵀ), with c from the origin to the centre of mass."
            }
            Self::TensorAboutCenterOfMass => {
                "About a pivot the tensor is I_p = I_c + m (l² 1 − l lᵀ), with l from the pivot to the centre of mass."
            }
            Self::WheelsLeftOut => "With wheels L = I ω + Σ h a, and the gyroscopic term is ω × (I ω + h).",
            Self::TorqueBodyAsSpace { .. } => {
                "A torque given along body axes is R N along those of space: rotate it before it is added, at each step anew."
            }
            Self::TorqueSpaceAsBody { .. } => {
                "A torque given along space axes is Rᵀ N along those of the body: rotate it before it is added, at each step anew."
            }
            Self::TorqueReversed { .. } => {
                "Change the sign: N = r × F, with r from the point that the body turns about to where the force acts."
            }
            Self::TorqueLeftOut { .. } => {
                "Apply the torque in every step; engines clear what was applied after each."
            }
            Self::TorqueScaled { .. } => {
                "See the torque's numbers: its unit, the mass, g, the lever, and whether it is applied once in each step."
            }
            Self::Damping { .. } | Self::MethodWithDamping { .. } => {
                "Set the angular damping of the body to zero: in some engines it is 0.04 or 0.05 1/s unless it is set."
            }
            Self::SpeedLimit { .. } => {
                "Raise the greatest angular speed of the body: in some engines it is 7, 47 or 100 rad/s unless it is set."
            }
            Self::Method { scheme, .. } => method_hint(*scheme),
            Self::RoundedRows(_) => "Log all 17 digits of doubles, if the program has them.",
            Self::SinglePrecisionArithmetic => {
                "Compute in double precision if that matters: single precision loses about 6e-8 in each step."
            }
            Self::TimeShift { .. } => {
                "See whether the rows are written before a step and stamped after it, or the other way round."
            }
            Self::StartOmegaAlongSpace => {
                "The scenario's ω is along body axes; an engine that takes it along space axes is to be given R ω."
            }
            Self::OtherStart { .. } => {
                "Start from the scenario's attitude and ω; mind along which axes ω is given to the engine."
            }
            Self::OtherTensor { .. } => {
                "See which tensor the program has: about which point, along which axes, of which parts and densities."
            }
        }
    }
}

const fn method_hint(scheme: Scheme) -> &'static str {
    match scheme {
        Scheme::ImplicitGyroscopic(_) | Scheme::LaggedMomentum(_) => {
            "An implicit gyroscopic term is stable and loses energy in proportion to the step: the body ends up turning about its axis of \
             greatest moment. Take shorter steps, or keep L along space axes and use a method of order 2 or more."
        }
        Scheme::HeldAtStart(_) | Scheme::HeldAtEnd(_) => {
            "Turn the attitude by the ω of the middle of the step, (ω + ω′)/2, as q′ = q exp(½ h ω): then the error falls with h²."
        }
        _ if scheme.order() < 2 => {
            "The error falls with h alone. Use a method of order 2 (midpoint, splitting into turns about the principal axes) or 4 (RK4 for q \
             and ω), or take many steps for each row."
        }
        Scheme::RungeKutta4MeanRate => {
            "The mean of ω turns the attitude with an error of h² even where ω has one of h⁴: integrate the quaternion itself by RK4, or \
             add the commutators of Munthe-Kaas. Otherwise take shorter steps."
        }
        _ => {
            "This is the error of the method at this step, and no mistake: take shorter steps for a smaller one."
        }
    }
}

/// A sentence.
impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of = |torque: &Option<&'static str>| torque.map_or_else(String::new, |name| format!(" ({name})"));
        match self {
            Self::NoGyroscopicTerm => f.write_str("ω × I ω is left out"),
            Self::OmegaBodyAsSpace => {
                f.write_str("the attitude is turned by body components of ω as if along space axes")
            }
            Self::OmegaSpaceAsBody => {
                f.write_str("the attitude is turned by space components of ω as if along body axes")
            }
            Self::ConjugateAttitude => f.write_str("the attitude is the inverse one, R_body_space"),
            Self::ScalarLast => f.write_str("the quaternion has its scalar last"),
            Self::TensorTransposed => f.write_str(
                "the tensor is turned from principal axes to the body's the wrong way, Rᵀ D R for R D Rᵀ",
            ),
            Self::PrincipalMomentsAlongBodyAxes(order) => {
                write!(f, "the principal moments {} are used along the body's x, y, z", numbered(order, 1))
            }
            Self::ProductsReversed => f.write_str("the products of inertia have the wrong sign"),
            Self::ProductsLeftOut => f.write_str("the products of inertia are left out"),
            Self::ProductsReordered(order) => {
                let name = |k: usize| ["I_xy", "I_xz", "I_yz"].get(k).copied().unwrap_or("?");
                let [a, b, c] = order.map(name);
                write!(
                    f,
                    "the products of inertia are in the wrong order: {a}, {b}, {c} for I_xy, I_xz, I_yz"
                )
            }
            Self::TensorAboutOrigin => {
                f.write_str("the tensor is about the origin of the body's axes, not about its centre of mass")
            }
            Self::TensorAboutCenterOfMass => {
                f.write_str("the tensor is about the centre of mass, not about the pivot")
            }
            Self::WheelsLeftOut => f.write_str("the momentum of the wheels is left out"),
            Self::TorqueBodyAsSpace { torque } => {
                write!(f, "the torque{} has its body components along space axes", of(torque))
            }
            Self::TorqueSpaceAsBody { torque } => {
                write!(f, "the torque{} has its space components along body axes", of(torque))
            }
            Self::TorqueReversed { torque } => write!(f, "the torque{} has the wrong sign", of(torque)),
            Self::TorqueLeftOut { torque } => write!(f, "the torque{} is left out", of(torque)),
            Self::TorqueScaled { factor } => {
                write!(
                    f,
                    "the torque is {factor:.6} times as large for this body: it, the mass that it acts on, or the tensor is another"
                )
            }
            Self::Damping { rate } => write!(f, "ω is damped: ω̇ has −c ω besides, c = {rate:.4} 1/s"),
            Self::DampingWithoutGyroscopicTerm { rate } => {
                write!(f, "ω × I ω is left out, and ω is damped: ω̇ = I⁻¹ N − c ω, c = {rate:.4} 1/s")
            }
            Self::SpeedLimit { limit, gyroscopic } => {
                let besides = if *gyroscopic { "" } else { ", and ω × I ω is left out" };
                write!(f, "|ω| is cut off at {limit:.6} rad/s{besides}")
            }
            Self::Method { scheme, step } if scheme.order() < 2 => {
                write!(f, "its steps are of order 1: {scheme}, h = {step:.6} s")
            }
            Self::MethodWithDamping { scheme, step, rate } => {
                write!(
                    f,
                    "ω is damped, c = {rate:.4} 1/s, and its steps are of order 1: {scheme}, h = {step:.6} s"
                )
            }
            Self::Method { scheme, step } => {
                write!(f, "this is the error of {scheme}, h = {step:.6} s")
            }
            Self::RoundedRows(None) => f.write_str("the motion is right to the single precision of its rows"),
            Self::RoundedRows(Some(digits)) => {
                write!(f, "the motion is right to the {digits} digits behind the point that its rows have")
            }
            Self::SinglePrecisionArithmetic => f.write_str("the motion is computed in single precision"),
            Self::TimeShift { shift } => {
                write!(f, "its rows are those of times {shift:.6} s later than they say")
            }
            Self::StartOmegaAlongSpace => {
                f.write_str("it starts with the body components of ω along space axes")
            }
            Self::OtherStart { angle, omega } => {
                write!(f, "it starts elsewhere: {angle:.6} rad from the scenario's attitude")?;
                omega.map_or(Ok(()), |omega| write!(f, ", with ω = {omega}"))
            }
            Self::OtherTensor { tensor: [a, b, c], has_scale } => {
                let scale = if *has_scale { "kg·m²" } else { "kg·m² times any factor" };
                write!(f, "it is the motion of another body, whose tensor is [")?;
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
