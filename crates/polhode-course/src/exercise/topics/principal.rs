//! Principal moments and axes.

use super::super::topic::{
    Datum, Form, Mistake, Question, Step, Topic, Wrong, computed, drawn, hidden, sign, signed,
};

/// Tensor with the principal moments 9 a < 9 b < 9 c along the axes (2 s, 2 t, −1)/3, (−s, 2 t, 2)/3
/// and (2 s, −t, 2)/3, so that its eigenvalues and eigenvectors are rational.
const ROTATED: [Datum; 11] = [
    hidden("a", 211, 389, 4),
    hidden("b", 231, 489, 4),
    hidden("c", 251, 589, 4),
    sign("s"),
    sign("t"),
    computed("I_xx", "kg m^2", "4*a + b + 4*c"),
    computed("I_yy", "kg m^2", "4*a + 4*b + c"),
    computed("I_zz", "kg m^2", "a + 4*b + 4*c"),
    computed("I_xy", "kg m^2", "s*t*(4*a - 2*b - 2*c)"),
    computed("I_xz", "kg m^2", "s*(4*c - 2*a - 2*b)"),
    computed("I_yz", "kg m^2", "t*(4*b - 2*a - 2*c)"),
];

/// Order of the moments with clear differences, and the triangle inequality.
const ORDER: [&str; 6] = [
    "b - a*11/10",
    "c - b*11/10",
    "a + b - c*21/20",
    "(2*a - b - c)^2 - a^2/50",
    "(2*b - a - c)^2 - a^2/50",
    "(2*c - a - b)^2 - a^2/50",
];

const ANOTHER: &str = "this is another principal moment: I₁ is the smallest and I₃ the largest";
const DIAGONAL: &str = "this is a diagonal element of the tensor: find the roots of |{I} − λ 1| = 0";
const OTHER_AXIS: &str = "this is the axis of another principal moment";
const UNROTATED: &str = "the axes x, y and z are not principal axes: the tensor has products of inertia";

pub(super) const TOPICS: [Topic; 3] = [
    Topic {
        name: "principal-moments",
        title: "Principal moments of inertia",
        text: "The inertia tensor of a body has the elements I_xx, I_yy, I_zz, I_xy, I_xz and I_yz. Find its principal \
               moments I₁ < I₂ < I₃.",
        data: &[&ROTATED],
        rules: &ORDER,
        steps: &[
            Step::Say(
                "The principal moments are the roots of |{I} − λ 1| = 0, which is λ³ − S λ² + K λ − D = 0 with",
            ),
            Step::Show("S", "I_xx + I_yy + I_zz", "kg m^2"),
            Step::Show("K", "I_xx*I_yy + I_xx*I_zz + I_yy*I_zz - I_xy^2 - I_xz^2 - I_yz^2", "kg^2 m^4"),
            Step::Show(
                "D",
                "I_xx*I_yy*I_zz + 2*I_xy*I_xz*I_yz - I_xx*I_yz^2 - I_yy*I_xz^2 - I_zz*I_xy^2",
                "kg^3 m^6",
            ),
            Step::Say(
                "Check: their sum is S and their product is D, and none is larger than the sum of the others.",
            ),
        ],
        questions: &[
            Question {
                name: "I_1",
                is: "smallest principal moment",
                unit: "kg m^2",
                form: Form::Plain,
                right: &["9*a"],
                mistakes: &[
                    Mistake(Wrong::Is(&["9*b"]), ANOTHER),
                    Mistake(Wrong::Is(&["9*c"]), ANOTHER),
                    Mistake(Wrong::Is(&["4*a + b + 4*c"]), DIAGONAL),
                    Mistake(Wrong::Is(&["4*a + 4*b + c"]), DIAGONAL),
                    Mistake(Wrong::Is(&["a + 4*b + 4*c"]), DIAGONAL),
                ],
            },
            Question {
                name: "I_2",
                is: "intermediate principal moment",
                unit: "kg m^2",
                form: Form::Plain,
                right: &["9*b"],
                mistakes: &[Mistake(Wrong::Is(&["9*a"]), ANOTHER), Mistake(Wrong::Is(&["9*c"]), ANOTHER)],
            },
            Question {
                name: "I_3",
                is: "largest principal moment",
                unit: "kg m^2",
                form: Form::Plain,
                right: &["9*c"],
                mistakes: &[
                    Mistake(Wrong::Is(&["9*a"]), ANOTHER),
                    Mistake(Wrong::Is(&["9*b"]), ANOTHER),
                    Mistake(Wrong::Is(&["a + 4*b + 4*c"]), DIAGONAL),
                ],
            },
        ],
    },
    Topic {
        name: "principal-axes",
        title: "Principal axes of inertia",
        text: "The inertia tensor of a body has the elements I_xx, I_yy, I_zz, I_xy, I_xz and I_yz, and the principal moments \
               I₁ < I₂ < I₃. Find vectors e₁ and e₃ along the principal axes 1 and 3. Length and sign do not matter.",
        data: &[
            &ROTATED,
            &[
                computed("I_1", "kg m^2", "9*a"),
                computed("I_2", "kg m^2", "9*b"),
                computed("I_3", "kg m^2", "9*c"),
            ],
        ],
        rules: &ORDER,
        steps: &[
            Step::Say(
                "For each root solve ({I} − λ 1) e = 0. The three equations are dependent: two of them give the ratios of the components.",
            ),
            Step::Say("The vector product of two rows of {I} − λ 1 is such a vector. Check: e₁ · e₃ = 0."),
        ],
        questions: &[
            Question {
                name: "e_1",
                is: "vector along the axis of the smallest moment",
                unit: "",
                form: Form::Axis,
                right: &["2*s/3", "2*t/3", "-1/3"],
                mistakes: &[
                    Mistake(Wrong::Is(&["-s", "2*t", "2"]), OTHER_AXIS),
                    Mistake(Wrong::Is(&["2*s", "-t", "2"]), OTHER_AXIS),
                    Mistake(Wrong::Is(&["1", "0", "0"]), UNROTATED),
                    Mistake(Wrong::Is(&["0", "1", "0"]), UNROTATED),
                    Mistake(Wrong::Is(&["0", "0", "1"]), UNROTATED),
                ],
            },
            Question {
                name: "e_3",
                is: "vector along the axis of the largest moment",
                unit: "",
                form: Form::Axis,
                right: &["2*s/3", "-t/3", "2/3"],
                mistakes: &[
                    Mistake(Wrong::Is(&["-s", "2*t", "2"]), OTHER_AXIS),
                    Mistake(Wrong::Is(&["2*s", "2*t", "-1"]), OTHER_AXIS),
                    Mistake(Wrong::Is(&["1", "0", "0"]), UNROTATED),
                    Mistake(Wrong::Is(&["0", "1", "0"]), UNROTATED),
                    Mistake(Wrong::Is(&["0", "0", "1"]), UNROTATED),
                ],
            },
        ],
    },
    Topic {
        name: "axes-of-plate",
        title: "Principal axes of a plate",
        text: "A thin plate in the plane of x and y has the moments I_xx and I_yy and the product of inertia I_xy, an element of \
               its tensor. The principal axis 1 is rotated by θ from x towards y. Find tan 2θ, and the difference Δ > 0 of the \
               two principal moments in the plane.",
        data: &[&[
            drawn("I_xx", "kg m^2", 121, 589, 3),
            drawn("I_yy", "kg m^2", 121, 589, 3),
            signed("I_xy", "kg m^2", 31, 99, 3),
        ]],
        rules: &["(I_xx - I_yy)^2 - I_xx*I_yy/20", "I_xx*I_yy - 2*I_xy^2"],
        steps: &[
            Step::Say(
                "Rotated by θ, the product becomes I_xy cos 2θ − (I_xx − I_yy) sin 2θ/2, which is zero along principal axes.",
            ),
            Step::Say("The roots of λ² − (I_xx + I_yy) λ + I_xx I_yy − I_xy² = 0 are (I_xx + I_yy)/2 ± Δ/2."),
        ],
        questions: &[
            Question {
                name: "tan_2theta",
                is: "tangent of twice the angle of axis 1",
                unit: "",
                form: Form::Plain,
                right: &["2*I_xy/(I_xx - I_yy)"],
                mistakes: &[
                    Mistake(
                        Wrong::With(&[("I_xy", "-I_xy")]),
                        "the sign of the product of inertia is reversed",
                    ),
                    Mistake(Wrong::Times("1/2"), "the product of inertia counts twice: I_xy and I_yx"),
                    Mistake(
                        Wrong::Is(&["2*I_xy/(I_xx + I_yy)"]),
                        "the denominator is the difference of the moments",
                    ),
                    Mistake(Wrong::Is(&["(I_xx - I_yy)/(2*I_xy)"]), "this is the cotangent"),
                ],
            },
            Question {
                name: "Delta",
                is: "difference of the principal moments in the plane",
                unit: "kg m^2",
                form: Form::Square("Delta_squared"),
                right: &["(I_xx - I_yy)^2 + 4*I_xy^2"],
                mistakes: &[
                    Mistake(Wrong::Is(&["(I_xx - I_yy)^2"]), "the product of inertia is missing"),
                    Mistake(
                        Wrong::Is(&["(I_xx - I_yy)^2 + I_xy^2"]),
                        "the product of inertia counts twice: Δ² has 4 I_xy²",
                    ),
                    Mistake(Wrong::Times("1/4"), "this is Δ/2: the moments are at the mean ± Δ/2"),
                ],
            },
        ],
    },
];
