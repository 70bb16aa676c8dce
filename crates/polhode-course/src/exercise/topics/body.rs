//! Composite and rotated bodies.

use super::super::topic::{Form, Mistake, Question, Step, Topic, Wrong, drawn, signed, triple};
use super::MOMENTS;

pub(super) const TOPICS: [Topic; 3] = [
    Topic {
        name: "composite-body",
        title: "Inertia tensor of a box with a ball",
        text: "A homogeneous box of mass m₁ with the edges a, b and c along x, y and z has its centre at the origin. A \
               homogeneous ball of mass m₂ and diameter D is fixed with its centre at (x, y, z). Find the inertia tensor of \
               both about the origin.",
        data: &[&[
            drawn("m_1", "kg", 21, 89, 1),
            drawn("m_2", "kg", 11, 39, 1),
            drawn("a", "cm", 21, 69, 0),
            drawn("b", "cm", 21, 69, 0),
            drawn("c", "cm", 21, 69, 0),
            drawn("D", "cm", 31, 59, 0),
            signed("x", "cm", 15, 55, 0),
            signed("y", "cm", 15, 55, 0),
            signed("z", "cm", 15, 55, 0),
        ]],
        rules: &[],
        steps: &[
            Step::Say(
                "Tensors about the same point are added. The box has M (b² + c²)/12 and no products about its centre.",
            ),
            Step::Say(
                "The ball has 2/5 m₂ (D/2)² = m₂ D²/10 about its centre, and the shift m₂ (d² δij − di dj) to the origin.",
            ),
        ],
        questions: &[Question {
            name: "I",
            is: "inertia tensor of both about the origin",
            unit: "kg m^2",
            form: Form::Plain,
            right: &[
                "m_1*(b^2 + c^2)/12 + m_2*D^2/10 + m_2*(y^2 + z^2)",
                "m_1*(a^2 + c^2)/12 + m_2*D^2/10 + m_2*(x^2 + z^2)",
                "m_1*(a^2 + b^2)/12 + m_2*D^2/10 + m_2*(x^2 + y^2)",
                "-m_2*x*y",
                "-m_2*x*z",
                "-m_2*y*z",
            ],
            mistakes: &[
                Mistake(Wrong::Products, "the sign of the products of inertia is reversed"),
                Mistake(
                    Wrong::With(&[("x", "0"), ("y", "0"), ("z", "0")]),
                    "the shift of the ball to the origin is missing",
                ),
                Mistake(Wrong::With(&[("D", "2*D")]), "the diameter of the ball is taken for its radius"),
                Mistake(
                    Wrong::With(&[("D", "0")]),
                    "the ball is treated as a particle: its own 2/5 m r² is missing",
                ),
                Mistake(
                    Wrong::With(&[("a", "2*a"), ("b", "2*b"), ("c", "2*c")]),
                    "the box has M (b² + c²)/12 about its centre; M/3 belongs to an edge",
                ),
            ],
        }],
    },
    Topic {
        name: "rod-with-disk",
        title: "Pendulum of a rod and a disk",
        text: "A uniform thin rod of mass m and length l carries a uniform disk of mass M and diameter D. The centre of the disk \
               is at the end of the rod, and its plane contains the rod. Find the moment of inertia about the axis through the \
               other end of the rod, perpendicular to the disk, and the distance of the centre of mass from this axis.",
        data: &[&[
            drawn("m", "g", 120, 390, 0),
            drawn("M", "g", 210, 890, 0),
            drawn("l", "cm", 31, 69, 0),
            drawn("D", "cm", 31, 59, 0),
        ]],
        rules: &[],
        steps: &[
            Step::Say(
                "A rod has m l²/3 about its end. A disk has M (D/2)²/2 = M D²/8 about its own axis, and the shift M l².",
            ),
            Step::Say("The centre of mass is the mean of l/2 and l with the masses as weights."),
        ],
        questions: &[
            Question {
                name: "I",
                is: "moment of inertia about the axis",
                unit: "kg m^2",
                form: Form::Plain,
                right: &["m*l^2/3 + M*D^2/8 + M*l^2"],
                mistakes: &[
                    Mistake(
                        Wrong::Is(&["m*l^2/3 + M*D^2/8"]),
                        "the shift of the disk to the axis is missing",
                    ),
                    Mistake(Wrong::Is(&["m*l^2/3 + M*D^2/8 - M*l^2"]), "the shift of the disk is subtracted"),
                    Mistake(
                        Wrong::Is(&["m*l^2/12 + M*D^2/8 + M*l^2"]),
                        "the rod has m l²/12 only about its centre",
                    ),
                    Mistake(Wrong::With(&[("D", "2*D")]), "the diameter of the disk is taken for its radius"),
                    Mistake(
                        Wrong::Is(&["m*l^2/3 + M*D^2/16 + M*l^2"]),
                        "M r²/4 is the moment of a disk about its diameter",
                    ),
                ],
            },
            Question {
                name: "d",
                is: "distance of the centre of mass from the axis",
                unit: "m",
                form: Form::Plain,
                right: &["(m/2 + M)*l/(m + M)"],
                mistakes: &[
                    Mistake(Wrong::Is(&["l*3/4"]), "the mean of the two centres needs the masses as weights"),
                    Mistake(Wrong::Is(&["(m + M/2)*l/(m + M)"]), "the masses are interchanged"),
                    Mistake(Wrong::Is(&["l"]), "the mass of the rod at l/2 is missing"),
                ],
            },
        ],
    },
    Topic {
        name: "rotated-body",
        title: "Inertia tensor of a rotated body",
        text: "A body has the principal moments I₁, I₂ and I₃ about its axes 1, 2 and 3. These axes result from x, y and z by a \
               rotation by the angle φ about z, from x towards y. Find the elements I_xx, I_yy and I_xy of its tensor.",
        data: &[&MOMENTS, &[triple("phi")]],
        rules: &["(I_1 - I_2)^2/(I_1 + I_2)^2 - 1/50"],
        steps: &[
            Step::Say(
                "The tensor along x, y, z is {I} = R diag(I₁, I₂, I₃) Rᵀ. The columns of R are the axes 1, 2, 3 = (cos φ, sin φ, 0), (−sin φ, cos φ, 0), (0, 0, 1).",
            ),
            Step::Say("Check: the trace I_xx + I_yy = I₁ + I₂ is conserved."),
        ],
        questions: &[
            Question {
                name: "I_xx",
                is: "moment of inertia about x",
                unit: "kg m^2",
                form: Form::Plain,
                right: &["I_1*cos(phi)^2 + I_2*sin(phi)^2"],
                mistakes: &[
                    Mistake(
                        Wrong::Is(&["I_1*sin(phi)^2 + I_2*cos(phi)^2"]),
                        "sine and cosine are interchanged, or the axes x and y",
                    ),
                    Mistake(
                        Wrong::Is(&["I_1*cos(phi) + I_2*sin(phi)"]),
                        "a tensor needs the rotation twice: squares of sine and cosine",
                    ),
                    Mistake(Wrong::Is(&["I_1"]), "this is the moment about the body axis 1"),
                ],
            },
            Question {
                name: "I_yy",
                is: "moment of inertia about y",
                unit: "kg m^2",
                form: Form::Plain,
                right: &["I_1*sin(phi)^2 + I_2*cos(phi)^2"],
                mistakes: &[
                    Mistake(
                        Wrong::Is(&["I_1*cos(phi)^2 + I_2*sin(phi)^2"]),
                        "sine and cosine are interchanged, or the axes x and y",
                    ),
                    Mistake(
                        Wrong::Is(&["I_2*cos(phi) - I_1*sin(phi)"]),
                        "a tensor needs the rotation twice: squares of sine and cosine",
                    ),
                    Mistake(Wrong::Is(&["I_2"]), "this is the moment about the body axis 2"),
                ],
            },
            Question {
                name: "I_xy",
                is: "product of inertia, element xy of the tensor",
                unit: "kg m^2",
                form: Form::Plain,
                right: &["(I_1 - I_2)*sin(phi)*cos(phi)"],
                mistakes: &[
                    Mistake(
                        Wrong::With(&[("phi", "-phi")]),
                        "the sign is reversed: the rotation is transposed, or the sign of the product",
                    ),
                    Mistake(
                        Wrong::Is(&["(I_1 + I_2)*sin(phi)*cos(phi)"]),
                        "axis 2 has the components −sin φ and cos φ: the terms have opposite signs",
                    ),
                    Mistake(
                        Wrong::Is(&["(I_1 - I_2)*2*sin(phi)*cos(phi)"]),
                        "sin φ cos φ is sin 2φ/2: a factor 2 is too much",
                    ),
                ],
            },
        ],
    },
];
