//! Free motion of any body.

use crate::derivation::Derivation;
use crate::derivation::step::Ground::{Definition, Hypothesis, Law};
use crate::derivation::step::{given, part, remark, result, shown};

pub(super) const ENERGY_AND_MOMENTUM: Derivation = Derivation {
    name: "energy-and-momentum",
    title: "Energy and angular momentum in free motion; the polhode",
    steps: &[
        part("Conserved quantities"),
        given(
            Definition,
            "Along the principal axes",
            "L_i = I_i ω_i, ~L = Σ_i L_i x̂_i, T = 1/2 Σ_i I_i ω_i²",
        ),
        given(
            Law,
            "Euler's equations are (euler-equations)",
            "N_1 = I_1 ω̇_1 − (I_2 − I_3) ω_2 ω_3\n\
             N_2 = I_2 ω̇_2 − (I_3 − I_1) ω_3 ω_1\n\
             N_3 = I_3 ω̇_3 − (I_1 − I_2) ω_1 ω_2",
        ),
        given(Definition, "and the torque is", "~N = Σ_i N_i x̂_i, ~ω = Σ_i ω_i x̂_i"),
        shown("Multiply them by ω_i and add. The products of three ω cancel:", "d/dt T = ~ω · ~N"),
        shown("Multiply them by L_i and add:", "d/dt (~L²) = 2 ~L · ~N"),
        remark(
            "Without torque T and |L| are constant. In space even the vector L is constant, because dL/dt = N (torque). \
             In the body it moves, with a constant magnitude.",
        ),
        part("Polhode"),
        result(
            "In the body ω stays on two ellipsoids, of the energy and of the angular momentum. Their intersection is \
             the path of ω, the polhode.",
            "2 T = I_1 ω_1² + I_2 ω_2² + I_3 ω_3², ~L² = I_1² ω_1² + I_2² ω_2² + I_3² ω_3²",
        ),
        shown(
            "In terms of L they are an ellipsoid and a sphere:",
            "2 T = L_1²/I_1 + L_2²/I_2 + L_3²/I_3, ~L² = L_1² + L_2² + L_3²",
        ),
        part("Shape"),
        remark("Number the axes so that I₁ < I₂ < I₃. Eliminate one component at a time:"),
        shown(
            "Near axis 1 and axis 3 the polhodes are closed curves around the axis, because both coefficients have the \
             same sign. These rotations are stable.",
            "2 I_3 T − ~L² = I_1 (I_3 − I_1) ω_1² + I_2 (I_3 − I_2) ω_2²\n\
             ~L² − 2 I_1 T = I_2 (I_2 − I_1) ω_2² + I_3 (I_3 − I_1) ω_3²",
        ),
        shown(
            "Near axis 2 they are hyperbolas, because the signs differ. The rotation about it is unstable.",
            "~L² − 2 I_2 T = I_3 (I_3 − I_2) ω_3² − I_1 (I_2 − I_1) ω_1²",
        ),
        given(
            Hypothesis,
            "The first two are never negative, which bounds L² for a given energy:",
            "2 I_1 T ≤ ~L² ≤ 2 I_3 T",
        ),
    ],
};
