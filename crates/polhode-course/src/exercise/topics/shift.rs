//! Parallel axes.

use super::super::topic::{Form, Mistake, Question, Step, Topic, Wrong, computed, drawn, hidden, signed};
use super::TENSOR;

pub(super) const TOPICS: [Topic; 2] = [
    Topic {
        name: "parallel-axes",
        title: "Parallel-axis theorem for a tensor",
        text: "The inertia tensor of a body of mass M about its centre of mass has the elements I_xx, I_yy, I_zz, I_xy, I_xz \
               and I_yz. The centre of mass is at (d_x, d_y, d_z) from the point O. Find the tensor J about O, along parallel axes.",
        data: &[
            &TENSOR,
            &[
                drawn("M", "kg", 12, 49, 1),
                signed("d_x", "cm", 12, 65, 0),
                signed("d_y", "cm", 12, 65, 0),
                signed("d_z", "cm", 12, 65, 0),
            ],
        ],
        rules: &[],
        steps: &[
            Step::Say("Parallel-axis theorem: Jij = Iij + M (d² δij − di dj)."),
            Step::Say("d² − d_x² = d_y² + d_z² is the squared distance between the parallel x axes."),
        ],
        questions: &[Question {
            name: "J",
            is: "inertia tensor about O",
            unit: "kg m^2",
            form: Form::Plain,
            right: &[
                "I_xx + M*(d_y^2 + d_z^2)",
                "I_yy + M*(d_x^2 + d_z^2)",
                "I_zz + M*(d_x^2 + d_y^2)",
                "I_xy - M*d_x*d_y",
                "I_xz - M*d_x*d_z",
                "I_yz - M*d_y*d_z",
            ],
            mistakes: &[
                Mistake(
                    Wrong::With(&[("M", "-M")]),
                    "the shift is subtracted: the tensor about the centre of mass is the smallest, so the shift from there is added",
                ),
                Mistake(
                    Wrong::With(&[("M", "0")]),
                    "the shift is missing: this is the tensor about the centre of mass",
                ),
                Mistake(
                    Wrong::Is(&[
                        "I_xx + M*(d_y^2 + d_z^2)",
                        "I_yy + M*(d_x^2 + d_z^2)",
                        "I_zz + M*(d_x^2 + d_y^2)",
                        "I_xy + M*d_x*d_y",
                        "I_xz + M*d_x*d_z",
                        "I_yz + M*d_y*d_z",
                    ]),
                    "the sign of the shift of the products is reversed: it is −M di dj",
                ),
                Mistake(
                    Wrong::Is(&[
                        "I_xx + M*(d_y^2 + d_z^2)",
                        "I_yy + M*(d_x^2 + d_z^2)",
                        "I_zz + M*(d_x^2 + d_y^2)",
                        "I_xy",
                        "I_xz",
                        "I_yz",
                    ]),
                    "the products of inertia are not shifted: they change by −M di dj",
                ),
                Mistake(
                    Wrong::Is(&[
                        "I_xx + M*(d_x^2 + d_y^2 + d_z^2)",
                        "I_yy + M*(d_x^2 + d_y^2 + d_z^2)",
                        "I_zz + M*(d_x^2 + d_y^2 + d_z^2)",
                        "I_xy - M*d_x*d_y",
                        "I_xz - M*d_x*d_z",
                        "I_yz - M*d_y*d_z",
                    ]),
                    "the moments are shifted by M d²: only the distance between the parallel axes counts",
                ),
                Mistake(Wrong::Products, "the sign of the products of inertia is reversed"),
            ],
        }],
    },
    Topic {
        name: "parallel-axes-twice",
        title: "From one axis to another parallel axis",
        text: "The moment of inertia of a body of mass M about the axis A is I_A. The centre of mass is at the distance d_A from \
               A and d_B from B; both axes are parallel. Find the moments of inertia about the axis through the centre of mass \
               and about B.",
        data: &[&[
            hidden("p", 12, 89, 2),
            drawn("M", "kg", 12, 59, 1),
            drawn("d_A", "cm", 21, 69, 0),
            drawn("d_B", "cm", 21, 69, 0),
            computed("I_A", "kg m^2", "p + M*d_A^2"),
        ]],
        rules: &["(d_A - d_B)^2/d_A^2 - 1/50", "p - M*d_A^2/10"],
        steps: &[
            Step::Say("The theorem leads only from and to the centre of mass: I_A = I_C + M d_A²."),
            Step::Say("So go to the centre of mass first, and then to B: I_B = I_C + M d_B²."),
        ],
        questions: &[
            Question {
                name: "I_C",
                is: "moment of inertia about the parallel axis through the centre of mass",
                unit: "kg m^2",
                form: Form::Plain,
                right: &["I_A - M*d_A^2"],
                mistakes: &[
                    Mistake(
                        Wrong::With(&[("M", "-M")]),
                        "the shift is added: towards the centre of mass it is subtracted",
                    ),
                    Mistake(Wrong::With(&[("d_A", "d_B")]), "the shift has the distance of the other axis"),
                    Mistake(Wrong::With(&[("M", "0")]), "the shift is missing"),
                ],
            },
            Question {
                name: "I_B",
                is: "moment of inertia about B",
                unit: "kg m^2",
                form: Form::Plain,
                right: &["I_A - M*d_A^2 + M*d_B^2"],
                mistakes: &[
                    Mistake(
                        Wrong::Is(&["I_A + M*d_A^2 - M*d_B^2"]),
                        "the shift is in the wrong direction: subtract M d_A² and add M d_B²",
                    ),
                    Mistake(
                        Wrong::Is(&["I_A + M*d_B^2"]),
                        "the theorem does not start at A: subtract M d_A² first",
                    ),
                    Mistake(
                        Wrong::Is(&["I_A + M*(d_A - d_B)^2"]),
                        "the distance between A and B is used: the theorem needs the distances from the centre of mass",
                    ),
                    Mistake(
                        Wrong::Is(&["I_A + M*(d_A + d_B)^2"]),
                        "the distance between A and B is used: the theorem needs the distances from the centre of mass",
                    ),
                    Mistake(Wrong::With(&[("M", "0")]), "the shifts are missing"),
                ],
            },
        ],
    },
];
