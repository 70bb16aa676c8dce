//! Angular momentum, kinetic energy, and units.

use super::super::topic::{Form, Mistake, Question, Step, Topic, Wrong, computed, drawn, hidden, signed};
use super::{MOMENTS, TENSOR};

const REVERSED: &[(&str, &str)] = &[("I_xy", "-I_xy"), ("I_xz", "-I_xz"), ("I_yz", "-I_yz")];
const DIAGONAL: &[(&str, &str)] = &[("I_xy", "0"), ("I_xz", "0"), ("I_yz", "0")];
const HALVED: &[(&str, &str)] = &[("I_xy", "I_xy/2"), ("I_xz", "I_xz/2"), ("I_yz", "I_yz/2")];
const RPM: &str = "rpm is taken for rad/s: 1 rpm = 2π/60 rad/s";
const HERTZ: &str = "revolutions per second are taken for rad/s: ω = 2π n";

pub(super) const TOPICS: [Topic; 5] = [
    Topic {
        name: "angular-momentum",
        title: "Angular momentum from ω",
        text: "A body has the inertia tensor I_xx, I_yy, I_zz, I_xy, I_xz, I_yz about a fixed point and rotates with ω = (ω_x, \
               ω_y, ω_z). Find its angular momentum about this point.",
        data: &[
            &TENSOR,
            &[
                signed("omega_x", "rad/s", 12, 59, 1),
                signed("omega_y", "rad/s", 12, 59, 1),
                signed("omega_z", "rad/s", 12, 59, 1),
            ],
        ],
        rules: &[],
        steps: &[
            Step::Say("Li = Σj Iij ωj: each component of L is a row of the tensor times ω."),
            Step::Say("The elements of the tensor have their sign already: I_xy is −∫ x y dm."),
        ],
        questions: &[Question {
            name: "L",
            is: "angular momentum",
            unit: "kg m^2/s",
            form: Form::Plain,
            right: &[
                "I_xx*omega_x + I_xy*omega_y + I_xz*omega_z",
                "I_xy*omega_x + I_yy*omega_y + I_yz*omega_z",
                "I_xz*omega_x + I_yz*omega_y + I_zz*omega_z",
            ],
            mistakes: &[
                Mistake(Wrong::With(REVERSED), "this is the value with the sign of the products reversed"),
                Mistake(
                    Wrong::With(DIAGONAL),
                    "the products of inertia are missing: L is parallel to ω only along a principal axis",
                ),
                Mistake(
                    Wrong::With(&[("I_xy", "I_yz"), ("I_yz", "I_xy")]),
                    "the elements I_xy and I_yz are interchanged",
                ),
            ],
        }],
    },
    Topic {
        name: "kinetic-energy",
        title: "Rotational kinetic energy from ω",
        text: "A body has the inertia tensor I_xx, I_yy, I_zz, I_xy, I_xz, I_yz about a fixed point and rotates with ω = (ω_x, \
               ω_y, ω_z). Find its kinetic energy.",
        data: &[
            &TENSOR,
            &[
                signed("omega_x", "rad/s", 12, 59, 1),
                signed("omega_y", "rad/s", 12, 59, 1),
                signed("omega_z", "rad/s", 12, 59, 1),
            ],
        ],
        rules: &[],
        steps: &[
            Step::Say("T = ½ ω · L = ½ Σij Iij ωi ωj."),
            Step::Say("Each product occurs twice in the double sum, so that the ½ cancels there."),
        ],
        questions: &[Question {
            name: "T",
            is: "kinetic energy",
            unit: "J",
            form: Form::Plain,
            right: &[
                "(I_xx*omega_x^2 + I_yy*omega_y^2 + I_zz*omega_z^2)/2 + I_xy*omega_x*omega_y + I_xz*omega_x*omega_z + I_yz*omega_y*omega_z",
            ],
            mistakes: &[
                Mistake(Wrong::Times("2"), "the factor ½ is forgotten"),
                Mistake(Wrong::With(REVERSED), "this is the value with the sign of the products reversed"),
                Mistake(
                    Wrong::With(DIAGONAL),
                    "the products of inertia are missing: ½ Σ I ω² holds along principal axes only",
                ),
                Mistake(Wrong::With(HALVED), "each product counts twice in the double sum: I_xy and I_yx"),
            ],
        }],
    },
    Topic {
        name: "angle-between-omega-and-L",
        title: "Angle between ω and L",
        text: "A body has the principal moments I₁, I₂ and I₃ and rotates with ω = (ω₁, ω₂, ω₃) along its principal axes. Find \
               the angle φ between ω and L.",
        data: &[
            &MOMENTS,
            &[
                signed("omega_1", "rad/s", 12, 59, 1),
                signed("omega_2", "rad/s", 12, 59, 1),
                signed("omega_3", "rad/s", 12, 59, 1),
            ],
        ],
        rules: &[],
        steps: &[
            Step::Say(
                "L = (I₁ ω₁, I₂ ω₂, I₃ ω₃), and tan φ = |ω × L|/(ω · L). The angle is below 90°, because ω · L = 2 T > 0.",
            ),
            Step::Say("The components of ω × L are (I₃ − I₂) ω₂ ω₃, (I₁ − I₃) ω₃ ω₁ and (I₂ − I₁) ω₁ ω₂."),
        ],
        questions: &[Question {
            name: "phi",
            is: "angle between ω and L",
            unit: "deg",
            form: Form::SquaredTangent("tan_squared_phi"),
            right: &[
                "(((I_3 - I_2)*omega_2*omega_3)^2 + ((I_1 - I_3)*omega_3*omega_1)^2 + ((I_2 - I_1)*omega_1*omega_2)^2)/(I_1*omega_1^2 + I_2*omega_2^2 + I_3*omega_3^2)^2",
            ],
            mistakes: &[
                Mistake(
                    Wrong::Is(&[
                        "(I_1*omega_1^2 + I_2*omega_2^2 + I_3*omega_3^2)^2/(((I_3 - I_2)*omega_2*omega_3)^2 + ((I_1 - I_3)*omega_3*omega_1)^2 + ((I_2 - I_1)*omega_1*omega_2)^2)",
                    ]),
                    "this is the complement to 90°: sine and cosine are interchanged",
                ),
                Mistake(Wrong::Times("4"), "ω · L is twice the kinetic energy"),
            ],
        }],
    },
    Topic {
        name: "energy-lost",
        title: "Energy lost at constant angular momentum",
        text: "A satellite rotates with the speed n about its axis of the smallest moment of inertia I₁. Parts that bend dissipate \
               energy, but no torque acts. In the end it rotates about the axis of the largest moment I₃. Find its final \
               angular speed and the energy lost.",
        data: &[&[
            hidden("p", 21, 59, 1),
            drawn("I_1", "kg m^2", 21, 89, 1),
            computed("I_3", "kg m^2", "I_1 + p"),
            drawn("n", "rpm", 12, 89, 1),
        ]],
        rules: &["2*I_1 - p", "p - I_1/5"],
        steps: &[
            Step::Say(
                "L is constant: L = I₁ n = I₃ ω. The energy is L²/(2 I), which is smallest for the largest moment.",
            ),
            Step::Say("Convert n first: 1 rpm = 2π/60 rad/s."),
        ],
        questions: &[
            Question {
                name: "omega",
                is: "final angular speed",
                unit: "rad/s",
                form: Form::Plain,
                right: &["I_1*n/I_3"],
                mistakes: &[
                    Mistake(
                        Wrong::With(&[("I_1", "I_3"), ("I_3", "I_1")]),
                        "the moments are interchanged: the body turns slower in the end",
                    ),
                    Mistake(Wrong::With(&[("n", "n*30/π")]), RPM),
                    Mistake(Wrong::With(&[("n", "n/(2*π)")]), HERTZ),
                    Mistake(Wrong::Is(&["n"]), "ω is not conserved, but L"),
                ],
            },
            Question {
                name: "lost",
                is: "energy lost, positive",
                unit: "J",
                form: Form::Plain,
                right: &["I_1^2*n^2*(1/I_1 - 1/I_3)/2"],
                mistakes: &[
                    Mistake(
                        Wrong::Is(&["(I_3 - I_1)*n^2/2"]),
                        "ω is not conserved, but L: compare L²/(2 I₁) with L²/(2 I₃)",
                    ),
                    Mistake(Wrong::Times("2"), "the factor ½ is forgotten"),
                    Mistake(Wrong::Times("-1"), "the energy lost is the first energy minus the last one"),
                    Mistake(Wrong::With(&[("n", "n*30/π")]), RPM),
                    Mistake(Wrong::With(&[("n", "n/(2*π)")]), HERTZ),
                ],
            },
        ],
    },
    Topic {
        name: "units",
        title: "Units of rotation",
        text: "A rotor with the moment of inertia I rotates with the speed n and stops within the time t, with a constant torque. \
               Find its angular speed, angular momentum and kinetic energy, and the magnitude of the torque.",
        data: &[&[
            drawn("I", "kg cm^2", 121, 989, 1),
            drawn("n", "rpm", 210, 2990, 0),
            drawn("t", "min", 12, 59, 1),
        ]],
        rules: &[],
        steps: &[
            Step::Say("1 kg cm² = 10⁻⁴ kg m², 1 rpm = 2π/60 rad/s, 1 min = 60 s."),
            Step::Say("ω = n in rad/s, L = I ω, T = ½ I ω², and the mean torque is L/t."),
        ],
        questions: &[
            Question {
                name: "omega",
                is: "angular speed",
                unit: "rad/s",
                form: Form::Plain,
                right: &["n"],
                mistakes: &[
                    Mistake(Wrong::Times("30/π"), RPM),
                    Mistake(Wrong::Times("1/(2*π)"), HERTZ),
                    Mistake(Wrong::Times("1/2"), "a revolution is 2π rad, not π"),
                ],
            },
            Question {
                name: "L",
                is: "angular momentum",
                unit: "kg m^2/s",
                form: Form::Plain,
                right: &["I*n"],
                mistakes: &[
                    Mistake(Wrong::With(&[("n", "n*30/π")]), RPM),
                    Mistake(Wrong::With(&[("n", "n/(2*π)")]), HERTZ),
                    Mistake(Wrong::Times("100"), "1 cm² is 10⁻⁴ m², not 10⁻² m²"),
                    Mistake(Wrong::Times("10000"), "kg cm² is taken for kg m²"),
                ],
            },
            Question {
                name: "T",
                is: "kinetic energy",
                unit: "J",
                form: Form::Plain,
                right: &["I*n^2/2"],
                mistakes: &[
                    Mistake(Wrong::Times("2"), "the factor ½ is forgotten"),
                    Mistake(Wrong::With(&[("n", "n*30/π")]), RPM),
                    Mistake(Wrong::With(&[("n", "n/(2*π)")]), HERTZ),
                    Mistake(Wrong::Times("100"), "1 cm² is 10⁻⁴ m², not 10⁻² m²"),
                    Mistake(Wrong::Times("10000"), "kg cm² is taken for kg m²"),
                ],
            },
            Question {
                name: "N",
                is: "magnitude of the torque",
                unit: "mN m",
                form: Form::Plain,
                right: &["I*n/t"],
                mistakes: &[
                    Mistake(Wrong::Times("60"), "minutes are taken for seconds"),
                    Mistake(Wrong::With(&[("n", "n*30/π")]), RPM),
                    Mistake(Wrong::With(&[("n", "n/(2*π)")]), HERTZ),
                    Mistake(Wrong::Times("100"), "1 cm² is 10⁻⁴ m², not 10⁻² m²"),
                ],
            },
        ],
    },
];
