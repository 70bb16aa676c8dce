//! Pendulums, and rolling on an incline.

use super::super::topic::{Form, GRAVITY, Mistake, Question, Step, Topic, Wrong, drawn};

const TWO_PI: &str = "a factor 2π is missing: the period is 2π/ω₀";

pub(super) const TOPICS: [Topic; 6] = [
    Topic {
        name: "physical-pendulum",
        title: "Period of a physical pendulum",
        text: "A uniform thin rod of length l swings about a horizontal axis at the distance d from its centre, perpendicular to \
               the rod. Find the period of small oscillations.",
        data: &[&[drawn("l", "cm", 61, 159, 0), drawn("d", "cm", 11, 29, 0), GRAVITY]],
        rules: &["l/2 - d"],
        steps: &[
            Step::Say(
                "About the axis I = M l²/12 + M d², and gravity exerts the torque −M g d sin θ ≃ −M g d θ.",
            ),
            Step::Say("I θ̈ = −M g d θ gives ω₀² = M g d/I, and τ = 2π/ω₀. The mass cancels."),
        ],
        questions: &[Question {
            name: "tau",
            is: "period of small oscillations",
            unit: "s",
            form: Form::Square("tau_squared"),
            right: &["4*π^2*(l^2/12 + d^2)/(g*d)"],
            mistakes: &[
                Mistake(
                    Wrong::Is(&["4*π^2*l^2/12/(g*d)"]),
                    "the shift M d² from the centre to the axis is missing",
                ),
                Mistake(
                    Wrong::Is(&["4*π^2*(l^2/3 + d^2)/(g*d)"]),
                    "the rod has M l²/12 about its centre; M l²/3 belongs to its end",
                ),
                Mistake(
                    Wrong::Is(&["4*π^2*d/g"]),
                    "this is the period of a particle at the centre: the moment M l²/12 is missing",
                ),
                Mistake(
                    Wrong::Is(&["4*π^2*(d^2 - l^2/12)/(g*d)"]),
                    "the shift is in the wrong direction: about the axis the moment is larger",
                ),
                Mistake(Wrong::Times("1/(4*π^2)"), TWO_PI),
                Mistake(
                    Wrong::Is(&["g*d/(4*π^2*(l^2/12 + d^2))"]),
                    "this is the frequency, the inverse of the period",
                ),
                Mistake(Wrong::With(&[("d", "2*d")]), "d is the distance from the centre, not twice that"),
            ],
        }],
    },
    Topic {
        name: "two-mass-pendulum",
        title: "Frequency of a pendulum with two masses",
        text: "A massless rod of length b swings about its upper end. The mass m₁ is at its lower end and m₂ at its midpoint. Find \
               the angular frequency ω₀ of small oscillations.",
        data: &[&[
            drawn("m_1", "kg", 11, 89, 1),
            drawn("m_2", "kg", 11, 89, 1),
            drawn("b", "cm", 31, 159, 0),
            GRAVITY,
        ]],
        rules: &["m_2 - m_1/2"],
        steps: &[
            Step::Say("I = m₁ b² + m₂ (b/2)², and N = −(m₁ b + m₂ b/2) g sin θ."),
            Step::Say("N = I θ̈ with sin θ ≃ θ gives ω₀² = −N/(I θ)."),
        ],
        questions: &[Question {
            name: "omega_0",
            is: "angular frequency of small oscillations",
            unit: "rad/s",
            form: Form::Square("omega_0_squared"),
            right: &["(m_1 + m_2/2)/(m_1 + m_2/4)*g/b"],
            mistakes: &[
                Mistake(
                    Wrong::Is(&["g/b"]),
                    "this is the frequency of one mass at the end: m₂ at the midpoint is missing",
                ),
                Mistake(Wrong::Is(&["(m_1 + m_2)/(m_1 + m_2/4)*g/b"]), "the torque on m₂ has the lever b/2"),
                Mistake(
                    Wrong::Is(&["(m_1 + m_2/2)/(m_1 + m_2)*g/b"]),
                    "m₂ has the moment m₂ (b/2)², not m₂ b²",
                ),
                Mistake(
                    Wrong::Is(&["(m_1 + m_2/4)/(m_1 + m_2/2)*g/b"]),
                    "moment and torque are interchanged in the quotient",
                ),
                Mistake(Wrong::With(&[("m_1", "m_2"), ("m_2", "m_1")]), "the masses are interchanged"),
                Mistake(
                    Wrong::Times("1/(4*π^2)"),
                    "this is the frequency in oscillations per second: ω₀ has a factor 2π",
                ),
                Mistake(Wrong::Is(&["b/g*(m_1 + m_2/4)/(m_1 + m_2/2)"]), "this is 1/ω₀"),
            ],
        }],
    },
    Topic {
        name: "centre-of-percussion",
        title: "Centre of percussion",
        text: "A bat of mass M has the moment of inertia I_C about the axis through its centre of mass, perpendicular to the bat. It \
               is held at the distance d from its centre of mass. Find the distance p from the handle at which a blow, \
               perpendicular to the bat, exerts no reaction on the handle.",
        data: &[&[
            drawn("M", "kg", 81, 149, 2),
            drawn("d", "cm", 41, 69, 0),
            drawn("I_C", "kg m^2", 31, 89, 3),
        ]],
        rules: &[],
        steps: &[
            Step::Say("An impulse J at p gives V = J/M to the centre of mass and ω = J (p − d)/I_C."),
            Step::Say("The handle, at the distance d, is at rest if V = ω d."),
        ],
        questions: &[Question {
            name: "p",
            is: "distance of the centre of percussion from the handle",
            unit: "m",
            form: Form::Plain,
            right: &["d + I_C/(M*d)"],
            mistakes: &[
                Mistake(
                    Wrong::Is(&["I_C/(M*d)"]),
                    "this is the distance from the centre of mass: the shift d to the handle is missing",
                ),
                Mistake(
                    Wrong::Is(&["d - I_C/(M*d)"]),
                    "the shift is in the wrong direction: the point is beyond the centre of mass",
                ),
                Mistake(Wrong::Is(&["d"]), "a blow at the centre of mass moves the handle, too"),
                Mistake(
                    Wrong::Is(&["I_C/(M*d) + d/2"]),
                    "d is the whole distance from handle to centre of mass",
                ),
            ],
        }],
    },
    Topic {
        name: "torsion-pendulum",
        title: "Torsion pendulum",
        text: "A uniform disk of mass M and diameter D hangs horizontally on a wire at its centre. The wire exerts the torque −κ θ. \
               Find the moment of inertia about the wire and the period.",
        data: &[&[
            drawn("M", "kg", 12, 89, 1),
            drawn("D", "cm", 21, 69, 0),
            drawn("kappa", "N m/rad", 21, 89, 3),
        ]],
        rules: &[],
        steps: &[
            Step::Say("A disk has ½ M R² about its own axis, with R = D/2."),
            Step::Say("I θ̈ = −κ θ gives τ = 2π √(I/κ)."),
        ],
        questions: &[
            Question {
                name: "I",
                is: "moment of inertia about the wire",
                unit: "kg m^2",
                form: Form::Plain,
                right: &["M*D^2/8"],
                mistakes: &[
                    Mistake(Wrong::With(&[("D", "2*D")]), "the diameter is taken for the radius"),
                    Mistake(Wrong::Times("2"), "the factor ½ is forgotten: M R² belongs to a ring"),
                    Mistake(
                        Wrong::Times("1/2"),
                        "M R²/4 is the moment about a diameter, not about the axis of the disk",
                    ),
                    Mistake(Wrong::Times("4/5"), "2/5 M R² belongs to a ball"),
                ],
            },
            Question {
                name: "tau",
                is: "period",
                unit: "s",
                form: Form::Square("tau_squared"),
                right: &["4*π^2*M*D^2/(8*kappa)"],
                mistakes: &[
                    Mistake(Wrong::With(&[("D", "2*D")]), "the diameter is taken for the radius"),
                    Mistake(Wrong::Times("2"), "the factor ½ in the moment of inertia is forgotten"),
                    Mistake(Wrong::Times("1/2"), "the moment about a diameter is used"),
                    Mistake(Wrong::Times("1/(4*π^2)"), TWO_PI),
                    Mistake(
                        Wrong::Is(&["8*kappa/(M*D^2)/(4*π^2)"]),
                        "this is the frequency, the inverse of the period",
                    ),
                ],
            },
        ],
    },
    Topic {
        name: "rolling-ball",
        title: "Ball that rolls down an incline",
        text: "A homogeneous ball rolls without slipping down a plane inclined by β, from rest. Find the acceleration of its centre, \
               and its speed after the distance s.",
        data: &[&[drawn("beta", "deg", 11, 39, 0), drawn("s", "m", 11, 79, 1), GRAVITY]],
        rules: &[],
        steps: &[
            Step::Say("M a = M g sin β − F, and the friction F turns the ball: 2/5 M R² · a/R = F R."),
            Step::Say("Without F: a (1 + 2/5) = g sin β. From rest v² = 2 a s."),
        ],
        questions: &[
            Question {
                name: "a",
                is: "acceleration of the centre",
                unit: "m/s^2",
                form: Form::Plain,
                right: &["5/7*g*sin(beta)"],
                mistakes: &[
                    Mistake(
                        Wrong::Times("7/5"),
                        "this is the acceleration of a body that slides without friction: the rotation is missing",
                    ),
                    Mistake(Wrong::Times("14/15"), "½ M R² belongs to a cylinder: a ball has 2/5 M R²"),
                    Mistake(Wrong::Times("1/2*7/5"), "M R² belongs to a ring: a ball has 2/5 M R²"),
                    Mistake(
                        Wrong::Is(&["5/7*g*cos(beta)"]),
                        "the component of gravity along the plane has the sine of its inclination",
                    ),
                    Mistake(
                        Wrong::With(&[("beta", "beta*180/π")]),
                        "the sine of degrees is taken as that of radians",
                    ),
                    Mistake(Wrong::Is(&["5/7*g"]), "the sine of the inclination is missing"),
                ],
            },
            Question {
                name: "v",
                is: "speed after the distance s",
                unit: "m/s",
                form: Form::Square("v_squared"),
                right: &["10/7*g*s*sin(beta)"],
                mistakes: &[
                    Mistake(Wrong::Times("7/5"), "the energy of the rotation is missing"),
                    Mistake(Wrong::Times("14/15"), "½ M R² belongs to a cylinder: a ball has 2/5 M R²"),
                    Mistake(Wrong::Times("1/2"), "v² = 2 a s: a factor 2 is forgotten"),
                    Mistake(
                        Wrong::Is(&["10/7*g*s*cos(beta)"]),
                        "the component of gravity along the plane has the sine of its inclination",
                    ),
                    Mistake(
                        Wrong::With(&[("beta", "beta*180/π")]),
                        "the sine of degrees is taken as that of radians",
                    ),
                    Mistake(Wrong::Is(&["10/7*g*s"]), "the sine of the inclination is missing"),
                ],
            },
        ],
    },
    Topic {
        name: "rolling-disk",
        title: "Friction of a rolling disk",
        text: "A uniform disk of mass M and radius R rolls without slipping down a plane inclined by β. Find the friction force \
               and its least coefficient.",
        data: &[&[
            drawn("M", "kg", 12, 89, 1),
            drawn("R", "cm", 12, 69, 0),
            drawn("beta", "deg", 11, 39, 0),
            GRAVITY,
        ]],
        rules: &[],
        steps: &[
            Step::Say(
                "With I = ½ M R² the acceleration is a = g sin β/(1 + ½), and the friction is F = I a/R².",
            ),
            Step::Say("F ≤ μ M g cos β, the normal force times the coefficient."),
        ],
        questions: &[
            Question {
                name: "F",
                is: "friction force",
                unit: "N",
                form: Form::Plain,
                right: &["M*g*sin(beta)/3"],
                mistakes: &[
                    Mistake(
                        Wrong::Times("3"),
                        "this is the component of gravity: the disk would not accelerate",
                    ),
                    Mistake(
                        Wrong::Times("2"),
                        "this is the net force M a: friction is the rest of M g sin β",
                    ),
                    Mistake(Wrong::Times("3/2"), "M R² belongs to a ring: a disk has ½ M R²"),
                    Mistake(
                        Wrong::Is(&["M*g*cos(beta)/3"]),
                        "the component of gravity along the plane has the sine of its inclination",
                    ),
                    Mistake(
                        Wrong::With(&[("beta", "beta*180/π")]),
                        "the sine of degrees is taken as that of radians",
                    ),
                ],
            },
            Question {
                name: "mu",
                is: "least coefficient of friction",
                unit: "",
                form: Form::Plain,
                right: &["sin(beta)/(3*cos(beta))"],
                mistakes: &[
                    Mistake(Wrong::Times("3"), "tan β holds for a body that is at rest"),
                    Mistake(Wrong::Is(&["sin(beta)/3"]), "the normal force is M g cos β, not M g"),
                    Mistake(Wrong::Times("3/2"), "M R² belongs to a ring: a disk has ½ M R²"),
                    Mistake(Wrong::Is(&["cos(beta)/(3*sin(beta))"]), "sine and cosine are interchanged"),
                    Mistake(
                        Wrong::With(&[("beta", "beta*180/π")]),
                        "the tangent of degrees is taken as that of radians",
                    ),
                ],
            },
        ],
    },
];
