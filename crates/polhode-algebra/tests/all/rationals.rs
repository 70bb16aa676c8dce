//! Rational numbers: text, arithmetic and doubles.

use polhode_algebra::{Rational, RationalError};

use crate::common::Random;

fn rational(text: &str) -> Rational {
    text.parse().unwrap()
}

#[test]
fn decimals_and_quotients_are_read_exactly() {
    for (text, above, below) in [
        ("0.25", 1, 4),
        ("-0.125", -1, 8),
        ("1e-3", 1, 1000),
        ("2.5E+2", 250, 1),
        ("2/3", 2, 3),
        ("-1.5/6", -1, 4),
        ("3/-9", -1, 3),
        ("−7", -7, 1),
        ("+.5", 1, 2),
        ("6.", 6, 1),
        ("0/5", 0, 1),
    ] {
        assert_eq!(rational(text), Rational::new(above, below).unwrap(), "{text}");
    }
    assert_eq!(rational("0.1") + rational("0.2"), rational("0.3"));
    assert_eq!(rational("4/6").to_string(), "2/3");
    assert_eq!(rational("-8/2").to_string(), "-4");
}

#[test]
fn other_text_is_an_error() {
    for text in ["", ".", "-", "1e", "e3", "1/", "/2", "1/2/3", "0x10", "1,5", "1 2", "--1", "inf", "1e1.5"] {
        assert_eq!(text.parse::<Rational>(), Err(RationalError::Form), "{text}");
    }
    assert_eq!("1/0".parse::<Rational>(), Err(RationalError::ZeroDenominator));
    assert_eq!("1/0.000".parse::<Rational>(), Err(RationalError::ZeroDenominator));
    for text in ["1e401", "1e-999999999999", &"9".repeat(401)] {
        assert_eq!(text.parse::<Rational>(), Err(RationalError::TooLarge), "{text}");
    }
    assert_eq!(Rational::new(3, 0), None);
}

#[test]
fn arithmetic_keeps_the_field_axioms() {
    let mut random = Random(11);
    for _ in 0..200 {
        let [a, b, c] = [0; 3].map(|_| random.rational());
        assert_eq!((&a + &b) * &c, &a * &c + &b * &c);
        assert_eq!(&a - &b, -(&b - &a));
        assert_eq!(a.over(&b).unwrap() * &b, a);
        assert_eq!(a.pow(3), &a * &a * &a);
        assert_eq!((&a - &b).is_negative(), a < b);
        let unit = a.gcd(&b);
        assert!(a.over(&unit).unwrap().is_integer() && b.over(&unit).unwrap().is_integer());
    }
}

#[test]
fn no_number_is_too_large_for_arithmetic() {
    let large = rational("1e300").pow(5);
    assert_eq!(large.over(&rational("1e299").pow(5)).unwrap(), rational("1e5"));
    assert_eq!(large.to_f64(), f64::INFINITY);
    assert_eq!((-large).to_f64(), f64::NEG_INFINITY);
    assert_eq!(rational("1e-300").pow(5).to_f64(), 0.0);
}

#[test]
fn doubles_are_the_nearest_ones() {
    let mut random = Random(12);
    for _ in 0..2000 {
        let digits = random.next();
        let exponent = random.below(600) as i32 - 307;
        let text = format!("{}.{}e{exponent}", digits % 10, digits / 10);
        assert_eq!(rational(&text).to_f64(), text.parse::<f64>().unwrap(), "{text}");
    }
    for (text, double) in [("1/3", 1.0 / 3.0), ("-11/12", -11.0 / 12.0), ("0", 0.0), ("1e308", 1e308)] {
        assert_eq!(rational(text).to_f64(), double, "{text}");
    }
    // Midpoints between two doubles go to the even one; anything above goes up.
    let half = rational("9007199254740993");
    assert_eq!(half.to_f64(), 9_007_199_254_740_992.0);
    assert_eq!((half + rational("1e-40")).to_f64(), 9_007_199_254_740_994.0);
}
