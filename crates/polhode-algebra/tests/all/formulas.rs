//! Formulas of the lecture notes as text, LaTeX and MathML, compared literally with
//! `tests/notes.txt`. `POLHODE_WRITE_FORMULAS=1` writes that file.

use polhode_algebra::{
    Accent, Fence, Formula, Large, Matrix, Operator, Relation, RemainingRoots, Style, Variable, Vector,
};

use crate::common::{symbols, value};

const EXPECTED: &str = include_str!("../notes.txt");

fn named(name: &str) -> Formula {
    Formula::named(name)
}

fn vector(name: &str) -> Formula {
    Formula::vector(name)
}

fn of(text: &str) -> Formula {
    value(text).to_formula(&symbols())
}

fn cross(a: Formula, b: Formula) -> Formula {
    Formula::Operation(Operator::Cross, vec![a, b])
}

fn dot(a: Formula, b: Formula) -> Formula {
    Formula::Operation(Operator::Dot, vec![a, b])
}

fn product(factors: &[Formula]) -> Formula {
    Formula::product(factors.to_vec())
}

fn half() -> Formula {
    Formula::integer(1).over(Formula::integer(2))
}

fn hat(name: &str) -> Formula {
    vector(name).accented(Accent::Hat)
}

fn tensor() -> Formula {
    vector("I").grouped(Fence::Braces)
}

fn index(name: &str, index: &str) -> Formula {
    named(name).index(Formula::Letter(index.to_owned(), Style::Italic))
}

/// Σ from k = 1 to 3.
fn sum_to_three(k: &str, body: Formula) -> Formula {
    let below = named(k).equals(Formula::integer(1));
    let above = Some(Box::new(Formula::integer(3)));
    Formula::Limits { operator: Large::Sum, below: Some(Box::new(below)), above, body: Box::new(body) }
}

/// m_α [δ_ij Σ_k x²_αk − x_αi x_αj]
fn element() -> Formula {
    let x = |k: &str| index("x", &format!("α{k}"));
    let squares = Formula::sum_over(named("k"), x("k").squared());
    let inside =
        Formula::Sum(vec![product(&[index("δ", "ij"), squares]), product(&[x("i"), x("j")]).negative()]);
    let term = product(&[named("m_α"), inside.grouped(Fence::Brackets)]);
    Formula::sum_over(named("α"), term)
}

fn cube() -> Matrix {
    Matrix::from_elements(|i, j| value(if i == j { "2/3*M*b^2" } else { "-M*b^2/4" }))
}

fn dumbbell() -> Matrix {
    Matrix::from_elements(|i, j| value(if i == j && i < 2 { "(m_1 + m_2)*b^2" } else { "0" }))
}

/// N = I ω̇ − (I − I) ω ω
fn euler(component: &str, [i, j, k]: [usize; 3]) -> Formula {
    let rate = product(&[named(&format!("I_{i}")), named(&format!("omega_{i}")).accented(Accent::Dot)]);
    let difference = Formula::Sum(vec![named(&format!("I_{j}")), named(&format!("I_{k}")).negative()]);
    let product = product(&[difference, named(&format!("omega_{j}")), named(&format!("omega_{k}"))]);
    named(component).equals(Formula::Sum(vec![rate, product.negative()]))
}

fn lagrangian() -> Formula {
    let symbols = symbols();
    let theta = symbols.find("theta").unwrap();
    let velocity = Variable::Symbol(theta.dot().unwrap());
    let value = value("(m_1 + m_2/4)*b^2*theta_dot^2/2 + (m_1 + m_2/2)*g*b*cos(theta)");
    named("L").equals(value.collected(&[velocity, Variable::Cosine(theta)], &symbols))
}

fn equation_of_motion() -> Formula {
    let symbols = symbols();
    let theta = symbols.find("theta").unwrap();
    let lagrangian = value("(m_1 + m_2/4)*b^2*theta_dot^2/2 + (m_1 + m_2/2)*g*b*cos(theta)");
    let acceleration = Variable::Symbol(theta.dot().unwrap().dot().unwrap());
    let equation = lagrangian.lagrange_equation(theta, &symbols);
    equation.collected(&[acceleration, Variable::Sine(theta)], &symbols).equals(Formula::integer(0))
}

fn momentum_rows() -> Formula {
    let column = |name: &str| {
        let rows = (1..=3).map(|k| vec![named(&format!("{name}_{k}"))]);
        Formula::Matrix(Fence::Parentheses, rows.collect())
    };
    let rows = (1..=3).map(|i| (1..=3).map(|j| named(&format!("I_{i}{j}"))).collect());
    let matrix = Formula::Matrix(Fence::Parentheses, rows.collect());
    column("L").equals(product(&[matrix, column("omega")]))
}

fn characteristic_equation() -> Formula {
    let element = |i: usize, j: usize| {
        let element = named(&format!("I_{i}{j}"));
        if i == j { Formula::Sum(vec![element, named("I").negative()]) } else { element }
    };
    let rows = (1..=3).map(|i| (1..=3).map(|j| element(i, j)).collect()).collect();
    Formula::determinant(rows).equals(Formula::integer(0))
}

fn notes() -> Vec<(&'static str, Formula)> {
    let symbols = symbols();
    let (omega, r) = (|| vector("omega"), || vector("r_α"));
    let velocity = || Formula::Sum(vec![vector("V"), cross(omega(), r())]);
    let axes = ["x", "y", "z"].map(hat);
    let torque = Vector(["-(m_1 + m_2)*b^2*omega^2*sin(alpha)*cos(alpha)", "0", "0"].map(value));
    let spin = Vector(["0", "omega*sin(alpha)", "omega*cos(alpha)"].map(value));
    let lagrange = {
        let (l, q) = (|| named("L"), || named("theta"));
        let momentum = l().derivative(q().accented(Accent::Dot), true).time_derivative();
        Formula::Sum(vec![momentum, l().derivative(q(), true).negative()]).equals(Formula::integer(0))
    };
    let exponent = product(&[named("i"), named("Omega"), named("t")]);
    let plane = Matrix([["a", "b", "0"], ["b", "h", "0"], ["0", "0", "a + h"]].map(|row| row.map(value)));
    let RemainingRoots::Pair(pair) = plane.eigenvalues().rest else { panic!("a pair of roots") };
    vec![
        ("velocity of a particle", vector("v_α").equals(velocity())),
        (
            "kinetic energy of a particle",
            named("T_α")
                .equals(product(&[half(), named("m_α"), vector("v_α").squared()]))
                .equals(product(&[half(), named("m_α"), velocity().squared()])),
        ),
        (
            "rotational energy",
            named("T_rot").equals(product(&[
                half(),
                Formula::sum_over(named("α"), product(&[named("m_α"), cross(omega(), r()).squared()])),
            ])),
        ),
        (
            "vanishing cross term",
            Formula::sum_over(named("α"), product(&[named("m_α"), r()])).equals(Formula::integer(0)),
        ),
        ("elements of the tensor", index("I", "ij").related(Relation::Defined, element())),
        (
            "Kronecker's delta",
            index("δ", "ij").equals(Formula::Cases(vec![
                (Formula::integer(1), named("i").equals(named("j"))),
                (Formula::integer(0), named("i").related(Relation::Unequal, named("j"))),
            ])),
        ),
        (
            "integral of the cube",
            index("I", "12").equals(
                product(&[
                    named("rho"),
                    Formula::integral(
                        Formula::integer(0),
                        named("b"),
                        product(&[
                            named("x"),
                            named("y"),
                            Formula::Differential { is_partial: false, of: Box::new(named("x")) },
                        ]),
                    ),
                ])
                .negative(),
            ),
        ),
        ("moment of the cube", index("I", "11").equals(of("2/3*rho*b^5")).equals(of("2/3*M*b^2"))),
        ("product of the cube", index("I", "12").equals(of("-1/4*rho*b^5")).equals(of("-M*b^2/4"))),
        ("tensor of the cube", tensor().equals(cube().factored_formula(Fence::Braces, &symbols))),
        (
            "principal moments of the cube",
            Formula::List(vec![
                named("I_1").equals(of("M*b^2/6")),
                named("I_2").equals(named("I_3")).equals(of("11/12*M*b^2")),
            ]),
        ),
        (
            "axis of the cube",
            vector("omega_1").equals(Vector(["1", "1", "1"].map(value)).in_basis(&axes, &symbols)),
        ),
        (
            "third axis of the cube",
            vector("omega_3").equals(Vector(["-1", "-1", "2"].map(value)).in_basis(&axes, &symbols)),
        ),
        (
            "rotational energy in principal axes",
            named("T_rot").equals(product(&[
                half(),
                sum_to_three("i", product(&[named("I_i"), named("omega_i").squared()])),
            ])),
        ),
        (
            "double vector product",
            cross(vector("A"), cross(vector("B"), vector("A"))).equals(Formula::Sum(vec![
                product(&[named("A").squared(), vector("B")]),
                product(&[dot(vector("A"), vector("B")).grouped(Fence::Parentheses), vector("A")]).negative(),
            ])),
        ),
        (
            "angular momentum by components",
            named("L_i").equals(sum_to_three("j", product(&[index("I", "ij"), named("omega_j")]))),
        ),
        ("angular momentum as a matrix product", momentum_rows()),
        (
            "torque",
            vector("N")
                .equals(vector("L").derivative(named("t"), false))
                .equals(dot(tensor(), omega().accented(Accent::Dot))),
        ),
        ("moment of the pendulum", index("I", "22").equals(of("(m_1 + m_2/4)*b^2")).equals(index("I", "33"))),
        ("torque of the pendulum", vector("N").equals(of("-(m_1 + m_2/2)*b*g*sin(theta)").times(hat("z")))),
        (
            "small oscillations",
            named("theta").accented(Accent::DoubleDot).related(
                Relation::Approximate,
                product(&[named("omega_0").squared(), named("theta")]).negative(),
            ),
        ),
        (
            "frequency of the pendulum",
            named("omega_0")
                .equals(value("(m_1 + m_2/2)/(m_1 + m_2/4)*g/b").square_root(&symbols).to_formula(&symbols)),
        ),
        ("Lagrange's equation", lagrange),
        ("Lagrangian of the pendulum", lagrangian()),
        ("equation of motion of the pendulum", equation_of_motion()),
        ("characteristic equation", characteristic_equation()),
        ("moving axes", hat("x_i").derivative(named("t"), false).equals(cross(omega(), hat("x_i")))),
        (
            "Euler's equations",
            Formula::Rows(vec![euler("N_x", [1, 2, 3]), euler("N_y", [2, 3, 1]), euler("N_z", [3, 1, 2])]),
        ),
        ("spin of the dumbbell", omega().equals(spin.in_basis(&axes, &symbols))),
        ("tensor of the dumbbell", tensor().equals(dumbbell().to_formula(Fence::Braces, &symbols))),
        ("torque on the dumbbell", vector("N").equals(torque.in_basis(&axes, &symbols))),
        ("rate of precession", named("Omega").related(Relation::Defined, of("(I_3 - I_1)/I_1*omega_3"))),
        (
            "precession of the symmetric top",
            named("omega_1")
                .accented(Accent::Dot)
                .equals(product(&[named("Omega"), named("omega_2")]).negative()),
        ),
        (
            "complex amplitude",
            Formula::Function(Box::new(named("eta")), Box::new(named("t")))
                .equals(product(&[named("A"), named("e").power(exponent)])),
        ),
        (
            "energy of the free top",
            named("E").equals(product(&[half(), named("omega"), named("L"), named("phi").applied("cos")])),
        ),
        (
            "moments of a plane body",
            Formula::List(vec![named("I_1"), named("I_2")]).equals(pair.to_formula(&symbols)),
        ),
        ("moment of a cylinder", index("I", "xx").equals(of("M*r^2/4 + M*h^2/12"))),
        ("energy of the heavy top", heavy_top()),
    ]
}

fn heavy_top() -> Formula {
    let symbols = symbols();
    let rates = ["theta_dot", "phi_dot"].map(|name| Variable::Symbol(symbols.find(name).unwrap()));
    let energy = value("I_1/2*(theta_dot^2 + phi_dot^2*sin(theta)^2)");
    named("T").equals(energy.collected(&rates, &symbols))
}

/// Returns a formula in its three forms.
fn written(formula: &Formula) -> String {
    format!("{}\n\n{}\n\n{}\n", formula.to_text(), formula.to_latex(), formula.to_mathml())
}

#[test]
fn formulas_of_the_notes() {
    let sections: Vec<String> =
        notes().iter().map(|(title, formula)| format!("## {title}\n\n{}", written(formula))).collect();
    let all = sections.join("\n");
    if std::env::var_os("POLHODE_WRITE_FORMULAS").is_some() {
        std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/notes.txt"), &all).unwrap();
        return;
    }
    for (section, expected) in sections.iter().zip(EXPECTED.split("\n## ")) {
        assert_eq!(
            section.trim_start_matches("## ").trim_end(),
            expected.trim_start_matches("## ").trim_end()
        );
    }
    assert_eq!(all, EXPECTED);
}

#[test]
fn parentheses_where_they_are_needed() {
    let [a, b, c] = ["a", "b", "c"].map(named);
    let sum = || Formula::Sum(vec![a.clone(), b.clone()]);
    let sine = || named("theta").applied("sin");
    let quotient = || a.clone().over(b.clone());
    for (formula, text, latex) in [
        (product(&[sum(), c.clone()]), "(a + b) c", "(a + b) c"),
        (Formula::Sum(vec![a.clone(), sum().negative()]), "a − (a + b)", "a - (a + b)"),
        (Formula::Sum(vec![sum().negative(), c.clone()]), "−(a + b) + c", "-(a + b) + c"),
        (product(&[a.clone(), b.clone().negative()]), "a (−b)", "a (-b)"),
        (a.clone().negative().squared(), "(−a)²", "(-a)^2"),
        (a.clone().squared().negative(), "−a²", "-a^2"),
        (product(&[a.clone(), b.clone()]).squared(), "(a b)²", "(a b)^2"),
        (a.clone().squared().power(named("n")), "(a²)ⁿ", "(a^2)^n"),
        (a.clone().power(Formula::integer(-1)), "a⁻¹", "a^{-1}"),
        (a.clone().power(named("theta")), "a^θ", r"a^\theta"),
        (quotient().squared(), "(a/b)²", r"\left( \frac{a}{b} \right)^2"),
        (quotient().over(c.clone()), "(a/b)/c", r"\frac{\frac{a}{b}}{c}"),
        (a.clone().over(quotient()), "a/(a/b)", r"\frac{a}{\frac{a}{b}}"),
        (a.clone().over(product(&[b.clone(), c.clone()])), "a/(b c)", r"\frac{a}{b c}"),
        (product(&[a.clone(), b.clone()]).over(c.clone()), "a b/c", r"\frac{a b}{c}"),
        (product(&[quotient(), c.clone()]), "a/b · c", r"\frac{a}{b} c"),
        (product(&[quotient(), c.clone()]).squared(), "(a/b · c)²", r"\left( \frac{a}{b} c \right)^2"),
        (product(&[half(), Formula::integer(3), a.clone()]), "1/2 · 3 a", r"\frac{1}{2} \cdot 3 a"),
        (product(&[a.clone(), half()]), "a · 1/2", r"a \frac{1}{2}"),
        (product(&[sine(), a.clone()]), "sin θ · a", r"\sin \theta \cdot a"),
        (product(&[sine().squared(), sine()]), "sin² θ sin θ", r"\sin^2 \theta \sin \theta"),
        (sine().over(a.clone()), "(sin θ)/a", r"\frac{\sin \theta}{a}"),
        (sum().applied("cos"), "cos(a + b)", r"\cos(a + b)"),
        (product(&[Formula::integer(2), a.clone()]).applied("sin"), "sin(2 a)", r"\sin(2 a)"),
        (quotient().applied("sin"), "sin(a/b)", r"\sin\left( \frac{a}{b} \right)"),
        (sum().root(), "√(a + b)", r"\sqrt{a + b}"),
        (Formula::integer(12).root(), "√12", r"\sqrt{12}"),
        (cross(a.clone(), sum()), "a × (a + b)", r"a \times (a + b)"),
        (cross(cross(a.clone(), b.clone()), c.clone()), "(a × b) × c", r"(a \times b) \times c"),
        (product(&[cross(a.clone(), b.clone()), c.clone()]), "(a × b) c", r"(a \times b) c"),
        (
            product(&[Formula::sum_over(named("k"), a.clone()), b.clone()]),
            "(Σₖ a) b",
            r"\left( \sum_k a \right) b",
        ),
        (Formula::sum_over(named("k"), sum()), "Σₖ (a + b)", r"\sum_k (a + b)"),
        (sum().time_derivative(), "d/dt (a + b)", r"\frac{d}{dt} (a + b)"),
        (product(&[a.clone(), b.clone()]).derivative(named("t"), false), "d(a b)/dt", r"\frac{d(a b)}{dt}"),
        (Formula::decimal("-3.3e-5"), "−3.3 × 10⁻⁵", r"-3.3 \times 10^{-5}"),
        (Formula::Operation(Operator::PlusMinus, vec![a.clone()]), "±a", r"\pm a"),
        (Formula::text("50 % & more"), "50 % & more", r"\text{50 \% \& more}"),
    ] {
        assert_eq!((formula.to_text().as_str(), formula.to_latex().as_str()), (text, latex), "{formula:?}");
        let markup = formula.to_mathml();
        assert_eq!(markup.matches('<').count(), 2 * markup.matches("</").count(), "{markup}");
    }
}

#[test]
fn values_in_customary_order() {
    for (source, text) in [
        ("b^2*M", "M b²"),
        ("-M*b^2/4", "−1/4 M b²"),
        ("m_2/2 + m_1", "m₁ + m₂/2"),
        ("m_1*b^2 + m_2*b^2/4", "(m₁ + m₂/4) b²"),
        ("M*(a^2 + b^2)/12", "1/12 M (a² + b²)"),
        ("M*(R^2 + 3/4*r^2)", "M (R² + 3/4 r²)"),
        ("2*a + 2*b", "2 (a + b)"),
        ("a/2 + b/2", "(a + b)/2"),
        ("3*a + 2*b", "3 a + 2 b"),
        ("-a + 3/4*b", "3/4 b − a"),
        ("-a - b", "−a − b"),
        ("x^2 - x + 1", "x² − x + 1"),
        ("I_3*omega - I_1*omega", "(I₃ − I₁) ω"),
        ("sqrt(3)/2*b", "√3/2 b"),
        ("sqrt(6)*b", "√6 b"),
        ("2*sqrt(2)", "2 √2"),
        ("a/(2*b)", "a/(2 b)"),
        ("1/(2*a + b)", "1/(2 a + b)"),
        ("m_1*m_2/(m_1 + m_2)", "m₁ m₂/(m₁ + m₂)"),
        ("-(a + b)/(3*h)", "−(a + b)/(3 h)"),
        ("1 - cos(theta)^2", "sin² θ"),
        ("1 - 2*cos(theta)^2 + cos(theta)^4", "sin⁴ θ"),
        ("1/sin(theta)", "1/(sin θ)"),
        ("sin(alpha)/2", "1/2 sin α"),
        ("I_1*phi_dot*sin(theta)^2 + I_3*phi_dot*cos(theta)^2", "(I₁ sin² θ + I₃ cos² θ) φ̇"),
        ("theta_ddot*phi_dot", "θ̈ φ̇"),
        ("(a + b)^3", "(a + b)³"),
        ("0", "0"),
        ("-7/3", "−7/3"),
    ] {
        assert_eq!(of(source).to_text(), text, "{source}");
    }
    let symbols = symbols();
    let sum = value("(x + y)*(a - 2*b) + 1/2");
    assert_eq!(sum.expanded(&symbols).to_text(), "a x + a y − 2 b x − 2 b y + 1/2");
    let x = Variable::Symbol(symbols.find("x").unwrap());
    assert_eq!(sum.collected(&[x], &symbols).to_text(), "(a − 2 b) x + a y − 2 b y + 1/2");
    assert_eq!(value("4*M*b^2*x").square_root(&symbols).to_formula(&symbols).to_text(), "2 b √(M x)");
}

#[test]
fn symbols_from_their_names() {
    for (name, text, latex) in [
        ("b", "b", "b"),
        ("m_1", "m₁", "m_1"),
        ("m12", "m₁₂", "m_{12}"),
        ("m₁", "m₁", "m_1"),
        ("omega0", "ω₀", r"\omega_0"),
        ("ω_0", "ω₀", r"\omega_0"),
        ("alpha", "α", r"\alpha"),
        ("Omega", "Ω", r"\Omega"),
        ("I_xy", "I_xy", "I_{xy}"),
        ("I_ij", "Iᵢⱼ", "I_{ij}"),
        ("r_alpha", "r_α", r"r_\alpha"),
        ("theta_max", "θ_max", r"\theta_{\max}"),
        ("arm", "arm", r"\mathrm{arm}"),
        ("arm_2", "arm₂", r"\mathrm{arm}_2"),
    ] {
        assert_eq!((named(name).to_text().as_str(), named(name).to_latex().as_str()), (text, latex));
    }
    let rate = named("omega_1").accented(Accent::Dot);
    assert_eq!((rate.to_text().as_str(), rate.to_latex().as_str()), ("ω\u{307}₁", r"\dot{\omega}_1"));
    let mover =
        "<msub><mover accent=\"true\"><mi>ω</mi><mo stretchy=\"false\">˙</mo></mover><mn>1</mn></msub>";
    assert!(rate.to_mathml().contains(mover));
    assert!(hat("x_3").to_mathml().contains("<mi>𝐱</mi><mo stretchy=\"false\">ˆ</mo></mover><mn>3</mn>"));
    assert!(vector("omega").to_mathml().contains("<mi>𝛚</mi>"));
    assert!(Formula::text("a < b").to_mathml().contains("<mtext>a&#xa0;&lt;&#xa0;b</mtext>"));
}
