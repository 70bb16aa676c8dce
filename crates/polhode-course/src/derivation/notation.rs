//! Notation of the derivations: formulas on one line, which become trees.
//!
//! ```text
//! rows      = list { newline list }          a row that starts with = continues the row before
//! list      = relation { "," relation }
//! relation  = sum { sign sum }               = ≡ ≃ ≤
//! sum       = ["−"] operation { ("+" | "−") operation }
//! operation = product [ "×" product | "·" product { "·" product } ]
//! product   = factor { factor }
//! factor    = operand [ power ] { "/" operand [ power ] }
//! power     = "²" | "³" | … | "^" operand
//! ```
//!
//! An operand is a number, a symbol, `~r_α` (bold), `x̂_i` (a unit vector, bold), `sin θ`,
//! `Σ_ij a`, `∫_0^b a`, `d/dt a`, `∂a`, `dx`, `(a)`, `[a]`, or cells in brackets: `(a, b; c, d)`. `{I}` is the
//! matrix with the elements `I_ij`.

use polhode_algebra::{Accent, Fence, Formula, Large, Operator, Relation, Style};

const RELATIONS: [(char, Relation); 4] =
    [('=', Relation::Equal), ('≡', Relation::Defined), ('≃', Relation::Approximate), ('≤', Relation::AtMost)];
const FUNCTIONS: [&str; 4] = ["sin", "cos", "tan", "det"];
const EXPONENTS: [(char, i64); 4] = [('²', 2), ('³', 3), ('⁴', 4), ('⁵', 5)];
const ACCENTS: [(char, Accent); 3] =
    [('\u{302}', Accent::Hat), ('\u{307}', Accent::Dot), ('\u{308}', Accent::DoubleDot)];
/// Letters that Unicode also has with their accent as one character.
const COMPOSED: [(&str, &str); 3] = [("ŷ", "y\u{302}"), ("ẑ", "z\u{302}"), ("ê", "e\u{302}")];

/// Returns the tree of a formula; `None` if the text is not one.
pub fn read(text: &str) -> Option<Formula> {
    let text = COMPOSED.iter().fold(text.to_owned(), |text, (one, two)| text.replace(one, two));
    let mut rows = Vec::new();
    for row in text.split('\n') {
        let mut reader = Reader { rest: row.trim_start() };
        rows.push(reader.list()?);
        if !reader.rest.is_empty() {
            return None;
        }
    }
    if rows.len() == 1 { rows.pop() } else { Some(Formula::Rows(rows)) }
}

struct Reader<'a> {
    rest: &'a str,
}

impl Reader<'_> {
    fn list(&mut self) -> Option<Formula> {
        let mut parts = vec![self.relation()?];
        while self.takes(',') {
            parts.push(self.relation()?);
        }
        if parts.len() == 1 { parts.pop() } else { Some(Formula::List(parts)) }
    }

    fn relation(&mut self) -> Option<Formula> {
        let mut formula = if self.peek() == Some('=') { Formula::text("") } else { self.sum()? };
        while let Some((sign, relation)) = RELATIONS.into_iter().find(|(sign, _)| self.peek() == Some(*sign))
        {
            self.takes(sign);
            formula = formula.related(relation, self.sum()?);
        }
        Some(formula)
    }

    fn sum(&mut self) -> Option<Formula> {
        let mut terms = Vec::new();
        loop {
            let is_negative = self.takes('−');
            let term = self.operation()?;
            terms.push(if is_negative { Formula::Negative(Box::new(term)) } else { term });
            if !self.takes('+') && self.peek() != Some('−') {
                break;
            }
        }
        Some(if terms.len() == 1 { terms.swap_remove(0) } else { Formula::Sum(terms) })
    }

    fn operation(&mut self) -> Option<Formula> {
        let mut operands = vec![self.product()?];
        if self.takes('×') {
            operands.push(self.product()?);
            return Some(Formula::Operation(Operator::Cross, operands));
        }
        while self.takes('·') {
            operands.push(self.product()?);
        }
        if operands.len() == 1 { operands.pop() } else { Some(Formula::Operation(Operator::Dot, operands)) }
    }

    fn product(&mut self) -> Option<Formula> {
        let mut factors = vec![self.factor()?];
        while self.peek().is_some_and(|c| c.is_alphanumeric() || "~([{Σ∫∂".contains(c)) {
            factors.push(self.factor()?);
        }
        Some(Formula::product(factors))
    }

    fn factor(&mut self) -> Option<Formula> {
        let mut factor = self.powered()?;
        while self.takes('/') {
            factor = factor.over(self.powered()?);
        }
        Some(factor)
    }

    fn powered(&mut self) -> Option<Formula> {
        let base = self.operand()?;
        Some(match self.exponent()? {
            Some(exponent) => base.power(exponent),
            None => base,
        })
    }

    /// Reads an exponent, if there is one.
    fn exponent(&mut self) -> Option<Option<Formula>> {
        for (sign, value) in EXPONENTS {
            if self.takes(sign) {
                return Some(Some(Formula::integer(value)));
            }
        }
        if self.takes('^') { self.operand().map(Some) } else { Some(None) }
    }

    fn operand(&mut self) -> Option<Formula> {
        let c = self.peek()?;
        if let Some((_, rest)) = self.rest.split_once("d/dt ").filter(|(before, _)| before.is_empty()) {
            self.rest = rest;
            let of = self.factor()?;
            let is_symbol = matches!(of, Formula::Letter(..) | Formula::Subscript(..) | Formula::Accent(..));
            let time = Formula::named("t");
            return Some(if is_symbol { of.derivative(time, false) } else { of.time_derivative() });
        }
        if self.takes('~') {
            return Some(self.symbol()?.bold());
        }
        if self.takes('∂') {
            return Some(Formula::Differential { is_partial: true, of: Box::new(self.operand()?) });
        }
        for (operator, sign) in [(Large::Sum, 'Σ'), (Large::Integral, '∫')] {
            if self.takes(sign) {
                let below = if self.takes('_') { Some(Box::new(index(&self.word())?)) } else { None };
                let above = if self.takes('^') { Some(Box::new(self.operand()?)) } else { None };
                return Some(Formula::Limits { operator, below, above, body: Box::new(self.product()?) });
            }
        }
        for (open, close, fence) in [
            ('(', ')', Fence::Parentheses),
            ('[', ']', Fence::Brackets),
            ('{', '}', Fence::Braces),
            ('|', '|', Fence::Bars),
        ] {
            if self.takes(open) {
                return self.fenced(close, fence);
            }
        }
        let word: String = self.rest.chars().take_while(char::is_ascii_alphabetic).collect();
        match word.strip_prefix('d').filter(|variable| variable.len() == 1) {
            Some(variable) => {
                self.rest = self.rest[2..].trim_start();
                Some(Formula::Differential { is_partial: false, of: Box::new(Formula::named(variable)) })
            }
            None if FUNCTIONS.contains(&word.as_str()) => {
                self.rest = self.rest[3..].trim_start();
                let exponent = self.exponent()?;
                let function = self.operand()?.applied(&word);
                Some(match exponent {
                    Some(exponent) => function.power(exponent),
                    None => function,
                })
            }
            None if c.is_ascii_digit() => Some(Formula::Number(self.word())),
            None => self.symbol(),
        }
    }

    /// Reads the cells of brackets.
    fn fenced(&mut self, close: char, fence: Fence) -> Option<Formula> {
        let mut rows = vec![self.list()?];
        while self.takes(';') {
            rows.push(self.list()?);
        }
        let is_closed = self.takes(close);
        if rows.len() > 1 {
            let cells = |row| if let Formula::List(cells) = row { cells } else { vec![row] };
            return is_closed.then(|| Formula::Matrix(fence, rows.into_iter().map(cells).collect()));
        }
        let inside = rows.pop().filter(|_| is_closed)?;
        Some(match (fence, &inside) {
            (Fence::Parentheses, Formula::List(_)) => inside.grouped(fence),
            (Fence::Parentheses, _) => inside,
            (Fence::Braces, _) => inside.bold().grouped(fence),
            _ => inside.grouped(fence),
        })
    }

    /// Reads a letter with primes, accent and index.
    fn symbol(&mut self) -> Option<Formula> {
        let letter = self.rest.chars().next().filter(|c| c.is_alphabetic())?;
        let after = &self.rest[letter.len_utf8()..];
        let primes = after.len() - after.trim_start_matches('\'').len();
        let (name, mut rest) = self.rest.split_at(letter.len_utf8() + primes);
        let mut formula = Formula::Letter(name.to_owned(), Style::Italic);
        if let Some((mark, accent)) = ACCENTS.into_iter().find(|(mark, _)| rest.starts_with(*mark)) {
            rest = &rest[mark.len_utf8()..];
            formula = if accent == Accent::Hat { formula.bold() } else { formula }.accented(accent);
        }
        self.rest = rest;
        if self.rest.starts_with('_') {
            self.rest = &self.rest[1..];
            return Some(formula.index(index(&self.word())?));
        }
        self.rest = self.rest.trim_start();
        Some(formula)
    }

    /// Reads letters and digits.
    fn word(&mut self) -> String {
        let is_other = |c: char| !c.is_alphanumeric() || EXPONENTS.iter().any(|(sign, _)| *sign == c);
        let end = self.rest.find(is_other).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest.trim_start();
        word.to_owned()
    }

    fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    fn takes(&mut self, sign: char) -> bool {
        let rest = self.rest.strip_prefix(sign);
        self.rest = rest.map_or(self.rest, str::trim_start);
        rest.is_some()
    }
}

/// Returns the formula of an index: digits, up to two letters and digits that are an index each, or
/// a word.
fn index(text: &str) -> Option<Formula> {
    let style = if text.chars().count() < 3 { Style::Italic } else { Style::Upright };
    let is_number = text.bytes().all(|c| c.is_ascii_digit());
    match text {
        "" => None,
        _ if is_number => Some(Formula::Number(text.to_owned())),
        _ => Some(Formula::Letter(text.to_owned(), style)),
    }
}
