//! Euler's equations, and the dumbbell on a slanted axis.

use super::super::topic::{Form, Mistake, Question, Step, Topic, Wrong, drawn, signed};
use super::MOMENTS;

const RADIANS: &str = "the sine and cosine of degrees are taken as those of radians";
const RPM: &str = "rpm is taken for rad/s: 1 rpm = 2π/60 rad/s";
const HERTZ: &str = "revolutions per second are taken for rad/s: ω = 2π n";

pub(super) const TOPICS: [Topic; 4] = [
    Topic {
        name: "euler-acceleration",
        title: "Euler's equations: ω̇ from the torque",
        text: "A body has the principal moments I₁, I₂ and I₃. At one instant its angular velocity is (ω₁, ω₂, ω₃) and the torque \
               is (N₁, N₂, N₃), both along the principal axes. Find ω̇ along these axes.",
        data: &[
            &MOMENTS,
            &[
                signed("omega_1", "rad/s", 12, 59, 1),
                signed("omega_2", "rad/s", 12, 59, 1),
                signed("omega_3", "rad/s", 12, 59, 1),
                signed("N_1", "N m", 12, 59, 1),
                signed("N_2", "N m", 12, 59, 1),
                signed("N_3", "N m", 12, 59, 1),
            ],
        ],
        rules: &[],
        steps: &[
            Step::Say(
                "Euler's equation for axis 1 is N₁ = I₁ ω̇₁ − (I₂ − I₃) ω₂ ω₃. The others follow by cyclic permutation.",
            ),
            Step::Say("Solve each for ω̇."),
        ],
        questions: &[Question {
            name: "omega_dot",
            is: "ω̇ along the principal axes",
            unit: "rad/s^2",
            form: Form::Plain,
            right: &[
                "(N_1 + (I_2 - I_3)*omega_2*omega_3)/I_1",
                "(N_2 + (I_3 - I_1)*omega_3*omega_1)/I_2",
                "(N_3 + (I_1 - I_2)*omega_1*omega_2)/I_3",
            ],
            mistakes: &[
                Mistake(
                    Wrong::With(&[("N_1", "-N_1"), ("N_2", "-N_2"), ("N_3", "-N_3")]),
                    "the sign of the torque is reversed",
                ),
                Mistake(
                    Wrong::Is(&[
                        "(N_1 - (I_2 - I_3)*omega_2*omega_3)/I_1",
                        "(N_2 - (I_3 - I_1)*omega_3*omega_1)/I_2",
                        "(N_3 - (I_1 - I_2)*omega_1*omega_2)/I_3",
                    ]),
                    "the sign of the term ω × L is reversed",
                ),
                Mistake(
                    Wrong::Is(&["N_1/I_1", "N_2/I_2", "N_3/I_3"]),
                    "the term ω × L is missing: the axes rotate with the body",
                ),
                Mistake(Wrong::With(&[("N_1", "0"), ("N_2", "0"), ("N_3", "0")]), "the torque is missing"),
                Mistake(
                    Wrong::Is(&[
                        "(N_1 + (I_3 - I_1)*omega_2*omega_3)/I_1",
                        "(N_2 + (I_1 - I_2)*omega_3*omega_1)/I_2",
                        "(N_3 + (I_2 - I_3)*omega_1*omega_2)/I_3",
                    ]),
                    "the moments belong to other axes: axis 1 has I₂ − I₃",
                ),
            ],
        }],
    },
    Topic {
        name: "euler-torque",
        title: "Euler's equations: the torque from ω̇",
        text: "A body has the principal moments I₁, I₂ and I₃. At one instant its angular velocity is (ω₁, ω₂, ω₃) and the rates \
               of its components are (α₁, α₂, α₃), along the principal axes. Find the torque along these axes.",
        data: &[
            &MOMENTS,
            &[
                signed("omega_1", "rad/s", 12, 59, 1),
                signed("omega_2", "rad/s", 12, 59, 1),
                signed("omega_3", "rad/s", 12, 59, 1),
                signed("alpha_1", "rad/s^2", 12, 59, 1),
                signed("alpha_2", "rad/s^2", 12, 59, 1),
                signed("alpha_3", "rad/s^2", 12, 59, 1),
            ],
        ],
        rules: &[],
        steps: &[Step::Say("N₁ = I₁ ω̇₁ − (I₂ − I₃) ω₂ ω₃, and cyclic permutations, with ω̇ = (α₁, α₂, α₃).")],
        questions: &[Question {
            name: "N",
            is: "torque along the principal axes",
            unit: "N m",
            form: Form::Plain,
            right: &[
                "I_1*alpha_1 - (I_2 - I_3)*omega_2*omega_3",
                "I_2*alpha_2 - (I_3 - I_1)*omega_3*omega_1",
                "I_3*alpha_3 - (I_1 - I_2)*omega_1*omega_2",
            ],
            mistakes: &[
                Mistake(
                    Wrong::Is(&[
                        "I_1*alpha_1 + (I_2 - I_3)*omega_2*omega_3",
                        "I_2*alpha_2 + (I_3 - I_1)*omega_3*omega_1",
                        "I_3*alpha_3 + (I_1 - I_2)*omega_1*omega_2",
                    ]),
                    "the sign of the term ω × L is reversed",
                ),
                Mistake(
                    Wrong::Is(&["I_1*alpha_1", "I_2*alpha_2", "I_3*alpha_3"]),
                    "the term ω × L is missing: the axes rotate with the body",
                ),
                Mistake(
                    Wrong::With(&[("alpha_1", "0"), ("alpha_2", "0"), ("alpha_3", "0")]),
                    "the term I ω̇ is missing",
                ),
                Mistake(
                    Wrong::Is(&[
                        "I_1*alpha_1 - (I_3 - I_1)*omega_2*omega_3",
                        "I_2*alpha_2 - (I_1 - I_2)*omega_3*omega_1",
                        "I_3*alpha_3 - (I_2 - I_3)*omega_1*omega_2",
                    ]),
                    "the moments belong to other axes: axis 1 has I₂ − I₃",
                ),
            ],
        }],
    },
    Topic {
        name: "dumbbell-torque",
        title: "Torque on a slanted dumbbell",
        text: "The masses m₁ and m₂ are at the ends of a massless rod, each at the distance b from the point O on the rod. The rod \
               rotates with the constant speed ω about an axis through O, inclined by α to the rod. Body axes: z along the rod, ω in \
               the plane of y and z, ω = (0, ω sin α, ω cos α). Find the component N_x of the torque that maintains this motion.",
        data: &[&[
            drawn("m_1", "kg", 11, 59, 1),
            drawn("m_2", "kg", 11, 59, 1),
            drawn("b", "cm", 12, 69, 0),
            drawn("omega", "rpm", 31, 189, 0),
            drawn("alpha", "deg", 21, 69, 0),
        ]],
        rules: &["(sin(alpha) - cos(alpha))^2 - 1/100"],
        steps: &[
            Step::Say(
                "Principal moments: I₁ = I₂ = (m₁ + m₂) b² and I₃ = 0, because both masses are on the z axis.",
            ),
            Step::Say("With ω̇ = 0 Euler's first equation is N_x = −(I₂ − I₃) ω₂ ω₃."),
        ],
        questions: &[Question {
            name: "N_x",
            is: "torque along x",
            unit: "N m",
            form: Form::Plain,
            right: &["-(m_1 + m_2)*b^2*omega^2*sin(alpha)*cos(alpha)"],
            mistakes: &[
                Mistake(Wrong::Times("-1"), "the sign is reversed: N₁ = −(I₂ − I₃) ω₂ ω₃"),
                Mistake(Wrong::With(&[("alpha", "alpha*180/π")]), RADIANS),
                Mistake(Wrong::With(&[("omega", "omega*30/π")]), RPM),
                Mistake(Wrong::With(&[("omega", "omega/(2*π)")]), HERTZ),
                Mistake(Wrong::Is(&["-(m_1 + m_2)*b^2*omega^2*sin(alpha)^2"]), "ω₃ is ω cos α, not ω sin α"),
                Mistake(
                    Wrong::Is(&["-(m_1 + m_2)*b^2*omega^2"]),
                    "ω has the components ω sin α and ω cos α along the body axes",
                ),
                Mistake(Wrong::Times("1/4"), "b is the distance from O, not the length of the rod"),
                Mistake(
                    Wrong::Is(&["-(m_1 - m_2)*b^2*omega^2*sin(alpha)*cos(alpha)"]),
                    "both masses contribute with the same sign, as (−b)² = b²",
                ),
            ],
        }],
    },
    Topic {
        name: "dumbbell-forces",
        title: "Forces on the masses of a slanted dumbbell",
        text: "The masses m₁ and m₂ are at the ends of a massless rod, each at the distance b from the point O on the rod. The rod \
               rotates with the constant speed ω about an axis through O, inclined by α to the rod. Find the magnitudes F₁ and F₂ \
               of the forces on the masses, and the component F_p of F₁ perpendicular to the rod.",
        data: &[&[
            drawn("m_1", "kg", 11, 59, 1),
            drawn("m_2", "kg", 11, 59, 1),
            drawn("b", "cm", 12, 69, 0),
            drawn("omega", "rpm", 31, 189, 0),
            drawn("alpha", "deg", 21, 69, 0),
        ]],
        rules: &["(sin(alpha) - cos(alpha))^2 - 1/100", "(m_1 - m_2)^2/m_1^2 - 1/50"],
        steps: &[
            Step::Say("Each mass moves in a circle of radius b sin α: F = m ω² b sin α, towards the axis."),
            Step::Say(
                "The component along the rod exerts no torque about O. The perpendicular one, F cos α, gives N = Σ b F cos α.",
            ),
        ],
        questions: &[
            Question {
                name: "F_1",
                is: "force on m₁",
                unit: "N",
                form: Form::Plain,
                right: &["m_1*b*omega^2*sin(alpha)"],
                mistakes: &[
                    Mistake(Wrong::Is(&["m_1*b*omega^2"]), "the radius of the circle is b sin α, not b"),
                    Mistake(
                        Wrong::Is(&["m_1*b*omega^2*cos(alpha)"]),
                        "the radius of the circle is b sin α: α is the angle between rod and axis",
                    ),
                    Mistake(Wrong::Is(&["m_2*b*omega^2*sin(alpha)"]), "the masses are interchanged"),
                    Mistake(Wrong::With(&[("alpha", "alpha*180/π")]), RADIANS),
                    Mistake(Wrong::With(&[("omega", "omega*30/π")]), RPM),
                    Mistake(Wrong::With(&[("omega", "omega/(2*π)")]), HERTZ),
                ],
            },
            Question {
                name: "F_2",
                is: "force on m₂",
                unit: "N",
                form: Form::Plain,
                right: &["m_2*b*omega^2*sin(alpha)"],
                mistakes: &[
                    Mistake(Wrong::Is(&["m_2*b*omega^2"]), "the radius of the circle is b sin α, not b"),
                    Mistake(
                        Wrong::Is(&["m_2*b*omega^2*cos(alpha)"]),
                        "the radius of the circle is b sin α: α is the angle between rod and axis",
                    ),
                    Mistake(Wrong::Is(&["m_1*b*omega^2*sin(alpha)"]), "the masses are interchanged"),
                    Mistake(Wrong::With(&[("alpha", "alpha*180/π")]), RADIANS),
                    Mistake(Wrong::With(&[("omega", "omega*30/π")]), RPM),
                    Mistake(Wrong::With(&[("omega", "omega/(2*π)")]), HERTZ),
                ],
            },
            Question {
                name: "F_p",
                is: "component of the force on m₁ perpendicular to the rod",
                unit: "N",
                form: Form::Plain,
                right: &["m_1*b*omega^2*sin(alpha)*cos(alpha)"],
                mistakes: &[
                    Mistake(Wrong::Is(&["m_1*b*omega^2*sin(alpha)"]), "this is the whole force"),
                    Mistake(
                        Wrong::Is(&["m_1*b*omega^2*sin(alpha)^2"]),
                        "this is the component along the rod",
                    ),
                    Mistake(
                        Wrong::Is(&["m_2*b*omega^2*sin(alpha)*cos(alpha)"]),
                        "the masses are interchanged",
                    ),
                    Mistake(Wrong::With(&[("alpha", "alpha*180/π")]), RADIANS),
                    Mistake(Wrong::With(&[("omega", "omega*30/π")]), RPM),
                ],
            },
        ],
    },
];
