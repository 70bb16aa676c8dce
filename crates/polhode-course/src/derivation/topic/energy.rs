//! Kinetic energy.

use crate::derivation::Derivation;
use crate::derivation::step::Ground::{Definition, Hypothesis};
use crate::derivation::step::{given, part, result, setting, shown};

pub(super) const KINETIC_ENERGY: Derivation = Derivation {
    name: "kinetic-energy",
    title: "Kinetic energy: translation and rotation",
    steps: &[
        part("Velocity of a particle"),
        given(
            Definition,
            "The moving axes have their origin in the body and turn with it. Let V be the velocity of the \
             origin, r_α the position of particle α from the origin, and u_α its velocity relative to the moving \
             axes. Its velocity relative to the fixed axes is (eq. 10.17):",
            "~v_α = ~V + ~u_α + ~ω × ~r_α",
        ),
        given(
            Hypothesis,
            "The relative positions of the particles of a rigid body are fixed, so no particle moves relative to \
             the moving axes:",
            "~u_α = 0",
        ),
        shown("Hence", "~v_α = ~V + ~ω × ~r_α"),
        part("Three terms"),
        given(Definition, "The kinetic energy is the sum over all particles:", "T ≡ 1/2 Σ_α m_α ~v_α²"),
        given(Definition, "The total mass is", "M ≡ Σ_α m_α"),
        shown(
            "Insert the velocity, and expand the square.",
            "T = 1/2 Σ_α m_α (~V + ~ω × ~r_α)²\n\
             = 1/2 M ~V² + Σ_α m_α [~V · (~ω × ~r_α)] + 1/2 Σ_α m_α (~ω × ~r_α)²",
        ),
        shown(
            "V and ω are the same for all particles, so they can be taken out of the sum in the middle term:",
            "T = 1/2 M ~V² + ~V · (~ω × Σ_α m_α ~r_α) + 1/2 Σ_α m_α (~ω × ~r_α)²",
        ),
        part("The centre of mass as the origin"),
        given(
            Definition,
            "Choose the centre of mass R as the origin. The position of a particle relative to the fixed origin is then",
            "~r'_α = ~R + ~r_α",
        ),
        given(Hypothesis, "R is the centre of mass:", "1/M Σ_α m_α ~r'_α = ~R"),
        shown("The left side is", "1/M Σ_α m_α ~r'_α = ~R + 1/M Σ_α m_α ~r_α"),
        setting("~r_3 = −(m_1 ~r_1 + m_2 ~r_2)/m_3"),
        shown("so that the last term is zero:", "Σ_α m_α ~r_α = 0"),
        shown("The middle term of T vanishes:", "~V · (~ω × Σ_α m_α ~r_α) = 0"),
        given(
            Definition,
            "The others are the energy of translation and the energy of rotation:",
            "T_trans ≡ 1/2 M ~V², T_rot ≡ 1/2 Σ_α m_α (~ω × ~r_α)²",
        ),
        result("The kinetic energy is their sum.", "T = T_trans + T_rot"),
        part("A fixed point as the origin"),
        setting("~r_α = ~s_α"),
        given(
            Hypothesis,
            "If a point of the body is fixed in space, choose it as the origin. The centre of mass may then be anywhere.",
            "~V = 0",
        ),
        shown(
            "Both terms with V vanish, and all energy is rotational:",
            "T = T_rot = 1/2 Σ_α m_α (~ω × ~r_α)²",
        ),
    ],
};
