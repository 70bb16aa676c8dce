//! Other origins and other axes.

use crate::derivation::Derivation;
use crate::derivation::step::Ground::{Definition, Hypothesis, Theorem};
use crate::derivation::step::{given, part, remark, result, setting, shown};

pub(super) const PARALLEL_AXES: Derivation = Derivation {
    name: "parallel-axes",
    title: "Inertia tensor about another origin (Steiner's theorem)",
    steps: &[
        part("Two origins"),
        remark(
            "The notes choose the centre of mass or a fixed point as the origin. This theorem relates the tensors \
             about the two.",
        ),
        given(
            Definition,
            "Let x_αi be the coordinates of the particles from the centre of mass, and X_αi those along parallel \
             axes from another origin. The centre of mass is at a from there:",
            "X_αi = x_αi + a_i, M = Σ_α m_α",
        ),
        given(
            Definition,
            "The tensors about the centre of mass and about the other origin are",
            "I_ij = Σ_α m_α (δ_ij Σ_k x_αk² − x_αi x_αj)\nJ_ij = Σ_α m_α (δ_ij Σ_k X_αk² − X_αi X_αj)",
        ),
        part("Difference"),
        given(Definition, "Let S be the first moments,", "S_i ≡ Σ_α m_α x_αi"),
        shown(
            "Insert X, and collect the terms of degree 2, 1 and 0 in x:",
            "J_ij = I_ij + 2 δ_ij Σ_k a_k S_k − a_i S_j − a_j S_i + M (δ_ij Σ_k a_k² − a_i a_j)",
        ),
        setting("x_3k = −(m_1 x_1k + m_2 x_2k)/m_3"),
        shown("The coordinates x are those from the centre of mass, so", "S_i = 0"),
        result("All terms of degree 1 vanish:", "J_ij = I_ij + M (δ_ij Σ_k a_k² − a_i a_j)"),
        shown(
            "For example, about a parallel to the axis 3 at the distance √(a₁² + a₂²), and off the diagonal:",
            "J_33 = I_33 + M (a_1² + a_2²), J_12 = I_12 − M a_1 a_2",
        ),
    ],
};

pub(super) const CHANGE_OF_AXES: Derivation = Derivation {
    name: "change-of-axes",
    title: "Inertia tensor along other axes: I' = R I Rᵀ",
    steps: &[
        part("Rotation of the axes"),
        given(
            Definition,
            "The rows of the rotation R are the unit vectors of the new axes. Components along these axes are",
            "ω'_i = Σ_j R_ij ω_j, L'_i = Σ_j R_ij L_j",
        ),
        shown(
            "The rows are perpendicular unit vectors, and so are the columns:",
            "{R} {R}^T = {1}, {R}^T {R} = {1}, det {R} = 1",
        ),
        shown("The transpose therefore leads back:", "ω_i = Σ_j R_ji ω'_j"),
        part("Tensor"),
        given(Definition, "Along the old axes", "L_i = Σ_j I_ij ω_j"),
        shown("Insert this into L', and express ω by ω':", "L'_i = Σ_jkl R_ij I_jk R_lk ω'_l"),
        given(
            Definition,
            "The factor of ω'_l is the tensor along the new axes:",
            "I'_il ≡ Σ_jk R_ij I_jk R_lk",
        ),
        shown("so that L' is the product of I' and ω':", "L'_i = Σ_j I'_ij ω'_j"),
        result("As matrices,", "{I'} = {R} {I} {R}^T"),
        part("What does not change"),
        shown("I' is symmetric, and has the same trace:", "I'_ij = I'_ji, Σ_i I'_ii = Σ_i I_ii"),
        shown(
            "The energy of rotation does not depend on the axes:",
            "1/2 Σ_ij I'_ij ω'_i ω'_j = 1/2 Σ_ij I_ij ω_i ω_j",
        ),
    ],
};

pub(super) const PRINCIPAL_AXES: Derivation = Derivation {
    name: "principal-axes",
    title: "Principal axes and principal moments",
    steps: &[
        part("Diagonal tensor"),
        given(
            Definition,
            "For any axes (inertia-tensor, angular-momentum)",
            "T_rot = 1/2 Σ_ij I_ij ω_i ω_j, ~L = {I} · ~ω",
        ),
        given(Definition, "with the components of ω along the axes:", "~ω = Σ_i ω_i x̂_i"),
        given(
            Hypothesis,
            "Principal axes are those along which the tensor is diagonal. The notes print T_rot in place of I_ij here.",
            "I_ij = I_i δ_ij",
        ),
        shown(
            "One index remains. The I_i are the principal moments:",
            "T_rot = 1/2 Σ_i I_i ω_i², ~L = Σ_i I_i ω_i x̂_i",
        ),
        given(Hypothesis, "In a rotation about one of these axes, say z,", "ω_1 = 0, ω_2 = 0, ω_3 = ω"),
        shown(
            "the formulas of elementary textbooks hold. They hold for principal axes only: L is parallel to ω.",
            "T_rot = 1/2 I_3 ω², ~L = I_3 ~ω",
        ),
        part("Characteristic equation"),
        setting("I_ij = J_ij"),
        setting("ω_i = w_i"),
        given(
            Theorem,
            "How are the axes found? Let {I} be known along any axes, and let the body rotate about a principal axis. Then \
             L is parallel to ω, with the unknown principal moment I as the factor. This holds for each component i:",
            "Σ_j I_ij ω_j = I ω_i",
        ),
        shown("Take the right side to the left:", "Σ_j I_ij ω_j − I ω_i = Σ_j (I_ij − I δ_ij) ω_j"),
        given(
            Theorem,
            "These are three equations for ω:",
            "(I_11 − I) ω_1 + I_12 ω_2 + I_13 ω_3 = 0\n\
             I_21 ω_1 + (I_22 − I) ω_2 + I_23 ω_3 = 0\n\
             I_31 ω_1 + I_32 ω_2 + (I_33 − I) ω_3 = 0",
        ),
        given(
            Theorem,
            "They have a solution other than ω = 0 only if the determinant of the coefficients is zero:",
            "|I_11 − I, I_12, I_13; I_21, I_22 − I, I_23; I_31, I_32, I_33 − I| = 0",
        ),
        given(
            Definition,
            "It is a cubic polynomial in I. With",
            "p = I_11 + I_22 + I_33, q = I_11 I_22 + I_22 I_33 + I_33 I_11 − I_12² − I_23² − I_31²",
        ),
        result(
            "the determinant is as follows. Its three roots I₁, I₂, I₃ are the principal moments.",
            "det ({I} − I {1}) = −I³ + p I² − q I + det {I}",
        ),
        remark(
            "Insert each root for I in the three equations, and solve them for ω: this is the direction of its axis. \
             The magnitude of ω stays undetermined.",
        ),
        part("Orthogonal axes"),
        shown("The tensor is symmetric, so for any a and b", "~b · ({I} · ~a) = ~a · ({I} · ~b)"),
        given(Hypothesis, "Let a and b be two of the axes:", "{I} · ~a = I_1 ~a, {I} · ~b = I_2 ~b"),
        given(
            Hypothesis,
            "Insert this on both sides. If the moments differ, a and b are perpendicular:",
            "I_1 (~a · ~b) = I_2 (~a · ~b)",
        ),
        remark(
            "If two moments are equal, each direction in the plane of their axes is a principal axis, and two \
             perpendicular ones may be chosen.",
        ),
        given(
            Definition,
            "Conversely, take the unit vectors along the rows of a rotation R as axes of the moments I_k. \
             Along the given axes the tensor is",
            "I_ij = Σ_k I_k R_ki R_kj, ~a = Σ_i R_1i x̂_i, ~b = Σ_i R_2i x̂_i",
        ),
        shown("and it has these axes and moments:", "{I} · ~a = I_1 ~a, {I} · ~b = I_2 ~b, ~a · ~b = 0"),
        shown(
            "Along its principal axes it is diagonal:",
            "{R} {I} {R}^T = {I_1, 0, 0; 0, I_2, 0; 0, 0, I_3}",
        ),
    ],
};

pub(super) const CUBE_AXES: Derivation = Derivation {
    name: "cube-axes",
    title: "Principal axes of a cube about its corner (example 11.5)",
    steps: &[
        part("Principal moments"),
        given(
            Definition,
            "The tensor of the cube about its corner is (cube)",
            "{I} = M b² {2/3, −1/4, −1/4; −1/4, 2/3, −1/4; −1/4, −1/4, 2/3}",
        ),
        given(Definition, "Take M b² out of all elements:", "I = λ M b²"),
        given(
            Definition,
            "The determinant without it is",
            "D = |2/3 − λ, −1/4, −1/4; −1/4, 2/3 − λ, −1/4; −1/4, −1/4, 2/3 − λ|",
        ),
        shown("so that the characteristic equation is D = 0:", "det ({I} − I {1}) = (M b²)³ D"),
        shown(
            "Expand it along the first row, and factor it:",
            "D = (2/3 − λ) [(2/3 − λ)² − 1/16] + 1/4 [−1/4 (2/3 − λ) − 1/16] − 1/4 [1/16 + 1/4 (2/3 − λ)]\n\
             = (1/6 − λ) (11/12 − λ)²",
        ),
        part("First axis"),
        shown(
            "For the root λ = 1/6 the three equations have the solution ω₁ = ω₂ = ω₃, the diagonal from the corner:",
            "{I} · (x̂ + ŷ + ẑ) = 1/6 M b² (x̂ + ŷ + ẑ)",
        ),
        part("The other two"),
        shown(
            "For the double root λ = 11/12 all three equations are ω₁ + ω₂ + ω₃ = 0. Each direction perpendicular to \
             the diagonal is a principal axis; two perpendicular ones are",
            "{I} · (x̂ − ŷ) = 11/12 M b² (x̂ − ŷ), {I} · (x̂ + ŷ − 2 ẑ) = 11/12 M b² (x̂ + ŷ − 2 ẑ)",
        ),
        shown(
            "The three are right-handed in this order. The notes name the second axis ω₁, and their third axis \
             −x̂ − ŷ + 2 ẑ makes the system left-handed.",
            "(x̂ + ŷ + ẑ) × (x̂ − ŷ) = x̂ + ŷ − 2 ẑ",
        ),
        given(Definition, "The principal moments are", "I_1 = 1/6 M b², I_2 = 11/12 M b², I_3 = 11/12 M b²"),
        result(
            "They have the trace and the determinant of the tensor:",
            "I_1 + I_2 + I_3 = I_11 + I_22 + I_33, I_1 I_2 I_3 = det {I}",
        ),
    ],
};
