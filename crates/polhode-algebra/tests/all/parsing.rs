//! Formulas as users write them.

use std::time::Instant;

use polhode_algebra::{Kind, ParseErrorKind, Rational, SymbolError, Symbols, parse};

use crate::common::{Random, symbols, value, variables};

#[test]
fn operators_bind_as_usual() {
    for (text, source) in [
        ("b/2", "1/2*b"),
        ("2*b", "2*b"),
        ("M*b^2", "M*b^2"),
        ("sqrt(3)/2*b", "1/2*sqrt(3)*b"),
        ("-a + 3/4*b", "-a + 3/4*b"),
        ("-b^2", "-b^2"),
        ("2^-1*b", "1/2*b"),
        ("a/b/h", "(a)/(b*h)"),
        ("a - b - h", "a - b - h"),
        ("a·b − -h", "a*b + h"),
        ("(a+b)^2", "a^2 + 2*a*b + b^2"),
        (" 1.5e2 * a ", "150*a"),
        ("0.1 + 0.2 - 0.3", "0"),
        ("2/3*M*b^2 - 5/12*M*b^2", "1/4*M*b^2"),
        ("theta_dot^2/2", "1/2*theta_dot^2"),
        ("sin(2*alpha)", "2*sin(alpha)*cos(alpha)"),
        ("a^0", "1"),
    ] {
        assert_eq!(value(text).to_source(&symbols()), source, "{text}");
    }
}

#[test]
fn sources_are_read_back() {
    let symbols = symbols();
    let names = variables(["x", "m_1", "sin(alpha)", "cos(alpha)", "sqrt(2)", "theta_dot", "theta"]);
    let mut random = Random(51);
    let mut read = 0;
    for _ in 0..60 {
        let f = random.quotient(&names);
        let source = f.to_source(&symbols);
        // A formula has at most 1000 characters.
        if source.len() <= 1000 {
            assert_eq!(parse(&source, &symbols), Ok(f), "{source}");
            read += 1;
        }
    }
    assert!(read > 30, "{read}");
}

#[test]
fn errors_state_place_rule_and_fix() {
    for (text, message, hint) in [
        ("", "column 1: expected a number, a symbol or (, found the end of the formula", None),
        ("b/", "column 3: expected a number, a symbol or (, found the end of the formula", None),
        (
            "2b",
            "column 2: expected an operator or the end of the formula, found `b`",
            Some("a product is written with *: …*b"),
        ),
        (
            "M b^2",
            "column 3: expected an operator or the end of the formula, found `b`",
            Some("a product is written with *: …*b"),
        ),
        ("b**2", "column 3: expected a number, a symbol or (, found `*`", Some("a power is written b^2")),
        (
            "0,5*b",
            "column 2: expected an operator or the end of the formula, found `,`",
            Some("the decimal sign is a point"),
        ),
        ("(a + b", "column 7: expected an operator or ), found the end of the formula", None),
        ("a + b)", "column 6: expected an operator or the end of the formula, found `)`", None),
        (
            "a^b",
            "column 3: the exponent `b` is not an integer from −12 to 12",
            Some("write a square root of a number as sqrt(3)"),
        ),
        (
            "a^0.5",
            "column 3: the exponent `0.5` is not an integer from −12 to 12",
            Some("write a square root of a number as sqrt(3)"),
        ),
        (
            "a^13",
            "column 3: the exponent `13` is not an integer from −12 to 12",
            Some("write a square root of a number as sqrt(3)"),
        ),
        (
            "a^",
            "column 3: the exponent `` is not an integer from −12 to 12",
            Some("write a square root of a number as sqrt(3)"),
        ),
        (
            "a^2^3",
            "column 4: expected an operator or the end of the formula, found `^`",
            Some("write parentheses around a power of a power: (b^2)^3"),
        ),
        ("a/(b - b)", "column 3: the divisor is zero", None),
        ("(b - b)^-1", "column 9: the divisor is zero", None),
        ("1/0", "column 3: the divisor is zero", None),
        ("m_3*b", "column 1: unknown symbol `m_3`", None),
        ("a + Theta", "column 5: unknown symbol `Theta`", Some("did you mean `theta`?")),
        ("omeg + 1", "column 1: unknown symbol `omeg`", Some("did you mean `omega`?")),
        ("b_dot", "column 1: unknown symbol `b_dot`", None),
        (
            "tan(alpha)",
            "column 1: unknown function `tan`",
            Some("the functions are sqrt, sin and cos; a product is written tan*(…)"),
        ),
        (
            "sqrt(b)",
            "column 5: sqrt takes a positive number without large prime factors",
            Some("use a symbol for the root, and its square where it is needed"),
        ),
        (
            "sqrt(-3)",
            "column 5: sqrt takes a positive number without large prime factors",
            Some("use a symbol for the root, and its square where it is needed"),
        ),
        (
            "cos(alpha/2)",
            "column 4: sin and cos take sums of symbols with integer factors up to 16",
            Some("declare the angle as a symbol: sin(alpha), cos(2*alpha - beta)"),
        ),
        ("1.2.3", "column 1: expected a decimal such as 0.25 or 1e-3, or a quotient such as 2/3", None),
        ("1e999*b", "column 1: a number has at most 400 digits and a power of ten within ±400", None),
        ("b = 2", "column 3: expected an operator or the end of the formula, found `=`", None),
        ("b[m]", "column 2: expected an operator or the end of the formula, found `[`", None),
    ] {
        let error = parse(text, &symbols()).unwrap_err();
        assert_eq!(error.to_string(), message, "{text}");
        // Symbols that are not similar to any are answered by the list.
        match hint {
            None if matches!(error.kind, ParseErrorKind::UnknownSymbol { .. }) => {
                assert!(error.hint().unwrap().starts_with("the symbols are M, m_1, m_2"), "{text}");
            }
            _ => assert_eq!(error.hint().as_deref(), hint, "{text}"),
        }
    }
    assert_eq!(parse("b", &Symbols::new()).unwrap_err().hint().unwrap(), "no symbols are declared");
}

#[test]
fn case_is_a_misspelling_and_ties_are_not_decided() {
    let mut symbols = Symbols::new();
    symbols.declare("M", Kind::Positive).unwrap();
    symbols.declare("width", Kind::Positive).unwrap();
    let hint = |text: &str| parse(text, &symbols).unwrap_err().hint().unwrap();
    assert_eq!(hint("m*2"), "did you mean `M`?");
    assert_eq!(hint("widht"), "did you mean `width`?");
    assert_eq!(hint("height"), "the symbols are M, width");
    let mut pair = Symbols::new();
    pair.declare("w_x", Kind::Constant).unwrap();
    pair.declare("w_y", Kind::Constant).unwrap();
    assert_eq!(parse("w_2", &pair).unwrap_err().hint().unwrap(), "the symbols are w_x, w_y");
}

#[test]
fn symbols_have_names_of_their_own() {
    let mut symbols = Symbols::new();
    assert!(symbols.declare("m1", Kind::Positive).is_ok());
    let error = |name: &str| symbols.clone().declare(name, Kind::Constant).unwrap_err();
    for name in ["", "1m", "m 1", "_m", "m-1", "m*"] {
        assert_eq!(error(name), SymbolError::Form { name: name.to_owned() });
    }
    assert_eq!(error("sin"), SymbolError::Reserved { name: "sin".to_owned() });
    assert_eq!(error("m1").to_string(), "symbol `m1` is declared twice");
    assert_eq!(error("m_1").to_string(), "symbols `m_1` and `m1` are printed in the same way; rename one");
    assert_eq!(symbols.find("m1_dot"), None);
}

#[test]
fn large_formulas_are_refused_quickly() {
    let start = Instant::now();
    let symbols = symbols();
    let nested = format!("{}b{}", "(".repeat(51), ")".repeat(51));
    for (text, limit) in [
        (format!("b{}", " + b".repeat(300)), "1000 characters"),
        (nested, "50 nested parentheses and signs"),
        ("(a + b + h + x + y)^8".to_owned(), "200 terms"),
        ("((a^12)^12)^12".to_owned(), "a degree of 40"),
        ("-".repeat(60) + "b", "50 nested parentheses and signs"),
    ] {
        let error = parse(&text, &symbols).unwrap_err();
        assert_eq!(error.kind, ParseErrorKind::TooLarge { limit }, "{text}");
    }
    // Nested quotients: the gcds of large polynomials.
    let quotient = "(a + b/(h + x))^4/((y + a/b)^3 - x) + 1/(x - y/(a + 1/(b - x)))^3";
    let result = parse(quotient, &symbols);
    assert!(result.is_ok() || matches!(result.unwrap_err().kind, ParseErrorKind::TooLarge { .. }));
    assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
}

#[test]
fn decimals_are_exact() {
    assert_eq!(
        value("0.3*b").evaluate_exactly(&|_| Some(Rational::new(1, 3).unwrap())),
        Rational::new(1, 10)
    );
}
