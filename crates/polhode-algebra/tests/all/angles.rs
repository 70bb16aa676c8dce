//! Sines and cosines.

use polhode_algebra::{Angle, Rational, RationalFunction};

use crate::common::{symbols, value};

#[test]
fn identities_are_decided() {
    for (left, right) in [
        ("sin(2*alpha)", "2*sin(alpha)*cos(alpha)"),
        ("cos(2*alpha)", "2*cos(alpha)^2 - 1"),
        ("sin(3*alpha)", "3*sin(alpha) - 4*sin(alpha)^3"),
        ("sin(alpha + theta)*sin(alpha - theta)", "sin(alpha)^2 - sin(theta)^2"),
        ("cos(alpha - theta)", "cos(theta - alpha)"),
        ("sin(-alpha)", "-sin(alpha)"),
        ("sin(alpha - alpha)", "0"),
        ("cos(5*alpha)", "16*cos(alpha)^5 - 20*cos(alpha)^3 + 5*cos(alpha)"),
        ("(sin(alpha)/cos(alpha))^2 + 1", "1/cos(alpha)^2"),
        ("sin(alpha)*sin(theta)", "(cos(alpha - theta) - cos(alpha + theta))/2"),
    ] {
        assert_eq!(value(left), value(right), "{left}");
    }
}

#[test]
fn sums_of_angles_agree_with_doubles() {
    let symbols = symbols();
    let angles = [("alpha", 0.7), ("theta", -1.9), ("phi", 2.4)];
    let at = |s| angles.iter().find(|(name, _)| symbols.find(name) == Some(s)).map(|&(_, value)| value);
    for text in ["alpha", "2*alpha - theta", "-7*phi + theta", "16*alpha", "alpha + theta + phi", "0"] {
        let angle = value(text);
        let double = angle.evaluate(&at).unwrap();
        let angle = Angle::new(&angle).unwrap();
        // Multiple-angle polynomials of degree 16 have coefficients up to 2^19.
        assert!((angle.sine().evaluate(&at).unwrap() - double.sin()).abs() < 1e-10, "{text}");
        assert!((angle.cosine().evaluate(&at).unwrap() - double.cos()).abs() < 1e-10, "{text}");
    }
    for text in [
        "alpha/2",
        "alpha^2",
        "alpha + 1",
        "17*alpha",
        "sin(alpha)",
        "1/alpha",
        "sqrt(2)*alpha",
        "alpha*theta",
    ] {
        assert_eq!(Angle::new(&value(text)), None, "{text}");
    }
}

#[test]
fn derivatives_are_limits_of_differences() {
    let symbols = symbols();
    let alpha = symbols.find("alpha").unwrap();
    for text in
        ["sin(alpha)", "alpha*cos(alpha)^3", "x/(2 + sin(alpha))", "sin(alpha)*cos(theta)/alpha", "x^2*y"]
    {
        let f = value(text);
        let at = |shift: f64| {
            f.evaluate(&|s| Some(if s == alpha { 0.8 + shift } else { 1.7 + symbols.name(s).len() as f64 }))
                .unwrap()
        };
        let exact = f
            .derivative(alpha)
            .evaluate(&|s| Some(if s == alpha { 0.8 } else { 1.7 + symbols.name(s).len() as f64 }));
        let h = 1e-3;
        let difference = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
        assert!((exact.unwrap() - difference).abs() < 1e-10, "{text}");
    }
}

#[test]
fn rules_of_differentiation() {
    let symbols = symbols();
    let [x, alpha] = ["x", "alpha"].map(|name| symbols.find(name).unwrap());
    let (f, g) = (value("x*sin(alpha)/(1 + x^2)"), value("(x - y)^2*cos(alpha)"));
    for s in [x, alpha] {
        assert_eq!((&f * &g).derivative(s), f.derivative(s) * &g + &f * g.derivative(s));
        let quotient = f.over(&g).unwrap().derivative(s);
        assert_eq!(quotient, (f.derivative(s) * &g - &f * g.derivative(s)).over(&(&g * &g)).unwrap());
    }
    assert_eq!(f.derivative(x).derivative(alpha), f.derivative(alpha).derivative(x));
    assert_eq!(value("sin(alpha)").derivative(x), RationalFunction::zero());
}

#[test]
fn angles_are_substituted_by_the_addition_theorems() {
    let symbols = symbols();
    let alpha = symbols.find("alpha").unwrap();
    let f = value("alpha*sin(alpha) + x");
    assert_eq!(
        f.substituted(alpha, &value("theta - 2*phi")).unwrap(),
        value("(theta - 2*phi)*sin(theta - 2*phi) + x")
    );
    assert_eq!(f.substituted(alpha, &value("0")).unwrap(), value("x"));
    assert_eq!(f.substituted(alpha, &value("theta/2")), None);
    assert_eq!(
        f.substituted(symbols.find("x").unwrap(), &value("theta/2")).unwrap(),
        value("alpha*sin(alpha) + theta/2")
    );
    let half = Rational::new(1, 2).unwrap();
    assert_eq!(value("x").scaled(&half), value("x/2"));
}
