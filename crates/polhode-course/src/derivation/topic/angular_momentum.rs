//! Angular momentum and torque.

use crate::derivation::Derivation;
use crate::derivation::step::Ground::{Definition, Hypothesis};
use crate::derivation::step::{given, part, remark, result, setting, shown};

pub(super) const ANGULAR_MOMENTUM: Derivation = Derivation {
    name: "angular-momentum",
    title: "Angular momentum L = {I} · ω",
    steps: &[
        part("Double vector product"),
        given(
            Definition,
            "The angular momentum about the moving origin is, with position and velocity from there,",
            "~L = Σ_α m_α (~r_α × ~v_α)",
        ),
        given(
            Definition,
            "The particles of a rigid body have the velocities (eq. 10.17)",
            "~v_α = ~ω × ~r_α",
        ),
        shown("Hence", "~L = Σ_α m_α [~r_α × (~ω × ~r_α)]"),
        shown("The double vector product is", "~A × (~B × ~A) = ~A² ~B − (~A · ~B) ~A"),
        shown("so that", "~L = Σ_α m_α [~r_α² ~ω − (~r_α · ~ω) ~r_α]"),
        part("Components"),
        given(
            Definition,
            "Use components along the body axes:",
            "~ω = Σ_i ω_i x̂_i, ~r_α = Σ_i x_αi x̂_i, L_i = ~L · x̂_i",
        ),
        shown("Component i of L is", "L_i = Σ_α m_α [~r_α² ω_i − (~r_α · ~ω) x_αi]"),
        shown(
            "Insert the components, with ω_i = Σ_j ω_j δ_ij, and collect the factors of ω_j:",
            "L_i = Σ_α m_α (Σ_k x_αk² Σ_j ω_j δ_ij − Σ_j x_αj ω_j x_αi)\n\
             = Σ_j ω_j Σ_α m_α (δ_ij Σ_k x_αk² − x_αi x_αj)",
        ),
        given(
            Definition,
            "The sum over the particles is the inertia tensor:",
            "I_ij ≡ Σ_α m_α (δ_ij Σ_k x_αk² − x_αi x_αj)",
        ),
        shown("Hence", "L_i = Σ_j I_ij ω_j"),
        result("As a vector,", "~L = Σ_i L_i x̂_i = Σ_ij I_ij ω_j x̂_i = {I} · ~ω"),
        shown(
            "This is the product of a matrix and a column:",
            "(L_1; L_2; L_3) = (I_11, I_12, I_13; I_21, I_22, I_23; I_31, I_32, I_33) (ω_1; ω_2; ω_3) = \
             (Σ_j I_1j ω_j; Σ_j I_2j ω_j; Σ_j I_3j ω_j)",
        ),
        part("Kinetic energy"),
        given(Definition, "The energy of rotation is (inertia-tensor)", "T_rot = 1/2 Σ_ij I_ij ω_i ω_j"),
        shown(
            "The sum over j is L_i, so T_rot is half the scalar product of ω and L:",
            "T_rot = 1/2 Σ_i ω_i L_i = 1/2 ~ω · ~L = 1/2 ~ω · {I} · ~ω",
        ),
    ],
};

pub(super) const TORQUE: Derivation = Derivation {
    name: "torque",
    title: "Torque N = dL/dt from Newton's law",
    steps: &[
        part("About a fixed point"),
        given(
            Definition,
            "Let the origin be at rest in an inertial frame. Then",
            "~v_α = d/dt ~r_α, ~L = Σ_α m_α (~r_α × ~v_α)",
        ),
        shown(
            "Differentiate each factor of the products:",
            "d/dt ~L = Σ_α m_α (~v_α × ~v_α + ~r_α × d/dt ~v_α)",
        ),
        shown("The first product is zero, as v is parallel to itself:", "~v_α × ~v_α = 0"),
        setting("~F_α = m_α d/dt ~v_α − Σ_β ~f_αβ"),
        shown(
            "By Newton's second law the external force F_α and the forces f_αβ of the other particles give",
            "m_α d/dt ~v_α = ~F_α + Σ_β ~f_αβ",
        ),
        given(
            Hypothesis,
            "Two particles attract or repel each other along the line between them, with equal and opposite forces:",
            "~f_αβ = k_αβ (~r_α − ~r_β)",
        ),
        shown("with a number k for each pair. Their torques cancel:", "Σ_αβ (~r_α × ~f_αβ) = 0"),
        given(Definition, "What remains is the torque of the external forces:", "~N ≡ Σ_α (~r_α × ~F_α)"),
        result("Hence", "~N = d/dt ~L"),
        part("About the centre of mass"),
        setting("~s_3 = −(m_1 ~s_1 + m_2 ~s_2)/m_3"),
        given(
            Definition,
            "The centre of mass R may be accelerated. With positions s from it,",
            "~r_α = ~R + ~s_α, ~L' = Σ_α m_α (~s_α × d/dt ~s_α), ~N' = Σ_α (~s_α × ~F_α)",
        ),
        shown("The origin is the centre of mass, so", "Σ_α m_α ~s_α = 0"),
        given(Definition, "With the total mass", "M ≡ Σ_α m_α"),
        shown(
            "L and N split into a part of the centre of mass and a part about it, and the external forces move the \
             centre of mass:",
            "~L = M (~R × d/dt ~R) + ~L', ~N = ~R × Σ_α ~F_α + ~N', Σ_α ~F_α = M d/dt d/dt ~R",
        ),
        shown("Therefore the same law holds about the centre of mass, however it moves:", "~N' = d/dt ~L'"),
        part("Not {I} · ω̇ alone"),
        remark(
            "The notes continue with N = {I} · ω̇, since {I} is constant. It is constant only along the body axes, \
             and these turn: N = {I} · ω̇ + ω × L (euler-equations). N = {I} · ω̇ holds where ω × L = 0, as in a \
             rotation about a fixed principal axis.",
        ),
    ],
};
