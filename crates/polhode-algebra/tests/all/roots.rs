//! Roots in closed form, eigenvalues and eigenvectors.

use polhode_algebra::{Formula, Matrix, RationalFunction, RemainingRoots, Univariate, Vector};

use crate::common::{Random, symbols, value, variables};

fn matrix(rows: [[&str; 3]; 3]) -> Matrix {
    Matrix(rows.map(|row| row.map(value)))
}

/// Returns ∏ (λ − root).
fn product(roots: &[RationalFunction]) -> Univariate {
    let mut coefficients = vec![RationalFunction::one()];
    for root in roots {
        let mut next = vec![RationalFunction::zero(); coefficients.len() + 1];
        for (k, c) in coefficients.iter().enumerate() {
            next[k] = &next[k] - root * c;
            next[k + 1] = &next[k + 1] + c;
        }
        coefficients = next;
    }
    Univariate::new(coefficients)
}

fn rational_roots(polynomial: &Univariate) -> Vec<RationalFunction> {
    let roots = polynomial.roots();
    assert_eq!(roots.rest, RemainingRoots::None);
    roots.rational.into_iter().flat_map(|(root, multiplicity)| vec![root; multiplicity]).collect()
}

#[test]
fn cube_of_the_notes() {
    let cube = Matrix::from_elements(|i, j| value(if i == j { "2/3*M*b^2" } else { "-M*b^2/4" }));
    let roots = cube.eigenvalues();
    assert_eq!(roots.rational, [(value("M*b^2/6"), 1), (value("11/12*M*b^2"), 2)]);
    assert_eq!(roots.rest, RemainingRoots::None);
    assert_eq!(cube.eigenvectors(&roots.rational[0].0), [Vector(["1", "1", "1"].map(value))]);
    let plane = cube.eigenvectors(&roots.rational[1].0);
    assert_eq!(plane, [Vector(["1", "-1", "0"].map(value)), Vector(["1", "1", "-2"].map(value))]);
    assert_eq!(cube.eigenvectors(&value("M*b^2")), []);
    let polynomial = cube.characteristic_polynomial().to_formula(&Formula::named("lambda"), &symbols());
    assert_eq!(polynomial.to_text(), "λ³ − 2 M b² λ² + 55/48 M² b⁴ λ − 121/864 M³ b⁶");
}

#[test]
fn roots_of_products() {
    let names = variables(["x", "y", "cos(alpha)"]);
    let mut random = Random(41);
    for k in 0..20 {
        let mut roots: Vec<RationalFunction> = (0..3)
            .map(|_| match k % 3 {
                0 => random.rational().into(),
                1 => random.polynomial(&names, 2).into(),
                _ => RationalFunction::new(&random.polynomial(&names, 2), &random.polynomial(&names, 1))
                    .unwrap(),
            })
            .collect();
        if k % 4 == 0 {
            roots[1] = roots[0].clone();
        }
        let found = rational_roots(&product(&roots));
        assert_eq!(found.len(), 3);
        assert_eq!(product(&found), product(&roots));
    }
}

#[test]
fn large_integers_are_found_exactly() {
    let roots = ["123456789012345678901234567890", "-987654321/1234567", "0"].map(value);
    let found = rational_roots(&product(&roots));
    assert_eq!(product(&found), product(&roots));
}

#[test]
fn pairs_with_square_roots() {
    let plane = matrix([["a", "b", "0"], ["b", "h", "0"], ["0", "0", "a + h"]]);
    let roots = plane.eigenvalues();
    assert_eq!(roots.rational, [(value("a + h"), 1)]);
    let RemainingRoots::Pair(pair) = roots.rest else { panic!("{:?}", roots.rest) };
    assert_eq!((&pair.center, &pair.deviation.outside), (&value("(a + h)/2"), &value("1/2")));
    assert_eq!(pair.deviation.inside, value("(a - h)^2 + 4*b^2"));
    // a ± c √d solve λ² − (a + h) λ + a h − b² = 0.
    let square = &pair.deviation.outside * &pair.deviation.outside * &pair.deviation.inside;
    assert_eq!(&pair.center * &pair.center - square, value("a*h - b^2"));

    // Squares leave the root, and roots of numbers belong to the field.
    let twice = |text: &str| value(text).square_root(&symbols());
    assert_eq!((twice("12*b^2*x").outside, twice("12*b^2*x").inside), (value("2*b"), value("3*x")));
    let golden = Univariate::new(["-b^2", "-b", "1"].map(value).to_vec());
    assert_eq!(rational_roots(&golden), ["(1 - sqrt(5))/2*b", "(1 + sqrt(5))/2*b"].map(value));
    let imaginary = Univariate::new(["b^2", "0", "1"].map(value).to_vec()).roots();
    assert!(matches!(imaginary.rest, RemainingRoots::Pair(pair) if pair.deviation.inside == value("-1")));
}

#[test]
fn cubics_without_rational_roots_are_refused() {
    for coefficients in [["-2", "0", "0", "1"], ["-b^3", "a*b^2", "0", "1"], ["1", "-3", "0", "1"]] {
        let cubic = Univariate::new(coefficients.map(value).to_vec());
        let roots = cubic.roots();
        assert_eq!(roots.rational, []);
        assert_eq!(roots.rest, RemainingRoots::NoClosedForm(cubic));
    }
}

#[test]
fn eigenvalues_with_angles() {
    // A diagonal tensor seen from turned axes, where only the diagonal element is free of sines.
    let rows = [["cos(alpha)", "-sin(alpha)", "0"], ["sin(alpha)", "cos(alpha)", "0"], ["0", "0", "1"]];
    let turn = matrix(rows);
    let diagonal = matrix([["I_1", "0", "0"], ["0", "I_2", "0"], ["0", "0", "I_3"]]);
    let turned = &turn * &diagonal * turn.transposed();
    let roots = turned.eigenvalues();
    assert_eq!(roots.rest, RemainingRoots::None);
    assert_eq!(roots.rational.len(), 3);
    for (value, _) in &roots.rational {
        let [vector] = &turned.eigenvectors(value)[..] else { panic!("one axis") };
        assert_eq!(turned.times_vector(vector), vector.scaled(value));
    }
    let shifted = matrix([["x", "sin(alpha)", "0"], ["sin(alpha)", "y", "0"], ["0", "0", "z"]]);
    assert_eq!(shifted.eigenvalues().rational, [(value("z"), 1)]);
}

#[test]
fn eigenvectors_are_orthogonal() {
    // Axes (1, 2, 2)/3, (2, 1, −2)/3, (2, −2, 1)/3.
    let axes = [["1/3", "2/3", "2/3"], ["2/3", "1/3", "-2/3"], ["2/3", "-2/3", "1/3"]];
    let turn = matrix(axes);
    for moments in [["I_1", "I_2", "I_3"], ["I_1", "I_2", "I_2"], ["M*a^2", "M*a^2", "M*a^2"]] {
        let [a, b, c] = moments;
        let diagonal = matrix([[a, "0", "0"], ["0", b, "0"], ["0", "0", c]]);
        let tensor = turn.transposed() * &diagonal * &turn;
        let roots = tensor.eigenvalues();
        let vectors: Vec<Vector> = roots
            .rational
            .iter()
            .flat_map(|(value, multiplicity)| {
                let vectors = tensor.eigenvectors(value);
                assert_eq!(vectors.len(), *multiplicity);
                assert!(vectors.iter().all(|v| tensor.times_vector(v) == v.scaled(value)));
                vectors
            })
            .collect();
        assert_eq!(vectors.len(), 3);
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            assert!(vectors[i].dot(&vectors[j]).is_zero());
        }
    }
}

#[test]
fn square_roots_need_positive_symbols() {
    let symbols = symbols();
    for (text, outside, inside) in [
        ("4*M^2*b^2", "2*M*b", "1"),
        ("x^2*b^3", "b", "x^2*b"),
        ("(m_1 + m_2)^2*g/b", "m_1 + m_2", "g/b"),
        ("(a - b)^2", "1", "(a - b)^2"),
        ("8/9*a", "2/3", "2*a"),
        ("g/(4*b^3)", "1/(2*b)", "g/b"),
        ("sqrt(3)*b^2", "b", "sqrt(3)"),
        ("0", "0", "1"),
    ] {
        let root = value(text).square_root(&symbols);
        assert_eq!((root.outside.clone(), root.inside.clone()), (value(outside), value(inside)), "{text}");
        assert_eq!(&root.outside * &root.outside * &root.inside, value(text), "{text}");
    }
    let root = value("(m_1 + m_2/2)/(m_1 + m_2/4)*g/b").square_root(&symbols);
    let at = |s| match symbols.name(s).as_str() {
        "m_1" => Some(1.2),
        "m_2" => Some(0.7),
        "g" => Some(9.81),
        "b" => Some(0.4),
        _ => None,
    };
    let expected = ((1.2f64 + 0.35) / (1.2 + 0.175) * 9.81 / 0.4).sqrt();
    assert!((root.evaluate(&at).unwrap() - expected).abs() < 1e-14);
    assert_eq!(value("-b").square_root(&symbols).evaluate(&at), None);
}
