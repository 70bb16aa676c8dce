//! Canonical forms: equal functions are equal values, and operations do as their definitions say.

use polhode_algebra::{Polynomial, Rational, RationalFunction, Variable, content_in, factors, gcd, lcm};

use crate::common::{Point, Random, symbols, value, variables};

#[test]
fn equal_functions_are_equal_values() {
    for (left, right) in [
        ("a - a", "0"),
        ("(a^2 - b^2)/(a - b)", "a + b"),
        ("(a^3 + b^3)/(a + b)", "a^2 - a*b + b^2"),
        ("1/(a*b) + 1/(a*h)", "(b + h)/(a*b*h)"),
        ("(2*a + 4*b)/(6*h)", "(a + 2*b)/(3*h)"),
        ("-a/(-b - h)", "a/(b + h)"),
        ("(x^2 - 2*x*y + y^2)/(y - x)", "y - x"),
        ("1/(1/a + 1/b)", "a*b/(a + b)"),
        ("(x^4 - y^4)/(x^2 + y^2)", "(x - y)*(x + y)"),
        ("sqrt(12)", "2*sqrt(3)"),
        ("sqrt(6)", "sqrt(2)*sqrt(3)"),
        ("sqrt(2/3)", "sqrt(6)/3"),
        ("1/sqrt(3)", "sqrt(3)/3"),
        ("1/(1 + sqrt(2))", "sqrt(2) - 1"),
        ("1/(sqrt(2) + sqrt(3))", "sqrt(3) - sqrt(2)"),
        ("a/(a - b*sqrt(5))", "(a^2 + a*b*sqrt(5))/(a^2 - 5*b^2)"),
        ("sin(alpha)^2 + cos(alpha)^2", "1"),
        ("(1 - cos(alpha))/sin(alpha)", "sin(alpha)/(1 + cos(alpha))"),
        ("1/(1 + sin(alpha)) + 1/(1 - sin(alpha))", "2/cos(alpha)^2"),
        ("cos(alpha)^4 - sin(alpha)^4", "cos(2*alpha)"),
    ] {
        assert_eq!(value(left), value(right), "{left}");
    }
    for (left, right) in
        [("a + b", "a - b"), ("sqrt(2)", "7/5"), ("sin(alpha)", "sin(theta)"), ("alpha", "sin(alpha)")]
    {
        assert_ne!(value(left), value(right), "{left}");
    }
}

/// Operations compared with those of numbers at random points.
#[test]
fn operations_agree_with_their_values() {
    let names = variables(["x", "y", "sin(alpha)", "cos(alpha)"]);
    let mut random = Random(21);
    let mut compared = 0;
    for seed in 0..30 {
        let (f, g) = (random.quotient(&names), random.quotient(&names));
        let point = Point::new(seed);
        let (Some(a), Some(b)) = (point.at(&f), point.at(&g)) else { continue };
        let check = |result: &RationalFunction, expected: Rational| {
            assert_eq!(point.at(result), Some(expected));
            assert_is_canonical(result);
        };
        check(&(&f + &g), &a + &b);
        check(&(&f - &g), &a - &b);
        check(&(&f * &g), &a * &b);
        if !b.is_zero() {
            check(&f.over(&g).unwrap(), a.over(&b).unwrap());
            check(&g.pow(-2).unwrap(), Rational::one().over(&b.pow(2)).unwrap());
        }
        check(&f.pow(3).unwrap(), a.pow(3));
        compared += 1;
    }
    assert!(compared > 25, "{compared}");
}

fn assert_is_canonical(function: &RationalFunction) {
    let (above, below) = (function.numerator(), function.denominator());
    assert_eq!(gcd(above, below), Polynomial::one());
    assert_eq!(*below, below.primitive());
    assert!(!below.variables().into_iter().any(Variable::is_algebraic));
    for variable in above.variables().into_iter().filter(|v| v.is_algebraic()) {
        assert!(above.degree_in(variable) <= 1);
    }
}

#[test]
fn different_ways_lead_to_one_form() {
    let names = variables(["x", "sqrt(2)", "sin(alpha)"]);
    let mut random = Random(22);
    for _ in 0..20 {
        let [f, g] = [0; 2].map(|_| random.quotient(&names[..2]));
        let h = RationalFunction::from(random.polynomial(&names, 3));
        assert_eq!((&f + &g) * &h, &f * &h + &g * &h);
        assert_eq!(&f + &g - &g, f);
        assert!((&f - &f).is_zero());
        if !g.is_zero() {
            assert_eq!((&f * &g).over(&g).unwrap(), f);
            assert_eq!(g.over(&g).unwrap(), RationalFunction::one());
        }
    }
}

#[test]
fn zero_has_no_reciprocal() {
    let zero = value("(a + b)^2 - a^2 - 2*a*b - b^2");
    assert!(zero.is_zero());
    assert_eq!(value("a").over(&zero), None);
    assert_eq!(zero.pow(-1), None);
    assert_eq!(zero.pow(0), Some(RationalFunction::one()));
    // The denominator is zero where α = θ.
    let pole = value("1/(sin(alpha)^2 - 1 + cos(theta)^2)");
    assert_eq!(pole.substituted(symbols().find("alpha").unwrap(), &value("theta")), None);
}

#[test]
fn gcds_of_products() {
    let names = variables(["x", "y", "z", "u"]);
    let mut random = Random(23);
    for _ in 0..60 {
        let [a, b, c] = [0; 3].map(|_| random.polynomial(&names, 4));
        let (f, g) = (&a * &c, &b * &c);
        let divisor = gcd(&f, &g);
        // The gcd divides both, contains c, and leaves coprime cofactors.
        let (p, q) = (f.over(&divisor).unwrap(), g.over(&divisor).unwrap());
        assert!(divisor.over(&c).is_some());
        assert_eq!(gcd(&p, &q), Polynomial::one());
        assert_eq!(divisor, divisor.primitive());
        let multiple = lcm(&f, &g);
        assert_eq!((&multiple * &divisor).primitive(), (&f * &g).primitive());
    }
}

#[test]
fn gcds_by_hand() {
    let of = |text: &str| value(text).numerator().clone();
    for (a, b, expected) in [
        ("0", "-2*x", "x"),
        ("0", "0", "0"),
        ("6", "4*x", "1"),
        ("x^2*y", "x*y^3*z", "x*y"),
        ("x^2 - y^2", "x^2 + 2*x*y + y^2", "x + y"),
        // Knuth, §4.6.1, example of algorithm E: coprime.
        ("x^8 + x^6 - 3*x^4 - 3*x^3 + 8*x^2 + 2*x - 5", "3*x^6 + 5*x^4 - 4*x^2 - 9*x + 21", "1"),
        ("(x*y + 1)*(x - z)", "(x*y + 1)*(y - z)", "x*y + 1"),
        ("(x + y + z)^3*(x - 1)", "(x + y + z)^2*(y - 1)", "x^2 + 2*x*y + y^2 + 2*x*z + 2*y*z + z^2"),
    ] {
        assert_eq!(gcd(&of(a), &of(b)), of(expected), "{a}, {b}");
        assert_eq!(gcd(&of(b), &of(a)), of(expected), "{b}, {a}");
    }
    let p = of("(x + 1)*(2*y + 4*z)*x");
    assert_eq!(content_in(&p, variables(["y"])[0]), of("x^2 + x"));
    assert_eq!(p.content(), "2".parse().unwrap());
}

#[test]
fn factors_multiply_to_the_polynomial() {
    let names = variables(["x", "y", "z"]);
    let mut random = Random(24);
    for _ in 0..40 {
        let [a, b, c] = [0; 3].map(|_| random.polynomial(&names, 3));
        let product = a.pow(3) * b.pow(2) * c;
        let all = factors(&product);
        let back =
            all.powers.iter().fold(Polynomial::from(all.coefficient.clone()), |p, (f, k)| p * f.pow(*k));
        assert_eq!(back, product);
        for (k, (f, _)) in all.powers.iter().enumerate() {
            assert_eq!(*f, f.primitive());
            // No factor is a square, and two have nothing in common.
            for variable in f.variables() {
                assert_eq!(gcd(f, &f.derivative(variable)).degree_in(variable), 0);
            }
            assert!(all.powers[k + 1..].iter().all(|(g, _)| gcd(f, g) == Polynomial::one()));
        }
    }
    let all = factors(value("-12*x^3*(x + y)^2*(z + 1)*(x + z)").numerator());
    assert_eq!(all.coefficient, "-12".parse().unwrap());
    assert_eq!(all.powers.iter().map(|(_, k)| *k).collect::<Vec<_>>(), [1, 3, 1, 2]);
}

#[test]
fn values_replace_variables() {
    let symbols = symbols();
    let [x, y] = ["x", "y"].map(|name| symbols.find(name).unwrap());
    let f = value("(x^2 + y)/(x - y)");
    assert_eq!(f.substituted(x, &value("y + 1/z")).unwrap(), value("((y + 1/z)^2 + y)*z"));
    assert_eq!(f.substituted(x, &value("y")), None);
    // Simultaneously, not one after the other.
    let swapped = f.replaced(&|v| match v {
        Variable::Symbol(s) if s == x => Some(y.into()),
        Variable::Symbol(s) if s == y => Some(x.into()),
        _ => None,
    });
    assert_eq!(swapped.unwrap(), value("(y^2 + x)/(y - x)"));
}

#[test]
fn doubles_of_functions() {
    let symbols = symbols();
    let alpha = symbols.find("alpha");
    let at = |s| (Some(s) == alpha).then_some(0.3);
    let f = value("sqrt(3)*sin(alpha)^2/(1 + alpha) - 2/7*cos(alpha)");
    let expected = 3f64.sqrt() * 0.3f64.sin().powi(2) / 1.3 - 2.0 / 7.0 * 0.3f64.cos();
    // Canonical form has 1 − cos² for sin², which costs a few units in the last place.
    assert!((f.evaluate(&at).unwrap() - expected).abs() < 4e-16);
    assert_eq!(f.evaluate(&|_| None), None);
    assert_eq!(value("1/(x - y)").evaluate(&|_| Some(2.0)), None);
    assert_eq!(
        value("M*b^2/6").evaluate(&|s| Some(if symbols.name(s) == "b" { 0.5 } else { 6.0 })),
        Some(0.25)
    );
}
