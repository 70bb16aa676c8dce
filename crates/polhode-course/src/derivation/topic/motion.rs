//! Two applications: a pendulum and a dumbbell.

use crate::derivation::Derivation;
use crate::derivation::step::Ground::{Definition, Law, Limit};
use crate::derivation::step::{given, part, result, setting, shown};

pub(super) const PENDULUM: Derivation = Derivation {
    name: "pendulum-frequency",
    title: "Frequency of a pendulum with two masses (example 11.4)",
    steps: &[
        part("Inertia tensor"),
        setting("m_3 = 0"),
        given(
            Definition,
            "x is along the rod, and z is the axis, which points out of the page. m₁ is at the end of the rod of \
             length b, m₂ at its middle:",
            "~r_1 = b x̂, ~r_2 = b/2 x̂",
        ),
        given(
            Definition,
            "With the coordinates x_αi of the particles the tensor is (inertia-tensor)",
            "x_αi = ~r_α · x̂_i\nI_ij = Σ_α m_α (δ_ij Σ_k x_αk² − x_αi x_αj)",
        ),
        shown(
            "It is diagonal, so the axes are principal axes:",
            "{I} = {0, 0, 0; 0, (m_1 + 1/4 m_2) b², 0; 0, 0, (m_1 + 1/4 m_2) b²}",
        ),
        part("Torque"),
        given(
            Definition,
            "θ is the angle of the rod from the vertical. Gravity has the torque",
            "~g = g cos θ x̂ − g sin θ ŷ\n~N = Σ_α m_α (~r_α × ~g)",
        ),
        shown("Each product is along z:", "~r_1 × ~g = −b g sin θ ẑ, ~r_2 × ~g = −b/2 g sin θ ẑ"),
        shown("Hence", "~N = −(m_1 + 1/2 m_2) b g sin θ ẑ"),
        part("Equation of motion"),
        given(Definition, "The pendulum turns about z:", "~ω = θ̇ ẑ"),
        shown("This is a principal axis, so N = {I} · ω̇ + ω × L has no second term:", "~ω × ({I} · ~ω) = 0"),
        shown("The first term is", "{I} · ~ω̇ = (m_1 + 1/4 m_2) b² θ̈ ẑ"),
        given(
            Law,
            "The notes lose the minus sign of the torque here; without it θ would grow. The z component of N = {I} · ω̇ is",
            "(m_1 + 1/4 m_2) b² θ̈ = −(m_1 + 1/2 m_2) b g sin θ",
        ),
        part("Lagrange's equation"),
        given(
            Definition,
            "The notes print T + U for the Lagrangian; it is T − U.",
            "T = 1/2 ~ω · {I} · ~ω, U = −Σ_α m_α [~g · ~r_α], L = T − U",
        ),
        shown(
            "With the tensor and the positions from above,",
            "T = 1/2 (m_1 + 1/4 m_2) b² θ̇²\nU = −m_1 g b cos θ − m_2 g b/2 cos θ",
        ),
        shown(
            "Lagrange's equation, in which this is zero, is the same equation of motion:",
            "d/dt (∂L/∂θ̇) − ∂L/∂θ = (m_1 + 1/4 m_2) b² θ̈ + (m_1 + 1/2 m_2) b g sin θ",
        ),
        part("Small oscillations"),
        given(Limit, "For small angles", "sin θ ≃ θ"),
        given(
            Definition,
            "Divide by the moment of inertia, and define",
            "K = (m_1 + 1/2 m_2)/(m_1 + 1/4 m_2) g/b",
        ),
        given(Law, "The equation of motion becomes", "θ̈ + K θ = 0"),
        setting("ω_0 = c"),
        given(Definition, "It is solved by an oscillation of amplitude A,", "θ = A cos (ω_0 t)"),
        shown("for which", "θ̈ = −ω_0² θ"),
        setting("g = ω_0² b (m_1 + 1/4 m_2)/(m_1 + 1/2 m_2)"),
        shown("Hence the equation holds for ω₀² = K:", "θ̈ + K θ = 0, ω_0² = K"),
        result("The frequency of small oscillations is", "ω_0² = (m_1 + 1/2 m_2)/(m_1 + 1/4 m_2) g/b"),
    ],
};

pub(super) const DUMBBELL: Derivation = Derivation {
    name: "dumbbell",
    title: "Torque and forces of a slanted dumbbell (example 11.10)",
    steps: &[
        part("Body, axes and rotation"),
        setting("m_3 = 0"),
        given(
            Definition,
            "z is along the rod, y along L, and x completes the right-handed axes. The masses are at",
            "~r_1 = b ẑ, ~r_2 = −b ẑ",
        ),
        given(
            Definition,
            "The dumbbell turns with constant ω about a fixed axis at the angle α from the rod:",
            "~ω = ω sin α ŷ + ω cos α ẑ, ω_i = ~ω · x̂_i",
        ),
        given(
            Definition,
            "With the coordinates x_αi of the particles the tensor is (inertia-tensor)",
            "x_αi = ~r_α · x̂_i\nI_ij = Σ_α m_α (δ_ij Σ_k x_αk² − x_αi x_αj)",
        ),
        shown(
            "It is diagonal, so the axes are principal axes:",
            "{I} = {(m_1 + m_2) b², 0, 0; 0, (m_1 + m_2) b², 0; 0, 0, 0}",
        ),
        given(Definition, "The principal moments are", "I_1 = (m_1 + m_2) b², I_2 = (m_1 + m_2) b², I_3 = 0"),
        given(Definition, "The angular momentum is", "~L = {I} · ~ω"),
        shown("It is along y, as the choice of the axes assumed:", "~L = (m_1 + m_2) b² ω sin α ŷ"),
        part("Torque"),
        setting("ω = c"),
        given(
            Definition,
            "Euler's equations give the torque. The notes first print the label N_x for all three components.",
            "N_x = I_1 ω̇_1 − (I_2 − I_3) ω_2 ω_3\n\
             N_y = I_2 ω̇_2 − (I_3 − I_1) ω_3 ω_1\n\
             N_z = I_3 ω̇_3 − (I_1 − I_2) ω_1 ω_2",
        ),
        setting("α = c'"),
        shown(
            "The components of ω are constant along the body axes, so every ω̇ is zero:",
            "N_x = −(m_1 + m_2) b² ω² sin α cos α, N_y = 0, N_z = 0",
        ),
        given(Definition, "The torque that keeps the axis fixed is", "~N = N_x x̂ + N_y ŷ + N_z ẑ"),
        result("It is perpendicular to the rod and to L:", "~N = −(m_1 + m_2) b² ω² sin α cos α x̂"),
        shown("This is the rate of L, which is fixed in the body and turns with it:", "~N = ~ω × ~L"),
        part("Forces"),
        given(
            Law,
            "The notes ask for the forces. Each mass moves on a circle, so by Newton's law",
            "~F_k = m_k ~ω × (~ω × ~r_k)",
        ),
        shown(
            "Insert the positions; the forces point to the axis.",
            "~F_1 = m_1 b ω² sin α (cos α ŷ − sin α ẑ)\n~F_2 = −m_2 b ω² sin α (cos α ŷ − sin α ẑ)",
        ),
        shown("Their magnitudes are m_k ω² b sin α:", "~F_1² = (m_1 ω² b sin α)², ~F_2² = (m_2 ω² b sin α)²"),
        shown("Together they have the torque N:", "~r_1 × ~F_1 + ~r_2 × ~F_2 = ~N"),
        shown(
            "For different masses the bearing also takes a net force:",
            "~F_1 + ~F_2 = (m_1 − m_2) ~ω × (~ω × b ẑ)",
        ),
    ],
};
