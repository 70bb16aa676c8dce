//! Printed text read back: random values are printed with factors outside, and are the same again.

use polhode_algebra::{RationalFunction, Variable, factors};

use crate::common::{Random, symbols, value, variables};

const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const SUBSCRIPTS: &str = "₀₁₂₃₄₅₆₇₈₉";

fn digit(c: char, digits: &str) -> Option<usize> {
    digits.chars().position(|d| d == c)
}

/// Returns printed text as a formula of the parser: `2*sin(theta)^2*m_1` for `2 sin² θ m₁`.
fn typed(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let (mut out, mut at) = (String::new(), 0);
    while at < letters.len() {
        let rest: String = letters[at..].iter().collect();
        let function = ["sin", "cos"].into_iter().find(|name| rest.starts_with(name));
        match letters[at] {
            _ if function.is_some() => {
                let mut power = String::new();
                at += 3;
                while let Some(exponent) = digit(letters[at], SUPERSCRIPTS) {
                    power.push_str(&exponent.to_string());
                    at += 1;
                }
                let angle = if letters[at + 1] == 'θ' { "theta" } else { "alpha" };
                let power = if power.is_empty() { "1" } else { &power };
                out.push_str(&format!("{}({angle})^{power}", function.unwrap()));
                at += 2;
                continue;
            }
            '√' => {
                let digits: String = letters[at + 1..].iter().take_while(|c| c.is_ascii_digit()).collect();
                out.push_str(&format!("sqrt({digits})"));
                at += digits.len();
            }
            ' ' => {
                let is_sign = |c: &char| matches!(c, '+' | '−' | '·');
                let is_near = is_sign(&letters[at - 1]) || is_sign(&letters[at + 1]);
                out.push(if is_near { ' ' } else { '*' });
            }
            '·' => out.push('*'),
            '−' => out.push('-'),
            'θ' => out.push_str("theta"),
            'α' => out.push_str("alpha"),
            '\u{307}' => out.push_str("_dot"),
            c => match (digit(c, SUPERSCRIPTS), digit(c, SUBSCRIPTS)) {
                (Some(exponent), _) => out.push_str(&format!("^{exponent}")),
                (_, Some(index)) => out.push_str(&format!("_{index}")),
                _ => out.push(c),
            },
        }
        at += 1;
    }
    out
}

#[test]
fn printed_values_are_read_back() {
    let symbols = symbols();
    let names = variables(["M", "m_1", "m_2", "b", "theta_dot", "sin(alpha)", "cos(alpha)", "sqrt(3)"]);
    let mut random = Random(61);
    let mut read = 0;
    for k in 0..120 {
        let above = random.polynomial(&names, 3);
        let common = random.polynomial(&names[..4], 1);
        let below = if k % 3 == 0 { random.polynomial(&names[1..5], 2) } else { above.pow(0) };
        let f = RationalFunction::new(&(above * &common), &(below * common.pow(k % 2))).unwrap();
        let all: Vec<Variable> = f.numerator().variables().into_iter().collect();
        let half = &all[..all.len() / 2];
        for formula in [f.to_formula(&symbols), f.collected(half, &symbols)] {
            let text = formula.to_text();
            if text.len() < 900 {
                assert_eq!(value(&typed(&text)), f, "{text}");
                read += 1;
            }
        }
    }
    assert!(read > 200, "{read}");
}

#[test]
fn printed_values_show_their_factors() {
    let symbols = symbols();
    let mut random = Random(62);
    for _ in 0..30 {
        let names = variables(["M", "a", "b", "h"]);
        let (p, q) = (random.polynomial(&names, 2), random.polynomial(&names, 2));
        let product = RationalFunction::from(&p * q.pow(2));
        let count = factors(product.numerator()).powers.len();
        let text = product.to_formula(&symbols).to_text();
        // A square of a sum is printed as a square.
        if q.term_count() > 1 && p.degree() > 0 && q.degree() > 0 {
            assert!(count > 1 && text.contains(")²"), "{text}");
        }
    }
}
