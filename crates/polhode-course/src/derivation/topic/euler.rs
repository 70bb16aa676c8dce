//! Euler's equations.

use crate::derivation::Derivation;
use crate::derivation::step::Ground::{Definition, Hypothesis, Law};
use crate::derivation::step::{given, part, remark, result, setting, shown};

pub(super) const EULER_EQUATIONS: Derivation = Derivation {
    name: "euler-equations",
    title: "Euler's equations of a rigid body",
    steps: &[
        setting("x̂_i = Σ_j R_ij ê_j"),
        setting("ω_1 = φ̇ sin θ sin ψ + θ̇ cos ψ, ω_2 = φ̇ sin θ cos ψ − θ̇ sin ψ, ω_3 = φ̇ cos θ + ψ̇"),
        part("Rates of vectors"),
        given(
            Definition,
            "The axes x̂_i turn with the body. All rates d/dt are those in the fixed frame. Let Q be any vector, with \
             its components along the turning axes:",
            "~ω = Σ_i ω_i x̂_i, ~Q = Σ_i Q_i x̂_i",
        ),
        shown(
            "Its rate in the fixed frame is that in the turning frame, which has the rates of the components, and \
             ω × Q (eq. 10.12):",
            "d/dt ~Q = Σ_i Q̇_i x̂_i + ~ω × ~Q",
        ),
        shown("An axis has constant components, so", "d/dt x̂_i = ~ω × x̂_i"),
        part("Any body axes"),
        given(
            Definition,
            "The angular momentum (angular-momentum) changes by the torque (torque):",
            "~L = Σ_ij I_ij ω_j x̂_i, ~N = d/dt ~L",
        ),
        shown(
            "The I_ij are constant along axes of the body. Differentiate the other two factors:",
            "~N = Σ_ij I_ij (ω̇_j x̂_i + ω_j d/dt x̂_i)\n= Σ_ij I_ij (ω̇_j x̂_i + ω_j ~ω × x̂_i)",
        ),
        shown(
            "The second sum is ω × L. The earlier N = {I} · ω̇ of the notes lacks it.",
            "~N = Σ_ij I_ij ω̇_j x̂_i + ~ω × ~L",
        ),
        part("Principal axes"),
        given(Hypothesis, "Choose the principal axes of the body.", "I_ij = I_i δ_ij"),
        shown("One index remains:", "~N = Σ_i I_i (ω̇_i x̂_i + ω_i ~ω × x̂_i)"),
        shown("The axes are right-handed,", "x̂ × ŷ = ẑ, ŷ × ẑ = x̂, ẑ × x̂ = ŷ"),
        shown("so that", "~ω × x̂ = ω_3 ŷ − ω_2 ẑ\n~ω × ŷ = ω_1 ẑ − ω_3 x̂\n~ω × ẑ = ω_2 x̂ − ω_1 ŷ"),
        given(Definition, "Collect the terms along each axis,", "N_x = ~N · x̂, N_y = ~N · ŷ, N_z = ~N · ẑ"),
        result(
            "These are Euler's equations. The notes print N_x in all three.",
            "N_x = I_1 ω̇_1 − (I_2 − I_3) ω_2 ω_3\n\
             N_y = I_2 ω̇_2 − (I_3 − I_1) ω_3 ω_1\n\
             N_z = I_3 ω̇_3 − (I_1 − I_2) ω_1 ω_2",
        ),
    ],
};

pub(super) const SIX_STEPS: Derivation = Derivation {
    name: "six-steps",
    title: "How to use Euler's equations, in six steps",
    steps: &[
        part("Choose the axes"),
        remark(
            "What does a torque N do to a body: how do ω and the attitude change? Choose the orientation of the body \
             axes at a time t₀, and as the origin the centre of mass or a fixed point.",
        ),
        part("Note ω and N"),
        given(
            Definition,
            "Resolve both along the body axes at t₀:",
            "~ω = ω_1 x̂ + ω_2 ŷ + ω_3 ẑ, ~N = N_1 x̂ + N_2 ŷ + N_3 ẑ",
        ),
        part("Find the principal axes"),
        given(
            Definition,
            "Compute {I} about the origin (inertia-tensor), its principal moments and its axes (principal-axes). \
             Turn the body axes to these, and resolve ω and N again:",
            "I_ij = I_i δ_ij",
        ),
        part("Write Euler's equations"),
        given(
            Law,
            "They are (euler-equations)",
            "N_1 = I_1 ω̇_1 − (I_2 − I_3) ω_2 ω_3\n\
             N_2 = I_2 ω̇_2 − (I_3 − I_1) ω_3 ω_1\n\
             N_3 = I_3 ω̇_3 − (I_1 − I_2) ω_1 ω_2",
        ),
        result(
            "Solve them for the rates:",
            "ω̇_1 = [N_1 + (I_2 − I_3) ω_2 ω_3]/I_1\n\
             ω̇_2 = [N_2 + (I_3 − I_1) ω_3 ω_1]/I_2\n\
             ω̇_3 = [N_3 + (I_1 − I_2) ω_1 ω_2]/I_3",
        ),
        part("Solve for ω(t)"),
        remark(
            "Integrate the three equations from ω(t₀), in closed form if possible (symmetric-top), otherwise \
             numerically. This is the motion of the axis of rotation in the body.",
        ),
        part("Solve for the attitude"),
        given(
            Definition,
            "The axes turn by dx̂_i/dt = ω × x̂_i. With Euler's angles φ, θ, ψ these equations are",
            "ω_1 = φ̇ sin θ sin ψ + θ̇ cos ψ\n\
             ω_2 = φ̇ sin θ cos ψ − θ̇ sin ψ\n\
             ω_3 = φ̇ cos θ + ψ̇",
        ),
        setting("x̂_i = Σ_j R_ij ê_j"),
        shown("which is the same motion of the axes:", "d/dt x̂_i = ~ω × x̂_i"),
        shown(
            "Solve for the rates of the angles, and integrate them. The motion of the body is then known.",
            "φ̇ = (ω_1 sin ψ + ω_2 cos ψ)/sin θ\n\
             θ̇ = ω_1 cos ψ − ω_2 sin ψ\n\
             ψ̇ = ω_3 − (ω_1 sin ψ + ω_2 cos ψ)/tan θ",
        ),
    ],
};
