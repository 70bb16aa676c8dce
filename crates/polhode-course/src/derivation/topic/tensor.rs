//! Inertia tensor.

use crate::derivation::Derivation;
use crate::derivation::step::Ground::{Definition, Limit};
use crate::derivation::step::{given, part, remark, result, shown};

pub(super) const INERTIA_TENSOR: Derivation = Derivation {
    name: "inertia-tensor",
    title: "Inertia tensor from the energy of rotation",
    steps: &[
        part("Square of a vector product"),
        given(
            Definition,
            "Start from the energy of rotation (kinetic-energy):",
            "T_rot = 1/2 Σ_α m_α (~ω × ~r_α)²",
        ),
        shown(
            "If θ is the angle between A and B, the vector product has the magnitude A B sin θ, and",
            "A² B² sin² θ = A² B² − (A B cos θ)²",
        ),
        shown("Here A B cos θ is the scalar product:", "(~A × ~B)² = ~A² ~B² − (~A · ~B)²"),
        shown("Hence", "T_rot = 1/2 Σ_α m_α [~ω² ~r_α² − (~ω · ~r_α)²]"),
        part("Components"),
        given(
            Definition,
            "Use components along the body axes. The notes write x, y, z also as 1, 2, 3.",
            "~ω = Σ_i ω_i x̂_i, ~r_α = Σ_i x_αi x̂_i",
        ),
        shown(
            "The axes are perpendicular unit vectors, so",
            "~ω² = Σ_i ω_i², ~r_α² = Σ_k x_αk², ~ω · ~r_α = Σ_i ω_i x_αi",
        ),
        shown(
            "The second square is a product of two sums, which need two indices i and j:",
            "T_rot = 1/2 Σ_α m_α [(Σ_i ω_i²) (Σ_k x_αk²) − (Σ_i ω_i x_αi) (Σ_j ω_j x_αj)]",
        ),
        shown(
            "Such a product is a double sum. The notes print b_i in it; the second factor has the index j.",
            "(Σ_i a_i) (Σ_j b_j) = Σ_ij a_i b_j",
        ),
        shown(
            "With δ_ij = 1 for i = j and 0 for i ≠ j, the first product is a double sum too:",
            "ω_i = Σ_j ω_j δ_ij, ω_i² = Σ_j ω_i ω_j δ_ij",
        ),
        shown(
            "Collect the factors of ω_i ω_j, and sum over the particles first:",
            "T_rot = 1/2 Σ_α m_α [Σ_ij ω_i ω_j δ_ij Σ_k x_αk² − Σ_ij ω_i ω_j x_αi x_αj]\n\
             = 1/2 Σ_α m_α Σ_ij ω_i ω_j [δ_ij Σ_k x_αk² − x_αi x_αj]\n\
             = 1/2 Σ_ij ω_i ω_j Σ_α m_α [δ_ij Σ_k x_αk² − x_αi x_αj]",
        ),
        given(
            Definition,
            "The sum over the particles depends on the body only. It is the inertia tensor, in kg m²:",
            "I_ij ≡ Σ_α m_α [δ_ij Σ_k x_αk² − x_αi x_αj]",
        ),
        result("The energy of rotation is", "T_rot = 1/2 Σ_ij I_ij ω_i ω_j"),
        part("Elements"),
        given(Definition, "Write the coordinates without indices,", "x_α = x_α1, y_α = x_α2, z_α = x_α3"),
        shown(
            "with i as the row and j as the column. The diagonal elements are the moments of inertia, the \
             others the products of inertia.",
            "{I} = {Σ_α m_α (y_α² + z_α²), −Σ_α m_α x_α y_α, −Σ_α m_α x_α z_α; \
             −Σ_α m_α y_α x_α, Σ_α m_α (x_α² + z_α²), −Σ_α m_α y_α z_α; \
             −Σ_α m_α z_α x_α, −Σ_α m_α z_α y_α, Σ_α m_α (x_α² + y_α²)}",
        ),
        shown("The tensor is symmetric:", "I_ij = I_ji"),
        given(
            Limit,
            "In a continuous body of density ρ the particle is an element of mass ρ dV, and the sum an integral:",
            "I_ij = ∫_V ρ [δ_ij Σ_k x_k² − x_i x_j] dV",
        ),
    ],
};

pub(super) const CUBE: Derivation = Derivation {
    name: "cube",
    title: "Inertia tensor of a cube about its corner (example 11.3)",
    steps: &[
        part("Integrals"),
        remark("A cube of mass M and width b has its corner at the origin and its edges along the axes."),
        given(Definition, "Its density is uniform:", "ρ = M/b³"),
        given(
            Definition,
            "The tensor is the integral over the volume (inertia-tensor), with",
            "x_1 = x, x_2 = y, x_3 = z\n\
             I_ij = ρ ∫_0^b dx ∫_0^b dy ∫_0^b dz (δ_ij Σ_k x_k² − x_i x_j)",
        ),
        part("Elements"),
        shown(
            "A diagonal element:",
            "I_11 = ρ ∫_0^b dx ∫_0^b dy ∫_0^b dz (x² + y² + z² − x²)\n\
             = ρ b ∫_0^b dy (b y² + 1/3 b³)\n\
             = ρ b (1/3 b⁴ + 1/3 b⁴)\n\
             = 2/3 ρ b⁵ = 2/3 M b²",
        ),
        shown(
            "An element off the diagonal:",
            "I_12 = −ρ ∫_0^b dx ∫_0^b dy ∫_0^b dz x y\n\
             = −ρ (1/2 b²) (1/2 b²) b = −1/4 ρ b⁵ = −1/4 M b²",
        ),
        shown("The others are the same by symmetry:", "I_11 = I_22 = I_33, I_12 = I_13 = I_23"),
        result("In short,", "I_11 = 2/3 M b², I_12 = −1/4 M b²"),
        shown("The tensor is", "{I} = M b² {2/3, −1/4, −1/4; −1/4, 2/3, −1/4; −1/4, −1/4, 2/3}"),
    ],
};
