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
