//! Inertia tensors from their definition.

use super::super::topic::{Form, Mistake, Question, Step, Topic, Wrong, computed, drawn, hidden, signed};
use super::TENSOR;

const S_XX: &str = "m_1*x_1^2 + m_2*x_2^2 + m_3*x_3^2";
const S_YY: &str = "m_1*y_1^2 + m_2*y_2^2 + m_3*y_3^2";
const S_ZZ: &str = "m_1*z_1^2 + m_2*z_2^2 + m_3*z_3^2";
const S_ALL: &str = "m_1*(x_1^2 + y_1^2 + z_1^2) + m_2*(x_2^2 + y_2^2 + z_2^2) + m_3*(x_3^2 + y_3^2 + z_3^2)";
const P_XY: &str = "-m_1*x_1*y_1 - m_2*x_2*y_2 - m_3*x_3*y_3";
const P_XZ: &str = "-m_1*x_1*z_1 - m_2*x_2*z_2 - m_3*x_3*z_3";
const P_YZ: &str = "-m_1*y_1*z_1 - m_2*y_2*z_2 - m_3*y_3*z_3";

pub(super) const TOPICS: [Topic; 4] = [
    Topic {
        name: "tensor-of-particles",
        title: "Inertia tensor of particles",
        text: "A rigid body consists of three particles with the masses m₁, m₂ and m₃ at the positions (x₁, y₁, z₁), \
               (x₂, y₂, z₂) and (x₃, y₃, z₃), joined by massless rods. Find its inertia tensor about the origin.",
        data: &[&[
            drawn("m_1", "kg", 11, 59, 1),
            drawn("m_2", "kg", 11, 59, 1),
            drawn("m_3", "kg", 11, 59, 1),
            signed("x_1", "cm", 12, 95, 0),
            signed("y_1", "cm", 12, 95, 0),
            signed("z_1", "cm", 12, 95, 0),
            signed("x_2", "cm", 12, 95, 0),
            signed("y_2", "cm", 12, 95, 0),
            signed("z_2", "cm", 12, 95, 0),
            signed("x_3", "cm", 12, 95, 0),
            signed("y_3", "cm", 12, 95, 0),
            signed("z_3", "cm", 12, 95, 0),
        ]],
        rules: &[],
        steps: &[
            Step::Say("The tensor is a sum over the particles, Iij = Σ m (δij r² − xi xj)."),
            Step::Say(
                "A moment of inertia has the squared distance from its axis: r² − x² = y² + z². A product of inertia has a minus sign.",
            ),
        ],
        questions: &[Question {
            name: "I",
            is: "inertia tensor about the origin",
            unit: "kg m^2",
            form: Form::Plain,
            right: &[
                "m_1*(y_1^2 + z_1^2) + m_2*(y_2^2 + z_2^2) + m_3*(y_3^2 + z_3^2)",
                "m_1*(x_1^2 + z_1^2) + m_2*(x_2^2 + z_2^2) + m_3*(x_3^2 + z_3^2)",
                "m_1*(x_1^2 + y_1^2) + m_2*(x_2^2 + y_2^2) + m_3*(x_3^2 + y_3^2)",
                P_XY,
                P_XZ,
                P_YZ,
            ],
            mistakes: &[
                Mistake(
                    Wrong::Products,
                    "the sign of the products of inertia is reversed: they are −Σ m x y",
                ),
                Mistake(
                    Wrong::Is(&[S_XX, S_YY, S_ZZ, P_XY, P_XZ, P_YZ]),
                    "the moments contain the coordinate along their own axis: I_xx is Σ m (y² + z²), not Σ m x²",
                ),
                Mistake(
                    Wrong::Is(&[S_ALL, S_ALL, S_ALL, P_XY, P_XZ, P_YZ]),
                    "the moments contain r²: subtract the square of the coordinate along their axis",
                ),
                Mistake(
                    Wrong::With(&[
                        ("m_1", "(m_1 + m_2 + m_3)/3"),
                        ("m_2", "(m_1 + m_2 + m_3)/3"),
                        ("m_3", "(m_1 + m_2 + m_3)/3"),
                    ]),
                    "each particle has its own mass, not the mean of all",
                ),
            ],
        }],
    },
    Topic {
        name: "box-about-corner",
        title: "Inertia tensor of a box about its corner",
        text: "A homogeneous box of mass M has the edges a, b and c along the axes x, y and z. It occupies 0 ≤ x ≤ a, \
               0 ≤ y ≤ b, 0 ≤ z ≤ c. Find its inertia tensor about the corner at the origin.",
        data: &[&[
            drawn("M", "kg", 12, 89, 1),
            drawn("a", "cm", 12, 69, 0),
            drawn("b", "cm", 12, 69, 0),
            drawn("c", "cm", 12, 69, 0),
        ]],
        rules: &["(a - b)^2/a^2 - 1/100", "(b - c)^2/b^2 - 1/100", "(c - a)^2/c^2 - 1/100"],
        steps: &[
            Step::Say("Iij = ∫ ρ (δij r² − xi xj) dV with ρ = M/(a b c)."),
            Step::Say(
                "∫ y² dy = b³/3 gives the terms of a moment. ∫ x dx ∫ y dy = a² b²/4 gives a product, with a minus sign.",
            ),
        ],
        questions: &[Question {
            name: "I",
            is: "inertia tensor about the corner",
            unit: "kg m^2",
            form: Form::Plain,
            right: &[
                "M*(b^2 + c^2)/3",
                "M*(a^2 + c^2)/3",
                "M*(a^2 + b^2)/3",
                "-M*a*b/4",
                "-M*a*c/4",
                "-M*b*c/4",
            ],
            mistakes: &[
                Mistake(
                    Wrong::Products,
                    "the sign of the products of inertia is reversed: they are −∫ x y dm",
                ),
                Mistake(
                    Wrong::Is(&["M*(b^2 + c^2)/12", "M*(a^2 + c^2)/12", "M*(a^2 + b^2)/12", "0", "0", "0"]),
                    "this is the tensor about the centre of mass: the shift to the corner is missing",
                ),
                Mistake(
                    Wrong::Is(&[
                        "-M*(b^2 + c^2)/6",
                        "-M*(a^2 + c^2)/6",
                        "-M*(a^2 + b^2)/6",
                        "M*a*b/4",
                        "M*a*c/4",
                        "M*b*c/4",
                    ]),
                    "the shift from the centre of mass is subtracted: about any other point it is added",
                ),
                Mistake(
                    Wrong::Is(&[
                        "M*(b^2 + c^2)*13/12",
                        "M*(a^2 + c^2)*13/12",
                        "M*(a^2 + b^2)*13/12",
                        "-M*a*b",
                        "-M*a*c",
                        "-M*b*c",
                    ]),
                    "the shift uses the whole edges: the centre of mass is half an edge from the corner",
                ),
                Mistake(
                    Wrong::Is(&["M*a^2/3", "M*b^2/3", "M*c^2/3", "-M*a*b/4", "-M*a*c/4", "-M*b*c/4"]),
                    "the moments contain the edge along their own axis: I_xx has b and c",
                ),
            ],
        }],
    },
    Topic {
        name: "sign-of-products",
        title: "Sign of the products of inertia",
        text: "A CAD program reports the moments I_xx, I_yy and I_zz of a body, and P_xy = +∫ x y dm, P_xz = +∫ x z dm, \
               P_yz = +∫ y z dm. The body rotates with the angular velocity ω = (ω_x, ω_y, ω_z). Find its angular momentum \
               about the origin.",
        data: &[&[
            hidden("p", 21, 59, 2),
            hidden("q", 21, 59, 2),
            hidden("r", 21, 59, 2),
            computed("I_xx", "kg m^2", "q + r"),
            computed("I_yy", "kg m^2", "p + r"),
            computed("I_zz", "kg m^2", "p + q"),
            signed("P_xy", "kg m^2", 31, 99, 3),
            signed("P_xz", "kg m^2", 31, 99, 3),
            signed("P_yz", "kg m^2", 31, 99, 3),
            signed("omega_x", "rad/s", 12, 59, 1),
            signed("omega_y", "rad/s", 12, 59, 1),
            signed("omega_z", "rad/s", 12, 59, 1),
        ]],
        rules: &[],
        steps: &[
            Step::Say(
                "The products of inertia of the tensor are I_xy = −∫ x y dm = −P_xy, and likewise for xz and yz.",
            ),
            Step::Say("L = {I} ω, row by row."),
        ],
        questions: &[Question {
            name: "L",
            is: "angular momentum about the origin",
            unit: "kg m^2/s",
            form: Form::Plain,
            right: &[
                "I_xx*omega_x - P_xy*omega_y - P_xz*omega_z",
                "I_yy*omega_y - P_xy*omega_x - P_yz*omega_z",
                "I_zz*omega_z - P_xz*omega_x - P_yz*omega_y",
            ],
            mistakes: &[
                Mistake(
                    Wrong::With(&[("P_xy", "-P_xy"), ("P_xz", "-P_xz"), ("P_yz", "-P_yz")]),
                    "this is the value with the sign of the products reversed: the tensor has −∫ x y dm",
                ),
                Mistake(
                    Wrong::With(&[("P_xy", "0"), ("P_xz", "0"), ("P_yz", "0")]),
                    "the products of inertia are missing: L is parallel to ω only along a principal axis",
                ),
                Mistake(
                    Wrong::With(&[("P_xy", "P_yz"), ("P_yz", "P_xy")]),
                    "the products P_xy and P_yz are interchanged",
                ),
            ],
        }],
    },
    Topic {
        name: "moment-about-axis",
        title: "Moment of inertia about an inclined axis",
        text: "The inertia tensor of a body about the origin has the elements I_xx, I_yy, I_zz, I_xy, I_xz and I_yz. Find the \
               moment of inertia about the axis through the origin that has the direction (u, v, w), which is not a unit vector.",
        data: &[
            &TENSOR,
            &[signed("u", "", 11, 49, 1), signed("v", "", 11, 49, 1), signed("w", "", 11, 49, 1)],
        ],
        rules: &[],
        steps: &[
            Step::Say(
                "Along the unit vector n the moment of inertia is n · {I} · n, with n = (u, v, w)/√(u² + v² + w²).",
            ),
            Step::Say("Each product of inertia occurs twice, because the tensor is symmetric."),
        ],
        questions: &[Question {
            name: "I_axis",
            is: "moment of inertia about the axis",
            unit: "kg m^2",
            form: Form::Plain,
            right: &[
                "(u^2*I_xx + v^2*I_yy + w^2*I_zz + 2*u*v*I_xy + 2*u*w*I_xz + 2*v*w*I_yz)/(u^2 + v^2 + w^2)",
            ],
            mistakes: &[
                Mistake(
                    Wrong::Times("u^2 + v^2 + w^2"),
                    "the direction is not normalized: divide by u² + v² + w²",
                ),
                Mistake(
                    Wrong::With(&[("I_xy", "-I_xy"), ("I_xz", "-I_xz"), ("I_yz", "-I_yz")]),
                    "this is the value with the sign of the products reversed",
                ),
                Mistake(
                    Wrong::With(&[("I_xy", "0"), ("I_xz", "0"), ("I_yz", "0")]),
                    "the products of inertia are missing",
                ),
                Mistake(
                    Wrong::With(&[("I_xy", "I_xy/2"), ("I_xz", "I_xz/2"), ("I_yz", "I_yz/2")]),
                    "each product of inertia counts twice: I_xy and I_yx",
                ),
            ],
        }],
    },
];
