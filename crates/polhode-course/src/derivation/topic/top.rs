//! Free symmetric top.

use crate::derivation::Derivation;
use crate::derivation::step::Ground::{Definition, Hypothesis, Theorem};
use crate::derivation::step::{given, part, remark, result, setting, shown};

pub(super) const SYMMETRIC_TOP: Derivation = Derivation {
    name: "symmetric-top",
    title: "Free motion of a symmetric top",
    steps: &[
        part("Euler's equations"),
        given(
            Definition,
            "Euler's equations are (euler-equations)",
            "N_1 = I_1 ω̇_1 − (I_2 − I_3) ω_2 ω_3\n\
             N_2 = I_2 ω̇_2 − (I_3 − I_1) ω_3 ω_1\n\
             N_3 = I_3 ω̇_3 − (I_1 − I_2) ω_1 ω_2",
        ),
        given(
            Hypothesis,
            "The moments about two axes are equal; the third axis is the axis of symmetry.",
            "I_2 = I_1",
        ),
        shown(
            "The equations become",
            "N_1 = I_1 ω̇_1 − (I_1 − I_3) ω_2 ω_3\nN_2 = I_1 ω̇_2 − (I_3 − I_1) ω_3 ω_1\nN_3 = I_3 ω̇_3",
        ),
        given(Theorem, "No torque acts, so N₃ = 0, and ω₃ is constant:", "ω̇_3 = 0"),
        given(Definition, "Define the constant", "Ω ≡ (I_3 − I_1)/I_1 ω_3"),
        shown("With it,", "N_1 = I_1 (ω̇_1 + Ω ω_2), N_2 = I_1 (ω̇_2 − Ω ω_1)"),
        given(Theorem, "Both are zero:", "ω̇_1 = −Ω ω_2, ω̇_2 = Ω ω_1"),
        part("Solution"),
        given(
            Definition,
            "The two coupled equations are one equation for the complex number",
            "η ≡ ω_1 + i ω_2",
        ),
        shown("Its rate by these equations is i Ω η:", "−Ω ω_2 + i Ω ω_1 = i Ω η"),
        setting("ω_3 = c"),
        given(
            Definition,
            "Hence η̇ = i Ω η. This is solved by an exponential function, where A is real with a suitable start of time:",
            "η = A e^(i Ω t)",
        ),
        shown("because", "η̇ = i Ω η"),
        shown("Split it into real and imaginary part,", "η = A cos (Ω t) + i A sin (Ω t)"),
        given(Definition, "which are the components of ω:", "ω_1 = A cos (Ω t), ω_2 = A sin (Ω t)"),
        shown("They solve Euler's equations without torque:", "N_1 = 0, N_2 = 0, N_3 = 0"),
        result(
            "ω has a constant magnitude and a constant angle from the axis of symmetry. In the body it goes round this \
             axis with the angular velocity Ω, on the body cone.",
            "ω_1² + ω_2² = A², ω̇_1 = −Ω ω_2, ω̇_2 = Ω ω_1",
        ),
    ],
};

pub(super) const COPLANAR: Derivation = Derivation {
    name: "coplanar",
    title: "L, ω and the axis of symmetry are in one plane",
    steps: &[
        part("Triple product"),
        given(
            Definition,
            "Along the principal axes",
            "~ω = ω_1 x̂_1 + ω_2 x̂_2 + ω_3 x̂_3, ~L = I_1 ω_1 x̂_1 + I_2 ω_2 x̂_2 + I_3 ω_3 x̂_3",
        ),
        shown("ω × x̂₃ is perpendicular to ω and x̂₃:", "~ω × x̂_3 = ω_2 x̂_1 − ω_1 x̂_2"),
        shown("Its product with L is", "~L · (~ω × x̂_3) = (I_1 − I_2) ω_1 ω_2"),
        given(Hypothesis, "The top is symmetric.", "I_2 = I_1"),
        result(
            "The three vectors span no volume: L is in the plane of ω and x̂₃ at all times.",
            "~L · (~ω × x̂_3) = 0",
        ),
        part("Order in the plane"),
        shown("L is a sum of multiples of the other two:", "~L = I_1 ~ω + (I_3 − I_1) ω_3 x̂_3"),
        remark(
            "For ω₃ > 0 this tells the order in the plane. If I₃ > I₁ (oblate), L is between x̂₃ and ω. If I₃ < I₁ \
             (prolate), ω is between x̂₃ and L.",
        ),
    ],
};

pub(super) const CONES: Derivation = Derivation {
    name: "cones",
    title: "Space cone and body cone of a free symmetric top",
    steps: &[
        part("Body cone"),
        given(
            Definition,
            "α is the angle of ω from x̂₃. χ is the angle of its projection onto the plane of x̂₁ and x̂₂, which \
             grows with the rate Ω (symmetric-top):",
            "ω_1 = ω sin α cos χ, ω_2 = ω sin α sin χ, ω_3 = ω cos α",
        ),
        given(Definition, "As a vector,", "~ω = Σ_i ω_i x̂_i"),
        given(
            Definition,
            "The angular momentum of the symmetric top is",
            "~L = I_1 ω_1 x̂_1 + I_1 ω_2 x̂_2 + I_3 ω_3 x̂_3",
        ),
        shown(
            "In the body, ω sweeps the body cone about x̂₃, with the half angle α:",
            "~ω · x̂_3 = ω cos α, ~ω² = ω²",
        ),
        setting("I_3 = I_1 tan α/tan θ"),
        setting("L = I_1 ω sin α/sin θ"),
        shown(
            "L is in the plane of x̂₃ and ω (coplanar). Let θ be its angle from x̂₃, on the side of ω, and L its magnitude:",
            "L sin θ = I_1 ω sin α, L cos θ = I_3 ω cos α",
        ),
        shown("The quotient is", "tan θ = I_1/I_3 tan α"),
        shown("These are magnitude and angle of L:", "~L² = L², ~L · x̂_3 = L cos θ"),
        part("Space cone"),
        given(Definition, "All energy is rotational (kinetic-energy):", "T_rot = 1/2 ~ω · ~L"),
        shown(
            "The angle between ω and L is φ = |α − θ|. The energy and L are constant, hence also ω cos φ, the \
             projection of ω onto L.",
            "T_rot = 1/2 ω L cos (α − θ)",
        ),
        remark(
            "In space L is fixed, and ω sweeps the space cone about L, with the half angle φ. If I₃ > I₁, then θ < α, \
             and the space cone is inside the body cone. If I₃ < I₁, the body cone rolls on the outside.",
        ),
        part("Rate in space"),
        given(Definition, "With the rate of ω in the body,", "Ω ≡ (I_3 − I_1)/I_1 ω_3"),
        shown(
            "ω is the sum of a rotation about L and one about the axis of symmetry:",
            "~ω = ~L/I_1 − Ω x̂_3",
        ),
        shown("Therefore x̂₃ turns about L with the angular velocity L/I₁:", "~ω × x̂_3 = ~L/I_1 × x̂_3"),
        result(
            "The rate of ω is the same in the body and in space, as ω × ω = 0. Thus ω turns about L with L/I₁ too:",
            "−Ω ω_2 x̂_1 + Ω ω_1 x̂_2 = ~L/I_1 × ~ω",
        ),
        part("Rolling contact"),
        shown(
            "The cones touch along ω. A point s ω of the body on this line is at rest, so the body cone rolls on the \
             space cone without slip:",
            "~ω × (s ~ω) = 0",
        ),
        shown(
            "In the same time ω covers equal arcs on both cones: Ω on the body cone, L/I₁ on the space cone.",
            "Ω ω sin α = L/I_1 ω sin (α − θ)",
        ),
    ],
};
