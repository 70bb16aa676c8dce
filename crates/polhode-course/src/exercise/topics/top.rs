//! Free and heavy tops, and the stability of rotations.

use super::super::topic::{
    Form, GRAVITY, Mistake, Question, Step, Topic, Wrong, computed, drawn, hidden, signed,
};

const RPM: &str = "rpm is taken for rad/s: 1 rpm = 2π/60 rad/s";
const HERTZ: &str = "revolutions per second are taken for rad/s: ω = 2π n";
const INVERTED: &str = "the moments I₁ and I₃ are interchanged";

pub(super) const TOPICS: [Topic; 5] = [
    Topic {
        name: "free-symmetric-top",
        title: "Free symmetric top: precession in the body",
        text: "A free symmetric top has the moments I₁ = I₂ and I₃, and its ω has the component ω₃ along the symmetry axis. Seen \
               from the body, ω precesses about this axis: ω₁ = A cos Ωt and ω₂ = A sin Ωt. Find Ω with its sign.",
        data: &[&[
            drawn("I_1", "kg m^2", 21, 89, 2),
            drawn("I_3", "kg m^2", 21, 89, 2),
            signed("omega_3", "rpm", 21, 189, 0),
        ]],
        rules: &["2*I_1 - I_3", "(I_1 - I_3)^2/I_1^2 - 1/50"],
        steps: &[
            Step::Say("Euler's equations with I₁ = I₂: ω̇₁ = −Ω ω₂, ω̇₂ = Ω ω₁ and ω̇₃ = 0."),
            Step::Say("Here Ω = (I₃ − I₁) ω₃/I₁, with ω₃ in rad/s."),
        ],
        questions: &[Question {
            name: "Omega",
            is: "angular velocity of the precession in the body",
            unit: "rad/s",
            form: Form::Plain,
            right: &["(I_3 - I_1)*omega_3/I_1"],
            mistakes: &[
                Mistake(Wrong::Times("-1"), "the sign is reversed: Ω has the sign of (I₃ − I₁) ω₃"),
                Mistake(
                    Wrong::Is(&["(I_3 - I_1)*omega_3/I_3"]),
                    "the difference is divided by I₁, the moment across the symmetry axis",
                ),
                Mistake(
                    Wrong::Is(&["I_3*omega_3/I_1"]),
                    "this is the precession of the axis in space for a small angle, not that of ω in the body",
                ),
                Mistake(Wrong::Is(&["(I_1 - I_3)*omega_3/I_3"]), INVERTED),
                Mistake(Wrong::With(&[("omega_3", "omega_3*30/π")]), RPM),
                Mistake(Wrong::With(&[("omega_3", "omega_3/(2*π)")]), HERTZ),
            ],
        }],
    },
    Topic {
        name: "cones",
        title: "Space cone and body cone",
        text: "A free symmetric top has the moments I₁ = I₂ and I₃. Its ω has the component ω₃ along the symmetry axis and ω_p \
               perpendicular to it. Find the half angle α of the body cone (between ω and the symmetry axis), the angle θ between L \
               and the symmetry axis, and the half angle γ of the space cone (between ω and L).",
        data: &[&[
            drawn("I_1", "kg m^2", 21, 89, 2),
            drawn("I_3", "kg m^2", 21, 89, 2),
            drawn("omega_3", "rad/s", 21, 89, 1),
            drawn("omega_p", "rad/s", 21, 89, 1),
        ]],
        rules: &[
            "2*I_1 - I_3",
            "(I_1 - I_3)^2/I_1^2 - 1/20",
            "(omega_p - omega_3)^2/omega_3^2 - 1/50",
            "(I_1*omega_p - I_3*omega_3)^2/(I_3*omega_3)^2 - 1/50",
        ],
        steps: &[
            Step::Say(
                "L, ω and the symmetry axis are in one plane: L has the components I₃ ω₃ and I₁ ω_p there.",
            ),
            Step::Say("γ is the difference of the other two: tan γ = |tan α − tan θ|/(1 + tan α tan θ)."),
        ],
        questions: &[
            Question {
                name: "alpha",
                is: "half angle of the body cone",
                unit: "deg",
                form: Form::Tangent("tan_alpha"),
                right: &["omega_p/omega_3"],
                mistakes: &[
                    Mistake(
                        Wrong::Is(&["omega_3/omega_p"]),
                        "this is the complement to 90°: the components are interchanged",
                    ),
                    Mistake(
                        Wrong::Is(&["I_1*omega_p/(I_3*omega_3)"]),
                        "this is the angle of L, not that of ω",
                    ),
                ],
            },
            Question {
                name: "theta",
                is: "angle between L and the symmetry axis",
                unit: "deg",
                form: Form::Tangent("tan_theta"),
                right: &["I_1*omega_p/(I_3*omega_3)"],
                mistakes: &[
                    Mistake(
                        Wrong::Is(&["I_3*omega_3/(I_1*omega_p)"]),
                        "this is the complement to 90°: the components are interchanged",
                    ),
                    Mistake(Wrong::Is(&["omega_p/omega_3"]), "this is the angle of ω, not that of L"),
                    Mistake(Wrong::Is(&["I_3*omega_p/(I_1*omega_3)"]), INVERTED),
                ],
            },
            Question {
                name: "gamma",
                is: "half angle of the space cone",
                unit: "deg",
                form: Form::SquaredTangent("tan_squared_gamma"),
                right: &["(omega_p*omega_3*(I_3 - I_1)/(I_3*omega_3^2 + I_1*omega_p^2))^2"],
                mistakes: &[
                    Mistake(Wrong::Is(&["(omega_p/omega_3)^2"]), "this is the half angle of the body cone"),
                    Mistake(
                        Wrong::Is(&["(I_1*omega_p/(I_3*omega_3))^2"]),
                        "this is the angle between L and the symmetry axis",
                    ),
                ],
            },
        ],
    },
    Topic {
        name: "precession-rate",
        title: "Precession of a free symmetric top in space",
        text: "A free symmetric top has the moments I₁ = I₂ and I₃. Its ω has the component ω₃ along the symmetry axis and ω_p \
               perpendicular to it. Find the magnitude of L, and the angular speed P with which the symmetry axis precesses about L.",
        data: &[&[
            drawn("I_1", "kg m^2", 21, 89, 2),
            drawn("I_3", "kg m^2", 21, 89, 2),
            drawn("omega_3", "rad/s", 21, 89, 1),
            drawn("omega_p", "rad/s", 21, 89, 1),
        ]],
        rules: &["2*I_1 - I_3", "(I_1 - I_3)^2/I_1^2 - 1/50"],
        steps: &[
            Step::Say("L² = (I₁ ω_p)² + (I₃ ω₃)²."),
            Step::Say(
                "ω = P L/L + (ω₃ − I₃ ω₃/I₁) x̂₃. Across the axis this is ω_p = P sin θ with I₁ ω_p = L sin θ: P = L/I₁.",
            ),
        ],
        questions: &[
            Question {
                name: "L",
                is: "magnitude of the angular momentum",
                unit: "kg m^2/s",
                form: Form::Square("L_squared"),
                right: &["I_1^2*omega_p^2 + I_3^2*omega_3^2"],
                mistakes: &[
                    Mistake(
                        Wrong::Is(&["I_3^2*(omega_p^2 + omega_3^2)"]),
                        "the moment across the axis is I₁",
                    ),
                    Mistake(
                        Wrong::Is(&["I_1^2*(omega_p^2 + omega_3^2)"]),
                        "the moment about the symmetry axis is I₃",
                    ),
                    Mistake(
                        Wrong::Is(&["(I_1*omega_p + I_3*omega_3)^2"]),
                        "the components are perpendicular: add their squares",
                    ),
                    Mistake(Wrong::Is(&["I_3^2*omega_p^2 + I_1^2*omega_3^2"]), INVERTED),
                ],
            },
            Question {
                name: "P",
                is: "angular speed of the precession about L",
                unit: "rad/s",
                form: Form::Square("P_squared"),
                right: &["(I_1^2*omega_p^2 + I_3^2*omega_3^2)/I_1^2"],
                mistakes: &[
                    Mistake(
                        Wrong::Is(&["(I_1^2*omega_p^2 + I_3^2*omega_3^2)/I_3^2"]),
                        "L is divided by I₁, the moment across the symmetry axis",
                    ),
                    Mistake(
                        Wrong::Is(&["((I_3 - I_1)*omega_3/I_1)^2"]),
                        "this is Ω, the precession of ω seen from the body",
                    ),
                    Mistake(
                        Wrong::Is(&["(I_3*omega_3/I_1)^2"]),
                        "this holds for a small angle only: L contains I₁ ω_p, too",
                    ),
                    Mistake(Wrong::Is(&["omega_p^2 + omega_3^2"]), "this is the magnitude of ω"),
                    Mistake(Wrong::Times("1/(4*π^2)"), HERTZ),
                ],
            },
        ],
    },
    Topic {
        name: "stability",
        title: "Stability of rotations about the principal axes",
        text: "A free body has the principal moments I₁ < I₂ < I₃. It rotates with the speed n about one axis, with small deviations. \
               Find the angular frequencies Ω₁ and Ω₃ of the oscillations about axes 1 and 3, and the rate k of the exponential \
               growth about axis 2.",
        data: &[&[
            hidden("p", 11, 39, 2),
            hidden("q", 11, 39, 2),
            drawn("I_1", "kg m^2", 41, 89, 2),
            computed("I_2", "kg m^2", "I_1 + p"),
            computed("I_3", "kg m^2", "I_1 + p + q"),
            drawn("n", "rpm", 21, 189, 0),
        ]],
        rules: &["I_1 + I_2 - I_3"],
        steps: &[
            Step::Say("For ω near axis 3: I₁ ω̇₁ = (I₂ − I₃) n ω₂ and I₂ ω̇₂ = (I₃ − I₁) n ω₁."),
            Step::Say(
                "So ω̈₁ = −Ω₃² ω₁. The same about axis 2 has the other sign: the rotation is unstable, with the rate k.",
            ),
        ],
        questions: &[
            Question {
                name: "Omega_1",
                is: "angular frequency of oscillations about axis 1",
                unit: "rad/s",
                form: Form::Square("Omega_1_squared"),
                right: &["n^2*(I_2 - I_1)*(I_3 - I_1)/(I_2*I_3)"],
                mistakes: &[
                    Mistake(
                        Wrong::Is(&["n^2*(I_3 - I_1)*(I_3 - I_2)/(I_1*I_2)"]),
                        "this is the frequency about axis 3",
                    ),
                    Mistake(
                        Wrong::Is(&["n^2*(I_3 - I_2)*(I_2 - I_1)/(I_1*I_3)"]),
                        "this is the growth rate about axis 2",
                    ),
                    Mistake(Wrong::With(&[("n", "n*30/π")]), RPM),
                    Mistake(Wrong::With(&[("n", "n/(2*π)")]), HERTZ),
                ],
            },
            Question {
                name: "k",
                is: "growth rate about axis 2",
                unit: "1/s",
                form: Form::Square("k_squared"),
                right: &["n^2*(I_3 - I_2)*(I_2 - I_1)/(I_1*I_3)"],
                mistakes: &[
                    Mistake(
                        Wrong::Is(&["n^2*(I_3 - I_1)*(I_3 - I_2)/(I_1*I_2)"]),
                        "this is the frequency about axis 3",
                    ),
                    Mistake(
                        Wrong::Is(&["n^2*(I_2 - I_1)*(I_3 - I_1)/(I_2*I_3)"]),
                        "this is the frequency about axis 1",
                    ),
                    Mistake(Wrong::With(&[("n", "n*30/π")]), RPM),
                    Mistake(Wrong::With(&[("n", "n/(2*π)")]), HERTZ),
                ],
            },
            Question {
                name: "Omega_3",
                is: "angular frequency of oscillations about axis 3",
                unit: "rad/s",
                form: Form::Square("Omega_3_squared"),
                right: &["n^2*(I_3 - I_1)*(I_3 - I_2)/(I_1*I_2)"],
                mistakes: &[
                    Mistake(
                        Wrong::Is(&["n^2*(I_2 - I_1)*(I_3 - I_1)/(I_2*I_3)"]),
                        "this is the frequency about axis 1",
                    ),
                    Mistake(
                        Wrong::Is(&["n^2*(I_3 - I_2)*(I_2 - I_1)/(I_1*I_3)"]),
                        "this is the growth rate about axis 2",
                    ),
                    Mistake(Wrong::With(&[("n", "n*30/π")]), RPM),
                    Mistake(Wrong::With(&[("n", "n/(2*π)")]), HERTZ),
                ],
            },
        ],
    },
    Topic {
        name: "heavy-top",
        title: "Slow precession of a fast heavy top",
        text: "A heavy symmetric top of mass M spins fast with the speed n about its symmetry axis, and is supported at a fixed point. \
               Its centre of mass is at the distance l from this point, its moments about this point are I₁ = I₂ and I₃. Find the \
               angular speed P of the slow steady precession, in the approximation of a fast top.",
        data: &[&[
            drawn("M", "g", 210, 890, 0),
            drawn("l", "cm", 21, 89, 1),
            drawn("I_1", "kg cm^2", 121, 389, 1),
            drawn("I_3", "kg cm^2", 21, 89, 1),
            drawn("n", "rpm", 2100, 8900, 0),
            GRAVITY,
        ]],
        rules: &["I_1 - I_3/2 - M*l^2", "I_3^2*n^2 - 800*M*g*l*I_1"],
        steps: &[
            Step::Say("Gravity exerts the torque M g l sin θ, and L ≃ I₃ n along the axis."),
            Step::Say("The axis precesses so that dL/dt = P L sin θ: the angle θ and I₁ cancel."),
        ],
        questions: &[Question {
            name: "P",
            is: "angular speed of the slow precession",
            unit: "rad/s",
            form: Form::Plain,
            right: &["M*g*l/(I_3*n)"],
            mistakes: &[
                Mistake(
                    Wrong::Is(&["M*g*l/(I_1*n)"]),
                    "the spin is about the symmetry axis: its moment is I₃, not I₁",
                ),
                Mistake(Wrong::With(&[("n", "n*30/π")]), RPM),
                Mistake(Wrong::With(&[("n", "n/(2*π)")]), HERTZ),
                Mistake(Wrong::Is(&["M*l/(I_3*n)"]), "the weight is M g"),
                Mistake(Wrong::Is(&["I_3*n/I_1"]), "this is the fast precession, the nutation"),
                Mistake(
                    Wrong::With(&[("l", "2*l")]),
                    "l is the distance to the centre of mass, not the length of the top",
                ),
            ],
        }],
    },
];
